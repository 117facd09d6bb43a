"""Sensitivities of a corner run by its one coordinate are those of the mechanism, for every kind of number.

The two are differentiated in different ways: the mechanism through its coordinates, loops and projections; the reduced
corner through polynomials whose coefficients move with hardpoints and masses. The mechanism runs at a tight tolerance.
"""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.parts import Rig
from jounce.simulation.compiled import compile_rig
from jounce.simulation.prepare import solve
from jounce.simulation.problem import excitation
from jounce.simulation.reduced import DEGREES, ReducedCorner, reduction_of
from jounce.simulation.settings import output_times

pytestmark = pytest.mark.usefixtures("optimised")

KART = jn.load("kart-double-wishbone")
STOPS = {"bump_stop": {"gap": "4 mm", "rate": "50 N/mm", "progression": 1e8}}
STOPPED = KART.with_changes(
    {f"strut.{name}": stop for name, stop in STOPS.items()} | {"steering.rack_travel": "4 mm"}
)
FREE = (
    "hardpoints.upper_ball_joint[2]",
    "hardpoints.strut_bottom[2]",
    "steering.rack_travel",
    "bodies.upright.mass",
    "strut.spring.rate",
    "strut.damper.coefficient",
    "strut.bump_stop.gap",
    "tyre.stiffness",
)
TOLERANCE = 1e-5
SEED = 20261123


def bump(height: float = 0.012, duration: float = 0.5) -> jn.Trial:
    return jn.Trial(
        road=jn.HalfSine(height=height, length=0.06, start=0.1), speed=2.0, duration=duration
    )


def mechanism(rig: Rig, trial: jn.Trial, free: tuple[str, ...], tolerance: float):
    compiled = compile_rig(rig, free)
    signals = excitation(compiled.facts, rig, trial, free)
    p, times = compiled.parameter_values(rig.parameters()), output_times(trial.duration, 1e-3)
    return solve(compiled, p, signals, times, tolerance=tolerance)


def worst(slopes: dict[str, np.ndarray], full, names: tuple[str, ...]) -> float:
    """Largest difference of a slope over the largest that its channel has, for those that are felt at all."""
    found = [0.0]
    for name in names:
        wanted = slopes[name]
        for i, row in enumerate(wanted):
            size = np.max(np.abs(full[name][i]))
            if size > 1e-9 * max(np.max(np.abs(full[name])), 1e-30):
                found.append(np.max(np.abs(row - full[name][i])) / size)
    return max(found)


def by_name(solution, compiled) -> dict[str, np.ndarray]:
    return dict(zip(compiled.output_names, solution.output_slopes, strict=True))


def test_every_kind_of_number_over_stops_and_lift_off():
    rig, trial = STOPPED, bump()
    found = jn.sensitivities(rig, trial, FREE, tolerance=TOLERANCE)
    assert found.attrs["method"] == "reduced explicit"
    assert found.attrs["events"] >= 4
    full, numbers = {name: np.empty(found[name].shape) for name in found}, rig.parameters()
    for i, path in enumerate(
        FREE
    ):  # central differences of the mechanism, whose own slopes the slow test takes
        step = 1e-4 * max(abs(numbers[path]), 1e-2)
        changed = (rig.with_changes({path: numbers[path] + sign * step}) for sign in (1, -1))
        ahead, behind = (
            jn.simulate(each, trial, method="explicit", tolerance=1e-11) for each in changed
        )
        for name, slopes in full.items():
            slopes[i] = (ahead[name].values - behind[name].values) / (2.0 * step)
    reduced = {name: found[name].values for name in found}
    # forces and accelerations have kinks at events, where a difference over the kink is no slope
    assert (
        worst(
            reduced,
            full,
            ("sprung.z", "unsprung.z", "strut.deflection", "wheel.camber", "wheel.steer"),
        )
        < 3e-5
    )


def test_numbers_that_move_no_pose_leave_the_table_alone():
    reduction = reduction_of(KART)
    assert reduction is not None
    compiled = reduction.sensitive(DEGREES[0], ("strut.spring.rate", "sprung.mass"))
    assert compiled.moved == ("strut.spring.rate", "sprung.mass")


