"""Passive and skyhook dampers on a reproducible rough road: printed r.m.s. values of acceleration, stroke and tyre.

Car: 400 / 40 kg, 25 / 200 kN/m; road of class C (256e-6 m^3 at 0.1 1/m), n_i = 0.01 i for i = 2 ... 300 with phases
2 pi frac(i * 0.6180339887498949), 20 m/s: period 5 s, r.m.s. 12.81605 mm. The values come from Runge-Kutta steps of
0.2 ms, the laws evaluated at each; two-state laws chatter, so their values spread by 3 %.
"""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.control import Passive, SemiActiveDamper, Skyhook, TwoStateSkyhook

pytestmark = pytest.mark.source(
    kind="computed",
    of="control",
    where="a rough road of 299 cosines; Runge-Kutta steps of 0.2 ms beside jounce",
    tolerance="0.01 % (passive), 0.5 % (skyhook), 3 % (two-state law, which chatters)",
)

SPEED, PERIOD, STEP = 20.0, 5.0, 5e-4
DAMPER = SemiActiveDamper(minimum=300.0, maximum=4000.0, lag=0.0)
PASSIVE = {  # N s/m: m/s^2, mm, mm
    300.0: (2.0964, 32.769, 8.2600),
    1172.6: (1.2183, 13.797, 4.3368),
    1500.0: (1.23520, 12.1731, 4.03544),
    2483.6: (1.3841, 9.4527, 3.7829),
    4000.0: (1.6547, 7.4444, 4.0086),
}


def road_height(t: np.ndarray) -> np.ndarray:
    i = np.arange(2, 301)
    n = 0.01 * i
    amplitude = np.sqrt(2.0 * 256e-6 * (0.1 / n) ** 2 * 0.01)
    phase = 2.0 * np.pi * np.modf(0.6180339887498949 * i)[0]
    return np.cos(2.0 * np.pi * SPEED * np.outer(t, n) + phase) @ amplitude


def car(coefficient: float = 1500.0) -> jn.QuarterCar:
    return jn.QuarterCar(
        sprung={"mass": 400.0},
        unsprung={"mass": 40.0},
        strut={"spring": {"rate": 25e3}, "damper": {"coefficient": coefficient}},
        tyre={"stiffness": 200e3, "lift_off": False},
    )


def trial(periods: int) -> jn.Trial:
    one = np.arange(0.0, PERIOD - 0.5 * STEP, STEP)
    height = np.append(np.tile(road_height(one), periods), road_height(np.zeros(1)))
    return jn.Trial(excitation=jn.Excitation(time=np.arange(len(height)) * STEP, height=height))


def last_period(run: object) -> tuple[float, float, float]:
    values = [
        run[name].to_numpy()[-5001:-1]
        for name in ("sprung.az", "strut.deflection", "tyre.deflection")
    ]
    return tuple(
        scale * np.std(value) for scale, value in zip((1.0, 1e3, 1e3), values, strict=True)
    )


def test_road_is_the_published_one() -> None:
    t = np.arange(0.0, PERIOD, 1e-3)
    assert np.std(road_height(t)) == pytest.approx(12.81605e-3, abs=1e-8)
    np.testing.assert_allclose(road_height(t + PERIOD), road_height(t), atol=1e-12)


@pytest.mark.parametrize("coefficient", PASSIVE)
def test_passive_dampers(coefficient: float) -> None:
    periods = 8 if coefficient < 1000.0 else 3  # until the start is forgotten
    found = last_period(jn.simulate(car(coefficient), trial(periods)))
    assert found == pytest.approx(PASSIVE[coefficient], rel=1e-4)


@pytest.mark.no_source
def test_an_actuator_that_holds_still_is_the_passive_damper() -> None:
    run = jn.simulate(
        car(300.0), trial(2), control=Passive(damping_coefficient=1500.0, actuator=DAMPER)
    )
    assert last_period(run) == pytest.approx(PASSIVE[1500.0], rel=1e-4)


def test_two_state_skyhook() -> None:
    run = jn.simulate(car(), trial(2), control=TwoStateSkyhook(actuator=DAMPER))
    assert last_period(run) == pytest.approx((1.3226, 9.807, 5.211), rel=0.03)


def test_linear_skyhook() -> None:
    run = jn.simulate(
        car(), trial(2), control=Skyhook(damping_coefficient=4000.0, actuator=DAMPER, rate=5000.0)
    )
    assert last_period(run) == pytest.approx((0.9456, 13.544, 6.866), rel=0.005)
