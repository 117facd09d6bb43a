"""Compiling in a child: the same bytes, nothing left behind, and a child that fails is made up for."""

import os
import runpy
import signal
import socket
import sys
import threading

import casadi as ca
import numpy as np
import pytest

from jounce.kernel import apart, native
from jounce.kernel.apart import compile_in_child, compiling_apart
from jounce.kernel.machine import IN_LLVM

pytestmark = pytest.mark.skipif(not apart.SPLITS, reason="this system splits no process")


def test_only_where_it_is_wanted():
    assert compile_in_child(lambda: b"made") is None
    with compiling_apart():
        assert compile_in_child(lambda: b"made") == b"made"
        assert compile_in_child(lambda: bytes(5_000_000)) == bytes(
            5_000_000
        )  # more than a pipe holds
    assert compile_in_child(lambda: b"made") is None


def test_it_is_made_in_another_process_that_has_gone():
    with compiling_apart():
        child = int(compile_in_child(lambda: str(os.getpid()).encode()) or b"0")
    assert child not in (0, os.getpid())
    with pytest.raises(ProcessLookupError):
        os.kill(child, 0)


@pytest.mark.parametrize(
    ("system", "splits"), [("linux", True), ("darwin", False), ("win32", False)]
)
def test_no_process_splits_where_its_libraries_do_not_survive_it(monkeypatch, system, splits):
    monkeypatch.setattr(sys, "platform", system)
    assert runpy.run_path(apart.__file__)["SPLITS"] is splits
    if not splits:
        monkeypatch.setattr(apart, "SPLITS", splits)
        monkeypatch.setattr(os, "fork", lambda: pytest.fail("the process is split"))
        with compiling_apart():
            assert compile_in_child(lambda: b"made") is None


def test_errors_and_crashes_give_nothing(capfd):
    def crash() -> bytes:
        os.kill(os.getpid(), signal.SIGKILL)
        return b""

    with compiling_apart():
        assert compile_in_child(lambda: b"%d" % (1 // 0)) is None
        assert compile_in_child(crash) is None
    assert capfd.readouterr() == ("", "")


def test_a_child_that_hangs_is_ended(monkeypatch):
    monkeypatch.setattr(apart, "_LONGEST", 0.05)
    with compiling_apart():
        assert compile_in_child(lambda: signal.pause() or b"") is None


def test_the_child_holds_no_connection_of_the_server():
    ours, theirs = socket.socketpair()
    with ours, theirs, compiling_apart():
        given = compile_in_child(
            lambda: b"closed" if theirs.fileno() > 2 and not _is_open(theirs.fileno()) else b"open"
        )
    assert given == b"closed"


def test_a_process_is_not_split_while_another_thread_is_in_the_compiler():
    inside, let_go, made = threading.Event(), threading.Event(), []

    def compile_something() -> None:
        with IN_LLVM:
            inside.set()
            let_go.wait()

    def split() -> None:
        with compiling_apart():
            made.append(compile_in_child(lambda: b"made"))

    threads = [threading.Thread(target=compile_something), threading.Thread(target=split)]
    threads[0].start()
    inside.wait()
    threads[1].start()
    threads[1].join(0.2)
    assert not made
    let_go.set()
    for thread in threads:
        thread.join()
    assert made == [b"made"]


def _is_open(descriptor: int) -> bool:
    try:
        os.fstat(descriptor)
    except OSError:
        return False
    return True


def test_code_that_was_compiled_apart_computes_the_same(tmp_path, monkeypatch):
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path))
    made = []
    emit = native._emit
    monkeypatch.setattr(native, "_emit", lambda *given: made.append(1) or emit(*given))
    x = ca.SX.sym("x", 2)
    none = [ca.SX.sym(name, 0) for name in "upm"]
    with compiling_apart():
        code = native.compile_functions(
            {"f": ca.Function("f", [x, *none], [x[0] * ca.sin(x[1]) + 0.123456])}
        )
    assert not made  # here
    nothing = np.zeros(0)
    assert (
        code.evaluate("f", (1,), np.array([2.0, 0.5]), *[nothing] * 3)[0]
        == 2.0 * np.sin(0.5) + 0.123456
    )
