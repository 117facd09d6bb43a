"""Machine code on disk: entries with a checksum, in a folder that the user owns.

An entry that is damaged, stale or writable by others is not used but made again.
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


def join(head: dict[str, Any], code: bytes) -> bytes:
    """Return one entry: the head (as JSON, after its length) followed by the code."""
    text = json.dumps(head).encode()
    return len(text).to_bytes(_LENGTH, "little") + text + code


def split(content: bytes) -> tuple[dict[str, Any], bytes]:
    """Return the head and the code of an entry made by ``join``."""
    start = _LENGTH + int.from_bytes(content[:_LENGTH], "little")
    return json.loads(content[_LENGTH:start]), content[start:]


def cache_folder() -> Path:
    """Return the folder of compiled models: ``$JOUNCE_CACHE_DIR``, else ``jounce`` in the system's cache folder.

    The cache folder is ``$XDG_CACHE_HOME`` if set, else ``~/.cache``, on macOS ``~/Library/Caches``, on Windows
    ``%LOCALAPPDATA%`` (``jounce/Cache`` there).

    Raises
    ------
    RuntimeError
        If there is no home folder, or ``$JOUNCE_CACHE_DIR`` is not absolute: a folder relative to the working
        directory may hold files of others, of an unpacked archive for example.
    """
    own = os.environ.get("JOUNCE_CACHE_DIR")
    if own:
        if not Path(own).is_absolute():
            _tell_relative(own)
            raise RuntimeError("no absolute path")
        return Path(own)
    shared = os.environ.get("XDG_CACHE_HOME")  # a relative path is invalid by the XDG specification
    if shared and Path(shared).is_absolute():
        return Path(shared) / "jounce"
    if sys.platform == "win32":
        local = Path(os.environ.get("LOCALAPPDATA", ""))
        return (
            (local if local.is_absolute() else Path.home() / "AppData" / "Local")
            / "jounce"
            / "Cache"
        )
    return Path.home() / ("Library/Caches" if sys.platform == "darwin" else ".cache") / "jounce"


def why_not_kept() -> str:
    """Return why native code cannot be stored in the cache folder; empty if it can."""
    try:
        folder = cache_folder()
    except RuntimeError:
        return (
            "JOUNCE_CACHE_DIR is no absolute path"
            if os.environ.get("JOUNCE_CACHE_DIR")
            else "no home folder is known"
        )
    try:
        read_own(folder / "none")
    except ForeignError as error:
        return f"{error.filename} belongs to another user or can be written by others"
    except OSError:
        pass
    existing = next(str(parent) for parent in (folder, *folder.parents) if os.path.lexists(parent))
    return (
        ""
        if Path(existing).is_dir() and os.access(existing, os.W_OK | os.X_OK)
        else f"{existing} cannot be written"
    )


@cache
def _tell_relative(given: str) -> None:
    _LOG.warning(
        "JOUNCE_CACHE_DIR is not an absolute path: %s; no native code is kept", ascii(given)
    )


def recall(key: str) -> bytes | None:
    """Return a cached entry if its checksum is right, else None."""
    with contextlib.suppress(RuntimeError):  # there is no home folder
        return read_sealed(cache_folder() / f"{key}.o", key)
    return None


def keep(key: str, content: bytes) -> None:
    """Store an entry; does nothing if the folder cannot be written."""
    with contextlib.suppress(RuntimeError):  # there is no home folder
        write_sealed(cache_folder() / f"{key}.o", key, content)


def read_sealed(file: Path, key: str) -> bytes | None:
    """Return the content of a file if it was written for this key, is complete, and only the user could write it."""
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
    """Write a file completely or not at all; return whether it was written.

    Nothing is written if others can write the folder, or if the kernel's sources were edited since they were loaded.
    """
    from jounce.core.writing import replacing

    try:
        folder = own_folder(file.parent)
        if edited_since("kernel"):
            return False
        # The mode does not depend on the user's umask. No fsync: the checksum detects a file cut short by a power
        # failure.
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
    """Warn once for a folder that it is not used, and why."""
    if folder not in _TOLD:
        _TOLD.add(folder)
        _LOG.warning(
            "%s belongs to another user or can be written by others: native code is neither read from there nor kept "
            "there (own it, and chmod go-w, or set JOUNCE_CACHE_DIR to a folder of your own)",
            ascii(where),
        )


def _checksum(key: str, content: bytes) -> bytes:
    """Checksum over the key and the content of an entry."""
    return hashlib.sha256(key.encode() + content).digest()
