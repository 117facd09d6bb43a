"""Reactions of joints: the force and torque that hold a joint together, by Newton and Euler on what hangs on it."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import casadi as ca

from jounce.mechanics.bodies import Body, MassProperties

if TYPE_CHECKING:
    from jounce.mechanics.tree import Tree


@dataclass(frozen=True)
class Wrench:
    """A force (N) at a point and a torque (N m) on a body, in ground axes; ``source`` names the equation behind it."""

    body: Body
    force: ca.SX
    point: ca.SX
    torque: ca.SX
    source: str = ""

    @property
    def joint(self) -> str:
        """The joint that closes a loop by it; empty for applied forces."""
        return joint_of(self.source)


def joint_of(equation: str) -> str:
    """Joint that a loop equation, named ``<joint>.<direction>``, belongs to."""
    return re.sub(r"\.(x|y|z|across|across_2|tilt|tilt_2|twist|cross)$", "", equation)


@dataclass(frozen=True)
class Reaction:
    """Force (N) and torque (N m) that the first body of a joint puts on the second, at ``point``, in ground axes."""

    force: ca.SX
    torque: ca.SX
    point: ca.SX


def tree_reaction(tree: Tree, child: Body, bodies: Iterable[Body], wrenches: Iterable[Wrench]) -> Reaction:
    """Reaction of the joint that carries ``child``: inertia of all that hangs on it, less what else acts there.

    Parameters
    ----------
    tree : Tree
        Gives the accelerations.
    child : Body
        The body the joint carries; the reaction is given at its frame's origin.
    bodies : iterable of Body
        ``child`` and everything that hangs on it.
    wrenches : iterable of Wrench
        All that acts on those bodies but tree joints.
    """
    assert child.frame is not None
    origin = child.frame.origin.value
    force, torque = ca.SX(3, 1), ca.SX(3, 1)
    for body in bodies:
        if body.mass_properties is not None:
            centre, push, twist = _inertial(tree, body, body.mass_properties)
            force += push
            torque += ca.cross(centre - origin, push) + twist
    for wrench in wrenches:
        force -= wrench.force
        torque -= ca.cross(wrench.point - origin, wrench.force) + wrench.torque
    return Reaction(force, torque, origin)


def _inertial(tree: Tree, body: Body, properties: MassProperties) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Centre of mass, mass times its acceleration, and rate of the angular momentum about it."""
    assert body.frame is not None
    orientation, inertia = body.frame.orientation, properties.inertia
    centre = body.point(properties.centre)
    acceleration = centre.bias + tree.accelerated(centre.rate)
    spin = orientation.spin
    spin_rate = orientation.spin_bias + tree.accelerated(spin)
    twist = orientation.rotate(inertia @ spin_rate + ca.cross(spin, inertia @ spin))
    return centre.value, properties.mass * acceleration, twist


def kinetic_energy(bodies: Iterable[Body]) -> ca.SX:
    """Kinetic energy, J."""
    energy = ca.SX(0.0)
    for body in bodies:
        properties = body.mass_properties
        if properties is not None and body.frame is not None:
            velocity = body.carrier.velocity(body.point(properties.centre))
            turn = body.frame.orientation
            spin = turn.unrotate(body.spin) if body.carrier.moves else turn.spin
            energy += 0.5 * (properties.mass * ca.dot(velocity, velocity) + ca.dot(spin, properties.inertia @ spin))
    return energy


def weight_energy(bodies: Iterable[Body], gravity: ca.SX) -> ca.SX:
    """Potential energy of the weights against the design pose, J."""
    energy = ca.SX(0.0)
    for body in bodies:
        properties = body.mass_properties
        if properties is not None:
            rise = body.carrier.height(body.point(properties.centre).value) - properties.centre[2]
            energy += properties.mass * gravity * rise
    return energy
