"""The page of many recordings in Chromium: overlaid, measured between two cursors, kept, saved and shared."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytestmark = pytest.mark.pages
TOKEN = "a-token-of-recordings"
TIME = np.arange(0.0, 20.0, 0.002)


def write(file: Path, lag: float, offset: float = 0.0) -> None:
    moved = TIME - lag
    bump = np.exp(-(((moved - 8.0) / 0.3) ** 2))
    columns = [TIME, 20.0 + np.sin(0.5 * moved), offset + 5.0 * bump + 0.2 * np.sin(7.0 * moved)]
    np.savetxt(
        file,
        np.column_stack(columns),
        delimiter=",",
        header="time [s],speed [m/s],sprung.az [m/s^2]",
        comments="",
        fmt="%.7g",
    )


@pytest.fixture
def page(browser: Any, workbench: tuple[Path, int]) -> Iterator[Any]:
    folder, port = workbench
    write(folder / "first.csv", 0.0)
    write(folder / "second.csv", 1.5)
    context = browser.new_context(viewport={"width": 1280, "height": 900}, locale="en-GB")
    context.set_default_timeout(60_000)
    page = context.new_page()
    page.troubles = []
    page.on("pageerror", lambda error: page.troubles.append(str(error)))
    page.goto(f"http://127.0.0.1:{port}/?token={TOKEN}")
    page.wait_for_selector("html[data-ready]")
    yield page
    context.close()
    assert page.troubles == []


def go(page: Any, port: int, where: str) -> None:
    page.evaluate(
        "where => { delete document.documentElement.dataset.ready; location.hash = where; }", where
    )
    page.wait_for_selector("html[data-ready=data]")


def figures(page: Any) -> list[list[str]]:
    """Rows of the table of figures, once both cursors are measured."""
    page.locator("[aria-label='Figures of the window'] tbody tr").first.wait_for()
    rows = page.locator("[aria-label='Figures of the window'] tbody tr").all()
    return [row.locator("th, td").all_inner_texts() for row in rows]


def set_number(page: Any, label: str, value: float) -> None:
    field = page.get_by_label(label, exact=True)
    field.fill(str(value))
    with page.expect_response("**/api/data/window"):
        field.press("Enter")
    page.wait_for_timeout(200)


def test_recordings_are_overlaid_and_measured(page: Any, workbench: tuple[Path, int]) -> None:
    _, port = workbench
    go(page, port, "/data?path=first.csv")
    page.get_by_label("Add a recording").select_option("second.csv")
    page.locator(".pane-head", has_text="second.csv").first.wait_for()
    assert page.locator(".pane").count() == 2
    set_number(page, "cursor A", 2.0)
    set_number(page, "cursor B", 6.0)
    rows = figures(page)
    assert [row[0] for row in rows] == [
        "speed [m/s] first.csv",
        "speed [m/s] second.csv",
        "sprung.az [m/s²] first.csv",
        "sprung.az [m/s²] second.csv",
    ]
    heads = page.locator("[aria-label='Figures of the window'] thead th").all_inner_texts()
    names = "channel,A,B,B − A,minimum,maximum,mean,r.m.s.,std. dev.,samples"
    assert heads == names.split(",")
    inside = (TIME >= 2.0) & (TIME <= 6.0)
    speed = (20.0 + np.sin(0.5 * TIME))[inside]
    _, a, b, apart, low, high, mean, rms, deviation, samples = rows[0]
    assert (a, b) == (f"{speed[0]:.3f}", f"{speed[-1]:.3f}")
    assert float(apart.replace("−", "-")) == pytest.approx(speed[-1] - speed[0], abs=1e-4)
    assert (float(low), float(high)) == pytest.approx((speed.min(), speed.max()), abs=1e-3)
    assert (float(mean), float(rms)) == pytest.approx(
        (speed.mean(), np.sqrt(np.mean(speed**2))), abs=1e-3
    )
    assert float(deviation) == pytest.approx(speed.std(), abs=1e-4)
    assert samples == "2001"
    set_number(page, "shift of second.csv", -1.5)
    rows = figures(page)
    assert rows[0][1] == rows[1][1]  # on one clock now


def test_cursors_are_dragged_clicked_and_typed(page: Any, workbench: tuple[Path, int]) -> None:
    _, port = workbench
    go(page, port, "/data?path=first.csv")
    figures(page)
    before = float(page.get_by_label("cursor A", exact=True).input_value())
    line = page.locator(".cursor-line").first
    box = line.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + 30)
    page.mouse.down()
    page.mouse.move(box["x"] + 60, box["y"] + 30, steps=4)
    page.mouse.up()
    dragged = float(page.get_by_label("cursor A", exact=True).input_value())
    assert dragged > before
    over = page.locator(".u-over").first.bounding_box()
    page.mouse.click(over["x"] + 0.95 * over["width"], over["y"] + 40)
    assert float(page.get_by_label("cursor B", exact=True).input_value()) == pytest.approx(
        19.0, abs=0.2
    )
    page.get_by_role("button", name="Hide the cursors").click()
    assert page.locator(".cursor-line:visible").count() == 0
    page.get_by_role("button", name="Undo").click()
    assert page.locator(".cursor-line:visible").count() == 4


def test_the_state_is_kept_over_a_reload_saved_and_shared(
    page: Any, workbench: tuple[Path, int]
) -> None:
    folder, port = workbench
    go(page, port, "/data?path=first.csv")
    figures(page)
    page.get_by_label("Add a recording").select_option("second.csv")
    set_number(page, "cursor A", 3.25)
    page.locator(".channels button", has_text="speed").click()
    page.locator(".pane").nth(1).wait_for(state="detached")
    page.wait_for_timeout(600)
    shared = page.url
    assert "state=" in shared
    page.reload()
    page.wait_for_selector("html[data-ready=data]")
    figures(page)
    assert page.get_by_label("cursor A", exact=True).input_value() == "3.25"
    assert page.locator(".pane").count() == 1
    page.get_by_label("Name of the layout").fill("damper look")
    page.get_by_role("button", name="Save the layout").click()
    page.get_by_text("Saved as layouts/damper look.toml.").wait_for()
    assert "3.25" in (folder / "layouts" / "damper look.toml").read_text()
    go(page, port, "/data?layout=layouts/damper look.toml")
    figures(page)
    assert page.get_by_label("cursor A", exact=True).input_value() == "3.25"
    (folder / "layouts" / "damper look.toml").write_text('schema = "jounce.layout/1"\nnote = 5\n')
    set_number(page, "cursor A", 4.5)
    page.get_by_role("button", name="Save the layout").click()
    page.get_by_text("the file has changed since it was loaded").wait_for()
    (folder / "second.csv").unlink()  # as in another project
    go(page, port, re.sub(r"^[^#]*#", "", shared))
    page.get_by_text("second.csv: no such file.").wait_for()
    assert len(figures(page)) == 1


def test_a_file_that_changes_while_it_is_open_says_so(
    page: Any, workbench: tuple[Path, int]
) -> None:
    folder, port = workbench
    go(page, port, "/data?path=first.csv")
    before = figures(page)
    write(folder / "first.csv", 0.0, offset=3.0)
    page.get_by_text(
        "first.csv has changed: curves and figures show the file as it is now."
    ).wait_for()
    page.wait_for_timeout(1000)
    assert figures(page)[1][3] != before[1][3] or figures(page)[1][6] != before[1][6]


def test_a_damaged_link_is_refused(page: Any, workbench: tuple[Path, int]) -> None:
    _, port = workbench
    go(page, port, "/data?state=AAAA")
    page.get_by_text("This link is damaged: the layout in it cannot be read.").wait_for()


def test_alignment_by_correlation_shows_its_trust(page: Any, workbench: tuple[Path, int]) -> None:
    _, port = workbench
    go(page, port, "/data?path=first.csv")
    page.get_by_label("Add a recording").select_option("second.csv")
    page.get_by_text("Align two recordings").click()
    form = page.locator(".aligning")
    form.get_by_label("Channel that stays").select_option("sprung.az")
    form.get_by_role("button", name="Align").click()
    form.get_by_text("Shifted by −1.500").wait_for()
    assert "Correlation 1.00" in form.locator(".state").inner_text() or "0.99" in form.inner_text()
    assert float(page.get_by_label("shift of second.csv").input_value()) == pytest.approx(
        -1.5, abs=2e-3
    )
    form.get_by_label("How").select_option("rise")
    form.get_by_label("Level", exact=True).fill("400")
    form.get_by_role("button", name="Align").click()
    form.get_by_text("the channel never rises through 400").wait_for()


def test_formulas_carry_units_and_say_what_is_wrong(page: Any, workbench: tuple[Path, int]) -> None:
    _, port = workbench
    go(page, port, "/data?path=first.csv")
    figures(page)
    page.get_by_role("button", name="Add a formula").click()
    formula = page.get_by_label("formula 1", exact=True)
    formula.wait_for()
    for text, words in (
        ("speed + sprung.az", "units do not fit"),
        ("speed / (speed - speed)", "division by zero"),
        ("lowpass(speed, 20)", "a number in Hz, in quotes"),
        ("sprung.az / max(speed - '20 m/s', 0)", "is zero at"),
    ):
        formula.fill(text)
        formula.press("Enter")
        page.locator(".formulas").get_by_text(words).wait_for()
    formula.fill("integral(speed)")
    formula.press("Enter")
    page.locator(".formulas .problem, .formulas .notice").wait_for(state="detached")
    rows = page.locator("[aria-label='Figures of the window'] tbody tr")
    rows.filter(has_text="computed_1 [m]").wait_for()
    page.get_by_label("Over").select_option("computed_1")  # now a distance is the axis
    page.get_by_text(re.compile("B − A = 13[0-9].* m")).wait_for()
    rows.first.wait_for()
    assert float(page.get_by_label("cursor B", exact=True).input_value()) > 200.0


def test_charts_and_events_of_the_window(page: Any, workbench: tuple[Path, int]) -> None:
    _, port = workbench
    go(page, port, "/data?path=first.csv")
    figures(page)
    kind = page.get_by_label("Chart of the window").first
    for choice, words in (
        ("spectrum", "resolution"),
        ("scatter", "correlation"),
    ):
        kind.select_option(choice)
        page.locator(".data-main .figures", has_text=words).first.wait_for()
    kind.select_option("histogram")
    page.get_by_label("Bins").wait_for()
    page.get_by_label("Event at cursor A").fill("kerb")
    page.get_by_role("button", name="Add the event").click()
    page.locator(".flag", has_text="kerb").wait_for()
    page.get_by_label("Notes on this layout").fill("tyres worn")
    page.get_by_label("Notes on this layout").blur()
    page.wait_for_timeout(600)
    page.reload()
    page.wait_for_selector("html[data-ready=data]")
    page.locator(".flag", has_text="kerb").wait_for()
    assert page.get_by_label("Notes on this layout").input_value() == "tyres worn"
    page.get_by_label("remove kerb").click()
    page.locator(".flag").wait_for(state="detached")


@pytest.mark.parametrize("where", ["data", "record"])
def test_a_large_recording_shows_how_far_it_is_read(page: Any, where: str) -> None:
    """Answers are held back here: how far a file is read is tested with files."""
    asked = "**/api/data/curves" if where == "data" else "**/api/record?**"
    reading = [
        {"path": "first.csv", "share": 0.415, "seconds": 2.2},
        {"path": "other.nc", "share": None, "seconds": 9.7},
    ]
    held: list[Any] = []
    page.route(asked, lambda route: held.append(route))  # noqa: PLW0108 - it needs a function of Python
    page.route("**/api/data/reading", lambda route: route.fulfill(json=reading))
    page.evaluate("where => { location.hash = where; }", f"/{where}?path=first.csv")
    first, other = (page.locator(".being-read").nth(k) for k in (0, 1))
    first.wait_for()
    assert first.inner_text().split("\n") == ["Reading first.csv", "42 %, 2 s"]
    assert (
        first.get_by_role("progressbar", name="Reading first.csv").get_attribute("value") == "0.415"
    )
    assert other.inner_text().split("\n") == ["Reading other.nc", "10 s"]
    assert other.locator("progress").get_attribute("value") is None
    page.unroute(asked)
    for route in held:
        route.continue_()
    page.locator(".u-over").first.wait_for()
    assert page.locator(".being-read").count() == 0


def test_undo_goes_back_to_what_was_opened(page: Any, workbench: tuple[Path, int]) -> None:
    _, port = workbench
    go(page, port, "/data?path=first.csv")
    figures(page)
    page.wait_for_timeout(800)  # a step is noted after a pause
    undo = page.get_by_role("button", name="Undo")
    assert undo.is_disabled()
    page.get_by_label("Add a recording").select_option("second.csv")
    page.locator(".pane-head", has_text="second.csv").first.wait_for()
    undo.click()
    page.locator(".pane-head", has_text="second.csv").first.wait_for(state="detached")
    assert page.locator(".pane").count() == 2
    assert undo.is_disabled()


def test_waiting_is_told_and_a_faulty_formula_named_once(
    page: Any, workbench: tuple[Path, int]
) -> None:
    _, port = workbench
    go(page, port, "/data?path=first.csv")
    figures(page)
    page.get_by_label("Add a recording").select_option("second.csv")
    page.locator(".pane-head", has_text="second.csv").first.wait_for()
    waiting: list[Any] = []
    is_slow = True
    page.route(
        "**/api/data/curves",
        lambda route: waiting.append(route) if is_slow else route.continue_(),
    )
    page.get_by_role("button", name="Add a formula").click()
    page.locator(".player .computing", has_text="computing …").wait_for()
    page.locator(".formulas .computing", has_text="computing …").wait_for()
    channel = page.locator(".channels button", has_text="computed_1")
    assert "computing …" in channel.inner_text()
    is_slow = False
    for route in waiting:
        route.continue_()
    page.locator(".formulas .computing").wait_for(state="detached")
    channel.filter(has_text="m/s").wait_for()
    formula = page.get_by_label("formula 1", exact=True)
    formula.fill("brake + 1")
    formula.press("Enter")
    page.locator(".formulas .problem").wait_for()
    assert page.locator(".formulas .problem").all_inner_texts() == [
        "no channel 'brake'. Write a quantity in quotes, such as '20 Hz'."
    ]
    assert page.get_by_text("no recording has the channel").count() == 0
    assert "faulty" in channel.inner_text()


def test_recordings_are_aligned_along_a_distance(page: Any, workbench: tuple[Path, int]) -> None:
    _, port = workbench
    go(page, port, "/data?path=first.csv")
    figures(page)
    page.get_by_label("Add a recording").select_option("second.csv")
    page.get_by_role("button", name="Add a formula").click()
    formula = page.get_by_label("formula 1", exact=True)
    formula.fill("integral(speed)")
    formula.press("Enter")
    page.locator(".channels button", has_text="computed_1").filter(has_text="m #").wait_for()
    page.get_by_label("Over").select_option("computed_1")
    page.get_by_text("Align two recordings").click()
    form = page.locator(".aligning")
    form.get_by_text("Largest shift [m]").wait_for()
    form.get_by_label("Channel that stays").select_option("sprung.az")
    form.get_by_role("button", name="Align").click()
    form.get_by_text(re.compile(r"Shifted by −(29|30|31)\.\d+ m\.")).wait_for()
    assert float(page.get_by_label("shift of second.csv").input_value()) == pytest.approx(
        -30.0, abs=1.5
    )


def test_a_german_page_shows_and_takes_a_decimal_comma(
    page: Any, workbench: tuple[Path, int]
) -> None:
    _, port = workbench
    page.get_by_role("button", name="Deutsch").click()
    page.wait_for_selector("html[lang=de][data-ready]")
    go(page, port, "/data?path=first.csv")
    cursor = page.get_by_label("Cursor A", exact=True)
    cursor.wait_for()
    cursor.fill("2,75")
    with page.expect_response("**/api/data/window") as answered:
        cursor.press("Enter")
    assert answered.value.request.post_data_json["begin"] == 2.75
    page.wait_for_timeout(300)
    assert page.evaluate("document.querySelector('.cursors input').value") == "2.75"
    shown = "Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, 'value').get"
    assert page.evaluate(f"({shown}).call(document.querySelector('.cursors input'))") == "2,75"
    cursor.press("ArrowUp")
    assert page.evaluate("document.querySelector('.cursors input').value") == "3.75"
    cursor.fill("zwei")
    assert cursor.get_attribute("aria-invalid") == "true"
