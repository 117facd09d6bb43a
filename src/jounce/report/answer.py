"""The answer of a campaign: values with their intervals, for which trials they hold, what to be careful about."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from jounce.core.display import display_unit
from jounce.core.errors import JounceError
from jounce.core.units import to_si
from jounce.identify.estimate import Estimate
from jounce.plots.display import estimate_cells, given, number
from jounce.report.characterisation import unit_at
from jounce.report.chart import Chart, Panel, Series
from jounce.report.page import Cell, PageTable

if TYPE_CHECKING:
    from jounce.campaign.result import CampaignResult
    from jounce.campaign.strategy_result import StrategyResult
    from jounce.identify.discrepancy import LawEstimate
    from jounce.identify.update import UpdatedParameter


@dataclass(frozen=True)
class Answer:
    """One parameter (SI): as in the rig file, as measured on the bench, as the last update left it, and the truth."""

    path: str
    where: str  # what it is of, e.g. a tyre pressure
    unit: str
    described: float | None
    bench: Estimate | None
    updated: UpdatedParameter | None
    carried: float | None  # value of the updated rig where it is not the one that was fitted
    law: LawEstimate | None
    truth: float | None


def decisive(result: CampaignResult) -> tuple[StrategyResult, ...]:
    """Give the updates behind the final model: the last one, and those that it builds on before it."""
    if not result.strategies:
        return ()
    known = {strategy.update.name: strategy for strategy in result.strategies}
    starts = {entry.name: entry.start_from for entry in result.campaign.update}
    chain = [result.strategies[-1]]
    while (before := starts.get(chain[0].update.name)) is not None and before in known:
        chain.insert(0, known[before])
    return tuple(chain)


def answers(result: CampaignResult) -> tuple[Answer, ...]:
    """Every parameter that was measured on the bench or updated on the way to the final model."""
    chain = decisive(result)
    fitted = {path: (strategy, p) for strategy in chain for path, p in strategy.update.parameters.items()}
    described = result.rig.parameters()
    found: list[Answer] = []
    for item in result.characterisation.replaced:
        pressure = _pressure(item.source)
        strategy, p = fitted.get(item.path, (None, None))
        own = strategy is None or pressure is None or pressure == _pressure_of(result, strategy)
        found.append(
            Answer(
                item.path,
                "" if pressure is None else given(pressure, "Pa"),
                _unit(result, item.path),
                item.described,
                _bench_estimate(result, item.measured, item.standard_error),
                p if own else None,
                None if own or not chain else _carried(chain[-1], item.path, pressure),
                _law(strategy, item.path) if own else None,
                strategy.truth.get(item.path) if own and strategy is not None else None,
            )
        )
    measured = {one.path for one in found}
    for path, (strategy, p) in fitted.items():
        if path not in measured:
            law, truth = _law(strategy, path), strategy.truth.get(path)
            found.append(Answer(path, "", _unit(result, path), described.get(path), None, p, None, law, truth))
    return tuple(found)


def _unit(result: CampaignResult, path: str) -> str:
    rigs = (*(strategy.knowledge.rig for strategy in result.strategies[::-1]), result.start, result.rig)
    return next((unit for rig in rigs if (unit := unit_at(rig, path)) != "1"), "1")


def _pressure(source: str) -> float | None:
    """Pressure (Pa) of a tyre bench by its table's name, ``bench.tyre."0.31 MPa"``."""
    if not source.startswith("bench.tyre."):
        return None
    try:
        return float(to_si(source.removeprefix("bench.tyre.").strip('"'), "Pa", where=source))
    except JounceError:
        return None


def _pressure_of(result: CampaignResult, strategy: StrategyResult) -> float | None:
    """Tyre pressure (Pa) that an update's tyre values are of: that of its first trial."""
    first = next((t.entry for t in result.trials if t.entry.number == strategy.fitted_on[0]), None)
    return None if first is None else first.tyre_pressure


def _carried(strategy: StrategyResult, path: str, pressure: float | None) -> float | None:
    try:
        return strategy.knowledge.rig_for(None, pressure, {}).parameters().get(path)
    except JounceError:
        return None


def _law(strategy: StrategyResult | None, path: str) -> LawEstimate | None:
    found = strategy.update.discrepancy if strategy is not None else None
    return None if found is None else found.parameters.get(path)


def _bench_estimate(result: CampaignResult, measured: float, error: float | None) -> Estimate:
    """Give the bench's estimate with its interval: the one whose value replaced that of the rig file."""
    for one in _estimates(result):
        if math.isclose(one.value, measured, rel_tol=1e-12):
            return one
    return Estimate(measured, error)


def _estimates(result: CampaignResult) -> Iterator[Estimate]:
    bench = result.characterisation
    for found in (bench.spring, *bench.tyre.values()):
        if found is not None:
            yield found.stiffness
            if found.tangent_stiffness is not None:
                yield found.tangent_stiffness
    yield from (choice.at_strut for choice in bench.damping_choices if choice.at_strut is not None)


