"""The quarter car equivalent to a corner: rates, damping and masses at the wheel, from its kinematics at rest.

With the body on a vertical guide, a corner has two free motions: heights of body and wheel centre. Small motions about
rest obey ``M z'' + C z' + K z = tyre`` with

- ``M``: a share ``r`` of each body's mass moves with the wheel (the rise of its centre of mass over that of the wheel),
the rest with the car's body. Its rotation and lateral motion add an *inertance* between the two, like that of an
inerter: ``b = sum(m |v|^2 + w I w - m r)`` with velocities for a unit speed of the wheel centre.
- ``C``: the damper's coefficient times its motion ratio squared.
- ``K``: spring rate times its motion ratio squared, plus the spring's force times the gradient of its motion ratio; the
same two terms for the gas of the damper at rest; plus the effect of the bodies' weights where their centres of mass
move along curves.

Two masses without an inertance cannot be fully equivalent; those of the quarter car are chosen to match the two natural
frequencies.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from jounce.core.errors import DescriptionError, SimulationError
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.kinematics import sweep_travel
from jounce.kinematics.model import check_corner
from jounce.kinematics.moved_rigs import rigs_along
from jounce.parts import Corner, DependentAxle, QuarterCar, Rig
from jounce.parts.dampers import DamperLaw, VelocityTable
from jounce.parts.leverage import body_motion, force_at
from jounce.parts.tables import on_lines
from jounce.parts.variants import LARGEST
from jounce.simulation import Mode, equilibrium

_NUDGE = 1e-4
"""Travel to either side over which the curvature of the path of a centre of mass is measured, m."""


@dataclass(frozen=True)
class BodyShare:
    """Division of a suspension body between sprung and unsprung mass, about equilibrium.

    ``wheel_share`` is the rise of its centre of mass over that of the wheel centre (1); ``inertance`` (kg) is its
    contribution between car body and wheel.
    """

    mass: float
    wheel_share: float
    inertance: float

    @property
    def sprung_mass(self) -> float:
        """Part of its mass that moves with the body, kg."""
        return self.mass * (1.0 - self.wheel_share)

    @property
    def unsprung_mass(self) -> float:
        """Part of its mass that moves with the wheel, kg."""
        return self.mass * self.wheel_share


@dataclass(frozen=True)
class Lumping:
    """Properties of a corner about static equilibrium, referred to the wheel centre. SI, compression positive.

    Attributes
    ----------
    travel : float
        Wheel travel from design at rest, m.
    motion_ratio, damper_ratio : float
        Shortening of spring and damper per rise of the wheel centre [1].
    motion_ratio_gradient : float
        Change of the spring's motion ratio with travel, 1/m.
    spring_deflection : float
        Shortening of the spring from its design length at rest, m.
    spring_force : float
        Force of spring and stops at rest, N.
    wheel_force : float
        Force of all springs at the wheel centre at rest, N, including torsion bar, third spring, Z-bar and damper gas.
    wheel_rate_spring, wheel_rate_preload, wheel_rate_weight : float
        Rate at the wheel from the stiffness of spring, torsion bar and gas, from their force and the gradient of the
        motion ratio, and from the weights of the suspension's bodies, N/m.
    wheel_rate_across : float
        Rate at the wheel of third spring and Z-bar in parallel wheel travel, N/m.
    third_ratio : float
        Shortening of the third spring per rise of both wheel centres [1]; 0 without one.
    wheel_damping : float
        Damping coefficient at the wheel, of the dampers at rest, N s/m.
    tyre_stiffness, tyre_damping : float
        Stiffness and damping coefficient of the tyre at its static load, N/m and N s/m.
    body_mass : float
        Mass on the guide, kg.
    shares : dict
        Suspension body to its share.
    gravity : float
        m/s^2.
    """

    travel: float
    motion_ratio: float
    damper_ratio: float
    motion_ratio_gradient: float
    spring_deflection: float
    spring_force: float
    wheel_force: float
    wheel_rate_spring: float
    wheel_rate_preload: float
    wheel_rate_weight: float
    wheel_rate_across: float
    third_ratio: float
    wheel_damping: float
    tyre_stiffness: float
    tyre_damping: float
    body_mass: float
    shares: dict[str, BodyShare]
    gravity: float

    @property
    def wheel_rate(self) -> float:
        """Rate at the wheel, N/m."""
        return (
            self.wheel_rate_spring
            + self.wheel_rate_preload
            + self.wheel_rate_weight
            + self.wheel_rate_across
        )

    @property
    def static_masses(self) -> tuple[float, float]:
        """Sprung and unsprung mass by the lever rule, kg; their sum is the total mass."""
        parts = self.shares.values()
        return (
            self.body_mass + sum(part.sprung_mass for part in parts),
            sum(part.unsprung_mass for part in parts),
        )

    @property
    def inertance(self) -> float:
        """Inertance between body and wheel, kg; negative if the masses between them outweigh the rotational inertia."""
        return sum(part.inertance for part in self.shares.values())

    @property
    def effective_masses(self) -> tuple[float, float]:
        """Sprung and unsprung mass that reproduce both natural frequencies without an inertance, kg."""
        (sprung, unsprung), b = self.static_masses, self.inertance
        k, k_t = self.wheel_rate, self.tyre_stiffness
        product = sprung * unsprung + b * (sprung + unsprung)
        total = k * unsprung + (k + k_t) * sprung + k_t * b
        sprung_mass = float(total + np.sqrt(total**2 - 4.0 * (k + k_t) * k * product)) / (
            2.0 * (k + k_t)
        )
        return sprung_mass, product / sprung_mass

    def matrices(self) -> tuple[Array, Array, Array]:
        """Mass, damping and stiffness matrices for the heights of body and wheel centre, each shape (2, 2)."""
        (sprung, unsprung), b = self.static_masses, self.inertance
        between = np.array([[1.0, -1.0], [-1.0, 1.0]])
        at_wheel = np.diag([0.0, 1.0])
        return (
            np.diag([sprung, unsprung]) + b * between,
            self.wheel_damping * between + self.tyre_damping * at_wheel,
            self.wheel_rate * between + self.tyre_stiffness * at_wheel,
        )

    def modes(self) -> tuple[Mode, ...]:
        """Oscillating modes by rising natural frequency, with shapes in ``sprung.z`` and ``unsprung.z``."""
        mass, damping, stiffness = self.matrices()
        inverse = np.linalg.inv(mass)
        upper = np.hstack([np.zeros((2, 2)), np.eye(2)])
        values, vectors = np.linalg.eig(
            np.vstack([upper, np.hstack([-inverse @ stiffness, -inverse @ damping])])
        )
        modes = []
        for value, vector in zip(values, vectors.T, strict=True):
            if value.imag > 1e-9 * abs(value):
                shape = vector[:2] / vector[np.argmax(np.abs(vector[:2]))]
                shapes = {
                    name: (float(z.real), float(z.imag))
                    for name, z in zip(("sprung.z", "unsprung.z"), shape, strict=True)
                }
                size = float(abs(value))
                modes.append(
                    Mode(
                        size / (2 * np.pi),
                        float(value.imag) / (2 * np.pi),
                        float(-value.real / size),
                        shapes,
                    )
                )
        return tuple(sorted(modes, key=lambda mode: mode.frequency_hz))


def lump(rig: Rig) -> Lumping:
    """Reduce a corner to rates, damping and masses at the wheel, about static equilibrium.

    The body of the rig must be free along z. The result is exact for small motions on a vertical guide with ideal
    joints and a vertical tyre; bushings and rotation of the body are neglected.

    Examples
    --------
    >>> import jounce as jn
    >>> found = lump(jn.load("kart-double-wishbone"))
    >>> round(found.motion_ratio, 4), round(sum(found.static_masses), 2)   # cos(26 deg); 21.8 kg in all
    (0.8988, 21.8)
    """
    corner = _guide_vertically(rig)
    rest = equilibrium(corner)
    travel = rest["unsprung.z"] - rest["sprung.z"]
    at_rest = sweep_travel(corner, [travel]).isel(wheel_travel=0)
    below, here, above = rigs_along(corner, [travel - _NUDGE, travel, travel + _NUDGE])
    values = {str(name): float(value) for name, value in at_rest.data_vars.items()}
    spring_force = values.get("spring_force", 0.0) + values["stop_force"]
    return Lumping(
        travel,
        values["motion_ratio"],
        values["damper_motion_ratio"],
        values["motion_ratio_gradient"],
        corner.hardpoints.length("spring") - values["spring_length"],
        spring_force,
        values.get("heave_force", values["wheel_force"]),
        values["wheel_rate_spring"],
        values["wheel_rate"] - values["wheel_rate_spring"],
        _weight_rate(below, above),
        values.get("heave_rate", values["wheel_rate"]) - values["wheel_rate"],
        values.get("third_spring_motion_ratio", 0.0),
        values["wheel_damping_coefficient"] + values.get("third_damping_coefficient", 0.0),
        _tyre_slope(corner, rest["tyre.deflection"]),
        corner.tyre.damping_coefficient,
        float(corner.sprung.mass) if corner.sprung else 0.0,
        _shares(here),
        corner.gravity,
    )


def lumped_from(rig: Rig) -> QuarterCar:
    """Return the quarter car equivalent to a corner about static equilibrium.

    Parameters
    ----------
    rig : Rig
        A 3-D rig whose body is free along z.

    Returns
    -------
    QuarterCar
        The cosine of ``strut.angle`` is the damper's motion ratio; damper and friction therefore keep their laws. The
        spring rate reproduces the wheel rate, including the preload term, weights, torsion bar, and third spring and
        Z-bar in parallel wheel travel, minus the part that the damper's law contains. The preload is chosen for zero
        deflection at design. A third damper is added to the law of the damper. The masses reproduce both natural
        frequencies. A spring curve is replaced by its slope at rest; a tyre curve is kept. The bump stop engages at the
        same wheel travel. Rebound stops and bushings are omitted.

    Raises
    ------
    DescriptionError
        For a lumped rig, a fixed body, or a damper with a motion ratio that no strut angle can represent.
    SimulationError
        If there is no static equilibrium.

    Examples
    --------
    >>> import numpy as np
    >>> import jounce as jn
    >>> car = lumped_from(jn.load("kart-double-wishbone"))
    >>> round(float(np.degrees(car.strut.angle)), 1), round(car.sprung.mass, 1), round(car.unsprung.mass, 1)
    (26.0, 16.4, 5.0)
    """
    corner, lumping = _guide_vertically(rig), lump(rig)
    ratio = lumping.damper_ratio
    lowest = float(np.cos(LARGEST))
    if not lowest <= ratio <= 1.0 + 1e-12:
        raise DescriptionError(
            "no strut angle has this motion ratio",
            where="damper",
            found=f"{ratio:.4g}",
            allowed=Phrase("{lowest:.3g} to 1", lowest=lowest),
            hint="Describe the quarter car by hand, with rates and coefficients at the wheel.",
        )
    sprung, unsprung = lumping.effective_masses
    stop, stop_force, stop_rate = _stop(corner, lumping)
    damper = _damper(corner, lumping)
    gas, gas_rate = damper.at_rest(ratio * lumping.travel)
    rate = (lumping.wheel_rate - stop_rate * lumping.motion_ratio**2) / ratio**2 - gas_rate
    static = (lumping.wheel_force - stop_force * lumping.motion_ratio) / ratio - gas
    tyre = corner.tyre.model_dump(
        by_alias=True, exclude_none=True, exclude={"law", "undeformed_radius"}
    )
    table: dict[str, Any] = {
        "schema": "jounce.rig/1",
        "model": "quarter-car",
        "source": f"Lumped about rest from: {corner.source}"
        if corner.source
        else "Lumped from a 3-D rig about rest",
        "gravity": corner.gravity,
        "sprung": {"mass": sprung},
        "unsprung": {"mass": unsprung},
        "strut": {
            "angle": float(np.arccos(min(ratio, 1.0))),
            "spring": {"rate": rate, "preload": static - rate * ratio * lumping.travel},
            "damper": damper.model_dump(),
        },
        "tyre": tyre,
    }
    if corner.strut.friction is not None:
        table["strut"]["friction"] = corner.strut.friction.model_dump()
    if corner.guide_friction is not None:
        table["guide"] = {"friction": corner.guide_friction.model_dump()}
    if stop:
        table["strut"]["bump_stop"] = stop
    return QuarterCar.from_table(table)


def _guide_vertically(rig: Rig) -> Corner:
    """Mount the corner on a vertical guide with ideal joints."""
    if isinstance(rig, DependentAxle):
        return check_corner(rig)
    if not isinstance(rig, Corner):
        raise DescriptionError(
            "the rig is already lumped",
            where=getattr(rig, "model", "rig"),
            allowed="a rig with hardpoints: double-wishbone, mcpherson, five-link, trailing-arm",
        )
    if rig.guide == "fixed" or rig.sprung is None:
        raise DescriptionError(
            "a rig with a fixed body cannot be lumped",
            where="guide",
            found=rig.guide,
            allowed='"vertical" and a sprung mass',
        )
    table = rig.model_dump(by_alias=True, exclude_none=True)
    table.pop("bushings", None)
    return type(rig).from_table({**table, "guide": "vertical"})


def _shares(rig: Corner) -> dict[str, BodyShare]:
    """Return the shares of all bodies at the design position of ``rig``."""
    shares = {}
    for name, body in rig.body_masses().items():
        velocity, turn = body_motion(rig, name)
        at_centre = velocity + np.cross(turn, body.centre_of_mass)
        whole = body.mass * at_centre @ at_centre + turn @ body.inertia.tensor @ turn
        shares[name] = BodyShare(
            body.mass, float(at_centre[2]), float(whole - body.mass * at_centre[2])
        )
    return shares


def _weight_rate(below: Corner, above: Corner) -> float:
    """Return the rate of the bodies' weights at the wheel, N/m, from the change of their rise with travel."""
    shares = [_shares(rig) for rig in (below, above)]
    gained = sum(
        part.mass * (part.wheel_share - shares[0][name].wheel_share)
        for name, part in shares[1].items()
    )
    return below.gravity * gained / (2.0 * _NUDGE)


