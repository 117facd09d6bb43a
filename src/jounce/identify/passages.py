"""Find and time the passages of an obstacle in a record that begins anywhere, and average the loops of a belt.

On a bench with a running belt the wheel meets the same obstacle repeatedly and does not come to rest in between. The
search template is the model's response, as the sensors measure it. The recurrence gives the speed of the belt more
accurately than a sensor on a cylinder. The average over the loops is compared with the model.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
import xarray as xr

from jounce.core.errors import FitError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import positive_si
from jounce.identify.belt_loops import (
    LEAD,
    alike_loops,
    cut_loops,
    loop_recording,
    noise_of_average,
    running_trial,
)
from jounce.parts import Rig
from jounce.recordings.carried import as_recording
from jounce.recordings.schema import recording_of
from jounce.recordings.sensors import Sensor, filter_signals
from jounce.roads import Road, Train, Trial
from jounce.simulation.settings import RunSettings
from jounce.simulation.solve import solve

_LIKE = 0.5
"""Minimum correlation with the model's response at a passage."""
_APART = 0.6
"""Minimum distance of two passages, as a share of a loop."""
_SLIPS = 0.12
"""Largest deviation of the belt speed from the stated one at which passages are found, as a share."""
_AFTER = 0.15
"""Time after a single obstacle that the template includes, in s: the wheel hops, the body begins to oscillate."""
_ONSET, _NEAR = 0.02, 0.02
"""Time after the first obstacle that the onset includes, and half-width of the timing search, in s."""


@dataclass(frozen=True)
class Passages(Shown):
    """Passages of the obstacles of a road in one record.

    Attributes
    ----------
    times : tuple of float
        Times of the record at which the wheel meets the (first) obstacle, s.
    likeness : tuple of float
        Correlation of the record with the model's response at each passage, over all channels (1).
    speed : float
        Speed of the belt, m/s: its length over the time between passages; the stated one for a single passage.
    period : float or None
        Mean time between passages, s; None for a single one.
    again : tuple of float
        Times (s) at which the obstacle of a road without recurrence is met again.
    loop : xarray.Dataset or None
        Average of the loops, in SI over ``time`` (s), which starts a share ``LEAD`` of a loop before the obstacle.
    scatter : xarray.Dataset or None
        Standard deviation between loops at each instant, in the unit of each channel.
    repeatability : dict
        Mapping from channel to the r.m.s. scatter between loops relative to the r.m.s. of the average (1).
    noise : dict
        Mapping from channel to the noise standard deviation of the average, in the unit of the channel: that of white
        noise with the spectral density of the differences between loops at the frequencies of the signal.
    odd : tuple of int
        Passages (counted from 1) whose loop is an outlier and was left out of the average.
    findings : tuple of Finding
        Results and limitations of the search.
    """

    times: tuple[float, ...]
    likeness: tuple[float, ...]
    speed: float
    period: float | None = None
    loop: xr.Dataset | None = None
    scatter: xr.Dataset | None = None
    repeatability: dict[str, float] = field(default_factory=dict)
    noise: dict[str, float] = field(default_factory=dict)
    odd: tuple[int, ...] = ()
    again: tuple[float, ...] = ()
    findings: tuple[Finding, ...] = ()


@dataclass(frozen=True)
class Sought(Shown):
    """Template and record of a search that found no obstacle.

    Attributes
    ----------
    record : xarray.Dataset
        Record of the channels that were used.
    response : xarray.Dataset
        The model's response in the same channels, at the best-matching time of the record (``time``, s).
    likeness : float
        Correlation at that time (1).
    """

    record: xr.Dataset
    response: xr.Dataset
    likeness: float


class ObstacleNotFoundError(FitError):
    """Raised if a record does not contain the obstacle; ``sought`` contains template and record."""

    sought: Sought | None = None


