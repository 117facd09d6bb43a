"""Findings about the record and the law of a damper fit."""

from __future__ import annotations

from typing import Any

import numpy as np

from jounce.core.findings import Finding, finding
from jounce.core.types import Array
from jounce.identify.damper_laws import damper_law, regularisation_velocity
from jounce.identify.damper_record import DamperMotion
from jounce.identify.damper_result import DamperResult
from jounce.identify.estimate import linear_least_squares
from jounce.identify.low_pass import low_pass_corner
from jounce.identify.signals import quantum_of


def hysteresis_share(motion: DamperMotion) -> float:
    """Compute the force difference between rising and falling velocity at equal velocities.

    It is the r.m.s. difference over velocity bins, relative to the range of the force [1]; 0 for any F(v) law.
    """
    rising = np.gradient(motion.velocity, motion.time) > 0.0
    edges = np.linspace(-0.9, 0.9, 22) * motion.peak_velocity
    place = np.digitize(motion.velocity, edges)
    gaps = []
    for index in range(1, len(edges)):
        up, down = motion.force[(place == index) & rising], motion.force[(place == index) & ~rising]
        if len(up) >= 2 and len(down) >= 2:
            noise = up.var(ddof=1) / len(up) + down.var(ddof=1) / len(down)
            gaps.append(max(float((up.mean() - down.mean()) ** 2 - noise), 0.0))
    return float(np.sqrt(np.mean(gaps))) / float(np.ptp(motion.force)) if gaps else 0.0


def damper_advice(
    result: DamperResult, motion: DamperMotion, at_bound: tuple[str, ...], name: str
) -> list[Finding]:
    """Return findings about a fitted law; ``at_bound`` lists the parameters that ended at a bound."""
    findings: list[Finding] = []

    def add(code: str, value: float | None = None, /, **numbers: Any) -> None:
        findings.append(finding(code, name, value, **numbers))

    law, parameters = damper_law(result.law, motion), result.parameters
    shapes = [
        key
        for (key, _), is_signed in zip(law.shapes, law.may_be_negative, strict=True)
        if not is_signed
    ]
    if not law.hysteretic:
        hysteresis = hysteresis_share(motion)
        # The magneto-rheological records have 8 to 10 %; simulated viscous dampers have 1 % with 5 % noise, 2 % with a
        # force that is 25 mrad late.
        if hysteresis > 0.04:
            add("identify.hysteresis", hysteresis, share=hysteresis)
        offset = parameters["offset"]
        if offset.interval and not offset.has(0.0):
            add("identify.force_offset", offset.value, offset=offset.value)
        for key in ("coefficient", "bump_coefficient", "rebound_coefficient"):
            if key in parameters and parameters[key].value < 0.0:
                add("identify.negative_coefficient", parameters[key].value, key=key)
        if result.friction is None:
            step, speed = _force_step(motion) or (None, 0.0)
            if step is not None:
                is_valve = speed > regularisation_velocity(motion)
                code = "identify.degressive_valve" if is_valve else "identify.friction_step"
                add(code, step, speed=speed, step=step)
        if "force" in result.damper and np.any(np.diff(result.damper["force"]) < 0.0):
            add("identify.law_falls")
    for key in at_bound:
        value = parameters[key].value
        add("identify.law_at_bound", value, key=key, value=value, unit=result.units[key])
    for key, parameter in parameters.items():
        vague = parameter.standard_error is not None and parameter.standard_error > 0.5 * abs(
            parameter.value
        )  # zero is within 95 %
        if vague and key in shapes:
            numbers = {"value": parameter.value, "error": parameter.standard_error}
            add(
                "identify.poorly_determined",
                parameter.standard_error,
                key=key,
                unit=result.units[key],
                **numbers,
            )
    if result.cycles < 3.0:  # almost all cycles are the first or the last
        add("identify.few_cycles", result.cycles, cycles=result.cycles)
    if result.r2 < 0.9:  # a line leaves 10 to 16 % of the magneto-rheological records unexplained
        add("identify.law_explains_little", result.r2, share=result.r2)
    return findings


_FADED, _DRIFTED = (
    0.05,
    0.03,
)  # change over the record, as shares of the law's force and of the force range
_FAR, _FEW = (
    12.0,
    0.02,
)  # spike limit in usual residuals; maximum share of samples that may be spikes


