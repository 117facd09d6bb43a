"""Inspection records of a vehicle: evaluation, grading, protocols, and storage."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, closing, nullcontext
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from jounce.core.errors import DescriptionError, RecordingError, is_of_system, unknown
from jounce.core.files import existing_file
from jounce.core.findings import DrawingError, Finding
from jounce.core.operation import Mark, Switch, Texts, operation
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.inspection.archive.entries import Grading, RecordEntry, pack
from jounce.inspection.archive.lane import (
    LIMITS,
    InspectedRecord,
    check_methods,
    entry_of,
    grading_of,
    inspect_record,
    refusal_of,
    stored_tester,
)
from jounce.inspection.grading import VehicleGrade, grade_vehicle
from jounce.inspection.limits import Limits, load_limits
from jounce.inspection.quantities import LANGUAGES, Language
from jounce.inspection.record import read_record, with_facts
from jounce.parts import load
from jounce.parts.testers import Tester, as_tester
from jounce.report.inspection import inspection_page
from jounce.report.page import Page, Paragraph, Section
from jounce.report.protocol import check_protocol, facts_of, write_protocol

if TYPE_CHECKING:
    from jounce.inspection.archive.store import Store

_AXLES = ("front", "rear")
PROTOCOLS = Texts(
    "Write a protocol (.pdf or .html), with its values as .json; CAR.pdf,html writes both. Repeat it.",
    "FILE",
)
LANGUAGE = Mark("Language of the protocol: en or de.")
STORE = Mark("The store: a SQLite file, or a database URL.", "STORE")


@dataclass(frozen=True)
class EvaluatedVehicle(Shown):
    """The records of one vehicle, evaluated and graded.

    Attributes
    ----------
    graded : VehicleGrade
        Values of the wheels (SI), grades, verdicts and reasons.
    records : tuple of InspectedRecord
        One record per axle, in the order given.
    protocols : tuple of Path
        Files written.
    store : str
        Store that holds the records; empty if not stored.
    numbers : tuple of int
        Numbers of the records in the store.
    missing : tuple of Finding
        Figures that could not be drawn.
    """

    graded: VehicleGrade
    records: tuple[InspectedRecord, ...]
    protocols: tuple[Path, ...] = ()
    store: str = ""
    numbers: tuple[int, ...] = ()
    missing: tuple[Finding, ...] = ()

    def __str__(self) -> str:
        return "\n\n".join(map(str, self.graded.axles))

    @property
    def title(self) -> str:
        """Return the names of the records."""
        return ", ".join(str(record.path) for record in self.records)

    @property
    def refusal(self) -> RecordingError | None:
        """Return the first reason why a wheel is not graded, as an error; ``None`` if all are graded."""
        for record in self.records:
            for grade in record.graded.grades:
                if grade.verdict == "not graded":
                    reason = grade.reasons[0].text() if grade.reasons else "nothing is known"
                    what = Phrase(
                        "the {wheel} wheel cannot be graded: {reason}",
                        wheel=grade.wheel,
                        reason=reason.removesuffix("."),
                    )
                    return RecordingError(what, where=str(record.path))
        return None

    @property
    def problems(self) -> tuple[str, ...]:
        """Return the reason why a wheel is not graded."""
        return (str(self.refusal),) if self.refusal else ()

    def to_dict(self) -> dict[str, Any]:
        """Return a single axle unchanged; merge the wheels of two axles into one list, each with its axle."""
        plain = self._one_axle() if len(self.graded.axles) == 1 else self._both_axles()
        plain["protocol"] = list(dict.fromkeys(map(str, self.protocols)))
        plain["store"] = (
            {"location": self.store, "records": list(self.numbers)} if self.store else None
        )
        if error := self.refusal:
            plain["error"] = {
                "kind": type(error).__name__,
                "message": str(error),
                "where": error.where,
            }
            plain["error"]["what"] = error.what
        return plain

    def _one_axle(self) -> dict[str, Any]:
        (axle,), (record, *_) = self.graded.axles, self.records
        return {"record": str(record.path), **axle.to_dict(), "vehicle": self.graded.summary()}

    def _both_axles(self) -> dict[str, Any]:
        axles = [graded.to_dict() for graded in self.graded.axles]
        names = [graded.axle for graded in self.graded.axles]
        return {
            "records": [str(record.path) for record in self.records],
            "wheels": [
                {"axle": name, **wheel}
                for name, axle in zip(names, axles, strict=True)
                for wheel in axle["wheels"]
            ],
            "axles": [
                {**axle["axle"], "facts": axle["facts"], "findings": axle["findings"]}
                for axle in axles
            ],
            "deciding": axles[0]["deciding"],
            "limits": axles[0]["limits"],
            "vehicle": self.graded.summary(),
            "verdict": self.graded.verdict,
        }


@operation(
    "inspect evaluate",
    named={"records": "record", "methods": "method", "reports": "report"},
    faces={"method": None, "report": None},
    page="jounce.report.inspected:evaluated_page",
    title="{result.title}",
    doing="evaluating",
    example="jounce inspect evaluate front.csv rear.csv --tester egea-specsus2018 --report car.pdf",
    note=(
        "--date, --place, --plate and --inspector override the header, in the store as well. A "
        "record that cannot be graded is stored with the reasons, never graded by guess; the exit code is then 2."
    ),
)
def evaluate_inspection(  # noqa: PLR0913 - each is an option
    records: Annotated[
        Sequence[Path | str],
        Texts("Record of one axle (CSV, netCDF, ...), or one of each axle.", "RECORD..."),
    ],
    tester: Annotated[
        Tester | Path | str,
        Mark("A tester file, or the name of a shipped one (eusama, egea-specsus2018, ...)."),
    ],
    *,
    vehicle: Annotated[
        Path | str | None,
        Mark("Vehicle file or name; its weight is compared with the static loads."),
    ] = None,
    methods: Annotated[
        Sequence[str],
        Texts(
            "Deciding method: eusama, egea, theta or boge; by default that of the tester. Repeat it."
        ),
    ] = (),
    limits: Annotated[Path | str | None, LIMITS] = None,
    reports: Annotated[Sequence[Path | str], PROTOCOLS] = (),
    store: Annotated[
        Path | str | None,
        Mark("Store record and result: a SQLite file (created if missing), or a database URL."),
    ] = None,
    language: Annotated[Language, LANGUAGE] = "en",
    date: Annotated[str | None, Mark("Day of the test, e.g. 2026-11-21.")] = None,
    place: Annotated[str | None, Mark("Location of the test.")] = None,
    plate: Annotated[str | None, Mark("Number plate of the vehicle.")] = None,
    inspector: Annotated[str | None, Mark("Person who made the test.")] = None,
    force: Annotated[bool, Switch("Overwrite existing output.")] = False,
    progress: Callable[[str], None] = lambda _: None,
) -> EvaluatedVehicle:
    """Evaluate and grade the records of one or both axles, write the protocol, and store both.

    A given date, place, plate or inspector overrides the header, in the store as well. A record that cannot be graded
    is stored with the reasons; missing values are never guessed.

    Parameters
    ----------
    records : sequence of Path or str
        Record of one axle, or one of each axle.
    tester : Tester, Path or str
        Tester used: its description, file or shipped name.
    vehicle : Path or str, optional
        File or name of the vehicle; its weight is compared with the static loads.
    methods : sequence of {"eusama", "egea", "theta", "boge"}
        Deciding methods; by default that of the tester.
    limits : Path or str, optional
        Limits file; by default the shipped limits.
    reports : sequence of Path or str
        Protocols to write, ``.pdf`` or ``.html``; ``car.pdf,html`` writes both formats. The values are written to a
        ``.json`` file of the same name.
    store : Path or str, optional
        SQLite file (created if missing), or a database URL.
    language : {"en", "de"}
        Language of the protocols.
    date : str, optional
        Date of the test, such as ``2026-11-21``.
    place : str, optional
        Location of the test.
    plate : str, optional
        Number plate of the vehicle.
    inspector : str, optional
        Person who made the test.
    force : bool
        Overwrite existing protocols.
    progress : callable
        Called with a one-line message at each stage.

    Returns
    -------
    EvaluatedVehicle
        Values, grades and verdicts, and the files written.

    Raises
    ------
    RecordingError
        If a record cannot be read; with a store, it is stored with the reason.
    DescriptionError
        If the tester, a method, the limits or a header's text does not match the records.
    OutputError
        If a protocol exists and ``force`` is not given; nothing is evaluated then.

    Examples
    --------
    >>> import tempfile
    >>> import jounce as jn
    >>> from jounce.testers.testing import write_test
    >>> _, record = jn.simulate_axle(jn.load("audi-a6-full-car"), "egea-specsus2018")
    >>> file = Path(tempfile.mkdtemp()) / "front.csv"
    >>> _ = write_test(record, file)
    >>> evaluate_inspection([file], "egea-specsus2018", place="Kempten").graded.verdict
    'pass'
    """
    protocols = _checked_protocols(records, reports, language, force=force)
    paths = [existing_file(file, RecordingError) for file in records]
    deciding = check_methods(methods)
    chosen, under_test = as_tester(tester), None if vehicle is None else load(vehicle)
    name = "" if vehicle is None else Path(vehicle).stem
    facts = {"date": date, "place": place, "plate_number": plate, "operator": inspector}
    asked = _Asked(
        {"tester": chosen, "vehicle": under_test, "methods": deciding}, load_limits(limits),
        {key: text for key, text in facts.items() if text is not None}, name,
    )  # fmt: skip
    inspected, numbers = [], []
    with _opened(store) as opened:
        for file in paths:
            progress(Phrase("evaluating {name}", name=file.name))
            found, number = _inspected(file, asked, opened)
            inspected.append(found)
            numbers += [] if number is None else [number]
    whole = grade_vehicle([found.graded for found in inspected])
    digests = [sha256(found.path.read_bytes()).hexdigest()[:12] for found in inspected]
    about = {"vehicle": name, "tester": chosen.name, **facts_of(whole)}
    written, missing = _write_protocols(
        whole, inspected, digests, protocols, about, language, force=force
    )
    location = "" if opened is None else opened.location
    return EvaluatedVehicle(whole, tuple(inspected), written, location, tuple(numbers), missing)


@operation(
    "inspect protocol",
    named={"records": "record", "reports": "report"},
    faces={"report": None},
    page="jounce.report.inspected:evaluated_page",
    title="{result.title}",
    doing="reading the store",
    example="jounce inspect protocol 1 2 --store lane.sqlite --report car.pdf",
)
def open_inspection(
    records: Annotated[
        Sequence[int | str],
        Texts("Number of the record of one axle in the store, or of each axle.", "RECORD..."),
    ],
    store: Annotated[Path | str, STORE],
    *,
    limits: Annotated[Path | str | None, LIMITS] = None,
    reports: Annotated[Sequence[Path | str], PROTOCOLS] = (),
    language: Annotated[Language, LANGUAGE] = "en",
    force: Annotated[bool, Switch("Overwrite existing output.")] = False,
) -> EvaluatedVehicle:
    """Open the protocol of stored records again: with their signals, tester, vehicle, methods and facts.

    The store is not changed. Records whose newest grading differs, because other limits applied, are refused.

    Parameters
    ----------
    records : sequence of int or str
        Number of the record of one axle, or of each axle, as in ``inspect search``.
    store : Path or str
        SQLite file, or a database URL.
    limits : Path or str, optional
        Limits file of the stored grading; by default the shipped limits.
    reports : sequence of Path or str
        Protocols to write, as for :func:`evaluate_inspection`.
    language : {"en", "de"}
        Language of the protocols.
    force : bool
        Overwrite existing protocols.

    Returns
    -------
    EvaluatedVehicle
        Values, grades and verdicts as stored, and the files written.

    Raises
    ------
    RecordingError
        If the store or a record does not exist, cannot be read, or was graded otherwise.
    DescriptionError
        If a number or the limits are invalid.
    OutputError
        If a protocol exists and ``force`` is not given.

    Examples
    --------
    >>> import tempfile
    >>> import jounce as jn
    >>> from jounce.testers.testing import write_test
    >>> _, record = jn.simulate_axle(jn.load("audi-a6-full-car"), "egea-specsus2018")
    >>> folder = Path(tempfile.mkdtemp())
    >>> _ = write_test(record, folder / "front.csv")
    >>> first = evaluate_inspection(
    ...     [folder / "front.csv"], "egea-specsus2018", store=folder / "lane.sqlite"
    ... )
    >>> again = open_inspection(first.numbers, folder / "lane.sqlite", reports=[folder / "car.html"])
    >>> again.graded.verdict == first.graded.verdict, (folder / "car.html").is_file()
    (True, True)
    """
    from jounce.inspection.archive.store import Store

    numbers = [_number(text) for text in records]
    protocols = _checked_protocols(numbers, reports, language, force=force)
    with closing(Store(store, read_only=True)) as opened:
        applied = load_limits(limits)
        found = [_reopened(opened, number, applied) for number in numbers]
        entries = [opened.entry(number) for number in numbers]
        digests = [sha256(opened.content(number)[0]).hexdigest()[:12] for number in numbers]
        location = opened.location
    first, whole = entries[0], grade_vehicle([record.graded for record in found])
    known = {"vehicle": first.vehicle, "plate_number": first.plate, "date": first.date}
    about = {"tester": first.tester, **facts_of(whole), **{k: v for k, v in known.items() if v}}
    written, missing = _write_protocols(
        whole, found, digests, protocols, about, language, force=force
    )
    return EvaluatedVehicle(whole, tuple(found), written, location, tuple(numbers), missing)


def _number(text: int | str) -> int:
    try:
        return int(text)
    except ValueError:
        raise DescriptionError(
            "not the number of a record", where="records", found=text, allowed="see: inspect search"
        ) from None


def _reopened(store: Store, number: int, limits: Limits) -> InspectedRecord:
    """Evaluate a stored record as it was; one that was graded otherwise is refused."""
    from jounce.inspection.archive.reevaluation import stored_signals, stored_vehicle

    entry, stored = store.entry(number), store.newest_grading(number)
    tester = stored_tester(entry)
    read = stored_signals(store, number, entry, tester)
    found = inspect_record(
        entry.name, tester, stored_vehicle(entry), entry.methods or None, limits, read=read
    )
    now = (found.graded.verdict, limits.label)
    if stored is not None and (stored.verdict, stored.limits) != now:
        raise RecordingError(
            "the stored grading differs",
            where=f"{store.location}, record {number}",
            found=Phrase("{verdict} under {limits}", verdict=stored.verdict, limits=stored.limits),
            allowed=Phrase("{verdict} under {limits}", verdict=now[0], limits=now[1]),
            hint="Give the limits of that grading, or grade the store again: inspect reevaluate.",
        )
    return found


def _checked_protocols(
    records: Sequence[object], reports: Sequence[Path | str], language: str, *, force: bool
) -> list[Path]:
    """Check in advance what cannot be written; return the files of all protocols."""
    if not 1 <= len(records) <= len(_AXLES):
        what = "too many records" if records else "no record"
        raise DescriptionError(what, where="records", found=len(records), allowed="one per axle")
    if language not in LANGUAGES:
        raise unknown(language, LANGUAGES, what="language", where="language")
    protocols = [file for given in reports for file in _formats_of(Path(given))]
    for file in protocols:
        check_protocol(file, force=force)
    if len(set(protocols)) < len(protocols):
        raise DescriptionError("the same protocol is given twice", where="reports")
    return protocols


def _write_protocols(
    vehicle: VehicleGrade,
    records: Sequence[InspectedRecord],
    digests: Sequence[str],
    files: Sequence[Path],
    about: dict[str, str],
    language: Language,
    *,
    force: bool,
) -> tuple[tuple[Path, ...], tuple[Finding, ...]]:
    """Write the protocols; return the files, and the figures that could not be drawn."""
    about["record"] = ", ".join(
        f"{found.path.name} (sha256 {digest})"
        for found, digest in zip(records, digests, strict=True)
    )
    signals = {found.graded.axle: found.record for found in records}
    written: list[Path] = []
    missing: list[Finding] = []
    for file in files:
        is_allowed = force or file is not files[0]  # all protocols share one JSON file
        try:
            written += write_protocol(
                vehicle, file, records=signals, language=language, about=about, force=is_allowed
            )
        except DrawingError as error:
            written.append(file.with_suffix(".json"))
            missing += error.findings
    return tuple(written), tuple(missing)


@dataclass(frozen=True)
class _Asked:
    """Settings for the evaluation of records, and the facts given about the test."""

    task: Mapping[str, Any]
    limits: Any
    facts: Mapping[str, str]
    vehicle: str


def _formats_of(file: Path) -> list[Path]:
    """Expand a name with several suffixes: ``car.pdf,html`` is ``car.pdf`` and ``car.html``."""
    first, *others = file.name.split(",")
    if not others or any(not suffix.isalnum() for suffix in others):
        return [file]
    return [
        file.with_name(first),
        *(file.with_name(first).with_suffix(f".{suffix}") for suffix in others),
    ]


def _inspected(
    file: Path, asked: _Asked, store: Store | None
) -> tuple[InspectedRecord, int | None]:
    """Read, evaluate, grade and store one record; an unreadable record is stored before the error is raised.

    The vehicle's name is used if the header contains none.
    """
    read, task = None, asked.task
    try:
        record, findings = read_record(file, task["tester"])
        record, overruled = with_facts(record, dict(asked.facts), where=str(file))
        read = (record, [*findings, *overruled])
        found = inspect_record(
            file, task["tester"], task["vehicle"], task["methods"], asked.limits, read=read
        )
    except Exception as error:
        if is_of_system(error):  # the record was not examined: this is not a verdict
            raise
        # a description that does not match a readable record is a wrong request, not a property of the record
        if store is not None and not (read is not None and isinstance(error, DescriptionError)):
            _store(store, entry_of(file, asked.facts, **task), refusal_of(error, asked.limits))
        raise
    if store is None:
        return found, None
    entry = entry_of(file, {"vehicle": asked.vehicle, **asked.facts, **found.facts}, **task)
    return found, _store(store, replace(entry, signals=pack(*read)), grading_of(found.graded))


def _opened(store: Path | str | None) -> AbstractContextManager[Store | None]:
    """Return a store that is closed after use; none needs no database package."""
    if store is None:
        return nullcontext()
    from jounce.inspection.archive.store import Store

    return closing(Store(store))


def _store(store: Store, entry: RecordEntry, grading: Grading) -> int:
    """Add a record to the store; a record already stored gets an additional grading."""
    number, is_new = store.accept(entry, grading)
    if not is_new:
        store.add_gradings([(number, grading)])
    return number


def evaluated_page(found: EvaluatedVehicle, *, title: str) -> Page:
    """Create a page of the graded axles of a vehicle and the files written."""
    page = inspection_page(found.graded, title=title)
    lines = [f"written: {file}" for file in dict.fromkeys(map(str, found.protocols))]
    if found.store:
        lines.append(f"stored: {found.store}, record {', '.join(map(str, found.numbers))}")
    written = Section("Written", tuple(Paragraph(line) for line in lines))
    return replace(page, sections=(*page.sections, written)) if lines else page
