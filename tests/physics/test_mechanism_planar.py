"""Planar linkages whose hinges lie in space: their motion, forces and energies against closed forms."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp

import jounce as jn

Y = (0.0, 1.0, 0.0)
CRANK, COUPLER, ROCKER, BASE = 0.2, np.hypot(0.4, 0.1), np.hypot(0.1, 0.3), 0.5  # m


def bar(mechanism, name, mass, start, end):
    """A thin straight bar that is a little thick, so that no moment is zero."""
    one, other = np.array(start), np.array(end)
    along = (other - one) / np.linalg.norm(other - one)
    tensor = mass * (other - one) @ (other - one) / 12.0 * (
        np.eye(3) - np.outer(along, along)
    ) + 1e-4 * np.eye(3)
    return mechanism.body(name, mass, 0.5 * (one + other), tensor)


@cache
def four_bar() -> jn.mechanics.Mechanism:
    """Ground A to D, crank A to B, coupler B to C, rocker D to C: a Grashof chain whose crank goes round."""
    mechanism = jn.mechanics.Mechanism()
    a, b, c, d = (0.0, 0.0, 0.0), (0.0, 0.0, 0.2), (0.4, 0.0, 0.3), (0.5, 0.0, 0.0)
    crank = bar(mechanism, "crank", 1.0, a, b)
    coupler = bar(mechanism, "coupler", 2.0, b, c)
    rocker = bar(mechanism, "rocker", 1.5, d, c)
    mechanism.revolute("A", mechanism.ground, crank, at=a, axis=Y)
    mechanism.revolute("B", crank, coupler, at=b, axis=Y)
    mechanism.revolute("D", mechanism.ground, rocker, at=d, axis=Y)
    mechanism.revolute("C", coupler, rocker, at=c, axis=Y)
    mechanism.watch_energy()
    mechanism.watch_coordinates()
    mechanism.watch_angle("transmission", coupler, rocker, Y)
    for joint in "ABCD":
        mechanism.watch_reaction(joint)
    for body in (crank, coupler, rocker):
        mechanism.watch_body(body)
    return mechanism


@cache
def four_bar_run(tolerance: float = 1e-9):
    return jn.simulate_mechanism(
        four_bar(),
        2.0,
        start={"A.angle rate": 12.0},
        redundant="remove",
        output_step=0.01,
        tolerance=tolerance,
    )


def chain(turn):
    """Places of B and C (x, z) for a turn of the crank (rad): C is where two circles meet."""
    b = CRANK * np.array([np.sin(turn), np.cos(turn)])
    reach = (np.array([BASE, 0.0]) - b.T).T
    distance = np.hypot(*reach)
    along = (COUPLER**2 - ROCKER**2 + distance**2) / (2.0 * distance)
    up = np.sqrt(COUPLER**2 - along**2)
    e = reach / distance
    c = b + along * e + up * np.array([-e[1], e[0]])
    return b, c


def energy(turn):
    """Potential energy (J) and inertia (kg m^2) seen by the crank, from the places of the joints alone."""
    step = 1e-5
    b, c = chain(turn)
    (b1, c1), (b0, c0) = chain(turn + step), chain(turn - step)
    v_b, v_c = (b1 - b0) / (2.0 * step), (c1 - c0) / (2.0 * step)
    ends = [(1.0, 0.0 * v_b, v_b), (2.0, v_b, v_c), (1.5, 0.0 * v_c, v_c)]
    lengths = (CRANK, COUPLER, ROCKER)
    inertia = 0.0
    for (mass, one, other), length in zip(ends, lengths, strict=True):
        inertia += mass / 3.0 * (one @ one + one @ other + other @ other)
        inertia += 1e-4 * ((other - one) @ (other - one)) / length**2
    return 9.81 * (0.5 * b[1] + b[1] + c[1] + 0.75 * c[1]), inertia


def test_four_bar_follows_the_closed_form():
    run = four_bar_run()
    b, c = chain(run["A.angle"].values)
    np.testing.assert_allclose(run["rocker.x"], 0.5 * (BASE + c[0]), rtol=0.0, atol=1e-11)
    np.testing.assert_allclose(run["rocker.z"], 0.5 * c[1], rtol=0.0, atol=1e-11)
    np.testing.assert_allclose(run["coupler.x"], 0.5 * (b[0] + c[0]), rtol=0.0, atol=1e-11)
    assert float(run["constraint.residual"].max()) < 1e-12


def test_four_bar_takes_as_long_for_a_turn_as_its_energy_says():
    run = four_bar_run()
    height, inertia = energy(0.0)
    total = height + 0.5 * inertia * 12.0**2
    end = float(run["A.angle"][100])
    expected, _ = quad(
        lambda turn: np.sqrt(0.5 * energy(turn)[1] / (total - energy(turn)[0])),
        0.0,
        end,
        epsabs=1e-12,
    )
    assert end > 6.0
    assert expected == pytest.approx(1.0, abs=2e-8)


def test_four_bar_keeps_its_energy_and_converges():
    drifts = []
    for tolerance in (1e-5, 1e-7, 1e-9):
        run = four_bar_run(tolerance)
        total = run["energy.kinetic"] + run["energy.weight"]
        drifts.append(float(abs(total - total[0]).max() / run["energy.kinetic"].max()))
    assert drifts[0] < 1e-5
    assert drifts[1] < 1e-7
    assert drifts[2] < 1e-9


def test_four_bar_closes_its_loops_between_long_steps():
    """Samples lie on a step's interpolant, which is far from closed: one projection left 7e-13 m of it."""
    assert float(four_bar_run(1e-3)["constraint.residual"].max()) < 1e-14


