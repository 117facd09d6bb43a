"""Page of speed limits: how fast each limit lets a vehicle drive, and every metric over speed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jounce.core.display import display_unit
from jounce.core.numbers import number, quantity
from jounce.core.tables import TextTable
from jounce.report.page import (
    Block,
    Page,
    Paragraph,
    answer_page,
    as_table,
    findings_blocks,
    picture_of,
)

if TYPE_CHECKING:
    from jounce.variants.limits import LimitCurve, SpeedLimits


def speed_limits_page(result: SpeedLimits, *, title: str) -> Page:
    """Create a page of speed limits.

    Parameters
    ----------
    result : SpeedLimits
        Result of :func:`jounce.find_speed_limits`.
    title : str
        Vehicle and road.

    Returns
    -------
    Page
        Page to be written with :data:`jounce.report.REPORTS`.
    """
    words = "Each metric over speed with its limit; of several heights also the limit speed over height."
    blocks: list[Block] = [
        as_table(_limits(result)),
        Paragraph(
            "A metric need not grow with speed: the limit speed is the lowest at which the limit is reached. "
            "What rises above a limit and falls again between two speeds that were driven is not seen.",
            "muted",
        ),
        picture_of(result, "speed-limits", words),
        *findings_blocks(result.findings),
    ]
    runs = sum(len(curve.speed) for curve in result.curves)
    return answer_page(title, blocks, f"{len(result.curves)} curves, {runs} values")


def _limits(result: SpeedLimits) -> TextTable:
    height, speed = display_unit("m", 0.1), display_unit("m/s")
    has_heights = result.heights != (None,)
    rows = []
    for curve in result.curves:
        at = curve.limit_speed
        cells = (
            curve.metric,
            quantity(curve.limit, curve.unit, 3),
            _speed_words(curve, at, speed.factor),
            ", ".join(number(item.speed * speed.factor, 3) for item in curve.crossings) or "–",
        )
        rows.append(
            (*([number((curve.height or 0.0) * height.factor, 4)] if has_heights else []), *cells)
        )
    header = ("metric", "limit", f"limit speed [{speed.name}]", f"crossings [{speed.name}]")
    return TextTable(
        "Limit speeds",
        (*([f"height [{height.name}]"] if has_heights else []), *header),
        rows,
        texts=(1, 2) if has_heights else (0, 1),
    )


def _speed_words(curve: LimitCurve, at: float | None, factor: float) -> str:
    """Write the limit speed; an open end where it lies beyond the speeds that were driven."""
    if at is None:
        return f"> {number(float(curve.speed[-1]) * factor, 3)}"
    is_below = at == float(curve.speed[0])
    return f"{'< ' if is_below else ''}{number(at * factor, 3)}"
