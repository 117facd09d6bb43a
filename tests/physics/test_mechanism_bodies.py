"""Bodies that turn in space: tops, tumbling, spherical and conical pendulums, against closed forms."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.special import ellipj, ellipk

import jounce as jn

ORIGIN, Y = (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)


def turned(quaternion):
    """Rotation matrices of quaternions, shape (4, n) to (3, 3, n)."""
    w, x, y, z = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def named(run, joint, names):
    return np.array([run[f"{joint}.{name}"].values for name in names])


@cache
def tumbling() -> jn.mechanics.Mechanism:
    mechanism = jn.mechanics.Mechanism(gravity=0.0)
    mechanism.free("flight", mechanism.body("body", 2.0, (0.5, 0.1, 0.2), (1.0, 2.0, 2.8)))
    mechanism.watch_coordinates()
    mechanism.watch_energy()
    return mechanism


def tumbling_run(tolerance: float = 1e-9):
    """About the middle axis, which is unstable: the body turns over again and again, many full turns."""
    start = {
        "flight.wx": 0.1,
        "flight.wy": 6.0,
        "flight.wz": 0.0,
        "flight.x rate": 0.3,
        "flight.e0": 0.5,
    }
    start |= {"flight.e1": 0.5, "flight.e2": -0.5, "flight.e3": 0.5}
    return jn.simulate_mechanism(
        tumbling(), 30.0, start=start, output_step=0.05, tolerance=tolerance
    )


def test_tumbling_body_keeps_momentum_energy_and_the_length_of_its_quaternion():
    run = tumbling_run()
    e, spin = (
        named(run, "flight", ("e0", "e1", "e2", "e3")),
        named(run, "flight", ("wx", "wy", "wz")),
    )
    momentum = np.einsum("ijn,jn->in", turned(e), np.array([1.0, 2.0, 2.8])[:, None] * spin)
    np.testing.assert_allclose(np.sum(e**2, axis=0), 1.0, rtol=0.0, atol=1e-14)
    np.testing.assert_allclose(
        momentum, momentum[:, :1] * np.ones(run.sizes["time"]), rtol=0.0, atol=1e-7
    )
    np.testing.assert_allclose(run["energy.kinetic"], run["energy.kinetic"][0], rtol=1e-8)
    np.testing.assert_allclose(run["flight.x"], 0.3 * run["time"], rtol=0.0, atol=1e-9)


def test_tumbling_body_follows_jacobi():
    """Landau and Lifshitz, Mechanics, section 37: elliptic functions, here with energy above that of the middle axis.

    For M^2 < 2 E I2 the roles of axes 1 and 3 change.
    """
    run = tumbling_run(1e-10)
    i1, i2, i3 = 1.0, 2.0, 2.8
    spin = np.array([0.1, 6.0, 0.0])
    energy2, momentum2 = (
        i1 * spin[0] ** 2 + i2 * spin[1] ** 2,
        (i1 * spin[0]) ** 2 + (i2 * spin[1]) ** 2,
    )
    assert momentum2 < energy2 * i2
    rate = np.sqrt((i2 - i1) * (energy2 * i3 - momentum2) / (i1 * i2 * i3))
    modulus = (i3 - i2) * (momentum2 - energy2 * i1) / ((i2 - i1) * (energy2 * i3 - momentum2))
    top = np.sqrt((momentum2 - energy2 * i1) / (i2 * (i2 - i1)))
    assert spin[1] == pytest.approx(top)  # wz = 0 at the start: wy is at its summit
    sn, cn, dn, _ = ellipj(rate * run["time"].values + ellipk(modulus), modulus)
    np.testing.assert_allclose(run["flight.wy"], top * sn, rtol=0.0, atol=1e-6)
    third = np.sqrt((momentum2 - energy2 * i1) / (i3 * (i3 - i1)))
    first = np.sqrt((energy2 * i3 - momentum2) / (i1 * (i3 - i1)))
    np.testing.assert_allclose(abs(run["flight.wz"]), abs(cn) * third, rtol=0.0, atol=1e-6)
    np.testing.assert_allclose(run["flight.wx"], dn * first, rtol=0.0, atol=1e-6)
    assert float(run["flight.wy"].min()) < -5.9


def tilt(angle):
    return {"tip.e0": np.cos(0.5 * angle), "tip.e2": np.sin(0.5 * angle)}


@cache
def top() -> jn.mechanics.Mechanism:
    """1.2 kg at 0.1 m over its tip; 0.004 kg m^2 about its axis, 0.003 across it, both about the centre."""
    mechanism = jn.mechanics.Mechanism()
    body = mechanism.body("top", 1.2, (0.0, 0.0, 0.1), (0.003, 0.003, 0.004))
    mechanism.spherical("tip", mechanism.ground, body, at=ORIGIN)
    mechanism.watch_body(body)
    mechanism.watch_coordinates()
    mechanism.watch_reaction("tip")
    mechanism.watch_energy()
    return mechanism


@pytest.mark.parametrize("branch", [-1.0, 1.0])
def test_top_precesses_steadily(branch: float):
    """Slow and fast precession W of a symmetric top: A W^2 cos(a) - C n W + m g l = 0, n the spin along its axis."""
    angle, spin, across = np.radians(30.0), 120.0, 0.003 + 1.2 * 0.1**2
    a, b, c = across * np.cos(angle), -0.004 * spin, 1.2 * 9.81 * 0.1
    turning = (-b + branch * np.sqrt(b**2 - 4.0 * a * c)) / (2.0 * a)
    start = tilt(angle) | {"tip.wx": -turning * np.sin(angle), "tip.wz": spin}
    run = jn.simulate_mechanism(top(), 2.0, start=start, output_step=0.01, tolerance=1e-9)
    time = run["time"].values
    np.testing.assert_allclose(run["top.z"], 0.1 * np.cos(angle), rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(
        run["top.x"], 0.1 * np.sin(angle) * np.cos(turning * time), rtol=0.0, atol=2e-8
    )
    np.testing.assert_allclose(
        run["top.y"], 0.1 * np.sin(angle) * np.sin(turning * time), rtol=0.0, atol=2e-8
    )
    np.testing.assert_allclose(run["tip.fz"], 1.2 * 9.81, rtol=0.0, atol=1e-6)
    pull = np.hypot(run["tip.fx"], run["tip.fy"])
    np.testing.assert_allclose(pull, 1.2 * turning**2 * 0.1 * np.sin(angle), rtol=1e-7)


def test_top_that_is_let_go_nods_as_its_energy_and_momenta_say():
    """Both momenta and the energy fix the nodding between two heights (Lagrange's top)."""
    angle, spin, across = np.radians(50.0), 90.0, 0.003 + 1.2 * 0.1**2
    run = jn.simulate_mechanism(
        top(), 1.0, start=tilt(angle) | {"tip.wz": spin}, output_step=1e-3, tolerance=1e-9
    )
    height = run["top.z"] / 0.1  # cosine of the tilt
    momentum = 0.004 * spin
    ratio = momentum**2 / (4.0 * across * 1.2 * 9.81 * 0.1)
    lowest = ratio - np.sqrt(ratio**2 - 2.0 * ratio * np.cos(angle) + 1.0)
    assert float(height.max()) == pytest.approx(np.cos(angle), abs=1e-9)
    assert float(height.min()) == pytest.approx(lowest, abs=1e-5)
    vertical = (
        across * (run["top.x"] * run["top.vy"] - run["top.y"] * run["top.vx"]) / 0.1**2
        + momentum * height
    )
    np.testing.assert_allclose(vertical, momentum * np.cos(angle), rtol=1e-8)
    np.testing.assert_allclose(run["tip.wz"], spin, rtol=1e-9)


@cache
def pendulum(kind: str) -> jn.mechanics.Mechanism:
    mechanism = jn.mechanics.Mechanism()
    bob = mechanism.body("bob", 1.0, (0.0, 0.0, -1.0), (1e-3, 1e-3, 1e-3))
    if kind == "spherical":
        mechanism.spherical("pivot", mechanism.ground, bob, at=ORIGIN)
    elif kind == "universal":
        mechanism.universal(
            "pivot", mechanism.ground, bob, at=ORIGIN, axis=(1.0, 0.0, 0.0), second_axis=Y
        )
    else:
        mechanism.free("flight", bob)
        mechanism.rod("rod", mechanism.ground, bob, at=ORIGIN, second_at=(0.0, 0.0, -1.0))
    mechanism.watch_body(bob)
    mechanism.watch_energy()
    return mechanism


STARTS = {
    "spherical": {"pivot.wx": 2.0},
    "universal": {"pivot.angle": 0.0, "pivot.angle rate": 2.0},
    "rod": {"flight.y rate": 2.0},
}


@pytest.mark.parametrize("kind", STARTS)
def test_pendulum_swings_in_its_plane_as_the_elliptic_integral_says(kind: str):
    run = jn.simulate_mechanism(
        pendulum(kind), 3.0, start=STARTS[kind], output_step=0.01, tolerance=1e-9
    )
    inertia = 1.0 + (0.0 if kind == "rod" else 1e-3)  # the ball on a rod does not turn
    rate = np.sqrt(9.81 / inertia)
    modulus = (2.0 / (2.0 * rate)) ** 2
    sn = ellipj(rate * run["time"].values, modulus)[0]
    half = np.sqrt(modulus) * sn
    np.testing.assert_allclose(run["bob.z"], -1.0 + 2.0 * half**2, rtol=0.0, atol=3e-8)
    np.testing.assert_allclose(
        run["bob.y"], 2.0 * half * np.sqrt(1.0 - half**2), rtol=0.0, atol=3e-8
    )
    np.testing.assert_allclose(run["bob.x"], 0.0, rtol=0.0, atol=1e-10)
    assert float(run["constraint.residual"].max()) < 1e-12


def test_pendulum_goes_round_a_cone():
    angle = np.radians(40.0)
    turning = np.sqrt(9.81 / np.cos(angle))
    start = {
        "flight.x": np.sin(angle),
        "flight.z": 1.0 - np.cos(angle),
        "flight.y rate": turning * np.sin(angle),
    }
    run = jn.simulate_mechanism(pendulum("rod"), 3.0, start=start, output_step=0.01, tolerance=1e-9)
    time = run["time"].values
    np.testing.assert_allclose(
        run["bob.x"], np.sin(angle) * np.cos(turning * time), rtol=0.0, atol=1e-7
    )
    np.testing.assert_allclose(run["bob.z"], -np.cos(angle), rtol=0.0, atol=1e-8)


def test_double_pendulum_follows_the_textbook():
    """Lagrange's equations of two point masses on rods of 1 m, integrated by SciPy."""
    mechanism = jn.mechanics.Mechanism()
    upper = mechanism.body("upper", 1.0, (1.0, 0.0, 0.0))
    lower = mechanism.body("lower", 1.0, (2.0, 0.0, 0.0))
    mechanism.revolute("shoulder", mechanism.ground, upper, at=ORIGIN, axis=Y)
    mechanism.revolute(
        "elbow", lower, upper, at=(1.0, 0.0, 0.0), axis=Y
    )  # child first: the angle counts backwards
    mechanism.watch_coordinates()
    mechanism.watch_energy()
    run = jn.simulate_mechanism(mechanism, 3.0, output_step=0.01, tolerance=1e-10)

    def rates(_, state):
        a, b, u, v = state  # from the horizontal, downwards
        mass = np.array([[2.0, np.cos(a - b)], [np.cos(a - b), 1.0]])
        force = np.array(
            [
                -np.sin(a - b) * v**2 + 2.0 * 9.81 * np.cos(a),
                np.sin(a - b) * u**2 + 9.81 * np.cos(b),
            ]
        )
        return [u, v, *np.linalg.solve(mass, force)]

    time = run["time"].values
    exact = solve_ivp(
        rates, (0.0, 3.0), np.zeros(4), rtol=1e-12, atol=1e-12, method="DOP853", t_eval=time
    )
    np.testing.assert_allclose(run["shoulder.angle"], exact.y[0], rtol=0.0, atol=1e-6)
    np.testing.assert_allclose(
        run["shoulder.angle"] - run["elbow.angle"], exact.y[1], rtol=0.0, atol=1e-6
    )
    total = run["energy.kinetic"] + run["energy.weight"]
    assert float(abs(total).max()) < 1e-8