def test_four_bar_stands_on_what_its_ground_joints_carry():
    run = four_bar_run()
    masses = {"crank": 1.0, "coupler": 2.0, "rocker": 1.5}
    for axis, weight in (("x", 0.0), ("y", 0.0), ("z", 4.5 * 9.81)):
        rate = sum(mass * run[f"{body}.a{axis}"] for body, mass in masses.items())
        held = run[f"A.f{axis}"] + run[f"D.f{axis}"]
        np.testing.assert_allclose(held, rate + weight, rtol=0.0, atol=1e-8)


def test_free_body_of_the_coupler_is_in_balance():
    """Newton and Euler on the coupler alone, with the reactions of both its hinges."""
    run = four_bar_run()
    b, c = chain(run["A.angle"].values)
    force_b = np.array([run["B.fx"], run["B.fz"]])
    force_c = -np.array([run["C.fx"], run["C.fz"]])  # C acts on the rocker
    accelerated = 2.0 * np.array([run["coupler.ax"], run["coupler.az"] + 9.81])
    np.testing.assert_allclose(force_b + force_c, accelerated, rtol=0.0, atol=1e-7)
    centre = 0.5 * (b + c)
    torque = sum(
        arm[1] * force[0] - arm[0] * force[1]
        for arm, force in ((b - centre, force_b), (c - centre, force_c))
    )
    spin = 2.0 * COUPLER**2 / 12.0 + 1e-4
    np.testing.assert_allclose(torque, spin * run["coupler.alpha_y"], rtol=0.0, atol=1e-7)


