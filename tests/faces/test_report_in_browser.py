"""Reports as people see them: opened from disk in Chromium, zoomed, played, light and dark, wide and narrow."""

from __future__ import annotations

import io
import os
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import jounce as jn
from jounce.campaign import run_campaign
from jounce.cli import main
from jounce.papers.audi_a6 import run_audi_a6
from jounce.report import (
    REPORTS,
    Page,
    PageTable,
    Paragraph,
    Section,
    recordings_page,
    write_campaign,
    write_page,
)
from jounce.report.kc import kc_page
from jounce.report.live import Curve, Pane, Viewer, ViewerScene
from jounce.report.papers import audi_case_page

pytestmark = pytest.mark.pages

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


class Opened:
    """A page in the browser, and everything that it complained about or asked for."""

    def __init__(
        self,
        browser: Any,
        file: Path,
        width: int = 1400,
        scheme: str = "light",
        *,
        script: bool = True,
    ) -> None:
        size = {"width": width, "height": 900}
        self.context = browser.new_context(
            viewport=size, color_scheme=scheme, java_script_enabled=script
        )
        self.page = self.context.new_page()
        self.troubles: list[str] = []
        self.asked: list[str] = []
        self.page.on(
            "console",
            lambda message: self.troubles.append(message.text) if message.type != "log" else None,
        )
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


def until(page: Any, expression: str) -> None:
    """Wait until something is so. A page whose policy forbids `eval` cannot be asked to tell by itself."""
    assert any(page.evaluate(expression) or page.wait_for_timeout(50) for _ in range(600)), (
        expression
    )


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1400])
def test_a_campaign_s_report_is_zoomed_and_played(
    browser: Any, report: Path, width: int, scheme: str
) -> None:
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
    assert [low, high] == pytest.approx(
        [before[0] + 0.2 * span, before[0] + 0.6 * span], abs=0.02 * span
    )
    scales = page.evaluate(f"{player}.plots.plots.map(one => [one.scales.x.min, one.scales.x.max])")
    assert scales == [[low, high]] * 2  # both plots show the same
    page.evaluate(f"{player}.goTo({low})")
    page.get_by_role("button", name="Play", exact=True).click()
    until(page, f"Math.abs({player}.now - {low}) > 1e-6")
    page.get_by_role("button", name="Pause", exact=True).click()
    painted = page.evaluate(
        """() => { const one = document.querySelector(".mechanism canvas"), { width, height } = one;
        const pixels = one.getContext("2d").getImageData(0, 0, width, height).data;
        return pixels.filter((value, i) => i % 4 === 3 && value > 0).length / (width * height); }"""
    )
    assert 0.05 < painted < 0.9
    opened.close()


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1280])
def test_a_kc_sheet_has_its_overview_first_and_a_page_for_each_test(
    browser: Any, tmp_path: Path, width: int, scheme: str
) -> None:
    sheet = jn.kc_sheet("double-wishbone-elastic", ["bounce", "steer", "lateral-opposed"], points=9)
    file = tmp_path / "sheet.html"
    REPORTS.write(kc_page(sheet, title="K&C <b>front</b>"), file)
    opened = Opened(browser, file, width, scheme)
    page = opened.page
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    assert page.locator("h1").inner_text() == "K&C <b>front</b>"
    headings = page.locator("h2").all_inner_texts()
    assert headings == ["Overview", "Bounce", "Steer", "Lateral, opposed", "Axle", "Conditions"]
    first = page.locator("#overview tbody tr").first.inner_text()
    assert "N/mm" in first
    charts = page.locator("#bounce svg.chart")
    assert charts.count() == 7  # the drawing and six curves
    lefts = [charts.nth(k).bounding_box()["x"] for k in range(1, 7)]
    assert len({round(x) for x in lefts}) == (3 if width > 1000 else 1)
    assert page.locator("#bounce path.l.dotted").count() >= 6  # fitted lines
    page.emulate_media(media="print")
    start = page.locator("#steer").evaluate("one => getComputedStyle(one).breakBefore")
    assert start == "page"
    opened.close()