def _tyre_slope(rig: Corner, deflection: float) -> float:
    """Return the stiffness of the tyre at a deflection (m), N/m."""
    if deflection <= 0.0:
        raise SimulationError(
            "the wheel is not on the road", where="tyre.deflection", found=f"{deflection} m"
        )
    if rig.tyre.curve is None:
        assert rig.tyre.stiffness is not None
        return rig.tyre.stiffness
    step = 1e-6 * deflection
    upper, lower = (force_at(rig.tyre.curve, deflection + sign * step) for sign in (1.0, -1.0))
    return (upper - lower) / (2.0 * step)


def _stop(rig: Corner, lumping: Lumping) -> tuple[dict[str, float], float, float]:
    """Return the bump stop along the lumped strut, and its force (N) and stiffness (N/m) along the spring at rest."""
    stop, scale = rig.strut.bump_stop, lumping.motion_ratio / lumping.damper_ratio
    if stop is None:
        return {}, 0.0, 0.0
    depth = lumping.spring_deflection - stop.gap
    table = {
        "gap": lumping.damper_ratio * lumping.travel - depth / scale,
        "rate": stop.rate * scale**2,
        "progression": stop.progression * scale**4,
    }
    if depth <= 0.0:
        return table, 0.0, 0.0
    force = stop.rate * depth + stop.progression * depth**3
    return table, force, stop.rate + 3.0 * stop.progression * depth**2