def answer_table(found: tuple[Answer, ...], name: str, trials: int) -> PageTable:
    """Values in a table: described, bench, updated model, the part, truth."""
    truth = any(one.truth is not None for one in found)
    laws = any(one.law is not None for one in found)
    rows = []
    for one in found:
        unit = display_unit(one.unit, _largest(one))
        cells: list[Cell | str] = [Cell(one.path, note=one.where)]
        cells.append(number(None if one.described is None else one.described * unit.factor))
        cells.append(_cell(one.bench, one.unit))
        if one.carried is not None:
            is_measured = one.bench is not None and math.isclose(one.carried, one.bench.value, rel_tol=1e-9)
            note = "as measured" if is_measured else "scaled likewise"
            cells.append(Cell(number(one.carried * unit.factor), "muted", note))
        elif one.updated is not None and one.updated.at_bound:
            cells.append(Cell(estimate_cells(one.updated, one.unit)[0], "fair", "at its bound"))
        else:
            cells.append(_cell(one.updated, one.unit))
        if laws:
            cells.append(_cell(_law_estimate(one.law), one.unit))
        if truth:
            cells.append(number(None if one.truth is None else one.truth * unit.factor, 4))
        cells += [unit.name or "–", _word(one)]
        rows.append(tuple(cells))
    header = ["parameter", "rig file", "bench", "updated model"]
    header += ["the part, model error counted"] * laws + ["truth"] * truth + ["unit", "of the part"]
    note = "Below each value: its 95 % interval; of the updated model that of the noise only. " * bool(rows)
    if name:
        note += f"Updated: {name}, fitted on {trials} trial{'s' * (trials != 1)}. "
    if laws:
        note += "The part: value of its law over the states ridden, with an interval that counts what the model lacks. "
    if truth:
        note += "Truth: the value behind the synthetic recordings."
    return PageTable(
        "From the rig file to the updated model",
        tuple(header),
        tuple(rows),
        "l" + "r" * (3 + laws + truth) + "ll",
        note,
    )


def _largest(one: Answer) -> float:
    values = [one.described, one.truth, *(found.value for found in (one.bench, one.updated) if found is not None)]
    return max((abs(value) for value in values if value is not None), default=0.0)


def _cell(found: Estimate | UpdatedParameter | None, si: str) -> Cell | str:
    value, _, interval, _ = estimate_cells(found, si)
    return value if interval == "–" else Cell(value, note=interval)


def _law_estimate(law: LawEstimate | None) -> Estimate | None:
    return None if law is None else Estimate(law.value, 0.5 * law.half_width, law.interval)


def _word(one: Answer) -> Cell | str:
    if one.law is not None:
        return Cell("identified", "good") if one.law.identified else Cell("not identified", "fair", one.law.why)
    if one.updated is not None:
        return Cell("not said", "muted", "noise only: fewer than three trials fitted")
    return Cell("bench only", "muted") if one.bench is not None else "–"


_LONGEST_TITLE = 27
"""Bold letters above a panel of 300 pixels."""
_LANES = ("rig file", "bench", "updated model", "the part", "truth")


def answer_chart(found: tuple[Answer, ...]) -> Chart | None:
    """Draw each parameter's values below each other with their 95 % intervals; None without any two to compare."""
    panels = tuple(panel for one in found if (panel := _panel(one)) is not None)
    if not panels:
        return None
    words = "; ".join(f"{panel.title}: {', '.join(panel.lanes)}" for panel in panels)
    return Chart(
        panels,
        "answer",
        "Each value with its 95 % interval: ○ rig file, ◆ bench, ● updated model (noise only), ■ the part (model error "
        "counted), ✕ truth. Axes need not begin at zero.",
        f"Values of the parameters with their intervals; all numbers are in the table above. {words}.",
        columns=3,
    )


def _panel(one: Answer) -> Panel | None:
    unit = display_unit(one.unit, _largest(one))
    shown: list[tuple[str, float, tuple[float, float] | None, str, str]] = []
    if one.described is not None:
        shown.append((_LANES[0], one.described, None, "muted", "rings"))
    if one.bench is not None:
        shown.append((_LANES[1], one.bench.value, one.bench.interval, "before", "diamonds"))
    if one.updated is not None:
        shown.append((_LANES[2], one.updated.value, one.updated.interval, "after", "dots"))
    if one.law is not None:
        shown.append((_LANES[3], one.law.value, one.law.interval, "other-1", "squares"))
    if one.truth is not None:
        shown.append((_LANES[4], one.truth, None, "bad", "crosses"))
    if len(shown) < 2:
        return None
    series = []
    for lane, (_, value, interval, role, mark) in enumerate(shown):
        if interval is not None:
            series.append(Series([end * unit.factor for end in interval], [lane, lane], role, "thick"))
        series.append(Series([value * unit.factor], [lane], role, mark))  # type: ignore[arg-type]
    verticals = ((one.truth * unit.factor, "bad", ""),) if one.truth is not None else ()
    title = f"{one.path}, {one.where}" if one.where else one.path
    while len(title) > _LONGEST_TITLE and "." in title.partition(",")[0]:
        title = title.partition(".")[2]  # the table above has the whole path
    return Panel(
        tuple(series),
        unit.label(""),
        title=title,
        verticals=verticals,
        lanes=tuple(name for name, *_ in shown),
        width=300,
        height=72 + 22 * len(shown),
    )
