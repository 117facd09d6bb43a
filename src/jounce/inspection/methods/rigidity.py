"""Tyre rigidity by EGEA from the force amplitude of the hold at 25 Hz."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from jounce.core.constants import NORMAL_95
from jounce.core.findings import Finding
from jounce.inspection.checks import warning
from jounce.inspection.signals.conditioning import WheelSignals
from jounce.inspection.signals.course import Course
from jounce.testers.plates import RIGIDITY, RIGIDITY_FREQUENCY, tyre_rigidity

_TOLERANCE = 1.0  # Hz
_FEWEST_TURNS = 6


@dataclass(frozen=True)
class Rigidity:
    """Tyre rigidity (N/m), half width of its 95 % interval (N/m), and the force amplitude behind it (N)."""

    rigidity: float
    half_width: float
    force_amplitude: float


def find_rigidity(signals: WheelSignals, course: Course, load: float) -> tuple[Rigidity | None, list[Finding]]:
    """Find the rigidity of a tyre under a static load (N); None without plate height or a hold at 25 Hz."""
    place = f"{signals.wheel}.tyre"
    if signals.height is None:
        return None, [warning(place, "no_rigidity_height")]
    turns = course.turns
    held = turns.frequency[course.hold]
    top = turns.top[course.hold]
    count = min(course.hold.stop - course.hold.start, 25)
    if count < _FEWEST_TURNS or abs(course.highest - RIGIDITY_FREQUENCY) > _TOLERANCE:
        return None, [warning(place, "no_rigidity_hold", count=count, frequency=float(np.median(held)))]
    begin, end = top[-count], top[-1]
    rate, start = signals.sample_rate, float(signals.time[0])
    cut = slice(max(round((begin - start) * rate), 0), round((end - start) * rate))
    time, height, force = signals.time[cut], signals.height[cut], signals.force[cut] - load
    wave = np.exp(-1j * turns.angle(time))
    amplitude = 2.0 * abs(complex(np.mean(force * wave)))
    stroke = 2.0 * abs(complex(np.mean((height - height.mean()) * wave)))
    rest = force - 2.0 * np.real(np.mean(force * wave) * np.conj(wave)) - force.mean()
    error = float(np.std(rest)) * np.sqrt(2.0 / force.size)
    return Rigidity(tyre_rigidity(amplitude, stroke), NORMAL_95 * RIGIDITY[0] * error / stroke, amplitude), []


def rigidity_findings(value: float, wheel: str, low: float, high: float) -> list[Finding]:
    """Say whether a rigidity (N/m) means a tyre inflated too little or too much, by limits in N/m."""
    place = f"{wheel}.tyre"
    if value < low:
        return [warning(place, "tyre_soft", value, rigidity=1e-3 * value, limit=1e-3 * low)]
    if value > high:
        return [warning(place, "tyre_stiff", value, rigidity=1e-3 * value, limit=1e-3 * high)]
    return []
