"""Units as test benches write them: the spelling is forgiven, the dimension decides, nothing is read by chance."""

from __future__ import annotations

import math

import pytest

from jounce.core.errors import DescriptionError
from jounce.core.units import _EVERYDAY, _factor_of_library, conversion_factor, is_unit, to_si

G = 9.80665  # ISO 80000-3


FOOT_POUND = 4.4482216152605 * 0.3048
SPELLINGS = {  # units that are written between bars, and what one of them is
    "m/s^2": [
        ("m/s2|m/s²|m/s**2|m/s^2|m/s/s|m·s^-2|m⋅s⁻²|m.s-2|m s-2", 1.0), ("mm/s2|mm/s²|mm*s^-2", 1e-3), ("Gal", 0.01),
        ("g|G|gn|g_n|g's|g-force", G), ("mg|milli-g|millig|milli g|mG", 1e-3 * G), ("µg", 1e-6 * G),
    ],
    "kg": [("mg", 1e-6), ("g", 1e-3)],
    "N*m": [("Nm|N.m|N-m|N·m|J", 1.0), ("kNm", 1e3), ("lb-ft|ft*lb|ft-lbs", FOOT_POUND)],
    "kg*m": [("ft*lb", 0.45359237 * 0.3048)],
    "N*s/m": [("Ns/m|N.s/m|N s/m|N·s/m|N/(m/s)", 1.0), ("kNs/m|Ns/mm", 1e3)],
    "N": [("kp|kgf", G), ("daN", 10.0)],
    "Pa": [("N/mm2|MPa", 1e6), ("bar", 1e5)],
    "kg*m^2": [("kg.m2|kg m²", 1.0)],
    "Hz": [("rpm|U/min|1/min", 1.0 / 60.0), ("rad/s", 0.5 / math.pi), ("1/s", 1.0)],
    "rad/s": [("rpm|U/min", math.pi / 30.0), ("1/s", 1.0), ("°/s|deg/s", math.pi / 180.0)],
    "rad": [("Grad|°|deg", math.pi / 180.0), ("mm/m", 1e-3)],
    "s": [("sec|Sek|s", 1.0), ("µs|us|\N{GREEK SMALL LETTER MU}s", 1e-6)],
    "m/s": [("km/h|kph|kmh", 1.0 / 3.6)],
    "1": [("%", 0.01), ("-", 1.0), ("mm/m", 1e-3)],
    "N*m/rad": [("Nm/deg", 180.0 / math.pi)],
}  # fmt: skip


@pytest.mark.parametrize(
    ("si", "unit", "factor"),
    [
        (si, unit, factor)
        for si, rows in SPELLINGS.items()
        for units, factor in rows
        for unit in units.split("|")
    ],
)
def test_spellings_and_dimensions(si: str, unit: str, factor: float) -> None:
    assert conversion_factor(unit, si) == pytest.approx(factor, rel=1e-12)
    assert to_si(f"2 {unit}", si) == pytest.approx(2.0 * factor, rel=1e-12)


@pytest.mark.parametrize(
    ("si", "unit"), [(si, unit) for si, row in _EVERYDAY.items() for unit in row]
)
def test_everyday_units_are_those_of_the_library(si: str, unit: str) -> None:
    assert _EVERYDAY[si][unit] == pytest.approx(_factor_of_library(unit, si), rel=4e-16, abs=0.0)
    assert si == "1" or _factor_of_library(si, si) == 1.0


NONE = {
    "m/s^2": ["kg", "mm", "ms-2"], "N": ["kg", "lb", "Nm", "KN"], "rad/s": ["Hz"], "kg": ["milli-g", "G"],
    "s": ["hh:mm:ss"], "N*m": ["Nm/deg"], "N*m/rad": ["Nm"], "K": ["°C"],
    "1": ["deg", "dB", "Np", "octave", "''", "'", '"'], "rad": ["''", "'", '"', "%", "1", "count", "bit", "dB", "pi"],
    "m": [
        "MM", "-mm", "−mm", "10*mm", "mm;N", ":,1", "m\0", "m" * 100, "m^9**9**9**9", "m^(9^9)", "m**1e9", "m^9999",
        "((((" * 20, "m" + "²" * 60,
    ],
}  # fmt: skip


@pytest.mark.parametrize(
    ("si", "unit"), [(si, unit) for si, units in NONE.items() for unit in units]
)
def test_what_is_no_such_unit_is_refused(si: str, unit: str) -> None:
    with pytest.raises(
        DescriptionError, match=r"^a\.csv: wrong unit; found .*; allowed: a unit that converts to"
    ):
        conversion_factor(unit, si, where="a.csv")


def test_words_that_are_units() -> None:
    assert all(is_unit(text) for text in ("N", "m/s2", "milli-g", "%", "°", "Ns/mm", "mg"))
    assert not any(
        is_unit(text) for text in ("front", "1", "", ":,1", "raw 2", "m^9**9**9", "x" * 200_000)
    )


@pytest.mark.parametrize("text", ["1e-300 m", "5e-324 m", "-1e-200 mm"])
def test_a_size_whose_inverse_is_no_number(text: str) -> None:
    """`design springs --frequency "1e-300 Hz"` and `export road --step "5e-324 m"` were internal errors."""
    with pytest.raises(
        DescriptionError, match=r"an impossible value.*0, and magnitudes from 1e-100 to 1e\+30 m"
    ):
        to_si(text, "m")
    assert to_si("0 m", "m") == 0.0
    assert to_si("6e-33 m", "m") == 6e-33  # what rounding leaves
