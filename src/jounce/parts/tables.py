"""Tables of force over travel or velocity: validation and linear interpolation."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from jounce.core.phrases import Phrase
from jounce.core.types import Array


def check_table(
    name: str, x: tuple[float, ...], force: tuple[float, ...], load: str = "force"
) -> None:
    """Refuse tables of unequal lengths, or whose points are not ascending; ``load`` names the second row."""
    if len(x) != len(force):
        raise ValueError(
            Phrase(
                "{name} has {count} points and {load} has {second_count}; give equal numbers of both",
                name=name,
                load=load,
                count=len(x),
                second_count=len(force),
            )
        )
    check_ascending(name, x)


def check_ascending(name: str, values: tuple[float, ...]) -> None:
    """Refuse points that are not strictly ascending."""
    for i, (a, b) in enumerate(pairwise(values)):
        if b <= a:
            raise ValueError(
                Phrase(
                    "{name}[{i}] = {b:g} is not above {name}[{second_i}] = {a:g}; sort the points",
                    name=name,
                    i=i + 1,
                    b=b,
                    second_i=i,
                    a=a,
                )
            )


def on_lines(points: Sequence[float] | Array, forces: Sequence[float] | Array, x: Any) -> Array:
    """Interpolate and extrapolate linearly at ``x``; the real part of a complex ``x`` selects the segment.

    >>> on_lines((0.0, 1.0), (0.0, 10.0), np.array([0.5, 2.0])).tolist()
    [5.0, 20.0]
    """
    at, force = np.asarray(points), np.asarray(forces)
    i = np.clip(np.searchsorted(at, np.real(x)) - 1, 0, len(at) - 2)
    return np.asarray(force[i] + (force[i + 1] - force[i]) * (x - at[i]) / (at[i + 1] - at[i]))
