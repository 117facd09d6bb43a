"""A design task: free variables within bounds, an objective and limits, all with derivatives.

Designs are evaluated by metrics of a stationary response or of a simulated trial. A metric is written as words:
``sprung.az`` (r.m.s. about rest), ``sprung.az weighted`` (by Wk, or any weighting by its name), ``sprung.az
absorbed_power`` (W), ``tyre.force coefficient`` (r.m.s. over static value), ``strut.deflection static``, ``mode 1
frequency``, ``mode 2 damping_ratio``.
A channel name without its corner selects that channel of all corners; ``worst`` before it takes the largest instead of
the root mean square over the corners.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError, FitError, SimulationError, nearest, unknown
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.design.variables import is_constant
from jounce.identify.fit_problem import Bounds, FreeParameter, free_parameters
from jounce.kinematics.catalogue import CATALOGUE
from jounce.parts import Rig
from jounce.recordings.schema import channels_of
from jounce.ride.absorbed_power import absorbed_power_response, absorbed_root, check_length
from jounce.ride.covariance import Gain, RandomVibration, Signal
from jounce.ride.family import Families, LinearFamily
from jounce.ride.stationary import weighting_gain
from jounce.ride.surface import Surface, surface
from jounce.roads import Trial

KINDS = ("rms", "weighted", "absorbed_power", "coefficient", "static")
_MODE = {"frequency": "Hz", "damping_ratio": "1"}
_EXAMPLES = (
    "e.g. 'sprung.az', 'sprung.az weighted', 'worst tyre.force coefficient', 'mode 1 frequency'"
)
Numbers = tuple[Array, Array]
"""Values of a metric, one for each channel, and their slopes (numbers, channels)."""


@dataclass(frozen=True)
class Metric:
    """A metric as written (``text``), with its SI unit (Hz for frequencies).

    ``channels`` are its channels, or the quantity of a mode; ``kind`` is one of `KINDS` or of `_MODE`; ``mode`` counts
    from 1; ``is_worst`` is True if the largest of its channels is used.
    """

    text: str
    channels: tuple[str, ...]
    kind: str
    unit: str
    weighting: str = ""
    mode: int = 0
    is_worst: bool = False

    @property
    def is_of_mode(self) -> bool:
        """Whether it is a quantity of a mode."""
        return self.mode > 0


def read_metric(text: str, units: Mapping[str, str], *, where: str) -> Metric:
    """Parse a metric; ``units`` has the SI unit of every channel of the model."""
    words = str(text).split()
    is_worst = words[:1] == ["worst"]
    words = words[1:] if is_worst else words
    if words[:1] == ["mode"]:
        return _mode_metric(text, words, where)
    if not 1 <= len(words) <= 2:
        raise DescriptionError("invalid metric", where=where, found=text, allowed=_EXAMPLES)
    kind, weighting = _kind(words[1] if len(words) == 2 else "rms", text, where)
    channels = tuple(channels_of(words[0], list(units)))
    if not channels:
        ends = {".".join(name.split(".")[-2:]) for name in units}
        error = unknown(
            words[0],
            {*ends, *(name for name in units if name.count(".") < 2)},
            what="metric",
            where=where,
        )
        if words[0] in {row.name for row in CATALOGUE}:
            hint = (
                "Use jn.design_kinematics or `jounce design kinematics` for kinematic quantities."
            )
            raise DescriptionError(error.what, where=where, allowed=error.allowed, hint=hint)
        raise error
    if kind == "coefficient" and not words[0].endswith("force"):
        raise DescriptionError(
            "a coefficient is defined only for forces",
            where=where,
            found=text,
            allowed="e.g. 'tyre.force coefficient'",
        )
    if kind == "absorbed_power" and units[channels[0]] != "m/s^2":
        raise DescriptionError(
            Phrase("{word} is defined only for accelerations", word=kind),
            where=where,
            found=text,
            allowed="e.g. 'sprung.az absorbed_power'",
        )
    return Metric(
        str(text),
        channels,
        kind,
        {"coefficient": "1", "absorbed_power": "W"}.get(kind, units[channels[0]]),
        weighting,
        0,
        is_worst,
    )


def _kind(word: str, text: str, where: str) -> tuple[str, str]:
    from jounce.ride.weighting import WEIGHTINGS

    if word == "weighted":
        return "weighted", "Wk"
    if word in WEIGHTINGS:
        return "weighted", word
    if word in KINDS:
        return word, ""
    allowed = ", ".join([*KINDS, *WEIGHTINGS])
    raise DescriptionError(
        Phrase("no such metric of a channel: {word!r}", word=word),
        where=where,
        found=text,
        allowed=allowed,
        hint=nearest(word, KINDS),
    )


def _gain_of(metric: Metric) -> Gain | None:
    """Return the magnitude over frequency (Hz) of what weights a metric; None for a plain one."""
    if metric.kind == "absorbed_power":
        return lambda frequency: np.abs(absorbed_power_response(frequency))
    return weighting_gain(metric.weighting) if metric.weighting else None


def _mode_metric(text: str, words: Sequence[str], where: str) -> Metric:
    if len(words) != 3 or not words[1].isdigit() or int(words[1]) < 1 or words[2] not in _MODE:
        allowed = "'mode 1 frequency', 'mode 1 damping_ratio', ..., by rising frequency"
        raise DescriptionError("not a quantity of a mode", where=where, found=text, allowed=allowed)
    return Metric(str(text), (" ".join(words),), words[2], _MODE[words[2]], mode=int(words[1]))


@dataclass(frozen=True)
class StationaryEvaluator:
    """Evaluates metrics of linear models on a random road, for one rig or for many at once."""

    families: Families
    surface: Surface
    metrics: tuple[Metric, ...]

    @property
    def is_exact(self) -> bool:
        """Whether its slopes are exact."""
        return self.families.first.is_exact

    @cached_property
    def _layout(self) -> tuple[dict[str, list[int]], tuple[Signal, ...]]:
        """Indices of each metric's signals, and the signals."""
        names = list(self.families.first.compiled.output_names)
        places: dict[str, list[int]] = {}
        signals: list[Signal] = []
        for metric in self.metrics:
            if not metric.is_of_mode:
                gain = _gain_of(metric)
                places[metric.text] = [len(signals) + i for i in range(len(metric.channels))]
                signals += [Signal(names.index(channel), gain) for channel in metric.channels]
        return places, tuple(signals)

    @cached_property
    def analysis(self) -> RandomVibration:
        """Random vibration of the required signals."""
        return RandomVibration(self.families, self.surface, self._layout[1])

    def absent(self) -> dict[str, str]:
        """Metrics whose variance under a white-noise road is infinite, with the reason."""
        moments = self.analysis.at(slopes=True)
        reasons = {}
        for metric in self.metrics:
            for i in self._layout[0].get(metric.text, []) if metric.kind != "static" else []:
                if i in moments.absent:
                    reasons[metric.text] = moments.absent[i]
                elif np.any(np.isnan(moments.variance_slopes[:, :, i])):
                    reasons[metric.text] = (
                        "would depend on the height of the road when a free parameter changes"
                    )
        return reasons

    def at(self, values: Array) -> dict[str, Numbers]:
        """Return every metric of a single rig by its text: values of its channels and their slopes, SI."""
        return {
            text: (numbers[0], slopes[0])
            for text, (numbers, slopes) in self.each(values[None]).items()
        }

    def each(self, values: Array) -> dict[str, Numbers]:
        """Return every metric for all rigs: (members, channels) and slopes (members, numbers, channels), SI."""
        moments = self.analysis.at(values)
        metrics = {}
        for metric in self.metrics:
            if metric.is_of_mode:
                model, along = moments.linear.model, moments.linear.along
                rows = [
                    mode_number(metric, *matrices)
                    for matrices in zip(model.A, along.A, strict=True)
                ]
                metrics[metric.text] = (
                    np.stack([row[0] for row in rows]),
                    np.stack([row[1] for row in rows]),
                )
                continue
            i = self._layout[0][metric.text]
            sigma = np.sqrt(np.maximum(moments.variances[:, i], 1e-300))
            slopes = moments.variance_slopes[:, :, i] / (2.0 * sigma[:, None])
            metrics[metric.text] = _of_kind(
                metric, sigma, slopes, moments.static[:, i], moments.static_slopes[:, :, i]
            )
        return metrics


