"""Locks on files and folders between processes; a lock is released when its process ends."""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from hashlib import sha256
from pathlib import Path

_BETWEEN_TRIALS = 0.02  # s between attempts: imperceptible to people, cheap for the system


def hold(place: Path, *, shared: bool = False) -> int | None:
    """Lock a file (created if missing) or a folder until ``os.close`` of the result; None if another process has it.

    A ``shared`` lock allows other shared locks, except on Windows. On a disk without locks, locking always succeeds.
    """
    folder = place.is_dir()
    if sys.platform == "win32":
        import msvcrt

        handle = os.open(_file_for(place) if folder else place, os.O_RDWR | os.O_CREAT)
        taken: type[OSError] = PermissionError
    else:
        import fcntl

        handle = os.open(place, os.O_RDONLY if folder else os.O_RDWR | os.O_CREAT, 0o666)
        taken = BlockingIOError
    try:
        if sys.platform == "win32":
            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        else:
            fcntl.flock(handle, (fcntl.LOCK_SH if shared else fcntl.LOCK_EX) | fcntl.LOCK_NB)
    except taken:
        os.close(handle)
        return None
    except OSError:
        pass
    return handle


def is_held(place: Path) -> bool:
    """Whether another process has locked a file or a folder."""
    held = hold(place, shared=True)  # concurrent tests do not block each other
    if held is not None:
        os.close(held)
    return held is None


def _file_for(folder: Path) -> Path:
    """File to lock instead of a folder, which Windows cannot lock; shared by the processes of one user."""
    name = os.path.normcase(folder.resolve())
    return (
        Path(tempfile.gettempdir())
        / f"jounce-{sha256(name.encode(errors='surrogatepass')).hexdigest()[:24]}.lock"
    )


@contextmanager
def holding(place: Path) -> Iterator[None]:
    """Lock a file or a folder within a block; wait for other processes to release it."""
    while (held := hold(place)) is None:
        time.sleep(_BETWEEN_TRIALS)
    try:
        yield
    finally:
        os.close(held)
