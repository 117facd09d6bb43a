"""Runs of a full car on reduced 3-D corners, with one coordinate per wheel; see ``reduced`` for single corners.

Every corner has its own table: polynomials of its travel, from poses sampled when the run is prepared.

Single corners and cars share sampling and tables (``sampled``), but little else. A suspension under a body that only
heaves needs two masses and a momentum, whose slopes by parameters are known as well. Under a body that rotates it needs
moments, angular momenta and tensors, whose errors are assessed by other effects; a corner treated as a car of one wheel
would compute all of these.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from jounce.core.errors import SimulationError
from jounce.core.remembered import Recent
from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.kernel.engine import Status
from jounce.mechanics.facts import HALF, MIDDLE, REACH, is_road, of_travel
from jounce.parts import Rig
from jounce.parts.corners import Corner
from jounce.parts.rig import structure_of
from jounce.parts.vehicles import FullCar3D
from jounce.roads import Trial
from jounce.simulation.compiled import Compiled, compile_described
from jounce.simulation.prepare import PreparedRun, prepare
from jounce.simulation.result import Solution, cut_at_branch
from jounce.simulation.sampled import (
    DEGREES,
    FLAT,
    OFF,
    ROUNDINGS,
    SHARE,
    SHOWN,
    STEPS_SHARE,
    TURNED,
    LastTables,
    Sampling,
    TravelTable,
    basis,
    first_range,
    may_reduce,
    sampling_of,
)
from jounce.simulation.settings import RunSettings
from jounce.simulation.statics import find_equilibrium

if TYPE_CHECKING:
    from jounce.mechanics.model import Model
    from jounce.models.reduced import SampledCorner

_ENDS, _SIDES = {"front": 1.0, "rear": -1.0}, {"left": 1.0, "right": -1.0}
PLACES = tuple(f"{end}_{side}" for end in _ENDS for side in _SIDES)
"""Names of the corners, in the model's order."""

_WIDE = (0.08, 0.07, 0.06)
"""Ranges of travel (m) to either side, tried from the widest if the lowest degree fails: higher degrees cost the same
for all ranges."""

Ranges = tuple[tuple[float, float], ...]
"""Range of travel (m) of each corner."""


class _CarLayout(NamedTuple):
    """Indices of a vehicle's numbers and of the tables' numbers among a model's parameters; names of table quantities.

    ``reach`` are the parameters for the range of the tables.
    """

    given: dict[str, int]
    reach: list[int]
    own: list[list[int]]
    names: list[list[str]]


@dataclass(frozen=True)
class CarReduction:
    """Reduced cars of one structure: the sampling of each axle's corners, and the model of each degree."""

    rig: FullCar3D
    axles: Mapping[str, Sampling]
    placed: dict[int, _CarLayout] = field(default_factory=dict)
    made: LastTables = field(default_factory=LastTables)

    def compiled(self, degree: int) -> Compiled:
        """Return the native code of the reduced car."""

        def model() -> Model:
            from jounce.models.reduced_car import reduced_car

            return reduced_car(self.rig, degree)

        return compile_described(
            ("reduced", type(self.rig).__name__, structure_of(self.rig), degree), model
        )

    def places(self, degree: int) -> _CarLayout:
        """Return the indices of numbers among the parameters of the model of a degree."""
        if degree not in self.placed:
            place = {path: i for i, path in enumerate(self.compiled(degree).facts.parameters)}
            reach, own, names = [place.pop(f"{corner}.{REACH}") for corner in PLACES], [], []
            for corner in PLACES:
                sampled = self.axles[corner.partition("_")[0]].names
                required = [
                    name for name in sampled[1:] if f"{corner}.{of_travel(name, 0)[0]}" in place
                ]
                paths = [MIDDLE, HALF, *of_travel(sampled[0], 0)]
                paths += [path for name in required for path in of_travel(name, degree)]
                own.append([place.pop(f"{corner}.{path}") for path in paths])
                names.append(required)
            self.placed[degree] = _CarLayout(place, reach, own, names)
        return self.placed[degree]

    def table(
        self, values: Mapping[str, float], which: int, low: float, high: float, degree: int
    ) -> TravelTable:
        """Sample the poses of a corner over a range of travel (m); the error is infinite if it does not reach that.

        ``values`` are the vehicle's parameters by path.
        """
        p = self.numbers(values, which)
        rack = values.get(f"{PLACES[which].partition('_')[0]}.corner.steering.rack_travel", 0.0)
        key = which, low, high, degree, rack, p.tobytes()
        return self.made.of(key, lambda: self._table(p, rack, which, low, high, degree))

    def _table(
        self, p: Array, rack: float, which: int, low: float, high: float, degree: int
    ) -> TravelTable:
        end = PLACES[which].partition("_")[0]
        sampling = self.axles[end]
        points, transform, powers, _ = basis(degree)
        middle, half = 0.5 * (high + low), 0.5 * (high - low)
        sampled = dict(
            zip(
                sampling.names,
                sampling.sample(p[None, :], rack, middle + half * points)[:, 0],
                strict=True,
            )
        )
        names = self.places(DEGREES[0]).names[which]
        series = np.array([sampled[name] for name in names]) @ transform.T
        mass = float(sampled[sampling.names[0]][0])
        reached = bool(np.isfinite(series).all())
        error = error_of(names, series, degree, half, mass) if reached else np.inf
        numbers = np.array([middle, half, mass, *(series[:, : degree + 1] @ powers).ravel()])
        return TravelTable(low, high, numbers, error)

    def numbers(self, values: Mapping[str, float], which: int) -> Array:
        """Return the parameters of the poses of a corner, including its position on the car."""
        end, _, side = PLACES[which].partition("_")
        before = f"{end}.corner."
        ahead = (
            _ENDS[end] * values[f"{end}.distance"] - values[f"{before}hardpoints.wheel_centre[0]"]
        )
        own = {"ahead": ahead, "turned": _SIDES[side]}
        for i, centre in enumerate(
            (0.0, 0.0, values["body.height"])
        ):  # the joint about which the body rotates
            own[f"origin[{i}]"] = values.get(f"body.joint[{i}]", centre)
        paths = self.axles[end].parameters
        return np.array([own[path] if path in own else values[f"{before}{path}"] for path in paths])


