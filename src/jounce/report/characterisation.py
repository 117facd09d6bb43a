"""Characterisation section of a campaign report: results of bench measurements and replaced rig values."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from jounce.campaign.characterise import decay_records
from jounce.core.display import display_unit
from jounce.core.errors import DescriptionError, JounceError
from jounce.core.results import ESTIMATE, ResultField, fields_of, fields_table, group_table
from jounce.core.types import Array
from jounce.identify.motion import MOTIONS
from jounce.parts.rig import result_unit_of
from jounce.plots.display import estimate_cells, estimate_text, number, quantity
from jounce.report.bench_charts import decay_panels, pressure_panel, stiffness_panels
from jounce.report.chart import Chart
from jounce.report.page import (
    Block,
    Details,
    PageTable,
    Paragraph,
    Section,
    Subsection,
    as_table,
    unique_slugs,
)

if TYPE_CHECKING:
    from jounce.campaign.characterise import DampingChoice
    from jounce.campaign.description import DecayBench
    from jounce.campaign.result import CampaignResult
    from jounce.identify.decay import CombinedDecay, DecayResult
    from jounce.identify.force_deflection import ForceDeflectionTrial
    from jounce.identify.stiffness import StiffnessResult
    from jounce.parts import Rig


_NAMES = {"bench.spring": "spring", "bench.tyre": "tyre", "bench.decay": "free decays"}


def characterisation(result: CampaignResult) -> Section:
    """Return replaced values, then spring, tyre and damping with tables and figures; failed tables are listed."""
    bench = result.characterisation
    blocks: list[Block] = [
        Paragraph(
            f"The {_NAMES.get(place, place)} could not be evaluated; the value of the rig file is used (see Findings).",
            "bad",
        )
        for place in bench.failed
    ]
    if bench.replaced:
        blocks.append(replaced_table(result))
    if bench.spring is not None:
        blocks.append(
            Subsection(
                "Spring", _stiffness(result, bench.spring, "bench.spring", "spring", "bench-spring")
            )
        )
    files = unique_slugs([f"bench tyre {name}" for name in bench.tyre])
    for file, (name, fit) in zip(files, bench.tyre.items(), strict=True):
        blocks.append(
            Subsection(
                f"Tyre at {name}",
                _stiffness(result, fit, f'bench.tyre."{name}"', f"tyre, {name}", file),
            )
        )
    if bench.pressure is not None and len(bench.pressure.pressures) > 1:
        blocks.append(Subsection("Tyre against pressure", _pressure(result)))
    if bench.decay is not None:
        blocks.append(Subsection("Damping from free decays", _decay(result)))
    if not blocks:
        blocks.append(
            Paragraph(
                "The campaign contains no bench measurements; all values are those of the rig file."
            )
        )
    return Section("Characterisation", tuple(blocks))


def unit_at(rig: Rig, path: str) -> str:
    """Return the SI unit of a rig value; ``1`` for a path that does not exist in this rig."""
    try:
        return result_unit_of(rig, path)
    except (DescriptionError, AttributeError, KeyError, IndexError, TypeError):
        return "1"


def replaced_table(result: CampaignResult) -> PageTable:
    """Return a table of the rig values that are replaced by measured ones."""
    rows = []
    for item in result.characterisation.replaced:
        si = unit_at(result.start, item.path)
        si = unit_at(result.rig, item.path) if si == "1" else si
        unit = display_unit(si, item.measured)
        error = "–" if item.standard_error is None else number(item.standard_error * unit.factor, 2)
        described = "–" if item.described is None else number(item.described * unit.factor)
        rows.append(
            (
                item.path,
                described,
                number(item.measured * unit.factor),
                error,
                unit.name,
                item.source,
            )
        )
    return PageTable(
        "Rig parameters replaced by measured values",
        ("parameter", "rig file", "measured", "standard error", "unit", "source"),
        tuple(rows),
        "lrrrll",
    )


def _stiffness(
    result: CampaignResult, fit: StiffnessResult, place: str, title: str, file: str
) -> tuple[Block, ...]:
    return stiffness_blocks(fit, result.characterisation.loaded.get(place, []), title, file)


def stiffness_blocks(
    fit: StiffnessResult, points: Sequence[ForceDeflectionTrial], title: str, file: str
) -> tuple[Block, ...]:
    """Return the result of a stiffness fit, its figure, and a table of its trials."""
    motion = MOTIONS[fit.motion]
    fields = [*fields_of(fit, "stiffness", "intercept", "tangent_stiffness"), *_coefficients(fit)]
    caption = f"Fit for the {title}: {fit.law} law, all trials"
    summary = as_table(fields_table(caption, fields), _fit_note(fit))
    alternative = (
        f"{motion.force_word.capitalize()} against {motion.deflection_word} of the {title} with a {fit.law} fit "
        f"through {len(fit.trials)} trials, stiffness {estimate_text(fit.stiffness, motion.stiffness)}; right: "
        "stiffness of each trial."
    )
    caption = (
        f"Left: measured points and fitted law of the {title}. "
        "Right: stiffness of the individual trials with 95 % intervals."
    )
    picture = Chart(stiffness_panels(fit, points, title), file, caption, alternative)
    return summary, picture, as_table(group_table("Individual trials", fit.trials))


def _coefficients(fit: StiffnessResult) -> list[ResultField]:
    """Return the coefficients of a law with more parameters than the stiffness."""
    if fit.law == "linear":
        return []
    pairs = zip(fit.coefficient_units, fit.coefficients, strict=True)
    return [
        ResultField("coefficients", f"coefficient {k}", *pair) for k, pair in enumerate(pairs, 1)
    ]


def _fit_note(fit: StiffnessResult) -> str:
    motion = MOTIONS[fit.motion]
    low, high = fit.fitted_range
    branch = "both branches" if fit.branch == "both" else f"the {fit.branch} branch"
    fitted = f"Fitted to {branch} from {quantity(low, motion.deflection, 3)} to {quantity(high, motion.deflection, 3)}"
    names = ("r2", "repeatability", "loss_factor", "hysteresis_energy", "operating_deflection")
    known = [field for field in fields_of(fit, *names) if field.value is not None]
    return "; ".join([fitted, *(f"{field.label} {field.in_words()}" for field in known)]) + "."


def _pressure(result: CampaignResult) -> tuple[Block, ...]:
    law = result.characterisation.pressure
    assert law is not None
    rows = tuple(
        (quantity(pressure, "Pa", 3), *estimate_cells(stiffness, "N/m"))
        for pressure, stiffness in zip(law.pressures, law.stiffnesses, strict=True)
    )
    note = []
    if law.slope is not None:
        stiffness, of = display_unit("N/m"), display_unit("Pa")
        note.append(
            f"Slope {number(law.slope * stiffness.factor / of.factor, 4)} {stiffness.name} per {of.name}"
        )
    if law.at_zero_pressure is not None:
        note.append(f"extrapolated to zero pressure {quantity(law.at_zero_pressure, 'N/m')}")
    if law.exponent is not None:
        note.append(f"exponent of the power law {number(law.exponent, 3)}")
    table = PageTable(
        "Tyre stiffness against inflation pressure",
        ("pressure", *ESTIMATE[1:]),
        rows,
        "lrrrl",
        "; ".join(note) + "." if note else "",
    )
    words = ", ".join(f"{row[0]}: {row[1]} {row[4]}" for row in rows)
    picture = Chart(
        (pressure_panel(law),),
        "bench-tyre-pressure",
        "Radial stiffness against inflation pressure, interpolated between the measured pressures.",
        f"Tyre stiffness against inflation pressure. {words}.",
    )
    return table, picture


def _decay(result: CampaignResult) -> tuple[Block, ...]:
    bench = result.characterisation
    combined = bench.decay
    assert combined is not None
    blocks: list[Block] = [
        decay_table(
            combined,
            f"Damping from {len(bench.decays)} free decays combined"
            if len(bench.decays) > 1
            else "Damping from a free decay",
        )
    ]
    if bench.damping_choices:
        blocks.append(_damping_choices(bench.damping_choices))
    records = _decay_records(result, result.campaign.bench.decay)
    if len(records) != len(bench.decays):
        records = [(f"decay {k}", (), ()) for k in range(1, len(bench.decays) + 1)]  # type: ignore[misc]
    pictures: list[Chart] = []
    files = unique_slugs(
        [f"bench decay {Path(name).stem.removeprefix('decay')}" for name, _, _ in records]
    )
    for file, (name, time, signal), decay in zip(files, records, bench.decays, strict=True):
        pictures.append(
            decay_chart(decay, np.asarray(time, float), np.asarray(signal, float), name, file)
        )
    blocks += pictures[:1]
    if len(bench.decays) > 1:
        blocks.append(each_decay(bench.decays, [record[0] for record in records]))
        blocks.append(Details("Figures of the other decays", tuple(pictures[1:])))
    return tuple(blocks)


def decay_chart(decay: DecayResult, time: Array, signal: Array, name: str, file: str) -> Chart:
    """Plot a measured and fitted free decay, with turning points and decrements; time in s, the record in SI."""
    motion = MOTIONS[decay.motion]
    alternative = (
        f"Free decay {name} with the fitted response: damping coefficient "
        f"{estimate_text(decay.damping_coefficient, motion.damping)}, dry friction "
        f"{estimate_text(decay.coulomb_force, motion.force)}."
    )
    caption = (
        f"{name}: measured and fitted response; successive turning points; apparent damping ratios from single "
        f"decrements. R² {decay.r2:.4f}."
    )
    return Chart(decay_panels(decay, time, signal, name), file, caption, alternative, columns=3)


def decay_table(decay: DecayResult | CombinedDecay, caption: str) -> PageTable:
    """Return a table of the damping from one or several free decays."""
    fields = [field for field in fields_of(decay) if hasattr(field.value, "interval")]
    word = MOTIONS[decay.motion].inertia_word
    note = (
        f"{number(decay.cycles, 3)} cycles in total; values are referred to the {word} that swings."
    )
    return as_table(fields_table(caption, fields), note)


_METHODS = {
    "viscous-and-coulomb": "viscous and dry friction",
    "logarithmic-decrement": "logarithmic decrement only",
}


def _damping_choices(choices: tuple[DampingChoice, ...]) -> PageTable:
    damping = display_unit("N*s/m")
    rows = tuple(
        (
            _METHODS[choice.method],
            *(
                _with_interval(*estimate_cells(estimate, si))
                for estimate, si in (
                    (choice.damping_ratio, "1"),
                    (choice.seen, "N*s/m"),
                    (choice.at_strut, "N*s/m"),
                )
            ),
            "yes" if choice.is_used else "no",
        )
        for choice in choices
    )
    return PageTable(
        "Damper coefficients by method of evaluating the decays",
        (
            "way",
            "damping ratio",
            damping.label("of the sprung mass"),
            damping.label("at the strut"),
            "used",
        ),
        rows,
        "lrrrl",
        "With 95 % intervals. The decrement takes dry friction for viscous damping: it is right at the amplitudes of "
        "the decays only.",
    )


def _with_interval(value: str, _error: str, interval: str, _unit: str) -> str:
    """Join the cells of an estimate into one, with the unit in the header."""
    return f"{value} ({interval})" if interval != "–" else value


def each_decay(decays: Sequence[DecayResult], names: Sequence[str]) -> PageTable:
    """Return a table of individual decays, one row each."""
    motion = MOTIONS[decays[0].motion]
    rows = tuple(
        (
            name,
            *(
                _with_interval(*estimate_cells(estimate, si))
                for estimate, si in (
                    (d.damping_coefficient, motion.damping),
                    (d.coulomb_force, motion.force),
                    (d.natural_frequency_hz, "Hz"),
                )
            ),
            number(d.cycles, 2),
        )
        for name, d in zip(names, decays, strict=True)
    )
    return PageTable(
        "Individual decays (with 95 % intervals)",
        (
            "record",
            display_unit(motion.damping).label("damping coefficient"),
            display_unit(motion.force).label("dry friction"),
            "natural frequency [Hz]",
            "cycles",
        ),
        rows,
        "lrrrr",
    )


def _decay_records(
    result: CampaignResult, table: DecayBench | None
) -> list[tuple[str, Array, Array]]:
    """Return file name, time (s) and record (SI) of each decay; empty if the files can no longer be read."""
    if table is None:
        return []
    try:
        records = decay_records(table, result.folder, result.campaign.sensors)
    except JounceError:
        return []
    return [(record.file, record.time, record.signal) for record in records]
