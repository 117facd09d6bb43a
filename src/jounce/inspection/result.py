"""Result of an inspection: values per wheel with their uncertainty, curves, grades and reasons."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields
from typing import Any

from jounce.core.findings import Finding
from jounce.core.serialise import Plain, plain_table
from jounce.core.tables import TextTable
from jounce.core.types import Array
from jounce.inspection.quantities import NUMBERS, WheelQuantity
from jounce.inspection.quarter_car import LinearQuarterCar

NOT_GRADED = "not graded"


@dataclass(frozen=True)
class WheelCurves:
    """Values of a test over the frequency, by turns of the exciter in the order of time.

    Attributes
    ----------
    time : ndarray, shape (n,)
        When the plate was at the top, s.
    frequency : ndarray, shape (n,)
        Of the plate, Hz.
    least_force, greatest_force : ndarray, shape (n,)
        Of the tyre in that turn, after the filter of the turn, N.
    phase_deg : ndarray, shape (n,)
        Phase angle by EGEA in degrees: in the band and beside it the curve that the least one is taken from, elsewhere
        that of the single turn; NaN where it is not known.
    plate_amplitude : ndarray, shape (n,)
        Half the plate's stroke in that turn, m.
    """

    time: Array
    frequency: Array
    least_force: Array
    greatest_force: Array
    phase_deg: Array
    plate_amplitude: Array


@dataclass(frozen=True)
class WheelResult(Plain):
    """Values of one wheel from a record, SI; None if unknown, with the reason among the findings.

    Attributes
    ----------
    wheel : str
        ``left`` or ``right``.
    static_load : float or None
        N.
    adhesion : float or None
        Least over static tyre force (1); 0 where the tyre lifts off.
    adhesion_frequency_hz : float or None
        Where the force is least, Hz; the resonance of the wheel on this tester.
    phase_angle_min_deg : float or None
        Least EGEA phase angle within 6 to 18 Hz, ends included, in degrees.
    phase_frequency_hz : float or None
        Where it is, Hz.
    relative_force_amplitude : float or None
        Greatest force amplitude over static load (1).
    tyre_rigidity : float or None
        By EGEA, from the force at 25 Hz, N/m.
    theta_rig, theta_road : float or None
        Damping ratio (1) of the wheel on this tester and on the road (plate at rest), by parametric fit.
    lift_off : bool
        Whether the tyre left the plate.
    resonance_frequency_hz : float or None
        Where the plate (sprung) or the force (rigid) moves most, Hz.
    boge_amplitude : float or None
        Greatest movement of a sprung plate from lowest to highest point, m.
    theta_methods : mapping of str to float or None
        Damping ratio (1) on this tester by ``fit``, ``half_power``, ``amplification``, ``free_decay``.
    uncertainty : mapping of str to float
        Half width of the 95 % interval by key, in the unit of the value.
    unreliable : tuple of str
        Keys of values that another test of the same wheel may give quite differently, as after lift-off: they have no
        interval, and no difference to another wheel is graded by them.
    corner : LinearQuarterCar or None
        Linear quarter car fitted to the record.
    grade : mapping of str to str
        Band by method; filled by the grading.
    verdict : str
        One word for the wheel; ``not graded`` before the grading, and for good where the record does not allow it.
    reasons : tuple of str
        Why; first of all what makes the record unfit.
    findings : tuple of Finding
        What weakens the values.
    german : mapping
        Its ``reasons`` and the bands of its ``grade`` in German.
    curves : WheelCurves or None
        What the plate and the tyre force do over frequency.
    more : mapping of str to float or None
        Values of methods that have no attribute of their own here, by key.
    """

    wheel: str
    static_load: float | None = None
    adhesion: float | None = None
    adhesion_frequency_hz: float | None = None
    phase_angle_min_deg: float | None = None
    phase_frequency_hz: float | None = None
    relative_force_amplitude: float | None = None
    tyre_rigidity: float | None = None
    theta_rig: float | None = None
    theta_road: float | None = None
    lift_off: bool = False
    resonance_frequency_hz: float | None = None
    boge_amplitude: float | None = None
    theta_methods: Mapping[str, float | None] = field(default_factory=dict)
    uncertainty: Mapping[str, float] = field(default_factory=dict)
    unreliable: tuple[str, ...] = ()
    corner: LinearQuarterCar | None = None
    grade: Mapping[str, str] = field(default_factory=dict)
    verdict: str = NOT_GRADED
    reasons: tuple[str, ...] = ()
    findings: tuple[Finding, ...] = ()
    german: Mapping[str, Any] = field(default_factory=dict, repr=False, compare=False)
    curves: WheelCurves | None = field(default=None, repr=False)
    more: Mapping[str, float | None] = field(default_factory=dict)

    def __str__(self) -> str:
        return "\n".join([str(wheel_table("", [self])), *self.reasons, *map(str, self.findings)])

    def value(self, key: str) -> float | None:
        """Give a value by its key in results, SI or as the key says; None where it is not known."""
        value: float | None = getattr(self, key) if key in FIELDS else self.more.get(key)
        return value

    @property
    def body_damping_ratio(self) -> float | None:
        """Damping ratio (1) of the body's mode on this wheel with the plate at rest, by parametric fit."""
        return self.more.get("body_damping_ratio")

    @property
    def explained_force(self) -> float | None:
        """Share (1) of the measured force that the fitted quarter car explains."""
        return self.more.get("explained_force")

    @property
    def is_gradable(self) -> bool:
        """Whether the record is fit for grading."""
        return not any(finding.severity == "problem" for finding in self.findings)

    def to_dict(self) -> dict[str, Any]:
        """Plain JSON object: values, ``lift_off``, ``uncertainty``, ``grade``, ``verdict``, ``reasons``, ``findings``.

        Beside them ``wheel``, ``static_load``, ``adhesion_frequency_hz``, ``resonance_frequency_hz``,
        ``boge_amplitude``, ``theta_methods``, ``theta_graded`` and ``unreliable``.
        """
        table: dict[str, Any] = {"wheel": self.wheel}
        table |= {name: getattr(self, name) for name in NUMBERS if name in FIELDS} | dict(self.more)
        table |= {
            "lift_off": self.lift_off,
            "theta_methods": self.theta_methods,
            "theta_graded": "theta_road",
            "uncertainty": self.uncertainty,
            "unreliable": self.unreliable,
            "grade": self.grade,
            "verdict": self.verdict,
            "reasons": self.reasons,
            "findings": self.findings,
            "german": self.german,
        }
        return plain_table(table)


