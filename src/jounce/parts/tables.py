"""Tables of force over travel or velocity: their checks, and the straight lines through their points."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from jounce.core.phrases import Phrase
from jounce.core.types import Array


def check_table(name: str, x: tuple[float, ...], force: tuple[float, ...]) -> None:
    """Refuse tables of unequal length or with points that do not ascend."""
    if len(x) != len(force):
        raise ValueError(
            Phrase(
                "{name} has {count} points and force has {second_count}; give as many of both",
                name=name,
                count=len(x),
                second_count=len(force),
            )
        )
    check_ascending(name, x)


def check_ascending(name: str, values: tuple[float, ...]) -> None:
    """Refuse points that do not ascend."""
    for i, (a, b) in enumerate(pairwise(values)):
        if b <= a:
            raise ValueError(
                Phrase(
                    "{name}[{i}] = {b:g} does not lie above {name}[{second_i}] = {a:g}; sort the points",
                    name=name,
                    i=i + 1,
                    b=b,
                    second_i=i,
                    a=a,
                )
            )


def on_lines(points: Sequence[float] | Array, forces: Sequence[float] | Array, x: Any) -> Array:
    """Value at ``x`` of straight lines through points and beyond them; a complex ``x`` lies where its real part does.

    >>> on_lines((0.0, 1.0), (0.0, 10.0), np.array([0.5, 2.0])).tolist()
    [5.0, 20.0]
    """
    at, force = np.asarray(points), np.asarray(forces)
    i = np.clip(np.searchsorted(at, np.real(x)) - 1, 0, len(at) - 2)
    return np.asarray(force[i] + (force[i + 1] - force[i]) * (x - at[i]) / (at[i + 1] - at[i]))
