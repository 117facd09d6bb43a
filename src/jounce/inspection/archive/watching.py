"""Watching of a lane's folder: every new record is stored; the files remain in place."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from jounce.core.errors import (
    JounceError,
    OutputError,
    RecordingError,
    ResourceError,
    is_of_system,
    resource_error,
    unforeseen,
)
from jounce.core.files import existing_file, state_of
from jounce.core.phrases import Phrase
from jounce.inspection.archive.database import DamagedStoreError
from jounce.inspection.archive.entries import storable
from jounce.inspection.archive.lane import ImportedRecord, import_record

if TYPE_CHECKING:
    from jounce.inspection.archive.store import Store
    from jounce.inspection.limits import Limits
    from jounce.parts.testers import Tester

_Stamp = tuple[int, int]
_END = 1 << 15  # bytes at each end in which a format is recognisable
_OWN = (b'"jounce.protocol/', b"axle_verdict")
"""Markers of report values and exported tables, near their beginning or end."""


def record_suffixes() -> tuple[str, ...]:
    """Return the suffixes of files that may be records."""
    from jounce.recordings.readers import READERS

    return tuple(suffix for reader in READERS for suffix in reader.suffixes)


@dataclass(frozen=True)
class Seen:
    """Outcome of one file in the folder."""

    file: Path  # location of the file, which is not moved
    imported: ImportedRecord | None  # the stored record; None if the file could not be read
    problem: str = ""  # why the record could not be read or graded; empty if it was graded


def check_folder(folder: Path) -> None:
    """Raise an error unless the path is a folder, before a store is created."""
    if not folder.is_dir():
        what = "a file, not a folder" if folder.exists() else "no such folder"
        raise JounceError(what, where=str(folder), hint="Check the path and the name.")


class FolderWatch:
    """Repeated scan of a folder that stores finished records.

    A file is finished when its size and time, and those of an accompanying TOML file, are unchanged for ``settle``
    seconds. Examined files are recorded in the store: an unreadable file is reported once, and again only after it has
    changed. Names that begin with a dot or a tilde, and subfolders, are skipped. By default a record's tester is the
    shipped one named in its header. ``clock`` returns the time in s.

    Examples
    --------
    >>> import tempfile
    >>> from jounce.inspection.archive.store import Store
    >>> folder = Path(tempfile.mkdtemp())
    >>> _ = (folder / "torn.csv").write_text("time [s], left.pl")
    >>> watch = FolderWatch(folder, Store(folder / "lane.sqlite"), settle=0.0)
    >>> [seen.imported.verdict for seen in watch.look()], watch.look()
    (['not graded'], [])
    """

    def __init__(
        self,
        folder: Path | str,
        store: Store,
        tester: Tester | None = None,
        limits: Limits | None = None,
        *,
        settle: float = 2.0,
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self.folder, self.store, self.tester, self.limits = Path(folder), store, tester, limits
        check_folder(self.folder)
        self._settle, self._clock = settle, clock
        self._suffixes = record_suffixes()
        self._done: dict[str, _Stamp] = store.watched_files()
        self._waiting: dict[str, tuple[_Stamp, float, Path]] = {}
        self._reported = self._busy = ""

    @property
    def waiting(self) -> list[Path]:
        """Return files that may still be growing, or could not yet be read or stored."""
        return [file for _, _, file in self._waiting.values()]

    def look(self) -> list[Seen]:
        """Scan once; return the outcomes of newly finished files."""
        return list(self.each())

    def each(self) -> Iterator[Seen]:
        """Scan once; yield each file as soon as it is stored or rejected."""
        now = self._clock()
        try:
            files = sorted(file for file in self.folder.iterdir() if self._may_be_record(file))
            self._reported = ""
        except OSError as error:  # a disconnected share may become available again
            if not self._reported:
                self._reported = f"the folder cannot be read: {error.strerror}"
                yield Seen(self.folder, None, self._reported)
            return
        there = {_path_of(file) for file in files}
        self._waiting = {path: waiting for path, waiting in self._waiting.items() if path in there}
        for file in files:
            stamp = _stamp_of(file)
            path = _path_of(file)
            if stamp is None or self._done.get(path) == stamp:
                self._waiting.pop(path, None)
                continue
            before, since, _ = self._waiting.get(path, (None, now, file))
            if before != stamp:
                since = now
                self._waiting[path] = (stamp, now, file)
            if now - since >= self._settle:
                seen = self._take(file, path, stamp)
                if seen is not None:
                    yield seen

    def _may_be_record(self, file: Path) -> bool:
        return (
            file.suffix.lower() in self._suffixes and file.name[0] not in ".~" and not file.is_dir()
        )

    def _take(self, file: Path, path: str, stamp: _Stamp) -> Seen | None:
        """Import a file and record it in the store; it is retried if the store or a disk is not writable."""
        try:
            seen = self._import(file)
            if _stamp_of(file) == stamp:  # otherwise it is still growing and is examined again
                if seen is not None:
                    self.store.note_watched(path, *stamp, seen.problem)
                self._done[path] = stamp
        except (OutputError, ResourceError) as error:
            reason = f"{error.what} {error.found}"
            if self._busy == reason:
                return None
            self._busy = reason
            return Seen(file, None, Phrase("{error} jounce tries again.", error=error.message()))
        self._busy = ""
        self._waiting.pop(path, None)
        return seen

    def _import(self, file: Path) -> Seen | None:
        """Import a file; None for jounce's own output."""
        try:
            existing_file(file, RecordingError)  # a pipe would block
            if _is_own_output(file):
                return None
            imported = import_record(file, self.store, self.tester, limits=self.limits)
            return Seen(file, imported, imported.problem)
        except (DamagedStoreError, OutputError):
            raise
        except Exception as error:  # noqa: BLE001 - one record never stops the watch
            if is_of_system(error):
                raise resource_error(error, str(file)) from None
            if isinstance(error, OSError):
                return Seen(file, None, f"cannot be read: {error.strerror or error}")
            return Seen(file, None, str(unforeseen(error, str(file))))


def _is_own_output(file: Path) -> bool:
    """Whether a file is a report or an exported table, which look like records but were written by jounce."""
    with file.open("rb") as content:
        ends = content.read(_END)
        content.seek(max(0, file.stat().st_size - _END))
        ends += content.read(_END)
    return any(mark in ends for mark in _OWN)


def _path_of(file: Path) -> str:
    """Return the path of a file as recorded in the store."""
    return storable(str(file.resolve()))


_FIRST_TOO_LARGE = 2**63  # limit of SQLite's integers: clocks may be set to the year 2300


def _stamp_of(file: Path) -> _Stamp | None:
    """Return combined size and time of a file and its TOML file, as storable numbers; None if the file is gone."""
    try:
        _, size, *times = state_of(file)
    except OSError:
        return None
    with contextlib.suppress(OSError):
        _, more, *later = state_of(file.with_suffix(".toml"))
        size, times = size + more, times + later
    return size, max(times) % _FIRST_TOO_LARGE
