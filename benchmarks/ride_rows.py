"""Roads, roughness index, weighting and controllers, each compared with NumPy and SciPy."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from itertools import count
from typing import Any

import numpy as np
from timing import Row, median_time

import jounce as jn
from jounce.design.cases import cases_problem
from jounce.ride.study import iso_trial
from jounce.ride.weighting import weight, weighting_response
from jounce.roads.rough import Iso8608
from jounce.roughness.iri import iri, state_transition

_CONTROLLED = 10.0  # s at 1 kHz
_moves = count()  # so that each design is a new one


def ride_rows() -> list[Row]:
    """All rows."""
    return [*_road_rows(), *_iri_rows(), *_weighting_rows(), *_robust_rows(), *_control_rows()]


def _road_rows() -> list[Row]:
    """10 km of ISO 8608 at 1 cm, a new seed each time; the peer sums 1 km of cosines."""
    seeds = iter(range(1_000_000))
    own = median_time(
        lambda: Iso8608(class_="C", length=1e4, step=0.01, seed=next(seeds)).points(), repeats=5
    )
    problem = "ISO 8608 road, 10 km at 1 cm"
    sums = 10.0 * 10.0 * median_time(_sum_of_cosines, repeats=1, budget=0.0)
    note = "sequential; extrapolated from 1 km with a tenth of the points and cosines"
    return [
        Row(problem, "jounce, Iso8608.points", own, None, 1.0, "≤ 0.5 s"),
        Row(problem, "NumPy, sum of cosines", sums, None, sums / own, note=note),
    ]


def _sum_of_cosines() -> np.ndarray:
    """1 km at 1 cm by the plain formula, every tenth of its cosines."""
    x = 0.01 * np.arange(100_001)
    n = np.arange(0.011, 2.83, 1e-2)
    phase = np.random.default_rng(0).uniform(0.0, 2.0 * np.pi, len(n))
    height = np.zeros_like(x)
    for line, angle in zip(n, phase, strict=True):
        height += np.sqrt(2.0 * 256e-6 * (0.1 / line) ** 2 * 1e-2) * np.cos(
            2.0 * np.pi * line * x + angle
        )
    return height


_SPREAD = {"sprung.mass": ["400 kg", "550 kg"], "strut.damper.coefficient": "15 %"}
_ROADS = {"city": ("B", 14.0), "motorway": ("A", 36.0), "rough": ("D", 10.0)}
_GOALS = ("city: p95 sprung.az", "rough: p95 tyre.force", "motorway: p95 sprung.az")


def _robust_rows() -> list[Row]:
    """A damper for three roads with 32 samples: time per design and per front; the peer evaluates rigs singly."""
    rig, damper = jn.load("audi-a6-quarter-car"), "strut.damper.coefficient"
    free = {damper: ("500 N*s/m", "5000 N*s/m")}
    cases = {name: {"road": road, "speed": speed} for name, (road, speed) in _ROADS.items()}
    task = cases_problem(rig, free, dict.fromkeys(_GOALS, 1.0), cases=cases, spread=_SPREAD)
    at = task.start
    own = median_time(lambda: task.evaluator.at(at * (1.0 + 1e-3 * next(_moves))))
    rigs = [family.rig for family in task.evaluator.cases["city"].families.members]

    def one_by_one() -> None:
        for road, speed in _ROADS.values():
            for one in rigs:
                jn.stationary(one, road, speed, band="iso", parameters=[damper])

    theirs = median_time(one_by_one, repeats=5)
    problem = "damper for three roads, one design over 32 samples, with slopes"
    whole = median_time(
        lambda: jn.design_front(rig, free, _GOALS, cases=cases, spread=_SPREAD, points=15),
        repeats=1,
    )
    return [
        Row(problem, "jounce, all samples together", own, None, 1.0),
        Row(problem, "jn.stationary for each", theirs, None, theirs / own, note="all channels"),
        Row(
            "the same, Pareto front of three objectives, 15 designs",
            "jounce, jn.design_front",
            whole,
        ),
    ]


def _iri_rows() -> list[Row]:
    """IRI of 100 km at 0.25 m, in segments of 100 m."""
    x = 0.25 * np.arange(400_001)
    z = np.cumsum(np.random.default_rng(1).normal(0.0, 1e-3, len(x)))
    problem = "IRI of 100 km at 0.25 m"
    own = median_time(lambda: iri(x, z), repeats=9)
    found, plain = iri(x, z).iri_m_per_km, _iri_loop(z)
    median = median_time(lambda: _iri_loop(z), repeats=3)
    return [
        Row(problem, "jounce.iri with its segments", own, 0.0, 1.0, "≤ 0.5 s"),
        Row(
            problem,
            "NumPy, matrix times state",
            median,
            abs(plain / found - 1.0),
            median / own,
            note="total only",
        ),
    ]


def _iri_loop(z: np.ndarray) -> float:
    """Roughness index by the textbook loop, m/km."""
    matrix, drive = state_transition(0.25)
    start = (z[44] - z[0]) / 11.0
    state, total = np.array([start, 0.0, start, 0.0]), 0.0
    slopes = np.diff(z) / 0.25
    for slope in slopes:
        state = matrix @ state + drive * slope
        total += abs(state[0] - state[2])
    return 1000.0 * total / len(slopes)


def _weighting_rows() -> list[Row]:
    """Wk of one hour at 1 kHz; errors of the weighting at the third octaves from 0.63 to 63 Hz."""
    from scipy import signal

    rate = 1000.0
    values = np.random.default_rng(2).normal(size=3_600_000)
    filters = _bilinear_wk(rate)
    problem = "ISO 2631 weighting Wk, one hour at 1 kHz"
    own = median_time(lambda: weight(values, rate, "Wk"), repeats=5)
    other = median_time(lambda: signal.sosfilt(filters, values), repeats=5)
    errors = [
        _response_error(run, rate)
        for run in (lambda v: weight(v, rate, "Wk"), lambda v: signal.sosfilt(filters, v))
    ]
    return [
        Row(
            problem,
            "jounce.ride.weighting",
            own,
            errors[0],
            1.0,
            "≤ 1 s",
            "error of the response, 0.63 to 63 Hz",
        ),
        Row(
            problem,
            "SciPy, bilinear filter",
            other,
            errors[1],
            other / own,
            note="error not reached",
        ),
    ]


def _bilinear_wk(rate: float) -> np.ndarray:
    """Wk of ISO 2631-1 through the plain bilinear transform."""
    from scipy import signal

    w1, w2, w3, w4, w5, w6 = (2.0 * np.pi * f for f in (0.4, 100.0, 12.5, 12.5, 2.37, 3.35))
    low = (w2**2, [1.0, np.sqrt(2.0) * w2, w2**2])
    parts = [
        ([1.0, 0.0, 0.0], [1.0, np.sqrt(2.0) * w1, w1**2]),
        ([low[0]], low[1]),
        ([w4**2 / w3, w4**2], [1.0, w4 / 0.63, w4**2]),
        ([1.0, w5 / 0.91, w5**2], [1.0, w6 / 0.91, w6**2]),
    ]
    sections = []
    for above, below in parts:
        b, a = signal.bilinear(above, below, rate)
        sections.append(np.concatenate([np.pad(b, (0, 3 - len(b))), np.pad(a, (0, 3 - len(a)))]))
    return np.array(sections)


def _response_error(run: Callable[[np.ndarray], Any], rate: float) -> float:
    """Largest relative error of the magnitude, from the response to an impulse."""
    impulse = np.zeros(2**17)
    impulse[0] = 1.0
    response = np.abs(np.fft.rfft(run(impulse)))
    frequency = np.fft.rfftfreq(len(impulse), 1.0 / rate)
    third_octaves = 10.0 ** (np.arange(-2, 19) / 10.0)
    wanted = np.abs(weighting_response("Wk", third_octaves))
    return float(np.max(np.abs(np.interp(third_octaves, frequency, response) / wanted - 1.0)))


def _control_rows() -> list[Row]:
    """10 s on an ISO C road at 20 m/s, controlled at 1 kHz: compiled laws and a function in Python."""
    rows = []
    for name, target in (("audi-a6-quarter-car", "≥ 500 × real time"), ("audi-a6-full-car", "")):
        rig = jn.load(name)
        trial = iso_trial(rig, "C", 20.0, duration=_CONTROLLED).trial
        problem = (
            f"controlled {rig.model}, ISO C at 20 m/s, {trial.duration:.4g} s, control at 1 kHz"
        )
        corners = (
            tuple(f"{corner}." for corner in rig.corners) if isinstance(rig, jn.Vehicle) else ("",)
        )
        own = 0.0
        for way, control, goal in (
            ("compiled skyhook", "skyhook", target),
            ("compiled LQG", "lqg", ""),
            ("Python function", _skyhook_at(corners), "≥ 20 × real time"),
        ):
            median = median_time(partial(jn.simulate, rig, trial, control=control), repeats=5)
            own = own or median
            note = f"{trial.duration / median:.0f} × real time, with its Dataset"
            rows.append(Row(problem, f"jounce, {way}", median, None, median / own, goal, note))
    return rows


def _skyhook_at(corners: tuple[str, ...]) -> Callable[[Any, float], list[float]]:
    """A user's own law: a two-state skyhook at every corner."""
    names = [(f"{corner}sprung.vz", f"{corner}strut.velocity") for corner in corners]

    def skyhook(measurement: Any, t: float) -> list[float]:  # noqa: ARG001
        return [
            4000.0 if measurement[body] * measurement[stroke] < 0.0 else 300.0
            for body, stroke in names
        ]

    return skyhook