def _of_kind(
    metric: Metric, sigma: Array, slopes: Array, rest: Array, rest_slopes: Array
) -> Numbers:
    """Return the metric of each channel (..., channels), and its slopes (..., numbers, channels)."""
    if metric.kind == "static":
        return rest, rest_slopes
    if metric.kind == "absorbed_power":
        return sigma**2, 2.0 * sigma[..., None, :] * slopes
    if metric.kind != "coefficient":
        return sigma, slopes
    if np.any(rest <= 0.0):
        raise FitError(
            "a coefficient without a static force", where=metric.text, found=f"{np.min(rest):.4g} N"
        )
    share, size = (sigma / rest)[..., None, :], rest[..., None, :]
    return sigma / rest, (slopes - share * rest_slopes) / size


def mode_number(metric: Metric, a: Array, along: Array) -> Numbers:
    """Return frequency (Hz) or damping ratio (1) of a mode of ``dx/dt = a x``, and its derivatives.

    Both are also defined for an overdamped mode: they continue smoothly, computed from its pair of real eigenvalues.
    """
    from scipy.linalg import eig

    values, left, right = eig(a, left=True, right=True)
    pairs = _pairs(values)
    if metric.mode > len(pairs):
        raise FitError(Phrase("there are only {count} modes", count=len(pairs)), where=metric.text)
    i, j = pairs[metric.mode - 1]
    first, second = values[i], values[j]
    moves = [
        np.array([left[:, k].conj() @ part @ right[:, k] for part in along])
        / (left[:, k].conj() @ right[:, k])
        for k in (i, j)
    ]
    size = np.sqrt((first * second).real)
    growth = (moves[0] * second + first * moves[1]).real / (2.0 * size)
    if metric.kind == "frequency":
        return np.array([size / (2.0 * np.pi)]), growth[:, None] / (2.0 * np.pi)
    total, change = (first + second).real, (moves[0] + moves[1]).real
    return np.array([-0.5 * total / size]), (0.5 * (total * growth / size - change) / size)[:, None]


