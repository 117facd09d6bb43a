from __future__ import annotations

import math
from types import SimpleNamespace

import numpy as np
import pytest
from scipy.optimize import minimize

import jounce as jn
from jounce.design.hardpoint_search import UNSETTLED, HardpointSearch


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
        assert 0.5 * missed**2 == pytest.approx(
            one.cost, abs=1e-3
        )  # numbers are rounded to the nanometre
    best = {path: one.after for path, one in found.moved.items()}
    assert best in [one.numbers for one in found.starts]
    assert len({tuple(one.numbers.values()) for one in found.starts}) > 1  # designs that differ
    assert found.results()["starts"][1]["numbers"] == found.starts[1].numbers


@pytest.mark.parametrize(("away", "ended"), [(0.0, "no step makes it better"), (0.1, UNSETTLED)])
def test_a_search_rests_where_no_step_can_gain_whatever_its_method_claims(monkeypatch, away, ended):
    """The first number is wanted at 2, outside of its box; the second at 0.5, and must not exceed -0.6 + 0.95."""
    both, one = np.eye(2), np.ones(2)
    wanted = np.array([2.0, 0.5])
    search = SimpleNamespace(
        must=np.array([False, True]), lower=-one, upper=one, scale=one, tolerance=one, share=one,
        low=np.array([2.0, -9.0]), high=np.array([2.0, -0.6]), numbers=lambda place: place,
        off=lambda values: values - wanted, evaluator=SimpleNamespace(together=lambda values: (values, both)),
    )  # fmt: skip

    def unsure(*arguments, **options):
        found = minimize(*arguments, **options)
        found.x, found.success, found.status = found.x - [0.0, away], False, 8
        return found

    monkeypatch.setattr("scipy.optimize.minimize", unsure)
    place, _, why = HardpointSearch.satisfy_constraints(search, np.zeros(2))
    assert place == pytest.approx([1.0, 0.35 - away])  # at a wall, and at the limit
    assert why == ended
