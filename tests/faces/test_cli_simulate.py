"""``jounce simulate``, ``modes``, ``plot``, ``library``: the way of a new user, and everything one can get wrong."""

from __future__ import annotations

from pathlib import Path

import pytest

import jounce as jn
from jounce.inspection.limits import load_limits
from jounce.parts.testers import load_tester

RIG = "kart-quarter-car"
DRIVE = ("--speed", "1.95 m/s", "--duration", "1 s")


def test_summary_agrees_with_the_recording(cli, bump: Path, tmp_path: Path) -> None:
    outcome = cli("simulate", RIG, "--road", bump, *DRIVE, "--out", "run.nc", "--json")
    assert outcome.exit_code == 0
    assert outcome.err == ""
    found = outcome.json
    run, findings = jn.read_recording(tmp_path / "run.nc")
    assert findings == []
    assert found["samples"] == 1001 == run.sizes["time"]
    assert set(found["channels"]) == set(map(str, run.data_vars))
    peak = found["channels"]["sprung.az"]
    assert peak["unit"] == "m/s^2"
    assert peak["maximum"] == pytest.approx(float(run["sprung.az"].max()), rel=1e-12)
    assert peak["time_of_maximum"] == pytest.approx(
        float(run["time"][int(run["sprung.az"].to_numpy().argmax())]), abs=1e-12
    )
    assert found["channels"]["tyre.force"]["static"] == pytest.approx(
        21 * 9.81, rel=1e-9
    )  # (16 + 5) kg
    assert found["events"] >= 2  # the tyre lifts off and lands


def test_table_for_people(cli, bump: Path) -> None:
    outcome = cli("simulate", RIG, "--road", bump, *DRIVE)
    assert outcome.exit_code == 0
    assert "sprung.az" in outcome.out
    assert "1001 samples" in outcome.out
    assert outcome.err == ""


def test_changes_and_bare_numbers_are_si(cli, bump: Path) -> None:
    words = ("simulate", RIG, "--road", bump, "--speed", 1.95, "--duration", 1, "--json")
    softer = cli(*words, "--set", "strut.spring.rate=15 N/mm").json
    same = cli(*words, "--set", "strut.spring.rate=15000").json
    assert softer["channels"] == same["channels"]
    assert (
        softer["channels"]["strut.deflection"]["static"]
        > 1.3 * cli(*words).json["channels"]["strut.deflection"]["static"]
    )


def test_structures_can_be_set(cli, bump: Path) -> None:
    words = ("simulate", RIG, "--road", bump, *DRIVE, "--json", "--set")
    bilinear = '{bump_coefficient = "100 N*s/m", rebound_coefficient = 200}'
    assert cli(*words, f"strut.damper={bilinear}").exit_code == 0
    without = cli(*words, "tyre.lift_off=false").json
    assert without["channels"]["tyre.force"]["minimum"] < 0.0


def test_output_step_and_csv(cli, bump: Path, tmp_path: Path) -> None:
    outcome = cli(
        "simulate",
        RIG,
        "--road",
        bump,
        *DRIVE,
        "--output-step",
        "5 ms",
        "--out",
        "run.csv",
        "--json",
    )
    assert outcome.json["samples"] == 201
    assert (tmp_path / "run.csv").read_text(encoding="utf-8").startswith("time [s],strut.")


def test_excitation_in_time(cli, tmp_path: Path) -> None:
    rows = "\n".join(f"{0.01 * i:.2f}, {5.0 if i > 10 else 0.0}" for i in range(101))
    (tmp_path / "base.csv").write_text(f"time [s], road.z [mm]\n{rows}\n", encoding="utf-8")
    found = cli("simulate", RIG, "--excitation", "base.csv", "--json").json
    assert found["duration"] == pytest.approx(1.0)
    assert found["channels"]["road.z"]["maximum"] == pytest.approx(0.005, rel=0.2)
    both = cli("simulate", RIG, "--excitation", "base.csv", "--speed", "1 m/s")
    assert both.exit_code == 2
    assert "Leave out the speed" in both.err


def test_shipped_course_by_name(cli) -> None:
    words = (
        "--road",
        "detrended_rms_course_1in",
        "--speed",
        "20 m/s",
        "--duration",
        "0.5 s",
        "--json",
    )
    assert cli("simulate", "audi-a6-quarter-car", *words).json["status"] == "completed"


