from __future__ import annotations

from itertools import pairwise
from types import SimpleNamespace

import numpy as np
import pytest

import jounce as jn
from jounce.recordings import recording
from jounce.ride import comfort
from jounce.ride.spectra import (
    Spectrum,
    channel_transfer,
    cross_spectrum,
    model_transfer,
    power_spectrum,
    response_spectrum,
    third_octaves,
    transfer_function,
)
from jounce.ride.weighting import weight

RATE = 500.0
NOISE = np.random.default_rng(7).normal(size=100_000)


def test_white_noise_is_flat() -> None:
    spectrum = power_spectrum(2.0 * NOISE, RATE, segment="2 s")
    assert spectrum.resolution == pytest.approx(0.75)
    inner = spectrum.density[2:-2]
    assert inner.mean() == pytest.approx(4.0 / (0.5 * RATE), rel=0.01)
    assert inner.std() / inner.mean() == pytest.approx(spectrum.averages**-0.5, rel=0.1)
    # Welch 1967: 199 Hann pieces that overlap by half: K / (1 + 2 (K - 1) / K / 36)
    assert spectrum.averages == pytest.approx(188.576, rel=1e-5)
    assert power_spectrum(NOISE, RATE, segment="2 s", window="boxcar").averages == 100.0
    assert spectrum.mean_square() == pytest.approx(4.0, rel=0.01)
    assert spectrum.mean_square(50.0, 100.0) == pytest.approx(4.0 * 50.0 / 250.0, rel=0.03)


@pytest.mark.parametrize("window", ["hann", "boxcar"])
@pytest.mark.parametrize(
    ("size", "count"), [(1000, 256), (1001, 255), (999, 999), (64, 64), (100, 8)]
)
def test_a_cross_spectrum_is_that_of_scipy(window: str, size: int, count: int) -> None:
    from scipy.signal import csd

    x, y = NOISE[:size] + 3.0, np.roll(NOISE, 7)[:size] ** 2
    frequency, density = cross_spectrum(x, y, RATE, count, window)
    overlap = count // 2 if window == "hann" else 0
    expected = csd(x, y, RATE, window, count, overlap, detrend="constant")
    np.testing.assert_allclose(frequency, expected[0], rtol=1e-15)
    scale = np.abs(expected[1]).max()
    np.testing.assert_allclose(density / scale, expected[1] / scale, rtol=0.0, atol=1e-14)


def test_parts_make_up_the_whole() -> None:
    spectrum = power_spectrum(NOISE, RATE)
    edges = [0.0, 3.33, 10.0, 99.9, 1e9]
    parts = [spectrum.mean_square(low, high) for low, high in pairwise(edges)]
    assert sum(parts) == pytest.approx(spectrum.mean_square(), rel=1e-12)


def test_transfer_of_a_known_filter() -> None:
    answer = np.convolve(NOISE, [0.0, 0.5, -0.25])[: NOISE.size]
    found = transfer_function(NOISE, answer, RATE, segment=2.0)
    z = np.exp(-2j * np.pi * found.frequency / RATE)
    np.testing.assert_allclose(found.response[2:-2], (0.5 * z - 0.25 * z * z)[2:-2], atol=0.01)
    assert found.coherence[2:-2].min() > 0.99


def test_noise_at_the_output_lowers_coherence_not_gain() -> None:
    other = np.random.default_rng(8).normal(size=NOISE.size)
    found = transfer_function(NOISE, NOISE + other, RATE, segment=2.0)
    assert found.coherence[2:-2].mean() == pytest.approx(0.5, abs=0.02)
    assert abs(found.response[2:-2]).mean() == pytest.approx(1.0, abs=0.02)
    scatter = np.std(abs(found.response[2:-2]))
    assert scatter == pytest.approx(found.relative_error[2:-2].mean(), rel=0.15)


def test_nothing_in_gives_no_coherence() -> None:
    found = transfer_function(np.zeros(10_000), NOISE[:10_000], RATE)
    assert found.coherence.max() == 0.0
    assert np.all(np.isinf(found.relative_error))


def test_third_octaves_are_those_of_the_standard() -> None:
    bands = third_octaves(power_spectrum(NOISE, RATE, segment="20 s"))
    assert 1.0 in bands.centre.round(12)  # base ten: 10^(n/10) Hz, edges 10^(1/20) away
    np.testing.assert_allclose(bands.high[:-1], bands.low[1:], rtol=1e-12)
    np.testing.assert_allclose(bands.high / bands.low, 10.0**0.1, rtol=1e-12)
    assert bands.high[-1] < 0.5 * RATE < bands.high[-1] * 10**0.1
    assert bands.high[0] - bands.low[0] >= 0.075
    flat = bands.centre > 5.0
    np.testing.assert_allclose(
        bands.rms[flat] ** 2, ((bands.high - bands.low) / 250.0)[flat], rtol=0.15
    )


