"""Grading of an inspection by limits: bands, verdicts and reasons for wheels, axles and the vehicle."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import Any

import numpy as np

from jounce.core.errors import RecordingError, unknown
from jounce.core.serialise import to_plain
from jounce.core.shown import Shown
from jounce.inspection.limits import VERDICTS, Criterion, Limits, VerdictBand, load_limits
from jounce.inspection.methods import METHODS, QUANTITIES
from jounce.inspection.quantities import Language
from jounce.inspection.quarter_car import steady_state
from jounce.inspection.reasons import Reason
from jounce.inspection.result import NOT_GRADED, Inspection, WheelResult, wheel_table


@dataclass(frozen=True)
class Difference:
    """Difference of one value between two wheels."""

    quantity: str
    first: float  # value of the first wheel, in the unit of the quantity
    second: float  # value of the second wheel, same unit
    absolute: float  # |first - second|, same unit
    # |first - second| / max(first, second) (1), values below 0 taken as 0; None if the greater value is not positive
    relative: float | None
    uncertainty: (
        float | None
    )  # half width of the 95 % interval of the absolute difference, same unit
    smaller: str  # wheel with the smaller value; empty for equal values
    relative_uncertainty: float | None = (
        None  # half width of the 95 % interval of the relative difference (1)
    )
    place: str = ""  # side of the car, for front and rear
    bands: dict[str, VerdictBand] = field(default_factory=dict)  # by name of the limit
    unreliable: tuple[
        str, ...
    ] = ()  # wheels or axles with an unreliable value, which prevents grading

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, with label and verdict by name of the limit."""
        grade = {
            name: {"label": band.label, "verdict": band.verdict}
            for name, band in self.bands.items()
        }
        return {
            "absolute": self.absolute,
            "relative": self.relative,
            "uncertainty": self.uncertainty,
            "relative_uncertainty": self.relative_uncertainty,
            "smaller": self.smaller,
            "unreliable": list(self.unreliable),
            "grade": grade,
        }


def difference_of(
    quantity: str, first: WheelResult, second: WheelResult, places: tuple[str, str], place: str = ""
) -> Difference | None:
    """Return the difference of a value between two wheels named ``places``; None if either value is missing.

    Examples
    --------
    >>> left, right = WheelResult("left", adhesion=0.6), WheelResult("right", adhesion=0.45)
    >>> found = difference_of("adhesion", left, right, ("left", "right"))
    >>> round(found.absolute, 3), round(found.relative, 3), found.smaller
    (0.15, 0.25, 'right')
    """
    a, b = first.value(quantity), second.value(quantity)
    if a is None or b is None or not (math.isfinite(a) and math.isfinite(b)):
        return None
    doubted = tuple(
        name
        for name, wheel in zip(places, (first, second), strict=True)
        if quantity in wheel.unreliable
    )
    halves = [wheel.uncertainty.get(quantity) for wheel in (first, second)]
    half = math.hypot(*halves) if None not in halves else None  # type: ignore[arg-type]
    gap, greatest, least = abs(a - b), max(a, b), max(min(a, b), 0.0)
    smaller = "" if a == b else places[0] if a < b else places[1]
    if greatest <= 0.0:
        return Difference(quantity, a, b, gap, None, half, smaller, place=place, unreliable=doubted)
    relative = None
    if None not in halves:
        of_least, of_greatest = halves if a < b else halves[::-1]
        relative = math.hypot(of_least, of_greatest * least / greatest) / greatest  # type: ignore[arg-type, operator]
    share = 1.0 - least / greatest
    return Difference(
        quantity, a, b, gap, share, half, smaller, relative, place, unreliable=doubted
    )


