"""Bushings: elastic joints in six directions, and rods that end in one.

A bushing lies between a point of each of two bodies and pushes them back along and about the axes of the first body.
Its forces on both act at one and the same place, and they follow from an energy, so a motion of both bodies together
does no work on it and an undamped bushing gives back all it took.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import casadi as ca

from jounce.mechanics.bodies import Body
from jounce.mechanics.rotations import unit

if TYPE_CHECKING:
    from jounce.mechanics.tree import Tree, Vector

_NONE = ca.SX(3, 1)
_SOFTEST = 1e-9  # N/m: a direction without stiffness lets a rod go, and one that the rod does not use does not count


@dataclass(frozen=True)
class Deflection:
    """What a bushing does, in the axes of its first body.

    Attributes
    ----------
    displacement, rotation : casadi.SX
        Of the second body against the first, m and rad; a turn by an angle counts as its sine.
    force, torque : casadi.SX
        On the second body, N and N m.
    energy, power : casadi.SX
        Stored in it, J, and taken up by it, W: the rate of the energy and what damping loses.
    """

    displacement: ca.SX
    rotation: ca.SX
    force: ca.SX
    torque: ca.SX
    energy: ca.SX
    power: ca.SX


def add_bushing(
    tree: Tree,
    name: str,
    first: Body,
    second: Body,
    at: Vector,
    stiffness: Vector,
    *,
    damping: Vector = _NONE,
    rotational_stiffness: Vector = _NONE,
    rotational_damping: Vector = _NONE,
) -> Deflection:
    """Put a bushing between two bodies, unloaded in the design pose.

    Parameters
    ----------
    tree : Tree
        The mechanism.
    name : str
        Its name.
    first, second : Body
        The bodies; the axes are those of the first.
    at : sequence of float, shape (3,)
        Its place in the design pose, m.
    stiffness, damping : sequence of float, shape (3,)
        N/m and N s/m.
    rotational_stiffness, rotational_damping : sequence of float, shape (3,)
        N m/rad and N m s/rad.

    Returns
    -------
    Deflection
        For outputs.

    Examples
    --------
    >>> from jounce.mechanics import Mechanism, add_bushing
    >>> mount = Mechanism()
    >>> engine = mount.body("engine", mass=120.0, centre_of_mass=(0.0, 0.0, 0.0), inertia=(6.0, 6.0, 4.0))
    >>> _ = mount.free("engine", engine)
    >>> soft = add_bushing(mount, "mount", mount.ground, engine, (0.0, 0.0, -0.2), (1e5, 1e5, 3e5))
    >>> mount.output("mount.force", soft.force[2], "N", "force of the mount on the engine, up positive")
    """
    at = tree.vector(f"{name}.at", at)
    stiffness = tree.vector(f"{name}.stiffness", stiffness, "N/m")
    damping = tree.vector(f"{name}.damping", damping, "N*s/m")
    rotational_stiffness = tree.vector(f"{name}.rotational_stiffness", rotational_stiffness, "N*m/rad")
    rotational_damping = tree.vector(f"{name}.rotational_damping", rotational_damping, "N*m*s/rad")
    displacement, rate = _displacement(first, second, at)
    rotation, turning = _rotation(first, second)
    force = -stiffness * displacement - damping * rate
    spin = _relative_spin(first, second)
    twist = -rotational_stiffness * rotation - rotational_damping * (turning @ spin)
    torque = turning.T @ twist
    tree.load(rate, force)
    tree.load(spin, torque)
    _note_pair(tree, first, second, second.point(at).value, force, torque)
    energy = 0.5 * (ca.dot(displacement, stiffness * displacement) + ca.dot(rotation, rotational_stiffness * rotation))
    power = -ca.dot(force, rate) - ca.dot(torque, spin)
    return Deflection(displacement, rotation, force, torque, energy, power)


def add_elastic_rod(
    tree: Tree,
    name: str,
    first: Body,
    second: Body,
    at: Vector,
    second_at: Vector,
    stiffness: Vector,
    damping: Vector = _NONE,
) -> tuple[ca.SX, ca.SX]:
    """Tie two points by a massless rod with a bushing at its first end; give tension (N) and the power taken up (W).

    Such a rod only carries force along itself, so what counts of the bushing is its compliance along the rod,
    ``sum e_i^2 / k_i`` with the rod's direction ``e`` in the design pose, and the damping that loses as much in a slow
    motion. Its rotational stiffness has nothing to turn.

    Parameters
    ----------
    tree : Tree
        The mechanism.
    name : str
        Its name.
    first, second : Body
        The bodies.
    at, second_at : sequence of float, shape (3,)
        The ends in the design pose, m.
    stiffness, damping : sequence of float, shape (3,)
        Of the bushing along the axes of the design pose, N/m and N s/m.
    """
    at, second_at = tree.vector(f"{name}.at", at), tree.vector(f"{name}.second_at", second_at)
    stiffness = tree.vector(f"{name}.stiffness", stiffness, "N/m")
    damping = tree.vector(f"{name}.damping", damping, "N*s/m")
    one, other = first.point(at), second.point(second_at)
    reach, design = other - one, second_at - at
    length = ca.sqrt(ca.dot(reach.value, reach.value))
    rate = ca.dot(reach.value, reach.rate) / length
    firm = stiffness + _SOFTEST
    shares = unit(design) ** 2 / firm
    along = 1.0 / ca.sum1(shares)
    loss = along**2 * ca.dot(shares, damping / firm)
    tension = along * (length - ca.sqrt(ca.dot(design, design))) + loss * rate
    tree.load(rate, -tension)
    _note_pair(tree, first, second, other.value, -tension * reach.value / length, _NONE, in_ground=True)
    return tension, tension * rate


def add_sliding_bushing(
    tree: Tree, first: Body, second: Body, at: ca.SX, axis: ca.SX, point: ca.SX, stiffness: ca.SX, damping: ca.SX
) -> tuple[ca.SX, ca.SX]:
    """Hold a point of the second body by a bushing on a line of the first, along which it slides freely.

    Parameters
    ----------
    tree : Tree
        The mechanism.
    first, second : Body
        Body with the line, and body with the bushing, whose axes the bushing has.
    at, axis : casadi.SX, shape (3,)
        A point of the line and its direction in the design pose.
    point : casadi.SX, shape (3,)
        Place of the bushing in the design pose, on the line.
    stiffness, damping : casadi.SX, shape (3,)
        N/m and N s/m.

    Returns
    -------
    tuple of casadi.SX
        Force on the second body, N, in its axes, shape (3,), and the power taken up, W.
    """
    held, along = second.point(point), first.direction(axis)
    own = second.frame
    assert own is not None
    apart = own.orientation.unrotate(held.value - first.point(at).value)
    direction = own.orientation.unrotate(along.value)
    slid = ca.dot(direction, stiffness * apart) / ca.dot(direction, stiffness * direction)
    gap = apart - slid * direction
    rate = tree.rate_of(gap)
    force = -stiffness * gap - damping * rate
    tree.load(rate, force)
    _note_pair(tree, first, second, held.value, own.orientation.rotate(force), _NONE, in_ground=True)
    return force, -ca.dot(force, rate)


def _displacement(first: Body, second: Body, at: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Displacement of the second body's point in the axes of the first, and its rate there."""
    assert first.frame is not None
    orientation = first.frame.orientation
    gap = second.point(at) - first.point(at)
    displacement = orientation.unrotate(gap.value)
    return displacement, orientation.unrotate(gap.rate) - ca.cross(orientation.spin, displacement)


