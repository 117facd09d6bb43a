"""Damper laws fitted to measured displacement, velocity and force."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from jounce.identify.damper_findings import changes, damper_advice, logger_effects
from jounce.identify.damper_laws import (
    LawName,
    damper_law,
    estimates,
    regularisation_velocity,
    search,
)
from jounce.identify.damper_record import (
    DamperMotion,
    VelocityFrom,
    columns_of,
    cycles_of,
    read_motion,
)
from jounce.identify.damper_result import DamperCurve, DamperResult
from jounce.identify.estimate import r_squared
from jounce.identify.signals import zigzag
from jounce.identify.signs import ForcePositive, StrokePositive, closed_part

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


def fit_damper(  # noqa: PLR0913 - each is a choice of its own
    displacement: ArrayLike | xr.Dataset | pd.DataFrame,
    velocity: ArrayLike | None = None,
    force: ArrayLike | None = None,
    time: ArrayLike | None = None,
    *,
    law: LawName = "linear",
    degree: int = 3,
    odd: bool = False,
    friction: bool = False,
    velocity_from: VelocityFrom = "recorded",
    stroke_positive: StrokePositive | None = None,
    force_positive: ForcePositive | None = None,
    name: str = "damper",
) -> DamperResult:
    """Fit a damper law to a record of imposed motion and force.

    ``linear``: F = c v + F0. ``bilinear``: c_bump for v > 0, c_rebound for v < 0. ``blow-off``: steep up to a
    blow-off force and velocity in each direction, flatter beyond. ``polynomial``: F = F0 + sum a_i v^i.
    ``tanh-hysteretic``: F = c v + k x + f tanh(slope (v + coupling x)) + F0. ``bouc-wen``: F = c v + k x + f z + F0,
    ``z' = rate (v - sigma |v| |z|^(n-1) z + (sigma - 1) v |z|^n)``, the normalised form, whose parameters are unique.
    The search for the shape parameters has many starts; the linear factors are solved for exactly at each step.

    Parameters
    ----------
    displacement : array (n,), Dataset or DataFrame
        [m], compression positive unless stated otherwise, any zero. Given alone: a recording or a table
        (``name [unit]``) with a displacement, a force and optionally a velocity at one location.
    velocity : array (n,) or None
        [m/s], with the sign of the displacement; None: the derivative of the displacement.
    force : array (n,)
        [N], positive where it resists compression unless stated otherwise.
    time : array (n,)
        [s], increasing; not needed with channels of a recording, which contain it.
    law : {"linear", "bilinear", "blow-off", "polynomial", "tanh-hysteretic", "bouc-wen"}
        Force law, as described above.
    degree : int
        Degree of the polynomial [1].
    odd : bool
        Whether the polynomial has odd powers only.
    friction : bool
        Whether to add dry friction to an F(v) law.
    velocity_from : {"recorded", "displacement"}
        Which velocity the law sees.
    stroke_positive : {"compression", "extension"} or None
        Positive direction of the displacement. None: compression, unless the record contradicts it; a finding reports
        a reversed sign, or a sign that the record cannot confirm.
    force_positive : {"compression", "tension"} or None
        Positive direction of the force, likewise.
    name : str
        File or channel named in messages.

    Returns
    -------
    DamperResult
        The fitted law with its parameters in SI and their standard errors.

    Raises
    ------
    FitError
        A record that cannot be used; see :func:`jounce.identify.damper_record.read_motion`.
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
    motion, findings = read_motion(
        *columns_of(displacement, velocity, force, time, name),
        velocity_from=velocity_from,
        stroke_positive=stroke_positive,
        force_positive=force_positive,
        name=name,
    )
    chosen = damper_law(law, motion, degree=degree, odd=odd, friction=friction)
    used = _fitted_part(motion) if chosen.remembers else slice(None)
    weights, shapes, free, at_bound = search(chosen, motion, used)
    names = [*chosen.weights, *chosen.shapes]
    values = np.concatenate([weights, shapes])
    fitted = chosen.columns(motion.displacement, motion.velocity, shapes) @ weights
    residual = (motion.force - fitted)[used]
    estimated = estimates(chosen, motion, used, values, residual, free)
    parameters = {key: parameter for (key, _), parameter in zip(names, estimated, strict=True)}
    plain = {key: parameter.value for key, parameter in parameters.items()}
    measured, x = motion.force[used], motion.displacement[used]
    cycles = motion.cycles - (0.5 if chosen.remembers else 0.0)
    closed = closed_part(x)
    turned = cycles_of(x[closed], is_closed=closed != slice(None))
    rms = float(np.sqrt(np.mean(residual**2)))
    table = {
        "force": max(plain.get("friction_force", 0.0), 0.0),
        "regularisation_velocity": regularisation_velocity(motion),
    }
    result = DamperResult(
        law=law,
        parameters=parameters,
        units=dict(names),
        nrmse=rms / float(np.ptp(measured)),
        r2=r_squared(measured, residual),
        rms_residual=rms,
        energy_per_cycle=float(np.trapezoid(measured[closed], x[closed])) / turned,
        fitted_energy_per_cycle=float(np.trapezoid(fitted[used][closed], x[closed])) / turned,
        cycles=cycles,
        samples=len(residual),
        displacement_centre=motion.centre,
        stroke_positive=motion.signs.stroke_positive,
        force_positive=motion.signs.force_positive,
        damper=chosen.table(plain),
        friction=table if friction else None,
        findings=(),
    )
    findings += damper_advice(result, motion, at_bound, name)
    findings += changes(
        motion.velocity[used] / motion.peak_velocity, fitted[used], residual, result, name
    )
    findings += logger_effects(motion, fitted, parameters["offset"].value, name)
    return replace(result, findings=tuple(findings))


