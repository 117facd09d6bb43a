"""What a file of a laboratory is: test of a spring or tyre, free decay, trial, calibration, table of trials, settings.

By its columns, their units and the shape of what they hold; names of files add what columns cannot tell.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import numpy as np

from jounce.campaign.laboratory import Laboratory, read_trials
from jounce.core.columns import ColumnTable
from jounce.core.errors import JounceError, RecordingError
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import conversion_factor, is_unit_of
from jounce.recordings.pulses import FEWEST_PULSES, edges
from jounce.recordings.reader import ReaderOptions
from jounce.recordings.readers import READERS, read_signals

Kind = Literal["spring", "tyre", "decay", "trial", "calibration", "table of trials", "settings", "unknown"]
_FEW_ROWS = 60
"""Rows: by hand nobody writes more, and no trial has fewer."""
_STIFF = 60e3
"""N/m: springs of small cars and karts are softer, tyres stiffer; bicycle springs lie about there, so it is said."""
_WORDS: dict[Kind, tuple[str, ...]] = {
    "spring": ("spring", "mola", "feder", "resorte", "molla", "ressort"),
    "tyre": ("tyre", "tire", "pneu", "reifen", "neumatico", "gomma"),
}
_FALLS = 0.5
"""Share of the first quarter's motion that is left in the last one of a free decay, at most."""


@dataclass(frozen=True)
class RecognisedFile(Shown):
    """A file and what it seems to be.

    Attributes
    ----------
    file : Path
        The file.
    kind : str
        ``spring``, ``tyre``, ``decay``, ``trial``, ``calibration``, ``table of trials``, ``settings`` or ``unknown``.
    why : str
        What tells it.
    columns : dict
        Names of a campaign to the columns of the file, where they differ.
    number : int or None
        Number of a trial, of its name.
    pressure : float or None
        Pressure that its name says, Pa.
    doubt : str
        What else it could be; empty where nothing.
    """

    file: Path
    kind: Kind
    why: str
    columns: dict[str, str] = field(default_factory=dict)
    number: int | None = None
    pressure: float | None = None
    doubt: str = ""


def recognise(folder: Path | str, settings: Laboratory | None = None) -> list[RecognisedFile]:
    """Look at every file of a folder and say what it seems to be.

    Parameters
    ----------
    folder : Path or str
        Folder of a laboratory's files.
    settings : Laboratory, optional
        What was written by hand: its channels tell electrical columns apart.

    Returns
    -------
    list of RecognisedFile
        In the order of names; files that no reader knows are ``unknown``.

    Raises
    ------
    RecordingError
        For a folder that does not exist or is empty.
    """
    place = Path(folder)
    if not place.is_dir():
        raise RecordingError("no such folder", where=str(place))
    files = sorted(file for file in place.iterdir() if file.is_file() and not file.name.startswith("."))
    if not files:
        raise RecordingError("the folder is empty", where=str(place))
    return _numbered([recognised(file, settings) for file in files])


def recognised(file: Path, settings: Laboratory | None = None) -> RecognisedFile:
    """Say what one file seems to be; see :func:`recognise`."""
    if file.suffix == ".toml":
        text = file.read_text(encoding="utf-8", errors="replace")
        is_settings = "jounce.laboratory/" in text
        return RecognisedFile(
            file, "settings" if is_settings else "unknown", "its schema" if is_settings else "a TOML file"
        )
    if not any(file.suffix.lower() in reader.suffixes for reader in READERS):
        return RecognisedFile(file, "unknown", f"no reader for {file.suffix or 'files without a suffix'}")
    if _is_table(file):
        return RecognisedFile(file, "table of trials", "columns for the number and the speed of trials")
    try:
        table = read_signals(file, ReaderOptions()).columns
    except JounceError as error:
        return RecognisedFile(file, "unknown", str(error))
    return _of_columns(file, table, settings)


def _is_table(file: Path) -> bool:
    if file.suffix.lower() not in (".csv", ".txt", ".tsv", ".xlsx") or file.stat().st_size > 100_000:
        return False
    try:
        return bool(read_trials(file))
    except (JounceError, OSError, UnicodeDecodeError, ValueError):
        return False


# columns --------------------------------------------------------------------------------------------------------------


def _of_columns(file: Path, table: ColumnTable, settings: Laboratory | None) -> RecognisedFile:
    units = {column.label: _kind_of_unit(column.unit) for column in table}
    time = next((column for column in table if column.name == "time" or units[column.label] == "s"), None)
    rows = len(table.columns[0].values) if len(table) else 0
    lengths = [column for column in table if units[column.label] == "m"]
    forces = [column for column in table if units[column.label] == "N"]
    if time is None and lengths and forces:
        return _force_deflection(file, table, lengths[0].label, forces[0].label)
    electrical = [column for column in table if units[column.label] in ("V", "A", "1")]
    others = [column for column in table if column is not time and column not in electrical]
    if time is None and rows <= _FEW_ROWS and electrical and others:
        why = f"{rows} rows of {others[0].label} and {electrical[0].label}, without time"
        return RecognisedFile(file, "calibration", why, {others[0].label: electrical[0].label})
    if time is None:
        return RecognisedFile(file, "unknown", f"columns {', '.join(column.label for column in table)}: no time")
    signals = [column for column in table if column is not time and column.fault is None]
    if not signals:
        return RecognisedFile(file, "unknown", "time, and no other column of numbers")
    pulses = [column for column in signals if _has_pulses(time.values, column.values)]
    moving = [column for column in signals if column not in pulses]
    if moving and all(_falls(column.values) for column in moving):
        why = f"{', '.join(column.label for column in moving)} swings and falls"
        channel = _measured(moving[0].name, settings)
        known = {} if channel is None or channel == moving[0].name else {channel: moving[0].label}
        return RecognisedFile(file, "decay", why, known, doubt="" if not pulses else "a trial: it has pulses")
    why = f"{len(moving)} signals over {_lasts(time.values, time.unit)}"
    if pulses:
        why += f", and pulses in {', '.join(column.label for column in pulses)}"
    return RecognisedFile(file, "trial", why, {"pulses": pulses[0].label} if pulses else {})


