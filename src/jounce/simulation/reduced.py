"""Runs of a 3-D corner reduced to its single internal coordinate: polynomials of travel, and their error bounds.

The pose quantities in the equations are sampled at Chebyshev points of a range of travel, each pose exact to rounding.
The polynomial keeps the first coefficients; the following ones, sampled as well, bound its error and that of its slope.
If that error is too large, the wheel leaves the range, or the run stops before its end, the full mechanism is used
instead.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import SimulationError
from jounce.core.remembered import Recent
from jounce.core.segments import Segments
from jounce.core.turns import once
from jounce.core.types import Array
from jounce.kernel.engine import Status
from jounce.kernel.native import Native, Source, code_from_cache
from jounce.kernel.poses import space_for, walk_poses
from jounce.mechanics.facts import HALF, MIDDLE, of_travel
from jounce.parts import Rig
from jounce.parts.corners import Corner
from jounce.parts.rig import structure_of
from jounce.roads import Trial
from jounce.simulation.compiled import Compiled, compile_described, sources
from jounce.simulation.prepare import PreparedRun, prepare
from jounce.simulation.result import Solution, cut_at_branch
from jounce.simulation.sampled import (
    BESIDE,
    COARSEST,
    DEGREES,
    FLAT,
    OFF,
    ROUNDINGS,
    SHARE,
    SHOWN,
    STEPS_SHARE,
    TIGHTEST,
    TRIES,
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

if TYPE_CHECKING:
    from jounce.mechanics.model import Model
    from jounce.models.reduced import SampledCorner

_SLOPES_SHARE = (
    0.1  # share of the tolerance: allowed relative error of a parameter's effect on a lever or mass
)
_UNFELT = 1e-4  # relative change of a quantity by a unit (SI) of a parameter, below which its error counts as absolute
_LANES = 8  # parameters of a description whose slopes are computed at once
_RACK = "steering.rack_travel"
_MASSES = ("mass", "momentum", "inertia")


@dataclass(frozen=True)
class Reduction(Sampling):
    """Reduced corners of one structure: the sampling of their poses, and the polynomial model of each degree."""

    rig: Corner
    placed: dict[int, _TableLayout] = field(default_factory=dict)
    made: LastTables = field(default_factory=LastTables)

    def compiled(self, degree: int) -> Compiled:
        """Return the native code of the reduced corner."""
        return _compile(self.rig, structure_of(self.rig), degree)

    def feels(self, path: str, degree: int = DEGREES[0]) -> bool:
        """Whether a parameter of the description affects the reduced corner, directly or through its table."""
        return path in self.places(degree).given or self.is_sampled(path)

    def is_sampled(self, path: str) -> bool:
        """Whether a table depends on a parameter of the description."""
        return path == _RACK or path in self.parameters

    def sensitive(self, degree: int, free: tuple[str, ...]) -> Compiled:
        """Return the code with sensitivities to parameters of the description; those in a table change all of it."""
        places = self.places(degree)
        free_table = tuple(path for path in free if path in places.given)
        if any(map(self.is_sampled, free)):
            free_table += tuple(path for path in places.table if path not in (MIDDLE, HALF))
        return replace(
            _sensitive(self.rig, structure_of(self.rig), degree, free_table, len(free)), free=free
        )

    @once
    def are_factors(self) -> NDArray[np.bool_]:
        """Whether each quantity except the first has an error relative to its value: masses and tyre inclination."""
        return np.array([name in _MASSES or name.startswith("tyre.") for name in self.names[1:]])

    @once
    def only_shown(self) -> NDArray[np.bool_]:
        """Whether each quantity except the first is only used in channels."""
        return np.array([name.startswith("wheel.") for name in self.names[1:]])

    def places(self, degree: int) -> _TableLayout:
        """Return the indices of numbers among the parameters of the model of a degree."""
        if degree not in self.placed:
            paths = self.compiled(degree).facts.parameters
            own = [MIDDLE, HALF, *of_travel(self.names[0], 0)]
            own += [path for name in self.names[1:] for path in of_travel(name, degree)]
            place = {path: i for i, path in enumerate(paths)}
            given = tuple(path for path in paths if path not in set(own))
            self.placed[degree] = _TableLayout(
                given, tuple(own), _numbers(place, given), _numbers(place, own)
            )
        return self.placed[degree]

    def tables(
        self, p: Array, rack: float, low: float, high: float, degree: int
    ) -> tuple[Array, Array]:
        """Sample the poses over a range of travel (m) for each row of ``p``; return table parameters and error bounds.

        ``p`` contains the values of ``parameters``, ``rack`` (m) is the fixed rack travel. The bounds are relative;
        they are NaN if the mechanism does not reach the whole range.
        """
        points, transform, powers, squares = basis(degree)
        middle, half = 0.5 * (high + low), 0.5 * (high - low)
        values = self.sample(p, rack, middle + half * points)
        series = values[1:] @ transform.T
        leading, dropped = np.abs(series[..., : degree + 1]), np.abs(series[..., degree + 1 :])
        size = self._sizes(leading, half)
        # Forces and masses depend on the slope of a quantity, channels on the quantity itself.
        slope_errors, value_errors = (
            dropped @ squares[degree + 1 :],
            SHARE / SHOWN * dropped.sum(axis=-1),
        )
        errors = np.where(self.only_shown[:, None], value_errors, slope_errors) / size
        may_flip = self.only_shown[:, None] & (
            (leading[..., 1:].sum(axis=-1) > TURNED) | (leading[..., 0] > TURNED)
        )
        errors[may_flip] = (
            np.inf
        )  # such a wheel may flip over, which only the full mechanism can show
        coefficients = (series[..., : degree + 1] @ powers).transpose(1, 0, 2).reshape(len(p), -1)
        first = np.column_stack([np.full(len(p), middle), np.full(len(p), half), values[0, :, 0]])
        return np.concatenate([first, coefficients], axis=1), errors.max(axis=0)

    def _sizes(self, sizes: Array, half: float) -> Array:
        """Return the reference of the error of each quantity except the first: its value or its variation.

        ``sizes`` are the absolute values of its coefficients along the last axis.
        """
        levers = np.maximum(sizes[..., 1:].sum(axis=-1), FLAT * half)
        size = np.where(
            self.are_factors.reshape(-1, *[1] * (sizes.ndim - 2)), sizes[..., 0], levers
        )
        size[0] = size[1]  # momentum and inertia belong to one matrix
        return size

    def slopes(
        self, table: TravelTable, degree: int, p: Array, rack: float, free: Sequence[str]
    ) -> tuple[Array, float]:
        """Return derivatives of a table by parameters of the description, one column each, and a bound of their error.

        The derivatives of the poses, with closed loops, are exact. The only error is that of the polynomials; for each
        parameter it is relative to the quantity that it changes most.
        """
        points, transform, powers, squares = basis(degree)
        middle, half = table.numbers[:2]
        values, along = self._along(p, rack, middle + half * points, free)
        moves, series = along[1:] @ transform.T, values[1:] @ transform.T
        leading, dropped = np.abs(moves[..., : degree + 1]), np.abs(moves[..., degree + 1 :])
        size = self._sizes(np.abs(series[..., : degree + 1]), half)[:, None]
        rounding = ROUNDINGS * np.abs(along[1:]).max(axis=-1)
        slope_errors = (
            np.maximum(
                dropped @ squares[degree + 1 :] - rounding * squares[degree + 1 :].sum(), 0.0
            )
            / size
        )
        value_errors = np.maximum(dropped.sum(axis=-1) - rounding * len(points), 0.0)
        first = np.where(
            self.are_factors, 0, 1
        )  # the constant term of a length has no effect on levers
        changes = np.array(
            [each[:, begin:].sum(axis=-1) for each, begin in zip(leading, first, strict=True)]
        )
        largest = (changes / size)[~self.only_shown].max(axis=0)
        errors = np.where(
            self.only_shown[:, None],
            _SLOPES_SHARE / SHOWN * value_errors / np.maximum(leading.sum(axis=-1), _UNFELT),
            slope_errors / np.maximum(largest, _UNFELT),
        )
        numbers = np.zeros((len(table.numbers), len(free)))
        numbers[2] = along[0, :, 0]
        numbers[3:] = (moves[..., : degree + 1] @ powers).transpose(0, 2, 1).reshape(-1, len(free))
        return numbers, float(errors.max(initial=0.0))

    def _along(
        self, p: Array, rack: float, travel: Array, free: Sequence[str]
    ) -> tuple[Array, Array]:
        """Return quantities at ascending travels, and their slopes, shape (quantities, parameters, travels)."""
        walk, place = self.walk(p, rack, travel)
        poses_found, work = space_for(walk, len(self.names))
        walk_poses(walk, poses_found, work)
        tracks, count, poses = len(self.tracks), len(self.names), len(travel)
        place_of = {path: tracks + i for i, path in enumerate(self.parameters)}
        if _RACK in free:
            place_of[_RACK] = tracks - 1
        size = tracks + len(self.parameters)
        values, slopes = np.empty((count, poses)), np.zeros((count, len(free), poses))
        values[:, place] = poses_found.outputs
        which = [i for i, path in enumerate(free) if path in place_of]
        for first in range(0, len(which), _LANES):
            group = which[first : first + _LANES]
            change = np.zeros((size, _LANES))
            change[[place_of[free[i]] for i in group], range(len(group))] = 1.0
            x = np.concatenate([self.start, change.ravel()])
            for k in range(poses):
                x[: len(self.start)] = poses_found.poses[:, k]
                slope = self.tangents.evaluate(
                    "tangent", (count * _LANES,), x, walk.targets[k], p, work.m
                )
                slopes[:, group, place[k]] = slope.reshape(count, _LANES)[:, : len(group)]
        return values, slopes

    @once
    def tangents(self) -> Native:
        """Native code for the slopes of all quantities."""

        def source() -> Source:
            from jounce.kernel.lowering import Lanes
            from jounce.models.reduced import sampled_corner

            first = (len(self.start), len(self.tracks), len(self.parameters), 1, 0)
            return Source({"tangent": Lanes(sampled_corner(self.rig).tangent(), _LANES, first)})

        return code_from_cache(
            f"{sources()} tangents {type(self.rig).__name__} {structure_of(self.rig)}", source
        )[0]

    def alike(
        self, base: TravelTable, degree: int, paths: Sequence[str], values: Array, limit: float
    ) -> tuple[Array, NDArray[np.bool_]]:
        """Return parameters of the reduced corner for rows of ``values`` of a description, over the range of a table.

        ``paths`` name the values; the first row is that of the table. Also return which rows have an error within the
        limit; the other rows are filled with the numbers of the first.
        """
        place, places = {path: i for i, path in enumerate(paths)}, self.places(degree)
        sampled = values[:, _numbers(place, self.parameters)]
        racks = values[:, place[_RACK]] if _RACK in place else np.zeros(len(values))
        rows = np.empty((len(values), len(places.of_given) + len(places.of_table)))
        rows[:, places.of_given] = values[:, _numbers(place, places.given)]
        rows[:, places.of_table] = base.numbers
        sound = np.ones(len(values), dtype=bool)
        if np.any(sampled != sampled[0]) or np.any(racks != racks[0]):
            numbers, errors = self.tables(sampled, float(racks[0]), base.low, base.high, degree)
            sound = (errors <= limit) & (racks == racks[0])
            rows[np.ix_(sound, places.of_table)] = numbers[sound]
        rows[~sound] = rows[0]
        return rows, sound

    def table(
        self, p: Array, rack: float, low: float, high: float, degree: int
    ) -> TravelTable | None:
        """Return the table for one row; None if the mechanism does not reach the whole range."""

        def make() -> TravelTable:
            numbers, errors = self.tables(p[None, :], rack, low, high, degree)
            return TravelTable(low, high, numbers[0], float(errors[0]))

        table = self.made.of((low, high, degree, rack, p.tobytes()), make)
        return table if np.isfinite(table.error) else None


class _TableLayout(NamedTuple):
    """Paths of the description's and a table's numbers, and their indices."""

    given: tuple[str, ...]
    table: tuple[str, ...]
    of_given: NDArray[np.intp]
    of_table: NDArray[np.intp]


def _numbers(place: dict[str, int], paths: Sequence[str]) -> NDArray[np.intp]:
    return np.array([place[path] for path in paths], dtype=np.intp)


_reductions: Recent[Reduction | None] = Recent()


def reduction_for(rig: Rig, trial: Trial, settings: RunSettings) -> Reduction | None:
    """Return the reduction of a rig if runs on a trial may use it; None if the full mechanism is required."""
    return reduction_of(rig) if may_reduce(trial, settings) else None


def reduction_of(rig: Rig) -> Reduction | None:
    """Return the reduction of a rig; None unless it is a corner whose pose follows from one coordinate."""
    if not isinstance(rig, Corner):
        return None
    structure = structure_of(rig)
    return _reductions.of(
        structure, lambda: _reduction(rig, structure) if rig.only_travels else None
    )


def _reduction(rig: Corner, structure: str) -> Reduction:
    def make() -> SampledCorner:
        from jounce.models.reduced import sampled_corner

        return sampled_corner(rig)

    sampling = sampling_of(f"sampled {type(rig).__name__} {structure}", make)
    return Reduction(
        sampling.native, sampling.names, sampling.tracks, sampling.parameters, sampling.start, rig
    )


def _sensitive(
    rig: Corner, structure: str, degree: int, varied: tuple[str, ...], count: int
) -> Compiled:
    """Compile the reduced corner with sensitivities to ``count`` numbers that change the parameters ``varied``."""
    key = ("reduced", type(rig).__name__, structure, degree, varied, count)
    plain, free = _compile(rig, structure, degree), tuple(f"direction {i}" for i in range(count))
    return compile_described(key, plain.source, free, lambda: plain, varied)


def _compile(rig: Corner, structure: str, degree: int) -> Compiled:
    def model() -> Model:
        from jounce.models.reduced import reduced_corner

        return reduced_corner(rig, degree)

    return compile_described(("reduced", type(rig).__name__, structure, degree), model)


@dataclass(frozen=True)
class ReducedRun:
    """A prepared run with its table."""

    prepared: PreparedRun
    table: TravelTable
    degree: int

    @property
    def rest(self) -> float:
        """Travel (m) at rest."""
        assert self.prepared.equilibrium is not None
        n, x = len(self.prepared.compiled.facts.coordinates), self.prepared.equilibrium.x
        return float(x[n - 1] - (x[0] if n > 1 else 0.0))

    def travel_bounds(self, states: Array) -> tuple[Array, Array]:
        """Return bounds of the travel (m) at and between the samples, which are along the last axis."""
        n, times = len(self.prepared.compiled.facts.coordinates), self.prepared.out.times
        travel, rate = states[n - 1], states[2 * n - 1]
        if n > 1:
            travel, rate = travel - states[0], rate - states[n]
        between = np.maximum(rate.max(axis=-1), -rate.min(axis=-1)) * np.diff(times).max(
            initial=0.0
        )
        return travel.min(axis=-1) - between, travel.max(axis=-1) + between

    def holds(self, states: Array) -> NDArray[np.bool_]:
        """Whether the wheel stays within the range of the table."""
        low, high = self.travel_bounds(states)
        return (self.table.low <= low) & (high <= self.table.high)


@dataclass(frozen=True)
class ReducedCorner:
    """A corner with its parameter values, signals of the tracks, sample times (s) and tolerance."""

    reduction: Reduction
    values: Mapping[str, float]
    signals: Sequence[Segments]
    times: Array
    tolerance: float
    free: tuple[str, ...] = ()

    def run(self) -> tuple[Solution, PreparedRun] | None:
        """Run, with a wider range of travel if the wheel leaves the first one; None if that fails."""
        laid_out = self.lay_out()
        for _ in range(TRIES):
            if laid_out is None:
                return None
            solution = laid_out.prepared.run()
            compiled = laid_out.prepared.compiled
            if (
                solution.status is not Status.COMPLETED
                or cut_at_branch(compiled, solution) is not solution
            ):
                return None
            if laid_out.holds(solution.states):
                return replace(solution, method=f"reduced {solution.method}"), laid_out.prepared
            laid_out = self.beyond(*map(float, laid_out.travel_bounds(solution.states)))
        return None

    def beyond(self, low: float, high: float) -> ReducedRun | None:
        """Prepare a run for a range of travel (m) wider than the wheel has used so far."""
        wider = BESIDE * (high - low)
        return self.over(low - wider, high + wider)

    @property
    def limit(self) -> float:
        """Maximum allowed error of a table."""
        return SHARE * self.tolerance

    def lay_out(self) -> ReducedRun | None:
        """Prepare a run for a range about the pose at rest; None if no polynomial suffices or there is no rest."""
        around = first_range(max(signal.extent for signal in self.signals))
        about_design = self.over(-around, around)
        if about_design is None or abs(about_design.rest) < OFF * around:
            return about_design
        return self.over(about_design.rest - around, about_design.rest + around)

    def over(self, low: float, high: float) -> ReducedRun | None:
        """Prepare a run for a range of travel, m."""
        p, rack = (
            np.array([self.values[path] for path in self.reduction.parameters]),
            self.values.get(_RACK, 0.0),
        )
        for degree in DEGREES:
            table = self.reduction.table(p, rack, low, high, degree)
            if table is None:
                return None
            if table.error > self.limit:
                continue
            slopes, error = (
                self.reduction.slopes(table, degree, p, rack, self.free)
                if self.free
                else (None, 0.0)
            )
            if error <= _SLOPES_SHARE * self.tolerance:
                return self._with(table, degree, slopes)
        return None

    def _with(self, table: TravelTable, degree: int, slopes: Array | None) -> ReducedRun | None:
        """Prepare a run over a table, whose numbers depend on the free parameters by ``slopes``."""
        reduction, places = self.reduction, self.reduction.places(degree)
        compiled = (
            reduction.sensitive(degree, self.free) if self.free else reduction.compiled(degree)
        )
        paths = compiled.facts.parameters
        p = np.empty(len(paths))
        p[places.of_given] = [self.values[path] for path in places.given]
        p[places.of_table] = table.numbers
        along = None
        if slopes is not None:
            derivatives = np.zeros((len(p), len(self.free)))
            derivatives[places.of_table] = slopes
            for column, path in enumerate(self.free):
                if path in places.given:
                    derivatives[paths.index(path), column] = 1.0
            along = derivatives[[paths.index(path) for path in compiled.moved]]
        try:
            tolerance = STEPS_SHARE * self.tolerance
            prepared = prepare(
                compiled, p, self.signals, self.times, tolerance=tolerance, along=along
            )
        except SimulationError:  # the full mechanism reports the reason
            return None
        return ReducedRun(prepared, table, degree)


def with_slopes(
    rig: Rig,
    trial: Trial,
    values: Mapping[str, float],
    signals: Sequence[Segments],
    times: Array,
    tolerance: float,
    free: tuple[str, ...],
) -> Solution | None:
    """Run a reduced corner with sensitivities; None if that is not possible.

    ``values`` are the numbers of the description, of which some are ``free``; ``signals`` contains every track.
    """
    longest = float(np.diff(times).max(initial=0.0))
    if longest > COARSEST or tolerance < TIGHTEST or trial.actuator_force is not None or not free:
        return None
    reduction = reduction_of(rig)
    if reduction is None or not all(map(reduction.feels, free)):
        return None
    run = ReducedCorner(reduction, values, signals, times, tolerance, free).run()
    return None if run is None else run[0]
