"""Vehicles on the command line: modes, check, library, simulate with roads and loads, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce import parts

HALF, HALF4, FULL = "audi-a6-half-car", "audi-a6-half-car-4dof", "audi-a6-full-car"
DRIVE = ("--road", "bump.toml", "--speed", "10 m/s", "--duration", "0.5 s")


@pytest.fixture(autouse=True)
def _in_place(bump: Path) -> None:
    assert bump.exists()


@pytest.mark.parametrize("car", [HALF, HALF4, FULL, "sldemo-half-car"])
def test_modes(cli, car: str) -> None:
    found = cli("modes", car, "--json").json
    expected = jn.modes(jn.load(car))
    assert [mode["frequency_hz"] for mode in found["modes"]] == [
        mode.frequency_hz for mode in expected
    ]
    assert found["equilibrium"]["body.z"] == jn.equilibrium(jn.load(car))["body.z"]
    text = cli("modes", car).out
    assert "body.pitch" in text
    assert max(map(len, text.splitlines())) < 200


def test_shapes_are_a_table_of_their_own(cli) -> None:
    shapes = cli("modes", FULL).out.partition("Amplitudes of the shapes")[2].splitlines()[3:]
    names = list(jn.modes(jn.load(FULL))[0].shape)
    assert [row.split()[0] for row in shapes[: len(names)]] == names


def test_check(cli, tmp_path: Path) -> None:
    for name in (HALF, HALF4, FULL):
        (tmp_path / f"{name}.toml").write_text(
            parts.library()[name].read_text(encoding="utf-8"), encoding="utf-8"
        )
    outcome = cli("check", *(f"{name}.toml" for name in (HALF, HALF4, FULL)), "--json")
    assert outcome.exit_code == 0
    assert [item["kind"] for item in outcome.json["files"]] == ["vehicle"] * 3
    assert (
        outcome.json["files"][2]["what"]
        == f"full-car with {len(jn.load(FULL).parameters())} parameters"
    )


def test_check_refuses(cli, tmp_path: Path) -> None:
    text = parts.library()[HALF].read_text(encoding="utf-8")
    (tmp_path / "bad.toml").write_text(text.replace('"1.29 m"', '"-1.29 m"'), encoding="utf-8")
    outcome = cli("check", "bad.toml")
    assert outcome.exit_code == 2
    assert "front.distance: out of range; found '-1.29 m'; allowed: above 0 m" in outcome.err
    (tmp_path / "bad.toml").write_text(text.replace('"physical"', '"phisical"'), encoding="utf-8")
    assert "Did you mean 'physical'?" in cli("check", "bad.toml").err


def test_library(cli) -> None:
    found = cli("library", "--json").json
    vehicles = {item["name"]: item for item in found["vehicles"]}
    assert {HALF, HALF4, FULL, "sldemo-half-car"} <= set(vehicles)
    assert not set(vehicles) & {item["name"] for item in found["rigs"]}
    assert {item["kind"] for item in found["vehicles"]} == {"vehicle"}
    assert vehicles[FULL]["what"] == "full-car"
    assert "Vehicles" in cli("library").out
    assert cli("library", HALF).out == parts.library()[HALF].read_text(encoding="utf-8")


def test_simulate_equals_python(cli) -> None:
    loads = (
        "--deceleration",
        "3 m/s^2@0.1 s",
        "--lateral-acceleration",
        "0.4 gravity@0.3 s",
        "--pitch-moment",
        "100 N*m @ 0.2 s",
    )
    found = cli("simulate", FULL, *DRIVE, *loads, "--out", "run.nc", "--json").json
    trial = jn.Trial(
        road=jn.load_road("bump.toml"),
        speed=10.0,
        duration=0.5,
        deceleration={"value": 3.0, "start": 0.1},
        lateral_acceleration={"value": 0.4 * 9.80665, "start": 0.3},
        pitch_moment={"value": 100.0, "start": 0.2},
    )
    run = jn.simulate(jn.load(FULL), trial)
    kept, findings = jn.read_recording(Path("run.nc"))
    assert findings == []
    for name in run:
        np.testing.assert_array_equal(kept[name], run[name])
        assert found["channels"][str(name)]["maximum"] == float(run[name].max())
    assert [one["place"] for one in found["findings"]] == [
        "trial: lateral_acceleration"
    ]  # what a lumped car leaves out
    assert found["loads"]["deceleration"] == "3 m/s^2@0.1 s"


def test_right_road(cli, tmp_path: Path) -> None:
    (tmp_path / "level.toml").write_text('kind = "flat"\n', encoding="utf-8")
    found = cli("simulate", FULL, *DRIVE, "--right-road", "level.toml", "--json").json
    assert found["channels"]["front_left.road.z"]["maximum"] == pytest.approx(0.01)
    assert found["channels"]["front_right.road.z"]["maximum"] == 0.0
    assert found["channels"]["body.roll"]["maximum"] > 1e-4


def test_shaker_moves_all_wheels_at_once(cli, tmp_path: Path) -> None:
    rows = "\n".join(f"{0.01 * i:.2f}, {5.0 * np.sin(0.2 * i):.6f}" for i in range(101))
    (tmp_path / "base.csv").write_text(f"time [s], road.z [mm]\n{rows}\n", encoding="utf-8")
    found = cli("simulate", HALF, "--excitation", "base.csv", "--json").json["channels"]
    assert found["front.road.z"] == found["rear.road.z"]


def table_file(folder: Path, apart: float, count: int) -> None:
    rows = "\n".join(f"{apart * i:.3f}, {(i * i) % 7}" for i in range(count))
    (folder / "table.csv").write_text(f"x [m], z [mm]\n{rows}\n", encoding="utf-8")


@pytest.mark.parametrize(
    ("car", "words", "place", "message"),
    [
        (FULL, ("--duration", "0.01 s"), "trial: road", "before the obstacle begins"),
        (FULL, ("--duration", "0.1 s"), "trial: duration", "before the rear axle, 2.91 m behind"),
        (FULL, ("--output-step", "5 ms"), "trial: road", "its peaks are missed"),
        (
            FULL,
            ("--pitch-moment", "100 N*m@9 s"),
            "trial: pitch_moment",
            "after the end of the run of 0.5 s",
        ),
        (HALF, ("--road", "cleat.toml"), "trial: road", "dampers of massless axles pass it on"),
    ],
)
def test_findings(
    cli, tmp_path: Path, car: str, words: tuple[str, ...], place: str, message: str
) -> None:
    (tmp_path / "cleat.toml").write_text(
        'kind = "rectangle"\nheight = 0.01\nlength = 0.5\nstart = 0.2\n', encoding="utf-8"
    )
    outcome = cli("simulate", car, *DRIVE, *words, "--json")
    assert outcome.exit_code == 0
    (finding,) = outcome.json["findings"]
    assert finding["place"] == place
    assert message in finding["message"]
    assert finding["severity"] == "warning"


def test_roads_that_end_or_are_coarse_are_told(cli, tmp_path: Path) -> None:
    words = (
        "simulate",
        FULL,
        "--road",
        "table.csv",
        "--speed",
        "10 m/s",
        "--duration",
        "2 s",
        "--json",
    )
    table_file(tmp_path, 0.05, 99)  # ends as high as it begins
    (finding,) = cli(*words).json["findings"]
    assert "the road ends after 4.9 m, but the run covers 20 m" in finding["message"]
    table_file(tmp_path, 0.05, 100)
    outcome = cli(*words)
    assert outcome.exit_code == 2
    assert (
        "the road is shorter than the run; found '20 m driven'; allowed: up to 4.95 m"
        in outcome.err
    )
    table_file(tmp_path, 1.0, 30)
    (finding,) = cli(*words).json["findings"]
    assert "1 m apart, contain nothing above 5 Hz at 10 m/s" in finding["message"]
    table_file(tmp_path, 0.05, 500)
    assert cli(*words).json["findings"] == []


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ((HALF, "--deceleration", "3 m/s^2"), "Give body.height"),
        (
            (HALF4, "--lateral-acceleration", "3 m/s^2"),
            "trial: lateral_acceleration: the model has no such input",
        ),
        ((HALF, "--right-road", "bump.toml"), "right is for full cars"),
        (("kart-quarter-car", "--pitch-moment", "3 N*m"), "allowed: the road only"),
        (
            (FULL, "--pitch-moment", "100 N"),
            "--pitch-moment: wrong unit; found 'N'; allowed: a unit that converts to N*m",
        ),
        ((FULL, "--pitch-moment", "100 N*m@1 m"), "--pitch-moment: wrong unit; found 'm'"),
        (
            (FULL, "--pitch-moment", "100 N*m@-1 s"),
            "--pitch-moment: out of range; found '-1 s'; allowed: a time of at least",
        ),
        ((FULL, "--pitch-moment", "nan"), "--pitch-moment: not a finite number"),
        ((FULL, "--deceleration", "@1 s"), "--deceleration: not a number with a unit"),
        ((FULL, "--deceleration", "3 m/s^2@"), "--deceleration: not a number with a unit"),
        ((FULL, "--deceleration", "50 m/s^2"), "With deceleration 50 (SI) from the very start"),
        (
            (FULL, "--deceleration", "90 m/s^2@0.1 s", "--duration", "3 s"),
            "s: a strut deflects beyond 10 m or the body turns over",
        ),
        ((FULL, "--right-road", "nowhere.toml"), "nowhere.toml: no such file"),
        ((HALF, "--set", "compat=simulnik"), "Did you mean 'simulink'?"),
        ((HALF, "--set", "front.distanc=1 m"), "Did you mean 'distance'?"),
        ((HALF, "--set", "front.distance=-1 m"), "front.distance: out of range"),
        (("audi-a6-halfcar",), "no such file, and no"),
    ],
)
def test_refused(cli, words: tuple[str, ...], message: str) -> None:
    outcome = cli("simulate", words[0], *DRIVE, *words[1:])
    assert outcome.exit_code == 2
    assert message in outcome.err
    assert len(outcome.err.splitlines()) == 1
    assert outcome.out == ""


def test_excitation_and_right_road_contradict_each_other(cli, tmp_path: Path) -> None:
    (tmp_path / "base.csv").write_text(
        "time [s], road.z [mm]\n0,0\n1,1\n2,0\n3,1\n", encoding="utf-8"
    )
    outcome = cli("simulate", FULL, "--excitation", "base.csv", "--right-road", "bump.toml")
    assert outcome.exit_code == 2
    assert "--right-road: an excitation is already a function of time" in outcome.err


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("draw", FULL), "only a 3-D rig of one corner can be drawn"),
        (
            ("animate", FULL, "--report", "a.html", *DRIVE),
            "only a 3-D rig of one corner can be drawn",
        ),
        (("kinematics", HALF, "--travel", "0"), "a lumped rig has no kinematics"),
        (
            ("kinematics", "formula-student-car", "--travel", "0"),
            "only one corner can be swept at a time",
        ),
        (
            ("adjust", HALF, "--set", "spring_preload=1 N"),
            "only a corner with hardpoints can be adjusted",
        ),
    ],
)
def test_commands_for_corners_refuse_vehicles(cli, words: tuple[str, ...], message: str) -> None:
    outcome = cli(*words)
    assert outcome.exit_code == 2
    assert message in outcome.err
    assert len(outcome.err.splitlines()) == 1
    assert not list(Path().glob("*.png")) + list(Path().glob("*.html"))


def test_design_over_a_simulated_road_refuses_the_wheelbase(cli) -> None:
    """The rear axle's delay moves with it, which sensitivities along with the run do not see."""
    words = (
        "design",
        "optimise",
        HALF,
        "--free",
        "front.distance=1..1.6 m",
        "--objective",
        "body.az",
    )
    outcome = cli(*words, "--road", "bump.toml", "--speed", "10 m/s", "--duration", "1 s")
    assert outcome.exit_code == 2
    assert "rear axle meets the road" in outcome.err