def find_passages(
    measured: xr.Dataset,
    rig: Rig,
    road: Road,
    speed: float | str,
    *,
    sensors: Mapping[str, Sensor] | None = None,
    channels: Sequence[str] | None = None,
    name: str = "record",
) -> Passages:
    """Find the times at which the wheel meets the obstacles of a road, and average over the loops of a belt.

    Parameters
    ----------
    measured : xarray.Dataset
        Recording in SI at uniform time steps (s); channels that are also outputs of the model are used.
    rig : Rig
        The rig as set up for the trial; approximate values are sufficient.
    road : Road
        The obstacle or train; with ``recurrence``, the length of the belt (m), loops are searched for.
    speed : float or str
        Stated speed, m/s.
    sensors : mapping of str to Sensor, optional
        Mapping from channel to sensor, applied to the model's response.
    channels : sequence of str, optional
        Channels to use; all common ones by default.
    name : str
        Name of the record in findings.

    Returns
    -------
    Passages
        Times, speed, average and scatter.

    Raises
    ------
    ObstacleNotFoundError
        If no part of the record matches the model's response; it contains the template.
    FitError
        If a loop of the belt contains a further obstacle.

    Examples
    --------
    >>> import jounce as jn
    >>> rig, road = jn.load("kart-quarter-car"), jn.HalfSine(height="10 mm", length="60 mm", recurrence="1.97 m")
    >>> late = road.model_copy(update={"start": 1.2})
    >>> run = jn.simulate(rig, jn.Trial(road=late, speed="1.95 m/s", duration="4 s"))[["sprung.az", "unsprung.az"]]
    >>> found = find_passages(run, rig, road, "2 m/s")
    >>> [round(time, 2) for time in found.times], round(found.speed, 3)
    ([0.62, 1.63, 2.64, 3.65], 1.95)
    """
    data = as_recording(measured, where=name)
    velocity = positive_si(speed, "m/s", where="speed")
    time = np.asarray(data["time"].to_numpy(), dtype=float)
    step = float(time[-1] - time[0]) / (len(time) - 1)
    expected = _response(rig, road, velocity, step, sensors or {})
    names = [
        str(c)
        for c in data.data_vars
        if c in expected.signals and (channels is None or c in channels)
    ]
    if not names:
        raise FitError(
            "the recording contains no channel of the model",
            where=name,
            found=", ".join(map(str, data.data_vars)),
            allowed=", ".join(expected.signals),
        )
    recorded = np.stack([data[c].to_numpy() for c in names])
    ahead = round(expected.lead / step)
    signs = _signs(recorded, expected.window(names, expected.length), ahead)
    recorded = signs[:, None] * recorded  # otherwise channels of opposite signs cancel
    like, power = _likeness(recorded, expected.window(names, expected.length), ahead)
    at, sign = _peaks(like, power, step, expected.period)
    if not len(at):
        best = int(np.argmax(sign * like * power))
        error = ObstacleNotFoundError(
            "the obstacle is not found in the record",
            where=name,
            found=f"at best a correlation of {sign * like[best]:.2f}",
            allowed=Phrase(
                "{like:g} or more with the model's response to {describe} at {velocity:.3g} m/s in {names}",
                like=_LIKE,
                describe=_describe(road),
                velocity=velocity,
                names=", ".join(names),
            ),
            hint="Check speed, obstacle, columns and units; is it the record of another trial?",
        )
        error.sought = _sought(
            data, names, sign * signs, expected, best, step, float(sign * like[best])
        )
        raise error
    onset = sign * _likeness(recorded, expected.window(names, expected.onset), ahead)[0]
    samples = None if expected.period is None else expected.period / step
    whole = np.arange(len(onset)) - ahead
    surest = np.where((whole >= 0) & (whole <= len(time) - expected.onset), onset, -1.0)
    at = _at_onset(onset, surest, at, expected.length - ahead, round(_NEAR / step), samples)
    times = time[0] + step * (at - ahead + _fractions(onset, at)) + expected.lead
    values = tuple(float(onset[i]) for i in at)
    findings = _sign_findings(sign * signs, names, name)
    if road.recurrence is None:
        others = _repeated_meetings(onset, like * sign * power, int(at[0]), expected.length)
        again = (
            time[0] + step * (others - ahead + _fractions(onset, others)) + expected.lead
        ).tolist()
        if again:
            listed = ", ".join(f"{instant:.3g} s" for instant in sorted([*again, times[0]]))
            findings.append(
                finding("identify.met_again", name, float(len(again) + 1), times=listed)
            )
        return Passages(
            (float(times[0]),), values, velocity, again=tuple(again), findings=tuple(findings)
        )
    if len(times) > 2:
        behind = _another_obstacle(onset, power, at, expected, names) * step * velocity
        if behind > 0.0:
            raise FitError(
                "each loop of the belt contains an obstacle that the road does not describe",
                where=name,
                found=f"another obstacle {behind:.3g} m after the start of the first",
                allowed=_describe(road),
                hint="Describe all obstacles, as a train or a profile of the whole loop, or remove the extra one.",
            )
    if len(times) < 2:
        return Passages(tuple(map(float, times)), values, velocity, findings=tuple(findings))
    return _average_loops(data, names, times, values, road.recurrence, velocity, findings, name)


