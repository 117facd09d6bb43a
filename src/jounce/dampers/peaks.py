"""Curves from tables of peak forces, which have no loop: force over velocity, and the gas force if it is stated."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from jounce.core.findings import Finding, finding
from jounce.core.types import Array
from jounce.dampers.curves import DamperSetting
from jounce.dampers.exports import PeakTable
from jounce.dampers.runs import of_cycles
from jounce.identify.estimate import Estimate

_REST = 0.005  # share of the largest velocity up to which a row is one at rest
_SAME = 0.02  # peak velocities that differ by less are one
_PART = 0.5  # of the gas force: nearer to none or to all of it


def curve_of_peaks(tables: Sequence[PeakTable], findings: list[Finding]) -> DamperSetting:
    """Make the curve of a setting from its tables of peak forces; repeated tables tell an interval.

    The gas force is taken out if the slowest forces of bump and rebound show that they contain it. What only a loop
    shows (gas stiffness, friction, lag) is NaN.
    """
    names = tuple(Path(table.path).name for table in tables)
    points, gases = [], []
    for table, name in zip(tables, names, strict=True):
        velocity, force, gas = _without_gas(table, name, findings)
        points.append(np.stack([velocity, force]))
        gases.append(gas)
    findings += [item for table in tables for item in table.findings]
    every = np.concatenate(points, axis=1)
    every = every[:, np.argsort(every[0], kind="stable")]
    levels: list[list[int]] = []
    for k, velocity in enumerate(every[0].tolist()):
        if levels and abs(velocity - every[0, levels[-1][0]]) < _SAME * abs(velocity):
            levels[-1].append(k)
        else:
            levels.append([k])
    forces = [of_cycles(every[1, level]) for level in levels]
    ends = np.array([item.interval or (math.nan, math.nan) for item in forces]).reshape(-1, 2)
    known = [gas for gas in gases if not math.isnan(gas)]
    findings.append(finding("dampers.peaks_only", names[0]))
    unknown = Estimate(math.nan)
    return DamperSetting(
        dict(tables[0].settings), names,
        np.array([float(every[0, level].mean()) for level in levels]),
        np.array([item.value for item in forces]), ends[:, 0], ends[:, 1],
        of_cycles(np.array(known)) if known else unknown, unknown, unknown, unknown, None,
    )  # fmt: skip


def _without_gas(
    table: PeakTable, name: str, findings: list[Finding]
) -> tuple[Array, Array, float]:
    """Return velocities and forces without the gas force, and the gas force (NaN if unknown)."""
    slow = np.abs(table.velocity) <= _REST * float(np.abs(table.velocity).max())
    velocity, force = table.velocity[~slow], table.force[~slow]
    gas = table.gas_force
    if slow.any():
        gas = float(table.force[slow].mean()) if gas is None else gas
    if gas is None:
        findings.append(finding("dampers.peaks_gas_unknown", name))
        return velocity, force, math.nan
    sides = [np.flatnonzero(side) for side in (velocity > 0.0, velocity < 0.0)]
    if not all(len(side) for side in sides):
        findings.append(finding("dampers.peaks_gas_unknown", name))
        return velocity, force, gas
    slowest = [side[np.argmin(np.abs(velocity[side]))] for side in sides]
    middle = float(force[slowest].mean())
    contains = middle / gas > _PART if gas else False
    if contains:
        findings.append(finding("dampers.peaks_with_gas", name, gas, gas=gas))
        return velocity, force - gas, gas
    findings.append(finding("dampers.peaks_without_gas", name, gas, gas=gas))
    return velocity, force, gas
