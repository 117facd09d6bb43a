"""Periodic steady states of a wheel on its plate, including nonlinearities: lift-off, friction, stops."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from jounce.core.errors import SimulationError
from jounce.core.types import Array
from jounce.mechanics.motions import constant_rate
from jounce.parts.rig import Rig
from jounce.parts.testers import Tester
from jounce.testers.plate_response import LinearTesterRig, linear_rig_on_tester, place_of
from jounce.testers.plates import wrap_phase
from jounce.testers.rig import TesterRig, channel, rig_on_tester

_BLOCK = 1.5  # s between two tests for periodicity
_BLOCKS = 40  # a minute of motion
_REPEATS = 1e-5  # share of the amplitude: largest remaining change of periodic motion
_ROUNDING = 1e-7  # smaller changes are rounding and have no decay rate
_SAMPLES = 512  # per period: sampled extremes of a sine are off by at most a share of 2e-5
_UNSETTLED = 8  # periods examined if the motion does not settle
_STEP = 0.5  # Hz: step of the coarse sweep
_FINE = 0.01  # Hz: resolution of minima


@dataclass(frozen=True)
class Periodic:
    """A steady state at one frequency."""

    frequency: float  # Hz
    settled: bool  # whether the motion repeats every turn; otherwise the values are minima over several turns
    force_min: float  # minimum contact force, N
    force_max: float  # maximum contact force, N
    # EGEA phase angle, rad: from the plate's top to the middle of the turn's low-force half; for nonperiodic motion
    # from the components of plate height and force at the exciter frequency
    phase_angle: float
    values: Mapping[
        str, Array
    ]  # outputs over one turn (512 samples), SI; starts at the plate's mean height
    state: Mapping[str, float]  # at the start of the turn


def periodic(
    on: TesterRig,
    frequency: float,
    *,
    wheel: str = "left",
    start: Mapping[str, float] | None = None,
    tolerance: float = 1e-6,
) -> Periodic:
    """Continue a run of a rig with driven exciters at one frequency (Hz) until it is periodic.

    On an axle one ``wheel`` is excited and the other plate is at rest. The run starts from the state ``start``, e.g.
    that of a nearby frequency, or from the linear model's steady state, with the default tolerance.

    Examples
    --------
    >>> from jounce.parts import load
    >>> from jounce.parts.testers import load_tester
    >>> found = periodic(rig_on_tester(load("audi-a6-quarter-car"), load_tester("eusama")), 16.6)
    >>> found.settled, round(found.force_min / 4954.05, 3)   # of the static load in N
    (True, 0.725)
    """
    if not (np.isfinite(frequency) and frequency > 0.0):
        raise SimulationError(
            "invalid frequency", where="frequency", found=frequency, allowed="above 0 Hz"
        )
    place, rate = place_of(on, wheel), 2.0 * np.pi * frequency
    turns = max(3, int(np.ceil(_BLOCK * frequency)))
    times, angles = np.arange(turns + 1) / frequency, {place: constant_rate(rate)}
    state = (
        dict(start)
        if start is not None
        else _linear_start(linear_rig_on_tester(on), frequency, place)
    )
    settled = False
    for _ in range(_BLOCKS):
        solution = on.run(angles, times, start=state, fastest=rate, tolerance=tolerance)
        ends = solution.states
        state = dict(zip(on.compiled.facts.states, map(float, ends[:, -1]), strict=True))
        settled = _remaining_change(ends, on.scale) < _REPEATS
        if settled:
            break
    length = 1 if settled else _UNSETTLED
    fine = np.arange(length * _SAMPLES) / (_SAMPLES * frequency)
    solution = on.run(angles, fine, start=state, fastest=rate, tolerance=tolerance)
    values = dict(zip(on.compiled.output_names, solution.outputs, strict=True))
    force = values[channel(place, "tyre.force")]
    height = values[channel(place, "plate.z")]
    if settled:
        phase = _phase_angle(force, on.static_load(place)) - _greatest_at(height, 1)
    else:
        phase = np.pi - _greatest_at(height, length) + _greatest_at(force, length)
    phase = float(wrap_phase(phase))
    return Periodic(
        frequency, settled, float(force.min()), float(force.max()), phase, values, state
    )


def _linear_start(linear: LinearTesterRig, frequency: float, place: str) -> dict[str, float]:
    """Return the state at angle 0 of the linear model's steady motion."""
    x = linear.on.rest.x + linear.states(frequency, place).imag
    return dict(zip(linear.on.compiled.facts.states, map(float, x), strict=True))


