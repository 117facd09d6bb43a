"""Page of the test results of one vehicle over the years."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.inspection.methods import QUANTITIES
from jounce.inspection.reasons import verdict_words
from jounce.plots.display import number
from jounce.plots.inspection import vehicle_history
from jounce.report.page import Block, Cell, Page, PageTable, Picture, Section, Tone

if TYPE_CHECKING:
    from collections.abc import Sequence

    from jounce.inspection.archive.history import Trend, WheelVisit

_TONES: dict[str, Tone] = {"pass": "good", "fail": "bad"}


def history_page(visits: Sequence[WheelVisit], trends: Sequence[Trend], *, title: str) -> Page:
    """Create a page of the history of one vehicle: trends of its values, then all visits.

    Parameters
    ----------
    visits : sequence of WheelVisit
        Result of :func:`jounce.inspection.archive.history.history_of`.
    trends : sequence of Trend
        Result of :func:`jounce.inspection.archive.history.trends_of`.
    title : str
        Number plate and vehicle.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.

    Examples
    --------
    >>> from jounce.inspection.archive.history import WheelVisit
    >>> visit = WheelVisit(1, "2026-11-21", "B-AB 123", "rear", "left", {"adhesion": 0.6}, "pass", "")
    >>> [section.title for section in history_page([visit], [], title="B-AB 123").sections]
    ['Answer', 'Visits']
    """
    words = "Adhesion, minimum phase angle and damping ratio of every wheel against the date."
    answer: list[Block] = [Picture(lambda: vehicle_history(visits), "history", words, words)]
    if trends:
        rows = tuple(
            (f"{trend.axle} {trend.wheel}".strip(), *_change(trend), str(trend.visits))
            for trend in trends
            if trend.quantity in QUANTITIES
        )
        answer.insert(
            0, PageTable("Change per year", ("wheel", "value", "per year", "visits"), rows, "llrr")
        )
    names = list(
        dict.fromkeys(name for visit in visits for name in visit.values if name in QUANTITIES)
    )
    every = tuple(
        (
            visit.date or "–",
            f"{visit.axle} {visit.wheel}".strip(),
            *(_value(visit, name) for name in names),
            Cell(verdict_words(visit.verdict), _TONES.get(visit.verdict, "fair"))
            if visit.verdict
            else "–",
            str(visit.record),
        )
        for visit in visits
    )
    header = ("date", "wheel", *(QUANTITIES[name].words() for name in names), "verdict", "record")
    table = PageTable(
        "Every wheel at every visit, by the newest grading",
        header,
        every,
        "ll" + "r" * len(names) + "lr",
    )
    return Page(
        title,
        (Section("Answer", tuple(answer)), Section("Visits", (table,))),
        "History of the shock absorbers",
    )


def _value(visit: WheelVisit, name: str) -> str:
    return QUANTITIES[name].text(visit.values.get(name)) + (
        " (unreliable)" if name in visit.unreliable else ""
    )


def _change(trend: Trend) -> tuple[str, str]:
    quantity = QUANTITIES[trend.quantity]
    sign = "+" if trend.change_per_year > 0.0 else ""
    return (
        quantity.words(),
        f"{sign}{number(trend.change_per_year * quantity.factor, 2)} {quantity.unit}".strip(),
    )
