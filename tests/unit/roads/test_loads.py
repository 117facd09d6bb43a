"""Loads of driving: steps, ramps and points against time, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest
from pydantic import ValidationError

import jounce as jn
from jounce.roads.trial import LOADS, DrivingAcceleration, PitchMoment

TIMES = np.linspace(0.0, 2.0, 41)


def at(load, times=TIMES, duration: float = 2.0):
    pieces = load.segments(duration)
    assert pieces.edges[0] == 0.0
    assert pieces.edges[-1] == duration
    assert np.all(np.diff(pieces.edges) > 0.0)
    return pieces.evaluate(np.asarray(times, dtype=float))


def test_a_step_with_units():
    load = PitchMoment(value="0.1 kN*m", start="500 ms")
    values, rates = at(load)
    np.testing.assert_array_equal(values, np.where(TIMES >= 0.5, 100.0, 0.0))
    assert not rates.any()
    assert load.segments(2.0).edges.tolist() == [0.0, 0.5, 2.0]


def test_a_plain_value_is_there_from_the_start():
    for given in (3.0, 3, "3 m/s^2"):
        trial = jn.Trial(road=jn.Flat(), speed=1.0, duration=2.0, deceleration=given)
        np.testing.assert_array_equal(trial.load("deceleration").evaluate(TIMES)[0], 3.0)


def test_a_ramp():
    values, rates = at(DrivingAcceleration(value=4.0, start=0.5, ramp=0.8))
    np.testing.assert_allclose(values, np.interp(TIMES, [0.5, 1.3], [0.0, 4.0]), rtol=0, atol=1e-14)
    assert set(np.round(rates, 9)) == {0.0, 5.0}


def test_points():
    load = PitchMoment(time=["0.2 s", 0.6, 1.5], values=["10 N*m", -20.0, 5.0])
    np.testing.assert_allclose(
        at(load)[0], np.interp(TIMES, [0.2, 0.6, 1.5], [10.0, -20.0, 5.0]), rtol=0, atol=1e-12
    )


@pytest.mark.parametrize("duration", [0.3, 0.5, 0.51, 1.0, 1.5, 5.0])
@pytest.mark.parametrize(
    ("load", "times", "values"),
    [
        (PitchMoment(value=7.0, start=0.5, ramp=1.0), [0.5, 1.5], [0.0, 7.0]),
        (
            PitchMoment(time=[0.0, 0.5, 4.0], values=[1.0, 2.0, -5.0]),
            [0.0, 0.5, 4.0],
            [1.0, 2.0, -5.0],
        ),
        (PitchMoment(time=[0.5, 3.0], values=[1.0, 9.0]), [0.5, 3.0], [1.0, 9.0]),
    ],
)
def test_the_run_may_end_before_the_load_does(load, times, values, duration):
    """A shorter run sees the same load, only less of it."""
    t = np.linspace(0.0, duration, 23)
    np.testing.assert_allclose(
        at(load, t, duration)[0], np.interp(t, times, values), rtol=0, atol=1e-12
    )


def test_a_load_that_never_comes():
    values, _ = at(PitchMoment(value=7.0, start=3.0))
    assert not values.any()
    trial = jn.Trial(road=jn.Flat(), speed=1.0, duration=2.0)
    assert not trial.load("lateral_acceleration").evaluate(TIMES)[0].any()
    assert trial.loads == ()


@pytest.mark.parametrize(
    ("table", "words"),
    [
        ({}, "either value"),
        ({"value": 1.0, "time": [0, 1], "values": [0, 1]}, "either value"),
        ({"time": [0, 1, 2], "values": [0, 1]}, "time has 3 numbers and values has 2"),
        ({"time": [0], "values": [1]}, "at least 2"),
        ({"values": [1, 2]}, "either value"),
        ({"time": [0, 1, 1], "values": [0, 1, 2]}, "does not increase"),
        ({"time": [-1, 1], "values": [0, 1]}, "at least 0"),
        ({"value": 1.0, "start": -1.0}, "at least 0"),
        ({"value": 1.0, "ramp": "-1 s"}, "at least 0"),
        ({"value": float("nan")}, "finite|NaN|nan"),
        ({"value": float("inf")}, "finite|inf"),
        ({"time": [0, 1], "values": [0, float("nan")]}, "finite|NaN|nan"),
        ({"value": True}, "number"),
        ({"value": "3 m/s^2"}, "N\\*m|N m"),
        ({"value": "3"}, "unit"),
        ({"value": 1.0, "begin": 1.0}, "begin"),
        ({"value": 1.0, "start": "1 m"}, "s"),
        ({"time": [0, 1], "values": [0, 1], "start": 1.0}, "start"),
        ({"time": [0, 1], "values": [0, 1], "ramp": 1.0}, "ramp"),
    ],
)
def test_refused(table, words):
    with pytest.raises((jn.DescriptionError, ValidationError), match=words):
        jn.Trial(road=jn.Flat(), speed=1.0, duration=1.0, pitch_moment=table)


def test_every_load_is_a_field_of_a_trial():
    assert set(LOADS) <= set(jn.Trial.model_fields)
