"""Static equilibrium and typical sizes of the states."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import SimulationError
from jounce.simulation.compiled import Compiled

Array = NDArray[np.float64]
_ITERATIONS = 60


@dataclass(frozen=True)
class Rest:
    """A state of rest: states, modes of the switches, and the Jacobian of the rates there."""

    x: Array
    modes: Array
    slope: Array


def find_rest(compiled: Compiled, p: Array, u: Array) -> Rest:
    """Solve the static equilibrium for given inputs (their rates taken as zero) by a semi-smooth Newton method.

    Parameters
    ----------
    compiled : Compiled
        The model.
    p : ndarray, shape (n_parameters,)
        Parameter values, SI.
    u : ndarray, shape (2 n_tracks,)
        Inputs: value and rate of each track; rates are set to zero.

    Raises
    ------
    SimulationError
        When no equilibrium exists or is found.
    """
    n_q = len(compiled.model.coordinates)
    x, u = np.zeros(compiled.state_count), u.copy()
    u[1::2] = 0.0
    modes = np.ones(len(compiled.model.switches))
    free = np.r_[0:n_q, 2 * n_q : len(x)]  # coordinates and internal states; velocities stay zero
    rows = np.r_[n_q : len(x)]
    for _ in range(_ITERATIONS):
        residual = compiled.evaluate("rate", x, u, p, modes)[rows]
        slope = compiled.evaluate("rate_x", x, u, p, modes)
        try:
            step = np.linalg.solve(slope[np.ix_(rows, free)], -residual)
        except np.linalg.LinAlgError:
            step = np.linalg.lstsq(slope[np.ix_(rows, free)], -residual, rcond=None)[0]
        x[free] += step
        sides = (compiled.evaluate("switch", x, u, p, modes) > 0.0).astype(float)
        settled = np.array_equal(sides, modes)
        modes = sides
        if settled and np.max(np.abs(step)) <= 1e-14 + 1e-12 * np.max(np.abs(x)):
            return Rest(x, modes, compiled.evaluate("rate_x", x, u, p, modes))
    raise SimulationError(
        "no static equilibrium was found",
        where=", ".join(compiled.model.coordinates),
        hint="Check masses, spring rate or curve (it must carry the weight), preload and bump stops.",
    )


def state_scale(rest: Rest, n_q: int, size: float) -> Array:
    """Typical size of each state for a motion of ``size`` metres: displacements, velocities, internal states."""
    scale = np.ones(len(rest.x))
    stiffness = np.abs(np.diag(rest.slope[n_q : 2 * n_q, :n_q]))
    scale[:n_q] = size
    scale[n_q : 2 * n_q] = size * np.maximum(np.sqrt(stiffness), 1.0)
    return scale
