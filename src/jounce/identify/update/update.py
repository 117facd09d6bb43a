"""Model updating: find the parameters with which the model gives what was measured."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from jounce.core.errors import FitError
from jounce.core.findings import Finding
from jounce.identify.update.free import free_parameters
from jounce.identify.update.identifiability import Identifiability, correlation_of, identifiability
from jounce.identify.update.optimise import Optimum, check_method, minimise_from_many
from jounce.identify.update.problem import FitTrial, UpdateProblem
from jounce.identify.update.uncertainty import robust_covariance


@dataclass(frozen=True)
class UpdatedParameter:
    """One fitted parameter, all values in the SI unit of its path.

    Attributes
    ----------
    initial, value : float
        Start value and estimate, in SI.
    standard_error : float or None
        In SI; None where the estimate lies on a bound or the data do not
        react to the parameter.
    interval : tuple of float or None
        95 % interval, in SI.
    lower, upper : float
        Bounds, in SI.
    at_bound : bool
        Whether the estimate lies on a bound.
    """

    initial: float
    value: float
    standard_error: float | None
    interval: tuple[float, float] | None
    lower: float
    upper: float
    at_bound: bool


@dataclass(frozen=True)
class UpdateResult:
    """Outcome of one update.

    Attributes
    ----------
    name, method : str
        As asked for.
    objective_before, objective_after, reduction_percent : float
        Sum of squares at the start and at the optimum, in the squared units of the (weighted) channels, and
        ``100 (before - after) / before``.
    iterations, evaluations : int
        Of the optimiser that found the optimum, and simulations of the whole set of trials in all.
    parameters : dict
        Path to ``UpdatedParameter``.
    correlation : tuple
        Correlation matrix (1) of the estimates, in the order of ``parameters`` (then lags).
    lags : dict
        Trial to lag of its recording behind the simulation, s; empty when not aligned.
    identifiability : Identifiability
        What the data could tell before the fit.
    findings : tuple of Finding
        What weakens the result.
    """

    name: str
    method: str
    objective_before: float
    objective_after: float
    reduction_percent: float
    iterations: int
    evaluations: int
    parameters: dict[str, UpdatedParameter]
    correlation: tuple[tuple[float, ...], ...]
    lags: dict[str, float]
    identifiability: Identifiability
    findings: tuple[Finding, ...] = field(default_factory=tuple)

    def values(self) -> dict[str, float]:
        """Fitted values by path, SI."""
        return {path: parameter.value for path, parameter in self.parameters.items()}


def update_model(  # noqa: PLR0913 - each is a choice of its own
    trials: Sequence[FitTrial],
    free: Mapping[str, str | float | Sequence[str | float]],
    *,
    name: str = "update",
    method: str = "least-squares",
    weights: str | Mapping[str, float] = "printed",
    channels: Sequence[str] | None = None,
    align: str | None = None,
    lag_bound: float = 0.02,
    starts: int = 1,
    seed: int = 1,
    tolerance: float = 1e-8,
) -> UpdateResult:
    """Fit parameters of a rig to the recordings of one or several trials.

    Parameters
    ----------
    trials : sequence of FitTrial
        What was run and measured; each carries its rig with start values. A free parameter whose start value differs
        between trials (tyre stiffness at two pressures) gets one common factor; values are those of the first trial.
    free : dict
        Path to bounds: ``"10 %"`` of the start value to either side, or ``[lower, upper]`` with units.
    name : str
        Names the result.
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
    starts : int
        Number of start points: the start values, then Latin-hypercube points within the bounds.
    seed : int
        Of the start points.
    tolerance : float
        Relative error of the simulated displacements.

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
    check_method(method)
    if not trials:
        raise FitError("no trial to fit", where=name, hint='Mark trials with use = "fit" or name their numbers.')
    if align not in (None, "lag"):
        raise FitError("unknown alignment", where=name, found=align, allowed='none, or "lag"')
    if starts < 1:
        raise FitError("not a number of starts", where=name, found=starts, allowed="1 or more")
    if not (np.isfinite(lag_bound) and lag_bound > 0.0):
        raise FitError("not a largest lag", where=name, found=f"{lag_bound} s", allowed="above 0 s")
    bounds = free_parameters(trials[0].rig, free, where=name)
    problem = UpdateProblem(
        trials,
        bounds,
        channels=channels,
        weights=weights,
        align=align == "lag",
        lag_bound=lag_bound,
        tolerance=tolerance,
    )
    start = np.array([item.scaled(item.initial) for item in bounds] + [0.0] * (problem.size - len(bounds)))
    names = (*(item.path for item in bounds), *(f"lag of {t.name}" for t in trials if align))
    known = identifiability(problem.residuals(start).jacobian, names)
    before, _ = problem.objective(start)
    optima = minimise_from_many(problem, start, method, starts, seed)
    findings = [*known.findings, *_stall(name, optima[0], before), *_several_minima(name, optima)]
    findings += _common_factors(problem)
    return _result(name, method, problem, known, before, optima[0], findings)


