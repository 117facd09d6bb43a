"""Response times of the workbench: server and headless Chromium with software rendering, by `make bench-web`.

Every figure is the time a person waits: from the input event to the frame after the curves have been drawn. What the
medians were, and on which machine, is written into ``docs/explanation/workbench-speed.md`` with ``--write``.
"""

from __future__ import annotations

import json
import os
import platform
import shutil
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
from clicks import Clicks, prepare_project, settled_memory

TABLE = Path(__file__).parents[1] / "docs" / "explanation" / "workbench-speed.md"
CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")
ARGUMENTS = ["--no-sandbox", "--disable-quic"]
SLIDER = """async ([selector, count, values]) => {
  // Each value is set as a hand would, and waited for until the frame after its curves is on the screen.
  const times = [], frame = () => new Promise((done) => requestAnimationFrame(done));
  const slider = document.querySelector(selector), low = Number(slider.min), high = Number(slider.max);
  for (let i = 0; i < count; i++) {
    const before = jounce.live.times.length, began = performance.now();
    slider.value = String(low + (high - low) * (0.3 + 0.4 * ((i * 7) % count) / count));
    slider.dispatchEvent(new Event("input"));
    while (values && jounce.live.times.length === before) await frame();
    await frame(); await frame();
    times.push(performance.now() - began);
    await new Promise((done) => setTimeout(done, 60));
  }
  return times;
}"""


class Served:
    """Start a server for a folder in a separate process, and return its start time."""

    def __init__(self, folder: Path) -> None:
        began = time.perf_counter()
        command = [sys.executable, "-m", "jounce", "serve", str(folder), "--no-open", "--json"]
        cache = {"JOUNCE_CACHE_DIR": str(folder / "cache")}  # records of earlier runs do not count
        self.process = subprocess.Popen(
            command, stdout=subprocess.PIPE, text=True, env=os.environ | cache
        )
        assert self.process.stdout is not None
        said = json.loads(self.process.stdout.readline())
        self.address, self.token = said["url"], said["token"]
        self.base = self.address.partition("?")[0]
        self.ask("GET", "api/health")
        self.up = time.perf_counter() - began

    def end(self) -> None:
        """Stop the server."""
        self.process.terminate()
        self.process.wait(20)

    def ask(self, method: str, path: str, body: Any = None) -> Any:
        """Send a request like a script."""
        headers = {"Authorization": f"Bearer {self.token}", "Content-Type": "application/json"}
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.base + path, data, headers, method=method)  # noqa: S310 - this machine
        with urllib.request.urlopen(request, timeout=120) as answer:  # noqa: S310
            return json.load(answer)


def median(times: list[float]) -> str:
    """Median and 90th percentile, ms."""
    ordered = sorted(times)
    return f"{statistics.median(ordered):.0f} ms (90th percentile {ordered[int(0.9 * (len(ordered) - 1))]:.0f} ms)"


LENGTHS = {"long.nc": 10_000_000, "longest.nc": 100_000_000}
TEXT = 1_000_000  # rows of a text file


def long_record(file: Path, count: int) -> None:
    """Write a recording of one channel."""
    import h5py

    chunk, noise = 1 << 20, np.random.default_rng(0)
    with h5py.File(file, "w") as record:
        instants = record.create_dataset("time", (count,), "f8", chunks=(chunk,))
        instants.make_scale("time")
        values = record.create_dataset("sprung.az", (count,), "f4", chunks=(chunk,))
        values.dims[0].attach_scale(instants)
        instants.attrs["units"], values.attrs["units"] = "s", "m/s^2"
        for start in range(0, count, chunk):
            part = np.arange(start, min(start + chunk, count)) / 1000.0
            instants[start : start + len(part)] = part
            values[start : start + len(part)] = np.sin(part) + 0.1 * noise.standard_normal(
                len(part)
            )


def text_record(file: Path) -> float:
    """Write a text file of four columns; return its size, MB."""
    time_ = np.arange(TEXT) / 1000.0
    noise = np.random.default_rng(0).standard_normal((2, TEXT))
    np.savetxt(file, np.column_stack([time_, np.sin(time_), *noise]), fmt="%.6g", delimiter=",", comments="",
               header="time [s],sprung.az [m/s^2],unsprung.az [m/s^2],strut.deflection [mm]")  # fmt: skip
    return file.stat().st_size / 1e6


def open_text(page: Any, served: Served) -> float:
    """Return the time from a click in the open workbench to the curves of the text file, s."""
    page.goto(served.address)
    page.wait_for_selector("html[data-ready=project]")
    page.wait_for_timeout(6000)
    began = time.perf_counter()
    page.evaluate("location.hash = '#/record?path=long.csv'")
    page.wait_for_selector(".u-over", timeout=120_000)
    return time.perf_counter() - began


