"""Our own pinned numbers (golden, not validation): operations of the vehicles' equations; a rise fails.

2026-11-21, first version: a half car with 50 operations a right-hand side, a full car of 7 degrees of freedom with 207,
a little more than four quarter cars of 41.
2026-11-23, CasADi below 3.8 writes twice a number as a constant and a product: up to three instructions more.
"""

from __future__ import annotations

import pytest

import jounce as jn
from jounce.simulation.compiled import compile_rig

HALF = "audi-a6-half-car"
PINNED = {
    HALF: {"rate": 51, "output": 72, "switch": 0, "slopes": 74},
    "audi-a6-half-car-4dof": {"rate": 93, "output": 120, "switch": 26, "slopes": 158},
    "audi-a6-full-car": {"rate": 209, "output": 266, "switch": 48, "slopes": 344},
}
SENSITIVE = {
    HALF: {"rate_s": 92, "output_s": 139},
    "audi-a6-half-car-4dof": {"rate_s": 165, "output_s": 224},
    "audi-a6-full-car": {"rate_s": 370, "output_s": 493},
}
FORMS = {"simulink": {"rate": 48, "output": 76}, "sign-corrected": {"rate": 47, "output": 70}}
FREE = ("body.mass", "front.spring_rate", "rear.damping_coefficient")


def counts(rig, names, free=()):
    functions = compile_rig(rig, free).functions
    return {name: functions[name].n_instructions() for name in names}


@pytest.mark.parametrize("name", PINNED)
def test_equations_do_not_grow(name):
    assert counts(jn.load(name), PINNED[name]) == PINNED[name]


@pytest.mark.parametrize("name", SENSITIVE)
def test_sensitivities_do_not_grow(name):
    assert counts(jn.load(name), SENSITIVE[name], FREE) == SENSITIVE[name]


@pytest.mark.parametrize("compat", FORMS)
def test_forms_of_the_half_car_do_not_grow(compat):
    assert counts(jn.load(HALF).with_changes({"compat": compat}), FORMS[compat]) == FORMS[compat]