def _kind_of_unit(unit: str) -> str:
    for si in ("s", "m", "N", "V", "A", "m/s^2", "m/s"):
        if unit and is_unit_of(unit, si):
            return si
    return "" if unit else "1"


def _force_deflection(file: Path, table: ColumnTable, length: str, force: str) -> RecognisedFile:
    x, f = (
        table[label].values * conversion_factor(table[label].unit, si) for label, si in ((length, "m"), (force, "N"))
    )
    rate = float(np.polyfit(x, f, 1)[0]) if np.ptp(x) > 0.0 else 0.0
    columns = {}
    if table[length].name != "displacement":
        columns["displacement"] = length
    if table[force].name != "force":
        columns["force"] = force
    named = _by_name(file.stem)
    by_rate: Kind = "tyre" if abs(rate) > _STIFF else "spring"
    pressure = _pressure(file.stem)
    kind = named or ("tyre" if pressure is not None and by_rate == "tyre" else by_rate)
    doubt = "" if named in (None, by_rate) else f"a {by_rate} by its rate of {1e-3 * rate:.3g} N/mm"
    if named is None and 0.5 * _STIFF < abs(rate) < 2.0 * _STIFF:
        doubt = f"{'a spring' if by_rate == 'tyre' else 'a tyre'}: its rate of {1e-3 * rate:.3g} N/mm is between both"
    how = f"force over displacement, {1e-3 * rate:.3g} N/mm" + (f", and its name says {named}" if named else "")
    return RecognisedFile(file, kind, how, columns, pressure=pressure, doubt=doubt)


def _by_name(stem: str) -> Kind | None:
    return next((kind for kind, words in _WORDS.items() if any(word in stem.casefold() for word in words)), None)


def _pressure(stem: str) -> float | None:
    """Pressure (Pa) in a name such as ``tyre_031_2`` (0.31 MPa) or ``pneu_2.5bar``."""
    with_unit = re.search(r"(\d+(?:[.,]\d+)?)\s*_?(MPa|bar|kPa)", stem, re.IGNORECASE)
    if with_unit:
        unit = {"mpa": "MPa", "kpa": "kPa", "bar": "bar"}[with_unit[2].casefold()]
        return float(with_unit[1].replace(",", ".")) * conversion_factor(unit, "Pa")
    bare = re.search(r"(?<!\d)0(\d\d)(?!\d)", stem)
    return float(f"0.{bare[1]}") * 1e6 if bare else None


def _measured(column: str, settings: Laboratory | None) -> str | None:
    channels = {} if settings is None else settings.channels
    return next((channel.measures for name, channel in channels.items() if name == column), None)


def _has_pulses(time: Array, values: Array) -> bool:
    """Whether a signal has two levels and nothing between them."""
    if not np.all(np.isfinite(values)) or np.ptp(values) == 0.0 or len(values) < _FEW_ROWS:
        return False
    low, high = np.quantile(values, [0.0, 1.0])
    between = np.mean(np.abs(values - 0.5 * (low + high)) < 0.25 * (high - low))
    if between > _BETWEEN:
        return False
    try:
        return len(edges(time, values)) >= FEWEST_PULSES
    except RecordingError:
        return False


_BETWEEN = 0.02
"""Share of samples in the middle between the levels of a pulse signal: edges pass through it in less than one."""


def _falls(values: Array) -> bool:
    """Whether a signal swings about its end and falls: a free decay."""
    if not np.all(np.isfinite(values)) or len(values) < _FEW_ROWS:
        return False
    centred = values - np.median(values[-len(values) // 4 :])
    parts = [float(np.std(part)) for part in np.array_split(centred, 4)]
    return (
        parts[0] > 0.0
        and all(b < _FALLS * parts[0] for b in parts[1:])
        and float(np.argmax(np.abs(centred))) < 0.25 * len(values)
    )


def _lasts(time: Array, unit: str) -> str:
    return f"{float(time[-1] - time[0]) * (conversion_factor(unit, 's') if unit else 1.0):.3g} s"


# numbers of trials ----------------------------------------------------------------------------------------------------


def _numbered(files: list[RecognisedFile]) -> list[RecognisedFile]:
    """Give trials the number in their names: the last whole number that differs in all of them."""
    trials = [item for item in files if item.kind == "trial"]
    numbers = [[int(text) for text in re.findall(r"\d+", item.file.stem)] for item in trials]
    places = range(1, 1 + min((len(row) for row in numbers), default=0))
    place = next((k for k in places if len({row[-k] for row in numbers}) == len(numbers)), None)
    if place is None:
        return files
    by_file = {item.file: row[-place] for item, row in zip(trials, numbers, strict=True)}
    return [
        RecognisedFile(
            item.file,
            item.kind,
            item.why,
            item.columns,
            by_file.get(item.file),
            _pressure(item.file.stem) if item.kind == "trial" else item.pressure,
            item.doubt,
        )
        for item in files
    ]
