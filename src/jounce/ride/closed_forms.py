"""Closed forms for the linear quarter car: variances on white-noise roads, optimal damping, invariants, first designs.

All formulas apply to the two-mass model with an undamped tyre; rates and coefficients are at the wheel.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from jounce.core.constants import GRAVITY
from jounce.core.errors import DescriptionError
from jounce.core.phrases import Phrase
from jounce.core.shown import Shown
from jounce.core.units import positive_si, to_si


@dataclass(frozen=True)
class LumpedCorner:
    """Parameters of a quarter car, all at the wheel, SI."""

    sprung_mass: float
    unsprung_mass: float
    wheel_rate: float
    tyre_stiffness: float
    damping_coefficient: float = 0.0

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            may_vanish = name == "damping_coefficient"
            if not (math.isfinite(value) and (value >= 0.0 if may_vanish else value > 0.0)):
                raise DescriptionError(
                    "out of range",
                    where=name,
                    found=value,
                    allowed="at least 0" if may_vanish else "above 0",
                )

    @property
    def total_mass(self) -> float:
        """Sprung plus unsprung mass, kg."""
        return self.sprung_mass + self.unsprung_mass


@dataclass(frozen=True)
class Variances:
    """Variances on a road whose vertical velocity is white noise, SI; ``deflection`` of the suspension at the wheel."""

    acceleration: float
    deflection: float
    tyre_deflection: float
    tyre_force: float


def white_noise_variances(corner: LumpedCorner, intensity: float) -> Variances:
    """Compute the variances of a damped quarter car on a white-noise road, in closed form.

    ``intensity`` is W of the road's vertical velocity in m^2/s
    (:func:`jounce.roughness.spectra.white_noise_intensity`).

    Examples
    --------
    >>> variances = white_noise_variances(LumpedCorner(400.0, 40.0, 25e3, 200e3, 1500.0), 1.0)
    >>> round(variances.acceleration, 4), round(variances.deflection, 8), round(variances.tyre_deflection, 9)
    (1510.4167, 0.14666667, 0.016977083)
    """
    m, u, k, kt, c = _numbers(corner)
    if c == 0.0:
        raise DescriptionError(
            "no stationary response", where="damping_coefficient", found=c, allowed="above 0 N*s/m"
        )
    total = m + u
    acceleration = (c**2 * kt + k**2 * total) / (2.0 * c * m**2)
    tyre = c**2 * kt * total**2 + _holding_term(m, u, k, kt)
    deflection, tyre_deflection = total / (2.0 * c), tyre / (2.0 * c * kt**2 * m**2)
    return Variances(
        *(
            intensity * value
            for value in (acceleration, deflection, tyre_deflection, kt**2 * tyre_deflection)
        )
    )


def _numbers(corner: LumpedCorner) -> tuple[float, float, float, float, float]:
    return (
        corner.sprung_mass,
        corner.unsprung_mass,
        corner.wheel_rate,
        corner.tyre_stiffness,
        corner.damping_coefficient,
    )


def _holding_term(m: float, u: float, k: float, kt: float) -> float:
    total = m + u
    return k**2 * total**3 - 2.0 * k * kt * m * u * total + kt**2 * m**2 * u


def comfort_damping(corner: LumpedCorner) -> float:
    """Return the damping coefficient (N*s/m, at the wheel) that minimises body acceleration, ``k sqrt(M / k_t)``.

    Examples
    --------
    >>> round(comfort_damping(LumpedCorner(400.0, 40.0, 25e3, 200e3)), 3)
    1172.604
    """
    return corner.wheel_rate * math.sqrt(corner.total_mass / corner.tyre_stiffness)


def least_acceleration_variance(corner: LumpedCorner, intensity: float) -> float:
    """Return the variance ((m/s^2)^2) of the body's acceleration with `comfort_damping`; ``intensity`` in m^2/s."""
    root = math.sqrt(corner.tyre_stiffness * corner.total_mass)
    return intensity * corner.wheel_rate * root / corner.sprung_mass**2


def road_holding_damping(corner: LumpedCorner) -> float:
    """Return the damping coefficient (N*s/m, at the wheel) that minimises wheel load variation.

    Examples
    --------
    >>> round(road_holding_damping(LumpedCorner(400.0, 40.0, 25e3, 200e3)), 3)
    2483.624
    """
    m, u, k, kt, _ = _numbers(corner)
    return math.sqrt(_holding_term(m, u, k, kt)) / (math.sqrt(kt) * (m + u))


