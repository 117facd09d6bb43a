"""Reports: time to write, open, zoom and play them in a browser with software rendering."""

from __future__ import annotations

import shutil
import statistics
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import xarray as xr
from timing import Row

import jounce as jn
from jounce.papers.demo import run_demo
from jounce.plots import time_history, write_figure
from jounce.recordings import recording
from jounce.report import REPORTS, recordings_page, write_campaign

ARGUMENTS = ("--no-sandbox", "--disable-quic")
FRAMES = """async () => {
  const player = jounce.players[0], [first, last] = player.plots.whole, times = [];
  const next = () => new Promise((done) => requestAnimationFrame(done));
  let before = await next();
  for (let k = 0; k < 90; k++) {
    const low = first + (last - first) * 0.4 * k / 90, wide = (last - first) * (0.6 - 0.5 * k / 90);
    player.zoom(low, low + wide);
    player.goTo(low + wide * 0.5);
    const now = await next();
    times.push(now - before);
    before = now;
  }
  return times;
}"""


def report_rows() -> list[Row]:
    """All rows; those of the browser only if one is installed."""
    with tempfile.TemporaryDirectory(prefix="jounce-bench-") as folder:
        _, result = run_demo(Path(folder) / "demo")
        write_campaign(result, Path(folder) / "warm")
        page = _processor(lambda: write_campaign(result, Path(folder) / "report", force=True))
        both = _processor(
            lambda: write_campaign(result, Path(folder) / "both", force=True, pdf=True)
        )
        size = (Path(folder) / "report" / "report.html").stat().st_size
        problem = "report of the shipped campaign, 16 trials (processor time)"
        rows = [
            Row(
                problem,
                "jounce, one HTML file",
                page,
                None,
                1.0,
                "≤ 2.5 s",
                f"{1e-6 * size:.1f} MB",
            ),
            Row(problem, "jounce, and the same as PDF", both, None, both / page, "+ 1 s"),
        ]
        signal = np.sin(np.arange(10_000_000) / 700.0)
        long = recording(np.arange(10_000_000) / 1000.0, {"sprung.az": (signal, "m/s^2", "")})
        picture = _processor(
            lambda: write_figure(time_history(long), Path(folder) / "long.png", force=True),
            repeats=3,
        )
        rows.append(
            Row(
                "plot of a recording of 10 million samples",
                "jounce, PNG",
                picture,
                None,
                1.0,
                "≤ 3 s",
            )
        )
        page = _processor(lambda: _long_page(long, Path(folder) / "long.html"), repeats=3)
        rows.append(
            Row(
                "page of a recording of 10 million samples",
                "jounce, HTML",
                page,
                None,
                1.0,
                "≤ 3 s",
            )
        )
        return rows + _browser_rows(Path(folder))


def _long_page(long: xr.Dataset, file: Path) -> None:
    REPORTS.write(recordings_page({"long": long}, ["sprung.az"], title="long"), file, force=True)


def _processor(work: Callable[[], object], repeats: int = 5) -> float:
    """Median of the processor time in s."""
    times = []
    for _ in range(repeats):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return statistics.median(times)


def _browser_rows(folder: Path) -> list[Row]:
    chromium = shutil.which("chromium")
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        return []
    if chromium is None:
        return []
    rig = jn.load("kart-double-wishbone")
    trial = jn.Trial(road=jn.Iso8608(class_="A", length=25.0), speed=2.0, duration="10 s")
    run = jn.simulate(rig, trial)
    curves = recordings_page(
        {"run": run}, ["sprung.az", "unsprung.az", "tyre.force"], title="run", rig=rig, trial=trial
    )
    REPORTS.write(curves, folder / "run.html")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=list(ARGUMENTS))
        page = browser.new_page(viewport={"width": 1400, "height": 900})
        opened = []
        for _ in range(5):
            page.goto((folder / "report" / "report.html").as_uri())
            page.wait_for_selector("html[data-ready]")
            opened.append(1e-3 * page.evaluate("performance.now()"))
        page.goto((folder / "run.html").as_uri())
        page.wait_for_selector("html[data-ready]")
        page.locator(".player").scroll_into_view_if_needed()
        frames = [1e-3 * one for one in page.evaluate(FRAMES)]
        browser.close()
    ready, frame = statistics.median(opened), statistics.median(frames)
    note = "Chromium without a graphics card"
    return [
        Row(
            "report of 16 trials, from opening until usable",
            "jounce",
            ready,
            None,
            1.0,
            "≤ 1 s",
            note,
        ),
        Row(
            "zoom and pan of 3 x 10 000 points, mechanism moving: one frame",
            "jounce",
            frame,
            None,
            1.0,
            "≤ 100 ms",
            note,
        ),
    ]
