"""Speeds at which a ride reaches its limits: absorbed power, shock, travel and velocity over obstacles and roads."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import pairwise
from typing import Annotated, Any

import numpy as np

from jounce.core.errors import DescriptionError, SimulationError
from jounce.core.findings import Finding, finding
from jounce.core.operation import Count, File, Number, Pairs, Texts, operation
from jounce.core.serialise import Plain
from jounce.core.types import Array
from jounce.core.units import positive_si, to_si
from jounce.core.waiting import progress_through
from jounce.parts import FullCar, FullCar3D, Rig, Vehicle, as_rig
from jounce.parts.options import AnyRig
from jounce.parts.vehicles import track_width
from jounce.recordings.schema import channels_of
from jounce.ride.absorbed_power import POWER_LIMIT, SHOCK_LIMIT
from jounce.ride.study import RideTrial, road_trial
from jounce.roads import Iso8608, Road, Trial, load_road
from jounce.roads.loading import class_and_seed, is_class
from jounce.roads.trial import FASTEST
from jounce.simulation import simulate
from jounce.simulation.compiled import compile_rig
from jounce.variants.metrics import RunMetric, check_durations, of_courses, read_metrics

_STEP = 1e-3  # s: output step of a run
_RUN_IN = 10.0  # m over which a random road fades in and out
_AFTER = 2.0  # s after an obstacle, in which the body comes to rest
_EXACT = 2e-3  # of a speed: how closely a crossing is found
_TRIES = 40  # runs for one crossing at most
_NEAR = (
    1.0  # of the rise to its neighbours: a turning value as near to the limit is looked at closely
)
_LOOKS = 12  # runs of such a look
_GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)
_BODY = ("body.az", "sprung.az")
Progress = Callable[[str], None]


@dataclass(frozen=True)
class Crossing(Plain):
    """A speed at which a metric passes its limit.

    Attributes
    ----------
    speed : float
        Speed, m/s.
    is_exceeded_above : bool
        Whether the limit is exceeded above this speed; False where the metric is within it again.
    """

    speed: float
    is_exceeded_above: bool


@dataclass(frozen=True)
class LimitCurve(Plain):
    """A metric over speed, with its limit.

    Attributes
    ----------
    metric : str
        Metric with its channel.
    unit : str
        SI unit of values and limit.
    limit : float
        The limit; a lower one for metrics that begin with ``min``.
    height : float or None
        Height of the obstacle, m; None for the road as it is.
    speed, values : array (n,)
        Speeds that were driven, m/s, ascending, and the metric; NaN where a run failed.
    crossings : tuple of Crossing
        All crossings that were found, by speed.
    """

    metric: str
    unit: str
    limit: float
    height: float | None
    speed: Array
    values: Array
    crossings: tuple[Crossing, ...]

    @property
    def limit_speed(self) -> float | None:
        """Lowest speed (m/s) at which the limit is reached; None if it is kept up to the fastest.

        The slowest speed if the limit is exceeded there already.
        """
        known = np.flatnonzero(np.isfinite(self.values))
        if len(known) and excess_over(self.metric, self.values[known[0]], self.limit) > 0.0:
            return float(self.speed[known[0]])
        return next((item.speed for item in self.crossings if item.is_exceeded_above), None)


@dataclass(frozen=True)
class SpeedLimits(Plain):
    """Speeds up to which limits are kept.

    Attributes
    ----------
    curves : tuple of LimitCurve
        One for each height of the obstacle and each metric.
    findings : tuple of Finding
        Several crossings, limits that are never reached or always exceeded, runs that failed.
    """

    curves: tuple[LimitCurve, ...]
    findings: tuple[Finding, ...]

    @property
    def heights(self) -> tuple[float | None, ...]:
        """Heights of the obstacle, m; (None,) for the road as it is."""
        return tuple(dict.fromkeys(curve.height for curve in self.curves))

    def limit_speed(self, height: float | None = None) -> float | None:
        """Return the speed (m/s) up to which all limits are kept; None if they are up to the fastest.

        Parameters
        ----------
        height : float, optional
            Height of the obstacle, m, one of ``heights``; None for the road as it is.

        Raises
        ------
        DescriptionError
            If this height was not driven.
        """
        if height not in self.heights:
            raise DescriptionError(
                "no such height was driven",
                where="height",
                found=str(height),
                allowed=", ".join(map(str, self.heights)),
            )
        speeds = [curve.limit_speed for curve in self.curves if curve.height == height]
        return min((speed for speed in speeds if speed is not None), default=None)

    @property
    def is_met(self) -> bool:
        """Whether every curve has a value."""
        return all(np.isfinite(curve.values).any() for curve in self.curves)

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI, with the lowest limit speed for each height."""
        lowest = [
            {"height": height, "limit_speed": self.limit_speed(height)} for height in self.heights
        ]
        return {**super().to_dict(), "lowest": lowest}

    def table(self) -> str:
        """Write all values over speed as CSV, SI."""
        lines = ["metric,unit,limit,height [m],speed [m/s],value"]
        for curve in self.curves:
            height = "" if curve.height is None else f"{curve.height:.9g}"
            lines += [
                f"{curve.metric},{curve.unit},{curve.limit:.9g},{height},{speed:.9g},"
                + ("" if math.isnan(value) else f"{value:.9g}")
                for speed, value in zip(curve.speed, curve.values, strict=True)
            ]
        return "\n".join(lines) + "\n"


