"""The cache of compiled code: a damaged entry is rebuilt, a folder that cannot be written is no hindrance."""

from __future__ import annotations

import os
import resource
import sys
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from jounce.kernel import native
from jounce.kernel.cache import cache_folder
from jounce.kernel.native import compile_functions

X, U, P, M = (ca.SX.sym(name, 1) for name in "xupm")
ONE = np.ones(1)


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path / "cache"))
    return tmp_path / "cache"


def function(factor: float = 3.0) -> dict[str, ca.Function]:
    return {"f": ca.Function("f", [X, U, P, M], [factor * X + ca.tanh(U)])}


def value(compiled) -> float:
    return float(compiled.evaluate("f", (1,), 2 * ONE, 0 * ONE, ONE, ONE)[0])


@pytest.fixture
def emitted(monkeypatch):
    """Counts how often code is made."""
    calls = []
    make = native._emit
    monkeypatch.setattr(native, "_emit", lambda *arguments: calls.append(1) or make(*arguments))
    return calls


def entry(folder: Path) -> Path:
    (file,) = folder.iterdir()
    return file


def test_second_time_comes_from_the_cache(folder, emitted):
    assert value(compile_functions(function())) == 6.0
    assert value(compile_functions(function())) == 6.0
    assert len(emitted) == 1
    assert entry(folder).suffix == ".o"


def test_other_numbers_in_the_graph_are_another_entry(folder, emitted):
    assert value(compile_functions(function())) == 6.0
    assert value(compile_functions(function(4.0))) == 8.0
    assert len(emitted) == len(list(folder.iterdir())) == 2


DAMAGES = {
    "emptied": lambda _: b"",
    "cut in the checksum": lambda content: content[:20],
    "cut after the checksum": lambda content: content[:32],
    "cut in half": lambda content: content[: len(content) // 2],
    "last byte missing": lambda content: content[:-1],
    "byte flipped in the code": lambda content: (
        content[:200] + bytes([content[200] ^ 1]) + content[201:]
    ),
    "byte flipped in the checksum": lambda content: bytes([content[0] ^ 1]) + content[1:],
    "something appended": lambda content: content + b"\0",
    "text": lambda _: b"not an object file at all, but long enough to have a checksum and a rest",
}


@pytest.mark.parametrize("damage", DAMAGES)
def test_damaged_entry_is_rebuilt(folder, emitted, damage):
    compile_functions(function())
    sound = entry(folder).read_bytes()
    entry(folder).write_bytes(DAMAGES[damage](sound))
    assert value(compile_functions(function())) == 6.0
    assert len(emitted) == 2
    assert value(compile_functions(function())) == 6.0
    assert len(emitted) == 2, "the entry was repaired"


def test_entry_that_lacks_the_function_is_rebuilt(folder, emitted):
    compile_functions({"g": function()["f"]})
    stale = entry(folder).read_bytes()
    compile_functions(function())
    (other,) = (file for file in folder.iterdir() if file.read_bytes() != stale)
    other.write_bytes(stale)
    assert value(compile_functions(function())) == 6.0
    assert len(emitted) == 3


def test_entry_of_another_graph_is_rebuilt(folder):
    """Copied or renamed files: the code is sound and has the function, but computes something else."""
    compile_functions(function(4.0))
    stale = entry(folder).read_bytes()
    compile_functions(function(3.0))
    (other,) = (file for file in folder.iterdir() if file.read_bytes() != stale)
    other.write_bytes(stale)
    assert value(compile_functions(function(3.0))) == 6.0


def test_folder_that_is_a_file(tmp_path, monkeypatch, emitted):
    blocked = tmp_path / "cache"
    blocked.write_text("in the way")
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(blocked))
    assert value(compile_functions(function())) == 6.0
    assert value(compile_functions(function())) == 6.0
    assert len(emitted) == 2
    assert blocked.read_text() == "in the way"


@pytest.mark.skipif(os.geteuid() == 0, reason="nothing is forbidden to root")
def test_folder_without_permission(tmp_path, monkeypatch):
    blocked = tmp_path / "cache"
    blocked.mkdir(mode=0o500)
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(blocked))
    assert value(compile_functions(function())) == 6.0


def test_full_disk_leaves_no_rubbish(folder, emitted, monkeypatch):
    monkeypatch.setattr(
        sys, "dont_write_bytecode", True
    )  # of what is imported meanwhile: it would be cut at the limit
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, before[1]))  # less than any entry
    try:
        assert value(compile_functions(function())) == 6.0
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert list(folder.iterdir()) == []


def test_where_the_cache_lies(tmp_path, monkeypatch):
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path / "own"))
    assert cache_folder() == tmp_path / "own"
    monkeypatch.delenv("JOUNCE_CACHE_DIR")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "xdg"))
    assert cache_folder() == tmp_path / "xdg" / "jounce"
    monkeypatch.delenv("XDG_CACHE_HOME")
    assert cache_folder() == Path.home() / ".cache" / "jounce"
