"""Every page of the workbench in Chromium: what assistive technology finds, both languages, and clicks at random."""

from __future__ import annotations

import contextlib
import json
import os
import random
import shutil
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import jounce as jn
from jounce.parts import library

pytest.importorskip("uvicorn")
AXE = Path(__file__).parents[2] / "viewer" / "node_modules" / "axe-core" / "axe.min.js"
RULES = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"]
DRAWN = (
    "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))"
)
RIG = "kart-double-wishbone.toml"
PAGES = [
    "project", f"rig?name={RIG}", f"trial?rig={RIG}", f"kinematics?rig={RIG}", f"kc?rig={RIG}", "record?path=run.nc",
    "data?path=run.nc", "campaign",
    "ride",
    "inspection", "studies", "jobs",
]  # fmt: skip


@pytest.fixture(scope="module")
def server(tmp_path_factory):
    """A workbench over a rig and a recording, in a process of its own."""
    folder = tmp_path_factory.mktemp("project")
    shutil.copy(Path(jn.__file__).parent / "parts" / "library" / RIG, folder / RIG)
    trial = jn.Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm"), speed="2 m/s", duration="0.5 s"
    )
    jn.write_recording(jn.simulate(jn.load("kart-quarter-car"), trial), folder / "run.nc")
    command = [sys.executable, "-m", "jounce", "serve", str(folder), "--no-open", "--json"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as started:
        yield started
        started.terminate()


@pytest.fixture(scope="module")
def workbench(server):
    """The address of the workbench."""
    return json.loads(server.stdout.readline())["url"]


def until(page: Any, expression: str) -> None:
    """Wait until something is so. A page whose policy forbids `eval` cannot be asked to tell by itself."""
    assert any(page.evaluate(expression) or page.wait_for_timeout(50) for _ in range(600)), (
        expression
    )


class Opened:
    """A page with all that went wrong on it."""

    def __init__(self, browser: Any, address: str, **context: Any) -> None:
        self.context = browser.new_context(**context)
        self.page, self.base, self.troubles = (
            self.context.new_page(),
            address.split("?", maxsplit=1)[0],
            [],
        )
        self.page.on("console", self._hear)
        self.page.on("pageerror", lambda error: self.troubles.append(str(error)))
        self.page.on("dialog", lambda dialog: dialog.dismiss())
        self.page.on("request", self._see)
        self.page.on(
            "response",
            lambda answer: self.troubles.append(answer.url) if answer.status >= 500 else None,
        )
        self.page.goto(address)
        self.ready()

    def _hear(self, message: Any) -> None:
        if (
            message.type in ("error", "warning") and "status of 4" not in message.text
        ):  # a refusal is an answer
            self.troubles.append(message.text)

    def _see(self, request: Any) -> None:
        if not request.url.startswith(
            (self.base, "data:", "blob:", self.base.replace("http", "ws"))
        ):
            self.troubles.append(f"asked elsewhere: {request.url}")

    def ready(self) -> None:
        self.page.wait_for_selector("html[data-ready]", timeout=60_000)

    def go(self, page: str) -> None:
        for loads in range(3):
            try:
                self._go(page)
                return
            except Exception as error:  # another language loads the page anew
                if loads == 2 or "context was destroyed" not in str(error):
                    raise

    def _go(self, page: str) -> None:
        self.ready()
        if not self.page.url.endswith(f"#/{page}"):
            words = (
                "page => { delete document.documentElement.dataset.ready; location.hash = page; }"
            )
            self.page.evaluate(words, f"/{page}")
        self.ready()
        self.page.wait_for_selector(".jobs > p.muted", state="detached")  # until its jobs were told
        self.page.evaluate(DRAWN)


FOCUS = """() => {
  const one = document.activeElement, style = getComputedStyle(one), box = one.getBoundingClientRect();
  if (one === document.body) return null;
  const isSeen = box.bottom > 0 && box.top < innerHeight && box.right > 0 && box.left < innerWidth;
  return [one.outerHTML.slice(0, 120), isSeen && style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) > 0];
}"""


@pytest.mark.pages
def test_the_keyboard_goes_everywhere_and_is_seen(workbench, browser):
    opened = Opened(browser, workbench, viewport={"width": 390, "height": 720})
    page = opened.page
    for name in ("record?path=run.nc", "studies", "ride"):
        opened.go(name)
        page.evaluate("document.activeElement.blur()")
        stops = []
        for _ in range(25):
            page.keyboard.press("Tab")
            stops.append(page.evaluate(FOCUS))
        assert [one[0] for one in stops if one and not one[1]] == [], name
        assert sum(one is not None for one in stops) > 20
    opened.go("project")
    page.locator(".skip").focus()
    page.keyboard.press("Enter")  # goes to the content, and to no page of that name
    assert page.evaluate("[document.activeElement.id, location.hash]") == ["main", "#/project"]
    page.get_by_role("main").get_by_role("link", name="run.nc", exact=True).press("Enter")
    page.wait_for_selector("html[data-ready=record]")
    until(page, "document.activeElement.id === 'main'")  # the link is gone: on to what it led to
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.title") == "Export this page"
    page.keyboard.press("Tab")
    assert (
        page.evaluate("document.activeElement.textContent")
        == "Analyse and compare with other recordings"
    )
    page.context.close()
    assert opened.troubles == []


@pytest.mark.pages
@pytest.mark.parametrize(
    ("width", "scheme", "language"),
    [(1280, "light", "en-GB"), (390, "dark", "de-DE"), (1280, "dark", "en-GB")],
)
def test_every_page_is_usable_without_a_mouse_and_without_sight(
    workbench, browser, width, scheme, language
):
    """By the rules of WCAG 2.2 AA that axe knows; nothing wider than the window, nothing on the console."""
    if not AXE.is_file():
        pytest.skip("axe is not installed: npm ci in viewer/")
    rules = AXE.read_text(encoding="utf-8")
    opened = Opened(
        browser,
        workbench,
        viewport={"width": width, "height": 720},
        color_scheme=scheme,
        locale=language,
    )
    found = []
    for page in PAGES:
        opened.go(page)
        assert opened.page.evaluate("document.documentElement.scrollWidth") <= width, page
        opened.page.evaluate(f"typeof axe === 'undefined' && (() => {{ {rules} }})()")
        told = opened.page.evaluate("rules => axe.run(document, {runOnly: rules})", RULES)
        serious = [one for one in told["violations"] if one["impact"] in ("serious", "critical")]
        found += [
            (page, one["id"], [node["html"][:120] for node in one["nodes"][:3]]) for one in serious
        ]
        assert told["passes"], "nothing was looked at"
    shown = opened.page.locator("#pages").inner_text()
    opened.context.close()
    assert found == []
    assert opened.troubles == []
    assert ("Fahrwerk" in shown) == language.startswith("de")


@pytest.mark.pages
def test_axe_finds_what_is_wrong(browser):
    if not AXE.is_file():
        pytest.skip("axe is not installed: npm ci in viewer/")
    page = browser.new_page()
    page.set_content(
        "<html><body><img src='x.png'><button></button><p style='color:#ccc'>pale</p></body></html>"
    )
    page.evaluate(AXE.read_text(encoding="utf-8"))
    told = page.evaluate("rules => axe.run(document, {runOnly: rules})", RULES)
    page.close()
    assert {"image-alt", "button-name", "color-contrast"} <= {
        one["id"] for one in told["violations"]
    }


@pytest.mark.pages
def test_the_language_that_was_chosen_stays(workbench, browser):
    opened = Opened(browser, workbench, locale="en-GB")
    opened.page.get_by_role("button", name="Deutsch").click()
    opened.page.get_by_role("heading", name="Mit einem Beispiel beginnen").wait_for()
    opened.go(f"rig?name={RIG}")
    opened.page.get_by_role("button", name="Speichern").wait_for()
    assert opened.page.evaluate("document.documentElement.lang") == "de"
    opened.go("studies")
    opened.page.get_by_role(
        "columnheader", name="Verteilung"
    ).wait_for()  # a head is a word, a number's path is none
    opened.context.close()
    assert opened.troubles == []


ALIKE = {
    "x",
    "y",
    "z",
    "exponent",
    "phase",
    "schema",
    "sigma",
    "progression",
    "xx",
    "xy",
    "xz",
    "yy",
    "yz",
    "zz",
}
"""What German calls the same, or a letter."""


def _collect_keys(schema: Any, keys: set[str]) -> None:
    """Names of the values that a form shows."""
    if isinstance(schema, dict):
        keys.update(schema.get("properties", {}))
        schema = list(schema.values())
    if isinstance(schema, list):
        for one in schema:
            _collect_keys(one, keys)


@pytest.mark.pages
def test_every_quantity_has_its_german_words(workbench, browser):
    """Catalogues, channels of runs and of an axle's sweep; names that files and commands use stay as they are."""
    from jounce.kinematics.catalogue import CATALOGUE
    from jounce.parts.files import library
    from jounce.recordings.schema import QUANTITIES
    from jounce.ride.catalogue import CATALOGUE as METRICS
    from jounce.web import forms

    corner = jn.load("kart-double-wishbone")
    trial = jn.Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm"), speed="2 m/s", duration="0.1 s"
    )
    runs = [
        jn.simulate(jn.load("kart-quarter-car"), trial),
        jn.simulate(corner, trial, detail=True),
        jn.sweep_roll(corner, "-1 deg:1 deg:1 deg"),
        jn.sweep_travel(corner, "-1 mm:1 mm:1 mm", points=True),
    ]
    words = {str(run[name].attrs["long_name"]) for run in runs for name in run.data_vars}
    words |= (
        {one.long_name for one in CATALOGUE}
        | {one.label for one in METRICS}
        | {text for _, text in QUANTITIES.values()}
    )
    names = {one.name for one in CATALOGUE} | {f"left.{one.name}" for one in CATALOGUE}
    names |= {str(name) for name in runs[2].data_vars}
    opened = Opened(browser, workbench, locale="de-DE")
    keys: set[str] = set()
    for name in library():
        _collect_keys(forms.schema(jn.load(name).model), keys)
    opened = Opened(browser, workbench, locale="de-DE")
    told = "([words, names, keys]) => [words.map(jounce.spoken), names.map(jounce.quantity), keys.map(jounce.key)]"
    asked = [sorted(words), sorted(names), sorted(keys - ALIKE)]
    answers = opened.page.evaluate(told, asked)
    opened.context.close()
    left = [
        english
        for own, said in zip(asked, answers, strict=True)
        for english, german in zip(own, said, strict=True)
        if german == english.replace("_", " ") or german == english
    ]
    assert left == []


