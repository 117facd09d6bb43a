"""Damper laws fitted to measured displacement, velocity and force."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.identify.damper_advice import damper_advice, hysteresis_share
from jounce.identify.damper_laws import DamperLaw, damper_law, regularisation_velocity
from jounce.identify.damper_motion import DamperMotion, VelocityFrom, read_motion
from jounce.identify.estimate import Estimate
from jounce.identify.regression import r_squared, uncertainty

LawName = Literal["linear", "bilinear", "polynomial", "tanh-hysteretic", "bouc-wen"]


@dataclass(frozen=True)
class DamperResult:
    """A damper law found from a record.

    Attributes
    ----------
    law : str
        Name of the law.
    parameters : dict of str to Estimate
        By name, SI; the standard errors allow for autocorrelated residuals. Without interval: at a bound.
    units : dict of str to str
        Unit of each parameter.
    nrmse : float
        Root mean square of measured minus fitted force, over the range (largest minus smallest) of the force [1].
    r2 : float
        Share of the variance of the force explained [1].
    rms_residual : float
        [N].
    energy_per_cycle, fitted_energy_per_cycle : float
        Work done on the damper per cycle, measured and by the law [J].
    cycles : float
        Cycles fitted [1].
    samples : int
        Samples fitted [1].
    displacement_centre : float
        Middle of the stroke in the record [m]: displacement in the law is counted from there.
    damper : dict
        Table to write under ``strut.damper`` in a rig, SI, bump positive. F(v) laws leave the offset out: it is a
        static force and belongs to the preload.
    friction : dict or None
        Table to write under ``strut.friction``; None when the law has none.
    findings : tuple of Finding
        Doubts about record and law.
    """

    law: str
    parameters: dict[str, Estimate]
    units: dict[str, str]
    nrmse: float
    r2: float
    rms_residual: float
    energy_per_cycle: float
    fitted_energy_per_cycle: float
    cycles: float
    samples: int
    displacement_centre: float
    damper: dict[str, Any]
    friction: dict[str, float] | None
    findings: tuple[Finding, ...]


@dataclass(frozen=True)
class DamperCurve:
    """Measured and fitted force side by side, for drawing.

    Attributes
    ----------
    time, displacement, velocity, measured, fitted : array (n,)
        [s], [m] from the middle of the stroke, [m/s], [N], [N].
    """

    time: Array
    displacement: Array
    velocity: Array
    measured: Array
    fitted: Array


def fit_damper(
    displacement: ArrayLike,
    velocity: ArrayLike | None,
    force: ArrayLike,
    time: ArrayLike,
    *,
    law: LawName = "linear",
    degree: int = 3,
    odd: bool = False,
    friction: bool = False,
    velocity_from: VelocityFrom = "recorded",
    name: str = "damper",
) -> DamperResult:
    """Fit a damper law to a record of imposed motion and force.

    ``linear``: F = c v + F0. ``bilinear``: c_bump for v > 0, c_rebound for v < 0. ``polynomial``: F = F0 + sum a_i v^i.
    ``tanh-hysteretic``: F = c v + k x + f tanh(slope (v + coupling x)) + F0. ``bouc-wen``: F = c v + k x + f z + F0,
    ``z' = rate (v - sigma |v| |z|^(n-1) z + (sigma - 1) v |z|^n)``, the normalised form, whose parameters are unique.
    Shape parameters are searched from many starts; the factors are solved for exactly at each step.

    Parameters
    ----------
    displacement : array (n,)
        [m], compression positive, any zero.
    velocity : array (n,) or None
        [m/s]; None: the derivative of the displacement.
    force : array (n,)
        [N], positive where it resists compression.
    time : array (n,)
        [s], increasing.
    law : {"linear", "bilinear", "polynomial", "tanh-hysteretic", "bouc-wen"}
        See above.
    degree : int
        Of the polynomial [1].
    odd : bool
        Polynomial with odd powers only.
    friction : bool
        Add dry friction to an F(v) law.
    velocity_from : {"recorded", "displacement"}
        Which velocity the law sees.
    name : str
        File or channel, used in messages.

    Returns
    -------
    DamperResult
        Parameters in SI with standard errors.

    Raises
    ------
    FitError
        A record that cannot be used; see :func:`jounce.identify.damper_motion.read_motion`.
    DescriptionError
        An unknown law.

    References
    ----------
    Kwok et al. (2006), Sensors and Actuators A 132, 441-451; Ikhouane and Rodellar (2007), Systems with Hysteresis.

    Examples
    --------
    >>> t = np.arange(0.0, 4.0, 0.01)
    >>> x, v = 0.02 * np.sin(6.0 * t), 0.12 * np.cos(6.0 * t)
    >>> result = fit_damper(x, v, np.where(v > 0.0, 300.0, 900.0) * v, t, law="bilinear")
    >>> [round(estimate.value) for estimate in result.parameters.values()]
    [300, 900, 0]
    """
    motion, findings = read_motion(displacement, velocity, force, time, velocity_from=velocity_from, name=name)
    chosen = damper_law(law, motion, degree=degree, odd=odd, friction=friction)
    used = _fitted_part(motion) if chosen.remembers else slice(None)
    weights, shapes, free, at_bound = _search(chosen, motion, used)
    names = [*chosen.weights, *chosen.shapes]
    values = np.concatenate([weights, shapes])
    fitted = chosen.columns(motion.displacement, motion.velocity, shapes) @ weights
    residual = (motion.force - fitted)[used]
    estimates = _estimates(chosen, motion, used, values, residual, free)
    parameters = {key: one for (key, _), one in zip(names, estimates, strict=True)}
    plain = {key: one.value for key, one in parameters.items()}
    measured, x = motion.force[used], motion.displacement[used]
    cycles = motion.cycles - (0.5 if chosen.remembers else 0.0)
    rms = float(np.sqrt(np.mean(residual**2)))
    result = DamperResult(
        law=law,
        parameters=parameters,
        units=dict(names),
        nrmse=rms / float(np.ptp(measured)),
        r2=r_squared(measured, residual),
        rms_residual=rms,
        energy_per_cycle=float(np.trapezoid(measured, x)) / cycles,
        fitted_energy_per_cycle=float(np.trapezoid(fitted[used], x)) / cycles,
        cycles=cycles,
        samples=len(residual),
        displacement_centre=motion.centre,
        damper=chosen.table(plain),
        friction=_friction_table(plain, motion) if friction else None,
        findings=(),
    )
    findings += damper_advice(result, motion, hysteresis_share(motion), at_bound, name)
    return DamperResult(**{**vars(result), "findings": tuple(findings)})


def damper_curve(
    result: DamperResult,
    displacement: ArrayLike,
    velocity: ArrayLike | None,
    force: ArrayLike,
    time: ArrayLike,
    *,
    velocity_from: VelocityFrom = "recorded",
) -> DamperCurve:
    """Evaluate a fitted law on a record, the one it was fitted to or another one (a hold-out).

    Parameters
    ----------
    result : DamperResult
        The fitted law.
    displacement, velocity, force, time : array (n,)
        A record as for :func:`fit_damper`; displacement is counted from the middle of its own stroke.
    velocity_from : {"recorded", "displacement"}
        Which velocity the law sees.

    Returns
    -------
    DamperCurve
        The moving part of the record with the law's force.
    """
    motion, _ = read_motion(displacement, velocity, force, time, velocity_from=velocity_from)
    powers = [int(key[1:]) for key in result.parameters if key[0] == "a" and key[1:].isdigit()]
    law = damper_law(
        result.law,
        motion,
        degree=max(powers, default=1),
        odd=all(power % 2 for power in powers),
        friction=result.friction is not None,
    )
    values = {key: one.value for key, one in result.parameters.items()}
    shapes = np.array([values[key] for key, _ in law.shapes])
    weights = np.array([values[key] for key, _ in law.weights])
    fitted = law.columns(motion.displacement, motion.velocity, shapes) @ weights
    return DamperCurve(motion.time, motion.displacement, motion.velocity, motion.force, fitted)


def _fitted_part(motion: DamperMotion) -> slice:
    """Leave out the first swing, which only brings a law with a memory into its state."""
    from jounce.identify.decay_peaks import zigzag

    turns = zigzag(motion.displacement, 0.1 * motion.stroke)
    return slice(turns[1] if len(turns) > 2 else 0, None)


def _weights(law: DamperLaw, columns: Array, force: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Best factors of the columns, those that cannot be negative cut at zero; and which of them are free."""
    free = np.ones(columns.shape[1], bool)
    scale = np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
    found = np.zeros(columns.shape[1])
    for _ in range(3):
        found = np.zeros(columns.shape[1])
        found[free] = np.linalg.lstsq(columns[:, free] / scale[free], force, rcond=None)[0] / scale[free]
        wrong = [i for i, (key, _) in enumerate(law.weights) if key in law.not_negative and found[i] < 0.0]
        if not wrong:
            break
        free[wrong] = False
        found[wrong] = 0.0
    return found, free


