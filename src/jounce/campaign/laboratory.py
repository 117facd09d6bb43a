"""Handwritten settings of a laboratory: masses, belt, obstacle, channels of the card, and the table of trials."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from jounce.campaign.belt import Belt
from jounce.core.columns import name_and_unit
from jounce.core.description import Description, Whole, read_description
from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.misplaced import error_at, misplaced_value
from jounce.core.phrases import Phrase
from jounce.core.text import without_accents
from jounce.core.units import (
    Mass,
    PositiveHeight,
    PositiveLength,
    PositiveTime,
    Unit,
    is_unit_of,
    to_si,
)
from jounce.recordings.cells import cells_of_file, cells_of_text
from jounce.recordings.conditioning import sensitivity_of
from jounce.recordings.schema import channel_unit, quantity_of
from jounce.recordings.sensors import Sensor


class Obstacle(Description):
    """Obstacle on the belt, as measured with a caliper: height and length, m."""

    height: PositiveHeight
    length: PositiveLength
    shape: Literal[
        "half-sine", "versine", "triangle", "half-cylinder", "rectangle", "trapezoid"
    ] = "half-sine"


class CardChannel(Sensor):
    """A channel of the acquisition card: its measured quantity, and the measuring chain of its sensor."""

    measures: str

    @model_validator(mode="after")
    def _measures_something(self) -> CardChannel:
        if not quantity_of(self.measures):
            raise error_at(
                ("measures",),
                Phrase(
                    "{measures!r} does not name a known quantity, such as sprung.az",
                    measures=self.measures,
                ),
            )
        if self.sensitivity:
            try:
                sensitivity_of(self.sensitivity, channel_unit(self.measures), where="")
            except DescriptionError as error:
                raise misplaced_value(("sensitivity",), error) from None
        return self


class Laboratory(Description):
    """Settings of a laboratory, schema ``jounce.laboratory/1``.

    Attributes
    ----------
    sprung_mass, unsprung_mass : float
        Weighed masses, kg.
    obstacle : Obstacle
        Height and length of the obstacle, m.
    belt : Belt
        Length of the loop; radius, pulses per revolution and column of the photo sensor.
    channels : dict
        Channel of each column of the files: ``{measures = "sprung.az", sensitivity = "100 mV/g"}``.
    trials : str
        File with the table of trials: number, speed, angle, pressure, obstacles.
    rig : str
        Rig file or library name, used instead of the quarter car built from these values.
    title : str
        Title of the report.
    sample_time : float
        Time step of files that contain neither a time column nor a sample rate, s.
    """

    schema_: Literal["jounce.laboratory/1"] = Field(default="jounce.laboratory/1", alias="schema")
    title: str = "Bench campaign"
    sprung_mass: Mass | None = None
    unsprung_mass: Mass | None = None
    obstacle: Obstacle
    belt: Belt | None = None
    channels: dict[str, CardChannel] = {}
    trials: str = ""
    rig: str = ""
    synthetic: str = ""
    sample_time: PositiveTime | None = None

    @model_validator(mode="after")
    def _complete(self) -> Laboratory:
        if not self.rig and (self.sprung_mass is None or self.unsprung_mass is None):
            raise ValueError("sprung_mass and unsprung_mass are missing; weigh both, or name a rig")
        measured = [channel.measures for channel in self.channels.values()]
        twice = {name for name in measured if measured.count(name) > 1}
        if twice:
            raise error_at(("channels",), Phrase("{twice} is measured twice", twice=min(twice)))
        return self


def load_laboratory(path: Path | str) -> Laboratory:
    """Read the settings of a laboratory.

    Raises
    ------
    DescriptionError
        If the settings are invalid; the message names file, line, key, value and allowed values.
    """
    return read_description(Laboratory, path, "jounce.laboratory/1")[0]


# the table of trials --------------------------------------------------------------------------------------------------


class TrialRow(Description):
    """One row of the table of trials: number, speed (m/s), angle of the strut (rad), pressure (Pa), obstacles."""

    number: Whole
    speed: Annotated[float, Unit("m/s", above=0.0)] | None = None
    angle: Annotated[float, Unit("rad")] | None = None
    pressure: Annotated[float, Unit("Pa", above=0.0)] | None = None
    count: Whole = 1
    pitch: PositiveLength | None = None
    taken_for_one: str = ""
    """Profile as written in the table, if it was not recognised."""


_HEADINGS: dict[str, tuple[str, str, tuple[str, ...]]] = {
    "speed": ("m/s", "v", ("speed", "velocity", "velocid", "velocita", "geschwindigkeit", "vitesse", "predkosc")),
    "angle": ("deg", "θ", ("angle", "angulo", "angolo", "winkel", "kat")),
    "pressure": ("MPa", "p", ("pressure", "pressao", "presion", "pression", "druck", "cisnienie")),
    "pitch": ("m", "x", ("pitch", "spacing", "distan", "espacamento", "separacion", "abstand", "odstep")),
    "profile": ("", "", ("profil", "perfil", "obstac", "hindernis", "ostacol", "przeszkod", "road")),
    "number": ("", "n", ("trial", "number", "no", "nr", "test", "run", "ensaio", "ensayo", "prueba", "versuch",
                         "nummer", "numer", "proba", "essai", "prova")),
}  # fmt: skip
"""Default unit, symbol and heading words (without accents) of each column.

