"""Several runs in one picture and on one page."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.core.errors import OutputError, RecordingError
from jounce.plots import compare, time_history
from jounce.recordings import recording
from jounce.report import REPORTS, recordings_page


def run(time: np.ndarray, scale: float) -> xr.Dataset:
    return recording(
        time, {"sprung.az": (scale * time, "m/s^2", ""), "strut.deflection": (1e-3 * time, "m", "")}
    )


def test_differences_are_read_on_the_line_between_samples() -> None:
    coarse, fine = run(np.linspace(0.0, 2.0, 3), 1.0), run(np.linspace(0.5, 3.0, 26), 3.0)
    figure = compare({"coarse": coarse, "fine": fine}, ["sprung.az"])
    over, apart = figure.axes
    assert [line.get_label() for line in over.lines] == ["coarse", "fine"]
    (line,) = apart.lines
    x, y = line.get_xdata(), line.get_ydata()
    inside = x <= 2.0
    assert y[inside] == pytest.approx(2.0 * x[inside])
    assert np.isnan(y[~inside]).all()  # the first one does not reach so far
    assert len(compare([coarse, fine], differences=False).axes) == 2


def test_display_units_and_defaults() -> None:
    figure = compare([run(np.linspace(0.0, 1.0, 5), 1.0)])
    assert [axes.get_ylabel() for axes in figure.axes] == [
        "acceleration\n[m/s²]",
        "deflection\n[mm]",
    ]
    assert figure.axes[1].lines[0].get_ydata()[-1] == pytest.approx(1.0)


def test_sweeps_are_compared_over_travel() -> None:
    rig = jn.load("kart-double-wishbone")
    sweeps = [jn.sweep_travel(rig, np.linspace(-0.01, 0.01, n)) for n in (5, 9)]
    figure = compare(sweeps, ["camber"])
    assert figure.axes[-1].get_xlabel() == "wheel travel [mm]"
    assert figure.axes[0].lines[0].get_xdata()[[0, -1]] == pytest.approx([-10.0, 10.0])


@pytest.mark.parametrize(
    ("runs", "channels", "message"),
    [
        ({}, None, "nothing to compare"),
        (
            {"a": run(np.arange(3.0), 1.0)},
            ["sprung.ax"],
            r"a: no channel 'sprung.ax'.*Did you mean 'sprung.az'",
        ),
        (
            {
                "a": run(np.arange(3.0), 1.0),
                "b": xr.Dataset({"camber": ("travel", [0.0])}, {"travel": [0.0]}),
            },
            None,
            "different axes.*a: time, b: travel",
        ),
        ({"a": xr.Dataset({"x": (("p", "q"), [[1.0]])})}, None, "a curve over one axis.*p x q"),
    ],
)
def test_what_cannot_be_compared_is_said(runs, channels, message: str) -> None:
    with pytest.raises(RecordingError, match=message):
        compare(runs, channels)
    with pytest.raises(RecordingError, match=message):
        recordings_page(runs, channels)


def test_long_recordings_keep_their_peaks() -> None:
    time = np.arange(2_000_000) / 1000.0
    signal = np.sin(time)
    signal[1_234_567] = 9.0
    data = recording(time, {"sprung.az": (signal, "m/s^2", "")})
    for figure in (time_history(data), compare([data])):
        x, y = figure.axes[0].lines[0].get_data()
        assert len(x) < 20_000
        assert (y.max(), x[y.argmax()]) == (9.0, time[1_234_567])
        assert (x[0], x[-1]) == (time[0], time[-1])


def test_a_page_of_runs_says_extremes_and_largest_difference(tmp_path: Path) -> None:
    page = recordings_page(
        {"a": run(np.linspace(0.0, 1.0, 5), 1.0), "b": run(np.linspace(0.0, 2.0, 5), -3.0)},
        title="Two",
    )
    table = page.sections[0].blocks[0]
    assert table.rows[0][:7] == ("sprung.az", "a", "m/s²", "0", "0", "1.000", "1.000")
    assert table.rows[1][:7] == ("", "b", "m/s²", "−6.000", "2.000", "0", "0")
    assert table.rows[1][7:] == ("−4.000", "1.000")
    for suffix in (".html", ".pdf"):
        file = REPORTS.write(page, tmp_path / f"two{suffix}")
        first = file.read_bytes()
        assert REPORTS.write(page, file, force=True).read_bytes() == first
        with pytest.raises(OutputError, match="exists"):
            REPORTS.write(page, file)


def test_a_channel_without_values_has_no_extremes() -> None:
    time = np.arange(4.0)
    data = run(time, 1.0).assign({"sprung.az": ("time", np.full(4, np.nan), {"units": "m/s^2"})})
    for runs in ({"a": data}, {"a": data, "b": run(time, 1.0)}):
        row = recordings_page(runs).sections[0].blocks[0].rows[0]
        assert set(row[-4:]) == {"–"}
    assert len(recordings_page({"a": data}).sections[0].blocks[0].header) == len(row) - 3


def test_runs_without_a_common_channel_are_named_with_a_few_of_theirs() -> None:
    from jounce.plots.comparison import common_channels

    t = np.arange(0.0, 1.0, 0.1)
    runs = {
        name: jn.recording(t, {f"{place}.az": (t, "m/s^2", "") for place in places})
        for name, places in (
            ("quarter.toml", ("sprung", "unsprung")),
            ("half.toml", ("front", "rear", "body", "seat")),
        )
    }
    with pytest.raises(RecordingError) as refused:
        common_channels(runs, None)
    text = str(refused.value)
    assert text.startswith("quarter.toml, half.toml: no channel is common to all runs")
    assert "half.toml: front.az, rear.az, body.az …" in text
    assert "seat" not in text
