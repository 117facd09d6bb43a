"""Parallel coordinates, as pictures of designs and of variants have them: upright axes, each between its own ends."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from jounce.plots.display import number
from jounce.plots.figures import INK, limits

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from jounce.core.types import Array

_NOTHING = 1e-5  # of the largest value: what no picture tells from nothing

Ends = tuple[str, str]
"""The least and the greatest value of an upright axis, as they are written."""


def between_ends(values: Array) -> tuple[Array, Ends]:
    """Shares of the way from the least to the greatest of values (n,); the middle where both are written alike.

    A difference that the ends do not show is not drawn over the whole height either.

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
    """Draw the upright axes at 0, 1, 2, ... with their ends; a line of data goes from 0 to 1 on each."""
    for k, (least, greatest) in enumerate(ends):
        axes.plot([k, k], [0.0, 1.0], color=INK, linewidth=0.7, zorder=1.0)
        for place, text, align in ((-0.02, least, "top"), (1.02, greatest, "bottom")):
            axes.annotate(text, (k, place), ha="center", va=align, fontsize=7.5)
    limits(axes, -0.3, len(ends) - 0.7)
    axes.set_ylim(-0.12, 1.12)
    axes.set_yticks([])
    axes.grid(visible=False)
    axes.spines["left"].set_visible(False)