@operation(
    "speed-limit",
    named={"rig": "vehicle", "changes": "set", "limits": "limit", "heights": "height"},
    echo={"vehicle": "vehicle", "changes": "set", "road": "road", "seed": "seed"},
    offers=("table", "figure", "report"),
    page="jounce.report.speed_limits:speed_limits_page",
    title="Speed limits of {vehicle} on {road}",
    doing="driving",
    example='jounce speed-limit audi-a6-full-car --road iso:E --slowest "2 m/s" --fastest "25 m/s"',
)
def find_speed_limits(
    rig: AnyRig,
    road: Annotated[
        str | Road,
        File(
            "A class of ISO 8608 (iso:A to iso:H), a road file, or a name of `jounce library`.",
            shipped=("roads",),
        ),
    ],
    limits: Annotated[
        Mapping[str, float | str] | None,
        Pairs(
            'Metric and its limit, e.g. "absorbed_power body.az"="6 W". Repeat it. Default: 6 W on roads, 2.5 g of '
            "shock over obstacles.",
            "METRIC=LIMIT",
            '"absorbed_power body.az"="6 W"',
        ),
    ] = None,
    *,
    slowest: Annotated[
        float | str, Number('Lowest speed, e.g. "2 m/s".', "SPEED", "m/s", is_positive=True)
    ] = 2.0,
    fastest: Annotated[
        float | str, Number('Highest speed, e.g. "100 km/h".', "SPEED", "m/s", is_positive=True)
    ] = 30.0,
    heights: Annotated[
        Sequence[float | str] | None,
        Texts('Height of the obstacle, e.g. "150 mm". Repeat it.', "HEIGHT"),
    ] = None,
    points: Annotated[int, Count("Speeds of the first look.", least=3, most=400)] = 25,
    length: Annotated[
        float | str,
        Number('Length of a road of ISO 8608, e.g. "300 m".', "LENGTH", "m", is_positive=True),
    ] = 300.0,
    seed: Annotated[int, Count("Seed of the random road.", least=0)] = 0,
    progress: Progress = lambda _: None,
) -> SpeedLimits:
    """Find the speeds at which limits are reached: absorbed power, shock, travel, or any metric of a run.

    Every speed drives the same metres of road. The speeds between ``slowest`` and ``fastest`` are driven first; then
    every crossing of a limit is closed in, and every turning point near a limit is looked at. All crossings are
    reported, since a metric need not grow with speed.

    Parameters
    ----------
    rig : Rig, str or Path
        Rig or vehicle, its file or its name in the library.
    road : str or Road
        A class of ISO 8608 (``"iso:E"``, with a seed ``"iso:E:7"``), a road file, its name in the library, or a road.
    limits : mapping of str to float or str, optional
        Metric, as for :func:`jounce.simulate_many` (``"absorbed_power body.az"``, ``"shock body.az"``,
        ``"max strut.deflection"``, ``"peak strut.velocity"``), and its limit, SI or with a unit. That of a metric with
        ``min`` is a lower one. Default: 6 W of absorbed power of the body on roads, 2.5 g of shock over obstacles.
    slowest, fastest : float or str
        Range of speeds, m/s.
    heights : sequence of float or str, optional
        Heights of the obstacle, m, which replace its own: the speed over height is the obstacle curve of the NATO
        mobility tradition.
    points : int
        Speeds of the first look, 3 to 400, in equal ratios. What rises above a limit and falls again between two of
        them, without coming near it at one, is not seen.
    length : float or str
        Length of a road of ISO 8608, m.
    seed : int
        Seed of the random road, 0 or more.
    progress : callable
        Receives a message for each speed of the first look.

    Returns
    -------
    SpeedLimits
        Curves, crossings and limit speeds, SI. Power and r.m.s. are means over the road; over an obstacle they are
        means until 2 s after it, and depend on this time.

    Raises
    ------
    DescriptionError
        For unknown roads and metrics, heights of a road that has none, and numbers out of range.
    SimulationError
        If no run reaches its end.

    Notes
    -----
    6 W and 2.5 g are the ride and the shock limit of the NATO Reference Mobility Model (``haley-1979``); the filters
    are those of :func:`jounce.absorbed_power` and :func:`jounce.ride.absorbed_power.shock`.

    Examples
    --------
    >>> import jounce as jn
    >>> bump = jn.HalfSine(height="60 mm", length="1 m")
    >>> found = find_speed_limits("audi-a6-quarter-car", bump, {"shock sprung.az": "9 m/s^2"}, fastest=20.0, points=7)
    >>> found.curves[0].crossings[0].is_exceeded_above, 3.0 < found.limit_speed() < 12.0
    (True, True)
    """
    rig = as_rig(rig)
    slow, fast = (
        positive_si(slowest, "m/s", where="slowest"),
        positive_si(fastest, "m/s", where="fastest"),
    )
    if not slow < fast:
        raise DescriptionError(
            "no range of speeds",
            where="slowest, fastest",
            found=f"{slow:g} to {fast:g} m/s",
            allowed="slowest below fastest",
        )
    if not 3 <= points <= _MOST_POINTS:
        raise DescriptionError(
            "out of range", where="points", found=points, allowed=f"3 to {_MOST_POINTS}"
        )
    roads = _roads_of(road, heights, positive_si(length, "m", where="length"), seed, slow, rig)
    metrics = _metrics_of(rig, limits, is_course=next(iter(roads.values())).is_course())
    grid = np.geomspace(slow, fast, points)
    curves: list[LimitCurve] = []
    findings: list[Finding] = []
    done, every = 0, len(roads) * points
    for height, driven in roads.items():
        runs = _Runs(rig, driven, tuple(metrics))
        for speed in grid:
            done += 1
            progress(
                progress_through(
                    "driving {which} of {count}: {name}", done, every, name=f"{speed:.3g} m/s"
                )
            )
            runs.at(float(speed))
        if runs.failed and not any(np.isfinite(row).any() for row in runs.values.values()):
            raise runs.failed[min(runs.failed)]
        for k, (metric, limit) in enumerate(metrics.items()):
            crossings = find_crossings(partial(_excess_at, runs, k, metric.text, limit), grid)
            speeds = np.array(sorted(runs.values))
            values = np.array([runs.values[speed][k] for speed in speeds])
            curve = LimitCurve(
                metric.text, metric.unit, limit, height, speeds, values,
                tuple(Crossing(*crossing) for crossing in crossings),
            )  # fmt: skip
            curves.append(curve)
            findings += _findings_of(curve)
        for speed, error in sorted(runs.failed.items()):
            findings.append(
                finding("variants.speed_failed", _place(height), speed, speed=speed, error=error)
            )
    return SpeedLimits(tuple(curves), tuple(findings))


