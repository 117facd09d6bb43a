"""Quality checks of a measured record: its time and each of its channels."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import RecordingError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.recordings.schema import quantity_of

LARGEST_JITTER = 0.01  # of the step: a phase error of 2 degrees at half the rate
OVER_RANGE = 1e20  # SI; loggers write 9.9e37 or 1e30 for missing values
ROUNDING = 1e-6  # of the step: time written with six digits
FEWEST_SAMPLES = 8  # fewer samples do not allow rate, noise or a trend to be estimated
CLIPPED_RUN = 3  # equal samples at a limit: two also occur at a turning point
FEWEST_CLIPPED = 6  # samples at a limit, i.e. two such runs: one may occur by chance
_NEVER_CLIPPED = {"slope", "command", "adhesion"}
_DRIVEN_PLACES = ("road", "platform")
_MAY_REST = (".road.z", "pitch_moment", "deceleration", "lateral_acceleration")
"""Suffixes of channels that remain 0 on a level road, or without braking or cornering."""


def row_number(row: int) -> str:
    """Name a row of numbers (counted from 0) when line numbers of the file are unknown."""
    return f"row {row + 1}"


def check_time(
    time: Array, *, where: str, name_row: Callable[[int], str] = row_number
) -> tuple[Array, list[Finding]]:
    """Check the time of a record and return uniform instants for it.

    Parameters
    ----------
    time : ndarray, shape (n,)
        Instants in s as recorded.
    where : str
        File named in errors and findings.
    name_row : callable
        Names a row (from 0) in errors, e.g. by its line in the file.

    Returns
    -------
    time : ndarray, shape (n,)
        Uniform instants in s, from the first to the last recorded instant. If there are no findings, the recorded time
        is already uniform, apart from rounding.
    findings : list of Finding
        One warning if the steps differ by more than rounding; the channels must then be resampled.

    Raises
    ------
    RecordingError
        If there are too few samples, values are not finite, time is all zero or not strictly increasing, or steps
        differ from the median step by more than 1 %. The message names the row.

    Examples
    --------
    >>> import numpy as np
    >>> time, findings = check_time(np.arange(10) * 0.001, where="a.csv")
    >>> len(findings)
    0
    """
    at = f"{where}: time"
    steps = check_instants(time, where=where, name_row=name_row)
    step = float(np.median(steps))
    jitter = np.abs(steps - step)
    largest = float(jitter.max()) / step
    if largest > LARGEST_JITTER:
        row = int(np.argmax(jitter)) + 1
        missing = round(float(steps[row - 1]) / step) - 1
        raise RecordingError(
            Phrase(
                "the time step jitters by {largest:.3g} % at {name_row}",
                largest=100.0 * largest,
                name_row=name_row(row),
            ),
            where=at,
            found=f"a step of {steps[row - 1]:.6g} s",
            allowed=Phrase("{step:.6g} s within 1 %", step=step),
            hint=f"{missing} sample{'s' * (missing > 1)} missing there; resample fills the gap and says so."
            if missing > 0
            else "Was time written with too few digits? resample converts the record to constant steps.",
        )
    uniform = np.linspace(time[0], time[-1], time.size)
    if largest <= ROUNDING + 4.0 * np.finfo(float).eps * float(np.abs(time).max()) / step:
        return uniform, []
    return uniform, [
        finding(
            "recordings.time_step_varies",
            at,
            largest,
            largest=largest,
            step=step,
            instants=time.size,
        )
    ]


def check_even(time: Array, *, where: str) -> Array:
    """Refuse instants (s), shape (n,), whose steps differ by more than 1 %: filters assume a constant rate.

    Arrays with fewer instants than the minimum of a record are not checked.
    """
    if time.size >= FEWEST_SAMPLES:
        check_time(time, where=where)
    return time


def check_instants(
    time: Array, *, where: str, name_row: Callable[[int], str] = row_number
) -> Array:
    """Refuse a time (s) with too few instants, or that is not finite, all zero or not increasing; return its steps."""
    at = f"{where}: time"
    _check_finite(time, at, name_row)
    if time.size > 1 and not np.any(time):
        raise RecordingError(
            "time is zero in every row", where=at, hint="Was the clock column exported?"
        )
    steps = check_ascending(time, "time", "s", where=at, name_row=name_row, hint=_CLOCK)
    if time.size < FEWEST_SAMPLES:
        raise RecordingError(
            "too few samples",
            where=at,
            found=str(time.size),
            allowed=Phrase("at least {fewest_samples}", fewest_samples=FEWEST_SAMPLES),
        )
    return steps


_CLOCK = (
    "A clock with too few digits, or one that jumped? Give the step of the samples (sample_time, --sample-time) if "
    "none are missing; where two records follow each other, cut them apart."
)


def check_ascending(
    values: Array,
    name: str,
    unit: str,
    *,
    where: str,
    name_row: Callable[[int], str] = row_number,
    hint: str = "",
) -> Array:
    """Refuse values that are not strictly increasing, naming the first such row; return their steps."""
    steps = np.diff(values)
    if np.any(steps <= 0.0):
        row = int(np.argmax(steps <= 0.0)) + 1
        raise RecordingError(
            Phrase("{name} does not increase at {name_row}", name=name, name_row=name_row(row)),
            where=where,
            found=f"{values[row]:.9g} {unit} after {values[row - 1]:.9g} {unit}",
            allowed=Phrase("strictly ascending {name}", name=name),
            hint=hint,
        )
    return np.asarray(steps, dtype=float)


def _check_finite(values: Array, at: str, name_row: Callable[[int], str]) -> None:
    if not values.size:
        return
    lowest, highest = float(values.min()), float(values.max())  # NaN if any value is
    if not math.isfinite(lowest) or not math.isfinite(highest):
        row = int(np.argmin(np.isfinite(values)))
        raise RecordingError(
            Phrase("not a finite number at {name_row}", name_row=name_row(row)),
            where=at,
            found=str(values[row]),
            hint="Fill the gap or cut off the rows.",
        )
    if (largest := max(-lowest, highest)) > OVER_RANGE:
        row = int(np.argmax(np.abs(values)))
        raise RecordingError(
            Phrase("implausible value at {name_row}", name_row=name_row(row)),
            where=at,
            found=f"{largest:g}",
            hint="Is it the code for a missing or over-range value?",
        )


def check_channels(
    channels: Mapping[str, Array],
    *,
    where: str,
    name_row: Callable[[int], str] = row_number,
    clipping: bool = True,
) -> list[Finding]:
    """Report channels whose signal is missing or incomplete.

    Parameters
    ----------
    channels : mapping of str to ndarray of shape (n,)
        Signals in SI by channel name.
    where : str
        File named in errors and findings.
    name_row : callable
        Names a row (from 0) in errors, e.g. by its line in the file.
    clipping : bool
        Also look for held, frozen and clipped values; only sensible for signals over time.

    Returns
    -------
    list of Finding
        A warning for each channel that is constant, holds each value for the same number of samples, has frozen
        stretches (see `frozen_samples`), or is clipped. A clipped channel has several runs of at least 3 equal samples
        at its maximum or minimum, entered by a jump. Runs at 0 or at the ends of the record are ignored, and so are
        inputs (``road``, ``platform``, braking and cornering).

    Raises
    ------
    RecordingError
        If a value is not finite. The message names row and channel.

    Examples
    --------
    >>> import numpy as np
    >>> wave = np.sin(np.arange(200) * 0.1)
    >>> [str(f) for f in check_channels({"sprung.az": np.clip(wave, -0.9, 0.9)}, where="a.csv")]
    ['warning: a.csv: sprung.az: the channel looks clipped: 22 % of its samples lie at its limits (-0.9 and 0.9)']
    """
    findings = []
    for name, values in channels.items():
        at = f"{where}: {name}"
        _check_finite(values, at, name_row)
        if values.size < 2:  # too few to say anything about
            continue
        if np.ptp(values) == 0.0:
            if values[0] == 0.0 and f".{name}".endswith(_MAY_REST):
                continue
            findings.append(finding("recordings.constant", at, values[0], value=values[0]))
        elif clipping and not (_is_driven(name) or quantity_of(name) in _NEVER_CLIPPED):
            findings += _holding(values, at) or [*_freezing(values, at), *_clipping(values, at)]
    return findings


def _is_driven(name: str) -> bool:
    """Whether a channel is an input of the rig: the road under any wheel, a shaker or manoeuvre loads."""
    return name.endswith(_MAY_REST) or any(
        part.startswith(_DRIVEN_PLACES) for part in name.split(".")
    )


def _holding(values: Array, at: str) -> list[Finding]:
    """Report a channel that holds each value for the same number of samples, and then jumps."""
    equal = int(np.count_nonzero(values[1:] == values[:-1]))
    count = values.size - equal - 2  # runs between the first and the last change
    if count < _FEWEST_HELD or 2 * (count - equal) > count:  # most runs are single samples
        return []
    steps = np.diff(values)
    changes = np.flatnonzero(steps)
    runs, jumps = np.diff(changes), np.abs(steps[changes])
    length = int(np.median(runs))
    # A slow signal that is merely quantised moves by single steps of its resolution.
    if (
        length < 2
        or np.mean(runs == length) < _HELD
        or np.median(jumps) < 1.5 * np.diff(np.unique(values)).min()
    ):
        return []
    return [finding("recordings.held", at, length, length=length, late=0.5 * (length - 1))]


_FEWEST_HELD, _HELD = (
    10,
    0.8,
)  # minimum number of runs, and fraction of equal length: random signals have only a few equal runs


def _freezing(values: Array, at: str) -> list[Finding]:
    stretches = frozen_stretches(values)
    if not stretches:
        return []
    frozen = sum(end - start for start, end in stretches)
    start, end = max(stretches, key=lambda stretch: stretch[1] - stretch[0])
    code = "recordings.frozen_again" if len(stretches) > 1 else "recordings.frozen"
    numbers = {"value": values[start], "length": end - start, "first": start + 1, "lost": frozen}
    return [finding(code, at, frozen / values.size, stretches=len(stretches), **numbers)]


def frozen_stretches(values: Array) -> list[tuple[int, int]]:
    """Find stretches in which a moving signal repeats one number; return the first sample and the one after the last.

    A stretch counts only if the signal moves right up to both ends, which makes chance an unlikely cause. A sensor at
    rest with noise below its resolution does not count: it enters and leaves rest by single steps. A tyre off the
    ground and a clipped sensor do not count either: they reach the end of their range without a jump.

    >>> noise = np.random.default_rng(0).normal(size=100).round(2)
    >>> noise[40:60] = 0.0
    >>> frozen_stretches(noise)
    [(40, 60)]
    """
    starts, ends = _runs(values, _FEWEST_FROZEN)
    if not starts.size:
        return []
    numbers = np.unique(values)
    lowest, highest = numbers[0], numbers[-1]
    resolution = max(float(np.diff(numbers).min()), _ROUNDED * float(highest - lowest))
    stretches = []
    for start, end in zip(starts.tolist(), ends.tolist(), strict=True):
        sides = values[:start][::-1], values[end:]
        if any(side.size < _BESIDE for side in sides):
            continue
        steps = [np.abs(np.diff(side[:_BESIDE])) for side in sides]
        still = max((np.count_nonzero(step == 0.0) + 1.0) / (step.size + 2.0) for step in steps)
        if still ** (end - start - 1) * values.size > _CHANCE or not all(
            _is_moving(side, resolution) for side in sides
        ):
            continue
        jumps = [abs(side[0] - values[start]) for side in sides]
        usual = [float(np.max(step[:5])) for step in steps]
        if values[start] in (lowest, highest) and not all(
            jump > _JUMP * step for jump, step in zip(jumps, usual, strict=True)
        ):
            continue
        stretches.append((start, end))
    return stretches


_FEWEST_FROZEN, _BESIDE = 8, 12  # minimum samples of a stretch, and those examined on each side
_CHANCE = 1e-6  # maximum probability that such a stretch occurs by chance anywhere in the record
_ROUNDED = 1e-9  # fraction of the range below which motion is rounding error
_JUMP = 3.0  # minimum jump into a stretch at an end of the range, in largest steps nearby


def _is_moving(beside: Array, resolution: float) -> bool:
    """Whether a signal moves next to a stretch (nearest sample first): by several resolution steps, or up and down.

    Alternation between two or three neighbouring numbers does not count: a constant value between them looks the same.
    """
    steps = np.diff(beside[:_BESIDE])
    turns = np.sign(steps[steps != 0.0])
    is_restless = (
        np.count_nonzero(np.diff(turns)) >= 3
        and np.unique(np.round(beside[:_BESIDE] / resolution)).size > 3
    )
    return (
        is_restless or float(np.median(np.abs(steps[:5]))) > 1.5 * resolution
    )  # two steps or more


def frozen_samples(values: Array) -> NDArray[np.bool_]:
    """Return a mask of the samples within `frozen_stretches` of a signal."""
    is_frozen = np.zeros(values.size, dtype=bool)
    for start, end in frozen_stretches(values):
        is_frozen[start:end] = True
    return is_frozen


def clipped_share(values: Array) -> float:
    """Return the fraction (1) of samples in flat runs at the limits of a record, entered by a jump; 0 for only a few.

    >>> round(clipped_share(np.clip(np.sin(np.arange(200) * 0.1), -0.9, 0.9)), 3)
    0.225
    """
    return sum(_clipping_limits(values).values()) / max(values.size, 1)


def _clipping_limits(values: Array) -> dict[float, int]:
    """Return the limits at which a record is clipped, with the number of samples at each."""
    reached = [
        float(end)
        for end in (values.min(), values.max())
        if np.count_nonzero(values == end) >= FEWEST_CLIPPED
    ]
    resolution = np.diff(np.unique(values)) if reached else np.empty(0)
    if not resolution.size:
        return {}
    smallest = float(resolution.min())
    limits = {
        limit: _flat_samples(values, limit, 1.5 * smallest, _rounding_at(values, limit))
        for limit in reached
    }
    return {
        limit: count for limit, count in limits.items() if count >= FEWEST_CLIPPED and limit != 0.0
    }


def _clipping(values: Array, at: str) -> list[Finding]:
    clipped = _clipping_limits(values)
    if not clipped:
        return []
    share = sum(clipped.values()) / values.size
    return [
        finding(
            "recordings.clipped",
            at,
            share,
            share=share,
            limits=" and ".join(f"{limit:g}" for limit in clipped),
        )
    ]


def _flat_samples(values: Array, limit: float, jump: float, rounding: float) -> int:
    """Count samples in inner runs at ``limit`` that are entered and left by a jump larger than ``jump``.

    A smooth top that was rounded is flat, too: as far before and after as the run is long, it is a few steps of
    rounding away from the limit.
    """
    starts, ends = _runs(values, CLIPPED_RUN)
    at_limit = values[starts] == limit
    starts, ends = starts[at_limit], ends[at_limit]
    steep = (np.abs(values[starts - 1] - limit) > jump) & (np.abs(values[ends] - limit) > jump)
    length = ends - starts
    before, after = (
        np.abs(values[np.clip(place, 0, values.size - 1)] - limit)
        for place in (starts - length, ends - 1 + length)
    )
    cut = np.maximum(before, after) > _ROUND_TOP * rounding
    return int(length[steep & cut].sum())


_ROUND_TOP = 12.0
"""Steps of rounding: a parabola that is flat over a run by half a step up and down falls four to eight beside it."""


def _rounding_at(values: Array, limit: float) -> float:
    """Return the step of rounding near a limit: numbers written with five digits are rounded more coarsely there."""
    levels = np.unique(values)
    near = levels[:_LEVELS] if limit == levels[0] else levels[-_LEVELS:]
    return min(float(np.diff(near).min()), _COARSEST * float(np.ptp(levels)))


_LEVELS = 9  # next to a limit, from which the step of rounding is told
_COARSEST = 1e-3  # of the range: a coarser step is one of the signal


def _runs(values: Array, fewest: int) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return start and end (exclusive) of each run of equal samples within the record, except at its ends."""
    is_equal = values[1:] == values[:-1]
    if not _has_run(is_equal, fewest - 1):
        return np.empty(0, np.intp), np.empty(0, np.intp)
    edges = np.flatnonzero(~is_equal) + 1
    starts, ends = edges[:-1], edges[1:]
    long = ends - starts >= fewest
    return starts[long], ends[long]


def _has_run(flags: NDArray[np.bool_], length: int) -> bool:
    """Whether that many flags in a row are set, anywhere.

    >>> [_has_run(np.array([True, True, True, False, True]), length) for length in (3, 4)]
    [True, False]
    """
    together = 1
    while together < length and flags.size:
        step = min(together, length - together)
        flags, together = flags[:-step] & flags[step:], together + step
    return bool(flags.any())
