"""Records of testers: plate height and plate force of one or two wheels, and the lane's notes on the car."""

from __future__ import annotations

import datetime
import re
import tomllib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.columns import read_comments_csv
from jounce.core.description import description_text, toml_error, toml_table
from jounce.core.errors import DescriptionError, RecordingError, nearest, nearest_name
from jounce.core.files import existing_file
from jounce.core.findings import Finding
from jounce.core.phrases import Phrase
from jounce.core.units import to_si
from jounce.inspection.findings import remark

if TYPE_CHECKING:
    import xarray as xr

    from jounce.parts.testers import Tester

SIDES = ("left", "right")
FORCE, HEIGHT, TACHO = "plate.force", "plate.z", "plate.frequency"
NUMBERS = {"static_load": "N", "plate_mass": "kg", "tyre_pressure": "Pa"}
"""Header keys of each wheel (``left.static_load``), with their SI units."""
TEXTS = (
    "axle",
    "wheel_order",
    "tester",
    "vehicle",
    "plate_number",
    "date",
    "place",
    "operator",
    "comment",
    "simulated",
)
"""Header keys of the whole record."""
_ORDERS = {"left, right", "right, left", "left", "right", "together"}
_LONGEST_TEXT, _LARGEST_NAME = (
    2000,
    1e15,
)  # characters; of numbers used as names, written with all digits


def read_record(path: Path | str, tester: Tester | None = None) -> tuple[xr.Dataset, list[Finding]]:
    r"""Read a record of a tester with its header.

    Parameters
    ----------
    path : Path or str
        File of any known format, e.g. CSV with ``time [s], left.plate.z [mm], left.plate.force [N], ...``. What is
        known about the car is given in lines ``# left.static_load = "4316 N"`` before the columns, or in a TOML file of
        the same name in the same directory; the lines take precedence.
    tester : Tester, optional
        Tester whose ``columns``, ``variable``, ``sample_time`` and ``resample`` define how its files are read.

    Returns
    -------
    record : xarray.Dataset
        Plate heights (m) and forces (N) on ``time`` (s); header entries as attributes, in SI.
    findings : list of Finding
        Omitted columns, resampled channels and misspelt keys.

    Raises
    ------
    RecordingError
        For an unreadable or invalid file: missing columns, NaN, clock jitter, no wheel.
    DescriptionError
        For a header with a wrong unit or value, or columns with a wrong unit.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "lane.csv"
    >>> rows = "\n".join(f"{i / 1000}, {i % 7 - 3}, {4000 + i % 5}" for i in range(20))
    >>> _ = file.write_text(f'# left.static_load = "4.3 kN"\ntime [s], left.plate.z [mm], left.plate.force [N]\n{rows}')
    >>> record, findings = read_record(file)
    >>> record.attrs["left.static_load"], list(record), findings
    (4300.0, ['left.plate.z', 'left.plate.force'], [])
    """
    from jounce.recordings.files import read_recording

    file = existing_file(path, RecordingError)
    options: dict[str, Any] = {}
    if tester is not None:
        options = {"columns": dict(tester.columns) or None, "variable": tester.variable}
        options |= {"sample_time": tester.sample_time, "resample": tester.resample}
    header, findings = _header(file)
    try:
        dataset, reader_findings = read_recording(file, **options)
    except DescriptionError as error:
        raise _unit_error(error) from None
    except RecordingError as error:
        raise _column_error(error) from None
    _check_units(reader_findings, file)
    facts, header_findings = read_facts({**dict(dataset.attrs), **header}, where=str(file))
    dataset.attrs = facts
    wheels_of(dataset, where=str(file))
    return dataset, [*findings, *reader_findings, *header_findings]


def missing_plates(path: Path | str) -> Phrase | None:
    """Return why a file can be no tester record, from its head alone; None if it may be one.

    Texts and files with plain names are judged; what hides its names, such as a compressed file, may be one.
    """
    file = Path(path)
    with file.open("rb") as stream:
        head = stream.read(_HEAD)
    if FORCE.encode() in head:
        return None
    if file.suffix.lower() not in _TABLES:
        is_whole = len(head) < _HEAD
        return _NO_PLATES if is_whole and file.suffix.lower() in _PLAIN else None
    lines = (line.strip() for line in head.decode("utf-8", "replace").splitlines())
    first = next((line for line in lines if line and not line.startswith("#")), "")
    shown = first if len(first) <= _SHOWN else f"{first[:_SHOWN]}…"
    return Phrase("no plate force in its first line: {first}", first=shown) if first else _NO_PLATES


