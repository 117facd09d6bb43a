"""Sketches of shipped rigs: pictures that fit their frame, each model its own."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import numpy as np
import pytest

import jounce as jn
from jounce.parts import library
from jounce.plots.mechanisms.sketch import sketch


def _places(text: str) -> np.ndarray:
    found = re.findall(r"[ML](-?[\d.]+) (-?[\d.]+)", text)
    return np.array(found, dtype=float)


@pytest.mark.parametrize("name", sorted(library()))
def test_each_shipped_rig_has_a_picture_that_fills_its_frame(name: str) -> None:
    text = sketch(jn.load(name))
    assert ElementTree.fromstring(text).tag.endswith("svg")
    places = _places(text)
    assert np.all(places >= 0.0)
    assert np.all(places <= [160.0, 110.0])
    width, height = np.ptp(places, axis=0) / [160.0 - 12.0, 110.0 - 12.0]
    assert max(width, height) == pytest.approx(1.0, abs=0.01)
    assert len(text) < 20_000


def test_quarter_half_and_full_car_differ_by_their_wheels() -> None:
    names = ("kart-quarter-car", "audi-a6-half-car", "audi-a6-full-car")
    quarter, half, full = (sketch(jn.load(name)).count("<path") for name in names)
    assert half == 2 * (quarter - 2) + 2
    assert full == 2 * half - 1 + 4  # the far side has no road of its own; four edges join both


def test_a_vehicle_of_corners_shows_both_wheels_of_its_front_axle() -> None:
    car = jn.load("formula-student-car")
    corner = sketch(car.front.corner)
    assert sketch(car).count("<path") == 2 * corner.count("<path")
    assert np.ptp(_places(sketch(car)), axis=0)[0] > 140.0
