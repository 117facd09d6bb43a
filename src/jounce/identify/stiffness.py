"""Stiffness from several force-deflection trials, with uncertainty and limits; tyres at several pressures."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from jounce.core.errors import FitError, unknown
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.results import Shows
from jounce.core.samples import as_samples
from jounce.core.serialise import Plain
from jounce.core.shown import Shown
from jounce.core.types import Array
from jounce.core.units import as_number
from jounce.identify.estimate import (
    Estimate,
    Uncertainty,
    linear_least_squares,
    mean_of_replicates,
    r_squared,
    uncertainty,
)
from jounce.identify.force_deflection import (
    Branch,
    ForceDeflectionTrial,
    SeatedTrial,
    Zero,
    hysteresis,
    number_namesakes,
    seat,
)
from jounce.identify.motion import MOTIONS, MeasuredMotion, MotionName, in_motion, unit_in_words

# force laws -----------------------------------------------------------------------------------------------------------


Law = Literal["linear", "polynomial", "power", "monotone-spline"]
LAWS: tuple[Law, ...] = ("linear", "polynomial", "power", "monotone-spline")


@dataclass(frozen=True)
class FittedCurve:
    """A force-deflection law with numeric parameters.

    Attributes
    ----------
    kind : {"polynomial", "power", "table"}
        ``polynomial``: F = preload + sum of coefficients[i] * x^(i+1); ``power``: F = a x^b with coefficients (a, b);
        ``table``: monotone cubic (PCHIP) through ``deflection`` and ``force``.
    coefficients : tuple of float
        Coefficients in N/m, N/m^2, ...; or (a [N/m^b], b [1]); empty for a table.
    deflection, force : tuple of float
        Knots of a table [m], [N]; empty otherwise.
    preload : float
        Force at x = 0 [N]; only with ``intercept="keep"``.
    origin : float
        Deflection of the trials at which x = 0 [m]; zero except with ``intercept="shift"``.
    """

    kind: Literal["polynomial", "power", "table"]
    coefficients: tuple[float, ...] = ()
    deflection: tuple[float, ...] = ()
    force: tuple[float, ...] = ()
    preload: float = 0.0
    origin: float = 0.0

    def __call__(self, deflection: ArrayLike) -> Array:
        """Return the force [N] at deflections of the trials [m], same shape."""
        x = as_samples(deflection, "m", where="deflection") - self.origin
        if self.kind == "polynomial":
            return np.asarray(
                self.preload + x * np.polynomial.polynomial.polyval(x, self.coefficients)
            )
        if self.kind == "power":
            a, b = self.coefficients
            return np.asarray(a * np.maximum(x, 0.0) ** b)
        return np.asarray(self._spline()(x))

    def tangent(self, deflection: ArrayLike) -> Array:
        """Return dF/dx [N/m] at deflections of the trials [m], same shape."""
        x = as_samples(deflection, "m", where="deflection") - self.origin
        if self.kind == "polynomial":
            powers = np.arange(1, len(self.coefficients) + 1)
            return np.asarray(
                np.polynomial.polynomial.polyval(x, np.array(self.coefficients) * powers)
            )
        if self.kind == "power":
            a, b = self.coefficients
            return np.asarray(a * b * np.maximum(x, 1e-12) ** (b - 1.0))
        return np.asarray(self._spline().derivative()(x))

    def _spline(self) -> Any:
        from scipy.interpolate import PchipInterpolator

        return PchipInterpolator(self.deflection, self.force, extrapolate=True)

    def deflection_at(self, force: float, limit: float) -> float | None:
        """Find the deflection [m] in 0...``limit`` at which the curve reaches ``force`` [N]; None if it does not."""
        grid = np.linspace(self.origin, max(limit, self.origin + 1e-9), 2001)
        values = self(grid)
        above = np.flatnonzero(values >= force)
        if not len(above):
            return None
        index = int(above[0])
        if index == 0:
            return float(grid[0])
        return float(np.interp(force, values[index - 1 : index + 1], grid[index - 1 : index + 1]))

    def to_table(self, limit: float) -> dict[str, Any]:
        """Return the curve in the form of a rig file, SI, from x = 0 on; a power law as a table up to ``limit`` [m].

        It excludes a preload, which has its own key in the rig.
        """
        if self.kind == "polynomial":
            return {"kind": "polynomial", "coefficients": list(self.coefficients)}
        if self.kind == "table":
            return {"kind": "table", "deflection": list(self.deflection), "force": list(self.force)}
        deflection = limit * np.linspace(0.0, 1.0, 41) ** 2
        return {
            "kind": "table",
            "deflection": deflection.tolist(),
            "force": self(deflection).tolist(),
        }


@dataclass(frozen=True)
class CurveFit:
    """One fit of a law to points: parameters in the law's order, followed by the intercept if there is one."""

    curve: FittedCurve
    parameters: Array
    residual: Array
    uncertainty: Uncertainty | None


