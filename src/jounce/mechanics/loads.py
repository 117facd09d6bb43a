"""Loads: forces on points, between points, on coordinates and along any expression, one frozen class each.

A load defines its effects in ``action``: its power on the rates, and its forces and torques on the bodies for their
reactions. For a load along an expression :mod:`jounce.mechanics.reactions` finds these by differentiating the
expression along the motion of every body.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from jounce.core.errors import AssemblyError
from jounce.core.types import Array
from jounce.mechanics.bodies import Body
from jounce.mechanics.descriptions import Given, Known, NamedPart, law, place, quantity
from jounce.mechanics.frames import Moving
from jounce.mechanics.system import System

_NONE = ca.SX(3, 1)
_SLIDING = 3.0  # in regularisation rates: beyond this, friction is fully developed; tanh(3) = 0.995
_POINT = 1e-12  # m: a shorter line has no direction
SAME_POINT = 1e-9  # m: ends closer than this coincide by design


@dataclass(frozen=True)
class Wrench:
    """A force (N) at a point and a torque (N m) on a body, in ground axes."""

    body: Body
    force: ca.SX = _NONE
    point: ca.SX = _NONE
    torque: ca.SX = _NONE


@dataclass(frozen=True)
class Action:
    """Effects of a load."""

    power: tuple[tuple[ca.SX, ca.SX], ...] = ()  # rates, and forces that do power on them
    wrenches: tuple[Wrench, ...] = ()  # its forces and torques on bodies
    along: tuple[
        tuple[ca.SX, ca.SX], ...
    ] = ()  # expressions, and forces along them that are not included in the wrenches
    efforts: tuple[
        tuple[ca.SX, ca.SX], ...
    ] = ()  # rates, and forces on them that act on coordinates
    stored: tuple[ca.SX, ...] = ()  # energies, J
    lost: tuple[ca.SX, ...] = ()  # powers, W
    shown: tuple[ca.SX, ...] = ()  # results returned to the caller


@dataclass(frozen=True, eq=False)
class ForceElement(NamedPart):
    """A force law in a mechanism."""

    def action(self, system: System) -> Action:
        """Return the effects of the load."""
        raise NotImplementedError


@dataclass(frozen=True, eq=False)
class PointForce(ForceElement):
    """A force (N, ground axes) on a point of a body."""

    body: Body
    force: ca.SX = law("N")
    at: Moving = law("m")
    kind = "force"

    def action(self, system: System) -> Action:  # noqa: ARG002
        """Return the effects of the load."""
        power = (self.body.carrier.velocity(self.at), self.force)
        return Action((power,), (Wrench(self.body, self.force, self.at.value),))


@dataclass(frozen=True, eq=False)
class Torque(ForceElement):
    """A torque (N m, ground axes) on a body."""

    body: Body
    torque: ca.SX = law("N*m")
    kind = "torque"

    def action(self, system: System) -> Action:  # noqa: ARG002
        """Return the effects of the load."""
        return Action(((self.body.spin, self.torque),), (Wrench(self.body, torque=self.torque),))


@dataclass(frozen=True, eq=False)
class GeneralForce(ForceElement):
    """A force along an expression of coordinates and points of bodies."""

    length: str
    along: ca.SX = law("{length}")
    magnitude: ca.SX = law("{force}")
    kind = "force along an expression"
    positive = "to greater values of the expression"

    def units(self) -> dict[str, str]:
        """Return N and m, or N m and rad."""
        return _units_along(self.length)

    def action(self, system: System) -> Action:
        """Return the effects of the load."""
        return Action(
            ((system.rate_of(self.along), self.magnitude),), along=((self.along, self.magnitude),)
        )


@dataclass(frozen=True, eq=False)
class PowerOnRate(ForceElement):
    """A force given by the rate on which it does work."""

    rate: ca.SX = law("m/s or rad/s")
    magnitude: ca.SX = law("N or N*m")
    kind = "force on a rate"
    positive = "to greater values of the rate"

    def action(self, system: System) -> Action:  # noqa: ARG002
        """Return the effects of the load."""
        both = ((self.rate, self.magnitude),)
        return Action(both, efforts=both)


@dataclass(frozen=True, eq=False)
class Between(ForceElement):
    """A load between two bodies."""

    first: Body
    second: Body

    def apart(self, first: Moving, second: Moving, force: ca.SX) -> Action:
        """Return the action of a force (N) that pushes two points apart along the line between them."""
        reach = second - first
        along = reach.value / length_of(reach.value)
        power = (ca.dot(along, reach.rate), force)
        ends = ((self.first, first, -1.0), (self.second, second, 1.0))
        return Action(
            (power,),
            tuple(Wrench(body, sign * force * along, end.value) for body, end, sign in ends),
        )

    def pair(self, place: ca.SX, force: ca.SX, torque: ca.SX = _NONE) -> tuple[Wrench, ...]:
        """Return force and torque on the second body (ground axes) and their opposites on the first, at one point."""
        ends = ((self.first, -1.0), (self.second, 1.0))
        return tuple(Wrench(body, sign * force, place, sign * torque) for body, sign in ends)


@dataclass(frozen=True, eq=False)
class PushApart(Between):
    """A force (N) that pushes two points apart."""

    at: Moving = law("m")
    second_at: Moving = law("m")
    force: ca.SX = law("N")
    kind = "force between points"
    positive = "pushes the points apart"

    def action(self, system: System) -> Action:  # noqa: ARG002
        """Return the effects of the load."""
        return self.apart(self.at, self.second_at, self.force)


@dataclass(frozen=True, eq=False)
class ForceBetween(Between):
    """A force (N, axes of the bodies' carrier) on a point of the second body, and its opposite on the first."""

    at: Moving = law("m")
    force: ca.SX = law("N")
    kind = "force between bodies"
    positive = "on the second body"

    def action(self, system: System) -> Action:  # noqa: ARG002
        """Return the effects of the load."""
        frame = self.first.frame
        carried = frame.origin.rate + ca.cross(
            frame.orientation.ground_spin, self.at.value - frame.origin.value
        )
        return Action(((self.at.rate - carried, self.force),), self.pair(self.at.value, self.force))


@dataclass(frozen=True, eq=False)
class SpringDamper(Between):
    """A spring and damper between two points, or a user-defined law; compression positive."""

    at: Given = place()
    second_at: Given = place()
    free_length: Given = quantity("m", None, at_least=0.0)
    stiffness: Given = quantity("N/m", None, at_least=0.0)
    damping: Given = quantity("N*s/m", None, at_least=0.0)
    force: ca.SX | None = law("N", None)
    kind = "spring and damper"
    positive = "compression"

    def defaults(self) -> dict[str, ca.SX]:
        """Return defaults: the spring is unloaded in the design pose."""
        return (
            {} if self.force is not None else {"free_length": length_of(self.second_at - self.at)}
        )

    def action(self, system: System) -> Action:
        """Return its effects; length (m) and force (N) are shown to the caller."""
        del system
        first, second = self.first.frame.point(self.at), self.second.frame.point(self.second_at)
        reach = second - first
        length = length_of(reach.value)
        if self.force is not None:
            return _with(self.apart(first, second, self.force), shown=(length, self.force))
        rate = ca.dot(reach.value, reach.rate) / length
        free = self.defaults()["free_length"] if self.free_length is None else self.free_length
        force, stored, lost = _spring_and_damper(self.stiffness, length - free, self.damping, rate)
        return _with(
            self.apart(first, second, force), stored=stored, lost=lost, shown=(length, force)
        )


@dataclass(frozen=True, eq=False)
class RotationalSpringDamper(ForceElement):
    """A spring and damper on the angle of a joint, or a user-defined law; positive along the angle."""

    joint: str
    angle: ca.SX
    stiffness: Given = quantity("N*m/rad", None, at_least=0.0)
    free_angle: Given = quantity("rad", None)
    damping: Given = quantity("N*m*s/rad", None, at_least=0.0)
    torque: ca.SX | None = law("N*m", None)
    kind = "rotational spring and damper"
    positive = "along the angle"

    def action(self, system: System) -> Action:
        """Return its effects; the torque (N m) is shown to the caller."""
        rate, torque = system.rate_of(self.angle), self.torque
        if torque is not None:
            return Action(((rate, torque),), along=((self.angle, torque),), shown=(torque,))
        torque, stored, lost = _spring_and_damper(
            self.stiffness, self.angle - self.free_angle, self.damping, rate
        )
        return Action(
            ((rate, torque),),
            along=((self.angle, torque),),
            stored=stored,
            lost=lost,
            shown=(torque,),
        )


@dataclass(frozen=True, eq=False)
class OnCoordinate(ForceElement):
    """A load along a coordinate, in ``length`` (``m`` or ``rad``)."""

    length: str
    coordinate: ca.SX = law("{length}")

    def units(self) -> dict[str, str]:
        """Return N and m, or N m and rad."""
        return _units_along(self.length)

    def acts(
        self, system: System, force: ca.SX, stored: tuple[ca.SX, ...], lost: tuple[ca.SX, ...]
    ) -> Action:
        """Return the action of a force along the coordinate."""
        along = ((self.coordinate, force),)
        return Action(
            ((system.rate_of(self.coordinate), force),), (), along, (), stored, lost, (force,)
        )


@dataclass(frozen=True, eq=False)
class Stop(OnCoordinate):
    """Elastic stops of a coordinate's travel; in contact they also damp, but never pull."""

    stiffness: Given = quantity("{force}/{length}", above=0.0)
    damping: Given = quantity("{force}*s/{length}", at_least=0.0)
    lower: Given = quantity("{length}", None)
    upper: Given = quantity("{length}", None)
    kind = "stop"

    def check(self, known: Known) -> None:
        """Refuse a stop without limits, or with crossed limits."""
        super().check(known)
        if self.lower is None and self.upper is None:
            raise AssemblyError(
                "a travel stop without limits", where=self.name, hint="Give lower, upper, or both."
            )
        if self.lower is not None and self.upper is not None and known("lower") > known("upper"):
            limits, allowed = (
                f"{known('lower'):g} to {known('upper'):g} {self.length}",
                "lower not above upper",
            )
            raise AssemblyError(
                "the lower limit of the stop is above the upper one",
                where=self.name,
                found=limits,
                allowed=allowed,
            )

    def action(self, system: System) -> Action:
        """Return its effects; the force (N or N m) is shown to the caller."""
        total, stored, lost = ca.SX(0.0), [], []
        for tag, end, sign in (("lower", self.lower, 1.0), ("upper", self.upper, -1.0)):
            if end is None:
                continue
            depth = sign * (end - self.coordinate)
            rate = system.rate_of(depth)
            touched = system.switch(f"{self.name} {tag} touched", depth)
            pushing = system.switch(
                f"{self.name} {tag} pushing", self.stiffness * depth + self.damping * rate
            )
            stored.append(touched * 0.5 * self.stiffness * depth**2)
            push = pushing * (self.stiffness * depth + self.damping * rate)
            lost.append(touched * rate * (push - self.stiffness * depth))
            total += sign * touched * pushing * (self.stiffness * depth + self.damping * rate)
        return self.acts(system, total, tuple(stored), tuple(lost))


@dataclass(frozen=True, eq=False)
class CoordinateFriction(OnCoordinate):
    """Coulomb friction on a coordinate, with a smooth change of sign."""

    regularisation_rate: Given = quantity("{length}/s", above=0.0)
    force: Given = quantity("{force}", at_least=0.0)
    kind = "friction"

    def action(self, system: System) -> Action:
        """Return its effects; the force (N or N m) is shown to the caller."""
        rate = system.rate_of(self.coordinate)
        sharp = rate / self.regularisation_rate
        system.switch(
            f"{self.name} sliding", ca.fabs(sharp) - _SLIDING
        )  # steps end on both sides of the layer
        drag = -self.force * ca.tanh(sharp)
        return self.acts(system, drag, (), (-drag * rate,))


def _units_along(length: str) -> dict[str, str]:
    return {"length": length, "force": "N" if length == "m" else "N*m"}


def refuse_one_point(name: str, reach: Array, when: str) -> None:
    """Refuse two ends whose separation ``reach`` (m) is too short to define a direction."""
    if (length := float(np.linalg.norm(reach))) < SAME_POINT:
        raise AssemblyError(
            "both ends coincide, so its force has no direction",
            where=name,
            found=f"{length:g} m {when}",
            allowed="two points that differ",
            hint="Was a point copied? To hold two bodies together at a point, use a bushing or coincident().",
        )


def length_of(vector: ca.SX) -> ca.SX:
    """Return the length of a vector, m, above zero."""
    return ca.sqrt(ca.dot(vector, vector) + _POINT**2)


def _with(
    action: Action,
    *,
    stored: tuple[ca.SX, ...] = (),
    lost: tuple[ca.SX, ...] = (),
    shown: tuple[ca.SX, ...] = (),
) -> Action:
    return Action(action.power, action.wrenches, stored=stored, lost=lost, shown=shown)


def _spring_and_damper(
    stiffness: ca.SX, stretch: ca.SX, damping: ca.SX, rate: ca.SX
) -> tuple[ca.SX, tuple[ca.SX, ...], tuple[ca.SX, ...]]:
    """Return force, stored energy and dissipated power of a linear spring and damper for a stretch and its rate."""
    force = -stiffness * stretch - damping * rate
    return force, (0.5 * stiffness * stretch**2,), (damping * rate**2,)
