"""A sensor that counts from the road, a high pass that nobody stated: what a fit leaves says which."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import jounce as jn
from jounce.core.findings import Finding

RIG = jn.load("kart-quarter-car")
TRUTH = {"strut.spring.rate": 24e3, "strut.damper.coefficient": 135.0, "tyre.stiffness": 142e3}
FREE = {"strut.spring.rate": "20 %", "strut.damper.coefficient": "50 %", "tyre.stiffness": "20 %"}
ROAD = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")
NOISE = {"sprung.az": 0.1, "unsprung.az": 0.5, "sprung.z": 5e-5}


@cache
def run(speed: float) -> Any:
    trial = jn.Trial(road=ROAD, speed=speed, duration="0.8 s")
    return trial, jn.simulate(RIG.with_changes(TRUTH), trial, tolerance=1e-8)


def said(sensors: dict[str, jn.Sensor], *, to_the_road: float = 0.0) -> dict[str, Finding]:
    """Warnings of an update by place, where records are seen through sensors that nobody states."""
    rng, trials = np.random.default_rng(3), []
    for speed in (1.2, 1.95, 2.86):
        trial, motion = run(speed)
        record = jn.apply_sensors(motion[list(NOISE)], sensors)
        seen = record["sprung.z"]  # its copy keeps the unit, which arithmetic of older xarray drops
        record["sprung.z"] = seen.copy(data=seen.values - to_the_road * motion["road.z"].values)
        for name, noise in NOISE.items():
            record[name].values[:] += noise * rng.normal(size=record[name].size)
        trials.append(jn.FitTrial(f"{speed:g} m/s", RIG, trial, record))
    found = jn.update_model(trials, FREE, weights="normalised")
    return {one.place: one for one in found.findings if one.severity == "warning"}


def test_sound_records_are_left_alone() -> None:
    assert said({}) == {}


def test_a_height_above_the_road_is_named() -> None:
    found = said({}, to_the_road=1.0)
    assert (
        "distance to the moving road instead of the height above the ground"
        in found["sprung.z"].message
    )
    assert found["sprung.z"].value == pytest.approx(1.0, abs=0.05)


@pytest.mark.parametrize(("channel", "corner"), [("sprung.az", 1.0), ("unsprung.az", 5.0)])
def test_a_high_pass_that_nobody_stated_is_named(channel: str, corner: float) -> None:
    found = said({channel: jn.Sensor(high_pass=corner)})[channel]
    assert "after a high-pass filter at about" in found.message
    assert found.value == pytest.approx(corner, rel=0.1)
