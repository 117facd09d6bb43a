"""Designs as text: what ``print(result)`` shows."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.core.text import aligned

if TYPE_CHECKING:
    from jounce.design.first_designs import SpringDesign
    from jounce.design.optimise import Optimisation
    from jounce.design.pareto import ParetoFront


def springs_text(design: SpringDesign) -> str:
    """Springs and dampers as they are and as wanted, SI."""
    rows = [["", "", "kg", "Hz", "damping ratio", "N/m", "N*s/m"]]
    for wheel in design.wheels:
        for name, found in (("as it is", wheel.present), ("wanted", wheel.wanted)):
            numbers = (found.frequency_hz, found.damping_ratio, found.spring_rate, found.damping_coefficient)
            rows.append([wheel.place or "wheel", name, *(f"{value:.5g}" for value in (wheel.sprung_mass, *numbers))])
    return "\n".join([*aligned(rows), *map(str, design.findings)])


def optimisation_text(found: Optimisation) -> str:
    """Free numbers, metrics and limits before and after, SI."""
    rows = [["", "start", "best", "unit", ""]]
    for item in found.numbers:
        at = f"at its {item.at} bound" if item.at else ""
        rows.append([item.path, f"{item.start:.5g}", f"{item.value:.5g}", item.unit, at])
    for name in found.objective:
        change = f"{100.0 * (found.after[name] / found.before[name] - 1.0):+.1f} %"
        rows.append([name, f"{found.before[name]:.5g}", f"{found.after[name]:.5g}", "", change])
    for limit in found.constraints:
        held = "at its limit" if limit.is_active else ""
        words = limit.channel if limit.channel.endswith(limit.name) else f"{limit.name}, {limit.channel}"
        rows.append([words, f"{limit.start:.5g}", f"{limit.value:.5g}", limit.unit, held])
    end = "converged" if found.converged else "did not converge"
    head = f"Best design on {found.driven}: {end}, {found.evaluations} designs"
    return "\n".join([head, *(line.rstrip() for line in aligned(rows)), *map(str, found.findings)])


def front_text(front: ParetoFront) -> str:
    """Designs from comfort to road holding, and what stands beside them, SI."""
    roles = ("comfort", "holding", "travel")
    rows = [["", *(f"{front.metrics[role]} [{front.units[role]}]" for role in roles), *front.numbers]]
    columns = [front.comfort, front.holding, front.travel, *front.numbers.values()]
    rows += [[str(i + 1), *(f"{column[i]:.5g}" for column in columns)] for i in range(len(front.comfort))]
    beside = [
        f"{mark.name} ({mark.kind}): {mark.comfort:.5g}, {mark.holding:.5g}, {mark.travel:.5g}" for mark in front.marks
    ]
    return "\n".join(
        [f"From comfort to road holding on {front.driven}", *aligned(rows), *beside, *map(str, front.findings)]
    )
