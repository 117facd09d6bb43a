"""A suspension thrown over a singular configuration: the run stops there, with time and pose; a rack out of reach."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

RIG = jn.load("reference-double-wishbone")
CLIFF = jn.Trial(
    road=jn.Ramp(height="0.8 m", length="0.05 m", start="0.5 m"), speed="5 m/s", duration="0.6 s"
)


def test_a_wheel_that_flips_over_ends_the_run():
    with pytest.raises(jn.SimulationError, match="flipped over") as caught:
        jn.simulate(RIG, CLIFF)
    assert "pose: " in str(caught.value)
    run = jn.simulate(RIG, CLIFF, check=False)
    assert run.attrs["status"] == "flipped"
    assert 0.1 < float(run["time"][-1]) < 0.5
    assert np.isfinite(run["unsprung.z"]).all()


def test_an_ordinary_obstacle_does_not():
    road = jn.HalfSine(height="60 mm", length="0.4 m", start="0.5 m")
    run = jn.simulate(RIG, jn.Trial(road=road, speed="5 m/s", duration="1 s"))
    assert run.attrs["status"] == "completed"


@pytest.mark.parametrize("rack", ["300 mm", "-300 mm"])
def test_a_rack_beyond_reach_is_refused(rack):
    with pytest.raises(jn.SimulationError):
        jn.modes(RIG.with_changes({"steering": {"rack_travel": rack}}))
