"""Measured files before they enter a campaign: what each one is, a small curve of it, and what it does not say."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Literal

import numpy as np

from jounce.campaign.from_folder import road_of
from jounce.campaign.laboratory import TrialRow, read_trials
from jounce.campaign.recogniser import RecognisedFile, number_trials, recognise_columns
from jounce.core.columns import Column, ColumnTable, names_time
from jounce.core.errors import JounceError
from jounce.core.files import state_of
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.text import without_accents
from jounce.core.types import Array
from jounce.core.units import conversion_factor, is_unit_of
from jounce.recordings.schema import quantity_of

Lack = Literal["unit", "speed", "pressure", "sign", "channel", "road"]
_BINS, _MOST_COLUMNS = 60, 40
"""Number of pairs of values in a small curve; maximum number of columns listed."""
_USUAL = {"displacement": "mm", "force": "N"}
"""Usual units of a test machine, proposed where a heading has none."""
_NAMES = {
    "displacement": ("displacement", "deflection", "stroke", "travel", "weg", "einfederung", "desloc", "curso",
                     "desplaz", "carrera", "corsa", "deplacement", "przemieszcz"),
    "force": ("force", "load", "kraft", "last", "forca", "fuerza", "carga", "forza", "effort", "sila"),
}  # fmt: skip
"""Words of headings, without accents, that name the columns of a test machine."""
_STATED = {
    "speed": (r"speed|velocity|geschwindigkeit|velocid\w*|velocita|vitesse|predkosc", "m/s"),
    "pressure": (r"pressure|reifendruck|druck|pressao|presion|pressione|cisnienie", "Pa"),
}
_SPEED = re.compile(
    r"(?i)(?<![a-z0-9])(?:v_?)?(\d+(?:[.,p]\d+)?)_?(m_?s|mps|km_?h|kmh|kph)(?![a-z0-9])"
)
"""Speed in a file name: ``run3_1.95ms``, ``v2p9mps``, ``7_km_h``."""
_FAST = {"m": "m/s", "k": "km/h"}


@dataclass(frozen=True)
class Missing:
    """Information that a file lacks: its kind, the column that it concerns, and a proposal."""

    what: Lack
    column: str = ""
    proposal: str = ""


@dataclass(frozen=True)
class FilePreview(Shown):
    """A file on its way into a campaign.

    Attributes
    ----------
    recognised : RecognisedFile
        The file and its kind.
    summary : str
        What it holds, or why it cannot be read.
    columns : tuple of dict
        Name, unit, minimum and maximum of each column.
    curve : dict
        A few values of its first signal: ``x``, ``y`` and their labels; empty if it has none.
    missing : tuple of Missing
        Information that it lacks.
    fields : dict
        Keys of its table in a campaign, as far as they are known.
    state : str
        Identifies the content: it differs once the file has changed.
    """

    recognised: RecognisedFile
    summary: str
    columns: tuple[dict[str, Any], ...] = ()
    curve: Mapping[str, Any] = field(default_factory=dict)
    missing: tuple[Missing, ...] = ()
    fields: Mapping[str, Any] = field(default_factory=dict)
    state: str = ""

    def to_dict(self) -> dict[str, Any]:
        """Return plain data."""
        item = self.recognised
        return {
            "file": str(item.file),
            "kind": item.kind,
            "doubt": item.doubt,
            "summary": self.summary,
            "columns": list(self.columns),
            "curve": dict(self.curve),
            "missing": [vars(lack) for lack in self.missing],
            "fields": dict(self.fields),
            "state": self.state,
        }


@dataclass(frozen=True)
class FilePreviews(Shown):
    """Files on their way into a campaign, with the roads of their table of trials.

    Attributes
    ----------
    files : tuple of FilePreview
        Each file.
    roads : dict
        Trains of obstacles in the table of trials, by the name that their trials use.
    """

    files: tuple[FilePreview, ...]
    roads: Mapping[str, Any] = field(default_factory=dict)

    def to_dict(self) -> dict[str, Any]:
        """Return plain data."""
        return {"files": [item.to_dict() for item in self.files], "roads": dict(self.roads)}


def preview_files(
    files: Sequence[Path | str],
    columns: Mapping[str, Mapping[str, str]] | None = None,
    rows: Sequence[TrialRow] | None = None,
) -> FilePreviews:
    r"""Recognise measured files, and list what each lacks before it can be part of a campaign.

    A file that cannot be read does not stop the others: its ``summary`` is the reason.

    Parameters
    ----------
    files : sequence of Path or str
        The files.
    columns : mapping, optional
        For each file, names and units that its headings lack: ``{"a.csv": {"force": "F [kN]"}}``.
    rows : sequence of TrialRow, optional
        Table of trials: speeds (m/s), angles (rad) and pressures (Pa) of the trials by number; by default that of the
        one table of trials among the files.

    Returns
    -------
    FilePreviews
        A preview of each file, in the given order.

    Examples
    --------
    >>> import tempfile
    >>> file = Path(tempfile.mkdtemp()) / "spring.csv"
    >>> _ = file.write_text("weg,kraft" + "".join(f"\n{x},{22 * x}" for x in range(20)))
    >>> (found,) = preview_files([file]).files
    >>> found.recognised.kind, [(lack.what, lack.column, lack.proposal) for lack in found.missing]
    ('spring', [('unit', 'weg', 'mm'), ('unit', 'kraft', 'N')])
    """
    given = columns or {}
    looked = [_look(Path(file), given.get(str(file), {})) for file in files]
    items = [item for item, _ in looked]
    tables = [item.file for item in items if item.kind == "table of trials"]
    if rows is None:
        rows = _rows_of(tables)
    by_number = {row.number: row for row in rows}
    numbered = {item.file: item for item in number_trials(items, by_number)}
    previews = [
        _preview(numbered[item.file], table, given.get(str(item.file), {}), by_number)
        for item, table in looked
    ]
    roads = {
        road_of(row): {"kind": "train", "of": "A", "count": row.count, "pitch": f"{row.pitch:g} m"}
        for row in rows
        if row.pitch is not None
    }
    return FilePreviews(tuple(previews), roads)


def _rows_of(tables: Sequence[Path]) -> list[TrialRow]:
    try:
        return read_trials(tables[0]) if len(tables) == 1 else []
    except JounceError:
        return []


def _look(file: Path, columns: Mapping[str, str]) -> tuple[RecognisedFile, ColumnTable | None]:
    """Recognise a file; any failure on it is its ``why``."""
    try:
        item, table = recognise_columns(file, None, columns)
    except JounceError as error:
        return RecognisedFile(file, "unknown", error.message()), None
    except Exception as error:  # noqa: BLE001 - readers of other packages raise anything on damaged files
        why = Phrase("cannot be read: {error}", error=f"{type(error).__name__}: {error}")
        return RecognisedFile(file, "unknown", why), None
    if table is not None and item.kind in ("unknown", "calibration"):
        machine = _machine_columns(table, columns)
        if machine:
            mended = {**machine, **columns}
            kind = _as_tested(file, mended)
            return kind or replace(item, kind="spring", columns=mended), table
    return (replace(item, columns={**item.columns, **columns}), table) if columns else (item, table)


def _machine_columns(table: ColumnTable, columns: Mapping[str, str]) -> dict[str, str]:
    """Return the columns that are named displacement and force, with their usual units where they have none."""
    found: dict[str, str] = {}
    for quantity, words in _NAMES.items():
        for column in table:
            plain = without_accents(column.name)
            if column.fault is None and any(word in plain for word in words):
                unit = "" if column.unit else f" [{_USUAL[quantity]}]"
                found.setdefault(quantity, f"{column.label}{unit}")
    is_timed = any(names_time(column.name) or is_unit_of(column.unit, "s") for column in table)
    return found if len({**found, **columns}) >= len(_NAMES) and not is_timed else {}


def _as_tested(file: Path, columns: Mapping[str, str]) -> RecognisedFile | None:
    item, _ = recognise_columns(file, None, columns)
    return replace(item, columns=dict(columns)) if item.kind in ("spring", "tyre") else None


# --- one file


def _preview(
    item: RecognisedFile,
    table: ColumnTable | None,
    given: Mapping[str, str],
    rows: Mapping[int, TrialRow],
) -> FilePreview:
    if table is None:
        return FilePreview(item, item.why, state=file_state(item.file))
    missing: list[Missing] = []
    curve, summary = _machine(item, table, given, missing) or _signal(item, table)
    if item.kind == "unknown":
        summary = item.why
    if item.kind in ("trial", "decay"):
        names = [name for name in item.columns if quantity_of(name)]
        if not names and not any(quantity_of(name) for name in item.signals):
            missing.append(Missing("channel", ", ".join(item.signals)))
        missing += [
            Missing("unit", column.name)
            for column in table
            if quantity_of(column.name) and not column.unit and column.name not in item.columns
        ]
    fields = _fields(item, table, rows)
    if item.kind == "trial" and "speed" not in fields:
        missing.append(Missing("speed"))
    row = rows.get(item.number) if item.kind == "trial" and item.number is not None else None
    if row is not None and row.taken_for_one:
        missing.append(Missing("road", row.taken_for_one))
    if item.kind == "tyre" and "pressure" not in fields:
        missing.append(Missing("pressure"))
    columns = tuple(
        {"name": column.written or column.name, "unit": column.unit, **_ends(column)}
        for column in list(table)[:_MOST_COLUMNS]
    )
    return FilePreview(item, summary, columns, curve, tuple(missing), fields, file_state(item.file))


def file_state(file: Path) -> str:
    """Identify the content of a file; empty if it is gone."""
    try:
        return "-".join(map(str, state_of(file)))
    except OSError:
        return ""


def _ends(column: Column) -> dict[str, float | None]:
    values = column.values if column.part is None else column.part[1]
    finite = values[np.isfinite(values)] if column.fault is None else values[:0]
    if not len(finite):
        return {"least": None, "greatest": None}
    return {"least": float(finite.min()), "greatest": float(finite.max())}


def _machine(
    item: RecognisedFile, table: ColumnTable, given: Mapping[str, str], missing: list[Missing]
) -> tuple[dict[str, Any], str] | None:
    """Return the curve of a test machine and its rate; add units and signs that are not stated."""
    if item.kind not in ("spring", "tyre"):
        return None
    from jounce.recordings.files import locate

    parts = []
    for quantity, si in (("displacement", "m"), ("force", "N")):
        spec = item.columns.get(quantity)
        column = (
            locate(table, spec)
            if spec is not None
            else next((c for c in table if c.unit and is_unit_of(c.unit, si)), None)
        )
        if column is None or column.fault is not None:
            return {}, item.why
        if quantity not in given and not _unit_of_heading(table, column):
            missing.append(Missing("unit", column.name, column.unit or _USUAL[quantity]))
        parts.append(column.values * conversion_factor(column.unit or _USUAL[quantity], si))
    x, force = 1e3 * parts[0], parts[1]
    rate = float(np.polyfit(parts[0], force, 1)[0]) if np.ptp(x) > 0.0 else math.nan
    if rate < 0.0:
        missing.append(Missing("sign"))
    step = max(1, len(x) // (2 * _BINS))
    curve = {
        "x": x[::step].tolist(),
        "y": force[::step].tolist(),
        "x_label": "mm",
        "y_label": "N",
    }
    return curve, Phrase("{rate:.3g} N/mm, {count} rows", rate=1e-3 * rate, count=len(x))


def _unit_of_heading(table: ColumnTable, column: Column) -> str:
    return next((one.unit for one in table if one.name == column.name), "")


def _signal(item: RecognisedFile, table: ColumnTable) -> tuple[dict[str, Any], str]:
    """Return the envelope of the first signal, and the number of signals, their length and rate."""
    column = next((c for c in table if c.name in item.signals and c.fault is None), None)
    if column is None:
        return {}, item.why
    low, high = _envelope(column.values)
    values = np.column_stack([low, high]).ravel()
    curve = {
        "x": np.repeat(np.arange(len(low), dtype=float), 2).tolist(),
        "y": values.tolist(),
        "x_label": "",
        "y_label": column.label,
    }
    count, rate, signals = len(column.values), item.rate, len(item.signals)
    numbers: dict[str, float] = {"signals": signals, "count": count}
    if rate is None:
        several = "{signals} signals, {count} rows"
        return curve, Phrase("1 signal, {count} rows" if signals == 1 else several, **numbers)
    several = "{signals} signals, {duration:.3g} s at {rate:.4g} Hz"
    single = "1 signal, {duration:.3g} s at {rate:.4g} Hz"
    numbers |= {"duration": (count - 1) / rate, "rate": rate}
    return curve, Phrase(single if signals == 1 else several, **numbers)


def _envelope(values: Array) -> tuple[Array, Array]:
    """Return minimum and maximum of each bin; 0 for a bin without a finite value."""
    bins = np.array_split(np.nan_to_num(values, posinf=0.0, neginf=0.0), min(_BINS, len(values)))
    return np.array([part.min() for part in bins]), np.array([part.max() for part in bins])


def _fields(
    item: RecognisedFile, table: ColumnTable, rows: Mapping[int, TrialRow]
) -> dict[str, Any]:
    """Return the keys of a file's table in a campaign, from the table of trials, its name and its comments."""
    fields: dict[str, Any] = {}
    stated = without_accents(" ".join(table.comments))
    columns = {**item.columns, **({"time": item.time} if item.time else {})}
    columns.pop("pulses", None)
    if columns:
        fields["columns"] = columns
    if item.sample_time is not None:
        fields["sample_time"] = f"{item.sample_time:.6g} s"
    pressure = item.pressure or _stated("pressure", stated)
    if item.kind == "tyre" and pressure:
        fields["pressure"] = f"{1e-6 * pressure:g} MPa"
    if item.kind == "decay":
        channel = next((name for name in (*item.columns, *item.signals) if quantity_of(name)), "")
        if channel and channel != "sprung.z":
            fields["channel"] = channel
    if item.kind != "trial":
        return fields
    row = rows.get(item.number) if item.number is not None else None
    if item.number is not None:
        fields["number"] = item.number
    speed = row.speed if row is not None else _speed_in(item.file.stem) or _stated("speed", stated)
    pressure = row.pressure if row is not None and row.pressure is not None else pressure
    if speed is not None:
        fields["speed"] = f"{speed:g} m/s"
    if pressure:
        fields["tyre_pressure"] = f"{1e-6 * pressure:g} MPa"
    return fields if row is None else {**fields, "road": road_of(row), **fields_of(row)}


