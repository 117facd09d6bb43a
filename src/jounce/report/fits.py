"""Pages of fits to bench measurements: stiffness, free decay, damper, hardpoints."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from jounce.core.display import display_unit
from jounce.core.numbers import estimate_cells, number
from jounce.core.old_names import old_argument
from jounce.core.results import fields_of, fields_table, group_table
from jounce.identify.estimate import Estimate
from jounce.plots import figure_of
from jounce.report.characterisation import decay_chart, decay_table, each_decay, stiffness_blocks
from jounce.report.page import (
    Block,
    Bullets,
    Details,
    Page,
    PageTable,
    Paragraph,
    Picture,
    answer_page,
    as_table,
    findings_blocks,
    unique_slugs,
)

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from jounce.campaign.bench_fits import MeasuredDamper, MeasuredDecays, MeasuredStiffness
    from jounce.core.findings import Finding
    from jounce.core.types import Array
    from jounce.design.measured_poses import HardpointFit
    from jounce.identify.damper_result import DamperCurve, DamperResult
    from jounce.identify.decay import CombinedDecay, DecayResult
    from jounce.identify.force_deflection import ForceDeflectionTrial
    from jounce.identify.stiffness import StiffnessResult


def measured_stiffness_page(measured: MeasuredStiffness, *, title: str) -> Page:
    """Create a page of a stiffness with its trials."""
    return stiffness_page(measured.fit, measured.measured.trials, measured.findings, title=title)


def measured_decays_page(measured: MeasuredDecays, *, title: str) -> Page:
    """Create a page of the damping from free decays."""
    return decay_page(measured.fit, measured.decays, measured.findings, title=title)


def measured_damper_page(measured: MeasuredDamper, *, title: str) -> Page:
    """Create a page of a damper law with its record."""
    return damper_page(measured.fit, measured.curve, measured.findings, title=title)


@old_argument("found", "fit")
def stiffness_page(
    fit: StiffnessResult,
    trials: Sequence[ForceDeflectionTrial],
    findings: Sequence[Finding],
    *,
    title: str,
) -> Page:
    """Create a page of a fitted stiffness with its measured points.

    Parameters
    ----------
    fit : StiffnessResult
        Result of :func:`jounce.fit_stiffness`.
    trials : sequence of ForceDeflectionTrial
        Measured trials.
    findings : sequence of Finding
        Findings that limit the reliability of the results.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    first, *others = stiffness_blocks(fit, trials, title, "stiffness")
    return answer_page(
        title, [first, *findings_blocks(findings), *others], f"Stiffness, {fit.law} law"
    )