def grade_differences(
    differences: Sequence[Difference], limits: Limits, used: Sequence[str], across: str
) -> tuple[tuple[Difference, ...], list[Reason]]:
    """Find the bands of differences across ``"wheels"`` or ``"axles"``, and the reasons from the decisive limits.

    ``used`` lists the deciding methods; other limits are graded for information only. A difference belongs to the
    band that contains the lower end of its 95 % interval, so wheels are graded unequal only if that is certain. A
    difference of unreliable values has no band.
    """
    graded = {difference.quantity: difference for difference in differences}
    reasons: list[Reason] = []
    for name, criterion in limits.differences.items():
        difference = graded.get(criterion.quantity)
        if criterion.across != across or difference is None:
            continue
        absolute = criterion.definition == "absolute"
        value = difference.absolute if absolute else difference.relative
        half = difference.uncertainty if absolute else difference.relative_uncertainty
        band = sure = None if value is None else criterion.band_of(value)
        if value is not None and half is not None:
            sure = criterion.band_of(max(value - half, 0.0))
        counts = criterion.verified and bool(set(criterion.methods) & set(used))
        if difference.unreliable:
            if counts:
                about = {"criterion": criterion, "across": across, "places": difference.unreliable}
                reasons.append(Reason("unreliable_difference", "", about))
            continue
        if band is None or sure is None:
            if counts:
                reasons.append(Reason("no_difference", "", {"quantity": criterion.quantity}))
            continue
        graded[criterion.quantity] = replace(difference, bands={**difference.bands, name: sure})
        if counts:
            values = {
                "criterion": criterion, "value": value, "half": half, "band": sure, "verdict": sure.verdict,
                "across": across, "definition": criterion.definition,
            }  # fmt: skip
            reasons.append(Reason("difference" if sure is band else "may_be", sure.verdict, values))
    return tuple(graded.values()), sorted(
        reasons, key=lambda reason: {"fail": 0, "advise": 1}.get(reason.verdict, 2)
    )


USUAL_TYRE = 200e3
"""Stiffness of a typical car tyre, N/m, from the reference car on which the methods were compared."""
_ALIKE = 0.05  # relative difference from the typical tyre above which the tyre is given as a reason


def explain(wheel: WheelResult, bands: Mapping[str, VerdictBand], limits: Limits) -> list[Reason]:
    """Explain why methods disagree about a wheel, from its values and bands by method; empty if they agree."""
    if len({band.verdict for band in bands.values()}) < 2:
        return []
    reasons = [Reason("disagree", "", {"grades": tuple(bands.items())})]
    rank = {method: VERDICTS.index(band.verdict) for method, band in bands.items()}
    others = {method: value for method, value in rank.items() if method != "eusama"}
    if "eusama" in rank and all(value != rank["eusama"] for value in others.values()):
        reasons += _of_adhesion(wheel, limits)
    if "egea" in rank and "theta" in rank and rank["egea"] != rank["theta"]:
        reasons.append(Reason("limits_differ"))
    return reasons


def _of_adhesion(wheel: WheelResult, limits: Limits) -> list[Reason]:
    reasons = []
    limit = limits.methods["eusama"].passing_from()
    if wheel.lift_off or wheel.adhesion == 0.0:
        reasons.append(Reason("lifted"))
    elif (
        wheel.adhesion is not None
        and wheel.static_load is not None
        and limit is not None
        and limit < 1.0
    ):
        force = (1.0 - wheel.adhesion) * wheel.static_load
        values = {"force": force, "load": wheel.static_load, "needed": force / (1.0 - limit)}
        reasons.append(
            Reason("mass", "", {**values, "limit": limit, "criterion": limits.methods["eusama"]})
        )
    return reasons + _of_tyre(wheel)


def _of_tyre(wheel: WheelResult) -> list[Reason]:
    """Return the adhesion with a typical tyre by the record's model; without a model, the tyre's general influence."""
    amplitude = np.nan
    if wheel.curves is not None and wheel.curves.plate_amplitude.size:
        amplitude = float(np.nanmax(wheel.curves.plate_amplitude, initial=np.nan))
    if wheel.corner is None or not np.isfinite(amplitude):
        if wheel.tyre_rigidity is None:
            return []
        return [Reason("rigidity", "", {"rigidity": 1e-3 * wheel.tyre_rigidity})]
    stiffness = wheel.corner.tyre_stiffness
    if abs(stiffness / USUAL_TYRE - 1.0) < _ALIKE:
        return []
    usual = steady_state(
        replace(wheel.corner, tyre_stiffness=USUAL_TYRE), wheel.static_load, amplitude=amplitude
    )
    values = {"usual": 1e-3 * USUAL_TYRE, "stiffness": 1e-3 * stiffness}
    return [
        Reason(
            "tyre", "", {**values, "adhesion": usual.adhesion, "phase": usual.phase_angle_min_deg}
        )
    ]


