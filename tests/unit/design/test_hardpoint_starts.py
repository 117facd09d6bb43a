from __future__ import annotations

import math

import pytest

import jounce as jn


def test_the_numbers_of_every_search_are_a_design_of_its_own() -> None:
    rig = jn.load("formula-student-front")
    free = {"hardpoints.upper_arm_front[2]": "20 mm", "hardpoints.upper_arm_rear[2]": "20 mm"}
    target = {"quantity": "camber_gain", "value": "-30 deg/m", "tolerance": "0.1 deg/m"}
    found = jn.design_kinematics(rig, free, [target], starts=2)
    assert len(found.starts) == 2
    for one in found.starts:
        assert set(one.numbers) == set(free)
        gain = float(jn.sweep_travel(rig.with_changes(one.numbers), 0.0)["camber_gain"][0])
        missed = abs(math.degrees(gain) + 30.0) / 0.1
        assert (missed <= 1.0) == one.met
        assert 0.5 * missed**2 == pytest.approx(one.cost, abs=1e-3)  # numbers are rounded to the nanometre
    best = {path: one.after for path, one in found.moved.items()}
    assert best in [one.numbers for one in found.starts]
    assert len({tuple(one.numbers.values()) for one in found.starts}) > 1  # designs that differ
    assert found.results()["starts"][1]["numbers"] == found.starts[1].numbers
