"""Work that takes long once, such as compiling, is told while it goes on: nobody should have to guess.

Whoever shows progress listens (`heard_by`); where nobody does, the logger ``jounce`` warns, which Python prints on
stderr unless it is told otherwise: ``logging.getLogger("jounce").setLevel("ERROR")`` keeps it silent.
"""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

LOGGED_EVERY, SHOWN_EVERY = 2.0, 0.5  # s
_LOG = logging.getLogger("jounce")
_listeners: list[Callable[[str | None], None]] = []
_told: list[str] = []  # what is being waited for, the outermost first


@contextmanager
def told(what: str) -> Iterator[None]:
    """Tell what is being waited for, and for how long already, until it is done.

    >>> with told("compiling the model (once on this machine)"):
    ...     pass   # ready at once: nothing was to be told
    """
    _told.append(what)
    if len(_told) > 1:  # a part of what is told already
        try:
            yield
        finally:
            _told.pop()
        return
    done, started = threading.Event(), time.monotonic()
    listener = _listeners[-1] if _listeners else None

    def tell() -> None:
        while not done.wait(SHOWN_EVERY if listener else LOGGED_EVERY):
            text = f"{what}, {time.monotonic() - started:.0f} s"
            if listener:
                listener(text)
            else:
                _LOG.warning("%s", text)

    teller = threading.Thread(target=tell, name="jounce waits", daemon=True)
    teller.start()
    try:
        yield
    finally:
        _told.pop()
        done.set()
        teller.join()
        if listener:
            listener(None)


@contextmanager
def heard_by(listener: Callable[[str | None], None]) -> Iterator[None]:
    """Have a function called with what is being waited for, twice a second, and with None when it is done.

    It is called from another thread.
    """
    _listeners.append(listener)
    try:
        yield
    finally:
        _listeners.remove(listener)


_watchers: list[Callable[[Mapping[str, Any]], None]] = []


def reached(numbers: Callable[[], Mapping[str, Any]]) -> None:
    """Tell how far a search has come, where somebody watches; only then its numbers are put together."""
    for watcher in _watchers:
        watcher(numbers())


@contextmanager
def watched_by(watcher: Callable[[Mapping[str, Any]], None]) -> Iterator[None]:
    """Have a function called with the numbers of every step of a search in the block.

    >>> with watched_by(lambda numbers: print(numbers["objective"])):
    ...     reached(lambda: {"objective": 0.5})
    0.5
    """
    _watchers.append(watcher)
    try:
        yield
    finally:
        _watchers.remove(watcher)