_SIDES = ("left", "right")


@dataclass(frozen=True)
class WheelGrade:
    """Grading of one wheel."""

    wheel: str  # ``left`` or ``right``
    bands: dict[str, VerdictBand]  # by method; methods without a value or limits are missing
    verdict: str  # ``pass``, ``advise``, ``fail`` or ``not graded``
    reasons: tuple[Reason, ...]  # deciding reasons first


@dataclass(frozen=True)
class GradedInspection(Shown):
    """An inspection of one axle with its grading.

    Attributes
    ----------
    inspection : Inspection
        The same values with grade, verdict and English reasons added to wheels and axle.
    limits : Limits
        Limits used for the grading.
    grades : tuple of WheelGrade
        Gradings in the order of the wheels.
    differences : tuple of Difference
        Differences between the wheels.
    verdict : str
        Verdict of the tested wheels of the axle.
    reasons : tuple of Reason
        Reasons for the axle's verdict.
    deciding : tuple of str
        Methods whose grade counts.
    """

    inspection: Inspection
    limits: Limits
    grades: tuple[WheelGrade, ...]
    differences: tuple[Difference, ...]
    verdict: str
    reasons: tuple[Reason, ...]
    deciding: tuple[str, ...]

    def __str__(self) -> str:
        reasons = [
            f"{grade.wheel}: {reason.text()}" for grade in self.grades for reason in grade.reasons
        ]
        reasons += [f"axle: {reason.text()}" for reason in self.reasons]
        return "\n".join(
            [str(wheel_table(f"{self.axle or 'axle'}: {self.verdict}", self.wheels)), *reasons]
        )

    @property
    def wheels(self) -> tuple[WheelResult, ...]:
        """Results of the wheels with their grading."""
        return self.inspection.wheels

    @property
    def axle(self) -> str:
        """``front``, ``rear``, or empty if the record does not name the axle."""
        return str(self.inspection.axle.get("axle", ""))

    def grade_of(self, wheel: str) -> WheelGrade | None:
        """Return the grading of ``"left"`` or ``"right"``; None if it was not tested."""
        return next((grade for grade in self.grades if grade.wheel == wheel), None)

    def to_dict(self) -> dict[str, Any]:
        """Return a plain JSON object ``{wheels: [...], axle: {...}, limits: {...}, verdict: ..., reasons: [...]}``."""
        return {
            **self.inspection.to_dict(),
            "deciding": list(self.deciding),
            "limits": _about(self.limits),
            "verdict": self.verdict,
            "reasons": [reason.text() for reason in self.reasons],
        }


@dataclass(frozen=True)
class VehicleGrade:
    """Grading of a vehicle from one or two axles.

    Attributes
    ----------
    axles : tuple of GradedInspection
        Graded axles, front before rear.
    differences : tuple of Difference
        Differences between front and rear of each side.
    verdict : str
        Verdict of the tested axles of the vehicle.
    reasons : tuple of Reason
        Reasons for the verdict.
    """

    axles: tuple[GradedInspection, ...]
    differences: tuple[Difference, ...] = ()
    verdict: str = NOT_GRADED
    reasons: tuple[Reason, ...] = field(default_factory=tuple)

    def to_dict(self) -> dict[str, Any]:
        """Return a plain JSON object ``{axles: [...], differences: {...}, verdict: ..., reasons: [...]}``."""
        return {"axles": [axle.to_dict() for axle in self.axles], **self.summary()}

    def summary(self) -> dict[str, Any]:
        """Return a plain JSON object about the whole vehicle."""
        sides: dict[str, dict[str, Any]] = {}
        for difference in self.differences:
            sides.setdefault(difference.place, {})[difference.quantity] = to_plain(
                difference.to_dict()
            )
        return {
            "verdict": self.verdict,
            "reasons": [reason.text() for reason in self.reasons],
            "differences": sides,
        }


def _about(limits: Limits) -> dict[str, str]:
    return {
        "name": limits.name, "version": limits.version, "date": limits.date, "source": limits.source,
        "digest": limits.digest, "label": limits.label,
    }  # fmt: skip


