"""Formulas over channels: closed forms, units that are carried, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.analysis.formula import ComputedChannel, evaluate_formula
from jounce.analysis.formula_text import channels_in
from jounce.core.errors import JounceError

RATE = 1000.0
TIME = np.arange(0.0, 4.0, 1.0 / RATE)
WAVE = 2.0 * np.pi * 1.5
CHANNELS = {
    "damper.displacement": (10.0 * np.sin(WAVE * TIME), "mm"),
    "speed": (np.full(TIME.size, 36.0), "km/h"),
    "roll_rate": (np.full(TIME.size, 30.0), "deg/s"),
    "sprung.az": (np.cos(TIME), "g"),
    "steer angle": (np.full(TIME.size, 90.0), "deg"),
    "force": (np.linspace(-1.0, 1.0, TIME.size), "kN"),
    "nothing": (np.zeros(TIME.size), "m/s"),
    "engine": (np.full(TIME.size, 6000.0), "rpm"),
    "temperature": (np.full(TIME.size, 20.0), "degC"),
}


def evaluate(formula: str, unit: str = "") -> ComputedChannel:
    return evaluate_formula(formula, CHANNELS.__getitem__, list(CHANNELS), TIME, unit=unit)


@pytest.mark.parametrize(
    ("formula", "unit", "value"),
    [
        ("speed", "m/s", 10.0),
        ("speed * roll_rate", "m/s^2", 10.0 * np.radians(30.0)),
        ("speed * roll_rate + '1 m/s^2'", "m/s^2", 10.0 * np.radians(30.0) + 1.0),
        ("speed ** 2 / '2 m'", "m/s^2", 50.0),
        ("sqrt(speed ** 2)", "m/s", 10.0),
        ("sin(`steer angle`)", "1", 1.0),
        ("`steer angle` - '60 deg'", "rad", np.radians(30.0)),
        ("atan2(speed, speed)", "rad", np.pi / 4.0),
        ("where(speed > '20 km/h', 1, 2)", "1", 1.0),
        ("clip(speed, '1 m/s', '8 m/s')", "m/s", 8.0),
        ("max(speed, 0)", "m/s", 10.0),
        ("engine", "rad/s", 200.0 * np.pi),
        ("temperature", "K", 293.15),
        ("mean(force) + '5 N'", "N", 5.0),
        ("speed * '2 N*s/m' * 3", "N", 60.0),
        ("-speed / speed ** 3", "s^2/m^2", -0.01),
        ("maximum(time)", "s", TIME[-1]),
    ],
)
def test_units_are_carried(formula: str, unit: str, value: float) -> None:
    found = evaluate(formula)
    assert found.unit == unit
    np.testing.assert_allclose(found.values, value, rtol=1e-12, atol=1e-9)
    assert found.findings == ()


def test_the_result_is_in_the_unit_that_was_asked_for() -> None:
    assert evaluate("speed", "km/h").values[0] == pytest.approx(36.0)
    assert evaluate("temperature", "degC").values[0] == pytest.approx(20.0)
    assert evaluate("sprung.az", "g").values[0] == pytest.approx(1.0)


def test_a_derivative_and_an_integral_are_those_of_a_sine() -> None:
    speed = evaluate("derivative(damper.displacement)", "mm/s").values
    np.testing.assert_allclose(speed, 10.0 * WAVE * np.cos(WAVE * TIME), atol=5e-3)
    path = evaluate("integral(derivative(damper.displacement))", "mm").values
    np.testing.assert_allclose(path, 10.0 * np.sin(WAVE * TIME), atol=5e-3)
    assert evaluate("integral(speed)").values[-1] == pytest.approx(10.0 * TIME[-1])


def test_filters_have_minus_three_decibels_at_their_corner() -> None:
    inner = slice(1000, 3000)
    for formula in (
        "lowpass(damper.displacement, '1.5 Hz')",
        "highpass(damper.displacement, '1.5 Hz')",
    ):
        values = evaluate(formula, "mm").values[inner]
        assert np.abs(values).max() == pytest.approx(10.0 / np.sqrt(2.0), rel=5e-3)
    smooth = evaluate("smooth(damper.displacement, '0.667 s')", "mm").values[inner]
    assert np.abs(smooth).max() < 0.02  # a whole period
    late = evaluate("delay(damper.displacement, '0.1 s')", "mm").values
    np.testing.assert_allclose(late[200:], 10.0 * np.sin(WAVE * (TIME[200:] - 0.1)), atol=1e-3)
    assert np.isnan(late[:100]).all()
    assert np.abs(evaluate("detrend(time)").values).max() < 1e-9


def test_division_by_nothing_is_said() -> None:
    with pytest.raises(
        JounceError, match="speed / nothing: division by zero; found nothing is zero throughout"
    ):
        evaluate("speed / nothing")
    crossing = evaluate("speed / max(force, '0 N')")
    (found,) = crossing.findings
    assert found.code == "analysis.divided_by_zero"
    lost = int(np.isnan(crossing.values).sum())
    assert lost == 2000
    assert found.message.startswith(
        "max(force, '0 N') is zero at 2000 of 4000 samples, first at 0 s"
    )
    (gaps,) = evaluate("sqrt(force)").findings
    assert gaps.code == "analysis.no_value"


@pytest.mark.parametrize(
    ("formula", "words"),
    [
        ("speed + force", "units do not fit; found 'm/s and N'"),
        ("`steer angle` + 1", "'1 deg' or '1 rad'"),
        ("sin(speed)", "units do not fit; found 'm/s'; allowed: an angle or a plain number"),
        ("exp(`steer angle`)", "allowed: a plain number"),
        ("speed ** force", "not an exponent"),
        ("speed ** 99", "a number from -12 to 12"),
        ("speeed", "no channel 'speeed'"),
        ("speed ^ 2", r"Write a power as x \*\* 2"),
        ("lowpass(speed, 20)", "a number in Hz, in quotes"),
        ("lowpass(speed, '700 Hz')", "cannot be realised at this sample rate"),
        ("lowpas(speed, '20 Hz')", "no such function"),
        ("min(speed)", "wrong number of arguments"),
        ("speed +", "the formula cannot be read"),
        ("", "the formula cannot be read"),
        ("__import__('os').system('true')", "no such function"),
        ("speed.__class__", "no channel 'speed.__class__'"),
        ("[speed for x in speed]", "not allowed in a formula"),
        ("(lambda: speed)()", "no such function"),
        ("speed if speed else 1", "not allowed in a formula"),
        ("'20 Furlong'", "not a unit"),
        ("speed * '20 xyz'", "not a unit"),
        ("'speed'", "not a number with a unit"),
        ("1e300", "not a number with a unit"),
        ("+".join(["speed"] * 400), "too long"),
        ("speed" * 300, "too long"),
        ("speed\0", "cannot be read"),
        ("max(speed, *force)", "arguments have no names here"),
        ("smooth(speed, '1 h')", "the span does not fit the record"),
    ],
)  # fmt: skip
def test_what_makes_no_sense_is_refused(formula: str, words: str) -> None:
    with pytest.raises(JounceError, match=words):
        evaluate(formula)


def test_the_wrong_unit_is_refused() -> None:
    with pytest.raises(JounceError, match="the formula has another unit; found 'm/s'"):
        evaluate("speed", "N")


def test_uneven_time_is_integrated_and_not_filtered() -> None:
    time = np.array([0.0, 1.0, 3.0, 4.0])
    channels = {"force": (np.array([0.0, 2.0, 2.0, 0.0]), "N")}
    found = evaluate_formula("integral(force)", channels.__getitem__, ["force"], time)
    assert found.values.tolist() == [0.0, 1.0, 5.0, 6.0]
    with pytest.raises(JounceError, match="time is not uniform"):
        evaluate_formula("lowpass(force, '0.1 Hz')", channels.__getitem__, ["force"], time)
    gaps = {"force": (np.array([0.0, np.nan, 2.0, 0.0]), "N")}
    with pytest.raises(JounceError, match="1 of 4 samples are missing; found 'the first at 1 s'"):
        evaluate_formula("integral(force)", gaps.__getitem__, ["force"], time)


def test_names_of_a_formula_are_those_it_uses() -> None:
    names = ["speed", "steer angle", "force", "sprung.az"]
    assert channels_in("lowpass(`steer angle`, '5 Hz') + sprung.az", names) == [
        "steer angle",
        "sprung.az",
    ]
