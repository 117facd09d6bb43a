from __future__ import annotations

import zlib

import numpy as np
import pytest
from scipy import signal

from jounce.core.errors import DescriptionError, RecordingError
from jounce.recordings import Sensor, apply_sensors, filter_signals, recording
from jounce.recordings.sensors import bias_of, check_sensors, noise_of, sections_of

RATE = 1000.0
TIME = np.arange(4000) / RATE
CHAIN = Sensor(high_pass="0.5 Hz", low_pass="100 Hz", gain=1.02, orientation=-1)


def gain_and_phase(sensor: Sensor, frequency: float) -> complex:
    """Steady response to a unit oscillation, measured on the second half of a long signal."""
    wave = np.exp(2j * np.pi * frequency * TIME)
    out = filter_signals(wave.real, RATE, sensor) + 1j * filter_signals(wave.imag, RATE, sensor)
    return complex(np.mean((out / wave)[2000:]))


@pytest.mark.source(
    kind="program",
    key="scipy",
    of="signals and identification",
    where="scipy.signal.butter",
    tolerance="rounding",
)
def test_the_high_pass_is_the_bilinear_filter() -> None:
    high = signal.butter(1, 0.5, "highpass", fs=RATE, output="sos")
    np.testing.assert_allclose(sections_of(CHAIN, RATE)[:1], high, rtol=1e-12, atol=1e-15)


@pytest.mark.parametrize("corner", [0.5, 4.0, 5.0, 20.0, 60.0, 100.0, 150.0, 250.0, 400.0])
def test_the_low_pass_is_the_analogue_filter(corner: float) -> None:
    """Poles, gain at the corner, and the delay of what is slow, of which the bilinear filter lacks 7 % at 150 Hz."""
    (section,) = sections_of(Sensor(low_pass=corner), RATE)
    analogue = signal.butter(2, 2.0 * np.pi * corner, analog=True)
    poles = np.exp(np.roots(analogue[1]) / RATE)
    np.testing.assert_allclose(np.sort(np.roots(section[3:])), np.sort(poles), rtol=3e-4)
    frequencies = corner * np.array([1e-3, 0.3, 1.0])
    _, response = signal.freqz(section[:3], section[3:], worN=frequencies, fs=RATE)
    _, truth = signal.freqs(*analogue, worN=2.0 * np.pi * frequencies)
    assert abs(response[2]) == pytest.approx(np.sqrt(0.5), rel=1e-6)
    assert np.angle(response[0]) == pytest.approx(np.angle(truth[0]), rel=2e-4)
    assert abs(response[1] - truth[1]) < 0.05 * corner / RATE
    assert np.abs(signal.freqz(section[:3], section[3:], worN=400)[1]).max() < 1.01


def test_corners_are_at_minus_3_db() -> None:
    assert abs(gain_and_phase(Sensor(high_pass=20.0), 20.0)) == pytest.approx(
        np.sqrt(0.5), abs=1e-4
    )
    assert abs(gain_and_phase(Sensor(low_pass=100.0), 100.0)) == pytest.approx(
        np.sqrt(0.5), abs=1e-4
    )


def test_low_pass_is_causal_and_delays_as_documented() -> None:
    phase = np.angle(gain_and_phase(Sensor(low_pass=20.0), 1.0))
    assert -phase / (2.0 * np.pi * 1.0) == pytest.approx(0.225 / 20.0, rel=0.005)


@pytest.mark.parametrize("level", [0.0, -9.81])
def test_rest_stays_at_rest(level: float) -> None:
    out = filter_signals(np.full(300, level), RATE, Sensor(low_pass="50 Hz"))
    np.testing.assert_allclose(out, level, rtol=0.0, atol=1e-13)
    out = filter_signals(np.full(300, level), RATE, CHAIN)
    np.testing.assert_allclose(out, 0.0, rtol=0.0, atol=1e-13)


def test_steady_and_zero_start_differ_only_for_a_signal_that_does_not_start_at_zero() -> None:
    pulse = np.sin(TIME * 30.0)
    np.testing.assert_array_equal(
        filter_signals(pulse, RATE, CHAIN), filter_signals(pulse, RATE, CHAIN, initial="zero")
    )
    step = filter_signals(np.ones(100), RATE, Sensor(low_pass="50 Hz"), initial="zero")
    assert step[0] == pytest.approx(sections_of(Sensor(low_pass=50.0), RATE)[0, 0], rel=1e-12)


@pytest.mark.parametrize("initial", ["steady", "zero"])
def test_derivatives_pass_the_same_filter(initial: str) -> None:
    def motion(stiffness: float) -> np.ndarray:
        return np.cos(np.sqrt(stiffness) * TIME) * np.exp(-TIME)

    slope = -np.sin(np.sqrt(900.0) * TIME) * np.exp(-TIME) * TIME * 0.5 / np.sqrt(900.0)
    exact = filter_signals(slope, RATE, CHAIN, initial=initial)  # type: ignore[arg-type]
    h = 1e-3
    runs = [filter_signals(motion(900.0 + d), RATE, CHAIN, initial=initial) for d in (h, -h)]  # type: ignore[arg-type]
    np.testing.assert_allclose(exact, (runs[0] - runs[1]) / (2.0 * h), rtol=0.0, atol=1e-9)


def test_columns_are_filtered_alike() -> None:
    both = np.stack((np.sin(TIME * 30.0), np.cos(TIME * 30.0)), axis=1)
    out = filter_signals(both, RATE, CHAIN)
    np.testing.assert_array_equal(out[:, 1], filter_signals(both[:, 1], RATE, CHAIN))
    assert filter_signals(np.zeros((0, 2)), RATE, CHAIN).shape == (0, 2)