def changes(
    speed: Array, fitted: Array, residual: Array, result: DamperResult, name: str
) -> list[Finding]:
    """Report changes during the record: a damper that warms up, a drifting zero, spikes.

    ``speed`` is the velocity relative to its peak. A force error that grows with speed is not a change in time.
    """
    findings: list[Finding] = []
    usual = float(np.median(np.abs(residual))) / 0.6745
    spikes = np.abs(residual) > _FAR * usual
    theirs = float(np.sum(residual[spikes] ** 2)) / max(float(residual @ residual), 1e-300)
    # Spikes are reported if they contribute more to the residual than all other samples together.
    if usual > 0.0 and 0 < np.count_nonzero(spikes) < _FEW * len(residual) and theirs > 0.5:
        findings.append(
            finding(
                "identify.law_spikes",
                name,
                np.count_nonzero(spikes),
                spikes=np.count_nonzero(spikes),
                times=_FAR,
                share=theirs,
            )
        )
        speed, fitted, residual = speed[~spikes], fitted[~spikes], residual[~spikes]
    reach = float(np.ptp(fitted))
    if (
        result.cycles < 2.0 or reach <= 0.0
    ):  # a single cycle cannot separate a change in time from one with velocity
        return findings
    place, force = np.linspace(-0.5, 0.5, len(residual)), fitted - fitted.mean()
    bent = [force * np.abs(speed), np.maximum(speed, 0.0), np.minimum(speed, 0.0)]
    columns = np.column_stack([place, place * force / reach, np.ones_like(force), force, *bent])
    drift, share = linear_least_squares(columns, residual)[0][:2] * (1.0, 1.0 / reach)
    if abs(share) > _FADED:
        code = "identify.damping_falls" if share < 0.0 else "identify.damping_grows"
        findings.append(finding(code, name, share, change=abs(share)))
    if abs(drift) > _DRIFTED * reach:
        findings.append(finding("identify.rest_force_drifts", name, drift, drift=drift))
    return findings


_COARSE = 0.25  # as a share of the force on one side
_NEAR = 12.0  # corner over motion frequency below which a low pass makes bump and rebound similar


def logger_effects(motion: DamperMotion, fitted: Array, offset: float, name: str) -> list[Finding]:
    """Report effects of the logger on the force: coarse quantisation, or a low-pass filter near the motion."""
    findings: list[Finding] = []
    step, force = quantum_of(motion.force), fitted - offset
    side = min(float(force.max()), -float(force.min()))
    if step > _COARSE * side > 0.0:
        findings.append(finding("identify.force_steps", name, step, step=step, side=side))
    time = motion.time
    frequency = motion.cycles / float(time[-1] - time[0])
    rate = 1.0 / float(np.median(np.diff(time)))
    reach = float(np.ptp(motion.force))
    if corner := low_pass_corner(
        motion.force - fitted, rate, frequency, reach=reach, step=step, near=_NEAR
    ):
        findings.append(
            finding("identify.force_low_pass", name, corner, corner=corner, frequency=frequency)
        )
    return findings


def _force_step(motion: DamperMotion) -> tuple[float, float] | None:
    """Return the force step at zero velocity [N] that an F(v) curve needs, and the velocity over which it occurs [m/s].

    Dry friction changes sign within the regularisation velocity; a degressive valve opens over a wider range.
    """
    v = motion.velocity / motion.peak_velocity
    smooth = np.column_stack([np.ones_like(v), np.maximum(v, 0.0), np.minimum(v, 0.0)])

    def fit_columns(*more: Array) -> tuple[float, float]:
        columns = np.column_stack([smooth, *more])
        factors = np.linalg.lstsq(columns, motion.force, rcond=None)[0]
        return float((motion.force - columns @ factors).std()), float(factors[-1])

    sharp = regularisation_velocity(motion)
    without, (left, step) = fit_columns()[0], fit_columns(np.tanh(motion.velocity / sharp))
    # A chosen limit: a lower one mistakes bends for steps, a higher one misses weak friction. The magneto-rheological
    # damper without current has a step of 21 % of its range.
    if step <= 0.02 * float(np.ptp(motion.force)) or left >= 0.8 * without:
        return None
    # A knee within twice the regularisation velocity cannot be distinguished from friction.
    knees = [share * motion.peak_velocity for share in (0.05, 0.1, 0.2, 0.4)]
    soft, height, knee = min(
        (*fit_columns(np.tanh(motion.velocity / knee)), knee)
        for knee in knees
        if knee > 2.0 * sharp
    )
    return (
        (height, knee) if soft < 0.9 * left else (step, sharp)
    )  # if both fit equally well, friction
