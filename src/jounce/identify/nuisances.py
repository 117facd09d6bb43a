"""Nuisances of a record outside the rig: speed, a filter before the logger, motion at its start.

If they are ignored, the fitted values compensate for them. Free nuisances are estimated with the parameters; the
residuals of a fit show which one to free.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from jounce.core.errors import FitError, unknown
from jounce.core.phrases import Phrase
from jounce.core.units import to_si
from jounce.identify.fit_problem import FitTrial, FreeParameter
from jounce.recordings.sensors import Sensor
from jounce.simulation.compiled import compile_rig
from jounce.simulation.free_motion import FreeVibration, free_motions
from jounce.simulation.problem import excitation, force_actuator

SPEED, LOW_PASS, START = "speed", ".low_pass", "start"
FASTEST = 0.45
"""Share of the sample rate above which a corner has no detectable effect."""


@dataclass(frozen=True)
class SearchedNuisance:
    """One unknown of trials or sensors.

    Attributes
    ----------
    name : str
        ``"speed"`` (m/s, one common factor for all trials that are driven over a road) or ``"<channel>.low_pass"``
        (corner in Hz).
    free : Free
        Start and bounds of the searched variable: the speed in m/s, or the inverse of the corner in s, in which the
        delay is linear.
    """

    name: str
    free: FreeParameter

    @property
    def unit(self) -> str:
        """SI unit of the reported value."""
        return "m/s" if self.name == SPEED else "Hz"

    @property
    def width(self) -> float:
        """Deviation allowed by the bounds (1): relative for the speed, logarithmic for a corner."""
        free = self.free
        return (
            free.half_range / free.initial
            if self.name == SPEED
            else 0.5 * math.log(free.upper / free.lower)
        )

    @property
    def is_inverse(self) -> bool:
        """Whether the search variable is the inverse of the value."""
        return self.name != SPEED

    def concerns(self, _trial: FitTrial) -> bool:
        """Always true: it affects every trial."""
        return True

    def apply_to(self, trial: FitTrial, value: float) -> FitTrial:
        """The trial with this value."""
        if self.name == SPEED:
            return replace(trial, trial=trial.trial.at_speed(value / self.free.initial))
        channel = self.name.removesuffix(LOW_PASS)
        sensor = with_low_pass(trial.sensors.get(channel), 1.0 / value)
        return replace(trial, sensors={**trial.sensors, channel: sensor})


@dataclass(frozen=True)
class SearchedStart:
    """Amplitude (m) of one natural vibration at the start of one trial's record.

    Attributes
    ----------
    name : str
        E.g. ``"trial 3: start, 5.05 Hz displaced"``.
    trial : str
        Name of the trial.
    shape : mapping of str to float
        Mapping from state to its value for an amplitude of 1 m, SI.
    free : FreeParameter
        Start (0) and bounds, m.
    unit : str
        SI unit of the amplitude.
    is_inverse : bool
        Whether the search variable is the inverse of the value: always false.
    """

    name: str
    trial: str
    shape: Mapping[str, float]
    free: FreeParameter
    unit: str = "m"
    is_inverse: bool = False

    @property
    def width(self) -> float:
        """Half the range of the bounds, m."""
        return self.free.half_range

    def concerns(self, trial: FitTrial) -> bool:
        """Whether it is the trial of this start."""
        return trial.name == self.trial

    def apply_to(self, trial: FitTrial, amplitude: float) -> FitTrial:
        """Return the trial started at this distance from equilibrium."""
        if not self.concerns(trial):
            return trial
        offset = {
            state: trial.offset.get(state, 0.0) + amplitude * value
            for state, value in self.shape.items()
        }
        return replace(trial, offset=offset)


def begins_unknown(trial: FitTrial) -> bool:
    """Whether unknown motion before the record can affect it; previous loops of a belt are simulated."""
    return float(trial.measured["time"][0]) <= _AT_ONCE


_AT_ONCE = 0.05
"""Simulated time before a record, in s, above which motion at the start of the run no longer matters."""


def start_motions(trial: FitTrial) -> list[FreeVibration]:
    """Return the natural vibrations of a trial's rig about its equilibrium at the start of the road."""
    compiled = compile_rig(trial.rig, actuator=force_actuator(trial.trial))
    signals = excitation(compiled.facts, trial.rig, trial.trial)
    heights = [float(signal.evaluate(np.zeros(1))[0][0]) for signal in signals]
    still = compiled.inputs(dict(zip(compiled.facts.tracks, heights, strict=True)))
    return free_motions(compiled, compiled.parameter_values(trial.rig.parameters()), still)


