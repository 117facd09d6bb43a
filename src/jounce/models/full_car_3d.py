"""Full car on 3-D corners or dependent axles: the body heaves, pitches and rolls, its suspensions are mechanisms.

Driving loads act as on a real car: inertia of every body, and reacting forces at the contact patches, distributed in
proportion to the wheel loads. A constraint against sliding and yawing takes the small remainder.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca

from jounce.control.actuators import AnyActuator
from jounce.mechanics import Mechanism, Model, Track
from jounce.mechanics.bodies import Body
from jounce.mechanics.frames import Moving
from jounce.models.attachments import (
    Pressed,
    add_tyre,
    bar_angle,
    bar_on,
    bar_stiffness,
    link_end,
    lowest_point,
    t_bar_of,
    third_damper_law,
    third_end,
    third_law,
)
from jounce.models.axles import build_axle
from jounce.models.channels import (
    show_bushings,
    show_hardpoints,
    show_height,
    show_point,
    show_reactions,
    show_turn,
    show_tyre,
)
from jounce.models.corner import add_strut, build_linkage, show_bar, show_third_spring, show_wheel
from jounce.models.linkage import Linkage, Suspension
from jounce.parts.rig import structure_of
from jounce.parts.vehicles import FullCar3D, SpatialAxle

_SIDES, _ENDS = {"left": 1.0, "right": -1.0}, {"front": 1.0, "rear": -1.0}
_UP, _FORWARD, _LEFT = (
    ca.SX([*axis]) for axis in ((0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
)


@dataclass(frozen=True)
class _CornerOnRoad:
    """A corner on the road, with its travel relative to the body in m; ``scope`` prefixes its names and parameters."""

    scope: tuple[str, str]
    linkage: Suspension
    centre: Moving
    travel: ca.SX
    road: Track
    tyre: Pressed


def full_car_3d(
    vehicle: FullCar3D,
    *,
    detail: bool = False,
    actuator: AnyActuator | None = None,
    hang: Callable[..., Suspension] = build_linkage,
) -> Model:
    """Write the equations of a full car on 3-D corners; they depend only on the structure of ``vehicle``.

    With ``detail`` the outputs also include hardpoints and contact point of every corner, all joint reactions, and the
    kinetic and gravitational energy. ``hang`` adds a corner in the axes of the body; its arguments are those of
    ``build_linkage``.
    """
    mechanism = Mechanism()
    mechanism.gravity = mechanism.parameter("gravity")
    body = _body(mechanism, vehicle)
    drive = _driving(mechanism, body)
    frame = mechanism.moving_frame(body, drive - mechanism.gravity * _UP)
    axles = {name: getattr(vehicle, name) for name in _ENDS}
    wheels = [
        wheel
        for name, axle in axles.items()
        for wheel in _axle(mechanism, frame, name, axle, actuator, hang)
    ]
    for pair, name in zip((wheels[:2], wheels[2:]), axles, strict=True):
        _anti_roll_bar(pair, mechanism.parameter(f"{name}.anti_roll_bar_rate"))
        with mechanism.within(name, f"{name}.{axles[name].part}"):
            _third_spring(mechanism, pair)
            _described_bar(mechanism, pair)
    _grip(mechanism, body, drive, wheels)
    if detail:
        _show_detail(mechanism, wheels)
    # Apart from their linkages, axles hardly differ.
    alike = hang is not build_linkage or structure_of(axles["front"]) == structure_of(axles["rear"])
    independent = [name for name, axle in axles.items() if axle.axle is None]
    names = [(f"{name}_{side}", name) for name in independent for side in _SIDES]
    pairs = [(2 * i, 2 * i + 1) for i in range(len(independent))]
    if pairs:
        mechanism.alike(names, [(0, 1, 2, 3)] if alike and len(pairs) > 1 else pairs)
    return mechanism.finish()


def _body(mechanism: Mechanism, vehicle: FullCar3D) -> Body:
    """Add the body with heave and two rotations about its centre, or heave and any rotation about a joint."""
    number = mechanism.parameter
    centre = ca.vertcat(0.0, 0.0, number("body.height"))
    pitch_inertia = number("body.pitch_inertia")
    inertia = ca.diag(ca.vertcat(number("body.roll_inertia"), pitch_inertia, pitch_inertia))
    body = mechanism.body("body", number("body.mass"), centre, inertia)
    carriage = mechanism.body("carriage")
    heave = mechanism.prismatic("sprung", mechanism.ground, carriage, axis=_UP)
    if vehicle.body.joint is None:
        pitch, roll = ca.vertsplit(
            mechanism.universal("attitude", carriage, body, centre, _LEFT, _FORWARD)
        )
        _show_body(mechanism, heave, pitch, roll)
        mechanism.share(
            ["sprung.distance rate", "attitude.angle rate", "attitude.second_angle rate"]
        )
        return body
    joint = ca.vertcat(*(number(f"body.joint[{i}]") for i in range(3)))
    mechanism.spherical("guide_joint", carriage, body, at=joint)
    up, place = body.frame.orientation.unrotate(_UP), body.frame.point(centre).value
    _show_body(mechanism, place[2] - centre[2], -ca.asin(up[0]), ca.atan2(up[1], up[2]))
    for i, axis in enumerate("xy"):
        mechanism.output(
            f"body.{axis}",
            place[i],
            "m",
            f"centre of gravity of the body, {axis}; from the design position",
        )
    mechanism.share(["sprung.distance rate", *(f"guide_joint.w{axis}" for axis in "xyz")])
    return body


def _show_body(mechanism: Mechanism, height: ca.SX, pitch: ca.SX, roll: ca.SX) -> None:
    """Add channels of the body; pitch is the rotation about the car's y axis, then roll about its own x axis."""
    show_height(
        mechanism, "body", height, "centre of gravity of the body", ", z; from the design position"
    )
    show_turn(mechanism, "pitch", pitch)
    show_turn(mechanism, "roll", roll)


