"""Full car on four 3-D corners with everything in ground axes: every joint sees the body's motion.

Far more operations than the shipped model, which writes the corners in the body's axes, and no step of that in common.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from jounce.mechanics import Mechanism, Model
from jounce.mechanics.bodies import Body
from jounce.mechanics.frames import Moving
from jounce.models.attachments import add_tyre, undeformed_radius
from jounce.models.channels import show_height
from jounce.models.corner import add_strut, build_linkage, show_wheel
from jounce.models.linkage import Linkage
from jounce.parts.vehicles import FullCar3D, SpatialAxle

_SIDES = {"left": 1.0, "right": -1.0}
_UP, _FORWARD, _LEFT = (ca.SX([*axis]) for axis in ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)))


@dataclass(frozen=True)
class _Wheel:
    """A corner on the road; travel against the body, undeformed radius and deflection in m, the tyre's load in N."""

    linkage: Linkage
    centre: Moving
    travel: ca.SX
    radius: ca.SX
    deflection: ca.SX
    load: ca.SX


def full_car_in_ground_axes(vehicle: FullCar3D) -> Model:
    """Write the equations of a full car on 3-D corners; the values in ``vehicle`` matter only through its structure."""
    mechanism = Mechanism()
    mechanism.gravity = mechanism.parameter("gravity")
    body = _body(mechanism)
    wheels: list[_Wheel] = []
    for name, axle, end in (("front", vehicle.front, 1.0), ("rear", vehicle.rear, -1.0)):
        left, right = (_corner(mechanism, body, name, axle, end, side) for side in _SIDES)
        twist = mechanism.parameter(f"{name}.anti_roll_bar_rate") * (left.travel - right.travel)
        mechanism.force(right.travel - left.travel, twist)
        wheels += [left, right]
    _drive(mechanism, body, wheels)
    mechanism.share(["sprung.distance rate", "attitude.angle rate", "attitude.second_angle rate"])
    mechanism.output("energy.kinetic", mechanism.kinetic_energy(), "J", "kinetic energy")
    mechanism.output("energy.weight", mechanism.weight_energy(), "J", "energy of the weights")
    return mechanism.finish()


def _body(mechanism: Mechanism) -> Body:
    """The body on its three freedoms; pitch is the turn about the car's y axis, then roll about its own x axis."""
    number = mechanism.parameter
    centre = ca.vertcat(0.0, 0.0, number("body.height"))
    pitch_inertia = number("body.pitch_inertia")
    inertia = ca.diag(ca.vertcat(number("body.roll_inertia"), pitch_inertia, pitch_inertia))
    body = mechanism.body("body", number("body.mass"), centre, inertia)
    carriage = mechanism.body("carriage")
    heave = mechanism.prismatic("sprung", mechanism.ground, carriage, axis=_UP)
    angles = mechanism.universal("attitude", carriage, body, centre, _LEFT, _FORWARD)
    for name, value, unit in (("z", heave, "m"), ("pitch", angles[0], "rad"), ("roll", angles[1], "rad")):
        mechanism.output(f"body.{name}", value, unit, f"body, {name}; from the design position")
    mechanism.output("body.vz", mechanism.rate_of(heave), "m/s", "centre of gravity of the body, vertical velocity")
    mechanism.output("body.az", mechanism.acceleration_of(heave), "m/s^2", "centre of gravity, vertical acceleration")
    for name, angle in (("pitch", angles[0]), ("roll", angles[1])):
        mechanism.output(f"body.{name}_rate", mechanism.rate_of(angle), "rad/s", f"body {name} rate")
        acceleration = mechanism.acceleration_of(angle)
        mechanism.output(f"body.{name}_acceleration", acceleration, "rad/s^2", f"body {name} acceleration")
    return body


def _corner(mechanism: Mechanism, body: Body, name: str, axle: SpatialAxle, end: float, side: str) -> _Wheel:
    """Hang one corner under the body and stand it on its road."""
    distance = mechanism.parameter(f"{name}.distance")
    with mechanism.within(f"{name}_{side}", f"{name}.corner"):
        ahead = end * distance - mechanism.parameter("hardpoints.wheel_centre[0]")
        linkage = build_linkage(axle.corner, mechanism, body, ahead=ahead, turned=_SIDES[side])
        road = mechanism.track("road.z")
        mechanism.output("road.z", road.value, "m", "road height under the wheel")
        add_strut(linkage)
        deflection, load = add_tyre(linkage, road)
        mechanism.output("tyre.deflection", deflection, "m", "tyre deflection from undeformed, compression positive")
        mechanism.output("tyre.force", load, "N", "contact force, compression positive")
        design = linkage.hardpoint("wheel_centre")
        centre = linkage.wheel_centre
        wheel, above = centre.value[2] - design[2], body.point(design).value[2] - design[2]
        travel = ca.dot(body.direction(ca.SX([0.0, 0.0, 1.0])).value, centre.value - body.point(design).value)
        show_height(mechanism, "unsprung", wheel, "wheel centre")
        show_height(mechanism, "sprung", above, "body above the wheel")
        show_wheel(linkage)
        radius = undeformed_radius(linkage)
    return _Wheel(linkage, centre, travel, radius, deflection, load)


def _drive(mechanism: Mechanism, body: Body, wheels: list[_Wheel]) -> None:
    """Let a pitch moment, a deceleration and a lateral acceleration act."""
    moment = mechanism.track("pitch_moment").value
    mechanism.apply_torque(body, moment * _LEFT)
    mechanism.output("body.pitch_moment", moment, "N*m", "moment given on the body, nose down positive")
    deceleration, lateral = (mechanism.track(name).value for name in ("deceleration", "lateral_acceleration"))
    inertia = deceleration * _FORWARD - lateral * _LEFT
    total = ca.SX(0.0)
    for part in mechanism.bodies.values():
        if part.mass_properties is not None:
            mechanism.apply_force(part, part.mass_properties.mass * inertia, part.mass_properties.centre)
            total += part.mass_properties.mass
    loads = sum((wheel.load for wheel in wheels), ca.SX(0.0))
    for wheel in wheels:
        grip = -total * inertia * wheel.load / ca.fmax(loads, 1.0)
        _push_at_road(wheel, grip)


def _push_at_road(wheel: _Wheel, force: ca.SX) -> None:
    """Let a force (N) act on the upright where the tyre touches the road."""
    upright, centre = wheel.linkage.upright, wheel.centre
    reach = -(wheel.radius - wheel.deflection) * _UP
    mechanism = wheel.linkage.mechanism
    mechanism.apply_force(
        upright, force, Moving(centre.value + reach, centre.rate + ca.cross(upright.spin, reach), _UP)
    )
