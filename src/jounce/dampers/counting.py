"""Count the samples of a record from the track in fine bins of travel and velocity, and tell what weakens them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import RecordingError
from jounce.core.findings import Finding, finding
from jounce.core.types import Array
from jounce.dampers.traces import (
    Differentiator,
    Single,
    Span,
    differentiator,
    largest_motion_in,
    noise_in,
    spans_of,
    spikes_in,
    standing_share,
    still_spans,
    velocity_of,
    without_spikes,
)
from jounce.dampers.track import CornerTrace, Track

PIECES = 20
"""Parts of a record whose scatter gives the intervals of shares: 19 degrees of freedom."""
MOST_BINS = 64
FINE = 16
"""Bins of travel that are counted, for each that is shown."""
COVERED = 0.999
"""Share of the time that lies within the velocities that are shown."""
FASTEST_BIN = 10.0
"""Velocity (m/s) at which bins end."""
_FINEST = 1e-3  # m/s: about the bins of velocity that are counted; low speed is a multiple of ten
_CHUNK = 1 << 16  # samples at a time: what fits the cache
_LONGEST = 1.5  # m: no suspension has a longer travel
_HARDLY = 0.05  # of the usual velocity of the others, below which a channel counts as dead
_NOISY = 1.5  # times its noise, below which a travel is nothing else
_STILL = 2.0  # s: a number repeated for this long while others move is a dead channel
_MOVES = 1e-3  # m: what counts as motion of the others
_STANDS, _STANDS_BELOW = 0.2, 3e-4  # share of standing still that is named; m within a second
_OFFSET = 0.25  # of the travel's range: difference of left and right, or drift, that is named
_PILES = 0.01  # share of time in the outer hundredth of the travel: a stop, or a sensor's end
_NARROW = 5e-3  # m: a travel in mm that stays between 0 and 5 may be volts
_BAD = 0.01  # share of spikes from which a channel is unreliable
_SOME = 200_000  # samples that tell the usual velocity


@dataclass(frozen=True)
class FineCounts:
    """Samples in fine bins for each atom of time: ``counts[atom, bin]``; the first begins at ``begin * width``."""

    width: float
    begin: int
    counts: NDArray[np.int64]

    @cached_property
    def total(self) -> NDArray[np.int64]:
        """Samples in each bin, of the whole record."""
        return np.asarray(self.counts.sum(axis=0), dtype=np.int64)

    @cached_property
    def middles(self) -> Array:
        """Middle of each bin."""
        return np.asarray(
            (self.begin + np.arange(self.counts.shape[1]) + 0.5) * self.width, dtype=float
        )

    @property
    def ends(self) -> tuple[float, float]:
        """Outer edges of all bins."""
        return self.begin * self.width, (self.begin + self.counts.shape[1]) * self.width

    def in_parts(self, parts: Sequence[NDArray[np.intp]]) -> NDArray[np.int64]:
        """Return the samples in each bin for parts of the record, given by their atoms."""
        return np.array([self.counts[rows].sum(axis=0) for rows in parts], dtype=np.int64)

    def shares(self, samples: NDArray[np.int64], borders: Array) -> Array:
        """Return the shares below, between and above borders, for rows of samples; NaN of a row without any."""
        sums = np.cumsum(samples, axis=1)
        places = np.searchsorted(self.middles, borders)
        padded = np.concatenate([np.zeros((len(sums), 1), np.int64), sums], axis=1)
        ends = [padded[:, :1], padded[:, places], padded[:, -1:]]
        with np.errstate(invalid="ignore"):
            shares = np.diff(np.concatenate(ends, axis=1), axis=1) / padded[:, -1:]
        return np.asarray(shares, dtype=float)

    def quantile(self, share: float, samples: NDArray[np.int64] | None = None) -> float:
        """Return the value below which a share of the samples lies, of the whole record by default."""
        sums = np.cumsum(self.total if samples is None else samples)
        place = int(np.searchsorted(sums, share * float(sums[-1])))
        return float(self.middles[min(place, self.middles.size - 1)])


@dataclass(frozen=True)
class CountedCorner:
    """What is counted of a corner.

    ``extremes[atom]`` has the least and the largest travel, then velocity; NaN in atoms without samples. ``noise`` is
    that of the velocity (m/s, r.m.s.); ``cut`` is the filter that made it, None of a velocity as recorded.
    """

    trace: CornerTrace
    travel: FineCounts | None
    velocity: FineCounts
    extremes: Array
    noise: float
    cut: Differentiator | None


@dataclass(frozen=True)
class CountedTrack:
    """A record whose corners are counted; sections and pieces list their atoms of time."""

    name: str
    rate: float
    sections: dict[str, NDArray[np.intp]]
    pieces: list[NDArray[np.intp]]
    corners: dict[str, CountedCorner]
    is_model: bool


@dataclass(frozen=True)
class _Moved:
    """A corner with its velocity, and the samples that do not count."""

    trace: CornerTrace
    velocity: Single
    noise: float
    cut: Differentiator | None
    skipped: tuple[Span, ...]
    moves: bool
    """Whether the travel is more than noise."""

    @property
    def usual(self) -> float:
        """R.m.s. velocity, from some of the samples, m/s."""
        some = self.velocity[:: max(1, self.velocity.size // _SOME)]
        return float(np.sqrt(np.mean(np.square(some))))


def count_track(
    track: Track, cutoff: float, low: float, stroke: float | None, *, is_model: bool
) -> tuple[CountedTrack, list[Finding]]:
    """Count the samples of each corner between all borders of sections and pieces.

    ``low`` (m/s) is the end of low speed, which is an edge of bins.

    Raises
    ------
    RecordingError
        If no corner moves as a suspension does.
    """
    findings = list(track.findings)
    traces = [
        whole for trace in track.corners.values() if (whole := _mended(track, trace, findings))
    ]
    if not traces:
        raise RecordingError(
            "no channel can be the travel of a suspension", where=track.name,
            found="; ".join(item.message for item in findings[-2:]), hint="Check its unit.",
        )  # fmt: skip
    moved = _alive([_differentiated(track, trace, cutoff) for trace in traces], track, findings)
    moved = _without_stuck(moved, track, findings)
    findings += _slow(track, moved, cutoff)
    atoms, sections, pieces = _atoms(track, [span for item in moved for span in item.skipped])
    corners = {item.trace.corner: _counted(item, _used(atoms, item), low) for item in moved}
    if not is_model:
        findings += _doubts(track, corners, sections, stroke)
    return CountedTrack(track.name, track.rate, sections, pieces, corners, is_model), findings


# channels -------------------------------------------------------------------------------------------------------------


def _mended(track: Track, trace: CornerTrace, findings: list[Finding]) -> CornerTrace | None:
    """Replace spikes by lines and name jumps of the level; None for what is no travel of a suspension."""
    place, travel = f"{track.name}: {trace.column}", trace.travel
    if travel is None:
        return trace
    ends = float(travel.min()), float(travel.max())
    spikes, jumps = spikes_in(travel, track.rate, ends)
    if spikes.size:
        share, mended = spikes.size / travel.size, without_spikes(travel, spikes)
        size = float(np.abs(travel[spikes] - mended[spikes]).max())
        code = "dampers.many_spikes" if share > _BAD else "dampers.spikes"
        findings.append(finding(code, place, share, spikes=spikes.size, share=share, size=size))
        travel = mended
        ends = float(travel.min()), float(travel.max())
    if jumps:
        at = track.first + jumps[0] / track.rate
        size = float(travel[jumps[0] + 1] - travel[jumps[0]])
        findings.append(
            finding("dampers.level_jumps", place, size, jumps=len(jumps), at=at, size=size)
        )
    extent = ends[1] - ends[0]
    if extent > _LONGEST:
        code = "dampers.no_travel_of_suspension"
        findings.append(finding(code, place, extent, extent=extent, most=_LONGEST))
        return None
    return replace(trace, travel=travel)


def _differentiated(track: Track, trace: CornerTrace, cutoff: float) -> _Moved:
    """Return the velocity of a corner, with the noise that is in it."""
    if trace.travel is None:
        assert trace.velocity is not None
        velocity = trace.velocity.astype(np.float32)
        return _Moved(trace, velocity, 0.0, None, trace.missing, moves=True)
    cut = differentiator(track.rate, min(cutoff, 0.8 * trace.highest))
    noise = noise_in(trace.travel)
    moves = largest_motion_in(trace.travel) > _NOISY * noise
    velocity = velocity_of(trace.travel, cut)
    return _Moved(trace, velocity, noise * cut.noise_gain, cut, trace.missing, moves)


def _alive(moved: Sequence[_Moved], track: Track, findings: list[Finding]) -> list[_Moved]:
    """Leave out channels that show nothing but noise, or hardly move where the others do."""
    usual = [item.usual for item in moved]
    alive = []
    for k, item in enumerate(moved):
        others = usual[:k] + usual[k + 1 :]
        least = _HARDLY * float(np.median(others)) if others else 0.0
        if item.moves and usual[k] > least:
            alive.append(item)
            continue
        place, corner = f"{track.name}: {item.trace.column}", item.trace.corner
        findings.append(finding("dampers.dead", place, usual[k], corner=corner, velocity=usual[k]))
    if not alive:
        found = ", ".join(item.trace.column for item in moved)
        raise RecordingError("no damper moves", where=track.name, found=found)
    return alive


def _without_stuck(moved: list[_Moved], track: Track, findings: list[Finding]) -> list[_Moved]:
    """Do not count where one channel repeats a number while another corner moves."""
    counted = []
    for item in moved:
        others = [other.trace.travel for other in moved if other is not item]
        travel = item.trace.travel
        stuck = [
            span
            for span in (() if travel is None else still_spans(travel, track.rate, _STILL))
            if any(
                other is not None and float(np.ptp(other[slice(*span)])) > _MOVES
                for other in others
            )
        ]
        if stuck:
            seconds = sum(last - first for first, last in stuck) / track.rate
            at = track.first + stuck[0][0] / track.rate
            place = f"{track.name}: {item.trace.column}"
            findings.append(finding("dampers.stuck", place, seconds, seconds=seconds, first=at))
        counted.append(replace(item, skipped=(*item.skipped, *stuck)))
    return counted


def _slow(track: Track, moved: Sequence[_Moved], cutoff: float) -> Iterator[Finding]:
    """Tell that a record is too slow for the cut-off."""
    slow = [item for item in moved if item.cut and 0.8 * item.trace.highest < cutoff]
    passbands = [item.cut.passband for item in slow if item.cut]
    if passbands:
        rate = 2.0 * min(item.trace.highest for item in slow)
        highest = min(passbands)
        yield finding("dampers.slow_record", track.name, highest, highest=highest, rate=rate)


# atoms of time --------------------------------------------------------------------------------------------------------


def _atoms(
    track: Track, skipped: Sequence[Span]
) -> tuple[NDArray[np.int64], dict[str, NDArray[np.intp]], list[NDArray[np.intp]]]:
    """Cut time at all borders; return the borders, the atoms of each section, and those of each piece."""
    pieces = np.linspace(0, track.count, PIECES + 1).astype(np.int64)
    spans = [*(span for spans in track.sections.values() for span in spans), *skipped]
    borders = np.asarray(spans, dtype=np.int64).ravel()
    atoms = np.unique(np.clip(np.concatenate([pieces, borders]), 0, track.count))

    def between(first: int, last: int) -> NDArray[np.intp]:
        return np.arange(*np.searchsorted(atoms, np.clip((first, last), 0, track.count)))

    sections = {
        name: np.concatenate([between(*span) for span in spans])
        for name, spans in track.sections.items()
    }
    return atoms, sections, [between(*span) for span in pairwise(pieces.tolist())]


def _used(atoms: NDArray[np.int64], item: _Moved) -> list[list[Span]]:
    """Return the samples of each atom that count: not the skipped ones, nor those whose velocity they reach."""
    if not item.skipped:
        return [[span] for span in pairwise(atoms.tolist())]
    half = 0 if item.cut is None else len(item.cut.kernel) // 2
    counts = np.ones(item.velocity.size, dtype=bool)
    for first, last in item.skipped:
        counts[max(0, first - half) : last + half] = False
    return [
        [(start + first, start + last) for first, last in spans_of(counts[start:stop])]
        for start, stop in pairwise(atoms.tolist())
    ]


# counts ---------------------------------------------------------------------------------------------------------------


def _counted(item: _Moved, used: Sequence[Sequence[Span]], low: float) -> CountedCorner:
    """Count travel and velocity in fine bins, atom by atom."""
    trace = item.trace
    extremes = np.full((len(used), 4), np.nan)
    if trace.travel is not None:
        extremes[:, :2] = _extremes(trace.travel, used)
    extremes[:, 2:] = _extremes(item.velocity, used)
    if not np.isfinite(extremes[:, 2]).any():
        raise RecordingError("all samples are missing", where=trace.column)
    least, most = float(np.nanmin(extremes[:, 2])), float(np.nanmax(extremes[:, 3]))
    width = low / (10 * max(1, round(low / (10.0 * _FINEST))))
    ends = max(least, -FASTEST_BIN), min(most, FASTEST_BIN)
    velocity = _binned(item.velocity, used, width, ends, is_cut=ends != (least, most))
    travel = None
    if trace.travel is not None:
        bottom, top = float(np.nanmin(extremes[:, 0])), float(np.nanmax(extremes[:, 1]))
        fine = nice_width((top - bottom) / MOST_BINS) / FINE
        travel = _binned(trace.travel, used, fine, (bottom, top), is_cut=False)
    return CountedCorner(trace, travel, velocity, extremes, item.noise, item.cut)


def _extremes(values: NDArray[Any], used: Sequence[Sequence[Span]]) -> Array:
    """Return the least and the largest value of each atom; NaN without samples."""
    ends = np.full((len(used), 2), np.nan)
    for row, spans in enumerate(used):
        for first, last in spans:
            part = values[first:last]
            ends[row] = np.fmin(ends[row, 0], part.min()), np.fmax(ends[row, 1], part.max())
    return ends


def _binned(
    values: NDArray[Any],
    used: Sequence[Sequence[Span]],
    width: float,
    ends: tuple[float, float],
    *,
    is_cut: bool,
) -> FineCounts:
    """Count values in bins of a width between the ends; ``is_cut`` if values lie beyond."""
    begin, last_bin = (math.floor(end / width) for end in ends)
    bins = last_bin - begin + 1
    counts = np.zeros((len(used), bins + 1), np.int64)
    scale, shift = values.dtype.type(1.0 / width), values.dtype.type(begin)
    for row, spans in enumerate(used):
        for first, last in spans:
            for start in range(first, last, _CHUNK):
                place = values[start : min(start + _CHUNK, last)] * scale
                place -= shift
                if is_cut:
                    np.clip(place, 0, bins - 1, out=place)
                counts[row] += np.bincount(place.astype(np.int32), minlength=bins + 1)
    counts[:, -2] += counts[:, -1]  # rounding at the upper end
    return FineCounts(width, begin, counts[:, :-1])


def nice_width(width: float) -> float:
    """Return 1, 2 or 5 times a power of ten, at least ``width`` and a nanometre.

    >>> nice_width(0.0013), nice_width(0.004)
    (0.002, 0.005)
    """
    least = max(width, 1e-9) * (1.0 - 1e-9)
    power = 10.0 ** math.floor(math.log10(least))
    return next(float(f"{n * power:.12g}") for n in (1.0, 2.0, 5.0, 10.0) if n * power >= least)


# doubts ---------------------------------------------------------------------------------------------------------------


def _doubts(
    track: Track,
    corners: Mapping[str, CountedCorner],
    sections: Mapping[str, NDArray[np.intp]],
    stroke: float | None,
) -> Iterator[Finding]:
    """Tell what weakens the histograms: offsets, drift, ends of the travel, volts, standing still."""
    travels = {name: item.travel for name, item in corners.items() if item.travel is not None}
    for name, travel in travels.items():
        yield from _of_travel(track.name, corners[name], travel, stroke)
    for axle in ("front", "rear"):
        sides = [travels[name] for name in (f"{axle}_left", f"{axle}_right") if name in travels]
        medians = [side.quantile(0.5) for side in sides]
        if medians[1:] and abs(medians[0] - medians[1]) > _OFFSET * max(map(_usual, sides)):
            place, away = f"{track.name}: {axle}", medians[0] - medians[1]
            yield finding("dampers.offset", place, away, left=medians[0], right=medians[1])
    signals = [item.trace.travel for item in corners.values() if item.trace.travel is not None]
    if signals and len(sections) == 1:
        share = standing_share(signals, track.rate, _STANDS_BELOW)
        if share > _STANDS:
            yield finding("dampers.stands_still", track.name, share, share=share)


def _usual(travel: FineCounts) -> float:
    """Return the range of a travel without its rarest samples, m."""
    return travel.quantile(COVERED) - travel.quantile(1.0 - COVERED)


def _of_travel(
    name: str, counted: CountedCorner, travel: FineCounts, stroke: float | None
) -> Iterator[Finding]:
    place = f"{name}: {counted.trace.column}"
    least, most = (
        float(np.nanmin(counted.extremes[:, 0])),
        float(np.nanmax(counted.extremes[:, 1])),
    )
    if stroke is not None and most - least > stroke:
        code = "dampers.beyond_stroke"
        yield finding(code, place, most - least, extent=most - least, stroke=stroke)
    samples = travel.total / float(travel.total.sum())
    edge = max(1, round(0.01 * samples.size))
    for code, side, end in (
        ("dampers.at_upper_end", samples[::-1], most),
        ("dampers.at_lower_end", samples, least),
    ):
        share, beside = float(side[:edge].sum()), float(side[edge : 3 * edge].sum())
        if share > max(_PILES, beside):
            yield finding(code, place, share, share=share, end=end)
    first, last = (
        travel.counts[rows].sum(axis=0)
        for rows in np.array_split(np.arange(len(travel.counts)), 4)[::3]
    )
    if first.any() and last.any():
        change = travel.quantile(0.5, last) - travel.quantile(0.5, first)
        if abs(change) > _OFFSET * _usual(travel):
            yield finding("dampers.drifts", place, change, change=change)
    if counted.trace.unit == "mm" and least >= 0.0 and most <= _NARROW:
        yield finding("dampers.maybe_volts", place, most, most=most)
