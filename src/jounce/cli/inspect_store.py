"""``jounce inspect import | watch | reevaluate | history | search | export | verify``: the lane's record store."""

from __future__ import annotations

import signal
import sys
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import AsJson, Force, positive_quantity, quantity
from jounce.cli.outputs import FigureFile, check_outputs
from jounce.cli.reply import DONE, FAILED, REFUSED, Reply, progress
from jounce.cli.tables import show_written, table
from jounce.core.errors import DescriptionError, JounceError, RecordingError, unknown
from jounce.core.files import existing_file

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.inspection.archive.entries import StoredRecord
    from jounce.inspection.archive.history import Trend, WheelVisit
    from jounce.inspection.archive.lane import ImportedRecord
    from jounce.inspection.archive.reevaluation import Reevaluation
    from jounce.parts.testers import Tester

StoreName = Annotated[str, typer.Option("--store", help="The store: a SQLite file, or a database URL.")]
TesterName = Annotated[
    str | None,
    typer.Option(help="A tester file, or the name of a shipped one; by default the one that the header names."),
]
LimitsName = Annotated[str | None, typer.Option("--limits", help="A limits file in place of the shipped limits.")]
Plate = Annotated[str | None, typer.Option(help="Number plate; capitals, spaces and hyphens do not count; B-AB*.")]
Verdict = Annotated[str | None, typer.Option(help="pass, advise, fail or not graded: of the axle.")]
TesterIs = Annotated[str | None, typer.Option("--tester", help="The name in its file, or of a shipped one.")]
Since = Annotated[str | None, typer.Option(help="First day, 2026-01-31.")]
Until = Annotated[str | None, typer.Option(help="Last day.")]
_SHOWN = ("number", "date", "plate", "vehicle", "axle", "tester", "name")


def import_(
    files: Annotated[
        list[Path], typer.Argument(metavar="FILE...", help="Records; the TOML files beside them as well.")
    ],
    store: StoreName,
    tester: TesterName = None,
    method: Annotated[list[str] | None, typer.Option(help="Evaluate and decide by it; repeat it.")] = None,
    limits: LimitsName = None,
    as_json: AsJson = False,
) -> Reply:
    """Evaluate and grade records and put them into the store; a line is printed when a record is safe.

    The same file is never stored twice. What cannot be graded is stored with its reasons; the exit code is 2 then.

    Example: jounce inspect import lane/*.csv --store lane.sqlite --tester egea-specsus2018
    """
    from jounce.inspection.archive.lane import import_record
    from jounce.inspection.archive.store import Store
    from jounce.inspection.evaluation import METHODS
    from jounce.inspection.limits import load_limits

    for file in files:
        existing_file(file, RecordingError)
    for one in method or ():
        if one not in METHODS:
            raise unknown(one, METHODS, what="method", where="--method")
    chosen, graded_by = _tester(tester), load_limits(limits)
    kept: list[ImportedRecord] = []
    failed: dict[str, str] = {}
    with closing(Store(store)) as opened, progress() as say:
        for file in files:
            say(f"importing {file.name}")
            try:
                kept.append(import_record(file, opened, chosen, methods=method, limits=graded_by))
            except (JounceError, OSError) as error:
                if isinstance(error, JounceError) and error.where == opened.location:
                    raise  # the store cannot be used: the other files fare no better
                failed[str(file)] = str(error)
                sys.stderr.write(f"jounce: {error}\n")
                continue
            _say_kept(kept[-1], as_json=as_json)
    plain = {"store": opened.location, "records": kept, "failed": failed}
    unfit = failed or any(one.problem for one in kept)
    return Reply(plain, lambda out: _draw_import(out, kept, failed), as_json, REFUSED if unfit else DONE)


