"""Pages of dampers: the sheet of a damper or set, two dampers compared, and clicks for a target."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from jounce.core.display import display_unit
from jounce.core.numbers import number, percent, with_half
from jounce.dampers.adjusters import is_clicks, words_of
from jounce.dampers.compared import ComparedForce, DamperComparison
from jounce.dampers.sheet import DamperSheet, SheetDamper, SheetRow
from jounce.identify.estimate import Estimate
from jounce.plots import figure_of
from jounce.plots.dampers import setting_words, settings_in_words
from jounce.report.fits import rig_table
from jounce.report.page import (
    Block,
    Bullets,
    Cell,
    Fact,
    Facts,
    Page,
    PageTable,
    Paragraph,
    Picture,
    Section,
    Tone,
    answer_page,
    findings_blocks,
    picture_of,
)

if TYPE_CHECKING:
    from jounce.design.clicks import ChosenClicks, ClickChoice

_COLUMNS = 6  # settings in a table of a sheet
_TONES: Mapping[str, Tone] = {"within": "good", "outside": "bad", "cannot be told": "fair"}
_UNITS = {
    "gas_force": ("N", 1.0),
    "gas_stiffness": ("N/mm", 1e-3),
    "friction": ("N", 1.0),
    "lag": ("ms", 1e3),
}
_FORCES = (
    "Force without that of the gas and with seal friction; bump is positive, rebound negative. ± is half of the "
    "95 % interval; it contains the scatter of cycles and records, not errors of the calibration."
)


# sheet ----------------------------------------------------------------------------------------------------------------


def sheet_page(sheet: DamperSheet, *, title: str) -> Page:
    """Create the sheet: of a set the dampers beside each other first, then a page for each damper."""
    single = len(sheet.dampers) == 1
    sections: list[Section] = []
    if not single:
        sections.append(Section("Set", tuple(_set(sheet))))
    for damper in sheet.dampers:
        heading = _named(damper)
        make = partial(_damper, sheet, damper)
        sections.append(Section(heading, make() if single else make, own_page=not single))
    if sheet.findings:
        sections.append(Section("Findings", tuple(findings_blocks(sheet.findings))))
    return Page(title, tuple(sections), sheet.remark)


def _named(damper: SheetDamper) -> str:
    return f"{damper.name}, no. {damper.serial}" if damper.serial else damper.name


def _damper(sheet: DamperSheet, damper: SheetDamper) -> tuple[Block, ...]:
    words = f"{damper.name}: force without gas over velocity for each setting, with 95 % intervals."
    rows = [
        (
            setting_words(item), with_half(item.gas_force), with_half(item.gas_stiffness, 1e-3),
            with_half(item.friction), with_half(item.lag, 1e3),
        )
        for item in damper.map.settings
    ]  # fmt: skip
    header = ("setting", "gas force [N]", "gas stiffness [N/mm]", "friction [N]", "lag [ms]")
    tables = _tables(sheet.speeds, damper)
    return (
        *tables,
        Paragraph(_FORCES, "muted"),
        Picture(lambda: figure_of(damper.map), f"damper-{_slug(damper.name)}", words, words),
        PageTable("Gas, friction and lag", header, tuple(rows), "lrrrr"),
    )


def _slug(name: str) -> str:
    return "".join(c if c.isalnum() else "-" for c in name.lower())


def _tables(speeds: Sequence[float], damper: SheetDamper) -> list[PageTable]:
    """Return forces over speeds, fast rebound first, with a column for each setting."""
    by_place = {(_key(row.settings), row.speed): row for row in damper.rows}
    settings = [item.settings for item in damper.map.settings]
    heads = [setting_words(item) for item in damper.map.settings]
    tables = []
    for first in range(0, len(settings), _COLUMNS):
        part = slice(first, first + _COLUMNS)
        rows = _force_rows(
            speeds, [[by_place.get((_key(s), v)) for v in speeds] for s in settings[part]]
        )
        header = (_speed_head(), *heads[part])
        tables.append(PageTable(f"Forces of {damper.name} [N]", header, rows, "r" * len(header)))
    return tables


def _key(settings: Mapping[str, float]) -> tuple[tuple[str, float], ...]:
    return tuple(sorted(settings.items()))


def _speed_head() -> str:
    return f"velocity [{display_unit('m/s').name}]"


def _force_rows(
    speeds: Sequence[float], columns: Sequence[Sequence[SheetRow | None]]
) -> tuple[tuple[str, ...], ...]:
    factor = display_unit("m/s").factor
    rows = []
    for sign in (-1.0, 1.0):
        places = range(len(speeds))
        for k in reversed(places) if sign < 0.0 else places:
            forces = [
                None if c[k] is None else (c[k].bump if sign > 0.0 else c[k].rebound)  # type: ignore[union-attr]
                for c in columns
            ]
            if any(force is not None for force in forces):
                rows.append((_plain(sign * speeds[k] * factor), *map(_force, forces)))
    return tuple(rows)


def _plain(value: float) -> str:
    return f"{value:.4g}".replace("-", "−")


def _force(value: Estimate | None) -> str:
    return "–" if value is None else with_half(value)


def _set(sheet: DamperSheet) -> list[Block]:
    """Put the dampers beside each other, setting by setting."""
    words = "Force without gas over velocity of all dampers."
    blocks: list[Block] = [picture_of(sheet, "damper-set", words)]
    keys = list(dict.fromkeys(_clicks(row.settings) for d in sheet.dampers for row in d.rows))
    for key in keys:
        columns = []
        for damper in sheet.dampers:
            own = {row.speed: row for row in damper.rows if _clicks(row.settings) == key}
            columns.append([own.get(speed) for speed in sheet.speeds])
        rows = _force_rows(sheet.speeds, columns)
        words = settings_in_words(dict(key)) or "as tested"
        header = (_speed_head(), *(damper.name for damper in sheet.dampers))
        blocks.append(PageTable(f"Forces [N], {words}", header, rows, "r" * len(header)))
    blocks.append(Paragraph(_FORCES, "muted"))
    return blocks


def _clicks(settings: Mapping[str, float]) -> tuple[tuple[str, float], ...]:
    return _key({name: value for name, value in settings.items() if is_clicks(name)})


# comparison -----------------------------------------------------------------------------------------------------------


def comparison_page(result: DamperComparison, *, title: str) -> Page:
    """Create the page of two dampers: verdict, worst place, forces with verdicts, gas and friction."""
    worst = result.worst
    counts = ", ".join(f"{count} {name}" for name, count in result.counts.items() if count)
    unit = display_unit("m/s")
    place = f"{number(worst.velocity * unit.factor, 3)} {unit.name}"
    clicks = settings_in_words(worst.clicks)
    facts = (
        Fact("verdict", result.verdict, counts, _TONES[result.verdict]),
        Fact(
            "largest difference",
            f"{with_half(worst.difference)} N",
            f"at {place}"
            + (f", {clicks}" if clicks else "")
            + f": {percent(worst.share, 0)} of the tolerance",
        ),
        Fact(
            "tolerance",
            f"{percent(result.tolerance)} + {number(result.tolerance_force)} N",
            "share of the mean force, and a force",
        ),
    )
    words = "Forces of both dampers, and their difference with its 95 % interval in the tolerance."
    first, second = result.names
    header = (
        *(["setting"] if result.forces[0].clicks else []), _speed_head(),
        f"{first} [N]", f"{second} [N]", "difference [N]", "tolerance ± [N]", "verdict",
    )  # fmt: skip
    rows = tuple(_compared_row(item) for item in result.forces)
    table = PageTable(
        "Forces", header, rows, "l" * bool(result.forces[0].clicks) + "rrrrrl",
        "A force is within or outside only if the whole 95 % interval of the difference is.",
    )  # fmt: skip
    others = tuple(
        (name.replace("_", " "), with_half(value, _UNITS[name][1]), _UNITS[name][0])
        for name, value in result.others.items()
    )
    blocks: list[Block] = [
        Facts(facts),
        *findings_blocks(result.findings),
        picture_of(result, "damper-comparison", words),
        table,
        PageTable(
            f"Gas, friction and lag: {second} minus {first}", ("quantity", "difference", "unit"), others, "lrl"
        ),
    ]  # fmt: skip
    return answer_page(title, blocks, f"{first} and {second}")


def _compared_row(item: ComparedForce) -> tuple[Cell | str, ...]:
    factor = display_unit("m/s").factor
    return (
        *([settings_in_words(item.clicks)] if item.clicks else []),
        number(item.velocity * factor, 3),
        number(item.first), number(item.second), with_half(item.difference),
        number(item.tolerance, 3), Cell(item.verdict, _TONES[item.verdict]),
    )  # fmt: skip


# clicks ---------------------------------------------------------------------------------------------------------------


def clicks_page(result: ChosenClicks, *, title: str) -> Page:
    """Create the page of clicks for a target: the best combinations, what is left over, and the table for a rig."""
    best = result.best
    facts = [
        Fact("clicks", _clicks_in_words(best), "measured" if best.is_measured else "interpolated"),
        Fact("left over", percent(best.misfit), _misfit_note(best)),
        Fact("residual force", f"{number(best.rms_force, 3)} N", "root mean square"),
    ]
    if best.rms_ratio is not None:
        facts.append(
            Fact(
                "residual damping ratio",
                number(best.rms_ratio, 2),
                "root mean square, at the wheel",
            )
        )
    words = "Target and best clicks, and what is left over, with 95 % intervals."
    searched = (
        f"All {result.combinations:,} combinations of whole clicks were tried."
        if result.are_all_tried
        else f"{result.combinations:,} combinations of whole clicks were searched, two adjusters at a time."
    ).replace(",", " ")
    compared = "damping ratios" if result.compared == "ratio" else "forces"
    blocks: list[Block] = [
        Facts(tuple(facts)),
        *findings_blocks(result.findings),
        _choices(result),
        Paragraph(
            f"{searched} Compared: {compared}, gas and friction taken out. Between measured clicks forces are "
            "interpolated linearly.",
            "muted",
        ),
        picture_of(result, "damper-clicks", words),
        _left_over(result),
        Paragraph("In a rig file, below [strut]:"),
        Bullets((f"damper = {rig_table(result.damper)}",)),
    ]
    if result.wheel is not None:
        wheel = result.wheel
        text = (
            f"Damping ratios at the wheel: motion ratio {number(wheel.motion_ratio)}, sprung mass "
            f"{number(wheel.sprung_mass)} kg, wheel rate {number(wheel.wheel_rate * 1e-3)} N/mm, critical "
            f"{number(wheel.critical_coefficient)} N s/m."
        )
        blocks.insert(4, Paragraph(text, "muted"))
    return answer_page(title, blocks, _clicks_in_words(best))


def _clicks_in_words(choice: ClickChoice) -> str:
    return ", ".join(f"{value:g} {words_of(name)}" for name, value in choice.clicks.items())


def _misfit_note(choice: ClickChoice) -> str:
    if choice.misfit_interval is None:
        return "of the target; interval unknown"
    low, high = (percent(end) for end in choice.misfit_interval)
    return f"of the target (95 %: {low} to {high})"


def _choices(result: ChosenClicks) -> PageTable:
    names = list(result.best.clicks)
    has_ratio = result.best.rms_ratio is not None
    header = (
        *(words_of(name) for name in names), "left over [%]", "95 % interval [%]", "residual force [N]",
        *(["residual damping ratio"] if has_ratio else []), "setting", "beside the best",
    )  # fmt: skip
    rows = []
    for k, choice in enumerate(result.choices):
        ends = choice.misfit_interval
        beside = {True: "cannot be told", False: "worse", None: "unknown"}[choice.is_as_good]
        rows.append(
            (
                *(f"{choice.clicks[name]:g}" for name in names),
                number(100.0 * choice.misfit, 3),
                "–" if ends is None else f"{number(100.0 * ends[0], 2)} to {number(100.0 * ends[1], 2)}",
                number(choice.rms_force, 3),
                *([number(choice.rms_ratio, 2)] if has_ratio else []),
                "measured" if choice.is_measured else "interpolated",
                beside if k else "",
            )
        )  # fmt: skip
    align = "r" * (len(header) - 2) + "ll"
    return PageTable("Best combinations", header, tuple(rows), align)


def _left_over(result: ChosenClicks) -> PageTable:
    factor = display_unit("m/s").factor
    best, ratios = result.best, result.ratios
    header = [_speed_head(), "target [N]", "best [N]", "residual [N]", "residual [%]"]
    if ratios is not None:
        header += ["target ratio", "ratio", "residual ratio"]
    rows = []
    halves = 0.5 * (best.high - best.low)
    for k, velocity in enumerate(result.velocity):
        rest, half = float(result.residual[k]), float(halves[k])
        estimate = Estimate(rest, None, None if np.isnan(half) else (rest - half, rest + half))
        share = rest / abs(result.target[k]) if result.target[k] else np.nan
        row = [
            number(velocity * factor, 3), number(float(result.target[k])), number(float(best.force[k])),
            with_half(estimate), number(100.0 * share, 2),
        ]  # fmt: skip
        if ratios is not None:
            row += [
                number(float(value), 3)
                for value in (ratios["target"][k], ratios["ratio"][k], ratios["ratio"][k] - ratios["target"][k])
            ]  # fmt: skip
        rows.append(tuple(row))
    return PageTable("What is left over", tuple(header), tuple(rows), "r" * len(header))
