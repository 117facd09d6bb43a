"""Structure of a mechanism: bodies, tree joints and closing joints, conditions and loads.

Reactions, signals and listings read it; the builder :class:`jounce.mechanics.Mechanism` fills it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca

from jounce.core.types import Array
from jounce.mechanics.bodies import Body, BodyFrames
from jounce.mechanics.expressions import expression_of
from jounce.mechanics.joints import ClosingEquation, Joint, JointCoordinates
from jounce.mechanics.loads import Action, ForceElement
from jounce.mechanics.system import System


@dataclass(frozen=True)
class HangingJoint:
    """A joint of the tree with its child body, and the names and symbols of its coordinates."""

    joint: Joint
    parent: Body
    child: Body
    motion: JointCoordinates
    coordinates: tuple[str, ...]
    quaternion: tuple[str, ...]
    speeds: tuple[str, ...]


@dataclass(frozen=True)
class Closing:
    """A joint that closes a loop, its equations and their multipliers."""

    joint: Joint
    rows: tuple[ClosingEquation, ...]
    multipliers: ca.SX


@dataclass(frozen=True)
class LoopExpression:
    """An expression constrained to zero: a ``condition``, a ``coupler`` of coordinates or a ``motion`` of one."""

    name: str
    kind: str
    expression: ca.SX


class Structure(System):
    """All parts of a mechanism, by name and in the order in which they were added."""

    gravity: ca.SX

    def __init__(self) -> None:
        super().__init__()
        self.poses = BodyFrames(self.collection)
        self.ground = Body("ground", self.poses)
        self.values: dict[str, float] = {}
        self.units: dict[str, str] = {}
        self.bodies: dict[str, Body] = {"ground": self.ground}
        self.hanging: dict[str, HangingJoint] = {}
        self.closing: dict[str, Closing] = {}
        self.conditions: dict[str, tuple[LoopExpression, ca.SX]] = {}
        self.loads: list[tuple[ForceElement, Action]] = []

    @property
    def parameters(self) -> tuple[str, ...]:
        """Paths of all parameters."""
        return tuple(self.collection.parameters)

    @property
    def tracks(self) -> tuple[str, ...]:
        """Names of all prescribed inputs."""
        return tuple(self.collection.tracks)

    @property
    def joints(self) -> tuple[str, ...]:
        """Names of the joints of the tree, from the ground outwards."""
        return tuple(self.hanging)

    @property
    def closures(self) -> tuple[str, ...]:
        """Names of the joints that close loops."""
        return tuple(self.closing)

    def growing(self) -> list[dict[Any, Any] | list[Any]]:
        """Return all containers that grow when parts are added."""
        return [*super().growing(), self.poses.frames, self.poses.named]

    def loops(self) -> dict[str, tuple[str, ...]]:
        """Return a map from each closing joint to the joints around its loop, itself first."""
        result = {}
        for name, closed in self.closing.items():
            around = [*self._branch(closed.joint.second), *self._branch(closed.joint.first)]
            result[name] = (name, *(joint for joint in around if around.count(joint) == 1))
        return result

    def _branch(self, body: Body) -> list[str]:
        """Return the joints from the ground to a body."""
        for name, hung in self.hanging.items():
            if hung.child is body:
                return [*self._branch(hung.parent), name]
        return []

    def hanging_on(self, root: Body) -> list[Body]:
        """Return a body and all bodies that it carries, including those in its moving axes."""
        result = [root]
        for hung in self.hanging.values():
            if any(hung.parent in (body, self.axes_of(body)) for body in result):
                result.append(hung.child)
        return result

    def axes_of(self, body: Body) -> Body | None:
        """Return the moving axes of a body, or None."""
        return next((axes for axes in self.bodies.values() if axes.axes_of is body), None)

    def mass_values(self, values: Mapping[str, float]) -> dict[str, tuple[float, Array]]:
        """Return mass (kg) and inertia (kg m^2, (3, 3)) of every body at parameter values."""
        p, numbers = (
            ca.vertcat(*self.collection.parameters.values()),
            [values[path] for path in self.parameters],
        )
        result = {}
        for body in self.bodies.values():
            if body.mass_properties is not None:
                properties = [body.mass_properties.mass, body.mass_properties.inertia]
                mass, inertia = ca.Function("mass", [p], properties)(numbers)
                result[body.name] = float(mass), inertia.full()
        return result

    def rate_of(self, expression: ca.SX) -> ca.SX:
        """Return the time derivative of an expression of coordinates, points of bodies and tracks."""
        return super().rate_of(self.poses.resolve(expression_of(expression, "rate")))

    def supplied_powers(self) -> list[ca.SX]:
        """Return the powers (W) of the motions prescribed by tracks."""
        tracks = self.collection.tracks.values()
        values, rates = (
            ca.vertcat(*(getattr(track, part) for track in tracks)) for part in ("value", "rate")
        )
        driven = [
            pair
            for pair in self.conditions.values()
            if tracks and ca.depends_on(pair[0].expression, values)
        ]
        return [
            -multiplier * ca.jtimes(condition.expression, values, rates)
            for condition, multiplier in driven
        ]
