"""Threads that want the same thing get it from the first one that makes it."""

from __future__ import annotations

import os
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import pytest

from jounce.core.remembered import Recent, once_per_object
from jounce.core.turns import once, turn

THREADS = 8


def ask_at_once(ask):
    """Give what all threads got, which began together."""
    begin = threading.Barrier(THREADS)

    def work(_):
        begin.wait()
        return ask()

    with ThreadPoolExecutor(THREADS) as threads:
        return list(threads.map(work, range(THREADS)))


class Thing:
    def __init__(self):
        self.made = []

    def slowly(self):
        self.made.append(threading.get_ident())
        time.sleep(0.02)
        return object()

    @once
    def part(self):
        return self.slowly()


def ways():
    by_property, by_key, beside = Thing(), Thing(), Thing()
    recent, ask = Recent(), once_per_object(lambda thing: thing.slowly())
    return {
        "once": (by_property, lambda: by_property.part),
        "Recent": (by_key, lambda: recent.of("key", by_key.slowly)),
        "remembered": (beside, lambda: ask(beside)),
    }


@pytest.mark.parametrize("way", ways())
def test_one_thread_makes_it_and_all_share_it(way):
    thing, ask = ways()[way]
    values = ask_at_once(ask)
    assert len(thing.made) == 1
    assert all(value is values[0] for value in values)


def test_other_things_are_made_meanwhile():
    recent, both = Recent(), threading.Barrier(2)
    with ThreadPoolExecutor(2) as threads:  # each waits for the other inside of what it makes
        assert list(threads.map(lambda key: recent.of(key, lambda: both.wait(5.0) >= 0), "ab")) == [
            True,
            True,
        ]


def test_what_one_thread_fails_to_make_the_next_one_tries():
    recent, tries = Recent(), []

    def make():
        tries.append(1)
        if len(tries) < 3:
            raise ZeroDivisionError
        return "made"

    def ask():
        try:
            return recent.of("key", make)
        except ZeroDivisionError:
            return "failed"

    assert sorted(ask_at_once(ask)) == ["failed"] * 2 + ["made"] * (THREADS - 2)


def test_a_store_that_is_too_small_still_gives_each_key_its_own(monkeypatch):
    monkeypatch.setattr(Recent, "most", 1)
    recent = Recent()
    values = ask_at_once(
        lambda: [recent.of(key, lambda key=key: key.upper()) for key in "abcabcabc" * 50]
    )
    assert values == [list("ABCABCABC" * 50)] * THREADS


def test_a_thread_that_has_a_turn_may_take_it_again():
    with turn("key"), turn("key"):
        pass
    recent = Recent()
    assert recent.of("outer", lambda: recent.of("inner", lambda: 1) + 1) == 2


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system does not split processes")
@pytest.mark.filterwarnings(
    "ignore:This process:DeprecationWarning"
)  # of forks beside threads: they are the subject
def test_a_child_does_not_wait_for_threads_that_stayed_behind():
    recent, inside, done = Recent(), threading.Event(), threading.Event()

    def slow():
        inside.set()
        done.wait(30.0)
        return "parent"

    other = threading.Thread(target=recent.of, args=("key", slow))
    other.start()
    inside.wait(30.0)
    child = os.fork()
    if child == 0:
        os._exit(0 if recent.of("key", lambda: "child") == "child" else 1)
    try:
        for _ in range(1000):
            ended, status = os.waitpid(child, os.WNOHANG)
            if ended:
                break
            time.sleep(0.01)
        else:
            os.kill(child, 9)
            os.waitpid(child, 0)
            pytest.fail("the child waits for a thread that it does not have")
        assert status == 0
    finally:
        done.set()
        other.join()
