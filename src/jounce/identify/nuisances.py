"""What a record can be wrong about that a rig knows nothing of: the speed of a trial, a filter before the logger.

Left alone, the fitted values make up for it. Freed, it is found with them; what a fit leaves tells which one to free.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from jounce.core.errors import FitError, unknown
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.identify.fit_problem import FitTrial, Free
from jounce.recordings.sensors import Sensor, filter_signals
from jounce.recordings.signals import shift_signals

SPEED, LOW_PASS = "speed", ".low_pass"
FASTEST = 0.45
"""Share of the sample rate: corners above it cannot be told from none."""


@dataclass(frozen=True)
class Nuisance:
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
    free: Free

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
    given = {} if sensor is None else {name: getattr(sensor, name) for name in sensor.model_fields_set}
    return Sensor.model_validate({**given, "low_pass": corner})


def nuisances_of(given: Mapping[str, Any], trials: Sequence[FitTrial], where: str) -> tuple[Nuisance, ...]:
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
            found.append(Nuisance(name, Free(name, speeds[0], lower, upper)))
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
        found.append(Nuisance(name, Free(name, 0.5 * (1.0 / low + 1.0 / high), 1.0 / high, 1.0 / low)))
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


# what a fit leaves ----------------------------------------------------------------------------------------------------

_EXPLAINS = 0.35  # of what is left: what explains so much is told
ALIKE = 0.8  # of what one fault leaves: where another leaves more than that, they cannot be told apart
_CORNERS = 12
_SLIGHT = 0.003  # of the speed: smaller errors do no harm
_MATTERS = 1e-4  # of the energy of the records: less is not worth a word


@dataclass(frozen=True)
class Rest:
    """Weighted residuals of all trials at the optimum, and their derivatives by all that was fitted, a column each.

    ``readings`` are rows, weight, simulated reading, sample rate (Hz) of a channel in each trial, with whether a
    constant of it is free.
    """

    vector: Array
    jacobian: Array
    readings: Mapping[str, Sequence[tuple[slice, float, Array, float, bool]]]
    energy: float

    @property
    def size(self) -> float:
        """Sum of squares."""
        return float(self.vector @ self.vector)

    def after(self, changes: Sequence[tuple[slice, Array, Array]] = ()) -> float:
        """Sum of squares after one step of what was fitted, with other residuals and derivatives in some rows."""
        gram, pull, size = self._products
        gram, pull = gram.copy(), pull.copy()
        for rows, vector, jacobian in changes:
            touched = np.flatnonzero(self.jacobian[rows].any(axis=0))
            old, both = self.jacobian[rows][:, touched], np.ix_(touched, touched)
            gram[both] += jacobian.T @ jacobian - old.T @ old
            pull[touched] += jacobian.T @ vector - old.T @ self.vector[rows]
            size += float(vector @ vector) - float(self.vector[rows] @ self.vector[rows])
        return size - float(pull @ np.linalg.pinv(gram, rcond=1e-12, hermitian=True) @ pull)

    @cached_property
    def _products(self) -> tuple[Array, Array, float]:
        return self.jacobian.T @ self.jacobian, self.jacobian.T @ self.vector, self.size


def low_pass_in(rest: Rest, channel: str) -> tuple[float, Finding] | None:
    """The corner (Hz) of a low pass that would explain most of what is left of a channel, better than a delay does."""
    if rest.size < _MATTERS * rest.energy:
        return None
    rate = min(one[3] for one in rest.readings[channel])
    left = {corner: _filtered(rest, channel, corner) for corner in np.geomspace(0.01 * rate, 0.4 * rate, _CORNERS)}
    corner = min(left, key=lambda one: left[one])
    near = {one: _filtered(rest, channel, one) for one in corner * np.geomspace(0.75, 1.33, 7) if one < FASTEST * rate}
    corner = min({**left, **near}, key=lambda one: {**left, **near}[one])
    after = {**left, **near}[corner]
    share = 1.0 - after / rest.size
    late = {delay: _delayed(rest, channel, delay) for delay in np.linspace(0.0, 20.0, 11) / rate}
    delay = min(late, key=lambda one: late[one])
    if share < _EXPLAINS or late[delay] < ALIKE * after:
        return None
    alike = "" if after < ALIKE * late[delay] else f" (a delay of {1e3 * delay:.2g} ms explains about as much)"
    text = (
        f"the record looks like the updated model's behind a low pass of about {corner:.3g} Hz, which explains "
        f"{100.0 * share:.0f} % of what is left{alike}: state low_pass of its sensor, or find it with the values, "
        f'nuisances = {{"{channel}{LOW_PASS}" = ["{0.5 * corner:.0f} Hz", "{2.0 * corner:.0f} Hz"]}}'
    )
    return share, Finding(channel, "warning", text, float(corner))


def late_share(rest: Rest) -> float:
    """Share of what is left that one delay of all records explains: a clock is likelier than what explains no more."""
    rate = min(one[3] for channel in rest.readings.values() for one in channel)

    def left(samples: float) -> float:
        return _changed(rest, rest.readings, lambda table, rate_of: shift_signals(table, rate_of, samples / rate))

    coarse = {float(one): left(float(one)) for one in range(-10, 21, 2)}
    best = min(coarse, key=lambda one: coarse[one])
    near = [left(best + part) for part in (-1.5, -1.0, -0.5, 0.5, 1.0, 1.5)]
    return 1.0 - min(coarse[best], *near) / rest.size


def _changed(rest: Rest, channels: Iterable[str], change: Any) -> float:
    """What is left when the readings of channels are changed by a linear map, after a step of what was fitted."""
    changes = []
    for rows, weight, reading, rate, is_free in (one for channel in channels for one in rest.readings[channel]):
        own = rest.jacobian[rows]
        both = change(np.column_stack([reading, own[:, own.any(axis=0)]]), rate)
        moved = weight * (reading - both[:, 0])
        changes.append((rows, rest.vector[rows] + moved - (moved.mean() if is_free else 0.0), both[:, 1:]))
    return rest.after(changes)


def _filtered(rest: Rest, channel: str, corner: float) -> float:
    sensor = Sensor(low_pass=float(corner))
    return _changed(rest, [channel], lambda table, rate: filter_signals(table, rate, sensor))


def _delayed(rest: Rest, channel: str, delay: float) -> float:
    return _changed(rest, [channel], lambda table, rate: shift_signals(table, rate, delay))


def speed_in(rest: Rest, slope: Array) -> tuple[float, Finding] | None:
    """The error of the speed that would explain most of what is left; ``slope`` is that by its logarithm."""
    if rest.size < _MATTERS * rest.energy:
        return None
    whole = np.column_stack([rest.jacobian, slope])
    step = np.linalg.lstsq(whole, rest.vector, rcond=1e-10)[0]
    left = rest.vector - whole @ step
    share = 1.0 - float(left @ left) / rest.size
    error = -float(step[-1])
    if share < _EXPLAINS or abs(error) < _SLIGHT:
        return None
    text = (
        f"a speed that is {100.0 * error:+.2g} % from the stated one would explain {100.0 * share:.0f} % of what is "
        'left: measure it, or find it with the values, nuisances = {"speed" = "5 %"}; the '
        "fitted values make up for it as far as they can"
    )
    return share, Finding(SPEED, "warning", text, error)
