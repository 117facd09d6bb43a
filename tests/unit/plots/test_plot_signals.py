from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.core.errors import FitError, RecordingError
from jounce.plots import measured_against_simulated, sweep, time_history
from jounce.plots.campaign import lively_window
from jounce.recordings import recording


@pytest.fixture
def run() -> xr.Dataset:
    time = np.arange(0.0, 1.0, 1e-2)
    force = np.where((time > 0.295) & (time < 0.405), 0.0, 200.0)
    channels = {
        "road.z": (0.01 * np.sin(time), "m", ""),
        "sprung.az": (np.cos(time), "m/s^2", ""),
        "tyre.force": (force, "N", ""),
        "rear.tyre.force": (np.where(time > 0.895, 0.0, 100.0), "N", ""),
        "rear.wheel.az": (time, "m/s^2", ""),
    }
    return recording(time, channels)


def spans(axes) -> list[tuple[float, float]]:
    return [
        (round(patch.get_x(), 3), round(patch.get_x() + patch.get_width(), 3))
        for patch in axes.patches
        if patch.get_width() < 0.5
    ]


def test_channels_in_display_units(run: xr.Dataset) -> None:
    figure = time_history(run, ["road.z", "sprung.az"])
    assert [axes.get_ylabel() for axes in figure.axes] == ["position\n[mm]", "acceleration\n[m/s²]"]
    assert figure.axes[-1].get_xlabel() == "time [s]"
    assert figure.axes[0].lines[0].get_ydata() == pytest.approx(1e3 * run["road.z"].to_numpy())
    assert figure.axes[1].lines[0].get_ydata() == pytest.approx(run["sprung.az"].to_numpy())
    assert figure.axes[0].get_xlim() == pytest.approx((0.0, 0.99))


def test_lost_contact_is_shaded(run: xr.Dataset) -> None:
    figure = time_history(run, ["tyre.force", "rear.wheel.az", "sprung.az"])
    assert spans(figure.axes[0]) == [
        (0.3, 0.4),
        (0.9, 0.99),
    ]  # no corner in the name: any tyre counts
    assert spans(figure.axes[1]) == [(0.9, 0.99)]  # its own tyre
    assert spans(figure.axes[2]) == [(0.3, 0.4), (0.9, 0.99)]


def test_default_channels(run: xr.Dataset) -> None:
    assert [axes.get_title("left") for axes in time_history(run).axes] == [
        "road.z",
        "sprung.az",
        "tyre.force",
        "rear.tyre.force",
    ]
    other = run[["rear.wheel.az"]]
    assert [axes.get_title("left") for axes in time_history(other).axes] == ["rear.wheel.az"]


@pytest.mark.parametrize(
    ("channels", "message"),
    [
        (["sprung.ax"], r"no channel 'sprung.ax'.*Did you mean 'sprung.az'"),
        ([], "no time-dependent channel to draw"),
    ],
)
def test_unknown_channels(run: xr.Dataset, channels: list[str], message: str) -> None:
    with pytest.raises(RecordingError, match=message):
        time_history(run, channels)


def test_trial_shows_signals_and_residuals(trials) -> None:
    figure = measured_against_simulated(trials[0], (0.2, 0.25))
    top, zoom, residual, residual_zoom = figure.axes
    before, after = trials[0].signals_before["sprung.az"], trials[0].signals["sprung.az"]
    lines = {line.get_label(): line.get_ydata() for line in top.lines}
    assert lines["measured"] == pytest.approx(after.measured)
    assert lines["before updating"] == pytest.approx(before.simulated)
    assert lines["after updating"] == pytest.approx(after.simulated)
    assert residual.lines[1].get_ydata() == pytest.approx(after.measured - after.simulated)
    assert top.get_xlim() == pytest.approx((0.0, 0.999))
    assert zoom.get_xlim()[0] < 0.2
    assert 0.55 < zoom.get_xlim()[1] < 0.65  # where it is lively
    assert residual_zoom.get_xlabel() == "time [s]"
    assert "ISO 18571 0.90 (good)" in zoom.get_title("right")


def test_trial_without_signals(trials) -> None:
    with pytest.raises(FitError, match="no signals"):
        measured_against_simulated(trials[3])


def test_trial_that_only_ran_before(trials) -> None:
    from dataclasses import replace

    figure = measured_against_simulated(replace(trials[0], after=None, signals={}))
    assert [line.get_label() for line in figure.axes[0].lines] == ["measured", "before updating"]


def test_window_holds_the_obstacle(trials) -> None:
    assert lively_window(trials[0].signals, (0.05, 0.7)) == pytest.approx(
        (0.05 - 0.039, 0.739), abs=1e-9
    )


def test_sweep_lines_and_errors() -> None:
    speed = ("speed", [1.0, 2.0, 3.0], {"units": "m/s"})
    channel = ("channel", ["sprung.az", "unsprung.az"])
    values = (
        ("speed", "channel"),
        [[1.0, 2.0], [3.0, 4.0], [5.0, np.nan]],
        {"units": "m", "long_name": "peak"},
    )
    results = xr.Dataset(
        {"peak": values, "scalar": 3.0}, coords={"speed": speed, "channel": channel}
    )
    axes = sweep(results).axes[0]
    assert [line.get_label() for line in axes.lines] == ["sprung.az", "unsprung.az"]
    assert axes.lines[0].get_ydata() == pytest.approx([1e3, 3e3, 5e3])
    assert axes.get_xlabel() == "speed [m/s]"
    with pytest.raises(RecordingError, match=r"no variable 'peek'.*Did you mean 'peak'"):
        sweep(results, ["peek"])
    with pytest.raises(RecordingError, match="no coordinate 'pitch'"):
        sweep(results, along="pitch")


def test_sweep_of_the_speed_study() -> None:
    road = jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m")
    results = jn.speed_sweep(jn.load("kart-quarter-car"), road, [1.95, 2.86], duration="0.5 s")
    labels = [axes.get_ylabel() for axes in sweep(results).axes]
    assert any(label.endswith("[mm]") for label in labels)
    assert all(label.endswith("]") for label in labels)


def test_a_vehicle_shows_its_road_body_and_all_axles_first() -> None:
    from jounce.plots.comparison import common_channels

    trial = jn.Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm"), speed="8 m/s", duration="0.1 s"
    )
    run = jn.simulate(jn.load("audi-a6-half-car"), trial)
    first = common_channels({"run": run}, None)
    assert first == ["front.road.z", "body.az", "front.strut.deflection", "rear.strut.deflection"]
