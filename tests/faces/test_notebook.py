"""Notebooks: run in Jupyter where it is installed, their pages and widgets in Chromium where that is."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import jounce as jn
from jounce.core.display import local_units
from jounce.core.optional import MissingPackageError, how_to_install
from jounce.notebook.sliders import _slider, _unit, curves_of

TRIAL = jn.Trial(
    road=jn.HalfSine(height="10 mm", length="60 mm", start="0.1 m"),
    speed="1.95 m/s",
    duration="0.3 s",
)
RATE = "strut.spring.rate"


@pytest.fixture(scope="module")
def kart() -> Any:
    return jn.load("kart-quarter-car")


@pytest.fixture(scope="module")
def run(kart: Any) -> Any:
    return jn.simulate(kart, TRIAL)


@pytest.fixture(scope="module")
def cell() -> Any:
    rig = jn.load("kart-double-wishbone")
    return jn.notebook.viewer(jn.sweep_travel(rig, np.linspace(-0.02, 0.02, 9), points=True), rig)


def test_a_slider_has_the_range_and_the_unit_of_its_number(kart: Any) -> None:
    found = _slider(kart, RATE, None)
    assert (found["low"], found["value"], found["high"]) == (11365.0, 22730.0, 34095.0)
    assert (found["unit"], found["factor"]) == ("N/mm", 1e-3)
    given = _slider(kart, "strut.spring.preload", ("0 N", "0.2 kN"))
    assert (given["low"], given["high"], given["unit"]) == (0.0, 200.0, "N")
    with local_units("imperial"):
        assert _slider(kart, RATE, None)["unit"] == "lbf/in"


@pytest.mark.parametrize(
    ("numbers", "message"),
    [
        (
            ["strut.sprng.rate"],
            r"unknown number 'strut\.sprng\.rate'.*Did you mean 'strut\.spring\.rate'",
        ),
        (["strut.spring.preload"], "the default range around zero is empty"),
        ({RATE: ("20 N/mm", 20000.0)}, "invalid range; found '20000 to 20000'"),
        ({RATE: ("20 N", "30 N")}, "wrong unit"),
        ([], "no parameters for the sliders"),
        (RATE, "no parameters for the sliders"),
    ],
)
def test_numbers_that_cannot_be_moved(numbers: Any, message: str, kart: Any) -> None:
    with pytest.raises(jn.DescriptionError, match=message):
        jn.notebook.live(kart, numbers, lambda rig: jn.simulate(rig, TRIAL))


def test_without_its_package_live_says_what_to_install(
    kart: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(__import__("sys").modules, "anywidget", None)
    with pytest.raises(MissingPackageError, match=re.escape(how_to_install("notebook"))):
        jn.notebook.live(kart, [RATE], lambda rig: jn.simulate(rig, TRIAL))


def test_curves_are_thinned_in_their_units_with_gaps(run: Any) -> None:
    data = run.copy(deep=True)
    data["sprung.z"][5] = np.nan
    names = ("time", "sprung.z", "sprung.az")
    units = {name: _unit(data, name) for name in names}
    height, acceleration = curves_of(data, names, units)
    assert (height["name"], height["unit"], height["across"]) == ("sprung.z", "mm", "time [s]")
    assert None in height["y"]
    assert max(y for y in height["y"] if y is not None) == pytest.approx(
        1e3 * float(data["sprung.z"].max()), rel=1e-4
    )
    assert len(acceleration["x"]) == len(acceleration["y"]) <= 1600
    assert json.loads(json.dumps(height, allow_nan=False)) == height


def test_a_live_rig_follows_its_sliders(kart: Any, run: Any) -> None:
    pytest.importorskip("anywidget")
    told: list[float] = []

    def computed(rig: Any) -> Any:
        told.append(rig.strut.spring.rate)
        if rig.strut.spring.rate > 30000.0:
            raise jn.SimulationError("too stiff by hand")
        return jn.simulate(rig, TRIAL)

    widget = jn.notebook.live(
        kart, {RATE: ("15 N/mm", "40 N/mm")}, computed, channels=["sprung.az"]
    )
    before = widget.curves
    assert widget.before == before
    widget.values = {RATE: 25000.0}
    assert told == [22730.0, 25000.0]
    stiffer = jn.simulate(kart.with_changes({RATE: 25000.0}), TRIAL)["sprung.az"]
    found = max(y for y in widget.curves[0]["y"])
    assert found == pytest.approx(float(stiffer.max()), rel=1e-4)
    assert found != pytest.approx(float(run["sprung.az"].max()), rel=1e-3)
    assert widget.before == before
    assert widget.rig().strut.spring.rate == 25000.0
    kept = widget.curves
    widget.values = {RATE: 35000.0}
    assert widget.problem.startswith("too stiff by hand")
    assert widget.curves == kept
    widget.values = {RATE: 26000.0}
    assert widget.problem == ""
    answers: list[Any] = []
    widget.send = answers.append
    widget._handle_custom_msg({"ask": "alive"}, [])
    widget._handle_custom_msg({"ask": "anything else"}, [])
    assert answers == [{"alive": True}]
    assert kart.strut.spring.rate == 22730.0


def test_the_viewer_is_one_frame_that_needs_nothing_else(cell: Any) -> None:
    text = cell._repr_html_()
    assert re.match(r'<iframe srcdoc="[^"]+" width="100%" height="760"', text)
    assert len(repr(cell)) < 60
    assert not re.search(r"""(src|href)=["']?https?:""", cell.page)