def test_run_that_never_meets_the_obstacle_is_said(cli, bump: Path) -> None:
    outcome = cli(
        "simulate", RIG, "--road", bump, "--speed", "1 m/s", "--duration", "0.1 s", "--json"
    )
    assert "before the obstacle begins" in outcome.json["findings"][0]["message"]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (
            ("--speed", "1.95 N"),
            "--speed: wrong unit; found 'N'; allowed: a unit that converts to m/s",
        ),
        (("--speed", "fast"), "--speed: not a number with a unit; found 'fast'"),
        (("--speed", "-1 m/s"), "--speed: out of range; found '-1 m/s'; allowed: above 0 m/s"),
        (("--speed", "nan"), "--speed: not a finite number"),
        (("--duration", "0 s"), "--duration: out of range"),
        (("--output-step", "0 ms"), "--output-step: out of range"),
        (("--tolerance", "loose"), "--tolerance: not a number"),
        (("--set", "strut.spring.rat=25 N/mm"), "Did you mean 'rate'?"),
        (("--set", "strut.sprng.rate=25 N/mm"), "Did you mean 'spring'?"),
        (
            ("--set", "sprung.mass=-16 kg"),
            "sprung.mass: out of range; found '-16 kg'; allowed: above 0 kg",
        ),
        (("--set", "strut.spring.rate=25 N"), "strut.spring.rate: wrong unit"),
        (("--set", "sprung.mass"), "--set: not NAME=VALUE"),
        (("--set", "sprung.mass=1", "--set", "sprung.mass=2"), "given twice"),
        (("--road", "missing.toml"), "missing.toml: no such file. Check"),
        (("--road", "missing"), "no road of that name"),
        (("--road", "detrended_rms_course"), "Did you mean 'detrended_rms_course_1in'?"),
        (("--out", "run.ods"), "allowed: .nc, .csv"),
        (("--out", "nowhere/run.nc"), "the output folder does not exist"),
    ],
)
def test_bad_options(words: tuple[str, ...], message: str, cli, bump: Path, tmp_path: Path) -> None:
    given = {"--road": str(bump), "--speed": "1.95 m/s", "--duration": "1 s"}
    rest = [(option, value) for option, value in given.items() if option not in words]
    outcome = cli("simulate", RIG, *(word for pair in rest for word in pair), *words)
    assert outcome.exit_code == 2
    assert outcome.out == ""
    assert message in outcome.err
    assert outcome.err.count("\n") == 1
    assert [file.name for file in tmp_path.iterdir()] == ["bump.toml"]


@pytest.mark.parametrize("left_out", ["--road", "--speed", "--duration"])
def test_missing_options(left_out: str, cli, bump: Path) -> None:
    given = {"--road": str(bump), "--speed": "1.95 m/s", "--duration": "1 s"}
    words = [
        word for option, value in given.items() if option != left_out for word in (option, value)
    ]
    outcome = cli("simulate", RIG, *words)
    assert outcome.exit_code == 2
    assert left_out in outcome.err


def test_more_samples_than_memory(cli, bump: Path) -> None:
    outcome = cli(
        "simulate",
        RIG,
        "--road",
        bump,
        "--speed",
        "1 m/s",
        "--duration",
        "1 s",
        "--output-step",
        "1e-15 s",
    )
    assert outcome.exit_code == 2
    assert "too many samples" in outcome.err
    assert "lengthen the output step" in outcome.err


