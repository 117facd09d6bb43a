"""Numbers without a unit in a form: they take that of their file, and say so."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import jounce as jn
from jounce.core.usual_units import usual_unit

RIG = "kart-double-wishbone.toml"
SI = {"hardpoints": {"a": [0.1, 0.2, 0.3]}, "strut": {"spring": {"rate": 22730.0}}}


@pytest.mark.parametrize(
    ("keys", "number", "si", "unit"),
    [
        (["hardpoints", "a", 1], 150.0, "m", "mm"),
        (["hardpoints", "a", 1], 0.15, "m", ""),
        (["strut", "spring", "rate"], 22.0, "N/m", "N/mm"),
        (["strut", "spring", "rate"], 22000.0, "N/m", ""),
        (["new", "value"], 2.0, "rad", "deg"),
        (["new", "value"], 2.0, "1", ""),
    ],
)
def test_a_file_in_si_keeps_plausible_numbers(
    keys: list, number: float, si: str, unit: str
) -> None:
    assert usual_unit(SI, keys, number, si) == unit


def test_neighbours_come_before_the_rest_of_the_file() -> None:
    values = {"a": {"x": "1 cm", "y": "?"}, "b": {"x": "1 mm", "y": "2 mm", "z": "3 mm"}}
    assert usual_unit(values, ["a", "y"], 5.0, "m") == "cm"
    assert usual_unit(values, ["c", "y"], 5.0, "m") == "mm"


@pytest.fixture
def project(tmp_path: Path):
    from jounce.web.project import Project

    shutil.copy(Path(jn.__file__).parent / "parts" / "library" / RIG, tmp_path / RIG)
    return Project(tmp_path)


@pytest.mark.parametrize(
    ("keys", "value", "written", "note"),
    [
        (["hardpoints", "lower_ball_joint", 1], 150, "150 mm", "150 is read as 150 mm"),
        (["hardpoints", "lower_ball_joint", 1], "15 cm", "15 cm", ""),
        (["hardpoints", "lower_ball_joint", 1], 0, 0, ""),
        (["wheel", "camber"], -1.5, "-1.5 deg", "-1.5 is read as -1.5 deg"),
        (["strut", "spring", "rate"], 25, "25 N/mm", "25 is read as 25 N/mm"),
    ],
)
def test_a_form_reads_a_bare_number_in_the_unit_of_its_file(
    project, keys, value, written, note
) -> None:
    from jounce.web.forms import form_of

    form = form_of(project, RIG, project.read(RIG).text, [(keys, value)])
    now = form.values
    for key in keys:
        now = now[key]
    assert now == written
    assert [item.text.startswith(note) for item in form.notes] == ([True] if note else [])
    assert all(item.german and "wird als" in item.german for item in form.notes)
