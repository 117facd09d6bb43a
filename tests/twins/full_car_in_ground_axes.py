"""Full car on four 3-D corners with everything in ground axes: every joint sees the body's motion.

Far more operations than the shipped model, which writes the corners in the body's axes, and no step of that in common.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from jounce.mechanics import Mechanism, Model
from jounce.mechanics.bodies import Body
from jounce.mechanics.elements import tyre_force
from jounce.mechanics.frames import Moving
from jounce.models.attachments import undeformed_radius
from jounce.models.channels import show_hardpoints, show_height, show_reactions
from jounce.models.corner import add_strut, build_linkage, show_wheel
from jounce.models.linkage import Linkage
from jounce.parts.vehicles import FullCar3D, SpatialAxle

_SIDES = {"left": 1.0, "right": -1.0}
_UP, _FORWARD, _LEFT = (
    ca.SX([*axis]) for axis in ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
)


@dataclass(frozen=True)
class _Wheel:
    """A corner on the road: its axis, travel against the body and height over the road in m, the load in N."""

    linkage: Linkage
    centre: Moving
    axis: ca.SX
    travel: ca.SX
    height: ca.SX
    load: ca.SX


def full_car_in_ground_axes(vehicle: FullCar3D, *, detail: bool = False) -> Model:
    """Write the equations of a full car on 3-D corners; the values in ``vehicle`` matter only through its structure.

    With ``detail`` hardpoints and reactions of joints are seen, too; then the tyres push at their contact points, which
    they otherwise do along their deflections, as their energy says.
    """
    mechanism = Mechanism()
    mechanism.gravity = mechanism.parameter("gravity")
    body = _body(mechanism)
    wheels: list[_Wheel] = []
    for name, axle, end in (("front", vehicle.front, 1.0), ("rear", vehicle.rear, -1.0)):
        left, right = (
            _corner(mechanism, body, name, axle, end, side, at_points=detail) for side in _SIDES
        )
        twist = mechanism.parameter(f"{name}.anti_roll_bar_rate") * (left.travel - right.travel)
        for wheel, pushed in ((left, -twist), (right, twist)):
            force = pushed * body.direction(_UP).value
            mechanism.apply_force(wheel.linkage.upright, force, wheel.centre)
            arm = wheel.centre.value - body.frame.origin.value
            under = Moving(
                wheel.centre.value, body.frame.origin.rate + ca.cross(body.spin, arm), _UP
            )
            mechanism.apply_force(body, -force, under)
        if detail:
            for side, wheel in (("left", left), ("right", right)):
                with mechanism.within(f"{name}_{side}", f"{name}.corner"):
                    show_hardpoints(wheel.linkage)
        wheels += [left, right]
    _drive(mechanism, body, wheels)
    mechanism.share(["sprung.distance rate", "attitude.angle rate", "attitude.second_angle rate"])
    if detail:
        show_reactions(mechanism)
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
    for name, value, unit in (
        ("z", heave, "m"),
        ("pitch", angles[0], "rad"),
        ("roll", angles[1], "rad"),
    ):
        mechanism.output(f"body.{name}", value, unit, f"body, {name}; from the design position")
    mechanism.output(
        "body.vz",
        mechanism.rate_of(heave),
        "m/s",
        "centre of gravity of the body, vertical velocity",
    )
    mechanism.output(
        "body.az",
        mechanism.acceleration_of(heave),
        "m/s^2",
        "centre of gravity, vertical acceleration",
    )
    for name, angle in (("pitch", angles[0]), ("roll", angles[1])):
        mechanism.output(
            f"body.{name}_rate", mechanism.rate_of(angle), "rad/s", f"body {name} rate"
        )
        acceleration = mechanism.acceleration_of(angle)
        mechanism.output(
            f"body.{name}_acceleration", acceleration, "rad/s^2", f"body {name} acceleration"
        )
    return body


def _corner(
    mechanism: Mechanism,
    body: Body,
    name: str,
    axle: SpatialAxle,
    end: float,
    side: str,
    *,
    at_points: bool,
) -> _Wheel:
    """Hang one corner under the body and stand it on its road."""
    distance = mechanism.parameter(f"{name}.distance")
    with mechanism.within(f"{name}_{side}", f"{name}.corner"):
        ahead = end * distance - mechanism.parameter("hardpoints.wheel_centre[0]")
        linkage = build_linkage(axle.corner, mechanism, body, ahead=ahead, turned=_SIDES[side])
        road = mechanism.track("road.z")
        mechanism.output("road.z", road.value, "m", "road height under the wheel")
        add_strut(linkage)
        axis = linkage.spin_direction.value
        height = linkage.wheel_centre.value[2] - road.value
        deflection = undeformed_radius(linkage) - height / _cosine(axis)
        push = tyre_force(mechanism, linkage.rig.tyre, deflection, mechanism.rate_of(deflection))
        load = push / _cosine(axis)
        if not at_points:
            mechanism.force(deflection, -push)
        mechanism.output(
            "tyre.deflection",
            deflection,
            "m",
            "tyre deflection from undeformed, compression positive",
        )
        mechanism.output("tyre.force", load, "N", "contact force, compression positive")
        design = linkage.hardpoint("wheel_centre")
        centre = linkage.wheel_centre
        wheel, above = centre.value[2] - design[2], body.point(design).value[2] - design[2]
        travel = ca.dot(
            body.direction(ca.SX([0.0, 0.0, 1.0])).value, centre.value - body.point(design).value
        )
        show_height(mechanism, "unsprung", wheel, "wheel centre")
        show_height(mechanism, "sprung", above, "body above the wheel")
        show_wheel(linkage)
        wheel = _Wheel(linkage, centre, axis, travel, height, load)
        if at_points:
            _push_at_road(wheel, load * _UP)
    return wheel


def _cosine(axis: ca.SX) -> ca.SX:
    """Of the lean of a wheel with that axis."""
    return ca.sqrt(axis[0] ** 2 + axis[1] ** 2)


def _drive(mechanism: Mechanism, body: Body, wheels: list[_Wheel]) -> None:
    """Let a pitch moment, a deceleration and a lateral acceleration act."""
    moment = mechanism.track("pitch_moment").value
    mechanism.apply_torque(body, moment * _LEFT)
    mechanism.output(
        "body.pitch_moment", moment, "N*m", "moment given on the body, nose down positive"
    )
    deceleration, lateral = (
        mechanism.track(name).value for name in ("deceleration", "lateral_acceleration")
    )
    inertia = deceleration * _FORWARD - lateral * _LEFT
    total = ca.SX(0.0)
    for part in mechanism.bodies.values():
        if part.mass_properties is not None:
            mechanism.apply_force(
                part, part.mass_properties.mass * inertia, part.mass_properties.centre
            )
            total += part.mass_properties.mass
    loads = sum((wheel.load for wheel in wheels), ca.SX(0.0))
    for wheel in wheels:
        grip = -total * inertia * wheel.load / ca.fmax(loads, 1.0)
        _push_at_road(wheel, grip)


def _push_at_road(wheel: _Wheel, force: ca.SX) -> None:
    """Let a force (N) act on the upright where the tyre touches the road."""
    upright, centre, axis = wheel.linkage.upright, wheel.centre, wheel.axis
    inwards = ca.vertcat(axis[:2] / _cosine(axis), 0.0)  # level, across the wheel
    reach = wheel.height * (axis[2] / _cosine(axis) * inwards - _UP)
    mechanism = wheel.linkage.mechanism
    mechanism.apply_force(
        upright,
        force,
        Moving(centre.value + reach, centre.rate + ca.cross(upright.spin, reach), _UP),
    )
