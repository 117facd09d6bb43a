from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

import jounce as jn
from jounce.core.recursion import first_order
from jounce.ride import comfort

RATE = 1000.0
TIME = np.arange(0.0, 10.0 + 0.5 / RATE, 1.0 / RATE)
SINE = np.sin(2.0 * np.pi * 5.0 * TIME)


def test_a_sine() -> None:
    # closed forms: r.m.s. 1/sqrt(2), VDV (3/8 T)^(1/4), its ratio 1.10668, crest factor sqrt(2)
    assert comfort.rms(SINE, RATE) == pytest.approx(np.sqrt(0.5), rel=1e-9)
    assert comfort.vdv(SINE, RATE) == pytest.approx(1.39158, abs=6e-6)
    ratio = comfort.vdv(SINE, RATE) / (comfort.rms(SINE, RATE) * 10.0**0.25)
    assert ratio == pytest.approx(1.10668, abs=6e-6)
    assert comfort.evdv(SINE, RATE) == pytest.approx(1.4 * np.sqrt(0.5) * 10.0**0.25, rel=1e-9)
    assert comfort.msdv(SINE, RATE) == pytest.approx(np.sqrt(5.0), rel=1e-9)
    assert comfort.crest_factor(SINE, RATE) == pytest.approx(np.sqrt(2.0), rel=1e-9)


def test_gaussian_noise_has_the_dose_ratio_of_its_kurtosis() -> None:
    noise = np.random.default_rng(5).normal(size=2_000_001)
    ratio = comfort.vdv(noise, RATE) / (comfort.rms(noise, RATE) * 2000.0**0.25)
    assert ratio == pytest.approx(1.31607, rel=2e-3)  # 3^(1/4)


def test_running_rms_of_a_burst() -> None:
    burst = np.where((TIME >= 4.0) & (TIME < 4.5), 2.0, 0.0)
    linear = comfort.running_rms(burst, RATE)
    assert linear[3900] == 0.0
    assert linear[4250] == pytest.approx(2.0 * np.sqrt(0.25), rel=2e-3)
    assert linear[5300] == pytest.approx(2.0 * np.sqrt(0.2), rel=2e-3)
    assert linear[5600] == pytest.approx(0.0, abs=1e-6)
    assert comfort.mtvv(burst, RATE) == pytest.approx(2.0 * np.sqrt(0.5), rel=2e-3)
    slow = comfort.running_rms(burst, RATE, averaging="exponential")
    assert slow[4500] ** 2 == pytest.approx(4.0 * (1.0 - np.exp(-0.5)), rel=3e-3)
    assert slow[6500] ** 2 == pytest.approx(4.0 * (1.0 - np.exp(-0.5)) * np.exp(-2.0), rel=3e-3)


def test_running_rms_of_what_is_constant() -> None:
    for averaging, settled in (("linear", 1000), ("exponential", 9999)):
        found = comfort.running_rms(np.full_like(TIME, 3.0), RATE, averaging=averaging)
        assert found[0] == 0.0
        assert found[settled] == pytest.approx(3.0, rel=1e-4)


@pytest.mark.parametrize("averaging", ["linear", "exponential"])
def test_running_rms_over_other_times(averaging) -> None:
    """A quarter of the time is a quarter of the rate for the same samples."""
    noise = np.random.default_rng(6).normal(size=3000)
    short = comfort.running_rms(noise, RATE, averaging=averaging, time_constant=0.25)
    np.testing.assert_allclose(
        short, comfort.running_rms(noise, 0.25 * RATE, averaging=averaging), rtol=1e-9
    )
    assert abs(short - comfort.running_rms(noise, RATE, averaging=averaging)).max() > 0.1


def test_windows_may_lie_between_samples() -> None:
    found = comfort.running_rms(np.full(100, 2.0), 3.7)  # 3.7 samples a window
    np.testing.assert_allclose(found[4:], 2.0, rtol=1e-12)


def test_recursion_in_blocks() -> None:
    drive = np.random.default_rng(0).normal(size=333)
    state, expected = 0.7, []
    for value in drive:
        state = 0.93 * state + value
        expected.append(state)
    np.testing.assert_allclose(first_order(drive, 0.93, 0.7), expected, rtol=1e-12, atol=1e-13)


