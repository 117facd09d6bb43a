"""The damping a campaign takes from free decays, on rigs whose truth is known, laws as lines and as curves."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.campaign.characterise import characterise
from jounce.campaign.description import Bench
from jounce.recordings import write_recording

KART = jn.load("kart-quarter-car")
CURVES = {
    "lines": {},
    "curved spring": {
        "strut.spring": {"rate": None, "curve": {"kind": "polynomial", "coefficients": [20e3, 2e5]}, "preload": 0.0}
    },
    "curved tyre": {"tyre.stiffness": None, "tyre.curve": {"kind": "polynomial", "coefficients": [90e3, 1.2e7]}},
}


@pytest.mark.parametrize("support", ["tyre", "blocked"])
@pytest.mark.parametrize("name", CURVES)
def test_damping_of_the_strut_is_recovered(tmp_path, name, support):
    """Small amplitudes, so that curves act with their tangents; the unsprung mass is neglected by the method."""
    truth = KART.with_changes({**CURVES[name], "tyre.lift_off": False, "unsprung.mass": 0.05})
    if support == "blocked":
        truth = truth.with_changes({"tyre": {"stiffness": 1e9, "lift_off": False}})
    trial = jn.Trial(road=jn.Flat(), speed="1 m/s", duration="1.5 s")
    run = jn.simulate(truth, trial, offset={"sprung.z": -1e-3}, tolerance=1e-8)
    write_recording(run[["sprung.z"]], tmp_path / "decay.csv")
    start = truth.with_changes({"strut.damper.coefficient": 100.0})
    bench = Bench(decay={"files": ["decay.csv"], "support": support})
    found, knowledge = characterise(start, bench, tmp_path)
    assert not found.failed
    assert knowledge.rig.parameters()["strut.damper.coefficient"] == pytest.approx(150.0, rel=0.02)
    assert np.isfinite(found.decay.stiffness.value)