# what is looked for ---------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Expected:
    """The model's response: signals from ``lead`` (s) before the obstacle, at the time steps of the record."""

    signals: dict[str, Array]
    lead: float
    length: int  # samples in which the response is that of all obstacles
    onset: int  # samples up to the end of the first one
    last: int  # samples from the start of the first to that of the last one
    period: float | None

    def window(self, names: Sequence[str], length: int) -> Array:
        """Return the signals minus their mean over the window, shape (names, length)."""
        rows = np.stack([self.signals[name][:length] for name in names])
        return np.asarray(rows - rows.mean(axis=1, keepdims=True))


def _describe(road: Road) -> str:
    return f"{getattr(road, 'kind', 'road')} of {road.end() - road.start:.3g} m"


def _first(road: Road) -> float:
    """Return the length (m) of the first obstacle."""
    while isinstance(road, Train):
        road = road.of
    return road.end() - road.start


def _response(
    rig: Rig, road: Road, speed: float, step: float, sensors: Mapping[str, Sensor]
) -> _Expected:
    length = road.end() - road.start
    if road.recurrence is not None:
        trial, begin = running_trial(rig, road, speed)
        lead, period = LEAD * road.recurrence / speed, road.recurrence / speed
        span = min(lead + length / speed + _AFTER, period)
    else:
        lead, period, begin = 0.02, None, 0.0
        span = lead + length / speed + _AFTER
        trial = Trial(
            road=road.model_copy(update={"start": lead * speed}), speed=speed, duration=span
        )
    run = solve(rig, trial, RunSettings(step, 1e-4))
    first = int(np.searchsorted(run.time, begin - 0.5 * step))
    signals = {}
    for name, (values, _, _) in run.channels.items():
        seen = (
            filter_signals(values, 1.0 / step, sensors[name], where=name)
            if name in sensors
            else values
        )
        signals[name] = seen[first:]
    onset = min(lead + _first(road) / speed + _ONSET, span)
    last = (length - _first(road)) / speed
    return _Expected(
        signals, lead, round(span / step), round(onset / step), round(last / step), period
    )


# finding --------------------------------------------------------------------------------------------------------------


def _likeness(recorded: Array, window: Array, ahead: int) -> tuple[Array, Array]:
    """Return the correlation (1) of a window with a record, over all channels, and its share of the motion (1).

    The window starts ``ahead`` samples before the first one. Channels are weighted by their own size; values constant
    within the window are ignored. A window that extends beyond the record is compared over the overlap.
    """
    from scipy.signal import correlate

    count = window.shape[1]
    behind = count - 1 - min(count - 1, round(_FEWEST_SEEN * count))
    products = energies = 0.0
    for record, wanted in zip(recorded, window, strict=True):
        if not np.any(wanted):
            continue
        inside = np.pad(np.ones(record.size), (ahead, behind))
        scaled = np.pad((record - record.mean()) / (float(np.std(record)) or 1.0), (ahead, behind))
        shape = wanted / math.sqrt(float(wanted @ wanted))
        both = correlate(inside, np.ones(count), mode="valid", method="fft")
        level = correlate(scaled, np.ones(count), mode="valid", method="fft") / both
        power = correlate(scaled**2, np.ones(count), mode="valid", method="fft") - both * level**2
        seen = correlate(inside, shape, mode="valid", method="fft")
        size = correlate(inside, shape**2, mode="valid", method="fft") - seen**2 / both
        products = products + correlate(scaled, shape, mode="valid", method="fft") - level * seen
        energies = energies + np.sqrt(np.maximum(power, _QUIET * both) * np.maximum(size, 1e-6))
    return np.asarray(products / energies), np.asarray(energies)


_QUIET = 0.05
"""Minimum mean square of a window, relative to the whole record, so that noise is not mistaken for a response."""
_FEWEST_SEEN = 0.15
"""Minimum share of a window within the record."""


def _peaks(like: Array, power: Array, step: float, period: float | None) -> tuple[np.ndarray, int]:
    """Return the samples at which passages begin, and the common sign of all channels.

    A train resembles itself one pitch later. The wheel moves within the train and hardly before and after it, so the
    correlation is weighted by the share of the motion within the window.
    """
    from scipy.signal import find_peaks

    sign = 1 if np.max(like * power) >= -np.min(like * power) else -1
    score = sign * like * power
    best = int(np.argmax(score))
    if sign * like[best] < _LIKE:
        return np.zeros(0, dtype=int), sign
    if period is None:
        return np.array([best]), sign
    padded = np.concatenate([[-1.0], score, [-1.0]])
    at, _ = find_peaks(
        padded, height=_SHARE * score[best], distance=max(1, round(_APART * period / step))
    )
    at = at - 1
    return at[sign * like[at] >= _LIKE * _SHARE], sign


