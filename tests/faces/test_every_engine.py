"""All pages in Chromium, Firefox and WebKit, without WebGL and with a browser's language that is no language tag.

Every test runs in one session of each browser: a browser that is not installed is skipped, with what Debian calls it.
"""

from __future__ import annotations

import json
import shutil
import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from engines import Chromium, Engine, Firefox, WebKit

import jounce as jn
from jounce.report import REPORTS, recordings_page

pytestmark = pytest.mark.pages
pytest.importorskip("uvicorn")
TOKEN = "a-token-of-the-tour"
RIG = "kart-double-wishbone.toml"
PAGES = {  # and what is drawn on each
    "project": (), f"rig?name={RIG}": (".mechanism",), f"trial?rig={RIG}": (".uplot", ".mechanism", ".phase"),
    f"kinematics?rig={RIG}": (".multiples", ".mechanism"), "record?path=run.nc": (".uplot",), "campaign": (),
    "ride": (), "inspection": (), "studies": (), "jobs": (),
}  # fmt: skip
COLOURED = """[...document.querySelectorAll("%s canvas")].reduce((sum, canvas) => {
  const { width, height } = canvas;
  const pixels = width && height ? canvas.getContext("2d").getImageData(0, 0, width, height).data : [];
  for (let i = 0; i < pixels.length; i += 4) {
    const colours = pixels.slice(i, i + 3);
    if (pixels[i + 3] > 128 && Math.max(...colours) - Math.min(...colours) > 60) sum++;
  }
  return sum;
}, 0)"""
"""How many pixels have the colour of a curve or of a part; those of axes and letters are grey."""


@pytest.fixture(
    scope="module", params=[Chromium, Firefox, WebKit], ids=lambda kind: kind.__name__.lower()
)
def engine(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Engine]:
    kind = request.param
    if not kind.is_installed():
        pytest.skip(f"{kind.__name__} is not installed (Debian: {kind.package})")
    with ExitStack() as stack:
        yield kind(stack, tmp_path_factory.mktemp("browser"))


@pytest.fixture(autouse=True)
def _left(engine: Engine) -> None:
    """Leave the page of the last test, whose requests a browser may report as interrupted."""
    engine.go("about:blank")
    time.sleep(0.2)
    engine.evaluate("0")
    engine.troubles.clear()


@pytest.fixture(scope="module")
def project(workbench: tuple[Path, int]) -> str:
    """Address of a workbench over a rig and a recording."""
    folder, port = workbench
    shutil.copy(Path(jn.__file__).parent / "parts" / "library" / RIG, folder)
    trial = jn.Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm"), speed="2 m/s", duration="0.5 s"
    )
    jn.write_recording(jn.simulate(jn.load("kart-quarter-car"), trial), folder / "run.nc")
    return f"http://127.0.0.1:{port}/"


def visit(engine: Engine, page: str) -> None:
    engine.evaluate(f"(delete document.documentElement.dataset.ready, location.hash = '#/{page}')")
    engine.until("document.documentElement.dataset.ready")


def press(engine: Engine, words: str) -> None:
    button = f"[...document.querySelectorAll('button')].find((button) => button.textContent === {json.dumps(words)})"
    engine.until(f"!!{button}")
    engine.evaluate(f"{button}.click()")


@pytest.mark.parametrize(
    ("language", "width"), [("en", 1280), ("de", 500)]
)  # WebKit's window is never narrower
def test_every_page_shows_what_it_is_about(
    engine: Engine, project: str, language: str, width: int
) -> None:
    engine.resize(width, 900)
    engine.go("about:blank")
    assert engine.evaluate("navigator.language") == "C"
    engine.go(f"{project}?token={TOKEN}")
    engine.until(
        "document.documentElement.dataset.ready"
    )  # to leave earlier breaks off its scripts
    if language == "de":
        engine.evaluate("localStorage.setItem('jounce-language', 'de')")
        engine.go("about:blank")
        engine.go(project)
        press(engine, "Dunkel")
    engine.until("document.documentElement.dataset.ready")
    assert engine.evaluate("document.documentElement.lang") == language
    for page, drawn in PAGES.items():
        visit(engine, page)
        assert engine.evaluate("document.querySelector('h1').innerText.length") > 3, page
        for place in drawn:
            engine.until(f"{COLOURED % place} > 300")
        assert engine.evaluate("document.documentElement.scrollWidth - innerWidth") <= 0, page
        assert (
            engine.evaluate(
                "[...document.querySelectorAll('.problem')].map((one) => one.innerText).join()"
            )
            == ""
        ), page
    engine.evaluate("localStorage.clear()")
    assert engine.troubles == []


