"""``jounce design kinematics``: a study file to a rig, results, tables and pictures, and what one can get wrong."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.parts import library

HEAD = 'schema = "jounce.design/1"\nrig = "formula-student-front"\n'
SEVERAL = 'schema = "jounce.design/1"\n[rigs]\nfront = "formula-student-front"\n'
CAR = (
    '[vehicle]\naxle = "front"\nwheelbase = 1.55\ncentre_of_mass_height = 0.3\nbrake_share = 0.6\n'
)
FREE = '[[free]]\npoint = "hardpoints.tie_rod_inner"\nwithin = "15 mm"\n'
CURVE = '[[target]]\nquantity = "toe"\nover = "-30 mm:30 mm:5 mm"\nvalue = "0 deg"\ntolerance = "0.03 deg"\n'
GAIN = '[[target]]\nquantity = "camber_gain"\nvalue = "-25 deg/m"\ntolerance = "0.2 deg/m"\n'


@pytest.fixture
def study(tmp_path: Path):
    def write(text: str) -> Path:
        file = tmp_path / "study.toml"
        file.write_text(text, encoding="utf-8")
        return file

    return write


def test_targets_that_can_be_met(cli, study, tmp_path: Path) -> None:
    outcome = cli("design", "kinematics", study(HEAD + FREE + CURVE), "--out", "out")
    assert outcome.exit_code == 0, outcome.err
    results = json.loads((tmp_path / "out" / "results.json").read_text(encoding="utf-8"))
    assert set(results) == {"met", "targets", "moved", "starts", "evaluations"}
    assert results["met"] is True
    (target,) = results["targets"]
    assert {"quantity", "before", "after", "wanted", "tolerance", "met"} <= set(target)
    assert np.max(np.abs(target["after"])) <= np.radians(0.03)
    assert np.max(np.abs(target["before"])) > np.radians(0.03)
    assert set(results["moved"]) == {f"hardpoints.tie_rod_inner[{i}]" for i in range(3)}
    assert len(results["starts"]) == 8
    assert results["evaluations"] > 8
    rig = jn.load(tmp_path / "out" / "rig.toml")
    for path, change in results["moved"].items():
        assert rig.parameters()[path] == change["after"]
        assert abs(change["after"] - change["before"]) <= 0.015 + 1e-9
    swept = jn.sweep_travel(rig, "-30 mm:30 mm:5 mm")["toe"].to_numpy()
    assert swept == pytest.approx(np.array(target["after"]), abs=1e-12)
    text = (tmp_path / "out" / "rig.toml").read_text(encoding="utf-8")
    before = library()["formula-student-front"].read_text(encoding="utf-8")
    changed = [line for line in text.splitlines() if line not in before.splitlines()]
    assert len(changed) == 1
    assert changed[0].startswith("tie_rod_inner = [")
    assert "# on the rocker" in text
    for name in (
        "targets.csv",
        "sensitivity.csv",
        "targets.png",
        "sensitivity.png",
        "geometry.png",
    ):
        assert (tmp_path / "out" / name).stat().st_size > 200


def test_targets_that_contradict_each_other(cli, study, tmp_path: Path) -> None:
    other = GAIN.replace("-25", "-30")
    free = FREE.replace("tie_rod_inner", "upper_arm_front")
    outcome = cli(
        "design", "kinematics", study(HEAD + free + GAIN + other), "--out", "out", "--json"
    )
    assert outcome.exit_code == 1
    assert outcome.json["met"] is False
    assert any(fight["missed"] == 0 and fight["other"] == 1 for fight in outcome.json["fights"])
    assert (tmp_path / "out" / "rig.toml").is_file()
    assert (
        json.loads((tmp_path / "out" / "results.json").read_text(encoding="utf-8"))["met"] is False
    )


def test_the_rig_may_lie_beside_the_study(cli, study, tmp_path: Path) -> None:
    rig = jn.load("formula-student-front").with_changes({"hardpoints.tie_rod_inner[2]": "150 mm"})
    jn.save(rig, tmp_path / "mine.toml", like="formula-student-front")
    outcome = cli(
        "design",
        "kinematics",
        study((HEAD + FREE + CURVE).replace("formula-student-front", "mine.toml")),
    )
    assert outcome.exit_code == 0
    assert "150" in outcome.out


@pytest.mark.slow  # it draws eight pictures
def test_a_study_of_both_axles_writes_both_rigs(cli, study, tmp_path: Path) -> None:
    head = 'schema = "jounce.design/1"\nstarts = 1\n[rigs]\nfront = "formula-student-front"\nrear = "mine.toml"\n'
    rig = jn.load("formula-student-front").with_changes({"hardpoints.tie_rod_inner[2]": "150 mm"})
    jn.save(rig, tmp_path / "mine.toml", like="formula-student-front")
    free = FREE.replace('"hardpoints.tie_rod_inner"', '"front.hardpoints.tie_rod_inner[2]"')
    free += free.replace("front.", "rear.")
    curves = [CURVE + f'rig = "{name}"\nmust = true\n' for name in ("front", "rear")]
    outcome = cli(
        "design", "kinematics", study(head + free + "".join(curves)), "--out", "out", "--json"
    )
    assert outcome.exit_code == 0, outcome.err
    assert set(outcome.json["moved"]) == {
        f"{name}.hardpoints.tie_rod_inner[2]" for name in ("front", "rear")
    }
    assert [target["rig"] for target in outcome.json["targets"]] == ["front", "rear"]
    for name in ("front", "rear"):
        moved = jn.load(tmp_path / "out" / f"{name}.toml").parameters()[
            "hardpoints.tie_rod_inner[2]"
        ]
        assert moved == outcome.json["moved"][f"{name}.hardpoints.tie_rod_inner[2]"]["after"]
        assert (tmp_path / "out" / f"geometry-{name}.png").stat().st_size > 10_000
    assert (tmp_path / "out" / "identified.csv").read_text(encoding="utf-8").count(
        "tie_rod_inner[2],m,"
    ) == 2
    assert (tmp_path / "out" / "tradeoffs.csv").read_text(encoding="utf-8").count(
        "front.toe 0"
    ) == 2


def test_nothing_is_overwritten(cli, study, tmp_path: Path) -> None:
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "results.json").write_text("mine", encoding="utf-8")
    outcome = cli("design", "kinematics", study(HEAD + FREE + CURVE), "--out", "out")
    assert outcome.exit_code == 2
    assert (tmp_path / "out" / "results.json").read_text(encoding="utf-8") == "mine"
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["results.json"]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (
            HEAD + FREE + CURVE.replace("toe", "tow"),
            ["target[0].quantity", "unknown quantity 'tow'", "'toe'"],
        ),
        (
            HEAD + FREE.replace("tie_rod_inner", "tie_rod_iner") + CURVE,
            ["free[0].point", "unknown parameter"],
        ),
        (
            HEAD + FREE.replace("hardpoints.tie_rod_inner", "bodies.upright.mass") + CURVE,
            ["has no effect"],
        ),
        (HEAD + FREE.replace("tie_rod_inner", "strut_top") + CURVE, ["has no effect", "strut_top"]),
        (HEAD + FREE + FREE + CURVE, ["listed twice", "hardpoints.tie_rod_inner[0]"]),
        (HEAD + FREE.replace("15 mm", "15 kg") + CURVE, ["free[0].within", "kg"]),
        (HEAD + FREE.replace('"15 mm"', "15") + CURVE, ["15 m", "metres"]),
        (HEAD + FREE.replace("15 mm", "0 mm") + CURVE, ["free[0].within"]),
        (
            HEAD
            + FREE.replace('within = "15 mm"', 'box = [["0 mm", "0 mm"], ["1 mm", "1 mm"]]')
            + CURVE,
            ["box"],
        ),
        (
            HEAD
            + FREE.replace("inner", "inner[2]").replace(
                'within = "15 mm"', 'box = ["150 mm", "140 mm"]'
            )
            + CURVE,
            ["the box is empty"],
        ),
        (HEAD + FREE.replace('within = "15 mm"', "") + CURVE, ["within"]),
        (HEAD + FREE + CURVE.replace("-30 mm:30 mm:5 mm", "-20:20:2"), ["20 m", "metres", "mm"]),
        (
            HEAD + FREE + CURVE.replace("-30 mm:30 mm", "-300 mm:300 mm"),
            ["cannot reach", "end of its travel"],
        ),
        (HEAD + FREE + CURVE.replace("0.03 deg", "0 deg"), ["target[0].tolerance"]),
        (HEAD + FREE + CURVE.replace("0.03 deg", "0.03 mm"), ["target[0].tolerance", "mm"]),
        (HEAD + FREE + CURVE.replace('value = "0 deg"', ""), ["value"]),
        (HEAD + FREE + GAIN.replace("camber_gain", "anti_dive"), ["anti_dive", "vehicle"]),
        (HEAD + FREE + GAIN.replace("camber_gain", "ackermann"), ["ackermann", "vehicle"]),
        (HEAD + FREE + CURVE + 'rig = "rear"\n', ["target[0].rig", "the study has one rig"]),
        (HEAD.replace("rig =", "# rig =") + FREE + CURVE, ["rig", "[rigs]"]),
        (
            HEAD
            + FREE.replace('within = "15 mm"', 'within = "15 mm"\nalong = "tie_rod_outr"')
            + CURVE,
            ["tie_rod_outer"],
        ),
        (
            HEAD
            + FREE.replace('within = "15 mm"', "box = [[40, 200, 130], [90, 240, 170]]")
            + CURVE,
            ["240 m", "metres"],
        ),
        (
            SEVERAL.replace("front =", '"../front" =') + FREE + CURVE,
            ["invalid rig name", "../front"],
        ),
        (SEVERAL.replace("front =", '"a.b" =') + FREE + CURVE, ["invalid rig name"]),
        (
            SEVERAL + FREE.replace('"hard', '"rear.hard') + CURVE + 'rig = "front"\n',
            ["free[0].point", "'rear'", "front"],
        ),
        (
            SEVERAL + FREE.replace('"hard', '"front.hard') + CURVE,
            ["target[0].rig", "does not name its rig", "front"],
        ),
        (
            SEVERAL
            + '[vehicle]\naxle = "front"\nwheelbase = 1.5\ncentre_of_mass_height = 0.3\nbrake_share = 0.6\n'
            + FREE
            + CURVE,
            ["vehicle"],
        ),
        (HEAD + FREE + CURVE.replace('"0.03 deg"', '"nan deg"'), ["target[0].tolerance"]),
        (HEAD + FREE + CURVE.replace('value = "0 deg"', "value = inf"), ["target[0].value"]),
        (HEAD + FREE + CURVE + "weight = 0\n", ["weight"]),
        (
            HEAD + FREE + CURVE.replace('"toe"', '"clearance(rod, rim)"').replace("deg", "mm"),
            ["shape", "rod"],
        ),
        (HEAD + FREE + CURVE + "[spread]\ncars = 10\n", ["the spread contains no deviation"]),
        (HEAD + FREE + CURVE + '[spread]\npoints = "1 mm"\ncars = 1\n', ["spread.cars"]),
        (
            HEAD
            + FREE.replace('within = "15 mm"', 'within = "15 mm"\nalong = "tie_rod_inner"')
            + CURVE,
            ["invalid direction"],
        ),
        (HEAD + FREE + 'tied = ["-hardpoints.tie_rod_inner"]\n' + CURVE, ["listed twice"]),
        (HEAD + FREE, ["target"]),
        (HEAD + CURVE, ["free"]),
        (HEAD.replace("front", "frnt") + FREE + CURVE, ["formula-student-frnt"]),
        (
            HEAD.replace("formula-student-front", "kart-quarter-car") + FREE + CURVE,
            ["no kinematics"],
        ),
        (HEAD.replace("design/1", "rig/1") + FREE + CURVE, ["schema"]),
        (HEAD + FREE + CURVE + "tolerence = 1\n", ["tolerence"]),
    ],
)
def test_what_cannot_be_asked_is_one_clear_message(
    cli, study, tmp_path: Path, text: str, words: list[str]
) -> None:
    outcome = cli("design", "kinematics", study(text), "--out", "out")
    assert outcome.exit_code == 2, outcome.out
    assert outcome.err.count("\n") <= 2
    for word in words:
        assert word in outcome.err, outcome.err
    assert not (tmp_path / "out").exists()


def test_a_study_is_checked_without_a_search(cli, study) -> None:
    outcome = cli("check", study(HEAD + FREE + CURVE), "--json")
    assert outcome.exit_code == 0, outcome.err
    assert "3 free numbers, 1 targets, 8 starts" in outcome.out
    assert cli("check", study(HEAD + FREE + CURVE.replace("toe", "tow"))).exit_code == 2


def test_ackermann_straight_ahead_has_no_value(cli, study) -> None:
    target = '[[target]]\nquantity = "ackermann"\nvalue = 1.0\ntolerance = 0.1\n'
    outcome = cli("design", "kinematics", study(HEAD + FREE + CAR + target))
    assert outcome.exit_code == 2
    assert "no value" in outcome.err


def test_boxes_without_a_mechanism_are_refused(cli, study) -> None:
    """Arms as long as 30 mm cannot follow a wheel over 60 mm."""
    box = 'box = [["-5 mm", "535 mm", "320 mm"], ["5 mm", "540 mm", "322 mm"]]'
    far = 'box = [["100 mm", "530 mm", "325 mm"], ["101 mm", "531 mm", "326 mm"]]'
    free = "".join(
        f'[[free]]\npoint = "hardpoints.upper_arm_{end}"\n{place}\n'
        for end, place in (("front", far), ("rear", box))
    )
    outcome = cli("design", "kinematics", study(HEAD + free + CURVE))
    assert outcome.exit_code == 2
    assert "no mechanism within the boxes" in outcome.err


def test_a_spread_of_parts_is_told_with_the_design(cli, study) -> None:
    made = '[spread]\nexact = {"tie_rod_inner length" = "0.5 mm"}\nadjust = ["tie_rod_length"]\ncars = 8\n'
    outcome = cli("design", "kinematics", study("starts = 1\n" + HEAD + FREE + CURVE + made))
    assert outcome.exit_code == 0, outcome.err
    assert "all targets are met by" in outcome.out
    wrong = made.replace("tie_rod_length", "tie_rod_lenght")
    outcome = cli("design", "kinematics", study(HEAD + FREE + CURVE + wrong))
    assert outcome.exit_code == 2
    assert "spread.adjust[0]" in outcome.err


def test_a_front_has_a_rig_for_each_design(cli, study, tmp_path: Path) -> None:
    free = FREE.replace("tie_rod_inner", "upper_arm_front[2]") + FREE.replace(
        "tie_rod_inner", "lower_arm_front[2]"
    )
    centre = '[[target]]\nquantity = "roll_centre_height"\nvalue = "5 mm"\ntolerance = "1 mm"\n'
    file = study(HEAD + free + GAIN.replace("-25", "-45") + centre)
    outcome = cli(
        "design", "kinematic-front", file, "--points", "3", "--starts", "1", "--out", "front"
    )
    assert outcome.exit_code == 0, outcome.err
    rows = (tmp_path / "front" / "front.csv").read_text(encoding="utf-8").splitlines()
    rigs = sorted(path.name for path in (tmp_path / "front").glob("rig-*.toml"))
    assert len(rows) == 2 + len(rigs) > 4
    column = rows[0].split(",").index("hardpoints.lower_arm_front[2]")
    for row, rig in zip(rows[2:], rigs, strict=True):
        assert jn.load(tmp_path / "front" / rig).parameters()[
            "hardpoints.lower_arm_front[2]"
        ] == float(row.split(",")[column])
    again = cli("design", "kinematic-front", file, "--out", "front")
    assert again.exit_code == 2
    assert cli("design", "kinematic-front", study(HEAD + FREE + CURVE)).exit_code == 2


def test_hardpoints_are_fitted_to_a_table_of_poses(cli, tmp_path: Path) -> None:
    rig = jn.load("formula-student-front").with_changes({"hardpoints.tie_rod_inner[2]": "151 mm"})
    travel = np.linspace(-0.02, 0.02, 9)
    toe = np.degrees(jn.sweep_travel(rig, travel)["toe"].to_numpy()) + np.resize(
        [2e-3, -1e-3, -1e-3], 9
    )
    rows = [f"{1e3 * at:.3f},{value:.6f}" for at, value in zip(travel, toe, strict=True)]
    (tmp_path / "poses.csv").write_text(
        "wheel_travel [mm],toe [deg]\n" + "\n".join(rows) + "\n", encoding="utf-8"
    )
    free = "hardpoints.tie_rod_inner[2]=10 mm"
    command = ("fit", "hardpoints", "formula-student-front", "poses.csv", "--free", free)
    outcome = cli(*command, "--out", "mine.toml", "--figure", "fit.png", "--json")
    assert outcome.exit_code == 0, outcome.err
    low, high = outcome.json["numbers"]["hardpoints.tie_rod_inner[2]"]["interval"]
    assert low < 0.151 < high
    assert high - low < 1e-4
    written = jn.load(tmp_path / "mine.toml").parameters()["hardpoints.tie_rod_inner[2]"]
    assert written == pytest.approx(
        outcome.json["numbers"]["hardpoints.tie_rod_inner[2]"]["value"], abs=1e-9
    )
    assert (tmp_path / "fit.png").stat().st_size > 5_000
    (tmp_path / "bad.csv").write_text("wheel_travel [mm],tow [deg]\n0,0\n", encoding="utf-8")
    outcome = cli("fit", "hardpoints", "formula-student-front", "bad.csv", "--free", free)
    assert outcome.exit_code == 2
    assert "toe" in outcome.err


def test_targets_that_fight_are_told_once_a_pair(cli, study) -> None:
    arms = FREE.replace("tie_rod_inner", "upper_arm_front")
    file = study(HEAD + arms + GAIN + GAIN.replace("-25", "-30"))
    found = cli("design", "kinematics", file)
    assert found.exit_code == 1
    lines = [line for line in found.out.splitlines() if " conflicts with " in line]
    assert len(lines) == 1
    fights = cli("design", "kinematics", file, "--json").json["fights"]
    assert {(one["missed"], one["other"]) for one in fights} == {(0, 1), (1, 0)}


def test_tables_say_how_far_a_curve_is_and_at_which_pose(cli, study, tmp_path: Path) -> None:
    values = '[[target]]\nquantity = "toe"\nover = "-30 mm:30 mm:30 mm"\nvalues = ["0.1 deg", "0 deg", "0 deg"]\n'
    centre = '[[target]]\nquantity = "roll_centre_height"\nat = "-20 mm"\nat_least = "-1 m"\ntolerance = "1 mm"\n'
    text = (
        HEAD
        + FREE
        + values
        + 'tolerance = "2 deg"\n'
        + centre
        + '[spread]\npoints = "0.2 mm"\ncars = 4\n'
    )
    outcome = cli("design", "kinematics", study(text), "--starts", "1", "--json")
    results = json.loads(outcome.out)
    away = np.degrees(np.array(results["targets"][0]["after"])) - np.array([0.1, 0.0, 0.0])
    worst = int(np.argmax(np.abs(away)))
    outcome = cli("design", "kinematics", study(text), "--starts", "1", "--report", "page.html")
    (row,) = (line for line in outcome.out.splitlines() if "farthest from its curve" in line)
    assert f"{(-30, 0, 30)[worst]} mm" in row
    first = np.degrees(np.array(results["targets"][0]["before"])) - np.array([0.1, 0.0, 0.0])
    assert f"{first[np.argmax(np.abs(first))]:.4f}"[:6] in row.replace("−", "-")
    assert "0 from it" in row
    assert any(
        "roll centre height" in line and "-20 mm" in line for line in outcome.out.splitlines()
    )
    (spread,) = (line for line in outcome.out.splitlines() if "all targets are met by" in line)
    assert spread.split()[-1] == "–"  # nothing is adjusted
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert "farthest from its curve" in page
    assert "roll centre height at -20 mm" in page


def test_a_study_file_gives_a_report_with_the_curves_of_the_test(
    cli, tmp_path, monkeypatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("study.toml").write_text(
        'schema = "jounce.design/1"\nrig = "twist-beam"\nstarts = 2\n\n'
        '[[free]]\npoint = "hardpoints.pivot[2]"\nwithin = "40 mm"\n\n'
        '[[target]]\ntest = "roll"\nquantity = "steer"\nvalue = -0.05\ntolerance = 0.001\n',
        encoding="utf-8",
    )
    checked = cli("check", "study.toml")
    assert checked.exit_code == 0, checked.err
    done = cli("design", "kinematics", "study.toml", "--out", "out", "--json")
    assert done.exit_code == 0, done.err
    page = Path("out/report.html").read_text(encoding="utf-8")
    assert "Curves of the K&amp;C tests with targets" in page
    assert "deg/deg" in page
    assert jn.load("out/rig.toml").hardpoints.pivot[2] > 0.31
