"""Pages of shock absorber tests: wheels side by side, and one wheel over the wear of its damper."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.inspection.quantities import NUMBERS
from jounce.inspection.reasons import verdict_words
from jounce.inspection.result import wheel_table
from jounce.plots.display import number
from jounce.report.page import (
    Block,
    Bullets,
    Fact,
    Facts,
    Findings,
    Page,
    PageTable,
    Section,
    Tone,
    as_table,
)

if TYPE_CHECKING:
    from collections.abc import Sequence

    from jounce.inspection.grading import GradedInspection, VehicleGrade
    from jounce.inspection.result import WheelResult
    from jounce.inspection.rig_inspection import InspectedRig

TONES: dict[str, Tone] = {"pass": "good", "advise": "fair", "fail": "bad"}
"""Meaning of the verdicts."""


def inspection_page(vehicle: VehicleGrade, *, title: str) -> Page:
    """Create a page of the graded axles of a vehicle: values of the wheels, reasons, findings.

    Parameters
    ----------
    vehicle : VehicleGrade
        Result of :func:`jounce.inspection.grading.grade_vehicle`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    sections = [Section(graded.axle or "axle", axle_blocks(graded)) for graded in vehicle.axles]
    if len(vehicle.axles) > 1:
        sections.append(Section("Vehicle", (_verdict("vehicle", vehicle.verdict),)))
    return Page(title, tuple(sections))


def axle_blocks(graded: GradedInspection) -> tuple[Block, ...]:
    """Return the blocks of a graded axle, values first."""
    decides = ", ".join(graded.deciding)
    title = f"{graded.axle or 'axle'}: {graded.verdict} (deciding: {decides}; limits: {graded.limits.label})"
    reasons = [
        f"{grade.wheel}: {reason.text()}" for grade in graded.grades for reason in grade.reasons
    ]
    reasons += [f"axle: {reason.text()}" for reason in graded.reasons]
    weakening = [
        finding
        for wheel in graded.wheels
        for finding in wheel.findings
        if finding.severity != "problem"
    ]
    blocks = (
        as_table(wheel_table(title, graded.wheels)),
        Bullets(tuple(reasons)),
        Findings((*graded.inspection.findings, *weakening)),
    )
    return tuple(block for block in blocks if isinstance(block, PageTable) or block.items)


def wheel_page(wheel: WheelResult, *, title: str) -> Page:
    """Create a page of the test of one wheel.

    Parameters
    ----------
    wheel : WheelResult
        Graded result of the test.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    blocks = (
        as_table(wheel_table(f"{wheel.wheel} wheel", [wheel])),
        _verdict("verdict", wheel.verdict),
        Bullets(wheel.reasons),
        Findings(wheel.findings),
    )
    return Page(title, (Section("Answer", blocks),))


def wear_page(wear: Sequence[float], wheels: Sequence[WheelResult], *, title: str) -> Page:
    """Create a page of the tests of one wheel over the wear of its damper.

    Parameters
    ----------
    wear : sequence of float
        Fraction of damping lost [1], for each test.
    wheels : sequence of WheelResult
        Results of the tests.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    shown = [
        quantity
        for name, quantity in NUMBERS.items()
        if any(wheel.value(name) is not None for wheel in wheels)
    ]
    rows = tuple(
        (
            number(lost, 3),
            *(quantity.text(wheel.value(quantity.name), with_unit=False) for quantity in shown),
            wheel.verdict,
        )
        for lost, wheel in zip(wear, wheels, strict=True)
    )
    header = ("wear", *(quantity.label() for quantity in shown), "verdict")
    table = PageTable("Over damper wear", header, rows, "r" * (len(shown) + 1) + "l")
    return Page(title, (Section("Answer", (table,)),))


def inspected_rig_page(found: InspectedRig, *, title: str) -> Page:
    """Create a page of a simulated test: one wheel, one wheel over damper wear, or the two wheels of an axle."""
    from jounce.inspection.grading import grade_vehicle

    if found.axle is not None:
        return inspection_page(grade_vehicle([found.axle]), title=title)
    wheels = [test.wheel for test in found.tests]
    return (
        wear_page(found.wear, wheels, title=title)
        if found.is_range
        else wheel_page(wheels[0], title=title)
    )


def _verdict(label: str, verdict: str) -> Facts:
    return Facts((Fact(label, verdict_words(verdict), tone=TONES.get(verdict, "plain")),))
