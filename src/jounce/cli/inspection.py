"""``jounce inspect``: shock absorbers on testers, simulated and measured, graded, and kept in the lane's store."""

from __future__ import annotations

import signal
import sys
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager, nullcontext, suppress
from dataclasses import replace
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.derived import add_commands
from jounce.cli.options import (
    STROKE,
    AsJson,
    Changes,
    Force,
    changes,
    check_outputs,
    warn_of,
)
from jounce.cli.reply import (
    DONE,
    REFUSED,
    Reply,
    drawing,
    progress,
    show_written,
    tell,
)
from jounce.core.errors import DescriptionError, JounceError, OutputError, RecordingError, is_of_system, unknown
from jounce.core.files import existing_file
from jounce.core.phrases import Phrase
from jounce.core.text import visible
from jounce.core.typed import positive_quantity, quantity
from jounce.core.waiting import progress_through

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.inspection.archive.lane import ImportedRecord, InspectedRecord
    from jounce.inspection.archive.store import Store
    from jounce.inspection.grading import VehicleGrade
    from jounce.inspection.limits import Limits
    from jounce.parts.testers import Tester
    from jounce.report import Page


app = typer.Typer(
    help=(
        "Shock-absorber inspection: simulate testers, evaluate and grade their records, print protocols, and keep all "
        "of it in the lane's record store (--store lane.sqlite)."
    ),
    no_args_is_help=True,
)
_OF_TESTER = "tester."
_SIDES, _BOTH, _AXLES = ("left", "right"), "both", ("front", "rear")


