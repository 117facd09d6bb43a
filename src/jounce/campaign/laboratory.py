"""What a laboratory writes down by hand: masses, belt, obstacle, channels of the card, and the table of its trials."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from jounce.campaign.belt import Belt
from jounce.core.description import Description, Whole, misplaced, read_description
from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.units import Mass, PositiveHeight, PositiveLength, Unit, to_si
from jounce.recordings.conditioning import sensitivity_of
from jounce.recordings.schema import channel_unit, quantity_of
from jounce.recordings.sensors import Sensor


class Obstacle(Description):
    """The obstacle on the belt, as a caliper measures it: height and length, m."""

    height: PositiveHeight
    length: PositiveLength
    shape: Literal["half-sine", "versine", "triangle", "half-cylinder", "rectangle", "trapezoid"] = "half-sine"


class CardChannel(Sensor):
    """A channel of the acquisition card: what it measures, and the chain of its sensor."""

    measures: str

    @model_validator(mode="after")
    def _measures_something(self) -> CardChannel:
        if not quantity_of(self.measures):
            raise misplaced(("measures",), f"{self.measures!r} names no known quantity, as sprung.az does")
        if self.sensitivity:
            try:
                sensitivity_of(self.sensitivity, channel_unit(self.measures), where="")
            except DescriptionError as error:
                raise misplaced(("sensitivity",), str(error)) from None
        return self


class Laboratory(Description):
    """Settings of a laboratory, schema ``jounce.laboratory/1``.

    Attributes
    ----------
    sprung_mass, unsprung_mass : float
        As weighed, kg.
    obstacle : Obstacle
        Height and length, m.
    belt : Belt
        Length of the loop; radius, pulses a turn and column of the photo sensor.
    channels : dict
        Column of the files to what it measures: ``{measures = "sprung.az", sensitivity = "100 mV/g"}``.
    trials : str
        File with the table of the trials: number, speed, angle, pressure, obstacles.
    rig : str
        A rig instead of the quarter car made of these numbers: a file or a name of the library.
    title : str
        Title of the report.
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

    @model_validator(mode="after")
    def _complete(self) -> Laboratory:
        if not self.rig and (self.sprung_mass is None or self.unsprung_mass is None):
            raise ValueError("sprung_mass and unsprung_mass are missing; weigh both, or name a rig")
        measured = [channel.measures for channel in self.channels.values()]
        twice = {name for name in measured if measured.count(name) > 1}
        if twice:
            raise misplaced(("channels",), f"{min(twice)} is measured twice")
        return self


def load_laboratory(path: Path | str) -> Laboratory:
    """Read the settings of a laboratory.

    Raises
    ------
    DescriptionError
        With file, line, key, found value and what is allowed.
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


_HEADINGS: dict[str, tuple[str, tuple[str, ...]]] = {
    "number": ("", ("trial", "number", "no", "nr", "n", "test", "run", "ensaio", "versuch", "nummer")),
    "speed": ("m/s", ("speed", "velocity", "v", "velocidade", "geschwindigkeit")),
    "angle": ("deg", ("angle", "strut angle", "θ", "ângulo", "angulo", "winkel")),
    "pressure": ("MPa", ("pressure", "p", "tyre pressure", "tire pressure", "pressão", "pressao", "druck")),
    "profile": ("", ("profile", "obstacle", "obstacles", "road", "perfil", "hindernis", "hindernisse")),
    "pitch": ("m", ("pitch", "spacing", "x", "distance", "espaçamento", "abstand")),
}
"""Usual unit of a column without one, and the words that head it."""
_TRAIN = 5
"""Obstacles of the paper's profile B."""


