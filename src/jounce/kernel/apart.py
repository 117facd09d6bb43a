"""Compiling in a child process: what it takes of memory, a hundred megabytes and more, goes with the child.

A process that lives long and compiles again and again (a server) keeps its size, and answers meanwhile.
"""

from __future__ import annotations

import os
import select
import signal
import sys
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from jounce.kernel.machine import IN_LLVM

SPLITS = sys.platform.startswith("linux")
"""Whether a process can split: macOS ends those that do once its libraries are loaded, and Windows cannot."""
_LONGEST = 300.0  # s: a child that takes longer hangs, and is given up
_PIECE = 1 << 20
_wanted: list[bool] = []


@contextmanager
def compiling_apart() -> Iterator[None]:
    """Have what is compiled in the block compiled by children, where the system can split a process."""
    # Of forks beside threads. It is no danger here: none of them is in the compiler.
    warnings.filterwarnings("ignore", category=DeprecationWarning, module=__name__)
    _wanted.append(True)
    try:
        yield
    finally:
        _wanted.pop()


def made_apart(make: Callable[[], bytes]) -> bytes | None:
    """Give what ``make`` makes in a child; None where that is not wanted, or the child came to no end.

    Errors stay in the child: whoever gets None calls ``make`` and sees them.
    """
    if not (_wanted and SPLITS):
        return None
    reading, writing = os.pipe()
    with IN_LLVM:
        child = os.fork()
    if child == 0:
        _do(make, writing)
    os.close(writing)
    content = None
    try:
        content = _all_of(reading)
    finally:
        os.close(reading)
        if content is None:
            os.kill(child, signal.SIGKILL)  # not waited for yet: it is still this one
        status = os.waitpid(child, 0)[1]
    return None if status else content


def _do(make: Callable[[], bytes], writing: int) -> None:
    """In the child: make it, hand it over, end without what a process does at its end."""
    code = 1
    try:
        os.closerange(3, writing)  # connections of the server, which must not live on with this child
        os.closerange(writing + 1, os.sysconf("SC_OPEN_MAX"))
        content = make()
        with os.fdopen(writing, "wb") as stream:
            stream.write(content)
        code = 0
    finally:
        os._exit(code)


def _all_of(reading: int) -> bytes | None:
    """All bytes of a pipe until its other end closes; None where that takes too long."""
    pieces: list[bytes] = []
    end = time.monotonic() + _LONGEST
    while select.select([reading], [], [], max(0.0, end - time.monotonic()))[0]:
        piece = os.read(reading, _PIECE)
        if not piece:
            return b"".join(pieces)
        pieces.append(piece)
    return None
