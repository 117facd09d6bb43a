"""``jounce ride`` and ``jounce compare``: answers, files, and what one can get wrong."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from jounce.ride.study import MERITS, all_controls

CAR = "audi-a6-half-car-4dof"
SHORT = ("--road", "iso:C", "--speed", "20 m/s", "--duration", "5 s")


def test_json_of_a_ride_holds_metrics_by_place(cli) -> None:
    outcome = cli("ride", CAR, *SHORT, "--json")
    assert outcome.exit_code == 0, outcome.err
    found = outcome.json
    assert (found["vehicle"], found["road"], found["speed"], found["failed"]) == (
        CAR,
        "iso:C",
        20.0,
        {},
    )
    assert found["duration"] - found["settling"] == pytest.approx(5.0)
    run = found["runs"][0]
    assert (run["control"], run["status"]) == ("passive", "completed")
    assert run["merits"]["comfort"] == run["metrics"]["weighted_rms"]["body.az"]
    assert run["merits"]["travel"] == max(run["metrics"]["travel_rms"].values())
    assert set(run["metrics"]["tyre_deflection_rms"]) == {"front", "rear"}


def test_stationary_response_stands_beside_the_simulated_one(cli) -> None:
    found = cli(
        "ride", CAR, "--road", "iso:B", "--speed", "20 m/s", "--duration", "60 s", "--json"
    ).json
    linear, simulated = found["stationary"]["standard_deviation"], found["runs"][0]["metrics"]
    for channel in ("body.az", "front.unsprung.az"):
        assert simulated["rms_acceleration"][channel] == pytest.approx(linear[channel], rel=0.03)
    text = cli("ride", CAR, "--road", "iso:B", "--speed", "20 m/s", "--duration", "5 s").out
    assert "linear model" in text
    share = found["stationary"]["by_chance"]["body.az"]
    assert 0.0 < share < 0.1
    row = next(line for line in text.splitlines() if "body.az" in line and "±" in line)
    shown = 0.01 * float(row.split("±")[1].split("%")[0])
    assert shown == pytest.approx(share * (60.0 / 5.0) ** 0.5, rel=0.05)  # the root of the time


@pytest.mark.parametrize("is_level", [True, False])
def test_the_front_axle_rolls_on_for_a_wheelbase(is_level: bool, cli, tmp_path: Path) -> None:
    import jounce as jn

    last = 0.0 if is_level else 5.0  # mm
    rows = "\n".join(
        f"{0.05 * i:.2f}, {10 * np.sin(0.05 * np.pi * i) + last * i / 400:.6f}" for i in range(401)
    )
    (tmp_path / "road.csv").write_text(f"x [m], z [mm]\n{rows}\n", encoding="utf-8")
    drive = ("ride", CAR, "--road", "road.csv", "--speed", "5 m/s")
    outcome = cli(*drive, "--out", "run.nc")
    assert outcome.exit_code == 0, outcome.err
    run, _ = jn.read_recording(tmp_path / "run.nc")
    end = float(run["time"][-1])
    assert end == pytest.approx((20.0 + is_level * jn.load(CAR).wheelbase) / 5.0, abs=1.1e-3)
    beyond = run["front.road.z"].sel(time=slice(20.0 / 5.0, None))
    assert float(abs(beyond - 1e-3 * last).max()) < 1e-6
    refused = cli(*drive, "--duration", f"{end + 0.01} s")
    assert refused.exit_code == 2
    assert "duration: the road is shorter than the run" in refused.err


@pytest.mark.parametrize("command", ["ride", "compare"])
def test_help_says_how_far_a_road_is_driven(command: str, cli) -> None:
    assert "a wheelbase beyond it" in " ".join(cli(command, "--help").out.replace("│", " ").split())


def test_several_controls_and_a_picture(cli, tmp_path: Path) -> None:
    outcome = cli("ride", CAR, *SHORT, "--control", "passive,skyhook", "--figure", "spectra.png")
    assert outcome.exit_code == 0, outcome.err
    assert "skyhook" in outcome.out
    assert (tmp_path / "spectra.png").stat().st_size > 10_000
    assert cli("ride", CAR, *SHORT, "--control", "skyhook", "--figure", "one.svg").exit_code == 0
    assert f"{CAR}, skyhook, on iso:C" in (tmp_path / "one.svg").read_text(encoding="utf-8")
    refused = cli("ride", CAR, *SHORT, "--figure", "spectra.png")
    assert refused.exit_code == 2
    assert "exists" in refused.err


def test_the_recording_is_written(cli, tmp_path: Path) -> None:
    import jounce as jn

    assert cli("ride", CAR, *SHORT, "--control", "skyhook", "--out", "run.nc").exit_code == 0
    run, _ = jn.read_recording(tmp_path / "run.nc")
    assert {"body.az", "front.command", "rear.actuator.force"} <= set(map(str, run.data_vars))
    assert float(run["front.command"].max()) > 0.0


def test_skyhook_is_more_comfortable_and_the_table_says_so(cli) -> None:
    outcome = cli(
        "compare",
        CAR,
        "--control",
        "passive",
        "--control",
        "skyhook",
        "--duration",
        "10 s",
        "--json",
    )
    passive, skyhook = (run["merits"] for run in outcome.json["runs"])
    assert skyhook["comfort"] < 0.85 * passive["comfort"]
    assert set(passive) == {merit.name for merit in MERITS}
    text = cli(
        "compare", CAR, "--control", "passive", "--control", "skyhook", "--duration", "5 s"
    ).out
    assert "smaller is better" in text


def test_a_law_that_does_not_fit_is_listed_beside_those_that_do(cli) -> None:
    outcome = cli(
        "compare",
        "audi-a6-half-car",
        "--control",
        "passive,groundhook",
        "--duration",
        "3 s",
        "--json",
    )
    assert outcome.exit_code == 0
    assert "unsprung.vz" in outcome.json["failed"]["groundhook"]
    assert (
        cli("compare", "audi-a6-half-car", "--control", "groundhook", "--duration", "3 s").exit_code
        == 2
    )


def test_all_stands_for_every_controller() -> None:
    names = all_controls()
    assert names[0] == "passive"
    assert {
        "skyhook",
        "groundhook",
        "hybrid",
        "add",
        "sh-add",
        "lqr",
        "lqg",
        "h-infinity",
        "mpc",
        "pid",
    } <= set(names)
    assert len(set(names)) == len(names)


def test_a_measured_road_is_driven_to_its_end_under_both_tracks(cli) -> None:
    outcome = cli(
        "ride",
        "audi-a6-full-car",
        "--road",
        "detrended_rms_course_1in",
        "--speed",
        "10 m/s",
        "--json",
    )
    found = outcome.json
    assert found["duration"] == pytest.approx((504.75 + 2.91) / 10.0, abs=1e-3)
    assert found["settling"] == pytest.approx(0.291)
    assert "stationary" not in found


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("ride", CAR, "--road", "iso:Z", "--speed", "20 m/s"), ("'Z'", "A, B, C")),
        (("ride", CAR, "--road", "iso:C", "--speed", "-20 m/s"), ("--speed", "above 0")),
        (("ride", CAR, "--road", "iso:C", "--speed", "20 kg"), ("--speed", "kg")),
        (("ride", CAR, *SHORT, "--control", "skyhok"), ("skyhok", "Did you mean 'skyhook'?")),
        (("ride", CAR, "--road", "nowhere.crg", "--speed", "20 m/s"), ("nowhere.crg",)),
        (("ride", CAR, *SHORT, "--out", "run.xls"), (".xls", ".nc, .csv")),
        (
            ("ride", CAR, *SHORT, "--control", "passive,skyhook", "--out", "run.nc"),
            ("--out", "one"),
        ),
        (("compare", CAR, "--figure", "picture.gif"), (".svg, .png, .pdf",)),
        (("compare", "no-car"), ("no-car",)),
        (("compare", CAR, "--control", ""), ("--control", "no controller")),
        (
            ("ride", CAR, "--road", "iso:C:7", "--seed", "3", "--speed", "20 m/s"),
            ("--seed", "two different seeds"),
        ),
    ],
)
def test_what_is_wrong_is_said_once(
    cli, tmp_path: Path, arguments: tuple[str, ...], words: tuple[str, ...]
) -> None:
    outcome = cli(*arguments)
    assert outcome.exit_code == 2
    assert outcome.err.count("\n") == 1
    for word in words:
        assert word in outcome.err
    assert list(tmp_path.iterdir()) == []


def test_a_road_may_name_its_seed(cli) -> None:
    drive = ("--speed", "20 m/s", "--duration", "3 s", "--json")
    said, chosen = (
        cli("ride", CAR, "--road", "ISO:c:7", *drive),
        cli("ride", CAR, "--road", "iso:C", "--seed", 7, *drive),
    )
    assert said.json["seed"] == chosen.json["seed"] == 7
    assert said.json["runs"] == chosen.json["runs"]


def test_tracks_of_a_full_car_differ(cli) -> None:
    metrics = cli("ride", "audi-a6-full-car", *SHORT, "--json").json["runs"][0]["metrics"]
    loads = metrics["dynamic_load_rms"]
    assert len(loads) == 4
    assert np.isfinite(metrics["rms_angular_acceleration"]["body.roll_acceleration"])
    assert abs(loads["front_left"] / loads["front_right"] - 1.0) > 1e-3


def _course(tmp_path: Path, spacing: float, length: float) -> str:
    x = np.arange(0.0, length, spacing)
    rows = "\n".join(f"{a:.4f}, {0.01 * np.sin(a) + 0.0003 * a:.6f}" for a in x)
    (tmp_path / "course.csv").write_text(f"x [m], z [m]\n{rows}\n", encoding="utf-8")
    return "course.csv"


def test_a_road_shorter_than_the_run_is_refused(cli, tmp_path: Path) -> None:
    course = _course(tmp_path, 0.1, 60.0)
    for words in (("ride", CAR, "--road", course), ("simulate", CAR, "--road", course)):
        outcome = cli(*words, "--speed", "20 m/s", "--duration", "30 s")
        assert outcome.exit_code == 2
        assert "shorter than the run" in outcome.err
        assert "600 m" in outcome.err or "597" in outcome.err
    assert (
        cli("ride", CAR, "--road", course, "--speed", "10 m/s", "--duration", "5 s").exit_code == 0
    )


def test_points_too_far_apart_for_the_speed_are_refused(cli, tmp_path: Path) -> None:
    outcome = cli("ride", CAR, "--road", _course(tmp_path, 1.0, 200.0), "--speed", "20 m/s")
    assert outcome.exit_code == 2
    assert "too far apart" in outcome.err
    assert "10 Hz" in outcome.err


def test_help_names_every_controller(cli):
    from jounce.control import CONTROLS

    text = " ".join(cli("compare", "--help").out.replace("│", " ").split())
    for name in CONTROLS:
        assert name in text


def test_a_measured_record_gives_metrics_and_what_is_doubtful_of_it(cli, tmp_path: Path) -> None:
    time = np.arange(6000) / 200.0
    noise = np.random.default_rng(2).normal(size=time.size)
    body = np.convolve(noise, np.ones(3) / 3.0, mode="same")
    rows = "\n".join(
        f"{t:.3f},{9.81 + b:.5f},{0.2 * w:.5f}" for t, b, w in zip(time, body, noise, strict=True)
    )
    (tmp_path / "lap.csv").write_text(
        f"time [s],AccZ [m/s^2],unsprung.az [m/s^2]\n{rows}\n", encoding="utf-8"
    )
    record = ("ride-metrics", "lap.csv", "--columns", "sprung.az=AccZ")
    found = cli(*record, "--settling", "2 s", "--json").json
    assert found["duration"] == pytest.approx(27.995)
    assert 0.1 < found["metrics"]["weighted_rms"]["sprung.az"] < 1.0
    assert [one["message"] for one in found["findings"] if "swapped" in one["message"]]
    text = cli(*record).out
    assert "sprung.az: its r.m.s. value is" in text
    assert "comfortable" in text
    refused = cli("ride-metrics", "lap.csv", "--columns", "sprung.az=Acc")
    assert refused.exit_code == 2
    assert "no column 'Acc'" in refused.err


def test_a_text_without_a_header_takes_its_names_in_order(cli, tmp_path):
    rows = "".join(f"{k / 500} {0.5 * (-1) ** (k // 50)}\n" for k in range(2000))
    (tmp_path / "plain.txt").write_text(rows, encoding="utf-8")
    done = cli("ride-metrics", "plain.txt", "--columns", "time [s], seat.az [m/s^2]", "--json")
    assert done.exit_code == 0, done.err
    assert done.json["metrics"]
    refused = cli("ride-metrics", "plain.txt", "--columns", "seat.az")
    assert refused.exit_code == 2
    assert "not NAME=VALUE" in refused.err
