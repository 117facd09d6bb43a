"""BOGE: greatest movement of a sprung plate while the exciter runs down through the resonance of the wheel."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from jounce.core.constants import NORMAL_95
from jounce.core.types import Array
from jounce.inspection.signals.conditioning import WheelSignals
from jounce.inspection.signals.turns import Turns

LOWEST_RESONANCE = 2.0  # Hz; below it is the body's


@dataclass(frozen=True)
class BogeAmplitude:
    """Greatest movement of the plate from lowest to highest point (m), its half width of 95 % (m), and where (Hz)."""

    amplitude: float
    half_width: float
    frequency_hz: float


def stroke_by_turn(height: Array, time: Array, turns: Turns) -> Array:
    """Highest less lowest height (m) of each turn, by the upward crossings; height (n,) in m on time (n,) in s."""
    starts = np.searchsorted(time, turns.crossing[::2])
    starts = np.minimum(starts, height.size - 1)
    count = turns.top.size
    if starts.size <= count:
        starts = np.append(starts, height.size - 1)
    starts = starts[: count + 1]
    high, low = np.maximum.reduceat(height, starts)[:count], np.minimum.reduceat(height, starts)[:count]
    return np.asarray(high - low)


def find_boge(signals: WheelSignals, turns: Turns) -> BogeAmplitude | None:
    """Find the greatest movement of a plate; None without its height."""
    if signals.height is None:
        return None
    stroke = stroke_by_turn(signals.height, signals.time, turns)
    at = int(np.argmax(np.where(turns.frequency > LOWEST_RESONANCE, stroke, 0.0)))
    third = np.diff(signals.height, 3)
    noise = float(np.median(np.abs(third))) / (0.6745 * np.sqrt(20.0))
    return BogeAmplitude(float(stroke[at]), NORMAL_95 * noise * np.sqrt(2.0), float(turns.frequency[at]))
