from __future__ import annotations

import numpy as np
import pytest
from scipy import signal

import jounce as jn
from jounce.ride.weighting import (
    WEIGHTINGS,
    Start,
    _block_length,
    _continuation,
    weight,
    weighting_response,
)


def test_a_long_record_is_the_same_as_its_parts() -> None:
    noise = np.random.default_rng(3).normal(size=400_000)  # several blocks
    whole = weight(noise, 1000.0, "Wk")
    first = weight(noise[:150_000], 1000.0, "Wk")
    np.testing.assert_allclose(first[:-600], whole[: first.size - 600], atol=1e-5)
    assert (
        abs(first - whole[: first.size]).max() < 2e-3
    )  # the last samples feel what is not there yet


def test_nothing_answers_before_it_happens() -> None:
    pulse = np.zeros(4000)
    pulse[2000:2100] = np.hanning(100)
    answer = weight(pulse, 1000.0, "Wk")
    assert abs(answer[:1990]).max() < 1e-5
    assert abs(answer).max() > 0.1


@pytest.mark.parametrize(("start", "first"), [("rest", 0.8), ("first", 0.0), ("mean", 0.0)])
def test_what_was_before_an_offset(start: Start, first: float) -> None:
    # gravity in the signal: a step of the filter when nothing was before, nothing at all when it was always there
    answer = weight(np.full(20_000, 9.81), 1000.0, "Wk", start=start)
    assert abs(answer).max() / 9.81 == pytest.approx(first, abs=0.35 if first else 1e-12)
    assert abs(answer[10_000:]).max() < 1e-6


def test_a_cosine_needs_its_settling_only_at_the_start() -> None:
    time = np.arange(0.0, 30.0, 0.001)
    answer = weight(np.cos(2.0 * np.pi * 2.0 * time), 1000.0, "Wk")
    gain = weighting_response("Wk", 2.0)
    expected = np.real(gain * np.exp(2j * np.pi * 2.0 * time))
    assert abs(answer - expected)[:500].max() > 0.1
    np.testing.assert_allclose(answer[20_000:-20], expected[20_000:-20], atol=1e-6)


@pytest.mark.parametrize("name", ["Wk", "Wd", "Wf"])
def test_the_start_is_that_of_the_filter(name: str) -> None:
    """From rest, transient included: against the analog filter as a recursion at ten times the rate."""
    rate, fine = 1000.0, 10_000.0
    time = np.arange(0.0, 6.0, 1.0 / fine)
    shaken = np.sin(2.0 * np.pi * 3.0 * time) + 0.3 * np.sin(2.0 * np.pi * 0.4 * time) * np.exp(
        -0.3 * time
    )
    row = WEIGHTINGS[name]
    numerator, denominator = (
        np.array([1.0, 0.0, 0.0]),
        np.array([1.0]),
    )  # high pass, low pass, transition, step
    for corner, quality in (
        (row.f1, 0.5**0.5),
        (row.f2, 0.5**0.5),
        (row.f4, row.q4),
        (row.f6, row.q6),
    ):
        if np.isfinite(corner):
            w = 2.0 * np.pi * corner
            denominator = np.polymul(denominator, [1.0 / w**2, 1.0 / (quality * w), 1.0])
    numerator = numerator / (2.0 * np.pi * row.f1) ** 2
    if np.isfinite(row.f3):
        numerator = np.polymul(numerator, [1.0 / (2.0 * np.pi * row.f3), 1.0])
    if np.isfinite(row.f5):
        w = 2.0 * np.pi * row.f5
        numerator = np.polymul(
            numerator, np.array([1.0 / w**2, 1.0 / (row.q5 * w), 1.0]) * (row.f5 / row.f6) ** 2
        )
    zeros, poles, gain = signal.tf2zpk(numerator, denominator)
    sections = signal.zpk2sos(*signal.bilinear_zpk(zeros, poles, gain, fine))
    expected = signal.sosfilt(sections, shaken)[::10]
    np.testing.assert_allclose(weight(shaken[::10], rate, name)[:-20], expected[:-20], atol=2e-4)
    assert abs(expected).max() > 0.02


@pytest.mark.parametrize("name", WEIGHTINGS)
def test_ends_of_the_response(name: str) -> None:
    gains = abs(weighting_response(name, [0.0, 1e-3, 1e5]))
    assert gains[0] == 0.0
    assert np.all(gains[1:] < 1e-3)


def test_the_largest_gain_of_wk() -> None:
    frequency = np.linspace(5.0, 7.0, 2001)
    gain = abs(weighting_response("Wk", frequency))
    assert frequency[gain.argmax()] == pytest.approx(6.17, abs=0.01)
    assert gain.max() == pytest.approx(1.0545, abs=1e-4)


@pytest.mark.parametrize(
    ("values", "rate", "name", "text"),
    [
        ([0.0, 1.0], 1000.0, "Wq", "unknown weighting 'Wq'; allowed: Wc, Wd, We, Wf, Wk"),
        ([0.0, np.nan], 1000.0, "Wk", "sample 2 is not a finite number"),
        (
            [0.0, 1.0],
            40.0,
            "Wk",
            "the sample rate is too low for the weighting; found '40 Hz'; allowed: 50 Hz or more",
        ),
        ([0.0, 1.0], np.nan, "Wk", "the sample rate is too low"),
        ([0.0], 1000.0, "Wk", "invalid signal"),
        ([[0.0, 1.0]], 1000.0, "Wk", "invalid signal"),
    ],
)
def test_bad_input_is_one_message(values, rate, name, text) -> None:
    with pytest.raises(jn.JounceError) as caught:
        weight(values, rate, name)
    assert text in str(caught.value)


def test_an_unknown_start_is_refused() -> None:
    with pytest.raises(jn.DescriptionError, match="unknown start of the record 'gravity'"):
        weight([0.0, 1.0], 1000.0, "Wk", start="gravity")


@pytest.mark.parametrize(
    ("name", "shortest", "rate", "slowest"),
    [  # the slowest pole: half of the corner over the quality factor, for a step always half of the corner
        ("Wk", 2.5, 50.0, 0.4 * 0.5**0.5),
        ("Wf", 12.5, 0.315, 0.1 * 0.5),
        ("We", 2.5, 50.0, 0.4 * 0.5**0.5),
    ],
)
def test_times_of_a_weighting(name: str, shortest: float, rate: float, slowest: float) -> None:
    row = WEIGHTINGS[name]
    assert (row.shortest, row.slowest_rate) == pytest.approx((shortest, rate))
    assert row.memory == pytest.approx(26.0 / (2.0 * np.pi * slowest))  # exp(-26) is left


def test_behind_its_end_a_record_is_mirrored_and_fades() -> None:
    assert _continuation(np.array([0.0, 1.0, 3.0])) == pytest.approx([0.5 * (6.0 - 1.0), 0.0])
    rising = _continuation(np.arange(2000.0))
    assert rising.size == 512
    assert (rising[0], rising[255]) == pytest.approx((2000.0, 0.5 * (1999.0 + 256.0)), rel=1e-4)
    for samples, needed, block in (
        (1000, 5000, 8192),
        (400_000, 20_000, 131_072),
        (10**6, 5000, 65_536),
    ):
        assert _block_length(samples, needed) == block
