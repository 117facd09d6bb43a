"""One record of a damper rig: its motion, its cycles, and what they show of gas, friction, lag and fade."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import JounceError
from jounce.core.findings import Finding, finding
from jounce.core.results import Shows
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.dampers.loops import acceleration_of, cycle_numbers, mean_of
from jounce.identify.damper_record import DamperMotion, columns_of, read_motion
from jounce.identify.estimate import Estimate, estimate, mean_of_replicates
from jounce.identify.signs import ForcePositive, StrokePositive, static_force
from jounce.recordings.options import RecordFile

MotionKind = Literal["sine", "crank", "triangle", "ramp", "random"]

_SECOND = (
    0.02  # second harmonic of a stroke, as a share of the first: a crank; a scotch yoke has none
)
_SINE = 0.98  # share of the variance of a stroke in its first two harmonics
_STEADY = 0.85  # median of the speed over its largest: a triangle has 1, a sine 0.71
_CYCLIC = 2.0  # cycles from which a motion is one
_UNEVEN = 0.1  # scatter of the strokes of cycles, as a share: not yet, or no longer, steady
_ONE_PERIOD = 0.05  # differences of the lengths of cycles, as a share
_TREND = 5  # cycles from which a trend over them is told
_FADES = 0.02  # change of the force over a record that is named
PEAK = 0.05  # share of the largest speed below it that counts as peak velocity
_BESIDE_FRICTION = 0.2  # of the force that rubs: its two directions do not cancel more closely
_CLEAR_GAS = 0.03  # share of the force from which that of the gas is neither lag nor friction
_NEAR_REST = 0.1  # share of the peak velocity up to which samples are slow
_SHARE_NEAR_REST = 0.02  # of the samples: a sine has 0.06, a triangle next to none


@dataclass(frozen=True)
class DynoRun(Plain):
    """A record of a damper rig.

    Attributes
    ----------
    file : str
        Name of the file.
    settings : dict of str to float
        Settings at which it was taken, SI.
    motion : {"sine", "crank", "triangle", "ramp", "random"}
        What drove the damper.
    stroke, peak_velocity : float
        Largest minus smallest displacement (m); usual peak velocity of a cycle (m/s).
    cycles : int
        Whole cycles; of a record without cycles, the parts it was divided into.
    stroke_positive, force_positive : str
        Positive directions in the record, as stated or found.
    peak_bump_force, peak_rebound_force : Estimate
        Force at peak velocity in bump and in rebound (N), gas included.
    fade : Estimate
        Change of the force from the first cycle to the last, as a share [1]; NaN with less than five.
    energy_per_cycle : float
        Work done on the damper in a cycle, J.
    """

    file: Annotated[str, Shows("file")]
    settings: dict[str, float]
    motion: Annotated[MotionKind, Shows("motion")]
    stroke: Annotated[float, Shows("stroke", "m")]
    peak_velocity: Annotated[float, Shows("peak velocity", "m/s")]
    cycles: Annotated[int, Shows("cycles")]
    stroke_positive: StrokePositive
    force_positive: ForcePositive
    peak_bump_force: Annotated[Estimate, Shows("bump at peak velocity", "N")]
    peak_rebound_force: Annotated[Estimate, Shows("rebound at peak velocity", "N")]
    fade: Annotated[Estimate, Shows("change over the record")]
    energy_per_cycle: Annotated[float, Shows("energy per cycle", "J")]


@dataclass(frozen=True)
class ReadRun:
    """A record that has been read, with what later steps need of it."""

    record: RecordFile
    settings: Mapping[str, float]
    motion: DamperMotion
    cycles: NDArray[np.int64]
    acceleration: Array
    findings: list[Finding] = field(default_factory=list)

    @property
    def file(self) -> str:
        """Name of the file."""
        return Path(self.record.path).name

    @cached_property
    def rest(self) -> Estimate:
        """Force at rest, N; 0 without an interval if the record does not show it."""
        motion = self.motion
        if not self.has_slow_samples:
            return Estimate(0.0)
        return static_force(motion.displacement, motion.velocity, motion.force)

    @property
    def gas_share(self) -> float:
        """Force at rest as a share of the range of the force [1]."""
        return self.rest.value / float(np.ptp(self.motion.force))

    @property
    def is_clear(self) -> bool:
        """Whether the force at rest shows which signs are right: it must stand out from what rubs or yields, too."""
        if abs(self.gas_share) <= _CLEAR_GAS:
            return False
        speed = np.abs(self.motion.velocity)
        slow = self.motion.force[speed < _NEAR_REST * np.quantile(speed, 0.99)]
        rubs = float(np.median(np.abs(slow - self.rest.value)))
        return abs(self.rest.value) > _BESIDE_FRICTION * rubs

    @cached_property
    def starts(self) -> NDArray[np.int64]:
        """First sample of each cycle, and the one after the last."""
        inside = np.flatnonzero(self.cycles >= 0)
        first = inside[np.flatnonzero(np.diff(self.cycles[inside], prepend=-1))]
        return np.append(first, inside[-1] + 1)

    @property
    def count(self) -> int:
        """Number of whole cycles."""
        return len(self.starts) - 1

    @cached_property
    def peak(self) -> float:
        """Usual peak velocity of a cycle, m/s."""
        return float(np.median(self.largest(np.abs(self.motion.velocity))))

    @property
    def has_slow_samples(self) -> bool:
        """Whether the record shows the force at rest: plateaus of velocity do not."""
        speed = np.abs(self.motion.velocity)
        slow = speed < _NEAR_REST * np.quantile(speed, 0.99)
        return float(np.mean(slow)) > _SHARE_NEAR_REST

    @property
    def has_one_period(self) -> bool:
        """Whether all cycles are of one length, though their strokes may grow or shrink."""
        lengths = np.diff(self.starts)
        is_cyclic = self.count > 1 and bool((self.cycles < 0).any())
        return is_cyclic and float(np.ptp(lengths)) < _ONE_PERIOD * float(lengths.mean())

    @cached_property
    def kind(self) -> MotionKind:
        """What drove the damper, told from the shape of the stroke."""
        if self.count > 1 and self.motion.cycles < _CYCLIC:
            return "ramp"
        if self.count > 1 and (self.cycles >= 0).all():  # parts, not cycles
            return "random"
        whole = slice(self.starts[0], self.starts[-1])
        speed, x = np.abs(self.motion.velocity[whole]), self.motion.displacement[whole]
        if float(np.median(speed)) > _STEADY * float(np.quantile(speed, 0.99)):
            return "triangle"
        lengths = np.diff(self.starts)
        since = np.arange(len(x)) - np.repeat(self.starts[:-1] - self.starts[0], lengths)
        phase = 2.0 * math.pi * since / np.repeat(lengths, lengths)
        first, second = (abs(np.mean((x - x.mean()) * np.exp(-1j * k * phase))) for k in (1, 2))
        if 2.0 * (first**2 + second**2) < _SINE * float(np.var(x)):
            return "random"
        return "crank" if second > _SECOND * first else "sine"

    @cached_property
    def peak_forces(self) -> tuple[Array, Array]:
        """Velocity (m/s) and force (N) at peak velocity, in bump and in rebound, of each cycle: (2, cycles)."""
        velocity, force = np.full((2, self.count), np.nan), np.full((2, self.count), np.nan)
        first, last = self.starts[0], self.starts[-1]
        cycles = self.cycles[first:last]
        for side, sign in enumerate((1.0, -1.0)):
            speed = sign * self.motion.velocity
            near = np.flatnonzero(speed[first:last] > (1.0 - PEAK) * self.largest(speed)[cycles])
            number = np.bincount(cycles[near], minlength=self.count)
            for values, means in ((self.motion.velocity, velocity), (self.motion.force, force)):
                means[side] = np.bincount(cycles[near], values[first + near], minlength=self.count)
                means[side] /= np.where(number > 0, number, np.nan)
        return velocity, force

    def largest(self, values: Array) -> Array:
        """Return the largest value in each cycle."""
        largest: Array = np.maximum.reduceat(values[: self.starts[-1]], self.starts[:-1])
        return largest


def read_run(
    record: RecordFile,
    settings: Mapping[str, float],
    *,
    stroke_positive: StrokePositive | None,
    force_positive: ForcePositive | None,
) -> ReadRun:
    """Read a record: compression positive, cut to the motion, its cycles numbered.

    Raises
    ------
    JounceError
        If displacement or force is missing, or the record has no motion.
    """
    name = Path(record.path).name
    motion, findings = read_motion(
        *columns_of(record.data, None, None, None, name),
        stroke_positive=stroke_positive,
        force_positive=force_positive,
        name=name,
    )
    told = [item for item in findings if item.severity != "note"]
    cycles = cycle_numbers(motion.displacement)
    run = ReadRun(record, settings, motion, cycles, acceleration_of(motion), told)
    if run.kind in ("sine", "crank", "triangle") or run.has_one_period:
        strokes = _strokes(run)
        uneven = float(np.ptp(strokes) / strokes.mean())
        if uneven > _UNEVEN:
            told.append(finding("dampers.not_steady", name, uneven, share=uneven))
    return run


def turned_by_gas(runs: Sequence[ReadRun]) -> list[ReadRun]:
    """Give records the signs with which the gas pushes, where it is clear; the others those of most of these.

    In a fast record the force at rest is small beside the rest, and late: only a gas force that is a clear share of the
    force decides. A record that would feed energy with the signs of the others keeps its own.
    """
    clear = [run if run.gas_share > 0.0 else _turned(run) for run in runs if run.is_clear]
    if not clear:
        return list(runs)
    most, _ = Counter(_signs_of(run) for run in clear).most_common(1)[0]
    sure = {id(run.record): run for run in clear}
    turned = [sure.get(id(run.record)) or _with_signs(run, most) for run in runs]
    for run in turned:
        run.findings[:] = [item for item in run.findings if item.code not in _OPEN_SIGNS]
    return turned


_OPEN_SIGNS = ("identify.signs_of_gas", "identify.bump_or_rebound")
"""What a single record leaves open and the other records settle."""


def _signs_of(run: ReadRun) -> tuple[StrokePositive, ForcePositive]:
    return run.motion.signs.stroke_positive, run.motion.signs.force_positive


def _turned(run: ReadRun) -> ReadRun:
    """Read a record with both signs reversed, and say so."""
    stroke, force = _signs_of(run)
    turned = _with_signs(
        run,
        (
            "compression" if stroke == "extension" else "extension",
            "compression" if force == "tension" else "tension",
        ),
    )
    pull = -run.gas_share * float(np.ptp(run.motion.force))
    turned.findings.append(finding("dampers.both_signs_reversed", run.file, -pull, pull=pull))
    return turned


def _with_signs(run: ReadRun, signs: tuple[StrokePositive, ForcePositive]) -> ReadRun:
    if signs == _signs_of(run):
        return run
    again = read_run(run.record, run.settings, stroke_positive=signs[0], force_positive=signs[1])
    return again if _signs_of(again) == signs else run


def _strokes(run: ReadRun) -> Array:
    x = run.motion.displacement
    return run.largest(x) + run.largest(-x)


def summary_of(run: ReadRun) -> DynoRun:
    """Sum up a record; a force that fades is a finding."""
    motion = run.motion
    _, force = run.peak_forces
    fade = _fade(force)
    if fade.interval and abs(fade.value) > _FADES and not fade.has(0.0):
        run.findings.append(finding("dampers.fades", run.file, fade.value, change=fade.value))
    if run.count == 1:
        run.findings.append(finding("dampers.one_cycle", run.file))
    inside = run.cycles >= 0
    work = float(np.trapezoid(motion.force[inside], motion.displacement[inside]))
    bump, rebound = (of_cycles(side) for side in force)
    return DynoRun(
        run.file, dict(run.settings), run.kind, motion.stroke, run.peak, run.count,
        motion.signs.stroke_positive, motion.signs.force_positive,
        bump, rebound, fade, work / run.count,
    )  # fmt: skip


def of_cycles(values: Array) -> Estimate:
    """Estimate the mean of a force over cycles; NaN without any."""
    known = values[np.isfinite(values)].tolist()
    return mean_of_replicates(known) if known else Estimate(math.nan)


def _fade(force: Array) -> Estimate:
    """Estimate the change of the force from the first cycle to the last, as a share of its mean."""
    size = mean_of(np.abs(force))
    known = np.flatnonzero(np.isfinite(size))
    if len(known) < _TREND:
        return Estimate(math.nan)
    place, share = known - known.mean(), size[known] / size[known].mean()
    power = float(place @ place)
    slope = float(place @ share) / power
    rest = share - 1.0 - slope * place
    span = float(np.ptp(known))
    error = math.sqrt(float(rest @ rest) / (len(known) - 2) / power)
    return estimate(slope * span, error * span, len(known) - 2)


def left_out(path: str | Path, error: JounceError) -> Finding:
    """Report a file that cannot be used."""
    return finding("dampers.file_left_out", Path(path).name, error=error)
