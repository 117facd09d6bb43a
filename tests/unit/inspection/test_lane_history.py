"""Trends of one vehicle and tables of results."""

from __future__ import annotations

import csv
import json
from dataclasses import replace
from pathlib import Path

import pytest

import jounce as jn
from jounce.core.errors import OutputError, RecordingError
from jounce.core.optional import MissingPackageError
from jounce.inspection.archive import exporting, reevaluation
from jounce.inspection.archive.entries import Grading, RecordEntry
from jounce.inspection.archive.exporting import COLUMNS, export, rows_of
from jounce.inspection.archive.history import WheelVisit, history_of, trends_of
from jounce.inspection.archive.lane import entry_of, import_record, stored_tester, warnings_of
from jounce.inspection.archive.reevaluation import Reevaluation, reevaluate
from jounce.inspection.archive.store import Store
from jounce.inspection.limits import load_limits, shipped_limits
from jounce.parts import rig_from_table
from jounce.parts.testers import load_tester

WHEEL = {
    "wheel": "left", "verdict": "advise", "reasons": ['adhesion "low", 30 %.', "Second, one."], "lift_off": False,
    "phase_angle_min_deg": 41.5, "theta_road": 0.11, "uncertainty": {"adhesion": 0.01}, "grade": {"eusama": "poor"},
}  # fmt: skip


@pytest.fixture
def store(tmp_path: Path) -> Store:
    found = Store(tmp_path / "lane.sqlite")
    for year, adhesion in ((2025, 0.4), (2023, 0.6), (2024, 0.5)):
        wheels = [
            {**WHEEL, "adhesion": adhesion},
            {**WHEEL, "wheel": "right", "adhesion": None, "theta_road": 0.2},
        ]
        entry = RecordEntry(
            f"{year}.csv", str(year).encode(), plate="B-AB 1", date=f"{year}-06-01", axle="rear"
        )
        found.accept(entry, Grading("advise", "limits 1", "0.1", {"wheels": wheels}))
    unread = Grading(
        "not graded", "limits 1", "0.1", {"wheels": [], "reasons": ["the header is missing."]}
    )
    found.accept(RecordEntry("x.csv", b"x", plate="B-AB 1", date="2026-06-01"), unread)
    return found


def test_history_is_by_date_and_its_slope_right(store) -> None:
    visits = history_of(store, "bab 1")
    assert [visit.values["adhesion"] for visit in visits if visit.wheel == "left"] == [
        0.6,
        0.5,
        0.4,
    ]
    trends = {(one.wheel, one.quantity): one for one in trends_of(visits)}
    assert trends["left", "adhesion"].change_per_year == pytest.approx(
        -0.1, abs=2e-4
    )  # 2024 is a leap year
    assert trends["left", "theta_road"].change_per_year == pytest.approx(0.0, abs=1e-12)
    assert ("right", "adhesion") not in trends
    assert trends["right", "theta_road"].visits == 3
    assert trends_of(visits[:2]) == []  # one day is no trend


def test_csv_has_a_row_for_each_wheel_and_one_for_what_could_not_be_read(
    store, tmp_path: Path
) -> None:
    file = export(rows_of(store.records()), tmp_path / "lane.csv")
    rows = list(csv.DictReader(file.read_text(encoding="utf-8").splitlines()))
    assert len(rows) == 7
    assert tuple(rows[0]) == COLUMNS
    assert (rows[0]["adhesion"], rows[0]["adhesion_half_width"], rows[0]["grade_eusama"]) == (
        "0.6",
        "0.01",
        "poor",
    )
    assert rows[0]["reasons"] == 'adhesion "low", 30 %. Second, one.'
    assert (rows[6]["wheel"], rows[6]["verdict"], rows[6]["reasons"]) == (
        "",
        "not graded",
        "the header is missing.",
    )
    with pytest.raises(OutputError, match="exists"):
        export([], file)


def test_an_axle_that_fails_with_wheels_that_pass_says_why_in_the_table(tmp_path: Path) -> None:
    wheels = [
        {**WHEEL, "wheel": side, "verdict": "pass", "reasons": ["good."]}
        for side in ("left", "right")
    ]
    store = Store(tmp_path / "lane.sqlite")
    store.accept(
        RecordEntry("a.csv", b"a"),
        Grading(
            "fail",
            "limits 1",
            "0.1",
            {"wheels": wheels, "reasons": ["difference left to right 19 deg: fail."]},
        ),
    )
    rows = rows_of(store.records())
    assert [(row["verdict"], row["reasons"]) for row in rows] == [("pass", "good.")] * 2
    assert {row["axle_reasons"] for row in rows} == {"difference left to right 19 deg: fail."}


