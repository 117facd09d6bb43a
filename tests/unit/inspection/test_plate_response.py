"""The parts of the evaluation: linear response and its fit, filter of the turns, turns, smoothing, damping ratios."""

from __future__ import annotations

import math

import numpy as np
import pytest

from jounce.core.errors import FitError
from jounce.inspection.methods import half_power, theta_by_decay
from jounce.inspection.quarter_car import (
    LinearQuarterCar,
    fit_response,
    force_response,
    responses,
    rig_poles,
    road_poles,
    steady_state,
    stretch_of,
    wheel_damping,
)
from jounce.inspection.signals import find_turns, middle_crossings
from jounce.inspection.turn_forces import corrected_curve, force_in_periods, prototype
from jounce.testers.plate_response import road_damping_ratio
from jounce.testers.plates import phase_angle


def corner(car) -> LinearQuarterCar:
    return LinearQuarterCar(car.ms, car.mu, car.k, car.c, car.kt, car.ct)


class TestResponse:
    def test_equals_the_twin(self, twin):
        car = twin.Car(c=700.0, ct=90.0)
        frequency = np.linspace(0.2, 30.0, 200)
        assert np.allclose(
            force_response(corner(car), frequency), car.response(frequency), rtol=1e-12
        )
        several = np.array(
            [[car.mu, car.k, car.c, car.kt, car.ct, car.ms], [40.0, 3e4, 1500.0, 2e5, 0.0, 350.0]]
        )
        found = responses(several, 2j * np.pi * frequency)
        assert np.allclose(found[0], car.response(frequency), rtol=1e-9)
        other = LinearQuarterCar(350.0, 40.0, 3e4, 1500.0, 2e5)
        assert np.allclose(found[1], force_response(other, frequency), rtol=1e-9)

    def test_poles_equal_the_twin(self, twin):
        for car in (twin.Car(c=300.0), twin.Car(ct=120.0), twin.Car(c=2500.0)):
            assert wheel_damping(road_poles(corner(car)))[0] == pytest.approx(
                car.wheel_damping(), rel=1e-9
            )
            matrix = car.rig_matrix(18.0, 60e3, 40.0)
            found = np.sort_complex(rig_poles(corner(car), 18.0, 60e3, 40.0))
            assert np.allclose(found, np.sort_complex(np.linalg.eigvals(matrix)), rtol=1e-7)

    def test_overdamped_wheel_counts_as_one(self):
        damping, frequency = wheel_damping(
            road_poles(LinearQuarterCar(400.0, 40.0, 25e3, 12e3, 200e3))
        )
        assert damping == 1.0
        assert frequency > 1.0

    def test_phase_is_180_less_the_angle(self):
        wanted = np.array([1.0, 0.5j, -1.0, -0.2j])
        assert np.degrees(phase_angle(wanted)) == pytest.approx(
            [180.0, 90.0, 0.0, 270.0], abs=1e-12
        )


class TestFit:
    @pytest.mark.parametrize("first", [0, 700, 2200])
    def test_finds_the_car_wherever_the_record_begins(self, twin, first):
        car = twin.Car(c=600.0, ct=50.0)
        time, height, _, force = twin.rigid_record(car, twin.Programme())
        assert time.size > first
        part = stretch_of(height[first:], force[first:] - car.static_load, 1000.0, 0.7, 27.0)
        found = fit_response([part], car.static_load)
        assert found.corner.unsprung_mass == pytest.approx(40.0, rel=1e-3)
        assert found.corner.damping_coefficient == pytest.approx(600.0, rel=1e-3)
        assert found.corner.tyre_stiffness == pytest.approx(200e3, rel=1e-3)
        assert found.corner.tyre_damping_coefficient == pytest.approx(50.0, abs=1.0)
        assert found.explained > 1.0 - 1e-6

    def test_several_stretches(self, twin):
        car = twin.Car()
        _, height, _, force = twin.rigid_record(car, twin.Programme())
        cuts = [(300, 3000), (3600, 9000)]
        parts = [
            stretch_of(height[a:b], force[a:b] - car.static_load, 1000.0, 0.7, 27.0)
            for a, b in cuts
        ]
        assert fit_response(parts, car.static_load).corner.damping_coefficient == pytest.approx(
            1000.0, rel=1e-3
        )

    def test_noise_and_what_is_explained_are_those_of_the_record(self, twin):
        car = twin.Car()
        _, height, _, force = twin.rigid_record(car, twin.Programme())
        noise = 40.0 * np.random.default_rng(6).standard_normal(force.size)
        both = [
            stretch_of(height, one, 1000.0, 0.7, 27.0)
            for one in (force + noise - car.static_load, noise)
        ]
        found = fit_response(both[:1], car.static_load)
        assert found.noise == pytest.approx(40.0, rel=0.06)
        left, power = (float(np.sum(np.abs(one.force) ** 2)) for one in both[::-1])
        assert 1.0 - found.explained == pytest.approx(left / power, rel=0.06)
        assert abs(found.corner.damping_coefficient - 1000.0) < 3.0 * found.spread(
            lambda one: one.damping_coefficient
        )
        mild = fit_response(
            [stretch_of(height, force + 0.5 * noise - car.static_load, 1000.0, 0.7, 27.0)],
            car.static_load,
        )
        for name in ("damping_coefficient", "tyre_stiffness", "spring_rate"):
            wide, narrow = (
                one.spread(lambda corner, name=name: getattr(corner, name)) for one in (found, mild)
            )
            assert wide == pytest.approx(2.0 * narrow, rel=0.05)

    def test_too_little(self):
        with pytest.raises(FitError, match="the signal is too small"):
            fit_response([stretch_of(np.zeros(200), np.zeros(200), 1000.0, 1.0, 20.0)], 4000.0)