BUMP = 'kind = "half-sine"\nheight = "8 mm"\nlength = "100 mm"\nstart = "0.2 m"\n'
STUDY = """schema = "jounce.design/1"
rig = "formula-student-front"
[[free]]
point = "hardpoints.tie_rod_inner"
within = "15 mm"
[[target]]
quantity = "toe"
over = "-30 mm:30 mm:15 mm"
value = "0 deg"
tolerance = "0.03 deg"
"""
SWEEP = """schema = "jounce.sweep/1"
rig = "kart-double-wishbone"
metrics = ["max sprung.az"]
outputs = ["sprung.z"]
trial = {speed = "2 m/s", duration = "0.5 s", road = "bump.toml"}
design = {kind = "sobol", count = 16}
[vary]
"strut.spring.rate" = "20 %"
"hardpoints.upper_ball_joint[2]" = {sd = "1 mm"}
"""
KART = "kart-double-wishbone"
QUARTER = ("audi-a6-quarter-car", "--road", "iso:C", "--speed", "20 m/s", "--duration", "5 s")
COMMANDS: dict[str, tuple[str, ...]] = {
    "simulate": (
        "simulate",
        KART,
        "--road",
        "bump.toml",
        "--speed",
        "2 m/s",
        "--duration",
        "0.5 s",
        "--out",
        "a.nc",
    ),
    "faster": (
        "simulate",
        KART,
        "--road",
        "bump.toml",
        "--speed",
        "3 m/s",
        "--duration",
        "0.5 s",
        "--out",
        "b.nc",
    ),
    "comparison": ("plot", "a.nc", "b.nc"),
    "kinematics": ("kinematics", KART, "--travel", "-10 mm:10 mm:2 mm"),
    "ride": ("ride", *QUARTER),
    "controllers": ("compare", *QUARTER, "--control", "passive,skyhook"),
    "modes": ("modes", "kart-quarter-car"),
    "roughness": ("iri", "profile.csv", "--segment", "20 m"),
    "models": ("study", "lumped-vs-spatial", KART, "--speed", "2 m/s", "--duration", "0.3 s"),
    "design": ("design", "kinematics", "study.toml", "--starts", "1", "--out", "design"),
    "sweep": ("sweep", "sweep.toml", "--out", "swept"),
    "record": (
        "inspect",
        "simulate",
        "audi-a6-quarter-car",
        "--method",
        "egea",
        "--out",
        "lane.csv",
    ),
    "protocol": ("inspect", "evaluate", "lane.csv", "--tester", "egea-specsus2018"),
    "german": (
        "inspect",
        "evaluate",
        "lane.csv",
        "--tester",
        "egea-specsus2018",
        "--language",
        "de",
    ),
    "equivalence": ("study", "inspection-equivalence", "audi-a6-quarter-car", "--points", "2"),
    "animation": ("animate", KART, "--travel", "-10 mm:10 mm:2 mm"),
}
MOVING = ("simulate", "kinematics", "models", "design", "sweep", "animation")
"""Pages whose mechanism moves with the curves."""
PAGES = [name for name in COMMANDS if name not in ("faster", "record")] + ["study"]
# Golden: small pictures of every kind of page in Chromium
KEPT = Path(__file__).parent / "pages"
SCALE, TALLEST, ALIKE = 20, 2400, 5.0
"""Pixels that become one in a picture that is kept, how much of a page it shows, and grey levels (of 255) by which one
of another machine, with its fonts, may differ on average."""


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """One page of every kind, written by its command."""
    folder = tmp_path_factory.mktemp("pages")
    (folder / "bump.toml").write_text(BUMP, encoding="utf-8")
    (folder / "study.toml").write_text(STUDY, encoding="utf-8")
    (folder / "sweep.toml").write_text(SWEEP, encoding="utf-8")
    x = np.arange(0.0, 60.0, 0.1)
    rows = "".join(f"{a:.1f},{0.01 * np.sin(a):.5f}\n" for a in x)
    (folder / "profile.csv").write_text(f"x [m],z [m]\n{rows}", encoding="utf-8")
    found = {}
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        for name, words in COMMANDS.items():
            wanted = (
                ()
                if {"--out", "--report"} & set(words) - ({"--out"} if name == "simulate" else set())
                else (name,)
            )
            report = [word for one in wanted for word in ("--report", f"{one}.html")]
            assert main([*words, *report]) == 0, name
            found[name] = folder / (f"{name}.html" if report else f"{words[-1]}/report.html")
    study = audi_case_page(run_audi_a6("case-a"))
    found["study"] = REPORTS.write(study, folder / "study.html")
    return found


