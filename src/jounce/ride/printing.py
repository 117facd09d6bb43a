"""Ride metrics as text: one table a kind of place, reasons and findings said once."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from jounce.core.text import aligned
from jounce.ride.catalogue import CATALOGUE

if TYPE_CHECKING:
    from jounce.ride.metrics import AbsentMetric, MetricValue, RideMetrics

_KINDS = (("motion", "comfort"), ("rotation",), ("corner",))


def metrics_text(found: RideMetrics) -> str:
    """Tables of all values (SI) by place, totals in words, what is absent, findings."""
    left_out = f" ({found.settling:g} s left out)" if found.settling else ""
    lines = [f"Ride metrics of {found.duration:g} s at {found.sample_rate:g} Hz{left_out}"]
    scope = {row.name: row.scope for row in CATALOGUE}
    for kind in _KINDS:
        lines += _table([item for item in found.values if scope[item.metric] in kind])
    for item in found.values:
        if scope[item.metric] == "point":
            lines.append(f"{item.metric} {item.place}: {item.value:.4g} {item.unit}, {found.comfort[item.place]}")
    lines += _absences(found.absent)
    return "\n".join([*lines, *map(str, found.findings)])


def _table(values: Sequence[MetricValue]) -> list[str]:
    """Metrics below each other, places beside each other."""
    places = list(dict.fromkeys(item.place for item in values))
    cells = {(item.metric, item.place): f"{item.value:.4g}" for item in values}
    names = {item.metric: item.unit for item in values}
    rows = [["", "", *places]] if any(places) else []
    rows += [[name, unit, *(cells.get((name, place), "–") for place in places)] for name, unit in names.items()]
    return aligned(rows, left=2)


def _absences(absent: Iterable[AbsentMetric]) -> list[str]:
    """One line a reason, with all metrics that it concerns; where only some places lack them, those places."""
    names: dict[tuple[str, tuple[str, ...]], list[str]] = {}
    places: dict[tuple[str, str], list[str]] = {}
    for item in absent:
        reason = item.reason.replace(f"channel {item.place}.", "channel ") if item.place else item.reason
        places.setdefault((item.metric, reason), []).append(item.place)
    for (metric, reason), corners in places.items():
        names.setdefault((reason, tuple(corners)), []).append(metric)
    lines = []
    for (reason, where), metrics in names.items():
        there = f" ({', '.join(where)})" if any(where) else ""
        lines.append(f"absent: {', '.join(metrics)}{there}: {reason}")
    return lines
