"""Jobs from files to figures in a browser, on the ways on which a new reader was stopped."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytestmark = pytest.mark.pages
TOKEN = "a-token-of-short-ways"
DROP = """files => {
  const dropped = new DataTransfer(), place = document.querySelector('h1');
  for (const [name, text] of files) dropped.items.add(new File([text], name));
  for (const kind of ['dragover', 'drop'])
    place.dispatchEvent(new DragEvent(kind, {bubbles: true, cancelable: true, dataTransfer: dropped}));
}"""
POINTS = """Point\tX (mm)\tY (mm)\tZ (mm)
Lower ball joint\t-4\t718\t141
Upper ball joint\t16\t688\t402
Tie rod inner\t128\t382\t199
Tie rod outer\t119\t702\t180
"""


@pytest.fixture
def page(browser: Any, workbench: tuple[Path, int]) -> Iterator[Any]:
    _, port = workbench
    context = browser.new_context(viewport={"width": 1280, "height": 900}, locale="en-GB")
    context.set_default_timeout(60_000)
    made, troubles = context.new_page(), []  # type: Any, list[str]
    made.on("pageerror", lambda error: troubles.append(str(error)))
    made.goto(f"http://127.0.0.1:{port}/?token={TOKEN}")
    made.wait_for_selector("html[data-ready]")
    yield made
    context.close()
    assert troubles == []


def go(page: Any, where: str) -> None:
    page.evaluate(
        "where => { delete document.documentElement.dataset.ready; location.hash = where; }",
        f"/{where}",
    )
    page.wait_for_selector(f"html[data-ready={where.partition('?')[0]}]")


def bump(head: str, lag: float) -> str:
    """A text file of a bump, with the given headings."""
    time = np.arange(0.0, 8.0, 0.005)
    wave = np.exp(-(((time - lag - 2.0) / 0.2) ** 2)) * np.sin(9.0 * (time - lag))
    return head + "".join(f"\n{t:.3f},{w:.5f}" for t, w in zip(time, wave, strict=True)) + "\n"


def test_telemetry_dropped_on_data_is_aligned_with_channels_of_other_names(page: Any) -> None:
    go(page, "data")
    page.get_by_text("Drop recordings anywhere on this page").wait_for()
    first = ("car.csv", bump("Time [s],Acc Body [g]", 1.5))
    second = ("run.csv", bump("time [s],sprung.az [m/s^2]", 0.0))
    page.evaluate(DROP, [first, second])
    page.locator(".recordings li", has_text="1600 samples").nth(1).wait_for()
    assert page.locator(".recordings b").all_inner_texts() == [
        "measured/car.csv",
        "measured/run.csv",
    ]
    page.get_by_text("Align two recordings").click()
    form = page.locator(".aligning")
    form.get_by_label("Channel that is shifted").select_option("sprung.az")
    form.get_by_label("Channel that stays").select_option("Acc Body")
    form.get_by_role("button", name="Align").click()
    form.get_by_text("Shifted by 1.500").wait_for()


def test_a_record_of_a_tester_is_led_to_its_inspection(
    page: Any, workbench: tuple[Path, int]
) -> None:
    head = "time [s],left.plate.z [mm],left.plate.force [N]"
    rows = "".join(f"\n{k / 500},{3 * np.sin(k / 9):.4f},{4000 + k % 5}" for k in range(400))
    page.evaluate(DROP, [("lane.csv", head + rows)])
    link = page.get_by_role("link", name="inspect: lane.csv")
    link.wait_for()
    assert page.get_by_text("missing:").count() == 0
    assert page.get_by_role("button", name="into the campaign").count() == 0
    link.click()
    page.wait_for_selector("html[data-ready=inspection]")
    assert page.get_by_label("Record of one axle").input_value() == "measured/lane.csv"


def test_a_pasted_table_that_is_wrong_stays_and_loses_no_file(page: Any) -> None:
    page.evaluate(DROP, [("04.csv", bump("time [s],unsprung.az [m/s^2]", 0.0))])
    page.get_by_text("missing: speed").wait_for()
    page.get_by_text("Paste the table of trials").click()
    table = "trial\tspeed [m/s]\tobstacle\tstrut angle [deg]\n4\t1.97\tB10\t16\n"
    area = page.locator("details textarea")
    area.fill(table)
    page.get_by_role("button", name="Fill in from the table").click()
    page.get_by_text("a train without a pitch; found 'B10'").wait_for()
    assert area.input_value() == table
    assert page.locator(".arrivals .spark").count() == 1
    area.fill(table.replace("B10", "B 0.10 m"))
    page.get_by_role("button", name="Fill in from the table").click()
    page.get_by_label("speed: 04.csv").and_(page.locator("[value='1.97 m/s']")).wait_for()
    assert page.get_by_label("strut angle: 04.csv").input_value() == "16 deg"
    assert page.get_by_label("road: 04.csv").input_value() == "B 0.1"


def test_a_shipped_rig_is_copied_with_its_changes_and_kept_as_variants(
    page: Any, workbench: tuple[Path, int]
) -> None:
    folder, _ = workbench
    go(page, "kinematics?rig=reference-double-wishbone")
    page.get_by_text("curves computed").wait_for()
    page.get_by_text("Paste hardpoints from a table").click()
    page.get_by_label("Rows of a name").fill(POINTS)
    page.get_by_role("button", name="Compare with the rig").click()
    page.get_by_role("button", name="Take 4 changed points").click()
    page.get_by_label("Quantity").select_option("bump_steer")
    assert page.get_by_label("Tolerance").input_value() == "1 deg/m"
    page.get_by_role("button", name="Add the target").click()
    page.get_by_label("Name of the new file").fill("mine.toml")
    page.get_by_role("button", name="Copy into this project").click()
    page.get_by_role("heading", name="Kinematics of mine.toml").wait_for()
    page.get_by_text("= 0 deg/m ± 1 deg/m").wait_for()  # the target came with it
    text = (folder / "mine.toml").read_text()
    assert 'tie_rod_inner = ["-128 mm", "382 mm", "199 mm"]' in text
    assert 'lower_ball_joint = ["4 mm", "718 mm", "141 mm"]' in text  # not 0.141 m
    page.get_by_label("Name of the new file").fill("other.toml")
    page.get_by_role("button", name="Save as a new file").click()
    page.locator(".against summary", has_text="other.toml").wait_for()
    page.locator(".legend", has_text="other.toml").wait_for()
    assert (folder / "other.toml").read_text() == text
    page.get_by_role("button", name="Save as a new file").click()
    page.get_by_text("already exists").wait_for()  # and nothing is overwritten


def test_the_result_of_a_ride_has_curves_that_are_saved(page: Any) -> None:
    go(page, "ride")
    page.get_by_label("Vehicle or rig").first.select_option("audi-a6-quarter-car")
    page.get_by_label("Duration").fill("4")
    page.get_by_label("Duration").press("Tab")
    assert page.get_by_label("Duration").input_value() == "4 s"
    page.get_by_role("button", name="Drive", exact=True).click()
    page.get_by_title("Export these curves").click()
    with page.expect_download() as download:
        page.get_by_role("button", name="SVG").click()
    picture = Path(download.value.path()).read_text()
    assert "passive" in picture
    assert "skyhook" in picture


def test_a_number_without_a_unit_takes_that_of_its_field(page: Any) -> None:
    go(page, "trial?rig=audi-a6-quarter-car")
    height, speed = (page.get_by_label(name, exact=True) for name in ("Height", "Speed"))
    height.fill("30")
    height.press("Tab")
    speed.fill("5 m/s")
    speed.press("Tab")
    speed.fill("6.5")
    speed.press("Tab")
    assert (height.input_value(), speed.input_value()) == ("30 mm", "6.5 m/s")
    page.get_by_role("button", name="Save the run").click()
    page.get_by_role("link", name="Beside recordings").click()
    page.wait_for_selector("html[data-ready=data]")
    page.locator(".recordings li", has_text="samples").first.wait_for()