_MOST_POINTS = 400


def _excess_at(runs: _Runs, k: int, metric: str, limit: float, speed: float) -> float:
    return excess_over(metric, runs.at(speed)[k], limit)


def excess_over(metric: str, value: float, limit: float) -> float:
    """Return by how much a value exceeds its limit, in its unit; the limit of ``min`` is a lower one.

    >>> excess_over("max sprung.az", 3.0, 2.0), excess_over("min tyre.force", 3.0, 2.0)
    (1.0, -1.0)
    """
    return float(limit - value if metric.startswith("min ") else value - limit)


def find_crossings(excess: Callable[[float], float], grid: Array) -> list[tuple[float, bool]]:
    """Find where a function passes zero between the ends of a grid, also where it only just does.

    Parameters
    ----------
    excess : callable
        Function of the abscissa, positive where a limit is exceeded; NaN where it is unknown.
    grid : array (n,)
        Ascending abscissas of the first look.

    Returns
    -------
    list of (float, bool)
        Abscissa of each crossing, and whether the function is positive above it.

    Examples
    --------
    >>> found = find_crossings(lambda x: (x - 2.03) * (4.0 - x), np.linspace(1.0, 5.0, 5))
    >>> [(round(x, 1), is_positive_above) for x, is_positive_above in found]
    [(2.0, True), (4.0, False)]
    """
    points = [(float(x), excess(float(x))) for x in grid]
    inside: list[tuple[float, float]] = []
    for before, here, after in zip(points, points[1:], points[2:], strict=False):
        inside += _look_at_turn(excess, before, here, after)
    points = sorted({*points, *inside})
    crossings = []
    for (a, at_a), (b, at_b) in pairwise(points):
        if (at_a > 0.0) != (at_b > 0.0) and math.isfinite(at_a) and math.isfinite(at_b):
            crossings.append((_close_in(excess, (a, at_a), (b, at_b)), at_b > 0.0))
    return crossings