def test_transmission_angle_is_that_between_the_bars():
    run = four_bar_run()
    b, c = chain(run["A.angle"].values)
    coupler, rocker = b - c, (np.array([BASE, 0.0]) - c.T).T
    angle = np.arctan2(
        coupler[1] * rocker[0] - coupler[0] * rocker[1], np.sum(coupler * rocker, axis=0)
    )
    np.testing.assert_allclose(
        run["transmission"] - run["transmission"][0], angle - angle[0], rtol=0.0, atol=1e-10
    )
    rate, acceleration = (
        run[f"rocker.{name}"] - run[f"coupler.{name}"] for name in ("wy", "alpha_y")
    )
    np.testing.assert_allclose(run["transmission rate"], rate, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(run["transmission acceleration"], acceleration, rtol=0.0, atol=1e-7)


@cache
def slider_crank() -> jn.mechanics.Mechanism:
    mechanism = jn.mechanics.Mechanism()
    crank = mechanism.body("crank", 1.0, (0.04, 0.0, 0.0), (1e-3, 2e-3, 2e-3))
    rod = mechanism.body("rod", 0.5, (0.18, 0.0, 0.0), (1e-4, 2e-3, 2e-3))
    piston = mechanism.body("piston", 0.4, (0.3, 0.0, 0.0), (1e-4, 1e-4, 1e-4))
    turn = mechanism.revolute(
        "main", mechanism.ground, crank, at=(0.0, 0.0, 0.0), axis=(0.0, -1.0, 0.0)
    )
    mechanism.revolute("pin", crank, rod, at=(0.1, 0.0, 0.0), axis=(0.0, -1.0, 0.0))
    mechanism.prismatic("guide", mechanism.ground, piston, axis=(1.0, 0.0, 0.0), at=(0.3, 0.0, 0.0))
    mechanism.coincident("gudgeon", rod, piston, at=(0.3, 0.0, 0.0))
    torque = mechanism.motion("drive", turn, mechanism.track("crank angle"))
    mechanism.output("drive.torque", torque, "N*m", "torque on the crank")
    mechanism.watch_body(piston)
    mechanism.watch_reaction("main")
    mechanism.watch_reaction("guide")
    mechanism.watch_energy()
    return mechanism


def slider_crank_energy(time, speed):
    """Kinetic and potential energy (J) of the closed form, for crank 0.1 m and rod 0.2 m; time may be complex."""
    turn = speed * time
    tilt = np.arcsin(-0.5 * np.sin(turn))
    tilt_rate = -0.5 * speed * np.cos(turn) / np.cos(tilt)
    piston = -0.1 * speed * np.sin(turn) - 0.2 * np.sin(tilt) * tilt_rate
    rod_x = -0.1 * speed * np.sin(turn) - 0.08 * np.sin(tilt) * tilt_rate
    rod_z = 0.1 * speed * np.cos(turn) + 0.08 * np.cos(tilt) * tilt_rate
    kinetic = 0.2 * piston**2 + 0.25 * (rod_x**2 + rod_z**2) + 1e-3 * tilt_rate**2
    kinetic = kinetic + 0.5 * (2e-3 + 1.0 * 0.04**2) * speed**2
    return kinetic + 9.81 * (0.04 * np.sin(turn) + 0.5 * (0.1 * np.sin(turn) + 0.08 * np.sin(tilt)))


def test_driven_slider_crank_takes_the_torque_of_the_closed_form():
    speed, step = 20.0, 1e-20
    run = jn.simulate_mechanism(
        slider_crank(),
        0.6,
        motions={"crank angle": jn.mechanics.constant_rate(speed)},
        redundant="remove",
        output_step=0.005,
        tolerance=1e-9,
    )
    time = run["time"].values
    tilt = np.arcsin(-0.5 * np.sin(speed * time))
    np.testing.assert_allclose(
        run["piston.x"], 0.1 * np.cos(speed * time) + 0.2 * np.cos(tilt), rtol=0.0, atol=1e-11
    )
    # the rate of the energy, by complex time instead of differences
    power = np.imag(slider_crank_energy(time + 1j * step, speed)) / step
    np.testing.assert_allclose(run["drive.torque"] * speed, power, rtol=0.0, atol=1e-7)
    np.testing.assert_allclose(
        run["main.ty"], -run["drive.torque"], rtol=0.0, atol=1e-9
    )  # about -y
    balance = run["energy.kinetic"] + run["energy.weight"] - run["energy.supplied"]
    assert float(abs(balance - balance[0]).max()) < 1e-7 * float(run["energy.kinetic"].max())


@cache
def windows(count: int) -> jn.mechanics.Mechanism:
    """Four-bars side by side: ``count + 1`` upright bars and ``count`` level ones, 1 m and 1 kg each."""
    mechanism = jn.mechanics.Mechanism()
    uprights = []
    for i in range(count + 1):
        uprights.append(
            bar(mechanism, f"upright {i}", 1.0, (float(i), 0.0, 0.0), (float(i), 0.0, 1.0))
        )
        mechanism.revolute(
            f"foot {i}", mechanism.ground, uprights[i], at=(float(i), 0.0, 0.0), axis=Y
        )
    for i in range(count):
        level = bar(mechanism, f"level {i}", 1.0, (float(i), 0.0, 1.0), (float(i + 1), 0.0, 1.0))
        mechanism.revolute(f"left {i}", uprights[i], level, at=(float(i), 0.0, 1.0), axis=Y)
        mechanism.revolute(
            f"right {i}", level, uprights[i + 1], at=(float(i + 1), 0.0, 1.0), axis=Y
        )
    mechanism.watch_energy()
    mechanism.watch_coordinates()
    return mechanism


@pytest.mark.parametrize(
    ("push", "tolerance"), [(1.1, 1e-5), (0.7, 1e-6), (1.37, 1e-7), (1.0, 1e-8), (0.83, 1e-9)]
)
def test_windows_pass_their_singular_poses(push: float, tolerance: float):
    """The N four-bar benchmark (IFToMM library of benchmark problems): all bars lie on one line at 90 and 270 degrees.

    All uprights turn together, so the closed form is that of one pendulum. Without a second look at such poses about
    half of these runs would end there, or go on on another branch with another energy.
    """
    count = 2
    run = jn.simulate_mechanism(
        windows(count),
        4.0,
        start={"foot 0.angle rate": push},
        redundant="remove",
        output_step=0.01,
        tolerance=tolerance,
    )
    inertia = (count + 1) * (1.0 / 3.0 + 1e-4) + count
    lever = (count + 1) * 0.5 + count

    def swing(_, state):
        return state[1], 9.81 * lever / inertia * np.sin(state[0])

    time = run["time"].values
    exact = solve_ivp(
        swing, (0.0, 4.0), (0.0, push), rtol=1e-12, atol=1e-12, t_eval=time, method="DOP853"
    )
    for i in range(count + 1):
        np.testing.assert_allclose(
            run[f"foot {i}.angle"], exact.y[0], rtol=0.0, atol=max(1e-4, 100.0 * tolerance)
        )
    assert float(run["foot 0.angle"].max()) > np.radians(630.0)
    assert float(run["constraint.residual"].max()) < 1e-9


@cache
def scissors(stages: int) -> jn.mechanics.Mechanism:
    """Pairs of crossed bars of 1 m and 1 kg on a fixed hinge and a slider, held at the slider."""
    mechanism = jn.mechanics.Mechanism()
    width, height = np.cos(SPREAD), np.sin(SPREAD)
    slider = mechanism.body("slider", 0.5, (width, 0.0, 0.0), (0.01, 0.01, 0.01))
    place = mechanism.prismatic(
        "slide", mechanism.ground, slider, axis=(1.0, 0.0, 0.0), at=(width, 0.0, 0.0)
    )
    left, right = mechanism.ground, slider
    for i in range(stages):
        low, high = i * height, (i + 1) * height
        up = bar(mechanism, f"up {i}", 1.0, (0.0, 0.0, low), (width, 0.0, high))
        down = bar(mechanism, f"down {i}", 1.0, (width, 0.0, low), (0.0, 0.0, high))
        mechanism.revolute(f"left {i}", left, up, at=(0.0, 0.0, low), axis=Y)
        mechanism.revolute(f"right {i}", right, down, at=(width, 0.0, low), axis=Y)
        mechanism.revolute(
            f"cross {i}", up, down, at=(0.5 * width, 0.0, low + 0.5 * height), axis=Y
        )
        left, right = down, up
    mechanism.output(
        "hold.force",
        mechanism.motion("hold", place, mechanism.track("spread")),
        "N",
        "force on the slider",
    )
    mechanism.watch_point("top", right, (width, 0.0, stages * height))
    mechanism.watch_coordinates()
    mechanism.watch_energy()
    return mechanism


SPREAD = np.radians(40.0)


def test_scissors_take_the_force_of_virtual_work_and_lift_as_they_close():
    """The hinges that close its loops repeat each other across the plane, so most of their equations go."""
    stages, speed = 2, -0.2
    run = jn.simulate_mechanism(
        scissors(stages),
        0.5,
        motions={"spread": jn.mechanics.step(0.0, speed, begin=0.1, stop=0.4)},
        redundant="remove",
        output_step=0.01,
        tolerance=1e-9,
    )
    width = np.cos(SPREAD) + run["slide.distance"]
    np.testing.assert_allclose(run["top.z"], stages * np.sqrt(1.0 - width**2), rtol=0.0, atol=1e-12)
    rise = -width / np.sqrt(1.0 - width**2)  # of one stage for 1 m of the slider
    still = (
        2.0 * 9.81 * 0.5 * stages**2 * rise
    )  # 2 kg a stage, its middle at (i + 1/2) of a stage's height
    np.testing.assert_allclose(run["hold.force"][:10], still[:10], rtol=1e-10)
    np.testing.assert_allclose(run["hold.force"][41:], still[41:], rtol=1e-10)
    balance = run["energy.kinetic"] + run["energy.weight"] - run["energy.supplied"]
    assert float(abs(balance).max()) < 1e-7
    assert float(run["constraint.residual"].max()) < 1e-12