@pytest.mark.pages
def test_what_the_server_refuses_is_said_in_the_language_of_the_page(workbench, browser):
    opened = Opened(browser, workbench, locale="de-DE")
    opened.go(f"kinematics?rig={RIG}")
    state = opened.page.get_by_role("status").first
    for typed, told in [
        ("-20 mm:20 mm:0.01 um", "zu viele"),
        ("-20 mm:20 parsnips:2 mm", "gefunden"),
        ("-20 m:20 m:2 m", "zulässig"),
    ]:
        area = opened.page.get_by_label("Radhub, Einfedern positiv: ")
        area.fill(typed)
        area.press("Tab")
        state.filter(has_text=told).wait_for(timeout=10_000)
    opened.go(f"rig?name={RIG}")
    mass = opened.page.locator("[data-path='sprung.mass'] input").first
    mass.fill("-3 kg")
    mass.press("Tab")
    wrong = opened.page.get_by_role("alert").filter(has_text="über 0 kg").first
    wrong.wait_for(timeout=10_000)
    assert (
        "außerhalb des Bereichs; gefunden -3 kg; zulässig: über 0 kg"
        in wrong.inner_text().replace("'", "")
    )
    opened.context.close()
    assert opened.troubles == []


BEGINS = (
    "begin,run the campaign,search,fit,simulate,compare,evaluate,find,resume,again,start,test,check"
)
"""Words of buttons that begin long work, which two processors do not do beside a browser."""
TYPED = [
    "10 mm",
    "-20 mm:20 mm:5 mm",
    "3",
    "0",
    "-1",
    "1e9",
    "2 kg",
    "",
    "<b>x</b>",
    "../x.toml",
    "ä € 漢",
    "NaN",
    "x" * 300,
]


