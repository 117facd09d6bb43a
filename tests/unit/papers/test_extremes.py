"""Extremes of sampled signals within windows."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.core.errors import RecordingError
from jounce.papers.audi_a6 import extremes_within

TIME = np.linspace(0.0, 2.0, 41)


def wave(time: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return np.sin(5.0 * time + 0.3), 5.0 * np.cos(5.0 * time + 0.3)


def test_extremes_lie_between_the_samples():
    found = extremes_within(TIME, *wave(TIME), 0.0, 2.0)
    assert found.max == pytest.approx(1.0, abs=1e-5)
    assert found.min == pytest.approx(-1.0, abs=1e-5)
    assert found.t_max == pytest.approx((0.5 * np.pi - 0.3) / 5.0, abs=1e-4)
    assert max(wave(TIME)[0]) < 0.9999  # the samples alone miss it


def test_ends_count_between_samples_too():
    found = extremes_within(TIME, *wave(TIME), 0.313, 0.777)
    assert (found.t_max, found.t_min) == (0.313, 0.777)
    assert found.max == pytest.approx(np.sin(5.0 * 0.313 + 0.3), abs=1.1e-5)  # 5^4 h^4 / 384
    assert found.min == pytest.approx(np.sin(5.0 * 0.777 + 0.3), abs=1.1e-5)


@pytest.mark.parametrize(
    "cubic",
    [(1.0, -2.0, 0.5, 3.0), (0.0, 1.0, 0.0, 0.0), (2.0, 0.0, 0.0, 0.0), (0.0, 1.0, -1.0, 0.0)],
)
def test_cubics_are_exact(cubic):
    law = np.polynomial.Polynomial(cubic)
    found = extremes_within(TIME, law(TIME), law.deriv()(TIME), 0.13, 1.71)
    fine = law(np.linspace(0.13, 1.71, 200001))
    assert found.min == pytest.approx(fine.min(), abs=1e-9)
    assert found.max == pytest.approx(fine.max(), abs=1e-9)
    inside = extremes_within(TIME, law(TIME), law.deriv()(TIME), 0.777, 0.778)
    assert [inside.min, inside.max] == pytest.approx(
        sorted(law(np.array([0.777, 0.778]))), abs=1e-12
    )


def test_error_falls_with_the_fourth_power_of_the_step():
    errors, places = [], np.linspace(0.0, 2.0, 801)[:-1]
    for count in (41, 81):
        time = np.linspace(0.0, 2.0, count)
        found = [
            extremes_within(time, *wave(time), place, place + 1e-9).max for place in places
        ]  # the signal there
        errors.append(np.max(np.abs(found - wave(places)[0])))
    assert errors[0] / errors[1] == pytest.approx(16.0, rel=0.02)


@pytest.mark.parametrize(("start", "end"), [(1.0, 1.0), (1.0, 0.5), (-0.1, 1.0), (1.0, 2.1)])
def test_windows_that_are_none(start, end):
    with pytest.raises(RecordingError, match="unknown time window"):
        extremes_within(TIME, *wave(TIME), start, end)
