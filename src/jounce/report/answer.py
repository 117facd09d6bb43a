"""The answer of a campaign: values with intervals, the trials for which they hold, and warnings."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from jounce.core.display import display_unit
from jounce.core.errors import JounceError
from jounce.core.units import to_si
from jounce.identify.estimate import Estimate
from jounce.plots.display import estimate_cells, number, setting_text
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
    """One parameter (SI): value in the rig file, from the bench, after the last update, and true value."""

    path: str
    where: str  # condition to which it refers, e.g. a tyre pressure
    unit: str
    described: float | None
    bench: Estimate | None
    updated: UpdatedParameter | None
    carried: float | None  # value of the updated rig if it differs from the fitted one
    law: LawEstimate | None
    truth: float | None


def decisive(result: CampaignResult) -> tuple[StrategyResult, ...]:
    """Return the updates behind the final model: the last one and those on which it is based."""
    if not result.strategies:
        return ()
    known = {strategy.update.name: strategy for strategy in result.strategies}
    starts = {entry.name: entry.start_from for entry in result.campaign.update}
    chain = [result.strategies[-1]]
    while (before := starts.get(chain[0].update.name)) is not None and before in known:
        chain.insert(0, known[before])
    return tuple(chain)


def answers(result: CampaignResult) -> tuple[Answer, ...]:
    """Return all parameters that were measured on the bench or updated for the final model."""
    chain = decisive(result)
    fitted = {
        path: (strategy, p) for strategy in chain for path, p in strategy.update.parameters.items()
    }
    described = result.rig.parameters()
    rows: list[Answer] = []
    for item in result.characterisation.replaced:
        pressure = _pressure(item.source)
        strategy, p = fitted.get(item.path, (None, None))
        own = strategy is None or pressure is None or pressure == _pressure_of(result, strategy)
        rows.append(
            Answer(
                item.path,
                "" if pressure is None else setting_text(pressure, "Pa"),
                _unit(result, item.path),
                item.described,
                _bench_estimate(result, item.measured, item.standard_error),
                p if own else None,
                None if own or not chain else _value_at_pressure(chain[-1], item.path, pressure),
                _law(strategy, item.path) if own else None,
                strategy.truth.get(item.path) if own and strategy is not None else None,
            )
        )
    measured = {row.path for row in rows}
    for path, (strategy, p) in fitted.items():
        if path not in measured:
            law, truth = _law(strategy, path), strategy.truth.get(path)
            rows.append(
                Answer(
                    path, "", _unit(result, path), described.get(path), None, p, None, law, truth
                )
            )
    return tuple(rows)


def _unit(result: CampaignResult, path: str) -> str:
    rigs = (
        *(strategy.knowledge.rig for strategy in result.strategies[::-1]),
        result.start,
        result.rig,
    )
    return next((unit for rig in rigs if (unit := unit_at(rig, path)) != "1"), "1")


def _pressure(source: str) -> float | None:
    """Return the pressure (Pa) of a tyre bench from its table name, ``bench.tyre."0.31 MPa"``."""
    if not source.startswith("bench.tyre."):
        return None
    try:
        return float(to_si(source.removeprefix("bench.tyre.").strip('"'), "Pa", where=source))
    except JounceError:
        return None


def _pressure_of(result: CampaignResult, strategy: StrategyResult) -> float | None:
    """Return the tyre pressure (Pa) of an update's tyre values: that of its first trial."""
    first = next((t.entry for t in result.trials if t.entry.number == strategy.fitted_on[0]), None)
    return None if first is None else first.tyre_pressure


def _value_at_pressure(strategy: StrategyResult, path: str, pressure: float | None) -> float | None:
    try:
        return strategy.knowledge.rig_for(None, pressure, {}).parameters().get(path)
    except JounceError:
        return None


def _law(strategy: StrategyResult | None, path: str) -> LawEstimate | None:
    discrepancy = strategy.update.discrepancy if strategy is not None else None
    return None if discrepancy is None else discrepancy.parameters.get(path)


def _bench_estimate(result: CampaignResult, measured: float, error: float | None) -> Estimate:
    """Return the bench estimate with its interval whose value replaced that of the rig file."""
    for estimate in _estimates(result):
        if math.isclose(estimate.value, measured, rel_tol=1e-12):
            return estimate
    return Estimate(measured, error)


def _estimates(result: CampaignResult) -> Iterator[Estimate]:
    bench = result.characterisation
    for stiffness in (bench.spring, *bench.tyre.values()):
        if stiffness is not None:
            yield stiffness.stiffness
            if stiffness.tangent_stiffness is not None:
                yield stiffness.tangent_stiffness
    yield from (choice.at_strut for choice in bench.damping_choices if choice.at_strut is not None)


