"""Test programme: exciter angle over time, and simulation of a rig over the programme."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from jounce.core.errors import unknown
from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.mechanics.facts import Output
from jounce.mechanics.motions import constant
from jounce.parts.rig import Rig
from jounce.parts.testers import Programme, Tester
from jounce.parts.vehicles import FrontViewAxle
from jounce.testers.model import ANGLE
from jounce.testers.rig import TesterRig, channel, rig_on_tester

_RUN_OUT = (
    10.0  # Hz/s: deceleration of an eccentric exciter that is still turning at the end of its sweep
)


@dataclass(frozen=True)
class SweptAngle:
    """Angle of an eccentric exciter over one controlled test: hold, sweep, stop."""

    edges: Array  # (4,): start of hold, sweep and stop, and end of stop, s
    coefficients: (
        Array  # (3, 3): angle (rad), rate (rad/s) and half the acceleration (rad/s^2) at each start
    )

    @property
    def end(self) -> float:
        """Final angle, rad."""
        angle, rate, half = self.coefficients[-1]
        length = self.edges[-1] - self.edges[-2]
        return float(angle + length * (rate + length * half))


def swept_angle(
    programme: Programme, static_load: float, begin: float = 0.0, angle: float = 0.0
) -> SweptAngle:
    """Return the exact exciter angle over a programme: quadratic in time while the frequency changes.

    The hold depends on the static load (N); the exciter starts at ``begin`` (s) from an angle in rad.

    Examples
    --------
    >>> from jounce.parts.testers import load_tester
    >>> found = swept_angle(load_tester("eusama").programme, 4000.0)
    >>> found.edges.tolist()   # s: 25 Hz for 1.5 s, then 2.5 Hz/s down to rest
    [0.0, 1.5, 11.5, 11.5]
    """
    first, last = 2.0 * np.pi * programme.start_frequency, 2.0 * np.pi * programme.end_frequency
    slope = np.copysign(2.0 * np.pi * programme.sweep_rate, last - first)
    lengths = programme.hold(static_load), (last - first) / slope, last / (2.0 * np.pi * _RUN_OUT)
    rows, edges = [], [begin]
    for length, rate, half in zip(
        lengths, (first, first, last), (0.0, 0.5 * slope, -np.pi * _RUN_OUT), strict=True
    ):
        rows.append([angle, rate, half])
        angle += length * (rate + length * half)
        edges.append(edges[-1] + length)
    return SweptAngle(np.array(edges), np.array(rows))


def angle_of(tests: list[SweptAngle]) -> Segments:
    """Join the tests of one exciter, with rest before, between and after them."""
    edges, rows = [-1.0], [[tests[0].coefficients[0, 0] if tests else 0.0, 0.0, 0.0]]
    for test in tests:
        edges += list(test.edges[:3])
        rows += [list(row) for row in test.coefficients]
        edges.append(test.edges[3])
        rows.append([test.end, 0.0, 0.0])
    edges.append(edges[-1] + 1.0)
    used = [i for i in range(len(rows)) if edges[i + 1] > edges[i]]
    coefficients = np.zeros((len(used), 4))
    coefficients[:, :3] = np.array(rows)[used]
    return Segments(
        np.array([*(edges[i] for i in used), edges[-1]]),
        np.zeros(len(used), np.int64),
        coefficients,
    )


Wheel = Literal["left", "right", "both"]
Other = Literal["still", "excited"]


@dataclass(frozen=True)
class ProgrammeRun:
    """Arrays of a simulated test."""

    time: Array  # (n,): s
    values: dict[str, Array]  # samples by model output, SI, shape (n,)
    static: dict[str, float]  # value at rest by output
    outputs: tuple[Output, ...]  # names, units and labels


def run_programme(
    rig: Rig, tester: Tester, *, wheel: Wheel = "both", other: Other = "still"
) -> ProgrammeRun:
    """Run a tester's programme without sensors; arguments as for :func:`simulate_test`."""
    chosen = _choose_tests(rig, wheel, other)
    return (_free if tester.programme.run_down == "free" else _run_controlled)(rig, tester, chosen)


def _choose_tests(rig: Rig, wheel: str, other: str) -> list[tuple[str, ...]]:
    """Return the wheels excited together in each test, in order."""
    for name, value, allowed in (
        ("wheel", wheel, ("left", "right", "both")),
        ("other", other, ("still", "excited")),
    ):
        if value not in allowed:
            raise unknown(str(value), allowed, what=name, where=name)
    if not isinstance(rig, FrontViewAxle):
        return [("",)]
    if other == "excited":
        return [("left", "right")]
    return [("left",), ("right",)] if wheel == "both" else [(wheel,)]


