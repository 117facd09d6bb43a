"""Page that compares three tests of the same car: sound dampers rejected, worn dampers passed, and influences."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.plots.display import number, percent
from jounce.plots.inspection import equivalence
from jounce.report.page import Block, Cell, Page, PageTable, Paragraph, Picture, Section

if TYPE_CHECKING:
    from jounce.inspection.equivalence import Equivalence, Factor


def equivalence_page(study: Equivalence, *, title: str) -> Page:
    """Create a page that compares adhesion, phase angle and THETA.

    Parameters
    ----------
    study : Equivalence
        Result of :func:`jounce.inspection.equivalence.compare_tests`.
    title : str
        Heading of the page.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
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
    words = "Wear above which each method rejects, against each varied quantity; dots at the top: never rejected."
    table = PageTable("Where the tests disagree with the damper", header, rows)
    answer: tuple[Block, ...] = (table, Paragraph(about, "muted"))
    curves = Section(
        "Influence of varied quantities",
        (Picture(lambda: equivalence(study), "equivalence", words, words),),
    )
    return Page(
        title,
        (Section("Answer", answer), curves),
        "Adhesion, phase angle and THETA of the same wheel",
    )


def _range(factor: Factor, ends: tuple[float, float] | None) -> str:
    return " to ".join(number(factor.scale * end) for end in dict.fromkeys(ends or ())) or "–"
