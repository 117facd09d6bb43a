"""A Ctrl-C in the midst of what cannot take one comes after it; a second one comes at once."""

from __future__ import annotations

import signal
import threading

import pytest

from jounce.core.interrupts import interrupt, interrupt_after, signal_of, uncovering_interrupts
from jounce.core.remembered import Recent


@pytest.fixture(autouse=True)
def _as_in_a_terminal():
    """Who starts the tests in the background may have told them to ignore the signal."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def press():
    signal.raise_signal(signal.SIGINT)


def pressed_in_a_block(times, done):
    with interrupt_after():
        for _ in range(times):
            press()
        done.append(1)


def test_it_comes_when_the_block_is_over():
    done = []
    with pytest.raises(KeyboardInterrupt):
        pressed_in_a_block(1, done)
    assert done
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_a_second_one_comes_at_once():
    done = []
    with pytest.raises(KeyboardInterrupt):
        pressed_in_a_block(2, done)
    assert not done


def test_blocks_in_blocks_hold_it_back_to_the_outermost():
    done = []

    def nested():
        with interrupt_after():
            pressed_in_a_block(1, done)
            done.append(2)

    with pytest.raises(KeyboardInterrupt):
        nested()
    assert done == [1, 2]


def test_what_is_made_for_all_is_made_whole_or_not_at_all():
    recent = Recent()
    with pytest.raises(KeyboardInterrupt):
        recent.of("key", lambda: press() or "half")
    assert recent.of("key", lambda: "whole") == "whole"


def test_handlers_of_others_and_other_threads_stay_as_they_are():
    pressed = []
    before = signal.signal(signal.SIGINT, lambda *_: pressed.append(1))
    try:
        with interrupt_after():
            press()
            assert pressed
    finally:
        signal.signal(signal.SIGINT, before)
    thread = threading.Thread(target=lambda: interrupt_after().__enter__())
    thread.start()
    thread.join()
    assert signal.getsignal(signal.SIGINT) is before


def of_a_library():
    try:
        raise KeyboardInterrupt
    except KeyboardInterrupt:
        raise SystemError(
            "<built-in function cse> returned a result with an exception set"
        ) from None


def test_what_a_library_made_of_an_interrupt_is_one():
    with pytest.raises(KeyboardInterrupt), uncovering_interrupts():
        of_a_library()
    with pytest.raises(SystemError), uncovering_interrupts():
        raise SystemError


def test_a_request_to_end_is_held_back_and_keeps_its_number():
    done, before = [], signal.signal(signal.SIGTERM, interrupt)

    def asked_to_end():
        with interrupt_after():
            signal.raise_signal(signal.SIGTERM)
            done.append(1)

    try:
        with pytest.raises(KeyboardInterrupt) as caught:
            asked_to_end()
    finally:
        signal.signal(signal.SIGTERM, before)
    assert done
    assert signal_of(caught.value) == signal.SIGTERM
    assert signal_of(KeyboardInterrupt()) == signal.SIGINT
