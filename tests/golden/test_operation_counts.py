"""Our own pinned numbers (golden, not validation): operations of the generated equations; a rise fails.

2026-11-21, first version: quarter car with 43 operations a right-hand side.
2026-11-21, what depends on parameters only is computed once a run (``derived``): 41; one lane of sensitivities a
parameter instead of the equations written out for each: 73 instead of 127 for three.
"""

from __future__ import annotations

import pytest

import jounce as jn
from jounce.models import build
from jounce.simulation.compiled import compile_model

PINNED = {
    "kart-quarter-car": {"rate": 41, "output": 49, "switch": 13},
    "audi-a6-quarter-car": {"rate": 41, "output": 49, "switch": 13},
    "hmmwv-front-corner": {"rate": 45, "output": 53, "switch": 18},
}
FREE = ("strut.spring.rate", "strut.damper.coefficient", "tyre.stiffness")


@pytest.mark.parametrize("name", PINNED)
def test_equations_do_not_grow(name):
    functions = compile_model(build(jn.load(name))).functions
    assert {part: functions[part].n_instructions() for part in PINNED[name]} == PINNED[name]


def test_sensitivities_do_not_grow():
    functions = compile_model(build(jn.load("kart-quarter-car")), FREE).functions
    assert functions["rate_s"].n_instructions() == 73
    assert functions["output_s"].n_instructions() == 91