@pytest.fixture
def opened(browser: Any, tmp_path: Path) -> Iterator[Any]:
    """Open a page; in the end nothing was complained about, and nothing asked for but files."""
    context = browser.new_context(viewport={"width": 900, "height": 900})
    page, troubles, asked = context.new_page(), [], []
    page.on(
        "console", lambda message: troubles.append(message.text) if message.type != "log" else None
    )
    page.on("pageerror", lambda error: troubles.append(str(error)))
    page.on("request", lambda request: asked.append(request.url))

    def open_page(text: str) -> Any:
        file = tmp_path / "page.html"
        file.write_text(text, encoding="utf-8")
        page.goto(file.as_uri())
        return page

    yield open_page
    context.close()
    assert [
        one for one in troubles if one != "$ is not defined"
    ] == []  # nbconvert's own script expects jQuery
    assert all(url.startswith(("file:", "about:", "data:", "blob:")) for url in asked)


def test_the_viewer_plays_in_its_cell(cell: Any, opened: Any) -> None:
    page = opened(f"<!doctype html><meta charset='utf-8'><h1>notebook</h1>{cell._repr_html_()}")
    inner = page.frame_locator("iframe")
    inner.locator("html[data-ready]").wait_for(timeout=30_000)
    assert inner.locator(".uplot, canvas").count() >= 2


MODEL = """<!doctype html><meta charset="utf-8"><div id="cell"></div>
<div class="jounce-still" data-live="abc">still</div>
<script type="module">
%(script)s
const state = %(state)s, heard = {};
const model = {
  get: (name) => state[name],
  set: (name, value) => { state[name] = value; (heard[`change:${name}`] ?? []).forEach((hear) => hear()); },
  on: (name, hear) => { (heard[name] ??= []).push(hear); },
  save_changes: () => { window.saved = structuredClone(state.values); },
  send: (question) => { window.asked = question; },
};
window.model = model;
window.answer = () => heard["msg:custom"].forEach((hear) => hear({ alive: true }));
widget.render({ model, el: document.getElementById("cell") });
</script>"""