@pytest.mark.source(
    kind="published",
    of="ride and roughness",
    key="iso-2631-1",
    where="factors of axes for comfort and health, daily exposure",
    tolerance="exact",
    compares="totals of axes, and times to the action value",
)
def test_totals_and_exposure() -> None:
    # ISO 2631-1: k = 1 for comfort, 1.4 for the horizontal axes for health; directive 2002/44/EC: 0.5 and 1.15 m/s^2
    axes = {"x": 0.3, "y": 0.4, "z": 1.2}
    assert comfort.total_value(axes) == pytest.approx(1.3)
    health = [comfort.total_value({axis: 1.0}, comfort.HEALTH_FACTORS) for axis in "xyz"]
    assert health == pytest.approx([1.4, 1.4, 1.0])
    assert comfort.daily_exposure(1.0) == 1.0
    assert comfort.daily_exposure(1.0, 2.0 * 3600.0) == pytest.approx(0.5)
    assert comfort.time_to_reach(comfort.ACTION_VALUE, 2.0) == pytest.approx(0.5 * 3600.0)
    assert comfort.time_to_reach(comfort.LIMIT_VALUE, 0.0) == np.inf


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (0.0, "not uncomfortable"),
        (0.4, "a little uncomfortable"),
        (0.55, "a little uncomfortable to fairly uncomfortable"),
        (1.1, "uncomfortable"),
        (2.2, "very uncomfortable to extremely uncomfortable"),
        (50.0, "extremely uncomfortable"),
    ],
)
def test_words_of_the_comfort_scale(value: float, words: str) -> None:
    assert comfort.comfort_words(value) == words


def test_edges_of_the_comfort_scale() -> None:
    """ISO 2631-1, C.2.3: from and to, in m/s^2."""
    edges = {
        "not": (0.0, 0.315),
        "a little": (0.315, 0.63),
        "fairly": (0.5, 1.0),
        "very": (1.25, 2.5),
    }
    edges |= {"uncomfortable": (0.8, 1.6), "extremely": (2.0, 1e6)}
    for start, (low, high) in edges.items():
        for value, is_felt in (
            (low, True),
            (high, True),
            (0.99 * low - 1e-9, False),
            (1.01 * high, start == "extremely"),
        ):
            told = [words.startswith(start) for words in comfort.comfort_words(value).split(" to ")]
            assert any(told) is is_felt, (start, value)


def test_short_signals_that_are_enough() -> None:
    assert comfort.rms([2.0, 2.0], 5.0) == pytest.approx(2.0)
    assert comfort.mtvv(SINE[:1001], RATE) == pytest.approx(np.sqrt(0.5), rel=1e-3)
    with pytest.raises(jn.RecordingError, match="invalid signal"):
        comfort.rms(np.ones((2, 2)), RATE)


def test_steady_vibration_needs_no_advice() -> None:
    assert comfort.advice(SINE, RATE, place="seat.az") == ()
    assert comfort.advice(np.zeros(5000), RATE, place="seat.az") == ()


def test_shocks_are_pointed_out() -> None:
    shock = 0.1 * SINE + np.where(abs(TIME - 5.0) < 0.02, 10.0, 0.0)
    found = comfort.advice(shock, RATE, place="seat.az")
    assert [finding.severity for finding in found] == ["warning", "note", "note"]
    assert found[0].value == pytest.approx(comfort.crest_factor(shock, RATE))
    assert found[0].value > 9.0
    assert found[1].value > 1.5
    assert found[2].value > 1.75
    assert all(finding.place == "seat.az" for finding in found)


@pytest.mark.parametrize(
    ("ratio", "limit", "lasting", "words"),
    [  # ISO 2631-1, 6.2.1 and 6.3.3; how long the burst lasts makes the ratio the first that is passed
        (lambda x: comfort.crest_factor(x, RATE), 9.0, 0.05, "crest factor"),
        (lambda x: comfort.mtvv(x, RATE) / comfort.rms(x, RATE), 1.5, 2.0, "MTVV"),
        (lambda x: comfort.vdv(x, RATE) / (comfort.rms(x, RATE) * 10.0**0.25), 1.75, 0.5, "VDV"),
    ],
    ids=["crest", "mtvv", "vdv"],
)
def test_advice_begins_at_the_limits_of_the_standard(
    ratio, limit: float, lasting: float, words: str
) -> None:
    def burst(size: float) -> np.ndarray:
        return np.where(lasting > TIME, size, 1.0) * SINE

    for share, is_told in ((0.99, False), (1.01, True)):
        size = brentq(lambda size, aim=share * limit: ratio(burst(size)) - aim, 1.0, 1e3)
        found = comfort.advice(burst(size), RATE, place="seat.az")
        told = [finding.value for finding in found if finding.message.startswith(words)]
        assert told == ([pytest.approx(share * limit, rel=1e-6)] if is_told else [])


def test_bad_signals() -> None:
    with pytest.raises(
        jn.RecordingError,
        match=r"too short for the running r\.m\.s\.; found '0\.5 s'; allowed: 1 s",
    ):
        comfort.mtvv(SINE[:501], RATE)
    with pytest.raises(jn.DescriptionError, match="unknown averaging 'cubic'"):
        comfort.running_rms(SINE, RATE, averaging="cubic")
    with pytest.raises(jn.RecordingError, match="invalid signal"):
        comfort.rms([1.0], RATE)
    with pytest.raises(jn.RecordingError, match="invalid signal"):
        comfort.rms(SINE, 0.0)
    with pytest.raises(jn.RecordingError, match="the signal is zero"):
        comfort.crest_factor(np.zeros(10), RATE)
