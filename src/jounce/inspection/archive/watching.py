"""Watch a folder of a test lane: every record written there goes into the store; the files stay."""

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
_END = 1 << 15  # bytes at either end, in which a format shows
_OWN = (b'"jounce.protocol/', b"axle_verdict")
"""What only a protocol's values and an exported table hold, near their beginning or end."""


def record_suffixes() -> tuple[str, ...]:
    """Suffixes of files that may be records."""
    from jounce.recordings.readers import READERS

    return tuple(suffix for reader in READERS for suffix in reader.suffixes)


@dataclass(frozen=True)
class Seen:
    """Outcome of a file of the folder."""

    file: Path  # where it is, and stays
    imported: ImportedRecord | None  # the stored record; None if the file could not be read
    problem: str = ""  # why it could not be read, or not be graded; empty where all is well


def check_folder(folder: Path) -> None:
    """Refuse anything but a folder, before a store is created for it."""
    if not folder.is_dir():
        what = "a file, not a folder" if folder.exists() else "no such folder"
        raise JounceError(what, where=str(folder), hint="Check the path and the name.")


class FolderWatch:
    """Scans a folder repeatedly, and puts finished records into a store.

    A file counts as finished when its size and time, and those of the TOML file beside it, stay the same for
    ``settle`` seconds. What was looked at is remembered in the store: a file that cannot be read is reported once, and
    again only after it has changed. Names that begin with a dot or a tilde, and folders in the folder, are skipped.
    By default a record's tester is the shipped one that its header names. ``clock`` gives the time in s.

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
        """Files that may still be growing, or could not be read or stored so far."""
        return [file for _, _, file in self._waiting.values()]

    def look(self) -> list[Seen]:
        """Scan once; return the outcome for the files that are now finished."""
        return list(self.each())

    def each(self) -> Iterator[Seen]:
        """Scan once; yield each file as soon as it is stored or rejected."""
        now = self._clock()
        try:
            files = sorted(file for file in self.folder.iterdir() if self._may_be_record(file))
            self._reported = ""
        except OSError as error:  # a share that went away may come back
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
        """Import a file and remember it; where the store or a disk cannot be written to now, it comes again."""
        try:
            seen = self._import(file)
            if _stamp_of(file) == stamp:  # otherwise it went on growing and is looked at again
                if seen is not None:
                    self.store.note_watched(path, *stamp, seen.problem)
                self._done[path] = stamp
        except (OutputError, ResourceError) as error:
            reason = f"{error.what} {error.found}"
            if self._busy == reason:
                return None
            self._busy = reason
            return Seen(file, None, Phrase("{error} It is tried again.", error=error.message()))
        self._busy = ""
        self._waiting.pop(path, None)
        return seen

    def _import(self, file: Path) -> Seen | None:
        """Import a file; None for jounce's own output."""
        try:
            existing_file(file, RecordingError)  # a pipe would keep everything waiting
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
    """Whether a file is a protocol or an exported table: formats of records, but written from the store."""
    with file.open("rb") as content:
        ends = content.read(_END)
        content.seek(max(0, file.stat().st_size - _END))
        ends += content.read(_END)
    return any(mark in ends for mark in _OWN)


def _path_of(file: Path) -> str:
    """Path of a file as the store keeps it."""
    return storable(str(file.resolve()))


_FIRST_TOO_LARGE = 2**63  # of SQLite's integers: clocks may stand in the year 2300


def _stamp_of(file: Path) -> _Stamp | None:
    """Size and time of a file and the one beside it, each as one number that a store takes; None when it is gone."""
    try:
        _, size, *times = state_of(file)
    except OSError:
        return None
    with contextlib.suppress(OSError):
        _, more, *later = state_of(file.with_suffix(".toml"))
        size, times = size + more, times + later
    return size, max(times) % _FIRST_TOO_LARGE