def _pairs(values: NDArray[np.complex128]) -> list[tuple[int, int]]:
    """Return the eigenvalue pair of each mode by rising frequency: conjugates, or adjacent real eigenvalues."""
    real = sorted(
        (i for i in range(len(values)) if values[i].imag == 0.0), key=lambda i: abs(values[i])
    )
    pairs = [(real[k], real[k + 1]) for k in range(0, len(real) - 1, 2)]
    turning = [i for i in range(len(values)) if values[i].imag > 0.0]
    pairs += [(i, int(np.argmin(np.abs(values - values[i].conj())))) for i in turning]
    return sorted(pairs, key=lambda pair: abs(values[pair[0]] * values[pair[1]]))


@dataclass(frozen=True)
class TrialEvaluator:
    """Evaluates metrics of a simulated trial: r.m.s. about the values at rest at its start; step in s."""

    family: LinearFamily
    trial: Trial
    metrics: tuple[Metric, ...]
    output_step: float = 2e-3

    def __post_init__(self) -> None:
        from jounce.ride.weighting import check_duration

        for metric in self.metrics:
            if metric.kind == "absorbed_power":
                check_length(self.trial.duration, where=metric.text)
            elif metric.weighting:
                check_duration(metric.weighting, self.trial.duration, where=metric.text)

    @property
    def is_exact(self) -> bool:
        """Whether its slopes are exact: always, since the simulation computes sensitivities."""
        return True

    def at(self, values: Array) -> dict[str, Numbers]:
        """Return every metric by its text: values of its channels and their slopes, SI."""
        from jounce.kernel.engine import Status
        from jounce.simulation.compiled import compile_rig
        from jounce.simulation.prepare import solve
        from jounce.simulation.problem import excitation
        from jounce.simulation.reduced import with_slopes
        from jounce.simulation.settings import output_times

        rig, paths = self.family.rig, self.family.paths
        plain, given = compile_rig(rig), dict(zip(paths, map(float, values), strict=True))
        numbers = {**rig.parameters(), **given}
        times = output_times(self.trial.duration, self.output_step)
        driven = excitation(plain.facts, rig.with_changes(given), self.trial, paths)
        solution = with_slopes(rig, self.trial, numbers, driven, times, 1e-5, paths)
        if solution is None:
            compiled = compile_rig(rig, paths)
            solution = solve(compiled, compiled.parameter_values(numbers), driven, times)
        if solution.status is not Status.COMPLETED:
            raise SimulationError(
                "the run did not reach its end", where="trial", found=solution.status.help
            )
        metrics = {}
        for metric in self.metrics:
            if metric.is_of_mode:
                model, slopes = self.family.at(values)
                metrics[metric.text] = mode_number(metric, model.A, slopes.A)
                continue
            i = [plain.output_names.index(name) for name in metric.channels]
            signals, along = solution.outputs[i], solution.output_slopes[i]
            metrics[metric.text] = self._number(metric, signals, along)
        return metrics

    def _number(self, metric: Metric, signals: Array, along: Array) -> Numbers:
        """Return a metric of signals (channels, time) with slopes (channels, numbers, time)."""
        rest, rest_slopes = signals[:, 0], along[:, :, 0]
        moved, slopes = signals - rest[:, None], along - rest_slopes[:, :, None]
        if metric.weighting or metric.kind == "absorbed_power":
            moved = np.array([self._weigh(row, metric) for row in moved])
            slopes = np.array([[self._weigh(row, metric) for row in block] for block in slopes])
        sigma = np.sqrt(np.mean(moved**2, axis=1))
        change = np.mean(slopes * moved[:, None, :], axis=2) / np.maximum(sigma, 1e-300)[:, None]
        return _of_kind(metric, sigma, change.T, rest, rest_slopes.T)

    def _weigh(self, row: Array, metric: Metric) -> Array:
        from jounce.ride.weighting import weight

        rate = 1.0 / self.output_step
        if metric.kind == "absorbed_power":
            return absorbed_root(row, rate)
        return weight(row, rate, metric.weighting)


