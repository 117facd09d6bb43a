"""History of one vehicle: values of each wheel at every inspection, and their trends."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from datetime import date
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from jounce.inspection.archive.entries import StoredRecord
    from jounce.inspection.archive.store import Store

QUANTITIES = ("adhesion", "phase_angle_min_deg", "theta_road")
_DAYS_OF_A_YEAR = 365.25  # Julian


@dataclass(frozen=True)
class WheelVisit:
    """One wheel at one inspection."""

    record: int  # number of the record in the store
    date: str
    plate: str
    axle: str
    wheel: str
    # ``adhesion`` (fraction), ``phase_angle_min_deg`` (degrees), ``theta_road`` (dimensionless)
    values: Mapping[str, float | None]
    verdict: str  # verdict of the wheel in the newest grading
    limits: str  # limits of the newest grading
    unreliable: tuple[
        str, ...
    ] = ()  # unreliable values, e.g. after lift-off, which are excluded from trends


@dataclass(frozen=True)
class Trend:
    """Trend of one value of one wheel."""

    axle: str
    wheel: str
    quantity: str
    # slope of the straight line through all visits (least squares), unit of the quantity per year
    change_per_year: float
    visits: int  # number of visits with a reliable value and a date


def history_of(store: Store, plate: str) -> list[WheelVisit]:
    """Return the measured values of every wheel of a vehicle by date.

    Case, spaces and hyphens of the number plate are ignored. The list is empty for an unknown plate; unreadable
    records are omitted.
    """
    return [visit for record in store.records(plate=plate) for visit in visits_of(record)]


def visits_of(record: StoredRecord) -> list[WheelVisit]:
    """Return the wheels of one record from its newest grading; empty if the record was unreadable."""
    if record.grading is None:
        return []
    wheels: list[dict[str, Any]] = record.grading.result.get("wheels", [])
    return [
        WheelVisit(
            record.number,
            record.date,
            record.plate,
            record.axle,
            wheel["wheel"],
            {name: wheel.get(name) for name in QUANTITIES},
            wheel["verdict"],
            record.grading.limits,
            tuple(name for name in wheel.get("unreliable", ()) if name in QUANTITIES),
        )
        for wheel in wheels
    ]


def trends_of(visits: Iterable[WheelVisit]) -> list[Trend]:
    """Return the trend of every value of each wheel that was inspected on at least two days.

    Examples
    --------
    >>> days = (("2024-11-21", 0.6), ("2025-11-21", 0.5), ("2026-11-21", 0.4))
    >>> visits = [WheelVisit(1, day, "B-AB 123", "rear", "left", {"adhesion": a}, "pass", "") for day, a in days]
    >>> [(trend.quantity, round(trend.change_per_year, 3), trend.visits) for trend in trends_of(visits)]
    [('adhesion', -0.1, 3)]
    """
    series: dict[tuple[str, str, str], list[tuple[int, float]]] = {}
    for visit in visits:
        day = day_number(visit.date)
        for name, value in visit.values.items():
            if value is not None and day is not None and name not in visit.unreliable:
                series.setdefault((visit.axle, visit.wheel, name), []).append((day, value))
    trends = []
    for (axle, wheel, name), points in series.items():
        days, values = np.array(points, dtype=float).T
        years = (days - days.mean()) / _DAYS_OF_A_YEAR
        if np.any(years != 0.0):
            slope = float(years @ values / (years @ years))
            trends.append(Trend(axle, wheel, name, slope, len(points)))
    return trends


def day_number(text: str) -> int | None:
    """Return the ordinal of an ISO 8601 day; None for other text."""
    try:
        return date.fromisoformat(text).toordinal()
    except ValueError:
        return None