def worst(verdicts: Iterable[str]) -> str:
    """Return the worst verdict: any failure decides; otherwise any ungraded part makes the result not graded.

    Examples
    --------
    >>> worst(["pass", "advise"]), worst(["pass", "not graded"]), worst(["not graded", "fail"]), worst([])
    ('advise', 'not graded', 'fail', 'not graded')
    """
    listed = list(verdicts)
    if "fail" in listed:
        return "fail"
    if not listed or NOT_GRADED in listed:
        return NOT_GRADED
    return max(listed, key=VERDICTS.index)


def grade(
    inspection: Inspection, limits: Limits | None = None, deciding: Sequence[str] | None = None
) -> GradedInspection:
    """Grade the wheels of an inspection, and the axle.

    Parameters
    ----------
    inspection : Inspection
        As returned by ``evaluate``.
    limits : Limits, optional
        Limits to apply; by default the shipped ones.
    deciding : sequence of {"eusama", "egea", "theta", "boge"}, optional
        Methods that determine the verdict: a wheel that lacks one of them is not graded. By default all evaluated
        methods with a value. Other methods are graded for information; the reasons explain disagreements. Unverified
        limits do not affect the verdict.

    Returns
    -------
    GradedInspection
        The worst band decides. Ungradable wheels and axles have the verdict ``"not graded"`` with its reasons.

    Raises
    ------
    DescriptionError
        For an unknown method.

    Examples
    --------
    >>> wheel = WheelResult("left", static_load=4300.0, adhesion=0.34, phase_angle_min_deg=51.0)
    >>> graded = grade(Inspection((wheel,), methods=("eusama", "egea")), deciding=["egea"])
    >>> graded.wheels[0].verdict, graded.wheels[0].grade
    ('pass', {'eusama': 'insufficient', 'egea': 'sufficient'})
    """
    chosen = limits if limits is not None else load_limits()
    for method in deciding or ():
        if method not in METHODS:
            raise unknown(method, METHODS, what="method")
    counted = None if deciding is None else tuple(deciding)
    grades = tuple(_grade_wheel(wheel, inspection, chosen, counted) for wheel in inspection.wheels)
    firm = [
        method for method in METHODS if method in chosen.methods and chosen.methods[method].verified
    ]
    used = (
        counted
        if counted is not None
        else tuple(m for m in firm if any(m in wheel_grade.bands for wheel_grade in grades))
    )
    differences, about = _between_wheels(inspection, grades, chosen, used)
    reasons = (*_axle_reasons(grades), *about)
    verdicts = [
        *(wheel_grade.verdict for wheel_grade in grades),
        *(reason.verdict for reason in about if reason.verdict),
    ]
    verdict = worst(verdicts)
    return GradedInspection(
        _with_grades(inspection, grades, differences, verdict, reasons),
        chosen, grades, differences, verdict, reasons, used,
    )  # fmt: skip


def _with_grades(
    inspection: Inspection,
    grades: tuple[WheelGrade, ...],
    differences: tuple[Difference, ...],
    verdict: str,
    reasons: tuple[Reason, ...],
) -> Inspection:
    wheels = tuple(
        replace(
            wheel,
            grade={method: band.label for method, band in wheel_grade.bands.items()},
            verdict=wheel_grade.verdict,
            reasons=sentences_of(wheel_grade.reasons),
            german={
                "grade": {method: band.words("de") for method, band in wheel_grade.bands.items()},
                "reasons": sentences_of(wheel_grade.reasons, "de"),
            },
        )
        for wheel, wheel_grade in zip(inspection.wheels, grades, strict=True)
    )
    by_quantity = {difference.quantity: difference.to_dict() for difference in differences}
    axle = {
        **inspection.axle,
        "differences": by_quantity,
        "verdict": verdict,
        "reasons": list(sentences_of(reasons)),
    }
    axle["german"] = {"reasons": list(sentences_of(reasons, "de"))}
    return replace(inspection, wheels=wheels, axle=axle)


def sentences_of(reasons: Iterable[Reason], language: Language = "en") -> tuple[str, ...]:
    """Write reasons as sentences."""
    return tuple(reason.text(language) for reason in reasons)


