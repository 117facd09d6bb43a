"""The sheet of a damper, and of a set: forces at standard velocities for each setting, as makers print them."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding
from jounce.core.operation import Texts, operation
from jounce.core.serialise import Plain, plain_table
from jounce.core.text import guard_row
from jounce.core.typed import quantity
from jounce.core.units import positive_si
from jounce.dampers.adjusters import LEVEL, is_clicks
from jounce.dampers.curves import DamperSetting
from jounce.dampers.files import SETTINGS
from jounce.dampers.map import CurveAt, DamperMap
from jounce.dampers.map_files import as_damper_map
from jounce.identify.estimate import Estimate

STANDARD = (0.025, 0.05, 0.13, 0.26, 0.39, 0.52, 1.04)
"""Velocities (m/s) of printed sheets; those that were reached are shown."""
_NEAR = 0.03  # share by which a standard velocity may lie beyond the measured ones


@dataclass(frozen=True)
class SheetRow(Plain):
    """Forces of a damper at one setting and speed.

    Attributes
    ----------
    settings : dict of str to float
        Clicks [1], temperature (K) and gas pressure (Pa).
    speed : float
        Speed of the piston, m/s.
    bump, rebound : Estimate or None
        Force without gas in bump (positive) and in rebound (negative), N; None where the speed was not reached.
    """

    settings: dict[str, float]
    speed: float
    bump: Estimate | None
    rebound: Estimate | None


@dataclass(frozen=True)
class SheetDamper(Plain):
    """A damper on a sheet: its name, serial number, map and forces at the speeds of the sheet.

    Attributes
    ----------
    name, serial : str
        Name of the damper, such as its place in the car, and its serial number.
    map : DamperMap
        Its map.
    rows : tuple of SheetRow
        Forces for each setting and speed.
    """

    left_out = ("map",)
    name: str
    serial: str
    map: DamperMap
    rows: tuple[SheetRow, ...]

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI, with gas force, friction and lag of each setting."""
        settings = [
            {
                n: getattr(s, n)
                for n in ("settings", "gas_force", "gas_stiffness", "friction", "lag")
            }
            for s in self.map.settings
        ]
        return {**super().to_dict(), "settings": plain_table({"": settings})[""]}


@dataclass(frozen=True)
class DamperSheet(Plain):
    """The sheet of a damper, or of a set of dampers.

    Attributes
    ----------
    dampers : tuple of SheetDamper
        The dampers.
    speeds : tuple of float
        Speeds of the tables, m/s.
    remark : str
        What else the head of the sheet says.
    findings : tuple of Finding
        Findings of the maps.
    """

    dampers: tuple[SheetDamper, ...]
    speeds: tuple[float, ...]
    remark: str
    findings: tuple[Finding, ...]

    def cells(self) -> list[list[str | float]]:
        """Return a header and a row for each damper, setting and speed, SI; empty where nothing is known."""
        names = dict.fromkeys(
            name for damper in self.dampers for row in damper.rows for name in row.settings
        )
        header: list[str | float] = ["damper", "serial", *(_heading(name) for name in names)]
        header += ["speed [m/s]"]
        for side in ("bump", "rebound"):
            header += [f"{side} [N]", f"{side} low [N]", f"{side} high [N]"]
        rows = [header]
        for damper in self.dampers:
            for row in damper.rows:
                stated = [row.settings.get(name, "") for name in names]
                forces = [cell for side in (row.bump, row.rebound) for cell in _ends(side)]
                rows.append([damper.name, damper.serial, *stated, row.speed, *forces])
        return rows

    def conditions(self) -> list[list[str | float]]:
        """Return a header and a row for each damper and setting with gas force, friction and lag, SI."""
        names = dict.fromkeys(
            name
            for damper in self.dampers
            for item in damper.map.settings
            for name in item.settings
        )
        values = {"gas_force": "N", "gas_stiffness": "N/m", "friction": "N", "lag": "s"}
        header: list[str | float] = ["damper", "serial", *(_heading(name) for name in names)]
        for name, unit in values.items():
            words = name.replace("_", " ")
            header += [f"{words} [{unit}]", f"{words} low [{unit}]", f"{words} high [{unit}]"]
        rows = [header]
        for damper in self.dampers:
            for item in damper.map.settings:
                stated = [item.settings.get(name, "") for name in names]
                told = [cell for name in values for cell in _ends(getattr(item, name))]
                rows.append([damper.name, damper.serial, *stated, *told])
        return rows

    def table(self) -> str:
        """Write the forces at the speeds of the sheet as CSV, SI."""
        stream = io.StringIO()
        writer = csv.writer(stream, lineterminator="\n")
        for row in self.cells():
            writer.writerow(f"{x:.9g}" if isinstance(x, float) else x for x in guard_row(row))
        return stream.getvalue()

    def sheets(self) -> dict[str, list[list[str | float]]]:
        """Return the sheets of a workbook."""
        return {"forces": self.cells(), "conditions": self.conditions()}


def _heading(name: str) -> str:
    unit = "" if is_clicks(name) else SETTINGS[name]
    return f"{name.replace('_', ' ')} [{unit}]" if unit else name.replace("_", " ")


def _ends(value: Estimate | None) -> list[str | float]:
    known = [math.nan] * 3 if value is None else [value.value, *(value.interval or [math.nan] * 2)]
    return ["" if math.isnan(x) else float(x) for x in known]


