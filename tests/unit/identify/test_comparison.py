from __future__ import annotations

import math

import numpy as np
import pytest

from jounce.core.errors import FitError
from jounce.core.serialise import to_json
from jounce.identify.comparison import compare

TIME = np.arange(2001) / 1000.0
WAVE = np.sin(2.0 * np.pi * 3.0 * TIME)  # whole periods: mean 0


def test_perfect_match() -> None:
    result = compare(WAVE, WAVE, TIME)
    assert (result.rmse, result.nrmse, result.r2, result.peak_error, result.peak_time_error) == (
        0.0,
        0.0,
        1.0,
        0.0,
        0.0,
    )
    assert result.magnitude == pytest.approx(0.0, abs=1e-15)
    assert result.phase == pytest.approx(0.0, abs=1e-7)
    assert result.lag == pytest.approx(0.0, abs=1e-12)
    assert result.samples == 2001


def test_scaled_signal() -> None:
    result = compare(WAVE, -1.25 * WAVE, TIME)
    assert result.nrmse == pytest.approx(2.25, rel=1e-9)  # |1 + 1.25| over the standard deviation
    assert result.r2 == pytest.approx(1.0 - 2.25**2, rel=1e-9)
    assert result.rmse == pytest.approx(2.25 * math.sqrt(0.5), rel=1e-3)
    assert result.peak_error == pytest.approx(0.25, rel=1e-12)
    assert result.magnitude == pytest.approx(0.25, rel=1e-12)
    assert result.phase == pytest.approx(1.0, abs=1e-7)
    assert result.combined == pytest.approx(math.hypot(0.25, 1.0), rel=1e-7)


def test_late_signal() -> None:
    reference, compared = (np.exp(-(((TIME - at) / 0.05) ** 2)) for at in (0.7, 0.73))
    result = compare(reference, compared, TIME)
    assert result.lag == pytest.approx(0.03, abs=1e-5)
    assert result.peak_time_error == pytest.approx(0.03, abs=1e-9)
    assert result.peak_error == pytest.approx(0.0, abs=1e-12)
    assert result.magnitude == pytest.approx(0.0, abs=1e-9)
    overlap = math.exp(-(0.03**2) / (2.0 * 0.05**2))  # correlation of two equal bells
    assert result.phase == pytest.approx(math.acos(overlap) / math.pi, abs=1e-9)


def test_offset_counts_against_the_deviation_from_the_mean() -> None:
    result = compare(WAVE + 100.0, WAVE + 100.0 + math.sqrt(0.5), TIME)
    assert result.nrmse == pytest.approx(1.0, rel=1e-3)
    assert result.r2 == pytest.approx(0.0, abs=2e-3)


def test_vanishing_signals_give_null_and_no_warning() -> None:
    silent = compare(WAVE * 0.0, WAVE, TIME)
    assert all(math.isnan(value) for value in (silent.nrmse, silent.peak_error, silent.phase))
    assert '"nrmse": null' in to_json(silent)
    flat = compare(WAVE, WAVE * 0.0, TIME)
    assert (flat.nrmse, flat.r2, flat.peak_error, flat.magnitude) == (
        pytest.approx(1.0),
        pytest.approx(0.0),
        -1.0,
        -1.0,
    )
    assert flat.lag == 0.0


@pytest.mark.parametrize(
    ("reference", "compared", "time", "message"),
    [
        (WAVE, WAVE[1:], TIME, "not be compared|cannot be compared"),
        (WAVE, WAVE, TIME[1:], r"time \(2000,\)"),
        (WAVE[:2], WAVE[:2], TIME[:2], "at least 3"),
        (WAVE, WAVE * np.nan, TIME, "trial 1: .*not finite"),
        (WAVE, WAVE, TIME[::-1], "constant steps"),
        (WAVE, WAVE, TIME**2, "constant steps"),
    ],
)
def test_bad_input(
    reference: np.ndarray, compared: np.ndarray, time: np.ndarray, message: str
) -> None:
    with pytest.raises(FitError, match=message):
        compare(reference, compared, time, place="trial 1")


@pytest.mark.parametrize(("late", "is_refused"), [(0.0045, False), (0.0055, True)])
def test_steps_may_differ_by_one_percent(late: float, is_refused: bool) -> None:
    time = np.arange(40.0)
    time[20] += late  # one step longer and one shorter by this much
    if is_refused:
        with pytest.raises(FitError, match="constant steps"):
            compare(np.sin(time), np.sin(time), time)
    else:
        assert compare(np.sin(time), np.sin(time), time).samples == 40
