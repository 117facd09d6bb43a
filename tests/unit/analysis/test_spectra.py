"""Spectra of records: Parseval, intervals, peaks, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError, RecordingError


def test_a_sine_has_its_mean_square_and_its_peak() -> None:
    t = np.arange(0.0, 100.0, 0.002)
    noise = np.random.default_rng(1).normal(size=t.size)
    run = jn.recording(
        t, {"sprung.az": (2.0 * np.sin(2.0 * np.pi * 7.3 * t) + 0.5 * noise, "m/s^2", "")}
    )
    (row,) = jn.estimate_spectra(run).channels
    assert row.rms**2 == pytest.approx(2.0 + 0.25, rel=0.01)
    (peak,) = row.peaks
    assert peak.frequency == pytest.approx(7.3, abs=0.02)
    assert peak.rms**2 == pytest.approx(2.0, rel=0.02)


def test_intervals_hold_the_density_of_white_noise() -> None:
    inside, count = 0, 0
    for seed in range(40):
        noise = np.random.default_rng(seed).normal(size=12_000)
        run = jn.recording(np.arange(12_000) / 100.0, {"sprung.az": (noise, "m/s^2", "")})
        found = jn.estimate_spectra(run, segment="2 s")
        density = found.channels[0].density[2:-1]
        low, high = (density * factor for factor in found.interval)
        inside += int(np.count_nonzero((low <= 0.02) & (high >= 0.02)))  # 1 (m/s^2)^2 over 50 Hz
        count += density.size
    assert 0.94 <= inside / count <= 0.96
    assert found.degrees_of_freedom == pytest.approx(2.0 * 119 / (1.0 + 2.0 / 36.0), rel=0.01)


def test_noise_has_no_peaks() -> None:
    peaks = 0
    for seed in range(40):
        noise = np.random.default_rng(seed).normal(size=12_000)
        run = jn.recording(np.arange(12_000) / 100.0, {"sprung.az": (noise, "m/s^2", "")})
        peaks += len(jn.estimate_spectra(run).channels[0].peaks)
    assert peaks <= 4


def test_slow_channels_end_the_band_and_constant_ones_stay_out() -> None:
    t = np.arange(6000) / 100.0
    noise = np.random.default_rng(0).normal(size=6000)
    signals = {
        "body.az": (noise, "m/s^2", ""),
        "body.z": (noise, "m", ""),
        "tyre.force": (0.0 * t, "N", ""),
    }
    run = jn.recording(t, signals)
    run["body.z"].attrs["recorded_rate"] = 50.0
    found = jn.estimate_spectra(run)
    assert found.band == (0.0, 20.0)
    assert [row.channel for row in found.channels] == ["body.az", "body.z"]
    texts = [str(one) for one in found.findings]
    assert any("body.z: recorded only up to 20 Hz" in text for text in texts)
    assert any("tyre.force: the channel is constant" in text for text in texts)


def test_a_file_is_read(tmp_path: Path) -> None:
    file = tmp_path / "lap.csv"
    t = np.arange(2000) / 200.0
    rows = "\n".join(
        f"{a:.4f};{b:.5f}" for a, b in zip(t, np.sin(2.0 * np.pi * 5.0 * t), strict=True)
    )
    file.write_text(f"time [s];sprung.az [g]\n{rows}\n")
    found = jn.estimate_spectra(file, "sprung.az", band=(1.0, 20.0))
    assert found.record == str(file)
    assert found.channels[0].peaks[0].frequency == pytest.approx(5.0, abs=0.05)
    assert found.channels[0].rms == pytest.approx(9.80665 / np.sqrt(2.0), rel=0.01)


@pytest.mark.parametrize(
    ("options", "error", "words"),
    [
        ({"segment": "30 s"}, RecordingError, "the segment does not fit the record; found '30 s'"),
        ({"band": (60.0, 70.0)}, RecordingError, "the band contains no frequency of the record"),
        ({"band": (5.0, 2.0)}, RecordingError, "the band contains no frequency of the record"),
        ({"window": "hamming"}, DescriptionError, "unknown window"),
        ({"confidence": 1.0}, DescriptionError, "invalid confidence level"),
        ({"end": "0.3 s"}, RecordingError, "too short for a spectrum"),
    ],
)
def test_what_cannot_be_estimated_is_refused(
    options: dict[str, object], error: type[Exception], words: str
) -> None:
    run = jn.recording(np.arange(1000) / 100.0, {"body.z": (np.sin(np.arange(1000.0)), "m", "")})
    with pytest.raises(error, match=words):
        jn.estimate_spectra(run, **options)  # type: ignore[arg-type]
