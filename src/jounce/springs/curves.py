"""Force over deflection at one loading speed: the mean of loading and unloading, and what lies between them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from jounce.core.results import Shows
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.identify.estimate import Estimate, mean_of_replicates, student_factor
from jounce.springs.presses import Press, cycle_forces

_POINTS = 40  # deflections of a curve
_TOP = 0.995  # share of the common stroke up to which it goes
_SAMPLES = 5  # of a stroke on either side of a deflection at least
_LEVEL = student_factor(math.inf)
_ALIKE = 0.15  # speeds that differ by less are one
_UNIFORM = math.sqrt(3.0)  # half width of a uniform distribution in standard deviations


@dataclass(frozen=True)
class PressCurve(Plain):
    """Force over deflection at one loading speed.

    Attributes
    ----------
    speed : float
        Loading speed, m/s; NaN if the records have no time.
    files : tuple of str
        Names of its records.
    deflection : array (n,)
        Deflection from contact, m, ascending from 0.
    force, low, high : array (n,)
        Mean of loading and unloading and its 95 % interval, N; of loading alone if no record unloads.
    hysteresis, hysteresis_low, hysteresis_high : array (n,)
        Half of the force by which loading exceeds unloading, N; NaN if no record unloads.
    energy, loss_factor : Estimate
        Energy lost in a cycle (J), and this over 2 pi times the work of loading [1]; NaN without unloading.
    """

    speed: Annotated[float, Shows("loading speed", "m/s")]
    files: tuple[str, ...]
    deflection: Array
    force: Array
    low: Array
    high: Array
    hysteresis: Array
    hysteresis_low: Array
    hysteresis_high: Array
    energy: Annotated[Estimate, Shows("energy lost in a cycle", "J")]
    loss_factor: Annotated[Estimate, Shows("loss factor", "1")]

    @property
    def error(self) -> Array:
        """Standard error of the force, N."""
        half: Array = 0.5 * (self.high - self.low) / _LEVEL
        return half

    @property
    def has_unloading(self) -> bool:
        """Whether the records show the way back."""
        return bool(np.isfinite(self.hysteresis).any())


def by_speed(presses: Sequence[Press]) -> list[list[Press]]:
    """Group records by loading speed, slowest first; those without time last."""
    timed = sorted((p for p in presses if math.isfinite(p.speed)), key=lambda p: p.speed)
    groups: list[list[Press]] = []
    for press in timed:
        if groups and press.speed < (1.0 + _ALIKE) * groups[-1][0].speed:
            groups[-1].append(press)
        else:
            groups.append([press])
    rest = [p for p in presses if not math.isfinite(p.speed)]
    return [*groups, rest] if rest else groups


def window_of(presses: Sequence[Press], reach: float, share: float) -> float:
    """Return the half width of a window (m): a share of the reach, or what has enough samples."""
    spacing = max(
        float(np.median(np.diff(stroke.deflection))) for p in presses for stroke in p.strokes
    )
    return max(share * reach, _SAMPLES * spacing)


def curve_of(presses: Sequence[Press]) -> PressCurve:
    """Make the curve of the records of one speed."""
    reach = min(press.reach for press in presses)
    grid = np.linspace(0.0, _TOP * reach, _POINTS + 1)
    width = window_of(presses, reach, 0.5 / _POINTS)
    means, halves = [], []
    energies, losses = [], []
    for press in presses:
        forces, errors = cycle_forces(press, grid, 2.0 * width)
        narrow, _ = cycle_forces(press, grid, width)
        pair, pair_error = _pairs(forces, errors)
        bend = np.abs(_mean(_pairs(narrow, errors)[0][0]) - _mean(pair[0]))
        means.append([_mean(side) for side in pair])
        common = [
            np.hypot(zero, press.zero.place_error * np.abs(np.gradient(mean, grid)))
            for zero, mean in zip((press.zero.zero_error, 0.0), means[-1], strict=True)
        ]
        halves.append(
            [
                _half(side, error, bend, other)
                for side, error, other in zip(pair, pair_error, common, strict=True)
            ]
        )
        for loading, unloading in forces:
            known = np.isfinite(loading) & np.isfinite(unloading)
            if np.count_nonzero(known) > 2:
                lost = float(np.trapezoid((loading - unloading)[known], grid[known]))
                work = float(np.trapezoid(np.abs(loading[known]), grid[known]))
                energies.append(lost)
                losses.append(lost / (2.0 * math.pi * work))
    values, half = _over_files(np.array(means), np.array(halves))
    force, lost_force = values
    force[0] = 0.0 if all(press.has_zero for press in presses) else force[0]
    known = np.isfinite(force)
    return PressCurve(
        float(np.median([press.speed for press in presses])),
        tuple(press.file for press in presses),
        grid[known], force[known], (force - half[0])[known], (force + half[0])[known],
        lost_force[known], (lost_force - half[1])[known], (lost_force + half[1])[known],
        mean_of_replicates(energies) if energies else Estimate(math.nan),
        mean_of_replicates(losses) if losses else Estimate(math.nan),
    )  # fmt: skip


def _pairs(forces: Array, errors: Array) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """Return mean and half difference of loading and unloading by cycle, with errors; loading without unloading."""
    known = np.asarray(np.isfinite(forces).all(axis=1))
    both = np.asarray(known.any(axis=1))
    if not both.any():
        missing = np.full_like(forces[:, 0], np.nan)
        return (forces[:, 0], missing), (errors[:, 0], missing)
    forces, errors = forces[both], errors[both]
    error = 0.5 * np.hypot(errors[:, 0], errors[:, 1])
    return (
        (0.5 * (forces[:, 0] + forces[:, 1]), 0.5 * (forces[:, 0] - forces[:, 1])),
        (error, error),
    )


def _mean(cycles: Array) -> Array:
    """Return the mean over cycles of what is known."""
    known = np.isfinite(cycles)
    count = known.sum(axis=0)
    mean: Array = np.where(known, cycles, 0.0).sum(axis=0) / np.where(count > 0, count, np.nan)
    return mean


def _half(cycles: Array, errors: Array, bend: Array, common: Array) -> Array:
    """Return half of the 95 % interval of a mean over cycles: noise, scatter, the window, and the zero."""
    count = len(cycles)
    within = _mean(errors**2) / count
    between = _mean((cycles - _mean(cycles)) ** 2) / max(count - 1, 1)
    excess = np.maximum(between - within, 0.0) if count > 1 else 0.0 * within
    factor = student_factor(count - 1) if count > 1 else 0.0
    window = np.maximum(np.nan_to_num(bend) - 2.0 * np.sqrt(within), 0.0) / _UNIFORM
    return np.asarray(np.sqrt(_LEVEL**2 * (within + common**2 + window**2) + factor**2 * excess))


def _over_files(means: Array, halves: Array) -> tuple[Array, Array]:
    """Return the mean over files (files, 2, n) and half of its interval, which contains their scatter."""
    count = len(means)
    own = np.sqrt((halves**2).sum(axis=0)) / count
    if count == 1:
        return means[0], halves[0]
    between = np.var(means, axis=0, ddof=1) / count
    excess = np.maximum(between - (own / _LEVEL) ** 2, 0.0)
    return means.mean(axis=0), np.sqrt(own**2 + student_factor(count - 1) ** 2 * excess)
