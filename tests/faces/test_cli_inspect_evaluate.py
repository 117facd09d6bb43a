"""``jounce inspect evaluate``: records of a lane graded, printed as protocols, kept in the store."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from jounce.inspection import read_record
from jounce.inspection.archive.entries import unpack
from jounce.inspection.archive.store import Store
from jounce.inspection.limits import shipped_limits
from jounce.inspection.quarter_car import (
    LinearQuarterCar,
    force_response,
    road_poles,
    steady_state,
    wheel_damping,
)
from jounce.parts.testers import load_tester

RATE, HOLD, SLOPE, PLATE_MASS = 1000.0, 2.0, 2.5, 20.0
SOUND, WORN = (
    LinearQuarterCar(330.0, 36.0, 22e3, 1300.0, 210e3),
    LinearQuarterCar(330.0, 36.0, 22e3, 380.0, 190e3),
)
ROWS = "\n".join(f"{i / 1000}, {i % 7}, {i % 11}" for i in range(50))
LIGHT = LinearQuarterCar(230.0, 32.0, 18e3, 1100.0, 240e3)


def plate(corner: LinearQuarterCar) -> tuple[np.ndarray, np.ndarray]:
    """Plate height (m) and plate force (N) of one wheel by its linear response, with the plate's inertia."""
    time = np.arange(int((HOLD + 25.0 / SLOPE + 0.8) * RATE)) / RATE - 0.4
    fall = np.clip(time - HOLD, 0.0, 25.0 / SLOPE)
    turns = np.where(time < HOLD, 25.0 * time, 25.0 * HOLD + 25.0 * fall - 0.5 * SLOPE * fall**2)
    height = np.where(time > 0.0, 3e-3 * np.sin(2.0 * np.pi * turns), 0.0)
    count = 4 * height.size
    frequency = np.fft.rfftfreq(count, 1.0 / RATE)
    response = np.zeros(frequency.size, dtype=complex)
    response[1:] = force_response(corner, frequency[1:])
    response -= PLATE_MASS * (2.0 * np.pi * frequency) ** 2
    force = np.fft.irfft(np.fft.rfft(height, count) * response, count)[: height.size]
    return height, corner.static_load + force


def write(name: str, left: LinearQuarterCar, right: LinearQuarterCar, axle: str = "front") -> Path:
    (zl, fl), (zr, fr) = plate(left), plate(right)
    still = np.zeros(zl.size)
    columns = [
        np.arange(2 * zl.size) / RATE,
        1e3 * np.concatenate([zl, still]),
        np.concatenate([fl, still + left.static_load]),
        1e3 * np.concatenate([still, zr]),
        np.concatenate([still + right.static_load, fr]),
    ]
    header = (
        f'# axle = "{axle}"\n# left.static_load = "{left.static_load} N"\n'
        f'# right.static_load = "{right.static_load} N"\n# wheel_order = "left, right"\n'
        '# vehicle = "Audi A6"\n# plate_number = "M-ÄÖ 12"\n# date = "2026-11-21"\n'
        "time [s], left.plate.z [mm], left.plate.force [N], right.plate.z [mm], right.plate.force [N]"
    )
    lines = [",".join(f"{value:.6g}" for value in row) for row in np.stack(columns, axis=1)]
    Path(name).write_text("\n".join([header, *lines, ""]), encoding="utf-8")
    return Path(name)


@pytest.fixture
def front(cli) -> Path:
    return write("front.csv", SOUND, WORN)


@pytest.fixture
def rear(cli) -> Path:
    return write("rear.csv", LIGHT, LIGHT, axle="rear")


TESTER = ("--tester", "egea-specsus2018")


def test_one_axle_as_json(cli, front: Path) -> None:
    found = cli("inspect", "evaluate", front, *TESTER, "--json")
    assert found.exit_code == 0
    plain = found.json
    left, right = plain["wheels"]
    assert (left["verdict"], right["verdict"], plain["axle"]["verdict"]) == ("pass", "fail", "fail")
    assert plain["axle"]["axle"] == "front"
    assert left["grade"] == {"eusama": "good", "egea": "sufficient", "theta": "green"}
    assert right["grade"]["egea"] == "too small"
    steady = steady_state(SOUND)
    assert left["adhesion"] == pytest.approx(
        steady.adhesion, abs=0.01
    )  # a run-down of 2.5 Hz/s rates it higher
    assert left["phase_angle_min_deg"] == pytest.approx(
        steady.phase_angle_min_deg, abs=3.0
    )  # and lower
    assert left["theta_road"] == pytest.approx(wheel_damping(road_poles(SOUND))[0], rel=1e-3)
    assert right["theta_road"] == pytest.approx(wheel_damping(road_poles(WORN))[0], rel=1e-3)
    assert plain["vehicle"]["verdict"] == "fail"
    assert plain["deciding"] == ["egea"]
    differences = plain["axle"]["differences"]["phase_angle_min_deg"]
    assert differences["grade"]["phase-angle"]["verdict"] == "fail"
    assert (plain["store"], plain["protocol"]) == (None, [])


