"""What a reader of a fitted damper law must know."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from jounce.core.findings import Finding, Severity
from jounce.identify.damper_laws import regularisation_velocity
from jounce.identify.damper_motion import DamperMotion

if TYPE_CHECKING:
    from jounce.identify.damper_fit import DamperResult

_VELOCITY_LAWS = ("linear", "bilinear", "polynomial")


def hysteresis_share(motion: DamperMotion) -> float:
    """Tell how far the force at one velocity depends on whether the speed is rising or falling.

    Parameters
    ----------
    motion : DamperMotion
        The record.

    Returns
    -------
    float
        Root mean square of the difference between rising and falling velocity over bins, by the range of the force [1];
        0 for any F(v).
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
    result: DamperResult, motion: DamperMotion, hysteresis: float, at_bound: tuple[str, ...], name: str
) -> list[Finding]:
    """Collect the findings about a fitted law; ``hysteresis`` is :func:`hysteresis_share`."""
    findings: list[Finding] = []

    def add(severity: Severity, text: str, value: float | None = None) -> None:
        findings.append(Finding(name, severity, text, value))

    if result.law in _VELOCITY_LAWS:
        _advise_velocity_law(result, motion, hysteresis, name, findings)
    for key in at_bound:
        text = (
            f"{key} ended at the limit of its range ({result.parameters[key].value:.4g} {result.units[key]}): the "
            "record does not determine it."
        )
        add("warning", text, result.parameters[key].value)
    for key, one in result.parameters.items():
        vague = one.standard_error is not None and one.standard_error > 0.5 * abs(one.value)
        if vague and key in ("sigma", "rate", "exponent", "slope"):
            text = (
                f"{key} = {one.value:.3g} +- {one.standard_error:.2g} {result.units[key]} is hardly determined: the "
                "record has too few samples where the force changes over."
            )
            add("note", text, one.standard_error)
    if result.cycles < 3.0:
        text = f"only {result.cycles:.1f} cycles: the standard errors rest on few repetitions."
        add("note", text, result.cycles)
    if result.r2 < 0.9:
        text = (
            f"the law explains only {100.0 * result.r2:.0f} % of the force; take another one and look at both curves."
        )
        add("warning", text, result.r2)
    return findings


def _advise_velocity_law(
    result: DamperResult, motion: DamperMotion, hysteresis: float, name: str, findings: list[Finding]
) -> None:
    if hysteresis > 0.04:
        text = (
            f"the force differs by {100.0 * hysteresis:.0f} % of its range between rising and falling velocity: "
            "hysteresis, which no F(v) law can follow; try 'tanh-hysteretic' or 'bouc-wen'."
        )
        findings.append(Finding(name, "warning", text, hysteresis))
    offset = result.parameters["offset"]
    if offset.interval and not offset.interval[0] <= 0.0 <= offset.interval[1]:
        text = (
            f"the force has an offset of {offset.value:.3g} N (gas pressure, spring, load-cell zero), not part "
            "of the damper table: put it into the preload."
        )
        findings.append(Finding(name, "note", text, offset.value))
    for key in ("coefficient", "bump_coefficient", "rebound_coefficient"):
        if key in result.parameters and result.parameters[key].value < 0.0:
            text = f"{key} is negative: the law would feed energy into the motion."
            findings.append(Finding(name, "problem", text, result.parameters[key].value))
    if result.friction is None:
        _advise_friction(motion, name, findings)
    if "force" in result.damper and np.any(np.diff(result.damper["force"]) < 0.0):
        text = "the fitted curve falls with rising velocity somewhere; lower the degree."
        findings.append(Finding(name, "warning", text))


def _advise_friction(motion: DamperMotion, name: str, findings: list[Finding]) -> None:
    """Compare smooth velocity curves with and without a step at zero velocity."""
    v = motion.velocity / motion.peak_velocity
    smooth = np.column_stack([np.ones_like(v), np.maximum(v, 0.0), np.minimum(v, 0.0)])
    stepped = np.column_stack([smooth, np.tanh(motion.velocity / regularisation_velocity(motion))])
    found = np.linalg.lstsq(stepped, motion.force, rcond=None)[0]
    without = motion.force - smooth @ np.linalg.lstsq(smooth, motion.force, rcond=None)[0]
    left = float(without.std()), float((motion.force - stepped @ found).std())
    if found[-1] > 0.02 * float(np.ptp(motion.force)) and left[1] < 0.8 * left[0]:
        text = (
            f"the force jumps by about +-{found[-1]:.3g} N where the velocity changes sign: dry friction; fit with "
            "friction=True or a hysteretic law."
        )
        findings.append(Finding(name, "warning", text, float(found[-1])))
