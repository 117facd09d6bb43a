"""Accelerations integrated: known motion comes back, the stated errors are those that occur, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import signal

import jounce as jn
from jounce.core.errors import DescriptionError, RecordingError

RATE = 200.0


def _run(acceleration: np.ndarray) -> object:  # type: ignore[type-arg]
    return jn.recording(
        np.arange(acceleration.size) / RATE, {"body.az": (acceleration, "m/s^2", "")}
    )


def test_a_known_random_motion_comes_back_in_its_band() -> None:
    rng, t = np.random.default_rng(3), np.arange(12_000) / RATE
    z, az, vz = np.zeros(t.size), np.zeros(t.size), np.zeros(t.size)
    for f in np.geomspace(0.9, 20.0, 40):
        w, phase, size = 2.0 * np.pi * f, rng.uniform(0.0, 2.0 * np.pi), 0.01 / f
        z += size * np.sin(w * t + phase)
        vz += size * w * np.cos(w * t + phase)
        az -= size * w**2 * np.sin(w * t + phase)
    found = jn.integrate_acceleration(_run(az + 0.5 + 0.01 * t), above=0.4)
    (one,) = found.channels
    inner = slice(int(4.0 * RATE), -int(4.0 * RATE))
    assert np.std(one.displacement[inner] - z[inner]) < 0.01 * np.std(z)
    assert np.std(one.velocity[inner] - vz[inner]) < 0.01 * np.std(vz)
    assert one.band[0] == pytest.approx(0.4 * 19.0 ** (1.0 / 6.0))
    assert found.valid == pytest.approx((2.5, 59.995 - 2.5))


def test_amplitudes_are_right_within_five_per_cent_from_the_stated_frequency_on() -> None:
    t = np.arange(40_000) / RATE
    for f, least, most in (
        (0.5 * 19.0 ** (1.0 / 6.0), 0.945, 0.955),
        (0.5, 0.49, 0.51),
        (3.0, 0.9999, 1.0001),
    ):
        w = 2.0 * np.pi * f
        (one,) = jn.integrate_acceleration(_run(-(w**2) * np.sin(w * t)), above=0.5).channels
        share = np.std(one.displacement[4000:-4000]) * np.sqrt(2.0)
        assert least < share < most


@pytest.mark.parametrize("motion", ["random", "transient", "periodic"])
def test_noise_gives_the_stated_errors(motion: str) -> None:
    density, squares, errors = 0.01, np.zeros(2), np.zeros(2)
    options = {"random": {"above": 0.5}, "periodic": {"period": 1.0}}.get(motion, {})
    for seed in range(100):
        noise = np.random.default_rng(seed).normal(size=4000) * density * np.sqrt(RATE / 2.0)
        (one,) = jn.integrate_acceleration(
            _run(noise), motion=motion, noise=density, **options
        ).channels  # type: ignore[arg-type]
        inner = slice(400, -400) if motion == "random" else slice(None)
        squares += [np.mean(one.velocity[inner] ** 2), np.mean(one.displacement[inner] ** 2)]
        errors = np.array([one.velocity_error, one.displacement_error])
    assert np.sqrt(squares / 100.0) == pytest.approx(errors, rel=0.08)


def test_the_density_of_noise_is_estimated_and_the_corner_is_found() -> None:
    rng, t = np.random.default_rng(0), np.arange(60_000) / RATE
    sections = signal.butter(4, [1.0, 3.0], "bandpass", fs=RATE, output="sos")
    motion = signal.sosfilt(sections, rng.normal(size=t.size))
    noise = rng.normal(size=t.size)
    found = jn.integrate_acceleration(_run(motion / motion.std() + 0.02 * noise))
    (one,) = found.channels
    assert one.noise == pytest.approx(0.02 / np.sqrt(RATE / 2.0), rel=0.25)
    assert 0.1 < one.corner < 1.2
    assert [item.code for item in found.findings] == ["analysis.corner"]


def test_a_transient_returns_to_its_place_whatever_the_sensor_adds() -> None:
    t = np.arange(1000) / RATE
    inside = (t > 1.0) & (t < 3.0)
    phase = np.pi * (t - 1.0) / 2.0
    z = np.where(inside, 0.05 * np.sin(phase) ** 4, 0.0)
    az = np.where(
        inside,
        0.05 * (np.pi / 2.0) ** 2 * (12.0 * np.sin(phase) ** 2 - 16.0 * np.sin(phase) ** 4),
        0.0,
    )
    found = jn.integrate_acceleration(_run(az + 0.3 - 0.02 * t), motion="transient")
    (one,) = found.channels
    assert np.abs(one.displacement - z).max() < 1e-5
    assert one.displacement[-1] == pytest.approx(0.0, abs=1e-12)
    assert one.removed > 0.1
    assert found.findings == ()


def test_a_record_that_does_not_end_at_rest_is_named() -> None:
    found = jn.integrate_acceleration(_run(np.sin(np.arange(1000) / 5.0)), motion="transient")
    assert [item.code for item in found.findings] == ["analysis.not_at_rest"]


def test_periodic_motion_keeps_only_what_repeats_itself() -> None:
    t = np.arange(2000) / RATE
    w = 2.0 * np.pi * 2.0
    other = np.sin(2.0 * np.pi * 3.3 * t)
    found = jn.integrate_acceleration(
        _run(2.0 - 0.01 * w**2 * np.cos(w * t) + other), motion="periodic", period="0.5 s"
    )
    (one,) = found.channels
    assert one.displacement == pytest.approx(0.01 * np.cos(w * t), abs=2e-4)
    assert one.band[0] == pytest.approx(2.0)


def test_results_are_channels_of_the_same_place() -> None:
    t = np.arange(4000) / RATE
    signals = {
        "pitch_acceleration": (np.sin(9.0 * t), "rad/s^2", ""),
        "body.z": (np.sin(t), "m", ""),
    }
    found = jn.integrate_acceleration(jn.recording(t, signals), above=0.5)
    assert list(found.recording().data_vars) == ["pitch_acceleration", "pitch_rate", "pitch"]
    assert found.recording()["pitch_rate"].attrs["units"] == "rad/s"
    assert "velocity" not in found.to_dict()["channels"][0]


@pytest.mark.parametrize(
    ("options", "error", "words"),
    [
        ({"channels": "body.z"}, RecordingError, "only accelerations are integrated"),
        ({"above": 0.01}, RecordingError, "the corner frequency does not suit the record"),
        (
            {"above": 1.0, "motion": "periodic"},
            DescriptionError,
            "this option is for random motion",
        ),
        ({"period": 50.0, "motion": "periodic"}, RecordingError, "no whole period"),
        ({"motion": "shock"}, DescriptionError, "unknown motion"),
        ({}, RecordingError, "drift hides the motion"),
    ],
)
def test_what_cannot_be_integrated_is_refused(
    options: dict[str, object], error: type[Exception], words: str
) -> None:
    walk = np.cumsum(np.random.default_rng(0).normal(size=4000))
    run = jn.recording(
        np.arange(4000) / RATE, {"body.az": (walk, "m/s^2", ""), "body.z": (walk, "m", "")}
    )
    with pytest.raises(error, match=words):
        jn.integrate_acceleration(run, **options)  # type: ignore[arg-type]
