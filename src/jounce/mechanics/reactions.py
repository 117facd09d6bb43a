"""Reactions of joints, by Newton and Euler on what hangs on them, and of all that holds a mechanism otherwise.

Whatever acts is a force and a torque on bodies. A load or condition along an expression pushes every point that the
expression names along what the expression gains when that point moves; on a coordinate that it names, it acts between
the two bodies of its joint. So all that acts on what hangs on a joint is known, and what lacks is the joint's.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import casadi as ca

from jounce.core.errors import AssemblyError, unknown
from jounce.mechanics.bodies import Body, MassProperties
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
    for body in mechanism.bodies.values():
        if body.carrier.moves:
            hint = "Reactions are known where everything hangs on the ground."
            raise AssemblyError("not for what hangs in a moving frame", where=f"reaction of {name}", hint=hint)
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
        bodies, felt = [hung.joint.first.name, hung.joint.second.name], hung.child.name
        on = on or bodies[1]
    else:
        own = [one.wrench for one in acting if one.source == name]
        if not own:
            raise unknown(
                name, [*mechanism.joints, *mechanism.closures, *mechanism.conditions], what="joint", where="reaction"
            )
        bodies = list(dict.fromkeys(one.body.name for one in own))
        if name in mechanism.closures:
            bodies = [mechanism.closing[name].joint.first.name, mechanism.closing[name].joint.second.name]
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
        at = bodies[on].frame.origin.value if on in bodies else ca.SX(3, 1)
    torque = sum((one.torque + ca.cross(one.point - at, one.force) for one in own if one.force.nnz()), ca.SX(3, 1))
    torque += sum((one.torque for one in own if not one.force.nnz()), ca.SX(3, 1))
    return sum((one.force for one in own), ca.SX(3, 1)), torque, at


def all_acting(mechanism: Structure) -> list[Acting]:
    """All that acts on the bodies of a mechanism but the joints of its tree."""
    found = []
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
    return found


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

    What acts between the two bodies of a joint comes with its name. A quaternion is against the ground, and what holds
    it is nothing that a joint between two other bodies transmits.
    """
    collection = mechanism.collection
    share = ca.jacobian(rate, collection.v).T @ force
    each, found = dict(zip(collection.speeds, ca.vertsplit(share), strict=True)), []
    for name, hung in mechanism.hanging.items():
        if not any(each[speed].nnz() for speed in hung.speeds):
            continue
        for speed, effort in zip(hung.speeds, hung.joint.efforts(hung.child, mechanism.ground), strict=True):
            for body, sign in ((effort.body, 1.0), (effort.other, -1.0)):
                push = sign * each[speed]
                through = name if {effort.body, effort.other} == {hung.parent, hung.child} else ""
                found.append((Wrench(body, push * effort.force, effort.point, push * effort.torque), through))
    return found


def _newton_euler(
    mechanism: Structure, child: Body, bodies: Iterable[Body], wrenches: Iterable[Wrench]
) -> tuple[ca.SX, ca.SX, ca.SX]:
    """What must act at the origin of ``child`` for all that hangs there to move as it does."""
    origin = child.frame.origin.value
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
    """Centre of mass, mass times its acceleration, and rate of the angular momentum about it."""
    orientation, inertia = body.frame.orientation, properties.inertia
    centre = body.frame.point(properties.centre)
    acceleration = centre.bias + mechanism.accelerated(centre.rate)
    spin = orientation.spin
    spin_rate = orientation.spin_bias + mechanism.accelerated(spin)
    twist = orientation.rotate(inertia @ spin_rate + ca.cross(spin, inertia @ spin))
    return centre.value, properties.mass * acceleration, twist
