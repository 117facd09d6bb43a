"""Machine code on disk: entries with a checksum, in a folder that belongs to the user.

An entry that is damaged or stale, or that others could have written, is rebuilt, never trusted.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import logging
import os
import sys
from functools import cache
from pathlib import Path
from typing import Any

from jounce.core.errors import OutputError
from jounce.core.ownership import ForeignError, own_folder, read_own
from jounce.core.sources import digest_of, edited_since
from jounce.kernel.machine import compiled_for

_CHECKSUM, _LENGTH = 32, 8
_LOG = logging.getLogger("jounce")


def key_here(identity: str) -> str:
    """Key of code for this processor, made by these versions of the kernel and the compiler."""
    return hashlib.sha256(f"{digest_of('kernel')} {compiled_for()} {identity}".encode()).hexdigest()


def joined(head: dict[str, Any], code: bytes) -> bytes:
    """Give code with what is to be known of it before."""
    text = json.dumps(head).encode()
    return len(text).to_bytes(_LENGTH, "little") + text + code


def parted(content: bytes) -> tuple[dict[str, Any], bytes]:
    """Give back what ``joined`` has put together."""
    start = _LENGTH + int.from_bytes(content[:_LENGTH], "little")
    return json.loads(content[_LENGTH:start]), content[start:]


def cache_folder() -> Path:
    """Folder of compiled models: ``$JOUNCE_CACHE_DIR``, else ``jounce`` where the system keeps what can be made again.

    That is ``$XDG_CACHE_HOME``, where it is set, or else ``~/.cache``, on macOS ``~/Library/Caches``, on Windows
    ``%LOCALAPPDATA%`` (``jounce/Cache`` there).

    Raises
    ------
    RuntimeError
        Where none can be named: no home folder, or a ``$JOUNCE_CACHE_DIR`` that is not absolute. What lies below the
        folder that one happens to stand in may be anybody's, an unpacked archive's for example.
    """
    own = os.environ.get("JOUNCE_CACHE_DIR")
    if own:
        if not Path(own).is_absolute():
            _tell_relative(own)
            raise RuntimeError("no absolute path")
        return Path(own)
    shared = os.environ.get("XDG_CACHE_HOME")  # the standard says: not absolute, not valid
    if shared and Path(shared).is_absolute():
        return Path(shared) / "jounce"
    if sys.platform == "win32":
        local = Path(os.environ.get("LOCALAPPDATA", ""))
        return (local if local.is_absolute() else Path.home() / "AppData" / "Local") / "jounce" / "Cache"
    return Path.home() / ("Library/Caches" if sys.platform == "darwin" else ".cache") / "jounce"


def why_not_kept() -> str:
    """Why native code cannot be kept in the cache folder, in words; empty where it can."""
    try:
        folder = cache_folder()
    except RuntimeError:
        return (
            "JOUNCE_CACHE_DIR is no absolute path" if os.environ.get("JOUNCE_CACHE_DIR") else "no home folder is known"
        )
    try:
        read_own(folder / "none")
    except ForeignError as error:
        return f"{error.filename} belongs to another user or can be written by others"
    except OSError:
        pass
    there = next(str(one) for one in (folder, *folder.parents) if os.path.lexists(one))
    return "" if Path(there).is_dir() and os.access(there, os.W_OK | os.X_OK) else f"{there} cannot be written"


@cache
def _tell_relative(given: str) -> None:
    _LOG.warning("JOUNCE_CACHE_DIR is not an absolute path: %s; no native code is kept", ascii(given))


def recall(key: str) -> bytes | None:
    """Give a cached entry whose checksum holds, else None."""
    with contextlib.suppress(RuntimeError):  # there is no home folder
        return read_sealed(cache_folder() / f"{key}.o", key)
    return None


def keep(key: str, content: bytes) -> None:
    """Store an entry; a folder that cannot be written means no cache."""
    with contextlib.suppress(RuntimeError):  # there is no home folder
        write_sealed(cache_folder() / f"{key}.o", key, content)


def read_sealed(file: Path, key: str) -> bytes | None:
    """Give what a file holds if it was written for this key, is whole, and nobody else could have put it there."""
    try:
        content = read_own(file)
    except ForeignError as error:
        _tell_foreign(file.parent, str(error.filename))
        return None
    except OSError:
        return None
    checksum, rest = content[:_CHECKSUM], content[_CHECKSUM:]
    return rest if rest and _checksum(key, rest) == checksum else None


def write_sealed(file: Path, key: str, content: bytes) -> bool:
    """Write a file whole or not at all; tell whether that was possible, where nobody else writes.

    Nothing is written where the kernel has been edited meanwhile: code of modules as they were would pass for new code.
    """
    from jounce.core.writing import replacing

    try:
        folder = own_folder(file.parent)
        if edited_since("kernel"):
            return False
        # Whatever the user's mask lets others write; a checksum tells what a power cut leaves of it.
        with replacing(folder / file.name, most=0o755, lasting=False) as temporary:
            temporary.write_bytes(_checksum(key, content) + content)
    except ForeignError as error:
        _tell_foreign(file.parent, str(error.filename))
        return False
    except (OSError, OutputError):
        return False
    return True


_TOLD: set[Path] = set()


def _tell_foreign(folder: Path, where: str) -> None:
    """Say once of a folder that it is not used, and why."""
    if folder not in _TOLD:
        _TOLD.add(folder)
        _LOG.warning(
            "%s belongs to another user or can be written by others: native code is neither read from there nor kept "
            "there (own it, and chmod go-w, or set JOUNCE_CACHE_DIR to a folder of your own)",
            ascii(where),
        )


def _checksum(key: str, content: bytes) -> bytes:
    """Checksum of an entry, with what it was made for."""
    return hashlib.sha256(key.encode() + content).digest()
