"""What three tests say of the same car: known biases of each are found."""

from __future__ import annotations

import pickle
from typing import ClassVar, Self

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.core.errors import JounceError
from jounce.inspection import equivalence
from jounce.inspection.equivalence import METHODS, Equivalence, compare_tests, usual_factors
from jounce.inspection.simulated import _end_finding, sweep_wear
from jounce.parts.testers import load_tester

CAR = jn.load("audi-a6-quarter-car").with_changes(
    {"tyre.damping_coefficient": 100.0, "sprung.mass": 400.0}
)


@pytest.fixture(scope="module")
def study() -> Equivalence:
    return compare_tests(CAR, wear=[0.0, 0.4, 0.8], factors=usual_factors(3))


def test_adhesion_rejects_light_cars_that_are_sound(study: Equivalence) -> None:
    found = {(one.factor, one.method): one for one in study.disagreements}
    assert found["load", "eusama"].rejected_sound == 1
    assert found["load", "eusama"].rejected_at == (0.5, 0.5)
    assert found["load", "egea"].rejected_sound == found["load", "theta"].rejected_sound == 0


def test_friction_and_soft_tyres_hide_wear_from_the_phase_angle(study: Equivalence) -> None:
    phase = study.planes["friction"]["phase_angle_min_deg"].sel(wear=0.8).to_numpy()
    assert np.all(np.diff(phase) > 0.0)
    theta = study.planes["friction"]["theta_road"].sel(wear=0.8).to_numpy()
    np.testing.assert_allclose(theta, theta[0], rtol=1e-9)


def test_every_quantity_falls_with_wear(study: Equivalence) -> None:
    for plane in study.planes.values():
        for quantity in METHODS.values():
            assert np.all(np.diff(plane[quantity].to_numpy(), axis=0) < 1e-9)


def test_plain_values_and_picture(study: Equivalence) -> None:
    from jounce.plots.inspection import equivalence

    plain = study.to_dict()
    assert plain["tests"] == 27
    assert len(plain["planes"]["load"]["adhesion"]) == 3
    figure = equivalence(study)
    assert [axes.get_xlabel() for axes in figure.axes] == [factor.label for factor in study.factors]
    dotted = any(
        np.isnan(study.rejecting_wear(factor.name, method)).any()
        for factor in study.factors
        for method in METHODS
    )
    texts = [text.get_text() for text in figure.legends[0].get_texts()]
    assert (texts[-1] == "dots at the top: never rejected") == dotted


def test_wear_from_which_a_method_rejects(study: Equivalence) -> None:
    wear = study.rejecting_wear("load", "eusama")
    verdicts = study.planes["load"]["eusama_verdict"]
    assert wear[0] == 0.0  # the light car, sound as it is
    for load, first in zip(verdicts["load"].to_numpy(), wear, strict=True):
        failing = verdicts["wear"].to_numpy()[verdicts.sel(load=load).to_numpy() == "fail"]
        assert 0.0 <= failing.min() - first < 0.4 if failing.size else np.isnan(first)


def test_a_boundary_lies_where_the_value_meets_the_limit(study: Equivalence) -> None:
    assert study.edges == {"eusama": 0.4, "egea": 35.0, "theta": 0.1}
    assert study.to_dict()["rejected_below"] == study.edges
    values = study.planes["tyre_stiffness"]["phase_angle_min_deg"].to_numpy()
    first = study.rejecting_wear("tyre_stiffness", "egea")
    for column, wear in zip(values.T, first, strict=True):
        assert wear not in (0.0, 0.4, 0.8)
        assert np.interp(wear, [0.0, 0.4, 0.8], column) == pytest.approx(35.0, abs=1e-9)


def test_other_rigs_are_refused() -> None:
    with pytest.raises(JounceError, match="quarter cars"):
        compare_tests(jn.load("audi-a6-half-car"))  # type: ignore[arg-type]


class Pool:
    """In place of processes: keeps how many there would be, and sends what it is given through pickle as they do."""

    started: ClassVar[list[int]] = []

    def __init__(self, workers: int, **_: object) -> None:
        self.started.append(workers)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        pass

    def map(self, function, things):
        function, things = pickle.loads(pickle.dumps((function, list(things))))
        return [pickle.loads(pickle.dumps(function(thing))) for thing in things]


@pytest.mark.parametrize(("tests", "started"), [(9, []), (4, [2]), (3, [3]), (1, [3])])
def test_processes_are_started_where_they_save_time(
    study: Equivalence, monkeypatch, tests: int, started: list[int]
):
    """9 tests in three columns, for at most three processes."""
    monkeypatch.setattr(equivalence, "_TESTS_OF_A_PROCESS", tests)
    monkeypatch.setattr(equivalence, "ProcessPoolExecutor", Pool)
    monkeypatch.setattr(Pool, "started", [])
    found = compare_tests(CAR, wear=[0.0, 0.4, 0.8], factors=usual_factors(3)[:1], workers=3)
    assert Pool.started == started
    name = found.factors[0].name
    assert found.planes[name].identical(study.planes[name])