def fields_of(row: TrialRow) -> dict[str, str]:
    """Return speed, pressure and angle of a row in a table of trials, as a campaign writes them."""
    fields = {}
    if row.speed is not None:
        fields["speed"] = f"{row.speed:g} m/s"
    if row.pressure is not None:
        fields["tyre_pressure"] = f"{1e-6 * row.pressure:g} MPa"
    if row.angle is not None:
        fields["strut_angle"] = f"{math.degrees(row.angle):g} deg"
    return fields


def _stated(quantity: str, comments: str) -> float | None:
    """Return a speed (m/s) or a pressure (Pa) with its unit in the comments of a file."""
    words, si = _STATED[quantity]
    for match in re.finditer(
        rf"(?:{words})\W{{0,5}}(\d+(?:[.,]\d+)?)\s*([a-z]+(?:/[a-z]+)?)", comments
    ):
        unit = {"mpa": "MPa", "kpa": "kPa", "pa": "Pa"}.get(match[2], match[2])
        if is_unit_of(unit, si):
            return float(match[1].replace(",", ".")) * conversion_factor(unit, si)
    return None


def _speed_in(stem: str) -> float | None:
    match = _SPEED.search(stem)
    if match is None:
        return None
    number = float(match[1].replace(",", ".").replace("p", ".").replace("P", "."))
    return number * conversion_factor(_FAST[match[2][0].lower()], "m/s")
