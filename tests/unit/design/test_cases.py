"""Designs judged by several cases and over a spread: slopes, brute force, constraints, fronts, and what is refused."""

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError, FitError
from jounce.design.cases import cases_problem

DAMPER = "strut.damper.coefficient"
ROUGH = {"road": "C", "speed": "20 m/s"}
SPREAD = {"sprung.mass": ["350 kg", "550 kg"], DAMPER: "15 %"}


@pytest.fixture(scope="module")
def car():
    return jn.load("audi-a6-quarter-car")


def kerb():
    return jn.Trial(
        road=jn.HalfSine(height="15 mm", length="0.5 m"), speed="5 m/s", duration="0.8 s"
    )


def test_slopes_of_all_cases_and_statistics_are_those_of_differences(car):
    cases = {"rough": ROUGH, "kerb": kerb()}
    objective = {"rough: p95 sprung.az": 1.0, "kerb: sprung.az": 0.5}
    free = {DAMPER: "40 %", "strut.spring.rate": "20 %"}
    problem = cases_problem(car, free, objective, cases=cases, spread=SPREAD, samples=8)
    at = problem.start * [1.1, 0.95]
    _, slopes = problem.objective(at)
    for i in range(2):
        step = 1e-4 * at[i] * np.eye(2)[i]
        difference = (problem.objective(at + step)[0] - problem.objective(at - step)[0]) / (
            2e-4 * at[i]
        )
        assert slopes[i] == pytest.approx(difference, rel=2e-3)
    assert "8 samples of sprung.mass" in problem.driven


@pytest.mark.parametrize("statistic", ["", "p95 "])
def test_a_robust_optimum_is_that_of_brute_force(car, statistic):
    metric = f"{statistic}tyre.force"
    given = {"road": "C", "speed": "20 m/s", "spread": SPREAD, "samples": 8}
    best = jn.optimise(car, {DAMPER: (500.0, 6000.0)}, metric, **given)
    problem = cases_problem(
        car, {DAMPER: (500.0, 6000.0)}, metric, cases={"all": ROUGH}, spread=SPREAD, samples=8
    )
    grid = np.linspace(500.0, 6000.0, 23)
    values = [problem.whole(metric, np.array([c]))[0] for c in grid]
    near = grid[int(np.argmin(values))]
    fine = np.linspace(near - 250.0, near + 250.0, 26)
    values = [problem.whole(metric, np.array([c]))[0] for c in fine]
    assert best.values[DAMPER] == pytest.approx(
        fine[int(np.argmin(values))], abs=2.0 * (fine[1] - fine[0])
    )
    assert best.after[metric] <= min(values)
    # the samples are those that a user can draw
    columns = jn.sobol(SPREAD, 8, seed=1).values(
        lambda path: (car.parameters()[path], "kg" if "mass" in path else "")
    )
    alone = []
    for mass, c in zip(columns["sprung.mass"], columns[DAMPER], strict=True):
        built = car.with_changes(
            {"sprung.mass": mass, DAMPER: best.values[DAMPER] * c / car.parameters()[DAMPER]}
        )
        alone.append(
            jn.stationary(built, "C", "20 m/s", band="iso").standard_deviation["tyre.force"]
        )
    expected = np.percentile(alone, 95) if statistic else np.mean(alone)
    assert best.after[metric] == pytest.approx(expected, rel=1e-6)


def test_a_limit_over_a_spread_holds_and_costs(car):
    free = {DAMPER: (300.0, 6000.0)}
    given = {"cases": {"rough": ROUGH}, "spread": SPREAD, "samples": 8}
    loose = jn.optimise(car, free, "rough: sprung.az", **given)
    most = 0.97 * loose.after["rough: sprung.az"] / loose.before["rough: sprung.az"]
    assert 0.0 < most < 1.0
    tight = jn.optimise(
        car, free, "rough: sprung.az", {"rough: p95 strut.deflection": "18 mm"}, **given
    )
    limit = tight.constraints[0]
    assert limit.value <= 0.018 * (1.0 + 1e-6)
    assert tight.value >= loose.value


@pytest.mark.slow
def test_kinematics_and_ride_are_designed_at_once():
    corner = jn.load("kart-double-wishbone")
    height = corner.parameters()["hardpoints.tie_rod_inner[2]"]
    free = {"hardpoints.tie_rod_inner[2]": (height - 0.01, height + 0.01), DAMPER: "40 %"}
    trial = jn.Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm", start="0.1 m"),
        speed="2 m/s",
        duration="0.4 s",
    )
    cases = {"kerb": trial, "corner": {"travel": ["-10 mm", "10 mm"]}}
    before = cases_problem(corner, free, "corner: range toe", cases=cases, more=["kerb: sprung.az"])
    best = jn.optimise(
        corner, free, {"corner: range toe": 1.0, "kerb: sprung.az": 1.0}, cases=cases
    )
    assert (
        best.after["corner: range toe"] < 0.7 * before.whole("corner: range toe", before.start)[0]
    )
    assert best.after["kerb: sprung.az"] <= best.before["kerb: sprung.az"]
    assert best.derivatives == "differences"


