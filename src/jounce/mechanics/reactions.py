"""Reactions of joints, by Newton-Euler equations of the bodies they carry, and of closures and conditions.

Every load is a force and a torque on bodies. A load or condition along an expression acts on each point in the
expression along the gradient with respect to that point; for a coordinate in the expression, it acts between the two
bodies of the coordinate's joint. All other loads on the bodies carried by a joint are thus known, and the joint's
reaction is the remainder of their balance.

All sums are in ground axes. Positions, forces and accelerations of bodies in moving axes are expressed in those axes.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import casadi as ca

from jounce.core.errors import unknown
from jounce.mechanics.bodies import Body, MassProperties
from jounce.mechanics.carrier import MovingCarrier
from jounce.mechanics.loads import Wrench
from jounce.mechanics.structure import Structure


@dataclass(frozen=True)
class Reaction:
    """Force (N) and torque (N m) of a joint's first body on its second at ``point``, in ground axes."""

    force: ca.SX
    torque: ca.SX
    point: ca.SX
    body: Body
    """Body on which it acts."""

    def at(self, point: ca.SX) -> Reaction:
        """Return the same reaction at another point."""
        return Reaction(
            self.force, self.torque + ca.cross(self.point - point, self.force), point, self.body
        )


@dataclass(frozen=True)
class Acting:
    """A wrench, its closure or condition ("" for loads), and the joint whose coordinate is constrained."""

    wrench: Wrench
    source: str = ""
    through: str = ""


def reaction_of(mechanism: Structure, name: str, on: str | None = None) -> Reaction:
    """Return the reaction of a joint, closure or condition of a mechanism with all masses, weights and loads.

    ``on`` is the body on which it acts: by default a joint's second body, or the last body that a condition acts on.
    """
    acting = all_acting(mechanism)
    if name in mechanism.joints:
        hung = mechanism.hanging[name]
        hanging = {body.name for body in mechanism.hanging_on(hung.child)}
        # a force on a coordinate is transmitted by its joint, as by a motor in the hinge
        reaction = _newton_euler(
            mechanism,
            hung.child,
            [body for body in mechanism.bodies.values() if body.name in hanging],
            [
                item.wrench
                for item in acting
                if item.wrench.body.name in hanging and item.through != name
            ],
        )
        bodies, felt = (
            [hung.joint.first.itself.name, hung.joint.second.itself.name],
            hung.child.name,
        )
        on = on or bodies[1]
    else:
        own = [item.wrench for item in acting if item.source == name]
        if not own:
            raise unknown(
                name,
                [*mechanism.joints, *mechanism.closures, *mechanism.conditions],
                what="joint",
                where="reaction",
            )
        bodies = list(dict.fromkeys(wrench.body.name for wrench in own))
        if name in mechanism.closures:
            joint = mechanism.closing[name].joint
            bodies = [joint.first.itself.name, joint.second.itself.name]
        ordered = [body for body in mechanism.bodies if body in bodies]
        felt = on = on or (bodies[1] if name in mechanism.closures else ordered[-1])
        reaction = _sum_wrenches(own, on, mechanism.bodies)
    if on not in bodies:
        raise unknown(on, bodies, what="body it acts on", where=f"reaction of {name}")
    force, torque, point = reaction if on == felt else (-reaction[0], -reaction[1], reaction[2])
    return Reaction(force, torque, point, mechanism.bodies[on])


def _sum_wrenches(
    wrenches: Iterable[Wrench], on: str, bodies: dict[str, Body]
) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Sum the wrenches on a body at the point of the first force, or at the body's origin if there is no force."""
    own = [wrench for wrench in wrenches if wrench.body.name == on]
    at = next((wrench.point for wrench in own if wrench.force.nnz()), None)
    if at is None:
        at = _origin(bodies[on]) if on in bodies else ca.SX(3, 1)
    forces = [wrench for wrench in own if wrench.force.nnz()]
    torque = sum(
        (wrench.torque + ca.cross(wrench.point - at, wrench.force) for wrench in forces),
        ca.SX(3, 1),
    )
    torque += sum((wrench.torque for wrench in own if not wrench.force.nnz()), ca.SX(3, 1))
    return sum((wrench.force for wrench in own), ca.SX(3, 1)), torque, at


def all_acting(mechanism: Structure) -> list[Acting]:
    """Return all loads on the bodies of a mechanism except tree joint reactions, in ground axes."""
    acting: list[Acting] = []
    for _, action in mechanism.loads:
        acting += [Acting(wrench) for wrench in action.wrenches]
        for expression, force in action.along:
            acting += [Acting(wrench) for wrench, _ in _along(mechanism, expression, force)]
        for rate, force in action.efforts:
            acting += [Acting(wrench) for wrench, _ in _efforts(mechanism, rate, force)]
    for closed in mechanism.closing.values():
        for row, multiplier in zip(closed.rows, ca.vertsplit(closed.multipliers), strict=True):
            for body, sign in ((closed.joint.second, 1.0), (closed.joint.first, -1.0)):
                push = sign * multiplier
                acting.append(
                    Acting(
                        Wrench(body, push * row.force, row.point, push * row.torque),
                        closed.joint.name,
                    )
                )
    for name, (condition, multiplier) in mechanism.conditions.items():
        wrenches = _along(mechanism, condition.expression, multiplier)
        acting += [Acting(wrench, name, through) for wrench, through in wrenches]
    return [replace(item, wrench=_outward(item.wrench)) for item in acting]


