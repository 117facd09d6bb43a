"""Compilation in a child process.

Compiling needs a hundred megabytes and more, which the operating system recovers when the child ends. A server that
compiles repeatedly therefore does not grow, and it stays responsive while a model is compiled.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from jounce.core.child_processes import bytes_from_fork
from jounce.kernel.machine import IN_LLVM

SPLITS = sys.platform.startswith("linux")
"""Whether a process can fork: macOS kills forked processes once its libraries are loaded, and Windows has no fork."""
_LONGEST = 300.0  # s: a child that takes longer hangs, and is given up
_wanted: list[bool] = []


@contextmanager
def compiling_apart() -> Iterator[None]:
    """Compile in children within the block, if the system can fork processes."""
    # Of forks beside threads. It is no danger here: none of them is in the compiler.
    warnings.filterwarnings(
        "ignore", category=DeprecationWarning, module=bytes_from_fork.__module__
    )
    _wanted.append(True)
    try:
        yield
    finally:
        _wanted.pop()


def compile_in_child(make: Callable[[], bytes]) -> bytes | None:
    """Return the result of ``make`` in a child; None if children are off or the child failed.

    Errors stay in the child: on None, the caller calls ``make`` itself and receives them.
    """
    return bytes_from_fork(make, IN_LLVM, _LONGEST) if _wanted and SPLITS else None
