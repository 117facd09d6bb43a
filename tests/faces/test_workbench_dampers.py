"""The page Dampers: from records of a test rig to the map, its curve between clicks, and what is exported."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import jounce as jn

pytest.importorskip("fastapi")

TOKEN = "a-token-of-dampers"
AXE = Path(__file__).parents[2] / "viewer" / "node_modules" / "axe-core" / "axe.min.js"
RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa"]


def rebound_rate(clicks: float) -> float:
    """Rate in rebound (N s/m) of the damper of these tests, whose clicks soften it evenly."""
    return 2000.0 * (1.0 - 0.05 * clicks)


def record(speed: float, clicks: int) -> Any:
    t = np.arange(0.0, 4.0, 2e-3)
    x, v = 0.02 * np.sin(speed / 0.02 * t), speed * np.cos(speed / 0.02 * t)
    force = 120.0 + np.where(v > 0.0, 900.0, rebound_rate(clicks)) * v
    force += np.random.default_rng(clicks).normal(0.0, 2.0, t.size)
    channels = {
        "displacement": (x, "m", ""),
        "velocity": (v, "m/s", ""),
        "force": (force, "N", ""),
    }
    return jn.recording(t, channels)


def written(folder: Path) -> Path:
    """A folder of nine records of three settings, and a file that is none."""
    folder.mkdir()
    for clicks in (0, 4, 8):
        for speed in (0.1, 0.2, 0.4):
            jn.write_recording(record(speed, clicks), folder / f"{clicks}clicks_{speed}.csv")
    (folder / "notes.csv").write_text("a,b\n1,x\n")
    return folder


def test_curves_between_clicks_are_over_the_axis_of_all_settings(tmp_path: Path) -> None:
    from jounce.web.damper_maps import map_curves

    curves = map_curves(jn.damper_map([written(tmp_path / "dyno")]))
    assert [item["label"] for item in curves["settings"]] == ["0 clicks", "4 clicks", "8 clicks"]
    between = {item["clicks"]: item for item in curves["between"]}
    assert min(between) == 0.0
    assert max(between) == 8.0
    at = int(np.argmin(curves["velocity"]))
    rate = between[2.0]["force"][at] / curves["velocity"][at]
    assert abs(rate - rebound_rate(2.0)) < 30.0
    assert (
        between[2.0]["low"][at]
        < rebound_rate(2.0) * curves["velocity"][at]
        < between[2.0]["high"][at]
    )


def test_a_map_of_one_setting_has_no_curves_between_clicks(tmp_path: Path) -> None:
    from jounce.web.damper_maps import map_curves

    records = [jn.RecordFile(f"{speed}.csv", record(speed, 0)) for speed in (0.1, 0.2, 0.4)]
    curves = map_curves(jn.damper_map(records))
    assert curves["between"] == []
    assert len(curves["settings"]) == 1
    assert len(curves["settings"][0]["force"]) == len(curves["velocity"])


@pytest.mark.parametrize(
    "task",
    [
        {"kind": "damper-map", "files": ["../dyno"]},
        {"kind": "damper-map", "files": ["dyno"], "settings": "none.csv"},
        {"kind": "damper-compare", "first": "dyno", "second": "/etc/passwd"},
        {"kind": "damper-clicks", "damper_map": "none", "bump": "0.7"},
        {"kind": "damper-sheet", "maps": []},
    ],
)
def test_files_outside_the_project_or_missing_are_refused(
    tmp_path: Path, task: dict[str, Any]
) -> None:
    from jounce.core.errors import JounceError
    from jounce.web.project import Project
    from jounce.web.tasks import spec_of, task_of

    (tmp_path / "dyno").mkdir()
    with pytest.raises(JounceError):
        spec_of(task_of(task), Project(tmp_path))


@pytest.mark.parametrize(
    ("task", "command"),
    [
        (
            {"kind": "damper-map", "files": ["dyno"], "reading": "peak"},
            "jounce damper map dyno --reading=peak",
        ),
        (
            {"kind": "damper-clicks", "damper_map": "dyno", "target": "rig.toml"},
            "jounce damper clicks dyno --target=rig.toml",
        ),
        (
            {"kind": "damper-compare", "first": "dyno", "second": "lap.csv", "tolerance": "5 %"},
            "jounce damper compare dyno lap.csv '--tolerance=5 %'",
        ),
        (
            {"kind": "damper-sheet", "maps": ["dyno", "lap.csv"]},
            "jounce damper sheet dyno lap.csv",
        ),
        (
            {"kind": "damper-histogram", "records": ["lap.csv"], "by": "sectors"},
            "jounce damper histogram lap.csv --by=sectors",
        ),
    ],
)
def test_a_form_is_a_command(tmp_path: Path, task: dict[str, Any], command: str) -> None:
    from jounce.core.commands import command_line
    from jounce.web.project import Project
    from jounce.web.tasks import spec_of, task_of

    (tmp_path / "dyno").mkdir()
    for name in ("rig.toml", "lap.csv"):
        (tmp_path / name).touch()
    spec = spec_of(task_of(task), Project(tmp_path))
    assert (spec.command or command_line(["jounce", *spec.words])) == command


@pytest.mark.pages
def test_a_folder_becomes_a_map_with_a_curve_between_clicks(
    browser: Any, workbench: tuple[Path, int]
) -> None:
    folder, port = workbench
    written(folder / "dyno")
    context = browser.new_context(viewport={"width": 1280, "height": 900})
    context.set_default_timeout(120_000)
    page = context.new_page()
    page.goto(f"http://127.0.0.1:{port}/?token={TOKEN}#/dampers")
    page.get_by_label("Folder of records").select_option("dyno")
    page.get_by_role("button", name="Map the damper").click()
    slider = page.get_by_label("Clicks", exact=True)
    slider.wait_for()
    page.get_by_text("Settings, with 95 % intervals").wait_for()
    page.get_by_text(
        "the column of the force cannot be told"
    ).first.wait_for()  # a file that is no record stops no other
    typed = page.get_by_label("Clicks, typed")
    typed.fill("2")
    typed.press("Tab")
    assert slider.get_attribute("aria-valuetext") == "2"
    slider.focus()
    slider.press("ArrowRight")
    assert float(typed.input_value()) > 2.0
    slider.press("ArrowLeft")
    page.get_by_text("Values of the curve between clicks").first.click()
    rows = page.locator("table:visible").first.locator("tbody tr").all_inner_texts()
    velocity, force, low, high = (float(cell.replace("−", "-")) for cell in rows[0].split("\t"))
    assert low < rebound_rate(2.0) * velocity < high
    assert low < force < high
    page.get_by_title("Export these curves").click()
    with page.expect_download() as download:
        page.get_by_role("button", name="CSV", exact=True).locator("visible=true").click()
    text = Path(download.value.path()).read_text("utf-8-sig")
    assert "4 clicks" in text
    assert len(list(csv.reader(io.StringIO(text)))) > 6
    page.get_by_text("Two dampers compared").click()
    page.get_by_label("Other damper").first.select_option("dyno")
    page.get_by_role("button", name="Compare", exact=True).click()
    page.frame_locator("iframe").get_by_text("within").first.wait_for()
    page.evaluate(f"(() => {{ {AXE.read_text()} }})()")
    violations = page.evaluate("rules => axe.run('main', {runOnly: rules})", RULES)["violations"]
    assert not violations, json.dumps(violations)[:2000]
    page.reload()  # the address keeps the folder
    page.get_by_text("Settings, with 95 % intervals").wait_for()
    context.close()