def _run_controlled(rig: Rig, tester: Tester, tests: list[tuple[str, ...]]) -> ProgrammeRun:
    """Simulate all tests in one run; the drive follows its programme exactly."""
    on, programme, begin = rig_on_tester(rig, tester), tester.programme, 0.0
    turns: dict[str, list[SweptAngle]] = {}
    for test in tests:
        load = max(on.static_load(place) for place in test)
        for place in test:
            turns.setdefault(place, []).append(swept_angle(programme, load, begin))
        begin = turns[test[0]][-1].edges[-1] + programme.pause
    end = begin - programme.pause
    times = _times(0.0, end, tester.sampling_frequency)
    angles = {place: angle_of(swept) for place, swept in turns.items()}
    solution = on.run(angles, times, fastest=_fastest(programme))
    return _course(on, times, solution.outputs)


def _free(rig: Rig, tester: Tester, tests: list[tuple[str, ...]]) -> ProgrammeRun:
    """Simulate one test after the other: spun up, then moved only by the drive's inertia."""
    programme, on = tester.programme, rig_on_tester(rig, tester)
    rate = 2.0 * np.pi * programme.start_frequency
    state: dict[str, float] = {}
    pieces: list[tuple[Array, dict[str, Array]]] = []
    outputs: tuple[Output, ...] = ()
    begin = 0.0
    for number, test in enumerate(tests):
        hold = programme.hold(max(on.static_load(place) for place in test))
        rest = programme.duration + (programme.pause if number + 1 < len(tests) else 0.0)
        for here, kind, length in _phases(on, rig_on_tester(rig, tester, test), hold, rest):
            times = begin + _times(0.0, length, tester.sampling_frequency)
            courses = {
                place: _track(
                    kind if place in test else "still",
                    state.get(channel(place, ANGLE), 0.0),
                    rate,
                    begin,
                )
                for place in on.places
            }
            solution = here.run(courses, times, start=state or None, fastest=_fastest(programme))
            state = _state(here, courses, solution.states[:, -1], times[-1:])
            values = dict(
                zip(here.compiled.output_names, solution.outputs[:, bool(pieces) :], strict=True)
            )
            outputs = outputs or here.compiled.facts.outputs
            pieces.append((times[bool(pieces) :], values))
            begin = float(times[-1])
    time = np.concatenate([times for times, _ in pieces])
    common = [output for output in outputs if all(output.name in values for _, values in pieces)]
    joined = {
        output.name: np.concatenate([values[output.name] for _, values in pieces])
        for output in common
    }
    return ProgrammeRun(time, joined, on.static, tuple(common))


def _phases(
    driven: TesterRig, free: TesterRig, hold: float, rest: float
) -> Iterator[tuple[TesterRig, str, float]]:
    """Yield rig, exciter mode and duration (s) of each phase of one test."""
    motor = driven.tester.drive is not None and driven.tester.drive.motor is not None
    if hold > 0.0:
        yield (free, "motor on", hold) if motor else (driven, "driven", hold)
    yield free, "motor off", rest


def _track(kind: str, angle: float, rate: float, begin: float) -> Segments:
    """Return the angle (rad) of an exciter at rest or driven (rad/s), or the share of its motor torque."""
    if kind == "driven":
        return Segments(
            np.array([begin, begin + 1.0]),
            np.zeros(1, np.int64),
            np.array([[angle, rate, 0.0, 0.0]]),
        )
    return constant({"still": angle, "motor on": 1.0, "motor off": 0.0}[kind])


def _state(on: TesterRig, tracks: Mapping[str, Segments], x: Array, at: Array) -> dict[str, float]:
    """Return the states at the end of a phase by name, including angles of driven exciters."""
    state = dict(zip(on.compiled.facts.states, map(float, x), strict=True))
    for place, segments in tracks.items():
        name = channel(place, ANGLE)
        if name not in state:
            angle, rate = segments.evaluate(at)
            state[name], state[f"{name} rate"] = float(angle[0]), float(rate[0])
    return state


def _fastest(programme: Programme) -> float:
    return 2.0 * np.pi * max(programme.start_frequency, programme.end_frequency)


def _times(begin: float, end: float, frequency: float) -> Array:
    count = int(np.floor((end - begin) * frequency + 1e-9))
    return np.asarray(begin + np.arange(count + 1) / frequency)


def _course(on: TesterRig, time: Array, outputs: Array) -> ProgrammeRun:
    values = dict(zip(on.compiled.output_names, outputs, strict=True))
    return ProgrammeRun(time, values, on.static, on.compiled.facts.outputs)
