"""Pages of optimised designs: the best design, or a Pareto front, with gains and costs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.core.display import display_unit
from jounce.core.old_names import old_argument
from jounce.plots.display import number, percent, quantity, raise_exponents
from jounce.report.page import (
    Block,
    Cell,
    Fact,
    Facts,
    Page,
    PageTable,
    Section,
    TableColumn,
    Tone,
    answer_page,
    findings_blocks,
    picture_of,
    table_of,
)

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from jounce.core.types import Array
    from jounce.design.best_design import BestDesign
    from jounce.design.goal_front import DesignFront
    from jounce.design.optimise import DesignConstraint, DesignNumber, Optimisation
    from jounce.design.pareto import ParetoFront, ParetoMark
    from jounce.design.springs import SpringDesign


@old_argument("found", "optimum")
def optimisation_page(optimum: Optimisation, *, title: str) -> Page:
    """Create a page of the best design of a search: improvement, design variables, and active limits.

    Parameters
    ----------
    optimum : Optimisation
        Result of :func:`jounce.optimise`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.

    Examples
    --------
    >>> import jounce as jn
    >>> rig, free = jn.load("audi-a6-quarter-car"), {"strut.damper.coefficient": (500, 5000)}
    >>> found = jn.optimise(rig, free, {"sprung.az": 1.0}, road="C", speed=20.0, band="iso")
    >>> [section.title for section in optimisation_page(found, title="A kart").sections]
    ['Answer', 'Metrics']
    """
    facts = [
        Fact(name, _change(optimum, name), f"from {_ends(optimum, name)}")
        for name in optimum.objective
    ]
    end, tone = _search_outcome("converged", "did not converge", optimum.converged)
    slopes = "exact gradients" if optimum.derivatives == "exact" else "finite-difference gradients"
    facts.append(
        Fact(
            "search",
            end,
            f"{optimum.iterations} steps, {optimum.evaluations} designs, {slopes}",
            tone,
        )
    )
    answer: list[Block] = [Facts(tuple(facts)), _numbers(optimum.numbers)]
    if optimum.constraints:
        answer.append(_limits(optimum.constraints))
    answer += findings_blocks(optimum.findings)
    names = dict.fromkeys((*optimum.objective, *optimum.before))
    rows = []
    for name in names:
        unit = display_unit(
            optimum.units[name], max(abs(optimum.before[name]), abs(optimum.after[name]))
        )
        ends = (
            number(value * unit.factor) for value in (optimum.before[name], optimum.after[name])
        )
        rows.append((name, unit.name or "–", *ends, _change(optimum, name)))
    words = "Objective, limits and design variables, from the start to the best design."
    metrics = (
        picture_of(optimum, "optimisation", words),
        PageTable("Metrics", ("metric", "unit", "start", "best", "change"), tuple(rows), "llrrr"),
    )
    return Page(
        title,
        (Section("Answer", tuple(answer)), Section("Metrics", metrics)),
        f"Best design on {raise_exponents(optimum.driven)}",
    )


def best_design_page(best: BestDesign, *, title: str) -> Page:
    """Create a page of the result of a design search: a single design, or a front."""
    pages: dict[str, Callable[..., Page]] = {
        "Optimisation": optimisation_page,
        "ParetoFront": front_page,
        "DesignFront": design_front_page,
    }
    return pages[type(best.outcome).__name__](best.outcome, title=title)


def _search_outcome(well: str, badly: str, is_well: bool) -> tuple[str, Tone]:
    """Return the text for the outcome of a search, with its tone."""
    if is_well:
        return well, "good"
    return badly, "bad"


def _ends(optimum: Optimisation, name: str) -> str:
    """Return a metric of the start and of the best design."""
    unit = display_unit(
        optimum.units[name], max(abs(optimum.before[name]), abs(optimum.after[name]))
    )
    return unit.behind(
        " to ".join(
            number(values[name] * unit.factor) for values in (optimum.before, optimum.after)
        )
    )


def _from_to(values: Array, si: str) -> str:
    """Format minimum and maximum of values (n,) in an SI unit, which is written once."""
    unit = display_unit(si, float(abs(values).max()))
    return unit.behind(
        " to ".join(number(float(end) * unit.factor) for end in (values.min(), values.max()))
    )


def _change(optimum: Optimisation, name: str) -> str:
    before = optimum.before[name]
    change = optimum.after[name] / before - 1.0 if before else None
    return ("+" if change and change > 0.0 else "") + percent(change)


def _numbers(numbers: Sequence[DesignNumber]) -> PageTable:
    rows = []
    for row in numbers:
        unit = display_unit(row.unit, max(abs(row.lower), abs(row.upper)))
        values = (
            number(value * unit.factor) for value in (row.start, row.value, row.lower, row.upper)
        )
        flat = " to ".join(number(end * unit.factor) for end in row.flat) if row.flat else "–"
        at = Cell(f"at its {row.at} bound", "fair") if row.at else "within"
        rows.append((row.path, unit.name or "–", *values, at, flat))
    header = (
        "number",
        "unit",
        "start",
        "best",
        "lower bound",
        "upper bound",
        "",
        "objective within 1 %",
    )
    return PageTable("Numbers of the design", header, tuple(rows), "llrrrrlr")


def _limits(limits: Sequence[DesignConstraint]) -> PageTable:
    rows = []
    for limit in limits:
        unit = display_unit(limit.unit, max(abs(limit.start), abs(limit.value)))
        ends = (None if end is None else end * unit.factor for end in (limit.lower, limit.upper))
        values = (limit.start * unit.factor, limit.value * unit.factor, *ends)
        state = Cell("holds the design", "fair") if limit.is_active else "not reached"
        rows.append(
            (
                ", ".join(dict.fromkeys((limit.name, limit.channel))),
                unit.name or "–",
                *map(number, values),
                state,
                number(limit.gain, 3),
            )
        )
    header = ("limit", "unit", "start", "best", "at least", "at most", "", "gain")
    note = "Gain: change of the objective in % where the limit is loosened by 1 %."
    return PageTable("Limits", header, tuple(rows), "llrrrrlr", note)


def front_page(front: ParetoFront, *, title: str) -> Page:
    """Create a page of a Pareto front: the present design, the front, and all designs on it.

    Parameters
    ----------
    front : ParetoFront
        Result of :func:`jounce.pareto`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    roles = front.roles
    names = {"comfort": "comfort", "holding": "road holding", "travel": "travel"}
    ends = [
        Fact(names[role], _from_to(getattr(front, role), front.units[role]), front.words[role])
        for role in roles
    ]
    state, tone = _search_outcome(
        "all designs are optimal", "some designs are not optimal", front.converged
    )
    facts = Facts((*ends, Fact("designs on the front", str(len(front.comfort)), state, tone)))
    marks = (
        TableColumn("design", [mark.name for mark in front.marks]),
        TableColumn("by", [mark.kind for mark in front.marks]),
        *(
            TableColumn(
                front.words[role],
                [getattr(mark, role) for mark in front.marks],
                front.units[role],
            )
            for role in roles
        ),
        TableColumn("dampers", [_dampers(mark, front.number_units) for mark in front.marks]),
    )
    designs = (
        TableColumn("design", [str(i + 1) for i in range(len(front.comfort))]),
        *(
            TableColumn(front.words[role], getattr(front, role).tolist(), front.units[role])
            for role in roles
        ),
        *(
            TableColumn(path, values.tolist(), front.number_units[path])
            for path, values in front.numbers.items()
        ),
    )
    words = f"Designs on the front, from {front.heading}, beside the present one; numbers along the front."
    picture = picture_of(front, "front", words)
    answer: list[Block] = [facts, picture, table_of("For comparison", marks)]
    answer += findings_blocks(front.findings)
    every = Section("Every design", (table_of(f"From {front.heading}", designs),))
    return Page(
        title,
        (Section("Answer", tuple(answer)), every),
        f"Pareto front, {front.heading}, on {raise_exponents(front.driven)}",
    )