def _axle(
    mechanism: Mechanism,
    frame: Body,
    name: str,
    axle: SpatialAxle,
    actuator: AnyActuator | None,
    hang: Callable[..., Suspension],
) -> list[_CornerOnRoad]:
    """Add both wheels of an axle in the axes of the body, on their roads."""
    if axle.axle is not None:
        sides = build_axle(axle.axle, mechanism, frame, name, _SIDES)
        scopes = {side: (f"{name}_{side}", f"{name}.axle") for side in sides}
        return [
            _on_road(mechanism, scopes[side], linkage, actuator) for side, linkage in sides.items()
        ]
    assert axle.corner is not None
    distance = mechanism.parameter(f"{name}.distance")
    wheels = []
    for side, sign in _SIDES.items():
        scope = f"{name}_{side}", f"{name}.corner"
        with mechanism.within(*scope):
            end, turned = mechanism.constant("end", _ENDS[name]), mechanism.constant("side", sign)
            ahead = end * distance - mechanism.parameter("hardpoints.wheel_centre[0]")
            linkage = hang(axle.corner, mechanism, frame, ahead=ahead, turned=turned)
        wheels.append(_on_road(mechanism, scope, linkage, actuator))
    return wheels


def _on_road(
    mechanism: Mechanism,
    scope: tuple[str, str],
    linkage: Suspension,
    actuator: AnyActuator | None,
) -> _CornerOnRoad:
    """Add the road of a wheel, its strut and tyre, and its channels."""
    with mechanism.within(*scope):
        road = mechanism.track("road.z")
        mechanism.output("road.z", road.value, "m", "road height under the wheel")
        add_strut(linkage, actuator)
        tyre = add_tyre(linkage, road, actuator, law="radial")
        show_tyre(mechanism, tyre.deflection, tyre.force)
        design = linkage.hardpoint("wheel_centre")
        centre = linkage.wheel_centre
        for which, place, text in (
            ("unsprung", centre.value, "wheel centre"),
            ("sprung", design, "body above the wheel"),
        ):
            show_height(mechanism, which, linkage.carrier.height(place) - design[2], text)
        show_wheel(linkage)
    return _CornerOnRoad(scope, linkage, centre, centre.value[2] - design[2], road, tyre)


def _show_detail(mechanism: Mechanism, wheels: list[_CornerOnRoad]) -> None:
    """Add channels of positions, joint reactions and energies."""
    for wheel in wheels:
        assert isinstance(wheel.linkage, Linkage)
        with mechanism.within(*wheel.scope):
            show_hardpoints(wheel.linkage)
            show_point(mechanism, "contact_point", lowest_point(wheel.linkage, wheel.road.value))
            show_bushings(wheel.linkage)
    show_reactions(mechanism)
    mechanism.watch_energy()


