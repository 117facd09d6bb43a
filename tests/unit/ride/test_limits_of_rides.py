"""Where findings of a ride begin, and which pieces of a record make up a spectrum."""

from __future__ import annotations

import math

import numpy as np
import pytest

from jounce.core.errors import RecordingError
from jounce.recordings import recording
from jounce.ride import comfort
from jounce.ride.metrics import ride_metrics
from jounce.ride.spectra import (
    Transfer,
    channel_transfer,
    power_spectrum,
    third_octaves,
    transfer_function,
)

TIME = np.arange(0.0, 20.0 + 5e-4, 1e-3)
WAVE = np.sin(2.0 * np.pi * 5.0 * TIME)
NOISE = np.random.default_rng(2).standard_normal(4003)


def run(**signals: np.ndarray):
    units = {"az": "m/s^2", "force": "N"}
    channels = {
        name.replace("__", "."): (values, units[name.rpartition("__")[2]], "")
        for name, values in signals.items()
    }
    return recording(TIME, channels)


@pytest.mark.parametrize(
    ("exposure", "words"),
    [
        (0.499, None),
        (0.501, "action value of 0.5"),
        (1.149, "action"),
        (1.151, "limit value of 1.15"),
    ],
)
def test_daily_exposure_beside_the_directive(exposure: float, words: str | None) -> None:
    once = ride_metrics(run(body__az=WAVE)).value("daily_exposure")
    found = ride_metrics(run(body__az=exposure / once * WAVE))
    told = [one for one in found.findings if "A(8)" in one.message]
    assert len(told) == (words is not None)
    for one in told:
        assert words in one.message
        assert one.message.startswith("for 8 h a day A(8) is ")
        assert one.value == pytest.approx(exposure)


def test_a_wheel_counts_as_lifted_up_to_a_load() -> None:
    load = 4000.0 + 3900.0 * WAVE
    for limit, share in (
        (0.0, 0.0),
        (100.0, 0.0),
        (2050.0, math.acos(0.5) / math.pi),
        ("3 kN", None),
    ):
        found = ride_metrics(run(tyre__force=load), lift_off_load=limit).value("lift_off_time")
        expected = share if share is not None else 0.5 - math.asin(1.0 / 3.9) / math.pi
        assert found == pytest.approx(expected, abs=6e-3)


def test_offsets_that_start_a_weighting_with_a_step() -> None:
    """More than three of the signal's own standard deviations."""
    for share in (-3.05, -2.95, 0.1, 2.95, 3.05):
        found = ride_metrics(run(body__az=WAVE + share * math.sqrt(0.5)))
        told = [one for one in found.findings if "offset" in one.message]
        assert (len(told) == 1) is (abs(share) > 3.0)


def test_values_over_the_whole_record() -> None:
    signal = np.array([1.0, -2.0, 3.0, 0.0, 1.0])
    squares = [0.5, 4.0, 9.0, 0.0, 0.5]  # both ends count half
    assert comfort.rms(signal, 2.0) == pytest.approx(math.sqrt(sum(squares) / 4.0))
    assert comfort.msdv(signal, 2.0) == pytest.approx(math.sqrt(sum(squares) / 2.0))
    fourth = [0.5, 16.0, 81.0, 0.0, 0.5]
    assert comfort.vdv(signal, 2.0) == pytest.approx((sum(fourth) / 2.0) ** 0.25)
    assert comfort.evdv(signal, 2.0) == pytest.approx(1.4 * comfort.rms(signal, 2.0) * 2.0**0.25)
    assert comfort.crest_factor(signal, 2.0) == pytest.approx(3.0 / comfort.rms(signal, 2.0))
    assert comfort.daily_exposure(1.2, 2.0 * 3600.0) == pytest.approx(0.6)
    assert comfort.time_to_reach(0.5, 1.0) == pytest.approx(2.0 * 3600.0)
    assert comfort.time_to_reach(0.5, 0.0) == math.inf
    assert comfort.total_value({"x": 1.0, "z": 2.0}, comfort.HEALTH_FACTORS) == pytest.approx(
        math.hypot(1.4, 2.0)
    )


