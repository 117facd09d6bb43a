"""Our own pinned numbers (golden, not validation): operations of a pose and of the whole catalogue; a rise fails.

2026-11-21, first version: 972 operations a Newton step and 1644 for 52 quantities of a double wishbone (1342 and 2258
with masses in the equations, which do not matter here).
2026-11-22: 63 quantities. Trail, scrub and offsets in the wheel's axes too, angles of the swing arms, the axis at held
spring length; links steer about the pure turn that rack and travel can make.
2026-11-22: 67 quantities. Kingpin inclination gain, camber per steer, ride height, tyre stiffness; three
more of a rocker.
2026-11-23: 68 quantities. Motion of the wheel centre per rise of the contact patch.
2026-11-24: 69 quantities. Force of the damper at rest, none of linear ones: one instruction more.
2026-11-23, CasADi below 3.8 writes twice a number as a constant and a product: up to 2 % more instructions.
"""

from __future__ import annotations

import pytest

import jounce as jn
from jounce.kinematics.model import kinematic_model

PINNED = {
    "reference-double-wishbone": {"pose": 983, "output": 1852},
    "formula-student-front": {"pose": 1259, "output": 2305},
    "generic-mcpherson": {"pose": 1062, "output": 2096},
    "sedan-multi-link": {"pose": 2716, "output": 7443},
    "semi-trailing-arm": {"pose": 60, "output": 514},
}


@pytest.mark.parametrize("name", PINNED)
def test_kinematics_do_not_grow(name: str) -> None:
    functions = kinematic_model(jn.load(name)).functions
    for part, pinned in PINNED[name].items():
        assert 0.7 * pinned < functions[part].n_instructions() <= pinned, (
            part
        )  # far fewer: pin them anew
