"""One vehicle over the years: what its wheels measured at each inspection."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import date
from typing import TYPE_CHECKING

from jounce.plots.style import PALETTE, legend_above, new_figure, styled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from jounce.inspection.archive.history import WheelVisit

_TITLES = {
    "adhesion": ("Adhesion [%]", 100.0),
    "phase_angle_min_deg": ("Least phase angle [°]", 1.0),
    "theta_road": ("Damping ratio on the road", 1.0),
}
_MARKS = {"left": ("o", "-"), "right": ("s", (0, (4, 1.5)))}


@styled
def vehicle_history(visits: Sequence[WheelVisit], *, height: float = 5.4) -> Figure:
    """Draw adhesion, phase angle and damping ratio of every wheel against the date.

    Parameters
    ----------
    visits : sequence of WheelVisit
        As ``jounce.inspection.archive.history.history_of`` gives them; those without a date are left out.
    height : float
        Inches.

    Returns
    -------
    matplotlib.figure.Figure
        One panel for each value (%, degrees, dimensionless), one line for each wheel.

    Examples
    --------
    >>> from jounce.inspection.archive.history import WheelVisit
    >>> visit = WheelVisit(1, "2026-11-21", "B-AB 123", "rear", "left", {"adhesion": 0.6}, "pass", "")
    >>> [axes.get_title("left") for axes in vehicle_history([visit]).axes]
    ['Adhesion [%]', 'Least phase angle [°]', 'Damping ratio on the road']
    """
    from jounce.inspection.archive.history import day_number

    dated = [(date.fromordinal(day), one) for one in visits if (day := day_number(one.date)) is not None]
    wheels = list(dict.fromkeys((one.axle, one.wheel) for _, one in dated))
    axles = list(dict.fromkeys(axle for axle, _ in wheels))
    figure = new_figure(height)
    panels = figure.subplots(len(_TITLES), 1, sharex=True)
    for axes, (name, (title, scale)) in zip(panels, _TITLES.items(), strict=True):
        for axle, wheel in wheels:
            points = [(day, one.values.get(name)) for day, one in dated if (one.axle, one.wheel) == (axle, wheel)]
            known = [(day, scale * value) for day, value in points if value is not None]
            mark, line = _MARKS.get(wheel, ("o", "-"))
            colour = PALETTE[axles.index(axle) % len(PALETTE)]
            days, values = [day for day, _ in known], [value for _, value in known]
            axes.plot(days, values, marker=mark, ls=line, color=colour, label=f"{axle} {wheel}".strip())
        axes.set_title(title)
        shown = [scale * value for _, one in dated if (value := one.values.get(name)) is not None] or [1.0]
        axes.set_ylim(1.15 * min(0.0, *shown), 1.15 * max(0.0, *shown) or 1.0)
    if wheels:
        legend_above(panels[0])
    figure.autofmt_xdate(rotation=0, ha="center")
    return figure
