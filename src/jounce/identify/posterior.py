"""Posterior of updated parameters: Gaussian, profile likelihood, samples, and predictions for every trial.

There are two kinds of posterior. *Noise only*: the residuals are noise, autocorrelated and of changing level. The
least-squares density is rotated and scaled to match the covariance that an update reports (the curvature adjustment of
composite likelihoods [ribatet2012]). *Model error*: all doubts are unknowns with priors, as in
:mod:`jounce.identify.discrepancy`; they are integrated out around their best values for each value of the parameters
(nested Laplace approximation [tierney1986]).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np

from jounce.core.errors import FitError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.results import Shows, group_table, own_unit
from jounce.core.seeds import check_seed, is_whole
from jounce.core.serialise import Plain
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.identify.datum import with_datums
from jounce.identify.densities import Basis, DoubtDensity, NoiseDensity
from jounce.identify.discrepancy import FEWEST_TRIALS, noise_variance, readings_of
from jounce.identify.doubt import Doubt
from jounce.identify.estimate import Estimate, correlation_of
from jounce.identify.fit_problem import (
    Channel,
    FitTrial,
    FreeParameter,
    Residuals,
    UpdateProblem,
    free_parameters,
)
from jounce.identify.log_density import (
    Convergence,
    LogDensity,
    by_ensemble,
    convergence,
    fit_log_density,
    profile,
    sample,
)
from jounce.identify.prediction import RICHER, PredictionBand, bands_of
from jounce.identify.settings import UpdateSettings
from jounce.identify.update import UpdateResult, bounds_and_priors, run_update
from jounce.parts.rig import result_unit_of

if TYPE_CHECKING:
    import xarray as xr


_FEWEST, _MOST = (
    1000,
    10_000_000,
)  # draws: 25 lie beyond each end of a 95 % interval; 80 MB for each parameter
HALF_DROP = 1.920729410347062
"""Drop of the log likelihood at the ends of a 95 % interval: half of chi^2 with one degree of freedom."""
MOST_R_HAT, FEWEST_DRAWS = 1.01, 400.0
"""Limits for converged draws: maximum R-hat (1), minimum number of effective draws [vehtari2021]."""
_TOLERANCE = 1e-6  # with model error: a log density moves by some thousandths, and simulations take half the time
MOST_ERROR = 0.5
"""Error of the log density above which it is reported: it changes weights of draws by a factor of 1.6."""

Progress = Callable[[str], None]


def _silent(_text: str) -> None:
    """Ignore progress messages."""


@dataclass(frozen=True)
class PosteriorParameter(Shown):
    """Posterior of one parameter, SI.

    Attributes
    ----------
    unit : str
        SI unit.
    value : float
        Maximum of the density (noise only), or middle of the interval (model error included).
    mean, standard_deviation : float
        Mean and standard deviation of the draws, in SI; with model error those of the component value.
    interval : tuple of float
        95 % interval of the draws: of the parameter (noise only), or the hull of the intervals of component and
        effective value (model error included), as in :class:`jounce.Discrepancy`.
    gaussian : tuple of float or None
        95 % interval of the Gaussian approximation, in SI.
    likelihood : tuple of float or None
        95 % interval of the profile likelihood, in SI; None if it extends beyond the bounds. With model error it is
        that of the extended model's parameter.
    convergence : Convergence
        Rank-normalised R-hat and effective numbers of draws (1).
    """

    unit: str
    value: Annotated[float, Shows("value", own_unit)]
    mean: float
    standard_deviation: float
    interval: Annotated[tuple[float, float], Shows("95 %", own_unit)]
    gaussian: tuple[float, float] | None
    likelihood: tuple[float, float] | None
    convergence: Convergence

    @property
    def r_hat(self) -> Annotated[float, Shows("R-hat", "1")]:
        """Rank-normalised R-hat [1]."""
        return self.convergence.r_hat

    @property
    def effective_draws(self) -> Annotated[int, Shows("effective draws")]:
        """Effective number of draws in the bulk."""
        return round(self.convergence.bulk)


@dataclass(frozen=True)
class LikelihoodProfile(Shown):
    """Profile log likelihood: one parameter varies, all others are at their best fit; 0 at its maximum.

    Attributes
    ----------
    values, log_likelihood : ndarray, shape (points,)
        Values of the parameter (SI) and log likelihood relative to its maximum (1).
    """

    values: Array
    log_likelihood: Array

    def interval(self) -> tuple[float, float] | None:
        """Return the ends at which the log likelihood has dropped by 1.92 (95 %); None if it does not drop that far."""
        top = int(np.argmax(self.log_likelihood))
        ends = []
        for side in (range(top, -1, -1), range(top, len(self.values))):
            before = top
            for k in side:
                if self.log_likelihood[k] < -HALF_DROP:
                    pair = sorted((k, before), key=lambda i: self.log_likelihood[i])
                    ends.append(
                        float(np.interp(-HALF_DROP, self.log_likelihood[pair], self.values[pair]))
                    )
                    break
                before = k
        return (ends[0], ends[1]) if len(ends) == 2 else None


@dataclass(frozen=True)
class Posterior(Plain, Shown):
    """Posterior of the parameters of a fit.

    Attributes
    ----------
    name : str
        Name of the update.
    counted : str
        ``"noise only"`` or ``"model error"``.
    parameters : dict
        Mapping from path to ``PosteriorParameter``.
    correlation : tuple
        Correlation matrix (1) of the draws, in the order of ``parameters``.
    profiles : dict
        Mapping from path to ``LikelihoodProfile``.
    predictions : dict
        Mapping from trial to channel to ``PredictionBand``: prediction and measurement.
    draws, chains : int
        Number of draws and number of chains.
    accepted : float
        Share of accepted steps (1).
    evaluations : int
        Number of exact evaluations of the density (each simulates all fitted trials).
    density_error : float
        Standard deviation (1) of the error of the sampled log density, at draws that were evaluated exactly. With model
        error the curvature of the doubts jumps where the number of wheel lift-offs changes: its trend over the
        parameters is sampled, and the trend's standard error is included.
    seed : int
        Seed of all random numbers.
    samples : xarray.Dataset
        Draws with dimensions ``chain`` and ``draw``, SI. Noise only: each parameter, named by its path. With model
        error: ``component of PATH`` and ``effective of PATH``, whose hull is the interval, see
        :class:`jounce.Discrepancy`. ``richer value of PATH`` is the parameter of the extended model, in addition to all
        doubts; it scatters less than component and effective value and is not the value of a part.
    update : UpdateResult or None
        The update that the posterior starts from.
    findings : tuple of Finding
        Limitations of the result.
    basis : Basis or None
        Input of :func:`next_trials`; None for other fits.
    """

    left_out = ("samples", "update", "basis")

    name: str
    counted: str
    parameters: dict[str, PosteriorParameter]
    correlation: tuple[tuple[float, ...], ...]
    profiles: dict[str, LikelihoodProfile]
    predictions: dict[str, dict[str, PredictionBand]]
    draws: int
    chains: int
    accepted: float
    evaluations: int
    density_error: float
    seed: int
    samples: xr.Dataset = field(repr=False)
    update: UpdateResult | None = field(repr=False, default=None)
    findings: tuple[Finding, ...] = ()
    basis: Basis | None = field(repr=False, default=None)

    def __str__(self) -> str:
        title = f"Posterior of {self.name}, {self.counted}: {self.draws} draws"
        return "\n".join([str(group_table(title, self.parameters)), *map(str, self.findings)])


@dataclass(frozen=True)
class UpdatedDensity:
    """An update with the density around its estimate."""

    update: UpdateResult
    density: NoiseDensity | DoubtDensity
    basis: Basis
    findings: tuple[Finding, ...]


def update_with_density(
    trials: Sequence[FitTrial],
    free: Mapping[str, Any],
    settings: UpdateSettings,
    progress: Progress,
) -> UpdatedDensity:
    """Update a model, and return the density of its parameters and its basis."""
    name, doubt = settings.name, settings.doubts
    progress(Phrase("{name}: update", name=name))
    bounds_ = bounds_and_priors(trials[0].rig_without, free, name)[0] if trials else {}
    update, calibration = run_update(trials, free, settings)
    limits = free_parameters(trials[0].rig_without, bounds_, where=name)
    trials = with_datums(trials, settings.channels)[0]
    findings = [item for item in update.findings if item.severity != "note"]
    values = update.values()
    if doubt is not None and len(trials) >= FEWEST_TRIALS:
        if calibration is None:
            why = next(item.message for item in update.findings if item.place == "intervals")
            raise FitError(
                "model error cannot be included", where=name, found=why, hint="Leave out doubt."
            )
        calibration.problem.tolerance = _TOLERANCE
        density: NoiseDensity | DoubtDensity = DoubtDensity(calibration)
        basis = Basis(tuple(trials), limits, calibration, density.covariance, values, settings)
    else:
        if doubt is not None:
            findings.append(
                finding(
                    "identify.posterior_of_noise",
                    "posterior",
                    len(trials),
                    fewest=FEWEST_TRIALS,
                    trials=len(trials),
                )
            )
        problem = UpdateProblem(trials, limits, settings)
        best = np.array([item.scale(values[item.path]) for item in limits])
        lowest = np.array([item.scale(0.0) if item.lower >= 0.0 else -np.inf for item in limits])
        size = len(limits)
        density = NoiseDensity(problem, best, -np.ones(size), np.ones(size), lowest)
        basis = Basis(
            tuple(trials), limits, None, density.covariance, values, settings,
            _levels_of(problem, best, _noise_level),
            _levels_of(problem, best, lambda _, residual: float(np.mean(residual**2))),
        )  # fmt: skip
    return UpdatedDensity(update, density, basis, tuple(findings))


def posterior(  # noqa: PLR0913 - each is a choice of its own
    trials: Sequence[FitTrial] | FitTrial,
    free: Mapping[str, str | float | Sequence[str | float] | Mapping[str, Any]],
    *,
    name: str = "update",
    method: str = "least-squares",
    weights: str | Mapping[str, float] = "normalised",
    channels: Sequence[str] | None = None,
    align: str | None = None,
    starts: int | None = None,
    doubt: Doubt | Mapping[str, Any] | None = None,
    bench: Mapping[str, Estimate] | None = None,
    draws: int = 20_000,
    seed: int = 1,
    predict: Sequence[FitTrial] | FitTrial | None = None,
    predicted_with: int = 50,
    progress: Progress = _silent,
) -> Posterior:
    """Update a model and return the posterior of its parameters: draws, intervals, predictions.

    Parameters
    ----------
    trials : FitTrial or sequence of FitTrial
        Set-up and recording of each trial, as for :func:`update_model`.
    free : dict
        Mapping from path to bounds (SI or text with a unit), with ``doubt`` also to bounds and prior, as for
        :func:`update_model`. The prior is uniform within the bounds. With ``doubt`` the bounds only guide the update,
        and negative values are impossible unless the lower bound is negative.
    name, method, channels, align, starts
        As for :func:`update_model`.
    weights : {"printed", "normalised"} or dict
        As for :func:`update_model` (1).
    bench : dict, optional
        As for :func:`update_model` (SI).
    doubt : Doubt or dict, optional
        Uncertainty of model and measurements: with at least three trials the draws then include model error. Without it
        they include noise only.
    draws : int
        Number of draws, at least: 1000 to 10 million.
    seed : int
        Seed of all random numbers.
    predict : sequence of FitTrial, optional
        Trials to predict bands for, by default the fitted ones; an empty sequence for none.
    predicted_with : int
        Number of draws that are simulated exactly for each of these trials: 2 to 10 000. The width of a band is as
        uncertain as a standard deviation of so many draws: 10 % with 50.
    progress : callable
        Function that receives progress messages, each one line of text.

    Returns
    -------
    Posterior
        Draws, intervals and predictions, SI.

    Raises
    ------
    FitError
        As :func:`update_model`, and for an invalid number of draws, two trials with the same name, or data insensitive
        to a parameter.
    MissingPackageError
        Without the packages of the extra ``posterior``.

    Notes
    -----
    The log density is a polynomial through exact values and slopes of the model at some tens of points, sampled by
    emcee and compared with exact values at new draws (``density_error``). ArviZ computes the diagnostics.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("kart-quarter-car")
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="1 s")
    >>> clean = jn.simulate(rig.with_changes({"strut.spring.rate": "24 N/mm"}), trial)[["sprung.az"]]
    >>> measured = jn.apply_sensors(clean, {"sprung.az": jn.Sensor(noise="0.1 m/s^2")}, seed=1)
    >>> found = jn.posterior([jn.FitTrial("one", rig, trial, measured)], {"strut.spring.rate": "10 %"}, draws=2000)
    >>> low, high = found.parameters["strut.spring.rate"].interval
    >>> low < 24e3 < high
    True
    """
    trials = [trials] if isinstance(trials, FitTrial) else trials
    predict = [predict] if isinstance(predict, FitTrial) else predict
    settings = UpdateSettings(
        name, method, weights, channels, align, starts=starts, doubt=doubt, bench=bench
    )
    return posterior_with(
        trials, free, settings, draws=draws, seed=seed, predict=predict, predicted_with=predicted_with,
        progress=progress,
    )  # fmt: skip


def posterior_with(
    trials: Sequence[FitTrial], free: Mapping[str, Any], settings: UpdateSettings, *, draws: int, seed: int,
    predict: Sequence[FitTrial] | None, progress: Progress, predicted_with: int = 50,
) -> Posterior:  # fmt: skip
    """Return the posterior of an update with these settings, as :func:`posterior` does."""
    _check_counts(draws, predicted_with, seed)
    _check_names(trials, "trials")
    _check_names(predict or (), "predict")
    name, at = settings.name, update_with_density(trials, free, settings, progress)
    density, basis, update = at.density, at.basis, at.update
    chosen = basis.trials if predict is None else with_datums(predict, settings.channels)[0]
    limits = basis.free
    progress(Phrase("{name}: evaluating the density around the estimate", name=name))
    table = fit_log_density(density, density.region, seed)
    progress(Phrase("{name}: {draws} draws", name=name, draws=draws))
    units = {item.path: result_unit_of(basis.trials[0].rig, item.path) for item in limits}
    sampled = _sample_and_describe(name, density, table, limits, units, draws, seed, update)
    result = replace(
        sampled, update=update, basis=basis, findings=(*at.findings, *sampled.findings)
    )
    if not chosen:
        return result
    progress(Phrase("{name}: predictions for {count} trials", name=name, count=len(chosen)))
    predictions = bands_of(density, basis, result.samples, chosen, predicted_with, seed)
    return replace(
        result,
        predictions=predictions,
        findings=(*result.findings, *_missed_predictions(result, predictions)),
    )


def posterior_of(
    residuals: Callable[[Array], tuple[Array, Array]],
    free: Mapping[str, tuple[float, float, float]],
    *,
    name: str = "fit",
    draws: int = 20_000,
    seed: int = 1,
) -> Posterior:
    """Compute the posterior of the parameters of any least-squares fit, noise only.

    Parameters
    ----------
    residuals : callable
        Function that returns residuals (n,) and their derivatives (n, parameters) for values (parameters,); all
        residuals have the same unit.
    free : dict
        Mapping from name to estimate, lower and upper bound, in the unit of the parameter (SI or any other); the
        estimate minimises the sum of squares.
    name : str
        Name of the result.
    draws : int
        Number of draws, at least: 1000 to 10 million.
    seed : int
        Seed of all random numbers.

    Returns
    -------
    Posterior
        The posterior, without predictions.

    Raises
    ------
    FitError
        As :func:`posterior`, and for an estimate outside its bounds.

    Examples
    --------
    >>> import numpy as np
    >>> x = np.linspace(0.0, 1.0, 200)
    >>> y = 2.0 * x + 0.1 * np.random.default_rng(1).normal(size=200)
    >>> slope = float(x @ y / (x @ x))
    >>> found = posterior_of(lambda p: (y - p[0] * x, -x[:, None]), {"slope": (slope, 0.0, 4.0)}, draws=2000)
    >>> low, high = found.parameters["slope"].interval
    >>> bool(low < 2.0 < high)
    True
    """
    _check_counts(draws, 2, seed)
    limits = []
    for path, (value, lower, upper) in free.items():
        if not lower <= value <= upper or not lower < upper:
            raise FitError(
                "the bounds exclude the estimate",
                where=path,
                found=value,
                allowed=Phrase("{lower:g} to {upper:g}", lower=lower, upper=upper),
            )
        limits.append(FreeParameter(path, value, lower, upper))
    if not limits:
        raise FitError("no free parameter", where=name)
    density = NoiseDensity(
        _Given(residuals, tuple(limits)), np.array([item.scale(item.initial) for item in limits]),
        -np.ones(len(limits)), np.ones(len(limits)), np.full(len(limits), -np.inf),
    )  # fmt: skip
    table = fit_log_density(density, density.region, seed)
    return _sample_and_describe(
        name, density, table, limits, dict.fromkeys(free, ""), draws, seed, None
    )


@dataclass(frozen=True)
class _Given:
    """Residuals given by a function of the values."""

    function: Callable[[Array], tuple[Array, Array]]
    free: tuple[FreeParameter, ...]

    def residuals(self, scaled: Array) -> Residuals:
        """Return residuals with their derivatives by scaled unknowns."""
        values = np.array([item.value(s) for item, s in zip(self.free, scaled, strict=True)])
        try:
            vector, jacobian = (np.asarray(part, dtype=float) for part in self.function(values))
        except TypeError:
            allowed = "residuals, shape (n,), and their derivatives, shape (n, m)"
            raise FitError(
                "the function returns an unexpected result", where="residuals", allowed=allowed
            ) from None
        whole = slice(0, len(vector))
        direct = jacobian.reshape(len(vector), -1) * np.array(
            [item.half_range for item in self.free]
        )
        return Residuals(vector, direct, np.zeros(len(vector)), (whole,), (whole,), np.zeros(1))


def _check_counts(draws: int, predicted_with: int, seed: int) -> None:
    check_seed(seed, FitError)
    for where, given, low, high in (
        ("draws", draws, _FEWEST, _MOST),
        ("predicted_with", predicted_with, 2, 10_000),
    ):
        if not (is_whole(given) and low <= given <= high):
            raise FitError(
                "invalid number of draws",
                where=where,
                found=given,
                allowed=Phrase("{low} to {high}", low=low, high=high),
            )


def _check_names(trials: Sequence[FitTrial], where: str) -> None:
    """Raise an error for two trials with the same name, which identifies predictions and lags."""
    names = [trial.name for trial in trials]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise FitError(
            "two trials have the same name",
            where=where,
            found=twice,
            hint="Give each trial its own name.",
        )


def _noise_level(channel: Channel, residual: Array) -> float:
    return max(noise_variance(residual), (channel.noise or 0.0) ** 2)


def _levels_of(
    problem: UpdateProblem, best: Array, power: Callable[[Channel, Array], float]
) -> dict[str, float]:
    """Return the standard deviation (SI) by channel, from a power of the residuals."""
    powers: dict[str, list[float]] = {}
    residuals = problem.residuals(best)
    channels = [channel for trial in problem.trials for channel in trial.channels]
    for channel, block in zip(channels, residuals.blocks, strict=True):
        if channel.weight > 0.0:
            powers.setdefault(channel.name, []).append(
                power(channel, residuals.vector[block] / channel.weight)
            )
    return {name: float(np.sqrt(np.mean(values))) for name, values in powers.items()}


def _sample_and_describe(
    name: str, density: NoiseDensity | DoubtDensity, table: LogDensity, free: Sequence[FreeParameter],
    units: Mapping[str, str], draws: int, seed: int, update: UpdateResult | None,
) -> Posterior:  # fmt: skip
    """Sample a density and summarise the draws."""
    import xarray as xr

    u, accepted = sample(table, draws, seed)
    chains, each, size = u.shape
    x = table.region.unknowns(u.reshape(-1, size))
    law = np.column_stack([free[i].value(0.0) + free[i].half_range * x[:, i] for i in range(size)])
    by = RICHER if isinstance(density, DoubtDensity) else ""
    columns = {f"{by}{item.path}": law[:, i] for i, item in enumerate(free)}
    if isinstance(density, DoubtDensity):
        columns = _readings(density, x, free, seed) | columns
    data = {
        name: (
            ("chain", "draw"),
            column.reshape(chains, each),
            {"units": units[name.rpartition(" of ")[2]]},
        )
        for name, column in columns.items()
    }
    samples = xr.Dataset(
        data, {"chain": np.arange(chains), "draw": np.arange(each)}, {"seed": seed, "update": name}
    )
    errors = np.sqrt(np.diag(density.covariance))
    profiles, parameters = {}, {}
    for i, item in enumerate(free):
        scaled, height = profile(table, i)
        profiles[item.path] = LikelihoodProfile(item.value(0.0) + item.half_range * scaled, height)
        error = float(errors[i]) * item.half_range
        value = item.value(float(table.region.centre[i]))
        gaussian: tuple[float, float] | None = (value - 1.96 * error, value + 1.96 * error)
        shown = [columns[f"{by}{item.path}"]]
        if isinstance(density, DoubtDensity):
            shown = [columns[f"{kind} of {item.path}"] for kind in ("component", "effective")]
            gaussian = None
            if update is not None and update.discrepancy is not None:
                gaussian = update.discrepancy.parameters[item.path].interval
        ends = np.array([np.quantile(series, (0.025, 0.975)) for series in shown])
        interval = float(ends[:, 0].min()), float(ends[:, 1].max())
        if isinstance(density, DoubtDensity):
            value = 0.5 * (interval[0] + interval[1])
        worst = max(
            (convergence(by_ensemble(series.reshape(chains, each))) for series in shown),
            key=lambda series: series.r_hat,
        )
        parameters[item.path] = PosteriorParameter(
            units[item.path], value, float(np.mean(shown[0])), float(np.std(shown[0])), interval, gaussian,
            profiles[item.path].interval(), worst,
        )  # fmt: skip
    first = [columns["component of " * bool(by) + item.path] for item in free]
    correlation = correlation_of(np.atleast_2d(np.cov(np.array(first))))
    counted = "model error" if isinstance(density, DoubtDensity) else "noise only"
    return Posterior(
        name, counted, parameters, tuple(tuple(float(v) for v in row) for row in correlation), profiles, {},
        chains * each, chains, accepted, table.evaluations, table.error, seed, samples,
        findings=tuple(_weak(parameters, table.error, free, counted)),
    )  # fmt: skip


def _readings(
    density: DoubtDensity, x: Array, free: Sequence[FreeParameter], seed: int
) -> dict[str, Array]:
    """Return draws of component and effective value of each parameter, SI.

    The unexplained residual is known from the fitted trials only: deviations have the tails of Student's t
    distribution.
    """
    from scipy.stats import chi2

    fit = density.fit
    read = readings_of(fit)
    q = len(fit.problem.nuisances)
    steps = np.column_stack([x - fit.state.theta, density.doubts(x, seed)[:, :q]])
    level = np.random.default_rng([seed, 8]).random(len(x))
    columns = {}
    for k, kind in enumerate(("component", "effective")):
        moved = steps @ read.slopes[k].T
        for i, item in enumerate(free):
            freedom = float(read.freedom[k, i])
            # From 10 000 degrees of freedom on, tails are normal to 1 %.
            tails = np.sqrt(freedom / chi2.ppf(level, freedom)) if freedom < 1e4 else 1.0
            centre = float(np.mean(moved[:, i]))
            values = read.values[k, i] + centre + tails * (moved[:, i] - centre)
            columns[f"{kind} of {item.path}"] = (
                np.maximum(values, 0.0) if item.lower >= 0.0 else values
            )
    return columns


def _weak(
    parameters: Mapping[str, PosteriorParameter],
    error: float,
    free: Sequence[FreeParameter],
    counted: str,
) -> list[Finding]:
    findings = []
    if error > MOST_ERROR:
        findings.append(finding("identify.log_density_off", "posterior", error, spread=error))
    for path, parameter in parameters.items():
        worst = min(parameter.convergence.bulk, parameter.convergence.tail)
        if parameter.convergence.r_hat > MOST_R_HAT or worst < FEWEST_DRAWS:
            findings.append(
                finding(
                    "identify.not_converged",
                    path,
                    parameter.convergence.r_hat,
                    r_hat=parameter.convergence.r_hat,
                    draws=worst,
                )
            )
    for item in free if counted == "noise only" else ():
        low, high = parameters[item.path].interval
        # A fiftieth of its interval: a bound there cuts off draws.
        near = [
            end
            for end, at in ((low, item.lower), (high, item.upper))
            if abs(end - at) < 0.02 * (high - low)
        ]
        if near:
            findings.append(finding("identify.draws_at_bound", item.path, near[0]))
    return findings


def _missed_predictions(
    posterior: Posterior, predictions: Mapping[str, Mapping[str, PredictionBand]]
) -> list[Finding]:
    """Report channels whose recording is largely outside the predicted band."""
    every = [
        (band.inside, f"{t}, {c}")
        for t, channels in predictions.items()
        for c, band in channels.items()
    ]
    missed = sorted(entry for entry in every if entry[0] < _LITTLE)
    if not missed:
        return []
    share, place = missed[0]
    code = "identify.missed_by_noise" if posterior.counted == "noise only" else "identify.missed"
    numbers: dict[str, Any] = {"signals": len(missed), "all": len(every), "little": _LITTLE}
    return [finding(code, "predictions", share, place=place, share=share, **numbers)]


_LITTLE = 0.8  # of a signal, where 95 % are expected inside
