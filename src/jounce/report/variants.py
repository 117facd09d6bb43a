"""Page of a sweep: statistics and sensitivities of all metrics, then figures, runs, and the study file."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from jounce.core.display import display_unit
from jounce.core.old_names import old_argument
from jounce.plots.display import number
from jounce.plots.variants import parallel_coordinates, scatter_matrix, tornado, variant_bands
from jounce.report.page import (
    Block,
    Bullets,
    Cell,
    Details,
    Fact,
    Facts,
    Page,
    PageTable,
    Paragraph,
    Picture,
    Section,
    findings_blocks,
    sections_of,
)
from jounce.report.recordings import curve_blocks

if TYPE_CHECKING:
    from typing import Any

    import xarray as xr
    from matplotlib.figure import Figure

    from jounce.parts import Rig
    from jounce.roads import Trial
    from jounce.variants.study import SweepResult
    from jounce.variants.summary import Influence, Summary

_SHOWN = 10.0  # s of a long run shown initially
_WORDS = {
    "first": "alone",
    "total": "with others",
    "mean_absolute_effect": "mean absolute effect",
    "mean_effect": "mean effect",
    "effect_spread": "spread of effects",
    "regression": "regression",
    "rank_correlation": "rank correlation",
}
_IN_UNITS = ("mean_absolute_effect", "mean_effect", "effect_spread")


@old_argument("found", "sweep")
def sweep_page(
    sweep: SweepResult,
    *,
    title: str,
    runs: Mapping[str, xr.Dataset] | None = None,
    rig: Rig | None = None,
    trial: Trial | None = None,
    study: str = "",
) -> Page:
    """Create a page of a sweep.

    Parameters
    ----------
    sweep : SweepResult
        As :func:`jounce.run_sweep` gives it.
    title : str
        Name of the study.
    runs : mapping of str to xarray.Dataset, optional
        Runs for the viewer by label, e.g. those with the minimum and maximum of a metric.
    rig, trial : Rig and Trial, optional
        3-D rig animated with the first run, and the trial that gives its road.
    study : str
        Text of the study file.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS` or :func:`jounce.report.write_page`.
    """
    summary, data = sweep.summary, sweep.data
    parts: dict[str, Callable[[], Section]] = {"Answer": lambda: Section("Answer", _answer(sweep))}
    if summary.metrics and summary.influences:
        parts["What matters"] = lambda: Section("What matters", _matters(summary, data))
        parts["Scatter"] = lambda: _picture_section(
            "Scatter", partial(scatter_matrix, data), "scatter", _SCATTER
        )
        parts["Parallel coordinates"] = lambda: _picture_section(
            "Parallel coordinates", partial(parallel_coordinates, data), "parallel", _PARALLEL
        )
    if "time" in data.dims and summary.ran:
        parts["Bands over time"] = lambda: _picture_section(
            "Bands over time", partial(variant_bands, data), "bands", _BANDS
        )
    if runs:
        shown = dict(runs)
        parts["Curves"] = lambda: Section("Curves", _curves(shown, title, rig, trial))
    parts["How it was made"] = lambda: Section("How it was made", _provenance(sweep, study))
    sections, missing = sections_of(parts)
    drawn = f"{summary.ran} of {summary.count} variants ran"
    return Page(title, sections, f"Sweep; {drawn}", missing=missing)


def sweep_result_page(swept: SweepResult, *, title: str) -> Page:
    """Create a page of a sweep with the text of its study file and the runs at its extremes."""
    from jounce.variants.study import extreme_runs, read_sweep

    sweep = read_sweep(swept.study)
    text = Path(swept.study).read_text(encoding="utf-8")
    work, page = sweep.work.study, sweep_page(swept, title=title, study=text)

    def curves() -> tuple[Block, ...]:
        runs = extreme_runs(sweep, swept.data)
        return _curves(runs, title, work.rig, work.trial) if runs else ()

    *others, made = page.sections
    return replace(page, sections=(*others, Section("Curves", curves), made))


_SCATTER = (
    "Metrics over the varied parameters (at most the seven most influential), one dot per variant; lines are "
    "means of tenths of the variants."
)
_PARALLEL = (
    "Every variant as a line through its parameters and metrics, coloured by the first metric."
)
_BANDS = "Median of the channels over the variants, with bands that contain 50 % and 90 % of them at each time."
_TORNADO = "Means of the metrics at low and high values of each parameter, and indices with 95 % intervals."


def _picture_section(title: str, draw: Callable[[], Figure], name: str, words: str) -> Section:
    return Section(title, lambda: (Picture(draw(), name, words, words),))


def _answer(sweep: SweepResult) -> tuple[Block, ...]:
    summary = sweep.summary
    lost = sum(failure["variants"] for failure in summary.failed.values())
    finished = summary.ran + lost
    facts = [
        Fact(
            "Variants",
            str(summary.count),
            "all finished" if finished == summary.count else f"{finished} finished",
        ),
        Fact(
            "Ran",
            str(summary.ran),
            f"{summary.side_by_side} side by side",
            "good" if not lost else "fair",
        ),
    ]
    if sweep.seed is not None:
        facts.append(Fact("Seed", str(sweep.seed), "the same points each time"))
    blocks: list[Block] = [Facts(tuple(facts))]
    if summary.metrics:
        blocks += [_statistics(summary), _percentiles(summary)]
    if summary.failed:
        rows = tuple(
            (Cell(reason, "bad"), str(failure["variants"]), str(failure["first"]))
            for reason, failure in summary.failed.items()
        )
        blocks.append(
            PageTable(
                "Variants without a run", ("reason", "variants", "first of them"), rows, "lrr"
            )
        )
    blocks += findings_blocks(summary.findings)
    return tuple(blocks)


def _statistics(summary: Summary) -> PageTable:
    rows = []
    for metric in summary.metrics:
        unit = display_unit(metric.unit, max(abs(metric.least), abs(metric.greatest)))
        levels = [number(level["value"] * unit.factor) for level in metric.percentiles.values()]
        ends = [
            f"{number(value * unit.factor)} ({at})"
            for value, at in (
                (metric.least, metric.least_at),
                (metric.greatest, metric.greatest_at),
            )
        ]
        middle = [number(value * unit.factor) for value in (metric.mean, metric.standard_deviation)]
        rows.append((metric.name, unit.name or "–", *middle, ends[0], *levels, ends[1]))
    levels = [f"{key} %" for key in summary.metrics[0].percentiles]
    header = (
        "metric",
        "unit",
        "mean",
        "standard deviation",
        "least (variant)",
        *levels,
        "greatest (variant)",
    )
    return PageTable("Every metric over the variants", header, tuple(rows), "ll" + "r" * 7)


def _percentiles(summary: Summary) -> Details:
    rows = []
    for metric in summary.metrics:
        unit = display_unit(metric.unit, max(abs(metric.least), abs(metric.greatest)))
        levels = [_with_interval(level, unit.factor) for level in metric.percentiles.values()]
        rows.append((metric.name, unit.name or "–", *levels))
    header = ("metric", "unit", *(f"{key} %" for key in summary.metrics[0].percentiles))
    note = (
        "In brackets: 95 % interval of each percentile, treating the variants as a random sample."
    )
    words = "Percentiles and their uncertainty"
    return Details(words, (PageTable(words, header, tuple(rows), "llrrr", note),))


def _with_interval(level: Mapping[str, Any], factor: float) -> str:
    value = number(level["value"] * factor)
    ends = level["interval"]
    return (
        value
        if ends is None
        else f"{value} ({' … '.join(number(end * factor, 3) for end in ends)})"
    )


def _share(measure: Mapping[str, Any]) -> str:
    """Format a share of variance or a coefficient with three decimals, finer than the accuracy of the design."""
    if not math.isfinite(measure["value"]):
        return "–"
    every = measure["value"], *(measure["interval"] or ())
    value, *ends = (f"{round(each, 3) + 0.0:.3f}".replace("-", "−") for each in every)
    return f"{value} ({' … '.join(ends)})" if ends else value


def _matters(summary: Summary, data: xr.Dataset) -> tuple[Block, ...]:
    return Picture(partial(tornado, data), "tornado", _TORNADO, _TORNADO), *(
        _table(summary, metric.name) for metric in summary.metrics
    )


def _table(summary: Summary, metric: str) -> PageTable:
    """Return the sensitivities of a metric, most influential parameter first."""
    own = [influence for influence in summary.influences if influence.metric == metric]
    measures = [name for name in own[0].measures if name in _WORDS]
    unit = display_unit(
        next(described.unit for described in summary.metrics if described.name == metric)
    )
    writers = {
        name: partial(_with_interval, factor=unit.factor) if name in _IN_UNITS else _share
        for name in measures
    }

    def weight(influence: Influence) -> float:
        return -abs(
            float(
                influence.measures["total" if "total" in influence.measures else measures[0]][
                    "value"
                ]
            )
        )

    rows = tuple(
        (influence.number, *(writers[name](influence.measures[name]) for name in measures))
        for influence in sorted(own, key=weight)
    )
    header = (
        "number",
        *(unit.label(_WORDS[name]) if name in _IN_UNITS else _WORDS[name] for name in measures),
    )
    return PageTable(f"What {metric} depends on", header, rows, "l" + "r" * len(measures))


def _curves(
    runs: Mapping[str, xr.Dataset], title: str, rig: Rig | None, trial: Trial | None
) -> tuple[Block, ...]:
    first = next(iter(runs.values()))
    held = [str(name) for name in first.data_vars if all(name in run for run in runs.values())]
    ends = ("road.z", "body.az", "sprung.az", "strut.deflection", "tyre.force")
    chosen = [next((name for name in held if name.endswith(end)), "") for end in ends]
    long = float(first["time"][-1]) > _SHOWN
    window = (0.0, _SHOWN) if long else None
    return curve_blocks(
        {"": runs},
        [number for number in chosen if number] or None,
        title=title,
        rig=rig,
        trial=trial,
        window=window,
    )


def _provenance(sweep: SweepResult, study: str) -> tuple[Block, ...]:
    items = [
        f"Command: {sweep.command}",
        f"Study: {sweep.study}",
        f"Shards and all inputs of the results: {sweep.out}",
    ]
    lines = tuple(Paragraph(line) for line in study.splitlines() if line.strip())
    return (Bullets(tuple(items)), *((Details("The study's file", lines),) if lines else ()))
