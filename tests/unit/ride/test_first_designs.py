"""Closed forms of a quarter car beside its definitions: first designs, limits, shares of masses."""

from __future__ import annotations

import math

import numpy as np
import pytest

from jounce.core.errors import DescriptionError
from jounce.ride import closed_forms
from jounce.ride.closed_forms import LumpedCorner, as_built, spring_and_damper

CORNER = LumpedCorner(400.0, 40.0, 25e3, 200e3, 1500.0)


@pytest.mark.parametrize("tyre", [None, 180e3])
def test_springs_and_dampers_there_and_back(tyre: float | None) -> None:
    """Through a motion ratio of 0.7, in series with the tyre."""
    one = spring_and_damper(
        "380 kg", "1.3 Hz", 0.31, tyre_stiffness=tyre, motion_ratio=0.7, gravity=9.0
    )
    ride = 380.0 * (2.0 * math.pi * 1.3) ** 2
    rate = ride if tyre is None else 1.0 / (1.0 / ride - 1.0 / tyre)
    assert (one.ride_rate, one.wheel_rate) == pytest.approx((ride, rate), rel=1e-12)
    assert one.spring_rate == pytest.approx(rate / 0.49, rel=1e-12)
    assert one.wheel_damping_coefficient == pytest.approx(
        2.0 * 0.31 * math.sqrt(rate * 380.0), rel=1e-12
    )
    assert one.damping_coefficient == pytest.approx(one.wheel_damping_coefficient / 0.49, rel=1e-12)
    assert (one.static_load, one.static_deflection) == pytest.approx(
        (380.0 * 9.0, 380.0 * 9.0 / rate), rel=1e-12
    )
    numbers = (380.0, one.spring_rate, one.damping_coefficient)
    back = as_built(*numbers, tyre_stiffness=tyre, motion_ratio=0.7, gravity=9.0)
    assert vars(back) == pytest.approx(vars(one), rel=1e-12)


def test_a_tyre_that_is_too_soft_says_up_to_where() -> None:
    most = math.sqrt(20e3 / 400.0) / (2.0 * math.pi)
    with pytest.raises(DescriptionError, match=rf"found '1.2 Hz'; allowed: below {most:.4g} Hz"):
        spring_and_damper(400.0, 1.2, 0.3, tyre_stiffness=20e3)
    assert spring_and_damper(400.0, 0.999 * most, 0.3, tyre_stiffness=20e3).wheel_rate > 5e6
    assert spring_and_damper(400.0, 1.2, 0.0).damping_coefficient == 0.0


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"sprung_mass": 0.0}, "sprung_mass: out of range; found 0.0; allowed: above 0"),
        ({"tyre_stiffness": math.inf}, "tyre_stiffness"),
        (
            {"damping_coefficient": -1.0},
            "damping_coefficient: out of range; found -1.0; allowed: at least 0",
        ),
    ],
)
def test_corners_are_checked(change, words) -> None:
    with pytest.raises(DescriptionError, match=words):
        LumpedCorner(**{**vars(CORNER), **change})
    assert LumpedCorner(400.0, 40.0, 25e3, 200e3).damping_coefficient == 0.0


def test_nothing_is_stationary_without_a_damper() -> None:
    with pytest.raises(DescriptionError, match="no stationary response"):
        closed_forms.white_noise_variances(LumpedCorner(400.0, 40.0, 25e3, 200e3), 1.0)


def test_best_dampers_and_rates_are_the_least_of_the_variances() -> None:
    """Slopes of the variances vanish there; every derivative by differences."""

    def at(name: str, **change: float) -> float:
        return getattr(
            closed_forms.white_noise_variances(LumpedCorner(**{**vars(CORNER), **change}), 2.0),
            name,
        )

    def slope(name: str, path: str, value: float) -> float:
        high, low = (at(name, **{path: value * (1.0 + step)}) for step in (1e-4, -1e-4))
        return (high - low) / 2e-4 / at(name, **{path: value})

    comfort, holding = (
        closed_forms.comfort_damping(CORNER),
        closed_forms.road_holding_damping(CORNER),
    )
    assert slope("acceleration", "damping_coefficient", comfort) == pytest.approx(0.0, abs=1e-6)
    assert slope("tyre_force", "damping_coefficient", holding) == pytest.approx(0.0, abs=1e-6)
    assert slope(
        "tyre_force", "wheel_rate", closed_forms.road_holding_rate(CORNER)
    ) == pytest.approx(0.0, abs=1e-6)
    assert closed_forms.least_acceleration_variance(CORNER, 2.0) == pytest.approx(
        at("acceleration", damping_coefficient=comfort), rel=1e-12
    )
    assert at("tyre_force") == pytest.approx(200e3**2 * at("tyre_deflection"), rel=1e-12)
    assert closed_forms.mean_dissipated_power(200e3, 2.0) == 200e3


def test_invariant_points_are_where_no_damper_matters() -> None:
    found = closed_forms.invariants(400.0, 40.0, 200e3)

    def response(hz: float, c: float) -> tuple[complex, complex]:
        s = 2j * math.pi * hz
        between = 25e3 + c * s
        masses = np.array(
            [[400.0 * s**2 + between, -between], [-between, 40.0 * s**2 + between + 200e3]]
        )
        body, wheel = np.linalg.solve(masses, [0.0, 200e3])
        return s**2 * body, body - wheel

    for c in (200.0, 5e3):
        assert response(found.acceleration_frequency_hz, c)[0] == pytest.approx(
            found.acceleration_ratio, rel=1e-9
        )
        assert abs(response(found.deflection_frequency_hz, c)[1]) == pytest.approx(
            found.deflection_ratio, rel=1e-9
        )


def test_frequencies_and_masses_of_a_corner() -> None:
    body, hop = closed_forms.approximate_frequencies(CORNER)
    assert body == pytest.approx(
        math.sqrt(1.0 / (1.0 / 25e3 + 1.0 / 200e3) / 400.0) / (2.0 * math.pi)
    )
    assert hop == pytest.approx(math.sqrt(225e3 / 40.0) / (2.0 * math.pi))
    front, rear = closed_forms.corner_masses(1500.0, 1.2, 1.5)
    assert 2.0 * (front + rear) == pytest.approx(1500.0)
    assert front * 1.2 == pytest.approx(rear * 1.5)  # moments about the centre of gravity
    assert closed_forms.ride_rate(25e3, None) == 25e3