def fit_curve(
    deflection: Array, force: Array, *, law: Law, degree: int, intercept: str, where: str
) -> CurveFit:
    """Fit a law to a set of points (deflection and force, each (n,), SI); errors mention ``where``."""
    needed = {"linear": 2, "polynomial": degree, "power": 2, "monotone-spline": 4}[law]
    if len(np.unique(deflection)) <= needed:
        raise FitError(
            "fewer points than the law needs",
            where=where,
            found=f"{len(np.unique(deflection))} different deflections",
            allowed=Phrase("more than {needed} for law {law!r}", needed=needed, law=law),
            hint="Discard less, lower the degree or choose a simpler law.",
        )
    if law == "linear":
        return _linear(deflection, force, intercept, where)
    if law == "polynomial":
        powers = np.arange(1, degree + 1)
        coefficients, residual, spread = linear_least_squares(deflection[:, None] ** powers, force)
        return CurveFit(
            FittedCurve("polynomial", tuple(map(float, coefficients))),
            coefficients,
            residual,
            spread,
        )
    return _power(deflection, force, where) if law == "power" else _monotone(deflection, force)


def _linear(deflection: Array, force: Array, intercept: str, where: str) -> CurveFit:
    regressors = np.column_stack([deflection, np.ones_like(deflection)])
    coefficients, residual, spread = linear_least_squares(regressors, force)
    slope, level = map(float, coefficients)
    if slope <= 0.0:
        raise FitError(
            "the force does not grow with the deflection",
            where=where,
            found=f"a slope of {slope:g} (SI)",
            hint="Check the columns and their signs.",
        )
    preload = level if intercept == "keep" else 0.0
    origin = -level / slope if intercept == "shift" else 0.0
    return CurveFit(
        FittedCurve("polynomial", (slope,), preload=preload, origin=origin),
        coefficients,
        residual,
        spread,
    )


def _power(deflection: Array, force: Array, where: str) -> CurveFit:
    from scipy.optimize import least_squares

    use = (deflection > 0.0) & (force > 0.0)
    if np.count_nonzero(use) < 3:
        raise FitError(
            "a power law needs at least three points with positive deflection and force",
            where=where,
        )
    reach, top = float(deflection[use].max()), float(force[use].max())
    x, y = np.maximum(deflection, 0.0) / reach, force / top
    exponent, level = np.polyfit(np.log(x[use]), np.log(y[use]), 1)
    solution = least_squares(
        lambda p: p[0] * x ** p[1] - y,
        [np.exp(level), max(exponent, 0.05)],
        bounds=([0.0, 0.02], [np.inf, 20.0]),
    )
    exponent = float(solution.x[1])
    scale = top / reach**exponent
    a = float(solution.x[0]) * scale
    # d(a, b)/d(scaled a, b): a = scaled * top / reach^b
    transform = np.array([[1.0 / scale, 0.0], [0.0, 1.0]])
    jacobian = (
        top
        * solution.jac
        @ np.array([[1.0, solution.x[0] * np.log(reach)], [0.0, 1.0]])
        @ transform
    )
    residual = -top * solution.fun
    return CurveFit(
        FittedCurve("power", (a, exponent)),
        np.array([a, exponent]),
        residual,
        uncertainty(jacobian, residual),
    )


