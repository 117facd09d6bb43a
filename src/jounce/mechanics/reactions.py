"""Reactions of joints, by Newton and Euler on what hangs on them, and of all that holds a mechanism otherwise.

Whatever acts is a force and a torque on bodies. A load or condition along an expression pushes every point that the
expression names along what the expression gains when that point moves; on a coordinate that it names, it acts between
the two bodies of its joint. So all that acts on what hangs on a joint is known, and what lacks is the joint's.

All is summed up in the ground's axes. What hangs in moving axes has its places, forces and accelerations in those.
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
    """Force (N) and torque (N m) that the first body of a joint puts on the second, at ``point``, in ground axes."""

    force: ca.SX
    torque: ca.SX
    point: ca.SX
    body: Body
    """The body that feels it."""

    def at(self, point: ca.SX) -> Reaction:
        """Give the same at another point."""
        return Reaction(self.force, self.torque + ca.cross(self.point - point, self.force), point, self.body)


@dataclass(frozen=True)
class Acting:
    """A wrench, the closure or condition it comes from (empty for loads), and the joint whose coordinate that holds."""

    wrench: Wrench
    source: str = ""
    through: str = ""


def reaction_of(mechanism: Structure, name: str, on: str | None = None) -> Reaction:
    """Reaction of a joint, closure or condition of a mechanism that has all its masses, weights and loads.

    ``on`` is the body that feels it: by default the second of a joint, and the last of all that a condition acts on.
    """
    acting = all_acting(mechanism)
    if name in mechanism.joints:
        hung = mechanism.hanging[name]
        hanging = {body.name for body in mechanism.hanging_on(hung.child)}
        # what holds a coordinate is transmitted by its joint, as by a motor in the hinge
        found = _newton_euler(
            mechanism,
            hung.child,
            [body for body in mechanism.bodies.values() if body.name in hanging],
            [one.wrench for one in acting if one.wrench.body.name in hanging and one.through != name],
        )
        bodies, felt = [hung.joint.first.itself.name, hung.joint.second.itself.name], hung.child.name
        on = on or bodies[1]
    else:
        own = [one.wrench for one in acting if one.source == name]
        if not own:
            raise unknown(
                name, [*mechanism.joints, *mechanism.closures, *mechanism.conditions], what="joint", where="reaction"
            )
        bodies = list(dict.fromkeys(one.body.name for one in own))
        if name in mechanism.closures:
            joint = mechanism.closing[name].joint
            bodies = [joint.first.itself.name, joint.second.itself.name]
        ordered = [body for body in mechanism.bodies if body in bodies]
        felt = on = on or (bodies[1] if name in mechanism.closures else ordered[-1])
        found = _summed(own, on, mechanism.bodies)
    if on not in bodies:
        raise unknown(on, bodies, what="body it acts on", where=f"reaction of {name}")
    force, torque, point = found if on == felt else (-found[0], -found[1], found[2])
    return Reaction(force, torque, point, mechanism.bodies[on])


def _summed(wrenches: Iterable[Wrench], on: str, bodies: dict[str, Body]) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Wrenches on one body, at the point of the first force; at the body's origin where none is a force."""
    own = [one for one in wrenches if one.body.name == on]
    at = next((one.point for one in own if one.force.nnz()), None)
    if at is None:
        at = _origin(bodies[on]) if on in bodies else ca.SX(3, 1)
    torque = sum((one.torque + ca.cross(one.point - at, one.force) for one in own if one.force.nnz()), ca.SX(3, 1))
    torque += sum((one.torque for one in own if not one.force.nnz()), ca.SX(3, 1))
    return sum((one.force for one in own), ca.SX(3, 1)), torque, at


