"""Model updating: fit parameters of a model to measurements."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Annotated, Any

import numpy as np

from jounce.core.errors import FitError, SimulationError
from jounce.core.findings import Finding, finding
from jounce.core.results import Shows, own_unit
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.identify.datum import with_datums
from jounce.identify.discrepancy import (
    FEWEST_TRIALS,
    Discrepancy,
    ModelErrorFit,
    discrepancy_of,
    fit_model_error,
)
from jounce.identify.doubt import Doubt
from jounce.identify.estimate import Estimate, correlation_of, r_squared
from jounce.identify.fit_problem import (
    FitTrial,
    FreeParameter,
    Residuals,
    UpdateProblem,
    free_parameters,
)
from jounce.identify.leftovers import LeftOver, beyond_noise, faults
from jounce.identify.nuisances import (
    SPEED,
    START,
    SearchedNuisance,
    SearchedStart,
    begins_unknown,
    nuisances_of,
)
from jounce.identify.search import AT_BOUND, SAME_PLACE, Optimum, SearchOutcome, search_from_starts
from jounce.identify.settings import UpdateSettings
from jounce.identify.stated_masses import loads_held_against_masses, preferred_masses
from jounce.identify.suspects import CLEARLY, suspects
from jounce.identify.trials_compared import disagreeing, exchanged_channels, unlike
from jounce.parts import Rig
from jounce.parts.rig import result_unit_of, unit_of

# what the data can tell -----------------------------------------------------------------------------------------------


_WEAK = 1e-6  # share of the largest norm or singular value: the size of simulation errors
_ALIKE = 0.98  # correlation: with the other parameter known, the interval would be a fifth as wide


@dataclass(frozen=True)
class Identifiability:
    """Sensitivity of the data to each unknown, at the start values; arrays in the order of ``parameters``.

    ``sensitivity`` is the r.m.s. change of the weighted residuals for one scaled unit of each unknown.
    ``singular_values`` are those of the scaled sensitivity matrix, descending, ``condition`` is the ratio of largest to
    smallest, and ``rank`` the number of distinguishable directions. ``correlation`` is the expected correlation of the
    estimates. Findings report parameters without influence and pairs with similar effects.
    """

    parameters: tuple[str, ...]
    sensitivity: tuple[float, ...]
    singular_values: tuple[float, ...]
    rank: int
    condition: float
    correlation: tuple[tuple[float, ...], ...]
    findings: tuple[Finding, ...]


def identifiability(jacobian: Array, names: tuple[str, ...]) -> Identifiability:
    """Assess identifiability from the derivatives of the residuals by the scaled unknowns."""
    norms = np.linalg.norm(jacobian, axis=0)
    singular = np.linalg.svd(np.linalg.qr(jacobian, mode="r"), compute_uv=False)
    rank = int(np.sum(singular > _WEAK * singular[0])) if singular[0] > 0.0 else 0
    correlation = correlation_of(
        np.asarray(np.linalg.pinv(jacobian.T @ jacobian, hermitian=True), dtype=float)
    )
    findings = [
        finding("identify.insensitive", name, 0.0)
        for name, norm in zip(names, norms, strict=True)
        if norm <= _WEAK * norms.max()
    ]
    pairs = [(i, j) for i in range(len(names)) for j in range(i) if abs(correlation[i, j]) > _ALIKE]
    findings += [
        finding("identify.cannot_be_told_apart", names[i], value, other=names[j], correlation=value)
        for i, j in pairs
        for value in (correlation[i, j],)
    ]
    condition = float(singular[0] / singular[-1]) if singular[-1] > 0.0 else float("inf")
    return Identifiability(
        names,
        tuple(float(norm) / np.sqrt(len(jacobian)) for norm in norms),
        tuple(float(value) for value in singular),
        rank,
        condition,
        tuple(tuple(float(value) for value in row) for row in correlation),
        tuple(findings),
    )


# uncertainty ----------------------------------------------------------------------------------------------------------


_SHARE = 20  # the level of the residuals is taken over this share of a record
_LEAST = 1e-12  # share of the largest level below which there is only rounding, without motion
_FEWEST = 25  # samples, at least
_REACH = 3  # ratio to the lag at which the residuals become uncorrelated


def robust_covariance(vector: Array, jacobian: Array, blocks: tuple[slice, ...]) -> Array:
    """Compute the covariance of least-squares estimates under autocorrelated noise of changing level.

    It is the sandwich ``(J'J)^-1 (J' G J) (J'J)^-1``, where ``G`` is the covariance of the residuals, from their level
    (moving r.m.s.) and their significant autocorrelation, tapered by Bartlett weights [newey1987]. For white residuals
    of constant level this is the classical covariance. The autocorrelation is that of the residuals, not of the scores
    ``J r``: the scores sum to zero at the optimum, which would make intervals too short. ``blocks`` are the rows of
    each channel of each trial; residuals of different blocks are assumed to be independent.
    """
    from scipy.signal import oaconvolve

    count, unknowns = jacobian.shape
    bread = np.linalg.pinv(jacobian.T @ jacobian, hermitian=True)
    meat = np.zeros((unknowns, unknowns))
    for block in blocks:
        level = _level(vector[block])
        least = max(_LEAST * float(np.max(level, initial=0.0)), np.finfo(float).tiny)
        correlation = _correlation(vector[block] / np.maximum(level, least))
        touched = np.flatnonzero(jacobian[block].any(axis=0))
        if not len(touched):
            continue
        rows = jacobian[block][:, touched] * level[:, None]
        kernel = np.concatenate([correlation[::-1], [1.0], correlation])
        meat[np.ix_(touched, touched)] += rows.T @ oaconvolve(
            rows, kernel[:, None], mode="same", axes=0
        )
    meat = 0.5 * (meat + meat.T)
    return np.asarray(bread @ meat @ bread * (count / max(count - unknowns, 1)))


def _level(residuals: Array) -> Array:
    """Return the root mean square of the residuals around each sample."""
    width = min(max(_FEWEST, len(residuals) // _SHARE), len(residuals))
    summed = np.concatenate([[0.0], np.cumsum(residuals**2)])
    first = np.clip(np.arange(len(residuals)) - width // 2, 0, len(residuals) - width)
    return np.asarray(np.sqrt(np.maximum(summed[first + width] - summed[first], 0.0) / width))


def _correlation(residuals: Array) -> Array:
    """Return the tapered autocorrelation from lag 1 on; empty if the residuals are white."""
    count = len(residuals)
    energy = float(residuals @ residuals)
    longest = count // 4
    values = (
        np.array([residuals[lag:] @ residuals[:-lag] / energy for lag in range(1, longest)])
        if energy > 0.0
        else np.zeros(0)
    )
    quiet = np.flatnonzero(np.abs(values) < 2.0 / np.sqrt(count))  # as 95 % of white noise
    end = int(quiet[0]) if len(quiet) else len(values)
    reach = min(_REACH * end, len(values))
    return np.asarray(values[:reach] * (1.0 - np.arange(1, reach + 1) / (reach + 1.0)))


# update ---------------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class UpdatedParameter(Shown):
    """One fitted parameter, all values in the SI unit of its path.

    Attributes
    ----------
    initial, value : float
        Start value and estimate, in SI.
    standard_error : float or None
        Standard error due to noise only, in SI: the scatter of the estimate over repeated trials. It excludes model
        error, which shifts the estimate by the same amount each time; see ``UpdateResult.discrepancy``. None if the
        estimate is at a bound or the data are insensitive to the parameter.
    interval : tuple of float or None
        95 % interval due to noise only, in SI.
    lower, upper : float
        Bounds, in SI.
    at_bound : bool
        Whether the estimate is at a bound.
    unit : str
        SI unit of all these values.
    """

    initial: Annotated[float, Shows("start", own_unit, 5)]
    value: Annotated[float, Shows("value", own_unit, 6)]
    standard_error: Annotated[float | None, Shows("standard error, noise only", own_unit, 2)]
    interval: Annotated[tuple[float, float] | None, Shows("95 % interval, noise only", own_unit, 6)]
    lower: float
    upper: float
    at_bound: Annotated[bool, Shows("at bound")]
    unit: str


def _units(update: Any) -> dict[str, str]:
    return {path: parameter.unit for path, parameter in update.parameters.items()}


@dataclass(frozen=True)
class UpdateResult(Shown):
    """Outcome of one update.

    Attributes
    ----------
    name, method : str
        Name and method as requested.
    objective_before, objective_after, reduction_percent : float
        Sum of squares at the start and at the optimum, in the squared units of the (weighted) channels, and
        ``100 (before - after) / before``.
    iterations, evaluations : int
        Iterations of the optimiser that found the optimum, and total number of simulations of the set of trials.
    parameters : dict
        Mapping from path to ``UpdatedParameter``.
    correlation : tuple
        Correlation matrix (1) of the estimates, in the order of ``parameters`` (then nuisances, then lags).
    lags : dict
        Mapping from trial to lag of its recording behind the simulation, s; empty if not aligned.
    identifiability : Identifiability
        Identifiability of the parameters at the start values.
    findings : tuple of Finding
        Limitations of the result.
    discrepancy : Discrepancy or None
        The parameters with intervals that include model error; None if this was not requested or fewer than three
        trials were fitted.
    nuisances : dict
        Mapping from nuisance (speed in m/s, corners of low passes in Hz, amplitudes at the start in m) to
        ``UpdatedParameter``.
    offsets : dict
        Mapping from trial to its estimated initial distance from equilibrium, SI by state.
    """

    name: Annotated[str, Shows("update")]
    method: Annotated[str, Shows("method")]
    objective_before: Annotated[float, Shows("objective before", "1")]
    objective_after: Annotated[float, Shows("objective after", "1")]
    reduction_percent: Annotated[float, Shows("reduction [%]", "1")]
    iterations: Annotated[int, Shows("iterations")]
    evaluations: Annotated[int, Shows("evaluations")]
    parameters: Annotated[dict[str, UpdatedParameter], Shows("Parameters")]
    correlation: tuple[tuple[float, ...], ...]
    lags: dict[str, float]
    identifiability: Identifiability
    findings: tuple[Finding, ...] = field(default_factory=tuple)
    discrepancy: Discrepancy | None = None
    nuisances: Annotated[dict[str, UpdatedParameter], Shows("Nuisances")] = field(
        default_factory=dict
    )
    offsets: dict[str, dict[str, float]] = field(default_factory=dict)

    @property
    def parts(self) -> Annotated[dict[str, Estimate], Shows(", as the part has it", _units)]:
        """Component values by path, with intervals that include model error, SI; empty without a discrepancy."""
        laws = {} if self.discrepancy is None else self.discrepancy.parameters
        return {
            path: Estimate(law.value, 0.5 * law.half_width, law.interval)
            for path, law in laws.items()
        }

    def values(self) -> dict[str, float]:
        """Fitted values by path, SI."""
        return {path: parameter.value for path, parameter in self.parameters.items()}


def update_model(  # noqa: PLR0913 - each is a choice of its own
    trials: Sequence[FitTrial] | FitTrial,
    free: Mapping[str, str | float | Sequence[str | float] | Mapping[str, Any]],
    *,
    name: str = "update",
    method: str = "least-squares",
    weights: str | Mapping[str, float] = "printed",
    channels: Sequence[str] | None = None,
    align: str | None = None,
    lag_bound: float = 0.02,
    starts: int | None = None,
    seed: int = 1,
    tolerance: float = 1e-8,
    doubt: Doubt | Mapping[str, Any] | None = None,
    nuisances: Mapping[str, Any] | None = None,
    bench: Mapping[str, Estimate] | None = None,
) -> UpdateResult:
    """Fit parameters of a rig to the recordings of one or several trials.

    Parameters
    ----------
    trials : FitTrial or sequence of FitTrial
        Set-up and recording of each trial; its rig contains the start values. A free parameter whose start value
        differs between trials (tyre stiffness at two pressures) gets one common factor; values are those of the first
        trial. The zero of a channel is the ``datum`` of its sensor, by default determined from the quiet start of the
        record, with a finding.
    free : dict
        Mapping from path to bounds: ``"10 %"`` of the start value to either side, or ``[lower, upper]`` with units.
        With ``doubt`` also ``{"bounds": "10 %", "prior": ["22.7 N/mm", "0.1 N/mm"]}``, with mean and standard deviation
        of prior knowledge, which is used for intervals that include model error.
    name : str
        Name of the result.
    method : {"least-squares", "bfgs"}
        Trust-region least squares, or the paper's BFGS with bounds; both with exact gradients.
    weights : {"printed", "normalised"} or dict
        Eq. 2 of paper 1 as printed (every squared difference counts 1), each channel by its variance and length, or a
        weight for each channel's squared differences.
    channels : sequence of str, optional
        Channels to compare; all common ones by default.
    align : {None, "lag"}
        Estimate a time lag for each trial together with the parameters, within ``lag_bound``.
    lag_bound : float
        Largest lag to either side, s.
    starts : int, optional
        Number of start points: the start values, then points spread over the bounds. The default is one; with ``doubt``
        the search continues from further points until the best optimum has been found twice.
    seed : int
        Seed of the start points.
    tolerance : float
        Relative error of the simulated displacements.
    doubt : Doubt or dict, optional
        Uncertainty of model and measurements; with at least three trials the result then has intervals that include it
        (``discrepancy``). ``jn.Doubt()`` contains the defaults.
    nuisances : dict, optional
        Unknowns outside the rig, estimated with the parameters: ``{"speed": "5 %"}`` (one common factor on the stated
        speeds), ``{"sprung.az.low_pass": ["20 Hz", "400 Hz"]}`` (corner of an undeclared second-order low pass of a
        channel, in all trials), ``{"start": "2 mm"}`` (maximum amplitude of each natural vibration at the start of each
        trial's record, due to earlier excitation). The intervals of ``doubt`` estimate them again together with all
        uncertain inputs.
    bench : dict, optional
        Mapping from path to the estimate of a component test (SI); a finding reports contradictions with the update.

    Returns
    -------
    UpdateResult

    Raises
    ------
    FitError
        No trial, no free parameter, fewer data than parameters, bounds that exclude the start, impossible settings, an
        optimiser that stalls.
    DescriptionError
        An unknown parameter or channel.
    SimulationError
        A simulation that diverges.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("kart-quarter-car")
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="1 s")
    >>> truth = rig.with_changes({"strut.spring.rate": "24 N/mm"})
    >>> measured = jn.simulate(truth, trial, tolerance=1e-8)[["sprung.az"]]
    >>> result = jn.update_model([jn.FitTrial("one", rig, trial, measured)], {"strut.spring.rate": "10 %"})
    >>> round(result.parameters["strut.spring.rate"].value, 3)
    24000.0
    """
    trials = [trials] if isinstance(trials, FitTrial) else trials
    settings = UpdateSettings(
        name,
        method,
        weights,
        channels,
        align,
        lag_bound,
        starts,
        seed,
        tolerance,
        doubt,
        nuisances,
        bench,
    )
    return run_update(trials, free, settings)[0]


def run_update(
    trials: Sequence[FitTrial], free: Mapping[str, Any], settings: UpdateSettings
) -> tuple[UpdateResult, ModelErrorFit | None]:
    """Update a model like :func:`update_model`; also return the final extended model if model error is included."""
    name, doubt, align = settings.name, settings.doubts, settings.fits_lags
    if not trials:
        raise FitError(
            "no trial to fit",
            where=name,
            hint='Mark trials with use = "fit" or name their numbers.',
        )
    ranges, priors = bounds_and_priors(trials[0].rig_without, free, name)
    if priors and doubt is None:
        raise FitError(
            "a prior requires doubt",
            where=f"{name}: {next(iter(priors))}",
            hint="Give doubt, e.g. doubt = jn.Doubt(), or leave out the prior.",
        )
    bounds = free_parameters(trials[0].rig_without, ranges, where=name)
    if START in (settings.nuisances or {}) or (doubt is not None and doubt.start > 0.0):
        trials = [
            trial.in_motion(trial.offset) if begins_unknown(trial) else trial for trial in trials
        ]
    trials, datums = with_datums(trials, settings.channels)
    datums += loads_held_against_masses(trials)
    unknowns = nuisances_of(settings.nuisances or {}, trials, f"{name}: nuisances")
    problem = UpdateProblem(trials, bounds, settings, unknowns)
    start = np.array(
        [item.scale(item.initial) for item in (*bounds, *(nuisance.free for nuisance in unknowns))]
    )
    names = (
        *(item.path for item in bounds),
        *(nuisance.name for nuisance in unknowns),
        *(f"lag of {t.name}" for t in trials if align),
    )
    known = identifiability(_whole(problem, start), names)
    before, _ = problem.objective(start)
    swapped = exchanged_channels(_residuals_by_channel(problem, problem.residuals(start)))
    starts = 1 if settings.starts is None and doubt is None else settings.starts
    search = search_from_starts(problem, start, settings.method, settings.seed, starts=starts)
    best = search.best
    findings = [
        *datums,
        *known.findings,
        *_stall(name, best, before),
        *_other_minima(name, problem, search),
    ]
    findings += _common_factors(problem)
    residuals = problem.residuals(best.scaled)
    left = _residuals_by_channel(problem, residuals)
    findings += [
        *swapped,
        *_unexplained_channels(problem, residuals),
        *_copies(problem),
        *_frozen(problem),
    ]
    at_bound = np.abs(best.scaled) > AT_BOUND
    findings += disagreeing(problem, residuals, best.scaled, ~at_bound) or unlike(left)
    whole = _whole(problem, best.scaled)
    inside = ~np.pad(at_bound, (0, whole.shape[1] - len(at_bound)))
    loud = [channel for channel, parts in left.items() if beyond_noise(parts) is not None]
    suspected = suspects(problem, residuals, best.scaled, whole[:, inside], loud)
    findings += [finding for _, finding in suspected]
    if loud:
        findings += preferred_masses(problem, best.scaled)
    for channel, parts in left.items():
        if not any(
            finding.place in (channel, SPEED) or share > CLEARLY for share, finding in suspected
        ):
            findings += faults(channel, parts, settings.lag_bound, is_aligned=align)
    inner = np.atleast_1d(whole.any(axis=0))
    inner[: len(at_bound)] &= ~at_bound
    covariance = np.zeros((len(inner), len(inner)))
    if inner.any():
        covariance[np.ix_(inner, inner)] = robust_covariance(
            residuals.vector, whole[:, inner], residuals.blocks
        )
    parameters = {}
    for i, (item, fitted) in enumerate(zip(problem.free, problem.values(best.scaled), strict=True)):
        value = float(fitted)
        error = (
            None
            if at_bound[i] or covariance[i, i] <= 0.0
            else float(np.sqrt(covariance[i, i])) * item.half_range
        )
        interval = None if error is None else (value - 1.96 * error, value + 1.96 * error)
        parameters[item.path] = UpdatedParameter(
            item.initial,
            value,
            error,
            interval,
            item.lower,
            item.upper,
            bool(at_bound[i]),
            result_unit_of(trials[0].rig, item.path),
        )
        if at_bound[i]:
            findings.append(finding("identify.on_bound", item.path, value))
    found_beside = {
        nuisance.name: _beside(nuisance, scaled, variance, is_bound)
        for nuisance, scaled, variance, is_bound in zip(
            unknowns,
            best.scaled[len(bounds) :],
            np.diag(covariance)[len(bounds) : problem.size],
            at_bound[len(bounds) :],
            strict=True,
        )
    }
    findings += _of_nuisances(found_beside)
    lags = (
        dict(zip((t.source.name for t in problem.trials), residuals.lags.tolist(), strict=True))
        if align
        else {}
    )
    correlations = correlation_of(covariance)
    alike = _correlated_pairs(names[: problem.size], correlations)
    at_start = [item for item in known.findings if any(item.place == pair.place for pair in alike)]
    findings = [
        *alike,
        *_far_masses(trials[0].rig, parameters),
        *(item for item in findings if item not in at_start),
    ]
    discrepancy = calibration = None
    for nuisance, scaled in zip(unknowns, best.scaled[len(bounds) :], strict=True):
        trials = [nuisance.apply_to(trial, nuisance.free.value(scaled)) for trial in trials]
    if doubt is not None:
        values = {path: parameter.value for path, parameter in parameters.items()}
        found_beside_of = {
            START if isinstance(nuisance, SearchedStart) else nuisance.name: nuisance.width
            for nuisance in unknowns
        }
        calibration, more = _with_doubt(
            trials, bounds, values, settings, lags, priors, found_beside_of
        )
        if calibration is not None:
            discrepancy = discrepancy_of(calibration, settings.bench or {})
            more = list(discrepancy.findings)
        findings = [*more, *findings]
    if discrepancy is None:
        findings += _beyond_noise(left)
    result = UpdateResult(
        name,
        settings.method,
        before,
        best.objective,
        100.0 * (before - best.objective) / before if before > 0.0 else 0.0,
        best.iterations,
        problem.evaluations,
        parameters,
        tuple(tuple(float(v) for v in row) for row in correlations),
        lags,
        known,
        tuple(findings),
        discrepancy,
        found_beside,
        {trial.name: dict(trial.offset) for trial in trials if trial.offset},
    )
    return result, calibration


def _beside(
    nuisance: SearchedNuisance | SearchedStart, scaled: float, variance: float, is_bound: bool
) -> UpdatedParameter:
    """Return the reported estimate of a nuisance: value and interval in its unit."""
    free, value = nuisance.free, float(nuisance.free.value(scaled))
    error = None if is_bound or variance <= 0.0 else float(np.sqrt(variance)) * free.half_range
    ends = None if error is None else (value - 1.96 * error, value + 1.96 * error)
    if not nuisance.is_inverse:
        return UpdatedParameter(
            free.initial, value, error, ends, free.lower, free.upper, is_bound, nuisance.unit
        )
    interval = None if ends is None else (1.0 / max(ends[1], 1e-12), 1.0 / max(ends[0], 1e-12))
    return UpdatedParameter(
        1.0 / free.initial, 1.0 / value, None if error is None else error / value**2, interval,
        1.0 / free.upper, 1.0 / free.lower, is_bound, nuisance.unit,
    )  # fmt: skip


def _of_nuisances(nuisances: Mapping[str, UpdatedParameter]) -> list[Finding]:
    """Report the estimated nuisances, which should be added to the description of trials and sensors."""
    findings = []
    starts = {name: parameter for name, parameter in nuisances.items() if f": {START}, " in name}
    if starts:
        name, largest = max(starts.items(), key=lambda item: abs(item[1].value))
        findings.append(
            finding(
                "identify.starts_found", START, largest.value, value=abs(largest.value), which=name
            )
        )
    for name, parameter in nuisances.items():
        low, high = parameter.interval or (None, None)
        if parameter.at_bound:
            code = "identify.nuisance_on_bound"
        elif name in starts:
            continue
        elif name == SPEED:
            code = (
                "identify.speed_found"
                if parameter.interval is None
                else "identify.speed_found_within"
            )
        else:
            code = (
                "identify.low_pass_found"
                if parameter.interval is None
                else "identify.low_pass_found_within"
            )
        excess = parameter.value / parameter.initial - 1.0 if parameter.initial else 0.0
        findings.append(
            finding(
                code,
                name,
                parameter.value,
                value=parameter.value,
                unit=parameter.unit,
                low=low,
                high=high,
                excess=excess,
            )
        )
    return findings


_CORRELATED = 0.9  # with the other parameter known, the interval would be less than half as wide
_FAR = 0.05  # of a mass that was weighed


def _correlated_pairs(names: Sequence[str], correlation: Array) -> list[Finding]:
    """Report pairs of estimates of which the data determine a combination rather than each value."""
    findings = []
    for i, name in enumerate(names):
        for j in range(i):
            value = float(correlation[i, j])
            if abs(value) > _CORRELATED:
                findings.append(
                    finding(
                        "identify.strongly_correlated",
                        name,
                        value,
                        other=names[j],
                        correlation=value,
                    )
                )
    return findings


def _far_masses(rig: Rig, parameters: Mapping[str, UpdatedParameter]) -> list[Finding]:
    """Report masses that differ much from their weighed values."""
    findings = []
    for path, parameter in parameters.items():
        if not path.endswith("mass") or rig.is_estimated(path) or parameter.initial <= 0.0:
            continue
        moved = parameter.value / parameter.initial - 1.0
        if abs(moved) > _FAR:
            findings.append(finding("identify.mass_moved", path, moved, moved=moved))
    return findings


def bounds_and_priors(
    rig: Rig, free: Mapping[str, Any], name: str
) -> tuple[dict[str, Any], dict[str, tuple[float, float]]]:
    """Return bounds, and mean and standard deviation (SI) of the parameters with a prior."""
    ranges, priors = {}, {}
    for path, given in free.items():
        ranges[path] = given
        if not isinstance(given, Mapping):
            continue
        where = f"{name}: {path}"
        if (
            set(given) != {"bounds", "prior"}
            or not isinstance(given["prior"], Sequence)
            or len(given["prior"]) != 2
        ):
            allowed = '{bounds = "10 %", prior = [mean, standard deviation]}'
            raise FitError(
                "invalid bounds for a parameter with a prior",
                where=where,
                found=dict(given),
                allowed=allowed,
            )
        ranges[path] = given["bounds"]
        if path in rig.parameters():
            mean, deviation = (
                to_si(value, unit_of(rig, path), where=where) for value in given["prior"]
            )
            if deviation <= 0.0:
                raise FitError(
                    "invalid standard deviation",
                    where=where,
                    found=given["prior"][1],
                    allowed="above 0",
                )
            priors[path] = mean, deviation
    return ranges, priors


def _with_doubt(
    trials: Sequence[FitTrial],
    free: Sequence[FreeParameter],
    values: Mapping[str, float],
    settings: UpdateSettings,
    lags: Mapping[str, float],
    priors: Mapping[str, tuple[float, float]],
    found_beside: Mapping[str, float],
) -> tuple[ModelErrorFit | None, list[Finding]]:
    """Fit the extended model; return its final state, or the reason why it cannot be fitted."""
    if len(trials) < FEWEST_TRIALS:
        return None, [
            finding(
                "identify.noise_only_few_trials",
                "intervals",
                len(trials),
                severity="warning" if priors else "note",
                fewest=FEWEST_TRIALS,
                trials=len(trials),
            )
        ]
    try:
        return fit_model_error(
            trials, free, values, settings, lags=lags, priors=priors, found_beside=found_beside
        ), []
    except SimulationError as error:
        return None, [finding("identify.noise_only", "intervals", error=error)]


def _whole(problem: UpdateProblem, scaled: Array) -> Array:
    """Return derivatives of the residuals by all estimates: scaled parameters, then lags relative to their bound."""
    residuals = problem.residuals(scaled)
    return residuals.with_lags(problem.lag_bound) if problem.align else residuals.direct


def _stall(name: str, optimum: Optimum, before: float) -> list[Finding]:
    if optimum.converged:
        return []
    if optimum.objective >= before * (1.0 - 1e-12) and before > 0.0:
        raise FitError(
            "the optimiser stalled at the start values",
            where=name,
            hint="Try the other method, wider bounds, several starts, or fewer parameters.",
        )
    return [finding("identify.not_settled", name, optimum.objective)]


def _other_minima(name: str, problem: UpdateProblem, search: SearchOutcome) -> list[Finding]:
    """Report other optima of the search, with a warning for those that fit nearly as well."""
    best, findings = search.best, []
    if not search.is_confirmed:
        findings.append(
            finding("identify.best_fit_once", name, search.starts, others=search.starts - 1)
        )
    if not search.others:
        return findings
    other = search.others[0]
    ratio = other.objective / best.objective if best.objective > 0.0 else np.inf
    moved = (
        (free.path, free.value(place), result_unit_of(problem.trials[0].source.rig, free.path))
        for free, place, here in zip(problem.free, other.scaled, best.scaled, strict=False)
        if abs(place - here) > SAME_PLACE
    )
    values = ", ".join(f"{path} {value:.4g} {unit}".rstrip() for path, value, unit in moved)
    count, ratio = len(search.others), min(ratio, 999.0)
    if ratio < _NEARLY:
        return [
            *findings,
            finding(
                "identify.other_fit_as_good",
                name,
                ratio,
                count=count,
                starts=search.starts,
                values=values,
                ratio=ratio,
            ),
        ]
    return [
        *findings,
        finding(
            "identify.other_fit_worse",
            name,
            ratio,
            count=count,
            starts=search.starts,
            values=values,
            ratio=ratio,
        ),
    ]


_NEARLY = 1.5
"""Ratio to the minimum sum of squares below which a second minimum may be the true one, as the model is not exact.

Model error changes the ratio of the sums of two minima by tens of per cent (foreign benches).
"""


_EXPLAINED = 0.5  # minimum explained share of a channel's variance


def _unexplained_channels(problem: UpdateProblem, residuals: Residuals) -> list[Finding]:
    """Report channels of which the updated model explains little: values fitted to them are not valid."""
    both = [(trial, channel) for trial in problem.trials for channel in trial.channels]
    poor = dict[str, dict[str, float]]()
    for (trial, channel), block in zip(both, residuals.blocks, strict=True):
        measured = channel.weight * channel.measured
        explained = r_squared(measured, residuals.vector[block])
        if channel.weight > 0.0 and explained < _EXPLAINED:
            poor.setdefault(channel.name, {})[trial.source.name] = explained
    findings = []
    for name, shares in poor.items():
        least = min(shares.values())
        code = "identify.explains_little_of_more" if len(shares) > 4 else "identify.explains_little"
        trials = ", ".join(list(shares)[:4])
        findings.append(
            finding(code, name, least, trials=trials, more=len(shares) - 4, least=least)
        )
    return findings


def _residuals_by_channel(
    problem: UpdateProblem, residuals: Residuals
) -> dict[str, list[LeftOver]]:
    """Return the residuals of each weighted channel, by trial, with the recordings shifted by their lags."""
    both = [(trial, channel) for trial in problem.trials for channel in trial.channels]
    left = dict[str, list[LeftOver]]()
    for (trial, channel), block in zip(both, residuals.blocks, strict=True):
        if channel.weight > 0.0:
            read = channel.measured - residuals.vector[block] / channel.weight
            part = LeftOver(trial.source.name, channel.measured, read, trial.rate, channel.noise)
            left.setdefault(channel.name, []).append(part)
    return left


def _beyond_noise(left: Mapping[str, Sequence[LeftOver]]) -> list[Finding]:
    """Report that intervals due to noise understate the uncertainty if residuals exceed the noise."""
    loud = {
        name: times for name, parts in left.items() if (times := beyond_noise(parts)) is not None
    }
    if not loud:
        return []
    channels = ", ".join(f"{name} ({min(times, 99.0):.2g} times)" for name, times in loud.items())
    return [finding("identify.more_than_noise", "intervals", max(loud.values()), channels=channels)]


def _copies(problem: UpdateProblem) -> list[Finding]:
    """Report trials with the same recording as a different trial, which add no information."""
    first, findings = dict[tuple[bytes, ...], str](), []
    for trial in problem.trials:
        record = tuple(channel.measured.tobytes() for channel in trial.channels)
        if record in first:
            findings.append(
                finding("identify.copy_of_trial", trial.source.name, other=first[record])
            )
        first.setdefault(record, trial.source.name)
    return findings


def _frozen(problem: UpdateProblem) -> list[Finding]:
    """Report channels of which parts are left out because the record is stuck at one value while the rig moves."""
    trials = dict[str, list[str]]()
    for trial in problem.trials:
        for channel in trial.channels:
            if channel.frozen is not None:
                trials.setdefault(channel.name, []).append(
                    f"{trial.source.name} ({channel.frozen.sum()} samples)"
                )
    return [
        finding("identify.frozen_left_out", name, trials=", ".join(where))
        for name, where in trials.items()
    ]


def _common_factors(problem: UpdateProblem) -> list[Finding]:
    findings = []
    for i, free in enumerate(problem.free):
        factors = [trial.factors[i] for trial in problem.trials]
        if max(factors) - min(factors) > 1e-9:
            findings.append(
                finding("identify.common_factor", free.path, max(factors) / min(factors))
            )
    return findings