def shrunk(png: bytes) -> Any:
    """The top of a page in grey, in little."""
    from PIL import Image

    picture = Image.open(io.BytesIO(png)).convert("L")
    return picture.resize((picture.width // SCALE, picture.height // SCALE), Image.Resampling.BOX)


def apart(one: Any, other: Any) -> float:
    """Grey levels by which two pictures differ on average, blurred; all of them where their sizes do."""
    from PIL import ImageFilter

    if one.width != other.width or abs(one.height - other.height) > 0.06 * other.height:
        return 255.0
    blurred = (
        picture.resize(other.size).filter(ImageFilter.GaussianBlur(2)) for picture in (one, other)
    )
    first, second = (np.asarray(picture, float) for picture in blurred)
    return float(np.abs(first - second).mean())


@pytest.mark.parametrize(("width", "scheme"), [(1400, "light"), (390, "dark")])
@pytest.mark.parametrize("name", PAGES)
def test_every_kind_of_page_is_opened_zoomed_and_played(
    browser: Any, pages: dict[str, Path], name: str, width: int, scheme: str
) -> None:
    from PIL import Image

    opened = Opened(browser, pages[name], width, scheme)
    page = opened.page
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    tall = page.evaluate("document.documentElement.scrollHeight")
    dark = page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(21, 25, 29)"
    assert dark == (scheme == "dark")
    words = {"Light": "Hell", "Dark": "Dunkel"} if name == "german" else {}
    to = "Light" if dark else "Dark"
    button = page.get_by_role("button", name=words.get(to, to), exact=True)
    assert button.is_visible()
    top = {"x": 0, "y": 0, "width": width, "height": min(tall, TALLEST)}
    seen = shrunk(page.screenshot(full_page=True, clip=top))
    kept = KEPT / f"{name}-{width}.png"
    if os.environ.get("JOUNCE_KEEP_PAGES"):
        seen.save(kept, optimize=True)
    with Image.open(kept) as before:
        assert apart(seen, before) < ALIKE
    has_player = page.evaluate("typeof jounce === 'object' && (jounce.players ?? []).length > 0")
    assert has_player == (name not in ("modes", "equivalence"))
    if has_player and width == 1400:
        assert page.evaluate("jounce.players[0].view !== null") == (name in MOVING)
        first, last = page.evaluate("jounce.players[0].plots.whole")
        low, high = first + 0.2 * (last - first), first + 0.6 * (last - first)
        page.evaluate(f"jounce.players[0].zoom({low}, {high})")
        assert page.evaluate("jounce.players[0].plots.window") == pytest.approx([low, high])
        if name in MOVING:
            page.evaluate(f"jounce.players[0].goTo({low})")
            page.get_by_role("button", name="Play", exact=True).click()
            assert any(
                page.wait_for_timeout(100) or page.evaluate("jounce.players[0].now") > low
                for _ in range(100)
            )
    if width == 1400:
        page.emulate_media(media="print", color_scheme="dark")
        assert (
            page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
        )
        assert not has_player or not page.locator(".player").first.is_visible()
    opened.close()


def test_a_german_page_has_german_buttons_and_decimal_commas(
    browser: Any, pages: dict[str, Path]
) -> None:
    opened = Opened(browser, pages["german"])
    page = opened.page
    page.locator(".player").scroll_into_view_if_needed()
    page.evaluate("jounce.players[0].goTo(1.25)")
    assert page.locator(".clock").inner_text() == "1,250 s"
    words = page.locator(".player").inner_text()
    for word in (
        "Plattenkraft",
        "Abspielen",
        "Tempo",
        "Echtzeit",
        "Großansicht",
        "Alles",
        "Zeit [s]",
    ):
        assert word in words or word == "Zeit [s]", word
    for word in ("Play", "speed", "channels", "Full window", "Drag", "plate"):
        assert word not in words, word
    page.get_by_role("button", name="Abspielen", exact=True).click()
    assert page.get_by_role("button", name="Pause", exact=True).is_visible()
    opened.close()


def test_an_animation_is_turned_named_and_swept_back(browser: Any, pages: dict[str, Path]) -> None:
    opened = Opened(browser, pages["animation"])
    page = opened.page
    until(page, "[...document.querySelectorAll('.names span')].every(one => one.style.transform)")
    names = page.locator(".names span")
    assert names.count() == 11
    places = [
        tuple(names.nth(k).bounding_box()[key] for key in ("x", "y", "width")) for k in range(11)
    ]
    for k, (x, y, width) in enumerate(places):
        for other_x, other_y, other_width in places[k + 1 :]:
            is_beside = x + width <= other_x or other_x + other_width <= x
            assert is_beside or abs(y - other_y) > 11.0  # names stand below each other
    page.get_by_role("button", name="names", exact=True).click()
    assert not names.first.is_visible()
    assert "spring and damper" in page.locator(".legend").inner_text()
    player = "jounce.players[0]"
    page.evaluate(f"{player}.goTo(9.9)")
    page.locator(".transport select").select_option("1")
    page.get_by_role("button", name="Play", exact=True).click()
    assert any(page.wait_for_timeout(50) or page.evaluate(f"{player}.way") < 0 for _ in range(100))
    assert page.evaluate(f"{player}.now") > 0.0  # it goes back the way it came
    opened.close()


def test_pictures_of_other_pages_are_told_apart() -> None:
    from PIL import Image

    kept = [
        Image.open(KEPT / f"{name}-{width}.png")
        for name in ("simulate", "ride", "protocol")
        for width in (390, 1400)
    ]
    for i, one in enumerate(kept):
        assert [apart(one, other) < ALIKE for other in kept] == [k == i for k in range(len(kept))]


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
            return one.points[one.shown.names.indexOf("lower_ball_joint")]; }"""
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
    pane = Pane(
        HOSTILE,
        HOSTILE,
        HOSTILE,
        (Curve(HOSTILE, "measured", x), Curve("</script><b>", "before", np.sin(x))),
    )
    scenes = tuple(ViewerScene(name, HOSTILE, x, (pane, pane), HOSTILE) for name in ("one", "two"))
    viewer = Viewer(HOSTILE, scenes, (("measured", HOSTILE, True), ("before", "漢字" * 150, True)))
    table = PageTable(HOSTILE, (HOSTILE,), ((HOSTILE,),))
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
            return one.points[one.shown.names.indexOf("upper_ball_joint")]; }"""
        )
        true = [
            1e3 * float(sweep[f"upper_ball_joint.{axis}"].interp(wheel_travel=1e-3 * travel))
            for axis in "xyz"
        ]
        assert place == pytest.approx(true, abs=0.02)  # mm
    assert opened.page.locator(".clock").inner_text() == "3.000 mm"
    opened.page.get_by_role("button", name="Play", exact=True).click()
    until(opened.page, "jounce.players[0].now > 3.2")
    opened.close()


