"""Finding one's way in the workbench: keys of the mechanism, curves by name, the project's files, and jobs."""

from __future__ import annotations

import json
import shutil
import time
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


def test_a_curve_with_a_target_comes_first_and_shows_its_limits_large(
    browser: Any, base: str
) -> None:
    with opened(browser, base) as it:
        page = it.page
        it.go("kinematics", f"rig={CORNER}")
        page.locator(".multiples figure").first.wait_for()
        page.get_by_label("Quantity").select_option("caster")
        page.get_by_label("Value", exact=True).fill("4 deg")
        page.get_by_label("Tolerance").fill("0.5 deg")
        page.get_by_label("At a value, or over").fill("-10 mm:10 mm:10 mm")
        page.get_by_role("button", name="Add the target").click()
        page.locator(".multiples figure:first-child .verdict.good").wait_for()
        assert page.locator(".multiples figure b").first.inner_text() == "caster"
        page.locator("[data-curve=caster].enlarge").press("Enter")
        dialog = page.get_by_role("dialog", name="Enlarged curve")
        dialog.get_by_role("button", name="Table", exact=True).press("Enter")
        assert dialog.locator("thead th").all_inner_texts() == [
            "wheel travel [mm]", "caster [°]", "target, at least [°]", "target, at most [°]"
        ]  # fmt: skip
        row = dialog.locator("tbody tr", has_text="−10.00").locator("td").all_inner_texts()
        assert [float(text) for text in row[1:]] == [3.5, 4.5]
        beyond = dialog.locator("tbody tr", has_text="−12.00").locator("td").all_inner_texts()
        assert beyond[1:] == ["–", "–"]


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


def test_a_job_shows_start_inputs_and_stage_and_tells_its_end_on_every_page(
    browser: Any, base: str
) -> None:
    job: dict[str, Any] = {
        "id": "000001-0a1b2c3d", "kind": "campaign", "title": "Campaign: kart", "state": "running", "python": "",
        "command": "jounce campaign run kart.toml --out=results", "files": {}, "out": "results", "report": "",
        "asked": {"kind": "campaign", "campaign": "kart.toml", "out": "results", "force": False},
        "begun": time.time() - 31.0, "ended": None, "lasted": 31.0, "said": "update 2 of 5: damper",
        "said_german": None, "share": 0.3, "left": None, "stage": [2, 4], "steps": [], "error": None, "german": None,
    }  # fmt: skip
    sockets: list[Any] = []
    with opened(browser, base) as it:
        page = it.page
        page.context.grant_permissions(["notifications"])

        def hear(socket: Any) -> None:
            sockets.append(socket)

        page.route_web_socket("**/api/live", hear)

        def say(**changes: Any) -> None:
            job.update(changes)
            it.until("() => true")
            sockets[-1].send(json.dumps([job]))

        it.go("jobs")
        page.get_by_text("The system notifies you when a job ends").wait_for()
        say()
        card = page.locator("article.job")
        card.get_by_text("stage 2 of 4").wait_for()
        told = card.inner_text()
        assert "started " in told
        assert "for 31 s" in told
        assert "left" not in told
        assert "campaign kart.toml · into results" in told
        bar = card.get_by_role("progressbar")
        assert bar.evaluate("one => one.value") == pytest.approx(0.3)
        it.is_accessible()
        it.go("trial", f"rig={CORNER}")
        page.evaluate(
            """() => {
                globalThis.notices = [];
                globalThis.Notification = class extends EventTarget {
                    static permission = 'granted';
                    constructor(title, { body }) { super(); notices.push(body); }
                };
                Object.defineProperty(document, 'hidden', { value: true, configurable: true });
            }"""
        )
        title = page.title()
        say(share=0.9, stage=[4, 4])
        assert page.title() == title
        say(state="done", ended=time.time(), share=1.0, left=None)
        it.until("document.title.startsWith('✓ ')")
        assert page.evaluate("notices") == ["Campaign: kart: done"]
        it.until(
            "[...document.querySelectorAll('[role=status]')].some(one => one.textContent === 'Campaign: kart: done')"
        )
        page.evaluate(
            """() => {
                Object.defineProperty(document, 'hidden', { value: false, configurable: true });
                document.dispatchEvent(new Event('visibilitychange'));
            }"""
        )
        assert page.title() == title


def test_a_real_job_says_when_it_began_and_what_it_was_asked(
    browser: Any, base: str, workbench: tuple[Path, int]
) -> None:
    (workbench[0] / "study.toml").write_text(
        'schema = "jounce.sweep/1"\nrig = "kart-quarter-car"\nmetrics = ["max sprung.az"]\n'
        'trial = {speed = "2 m/s", duration = "0.2 s", road = {kind = "half-sine", height = "10 mm", '
        'length = "60 mm"}}\ndesign = {kind = "monte-carlo", count = 4}\nvary = {"strut.spring.rate" = "20 %"}\n'
    )
    with opened(browser, base, locale="de-DE", viewport={"width": 390, "height": 720}) as it:
        it.go("jobs")
        it.page.get_by_role("button", name="Benachrichtigen").wait_for()
        it.page.evaluate(
            """([token]) => fetch('/api/jobs', {method: 'POST', body: JSON.stringify({kind: 'sweep',
            study: 'study.toml', out: 'swept'}), headers: {Authorization: `Bearer ${token}`,
            'Content-Type': 'application/json'}})""",
            [TOKEN],
        )
        card = it.page.locator("article.job").filter(has_text="study")
        card.get_by_text("fertig").wait_for()
        told = card.inner_text()
        assert "Studie study.toml · Ordner swept" in told
        assert "begonnen" in told
        it.is_accessible()