class Judge(Protocol):
    """Evaluates designs: metrics by their texts, with slopes by the free parameters."""

    @property
    def is_exact(self) -> bool:
        """Whether its slopes are exact."""

    def at(self, values: Array) -> dict[str, Numbers]:
        """Return every metric by its text: values of its channels and their slopes, SI."""


Evaluator = StationaryEvaluator | TrialEvaluator


def combine_channels(metric: Metric, numbers: Numbers) -> tuple[float, Array]:
    """Combine all channels of a metric: the largest, or the root mean square, with its slopes (numbers,)."""
    values, slopes = numbers
    if len(values) == 1:
        return float(values[0]), slopes[:, 0]
    if metric.is_worst:
        i = int(np.argmax(np.abs(values)))
        return float(values[i]), slopes[:, i]
    whole = float(np.sqrt(np.mean(values**2)))
    return whole, slopes @ values / (len(values) * max(whole, 1e-300))


def units_of(rig: Rig) -> dict[str, str]:
    """Return the SI unit of every channel of a rig's model."""
    return {output.name: output.unit for output in LinearFamily(rig).compiled.facts.outputs}


Objective = str | Mapping[str, float]
Bound = str | float | None
LimitGiven = Bound | tuple[Bound, Bound] | list[Bound]


@dataclass(frozen=True)
class Limit:
    """Limits of a metric, for each channel or (``is_whole``) for all combined, SI; None for an open side."""

    metric: Metric
    lower: float | None
    upper: float | None
    is_whole: bool = False


