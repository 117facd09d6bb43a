"""Page of a damper map: its curves, what each setting and each record shows, and the table for a rig."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.core.display import display_unit
from jounce.core.numbers import number, with_half
from jounce.core.tables import TextTable
from jounce.plots import figure_of
from jounce.plots.dampers import setting_words
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
    from jounce.dampers.curves import DamperSetting
    from jounce.dampers.map import DamperMap

_READ = {
    "peak": "one point a cycle at peak velocity (PVP)",
    "continuous": "the whole loop, the mean of rising and falling speed (CVP)",
}


def damper_map_page(result: DamperMap, *, title: str) -> Page:
    """Create a page of a damper map.

    Parameters
    ----------
    result : DamperMap
        Result of :func:`jounce.damper_map`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    tables = {"damper": result.damper, "friction": result.friction}
    words = "Force without gas over velocity for each setting, with 95 % intervals."
    blocks: list[Block] = [
        as_table(_settings(result)),
        Paragraph(
            f"Read as {_READ[result.reading]}. Bump and compression are positive; the gas force is taken out. "
            "Intervals contain the scatter of cycles and records, not errors of the calibration.",
            "muted",
        ),
        Picture(lambda: figure_of(result), "damper-map", words, words),
        *([as_table(_knees(result))] if any(item.knees for item in result.settings) else []),
        *findings_blocks(result.findings),
        Details("Curves", tuple(as_table(_curve(item)) for item in result.settings)),
        Details("Records", (as_table(_runs(result)),)),
        Paragraph("In a rig file, below [strut]; friction is apart:"),
        Bullets(tuple(f"{name} = {rig_table(table)}" for name, table in tables.items() if table)),
    ]
    return answer_page(
        title,
        blocks,
        f"{_counted(len(result.settings), 'setting')}, {_counted(len(result.runs), 'record')}",
    )


def _counted(number: int, word: str) -> str:
    return f"{number} {word}" if number == 1 else f"{number} {word}s"


def _settings(result: DamperMap) -> TextTable:
    rows = [
        (
            setting_words(item), str(len(item.files)), with_half(item.gas_force), with_half(item.gas_stiffness, 1e-3),
            with_half(item.friction), with_half(item.lag, 1e3),
            "–" if item.repeatability is None else number(100.0 * item.repeatability, 2),
        )
        for item in result.settings
    ]  # fmt: skip
    header = (
        "setting", "records", "gas [N]", "gas stiffness [N/mm]", "friction [N]", "lag [ms]", "repeats [%]",
    )  # fmt: skip
    return TextTable("Settings, with 95 % intervals", header, rows)


def _knees(result: DamperMap) -> TextTable:
    speed = display_unit("m/s")
    rows = [
        (
            setting_words(item), knee.side, with_half(knee.velocity, speed.factor), with_half(knee.force),
            number(knee.softer, 2),
        )
        for item in result.settings
        for knee in item.knees
    ]  # fmt: skip
    header = (
        "setting", "side", f"velocity [{speed.name}]", "force [N]", "slope beyond over before",
    )  # fmt: skip
    return TextTable("Knees, where a valve opens, with 95 % intervals", header, rows, texts=(0, 1))


def _curve(item: DamperSetting) -> TextTable:
    force = display_unit("N", float(abs(item.force).max()))
    speed = display_unit("m/s", float(abs(item.velocity).max()))
    rows = [
        tuple(
            number(value * factor, 4)
            for value, factor in zip(row, (speed.factor, *[force.factor] * 3), strict=True)
        )
        for row in zip(item.velocity, item.force, item.low, item.high, strict=True)
    ]
    header = (f"velocity [{speed.name}]", f"force [{force.name}]", "from", "to")
    return TextTable(setting_words(item), header, rows, texts=())


def _runs(result: DamperMap) -> TextTable:
    stroke, speed = display_unit("m", 0.05), display_unit("m/s")
    rows = [
        (
            run.file, run.motion, number(run.stroke * stroke.factor, 3), number(run.peak_velocity * speed.factor, 3),
            str(run.cycles), number(run.peak_bump_force.value, 4), number(run.peak_rebound_force.value, 4),
            number(100.0 * run.fade.value, 2), number(run.energy_per_cycle, 3),
        )
        for run in result.runs
    ]  # fmt: skip
    header = (
        "record", "motion", f"stroke [{stroke.name}]", f"peak velocity [{speed.name}]", "cycles",
        "bump [N]", "rebound [N]", "fade [%]", "energy per cycle [J]",
    )  # fmt: skip
    return TextTable("Records", header, rows, texts=(0, 1))
