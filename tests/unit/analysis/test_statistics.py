"""Statistics of channels against closed forms, and what they say of channels that are no signals."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import RecordingError


def test_a_sine_has_the_statistics_of_a_sine() -> None:
    t = np.arange(10_000) / 1000.0
    run = jn.recording(t, {"sprung.az": (1.0 + 3.0 * np.sin(2.0 * np.pi * 4.0 * t), "m/s^2", "")})
    found = jn.describe_channels(run)
    (row,) = found.channels
    assert row.mean.value == pytest.approx(1.0, abs=1e-12)
    assert row.standard_deviation == pytest.approx(3.0 / np.sqrt(2.0), rel=1e-12)
    assert row.rms.value == pytest.approx(np.sqrt(1.0 + 4.5), rel=1e-12)
    assert (row.minimum, row.maximum) == pytest.approx((-2.0, 4.0), abs=3e-4)
    assert row.time_of_maximum % 0.25 == pytest.approx(1.0 / 16.0, abs=1e-3)
    assert row.crest_factor == pytest.approx(np.sqrt(2.0), rel=1e-3)
    assert row.kurtosis == pytest.approx(1.5, rel=1e-9)
    assert row.skewness == pytest.approx(0.0, abs=1e-9)
    assert row.crossings == pytest.approx(4.0, abs=0.11)
    assert found.findings == ()


def test_intervals_of_mean_and_rms_hold_the_truth() -> None:
    inside = np.zeros(2)
    for seed in range(200):
        noise = np.random.default_rng(seed).normal(0.5, 2.0, 4000)
        (row,) = jn.describe_channels(
            jn.recording(np.arange(4000) / 100.0, {"body.az": (noise, "m/s^2", "")})
        ).channels
        inside += [row.mean.has(0.5), row.rms.has(np.sqrt(4.25))]
    assert np.all(inside >= 180)
    assert np.all(inside < 200)


def test_constant_drifting_clipped_and_changing_channels_are_named() -> None:
    rng, t = np.random.default_rng(0), np.arange(20_000) / 1000.0
    noise = rng.normal(size=t.size)
    loud = noise * np.where(t > 19.0, 20.0, 1.0)
    signals = {
        "a.az": 0.0 * t + 2.0,
        "b.az": noise + 0.5 * t,
        "c.az": np.clip(noise, -1.5, 1.5),
        "d.az": loud,
    }
    run = jn.recording(t, {name: (values, "m/s^2", "") for name, values in signals.items()})
    found = {
        one.place.rpartition(": ")[2]: one.message for one in jn.describe_channels(run).findings
    }
    assert "constant" in found["a.az"]
    assert "drifts by 10" in found["b.az"]
    assert "clipped" in found["c.az"]
    assert "from 19 s to 20 s" in found["d.az"]


def test_rows_are_plain_and_a_stretch_is_cut() -> None:
    t = np.arange(1000) / 100.0
    run = jn.recording(t, {"body.z": (np.where(t < 5.0, 0.0, np.sin(40.0 * t)), "m", "")})
    found = jn.describe_channels(run, begin="5 s")
    assert (found.begin, found.end) == (5.0, 9.99)
    assert found.rows()[0]["rms_low"] < found.rows()[0]["rms"] < found.rows()[0]["rms_high"]
    assert "source" not in found.to_dict()


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"channels": "bdy.z"}, "no channel 'bdy.z'"),
        ({"begin": "20 s"}, "too few samples"),
    ],
)
def test_wrong_stretches_and_names_are_refused(options: dict[str, str], words: str) -> None:
    run = jn.recording(np.arange(100) / 100.0, {"body.z": (np.arange(100.0), "m", "")})
    with pytest.raises(RecordingError, match=words):
        jn.describe_channels(run, **options)  # type: ignore[arg-type]


def test_missing_samples_and_gaps_in_time_are_named() -> None:
    t, z = np.arange(100) / 100.0, np.sin(np.arange(100.0))
    z[40] = np.nan
    with pytest.raises(
        RecordingError, match=r"1 of 100 samples are missing; found .the first at 0\.4 s"
    ):
        jn.describe_channels(jn.recording(t, {"body.z": (z, "m", "")}))
    late = np.where(np.arange(100) > 50, t + 0.5, t)
    with pytest.raises(RecordingError, match="time step jitters"):
        jn.describe_channels(jn.recording(late, {"body.z": (np.sin(t), "m", "")}))
