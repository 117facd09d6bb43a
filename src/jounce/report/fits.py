"""What a bench measurement gave as a page: stiffness, a free decay, a damper."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.plots import figure_of
from jounce.plots.display import estimate_cells, percent, quantity
from jounce.report.characterisation import ESTIMATE, decay_chart, decay_table, each_decay, stiffness_blocks
from jounce.report.page import Block, Details, Findings, Page, Paragraph, Picture, Section, Table, unique_slugs

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from jounce.core.findings import Finding
    from jounce.core.types import Array
    from jounce.identify.damper import DamperCurve, DamperResult
    from jounce.identify.decay import CombinedDecay, DecayResult
    from jounce.identify.force_deflection import ForceDeflectionTrial
    from jounce.identify.stiffness import StiffnessResult


def stiffness_page(
    found: StiffnessResult, trials: Sequence[ForceDeflectionTrial], findings: Sequence[Finding], *, title: str
) -> Page:
    """Put a fitted stiffness on a page, with the points that it was fitted to.

    Parameters
    ----------
    found : StiffnessResult
        As :func:`jounce.fit_stiffness` gives it.
    trials : sequence of ForceDeflectionTrial
        What was measured.
    findings : sequence of Finding
        What weakens the numbers.
    title : str
        Head of the page.

    Returns
    -------
    Page
        To be written with :data:`jounce.report.REPORTS`.
    """
    first, *others = stiffness_blocks(found, trials, title, "stiffness")
    return _page(title, [first, *_said(findings), *others], f"Stiffness, {found.law} law")


def decay_page(
    found: DecayResult | CombinedDecay,
    decays: Mapping[str, tuple[DecayResult, Array, Array]],
    findings: Sequence[Finding],
    *,
    title: str,
) -> Page:
    """Put the damping of one or several free decays on a page.

    Parameters
    ----------
    found : DecayResult or CombinedDecay
        As :func:`jounce.fit_decay` or :func:`jounce.combine_decays` gives it.
    decays : mapping of str to (DecayResult, ndarray, ndarray)
        Each of them by name, with its time (s) and what was recorded (SI), shape (n,).
    findings : sequence of Finding
        What weakens the numbers.
    title : str
        Head of the page.

    Returns
    -------
    Page
        To be written with :data:`jounce.report.REPORTS`.
    """
    several = len(decays) > 1
    caption = f"Damping from {len(decays)} free decays combined" if several else "Damping from a free decay"
    files = unique_slugs([f"decay {name}" for name in decays])
    charts = [decay_chart(*one, name, file) for file, (name, one) in zip(files, decays.items(), strict=True)]
    blocks: list[Block] = [decay_table(found, caption), *_said(findings), *charts[:1]]
    if several:
        blocks += [
            each_decay([one for one, _, _ in decays.values()], list(decays)),
            Details("Figures of the other decays", tuple(charts[1:])),
        ]
    return _page(title, blocks, "Damping from free decay")


def damper_page(found: DamperResult, curve: DamperCurve, findings: Sequence[Finding], *, title: str) -> Page:
    """Put a fitted damper law on a page, with the loops that it was fitted to.

    Parameters
    ----------
    found : DamperResult
        As :func:`jounce.fit_damper` gives it.
    curve : DamperCurve
        Measured and fitted force side by side.
    findings : sequence of Finding
        What weakens the numbers.
    title : str
        Head of the page.

    Returns
    -------
    Page
        To be written with :data:`jounce.report.REPORTS`.
    """
    rows = tuple(
        (name.replace("_", " "), *estimate_cells(one, found.units[name])) for name, one in found.parameters.items()
    )
    note = (
        f"Residual {percent(found.nrmse)} of the force range, {quantity(found.rms_residual, 'N', 3)} r.m.s.; energy "
        f"per cycle {quantity(found.energy_per_cycle, 'J')}, fitted {quantity(found.fitted_energy_per_cycle, 'J')}."
    )
    counted = (
        f"{found.samples} samples of {found.cycles:g} cycles. In the record the stroke is positive in "
        f"{found.stroke_positive}, the force in {found.force_positive}; the law is positive in compression."
    )
    words = "Force against velocity and against displacement, measured and fitted."
    picture = Picture(figure_of(curve, law=found.law), "damper", words, words)
    table = Table(f"Damper, {found.law} law", ESTIMATE, rows, "lrrrl", note)
    return _page(title, [table, Paragraph(counted, "muted"), *_said(findings), picture], f"Damper, {found.law} law")


def _said(findings: Sequence[Finding]) -> list[Block]:
    return [Findings(tuple(findings))] if findings else []


def _page(title: str, blocks: Sequence[Block], subtitle: str) -> Page:
    return Page(title, (Section("Answer", tuple(blocks)),), subtitle)