def measured(served: Served, folder: Path) -> list[tuple[str, str, str]]:
    """Rows: action, target, measurement."""
    from playwright.sync_api import sync_playwright

    rows = [("server up", "1.5 s", f"{served.up:.2f} s")]
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        context = browser.new_context(viewport={"width": 1280, "height": 720})
        page = context.new_page()
        page.goto("about:blank")
        began = time.perf_counter()
        page.goto(served.address)
        page.wait_for_selector("html[data-ready=project]")
        rows.append(("page ready", "1.5 s", f"{time.perf_counter() - began:.2f} s"))
        sizes = page.evaluate(SIZES)
        rows.append(("first page, compressed", "150 kB", f"{sum(sizes) / 1e3:.0f} kB"))
        paints = []
        for _ in range(7):
            page.reload()
            page.wait_for_selector("html[data-ready=project]")
            paints.append(page.evaluate(PAINT))
        rows.append(("first paint, warm", "300 ms", median(paints)))

        def opened(where: str, ready: str) -> None:
            page.goto(f"{served.base}#/{where}")
            page.wait_for_selector(ready, timeout=120_000)
            page.wait_for_timeout(2500)

        trial = "trial?rig=kart-double-wishbone&duration=10%20s"
        opened(trial, ".player .u-over")
        for name in ("strut.deflection",):
            page.get_by_role(
                "button", name=name, exact=True
            ).click()  # three curves of 10 000 samples stay
        path = ".slider[data-path='strut.spring.rate'] input[type=range]"
        times = page.evaluate(SLIDER, [path, 30, True])
        what = "slider to redrawn curves (3 x 10 000 samples, as changed and as it is) with the mechanism moving"
        rows.append((what, "100 ms", median(times)))
        for rig, target in (("formula-student-front", "–"), ("kart-quarter-car", "60 ms")):
            opened(f"trial?rig={rig}", ".player .u-over")
            times = page.evaluate(SLIDER, [path, 30, True])
            moved = page.evaluate(MOVED)
            rows.append(
                (
                    f"slider to redrawn curves, {rig}",
                    target,
                    f"{median(times)}, {moved / 1e3:.0f} kB a step",
                )
            )
        opened("kinematics?rig=formula-student-front", ".multiples figure")
        count = page.locator(".multiples figure").count()
        times = page.evaluate(DRAG, 30)
        rows.append((f"dragged hardpoint to {count} redrawn curves", "100 ms", median(times)))
        times = page.evaluate(SLIDER, [".drive input[type=range]", 30, False])
        rows.append(
            (f"travel slider to the pose of mechanism and {count} curves", "–", median(times))
        )
        opened("kc?rig=double-wishbone-elastic", ".sheet tbody tr:nth-child(30)")
        times = page.evaluate(SLIDER, [path, 30, True])
        rows.append(("slider to the redrawn test of a K&C sheet", "200 ms", median(times)))
        for name, count in LENGTHS.items():
            long_record(folder / name, count)
            began = time.perf_counter()
            opened(f"record?path={name}", ".u-over")
            spent = time.perf_counter() - began - 2.5
            rows.append(
                (
                    f"recording of {count:.0e} samples opened",
                    "3 s" if name == "long.nc" else "–",
                    f"{spent:.2f} s",
                )
            )
            times = page.evaluate(PAN, 40)
            rows.append(
                (
                    "panned by a fifth of what is seen: the frame",
                    "33 ms",
                    median([frame for frame, _ in times]),
                )
            )
            rows.append(
                ("and its finest curves", "no stutter", median([whole for _, whole in times]))
            )
            (folder / name).unlink()
        size = text_record(folder / "long.csv")
        again = Served(folder)
        for what, target, server in (
            ("opened", "50 MB/s", served),
            ("opened again", "0.5 s", served),
            ("opened again by another server", "0.5 s", again),
        ):
            spent = open_text(page, server)
            rows.append(
                (f"text of {size:.0f} MB {what}", target, f"{spent:.2f} s, {size / spent:.0f} MB/s")
            )
        again.end()
        rows.append(
            (
                "eight tabs and four jobs: the page answers in",
                "300 ms",
                busy(served, context, folder),
            )
        )
        browser.close()
    held = []
    clicks = Clicks(served.base, served.token)
    for _ in range(4):
        clicks.click(250)
        memory = settled_memory(served.process.pid)
        held.append(f"{memory['resident']:.0f}")
    rows.append(
        (
            "memory of the idle server after 250, 500, 750 and 1000 requests of all routes at random",
            "150 MB, flat",
            f"{', '.join(held)} MB; {memory['own']:.0f} MB of it not from files",
        )
    )
    return rows


SIZES = """performance.getEntriesByType("resource").filter((one) => /\\.(js|css)$/.test(one.name))
  .map((one) => one.transferSize)"""
