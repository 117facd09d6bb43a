from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.plots import kinematics
from jounce.plots.figures import name_figure
from jounce.plots.kinematics import SHEETS, kinematic_curves, write_kinematics

RIG = jn.load("reference-double-wishbone")


@pytest.fixture(scope="module")
def sweep():
    return jn.sweep_travel(RIG, np.linspace(-0.2, 0.08, 57))


def test_curves_are_in_usual_units(sweep) -> None:
    axes = kinematic_curves(sweep, ["camber", "roll_centre_height"]).axes
    assert [item.get_title("left") for item in axes] == ["camber [°]", "roll centre height [mm]"]
    x, y = axes[0].lines[0].get_data()
    assert x == pytest.approx(1e3 * sweep["wheel_travel"].to_numpy())
    assert y == pytest.approx(np.degrees(sweep["camber"].to_numpy()))
    assert axes[0].get_xlabel() == "wheel travel [mm]"


def test_poles_are_cut_off(sweep) -> None:
    """The front instant centre runs to infinity near -140 mm."""
    lines = kinematic_curves(sweep, ["instant_centre_y"]).axes[0].lines
    values = lines[0].get_data()[1]
    assert np.isnan(values).sum() >= 1
    assert np.nanmax(np.abs(values)) < 0.2 * 1e3 * float(np.abs(sweep["instant_centre_y"]).max())


def test_axles_have_two_lines_and_pairs_at_most_five() -> None:
    rolled = kinematic_curves(
        jn.sweep_roll(RIG, np.radians([-2.0, 0.0, 2.0])), ["camber", "roll_stiffness"]
    )
    assert [line.get_label() for line in rolled.axes[0].lines[:2]] == ["left", "right"]
    pairs = jn.sweep_travel(RIG, [-0.02, 0.0, 0.02], np.linspace(-0.03, 0.03, 13))
    labels = [line.get_label() for line in kinematic_curves(pairs, ["camber"]).axes[0].lines]
    assert [label for label in labels if not label.startswith("_")] == [
        "rack −30 mm",
        "rack −15 mm",
        "rack 0 mm",
        "rack 15 mm",
        "rack 30 mm",
    ]


def test_every_quantity_is_on_one_sheet(sweep, tmp_path: Path, monkeypatch) -> None:
    """Sheets are drawn as pictures where the command writes them: seconds."""
    drawn = []
    monkeypatch.setattr(
        kinematics, "render_figure", lambda figure, _: drawn.append(figure) or {".png": b"\x89PNG"}
    )
    named = [name for names in SHEETS.values() for name in names]
    assert len(set(named)) == len(named)
    files = write_kinematics(sweep, tmp_path / "curves")
    assert {file.name for file in files} == {*(f"{sheet}.png" for sheet in SHEETS), "others.png"}
    assert len(drawn) == len(files)
    shown = {axes.get_title("left").partition(" [")[0] for figure in drawn for axes in figure.axes}
    assert len(shown) > 40
    with pytest.raises(jn.OutputError, match="exists"):
        write_kinematics(sweep, tmp_path / "curves")


def test_unknown_quantities_are_refused(sweep) -> None:
    with pytest.raises(jn.RecordingError, match="camber"):
        kinematic_curves(sweep, ["cambre"])


def test_sweeps_are_shown_like_every_result(sweep) -> None:
    figure = jn.plots.figure_of(sweep, quantities=["toe"])
    assert figure.axes[0].get_title("left") == "toe [°]"
    assert jn.plots.figure_of(jn.sweep_roll(RIG, [0.0, 0.01])).axes[0].get_xlabel() in {
        "",
        "roll angle [°]",
    }


def test_jumps_of_stops_are_drawn_whole() -> None:
    rig = RIG.with_changes({"strut.bump_stop": {"gap": 0.03, "rate": 900e3}})
    found = jn.sweep_travel(rig, np.linspace(-0.08, 0.08, 41))
    drawn = kinematic_curves(found, ["wheel_rate"]).axes[0].lines[0].get_data()[1]
    assert drawn == pytest.approx(1e-3 * found["wheel_rate"].to_numpy())


def test_variants_are_drawn_over_each_other_with_a_legend() -> None:
    other = RIG.with_changes(
        {"hardpoints.tie_rod_inner[2]": RIG.hardpoints.tie_rod_inner[2] + 0.003}
    )
    sweeps = {
        "as it is": jn.sweep_travel(RIG, [-0.02, 0.0, 0.02]),
        "higher": jn.sweep_travel(other, [-0.01, 0.0, 0.01]),
    }
    figure = kinematic_curves(sweeps, ["toe"])
    one, two = figure.axes[0].lines[:2]
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["as it is", "higher"]
    assert list(one.get_xdata()) == [-20.0, 0.0, 20.0]
    assert list(two.get_xdata()) == [-10.0, 0.0, 10.0]
    with pytest.raises(jn.RecordingError, match="different quantities"):
        kinematic_curves({"one": sweeps["higher"], "other": jn.sweep_rack(RIG, [0.0, 0.01])})
    with pytest.raises(jn.RecordingError, match="no sweeps"):
        kinematic_curves({})


def test_a_wide_legend_meets_neither_the_title_nor_the_edge() -> None:
    swept = jn.sweep_travel(jn.load("reference-double-wishbone"), [-0.02, 0.0, 0.02])
    long = [
        "as drawn in the sketch",
        "upper arm 10 mm higher in front",
        "steering rack of another supplier, long",
    ]
    for names, quantities in ((long, ["camber"]), (long, None), (["a", "b"], None)):
        figure = jn.plots.kinematic_curves(dict.fromkeys(names, swept), quantities)
        name_figure(figure, "a rather long title of a suspension and of its travel")
        figure.draw_without_rendering()
        legend, title = figure.legends[0].get_window_extent(), figure.texts[0].get_window_extent()
        assert [text.get_text() for text in figure.legends[0].get_texts()] == names
        assert legend.x0 >= 0.0
        assert legend.x1 <= figure.bbox.x1 + 1.0
        assert not legend.overlaps(title)
        for axes in figure.axes:
            assert not axes.get_visible() or not legend.overlaps(axes.get_window_extent())
