"""Histograms of an hour of four dampers at 1 kHz, in processor time, which hardly depends on other load."""

from __future__ import annotations

import sys

import numpy as np
import xarray as xr
from timing import Row, processor_time

import jounce as jn

RATE, SECONDS = 1000.0, 3600
TARGET = "≤ 0.5 s"
REPEATS = 5
CORNERS = ("front_left", "front_right", "rear_left", "rear_right")


def damper_rows() -> list[Row]:
    """Travel and velocity of four corners over 60 laps, from a recording in memory."""
    run = _outing()

    def count() -> jn.DamperHistograms:
        return jn.damper_histograms(run)

    made = count()
    median = float(np.median([processor_time(count) for _ in range(REPEATS)]))
    samples = run.sizes["time"] * len(CORNERS)
    note = f"{len(made.sections) - 1} laps, {median / samples * 1e9:.0f} ns a sample"
    problem = "damper histograms, an hour of four channels at 1 kHz"
    return [Row(problem, "`jn.damper_histograms`", median, target=TARGET, note=note)]


def _outing() -> xr.Dataset:
    """Return an outing: body motion and wheel hop of random size, quantised noise of potentiometers, lap markers."""
    random = np.random.default_rng(1)
    count = int(SECONDS * RATE)
    channels = {}
    for corner in CORNERS:
        road = random.normal(size=count + 60)
        hop = np.convolve(road, np.hanning(61) * np.cos(np.arange(-30, 31) * 0.08), "valid")
        body = 8e-3 * np.sin(0.9 * np.arange(count) / RATE + random.uniform(0.0, 6.0))
        travel = 0.03 + body + 2e-4 * hop + random.normal(0.0, 3e-5, count)
        channels[f"{corner}.damper.travel"] = (np.round(travel, 5), "m", "")
    beacons = np.arange(30.0, SECONDS, 59.0)
    return jn.recording(np.arange(count) / RATE, channels, attributes={"beacons": beacons})


if __name__ == "__main__":
    from timing import markdown

    sys.stdout.write(markdown(damper_rows()) + "\n")
