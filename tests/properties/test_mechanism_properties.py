"""What must hold for any mechanism: loops stay closed, energy stays, and nothing depends on where the axes lie."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import jounce as jn

X, Y, Z, ORIGIN = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)
LENGTH = st.floats(0.1, 1.0)
FEW = settings(max_examples=20)
POINTS = {"A": ORIGIN, "B": (0.0, 0.0, 0.2), "C": (0.4, 0.0, 0.3), "D": (0.5, 0.0, 0.0)}
BARS = {"crank": ("A", "B", 1.0), "coupler": ("B", "C", 2.0), "rocker": ("D", "C", 1.5)}


def middle(points, bar):
    return 0.5 * (np.array(points[BARS[bar][0]]) + np.array(points[BARS[bar][1]]))


@cache
def four_bar() -> jn.mechanics.Mechanism:
    mechanism = jn.mechanics.Mechanism()
    bodies = {
        bar: mechanism.body(bar, BARS[bar][2], middle(POINTS, bar), (0.03, 0.03, 0.03))
        for bar in BARS
    }
    bodies["ground"] = mechanism.ground
    for joint, first, second in (
        ("A", "ground", "crank"),
        ("B", "crank", "coupler"),
        ("D", "ground", "rocker"),
    ):
        mechanism.revolute(joint, bodies[first], bodies[second], at=POINTS[joint], axis=Y)
    mechanism.revolute("C", bodies["coupler"], bodies["rocker"], at=POINTS["C"], axis=Y)
    for joint in POINTS:
        mechanism.watch_reaction(joint)
    for bar in BARS:
        mechanism.watch_body(bodies[bar])
    mechanism.watch_energy()
    return mechanism


def elsewhere(points):
    """The four-bar's numbers for other places of its joints."""
    values = {
        f"{name}.at[{i}]": float(point[i]) for name, point in points.items() for i in range(3)
    }
    return values | {
        f"{bar}.centre_of_mass[{i}]": float(middle(points, bar)[i])
        for bar in BARS
        for i in range(3)
    }


def run_of(points, speed: float, **settings_):
    given_ = {"redundant": "remove", "output_step": 0.02, "tolerance": 1e-8} | settings_
    return jn.simulate_mechanism(
        four_bar(), 0.4, start={"A.angle rate": speed}, values=elsewhere(points), **given_
    )


def is_crank(crank, coupler, rocker, base):
    """Grashof, with a margin: the crank is the shortest bar and goes round."""
    bars = sorted((crank, coupler, rocker, base))
    return crank == bars[0] and bars[0] + bars[3] < 0.95 * (bars[1] + bars[2])


def places(crank, coupler, rocker, base, turn):
    b = crank * np.array([np.sin(turn), np.cos(turn)])
    reach = np.array([base, 0.0]) - b
    distance = np.hypot(*reach)
    along = (coupler**2 - rocker**2 + distance**2) / (2.0 * distance)
    up = np.sqrt(coupler**2 - along**2)
    e = reach / distance
    c = b + along * e + up * np.array([-e[1], e[0]])
    return {"A": ORIGIN, "B": (b[0], 0.0, b[1]), "C": (c[0], 0.0, c[1]), "D": (base, 0.0, 0.0)}


@FEW
@given(
    crank=st.floats(0.1, 0.3),
    coupler=LENGTH,
    rocker=LENGTH,
    base=LENGTH,
    turn=st.floats(-3, 3),
    speed=st.floats(-9, 9),
)
def test_cranks_that_go_round_keep_energy_loops_and_balance(
    crank, coupler, rocker, base, turn, speed
):
    assume(is_crank(crank, coupler, rocker, base))
    run = run_of(places(crank, coupler, rocker, base, turn), speed)
    total = run["energy.kinetic"] + run["energy.weight"]
    assert float(run["constraint.residual"].max()) < 1e-12
    assert float(abs(total - total[0]).max()) < 1e-6 * max(1.0, float(run["energy.kinetic"].max()))
    push = sum(mass * run[f"{bar}.az"] for bar, (_, _, mass) in BARS.items()) + 4.5 * 9.81
    np.testing.assert_allclose(run["A.fz"] + run["D.fz"], push, rtol=1e-7, atol=1e-6)


@FEW
@given(heading=st.floats(-3, 3), shift=st.tuples(*[st.floats(-2, 2)] * 3), speed=st.floats(-9, 9))
def test_places_and_headings_change_nothing_but_the_axes(heading, shift, speed):
    """Moved anywhere and turned about the vertical, the mechanism does the same."""
    turn = np.array(
        [
            [np.cos(heading), -np.sin(heading), 0.0],
            [np.sin(heading), np.cos(heading), 0.0],
            [0.0, 0.0, 1.0],
        ]
    )
    moved = {name: turn @ point + shift for name, point in POINTS.items()}
    axes = {f"{name}.axis[{i}]": float((turn @ Y)[i]) for name in POINTS for i in range(3)}
    still = run_of(POINTS, speed)
    run = jn.simulate_mechanism(
        four_bar(),
        0.4,
        start={"A.angle rate": speed},
        values=elsewhere(moved) | axes,
        redundant="remove",
        output_step=0.02,
        tolerance=1e-8,
    )
    for bar in BARS:
        one, other = (
            np.array([each[f"{bar}.{axis}"].values for axis in "xyz"]) for each in (still, run)
        )
        np.testing.assert_allclose(
            turn @ one + np.array(shift)[:, None], other, rtol=0.0, atol=1e-7
        )
    one, other = (np.array([each[f"B.f{axis}"].values for axis in "xz"]) for each in (still, run))
    sideways = np.cos(heading) * run["B.fx"] + np.sin(heading) * run["B.fy"]
    np.testing.assert_allclose(sideways, one[0], rtol=0.0, atol=1e-4)
    np.testing.assert_allclose(other[1], one[1], rtol=0.0, atol=1e-4)


