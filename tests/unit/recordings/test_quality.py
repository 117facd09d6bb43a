from __future__ import annotations

import numpy as np
import pytest

from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.units import conversion_factor
from jounce.recordings.quality import check_channels, check_time, frozen_samples, frozen_stretches

STEPS = np.arange(200)


def test_uniform_time_passes_with_rounding() -> None:
    recorded = np.array([float(f"{t:.6f}") for t in STEPS * 0.001])
    time, findings = check_time(recorded, where="a.csv")
    assert findings == []
    np.testing.assert_allclose(time, STEPS * 0.001, rtol=0.0, atol=1e-15)


def test_late_start_is_kept_and_rounding_of_large_times_is_no_jitter() -> None:
    time, findings = check_time(
        1.7e9 + STEPS * 1e-4, where="a.csv"
    )  # a clock in seconds since 1970
    assert findings == []
    assert time[0] == 1.7e9


def test_small_jitter_is_a_finding() -> None:
    recorded = STEPS * 0.001
    recorded[50] += 8e-6
    time, findings = check_time(recorded, where="a.csv")
    assert [f.severity for f in findings] == ["warning"]
    assert "resampled" in findings[0].message
    assert findings[0].value == pytest.approx(0.008, rel=1e-6)
    np.testing.assert_allclose(time, STEPS * 0.001, rtol=0.0, atol=1e-15)


def test_jitter_below_a_millionth_is_rounding() -> None:
    for shift, told in ((0.9e-9, 0), (1.1e-9, 1), (9.9e-6, 1)):
        recorded = STEPS * 0.001
        recorded[50] += shift
        assert [found.value for found in check_time(recorded, where="a.csv")[1]] == [
            pytest.approx(1e3 * shift)
        ] * told


def test_numbers_that_no_range_holds_are_marks() -> None:
    assert check_channels({"sprung.az": np.where(STEPS == 7, 0.99e20, STEPS)}, where="a.csv") == []
    for value in (1.01e20, -9.9e37):
        with pytest.raises(
            RecordingError,
            match=r"a\.csv: sprung\.az: implausible value at row 8; found '.*over-range",
        ):
            check_channels({"sprung.az": np.where(STEPS == 7, value, STEPS)}, where="a.csv")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda t: np.where(STEPS == 50, t + 12e-6, t), r"jitters by 1\.2 % at row 51"),
        (
            lambda t: np.where(STEPS == 50, t + 10.1e-6, t),
            r"jitters by 1\.01 % at row 51; .*too few digits",
        ),
        (
            lambda t: np.delete(t, 70),
            r"at row 71.*found 'a step of 0\.002 s'.*1 sample missing there",
        ),
        (
            lambda t: np.delete(t, [70, 71]),
            r"at row 71.*allowed: 0\.001 s within 1 %.*2 samples missing there",
        ),
        (
            lambda t: np.where(STEPS == 9, t[8], t),
            r"time does not increase at row 10; found '0\.008 s after 0\.008 s'",
        ),
        (lambda t: t[::-1].copy(), "time does not increase at row 2"),
        (lambda t: t * 0.0, "time is zero in every row"),
        (
            lambda t: np.where(STEPS == 3, np.nan, t),
            "a.csv: time: not a finite number at row 4; found 'nan'",
        ),
        (lambda t: t[:7], "too few samples; found '7'; allowed: at least 8"),
        (lambda t: t[:1], "too few samples"),
        (lambda t: t[:0], "too few samples"),
        (lambda t: np.round(t * 1.37, 4), "too few digits"),
    ],
)
def test_bad_time(change: object, message: str) -> None:
    assert check_time(STEPS[:8] * 0.001, where="a.csv")[0].size == 8
    with pytest.raises(RecordingError, match=message):
        check_time(change(STEPS * 0.001), where="a.csv")  # type: ignore[operator]


def test_rows_are_named_by_the_caller() -> None:
    with pytest.raises(RecordingError, match="at line 12"):
        check_time(
            np.where(STEPS == 10, 0.0, STEPS * 0.001),
            where="a.csv",
            name_row=lambda row: f"line {row + 2}",
        )


def test_good_channels_have_no_findings() -> None:
    wave = np.sin(STEPS * 0.1)
    assert (
        check_channels(
            {"sprung.az": wave, "sprung.z": np.concatenate((np.zeros(50), wave))}, where="a"
        )
        == []
    )


def test_not_a_number_names_channel_and_row() -> None:
    with pytest.raises(
        RecordingError, match=r"a\.csv: sprung\.az: not a finite number at row 6; found 'inf'"
    ):
        check_channels({"sprung.az": np.where(STEPS == 5, np.inf, 0.1 * STEPS)}, where="a.csv")


