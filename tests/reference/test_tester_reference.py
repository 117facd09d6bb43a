"""Testers of shock absorbers against numbers that are written down elsewhere.

Car A (400 kg, 40 kg, 25 kN/m, 200 kN/m, no tyre damping, plate +-3 mm): table of steady states, sweeps and the
3-DOF rig computed independently from the equations of the quarter car; paper 2's table 1 for the Audi corner.
"""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from jounce.parts import QuarterCar, load
from jounce.parts.testers import load_tester
from jounce.testers.periodic import steady_sweep
from jounce.testers.plate_response import (
    closed_form_adhesion,
    least_phase_angle,
    road_damping_ratio,
    steady_response,
    wheel_mode,
)
from jounce.testers.plates import tyre_rigidity
from jounce.testers.testing import simulate_test

pytestmark = pytest.mark.source(
    kind="computed",
    of="testers and inspection",
    where="car A: 400 kg, 40 kg, 25 N/mm, 200 N/mm, plate of 3 mm; its equations solved beside jounce",
    tolerance="the printed digits; 0.05 points and 0.1 degrees of run-downs",
)

EUSAMA, THETA = load_tester("eusama"), load_tester("theta-msd3000")


def car_a(damping, stiffness=200e3):
    return QuarterCar.from_table(
        {
            "sprung": {"mass": 400.0},
            "unsprung": {"mass": 40.0},
            "strut": {"spring": {"rate": 25e3}, "damper": {"coefficient": float(damping)}},
            "tyre": {"stiffness": stiffness},
        }
    )


# c: adhesion %, Hz, phase deg, Hz, wheel mode Hz, damping ratio
STEADY = {
    500: (25.69, 12.04, 31.16, 8.06, 11.931, 0.0851),
    1000: (60.25, 12.28, 57.27, 7.76, 11.890, 0.1708),
    1500: (70.95, 12.60, 76.53, 7.23, 11.820, 0.2575),
    2000: (75.87, 12.94, 89.50, 6.41, 11.720, 0.3458),
}


@pytest.mark.parametrize("damping", STEADY)
def test_steady_adhesion_phase_and_mode(damping):
    adhesion, at, phase, there, frequency, ratio = STEADY[damping]
    rig = car_a(damping)
    found = closed_form_adhesion(rig, EUSAMA)
    assert 100.0 * found[0] == pytest.approx(adhesion, abs=0.006)
    assert found[1] == pytest.approx(at, abs=0.011)
    least = least_phase_angle(rig, EUSAMA)
    assert np.degrees(least[0]) == pytest.approx(phase, abs=0.006)
    assert least[1] == pytest.approx(there, abs=0.011)
    mode = wheel_mode(rig, EUSAMA)
    assert mode.frequency_hz == pytest.approx(frequency, abs=0.0006)
    assert mode.damping_ratio == pytest.approx(ratio, abs=0.00006)


@pytest.mark.no_source
@pytest.mark.parametrize("damping", STEADY)
def test_simulated_steady_states_are_the_closed_form_without_lift_off(damping):
    rig = car_a(damping)
    sweep, closed = steady_sweep(rig, EUSAMA), closed_form_adhesion(rig, EUSAMA)
    assert not sweep.lift_off
    assert sweep.adhesion == pytest.approx(closed[0], abs=1e-4)
    assert sweep.adhesion_frequency == pytest.approx(closed[1], abs=0.021)
    assert sweep.phase_angle == pytest.approx(least_phase_angle(rig, EUSAMA)[0], abs=1e-4)


# sweep rate in Hz/s, c: adhesion %, phase deg, after 1.5 s at 25 Hz
RUN_DOWN = {
    (1.0, 500): (27.63, 29.93),
    (1.0, 1000): (60.61, 56.26),
    (1.0, 1500): (71.09, 75.66),
    (2.5, 500): (30.80, 27.96),
    (2.5, 1000): (61.15, 54.66),
    (2.5, 1500): (71.28, 74.32),
    (10.0, 500): (41.72, 30.2),
    (10.0, 1000): (63.70, 40.7),
    (10.0, 1500): (72.19, 66.7),
}


@pytest.mark.parametrize(("rate", "damping"), RUN_DOWN)
def test_run_down(rate, damping):
    adhesion, phase = RUN_DOWN[rate, damping]
    tester = EUSAMA.with_changes({"programme.sweep_rate": rate, "sampling_frequency": 4000.0})
    record = simulate_test(car_a(damping), tester)
    time, static = record["time"].values, record.attrs["left.static_load"]
    force = record["truth.left.tyre.force"].values
    assert 100.0 * force.min() / static == pytest.approx(adhesion, abs=0.05)
    assert plain_phase_angle(
        time, record["left.plate.z"].values, force - static, rate
    ) == pytest.approx(phase, abs=0.1)


