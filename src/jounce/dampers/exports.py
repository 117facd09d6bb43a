"""Tables as damper dynos export them, whatever their columns are called: records, whole loops and peak forces.

Makers do not publish their formats, and owners rearrange them: columns are told from their units, and from words where
several have the same one. A table of a whole loop without time gets its time from displacement and velocity, if its
rows are equally spaced. A table of peak forces has no loop.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from jounce.core.columns import Column, ColumnTable, columns_in, text_of, time_column
from jounce.core.errors import RecordingError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import conversion_factor
from jounce.dampers.conditions import (
    BUMP,
    GAS,
    REBOUND,
    adjuster_of,
    conditions_in,
    kelvin,
    unit_of,
    words_of,
)
from jounce.recordings import recording
from jounce.recordings.cells import cells_of_file, cells_of_text
from jounce.recordings.options import RecordFile
from jounce.recordings.reader import ReaderOptions
from jounce.recordings.readers import read_signals

if TYPE_CHECKING:
    import xarray as xr

_ABSOLUTE = frozenset(["abs", "absolute", "betrag", "magnitude"])
_TARGET = frozenset(
    ["test", "target", "set", "setpoint", "nominal", "soll", "command", "commanded", "desired"]
)
_FRICTION = frozenset(["drag", "seal", "friction", "reibung"])
_BRANCHES = frozenset(["open", "closed", "opening", "closing", "accel", "decel", "auf", "zu"])
_LENGTHS = frozenset(
    [
        "displacement",
        "disp",
        "displ",
        "position",
        "pos",
        "stroke",
        "travel",
        "weg",
        "hub",
        "deflection",
        "lvdt",
    ]
)
_SPEEDS = frozenset(["velocity", "vel", "speed", "geschwindigkeit", "v"])
_FORCES = frozenset(["force", "load", "kraft"]) | BUMP | REBOUND
_HEAD = 200  # lines, in which conditions are looked for
_LEAST = 50  # rows of a record
_PARTS = 60  # most runs in a file
_UNEVEN = 0.02  # share of the stroke by which rows of equal spacing may miss the displacement
_TEXTS = (".csv", ".txt", ".tsv", ".dat", ".asc", ".prn")


@dataclass(frozen=True)
class PeakTable(Shown):
    """Peak forces of a damper at one setting, as a dyno exports them.

    Parameters
    ----------
    path : str or Path
        The file.
    velocity, force : array (n,)
        Peak velocities (m/s), bump positive, and forces (N), compression positive.
    settings : dict of str to float
        Conditions that the file states, SI.
    gas_force : float or None
        Gas force (N) that the file states; None if it states none.
    findings : sequence of Finding
        How the table was understood.
    sides : {"named", "by_force", "signed", "reversed"}
        What tells bump from rebound: names of columns, the sign of the force, or that of the velocity, whose forces had
        the right sign or the wrong one.
    """

    path: str | Path
    velocity: Array
    force: Array
    settings: Mapping[str, float]
    gas_force: float | None = None
    findings: Sequence[Finding] = ()
    sides: Literal["named", "by_force", "signed", "reversed"] = "named"

    def with_signs(self, stroke_positive: str | None, force_positive: str | None) -> PeakTable:
        """Exchange bump and rebound if the stated signs require it; names of columns leave nothing open.

        >>> table = PeakTable("a.csv", np.array([0.1]), np.array([200.0]), {}, sides="signed")
        >>> table.with_signs("extension", "tension").velocity
        array([-0.1])
        """
        extends, pulls = stroke_positive == "extension", force_positive == "tension"
        exchanged = {
            "named": False, "by_force": pulls, "signed": extends or pulls, "reversed": extends,
        }  # fmt: skip
        if not exchanged[self.sides]:
            return self
        return replace(self, velocity=-self.velocity, force=-self.force)


def read_export(path: Path, *, sample_time: float | None = None) -> list[RecordFile | PeakTable]:
    """Read the records or tables of peak forces of a file.

    Raises
    ------
    RecordingError
        If displacement, velocity and force cannot be told, or have no units.
    """
    parts: list[RecordFile | PeakTable] = []
    tables = _tables(path)
    for number, (head, table) in enumerate(tables, 1):
        conditions = conditions_in(head)
        for run, rows in _runs(table):
            label = ", ".join(filter(None, (f"table {number}" if len(tables) > 1 else "", run)))
            part = _Part(path, label, conditions, [_rows_of(column, rows) for column in table])
            parts.append(part.read(sample_time))
    return parts


# --- files and their parts


def _tables(path: Path) -> list[tuple[list[list[str]], ColumnTable]]:
    """Return each table of a file with the rows above it; a file may repeat its header."""
    suffix = path.suffix.lower()
    lines = text_of(path).splitlines() if suffix in _TEXTS else []
    if not lines:
        table = read_signals(path, ReaderOptions()).columns
        return [(_above(cells_of_file(path)) if suffix == ".xlsx" else [], table)]
    head = next((i for i, line in enumerate(lines[1 : _HEAD + 1]) if _is_row(lines[i + 1])), 0)
    names = next((i for i in range(head, -1, -1) if _has_names(lines[i])), head)
    repeated = [i for i, line in enumerate(lines) if line.strip() == lines[names].strip()]
    if len(repeated) < 2:
        above = _above(cells_of_text("\n".join(lines[:_HEAD])))
        return [(above, read_signals(path, ReaderOptions()).columns)]
    starts = [_first_after_rows(lines, i) for i in repeated]
    return [
        (
            cells_of_text("\n".join(lines[start:at])) if start < at else [],
            columns_in("\n".join(lines[at:end]) + "\n", path, 0),
        )
        for start, at, end in zip(starts, repeated, [*starts[1:], len(lines)], strict=True)
    ]


def _is_row(line: str) -> bool:
    """Whether a line has two numbers or more, and no letters except exponents."""
    return bool(line.strip()) and not set(line) - set("0123456789.,;+-eE \t\"") and len(
        line.replace(";", " ").replace("\t", " ").replace(", ", " ").replace(",", " ").split()
    ) > 1  # fmt: skip


def _has_names(line: str) -> bool:
    return len(words_of(line)) > 1 and not conditions_in(cells_of_text(line))


def _first_after_rows(lines: Sequence[str], at: int) -> int:
    """Return the first line of the block of text that ends at a line."""
    while at > 0 and not _is_row(lines[at - 1]):
        at -= 1
    return at


def _above(cells: Sequence[Sequence[str]]) -> list[list[str]]:
    """Return the rows above the first row of numbers."""
    above: list[list[str]] = []
    for row in cells[:_HEAD]:
        filled = [cell for cell in row if cell.strip()]
        if len(filled) > 1 and all(_is_row(f"{cell} 0") for cell in filled):
            break
        above.append(list(row))
    return above


def _runs(table: ColumnTable) -> list[tuple[str, NDArray[np.intp]]]:
    """Split a table where a target or the clicks change, or where its time starts again: rows of each run."""
    usable = [column for column in table if column.fault is None]
    rows = len(usable[0].values) if usable else 0
    changes = np.zeros(max(rows - 1, 0), dtype=bool)
    labels = []
    for column in usable:
        words = words_of(column.name)
        steps = np.diff(column.values)
        if words & _TARGET or adjuster_of(words):
            places = np.flatnonzero(steps)
            parts = np.diff([0, *(places + 1), rows])
            if 0 < len(places) < _PARTS and (adjuster_of(words) or parts.min() >= _LEAST):
                changes |= steps != 0.0
                labels.append(column)
        elif column is time_column(usable):
            changes |= steps < 0.0
    ends = [0, *(np.flatnonzero(changes) + 1).tolist(), rows]
    if len(ends) == 2 or len(ends) > _PARTS:
        return [("", np.arange(rows))]
    return [
        (
            ", ".join(f"{column.values[first]:g}" for column in labels) or f"part {k}",
            np.arange(first, end),
        )
        for k, (first, end) in enumerate(pairwise(ends), 1)
    ]  # fmt: skip


def _rows_of(column: Column, rows: NDArray[np.intp]) -> Column:
    return column if column.fault is not None else replace(column, values=column.values[rows])


# --- columns and their meaning


@dataclass(frozen=True)
class _Part:
    """A part of a file that is one record, or one table of peak forces."""

    path: Path
    label: str
    conditions: Mapping[str, float]
    columns: Sequence[Column]

    @property
    def name(self) -> str:
        return f"{self.path} ({self.label})" if self.label else str(self.path)

    def read(self, sample_time: float | None) -> RecordFile | PeakTable:
        """Read the part as what its columns show: a record, or peak forces."""
        forces = {
            side: self._of("N", words, without=_FRICTION | (GAS if side else BUMP | REBOUND | GAS))
            for side, words in (("bump", BUMP), ("rebound", REBOUND), ("", frozenset[str]()))
        }
        moves = [item for item in self._of("m", _LENGTHS) if not words_of(item.name) & _TARGET]
        sides = [*forces["bump"], *forces["rebound"]]
        if moves and self._is_long(moves[0]):
            loads = forces[""] or (sides if len(sides) == 1 else [])
            return self._record(
                self._single(moves, "m", _LENGTHS, "displacement"),
                self._single(loads, "N", _FORCES, "force"),
                sample_time,
            )
        if sides:
            return self._peaks(forces["bump"], forces["rebound"])
        self._refuse_unscaled()
        return self._signed_peaks(self._single(forces[""], "N", _FORCES, "force"))

    def _filled(self, column: Column, si: str) -> Array:
        """Return the values of a column in SI; NaN in empty cells, which the side with fewer velocities has."""
        if column.fault is None or column.part is None:
            return column.in_si(si)
        rows, numbers = column.part
        values = np.full(max(len(item.values) for item in self.columns), np.nan)
        if int(rows.max()) >= len(values):
            raise column.fault
        values[rows] = numbers
        return values * conversion_factor(column.unit, si)

    def _is_long(self, moved: Column) -> bool:
        """Whether a displacement moves over so many rows that it is no column of strokes."""
        return len(moved.values) >= _LEAST and float(np.ptp(moved.values)) > 0.0

    def _of(
        self, si: str, words: frozenset[str], *, without: frozenset[str] = frozenset()
    ) -> list[Column]:
        """Return the columns of a kind, in units that jounce reads; of several, those that the words are about."""
        kind = [
            replace(column, unit=unit)
            for column in self.columns
            if (unit := unit_of(column.unit, si)) and not words_of(column.name) & without
        ]
        if si != "N":
            return kind
        return [item for item in kind if not words or words_of(item.name) & words]

    def _single(self, columns: list[Column], si: str, words: frozenset[str], what: str) -> Column:
        named = [item for item in columns if words_of(item.name) & words] or columns
        if len(named) == 1:
            return named[0]
        bare = [
            item.label
            for item in self.columns
            if words_of(item.name) & (words or _FORCES) and not unit_of(item.unit, si)
        ]
        if bare and not named:
            raise RecordingError(
                Phrase("the {what} has no unit, or one of something else", what=what),
                where=self.name, found=", ".join(bare), allowed=Phrase("a unit that converts to {si}", si=si),
                hint="Write the unit into the header: Velocity [in/s]. Volts need the sensor's sensitivity (sensors).",
            )  # fmt: skip
        raise RecordingError(
            Phrase("the column of the {what} cannot be told", what=what), where=self.name,
            found=", ".join(item.label for item in named or self.columns),
            allowed="displacement, velocity and force, or peak forces in bump and rebound over velocity",
            hint="Map columns to channels with columns, with their units.",
        )  # fmt: skip

    def _refuse_unscaled(self) -> None:
        """Refuse a displacement in volts: without it, a loop would be read as peak forces."""
        for column in self.columns:
            if words_of(column.name) & _LENGTHS and not unit_of(column.unit, "m"):
                self._single([], "m", _LENGTHS, "displacement")

    # --- records

    def _record(self, moved: Column, force: Column, sample_time: float | None) -> RecordFile:
        findings: list[Finding] = []
        x, f = moved.in_si("m"), force.in_si("N")
        speeds = self._of("m/s", _SPEEDS)
        real = [item for item in speeds if not words_of(item.name) & _TARGET]
        v = self._single(real, "m/s", _SPEEDS, "velocity").in_si("m/s") if real else None
        clock = time_column(self.columns)
        if v is not None and float(v.min()) >= 0.0 and float(v.max()) > 0.0:
            v = None if clock is not None else v * _directions(x)
            findings.append(finding("dampers.velocity_absolute", self.name))
        if clock is not None:
            time = clock.in_si("s")
        elif sample_time is not None:
            time = np.arange(len(x), dtype=float) * sample_time
        elif v is not None:
            step = self._step(x, v)
            findings.append(finding("dampers.time_rebuilt", self.name, step, step=step))
            time = np.arange(len(x), dtype=float) * step
        else:
            raise RecordingError(
                "neither time nor velocity", where=self.name,
                found=", ".join(item.label for item in self.columns),
                hint="Give the sample time (sample_time).",
            )  # fmt: skip
        channels = {"displacement": (x, "m", ""), "force": (f, "N", "")}
        if v is not None:
            channels["velocity"] = (v, "m/s", "")
        data: xr.Dataset = recording(time, channels)
        return RecordFile(
            self.name, data.assign_attrs(conditions=self._settings()), tuple(findings)
        )

    def _step(self, x: Array, v: Array) -> float:
        """Return the time (s) between rows, which turns the sum of velocities into the displacement."""
        summed = np.concatenate([[0.0], np.cumsum(0.5 * (v[1:] + v[:-1]))])
        moved, path = x - x.mean(), summed - summed.mean()
        step = abs(float(moved @ path) / max(float(path @ path), 1e-300))
        sign = 1.0 if float(moved @ path) > 0.0 else -1.0
        away = float(np.abs(moved - sign * step * path).max()) / float(np.ptp(x))
        if away > _UNEVEN or step == 0.0:
            raise RecordingError(
                "no time, and the rows are not equally spaced: the velocity does not lead to the displacement",
                where=self.name, found=f"{100.0 * away:.0f} % of the stroke",
                hint="Export the time, or give the sample time (sample_time).",
            )  # fmt: skip
        return step

    # --- peak forces

    def _peaks(self, bump: list[Column], rebound: list[Column]) -> PeakTable:
        speeds = self._of("m/s", _SPEEDS)
        own = [item for item in speeds if not words_of(item.name) & _TARGET] or speeds
        points: list[tuple[Array, Array]] = []
        for sign, words, others, columns in ((1.0, BUMP, REBOUND, bump), (-1.0, REBOUND, BUMP, rebound)):  # fmt: skip
            if not columns:
                continue
            named = [item for item in own if words_of(item.name) & words]
            at = self._single(
                named or [item for item in own if not words_of(item.name) & others],
                "m/s", _SPEEDS, "velocity",
            )  # fmt: skip
            force = self._mean_force(columns)
            known = np.isfinite(force) & np.isfinite(speed := self._filled(at, "m/s"))
            points.append((sign * np.abs(speed[known]), force[known]))
        forces = _compression_positive(points)
        velocity = np.concatenate([v for v, _ in points])
        return self._table(velocity, np.concatenate(forces), [])

    def _mean_force(self, columns: list[Column]) -> Array:
        """Return the force of a side; of both branches of a loop (open, closed) their mean."""
        if len(columns) > 1 and not all(words_of(item.name) & _BRANCHES for item in columns):
            columns = [self._single(columns, "N", frozenset(), "force")]
        mean: Array = np.mean([self._filled(item, "N") for item in columns], axis=0)
        return mean

    def _signed_peaks(self, force: Column) -> PeakTable:
        """Read force over velocity in one column each; a loop without displacement is refused."""
        speeds = self._of("m/s", _SPEEDS)
        own = [item for item in speeds if not words_of(item.name) & _TARGET] or speeds
        v, f = self._single(own, "m/s", _SPEEDS, "velocity").in_si("m/s"), force.in_si("N")
        turns = np.count_nonzero(np.diff(np.sign(np.diff(v))))
        if len(v) >= _LEAST and turns:
            raise RecordingError(
                "a loop of force over velocity without displacement", where=self.name,
                hint="Export the displacement, too: gas force and lag cannot be told apart without it.",
            )  # fmt: skip
        if float(v.min()) >= 0.0 and float(f.min()) < 0.0 < float(f.max()):
            by_force = [finding("dampers.peaks_by_force", self.name)]
            signed = v * np.where(f < 0.0, -1.0, 1.0)
            return replace(self._table(signed, f, by_force), sides="by_force")
        if float(v @ f) < 0.0:
            turned = [finding("dampers.peaks_reversed", self.name)]
            return replace(self._table(v, -f, turned), sides="reversed")
        return replace(self._table(v, f, []), sides="signed")

    def _table(self, velocity: Array, force: Array, findings: list[Finding]) -> PeakTable:
        gas = [item for item in self._of("N", GAS) if not words_of(item.name) & _FRICTION]
        stated = (
            float(gas[0].in_si("N").mean()) if len(gas) == 1 else self.conditions.get("gas_force")
        )
        return PeakTable(self.name, velocity, force, self._settings(), stated, tuple(findings))

    def _settings(self) -> dict[str, float]:
        """Return the conditions of the part: of its columns, else of the rows above the table."""
        settings = {key: value for key, value in self.conditions.items() if key != "gas_force"}
        for column in self.columns:
            if column.fault is not None:
                continue
            words, mean = words_of(column.name), float(column.values.mean())
            unit = column.unit or column.name.rpartition("(")[2].rstrip(")")
            temperature = kelvin(mean, unit) if any(w.startswith("temp") for w in words) else None
            if temperature is not None:
                settings["temperature"] = temperature
            elif words & GAS and (spelt := unit_of(column.unit, "Pa")):
                settings["gas_pressure"] = mean * conversion_factor(spelt, "Pa")
            elif (name := adjuster_of(words)) and float(np.ptp(column.values)) == 0.0:
                settings[name] = mean
        return settings


def _directions(displacement: Array) -> Array:
    """Return the direction of motion (+1, -1) at each row, over some rows so that noise does not matter."""
    half = max(1, len(displacement) // 400)
    padded = np.pad(displacement, half, mode="reflect", reflect_type="odd")
    directions: Array = np.sign(padded[2 * half :] - padded[: -2 * half])
    return directions


def _compression_positive(points: Sequence[tuple[Array, Array]]) -> list[Array]:
    """Give forces of bump and rebound the signs with which the damper dissipates at its largest velocity."""
    forces = []
    for velocity, force in points:
        fastest = int(np.argmax(np.abs(velocity)))
        forces.append(force if float(force[fastest] * velocity[fastest]) >= 0.0 else -force)
    return forces
