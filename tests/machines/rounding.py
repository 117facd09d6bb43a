"""Another library's rounding, as ``--rounding-noise SEED`` plays it.

Results of linear algebra, and of functions that an optimiser is handed, move by up to three units in the last place.
By how much depends on the number and the seed alone. So equal inputs give equal results, and conjugates and symmetric
matrices stay what they are, as with a real library.
"""

from __future__ import annotations

import functools
import importlib
import sys
from collections.abc import Callable
from typing import Any

import numpy as np

MOST = 3  # units in the last place
_NO_SUMS = {
    "block_diag",
    "cross",
    "diagonal",
    "matrix_transpose",
    "outer",
}  # every library gives the same


def install(seed: int) -> None:
    """Put noise on linear algebra and optimisers, also where a module has imported a function by name."""
    moving: dict[int, tuple[Callable[..., Any], Callable[..., Any]]] = {}
    for name, wrap in (
        ("numpy.linalg", noisy),
        ("scipy.linalg", noisy),
        ("scipy.optimize", _handed_on),
    ):
        for function in _functions(importlib.import_module(name)):
            moving[id(function)] = function, wrap(function, seed)
    for module in list(sys.modules.values()):
        for name, value in list(getattr(module, "__dict__", {}).items()):
            if id(value) in moving:
                setattr(module, name, moving[id(value)][1])


def moved(value: Any, seed: int) -> Any:
    """Move numbers in double precision, also within tuples and lists; give everything else as it is."""
    if isinstance(value, tuple | list):
        parts = [moved(part, seed) for part in value]
        return type(value)(*parts) if hasattr(value, "_fields") else type(value)(parts)
    if not isinstance(value, float | complex | np.ndarray) or np.asarray(value).dtype not in (
        float,
        complex,
    ):
        return value
    order = "F" if np.asarray(value).flags.fnc else "C"
    numbers = np.array(value, order=order)
    flat = numbers.ravel(order).view(float)
    mixed = (np.abs(flat).view(np.uint64) + np.uint64(seed)) * np.uint64(0x9E3779B97F4A7C15)
    steps = ((mixed >> np.uint64(32)) % np.uint64(2 * MOST + 1)).astype(float) - MOST
    sound = np.isfinite(flat) & (flat != 0.0)
    flat[sound] += steps[sound] * np.spacing(flat[sound])
    found = flat.view(numbers.dtype).reshape(numbers.shape, order=order)
    return found if isinstance(value, np.ndarray) else found[()]


def noisy(function: Callable[..., Any], seed: int) -> Callable[..., Any]:
    """Wrap a function whose results shall move."""

    @functools.wraps(function)
    def call(*arguments: Any, **options: Any) -> Any:
        return moved(function(*arguments, **options), seed)

    return call


def _handed_on(function: Callable[..., Any], seed: int) -> Callable[..., Any]:
    """Wrap an optimiser: results of the functions that it is handed move, those of constraints included."""

    def wrapped(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: wrapped(part) for key, part in value.items()}
        if isinstance(value, tuple | list) and any(isinstance(part, dict) for part in value):
            return [wrapped(part) for part in value]
        return noisy(value, seed) if callable(value) and not isinstance(value, type) else value

    @functools.wraps(function)
    def call(*arguments: Any, **options: Any) -> Any:
        return function(*map(wrapped, arguments), **wrapped(options))

    return call


def _functions(module: Any) -> list[Callable[..., Any]]:
    found = [getattr(module, name) for name in module.__all__ if name not in _NO_SUMS]
    return [
        one
        for one in found
        if callable(one)
        and not isinstance(one, type)
        and "special_matrices" not in one.__module__
        and not one.__name__.startswith(("get_", "find_"))
    ]
