"""Recordings brought onto one clock or one distance, by correlation of a channel or by an event of both."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import NDArray

from jounce.analysis.record import AnyRecord, Measured, check_channel, read_measured, refuse_gaps
from jounce.core.errors import RecordingError, unknown
from jounce.core.phrases import Phrase
from jounce.core.results import Shows, own_unit
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.recordings.signals import correlation_coefficients, read_at, uniform_instants

Event: TypeAlias = Literal["rise", "fall", "maximum", "minimum", "start"]
EVENTS: tuple[Event, ...] = get_args(Event)
_ALIKE = 0.5  # smallest correlation at which two records show the same motion
_AMBIGUOUS = 0.9  # of the highest peak: another peak as high as that may as well be the right one
_SAME_RATE = 1e-3
_FEWEST = 16  # samples that must overlap
_MOST = 20_000_000


@dataclass(frozen=True)
class Alignment(Plain):
    """Shift of one recording onto another.

    Attributes
    ----------
    shift : float
        What to add to the instants (s) of the moved recording, or to its ``axis``, in the unit of that channel.
    correlation : float or None
        Coefficient (-1 to 1) of both channels at this shift: 1 if they are alike. None for an event.
    next_best : float or None
        The highest other peak of the correlation (-1 to 1); the closer to ``correlation``, the less certain.
    overlap : float
        Duration of the overlap after the shift, s; on another axis its length, in ``unit``.
    rate : float or None
        Samples per second (Hz), or per ``unit`` of the axis, at which they were compared.
    unit : str
        SI unit of the axis: "s", or that of the channel.
    """

    shift: Annotated[float, Shows("shift", own_unit)]
    correlation: Annotated[float | None, Shows("correlation", "1")]
    next_best: Annotated[float | None, Shows("next best correlation", "1")]
    overlap: Annotated[float, Shows("overlap", own_unit)]
    rate: Annotated[float | None, Shows("compared at", lambda found: _per(found.unit))] = None
    unit: str = "s"


def _per(unit: str) -> str:
    return "Hz" if unit == "s" else f"1/{unit}"


@dataclass(frozen=True)
class Track:
    """One channel of a recording over its axis: ascending instants in s, or ascending values of another unit."""

    time: Array
    values: Array
    where: str
    unit: str = "s"


def track_over(axis: Array, values: Array, where: str, unit: str) -> Track:
    """Return a channel over another that never descends; where that stands still, its first sample counts.

    Raises
    ------
    RecordingError
        If the axis descends, has gaps, or does not move.
    """
    steps = np.diff(axis)
    if not (np.isfinite(axis).all() and (steps >= 0.0).all()):
        raise RecordingError(
            "the channel is no axis: it descends or has gaps",
            where=where,
            allowed="time, or a channel that never descends, such as a distance",
        )
    moves = np.concatenate(([True], steps > 0.0))
    if np.count_nonzero(moves) < 2:
        raise RecordingError("the channel is constant", where=where)
    return Track(axis[moves], values[moves], where, unit)


def align_by_correlation(
    reference: AnyRecord,
    moved: AnyRecord,
    channel: str,
    *,
    other: str = "",
    axis: str = "time",
    maximum_shift: float | str | None = None,
    resample: float | str | None = None,
) -> Alignment:
    """Find the shift of a recording onto another at which a channel of both is most alike.

    Parameters
    ----------
    reference, moved : Dataset, DataFrame, (Dataset, list of Finding), Path or str
        Two recordings of the same motion, of any length and beginning.
    channel : str
        Channel of ``reference``; its level and size do not matter.
    other : str, optional
        Channel of ``moved``; by default the same.
    axis : str, optional
        ``time``, or a channel of both that never descends, such as a distance: the shift is along it, in its SI unit.
    maximum_shift : float or str, optional
        Largest shift considered, s (or the SI unit of ``axis``) or text with a unit; by default any at which half of
        the shorter record overlaps.
    resample : float or str, optional
        Rate at which both are compared, Hz (or samples per SI unit of ``axis``) or text with a unit; required if
        their rates differ, but on another axis the lower mean rate is the default.

    Returns
    -------
    Alignment
        Shift with the height of its peak as a measure of trust; fractions of a sample by a parabola.

    Raises
    ------
    RecordingError
        If the rates differ, the channels are not alike (correlation below 0.5), or another shift fits nearly as well
        (a peak of 90 %), as for periodic motion.

    Examples
    --------
    >>> import jounce as jn, numpy as np
    >>> t = np.arange(0.0, 10.0, 0.01)
    >>> first = jn.recording(t, {"sprung.z": (np.exp(-((t - 4.0) ** 2)), "m", "")})
    >>> second = jn.recording(t, {"sprung.z": (np.exp(-((t - 5.5) ** 2)), "m", "")})
    >>> found = jn.align_by_correlation(first, second, "sprung.z")
    >>> round(found.shift, 3), round(found.correlation, 3)
    (-1.5, 1.0)
    >>> on_clock = second.assign_coords(time=second["time"] + found.shift)
    """
    first, second = _tracks(reference, moved, channel, other, axis)
    unit = first.unit
    most = None if maximum_shift is None else to_si(maximum_shift, unit, where="maximum_shift")
    rate = None if resample is None else to_si(resample, _per(unit), where="resample")
    if rate is None and axis != "time":
        rate = mean_rate(first, second)
    return correlated(first, second, maximum_shift=most, resample=rate)


def align_by_event(
    reference: AnyRecord,
    moved: AnyRecord,
    channel: str,
    event: Event = "rise",
    *,
    level: float | None = None,
    other: str = "",
    axis: str = "time",
) -> Alignment:
    """Find the shift of a recording at which an event of a channel coincides with that of another recording.

    Parameters
    ----------
    reference, moved : Dataset, DataFrame, (Dataset, list of Finding), Path or str
        Two recordings.
    channel : str
        Channel of ``reference``.
    event : {"rise", "fall", "maximum", "minimum", "start"}
        First rise or fall through ``level``, the largest or smallest value, or the first sample.
    level : float, optional
        For ``rise`` and ``fall``: value in the SI unit of the channel.
    other : str, optional
        Channel of ``moved``; by default the same.
    axis : str, optional
        ``time``, or a channel of both that never descends, such as a distance: the shift is along it, in its SI unit.

    Returns
    -------
    Alignment
        Shift, without a correlation. Crossings are found between samples on a straight line.

    Raises
    ------
    RecordingError
        If the event does not occur in one of them.

    Examples
    --------
    >>> import jounce as jn, numpy as np
    >>> t = np.arange(0.0, 10.0, 0.01)
    >>> runs = [jn.recording(t, {"speed": (np.maximum(t - start, 0.0), "m/s", "")}) for start in (2.0, 3.25)]
    >>> round(jn.align_by_event(*runs, "speed", "rise", level=0.5).shift, 6)
    -1.25
    """
    first, second = _tracks(reference, moved, channel, other, axis)
    return coincident(first, second, event, level)


def mean_rate(*tracks: Track) -> float:
    """Return the lowest mean rate of tracks: samples per unit of their axis."""
    return min(_rate(track) for track in tracks)


def correlated(
    reference: Track,
    moved: Track,
    *,
    maximum_shift: float | None = None,
    resample: float | None = None,
) -> Alignment:
    """Return the alignment of two tracks by correlation; see `align_by_correlation`."""
    rates = [_rate(track) for track in (reference, moved)]
    if resample is None and max(rates) > min(rates) * (1.0 + _SAME_RATE):
        raise RecordingError(
            "the recordings have different sample rates",
            where=moved.where,
            found=f"{rates[0]:.6g} Hz and {rates[1]:.6g} Hz",
            hint=Phrase(
                "Compare them at the lower rate: resample = '{rate:.6g} Hz'.", rate=min(rates)
            ),
        )
    rate = rates[0] if resample is None else resample
    a, b = (_at(track, rate) for track in (reference, moved))
    shorter = min(a.size, b.size)
    fewest = max(_FEWEST, shorter // 2)
    if shorter < 2 * _FEWEST or max(a.size, b.size) > _MOST:
        raise RecordingError(
            "the number of samples does not suit a correlation",
            where=moved.where,
            found=shorter if shorter < 2 * _FEWEST else max(a.size, b.size),
            allowed=Phrase("{fewest} to {most:g}", fewest=2 * _FEWEST, most=float(_MOST)),
        )
    for track, values in ((reference, a), (moved, b)):
        if float(np.ptp(values)) == 0.0:
            raise RecordingError("the channel is constant", where=track.where)
    most = max(a.size, b.size) - 1
    lags = np.arange(-most, most + 1)
    begin = float(reference.time[0] - moved.time[0])
    shifts = begin - lags / rate
    length = np.minimum(a.size, b.size - lags) - np.maximum(-lags, 0)
    allowed = length >= fewest
    if maximum_shift is not None:
        allowed &= np.abs(shifts) <= abs(maximum_shift) + 0.5 / rate
    if np.count_nonzero(allowed) < 3:
        raise RecordingError(
            "no shift within this range lets the recordings overlap",
            where=moved.where,
            found=None if maximum_shift is None else f"{maximum_shift:g} {reference.unit}",
            hint="Allow a larger shift, or align their starts first.",
        )
    likeness = np.where(allowed, correlation_coefficients(a, b, most), -np.inf)
    peak = int(np.argmax(likeness))
    height = float(likeness[peak])
    if height < _ALIKE:
        raise RecordingError(
            "the recordings are not alike",
            where=moved.where,
            found=Phrase("at best a correlation of {height:.2f}", height=height),
            allowed=Phrase("at least {alike:g}", alike=_ALIKE),
            hint="Choose another channel, or align them by an event.",
        )
    if not (allowed[peak - 1] and allowed[(peak + 1) % allowed.size]):
        raise RecordingError(
            "the best shift is at the end of the range",
            where=moved.where,
            found=f"{shifts[peak]:.4g} {reference.unit}",
            hint="Allow a larger shift, choose another channel, or align them by an event.",
        )
    rival = _rival(likeness, peak)
    other = -1.0 if rival is None else float(likeness[rival])
    if rival is not None and other > _AMBIGUOUS * height:
        raise RecordingError(
            "the alignment is ambiguous",
            where=moved.where,
            found=Phrase(
                "correlations of {height:.3f} at {first:.4g} {unit} and {other:.3f} at {second:.4g} {unit}",
                height=height,
                first=float(shifts[peak]),
                other=other,
                second=float(shifts[rival]),
                unit=reference.unit,
            ),
            hint="Limit the shift, choose a channel that does not repeat, or align them by an event.",
        )
    left, top, right = likeness[peak - 1 : peak + 2]
    bend = left - 2.0 * top + right
    part = 0.5 * (left - right) / bend if bend < 0.0 else 0.0
    shift = begin - (float(lags[peak]) + float(np.clip(part, -1.0, 1.0))) / rate
    overlap = float(length[peak] - 1) / rate
    next_best = None if rival is None else other
    return Alignment(shift, min(height, 1.0), next_best, overlap, rate, reference.unit)


def coincident(reference: Track, moved: Track, event: Event, level: float | None) -> Alignment:
    """Return the alignment of two tracks by an event; see `align_by_event`."""
    at, also = (event_instant(track, event, level) for track in (reference, moved))
    shift = at - also
    first = max(reference.time[0], moved.time[0] + shift)
    last = min(reference.time[-1], moved.time[-1] + shift)
    return Alignment(shift, None, None, max(0.0, float(last - first)), None, reference.unit)


def event_instant(track: Track, event: Event, level: float | None = None) -> float:
    """Return the instant (s) of an event of a track, or its place on another axis."""
    time, values = track.time, track.values
    if event not in EVENTS:
        raise unknown(str(event), EVENTS, what="event", where="event")
    if event == "start":
        return float(time[0])
    if not np.isfinite(values).any():
        raise RecordingError("the channel has no value", where=track.where)
    if event in ("maximum", "minimum"):
        return float(time[np.nanargmax(values) if event == "maximum" else np.nanargmin(values)])
    if level is None:
        raise RecordingError(
            "the level is missing", where=track.where, hint="A rise or a fall needs a level."
        )
    sign = 1.0 if event == "rise" else -1.0
    above = sign * (values - level)
    crossed = np.flatnonzero((above[:-1] < 0.0) & (above[1:] >= 0.0))
    if not crossed.size:
        low, high = float(np.nanmin(values)), float(np.nanmax(values))
        raise RecordingError(
            Phrase("the channel never rises through {level:.6g}", level=level)
            if event == "rise"
            else Phrase("the channel never falls through {level:.6g}", level=level),
            where=track.where,
            allowed=Phrase("between {low:.6g} and {high:.6g}", low=low, high=high),
        )
    k = int(crossed[0])
    share = -above[k] / (above[k + 1] - above[k])
    return float(time[k] + share * (time[k + 1] - time[k]))


def _tracks(
    reference: AnyRecord, moved: AnyRecord, channel: str, other: str, axis: str
) -> tuple[Track, Track]:
    first, second = read_measured(reference), read_measured(moved)
    return _track(first, channel, axis), _track(second, other or channel, axis)


def _track(record: Measured, channel: str, axis: str) -> Track:
    values, where = record.values(check_channel(record, channel)), f"{record.name}: {channel}"
    if axis != "time":
        along = record.values(check_channel(record, axis))
        return track_over(along, values, where, record.unit(axis))
    time = np.asarray(record.run["time"].to_numpy(), dtype=float)
    return Track(time, values, where)


def _rate(track: Track) -> float:
    if track.time.size < 2:
        raise RecordingError("the record is too short", where=track.where)
    return (track.time.size - 1) / float(track.time[-1] - track.time[0])


def _at(track: Track, rate: float) -> Array:
    """Return a track at a rate, from its first instant."""
    values = track.values
    refuse_gaps(track.time, values, where=track.where)
    wanted = uniform_instants(float(track.time[0]), float(track.time[-1]), rate)
    return read_at(track.time, values, wanted, rate)


def _rival(likeness: NDArray[np.float64], peak: int) -> int | None:
    """Return the highest peak apart from the lobe around the highest; none if there is no other."""
    low = likeness < 0.5 * likeness[peak]
    before, behind = np.flatnonzero(low[:peak]), np.flatnonzero(low[peak:])
    others = np.full(likeness.size, -np.inf)
    if before.size:
        others[: before[-1]] = likeness[: before[-1]]
    if behind.size:
        others[peak + behind[0] :] = likeness[peak + behind[0] :]
    best = int(np.argmax(others))
    return best if np.isfinite(others[best]) else None