The first matching entry applies: "trial speed" is a speed, "obstacle spacing" a pitch.
"""
_PART_OF_A_WORD = 5
"""Minimum length of a word that may match within another, as in Reifendruck; shorter words must match entirely."""
_TRAIN = 5
"""Number of obstacles of the paper's profile B."""
_TRAINS = r"\s*(B(?=\s*[\d(])|(B|train|five|5|series?|reihe|seria|trem|tren)\b)"
_WIDEST = 3.0
"""Greatest pitch, in m, of a number without a unit: the 10 of "B10" are hardly metres."""
_SINGLE = r"\s*(A|1|one|single\b.*)?\s*"


def read_trials(path: Path | str) -> list[TrialRow]:
    r"""Read a table of trials (CSV or XLSX): a blank cell repeats the value above it, as in the paper's Table 2.

    Columns are recognised by words in their headings: trial, speed, angle, pressure, profile (``A``: one obstacle,
    ``B``: five) and pitch, also in German, Spanish, Portuguese, French, Italian and Polish. A profile may include its
    pitch, ``"B (x = 0.10 m)"``. Units are given in the headings or in a separate row below them.

    Raises
    ------
    RecordingError
        If the headings for trial or speed are missing, a number occurs twice, or a cell is not a number.

    Examples
    --------
    >>> import tempfile
    >>> file = Path(tempfile.mkdtemp()) / "trials.csv"
    >>> table = "trial,speed [m/s],angle [deg],p [MPa],profile\n1,1.95,26,0.31,A\n2,2.86,,,\n4,1.97,,,B 0.10\n"
    >>> _ = file.write_text(table)
    >>> [(row.number, row.speed, row.count, row.pitch) for row in read_trials(file)]
    [(1, 1.95, 1, None), (2, 2.86, 1, None), (4, 1.97, 5, 0.1)]
    """
    file = Path(path)
    return _trials_in(cells_of_file(file), str(file))


def read_trial_text(text: str, where: str = "table") -> list[TrialRow]:
    r"""Read a table of trials copied from a spreadsheet; separators, headings and units are as in `read_trials`.

    Raises
    ------
    RecordingError
        As `read_trials`; the message names the line of the text.

    Examples
    --------
    >>> rows = read_trial_text("Versuch\tv [km/h]\tDruck [bar]\n1\t7,2\t3,1\n2\t10,8\t\n")
    >>> [(row.number, round(row.speed, 6), round(row.pressure)) for row in rows]
    [(1, 2.0, 310000), (2, 3.0, 310000)]
    """
    return _trials_in(cells_of_text(text), where)


def _trials_in(rows: list[list[str]], file: str) -> list[TrialRow]:
    head = _heading_row(rows, file)
    places = _headings_in(rows[head])
    if head + 1 < len(rows) and _are_units(rows[head + 1], places):
        head += 1
        places = {name: (i, rows[head][i].strip() or unit) for name, (i, unit) in places.items()}
    last: dict[str, str] = {}
    trials = []
    for line, row in enumerate(rows[head + 1 :], head + 2):
        given = {
            name: row[i].strip()
            for name, (i, _) in places.items()
            if i < len(row) and row[i].strip()
        }
        if not given:
            continue
        new_profile = "profile" in given and "pitch" not in given
        last = {
            **{name: text for name, text in last.items() if not (new_profile and name == "pitch")},
            **given,
        }
        if "number" in given:
            trials.append(
                _trial(
                    last, {name: unit for name, (_, unit) in places.items()}, f"{file}: line {line}"
                )
            )
    numbers = [trial.number for trial in trials]
    twice = sorted({number for number in numbers if numbers.count(number) > 1})
    if twice:
        raise RecordingError("a trial is listed twice", where=file, found=twice[0])
    return trials


