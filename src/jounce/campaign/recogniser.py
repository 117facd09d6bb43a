"""Recognise the files of a laboratory: spring or tyre test, free decay, trial, calibration, table of trials, settings.

Files are recognised by their columns, units and signal shapes; file names provide information that columns lack.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal

import numpy as np

from jounce.campaign.laboratory import Laboratory, is_table_of_trials, read_trials
from jounce.core.columns import Column, ColumnTable, name_and_unit, names_time, text_of
from jounce.core.errors import JounceError, RecordingError
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.text import without_accents
from jounce.core.types import Array
from jounce.core.units import conversion_factor, is_unit_of
from jounce.recordings.pulses import FEWEST_PULSES, edges
from jounce.recordings.reader import ReaderOptions
from jounce.recordings.readers import READERS, read_signals
from jounce.recordings.schema import place_of

Kind = Literal[
    "spring",
    "tyre",
    "decay",
    "trial",
    "tester record",
    "calibration",
    "table of trials",
    "settings",
    "unknown",
]
_FEW_ROWS = 60
"""Maximum number of rows of a handwritten table, and minimum number of samples of a trial."""
_STIFF = 60e3
"""Limit in N/m: springs of small cars and karts are softer, tyres are stiffer; rates near the limit are reported."""
_WORDS: dict[Kind, tuple[str, ...]] = {
    "spring": ("spring", "mola", "feder", "resorte", "muelle", "molla", "ressort", "sprezyn"),
    "tyre": ("tyre", "tire", "pneu", "reifen", "neumatico", "gomma", "opon"),
    "decay": ("decay", "decai", "free", "ausschwing", "amortigua", "smorza", "gasn"),
}
_WEIGHTS = {"kg": "kgf", "lb": "lbf", "lbs": "lbf"}
"""Units of mass that denote forces in a test with weights or scales."""
_RATE = re.compile(
    r"(?:sampl|rate|abtast|frequen|frecuen|muestreo|amostrag|czestotliw|\bfs\b)[^\d\n]{0,40}"
    r"(\d+(?:[.,]\d+)?) *(k?)(?:Hz|S/s)",
    re.IGNORECASE,
)
"""Pattern of the sample rate in the header of a file without a time column."""
_HEADER = 4000
"""Number of characters at the beginning of a file that are searched for its sample rate."""
_USUAL_RATES = (50.0, 200e3)
"""Usual sample rates in Hz; they distinguish seconds from milliseconds if a time column has no unit."""
_OF_A_PLATE = ("plate.force", "plate.z")
"""Ends of the names of a shock-absorber tester's channels: left.plate.force."""
_FALLS = 0.5
"""Maximum motion in the later quarters of a free decay, as a fraction of the motion in the first quarter."""


@dataclass(frozen=True)
class RecognisedFile(Shown):
    """A file and its recognised kind.

    Attributes
    ----------
    file : Path
        The file.
    kind : str
        ``spring``, ``tyre``, ``decay``, ``trial``, ``tester record`` (of a shock-absorber tester), ``calibration``,
        ``table of trials``, ``settings`` or ``unknown``.
    why : str
        Reason for the recognised kind.
    columns : dict
        Names in the campaign to columns of the file, if they differ.
    number : int or None
        Trial number in the file name.
    pressure : float or None
        Pressure in the file name, Pa.
    doubt : str
        Alternative kind; empty if the file is unambiguous.
    time : str
        Time column with its unit, if readers need it: ``"t [s]"``.
    sample_time : float or None
        Time step from the header, s, if the file has no time column.
    rate : float or None
        Sample rate of a record over time, Hz.
    signals : tuple of str
        Columns of a record over time, except the time.
    """

    file: Path
    kind: Kind
    why: str
    columns: dict[str, str] = field(default_factory=dict)
    number: int | None = None
    pressure: float | None = None
    doubt: str = ""
    time: str = ""
    sample_time: float | None = None
    rate: float | None = None
    signals: tuple[str, ...] = ()


def recognise(folder: Path | str, settings: Laboratory | None = None) -> list[RecognisedFile]:
    """Recognise the kind of every file of a folder.

    Parameters
    ----------
    folder : Path or str
        Folder of a laboratory's files.
    settings : Laboratory, optional
        Settings of the laboratory, whose channels distinguish electrical columns.

    Returns
    -------
    list of RecognisedFile
        Files in the order of their names; files without a reader are ``unknown``.

    Raises
    ------
    RecordingError
        If the folder does not exist or is empty.
    """
    place = Path(folder)
    if not place.is_dir():
        raise RecordingError("no such folder", where=str(place))
    files = sorted(
        file for file in place.iterdir() if file.is_file() and not file.name.startswith(".")
    )
    if not files:
        raise RecordingError("the folder is empty", where=str(place))
    items = [recognise_file(file, settings) for file in files]
    return number_trials(
        items, _numbers_of([item.file for item in items if item.kind == "table of trials"])
    )


