"""Loops in space against closed forms: Bricard's six hinges, a spatial slider-crank, shafts on a cross, a governor."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import jounce as jn

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
ORIGIN = (0.0, 0.0, 0.0)
CORNERS = np.array(
    [[0, 0, 0], [1, 0, 0], [1, 0, -1], [1, 1, -1], [0, 1, -1], [0, 1, 0]], dtype=float
)


@cache
def bricard() -> jn.mechanics.Mechanism:
    """Five bars of 1 m and 1 kg along edges of a cube, six hinges across the bars they join (IFToMM benchmark).

    Bars 0 to 2 hang on the ground at hinge 0, bars 4 and 3 at hinge 5; hinge 3 closes the loop.
    """
    mechanism = jn.mechanics.Mechanism()
    bars = {-1: mechanism.ground, 5: mechanism.ground}
    axes = [
        np.cross(CORNERS[i] - CORNERS[i - 1], CORNERS[(i + 1) % 6] - CORNERS[i]) for i in range(6)
    ]
    for i in range(5):
        along = CORNERS[i + 1] - CORNERS[i]
        tensor = (np.eye(3) - np.outer(along, along)) / 12.0 + 1e-4 * np.eye(3)
        bars[i] = mechanism.body(f"bar {i}", 1.0, 0.5 * (CORNERS[i] + CORNERS[i + 1]), tensor)
    for i in (0, 1, 2, 5, 4, 3):
        mechanism.revolute(f"hinge {i}", bars[i - 1], bars[i], at=CORNERS[i], axis=axes[i])
    for i in range(5):
        mechanism.watch_point(f"bar {i}", bars[i], 0.5 * (CORNERS[i] + CORNERS[i + 1]))
    mechanism.watch_coordinates()
    mechanism.watch_energy()
    mechanism.watch_reaction("hinge 0")
    mechanism.watch_reaction("hinge 5")
    return mechanism


def test_bricard_names_its_redundant_equation():
    with pytest.raises(
        jn.AssemblyError, match=r"hinge 3.*1 superfluous equation .*loop of hinge 3, "
    ) as caught:
        jn.simulate_mechanism(bricard(), 0.1)
    assert all(f"hinge {i}" in str(caught.value) for i in range(6))


def test_bricard_keeps_energy_and_loop_and_its_symmetry():
    run = jn.simulate_mechanism(
        bricard(), 5.0, redundant="remove", output_step=0.01, tolerance=1e-9
    )
    total = run["energy.kinetic"] + run["energy.weight"]
    assert float(run["energy.kinetic"].max()) > 4.0
    assert float(abs(total).max()) < 1e-7
    assert float(run["constraint.residual"].max()) < 1e-11
    np.testing.assert_allclose(run["hinge 0.angle"], run["hinge 2.angle"], rtol=0.0, atol=1e-10)
    np.testing.assert_allclose(run["hinge 0.angle"], run["hinge 4.angle"], rtol=0.0, atol=1e-10)
    push = np.array([sum(run[f"bar {i}.a{axis}"].values for i in range(5)) for axis in "xyz"])
    push[2] += 5.0 * 9.81
    held = np.array([(run[f"hinge 0.f{axis}"] - run[f"hinge 5.f{axis}"]).values for axis in "xyz"])
    np.testing.assert_allclose(held, push, rtol=0.0, atol=1e-7)


@cache
def spatial_slider_crank() -> jn.mechanics.Mechanism:
    """A crank about x at y = 0.1 m, z = 0.12 m; a slider along x; a rod with a ball and a cross."""
    mechanism = jn.mechanics.Mechanism()
    hub, pin = np.array([0.0, 0.1, 0.12]), np.array([0.0, 0.1, 0.2])
    seat = np.array([0.2, 0.0, 0.0])
    along = (seat - pin) / np.linalg.norm(seat - pin)
    across = np.cross(along, Z) / np.linalg.norm(np.cross(along, Z))
    crank = mechanism.body("crank", 0.12, hub, (1e-4, 1e-5, 1e-4))
    rod = mechanism.body("rod", 0.5, 0.5 * (pin + seat), (4e-3, 4e-4, 4e-3))
    slider = mechanism.body("slider", 2.0, seat, (1e-4, 1e-4, 1e-4))
    turn = mechanism.revolute("main", mechanism.ground, crank, at=hub, axis=X)
    mechanism.prismatic("guide", mechanism.ground, slider, axis=X, at=seat)
    mechanism.universal(
        "cross", slider, rod, at=seat, axis=across, second_axis=np.cross(along, across)
    )
    mechanism.spherical("ball", crank, rod, at=pin)
    torque = mechanism.motion("drive", turn, mechanism.track("angle"))
    mechanism.output("drive.torque", torque, "N*m", "torque on the crank")
    mechanism.watch_body(slider)
    mechanism.watch_energy()
    for joint in ("main", "guide"):
        mechanism.watch_reaction(joint)
    mechanism.watch_body(rod)
    mechanism.watch_body(crank)
    return mechanism


def test_spatial_slider_crank_follows_the_length_of_its_rod():
    """Crank 80 mm, rod 300 mm, as in Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, 1989."""
    mechanism, speed = spatial_slider_crank(), 6.0
    drive = {"angle": jn.mechanics.constant_rate(speed)}
    run = jn.simulate_mechanism(mechanism, 1.5, motions=drive, output_step=0.01, tolerance=1e-9)
    angle = speed * run["time"].values
    y, z = 0.1 - 0.08 * np.sin(angle), 0.12 + 0.08 * np.cos(angle)
    x = np.sqrt(0.2**2 + 0.1**2 + 0.2**2 - y**2 - z**2)
    rate = speed * 0.08 * (y * np.cos(angle) + z * np.sin(angle)) / x
    np.testing.assert_allclose(run["slider.x"], x, rtol=0.0, atol=1e-11)
    np.testing.assert_allclose(run["slider.vx"], rate, rtol=0.0, atol=1e-9)
    balance = run["energy.kinetic"] + run["energy.weight"] - run["energy.supplied"]
    assert float(abs(balance - balance[0]).max()) < 1e-7
    bodies = {"crank": 0.12, "rod": 0.5, "slider": 2.0}
    for axis, weight in (("x", 0.0), ("y", 0.0), ("z", 9.81 * 2.62)):
        push = sum(mass * run[f"{body}.a{axis}"] for body, mass in bodies.items()) + weight
        np.testing.assert_allclose(
            run[f"main.f{axis}"] + run[f"guide.f{axis}"], push, rtol=0.0, atol=1e-7
        )
    np.testing.assert_allclose(run["main.tx"], run["drive.torque"], rtol=0.0, atol=1e-9)


@cache
def cross(bend: float) -> jn.mechanics.Mechanism:
    """Two shafts in their bearings with a universal joint between them, by the one equation that is left of it."""
    mechanism = jn.mechanics.Mechanism(gravity=0.0)
    out = (np.cos(bend), 0.0, np.sin(bend))
    first = mechanism.body("first", 1.0, ORIGIN, (0.02, 0.02, 0.02))
    second = mechanism.body("second", 1.0, ORIGIN, (0.01, 0.01, 0.01))
    turn = mechanism.revolute("in", mechanism.ground, first, at=ORIGIN, axis=X)
    mechanism.revolute("out", mechanism.ground, second, at=ORIGIN, axis=out)
    mechanism.perpendicular("cross", first, second, axis=Y, second_axis=np.cross(out, Y))
    torque = mechanism.motion("drive", turn, mechanism.track("angle"))
    mechanism.output("drive.torque", torque, "N*m", "torque on the first shaft")
    mechanism.watch_coordinates()
    return mechanism


def test_universal_joint_has_its_ratio_of_speeds():
    """tan(out) = cos(bend) tan(in) for a first pin that starts across the plane of both shafts (Cardan)."""
    bend, speed = np.radians(30.0), 5.0
    drive = {"angle": jn.mechanics.constant_rate(speed)}
    run = jn.simulate_mechanism(cross(bend), 2.0, motions=drive, output_step=0.01, tolerance=1e-9)
    turn = speed * run["time"].values
    ratio = np.cos(bend) / (1.0 - np.sin(bend) ** 2 * np.sin(turn) ** 2)
    np.testing.assert_allclose(run["out.angle rate"] / speed, ratio, rtol=1e-9)
    turned = run["out.angle"]
    left, right = np.sin(turned) * np.cos(turn), np.cos(bend) * np.sin(turn) * np.cos(turned)
    np.testing.assert_allclose(left, right, rtol=0.0, atol=1e-11)
    torque = 0.01 * run["out.angle acceleration"] * ratio
    np.testing.assert_allclose(run["drive.torque"], torque, rtol=0.0, atol=1e-9)


@cache
def governor() -> jn.mechanics.Mechanism:
    """Watt's governor: two balls on arms that a spindle turns, a sleeve that links lift; links are massless rods."""
    mechanism = jn.mechanics.Mechanism()
    spindle = mechanism.body("spindle", 1.0, ORIGIN, (0.01, 0.01, 0.01))
    sleeve = mechanism.body("sleeve", 1.5, (0.0, 0.0, -2.0 * REACH), (1e-3, 1e-3, 1e-3))
    turn = mechanism.revolute("bearing", mechanism.ground, spindle, at=ORIGIN, axis=Z)
    mechanism.prismatic("slide", spindle, sleeve, axis=Z, at=ORIGIN)
    for side, sign in (("left", 1.0), ("right", -1.0)):
        ball = mechanism.body(side, 0.6, (sign * REACH, 0.0, -REACH))
        mechanism.revolute(f"{side} arm", spindle, ball, at=ORIGIN, axis=(0.0, -sign, 0.0))
        mechanism.rod(
            f"{side} link", ball, sleeve, (sign * REACH, 0.0, -REACH), (0.0, 0.0, -2.0 * REACH)
        )
    torque = mechanism.motion("drive", turn, mechanism.track("angle"))
    mechanism.output("drive.torque", torque, "N*m", "torque on the spindle")
    mechanism.watch_body(sleeve)
    mechanism.watch_coordinates()
    mechanism.watch_energy()
    return mechanism