def test_existing_output_is_kept(cli, bump: Path, tmp_path: Path) -> None:
    (tmp_path / "run.nc").write_bytes(b"mine")
    words = ("simulate", RIG, "--road", bump, *DRIVE, "--out", "run.nc")
    outcome = cli(*words)
    assert outcome.exit_code == 2
    assert "run.nc: the output already exists" in outcome.err
    assert "--force" in outcome.err
    assert (tmp_path / "run.nc").read_bytes() == b"mine"
    assert cli(*words, "--force").exit_code == 0
    assert (tmp_path / "run.nc").read_bytes() != b"mine"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            '"16 kg"',
            '"-16 kg"',
            "rig.toml, line 4: sprung.mass: out of range; found '-16 kg'; allowed: above 0 kg",
        ),
        ('"16 kg"', '"16"', "rig.toml, line 4: sprung.mass: the unit is missing"),
        ('"16 kg"', '"16 m"', "rig.toml, line 4: sprung.mass: wrong unit"),
        ("stiffness", "stifness", "Did you mean 'stiffness'?"),
        ("[tyre]", "[tyre", "rig.toml: not valid TOML"),
        ("jounce.rig/1", "jounce.rig/9", "jounce.rig/1"),
        ("quarter-car", "quater-car", "Did you mean 'quarter-car'?"),
        (None, "", "rig.toml: the file is empty"),
    ],
)
def test_bad_rigs(
    old: str | None, new: str, message: str, cli, rig_text: str, tmp_path: Path
) -> None:
    (tmp_path / "rig.toml").write_text(rig_text.replace(old, new) if old else new, encoding="utf-8")
    for command in ("modes", "check"):
        outcome = cli(command, "rig.toml")
        assert outcome.exit_code == 2
        assert message in outcome.err


def test_bad_road(cli, tmp_path: Path) -> None:
    (tmp_path / "road.toml").write_text('kind = "half-sin"\nheight = "10 mm"\n', encoding="utf-8")
    outcome = cli("simulate", RIG, "--road", "road.toml", *DRIVE)
    assert outcome.exit_code == 2
    assert "road.toml, line 1: kind: unknown kind of road 'half-sin'" in outcome.err
    assert "Did you mean 'half-sine'?" in outcome.err


def test_modes(cli) -> None:
    found = cli("modes", RIG, "--json").json
    expected = [mode.frequency_hz for mode in jn.modes(jn.load(RIG))]
    assert [mode["frequency_hz"] for mode in found["modes"]] == pytest.approx(expected, rel=1e-12)
    assert found["equilibrium"]["tyre.force"] == pytest.approx(21 * 9.81, rel=1e-9)
    text = cli("modes", RIG, "--set", "strut.damper.coefficient=1e5 N*s/m")
    assert text.exit_code == 0
    assert "Static equilibrium" in text.out
    assert "friction" not in text.out
    assert found["findings"] == []


def test_modes_say_that_dry_friction_is_left_out(cli, tmp_path: Path) -> None:
    words = ("modes", RIG, "--set", "strut.friction.force=40 N")
    stuck = cli(*words, "--report", "stuck.html")
    assert "note: strut.friction.force: dry friction is left out" in stuck.out
    assert "dry friction is left out" in (tmp_path / "stuck.html").read_text(encoding="utf-8")
    assert cli(*words, "--json").json["findings"][0]["place"] == "strut.friction.force"


def test_coordinates_of_joints_at_rest_have_their_units(cli) -> None:
    text = cli("modes", "kart-double-wishbone").out
    for name, unit in (
        ("sprung.distance rate", "m/s"),
        ("lower_arm.angle rate", "°/s"),
        ("ball_joint.wx", "°/s"),
    ):
        (row,) = (line for line in text.splitlines() if name in line)
        assert row.split(name)[1].split()[0] == unit


def test_runs_are_compared_and_reported(cli, bump: Path, tmp_path: Path) -> None:
    run = cli(
        "simulate",
        RIG,
        "--road",
        bump,
        *DRIVE,
        "--out",
        "a.nc",
        "--figure",
        "a.svg",
        "--report",
        "a.html",
        "--json",
    )
    assert (run.json["figure"], run.json["report"]) == ("a.svg", "a.html")
    assert "data-viewer=" in (tmp_path / "a.html").read_text(encoding="utf-8")
    cli(
        "simulate",
        RIG,
        "--road",
        bump,
        *DRIVE,
        "--set",
        "strut.damper.coefficient=300 N*s/m",
        "--out",
        "b.nc",
    )
    outcome = cli(
        "plot", "a.nc", "b.nc", "tyre.force", "--figure", "ab.svg", "--report", "ab.pdf", "--json"
    )
    assert outcome.exit_code == 0, outcome.err
    assert outcome.json["runs"] == ["a.nc", "b.nc"]
    assert outcome.json["channels"] == ["tyre.force"]
    assert (tmp_path / "ab.svg").read_text(encoding="utf-8").count("difference") == 1
    assert (tmp_path / "ab.pdf").read_bytes().startswith(b"%PDF")
    assert "ab.pdf: the output already exists" in cli("plot", "a.nc", "--report", "ab.pdf").err
    assert "nothing to write" in cli("plot", "a.nc", "b.nc").err
    assert "no channel 'c.zz'" in cli("plot", "a.nc", "c.zz", "--figure", "c.svg").err


