"""``jounce inspect evaluate``: what the record of a test lane says, graded, printed and kept."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import AsJson, Force
from jounce.cli.reply import DONE, REFUSED, Reply, progress
from jounce.cli.tables import show_findings, table
from jounce.core.errors import DescriptionError, RecordingError, unknown
from jounce.core.files import existing_file

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.inspection.archive.lane import InspectedRecord
    from jounce.inspection.grading import GradedInspection, VehicleGrade
    from jounce.inspection.limits import Limits
    from jounce.inspection.quantities import Language, Quantity
    from jounce.inspection.result import WheelResult
    from jounce.parts.testers import Tester

_MOST_RECORDS = 2
_VERDICT_STYLES = {"pass": "green", "advise": "yellow", "fail": "bold red", "not graded": "bold"}


def evaluate(
    record: Annotated[
        list[Path], typer.Argument(metavar="RECORD...", help="A record (CSV, netCDF, ...) of one axle, or one of each.")
    ],
    tester: Annotated[
        str, typer.Option(help="A tester file, or the name of a shipped one (eusama, egea-specsus2018, ...).")
    ],
    vehicle: Annotated[
        str | None, typer.Option(help="The vehicle's file or name: its weight is compared with the static loads.")
    ] = None,
    method: Annotated[
        list[str] | None,
        typer.Option(help="eusama, egea, theta or boge: evaluate and decide by it. Repeat it. Default: the tester's."),
    ] = None,
    limits: Annotated[str | None, typer.Option(help="A limits file in place of the shipped limits.")] = None,
    protocol: Annotated[
        list[Path] | None, typer.Option(help="Write a protocol, .pdf or .html, and its values as .json. Repeat it.")
    ] = None,
    store: Annotated[
        str | None, typer.Option(help="Keep record and result: a file (SQLite, made if missing) or database URL.")
    ] = None,
    language: Annotated[str, typer.Option(help="Of the protocol: en or de.")] = "en",
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Evaluate and grade the record of one axle, or of both; write the protocol, keep both in the lane's store.

    A record that cannot be graded is stored with its reasons, never graded by guess; the exit code is 2 then.

    Example: jounce inspect evaluate front.csv rear.csv --tester egea-specsus2018 --protocol car.pdf
    """
    wanted = _Wanted(record, tester, vehicle, method, limits, protocol or [], language, force=force)
    open_store = None if store is None else _open(store)
    try:
        with progress() as say:
            inspected = [_inspect(file, wanted, open_store, say) for file in record]
    finally:
        if open_store is not None:
            open_store.close()
    from jounce.inspection.grading import grade_vehicle

    whole = grade_vehicle([one.graded for one, _ in inspected])
    written = _write(whole, [one for one, _ in inspected], wanted)
    plain = _plain(whole, [one for one, _ in inspected]) | {"protocol": [str(file) for file in written]}
    plain["store"] = (
        None
        if open_store is None
        else {"location": open_store.location, "records": [number for _, number in inspected]}
    )
    unfit = _unfit(inspected)
    if unfit is not None:
        plain["error"] = {"kind": "RecordingError", "message": str(unfit), "where": unfit.where, "what": unfit.what}
        sys.stderr.write(f"jounce: {unfit}\n")
    return Reply(plain, lambda console: _draw(console, whole, plain), as_json, DONE if unfit is None else REFUSED)


class _Wanted:
    """What is asked for, checked and loaded before any work is done."""

    def __init__(
        self,
        records: list[Path],
        tester: str,
        vehicle: str | None,
        methods: list[str] | None,
        limits: str | None,
        protocols: list[Path],
        language: str,
        *,
        force: bool,
    ) -> None:
        from jounce.inspection.evaluation import METHODS
        from jounce.inspection.limits import load_limits
        from jounce.inspection.quantities import LANGUAGES
        from jounce.parts.testers import load_tester

        if len(records) > _MOST_RECORDS:
            raise DescriptionError("too many records", where="RECORD", found=len(records), allowed="one of each axle")
        for file in records:
            existing_file(file, RecordingError)
        for one in methods or ():
            if one not in METHODS:
                raise unknown(one, METHODS, what="method", where="--method")
        if language not in LANGUAGES:
            raise unknown(language, LANGUAGES, what="language", where="--language")
        self.methods, self.force = list(dict.fromkeys(methods or ())) or None, force
        self.language: Language = "de" if language == "de" else "en"
        self.protocols = _checked(protocols, force=force)
        self.tester: Tester = load_tester(tester)
        self.limits: Limits = load_limits(limits)
        self.vehicle = None if vehicle is None else _vehicle(vehicle)
        self.vehicle_name = "" if vehicle is None else Path(vehicle).stem
        self.task: dict[str, Any] = {"tester": self.tester, "vehicle": self.vehicle, "methods": self.methods}


def _checked(protocols: list[Path], *, force: bool) -> list[Path]:
    if not protocols:
        return []
    from jounce.report.protocol import check_protocol

    for file in protocols:
        check_protocol(file, force=force)
    if len(set(protocols)) < len(protocols):
        raise DescriptionError("the same protocol is asked for twice", where="--protocol")
    return protocols


def _vehicle(name: str) -> Any:
    from jounce.parts import load

    return load(name)


def _open(location: str) -> Any:
    from jounce.inspection.archive.store import Store

    return Store(location)


