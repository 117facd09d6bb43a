"""Many runs of one rig with varying parameters of the rig, the trial or the controller."""

from __future__ import annotations

import itertools
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

import numpy as np

from jounce.core.datasets import dataset
from jounce.core.errors import DescriptionError, JounceError, SimulationError, reason, unknown
from jounce.core.findings import Finding, findings_of
from jounce.core.remembered import once_per_object
from jounce.core.samples import as_values
from jounce.core.types import Array
from jounce.core.units import Unit
from jounce.parts import Corner, Rig, Vehicle
from jounce.parts.rig import change_table, parameters_of, quantity_at, unknown_path
from jounce.recordings.schema import channels_of
from jounce.roads import Trial
from jounce.roads.trial import is_lasting
from jounce.simulation.compiled import Compiled, compile_rig
from jounce.simulation.prepare import PreparedRun, prepare
from jounce.simulation.problem import MOVES_TRACKS, excitation, force_actuator
from jounce.simulation.reduced import ReducedCorner, ReducedRun, Reduction, reduction_for
from jounce.simulation.reduced_car import CarReduction, ReducedCar, car_reduction_for
from jounce.simulation.result import (
    angles_of,
    branch_limits,
    cut_at_branch,
    samples_reached,
    turns_little,
)
from jounce.simulation.sampled import STEPS_SHARE, TRIES
from jounce.simulation.settings import RunSettings
from jounce.variants import few_channels, stepped
from jounce.variants.designs import MOST, Design, is_list
from jounce.variants.few_channels import FewChannels
from jounce.variants.findings import Tally
from jounce.variants.metrics import (
    RunMetric,
    check_durations,
    of_course,
    of_courses,
    of_sums,
    read_metrics,
)
from jounce.variants.side_by_side import LEAST, SharedLayout, lay_out, sums_side_by_side
from jounce.variants.threads import Item, processors, share

if TYPE_CHECKING:
    import xarray as xr
    from numpy.typing import NDArray

    from jounce.control import Controller
    from jounce.core.segments import Segments
    from jounce.kinematics.adjustments import Adjustable

Variants = Mapping[str, Sequence[float | str] | Array] | Design
_TRIAL, _CONTROL = "trial.", "control."
_Value = TypeVar("_Value")


@dataclass(frozen=True)
class VariantWork:
    """The work of a study except the variants themselves; it can be sent to another process.

    Attributes
    ----------
    study : Study
        Rig, trial, settings and controller.
    metrics : list of RunMetric
        Metrics of each run.
    channels : list of str
        Channels stored over time.
    design : dict
        Kind, count and seed of the design of the variants; empty without a design.
    """

    study: VariantStudy
    metrics: list[RunMetric]
    channels: list[str]
    design: dict[str, str | int]

    def run(
        self, columns: Mapping[str, Array], *, first: int = 0, threads: int | None = None
    ) -> xr.Dataset:
        """Run variants given as values (SI) by path; ``first`` is the number of the first variant."""
        count = len(next(iter(columns.values())))
        few = self.study.few_of(self.metrics, self.channels, count)
        results = _Results(
            self.metrics, self.channels, count, few, _Frame(self.study, columns, first)
        )
        groups = list(self.study.groups(columns))
        small = [
            pair for pair in groups if len(pair[1]) < LEAST
        ]  # too small to split between threads
        if small and not self.study.adjusts(columns):
            self.study.allows_all(_of_the_rig(columns))  # checked once, not for each group
        free = self.study.control is None  # a controller may be a function with state
        workers = min(threads or processors(), len(small)) if free else 1
        for group, rows in groups:
            if len(rows) >= LEAST or workers <= 1:
                group.fill(results, columns, rows, threads)
        if workers > 1:
            results.make_room()

            def fill(pairs: Iterable[tuple[_TrialGroup, NDArray[np.int64]]]) -> None:
                for group, own in pairs:
                    group.fill(results, columns, own, 1)

            _share_out(small, fill, workers)
        return results.dataset(self.design)


def read_request(
    rig: Rig,
    trial: Trial,
    variants: Variants,
    settings: RunSettings,
    metrics: Sequence[str] | str | None,
    outputs: Sequence[str] | str | None,
    control: Controller | None,
) -> tuple[VariantWork, dict[str, Array]]:
    """Read a request; return the work and the values (SI) of every variant by path."""
    if metrics is not None and not len(metrics) and not outputs:
        raise DescriptionError(
            "there are no results to store", where="metrics", allowed="e.g. ['rms sprung.az']"
        )
    study = VariantStudy(rig, trial, settings, control)
    columns = study.columns(variants)
    wanted = read_metrics(metrics, study.units) if metrics is not None else []
    check_durations(wanted, columns.get("trial.duration", [trial.duration]))
    channels = study.channels(
        outputs if outputs is not None or metrics is not None else list(study.units)
    )
    if channels and "trial.duration" in columns and np.ptp(columns["trial.duration"]) > 0.0:
        raise DescriptionError(
            "channels cannot be stored for runs of different lengths",
            where="outputs",
            hint="Request metrics.",
        )
    design: dict[str, str | int] = (
        {"design": variants.kind, "seed": variants.seed} if isinstance(variants, Design) else {}
    )
    return VariantWork(study, wanted, channels, design), columns


