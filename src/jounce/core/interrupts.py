"""Ctrl-C in the midst of a library that cannot take it."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from threading import current_thread, main_thread


@contextmanager
def interrupt_after() -> Iterator[None]:
    """Hold a Ctrl-C back until the block ends; a second one is let through.

    CasADi turns an interrupt into an error of its own, or loses it. Nothing changes where somebody else handles the
    signal, and in other threads, which never get it.
    """
    if current_thread() is not main_thread() or signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
        yield
        return
    is_wanted = False

    def note(*_: object) -> None:
        nonlocal is_wanted
        if is_wanted:
            raise KeyboardInterrupt
        is_wanted = True

    signal.signal(signal.SIGINT, note)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
        if is_wanted:
            raise KeyboardInterrupt


def is_interrupt(error: BaseException | None) -> bool:
    """Whether an error is an interrupt, or what a library made of one.

    >>> is_interrupt(KeyboardInterrupt()), is_interrupt(ValueError())
    (True, False)
    """
    while error is not None:
        if isinstance(error, KeyboardInterrupt):
            return True
        error = error.__cause__ or error.__context__
    return False
