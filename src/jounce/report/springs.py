"""Page of a spring map: its curve, shape, hysteresis and loading speeds, and the table for a rig."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from jounce.core.display import display_unit
from jounce.core.numbers import estimate_text, number, percent, with_half
from jounce.core.tables import TextTable
from jounce.plots import figure_of
from jounce.plots.springs import speed_words
from jounce.report.fits import rig_table
from jounce.report.page import (
    Block,
    Bullets,
    Details,
    Page,
    Paragraph,
    Picture,
    answer_page,
    as_table,
    findings_blocks,
)

if TYPE_CHECKING:
    from jounce.springs.curves import PressCurve
    from jounce.springs.map import SpringMap

_WORDS = {
    "linear": "a straight line", "progressive": "a curve", "helper": "a helper and a main spring",
    "sections": "straight sections",
}  # fmt: skip


def spring_map_page(result: SpringMap, *, title: str) -> Page:
    """Create a page of a spring map.

    Parameters
    ----------
    result : SpringMap
        Result of :func:`jounce.spring_map`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    words = "Force over deflection with 95 % intervals; loading and unloading of each speed."
    tables = {"bump_stop": result.bump_stop} if result.law else {"spring": result.spring}
    blocks: list[Block] = [
        as_table(_rates(result)),
        *([as_table(_knees(result))] if result.knees else []),
        as_table(_speeds(result)),
        Paragraph(
            f"Its shape is {_WORDS[result.shape]}. Deflections count from contact, compression is positive, the force "
            "is the mean of loading and unloading. Intervals contain noise, scatter of cycles and files, and the "
            "errors of the zeros, not those of the calibration.",
            "muted",
        ),
        Picture(lambda: figure_of(result), "spring-map", words, words),
        *findings_blocks(result.findings),
        *[
            Details(f"Curve at {speed_words(item)}", (as_table(_curve(item)),))
            for item in result.curves
        ],
        Details("Records", (as_table(_runs(result)),)),
        Paragraph("In a rig file, below [strut]:"),
        Bullets(tuple(f"{name} = {rig_table(table)}" for name, table in tables.items() if table)),
    ]
    kind = "bump stop" if result.part == "bump-stop" else "spring"
    counted = "1 record" if len(result.runs) == 1 else f"{len(result.runs)} records"
    return answer_page(title, blocks, f"{kind}, {counted}")


def _rates(result: SpringMap) -> TextTable:
    length = display_unit("m", 0.05)
    rows = [
        (
            number(item.start * length.factor, 4), number(item.end * length.factor, 4),
            estimate_text(item.rate, "N/m"),
        )
        for item in result.sections
    ]  # fmt: skip
    if result.law is not None:
        rows.append(("law", "", estimate_text(result.law.rate, "N/m")))
    return TextTable("Rates", (f"from [{length.name}]", f"to [{length.name}]", "rate"), rows)


def _knees(result: SpringMap) -> TextTable:
    length = display_unit("m", 0.05)
    rows = [
        (
            item.kind, with_half(item.deflection, length.factor), with_half(item.force),
            estimate_text(item.helper_rate, "N/m"),
        )
        for item in result.knees
    ]  # fmt: skip
    header = ("knee", f"deflection [{length.name}]", "force [N]", "helper alone")
    return TextTable("Knees, with 95 % intervals", header, rows)


def _speeds(result: SpringMap) -> TextTable:
    rows = [
        (
            speed_words(item), str(len(item.files)), number(float(item.force[-1]), 4),
            with_half(item.energy), with_half(item.loss_factor, 100.0),
        )
        for item in result.curves
    ]  # fmt: skip
    effect = result.speed_effect
    if effect.interval is not None:
        low, high = effect.interval
        rows.append(
            (
                "ten times the speed",
                "",
                percent(effect.value),
                f"{percent(low)} to {percent(high)}",
                "",
            )
        )
    header = (
        "loading speed",
        "records",
        "largest force [N]",
        "energy per cycle [J]",
        "loss factor [%]",
    )
    return TextTable("Loading speeds", header, rows)


def _curve(item: PressCurve) -> TextTable:
    length, force = display_unit("m", 0.05), display_unit("N", float(item.force[-1]))
    columns = (item.deflection, item.force, item.low, item.high, item.hysteresis)
    rows = [
        tuple(
            number(float(value) * factor, 4)
            for value, factor in zip(row, (length.factor, *[force.factor] * 4), strict=True)
        )
        for row in zip(*columns, strict=True)
    ]
    header = (
        f"deflection [{length.name}]", f"force [{force.name}]", "from", "to", "half of loading less unloading",
    )  # fmt: skip
    return TextTable(speed_words(item), header, rows, texts=())


def _runs(result: SpringMap) -> TextTable:
    length = display_unit("m", 0.05)
    rows = [
        (
            run.file, "–" if math.isnan(run.speed) else number(1e3 * run.speed, 3),
            number(run.stroke * length.factor, 4), number(run.largest_force, 4), str(run.cycles),
            with_half(run.force_zero), with_half(run.contact, length.factor),
            f"{run.stroke_positive}, {run.force_positive}",
        )
        for run in result.runs
    ]  # fmt: skip
    header = (
        "record", "speed [mm/s]", f"stroke [{length.name}]", "largest force [N]", "cycles", "zero of force [N]",
        f"contact [{length.name}]", "positive",
    )  # fmt: skip
    return TextTable("Records", header, rows, texts=(0, 7))