def _starts_of(given: Any, trials: Sequence[FitTrial], place: str) -> list[SearchedStart]:
    """Return the start amplitudes of each trial's vibrations, bounded by plus and minus the given length (m)."""
    largest = to_si(given, "m", where=place)
    if largest <= 0.0:
        raise FitError(
            "invalid amplitude",
            where=place,
            found=given,
            allowed='a length above zero, e.g. "2 mm"',
        )
    starts = []
    for trial in filter(begins_unknown, trials):
        for motion in start_motions(trial):
            for way, shape in (("displaced", motion.displaced), ("moving", motion.moving)):
                name = f"{trial.name}: {START}, {motion.frequency:.3g} Hz {way}"
                starts.append(
                    SearchedStart(
                        name, trial.name, shape, FreeParameter(name, 0.0, -largest, largest)
                    )
                )
    if not starts:
        raise FitError(
            "no trial has a start that could be estimated",
            where=place,
            found="running belts, or rigs that do not oscillate",
            hint="Leave it out.",
        )
    return starts


def with_low_pass(sensor: Sensor | None, corner: float) -> Sensor:
    """Return the sensor with a low-pass filter at this corner (Hz)."""
    return (sensor or Sensor()).with_fields(low_pass=corner)


def nuisances_of(
    given: Mapping[str, Any], trials: Sequence[FitTrial], where: str
) -> tuple[SearchedNuisance | SearchedStart, ...]:
    """Read the nuisances and their bounds: a share of the stated speed, two corners in Hz, or a maximum amplitude.

    Corners start in the middle of their bounds unless a better start is known.
    """
    channels = [str(name) for name in trials[0].measured.data_vars]
    rate = min(
        1.0 / float(np.median(np.diff(trial.measured["time"].to_numpy()))) for trial in trials
    )
    nuisances: list[SearchedNuisance | SearchedStart] = []
    for name, bounds in given.items():
        place = f"{where}: {name}"
        if name == START:
            nuisances += _starts_of(bounds, trials, place)
            continue
        if name == SPEED:
            speeds = [trial.trial.speed for trial in trials if trial.trial.speed is not None]
            if not speeds:
                raise FitError("no trial has a speed", where=place, hint="Leave it out.")
            lower, upper = _speeds(bounds, speeds[0], place)
            nuisances.append(SearchedNuisance(name, FreeParameter(name, speeds[0], lower, upper)))
            continue
        channel = name.removesuffix(LOW_PASS)
        if not name.endswith(LOW_PASS) or channel not in channels:
            raise unknown(
                name,
                [SPEED, START, *(f"{known}{LOW_PASS}" for known in channels)],
                what="nuisance",
                where=where,
            )
        if not isinstance(bounds, Sequence) or isinstance(bounds, str) or len(bounds) != 2:
            raise FitError(
                "invalid pair of bounds", where=place, found=bounds, allowed='["20 Hz", "400 Hz"]'
            )
        low, high = (to_si(value, "Hz", where=place) for value in bounds)
        high = min(high, FASTEST * rate)
        if not 0.0 < low < high:
            allowed = Phrase(
                "two corners, the lower above 0 and below {fastest:g} Hz, {second_fastest:g} of the sample rate",
                fastest=FASTEST * rate,
                second_fastest=FASTEST,
            )
            raise FitError(
                "no corner frequencies between the bounds",
                where=place,
                found=list(bounds),
                allowed=allowed,
            )
        nuisances.append(
            SearchedNuisance(
                name, FreeParameter(name, 0.5 * (1.0 / low + 1.0 / high), 1.0 / high, 1.0 / low)
            )
        )
    return tuple(nuisances)


def _speeds(bounds: Any, speed: float, place: str) -> tuple[float, float]:
    """Return the lower and upper speed in m/s."""
    if isinstance(bounds, str | int | float):
        share = to_si(bounds, "1", where=place)
        if not 0.0 < share < 1.0:
            raise FitError(
                "invalid share of the speed", where=place, found=bounds, allowed='e.g. "5 %"'
            )
        return speed * (1.0 - share), speed * (1.0 + share)
    if not isinstance(bounds, Sequence) or len(bounds) != 2:
        raise FitError(
            "invalid range of speeds", where=place, found=bounds, allowed='"5 %" or [lower, upper]'
        )
    lower, upper = (to_si(value, "m/s", where=place) for value in bounds)
    if not 0.0 < lower < speed < upper:
        raise FitError(
            "the bounds exclude the speed",
            where=place,
            found=list(bounds),
            allowed=Phrase("around {speed:g} m/s", speed=speed),
        )
    return lower, upper
