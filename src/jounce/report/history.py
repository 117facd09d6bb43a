"""What the tests of one vehicle over the years found, as a page."""

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
    """Put the history of one vehicle on a page: how its values change, then every visit.

    Parameters
    ----------
    visits : sequence of WheelVisit
        As :func:`jounce.inspection.archive.history.history_of` gives them.
    trends : sequence of Trend
        As :func:`jounce.inspection.archive.history.trends_of` gives them.
    title : str
        Number plate and vehicle.

    Returns
    -------
    Page
        To be written with :data:`jounce.report.REPORTS`.

    Examples
    --------
    >>> from jounce.inspection.archive.history import WheelVisit
    >>> visit = WheelVisit(1, "2026-11-21", "B-AB 123", "rear", "left", {"adhesion": 0.6}, "pass", "")
    >>> [section.title for section in history_page([visit], [], title="B-AB 123").sections]
    ['Answer', 'Visits']
    """
    words = "Adhesion, least phase angle and damping ratio of every wheel against the date."
    answer: list[Block] = [Picture(lambda: vehicle_history(visits), "history", words, words)]
    if trends:
        rows = tuple(
            (f"{one.axle} {one.wheel}".strip(), *_change(one), str(one.visits))
            for one in trends
            if one.quantity in QUANTITIES
        )
        answer.insert(0, PageTable("Change per year", ("wheel", "value", "per year", "visits"), rows, "llrr"))
    names = list(dict.fromkeys(name for one in visits for name in one.values if name in QUANTITIES))
    every = tuple(
        (
            one.date or "–",
            f"{one.axle} {one.wheel}".strip(),
            *(_value(one, name) for name in names),
            Cell(verdict_words(one.verdict), _TONES.get(one.verdict, "fair")) if one.verdict else "–",
            str(one.record),
        )
        for one in visits
    )
    header = ("date", "wheel", *(QUANTITIES[name].words() for name in names), "verdict", "record")
    table = PageTable(
        "Every wheel at every visit, by the newest grading", header, every, "ll" + "r" * len(names) + "lr"
    )
    return Page(
        title, (Section("Answer", tuple(answer)), Section("Visits", (table,))), "History of the shock absorbers"
    )


def _value(one: WheelVisit, name: str) -> str:
    return QUANTITIES[name].text(one.values.get(name)) + (" (unreliable)" if name in one.unreliable else "")


def _change(one: Trend) -> tuple[str, str]:
    found = QUANTITIES[one.quantity]
    sign = "+" if one.change_per_year > 0.0 else ""
    return found.words(), f"{sign}{number(one.change_per_year * found.factor, 2)} {found.unit}".strip()