def test_a_front_over_a_spread(car):
    front = jn.pareto(
        car, {DAMPER: (300.0, 6000.0)}, "C", "20 m/s", points=3, spread=SPREAD, samples=4,
        comfort="p95 sprung.az", holding="p95 tyre.force", travel="strut.deflection",
    )  # fmt: skip
    assert np.all(np.diff(front.comfort) > 0.0)
    assert np.all(np.diff(front.holding) < 0.0)
    assert [(mark.name, mark.values) for mark in front.marks] == [
        ("as it is", {DAMPER: car.parameters()[DAMPER]})
    ]


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"cases": {}}, "no case"),
        ({"cases": {"rough": ROUGH, "other": ROUGH}}, "no metric uses this case"),
        ({"cases": {"rough": {"road": "C", "sped": 3.0}}}, "unknown key"),
        ({"cases": {"rough": {"travel": [-0.01, 0.01]}}}, "quantity"),
        ({"objective": "smooth: sprung.az"}, "unknown case"),
        ({"objective": "rough: p95 sprung.az", "spread": None}, "percentile needs a spread"),
        ({"samples": 1}, "invalid number of samples"),
        ({"spread": {"sprung.mas": "5 %"}}, "unknown parameter"),
        (
            {"spread": {"sprung.mass": ["-1 kg", "500 kg"]}},
            "exceeds the allowed range, from -1 to 500 kg",
        ),
        ({"road": "C"}, "cases have their own roads"),
        ({"objective": "rough: sprung.ax"}, "unknown metric"),
    ],
)
def test_what_is_refused(car, change, words):
    given = {
        "cases": {"rough": ROUGH},
        "spread": {"sprung.mass": "5 %"},
        "objective": "rough: sprung.az",
        **change,
    }
    with pytest.raises((DescriptionError, FitError), match=words):
        jn.optimise(car, {DAMPER: "40 %"}, given.pop("objective"), **given)


STUDY = """
schema = "jounce.optimisation/1"
rig = "audi-a6-quarter-car"
free = {"strut.damper.coefficient" = ["300 N*s/m", "6000 N*s/m"]}
objective = {"rough: sprung.az" = 1.0, "kerb: sprung.az" = 1.0}
constraints = {"rough: p95 strut.deflection" = "30 mm"}
spread = {"sprung.mass" = "10 %"}
samples = 4

[cases.rough]
road = "C"
speed = "20 m/s"

[cases.kerb]
road = {kind = "half-sine", height = "15 mm", length = "0.5 m"}
speed = "5 m/s"
duration = "0.6 s"
"""


def test_a_study_file_gives_what_the_call_gives(tmp_path, car):
    file = tmp_path / "study.toml"
    file.write_text(STUDY, encoding="utf-8")
    found = jn.run_optimisation(file)
    trial = jn.Trial(
        road=jn.HalfSine(height="15 mm", length="0.5 m"), speed="5 m/s", duration="0.6 s"
    )
    called = jn.optimise(
        car, {DAMPER: (300.0, 6000.0)}, {"rough: sprung.az": 1.0, "kerb: sprung.az": 1.0},
        {"rough: p95 strut.deflection": "30 mm"}, cases={"rough": ROUGH, "kerb": trial},
        spread={"sprung.mass": "10 %"}, samples=4,
    )  # fmt: skip
    assert found.values == called.values
    assert found.converged


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            "objective = {",
            "front = ['rough: sprung.az', 'kerb: sprung.az']\nobjective = {",
            "either objective",
        ),
        ('speed = "20 m/s"', 'sped = "20 m/s"', "cases.rough"),
        ("samples = 4", "samples = 1", "samples"),
        ('"30 mm"', '"30 kg"', "line 6"),
        ("[cases.kerb]", "[cases.curb]", "line 5: objective: kerb: sprung.az"),
        ('kind = "half-sine"', 'kind = "half-sin"', "half-sin"),
    ],
)
def test_what_is_wrong_with_a_study_is_said_with_its_place(tmp_path, old, new, words):
    file = tmp_path / "study.toml"
    assert old in STUDY
    file.write_text(STUDY.replace(old, new), encoding="utf-8")
    with pytest.raises(DescriptionError, match=words):
        jn.run_optimisation(file)
