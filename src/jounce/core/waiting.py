"""Work that takes long once, such as compiling, is reported while it goes on: nobody should have to guess.

Whoever shows progress listens (`heard_by`); where nobody does, the logger ``jounce`` warns, which Python prints on
stderr unless it is reported otherwise: ``logging.getLogger("jounce").setLevel("ERROR")`` keeps it silent.
"""

from __future__ import annotations

import contextlib
import logging
import os
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any, NamedTuple

LOGGED_EVERY, SHOWN_EVERY = 2.0, 0.5  # s
LOGGED_LATEST = 30.0
"""How far apart (s) lines of a log may get: the longer it lasts, the fewer say so."""
_LOOKS = 4  # of the teller, in the shorter of the two
_LOG = logging.getLogger("jounce")
_listeners: list[Callable[[str | None], None]] = []


class _Here(threading.local):
    waits = False


_here = _Here()
"""Whether this thread is in a block of :func:`told`; parts of it are not reported apart."""


class _Wait(NamedTuple):
    what: str | Callable[[], str]
    started: float
    listener: Callable[[str | None], None] | None


class _Teller:
    """The thread that tells of the wait that began last; it lives on between waits that follow each other closely.

    A thread for each would take longer to start than many a thing that is waited for.
    """

    _lock: threading.RLock
    _waits: list[_Wait]
    _thread: threading.Thread | None

    def __init__(self) -> None:
        self.forget()

    def forget(self) -> None:
        self._lock, self._waits, self._thread = threading.RLock(), [], None

    def begin(self, wait: _Wait) -> None:
        with self._lock:
            self._waits.append(wait)
            if self._thread is None or not self._thread.is_alive():
                self._thread = threading.Thread(target=self._tell, name="jounce waits", daemon=True)
                with contextlib.suppress(RuntimeError):  # no thread is to be had: nothing is told
                    self._thread.start()

    def end(self, wait: _Wait) -> None:
        """End a wait: nothing is reported of it from here on."""
        with self._lock, contextlib.suppress(ValueError):  # begun before a fork
            self._waits.remove(wait)

    def _tell(self) -> None:
        wait, last = None, 0.0
        while True:
            time.sleep(min(LOGGED_EVERY, SHOWN_EVERY) / _LOOKS)
            with self._lock:
                if not self._waits:
                    self._thread = None
                    return
                if self._waits[-1] is not wait:
                    wait, last = self._waits[-1], 0.0
                every = SHOWN_EVERY if wait.listener else min(max(LOGGED_EVERY, last), LOGGED_LATEST)
                waited = time.monotonic() - wait.started
                if waited < last + every:
                    continue
                what = wait.what if isinstance(wait.what, str) else wait.what()
                last, text = waited, f"{what}, {waited:.0f} s"
                if wait.listener:
                    wait.listener(text)
                else:
                    _LOG.warning("%s", text)


_teller = _Teller()
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_teller.forget)  # the thread stayed behind, with the lock perhaps


@contextmanager
def told(what: str | Callable[[], str]) -> Iterator[None]:
    """Tell what is being waited for, and for how long already, until it is done.

    A function gives the words anew each time, such as how far the work has come; it is called from another thread.

    >>> with told("compiling the model (once on this machine)"):
    ...     pass   # ready at once: nothing was to be told
    """
    if _here.waits:  # a part of what is told already
        yield
        return
    listener = _listeners[-1] if _listeners else None
    wait = _Wait(what, time.monotonic(), listener)
    _here.waits = True
    _teller.begin(wait)
    try:
        yield
    finally:
        _here.waits = False
        _teller.end(wait)
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