def _coded(law: DamperLaw, shapes: Array) -> Array:
    """Shape parameters as the search sees them: logarithms, but for the coupling, which has a sign."""
    return np.array(
        [
            value / bound if key == "displacement_coupling" else math.log(value)
            for (key, _), value, bound in zip(law.shapes, shapes, law.bounds[1], strict=True)
        ]
    )


def _decoded(law: DamperLaw, coded: Array) -> Array:
    return np.array(
        [
            value * bound if key == "displacement_coupling" else math.exp(value)
            for (key, _), value, bound in zip(law.shapes, coded, law.bounds[1], strict=True)
        ]
    )


def _search(
    law: DamperLaw, motion: DamperMotion, used: slice
) -> tuple[Array, Array, NDArray[np.bool_], tuple[str, ...]]:
    """Weights, shapes, which parameters are free, and the names of those at a bound."""
    from scipy.optimize import least_squares

    size = float(motion.force.std())

    def misfit(coded: Array) -> Array:
        columns = law.columns(motion.displacement, motion.velocity, _decoded(law, coded))[used]
        return np.asarray((columns @ _weights(law, columns, motion.force[used])[0] - motion.force[used]) / size)

    shapes, inside = law.starts[0], np.zeros(0, bool)
    if law.shapes:
        low, high = _coded(law, law.bounds[0]), _coded(law, law.bounds[1])
        starts = [np.clip(_coded(law, start), low + 1e-6, high - 1e-6) for start in law.starts]
        starts.sort(key=lambda start: float((misfit(start) ** 2).sum()))
        found = [
            least_squares(misfit, start, bounds=(low, high), diff_step=1e-4, xtol=1e-8, ftol=1e-9, max_nfev=60)
            for start in starts[:4]
        ]
        best = min(found, key=lambda one: float(one.cost))
        shapes = _decoded(law, best.x)
        inside = (best.x > low + 1e-3) & (best.x < high - 1e-3)
    columns = law.columns(motion.displacement, motion.velocity, shapes)[used]
    weights, free = _weights(law, columns, motion.force[used])
    every = np.concatenate([free, inside])
    names = [key for key, _ in (*law.weights, *law.shapes)]
    return weights, shapes, every, tuple(key for key, is_free in zip(names, every, strict=True) if not is_free)


