"""Result of an inspection: values per wheel with uncertainty, curves, grades and reasons."""

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
    """Values of a test over frequency, one per turn of the exciter in chronological order.

    Attributes
    ----------
    time : ndarray, shape (n,)
        Time at which the plate is highest, s.
    frequency : ndarray, shape (n,)
        Frequency of the plate, Hz.
    least_force, greatest_force : ndarray, shape (n,)
        Minimum and maximum tyre force in the turn after filtering, N.
    phase_deg : ndarray, shape (n,)
        EGEA phase angle in degrees: in and near the band from the smoothed curve whose minimum is reported, elsewhere
        from the single turn; NaN if unknown.
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
    """Values of one wheel from a record, SI; None if unknown, with the reason in the findings.

    Attributes
    ----------
    wheel : str
        ``left`` or ``right``.
    static_load : float or None
        Static wheel load, N.
    adhesion : float or None
        Minimum over static tyre force (1); 0 if the tyre lifts off.
    adhesion_frequency_hz : float or None
        Frequency of the minimum force, Hz; the wheel's resonance on this tester.
    phase_angle_min_deg : float or None
        Minimum EGEA phase angle within 6 to 18 Hz, ends included, in degrees.
    phase_frequency_hz : float or None
        Frequency of the minimum phase angle, Hz.
    relative_force_amplitude : float or None
        Maximum force amplitude over static load (1).
    tyre_rigidity : float or None
        EGEA rigidity from the force at 25 Hz, N/m.
    theta_rig, theta_road : float or None
        Damping ratio (1) of the wheel on this tester and on the road (plate at rest), by parametric fit.
    lift_off : bool
        Whether the tyre left the plate.
    resonance_frequency_hz : float or None
        Frequency of the maximum plate movement (sprung) or force amplitude (rigid), Hz.
    boge_amplitude : float or None
        Maximum peak-to-peak movement of a sprung plate, m.
    theta_methods : mapping of str to float or None
        Damping ratio (1) on this tester by ``fit``, ``half_power``, ``amplification``, ``free_decay``.
    uncertainty : mapping of str to float
        Half width of the 95 % interval by key, in the unit of the value.
    unreliable : tuple of str
        Keys of values with poor repeatability, as after lift-off: they have no interval and are not used for grading
        differences between wheels.
    corner : LinearQuarterCar or None
        Linear quarter car fitted to the record.
    grade : mapping of str to str
        Band by method; set by the grading.
    verdict : str
        Verdict of the wheel; ``not graded`` before the grading, and if the record is unusable.
    reasons : tuple of str
        Reasons of the verdict, starting with those that make the record unusable.
    findings : tuple of Finding
        Findings that make the values less reliable.
    german : mapping
        The ``reasons`` and the bands of ``grade`` in German.
    curves : WheelCurves or None
        Plate movement and tyre force over frequency.
    more : mapping of str to float or None
        Further values of methods, without an attribute of their own, by key.
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
        """Return a value by its key in results, in SI or the unit in the key; None if unknown."""
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
        """Return JSON data: values, ``lift_off``, ``uncertainty``, ``grade``, ``verdict``, ``reasons``, ``findings``.

        It also contains ``wheel``, ``static_load``, ``adhesion_frequency_hz``, ``resonance_frequency_hz``,
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
    """Tabulate the values of wheels side by side, with half widths of 95 % intervals, grades and verdicts.

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
        Results, left before right.
    axle : mapping
        ``{"axle": "front"}`` plus differences, verdict and reasons after grading.
    facts : mapping
        Entries of the record's header: tester, vehicle, plate number, date.
    methods : tuple of str
        Evaluated methods.
    findings : tuple of Finding
        Findings about the whole record.
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
        """Return the result of ``"left"`` or ``"right"``."""
        return next(wheel for wheel in self.wheels if wheel.wheel == name)

    @property
    def is_gradable(self) -> bool:
        """Whether every wheel can be graded."""
        return bool(self.wheels) and all(wheel.is_gradable for wheel in self.wheels)
