"""Rigs on a shock absorber tester: quarter car, axle or 3-D corner on plates moved by exciters.

Each plate is fixed to its exciter or mounted on a spring above it. The exciter's angle is a track (prescribed by the
drive) or, if the drive runs freely, a coordinate with the drive's inertia. At angle 0 the plate is at its mean height
and moves upwards.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca

from jounce.core.errors import AssemblyError
from jounce.mechanics import Mechanism, Model, System, Track
from jounce.mechanics.elements import friction_force
from jounce.models.attachments import add_tyre
from jounce.models.channels import show_height, show_tyre
from jounce.models.corner import TEMPLATES, add_strut, show_wheel, suspension
from jounce.models.linkage import Linkage
from jounce.models.lumped import add_wheel
from jounce.models.quarter_car import add_quarter_car
from jounce.parts.corners import Corner
from jounce.parts.rig import Rig
from jounce.parts.vehicles import FrontViewAxle, QuarterCar, Side

ANGLE, MOTOR = "excenter.angle", "motor.on"
"""Suffixes of the track names: exciter angle (rad), and applied share of the motor torque."""
SIDES = {"left": 1.0, "right": -1.0}
_CREEP = 0.5  # rad/s: speed below which the drive's dry friction is smoothed
_BOTTOM = -0.5 * ca.pi  # rest angle of a free exciter
_LIFTED = 0.02  # m: the equilibrium search starts with the plate pressed against the tyre


@dataclass(frozen=True)
class PlateForm:
    """Design of the plates: everything about a tester that affects the structure of the equations."""

    sprung: bool = False  # whether there is a spring between exciter and plate
    # wheels (``""``, ``"left"``, ``"right"``) whose exciter is moved by the drive's inertia; the others have tracks
    free: tuple[str, ...] = ()


@dataclass(frozen=True)
class Plate:
    """A plate under a wheel: heights of plate and exciter (m), exciter angle (rad), and prefix of its channels.

    ``pushed`` is the spring force on the plate (N, upwards), None for a rigid plate.
    """

    height: ca.SX
    exciter: ca.SX
    angle: ca.SX
    begin: str
    pushed: ca.SX | None


def tester_model(rig: Rig, form: PlateForm) -> Model:
    """Build the equations of a rig on a tester; only the structure of ``rig`` matters, not its values.

    Tracks are ``[<side>.]excenter.angle`` (rad) of driven and ``[<side>.]motor.on`` of free exciters. Parameters are
    those of the rig and, prefixed with ``tester.``, those of the tester. Raises AssemblyError for a rig without a tyre.
    """
    builders: dict[type[Rig], Callable[[Rig, PlateForm], System]] = {
        QuarterCar: _quarter_car,
        FrontViewAxle: _front_view,
        **dict.fromkeys(TEMPLATES, _corner),
    }
    if type(rig) not in builders:
        allowed = ", ".join(kind.__name__ for kind in builders)
        raise AssemblyError(
            "this rig does not fit on a tester", found=type(rig).__name__, allowed=allowed
        )
    return builders[type(rig)](rig, form).finish()


def _quarter_car(rig: Rig, form: PlateForm) -> System:
    assert isinstance(rig, QuarterCar)
    system = System()
    plate = _add_plate(system, form, "")
    _, contact = add_quarter_car(system, rig, plate.height)
    _show_plate(system, plate, contact)
    return system


def _corner(rig: Rig, form: PlateForm) -> System:
    assert isinstance(rig, Corner)
    mechanism = Mechanism()
    mechanism.gravity = mechanism.parameter("gravity")
    plate = _add_plate(mechanism, form, "")
    linkage = suspension(rig, mechanism)
    add_strut(linkage)
    rate = mechanism.rate_of(plate.height)
    tyre = add_tyre(linkage, Track(plate.height, rate, ca.SX(0.0)))
    mechanism.force(plate.height, -tyre.force)
    show_tyre(mechanism, tyre.deflection, tyre.force)
    _guide(linkage)
    show_wheel(linkage)
    _show_plate(mechanism, plate, tyre.force)
    return mechanism


def _guide(linkage: Linkage) -> None:
    """Add the friction of the body's guide and the heights of body and wheel."""
    mechanism, rig = linkage.mechanism, linkage.rig
    if rig.guide != "fixed":
        heave = mechanism.coordinate_named("sprung.distance")
        mechanism.force(
            heave,
            -friction_force(
                mechanism, rig.guide_friction, "guide_friction", mechanism.rate_of(heave)
            ),
        )
        show_height(mechanism, "sprung", heave, "sprung mass above design")
    centre = linkage.wheel_centre.value[2] - linkage.number("hardpoints.wheel_centre[2]")
    show_height(mechanism, "unsprung", centre, "wheel centre above design")


