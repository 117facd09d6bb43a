"""A record from the track: the travel of each damper in SI, its laps or sectors, and what cannot be used."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from jounce.core.columns import name_and_unit
from jounce.core.errors import DescriptionError, RecordingError, nearest
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import conversion_factor, to_si
from jounce.dampers.corners import (
    Match,
    Place,
    by_corner,
    corner_named,
    counter_in,
    guess_channels,
    match_of,
    speed_in,
)
from jounce.dampers.traces import Span, spans_of
from jounce.recordings.carried import as_recording
from jounce.recordings.files import read_mapped
from jounce.recordings.laps import find_laps, runs_of_numbers
from jounce.recordings.options import RecordFile
from jounce.recordings.quality import FEWEST_SAMPLES, LARGEST_JITTER, check_time

if TYPE_CHECKING:
    import xarray as xr

    from jounce.core.columns import Column
    from jounce.recordings.reader import SignalTable

Division = Literal["laps", "sectors", "whole"]
_MOST_GAPS = 1000  # stretches of missing samples, beyond which a channel is left out
_MOST_SECTIONS = 500
_SIGN_LOST = 1e-6  # of the largest velocity: rounding of a velocity that is never negative
_SAID_HERE = ("recordings.unknown_columns", "recordings.constant", "recordings.sign_lost")
"""Findings of the reader that are told here in other words, or do not matter."""


@dataclass(frozen=True)
class TrackOptions:
    """How records from the track are read; see `jounce.damper_histograms`."""

    channels: Mapping[str, str]
    division: Division
    sector_ends: tuple[float, ...]
    begin: float | None
    end: float | None
    measured_at: Place | None
    shown_at: Place | None
    motion_ratio: Mapping[str, float] | float | None
    reversed_corners: tuple[str, ...]
    reading: Mapping[str, Any]


@dataclass(frozen=True)
class CornerTrace:
    """Travel (m) or, without it, velocity (m/s) of one corner, compression positive; the samples that are missing."""

    corner: str
    column: str
    place: Place
    travel: Array | None
    velocity: Array | None
    missing: tuple[Span, ...]
    unit: str
    """Unit in the record, before it was converted."""
    highest: float
    """Frequency (Hz) up to which it was recorded."""


@dataclass(frozen=True)
class Track:
    """A record from the track at a constant rate (Hz), cut into sections by name."""

    name: str
    first: float
    rate: float
    count: int
    corners: Mapping[str, CornerTrace]
    sections: Mapping[str, tuple[Span, ...]]
    findings: tuple[Finding, ...]


def read_track(item: Any, options: TrackOptions) -> Track:
    """Read a record: a file, a recording with or without its findings, or a table.

    Raises
    ------
    RecordingError
        If it cannot be read, its steps are not constant, or no damper is found.
    """
    findings: list[Finding] = []
    matches: dict[str, Match] = {}
    if isinstance(item, str | Path):
        name = Path(item).name
        run, matches, findings = _read_file(item, options)
    else:
        run, given, name = _taken(item)
        findings += given
    run = _between(as_recording(run, where=name), options, name)
    rate = _rate(run, name)
    columns = [
        (str(key), str(variable.attrs.get("units", "")))
        for key, variable in run.data_vars.items()
        if variable.dims == ("time",) and variable.dtype.kind in "fiu"
    ]
    known = {(match.corner, match.is_velocity) for match in matches.values() if match.is_usable}
    chosen = _chosen(columns, options, name) if not matches else guess_channels(columns)
    matches |= {
        key: match
        for key, match in chosen.items()
        if (match.corner, match.is_velocity) not in known
    }
    usable = {key: match for key, match in matches.items() if match.is_usable}
    findings += _unusable(matches, usable, name)
    findings += _guesses(usable, options, name)
    corners = _corners(run, usable, rate, options, name, findings)
    if not corners:
        raise RecordingError(
            "no travel of a damper", where=name,
            found="; ".join(item.message for item in findings) or ", ".join(key for key, _ in columns) or "no channel",
            allowed="channels such as 'Damper FL [mm]' or 'front_left.damper.travel [m]'",
            hint="Name them: channels={'front_left': 'NAME [mm]'}, --channel front_left='NAME [mm]'.",
        )  # fmt: skip
    sections = _sections(run, columns, rate, options, name, findings)
    first = float(run["time"].to_numpy()[0])
    return Track(name, first, rate, run.sizes["time"], corners, sections, tuple(findings))


def _taken(item: Any) -> tuple[Any, Sequence[Finding], str]:
    """Return a recording that was read before, its findings and its name."""
    if isinstance(item, RecordFile):
        return item.data, item.findings, Path(item.path).name
    run, findings = item if isinstance(item, tuple) else (item, ())
    source = run.encoding.get("source", "recording") if hasattr(run, "encoding") else "recording"
    return run, findings, Path(str(source)).name


# files ----------------------------------------------------------------------------------------------------------------


def _read_file(
    path: str | Path, options: TrackOptions
) -> tuple[xr.Dataset, dict[str, Match], list[Finding]]:
    """Read a file, with the columns of dampers, laps and speed mapped to channels; return the channels of dampers."""
    name = Path(path).name
    matches: dict[str, Match] = {}
    findings: list[Finding] = []

    def choose(signals: SignalTable, *, with_counters: bool) -> dict[str, str]:
        known = {
            column.label: column
            for table in signals.tables
            for column in table
            if column.name != "time"
        }
        names = [(label, column.unit) for label, column in known.items()]
        matches.clear()
        findings.clear()
        for key, match in _chosen(names, options, name).items():
            column = known.get(match.column)
            if column is None or not match.is_usable or _is_whole(column, name, findings):
                matches[key] = match
        mapping = {key: match.column for key, match in matches.items() if match.is_usable}
        return mapping | (_counters(known) if with_counters else {})

    def read(*, with_counters: bool) -> tuple[xr.Dataset, list[Finding]]:
        return read_mapped(
            path, lambda signals: choose(signals, with_counters=with_counters), **options.reading
        )

    try:
        run, more = read(with_counters=options.division != "whole")
    except RecordingError:
        if options.division == "whole":
            raise
        run, more = read(with_counters=False)  # a counter at other instants must not cost the rest
    return run, matches, [*findings, *(item for item in more if item.code not in _SAID_HERE)]


def _counters(known: Mapping[str, Column]) -> dict[str, str]:
    """Map the columns that count laps and sectors, and the speed."""
    plain = [(column.name, column.unit) for column in known.values() if column.fault is None]
    by_name = {column.name: label for label, column in reversed(list(known.items()))}
    chosen = {f"{kind}.counts": counter_in(plain, kind) for kind in ("lap", "sector")}
    chosen["body.speed"] = speed_in(plain)
    return {key: by_name[name] for key, name in chosen.items() if name and name != key}


def _is_whole(column: Column, name: str, findings: list[Finding]) -> bool:
    """Whether a column has numbers only; tell why it is left out."""
    place = f"{name}: {column.name}"
    if column.fault is not None:
        findings.append(finding("dampers.channel_left_out", place, error=column.fault))
        return False
    missing = int(np.count_nonzero(~np.isfinite(column.values)))
    if missing:
        share = missing / column.values.size
        findings.append(finding("dampers.samples_missing", place, share, share=share))
    return not missing


# channels -------------------------------------------------------------------------------------------------------------


def _chosen(
    columns: Sequence[tuple[str, str]], options: TrackOptions, name: str
) -> dict[str, Match]:
    """Return the channels that are named, and for corners that are not, those guessed from their names."""
    plain = [(name_and_unit(label)[0], label, unit) for label, unit in columns]
    guessed = guess_channels([(bare, unit) for bare, _, unit in plain])
    labels = {bare: label for bare, label, _ in reversed(plain)}
    matches = {key: _renamed(match, labels[match.column]) for key, match in guessed.items()}
    for key, spec in options.channels.items():
        corner = corner_named(key, "channels")
        wanted, unit = name_and_unit(spec)
        known = next(
            ((label, own) for bare, label, own in plain if spec in (bare, label) or wanted == bare),
            None,
        )
        if known is None:
            raise RecordingError(
                Phrase("no column {key!r}", key=spec),
                where=name,
                found=", ".join(label for label, _ in columns),
                hint=nearest(wanted, [bare for bare, _, _ in plain]),
            )
        own = unit or known[1]
        as_named = match_of(f"{corner} damper {wanted}", own) or match_of(f"{corner} damper", own)
        if as_named is None:
            raise RecordingError(
                "not a travel or a velocity",
                where=f"{name}: {wanted}",
                found=own,
                allowed="a unit of length, of velocity, or volts",
            )
        column = known[0] if known[1] or not unit else f"{wanted} [{unit}]"
        place = options.measured_at or as_named.place
        match = Match(
            corner, column, as_named.is_velocity, place, as_named.electrical, as_named.lacks_unit
        )
        matches = {
            k: m
            for k, m in matches.items()
            if (m.corner, m.is_velocity) != (corner, match.is_velocity)
        }
        matches[match.channel] = match
    return matches


def _renamed(match: Match, column: str) -> Match:
    return Match(
        match.corner, column, match.is_velocity, match.place, match.electrical, match.lacks_unit
    )


def _unusable(
    matches: Mapping[str, Match], usable: Mapping[str, Match], name: str
) -> Iterator[Finding]:
    """Tell which channels are left out, for want of a calibration or a unit."""
    corners = {match.corner for match in usable.values()}
    for match in matches.values():
        if match.corner in corners or match.is_usable:
            continue
        place = f"{name}: {match.column}"
        if match.electrical:
            unit, corner = match.electrical, match.corner
            yield finding("dampers.not_calibrated", place, unit=unit, corner=corner)
        else:
            column, corner = match.column, match.corner
            yield finding("dampers.lacks_unit", place, column=column, corner=corner)


def _guesses(matches: Mapping[str, Match], options: TrackOptions, name: str) -> Iterator[Finding]:
    """Tell which columns were taken for which corners, if names alone decided it."""
    named = {corner_named(key, "channels") for key in options.channels}
    guessed = [
        match
        for match in matches.values()
        if match.corner not in named and not match.column.startswith(f"{match.corner}.")
    ]
    if guessed:
        words = ", ".join(f"{match.corner} = '{match.column}'" for match in guessed)
        yield finding("dampers.channels_guessed", name, len(guessed), channels=words)


def _corners(
    run: xr.Dataset,
    matches: Mapping[str, Match],
    rate: float,
    options: TrackOptions,
    name: str,
    findings: list[Finding],
) -> dict[str, CornerTrace]:
    """Return the signals of each corner, compression positive, at the place that is shown."""
    corners: dict[str, CornerTrace] = {}
    ratios = by_corner(
        options.motion_ratio, {match.corner for match in matches.values()}, "motion_ratio"
    )
    turned = {
        corner_named(text, "reversed") if text.lower() != "all" else "all"
        for text in options.reversed_corners
    }
    unknown_ratio: list[str] = []
    for match in sorted(matches.values(), key=lambda match: match.is_velocity):
        variable = run[match.column if match.column in run else match.channel]
        place = options.measured_at or match.place
        factor = _factor(match, variable, turned)
        shown = options.shown_at or place
        if shown != place:
            ratio = ratios.get(match.corner)
            if ratio is None:
                unknown_ratio.append(match.corner)
                shown = place
            else:
                factor *= ratio if shown == "damper" else 1.0 / ratio
        values = np.asarray(variable.to_numpy(), dtype=float)
        values = values if factor == 1.0 else values * factor
        where = f"{name}: {match.column}"
        values, missing = _without_gaps(values, where, findings)
        if missing is None:
            continue
        if match.is_velocity:
            known = corners.get(match.corner)
            if _lost_its_sign(values):
                code = "dampers.sign_lost" if known is None else "dampers.sign_lost_derived"
                findings.append(finding(code, where, corner=match.corner))
                continue
            if known is not None:
                continue
        own = float(variable.attrs.get("recorded_rate", rate))
        unit = name_and_unit(match.column)[1] or str(variable.attrs.get("units", ""))
        travel, velocity = (None, values) if match.is_velocity else (values, None)
        corners[match.corner] = CornerTrace(
            match.corner, match.column, shown, travel, velocity, missing, unit, 0.5 * min(own, rate)
        )
    if unknown_ratio:
        findings.append(finding("dampers.no_motion_ratio", name, corners=", ".join(unknown_ratio)))
    return corners


def _factor(match: Match, variable: xr.DataArray, turned: set[str]) -> float:
    unit = str(variable.attrs.get("units", ""))
    factor = conversion_factor(unit, "m/s" if match.is_velocity else "m", where=match.column)
    is_turned = bool(turned & {"all", match.corner, match.corner.partition("_")[0]})
    return -factor if is_turned else factor


def _without_gaps(
    values: Array, where: str, findings: list[Finding]
) -> tuple[Array, tuple[Span, ...] | None]:
    """Bridge missing samples by lines, and return where they are; None if there are too many."""
    if math.isfinite(float(values.sum())):
        return values, ()
    finite = np.isfinite(values)
    gaps = spans_of(~finite)
    share = 1.0 - float(finite.mean())
    if len(gaps) > _MOST_GAPS or np.count_nonzero(finite) < FEWEST_SAMPLES:
        findings.append(finding("dampers.samples_missing", where, share, share=share))
        return values, None
    findings.append(finding("dampers.gaps", where, share, share=share, gaps=len(gaps)))
    bridged = values.copy()
    lost, known = np.flatnonzero(~finite), np.flatnonzero(finite)
    bridged[lost] = np.interp(lost, known, values[known])
    return bridged, tuple(gaps)


def _lost_its_sign(velocity: Array) -> bool:
    """Whether a velocity is never negative, or never positive, although a damper returns."""
    low, high = float(velocity.min()), float(velocity.max())
    largest = max(-low, high)
    return largest > 0.0 and min(high, -low) < _SIGN_LOST * largest


# time -----------------------------------------------------------------------------------------------------------------


def _between(run: xr.Dataset, options: TrackOptions, name: str) -> xr.Dataset:
    """Cut a record to the time (s) that is asked for."""
    if options.begin is None and options.end is None:
        return run
    time = run["time"].to_numpy()
    low = float(time[0]) if options.begin is None else options.begin
    high = float(time[-1]) if options.end is None else options.end
    first, last = np.searchsorted(time, (low, high), side="left")
    if last - first < FEWEST_SAMPLES:
        raise RecordingError(
            "the section has too few samples",
            where=name,
            found=f"{low:g} s to {high:g} s",
            allowed=Phrase("{first:g} s to {last:g} s", first=float(time[0]), last=float(time[-1])),
        )
    return run.isel(time=slice(int(first), int(last) + 1))


def _rate(run: xr.Dataset, name: str) -> float:
    """Return the sample rate (Hz); refuse time whose steps are not constant."""
    if "time" not in run.coords:
        raise RecordingError("no time coordinate", where=name, allowed="a coordinate 'time' in s")
    time = np.asarray(run["time"].to_numpy(), dtype=float)
    if time.size >= FEWEST_SAMPLES:
        steps = time[1:] - time[:-1]
        mean = float(time[-1] - time[0]) / (time.size - 1)
        even = LARGEST_JITTER * mean
        if steps.min() > mean - even and steps.max() < mean + even:
            return 1.0 / mean
    check_time(time, where=name)  # raises the reason
    return (time.size - 1) / float(time[-1] - time[0])


def _sections(
    run: xr.Dataset,
    columns: Sequence[tuple[str, str]],
    rate: float,
    options: TrackOptions,
    name: str,
    findings: list[Finding],
) -> dict[str, tuple[Span, ...]]:
    """Return the laps or sectors of a record, after the whole of it; if they are unknown, tell why."""
    whole: dict[str, tuple[Span, ...]] = {"whole": ((0, run.sizes["time"]),)}
    if options.division == "whole":
        return whole
    laps = _laps(run, columns, rate)
    if options.division == "sectors":
        sectors, why = _sectors(run, columns, rate, laps, options)
        if sectors:
            return whole | sectors
        findings.append(finding("dampers.no_sectors", name, why=why))
    if not laps:
        if options.division == "laps":
            findings.append(finding("dampers.no_laps", name))
        return whole
    if len(laps) > _MOST_SECTIONS:
        findings.append(finding("dampers.too_many_laps", name, len(laps), laps=len(laps)))
        return whole
    return whole | {f"lap {number}": (span,) for number, span in laps.items()}


def _laps(run: xr.Dataset, columns: Sequence[tuple[str, str]], rate: float) -> dict[int, Span]:
    """Return the samples of each complete lap: between lap markers, or of one number of a lap counter."""
    time = np.asarray(run["time"].to_numpy(), dtype=float)

    def span(begin: float, end: float) -> Span:
        first, last = (int(np.ceil((at - time[0]) * rate - 1e-6)) for at in (begin, end))
        return first, last

    try:
        ends = find_laps(run)
        if len(ends):
            return {k + 1: span(*lap) for k, lap in enumerate(ends.tolist())}
    except RecordingError:
        pass
    counter = _counter(run, columns, "lap")
    if counter is None:
        return {}
    laps: dict[int, Span] = {}
    for number, begin, end in runs_of_numbers(time, counter):
        laps.setdefault(number, span(begin, end))
    return laps


def _counter(run: xr.Dataset, columns: Sequence[tuple[str, str]], kind: str) -> Array | None:
    name = f"{kind}.counts" if f"{kind}.counts" in run else counter_in(columns, kind)
    if not name:
        return None
    values = np.asarray(run[name].to_numpy(), dtype=float)
    return values if np.isfinite(values).all() else None


def _sectors(
    run: xr.Dataset,
    columns: Sequence[tuple[str, str]],
    rate: float,
    laps: Mapping[int, Span],
    options: TrackOptions,
) -> tuple[dict[str, tuple[Span, ...]], str]:
    """Return the samples of each sector in all laps; without them, a word for what is missing."""
    spans: dict[int, list[Span]] = {}
    if options.sector_ends:
        speed = speed_in(columns)
        if not laps or not speed:
            return {}, "laps" if not laps else "speed"
        unit = str(run[speed].attrs.get("units", "m/s"))
        speeds = np.asarray(run[speed].to_numpy(), dtype=float) * conversion_factor(unit, "m/s")
        for first, last in laps.values():
            distance = np.cumsum(np.abs(speeds[first:last])) / rate
            ends = [first + int(k) for k in np.searchsorted(distance, options.sector_ends)]
            for number, (begin, end) in enumerate(zip([first, *ends], [*ends, last], strict=True)):
                if end > begin:
                    spans.setdefault(number + 1, []).append((begin, end))
    else:
        counter = _counter(run, columns, "sector")
        if counter is None:
            return {}, "channel"
        whole = np.rint(counter)
        numbers = np.unique(whole)
        if not 1 < numbers.size <= _MOST_SECTIONS:
            return {}, "channel"
        for number in numbers.tolist():
            spans[int(number)] = spans_of(whole == number)
    return {f"sector {number}": tuple(spans[number]) for number in sorted(spans)}, ""


def distances(values: Sequence[float | str] | None, where: str) -> tuple[float, ...]:
    """Read distances (m), which must ascend."""
    ends = tuple(to_si(value, "m", where=where) for value in values or ())
    if any(second <= first for first, second in pairwise((0.0, *ends))):
        raise DescriptionError(
            "the distances do not ascend",
            where=where,
            found=", ".join(f"{end:g} m" for end in ends),
        )
    return ends
