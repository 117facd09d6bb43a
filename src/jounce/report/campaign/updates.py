"""Updates: parameters with uncertainty and bounds, what the data could tell apart, what the fit brought."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.plots import display_unit, number, objectives, update
from jounce.report.campaign.bench import unit_at
from jounce.report.numbers import correlation, estimate_cells, percent
from jounce.report.page import Block, Cell, Findings, Paragraph, Picture, Section, Subsection, Table, unique_slugs

if TYPE_CHECKING:
    from jounce.campaign.result import CampaignResult, StrategyResult


def updates(result: CampaignResult) -> Section:
    """All updates in order; those that failed are named."""
    done = {strategy.update.name for strategy in result.strategies}
    blocks: list[Block] = [
        Paragraph(f"The update {entry.name!r} failed and is left out. See Findings.", "bad")
        for entry in result.campaign.update
        if entry.name not in done
    ]
    if not result.campaign.update:
        blocks.append(Paragraph("No update was asked for: the trials are compared with the characterised model."))
    if result.strategies:
        found = [strategy.update for strategy in result.strategies]
        words = "; ".join(
            f"{one.name}: {number(one.objective_before)} to {number(one.objective_after)}" for one in found
        )
        blocks += [
            _overview(result),
            Picture(
                objectives(found),
                "updates-objective",
                "Objective of each update relative to its own start.",
                f"Objective before and after each update. {words}.",
            ),
        ]
    blocks += [
        Subsection(strategy.update.name, _strategy(strategy, file))
        for file, strategy in zip(_figure_names(result), result.strategies, strict=True)
    ]
    return Section("Updates", tuple(blocks))


def _overview(result: CampaignResult) -> Table:
    rows = tuple(
        (
            one.name,
            one.method,
            ", ".join(str(number_of) for number_of in strategy.fitted_on),
            number(one.objective_before),
            number(one.objective_after),
            percent(0.01 * one.reduction_percent),
            str(one.iterations),
            str(one.evaluations),
        )
        for strategy in result.strategies
        for one in (strategy.update,)
    )
    header = (
        "update",
        "method",
        "trials",
        "objective before",
        "objective after",
        "reduction",
        "iterations",
        "evaluations",
    )
    note = "Objective: sum of squared differences over all channels and samples, weighted where the campaign says so."
    return Table("What the updates brought", header, rows, "lllrrrrr", note)


def _figure_names(result: CampaignResult) -> list[str]:
    return unique_slugs([f"update {strategy.update.name}" for strategy in result.strategies])


def _strategy(strategy: StrategyResult, file: str) -> tuple[Block, ...]:
    found = strategy.update
    units = {path: unit_at(strategy.knowledge.rig, path) for path in found.parameters}
    fitted = "; ".join(
        f"{path} {estimate_cells(p, units[path])[0]} {display_unit(units[path]).name}"
        + (" at its bound" if p.at_bound else "")
        for path, p in found.parameters.items()
    )
    picture = Picture(
        update(found, units),
        file,
        "Start and fitted values between their bounds with 95 % intervals; correlation of the estimates (– where a "
        "parameter lies on a bound).",
        f"Fitted parameters of {found.name}: {fitted}.",
    )
    blocks: list[Block] = [_parameters(strategy, units), picture, _identifiability(strategy)]
    if found.lags:
        rows = tuple((name, number(1e3 * lag, 3)) for name, lag in found.lags.items())
        blocks.append(Table("Lag of each recording behind the simulation", ("trial", "lag [ms]"), rows, "lr"))
    if found.findings:
        blocks.append(Findings(found.findings))
    return tuple(blocks)


def _parameters(strategy: StrategyResult, units: dict[str, str]) -> Table:
    rows: list[tuple[Cell | str, ...]] = []
    for path, p in strategy.update.parameters.items():
        unit = display_unit(units[path], p.value)
        value, error, interval, name = estimate_cells(p, units[path])
        bounds = f"{number(p.lower * unit.factor)} to {number(p.upper * unit.factor)}"
        fitted = Cell(value, "fair", "at its bound") if p.at_bound else value
        rows.append((path, number(p.initial * unit.factor), fitted, error, interval, bounds, name or "–"))
    header = ("parameter", "initial", "fitted", "standard error", "95 % interval", "bounds", "unit")
    note = "Standard errors allow for correlated residuals; a parameter on its bound has none."
    return Table(f"Parameters of {strategy.update.name}", header, tuple(rows), "lrrrrrl", note)


def _identifiability(strategy: StrategyResult) -> Table:
    known = strategy.update.identifiability
    count = len(strategy.update.parameters)
    rows = tuple(
        (
            f"{place}  {name}",
            number(sensitivity, 3),
            *("1" if place == column else correlation(value) for column, value in enumerate(row[:count], 1)),
        )
        for place, (name, sensitivity, row) in enumerate(
            zip(known.parameters, known.sensitivity, known.correlation, strict=True), 1
        )
    )
    header = ("parameter", "sensitivity", *(f"with {place}" for place in range(1, count + 1)))
    note = (
        f"Rank {known.rank} of {len(known.parameters)}, condition number {number(known.condition, 3)}. Sensitivity: "
        "r.m.s. change of the weighted residuals from the middle of the bounds to one end."
    )
    caption = "Before the fit: what the data react to, and which estimates would be correlated"
    return Table(caption, header, rows, "lr" + "r" * count, note)
