"""Turns and sweeps of plates whose motion is known: what is found, and where it becomes a finding."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from jounce.inspection.evaluation import _swings_upside_down
from jounce.inspection.signals import WheelSignals, find_turns, limits_of, middle_crossings
from jounce.inspection.sweep import (
    Sweep,
    _falls,
    _lasting,
    _rate,
    _slow_part,
    _sprung_findings,
    exciter_height,
    find_sweep,
    spring_against_height,
    turns_of,
    turns_of_sweep,
)
from jounce.parts.testers import load_tester

EGEA, THETA = load_tester("egea-specsus2018"), load_tester("theta-msd3000")
RATE = 1000.0


def plate(frequency: np.ndarray, *, tacho: bool = False) -> WheelSignals:
    """A rigid plate of 3 mm amplitude that turns at given frequencies, one a sample; its angle integrated."""
    time = np.arange(frequency.size) / RATE
    angle = (
        2.0
        * np.pi
        * np.concatenate([[0.0], np.cumsum(0.5 * (frequency[1:] + frequency[:-1]) / RATE)])
    )
    height = None if tacho else 3e-3 * np.sin(angle)
    return WheelSignals(
        "left", time, np.full(time.size, 4e3), height, frequency if tacho else None, 4e3, 20.0
    )


def course(*points: tuple[float, float]) -> np.ndarray:
    """Frequency (Hz) over time along lines through points (s, Hz), one a sample."""
    times, values = zip(*points, strict=True)
    return np.interp(np.arange(0.0, times[-1], 1.0 / RATE), times, values)


def down(rate: float, top: float = 25.0, low: float = 1.5) -> np.ndarray:
    return course((0.0, top), (2.0, top), (2.0 + (top - low) / rate, low))


@pytest.mark.parametrize("tacho", [False, True])
def test_a_sweep_is_found_as_it_was_made(tacho: bool) -> None:
    sweep, findings = find_sweep(plate(down(2.5), tacho=tacho), EGEA, rigid=True)
    assert findings == []
    assert sweep.highest == pytest.approx(25.0, rel=1e-3)
    assert sweep.sweep_rate == pytest.approx(2.5, rel=0.02)
    frequency, top = sweep.turns.frequency, sweep.turns.top
    held = top[sweep.hold]
    assert held[0] < 0.1
    falls = 2.0 + (1.0 - 0.985) * 25.0 / 2.5  # when 98.5 % of the highest are passed
    assert held[-1] == pytest.approx(falls, abs=0.05)
    assert sweep.begin == pytest.approx(falls - 1.0, abs=0.05)
    assert frequency[sweep.last] == pytest.approx(frequency.min())
    inner = slice(5, -5)
    np.testing.assert_allclose(
        frequency[inner], np.interp(top[inner], [2.0, 11.4], [25.0, 1.5]), rtol=0.01
    )


def test_a_plate_that_speeds_up_again_has_swept_all_the_same() -> None:
    frequency = np.concatenate([down(2.5), course((0.0, 1.5), (2.0, 5.0), (3.0, 5.0))])
    sweep, _ = find_sweep(plate(frequency), EGEA, rigid=True)
    assert sweep.last < sweep.turns.frequency.size - 3
    assert sweep.sweep_rate == pytest.approx(2.5, rel=0.02)


def test_begin_is_not_before_the_hold() -> None:
    sweep, _ = find_sweep(plate(course((0.0, 25.0), (0.5, 25.0), (9.9, 1.5))), EGEA, rigid=True)
    assert sweep.begin == sweep.turns.top[sweep.hold][0] < 0.1


@pytest.mark.parametrize(
    ("frequency", "code", "words"),
    [
        (course((0.0, 25.0), (0.3, 25.0)), "few_turns", {"fewest": 8}),
        (down(2.5, top=17.5), "never_high", {"top": 17.5, "high": 18.0}),
        (
            course((0.0, 25.0), (2.0, 25.0), (3.0, 20.0), (6.0, 20.0)),
            "no_sweep",
            {"low": 20.0, "top": 25.0},
        ),
        (course((0.0, 25.0), (2.0, 25.0), (5.0, 10.0)), "sweep_cut_off", {"low": 10.0}),
        (down(2.5)[::-1], "sweep_up", {}),
        (np.tile(down(2.5), 2), "several_sweeps", {"count": 2}),
    ],
)
def test_what_is_no_sweep(frequency, code, words) -> None:
    sweep, (finding,) = find_sweep(plate(frequency), EGEA, rigid=True)
    assert sweep is None
    assert (finding.severity, finding.code, finding.place) == ("problem", code, "left.plate.z")
    for name, value in words.items():
        assert finding.words[name] == pytest.approx(value, rel=0.07)


@pytest.mark.parametrize(("share", "told"), [(1.0, []), (1.012, []), (1.035, ["sweep_fast"])])
def test_sweeps_that_are_too_fast(share: float, told: list[str]) -> None:
    most = limits_of(EGEA).sweep_rate_max
    _, findings = find_sweep(plate(down(share * most)), EGEA, rigid=True)
    assert [one.code for one in findings] == told
    for one in findings:
        assert one.words == pytest.approx({"rate": share * most, "most": most}, rel=0.01)


@pytest.mark.parametrize(
    ("share", "low", "told"), [(1.1, 1.5, []), (0.92, 1.5, ["sweep_short"]), (0.85, 2.5, [])]
)
def test_sweeps_that_are_too_short(share: float, low: float, told: list[str]) -> None:
    """Below 98 % of what is asked for; one that ends above 2 Hz ends early, and is no shorter."""
    least = limits_of(EGEA).sweep_time_min
    lasting = share * least
    frequency = course((0.0, 23.0), (2.0, 23.0), (2.0 + lasting, low), (2.8 + lasting, low))
    sweep, findings = find_sweep(plate(frequency), EGEA, rigid=True)
    found = [one for one in findings if one.code == "sweep_short"]
    assert [one.code for one in found] == told
    length = float(sweep.turns.top[sweep.last] - sweep.turns.top[sweep.first])
    assert length == pytest.approx(lasting, abs=0.8)
    for one in found:
        assert one.words == pytest.approx({"length": length, "least": least})


def test_falls_rates_and_stretches() -> None:
    frequency = np.array([25.0, 20.0, 12.0, 5.0, 12.0, 17.0, 5.0, 19.0, 6.0, 7.0])
    assert _falls(frequency, 18.0, 6.0) == 2
    assert _falls(frequency, 19.0, 6.0) == 2  # both ends count
    assert _falls(frequency, 19.1, 5.9) == 1
    time = np.arange(20.0) * 0.5
    speed = np.concatenate([30.0 - time[:10], 25.5 - 3.0 * (time[10:] - 4.5)])
    assert _rate(time, speed, 0.0, 100.0) == pytest.approx(3.0)
    assert _rate(time, speed, 26.0, 40.0) == pytest.approx(1.0)
    assert _rate(time, speed, 90.0, 100.0) == pytest.approx(3.0)  # nothing in the band: all of it
    assert _rate(time[:7], speed[:7], 0.0, 100.0) == 0.0
    assert _rate(time[:8], speed[:8], 0.0, 100.0) == pytest.approx(1.0)
    level = np.array([9.0] * 5 + [1.0] * 4 + [5.0] * 6 + [1.0] * 5 + [9.0] * 4)
    np.testing.assert_array_equal(_lasting(level, 8.0, 2.0), [9.0] * 5 + [5.0] * 6 + [1.0] * 5)


def test_turns_are_read_from_crossings_of_the_middle() -> None:
    time = np.arange(3000) / RATE
    height = 1e-3 + 3e-3 * np.sin(2.0 * np.pi * 5.0 * time + 0.3)
    crossing, upwards = middle_crossings(time, height, 1e-3, 3e-3)
    expected = (np.pi * np.arange(1, 31) - 0.3) / (2.0 * np.pi * 5.0)
    np.testing.assert_allclose(crossing, expected[: crossing.size], atol=1e-6)
    assert crossing.size in (29, 30)
    assert not upwards  # the first is downwards
    small = np.where(np.abs(height - 1e-3) < 0.6e-3, height, 1e-3 + 0.29 * (height - 1e-3))
    assert (
        middle_crossings(time, small, 1e-3, 3e-3)[0].size == 0
    )  # excursions below 0.3 of the amplitude
    turns = find_turns(time, height, 1e-3, 3e-3)
    tops = (2.0 * np.pi * np.arange(1, 15) + 0.5 * np.pi - 0.3) / (2.0 * np.pi * 5.0)
    np.testing.assert_allclose(turns.top[: tops.size], tops[: turns.top.size], atol=1e-4)
    np.testing.assert_allclose(turns.frequency, 5.0, rtol=1e-4)
    few = time < 1.65
    assert find_turns(time[few], height[few], 1e-3, 3e-3) is None
    enough = time < 1.9
    assert find_turns(time[enough], height[enough], 1e-3, 3e-3) is not None


def test_the_exciter_is_the_plate_and_what_its_spring_takes() -> None:
    """A sprung plate at 5 Hz whose exciter is known: spring force = rate (exciter - plate)."""
    time = np.arange(4000) / RATE
    w = 2.0 * np.pi * 5.0
    height, exciter = 4e-3 * np.sin(w * time), 0.5 * THETA.stroke * np.cos(w * time)
    force = THETA.plate_spring_rate * (exciter - height) + THETA.plate_mass * w**2 * height
    one = WheelSignals("left", time, 4e3 + force, height, None, 4e3, 0.0)
    found = exciter_height(one, THETA)
    np.testing.assert_allclose(found[50:-50], exciter[50:-50], atol=0.02 * THETA.stroke)
    assert exciter_height(one, EGEA) is exciter_height(one, None) is None
    heavy = WheelSignals("left", time, 4e3 + force, height, None, 4e3, 2.0 * THETA.plate_mass)
    moved = (exciter_height(heavy, THETA) - found)[50:-50]
    expected = (-THETA.plate_mass * w**2 * height / THETA.plate_spring_rate)[50:-50]
    np.testing.assert_allclose(moved, expected, atol=0.02 * np.abs(expected).max())
    assert spring_against_height(one, None) == 0.0
    swing = WheelSignals("left", time, 4e3 - THETA.plate_spring_rate * height + THETA.plate_mass * w**2 * height,
                         height, None, 4e3, 0.0)  # fmt: skip
    assert spring_against_height(swing, THETA) == pytest.approx(-1.0, abs=1e-3)
    turned = WheelSignals("left", time, swing.force, -height, None, 4e3, 0.0)
    assert spring_against_height(turned, THETA) > 0.9
    for stroke, told in (
        (0.99, False),
        (1.01, True),
    ):  # where the plate moves more than the exciter
        scale = stroke * THETA.stroke / float(np.ptp(height))
        scaled = WheelSignals(
            "left", time, 4e3 + scale * (swing.force - 4e3), -scale * height, None, 4e3, 0.0
        )
        assert _swings_upside_down(scaled, THETA) is told


def test_turns_of_a_quiet_sprung_plate() -> None:
    """Turns count from an eighth of the exciter's stroke on, also on the slow swing of a car."""
    time = np.arange(6000) / RATE
    slow = 5e-3 * np.sin(2.0 * np.pi * 0.8 * time)
    for share, found in ((0.2, True), (0.05, False)):
        height = slow + share * 0.5 * THETA.stroke * np.sin(2.0 * np.pi * 9.0 * time)
        one = WheelSignals("left", time, np.full(time.size, 4e3), height, None, 4e3, 0.0)
        turns = turns_of(one, THETA)
        nine = turns is not None and abs(float(np.median(turns.frequency)) - 9.0) < 0.1
        assert nine is found