def watch(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="Where the lane writes its records.")],
    store: StoreName,
    tester: TesterName = None,
    limits: LimitsName = None,
    interval: Annotated[str, typer.Option(help="Time between two looks.")] = "1 s",
    settle: Annotated[str, typer.Option(help="A file that stays the same for so long is finished.")] = "2 s",
    once: Annotated[bool, typer.Option("--once", help="Take what is there, and end.")] = False,
    as_json: AsJson = False,
) -> Reply:
    """Watch a folder and put every finished record into the store, until Ctrl-C. The files stay where they are.

    What cannot be read is reported once; it is looked at again when it has changed.

    Example: jounce inspect watch /srv/lane --store lane.sqlite --tester theta-msd3000
    """
    from jounce.inspection.archive.store import Store
    from jounce.inspection.archive.watching import FolderWatch
    from jounce.inspection.limits import load_limits

    pause, settled = positive_quantity(interval, "s", "--interval"), quantity(settle, "s", "--settle")
    if settled < 0.0:
        raise DescriptionError("out of range", where="--settle", found=settle, allowed="0 s or more")
    kept: list[ImportedRecord] = []
    failed: dict[str, str] = {}
    chosen, graded_by = _tester(tester), load_limits(limits)
    with closing(Store(store)) as opened:
        watching = FolderWatch(folder, opened, chosen, graded_by, settle=settled)
        end = time.monotonic() + 3.0 * settled + 1.0
        with _until_stopped():
            while True:
                for seen in watching.each():
                    if seen.imported is None:
                        failed[str(seen.file)] = seen.problem
                        sys.stderr.write(f"jounce: {seen.file}: {seen.problem.removeprefix(f'{seen.file}: ')}\n")
                    else:
                        failed.pop(str(seen.file), None)  # the store, or the file, may have come back
                        kept.append(seen.imported)
                        _say_kept(seen.imported, as_json=as_json)
                if once and (not watching.is_waiting or time.monotonic() > end):
                    break
                time.sleep(min(pause, max(settled, 0.01)) if once else pause)
    plain = {"folder": str(folder), "store": opened.location, "records": kept, "failed": failed}
    return Reply(plain, lambda out: _draw_import(out, kept, failed), as_json)


def reevaluate(
    store: StoreName,
    limits: LimitsName = None,
    tester: Annotated[
        str | None, typer.Option(help="For records of which no tester is known: a tester file, or a shipped one.")
    ] = None,
    workers: Annotated[int, typer.Option(min=1, help="Processes.")] = 2,
    from_files: Annotated[
        bool, typer.Option("--from-files", help="Read the files as they came in once more (slower).")
    ] = False,
    as_json: AsJson = False,
) -> Reply:
    """Evaluate and grade all stored records again, under other limits; earlier gradings are kept.

    Example: jounce inspect reevaluate --store lane.sqlite --limits stricter.toml
    """
    from jounce.inspection.archive.reevaluation import reevaluate as again
    from jounce.inspection.archive.store import Store
    from jounce.inspection.limits import load_limits

    chosen, graded_by = _tester(tester), load_limits(limits)
    Store(store, read_only=True).close()  # where there is no store, none is made
    with closing(Store(store)) as opened, progress() as say:
        found = again(
            opened, graded_by, tester=chosen, workers=workers, from_files=from_files,
            say=lambda done, number: say(f"evaluated {done} of {number}"),
        )  # fmt: skip
    plain = {
        "store": opened.location, "limits": graded_by.label, "records": found.records, "added": found.added,
        "unchanged": found.unchanged, "changed": found.changed, "failed": found.failed,
        "changes": [{"before": a, "after": b, "records": count} for (a, b), count in found.changes.items()],
    }  # fmt: skip
    return Reply(plain, lambda out: _draw_again(out, found, graded_by.label), as_json, FAILED if found.failed else DONE)