@old_argument("found", "fit")
def decay_page(
    fit: DecayResult | CombinedDecay,
    decays: Mapping[str, tuple[DecayResult, Array, Array]],
    findings: Sequence[Finding],
    *,
    title: str,
) -> Page:
    """Create a page of the damping from one or several free decays.

    Parameters
    ----------
    fit : DecayResult or CombinedDecay
        Result of :func:`jounce.fit_decay`, or of :func:`jounce.fit_measured_decays` for several.
    decays : mapping of str to (DecayResult, ndarray, ndarray)
        Individual decays by name, each with its time (s) and record (SI), shape (n,).
    findings : sequence of Finding
        Findings that limit the reliability of the results.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    several = len(decays) > 1
    caption = (
        f"Damping from {len(decays)} free decays combined"
        if several
        else "Damping from a free decay"
    )
    files = unique_slugs([f"decay {name}" for name in decays])
    charts = [
        decay_chart(*decay, name, file)
        for file, (name, decay) in zip(files, decays.items(), strict=True)
    ]
    blocks: list[Block] = [decay_table(fit, caption), *findings_blocks(findings), *charts[:1]]
    if several:
        blocks += [
            each_decay([decay for decay, _, _ in decays.values()], list(decays)),
            Details("Figures of the other decays", tuple(charts[1:])),
        ]
    return answer_page(title, blocks, "Damping from free decay")


@old_argument("found", "fit")
def damper_page(
    fit: DamperResult,
    curve: DamperCurve,
    findings: Sequence[Finding],
    *,
    title: str,
) -> Page:
    """Create a page of a fitted damper law with its measured loops.

    Parameters
    ----------
    fit : DamperResult
        Result of :func:`jounce.fit_damper`.
    curve : DamperCurve
        Measured and fitted force side by side.
    findings : sequence of Finding
        Findings that limit the reliability of the results.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    parameters = fields_of(fit, "parameters")
    names = ("nrmse", "rms_residual", "r2", "energy_per_cycle", "fitted_energy_per_cycle")
    note = "; ".join(f"{field.label} {field.in_words()}" for field in fields_of(fit, *names)) + "."
    counted = (
        f"{fit.samples} samples of {fit.cycles:g} cycles. In the record the stroke is positive in "
        f"{fit.stroke_positive}, the force in {fit.force_positive}; the law is positive in compression."
    )
    words = "Force against velocity and against displacement, measured and fitted."
    picture = Picture(lambda: figure_of(curve, law=fit.law), "damper", words, words)
    table = as_table(fields_table(f"Damper, {fit.law} law", parameters), note)
    tables = {"damper": fit.damper, "friction": fit.friction}
    rig = Bullets(
        tuple(
            f"{name} = {rig_table(values)}" for name, values in tables.items() if values is not None
        )
    )
    in_rig = Paragraph("In a rig file, below [strut], positive in compression (bump):")
    blocks = [table, Paragraph(counted, "muted"), in_rig, rig, *findings_blocks(findings), picture]
    return answer_page(title, blocks, f"Damper, {fit.law} law")


def rig_table(table: dict[str, Any]) -> str:
    """Format a table on one line in the syntax of a rig file."""
    import tomlkit

    inline = tomlkit.inline_table()
    inline.update({key: _short(value) for key, value in table.items()})
    return inline.as_string()


def _short(value: Any) -> Any:
    """Round numbers to six digits, also those of lists."""
    if isinstance(value, list):
        return [_short(item) for item in value]
    return float(f"{value:.6g}") if isinstance(value, float) else value


@old_argument("found", "fit")
def hardpoints_page(fit: HardpointFit, *, title: str) -> Page:
    """Create a page of hardpoints fitted to measured poses, with the residual of each measured quantity.

    Parameters
    ----------
    fit : HardpointFit
        Result of :func:`jounce.fit_hardpoints`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    rows = [
        _change_row(label, estimate, "m" if "hardpoints." in label else "1", fit.before[label])
        for label, estimate in fit.numbers.items()
    ]
    rows += [
        _change_row(f"offset of {name}", estimate, fit.quantities[name].unit, 0.0)
        for name, estimate in fit.offsets.items()
    ]
    header = ("number", "before", "found", "by", "95 % interval of the change", "unit")
    note = f"{fit.agreed} of {fit.starts} starts converged to this result; {len(fit.wheel_travel)} poses."
    points = PageTable("Points", header, tuple(rows), "lrrrrl", note)
    left = as_table(group_table("Residual, root mean square", fit.quantities))
    return answer_page(
        title, [points, left, *findings_blocks(fit.findings)], "Hardpoints from measured poses"
    )


def _change_row(label: str, estimate: Estimate, si: str, before: float) -> tuple[str, ...]:
    """Return a row with a value before and after, and the interval of its change."""
    ends = estimate.interval and (estimate.interval[0] - before, estimate.interval[1] - before)
    change = Estimate(estimate.value - before, estimate.standard_error, ends)
    unit = display_unit(si)
    value, _, interval, name = estimate_cells(change, si, unit)
    return (
        label,
        *(number(size * unit.factor, 6) for size in (before, estimate.value)),
        value,
        interval,
        name or "–",
    )
