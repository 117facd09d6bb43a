"""Faults of a record that a fit makes up for: what is left of it tells them, and tells none where there is none."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.identify.leftovers import LeftOver, beyond_noise, faults

T = np.arange(0.0, 1.0, 1e-3)
NOISE = np.random.default_rng(11).normal(0.0, 0.02, (3, len(T)))


def swing(t: Array) -> Array:
    """A decaying swing of 6 Hz, m/s^2."""
    found: Array = np.exp(-2.0 * np.maximum(t, 0.0)) * np.sin(12.0 * np.pi * np.maximum(t, 0.0))
    return found


def told(
    measured: Callable[[Array], Array], *, is_aligned: bool = False, trials: int = 3
) -> list[Finding]:
    """Findings on records that all have the same fault."""
    parts = [LeftOver(f"t{i}", measured(T) + NOISE[i], swing(T), 1000.0) for i in range(trials)]
    return faults("sprung.az", parts, 0.02, is_aligned=is_aligned)


def test_a_record_that_is_only_noisy_has_no_fault() -> None:
    assert told(swing) == []
    assert beyond_noise([LeftOver("t", swing(T) + NOISE[0], swing(T), 1000.0)]) is None


@pytest.mark.parametrize(
    ("measured", "words", "value"),
    [
        (
            lambda t: 1.2 * swing(t),
            "the record is 1.2 times the response of the updated model in t0, t1, t2",
            1.2,
        ),
        (lambda t: swing(t) / 9.81, "times the response of the updated model", 1.0 / 9.81),
        (lambda t: swing(t) + 0.5 * t, "drifts by 0.5", 0.5),
        (lambda t: swing(t - 0.004), "lags the updated model by 4 ms", 0.004),
        (lambda t: swing(t + 0.004), "leads the updated model by 4 ms", -0.004),
    ],
)
def test_the_fault_is_named_with_its_size(
    measured: Callable[[Array], Array], words: str, value: float
) -> None:
    (finding,) = told(measured)
    assert words in finding.message
    assert finding.severity == "warning"
    assert finding.value == pytest.approx(value, rel=0.05)


def test_a_channel_that_is_late_in_an_aligned_trial_is_held_against_the_others() -> None:
    (finding,) = told(lambda t: swing(t - 0.004), is_aligned=True)
    assert "lags the other channels of its trial" in finding.message
    assert "low_pass" in finding.message


def test_a_sensor_out_of_range_is_not_taken_for_a_wrong_scale() -> None:
    parts = [LeftOver("t", np.clip(swing(T) + NOISE[0], -0.25, 0.25), swing(T), 1000.0)]
    (finding,) = faults("sprung.az", parts, 0.02, is_aligned=False)
    assert "flat at the limits" in finding.message


def test_what_is_left_beyond_the_noise_is_a_multiple_of_it() -> None:
    other = np.exp(-3.0 * T) * np.sin(12.5 * np.pi * T)
    times = beyond_noise([LeftOver("t", other + NOISE[0], swing(T), 1000.0)])
    left = other + NOISE[0] - swing(T)
    assert times == pytest.approx(left.std() / 0.02, rel=0.1)


def test_a_dead_reading_has_no_fault_to_name() -> None:
    assert (
        faults(
            "sprung.az", [LeftOver("t", NOISE[0], np.zeros(len(T)), 1000.0)], 0.02, is_aligned=False
        )
        == []
    )
