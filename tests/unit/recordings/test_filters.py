from __future__ import annotations

import numpy as np
import pytest

from jounce.core.errors import RecordingError
from jounce.recordings import band_limit, cfc_filter, derivative, resample
from jounce.recordings.signals import cfc_coefficients

RATE = 10_000.0
TIME = np.arange(20_000) / RATE
MIDDLE = slice(5_000, 15_000)


def gain_and_phase(filtered: np.ndarray, frequency: float) -> complex:
    wave = np.exp(-2j * np.pi * frequency * TIME)
    pure = np.sin(2.0 * np.pi * frequency * TIME)
    return complex(np.sum((filtered * wave)[MIDDLE]) / np.sum((pure * wave)[MIDDLE]))


@pytest.mark.parametrize("order", [1, 2, 4])
@pytest.mark.parametrize(
    ("key", "corner"), [("below", 30.0), ("above", 30.0), ("below", 3000.0), ("above", 3000.0)]
)
def test_minus_3_db_at_the_given_frequency_without_phase(
    order: int, key: str, corner: float
) -> None:
    response = gain_and_phase(
        band_limit(np.sin(2.0 * np.pi * corner * TIME), RATE, order=order, **{key: corner}), corner
    )
    assert abs(response) == pytest.approx(np.sqrt(0.5), rel=1e-3)
    assert np.angle(response) == pytest.approx(0.0, abs=1e-3)
    beyond = corner * (1.3 if key == "below" else 0.7)
    steepness = np.tan(np.pi * beyond / RATE) / np.tan(np.pi * corner / RATE)
    squared = (np.sqrt(2.0) - 1.0) * steepness ** (2 * order if key == "below" else -2 * order)
    response = gain_and_phase(
        band_limit(np.sin(2.0 * np.pi * beyond * TIME), RATE, order=order, **{key: corner}), beyond
    )
    assert abs(response) == pytest.approx(1.0 / (1.0 + squared), rel=2e-3)


def test_band_pass_and_no_filter() -> None:
    slow, mid, fast = (np.sin(2.0 * np.pi * f * TIME) for f in (1.0, 50.0, 2000.0))
    kept = band_limit(slow + mid + fast, RATE, above=10.0, below=250.0)
    np.testing.assert_allclose(kept[MIDDLE], mid[MIDDLE], rtol=0.0, atol=0.01)
    copy = band_limit(mid, RATE)
    np.testing.assert_array_equal(copy, mid)
    assert not np.shares_memory(copy, mid)


def test_columns_are_filtered_alike() -> None:
    both = np.stack((np.sin(TIME * 30.0), np.cos(TIME * 30.0)), axis=1)
    np.testing.assert_array_equal(
        band_limit(both, RATE, below=9.0)[:, 1], band_limit(both[:, 1], RATE, below=9.0)
    )


@pytest.mark.parametrize("frequency", [0.0, -1.0, 5000.0, float("nan")])
def test_impossible_corner(frequency: float) -> None:
    with pytest.raises(RecordingError, match=r"low pass: .*cannot be realised.*below 5000 Hz"):
        band_limit(TIME, RATE, below=frequency)


def test_too_short_to_filter() -> None:
    with pytest.raises(RecordingError, match="too short to filter; found '9 samples'; allowed: 10"):
        band_limit(TIME[:9], RATE, below=10.0)


def test_cfc_gains() -> None:
    # SAE J211 / ISO 6487 with the design constant 2.0775: -6 dB at 2.0775 CFC, -3 dB at 1.667 CFC (1.6670 for CFC 60)
    half = gain_and_phase(
        cfc_filter(np.sin(2.0 * np.pi * 2.0775 * 60.0 * TIME), RATE, 60.0), 2.0775 * 60.0
    )
    assert abs(half) == pytest.approx(0.5, rel=2e-3)
    assert np.angle(half) == pytest.approx(0.0, abs=1e-3)
    w = 2.0 * np.pi * 1.6670 * 60.0 / RATE
    a0, a1, a2, b1, b2 = cfc_coefficients(60.0, RATE)
    z = np.exp(-1j * w)
    gain = abs((a0 + a1 * z + a2 * z * z) / (1.0 - b1 * z - b2 * z * z)) ** 2
    assert gain == pytest.approx(np.sqrt(0.5), rel=2e-4)


