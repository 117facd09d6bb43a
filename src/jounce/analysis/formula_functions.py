"""Functions of formulas: of each sample, of all samples, and over time."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from jounce.analysis.formula_units import (
    ANGLE,
    HERTZ,
    PLAIN,
    SECOND,
    Powers,
    Signal,
    alike,
    multiplied,
    unit_name,
    without_angle,
)
from jounce.analysis.record import refuse_gaps
from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.phrases import Phrase
from jounce.core.types import Array

_EVEN = 1e-3  # of a step: larger differences of steps need resampling before a filter


@dataclass(frozen=True)
class Timeline:
    """Instants (s) of the samples of a recording, and its name for messages."""

    time: Array
    where: str

    def samples(self, signal: Signal) -> Array:
        """Return a value as samples."""
        return np.array(np.broadcast_to(signal.values, self.time.shape), dtype=float)

    def rate(self, what: str) -> float:
        """Return the sample rate (Hz); refuse time with gaps or uneven steps."""
        steps = np.diff(self.time)
        mean = float(self.time[-1] - self.time[0]) / max(1, steps.size)
        if not steps.size or float(np.abs(steps - mean).max()) > _EVEN * mean:
            raise RecordingError(
                "time is not uniform",
                where=f"{self.where}: {what}",
                hint="Read the file with resample, or bring the recording onto constant steps.",
            )
        return 1.0 / mean

    def number(self, signal: Signal, powers: Powers, unit: str) -> float:
        """Return an argument that must be one number of a unit."""
        if not signal.is_number or signal.powers != powers:
            raise DescriptionError(
                "not a value of this argument",
                where="formula",
                found=f"{signal.text} [{unit_name(signal.powers)}]",
                allowed=Phrase("a number in {unit}, in quotes", unit=unit),
            )
        return float(signal.values)


@dataclass(frozen=True)
class Function:
    """A function of formulas: how it is written, the number of its arguments, and its work."""

    form: str
    fewest: int
    most: int
    work: Callable[..., Signal]


def _of_plain(function: Callable[[Any], Any], result: Powers, angle: bool = False) -> Any:
    def work(_: Timeline, x: Signal) -> Signal:
        if without_angle(x.powers) or (x.powers and not angle):
            raise DescriptionError(
                "units do not fit",
                where=x.text,
                found=unit_name(x.powers),
                allowed="an angle or a plain number" if angle else "a plain number",
            )
        return Signal(function(np.asarray(x.values, float)), result, "")

    return work


def _same(function: Callable[[Any], Any]) -> Any:
    return lambda _, x: Signal(function(x.values), x.powers, "")


def _root(_: Timeline, x: Signal) -> Signal:
    powers = tuple((name, 0.5 * power) for name, power in x.powers)
    return Signal(np.sqrt(np.asarray(x.values, float)), powers, "")


def _sign(_: Timeline, x: Signal) -> Signal:
    return Signal(np.sign(x.values), PLAIN, "")


def _angle_of(_: Timeline, y: Signal, x: Signal) -> Signal:
    y, x = alike(y, x, "atan2")
    return Signal(np.arctan2(y.values, x.values), ANGLE, "")


def _extreme(function: Callable[[Any, Any], Any], _: Timeline, *given: Signal) -> Signal:
    first, *others = given
    for other in others:
        left, right = alike(first, other, "and")
        first = Signal(function(left.values, right.values), left.powers, left.text)
    return first


def _clip(timeline: Timeline, x: Signal, low: Signal, high: Signal) -> Signal:
    least, most = _extreme(np.maximum, timeline, x, low), high
    return _extreme(np.minimum, timeline, least, most)


def _where(_: Timeline, condition: Signal, yes: Signal, no: Signal) -> Signal:
    yes, no = alike(yes, no, "and")
    chosen = np.where(np.asarray(condition.values) > 0.0, yes.values, no.values)
    return Signal(np.where(np.isnan(condition.values), np.nan, chosen), yes.powers, "")


def _of_all(function: Callable[[Array], Any], timeline: Timeline, x: Signal) -> Signal:
    values = timeline.samples(x)
    values = values[np.isfinite(values)]
    if not values.size:
        raise RecordingError("the channel has no value", where=f"{timeline.where}: {x.text}")
    return Signal(float(function(values)), x.powers, "")


def _derivative(timeline: Timeline, x: Signal) -> Signal:
    values = timeline.samples(x)
    if values.size < 3:
        raise RecordingError("the signal is too short to differentiate", where=x.text)
    slope = np.gradient(values, timeline.time, edge_order=2)
    return Signal(slope, multiplied(x.powers, SECOND, -1.0), "")


def _integral(timeline: Timeline, x: Signal) -> Signal:
    from scipy.integrate import cumulative_trapezoid

    values = timeline.samples(x)
    refuse_gaps(timeline.time, values, where=f"{timeline.where}: {x.text}")
    area = cumulative_trapezoid(values, timeline.time, initial=0.0)
    return Signal(area, multiplied(x.powers, SECOND), "")


def _filtered(timeline: Timeline, x: Signal, above: Signal | None, below: Signal | None) -> Signal:
    from jounce.recordings.signals import band_limit

    values = timeline.samples(x)
    refuse_gaps(timeline.time, values, where=f"{timeline.where}: {x.text}")
    low, high = (
        None if corner is None else timeline.number(corner, HERTZ, "Hz")
        for corner in (above, below)
    )
    return Signal(band_limit(values, timeline.rate(x.text), above=low, below=high), x.powers, "")


def _low(timeline: Timeline, x: Signal, corner: Signal) -> Signal:
    return _filtered(timeline, x, None, corner)


def _high(timeline: Timeline, x: Signal, corner: Signal) -> Signal:
    return _filtered(timeline, x, corner, None)


def _smooth(timeline: Timeline, x: Signal, span: Signal) -> Signal:
    from scipy.ndimage import uniform_filter1d

    values = timeline.samples(x)
    refuse_gaps(timeline.time, values, where=f"{timeline.where}: {x.text}")
    count = round(timeline.number(span, SECOND, "s") * timeline.rate(x.text)) // 2 * 2 + 1
    if not 1 <= count <= values.size:
        raise DescriptionError(
            "the span does not fit the record",
            where=x.text,
            found=span.text,
            allowed=Phrase("up to {span:g} s", span=float(timeline.time[-1] - timeline.time[0])),
        )
    return Signal(uniform_filter1d(values, count, mode="nearest"), x.powers, "")


def _delay(timeline: Timeline, x: Signal, lag: Signal) -> Signal:
    values, time = timeline.samples(x), timeline.time
    wanted = time - timeline.number(lag, SECOND, "s")
    return Signal(np.interp(wanted, time, values, left=np.nan, right=np.nan), x.powers, "")


def _detrend(timeline: Timeline, x: Signal) -> Signal:
    values, time = timeline.samples(x), timeline.time
    refuse_gaps(timeline.time, values, where=f"{timeline.where}: {x.text}")
    if values.size < 2:
        return Signal(values - values.mean(), x.powers, "")
    slope, level = np.polyfit(time - time.mean(), values, 1)
    return Signal(values - slope * (time - time.mean()) - level, x.powers, "")


FUNCTIONS: Mapping[str, Function] = {
    "abs": Function("abs(x)", 1, 1, _same(np.abs)),
    "sqrt": Function("sqrt(x)", 1, 1, _root),
    "exp": Function("exp(x)", 1, 1, _of_plain(np.exp, PLAIN)),
    "log": Function("log(x)", 1, 1, _of_plain(np.log, PLAIN)),
    "log10": Function("log10(x)", 1, 1, _of_plain(np.log10, PLAIN)),
    "sin": Function("sin(angle)", 1, 1, _of_plain(np.sin, PLAIN, angle=True)),
    "cos": Function("cos(angle)", 1, 1, _of_plain(np.cos, PLAIN, angle=True)),
    "tan": Function("tan(angle)", 1, 1, _of_plain(np.tan, PLAIN, angle=True)),
    "asin": Function("asin(x)", 1, 1, _of_plain(np.arcsin, ANGLE)),
    "acos": Function("acos(x)", 1, 1, _of_plain(np.arccos, ANGLE)),
    "atan": Function("atan(x)", 1, 1, _of_plain(np.arctan, ANGLE)),
    "atan2": Function("atan2(y, x)", 2, 2, _angle_of),
    "sign": Function("sign(x)", 1, 1, _sign),
    "min": Function("min(x, y, ...)", 2, 8, partial(_extreme, np.minimum)),
    "max": Function("max(x, y, ...)", 2, 8, partial(_extreme, np.maximum)),
    "clip": Function("clip(x, low, high)", 3, 3, _clip),
    "where": Function("where(condition, x, y)", 3, 3, _where),
    "mean": Function("mean(x)", 1, 1, partial(_of_all, np.mean)),
    "rms": Function("rms(x)", 1, 1, partial(_of_all, lambda x: np.sqrt(np.mean(x * x)))),
    "std": Function("std(x)", 1, 1, partial(_of_all, np.std)),
    "minimum": Function("minimum(x)", 1, 1, partial(_of_all, np.min)),
    "maximum": Function("maximum(x)", 1, 1, partial(_of_all, np.max)),
    "first": Function("first(x)", 1, 1, partial(_of_all, lambda x: x[0])),
    "last": Function("last(x)", 1, 1, partial(_of_all, lambda x: x[-1])),
    "derivative": Function("derivative(x)", 1, 1, _derivative),
    "integral": Function("integral(x)", 1, 1, _integral),
    "lowpass": Function("lowpass(x, '20 Hz')", 2, 2, _low),
    "highpass": Function("highpass(x, '0.5 Hz')", 2, 2, _high),
    "bandpass": Function("bandpass(x, '0.5 Hz', '20 Hz')", 3, 3, _filtered),
    "smooth": Function("smooth(x, '0.1 s')", 2, 2, _smooth),
    "delay": Function("delay(x, '5 ms')", 2, 2, _delay),
    "detrend": Function("detrend(x)", 1, 1, _detrend),
}
"""Functions of formulas by their names."""
