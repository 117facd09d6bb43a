"""Andrews' squeezing mechanism: seven bodies in a plane, three loops, a spring, a torque; published end values.

Numbers and reference: Test Set for Initial Value Problem Solvers, release 2.4, "Andrews' squeezing mechanism" (after
Schiehlen, Multibody Systems Handbook, 1990; Hairer and Wanner, Solving Ordinary Differential Equations II, VII.7).
"""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

pytestmark = pytest.mark.source(
    kind="published",
    of="mechanisms in space",
    key="ivp-test-set",
    where="Andrews' squeezing mechanism: reference at 0.03 s",
    tolerance="fifteen digits; 2e-8 rad, 2e-7 and 2e-6 are asked for",
)

BETA, THETA, GAMMA = -0.0617138900142764496358948458001, 0.0, 0.455279819163070380255912382449
PHI, DELTA, OMEGA = (
    0.222668390165885884674473185609,
    0.487364979543842550225598953530,
    -0.222668390165885884674473185609,
)
EPSILON = 1.23054744454982119249735015568
START = {
    "beta": BETA,
    "theta": THETA,
    "gamma": GAMMA,
    "phi": PHI,
    "delta": DELTA,
    "omega": OMEGA,
    "epsilon": EPSILON,
}
END = {  # angle (rad), speed (rad/s) and acceleration (rad/s^2) at 0.03 s
    "beta": (15.81077119629904, 1139.920302151208, -24631.76316945196),
    "theta": (-15.75637105984298, -1424.379294994111, 51850.37701610329),
    "gamma": (0.04082224013073101, 11.03291221937134, 324102.5686413781),
    "phi": (-0.5347301163226948, 19.29337464421385, 566749.3645176213),
    "delta": (0.5244099658805304, 0.5735699284790808, 16743.62929479361),
    "omega": (0.5347301163226948, -19.29337464421385, -566749.3645176222),
    "epsilon": (1.048080741042263, 0.3231791658026955, 9826.520791458422),
}
Z = (0.0, 0.0, 1.0)


def toward(angle, along, across=0.0):
    """``along`` the direction of an angle and ``across`` it, a quarter turn on, m."""
    return np.array(
        [
            along * np.cos(angle) - across * np.sin(angle),
            along * np.sin(angle) + across * np.cos(angle),
            0.0,
        ]
    )


def squeezer() -> jn.mechanics.Mechanism:
    mechanism = jn.mechanics.Mechanism(gravity=0.0)
    a, b, c = (
        np.array([-0.06934, -0.00227, 0.0]),
        np.array([-0.03635, 0.03273, 0.0]),
        np.array([0.014, 0.072, 0.0]),
    )
    pin = toward(BETA, 0.007)
    e, f = a + toward(DELTA, 0.04), a + toward(EPSILON, 0.0, -0.04)
    knot = pin - toward(BETA + THETA, 0.028)

    def body(name, mass, centre, moment):
        return mechanism.body(name, mass, centre, (moment, moment, moment))

    k1 = body("k1", 0.04325, toward(BETA, 0.00092), 2.194e-6)
    k2 = body("k2", 0.00365, pin - toward(BETA + THETA, 0.0115), 4.410e-7)
    k3 = body("k3", 0.02373, b + toward(GAMMA, 0.01043, -0.01874), 5.255e-6)
    k4 = body("k4", 0.00706, e + toward(PHI + DELTA, 0.0, -(0.02 - 0.01421)), 5.667e-7)
    k5 = body("k5", 0.07050, a + toward(DELTA, 0.02308, 0.00916), 1.169e-5)
    k6 = body("k6", 0.00706, f + toward(OMEGA + EPSILON, 0.02 - 0.01421), 5.667e-7)
    k7 = body("k7", 0.05498, a + toward(EPSILON, 0.00449, -0.01228), 1.912e-5)
    mechanism.revolute("beta", mechanism.ground, k1, at=(0.0, 0.0, 0.0), axis=Z)
    mechanism.revolute("theta", k1, k2, at=pin, axis=Z)
    mechanism.revolute("gamma", mechanism.ground, k3, at=b, axis=Z)
    mechanism.revolute("delta", mechanism.ground, k5, at=a, axis=Z)
    mechanism.revolute("phi", k5, k4, at=e, axis=Z)
    mechanism.revolute("epsilon", mechanism.ground, k7, at=a, axis=Z)
    mechanism.revolute("omega", k7, k6, at=f, axis=Z)
    for name, other in (("knot 3", k3), ("knot 4", k4), ("knot 6", k6)):
        mechanism.coincident(name, k2, other, at=knot)
    mechanism.spring_damper(
        "spring",
        mechanism.ground,
        k3,
        c,
        b + toward(GAMMA, 0.02, -0.018),
        stiffness=4530.0,
        free_length=0.07785,
    )
    mechanism.apply_torque(k1, (0.0, 0.0, 0.033))
    mechanism.watch_coordinates()
    mechanism.watch_energy()
    return mechanism


def test_squeezer_ends_where_the_test_set_says():
    run = jn.simulate_mechanism(
        squeezer(), 0.03, redundant="remove", output_step=1e-3, tolerance=1e-11
    )
    for name, (angle, speed, acceleration) in END.items():
        np.testing.assert_allclose(
            run[f"{name}.angle"][-1] + START[name], angle, rtol=0.0, atol=2e-8
        )
        np.testing.assert_allclose(run[f"{name}.angle rate"][-1], speed, rtol=2e-7, atol=0.0)
        np.testing.assert_allclose(
            run[f"{name}.angle acceleration"][-1], acceleration, rtol=2e-6, atol=0.0
        )
    put_in = 0.033 * run["beta.angle"]
    balance = run["energy.kinetic"] + run["energy.elastic"] - put_in
    np.testing.assert_allclose(balance, balance[0], rtol=0.0, atol=1e-9 * float(put_in[-1]))
    assert float(run["constraint.residual"].max()) < 1e-14
