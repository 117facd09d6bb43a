"""``jounce clearances`` and ``jounce steering-effort`` through their entry point."""

from __future__ import annotations

import csv

import numpy as np
import pytest

import jounce as jn

RIG = "formula-student-front"
ROD = "tie_rod_inner-tie_rod_outer 8 mm"
RIM = "rim 115 mm from -90 mm to 20 mm"
ARM = "upper_arm_front-upper_ball_joint 8 mm"
MOVES = ("--travel", "-20 mm:20 mm:20 mm", "--rack", "-20 mm:20 mm:20 mm")
STEERED = ("--set", 'steering={rack_ratio = "13 mm/rad"}')


def test_clearances_are_those_of_python_in_table_file_json_and_picture(cli, tmp_path) -> None:
    between = ("--between", f"rod in rim: {ROD}, {RIM}", "--between", f"rod to arm: {ROD}, {ARM}")
    out, picture = tmp_path / "clearances.csv", tmp_path / "clearances.png"
    outcome = cli(
        "clearances", RIG, *between, *MOVES, "--out", str(out), "--figure", str(picture), "--json"
    )
    assert outcome.exit_code == 0, outcome.err
    rod = jn.Solid(points=["tie_rod_inner", "tie_rod_outer"], radius=0.008)
    arm = jn.Solid(points=["upper_arm_front", "upper_ball_joint"], radius=0.008)
    pairs = {
        "rod in rim": (rod, jn.Rim(radius=0.115, inner=-0.09, outer=0.02)),
        "rod to arm": (rod, arm),
    }
    wanted = jn.clearances(jn.load(RIG), pairs, "-20 mm:20 mm:20 mm", "-20 mm:20 mm:20 mm")
    for name in pairs:
        assert outcome.json["quantities"][name]["values"] == wanted[name].to_numpy().tolist()
        least = outcome.json["least"][name]
        assert least["clearance"] == float(wanted[name].min())
        where = {along: least[along] for along in ("wheel_travel", "rack_travel")}
        assert float(wanted[name].sel(where, method="nearest")) == least["clearance"]
    assert outcome.json["lengths"] == jn.link_lengths(jn.load(RIG))
    rows = list(csv.DictReader(out.read_text(encoding="utf-8").splitlines(), skipinitialspace=True))
    assert len(rows) == 9
    assert float(rows[-1]["rod in rim [m]"]) == float(wanted["rod in rim"][-1, -1])
    assert picture.stat().st_size > 10_000
    steered = cli("clearances", RIG, *between, "--rack", "-20 mm:20 mm:20 mm", "--json").json[
        "quantities"
    ]
    assert steered["rod to arm"]["values"] == pytest.approx(
        wanted["rod to arm"].sel(wheel_travel=0.0).to_numpy()
    )
    assert steered["wheel_travel"]["values"] == [0.0, 0.0, 0.0]


def test_bodies_that_overlap_are_a_finding_and_lengths_need_no_pair(cli) -> None:
    thick = ("--between", f"thick: {ROD.replace('8 mm', '200 mm')}, {ARM}")
    outcome = cli("clearances", RIG, *thick, "--json")
    assert outcome.exit_code == 0
    (finding,) = outcome.json["findings"]
    assert (finding["place"], finding["severity"]) == ("thick", "warning")
    assert outcome.json["least"]["thick"]["clearance"] == finding["value"] < 0.0
    alone = cli("clearances", "generic-mcpherson")
    assert alone.exit_code == 0
    assert "tie_rod_inner - tie_rod_outer" in alone.out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--between", ROD], "two different bodies are required"),
        (["--between", f"a: {ROD}"], "two different bodies are required"),
        (["--between", f"a: {ROD}, rim 115 mm"], "not a body"),
        (["--between", f"a: {ROD}, rim 115 mm from 20 mm to -90 mm"], "is not inboard"),
        (["--between", f"a: {RIM}, {RIM}"], "invalid pair of bodies"),
        (["--between", f"a: {ROD}, tie_rod_iner 5 mm"], "Did you mean 'tie_rod_inner'"),
        (["--between", f"a: {ROD}, tie_rod_inner 5"], "is implausible"),
        (["--between", f"a: {ROD}, tie_rod_inner -5 mm"], "radius"),
        (["--between", f"a: {ROD}, {RIM}", "--between", f"a: {ROD}, {ARM}"], "given twice"),
        (["--between", f"a: {ROD}, {RIM}", "--travel", "-20:20:2"], "Millimetres meant"),
        (["--travel", "10 mm"], "no distances are requested"),
        (["--between", f"a: {ROD}, {RIM}", "--out", "a.xlsx"], ".csv"),
        (["--between", f"a: {ROD}, {RIM}", "--figure", "a.xlsx"], ".png"),
    ],
)
def test_bad_pairs_are_refused(cli, arguments, message: str) -> None:
    outcome = cli("clearances", RIG, *arguments)
    assert outcome.exit_code == 2
    assert message in outcome.err


def test_efforts_are_those_of_python(cli, tmp_path) -> None:
    loads = (
        "--load",
        "vertical_force=700 N",
        "--left",
        "lateral_force=400 N",
        "--right",
        "lateral_force=900 N",
    )
    out, picture = tmp_path / "effort.csv", tmp_path / "effort.svg"
    swept = (
        "--rack",
        "-20 mm:20 mm:20 mm",
        *STEERED,
        "--out",
        str(out),
        "--figure",
        str(picture),
        "--json",
    )
    outcome = cli("steering-effort", RIG, *loads, *swept)
    assert outcome.exit_code == 0, outcome.err
    rig = jn.load(RIG).with_changes({"steering": {"rack_ratio": 0.013}})
    sides = [jn.ContactLoad(vertical_force=700.0, lateral_force=force) for force in (400.0, 900.0)]
    wanted = jn.steering_effort(rig, *sides, "-20 mm:20 mm:20 mm")
    for name in ("rack_force", "left.rack_force", "handwheel_torque", "handwheel_angle"):
        assert outcome.json[name]["values"] == pytest.approx(
            wanted[name].to_numpy().tolist(), rel=1e-12
        ), name
    assert out.read_text(encoding="utf-8").startswith("rack_travel [m],rack_force [N]")
    assert picture.stat().st_size > 10_000


def test_a_rack_beyond_the_end_of_travel_is_told(cli) -> None:
    outcome = cli(
        "steering-effort",
        RIG,
        "--load",
        "lateral_force=400 N",
        "--rack",
        "0 mm:150 mm:10 mm",
        "--json",
    )
    assert outcome.exit_code == 2
    assert "reaches the end of its travel" in outcome.err
    assert 0 < len(outcome.json["rack_force"]["values"]) < 16
    assert np.isfinite(outcome.json["rack_force"]["values"]).all()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "no load from the road is given"),
        (["--left", "lateral_force=1 kN"], "no load from the road is given"),
        (["--load", "sideways=1 kN"], "sideways"),
        (["--load", "lateral_force=1 kN", "--rack", "-20:20:2"], "Millimetres meant"),
        (["--load", "lateral_force=1 mm"], "wrong unit"),
    ],
)
def test_bad_loads_are_refused(cli, arguments, message: str) -> None:
    outcome = cli("steering-effort", RIG, *arguments)
    assert outcome.exit_code == 2
    assert message in outcome.err


def test_a_corner_without_rack_is_not_steered(cli) -> None:
    outcome = cli("steering-effort", "semi-trailing-arm", "--load", "lateral_force=1 kN")
    assert outcome.exit_code == 2
    assert "this wheel has no steering rack" in outcome.err
