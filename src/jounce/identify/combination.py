"""Several estimates, or several decays, as one."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from jounce.core.errors import FitError
from jounce.core.findings import Finding
from jounce.identify.decay import DecayResult
from jounce.identify.estimate import Estimate, at_least_zero, estimate


@dataclass(frozen=True)
class CombinedDecay:
    """Damping from several decays of the same system.

    Attributes
    ----------
    damping_ratio, damping_coefficient, coulomb_force, natural_frequency_hz, stiffness, logarithmic_decrement : Estimate
        As in :class:`DecayResult`, over all runs; the intervals honour the scatter between runs.
    equilibrium : Estimate or None
        [m]; None when a run has none.
    cycles : float
        Sum over the runs [1].
    runs : int
        Number of decays.
    findings : tuple of Finding
        Those of the runs, and runs that contradict each other.
    """

    damping_ratio: Estimate
    damping_coefficient: Estimate
    coulomb_force: Estimate
    natural_frequency_hz: Estimate
    equilibrium: Estimate | None
    stiffness: Estimate
    logarithmic_decrement: Estimate
    cycles: float
    runs: int
    findings: tuple[Finding, ...]


def combine_decays(results: Sequence[DecayResult]) -> CombinedDecay:
    """Combine several decays of the same system into one estimate per quantity.

    Runs are weighted by their own variance plus the variance between runs (DerSimonian and Laird); the interval is that
    of Hartung and Knapp with (runs - 1) degrees of freedom, never narrower than the runs' own errors allow.

    Parameters
    ----------
    results : sequence of DecayResult
        At least one.

    Returns
    -------
    CombinedDecay
        One run is passed on unchanged.

    Raises
    ------
    FitError
        For no results.
    """
    if not results:
        raise FitError("no decays to combine", allowed="at least one")
    names = (
        "damping_ratio",
        "damping_coefficient",
        "coulomb_force",
        "natural_frequency_hz",
        "stiffness",
        "logarithmic_decrement",
    )
    combined = {name: combine([getattr(result, name) for result in results]) for name in names}
    for name in ("damping_ratio", "damping_coefficient", "coulomb_force"):
        combined[name] = at_least_zero(combined[name])
    centres = [result.equilibrium for result in results if result.equilibrium is not None]
    findings = [finding for result in results for finding in result.findings]
    frequencies = [result.natural_frequency_hz.value for result in results]
    if np.ptp(frequencies) > 0.05 * float(np.mean(frequencies)):
        findings.append(
            Finding(
                "decays",
                "warning",
                f"the natural frequencies of the runs differ from {min(frequencies):.4g} to "
                f"{max(frequencies):.4g} Hz: was something changed between them?",
                float(np.ptp(frequencies)),
            )
        )
    return CombinedDecay(
        **combined,
        equilibrium=combine(centres) if len(centres) == len(results) else None,
        cycles=float(sum(result.cycles for result in results)),
        runs=len(results),
        findings=tuple(findings),
    )


def combine(estimates: Sequence[Estimate]) -> Estimate:
    """Combine independent estimates of one quantity (random effects).

    Parameters
    ----------
    estimates : sequence of Estimate
        All in the same unit.

    Returns
    -------
    Estimate
        Weighted mean; without a standard error on every entry the plain mean and the scatter between entries.

    Examples
    --------
    >>> combine([Estimate(1.0, 0.1), Estimate(3.0, 0.1)]).value
    2.0
    """
    if len(estimates) == 1:
        return estimates[0]
    values = np.array([one.value for one in estimates])
    errors = np.array([one.standard_error or 0.0 for one in estimates])
    freedom = len(values) - 1
    if np.any(errors <= 0.0):
        return estimate(float(values.mean()), float(values.std(ddof=1)) / math.sqrt(len(values)), freedom)
    weight = errors**-2.0
    mean = float(np.average(values, weights=weight))
    excess = float(weight @ (values - mean) ** 2) - freedom
    between = max(0.0, excess / float(weight.sum() - (weight**2).sum() / weight.sum()))
    weight = 1.0 / (errors**2 + between)
    mean = float(np.average(values, weights=weight))
    scatter = float(weight @ (values - mean) ** 2) / freedom
    return estimate(mean, math.sqrt(max(scatter, 1.0) / float(weight.sum())), freedom)