def test_sliders_and_curves_in_the_browser(kart: Any, run: Any, opened: Any) -> None:
    names = ("time", "sprung.az", "tyre.force")
    units = {name: _unit(run, name) for name in names}
    curves = curves_of(run, names, units)
    curves[0]["name"] = "<img src=x onerror=alert(1)>"  # names of channels come from files
    state = {
        "sliders": [_slider(kart, RATE, None)], "values": {RATE: 22730.0}, "before": curves, "curves": curves,
        "problem": "", "still": "abc",
    }  # fmt: skip
    script = resources.files("jounce.notebook").joinpath("live.js").read_text(encoding="utf-8")
    script = script.replace("export default { render };", "const widget = { render };")
    page = opened(MODEL % {"script": script, "state": json.dumps(state).replace("<", "\\u003c")})
    assert page.locator("svg").count() == 2
    assert page.locator("img").count() == 0
    assert page.locator("output").inner_text() == "22.73 N/mm"
    assert page.evaluate("window.asked") == {"ask": "alive"}
    assert page.locator("input[type=range]").is_disabled()  # no kernel has answered
    assert "move where the notebook runs" in page.locator("small").inner_text()
    assert page.locator(".jounce-still").is_visible()
    page.evaluate("window.answer()")
    assert not page.locator(".jounce-still").is_visible()
    page.locator("input[type=range]").fill("30000")
    assert page.evaluate("window.saved") == {RATE: 30000}
    assert page.locator("output").inner_text() == "30 N/mm"
    first = page.locator("svg .before").first.get_attribute("d")
    page.evaluate(
        "model.set('curves', model.get('curves').map((c) => ({...c, y: c.y.map((y) => 2 * y)})))"
    )
    assert (
        page.locator("svg .before").first.get_attribute("d") != first
    )  # it is smaller beside the new one
    page.evaluate("model.set('problem', '<b>too stiff</b>')")
    assert page.locator(".problem").inner_text() == "<b>too stiff</b>"
    page.get_by_role("button", name="reset").click()
    assert page.evaluate("window.saved") == {RATE: 22730}


CELLS = [
    "import jounce as jn\nkart = jn.load('kart-quarter-car')\nkart",
    "trial = jn.Trial(road=jn.HalfSine(height='10 mm', length='60 mm'), speed='1.95 m/s', duration='0.3 s')\n"
    "run = jn.simulate(kart, trial)\nrun",
    "jn.plots.show(run)",
    "figure = jn.plots.time_history(run)\nfigure",
    "jn.notebook.viewer(run)",
    "widget = jn.notebook.live(kart, ['strut.spring.rate'], lambda rig: jn.simulate(rig, trial))\nwidget",
    "import time\nwidget.values = {'strut.spring.rate': 25000.0}\nbegin = time.perf_counter()\n"
    "widget.values = {'strut.spring.rate': 26000.0}\ntime.perf_counter() - begin",
]


@pytest.mark.slow
def test_a_notebook_in_jupyter_and_its_page(opened: Any, tmp_path: Path) -> None:
    nbclient, nbformat = pytest.importorskip("nbclient"), pytest.importorskip("nbformat")
    nbconvert = pytest.importorskip("nbconvert")
    pytest.importorskip("ipykernel")
    pytest.importorskip("anywidget")
    book = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(text) for text in CELLS])
    nbclient.NotebookClient(book, timeout=300, kernel_name="python3").execute()
    shown = [[one for one in cell.outputs if one.output_type != "stream"] for cell in book.cells]
    counts = [1] * len(CELLS)
    counts[5] = 2  # sliders, and what stands for them in a page
    assert [len(outputs) for outputs in shown] == counts  # pictures once, too
    still = shown[5][1].data["text/html"]
    rig, run, *pictures, viewer, live, took = (outputs[0].data for outputs in shown)
    for table in (rig, run):
        assert len(table["text/html"]) <= 8000
    assert "N/mm" in rig["text/html"]
    assert "m/s²" in run["text/html"]
    assert all("image/svg+xml" in one for one in pictures)
    assert len(pictures) == 2
    assert "<iframe" in viewer["text/html"]
    assert "application/vnd.jupyter.widget-view+json" in live
    assert float(took["text/plain"]) < 5.0  # a tenth of a second where nothing else runs
    exporter = nbconvert.HTMLExporter(template_name="basic")
    page = opened(f"<!doctype html><meta charset='utf-8'>{exporter.from_notebook_node(book)[0]}")
    assert page.locator("svg, img[src^='data:image/svg']").count() == len(pictures) + 1
    assert page.locator(".jounce table").count() == 3
    assert "22.73" in still
    assert page.locator(".jounce-still img").evaluate("image => image.naturalWidth") > 300
    assert "The sliders move where the notebook runs" in page.locator(".jounce-still").inner_text()
    page.frame_locator("iframe").locator("html[data-ready]").wait_for(timeout=30_000)
    page.screenshot(path=str(tmp_path / "notebook.png"), full_page=True)
