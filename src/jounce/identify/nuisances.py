"""What a record can be wrong about that a rig knows nothing of: the speed of a trial, a filter before the logger.

Left alone, the fitted values make up for it. Freed, it is found with them; what a fit leaves tells which one to free.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from jounce.core.errors import FitError, unknown
from jounce.core.units import to_si
from jounce.identify.fit_problem import FitTrial, FreeParameter
from jounce.recordings.sensors import Sensor

SPEED, LOW_PASS = "speed", ".low_pass"
FASTEST = 0.45
"""Share of the sample rate: corners above it cannot be told from none."""


@dataclass(frozen=True)
class SearchedNuisance:
    """One unknown of trials or sensors.

    Attributes
    ----------
    name : str
        ``"speed"`` (m/s, one common factor for all trials that are driven over a road) or ``"<channel>.low_pass"``
        (corner in Hz).
    free : Free
        Start and bounds of what is searched: the speed in m/s, or one over the corner in s, in which a delay is linear.
    """

    name: str
    free: FreeParameter

    @property
    def unit(self) -> str:
        """SI unit of the value that is told."""
        return "m/s" if self.name == SPEED else "Hz"

    @property
    def width(self) -> float:
        """How far its bounds let it be off (1): a share of the speed, the logarithm of a corner."""
        free = self.free
        return free.half_range / free.initial if self.name == SPEED else 0.5 * math.log(free.upper / free.lower)

    def told(self, found: float) -> float:
        """The value in its unit: what is searched, or one over it."""
        return found if self.name == SPEED else 1.0 / found

    def applied(self, trial: FitTrial, found: float) -> FitTrial:
        """The trial with this value."""
        if self.name == SPEED:
            return replace(trial, trial=trial.trial.at_speed(found / self.free.initial))
        channel = self.name.removesuffix(LOW_PASS)
        sensor = with_low_pass(trial.sensors.get(channel), 1.0 / found)
        return replace(trial, sensors={**trial.sensors, channel: sensor})


def with_low_pass(sensor: Sensor | None, corner: float) -> Sensor:
    """The sensor with a low pass of this corner (Hz)."""
    return (sensor or Sensor()).changed(low_pass=corner)


def nuisances_of(given: Mapping[str, Any], trials: Sequence[FitTrial], where: str) -> tuple[SearchedNuisance, ...]:
    """Read the nuisances and their bounds: a share of the stated speed, or two corners in Hz.

    Corners start in the middle of their bounds until a better start is known.
    """
    channels = [str(name) for name in trials[0].measured.data_vars]
    rate = min(1.0 / float(np.median(np.diff(trial.measured["time"].to_numpy()))) for trial in trials)
    found = []
    for name, bounds in given.items():
        place = f"{where}: {name}"
        if name == SPEED:
            speeds = [trial.trial.speed for trial in trials if trial.trial.speed is not None]
            if not speeds:
                raise FitError("no trial has a speed", where=place, hint="Leave it out.")
            lower, upper = _speeds(bounds, speeds[0], place)
            found.append(SearchedNuisance(name, FreeParameter(name, speeds[0], lower, upper)))
            continue
        channel = name.removesuffix(LOW_PASS)
        if not name.endswith(LOW_PASS) or channel not in channels:
            raise unknown(name, [SPEED, *(f"{one}{LOW_PASS}" for one in channels)], what="nuisance", where=where)
        if not isinstance(bounds, Sequence) or isinstance(bounds, str) or len(bounds) != 2:
            raise FitError("not a pair of bounds", where=place, found=bounds, allowed='["20 Hz", "400 Hz"]')
        low, high = (to_si(value, "Hz", where=place) for value in bounds)
        high = min(high, FASTEST * rate)
        if not 0.0 < low < high:
            allowed = f"two corners, the lower above 0 and below {FASTEST * rate:g} Hz, {FASTEST:g} of the sample rate"
            raise FitError("no corners between the bounds", where=place, found=list(bounds), allowed=allowed)
        found.append(SearchedNuisance(name, FreeParameter(name, 0.5 * (1.0 / low + 1.0 / high), 1.0 / high, 1.0 / low)))
    return tuple(found)


def _speeds(bounds: Any, speed: float, place: str) -> tuple[float, float]:
    """Lower and upper speed in m/s."""
    if isinstance(bounds, str | int | float):
        share = to_si(bounds, "1", where=place)
        if not 0.0 < share < 1.0:
            raise FitError("not a share of the speed", where=place, found=bounds, allowed='e.g. "5 %"')
        return speed * (1.0 - share), speed * (1.0 + share)
    if not isinstance(bounds, Sequence) or len(bounds) != 2:
        raise FitError("not a range of speeds", where=place, found=bounds, allowed='"5 %" or [lower, upper]')
    lower, upper = (to_si(value, "m/s", where=place) for value in bounds)
    if not 0.0 < lower < speed < upper:
        raise FitError("the bounds exclude the speed", where=place, found=list(bounds), allowed=f"around {speed:g} m/s")
    return lower, upper
