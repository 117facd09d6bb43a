"""Reports as people see them: opened from disk in Chromium, zoomed, played, light and dark, wide and narrow."""

from __future__ import annotations

import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import jounce as jn
from jounce.campaign import run_campaign
from jounce.report import (
    REPORTS,
    Page,
    Paragraph,
    Section,
    Table,
    recordings_page,
    write_campaign,
    write_page,
)
from jounce.report.live import Curve, Pane, Scene, Viewer

sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")
pytestmark = pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed")

HOSTILE = '<img src=x onerror="document.title=1">'
CAMPAIGN = """schema = "jounce.campaign/1"
title = "Kart <b>bench</b>"
synthetic = "Made by a test."
rig = "kart-double-wishbone"
[roads.A]
kind = "half-sine"
height = "8 mm"
length = "100 mm"
start = "0.2 m"
[[trial]]
number = 1
speed = "2 m/s"
road = "A"
recording = "1.csv"
use = "fit"
[[trial]]
number = 2
speed = "3 m/s"
road = "A"
recording = "2.csv"
"""


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with sync_api.sync_playwright() as playwright:
        arguments = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
        made = playwright.chromium.launch(executable_path=CHROMIUM, args=[*arguments, "--disable-quic"])
        yield made
        made.close()


class Opened:
    """A page in the browser, and everything that it complained about or asked for."""

    def __init__(
        self, browser: Any, file: Path, width: int = 1400, scheme: str = "light", *, script: bool = True
    ) -> None:
        size = {"width": width, "height": 900}
        self.context = browser.new_context(viewport=size, color_scheme=scheme, java_script_enabled=script)
        self.page = self.context.new_page()
        self.troubles: list[str] = []
        self.asked: list[str] = []
        self.page.on("console", lambda message: self.troubles.append(message.text) if message.type != "log" else None)
        self.page.on("pageerror", lambda error: self.troubles.append(str(error)))
        self.page.on("request", lambda request: self.asked.append(request.url))
        self.page.goto(file.as_uri())
        if script:
            self.page.wait_for_selector("html[data-ready]", timeout=30_000)

    def close(self) -> None:
        """No error in the console, nothing asked for but the file itself and what the script makes of its text."""
        self.context.close()
        assert self.troubles == []
        assert [url for url in self.asked[1:] if not url.startswith(("data:", "blob:"))] == []


@pytest.fixture(scope="module")
def report(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The report of a 3-D rig's campaign of two trials."""
    folder = tmp_path_factory.mktemp("kart")
    rig = jn.load("kart-double-wishbone")
    road = jn.HalfSine(height="8 mm", length="100 mm", start="0.2 m")
    for number, speed in ((1, 2.0), (2, 3.0)):
        run = jn.simulate(rig, jn.Trial(road=road, speed=speed, duration="0.5 s"))
        jn.write_recording(run[["sprung.az", "unsprung.az"]], folder / f"{number}.csv")
    (folder / "campaign.toml").write_text(CAMPAIGN, encoding="utf-8")
    write_campaign(run_campaign(folder / "campaign.toml"), folder / "out")
    return folder / "out" / "report.html"


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1400])
def test_a_campaign_s_report_is_zoomed_and_played(browser: Any, report: Path, width: int, scheme: str) -> None:
    opened = Opened(browser, report, width, scheme)
    page = opened.page
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    dark = page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(21, 25, 29)"
    assert dark == (scheme == "dark")
    player = "jounce.players[0]"
    whole = page.evaluate(f"{player}.plots.whole")
    assert whole == pytest.approx([0.0, 0.5], abs=1e-9)
    page.locator(".player").scroll_into_view_if_needed()
    box = page.locator(".u-over").first.bounding_box()
    page.mouse.move(box["x"] + 0.2 * box["width"], box["y"] + 50)
    page.mouse.down()
    page.mouse.move(box["x"] + 0.6 * box["width"], box["y"] + 50, steps=4)
    before = page.evaluate(f"{player}.plots.window")
    page.mouse.up()
    low, high = page.evaluate(f"{player}.plots.window")
    span = before[1] - before[0]
    assert [low, high] == pytest.approx([before[0] + 0.2 * span, before[0] + 0.6 * span], abs=0.02 * span)
    scales = page.evaluate(f"{player}.plots.plots.map(one => [one.scales.x.min, one.scales.x.max])")
    assert scales == [[low, high]] * 2  # both plots show the same
    page.evaluate(f"{player}.goTo({low})")
    page.get_by_role("button", name="Play", exact=True).click()
    page.wait_for_timeout(600)
    assert page.evaluate(f"{player}.now") != pytest.approx(low, abs=1e-6)
    page.get_by_role("button", name="Pause", exact=True).click()
    painted = page.evaluate(
        """() => { const one = jounce.players[0].view; one.isDirty = true; one.draw();
        const gl = one.renderer.getContext(), w = gl.drawingBufferWidth, h = gl.drawingBufferHeight;
        const pixels = new Uint8Array(4 * w * h); gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        let count = 0; for (let i = 3; i < pixels.length; i += 4) count += pixels[i] > 0; return count / (w * h); }"""
    )
    assert 0.05 < painted < 0.9
    opened.close()


