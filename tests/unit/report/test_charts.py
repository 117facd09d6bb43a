"""Small figures of pages, and curves packed into them."""

from __future__ import annotations

import base64
import re
import zlib
from hashlib import sha256
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from jounce.plots.thinning import thin
from jounce.report.chart import Chart, Panel, Series, chart_svg, panel_svg, tick_text, ticks
from jounce.report.live import (
    Curve,
    PageArrays,
    Pane,
    Viewer,
    ViewerScene,
    bundle,
    live_data,
    scene_panels,
)
from jounce.report.render import chart_style, png_of

ROOT = Path(__file__).parents[3]


def unpacked(packed: PageArrays, index: int) -> np.ndarray:
    """What the page's script makes of an array, step by step as it does."""
    found = packed.arrays[index]
    if "even" in found:
        return found["even"][0] + np.arange(found["n"]) * found["even"][1]
    data = zlib.decompress(base64.b64decode(packed.text()))
    n, at = found["n"], found["at"]
    value = slope = 0
    values = []
    for low, high in zip(data[at : at + n], data[at + n : at + 2 * n], strict=True):
        folded = low | high << 8
        step = (folded >> 1) ^ -(folded & 1)
        if found["order"] == 0:
            value = folded
        elif found["order"] == 1:
            value = (value + step) & 65535
        else:
            slope = (slope + step) & 65535
            value = (value + slope) & 65535
        values.append(np.nan if value == 65535 else found["low"] + found["step"] * value)
    return np.array(values)


@pytest.mark.parametrize(
    "values",
    [
        np.linspace(0.0, 3.0, 301),
        np.sin(np.linspace(0.0, 20.0, 500)),
        np.random.default_rng(1).standard_normal(400),
        np.where(np.arange(100) % 7 == 0, np.nan, np.arange(100.0) ** 2),
        np.array([1.0, np.inf, -np.inf, 2.0]),
        np.full(5, 3.25),
        np.full(4, np.nan),
        np.array([7.0]),
        np.array([-1e300, 1e300, 0.0]),
        np.where(np.arange(50) % 2 == 0, -1.0, 1.0),
    ],
    ids=[
        "even",
        "smooth",
        "noise",
        "gaps",
        "infinite",
        "constant",
        "unknown",
        "single",
        "huge",
        "jumps",
    ],
)
def test_arrays_come_back_within_half_a_step(values: np.ndarray) -> None:
    packed = PageArrays()
    index = packed.add(values)
    assert packed.add(values.copy()) == index  # once in the page
    back = unpacked(packed, index)
    known = np.isfinite(values)
    assert np.array_equal(np.isfinite(back), known)
    if known.any():
        range_ = np.ptp(values[known] / 2.0) * 2.0
        assert (
            np.abs(back[known] - values[known]).max()
            <= range_ / 131_000 + 1e-12 * np.abs(values[known]).max()
        )


def test_long_records_keep_their_peaks() -> None:
    time = np.arange(1_000_000) / 1000.0
    signal = np.sin(time)
    signal[543_210], signal[654_321] = 9.0, -8.0
    scene = ViewerScene(
        "long", "long", time, (Pane("a", "a", "", (Curve("a", "measured", signal),)),)
    )
    viewer = Viewer("long", (scene,), (("measured", "measured", True),))
    data = live_data([viewer])
    array = data["arrays"][data["viewers"][0]["scenes"][0]["panes"][0]["curves"][0]["y"]]
    assert array["n"] <= 20_000
    assert array["low"] == pytest.approx(-8.0, abs=array["step"])
    assert array["low"] + 65534 * array["step"] == pytest.approx(9.0, abs=array["step"])


def test_zero_is_zero_in_a_page() -> None:
    for values in (
        np.array([-0.3, 0.0, 17.0, 5.0]),
        np.array([0.0, -1e-7, 2e5, 3.0]),
        np.array([0.0, 0.1, np.nan]),
    ):
        packed = PageArrays()
        back = unpacked(packed, packed.add(values))
        assert (back[values == 0.0] == 0.0).all()


def test_thinning_keeps_first_last_lowest_and_highest_of_every_column() -> None:
    x = np.linspace(0.0, 1.0, 5000)
    y = np.random.default_rng(2).standard_normal(5000)
    few, seen = thin(x, y, 0.0, 1.0, 50)
    assert len(few) <= 4 * 51
    for k in range(50):
        inside, kept = (x >= k / 50) & (x < (k + 1) / 50), (few >= k / 50) & (few < (k + 1) / 50)
        assert (seen[kept].min(), seen[kept].max()) == (y[inside].min(), y[inside].max())