def _grade_wheel(
    wheel: WheelResult, inspection: Inspection, limits: Limits, deciding: tuple[str, ...] | None
) -> WheelGrade:
    unfit = [item for item in (*wheel.findings, *inspection.findings) if item.severity == "problem"]
    if unfit:
        by_message = {item.message: item for item in reversed(unfit)}
        reasons_ = tuple(
            Reason("finding", NOT_GRADED, {"finding": item})
            for item in reversed(by_message.values())
        )
        return WheelGrade(wheel.wheel, {}, NOT_GRADED, reasons_)
    bands: dict[str, VerdictBand] = {}
    reasons: dict[str, list[Reason]] = {}
    for method in dict.fromkeys((*(inspection.methods or limits.methods), *(deciding or ()))):
        band, reasons[method] = _by_method(wheel, method, limits)
        if band is not None:
            bands[method] = band
    firm = {method: band for method, band in bands.items() if limits.methods[method].verified}
    used = deciding if deciding is not None else tuple(firm)
    conditions = [condition for condition in _conditions(wheel, limits, used) if bands]
    failed = (
        ()
        if any(m in firm for m in used)
        else tuple(m for m, band in firm.items() if band.verdict == "fail")
    )
    if failed:
        conditions.append(Reason("counts", "fail", {"methods": failed}))
    verdict = worst(
        [*(firm[m].verdict if m in firm else NOT_GRADED for m in used), *_verdicts(conditions)]
    )
    order = sorted(reasons, key=lambda m: (m not in used, -_severity(bands.get(m))))
    listed = [reason for method in order for reason in reasons[method]] + conditions
    if any(method not in used for method in bands) and any(method in firm for method in used):
        listed.append(Reason("deciding", "", {"methods": used}))
    return WheelGrade(wheel.wheel, bands, verdict, (*listed, *explain(wheel, firm, limits)))


def _severity(band: VerdictBand | None) -> int:
    return len(VERDICTS) if band is None else VERDICTS.index(band.verdict)


def _verdicts(reasons: Iterable[Reason]) -> list[str]:
    return [reason.verdict for reason in reasons if reason.verdict]


def _by_method(
    wheel: WheelResult, method: str, limits: Limits
) -> tuple[VerdictBand | None, list[Reason]]:
    """Return the band of a wheel by one method, and the reasons."""
    criterion = limits.methods.get(method)
    if criterion is None:
        return None, [Reason("unlimited", NOT_GRADED, {"method": method})]
    value = wheel.value(criterion.quantity)
    about = {"criterion": criterion, "method": method}
    if value is None or value != value:  # noqa: PLR0124 - not a number
        return None, [Reason("missing", NOT_GRADED, about)]
    half = wheel.uncertainty.get(criterion.quantity)
    about |= {"value": value, "half": half}
    band = criterion.band_of(value) or _lowest_band(criterion, value, half)
    if band is None:
        return None, [Reason("outside", NOT_GRADED, about)]
    if not criterion.verified:
        return band, [Reason("unverified", "", {**about, "band": band})]
    reasons = [Reason("band", band.verdict, {**about, "band": band, "verdict": band.verdict})]
    if band.note == "over_range":
        reasons.append(Reason("over_range", "", {**about, "limit": band.start}))
    if criterion.quantity in wheel.unreliable:
        reasons.append(Reason("unreliable", "", {"criterion": criterion, "method": method}))
    return band, reasons + near_edges(criterion, value, half, method)


def _lowest_band(criterion: Criterion, value: float, half: float | None) -> VerdictBand | None:
    """Return the lowest band for a value below it whose 95 % interval (half width in the same unit) overlaps it."""
    lowest = criterion.bands[0]
    return lowest if half is not None and value < lowest.start <= value + half else None


def near_edges(criterion: Criterion, value: float, half: float | None, method: str) -> list[Reason]:
    """Return a reason for each limit within the 95 % interval of a value (half width in the criterion's unit)."""
    if half is None:
        return []
    low, high = value - half, value + half
    return [
        Reason(
            "near",
            "",
            {"criterion": criterion, "method": method, "low": low, "high": high, "limit": edge},
        )
        for edge in criterion.edges()
        if low < edge <= high
    ]


