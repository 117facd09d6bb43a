"""A road driven over at a speed that changes: closed-form pieces, held against a fine twin."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.roads import HalfCylinder, Iso8608, Rectangle, Train, Trapezoid, Versine
from jounce.roads.trial import SpeedOverTime

CHANGING = {"time": [0.0, 0.6, 1.2, 2.0], "speed": [1.0, 3.0, 2.0, 2.5]}
ROADS = [
    jn.HalfSine(height="10 mm", length="60 mm", start="0.3 m"),
    Versine(height="10 mm", length="0.2 m", start="0.3 m"),
    Trapezoid(height="10 mm", length="0.3 m", ramp="0.1 m", start="0.3 m"),
    HalfCylinder(radius="20 mm", start="0.3 m"),
    Train(of=jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m"), count=5, pitch="0.15 m"),
    jn.HalfSine(height="10 mm", length="60 mm", start="0.3 m", recurrence="1.1 m"),
    Iso8608(class_="C", length="20 m", seed=3),
]


@pytest.mark.parametrize("road", ROADS, ids=lambda road: road.kind)
def test_heights_are_those_of_the_distance_driven(road: jn.Road) -> None:
    trial = jn.Trial(road=road, speeds=CHANGING, duration="2 s")
    fine = np.linspace(0.0, 2.0, 200_001)
    speed = np.interp(fine, CHANGING["time"], CHANGING["speed"])
    way = np.concatenate([[0.0], np.cumsum(0.5 * (speed[1:] + speed[:-1]) * np.diff(fine))])
    at = np.linspace(0.001, 1.999, 1777)
    height, rate = trial.segments().evaluate(at)
    np.testing.assert_allclose(height, road.height_at(np.interp(at, fine, way)), atol=1.5e-5)
    sharp = np.diff(trial.segments().edges).min() < 1e-9
    inside = slice(1, -1)
    numeric = (height[2:] - height[:-2]) / (at[2] - at[0])
    away = np.abs(numeric - rate[inside])
    assert np.quantile(away, 0.9) < 0.02 * np.max(np.abs(rate)) or sharp  # the rest lies at edges
    assert trial.speed == pytest.approx(way[-1] / 2.0, rel=1e-6)
    assert (
        trial.end() == pytest.approx(float(np.interp(road.end(), way, fine)), abs=1e-3)
        or road.end() > way[-1]
    )


def test_a_constant_speed_is_the_same_run() -> None:
    rig = jn.load("kart-quarter-car")
    plain = jn.simulate(
        rig, jn.Trial(road=ROADS[0], speed="1.95 m/s", duration="1 s"), tolerance=1e-8
    )
    same = {"time": [0.0, 0.4, 1.0], "speed": [1.95, 1.95, 1.95]}
    held = jn.simulate(rig, jn.Trial(road=ROADS[0], speeds=same, duration="1 s"), tolerance=1e-8)
    for name in plain.data_vars:
        np.testing.assert_allclose(
            held[name], plain[name], atol=1e-5 * float(np.ptp(plain[name].to_numpy())) + 1e-12
        )


def test_a_faster_trial_scales_all_speeds() -> None:
    trial = jn.Trial(road=ROADS[0], speeds=CHANGING, duration="2 s")
    faster = trial.at_speed(1.1)
    assert faster.speed == pytest.approx(1.1 * trial.speed)
    assert faster.speeds.speed[1] == pytest.approx(3.3)


def test_slopes_by_parameters_are_exact() -> None:
    rig = jn.load("kart-quarter-car")
    trial = jn.Trial(road=ROADS[0], speeds=CHANGING, duration="0.8 s")
    slopes = jn.sensitivities(rig, trial, ["tyre.stiffness"], tolerance=1e-9)
    step = 20.0
    base = rig.parameters()["tyre.stiffness"]
    above, below = (
        jn.simulate(
            rig.with_changes({"tyre.stiffness": base + sign * step}), trial, tolerance=1e-11
        )["sprung.z"]
        for sign in (1.0, -1.0)
    )
    difference = (above - below) / (2.0 * step)
    found = slopes["sprung.z"].sel(parameter="tyre.stiffness")
    assert float(abs(found - difference).max()) < 1e-3 * float(abs(difference).max())


@pytest.mark.parametrize(
    ("given", "what"),
    [
        ({"time": [0.0], "speed": [1.0]}, "at least 2"),
        ({"time": [0.5, 1.0], "speed": [1.0, 2.0]}, "must begin at 0"),
        ({"time": [0.0, 0.0], "speed": [1.0, 2.0]}, "does not increase"),
        ({"time": [0.0, 1.0], "speed": [1.0, 0.0]}, "above 0"),
    ],
)
def test_impossible_speeds_are_refused(given, what: str) -> None:
    with pytest.raises(DescriptionError, match=what):
        SpeedOverTime.from_table(given, where="speeds")


def test_speed_and_speeds_contradict() -> None:
    with pytest.raises(DescriptionError, match="leave out speed"):
        jn.Trial(road=ROADS[0], speed="5 m/s", speeds=CHANGING, duration="2 s")
    jumping = Rectangle(height="5 mm", length="60 mm", start="0.3 m")
    assert jn.Trial(road=jumping, speeds=CHANGING, duration="2 s").segments().jumps.max() > 4e-3
