"""All ride metrics of one recording, with a reason for each unavailable metric."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.errors import Clause, DescriptionError, RecordingError, nearest, unknown
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.text import align_columns
from jounce.core.units import positive_si, to_si
from jounce.parts import Rig
from jounce.recordings.carried import as_recording
from jounce.recordings.plausibility import implausible
from jounce.recordings.quality import check_time
from jounce.recordings.schema import check_recording, is_channel, quantity_of
from jounce.ride import comfort
from jounce.ride.catalogue import (
    CATALOGUE,
    USUAL_WEIGHTING,
    Acceleration,
    Choices,
    CornerSignals,
    Pair,
    Point,
    Scope,
    carries_passengers,
)
from jounce.ride.doubts import doubts
from jounce.ride.weighting import STARTS, Start, weighting

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


# available travel -----------------------------------------------------------------------------------------------------


Given = Any
_STOPS = ("rebound_stop.gap", "bump_stop.gap")


def by_corner(given: Given, corners: Sequence[str], where: str) -> dict[str, Pair]:
    """Return rebound and bump lengths (m) of every corner, from one value or pair, or a mapping by corner or axle."""
    if given is None:
        return {}
    if not isinstance(given, Mapping):
        pair = _pair(given, where)
        return dict.fromkeys(corners, pair)
    for key in given:
        if not any(key in (corner, _axle(corner)) for corner in corners):
            raise unknown(
                str(key), {*corners, *map(_axle, corners)} - {""}, what="corner", where=where
            )
    pairs = {}
    for corner in corners:
        for key in (corner, _axle(corner)):
            if key in given and corner not in pairs:
                pairs[corner] = _pair(given[key], f"{where}: {key}")
    return pairs


def gaps_of(rig: Rig | None, corners: Sequence[str]) -> dict[str, Pair]:
    """Return the gaps (m) of rebound and bump stop of every corner; None for a missing stop."""
    if rig is None:
        return {}
    numbers = rig.parameters()
    return {
        corner: (_gap(numbers, corner, _STOPS[0]), _gap(numbers, corner, _STOPS[1]))
        for corner in corners
    }


def _gap(numbers: Mapping[str, float], corner: str, stop: str) -> float | None:
    paths = [path for path in numbers if path.endswith(stop)]
    axle = _axle(corner)
    own = [path for path in paths if not axle or path.startswith(f"{axle}.")]
    return numbers[own[0]] if own else None


def _axle(corner: str) -> str:
    return corner.partition("_")[0]


def _pair(given: Any, where: str) -> Pair:
    if isinstance(given, (list, tuple)):
        if len(given) != 2:
            raise DescriptionError(
                "two values are required",
                where=where,
                found=given,
                allowed="rebound and bump travel, e.g. 0.06, 0.08",
            )
        rebound, bump = (
            None if value is None else to_si(value, "m", where=where) for value in given
        )
        return rebound, bump
    return None, to_si(given, "m", where=where)


# metrics --------------------------------------------------------------------------------------------------------------


_AXES = {"ax": "x", "ay": "y", "az": "z"}
_TURNS = {"roll_acceleration": "roll", "pitch_acceleration": "pitch", "yaw_acceleration": "yaw"}
_PARTS = (
    "strut.deflection",
    "strut.velocity",
    "strut.force",
    "strut.damper_force",
    "tyre.force",
    "tyre.deflection",
)
_OFFSET = 3.0  # standard deviations; a ride's mean acceleration is near zero, gravity at least 5


@dataclass(frozen=True)
class MetricValue:
    """Value of one metric at one place, in an SI unit.

    ``place`` is a channel (accelerations), a position (totals) or a corner (struts and tyres; "" for a quarter car).
    """

    metric: str
    place: str
    value: float
    unit: str
    label: str


@dataclass(frozen=True)
class AbsentMetric:
    """Metric that cannot be computed from this recording, with the reason; an empty place means everywhere."""

    metric: str
    place: str
    reason: str


@dataclass(frozen=True)
class RideMetrics(Shown):
    """Ride comfort, suspension travel and road holding of one recording.

    Attributes
    ----------
    values : tuple of MetricValue
        Values in the order of the catalogue, SI.
    absent : tuple of AbsentMetric
        Metrics that are not available, each with its reason.
    comfort : dict of str to str
        ISO 2631-1 description of the vibration total value, by place.
    duration : float
        Evaluated time, s.
    settling : float
        Time skipped at the start, s.
    sample_rate : float
        Sample rate, Hz.
    findings : tuple of Finding
        Warnings about the signals, and advice from the standard.
    """

    values: tuple[MetricValue, ...]
    absent: tuple[AbsentMetric, ...]
    comfort: dict[str, str]
    duration: float
    settling: float
    sample_rate: float
    findings: tuple[Finding, ...] = ()

    def value(self, metric: str, place: str | None = None) -> float:
        """Return the value of a metric in its SI unit; ``place`` may be omitted if there is only one.

        Raises
        ------
        RecordingError
            If the metric is not available; the message contains the reason.
        DescriptionError
            If a name or place is unknown, or the place is ambiguous.
        """
        if metric not in {row.name for row in CATALOGUE}:
            raise unknown(metric, (row.name for row in CATALOGUE), what="metric")
        values = {item.place: item.value for item in self.values if item.metric == metric}
        if place in values:
            return values[place]
        for item in self.absent:
            if item.metric == metric and place in (item.place, None) and not values:
                raise RecordingError(item.reason, where=metric)
        if place is None and len(values) == 1:
            return next(iter(values.values()))
        raise DescriptionError(
            "the place is ambiguous"
            if place is None
            else Phrase("no value at {place!r}", place=place),
            where=metric,
            allowed=", ".join(map(repr, values)),
            hint=nearest(place or "", values),
        )

    def __str__(self) -> str:
        left_out = f" ({self.settling:g} s left out)" if self.settling else ""
        lines = [f"Ride metrics of {self.duration:g} s at {self.sample_rate:g} Hz{left_out}"]
        scope = {row.name: row.scope for row in CATALOGUE}
        for kind in (("motion", "comfort"), ("rotation",), ("corner",)):
            lines += _table([item for item in self.values if scope[item.metric] in kind])
        for item in self.values:
            if scope[item.metric] == "point":
                lines.append(
                    f"{item.metric} {item.place}: {item.value:.4g} {item.unit}, {self.comfort[item.place]}"
                )
        return "\n".join([*lines, *_absences(self.absent), *map(str, self.findings)])


def ride_metrics(
    run: xr.Dataset | pd.DataFrame,
    rig: Rig | None = None,
    *,
    settling: float | str = 0.0,
    weighting: Mapping[str, str] | None = None,
    start: Start = "rest",
    travel: Given = None,
    stop_gap: Given = None,
    exposure: float | str = "8 h",
    lift_off_load: float | str = 0.0,
    metrics: Sequence[str] | None = None,
) -> RideMetrics:
    """Compute ride comfort, suspension travel and road holding of a simulated or measured recording.

    Parameters
    ----------
    run : xarray.Dataset or pandas.DataFrame
        Recording in SI on uniform time, or a table with columns ``name [unit]``. Accelerations are recognised by the
        suffixes of their names (``.az``, ``.pitch_acceleration``), corners by ``strut.deflection``, ``tyre.force`` and
        so on (``front_left.tyre.force``).
    rig : Rig, optional
        Rig or vehicle of the run; supplies the gaps of its stops unless ``stop_gap`` is given.
    settling : float or str
        Time skipped at the start (run-in, transient of the weightings), s or text with a unit.
    weighting : mapping of str to str, optional
        Weighting by channel or axis (``{"z": "Wf"}``) in place of Wk for z, Wd for x and y, We for rotations.
    start : {"rest", "first", "mean"}
        State before the record, as in `jounce.ride.weighting.weight`; ``"mean"`` for signals that include gravity.
    travel : pair of float or str, or mapping, optional
        Rebound and bump travel available from the mean deflection, m; for all corners, or by corner or axle.
    stop_gap : float or str, pair of them, or mapping, optional
        Deflection at which the bump stop makes contact, or a pair for rebound and bump stop, m; for all corners, or by
        corner or axle.
    exposure : float or str
        Daily duration of the vibration, s or text, for A(8).
    lift_off_load : float or str
        Wheel load up to which a tyre is considered lifted off, N; 0 is suitable for simulations.
    metrics : sequence of str, optional
        Names from the catalogue; by default all. A named metric that is not available is an error.

    Returns
    -------
    RideMetrics
        Values by metric and place, and unavailable metrics with reasons.

    Raises
    ------
    RecordingError
        If a Dataset is not a recording, time is not uniform, or the settling time exceeds the record.
    DescriptionError
        If a metric, weighting or corner is unknown, or a unit is incompatible.

    Notes
    -----
    Source: ISO 2631-1:1997 (``iso-2631-1``), ISO 8041-1:2017 (``iso-8041-1``); each row of
    `jounce.ride.catalogue.CATALOGUE` names its source and common confusions.

    Examples
    --------
    >>> import jounce as jn
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="3 s")
    >>> metrics = ride_metrics(jn.simulate(jn.load("kart-quarter-car"), trial))
    >>> round(metrics.value("weighted_rms"), 2), round(metrics.value("lift_off_time"), 3)
    (2.64, 0.027)
    """
    run = as_recording(run, where="run")
    rate, first, skipped = _time(run, settling)
    rows = {row.name: row for row in CATALOGUE}
    for name in metrics or ():
        if name not in rows:
            raise unknown(name, rows, what="metric", where="metrics")
    wanted = [row for row in CATALOGUE if metrics is None or row.name in metrics]
    names = [str(name) for name in run.data_vars]
    prefixes = [
        name.removesuffix(part) for name in names for part in _PARTS if is_channel(name, part)
    ]
    corners = tuple(
        dict.fromkeys(prefix.removesuffix(".") for prefix in prefixes)
    )  # "" for channels without a prefix
    if start not in STARTS:
        raise unknown(str(start), STARTS, what="start of the record", where="start")
    choices = Choices(
        settling=skipped,
        weighting=_weightings(weighting or {}, names),
        start=start,
        travel=by_corner(travel, corners, "travel"),
        stop_gap=by_corner(stop_gap, corners, "stop_gap")
        if stop_gap is not None
        else gaps_of(rig, corners),
        exposure=positive_si(exposure, "s", where="exposure"),
        lift_off_load=to_si(lift_off_load, "N", where="lift_off_load"),
    )
    views = _views(run, names, corners, rate, first, choices)
    values: list[MetricValue] = []
    absent: list[AbsentMetric] = []
    for row in wanted:
        # accelerations are selected by axis; points and corners use every row of their scope
        by_axis = row.scope not in ("point", "corner")
        parts = [
            (at, view)
            for at, view in views[row.scope]
            if not by_axis or at.rpartition(".")[2] in row.needs
        ]
        if not parts:
            absent.append(
                AbsentMetric(
                    row.name, "", Phrase("no channel {needs}", needs=" or ".join(row.needs))
                )
            )
        for place, view in parts:
            try:
                values.append(
                    MetricValue(row.name, place, float(row.formula(view)), row.unit, row.label)
                )
            except RecordingError as error:
                absent.append(AbsentMetric(row.name, place, Clause(error.message(within=place))))
        if metrics is not None and not any(item.metric == row.name for item in values):
            reason = next(item.reason for item in absent if item.metric == row.name)
            raise RecordingError(
                Phrase("the metric is not available: {reason}", reason=reason), where=row.name
            )
    totals = {item.place: item.value for item in values if item.metric == "vibration_total_value"}
    words = {place: comfort.comfort_words(value) for place, value in totals.items()}
    used = {
        name
        for row in wanted
        for name in names
        if any(is_channel(name, part) for part in row.needs)
    }
    signals = {
        name: run[name].to_numpy()[first:]
        for name in names
        if name in used and quantity_of(name) != "command"
    }
    findings = (
        *implausible(signals, 1.0 / rate, where=""),
        *doubts(
            {name: values for name, values in signals.items() if quantity_of(name) == "az"}, rate
        ),
        *_findings(views, values, {row.name for row in wanted}, rate, choices.exposure / 3600.0),
    )
    duration = (run["time"].size - 1 - first) / rate
    return RideMetrics(tuple(values), tuple(absent), words, duration, skipped, rate, findings)


def _time(run: xr.Dataset, settling: float | str) -> tuple[float, int, float]:
    """Return sample rate in Hz, index of the first evaluated sample, and skipped time in s."""
    check_recording(run)
    time = np.asarray(run["time"].values, dtype=float)
    if check_time(time, where="recording")[1]:
        hint = "Read the file with read_recording, or resample the signal."
        raise RecordingError(
            "the time steps are not uniform", where="recording", allowed="constant steps", hint=hint
        )
    duration = float(time[-1] - time[0])
    skipped = to_si(settling, "s", where="settling")
    if not 0.0 <= skipped < duration:
        raise RecordingError(
            "no part of the record remains",
            where="settling",
            found=f"{skipped:g} s",
            allowed=Phrase(
                "0 s up to less than {duration:g} s, the duration of the record", duration=duration
            ),
        )
    rate = (time.size - 1) / duration
    first = min(int(np.ceil(skipped * rate - 1e-6)), time.size - 2)
    return rate, first, skipped


def _weightings(given: Mapping[str, str], names: Sequence[str]) -> Mapping[str, str]:
    for key, name in given.items():
        if key not in (*names, *USUAL_WEIGHTING):
            raise unknown(
                key, (*names, *USUAL_WEIGHTING), what="channel or axis", where="weighting"
            )
        weighting(name)
    return given


Views = dict[Scope, list[tuple[str, Any]]]


def _views(
    run: xr.Dataset,
    names: Sequence[str],
    corners: Sequence[str],
    rate: float,
    first: int,
    choices: Choices,
) -> Views:
    """Return views of the recording by scope, each with its place."""
    signals = {name: np.asarray(run[name].values, dtype=float) for name in names}

    def motions(axes: Mapping[str, str]) -> Iterator[Acceleration]:
        for name, values in signals.items():
            axis = axes.get(name.rpartition(".")[2])
            if axis is not None:
                yield Acceleration(name, axis, values, rate, first, choices)

    linear = list(motions(_AXES))
    comfort_motions = [
        motion for motion in linear if carries_passengers(motion.channel.rpartition(".")[0])
    ]
    places: dict[str, dict[str, Acceleration]] = {}
    for motion in comfort_motions:
        places.setdefault(motion.channel.rpartition(".")[0], {})[motion.axis] = motion
    views: Views = {
        "motion": [(motion.channel, motion) for motion in linear],
        "rotation": [(motion.channel, motion) for motion in motions(_TURNS)],
        "comfort": [(motion.channel, motion) for motion in comfort_motions],
        "point": [(place, Point(place, axes)) for place, axes in places.items()],
        "corner": [],
    }
    for corner in corners:
        prefix = f"{corner}." if corner else ""
        own = {part: signals[prefix + part][first:] for part in _PARTS if prefix + part in signals}
        views["corner"].append((corner, CornerSignals(corner, own, rate, choices)))
    return views


def _findings(
    views: Views, values: Sequence[MetricValue], wanted: set[str], rate: float, hours: float
) -> Iterator[Finding]:
    weighted_metrics = wanted & {row.name for row in CATALOGUE if row.scope in ("comfort", "point")}
    for place, motion in views["comfort"] if weighted_metrics else ():
        yield from _about_signal(place, motion, rate)
        yield from _advice(place, motion)
    for item in values:
        if item.metric == "daily_exposure" and item.value > comfort.ACTION_VALUE:
            is_over = item.value > comfort.LIMIT_VALUE
            name, limit = (
                ("limit", comfort.LIMIT_VALUE) if is_over else ("action", comfort.ACTION_VALUE)
            )
            exposure = item.value
            code = "ride.daily_exposure"
            yield finding(
                code, item.place, exposure, hours=hours, exposure=exposure, name=name, limit=limit
            )
        if item.metric == "motion_sickness" and item.value > 1.0:
            yield finding("ride.sick_people", item.place, item.value, share=item.value)
    struts_without_damper = [corner for corner, view in views["corner"] if view.has("strut.force")]
    by_damper = any(view.has("strut.damper_force") for _, view in views["corner"])
    if "dissipated_power" in wanted and struts_without_damper and not by_damper:
        yield finding("ride.strut_power", ", ".join(filter(None, struts_without_damper)) or "strut")


def _about_signal(place: str, motion: Acceleration, rate: float) -> Iterator[Finding]:
    average, spread = float(motion.values.mean()), float(motion.values.std())
    if motion.choices.start == "rest" and abs(average) > _OFFSET * spread:
        yield finding("ride.offset", place, average, offset=average)
    row = weighting(motion.usual)
    if (
        rate < 2.0 * row.limits[2] and rate >= row.slowest_rate
    ):  # half the rate is within the weighting's band
        yield finding(
            "ride.sampled_slowly", place, rate, rate=rate, metric=row.name, highest=0.5 * rate
        )


def _advice(place: str, motion: Acceleration) -> tuple[Finding, ...]:
    """Return the standard's advice; empty if the record is too short for the weighting."""
    try:
        return comfort.advice(motion.filtered(), motion.rate, place=place)
    except RecordingError:
        return ()