@dataclass(frozen=True)
class _Frame:
    """Parts of a result that do not depend on the runs; built while the runs are computed."""

    study: VariantStudy
    columns: Mapping[str, Array]
    first: int

    def make(self) -> None:
        """Build all parts."""
        _ = self.axes, self.beside, self.outside

    @cached_property
    def axes(self) -> xr.Dataset:
        """Axis of variant numbers."""
        return _variant_axis(self.first, len(next(iter(self.columns.values()))))

    @cached_property
    def beside(self) -> dict[str, xr.Variable]:
        """Coordinates with the varied parameters."""
        study = self.study
        return {
            path: _variant_column(column, study.number(path)[1], path)
            for path, column in self.columns.items()
        }

    @cached_property
    def outside(self) -> int:
        """Number of variants with a parameter outside its allowed range."""
        return self.study.outside(self.columns)


def _variant_column(values: Array, unit: str, long_name: str) -> xr.Variable:
    import xarray as xr

    return xr.Variable(("variant",), values, {"units": unit, "long_name": long_name}, fastpath=True)


@dataclass(frozen=True)
class _Results:
    """Arrays of results, filled group by group."""

    metrics: list[RunMetric]
    channels: list[str]
    count: int
    few: FewChannels | None
    frame: _Frame

    @cached_property
    def numbers(self) -> Array:
        return np.full((self.count, len(self.metrics)), np.nan)

    @cached_property
    def reasons(self) -> NDArray[np.object_]:
        return np.full(
            self.count, "", dtype=object
        )  # object array: one long text does not widen all others

    @cached_property
    def courses(self) -> list[Array | None]:
        return [None] * self.count

    def make_room(self) -> None:
        """Allocate all arrays before threads fill them."""
        _ = self.numbers, self.reasons, self.courses

    @cached_property
    def tally(self) -> dict[str, int]:
        return {"side_by_side": 0}

    @cached_property
    def found(self) -> Tally:
        """Findings of controllers."""
        return Tally()

    def dataset(self, design: Mapping[str, str | int]) -> xr.Dataset:
        import xarray as xr

        study, axes = self.frame.study, self.frame.axes
        result: dict[str, xr.Variable] = {}
        for i, metric in enumerate(self.metrics):
            result[metric.text] = _variant_column(
                self.numbers[:, i].copy(), metric.unit, metric.long_name
            )
        if self.channels:
            given = self.frame.columns.get("trial.duration", [study.trial.duration])
            times = study.settings.times(float(given[0]))
            axes = axes.assign_coords(time=xr.Variable(("time",), times, {"units": "s"}))
        for i, name in enumerate(self.channels):
            values = np.full((self.count, len(times)), np.nan)
            for row, course in zip(values, self.courses, strict=True):
                if course is not None:
                    row[: course.shape[1]] = course[i]
            about = {"units": study.units[name], "long_name": study.long_names[name]}
            result[name] = xr.Variable(("variant", "time"), values, about, fastpath=True)
        about = {"long_name": "why it has no run"}
        result["reason"] = xr.Variable(("variant",), self.reasons, about, fastpath=True)
        attributes = {
            "rig": str(getattr(study.rig, "model", "")),
            **self.tally,
            "outside": self.frame.outside,
            **design,
        }
        attributes |= self.found.attributes()
        return dataset(result, axes, attributes, self.frame.beside)


@lru_cache(2)
def _variant_axis(first: int, count: int) -> xr.Dataset:
    """Return the axis of variant numbers, which several results may share."""
    import xarray as xr

    return xr.Dataset(coords={"variant": np.arange(first, first + count)})