def _dampers(mark: ParetoMark, units: Mapping[str, str]) -> str:
    """Return the dampers of a design as text."""
    texts = (
        f"{path}: {quantity(value, units.get(path, '1'))}" for path, value in mark.values.items()
    )
    return ", ".join(texts) or "–"


def springs_page(design: SpringDesign, *, title: str) -> Page:
    """Create a page of springs and dampers for a target frequency, compared with those of the rig.

    Parameters
    ----------
    design : SpringDesign
        Result of :func:`jounce.design_springs`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    rows = [
        (wheel, name, of)
        for wheel in design.wheels
        for name, of in (("present", wheel.present), ("target", wheel.wanted))
    ]
    columns = (
        TableColumn("wheel", [wheel.place or "wheel" for wheel, _, _ in rows]),
        TableColumn("", [name for _, name, _ in rows]),
        TableColumn("sprung mass", [wheel.sprung_mass for wheel, _, _ in rows], "kg"),
        TableColumn("frequency", [of.frequency_hz for _, _, of in rows], "Hz"),
        TableColumn("damping ratio", [of.damping_ratio for _, _, of in rows], "1"),
        TableColumn("spring rate", [of.spring_rate for _, _, of in rows], "N/m"),
        TableColumn("damping", [of.damping_coefficient for _, _, of in rows], "N*s/m"),
        TableColumn("sag", [of.static_deflection for _, _, of in rows], "m"),
    )
    tyre = "spring and tyre in series" if design.with_tyre else "the tyre rigid"
    blocks: list[Block] = [table_of(f"Springs and dampers, {tyre}", columns)]
    blocks += findings_blocks(design.findings)
    return answer_page(title, blocks)


def design_front_page(front: DesignFront, *, title: str) -> Page:
    """Create a page of a front of several metrics: the range of each metric, a figure, and all designs.

    Parameters
    ----------
    front : DesignFront
        Result of :func:`jounce.design_front`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    ends = [
        Fact(
            name,
            _from_to(values, front.goal_units[name]),
            f"{quantity(front.present[name], front.goal_units[name])} as it is",
        )
        for name, values in front.goals.items()
    ]
    state, tone = _search_outcome(
        "all searches converged", "some searches did not converge", front.converged
    )
    facts = Facts((*ends, Fact("designs on the front", str(front.count), state, tone)))
    columns = {**front.goals, **front.numbers}
    si = {**front.goal_units, **front.number_units}
    units = {
        name: display_unit(si[name], float(abs(values).max())) for name, values in columns.items()
    }
    present = {**front.present, **front.start}
    rows = [("as it is", *(number(present[name] * unit.factor) for name, unit in units.items()))]
    rows += [
        (
            str(i + 1),
            *(number(float(values[i]) * units[name].factor) for name, values in columns.items()),
        )
        for i in range(front.count)
    ]
    header = ("", *(unit.label(name) for name, unit in units.items()))
    first = next(iter(front.goals))
    every = PageTable(f"From the least {first} on", header, tuple(rows), "r" * len(header))
    words = "Non-dominated designs: pairs of metrics, and all of them with the numbers."
    answer: list[Block] = [facts, picture_of(front, "front", words)]
    answer += findings_blocks(front.findings)
    sections = (Section("Answer", tuple(answer)), Section("Every design", (every,)))
    return Page(title, sections, f"Best designs on {raise_exponents(front.driven)}")