def test_constant_channel() -> None:
    (finding,) = check_channels({"sprung.az": np.full(20, 0.3)}, where="a.csv")
    assert (finding.place, finding.severity, finding.value) == ("a.csv: sprung.az", "warning", 0.3)
    assert "constant" in finding.message
    assert len(check_channels({"force": np.full(2, 3.0)}, where="")) == 1
    assert check_channels({"force": np.full(1, 3.0)}, where="", clipping=False) == []


def test_nothing_is_said_of_a_level_road_and_of_no_braking() -> None:
    still = dict.fromkeys(
        ("road.z", "front.road.z", "body.pitch_moment", "body.lateral_acceleration"), np.zeros(20)
    )
    assert check_channels(still, where="a.csv") == []
    (finding,) = check_channels(
        {"front.road.z": np.full(20, 0.3), "platform.z": np.arange(20.0)}, where="a.csv"
    )
    assert finding.place == "a.csv: front.road.z"
    wave = np.clip(np.sin(STEPS * 0.1), -0.9, 2.0)
    assert (
        check_channels({"front_left.road.z": wave, "body.pitch_moment": wave}, where="a.csv") == []
    )


def test_clipped_channel() -> None:
    wave = np.clip(np.sin(STEPS * 0.1), -0.9, 2.0)
    (finding,) = check_channels({"sprung.az": wave}, where="a.csv")
    assert "clipped" in finding.message
    assert finding.value == pytest.approx(np.mean(wave == -0.9), abs=1e-12)
    assert check_channels({"sprung.az": wave}, where="a.csv", clipping=False) == []


@pytest.mark.parametrize(
    ("pieces", "clipped"),
    [
        (([2.0, 5.0, 5.0, 5.0, 2.0],) * 2, 6),
        (([2.0, *[5.0] * 6, 2.0],), 6),
        (([2.0, *[5.0] * 5, 2.0],), 0),  # fewer than six samples
        (([2.0, 5.0, 5.0, 2.0],) * 3, 0),  # runs of two
        (([2.0, 5.0, 5.0, 5.0, 2.0], [2.0, 5.0, 5.0, 2.0], [2.0, *[5.0] * 4, 2.0]), 7),
        (
            ([4.84, *[5.0] * 6, 4.84],),
            6,
        ),  # entered and left by more than one and a half of the resolution
        (([4.86, *[5.0] * 6, 2.0],), 0),
        (([2.0, *[5.0] * 6, 4.86],), 0),
        (([2.0, *[5.0] * 6],), 0),  # at the end of the record
    ],
)
def test_clipped_samples_are_counted_in_runs_of_three(
    pieces: tuple[list[float], ...], clipped: int
) -> None:
    wave = np.array([0.5, 0.6, 0.7, *(value for piece in pieces for value in piece)])
    for values in (wave, wave[::-1], 9.0 - wave):
        found = check_channels({"sprung.az": values}, where="a.csv")
        assert [one.value for one in found] == [
            pytest.approx(clipped / wave.size, rel=1e-12)
        ] * bool(clipped)
        for name in (
            "road.z",
            "left.platform.z",
            "road.slope",
            "damper.command",
            "left.adhesion",
            "body.deceleration",
        ):
            assert check_channels({name: values}, where="a.csv") == []
    both = np.concatenate(((5.0 - wave)[::-1], wave))
    assert [one.value for one in check_channels({"sprung.az": both - 9.0}, where="a.csv")] == (
        [pytest.approx(2.0 * clipped / both.size, rel=1e-12)] if clipped else []
    )


@pytest.mark.parametrize(
    ("name", "values"),
    [
        (
            "sprung.az",
            np.round(np.sin(STEPS * 0.02) * 100.0) / 100.0,
        ),  # coarse but unclipped: enters by one step
        ("tyre.force", np.maximum(np.sin(STEPS * 0.1) * 300.0, 0.0)),  # lift-off
        (
            "sprung.z",
            np.concatenate((np.full(30, -0.05), -0.05 + 0.01 * (1.0 - np.cos(STEPS * 0.1)))),
        ),  # rest first
        ("road.z", np.where((STEPS > 50) & (STEPS < 90), 0.01, 0.0)),  # a rectangular obstacle
    ],
)
def test_flat_pieces_that_are_not_clipping(name: str, values: np.ndarray) -> None:
    assert check_channels({name: values}, where="a.csv") == []


