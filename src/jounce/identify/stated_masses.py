"""Masses that a rig states, held against trials: what is recorded of motion knows their ratios, and no scale."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from jounce.core.errors import SimulationError
from jounce.core.findings import Finding
from jounce.core.types import Array
from jounce.identify.fit_problem import Free, UpdateProblem
from jounce.parts import Rig
from jounce.recordings.schema import channel_unit
from jounce.simulation.compiled import compile_rig

_RANGE = 0.3  # of a mass: as far as it is looked for to either side
_HALVED = 0.5  # of what is left: other masses that leave less are told
_STEPS = 3
_TOLD_APART = 1e-4  # of the largest singular value: combinations that matter less stay as they are, the scale too
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
    """Masses (kg) of the equations that are not fitted, by path."""
    used = compile_rig(rig).facts.parameters
    values = rig.parameters()
    return {path: values[path] for path in used if path.endswith("mass") and path not in free and values[path] > 0.0}


def preferred_masses(problem: UpdateProblem, scaled: Array, **settings: object) -> list[Finding]:
    """Say that other masses would leave half as much, and which ratio of them the data prefer.

    ``scaled`` is the optimum of ``problem`` with the masses as stated, ``settings`` what else it was made with. Their
    common scale is nothing that the data know: the sum is told as stated.
    """
    rig = problem.trials[0].source.rig
    masses = stated_masses(rig, [one.path for one in problem.free])
    if len(masses) < 2:
        return []
    more = [Free(path, mass, (1.0 - _RANGE) * mass, (1.0 + _RANGE) * mass) for path, mass in masses.items()]
    count = len(problem.free)
    wider = UpdateProblem(
        [one.source for one in problem.trials],
        [*problem.free, *more],
        align=problem.align,
        lag_bound=problem.lag_bound,
        tolerance=problem.tolerance,
        nuisances=problem.nuisances,
        **settings,  # type: ignore[arg-type]
    )
    x = np.concatenate([scaled[:count], np.zeros(len(more)), scaled[count:]])
    before, _ = wider.objective(x)
    after = before
    for _ in range(_STEPS):
        found = wider.residuals(x)
        step = -np.linalg.pinv(found.jacobian, rcond=_TOLD_APART) @ found.vector
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
    listed = ", ".join(f"{path} {scale * value:.4g} kg for {masses[path]:.4g}" for path, value in values.items())
    text = (
        f"other masses would leave {100.0 * after / before:.2g} % of what is left: with their sum as stated, {listed}. "
        "Weigh them; what was fitted makes up for masses that are wrong"
    )
    return [Finding("masses", "warning", text, after / before)]


def scale_of_masses(
    free: Sequence[str], channels: Sequence[str], doubt: float, known: Collection[str]
) -> list[Finding]:
    """Say that the scale of all rates is that of the stated masses, where no force was measured.

    ``doubt`` is how far the masses may be off (1, 95 %), ``known`` the parameters that have a value of their own
    beforehand.
    """
    by_mass = [path for path in free if path.endswith(_BY_MASS)]
    if any(channel_unit(name) == "N" for name in channels) or not by_mass or any(path in known for path in by_mass):
        return []
    if any(path.endswith("mass") for path in free):
        text = (
            "no force was measured and no rate is known beforehand, so masses and rates are known but for a common "
            "factor: give a rate its bench value as prior, or fix a mass"
        )
        return [Finding("masses", "warning", text)]
    text = (
        f"the scale of {', '.join(by_mass)} is set by the stated masses (± {100.0 * doubt:.2g} %): all of them larger "
        "by one factor would move alike"
    )
    return [Finding("masses", "note", text, doubt)]
