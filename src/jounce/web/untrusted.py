"""Reading of untrusted input: regular files of bounded size, and plain JSON."""

from __future__ import annotations

import math
import os
import stat
from pathlib import Path
from typing import Any

from pydantic_core import from_json

_DEEPEST = 64  # maximum nesting of lists and objects
_GREATEST = 1 << 63


def content(file: Path, most: int) -> bytes:
    """Return the content of a file.

    Raises
    ------
    OSError
        If it cannot be read, or is a link, a pipe, a device or a folder.
    ValueError
        If it contains more than ``most`` bytes.
    """
    # Opened before it is examined, so the examined file is the one read. A pipe must not block.
    flags = (
        os.O_RDONLY
        | getattr(os, "O_NONBLOCK", 0)
        | getattr(os, "O_BINARY", 0)
        | getattr(os, "O_NOFOLLOW", 0)
    )
    with os.fdopen(os.open(file, flags), "rb") as stream:
        status = os.fstat(stream.fileno())
        if not stat.S_ISREG(status.st_mode):
            raise FileNotFoundError(file)
        if status.st_size > most:
            raise ValueError(f"more than {most} bytes")
        return stream.read(most)


def is_regular(file: Path) -> bool:
    """Whether a path is a regular file, not a link to one."""
    try:
        return stat.S_ISREG(file.lstat().st_mode)
    except OSError:
        return False


def mark(file: Path) -> None:
    """Create an empty file unless the name exists, without following a link of that name."""
    if not os.path.lexists(file):
        os.close(os.open(file, os.O_CREAT | os.O_EXCL | os.O_WRONLY))


def plain_json(text: bytes | str) -> Any:
    """Parse JSON of limited depth with finite numbers and valid UTF-8 text; otherwise raise ValueError."""
    plain = from_json(text, allow_inf_nan=False)
    waiting = [(plain, 0)]
    while waiting:
        value, depth = waiting.pop()
        if (isinstance(value, float) and math.isinf(value)) or (
            isinstance(value, int) and abs(value) > _GREATEST
        ):
            raise ValueError("a number is too large")
        if isinstance(value, (dict, list)):
            if depth == _DEEPEST:
                raise ValueError(f"more than {_DEEPEST} lists and objects within each other")
            waiting += [
                (child, depth + 1)
                for child in (value.values() if isinstance(value, dict) else value)
            ]
    return plain