_HEAD, _SHOWN = 1 << 16, 60  # bytes that are looked at; characters of a first line that are shown
_TABLES, _PLAIN = (".csv", ".tsv", ".txt", ".dat"), (".nc", ".nc4", ".ld", ".vbo", ".rsp", ".sst")
_NO_PLATES = Phrase("it names no plate force")


def _check_units(findings: Iterable[Finding], file: Path) -> None:
    """Raise an error for plate heights and forces that the reader omitted because they have no unit."""
    said = [
        str(item.numbers["labels"]) for item in findings if item.code == "recordings.without_unit"
    ]
    for name in (f"{side}.{what}" for side in SIDES for what in (HEIGHT, FORCE)):
        if any(f"{name} = " in text for text in said):
            where, allowed = f"{file}: column {name!r}", "a header such as 'left.plate.z [mm]'"
            hint = f'Write it into the header, or into the tester\'s [columns]: "{name}" = "{name} [UNIT]".'
            raise RecordingError("the column has no unit", where=where, allowed=allowed, hint=hint)


def _header(file: Path) -> tuple[dict[str, Any], list[Finding]]:
    """Read the entries of the accompanying TOML file and of the header lines."""
    from jounce.recordings.readers import reader_of

    facts: dict[str, Any] = {}
    findings: list[Finding] = []
    beside = file.with_suffix(".toml")
    if beside.is_file() and beside != file:
        try:
            facts |= flat_facts(toml_table(description_text(beside)))
        except tomllib.TOMLDecodeError as error:
            raise toml_error(error, str(beside)) from None
        except UnicodeDecodeError as error:
            raise DescriptionError(
                Phrase("not valid TOML: {error}", error=str(error)), where=str(beside)
            ) from None
    if file.is_file() and reader_of(file).name == "csv":
        for line in read_comments_csv(file):
            if "=" not in line:
                continue
            try:
                facts |= flat_facts(toml_table(line))
            except tomllib.TOMLDecodeError:
                findings.append(remark(str(file), "warning", "line_left_out", line=line))
    return facts, findings


def flat_facts(table: Mapping[str, Any], before: str = "") -> dict[str, Any]:
    """Flatten a header's tables, e.g. ``{"left": {"static_load": "4 kN"}}``, to dotted names."""
    flat: dict[str, Any] = {}
    for key, value in table.items():
        flat |= (
            flat_facts(value, f"{before}{key}.")
            if isinstance(value, Mapping)
            else {f"{before}{key}": value}
        )
    return flat


def read_facts(
    facts: Mapping[str, Any], *, where: str = "record"
) -> tuple[dict[str, Any], list[Finding]]:
    """Check the header entries (see ``NUMBERS`` and ``TEXTS``) and convert numbers and texts with units to SI.

    Returns the entries, and a warning for each unknown key, which is kept. Raises DescriptionError for a value with a
    wrong unit or out of range; ``where`` is the location named in errors.
    """
    checked: dict[str, Any] = {}
    findings: list[Finding] = []
    known = [*TEXTS, *(f"{side}.{name}" for side in SIDES for name in NUMBERS)]
    for key, value in facts.items():
        side, _, name = key.partition(".")
        if side in SIDES and name in NUMBERS:
            checked[key] = _number(value, NUMBERS[name], f"{where}: {key}")
        elif key == "wheel_order":
            checked[key] = _order(value, where)
        elif key == "axle":
            checked[key] = _axle(value, where)
        else:
            checked[key] = _text(value, f"{where}: {key}") if key in TEXTS else str(value)
            if key == "date" and checked[key] and not _is_day(checked[key]):
                findings.append(remark(where, "warning", "not_a_date", date=checked[key]))
            if key not in TEXTS and key not in ("schema", "jounce", "source", "Conventions"):
                near = nearest_name(key, known)
                code = "unknown_key_near" if near else "unknown_key"
                findings.append(
                    remark(where, "warning" if near else "note", code, key=key, near=near)
                )
    return checked, findings


def _text(value: object, where: str) -> str:
    """Return the text of an entry about the record; also accepts numbers and TOML dates."""
    plain = value.item() if isinstance(value, np.generic) else value
    if isinstance(plain, (datetime.date, datetime.time)):
        return plain.isoformat()
    is_number = (
        isinstance(plain, (int, float)) and abs(plain) < _LARGEST_NAME
    )  # NaN is not below it
    text = str(plain) if is_number or isinstance(plain, str) else None
    if text is None or len(text) > _LONGEST_TEXT or "\0" in text:
        allowed = Phrase(
            "text of at most {longest_text} characters, or a date", longest_text=_LONGEST_TEXT
        )
        raise DescriptionError("not a text", where=where, found=value, allowed=allowed)
    return text