def _result(
    name: str,
    method: str,
    problem: UpdateProblem,
    known: Identifiability,
    before: float,
    optimum: Optimum,
    findings: list[Finding],
) -> UpdateResult:
    residuals = problem.residuals(optimum.scaled)
    at_bound = np.abs(optimum.scaled) > 1.0 - 1e-5
    inner = ~at_bound
    covariance = np.zeros((problem.size, problem.size))
    if inner.any():
        covariance[np.ix_(inner, inner)] = robust_covariance(
            residuals.vector, residuals.jacobian[:, inner], residuals.blocks
        )
    parameters = {}
    for i, (free, value) in enumerate(zip(problem.free, problem.values(optimum.scaled), strict=True)):
        error = None if at_bound[i] or covariance[i, i] <= 0.0 else float(np.sqrt(covariance[i, i])) * free.half_range
        interval = None if error is None else (float(value) - 1.96 * error, float(value) + 1.96 * error)
        parameters[free.path] = UpdatedParameter(
            free.initial, float(value), error, interval, free.lower, free.upper, bool(at_bound[i])
        )
        if at_bound[i]:
            text = "ends on its bound: the data ask for more than is allowed, or the model lacks something"
            findings.append(Finding(free.path, "warning", text, float(value)))
    lags = problem.lags(optimum.scaled)
    return UpdateResult(
        name,
        method,
        before,
        optimum.objective,
        100.0 * (before - optimum.objective) / before if before > 0.0 else 0.0,
        optimum.iterations,
        problem.evaluations,
        parameters,
        tuple(tuple(float(v) for v in row) for row in correlation_of(covariance)),
        {trial.source.name: float(lag) for trial, lag in zip(problem.trials, lags, strict=True)}
        if problem.align
        else {},
        known,
        tuple(findings),
    )


def _stall(name: str, optimum: Optimum, before: float) -> list[Finding]:
    if optimum.converged:
        return []
    if optimum.objective >= before * (1.0 - 1e-12) and before > 0.0:
        raise FitError(
            "the optimiser stalled at the start values",
            where=name,
            hint="Try the other method, wider bounds, several starts, or fewer parameters.",
        )
    text = (
        "the optimiser stopped before it converged; the values may not be the best: try the other method or more starts"
    )
    return [Finding(name, "warning", text, optimum.objective)]


def _several_minima(name: str, optima: list[Optimum]) -> list[Finding]:
    best = optima[0]
    other = [o for o in optima[1:] if np.max(np.abs(o.scaled - best.scaled)) > 1e-3]
    if not other:
        return []
    text = f"{len(other)} of {len(optima)} starts ended elsewhere, the next best at {other[0].objective:.4g}"
    return [Finding(name, "note", text, other[0].objective)]


def _common_factors(problem: UpdateProblem) -> list[Finding]:
    findings = []
    for i, free in enumerate(problem.free):
        factors = [trial.factors[i] for trial in problem.trials]
        if max(factors) - min(factors) > 1e-9:
            text = "start values differ between the trials; one common factor is fitted, the value is the first trial's"
            findings.append(Finding(free.path, "note", text, float(max(factors) / min(factors))))
    return findings