def _front_view(rig: Rig, form: PlateForm) -> System:
    assert isinstance(rig, FrontViewAxle)
    system = System()
    z, roll = system.coordinate("body.z"), system.coordinate("body.roll", "rad")
    mass, gravity = system.parameter("mass"), system.parameter("gravity")
    system.point_mass(mass, z)
    system.force(z, -mass * gravity)
    system.point_mass(system.parameter("roll_inertia"), roll)
    travels = {}
    for name, sign in SIDES.items():
        height = z + sign * system.parameter(f"{name}.distance") * roll
        plate = _add_plate(system, form, name)
        with system.within(name, f"{name}.wheel"):
            unsprung, contact = _add_wheel(system, getattr(rig, name), height, plate, gravity)
        travels[name] = unsprung - height
        _show_plate(system, plate, contact)
    twist = travels["left"] - travels["right"]
    system.force(-twist, system.parameter("anti_roll_bar_rate") * twist)
    show_height(system, "body", z, "centre of gravity of the body")
    system.output("body.roll", roll, "rad", "body roll, right side down positive")
    return system


def _add_wheel(
    system: System, side: Side, height: ca.SX, plate: Plate, gravity: ca.SX
) -> tuple[ca.SX, ca.SX]:
    """Add the wheel of one side under the body; return its height (m) and contact force (N)."""
    if isinstance(side.wheel, QuarterCar):
        return add_quarter_car(system, side.wheel, plate.height, sprung=height)
    return add_wheel(system, side.wheel, height, gravity, plate=plate.height)


def _add_plate(system: System, form: PlateForm, place: str) -> Plate:
    """Add exciter and plate of one wheel, with all forces except the tyre's."""
    begin = f"{place}." if place else ""
    free = place in form.free
    if free:
        angle = system.coordinates([begin + ANGLE], [f"{begin}{ANGLE} rate"], [_BOTTOM], ["rad"])[
            0
        ][0]
        _add_drive(system, angle, begin)
    else:
        angle = system.track(begin + ANGLE).value
    exciter = system.parameter("tester.amplitude") * ca.sin(angle)
    height = exciter
    if form.sprung:
        height = system.coordinates([f"{begin}plate.z"], [f"{begin}plate.vz"], [_LIFTED])[0][0]
    if form.sprung or free:
        mass = system.parameter("tester.plate_mass")
        system.point_mass(mass, height)
        system.force(height, -mass * system.parameter("gravity"))
    pushed = None
    if form.sprung:
        lift = exciter - height
        pushed = system.parameter("tester.plate_spring_rate") * lift
        pushed += system.parameter("tester.plate_damping_coefficient") * system.rate_of(lift)
        system.force(-lift, pushed)
    return Plate(height, exciter, angle, begin, pushed)


def _add_drive(system: System, angle: ca.SX, begin: str) -> None:
    """Add inertia and friction of a free drive, and the torque of its motor."""
    speed = system.rate_of(angle)
    system.point_mass(system.parameter("tester.drive.inertia"), angle)
    friction = system.parameter("tester.drive.friction_torque") * ca.tanh(speed / _CREEP)
    friction += system.parameter("tester.drive.viscous_friction") * speed
    no_load = 2.0 * ca.pi * system.parameter("tester.drive.motor.no_load_frequency")
    line = system.parameter("tester.drive.motor.stall_torque") * (1.0 - speed / no_load)
    torque = line * system.track(begin + MOTOR).value
    system.force(angle, torque - friction)
    system.output(f"{begin}drive.torque", friction, "N*m", "friction of the drive")
    system.output(f"{begin}motor.torque", torque, "N*m", "torque of the motor")


def _show_plate(system: System, plate: Plate, contact: ca.SX) -> None:
    """Add outputs of plate, exciter, force under the plate, and drive torque; the plate is guided without friction."""
    begin, mass = plate.begin, system.parameter("tester.plate_mass")
    acceleration, speed = system.acceleration_of(plate.height), system.rate_of(plate.angle)
    under = contact + mass * acceleration
    pushed = (
        plate.pushed if plate.pushed is not None else under + mass * system.parameter("gravity")
    )
    torque = pushed * ca.jacobian(plate.exciter, plate.angle)
    for name, value, unit, text in (
        ("plate.z", plate.height, "m", "plate, height"),
        ("plate.vz", system.rate_of(plate.height), "m/s", "plate, vertical velocity"),
        ("plate.az", acceleration, "m/s^2", "plate, vertical acceleration"),
        (
            "plate.force",
            under,
            "N",
            "force of a cell under the plate: contact force and plate inertia",
        ),
        ("excenter.z", plate.exciter, "m", "eccentric exciter, height"),
        ("excenter.frequency", speed / (2.0 * ca.pi), "Hz", "exciter, turns per second"),
        ("excenter.torque", torque, "N*m", "torque that the exciter takes from its drive"),
        ("excenter.power", torque * speed, "W", "power that the exciter takes from its drive"),
    ):
        system.output(begin + name, value, unit, text)
