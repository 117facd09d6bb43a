"""Damping from free decays: logarithmic decrement, and viscous damping told apart from dry friction."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import FitError, unknown
from jounce.core.findings import Finding, Severity
from jounce.core.types import Array
from jounce.identify.decay_peaks import Peaks, find_peaks, find_release, noise_of, ratio_from_decrement
from jounce.identify.decay_response import QUANTITIES, DecayParameters, Quantity, alternating
from jounce.identify.decay_search import search_decay
from jounce.identify.estimate import Estimate, at_least_zero
from jounce.identify.regression import Uncertainty, linear_least_squares, r_squared


@dataclass(frozen=True)
class DecayResult:
    """Damping found from one free decay.

    Attributes
    ----------
    damping_ratio : Estimate
        Viscous part only, c / (2 sqrt(k m)) [1].
    damping_coefficient : Estimate
        Viscous part only, c [N s/m].
    coulomb_force : Estimate
        Dry friction F_c [N]; not negative.
    natural_frequency_hz : Estimate
        Undamped natural frequency [Hz].
    equilibrium : Estimate or None
        Displacement at which the spring carries the mass [m]; not where it came to rest, which friction decides.
        None for velocity and acceleration records.
    stiffness : Estimate
        Mass times squared natural angular frequency [N/m].
    logarithmic_decrement : Estimate
        The naive one: slope of ln(amplitude) per full cycle about the equilibrium, all turning points [1]. Friction
        makes it larger than the viscous damping alone would.
    amplitudes : tuple of float
        Of the successive turning points about the equilibrium, unit of the record.
    decrements : tuple of float
        ln(X_i / X_(i+2)) of successive turning points [1].
    naive_damping_ratios : tuple of float
        Damping ratios that these decrements would mean if there were no friction [1].
    cycles : float
        Full cycles between first and last turning point [1].
    r2 : float
        Share of the variance of the decay that the response explains [1].
    rms_residual : float
        Root mean square of measured minus fitted, unit of the record.
    window : (float, float)
        First and last time used [s].
    parameters : DecayParameters
        The fitted response; ``decay_response(time, parameters, quantity)`` draws it.
    quantity : {"displacement", "velocity", "acceleration"}
        What was fitted.
    findings : tuple of Finding
        What weakens the result.
    """

    damping_ratio: Estimate
    damping_coefficient: Estimate
    coulomb_force: Estimate
    natural_frequency_hz: Estimate
    equilibrium: Estimate | None
    stiffness: Estimate
    logarithmic_decrement: Estimate
    amplitudes: tuple[float, ...]
    decrements: tuple[float, ...]
    naive_damping_ratios: tuple[float, ...]
    cycles: float
    r2: float
    rms_residual: float
    window: tuple[float, float]
    parameters: DecayParameters
    quantity: Quantity
    findings: tuple[Finding, ...]


def fit_decay(
    time: ArrayLike,
    displacement: ArrayLike,
    *,
    mass: float,
    stiffness: float | None = None,
    quantity: Quantity = "displacement",
    name: str = "decay",
) -> DecayResult:
    """Find viscous damping and dry friction from a free decay.

    The response of m x'' + c x' + F_c sign(x') + k (x - x_eq) = 0, which is known in closed form from turning point to
    turning point and includes the final sticking, is fitted to the record from the moment the largest excursion is
    left. Start values come from the recursion of the turning points. Holding before the release, an initial velocity
    and a release in the middle of the record are all allowed. Displacement is best; an acceleration jumps at every
    turning point where there is friction, and its intervals for the friction come out some 10 % too narrow.

    Parameters
    ----------
    time : array (n,)
        Increasing times [s].
    displacement : array (n,)
        The record: displacement [m], or velocity [m/s] or acceleration [m/s^2] as ``quantity`` says; any zero, any
        sign.
    mass : float
        Oscillating mass [kg].
    stiffness : float or None
        Known stiffness [N/m]; only compared with the one that mass and frequency give.
    quantity : {"displacement", "velocity", "acceleration"}
        What the record holds.
    name : str
        File or channel, used in messages.

    Returns
    -------
    DecayResult
        Every estimate with standard error and 95 % interval.

    Raises
    ------
    FitError
        Unequal lengths, NaN, time that does not increase, a mass that is not positive, no oscillation.

    References
    ----------
    Den Hartog (1931), Transactions of the ASME 53, 107-115 (combined viscous and Coulomb damping).

    Examples
    --------
    >>> from jounce.identify.decay_response import decay_response
    >>> truth = DecayParameters(33.9, 0.11, 0.8e-3, 0.0, 0.2, 0.020)
    >>> t = np.arange(0.0, 2.0, 1e-3)
    >>> result = fit_decay(t, decay_response(t, truth, "displacement"), mass=16.0)
    >>> round(result.damping_ratio.value, 5), round(result.coulomb_force.value, 2)
    (0.11, 14.71)
    """
    t, signal = _checked(time, displacement, mass, stiffness, quantity, name)
    noise = noise_of(signal)
    first = find_release(signal, noise)
    try:
        peaks = find_peaks(t[first:], signal[first:], noise)
    except FitError as error:
        raise FitError(error.what, where=name, found=error.found, allowed=error.allowed, hint=error.hint) from None
    last = int(np.searchsorted(t, peaks.time[-1] + 3.0 * peaks.half_period(), side="right"))
    t, signal = t[first:last], signal[first:last]
    findings: list[Finding] = []
    parameters, spread, residual = search_decay(t, signal, peaks, quantity, name, findings)
    used = np.isfinite(residual)
    t, signal, residual = t[used], signal[used], residual[used]
    estimates = _estimates(parameters, spread, mass)
    centre = estimates.pop("equilibrium")
    amplitudes = _amplitudes(peaks, parameters, quantity)
    decrements = tuple(float(math.log(a / b)) for a, b in zip(amplitudes[:-2], amplitudes[2:], strict=True))
    result = DecayResult(
        **estimates,
        equilibrium=centre if quantity == "displacement" else None,
        logarithmic_decrement=_naive_decrement(amplitudes),
        amplitudes=tuple(map(float, amplitudes)),
        decrements=decrements,
        naive_damping_ratios=tuple(ratio_from_decrement(one) for one in decrements),
        cycles=(len(peaks.time) - 1) / 2.0,
        r2=r_squared(signal, residual),
        rms_residual=float(np.sqrt(np.mean(residual**2))),
        window=(float(t[0]), float(t[-1])),
        parameters=parameters,
        quantity=quantity,
        findings=(),
    )
    findings += _advice(result, spread, float(np.median(np.diff(t))), stiffness, name)
    return DecayResult(**{**vars(result), "findings": tuple(findings)})


def _checked(
    time: ArrayLike, record: ArrayLike, mass: float, stiffness: float | None, quantity: str, name: str
) -> tuple[Array, Array]:
    t, signal = np.asarray(time, float), np.asarray(record, float)
    if quantity not in QUANTITIES:
        raise unknown(str(quantity), QUANTITIES, what="quantity", where=name)
    if t.ndim != 1 or t.shape != signal.shape:
        raise FitError(
            "time and record are not two columns of the same length", where=name, found=f"{t.shape} and {signal.shape}"
        )
    if len(t) < 20:
        raise FitError("too few samples", where=name, found=len(t), allowed="at least 20")
    bad = np.flatnonzero(~(np.isfinite(t) & np.isfinite(signal)))
    if len(bad):
        raise FitError("a value is missing or not finite", where=name, found=f"sample {bad[0] + 1}")
    if np.any(np.diff(t) <= 0.0):
        place = int(np.argmax(np.diff(t) <= 0.0)) + 2
        raise FitError("the time does not increase", where=name, found=f"sample {place}")
    for value, what in ((mass, "mass"), (stiffness, "stiffness")):
        if value is not None and not (math.isfinite(value) and value > 0.0):
            raise FitError(f"the {what} is not positive", where=name, found=value, allowed="above 0")
    if np.ptp(signal) == 0.0:
        raise FitError("the record never changes", where=name, hint="Is this the right channel?")
    return t, signal


def _estimates(p: DecayParameters, spread: Uncertainty, mass: float) -> dict[str, Estimate]:
    omega, ratio, friction = p.angular_frequency, p.damping_ratio, p.friction_deflection

    def derived(value: float, *gradient: float) -> Estimate:
        return spread.derived(value, np.array([*gradient, *[0.0] * (6 - len(gradient))]))

    return {
        "damping_ratio": at_least_zero(derived(ratio, 0.0, 1.0)),
        "damping_coefficient": at_least_zero(
            derived(2.0 * ratio * omega * mass, 2.0 * ratio * mass, 2.0 * omega * mass)
        ),
        "coulomb_force": at_least_zero(
            derived(friction * mass * omega**2, 2.0 * friction * mass * omega, 0.0, mass * omega**2)
        ),
        "natural_frequency_hz": derived(omega / (2.0 * math.pi), 1.0 / (2.0 * math.pi)),
        "equilibrium": derived(p.offset, 0.0, 0.0, 0.0, 1.0),
        "stiffness": derived(mass * omega**2, 2.0 * mass * omega),
    }


def _amplitudes(peaks: Peaks, parameters: DecayParameters, quantity: Quantity) -> Array:
    """Turning points as positive amplitudes, up to the first that is not on its own side."""
    away = peaks.value - parameters.offset
    if quantity == "displacement":
        away[0] = parameters.release_deflection  # the fitted release is better than one sample
    return alternating(away)


def _naive_decrement(amplitudes: Array) -> Estimate:
    if len(amplitudes) < 2:
        return Estimate(math.inf)
    cycle = 0.5 * np.arange(len(amplitudes))
    if len(amplitudes) == 2:
        return Estimate(2.0 * math.log(amplitudes[0] / amplitudes[1]))
    found, _, spread = linear_least_squares(np.column_stack([-cycle, np.ones_like(cycle)]), np.log(amplitudes))
    return spread.estimates(found)[0]


def _advice(result: DecayResult, spread: Uncertainty, step: float, stiffness: float | None, name: str) -> list[Finding]:
    p, friction, cycles = result.parameters, result.coulomb_force, result.cycles
    findings: list[Finding] = []

    def add(severity: Severity, text: str, value: float) -> None:
        findings.append(Finding(name, severity, text, value))

    if friction.interval is not None and friction.interval[0] > 0.0 and len(result.decrements) > 1:
        text = (
            f"the logarithmic decrement changes from {result.decrements[0]:.3f} to {result.decrements[-1]:.3f} as the "
            f"amplitude falls: dry friction; use the combined estimate (viscous {result.damping_coefficient.value:.4g} "
            f"N s/m and {friction.value:.3g} N), not the decrement."
        )
        add("warning", text, friction.value)
    for value, what, unit in ((p.friction_deflection, "dry friction", " N"), (p.damping_ratio, "viscous damping", "")):
        if value < 0.0:
            text = f"the decay shows no {what}: the fit would even make it negative, which is reported as 0{unit}."
            add("note", text, value)
    if cycles < 1.5:
        text = f"only {cycles:g} cycles: viscous damping and dry friction can hardly be told apart; see the intervals."
        add("warning", text, cycles)
    samples = 2.0 * math.pi / p.angular_frequency / step
    if samples < 20.0:
        add("warning", f"only {samples:.1f} samples per cycle; sample at least 20.", samples)
    if result.r2 < 0.98:
        text = (
            f"the fitted decay explains only {100.0 * result.r2:.1f} % of the record: not the free decay of one mass "
            "with viscous damping and friction, or much noise; look at both curves."
        )
        add("problem", text, result.r2)
    elif spread.correlation_time > 4.0 and result.rms_residual > 1e-6 * abs(p.release_deflection):
        text = (
            "neighbouring residuals resemble each other: something small is not in the model; the intervals allow "
            "for it."
        )
        add("note", text, spread.correlation_time)
    if stiffness is not None and abs(result.stiffness.value / stiffness - 1.0) > 0.03:
        share = result.stiffness.value / stiffness - 1.0
        text = (
            f"mass and frequency mean {result.stiffness.value:.5g} N/m, {100 * share:+.1f} % from the given "
            f"{stiffness:.5g} N/m: check mass, stiffness at the wheel, and what else moves."
        )
        add("warning", text, share)
    return findings