def _look_at_turn(
    excess: Callable[[float], float],
    before: tuple[float, float],
    here: tuple[float, float],
    after: tuple[float, float],
) -> list[tuple[float, float]]:
    """Search a turning point near zero for a place beyond it, by golden section; return the place."""
    sides = before[1], here[1], after[1]
    sign = 1.0 if here[1] <= 0.0 else -1.0  # a summit below zero, or a valley above it
    towards = [sign * side for side in sides]
    rise = towards[1] - min(towards[0], towards[2])
    is_turn = towards[1] >= max(towards[0], towards[2])
    if not all(map(math.isfinite, sides)) or not is_turn or -towards[1] > _NEAR * rise:
        return []
    low, high = before[0], after[0]
    inner = [high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)]
    values = [sign * excess(x) for x in inner]
    for _ in range(_LOOKS):
        for x, value in zip(inner, values, strict=True):
            if value > 0.0:
                return [(x, sign * value)]
        if values[0] > values[1]:
            high, inner[1], values[1] = inner[1], inner[0], values[0]
            inner[0] = high - _GOLDEN * (high - low)
            values[0] = sign * excess(inner[0])
        else:
            low, inner[0], values[0] = inner[0], inner[1], values[1]
            inner[1] = low + _GOLDEN * (high - low)
            values[1] = sign * excess(inner[1])
    return []


def _close_in(
    excess: Callable[[float], float], low: tuple[float, float], high: tuple[float, float]
) -> float:
    """Find the zero between two abscissas of unlike signs, by the Illinois rule; a gap ends the search."""
    (a, at_a), (b, at_b) = low, high
    for _ in range(_TRIES):
        if b - a <= _EXACT * b:
            break
        middle = b - at_b * (b - a) / (at_b - at_a)
        middle = min(max(middle, a + 0.05 * (b - a)), b - 0.05 * (b - a))
        value = excess(middle)
        if value == 0.0:
            return middle
        if not math.isfinite(value):
            break
        if (value > 0.0) == (at_b > 0.0):
            b, at_b, at_a = middle, value, 0.5 * at_a
        else:
            a, at_a, at_b = middle, value, 0.5 * at_b
    return 0.5 * (a + b)


class _Runs:
    """Metrics of one rig on one road by speed; every speed is driven once."""

    def __init__(self, rig: Rig, road: Road, metrics: Sequence[RunMetric]) -> None:
        self.rig, self.road, self.metrics = rig, road, metrics
        self.values: dict[float, list[float]] = {}
        self.failed: dict[float, SimulationError] = {}

    def at(self, speed: float) -> list[float]:
        """Return all metrics at a speed (m/s); NaN if the run fails."""
        if speed not in self.values:
            try:
                self.values[speed] = self._drive(speed)
            except SimulationError as error:
                self.failed[speed] = error
                self.values[speed] = [math.nan] * len(self.metrics)
        return self.values[speed]

    def _drive(self, speed: float) -> list[float]:
        ride = _trial_at(self.rig, self.road, speed)
        run = simulate(self.rig, ride.trial, output_step=_STEP)
        check_durations(self.metrics, [ride.trial.duration - ride.settling])
        first = round(ride.settling / _STEP)
        numbers = []
        for metric in self.metrics:
            samples = run[metric.channel].to_numpy()
            rest = samples[:1]
            course = (samples - rest)[None, :]
            numbers.append(float(of_courses(metric, course, rest, _STEP, first)[0]))
        return numbers


def _trial_at(rig: Rig, road: Road, speed: float) -> RideTrial:
    """Return the trial of a whole road or obstacle at a speed (m/s), and the time that does not count (s)."""
    behind = rig.wheelbase if isinstance(rig, Vehicle) else 0.0
    if isinstance(road, Iso8608) and road.run_in:
        right = road.other_track() if isinstance(rig, FullCar | FullCar3D) else None
        lasting = _whole_steps((road.length - road.run_in) / speed)
        trial = Trial(road=road, right=right, speed=speed, duration=lasting)
        return RideTrial(trial, _whole_steps((road.run_in + behind) / speed))
    if road.is_course():
        return road_trial(rig, road, speed)
    lasting = _whole_steps((road.end() + behind) / speed + _AFTER)
    return RideTrial(Trial(road=road, speed=speed, duration=lasting), 0.0)