@app.command("simulate")
def simulate(
    rig: Annotated[str, typer.Argument(metavar="RIG", help="A rig or vehicle file, or a name of `jounce library`.")],
    method: Annotated[
        str | None, typer.Option(help="eusama, egea, theta or boge; by default the method of the tester.")
    ] = None,
    tester: Annotated[
        str | None, typer.Option(help="A tester file, or the name of a shipped one; by default one for the method.")
    ] = None,
    steady: Annotated[bool, typer.Option("--steady", help="Steady states instead of a sweep.")] = False,
    stroke: Annotated[str | None, typer.Option(help='Stroke of the exciter, peak to peak: "6 mm".')] = None,
    sweep_rate: Annotated[str | None, typer.Option(help='Rate of the sweep: "2.5 Hz/s".')] = None,
    wear: Annotated[
        str | None, typer.Option(help="Loss of damping, as a share: one number, or FIRST:LAST:STEP.")
    ] = None,
    wheel: Annotated[
        str,
        typer.Option(help="left or right: the wheel to test, and its plate; both: both wheels of an axle in turn."),
    ] = "left",
    axle: Annotated[str, typer.Option(help="Axle of a vehicle: front or rear.")] = "front",
    noise: Annotated[
        str, typer.Option(help='Standard deviation of the force noise, relative to the static load: "1 %".')
    ] = "0",
    seed: Annotated[int, typer.Option(min=0, help="Seed of the noise.")] = 0,
    set_: Changes = None,
    out: Annotated[Path | None, typer.Option(help="Write the record: RECORD.csv or RECORD.nc.")] = None,
    truth: Annotated[
        bool, typer.Option("--truth", help="Include channels in the record that no tester measures (truth.*).")
    ] = False,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Simulate a test, evaluate the record like a measured one, and grade it.

    --set changes the rig, and with `tester.` before the path the tester: --set tester.plate_mass="25 kg". With --json
    one wheel is one object; both wheels are {wheels: [...], axle: {...}}, as of `inspect evaluate`.

    Example: jounce inspect simulate audi-a6-quarter-car --method egea --wear 0:1:0.1
    """
    for option, value, allowed in (("--wheel", wheel, (*_SIDES, _BOTH)), ("--axle", axle, _AXLES)):
        if value not in allowed:
            raise DescriptionError("unknown", where=option, found=value, allowed=", ".join(allowed))
    several = wear is not None and ":" in wear
    if out is not None and (steady or several):
        what = "steady states have no record" if steady else "a record holds a single test"
        raise OutputError(what, where=f"--out {out}", hint="Leave out --steady, and give a single --wear.")
    check_outputs(recording=out, force=force)
    wanted = changes(set_)
    of_rig = {path: value for path, value in wanted.items() if not path.startswith(_OF_TESTER)}
    of_tester = {path.removeprefix(_OF_TESTER): value for path, value in wanted.items() if path not in of_rig}
    chosen_tester = _chosen_tester(method, tester, stroke, sweep_rate, of_tester)
    from jounce.inspection.simulated import simulate_axle, simulate_inspection, sweep_wear
    from jounce.parts import load
    from jounce.parts.variants import worn

    chosen = load(rig).with_changes(of_rig) if of_rig else load(rig)
    warn_of(chosen, rig)
    name = Path(rig).stem if rig.endswith(".toml") else rig
    share = quantity(noise, "1", "--noise")
    wears = sweep_wear(wear) if wear is not None else [0.0]
    about = {"rig": rig, "tester": chosen_tester.name, "method": method or chosen_tester.method, "steady": steady}
    if wheel == _BOTH:
        if steady or len(wears) > 1:
            what = "steady states need a single wheel" if steady else "a range of wear needs a single wheel"
            raise DescriptionError(what, where="--wheel", found=_BOTH, allowed=", ".join(_SIDES))
        graded, measured = simulate_axle(
            worn(chosen, wears[0]) if wears[0] else chosen, chosen_tester, method=method,
            axle=axle, noise=share, seed=seed, vehicle=name,  # type: ignore[arg-type]
        )  # fmt: skip
        if out is not None:
            _write_record(measured, out, truth=truth, force=force)
        both = {**graded.to_dict(), **about, "record": out and str(out)}

        from jounce.inspection.grading import grade_vehicle
        from jounce.report.inspection import inspection_page

        title = f"{rig} on {chosen_tester.name}, sweep of both wheels"
        return _page_reply(both, inspection_page(grade_vehicle([graded]), title=title), as_json=as_json)
    runs = []
    with progress() as say:
        for number, lost in enumerate(wears, 1):
            say(progress_through("testing {which} of {count}", number, len(wears)) if len(wears) > 1 else "testing")
            found = simulate_inspection(
                worn(chosen, lost) if lost else chosen, chosen_tester, method=method, steady=steady,
                wheel=wheel, axle=axle, noise=share, seed=seed, vehicle=name,  # type: ignore[arg-type]
            )  # fmt: skip
            runs.append(found)
    if out is not None and runs[0].record is not None:
        _write_record(runs[0].record, out, truth=truth, force=force)
    from jounce.report.inspection import wear_page, wheel_page

    title = f"{rig} on {chosen_tester.name}, {'steady states' if steady else 'sweep'}"
    tables = [found.wheel.to_dict() for found in runs]
    if not steady:
        for one, found in zip(tables, runs, strict=True):
            one["truth"] = {"theta_road": found.theta_road, "theta_rig": found.theta_rig}
    if not several:
        plain: dict[str, Any] = {**tables[0], **about, "record": out and str(out)}
        return _page_reply(plain, wheel_page(runs[0].wheel, title=title), as_json=as_json)
    swept = {**about, "wear": wears, "wheels": [{"wear": lost, **one} for lost, one in zip(wears, tables, strict=True)]}
    return _page_reply(swept, wear_page(wears, [run.wheel for run in runs], title=title), as_json=as_json)


def _page_reply(plain: dict[str, Any], page: Page, *, as_json: bool) -> Reply:
    """Answer with a page."""

    def draw(console: Console) -> None:
        from jounce.cli.terminal import show_page

        show_page(console, page)
        show_written(console, plain)

    return Reply(plain, draw, as_json)


def _chosen_tester(
    method: str | None, tester: str | None, stroke: str | None, sweep_rate: str | None, wanted: dict[str, Any]
) -> Tester:
    """The tester that is asked for, with its changes."""
    from jounce.inspection.simulated import tester_for
    from jounce.parts.testers import load_tester

    if method is None and tester is None:
        raise DescriptionError(
            "no method is given",
            where="--method",
            allowed="eusama, egea, theta, boge; or --tester with a file or a name",
        )
    if method is not None:
        found = tester_for(method)
    if tester is not None:
        found = load_tester(tester)
    made = dict(wanted)
    if stroke is not None:
        made["stroke"] = positive_quantity(stroke, "m", "--stroke", most=STROKE)
    if sweep_rate is not None:
        made["programme.sweep_rate"] = positive_quantity(sweep_rate, "Hz/s", "--sweep-rate")
    return found.with_changes(made) if made else found


def _write_record(record: Any, file: Path, *, truth: bool, force: bool) -> None:
    from jounce.testers.testing import write_test

    kept = record if truth else record[[name for name in record.data_vars if not str(name).startswith("truth.")]]
    write_test(kept, file, force=force)


@app.command("evaluate")
def evaluate(
    record: Annotated[
        list[Path],
        typer.Argument(metavar="RECORD...", help="Record of one axle (CSV, netCDF, ...), or one of each axle."),
    ],
    tester: Annotated[
        str, typer.Option(help="A tester file, or the name of a shipped one (eusama, egea-specsus2018, ...).")
    ],
    vehicle: Annotated[
        str | None, typer.Option(help="Vehicle file or name; its weight is compared with the static loads.")
    ] = None,
    method: Annotated[
        list[str] | None,
        typer.Option(help="Deciding method: eusama, egea, theta or boge; by default that of the tester. Repeat it."),
    ] = None,
    limits: Annotated[str | None, typer.Option(help="A limits file instead of the shipped limits.")] = None,
    report: Annotated[
        list[Path] | None,
        typer.Option(
            help="Write a protocol (.pdf or .html), with its values as .json; CAR.pdf,html writes both. Repeat it."
        ),
    ] = None,
    store: Annotated[
        str | None, typer.Option(help="Store record and result: a SQLite file (created if missing), or a database URL.")
    ] = None,
    language: Annotated[str, typer.Option(help="Language of the protocol: en or de.")] = "en",
    date: Annotated[str | None, typer.Option(help="Day of the test, e.g. 2026-11-21.")] = None,
    place: Annotated[str | None, typer.Option(help="Where it was made.")] = None,
    plate: Annotated[str | None, typer.Option(help="Number plate of the vehicle.")] = None,
    inspector: Annotated[str | None, typer.Option(help="Who made it.")] = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Evaluate and grade the records of one or both axles, write the protocol, and store both.

    What --date, --place, --plate and --inspector say takes the place of the header's, in the store as well. A record
    that cannot be graded is stored with the reasons, never graded by guess; the exit code is then 2.

    Example: jounce inspect evaluate front.csv rear.csv --tester egea-specsus2018 --report car.pdf
    """
    from jounce.inspection.grading import grade_vehicle
    from jounce.inspection.limits import load_limits
    from jounce.inspection.quantities import LANGUAGES
    from jounce.parts import load
    from jounce.parts.testers import load_tester
    from jounce.report.protocol import check_protocol, facts_of, write_protocol

    if len(record) > len(_AXLES):
        raise DescriptionError("too many records", where="RECORD", found=len(record), allowed="one of each axle")
    for file in record:
        existing_file(file, RecordingError)
    _check_methods(method)
    if language not in LANGUAGES:
        raise unknown(language, LANGUAGES, what="language", where="--language")
    protocols = [one for given in report or () for one in _formats_of(given)]
    for file in protocols:
        check_protocol(file, force=force)
    if len(set(protocols)) < len(protocols):
        raise DescriptionError("the same protocol is given twice", where="--report")
    methods = list(dict.fromkeys(method or ())) or None
    chosen, graded_by = load_tester(tester), load_limits(limits)
    facts = {"date": date, "place": place, "plate_number": plate, "operator": inspector}
    given = {key: text for key, text in facts.items() if text is not None}
    task = {"tester": chosen, "vehicle": None if vehicle is None else load(vehicle), "methods": methods}
    name = "" if vehicle is None else Path(vehicle).stem
    inspected: list[InspectedRecord] = []
    numbers: list[int] = []
    with nullcontext() if store is None else closing(_store_at(store)) as opened, progress() as say:
        for file in record:
            say(Phrase("evaluating {name}", name=file.name))
            inspected.append(_inspect(file, task, graded_by, {"vehicle": name, **given}, opened, numbers))
    whole = grade_vehicle([one.graded for one in inspected])
    about = {"vehicle": name, "tester": chosen.name, **facts_of(whole)}
    about["record"] = ", ".join(
        f"{one.path.name} (sha256 {sha256(one.path.read_bytes()).hexdigest()[:12]})" for one in inspected
    )
    records = {one.graded.axle: one.record for one in inspected}
    written: list[Path] = []
    missing: list[Finding] = []
    for file in protocols:
        with drawing() as undrawn:
            written += write_protocol(
                whole, file, records=records, language=language, about=about, force=force or file is not protocols[0],
            )  # fmt: skip
        if undrawn:
            written.append(file.with_suffix(".json"))
            missing += undrawn
    plain = _plain_vehicle(whole, inspected) | {"protocol": list(dict.fromkeys(map(str, written)))}
    plain["store"] = None if opened is None else {"location": opened.location, "records": numbers}
    unfit = _unfit(inspected)
    if unfit is not None:
        plain["error"] = {"kind": "RecordingError", "message": str(unfit), "where": unfit.where, "what": unfit.what}
        tell(f"{unfit}")
    code = DONE if unfit is None else REFUSED
    return Reply(plain, lambda console: _draw_vehicle(console, whole, plain), as_json, code, missing)


def _store_at(place: str) -> Store:
    from jounce.inspection.archive.store import Store

    return Store(place)


def _check_methods(methods: list[str] | None) -> None:
    from jounce.inspection.methods import METHODS

    for one in methods or ():
        if one not in METHODS:
            raise unknown(one, METHODS, what="method", where="--method")


def _formats_of(file: Path) -> list[Path]:
    """Files that a name with several suffixes stands for: ``car.pdf,html`` is ``car.pdf`` and ``car.html``."""
    first, *others = file.name.split(",")
    if not others or any(not one.isalnum() for one in others):
        return [file]
    return [file.with_name(first), *(file.with_name(first).with_suffix(f".{one}") for one in others)]


def _inspect(
    file: Path, task: dict[str, Any], limits: Limits, given: dict[str, str], store: Store | None, numbers: list[int]
) -> InspectedRecord:
    """Read, evaluate and grade one record and keep it; what cannot be read is kept, too, before it is refused.

    ``given`` is what the command line says of the test; its vehicle counts where the header names none.
    """
    from jounce.inspection.archive.entries import pack
    from jounce.inspection.archive.lane import entry_of, grading_of, inspect_record, refusal_of
    from jounce.inspection.record import read_record, with_facts

    read, facts = None, {key: text for key, text in given.items() if key != "vehicle"}
    try:
        record, said = read_record(file, task["tester"])
        record, overruled = with_facts(record, facts, where=str(file))
        read = (record, [*said, *overruled])
        found = inspect_record(file, task["tester"], task["vehicle"], task["methods"], limits, read=read)
    except Exception as error:
        if is_of_system(error):  # the record was not looked at: this is no verdict
            raise
        # a description that does not fit a readable record is a wrong request, no property of the record
        if store is not None and not (read is not None and isinstance(error, DescriptionError)):
            _keep(store, entry_of(file, facts, **task), refusal_of(error, limits))
        raise
    if store is not None:
        entry = replace(entry_of(file, {**given, **found.facts}, **task), signals=pack(*read))
        numbers.append(_keep(store, entry, grading_of(found.graded)))
    return found


def _keep(store: Any, entry: Any, grading: Any) -> int:
    """Put a record into the store; one that it holds already gets one more grading."""
    number, is_new = store.accept(entry, grading)
    if not is_new:
        store.add_gradings([(number, grading)])
    return int(number)


def _plain_vehicle(whole: VehicleGrade, inspected: list[InspectedRecord]) -> dict[str, Any]:
    """One axle as it is; two with all wheels in one list, each with its axle."""
    if len(whole.axles) == 1:
        return {"record": str(inspected[0].path), **whole.axles[0].to_dict(), "vehicle": whole.summary()}
    axles = [one.to_dict() for one in whole.axles]
    wheels = [
        {"axle": one.axle, **wheel} for one, plain in zip(whole.axles, axles, strict=True) for wheel in plain["wheels"]
    ]
    return {
        "records": [str(one.path) for one in inspected],
        "wheels": wheels,
        "axles": [{**plain["axle"], "facts": plain["facts"], "findings": plain["findings"]} for plain in axles],
        "deciding": axles[0]["deciding"],
        "limits": axles[0]["limits"],
        "vehicle": whole.summary(),
        "verdict": whole.verdict,
    }


def _unfit(inspected: list[InspectedRecord]) -> RecordingError | None:
    """The first reason why a wheel is not graded, as an error; None where all are."""
    for one in inspected:
        for grade in one.graded.grades:
            if grade.verdict == "not graded":
                reason = grade.reasons[0].text() if grade.reasons else "nothing is known"
                return RecordingError(
                    Phrase(
                        "the {wheel} wheel cannot be graded: {reason}",
                        wheel=grade.wheel,
                        reason=reason.removesuffix("."),
                    ),
                    where=str(one.path),
                )
    return None


def _draw_vehicle(console: Console, whole: VehicleGrade, plain: dict[str, Any]) -> None:
    from jounce.cli.terminal import show_page
    from jounce.report.inspection import inspection_page

    names = plain.get("records", [plain.get("record")])
    show_page(console, inspection_page(whole, title=", ".join(map(str, names))))
    for file in plain["protocol"]:
        console.print(f"written: {file}")
    if plain["store"] is not None:
        numbers = ", ".join(map(str, plain["store"]["records"]))
        console.print(f"stored: {plain['store']['location']}, record {numbers}")


StoreName = Annotated[str, typer.Option("--store", help="The store: a SQLite file, or a database URL.")]
TesterName = Annotated[
    str | None,
    typer.Option(help="A tester file, or the name of a shipped one; by default the one named in the header."),
]
LimitsName = Annotated[str | None, typer.Option("--limits", help="A limits file instead of the shipped limits.")]


@app.command("import")
def import_(
    files: Annotated[
        list[Path], typer.Argument(metavar="FILE...", help="Records; the TOML files next to them are read as well.")
    ],
    store: StoreName,
    tester: TesterName = None,
    method: Annotated[list[str] | None, typer.Option(help="Deciding method. Repeat it.")] = None,
    limits: LimitsName = None,
    as_json: AsJson = False,
) -> Reply:
    """Evaluate and grade records and store them; one line is printed as soon as a record is safe.

    The same file is never stored twice. What cannot be graded is stored with the reasons; the exit code is then 2.

    Example: jounce inspect import lane/*.csv --store lane.sqlite --tester egea-specsus2018
    """
    from jounce.inspection.archive.lane import import_record
    from jounce.inspection.archive.store import Store
    from jounce.inspection.limits import load_limits

    for file in files:
        existing_file(file, RecordingError)
    _check_methods(method)
    chosen, graded_by = _given_tester(tester), load_limits(limits)
    kept: list[ImportedRecord] = []
    failed: dict[str, str] = {}
    with closing(Store(store)) as opened, progress() as say:
        for file in files:
            say(Phrase("importing {name}", name=file.name))
            try:
                kept.append(import_record(file, opened, chosen, methods=method, limits=graded_by))
            except (JounceError, OSError) as error:
                if is_of_system(error) or (isinstance(error, JounceError) and error.where == opened.location):
                    raise  # the other files fare no better
                failed[str(file)] = str(error)
                tell(f"{error}")
                continue
            _say_kept(kept[-1], as_json=as_json)
    plain = {"store": opened.location, "records": kept, "failed": failed}
    unfit = failed or any(one.problem for one in kept)
    return Reply(plain, lambda out: _draw_import(out, kept, failed), as_json, REFUSED if unfit else DONE)


@app.command("watch")
def watch(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="Folder into which the lane writes its records.")],
    store: StoreName,
    tester: TesterName = None,
    limits: LimitsName = None,
    interval: Annotated[str, typer.Option(help="Polling interval.")] = "1 s",
    settle: Annotated[str, typer.Option(help="A file unchanged for this time is complete.")] = "2 s",
    once: Annotated[bool, typer.Option("--once", help="Process the files present, then stop.")] = False,
    as_json: AsJson = False,
) -> Reply:
    """Watch a folder and store every complete record, until Ctrl-C. The files stay where they are.

    What cannot be read is reported once, and tried again when it has changed. With --once the exit code is then 2.

    Example: jounce inspect watch /srv/lane --store lane.sqlite --tester theta-msd3000
    """
    from jounce.inspection.archive.store import Store
    from jounce.inspection.archive.watching import FolderWatch, check_folder
    from jounce.inspection.limits import load_limits

    pause, settled = positive_quantity(interval, "s", "--interval"), quantity(settle, "s", "--settle")
    if settled < 0.0:
        raise DescriptionError("out of range", where="--settle", found=settle, allowed="0 s or more")
    kept: list[ImportedRecord] = []
    failed: dict[str, str] = {}
    chosen, graded_by, code = _given_tester(tester), load_limits(limits), DONE
    check_folder(folder)
    with closing(Store(store)) as opened:
        watching = FolderWatch(folder, opened, chosen, graded_by, settle=settled)
        end = time.monotonic() + 3.0 * settled + 1.0
        with _until_stopped():
            while True:
                for seen in watching.each():
                    if seen.imported is None:
                        failed[str(seen.file)] = seen.problem
                        tell(f"{seen.file}: {seen.problem.removeprefix(f'{seen.file}: ')}")
                    else:
                        failed.pop(str(seen.file), None)  # the store, or the file, may have come back
                        kept.append(seen.imported)
                        _say_kept(seen.imported, as_json=as_json)
                if once and (not watching.waiting or time.monotonic() > end):
                    left = [str(file) for file in watching.waiting if str(file) not in failed]
                    failed |= dict.fromkeys(left, "not stored: still being written, or the store could not be used")
                    for file in left:
                        tell(f"{file}: {failed[file]}")
                    code = REFUSED if failed else DONE
                    break
                time.sleep(min(pause, max(settled, 0.01)) if once else pause)
    plain = {"folder": str(folder), "store": opened.location, "records": kept, "failed": failed}
    return Reply(plain, lambda out: _draw_import(out, kept, failed), as_json, code)


def _given_tester(name: str | None) -> Tester | None:
    from jounce.parts.testers import load_tester

    return None if name is None else load_tester(name)


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
    warned = f", {kept.warnings} warning{'s' * (kept.warnings > 1)}" if kept.warnings else ""
    sys.stdout.write(visible(f"{word} {kept.number} {kept.file}: {kept.verdict}{reason}{warned}") + "\n")
    sys.stdout.flush()


def _draw_import(out: Console, kept: list[ImportedRecord], failed: dict[str, str]) -> None:
    new = sum(one.is_new for one in kept)
    ungraded = sum(bool(one.problem) for one in kept if one.is_new)
    parts = [f"{new} new", f"{len(kept) - new} already known"]
    parts += [f"{ungraded} of the new records cannot be graded"] if ungraded else []
    parts += [f"{len(failed)} not readable"] if failed else []
    out.print(", ".join(parts))
    if any(one.warnings for one in kept):
        out.print("what the warnings are: column findings of inspect export")


add_commands(app, "inspect")