def answer_table(parameters: tuple[Answer, ...], name: str, trials: int) -> PageTable:
    """Return a table of values: rig file, bench, updated model, physical part, truth."""
    truth = any(row.truth is not None for row in parameters)
    laws = any(row.law is not None for row in parameters)
    rows = []
    for row in parameters:
        unit = display_unit(row.unit, _largest(row))
        cells: list[Cell | str] = [Cell(row.path, note=row.where)]
        cells.append(number(None if row.described is None else row.described * unit.factor))
        cells.append(_cell(row.bench, row.unit))
        if row.carried is not None:
            is_measured = row.bench is not None and math.isclose(
                row.carried, row.bench.value, rel_tol=1e-9
            )
            note = "as measured" if is_measured else "scaled likewise"
            cells.append(Cell(number(row.carried * unit.factor), "muted", note))
        elif row.updated is not None and row.updated.at_bound:
            cells.append(Cell(estimate_cells(row.updated, row.unit)[0], "fair", "at its bound"))
        else:
            cells.append(_cell(row.updated, row.unit))
        if laws:
            cells.append(_cell(_law_estimate(row.law), row.unit))
        if truth:
            cells.append(number(None if row.truth is None else row.truth * unit.factor, 4))
        cells += [unit.name or "–", _word(row)]
        rows.append(tuple(cells))
    header = ["parameter", "rig file", "bench", "updated model"]
    header += ["the part, with model error"] * laws + ["truth"] * truth + ["unit", "part value"]
    note = (
        "Below each value: its 95 % interval; of the updated model that of the noise only. "
        * bool(rows)
    )
    if name:
        note += f"Updated: {name}, fitted on {trials} trial{'s' * (trials != 1)}. "
    if laws:
        note += "The part: value of its law over the states ridden, with an interval that includes model error. "
    if truth:
        note += "Truth: the value behind the synthetic recordings."
    return PageTable(
        "From the rig file to the updated model",
        tuple(header),
        tuple(rows),
        "l" + "r" * (3 + laws + truth) + "ll",
        note,
    )


def _largest(row: Answer) -> float:
    values = [
        row.described,
        row.truth,
        *(estimate.value for estimate in (row.bench, row.updated) if estimate is not None),
    ]
    return max((abs(value) for value in values if value is not None), default=0.0)


def _cell(estimate: Estimate | UpdatedParameter | None, si: str) -> Cell | str:
    value, _, interval, _ = estimate_cells(estimate, si)
    return value if interval == "–" else Cell(value, note=interval)


def _law_estimate(law: LawEstimate | None) -> Estimate | None:
    return None if law is None else Estimate(law.value, 0.5 * law.half_width, law.interval)


def _word(row: Answer) -> Cell | str:
    if row.law is not None:
        return (
            Cell("identified", "good")
            if row.law.identified
            else Cell("not identified", "fair", row.law.why)
        )
    if row.updated is not None:
        return Cell("not available", "muted", "noise only: fewer than three trials fitted")
    return Cell("bench only", "muted") if row.bench is not None else "–"


_LONGEST_TITLE = 27
"""Bold characters that fit above a panel of 300 pixels."""
_LANES = ("rig file", "bench", "updated model", "the part", "truth")


def answer_chart(rows: tuple[Answer, ...]) -> Chart | None:
    """Plot each parameter's values one below another with 95 % intervals; ``None`` without two to compare."""
    panels = tuple(panel for row in rows if (panel := _panel(row)) is not None)
    if not panels:
        return None
    words = "; ".join(f"{panel.title}: {', '.join(panel.lanes)}" for panel in panels)
    return Chart(
        panels,
        "answer",
        "Each value with its 95 % interval: ○ rig file, ◆ bench, ● updated model (noise only), ■ the part (with model "
        "error), ✕ truth. Axes need not begin at zero.",
        f"Values of the parameters with their intervals; all numbers are in the table above. {words}.",
        columns=3,
    )


def _panel(row: Answer) -> Panel | None:
    unit = display_unit(row.unit, _largest(row))
    shown: list[tuple[str, float, tuple[float, float] | None, str, str]] = []
    if row.described is not None:
        shown.append((_LANES[0], row.described, None, "muted", "rings"))
    if row.bench is not None:
        shown.append((_LANES[1], row.bench.value, row.bench.interval, "before", "diamonds"))
    if row.updated is not None:
        shown.append((_LANES[2], row.updated.value, row.updated.interval, "after", "dots"))
    if row.law is not None:
        shown.append((_LANES[3], row.law.value, row.law.interval, "other-1", "squares"))
    if row.truth is not None:
        shown.append((_LANES[4], row.truth, None, "bad", "crosses"))
    if len(shown) < 2:
        return None
    series = []
    for lane, (_, value, interval, role, mark) in enumerate(shown):
        if interval is not None:
            series.append(
                Series([end * unit.factor for end in interval], [lane, lane], role, "thick")
            )
        series.append(Series([value * unit.factor], [lane], role, mark))  # type: ignore[arg-type]
    verticals = ((row.truth * unit.factor, "bad", ""),) if row.truth is not None else ()
    title = f"{row.path}, {row.where}" if row.where else row.path
    while len(title) > _LONGEST_TITLE and "." in title.partition(",")[0]:
        title = title.partition(".")[2]  # the table above contains the full path
    return Panel(
        tuple(series),
        unit.label(""),
        title=title,
        verticals=verticals,
        lanes=tuple(name for name, *_ in shown),
        width=300,
        height=72 + 22 * len(shown),
    )
