"""Damper and spring records in every combination of signs: right, or a finding that names the turned column."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from jounce.core.errors import DescriptionError
from jounce.core.units import conversion_factor, to_si
from jounce.identify.damper import damper_curve, fit_damper
from jounce.identify.force_deflection import ForceDeflectionTrial
from jounce.identify.signs import compression_positive
from jounce.identify.stiffness import fit_stiffness
from jounce.recordings import recording

TIME = np.arange(0.0, 4.0, 0.005)
STROKE = 0.020 * np.sin(2 * np.pi * TIME)
SPEED = 0.040 * np.pi * np.cos(2 * np.pi * TIME)
COMBINATIONS = list(itertools.product((1, -1), (1, -1)))
NOISE = np.random.default_rng(1).normal(0.0, 4.0, len(TIME))


def record(stroke, force, *, bump=500.0, rebound=2000.0, gas=60.0, velocity=True):
    """Stroke, velocity, force and time of a damper as a machine with these signs records them."""
    truth = np.where(SPEED > 0.0, bump, rebound) * SPEED + gas + NOISE
    return stroke * STROKE, stroke * SPEED if velocity else None, force * truth, TIME


def words(stroke, force):
    return {
        "stroke_positive": "compression" if stroke > 0 else "extension",
        "force_positive": "compression" if force > 0 else "tension",
    }


def values(result):
    return {key: one.value for key, one in result.parameters.items()}


def loud(result):
    return [f for f in result.findings if f.severity != "note"]


@pytest.mark.parametrize(("stroke", "force"), COMBINATIONS)
@pytest.mark.parametrize("gas", [60.0, 0.0, -30.0])
@pytest.mark.parametrize("velocity", [True, False])
def test_stated_signs_give_the_truth(stroke, force, gas, velocity):
    result = fit_damper(
        *record(stroke, force, gas=gas, velocity=velocity), law="bilinear", **words(stroke, force)
    )
    truth = {"bump_coefficient": 500.0, "rebound_coefficient": 2000.0, "offset": gas}
    assert values(result) == pytest.approx(truth, rel=0.01, abs=1.5)
    assert result.damper == {
        "bump_coefficient": pytest.approx(500.0, rel=0.01),
        "rebound_coefficient": pytest.approx(2000.0, rel=0.01),
    }
    assert words(stroke, force) == {
        "stroke_positive": result.stroke_positive,
        "force_positive": result.force_positive,
    }
    assert bool(loud(result)) == (gas < 0.0)  # a force that pulls inwards is doubted even then


@pytest.mark.parametrize(("stroke", "force"), COMBINATIONS)
def test_without_options_a_gas_force_tells_the_turned_column(stroke, force):
    result = fit_damper(*record(stroke, force), law="bilinear")
    if (stroke, force) == (-1, -1):
        assert "the signs of stroke and force are both reversed" in loud(result)[0].message
    else:
        truth = {"bump_coefficient": 500.0, "rebound_coefficient": 2000.0, "offset": 60.0}
        assert values(result) == pytest.approx(truth, rel=0.01, abs=1.5)
        turned = {(1, 1): None, (-1, 1): "stroke", (1, -1): "force"}[stroke, force]
        assert [
            f"the {turned} was recorded with the opposite sign" in f.message for f in loud(result)
        ] == [True] * bool(turned)


@pytest.mark.parametrize(("stroke", "force"), COMBINATIONS)
def test_without_options_and_gas_nothing_is_silent(stroke, force):
    result = fit_damper(*record(stroke, force, gas=0.0), law="bilinear")
    assert any("stroke" in f.message and "force" in f.message for f in loud(result))


@pytest.mark.parametrize(("stroke", "force"), COMBINATIONS)
@pytest.mark.parametrize("gas", [60.0, 0.0])
def test_a_symmetric_damper_is_right_whatever_the_signs(stroke, force, gas):
    result = fit_damper(*record(stroke, force, bump=1500.0, rebound=1500.0, gas=gas))
    assert result.parameters["coefficient"].value == pytest.approx(1500.0, rel=0.01)
    assert bool(loud(result)) == (
        stroke != force or (gas > 0.0 and stroke < 0)
    )  # gas that pulls is told


@pytest.mark.parametrize(
    ("stated", "column"), [("stroke_positive", "force"), ("force_positive", "stroke")]
)
@pytest.mark.parametrize("gas", [60.0, 0.0])
def test_one_stated_sign_tells_the_other(stated, column, gas):
    stroke, force = (1, -1) if stated == "stroke_positive" else (-1, 1)
    result = fit_damper(*record(stroke, force, gas=gas), law="bilinear", **{stated: "compression"})
    assert values(result)["bump_coefficient"] == pytest.approx(500.0, rel=0.01)
    assert f"the {column} was recorded with the opposite sign" in loud(result)[0].message


@pytest.mark.parametrize(("stroke", "force"), COMBINATIONS)
@pytest.mark.parametrize(("said_stroke", "said_force"), COMBINATIONS)
def test_wrong_statements_are_never_silent(stroke, force, said_stroke, said_force):
    result = fit_damper(*record(stroke, force), law="bilinear", **words(said_stroke, said_force))
    right = values(result) == pytest.approx(
        {"bump_coefficient": 500.0, "rebound_coefficient": 2000.0, "offset": 60.0},
        rel=0.01,
        abs=1.5,
    )
    assert right or loud(result)
    if (stroke, force) == (said_stroke, said_force):
        assert right
        assert not loud(result)
    if stroke * force != said_stroke * said_force:
        assert "problem" in {f.severity for f in result.findings}


@pytest.mark.parametrize("column", ["velocity", "stroke"])
def test_a_velocity_that_contradicts_the_stroke_follows_it(column):
    stroke, velocity, force, time = record(1, 1)
    if column == "velocity":
        velocity = -velocity
    result = fit_damper(stroke, velocity, force, time, law="bilinear")
    assert values(result)["bump_coefficient"] == pytest.approx(500.0, rel=0.01)
    assert any("velocity" in f.message and "reversed" in f.message for f in loud(result)) == (
        column == "velocity"
    )


def test_a_spring_is_no_damper():
    result = fit_damper(STROKE, SPEED, 20e3 * STROKE + 100.0 + NOISE, TIME)
    assert any("hardly any work" in f.message for f in loud(result))


def test_a_hold_out_is_read_as_the_fitted_record():
    result = fit_damper(*record(-1, -1), law="bilinear", **words(-1, -1))
    curve = damper_curve(result, *record(-1, -1))
    assert np.sqrt(np.mean((curve.fitted - curve.measured) ** 2)) < 5.0


@pytest.mark.parametrize(
    "options",
    [{"stroke_positive": "tension"}, {"force_positive": "extension"}, {"stroke_positive": "-1"}],
)
def test_unknown_signs_are_refused(options):
    with pytest.raises(DescriptionError, match="allowed"):
        fit_damper(*record(1, 1), **options)
    with pytest.raises(DescriptionError, match="allowed"):
        fit_stiffness([ForceDeflectionTrial(STROKE[:50], STROKE[:50], "one", **options)])


@pytest.mark.parametrize(
    "unit",
    [
        "-mm",
        "\N{MINUS SIGN}mm",
        "\N{EN DASH}mm",
        "- mm",
        "(-1)*mm",
        "mm*-1",
        "-1 mm",
        "-1*mm",
        "mm/-1",
    ],
)
def test_turned_units_are_accepted_nowhere(unit):
    with pytest.raises(DescriptionError, match="wrong unit"):
        conversion_factor(unit, "m")
    with pytest.raises(DescriptionError):
        to_si(f"3 {unit}", "m")


@pytest.mark.parametrize(("stroke", "force"), COMBINATIONS)
@pytest.mark.parametrize("stated", [False, True])
@pytest.mark.parametrize("preload", [0.0, 300.0])
def test_a_spring_pushes_back_whatever_the_signs(stroke, force, stated, preload):
    way = np.concatenate([np.linspace(0.0, 0.03, 100), np.linspace(0.03, 0.0, 100)])
    options = words(stroke, force) if stated else {}
    trial = ForceDeflectionTrial(
        stroke * way, force * (preload + 22.7e3 * way), "spring", **options
    )
    result = fit_stiffness([trial], intercept="keep")
    assert result.stiffness.value == pytest.approx(22.7e3, rel=1e-9)
    assert result.intercept.value == pytest.approx(preload, abs=1e-6)
    notes = [f for f in result.findings if "reversed" in f.message]
    assert len(notes) == (0 if stated else (stroke < 0) + (force < 0))


@pytest.mark.parametrize(("stroke", "force"), [(1, -1), (-1, 1), (-1, -1)])
def test_a_wrong_statement_about_a_spring_is_a_warning(stroke, force):
    way = np.linspace(0.0, 0.03, 100)
    trial = ForceDeflectionTrial(stroke * way, force * 22.7e3 * way, "spring", **words(1, 1))
    result = fit_stiffness([trial])
    assert result.stiffness.value == pytest.approx(22.7e3, rel=1e-9)
    assert len([f for f in loud(result) if "as stated" in f.message]) == (stroke < 0) + (force < 0)


def test_channels_of_a_trial_are_turned_as_stated():
    channels = {
        name: ([1.0, 2.0], unit, "")
        for name, unit in [
            ("strut.deflection", "m"),
            ("strut.force", "N"),
            ("sprung.z", "m"),
            ("sprung.az", "m/s^2"),
        ]
    }
    run = recording([0.0, 1.0], channels)
    signs = {
        name: float(values[0])
        for name, values in compression_positive(run, "extension", None).items()
    }
    assert signs == {
        "strut.deflection": -1.0,
        "strut.force": 1.0,
        "sprung.z": 1.0,
        "sprung.az": 1.0,
    }
    signs = {
        name: float(values[0])
        for name, values in compression_positive(run, None, "tension").items()
    }
    assert signs == {
        "strut.deflection": 1.0,
        "strut.force": -1.0,
        "sprung.z": 1.0,
        "sprung.az": 1.0,
    }
