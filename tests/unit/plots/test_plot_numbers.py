from __future__ import annotations

import math

import pytest

from jounce.core.display import display_unit
from jounce.plots.display import digits_for, number, quantity, words_of


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (22730.4, 4, "22730"),
        (0.1, 2, "0.10"),
        (-1.0, 3, "−1.00"),
        (999.96, 4, "1000"),
        (0.099996, 4, "0.1000"),
        (1e-5, 2, "1.0e−5"),
        (-3.9e8, 3, "−3.90e8"),
        (0.0, 3, "0"),
        (math.nan, 3, "–"),
        (None, 3, "–"),
        (math.inf, 3, "∞"),
        (-math.inf, 3, "−∞"),
    ],
)
def test_numbers(value: float | None, digits: int, text: str) -> None:
    assert number(value, digits) == text


@pytest.mark.parametrize(
    ("si", "name", "factor"),
    [
        ("m", "mm", 1e3),
        ("rad", "°", 57.29577951308232),
        ("Pa", "MPa", 1e-6),
        ("N/m", "N/mm", 1e-3),
        ("N*s/m", "N·s/m", 1.0),
        ("m/s^2", "m/s²", 1.0),
        ("N/m^3", "N/m³", 1.0),
        ("kg", "kg", 1.0),
        ("1", "", 1.0),
    ],
)
def test_display_units(si: str, name: str, factor: float) -> None:
    unit = display_unit(si)
    assert unit.name == name
    assert unit.factor == pytest.approx(factor, rel=1e-12)


def test_large_forces_in_kilonewtons() -> None:
    assert quantity(19999.0, "N") == "19999 N"
    assert quantity(-25000.0, "N", 3) == "−25.0 kN"


def test_labels() -> None:
    assert display_unit("1").label("damping ratio") == "damping ratio [–]"
    assert words_of("front_left.wheel.az") == "acceleration"
    assert words_of("odd.thing") == "thing"


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [
        (22731.4, 12.3, "22731"),
        (0.10961, 0.0021, "0.1096"),
        (5.0, 40.0, "5.0"),
        (1.0, None, "1.000"),
    ],
)
def test_error_decides_the_digits(value: float, error: float | None, text: str) -> None:
    assert number(value, digits_for(value, error)) == text