def test_turns_that_belong_to_a_sweep() -> None:
    frequency = np.concatenate([np.full(3, 2.0), np.linspace(10.0, 6.0, 21), [7.0, 6.2, 5.9]])
    time = np.cumsum(1.0 / frequency)
    found = turns_of_sweep(frequency, time)
    np.testing.assert_array_equal(np.flatnonzero(~found), [0, 1, 2, 24, 25])
    assert not turns_of_sweep(frequency[3:7], time[3:7]).any()
    assert turns_of_sweep(frequency[3:8], time[3:8]).all()
    up = turns_of_sweep(frequency[3:24][::-1], np.cumsum(1.0 / frequency[3:24][::-1]))
    assert up.all()
    odd = frequency[3:24].copy()
    odd[10] *= 1.16
    assert np.flatnonzero(~turns_of_sweep(odd, time[3:24])).tolist() == [10]


@pytest.mark.parametrize(
    ("top", "lows", "code"),
    [
        (20.0, [1.0], ""),
        (20.0, [6.9], ""),
        (20.0, [7.1], "sweep_cut_off"),
        (20.0, [14.8], "sweep_cut_off"),
        (20.0, [15.2], "no_sweep"),
        (10.0, [5.9], ""),
        (10.0, [6.1], "sweep_cut_off"),
        (20.0, [4.9, 4.9], "several_sweeps"),
        (20.0, [4.9, 5.1], ""),
        (10.0, [3.9, 3.9], "several_sweeps"),
        (10.0, [3.9, 4.1], ""),
    ],
)
def test_sweeps_of_sprung_plates(top: float, lows: list[float], code: str) -> None:
    parts = [
        part
        for low in lows
        for part in (np.full(9, top), np.linspace(top, low, 40), np.full(9, low))
    ]
    frequency = np.concatenate(parts)
    found = _sprung_findings(
        Sweep(SimpleNamespace(frequency=frequency), 8, frequency.size - 1, slice(0, 9), 1.0), "z"
    )
    assert [one.code for one in found] == ([code] if code else [])
    for one in found:
        assert one.words == (
            {"count": 2}
            if code == "several_sweeps"
            else pytest.approx({"low": lows[0], "top": top})
        )


def test_slow_swings_are_means_over_a_quarter_of_a_second() -> None:
    peak = np.zeros(1001)
    peak[500] = 251.0
    found = _slow_part(peak, RATE)
    np.testing.assert_allclose(
        found, np.where(np.abs(np.arange(1001) - 500) <= 125, 1.0, 0.0), atol=1e-12
    )
    np.testing.assert_allclose(_slow_part(np.full(1001, 3.0), RATE), 3.0)  # also at both ends
