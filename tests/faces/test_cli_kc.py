"""``jounce kc`` through its entry point: overview, files, measured sheets, failures, bad input."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import openpyxl
import pytest
import xarray as xr

import jounce as jn
from jounce.kc.tests import TESTS

RIG = "double-wishbone-elastic"


def test_the_sheet_is_written_in_all_forms(cli, tmp_path) -> None:
    out = tmp_path / "sheet"
    outcome = cli("kc", RIG, "--out", str(out), "--within", "bounce=20 mm", "--json")
    assert outcome.exit_code == 0, outcome.err
    assert outcome.json["tests"] == list(TESTS)
    files = {str(file.relative_to(out)) for file in out.rglob("*") if file.is_file()}
    assert {
        "overview.csv",
        "kc.nc",
        "kc.xlsx",
        "report.html",
        "report.pdf",
        "tests/roll.csv",
    } <= files
    rows = list(csv.DictReader((out / "overview.csv").read_text(encoding="utf-8").splitlines()))
    bounce = jn.kc_test(jn.load(RIG), "bounce")
    fit = jn.kc_slopes(bounce, within="20 mm").set_index(quantity="quantity")["slope"]
    want = float(fit.sel(quantity="left.camber"))
    assert float(rows[2]["left [SI]"]) == pytest.approx(want, rel=1e-9)
    assert rows[2]["unit"] == "deg/m"
    assert float(rows[2]["left"]) == pytest.approx(np.degrees(want), rel=1e-9)
    stored = xr.open_dataset(out / "kc.nc", engine="h5netcdf").sel(test="bounce")
    assert stored["left.camber"].values == pytest.approx(bounce["left.camber"].values, rel=1e-9)
    book = openpyxl.load_workbook(out / "kc.xlsx", read_only=True)
    assert book.sheetnames == ["overview", *TESTS]
    page = (out / "report.html").read_text(encoding="utf-8")
    for name in ("Overview", "Bounce", "Lateral, in phase", "Aligning, opposed", "Conditions"):
        assert f">{name}</a>" in page
    assert page.index("Characteristics") < page.index('id="bounce"')


def test_the_terminal_shows_the_overview(cli) -> None:
    outcome = cli("kc", RIG, "--test", "bounce", "--test", "lateral-opposed")
    assert outcome.exit_code == 0, outcome.err
    assert "ride steer (bump toe)" in outcome.out
    assert "deg/kN" in outcome.out
    assert "roll stiffness" not in outcome.out


def test_a_measured_sheet_is_judged(cli, tmp_path) -> None:
    own = tmp_path / "own"
    assert cli("kc", RIG, "--test", "bounce", "--out", str(own)).exit_code == 0
    kept = own / "tests" / "bounce.csv"
    same = cli("kc", RIG, "--test", "bounce", "--measured", str(kept), "--json")
    assert same.exit_code == 0, same.err
    assert {row["verdict"] for row in same.json["compared"]} <= {"within", "not judged"}
    softer = ("--set", 'strut.spring.rate="10 N/mm"', "--tolerance", "vertical_force=1 %")
    other = cli(
        "kc",
        RIG,
        *softer,
        "--test",
        "bounce",
        "--measured",
        str(kept),
        "--report",
        "b.html",
        "--json",
    )
    load = next(row for row in other.json["compared"] if row["quantity"] == "left.vertical_force")
    assert load["verdict"] == "outside"
    assert abs(load["leaves_at"]) < 0.02
    page = Path("b.html").read_text(encoding="utf-8")
    assert "Model and measurement" in page
    assert "left, measured" in page


def test_a_test_that_fails_does_not_lose_the_others(cli, tmp_path) -> None:
    out = tmp_path / "sheet"
    far = ("--to", "steer=2 m", "--test", "steer", "--test", "bounce", "--points", "5")
    outcome = cli("kc", RIG, *far, "--out", str(out), "--json")
    assert outcome.exit_code == 2
    assert outcome.json["tests"] == ["bounce"]
    assert [item["code"] for item in outcome.json["findings"]] == ["kc.test_failed"]
    assert "steer" in outcome.err
    assert (out / "tests" / "bounce.csv").is_file()


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (("kc", RIG, "--test", "bonce"), "bounce"),
        (("kc", RIG, "--to", "bounce=40 N"), "--to"),
        (("kc", RIG, "--within", "bounce=40 kg"), "within"),
        (("kc", RIG, "--held", "weight"), "load"),
        (("kc", RIG, "--points", "3"), "points"),
        (("kc", RIG, "--tolerance", "toe=1 deg"), "measured"),
        (("kc", "semi-trailing-arm", "--test", "steer"), "rack"),
        (("kc", "semi-trailing-arm", "--steer", "10 mm"), "rack"),
        (("kc", "kart-quarter-car"), "hardpoints"),
        (("kc", "sedan-full-car-3d"), "front, rear"),
        (("kc", RIG, "--measured", "nowhere.csv"), "nowhere.csv"),
    ],
)
def test_bad_input_is_one_message(cli, given, said) -> None:
    outcome = cli(*given)
    assert outcome.exit_code == 2
    assert said in outcome.err
    assert "internal error" not in outcome.err
    assert "Traceback" not in outcome.err