def recognise_file(file: Path, settings: Laboratory | None = None) -> RecognisedFile:
    """Recognise the kind of one file; see :func:`recognise`."""
    return recognise_columns(file, settings)[0]


def recognise_columns(
    file: Path, settings: Laboratory | None = None, columns: Mapping[str, str] | None = None
) -> tuple[RecognisedFile, ColumnTable | None]:
    """Recognise one file, and return its columns if it is a measurement.

    ``columns`` are names and units that its headings lack: ``{"displacement": "s [mm]"}``.
    """
    known = _recognise_description(file)
    if known is not None:
        return known, None
    try:
        table = read_signals(file, ReaderOptions()).columns
    except JounceError as error:
        return RecognisedFile(file, "unknown", error.message()), None
    return _of_columns(file, _with_names(table, columns or {}), settings), table


def _with_names(table: ColumnTable, columns: Mapping[str, str]) -> ColumnTable:
    """Return the columns under given names and with given units."""
    given = {}
    for name, spec in columns.items():
        label, unit = name_and_unit(spec)
        for column in table:
            if spec in (column.label, column.written) or label in (column.name, column.label):
                given[id(column)] = replace(column, name=name, unit=unit or column.unit)
    return replace(table, columns=tuple(given.get(id(column), column) for column in table))


def _recognise_description(file: Path) -> RecognisedFile | None:
    """Recognise a file that is no measurement, or has no reader."""
    if file.suffix == ".toml":
        text = file.read_text(encoding="utf-8", errors="replace")
        is_settings = "jounce.laboratory/" in text
        return RecognisedFile(
            file,
            "settings" if is_settings else "unknown",
            Phrase("its schema") if is_settings else Phrase("a TOML file"),
        )
    if not any(file.suffix.lower() in reader.suffixes for reader in READERS):
        return RecognisedFile(
            file,
            "unknown",
            Phrase("no reader for {suffix}", suffix=file.suffix)
            if file.suffix
            else Phrase("no reader for files without a suffix"),
        )
    if _is_table(file):
        return RecognisedFile(
            file, "table of trials", Phrase("columns for the number and the speed of trials")
        )
    return None


def _is_table(file: Path) -> bool:
    if (
        file.suffix.lower() not in (".csv", ".txt", ".tsv", ".xlsx")
        or file.stat().st_size > 100_000
    ):
        return False
    return is_table_of_trials(file)


# columns --------------------------------------------------------------------------------------------------------------


def _of_columns(file: Path, table: ColumnTable, settings: Laboratory | None) -> RecognisedFile:
    units = {column.label: _kind_of_unit(column.unit) for column in table}
    rows = len(table.columns[0].values) if len(table) else 0
    lengths = [column for column in table if units[column.label] == "m"]
    forces = [column for column in table if units[column.label] == "N" or column.unit in _WEIGHTS]
    time = _time(table)
    if time is None and lengths and forces:
        return _force_deflection(file, lengths[0], forces[0])
    electrical = [column for column in table if units[column.label] in ("V", "A", "1")]
    others = [column for column in table if column is not time and column not in electrical]
    if time is None and rows <= _FEW_ROWS and electrical and others:
        why = f"{rows} rows of {others[0].label} and {electrical[0].label}, without time"
        return RecognisedFile(file, "calibration", why, {others[0].label: electrical[0].label})
    seconds, spec, step = _clock(file, time, rows, settings)
    if seconds is None:
        return RecognisedFile(file, "unknown", _no_time(table, rows))
    signals = [column for column in table if column is not time and column.fault is None]
    if not signals:
        return RecognisedFile(file, "unknown", Phrase("time, and no other column of numbers"))
    rate = (
        (len(seconds) - 1) / float(seconds[-1] - seconds[0]) if seconds[-1] > seconds[0] else None
    )
    item = _of_signals(file, seconds, signals, settings)
    return replace(
        item,
        time=spec,
        sample_time=step,
        rate=rate,
        signals=tuple(column.name for column in signals),
    )


def _time(table: ColumnTable) -> Column | None:
    """Return the time column, recognised by its name (in several languages) or unit."""
    plain = next(
        (column for column in table if column.name == "time" or _kind_of_unit(column.unit) == "s"),
        None,
    )
    if plain is not None:
        return plain
    return next((c for c in table if names_time(c.name) and not c.unit and c.fault is None), None)


