"""A quarter car on a plate that an eccentric exciter drives, in the three readings of section 4 of paper 2."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca

from jounce.mechanics import Model, System, tyre_force
from jounce.mechanics.system import Track
from jounce.parts import QuarterCar

ANGLE = "excenter.angle"
"""Track of the models: angle of the exciter, rad; the plate is at its mean height at 0 and rises from there."""


@dataclass(frozen=True)
class Chain:
    """What stands between plate and body.

    Attributes
    ----------
    contact, dissipated : casadi.SX
        Force on the plate in N, compression positive, and the power that turns to heat in W.
    deflection, velocity : casadi.SX
        Of the spring, m and m/s, compression positive.
    spring, total : casadi.SX
        Force of the spring, and with its damper, N.
    """

    contact: ca.SX
    dissipated: ca.SX
    deflection: ca.SX
    velocity: ca.SX
    spring: ca.SX
    total: ca.SX


@dataclass(frozen=True)
class _Stand:
    """Heights of plate and body (m) and their rates (m/s)."""

    system: System
    rig: QuarterCar
    plate: ca.SX
    body: ca.SX

    @property
    def laws(self) -> tuple[ca.SX, ca.SX, ca.SX, ca.SX]:
        """Spring rate, damping coefficient, stiffness and damping coefficient of the tyre, SI."""
        paths = ("strut.spring.rate", "strut.damper.coefficient", "tyre.stiffness", "tyre.damping_coefficient")
        rate, damping, stiffness, pneumatic = (self.system.parameter(path) for path in paths)
        return rate, damping, stiffness, pneumatic


def plate_model(kind: str, rig: QuarterCar) -> Model:
    """Write the equations of a body on a driven plate; all heights are 0 where nothing is compressed.

    Parameters
    ----------
    kind : {"summed", "series", "two-mass"}
        Spring and tyre merged into one by adding their constants, one behind the other without a wheel's mass, or with
        it (the quarter car, whose tyre may leave the plate).
    rig : QuarterCar
        With linear spring and damper; its values matter only as parameters.

    Returns
    -------
    Model
        One track, :data:`ANGLE`; parameters are those of the rig, ``excenter.amplitude`` (m), ``plate.mass`` (kg) and
        ``spring.free_length`` (m).
    """
    system = System()
    angle = system.track(ANGLE)
    plate = system.parameter("excenter.amplitude") * ca.sin(angle.value)
    body = system.coordinate("sprung.z")
    mass = system.parameter("sprung.mass")
    system.point_mass(mass, body)
    system.force(body, -mass * system.parameter("gravity"))
    chain = CHAINS[kind](_Stand(system, rig, plate, body))
    _show(system, plate, body, chain)
    _drive(system, angle, plate, chain)
    return system.finish()


def _summed(stand: _Stand) -> Chain:
    """One spring and one damper with the sums of the constants."""
    rate, damping, stiffness, pneumatic = stand.laws
    deflection = stand.plate - stand.body
    velocity = stand.system.rate_of(deflection)
    spring = (rate + stiffness) * deflection
    total = spring + (damping + pneumatic) * velocity
    stand.system.force(stand.body, total)
    return Chain(total, (damping + pneumatic) * velocity**2, deflection, velocity, spring, total)


def _series(stand: _Stand) -> Chain:
    """Spring with damper on tyre with damper; the point between them has no mass, so its two forces are equal."""
    system, (rate, damping, stiffness, pneumatic) = stand.system, stand.laws
    wheel = system.internal_state("unsprung.z")
    body_velocity, plate_velocity = system.rate_of(stand.body), system.rate_of(stand.plate)
    pull = stiffness * (stand.plate - wheel) + pneumatic * plate_velocity
    velocity = (pull - rate * (wheel - stand.body) + damping * body_velocity) / (damping + pneumatic)
    system.set_internal_rate("unsprung.z", velocity)
    deflection, rising = wheel - stand.body, velocity - body_velocity
    spring = rate * deflection
    total = spring + damping * rising
    system.force(stand.body, total)
    dissipated = damping * rising**2 + pneumatic * (plate_velocity - velocity) ** 2
    return Chain(total, dissipated, deflection, rising, spring, total)


def _two_mass(stand: _Stand) -> Chain:
    """The quarter car."""
    system, (rate, damping, _, pneumatic) = stand.system, stand.laws
    wheel = system.coordinate("unsprung.z")
    mass = system.parameter("unsprung.mass")
    system.point_mass(mass, wheel)
    system.force(wheel, -mass * system.parameter("gravity"))
    deflection = wheel - stand.body
    velocity = system.rate_of(deflection)
    spring = rate * deflection
    total = spring + damping * velocity
    system.force(-deflection, total)
    tyre = stand.plate - wheel
    contact = tyre_force(system, stand.rig.tyre, tyre, system.rate_of(tyre))
    system.force(-tyre, contact)
    system.output("unsprung.z", wheel, "m", "wheel, height")
    dissipated = damping * velocity**2 + pneumatic * system.rate_of(tyre) ** 2
    return Chain(contact, dissipated, deflection, velocity, spring, total)


CHAINS: dict[str, Callable[[_Stand], Chain]] = {"summed": _summed, "series": _series, "two-mass": _two_mass}


def _show(system: System, plate: ca.SX, body: ca.SX, chain: Chain) -> None:
    length = system.parameter("spring.free_length") - chain.deflection
    system.output("sprung.z", body, "m", "body, height")
    system.output("sprung.az", system.acceleration_of(body), "m/s^2", "body, vertical acceleration")
    system.output("spring.deflection", chain.deflection, "m", "spring, compression")
    system.output("spring.length", length, "m", "spring, length")
    system.output("spring.force", chain.spring, "N", "spring, force without damper, compression positive")
    system.output("strut.force", chain.total, "N", "spring and damper, force, compression positive")
    system.output("stand.deflection", plate - body, "m", "all springs, compression between plate and body")
    system.output("tyre.force", chain.contact, "N", "force on the plate, compression positive")
    system.output("dampers.power", chain.dissipated, "W", "power that the dampers turn to heat")


def _drive(system: System, angle: Track, plate: ca.SX, chain: Chain) -> None:
    """What the drive has to give: the plate is guided without friction, the exciter works on it as a Scotch yoke."""
    weight = system.parameter("plate.mass") * (system.parameter("gravity") + system.acceleration_of(plate))
    force = chain.contact + weight
    torque = force * ca.jacobian(plate, angle.value)
    system.output("plate.z", plate, "m", "plate, height")
    system.output("plate.force", force, "N", "exciter on plate, up")
    system.output("excenter.torque", torque, "N*m", "torque of the drive on the exciter")
    system.output("excenter.power", torque * angle.rate, "W", "power of the drive")