_SHARE = 0.6
"""Minimum share of the best score for a further passage."""


def _sought(
    data: xr.Dataset,
    names: Sequence[str],
    signs: Array,
    expected: _Expected,
    best: int,
    step: float,
    likeness: float,
) -> Sought:
    """Return the model's response at its best match, each channel minus its mean and with the likelier sign."""
    begin = float(data["time"][0]) + best * step - expected.lead
    count = expected.length
    channels = {}
    for name, sign in zip(names, signs, strict=True):
        values = sign * expected.signals[name][:count]
        middle = float(data[name].mean()) - float(values.mean())
        channels[name] = (
            values + middle,
            str(data[name].attrs["units"]),
            str(data[name].attrs.get("long_name", "")),
        )
    clock = begin + step * np.arange(count)
    return Sought(data[list(names)], recording_of(clock, channels, attributes={}), likeness)


def _repeated_meetings(onset: Array, score: Array, at: int, length: int) -> np.ndarray:
    """Return the samples at which the obstacle of a road without recurrence is met again."""
    from scipy.signal import find_peaks

    padded = np.concatenate([[-1.0], score, [-1.0]])
    peaks = find_peaks(padded, height=_SHARE * score.max(), distance=length)[0] - 1
    surest = np.array([_argmax_near(onset, int(i), length // 2) for i in peaks], dtype=int)
    return (
        surest[(onset[surest] >= _CLEAR) & (np.abs(surest - at) > length)]
        if len(surest)
        else surest
    )


def _another_obstacle(
    onset: Array, power: Array, at: np.ndarray, expected: _Expected, names: Sequence[str]
) -> int:
    """Return the samples from an obstacle's start to a further one, not of the road, that every loop contains.

    The result is 0 without such an obstacle. The continued oscillation of wheel and body resembles an obstacle to some
    degree, which the model's own loop shows.
    """
    loop = expected.window(names, len(next(iter(expected.signals.values()))))
    own, _ = _likeness(np.hstack([loop, loop]), expected.window(names, expected.onset), 0)
    period = int(np.min(np.diff(at)))
    reach = np.arange(expected.last + expected.onset, min(period - expected.onset, loop.shape[1]))
    whole = at[(at + period < len(onset))]
    if not len(reach) or len(whole) < 2:
        return 0
    seen = np.min([onset[i + reach] for i in whole], axis=0)
    strong = np.min([power[i + reach] / power[i] for i in whole], axis=0)
    more = np.where((strong >= _SHARE) & (seen >= _CLEAR), seen - own[reach], 0.0)
    best = int(np.argmax(more))
    return int(reach[best]) if more[best] >= _MORE_ALIKE else 0


_CLEAR = 0.8
"""Minimum correlation with the onset for an unexpected passage."""
_MORE_ALIKE = 0.3
"""Minimum excess of the correlation with the onset over that of the model's loop, for a further obstacle."""


def _at_onset(
    onset: Array, whole: Array, at: np.ndarray, reach: int, near: int, period: float | None
) -> np.ndarray:
    """Move passages to the onset of the response to the first obstacle, at equal distances.

    Later parts of a train depend too much on masses and damping. Starting from the most certain passage, the next ones
    are searched for one period (samples) before and after it, which avoids missed passages at the ends and false ones
    in between. ``whole`` is the correlation for windows within the record.
    """
    surest = max((_argmax_near(whole, int(i), reach) for i in at), key=lambda i: float(whole[i]))
    if period is None:
        return np.array([surest])
    apart = np.diff(at)
    likely = apart[np.abs(apart / period - 1.0) < _SLIPS]
    if len(likely) < 2 and len(apart) > 1 and np.ptp(apart) < _EVEN * np.median(apart):
        likely = apart  # the speed differs from the stated one
    if len(likely) > 1:
        period, wide = float(np.median(likely)), near
    else:
        wide = max(near, round(_SLIPS * period))
    passages = {0: surest}
    for way in (1, -1):
        number, last, step, around = 0, float(surest), way * period, wide
        while 0 <= last + step < len(onset):
            number, last = number + way, last + step
            i = _argmax_near(onset, round(last), around)
            if onset[i] >= _SURE:
                if number - way in passages:  # follow the speed of the belt
                    step = i - passages[number - way]
                passages[number], last, around = i, float(i), near
    return np.array([passages[number] for number in sorted(passages)])


_EVEN = 0.05
"""Largest unevenness, as a share, of the distances of passages that do not match the stated speed."""
_SURE = 0.7
"""Minimum correlation with the onset for an expected passage."""


def _argmax_near(onset: Array, i: int, reach: int) -> int:
    first = max(i - reach, 0)
    return first + int(np.argmax(onset[first : i + reach + 1]))


def _fractions(like: Array, at: np.ndarray) -> Array:
    """Refine correlation maxima between samples by a parabola through three of them."""
    fraction = np.zeros(len(at))
    for k, i in enumerate(at):
        if 0 < i < len(like) - 1:
            left, middle, right = like[i - 1 : i + 2]
            bend = left - 2.0 * middle + right
            fraction[k] = 0.5 * (left - right) / bend if bend < 0.0 else 0.0
    return np.clip(fraction, -0.5, 0.5)


def _signs(recorded: Array, window: Array, ahead: int) -> Array:
    """Return the sign of each channel at the best joint match with the model's response, weighted by size.

    A channel is reversed only if it clearly is the inverted response; a weak channel keeps its sign.
    """
    each = [
        _likeness(row[None, :], wanted[None, :], ahead)
        for row, wanted in zip(recorded, window, strict=True)
    ]
    best = int(np.argmax(sum(np.abs(like) * power**2 for like, power in each)))
    return np.array([-1.0 if like[best] < -_LIKE else 1.0 for like, _ in each])


def _sign_findings(signs: Array, names: Sequence[str], where: str) -> list[Finding]:
    turned = [name for name, sign in zip(names, signs, strict=True) if sign < 0.0]
    return [finding("identify.upside_down", f"{where}: {', '.join(turned)}")] if turned else []


def _average_loops(
    data: xr.Dataset,
    names: Sequence[str],
    times: Array,
    likeness: tuple[float, ...],
    belt: float,
    stated: float,
    findings: list[Finding],
    where: str,
) -> Passages:
    """Compute speed, average and scatter of a record with several passages."""
    periods = np.diff(times)
    usual = float(np.median(periods))
    whole = np.maximum(
        np.round(periods / usual), 1.0
    )  # a passage between them may not have been recognised
    period = float((times[-1] - times[0]) / whole.sum())
    speed = belt / period
    if abs(speed / stated - 1.0) > _SLIPS:
        numbers = {"period": period, "speed": speed, "belt": belt, "stated": stated}
        findings.append(finding("identify.other_speed", where, speed, **numbers))
    time = np.asarray(data["time"].to_numpy(), dtype=float)
    step = float(time[-1] - time[0]) / (len(time) - 1)
    count = max(round(period / step), 8)
    loops, begun = cut_loops(data, names, time, times, period, count)
    if len(loops) < 2:
        return Passages(tuple(map(float, times)), likeness, speed, period, findings=tuple(findings))
    chosen = alike_loops(loops)
    odd = tuple(int(begun[k]) + 1 for k in np.flatnonzero(~chosen))
    if odd:
        listed = ", ".join(map(str, odd))
        is_alternating = (
            len(odd) > 2 and set(np.diff(odd)) == {2} and len(odd) >= (len(loops) - 1) // 2
        )
        code = "identify.alternating_passages" if is_alternating else "identify.odd_passages"
        findings.append(finding(code, where, float(len(odd)), odd=listed, count=len(times)))
    mean, scatter = loops[chosen].mean(axis=0), loops[chosen].std(axis=0, ddof=1)
    size = np.sqrt(np.mean((mean - mean.mean(axis=1, keepdims=True)) ** 2, axis=1))
    spread = np.sqrt(np.mean(scatter**2, axis=1))
    repeat = {
        name: float(s / m) if m > 0.0 else math.inf
        for name, s, m in zip(names, spread, size, strict=True)
    }
    return Passages(
        tuple(map(float, times)),
        likeness,
        speed,
        period,
        loop_recording(data, names, mean, period, passages=int(chosen.sum())),
        loop_recording(data, names, scatter, period, passages=int(chosen.sum())),
        repeat,
        dict(zip(names, noise_of_average(loops[chosen]), strict=True)),
        odd,
        findings=tuple(findings),
    )
