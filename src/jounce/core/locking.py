"""One process at a time: locks on files and folders that go with the process that holds them, however it ends."""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from hashlib import sha256
from pathlib import Path

_BETWEEN_TRIALS = 0.02  # s


def hold(place: Path, *, shared: bool = False) -> int | None:
    """Hold a file, which is made, or a folder until ``os.close`` of what is given; None where another process holds it.

    Where it is ``shared``, others may do so, too, but on Windows. On a disk without locks everybody holds everything.
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
    """Whether another process holds a file or a folder."""
    held = hold(place, shared=True)  # two who ask at once do not take each other for one who holds it
    if held is not None:
        os.close(held)
    return held is None


def _file_for(folder: Path) -> Path:
    """A file to lock in place of a folder, which Windows does not lock: it serves the processes of one user."""
    name = os.path.normcase(folder.resolve())
    return Path(tempfile.gettempdir()) / f"jounce-{sha256(name.encode(errors='surrogatepass')).hexdigest()[:24]}.lock"


@contextmanager
def holding(place: Path) -> Iterator[None]:
    """Hold a file or a folder for a block, once no other process does."""
    while (held := hold(place)) is None:
        time.sleep(_BETWEEN_TRIALS)
    try:
        yield
    finally:
        os.close(held)
