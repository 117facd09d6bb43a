"""Differences between two wheels, in both definitions in use."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from jounce.inspection.result import WheelResult
from jounce.inspection.verdicts.limits import Band, Limits
from jounce.inspection.verdicts.reasons import Reason


@dataclass(frozen=True)
class Difference:
    """Difference of one value between two wheels.

    Attributes
    ----------
    quantity : str
        Which value.
    first, second : float
        Of both wheels, in the unit of the quantity.
    absolute : float
        |first - second|, same unit.
    relative : float or None
        |first - second| / max(first, second) (1); None where the greater value is not above 0.
    uncertainty : float or None
        Half width of the 95 % interval of the absolute difference, same unit.
    smaller : str
        Which wheel has the smaller value; empty for equal values.
    place : str
        Side of the car, for front and rear.
    bands : dict of str to Band
        By name of the limit.
    """

    quantity: str
    first: float
    second: float
    absolute: float
    relative: float | None
    uncertainty: float | None
    smaller: str
    place: str = ""
    bands: dict[str, Band] = field(default_factory=dict)

    def to_dict(self) -> dict[str, Any]:
        """Plain values and, by the name of the limit, label and verdict."""
        grade = {name: {"label": band.label, "verdict": band.verdict} for name, band in self.bands.items()}
        return {
            "absolute": self.absolute,
            "relative": self.relative,
            "uncertainty": self.uncertainty,
            "smaller": self.smaller,
            "grade": grade,
        }


def difference_of(
    quantity: str, first: WheelResult, second: WheelResult, places: tuple[str, str], place: str = ""
) -> Difference | None:
    """Difference of a value between two wheels called ``places``; None where one of them has no value.

    Examples
    --------
    >>> left, right = WheelResult("left", adhesion=0.6), WheelResult("right", adhesion=0.45)
    >>> found = difference_of("adhesion", left, right, ("left", "right"))
    >>> round(found.absolute, 3), round(found.relative, 3), found.smaller
    (0.15, 0.25, 'right')
    """
    a, b = getattr(first, quantity), getattr(second, quantity)
    if a is None or b is None or not (math.isfinite(a) and math.isfinite(b)):
        return None
    halves = [one.uncertainty.get(quantity) for one in (first, second)]
    half = math.hypot(*halves) if None not in halves else None  # type: ignore[arg-type]
    gap, greatest = abs(a - b), max(a, b)
    smaller = "" if a == b else places[0] if a < b else places[1]
    return Difference(quantity, a, b, gap, gap / greatest if greatest > 0.0 else None, half, smaller, place)


def grade_differences(
    differences: Sequence[Difference], limits: Limits, used: Sequence[str], across: str
) -> tuple[tuple[Difference, ...], list[Reason]]:
    """Find the bands of differences.

    Parameters
    ----------
    differences : sequence of Difference
        Between two wheels.
    limits : Limits
        Their criteria.
    used : sequence of str
        Methods that decide; limits that belong to none of them only name their band.
    across : {"wheels", "axles"}
        What is compared.

    Returns
    -------
    differences : tuple of Difference
        With their bands.
    reasons : list of Reason
        Of the limits that count.
    """
    graded = {one.quantity: one for one in differences}
    reasons: list[Reason] = []
    for name, criterion in limits.differences.items():
        one = graded.get(criterion.quantity)
        if criterion.across != across or one is None:
            continue
        value = one.absolute if criterion.definition == "absolute" else one.relative
        band = None if value is None else criterion.band_of(value)
        counts = criterion.verified and bool(set(criterion.methods) & set(used))
        if band is None:
            if counts:
                reasons.append(Reason("no_difference", "", {"quantity": criterion.quantity}))
            continue
        graded[criterion.quantity] = replace(one, bands={**one.bands, name: band})
        if counts:
            values = {
                "criterion": criterion, "value": value, "band": band, "verdict": band.verdict,
                "across": across, "definition": criterion.definition,
            }  # fmt: skip
            reasons.append(Reason("difference", band.verdict, values))
    return tuple(graded.values()), sorted(reasons, key=lambda one: {"fail": 0, "advise": 1}.get(one.verdict, 2))
