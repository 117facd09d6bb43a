"""Finding one's way in the workbench: keys of the mechanism, curves by name, the project's files, and jobs."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

import jounce as jn

pytestmark = pytest.mark.pages
pytest.importorskip("uvicorn")
TOKEN = "a-token-of-wayfinding"
LIBRARY = Path(jn.__file__).parent / "parts" / "library"
CORNER = "kart-double-wishbone.toml"
AXE = Path(__file__).parents[2] / "viewer" / "node_modules" / "axe-core" / "axe.min.js"
RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"]


@pytest.fixture
def base(workbench: tuple[Path, int]) -> str:
    folder, port = workbench
    for name in (CORNER, "kart-quarter-car.toml"):
        shutil.copy(LIBRARY / name, folder)
    return f"http://127.0.0.1:{port}/"


class Opened:
    """A page, and what went wrong on it."""

    def __init__(self, page: Any, base: str) -> None:
        self.page, self.base = page, base
        self.troubles: list[str] = []
        page.set_default_timeout(60_000)
        page.on("pageerror", lambda error: self.troubles.append(str(error)))
        page.goto(f"{base}?token={TOKEN}")
        page.wait_for_selector("html[data-ready]")

    def go(self, name: str, values: str = "") -> None:
        self.page.evaluate("delete document.documentElement.dataset.ready")
        self.page.goto(f"{self.base}#/{name}?{values}")
        self.page.wait_for_selector(f"html[data-ready={name}]")

    def until(self, expression: str, argument: Any = None) -> None:
        """Wait until something is so; the policy of the page forbids to wait in it."""
        assert any(
            self.page.evaluate(expression, argument) or self.page.wait_for_timeout(50)
            for _ in range(400)
        ), expression

    def is_accessible(self) -> None:
        """Nothing that axe finds is serious, and nothing is wider than the window."""
        if not AXE.is_file():
            pytest.skip("axe is not installed: npm ci in viewer/")
        rules = AXE.read_text(encoding="utf-8")
        self.page.evaluate(f"typeof axe === 'undefined' && (() => {{ {rules} }})()")
        told = self.page.evaluate("rules => axe.run(document, {runOnly: rules})", RULES)
        serious = [one for one in told["violations"] if one["impact"] in ("serious", "critical")]
        assert [(one["id"], one["nodes"][0]["html"][:160]) for one in serious] == []
        assert self.page.evaluate("document.documentElement.scrollWidth <= innerWidth")


@contextmanager
def opened(browser: Any, base: str, **context: Any) -> Iterator[Opened]:
    made = browser.new_context(**{"viewport": {"width": 1280, "height": 720}, **context})
    try:
        page = Opened(made.new_page(), base)
        yield page
        assert page.troubles == []
    finally:
        made.close()


def test_arrow_keys_turn_the_mechanism_and_plus_and_minus_zoom_it(browser: Any, base: str) -> None:
    with opened(browser, base) as it:
        it.go("kinematics", f"rig={CORNER}")
        canvas = it.page.locator(".mechanism canvas")

        def picture() -> str:
            it.page.wait_for_timeout(100)
            return str(canvas.evaluate("one => one.toDataURL()"))

        canvas.focus()
        assert canvas.evaluate("one => getComputedStyle(one).outlineStyle") == "solid"
        assert (
            it.page.locator(".mechanism .keys").evaluate("one => getComputedStyle(one).opacity")
            == "1"
        )
        assert "arrow keys" in str(canvas.get_attribute("aria-label"))
        first, scrolled = picture(), it.page.evaluate("scrollY")
        for there, back in [("ArrowLeft", "ArrowRight"), ("ArrowUp", "ArrowDown"),
                            ("+", "-"), ("Shift+ArrowUp", "Shift+ArrowDown")]:  # fmt: skip
            it.page.keyboard.press(there)
            assert picture() != first, there
            it.page.keyboard.press(back)
            assert picture() == first, back
        it.page.keyboard.press("ArrowLeft")
        it.page.keyboard.press("0")
        assert picture() == first
        assert it.page.evaluate("scrollY") == scrolled
        it.page.keyboard.press("?")
        it.page.get_by_text("turn the mechanism that has the focus").wait_for()


def test_a_curve_is_found_by_name_kept_on_top_enlarged_and_read_as_a_table(
    browser: Any, base: str
) -> None:
    with opened(browser, base) as it:
        page = it.page
        it.go("kinematics", f"rig={CORNER}")
        first = page.locator(".multiples figure").first
        assert "roll centre" not in first.inner_text()
        page.get_by_role("button", name="Keep roll centre height at the top").press("Enter")
        it.until("document.activeElement.getAttribute('aria-pressed') === 'true'")
        assert "roll centre height" in first.inner_text()
        it.until(
            "[...document.querySelectorAll('[role=status]')].some(one => /pinned to/.test(one.textContent))"
        )
        page.reload()
        page.wait_for_selector(".multiples figure")
        assert "roll centre height [mm]" in " ".join(first.inner_text().split())

        page.get_by_role("button", name="Enlarge roll centre height").press("Enter")
        dialog = page.get_by_role("dialog", name="Enlarged curve")
        dialog.wait_for()
        assert float(dialog.evaluate("one => one.clientWidth")) > 1000
        place = dialog.locator("output.place")
        before = place.inner_text()
        assert before.startswith("wheel travel −20.00 mm: ")
        page.keyboard.press("ArrowRight")
        assert place.inner_text().startswith("wheel travel −18.00 mm: ")
        page.keyboard.press("PageDown")
        assert (
            dialog.get_by_label("curve", exact=True).evaluate("one => one.selectedOptions[0].text")
            == "camber"
        )
        it.is_accessible()
        dialog.get_by_label("curve", exact=True).select_option(label="roll centre height")
        dialog.get_by_role("button", name="Table", exact=True).press("Enter")
        cells = dialog.locator("tbody tr").first.locator("th, td").all_inner_texts()
        assert cells[0] == "−20.00"
        assert float(cells[1]) == pytest.approx(float(before.split(": ")[1].split()[0]), rel=1e-3)
        assert dialog.locator("tbody tr").count() == 21
        dialog.locator(".values p", has_text="All 21 values.").wait_for()
        it.until(
            "[...document.querySelectorAll('dialog [role=status]')].some(one => /All 21/.test(one.textContent))"
        )
        it.is_accessible()
        page.keyboard.press("Escape")
        it.until("document.activeElement.matches('[data-curve=roll_centre_height].enlarge')")
        page.get_by_role("button", name="Keep roll centre height at the top").click()
        assert "roll centre" not in first.inner_text()


def test_channels_of_a_trial_are_found_pinned_and_tabulated_alike(browser: Any, base: str) -> None:
    with opened(browser, base, locale="de-DE", viewport={"width": 390, "height": 720}) as it:
        page = it.page
        it.go("trial", f"rig={CORNER}")
        page.locator(".player .tools").first.wait_for()
        heads = page.locator(".pane-head b")
        field = page.get_by_role("searchbox", name="Kanal suchen")
        field.fill(
            "front_left.wheel.z, camber" if "front" in heads.first.inner_text() else "camber"
        )
        shown = page.locator(".channels button:visible")
        assert 0 < shown.count() < 10
        name = str(shown.last.get_attribute("data-channel"))
        count = heads.count()
        field.press("Enter")
        it.until("count => document.querySelectorAll('.pane-head b').length > count", count)
        page.locator(f"[data-curve='{name}'].pin").press("Enter")
        it.until("name => document.querySelector('.tool.pin').dataset.curve === name", name)
        it.until("document.activeElement.matches('.tool.pin[aria-pressed=true]')")
        page.reload()
        page.locator(f".pane-head:first-child [data-curve='{name}'].pin").wait_for()
        page.locator(f"[data-curve='{name}'].enlarge").press("Enter")
        dialog = page.get_by_role("dialog", name="Vergrößerte Kurve")
        dialog.get_by_role("button", name="Tabelle").press("Enter")
        text = dialog.locator(".values p").inner_text()
        rows = dialog.locator("tbody tr").count()
        assert 100 < rows <= 200
        assert f"{rows} von 1501 Werten: jede 8. Zeile." in text
        it.is_accessible()
        page.keyboard.press("Escape")
        it.is_accessible()
