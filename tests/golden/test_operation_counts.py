"""Our own pinned numbers (golden, not validation): operations of the generated equations; a rise fails.

2026-11-21, first version: quarter car with 43 operations a right-hand side.
2026-11-21, what depends on parameters only is computed once a run (``derived``): 41; one lane of sensitivities a
parameter instead of the equations written out for each: 73 instead of 127 for three.
2026-11-21, every 3-D template: a double wishbone with 1335 operations a right-hand side, 3046 with sensitivities.
2026-11-21, the tyre takes its deflection rate from the velocity of the wheel centre: 19 fewer a right-hand side, 39
fewer switching functions, 15 more outputs.
2026-11-21, full car on four 3-D corners: 3121 operations on four corners at once and 212 others, in place of 22 260.
2026-11-28, tyres of that car push at the contact point, by their deflection along the wheel's plane: 65 more on four
corners at once, 8 fewer others.
2026-11-23, CasADi below 3.8 writes twice a number as a constant and a product: a constant more here and there.
"""

from __future__ import annotations

import pytest

import jounce as jn
from jounce.models import build
from jounce.simulation.compiled import compile_model, compile_rig
from jounce.simulation.programs import plain_program

PINNED = {
    "kart-quarter-car": {"rate": 41, "output": 49, "switch": 13},
    "audi-a6-quarter-car": {"rate": 41, "output": 49, "switch": 13},
    "hmmwv-front-corner": {"rate": 45, "output": 53, "switch": 18},
}
CORNERS = {
    "kart-double-wishbone": {
        "rate": 1325,
        "output": 1508,
        "switch": 80,
        "project_many": 982,
        "slopes": 3084,
    },
    "generic-mcpherson": {
        "rate": 2131,
        "output": 2308,
        "switch": 80,
        "project_many": 1534,
        "slopes": 5143,
    },
    "sedan-multi-link": {
        "rate": 4244,
        "output": 4113,
        "switch": 17,
        "project_many": 3704,
        "slopes": 7927,
    },
    "semi-trailing-arm": {"rate": 225, "output": 281, "switch": 97, "slopes": 531},
    "formula-student-front": {
        "rate": 1638,
        "output": 1812,
        "switch": 149,
        "project_many": 1229,
        "slopes": 3667,
    },
    "hmmwv-front": {
        "rate": 2744,
        "output": 2901,
        "switch": 213,
        "project_many": 1800,
        "slopes": 5667,
    },
}
FULL_CAR_3D = {
    "rate": (3198, 198),
    "output": (3563, 236),
    "switch": (252, 12),
    "project": (929, 23),
}
"""Operations on four corners at once, and on single numbers."""
ARMS = ("lower_arm_front", "lower_arm_rear", "upper_arm_front", "upper_arm_rear")
ON_BUSHINGS = {
    "rate": 3370,
    "output": 3609,
    "switch": 107,
    "project_many": 2211,
    "slopes": 7506,
}  # 2026-11-28: rotation vectors, +4 %
TEN = (
    "hardpoints.strut_bottom[2]",
    "hardpoints.upper_ball_joint[1]",
    "hardpoints.lower_ball_joint[1]",
    "hardpoints.tie_rod_outer[2]",
    "hardpoints.lower_arm_front[2]",
    "sprung.mass",
    "bodies.upright.mass",
    "strut.spring.rate",
    "strut.damper.coefficient",
    "tyre.stiffness",
)
FREE = ("strut.spring.rate", "strut.damper.coefficient", "tyre.stiffness")


@pytest.mark.parametrize("name", PINNED)
def test_equations_do_not_grow(name):
    functions = compile_model(build(jn.load(name))).functions
    assert {part: functions[part].n_instructions() for part in PINNED[name]} == PINNED[name]


def test_sensitivities_do_not_grow():
    functions = compile_model(build(jn.load("kart-quarter-car")), FREE).functions
    assert functions["rate_s"].n_instructions() == 73
    assert functions["output_s"].n_instructions() == 91


def test_the_full_car_computes_its_corners_side_by_side():
    program = plain_program(build(jn.load("formula-student-car")))
    for name, (vectors, numbers) in FULL_CAR_3D.items():
        graph = program.functions[name].graph
        groups = [graph.group_of(i) for i, node in enumerate(graph.nodes) if node.operands]
        shapes = {
            graph.shapes[i]
            for i, node in enumerate(graph.nodes)
            if node.operands and graph.group_of(i)
        }
        assert (len(shapes), groups.count(None)) == (vectors, numbers), name


def counts(functions, names):
    return {name: functions[name].n_instructions() for name in names}


@pytest.mark.parametrize("name", CORNERS)
def test_equations_of_corners_do_not_grow(name):
    assert counts(compile_rig(jn.load(name)).functions, CORNERS[name]) == CORNERS[name]


def test_equations_on_bushings_do_not_grow():
    law = {"stiffness": [1e7] * 3, "rotational_stiffness": [20.0] * 3}
    rig = jn.load("kart-double-wishbone").with_changes({"bushings": dict.fromkeys(ARMS, law)})
    assert counts(compile_rig(rig).functions, ON_BUSHINGS) == ON_BUSHINGS


def test_sensitivities_of_the_double_wishbone_do_not_grow():
    expected = {
        "rate_s": 3005,
        "output_s": 3535,
        "project_s": 1626,
        "switch_slope": 265,
        "derived_lanes": 482,
    }
    assert counts(compile_rig(jn.load("kart-double-wishbone"), TEN).functions, expected) == expected
