"""Random vibration of one linear model, written to be read: impulse responses and transfer functions, one at a time.

A model is a table: ``A``, ``B0``, ``B1`` (by heights of the road and by their rates, a column for each wheel), ``C``,
``D0``, ``D1``, and ``delays`` of the wheels (s). Slopes have no formulas of their own: they are differences.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np
from scipy.linalg import expm, solve_continuous_lyapunov

Table = dict[str, np.ndarray]
_PANELS, _POINTS = 4, 20  # of the integrals between the delays
_STEP = 2e-2
_EIGHTH_ORDER = ((1, 4 / 5), (2, -1 / 5), (3, 4 / 105), (4, -1 / 280))


def white_variance(model: Table, noises: Sequence[Sequence[int]]) -> np.ndarray:
    """Variance of each output where the road's velocity is white noise of intensity 1, one noise for some wheels each.

    An output answers an impulse by ``h(t)``; its variance is the integral of ``h(t)**2``.
    """
    a, c, delays = model["A"], model["C"], model["delays"]
    slow = -np.linalg.solve(a, model["B0"])  # where the states are when the road moves slowly
    push, level = model["B1"] - slow, c @ slow + model["D0"]
    seen = [
        solve_continuous_lyapunov(a.T, -np.outer(row, row)) for row in c
    ]  # integral of (row exp(A t))' (row exp(A t))
    total = np.zeros(len(c))
    for wheels in noises:
        times = sorted({delays[k] for k in wheels})
        for begin, end in pairwise(times):
            reached = [k for k in wheels if delays[k] <= begin]

            def squared(t: float, reached: Sequence[int] = reached) -> np.ndarray:
                moved = sum(expm(a * (t - delays[k])) @ push[:, k] for k in reached)
                return (c @ moved + level[:, reached].sum(axis=1)) ** 2

            total += _integral(squared, begin, end)
        last = times[-1]
        state = sum(expm(a * (last - delays[k])) @ push[:, k] for k in wheels)
        total += np.array([state @ part @ state for part in seen])
    return total


def _integral(function: Callable[[float], np.ndarray], begin: float, end: float) -> np.ndarray:
    points, weights = np.polynomial.legendre.leggauss(_POINTS)
    width = (end - begin) / _PANELS
    total = np.zeros(())
    for i in range(_PANELS):
        for point, weight in zip(points, weights, strict=True):
            total = total + 0.5 * width * weight * function(
                begin + width * (i + 0.5 * (1.0 + point))
            )
    return total


def band_variance(
    model: Table, noises: Sequence[Sequence[int]], frequency: np.ndarray, power: np.ndarray, gain: np.ndarray,
    coherence: np.ndarray | None = None,
) -> np.ndarray:  # fmt: skip
    """Sum over frequencies (Hz) of the squared responses times ``power`` (f,), m^2, and ``gain`` (outputs, f).

    ``coherence`` (f,) is the root of that of two noises, where they have one.
    """
    total = np.zeros(len(model["C"]))
    for i, f in enumerate(frequency):
        answers = [_response(model, wheels, 2j * np.pi * f) for wheels in noises]
        squared = sum(np.abs(answer) ** 2 for answer in answers)
        if coherence is not None:
            squared = squared + 2.0 * coherence[i] * (answers[0] * answers[1].conj()).real
        total += squared * power[i] * gain[:, i]
    return total


def _response(model: Table, wheels: Sequence[int], s: complex) -> np.ndarray:
    """Amplitude of the outputs for a road of amplitude 1 that reaches each of the wheels after its delay."""
    states = np.linalg.solve(
        s * np.eye(len(model["A"])) - model["A"], model["B0"] + s * model["B1"]
    )
    whole = model["C"] @ states + model["D0"] + s * model["D1"]
    return sum(whole[:, k] * np.exp(-s * model["delays"][k]) for k in wheels)


def slope(
    function: Callable[[Table], np.ndarray], model: Table, along: Table, size: float
) -> np.ndarray:
    """Slope of variances along a number of some size, from those of the model's parts: differences of 8th order."""
    step = _STEP * size
    found = np.zeros(())
    for count, weight in _EIGHTH_ORDER:
        ahead, behind = (
            function(
                {name: part + side * count * step * along[name] for name, part in model.items()}
            )
            for side in (1.0, -1.0)
        )
        found = found + weight * (ahead - behind) / step
    return found
