from __future__ import annotations

import os
import tempfile
import webbrowser
from pathlib import Path

import matplotlib as mpl
import pytest

import jounce as jn
from jounce.core import writing
from jounce.core.errors import OutputError
from jounce.plots import add_note, new_figure, render_figure, road_profile, show, write_figure
from jounce.plots.figures import log_axes, style

OBSTACLE = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")
MAGIC = {".svg": b"<?xml", ".png": b"\x89PNG", ".pdf": b"%PDF"}


@pytest.mark.parametrize("suffix", sorted(MAGIC))
def test_same_figure_same_bytes(suffix: str, tmp_path: Path) -> None:
    first = write_figure(road_profile(OBSTACLE), tmp_path / f"a{suffix}").read_bytes()
    second = write_figure(road_profile(OBSTACLE), tmp_path / f"b{suffix}").read_bytes()
    assert first == second
    assert first.startswith(MAGIC[suffix])
    assert len(first) > 3000


def test_one_figure_gives_the_same_bytes_each_time() -> None:
    figure = new_figure(4.0)
    for axes in figure.subplots(1, 2):
        axes.plot([0.0, 1.0], [0.0, 1.0], label="a")
        axes.set_xlabel("x")
        figure.colorbar(axes.imshow([[0.0, 1.0]]), ax=axes)
    first = render_figure(figure, sorted(MAGIC))
    assert render_figure(figure, sorted(MAGIC)) == first
    assert render_figure(figure, [".png"])[".png"] == first[".png"]


@pytest.mark.skipif(
    os.name != "posix", reason="elsewhere what still runs is not known, and left for a day"
)
def test_figures_that_were_shown_go_with_the_next_process(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened: list[str] = []
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setattr(webbrowser, "open", opened.append)
    show(OBSTACLE)
    (shown,) = tmp_path.rglob("*.png")
    assert opened == [shown.as_uri()]
    assert shown.read_bytes().startswith(MAGIC[".png"])
    writing._sweep.cache_clear()
    with monkeypatch.context() as later:  # as another process sees it, when this one has ended
        later.setattr(writing, "_THIS_RUN", "000000")
        with writing.working_folder() as folder:
            assert list(tmp_path.iterdir()) == [folder]
    writing._sweep.cache_clear()


def test_settings_of_the_user_do_not_matter_and_stay() -> None:
    before = render_figure(road_profile(OBSTACLE))
    with mpl.rc_context({"font.size": 30.0, "axes.facecolor": "black", "svg.fonttype": "path"}):
        assert render_figure(road_profile(OBSTACLE)) == before
        assert mpl.rcParams["font.size"] == 30.0
    assert mpl.rcParams["svg.hashsalt"] is None


def test_no_date_no_random_names() -> None:
    svg = render_figure(road_profile(OBSTACLE))[".svg"].decode()
    assert "<dc:date>" not in svg
    assert "height [mm]" in svg  # text stays text


def test_existing_file_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "road.png"
    file.write_text("mine", encoding="utf-8")
    with pytest.raises(OutputError, match="the output already exists"):
        write_figure(road_profile(OBSTACLE), file)
    assert file.read_text(encoding="utf-8") == "mine"
    write_figure(road_profile(OBSTACLE), file, force=True)
    assert file.read_bytes().startswith(MAGIC[".png"])
    assert [entry.name for entry in tmp_path.iterdir()] == ["road.png"]


@pytest.mark.parametrize(
    ("name", "message"), [("a.jpg", "format"), ("a", "format"), ("no/a.svg", "folder")]
)
def test_what_cannot_be_written_is_refused(name: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(OutputError, match=message):
        write_figure(road_profile(OBSTACLE), tmp_path / name)


def test_note_stands_below_everything() -> None:
    figure = road_profile(OBSTACLE)
    add_note(figure, "Synthetic data")
    assert b"Synthetic data" in render_figure(figure)[".svg"]
    note = figure.texts[-1].get_window_extent()
    assert note.y1 <= figure.axes[0].xaxis.label.get_window_extent().y0 + 1.0


def test_empty_note_changes_nothing() -> None:
    figure = new_figure(2.0)
    add_note(figure, "")
    assert figure.texts == []


@pytest.mark.parametrize(
    ("low", "high", "expected"),
    [
        (1e-6, 1e6, ["10⁻⁶", "0.0001", "0.01", "1", "100", "10⁴", "10⁶"]),
        (0.2, 30.0, ["1", "10"]),
        (2e4, 9e4, ["2·10⁴", "3·10⁴", "4·10⁴", "6·10⁴"]),
    ],
)
def test_logarithmic_ticks_are_written_without_markup(
    low: float, high: float, expected: list[str]
) -> None:
    with style():
        figure = new_figure(2.0)
        axes = figure.subplots()
        axes.plot([low, high], [low, high])
        log_axes(axes)
        axes.set_xlim(low, high)
        figure.draw_without_rendering()
        ticks = [*axes.get_xticklabels(), *axes.get_xticklabels(minor=True)]
    shown = [
        tick.get_text()
        for tick in ticks
        if tick.get_text() and low <= tick.get_position()[0] <= high
    ]
    assert shown == expected


def test_letters_without_a_glyph_are_told_once(caplog: pytest.LogCaptureFixture) -> None:
    figure = new_figure(2.0)
    figure.subplots().set(title="漢字 über ω", xlabel="字")
    render_figure(figure, [".png", ".pdf"])
    assert [record.getMessage() for record in caplog.records] == [
        "characters missing from the font of figures are drawn as boxes: 字漢"
    ]
