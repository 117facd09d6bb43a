"""Similitude: the mass and stiffness that a scaled prototype should have, and the rules that the built one violates."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from jounce.bench.estimated import estimated_default, estimates_used
from jounce.core.constants import GRAVITY
from jounce.core.description import Description
from jounce.core.errors import FitError
from jounce.core.findings import Finding
from jounce.core.operation import MadeBy, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain
from jounce.core.units import (
    Frequency,
    Mass,
    PositiveNumber,
    PositiveSpeed,
    PositiveStiffness,
    Unit,
)

Density = Annotated[float, Unit("kg/m^3", above=0.0)]
_MISSED = 0.05
"""Relative deviation above which a rule is violated: the density of steel (7579 to 7850 kg/m^3) changes masses by 4 %.

The published prototype deviates from each of the four rules by 67 % or more.
"""


def scaled_mass(mass: float, factor: float, *, density_ratio: float = 1.0) -> float:
    """Return the mass (kg) of a block whose edges are divided by a factor: mass * density_ratio / factor^3.

    ``density_ratio`` is the density of the reduced block over that of the full-size one (1).

    Examples
    --------
    >>> scaled_mass(265.0, 2.5)
    16.96
    """
    for value, what in ((mass, "mass"), (factor, "factor"), (density_ratio, "density ratio")):
        if not (math.isfinite(value) and value > 0.0):
            raise FitError(
                Phrase("the {what} is not positive", what=what), found=value, allowed="above 0"
            )
    return mass * density_ratio / factor**3


class Similitude(Description):
    """Full-size suspension and its scaled prototype.

    Published: the quarter vehicle's sprung mass, the two length factors, the density of cast iron, the mass as built,
    the tyre stiffness and the spring rate (here with the strut at 26 degrees, rigidly tied at the wheel: 18 362 N/m).
    *Estimated*, without a source: ``reference_density`` 7850 kg/m^3 (steel) and
    ``reference_frequency`` 1.5 Hz (body bounce of a passenger car).

    Attributes
    ----------
    reference_mass : float
        Sprung mass at full size.
    prototype_mass : float
        Sprung mass as built.
    geometry_factor : float
        Ratio of lengths, full size to prototype.
    mass_factor : float
        Ratio of the edges of the mass, full size to prototype.
    prototype_density : float
        Density of the prototype's mass.
    prototype_wheel_rate : float
        Wheel rate as built.
    prototype_tyre_stiffness : float
        Tyre stiffness as built.
    prototype_speed : float
        Speed of the trials.
    reference_density : float
        Density at full size.
    reference_frequency : float
        Body bounce frequency at full size.
    """

    reference_mass: Mass = 265.0
    prototype_mass: Mass = 16.0
    geometry_factor: PositiveNumber = 1.5
    mass_factor: PositiveNumber = 2.5
    prototype_density: Density = 7150.0
    prototype_wheel_rate: PositiveStiffness = 18362.0
    prototype_tyre_stiffness: PositiveStiffness = 138468.0
    prototype_speed: PositiveSpeed = 1.95
    reference_density: Density = estimated_default(7850.0, "density of steel")
    reference_frequency: Frequency = estimated_default(1.5, "body bounce of a passenger car")


@dataclass(frozen=True)
class ScaleFactor:
    """One quantity under similitude with the same gravity (Froude).

    ``factor`` is the required ratio of the full-size value to the prototype's (1); ``prototype`` the value as
    built, ``full_size`` the value it represents, both in the SI ``unit`` and None if only the factor is known.
    """

    name: str
    factor: float
    prototype: float | None
    full_size: float | None
    unit: str


@dataclass(frozen=True)
class SimilitudeReport(Plain):
    """Mass by Eq. 1, factors of similitude, and violations by the prototype.

    Attributes
    ----------
    mass_same_density, mass_prototype_density : float
        Mass that Eq. 1 gives with the full-size density and with the prototype's [kg].
    effective_mass_factor : float
        Length factor that would give the mass as built with the two densities [1].
    density_for_built_mass : float
        Full-size density with which Eq. 1 gives exactly the mass as built [kg/m^3].
    factors : tuple of ScaleFactor
        Length, time, mass, stiffness, damping coefficient, speed, force.
    frequency, similar_frequency : float
        Body bounce of the prototype on its tyre, and the one a similar prototype would have [Hz].
    violations : tuple of str
        Violations of similitude, one sentence each.
    findings : tuple of Finding
        Violations as findings, and the estimated values used.
    """

    mass_same_density: float
    mass_prototype_density: float
    effective_mass_factor: float
    density_for_built_mass: float
    factors: tuple[ScaleFactor, ...]
    frequency: float
    similar_frequency: float
    violations: tuple[str, ...]
    findings: tuple[Finding, ...]


@operation(
    "bench scale",
    arguments=0,
    page="jounce.report.bench:similitude_page",
    title="Prototype",
    example='jounce bench scale --prototype-mass "18.6 kg"',
)
def similitude_report(
    case: Annotated[Similitude | None, MadeBy("jounce.bench.similitude:Similitude")] = None,
) -> SimilitudeReport:
    """Assess the similitude of a prototype: its mass by Eq. 1 of the paper, the scale factors, and its violations.

    Lengths scale with ``geometry_factor`` and, for the same gravity, times with its square root. The mass ratio is that
    of the built prototype; stiffness = mass / time^2, damping coefficient = mass / time, force = mass.

    Parameters
    ----------
    case : Similitude, optional
        Full-size suspension and prototype; by default the published kart.

    Returns
    -------
    SimilitudeReport
        Masses, scale factors and violations, SI.

    Examples
    --------
    >>> report = similitude_report()
    >>> round(report.mass_same_density, 2), round(report.mass_prototype_density, 3)
    (16.96, 15.448)
    >>> round(report.frequency, 2)
    5.07
    """
    case = case or Similitude()
    density = case.prototype_density / case.reference_density
    mass_ratio = case.reference_mass / case.prototype_mass
    time = math.sqrt(case.geometry_factor)
    ride = 1.0 / (1.0 / case.prototype_wheel_rate + 1.0 / case.prototype_tyre_stiffness)
    frequency = math.sqrt(ride / case.prototype_mass) / (2.0 * math.pi)
    factors = (
        _factor("length", case.geometry_factor, None, "m"),
        _factor("time", time, None, "s"),
        _factor("mass", mass_ratio, case.prototype_mass, "kg"),
        _factor("wheel rate", mass_ratio / time**2, case.prototype_wheel_rate, "N/m"),
        _factor("tyre stiffness", mass_ratio / time**2, case.prototype_tyre_stiffness, "N/m"),
        _factor("damping coefficient", mass_ratio / time, None, "N*s/m"),
        _factor("speed", time, case.prototype_speed, "m/s"),
        _factor("force", mass_ratio, None, "N"),
    )
    violations = _violations(case, frequency, density)
    findings = [Finding("similitude", "warning", text) for text in violations]
    findings += estimates_used(case, "similitude")
    return SimilitudeReport(
        mass_same_density=scaled_mass(case.reference_mass, case.mass_factor),
        mass_prototype_density=scaled_mass(
            case.reference_mass, case.mass_factor, density_ratio=density
        ),
        effective_mass_factor=(mass_ratio * density) ** (1.0 / 3.0),
        density_for_built_mass=scaled_mass(case.reference_mass, case.mass_factor)
        * case.prototype_density
        / case.prototype_mass,
        factors=factors,
        frequency=frequency,
        similar_frequency=case.reference_frequency * time,
        violations=violations,
        findings=tuple(findings),
    )


def _factor(name: str, factor: float, prototype: float | None, unit: str) -> ScaleFactor:
    return ScaleFactor(
        name, factor, prototype, None if prototype is None else factor * prototype, unit
    )


def _violations(case: Similitude, frequency: float, density: float) -> tuple[str, ...]:
    """Report violations of similitude."""
    violations = []
    if abs(case.mass_factor / case.geometry_factor - 1.0) > _MISSED:
        violations.append(
            f"two length factors: geometry is reduced by {case.geometry_factor:g}, the edges of the mass by "
            f"{case.mass_factor:g}; one prototype has only one scale."
        )
    by_geometry = scaled_mass(case.reference_mass, case.geometry_factor, density_ratio=density)
    if abs(case.prototype_mass / by_geometry - 1.0) > _MISSED:
        violations.append(
            f"mass: reduced like the geometry it would be {by_geometry:.3g} kg, built are {case.prototype_mass:.3g} kg."
        )
    similar = case.reference_frequency * math.sqrt(case.geometry_factor)
    if abs(frequency / similar - 1.0) > _MISSED:
        rate = (2.0 * math.pi * similar) ** 2 * case.prototype_mass
        violations.append(
            f"frequency: body bounce is {frequency:.3g} Hz, {frequency / similar:.2g} times the {similar:.3g} Hz that "
            f"{case.reference_frequency:g} Hz at full size asks for (ride rate {rate:.3g} N/m)."
        )
    deflection = GRAVITY * case.prototype_mass / case.prototype_wheel_rate
    wanted = GRAVITY / (2.0 * math.pi * case.reference_frequency) ** 2 / case.geometry_factor
    if abs(deflection / wanted - 1.0) > _MISSED:
        violations.append(
            f"static deflection: {1e3 * deflection:.3g} mm at the wheel instead of about {1e3 * wanted:.3g} mm, so "
            "friction, free play and travel weigh otherwise than at full size."
        )
    return tuple(violations)
