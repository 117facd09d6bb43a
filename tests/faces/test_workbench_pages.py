"""The pages of long work in a real browser: each used for its main task by roles and labels, light and dark."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest

pytestmark = pytest.mark.pages
uvicorn = pytest.importorskip("uvicorn")
TOKEN = "a-token-of-these-tests"
DRAWN = (
    "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done())))"
)
EVIL = "<img src=x onerror=document.title='gone'>"
STUDY = """schema = "jounce.sweep/1"
rig = "kart-quarter-car"
metrics = ["max sprung.az"]
trial = {speed = "2 m/s", duration = "1 s", road = {kind = "half-sine", height = "10 mm", length = "60 mm"}}
design = {kind = "monte-carlo", count = 300000}
vary = {"strut.spring.rate" = "20 %"}
"""


@pytest.fixture(scope="module")
def server(workbench):
    folder, port = workbench
    return folder, f"http://127.0.0.1:{port}/"


class Opened:
    """A page with what went wrong on it, and what it asked for."""

    def __init__(self, page: Any, base: str) -> None:
        self.page, self.base = page, base
        self.troubles: list[str] = []
        self.asked: list[str] = []
        page.set_default_timeout(120_000)
        page.on(
            "console",
            lambda message: self.troubles.append(message.text) if message.type != "log" else None,
        )
        page.on("pageerror", lambda error: self.troubles.append(str(error)))
        page.on("request", lambda request: self.asked.append(request.url))

    def go(self, name: str, values: str = "") -> None:
        self.page.evaluate("delete document.documentElement.dataset.ready")
        self.page.goto(f"{self.base}#/{name}?{values}")
        self.page.wait_for_selector(f"html[data-ready={name}]")

    def fits(self) -> None:
        """Nothing hangs over the edge, wide and light as narrow and dark."""
        for width, scheme in ((390, "dark"), (1280, "light")):
            self.page.set_viewport_size({"width": width, "height": 720})
            self.page.emulate_media(color_scheme=scheme)
            self.page.evaluate(DRAWN)
            assert self.page.evaluate("document.documentElement.scrollWidth") <= width


@contextmanager
def opened(browser: Any, address: str) -> Iterator[Opened]:
    base = address.partition("?")[0]
    context = browser.new_context(viewport={"width": 1280, "height": 720})
    found = Opened(context.new_page(), base)
    found.page.goto(address)
    found.page.wait_for_selector("html[data-ready=project]")
    yield found
    title = found.page.title()
    context.close()
    assert "gone" not in title
    refusals = ("422", "409")  # which the browser tells, too
    assert [one for one in found.troubles if not any(code in one for code in refusals)] == []
    assert [url for url in found.asked if not url.startswith((base, "data:", "blob:"))] == []


def test_a_campaign_is_begun_measured_and_run(server, browser, tmp_path):
    folder, base = server
    with opened(browser, f"{base}?token={TOKEN}") as one:
        page = one.page
        one.go("campaign")
        page.get_by_text("No campaign in this project yet").wait_for()
        page.get_by_role("button", name="Copy into this project").click()
        page.get_by_role("heading", name="My bench campaign").wait_for()
        page.get_by_role("button", name="Separate damping and friction").click()
        page.locator("iframe[title^=Free]").wait_for()
        assert (
            "13.19" in page.get_by_role("region", name="estimates").inner_text()
        )  # N, of the synthetic example
        report = page.frame_locator("iframe[title^=Free]")
        report.get_by_role("heading", name="Answer").wait_for()

        spring = tmp_path / "soft spring.csv"
        spring.write_text("way;F\n" + "\n".join(f"{-0.5 * i};{-11 * i}" for i in range(40)))
        broken = tmp_path / "broken.mat"
        broken.write_bytes(b"MATLAB 5.0" + bytes(range(256)) * 4)
        page.locator("input[type=file]").set_input_files(str(broken))
        page.get_by_role("heading", name="campaign/measured/broken.mat").wait_for()
        page.locator(".reading .problem").wait_for()
        assert "broken.mat" in page.locator(".reading .problem").inner_text()
        page.locator("input[type=file]").set_input_files(str(spring))
        page.get_by_label("quantity of way").wait_for()
        page.get_by_label("Type of measurement").select_option("spring")
        page.get_by_label("quantity of way").and_(page.locator("select")).select_option(
            "displacement"
        )
        page.get_by_label("quantity of F").and_(page.locator("select")).select_option("force")
        page.get_by_text("no unit").first.wait_for()
        page.get_by_label("unit of way").fill("kg")
        page.get_by_label("unit of way").press("Tab")
        page.get_by_text("wrong unit").first.wait_for()
        page.get_by_label("unit of way").fill("mm")
        page.get_by_label("unit of way").press("Tab")
        page.get_by_label("unit of F").fill("N")
        page.get_by_label("unit of F").press("Tab")
        page.get_by_label("Stroke").last.select_option("extension")
        page.locator(".reading select").nth(1).select_option("tension")
        page.get_by_text("preview of 40 samples").wait_for()
        page.locator(".xy[aria-label*='over deflections from 0 to 19.5 mm']").wait_for()
        one.fits()
        page.get_by_label("Replace the example files").check()
        page.get_by_role("button", name="Add to the campaign").click()
        parts = page.locator(
            "section.job", has=page.get_by_role("heading", name="spring", exact=True)
        )
        parts.get_by_role("button", name="view campaign/measured/soft spring.csv").wait_for()
        assert (
            'stroke_positive = "extension"' in (folder / "campaign" / "campaign.toml").read_text()
        )

        text = page.get_by_label("text of campaign/campaign.toml")
        for written, told in (("[[[", "not valid TOML"), ("high_path", "high_path")):
            page.get_by_text("Campaign file", exact=True).click()
            text.fill(text.input_value().replace("high_pass", written, 1))
            page.get_by_role("button", name="Save", exact=True).click()
            page.get_by_role("alert").filter(
                has_text=told
            ).wait_for()  # and its text is there to be mended
            assert written in text.input_value()
            page.get_by_role("button", name="Undo").click()
            page.get_by_role("heading", name="Trials").wait_for()
        page.get_by_text("Campaign file", exact=True).click()
        text.fill(text.input_value().replace('title = "My', 'title = "Our'))
        page.get_by_role("button", name="Save", exact=True).click()
        page.get_by_role("heading", name="Our bench campaign").wait_for()

        page.get_by_role("button", name="Run the campaign").click()
        page.locator(".reported h2").filter(has_text="Answer").wait_for()
        assert page.locator(".reported").get_by_text("of 1 hold").first.is_visible()
        page.locator(".reported h2").filter(has_text="Validation").wait_for()
        page.get_by_role("link", name="drive: campaign/results/rig-").wait_for()
        page.reload()
        page.locator(".reported h2").filter(has_text="Answer").wait_for()
        one.fits()


def test_a_study_is_written_swept_brushed_and_its_variant_driven(server, browser):
    _, base = server
    with opened(browser, f"{base}?token={TOKEN}") as one:
        page = one.page
        one.go("studies")
        page.get_by_text("No sweeps yet").wait_for()
        page.locator("form select").first.select_option("kart-quarter-car")
        share = page.get_by_label("strut.spring.rate, share")
        share.fill("20 kg")
        page.get_by_label("Count").fill("32")
        page.get_by_role("button", name="Save the study").click()
        page.get_by_role("alert").wait_for()
        assert "strut.spring.rate" in page.get_by_role("alert").inner_text()
        share.fill("20 %")
        page.get_by_role("button", name="Save and start").click()
        page.get_by_text("32 variants started").wait_for()
        page.get_by_role("button", name="Show the results: Sweep study").click()
        page.get_by_role("heading", name="Sensitivity of the metrics").wait_for()
        region = page.get_by_role("region", name="what rms sprung.az depends on")
        assert region.get_by_role("row").nth(1).inner_text().startswith("strut.spring.rate")
        page.get_by_text("32 of 32 variants", exact=True).wait_for()
        half = re.compile(r"^1[5-7] of 32 variants$")
        page.get_by_text("Ranges as numbers").click()
        page.get_by_label("strut.spring.rate, from [N/mm]").fill("22.7")
        page.get_by_label("strut.spring.rate, from [N/mm]").press("Tab")
        page.get_by_text(half).wait_for()
        page.get_by_role("button", name="All variants").click()
        drawing = page.get_by_role("region", name="parallel coordinates").locator("canvas")
        drawing.scroll_into_view_if_needed()
        box = drawing.bounding_box()
        page.mouse.move(box["x"] + 65, box["y"] + 26)
        page.mouse.down()
        page.mouse.move(box["x"] + 65, box["y"] + 151, steps=4)
        page.mouse.up()
        page.get_by_text(half).wait_for()  # the upper half
        one.fits()
        page.get_by_role("link", name="as a trial").first.click()
        page.wait_for_selector("html[data-ready=trial]")
        page.wait_for_selector(".player .u-over")
        assert (
            "--set=strut.spring.rate="
            in page.get_by_label("The same on the command line").inner_text()
        )
        one.go("jobs")
        page.get_by_role("heading", name="Sweep study").wait_for()


def test_a_record_is_graded_kept_and_found_again(server, browser):
    folder, base = server
    with opened(browser, f"{base}?token={TOKEN}") as one:
        page = one.page
        one.go("inspection")
        page.get_by_text("No store in this project yet").wait_for()
        page.get_by_text("No record available?").click()
        page.get_by_role("button", name="Simulate the test").click()
        page.get_by_role("link", name="Evaluate").click()
        page.locator(
            "select:has(option[value='simulated.csv'])"
        ).first.wait_for()  # the page that was left knows none
        assert page.get_by_label("Record of one axle").input_value() == "simulated.csv"
        page.get_by_label("Number plate").first.fill(f"B-AB 1 {EVIL}")
        page.get_by_label("Save in the store").fill("lane.sqlite")
        page.get_by_role("button", name="Evaluate and grade").click()
        page.locator("iframe[title='Test report']").wait_for()
        assert (
            "pass"
            in page.get_by_role("region", name="wheels").get_by_role("row").nth(1).inner_text()
        )
        protocol = page.frame_locator("iframe[title='Test report']")
        protocol.get_by_text("simulated").first.wait_for()
        assert protocol.locator("img[src=x]").count() == 0
        one.fits()
        assert (folder / "lane.sqlite").is_file()
        one.go("project")
        one.go("inspection")
        page.get_by_role("button", name="Search").click()
        found = page.get_by_role("region", name="records")
        found.wait_for()
        assert "<img" in found.inner_text()  # markup of a number plate is text
        page.get_by_role("button", name="history of").click()
        page.locator("iframe[title='Every visit']").wait_for()
        page.get_by_text("One visit shows no trend").wait_for()
        one.fits()


def test_controllers_are_compared_and_best_designs_open_as_rides(server, browser):
    _, base = server
    with opened(browser, f"{base}?token={TOKEN}") as one:
        page = one.page
        one.go("ride")
        page.get_by_label("Duration").fill("4 s")
        page.get_by_role("button", name="Drive", exact=True).click()
        table = page.get_by_role("region", name="controllers")
        table.wait_for()
        assert "skyhook" in table.inner_text()
        page.frame_locator("iframe.report").get_by_role("heading", name="Spectra").first.wait_for()
        one.fits()
        one.go("ride")
        page.get_by_text("No finished ride yet").wait_for(state="hidden")
        page.get_by_label("Vehicle or rig").first.select_option("kart-quarter-car")
        page.get_by_label("Duration").fill("3 s")
        page.get_by_role("button", name="Drive", exact=True).click()
        page.get_by_role("region", name="controllers").wait_for()
        one.go("ride")
        assert page.get_by_role("button", name="Draw").is_disabled()
        for rig, control in (
            ("audi-a6-quarter-car", "passive"),
            ("audi-a6-quarter-car", "skyhook"),
            ("kart-quarter-car", "passive"),
        ):
            page.get_by_label(f"{rig} on iso:C at 20 m/s, {control}").check()
        page.get_by_role("button", name="Draw").click()
        page.locator(".player .u-over").first.wait_for()
        assert (
            page.locator(
                ".player .toggle, .player button", has_text="kart-quarter-car, passive, 3 s"
            ).count()
            == 1
        )
        page.get_by_label("Curves over").select_option("frequency (spectra)")
        page.get_by_text("m/s²/√Hz").first.wait_for()
        assert (
            "rides['audi-a6-quarter-car, skyhook, 4 s']"
            in page.get_by_label("The same in Python").last.inner_text()
        )
        one.fits()
        page.get_by_label("bounds").fill("600..6000 N*s/m")
        page.get_by_label("Designs").fill("4")
        page.get_by_role("button", name="Search").click()
        page.get_by_role("link", name="open design 2 as a ride").last.click()
        page.get_by_text("changed (SI): strut.damper.coefficient").wait_for()
        page.get_by_label("Speed").first.fill("20 kg")
        page.get_by_role("button", name="Drive", exact=True).click()
        page.locator(".mark.bad").wait_for()
        assert "wrong unit" in page.get_by_role("alert").inner_text()


def test_a_job_outlives_its_server_in_the_page(browser, tmp_path):
    """The server is killed while a sweep runs; the page says so, and that of the next one shows it going on."""
    (tmp_path / "study.toml").write_text(STUDY)
    (tmp_path / f"{EVIL.replace('/', '')}.csv").write_text("t,x\n")

    def started() -> tuple[subprocess.Popen[str], str]:
        command = [sys.executable, "-m", "jounce", "serve", str(tmp_path), "--no-open", "--json"]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        assert process.stdout is not None
        with process.stdout:
            return process, json.loads(process.stdout.readline())["url"]

    server, address = started()
    context = browser.new_context()
    page = context.new_page()
    page.set_default_timeout(120_000)
    try:
        page.goto(address)
        page.get_by_text("<img").first.wait_for()
        page.goto(address.partition("?")[0] + "#/studies")
        page.get_by_role("button", name="Start study.toml").click()
        page.get_by_text("simulating").wait_for()
        server.kill()
        server.wait()
        page.get_by_text("no longer reports on jobs").wait_for()
        server, address = started()
        page.goto(address)
        page.goto(address.partition("?")[0] + "#/jobs")
        page.get_by_text("left").wait_for()
        page.get_by_role("button", name="Cancel: Sweep study").click()
        page.locator(".mark.fair", has_text="cancelled").wait_for()
        page.get_by_role("button", name="Resume: Sweep study").click()
        page.locator(".job .state:visible", has_text="simulating").wait_for()
        page.reload()
        page.get_by_role("button", name="Cancel: Sweep study").click()
        page.locator(".mark.fair", has_text="cancelled").nth(1).wait_for()
        assert "gone" not in page.title()
    finally:
        context.close()
        server.kill()
        server.wait()
