"""When a recording begins: the simulation always starts at rest at 0."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.identify.fit_problem import _from_rest

RIG = jn.load("kart-quarter-car")
TRIAL = jn.Trial(
    road=jn.HalfSine(height="10 mm", length="60 mm", start="0.6 m"),
    speed="1.95 m/s",
    duration="1.5 s",
)


@pytest.mark.parametrize(
    ("begin", "first", "uniform"),
    [(0.0, 0.0, 11), (0.005, 0.0, 16), (0.0053, 0.0, 16), (-0.01, -0.01, 11)],
)
def test_output_times_reach_back_to_the_start(begin, first, uniform):
    time = begin + 1e-3 * np.arange(11)
    times, count = _from_rest(time, 1000.0)
    assert times[0] == first
    assert count == uniform
    assert np.all(np.diff(times) > 0.0)
    np.testing.assert_allclose(np.diff(times[-count:]), 1e-3, atol=1e-12)
    np.testing.assert_array_equal(times[-11:], time)


def test_a_cropped_recording_through_a_high_pass_gives_the_same_values():
    """The coupling capacitor has seen the whole pass, also what was cropped from the recording."""
    truth = RIG.with_changes({"strut.spring.rate": "24 N/mm"})
    sensors = {"sprung.az": jn.Sensor(high_pass="2 Hz")}
    whole = jn.apply_sensors(jn.simulate(truth, TRIAL, tolerance=1e-8), sensors)[["sprung.az"]]
    free = {"strut.spring.rate": "10 %"}
    for measured in (whole, whole.isel(time=slice(330, None))):
        result = jn.update_model([jn.FitTrial("one", RIG, TRIAL, measured, sensors)], free)
        assert result.parameters["strut.spring.rate"].value == pytest.approx(24e3, rel=1e-6)