class TestFilterOfTheTurn:
    def test_gains(self):
        taps, half = prototype()
        u = np.linspace(0.0, half, taps.size)
        gain = {
            m: 2.0 * np.trapezoid(taps * np.cos(2 * np.pi * m * u), u)
            for m in (0, 1, 1.5, 2, 4, 4.5, 6, 8, 12)
        }
        assert [gain[m] for m in (0, 1, 2)] == pytest.approx([1.0, 1.0, 1.0], abs=1e-5)
        assert abs(gain[1.5] - 1.0) < 0.025
        assert max(abs(gain[m]) for m in (4, 4.5, 6, 8, 12)) < 0.0105

    @pytest.mark.parametrize("frequency", [5.0, 7.3, 12.0, 24.0])
    def test_sine(self, frequency):
        t = np.arange(4000) / 1000.0
        tops = np.array([1.5, 1.5 + 1.0 / frequency])
        force = 3000.0 + 800.0 * np.cos(2 * np.pi * frequency * (t - 1.5) - 2.0)
        found = force_in_periods(
            force[None], 1000.0, 0.0, tops, np.full(2, frequency), 3000.0, (-0.12, 0.63)
        )[0]
        trough = 1.5 + (math.pi + 2.0 - 2.0 * math.pi) / (2 * math.pi * frequency)
        trough += 1.0 / frequency if trough < 1.5 - 0.12 / frequency else 0.0
        if trough > 1.5 + 0.63 / frequency:
            assert np.isnan(found[:, 0]).all()
            return
        assert found[0, 0] == pytest.approx(2200.0, abs=1.0)
        assert found[0, 1] == pytest.approx(trough, abs=2e-4)
        assert found[0, 2] == pytest.approx(3800.0, abs=12.0)
        assert 0.5 * (found[0, 3] + found[0, 4]) == pytest.approx(trough, abs=2e-4)
        assert found[0, 4] - found[0, 3] == pytest.approx(0.5 / frequency, rel=2e-3)

    def test_beyond_the_record_is_unknown(self):
        force = 3000.0 + np.sin(np.arange(1000) / 13.0)
        found = force_in_periods(
            force[None], 1000.0, 0.0, np.array([0.02, 0.99]), np.full(2, 12.0), 3000.0, (-0.1, 0.6)
        )
        assert np.isnan(found).all()


class TestTurns:
    def test_chirp(self, twin):
        programme = twin.Programme()
        t = twin.grid(programme.duration, 1000.0)
        turns = find_turns(t, 3e-3 * np.sin(programme.angle(t)), 0.0, 3e-3)
        true = 25.0 - 2.5 * np.clip(turns.top - 1.5, 0.0, None)
        inside = true > 3.0
        assert np.abs(turns.frequency - true)[inside].max() < 0.02
        angle = np.mod(programme.angle(turns.top), 2 * np.pi)
        assert np.abs(angle - np.pi / 2)[inside].max() < 5e-3

    def test_noise_makes_no_turns(self):
        t = np.arange(3000) / 1000.0
        rng = np.random.default_rng(2)
        times, upwards = middle_crossings(
            t, np.sin(20.0 * t) + rng.normal(0.0, 0.05, t.size), 0.0, 1.0
        )
        assert times.size == 18 + 1
        assert not upwards or times[0] > 0.2
        assert np.abs(np.diff(times) - np.pi / 20.0).max() < 0.01

    def test_too_few(self):
        t = np.arange(1000) / 1000.0
        assert find_turns(t, np.sin(20.0 * t), 0.0, 1.0) is None