FIELDS = frozenset(item.name for item in fields(WheelResult))


def wheel_table(title: str, wheels: Sequence[WheelResult]) -> TextTable:
    """Write the values of wheels side by side, with half 95 % intervals, grades and verdicts.

    >>> print(wheel_table("front", [WheelResult("left", adhesion=0.61, uncertainty={"adhesion": 0.0123})]))
    front
                       left
    ─────────────────  ──────────────
    adhesion (EUSAMA)  61.0 % ± 1.3 %
    verdict            not graded
    """
    rows = [
        (number.words(), *(_with_half(wheel, number) for wheel in wheels))
        for name, number in NUMBERS.items()
        if any(wheel.value(name) is not None for wheel in wheels)
    ]
    if any(wheel.lift_off for wheel in wheels):
        rows.append(
            ("tyre leaves the plate", *("yes" if wheel.lift_off else "no" for wheel in wheels))
        )
    methods = dict.fromkeys(method for wheel in wheels for method in wheel.grade)
    rows += [
        (f"grade {method}", *(wheel.grade.get(method, "–") for wheel in wheels))
        for method in methods
    ]
    rows.append(("verdict", *(wheel.verdict for wheel in wheels)))
    return TextTable(
        title, ("", *(wheel.wheel for wheel in wheels)), rows, tuple(range(len(wheels) + 1))
    )


def _with_half(wheel: WheelResult, number: WheelQuantity) -> str:
    value, half = wheel.value(number.name), wheel.uncertainty.get(number.name)
    text = number.text(value)
    return text if half is None or text == "–" else f"{text} ± {number.rounded_up(half)}"


@dataclass(frozen=True)
class Inspection(Plain):
    """Values of the wheels of one axle from a record.

    Attributes
    ----------
    wheels : tuple of WheelResult
        Left before right.
    axle : mapping
        ``{"axle": "front"}`` and what the grading adds: differences, verdict, reasons.
    facts : mapping
        What the record's header says: tester, vehicle, plate number, date.
    methods : tuple of str
        What was evaluated.
    findings : tuple of Finding
        About the whole record.
    """

    wheels: tuple[WheelResult, ...]
    axle: Mapping[str, Any] = field(default_factory=dict)
    facts: Mapping[str, Any] = field(default_factory=dict)
    methods: tuple[str, ...] = ()
    findings: tuple[Finding, ...] = ()

    def __str__(self) -> str:
        title = str(self.axle.get("axle", ""))
        findings = [
            *self.findings,
            *(finding for wheel in self.wheels for finding in wheel.findings),
        ]
        return "\n".join([str(wheel_table(title, self.wheels)), *map(str, findings)])

    def wheel(self, name: str) -> WheelResult:
        """Give the result of ``"left"`` or ``"right"``."""
        return next(wheel for wheel in self.wheels if wheel.wheel == name)

    @property
    def is_gradable(self) -> bool:
        """Whether every wheel can be graded."""
        return bool(self.wheels) and all(wheel.is_gradable for wheel in self.wheels)