def _conditions(wheel: WheelResult, limits: Limits, used: Sequence[str]) -> list[Reason]:
    """Return reasons for conditions of the used methods that fail or may fail."""
    reasons = []
    for condition in limits.conditions.values():
        value, needed = (
            wheel.value(condition.quantity),
            [method for method in condition.methods if method in used],
        )
        if value is None or not needed:
            continue
        band, half = condition.band_of(value), wheel.uncertainty.get(condition.quantity)
        if band is not None and band.verdict != "pass":
            values = {
                "criterion": condition,
                "value": value,
                "half": half,
                "band": band,
                "verdict": band.verdict,
            }
            reasons.append(Reason("condition", band.verdict, values))
        reasons += near_edges(condition, value, half, needed[0])
    return reasons


def _between_wheels(
    inspection: Inspection, grades: tuple[WheelGrade, ...], limits: Limits, used: Sequence[str]
) -> tuple[tuple[Difference, ...], list[Reason]]:
    if len(grades) < len(_SIDES) or any(not wheel.is_gradable for wheel in inspection.wheels):
        return (), []
    left, right = (inspection.wheel(side) for side in _SIDES)
    differences = differences_of(left, right, ("left", "right"))
    return grade_differences(differences, limits, used, "wheels")


def differences_of(
    first: WheelResult, second: WheelResult, places: tuple[str, str], place: str = ""
) -> list[Difference]:
    """Return differences of all values that both wheels have; ``places`` are the names of the two wheels."""
    differences = (difference_of(name, first, second, places, place) for name in QUANTITIES)
    return [difference for difference in differences if difference is not None]


def _axle_reasons(grades: tuple[WheelGrade, ...]) -> list[Reason]:
    tested = {wheel_grade.wheel for wheel_grade in grades}
    missing = [Reason("one_wheel", "", {"missing": side}) for side in _SIDES if side not in tested]
    return missing + [
        Reason(
            "wheel",
            wheel_grade.verdict,
            {"wheel": wheel_grade.wheel, "verdict": wheel_grade.verdict},
        )
        for wheel_grade in grades
    ]


def grade_vehicle(axles: Sequence[GradedInspection]) -> VehicleGrade:
    """Combine the gradings of a vehicle's axles.

    Parameters
    ----------
    axles : sequence of GradedInspection
        One or two, of different axles, graded by the same limits.

    Returns
    -------
    VehicleGrade
        Verdict of the tested axles, and differences between front and rear of each side.

    Raises
    ------
    RecordingError
        If both records are of the same axle, do not name their axle, or were graded by different limits.
    """
    ordered = sorted(axles, key=lambda axle: axle.axle)  # front, rear
    for first, second in combinations(ordered, 2):
        _check_pair(first, second)
    reasons = [
        Reason("axle", axle.verdict, {"axle": axle.axle, "verdict": axle.verdict})
        for axle in ordered
    ]
    differences: list[Difference] = []
    verdicts = [axle.verdict for axle in ordered]
    if len(ordered) == 2:
        for side in _SIDES:
            pair = [
                [wheel for wheel in axle.wheels if wheel.wheel == side and wheel.is_gradable]
                for axle in ordered
            ]
            if all(pair):
                side_differences = differences_of(pair[0][0], pair[1][0], ("front", "rear"), side)
                graded, about = grade_differences(
                    side_differences, ordered[0].limits, ordered[0].deciding, "axles"
                )
                differences += graded
                reasons += about
                verdicts += _verdicts(about)
    return VehicleGrade(tuple(ordered), tuple(differences), worst(verdicts), tuple(reasons))


def _check_pair(first: GradedInspection, second: GradedInspection) -> None:
    if not first.axle or not second.axle:
        raise RecordingError(
            "records of two axles must state their axle",
            where="axle", found="none", allowed="front, rear", hint='Write a line # axle = "front" before the columns.',
        )  # fmt: skip
    if first.axle == second.axle:
        raise RecordingError(
            "two records of the same axle",
            where="axle",
            found=first.axle,
            allowed="one per axle",
        )
    if first.limits.digest != second.limits.digest:
        raise RecordingError("the axles were graded by different limits", where="limits")
