"""Maps of dampers for the page: curves of all settings, and between clicks, in the units that are shown."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.types import Array

if TYPE_CHECKING:
    from jounce.dampers.map import DamperMap

_STEPS = (0.25, 0.5, 1.0, 2.0, 5.0, 10.0)
_MOST = 120
"""Steps of the slider over clicks, and the largest number of curves between clicks."""


def write_map(asked: Mapping[str, Any], folder: Path) -> dict[str, Any]:
    """Map the damper of a question; its page is written into the folder, without the figure, which the page draws."""
    from jounce.dampers.map import damper_map
    from jounce.report.dampers import damper_map_page
    from jounce.report.page import Picture
    from jounce.report.render import REPORTS

    names = ("settings", "reading", "stroke_positive", "force_positive")
    given = {name: asked[name] for name in names if asked[name]}
    made = damper_map(asked["files"], **given)
    page = damper_map_page(made, title="Damper map")
    (answer,) = page.sections
    blocks = tuple(block for block in answer.blocks if not isinstance(block, Picture))
    answer = replace(answer, source=blocks)
    REPORTS.write(replace(page, sections=(answer,)), folder / "report.html")
    return {"curves": map_curves(made), "findings": made.findings}


def map_curves(made: DamperMap) -> dict[str, Any]:
    """Return the curves of all settings and those between clicks over one axis, with their intervals.

    Forces are without gas. Where a setting is not known, its values are None.
    """
    from jounce.core.display import display_unit
    from jounce.plots.dampers import setting_words

    x = np.unique(np.concatenate([item.velocity for item in made.settings]))
    speed = display_unit("m/s", float(np.abs(x).max()))
    force = display_unit("N", max(float(np.abs(item.force).max()) for item in made.settings))

    def over(velocity: Array, values: Array) -> list[float | None]:
        shown = np.interp(x, velocity, values * force.factor, left=np.nan, right=np.nan)
        return [None if np.isnan(value) else value for value in shown.tolist()]

    def curve(item: Any) -> dict[str, Any]:
        return {name: over(item.velocity, getattr(item, name)) for name in ("force", "low", "high")}

    return {
        "velocity": (x * speed.factor).tolist(),
        "velocity_unit": speed.name,
        "force_unit": force.name,
        "settings": [{"label": setting_words(item), **curve(item)} for item in made.settings],
        "between": [{"clicks": clicks, **curve(made.at(clicks))} for clicks in _grid(made.clicks)],
    }


def _grid(clicks: tuple[float, ...]) -> list[float]:
    """Return evenly spaced clicks from the first measured ones to the last; none if no clicks are known."""
    if not clicks:
        return []
    span = clicks[-1] - clicks[0]
    step = next((step for step in _STEPS if span / step <= _MOST), span / _MOST)
    values = np.arange(clicks[0], clicks[-1] + 0.5 * step, step)
    return [float(value) for value in np.minimum(values, clicks[-1])]