def test_five_hundred_files_are_searched_sorted_and_folded_and_stay_so(
    browser: Any, base: str, workbench: tuple[Path, int]
) -> None:
    many = workbench[0] / "many"
    many.mkdir(exist_ok=True)
    for k in range(500):
        rows = "".join(f"{0.1 * i:.1f},{i}\n" for i in range(3 + k))
        (many / f"run_{k}.csv").write_text(f"time [s],sprung.z [mm]\n{rows}")
    try:
        with opened(browser, base) as it:
            page = it.page
            it.go("project")
            files = page.get_by_role("region", name="Files", exact=True)
            files.get_by_text("record (500)").wait_for()
            assert page.evaluate("document.querySelector('.files').scrollHeight") < 1200
            assert files.locator("tbody tr").count() < 40
            files.get_by_text("record (500)").click()
            files.get_by_label("Sort by").select_option("largest first")
            region = files.get_by_role("region", name="files: record")
            assert region.locator("tbody th").first.inner_text() == "many/run_499.csv"
            assert page.evaluate("document.querySelector('.files').scrollHeight") < 1700
            it.is_accessible()
            page.reload()
            page.wait_for_selector("html[data-ready=project]")
            assert region.locator("tbody th").first.inner_text() == "many/run_499.csv"
            files.get_by_label("Sort by").select_option("name")
            assert region.locator("tbody th").nth(2).inner_text() == "many/run_2.csv"
            files.get_by_text("record (500)").click()
            files.get_by_label("Search files").fill("run_49, wishbone")
            assert region.locator("tbody tr").count() == 11
            files.get_by_text("12 of ").wait_for()
            it.until(
                "[...document.querySelectorAll('[role=status]')].some(one => /12 of 50/.test(one.textContent))"
            )
            files.get_by_label("Search files").fill("")
            files.get_by_label("Group by").select_option("folder")
            files.get_by_text("many (500)").wait_for()
            files.get_by_label("Group by").select_option("kind")

            page.keyboard.press("Control+k")
            box = page.get_by_role("combobox", name="Search pages, files, rigs")
            it.until("document.querySelectorAll('#palette-list li').length === 40")
            box.fill("run_300")  # the files arrive a little later than pages and rigs
            page.get_by_role("option", name="many/run_300.csv").first.wait_for()
            took = page.evaluate(
                """() => {
                    const field = document.querySelector('[role=combobox]'), began = performance.now();
                    for (const text of ['r', 'ru', 'run_4', 'run_49', 'run_499']) {
                        field.value = text;
                        field.dispatchEvent(new Event('input'));
                    }
                    return (performance.now() - began) / 5;
                }"""
            )
            assert took < 100, "ms from a letter to the matches"
            assert (
                page.locator("#palette-list li").first.inner_text().startswith("many/run_499.csv")
            )
            box.fill("double wishbone kart kinematics")
            page.get_by_role("option", name="kart-double-wishbone: kinematics").wait_for()
    finally:
        shutil.rmtree(many)


def test_the_palette_knows_quantities_and_channels_of_the_page(browser: Any, base: str) -> None:
    with opened(browser, base) as it:
        page = it.page
        it.go("trial", f"rig={CORNER}")
        page.locator(".player .tools").first.wait_for()
        hidden = page.locator("[data-channel][aria-pressed=false]").last
        name = str(hidden.get_attribute("data-channel"))
        page.keyboard.press("Control+k")
        page.get_by_role("combobox", name="Search pages").fill(f"{name} show the curve")
        page.locator("#palette-list li", has_text=f"{name},").first.click()
        page.locator(f".pane-head [data-curve='{name}'].enlarge").wait_for()
        page.keyboard.press("Control+k")
        page.get_by_role("combobox", name="Search pages").fill("Speed quantity")
        page.get_by_role("option", name="Speed").first.wait_for()
        page.keyboard.press("Enter")
        assert page.evaluate("document.activeElement.closest('label').textContent") == "Speed"


def test_shipped_rigs_have_a_drawing_and_a_kind(browser: Any, base: str) -> None:
    with opened(browser, base, locale="de-DE", viewport={"width": 390, "height": 720}) as it:
        page = it.page
        asked: list[str] = []
        page.on("request", lambda request: asked.append(request.url))
        it.go("project")
        cards = page.locator(".gallery li")
        assert cards.count() == len(jn.parts.library())
        card = cards.filter(has_text="generic-mcpherson")
        assert "McPherson" in card.inner_text()
        assert not any("name=van-front" in url for url in asked)
        card.scroll_into_view_if_needed()
        it.until("document.querySelector('img[data-rig=generic-mcpherson]').naturalWidth > 0")
        it.is_accessible()
        card.get_by_role("button", name="wählen").press("Enter")
        assert page.evaluate("document.activeElement.value") == "generic-mcpherson.toml"
        it.go("kinematics")
        link = page.get_by_role("link", name="öffnen: suv-front")
        assert page.locator(".gallery li").filter(has_text="kart-quarter-car").count() == 0
        it.is_accessible()
        link.click()
        page.wait_for_selector(".multiples figure")
