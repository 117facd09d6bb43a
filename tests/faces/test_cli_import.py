"""``jounce import``: a real corner becomes a rig file that everything else reads, and what is refused."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import jounce as jn

FILES = Path(__file__).parents[1] / "files" / "chrono"
POLARIS = FILES / "Polaris_Front_DoubleWishbone.json"


def test_the_rig_goes_to_stdout_and_warnings_to_stderr(cli, tmp_path: Path):
    outcome = cli("import", "chrono", POLARIS)
    assert outcome.exit_code == 0
    file = tmp_path / "rig.toml"
    file.write_text(outcome.out, encoding="utf-8")
    assert jn.load(file).hardpoints.lower_ball_joint[:2] == pytest.approx((0.016, 0.574))
    assert "Lower Control Arm: the principal moments 0.1, 0.1 and 0.2938" in outcome.err
    assert "note: " not in outcome.err


def test_a_written_rig_passes_the_check_with_its_findings(cli, tmp_path: Path):
    outcome = cli("import", "chrono", POLARIS, "--out", "rig.toml", "--wheel-radius", "330.229 mm")
    assert outcome.exit_code == 0
    assert "rig.toml: double-wishbone, Polaris DoubleWishbone" in outcome.out
    assert "estimated: bodies.lower_arm.inertia" in outcome.out
    assert "wheel.radius" not in outcome.out.split("\n")[1]
    checked = cli("check", "rig.toml", "--json").json
    assert checked["ok"]
    assert any(
        "strut_top: the strut leans 34.4 deg" in note for note in checked["files"][0]["notes"]
    )
    assert jn.load(tmp_path / "rig.toml").wheel.radius == pytest.approx(0.330229)


def test_json_holds_rig_and_findings(cli):
    plain = cli(
        "import", "chrono", FILES / "Sedan_MultiLink.json", "--json", "--sprung-mass", "312.5 kg"
    ).json
    assert plain["model"] == "five-link"
    assert plain["out"] is None
    assert "sprung.mass" not in plain["estimated"]
    assert {finding["severity"] for finding in plain["findings"]} == {"note"}
    assert 'mass = "312.5 kg"' in plain["text"]


def test_nothing_is_overwritten(cli, tmp_path: Path):
    file = tmp_path / "rig.toml"
    file.write_text("mine", encoding="utf-8")
    refused = cli("import", "chrono", POLARIS, "--out", file)
    assert refused.exit_code == 2
    assert "the output already exists" in refused.err
    assert file.read_text() == "mine"
    assert cli("import", "chrono", POLARIS, "--out", file, "--force").exit_code == 0
    assert jn.load(file).model == "double-wishbone"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (
            [FILES / "Gator_SingleWishboneFront.json"],
            "found 'SingleWishbone'; allowed: the template DoubleWishbone, Mac",
        ),
        (["missing.json"], "missing.json: no such file"),
        ([FILES / "LICENSE.txt"], "not valid JSON"),
        ([POLARIS, "--wheel-radius", "330"], "--wheel-radius: 330 m is implausible"),
        ([POLARIS, "--wheel-radius", "330 m"], None),
        ([POLARIS, "--wheel-radius", "330 kg"], "--wheel-radius: wrong unit"),
        ([POLARIS, "--sprung-mass", "0 kg"], "--sprung-mass: out of range"),
        ([POLARIS, "--tyre-stifness", "1"], "Did you mean '--tyre-stiffness'"),
        ([POLARIS, "--out", "missing/rig.toml"], "output folder does not exist"),
        (
            [POLARIS, "--out", "rig.txt"],
            "rig.txt: rigs are not written in this format; found '.txt'; allowed: .toml",
        ),
    ],
    ids=str,
)
def test_refused(cli, words: list[object], message: str | None):
    outcome = cli("import", "chrono", *words)
    if message is None:  # a bare number is SI: a wheel of 330 m is legal and named
        assert outcome.exit_code == 0
        assert "330 m is implausible for a wheel" in outcome.err
        return
    assert outcome.exit_code == 2
    assert message in " ".join(outcome.err.split())
    assert outcome.out == ""


def test_a_file_with_odd_names_is_written_as_valid_toml(cli, tmp_path: Path):
    table = json.loads((FILES / "audi_DoubleWishbone.json").read_text(encoding="utf-8"))
    file = tmp_path / "odd.json"
    file.write_text(
        json.dumps({**table, "Name": 'a "quoted" \\ name\nof two lines'}), encoding="utf-8"
    )
    assert cli("import", "chrono", file, "--out", "rig.toml").exit_code == 0
    assert jn.load(tmp_path / "rig.toml").source.startswith('a "quoted" \\ name\nof two lines')


POINTS = """name,x [mm],y [mm],z [mm]
LCA front,150,220,122
LCA rear,-150,220,118
Lower outer,5,560,130
Tie rod inner,65,225,148
Tie rod outer,70,556,165
Hub,0,600,226
Top mount,0,480,700
Lwr strut mount,0,540,330
"""


def test_a_table_of_hardpoints_becomes_a_rig(cli, tmp_path: Path):
    (tmp_path / "points.csv").write_text(POINTS, encoding="utf-8")
    refused = cli("import", "hardpoints", "points.csv")
    assert refused.exit_code == 2
    assert "these points and wheel_centre" in refused.err
    outcome = cli(
        "import", "hardpoints", "points.csv", "--name", "Hub=wheel_centre", "--out", "rig.toml"
    )
    assert outcome.exit_code == 0
    assert "rig.toml: mcpherson, hardpoints of points.csv" in outcome.out
    assert "the wheel radius is assumed to be 226 mm" in outcome.out
    assert jn.load(tmp_path / "rig.toml").hardpoints.strut_bottom == pytest.approx(
        (0.0, 0.54, 0.33)
    )
    checked = cli("check", "rig.toml")
    assert checked.exit_code == 0, "a rig for kinematics is whole as it is"
    assert (
        "it has no bodies, spring, damper, tyre: its kinematics can be swept, it cannot move"
        in checked.out
    )
    for words, message in (
        (("--side", "middle"), "unknown side 'middle'"),
        (("--axle", "third"), "unknown axle 'third'"),
        (("--name", "Hub"), "two names are required"),
        (("--name", "Hub=wheel_centre", "--axes", "x"), "three axes are required"),
    ):
        refused = cli("import", "hardpoints", "points.csv", *words)
        assert (refused.exit_code, message in refused.err) == (2, True)


def test_a_subsystem_of_adams_becomes_a_rig(cli, tmp_path: Path):
    file = FILES.parent / "adams_car" / "made_up.cdb" / "subsystems.tbl" / "front.sub"
    outcome = cli("import", "adams", file, "--out", "rig.toml", "--wheel-mass", "18 kg")
    assert outcome.exit_code == 0
    assert "rig.toml: double-wishbone, front.sub, subsystem of Adams Car" in outcome.out
    assert "bodies.wheel.mass" not in outcome.out.split("\n")[1]
    assert jn.load(tmp_path / "rig.toml").strut.spring.rate == pytest.approx(60e3)
    refused = cli("import", "adams", file.parents[1] / "springs.tbl" / "ride.spr")
    assert (refused.exit_code, "[SUBSYSTEM_HEADER] is missing" in refused.err) == (2, True)