def _inspect(file: Path, wanted: _Wanted, store: Any, say: Any) -> tuple[InspectedRecord, int | None]:
    """Read, evaluate and grade one record and keep it; what cannot be read is kept, too, before it is refused."""
    from jounce.inspection.archive.entries import pack
    from jounce.inspection.archive.lane import entry_of, grading_of, inspect_record, refusal_of
    from jounce.inspection.record import read_record

    say(f"evaluating {file.name}")
    read = None
    try:
        read = read_record(file, wanted.tester)
        found = inspect_record(file, wanted.tester, wanted.vehicle, wanted.methods, wanted.limits, read=read)
    except Exception as error:
        if store is not None and not (read is not None and isinstance(error, DescriptionError)):  # that is the request
            _keep(store, entry_of(file, **wanted.task), refusal_of(error, wanted.limits))
        raise
    if store is None:
        return found, None
    facts = {"vehicle": wanted.vehicle_name, **found.facts}
    entry = replace(entry_of(file, facts, **wanted.task), signals=pack(*read))
    return found, _keep(store, entry, grading_of(found.graded))


def _keep(store: Any, entry: Any, grading: Any) -> int:
    """Put a record into the store; one that it holds already gets one more grading."""
    number, is_new = store.accept(entry, grading)
    if not is_new:
        store.add_gradings([(number, grading)])
    return int(number)


def _write(whole: VehicleGrade, inspected: list[InspectedRecord], wanted: _Wanted) -> list[Path]:
    if not wanted.protocols:
        return []
    from jounce.report.protocol import facts_of, write_protocol

    about = {"vehicle": wanted.vehicle_name, "tester": wanted.tester.name, **facts_of(whole)}
    about["record"] = ", ".join(f"{one.path.name} {_digest(one.path)}" for one in inspected)
    records = {one.graded.axle: one.record for one in inspected}
    files: list[Path] = []
    for file in wanted.protocols:
        files += write_protocol(
            whole, file, records=records, language=wanted.language, about=about, force=wanted.force or bool(files)
        )
    return list(dict.fromkeys(files))


def _digest(file: Path) -> str:
    import hashlib

    return f"(sha256 {hashlib.sha256(file.read_bytes()).hexdigest()[:12]})"


def _plain(whole: VehicleGrade, inspected: list[InspectedRecord]) -> dict[str, Any]:
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


def _unfit(inspected: list[tuple[InspectedRecord, int | None]]) -> RecordingError | None:
    """The first reason why a wheel is not graded, as an error; None where all are."""
    for one, _ in inspected:
        for grade in one.graded.grades:
            if grade.verdict == "not graded":
                reason = grade.reasons[0].text() if grade.reasons else "nothing is known"
                return RecordingError(
                    f"the {grade.wheel} wheel cannot be graded: {reason.removesuffix('.')}", where=str(one.path)
                )
    return None


def _draw(console: Console, whole: VehicleGrade, plain: dict[str, Any]) -> None:
    for graded in whole.axles:
        draw_axle(console, graded)
    if len(whole.axles) > 1:
        console.print(f"vehicle: {whole.verdict}", style=_VERDICT_STYLES.get(whole.verdict, ""))
    for file in plain["protocol"]:
        console.print(f"written: {file}")
    if plain["store"] is not None:
        numbers = ", ".join(map(str, plain["store"]["records"]))
        console.print(f"stored: {plain['store']['location']}, record {numbers}")


def draw_axle(console: Console, graded: GradedInspection) -> None:
    """Print a graded axle: values of the wheels beside each other, reasons, findings."""
    sides = [wheel.wheel for wheel in graded.wheels]
    decides = ", ".join(graded.deciding)
    title = f"{graded.axle or 'axle'}: {graded.verdict} (decides: {decides}; limits: {graded.limits.label})"
    console.print(table(title, ("", *sides), _rows(graded)))
    for grade in graded.grades:
        for reason in grade.reasons:
            console.print(f"{grade.wheel}: {reason.text()}", soft_wrap=not console.is_terminal)
    for reason in graded.reasons:
        console.print(f"axle: {reason.text()}", soft_wrap=not console.is_terminal)
    weakening = [one for wheel in graded.wheels for one in wheel.findings if one.severity != "problem"]
    show_findings(console, [*graded.inspection.findings, *weakening])


def _rows(graded: GradedInspection) -> list[list[object]]:
    """Values with their uncertainties, grades and verdicts; one column for each wheel."""
    from jounce.inspection.quantities import QUANTITIES

    wheels = graded.wheels
    rows: list[list[object]] = [
        ["static load", *("–" if one.static_load is None else f"{one.static_load:.0f} N" for one in wheels)]
    ]
    for name, quantity in QUANTITIES.items():
        if any(getattr(wheel, name) is not None for wheel in wheels):
            rows.append([quantity.words(), *(_cell(wheel, quantity) for wheel in wheels)])
    methods = dict.fromkeys(method for wheel in wheels for method in wheel.grade)
    rows += [[f"grade {method}", *(wheel.grade.get(method, "–") for wheel in wheels)] for method in methods]
    return [*rows, ["verdict", *(wheel.verdict for wheel in wheels)]]


def _cell(wheel: WheelResult, quantity: Quantity) -> str:
    text, half = quantity.text(getattr(wheel, quantity.name)), wheel.uncertainty.get(quantity.name)
    return text if half is None or text == "–" else f"{text} ± {quantity.rounded_up(half)}"