@operation(
    "damper sheet",
    named={"names": "name", "serials": "serial", "speeds": "speed"},
    offers=("tables", "figure", "report"),
    page="jounce.report.damper_sheets:sheet_page",
    title="Damper sheet",
    doing="reading",
    example='jounce damper sheet left.csv right.csv --name "front left" --name "front right" --report front.pdf',
)
def damper_sheet(
    maps: Annotated[
        Sequence[DamperMap | str | Path],
        Texts(
            "Damper maps: tables of `jounce damper map --out` or of makers, or folders of records.",
            "MAP...",
        ),
    ],
    *,
    names: Annotated[
        Sequence[str] | None, Texts("Name of each damper, in order; repeat it.", "NAME")
    ] = None,
    serials: Annotated[
        Sequence[str] | None, Texts("Serial number of each damper, in order; repeat it.", "NUMBER")
    ] = None,
    speeds: Annotated[
        Sequence[float | str] | None,
        Texts(
            'Speeds of the table, e.g. "50 mm/s"; repeat it. Default: those of printed sheets.',
            "SPEED",
        ),
    ] = None,
    remark: str = "",
) -> DamperSheet:
    r"""Make the sheet of a damper as makers print it, or of a set: the dampers of an axle beside each other.

    Parameters
    ----------
    maps : sequence of DamperMap, str or Path
        Maps of the dampers, or their files (see :func:`jounce.read_damper_map`).
    names, serials : sequence of str, optional
        Name and serial number of each damper; by default names of the files, or "damper 1", ...
    speeds : sequence of float or str, optional
        Speeds of the tables, m/s; by default 0.025, 0.05, 0.13, 0.26, 0.39, 0.52 and 1.04 m/s as far as they were
        reached.
    remark : str
        What else the head of the sheet says: maker, oil, operator, date.

    Returns
    -------
    DamperSheet
        Force in bump and rebound at each speed and setting with its interval, without gas and with friction; gas
        force, friction and lag. A speed that a setting did not reach has no force: nothing is extrapolated.

    Raises
    ------
    DescriptionError
        If there is no map, names do not match the maps, or a speed is not positive.
    RecordingError, FitError
        If a map cannot be read.

    Examples
    --------
    >>> import tempfile, pathlib
    >>> import jounce as jn
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "left.csv"
    >>> _ = file.write_text("clicks,velocity,force\n0,-0.3,-450\n0,-0.1,-150\n0,0.1,80\n0,0.3,240\n")
    >>> sheet = jn.damper_sheet([file], names=["front left"])
    >>> [(row.speed, round(row.rebound.value), round(row.bump.value)) for row in sheet.dampers[0].rows]
    [(0.13, -195, 104), (0.26, -390, 208)]
    """
    given = [maps] if isinstance(maps, str | Path | DamperMap) else list(maps)
    if not given:
        raise DescriptionError("no damper map is given", where="maps", allowed="one or more")
    read = [as_damper_map(item) for item in given]
    named = names_for(names, "names", len(read)) or [
        Path(item).stem if isinstance(item, str | Path) else f"damper {k}"
        for k, item in enumerate(given, 1)
    ]
    numbers = names_for(serials, "serials", len(read)) or [""] * len(read)
    chosen = STANDARD if speeds is None else tuple(sorted(_speed(value) for value in speeds))
    reached = max(float(np.abs(item.velocity).max()) for made in read for item in made.settings)
    used = tuple(
        speed for speed in chosen if speeds is not None or speed <= reached * (1.0 + _NEAR)
    )
    dampers = []
    for name, serial, made in zip(named, numbers, read, strict=True):
        rows = [
            SheetRow(dict(item.settings), speed, force_at(item, speed), force_at(item, -speed))
            for item in made.settings
            for speed in used
        ]
        known = tuple(row for row in rows if row.bump is not None or row.rebound is not None)
        dampers.append(SheetDamper(name, serial, made, known))
    findings = tuple(item for made in read for item in made.findings)
    return DamperSheet(tuple(dampers), used, remark, findings)


def names_for(given: Sequence[str] | None, where: str, count: int) -> list[str]:
    """Return the names given for dampers, or none; refuse fewer or more than there are dampers.

    Raises
    ------
    DescriptionError
        If there is not one for each damper.
    """
    texts = list(given or ())
    if texts and len(texts) != count:
        raise DescriptionError(
            "one for each damper is required",
            where=where,
            found=str(len(texts)),
            allowed=str(count),
        )
    return texts


def _speed(value: float | str) -> float:
    typed = quantity(value, "m/s", "speeds") if isinstance(value, str) else value
    return positive_si(typed, "m/s", where="speeds")


def force_at(curve: DamperSetting | CurveAt, velocity: float) -> Estimate | None:
    """Return the force (N) of a curve at a velocity (m/s); None beyond what was measured on its side.

    A standard velocity that lies a little beyond the last one is reached by the slope there.
    """
    side = curve.velocity * velocity > 0.0
    at = curve.velocity[side]
    if not len(at) or not np.abs(at).min() * (1.0 - _NEAR) <= abs(velocity) <= np.abs(at).max() * (
        1.0 + _NEAR
    ):
        return None
    inside = float(np.clip(velocity, at.min(), at.max()))
    force, low, high = (
        float(np.interp(inside, at, values[side]))
        for values in (curve.force, curve.low, curve.high)
    )
    force *= velocity / inside
    half = 0.5 * (high - low)
    if math.isnan(half):
        return Estimate(force)
    return Estimate(force, half / LEVEL, (force - half, force + half))
