"""Tables of ``jounce design``."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from jounce.cli.tables import show_findings, show_written, table

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.design.first_designs import SpringDesign
    from jounce.design.optimise import Optimisation
    from jounce.design.pareto import ParetoFront


def draw_springs(console: Console, plain: dict[str, Any], design: SpringDesign) -> None:
    """Print springs and dampers as they are and as wanted."""
    header = (
        "wheel", "", "sprung mass kg", "frequency Hz", "damping ratio", "spring rate N/m", "damping N*s/m", "sag mm",
    )  # fmt: skip
    rows = []
    for wheel in design.wheels:
        for name, found in (("as it is", wheel.present), ("wanted", wheel.wanted)):
            numbers = found.frequency_hz, found.damping_ratio, found.spring_rate, found.damping_coefficient
            rows.append((wheel.place or "wheel", name, wheel.sprung_mass, *numbers, 1e3 * found.static_deflection))
    tyre = "spring and tyre in series" if design.with_tyre else "the tyre rigid"
    console.print(table(f"Springs and dampers of {plain['rig']}, {tyre}", header, rows, text=(0, 1)))
    show_findings(console, design.findings)
    show_written(console, plain)


def draw_optimisation(console: Console, plain: dict[str, Any], found: Optimisation) -> None:
    """Print numbers, objective and limits of the best design."""
    rows: list[tuple[object, ...]] = []
    for item in found.numbers:
        flat = None if item.flat is None else f"{item.flat[0]:.5g} … {item.flat[1]:.5g}"
        rows.append((item.path, item.unit, item.start, item.value, item.lower, item.upper, flat))
    header = ("number", "unit", "start", "best", "lower bound", "upper bound", "objective within 1 %")
    console.print(table(f"Best numbers of {plain['rig']}: {found.driven}", header, rows, text=(0, 1, 6)))
    changed = [
        (name, found.before[name], found.after[name], 100.0 * (found.after[name] / found.before[name] - 1.0))
        for name in found.objective
    ]
    console.print(table("Objective (SI)", ("metric", "start", "best", "change %"), changed))
    if found.constraints:
        limits = []
        for one in found.constraints:
            bounds = one.lower, one.upper, one.is_active, one.gain
            limits.append((one.name, one.channel, one.unit, one.start, one.value, *bounds))
        columns = ("limit", "channel", "unit", "start", "best", "at least", "at most", "holds it back", "gain")
        console.print(table("Limits; gain: objective % for 1 % of the limit", columns, limits, text=(0, 1, 2)))
    slopes = "exact slopes" if found.derivatives == "exact" else "slopes by differences"
    end = "converged" if found.converged else "did not converge"
    console.print(f"{end} after {found.iterations} steps, {found.evaluations} designs, {slopes}")
    show_findings(console, found.findings)
    show_written(console, plain)


def draw_front(console: Console, plain: dict[str, Any], front: ParetoFront) -> None:
    """Print the designs of a front and what stands beside it."""
    roles = ("comfort", "holding", "travel")
    units = ["–" if front.units[role] == "1" else front.units[role] for role in roles]
    names = [f"{front.metrics[role]} [{unit}]" for role, unit in zip(roles, units, strict=True)]
    numbers = [f"{path} [{front.number_units[path]}]" for path in front.numbers]
    columns = [front.comfort, front.holding, front.travel, *front.numbers.values()]
    rows = [(str(i + 1), *(float(column[i]) for column in columns)) for i in range(len(front.comfort))]
    title = f"From comfort to road holding: {plain['rig']}, {front.driven}"
    console.print(table(title, ("", *names, *numbers), rows))
    marks = []
    for mark in front.marks:
        dampers = ", ".join(f"{path} = {value:.5g}" for path, value in mark.values.items())
        marks.append((mark.name, mark.kind, mark.comfort, mark.holding, mark.travel, dampers))
    console.print(table("Beside them (SI)", ("design", "by", *names, "dampers"), marks, text=(0, 1, 5)))
    show_findings(console, front.findings)
    show_written(console, plain)