def test_facts_of_the_command_line_count_before_those_of_the_header(cli, front: Path) -> None:
    given = (
        "--date",
        "2026-11-22",
        "--place",
        "Kempten",
        "--plate",
        "KE-AB 1",
        "--inspector",
        "A. Meier",
    )
    words = ("--report", "car.html,pdf", "--store", "lane.sqlite", "--json")
    plain = cli("inspect", "evaluate", front, *TESTER, *given, *words).json
    assert plain["protocol"] == ["car.html", "car.json", "car.pdf"]
    page = Path("car.html").read_text(encoding="utf-8")
    for text in ("2026-11-22", "Kempten", "KE-AB 1", "A. Meier"):
        assert f"<dd>{text}</dd>" in page
    assert "M-ÄÖ 12" in page  # the finding tells what the header said
    said = [one["message"] for one in plain["findings"] if one.get("code") == "overruled"]
    assert said == [
        "the header gives date '2026-11-21'; '2026-11-22' was given instead and is used.",
        "the header gives plate_number 'M-ÄÖ 12'; 'KE-AB 1' was given instead and is used.",
    ]
    assert Path("car.pdf").read_bytes().startswith(b"%PDF")
    (record,) = cli(
        "inspect", "search", "--store", "lane.sqlite", "--plate", "KEAB1", "--json"
    ).json["records"]
    assert (record["date"], record["plate"]) == ("2026-11-22", "KE-AB 1")
    refused = cli("inspect", "evaluate", front, *TESTER, "--date", "soon")
    assert (refused.exit_code, "not a date" in refused.err) == (2, True)


def test_people_get_values_grades_and_reasons(cli, front: Path) -> None:
    found = cli("inspect", "evaluate", front, *TESTER)
    assert found.exit_code == 0
    for text in (
        "least phase angle (EGEA)",
        "±",
        "too small",
        "front: fail",
        "Limits: EGEA SPECSUS2018",
        "jounce 1 (",
    ):
        assert text in found.out


def test_both_axles_with_protocols_of_both_kinds(cli, front: Path, rear: Path) -> None:
    words = ("--report", "car.pdf", "--report", "car.html", "--language", "de", "--json")
    found = cli("inspect", "evaluate", rear, front, *TESTER, *words)
    assert found.exit_code == 0
    plain = found.json
    assert [(one["axle"], one["wheel"]) for one in plain["wheels"]] == [
        ("front", "left"), ("front", "right"), ("rear", "left"), ("rear", "right"),
    ]  # fmt: skip
    assert [one["verdict"] for one in plain["axles"]] == ["fail", "pass"]
    assert plain["vehicle"]["verdict"] == "fail"
    assert plain["vehicle"]["differences"]["left"]["phase_angle_min_deg"]["absolute"] > 0.0
    assert plain["protocol"] == ["car.pdf", "car.json", "car.html"]
    assert Path("car.pdf").read_bytes().startswith(b"%PDF-")
    page = Path("car.html").read_text(encoding="utf-8")
    for text in ("Prüfprotokoll", "M-ÄÖ 12", "Hinterachse", "front.csv"):
        assert text in page
    assert json.loads(Path("car.json").read_text(encoding="utf-8"))["verdict"] == "fail"
    rear_reasons = " ".join(plain["wheels"][2]["reasons"])
    assert "the methods disagree" in rear_reasons  # a light car with sound dampers
    assert "adhesion depends on the load" in rear_reasons


def test_methods_that_are_asked_for_decide(cli, rear: Path) -> None:
    by_tester = cli("inspect", "evaluate", rear, *TESTER, "--json").json
    assert [one["verdict"] for one in by_tester["wheels"]] == ["pass", "pass"]
    by_adhesion = cli("inspect", "evaluate", rear, *TESTER, "--method", "eusama", "--json").json
    assert [one["verdict"] for one in by_adhesion["wheels"]] == ["fail", "fail"]
    assert by_adhesion["wheels"][0]["grade"].keys() == {"eusama"}


