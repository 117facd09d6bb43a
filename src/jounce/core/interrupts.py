"""Handle Ctrl-C and termination requests before a command runs and inside libraries that cannot handle them."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from threading import current_thread, main_thread
from types import FrameType
from typing import NoReturn

_SIGNALS = [
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name)
]
INTERRUPTED = "interrupted; no file is left half-written."


def interrupt(number: int, _: FrameType | None) -> None:
    """Interrupt the command, which then removes unfinished files and reports it."""
    raise KeyboardInterrupt(number)


def leave(number: int, _: FrameType | None) -> NoReturn:
    """End the process at once: nothing is being written while commands load, or after they have finished."""
    with suppress(OSError):
        os.write(2, f"jounce: {INTERRUPTED}\n".encode())
    os._exit(128 + number)


def signal_of(error: BaseException) -> int:
    """Return the number of the signal that caused an interrupt."""
    return next((number for number in error.args if number in _SIGNALS), signal.SIGINT)


def handle_interrupts(handler: Callable[[int, FrameType | None], None]) -> None:
    """Handle Ctrl-C, a closed terminal and termination requests, except signals this process was started to ignore."""
    for number in _SIGNALS:
        if signal.getsignal(number) in (
            signal.SIG_DFL,
            signal.default_int_handler,
            interrupt,
            leave,
        ):
            signal.signal(number, handler)


@contextmanager
def interrupt_after() -> Iterator[None]:
    """Delay an interrupt until the block ends; a second interrupt takes effect immediately.

    CasADi converts an interrupt to its own error, or loses it. Nothing changes if another handler is installed, or in
    threads other than the main thread, which never receive signals.
    """
    if current_thread() is not main_thread():
        yield
        return
    raising = (signal.default_int_handler, interrupt)
    before = {
        number: handler for number in _SIGNALS if (handler := signal.getsignal(number)) in raising
    }
    wanted: list[int] = []

    def note(number: int, frame: FrameType | None) -> None:
        wanted.append(number)
        if len(wanted) > 1:
            before[number](number, frame)

    for number in before:
        signal.signal(number, note)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        if wanted:
            raise KeyboardInterrupt(wanted[0])


@contextmanager
def uncovering_interrupts() -> Iterator[None]:
    """Raise the original interrupt if a library, or a cleanup, replaced it by a different error.

    >>> try:
    ...     with uncovering_interrupts():
    ...         raise SystemError from KeyboardInterrupt(2)
    ... except KeyboardInterrupt as error:
    ...     error
    KeyboardInterrupt(2)
    """
    try:
        yield
    except Exception as error:
        cause: BaseException | None = error
        while cause is not None and not isinstance(cause, KeyboardInterrupt):
            cause = cause.__cause__ or cause.__context__
        if cause is None:
            raise
        raise KeyboardInterrupt(*cause.args) from error
