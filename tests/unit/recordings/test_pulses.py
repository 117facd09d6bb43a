"""Speed from pulses: counted over turns, with missing and double pulses found."""

from __future__ import annotations

import math

import numpy as np
import pytest

from jounce.core.errors import RecordingError
from jounce.recordings.pulses import edges, pulse_speed

RATE, RADIUS = 2000.0, 0.05
TIME = np.arange(0.0, 10.0, 1.0 / RATE)
TURN = 2.0 * math.pi * RADIUS


def seen(at: np.ndarray, *, width: float = 1e-3, noise: float = 0.03, seed: int = 1) -> np.ndarray:
    """Voltage of a sensor that sees marks at some instants."""
    since = TIME - at[np.clip(np.searchsorted(at, TIME, side="right") - 1, 0, None)]
    level = np.where((since >= 0.0) & (since < width), 4.8, 0.2)
    return level + noise * np.random.default_rng(seed).standard_normal(TIME.size)


def marks(speed: float, per_turn: int) -> np.ndarray:
    return np.arange(0.003, 9.99, TURN / per_turn / speed)


@pytest.mark.parametrize("per_turn", [1, 6, 12, 24])
@pytest.mark.parametrize("speed", [0.4, 1.95, 3.87])
def test_the_mean_speed_is_that_of_the_marks(speed: float, per_turn: int) -> None:
    found = pulse_speed(TIME, seen(marks(speed, per_turn)), per_turn=per_turn, radius=RADIUS)
    assert found.mean == pytest.approx(speed, rel=3e-4)
    assert (found.missing, found.doubled) == (0, 0)
    assert found.variation < 3.0 * found.resolution + 1e-9


def test_missing_and_double_pulses_are_found() -> None:
    at = marks(1.95, 12)
    gone, twice = [40, 41, 200], [100, 300]
    kept = np.delete(at, gone)
    again = at[twice] + 2.5e-3
    found = pulse_speed(
        TIME, seen(np.sort(np.concatenate([kept, again]))), per_turn=12, radius="50 mm"
    )
    assert (found.missing, found.doubled) == (len(gone), len(twice))
    assert found.mean == pytest.approx(1.95, rel=2e-4)
    assert [item.code for item in found.findings] == ["recordings.pulses_corrected"]


def test_a_speed_that_changes_is_followed() -> None:
    x = np.arange(0.0, 30.0, TURN / 12)
    speed = lambda t: 2.0 + 0.3 * np.sin(2.0 * math.pi * t / 5.0)  # noqa: E731
    fine = np.arange(0.0, 10.0, 1e-4)
    way = np.concatenate([[0.0], np.cumsum(0.5 * (speed(fine[1:]) + speed(fine[:-1])) * 1e-4)])
    at = np.interp(x[x < way[-1]], way, fine)
    found = pulse_speed(TIME, seen(at + 1e-3), per_turn=12, radius=RADIUS)
    inside = (found.time > 0.3) & (found.time < 9.7)
    assert np.max(np.abs(found.speed - speed(found.time))[inside]) < 0.03
    assert [item.code for item in found.findings] == ["recordings.speed_varies"]


def test_uneven_marks_cancel_over_a_turn() -> None:
    places = np.sort(np.random.default_rng(2).uniform(0.0, 1.0, 12))
    turns = np.concatenate([k + places for k in range(60)])
    at = turns * TURN / 1.95
    found = pulse_speed(TIME, seen(at[at < 9.99] + 1e-3), per_turn=12, radius=RADIUS)
    inside = slice(12, -12)
    assert np.std(found.speed[inside]) < 0.01 * 1.95 or found.missing > 0


@pytest.mark.parametrize(
    ("signal", "what"),
    [
        (np.full(TIME.size, 0.2), "alternate between two levels"),
        (np.random.default_rng(3).standard_normal(TIME.size), "alternate between two levels"),
        (seen(np.array([1.0, 2.0])), "too few pulses"),
    ],
)
def test_what_has_no_pulses_is_refused(signal: np.ndarray, what: str) -> None:
    with pytest.raises(RecordingError, match=what):
        pulse_speed(TIME, signal, per_turn=1, radius=RADIUS)


def test_an_implausible_speed_is_refused() -> None:
    with pytest.raises(RecordingError, match="an implausible speed for a bench"):
        pulse_speed(TIME, seen(marks(1.95, 12)), per_turn=1, radius="5 m")
    with pytest.raises(RecordingError, match="invalid number of pulses per revolution"):
        pulse_speed(TIME, seen(marks(1.95, 12)), per_turn=0, radius=RADIUS)


def test_edges_lie_between_samples() -> None:
    time = np.arange(8.0)
    signal = np.array([0.0, 0.0, 1.0, 1.0, 0.0, 0.25, 1.0, 0.0])
    with pytest.raises(RecordingError, match="too few"):
        edges(time, signal)
    found = edges(np.arange(32.0), np.tile(signal, 4))
    np.testing.assert_allclose(found[:2], [1.5, 5.0 + 1.0 / 3.0])
