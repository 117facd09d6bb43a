"""Pages of runs, rides and models: what is on them of odd inputs, and how much of it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.design.pareto import ParetoFront, ParetoMark
from jounce.inspection.archive.history import Trend, WheelVisit
from jounce.report import (
    REPORTS,
    front_page,
    history_page,
    modes_page,
    recordings_page,
    ride_page,
    roughness_page,
)
from jounce.report.live import Curve, Pane, ViewerScene, live_data, scene_panels
from jounce.report.page import Page, PageTable, Paragraph
from jounce.report.render import with_break_points
from jounce.ride.study import RideStudy, iso_trial

HOSTILE = '<img src=x onerror="document.title=1">$\\alpha$'
LONG = "漢字" * 150


def run(samples: int = 50, channels: int = 0) -> xr.Dataset:
    time = np.arange(samples) / 1000.0
    known = np.sin(40.0 * time)
    gaps, infinite = known.copy(), known.copy()
    gaps[:5], infinite[7] = np.nan, np.inf
    named = {HOSTILE: known, LONG: gaps, "a.z": infinite, "b.z": np.full(samples, np.nan)}
    named |= {f"more_{k}.z": known + k for k in range(channels)}
    units = {"units": HOSTILE, "long_name": HOSTILE}
    return xr.Dataset(
        {name: ("time", y, units) for name, y in named.items()}, coords={"time": ("time", time)}
    )


def test_names_and_values_of_any_kind_are_shown_as_they_are(tmp_path: Path) -> None:
    page = recordings_page(
        {HOSTILE: run(), LONG: 2.0 * run()}, [HOSTILE, LONG, "a.z", "b.z"], title=HOSTILE
    )
    html = REPORTS.write(page, tmp_path / "a.html").read_text(encoding="utf-8")
    assert "<img" not in html
    assert LONG in html.replace("<wbr>", "")
    assert REPORTS.write(page, tmp_path / "a.pdf").read_bytes().startswith(b"%PDF")
    table = next(block for block in page.blocks() if isinstance(block, PageTable))
    rows = [[cell if isinstance(cell, str) else cell.text for cell in row] for row in table.rows]
    assert rows[6][3:7] == ["–"] * 4  # nothing is known of b.z
    assert "∞" not in "".join(rows[4]) + "".join(rows[5])  # an infinite value is no extreme


def test_a_page_holds_as_many_channels_as_it_can_and_says_what_is_left_out() -> None:
    page = recordings_page({"one": run(60_000, 40)}, ["a.z"], title="long")
    (viewer,) = page.viewers()
    assert "20 more channels do not fit" in viewer.caption
    assert len(viewer.scenes[0].panes) == 24
    assert len(live_data([viewer])["packed"]) < 4_000_000
    (longer,) = recordings_page({"one": run(200_000, 40)}, ["a.z"], title="longer").viewers()
    assert len(longer.scenes[0].panes) == 24


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("front.strut.deflection", "front.<wbr>strut.<wbr>deflection"),
        ("r.m.s. of m/s^1.75", "r.m.s. of m/s^1.75"),
        ("<b>a_b", "&lt;b&gt;a_b"),
    ],
)
def test_names_break_behind_their_dots_only(text: str, found: str) -> None:
    assert str(with_break_points(text)) == found


def texts(page: Page) -> str:
    return " ".join(block.text for block in page.blocks() if isinstance(block, Paragraph))


def test_rides_that_all_failed_are_a_page_that_says_so(tmp_path: Path) -> None:
    trial = iso_trial(jn.load("audi-a6-quarter-car"), "C", "20 m/s", duration="1 s")
    page = ride_page(RideStudy(trial, (), {HOSTILE: "the simulation diverged"}), title=HOSTILE)
    assert "No ride was completed." in texts(page)
    assert "was not run: the simulation diverged" in texts(page)
    assert "<img" not in REPORTS.write(page, tmp_path / "a.html").read_text(encoding="utf-8")


def test_a_model_without_modes_is_a_page_that_says_so() -> None:
    page = modes_page((), {"sprung.z": -0.01, "joint.q": 0.2}, title="still")
    assert "No oscillating mode" in texts(page)
    (table,) = (block for block in page.blocks() if isinstance(block, PageTable))
    assert table.rows == (("sprung.z", "mm", "−10.00"), ("joint.q", "SI", "0.2000"))


def test_a_profile_is_shown_over_metres_with_its_segments() -> None:
    x = np.arange(0.0, 60.0, 0.1)
    z = 0.01 * np.sin(x)
    found = jn.iri(x, z, segment="20 m")
    (viewer,) = roughness_page(found, x, z, found.findings, title="waves").viewers()
    (scene,) = viewer.scenes
    assert (viewer.words, viewer.unit) == ("distance", "m")
    assert scene.x == pytest.approx(x)
    height, index = (pane.curves[0].values for pane in scene.panes)
    assert height == pytest.approx(1e3 * z)
    assert index[[100, 300, 500]] == pytest.approx([part.iri_m_per_km for part in found.segments])


ROLES = ("comfort", "holding", "travel")


def test_a_front_has_its_units_ends_and_texts_that_are_no_markup(tmp_path: Path) -> None:
    values = {"comfort": np.array([1.0, 2.0, np.inf]), "holding": np.array([0.3, np.nan, 0.1])}
    names = dict(zip(ROLES, (HOSTILE, "tyre.force", "strut.deflection"), strict=True))
    front = ParetoFront(
        names,
        dict(zip(ROLES, ("m/s^2", "1", "m"), strict=True)),
        values["comfort"], values["holding"], np.array([0.01, 0.02, 0.03]),
        {"strut.damper.coefficient": np.array([500.0, 1000.0, 1500.0])}, {"strut.damper.coefficient": "N*s/m"},
        (ParetoMark("best for " + "漢" * 300, "searched", {"strut.damper.coefficient": 700.0}, 1.1, 0.2, 0.015),),
        False, "a road, G_d = 1e-6 m^3", (), names,
    )  # fmt: skip
    page = front_page(front, title=HOSTILE)
    beside, every = (block for block in page.blocks() if isinstance(block, PageTable))
    assert beside.rows[0][2:] == (
        "1.100",
        "0.2000",
        "15.00",
        "strut.damper.coefficient: 700.0 N·s/m",
    )
    assert [row[1] for row in every.rows] == ["1.000", "2.000", "∞"]
    assert every.rows[1][2] == "–"
    assert page.subtitle == f"Pareto front, {HOSTILE} to tyre.force, on a road, G_d = 1e-6 m³"
    text = REPORTS.write(page, tmp_path / "a.html").read_text(encoding="utf-8")
    assert "<img" not in text
    assert "some designs are not optimal" in text


def test_a_history_shows_what_is_not_known_as_such(tmp_path: Path) -> None:
    values = {"adhesion": 0.62, "phase_angle_min_deg": None, "theta_road": float("nan")}
    visits = [
        WheelVisit(1, "2025-11-21", HOSTILE, "rear", "left", values, "fail", ""),
        WheelVisit(2, "", HOSTILE, "", HOSTILE, {"adhesion": None}, "", ""),
    ]
    page = history_page(
        visits, [Trend("rear", "left", "adhesion", -0.104, 2)], title="B-AB 123 " + "漢" * 300
    )
    change, every = (block for block in page.blocks() if isinstance(block, PageTable))
    assert change.rows == (("rear left", "adhesion (EUSAMA)", "−10 %", "2"),)
    first, second = every.rows
    assert first[:5] == ("2025-11-21", "rear left", "62.0 %", "–", "–")
    assert (first[5].text, first[5].tone) == ("fail", "bad")  # type: ignore[union-attr]
    assert second[0] == second[2] == second[5] == "–"
    assert "<img" not in REPORTS.write(page, tmp_path / "a.html").read_text(encoding="utf-8")
    assert len(history_page([], [], title="nothing").sections) == 2


def test_titles_of_panels_keep_within_them() -> None:
    words = ("spring, stops, damper and friction, compression positive", "漢" * 300, "force")
    panes = tuple(
        Pane("strut.force", f"strut.force, {one}", "N", (Curve("", "after", np.zeros(2)),))
        for one in words
    )
    titles = [
        panel.title
        for panel in scene_panels(ViewerScene("a", "a", np.arange(2.0), panes), "time", "s")
    ]
    assert titles == [
        "strut.force, spring, stops, damper and friction",
        "strut.force",
        "strut.force, force",
    ]


def test_a_comparison_of_rides_shows_the_rear_axle_too() -> None:
    rig, controls = jn.load("audi-a6-half-car-4dof"), ["passive", "skyhook"]
    study = jn.compare_rides(rig, iso_trial(rig, "C", "20 m/s", duration="3 s"), controls)
    page = ride_page(study, title="Half car")
    viewer = next(block for block in page.blocks() if hasattr(block, "scenes"))
    shown = [pane.name for pane in viewer.scenes[0].panes if pane.shown]
    assert shown == [
        "front.road.z",
        "body.az",
        "front.strut.deflection",
        "rear.strut.deflection",
        "front.tyre.force",
        "rear.tyre.force",
    ]


def test_a_kinematic_report_has_the_usual_curves_the_drawing_and_the_hardpoints() -> None:
    from jounce.report.swept import swept_page

    rig = jn.load("formula-student-front")
    page = swept_page(jn.sweep_kinematics(rig, "-10 mm:10 mm:10 mm"), title="Front corner")
    viewer = next(block for block in page.blocks() if hasattr(block, "scenes"))
    shown = {pane.name for pane in viewer.scenes[0].panes if pane.shown}
    usual = {"toe", "camber", "caster", "kingpin_inclination", "scrub_radius", "half_track_change"}
    assert usual | {"roll_centre_height", "motion_ratio", "wheel_rate"} <= shown
    (section,) = (section for section in page.sections if section.title == "Mechanism")
    picture, table = section.blocks
    assert [axes.get_title(loc="left") or axes.get_title() for axes in picture.figure.axes][:3] == [
        "front view",
        "side view, from the left",
        "top view",
    ]
    rows = {name: place for name, *place in table.rows}
    assert rows["upper ball joint"] == ["−8.00", "545.00", "330.00"]
    assert len(rows) == len(list(rig.hardpoints)) - sum(
        place is None for _, place in rig.hardpoints
    )
