"""Random cars on testers, force noise of 1 % of the static load: values stay, and the intervals cover.

The truth is what the same record gives without noise; damping ratios are also compared with the car itself.
"""

from __future__ import annotations

import numpy as np
import plate_twin
import pytest

from jounce.inspection import evaluate
from jounce.parts.testers import load_tester
from jounce.recordings import recording

NOISE = 0.01


@pytest.fixture(scope="module")
def twin():
    return plate_twin


def wheel_of(time, height, force, load, tester):
    channels = {"left.plate.z": (height, "m", ""), "left.plate.force": (force, "N", "")}
    found = evaluate(
        recording(time, channels, attributes={"left.static_load": load}), tester
    ).wheel("left")
    assert found.is_gradable, found.reasons
    return found


def compare(twin, tester, simulate, keys, seeds):
    """Errors and half widths, shape (seeds, keys), and errors of theta_road against the car."""
    errors, halves, truths = [], [], []
    for seed in seeds:
        rng = np.random.default_rng(9000 + seed)
        car = twin.random_car(rng)
        time, height, force, _ = simulate(car)
        noise = rng.normal(0.0, NOISE * car.static_load, time.size)
        clean = wheel_of(time, height, force, car.static_load, tester)
        noisy = wheel_of(time, height, force + noise, car.static_load, tester)
        assert not clean.lift_off
        assert not noisy.lift_off
        errors.append([getattr(noisy, key) - getattr(clean, key) for key in keys])
        halves.append([noisy.uncertainty[key] for key in keys])
        truths.append(clean.theta_road - car.wheel_damping())
    return np.array(errors), np.array(halves), np.array(truths)


def check(errors, halves, keys, limits):
    covered = np.mean(np.abs(errors) <= halves, axis=0)
    lowest = 0.95 - 4.0 * np.sqrt(0.95 * 0.05 / len(errors))
    for index, key in enumerate(keys):
        worst = np.abs(errors[:, index]).max()
        assert worst < limits[index], (key, worst)
        assert lowest < covered[index] <= 1.0, (key, covered[index])
        useful = np.median(halves[:, index]) / (1.96 * np.std(errors[:, index]))
        assert 0.6 < useful < 2.0, (key, useful)


RIGID = (
    "adhesion",
    "phase_angle_min_deg",
    "theta_road",
    "relative_force_amplitude",
    "tyre_rigidity",
)
RIGID_LIMITS = (0.01, 2.0, 0.01, 0.01, 6e3)


def rigid(twin):
    programme = twin.Programme()
    return lambda car: twin.rigid_record(car, programme, mp=20.0, fine=4)


def sprung(twin, tester):
    programme = twin.Programme(
        start=tester.programme.start_frequency,
        end=tester.programme.end_frequency,
        rate=tester.programme.sweep_rate,
        hold=tester.programme.hold_time,
    )
    return lambda car: twin.sprung_record(
        car,
        programme,
        e=tester.amplitude,
        mp=tester.plate_mass,
        kp=tester.plate_spring_rate,
        fine=4,
    )


def test_rigid_plate(twin):
    tester = load_tester("egea-specsus2018")
    errors, halves, truths = compare(twin, tester, rigid(twin), RIGID, range(40))
    check(errors, halves, RIGID, RIGID_LIMITS)
    assert np.abs(truths).max() < 1e-3


@pytest.mark.slow
def test_rigid_plate_500_cars(twin):
    tester = load_tester("egea-specsus2018")
    errors, halves, truths = compare(twin, tester, rigid(twin), RIGID, range(500))
    check(errors, halves, RIGID, RIGID_LIMITS)
    assert np.abs(truths).max() < 1e-3


def test_sprung_plate(twin):
    tester = load_tester("theta-msd3000")
    keys = ("theta_road", "theta_rig")
    errors, halves, _ = compare(twin, tester, sprung(twin, tester), keys, range(40))
    check(errors, halves, keys, (0.01, 0.02))  # theta on the road is graded


@pytest.mark.parametrize("friction", [80.0, 160.0])
def test_friction_is_followed_through_the_noise(twin, friction):
    """Dry friction is not in the model: the turns themselves must correct it."""
    tester = load_tester("egea-specsus2018")
    car = twin.Car(c=900.0, friction=friction)
    time, height, force, contact = twin.rigid_record(car, twin.Programme(), mp=20.0, fine=4)
    clean = wheel_of(time, height, force, car.static_load, tester)
    assert clean.adhesion == pytest.approx(contact[1600:].min() / car.static_load, abs=4e-3)
    rng = np.random.default_rng(3)
    noisy = wheel_of(
        time, height, force + rng.normal(0.0, 43.0, time.size), car.static_load, tester
    )
    assert noisy.adhesion == pytest.approx(clean.adhesion, abs=0.01)
    assert noisy.phase_angle_min_deg == pytest.approx(clean.phase_angle_min_deg, abs=2.0)
    assert noisy.theta_road > 1.05 * twin.Car(c=900.0).wheel_damping()


def test_lift_off_is_seen(twin):
    tester = load_tester("eusama")
    car = twin.Car(ms=170.0, mu=38.0, c=450.0, k=14e3, kt=220e3)
    time, height, force, contact = twin.rigid_record(
        car, twin.Programme(), mp=20.0, fine=4, lift_off=True
    )
    assert contact.min() == 0.0
    rng = np.random.default_rng(6)
    for noise in (0.0, NOISE * car.static_load):
        found = wheel_of(
            time, height, force + rng.normal(0.0, noise, time.size), car.static_load, tester
        )
        assert found.lift_off
        assert found.adhesion == 0.0
        assert found.relative_force_amplitude > 1.0
        assert found.theta_road == pytest.approx(car.wheel_damping(), rel=0.05)
        assert "the tyre leaves the plate" in found.findings[-1].message or len(found.findings) > 1
