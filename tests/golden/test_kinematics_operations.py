"""Our own pinned numbers (golden, not validation): operations of a pose and of the whole catalogue; a rise fails.

2026-11-21, first version: 972 operations a Newton step and 1644 for 52 quantities of a double wishbone (1342 and 2258
with masses in the equations, which do not matter here).
"""

from __future__ import annotations

import pytest

import jounce as jn
from jounce.kinematics.model import kinematic_model

PINNED = {
    "reference-double-wishbone": {"pose": 972, "output": 1644},
    "formula-student-front": {"pose": 1244, "output": 1953},
    "generic-mcpherson": {"pose": 1051, "output": 1875},
    "sedan-multi-link": {"pose": 2664, "output": 6585},
    "semi-trailing-arm": {"pose": 60, "output": 562},
}


@pytest.mark.parametrize("name", PINNED)
def test_kinematics_do_not_grow(name: str) -> None:
    functions = kinematic_model(jn.load(name)).functions
    for part, pinned in PINNED[name].items():
        assert 0.7 * pinned < functions[part].n_instructions() <= pinned, part  # far fewer: pin them anew
