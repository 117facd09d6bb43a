"""Statistics of a window against closed forms, whatever the pieces in which it is read."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.analysis import window
from jounce.core.errors import RecordingError


def test_a_sine_has_its_mean_its_effective_value_and_its_extremes() -> None:
    t = np.arange(0.0, 3.0, 1e-3)
    found = jn.window_statistics(2.0 + 3.0 * np.sin(2.0 * np.pi * 5.0 * t))
    assert found.mean == pytest.approx(2.0, abs=1e-12)
    assert found.standard_deviation == pytest.approx(3.0 / np.sqrt(2.0), rel=1e-12)
    assert found.rms == pytest.approx(np.sqrt(4.0 + 4.5), rel=1e-12)
    assert (found.minimum, found.maximum) == (pytest.approx(-1.0), pytest.approx(5.0))
    assert (found.samples, found.missing) == (3000, 0)


def test_pieces_do_not_matter(monkeypatch: pytest.MonkeyPatch) -> None:
    values = np.random.default_rng(1).normal(1e6, 1e-2, 1001)
    values[[3, 500, 1000]] = np.nan
    whole = jn.window_statistics(values)
    monkeypatch.setattr(window, "_CHUNK", 17)
    pieces = jn.window_statistics(values)
    assert pieces.to_dict() == pytest.approx(whole.to_dict(), rel=1e-12)
    assert whole.missing == 3
    assert whole.standard_deviation == pytest.approx(np.nanstd(values), rel=1e-9)
    assert (
        jn.histogram(values).counts.tolist()
        == np.histogram(values[np.isfinite(values)], 40)[0].tolist()
    )


def test_single_precision_is_summed_in_double() -> None:
    values = np.full(1 << 20, 0.1, np.float32)
    assert jn.window_statistics(values).mean == pytest.approx(float(np.float32(0.1)), rel=1e-14)


def test_nothing_has_no_statistics() -> None:
    with pytest.raises(RecordingError, match="the window contains no sample"):
        jn.window_statistics([np.nan, np.nan])


def test_a_histogram_counts_every_sample_once() -> None:
    values = np.random.default_rng(2).uniform(0.0, 1.0, 10_000)
    found = jn.histogram(values, bins=10)
    assert int(found.counts.sum()) == 10_000
    assert found.shares == pytest.approx(np.full(10, 0.1), abs=0.02)
    constant = jn.histogram(np.full(5, 7.0), bins=3)
    assert constant.counts.tolist() == [0, 5, 0]
    with pytest.raises(RecordingError, match="not a number of bins; found 0; allowed: 1 to 200"):
        jn.histogram(values, bins=0)