def _relative_spin(first: Body, second: Body) -> ca.SX:
    """Angular velocity of the second body against the first, in the axes of the first."""
    assert first.frame is not None
    assert second.frame is not None
    return first.frame.orientation.unrotate(second.frame.orientation.ground_spin) - first.frame.orientation.spin


def _rotation(first: Body, second: Body) -> tuple[ca.SX, ca.SX]:
    """Antisymmetric part of the relative rotation as a vector, and the matrix that turns the spin into its rate."""
    assert first.frame is not None
    assert second.frame is not None
    matrix = first.frame.orientation.matrix.T @ second.frame.orientation.matrix
    rotation = 0.5 * ca.vertcat(matrix[2, 1] - matrix[1, 2], matrix[0, 2] - matrix[2, 0], matrix[1, 0] - matrix[0, 1])
    return rotation, 0.5 * (ca.trace(matrix) * ca.SX.eye(3) - matrix)


def _note_pair(
    tree: Tree, first: Body, second: Body, place: ca.SX, force: ca.SX, torque: ca.SX, *, in_ground: bool = False
) -> None:
    """Note force and torque on the second body and their opposites on the first, at one place."""
    assert first.frame is not None
    turn = first.frame.orientation.rotate
    push, twist = (force, torque) if in_ground else (turn(force), turn(torque))
    for body, sign in ((first, -1.0), (second, 1.0)):
        tree.note(body, sign * push, place, sign * twist)
