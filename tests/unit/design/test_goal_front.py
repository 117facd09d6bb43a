"""Fronts of three metrics and more: nothing sampled surpasses them, as Python, as file, as picture and as page."""

from __future__ import annotations

import json

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.design.mixtures import mixtures, undominated_rows
from jounce.design.optimise import task_of

FREE = {"strut.damper.coefficient": ("300 N*s/m", "6000 N*s/m"), "strut.spring.rate": "±40 %"}
GOALS = ["rough: sprung.az", "rough: tyre.force", "rough: strut.deflection"]
CASES = {"rough": {"road": "C", "speed": "20 m/s"}}
LIMIT = {"rough: strut.deflection": "14 mm"}
STUDY = """
schema = "jounce.optimisation/1"
rig = "audi-a6-quarter-car"
free = {"strut.damper.coefficient" = ["300 N*s/m", "6000 N*s/m"], "strut.spring.rate" = "±40 %"}
front = ["rough: sprung.az", "rough: tyre.force", "rough: strut.deflection"]
points = 4
[cases]
rough = {road = "C", speed = "20 m/s"}
"""


@pytest.fixture(scope="module")
def front():
    return jn.design_front(
        "audi-a6-quarter-car", FREE, GOALS, cases=CASES, constraints=LIMIT, points=6
    )


def test_no_design_of_a_dense_grid_surpasses_the_front(front):
    assert front.converged
    assert front.count >= 5
    found = np.column_stack(list(front.goals.values()))
    span = np.ptp(found, axis=0)
    assert undominated_rows(found, span) == list(range(front.count))
    car = jn.load("audi-a6-quarter-car")
    problem = task_of(car, FREE, dict.fromkeys(GOALS, 1.0), LIMIT, {}, CASES, None, 32, 1)
    grid = [
        [np.geomspace(300.0, 6000.0, 20)[i], np.linspace(22800.0, 53200.0, 9)[j]]
        for i in range(20)
        for j in range(9)
    ]
    sampled = np.array([[problem.whole(goal, np.array(at))[0] for goal in GOALS] for at in grid])
    kept = sampled[sampled[:, 2] <= 0.014]
    assert 50 < len(kept) < len(grid)
    for one in found:
        assert not np.any(np.all(kept < one - 1e-3 * span, axis=1))
    assert np.all(
        found.min(axis=0) <= kept.min(axis=0) * (1.0 + 3e-6)
    )  # corners are the least of each
    assert np.all(found[:, 2] <= 0.014 * (1.0 + 1e-6))


def test_what_is_told_is_that_of_the_designs(front):
    car = jn.load("audi-a6-quarter-car")
    changes = {path: float(values[3]) for path, values in front.numbers.items()}
    there = jn.stationary(car.with_changes(changes), "C", "20 m/s", band="iso")
    assert there.standard_deviation["sprung.az"] == pytest.approx(
        front.goals["rough: sprung.az"][3], rel=1e-6
    )
    assert front.present["rough: sprung.az"] == pytest.approx(
        jn.stationary(car, "C", "20 m/s", band="iso").standard_deviation["sprung.az"]
    )
    assert front.start["strut.spring.rate"] == car.strut.spring.rate
    assert str(front).count("\n") > front.count
    assert json.loads(json.dumps(front.to_dict()))["goals"].keys() == set(GOALS)


def test_mixtures_are_spread_evenly_and_sum_up():
    found = np.array(list(mixtures(3, 12)))
    assert len(found) + 3 >= 12  # with the corners
    assert found.sum(axis=1) == pytest.approx(1.0, abs=1e-12)
    assert found.min() > 0.1  # a goal without room is that of a corner
    assert len(np.unique(found, axis=0)) == len(found)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('"rough: tyre.force", "rough: strut.deflection"]', "]", "front"),
        ('"rough: tyre.force"', '"rough: sprung.az"', "different metrics"),
        (
            "points = 4",
            'points = 4\nshown = "rough: unsprung.az"',
            "applies only to fronts of two metrics",
        ),
        ('"rough: tyre.force"', '"rough: tyre.forze"', "tyre.force"),
    ],
)
def test_what_is_no_front_is_refused(old, new, words, tmp_path):
    file = tmp_path / "study.toml"
    file.write_text(STUDY.replace(old, new), encoding="utf-8")
    with pytest.raises(DescriptionError, match=words) as error:
        jn.run_optimisation(file)
    assert "study.toml" in str(error.value)
