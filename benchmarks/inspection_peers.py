"""Typical own scripts of a laboratory: evaluation by EGEA's text, a run-down with SciPy, a table with pandas."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from peers import Array


def egea_script(record: Any) -> tuple[float, float]:
    """Adhesion (1) and minimum phase angle (degrees): low-pass filter per cycle, then its minimum force."""
    from scipy.signal import firwin, kaiser_beta

    time, height, force = (
        record[name].to_numpy() for name in ("time", "left.plate.z", "left.plate.force")
    )
    load, rate = record.attrs["left.static_load"], 1.0 / (time[1] - time[0])
    up = np.flatnonzero((height[:-1] <= 0.0) & (height[1:] > 0.0))
    crossing = time[up] - height[up] / (height[up + 1] - height[up]) / rate
    angles, least = [], []
    for begin, end in pairwise(crossing):
        f = 1.0 / (end - begin)
        if not 5.0 < f < 25.5:
            continue
        top = begin + 0.25 / f
        reach = int(0.56 * rate / f)
        taps = firwin(2 * reach + 1, 3.0 * f, window=("kaiser", kaiser_beta(40.0)), fs=rate)
        first, last = int((top - 0.7 / f) * rate) - reach, int((top + 1.2 / f) * rate) + reach
        if first < 0 or last >= time.size:
            continue
        smooth, at = (
            np.convolve(force[first : last + 1], taps, "valid"),
            time[first + reach : last + 1 - reach],
        )
        window = (at > top - 0.12 / f) & (at < top + 0.63 / f)
        low = int(np.flatnonzero(window)[np.argmin(smooth[window])])
        falls = np.flatnonzero((smooth[:low] >= load) & (smooth[1 : low + 1] < load))
        rises = np.flatnonzero((smooth[low:-1] < load) & (smooth[low + 1 :] >= load)) + low
        least.append(smooth[low])
        if falls.size and rises.size and 6.0 <= f <= 18.0:
            a, b = (
                at[k] + (load - smooth[k]) / (smooth[k + 1] - smooth[k]) / rate
                for k in (falls[-1], rises[0])
            )
            angles.append(360.0 * f * (0.5 * (a + b) - top))
    return float(np.min(least)) / load, float(np.min(angles))


def run_down(rig: Any, tester: Any, times: Array, tolerance: float) -> Array:
    """Tyre force (N) of a quarter car without friction on a rigid plate: hold, linear run-down, by SciPy's DOP853."""
    from scipy.integrate import solve_ivp

    programme, lever = tester.programme, np.cos(rig.strut.angle or 0.0)
    k, c = rig.strut.spring.rate * lever**2, rig.strut.damper.coefficient * lever**2
    ms, mu, kt, ct = (
        rig.sprung.mass,
        rig.unsprung.mass,
        rig.tyre.stiffness,
        rig.tyre.damping_coefficient,
    )
    load = (ms + mu) * rig.gravity
    hold, sweep, amplitude = programme.hold_time, programme.sweep_rate, 0.5 * tester.stroke
    end = hold + programme.start_frequency / sweep

    def plate(t: Any) -> tuple[Any, Any]:
        late = np.clip(t - hold, 0.0, end - hold)
        angle = (
            2.0 * np.pi * (programme.start_frequency * np.minimum(t, end) - 0.5 * sweep * late**2)
        )
        speed = 2.0 * np.pi * (programme.start_frequency - sweep * late)
        return amplitude * np.sin(angle), amplitude * speed * np.cos(angle)

    def rate(t: float, x: Array) -> list[float]:
        z, v = plate(t)
        tyre = max(kt * (z - x[1]) + ct * (v - x[3]) + load, 0.0) - load
        strut = k * (x[1] - x[0]) + c * (x[3] - x[2])
        return [x[2], x[3], strut / ms, (tyre - strut) / mu]

    z, v = plate(times)
    x, parts = np.zeros(4), []
    for first, last in ((0.0, hold), (hold, times[-1])):
        at = times[(times >= first) & (times < last)]
        found = solve_ivp(
            rate,
            (first, last),
            x,
            "DOP853",
            np.append(at, last),
            rtol=tolerance,
            atol=tolerance * 1e-4,
            max_step=0.02,
        )
        parts.append(found.y[:, :-1])
        x = found.y[:, -1]
    states = np.hstack([*parts, x[:, None]])
    return np.maximum(kt * (z - states[1]) + ct * (v - states[3]) + load, 0.0)


def table_of_numbers(file: Path) -> Array:
    """Numbers of a CSV file, without header, units and checks."""
    import pandas as pd

    return pd.read_csv(file, comment="#", skipinitialspace=True).to_numpy()
