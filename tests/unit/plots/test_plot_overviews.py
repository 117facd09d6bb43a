from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import FitError, JounceError, SimulationError
from jounce.plots import (
    figure_of,
    frequency_response,
    modes,
    residual_against_speed_and_pitch,
    road_profile,
    show,
    trial_matrix,
)
from jounce.plots.signals import sample_segments


def test_matrix_says_everything_in_words(trials) -> None:
    axes = trial_matrix(trials).axes[0]
    texts = [text.get_text() for text in axes.texts]
    assert texts.count("holds") == 3
    assert texts.count("not usable") == 1
    assert texts.count("0.90") == 3
    assert texts.count("0.50") == 3
    assert "0.84" in texts  # lowest R2 of trial 2
    labels = [label.get_text() for label in axes.get_yticklabels()]
    assert labels == [
        "trial 1, fitted",
        "trial 2, held out",
        "trial 3, held out",
        "trial 4, held out",
    ]


def test_heads_of_a_matrix_do_not_run_into_each_other(trials) -> None:
    """'strut.deflectionsprung.az' was one word to the eye."""
    one = next(iter(trials[0].after.channels.values()))
    names = ("strut.deflection", "sprung.az", "unsprung.az")
    three = replace(trials[0].after, channels=dict.fromkeys(names, one))
    figure = trial_matrix([replace(trials[0], before=three, after=three)])
    figure.canvas.draw()
    heads = [
        one
        for one in figure.axes[0].texts
        if one.get_text().replace("\n", "") in (*names, "lowest R²")
    ]
    boxes = sorted((text.get_window_extent() for text in heads), key=lambda box: box.x0)
    assert len(boxes) == 7
    assert all(after.x0 > before.x1 + 3.0 for before, after in pairwise(boxes))


def test_residuals_stand_where_they_belong(trials) -> None:
    left, right = residual_against_speed_and_pitch(trials).axes
    points = [(float(line.get_xdata()[0]), float(line.get_ydata()[0])) for line in left.lines]
    assert points == [(1.95, 0.2), (2.86, 0.4)]
    assert [line.get_markerfacecolor() == "white" for line in left.lines] == [
        False,
        True,
    ]  # fitted, held out
    assert [float(line.get_xdata()[0]) for line in right.lines] == pytest.approx([150.0])
    assert [text.get_text() for text in left.texts] == ["1", "2"]


def test_residuals_of_one_kind_have_the_whole_width(trials) -> None:
    both = residual_against_speed_and_pitch(trials)
    for kind, title in ((trials[:2], "single obstacle"), (trials[2:], "trains")):
        figure = residual_against_speed_and_pitch(kind)
        assert [axes.get_title("left") for axes in figure.axes] == [title]
        assert figure.axes[0].get_ylabel() == both.axes[0].get_ylabel()
        assert figure.axes[0].get_ylim()[0] == 0.0
        figure.draw_without_rendering()
        both.draw_without_rendering()
        assert figure.axes[0].get_position().width > 1.5 * both.axes[0].get_position().width
    entry = trials[0].entry
    nowhere = replace(
        trials[0], entry=type(entry).model_construct(**{**dict(entry), "speed": None})
    )
    with pytest.raises(FitError, match="speed or an obstacle pitch"):
        residual_against_speed_and_pitch([nowhere])


def test_residuals_need_a_trial(trials) -> None:
    with pytest.raises(FitError, match="no trial could be compared"):
        residual_against_speed_and_pitch(trials[3:])


def test_jumps_are_upright() -> None:
    x, height = sample_segments(
        jn.Rectangle(height="10 mm", length="60 mm", start="0.2 m").segments(1.0)
    )
    assert np.all(np.diff(x) >= 0.0)
    rise = int(np.argmax(height > 0.005))
    assert x[rise] - x[rise - 1] < 1e-6
    assert height[rise - 1 : rise + 1] == pytest.approx([0.0, 0.01])


def test_roads_share_their_distance() -> None:
    one = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")
    figure = road_profile({"A": one, "B": jn.Train(of=one, count=3, pitch="0.1 m")})
    assert [axes.get_title("left") for axes in figure.axes] == ["A", "B"]
    assert max(figure.axes[0].lines[0].get_ydata()) == pytest.approx(10.0, rel=1e-3)
    assert figure.axes[0].get_xlim() == figure.axes[1].get_xlim()
    assert figure.axes[0].get_xlim()[1] > 0.46


def test_frequency_response_is_that_of_the_model() -> None:
    model = jn.linearise(jn.load("kart-quarter-car"))
    frequency = [1.0, 5.0, 28.0]
    top = frequency_response(model, ["tyre.force"], frequency).axes[0]
    expected = np.abs(model.frequency_response(frequency, "tyre.force")) * 1e-3
    assert top.lines[0].get_ydata() == pytest.approx(expected)
    with pytest.raises(SimulationError, match=r"no output 'tyre.farce'.*Did you mean 'tyre.force'"):
        frequency_response(model, ["tyre.farce"])


def test_modes_need_one() -> None:
    with pytest.raises(SimulationError, match="no oscillating mode"):
        modes(())


def test_every_kind_of_result_has_its_picture(trials, update_result) -> None:
    rig = jn.load("kart-quarter-car")
    road = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")
    run = jn.simulate(rig, jn.Trial(road=road, speed=2.0, duration="0.4 s"))
    things = [
        (run, 5),
        (road, 1),
        ({"A": road, "B": road}, 2),
        (update_result, 2),
        ([update_result, update_result], 1),
        (trials[0], 4),
        (trials, 1),
        (jn.linearise(rig), 4),
        (jn.modes(rig), 2),
    ]
    for thing, axes in things:
        assert len(figure_of(thing).axes) == axes, type(thing)


def test_options_reach_the_drawing() -> None:
    road = jn.HalfSine(height="10 mm", length="60 mm")
    assert figure_of(road, distance=2.0).axes[0].get_xlim()[1] == pytest.approx(2.0)


@pytest.mark.parametrize("thing", [3, "run.nc", [], (), {}, [1, 2]])
def test_what_has_no_picture(thing: object) -> None:
    with pytest.raises(JounceError, match="there is no figure for this type"):
        figure_of(thing)


def test_show_without_a_screen_gives_the_figure(monkeypatch: pytest.MonkeyPatch) -> None:
    import sys

    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.delitem(sys.modules, "ipykernel", raising=False)
    assert show(jn.HalfSine(height="10 mm", length="60 mm")).axes[0].get_ylabel() == "height [mm]"


def test_show_opens_a_picture_where_there_is_a_screen(monkeypatch: pytest.MonkeyPatch) -> None:
    import webbrowser

    opened: list[str] = []
    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setattr(webbrowser, "open", opened.append)
    show(jn.HalfSine(height="10 mm", length="60 mm"))
    assert len(opened) == 1
    assert opened[0].endswith(".png")
