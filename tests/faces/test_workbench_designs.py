"""Best designs and rides in a browser: what is proposed, what a failed search offers, what the front says."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

pytestmark = pytest.mark.pages
TOKEN = "a-token-of-designs"
CAR = "audi-a6-half-car-4dof"


@pytest.fixture
def page(browser: Any, workbench: tuple[Path, int]) -> Iterator[Any]:
    _, port = workbench
    context = browser.new_context(viewport={"width": 1280, "height": 800})
    context.set_default_timeout(60_000)
    made, troubles = context.new_page(), []  # type: Any, list[str]
    made.on("pageerror", lambda error: troubles.append(str(error)))
    made.goto(f"http://127.0.0.1:{port}/?token={TOKEN}#/ride")
    made.wait_for_selector("html[data-ready=ride]")
    yield made
    context.close()
    assert troubles == []


def until(page: Any, happens: Callable[[], object]) -> None:
    """Wait until something is so; the page goes on meanwhile."""
    assert any(happens() or page.wait_for_timeout(20) for _ in range(1500))


def rows(page: Any) -> list[list[str]]:
    """Give the design variables that the form has, with their bounds."""
    return [
        [field.input_value() for field in row.locator("input").all()]
        for row in page.locator(".pair").all()
    ]


def choose_car(page: Any) -> None:
    search = page.locator("section", has=page.get_by_role("button", name="Search"))
    search.get_by_label("Vehicle or rig").select_option(CAR)
    until(page, lambda: rows(page)[:1] == [["front.damping_coefficient", "900..9000 N·s/m"]])


def test_a_search_proposes_what_a_designer_chooses_with_its_own_bounds(page: Any) -> None:
    choose_car(page)
    assert rows(page) == [
        ["front.damping_coefficient", "900..9000 N·s/m"],
        ["rear.damping_coefficient", "750..7500 N·s/m"],
    ]
    offered = page.locator("#paths-that-are-free option").all()
    paths = [option.get_attribute("value") for option in offered]
    assert "front.spring_rate" in paths
    assert not {"gravity", "body.mass", "front.tyre.stiffness"} & set(paths)
    first = page.locator(".pair").first
    first.get_by_label("design variable").fill("front.spring_rate")
    first.get_by_label("bounds").focus()
    assert rows(page)[0] == ["front.spring_rate", "8.4..84 N/mm"]
    page.get_by_role("button", name="remove rear.damping_coefficient").click()
    assert len(rows(page)) == 1


def test_a_failed_search_is_changed_and_its_front_says_what_it_shows(page: Any) -> None:
    choose_car(page)
    page.locator(".pair").first.get_by_label("bounds").fill("9000..900 N·s/m")
    page.get_by_label("Designs", exact=True).fill("3")
    page.get_by_role("button", name="Search", exact=True).click()
    page.get_by_text("failed", exact=True).wait_for()
    page.get_by_role("button", name="Change and start again").first.click()
    until(page, lambda: rows(page)[:1] == [["front.damping_coefficient", "9000..900 N·s/m"]])
    assert [name for name, _ in rows(page)] == [
        "front.damping_coefficient",
        "rear.damping_coefficient",
    ]
    assert page.get_by_label("Designs", exact=True).input_value() == "3"
    page.locator(".pair").first.get_by_label("bounds").fill("900..9000 N·s/m")
    page.get_by_role("button", name="Search", exact=True).click()
    picture = page.get_by_role("group", name="Pareto front")
    picture.wait_for()
    said = "sprung.az, unweighted r.m.s. of front and rear [m/s²]"
    assert picture.get_by_text(said).count() == 1
    assert page.locator("th", has_text=said).count() == 1
    marks = [
        float(text) for text in picture.locator("text").all_text_contents() if text[:1].isdigit()
    ]
    assert len(marks) >= 6
    assert all(len(f"{value:g}") <= 4 for value in marks)  # round numbers


def test_notes_of_a_ride_name_controller_and_place(page: Any) -> None:
    page.get_by_label("Vehicle or rig").first.select_option(CAR)
    page.get_by_label("Duration").fill("4 s")
    page.get_by_label("Road").first.select_option("iso:F")
    page.get_by_role("button", name="Drive", exact=True).click()
    page.locator("th", has_text="controller").first.wait_for()
    notes = page.locator("main p.muted", has_text=": ").all_inner_texts()
    own = [text for text in notes if text.partition(": ")[0] in ("note", "warning")]
    assert own
    for text in own:
        assert text.split(": ")[1].partition(",")[0] in ("passive", "skyhook"), text