def test_cfc_needs_ten_samples_per_class() -> None:
    with pytest.raises(RecordingError, match=r"found 'class 180 at 1000 Hz'; allowed: .*up to 100"):
        cfc_filter(TIME, 1000.0, 180.0)
    with pytest.raises(RecordingError):
        cfc_filter(TIME, 1000.0, 100.1)
    assert len(cfc_filter(TIME, 1000.0, 100.0)) == len(TIME)
    with pytest.raises(RecordingError):
        cfc_filter(TIME, 1000.0, -60.0)


def test_resampling_up_is_accurate_and_keeps_both_ends() -> None:
    time = TIME[::20]
    fine, values = resample(time, np.sin(2.0 * np.pi * 5.0 * time), 2000.0)
    assert (fine[0], fine[-1]) == (time[0], time[-1])
    assert fine.size == 4 * (time.size - 1) + 1
    np.testing.assert_allclose(values, np.sin(2.0 * np.pi * 5.0 * fine), rtol=0.0, atol=1e-5)


def test_resampling_down_lets_nothing_fold_back() -> None:
    slow, fast = (
        np.sin(2.0 * np.pi * 5.0 * TIME),
        np.sin(2.0 * np.pi * 995.0 * TIME),
    )  # 995 Hz would appear as 5 Hz
    coarse, values = resample(TIME, slow + fast, 1000.0)
    inner = slice(100, -100)
    np.testing.assert_allclose(
        values[inner], np.sin(2.0 * np.pi * 5.0 * coarse)[inner], rtol=0.0, atol=1e-4
    )
    for share, gain in (
        (0.4, np.sqrt(0.5)),
        (0.44, 0.340),
    ):  # Butterworth of order 8, both ways, at 0.4 of the rate
        wave = resample(TIME, np.sin(2.0 * np.pi * 1000.0 * share * TIME), 1000.0)[1][200:-200]
        assert np.sqrt(2.0 * np.mean(wave**2)) == pytest.approx(gain, rel=1e-2)


def test_a_gap_of_more_than_ten_steps_is_bridged_by_a_line() -> None:
    for gap, bridged in ((9.9, False), (10.1, True)):
        time = np.concatenate((np.arange(40.0), 39.0 + gap + np.arange(40.0)))
        instants, values = resample(time, np.stack((time**2, time), axis=1), 4.0)
        within = (instants > 39.0) & (instants < 39.0 + gap)
        chord = 39.0**2 + (78.0 + gap) * (instants - 39.0)
        np.testing.assert_allclose(
            values[:, 0], np.where(within & bridged, chord, instants**2), rtol=1e-9
        )
        np.testing.assert_allclose(values[:, 1], instants, rtol=1e-12)


def test_same_rate_changes_nothing() -> None:
    time, values = resample(TIME, np.sin(TIME), RATE)
    np.testing.assert_allclose(time, TIME, rtol=0.0, atol=1e-12)
    np.testing.assert_allclose(values, np.sin(TIME), rtol=0.0, atol=1e-12)


@pytest.mark.parametrize("rate", [0.0, -1.0, float("nan"), float("inf")])
def test_impossible_rate(rate: float) -> None:
    with pytest.raises(RecordingError, match="not positive"):
        resample(TIME, TIME, rate)


def test_lengths_must_fit() -> None:
    with pytest.raises(RecordingError, match="do not match"):
        resample(TIME, TIME[1:], 10.0)
    with pytest.raises(RecordingError, match="do not match"):
        resample([0.0], [0.0], 10.0)


def test_derivative_is_exact_for_parabolas_up_to_the_ends() -> None:
    t = np.arange(10) / 100.0
    both = np.stack((t, 3.0 * t**2), axis=1)
    np.testing.assert_allclose(
        derivative(both, 100.0), np.stack((np.ones(10), 6.0 * t), axis=1), rtol=0.0, atol=1e-12
    )
    with pytest.raises(RecordingError, match="too short to differentiate"):
        derivative([0.0, 1.0], 100.0)
