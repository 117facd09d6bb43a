"""Hardpoints of a rig from a table that was copied from a spreadsheet, beside those that the rig has."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import permutations, product
from typing import Any

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding
from jounce.core.phrases import Phrase
from jounce.core.serialise import to_plain
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import conversion_factor
from jounce.parts.corners import Corner
from jounce.parts.importers.hardpoints import Axle, PointReading, Side, rotation_of, table_in

_UNITS = ("mm", "m", "cm", "inch")
_CLEARLY = 0.5
"""Other axes or units are proposed if the points then lie at most this fraction as far from those of the rig."""
_OWN = "x,y,z"
_WHERE = "table"


@dataclass(frozen=True)
class PointChange:
    """A hardpoint before and after: its name, that in the table, both positions (m), and the distance between (m)."""

    name: str
    theirs: str
    before: tuple[float, float, float]
    after: tuple[float, float, float]
    distance: float


@dataclass(frozen=True)
class PastedPoints(Shown):
    """Hardpoints of a table beside those of a rig.

    Attributes
    ----------
    points : tuple of PointChange
        Points that both have.
    unit, axes : str
        Unit of the table, and its axes that are x, y and z of the rig: ``"-x,-y,z"``.
    is_unit_stated, is_mirrored : bool
        Whether the table (or the caller) states the unit; whether a right corner was mirrored.
    unknown : dict
        Names in the table that are no hardpoint of the rig, with the place of their rows.
    absent : tuple of str
        Hardpoints of the rig that the table lacks: they stay where they are.
    findings : tuple of Finding
        What was skipped or assumed.
    """

    points: tuple[PointChange, ...]
    unit: str
    axes: str
    is_unit_stated: bool
    is_mirrored: bool
    unknown: Mapping[str, str]
    absent: tuple[str, ...]
    findings: tuple[Finding, ...]

    @property
    def changes(self) -> dict[str, float]:
        """Changed coordinates (m) by their paths, as for `Rig.with_changes`."""
        return {
            f"hardpoints.{point.name}[{i}]": point.after[i]
            for point in self.points
            for i in range(3)
            if abs(point.after[i] - point.before[i]) > 1e-9
        }

    def to_dict(self) -> dict[str, Any]:
        """Return plain data with all fields and the changes."""
        return {**to_plain(vars(self)), "changes": self.changes}


def read_pasted_points(
    rig: Corner,
    text: str,
    *,
    unit: str | None = None,
    axes: str | None = None,
    side: Side = "left",
    axle: Axle | None = None,
    names: Mapping[str, str] | None = None,
) -> PastedPoints:
    r"""Read hardpoints of a rig from a table; nothing is changed.

    Separators, names and units are as in `import_hardpoints`, but the table need not be complete. Units and axes that
    are not stated are those that place the points nearest to the rig's.

    Parameters
    ----------
    rig : Corner
        A corner, whose hardpoints are compared.
    text : str
        Rows of a name and three coordinates, with headings or without.
    unit : str, optional
        Unit of the coordinates, such as ``"mm"``.
    axes : str, optional
        Axes of the table that are x (forward), y (left) and z (up): ``"-x,-y,z"`` for x back and y right.
    side : {"left", "right"}
        Corner that is read if the table has two sides. A right corner is mirrored.
    axle : {"front", "rear"}, optional
        Axle that is read if the table has two.
    names : mapping, optional
        Hardpoint of each name in the table that is not recognised.

    Returns
    -------
    PastedPoints
        The points before and after, in m.

    Raises
    ------
    DescriptionError
        If the table has no hardpoint of this rig, a point without three numbers, or one twice; the message names the
        row.

    Examples
    --------
    >>> from jounce.parts import load
    >>> rig = load("kart-double-wishbone")
    >>> found = read_pasted_points(rig, "point\tx\ty\tz\nLBJ\t-6\t-335\t47,5\nUBJ\t9,8\t-303,25\t270,8\n")
    >>> found.unit, found.axes, [(point.name, round(1e3 * point.after[2], 3)) for point in found.points]
    ('mm', '-x,-y,z', [('lower_ball_joint', 47.5), ('upper_ball_joint', 270.8)])
    """
    if unit is not None:
        conversion_factor(unit, "m", where="unit")
    reading = PointReading(table_in(text, _WHERE), side, axle, {**(names or {})})
    own = {name: np.array(place) for name, place in rig.hardpoints.given().items()}
    theirs = dict(reading.points)
    for end in ("bottom", "top"):  # a strut whose ends are those of its spring
        if f"spring_{end}" in theirs and f"spring_{end}" not in own:
            theirs.setdefault(f"strut_{end}", theirs.pop(f"spring_{end}"))
    common = [name for name in own if name in theirs]
    if not common:
        raise DescriptionError(
            "no hardpoint of this rig is in it",
            where=_WHERE,
            found=", ".join(row.name for row in reading.table.rows[:10]),
            allowed=Phrase("rows of {names}", names=", ".join(own)),
            hint="Say which hardpoint each name is.",
        )
    table = np.array([theirs[name] for name in common])
    rigs = np.array([own[name] for name in common])
    stated = unit or reading.table.unit or None
    chosen, turn = _nearest(table, rigs, stated, axes)
    after = table @ turn.T * conversion_factor(chosen, "m")
    is_mirrored = axes is not None and float(np.sum(after[:, 1] * rigs[:, 1])) < 0.0
    if is_mirrored:
        after = after * [1.0, -1.0, 1.0]
    after = np.round(after, 9) + 0.0
    written = _written_names(reading, names or {})
    points = tuple(
        PointChange(
            name,
            written.get(name, name),
            (float(before[0]), float(before[1]), float(before[2])),
            (float(now[0]), float(now[1]), float(now[2])),
            float(np.linalg.norm(now - before)),
        )
        for name, before, now in zip(common, rigs, after, strict=True)
    )
    left_out = {
        row.name: row.where for row in reading.table.rows if row.name not in written.values()
    }
    return PastedPoints(
        points,
        chosen,
        _axes_of(turn),
        stated is not None,
        is_mirrored,
        left_out,
        tuple(name for name in own if name not in theirs),
        tuple(reading.findings),
    )


def _nearest(table: Array, rig: Array, unit: str | None, axes: str | None) -> tuple[str, Array]:
    """Return the unit and the rotation that place the points nearest to the rig's: the usual ones if in doubt."""
    turns = [rotation_of(axes)] if axes is not None else _turns()
    units = [unit] if unit is not None else _UNITS

    def distance(unit: str, turn: Array) -> float:
        return float(np.linalg.norm(table @ turn.T * conversion_factor(unit, "m") - rig))

    usual = min(units, key=lambda name: distance(name, turns[0]))
    pairs = [(name, turn) for name in units for turn in turns]
    best = min(pairs, key=lambda pair: distance(*pair))
    is_better = distance(*best) < _CLEARLY * distance(usual, turns[0])
    return best if is_better else (usual, turns[0])


def _turns() -> list[Array]:
    """Return all ways in which three axes can be named and directed, as they are first."""
    turns = []
    for order in permutations(range(3)):
        for signs in product((1.0, -1.0), repeat=3):
            turn = np.zeros((3, 3))
            turn[range(3), order] = signs
            turns.append(turn)
    return turns


def _axes_of(turn: Array) -> str:
    """Write a rotation as axes: the inverse of `rotation_of`."""
    columns = np.argmax(np.abs(turn), axis=1)
    return ",".join(
        f"{'-' if turn[row, column] < 0.0 else ''}{'xyz'[column]}"
        for row, column in enumerate(columns)
    )


def _written_names(reading: PointReading, names: Mapping[str, str]) -> dict[str, str]:
    """Return the name in the table of each hardpoint that was read."""
    places = {tuple(place): name for name, place in reading.points.items()}
    written: dict[str, str] = {}
    for row in reading.table.rows:
        name = names.get(row.name) or places.get(tuple(row.place))
        if name:
            written.setdefault(name, row.name)
    return written
