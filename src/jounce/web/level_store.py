"""Records that were read, kept in the user's cache folder: a restarted server opens them without reading them again.

An entry belongs to one content of one file, read by one version of jounce. Entries that are damaged are deleted, and
those that were not used for a month, or the oldest if all of them are too large.
"""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import time
from hashlib import sha256
from pathlib import Path
from typing import Any

from jounce.core.errors import JounceError
from jounce.core.ownership import own_folder
from jounce.core.sources import digest_of
from jounce.core.writing import lasting_folder
from jounce.kernel.cache import cache_folder

_SEAL = "seal.json"
_MOST_BYTES, _SHARE_OF_FREE = 4_000_000_000, 0.1  # of all entries, and of the free disk space
_LONGEST = 30.0  # days without use
_DAY = 86400.0
_PIECES, _PIECE = 16, 1 << 12  # of each file, to detect damage without reading all of it


def store_folder() -> Path | None:
    """Return the folder of the entries; None if there is no cache folder that only this user can write."""
    with contextlib.suppress(RuntimeError, OSError):
        return own_folder(cache_folder() / "records")
    return None


def restore(key: str, folder: Path) -> bool:
    """Link the files of an entry into a new folder; whether there is an entry that is whole."""
    entry = _entry(key)
    if entry is None or not entry.is_dir():
        return False
    try:
        sealed = json.loads((entry / _SEAL).read_text(encoding="utf-8"))
        if sealed["key"] != entry.name:
            raise ValueError(sealed["key"])
        folder.mkdir(parents=True)
        for name, seal in sealed["files"].items():
            if Path(name).name != name:
                raise ValueError(name)
            os.link(entry / name, folder / name)
            if _seal_of(folder / name) != seal:
                raise ValueError(name)
        os.utime(entry)
    except (OSError, ValueError, TypeError, KeyError, AttributeError):
        for damaged in (folder, entry):
            shutil.rmtree(damaged, ignore_errors=True)
        return False
    return True


def keep(key: str, folder: Path) -> None:
    """Add the files of a folder as an entry, unless it is too large or the disk does not allow it."""
    entry = _entry(key)
    if entry is None:
        return
    with contextlib.suppress(OSError, JounceError):
        files = [file for file in folder.iterdir() if file.is_file()]
        size = sum(file.stat().st_size for file in files)
        free = shutil.disk_usage(entry.parent).free
        most = min(_MOST_BYTES, int(_SHARE_OF_FREE * free))
        if size > most or entry.exists():
            return
        _remove_old(entry.parent, most - size)
        made = lasting_folder(entry.parent)
        try:
            for file in files:
                os.link(file, made / file.name)
            seals = {file.name: _seal_of(file) for file in files}
            sealed = json.dumps({"key": entry.name, "files": seals})
            (made / _SEAL).write_text(sealed, encoding="utf-8")
            made.rename(entry)
        except OSError:
            shutil.rmtree(made, ignore_errors=True)
            raise


def _entry(key: str) -> Path | None:
    """Folder of an entry: another one for another version of what reads records."""
    folder = store_folder()
    version = digest_of("core", "recordings", "web/levels")
    return folder and folder / sha256(f"{key} {version}".encode()).hexdigest()[:32]


def _remove_old(folder: Path, most: int) -> None:
    """Remove entries that were not used for long, and the oldest until the others have ``most`` bytes."""
    entries = sorted(
        ((entry.stat().st_mtime, entry) for entry in folder.iterdir() if entry.name[0] != "."),
        reverse=True,
    )
    size, oldest = 0, time.time() - _LONGEST * _DAY
    for used, entry in entries:
        size += sum(file.stat().st_size for file in entry.iterdir())
        if size > most or used < oldest:
            shutil.rmtree(entry, ignore_errors=True)


def _seal_of(file: Path) -> list[Any]:
    """Size of a file, and a digest of pieces from its first byte to its last."""
    return [file.stat().st_size, digest_of_pieces(file, _PIECES, _PIECE).hexdigest()]


def digest_of_pieces(file: Path, count: int, size: int) -> Any:
    """Return the SHA-256 of evenly spaced pieces of a file; of all of it if they cover it."""
    digest = sha256()
    with file.open("rb") as stream:
        last = max(0, os.fstat(stream.fileno()).st_size - size)
        for place in dict.fromkeys(last * k // (count - 1) for k in range(count)):
            stream.seek(place)
            digest.update(stream.read(size))
    return digest
