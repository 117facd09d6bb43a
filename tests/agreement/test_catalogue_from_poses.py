"""Every row of the catalogue against differences of poses, of every suspension, on both sides, steered and not.

``docs/make_validation.py`` writes the table of ``docs/explanation/kinematics-validation.md`` from the same cases.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from validation_cases import CASES, compared, compared_axle, rig_of

import jounce as jn
from jounce.kinematics.catalogue import CATALOGUE

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "explanation" / "kinematics-validation.md"


@pytest.fixture(scope="module")
def found():
    return {case: compared(*case) for case in CASES}


def test_every_row_is_that_of_the_poses(found) -> None:
    for case, (errors, shapes) in found.items():
        wrong = {name: error for name, error in errors.items() if not error < 1e-8}
        assert not wrong, (case, wrong)
        assert max(shapes.values()) < 1e-14, (
            case
        )  # m: links and bodies keep their shape, so the poses are right


@pytest.fixture(scope="module")
def axle():
    return compared_axle()


def test_rows_of_an_axle_are_those_of_its_wheels(axle) -> None:
    wrong = {name: error for name, error in axle.items() if not error < 1e-8}
    assert not wrong


def test_no_row_is_left_out(found) -> None:
    known = {name for errors, _ in found.values() for name in errors}
    assert known == {row.name for row in CATALOGUE}
    for name, travel, rack in CASES:
        swept = jn.sweep_travel(rig_of(name), [travel], rack)
        own = {str(one) for one in (*swept.data_vars, *swept.coords)} - (
            {"rack_travel"} if rack is None else set()
        )
        assert own == set(found[name, travel, rack][0]), name


def test_poses_are_distinct_enough_to_see_a_mistake() -> None:
    """No row that may change is 0 or 1 at all poses, where a wrong sign or factor would not be seen."""
    values: dict[str, list[float]] = {}
    for name, travel, rack in CASES:
        swept = jn.sweep_travel(rig_of(name), [travel], rack)
        for one in (*swept.data_vars, *swept.coords):
            values.setdefault(str(one), []).append(float(swept[one].to_numpy().ravel()[0]))
    still = {
        name
        for name, seen in values.items()
        if np.all(np.abs(np.abs(seen) - 1.0) < 1e-9) or np.allclose(seen, 0.0)
    }
    assert still == {
        "steering_axis_pitch"
    }  # all of these make a pure turn; others are in tests/physics


def test_the_page_tells_what_is_compared(found, axle) -> None:
    import make_validation as script

    told = {
        match[1]: float(match[2])
        for match in re.finditer(
            r"^\| `(\w+)` \|.*\| (\S+) \|$", PAGE.read_text(encoding="utf-8"), re.M
        )
    }
    assert {row.name for row in CATALOGUE} == set(script.HOW)
    assert set(axle) == set(script.AXLE)
    assert set(told) == set(script.HOW) | set(axle)
    for name, bound in told.items():
        seen = [errors[name] for errors, _ in found.values() if name in errors]
        largest = max([*seen, axle.get(name, 0.0)])
        assert largest <= 30.0 * bound, name  # rounding is another one on another machine
