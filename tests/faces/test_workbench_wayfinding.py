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
