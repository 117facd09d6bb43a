"""Maps of dampers and histograms from the track, in processor time, which hardly depends on other load."""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np
import xarray as xr
from timing import Row, processor_time

import jounce as jn

RATE, SECONDS = 1000.0, 3600
TARGET, MAP_TARGET = "≤ 0.5 s", "≤ 1 s"
REPEATS = 5
CORNERS = ("front_left", "front_right", "rear_left", "rear_right")


def damper_rows() -> list[Row]:
    """Maps of a folder of records, and histograms of an outing."""
    return [*_map_rows(), *_histogram_rows()]


def _map_rows() -> list[Row]:
    """Three clicks at four velocities, 60 s at 1 kHz each, read from files."""
    rows = []
    for ending, way in ((".nc", "netCDF"), (".csv", "CSV")):
        with tempfile.TemporaryDirectory() as folder:
            for clicks in (0, 4, 8):
                for frequency in (0.5, 1.0, 2.0, 4.0):
                    name = f"c{clicks}_{frequency:g}Hz{ending}"
                    jn.write_recording(_dyno(clicks, frequency), Path(folder) / name)

            def make(records: str = folder) -> jn.DamperMap:
                return jn.damper_map(records)

            made = make()
            median = float(np.median([processor_time(make) for _ in range(REPEATS)]))
        note = f"{len(made.settings)} settings, {len(made.runs)} records"
        problem = f"damper map, 12 records of 60 s at 1 kHz, {way}"
        rows.append(Row(problem, "`jn.damper_map`", median, target=MAP_TARGET, note=note))
    return rows


def _dyno(clicks: int, frequency: float) -> xr.Dataset:
    """Return a record of a damper of 1.5 to 2.3 kN s/m with gas, friction, a lag of 2 ms and noise."""
    random = np.random.default_rng(clicks * 10 + int(frequency))
    time = np.arange(0.0, SECONDS / 60.0, 1.0 / RATE)
    turn = 2.0 * np.pi * frequency
    stroke = 0.025 * np.sin(turn * time)
    velocity = 0.025 * turn * np.cos(turn * (time - 0.002))
    force = (1500.0 + 100.0 * clicks) * velocity / (1.0 + np.abs(velocity))
    force += 15.0 * np.sign(velocity) + 120.0 + 900.0 * stroke + random.normal(0.0, 4.0, len(time))
    return jn.recording(time, {"displacement": (stroke, "m", ""), "force": (force, "N", "")})


def _histogram_rows() -> list[Row]:
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
