"""The page of a campaign is the report's own: answer first, rows of trials that open their curves, nothing foreign."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import jounce as jn

pytestmark = pytest.mark.pages
TOKEN = "a-token-of-campaigns"
AXE = Path(__file__).parents[2] / "viewer" / "node_modules" / "axe-core" / "axe.min.js"
HOSTILE = """<!doctype html><main><section id="answer"><h2 onclick="globalThis.done = 1">Answer</h2>
<p style="position:fixed;inset:0" class="bad">Plain <b>text</b> <a href="https://example.org">link</a></p>
<img src="x" onerror="globalThis.done = 1"><script>globalThis.done = 1</script><iframe src="/"></iframe>
<svg viewBox="0 0 9 9" style="position: fixed; max-width: 90px" onload="globalThis.done = 1"><a href="javascript:0">
<text>drawn</text></a><path d="M0 0h9" class="l"/><foreignObject><p>inside</p></foreignObject></svg></section></main>"""


@pytest.fixture(scope="module")
def done(browser: Any, workbench: tuple[Path, int]) -> Iterator[tuple[Any, str]]:
    """Run the campaign to start from on its page; give the browser's context and the address of the job."""
    folder, port = workbench
    jn.new_campaign(folder / "mine")
    context = browser.new_context(viewport={"width": 1280, "height": 800})
    context.set_default_timeout(180_000)
    page = context.new_page()
    page.goto(f"http://127.0.0.1:{port}/?token={TOKEN}#/campaign?file=mine/campaign.toml")
    page.get_by_role("button", name="Run the campaign").click()
    page.locator(".reported h2").first.wait_for()
    address = page.url
    page.close()
    yield context, address
    context.close()


@pytest.fixture
def page(done: tuple[Any, str]) -> Iterator[Any]:
    context, address = done
    made, troubles = context.new_page(), []  # type: Any, list[str]
    made.on("pageerror", lambda error: troubles.append(str(error)))
    made.on("console", lambda said: troubles.append(said.text) if said.type == "error" else None)
    made.goto(address)
    made.locator(".reported h2").first.wait_for()
    yield made
    made.close()
    assert troubles == []


def test_the_answer_comes_first_and_the_evidence_unfolds(page: Any) -> None:
    shown = page.locator(".reported > section > h2").all_inner_texts()
    assert [text.split("\n")[0].split(" Synthetic")[0] for text in shown] == [
        "Answer",
        "Curves",
        "Validation",
    ]
    answer = page.locator(".reported > section").first
    assert answer.get_by_text("1 of 1 hold").count() == 1
    assert answer.get_by_role("rowheader", name="strut.spring.rate").is_visible()
    assert answer.locator("svg.chart").count() == 4  # each value with both its intervals
    assert page.evaluate("document.documentElement.scrollHeight") < 4200
    assert not page.get_by_text("Test matrix").is_visible()
    page.get_by_role("button", name="Trials and roads").click()
    assert page.get_by_text("Test matrix").is_visible()


def test_a_row_says_how_well_it_fits_and_opens_its_curves(page: Any) -> None:
    rows = page.locator("details[data-scene]")
    assert rows.count() == 3
    assert page.locator(".reported .player").count() == 0
    first = rows.first.locator("summary").inner_text()
    assert first.startswith("Trial 1 (fitted), 1.95 m/s, road A: holds")
    assert "sprung.az: R² 0." in first
    assert "NRMSE 0.11" in first
    page.get_by_role("button", name="4", exact=True).click()  # its number in the table of ratings
    player = rows.nth(2).locator(".player")
    player.wait_for()
    assert page.locator(".reported .player").count() == 1
    for label in ("measured", "before updating", "stiffness, damping and friction"):
        assert player.get_by_role("button", name=label).get_attribute("aria-pressed") == "true"
    assert player.locator("canvas").first.is_visible()
    player.locator(".save summary").first.click()
    with page.expect_download() as saved:
        player.get_by_role("button", name="CSV").click()
    text = Path(saved.value.path()).read_text(encoding="utf-8-sig")
    assert text.startswith("time [s],")
    assert "measured" in text.splitlines()[0]


def test_the_page_of_a_campaign_needs_no_eyes_and_fits_a_phone(page: Any) -> None:
    if not AXE.is_file():
        pytest.skip("axe is not installed: npm ci in viewer/")
    page.locator("details[data-scene] summary").first.press("Enter")
    page.locator(".reported .player").wait_for()
    for folded in page.locator("details.folded > summary").all():
        folded.press("Enter")
    page.set_viewport_size({"width": 390, "height": 800})
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    page.evaluate(f"(() => {{ {AXE.read_text(encoding='utf-8')} }})()")
    told = page.evaluate(
        "axe.run(document, {runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'wcag22aa']})"
    )
    grave = [one for one in told["violations"] if one["impact"] in ("serious", "critical")]
    assert [(one["id"], [node["html"][:150] for node in one["nodes"][:3]]) for one in grave] == []
    assert told["passes"]


def test_nothing_of_a_foreign_report_acts(
    page: Any, workbench: tuple[Path, int], done: tuple[Any, str]
) -> None:
    folder, _ = workbench
    file = folder / "mine" / "results" / "report.html"
    text = file.read_text(encoding="utf-8")
    try:
        file.write_text(HOSTILE, encoding="utf-8")
        page.reload()
        shown = page.locator(".reported")
        shown.get_by_text("Plain").wait_for()
        assert page.evaluate("globalThis.done") is None
        assert shown.locator("script, img, iframe, foreignObject, b, [style*=fixed]").count() == 0
        assert shown.locator("[href], [onclick], [onload]").count() == 0
        assert shown.locator("svg path").count() == 1
    finally:
        file.write_text(text, encoding="utf-8")


LEFT = """() => [...document.querySelectorAll('.reported [lang=en]')]
  .filter(one => !one.closest('dd, li')).map(one => one.textContent)"""
"""Sentences that stay English, but for literature and texts of the campaign's author."""


def test_a_german_page_has_the_report_in_german_with_decimal_commas(page: Any) -> None:
    page.get_by_role("button", name="Deutsch").click()
    page.locator(".reported h2", has_text="Antwort").first.wait_for()
    text = page.evaluate("document.querySelector('.reported').textContent")
    assert "Bewertung nach ISO/TS 18571 jedes Versuchs vor und nach jedem Abgleich" in text
    assert "Standardfehler und Intervalle sind nur die des Rauschens" in text
    assert "R² 0," in text
    assert "R² 0." not in text
    own = "stiffness, damping and friction"  # the update's name, as its campaign gives it
    left = [text for text in page.evaluate(LEFT) if text != own]
    assert not left, "\n".join(left)
    page.get_by_role("button", name="English").click()
    page.locator(".reported h2", has_text="Answer").first.wait_for()