def unread_headings(path: Path | str) -> list[str]:
    """Return the headings of a table of trials that jounce does not read."""
    rows, head = _table_of(Path(path))
    read = {i for i, _ in _headings_in(rows[head]).values()}
    return [cell.strip() for i, cell in enumerate(rows[head]) if cell.strip() and i not in read]


def is_table_of_trials(path: Path | str) -> bool:
    """Whether a file has headings for the number and the speed of trials."""
    try:
        _table_of(Path(path))
    except RecordingError:
        return False
    return True


def _table_of(file: Path) -> tuple[list[list[str]], int]:
    """Return the cells of a table of trials, and the index of its heading row."""
    rows = cells_of_file(file)
    return rows, _heading_row(rows, str(file))


def _heading_row(rows: list[list[str]], where: str) -> int:
    head = next(
        (i for i, row in enumerate(rows) if {"number", "speed"} <= _headings_in(row).keys()), None
    )
    if head is None:
        raise RecordingError(
            "no table of trials: columns for the number and the speed are not named",
            where=where,
            found=", ".join(cell for cell in max(rows, key=_count_cells) if cell)
            if rows
            else "nothing",
            allowed="trial, speed [m/s], angle [deg], pressure [MPa], profile, pitch [m]",
        )
    return head


def _count_cells(row: Sequence[str]) -> int:
    return sum(bool(cell.strip()) for cell in row)


def _are_units(row: Sequence[str], places: dict[str, tuple[int, str]]) -> bool:
    """Whether a row below the headings contains units."""
    place = places["speed"][0]
    return place < len(row) and is_unit_of(row[place], "m/s")


def _headings_in(row: Sequence[str]) -> dict[str, tuple[int, str]]:
    """Return column and unit of each recognised heading in a row; a single symbol is also a heading."""
    headings: dict[str, tuple[int, str]] = {}
    for i, cell in enumerate(row):
        text, unit = name_and_unit(cell)
        name = _heading(text)
        if name and name not in headings:
            headings[name] = i, unit or _HEADINGS[name][0]
    return headings


def _heading(text: str) -> str | None:
    """Identify a heading by its symbol or words."""
    plain = without_accents(text)
    words = re.findall(r"[^\W\d_]+", plain)
    for name, (_, symbol, known) in _HEADINGS.items():
        if words == [symbol] or any(
            word == part or (len(part) >= _PART_OF_A_WORD and part in word)
            for word in words
            for part in known
        ):
            return name
    return None


def _trial(cells: dict[str, str], units: dict[str, str], where: str) -> TrialRow:
    values: dict[str, Any] = {}
    for name, si in (("speed", "m/s"), ("angle", "rad"), ("pressure", "Pa"), ("pitch", "m")):
        if name in cells and cells[name] not in ("-", "–"):
            values[name] = _size(cells[name], units[name], si, f"{where}: {name}")
    number = re.fullmatch(r"\D*?(\d+)(?:\.0*)?\D*", cells["number"])
    if number is None:
        raise RecordingError("not a trial number", where=where, found=cells["number"])
    values["number"] = int(number[1])
    profile = cells.get("profile", "A")
    train = re.match(_TRAINS, profile, re.IGNORECASE)
    if train:
        values["count"] = _TRAIN
        inside = re.search(r"(\d*\.\d+|\d+)\s*(mm|cm|m)?\s*\)?\s*$", profile[train.end() :])
        if inside and "pitch" not in values and (inside[2] or float(inside[1]) <= _WIDEST):
            values["pitch"] = _size(f"{inside[1]} {inside[2] or 'm'}", "m", "m", where)
        if "pitch" not in values:
            raise RecordingError(
                "a train without a pitch",
                where=where,
                found=profile,
                allowed='"B 0.10 m", or a column pitch',
            )
    else:
        values.pop("pitch", None)
        if not re.fullmatch(_SINGLE, profile, re.IGNORECASE):
            values["taken_for_one"] = profile
    return TrialRow.model_validate(values)


def _size(text: str, unit: str, si: str, where: str) -> float:
    try:
        return to_si(text if re.search(r"[A-Za-z°µ]", text) else f"{text} {unit}", si, where=where)
    except DescriptionError as error:
        raise RecordingError(
            error.what, where=where, found=text, allowed=error.allowed, hint=error.hint
        ) from None