@pytest.mark.parametrize(
    ("window", "segment", "count", "wide"),
    [
        ("hann", None, 500, 1.5),
        ("boxcar", None, 500, 1.0),
        ("hann", "0.2 s", 200, 1.5),
        ("boxcar", 4.003, 4003, 1.0),
    ],
)
def test_pieces_of_a_spectrum(
    window: str, segment: float | str | None, count: int, wide: float
) -> None:
    found = power_spectrum(NOISE, 1000.0, segment=segment, window=window)
    assert found.frequency[1] == pytest.approx(1000.0 / count)
    assert found.resolution == pytest.approx(wide * 1000.0 / count)
    pieces = 4003 // count if window == "boxcar" else (4003 - count) // (count - count // 2) + 1
    if window == "boxcar":
        assert found.averages == pieces
    else:  # pieces that overlap by half are correlated by a sixth
        assert found.averages == pytest.approx(
            pieces / (1.0 + 2.0 / 36.0 * (pieces - 1) / pieces), rel=1e-9
        )


def test_segments_that_do_not_fit() -> None:
    for samples, fits in ((4003, True), (4004, False), (8, True), (7, False)):
        if fits:
            assert (
                power_spectrum(NOISE, 1000.0, segment=samples / 1000.0).frequency.size
                == samples // 2 + 1
            )
        else:
            with pytest.raises(RecordingError, match="the segment does not fit the record"):
                power_spectrum(NOISE, 1000.0, segment=samples / 1000.0)
    assert power_spectrum(NOISE[:8], 1000.0).frequency.size == 5
    with pytest.raises(
        RecordingError, match=r"insufficient data for a spectrum.*at least 8 samples"
    ):
        power_spectrum(NOISE[:7], 1000.0)
    with pytest.raises(RecordingError, match="sample 8 is not a finite number"):
        power_spectrum(np.where(np.arange(4003) == 7, np.nan, NOISE), 1000.0)


def test_a_transfer_function_needs_two_pieces() -> None:
    found = transfer_function(NOISE, 3.0 * NOISE, 1000.0, segment=2.0, window="boxcar")
    assert found.averages == 2.0
    np.testing.assert_allclose(found.response[1:], 3.0, rtol=1e-9)
    with pytest.raises(
        RecordingError,
        match=r"needs at least two segments; found '2\.002 s'; allowed: at most half",
    ):
        transfer_function(NOISE, NOISE, 1000.0, segment=2.002, window="boxcar")


def test_errors_of_gains() -> None:
    one = Transfer(np.ones(3), np.ones(3, complex), np.array([0.8, 1.0, 0.0]), 10.0)
    assert one.relative_error[:2] == pytest.approx([math.sqrt(0.2 / (2.0 * 0.8 * 10.0)), 0.0])
    assert one.relative_error[2] == math.inf


def test_a_transfer_of_channels_begins_after_settling() -> None:
    time = np.arange(NOISE.size) / 1000.0
    output = np.where(time < 1.0, 0.0, 2.0 * NOISE)
    record = recording(time, {"road.z": (NOISE, "m", ""), "body.z": (output, "m", "")})
    settled = channel_transfer(record, "body.z", segment="0.25 s", settling=1.0)
    np.testing.assert_allclose(settled.response[1:], 2.0, rtol=1e-9)
    early = channel_transfer(record, "body.z", segment="0.25 s", settling=0.99)
    assert abs(early.response[1:] - 2.0).max() > 1e-3


def test_bands_that_are_resolved() -> None:
    """Those as wide as the resolution: 0.2316 of the centre, so from 13 Hz on at 3 Hz."""
    found = third_octaves(power_spectrum(NOISE, 1000.0, segment=0.5))
    assert found.centre[0] == pytest.approx(10.0**1.2)  # 12.6 Hz is 2.9 Hz wide
    assert found.high[-1] <= 500.0 < found.high[-1] * 10.0**0.1
    np.testing.assert_allclose(found.high / found.low, 10.0**0.1)
    with pytest.raises(
        RecordingError,
        match=r"does not resolve any third-octave band; found '93\.75 Hz up to 500 Hz'",
    ):
        third_octaves(power_spectrum(NOISE, 1000.0, segment=0.016, window="hann"))