def _estimates(
    law: DamperLaw, motion: DamperMotion, used: slice, values: Array, residual: Array, free: NDArray[np.bool_]
) -> list[Estimate]:
    count = len(law.weights)

    def force(point: Array) -> Array:
        columns = law.columns(motion.displacement, motion.velocity, point[count:])
        return np.asarray((columns @ point[:count])[used])

    jacobian = np.empty((len(residual), len(values)))
    jacobian[:, :count] = law.columns(motion.displacement, motion.velocity, values[count:])[used]
    for index in range(count, len(values)):
        step = np.zeros(len(values))
        reach = float(law.bounds[1][index - count]) if law.shapes[index - count][0] == "displacement_coupling" else 0.0
        step[index] = 1e-3 * max(abs(float(values[index])), 1e-2 * reach)
        jacobian[:, index] = (force(values + step) - force(values - step)) / (2.0 * step[index])
    known = uncertainty(jacobian[:, free], residual).estimates(values[free])
    remaining = iter(known)
    return [next(remaining) if is_free else Estimate(float(v)) for v, is_free in zip(values, free, strict=True)]


def _friction_table(values: dict[str, float], motion: DamperMotion) -> dict[str, float]:
    return {
        "force": max(values["friction_force"], 0.0),
        "regularisation_velocity": regularisation_velocity(motion),
    }
