"""Storing of lane records: given files, or all files written to a watched folder."""

from __future__ import annotations

import signal
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from jounce.core.errors import DescriptionError, JounceError, RecordingError, is_of_system
from jounce.core.files import existing_file
from jounce.core.operation import Mark, Number, Switch, Texts, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import to_plain
from jounce.core.shown import Shown
from jounce.inspection.archive.lane import LIMITS, ImportedRecord, check_methods, import_record
from jounce.inspection.archive.questions import STORE
from jounce.inspection.archive.store import Store
from jounce.inspection.archive.watching import FolderWatch, check_folder
from jounce.inspection.limits import load_limits
from jounce.parts.testers import Tester, as_tester

TESTER = Mark(
    "A tester file, or the name of a shipped one; by default the one named in the header."
)


@dataclass(frozen=True)
class ImportedRecords(Shown):
    """Result of storing records.

    Attributes
    ----------
    store : str
        Location of the store.
    records : tuple of ImportedRecord
        Stored records, each with number, verdict, and whether it is new.
    failed : dict of str to str
        Reasons by name of files that could not be stored.
    folder : str
        Watched folder; empty if files were given.
    is_whole : bool
        Whether all records were stored and graded.
    """

    store: str
    records: tuple[ImportedRecord, ...]
    failed: dict[str, str]
    folder: str = ""
    is_whole: bool = True

    def to_dict(self) -> dict[str, Any]:
        """Return records and failures as plain data."""
        watched = {"folder": self.folder} if self.folder else {}
        return {
            **watched,
            "store": self.store,
            "records": to_plain(self.records),
            "failed": dict(self.failed),
        }


@operation(
    "inspect import",
    named={"methods": "method"},
    faces={"method": None},
    page="jounce.report.stores:imported_records_page",
    doing="importing",
    example="jounce inspect import lane/*.csv --store lane.sqlite --tester egea-specsus2018",
    note=(
        "The same file is never stored twice. What cannot be graded is stored with the reasons; the exit code is then "
        "2."
    ),
)
def import_inspections(
    files: Annotated[
        Sequence[Path | str],
        Texts("Records; the TOML files next to them are read as well.", "FILE..."),
    ],
    store: Annotated[Path | str, STORE],
    tester: Annotated[Tester | Path | str | None, TESTER] = None,
    methods: Annotated[Sequence[str], Texts("Deciding method. Repeat it.")] = (),
    limits: Annotated[Path | str | None, LIMITS] = None,
    *,
    each: Callable[[object], None] = lambda _: None,
    progress: Callable[[str], None] = lambda _: None,
) -> ImportedRecords:
    """Evaluate and grade records and store them; one line is printed as soon as a record is safe.

    The same file is never stored twice. Records that cannot be graded are stored with the reasons.

    Parameters
    ----------
    files : sequence of Path or str
        Records; accompanying TOML files are included. No file is moved.
    store : Path or str
        SQLite file, which is created if missing, or a database URL.
    tester : Tester, Path or str, optional
        Tester of the records; by default the shipped one named in each header.
    methods : sequence of {"eusama", "egea", "theta", "boge"}
        Deciding methods; by default the method of the tester.
    limits : Path or str, optional
        Limits file; by default the shipped limits.
    each : callable
        Called with each :class:`ImportedRecord` as soon as it is stored, or with the reason for a failure.
    progress : callable
        Called with a progress text of one line.

    Returns
    -------
    ImportedRecords
        Number and verdict of each record.

    Raises
    ------
    RecordingError
        For a missing file; nothing is stored then.
    DescriptionError
        For unknown methods, testers and limits.
    OutputError
        If the store cannot be written.

    Examples
    --------
    >>> import tempfile
    >>> folder = Path(tempfile.mkdtemp())
    >>> _ = (folder / "half.csv").write_text("time [s], left.plate.z [mm]")
    >>> found = import_inspections([folder / "half.csv"], folder / "lane.sqlite")
    >>> found.records[0].verdict, found.is_whole
    ('not graded', False)
    """
    paths = [existing_file(file, RecordingError) for file in files]
    deciding, chosen = check_methods(methods), None if tester is None else as_tester(tester)
    graded_by = load_limits(limits)
    kept: list[ImportedRecord] = []
    failed: dict[str, str] = {}
    with closing(Store(store)) as opened:
        for file in paths:
            progress(Phrase("importing {name}", name=file.name))
            try:
                kept.append(import_record(file, opened, chosen, methods=deciding, limits=graded_by))
            except (JounceError, OSError) as error:
                if is_of_system(error) or (
                    isinstance(error, JounceError) and error.where == opened.location
                ):
                    raise  # the other files would fail in the same way
                failed[str(file)] = str(error)
                each(str(error))
                continue
            each(kept[-1])
    is_whole = not failed and not any(record.problem for record in kept)
    return ImportedRecords(opened.location, tuple(kept), failed, is_whole=is_whole)