def _clock(
    file: Path, time: Column | None, rows: int, settings: Laboratory | None
) -> tuple[Array | None, str, float | None]:
    """Return the instants of the samples (s), the column as named in a campaign, and a time step from the header."""
    if time is None:
        step = _step_in_header(file) if rows > _FEW_ROWS else None
        if step is None and rows > _FEW_ROWS and settings is not None:
            step = settings.sample_time
        return (
            (None, "", None)
            if step is None
            else (np.arange(rows, dtype=np.float64) * step, "", step)
        )
    if time.unit or time.fault is not None or len(time.values) < 2:
        return time.values * (conversion_factor(time.unit, "s") if time.unit else 1.0), "", None
    step = float(np.median(np.diff(time.values)))
    unit = next(
        (u for u, s in (("s", 1.0), ("ms", 1e-3)) if step > 0.0 and _is_usual(1.0 / (s * step))),
        None,
    )
    if unit is None:
        return None, "", None
    return time.values * conversion_factor(unit, "s"), f"{time.label} [{unit}]", None


def _is_usual(rate: float) -> bool:
    return _USUAL_RATES[0] <= rate <= _USUAL_RATES[1]


def _step_in_header(file: Path) -> float | None:
    try:
        stated = _RATE.search(without_accents(text_of(file)[:_HEADER]))
    except RecordingError:
        return None
    return (
        None
        if stated is None
        else 1.0 / (float(stated[1].replace(",", ".")) * (1e3 if stated[2] else 1.0))
    )


def _no_time(table: ColumnTable, rows: int) -> str:
    columns = ", ".join(column.label for column in table)
    if rows <= _FEW_ROWS:
        return Phrase(
            "columns {columns}: no time, and no displacement and force; write units in the headings, as in "
            "displacement [mm]",
            columns=columns,
        )
    return Phrase(
        "columns {columns}: no time; name a column time [s], or give sample_time in the settings",
        columns=columns,
    )


def _of_signals(
    file: Path, seconds: Array, signals: list[Column], settings: Laboratory | None
) -> RecognisedFile:
    """Distinguish trials from free decays by the shape of their signals over time (s)."""
    plates = [column.label for column in signals if column.name.endswith(_OF_A_PLATE)]
    if plates:
        return RecognisedFile(file, "tester record", f"signals of a tester: {', '.join(plates)}")
    pulses = [column for column in signals if _has_pulses(seconds, column.values)]
    moving = [column for column in signals if column not in pulses]
    is_driven = any(place_of(column.name).startswith("unsprung") for column in moving)
    may_decay = _by_name(file.stem) == "decay" or not is_driven  # a wheel is measured in trials
    if moving and may_decay and all(_falls(column.values) for column in moving):
        why = f"{', '.join(column.label for column in moving)} swings and falls"
        channel = _measured_channel(moving[0].name, settings)
        known = {} if channel is None or channel == moving[0].name else {channel: moving[0].label}
        return RecognisedFile(
            file, "decay", why, known, doubt="" if not pulses else "a trial: it has pulses"
        )
    why = f"{len(moving)} signals over {seconds[-1] - seconds[0]:.3g} s"
    if pulses:
        why += f", and pulses in {', '.join(column.label for column in pulses)}"
    return RecognisedFile(file, "trial", why, {"pulses": pulses[0].label} if pulses else {})


def _kind_of_unit(unit: str) -> str:
    for si in ("s", "m", "N", "V", "A", "m/s^2", "m/s"):
        if unit and is_unit_of(unit, si):
            return si
    return "" if unit else "1"


def _force_deflection(file: Path, length: Column, force: Column) -> RecognisedFile:
    weight = _WEIGHTS.get(force.unit, "")
    x = length.values * conversion_factor(length.unit, "m")
    f = force.values * conversion_factor(weight or force.unit, "N")
    rate = float(np.polyfit(x, f, 1)[0]) if np.ptp(x) > 0.0 else 0.0
    columns = {}
    if length.name != "displacement":
        columns["displacement"] = length.label
    if force.name != "force" or weight:
        columns["force"] = f"{_original_heading(force)} [{weight}]" if weight else force.label
    named = _by_name(file.stem)
    named = None if named == "decay" else named
    by_rate: Kind = "tyre" if abs(rate) > _STIFF else "spring"
    pressure = _pressure(file.stem)
    kind = named or ("tyre" if pressure is not None and by_rate == "tyre" else by_rate)
    doubt = "" if named in (None, by_rate) else f"a {by_rate} by its rate of {1e-3 * rate:.3g} N/mm"
    if (
        named is None and 0.5 * _STIFF < abs(rate) < 2.0 * _STIFF
    ):  # bicycle springs, 53 N/mm, soft tyres, 120 N/mm
        doubt = f"{'a spring' if by_rate == 'tyre' else 'a tyre'}: its rate of {1e-3 * rate:.3g} N/mm is between both"
    how = f"force over displacement, {1e-3 * rate:.3g} N/mm" + (
        f", {force.unit} read as {weight}" if weight else ""
    )
    how += f", and its name says {named}" if named else ""
    return RecognisedFile(file, kind, how, columns, pressure=pressure, doubt=doubt)