def test_bands_give_the_weighted_value_of_the_signal() -> None:
    # ISO 2631-1, 6.4.2: both ways are the same apart from the bands' width
    signal = np.convolve(NOISE, np.ones(10) / 10.0, mode="same")
    over_time = comfort.rms(weight(signal, RATE, "Wk"), RATE)
    bands = third_octaves(power_spectrum(signal, RATE, segment="20 s"))
    assert bands.weighted("Wk") == pytest.approx(over_time, rel=0.02)
    assert bands.weighted("Wd") == pytest.approx(
        comfort.rms(weight(signal, RATE, "Wd"), RATE), rel=0.02
    )


def test_a_linear_model_in_the_same_form() -> None:
    model = jn.linearise(jn.load("kart-quarter-car"))
    found = model_transfer(model, [1.0, 5.0], "sprung.az")
    np.testing.assert_allclose(found.response, model.frequency_response([1.0, 5.0], "sprung.az"))
    assert found.coherence.tolist() == [1.0, 1.0]
    assert found.relative_error.tolist() == [0.0, 0.0]


def test_a_delayed_track_is_added_with_its_phase() -> None:
    model = jn.linearise(jn.load("kart-quarter-car"))
    f = np.array([2.0, 4.0, 5.0])
    alone = response_spectrum(model, f, np.full(3, 2.0), "sprung.az")
    np.testing.assert_allclose(alone, 2.0 * abs(model.frequency_response(f, "sprung.az")) ** 2)
    late = response_spectrum(model, f, np.full(3, 2.0), "sprung.az", {"road.z": 0.125})
    np.testing.assert_allclose(late, alone)
    # gains 1 and j, the second one an eighth of a second late: they meet at 2 Hz, and not at 4 Hz
    gains = {"front.road.z": 1.0, "rear.road.z": 1j}
    twin = SimpleNamespace(frequency_response=lambda f, _, track: np.full(f.shape, gains[track]))
    both = response_spectrum(
        twin, f[:2], np.full(2, 2.0), "body.az", {"front.road.z": 0.0, "rear.road.z": 0.125}
    )
    np.testing.assert_allclose(both, [2.0 * 4.0, 2.0 * 2.0])


def test_a_channel_that_is_missing() -> None:
    run = recording(np.arange(100) / 100.0, {"sprung.az": (NOISE[:100], "m/s^2", "")})
    with pytest.raises(jn.RecordingError, match=r"no channel 'road\.z'"):
        channel_transfer(run, "sprung.az")


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: power_spectrum(NOISE[:4], RATE), "insufficient data for a spectrum"),
        (lambda: power_spectrum(NOISE, 0.0), "insufficient data for a spectrum"),
        (
            lambda: power_spectrum(
                recording(np.arange(9.0), {"sprung.az": (NOISE[:9], "m/s^2", "")}), RATE
            ),
            "signal: a whole Dataset; give the values of one channel",
        ),
        (lambda: power_spectrum([*NOISE[:20], np.nan], RATE), "sample 21 is not a finite number"),
        (
            lambda: power_spectrum(NOISE, RATE, segment="300 s"),
            "the segment does not fit the record",
        ),
        (
            lambda: power_spectrum(NOISE, RATE, segment="1 ms"),
            "the segment does not fit the record",
        ),
        (lambda: power_spectrum(NOISE, RATE, window="flat"), "unknown window 'flat'"),
        (lambda: transfer_function(NOISE, NOISE[1:], RATE), "different lengths"),
        (
            lambda: transfer_function(NOISE, NOISE, RATE, segment="200 s"),
            "needs at least two segments",
        ),
        (
            lambda: third_octaves(power_spectrum(NOISE[:16], RATE)),
            "does not resolve any third-octave band",
        ),
    ],
)
def test_bad_input_is_one_message(call, text: str) -> None:
    with pytest.raises(jn.JounceError) as caught:
        call()
    assert text in str(caught.value)


def test_bins_at_both_ends_count_in_full() -> None:
    spectrum = Spectrum(np.array([0.0, 1.0, 2.0]), np.array([1.0, 2.0, 4.0]), 1.0, 1.0)
    assert spectrum.mean_square() == 7.0
    assert spectrum.mean_square(0.5, 1.5) == 2.0
    assert spectrum.mean_square(0.0, 0.25) == 0.5


def test_bands_that_just_fit() -> None:
    """As wide as the resolution at the low end, up to half the sample rate at the high one."""
    edge = 10.0**0.05
    frequency = np.linspace(0.0, 10.0 * edge, 401)
    bands = third_octaves(Spectrum(frequency, np.ones(401), edge - 1.0 / edge, 1.0))
    assert bands.centre[[0, -1]] == pytest.approx([1.0, 10.0])
