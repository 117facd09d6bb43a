"""Threads that share work: each item is taken once, errors are heard, and threads serve again."""

import math
import os
import sys
import threading
import time

import pytest

from jounce.variants import threads
from jounce.variants.threads import processors, share


@pytest.mark.parametrize("workers", [1, 2, 5])
def test_each_item_is_taken_once(workers):
    taken: list[int] = []
    share(range(500), taken.extend, workers)
    assert sorted(taken) == list(range(500))


def test_so_many_threads_work_at_once_and_serve_again(monkeypatch):
    while threads._free:  # those of other tests end
        time.sleep(0.01)
    monkeypatch.setattr(threads, "_WAITS", 600.0)
    seen = []
    for _ in range(2):
        all_there = threading.Barrier(3)

        def take(_, all_there=all_there) -> None:
            all_there.wait(60.0)  # passed only when three threads are here
            seen.append(threading.current_thread())

        share([], take, 3)
        while len(threads._free) < 2:  # both are about to put themselves back
            time.sleep(1e-3)
    assert len(set(seen)) == 3
    assert seen.count(threading.current_thread()) == 2
    monkeypatch.undo()
    all_there = threading.Barrier(3)
    share([], lambda _: all_there.wait(60.0), 3)  # which wait as long as ever from here on


@pytest.mark.parametrize("error", [ValueError, KeyboardInterrupt])
def test_who_fails_leaves_nothing_to_the_others_and_is_heard(error):
    both_there, failed = threading.Barrier(2), threading.Event()
    taken = []

    def take(some) -> None:
        both_there.wait(60.0)
        if threading.current_thread() is not threading.main_thread():
            next(some)
            failed.set()
            raise error("a helper")
        assert failed.wait(60.0)
        while some.__length_hint__():  # it is about to take all that is left
            time.sleep(1e-3)
        taken.extend(some)

    with pytest.raises(error, match="a helper"):
        share(range(100), take, 2)
    assert taken == []
    share(range(3), taken.extend, 2)  # and the next work is done
    assert sorted(taken) == [0, 1, 2]


def test_a_thread_that_waits_too_long_ends(monkeypatch):
    monkeypatch.setattr(threads, "_WAITS", 0.01)
    both_there, seen = threading.Barrier(2), []

    def take(_) -> None:
        both_there.wait(60.0)
        seen.append(threading.current_thread())

    share([], take, 2)
    (helper,) = set(seen) - {threading.current_thread()}
    helper.join(60.0)
    assert not helper.is_alive()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="processes cannot be split here")
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_a_child_has_threads_of_its_own():
    share([], lambda _: None, 2)
    child = os.fork()
    if child == 0:
        import signal

        signal.alarm(60)  # who waits for threads that stayed behind is ended
        taken: list[int] = []
        share(range(4), taken.extend, 2)
        os._exit(0 if sorted(taken) == [0, 1, 2, 3] else 1)
    assert os.waitpid(child, 0)[1] == 0


def test_who_is_interrupted_while_it_waits_leaves_nothing_to_the_others(monkeypatch):
    class Interrupted(threads.SimpleQueue):
        def get(self, *given, **named):
            if threading.current_thread() is threading.main_thread():
                raise KeyboardInterrupt
            return super().get(*given, **named)

    monkeypatch.setattr(threads, "SimpleQueue", Interrupted)
    heard, ended, taken = threading.Event(), threading.Event(), []

    def take(some) -> None:
        if threading.current_thread() is threading.main_thread():
            return
        heard.wait(60.0)
        taken.extend(some)
        ended.set()

    with pytest.raises(KeyboardInterrupt):
        share(range(100), take, 2)
    heard.set()
    assert ended.wait(60.0)
    assert taken == []


@pytest.mark.skipif(
    not hasattr(os, "sched_getaffinity"), reason="processes are bound to processors on Linux"
)
def test_a_process_that_is_bound_to_a_processor_uses_no_more(monkeypatch):
    before = os.sched_getaffinity(0)
    monkeypatch.setattr(threads, "time_share", lambda: math.inf)
    try:
        os.sched_setaffinity(0, {min(before)})
        assert processors() == 1
    finally:
        os.sched_setaffinity(0, before)
    assert processors() == len(before)


@pytest.mark.parametrize(
    ("above", "here", "found", "used"),
    [
        (None, None, math.inf, 8),
        ("max", "max", math.inf, 8),
        ("200000", "max", 2.0, 2),
        ("max", "50000", 0.5, 1),
    ],
)
def test_a_container_with_little_time_counts_as_few_processors(
    tmp_path, monkeypatch, above, here, found, used
):
    own = tmp_path / "own"
    own.write_text("1:cpu:/other\n0::/box/job\n")
    (tmp_path / "box" / "job").mkdir(parents=True)
    for folder, limit in (("box", above), ("box/job", here)):
        if limit is not None:
            (tmp_path / folder / "cpu.max").write_text(f"{limit} 100000\n")
    assert threads.time_share(tmp_path, own) == found
    monkeypatch.setattr(threads, "time_share", lambda: found)
    monkeypatch.setattr(os, "sched_getaffinity", lambda _: set(range(8)), raising=False)
    assert processors() == used


@pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="other systems have no control groups"
)
def test_a_control_group_may_have_any_name(tmp_path):
    own, group = tmp_path / "own", tmp_path / os.fsdecode(b"caf\xe9")
    own.write_bytes(b"0::/caf\xe9\n")
    group.mkdir()
    (group / "cpu.max").write_text("300000 100000\n")
    assert threads.time_share(tmp_path, own) == 3.0


@pytest.mark.parametrize("workers", [1, 3])
def test_what_is_to_be_done_meanwhile_is_done_once_before_this_thread_takes_items(workers):
    done = []
    share(
        range(9),
        lambda some: done.extend((threading.get_ident(), i) for i in some),
        workers,
        lambda: done.append("m"),
    )
    assert done.count("m") == 1
    assert sorted(i for _, i in (one for one in done if one != "m")) == list(range(9))
    own = [k for k, one in enumerate(done) if one != "m" and one[0] == threading.get_ident()]
    assert all(k > done.index("m") for k in own)


def test_an_error_meanwhile_leaves_nothing_to_the_others():
    with pytest.raises(ValueError, match="meanwhile"):
        share(range(100), lambda some: [time.sleep(0.001) for _ in some], 2, _fails)


def _fails():
    raise ValueError("meanwhile")