def damper_curve(
    result: DamperResult,
    displacement: ArrayLike | xr.Dataset | pd.DataFrame,
    velocity: ArrayLike | None = None,
    force: ArrayLike | None = None,
    time: ArrayLike | None = None,
    *,
    velocity_from: VelocityFrom = "recorded",
) -> DamperCurve:
    """Evaluate a fitted law on the record it was fitted to or on a different one (a hold-out).

    Parameters
    ----------
    result : DamperResult
        The fitted law.
    displacement, velocity, force, time : array (n,), Dataset or DataFrame
        A record as for :func:`fit_damper` [m, m/s, N, s], with the signs of the fitted record; displacement is counted
        from the middle of its own stroke.
    velocity_from : {"recorded", "displacement"}
        Which velocity the law sees.

    Returns
    -------
    DamperCurve
        The moving part of the record and the force of the law.

    Examples
    --------
    >>> t = np.arange(0.0, 2.0, 1e-3)
    >>> x, v = 0.02 * np.sin(2.0 * np.pi * t), 0.04 * np.pi * np.cos(2.0 * np.pi * t)
    >>> curve = damper_curve(fit_damper(x, v, 1500.0 * v, t, law="linear"), x, v, 1500.0 * v, t)
    >>> bool(np.allclose(curve.fitted, curve.measured))
    True
    """
    motion, _ = read_motion(
        *columns_of(displacement, velocity, force, time, "damper"),
        velocity_from=velocity_from,
        stroke_positive=result.stroke_positive,
        force_positive=result.force_positive,
    )
    powers = [int(key[1:]) for key in result.parameters if key[0] == "a" and key[1:].isdigit()]
    law = damper_law(
        result.law,
        motion,
        degree=max(powers, default=1),
        odd=all(power % 2 for power in powers),
        friction=result.friction is not None,
    )
    values = {key: parameter.value for key, parameter in result.parameters.items()}
    shapes = np.array([values[key] for key, _ in law.shapes])
    weights = np.array([values[key] for key, _ in law.weights])
    fitted = law.columns(motion.displacement, motion.velocity, shapes) @ weights
    return DamperCurve(motion.time, motion.displacement, motion.velocity, motion.force, fitted)


def _fitted_part(motion: DamperMotion) -> slice:
    """Return the part after the first swing, which only initialises the state of a law with memory."""
    turns = zigzag(motion.displacement, 0.1 * motion.stroke)
    return slice(turns[1] if len(turns) > 2 else 0, None)
