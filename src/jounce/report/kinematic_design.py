"""Hardpoints found from targets as a page: which are met, then curves and the rig that moves, before and after."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.display import display_unit
from jounce.kinematics import sweep_travel
from jounce.plots.display import number
from jounce.plots.kinematic_design import sensitivity_bars, target_curves
from jounce.report.page import Block, Bullets, Cell, Fact, Facts, Findings, Page, Picture, Section, Table
from jounce.report.recordings import curve_blocks

if TYPE_CHECKING:
    import xarray as xr

    from jounce.design.kinematics import KinematicDesign, TargetResult

_POINTS = 41
_SMALLEST = 0.02  # m of travel that is shown at least


def kinematic_design_page(found: KinematicDesign, *, title: str) -> Page:
    """Put a kinematic design on a page.

    Parameters
    ----------
    found : KinematicDesign
        What :func:`jounce.design_kinematics` found.
    title : str
        Name of the study.

    Returns
    -------
    Page
        To be written with :data:`jounce.report.REPORTS` or :func:`jounce.report.write_page`.
    """
    met = sum(target.met for target in found.targets)
    good = sum(start.met for start in found.starts)
    facts = Facts(
        (
            Fact(
                "Targets met",
                f"{met} of {len(found.targets)}",
                "within their tolerances",
                "good" if found.met else "bad",
            ),
            Fact("Searches that met all", f"{good} of {len(found.starts)}", f"{found.evaluations} designs computed"),
            Fact(
                "Numbers moved",
                str(sum(one.before != one.after for one in found.moved.values())),
                f"of {len(found.moved)} free or tied",
            ),
        )
    )
    answer: list[Block] = [facts, _targets(found)]
    if found.fights:
        answer.append(Bullets(tuple(_fight(found, fight) for fight in found.fights)))
    if found.findings:
        answer.append(Findings(found.findings))
    wanted = "Every wanted curve before and after with its band; single values in tolerances from what is wanted."
    one = f"1 {display_unit('m').name}"
    matter = f"What {one} of the coordinates that matter most changes of each target, in its tolerances."
    sections = (
        Section("Answer", tuple(answer)),
        Section("Targets", (Picture(target_curves(found), "targets", wanted, wanted),)),
        Section("Curves", _curves(found, title)),
        Section("Moved", (_moved(found),)),
        Section("Sensitivity", (Picture(sensitivity_bars(found), "sensitivity", matter, matter),)),
    )
    return Page(title, sections, "Hardpoints from kinematic targets")


def _fight(found: KinematicDesign, fight: Any) -> str:
    missed, other = (found.targets[i].quantity.replace("_", " ") for i in (fight.missed, fight.other))
    return f"{missed} fights {other}: what brings one nearer takes the other away ({number(fight.cosine, 2)})."


def _targets(found: KinematicDesign) -> Table:
    rows: list[tuple[Cell | str, ...]] = []
    for target in found.targets:
        unit = display_unit(target.unit, float(np.max(np.abs(target.after))))
        rows.append(
            (
                target.quantity.replace("_", " "),
                unit.name or "–",
                *(_span(value, unit.factor) for value in (target.before, target.after)),
                _wanted(target, unit.factor),
                f"± {number(target.tolerance * unit.factor, 2)}",
                Cell("met", "good") if target.met else Cell("missed", "bad"),
            )
        )
    header = ("target", "unit", "before", "after", "wanted", "tolerance", "")
    return Table("Targets", header, tuple(rows), "llrrrrl", "Curves are given by their least and greatest value.")


def _span(value: float | list[float], factor: float) -> str:
    ends = [value, value] if isinstance(value, float) else [min(value), max(value)]
    return " to ".join(dict.fromkeys(number(end * factor) for end in ends))


def _wanted(target: TargetResult, factor: float) -> str:
    wanted = target.wanted
    if isinstance(wanted, list) and (len(wanted) != 2 or None not in wanted):
        return _span([float(one) for one in wanted], factor)
    if isinstance(wanted, list):
        low, high = wanted
        return f"at most {number(high * factor)}" if low is None else f"at least {number(low * factor)}"
    return number(float(wanted) * factor)


def _moved(found: KinematicDesign) -> Table:
    rows = []
    for path, change in found.moved.items():
        unit = display_unit("m" if path.startswith("hardpoints.") else "1", 0.1)
        ends = (change.before, change.after, change.after - change.before)
        rows.append((path, unit.name or "SI", *(f"{value * unit.factor:.3f}".replace("-", "−") for value in ends)))
    return Table("Numbers of the rig", ("number", "unit", "before", "after", "by"), tuple(rows), "llrrr")


def _curves(found: KinematicDesign, title: str) -> tuple[Block, ...]:
    """Sweeps of the rig found and of the rig that it was begun with, over what the targets are wanted over."""
    start = found.rig.with_changes({path: one.before for path, one in found.moved.items()})
    rigs = {"after": found.rig, "before": start}
    groups: dict[str, dict[str, xr.Dataset]] = {}
    at = [place for target in found.targets if target.along == "travel" for place in target.at]
    ends = (min([*at, -_SMALLEST]), max([*at, _SMALLEST]))
    groups["over travel"] = {name: sweep_travel(rig, np.linspace(*ends, _POINTS)) for name, rig in rigs.items()}
    names = dict.fromkeys(target.quantity for target in found.targets)
    held = set.intersection(*(set(map(str, sweep.data_vars)) for sweep in groups["over travel"].values()))
    first = [name for name in names if name in held][:4]
    return curve_blocks(groups, first or None, title=title, rig=found.rig)