def _carry_state(
    near: Periodic, linear: LinearTesterRig, frequency: float, place: str
) -> dict[str, float]:
    """Return the state of a nearby frequency, corrected by the linear model's change."""
    there, here = (_linear_start(linear, f, place) for f in (near.frequency, frequency))
    return {name: value + here[name] - there[name] for name, value in near.state.items()}


def _remaining_change(ends: Array, scale: Array) -> float:
    """Return the remaining change of the state at the end of a turn, relative to its scale."""
    changes = np.max(np.abs(np.diff(ends, axis=1)) / scale[:, None], axis=0)
    if changes[-1] < _ROUNDING:
        return float(changes[-1])
    shrinking = min(
        float((changes[-1] / max(changes[0], 1e-300)) ** (1.0 / (len(changes) - 1))), 1.0 - 1e-4
    )
    return float(changes[-1]) / (1.0 - shrinking)


def _phase_angle(force: Array, static: float) -> float:
    """Return the angle (rad) at the middle of the low-force half of the turn, around the minimum force."""
    low = int(np.argmin(force))
    turned = np.roll(force, -low) - static
    up = int(np.argmax(turned > 0.0))
    down = len(turned) - int(np.argmax(turned[::-1] > 0.0))
    after = up - turned[up] / (turned[up] - turned[up - 1])
    before = down - 1 + turned[down - 1] / (turned[down - 1] - turned[down % len(turned)])
    return float(2.0 * np.pi * (low + 0.5 * (after + before - len(turned))) / len(turned))


def _greatest_at(signal: Array, turns: int) -> float:
    """Return the angle (rad) at which the component at the exciter frequency is largest."""
    return float(-np.angle(np.fft.rfft(signal)[turns]))


@dataclass(frozen=True)
class SteadySweep:
    """Steady states of one wheel over the tester's frequencies."""

    adhesion: float  # minimum over static contact force (1)
    adhesion_frequency: float  # frequency of the minimum force, Hz, to 0.01 Hz
    phase_angle: float  # minimum EGEA phase angle in the tester's band, rad
    phase_frequency: float  # frequency of the minimum phase angle, Hz
    force_amplitude_25: float  # half the force range at 25 Hz, N
    lift_off: bool  # whether the wheel leaves the plate
    states: tuple[Periodic, ...]  # all computed states, by frequency


def steady_sweep(rig: Rig, tester: Tester, *, wheel: str = "left") -> SteadySweep:
    """Compute periodic steady states of a wheel from the highest frequency downwards, each from the previous one.

    Minimum adhesion (1) and minimum phase angle (rad) in the tester's band are refined to 0.01 Hz.
    """
    on, limits = rig_on_tester(rig, tester), tester.limits
    highest = max(tester.programme.start_frequency, tester.programme.end_frequency)
    linear, place = linear_rig_on_tester(on), place_of(on, wheel)
    known: dict[float, Periodic] = {}

    def at(frequency: float) -> Periodic:
        key = round(frequency, 6)
        if key not in known:
            above = [f for f in known if f > key]
            start = _carry_state(known[min(above)], linear, key, place) if above else None
            known[key] = periodic(on, key, wheel=wheel, start=start)
        return known[key]

    lowest = min(limits.frequency_min, _STEP)
    grid = np.unique(
        np.append(
            np.arange(lowest, highest, _STEP), [highest, limits.frequency_min, limits.frequency_max]
        )
    )
    for frequency in grid[::-1]:
        at(float(frequency))
    force, here = _refine_minimum(lambda f: at(f).force_min, grid)
    band = grid[(grid >= limits.frequency_min) & (grid <= limits.frequency_max)]
    phase, there = _refine_minimum(lambda f: at(f).phase_angle, band)
    top = at(25.0)
    static = on.static_load(place)
    states = tuple(known[f] for f in sorted(known))
    amplitude = 0.5 * (top.force_max - top.force_min)
    return SteadySweep(
        max(0.0, force / static), here, phase, there, amplitude, force <= 1e-9 * static, states
    )


def _refine_minimum(value: Callable[[float], float], grid: Array) -> tuple[float, float]:
    """Return the minimum value and its frequency: the grid minimum refined to 0.01 Hz between its neighbours."""
    values = np.array([value(float(f)) for f in grid])
    best = int(np.argmin(values))
    low = round(float(grid[max(best - 1, 0)]) / _FINE)
    high = round(float(grid[min(best + 1, len(grid) - 1)]) / _FINE)
    while high - low > 2:
        left = low + (high - low) // 3
        right = high - (high - low) // 3
        if value(left * _FINE) <= value(right * _FINE):
            high = right
        else:
            low = left
    inside = [(value(k * _FINE), round(k * _FINE, 9)) for k in range(low, high + 1)]
    return min([*inside, (float(values[best]), float(grid[best]))])