def test_what_weakens_a_value_is_in_the_table_and_no_trend_is_drawn_from_it(tmp_path: Path) -> None:
    def said(severity: str, message: str) -> dict:
        return {"place": "left", "severity": severity, "message": message}

    lifted = {
        "unreliable": ["phase_angle_min_deg", "phase_frequency_hz"],
        "phase_angle_min_deg": -11.0,
    }
    found = {
        **WHEEL,
        **lifted,
        "findings": [said("warning", "the tyre lifts."), said("problem", "unfit.")],
    }
    store = Store(tmp_path / "lane.sqlite")
    for year, wheel in ((2023, WHEEL), (2024, found), (2025, WHEEL)):
        result = {"wheels": [wheel], "findings": [said("warning", "no date.")]}
        entry = RecordEntry(
            f"{year}.csv", str(year).encode(), plate="B-AB 1", date=f"{year}-06-01", axle="rear"
        )
        store.accept(entry, Grading("fail", "limits 1", "0.1", result))
    rows = rows_of(store.records())
    assert [row["findings"] for row in rows] == ["no date.", "the tyre lifts. no date.", "no date."]
    assert [warnings_of(record.grading) for record in store.records()] == [1, 2, 1]
    visits = history_of(store, "B-AB 1")
    assert [visit.unreliable for visit in visits] == [(), ("phase_angle_min_deg",), ()]
    trend = next(one for one in trends_of(visits) if one.quantity == "phase_angle_min_deg")
    assert (trend.visits, trend.change_per_year) == (2, pytest.approx(0.0, abs=1e-12))


