"""Test sheets before measuring."""

from __future__ import annotations

from pathlib import Path

import pytest

import jounce as jn
from jounce.campaign.test_sheet import TestSheet
from jounce.core.errors import DescriptionError
from jounce.report.laboratory import sheet_page

SETTINGS = """schema = "jounce.laboratory/1"
sprung_mass = "16 kg"
unsprung_mass = "5 kg"
obstacle = {height = "10 mm", length = "60 mm"}
trials = "table.csv"
belt = {length = "1.97 m"}
"""
TABLE = """trial,speed [m/s],angle [deg],pressure [MPa],profile
1,1.95,26,0.31,A
2,2.86,,0.25,
3,3.79,16,0.31,
4,1.97,26,,B 0.10
"""


def settings(folder: Path, text: str = SETTINGS) -> Path:
    (folder / "table.csv").write_text(TABLE, encoding="utf-8")
    file = folder / "settings.toml"
    file.write_text(text, encoding="utf-8")
    return file


@pytest.fixture(scope="module")
def sheet(tmp_path_factory: pytest.TempPathFactory) -> TestSheet:
    return jn.plan_test(settings(tmp_path_factory.mktemp("lab")))


def test_trials_are_ordered_by_what_is_set_up(sheet: TestSheet) -> None:
    assert [trial.number for trial in sheet.trials] == [1, 4, 3, 2]
    assert sheet.masses == (16.0, 5.0)
    assert sheet.frequencies == pytest.approx((4.99, 28.1), rel=0.01)


def test_peaks_are_those_of_a_run(sheet: TestSheet, tmp_path: Path) -> None:
    first = next(trial for trial in sheet.trials if trial.number == 1)
    rig = jn.load("kart-quarter-car").with_changes(
        {
            "strut.spring.rate": "22 N/mm",
            "tyre.stiffness": "138 N/mm",
            "strut.damper.coefficient": "150 N*s/m",
        }
    )
    road = jn.HalfSine(height="10 mm", length="60 mm", start="0.1 m", recurrence="1.97 m")
    run = jn.simulate(rig, jn.Trial(road=road, speed="1.95 m/s", duration="1 s"), start="periodic")
    assert first.peaks["unsprung.az"] == pytest.approx(
        float(abs(run["unsprung.az"]).max()), rel=0.05
    )
    assert first.returns == pytest.approx(1.97 / 1.95)


def test_a_train_teaches_more_than_one_obstacle(sheet: TestSheet) -> None:
    taught = {trial.number: trial.teaches for trial in sheet.trials}
    assert (
        set(taught[1])
        == set(taught[4])
        >= {"strut.spring.rate", "tyre.stiffness", "guide.friction.force"}
    )
    assert all(taught[4][path] < taught[1][path] for path in taught[1])


def test_students_get_forms(tmp_path: Path) -> None:
    file = settings(tmp_path)
    plain, forms = (sheet_page(jn.plan_test(file, students=students)) for students in (False, True))
    assert [section.title for section in plain.sections] == ["Settings", "Trials", "To note"]
    assert [section.title for section in forms.sections][3:] == ["Predict", "Measure", "Compare"]


def test_settings_without_a_table_are_refused(tmp_path: Path) -> None:
    file = settings(tmp_path, SETTINGS.replace('trials = "table.csv"\n', ""))
    with pytest.raises(DescriptionError, match="name no table of trials"):
        jn.plan_test(file)