class TestSmoothing:
    frequency = np.linspace(5.0, 19.0, 60)

    def test_noise_about_the_model_is_not_believed(self):
        rng = np.random.default_rng(4)
        model = 100.0 + (self.frequency - 9.0) ** 2
        course = corrected_curve(
            self.frequency, model + rng.normal(0.0, 2.0, 60), model, np.ones(60), 2.0
        )
        assert np.abs(course.value - model).max() < 1.2

    def test_what_the_model_misses_is_believed(self):
        rng = np.random.default_rng(4)
        model = 100.0 + (self.frequency - 9.0) ** 2
        truth = model + 12.0 * np.sin(0.6 * self.frequency)
        course = corrected_curve(
            self.frequency, truth + rng.normal(0.0, 1.0, 60), model, np.ones(60), 2.0
        )
        assert np.abs(course.value - truth).max() < 2.0
        assert np.mean(np.abs(course.value - truth) < 2.0 * course.error) > 0.85

    def test_least_with_ends(self):
        course = corrected_curve(self.frequency, self.frequency, self.frequency, np.ones(60), 2.0)
        at, value, _ = course.least(6.0, 18.0)
        assert (at, value) == (6.0, pytest.approx(6.0, abs=1e-9))
        assert course.least(4.0, 18.0) is None
        assert course.lowest()[0] == 5.0


class TestDampingRatios:
    def test_half_power_of_one_mass(self):
        f = np.linspace(2.0, 12.0, 4001)
        gain = 1.0 / np.abs(1.0 - (f / 6.0) ** 2 + 2j * 0.05 * f / 6.0)
        assert half_power(f, gain) == pytest.approx(0.05, rel=0.02)
        assert half_power(f, 1.0 / np.abs(1.0 - (f / 6.0) ** 2 + 2j * 0.45 * f / 6.0)) is None

    def test_decay(self):
        t = np.arange(6000) / 1000.0
        z = np.where(t < 2.0, np.sin(60.0 * t), 0.0)
        away = np.clip(t - 2.0, 0.0, None)
        z = z + np.where(
            t >= 2.0, 0.3 + np.exp(-0.1 * 35.0 * away) * np.cos(35.0 * math.sqrt(0.99) * away), 0.0
        )
        ratio, frequency = theta_by_decay(z, 1000.0)
        assert ratio == pytest.approx(0.1, abs=0.004)
        assert frequency == pytest.approx(35.0 * math.sqrt(0.99) / (2 * math.pi), rel=0.01)
        assert theta_by_decay(np.sin(60.0 * t), 1000.0) is None

    def test_conversion_is_what_the_rig_does(self):
        car = LinearQuarterCar(400.0, 40.0, 25e3, 400.0, 200e3)
        road = road_damping_ratio(
            wheel_damping(rig_poles(car, 20.0, 50e3))[0],
            wheel_rate=25e3, tyre_stiffness=200e3, unsprung_mass=40.0, plate_mass=20.0, plate_spring_rate=50e3,
        )  # fmt: skip
        assert road == pytest.approx(wheel_damping(road_poles(car))[0], rel=0.03)


class TestSteadyState:
    def test_minimum_at_an_end_is_said(self):
        found = steady_state(LinearQuarterCar(400.0, 40.0, 25e3, 3500.0, 200e3))
        assert found.phase_at_end
        assert found.phase_frequency_hz == 6.0
        assert not steady_state(LinearQuarterCar(400.0, 40.0, 25e3, 1000.0, 200e3)).phase_at_end

    def test_linear_lift_off_counts_as_zero(self):
        found = steady_state(LinearQuarterCar(150.0, 40.0, 12e3, 300.0, 200e3))
        assert found.lift_off
        assert found.adhesion == 0.0
        assert found.relative_force_amplitude > 1.0

    def test_band_limit_matters_with_a_damped_tyre(self):
        car = LinearQuarterCar(400.0, 40.0, 25e3, 2500.0, 200e3, 2000.0)
        assert (
            steady_state(car, highest=25.0).adhesion
            > steady_state(car, highest=60.0).adhesion + 0.05
        )

    def test_any_response_will_do(self):
        car = LinearQuarterCar(400.0, 40.0, 25e3, 1000.0, 200e3)
        given = steady_state(lambda f: force_response(car, f), 4316.4)
        assert given == steady_state(car, 4316.4)