def history(
    plate: Annotated[str, typer.Option(help="Number plate; capitals, spaces and hyphens do not count.")],
    store: StoreName,
    figure: FigureFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Show one vehicle over the years: adhesion, phase angle and damping ratio of each wheel, and their trend.

    Example: jounce inspect history --plate "B-AB 123" --store lane.sqlite --figure history.svg
    """
    from jounce.inspection.archive.history import history_of, trends_of
    from jounce.inspection.archive.store import Store

    check_outputs(figure=figure, force=force)
    with closing(Store(store, read_only=True)) as opened:
        records = opened.records(plate=plate)
        visits = history_of(opened, plate)
    if not records:
        raise RecordingError(
            "no record of this number plate", where=opened.location, found=plate, hint="See: inspect search."
        )
    trends = trends_of(visits)
    if figure is not None:
        from jounce.plots.inspection import vehicle_history
        from jounce.plots.style import write_figure

        write_figure(vehicle_history(visits), figure, force=force)
    plain = {
        "plate": records[-1].plate, "vehicle": records[-1].vehicle, "records": [one.number for one in records],
        "wheels": [_visit(one) for one in visits], "trends": trends, "figure": figure,
    }  # fmt: skip
    return Reply(plain, lambda out: _draw_history(out, plain, visits, trends), as_json)


def search(
    store: StoreName,
    plate: Plate = None,
    verdict: Verdict = None,
    tester: TesterIs = None,
    since: Since = None,
    until: Until = None,
    as_json: AsJson = False,
) -> Reply:
    """Find records by plate, verdict, tester and date.

    Example: jounce inspect search --store lane.sqlite --verdict fail --since 2026-01-01
    """
    from jounce.inspection.archive.store import Store

    conditions = _conditions(plate, verdict, tester, since, until)
    with closing(Store(store, read_only=True)) as opened:
        found = [_summary(record) for record in opened.records(**conditions)]
    columns = (*_SHOWN, "verdict")
    rows = [[record[name] for name in columns] for record in found]
    title = f"{len(found)} record{'' if len(found) == 1 else 's'}"
    shown = lambda out: out.print(table(title, columns, rows, text=range(1, len(columns))))  # noqa: E731
    return Reply({"store": opened.location, "records": found}, shown, as_json)


def export(
    store: StoreName,
    out: Annotated[Path, typer.Option(help="Table to write: .csv or .parquet.")],
    plate: Plate = None,
    verdict: Verdict = None,
    tester: TesterIs = None,
    since: Since = None,
    until: Until = None,
    damaged: Annotated[
        bool, typer.Option("--damaged", help="Write what can still be read of a damaged store (all of it).")
    ] = False,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Write the newest results as a table with a row for each wheel (SI).

    Example: jounce inspect export --store lane.sqlite --out lane.parquet --since 2026-01-01
    """
    from jounce.inspection.archive.exporting import check_export, rows_of
    from jounce.inspection.archive.exporting import export as write
    from jounce.inspection.archive.store import Store

    conditions = _conditions(plate, verdict, tester, since, until)
    check_export(out, force=force)
    lost: list[str] = []
    with closing(Store(store, read_only=True, damaged=damaged)) as opened:
        if damaged:
            records, lost = opened.readable_records()
        else:
            records = opened.records(**conditions)
    rows = rows_of(records)
    write(rows, out, force=force)
    for text in lost:
        sys.stderr.write(f"jounce: {text}\n")
    plain = {"store": opened.location, "out": str(out), "records": len(records), "rows": len(rows), "lost": lost}
    said = f"written: {out}, {len(records)} records, {len(rows)} rows"
    return Reply(plain, lambda console: console.print(said), as_json, FAILED if lost else DONE)


def verify(store: StoreName, as_json: AsJson = False) -> Reply:
    """Check a store byte by byte: the database, and every record against its checksum. Nothing is written.

    Example: jounce inspect verify --store lane.sqlite
    """
    from jounce.inspection.archive.store import Store

    with closing(Store(store, read_only=True)) as opened:
        found, count = opened.problems(), len(opened.numbers())
    plain = {"store": opened.location, "records": count, "problems": found}
    if found:
        raise RecordingError(
            f"the store is damaged: {'; '.join(found)}", where=opened.location, hint="Use a copy of the store."
        )
    return Reply(plain, lambda out: out.print(f"{opened.location}: sound, {count} records"), as_json)


def register(app: typer.Typer) -> None:
    """Add the commands of the store to ``jounce inspect``."""
    app.command("import")(import_)
    for command in (watch, reevaluate, history, search, export, verify):
        app.command(command.__name__)(command)


def _tester(name: str | None) -> Tester | None:
    from jounce.parts.testers import load_tester

    return None if name is None else load_tester(name)


def _conditions(
    plate: str | None, verdict: str | None, tester: str | None, since: str | None, until: str | None
) -> dict[str, Any]:
    """Conditions of a search, checked."""
    from jounce.inspection.archive.history import day_number
    from jounce.inspection.limits import VERDICTS
    from jounce.inspection.result import NOT_GRADED

    words = (*VERDICTS, *(() if NOT_GRADED in VERDICTS else (NOT_GRADED,)))
    if verdict is not None and verdict not in words:
        raise unknown(verdict, words, what="verdict", where="--verdict")
    for option, day in (("--since", since), ("--until", until)):
        if day is not None and day_number(day) is None:
            raise DescriptionError("no day", where=option, found=day, allowed="e.g. 2026-01-31")
    if tester is not None:
        from jounce.parts.testers import library, load_tester

        tester = load_tester(tester).name if tester in library() else tester
    return {"plate": plate, "verdict": verdict, "tester": tester, "since": since, "until": until}


@contextmanager
def _until_stopped() -> Iterator[None]:
    """Work until Ctrl-C, or until the system asks to end; both are the usual way to stop and no error."""

    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    before = None
    with suppress(ValueError):  # only the main thread may
        before = signal.signal(signal.SIGTERM, stop)
    try:
        with suppress(KeyboardInterrupt):
            yield
    finally:
        if before is not None:
            signal.signal(signal.SIGTERM, before)


def _say_kept(kept: ImportedRecord, *, as_json: bool) -> None:
    """Acknowledge a record at once: it is safe."""
    if as_json:
        return
    word = "accepted" if kept.is_new else "known"
    reason = f" ({kept.problem})" if kept.problem else ""
    sys.stdout.write(f"{word} {kept.number} {kept.file}: {kept.verdict}{reason}\n")
    sys.stdout.flush()


def _draw_import(out: Console, kept: list[ImportedRecord], failed: dict[str, str]) -> None:
    new = sum(one.is_new for one in kept)
    ungraded = sum(bool(one.problem) for one in kept if one.is_new)
    parts = [f"{new} new", f"{len(kept) - new} known already"]
    parts += [f"{ungraded} of the new ones cannot be graded"] if ungraded else []
    parts += [f"{len(failed)} not readable"] if failed else []
    out.print(", ".join(parts))


def _draw_again(out: Console, found: Reevaluation, label: str) -> None:
    out.print(f"{found.records} records under limits {label}: {found.added} gradings added, {found.unchanged} the same")
    for (before, after), count in found.changes.items():
        out.print(f"  {before or 'without a grading'} → {after}: {count}")
    for number, problem in found.failed.items():
        out.print(f"problem: record {number}: {problem}", soft_wrap=not out.is_terminal)


def _summary(record: StoredRecord) -> dict[str, Any]:
    grading = record.grading
    about = {name: getattr(record, name) for name in (*_SHOWN, "accepted")}
    return {**about, "verdict": grading and grading.verdict, "limits": grading and grading.limits}


def _visit(visit: WheelVisit) -> dict[str, Any]:
    about = {"record": visit.record, "date": visit.date, "axle": visit.axle, "wheel": visit.wheel}
    return {**about, **visit.values, "verdict": visit.verdict, "limits": visit.limits}


def _draw_history(out: Console, plain: dict[str, Any], visits: list[WheelVisit], trends: list[Trend]) -> None:
    title = ", ".join(filter(None, (plain["plate"], plain["vehicle"])))
    header = ("date", "axle", "wheel", "adhesion", "phase [deg]", "theta", "verdict", "record")
    rows = [(one.date, one.axle, one.wheel, *one.values.values(), one.verdict, one.record) for one in visits]
    out.print(table(title, header, rows, text=(0, 1, 2, 6)))
    if trends:
        rows_ = [(one.axle, one.wheel, one.quantity, one.change_per_year, one.visits) for one in trends]
        out.print(table("change per year", ("axle", "wheel", "value", "per year", "visits"), rows_, text=(0, 1, 2)))
    show_written(out, plain)
