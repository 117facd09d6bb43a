"""What holds for every recording: files, units, sensors, filters and ratings."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from jounce.core.units import conversion_factor
from jounce.identify.comparison import compare, iso18571
from jounce.recordings import (
    Sensor,
    band_limit,
    estimate_lag,
    filter_signals,
    read_recording,
    recording,
    shift_signals,
    write_recording,
)

NUMBERS = st.floats(-1e6, 1e6, allow_nan=False).map(lambda x: 0.0 if abs(x) < 1e-9 else x)
SIGNALS = arrays(float, st.integers(20, 60), elements=NUMBERS)
PAIRS = st.integers(20, 60).flatmap(lambda n: arrays(float, (n, 2), elements=NUMBERS))
SENSORS = st.builds(
    Sensor,
    high_pass=st.none() | st.floats(0.1, 20.0),
    low_pass=st.none() | st.floats(25.0, 400.0),
    gain=st.floats(0.1, 10.0),
    orientation=st.sampled_from([1, -1]),
)


@given(SIGNALS, st.sampled_from([".nc", ".csv"]), st.floats(1e-4, 0.1))
def test_files_give_back_what_was_written(values: np.ndarray, suffix: str, step: float) -> None:
    run = recording(
        np.arange(values.size) * step,
        {"sprung.az": (values, "m/s^2", ""), "tyre.force": (-values, "N", "")},
    )
    with tempfile.TemporaryDirectory() as folder:
        back, _ = read_recording(write_recording(run, Path(folder) / f"run{suffix}"))
    for name in run.data_vars:
        np.testing.assert_array_equal(back[name], run[name])
    np.testing.assert_allclose(back["time"], run["time"], rtol=1e-14, atol=1e-15)


@given(
    SIGNALS,
    st.sampled_from(["m/s^2", "g", "mm/s^2", "ft/s^2"]),
    st.sampled_from(["s", "ms", "min"]),
)
def test_units_of_a_file_do_not_change_the_recording(
    values: np.ndarray, unit: str, clock: str
) -> None:
    time = np.arange(values.size) * 0.001
    rows = zip(
        time / conversion_factor(clock, "s"), values / conversion_factor(unit, "m/s^2"), strict=True
    )
    text = f"time [{clock}], sprung.az [{unit}]\n" + "".join(
        f"{float(t)!r}, {float(v)!r}\n" for t, v in rows
    )
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "a.csv"
        file.write_text(text)
        back, _ = read_recording(file)
    np.testing.assert_allclose(back["sprung.az"], values, rtol=1e-14, atol=0.0)
    np.testing.assert_allclose(back["time"], time, rtol=1e-12, atol=1e-15)


@given(PAIRS, SENSORS, st.floats(-5.0, 5.0), st.sampled_from(["steady", "zero"]))
def test_sensors_are_linear(pair: np.ndarray, sensor: Sensor, factor: float, initial: str) -> None:
    a, b = pair.T
    together = filter_signals(a + factor * b, 1000.0, sensor, initial=initial)  # type: ignore[arg-type]
    parts = filter_signals(pair, 1000.0, sensor, initial=initial) @ [1.0, factor]  # type: ignore[arg-type]
    np.testing.assert_allclose(
        together, parts, rtol=0.0, atol=1e-11 * (1.0 + np.abs(pair).max()) * 60.0
    )


@given(SIGNALS, st.floats(1.0, 400.0))
def test_phase_free_filters_do_not_know_the_direction_of_time(
    values: np.ndarray, corner: float
) -> None:
    size = 1.0 + np.abs(values).max()
    padded = np.concatenate(
        (np.zeros(3000), values, np.zeros(3000))
    )  # so that the ends do not matter
    forwards = band_limit(padded, 1000.0, below=corner)
    np.testing.assert_allclose(
        forwards, band_limit(padded[::-1], 1000.0, below=corner)[::-1], rtol=0.0, atol=1e-6 * size
    )


@given(st.floats(-0.05, 0.05), st.floats(0.5, 3.0))
def test_lag_of_a_shifted_signal_is_the_shift(lag: float, scale: float) -> None:
    time = np.arange(800) / 1000.0
    pulse = np.exp(-(((time - 0.4) / 0.03) ** 2)) * np.cos(40.0 * (time - 0.4))
    assert abs(estimate_lag(pulse, scale * shift_signals(pulse, 1000.0, lag), 1000.0) - lag) < 1e-5


@given(PAIRS, st.floats(0.01, 100.0))
def test_ratings_do_not_depend_on_the_unit(pair: np.ndarray, factor: float) -> None:
    a, b = pair.T
    if np.ptp(a) < 1e-3:
        return
    one, other = (iso18571(f * a, f * b, 10e3) for f in (1.0, factor))
    assert abs(one.corridor - other.corridor) < 1e-9
    for score in (one.corridor, one.phase, one.magnitude, one.slope, one.rating):
        assert 0.0 <= score <= 1.0


@given(PAIRS)
def test_comparison_keeps_its_identities(pair: np.ndarray) -> None:
    a, b = pair.T
    if np.ptp(a) < 1e-3:
        return
    result = compare(a, b, np.arange(a.size) * 0.01)
    assert abs(result.r2 - (1.0 - result.nrmse**2)) <= 1e-12 * (1.0 + result.nrmse**2)
    assert result.rmse >= 0.0
    assert result.magnitude >= -1.0
