"""Static equilibrium and typical sizes of the states."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import SimulationError
from jounce.simulation.compiled import Compiled

Array = NDArray[np.float64]
_ITERATIONS = 60
_SAGS = (0.0, 1e-4, 1e-3, 1e-2, 1e-1)  # m
_FAR = 1e3  # m: a step that long means that nothing holds the weight
_UNBALANCED = 1e-6  # m/s^2


@dataclass(frozen=True)
class Rest:
    """A state of rest: states, modes of the switches, Jacobian of the rates, and which states the balance decides.

    ``decided`` are the coordinates and the internal states with a rate of their own at rest; the others (a hysteretic
    state that only moves with the damper) stay at zero. ``rows`` are the rates that must vanish for them.
    """

    x: Array
    modes: Array
    slope: Array
    decided: NDArray[np.intp]
    rows: NDArray[np.intp]


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
    u = u.copy()
    u[1::2] = 0.0
    count = len(compiled.model.coordinates)
    depth = np.arange(count, 0, -1, dtype=float)
    for sag in _SAGS:  # springs that are soft at first need a start that compresses them
        start = np.zeros(compiled.state_count)
        start[:count] = (u[0] if len(u) else 0.0) - sag * depth
        rest = _newton(compiled, p, u, start)
        if rest is not None:
            return rest
    raise SimulationError(
        "no static equilibrium was found",
        where=", ".join(compiled.model.coordinates),
        hint="Check masses, spring rate or curve (it must carry the weight), preload and bump stops.",
    )


def _newton(compiled: Compiled, p: Array, u: Array, x: Array) -> Rest | None:
    """Newton from ``x``; modes follow the sides of their switches; None when it does not settle on a true balance."""
    count = len(compiled.model.coordinates)
    modes = (compiled.evaluate("switch", x, u, p, np.ones(len(compiled.model.switches))) > 0.0).astype(float)
    for _ in range(_ITERATIONS):
        slope = compiled.evaluate("rate_x", x, u, p, modes)
        internal = [i for i in range(2 * count, len(x)) if slope[i, i] != 0.0]
        decided, rows = np.array([*range(count), *internal]), np.array([*range(count, 2 * count), *internal])
        residual = compiled.evaluate("rate", x, u, p, modes)[rows]
        try:
            step = np.linalg.solve(slope[np.ix_(rows, decided)], -residual)
        except np.linalg.LinAlgError:
            return None
        if not np.all(np.isfinite(step)) or np.max(np.abs(step)) > _FAR:
            return None
        x = x.copy()
        x[decided] += step
        sides = (compiled.evaluate("switch", x, u, p, modes) > 0.0).astype(float)
        settled = np.array_equal(sides, modes) and np.max(np.abs(step)) <= 1e-13 + 1e-11 * np.max(np.abs(x))
        modes = sides
        if settled:
            balance = compiled.evaluate("rate", x, u, p, modes)[rows]
            if np.max(np.abs(balance)) > _UNBALANCED:
                return None
            return Rest(x, modes, compiled.evaluate("rate_x", x, u, p, modes), decided, rows)
    return None


def state_scale(rest: Rest, n_q: int, size: float) -> Array:
    """Typical size of each state for a motion of ``size`` metres: displacements, velocities, internal states."""
    scale = np.ones(len(rest.x))
    stiffness = np.abs(np.diag(rest.slope[n_q : 2 * n_q, :n_q]))
    scale[:n_q] = size
    scale[n_q : 2 * n_q] = size * np.maximum(np.sqrt(stiffness), 1.0)
    return scale