def test_values_of_the_viewer_are_those_of_the_recording(browser: Any, report: Path) -> None:
    opened = Opened(browser, report)
    recorded, _ = jn.read_recording(report.parents[1] / "1.csv")
    for time in (0.15, 0.3):
        opened.page.evaluate(f"jounce.players[0].goTo({time})")
        shown = opened.page.locator(".pane-head output").first.inner_text()
        true = float(recorded["sprung.az"].interp(time=time))
        range_ = float(np.ptp(recorded["sprung.az"].to_numpy()))
        assert float(shown.replace("−", "-")) == pytest.approx(true, rel=1e-3, abs=range_ / 60_000)
    opened.close()


def test_the_mechanism_stands_where_the_model_says(browser: Any, report: Path) -> None:
    opened = Opened(browser, report)
    rig = jn.load("kart-double-wishbone")
    road = jn.HalfSine(height="8 mm", length="100 mm", start="0.2 m")
    run = jn.simulate(rig, jn.Trial(road=road, speed=2.0, duration="0.5 s"), detail=True)
    for time in (0.0, 0.13, 0.2):
        opened.page.evaluate(f"jounce.players[0].goTo({time})")
        place = opened.page.evaluate(
            """() => { const one = jounce.players[0].view;
            return one.points[one.shown.names.indexOf("lower_ball_joint")].toArray(); }"""
        )
        true = [1e3 * float(run[f"lower_ball_joint.{axis}"].interp(time=time)) for axis in "xyz"]
        assert place == pytest.approx(true, abs=0.05)  # mm
    opened.close()


def test_trials_channels_curves_and_keys(browser: Any, report: Path) -> None:
    opened = Opened(browser, report)
    page = opened.page
    page.get_by_role("button", name="tyre.force").click()
    assert page.locator(".pane").count() == 3
    page.get_by_role("button", name="measured", exact=True).click()
    assert page.evaluate("jounce.players[0].plots.plots[0].series[1].show") is False
    page.locator('a[data-show="trial-02"]').first.click()
    assert page.locator(".player select").first.input_value() == "1"
    page.keyboard.press("0")
    assert page.evaluate("jounce.players[0].plots.window") == pytest.approx([0.0, 0.5])
    page.keyboard.press("+")
    low, high = page.evaluate("jounce.players[0].plots.window")
    assert high - low == pytest.approx(0.25)
    page.keyboard.press("f")
    assert page.evaluate("document.querySelector('.player').getBoundingClientRect().width") >= 1380
    page.keyboard.press("Escape")
    assert page.evaluate("document.querySelector('.player').getBoundingClientRect().width") < 1380
    page.get_by_role("button", name="Dark", exact=True).click()
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(21, 25, 29)"
    opened.close()


def test_without_a_script_the_figures_remain(browser: Any, report: Path) -> None:
    opened = Opened(browser, report, script=False)
    page = opened.page
    assert page.get_by_text("the figures below show the same").is_visible()
    page.locator("details summary", has_text="Trial 1").click()
    assert page.locator("#picture-trial-01 svg path.l.measured").first.is_visible()
    opened.close()


def test_on_paper_everything_is_unfolded_and_light(browser: Any, report: Path) -> None:
    opened = Opened(browser, report, scheme="dark")
    page = opened.page
    page.emulate_media(media="print", color_scheme="dark")
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
    assert not page.locator(".player").is_visible()
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    assert page.locator("#picture-trial-02 svg").first.is_visible()
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert not page.locator("#picture-trial-02 svg").first.is_visible()
    opened.close()


