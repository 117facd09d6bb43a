"""Selection of a spring for the prototype."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated

from jounce.bench.estimated import estimated_default, estimates_used
from jounce.core.constants import GRAVITY
from jounce.core.description import Description
from jounce.core.errors import FitError
from jounce.core.findings import Finding, finding
from jounce.core.operation import MadeBy, Pairs, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain
from jounce.core.typed import positive_quantity
from jounce.core.units import (
    Angle,
    Frequency,
    Mass,
    NonNegativeDampingCoefficient,
    NonNegativeForce,
    PositiveLength,
    PositiveStiffness,
    to_si,
)

PUBLISHED = {"bicycle": 52775.0, "scooter": 22730.0}  # N/m
_AT_REST = 0.5
"""Maximum fraction of the travel used at rest, which leaves equal travel for bump and rebound."""
_STIFF = 1.5
"""Maximum ratio to the target frequency: the wheel rate is then 2.25 times too large."""
CANDIDATES = Pairs(
    "Candidates. Default: bicycle=52775 N/m, scooter=22730 N/m.", "NAME=RATE", 'soft="22.73 N/mm"'
)


class SpringChoice(Description):
    """Requirements for a spring.

    Published: the sprung mass, the strut angles, the tyre stiffness. *Estimated*, without a source:
    ``damping_coefficient`` 150 N s/m along the strut, ``available_travel`` 40 mm at the wheel, ``target_frequency``
    1.84 Hz (1.5 Hz at full size, by similitude with lengths reduced by 1.5), ``friction_force`` 15 N at the sprung
    mass.

    Attributes
    ----------
    sprung_mass : float
        Sprung mass.
    strut_angle : float
        Angle of the strut to the vertical.
    tyre_stiffness : float
        Stiffness of the tyre in series.
    damping_coefficient : float
        Damping coefficient along the strut.
    available_travel : float
        Travel available at the wheel.
    target_frequency : float
        Target frequency of body bounce.
    friction_force : float
        Friction force at the sprung mass.
    """

    sprung_mass: Mass = 16.0
    strut_angle: Angle = math.radians(26.0)
    tyre_stiffness: PositiveStiffness = 138468.0
    damping_coefficient: NonNegativeDampingCoefficient = estimated_default(
        150.0, "damping ratio near 0.1 with the softer spring"
    )
    available_travel: PositiveLength = estimated_default(
        0.040, "stroke of a bicycle shock absorber"
    )
    target_frequency: Frequency = estimated_default(1.84, "1.5 Hz at full size")
    friction_force: NonNegativeForce = estimated_default(
        15.0, "linear guides after one set of balls was removed"
    )


@dataclass(frozen=True)
class SpringRow:
    """One candidate at the wheel.

    Attributes
    ----------
    name : str
        Name of the spring.
    spring_rate, wheel_rate, ride_rate : float
        At the spring, at the wheel (rate * cos^2 of the strut angle), and with the tyre in series [N/m].
    natural_frequency_rigid_tyre, natural_frequency : float
        Natural frequency of the sprung mass on the spring alone, and with the tyre in series [Hz].
    damping_ratio : float
        Damping ratio on the spring alone: damping at the wheel / (2 sqrt(wheel_rate * mass)) [1].
    static_deflection : float
        Static deflection of the suspension at the wheel [m].
    travel_share : float
        Static deflection over available travel [1].
    suspension_share : float
        Suspension's fraction of the total deflection of suspension and tyre [1].
    friction_deflection : float
        Friction divided by wheel rate: maximum distance from equilibrium at which the mass may rest [m].
    """

    name: str
    spring_rate: float
    wheel_rate: float
    ride_rate: float
    natural_frequency_rigid_tyre: float
    natural_frequency: float
    damping_ratio: float
    static_deflection: float
    travel_share: float
    suspension_share: float
    friction_deflection: float


@dataclass(frozen=True)
class SpringComparison(Plain):
    """Candidates in the order given, and the recommended spring.

    Its natural frequency with the tyre comes closest to the target without using up the travel.

    Attributes
    ----------
    rows : tuple of SpringRow
        Candidates.
    chosen : str
        Name of the recommended spring.
    reasons : tuple of str
        Reason for each rejected candidate.
    findings : tuple of Finding
        The reasons, and concerns about the recommended spring.
    """

    rows: tuple[SpringRow, ...]
    chosen: str
    reasons: tuple[str, ...]
    findings: tuple[Finding, ...]


@operation(
    "bench springs",
    named={"springs": "candidates"},
    page="jounce.report.bench:spring_choice_page",
    title="Springs",
    example='jounce bench springs stiff="52.775 N/mm" soft="22.73 N/mm" --sprung-mass "16 kg"',
)
def compare_springs(
    springs: Annotated[
        Mapping[str, float | str] | Sequence[tuple[str, float | str]] | None, CANDIDATES
    ] = None,
    choice: Annotated[SpringChoice | None, MadeBy("jounce.bench.springs:SpringChoice")] = None,
) -> SpringComparison:
    """Compare candidate springs by static deflection, natural frequency and damping ratio, and recommend one.

    Parameters
    ----------
    springs : mapping, or sequence of pairs, optional
        Name of each candidate and its spring rate, N/m; by default those of the published kart.
    choice : SpringChoice, optional
        Requirements; by default those of the published kart.

    Returns
    -------
    SpringComparison
        Candidates and recommendation, SI.

    Raises
    ------
    DescriptionError
        If a text is not a spring rate.
    FitError
        If there are no springs, a rate is not positive, names are not unique, or the strut is nearly horizontal.

    Examples
    --------
    >>> found = compare_springs({"bicycle": "52.775 N/mm", "scooter": 22730.0})
    >>> found.chosen, round(found.rows[1].wheel_rate), round(found.rows[1].natural_frequency, 3)
    ('scooter', 18362, 5.066)
    """
    choice = choice or SpringChoice()
    springs = PUBLISHED if springs is None else springs
    pairs = [*springs.items()] if isinstance(springs, Mapping) else springs
    names = [name for name, _ in pairs]
    if not names:
        raise FitError("no springs to compare", allowed="at least one")
    if len(set(names)) < len(names):
        raise FitError("a spring is named twice", allowed="different names")
    rates = [(name, _rate(name, rate)) for name, rate in pairs]
    if (
        math.cos(choice.strut_angle) < 0.1
    ):  # the wheel rate is then less than a hundredth of the spring rate
        raise FitError(
            "the strut is nearly horizontal",
            found=f"{math.degrees(choice.strut_angle):g} deg",
            allowed="below 84 deg",
        )
    rows = tuple(_row(name, rate, choice) for name, rate in rates)
    fitting = [row for row in rows if row.travel_share <= _AT_REST] or list(rows)
    chosen = min(
        fitting, key=lambda row: abs(math.log(row.natural_frequency / choice.target_frequency))
    )
    reasons = tuple(_reason(row, chosen, choice) for row in rows if row is not chosen)
    findings = [Finding("springs", "note", reason) for reason in reasons]
    findings += _doubts(chosen, choice)
    findings += estimates_used(choice, "springs")
    return SpringComparison(rows, chosen.name, reasons, tuple(findings))


def _rate(name: str, given: float | str) -> float:
    """Convert a rate to N/m; numbers are SI and may have any magnitude, text must be plausible."""
    if isinstance(given, str):
        return positive_quantity(given, "N/m", name)
    if not given > 0.0:
        raise FitError(
            Phrase("{name}: the spring rate is not positive", name=name),
            found=f"{given:g} N/m",
            allowed="above 0 N/m",
        )
    return to_si(given, "N/m", where=name)


def _row(name: str, rate: float, choice: SpringChoice) -> SpringRow:
    lever = math.cos(choice.strut_angle) ** 2
    wheel = rate * lever
    ride = 1.0 / (1.0 / wheel + 1.0 / choice.tyre_stiffness)
    static = GRAVITY * choice.sprung_mass / wheel
    return SpringRow(
        name=name,
        spring_rate=rate,
        wheel_rate=wheel,
        ride_rate=ride,
        natural_frequency_rigid_tyre=math.sqrt(wheel / choice.sprung_mass) / (2.0 * math.pi),
        natural_frequency=math.sqrt(ride / choice.sprung_mass) / (2.0 * math.pi),
        damping_ratio=choice.damping_coefficient
        * lever
        / (2.0 * math.sqrt(wheel * choice.sprung_mass)),
        static_deflection=static,
        travel_share=static / choice.available_travel,
        suspension_share=choice.tyre_stiffness / (choice.tyre_stiffness + wheel),
        friction_deflection=choice.friction_force / wheel,
    )


def _reason(row: SpringRow, chosen: SpringRow, choice: SpringChoice) -> str:
    name = f"{row.name} ({row.spring_rate:.5g} N/m)"
    if row.travel_share > _AT_REST >= chosen.travel_share:
        return (
            f"{name} is too soft: standing still it uses {100 * row.travel_share:.0f} % of the available travel of "
            f"{1e3 * choice.available_travel:.3g} mm."
        )
    if row.natural_frequency < chosen.natural_frequency:
        return (
            f"{name} is further from the target of {choice.target_frequency:.3g} Hz than {chosen.name}: "
            f"{row.natural_frequency:.3g} Hz."
        )
    return (
        f"{name} is too stiff: {row.natural_frequency:.3g} Hz instead of {chosen.natural_frequency:.3g} Hz (target "
        f"{choice.target_frequency:.3g} Hz); standing still it moves {1e3 * row.static_deflection:.2g} mm, "
        f"{100 * row.travel_share:.0f} % of the travel; the same damper gives a damping ratio of "
        f"{row.damping_ratio:.2g} instead of {chosen.damping_ratio:.2g}; and the tyre takes "
        f"{100 * (1 - row.suspension_share):.0f} % of a deflection instead of "
        f"{100 * (1 - chosen.suspension_share):.0f} %."
    )


def _doubts(row: SpringRow, choice: SpringChoice) -> list[Finding]:
    findings = []
    if row.natural_frequency > _STIFF * choice.target_frequency:
        findings.append(
            finding(
                "bench.best_spring_stiff",
                "springs",
                row.natural_frequency,
                name=row.name,
                frequency=row.natural_frequency,
                times=row.natural_frequency / choice.target_frequency,
                target=choice.target_frequency,
            )
        )
    if row.travel_share > _AT_REST:
        findings.append(
            finding(
                "bench.travel_used_at_rest",
                "springs",
                row.travel_share,
                name=row.name,
                share=row.travel_share,
            )
        )
    if choice.strut_angle > math.radians(
        30.0
    ):  # Adams 1993, cited by the paper; `STEEP_STRUT` of rigs
        findings.append(finding("bench.struts_inclined", "springs", choice.strut_angle))
    return findings
