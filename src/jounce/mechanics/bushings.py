"""Bushings of a mechanism: elastic joints in six directions, and rods with a bushing at one end."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca

from jounce.mechanics.bodies import Body
from jounce.mechanics.descriptions import Given, Known, Vector, place
from jounce.mechanics.frames import Frame
from jounce.mechanics.loads import Action, Between, refuse_one_point
from jounce.mechanics.mechanism import Mechanism
from jounce.mechanics.rotations import rotation_vector, unit
from jounce.mechanics.system import System

Curves = Callable[[int, ca.SX], tuple[ca.SX, ca.SX] | None]
"""Resistance (N, N m) and energy (J) of a bushing's curve in direction 0 to 5 at a displacement; None without it."""
_NONE = ca.SX(3, 1)
_SOFTEST = 1e-9  # N/m: replaces zero stiffness in the compliance along a rod


@dataclass(frozen=True)
class Deflection:
    """Displacement and force of a bushing, in the axes of its first body.

    Attributes
    ----------
    displacement, rotation : casadi.SX
        Motion of the second body relative to the first, m and rad; the rotation is axis times angle, up to 180 degrees.
    force, torque : casadi.SX
        Force and torque on the second body, N and N m.
    energy, power : casadi.SX
        Energy stored in it, J, and power absorbed by it, W: rate of the energy plus damping loss.
    """

    displacement: ca.SX
    rotation: ca.SX
    force: ca.SX
    torque: ca.SX
    energy: ca.SX
    power: ca.SX


@dataclass(frozen=True, eq=False)
class ElasticJoint(Between):
    """An elastic joint in six directions along the axes of its first body, or along own ``axes`` fixed to it.

    Its forces on the two bodies act at the same point and derive from an energy: a common motion of the bodies does no
    work on it, and an undamped bushing returns all energy. ``curves`` replace its stiffness in some directions.
    """

    at: Given = place()
    stiffness: Given = place(unit="N/m", at_least=0.0)
    damping: Given = place(unit="N*s/m", at_least=0.0)
    rotational_stiffness: Given = place(unit="N*m/rad", at_least=0.0)
    rotational_damping: Given = place(unit="N*m*s/rad", at_least=0.0)
    preload: Given = place(None, unit="N")
    rotational_preload: Given = place(None, unit="N*m")
    axes: ca.SX | None = None
    curves: Curves | None = None
    kind = "bushing"

    def action(self, system: System) -> Action:
        """Return its effects; displacement, rotation, force, torque, energy and power are shown to the caller."""
        del system
        first, second = self.first.frame, self.second.frame
        displacement, rate = _displacement(first, second, self.at)
        rotation, turning = rotation_vector(first.orientation.matrix.T @ second.orientation.matrix)
        spin = first.orientation.unrotate(second.orientation.ground_spin) - first.orientation.spin
        force, bent = self._law(0, displacement, rate, self.stiffness, self.damping, self.preload)
        twist, twisted = self._law(
            3,
            rotation,
            turning @ spin,
            self.rotational_stiffness,
            self.rotational_damping,
            self.rotational_preload,
        )
        torque = turning.T @ twist
        power = -ca.dot(force, rate) - ca.dot(torque, spin)
        outward = first.orientation.rotate
        wrenches = self.pair(second.point(self.at).value, outward(force), outward(torque))
        shown = (displacement, rotation, force, torque, bent + twisted, power)
        return Action(((rate, force), (spin, torque)), wrenches, shown=shown)

    def _law(
        self,
        start: int,
        displacement: ca.SX,
        rate: ca.SX,
        stiffness: ca.SX,
        damping: ca.SX,
        preload: ca.SX | None,
    ) -> tuple[ca.SX, ca.SX]:
        """Return load on the second body and energy of three directions, ``start`` is the first of them."""
        if self.axes is not None:
            displacement, rate = self.axes.T @ displacement, self.axes.T @ rate
        resistance, energy = stiffness * displacement, 0.5 * stiffness * displacement**2
        for i in range(3):
            law = self.curves(start + i, displacement[i]) if self.curves is not None else None
            if law is not None:
                resistance[i], energy[i] = law
        load = -resistance - damping * rate
        if preload is not None:
            load, energy = load + preload, energy - preload * displacement
        return load if self.axes is None else self.axes @ load, ca.sum1(energy)


@dataclass(frozen=True, eq=False)
class ElasticRod(Between):
    """A massless rod with a bushing at its first end."""

    at: Given = place()
    second_at: Given = place()
    stiffness: Given = place(unit="N/m", at_least=0.0)
    damping: Given = place(unit="N*s/m", at_least=0.0)
    axes: ca.SX | None = None
    kind = "elastic rod"

    def check(self, known: Known) -> None:
        """Refuse coincident ends: the rod takes its length and direction from the design pose."""
        super().check(known)
        refuse_one_point(self.name, known("second_at") - known("at"), "in the design pose")

    def action(self, system: System) -> Action:
        """Return its effects; tension (N) and absorbed power (W) are shown to the caller."""
        del system
        other = self.second.frame.point(self.second_at)
        reach, design = other - self.first.frame.point(self.at), self.second_at - self.at
        length = ca.sqrt(ca.dot(reach.value, reach.value))
        rate = ca.dot(reach.value, reach.rate) / length
        firm = self.stiffness + _SOFTEST
        along_axes = unit(design) if self.axes is None else self.axes.T @ unit(design)
        shares = along_axes**2 / firm
        along = 1.0 / ca.sum1(shares)
        loss = along**2 * ca.dot(shares, self.damping / firm)
        tension = along * (length - ca.sqrt(ca.dot(design, design))) + loss * rate
        wrenches = self.pair(other.value, -tension * reach.value / length)
        return Action(((rate, -tension),), wrenches, shown=(tension, tension * rate))