def _whole_steps(time: float) -> float:
    return math.ceil(time / _STEP - 1e-6) * _STEP


def _roads_of(
    road: str | Road,
    heights: Sequence[float | str] | None,
    length: float,
    seed: int,
    slowest: float,
    rig: Rig,
) -> dict[float | None, Road]:
    """Return the roads to drive by the height of their obstacle (m); None for the road as it is."""
    given = _road_of(road, length, seed, slowest, rig)
    if not heights:
        return {None: given}
    wanted = [positive_si(height, "m", where="heights") for height in heights]
    return {height: _with_height(given, height) for height in sorted(set(wanted))}


def _road_of(road: str | Road, length: float, seed: int, slowest: float, rig: Rig) -> Road:
    """Read a road; a class of ISO 8608 is fine enough for the slowest speed (m/s), at which wheels hop, too."""
    if isinstance(road, Road):
        return road
    if not is_class(road):
        return load_road(road)
    name, own = class_and_seed(str(road))
    if own is not None and seed not in (0, own):
        raise DescriptionError(
            "two different seeds are given",
            where="--seed",
            found=f"{seed}, and {own} in --road {road}",
        )
    behind = rig.wheelbase if isinstance(rig, Vehicle) else 0.0
    made = Iso8608(
        class_=name,
        length=length + behind + 2.0 * _RUN_IN,
        step=min(0.05, slowest / (2.0 * FASTEST)),
        seed=seed if own is None else own,
        run_in=_RUN_IN,
    )
    if isinstance(rig, FullCar | FullCar3D):
        made = made.model_copy(update={"track": track_width(rig)})
    return made


def _with_height(road: Road, height: float) -> Road:
    """Return an obstacle, or a train of it, with another height (m)."""
    if "height" in type(road).model_fields:
        return road.with_fields(height=height)
    inner = getattr(road, "of", None)
    if isinstance(inner, Road):
        return road.with_fields(of=_with_height(inner, height))
    raise DescriptionError(
        "the road has no height to replace",
        where="heights",
        found=str(getattr(road, "kind", "")),
        allowed="an obstacle with a height, e.g. kind = 'half-cylinder'",
    )


def _metrics_of(
    rig: Rig, limits: Mapping[str, float | str] | None, *, is_course: bool
) -> dict[RunMetric, float]:
    """Return metrics and their limits, SI; those of the NATO tradition without any."""
    units = {output.name: output.unit for output in compile_rig(rig).facts.outputs}
    given: Mapping[str, float | str]
    if limits:
        given = limits
    else:
        body = next((name for name in _BODY if channels_of(name, list(units))), None)
        if body is None:
            raise DescriptionError(
                "no acceleration of a body to limit by default",
                where="limits",
                hint="Give metrics with their limits.",
            )
        given = (
            {f"absorbed_power {body}": POWER_LIMIT} if is_course else {f"shock {body}": SHOCK_LIMIT}
        )
    metrics: dict[RunMetric, float] = {}
    for text, limit in given.items():
        for metric in read_metrics([text], units):
            metrics[metric] = to_si(limit, metric.unit, where=f"limits: {text}")
            if not math.isfinite(metrics[metric]):
                raise DescriptionError("not a limit", where=f"limits: {text}", found=str(limit))
    return metrics


def _findings_of(curve: LimitCurve) -> list[Finding]:
    """Report what a single speed does not say about a curve."""
    place = f"{curve.metric}{'' if curve.height is None else f', {_place(curve.height)}'}"
    known = np.isfinite(curve.values)
    if not known.any():
        return []
    speed = curve.speed[known]
    exceeds = excess_over(curve.metric, float(curve.values[known][0]), curve.limit) > 0.0
    if exceeds:
        return [
            finding(
                "variants.limit_always_exceeded", place, float(speed[0]), slowest=float(speed[0])
            ),
            *_several(curve, place),
        ]
    if not curve.crossings:
        return [
            finding(
                "variants.limit_never_reached", place, float(speed[-1]), fastest=float(speed[-1])
            )
        ]
    return _several(curve, place)


def _several(curve: LimitCurve, place: str) -> list[Finding]:
    """Report crossings after the first that matters."""
    if all(item.is_exceeded_above for item in curve.crossings):
        return []
    listed = ", ".join(
        f"{item.speed:.3g} m/s ({'>' if item.is_exceeded_above else '<'})"
        for item in curve.crossings
    )
    return [finding("variants.limit_crossed_again", place, len(curve.crossings), speeds=listed)]


def _place(height: float | None) -> str:
    return "road" if height is None else f"{1e3 * height:.4g} mm"
