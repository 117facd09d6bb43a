"""Forces on the bodies of a mechanism, their weights and masses, and what is kept account of for the energies."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from jounce.core.constants import GRAVITY
from jounce.core.errors import AssemblyError, unknown
from jounce.mechanics.bodies import Body, RigidMass, as_vector
from jounce.mechanics.carrier import Carried, MovingCarrier
from jounce.mechanics.frames import Moving
from jounce.mechanics.model import Model
from jounce.mechanics.tree import Number, Tree, Vector

_SLIDING = 3.0  # regularisation rates; tanh(3) = 0.995
_POINT = 1e-12  # m: a line shorter than that has no direction


class Loaded(Tree):
    """A tree of bodies with weights and forces.

    Parameters
    ----------
    gravity : float or casadi.SX
        m/s^2, along -z.
    """

    def __init__(self, gravity: Number = GRAVITY) -> None:
        super().__init__()
        self.gravity = self.number("gravity", gravity, "m/s^2")
        self._settled: set[str | int] = set()
        self._stored: list[ca.SX] = []
        self._lost: list[ca.SX] = []
        self._supplied: list[ca.SX] = []

    def apply_force(self, body: Body, force: ca.SX | Sequence[float], point: Moving | ca.SX | Sequence[float]) -> None:
        """Let a force (N, ground axes) act on a point of a body, given by ``body.point`` or its design place (m).

        Where a carrier moves the body, force and point are in the carrier's axes.
        """
        self._held("force", body)
        where, push = point if isinstance(point, Moving) else body.point(point), as_vector(force)
        self.load(body.carrier.velocity(where), push)
        self.note(body, push, where.value)

    def apply_torque(self, body: Body, torque: ca.SX | Sequence[float]) -> None:
        """Let a torque (N m, ground axes; its carrier's where one moves the body) act on a body."""
        self._held("torque", body)
        twist = as_vector(torque)
        self.load(body.spin, twist)
        self.note(body, torque=twist)

    def push_apart(self, first: Body, second: Body, at: Moving, second_at: Moving, force: ca.SX) -> None:
        """Let a force (N) push two points apart along the line between them."""
        reach = second_at - at
        along = reach.value / _length(reach.value)
        self.load(ca.dot(along, reach.rate), force)
        for body, point, sign in ((first, at, -1.0), (second, second_at, 1.0)):
            self.note(body, sign * force * along, point.value)

    def spring_damper(
        self,
        name: str,
        first: Body,
        second: Body,
        at: Vector,
        second_at: Vector,
        *,
        stiffness: Number = 0.0,
        damping: Number = 0.0,
        free_length: Number | None = None,
        force: ca.SX | None = None,
    ) -> tuple[ca.SX, ca.SX]:
        """Put a spring and damper between two points; give its length (m) and force (N, compression positive).

        Parameters
        ----------
        name : str
            Its name.
        first, second : Body
            The bodies it pushes apart.
        at, second_at : sequence of float, shape (3,)
            Its ends in the design pose, m.
        stiffness : float
            N/m.
        damping : float
            N s/m.
        free_length : float, optional
            m; by default the length in the design pose.
        force : casadi.SX, optional
            A law of your own in place of stiffness and damping, N, positive in compression.

        Returns
        -------
        tuple of casadi.SX
            Length and force.
        """
        self._held(name, first, second)
        places = self.vector(f"{name}.at", at), self.vector(f"{name}.second_at", second_at)
        ends = first.point(places[0]), second.point(places[1])
        reach = ends[1] - ends[0]
        length = _length(reach.value)
        if force is None:
            rate = ca.dot(reach.value, reach.rate) / length
            design = _length(places[1] - places[0])
            free = design if free_length is None else self.number(f"{name}.free_length", free_length, "m")
            force = self._spring_and_damper(
                self.number(f"{name}.stiffness", stiffness, "N/m"),
                length - free,
                self.number(f"{name}.damping", damping, "N*s/m"),
                rate,
            )
        self.push_apart(first, second, *ends, force)
        return length, force

    def rotational_spring_damper(
        self,
        name: str,
        joint: str,
        *,
        stiffness: Number = 0.0,
        damping: Number = 0.0,
        free_angle: Number = 0.0,
        torque: ca.SX | None = None,
    ) -> ca.SX:
        """Put a spring and damper on the angle of a revolute or cylindrical joint of the tree; give its torque (N m).

        Parameters
        ----------
        name : str
            Its name.
        joint : str
            The joint.
        stiffness : float
            N m/rad.
        damping : float
            N m s/rad.
        free_angle : float
            Angle without torque, rad.
        torque : casadi.SX, optional
            A law of your own (use ``coordinate_named`` and ``rate_of``), N m, positive along the angle.

        Returns
        -------
        casadi.SX
            Torque on the second body along the joint's axis.
        """
        if joint not in self._joints or f"{joint}.angle" not in self._coordinates:
            turning = [text for text in self._joints if f"{text}.angle" in self._coordinates]
            raise unknown(joint, turning, what="joint with an angle in the tree", where=name)
        angle = self._coordinates[f"{joint}.angle"]
        if torque is None:
            torque = self._spring_and_damper(
                self.number(f"{name}.stiffness", stiffness, "N*m/rad"),
                angle - self.number(f"{name}.free_angle", free_angle, "rad"),
                self.number(f"{name}.damping", damping, "N*m*s/rad"),
                self.rate_of(angle),
            )
        hung = self._joints[joint]
        assert hung.axis is not None
        along = hung.parent.direction(hung.axis).value * torque
        self.load(self.rate_of(angle), torque)
        self.note(hung.child, torque=along)
        self.note(hung.parent, torque=-along)
        return torque

    def stop(
        self,
        name: str,
        coordinate: ca.SX,
        *,
        lower: Number | None = None,
        upper: Number | None = None,
        stiffness: Number,
        damping: Number = 0.0,
    ) -> ca.SX:
        """Put elastic stops at the ends of a coordinate's travel; give their force or torque on it (N or N m).

        Parameters
        ----------
        name : str
            Its name.
        coordinate : casadi.SX
            What the joint gave, such as its angle or distance.
        lower, upper : float, optional
            Where they are touched, m or rad.
        stiffness : float
            N/m or N m/rad.
        damping : float
            N s/m or N m s/rad while touched; a stop does not pull, so the loss ends where it would.
        """
        self._check_condition(name, coordinate)
        length, push = ("rad", "N*m") if _is_angle(coordinate) else ("m", "N")
        firm, lossy = (
            self.number(f"{name}.stiffness", stiffness, f"{push}/{length}"),
            self.number(f"{name}.damping", damping, f"{push}*s/{length}"),
        )
        total = ca.SX(0.0)
        for tag, end, sign in (("lower", lower, 1.0), ("upper", upper, -1.0)):
            if end is None:
                continue
            depth = sign * (self.number(f"{name}.{tag}", end, length) - coordinate)
            rate = self.rate_of(depth)
            touched = self.switch(f"{name} {tag} touched", depth)
            pushing = self.switch(f"{name} {tag} pushing", firm * depth + lossy * rate)
            self._stored.append(touched * 0.5 * firm * depth**2)
            self._lost.append(touched * rate * (pushing * (firm * depth + lossy * rate) - firm * depth))
            total += sign * touched * pushing * (firm * depth + lossy * rate)
        self.force(coordinate, total)
        return total

    def friction(self, name: str, coordinate: ca.SX, force: Number, *, regularisation_rate: Number = 2e-3) -> ca.SX:
        """Put Coulomb friction on a coordinate; give its force or torque on it (N or N m).

        Parameters
        ----------
        name : str
            Its name.
        coordinate : casadi.SX
            What the joint gave, such as its angle or distance.
        force : float
            N or N m, whatever the joint carries.
        regularisation_rate : float
            m/s or rad/s: below about that rate the force turns over smoothly, so a joint that should stick creeps.
        """
        self._check_condition(name, coordinate)
        length, push = ("rad", "N*m") if _is_angle(coordinate) else ("m", "N")
        rate = self.rate_of(coordinate)
        sharp = rate / self.number(f"{name}.regularisation_rate", regularisation_rate, f"{length}/s")
        self.switch(f"{name} sliding", ca.fabs(sharp) - _SLIDING)
        drag = -self.number(f"{name}.force", force, push) * ca.tanh(sharp)
        self._lost.append(-drag * rate)
        self.force(coordinate, drag)
        return drag

    def _spring_and_damper(self, stiffness: ca.SX, stretch: ca.SX, damping: ca.SX, rate: ca.SX) -> ca.SX:
        """Force of a linear spring and damper against a stretch and its rate; its energies are kept account of."""
        self._stored.append(0.5 * stiffness * stretch**2)
        self._lost.append(damping * rate**2)
        return -stiffness * stretch - damping * rate

    def condition(self, name: str, expression: ca.SX) -> ca.SX:
        """Keep any expression of coordinates and tracks at zero; give its multiplier."""
        multiplier = super().condition(name, expression)
        values = ca.vertcat(*(track.value for track in self._tracks.values()))
        if self._tracks and ca.depends_on(ca.SX(expression), values):
            rates = ca.vertcat(*(track.rate for track in self._tracks.values()))
            self._supplied.append(-multiplier * ca.jtimes(ca.SX(expression), values, rates))
        return multiplier

    def power(self) -> ca.SX | None:
        """Power of all forces, weights among them, and of prescribed motions, W; None where a body moves by a track."""
        if any(joint.kind == "driven" for joint in self._joints.values()) and self._tracks:
            return None
        return sum((ca.dot(rate, force) for rate, force in self._loads), ca.SX(0.0)) + sum(self._supplied, ca.SX(0.0))

    def mass_matrix(self, model: Model) -> ca.Function:
        """Give the mass matrix (kg, kg m, kg m^2) of the speeds as a function of the model's x, u and p."""
        v = ca.vertcat(*self._speeds.values())
        matrix = ca.SX(v.shape[0], v.shape[0])
        for inertia in self._inertias:
            matrix += inertia.matrix(v)
        return ca.Function("mass", [model.x, model.u, model.p], [matrix])

    def mass_values(self, values: Mapping[str, float]) -> dict[str, tuple[float, NDArray[np.float64]]]:
        """Mass (kg) and inertia (kg m^2, (3, 3)) of every body at parameter values."""
        paths = list(self._parameters)
        p, numbers = ca.vertcat(*self._parameters.values()), [values[path] for path in paths]
        found = {}
        for body in self._bodies.values():
            properties = body.mass_properties
            if properties is not None:
                mass, inertia = ca.Function("mass", [p], [properties.mass, properties.inertia])(numbers)
                found[body.name] = float(mass), inertia.full()
        return found

    def settle(self) -> None:
        """Add masses and weights of all bodies that have theirs not yet; called by ``finish``."""
        for body in self._bodies.values():
            if body.frame is None:
                raise AssemblyError("the body hangs on nothing", where=body.name, hint="Give it a joint, or free().")
            properties = body.mass_properties
            if properties is not None and body.name not in self._settled and not body.carrier.moves:
                self.inertia(RigidMass(body.frame, properties))
                weight = ca.vertcat(0.0, 0.0, -properties.mass * self.gravity)
                self.apply_force(body, weight, body.point(properties.centre))
            self._settled.add(body.name)
        for carrier in {id(body.carrier): body.carrier for body in self._bodies.values()}.values():
            if isinstance(carrier, MovingCarrier) and id(carrier) not in self._settled:
                for group in _groups(body for body in self._bodies.values() if _is_on(body, carrier)):
                    self.inertia(carrier.masses([_carried(body) for body in group]))
                self._settled.add(id(carrier))


def _is_on(body: Body, carrier: MovingCarrier) -> bool:
    """Whether a body has mass and moves in some axes."""
    return body.carrier is carrier and body.mass_properties is not None


def _groups(bodies: Iterable[Body]) -> list[list[Body]]:
    """Bodies by the place they belong to, as their names say."""
    found: dict[str, list[Body]] = {}
    for body in bodies:
        found.setdefault(body.name.rpartition(".")[0], []).append(body)
    return list(found.values())


def _carried(body: Body) -> Carried:
    """A body with mass, in moving axes."""
    assert body.mass_properties is not None
    assert body.frame is not None
    properties, frame = body.mass_properties, body.frame
    alone = RigidMass(frame, properties)
    return Carried(properties.mass, frame.point(properties.centre), frame.orientation, properties.inertia, alone)


def _is_angle(coordinate: ca.SX) -> bool:
    """Whether what is given counts in radians."""
    return bool(coordinate.is_symbolic() and coordinate.name().endswith("angle"))


def _length(vector: ca.SX) -> ca.SX:
    """Length of a vector, m, above zero."""
    return ca.sqrt(ca.dot(vector, vector) + _POINT**2)