@dataclass(frozen=True, eq=False)
class SlidingBushing(Between):
    """A bushing on the second body, with its axes, that slides freely along a line of the first."""

    at: Given = place()
    axis: Given = place(unit="1")
    point: Given = place()
    stiffness: Given = place(unit="N/m", at_least=0.0)
    damping: Given = place(unit="N*s/m", at_least=0.0)
    axes: ca.SX | None = None
    kind = "sliding bushing"

    def action(self, system: System) -> Action:
        """Return its effects; force on the second body (N, its axes) and absorbed power (W) are shown to the caller."""
        fixed, own = self.second.frame.point(self.point), self.second.frame.orientation
        to_own = ca.SX.eye(3) if self.axes is None else self.axes.T
        apart = to_own @ own.unrotate(fixed.value - self.first.frame.point(self.at).value)
        along = to_own @ own.unrotate(self.first.frame.direction(self.axis).value)
        slid = ca.dot(along, self.stiffness * apart) / ca.dot(along, self.stiffness * along)
        gap = apart - slid * along
        rate = system.rate_of(gap)
        force = -self.stiffness * gap - self.damping * rate
        return Action(
            ((rate, force),),
            self.pair(fixed.value, own.rotate(to_own.T @ force)),
            shown=(to_own.T @ force, -ca.dot(force, rate)),
        )


def add_bushing(
    mechanism: Mechanism,
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
    """Add a bushing between two bodies, unloaded in the design pose.

    Parameters
    ----------
    mechanism : Mechanism
        The mechanism.
    name : str
        Its name.
    first, second : Body
        The bodies; the axes are those of the first.
    at : sequence of float, shape (3,)
        Its position in the design pose, m.
    stiffness, damping : sequence of float, shape (3,)
        N/m and N s/m.
    rotational_stiffness, rotational_damping : sequence of float, shape (3,)
        N m/rad and N m s/rad.

    Returns
    -------
    Deflection
        Displacement, force and energy, for use in outputs.

    Examples
    --------
    >>> from jounce.mechanics import Mechanism, add_bushing
    >>> mount = Mechanism()
    >>> engine = mount.body("engine", mass=120.0, centre_of_mass=(0.0, 0.0, 0.0), inertia=(6.0, 6.0, 4.0))
    >>> _ = mount.free("engine", engine)
    >>> soft = add_bushing(mount, "mount", mount.ground, engine, (0.0, 0.0, -0.2), (1e5, 1e5, 3e5))
    >>> mount.output("mount.force", soft.force[2], "N", "force of the mount on the engine, up positive")
    """
    law = ElasticJoint(
        name, first, second, at, stiffness, damping, rotational_stiffness, rotational_damping
    )
    return Deflection(*mechanism.act(law).shown)


def add_elastic_rod(
    mechanism: Mechanism,
    name: str,
    first: Body,
    second: Body,
    at: Vector,
    second_at: Vector,
    stiffness: Vector,
    damping: Vector = _NONE,
    axes: ca.SX | None = None,
) -> tuple[ca.SX, ca.SX]:
    """Connect two points by a massless rod with a bushing at its first end; return tension (N) and absorbed power (W).

    Such a rod carries only axial force, so only the bushing's compliance along the rod matters,
    ``sum e_i^2 / k_i`` with the rod's direction ``e`` in the design pose, and the equivalent damping with the same loss
    in slow motion. Rotational stiffness has no effect.

    Parameters
    ----------
    mechanism : Mechanism
        The mechanism.
    name : str
        Its name.
    first, second : Body
        The bodies.
    at, second_at : sequence of float, shape (3,)
        The ends in the design pose, m.
    stiffness, damping : sequence of float, shape (3,)
        Stiffness and damping of the bushing along the axes of the design pose, N/m and N s/m.
    axes : casadi.SX, shape (3, 3), optional
        Own axes of the bushing as columns, unit vectors in the design pose.
    """
    tension, power = mechanism.act(
        ElasticRod(name, first, second, at, second_at, stiffness, damping, axes)
    ).shown
    return tension, power


def add_sliding_bushing(
    mechanism: Mechanism,
    first: Body,
    second: Body,
    at: ca.SX,
    axis: ca.SX,
    point: ca.SX,
    stiffness: ca.SX,
    damping: ca.SX,
    axes: ca.SX | None = None,
) -> tuple[ca.SX, ca.SX]:
    """Support a point of the second body by a bushing that slides freely along a line of the first.

    The bushing has the axes of the second body, or own ``axes`` fixed to it (columns, in the design pose). Returns the
    force on the second body (N, in its axes) and the absorbed power (W).
    """
    law = SlidingBushing(
        "sliding bushing", first, second, at, axis, point, stiffness, damping, axes
    )
    force, power = mechanism.act(law).shown
    return force, power


def _displacement(first: Frame, second: Frame, at: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Return the displacement of the second body's point and its rate, in the axes of the first body."""
    orientation = first.orientation
    gap = second.point(at) - first.point(at)
    displacement = orientation.unrotate(gap.value)
    return displacement, orientation.unrotate(gap.rate) - ca.cross(orientation.spin, displacement)