def day_of(text: str) -> str:
    """Convert a date to an ISO 8601 day; other text is returned unchanged.

    Examples
    --------
    >>> day_of("21.11.2026"), day_of("2026-11-21T08:30:00"), day_of("soon")
    ('2026-11-21', '2026-11-21', 'soon')
    """
    german = re.match(r"\s*(\d{1,2})\.(\d{1,2})\.(\d{4})", text)
    iso = f"{german[3]}-{int(german[2]):02}-{int(german[1]):02}" if german else text.strip()[:10]
    try:
        return datetime.date.fromisoformat(iso).isoformat()
    except ValueError:
        return text


def _is_day(text: str) -> bool:
    try:
        datetime.date.fromisoformat(day_of(text))
    except ValueError:
        return False
    return True


def _number(value: object, si: str, where: str) -> float:
    try:
        number = to_si(value, si, where=where)
    except DescriptionError as error:
        raise _unit_error(error) if si == "N" else error from None
    if number < 0.0 or (si != "kg" and number == 0.0):
        raise DescriptionError(
            "out of range", where=where, found=f"{number:g} {si}", allowed="above 0"
        )
    return number


def _order(value: object, where: str) -> str:
    words = (
        [str(word).strip() for word in value]
        if isinstance(value, (list, tuple))
        else str(value).split(",")
    )
    order = ", ".join(word.strip() for word in words)
    if order not in _ORDERS:
        raise DescriptionError(
            "unknown order of the wheels",
            where=f"{where}: wheel_order",
            found=order,
            allowed=" | ".join(sorted(_ORDERS)),
        )
    return order


def _axle(value: object, where: str) -> str:
    if str(value) not in ("front", "rear"):
        raise DescriptionError(
            "unknown axle", where=f"{where}: axle", found=str(value), allowed="front, rear"
        )
    return str(value)


def _unit_error(error: DescriptionError) -> DescriptionError:
    """Add a hint about pounds or kilograms in a force column."""
    words = {"lb": "lbf", "lbs": "lbf", "pound": "lbf", "kg": "kgf"}
    unit = str(error.found or "")
    hint = error.hint
    if unit in words and "convert" in error.allowed:
        hint = Phrase(
            "{unit!r} is a mass; write {words!r} for the force.", unit=unit, words=words[unit]
        )
    return DescriptionError(
        error.what, where=error.where, found=error.found, allowed=error.allowed, hint=hint
    )


def _column_error(error: RecordingError) -> RecordingError:
    """Add a hint about where to define a tester's column names."""
    if not error.what.startswith("no column"):
        return error
    hint = 'Define its name in the tester file, [columns]: time = "Zeit [s]", "left.plate.z" = "s_left [mm]", ...'
    return RecordingError(
        error.what, where=error.where, found=error.found, allowed=error.allowed, hint=hint
    )


def is_simulated(facts: Mapping[str, Any]) -> bool:
    """Whether a record is marked as simulated in its header or, for older records, in a comment."""
    return bool(facts.get("simulated")) or str(facts.get("comment", "")).startswith(
        "simulated, seed"
    )


def with_facts(
    record: xr.Dataset, given: Mapping[str, str], *, where: str = "record"
) -> tuple[xr.Dataset, list[Finding]]:
    """Replace header entries of a test, e.g. its ``date`` or ``plate_number``.

    Returns the record, and a warning for each header entry that was replaced. Raises DescriptionError for an invalid
    date.
    """
    if "date" in given and not _is_day(given["date"]):
        raise DescriptionError(
            "not a date", where="date", found=given["date"], allowed="e.g. 2026-11-21"
        )
    findings: list[Finding] = [
        remark(where, "warning", "overruled", key=key, header=str(record.attrs[key]), given=text)
        for key, text in given.items()
        if str(record.attrs.get(key) or text) != text
    ]
    return record.assign_attrs(given), findings


def wheels_of(record: xr.Dataset, *, where: str = "record") -> tuple[str, ...]:
    """Return the wheels of a record that have a plate force, ``"left"`` before ``"right"``.

    Raises
    ------
    RecordingError
        If the record has no plate force.
    """
    names = [str(name) for name in record.data_vars]
    sides = tuple(side for side in SIDES if f"{side}.{FORCE}" in names)
    if not sides:
        raise RecordingError(
            "the record has no plate force",
            where=where,
            found=", ".join(names) or "no channel",
            allowed="left.plate.force and right.plate.force, or one of them",
            hint=_near_channel(names) or "Map the columns in the tester's [columns].",
        )
    return sides


def _near_channel(names: Iterable[str]) -> str:
    wanted = [f"{side}.{FORCE}" for side in SIDES]
    return next((hint for hint in (nearest(name, wanted) for name in names) if hint), "")
