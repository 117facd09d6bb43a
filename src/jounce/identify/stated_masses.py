"""Compare stated masses with trials: recorded motion determines the ratios of masses, but not their scale."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence

import numpy as np

from jounce.core.errors import FitError, SimulationError
from jounce.core.findings import Finding, finding
from jounce.core.types import Array
from jounce.identify.estimate import Estimate
from jounce.identify.fit_problem import FitTrial, FreeParameter, UpdateProblem
from jounce.parts import Rig, Vehicle
from jounce.recordings.schema import channel_unit
from jounce.simulation.compiled import compile_rig

_RANGE = 0.3  # share of a mass: range of the search to either side
_HALVED = 0.5  # share of the residual below which different masses are reported
_STEPS = 3  # of Gauss and Newton, from an optimum on
_TOLD_APART = (
    1e-4  # share of the largest singular value: combinations below it are kept, including the scale
)
_BY_MASS = (
    ".rate",
    ".stiffness",
    ".coefficient",
    ".bump_coefficient",
    ".rebound_coefficient",
    ".force",
    "_coefficient",
)


def stated_masses(rig: Rig, free: Sequence[str]) -> dict[str, float]:
    """Return the masses (kg) of the equations that are not fitted, by path."""
    used = compile_rig(rig).facts.parameters
    values = rig.parameters()
    return {
        path: values[path]
        for path in used
        if path.endswith("mass") and path not in free and values[path] > 0.0
    }


def static_load(rig: Rig, numbers: Mapping[str, float]) -> float:
    """Compute the static wheel load (N) of a one-wheel rig, which carries all masses: guides take no vertical force."""
    used = compile_rig(rig).facts.parameters
    return numbers["gravity"] * sum(
        value for path, value in numbers.items() if path.endswith("mass") and path in used
    )


def loads_held_against_masses(trials: Sequence[FitTrial]) -> list[Finding]:
    """Report trials whose measured static wheel load contradicts the stated masses; raise an error for vehicles."""
    findings = []
    for trial in trials:
        if trial.wheel_load is None:
            continue
        if isinstance(trial.rig, Vehicle):
            raise FitError(
                "a wheel load at rest determines the masses only for rigs with one wheel",
                where=trial.name,
                found=type(trial.rig).__name__,
                allowed="a quarter car or a corner, or no wheel load",
            )
        load = static_load(trial.rig, trial.rig.parameters())
        more = trial.wheel_load / load - 1.0
        if abs(more) > _WEIGHED:
            findings.append(
                finding(
                    "identify.masses_weigh_otherwise",
                    f"{trial.name}: wheel_load",
                    more,
                    wheel_load=trial.wheel_load,
                    load=load,
                    excess=more,
                )
            )
    return findings


_WEIGHED = 0.02  # of a load: as far as masses of lumped rigs are doubted


def preferred_masses(problem: UpdateProblem, scaled: Array) -> list[Finding]:
    """Report if different masses would halve the residual, and the mass ratio that fits best.

    ``scaled`` is the optimum of ``problem`` with the stated masses. The data do not determine their common scale, so
    the stated sum is kept.
    """
    rig = problem.trials[0].source.rig
    masses = stated_masses(rig, [item.path for item in problem.free])
    if len(masses) < 2:
        return []
    more = [
        FreeParameter(path, mass, (1.0 - _RANGE) * mass, (1.0 + _RANGE) * mass)
        for path, mass in masses.items()
    ]
    count = len(problem.free)
    wider = UpdateProblem(
        [item.source for item in problem.trials],
        [*problem.free, *more],
        problem.settings,
        problem.nuisances,
    )
    x = np.concatenate([scaled[:count], np.zeros(len(more)), scaled[count:]])
    before, _ = wider.objective(x)
    after = before
    for _ in range(_STEPS):
        residuals = wider.residuals(x)
        step = -np.linalg.pinv(residuals.jacobian, rcond=_TOLD_APART) @ residuals.vector
        moved = np.clip(x + step, -1.0, 1.0)
        try:
            reached, _ = wider.objective(moved)
        except SimulationError:
            break
        if reached >= after:
            break
        x, after = moved, reached
    if after > _HALVED * before:
        return []
    values = dict(zip(masses, wider.values(x)[count:], strict=True))
    scale = sum(masses.values()) / sum(values.values())
    listed = ", ".join(
        f"{path} {scale * value:.4g} kg for {masses[path]:.4g}" for path, value in values.items()
    )
    return [
        finding(
            "identify.other_masses", "masses", after / before, share=after / before, masses=listed
        )
    ]


def scale_of_masses(
    free: Sequence[str],
    channels: Sequence[str],
    doubt: float,
    known: Collection[str],
    *,
    is_weighed: bool = False,
) -> list[Finding]:
    """Report that, without a measured force, the stated masses determine the scale of all rates.

    ``doubt`` is the uncertainty of the masses (1, 95 %), ``known`` are the parameters with independent prior values;
    ``is_weighed`` is true if the static wheel load was measured.
    """
    if is_weighed:
        return []
    by_mass = [path for path in free if path.endswith(_BY_MASS)]
    if (
        any(channel_unit(name) == "N" for name in channels)
        or not by_mass
        or any(path in known for path in by_mass)
    ):
        return []
    if any(path.endswith("mass") for path in free):
        return [finding("identify.scale_unknown", "masses")]
    return [
        finding("identify.scale_of_masses", "masses", doubt, names=", ".join(by_mass), doubt=doubt)
    ]


def off_together(
    updated: Mapping[str, float],
    bench: Mapping[str, Estimate],
    contradicted: Collection[str],
    angle: float,
) -> list[Finding]:
    """Report masses or a strut angle that would explain rates that all differ from bench values by one factor.

    ``updated`` are values of the update by path, ``bench`` those of component tests (SI), ``contradicted`` the paths
    for which they disagree; ``angle`` is the stated strut angle in rad.
    """
    tested = [
        path
        for path in updated
        if path in bench and path.endswith(_BY_MASS) and bench[path].value > 0.0
    ]
    off = [path for path in tested if path in contradicted]
    rates = [path for path in tested if path.endswith(_RATES)]
    if len(off) < 2 or not set(rates) <= set(off):
        return []
    factors = np.array([updated[path] / bench[path].value for path in off])
    factor = float(np.mean(factors))
    if factor <= 0.0 or np.ptp(factors) > _ALIKE * abs(factor - 1.0):
        return []
    listed = ", ".join(f"{path} {ratio:.3g}" for path, ratio in zip(off, factors, strict=True))
    excess = 1.0 / factor - 1.0
    cosine = math.sqrt(factor) * math.cos(angle)
    if all(path.startswith("strut.") for path in off) and cosine < 1.0:
        lean = math.acos(cosine)
        return [
            finding(
                "identify.masses_or_angle_off",
                "masses",
                factor,
                factors=listed,
                excess=excess,
                angle=lean,
            )
        ]
    return [finding("identify.masses_off", "masses", factor, factors=listed, excess=excess)]


_RATES = (".rate", ".stiffness")
_ALIKE = (
    0.5  # relative to the distance of a factor from 1: factors that differ by less count as equal
)
