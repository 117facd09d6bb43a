"""Force over velocity at one setting of a damper: gas, friction and lag taken apart, each with its interval."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray

from jounce.core.findings import Finding, finding
from jounce.core.results import Shows
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.dampers.knees import Knee, find_knees
from jounce.dampers.loops import Loops, error_of, loops_of, mean_of
from jounce.dampers.runs import PEAK, ReadRun, of_cycles
from jounce.identify.estimate import Estimate, at_least_zero, combine, estimate, student_factor

Reading = Literal["peak", "continuous"]

_SHARES = np.array([0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.97])
"""Velocities of a continuous reading, as shares of the largest: closer where valves open."""
_SLOW = ((0.04, 0.18), (0.04, 0.35), (0.1, 0.35), (0.18, 0.5))
"""Speeds from and to which gas and friction are found, as shares of the peak velocity of the slowest record."""
_SAMPLES = 12  # of a cycle and side, for a cubic
_REACH = 0.985  # share of its peak velocity up to which a record counts
_SAME = 0.05  # peak velocities that differ by less are one
_DISTINCT = 3  # peak velocities from which a curve can be drawn through them
_TURNS = 0.08  # share of the peak velocity below which friction turns round
_ROUGH = 0.01  # share of the force to which a straight slope between windows is right
_TOGETHER = 1e-3  # ratio of singular values below which lag and gas stiffness cannot be told apart
_DEAD = 0.5  # force with rising speed, as a share of that with falling speed, below which the travel is dead
_MISSING = 0.2  # of the largest force: what lacks at least, more than gas stiffness and noise make
_DEAD_STROKE = 0.03  # of the stroke: dead travel that is named; oil that gives way makes 0.023
_UNIFORM = math.sqrt(3.0)  # half width of a uniform distribution in standard deviations


@dataclass(frozen=True)
class DamperSetting(Plain):
    """A damper at one setting.

    Attributes
    ----------
    settings : dict of str to float
        Clicks [1], temperature (K) and gas pressure (Pa) that the records state; empty if they state none.
    files : tuple of str
        Names of its records.
    velocity : array (n,)
        Velocities, m/s, ascending, bump positive.
    force, low, high : array (n,)
        Force (N) without that of the gas, and its 95 % interval; NaN where too few cycles tell one.
    gas_force, gas_stiffness : Estimate
        Force of the gas in mid-stroke, N, and its stiffness, N/m; NaN if no record shows it.
    friction : Estimate
        Dry friction of the seals, N; NaN if no record shows it.
    lag : Estimate
        Delay of the force behind the velocity, s; NaN if no record shows it.
    repeatability : float or None
        Scatter of repeated records, as a share of the force [1]; None without repeats.
    knees : tuple of Knee
        Where the force bends, as its blow-off valves open; none of a side that shows none.
    """

    settings: dict[str, float]
    files: tuple[str, ...]
    velocity: Array
    force: Array
    low: Array
    high: Array
    gas_force: Annotated[Estimate, Shows("gas force in mid-stroke", "N")]
    gas_stiffness: Annotated[Estimate, Shows("gas stiffness", "N/m")]
    friction: Annotated[Estimate, Shows("friction", "N")]
    lag: Annotated[Estimate, Shows("lag of the force", "s")]
    repeatability: Annotated[float | None, Shows("scatter of repeats", "%", 2)]
    knees: tuple[Knee, ...] = ()

    @property
    def damper(self) -> dict[str, Any]:
        """Table to write under ``strut.damper``, SI: gas force and friction are taken out."""
        friction = np.nan_to_num(self.friction.value)
        velocity, force = with_rest(self.velocity, self.force - friction * np.sign(self.velocity))
        return {"kind": "table", "velocity": velocity.tolist(), "force": force.tolist()}


def usual_reading(groups: Sequence[Sequence[ReadRun]]) -> Reading:
    """Choose "peak" if each setting was run at three peak velocities or more, or at plateaus; else "continuous"."""
    enough = all(
        len(_levels(runs)) >= _DISTINCT or all(run.kind == "triangle" for run in runs)
        for runs in groups
    )
    return "peak" if enough else "continuous"


def curve_of(
    runs: Sequence[ReadRun], reading: Reading, largest: float, findings: list[Finding]
) -> DamperSetting:
    """Reduce the records of one setting to a curve; ``largest`` is the largest peak velocity of all settings (m/s)."""
    velocity, width = _windows(largest)
    loops, lag, stiffness = _without_lag(runs, velocity, width)
    lag = _as_instants_allow(lag, runs)
    gas, friction = _at_rest(runs, lag.value, stiffness.value, findings)
    place = " ".join(run.file for run in runs[:2]) + (" ..." if len(runs) > 2 else "")
    for run in runs:
        _name_dead_travel(run, velocity, width, (gas.value, stiffness.value), findings)
    if reading == "peak":
        at, forces = _peak_points(runs)
        narrow = 0.5 * PEAK * np.abs(at)
    else:
        at, forces = _continuous_points(runs, loops)
        narrow = np.interp(at, velocity, width)
    repeatability = _repeatability(runs)
    if repeatability is not None and repeatability > _REPEATS:
        findings.append(
            finding("dampers.repeats_differ", place, repeatability, share=repeatability)
        )
    _name_friction(at, forces, gas, friction, place, findings)
    bends = _bends(at, np.array([item.value for item in forces]), narrow)
    net = [_net(item, gas, bend) for item, bend in zip(forces, bends.tolist(), strict=True)]
    ends = np.array([item.interval or (math.nan, math.nan) for item in net]).reshape(-1, 2)
    return DamperSetting(
        dict(runs[0].settings), tuple(run.file for run in runs),
        at, np.array([item.value for item in net]), ends[:, 0], ends[:, 1],
        _if_told(gas), _if_told(stiffness), _if_told(at_least_zero(friction)), _if_told(lag), repeatability,
        _knees(runs, loops, gas),
    )  # fmt: skip


def _knees(runs: Sequence[ReadRun], loops: Sequence[Loops], gas: Estimate) -> tuple[Knee, ...]:
    """Find knees in the whole loops, whose velocities are closer than peak velocities."""
    at, forces = _continuous_points(runs, loops)
    error = [item.standard_error or 0.0 for item in forces]
    return find_knees(at, np.array([item.value for item in forces]) - gas.value, np.array(error))


def _name_friction(
    velocity: Array, forces: Sequence[Estimate], gas: Estimate, friction: Estimate,
    place: str, findings: list[Finding],
) -> None:  # fmt: skip
    """Name a friction that is a large part of the force even at the largest velocity."""
    if friction.interval is None or not len(velocity):
        return
    k = int(np.argmax(np.abs(velocity)))
    share = friction.interval[0] / abs(forces[k].value - gas.value)
    if share > _FRICTION:
        speed = abs(float(velocity[k]))
        findings.append(
            finding("dampers.friction_rules", place, share, share=share, velocity=speed)
        )


_FRICTION = 0.3  # of the force at the largest velocity


def _as_instants_allow(lag: Estimate, runs: Sequence[ReadRun]) -> Estimate:
    """Widen a lag by a hundredth of the sampling step: no two channels are sampled at the same instant more closely."""
    if lag.interval is None or lag.standard_error is None:
        return lag
    step = max(float(np.median(np.diff(run.motion.time))) for run in runs)
    half = math.hypot(0.5 * (lag.interval[1] - lag.interval[0]), _INSTANT * step)
    error = math.hypot(lag.standard_error, 0.5 * _INSTANT * step)
    return Estimate(lag.value, error, (lag.value - half, lag.value + half))


_INSTANT = 0.01  # of the sampling step


def _if_told(value: Estimate) -> Estimate:
    """Return an estimate with an interval as it is; without one nothing was told, and zero only stands for it."""
    return value if value.interval is not None else Estimate(math.nan)


def _net(force: Estimate, gas: Estimate, bend: float) -> Estimate:
    """Take the gas force from a force; its error and that of a window (N) count."""
    value = force.value - gas.value
    if force.interval is None or force.standard_error is None:
        return Estimate(value)
    halves = [0.5 * (item.interval[1] - item.interval[0]) for item in (force, gas) if item.interval]
    half = math.hypot(*halves, student_factor(math.inf) * bend)
    error = math.hypot(force.standard_error, gas.standard_error or 0.0, bend)
    return Estimate(value, error, (value - half, value + half))


def _bends(velocity: Array, force: Array, width: Array) -> Array:
    """Return the standard error (N) of a mean force in a window where the curve bends.

    In the middle of a window of half width h, the mean over a kink is off by h/4 times the change of slope.
    """
    error = np.zeros(len(velocity))
    for side in (velocity < 0.0, velocity > 0.0):
        at, load = velocity[side], force[side]
        if len(at) > 2:
            change = np.abs(np.diff(np.diff(load) / np.diff(at)))
            change = np.concatenate([change[:1], change, change[-1:]])
            error[side] = 0.25 * width[side] * change / _UNIFORM
    return error


_REPEATS = 0.03  # scatter of repeated records, as a share of their force, that is named


def _windows(largest: float) -> tuple[Array, Array]:
    shares = np.concatenate([-_SHARES[::-1], _SHARES])
    gaps = np.diff(shares)
    half = 0.2 * np.minimum(np.append(gaps, gaps[-1]), np.insert(gaps, 0, gaps[0]))
    return shares * largest, np.minimum(half, 0.012) * largest


def _without_lag(
    runs: Sequence[ReadRun], velocity: Array, width: Array
) -> tuple[list[Loops], Estimate, Estimate]:
    """Find the delay of the force and the stiffness of the gas, and the loops without both.

    At equal velocities a loop differs between rising and falling speed by the gas stiffness times the difference of
    the displacements, and by the slope of the curve times the lag times the difference of the accelerations. Records
    of several frequencies tell them apart; of one, only the shape of the curve does.
    """
    lag, stiffness = Estimate(0.0), Estimate(0.0)
    loops: list[Loops] = []
    for _ in range(3):
        loops = [
            loops_of(
                run.motion,
                run.cycles,
                velocity,
                width,
                acceleration=run.acceleration,
                lag=lag.value,
                stiffness=stiffness.value,
            )
            for run in runs
        ]
        step_lag, step_stiffness = _lag_and_stiffness(runs, loops, velocity)
        lag = _shifted(step_lag, lag.value)
        stiffness = _shifted(step_stiffness, stiffness.value)
        if step_lag.standard_error is None or abs(step_lag.value) < 0.1 * step_lag.standard_error:
            break
    return loops, lag, stiffness


def _shifted(item: Estimate, by: float) -> Estimate:
    ends = None if item.interval is None else (item.interval[0] + by, item.interval[1] + by)
    return Estimate(item.value + by, item.standard_error, ends)


def _lag_and_stiffness(
    runs: Sequence[ReadRun], loops: Sequence[Loops], velocity: Array
) -> tuple[Estimate, Estimate]:
    columns, gaps = [], []
    curve = mean_of(np.stack([mean_of(loop.both) for loop in loops]))
    slope, size = (
        _slopes(velocity, curve),
        float(np.abs(curve[np.isfinite(curve)]).max(initial=0.0)),
    )
    for run, loop in zip(runs, loops, strict=True):
        gap = loop.force[:, 0] - loop.force[:, 1]
        mean, error = mean_of(gap), np.nan_to_num(error_of(gap))
        usable = np.isfinite(mean) & np.isfinite(slope) & (np.abs(velocity) < _REACH * run.peak)
        usable &= np.abs(velocity) > _TURNS * run.peak
        weight = 1.0 / np.sqrt(error[usable] ** 2 + (_ROUGH * size) ** 2)
        away = (loop.displacement[0] - loop.displacement[1])[usable]
        faster = (loop.acceleration[0] - loop.acceleration[1])[usable]
        columns.append(np.stack([-slope[usable] * faster, away], axis=1) * weight[:, np.newaxis])
        gaps.append(mean[usable] * weight)
    values, errors, freedom = _solved(np.concatenate(columns), np.concatenate(gaps))
    if len(columns) >= _RECORDS:
        # Slopes between windows are not those of the curve: what records disagree by counts, too.
        others = np.array(
            [
                _solved(
                    np.concatenate(columns[:k] + columns[k + 1 :]),
                    np.concatenate(gaps[:k] + gaps[k + 1 :]),
                )[0]
                for k in range(len(columns))
            ]
        )
        errors = np.hypot(errors, others.std(axis=0) * math.sqrt(len(columns) - 1.0))
        freedom = len(columns) - 1
    return estimate(values[0], errors[0], freedom), estimate(values[1], errors[1], freedom)


_RECORDS = 3  # from which leaving one out tells how much they disagree


def _solved(matrix: Array, right: Array) -> tuple[Array, Array, int]:
    """Solve for lag and gas stiffness; what cannot be told is zero with an infinite error."""
    sizes = np.linalg.norm(matrix, axis=0)
    values, errors = np.zeros(2), np.full(2, math.inf)
    if len(right) < _EQUATIONS or not np.all(sizes > 0.0):
        return values, errors, 0
    scaled = matrix / sizes
    singular = np.linalg.svd(scaled, compute_uv=False)
    used = [0, 1] if singular[1] > _TOGETHER * singular[0] else [0]
    solution, *_ = np.linalg.lstsq(scaled[:, used], right, rcond=None)
    rest = right - scaled[:, used] @ solution
    freedom = len(right) - len(used)
    spread = np.linalg.inv(scaled[:, used].T @ scaled[:, used]) * float(rest @ rest) / freedom
    values[used], errors[used] = solution / sizes[used], np.sqrt(np.diag(spread)) / sizes[used]
    return values, errors, freedom


_EQUATIONS = 6


def _slopes(velocity: Array, curve: Array) -> Array:
    """Return the slope of a curve on either side of rest, where it may jump by the friction."""
    slope = np.full(len(curve), np.nan)
    for side in (velocity < 0.0, velocity > 0.0):
        known = np.flatnonzero(side & np.isfinite(curve))
        if len(known) > 2:
            slope[known] = np.gradient(curve[known], velocity[known])
    return slope


def _at_rest(
    runs: Sequence[ReadRun], lag: float, stiffness: float, findings: list[Finding]
) -> tuple[Estimate, Estimate]:
    """Extrapolate bump and rebound to rest: their mean is the gas force, half their difference the friction.

    A parabola and a cubic are fitted in each cycle; what they differ by is counted as uncertain, too. Of several
    windows of speed that with the least error counts: in the slowest, seals may still creep before they slide. Where
    slow samples are too few, the static force of the slowest record is the gas force, and the friction is unknown.
    """
    slowest = min(runs, key=lambda run: run.peak)
    windows = [(first * slowest.peak, last * slowest.peak) for first, last in _SLOW]
    fastest = max(last for _, last in windows)
    slow = [_Slow.of(run, fastest, lag, stiffness) for run in runs]
    ends = [pair for window in windows if (pair := _ends_in(slow, window))]
    if ends:
        return min(
            ends, key=lambda pair: math.hypot(*(item.standard_error or 0.0 for item in pair))
        )
    if not slowest.has_slow_samples:
        findings.append(finding("dampers.gas_unknown", slowest.file))
        return Estimate(0.0), Estimate(0.0)
    return slowest.rest, Estimate(0.0)


@dataclass(frozen=True)
class _Slow:
    """The slow samples of a record, without lag and gas stiffness: velocity (m/s) and force (N), by cycle."""

    velocity: Array
    force: Array
    cycles: NDArray[np.int64]
    count: int

    @classmethod
    def of(cls, run: ReadRun, fastest: float, lag: float, stiffness: float) -> _Slow:
        motion = run.motion
        velocity = motion.velocity - lag * run.acceleration
        near = np.flatnonzero((np.abs(velocity) <= fastest) & (run.cycles >= 0))
        force = motion.force[near] - stiffness * motion.displacement[near]
        return cls(velocity[near], force, run.cycles[near], run.count)


def _ends_in(
    slow: Sequence[_Slow], window: tuple[float, float]
) -> tuple[Estimate, Estimate] | None:
    """Return gas force and friction as the samples of a window of speed (m/s) tell them; None with too few cycles."""
    sides: list[list[tuple[Array, Array]]] = [[], []]  # of gas and friction, by record
    for part in slow:
        bump, rebound = (_intercepts(part, sign, window) for sign in (1.0, -1.0))
        both = np.isfinite(bump[1]) & np.isfinite(rebound[1])
        if both.any():
            for way, results in zip((1.0, -1.0), sides, strict=True):
                parabola, cubic = (
                    0.5 * (up + way * down)[both] for up, down in zip(bump, rebound, strict=True)
                )
                results.append((parabola, cubic))
    if sum(len(parabola) for parabola, _ in sides[0]) < 2:
        return None
    gas, friction = (_pooled(side) for side in sides)
    return gas, friction


def _pooled(records: Sequence[tuple[Array, Array]]) -> Estimate:
    """Estimate the mean of all cycles of all records; records that differ by more than their cycles count so."""
    parabola, cubic = (np.concatenate(part) for part in zip(*records, strict=True))
    count = len(parabola)
    error = float(parabola.std(ddof=1)) / math.sqrt(count)
    if len(records) > 1:
        means = np.array([part.mean() for part, _ in records])
        error = max(error, float(means.std(ddof=1)) / math.sqrt(len(means)))
    bend = float(np.mean(cubic - parabola)) / _UNIFORM
    return estimate(float(parabola.mean()), math.hypot(error, bend), count - 1)


def _intercepts(slow: _Slow, sign: float, within: tuple[float, float]) -> tuple[Array, Array]:
    """Return the force (N) to which a parabola and a cubic lead at rest, in each cycle; NaN with too few samples."""
    speed = sign * slow.velocity
    near = np.flatnonzero((speed >= within[0]) & (speed <= within[1]))
    cycles, share, force = slow.cycles[near], speed[near] / within[1], slow.force[near]

    def total(weights: Array) -> Array:
        return np.bincount(cycles, weights, minlength=slow.count).astype(float)

    powers = np.stack([total(share**k) for k in range(7)])
    loads = np.stack([total(force * share**k) for k in range(4)])
    enough = powers[0] >= _SAMPLES
    ends = []
    for degree in (2, 3):
        row = np.arange(degree + 1)
        matrix = np.moveaxis(powers[row[:, np.newaxis] + row], -1, 0)[enough]
        end = np.full(slow.count, math.nan)
        if enough.any():
            end[enough] = np.linalg.solve(matrix, loads[row].T[enough][..., np.newaxis])[:, 0, 0]
        ends.append(end)
    return ends[0], ends[1]


def _levels(runs: Sequence[ReadRun]) -> list[list[ReadRun]]:
    """Put records of one peak velocity together, slowest first."""
    levels: list[list[ReadRun]] = []
    for run in sorted(runs, key=lambda item: item.peak):
        if levels and run.peak < (1.0 + _SAME) * levels[-1][0].peak:
            levels[-1].append(run)
        else:
            levels.append([run])
    return levels


def _peak_points(runs: Sequence[ReadRun]) -> tuple[Array, tuple[Estimate, ...]]:
    points: list[tuple[float, Estimate]] = []
    for level in _levels(runs):
        read = [run.peak_forces for run in level]
        for side in (0, 1):
            velocity = float(np.mean([mean_of(v[side]) for v, _ in read]))
            points.append((velocity, combine([of_cycles(f[side]) for _, f in read])))
    points.sort(key=lambda item: item[0])
    return np.array([velocity for velocity, _ in points]), tuple(force for _, force in points)


def _continuous_points(
    runs: Sequence[ReadRun], loops: Sequence[Loops]
) -> tuple[Array, tuple[Estimate, ...]]:
    velocity, points = [], []
    for k, at in enumerate(loops[0].velocity):
        known = [
            of_cycles(loop.both[:, k])
            for run, loop in zip(runs, loops, strict=True)
            if abs(at) < _REACH * run.peak and np.isfinite(loop.both[:, k]).any()
        ]
        if known:
            velocity.append(float(at))
            points.append(combine(known))
    return np.array(velocity), tuple(points)


def _repeatability(runs: Sequence[ReadRun]) -> float | None:
    """Return the scatter of repeated records of one velocity, as a share of their force; None without repeats."""
    squares, freedom = 0.0, 0
    for level in _levels(runs):
        if len(level) < 2:
            continue
        for side in (0, 1):
            means = np.array([mean_of(run.peak_forces[1][side]) for run in level])
            squares += float(np.var(means) * len(means) / np.mean(means) ** 2)
            freedom += len(means) - 1
    return math.sqrt(squares / freedom) if freedom else None


def _name_dead_travel(
    run: ReadRun, velocity: Array, width: Array, gas: tuple[float, float], findings: list[Finding]
) -> None:
    """Name travel after a reversal in which the force is missing: gas in the oil, or an empty chamber.

    ``gas`` is force (N) and stiffness (N/m) of the gas chamber, which opens slow loops on both sides, too.
    """
    if run.kind not in ("sine", "crank"):
        return
    loop = loops_of(
        run.motion, run.cycles, velocity, width, acceleration=run.acceleration, stiffness=gas[1]
    )
    rising, falling = mean_of(loop.force) - gas[0]
    missing = (rising / falling < _DEAD) & (
        np.abs(falling - rising) > _MISSING * np.abs(np.nan_to_num(falling)).max()
    )
    for side, sign in (("bump", 1.0), ("rebound", -1.0)):
        places = np.flatnonzero(
            missing & (sign * velocity > 0.0) & (np.abs(velocity) < _REACH * run.peak)
        )
        if len(places) == 0:
            continue
        fastest = places[np.argmax(np.abs(velocity[places]))]
        travel = 0.5 * run.motion.stroke - abs(float(loop.displacement[0, fastest]))
        if travel > _DEAD_STROKE * run.motion.stroke:
            findings.append(
                finding("dampers.dead_travel", run.file, travel, side=side, travel=travel)
            )


def with_rest(velocity: Array, force: Array) -> tuple[Array, Array]:
    """Put the point at rest into a curve, where the force is zero."""
    away = np.abs(velocity) > 1e-9
    place = int(np.searchsorted(velocity[away], 0.0))
    return np.insert(velocity[away], place, 0.0), np.insert(force[away], place, 0.0)