def test_other_limits_give_other_verdicts(cli, rear: Path) -> None:
    text = (
        shipped_limits()
        .read_text(encoding="utf-8")
        .replace("35 deg", "80 deg")
        .replace('"1"', '"strict-2"', 1)
    )
    Path("strict.toml").write_text(text, encoding="utf-8")
    found = cli("inspect", "evaluate", rear, *TESTER, "--limits", "strict.toml", "--json").json
    assert [one["verdict"] for one in found["wheels"]] == ["fail", "fail"]
    assert found["limits"]["version"] == "strict-2"


def test_records_and_results_are_kept(cli, front: Path) -> None:
    for _ in range(2):
        found = cli("inspect", "evaluate", front, *TESTER, "--store", "lane.sqlite", "--json")
        assert found.exit_code == 0
        assert found.json["store"] == {"location": "lane.sqlite", "records": [1]}
    store = Store("lane.sqlite", read_only=True)
    (kept,) = store.records()
    assert (kept.plate, kept.vehicle, kept.axle, kept.date) == (
        "M-ÄÖ 12",
        "Audi A6",
        "front",
        "2026-11-21",
    )
    assert store.content(1)[0] == front.read_bytes()
    gradings = store.gradings(1)
    assert [one.verdict for one in gradings] == ["fail", "fail"]
    assert gradings[0].limits.startswith("jounce 1 (")
    assert [one["verdict"] for one in gradings[0].result["wheels"]] == ["pass", "fail"]
    signals, findings = unpack(store.signals(1))
    read, said = read_record(front, load_tester("egea-specsus2018"))
    assert signals.identical(read)
    assert findings == said
    store.close()


def test_a_record_that_cannot_be_graded_is_kept_with_its_reasons(cli) -> None:
    height = 1e3 * 3e-3 * np.sin(2.0 * np.pi * 25.0 * np.arange(8000) / RATE)  # never runs down
    rows = "\n".join(
        f"{i / RATE:.3f}, {z:.4f}, {4000.0 + 100.0 * z:.1f}" for i, z in enumerate(height)
    )
    header = '# axle = "front"\n# left.static_load = "4000 N"\n'
    Path("hold.csv").write_text(
        f"{header}time [s], left.plate.z [mm], left.plate.force [N]\n{rows}\n", encoding="utf-8"
    )
    words = ("--store", "lane.sqlite", "--report", "hold.pdf", "--json")
    found = cli("inspect", "evaluate", "hold.csv", *TESTER, *words)
    assert found.exit_code == 2
    assert found.err.count("jounce: ") == 1
    assert "the left wheel cannot be graded" in found.err
    plain = found.json
    assert plain["wheels"][0]["verdict"] == "not graded"
    assert plain["wheels"][0]["grade"] == {}
    assert plain["error"]["message"] in found.err
    store = Store("lane.sqlite", read_only=True)
    (kept,) = store.records()
    assert kept.grading.verdict == "not graded"
    assert kept.grading.result["wheels"][0]["reasons"]
    store.close()
    assert Path("hold.pdf").read_bytes().startswith(b"%PDF-")


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (f"time [s], left.plate.z [mm], left.plate.force [lb]\n{ROWS}", "lbf"),
        (f"time [s], speed [m/s], way [m]\n{ROWS}", "the record has no plate force"),
        ("", "empty"),
    ],
)
def test_a_record_that_cannot_be_read_is_kept_too(cli, content: str, message: str) -> None:
    Path("bad.csv").write_text(content, encoding="utf-8")
    found = cli("inspect", "evaluate", "bad.csv", *TESTER, "--store", "lane.sqlite", "--json")
    assert found.exit_code == 2
    assert message in found.json["error"]["message"]
    store = Store("lane.sqlite", read_only=True)
    (kept,) = store.records()
    assert (kept.name, kept.grading.verdict) == ("bad.csv", "not graded")
    assert message in kept.grading.result["reasons"][0]
    assert store.content(kept.number)[0] == content.encode()
    store.close()


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("--method", "egae"), "unknown method 'egae'"),
        (("--method", "boge"), "unknown method of a rigid plate 'boge'"),
        (("--limits", "none.toml"), "none.toml: no such file"),
        (("--report", "car.docx"), "protocols are not written in this format"),
        (("--report", "none/car.pdf"), "the output folder does not exist"),
        (("--report", "there.pdf"), "the output already exists"),
        (("--report", "a.pdf", "--report", "a.pdf"), "given twice"),
        (("--language", "fr"), "unknown language 'fr'"),
        (("--store", "none/lane.sqlite"), "the folder of the store does not exist"),
        (("--vehicle", "no-such-car"), "no rig of that name"),
        (("front.csv",), "two records of the same axle"),
        (("a.csv", "b.csv"), "too many records"),
        (("missing.csv",), "missing.csv: no such file"),
    ],
)
def test_wrong_requests_end_with_one_message_and_nothing_written(
    cli, front: Path, words, message: str
) -> None:
    Path("there.pdf").write_text("mine", encoding="utf-8")
    before = sorted(Path().iterdir())
    found = cli("inspect", "evaluate", front, *TESTER, *words, "--json")
    assert found.exit_code == 2
    assert message in found.json["error"]["message"]
    assert sorted(Path().iterdir()) == before
    assert Path("there.pdf").read_text(encoding="utf-8") == "mine"