def _outward(wrench: Wrench) -> Wrench:
    """Return the wrench in ground axes, acting on the body instead of its moving axes."""
    body, carrier = wrench.body, wrench.body.carrier
    if not carrier.moves:
        return wrench
    force, torque = (
        carrier.outward(part) if part.nnz() else part for part in (wrench.force, wrench.torque)
    )
    return Wrench(body.itself, force, carrier.place(wrench.point), torque)


def _origin(body: Body) -> ca.SX:
    """Return the origin of a body's frame, ground axes."""
    return body.carrier.place(body.frame.origin.value)


def _along(mechanism: Structure, expression: ca.SX, force: ca.SX) -> list[tuple[Wrench, str]]:
    """Return the wrenches of a force along expressions, each with the joint if it acts on a coordinate."""
    along = []
    for named in mechanism.poses.occurring(expression):
        push = ca.jacobian(expression, named.symbol).T @ force
        if named.is_point:
            along.append((Wrench(named.body, push, named.symbol), ""))
        else:
            along.append((Wrench(named.body, torque=ca.cross(named.symbol, push)), ""))
    own = ca.jtimes(expression, mechanism.collection.q, ca.vertcat(*mechanism.collection.rates))
    return along + _efforts(mechanism, own, force)


def _efforts(mechanism: Structure, rate: ca.SX, force: ca.SX) -> list[tuple[Wrench, str]]:
    """Return the wrenches of a force on a rate, on the bodies of the joints whose speeds occur in the rate.

    A wrench between the two bodies of a joint includes the joint's name. A quaternion is relative to the ground or to
    the body's moving axes; a force on it is therefore not transmitted by a joint between two other bodies.
    """
    collection = mechanism.collection
    share = ca.jacobian(rate, collection.v).T @ force
    each, efforts = dict(zip(collection.speeds, ca.vertsplit(share), strict=True)), []
    for name, hung in mechanism.hanging.items():
        if not any(each[speed].nnz() for speed in hung.speeds):
            continue
        still = _still(mechanism, hung.child)
        for speed, effort in zip(hung.speeds, hung.joint.efforts(hung.child, still), strict=True):
            for body, sign in ((effort.body, 1.0), (effort.other, -1.0)):
                push = sign * each[speed]
                through = name if {effort.body, effort.other} == {hung.parent, hung.child} else ""
                efforts.append(
                    (Wrench(body, push * effort.force, effort.point, push * effort.torque), through)
                )
    return efforts


def _still(mechanism: Structure, body: Body) -> Body:
    """Return the ground, or the moving axes of a body."""
    axes = (
        other
        for other in mechanism.bodies.values()
        if other.axes_of is not None and other.carrier is body.carrier
    )
    return next(axes, mechanism.ground)


def _newton_euler(
    mechanism: Structure, child: Body, bodies: Iterable[Body], wrenches: Iterable[Wrench]
) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Return the wrench at the origin of ``child`` required by its motion and that of all bodies it carries."""
    origin = _origin(child)
    force, torque = ca.SX(3, 1), ca.SX(3, 1)
    for body in bodies:
        if body.mass_properties is not None:
            centre, push, twist = _inertial(mechanism, body, body.mass_properties)
            force += push
            torque += ca.cross(centre - origin, push) + twist
    for wrench in wrenches:
        force -= wrench.force
        torque -= ca.cross(wrench.point - origin, wrench.force) + wrench.torque
    return force, torque, origin


def _inertial(
    mechanism: Structure, body: Body, properties: MassProperties
) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Return centre of mass, mass times its acceleration, and rate of the angular momentum about it.

    In moving axes the acceleration is relative to the field acting on all masses, such as gravity.
    """
    orientation, inertia, carrier = body.frame.orientation, properties.inertia, body.carrier
    centre = body.frame.point(properties.centre)
    if isinstance(carrier, MovingCarrier):
        acceleration, spin_rate = carrier.acceleration(centre), carrier.spin_bias(orientation)
        spin, tensor = carrier.spin(orientation), orientation.turned(inertia)
    else:
        acceleration, spin_rate = centre.bias, orientation.spin_bias
        spin, tensor = orientation.spin, inertia
    acceleration += mechanism.accelerated(carrier.velocity(centre))
    spin_rate += mechanism.accelerated(spin)
    twist = tensor @ spin_rate + ca.cross(spin, tensor @ spin)
    outward = carrier.outward if carrier.moves else orientation.rotate
    return (
        carrier.place(centre.value),
        properties.mass * carrier.outward(acceleration),
        outward(twist),
    )