def test_parquet_has_types_and_units(store, tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    file = export(rows_of(store.records()), tmp_path / "lane.parquet")
    found = parquet.read_table(file)
    assert found.num_rows == 7
    assert found.schema.field("tyre_rigidity").metadata == {b"unit": b"N/m"}
    assert found["adhesion"].to_pylist()[:2] == [0.6, None]
    assert found["lift_off"].to_pylist()[-1] is None
    assert json.dumps(found["number"].to_pylist()) == "[2, 2, 3, 3, 1, 1, 4]"


def test_parquet_without_its_package_says_what_to_install(tmp_path: Path, monkeypatch) -> None:
    def missing(module: str, extra: str) -> None:
        raise MissingPackageError(
            f"the package {module!r} is not installed", hint=f"jounce[{extra}]"
        )

    monkeypatch.setattr(exporting, "require", missing)
    with pytest.raises(MissingPackageError, match=r"jounce\[lane\]"):
        export([], tmp_path / "lane.parquet")
    with pytest.raises(OutputError, match=r"allowed: \.csv, \.parquet"):
        export([], tmp_path / "lane.xls")
    assert list(tmp_path.iterdir()) == []


def test_descriptions_that_a_store_keeps_are_read_again(tmp_path: Path) -> None:
    record = tmp_path / "2025.csv"
    record.write_text("# axle = 'rear'\ntime [s]\n0\n", encoding="utf-8")
    tester, car = load_tester("boge"), jn.load("audi-a6-quarter-car")
    kept = entry_of(record, tester=tester, vehicle=car)
    assert stored_tester(json_again(kept, "tester_table")) == tester
    assert rig_from_table(json_again(kept, "vehicle_table").vehicle_table) == car
    assert reevaluation.stored_vehicle(json_again(kept, "vehicle_table")) == car
    assert reevaluation.stored_vehicle(entry_of(record, tester=tester)) is None


def json_again(entry: RecordEntry, name: str) -> RecordEntry:
    return replace(entry, **{name: json.loads(json.dumps(getattr(entry, name)))})


def test_history_is_drawn(store, tmp_path: Path) -> None:
    from jounce.plots.inspection import vehicle_history

    figure = vehicle_history(history_of(store, "B-AB 1"))
    adhesion = figure.axes[0].lines[0]
    assert list(adhesion.get_ydata()) == [60.0, 50.0, 40.0]
    assert figure.axes[0].get_ylim()[1] > 60.0
    vehicle_history([])


def test_values_below_zero_are_within_the_picture() -> None:
    from jounce.plots.inspection import vehicle_history

    values = {"adhesion": 0.0, "phase_angle_min_deg": -9.0, "theta_road": 0.05}
    figure = vehicle_history(
        [WheelVisit(1, "2026-11-21", "B-AB 1", "front", "left", values, "fail", "")]
    )
    low, high = figure.axes[1].get_ylim()
    assert low < -9.0 < high
    assert all(axes.get_ylim()[0] == 0.0 for axes in (figure.axes[0], figure.axes[2]))


def test_an_unreliable_value_is_told_from_the_others_wherever_a_history_is_shown() -> None:
    from rich.console import Console

    from jounce.cli.terminal import show_page
    from jounce.plots.inspection import vehicle_history
    from jounce.report.history import history_page

    def visit(record: int, angle: float, unreliable: tuple[str, ...] = ()) -> WheelVisit:
        values = {"adhesion": 0.4, "phase_angle_min_deg": angle, "theta_road": 0.1}
        return WheelVisit(
            record,
            f"{2022 + record}-06-01",
            "B-AB 1",
            "rear",
            "left",
            values,
            "fail",
            "",
            unreliable,
        )

    sound = [visit(1, 41.0), visit(2, 42.0)]
    visits = [*sound, visit(3, -11.0, ("phase_angle_min_deg",))]
    adhesion, phase, _ = vehicle_history(visits).axes
    assert [len(axes.lines) for axes in (adhesion, phase)] == [1, 2]
    assert (list(phase.lines[1].get_ydata()), phase.lines[1].get_markerfacecolor()) == (
        [-11.0],
        "white",
    )
    assert ["hollow" in axes.get_title("left") for axes in (adhesion, phase)] == [False, True]
    (table,) = history_page(visits, [], title="B-AB 1").sections[1].blocks
    assert [["unreliable" in str(cell) for cell in row].index(True) for row in table.rows[2:]] == [
        3
    ]
    assert not any("unreliable" in str(row) for row in table.rows[:2])
    with (console := Console(width=120)).capture() as shown:
        show_page(console, history_page(visits, [], title="B-AB 1"))
    assert [
        line.split()[0] for line in shown.get().splitlines() if "−11.0° (unreliable)" in line
    ] == ["2025-06-01"]


def test_records_are_evaluated_again_by_the_tester_they_came_with(
    tmp_path: Path, twin, eusama, monkeypatch
) -> None:
    """One whose tester nobody knew, one that came with its tester, one that cannot be read; all on one process."""
    car = twin.Car()
    time, height, force, _ = twin.rigid_record(car, twin.Programme(), mp=eusama.plate_mass, fine=4)
    rows = [f"{t:.3f}, {1e3 * z:.6f}, {f:.3f}" for t, z, f in zip(time, height, force, strict=True)]
    head = f'# left.static_load = "{car.static_load} N"\ntime [s], left.plate.z [mm], left.plate.force [N]\n'
    lane = Store(tmp_path / "lane.sqlite")
    found = []
    for name, text, tester in (
        ("unknown", head + "\n".join(rows), None),
        ("known", "# axle = 'rear'\n" + head + "\n".join(rows), eusama),
        ("broken", head, eusama),
    ):
        (tmp_path / f"{name}.csv").write_text(text, encoding="utf-8")
        found.append(import_record(tmp_path / f"{name}.csv", lane, tester))
    assert [one.verdict for one in found] == ["not graded", "pass", "not graded"]
    said: list[tuple[int, int]] = []
    asked = eusama.model_copy(
        update={"plate_mass": eusama.plate_mass + 0.5}
    )  # of the first record only
    first = reevaluate(lane, tester=asked, workers=1, say=lambda done, of: said.append((done, of)))
    assert first == Reevaluation(3, 1, 2, {("not graded", "pass"): 1}, (1,), {})
    assert said == [(3, 3)]
    again = reevaluate(lane, tester=asked, workers=1, from_files=True)
    assert again == Reevaluation(3, 0, 3)
    strict = shipped_limits().read_text(encoding="utf-8").replace('version = "1"', 'version = "2"')
    (tmp_path / "own.toml").write_text(strict, encoding="utf-8")
    other = reevaluate(lane, load_limits(tmp_path / "own.toml"), tester=asked, workers=1)
    assert (other.added, other.changes) == (3, {})
    assert [len(lane.gradings(number)) for number in (1, 2, 3)] == [3, 2, 2]

    def lost(*_: object) -> None:
        raise RecordingError("record is damaged")

    monkeypatch.setattr(Store, "content", lost)
    failing = reevaluate(lane, tester=asked, workers=1, from_files=True)
    assert (failing.added, failing.unchanged, sorted(failing.failed)) == (0, 0, [1, 2, 3])
    assert [len(lane.gradings(number)) for number in (1, 2, 3)] == [3, 2, 2]
