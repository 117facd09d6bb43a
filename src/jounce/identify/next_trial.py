"""Rank possible next trials by their expected information about the parameters.

In the linearised Gaussian case the covariance of the parameters after a trial follows from exact sensitivities and does
not depend on the measured values. The expected information gain is the log of the ratio of the volumes before and after
the trial [lindley1956].
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from jounce.core.errors import FitError, SimulationError
from jounce.core.findings import Finding, finding
from jounce.core.seeds import is_whole
from jounce.core.serialise import Plain
from jounce.core.shown import Shown
from jounce.core.text import align_columns
from jounce.core.types import Array
from jounce.identify.densities import Basis
from jounce.identify.discrepancy import OBSERVATIONS, candidate_information, readings_of
from jounce.identify.fit_problem import FitTrial, prepare_trial, project_out
from jounce.identify.posterior import Posterior
from jounce.parts import Rig
from jounce.parts.rig import check_rig, result_unit_of
from jounce.recordings.sensors import Sensor
from jounce.roads import Trial

_TOLERANCE = 1e-7  # of displacements: its results are slopes, which are less exact than runs


@dataclass(frozen=True)
class Candidate(Shown):
    """A trial that could be run.

    Attributes
    ----------
    name : str
        Name of the trial in the result.
    rig : Rig
        The rig as set up for the trial.
    trial : Trial
        Road and speed, or base motion.
    sensors : dict
        Mapping from channel to sensor, as for :class:`jounce.FitTrial`.
    """

    name: str
    rig: Rig
    trial: Trial
    sensors: Mapping[str, Sensor] = field(default_factory=dict)

    def __post_init__(self) -> None:
        check_rig(self.rig)


@dataclass(frozen=True)
class CandidateGain(Shown):
    """Expected information of a trial.

    Attributes
    ----------
    name : str
        Name of the trial.
    gain : float
        Expected information about all parameters jointly, in nats (1): 0.69 halves one standard deviation.
    standard_errors : dict
        Mapping from path to the standard deviation (SI) after the trial.
    """

    name: str
    gain: float
    standard_errors: dict[str, float]


@dataclass(frozen=True)
class NextTrials(Plain, Shown):
    """Candidate trials, ranked by their expected information.

    Attributes
    ----------
    counted : str
        ``"noise only"`` or ``"model error"``, as in :class:`Posterior`.
    now : dict
        Mapping from path to the current standard deviation (SI).
    units : dict
        Mapping from path to SI unit.
    candidates : tuple of CandidateGain
        Each candidate added to all fitted trials, sorted by decreasing gain.
    series : tuple of CandidateGain
        The best candidate, the best one after it, and so on; ``gain`` (1) is relative to the previous one.
    findings : tuple of Finding
        Trials that could not be evaluated, and limitations of the ranking.
    """

    counted: str
    now: dict[str, float]
    units: dict[str, str]
    candidates: tuple[CandidateGain, ...]
    series: tuple[CandidateGain, ...]
    findings: tuple[Finding, ...] = ()

    def __str__(self) -> str:
        rows = [["trial", "gain [nat]", *(f"{path} [{self.units[path]}]" for path in self.now)]]
        rows.append(["today", "", *(f"±{value:.4g}" for value in self.now.values())])
        rows += [
            [
                candidate.name,
                f"{candidate.gain:.3g}",
                *(f"±{value:.4g}" for value in candidate.standard_errors.values()),
            ]
            for candidate in self.candidates[:20]
        ]
        best = ", then ".join(candidate.name for candidate in self.series)
        lines = [line.rstrip() for line in align_columns(rows)]
        return "\n".join([*lines, f"one after the other: {best}", *map(str, self.findings)])


def next_trials(
    found: Posterior | Basis, candidates: Sequence[Candidate], *, count: int = 3
) -> NextTrials:
    """Rank trials by their expected information about the parameters of a posterior.

    Parameters
    ----------
    found : Posterior or Basis
        Result of :func:`posterior`, or its ``basis``. If it includes model error, new trials include it as well, and
        the information is that about the component values (``component``).
    candidates : sequence of Candidate
        Trials that could be run, with channels that were fitted.
    count : int
        Length of the series in which each trial is the best after the previous ones, 1 or more. A trial may appear more
        than once.

    Returns
    -------
    NextTrials

    Raises
    ------
    FitError
        No candidates, no candidate that can be simulated, or a posterior that does not come from an update.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("kart-quarter-car")
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm"), speed="2 m/s", duration="1 s")
    >>> clean = jn.simulate(rig, trial)[["sprung.az"]]
    >>> measured = jn.apply_sensors(clean, {"sprung.az": jn.Sensor(noise="0.1 m/s^2")}, seed=1)
    >>> found = jn.posterior([jn.FitTrial("one", rig, trial, measured)], {"strut.spring.rate": "10 %"}, draws=1000)
    >>> slow, fast = (trial.model_copy(update={"speed": speed}) for speed in (2.0, 6.0))
    >>> ranked = next_trials(found, [Candidate("slow", rig, slow), Candidate("fast", rig, fast)], count=1)
    >>> ranked.candidates[0].gain > ranked.candidates[1].gain > 0.0
    True
    """
    basis = found.basis if isinstance(found, Posterior) else found
    if basis is None:
        raise FitError("the posterior does not come from an update", where="next_trials")
    if not candidates:
        raise FitError("no trial to choose from", where="candidates")
    if not (is_whole(count) and count >= 1):
        raise FitError("invalid number of trials", where="count", found=count, allowed="1 or more")
    judge = _WithDoubt(basis) if basis.calibration is not None else _NoiseOnly(basis)
    informations, findings = {}, []
    for candidate in candidates:
        try:
            informations[candidate.name] = judge.information(candidate)
        except SimulationError as error:
            findings.append(finding("identify.cannot_be_judged", candidate.name, error=error))
    if not informations:
        raise FitError(
            "none of the trials can be simulated", where="candidates", found=str(findings[0])
        )
    paths = [item.path for item in basis.free]
    start = judge.start

    def gain_of(name: str, known: Array) -> CandidateGain:
        before, after = judge.covariance(known), judge.covariance(known + informations[name])
        gain = 0.5 * float(np.linalg.slogdet(before)[1] - np.linalg.slogdet(after)[1])
        return CandidateGain(
            name, gain, dict(zip(paths, np.sqrt(np.diag(after)).tolist(), strict=True))
        )

    every = sorted((gain_of(name, start) for name in informations), key=lambda judged: -judged.gain)
    series, known = [], start
    for _ in range(count):
        best = max((gain_of(name, known) for name in informations), key=lambda judged: judged.gain)
        series.append(best)
        known = known + informations[best.name]
    now = dict(zip(paths, np.sqrt(np.diag(judge.covariance(start))).tolist(), strict=True))
    units = {path: result_unit_of(basis.trials[0].rig, path) for path in paths}
    counted = "noise only" if basis.calibration is None else "model error"
    return NextTrials(counted, now, units, tuple(every), tuple(series), tuple(findings))


def _simulated_recording(candidate: Candidate, basis: Basis) -> FitTrial:
    """Return the trial with a simulated recording of the fitted channels at the fitted rate."""
    from jounce.simulation import simulate

    fitted = basis.trials[0]
    time = fitted.measured["time"].to_numpy()
    step = float(np.median(np.diff(time)))
    names = [str(name) for name in fitted.measured.data_vars]
    run = simulate(candidate.rig, candidate.trial, output_step=step, tolerance=1e-5)
    sensors = {**fitted.sensors, **candidate.sensors}
    return FitTrial(
        candidate.name, candidate.rig, candidate.trial, run[[n for n in names if n in run]], sensors
    )


class _NoiseOnly:
    """Information about scaled parameters; candidates have the weights of the fitted trials' residuals."""

    def __init__(self, basis: Basis) -> None:
        self.basis = basis
        self.scale = np.array([item.half_range for item in basis.free])
        self.start: Array = np.asarray(np.linalg.inv(basis.covariance), dtype=float)
        plain = sum((self._plain(trial) for trial in basis.trials), np.zeros_like(self.start))
        ratio = np.linalg.slogdet(self.start)[1] - np.linalg.slogdet(plain)[1]
        self.weight = float(np.exp(ratio / len(self.scale)))

    def covariance(self, information: Array) -> Array:
        """Return the covariance of the parameters, SI."""
        return np.asarray(np.linalg.inv(information) * np.outer(self.scale, self.scale))

    def information(self, candidate: Candidate) -> Array:
        """Return the information that a trial adds."""
        return self.weight * self._plain(_simulated_recording(candidate, self.basis))

    def _plain(self, trial: FitTrial) -> Array:
        """Return the information of a trial with white residuals, with a free lag if lags were fitted."""
        basis = self.basis
        prepared = prepare_trial(trial, basis.free, replace(basis.settings, weights="printed"))
        values = np.array([basis.values[item.path] for item in basis.free])
        solution = prepared.solve(values, _TOLERANCE)
        scales = self.scale * prepared.factors
        rows, slopes = [], []
        for channel in prepared.channels:
            if channel.name not in basis.residual:
                continue
            table = prepared.table(channel, solution)
            table, slope = channel.offset(table, np.gradient(table[:, 0]) * prepared.rate)
            rows.append(table[:, 1:] * scales / basis.residual[channel.name])
            slopes.append(slope / basis.residual[channel.name])
        if not rows:
            raise FitError(
                "none of the fitted channels", where=trial.name, allowed=", ".join(basis.residual)
            )
        jacobian = np.vstack(rows)
        if basis.settings.fits_lags:
            project_out(jacobian, np.concatenate(slopes))
        return np.asarray(jacobian.T @ jacobian)


class _WithDoubt:
    """Information about scaled parameters and doubts that all trials share."""

    def __init__(self, basis: Basis) -> None:
        self.basis = basis
        assert basis.calibration is not None
        self.fit = basis.calibration
        self.read = readings_of(self.fit)
        size = self.read.slopes.shape[-1]
        self.start: Array = np.asarray(
            np.linalg.inv(self.fit.step.covariance[:size, :size]), dtype=float
        )
        self.noise = self.fit.step.noise
        self.rest = {name: share / OBSERVATIONS for name, share in self.fit.rest.items()}

    def covariance(self, information: Array) -> Array:
        """Return the covariance of the component values that a test machine would measure, SI."""
        slopes = self.read.slopes[0]
        return np.asarray(slopes @ np.linalg.inv(information) @ slopes.T)

    def information(self, candidate: Candidate) -> Array:
        """Return the information that a trial adds; the unexplained part scales with the signal as in fitted trials."""
        return candidate_information(
            self.fit, _simulated_recording(candidate, self.basis), self.noise, self.rest
        )
