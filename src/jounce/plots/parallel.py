"""Parallel coordinates for figures of designs and variants: vertical axes, each with its own limits."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from jounce.plots.display import number
from jounce.plots.figures import INK, limits

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from jounce.core.types import Array

_NOTHING = 1e-5  # of the largest value: invisible in a figure

Ends = tuple[str, str]
"""Minimum and maximum of a vertical axis, as displayed."""


def between_ends(values: Array) -> tuple[Array, Ends]:
    """Scale values (n,) from 0 at their minimum to 1 at their maximum; 0.5 if both are displayed alike.

    A difference too small for the displayed limits is therefore not drawn over the full height.

    >>> between_ends(np.array([1.0, 2.0, 5.0]))[0].tolist()
    [0.0, 0.25, 1.0]
    >>> between_ends(np.array([-15.0, -15.0 + 1e-9]))[0].tolist()
    [0.5, 0.5]
    """
    values = np.where(
        np.abs(values) < _NOTHING * np.nanmax(np.abs(values), initial=0.0), 0.0, values
    )
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    least, greatest = map(number, (low, high))
    shares = (values - low) / (high - low) if least != greatest else np.full(len(values), 0.5)
    return shares, (least, greatest)


def draw_uprights(axes: Axes, ends: Sequence[Ends]) -> None:
    """Draw the vertical axes at 0, 1, 2, ... with their limits; data lines range from 0 to 1 on each."""
    for k, (least, greatest) in enumerate(ends):
        axes.plot([k, k], [0.0, 1.0], color=INK, linewidth=0.7, zorder=1.0)
        for place, text, align in ((-0.02, least, "top"), (1.02, greatest, "bottom")):
            axes.annotate(text, (k, place), ha="center", va=align, fontsize=7.5)
    limits(axes, -0.3, len(ends) - 0.7)
    axes.set_ylim(-0.12, 1.12)
    axes.set_yticks([])
    axes.grid(visible=False)
    axes.spines["left"].set_visible(False)