CONTROLS = "button:enabled, a[href^='#'], select:enabled, input:enabled, summary, textarea, canvas"
GONE = (
    "Timeout",
    "not attached",
    "not visible",
    "not connected",
    "Element is not an",
    "context was destroyed",
)
"""What is said of an element, or a page, that has been replaced or hidden since it was chosen."""


_SETTLED = 5000.0  # ms, in which late answers come, and the server has a pause to tidy up


def _clicked_at_random(
    opened: Opened, seed: int, seconds: float, held: Callable[[], float]
) -> list[list[float]]:
    """Use what is on the page at random; give seconds passed, and bytes of the page's heap and of the server."""
    drawn, page, begin = random.Random(seed), opened.page, time.monotonic()
    devtools = opened.context.new_cdp_session(page)
    kept: list[list[float]] = []
    while (passed := time.monotonic() - begin) < seconds:
        if passed >= len(kept) * min(150.0, 0.25 * seconds):
            opened.go("project")
            page.wait_for_timeout(min(_SETTLED, 20.0 * seconds))
            for _ in range(2):  # what the first lets go of may hold more
                devtools.send("HeapProfiler.collectGarbage")
                page.wait_for_timeout(200)
            kept.append([passed, devtools.send("Runtime.getHeapUsage")["usedSize"], held()])
            at, heap, server = kept[-1]
            sys.stdout.write(
                f"{at:6.0f} s: page {1e-6 * heap:.2f} MB, server {1e-6 * server:.2f} MB\n"
            )
            sys.stdout.flush()
            assert opened.troubles == []  # what an hour more would not mend
        if drawn.random() < 0.08:
            opened.go(drawn.choice(PAGES))
        controls: list[Any] = []
        try:
            controls = page.query_selector_all(CONTROLS)
            if not controls:
                opened.go("project")
                continue
            _use(drawn.choice(controls), drawn)
        except Exception as error:
            if not any(words in str(error) for words in GONE):
                raise
        for one in controls:
            one.dispose()
        page.wait_for_timeout(drawn.choice((20, 60, 200)))
    opened.go("project")
    return kept