@dataclass(frozen=True)
class DesignProblem:
    """A design task: the initial rig, free variables, weights of the objective, and limits.

    ``metrics`` has all metrics by their text; ``surface`` is the road of a stationary response, ``trial`` the simulated
    trial otherwise; ``notes`` are findings about automatic choices; ``base`` has the objective's metrics at the start,
    SI; ``driven`` describes several cases in words.
    """

    rig: Rig
    free: tuple[FreeParameter, ...]
    weights: dict[str, float]
    limits: tuple[Limit, ...]
    evaluator: Evaluator | Judge
    metrics: dict[str, Metric]
    surface: Surface | None
    trial: Trial | None
    notes: tuple[Finding, ...] = ()
    base: dict[str, float] = field(default_factory=dict)
    driven: str = ""
    _memory: dict[bytes, dict[str, Numbers]] = field(default_factory=dict, repr=False)

    @property
    def has_kinks(self) -> bool:
        """Whether the metrics have kinks: a percentile has one where two samples swap their order."""
        return bool(getattr(self.evaluator, "has_kinks", False))

    @property
    def start(self) -> Array:
        """Values of the rig, SI."""
        return np.array([free.initial for free in self.free])

    @property
    def evaluations(self) -> int:
        """Number of designs evaluated."""
        return len(self._memory)

    def numbers(self, values: Array) -> dict[str, Numbers]:
        """Return all metrics at given values (SI) of the free variables, with slopes."""
        key = np.asarray(values, dtype=float).tobytes()
        if key not in self._memory:
            self._memory[key] = self.evaluator.at(np.asarray(values, dtype=float))
        return self._memory[key]

    def whole(self, text: str, values: Array) -> tuple[float, Array]:
        """Return a metric combined over all its channels, and its slopes, SI."""
        return combine_channels(self.metrics[text], self.numbers(values)[text])

    def objective(self, values: Array) -> tuple[float, Array]:
        """Return the objective relative to its initial value (1), and its slopes per SI unit of the free variables."""
        total, slopes = 0.0, np.zeros(len(self.free))
        for text, weight in self.weights.items():
            number, along = self.whole(text, values)
            share = weight / (self.base[text] ** 2 * sum(self.weights.values()))
            total += share * number**2
            slopes = slopes + 2.0 * share * number * along
        return total, slopes

    def with_values(self, values: Array) -> Rig:
        """Return the rig with given values (SI) of the free variables."""
        return self.rig.with_changes(
            dict(zip([free.path for free in self.free], map(float, values), strict=True))
        )

    def margins(self, values: Array) -> list[tuple[Limit, str, str, float, Array]]:
        """Return the margin of each side of each limit and channel, relative to the limit, with slopes."""
        margins = []
        for limit in self.limits:
            numbers, slopes = self.numbers(values)[limit.metric.text]
            channels: tuple[str, ...] = limit.metric.channels
            if limit.is_whole:
                number, along = combine_channels(limit.metric, (numbers, slopes))
                numbers, slopes, channels = np.array([number]), along[:, None], (limit.metric.text,)
            for i, channel in enumerate(channels):
                for side, bound, sign in (
                    ("lower", limit.lower, 1.0),
                    ("upper", limit.upper, -1.0),
                ):
                    if bound is not None:
                        size = abs(bound) or abs(self.base_of(limit.metric)) or 1.0
                        margin = sign * (float(numbers[i]) - bound) / size
                        margins.append((limit, channel, side, margin, sign * slopes[:, i] / size))
        return margins

    def base_of(self, metric: Metric) -> float:
        """Return the value of a metric at the start, SI."""
        return self.whole(metric.text, self.start)[0]


def design_problem(
    rig: Rig,
    free: Mapping[str, Bounds],
    objective: Objective,
    constraints: Mapping[str, LimitGiven] | None = None,
    *,
    road: Any = None,
    speed: float | str | None = None,
    trial: Trial | None = None,
    more: Sequence[str] = (),
    **settings: Any,
) -> DesignProblem:
    """Read a design task; ``more`` are further metrics to evaluate, ``settings`` those of the road (SI or texts)."""
    numbers = numbers_of(rig, free)
    units = units_of(rig)
    weights = read_weights(objective)
    metrics = {text: read_metric(text, units, where="objective") for text in weights}
    limits = []
    for text, given in (constraints or {}).items():
        metrics[text] = read_metric(text, units, where="constraints")
        limits.append(read_limit(metrics[text], given))
    metrics |= {text: read_metric(text, units, where="metrics") for text in more}
    family = LinearFamily(rig, tuple(number.path for number in numbers))
    evaluator: StationaryEvaluator | TrialEvaluator
    road_surface: Surface | None = None
    notes: tuple[Finding, ...] = ()
    if trial is not None:
        _refuse_both(road, speed, settings)
        evaluator = TrialEvaluator(family, trial, tuple(metrics.values()))
    else:
        evaluator, notes = stationary_evaluator(
            Families((family,)), tuple(metrics.values()), road, speed, settings
        )
        road_surface = evaluator.surface
    problem = DesignProblem(
        rig, numbers, weights, tuple(limits), evaluator, metrics, road_surface, trial, notes
    )
    for text in weights:
        base = problem.base_of(metrics[text])
        if not (np.isfinite(base) and base != 0.0):
            raise FitError("is zero at the start and cannot be reduced", where=f"objective: {text}")
        problem.base[text] = base
    return problem


def numbers_of(rig: Rig, free: Mapping[str, Bounds]) -> tuple[FreeParameter, ...]:
    """Read the free parameters; reject those without effect on the model, and bounds that the schema forbids."""
    for path in filter(is_constant, free):
        raise DescriptionError(
            "a constant of nature, which no design changes",
            where=f"free: {path}",
            allowed="e.g. springs, dampers, anti-roll bars, hardpoints",
        )
    numbers = free_parameters(
        rig, {path: _strip_sign(bounds) for path, bounds in free.items()}, where="free"
    )
    _check_used(LinearFamily(rig, tuple(number.path for number in numbers)))
    _check_bounds(rig, numbers)
    return numbers


def _strip_sign(bounds: Bounds) -> Bounds:
    return bounds.replace("±", "").replace("+-", "").strip() if isinstance(bounds, str) else bounds