def _original_heading(column: Column) -> str:
    """Return the heading as written in the file, including its unit."""
    return column.written or column.label


def _by_name(stem: str) -> Kind | None:
    return next(
        (
            kind
            for kind, words in _WORDS.items()
            if any(word in without_accents(stem) for word in words)
        ),
        None,
    )


def _pressure(stem: str) -> float | None:
    """Extract the pressure (Pa) from a name such as ``tyre_031_2`` (0.31 MPa), ``pneu_2.5bar`` or ``run07_45psi``."""
    with_unit = re.search(r"(\d+(?:[.,]\d+)?)\s*_?(MPa|bar|kPa|psi)", stem, re.IGNORECASE)
    if with_unit:
        unit = {"mpa": "MPa", "kpa": "kPa", "bar": "bar", "psi": "psi"}[with_unit[2].casefold()]
        return float(with_unit[1].replace(",", ".")) * conversion_factor(unit, "Pa")
    bare = re.search(r"(?<!\d)0([1-9]\d)(?!\d)", stem)
    return float(f"0.{bare[1]}") * 1e6 if bare else None


def _measured_channel(column: str, settings: Laboratory | None) -> str | None:
    channels = {} if settings is None else settings.channels
    return next((channel.measures for name, channel in channels.items() if name == column), None)


def _has_pulses(time: Array, values: Array) -> bool:
    """Whether a signal has two levels and almost no samples between them."""
    if not np.all(np.isfinite(values)) or np.ptp(values) == 0.0 or len(values) < _FEW_ROWS:
        return False
    low, high = np.quantile(values, [0.0, 1.0])
    # Pulses cross the middle half of their range only at edges; other signals are there as often as elsewhere.
    between = np.mean(np.abs(values - 0.5 * (low + high)) < 0.25 * (high - low))
    if between > _BETWEEN:
        return False
    try:
        return len(edges(time, values)) >= FEWEST_PULSES
    except RecordingError:
        return False


_BETWEEN = 0.02
"""Maximum fraction of samples between the levels of a pulse signal: an edge takes less than one sample."""


def _falls(values: Array) -> bool:
    """Whether a signal decays towards its final value, as in a free decay."""
    if not np.all(np.isfinite(values)) or len(values) < _FEW_ROWS:
        return False
    centred = values - np.median(values[-len(values) // 4 :])
    parts = [float(np.std(part)) for part in np.array_split(centred, 4)]
    return (
        parts[0] > 0.0
        and all(b < _FALLS * parts[0] for b in parts[1:])
        and float(np.argmax(np.abs(centred))) < 0.25 * len(values)  # released in the first quarter
    )


# numbers of trials ----------------------------------------------------------------------------------------------------


def _numbers_of(tables: list[Path]) -> set[int]:
    """Return the trial numbers in the table of trials; empty if there is no readable table."""
    try:
        return {row.number for row in read_trials(tables[0])} if len(tables) == 1 else set()
    except JounceError:
        return set()


def number_trials(files: list[RecognisedFile], known: Collection[int]) -> list[RecognisedFile]:
    """Extract trial numbers from file names, at the position with most numbers of the table, or most distinct numbers.

    Positions are counted from either end of a name; in case of a tie the last position is used.
    """
    trials = [item for item in files if item.kind == "trial"]
    numbers = {
        item.file: [int(text) for text in re.findall(r"\d+", item.file.stem)] for item in trials
    }
    longest = max(map(len, numbers.values()), default=0)

    def different(place: int) -> int:
        values = [row[place] for row in numbers.values() if -len(row) <= place < len(row)]
        return len(set(values) & set(known) if known else set(values))

    places = [*range(-1, -longest - 1, -1), *range(longest)]
    place = max(places, key=different, default=None)
    if place is None or (not known and different(place) < len(trials)):
        return files
    return [
        _with_number(item, numbers[item.file], place) if item.file in numbers else item
        for item in files
    ]


def _with_number(item: RecognisedFile, numbers: list[int], place: int) -> RecognisedFile:
    number = numbers[place] if -len(numbers) <= place < len(numbers) else None
    return replace(item, number=number, pressure=_pressure(item.file.stem))