def test_ticks_are_round_and_inside() -> None:
    for low, high in ((0.0, 1.0), (-3.2e-7, 8.1e-7), (1234.0, 1239.0), (-5e9, 7e9)):
        found = ticks(low, high)
        assert 3 <= len(found) <= 11
        assert all(
            low - 1e-9 * (high - low) <= tick <= high + 1e-9 * (high - low) for tick in found
        )
        assert len({round((b - a) / (high - low), 6) for a, b in pairwise(found)}) == 1
    assert ticks(2.0, 2.0) == [2.0]
    assert ticks(float("nan"), 1.0) == []
    assert [tick_text(value) for value in (-0.5, 1200.0, 1e-7, 0.30000000000000004)] == [
        "−0.5",
        "1200",
        "1e−7",
        "0.3",
    ]


HOSTILE = '<script>alert("x")</script>&\'"'


def test_text_is_never_markup_and_names_fit() -> None:
    panel = Panel(
        (Series([0.0, 1.0], [0.0, 1.0], label=HOSTILE), Series([0.5], [1.0], "bad", "crosses")),
        HOSTILE,
        HOSTILE,
        HOSTILE,
        ((0.0, 0.5, HOSTILE),),
        ((0.7, "bad", HOSTILE),),
        (HOSTILE, "x" * 300),
        ((0.5, 0.0, HOSTILE),),
    )
    root = ElementTree.fromstring(panel_svg(panel, "p", HOSTILE))
    assert not [element for element in root.iter() if element.tag.endswith("script")]
    texts = [element.text or "" for element in root.iter("text")]
    assert HOSTILE in texts
    assert max(len(text) for text in texts) < 60


def test_nothing_finite_is_an_empty_figure() -> None:
    nothing = np.full(3, np.nan)
    for panel in (
        Panel(()),
        Panel((Series(nothing, nothing), Series(nothing, nothing, style="dots"))),
        Panel((), lanes=()),
    ):
        svg = panel_svg(panel, "p", "nothing")
        ElementTree.fromstring(svg)
        assert "nan" not in svg
        assert "inf" not in svg


def test_gaps_part_a_line() -> None:
    svg = panel_svg(
        Panel((Series([0.0, 1.0, 2.0, 3.0, 4.0], [0.0, 1.0, np.nan, 1.0, 0.0]),)), "p", ""
    )
    line = re.search(r'class="l q after line"[^>]*d="([^"]*)"', svg)
    assert line is not None
    assert line[1].count("M") == 2


def test_figures_beside_a_page_stand_alone_and_are_the_same_each_time() -> None:
    chart = Chart((Panel((Series([0.0, 1.0], [0.0, 1.0]),)),) * 3, "c", "caption", "words")
    svg = chart_svg(chart, chart_style(), "Synthetic data")
    assert svg == chart_svg(chart, chart_style(), "Synthetic data")
    assert "Synthetic data" in svg
    names = set(re.findall(r"var\(--([\w-]+)\)", svg))
    assert names <= set(re.findall(r"--([\w-]+):", svg))
    png = png_of(svg)
    assert png.startswith(b"\x89PNG")
    assert png == png_of(svg)
    assert int.from_bytes(png[16:20], "big") == pytest.approx(2 * 2 * 430, abs=4)


def test_a_still_figure_shows_what_the_viewer_shows_first() -> None:
    x = np.linspace(0.0, 1.0, 11)
    curves = (Curve("measured", "measured", x), Curve("other", "other-1", x))
    scene = ViewerScene(
        "s",
        "s",
        x,
        (Pane("a", "words", "mm", curves), Pane("b", "b", "", curves, False)),
        window=(0.2, 0.4),
    )
    panels = scene_panels(scene, "time", "s", ("measured",))
    assert [(len(panel.series), panel.x_range, panel.y_label) for panel in panels] == [
        (1, (0.2, 0.4), "[mm]")
    ]


def test_the_bundle_is_made_from_the_sources_that_stand_here() -> None:
    folder = ROOT / "viewer"
    if not folder.is_dir():
        pytest.skip("the sources of the viewer are not here")
    sources = ["build.mjs", "package.json", "package-lock.json", "tsconfig.json"]
    styles = ("blocks", "chart", "colours")
    sources += [f"../src/jounce/report/templates/{name}.css" for name in styles]
    sources += sorted(
        file.relative_to(folder).as_posix()
        for file in (folder / "src").rglob("*")
        if file.is_file()
    )
    total = sha256()
    for name in sources:
        total.update(f"{name}\0".encode())
        total.update((folder / name).read_bytes().replace(b"\r\n", b"\n"))
    assert bundle("sources.sha256").strip() == total.hexdigest(), "make viewer"


def test_the_bundle_asks_for_nothing_and_brings_its_licences() -> None:
    for name in ("viewer.js", "page.js", "viewer.css"):
        text = bundle(name)
        assert "</script" not in text.lower()
        assert "</style" not in text.lower()
        assert "@import" not in text
        assert not re.search(r"url\((?!data:|#)", text)
    assert re.findall(r"^(\S+) \d+\.\d+\.\d+ \(MIT\)$", bundle("licences.txt"), re.MULTILINE) == [
        "uplot"
    ]
    lock = ROOT / "viewer" / "package-lock.json"
    if lock.is_file():
        assert '"resolved"' not in lock.read_text(encoding="utf-8")
