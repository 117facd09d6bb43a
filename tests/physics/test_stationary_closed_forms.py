"""Stationary responses against closed forms: variances on white noise, best dampers, invariant points, power.

Car A: 400 kg on 40 kg, 25 kN/m, tyre 200 kN/m without damping. Variances and optima of the linear quarter car on white
noise: derived symbolically, checked by Lyapunov's equation (domain H of the project's digest of formulas).
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize_scalar
from scipy.stats import norm

import jounce as jn
from jounce.parts import QuarterCar
from jounce.ride.closed_forms import (
    LumpedCorner,
    comfort_damping,
    invariants,
    least_acceleration_variance,
    mean_dissipated_power,
    road_holding_damping,
    road_holding_rate,
    white_noise_variances,
)
from jounce.ride.stationary import linear_findings, stationary
from jounce.roughness.spectra import white_noise_intensity

SPEED = 20.0


def car(
    c: float = 1500.0, k: float = 25e3, *, ms: float = 400.0, mu: float = 40.0, kt: float = 200e3
) -> QuarterCar:
    return QuarterCar(
        sprung={"mass": ms},
        unsprung={"mass": mu},
        strut={"spring": {"rate": k}, "damper": {"coefficient": c}},
        tyre={"stiffness": kt},
    )


def lumped(
    c: float = 1500.0, k: float = 25e3, *, ms: float = 400.0, mu: float = 40.0, kt: float = 200e3
):
    return LumpedCorner(ms, mu, k, kt, c)


@pytest.mark.parametrize("c", [150.0, 1172.604, 1500.0, 4000.0, 20e3])
@pytest.mark.parametrize(
    "other", [{}, {"k": 60e3}, {"ms": 200.0, "mu": 60.0}, {"kt": 350e3}], ids=str
)
def test_variances_on_white_noise(c, other):
    rig, exact = (
        car(c, **other),
        white_noise_variances(lumped(c, **other), white_noise_intensity("C", SPEED)),
    )
    found = stationary(rig, "C", SPEED)
    assert found["sprung.az"] ** 2 == pytest.approx(exact.acceleration, rel=1e-9)
    assert found["strut.deflection"] ** 2 == pytest.approx(exact.deflection, rel=1e-9)
    assert found["tyre.deflection"] ** 2 == pytest.approx(exact.tyre_deflection, rel=1e-9)
    assert found["tyre.force"] ** 2 == pytest.approx(exact.tyre_force, rel=1e-9)


def test_published_numbers_of_car_a():
    exact = white_noise_variances(lumped(), 1.0)
    assert exact.acceleration == pytest.approx(1510.4167, abs=5e-5)
    assert exact.deflection == pytest.approx(0.14666667, abs=5e-9)
    assert exact.tyre_deflection == pytest.approx(0.016977083, abs=5e-10)
    found = stationary(car(), "iso:B", "20 m/s")
    assert found["sprung.az"] == pytest.approx(0.61776, abs=5e-6)
    assert found["strut.deflection"] == pytest.approx(6.0875e-3, abs=5e-8)
    assert found["tyre.deflection"] == pytest.approx(2.0711e-3, abs=5e-8)
    assert found.load_coefficients == {"tyre.force": pytest.approx(0.0960, abs=5e-5)}


def test_strut_at_an_angle_counts_by_its_cosine_squared():
    rig = car().with_changes({"strut.angle": "26 deg"})
    cos = np.cos(np.radians(26.0))
    exact = white_noise_variances(
        lumped(1500.0 * cos**2, 25e3 * cos**2), white_noise_intensity("B", SPEED)
    )
    found = stationary(rig, "B", SPEED)
    assert found["sprung.az"] ** 2 == pytest.approx(exact.acceleration, rel=1e-9)
    assert (found["strut.deflection"] / cos) ** 2 == pytest.approx(exact.deflection, rel=1e-9)


def test_best_dampers_and_stiffness():
    corner = lumped()
    assert comfort_damping(corner) == pytest.approx(1172.604, abs=5e-4)
    assert road_holding_damping(corner) == pytest.approx(2483.624, abs=5e-4)
    assert road_holding_rate(corner) == pytest.approx(16528.9, abs=0.05)
    least = stationary(car(comfort_damping(corner)), "B", SPEED)["sprung.az"] ** 2
    assert least == pytest.approx(
        least_acceleration_variance(corner, white_noise_intensity("B", SPEED)), rel=1e-9
    )
    for name, best in (
        ("sprung.az", comfort_damping(corner)),
        ("tyre.force", road_holding_damping(corner)),
    ):
        searched = minimize_scalar(
            lambda c, name=name: stationary(car(c), "B", SPEED)[name],
            bounds=(500.0, 5000.0),
            method="bounded",
        )
        assert searched.x == pytest.approx(best, rel=1e-4)
        slope = stationary(car(best), "B", SPEED, parameters=["strut.damper.coefficient"]).slopes
        assert (
            abs(slope["strut.damper.coefficient"][name]) * best
            < 1e-9 * stationary(car(best), "B", SPEED)[name]
        )


def test_best_stiffness_for_road_holding_does_not_depend_on_the_damper():
    for c in (500.0, 3000.0):
        slopes = stationary(
            car(c, road_holding_rate(lumped())), "B", SPEED, parameters=["strut.spring.rate"]
        ).slopes
        found = stationary(car(c, 25e3), "B", SPEED, parameters=["strut.spring.rate"]).slopes
        assert (
            abs(slopes["strut.spring.rate"]["tyre.force"])
            < 1e-9 * found["strut.spring.rate"]["tyre.force"]
        )


@pytest.mark.parametrize(
    "other", [{}, {"c": 300.0}, {"k": 80e3}, {"ms": 250.0}, {"mu": 25.0}], ids=str
)
def test_mean_power_of_the_damper_depends_on_the_tyre_only(other):
    rig = car(**other)
    power = rig.strut.damper.coefficient * stationary(rig, "C", SPEED)["strut.velocity"] ** 2
    assert power == pytest.approx(
        mean_dissipated_power(200e3, white_noise_intensity("C", SPEED)), rel=1e-9
    )


@pytest.mark.parametrize("c", [1.0, 1500.0, 9000.0])
@pytest.mark.parametrize("k", [5e3, 25e3, 90e3])
def test_invariant_points(c, k):
    model, exact = jn.linearise(car(c, k)), invariants(400.0, 40.0, 200e3)
    assert exact.acceleration_frequency_hz == pytest.approx(11.25395, abs=5e-6)
    assert exact.deflection_frequency_hz == pytest.approx(3.39319, abs=5e-6)
    (acceleration,) = model.frequency_response([exact.acceleration_frequency_hz], "sprung.az")
    assert abs(acceleration - exact.acceleration_ratio) < 1e-9 * 500.0
    (deflection,) = model.frequency_response([exact.deflection_frequency_hz], "strut.deflection")
    assert abs(deflection) == pytest.approx(exact.deflection_ratio, rel=1e-9)


@pytest.mark.parametrize("damper", [500.0, 2500.0, 8000.0])
def test_invariant_point_of_a_half_car(damper):
    """Where dynamic index and axles agree, each end is a quarter car of its own and keeps its invariant points."""
    front, rear, mass = 1.2, 1.5, 1600.0
    vehicle = jn.load("audi-a6-half-car-4dof").with_changes(
        {
            "body.mass": mass,
            "body.pitch_inertia": mass * front * rear,  # dynamic index 1
            "front.distance": front,
            "rear.distance": rear,
            "front.tyre.damping_coefficient": 0.0,
            "rear.tyre.damping_coefficient": 0.0,
            "front.damping_coefficient": damper,
        }
    )
    model, sprung = jn.linearise(vehicle), 0.5 * mass * rear / (front + rear)
    exact = invariants(sprung, vehicle.front.unsprung_mass, vehicle.front.tyre.stiffness)
    for name, at, ratio in (
        ("front.sprung.az", exact.acceleration_frequency_hz, exact.acceleration_ratio),
        ("front.strut.deflection", exact.deflection_frequency_hz, exact.deflection_ratio),
    ):
        assert abs(model.frequency_response([at], name, "front.road.z")[0]) == pytest.approx(
            ratio, rel=1e-9
        )
        assert abs(model.frequency_response([at], name, "rear.road.z")[0]) < 1e-9 * ratio


@pytest.mark.parametrize("damper", [500.0, 2500.0, 8000.0])
@pytest.mark.parametrize("inertia", [1500.0, 2500.0, 4000.0])
def test_invariant_sum_of_any_half_car(damper, inertia):
    """At the wheels' frequency on their tyres, forces of both axles together are those of the tyres on a held wheel.

    Per axle, ``m_u a_u + k_t (z_u - z_r) = -F``: with equal wheels at ``omega = sqrt(k_t / m_u)`` the unsprung terms
    cancel, so ``m_b a_b = k_t z_r`` summed over all wheels, whatever springs, dampers and pitch inertia do.
    """
    equal = {"unsprung_mass": 40.0, "tyre.stiffness": 200e3, "tyre.damping_coefficient": 0.0}
    changes = {f"{axle}.{key}": value for axle in ("front", "rear") for key, value in equal.items()}
    vehicle = jn.load("audi-a6-half-car-4dof").with_changes(
        {**changes, "front.damping_coefficient": damper, "body.pitch_inertia": inertia}
    )
    model, at = jn.linearise(vehicle), invariants(400.0, 40.0, 200e3).acceleration_frequency_hz
    for track, arm in (("front.road.z", -1.29), ("rear.road.z", 1.62)):
        (heave,) = model.frequency_response([at], "body.az", track)
        assert heave == pytest.approx(2.0 * 200e3 / 1636.0, rel=1e-9)
        (pitch,) = model.frequency_response([at], "body.pitch_acceleration", track)
        assert pitch == pytest.approx(arm * 2.0 * 200e3 / inertia, rel=1e-9)


@pytest.mark.parametrize("kind", ["table", "tanh", "collinear"])
def test_dampers_whose_curve_bends_are_told_with_the_coefficient_they_damp_as(kind):
    """For a Gaussian velocity it is the mean slope (Stein): slopes times probabilities, told where that at rest is not.

    With it as coefficient a run of 58 s has the standard deviation of the body's acceleration within 1 % (1.36 and
    1.37 m/s^2), and with the slope at rest 2.0 m/s^2.
    """
    knots, forces = (
        np.array([-1.0, -0.05, 0.0, 0.05, 1.0]),
        np.array([-1500.0, -400.0, 0.0, 200.0, 900.0]),
    )
    table = {"velocity": knots.tolist(), "force": forces.tolist()}
    laws = {
        "table": table,
        "tanh": {"kind": "tanh", "coefficient": 500.0, "force": 300.0, "slope": 20.0},
        "collinear": {"velocity": [-1.0, 0.0, 0.4], "force": [-1500.0, 0.0, 600.0]},
    }
    found = stationary(car().with_changes({"strut.damper": laws[kind]}), "C", SPEED)
    told = [one.value for one in found.findings if one.place == "strut.damper"]
    if kind == "collinear":
        assert not told
        return
    velocity = norm(scale=found.standard_deviation["strut.velocity"])
    if kind == "table":
        edges = np.array([-np.inf, -0.05, 0.0, 0.05, np.inf])
        expected = np.diff(velocity.cdf(edges)) @ (np.diff(forces) / np.diff(knots))
    else:
        expected = 500.0 + velocity.expect(lambda v: 300.0 * 20.0 * (1.0 - np.tanh(20.0 * v) ** 2))
    assert told == [pytest.approx(expected, rel=1e-4)]
    unknown = linear_findings(
        car().with_changes({"strut.damper": laws[kind]}), {}, {}
    )  # as of modes
    assert ["0.3 m/s (assumed)" in one.message for one in unknown] == [True]
