"""``jounce inspect simulate``: one wheel object, wear, records that are evaluated blind, and what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest

from jounce.inspection import evaluate, read_record
from jounce.parts.testers import library, load_tester

CAR = """schema = "jounce.rig/1"
model = "quarter-car"
sprung = {mass = "400 kg"}
unsprung = {mass = "40 kg"}
strut = {spring = {rate = "25 N/mm"}, damper = {coefficient = "1000 N*s/m"}}
tyre = {stiffness = "200 N/mm"}
"""
WHEEL = {
    "adhesion", "phase_angle_min_deg", "phase_frequency_hz", "relative_force_amplitude", "tyre_rigidity", "theta_rig",
    "theta_road", "lift_off", "uncertainty", "grade", "verdict", "reasons", "findings",
}  # fmt: skip


@pytest.fixture
def car(tmp_path: Path) -> str:
    (tmp_path / "car.toml").write_text(CAR, encoding="utf-8")
    return "car.toml"


def test_steady_states_of_the_reference_car(cli, car) -> None:
    found = cli("inspect", "simulate", car, "--method", "eusama", "--steady", "--json").json
    assert found.keys() >= WHEEL
    assert 100.0 * found["adhesion"] == pytest.approx(60.25, abs=0.05)
    assert found["phase_angle_min_deg"] == pytest.approx(57.27, abs=0.05)
    assert found["phase_frequency_hz"] == pytest.approx(7.76, abs=0.011)
    assert found["theta_road"] == pytest.approx(0.1708, rel=0.01)
    assert found["tyre_rigidity"] == pytest.approx(189.0e3, abs=200.0)
    assert found["relative_force_amplitude"] == pytest.approx(1.0 - found["adhesion"], abs=1e-12)
    assert (found["lift_off"], found["verdict"]) == (False, "pass")


def test_set_changes_rig_and_tester(cli, car) -> None:
    found = cli(
        "inspect", "simulate", car, "--method", "eusama", "--steady", "--set", "strut.damper.coefficient=500",
        "--set", "tester.stroke=4 mm", "--json",
    ).json  # fmt: skip
    assert 1.0 - found["adhesion"] == pytest.approx((1.0 - 0.2569) * 4.0 / 6.0, abs=1e-4)
    again = cli(
        "inspect", "simulate", car, "--method", "eusama", "--steady", "--set", "strut.damper.coefficient=500",
        "--stroke", "4 mm", "--json",
    ).json  # fmt: skip
    assert again["adhesion"] == found["adhesion"]


def test_run_down_is_evaluated_like_a_record(cli, car, tmp_path: Path) -> None:
    said = ("inspect", "simulate", car, "--method", "egea", "--noise", "1 %", "--seed", "3")
    found = cli(*said, "--out", "lane.csv", "--json").json
    assert 100.0 * found["adhesion"] == pytest.approx(61.15, abs=1.0)
    assert found["phase_angle_min_deg"] == pytest.approx(54.66, abs=2.0)
    assert found["theta_road"] == pytest.approx(found["truth"]["theta_road"], abs=0.01)
    assert found["uncertainty"]["adhesion"] > 0.0
    record, _ = read_record(tmp_path / "lane.csv")
    assert set(record.data_vars) == {"left.plate.z", "left.plate.force"}
    assert record.attrs["vehicle"] == "car"
    blind = evaluate(record, load_tester("egea-specsus2018")).wheel("left")
    assert blind.adhesion == pytest.approx(found["adhesion"], abs=1e-6)
    assert cli(*said, "--out", "lane.csv").exit_code == 2  # it is there already
    assert cli(*said, "--out", "lane.csv", "--force").exit_code == 0


def test_wear_is_a_table(cli, car) -> None:
    said = ("inspect", "simulate", car, "--method", "egea", "--steady", "--wear", "0:0.8:0.4")
    found = cli(*said, "--json").json
    assert [wheel["wear"] for wheel in found["wheels"]] == [0.0, 0.4, 0.8]
    phases = [wheel["phase_angle_min_deg"] for wheel in found["wheels"]]
    assert phases == sorted(phases, reverse=True)
    assert [wheel["verdict"] for wheel in found["wheels"]] == ["pass", "pass", "fail"]
    assert "wear" in cli(*said).out
    one = cli(
        "inspect", "simulate", car, "--method", "egea", "--steady", "--wear", "0.5", "--json"
    ).json
    assert one["phase_angle_min_deg"] == pytest.approx(31.16, abs=0.05)


def test_axles_corners_and_the_sprung_plate(cli) -> None:
    axle = cli(
        "inspect",
        "simulate",
        "audi-a6-full-car",
        "--method",
        "eusama",
        "--axle",
        "rear",
        "--wheel",
        "right",
        "--json",
    )
    assert (axle.exit_code, axle.json["wheel"]) == (0, "right")
    assert 0.5 < axle.json["adhesion"] < 0.9
    sprung = cli("inspect", "simulate", "audi-a6-quarter-car", "--method", "theta", "--json").json
    assert sprung["adhesion"] is None
    assert sprung["theta_road"] == pytest.approx(sprung["truth"]["theta_road"], abs=0.01)
    corner = cli(
        "inspect", "simulate", "reference-double-wishbone", "--method", "eusama", "--json"
    ).json
    assert corner["adhesion"] == pytest.approx(0.72, abs=0.02)


def test_a_load_out_of_range_is_a_finding(cli, car) -> None:
    found = cli(
        "inspect", "simulate", car, "--method", "egea", "--steady", "--set", "sprung.mass=1200", "--json"
    ).json  # fmt: skip
    assert any("static wheel load" in finding["message"] for finding in found["findings"])


def test_people_read_values_and_the_verdict(cli, car) -> None:
    text = cli("inspect", "simulate", car, "--method", "eusama").out
    assert "adhesion" in text
    assert "verdict: pass" in text


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("car.toml",), "no method is given"),
        (("car.toml", "--method", "eusamma"), "Did you mean 'eusama'"),
        (("car.toml", "--tester", "egea"), "no tester of that name"),
        (("car.toml", "--method", "egea", "--stroke=-6 mm"), "above 0"),
        (("car.toml", "--method", "egea", "--stroke", "6 kg"), "wrong unit"),
        (("car.toml", "--method", "egea", "--stroke", "6 mm", "--wheel", "middle"), "left, right"),
        (("car.toml", "--method", "egea", "--wear", "0:2:0.5"), "within 0 to 1"),
        (("car.toml", "--method", "egea", "--wear", "new"), "within 0 to 1"),
        (("car.toml", "--method", "egea", "--noise=-1"), "noise"),
        (("car.toml", "--method", "egea", "--steady", "--out", "x.csv"), "no record"),
        (("car.toml", "--method", "egea", "--out", "x.xls"), ".nc, .csv"),
        (("car.toml", "--method", "egea", "--set", "tester.strok=6 mm"), "stroke"),
        (("audi-a6-half-car", "--method", "egea"), "no tyres"),
        (("formula-student-car", "--method", "egea"), "one of its corners"),
    ],
)
def test_refused_with_one_message(cli, car, words, says) -> None:
    outcome = cli("inspect", "simulate", *words)
    assert outcome.exit_code == 2
    assert says in outcome.err
    assert "Traceback" not in outcome.err


def test_every_shipped_tester_runs(cli, car) -> None:
    for name in library():
        assert cli("inspect", "simulate", car, "--tester", name, "--json").exit_code == 0


def test_both_wheels_of_an_axle_make_a_record_of_an_axle(cli, tmp_path: Path) -> None:
    said = (
        "inspect",
        "simulate",
        "audi-a6-full-car",
        "--method",
        "egea",
        "--axle",
        "rear",
        "--noise",
        "1 %",
    )
    found = cli(*said, "--wheel", "both", "--out", "lane.csv", "--json").json
    assert [wheel["wheel"] for wheel in found["wheels"]] == ["left", "right"]
    assert found["axle"]["axle"] == "rear"
    again = cli("inspect", "evaluate", "lane.csv", "--tester", "egea-specsus2018", "--json").json
    for mine, theirs in zip(found["wheels"], again["wheels"], strict=True):
        assert mine["phase_angle_min_deg"] == pytest.approx(theirs["phase_angle_min_deg"], abs=1e-3)
        assert mine["verdict"] == theirs["verdict"] == "pass"
    assert "sweep of both wheels" in cli(*said, "--wheel", "both").out


def test_a_record_of_one_wheel_of_an_axle_is_one_of_this_wheel(cli, tmp_path: Path) -> None:
    said = (
        "inspect",
        "simulate",
        "audi-a6-full-car",
        "--method",
        "egea",
        "--wheel",
        "right",
        "--out",
        "lane.csv",
    )
    assert cli(*said).exit_code == 0
    outcome = cli("inspect", "evaluate", "lane.csv", "--tester", "egea-specsus2018", "--json")
    assert outcome.exit_code == 0
    assert [wheel["wheel"] for wheel in outcome.json["wheels"]] == ["right"]
    assert outcome.json["findings"] == []


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("audi-a6-quarter-car", "--wheel", "both"), "a single wheel stands on one plate only"),
        (("audi-a6-full-car", "--wheel", "both", "--steady"), "steady states need a single wheel"),
        (
            ("audi-a6-full-car", "--wheel", "both", "--wear", "0:1:0.5"),
            "a range of wear needs a single wheel",
        ),
    ],
)
def test_both_wheels_that_cannot_be(cli, words: tuple[str, ...], says: str) -> None:
    outcome = cli("inspect", "simulate", *words, "--method", "egea")
    assert outcome.exit_code == 2
    assert says in outcome.err


def test_help_names_the_store(cli) -> None:
    assert "record store" in " ".join(cli("inspect", "--help").out.split())