def test_ideal_sensor_changes_nothing() -> None:
    assert Sensor(noise="1 g").is_ideal
    assert not CHAIN.is_ideal
    np.testing.assert_array_equal(filter_signals(TIME, RATE, Sensor()), TIME)


@pytest.mark.parametrize("key", ["high_pass", "low_pass"])
def test_corner_above_half_the_sample_rate(key: str) -> None:
    with pytest.raises(
        RecordingError,
        match=rf"sensor of sprung\.az: {key}: .*found '500 Hz'; allowed: .*below 500 Hz",
    ):
        apply_sensors(run(), {"sprung.az": Sensor(**{key: "500 Hz"})})


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"gain": 0}, "gain of 0"),
        ({"noise": "-0.1 g"}, "noise: out of range; found '-0.1 g'; allowed: at least 0"),
        ({"noise": -0.1}, "noise: out of range"),
        ({"bias": "much"}, "bias: invalid physical value; found 'much'"),
        ({"bias": float("nan")}, "bias: invalid physical value"),
        ({"bias": True}, "bias: invalid physical value"),
        ({"high_pass": "-1 Hz"}, "high_pass: out of range"),
        ({"high_pass": "1 m"}, "high_pass: wrong unit"),
        ({"high_pass": "9 Hz", "low_pass": "8 Hz"}, "not below low_pass"),
        ({"orientation": 2}, "orientation"),
        ({"hih_pass": "1 Hz"}, "unknown key.*Did you mean 'high_pass'"),
    ],
)
def test_impossible_sensors(fields: dict[str, object], message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        Sensor(**fields)


def run() -> object:
    return recording(
        TIME, {"sprung.az": (np.sin(TIME * 30.0), "m/s^2", ""), "road.z": (TIME * 0.0, "m", "")}
    )


def test_bias_and_noise_have_the_unit_of_the_channel() -> None:
    sensor = Sensor(bias="0.1 g", noise="10 mm/s^2")
    assert bias_of(sensor, "m/s^2") == pytest.approx(0.980665, rel=1e-14)
    assert noise_of(sensor, "m/s^2") == pytest.approx(0.01, rel=1e-14)
    with pytest.raises(
        DescriptionError,
        match=r"sensor of road\.z: bias: wrong unit; found 'g'; allowed: .*converts to m",
    ):
        apply_sensors(run(), {"road.z": sensor})


def test_recorded_signal() -> None:
    motion = run()
    record = apply_sensors(
        motion, {"sprung.az": Sensor(bias="2 m/s^2", gain=1.1, orientation=-1, noise="1 m/s^2")}
    )
    np.testing.assert_allclose(
        record["sprung.az"], 2.0 - 1.1 * motion["sprung.az"], rtol=0.0, atol=1e-14
    )
    assert record["sprung.az"].attrs == motion["sprung.az"].attrs
    np.testing.assert_array_equal(record["road.z"], motion["road.z"])
    np.testing.assert_array_equal(motion["sprung.az"], np.sin(TIME * 30.0))


@pytest.mark.parametrize(
    ("datum", "zero"), [("rest", 3.0), ("undeformed", 0.0), ("free offset", 0.0), (None, 0.0)]
)
def test_a_sensor_that_was_zeroed_at_rest_counts_from_the_first_sample(
    datum: str | None, zero: float
) -> None:
    motion = recording(TIME, {"sprung.z": (3.0 + np.sin(TIME * 30.0), "m", "")})
    record = apply_sensors(motion, {"sprung.z": Sensor(datum=datum, gain=2.0, bias="10 mm")})
    np.testing.assert_allclose(
        record["sprung.z"], 0.01 + 2.0 * (motion["sprung.z"] - zero), rtol=0.0, atol=1e-14
    )


def test_values_of_sensors_are_checked_before_anything_is_computed() -> None:
    check_sensors({"sprung.az": Sensor(bias="1 g", noise="1 mm/s^2")}, "bench")
    for key in ("bias", "noise"):
        with pytest.raises(
            DescriptionError, match=rf"bench: sprung\.az\.{key}: wrong unit; found 'mm'"
        ):
            check_sensors({"sprung.az": Sensor(**{key: "3 mm"})}, "bench")


def test_noise_needs_a_seed_and_depends_on_seed_and_channel_only() -> None:
    noisy = {"sprung.az": Sensor(noise="0.2 m/s^2"), "road.z": Sensor(noise="1 mm")}
    first, again = (apply_sensors(run(), noisy, seed=1) for _ in range(2))
    alone = apply_sensors(run(), {"sprung.az": noisy["sprung.az"]}, seed=1)
    other = apply_sensors(run(), noisy, seed=2)
    np.testing.assert_array_equal(first["sprung.az"], again["sprung.az"])
    np.testing.assert_array_equal(first["sprung.az"], alone["sprung.az"])
    difference = (first["sprung.az"] - run()["sprung.az"]).values
    same_ever = 0.2 * np.random.default_rng([1, zlib.crc32(b"sprung.az")]).standard_normal(
        TIME.size
    )
    np.testing.assert_allclose(difference, same_ever, rtol=0.0, atol=1e-14)
    assert abs(difference.mean()) < 0.015
    assert abs(np.corrcoef(difference, first["road.z"].values)[0, 1]) < 0.06
    assert (
        abs(np.corrcoef(difference, (other["sprung.az"] - run()["sprung.az"]).values)[0, 1]) < 0.06
    )


def test_unknown_channel() -> None:
    with pytest.raises(
        DescriptionError, match=r"unknown channel 'sprung\.ax'.*Did you mean 'sprung\.az'"
    ):
        apply_sensors(run(), {"sprung.ax": CHAIN})