def test_on_a_phone_the_first_column_stays_and_axes_can_be_read(browser: Any, report: Path) -> None:
    opened = Opened(browser, report, 390)
    page = opened.page
    table = page.locator(".table", has_text="Model compared with measurement").first
    table.evaluate("one => { one.scrollLeft = 300; }")
    cell = table.locator("tbody tr th").first
    assert cell.bounding_box()["x"] == pytest.approx(table.bounding_box()["x"], abs=2)
    page.locator("details summary", has_text="Trial 1").click()
    text = page.locator("#picture-trial-01 svg text").first
    assert text.evaluate("one => one.getScreenCTM().a * 12") > 6.0
    opened.close()


def test_texts_are_never_markup(browser: Any, tmp_path: Path) -> None:
    x = np.linspace(0.0, 1.0, 50)
    pane = Pane(HOSTILE, HOSTILE, HOSTILE, (Curve(HOSTILE, "measured", x), Curve("</script><b>", "before", np.sin(x))))
    scenes = tuple(Scene(name, HOSTILE, x, (pane, pane), HOSTILE) for name in ("one", "two"))
    viewer = Viewer(HOSTILE, scenes, (("measured", HOSTILE, True), ("before", "漢字" * 150, True)))
    table = Table(HOSTILE, (HOSTILE,), ((HOSTILE,),))
    blocks = (viewer, table, Paragraph("</script><script>document.title=2</script>"))
    write_page(Page(HOSTILE, (Section(HOSTILE, blocks),)), tmp_path / "out")
    for width in (390, 1400):
        opened = Opened(browser, tmp_path / "out" / "report.html", width)
        assert opened.page.title() == HOSTILE
        assert opened.page.locator("img").count() == 0
        assert opened.page.evaluate("document.documentElement.scrollWidth") <= width
        opened.close()


def test_a_sweep_is_played_over_its_travel(browser: Any, tmp_path: Path) -> None:
    rig = jn.load("kart-double-wishbone")
    sweep = jn.sweep_travel(rig, np.linspace(-0.01, 0.01, 21), points=True)
    page = recordings_page({"kart": sweep}, ["camber", "toe"], title="Kart", rig=rig)
    opened = Opened(browser, REPORTS.write(page, tmp_path / "sweep.html"))
    for travel in (-10.0, 3.0):
        opened.page.evaluate(f"jounce.players[0].goTo({travel})")
        place = opened.page.evaluate(
            """() => { const one = jounce.players[0].view;
            return one.points[one.shown.names.indexOf("upper_ball_joint")].toArray(); }"""
        )
        true = [1e3 * float(sweep[f"upper_ball_joint.{axis}"].interp(wheel_travel=1e-3 * travel)) for axis in "xyz"]
        assert place == pytest.approx(true, abs=0.02)  # mm
    assert opened.page.locator(".clock").inner_text() == "3.000 mm"
    opened.page.get_by_role("button", name="Play", exact=True).click()
    opened.page.wait_for_timeout(500)
    assert opened.page.evaluate("jounce.players[0].now") > 3.2
    opened.close()


def test_missing_and_infinite_values_are_gaps(browser: Any, tmp_path: Path) -> None:
    x = np.linspace(0.0, 1.0, 101)
    values = np.where(x < 0.5, x, np.nan)
    values[3] = np.inf
    scene = Scene("one", "one", x, (Pane("a", "a", "mm", (Curve("a", "measured", values),)),))
    write_page(Page("t", (Section("s", (Viewer("t", (scene,), (("measured", "a", True),)),)),)), tmp_path / "out")
    opened = Opened(browser, tmp_path / "out" / "report.html")
    for time, text in ((0.25, "0.2500"), (0.75, "–"), (0.03, "–")):
        opened.page.evaluate(f"jounce.players[0].goTo({time})")
        assert opened.page.locator(".pane-head output").first.inner_text() == text
    opened.close()


def test_a_page_without_curves_is_small_and_turns_dark(browser: Any, tmp_path: Path) -> None:
    (file,) = write_page(Page("t", (Section("s", (Paragraph("p"),)),)), tmp_path / "out")
    assert file.stat().st_size < 30_000
    opened = Opened(browser, file)
    opened.page.get_by_role("button", name="Dark").click()
    assert opened.page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(21, 25, 29)"
    opened.close()


def test_a_page_refuses_scripts_that_are_not_its_own(report: Path) -> None:
    html = report.read_text(encoding="utf-8")
    policy = re.search(r'Content-Security-Policy" content="([^"]+)"', html)
    assert policy is not None
    assert "default-src 'none'" in policy[1]
    assert re.search(r"script-src 'sha256-[A-Za-z0-9+/=]{44}';", policy[1])
    assert report.stat().st_size < 3_000_000