def _use(control: Any, drawn: random.Random) -> None:
    """Use one element, which stays the one that was chosen while the page changes."""
    kind, values, name = control.evaluate(
        """one => [one.tagName + ' ' + (one.type || ''), [...(one.options || [])].map(option => option.value),
                   ((one.textContent || '') + (one.ariaLabel || '')).toLowerCase()]"""
    )
    if kind.startswith("SELECT"):
        if values:
            control.select_option(drawn.choice(values), timeout=500)
    elif kind.endswith(("text", "search", "number")) or kind.startswith("TEXTAREA"):
        text = drawn.choice(TYPED)
        control.fill("7" if kind.endswith("number") else text, timeout=500)
        control.press("Tab", timeout=500)
    elif kind.endswith("range"):
        control.press(
            drawn.choice(("ArrowLeft", "ArrowRight", "Home", "End", "PageUp")), timeout=500
        )
    elif not kind.endswith("file") and not any(word in name for word in BEGINS.split(",")):
        control.click(timeout=500, position={"x": 3, "y": 3} if kind.startswith("CANVAS") else None)


@pytest.mark.pages
def test_clicks_at_random_break_nothing(workbench, browser):
    opened = Opened(browser, workbench, viewport={"width": 1280, "height": 720})
    _clicked_at_random(opened, int(os.environ.get("JOUNCE_SEED", "18")), 30.0, lambda: 0.0)
    opened.context.close()
    assert opened.troubles == []


def _meet_all(address: str) -> None:
    """Ask the server for a run and a sweep of every shipped rig, and keep the run; not all of them can have all."""
    base, _, token = address.partition("?token=")
    road = {"kind": "half-sine", "height": "10 mm", "length": "60 mm", "start": "0.2 m"}
    head = {"Authorization": f"Bearer {token}", "Content-Type": "application/json"}
    for name in library():
        run = {"road": road, "speed": "2 m/s", "duration": "0.5 s"}
        for path, asked in (
            ("simulate", run),
            (
                "keep",
                run | {"title": f"first of {name}"},
            ),  # drawn runs are of whole mechanisms, kept ones reduced
            ("kinematics", {"travel": "-5 mm:5 mm:5 mm"}),
        ):
            content = json.dumps({"rig": name, **asked}).encode()
            with contextlib.suppress(urllib.error.HTTPError):
                urllib.request.urlopen(
                    urllib.request.Request(f"{base}api/{path}", content, head)
                ).read()