@pytest.mark.parametrize(
    ("view", "right", "up"),
    [
        ("front", (0, 1, 0), (0, 0, 1)),
        ("side", (-1, 0, 0), (0, 0, 1)),
        ("top", (0, -1, 0), (1, 0, 0)),
    ],
)
def test_a_hardpoint_is_dragged_in_plain_views(
    engine: Engine, project: str, view: str, right: Any, up: Any
) -> None:
    engine.resize(1280, 900)
    engine.go(f"{project}?token={TOKEN}#/rig?name={RIG}")
    engine.until(f"{COLOURED % '.mechanism'} > 300")
    place = "[...document.querySelectorAll('.points input')].map((one) => Number(one.value))"
    engine.evaluate("document.querySelector('.mechanism').scrollIntoView({ block: 'center' })")
    press(engine, view)
    engine.evaluate(
        "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
    )
    x, y = engine.evaluate("""(() => {
      const name = [...document.querySelectorAll(".names span")].find((one) => one.textContent === "upper ball joint");
      const box = name.getBoundingClientRect(); return [box.left - 7, box.top + 8];
    })()""")
    engine.drag((x, y), (x, y))
    engine.until("document.querySelector('.points select').value === 'upper_ball_joint'")
    before = np.array(engine.evaluate(place))
    engine.drag((x, y), (x + 40, y - 25))
    moved = np.array(engine.evaluate(place)) - before
    across, upward = moved @ np.array(right), moved @ np.array(up)
    assert across > 5  # mm
    assert across / upward == pytest.approx(40 / 25, rel=0.1)  # it snaps to mm
    assert np.linalg.norm(moved) == pytest.approx(np.hypot(across, upward))
    written = ", ".join(f'"{value:.9g} mm"' for value in before + moved)
    engine.until(
        f"document.querySelector('textarea[aria-label^=text]').value.includes({json.dumps(written)})"
    )
    press(engine, "Undo")
    engine.until(
        "document.querySelector('textarea[aria-label^=text]').value.includes('-9.8 mm\", \"303.25 mm\", \"270.83 mm')"
    )
    assert engine.troubles == []


def test_a_report_is_played_and_stands_in_a_notebook(engine: Engine, tmp_path: Path) -> None:
    rig = jn.load("kart-double-wishbone")
    sweep = jn.sweep_travel(rig, np.linspace(-0.02, 0.02, 9), points=True)
    report = REPORTS.write(
        recordings_page({"kart": sweep}, ["camber"], title="Kart", rig=rig), tmp_path / "sweep.html"
    )
    cell = tmp_path / "cell.html"
    cell.write_text(
        f"<!doctype html><meta charset='utf-8'>{jn.notebook.viewer(sweep, rig)._repr_html_()}",
        encoding="utf-8",
    )
    engine.resize(1280, 900)
    engine.go(report.as_uri())
    engine.until(f"{COLOURED % '.mechanism'} > 300 && {COLOURED % '.uplot'} > 100")
    painted = (
        "(document.querySelector('.player').scrollIntoView(), "
        "document.querySelector('.mechanism canvas').toDataURL())"
    )
    engine.evaluate(f"(window.before = {painted}, 0)")
    press(engine, "Play")
    engine.until(f"{painted} !== before")
    engine.go(cell.as_uri())
    inner = "document.querySelector('iframe').contentDocument"
    engine.until(f"{inner}?.documentElement.dataset.ready !== undefined")
    engine.until(COLOURED.replace("document", inner) % ".mechanism" + " > 300")
    assert engine.troubles == []