PAINT = """performance.getEntriesByName("first-contentful-paint")[0].startTime"""
MOVED = """performance.getEntriesByType("resource").filter((one) => one.name.endsWith("/api/simulate")).at(-1)
  .decodedBodySize"""
DRAG = """async (count) => {
  const times = [], frame = () => new Promise((done) => requestAnimationFrame(done));
  const input = document.querySelector(".points input[aria-label='z [mm]']");
  document.querySelector(".points select").value = "tie_rod_inner";
  document.querySelector(".points select").dispatchEvent(new Event("change"));
  for (let i = 0; i < count; i++) {
    const before = jounce.live.times.length, began = performance.now();
    input.value = String(Number(input.value) + (i % 2 ? -1 : 1));
    input.dispatchEvent(new Event("change"));
    while (jounce.live.times.length === before) await frame();
    await frame(); await frame();
    times.push(performance.now() - began);
    await new Promise((done) => setTimeout(done, 60));
  }
  return times;
}"""
PAN = """async (count) => {
  const times = [], frame = () => new Promise((done) => requestAnimationFrame(done));
  const player = document.querySelector(".player");
  const press = (key) => player.dispatchEvent(new KeyboardEvent("keydown", { key }));
  for (let i = 0; i < 4; i++) { press("+"); await new Promise((done) => setTimeout(done, 200)); }
  for (let i = 0; i < count; i++) {
    const before = jounce.live.times.length, began = performance.now();
    press(i % 20 < 10 ? "ArrowRight" : "ArrowLeft");
    await frame();
    const drawn = performance.now() - began;
    while (jounce.live.times.length === before && performance.now() - began < 2000) await frame();
    await frame();
    times.push([drawn, performance.now() - began]);
  }
  return times;
}"""
STUDY = """schema = "jounce.sweep/1"
rig = "kart-quarter-car"
metrics = ["rms sprung.az"]

[trial]
speed = "2 m/s"
duration = "20 s"
road = {kind = "half-sine", height = "10 mm", length = "60 mm", start = "0.2 m"}

[design]
kind = "monte-carlo"
count = 100000

[vary]
"strut.spring.rate" = ["15 N/mm", "30 N/mm"]
"""


def busy(served: Served, context: Any, folder: Path) -> str:
    """Response time of small requests with four running jobs and eight open tabs."""
    jobs = []
    for k in range(4):
        (folder / f"busy-{k}.toml").write_text(STUDY, encoding="utf-8")
        jobs.append(
            served.ask(
                "POST", "api/jobs", {"kind": "sweep", "study": f"busy-{k}.toml", "out": f"busy-{k}"}
            )
        )
    tabs = [context.new_page() for _ in range(7)]
    for tab in tabs:
        tab.goto(f"{served.base}#/jobs")
    time.sleep(6.0)
    states = [served.ask("GET", f"api/jobs/{job['id']}")["state"] for job in jobs]
    times: list[float] = []

    def ask(path: str) -> None:
        began = time.perf_counter()
        served.ask("GET", path)
        times.append(1e3 * (time.perf_counter() - began))

    for k in range(40):
        workers = [
            threading.Thread(target=ask, args=(path,)) for path in ("api/project", "api/jobs")
        ]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        tabs[k % len(tabs)].evaluate("document.title")
        time.sleep(0.05)
    for job in jobs:
        served.ask("POST", f"api/jobs/{job['id']}/cancel", {})
    for job in jobs:
        while served.ask("GET", f"api/jobs/{job['id']}")["state"] in ("running", "cancelling"):
            time.sleep(0.2)
    running = sum(state == "running" for state in states)
    return f"{median(times)}, {running} jobs running"


def main() -> None:
    """Measure, print, and optionally write the table."""
    with tempfile.TemporaryDirectory(prefix="jounce-bench-", ignore_cleanup_errors=True) as place:
        prepare_project(Path(place))
        served = Served(Path(place))
        try:
            rows = measured(served, Path(place))
        finally:
            served.end()
    lines = [
        "| action | target | measured |",
        "|---|---|---|",
        *(f"| {' | '.join(row)} |" for row in rows),
    ]
    load = os.getloadavg()[0] if hasattr(os, "getloadavg") else 0.0
    day = datetime.now(tz=UTC).date().isoformat()
    where = f"{day}, {os.cpu_count()} processors, {platform.machine()}, Python {platform.python_version()}"
    head = (
        "# Response times of the workbench\n\n`make bench-web` writes this table: headless Chromium at 1280 x 720 with "
        "software rendering, from the input to the frame after the curves are drawn.\n"
    )
    text = f"{head}\n{chr(10).join(lines)}\n\nMeasured on {where}; load of the machine at the end {load:.1f}.\n"
    print(text)
    if "--write" in sys.argv:
        _, mark, others = TABLE.read_text(encoding="utf-8").partition("\n## ")
        TABLE.write_text(f"{text}{mark}{others}", encoding="utf-8")


if __name__ == "__main__":
    main()