def plain_phase_angle(time, height, force, rate):
    """Least angle (deg) from a plate's top to the middle of the low-force half that lies in the turn it begins."""
    turned = (
        2.0 * np.pi * 25.0 * time - np.pi * rate * np.maximum(time - 1.5, 0.0) ** 2
    )  # exact chirp
    assert np.allclose(height, 0.003 * np.sin(turned), atol=1e-9)
    first, last = np.ceil(turned[0] / (2 * np.pi) - 0.25), np.floor(turned[-1] / (2 * np.pi) - 0.25)
    tops = np.interp(2.0 * np.pi * (np.arange(first, last + 1) + 0.25), turned, time)
    falls = _crossings(time, force, force[:-1] > 0.0, force[1:] <= 0.0)
    rises = _crossings(time, force, force[:-1] <= 0.0, force[1:] > 0.0)
    falls = falls[falls < rises[-1]]
    middles = 0.5 * (falls + rises[np.searchsorted(rises, falls)])
    angles = []
    for top, following in itertools.pairwise(tops):
        inside = middles[(middles >= top) & (middles < following)]
        if 6.0 <= 1.0 / (following - top) <= 18.0 and len(inside):
            angles.append(360.0 * (inside[0] - top) / (following - top))
    return min(angles)


def _crossings(time, force, before, after):
    i = np.flatnonzero(before & after)
    return time[i] + force[i] / (force[i] - force[i + 1]) * (time[i + 1] - time[i])


# c: rig mode Hz, damping ratio on the rig, greatest |z_p/e|, converted to the road, exactly on the road
SPRUNG = {
    200: (5.57, 0.0558, 5.078, 0.0345, 0.0340),
    400: (5.57, 0.1118, 2.565, 0.0690, 0.0681),
    600: (5.56, 0.1681, 1.739, 0.1038, 0.1022),
    800: (5.56, 0.2250, 1.335, 0.1389, 0.1364),
}


@pytest.mark.parametrize("damping", SPRUNG)
def test_sprung_plate(damping):
    frequency, on_rig, amplification, converted, on_road = SPRUNG[damping]
    rig = car_a(damping)
    mode = wheel_mode(rig, THETA, on="rig")
    assert mode.frequency_hz == pytest.approx(frequency, abs=0.006)
    assert mode.damping_ratio == pytest.approx(on_rig, abs=0.00006)
    response = steady_response(rig, THETA, np.linspace(3.0, 8.0, 5001))
    assert np.abs(response.plate_response).max() == pytest.approx(amplification, abs=0.0006)
    road = road_damping_ratio(
        mode.damping_ratio,
        wheel_rate=25e3,
        tyre_stiffness=200e3,
        unsprung_mass=40.0,
        plate_mass=20.0,
        plate_spring_rate=50e3,
    )
    assert road == pytest.approx(converted, abs=0.00006)
    assert wheel_mode(rig, THETA).damping_ratio == pytest.approx(on_road, abs=0.00006)


@pytest.mark.parametrize(
    ("damping", "on_rig"), [(200, 0.0479), (400, 0.0960), (600, 0.1443), (800, 0.1931)]
)
def test_stiffer_plate_spring(damping, on_rig):
    mode = wheel_mode(
        car_a(damping), THETA.with_changes({"plate_spring_rate": "100 N/mm"}), on="rig"
    )
    assert mode.damping_ratio == pytest.approx(on_rig, abs=0.00006)
    assert mode.frequency_hz == pytest.approx(6.83, abs=0.03)


@pytest.mark.source(
    kind="computed",
    of="testers and inspection",
    key="suspension-system",
    where="Table 1 on a EUSAMA plate; closed form beside jounce",
    tolerance="half a unit of the last printed digit",
)
@pytest.mark.parametrize(
    ("tyre_damping", "adhesion", "at"), [(1000.0, 72.5, 16.6), (0.0, 62.7, 14.6)]
)
def test_paper_2_corner(tyre_damping, adhesion, at):
    rig = load("audi-a6-quarter-car").with_changes({"tyre.damping_coefficient": tyre_damping})
    found = closed_form_adhesion(rig, EUSAMA)
    assert 100.0 * found[0] == pytest.approx(adhesion, abs=0.06)
    assert found[1] == pytest.approx(at, abs=0.06)


# tyre stiffness N/mm: force amplitude at 25 Hz over the plate's, and rigidity by the EGEA formula, N/mm; c = 1500 N s/m
@pytest.mark.parametrize(
    ("stiffness", "slope", "rigidity"),
    [(150, 175.5, 146.2), (200, 248.0, 187.6), (250, 329.6, 234.2), (300, 421.9, 286.9)],
)
def test_rigidity_formula(stiffness, slope, rigidity):
    response = steady_response(car_a(1500, 1e3 * stiffness), EUSAMA, [25.0])
    force = float(response.force_amplitude[0])
    assert force / 3.0 == pytest.approx(slope, abs=0.06)
    assert tyre_rigidity(force, 0.003) / 1e3 == pytest.approx(rigidity, abs=0.06)


def test_phase_limit_meets_the_damping_limit():
    # 35 degrees on car A at c = 566.5 N s/m, where the wheel's damping ratio is 0.0965 and EUSAMA gives 34.0 %
    rig = car_a(566.5)
    assert np.degrees(least_phase_angle(rig, EUSAMA)[0]) == pytest.approx(35.0, abs=0.02)
    assert wheel_mode(rig, EUSAMA).damping_ratio == pytest.approx(0.0965, abs=0.0001)
    assert 100.0 * closed_form_adhesion(rig, EUSAMA)[0] == pytest.approx(34.0, abs=0.06)