@pytest.mark.parametrize("tester", ["egae", "none.toml"])
def test_unknown_testers_are_refused(cli, front: Path, tester: str) -> None:
    found = cli("inspect", "evaluate", front, "--tester", tester, "--json")
    assert found.exit_code == 2
    assert tester in found.json["error"]["message"]


def test_a_limits_file_with_a_gap_is_refused_before_any_work(cli, front: Path) -> None:
    text = (
        shipped_limits()
        .read_text(encoding="utf-8")
        .replace("from = 0.10, to = 0.13", "from = 0.10, to = 0.12")
    )
    Path("gap.toml").write_text(text, encoding="utf-8")
    found = cli(
        "inspect", "evaluate", front, *TESTER, "--limits", "gap.toml", "--store", "lane.sqlite"
    )
    assert found.exit_code == 2
    assert "methods.theta.bands[2]: a gap from 0.12 to 0.13" in found.err
    assert not Path("lane.sqlite").exists()


def test_existing_protocols_are_replaced_with_force_only(cli, front: Path) -> None:
    Path("car.json").write_text("mine", encoding="utf-8")
    words = ("inspect", "evaluate", front, *TESTER, "--report", "car.html")
    assert cli(*words).exit_code == 2
    assert Path("car.json").read_text(encoding="utf-8") == "mine"
    assert cli(*words, "--force").exit_code == 0
    assert json.loads(Path("car.json").read_text(encoding="utf-8"))["schema"] == "jounce.protocol/1"


def test_the_vehicle_names_the_car_where_the_record_does_not(cli) -> None:
    write("front.csv", SOUND, SOUND)
    text = Path("front.csv").read_text(encoding="utf-8").replace('# vehicle = "Audi A6"\n', "")
    Path("front.csv").write_text(text, encoding="utf-8")
    found = cli(
        "inspect",
        "evaluate",
        "front.csv",
        *TESTER,
        "--vehicle",
        "audi-a6-quarter-car",
        "--report",
        "a.html",
    )
    assert found.exit_code == 0
    assert "audi-a6-quarter-car" in Path("a.html").read_text(encoding="utf-8")
    assert "is not that of the vehicle file" in found.out  # 366 kg on a wheel of 505 kg


def test_an_evaluation_that_fails_loses_no_record(
    cli, front: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from jounce.inspection.archive import lane

    def fail(*_arguments: object) -> None:
        raise ZeroDivisionError("somewhere")

    monkeypatch.setattr(lane, "evaluate", fail)
    found = cli("inspect", "evaluate", front, *TESTER, "--store", "lane.sqlite", "--json")
    assert found.exit_code == 1
    store = Store("lane.sqlite", read_only=True)
    (kept,) = store.records()
    assert kept.grading.verdict == "not graded"
    assert store.content(1)[0] == front.read_bytes()
    store.close()


def test_a_wrong_request_keeps_nothing(cli, front: Path) -> None:
    found = cli(
        "inspect",
        "evaluate",
        front,
        *TESTER,
        "--method",
        "boge",
        "--store",
        "lane.sqlite",
        "--json",
    )
    assert found.exit_code == 2
    store = Store("lane.sqlite", read_only=True)
    assert store.records() == []
    store.close()