def test_what_the_polynomials_leave_out_of_a_slope_is_within_its_bound():
    """Slopes of polynomials over the widest range, where they are worst, beside exact ones at other travels."""
    reduction, values, half = reduction_of(KART), KART.parameters(), 0.06
    assert reduction is not None
    p, free = np.array([values[path] for path in reduction.parameters]), FREE[:2]
    others = np.sort(np.random.default_rng(SEED).uniform(-half, half, 23))
    _, exact = reduction._along(p, 0.0, others, free)
    bounds = []
    for degree in DEGREES:
        table = reduction.table(p, 0.0, -half, half, degree)
        numbers, bound = reduction.slopes(table, degree, p, 0.0, free)
        rows = numbers[3:].reshape(len(reduction.names) - 1, degree + 1, len(free))
        for i, name in enumerate(reduction.names[1:]):
            for j in range(len(free)):
                off = np.max(np.abs(np.polyval(rows[i, ::-1, j], others / half) - exact[i + 1, j]))
                scale = 100.0 if name.startswith("wheel.") else 1.0
                largest = np.max(np.abs(exact[1:, j]))
                assert off <= (scale * bound + 3e-14) * largest  # and rounding
        bounds.append(bound)
    assert bounds[1] < 1e-2 * bounds[0]


def test_a_tighter_tolerance_takes_the_higher_degree_for_slopes_first():
    """Levers would do with the lower degree; their slopes along the place of a tie rod are farther off."""
    trial, values = bump(), KART.parameters()
    signals = excitation(compile_rig(KART).facts, KART, trial)
    given = (reduction_of(KART), values, signals, output_times(trial.duration, 1e-3), 1e-6)
    plain, sensitive = (
        ReducedCorner(*given, free).over(-0.04, 0.04)
        for free in ((), ("hardpoints.tie_rod_outer[1]",))
    )
    assert plain is not None
    assert sensitive is not None
    assert (plain.degree, sensitive.degree) == DEGREES


def test_the_mechanism_runs_where_one_coordinate_does_not_do():
    found = [jn.sensitivities(KART, bump(duration=0.02), ["tyre.stiffness"], tolerance=1e-8)]
    found += [jn.sensitivities(KART, bump(duration=0.02), ["tyre.stiffness"], output_step=1e-2)]
    assert [each.attrs["method"] for each in found] == ["explicit"] * 2


@pytest.mark.slow
def test_random_corners_of_every_suspension():
    """Other hardpoints, masses and rates, stops, with and without lift-off; what cannot stand is no case."""
    random, found, reduced = np.random.default_rng(SEED), [], 0
    names = (
        "kart-double-wishbone",
        "reference-double-wishbone",
        "generic-mcpherson",
        "sedan-multi-link",
    )
    rigs = [
        jn.load(name)
        for name in (*names, "semi-trailing-arm", "formula-student-front", "suv-front")
    ]
    for attempt in range(84):
        if len(found) == 42:
            break
        rig = rigs[attempt % len(rigs)]
        numbers = rig.parameters()
        places = sorted(
            path for path in numbers if path.startswith("hardpoints.") and "wheel" not in path
        )
        spring = (
            "strut.spring.rate" if "strut.spring.rate" in numbers else "strut.spring.free_length"
        )  # of a curve
        free = (
            *places[:: max(len(places) // 4, 1)][:4],
            spring,
            "strut.bump_stop.gap",
            "tyre.stiffness",
        )
        free += tuple(
            path for path in numbers if path.startswith("bodies.") and path.endswith(".mass")
        )[:1]
        gap, rate = random.uniform(0.003, 0.02, 2), 5.0 * numbers.get("strut.spring.rate", 3e4)
        changes = {path: numbers[path] + 0.003 * random.uniform(-1.0, 1.0) for path in places}
        changes |= {
            "tyre.lift_off": bool(random.random() < 0.7),
            "strut.rebound_stop": {"gap": gap[1], "rate": rate},
        }
        changes["strut.bump_stop"] = {"gap": gap[0], "rate": rate, "progression": 1e7}
        size = max(numbers.get("tyre.undeformed_radius", 0.25), 0.12) / 0.3
        road = jn.HalfSine(
            height=size * random.uniform(0.005, 0.03),
            length=size * random.uniform(0.2, 1.0),
            start=0.1,
        )
        trial = jn.Trial(road=road, speed=random.uniform(1.0, 8.0), duration=0.6)
        try:
            changed = rig.with_changes(changes)
            one = jn.sensitivities(changed, trial, free)
            full = by_name(mechanism(changed, trial, free, 1e-9), compile_rig(changed))
        except jn.JounceError:
            continue
        shown = tuple(name for name in ("sprung.z", "unsprung.z") if name in full)
        assert shown
        found.append(worst({name: one[name].values for name in one}, full, shown))
        reduced += one.attrs["method"] == "reduced explicit"
    assert len(found) == 42
    assert reduced >= 30
    assert max(found) < TOLERANCE