def _anti_roll_bar(pair: list[_CornerOnRoad], rate: ca.SX) -> None:
    """Add a bar (N/m) that pushes the wheel with more travel down and the other wheel up."""
    twist = rate * (pair[0].travel - pair[1].travel)
    for wheel in pair:
        down = ca.vertcat(0.0, 0.0, -twist * wheel.linkage.side)
        wheel.linkage.push_off("anti_roll_bar", "upright", wheel.centre, down)


def _described_bar(mechanism: Mechanism, pair: list[_CornerOnRoad]) -> None:
    """Add the corner's anti-roll bar, twisted by the difference of its ends' rotations, or a Z-bar, by their sum."""
    bar = pair[0].linkage.rig.anti_roll_bar
    if bar is None:
        return
    if bar.kind == "t":
        held = t_bar_of(pair[0].linkage, pair[1].linkage)
        torque = bar_stiffness(pair[0].linkage) * held.twist
        for wheel, slope in zip(pair, held.twist_slopes, strict=True):
            pull = -torque * slope
            wheel.linkage.push_off(
                "anti_roll_bar", bar_on(wheel.linkage), link_end(wheel.linkage), pull
            )
        show_bar(mechanism, held.twist, torque)
        return
    signs, ends = (
        (1.0 if bar.kind == "z" else -1.0, 1.0),
        [bar_angle(wheel.linkage) for wheel in pair],
    )
    twist = sum(
        (s * end.value(w.linkage) for s, end, w in zip(signs, ends, pair, strict=True)), ca.SX(0.0)
    )
    torque = bar_stiffness(pair[0].linkage) * twist
    for sign, end, wheel in zip(signs, ends, pair, strict=True):
        wheel.linkage.press(end, -sign * torque)
    show_bar(mechanism, twist, torque)


def _third_spring(mechanism: Mechanism, pair: list[_CornerOnRoad]) -> None:
    """Add a third spring and damper between the left and the right side."""
    third = pair[0].linkage.rig.third_spring
    if third is None:
        return
    left, right = (wheel.linkage for wheel in pair)
    ends = third_end(left), third_end(right)
    reach = ends[1] - ends[0]
    length = ca.sqrt(ca.dot(reach.value, reach.value))
    deflection = 2.0 * left.side * left.hardpoint("third_spring_end")[1] - length
    force = third_law(left, length) + third_damper_law(
        left, deflection, mechanism.rate_of(deflection)
    )
    mechanism.push_apart(left.carrier_of(third.on), right.carrier_of(third.on), *ends, force)
    show_third_spring(mechanism, deflection, force)


def _driving(mechanism: Mechanism, body: Body) -> ca.SX:
    """Apply pitch moment, deceleration and lateral acceleration; return the inertial field, m/s^2."""
    moment = mechanism.track("pitch_moment").value
    mechanism.apply_torque(body, moment * _LEFT)
    mechanism.output(
        "body.pitch_moment", moment, "N*m", "moment given on the body, nose down positive"
    )
    deceleration, lateral = (
        mechanism.track(name).value for name in ("deceleration", "lateral_acceleration")
    )
    inertia = deceleration * _FORWARD - lateral * _LEFT
    assert body.mass_properties is not None
    mechanism.apply_force(body, body.mass_properties.mass * inertia, body.mass_properties.centre)
    return inertia


def _grip(mechanism: Mechanism, body: Body, drive: ca.SX, wheels: list[_CornerOnRoad]) -> None:
    """Apply the road's forces that react the inertia of driving (m/s^2), at each wheel by its share of the load."""
    assert body.mass_properties is not None
    mass = sum((wheel.linkage.mass for wheel in wheels), body.mass_properties.mass)
    loads = sum((wheel.tyre.force for wheel in wheels), ca.SX(0.0))
    needed = -mass * drive / ca.fmax(loads, 1.0)
    for wheel in wheels:
        force = wheel.linkage.carrier.inward(needed * wheel.tyre.force)
        mechanism.apply_force(wheel.linkage.upright, force, wheel.tyre.point)