def _damper(rig: Corner, lumping: Lumping) -> DamperLaw:
    """Return the damper of the lumped rig including the third damper; for a map, the row at its length at rest."""
    damper: DamperLaw = rig.strut.damper.at_length(
        rig.hardpoints.length("damper") - lumping.damper_ratio * lumping.travel
    )
    third = None if rig.third_spring is None else rig.third_spring.damper
    if third is None or lumping.third_ratio == 0.0:
        return damper
    own_points, third_points = (
        _law_points(damper, "strut.damper"),
        _law_points(third, "third_spring.damper"),
    )
    share = (
        lumping.third_ratio / lumping.damper_ratio
    )  # velocity of the third damper per velocity of the lumped one
    velocities = np.unique(np.round(np.concatenate([own_points[0], third_points[0] / share]), 12))
    both = on_lines(*own_points, velocities) + 0.5 * share * on_lines(
        *third_points, share * velocities
    )
    return VelocityTable(velocity=tuple(velocities.tolist()), force=tuple(both.tolist()))


def _law_points(damper: DamperLaw, where: str) -> tuple[Array, Array]:
    """Return velocities (m/s) and forces (N) of a piecewise linear damper."""
    points = damper.points()
    if points is None:
        raise DescriptionError(
            "a hysteretic damper combined with a third damper has no lumped equivalent",
            where=where,
            found=damper.kind,
            allowed="linear, bilinear, blow-off, table, or no third damper",
        )
    return points
