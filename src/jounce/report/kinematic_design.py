"""Page of a kinematic design: targets met, then curves and the animated rig before and after."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.display import DisplayUnit, display_unit
from jounce.core.old_names import old_argument
from jounce.kc.laboratory import kc_test
from jounce.kc.overview import usual_unit
from jounce.kc.tests import TESTS
from jounce.kinematics import sweep_travel
from jounce.parts import Corner
from jounce.parts.rig import unit_of
from jounce.plots.display import number
from jounce.plots.kinematic_design import design_pictures
from jounce.report.chart import Chart, Panel, Series, Style
from jounce.report.page import (
    Block,
    Bullets,
    Cell,
    Fact,
    Facts,
    Page,
    PageTable,
    Picture,
    Section,
    Subsection,
    findings_blocks,
)
from jounce.report.recordings import curve_blocks

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.figure import Figure

    from jounce.design.kinematics import KinematicDesign, TargetResult
    from jounce.design.spread import KinematicSpread
    from jounce.design.studied import StudiedDesign
    from jounce.parts import DependentAxle

_POINTS = 41
_FINE = 1e-6  # of a tolerance: below this, a value is rounding error
_SMALLEST = 0.02  # minimum travel shown, m
_PANELS = 6  # curves of K&C tests at most


@old_argument("found", "design")
def kinematic_design_page(
    design: KinematicDesign, *, title: str, pictures: Mapping[str, Figure] | None = None
) -> Page:
    """Create a page of a kinematic design.

    Parameters
    ----------
    design : KinematicDesign
        Result of :func:`jounce.design_kinematics`.
    title : str
        Name of the study.

    pictures : mapping of str to Figure, optional
        Result of :func:`jounce.plots.kinematic_design.design_pictures`, if already drawn.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS` or :func:`jounce.report.write_page`.
    """
    met = sum(target.met for target in design.targets)
    good = sum(start.met for start in design.starts)
    facts = Facts(
        (
            Fact(
                "Targets met",
                f"{met} of {len(design.targets)}",
                "within their tolerances",
                "good" if design.met else "bad",
            ),
            Fact(
                "Searches that met all",
                f"{good} of {len(design.starts)}",
                f"{design.evaluations} designs computed",
            ),
            Fact(
                "Numbers moved",
                str(sum(change.before != change.after for change in design.moved.values())),
                f"of {len(design.moved)} free or tied",
            ),
        )
    )
    answer: list[Block] = [facts, _targets(design)]
    if design.fights:
        answer.append(Bullets(tuple(_fight(design, fight) for fight in design.fighting())))
    answer += findings_blocks(design.findings)
    millimetre = f"1 {display_unit('m').name}"
    words = {
        "targets": "Target curves with their bands before and after; single values as deviations in tolerances.",
        "sensitivity": f"Shift of each target, in tolerances, for {millimetre} of the most influential coordinates.",
        "tradeoffs": "Response of all targets to a shift of one by a tolerance: 1 is independent, less is coupled.",
        "spread": "Effect of part tolerances on every target: range of 95 % of the cars, as built and adjusted.",
        "geometry": "Instant centres, roll centre and steering axis of the rig before and after.",
    }
    drawn = {
        name: Picture(picture, name, words[name.partition("-")[0]], words[name.partition("-")[0]])
        for name, picture in (pictures or design_pictures(design)).items()
    }
    geometry = [drawn[name] for name in drawn if name.startswith("geometry")]
    sections = [
        Section("Answer", tuple(answer)),
        Section("Targets", (drawn["targets"],)),
        Section("Curves", lambda: _curves(design, title)),
        *([Section("Geometry", tuple(geometry))] if geometry else []),  # dependent axles have none
        Section("Moved", (_changes(design), _directions(design))),
        Section("Sensitivity", (drawn["sensitivity"],)),
    ]
    if "tradeoffs" in drawn:
        sections.append(Section("Trade-offs", (drawn["tradeoffs"],)))
    if design.spread:
        blocks: list[Block] = []
        for name, spread in design.spread.items():
            own: list[Block] = [
                _spread(name, spread),
                drawn[f"spread-{name}" if name else "spread"],
            ]
            own += findings_blocks(spread.findings)
            blocks += [Subsection(name.capitalize(), tuple(own))] if name else own
        sections.append(Section("Tolerances", tuple(blocks)))
    return Page(title, tuple(sections), "Hardpoints from kinematic targets")


def studied_design_page(studied: StudiedDesign, *, title: str) -> Page:
    """Create a page of the design of a study file, as :func:`kinematic_design_page` does."""
    return kinematic_design_page(studied.design, title=title)


def _fight(design: KinematicDesign, fight: Any) -> str:
    missed, other = (design.targets[i].label for i in (fight.missed, fight.other))
    return f"{missed} conflicts with {other}: improving one worsens the other ({number(fight.cosine, 2)})."


def _unit_of_target(target: TargetResult) -> DisplayUnit:
    """Return the unit of a target's values: of a row of a K&C sheet, that in which laboratories write it."""
    if not target.test:
        return display_unit(target.unit, float(np.max(np.abs(target.after))))
    over = TESTS[target.along].unit
    own = over if target.unit == "1" else target.unit
    return usual_unit(own.removesuffix(f"/{over}").removesuffix(f"/({over})"), over)


def _targets(design: KinematicDesign) -> PageTable:
    rows: list[tuple[Cell | str, ...]] = []
    for target in design.targets:
        unit = _unit_of_target(target)
        rows.append(
            (
                _name(target) + (", must hold" if target.must else ""),
                unit.name or "–",
                *(
                    _target_value(value, target, unit.factor)
                    for value in (target.before, target.after)
                ),
                _target_range(target, unit.factor),
                f"± {number(target.tolerance * unit.factor, 2)}",
                Cell("met", "good") if target.met else Cell("missed", "bad"),
            )
        )
    header = ("target", "unit", "before", "after", "wanted", "tolerance", "")
    note = "Curves are given by minimum and maximum; with a target for each pose, by the largest deviation."
    return PageTable("Targets", header, tuple(rows), "llrrrrl", note)


def _name(target: TargetResult) -> str:
    """Return the name of a target, with its pose if that is not the design position."""
    if target.has_curve:
        return f"{target.label}, farthest from its curve"
    return (
        f"{target.label} at {target.pose(0)}"
        if len(target.at) == 1 and target.at[0]
        else target.label
    )


def _target_value(value: float | list[float], target: TargetResult, factor: float) -> str:
    """Format a value, the range of a curve, or the largest deviation from a target curve and its pose."""
    if not target.has_curve:
        return _span(value, factor, _FINE * target.tolerance)
    k, off = target.worst(value)
    return f"{_span(off, factor, _FINE * target.tolerance)} at {target.pose(k)}"


def _span(value: float | list[float], factor: float, least: float = 0.0) -> str:
    """Format a value, or the range of a curve; magnitudes below ``least`` count as zero."""
    ends = [value, value] if isinstance(value, float) else [min(value), max(value)]
    return " to ".join(
        dict.fromkeys(number(0.0 if abs(end) < least else end * factor) for end in ends)
    )


def _target_range(target: TargetResult, factor: float) -> str:
    if target.limits:
        low, high = (None if end is None else number(end * factor) for end in target.wanted)
        if low is None:
            return f"at most {high}"
        return f"at least {low}" if high is None else f"{low} to {high}"
    return "0 from it" if target.has_curve else _span(target.wanted, factor)


def _changes(design: KinematicDesign) -> PageTable:
    rows = []
    for path, change in design.moved.items():
        unit = display_unit(_unit_of(design, path), 0.1)
        ends = (change.before, change.after, change.after - change.before)
        rows.append(
            (
                path,
                unit.name or "–",
                *(f"{value * unit.factor:.3f}".replace("-", "−") for value in ends),
            )
        )
    return PageTable(
        "Numbers of the rig", ("number", "unit", "before", "after", "by"), tuple(rows), "llrrr"
    )


def _unit_of(design: KinematicDesign, path: str) -> str:
    name, _, own = path.partition(".")
    return (
        unit_of(design.rigs[name], own) if name in design.rigs else unit_of(design.rigs[""], path)
    )


def _directions(design: KinematicDesign) -> PageTable:
    rows = []
    for direction in design.identified:
        unit = display_unit(direction.unit, 0.1)
        ends = (
            "–" if end is None else number(end * unit.factor, 2)
            for end in (direction.alone, direction.together)
        )
        rows.append((direction.number, unit.name or direction.unit, *ends))
    note = (
        "Standard deviation of each parameter if the curves are known to their tolerances: alone with all others "
        "known, and together with all others. A dash: the curves do not determine it."
    )
    return PageTable(
        "Parameters determined by the curves",
        ("number", "unit", "alone", "together"),
        tuple(rows),
        "llrr",
        note,
    )


def _spread(name: str, spread: KinematicSpread) -> PageTable:
    unit = display_unit("m")
    adjusted = number(100.0 * spread.met_adjusted, 3) if spread.adjustments else "–"
    rows = [
        ("all targets are met by", "%", number(100.0 * spread.met, 3), adjusted),
        *(
            (
                f"{adjustment.replace('_', ' ')} needs",
                unit.name,
                number(need.low * unit.factor, 3),
                number(need.high * unit.factor, 3),
            )
            for adjustment, need in spread.adjustments.items()
        ),
    ]
    head = f"{spread.cars} cars of {name}" if name else f"{spread.cars} cars"
    note = "Fractions of the cars as built and adjusted; for an adjustment, the range that 95 % of the cars need."
    return PageTable(
        head, ("", "unit", "as built, or from", "adjusted, or to"), tuple(rows), "llrr", note
    )


def _curves(design: KinematicDesign, title: str) -> tuple[Block, ...]:
    """Return sweeps of the final and initial rigs over the ranges of the targets."""
    blocks: list[Block] = []
    for name, start in design.before().items():
        rig = design.rigs[name]
        mine = [target for target in design.targets if target.rig == name]
        blocks += _sheet_curves(name, start, rig, mine)
        if not (isinstance(rig, Corner) and isinstance(start, Corner)):
            continue
        at = [place for target in mine if target.along == "travel" for place in target.at]
        ends = (min([*at, -_SMALLEST]), max([*at, _SMALLEST]))
        swept = {
            label: sweep_travel(shown_rig, np.linspace(*ends, _POINTS))
            for label, shown_rig in (("after", rig), ("before", start))
        }
        held = set.intersection(*(set(map(str, sweep.data_vars)) for sweep in swept.values()))
        first = [
            quantity
            for quantity in dict.fromkeys(target.quantity for target in mine)
            if quantity in held
        ][:4]
        label = f"{name} over travel".strip()
        shown = f"{title}, {name}" if name else title
        file = f"curves-{name}" if name else "curves"
        curves = curve_blocks({label: swept}, first or None, title=shown, name=file, rig=rig)
        blocks += [Subsection(name.capitalize(), curves)] if name else curves
    return tuple(blocks)


def _sheet_curves(
    name: str,
    before: Corner | DependentAxle,
    after: Corner | DependentAxle,
    targets: Sequence[TargetResult],
) -> list[Block]:
    """Return the curves of K&C tests that have targets, before and after, over the ranges of their lines."""
    panels: list[Panel] = []
    mine = [target for target in targets if target.test][:_PANELS]
    for target in mine:
        unit = display_unit(TESTS[target.along].unit)
        to = max(TESTS[target.along].range, *map(abs, target.at))
        series = []
        for role, rig in (("before", before), ("after", after)):
            run = kc_test(rig, target.along, to=to)
            values, x = run[target.quantity], run["input"].values
            own = display_unit(str(values.attrs["units"]))
            style: Style = "line" if role == "after" else "dashed"
            label = role if not panels else ""
            series.append(Series(x * unit.factor, values.values * own.factor, role, style, label))
        panels.append(
            Panel(
                tuple(series),
                unit.label(f"input of {target.along}"),
                title=f"{target.quantity.replace('.', ', ').replace('_', ' ')} [{own.name}]",
                width=300,
                height=226,
            )
        )
    if not panels:
        return []
    words = "Curves of the K&C tests with targets, before (dashed) and after (solid)."
    file = f"kc-{name}" if name else "kc"
    return [Chart(tuple(panels), file, words, words, columns=3)]