@pytest.mark.parametrize("suffix", ["png", "svg", "pdf"])
def test_plot(suffix: str, cli, bump: Path, tmp_path: Path) -> None:
    cli("simulate", RIG, "--road", bump, *DRIVE, "--out", "run.nc")
    outcome = cli(
        "plot", "run.nc", "sprung.az", "tyre.force", "--figure", f"figure.{suffix}", "--json"
    )
    assert outcome.json["channels"] == ["sprung.az", "tyre.force"]
    start = {"png": b"\x89PNG", "svg": b"<?xml", "pdf": b"%PDF"}[suffix]
    assert (tmp_path / f"figure.{suffix}").read_bytes().startswith(start)
    again = cli("plot", "run.nc", "--figure", f"figure.{suffix}")
    assert again.exit_code == 2
    assert "the output already exists" in again.err


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("run.nc", "sprung.zz", "--figure", "f.png"), "no channel 'sprung.zz'"),
        (("run.nc", "--figure", "f.gif"), "allowed: .svg, .png, .pdf"),
        (("gone.nc", "--figure", "f.png"), "gone.nc: no such file"),
        (("bump.toml", "--figure", "f.png"), "suffix does not belong to a known format"),
    ],
)
def test_bad_plots(words: tuple[str, ...], message: str, cli, bump: Path, tmp_path: Path) -> None:
    cli("simulate", RIG, "--road", bump, *DRIVE, "--out", "run.nc")
    outcome = cli("plot", *words)
    assert outcome.exit_code == 2
    assert message in outcome.err
    assert sorted(file.name for file in tmp_path.iterdir()) == ["bump.toml", "run.nc"]


def test_library(cli, tmp_path: Path) -> None:
    found = cli("library", "--json").json
    assert RIG in [rig["name"] for rig in found["rigs"]]
    assert all(item["source"] for item in [*found["rigs"], *found["roads"]])
    text = cli("library", RIG).out
    (tmp_path / "mine.toml").write_text(text, encoding="utf-8")
    assert jn.load(tmp_path / "mine.toml") == jn.load(RIG)
    assert "504.75 m" in cli("library", "detrended_rms_course_1in").out
    assert "egea-specsus2018" in [tester["name"] for tester in found["testers"]]
    assert [item["name"] for item in found["limits"]] == ["jounce"]
    assert all(item["source"] for item in [*found["testers"], *found["limits"]])
    (tmp_path / "eusama.toml").write_text(cli("library", "eusama").out, encoding="utf-8")
    (tmp_path / "limits.toml").write_text(cli("library", "jounce").out, encoding="utf-8")
    assert load_tester(tmp_path / "eusama.toml") == load_tester("eusama")
    assert load_limits(tmp_path / "limits.toml") == load_limits()
    unknown = cli("library", "kart-quarter")
    assert unknown.exit_code == 2
    assert "Did you mean 'kart-quarter-car'?" in unknown.err


def test_method_is_chosen_and_told(cli, bump: Path) -> None:
    words = ("simulate", RIG, "--road", bump, *DRIVE)
    assert cli(*words, "--json").json["method"] == "exact"
    assert cli(*words, "--method", "explicit", "--json").json["method"] == "explicit"
    found = cli(*words, "--method", "implicit", "--json").json
    assert found["method"] == "implicit"
    assert found["channels"]["sprung.z"]["maximum"] == pytest.approx(
        cli(*words, "--json").json["channels"]["sprung.z"]["maximum"], rel=1e-4
    )
    assert "implicit method" in cli(*words, "--method", "implicit").out


def test_a_method_that_does_not_exist(cli, bump: Path) -> None:
    outcome = cli("simulate", RIG, "--road", bump, *DRIVE, "--method", "euler")
    assert outcome.exit_code == 2
    assert "euler" in outcome.err
    assert "auto, explicit, implicit" in outcome.err