def all_acting(mechanism: Structure) -> list[Acting]:
    """All that acts on the bodies of a mechanism but the joints of its tree, in the ground's axes."""
    found: list[Acting] = []
    for _, action in mechanism.loads:
        found += [Acting(wrench) for wrench in action.wrenches]
        for expression, force in action.along:
            found += [Acting(wrench) for wrench, _ in _along(mechanism, expression, force)]
        for rate, force in action.efforts:
            found += [Acting(wrench) for wrench, _ in _efforts(mechanism, rate, force)]
    for closed in mechanism.closing.values():
        for row, multiplier in zip(closed.rows, ca.vertsplit(closed.multipliers), strict=True):
            for body, sign in ((closed.joint.second, 1.0), (closed.joint.first, -1.0)):
                push = sign * multiplier
                found.append(Acting(Wrench(body, push * row.force, row.point, push * row.torque), closed.joint.name))
    for name, (condition, multiplier) in mechanism.conditions.items():
        wrenches = _along(mechanism, condition.expression, multiplier)
        found += [Acting(wrench, name, through) for wrench, through in wrenches]
    return [replace(one, wrench=_outward(one.wrench)) for one in found]


def _outward(wrench: Wrench) -> Wrench:
    """The same in the ground's axes, and on a body instead of its moving axes."""
    body, carrier = wrench.body, wrench.body.carrier
    if not carrier.moves:
        return wrench
    force, torque = (carrier.outward(part) if part.nnz() else part for part in (wrench.force, wrench.torque))
    return Wrench(body.itself, force, carrier.place(wrench.point), torque)


def _origin(body: Body) -> ca.SX:
    """Where the origin of a body's frame is, ground axes."""
    return body.carrier.place(body.frame.origin.value)


def _along(mechanism: Structure, expression: ca.SX, force: ca.SX) -> list[tuple[Wrench, str]]:
    """What a force along expressions is on bodies; for a coordinate with the joint it belongs to."""
    found = []
    for named in mechanism.poses.occurring(expression):
        push = ca.jacobian(expression, named.symbol).T @ force
        if named.is_point:
            found.append((Wrench(named.body, push, named.symbol), ""))
        else:
            found.append((Wrench(named.body, torque=ca.cross(named.symbol, push)), ""))
    own = ca.jtimes(expression, mechanism.collection.q, ca.vertcat(*mechanism.collection.rates))
    return found + _efforts(mechanism, own, force)


def _efforts(mechanism: Structure, rate: ca.SX, force: ca.SX) -> list[tuple[Wrench, str]]:
    """What a force on a rate is on the bodies of the joints by whose speeds it is made.

    What acts between the two bodies of a joint comes with its name. A quaternion is against the ground, or the moving
    axes that the body hangs in, and what holds it is nothing that a joint between two other bodies transmits.
    """
    collection = mechanism.collection
    share = ca.jacobian(rate, collection.v).T @ force
    each, found = dict(zip(collection.speeds, ca.vertsplit(share), strict=True)), []
    for name, hung in mechanism.hanging.items():
        if not any(each[speed].nnz() for speed in hung.speeds):
            continue
        still = _still(mechanism, hung.child)
        for speed, effort in zip(hung.speeds, hung.joint.efforts(hung.child, still), strict=True):
            for body, sign in ((effort.body, 1.0), (effort.other, -1.0)):
                push = sign * each[speed]
                through = name if {effort.body, effort.other} == {hung.parent, hung.child} else ""
                found.append((Wrench(body, push * effort.force, effort.point, push * effort.torque), through))
    return found


def _still(mechanism: Structure, body: Body) -> Body:
    """The ground, or the moving axes that a body hangs in."""
    axes = (one for one in mechanism.bodies.values() if one.axes_of is not None and one.carrier is body.carrier)
    return next(axes, mechanism.ground)


def _newton_euler(
    mechanism: Structure, child: Body, bodies: Iterable[Body], wrenches: Iterable[Wrench]
) -> tuple[ca.SX, ca.SX, ca.SX]:
    """What must act at the origin of ``child`` for all that hangs there to move as it does."""
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


def _inertial(mechanism: Structure, body: Body, properties: MassProperties) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Centre of mass, mass times its acceleration, and rate of the angular momentum about it.

    In moving axes it is the acceleration against the field that all masses feel there, such as that of their weights.
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
    return carrier.place(centre.value), properties.mass * carrier.outward(acceleration), outward(twist)
