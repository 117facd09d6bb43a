"""Alignment of recordings: known shifts are found, and what is uncertain is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import JounceError


def road(t: np.ndarray) -> np.ndarray:
    """A motion without repetition: many incommensurable waves."""
    rng = np.random.default_rng(3)
    waves = zip(rng.uniform(0.2, 8.0, 60), rng.uniform(0.0, 7.0, 60), strict=True)
    return sum(np.sin(2.0 * np.pi * f * t + phase) / (1.0 + f) for f, phase in waves)


def run(first: float, last: float, rate: float, lag: float = 0.0, noise: float = 0.0) -> Any:
    t = np.arange(first, last, 1.0 / rate)
    values = road(t - lag) + noise * np.random.default_rng(int(rate)).standard_normal(t.size)
    return jn.recording(t, {"sprung.az": (3.0 + 2.0 * values, "m/s^2", "")})


@pytest.mark.parametrize(("lag", "first"), [(1.234, 0.0), (-3.4, 0.0), (0.5, 100.0)])
def test_a_known_shift_is_found_to_a_fraction_of_a_sample(lag: float, first: float) -> None:
    found = jn.align_by_correlation(
        run(0.0, 40.0, 200.0), run(first, first + 25.0, 200.0, lag + first, 0.2), "sprung.az"
    )
    assert found.shift == pytest.approx(-lag - first, abs=1e-3)
    assert 0.9 < found.correlation < 1.0
    assert found.next_best < 0.7
    assert found.rate == pytest.approx(200.0)
    assert found.overlap == pytest.approx(25.0, abs=1.5)


def test_different_rates_are_compared_only_at_a_stated_rate() -> None:
    fast, slow = run(0.0, 30.0, 500.0), run(0.0, 30.0, 100.0, 0.777)
    with pytest.raises(JounceError, match=r"different sample rates.*resample = '100 Hz'"):
        jn.align_by_correlation(fast, slow, "sprung.az")
    found = jn.align_by_correlation(fast, slow, "sprung.az", resample="100 Hz")
    assert found.shift == pytest.approx(-0.777, abs=2e-3)


def test_periodic_motion_is_ambiguous_unless_the_shift_is_limited() -> None:
    t = np.arange(0.0, 20.0, 0.01)
    runs = [
        jn.recording(t, {"sprung.z": (np.sin(2.0 * np.pi * (t - lag)), "m", "")})
        for lag in (0.0, 0.2)
    ]
    with pytest.raises(
        JounceError, match=r"the alignment is ambiguous; found correlations of 1.000 at"
    ):
        jn.align_by_correlation(*runs, "sprung.z")
    found = jn.align_by_correlation(*runs, "sprung.z", maximum_shift="400 ms")
    assert found.shift == pytest.approx(-0.2, abs=1e-3)


def test_what_is_not_alike_is_refused() -> None:
    t = np.arange(0.0, 20.0, 0.01)
    rng = np.random.default_rng(4)
    noise = [
        jn.recording(t, {"sprung.z": (rng.standard_normal(t.size), "m", "")}) for _ in range(2)
    ]
    with pytest.raises(
        JounceError, match="the recordings are not alike; found at best a correlation of 0"
    ):
        jn.align_by_correlation(*noise, "sprung.z")
    still = jn.recording(t, {"sprung.z": (np.ones(t.size), "m", "")})
    with pytest.raises(JounceError, match="the channel is constant"):
        jn.align_by_correlation(noise[0], still, "sprung.z")
    with pytest.raises(JounceError, match="the best shift is at the end of the range"):
        jn.align_by_correlation(
            run(0.0, 20.0, 100.0), run(0.0, 20.0, 100.0, 0.1), "sprung.az", maximum_shift="0.05 s"
        )
    with pytest.raises(JounceError, match=r"no channel 'sprung\.z'"):
        jn.align_by_correlation(run(0.0, 9.0, 100.0), still, "sprung.z")
    with pytest.raises(JounceError, match="the number of samples does not suit a correlation"):
        jn.align_by_correlation(run(0.0, 0.2, 100.0), run(0.0, 20.0, 100.0), "sprung.az")


def test_events_are_found_between_samples() -> None:
    t = np.arange(0.0, 10.0, 0.1)
    first = jn.recording(t, {"speed": (t - 3.05, "m/s", "")})
    second = jn.recording(t + 7.0, {"speed": (t - 4.22, "m/s", "")})
    found = jn.align_by_event(first, second, "speed", "rise", level=0.0)
    assert found.shift == pytest.approx(3.05 - 11.22)
    assert found.correlation is None
    assert jn.align_by_event(first, second, "speed", "start").shift == pytest.approx(-7.0)
    assert jn.align_by_event(first, second, "speed", "maximum").shift == pytest.approx(-7.0)
    with pytest.raises(
        JounceError, match=r"the channel never falls through 0; allowed: between -3.05 and 6.85"
    ):
        jn.align_by_event(first, second, "speed", "fall", level=0.0)
    with pytest.raises(JounceError, match="the level is missing"):
        jn.align_by_event(first, second, "speed", "rise")
    with pytest.raises(JounceError, match="unknown event 'jump'"):
        jn.align_by_event(first, second, "speed", "jump")


def test_recordings_are_aligned_along_a_distance() -> None:
    t = np.arange(0.0, 30.0, 0.01)
    ways = (10.0 * t + 0.05 * t**2, 12.0 * t)
    runs = [
        jn.recording(
            t,
            {
                "sprung.az": (road(0.1 * (way + start)), "m/s^2", ""),
                "distance": (way, "m", ""),
            },
        )
        for way, start in zip(ways, (0.0, 17.0), strict=True)
    ]
    found = jn.align_by_correlation(*runs, "sprung.az", axis="distance")
    assert found.shift == pytest.approx(17.0, abs=0.02)
    assert found.unit == "m"
    assert found.correlation > 0.99
    assert "m" in str(found)
    event = jn.align_by_event(*runs, "sprung.az", "maximum", axis="distance")
    assert event.shift == pytest.approx(17.0, abs=0.5)
    with pytest.raises(JounceError, match="the channel is no axis: it descends or has gaps"):
        jn.align_by_correlation(*runs, "sprung.az", axis="sprung.az")