@pytest.mark.slow
def test_minutes_of_clicks_break_nothing_and_hold_no_memory(server, workbench, browser):
    """What a page held is given back when it is left, and what the server holds is bounded.

    Ten minutes, or as many as JOUNCE_MINUTES says. An hour and more tell how much an hour adds, after the first
    quarter, in which the pages load what they need; the server has met all shipped rigs before, more than it keeps.
    """
    memory = pytest.importorskip("psutil").Process(server.pid).memory_info
    _meet_all(workbench)
    minutes = float(os.environ.get("JOUNCE_MINUTES", "10"))
    opened = Opened(browser, workbench, viewport={"width": 1280, "height": 720})
    seed = int(os.environ.get("JOUNCE_SEED", "1801"))
    kept = np.array(
        _clicked_at_random(opened, seed, 60.0 * minutes, lambda: memory().rss - memory().shared)
    )
    opened.context.close()
    assert opened.troubles == []
    later = kept[len(kept) // 4 :]
    if minutes < 60.0:
        assert later[-1, 1] - later[0, 1] < 3e6, kept[:, 1]
    else:
        page, held = (np.polyfit(later[:, 0] / 3600.0, later[:, i], 1)[0] for i in (1, 2))
        assert page < 1e6, f"{page:.0f} bytes an hour"
        assert held < 1e6, f"{held:.0f} bytes an hour"


@pytest.mark.pages
def test_a_finer_travel_draws_its_ways_whole(workbench, browser):
    opened = Opened(browser, workbench, viewport={"width": 1280, "height": 900})
    opened.go(f"kinematics?rig={RIG}")
    travel = opened.page.get_by_label("Wheel travel, bump positive: ")
    for step in ("4 mm", "0.4 mm"):
        drawn = opened.page.evaluate("jounce.live.times.length")
        travel.fill(f"-20 mm:20 mm:{step}")
        travel.press("Tab")
        until(opened.page, f"jounce.live.times.length > {drawn}")
        opened.page.evaluate(DRAWN)
    opened.context.close()
    assert opened.troubles == []


@pytest.mark.pages
def test_what_is_drawn_is_as_fine_as_the_screen(workbench, browser):
    """Drawn coarser, curves and their numbers were blurred on screens of two pixels a point, and on enlarged pages."""
    opened = Opened(
        browser, workbench, viewport={"width": 1280, "height": 900}, device_scale_factor=2
    )
    for page, drawn in (
        (f"kinematics?rig={RIG}", ".multiples canvas"),
        (f"trial?rig={RIG}", ".phase canvas"),
    ):
        opened.go(page)
        fine = (
            f"Array.from(document.querySelectorAll('{drawn}'), one => one.width / one.clientWidth)"
        )
        until(opened.page, f"{fine}.length && {fine}.every(share => Math.abs(share - 2) < 0.01)")
    opened.context.close()
    assert opened.troubles == []


@pytest.mark.pages
def test_the_mechanism_rolls_with_the_body(workbench, browser):
    """In front view what the body holds goes up where its left side does; the sweep itself is in the body's axes."""
    opened = Opened(browser, workbench, viewport={"width": 1280, "height": 900})
    opened.go(f"kinematics?rig={RIG}")
    drawn = opened.page.evaluate("jounce.live.times.length")
    opened.page.get_by_label("Curves over").select_option("roll")
    until(opened.page, f"jounce.live.times.length > {drawn}")
    opened.page.get_by_role("button", name="front", exact=True).click()
    angle = opened.page.get_by_label("Roll, left side up positive [deg], typed")
    name, heights = opened.page.locator(".names span", has_text="strut top"), []
    for roll in (-4, 0, 4):
        angle.fill(str(roll))
        opened.page.evaluate(DRAWN)
        heights.append(name.evaluate("one => -one.getBoundingClientRect().top"))
    opened.context.close()
    assert opened.troubles == []
    up, down = heights[2] - heights[1], heights[1] - heights[0]
    assert up > 2.0, heights
    assert up == pytest.approx(down, rel=0.2, abs=1.5)  # pixels


@pytest.mark.pages
def test_a_folder_and_a_file_beside_its_place_are_no_uploads_and_a_day_is_that_of_the_page(
    workbench, browser, tmp_path
):
    opened = Opened(
        browser, workbench, viewport={"width": 1280, "height": 900}, timezone_id="Pacific/Auckland"
    )
    page, devtools = opened.page, opened.context.new_cdp_session(opened.page)
    page.clock.set_fixed_time("2026-01-31T20:00:00Z")
    opened.go("inspection")
    assert page.get_by_label("Date", exact=True).input_value() == "2026-02-01"
    folder = tmp_path / "lane records"
    folder.mkdir()
    zone = page.locator(".drop").bounding_box()
    drag = {"items": [], "files": [str(folder)], "dragOperationsMask": 1}
    page.evaluate(
        "addEventListener('drop', (event) => { window.isKept = event.defaultPrevented; })"
    )
    for y in (zone["y"] - 40, zone["y"] + 20):  # above it, then in it
        for kind in ("dragEnter", "dragOver", "drop"):
            devtools.send(
                "Input.dispatchDragEvent",
                {"type": kind, "x": zone["x"] + 600, "y": y, "data": drag},
            )
        until(page, "window.isKept === true")
    page.get_by_role("alert").filter(has_text="lane records: a folder").wait_for()
    opened.context.close()
    assert opened.troubles == []


LACKING = """
for (const storage of ["localStorage", "sessionStorage"])
  Object.defineProperty(window, storage, { get() { throw new DOMException("denied", "SecurityError"); } });
Object.defineProperty(navigator, "clipboard", { value: undefined });
window.WebSocket = class extends EventTarget {
  constructor() { super(); setTimeout(() => this.dispatchEvent(new Event("close"))); }
};
"""
"""A browser that may keep nothing, at an address of another machine, behind a proxy that lets no socket through."""


@pytest.mark.pages
def test_pages_work_where_a_browser_keeps_nothing_and_a_proxy_lets_no_socket_through(
    workbench, browser
):
    context = browser.new_context(viewport={"width": 1280, "height": 720})
    context.add_init_script(LACKING)
    page, troubles = context.new_page(), []
    page.on("console", lambda told: troubles.append(told.text) if told.type == "error" else None)
    page.on("pageerror", lambda error: troubles.append(str(error)))
    page.goto(workbench)
    page.wait_for_selector("html[data-ready=project]")
    for name in (*PAGES, f"rig?name={RIG}"):
        page.evaluate(
            "page => { delete document.documentElement.dataset.ready; location.hash = page; }",
            f"/{name}",
        )
        page.wait_for_selector("html[data-ready]")
        page.wait_for_selector(
            ".jobs > p.muted", state="detached"
        )  # they are told without a socket
    code = page.locator("section.code", has_text="The same in Python")
    code.get_by_role("button").click()
    code.get_by_role("button", name="Selected: copy it").wait_for()
    assert "jn.load(" in page.evaluate("getSelection().toString()")
    assert page.get_by_text("The server no longer reports on jobs").count() == 0
    context.close()
    assert troubles == []


def _saved(page: Any, menu: Any, entry: str, folder: Path) -> Path:
    menu.locator("summary").click()
    with page.expect_download(timeout=60_000) as download:
        menu.get_by_role("button", name=entry, exact=True).click()
    file: Path = folder / download.value.suggested_filename
    download.value.save_as(file)
    return file


@pytest.mark.pages
def test_what_a_page_shows_is_saved_and_copied(workbench, browser, tmp_path):
    """Curves with the numbers that are drawn, within the range that is visible; tables, drawings and the page."""
    allowed = {"accept_downloads": True, "permissions": ["clipboard-read", "clipboard-write"]}
    opened = Opened(browser, workbench, viewport={"width": 1280, "height": 900}, **allowed)
    page = opened.page
    opened.go(f"trial?rig={RIG}")
    until(page, "document.querySelectorAll('.plots canvas').length > 2")
    curves = page.locator("details.save").filter(has_text="Copy the numbers")
    assert _saved(page, curves, "SVG", tmp_path).read_text().startswith("<svg")
    assert _saved(page, curves, "PNG × 2", tmp_path).read_bytes().startswith(b"\x89PNG")
    rows = _saved(page, curves, "CSV", tmp_path).read_text("utf-8-sig").splitlines()
    assert rows[0].startswith("time [s],")
    assert "sprung.az" in rows[0]
    assert [float(rows[k].split(",")[0]) for k in (1, -1)] == [0.0, 1.5]
    curves.locator("summary").click()
    curves.get_by_role("button", name="Copy the numbers").click()
    until(page, "navigator.clipboard.readText().then((text) => text.startsWith('time [s]\\t'))")
    page.get_by_role("button", name="+", exact=True).click()
    seen = _saved(page, curves, "CSV", tmp_path).read_text("utf-8-sig").splitlines()
    assert 3 < len(seen) < 0.6 * len(rows)
    drawing = page.locator(".mechanism details.save")
    assert _saved(page, drawing, "PNG × 2", tmp_path).stat().st_size > 10_000
    whole = page.locator("main > .saving details")
    assert _saved(page, whole, "PDF document", tmp_path).read_bytes().startswith(b"%PDF")
    assert "sprung.az" in _saved(page, whole, "HTML report", tmp_path).read_text()
    opened.go("project")
    table = page.locator(".savable details.save").first
    assert RIG in _saved(page, table, "CSV", tmp_path).read_text("utf-8-sig")
    assert opened.troubles == []
    opened.context.close()


LOADED = """() => performance.getEntriesByType("resource")
  .filter((one) => /\\.(js|css)$/.test(one.name)).map((one) => [one.name, one.transferSize])"""


@pytest.mark.pages
def test_a_page_loads_its_own_script_only_and_once(workbench, browser):
    """The first page has at most 150 kB, those of other pages come when they are opened."""
    opened = Opened(browser, workbench)
    opened.go("project")
    first = dict(opened.page.evaluate(LOADED))
    assert 20_000 < sum(first.values()) < 150_000
    assert not any(word in name for name in first for word in ("/trial-", "/german-"))
    opened.page.evaluate("location.hash = '#/jobs'")
    opened.page.wait_for_selector("html[data-ready=jobs]")
    assert any("/jobs-" in name for name in dict(opened.page.evaluate(LOADED)))
    opened.page.reload()
    opened.page.wait_for_selector("html[data-ready=jobs]")
    assert sum(dict(opened.page.evaluate(LOADED)).values()) == 0  # from the browser's cache
    opened.page.route("**/studies-*.js", lambda route: route.abort())
    opened.page.evaluate("location.hash = '#/studies'")
    opened.page.get_by_text("This page could not be loaded").wait_for()
    opened.context.close()


@pytest.mark.pages
def test_everything_is_found_by_its_name(workbench, browser):
    """Pages, files, curves and actions from every page; the filter of curves takes what its example shows."""
    opened = Opened(browser, workbench, viewport={"width": 1280, "height": 900})
    page = opened.page
    opened.go(f"kinematics?rig={RIG}")
    assert page.title() == f"Kinematics of {RIG} – Kinematics – jounce workbench"
    until(page, "document.querySelectorAll('.multiples figure').length > 20")
    page.keyboard.press("Control+k")
    matches = page.locator("dialog [role=option]")
    page.locator("dialog input").fill("roll centre h")
    listed = "[...document.querySelectorAll('dialog [role=option]')].map((one) => one.innerText)"
    until(page, f"{listed}.join('|') === 'roll centre height\\ncurve'")
    page.keyboard.press("Enter")
    until(page, "document.querySelectorAll('dialog').length === 0")
    curve = page.locator(".multiples figure", has_text="roll centre height")
    until(page, "scrollY > 0")
    assert curve.is_visible()
    page.locator("details.save summary").first.focus()
    page.keyboard.press("Control+k")  # a menu keeps the keys of the curves around it, not this one
    page.locator("dialog[open]").wait_for()
    page.keyboard.press("Escape")
    page.get_by_placeholder("camber, roll centre").fill("camber, roll centre …")
    assert 2 <= page.locator(".multiples figure:visible").count() <= 8
    page.keyboard.press("Control+k")
    page.locator("dialog input").fill("run view")
    matches.get_by_text("run.nc: view").wait_for()
    page.keyboard.press("Enter")
    page.wait_for_selector("html[data-ready=record]")
    page.evaluate("document.activeElement.blur()")
    page.keyboard.press("?")
    assert page.get_by_role("dialog").get_by_role("heading").inner_text() == "Keys"
    page.keyboard.press("Escape")
    page.keyboard.press("Control+k")
    page.locator("dialog input").fill("no such thing")
    assert matches.all_inner_texts() == ["nothing found"]
    page.keyboard.press("Enter")
    page.keyboard.press("Escape")
    assert page.get_by_role("dialog").count() == 0
    assert opened.troubles == []
    opened.context.close()