def read_trials(path: Path | str) -> list[TrialRow]:
    r"""Read a table of trials (CSV or XLSX): a blank cell has the value above it, as in the paper's Table 2.

    Columns are found by their words: trial, speed, angle, pressure, profile (``A``: one obstacle, ``B``: five) and
    pitch; a profile may say its pitch, ``"B 0.10 m"``.

    Raises
    ------
    RecordingError
        Without a heading for trial and speed, for a number given twice, or a cell that is none.

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
    rows = _cells(file)
    head = next((i for i, row in enumerate(rows) if {"number", "speed"} <= _headed(row).keys()), None)
    if head is None:
        found = ", ".join(str(cell) for cell in rows[0]) if rows else "nothing"
        raise RecordingError(
            "no table of trials: columns for the number and the speed are not named",
            where=str(file),
            found=found,
            allowed="trial, speed [m/s], angle [deg], pressure [MPa], profile, pitch [m]",
        )
    places = _headed(rows[head])
    last: dict[str, str] = {}
    trials = []
    for line, row in enumerate(rows[head + 1 :], head + 2):
        given = {name: row[i].strip() for name, (i, _) in places.items() if i < len(row) and row[i].strip()}
        if not given:
            continue
        new_profile = "profile" in given and "pitch" not in given
        last = {**{name: text for name, text in last.items() if not (new_profile and name == "pitch")}, **given}
        if "number" in given:
            trials.append(_trial(last, {name: unit for name, (_, unit) in places.items()}, f"{file}: line {line}"))
    numbers = [trial.number for trial in trials]
    twice = sorted({number for number in numbers if numbers.count(number) > 1})
    if twice:
        raise RecordingError("a trial is listed twice", where=str(file), found=twice[0])
    return trials


def _cells(file: Path) -> list[list[str]]:
    """Cells of a text file or of the first sheet of a workbook, as texts."""
    if file.suffix.lower() == ".xlsx":
        from jounce.core.optional import require

        book = require("openpyxl", "io").load_workbook(file, read_only=True, data_only=True)
        sheet = book.worksheets[0]
        return [["" if cell is None else str(cell) for cell in row] for row in sheet.iter_rows(values_only=True)]
    text = file.read_text(encoding="utf-8-sig")
    first = text.partition("\n")[0]
    separator = max(";\t,", key=first.count)
    rows = list(csv.reader(io.StringIO(text), delimiter=separator))
    if separator != ",":
        rows = [[re.sub(r"^(\s*[+-]?\d+),(\d+\s*)$", r"\1.\2", cell) for cell in row] for row in rows]
    return rows


def _headed(row: Sequence[str]) -> dict[str, tuple[int, str]]:
    """Column and unit of each heading of a row that names some."""
    found: dict[str, tuple[int, str]] = {}
    for i, cell in enumerate(row):
        match = re.fullmatch(r"\s*([^\[(]*?)\s*(?:[\[(]\s*([^\])]+?)\s*[\])])?\s*\.?\s*", cell)
        words = match[1].casefold().strip(" .:#") if match else ""
        for name, (unit, known) in _HEADINGS.items():
            if words in known and name not in found and match is not None:
                found[name] = i, match[2] or unit
    return found


def _trial(cells: dict[str, str], units: dict[str, str], where: str) -> TrialRow:
    values: dict[str, Any] = {}
    for name, si in (("speed", "m/s"), ("angle", "rad"), ("pressure", "Pa"), ("pitch", "m")):
        if name in cells and cells[name] not in ("-", "–"):
            values[name] = _size(cells[name], units[name], si, f"{where}: {name}")
    try:
        values["number"] = int(float(cells["number"]))
    except ValueError:
        raise RecordingError("not a number of a trial", where=where, found=cells["number"]) from None
    profile = cells.get("profile", "A")
    if re.match(r"\s*(B|train|five|5)\b", profile, re.IGNORECASE):
        values["count"] = _TRAIN
        inside = re.search(r"(\d*\.\d+|\d+)\s*(mm|cm|m)?\s*$", profile[1:])
        if inside and "pitch" not in values:
            values["pitch"] = _size(f"{inside[1]} {inside[2] or 'm'}", "m", "m", where)
        if "pitch" not in values:
            raise RecordingError(
                "a train without a pitch", where=where, found=profile, allowed='"B 0.10 m", or a column pitch'
            )
    else:
        values.pop("pitch", None)
    return TrialRow.model_validate(values)


def _size(text: str, unit: str, si: str, where: str) -> float:
    try:
        return to_si(text if re.search(r"[A-Za-z°µ]", text) else f"{text} {unit}", si, where=where)
    except DescriptionError as error:
        raise RecordingError(error.what, where=where, found=text, allowed=error.allowed, hint=error.hint) from None