def error_of(names: Sequence[str], series: Array, degree: int, half: float, mass: float) -> float:
    """Bound the error of polynomials with Chebyshev coefficients ``series``, one row for each quantity.

    The error is relative to the effect of each quantity on the car. ``half`` is half the range of travel (m), ``mass``
    that of the corner (kg).
    """
    orders = np.arange(series.shape[1], dtype=float)[degree + 1 :]
    leading, dropped = np.abs(series[:, : degree + 1]), np.abs(series[:, degree + 1 :])
    variation = np.maximum(leading[:, 1:].sum(axis=1), FLAT * half)
    value, slope = dropped.sum(axis=1), dropped @ orders**2
    significant = np.maximum(dropped - ROUNDINGS * leading.max(axis=1, initial=0.0)[:, None], 0.0)
    second_slope = significant @ (orders**2 * (orders**2 - 1.0) / 3.0)
    rows: dict[str, list[int]] = {}
    for i, name in enumerate(names):
        rows.setdefault(
            name if name.endswith((".length", ".angle")) else name.partition(".")[0], []
        ).append(i)
    errors, in_motion = (
        [0.0],
        SHARE / SHOWN,
    )  # in_motion: weight of quantities without a static load
    for name, group in rows.items():
        error, size = slope[group], leading[group, 0].max()
        if name in ("inertia", "angular", "tensor"):
            error = in_motion * slope[group]
        elif (
            name == "moment"
        ):  # changes by mass times metre; its second derivative has an effect, too
            error, size = np.maximum(slope[group], in_motion * second_slope[group]), mass * half
        elif name == "turning":
            error, size = value[group], 1.0
        elif name == "spin_direction":
            turns = leading[[group[0], group[2]]]
            if max(turns[:, 0].max(), turns[:, 1:].sum(axis=1).max()) > TURNED:
                return float(
                    "inf"
                )  # such a wheel may flip over, which only the full mechanism can show
            # It also inclines the tyre's deflection and the lever of its force.
            error, size = (
                np.maximum(in_motion * value[group] / variation[group].max(), value[group]),
                1.0,
            )
        elif name in ("wheel_centre", "arb_link_end", "third_spring_end"):
            size = half
        else:
            size = variation[group].max()
        errors.append(float(np.max(error) / size))
    return float(np.nan_to_num(np.max(errors), nan=np.inf))  # a quantity of zero size has no bound


_reductions: Recent[CarReduction | None] = Recent()


def car_reduction_for(rig: Rig, trial: Trial, settings: RunSettings) -> CarReduction | None:
    """Return the reduction of a rig if runs on a trial may use it; None if the full mechanism is required."""
    return (
        car_reduction_of(rig)
        if isinstance(rig, FullCar3D) and may_reduce(trial, settings)
        else None
    )


def car_reduction_of(rig: FullCar3D) -> CarReduction | None:
    """Return the reduction of a car; None unless a single coordinate determines the pose of each corner."""

    def make() -> CarReduction | None:
        corners = {end: getattr(rig, end).corner for end in _ENDS}
        known = {end: corner for end, corner in corners.items() if corner is not None}
        if len(known) < len(corners) or not all(corner.only_travels for corner in known.values()):
            return None
        return CarReduction(rig, {end: _sampling(corner) for end, corner in known.items()})

    return _reductions.of(structure_of(rig), make)