def road_holding_rate(corner: LumpedCorner) -> float:
    """Return the wheel rate (N/m) that minimises wheel load variation for any damper, ``k_t m_s m_u / M^2``.

    Examples
    --------
    >>> round(road_holding_rate(LumpedCorner(400.0, 40.0, 25e3, 200e3)), 1)
    16528.9
    """
    return corner.tyre_stiffness * corner.sprung_mass * corner.unsprung_mass / corner.total_mass**2


def mean_dissipated_power(tyre_stiffness: float, intensity: float) -> float:
    """Return the mean power (W) dissipated by one wheel's damper, ``W k_t / 2``, for any masses, spring and damper.

    ``tyre_stiffness`` in N/m, ``intensity`` of the white-noise road in m^2/s.
    """
    return 0.5 * intensity * tyre_stiffness


@dataclass(frozen=True)
class Invariants:
    """Points of the frequency response that no suspension law between body and wheel can change.

    Attributes
    ----------
    acceleration_frequency_hz : float
        Frequency at which the body's acceleration per road height is fixed, Hz.
    acceleration_ratio : float
        Acceleration per road height at this frequency, ``k_t / m_s``, 1/s^2, in phase with the road.
    deflection_frequency_hz : float
        Frequency at which the suspension deflection per road height is fixed, Hz.
    deflection_ratio : float
        Magnitude of the deflection per road height at this frequency, ``M / m_s`` (1).
    """

    acceleration_frequency_hz: float
    acceleration_ratio: float
    deflection_frequency_hz: float
    deflection_ratio: float


def invariants(sprung_mass: float, unsprung_mass: float, tyre_stiffness: float) -> Invariants:
    """Compute the invariant points of a quarter car with an undamped tyre, SI (key hedrick-butsuen-1990).

    They apply equally to passive, semi-active and active suspensions.

    Examples
    --------
    >>> points = invariants(400.0, 40.0, 200e3)
    >>> round(points.acceleration_frequency_hz, 5), round(points.acceleration_ratio)
    (11.25395, 500)
    >>> round(points.deflection_frequency_hz, 5), round(points.deflection_ratio, 2)
    (3.39319, 1.1)
    """
    total = sprung_mass + unsprung_mass
    first, second = (
        math.sqrt(tyre_stiffness / mass) / (2.0 * math.pi) for mass in (unsprung_mass, total)
    )
    return Invariants(first, tyre_stiffness / sprung_mass, second, total / sprung_mass)


def ride_rate(wheel_rate: float, tyre_stiffness: float | None) -> float:
    """Return wheel rate and tyre stiffness (N/m) in series, N/m; None means a rigid tyre."""
    return (
        wheel_rate
        if tyre_stiffness is None
        else wheel_rate * tyre_stiffness / (wheel_rate + tyre_stiffness)
    )


def approximate_frequencies(corner: LumpedCorner) -> tuple[float, float]:
    """Approximate body bounce and wheel hop (Hz) as uncoupled, within about 1 % of a car's undamped frequencies.

    Examples
    --------
    >>> [round(value, 3) for value in approximate_frequencies(LumpedCorner(400.0, 40.0, 25e3, 200e3))]
    [1.186, 11.937]
    """
    body = ride_rate(corner.wheel_rate, corner.tyre_stiffness) / corner.sprung_mass
    hop = (corner.wheel_rate + corner.tyre_stiffness) / corner.unsprung_mass
    return math.sqrt(body) / (2.0 * math.pi), math.sqrt(hop) / (2.0 * math.pi)


def static_deflection(sprung_mass: float, wheel_rate: float, gravity: float = GRAVITY) -> float:
    """Return the deflection (m) under a mass (kg) for a wheel rate (N/m) without preload; ``gravity`` in m/s^2."""
    return sprung_mass * gravity / wheel_rate


def corner_masses(
    body_mass: float, front_distance: float, rear_distance: float
) -> tuple[float, float]:
    """Return the sprung mass (kg) on one front and one rear wheel; axle distances (m) from the centre of gravity.

    >>> [round(mass, 2) for mass in corner_masses(1636.0, 1.29, 1.62)]
    [455.38, 362.62]
    """
    base = front_distance + rear_distance
    return 0.5 * body_mass * rear_distance / base, 0.5 * body_mass * front_distance / base


@dataclass(frozen=True)
class SpringAndDamper(Shown):
    """Spring and damper of one wheel.

    Attributes
    ----------
    spring_rate, damping_coefficient : float
        Values at the strut, N/m and N*s/m.
    wheel_rate, wheel_damping_coefficient : float
        Values at the wheel, N/m and N*s/m: the strut values times the motion ratio squared.
    ride_rate : float
        Wheel rate and tyre in series, N/m.
    frequency_hz : float
        Undamped natural frequency of the sprung mass on the ride rate, without the wheel's mass, Hz.
    damping_ratio : float
        Damping ratio of the sprung mass on the wheel rate (1).
    static_deflection : float
        Static deflection of the suspension at the wheel without preload, m.
    static_load : float
        Weight of the sprung mass, N.
    """

    spring_rate: float
    damping_coefficient: float
    wheel_rate: float
    wheel_damping_coefficient: float
    ride_rate: float
    frequency_hz: float
    damping_ratio: float
    static_deflection: float
    static_load: float