@dataclass(frozen=True)
class VariantStudy:
    """Everything that the variants share, and the parameters that may vary."""

    rig: Rig
    trial: Trial
    settings: RunSettings
    control: Controller | None

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the descriptions only; the other process compiles its own model."""
        return VariantStudy, (self.rig, self.trial, self.settings, self.control)

    @cached_property
    def compiled(self) -> Compiled:
        """Compiled model, with its actuator if it has one."""
        if self.control is not None:
            from jounce.simulation.controlled import close_loop

            loop = close_loop(self.rig, self.control)
            return compile_rig(
                self.rig, actuator=loop.actuator if loop else force_actuator(self.trial)
            )
        return compile_rig(self.rig, actuator=force_actuator(self.trial))

    @cached_property
    def reduction(self) -> Reduction | None:
        """Rig reduced to its single internal coordinate, or None if not applicable."""
        return reduction_for(self.rig, self.trial, self.settings) if self.control is None else None

    @cached_property
    def car(self) -> CarReduction | None:
        """Car reduced to one coordinate per wheel, or None if not applicable."""
        return (
            car_reduction_for(self.rig, self.trial, self.settings) if self.control is None else None
        )

    @cached_property
    def units(self) -> dict[str, str]:
        """SI unit of every channel."""
        return {output.name: output.unit for output in self.compiled.facts.outputs}

    @cached_property
    def long_names(self) -> dict[str, str]:
        """Label of every channel."""
        return {output.name: output.long_name for output in self.compiled.facts.outputs}

    @cached_property
    def base(self) -> Array:
        """Parameters (SI) of the unchanged rig."""
        return self.compiled.parameter_values(self.rig.parameters())

    def channels(self, given: Sequence[str] | str | None) -> list[str]:
        """Return the names of requested channels; a channel name without corner selects that of all corners."""
        result: list[str] = []
        for name in [given] if isinstance(given, str) else given or []:
            channels = channels_of(name, list(self.units))
            if not channels:
                raise unknown(name, self.units, what="channel", where="outputs")
            result += channels
        return list(dict.fromkeys(result))

    def few_of(
        self, metrics: Iterable[RunMetric], channels: Iterable[str], runs: int
    ) -> FewChannels | None:
        """Return code for the requested channels only; None if compiling it does not pay off."""
        if (
            self.control is not None
            or runs < few_channels.LEAST
            or not few_channels.are_worth_it(self.compiled)
        ):
            return None
        wanted = dict.fromkeys([*(metric.channel for metric in metrics), *channels])
        return FewChannels(self.compiled, tuple(wanted)) if len(wanted) < len(self.units) else None

    def owner(self, path: str) -> tuple[Any, str]:
        """Return the description (rig, trial or controller) to which a path belongs, and the remaining path."""
        for prefix, of in ((_TRIAL, self.trial), (_CONTROL, self.control)):
            if path.startswith(prefix):
                if of is None:
                    raise DescriptionError(
                        "there is no controller", where=f"variants: {path}", hint="Give control=..."
                    )
                return of, path.removeprefix(prefix)
        return self.rig, path

    def number(self, path: str) -> tuple[float, str]:
        """Return value (SI) and SI unit of the parameter at a path."""
        value, quantity = self._quantity(path)
        return value, quantity.si

    def limit(self, path: str) -> Unit:
        """Return unit and range of the parameter at a path."""
        return self._quantity(path)[1]

    def _quantity(self, path: str) -> tuple[float, Unit]:
        of, rest = self.owner(path)
        quantities = _quantities_of(of)
        if rest not in quantities:
            known = of.parameters() if of is self.rig else _numbers_of(of)
            if rest in known:
                quantities[rest] = known[rest], quantity_at(of, rest)
            elif of is self.rig and rest in self.adjustments:
                quantities[rest] = self._adjustment(rest)
            else:
                others = [
                    *self.adjustments,
                    *(f"{_TRIAL}{name}" for name in _numbers_of(self.trial)),
                ]
                raise unknown_path(
                    f"variants: {path}", [*known, *(others if of is self.rig else [])], name=rest
                )
        return quantities[rest]

    @cached_property
    def adjustments(self) -> dict[str, Adjustable]:
        """Adjustments of the rig by name; they can be varied like its parameters."""
        from jounce.kinematics.adjustments import adjustables

        return adjustables(self.rig) if isinstance(self.rig, Corner) else {}

    def _adjustment(self, name: str) -> tuple[float, Unit]:
        from jounce.kinematics.adjustments import ROUNDING

        adjustment = self.adjustments[name]
        assert isinstance(self.rig, Corner)
        low, high = adjustment.allowed_for(self.rig)
        limit = Unit(adjustment.unit, at_least=low - ROUNDING, at_most=high + ROUNDING)
        return adjustment.base(self.rig), limit

    def adjusts(self, paths: Iterable[str]) -> bool:
        """Whether any of the paths is an adjustment."""
        known = _numbers(self.rig)
        return any(
            path not in known and path in self.adjustments
            for path in _of_the_rig(dict.fromkeys(paths))
        )

    def changed_rig(self, changes: Mapping[str, float]) -> Rig:
        """Return the rig with changed parameters (SI), then adjusted."""
        names = [path for path in changes if self.adjusts([path])]
        rig = self.rig.with_changes(
            {path: value for path, value in changes.items() if path not in names}
        )
        if not names:
            return rig
        from jounce.kinematics.adjustments import apply_adjustments

        return apply_adjustments(rig, {name: changes[name] for name in names})

    def whole(self, path: str) -> bool:
        """Whether the parameter at a path is an integer, such as the seed of a road."""
        of, rest = self.owner(path)
        return of is not self.rig and rest in _numbers_of(of, whole=True)

    def outside(self, columns: Mapping[str, Array]) -> int:
        """Number of variants with a parameter outside its allowed range."""
        result: NDArray[np.bool_] | None = None
        for path, column in columns.items():
            limit = self.limit(path)
            least, most = limit.limits
            low, high = float(column.min()), float(column.max())
            if high <= most and (low > least if limit.above is not None else low >= least):
                continue
            beyond = (
                (column < least) | (column > most) | (limit.above is not None and column == least)
            )
            result = beyond if result is None else result | beyond
        return 0 if result is None else int(np.sum(result))

    def columns(self, variants: Variants) -> dict[str, Array]:
        """Return the values of every variant by path, SI."""
        if isinstance(variants, Design):
            result = variants.values(self.number, self.whole, self.limit)
        elif (
            not variants
            or not hasattr(variants, "items")
            or not all(isinstance(path, str) for path in variants)
        ):
            allowed = "the path of a parameter and its values, or a design such as jn.sobol(...)"
            raise DescriptionError(
                "no parameter to vary is given", where="variants", found=variants, allowed=allowed
            )
        else:
            result = {
                path: _column(given, self.number(path)[1], path) for path, given in variants.items()
            }
        lengths = {path: len(column) for path, column in result.items()}
        if len(set(lengths.values())) > 1:
            raise DescriptionError(
                "the values have different lengths", where="variants", found=lengths
            )
        if not 1 <= max(lengths.values()) <= MOST:
            raise DescriptionError(
                "invalid number of variants", where="variants", found=max(lengths.values())
            )
        for path in result:
            of, rest = self.owner(path)
            if (
                of is self.rig
                and rest not in self.compiled.facts.parameters
                and not self.adjusts([rest])
            ):
                raise DescriptionError(
                    "has no effect on the model", where=f"variants: {path}", hint="Leave it out."
                )
        return result

    def variant(self, changes: Mapping[str, float]) -> tuple[Rig, Trial, Controller | None]:
        """Return rig, trial and controller with the parameters (SI) of one variant."""
        own = {
            path: value
            for path, value in changes.items()
            if not path.startswith((_TRIAL, _CONTROL))
        }
        trial, control = (
            _change(description, changes, prefix)
            for description, prefix in ((self.trial, _TRIAL), (self.control, _CONTROL))
        )
        return self.changed_rig(own), trial, control

    def allows_all(self, own: Mapping[str, Array]) -> bool:
        """Whether the description allows all values of the rig's parameters; False if individual checks are as cheap.

        Conditions on several parameters (one below another) hold for all variants if they hold at all corners of their
        ranges. Each variant is checked individually only if there are more corners than variants, or if a corner is
        forbidden.
        """
        if not own:  # the unchanged rig
            return True
        box = [(float(column.min()), float(column.max())) for column in own.values()]
        known = _allowed_boxes(self.rig)
        inside = known.get(tuple(own))
        if inside is not None and all(
            a <= c and d <= b for (a, b), (c, d) in zip(inside, box, strict=True)
        ):
            return True
        if 2 ** len(own) < len(next(iter(own.values()))):
            for reach in (1.0, 0.0):  # also beyond the ends, for later sweeps with wider ranges
                wide = [
                    (low - reach * (high - low), high + reach * (high - low)) for low, high in box
                ]
                if all(map(partial(self.is_allowed, own), itertools.product(*wide))):
                    known[tuple(own)] = wide
                    return True
        return False

    def is_allowed(self, paths: Iterable[str], row: Sequence[float]) -> bool:
        """Whether the description allows the given values (SI)."""
        try:
            self.changed_rig(dict(zip(paths, row, strict=True)))
        except JounceError:
            return False
        return True

    def groups(
        self, columns: Mapping[str, Array]
    ) -> Iterator[tuple[_TrialGroup, NDArray[np.int64]]]:
        """Yield groups of variants that share a trial and a controller, with their row indices."""
        outer = [path for path in columns if path.startswith((_TRIAL, _CONTROL))]
        count = len(next(iter(columns.values())))
        if not outer:
            yield _TrialGroup(self, self.trial, self.control), np.arange(count)
            return
        table = np.column_stack([columns[path] for path in outer])
        kinds, of = np.unique(table, axis=0, return_inverse=True)
        for i, values in enumerate(kinds):
            rows = np.flatnonzero(of.ravel() == i)
            changes = {path: float(value) for path, value in zip(outer, values, strict=True)}
            try:
                trial = _change(self.trial, changes, _TRIAL)
                control = _change(self.control, changes, _CONTROL)
            except JounceError as error:
                yield _TrialGroup(self, self.trial, None, error.message()), rows
                continue
            yield _TrialGroup(self, trial, control), rows


@dataclass(frozen=True)
class _TrialGroup:
    """Variants of the rig over one trial, with a reason if none of them can run."""

    study: VariantStudy
    trial: Trial
    control: Controller | None
    reason: str = ""

    def fill(
        self,
        results: _Results,
        columns: Mapping[str, Array],
        rows: NDArray[np.int64],
        threads: int | None,
    ) -> None:
        own = _of_the_rig(columns)
        if len(rows) < results.count:
            own = {path: column[rows] for path, column in own.items()}
        if self.reason:
            for row in rows:
                results.reasons[row] = self.reason
            return
        described = self._needs_description(own, len(rows))
        if described is not None:
            for i in np.flatnonzero(described).tolist():
                changes = {path: float(column[i]) for path, column in own.items()}
                self._run_alone(results, int(rows[i]), partial(self._run, changes, results.few))
            own, rows = {path: column[~described] for path, column in own.items()}, rows[~described]
        if not len(rows):
            return
        parameters = self._parameters(own, len(rows))
        careful = np.ones(len(rows), dtype=bool)
        summed = not results.channels and not any(metric.needs_course for metric in results.metrics)
        if summed and self.study.settings.method == "auto" and len(rows) >= LEAST:
            careful = self._run_in_vectors(results, parameters, rows, threads)
        if careful.all():
            careful = self._step_in_vectors(results, parameters, rows, threads)

        def run_some(some: Iterable[int]) -> None:
            for i in some:
                self._run_alone(
                    results,
                    int(rows[i]),
                    partial(self._solve, parameters[i], self._signals, results.few),
                )

        left = np.flatnonzero(careful).tolist()
        workers = min(threads or processors(), len(left))
        if workers > 1:
            results.make_room()
        _share_out(left, run_some, workers)

    def _parameters(self, own: Mapping[str, Array], count: int) -> Array:
        """Return the values (SI) of all parameters of the model, one row per variant."""
        parameters = np.empty((count, len(self.study.base)))
        parameters[:] = self.study.base
        for path, column in own.items():
            parameters[:, self.study.compiled.facts.parameters.index(path)] = column
        return parameters

    def _needs_description(self, own: Mapping[str, Array], count: int) -> NDArray[np.bool_] | None:
        """Return flags of variants to be validated one by one, to report why they are forbidden; None if none."""
        if (
            self.control is not None
            or any(path in MOVES_TRACKS for path in own)
            or self.study.adjusts(own)
        ):
            return np.ones(count, dtype=bool)
        if self.study.allows_all(own):
            return None
        rows = zip(*(column.tolist() for column in own.values()), strict=True)
        return np.array([not self.study.is_allowed(own, row) for row in rows], dtype=bool)

    @cached_property
    def _signals(self) -> list[Segments]:
        return excitation(self.study.compiled.facts, self.study.rig, self.trial)

    def _run_in_vectors(
        self, results: _Results, parameters: Array, rows: NDArray[np.int64], threads: int | None
    ) -> NDArray[np.bool_]:
        """Fill in the variants that can run in vector registers; return the remaining ones."""
        study, names = self.study, list(dict.fromkeys(metric.channel for metric in results.metrics))
        limits = branch_limits(study.compiled.output_names)
        outputs = [study.compiled.output_names.index(name) for name in names]
        channels = list(dict.fromkeys([*outputs, *limits]))
        layout = self._layout(channels)
        make = results.frame.make
        sums = sums_side_by_side(layout, parameters, threads, make) if layout is not None else None
        if sums is None:
            return np.ones(len(rows), dtype=bool)
        careful = sums.alone.copy()
        for (
            place,
            limit,
        ) in limits.items():  # a single run reports the reason for diverging variants
            j = channels.index(place)
            careful |= ~(
                np.maximum(
                    np.abs(sums.rest[:, j] + sums.least[:, j]),
                    np.abs(sums.rest[:, j] + sums.most[:, j]),
                )
                <= limit
            )
        sound = ~careful
        count = int(np.count_nonzero(sound))
        for i, metric in enumerate(results.metrics):
            values = of_sums(metric.word, sums, names.index(metric.channel))
            if count == results.count:
                results.numbers[:, i] = values
            else:
                results.numbers[rows[sound], i] = values[sound]
        results.tally["side_by_side"] += count
        return careful

    def _layout(self, channels: Sequence[int]) -> SharedLayout | None:
        """Layout shared by vectorised variants, stored with the trial for later sweeps."""
        study = self.study
        layouts = _layouts_of(self.trial)
        wheels = tuple(study.rig.wheels.items()) if isinstance(study.rig, Vehicle) else ()
        key = study.compiled.identity, study.base.tobytes(), wheels, study.settings, tuple(channels)
        if layouts is None or key not in layouts:
            times = study.settings.times(self.trial.duration)
            layout = lay_out(study.compiled, study.base, self._signals, times, channels)
            if layouts is None:
                return layout
            if len(layouts) >= _MOST_LAYOUTS:
                layouts.clear()
            layouts[key] = layout
        return layouts[key]

    def _step_in_vectors(
        self, results: _Results, parameters: Array, rows: NDArray[np.int64], threads: int | None
    ) -> NDArray[np.bool_]:
        """Fill in the variants that can be stepped in vectors; return the remaining ones.

        Variants with a wheel outside its table are repeated with a wider table that suffices for all, or half, of them.
        """
        careful, left = np.ones(len(rows), dtype=bool), np.arange(len(rows))
        may = self.study.settings.method != "implicit" and len(rows) >= stepped.LEAST
        stepping = self._prepare_steps(parameters) if may else None
        for _ in range(TRIES):
            if stepping is None:
                break
            travelled = self._step_through(results, stepping, rows[left], threads)
            careful[left[travelled.held]] = False
            beyond = np.isfinite(travelled.low) & np.isfinite(travelled.high)
            left = left[beyond]
            if len(left) < stepped.LEAST:
                break
            low, high = travelled.low[beyond], travelled.high[beyond]
            stepping = self._prepare_steps(parameters[left], (float(low.min()), float(high.max())))
            if stepping is None:
                stepping = self._prepare_steps(
                    parameters[left], (float(np.median(low)), float(np.median(high)))
                )
        return careful

    def _step_through(
        self, results: _Results, stepping: _Stepping, rows: NDArray[np.int64], threads: int | None
    ) -> _TravelBeyond:
        """Step variants and fill in those that stay within their tables; return the travel of the others."""
        study, nowhere = self.study, np.full(len(rows), np.nan)
        travelled = _TravelBeyond(np.zeros(len(rows), dtype=bool), nowhere, nowhere.copy())
        base, numbers, sound, corner, tolerance = stepping
        outputs = study.compiled.output_names
        limits = {outputs[row]: limit for row, limit in branch_limits(outputs).items()}
        angles = (
            angles_of(outputs) if base.compiled.facts.projects else []
        )  # a single coordinate cannot flip over
        wanted = [
            *(metric.channel for metric in results.metrics),
            *results.channels,
            *limits,
            *angles,
        ]
        channels = [outputs.index(name) for name in dict.fromkeys(wanted)]
        row_of = {outputs[number]: i for i, number in enumerate(channels)}
        extended = stepped.in_blocks(base.compiled, numbers)
        blocks = stepped.LaneBlocks(
            base.compiled, base, extended, self._signals, channels, tolerance
        )
        rest, wide = blocks.rest(), extended.shape[2]
        sound &= ~rest.lost.ravel()[: len(rows)]
        results.make_room()

        def take(block: int, states: Array, courses: Array) -> None:
            first = block * wide
            count = min(wide, len(rows) - first)
            inside = (
                corner.holds(states)[:count] if corner is not None else np.ones(count, dtype=bool)
            )
            valid = np.ones(wide, dtype=bool)
            for (
                name,
                limit,
            ) in limits.items():  # a single run reports the reason for diverging variants
                course = courses[row_of[name]]
                valid = valid & (np.maximum(course.max(axis=1), -course.min(axis=1)) <= limit)
            for name in angles:
                valid = valid & turns_little(courses[row_of[name]])
            sane = sound[first : first + count] & valid[:count]
            lanes, beyond = np.flatnonzero(sane & inside), np.flatnonzero(sane & ~inside)
            if corner is not None:
                travelled.low[first + beyond], travelled.high[first + beyond] = (
                    part[beyond] for part in corner.travel_bounds(states)
                )
            still = blocks.outputs_at_rest(rest, block)
            for i, metric in enumerate(results.metrics):
                row = row_of[metric.channel]
                signals = (courses[row] - still[row, :, None])[lanes]
                results.numbers[rows[first + lanes], i] = of_courses(
                    metric, signals, still[row, lanes], study.settings.output_step
                )
            if results.channels:
                shown = [row_of[name] for name in results.channels]
                for lane in lanes:
                    results.courses[rows[first + lane]] = courses[shown, lane].copy()
            travelled.held[first + lanes] = True

        blocks.run(rest, take, threads)
        results.tally["side_by_side"] += int(np.sum(travelled.held))
        return travelled

    def _prepare_steps(
        self, parameters: Array, travel: tuple[float, float] | None = None
    ) -> _Stepping | None:
        """Prepare the stepping of variants in vectors; None if impossible, or if the base rig cannot run.

        The tables extend beyond ``travel`` (m), the known travel of the wheel.
        """
        study = self.study
        times, tolerance = study.settings.times(self.trial.duration), study.settings.tolerance
        if study.reduction is None:
            if travel is not None or not stepped.can_step(study.compiled, len(parameters)):
                return None
            try:
                method = study.settings.method
                base = prepare(
                    study.compiled,
                    study.base,
                    self._signals,
                    times,
                    tolerance=tolerance,
                    method=method,
                )
            except SimulationError:
                return None
            every = np.ones(len(parameters), dtype=bool)
            stepping = _Stepping(base, parameters, every, None, tolerance)
        else:
            names = study.compiled.facts.parameters
            values = dict(zip(names, study.base.tolist(), strict=True))
            corner = ReducedCorner(study.reduction, values, self._signals, times, tolerance)
            stepper = corner.lay_out() if travel is None else corner.beyond(*travel)
            if stepper is None:
                return None
            whole = np.concatenate([study.base[None, :], parameters])
            numbers, sound = study.reduction.alike(
                stepper.table, stepper.degree, names, whole, corner.limit
            )
            stepping = _Stepping(
                stepper.prepared, numbers[1:], sound[1:], stepper, STEPS_SHARE * tolerance
            )
        base = stepping.base
        steps = (
            base.exact is None
            and base.method == "explicit"
            and stepped.can_step(base.compiled, len(parameters))
        )
        return stepping if steps else None

    def _run_alone(self, results: _Results, row: int, run: Callable[[], _RunSamples]) -> None:
        """Fill in the result of a run, or the reason for its failure."""
        try:
            run_samples = run()
        except Exception as error:  # noqa: BLE001 - one variant must not stop all others
            results.reasons[row] = str(reason(error))  # convert to plain str for the array
            return
        if run_samples.findings:
            results.found.add(run_samples.findings)
        for i, metric in enumerate(results.metrics):
            j = run_samples.names.index(metric.channel)
            results.numbers[row, i] = of_course(
                metric, run_samples.outputs[j], run_samples.rest[j], self.study.settings.output_step
            )
        if results.channels:
            results.courses[row] = run_samples.outputs[
                [run_samples.names.index(name) for name in results.channels]
            ]

    def _run(self, changes: Mapping[str, float], few: FewChannels | None) -> _RunSamples:
        """Run the rig with some of its parameters changed."""
        settings, compiled, rig = (
            self.study.settings,
            self.study.compiled,
            self.study.changed_rig(changes),
        )
        if self.control is not None:
            from jounce.simulation.solve import solve

            run = solve(rig, self.trial, settings, control=self.control)
            outputs = np.array([values for values, _, _ in run.channels.values()])
            findings = findings_of(run.attributes)
            return _RunSamples(compiled.output_names, outputs, outputs[:, 0], findings)
        signals = excitation(compiled.facts, rig, self.trial)
        return self._solve(compiled.parameter_values(rig.parameters()), signals, few)

    def _solve(self, p: Array, signals: list[Segments], few: FewChannels | None) -> _RunSamples:
        """Run the model for values (SI) of all its parameters, without findings."""
        settings, compiled = self.study.settings, self.study.compiled
        times = settings.times(self.trial.duration)
        some = self._run_reduced(p, signals, times)
        if some is not None:
            return _RunSamples(compiled.output_names, *some)
        some = few.run(p, signals, times, settings) if few is not None else None
        if few is not None and some is not None:
            return _RunSamples(few.names, *some)
        prepared_run = prepare(
            compiled, p, signals, times, tolerance=settings.tolerance, method=settings.method
        )
        solution = cut_at_branch(compiled, prepared_run.run())
        samples_reached(solution, compiled.facts, check=True)
        at = prepared_run.equilibrium
        rest = solution.outputs[:, 0]
        if at is not None:
            rest = compiled.evaluate("output", at.x, prepared_run.still, p, at.modes)
        return _RunSamples(compiled.output_names, solution.outputs, rest)

    def _run_reduced(
        self, p: Array, signals: list[Segments], times: Array
    ) -> tuple[Array, Array] | None:
        """Run the model with one coordinate per corner; None if that is not possible."""
        study = self.study
        values = dict(zip(study.compiled.facts.parameters, p.tolist(), strict=True))
        course = values, signals, times, study.settings.tolerance
        if study.reduction is not None:
            output = ReducedCorner(study.reduction, *course).run()
        elif study.car is not None:
            output = ReducedCar(study.car, *course).run()
        else:
            return None
        if output is None:
            return None
        solution, prepared_run = output
        at = prepared_run.equilibrium
        assert at is not None
        still, values_there = prepared_run.still, prepared_run.problem.p
        return solution.outputs, prepared_run.compiled.evaluate(
            "output", at.x, still, values_there, at.modes
        )


def _share_out(items: Sequence[Item], take: Callable[[Iterable[Item]], None], workers: int) -> None:
    """Distribute items to several threads as soon as one item took long enough.

    Short runs are mostly Python code, which is executed by one thread at a time; two threads would take twice as long
    as one. The first item also builds the shared objects.
    """
    for i in range(len(items) if workers > 1 else 0):
        begin = time.thread_time()
        take(items[i : i + 1])
        if i > 0 and time.thread_time() - begin > _LONG:
            share(items[i + 1 :], take, workers)
            return
    if workers == 1:
        take(items)


_LONG = 2e-3  # s of processor time: far above the start-up time of a thread


class _RunSamples(NamedTuple):
    """Result of a run: channels, their samples and values at rest, one row each, and findings."""

    names: Sequence[str]
    outputs: Array
    rest: Array
    findings: Sequence[Finding] = ()


class _Stepping(NamedTuple):
    """A run of the base rig, parameters of the variants, flags of valid ones, and the reduced run with its table."""

    base: PreparedRun
    numbers: Array
    sound: NDArray[np.bool_]
    one: ReducedRun | None
    tolerance: float


class _TravelBeyond(NamedTuple):
    """Flags of variants that stayed within their tables, and the travel of wheels that left them (m)."""

    held: NDArray[np.bool_]
    low: Array
    high: Array


@once_per_object
def _quantities_of(description: object) -> dict[str, tuple[float, Unit]]:  # noqa: ARG001 - kept beside it
    """Return values (SI) of requested parameters of a rig, trial or controller, with units and ranges."""
    return {}


@once_per_object
def _allowed_boxes(rig: Rig) -> dict[tuple[str, ...], list[tuple[float, float]]]:  # noqa: ARG001 - kept beside it
    """Return ranges of parameters of a rig, by their paths, in which its description is known to allow all values."""
    return {}


_MOST_LAYOUTS = 4  # for each trial: enough for a sweep and its repeats


@once_per_object
def _layouts_of(trial: Trial) -> dict[object, SharedLayout | None] | None:
    """Return the cache of layouts of a trial; None if its road is a file, which may change."""
    return {} if is_lasting(trial) else None


def _numbers_of(description: Any, *, whole: bool = False) -> dict[str, float]:
    """Return the parameters of a trial or controller by path, including integers (a seed); or integers only."""
    numbers = {} if whole else parameters_of(description)
    for name in type(description).model_fields:
        value = getattr(description, name)
        if isinstance(value, int) and not isinstance(value, bool):
            numbers[name] = float(value)
        elif hasattr(type(value), "model_fields"):
            numbers |= {
                f"{name}.{path}": number for path, number in _numbers_of(value, whole=whole).items()
            }
    return numbers


@once_per_object
def _numbers(rig: Rig) -> dict[str, float]:
    """Return the parameters of a rig by path."""
    return rig.parameters()


def _of_the_rig(columns: Mapping[str, _Value]) -> dict[str, _Value]:
    return {
        path: column for path, column in columns.items() if not path.startswith((_TRIAL, _CONTROL))
    }


def _change(description: Any, changes: Mapping[str, float], prefix: str) -> Any:
    own: dict[str, float] = {
        path.removeprefix(prefix): value
        for path, value in changes.items()
        if path.startswith(prefix)
    }
    if description is None or not own:
        return description
    whole = _numbers_of(description, whole=True)
    own = {
        path: int(value) if path in whole and value.is_integer() else value
        for path, value in own.items()
    }
    return type(description).from_table(
        change_table(description, own), where=prefix.removesuffix(".")
    )


def _column(given: object, unit: str, path: str) -> Array:
    if not is_list(given):
        raise DescriptionError(
            "not a list of values",
            where=f"variants: {path}",
            found=given,
            allowed="one value per variant",
        )
    column = np.array(as_values(given, unit, where=f"variants: {path}"))  # a copy: results store it
    if column.ndim != 1 or not len(column) or not np.all(np.isfinite(column)):
        raise DescriptionError(
            "not a list of finite numbers", where=f"variants: {path}", found=str(given)[:60]
        )
    return column
