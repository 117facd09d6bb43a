"""A rig may be given by its name or file; what is none is refused in one sentence, wherever it is given."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError

NAME = "audi-a6-quarter-car"
TRIAL = jn.Trial(road=jn.HalfSine(height="10 mm", length="1 m"), speed="10 m/s", duration="0.2 s")
DAMPER = {"strut.damper.coefficient": ("300 N*s/m", "6000 N*s/m")}
ROUGH = {"road": "C", "speed": "20 m/s"}
TAKES_NAMES = {
    "simulate": lambda rig: jn.simulate(rig, TRIAL)["sprung.az"].values,
    "simulate_many": lambda rig: (
        jn.simulate_many(rig, TRIAL, {"sprung.mass": [400.0]}, metrics="rms sprung.az")[
            "rms sprung.az"
        ].values
    ),
    "stationary": lambda rig: jn.stationary(rig, **ROUGH)["sprung.az"],
    "optimise": lambda rig: list(jn.optimise(rig, DAMPER, "sprung.az", **ROUGH).values.values()),
    "pareto": lambda rig: jn.pareto(rig, DAMPER, **ROUGH, points=3).comfort,
    "best_dampers": lambda rig: list(jn.best_dampers(rig, **ROUGH)[0].searched.values()),
}
TAKES_RIGS = {
    "FitTrial": lambda rig: jn.FitTrial("one", rig, TRIAL, None),
    "Candidate": lambda rig: jn.Candidate("one", rig, TRIAL),
    "modes": jn.modes,
    "linearise": jn.linearise,
    "equilibrium": jn.equilibrium,
    "gradient": lambda rig: jn.gradient(rig, TRIAL, list(DAMPER), {"sprung.az": 1.0}),
}


@pytest.mark.parametrize("call", TAKES_NAMES.values(), ids=TAKES_NAMES)
def test_a_name_a_file_and_the_rig_itself_are_the_same(call, tmp_path):
    rig = jn.load(NAME)
    file = tmp_path / "own.toml"
    jn.save(rig, file)
    whole = call(rig)
    for given in (NAME, str(file), file):
        np.testing.assert_array_equal(call(given), whole)


@pytest.mark.parametrize("call", TAKES_NAMES.values(), ids=TAKES_NAMES)
def test_a_name_that_is_none_is_refused_with_the_nearest(call):
    with pytest.raises(DescriptionError, match="audi-a6-quarter-car"):
        call("audi-a6-quater-car")


@pytest.mark.parametrize("given", [None, 3, {"sprung": 1.0}])
@pytest.mark.parametrize(
    "call", {**TAKES_NAMES, **TAKES_RIGS}.values(), ids={**TAKES_NAMES, **TAKES_RIGS}
)
def test_what_is_no_rig_is_refused(call, given):
    with pytest.raises(DescriptionError, match=r"rig: not a rig.*a rig or a vehicle"):
        call(given)


@pytest.mark.parametrize("call", TAKES_RIGS.values(), ids=TAKES_RIGS)
def test_who_takes_no_names_says_how_to_load_one(call):
    with pytest.raises(DescriptionError, match=r"jn\.load\('audi-a6-quarter-car'\)"):
        call(NAME)