@operation(
    "inspect watch",
    faces={"interval": "1 s", "settle": "2 s"},
    page="jounce.report.stores:imported_records_page",
    doing="watching the folder",
    example="jounce inspect watch /srv/lane --store lane.sqlite --tester theta-msd3000",
    note=(
        "What cannot be read is reported once, and tried again when it has changed. With --once the exit code is then "
        "2."
    ),
)
def watch_inspections(
    folder: Annotated[Path | str, Mark("Folder into which the lane writes its records.", "DIR")],
    store: Annotated[Path | str, STORE],
    tester: Annotated[Tester | Path | str | None, TESTER] = None,
    limits: Annotated[Path | str | None, LIMITS] = None,
    interval: Annotated[float, Number("Polling interval.", unit="s", is_positive=True)] = 1.0,
    settle: Annotated[float, Number("A file unchanged for this time is complete.", unit="s")] = 2.0,
    *,
    once: Annotated[bool, Switch("Process the files present, then stop.")] = False,
    each: Callable[[object], None] = lambda _: None,
) -> ImportedRecords:
    """Watch a folder and store every complete record, until Ctrl-C. The files stay where they are.

    An unreadable file is reported once, and tried again after it has changed.

    Parameters
    ----------
    folder : Path or str
        Folder into which the lane writes its records.
    store : Path or str
        SQLite file, which is created if missing, or a database URL.
    tester : Tester, Path or str, optional
        Tester of the records; by default the shipped one named in each header.
    limits : Path or str, optional
        Limits file; by default the shipped limits.
    interval : float
        Polling interval of the folder [s].
    settle : float
        Time [s] without changes after which a file is complete.
    once : bool
        Whether to store the files present and return.
    each : callable
        Called with each :class:`ImportedRecord` as soon as it is stored, or with the reason for a failure.

    Returns
    -------
    ImportedRecords
        All stored records, after an interrupt (``KeyboardInterrupt``) has ended the watch.

    Raises
    ------
    JounceError
        If the folder does not exist, a time is negative, or the store cannot be opened.

    Examples
    --------
    >>> import tempfile
    >>> folder = Path(tempfile.mkdtemp())
    >>> _ = (folder / "torn.csv").write_text("time [s], left.pl")
    >>> found = watch_inspections(folder, folder / "lane.sqlite", settle=0.0, once=True)
    >>> found.records[0].verdict, found.is_whole
    ('not graded', True)
    """
    if settle < 0.0:
        raise DescriptionError(
            "out of range", where="settle", found=f"{settle:g} s", allowed="0 s or more"
        )
    kept: list[ImportedRecord] = []
    failed: dict[str, str] = {}
    chosen, graded_by = None if tester is None else as_tester(tester), load_limits(limits)
    check_folder(Path(folder))
    with closing(Store(store)) as opened, _until_stopped():
        watching = FolderWatch(folder, opened, chosen, graded_by, settle=settle)
        end = time.monotonic() + 3.0 * settle + 1.0
        while True:
            for seen in watching.each():
                if seen.imported is None:
                    failed[str(seen.file)] = seen.problem
                    each(f"{seen.file}: {seen.problem.removeprefix(f'{seen.file}: ')}")
                else:
                    failed.pop(str(seen.file), None)  # the store or the file may be available again
                    kept.append(seen.imported)
                    each(seen.imported)
            if once and (not watching.waiting or time.monotonic() > end):
                left = [str(file) for file in watching.waiting if str(file) not in failed]
                failed |= dict.fromkeys(
                    left, "not stored: still being written, or the store could not be used"
                )
                for file in left:
                    each(f"{file}: {failed[file]}")
                break
            time.sleep(min(interval, max(settle, 0.01)) if once else interval)
    return ImportedRecords(opened.location, tuple(kept), failed, str(folder), not (failed and once))


@contextmanager
def _until_stopped() -> Iterator[None]:
    """Run until Ctrl-C or a termination signal; both are normal ways to stop, not errors."""

    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    before = None
    with suppress(ValueError):  # only possible in the main thread
        before = signal.signal(signal.SIGTERM, stop)
    try:
        with suppress(KeyboardInterrupt):
            yield
    finally:
        if before is not None:
            signal.signal(signal.SIGTERM, before)
