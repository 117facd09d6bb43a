"""Texts that a spreadsheet would run as formulas: guarded in each table that is written, and read as they were."""

from __future__ import annotations

import csv

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.cli.options import write_numbers
from jounce.core.text import guard_formula, guard_row, unguard_formula
from jounce.inspection.archive.exporting import export

FORMULAS = ("=cmd|' /C calc'!A0", "+1+1", "-2+3", "@SUM(A1)", "\t=1", "\r=1", "'=1", "''=1")


@pytest.mark.parametrize("text", [*FORMULAS, "front", "'quoted", "", "'", "a=b"])
def test_the_guard_comes_off_again(text: str) -> None:
    assert unguard_formula(guard_formula(text)) == text
    assert (guard_formula(text) == text) == (text not in FORMULAS)
    assert guard_row([text, -1.5, None]) == [guard_formula(text).replace("\r", "\n"), -1.5, None]


def test_a_channel_that_looks_like_a_formula(tmp_path) -> None:
    run = xr.Dataset(
        {"=1+1.sprung.az": ("time", np.arange(9.0), {"units": "m/s^2"})},
        {"time": ("time", np.arange(9) * 0.01, {"units": "s"})},
    )
    file = jn.write_recording(run, tmp_path / "a.csv")
    assert file.read_text().startswith("time [s],'=1+1.sprung.az [m/s^2]\n0.0,0.0\n")
    again, _ = jn.read_recording(file)
    np.testing.assert_array_equal(again["=1+1.sprung.az"], run["=1+1.sprung.az"])


@pytest.mark.parametrize("text", FORMULAS)
def test_rows_of_a_store_and_of_numbers(tmp_path, text: str) -> None:
    kept = export(
        [{"number": 1, "name": text, "plate": text, "adhesion": -0.5}], tmp_path / "lane.csv"
    )
    write_numbers({}, [{"name": text, "value": -0.5}], tmp_path / "numbers.csv", force=False)
    for file in (kept, tmp_path / "numbers.csv"):
        with file.open(newline="") as stream:
            rows = [*csv.reader(stream)]
        assert guard_row([text])[0] in rows[1]
        assert text not in rows[1]
        assert "-0.5" in rows[1]


def test_a_case_that_looks_like_a_formula(tmp_path) -> None:
    car = jn.LoadedAxle(
        axle="front",
        mass=280.0,
        wheelbase=1.55,
        centre_of_mass_height=0.3,
        weight_share=0.48,
        brake_share=0.65,
    )
    case = jn.LoadCase(longitudinal=-1.0)
    found = jn.load_cases(jn.load("formula-student-front"), car, {"=1+1": case})
    assert jn.load_case_table(found).splitlines()[1].startswith('"\'=1+1",left,')
