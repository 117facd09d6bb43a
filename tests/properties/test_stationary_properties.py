"""Invariances of stationary responses over many quarter cars and vehicles."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import jounce as jn
from jounce.ride.closed_forms import LumpedCorner, white_noise_variances
from jounce.ride.stationary import stationary
from jounce.roughness.spectra import white_noise_intensity

MASSES = st.floats(100.0, 1000.0)
SHARES = st.floats(0.03, 0.5)
FREQUENCIES = st.floats(0.7, 4.0)
DAMPING = st.floats(0.05, 1.5)
HARDNESS = st.floats(2.0, 20.0)


def car(
    mass: float, share: float, frequency: float, damping: float, hardness: float
) -> jn.QuarterCar:
    k = mass * (2 * np.pi * frequency) ** 2
    return jn.QuarterCar(
        sprung={"mass": mass},
        unsprung={"mass": share * mass},
        strut={"spring": {"rate": k}, "damper": {"coefficient": 2 * damping * np.sqrt(k * mass)}},
        tyre={"stiffness": hardness * k},
    )


@settings(max_examples=40, deadline=None)
@given(MASSES, SHARES, FREQUENCIES, DAMPING, HARDNESS)
def test_any_quarter_car_follows_the_closed_form(mass, share, frequency, damping, hardness):
    rig = car(mass, share, frequency, damping, hardness)
    corner = LumpedCorner(
        mass, share * mass, rig.strut.spring.rate, rig.tyre.stiffness, rig.strut.damper.coefficient
    )  # fmt: skip
    exact, found = (
        white_noise_variances(corner, white_noise_intensity("B", 15.0)),
        stationary(rig, "B", 15.0),
    )
    assert found["sprung.az"] ** 2 == pytest.approx(exact.acceleration, rel=1e-8)
    assert found["strut.deflection"] ** 2 == pytest.approx(exact.deflection, rel=1e-8)
    assert found["tyre.force"] ** 2 == pytest.approx(exact.tyre_force, rel=1e-8)


@settings(max_examples=20, deadline=None)
@given(st.floats(0.1, 10.0), st.floats(3.0, 60.0))
def test_responses_grow_with_the_root_of_roughness_and_speed(rougher, speed):
    rig = jn.load("hmmwv-front-corner")
    first, second = (
        stationary(rig, 64e-6, speed, band="iso"),
        stationary(rig, rougher * 64e-6, speed, band="iso"),
    )
    for name, value in first.standard_deviation.items():
        assert second[name] == pytest.approx(np.sqrt(rougher) * value, rel=1e-12)
    car_a = car(400.0, 0.1, 1.26, 0.24, 8.0)
    slow, fast = stationary(car_a, "B", speed), stationary(car_a, "B", 4.0 * speed)
    assert fast["sprung.az"] == pytest.approx(2.0 * slow["sprung.az"], rel=1e-12)


@settings(max_examples=15, deadline=None)
@given(st.floats(5.0, 50.0), st.floats(0.3, 3.0))
def test_bands_add_up(speed, split):
    vehicle = jn.load("audi-a6-half-car-4dof")
    whole = stationary(vehicle, "C", speed, band=(0.01, 5.0))
    parts = [stationary(vehicle, "C", speed, band=band) for band in ((0.01, split), (split, 5.0))]
    for name, value in whole.standard_deviation.items():
        assert np.hypot(parts[0][name], parts[1][name]) == pytest.approx(value, rel=1e-8), name