# text -----------------------------------------------------------------------------------------------------------------


def _table(values: Sequence[MetricValue]) -> list[str]:
    """Format a table with a row per metric and a column per place."""
    places = list(dict.fromkeys(item.place for item in values))
    cells = {(item.metric, item.place): f"{item.value:.4g}" for item in values}
    names = {item.metric: item.unit for item in values}
    rows = [["", "", *places]] if any(places) else []
    rows += [
        [name, unit, *(cells.get((name, place), "–") for place in places)]
        for name, unit in names.items()
    ]
    return align_columns(rows, left=2)


def _absences(absent: Iterable[AbsentMetric]) -> list[str]:
    """Format one line per reason, with all affected metrics, and the places if not all are affected."""
    names: dict[tuple[str, tuple[str, ...]], list[str]] = {}
    places: dict[tuple[str, str], list[str]] = {}
    for item in absent:
        reason = (
            item.reason.replace(f"channel {item.place}.", "channel ") if item.place else item.reason
        )
        places.setdefault((item.metric, reason), []).append(item.place)
    for (metric, reason), corners in places.items():
        names.setdefault((reason, tuple(corners)), []).append(metric)
    lines = []
    for (reason, where), metrics in names.items():
        there = f" ({', '.join(where)})" if any(where) else ""
        lines.append(f"absent: {', '.join(metrics)}{there}: {reason}")
    return lines
