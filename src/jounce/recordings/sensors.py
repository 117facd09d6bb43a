"""Effect of the measuring chain on a signal, for a fair comparison of simulations with records."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Annotated, Literal, Self

import numpy as np
from numpy.typing import ArrayLike
from pydantic import Field, model_validator

from jounce.core.description import Description, Whole
from jounce.core.errors import as_found, show_value
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.core.types import Array
from jounce.core.units import Frequency, Number, Unit, as_number, to_si
from jounce.recordings.schema import channel_unit
from jounce.recordings.signals import check_frequency

Initial = Literal["steady", "zero"]
Datum = Literal["rest", "undeformed", "free offset"]
Order = Annotated[Whole, Field(ge=1, le=8)]
_LONGEST_VALUE = 200  # characters: a regular expression shall not search long texts
_LEADING_NUMBER = re.compile(r"\s*[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?(?![\d.])")


@dataclass(frozen=True)
class ChannelUnit(Unit):
    """Annotation of a value in the unit of its channel: kept as written until the channel is known."""

    si: str = "the channel's SI unit"

    def _read(self, value: object) -> float | str:  # type: ignore[override]  # text stays text
        text = value if isinstance(value, str) else show_value(value)
        match = _LEADING_NUMBER.match(text) if len(text) < _LONGEST_VALUE else None
        if isinstance(value, bool) or not isinstance(value, (int, float, str)) or match is None:
            allowed = "'<number> <unit of the channel>' or a number in SI"
            raise error_at((), "invalid physical value", found=as_found(value), allowed=allowed)
        if self.at_least is not None and float(match[0]) < self.at_least:
            allowed = Phrase("at least {bound:g}", bound=self.at_least)
            raise error_at((), "out of range", found=as_found(value), allowed=allowed)
        return value


class Sensor(Description):
    """A sensor with its conditioner: the record is a filtered, scaled, noisy image of the motion.

    The chain is: zero (``datum``), ``orientation * gain``, AC coupling, band limit; then ``bias`` and ``noise`` are
    added.

    Attributes
    ----------
    high_pass : float or None
        Corner of the AC coupling of a piezo conditioner, Hz (-3 dB); None: coupled down to 0 Hz.
    low_pass : float or None
        Corner of the band limit, Hz (-3 dB): a causal Butterworth filter; of the second order it delays by about
        ``0.225 / low_pass`` s. None: no limit.
    high_pass_order, low_pass_order : int
        Orders of both filters, 1 to 8: a conditioner's AC coupling is of the first, an anti-alias filter often of the
        fourth to eighth.
    bias : float or str
        Constant added to the record, in the channel's unit, e.g. ``"0.2 m/s^2"``.
    noise : float or str
        Standard deviation of white noise added to every sample, in the channel's unit; only if a seed is given.
    gain : float
        Ratio of the recorded to the true value, 1 by default.
    gain_doubt : float or None
        Relative standard uncertainty (1) of the gain, from its calibration. None: the value of `Doubt` for all sensors.
    orientation : {1, -1}
        -1 for a sensor mounted upside down.
    column : str
        Column in the files, with a unit if the files give none, e.g. ``"ch0 [V]"``.
    sensitivity : str or tuple of str
        Sensitivity, if files contain volts or counts: ``"100 mV/g"``, ``"5 V / 50 mm"``, or a chain from the sensor to
        the card, ``["10 pC/(m/s^2)", "1 mV/pC"]``.
    zero : str
        Recorded value for a quantity of 0, e.g. ``"2.5 V"``.
    range : str
        Maximum absolute value of the quantity (``"50 g"``) or of the card (``"10 V"``); beyond it, record and model are
        clipped.
    datum : {"rest", "undeformed", "free offset"} or None
        Zero of the record: at rest before the run (a displacement sensor or load cell that was zeroed), the zero of
        the model (undeformed springs, design position, no force), or arbitrary, so that a constant is fitted with the
        parameters. None: determined from the quiet start of the recording.

    Examples
    --------
    >>> Sensor(high_pass="0.5 Hz", noise="0.05 g").high_pass
    0.5
    """

    high_pass: Frequency | None = None
    low_pass: Frequency | None = None
    bias: Annotated[float | str, ChannelUnit()] = 0.0
    noise: Annotated[float | str, ChannelUnit(at_least=0.0)] = 0.0
    gain: Number = 1.0
    gain_doubt: Annotated[float, Unit("1", at_least=0.0)] | None = None
    orientation: Literal[1, -1] = 1
    datum: Datum | None = None
    column: str = ""
    sensitivity: str | tuple[str, ...] = ""
    zero: str = ""
    range: str = ""
    high_pass_order: Order = 1
    low_pass_order: Order = 2

    @model_validator(mode="after")
    def _is_possible(self) -> Self:
        if self.gain == 0.0:
            raise error_at((), "a gain of 0 removes the signal", allowed="any other number")
        if (
            self.high_pass is not None
            and self.low_pass is not None
            and self.high_pass >= self.low_pass
        ):
            text = "high_pass ({high_pass:g} Hz) is not below low_pass ({low_pass:g} Hz)"
            raise ValueError(Phrase(text, high_pass=self.high_pass, low_pass=self.low_pass))
        return self

    @property
    def is_ideal(self) -> bool:
        """Whether the record is the motion itself, apart from noise."""
        acquired = {name: getattr(self, name) for name in _ACQUIRED}
        return self == Sensor(noise=self.noise, **acquired)


_ACQUIRED = ("column", "sensitivity", "zero", "gain_doubt")
"""Fields that affect how a file is read, but not the effect of the chain on a signal."""


def sections_of(sensor: Sensor, sample_rate: float, *, where: str = "sensor") -> Array:
    """Return the sensor's filters as second-order sections ``b0 b1 b2 a0 a1 a2``, shape (n, 6), without gain.

    The high pass is a bilinear transform, exact at its corner. The low pass has the poles of the analogue filter, its
    delay at low frequency, and -3 dB at its corner: a bilinear transform would be early by 7 % of the delay at 0.15 of
    the rate, an error that a fit would compensate. Corners must lie below half the ``sample_rate`` (Hz).
    """
    sections = []
    if sensor.high_pass is not None:
        check_frequency(sensor.high_pass, sample_rate, where=f"{where}: high_pass")
        w = math.tan(math.pi * sensor.high_pass / sample_rate)
        sections += [_high_pass(w, angle) for angle in _pole_angles(sensor.high_pass_order)]
    if sensor.low_pass is not None:
        check_frequency(sensor.low_pass, sample_rate, where=f"{where}: low_pass")
        corner = 2.0 * math.pi * sensor.low_pass / sample_rate
        sections += [_low_pass(corner, angle) for angle in _pole_angles(sensor.low_pass_order)]
    return np.array(sections, dtype=float).reshape(-1, 6)


def _pole_angles(order: int) -> list[float]:
    """Angles (rad) of the pole pairs of a Butterworth filter from the real axis; 0 for a single real pole."""
    half = math.pi / (2.0 * order)
    return [half * k for k in range(1 - order % 2, order, 2)]


def _high_pass(w: float, angle: float) -> list[float]:
    """One pole, or one pair, of a Butterworth high pass by bilinear transform; ``w`` is the prewarped corner."""
    if angle == 0.0:
        return [1.0 / (1.0 + w), -1.0 / (1.0 + w), 0.0, 1.0, -(1.0 - w) / (1.0 + w), 0.0]
    damped = 2.0 * math.cos(angle) * w
    scale = 1.0 + damped + w * w
    return [
        1.0 / scale,
        -2.0 / scale,
        1.0 / scale,
        1.0,
        2.0 * (w * w - 1.0) / scale,
        (1.0 - damped + w * w) / scale,
    ]


def _low_pass(corner: float, angle: float) -> list[float]:
    """One pole, or one pair, of a Butterworth low pass as a section; the corner in radians a sample."""
    damped = 2.0 * math.cos(angle)
    if angle == 0.0:  # s + 1: delay at rest in 1/corner, and gain at the corner
        a1, a2, lag, gain = -math.exp(-corner), 0.0, 1.0, math.sqrt(0.5)
    else:  # s^2 + damped s + 1
        decay = math.exp(-0.5 * damped * corner)
        a1, a2, lag, gain = (
            -2.0 * decay * math.cos(math.sin(angle) * corner),
            decay**2,
            damped,
            1.0 / damped,
        )
    if angle and corner < _SLOW:
        w = math.tan(0.5 * corner)
        scale = 1.0 + damped * w + w * w
        b = w * w / scale
        return [b, 2.0 * b, b, 1.0, 2.0 * (w * w - 1.0) / scale, (1.0 - damped * w + w * w) / scale]
    level = 1.0 + a1 + a2  # sum of b: a gain of 1 at rest
    late = level * lag / corner + a1 + 2.0 * a2  # b1 + 2 b2: the delay at rest
    turn = cmath.exp(-1j * corner)
    line, bend = (
        level - late + late * turn,
        (1.0 - turn) ** 2,
    )  # b = (level - late, late, 0) + more (1, -2, 1)
    half = (line * bend.conjugate()).real / abs(bend) ** 2
    wanted = (abs(gain * (1.0 + a1 * turn + a2 * turn**2)) ** 2 - abs(line) ** 2) / abs(bend) ** 2
    root = math.sqrt(max(half * half + wanted, 0.0))
    more = min(-half - root, -half + root, key=abs)
    return [level - late + more, late - 2.0 * more, more, 1.0, a1, a2]


_SLOW = 0.03  # radians per sample, below which the delay of the bilinear transform errs by less than 1e-4


def filter_signals(
    values: ArrayLike,
    sample_rate: float,
    sensor: Sensor,
    *,
    initial: Initial = "steady",
    where: str = "sensor",
) -> Array:
    """Apply the linear part of a sensor to signals: orientation, gain and filters, without bias and noise.

    Linear in ``values``: the same call turns a motion into its record, and derivatives of the motion by parameters
    into those of the record.

    Parameters
    ----------
    values : array_like, shape (n,) or (n, k)
        Signals, or derivatives of signals, in SI or any other unit, at a constant rate, samples along the first axis.
    sample_rate : float
        Samples per second in Hz.
    sensor : Sensor
        Description of the chain.
    initial : {"steady", "zero"}
        ``"steady"``: the first sample has been constant before the record, so a signal at rest starts without a
        transient; ``"zero"``: the signal was zero.
    where : str
        Channel named in errors.

    Returns
    -------
    ndarray, shape of ``values``
        Filtered signals in the same unit.

    Raises
    ------
    RecordingError
        If a corner frequency is not below half the sample rate.

    Examples
    --------
    >>> filter_signals([1.0, 1.0, 2.0], 1000.0, Sensor(gain=2.0, orientation=-1)).tolist()
    [-2.0, -2.0, -4.0]
    >>> filter_signals([1.0, 1.0, 1.0], 1000.0, Sensor(high_pass="1 Hz")).tolist()
    [0.0, 0.0, 0.0]
    """
    signals = np.atleast_1d(as_samples(values, where=where)) * (sensor.gain * sensor.orientation)
    sections = sections_of(sensor, as_number(sample_rate, "Hz", where=where), where=where)
    if len(sections) == 0:
        return signals
    from scipy import signal

    if signals.shape[0] == 0:
        return signals
    shape = (len(sections), 2) + (1,) * (signals.ndim - 1)
    state = np.zeros((len(sections), 2, *signals.shape[1:]))
    if initial == "steady":
        state = state + _steady_state(sections).reshape(shape) * signals[0]
    return np.asarray(signal.sosfilt(sections, signals, axis=0, zi=state)[0], dtype=float)


def _steady_state(sections: Array) -> Array:
    """States of the sections for a constant input of 1, in transposed direct form II; shape (sections, 2)."""
    states, level = np.zeros((len(sections), 2)), 1.0
    for index, (b0, b1, b2, _, a1, a2) in enumerate(sections.tolist()):
        settled = level * (b0 + b1 + b2) / (1.0 + a1 + a2)
        states[index] = settled - b0 * level, b2 * level - a2 * settled
        level = settled
    return states


def bias_of(sensor: Sensor, unit: str, *, where: str = "bias") -> float:
    """Return the sensor's bias in the channel's SI ``unit``; it does not depend on model parameters."""
    return to_si(sensor.bias, unit, where=where)


def noise_of(sensor: Sensor, unit: str, *, where: str = "noise") -> float:
    """Return the standard deviation of the sensor's noise in the channel's SI ``unit``."""
    return to_si(sensor.noise, unit, where=where)


def check_sensors(sensors: Mapping[str, Sensor], where: str) -> None:
    """Refuse sensor values in a unit that does not fit the channel, before anything is computed."""
    for name, sensor in sensors.items():
        unit = channel_unit(name)
        bias_of(sensor, unit, where=f"{where}: {name}.bias")
        noise_of(sensor, unit, where=f"{where}: {name}.noise")