_SOFTEST = 1e-9  # N/m: the static deflection of a softer spring overflows


def spring_and_damper(
    sprung_mass: float | str,
    frequency: float | str,
    damping_ratio: float,
    *,
    tyre_stiffness: float | str | None = None,
    motion_ratio: float = 1.0,
    gravity: float = GRAVITY,
) -> SpringAndDamper:
    """Compute spring and damper for a given natural frequency and damping ratio of a mass.

    Parameters
    ----------
    sprung_mass : float or str
        Sprung mass of this wheel, kg.
    frequency : float or str
        Undamped natural frequency of the body, Hz.
    damping_ratio : float
        Fraction of critical damping (1): ``c / (2 sqrt(k m))`` at the wheel, for a rigid tyre.
    tyre_stiffness : float or str, optional
        Tyre stiffness, N/m; the frequency is then that of spring and tyre in series. By default a rigid tyre.
    motion_ratio : float
        Spring travel over wheel travel (1); for a lumped strut, the cosine of its angle.
    gravity : float
        Gravitational acceleration, m/s^2.

    Returns
    -------
    SpringAndDamper
        Spring, damper and derived values, SI.

    Raises
    ------
    DescriptionError
        If a value is out of range, or the tyre alone is too soft for the frequency.

    Examples
    --------
    >>> design = spring_and_damper("460 kg", "1.4466 Hz", 0.24)   # the 38 N/mm and 2000 N*s/m of paper 2
    >>> round(design.spring_rate, -2), round(design.damping_coefficient, -1)
    (38000.0, 2010.0)
    """
    mass = positive_si(sprung_mass, "kg", where="sprung_mass")
    wanted = positive_si(frequency, "Hz", where="frequency")
    share = positive_si(damping_ratio, "1", where="damping_ratio", zero=True)
    ratio = positive_si(motion_ratio, "1", where="motion_ratio")
    stiffness = (
        None
        if tyre_stiffness is None
        else positive_si(tyre_stiffness, "N/m", where="tyre_stiffness")
    )
    ride = mass * (2.0 * math.pi * wanted) ** 2
    if ride < _SOFTEST:
        raise DescriptionError(
            "an implausibly low frequency",
            where="frequency",
            found=f"{wanted:g} Hz",
            allowed="about 1 Hz",
        )
    rate = ride
    if stiffness is not None:
        if ride >= stiffness:
            most = math.sqrt(stiffness / mass) / (2.0 * math.pi)
            raise DescriptionError(
                "the tyre is too soft for this frequency",
                where="frequency",
                found=f"{wanted:g} Hz",
                allowed=Phrase("below {most:.4g} Hz", most=most),
            )
        rate = ride * stiffness / (stiffness - ride)
    damping = 2.0 * share * math.sqrt(rate * mass)
    lever = ratio**2
    gravity = to_si(gravity, "m/s^2", where="gravity")
    sag = static_deflection(mass, rate, gravity)
    return SpringAndDamper(
        rate / lever, damping / lever, rate, damping, ride, wanted, share, sag, mass * gravity
    )


def as_built(
    sprung_mass: float,
    spring_rate: float,
    damping_coefficient: float,
    *,
    tyre_stiffness: float | None = None,
    motion_ratio: float = 1.0,
    gravity: float = GRAVITY,
) -> SpringAndDamper:
    """Compute frequency and damping ratio of a given spring and damper, the inverse of :func:`spring_and_damper`.

    Masses in kg, rates in N/m and coefficients in N*s/m at the strut; None means a rigid tyre.

    >>> front = as_built(455.38, 28000.0, 3000.0)   # paper 2, table 2
    >>> round(front.frequency_hz, 3), round(front.damping_ratio, 2)
    (1.248, 0.42)
    """
    lever = motion_ratio**2
    rate, damping = spring_rate * lever, damping_coefficient * lever
    ride = ride_rate(rate, tyre_stiffness)
    frequency = math.sqrt(ride / sprung_mass) / (2.0 * math.pi)
    share = damping / (2.0 * math.sqrt(rate * sprung_mass))
    sag = static_deflection(sprung_mass, rate, gravity)
    load = sprung_mass * gravity
    return SpringAndDamper(
        spring_rate, damping_coefficient, rate, damping, ride, frequency, share, sag, load
    )