REACH = 0.3 / np.sqrt(2.0)  # arm and link 0.3 m, at 45 degrees in the design pose


def test_governor_hunts_as_lagrange_says():
    """Arms at a from the axis: balls at l sin a, sleeve 2 l cos a below; one equation of motion at a given speed."""
    speed = 16.0
    run = jn.simulate_mechanism(
        governor(),
        2.0,
        motions={"angle": jn.mechanics.constant_rate(speed)},
        output_step=0.01,
        tolerance=1e-9,
    )

    def hunting(_, state):
        a, rate = state
        inertia = 2.0 * 0.6 + 4.0 * 1.5 * np.sin(a) ** 2
        force = 2.0 * 0.6 * speed**2 * np.sin(a) * np.cos(a) - 4.0 * 1.5 * rate**2 * np.sin(
            a
        ) * np.cos(a)
        force -= 2.0 * (0.6 + 1.5) * 9.81 / 0.3 * np.sin(a)
        return rate, force / inertia

    time = run["time"].values
    exact = solve_ivp(
        hunting,
        (0.0, 2.0),
        (0.25 * np.pi, 0.0),
        rtol=1e-12,
        atol=1e-12,
        method="DOP853",
        t_eval=time,
    )
    for side in ("left", "right"):
        np.testing.assert_allclose(
            run[f"{side} arm.angle"] + 0.25 * np.pi, exact.y[0], rtol=0.0, atol=1e-6
        )
    np.testing.assert_allclose(run["sleeve.z"], -0.6 * np.cos(exact.y[0]), rtol=0.0, atol=1e-6)
    torque = 1.2 * 0.3**2 * speed * np.sin(2.0 * exact.y[0]) * exact.y[1]
    np.testing.assert_allclose(run["drive.torque"], torque, rtol=0.0, atol=1e-5)
    assert float(np.ptp(exact.y[0])) > 0.3