def test_missing_and_infinite_values_are_gaps(browser: Any, tmp_path: Path) -> None:
    x = np.linspace(0.0, 1.0, 101)
    values = np.where(x < 0.5, x, np.nan)
    values[3] = np.inf
    scene = ViewerScene("one", "one", x, (Pane("a", "a", "mm", (Curve("a", "measured", values),)),))
    write_page(
        Page("t", (Section("s", (Viewer("t", (scene,), (("measured", "a", True),)),)),)),
        tmp_path / "out",
    )
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
    assert (
        opened.page.evaluate("getComputedStyle(document.body).backgroundColor") == "rgb(21, 25, 29)"
    )
    opened.close()


def test_a_page_refuses_scripts_that_are_not_its_own(report: Path) -> None:
    html = report.read_text(encoding="utf-8")
    policy = re.search(r'Content-Security-Policy" content="([^"]+)"', html)
    assert policy is not None
    assert "default-src 'none'" in policy[1]
    assert re.search(r"script-src 'sha256-[A-Za-z0-9+/=]{44}';", policy[1])
    assert report.stat().st_size < 3_000_000


def test_a_mechanism_is_turned_moved_and_enlarged(browser: Any, report: Path) -> None:
    """With the mouse and with two fingers; the wheel scrolls the page until the mechanism is clicked on."""
    opened = Opened(browser, report)
    page = opened.page
    until(page, "jounce.players[0].view.camera.height > 100")
    page.locator(".mechanism").scroll_into_view_if_needed()
    box = page.locator(".mechanism canvas").bounding_box()
    x, y = box["x"] + 20, box["y"] + box["height"] - 20

    def seen() -> tuple[float, float, float, float]:
        words = (
            "(({ azimuth, elevation, scale, target }) => [azimuth, elevation, scale, target[2]])"
        )
        return tuple(page.evaluate(f"{words}(jounce.players[0].view.camera)"))

    def drag(dx: float, dy: float, button: Any = "left") -> None:
        page.mouse.move(x, y)
        page.mouse.down(button=button)
        page.mouse.move(x + dx, y + dy)
        page.mouse.up(button=button)

    azimuth, elevation, scale, height = seen()
    page.mouse.move(x, y)
    page.mouse.wheel(0, -100)
    page.wait_for_timeout(100)
    assert seen() == (azimuth, elevation, scale, height)
    page.mouse.wheel(0, 100)
    page.locator(".mechanism").scroll_into_view_if_needed()
    box = page.locator(".mechanism canvas").bounding_box()
    x, y = box["x"] + 20, box["y"] + box["height"] - 20
    drag(60, -30)
    rate = 2 * np.pi / box["height"]
    assert seen() == pytest.approx((azimuth - 60 * rate, elevation - 30 * rate, scale, height))
    drag(0, 3000)
    assert seen()[1] == pytest.approx(np.pi / 2)  # no further than from above
    page.get_by_role("button", name="front", exact=True).click()
    _, _, scale, height = seen()
    drag(0, -50, "right")
    assert seen() == pytest.approx((0.0, 0.0, scale, height - 50 / scale))
    page.mouse.wheel(0, -100)
    until(page, f"jounce.players[0].view.camera.scale > {scale}")
    assert seen()[2] == pytest.approx(scale / 0.95)
    fingers = page.context.new_cdp_session(page)
    places = [[x, y], [x + 100, y]], [[x, y], [x + 200, y]]
    for kind, points in (("touchStart", places[0]), ("touchMove", places[1]), ("touchEnd", [])):
        touched = [{"x": a, "y": b, "id": i} for i, (a, b) in enumerate(points)]
        fingers.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": touched})
    assert seen()[2] == pytest.approx(2 * scale / 0.95)
    page.mouse.dblclick(x, y)
    assert seen()[:2] == pytest.approx((azimuth, elevation))
    opened.close()