def _sampling(corner: Corner) -> Sampling:
    def make() -> SampledCorner:
        from jounce.models.reduced_car import sampled_suspension

        return sampled_suspension(corner)

    return sampling_of(f"sampled suspension {type(corner).__name__} {structure_of(corner)}", make)


@dataclass(frozen=True)
class CarRun:
    """A prepared run that stops when a wheel leaves its range."""

    prepared: PreparedRun
    ranges: Ranges

    def holds(self, states: Array) -> bool:
        """Whether all wheels are within their ranges at all samples; the run itself checks between them."""
        places = [self.prepared.compiled.facts.states.index(f"{place}.travel") for place in PLACES]
        return all(
            low <= travel.min() and travel.max() <= high
            for travel, (low, high) in zip(states[places], self.ranges, strict=True)
        )


@dataclass(frozen=True)
class ReducedCar:
    """A car with its parameter values, signals of the tracks, sample times (s) and tolerance."""

    reduction: CarReduction
    values: Mapping[str, float]
    signals: Sequence[Segments]
    times: Array
    tolerance: float

    def run(self) -> tuple[Solution, PreparedRun] | None:
        """Run, with a wider range of travel if a wheel leaves the first one; None if that fails."""
        left = 0.0
        for around, degrees in (
            (self.first_range, DEGREES[:1]),
            *((wide, DEGREES) for wide in _WIDE),
        ):
            laid_out = self.lay_out(around, degrees) if around > left else None
            if laid_out is None:
                continue
            prepared, solution = laid_out.prepared, laid_out.prepared.run()
            if solution.status is Status.NOT_FINITE or not laid_out.holds(solution.states):
                left = around
                continue
            if solution.status is not Status.COMPLETED:
                return None
            if cut_at_branch(prepared.compiled, solution) is not solution:
                return None
            return replace(solution, method=f"reduced {solution.method}"), prepared
        return None

    @property
    def first_range(self) -> float:
        """Initial range of travel (m) to either side."""
        extents = {name: signal.extent for name, signal in self._courses.items()}
        leaning = any(extent > 0.0 for name, extent in extents.items() if not is_road(name))
        road = max(extent for name, extent in extents.items() if is_road(name))
        return first_range(np.inf if leaning else road)

    @property
    def _courses(self) -> dict[str, Segments]:
        return dict(
            zip(self.reduction.compiled(DEGREES[0]).facts.tracks, self.signals, strict=True)
        )

    def lay_out(self, around: float, degrees: Sequence[int] = DEGREES) -> CarRun | None:
        """Prepare a run for a range (m) about the pose at rest; None if no polynomial suffices or there is no rest."""
        ranges: Ranges = ((-around, around),) * len(PLACES)
        table = self._numbers(ranges, degrees)
        if table is None:
            return None
        degree, p = table
        compiled = self.reduction.compiled(degree)
        still = compiled.inputs(
            {
                name: float(each.evaluate(self.times[:1])[0][0])
                for name, each in self._courses.items()
            }
        )
        try:
            x = find_equilibrium(compiled, p, still).x
        except SimulationError:  # the full mechanism reports the reason
            return None
        rests = [float(x[compiled.facts.states.index(f"{place}.travel")]) for place in PLACES]
        if max(map(abs, rests)) >= OFF * around:
            ranges = tuple((rest - around, rest + around) for rest in rests)
            table = self._numbers(ranges, degrees)
        return None if table is None else self._over(ranges, *table)

    def _over(self, ranges: Ranges, degree: int, p: Array) -> CarRun | None:
        """Prepare a run for ranges of travel, m."""
        compiled = self.reduction.compiled(degree)
        try:
            prepared = prepare(
                compiled, p, self.signals, self.times, tolerance=STEPS_SHARE * self.tolerance
            )
        except SimulationError:
            return None
        p[self.reduction.places(degree).reach] = 1.0
        return CarRun(
            replace(prepared, problem=prepared.problem._replace(p=compiled.extend(p))), ranges
        )

    def _numbers(self, ranges: Ranges, degrees: Sequence[int]) -> tuple[int, Array] | None:
        """Return the first degree sufficient for all ranges, and its model's parameters, without limits of travel."""
        for degree in degrees:
            tables = []
            for which, each in enumerate(ranges):
                tables.append(self.reduction.table(self.values, which, *each, degree))
                if tables[-1].error > SHARE * self.tolerance:
                    break
            else:
                places = self.reduction.places(degree)
                p = np.empty(len(self.reduction.compiled(degree).facts.parameters))
                p[list(places.given.values())] = [self.values[path] for path in places.given]
                for place, table in zip(places.own, tables, strict=True):
                    p[place] = table.numbers
                p[places.reach] = np.inf
                return degree, p
        return None
