"""Progress messages for slow work, such as compiling.

An interface that shows progress registers a listener (`heard_by`). Otherwise the logger ``jounce`` emits warnings,
which Python prints on stderr by default: ``logging.getLogger("jounce").setLevel("ERROR")`` silences it.
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

from jounce.core.phrases import Phrase


class Stage(Phrase):
    """The current work, and its completed fraction.

    The template is that of a `Phrase`; the text before its first colon is the phase, of which the fraction ``share``
    (0 to 1) is complete.

    Examples
    --------
    >>> progress = Stage("testing: {percent:.0f} %", share=0.3, percent=30.0)
    >>> print(progress, progress.share, progress.phase)
    testing: 30 % 0.3 testing
    """

    __slots__ = ("phase", "share")
    phase: str
    share: float

    def __new__(cls, template: str, /, *, share: float, **fields: Any) -> Stage:
        """Fill the template."""
        progress = super().__new__(cls, template, **fields)
        assert isinstance(progress, Stage)
        progress.phase, progress.share = template.partition(":")[0], min(1.0, share)
        return progress


def progress_through(template: str, which: int, count: int, /, **fields: Any) -> Stage:
    """Make a stage of work on several items: ``{which}`` of ``{count}``; the named item is not finished yet.

    >>> print(progress := progress_through("fitting {which} of {count}: {name}", 4, 10, name="a.csv"), progress.share)
    fitting 4 of 10: a.csv 0.3
    """
    return Stage(template, share=(which - 1) / max(1, count), which=which, count=count, **fields)


class Waiting(Phrase):
    """The current work, ``what``, and its duration so far."""

    __slots__ = ("what",)
    what: str

    def __new__(cls, what: str, seconds: float, /) -> Waiting:
        """Append the time to the text."""
        waiting = super().__new__(cls, "{what}, {seconds:.0f} s", what=what, seconds=seconds)
        assert isinstance(waiting, Waiting)
        waiting.what = what
        return waiting


LOGGED_EVERY, SHOWN_EVERY = 2.0, 0.5  # s: keeps a log short, and a display responsive
LOGGED_LATEST = 30.0
"""Longest interval (s) between log lines: it grows with the duration of the work."""
_LOOKS = 4  # checks of the reporting thread within the shorter interval
_LOG = logging.getLogger("jounce")
_listeners: list[Callable[[str | None], None]] = []


class _Here(threading.local):
    waits = False


_here = _Here()
"""Blocks of :func:`report_work` in this thread; nested ones are not reported separately."""


class _Wait(NamedTuple):
    what: str | Callable[[], str]
    started: float
    listener: Callable[[str | None], None] | None


class _Teller:
    """Thread that reports the most recent wait; it is reused for waits in close succession.

    Starting a thread for each wait would take longer than many of the waits.
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
                with contextlib.suppress(RuntimeError):  # no thread available: no report
                    self._thread.start()

    def end(self, wait: _Wait) -> None:
        """End a wait and its reports."""
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
                every = (
                    SHOWN_EVERY if wait.listener else min(max(LOGGED_EVERY, last), LOGGED_LATEST)
                )
                waited = time.monotonic() - wait.started
                if waited < last + every:
                    continue
                what = wait.what if isinstance(wait.what, str) else wait.what()
                last, text = waited, Waiting(what, waited)
                if wait.listener:
                    wait.listener(text)
                else:
                    _LOG.warning("%s", text)


_teller = _Teller()
if hasattr(os, "register_at_fork"):
    os.register_at_fork(
        after_in_child=_teller.forget
    )  # the thread is not in the child, and may hold the lock


@contextmanager
def report_work(what: str | Callable[[], str]) -> Iterator[None]:
    """Report the current work and its duration until the block ends.

    ``what`` may be a function that returns the text for each report, such as the progress; it is called from a
    different thread.

    >>> with report_work("compiling the model (once on this machine)"):
    ...     pass   # done at once: nothing is reported
    """
    if _here.waits:  # part of reported work
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
    """Call a function twice a second with the text of the current wait, and with None when the wait ends.

    It is called from a different thread.
    """
    _listeners.append(listener)
    try:
        yield
    finally:
        _listeners.remove(listener)


_watchers: list[Callable[[Mapping[str, Any]], None]] = []


def report_progress(numbers: Callable[[], Mapping[str, Any]]) -> None:
    """Report the progress of a search to a watcher; the numbers are computed only if there is one."""
    for watcher in _watchers:
        watcher(numbers())


@contextmanager
def watched_by(watcher: Callable[[Mapping[str, Any]], None]) -> Iterator[None]:
    """Call a function with the values of every step of a search in the block.

    >>> with watched_by(lambda numbers: print(numbers["objective"])):
    ...     report_progress(lambda: {"objective": 0.5})
    0.5
    """
    _watchers.append(watcher)
    try:
        yield
    finally:
        _watchers.remove(watcher)