def read_weights(objective: Objective) -> dict[str, float]:
    """Read metrics and their weights."""
    given = {objective: 1.0} if isinstance(objective, str) else dict(objective)
    if not given:
        raise DescriptionError(
            "no objective is given", where="objective", hint='Give one, e.g. {"sprung.az": 1.0}.'
        )
    every: Mapping[str, object] = given  # callers may pass other types than annotated
    for text, number in every.items():
        is_number = isinstance(number, (int, float)) and not isinstance(number, bool)
        if not (is_number and np.isfinite(given[text]) and given[text] > 0.0):
            raise DescriptionError(
                "invalid weight", where=f"objective: {text}", found=number, allowed="above 0"
            )
    return {text: float(weight) for text, weight in given.items()}


def read_limit(metric: Metric, given: LimitGiven) -> Limit:
    """Read the limits of a metric."""
    where = f"constraints: {metric.text}"
    if isinstance(given, (tuple, list)):
        if len(given) != 2:
            raise DescriptionError(
                "invalid limits",
                where=where,
                found=list(given),
                allowed="a value, or (lower, upper)",
            )
        lower, upper = (
            None if side is None else to_si(side, metric.unit, where=where) for side in given
        )
    else:
        text = given.strip() if isinstance(given, str) else given
        is_lower = isinstance(text, str) and text.startswith(">")
        if isinstance(text, str):
            text = text.lstrip("<>= ")
        if text is None:
            raise DescriptionError("no limit", where=where, allowed="a value, or (lower, upper)")
        bound = to_si(_number(text), metric.unit, where=where)
        lower, upper = (bound, None) if is_lower else (None, bound)
    if lower is None and upper is None:
        raise DescriptionError("no limit", where=where, allowed="a value, or (lower, upper)")
    if lower is not None and upper is not None and lower > upper:
        raise DescriptionError(
            "the lower limit is greater than the upper one",
            where=where,
            found=f"{lower:g}, {upper:g}",
        )
    return Limit(metric, lower, upper)


def _number(text: str | float) -> str | float:
    try:
        return float(text)
    except ValueError:
        return text


def _check_used(family: LinearFamily) -> None:
    used = family.compiled.facts.parameters
    for path in family.paths:
        if path not in used:
            raise DescriptionError(
                "the model does not depend on this parameter",
                where=f"free: {path}",
                allowed=", ".join(sorted(used)),
            )


def _check_bounds(rig: Rig, numbers: Sequence[FreeParameter]) -> None:
    """Reject bounds that the description does not allow."""
    for number in numbers:
        for value in (number.lower, number.upper):
            rig.with_changes({number.path: value})


def _refuse_both(road: Any, speed: float | str | None, settings: Mapping[str, Any]) -> None:
    given = {"road": road, "speed": speed, **settings}
    for name, value in given.items():
        if value is not None:
            raise DescriptionError(
                "a trial has its own road", where=name, hint="Give either trial or road and speed."
            )


def stationary_evaluator(
    families: Families,
    metrics: tuple[Metric, ...],
    road: Any,
    speed: float | str | None,
    settings: dict[str, Any],
) -> tuple[StationaryEvaluator, tuple[Finding, ...]]:
    """Return an evaluator on a road: white noise if all metrics are finite on it, otherwise the band of ISO 8608."""
    if road is None or speed is None:
        missing = "road" if road is None else "speed"
        raise DescriptionError(
            Phrase("no {missing}", missing=missing),
            where=missing,
            hint='Give road="C" and speed="20 m/s", or a trial.',
        )
    given = {name: value for name, value in settings.items() if value is not None}
    reasons: dict[str, str] = {}
    for metric in metrics:
        if metric.weighting:
            reasons[metric.text] = "a weighting is a matter of frequencies"
    is_white = given.get("band") is None and not callable(road)
    if is_white and not reasons:
        evaluator = StationaryEvaluator(families, surface(road, speed, **given), metrics)
        reasons = evaluator.absent()
        if not reasons:
            return evaluator, ()
    if not is_white:
        return StationaryEvaluator(families, surface(road, speed, **given), metrics), ()
    evaluator = StationaryEvaluator(
        families, surface(road, speed, **{**given, "band": "iso"}), metrics
    )
    text, reason = next(iter(reasons.items()))
    note = finding("design.band_instead_of_white", text, reason=reason)
    return evaluator, (note,)