@pytest.mark.parametrize("count", [0, 1])
def test_too_few_samples_say_nothing(count: int) -> None:
    assert check_channels({"sprung.az": np.ones(count)}, where="a.csv") == []


def test_values_that_are_held_are_not_taken_for_clipped() -> None:
    """A force at a tenth of the rate, repeated to fill the rows, was said to be clipped."""
    wave = np.sin(np.arange(2000) * 0.012)
    (found,) = check_channels({"strut.force": np.repeat(wave[::10], 10)}, where="a.csv")
    assert "each value is held for 10 samples" in found.message
    assert found.value == 10.0
    (clipped,) = check_channels({"strut.force": np.clip(wave, -0.9, 0.9)}, where="a.csv")
    assert "looks clipped" in clipped.message
    assert check_channels({"strut.force": np.round(wave, 2)}, where="a.csv") == []


def test_a_clock_that_stands_or_goes_back_says_what_to_do() -> None:
    for time in (np.repeat(STEPS * 0.01, 2), np.concatenate([STEPS, STEPS]) * 0.01):
        with pytest.raises(RecordingError, match=r"time does not increase at .*sample_time"):
            check_time(time, where="a.csv")


def test_a_voltage_is_told_from_a_misspelt_unit() -> None:
    for unit in ("mV", "V"):
        with pytest.raises(DescriptionError, match="divide by its sensitivity"):
            conversion_factor(unit, "m/s^2")
    with pytest.raises(DescriptionError, match="Check spelling"):
        conversion_factor("N/mV", "m/s^2")


NOISE = np.random.default_rng(4).normal(size=3000)
SWING = np.exp(-(np.arange(3000) % 1000) / 250.0) * np.sin(np.arange(3000) % 1000 * 0.03)


def _with(values: np.ndarray, start: int, count: int, held: float | None) -> np.ndarray:
    found = values.copy()
    found[start : start + count] = found[start] if held is None else held
    return found


@pytest.mark.parametrize(
    ("values", "start", "count"),
    [
        (_with(np.round(NOISE, 2), 500, 2000, 0.0), 500, 2000),
        (_with(np.round(SWING + 0.01 * NOISE, 3), 1100, 20, 0.0), 1100, 20),
        (_with(np.round(SWING + 0.01 * NOISE, 3), 1105, 20, None), 1105, 20),
        (_with(SWING, 1100, 20, 0.0), 1100, 20),  # a simulation without noise
        (_with(2.0 + SWING, 1100, 20, 0.0), 1100, 20),  # at the end of the range, but by a jump
    ],
)
def test_a_stretch_without_signal_is_found_and_told(
    values: np.ndarray, start: int, count: int
) -> None:
    assert frozen_stretches(values) == [(start, start + count)]
    assert np.flatnonzero(frozen_samples(values)).tolist() == list(range(start, start + count))
    (told,) = check_channels({"sprung.az": values}, where="a.csv")
    assert told.severity == "warning"
    assert f"for {count} samples from sample {start + 1} on" in told.message
    assert told.value == pytest.approx(count / values.size)
    assert check_channels({"road.z": values}, where="a.csv") == []


@pytest.mark.parametrize("bits", range(4, 15))
@pytest.mark.parametrize("noise", [0.0, 0.1, 0.3, 0.5, 1.0])
def test_a_coarse_sensor_that_comes_to_rest_is_not_frozen(bits: int, noise: float) -> None:
    step, time = 2.0 / 2**bits, np.arange(3000) * 1e-3
    rest = (
        np.where(time % 1.0 < 0.7, SWING, 0.0) * np.clip((0.7 - time % 1.0) / 0.3, 0.0, 1.0) ** 2
    )  # hits, settles
    for signal in (
        SWING,
        rest,
        np.sin(3.0 * time),
        np.cumsum(NOISE) / 60.0,
        np.maximum(np.sin(20.0 * time), 0.0),
    ):
        assert frozen_stretches(np.round((signal + noise * step * NOISE) / step) * step) == []


def test_a_tyre_off_the_ground_and_a_model_at_rest_are_not_frozen() -> None:
    force = np.maximum(400.0 + 500.0 * np.sin(STEPS * 0.1), 0.0)
    assert frozen_stretches(force) == []
    assert (
        frozen_stretches(
            np.maximum(400.0 + 500.0 * np.sin(np.arange(3000) * 0.05) + 5.0 * NOISE, 0.0)
        )
        == []
    )
    rest = 1e-17 * np.round(NOISE[:100])
    rest[40:60] = 1e-17
    assert frozen_stretches(np.concatenate((rest, SWING))) == []