@pytest.mark.slow
def test_real_processes_give_the_same(study: Equivalence, monkeypatch):
    """Seconds for two interpreters; tests of a store's evaluation anew have such processes, too."""
    monkeypatch.setattr(equivalence, "_TESTS_OF_A_PROCESS", 1)
    found = compare_tests(CAR, wear=[0.0, 0.4, 0.8], factors=usual_factors(3), workers=2)
    assert all(found.planes[name].identical(plane) for name, plane in study.planes.items())


def test_a_page_says_where_the_tests_disagree(study: Equivalence) -> None:
    from jounce.report import PageTable, equivalence_page

    page = equivalence_page(study, title="tests")
    (table,) = (block for block in page.blocks() if isinstance(block, PageTable))
    assert len(table.rows) == len(study.disagreements)
    for row, found in zip(table.rows, study.disagreements, strict=True):
        passed = row[4]
        assert not isinstance(passed, str)
        assert (passed.text, passed.tone) == (
            f"{found.passed_worn} of {found.worn}",
            "fair" if found.passed_worn else "plain",
        )
    assert [picture.name for picture in page.pictures()] == ["equivalence"]


def test_what_is_varied() -> None:
    tyre, mass, friction = usual_factors(3)
    assert tyre.values == (140e3, 220e3, 300e3)
    assert mass.values == (0.5, 1.0, 1.5)
    assert friction.values == (0.0, 100.0, 200.0)
    assert [one.scale for one in (tyre, mass, friction)] == [1e-3, 1.0, 1.0]
    assert mass.changes(CAR, 1.5) == {"sprung.mass": 600.0}
    assert friction.changes(CAR, 0.0) == {}


@pytest.mark.parametrize(
    ("fails", "values", "first"),
    [
        ([False, True, True], [0.6, 0.3, 0.2], 0.4 * 2.0 / 3.0),
        ([True, True, True], [0.3, 0.2, 0.1], 0.0),
        ([False, False, True], [0.6, 0.5, 0.4], 0.8),
        ([False, True, True], [0.3, 0.2, 0.1], 0.4),  # no crossing of the edge before it
        ([False, True, True], [0.5, 0.6, 0.1], 0.4),
        ([False, False, False], [0.6, 0.5, 0.45], float("nan")),
    ],
)
def test_between_two_wears(fails, values, first) -> None:
    found = equivalence._first_rejected(
        np.array([0.0, 0.4, 0.8]), np.array(fails), np.array(values), 0.4
    )
    assert found == pytest.approx(first, nan_ok=True)


def test_who_is_sound_and_who_is_worn() -> None:
    factor = usual_factors(3)[1]
    verdict = np.full((6, 3), "advise")
    verdict[:3, 0] = verdict[1, 2] = "fail"
    verdict[3:, 1] = verdict[5, 2] = "pass"
    table = {f"{method}_verdict": (("wear", "load"), verdict) for method in METHODS}
    plane = xr.Dataset(
        table, {"wear": [0.0, 0.2, 0.21, 0.69, 0.7, 1.0], "load": list(factor.values)}
    )
    for row in equivalence._disagreements(factor, plane):
        assert (row.sound, row.worn, row.rejected_sound, row.passed_worn) == (6, 6, 3, 3)
        assert (row.rejected_at, row.passed_at) == ((0.5, 1.5), (1.0, 1.5))


@pytest.mark.parametrize(
    ("text", "wears"),
    [
        ("0.5", [0.5]),
        ("0:1:0.3", [0.0, 0.3, 0.6, 0.9]),
        ("0.1:0.3:0.1", [0.1, 0.2, 0.3]),
        ("0:1:0", None),
        ("1:0:0.1", None),
        ("0.2:0.2:0.1", [0.2]),
        ("-0.1", None),
        ("1.01", None),
        ("0:1:0.00005", None),
        ("0:1", None),
        ("nan", None),
        ("much", None),
    ],
)
def test_ranges_of_wear(text, wears) -> None:
    if wears is None:
        with pytest.raises(JounceError, match="not a range of wear"):
            sweep_wear(text)
    else:
        assert sweep_wear(text) == wears


@pytest.mark.parametrize(
    ("hz", "told"), [(6.004, True), (6.006, False), (17.994, False), (17.996, True)]
)
def test_phase_angles_at_an_end_of_the_band(hz: float, told: bool) -> None:
    found = _end_finding(hz, load_tester("egea-specsus2018"), "left")
    assert [(one.code, one.words) for one in found] == (
        [("phase_at_end", {"frequency": hz})] if told else []
    )
