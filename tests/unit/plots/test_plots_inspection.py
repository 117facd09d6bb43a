"""Curves of inspections: what is drawn, from which values."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from jounce.inspection.grading import grade
from jounce.inspection.result import Inspection, WheelCurves, WheelResult
from jounce.plots import figure_of, render_figure
from jounce.plots.inspection import envelope, inspection_curves

FREQUENCY = np.linspace(25.0, 4.0, 40)
TIME = np.cumsum(1.0 / FREQUENCY)


def curves(*, sprung: bool = False) -> WheelCurves:
    unknown = np.full(40, np.nan)
    if sprung:
        return WheelCurves(TIME, FREQUENCY, unknown, unknown, unknown, 1e-4 * FREQUENCY)
    least, greatest = 4000.0 - 40.0 * FREQUENCY, 4000.0 + 60.0 * FREQUENCY
    return WheelCurves(TIME, FREQUENCY, least, greatest, 7.0 * FREQUENCY, np.full(40, 3e-3))


def inspection(*, sprung: bool = False) -> Inspection:
    wheels = (
        WheelResult(
            "left",
            static_load=4e3,
            phase_angle_min_deg=30.0,
            phase_frequency_hz=6.0,
            curves=curves(sprung=sprung),
        ),
        WheelResult("right", static_load=3e3, curves=curves(sprung=sprung)),
    )
    return Inspection(wheels)


@pytest.fixture
def record() -> xr.Dataset:
    time = np.arange(5000) / 1000.0
    force = 4000.0 + 1000.0 * np.sin(100.0 * time)
    return xr.Dataset(
        {"left.plate.force": ("time", force), "left.plate.z": ("time", 1e-6 * force)},
        coords={"time": time},
    )


def test_the_limit_that_fails_is_drawn_beside_the_one_that_passes(record: xr.Dataset) -> None:
    phase = inspection_curves(inspection(), record, phase_limit=45.0, phase_failure=30.0).axes[1]
    assert {text.get_text(): text.xy[1] for text in phase.texts} == {
        "passes from here": 45.0,
        "fails below": 30.0,
    }
    same = inspection_curves(inspection(), record, phase_limit=35.0, phase_failure=35.0).axes[1]
    assert [text.get_text() for text in same.texts] == ["limit"]


def test_rigid_plates_show_force_phase_and_force_over_time(record: xr.Dataset) -> None:
    figure = inspection_curves(inspection(), record, phase_limit=35.0)
    assert [axes.get_title(loc="left") for axes in figure.axes] == [
        "Force amplitude [kN]",
        "Phase angle [°]",
        "Plate force [kN]",
    ]
    line = figure.axes[0].lines[0]
    assert np.all(np.diff(line.get_xdata()) > 0.0)
    assert line.get_ydata()[-1] == pytest.approx(1e-3 * 50.0 * 25.0)  # half of greatest less least
    phase = figure.axes[1]
    assert [text.get_text() for text in phase.texts] == ["limit"]
    marks = [
        (line.get_xdata()[0], line.get_ydata()[0])
        for line in phase.lines
        if line.get_marker() == "o"
    ]
    assert marks == [(6.0, 30.0)]
    low, high = figure.axes[2].get_ylim()
    assert low < 3.01
    assert high > 4.99


def test_a_wheel_that_only_its_force_shows_is_named_there(record: xr.Dataset) -> None:
    record["right.plate.force"] = record["left.plate.force"]
    force = inspection_curves(inspection(), record, phase_limit=35.0).axes[-1]
    assert force.get_legend() is None  # both are named above their curves
    still = Inspection((inspection().wheels[0],))
    legend = inspection_curves(still, record, phase_limit=35.0).axes[-1].get_legend()
    assert [text.get_text() for text in legend.get_texts()] == ["left", "right"]


def test_sprung_plates_show_the_plate(record: xr.Dataset) -> None:
    figure = inspection_curves(inspection(sprung=True), record, language="de")
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    assert titles == ["Plattenamplitude [mm]", "Plattenhub [mm]", "Plattenkraft [kN]"]
    assert figure.axes[0].lines[0].get_ydata()[-1] == pytest.approx(2.5)
    assert [text.get_text() for text in figure.axes[0].get_legend().get_texts()] == [
        "links",
        "rechts",
    ]


def test_without_curves_and_record_it_says_so() -> None:
    figure = inspection_curves(Inspection((WheelResult("left"),)))
    assert figure.axes[0].texts[0].get_text() == "no curves available"


def test_a_jolt_at_the_start_does_not_flatten_the_rest(record: xr.Dataset) -> None:
    record["left.plate.force"][100:103] = 40e3
    figure = inspection_curves(inspection(), record)
    assert figure.axes[2].get_ylim()[1] < 8.0


def test_the_picture_is_the_same_every_time(record: xr.Dataset) -> None:
    first, second = (
        render_figure(inspection_curves(inspection(), record), [".svg"])[".svg"] for _ in range(2)
    )
    assert first == second
    assert len(first) < 150_000


def test_the_envelope_keeps_every_peak() -> None:
    rng = np.random.default_rng(1)
    values = rng.normal(size=12345)
    values[7777] = 99.0
    centre, low, high = envelope(np.arange(12345.0), values, 300)
    assert centre.size == 300
    assert (low.min(), high.max()) == (values.min(), 99.0)
    assert np.all(low <= high)
    gone = envelope(np.arange(3.0), np.full(3, np.nan))
    assert [part.size for part in gone] == [0, 0, 0]


def test_results_are_drawn_by_the_one_verb() -> None:
    for result in (inspection(), grade(inspection())):
        titles = [axes.get_title(loc="left") for axes in figure_of(result).axes]
        assert titles == ["Force amplitude [kN]", "Phase angle [°]"]


def test_sprung_plates_are_drawn_over_the_run_down_alone() -> None:
    frequency = np.concatenate([[1.3, 2.2, 1.4, 9.0], np.linspace(16.0, 2.0, 60)])
    time = np.concatenate([[0.0], np.cumsum(1.0 / frequency)[:-1]])
    time[3:] += 0.4  # what swings before the test are no turns of the exciter
    nothing = np.full(frequency.size, np.nan)
    curves = WheelCurves(time, frequency, nothing, nothing, nothing, 1e-3 / frequency)
    figure = inspection_curves(Inspection((WheelResult("left", static_load=4e3, curves=curves),)))
    line = figure.axes[0].lines[0]
    assert np.array_equal(line.get_xdata(), np.sort(frequency[4:]))
    upwards = WheelCurves(time, frequency[::-1], nothing, nothing, nothing, 1e-3 / frequency[::-1])
    assert (
        inspection_curves(Inspection((WheelResult("left", curves=upwards),)))
        .axes[0]
        .lines[0]
        .get_xdata()
        .size
        > 0
    )
