"""Page of adjustments: wheel alignment before and after, effect of each setting, and quantities over travel."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from jounce.core.display import display_unit
from jounce.design.adjustments import OVER_TRAVEL, QUANTITIES
from jounce.kinematics.adjustments import write_setting
from jounce.plots.display import number, settle_number
from jounce.report.page import Block, Fact, Facts, Page, PageTable, answer_page, findings_blocks

if TYPE_CHECKING:
    from jounce.design.adjustment import Adjustment
    from jounce.design.adjustments import AdjustReport, WheelState

_NOTHING = 1e-6
"""Changes per mm, degree or N below which a value is rounding error."""


def adjustment_page(adjustment: Adjustment, *, title: str) -> Page:
    """Create a page of the effect of adjustments on a rig."""
    report, is_changed = adjustment.report, bool(adjustment.report.settings)
    states = (
        {"before": report.before, "after": report.after}
        if is_changed
        else {"present": report.before}
    )
    answer: list[Block] = [_states(states)]
    if not is_changed:
        answer.append(_effects(report))
    answer.append(_over_travel(report, is_changed=is_changed))
    if adjustment.lengths is not None:
        camber, toe = (
            write_setting(angle, "rad")
            for angle in (adjustment.lengths.camber, adjustment.lengths.toe)
        )
        reached = f"camber {camber}, toe {toe}"
        answer.append(Facts((Fact("reached", reached),)))
    answer += findings_blocks(adjustment.findings)
    return answer_page(title, answer)


def _states(states: dict[str, WheelState]) -> PageTable:
    rows = []
    for name, si in QUANTITIES.items():
        unit = display_unit(si)
        values = (getattr(state, name) for state in states.values())
        rows.append(
            (
                name.replace("_", " "),
                unit.name or "–",
                *(settle_number(value, si, unit) for value in values),
            )
        )
    return PageTable(
        "The wheel", ("quantity", "unit", *states), tuple(rows), "ll" + "r" * len(states)
    )


def _effects(report: AdjustReport) -> PageTable:
    """Return a table of the effect of each setting at the limits of its range, and per mm, degree or N."""
    units = {name: display_unit(si) for name, si in QUANTITIES.items()}
    rows: list[tuple[str, ...]] = []
    for effect in report.effects:
        own = display_unit(effect.unit)
        rows.append((effect.setting, *([""] * len(units))))
        for value, state in (
            (effect.lowest, effect.at_lowest),
            (effect.highest, effect.at_highest),
        ):
            cells = (
                settle_number(getattr(state, name, None), QUANTITIES[name], unit)
                for name, unit in units.items()
            )
            rows.append((f"    {value * own.factor:.4g} {own.name}", *cells))
        slopes = (
            _slope(effect.per_unit[name], unit.factor / own.factor) for name, unit in units.items()
        )
        rows.append((f"    per {own.name}", *slopes))
    header = ("setting", *(unit.label(name.replace("_", " ")) for name, unit in units.items()))
    caption = "Effect of each setting: at both ends of its range, and per unit"
    return PageTable(caption, header, tuple(rows), "l" + "r" * len(units))


def _slope(value: float | None, factor: float) -> str:
    """Format a change per unit, with values at rounding level as zero."""
    shown_value = None if value is None else value * factor
    return number(0.0 if shown_value is not None and abs(shown_value) < _NOTHING else shown_value)


def _over_travel(report: AdjustReport, *, is_changed: bool) -> PageTable:
    """Return a table of quantities over travel, each before and after."""
    quantities, along = report.over_travel, display_unit("m")
    when = ("before", "after") if is_changed else ("",)
    rows = tuple(row for name in quantities.before for row in _rows(report, name, when))
    places = (f"{travel * along.factor:.4g} {along.name}" for travel in quantities.travel)
    caption = "Over wheel travel, bump positive"
    return PageTable(
        caption, ("quantity", "unit", "", *places), rows, "lll" + "r" * len(quantities.travel)
    )


def _rows(report: AdjustReport, name: str, when: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    si = OVER_TRAVEL[name]
    unit = display_unit(si)
    for label, values in zip(
        when, (report.over_travel.before, report.over_travel.after), strict=False
    ):
        words = ("", "") if label == "after" else (name.replace("_", " "), unit.name or "–")
        yield (*words, label, *(settle_number(value, si, unit) for value in values[name]))
