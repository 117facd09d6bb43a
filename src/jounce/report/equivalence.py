"""Three tests of the same car as a page: where they reject sound dampers or pass worn ones, then over what varies."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.plots.display import number, percent
from jounce.plots.inspection import equivalence
from jounce.report.page import Block, Cell, Page, PageTable, Paragraph, Picture, Section

if TYPE_CHECKING:
    from jounce.inspection.equivalence import Equivalence, Factor


def equivalence_page(study: Equivalence, *, title: str) -> Page:
    """Put a comparison of adhesion, phase angle and THETA on a page.

    Parameters
    ----------
    study : Equivalence
        As :func:`jounce.inspection.equivalence.compare_tests` gives it.
    title : str
        Head of the page.

    Returns
    -------
    Page
        To be written with :data:`jounce.report.REPORTS`.
    """
    from jounce.inspection.equivalence import SOUND, WORN

    factors = {factor.name: factor for factor in study.factors}
    rows = tuple(
        (
            factors[case.factor].label,
            case.method.upper(),
            Cell(
                f"{case.rejected_sound} of {case.sound}", "fair" if case.rejected_sound else "plain"
            ),
            _range(factors[case.factor], case.rejected_at),
            Cell(f"{case.passed_worn} of {case.worn}", "fair" if case.passed_worn else "plain"),
            _range(factors[case.factor], case.passed_at),
        )
        for case in study.disagreements
    )
    header = ("varied", "method", "sound rejected", "at", "worn passed", "at")
    about = (
        f"A sound damper has lost up to {percent(SOUND, 0)} of its damping, a worn one {percent(WORN, 0)} or more "
        f"(estimated). {study.tests} simulated tests, limits {study.limits}."
    )
    words = "Wear from which each method rejects, over each quantity that varies; dots at the top: never rejected."
    table = PageTable("Where the tests disagree with the damper", header, rows)
    answer: tuple[Block, ...] = (table, Paragraph(about, "muted"))
    curves = Section(
        "Over what varies", (Picture(lambda: equivalence(study), "equivalence", words, words),)
    )
    return Page(
        title,
        (Section("Answer", answer), curves),
        "Adhesion, phase angle and THETA of the same wheel",
    )


def _range(factor: Factor, ends: tuple[float, float] | None) -> str:
    return " to ".join(number(factor.scale * end) for end in dict.fromkeys(ends or ())) or "–"