def _monotone(deflection: Array, force: Array) -> CurveFit:
    bins = int(np.clip(len(deflection) // 8, 3, 24))
    edges = np.linspace(0.0, float(deflection.max()), bins + 1)
    place = np.clip(np.digitize(deflection, edges) - 1, 0, bins - 1)
    keep = [index for index in range(bins) if np.any(place == index)]
    x = np.array([deflection[place == index].mean() for index in keep])
    y = np.array([force[place == index].mean() for index in keep])
    weight = np.array([np.count_nonzero(place == index) for index in keep], float)
    end = np.array([float(deflection.max()), _end_force(deflection, force)])
    x, y, weight = np.append(x, end[0]), np.append(y, end[1]), np.append(weight, 1.0)
    positive = x > 1e-9 * end[0]
    x, first = np.unique(x[positive], return_index=True)
    y, weight = y[positive][first], weight[positive][first]
    y = np.maximum(_increasing(y, weight), 0.0)
    x, y = np.concatenate([[0.0], x]), np.concatenate([[0.0], y])
    curve = FittedCurve("table", deflection=tuple(map(float, x)), force=tuple(map(float, y)))
    return CurveFit(curve, y[1:], force - curve(deflection), None)


def _end_force(deflection: Array, force: Array) -> float:
    """Return the force at the largest deflection, from a line through the last tenth of the range."""
    near = deflection >= 0.9 * deflection.max()
    if np.ptp(deflection[near]) == 0.0:
        return float(force[near].mean())
    return float(np.polyval(np.polyfit(deflection[near], force[near], 1), deflection.max()))


def _increasing(values: Array, weights: Array) -> Array:
    """Return the nearest non-decreasing sequence in weighted least squares (pool adjacent violators)."""
    blocks: list[list[float]] = []
    for value, weight in zip(values, weights, strict=True):
        blocks.append([float(value), float(weight), 1.0])
        while len(blocks) > 1 and blocks[-2][0] > blocks[-1][0]:
            value_b, weight_b, count_b = blocks.pop()
            value_a, weight_a, count_a = blocks.pop()
            total = weight_a + weight_b
            blocks.append(
                [(value_a * weight_a + value_b * weight_b) / total, total, count_a + count_b]
            )
    return np.concatenate([np.full(int(count), value) for value, _, count in blocks])


# fit ------------------------------------------------------------------------------------------------------------------


Intercept = Literal["drop", "shift", "keep"]
INTERCEPTS: dict[Intercept, str] = {
    "drop": "dropped",
    "shift": "deflection offset",
    "keep": "kept as preload",
}
_RATE, _FORCE, _DEFLECTION = in_motion("stiffness"), in_motion("force"), in_motion("deflection")


@dataclass(frozen=True)
class TrialStiffness(Plain):
    """Result of a single trial: ``stiffness`` [N/m] as in :class:`StiffnessResult`, from this trial alone.

    ``intercept`` [N] is the force of the fitted line at zero deflection, None for laws without one. ``loss_factor`` [1]
    is energy lost / (2 pi work of loading); it and the ``hysteresis_energy`` of the cycle [J] are None without an
    unloading branch. ``rms_residual`` [N] is that of measured minus fitted force over the ``points`` used. ``motion``
    is that of the result.
    """

    name: Annotated[str, Shows("trial")]
    stiffness: Annotated[Estimate, Shows("stiffness", _RATE)]
    intercept: Annotated[Estimate | None, Shows("intercept", _FORCE)]
    loss_factor: Annotated[float | None, Shows("loss factor", "1")]
    hysteresis_energy: float | None
    rms_residual: Annotated[float, Shows("r.m.s. residual", _FORCE)]
    points: Annotated[int, Shows("points")]
    motion: MotionName = "translation"

    left_out = ("motion",)


@dataclass(frozen=True)
class StiffnessResult(Shown):
    """Stiffness of a spring, a tyre, or a part in torsion.

    Attributes
    ----------
    motion : {"translation", "rotation"}
        Along a line or about an axis. For a rotation read angle [rad] instead of deflection, torque [N m] instead of
        force, and N m/rad instead of N/m below.
    law : str
        Force law that was fitted.
    stiffness : Estimate
        Linear law: the slope. Other laws: the tangent at ``operating_force``, or at the middle of the fitted range
        without an operating force [N/m]. The interval treats the trials as replicates. For a polynomial or power law it
        includes the difference from polynomials of one and two higher degrees.
    intercept : Estimate or None
        Force of the fitted line at zero deflection [N]; None for laws that pass through the origin.
    intercept_choice : {"drop", "shift", "keep"}
        Treatment of the intercept in ``curve``.
    zero : {"first-contact", "none"}
        Zero of deflections and forces of the trials.
    branch : {"loading", "unloading", "both"}
        Part of each trial that was fitted.
    coefficients : tuple of Estimate
        Parameters of the law: slope [N/m]; a_i [N/m^i]; a [N/m^b] and b [1]; forces at the knots [N].
    curve : FittedCurve
        The fitted law; ``curve.to_table(limit)`` returns it in the form of a rig file.
    fitted_range : (float, float)
        Smallest and largest deflection used [m].
    force_range : (float, float)
        Smallest and largest measured force used [N].
    r2 : float
        Share of the force's variance explained by the pooled fit [1].
    repeatability : float or None
        Standard deviation of the stiffness between trials [N/m]; None for one trial.
    loss_factor, hysteresis_energy : float or None
        Means over the trials that have an unloading branch [1], [J].
    operating_deflection : float or None
        Deflection at which the trials reach ``operating_force`` [m].
    tangent_stiffness : Estimate or None
        Slope of the *measured* loading branches around ``operating_deflection``, discarded points included [N/m].
    trials : tuple of TrialStiffness
        One entry per trial.
    findings : tuple of Finding
        Limitations of the result.
    """

    motion: MotionName
    law: Annotated[Law, Shows("law")]
    stiffness: Annotated[Estimate, Shows("stiffness", _RATE)]
    intercept: Annotated[
        Estimate | None,
        Shows(lambda fit: f"intercept ({INTERCEPTS[fit.intercept_choice]})", _FORCE),
    ]
    intercept_choice: Intercept
    zero: Zero
    branch: Annotated[Branch, Shows("branches fitted")]
    coefficients: tuple[Estimate, ...]
    curve: FittedCurve
    fitted_range: Annotated[tuple[float, float], Shows("deflections fitted", _DEFLECTION)]
    force_range: tuple[float, float]
    r2: Annotated[float, Shows("R²", "1", 6)]
    repeatability: Annotated[float | None, Shows("standard deviation between trials", _RATE)]
    loss_factor: Annotated[float | None, Shows("loss factor", "1")]
    hysteresis_energy: Annotated[float | None, Shows("energy dissipated per cycle", "J")]
    operating_deflection: Annotated[
        float | None, Shows("deflection at the static load", _DEFLECTION)
    ]
    tangent_stiffness: Annotated[
        Estimate | None, Shows("local stiffness at the static operating point", _RATE)
    ]
    trials: Annotated[tuple[TrialStiffness, ...], Shows("Trials")]
    findings: tuple[Finding, ...]

    @property
    def coefficient_units(self) -> tuple[str, ...]:
        """SI unit of each coefficient."""
        force, deflection = _FORCE(self), _DEFLECTION(self)
        if self.law == "monotone-spline":
            return (force,) * len(self.coefficients)
        if self.law == "power":
            return f"{force}/{deflection}^{self.coefficients[1].value:.4g}", "1"
        powers = ("", *(f"^{power}" for power in range(2, len(self.coefficients) + 1)))
        return tuple(f"{force}/{deflection}{power}" for power in powers)

    @property
    def of_branch(self) -> str:
        """Suffix of the fit in a legend: ``", loading"`` if the trials include unloading, otherwise empty."""
        return f", {self.branch}" if self.branch != "both" and self.loss_factor is not None else ""


def fit_stiffness(
    trials: Sequence[ForceDeflectionTrial] | ForceDeflectionTrial,
    *,
    law: Law = "linear",
    degree: int = 3,
    discard_below: float = 0.0,
    intercept: Intercept = "drop",
    branch: Branch = "loading",
    operating_force: float | None = None,
    zero: Zero = "first-contact",
) -> StiffnessResult:
    """Fit a force law to repeated force-deflection trials.

    The points of all trials are fitted together. The uncertainty comes from the scatter *between* trials, because the
    points of one trial share their errors. For a single trial it comes from the residuals, with a finding.

    Parameters
    ----------
    trials : sequence of ForceDeflectionTrial
        Deflection [m] and force [N], compression positive (opposite signs are reversed, with a finding);
        or angle [rad] and torque [N m], with ``motion="rotation"``.
    law : {"linear", "polynomial", "power", "monotone-spline"}
        F = k x + b; F = sum of a_i x^i for i = 1...``degree`` (no constant); F = a x^b; or a monotone cubic through bin
        means that starts at the origin.
    degree : int
        Degree of the polynomial law [1], 1 to 9.
    discard_below : float
        Points with a smaller deflection after the zero correction are not fitted [m or rad], e.g. 0.002 for a tyre that
        settles on its support.
    intercept : {"drop", "shift", "keep"}
        Linear law only; k and b are always fitted. ``drop``: the curve is F = k x, a model receives the slope only.
        ``shift``: the curve is F = k (x - x0) with x0 = -b/k, and deflection is measured from x0. ``keep``: the curve
        is F = b + k x with the preload b.
    branch : {"loading", "unloading", "both"}
        Part of each trial to fit; loading ends at the largest deflection.
    operating_force : float or None
        Static force on the part in use [N or N m]; a finding reports an operating point outside the fitted range.
    zero : {"first-contact", "none"}
        See :func:`jounce.identify.force_deflection.seat`.

    Returns
    -------
    StiffnessResult
        Stiffness in N/m, or N m/rad, with a 95 % interval.

    Raises
    ------
    FitError
        No trials, a mixture of forces and torques, fewer points than the law needs, NaN, unequal lengths,
        ``discard_below`` beyond the data, a force that does not increase, rows from the largest deflection to the zero.
    DescriptionError
        An unknown law, branch or intercept.

    Examples
    --------
    >>> import numpy as np
    >>> x = np.linspace(0.0, 0.015, 31)
    >>> trials = [ForceDeflectionTrial(x, k * x, f"spring {k}") for k in (22700.0, 22730.0, 22760.0)]
    >>> result = fit_stiffness(trials)
    >>> round(result.stiffness.value), round(result.repeatability)
    (22730, 30)
    """
    trials = [trials] if isinstance(trials, ForceDeflectionTrial) else trials
    motion = _motion_of(trials)
    discard_below = as_number(discard_below, motion.deflection, where="discard_below")
    _check(motion, law, degree, discard_below, intercept, branch, zero)
    if operating_force is not None:
        operating_force = as_number(operating_force, motion.force, where="operating_force")
    if operating_force is not None and not (np.isfinite(operating_force) and operating_force > 0.0):
        raise FitError(
            Phrase("invalid static {force_word}", force_word=Phrase(motion.force_word)),
            where="operating_force",
            found=f"{operating_force} {unit_in_words(motion.force)}",
            allowed="above 0",
        )
    seated, findings = [], []
    for trial in number_namesakes(list(trials)):
        seated_trial, notes = seat(trial, zero=zero)
        seated.append(seated_trial)
        findings += notes
    findings += _copies(seated)
    points = [
        _points_to_fit(seated_trial, branch, discard_below, law, findings)
        for seated_trial in seated
    ]
    x, force = (np.concatenate(column) for column in zip(*points, strict=True))
    pooled = fit_curve(x, force, law=law, degree=degree, intercept=intercept, where="all trials")
    alone = [
        fit_curve(a, b, law=law, degree=degree, intercept=intercept, where=seated_trial.name)
        for seated_trial, (a, b) in zip(seated, points, strict=True)
    ]
    low, reach = float(x.min()), float(x.max())
    operating, tangent = None, None
    if operating_force is not None:
        operating, tangent = _operating_point(
            seated, pooled.curve, operating_force, (low, reach), motion, findings
        )
    at = operating if operating is not None else 0.5 * (low + reach)
    rows = []
    for seated_trial, fit in zip(seated, alone, strict=True):
        energy, loss = hysteresis(seated_trial)
        rms = float(np.sqrt(np.mean(fit.residual**2)))
        estimates = _stiffness(fit, at), _intercept(fit)
        rows.append(
            TrialStiffness(
                seated_trial.name, *estimates, loss, energy, rms, len(fit.residual), motion.name
            )
        )
    line = _intercept(pooled)
    findings += _no_spring(_stiffness(pooled, at).value, motion)
    findings += _advice(pooled, x, force, law, line if intercept == "keep" else None, rows, motion)
    several = len(rows) > 1
    values = [row.stiffness.value for row in rows]
    own = _stiffness(pooled, at)
    stiffness = mean_of_replicates(values, value=own.value) if several else own
    if law in _DEGREES:
        stiffness, lack = _with_law(
            stiffness, x, force, at, degree if law == "polynomial" else _DEGREES[law], motion
        )
        findings += lack
    if line is not None and several:
        line = mean_of_replicates([float(fit.parameters[-1]) for fit in alone], value=line.value)
    losses = [
        (row.loss_factor, row.hysteresis_energy) for row in rows if row.loss_factor is not None
    ]
    return StiffnessResult(
        motion=motion.name,
        law=law,
        stiffness=stiffness,
        intercept=line,
        intercept_choice=intercept,
        zero=zero,
        branch=branch,
        coefficients=_coefficients(pooled, alone),
        curve=pooled.curve,
        fitted_range=(low, reach),
        force_range=(float(force.min()), float(force.max())),
        r2=r_squared(force, pooled.residual),
        repeatability=float(np.std(values, ddof=1)) if several else None,
        loss_factor=float(np.mean([loss for loss, _ in losses])) if losses else None,
        hysteresis_energy=float(np.mean([energy for _, energy in losses])) if losses else None,
        operating_deflection=operating,
        tangent_stiffness=tangent,
        trials=tuple(rows),
        findings=tuple(findings),
    )


def _motion_of(trials: Sequence[ForceDeflectionTrial]) -> MeasuredMotion:
    """Return the common motion of all trials: translation (force, deflection) or rotation (torque, angle)."""
    if not trials:
        raise FitError("no trials to fit", allowed="at least one force-deflection trial")
    for trial in trials:
        if trial.motion not in MOTIONS:
            raise unknown(str(trial.motion), MOTIONS, what="motion", where=trial.name)
    if len(motions := {trial.motion for trial in trials}) > 1:
        raise FitError(
            "trials of forces and of torques are not fitted together",
            found=", ".join(sorted(motions)),
        )
    return MOTIONS[trials[0].motion]


def _check(
    motion: MeasuredMotion,
    law: str,
    degree: int,
    discard_below: float,
    intercept: str,
    branch: str,
    zero: str,
) -> None:
    for value, options, what in (
        (law, LAWS, "law"),
        (intercept, ("drop", "shift", "keep"), "intercept"),
        (branch, ("loading", "unloading", "both"), "branch"),
        (zero, ("first-contact", "none"), "zero"),
    ):
        if value not in options:
            raise unknown(str(value), options, what=what)
    if law == "polynomial" and not 1 <= degree <= 9:
        raise FitError("invalid degree of the polynomial", found=degree, allowed="1 to 9")
    if not (np.isfinite(discard_below) and discard_below >= 0.0):
        raise FitError(
            Phrase(
                "discard_below is not a valid {deflection_word}",
                deflection_word=Phrase(motion.deflection_word),
            ),
            found=f"{discard_below} {motion.deflection}",
            allowed=Phrase("0 {deflection} or more", deflection=motion.deflection),
        )
    if law != "linear" and intercept != "drop":
        raise FitError(
            Phrase("the law {law!r} passes through the origin and has no intercept", law=law),
            found=intercept,
            allowed="'drop'",
        )


_AT_ZERO = (
    0.02  # share of the stroke: a trial with a smaller range beyond its zero is not a loading
)


def _copies(trials: Sequence[SeatedTrial]) -> list[Finding]:
    """Report trials with the same data as a different trial, which are not repetitions."""
    first: dict[tuple[bytes, bytes], str] = {}
    findings = []
    for trial in trials:
        other = first.setdefault((trial.deflection.tobytes(), trial.force.tobytes()), trial.name)
        if other != trial.name:
            findings.append(finding("identify.stiffness_copy", trial.name, other=other))
    return findings


def _points_to_fit(
    trial: SeatedTrial, branch: Branch, discard_below: float, law: Law, findings: list[Finding]
) -> tuple[Array, Array]:
    """Return the points to fit; for laws that include tension, those of both sides of a two-sided trial."""
    deflection, force = trial.branch(branch)
    has_both = trial.is_two_sided() and law in ("linear", "polynomial")
    use = (np.abs(deflection) if has_both else deflection) >= discard_below
    beyond = np.count_nonzero(deflection < -_AT_ZERO * float(np.ptp(trial.deflection)))
    if beyond and not has_both:
        findings.append(
            finding("identify.points_below_zero", trial.name, beyond, points=beyond, all=len(use))
        )
    if float(trial.deflection.max()) <= _AT_ZERO * float(np.ptp(trial.deflection)):
        raise FitError(
            "the trial ends at zero deflection instead of beginning there",
            where=trial.name,
            found=f"from {trial.motion.say(float(trial.deflection[0]), 4)} and {float(trial.force[0]):.4g} "
            f"{unit_in_words(trial.motion.force)} on",
            allowed="rows in time order, from first contact to the largest deflection",
            hint="Reverse the rows, or correct the zero of the deflection.",
        )
    if np.count_nonzero(use) < 2:
        raise FitError(
            "no points remain after discarding"
            if discard_below > 0.0
            else "the branch contains too few points",
            where=trial.name,
            found=f"{np.count_nonzero(use)} of {len(use)} points at or beyond {trial.motion.say(discard_below, 6)}; "
            f"the {branch} branch reaches {trial.motion.say(float(deflection.max()), 4)}",
            allowed="at least 2 points",
            hint="Discard less, or check the unit of the deflection.",
        )
    return deflection[use], force[use]


def _stiffness(fit: CurveFit, at: float) -> Estimate:
    """Return the tangent at deflection ``at`` [m] with its residual-based uncertainty."""
    value = float(fit.curve.tangent(at + fit.curve.origin if fit.curve.origin else at))
    if fit.uncertainty is None:
        return Estimate(value)
    return fit.uncertainty.propagate(value, _tangent_gradient(fit, at))


_DEGREES: dict[Law, int] = {"polynomial": 0, "power": 2}
"""Laws with an assumed shape, with the degree of the equally flexible polynomial (0: the degree of the law)."""


def _with_law(
    stiffness: Estimate, x: Array, force: Array, at: float, degree: int, motion: MeasuredMotion
) -> tuple[Estimate, list[Finding]]:
    """Return the tangent at ``at`` (SI) with an interval that includes the choice of the law, and findings about it.

    All trials share the error of the law, so their scatter does not show it. Polynomials of one and two higher degrees
    have a smaller error: the larger difference of their tangents is added in quadrature to the half width.
    """
    others = []
    for more in (1, 2):
        if len(np.unique(x)) <= degree + more:
            break
        reach = float(x.max())  # of order 1, to keep high powers distinguishable
        powers = np.arange(1, degree + more + 1)
        coefficients = np.linalg.lstsq((x[:, None] / reach) ** powers, force, rcond=None)[0]
        others.append(float(coefficients @ (powers * (at / reach) ** (powers - 1.0))) / reach)
    if not others or stiffness.standard_error is None or stiffness.interval is None:
        return stiffness, []
    apart = max(abs(other - stiffness.value) for other in others)
    half = 0.5 * (stiffness.interval[1] - stiffness.interval[0])
    whole = math.hypot(half, apart)
    error = math.hypot(stiffness.standard_error, 0.5 * apart)
    counted = Estimate(stiffness.value, error, (stiffness.value - whole, stiffness.value + whole))
    if apart <= half:
        return counted, []
    return counted, [
        finding(
            "identify.degrees_disagree",
            "law",
            apart,
            severity="warning" if apart > _ODD * abs(stiffness.value) else "note",
            degree=degree + 1,
            least=min(others),
            greatest=max(others),
            unit=unit_in_words(motion.stiffness),
            at=motion.say(at),
            value=stiffness.value,
        )
    ]


def _tangent_gradient(fit: CurveFit, at: float) -> Array:
    if fit.curve.kind == "power":
        a, b = fit.curve.coefficients
        x = max(at, 1e-12)
        return np.array([b * x ** (b - 1.0), a * x ** (b - 1.0) * (1.0 + b * np.log(x))])
    powers = np.arange(1, len(fit.curve.coefficients) + 1)
    gradient = powers * at ** (powers - 1.0)
    return np.append(gradient, 0.0) if len(fit.parameters) > len(gradient) else gradient


def _intercept(fit: CurveFit) -> Estimate | None:
    has_one = fit.curve.kind == "polynomial" and len(fit.parameters) > len(fit.curve.coefficients)
    return fit.uncertainty.estimates(fit.parameters)[-1] if has_one and fit.uncertainty else None


def _operating_point(
    trials: list[SeatedTrial],
    curve: FittedCurve,
    force: float,
    fitted: tuple[float, float],
    motion: MeasuredMotion,
    findings: list[Finding],
) -> tuple[float | None, Estimate | None]:
    """Return the deflection at which the trials carry ``force``, and the measured slope there."""
    (low, reach), rate = fitted, unit_in_words(motion.stiffness)
    deflections, slopes = [], []
    for trial in trials:
        x, f = trial.branch("loading")
        above = np.flatnonzero(f >= force)
        if not len(above) or above[0] == 0:
            continue
        here = float(
            np.interp(force, f[above[0] - 1 : above[0] + 1], x[above[0] - 1 : above[0] + 1])
        )
        deflections.append(here)
        slope = _slope_at(
            x - here, f, max(0.03 * reach, 2.5 * float(np.median(np.abs(np.diff(x)))))
        )
        slopes += [] if slope is None else [slope]
    at = float(np.mean(deflections)) if deflections else curve.deflection_at(force, 10.0 * reach)
    tangent = mean_of_replicates(slopes) if slopes else None
    if at is None or not low <= at <= reach:
        code = {
            (False, False): "identify.load_outside",
            (False, True): "identify.load_outside_slope",
            (True, False): "identify.load_never_reached",
            (True, True): "identify.load_never_reached_slope",
        }[at is None, tangent is not None]
        slope = tangent.value if tangent else None
        where = None if at is None else motion.say(at)
        names: dict[str, Any] = {
            "name": motion.force_word,
            "unit": unit_in_words(motion.force),
            "rate": rate,
        }
        ends: dict[str, Any] = {"low": motion.say(low), "high": motion.say(reach)}
        findings.append(
            finding(
                code, "operating point", at, force=force, at=where, slope=slope, **names, **ends
            )
        )
    return at, tangent


def _slope_at(x: Array, force: Array, width: float) -> float | None:
    """Return the slope [N/m] at x = 0 of a parabola (for only a few points a line) through points within ``width``."""
    near = np.abs(x) <= width
    degree = 2 if len(np.unique(x[near])) >= 5 else 1
    if len(np.unique(x[near])) < 2:
        return None
    return float(np.polyfit(x[near] / width, force[near], degree)[-2] / width)


_ODD = 0.05  # deviation from the stiffness of the other trials above which a trial is reported


def _advice(
    pooled: CurveFit,
    x: Array,
    force: Array,
    law: Law,
    preload: Estimate | None,
    rows: Sequence[TrialStiffness],
    motion: MeasuredMotion,
) -> list[Finding]:
    """Return findings about the fit; ``preload`` is the intercept if it is kept."""
    findings: list[Finding] = []
    rate = unit_in_words(motion.stiffness)

    def add(code: str, place: str, value: float | None = None, /, **numbers: Any) -> None:
        findings.append(finding(code, place, value, **numbers))

    if len(rows) == 1:
        add("identify.one_trial", "trials")
    if all(row.loss_factor is None for row in rows):
        add("identify.no_unloading", "trials")
    values = np.array([row.stiffness.value for row in rows])
    for i, row in enumerate(rows):
        others = np.delete(values, i)
        if len(others) < 2 or np.median(others) <= 0.0:
            break
        far, usual = float(values[i] / np.median(others)), float(np.ptp(others) / np.median(others))
        if abs(far - 1.0) > max(_ODD, 3.0 * usual):  # beyond three times the range of the others
            value = row.stiffness.value
            add("identify.trial_differs", row.name, far, times=far, value=value, unit=rate)
    few = min(rows, key=lambda row: row.points)
    if few.points < 10:
        add("identify.few_points", few.name, few.points, points=few.points)
    if law == "linear" and len(np.unique(x)) > 3:
        u = (x - x.mean()) / float(np.ptp(x))
        coefficients, _, spread = linear_least_squares(
            np.column_stack([u**2, u, np.ones_like(u)]), force
        )
        bend = spread.estimates(coefficients)[0]
        share = 2.0 * bend.value / coefficients[1]  # change of slope over the range / mean slope
        if (
            bend.interval and not bend.has(0.0) and abs(share) > 0.03
        ):  # a choice: 1.5 % to either side
            add("identify.not_linear", "linear law", share, change=share)
        sides = [x < 0.0, x > 0.0]
        if all(len(np.unique(x[side])) > 4 for side in sides):
            pulled, pushed = (float(np.polyfit(x[side], force[side], 1)[0]) for side in sides)
            if abs(pushed - pulled) > _ODD * abs(pushed):
                both = {"pulled": pulled, "pushed": pushed, "unit": rate}
                names = {"tension": motion.pulled, "compression": motion.pushed}
                add("identify.slopes_differ", "linear law", pushed - pulled, **both, **names)
    if preload is not None and preload.value < 0.0:
        add(
            "identify.intercept",
            "intercept",
            preload.value,
            value=preload.value,
            unit=unit_in_words(motion.force),
        )
    slopes = pooled.curve.tangent(np.linspace(x.min(), x.max(), 200))
    if law != "monotone-spline" and float(slopes.min()) <= 0.0:
        add("identify.curve_falls", "curve")
    return findings


_SPRINGS: dict[str, tuple[float, float, str]] = {
    "translation": (100.0, 5e6, "spring, tyre or bush of a vehicle"),
    "rotation": (1.0, 1e7, "bar, bush or frame of a vehicle"),
}
"""Plausible range (SI); the stiffest frames twist by 1 degree under 50 kN m, which is 3e6 N m/rad."""


def _no_spring(rate: float, motion: MeasuredMotion) -> list[Finding]:
    least, most, what = _SPRINGS[motion.name]
    if least <= rate <= most:
        return []
    unit = unit_in_words(motion.stiffness)
    return [
        finding(
            "identify.no_spring",
            "stiffness",
            rate,
            rate=rate,
            unit=unit,
            what=what,
            least=least,
            most=most,
            word=motion.deflection_word,
            force_name=motion.force_word,
        )
    ]


def _coefficients(pooled: CurveFit, alone: list[CurveFit]) -> tuple[Estimate, ...]:
    if pooled.curve.kind == "table":
        knots = np.array(pooled.curve.deflection)
        return tuple(
            mean_of_replicates([float(fit.curve(knot)) for fit in alone], value=value)
            for knot, value in zip(knots, pooled.curve.force, strict=True)
        )
    count = len(pooled.curve.coefficients)
    if len(alone) == 1 and pooled.uncertainty is not None:
        return pooled.uncertainty.estimates(pooled.parameters)[:count]
    return tuple(
        mean_of_replicates(
            [float(fit.parameters[i]) for fit in alone], value=float(pooled.parameters[i])
        )
        for i in range(count)
    )


# tyre against pressure ------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class PressureStiffness(Shown):
    """Radial stiffness of a tyre measured at several pressures.

    Attributes
    ----------
    pressures : tuple of float
        Increasing inflation pressures [Pa].
    stiffnesses : tuple of Estimate
        Radial stiffness at each [N/m].
    slope : float or None
        dk/dp of the line through all points [N/m/Pa]; None for one pressure.
    at_zero_pressure : float or None
        Stiffness of that line at zero pressure: the carcass stiffness [N/m].
    exponent : float or None
        n of the power law k ~ p^n through all points [1]; usually not 1, as stiffness is not proportional to pressure.
    findings : tuple of Finding
        Findings, e.g. a stiffness that decreases with pressure.
    """

    pressures: tuple[float, ...]
    stiffnesses: tuple[Estimate, ...]
    slope: float | None
    at_zero_pressure: float | None
    exponent: float | None
    findings: tuple[Finding, ...]

    def at(self, pressure: float) -> tuple[Estimate, list[Finding]]:
        """Interpolate the stiffness [N/m] linearly between measured pressures [Pa].

        The interval combines those of the two neighbouring pressures. Outside the measured range the nearest two are
        extrapolated, with a warning; a single measurement is returned unchanged. Pressures must be positive.
        """
        if not (math.isfinite(pressure) and pressure > 0.0):
            raise FitError(
                "invalid inflation pressure", found=f"{pressure} Pa", allowed="above 0 Pa"
            )
        p = np.array(self.pressures)
        findings = []
        if not p[0] <= pressure <= p[-1]:
            findings.append(
                finding(
                    "identify.pressure_outside",
                    "tyre pressure",
                    pressure,
                    pressure=pressure,
                    least=p[0],
                    most=p[-1],
                )
            )
        if len(p) == 1:
            return self.stiffnesses[0], findings
        right = int(np.clip(np.searchsorted(p, pressure), 1, len(p) - 1))
        share = float((pressure - p[right - 1]) / (p[right] - p[right - 1]))
        return _blend(self.stiffnesses[right - 1], self.stiffnesses[right], share), findings


def _blend(low: Estimate, high: Estimate, share: float) -> Estimate:
    value = (1.0 - share) * low.value + share * high.value
    if (
        low.standard_error is None
        or high.standard_error is None
        or low.interval is None
        or high.interval is None
    ):
        return Estimate(value)

    def combine_errors(a: float, b: float) -> float:
        return math.hypot((1.0 - share) * a, share * b)

    half = combine_errors(low.value - low.interval[0], high.value - high.interval[0])
    return Estimate(
        value, combine_errors(low.standard_error, high.standard_error), (value - half, value + half)
    )


def stiffness_against_pressure(points: Sequence[tuple[float, Estimate]]) -> PressureStiffness:
    """Collect the radial stiffness of a tyre at several pressures [Pa], in any order, each pressure once.

    No points, a pressure that is not positive or given twice, or a stiffness that is not positive raise an error.

    >>> tyre = stiffness_against_pressure([(0.25e6, Estimate(125800.0)), (0.31e6, Estimate(138468.0))])
    >>> round(tyre.slope, 5), round(tyre.exponent, 3), round(tyre.at(0.28e6)[0].value)
    (0.21113, 0.446, 132134)
    """
    if not points:
        raise FitError("no stiffness is given at any pressure", allowed="at least one pressure")
    ordered = sorted(points, key=lambda point: point[0])
    p, k = (
        np.array([point[0] for point in ordered]),
        np.array([point[1].value for point in ordered]),
    )
    if not (np.all(np.isfinite(p)) and p[0] > 0.0):
        raise FitError("invalid inflation pressure", found=f"{p[0]} Pa", allowed="above 0 Pa")
    if np.any(np.diff(p) == 0.0):
        raise FitError(
            "a pressure is given twice",
            found=f"{p[np.argmin(np.diff(p))]:g} Pa",
            hint="Fit its trials together.",
        )
    if not (np.all(np.isfinite(k)) and np.all(k > 0.0)):
        raise FitError(
            "a stiffness is not positive", found=f"{k.min():g} N/m", allowed="above 0 N/m"
        )
    line = np.polyfit(p, k, 1) if len(p) > 1 else None
    exponent = float(np.polyfit(np.log(p), np.log(k), 1)[0]) if len(p) > 1 else None
    findings: list[Finding] = []
    if np.any(np.diff(k) < 0.0):
        findings.append(finding("identify.stiffness_falls", "tyre pressure"))
    return PressureStiffness(
        tuple(map(float, p)),
        tuple(point[1] for point in ordered),
        float(line[0]) if line is not None else None,
        float(line[1]) if line is not None else None,
        exponent,
        tuple(findings),
    )