@FEW
@given(factor=st.floats(1e-3, 1e3), speed=st.floats(-9, 9))
def test_heavier_of_the_same_moves_the_same(factor, speed):
    mechanism = four_bar()
    values = {
        path: factor * value
        for path, value in mechanism.values.items()
        if ".mass" in path or ".inertia" in path
    }
    settings_ = {
        "redundant": "remove",
        "output_step": 0.02,
        "tolerance": 1e-8,
        "start": {"A.angle rate": speed},
    }
    one = jn.simulate_mechanism(mechanism, 0.4, **settings_)
    other = jn.simulate_mechanism(mechanism, 0.4, values=values, **settings_)
    np.testing.assert_allclose(other["rocker.x"], one["rocker.x"], rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(other["A.fz"], factor * one["A.fz"], rtol=1e-6, atol=1e-6 * factor)


@cache
def arm() -> jn.mechanics.Mechanism:
    """A ball joint on a hinge: quaternions, gyroscopic torques."""
    mechanism = jn.mechanics.Mechanism()
    upper = mechanism.body("upper", 1.0, (0.5, 0.1, 0.0), (0.02, 0.1, 0.11))
    lower = mechanism.body("lower", 0.7, (1.3, 0.0, 0.1), (0.01, 0.05, 0.05, 0.0, 0.004, 0.0))
    mechanism.revolute("shoulder", mechanism.ground, upper, at=ORIGIN, axis=(0.2, 1.0, 0.1))
    mechanism.spherical("elbow", upper, lower, at=(1.0, 0.0, 0.0))
    mechanism.watch_coordinates()
    mechanism.watch_energy()
    return mechanism


SPEED = st.floats(-5, 5)


@FEW
@given(speeds=st.tuples(SPEED, SPEED, SPEED, SPEED), angle=st.floats(-3, 3))
def test_time_runs_backwards(speeds, angle):
    names = ("shoulder.angle rate", "elbow.wx", "elbow.wy", "elbow.wz")
    start = {"shoulder.angle": angle, **dict(zip(names, speeds, strict=True))}
    there = jn.simulate_mechanism(arm(), 0.5, start=start, output_step=0.5, tolerance=1e-9)
    places_ = ("shoulder.angle", *(f"elbow.e{i}" for i in range(4)))
    back = {name: float(there[name][-1]) for name in places_} | {
        name: -float(there[name][-1]) for name in names
    }
    home = jn.simulate_mechanism(arm(), 0.5, start=back, output_step=0.5, tolerance=1e-9)
    for name, speed in zip(names, speeds, strict=True):
        assert float(home[name][-1]) == pytest.approx(-speed, abs=1e-6)
    assert float(home["shoulder.angle"][-1]) == pytest.approx(angle, abs=1e-6)
    assert abs(float(home["elbow.e0"][-1])) == pytest.approx(1.0, abs=1e-6)


@FEW
@given(scale=st.floats(1e-3, 1e3), parts=st.tuples(*[st.floats(-1, 1)] * 4))
def test_length_and_sign_of_a_given_quaternion_do_not_matter(scale, parts):
    assume(np.linalg.norm(parts) > 0.1)
    runs = []
    for factor in (1.0, scale, -scale):
        start = {f"elbow.e{i}": factor * part for i, part in enumerate(parts)} | {"elbow.wx": 1.0}
        runs.append(jn.simulate_mechanism(arm(), 0.2, start=start, output_step=0.1, tolerance=1e-8))
    for run in runs[1:]:
        np.testing.assert_allclose(
            run["shoulder.angle"], runs[0]["shoulder.angle"], rtol=0.0, atol=1e-9
        )
        assert abs(float(sum(run[f"elbow.e{i}"][-1] ** 2 for i in range(4))) - 1.0) < 1e-13


MOMENT = st.floats(0.01, 10.0)


@given(moments=st.tuples(MOMENT, MOMENT, MOMENT), turn=st.tuples(*[st.floats(-1, 1)] * 3))
def test_inertia_is_refused_where_the_triangle_inequality_fails_in_any_axes(moments, turn):
    from scipy.spatial.transform import Rotation

    largest, rest = max(moments), sum(moments) - max(moments)
    assume(abs(largest - rest) > 1e-3)
    matrix = Rotation.from_rotvec(turn).as_matrix()
    tensor = matrix @ np.diag(moments) @ matrix.T
    mechanism = jn.mechanics.Mechanism()
    if largest > rest:
        with pytest.raises(jn.AssemblyError, match="body: impossible inertia"):
            mechanism.body("body", 1.0, ORIGIN, 0.5 * (tensor + tensor.T))
    else:
        mechanism.body("body", 1.0, ORIGIN, 0.5 * (tensor + tensor.T))
        assert mechanism.mass_values(mechanism.values)["body"][0] == 1.0
