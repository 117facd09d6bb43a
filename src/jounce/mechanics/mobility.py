"""Degrees of freedom of a mechanism: the motions that its joints allow, and those without force.

They are counted by the rank of the loop equations' Jacobian at a closed, non-singular pose. Assembly also checks
neighbouring poses; a motion that would stop within the next millimetre is therefore not reported as free.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from jounce.core.findings import Finding, finding
from jounce.core.remembered import Recent
from jounce.core.types import Array
from jounce.mechanics.assembly import Evaluator, close_loops, motions_left
from jounce.mechanics.bodies import Body
from jounce.mechanics.model import Model
from jounce.mechanics.structure import Structure

_NUDGE = 1e-4  # m or rad: step after which forces are compared
_NOTHING = 1e-6  # forces below this share of the largest are rounding errors
_STILL = 1e-6  # share of a motion, and slide (m) of a screw by a turn of 1 rad, below which it is not reported
_LISTED = 6  # maximum number of motions listed by a finding
_POSES = 64  # number of recent start poses cached per model


@dataclass(frozen=True)
class FreeMotion:
    """A motion that the joints allow in a pose.

    Attributes
    ----------
    body : str
        The body with most of the kinetic energy.
    axis : tuple of float
        Axis of its rotation, or direction of its translation (1), ground axes.
    point : tuple of float or None
        Point of the axis closest to the centre of mass, m; None if the body does not rotate.
    pitch : float
        Slide of the body along the axis per rotation, m/rad; 0 for a translation.
    moving : tuple of str
        All bodies that move.
    is_loaded : bool
        Whether a weight, spring, damper or other force acts along it, or would after a small step.
    """

    body: str
    axis: tuple[float, ...]
    point: tuple[float, ...] | None
    pitch: float
    moving: tuple[str, ...]
    is_loaded: bool

    def __str__(self) -> str:
        if self.point is None:
            return f"{self.body} slides along {_format_vector(self.axis)}"
        slide = f" and slides {self.pitch:.3g} m/rad along it" if abs(self.pitch) > _STILL else ""
        line = f"through {_format_vector(self.point)} m along {_format_vector(self.axis)}"
        return f"{self.body} turns about the line {line}{slide}"


@dataclass(frozen=True)
class Mobility:
    """Degrees of freedom of a mechanism in a pose.

    Attributes
    ----------
    degrees_of_freedom : int
        Number of independent motions allowed by the joints and prescribed motions.
    count : int
        Count by Grübler's formula: 6 per body minus all equations. Each redundant equation makes it too low by one.
    redundant : tuple of tuple of str
        Groups of loop equations, in each of which one follows from the others: these joints are over-constrained.
    motions : tuple of FreeMotion
        The free motions, one for each degree of freedom.
    """

    degrees_of_freedom: int
    count: int
    redundant: tuple[tuple[str, ...], ...]
    motions: tuple[FreeMotion, ...]

    def __str__(self) -> str:
        lines = [f"degrees of freedom: {self.degrees_of_freedom} (Grübler: {self.count})"]
        lines += [
            f"  {motion}{'' if motion.is_loaded else '; no force acts along it'}"
            for motion in self.motions
        ]
        lines += [f"redundant: one of {', '.join(group)}" for group in self.redundant]
        return "\n".join(lines)

    def findings(self, *, is_driven: bool) -> Iterator[Finding]:
        """Report motions with loops, motions without force, redundant equations, and a rigid mechanism."""
        if self.motions:
            yield finding(
                "mechanics.freedoms_left", "degrees of freedom", motions=_list_motions(self.motions)
            )
        elif not is_driven:
            yield finding("mechanics.nothing_moves", "degrees of freedom")
        if self.redundant:
            names = ", ".join(name for group in self.redundant for name in group)
            yield finding("mechanics.redundant_equations", "degrees of freedom", names=names)
        if idle := [motion for motion in self.motions if not motion.is_loaded]:
            yield finding(
                "mechanics.no_force_along",
                "degrees of freedom",
                motions=_list_motions(idle, len(self.motions)),
            )


def _list_motions(motions: Sequence[FreeMotion], of: int = 0) -> str:
    more = [f"and {len(motions) - _LISTED} more"] if len(motions) > _LISTED else []
    return f"{len(motions)}{f' of {of}' if of else ''}: {'; '.join([*map(str, motions[:_LISTED]), *more])}"


def _format_vector(vector: tuple[float, ...]) -> str:
    return f"({', '.join(f'{round(part, 4) + 0.0:.4g}' for part in vector)})"


class Freedoms:
    """Counts the degrees of freedom of a mechanism's model and caches the results; created once per model."""

    def __init__(self, mechanism: Structure, model: Model, force: ca.Function) -> None:
        """``force`` is the generalised force of all loads (N, N m) as a function of x, u, p and m."""
        every = [
            equation.name
            for constraint in mechanism.collection.constraints
            for equation in constraint.equations
        ]
        self._left_out = tuple((name,) for name in every if name not in model.constraints)
        self._count = len(model.speeds) - len(every)
        self._model, self._force = model, force
        bodies = [
            body
            for body in mechanism.bodies.values()
            if body.is_placed and body is not mechanism.ground
        ]
        self._is_carried = any(body.carrier.moves for body in bodies)
        self._names = tuple(body.name for body in bodies)
        n_q, n_v = model.facts.counts
        v = model.x[n_q : n_q + n_v]
        self._bodies = ca.Function(
            "bodies",
            [model.x, model.u, model.p],
            [ca.vertcat(*(_motion(body, v) for body in bodies))],
        )
        self._known = Recent[Mobility](_POSES)

    def at(
        self, x: Array, u: Array, p: Array, redundant: tuple[tuple[str, ...], ...] = ()
    ) -> Mobility:
        """Return the degrees of freedom at a closed, non-singular state; ``redundant`` are known redundant groups."""

        def make() -> Mobility:
            motions = self._motions(Evaluator(self._model, p, u), x)
            return Mobility(len(motions), self._count, redundant + self._left_out, motions)

        return self._known.of((x.tobytes(), u.tobytes(), p.tobytes(), redundant), make)

    def _motions(self, evaluator: Evaluator, x: Array) -> tuple[FreeMotion, ...]:
        """Return the motions that the joints allow, those with a force first."""
        directions = motions_left(evaluator.at(x)[1])
        if not directions.shape[1]:
            return ()
        loaded, unloaded = self._by_force(evaluator, x, directions)
        each = np.split(self._bodies(x, evaluator.u, evaluator.p).full(), len(self._names))

        def describe(way: Array, *, is_loaded: bool) -> FreeMotion:
            moves, energies = [], []
            for part in each:
                centre, (mass, inertia, _) = part[:, 0], part[:, 1]
                rate, spin = part[:, 2 : 2 + len(way)] @ way, part[:, 2 + len(way) :] @ way
                moves.append((centre, rate, spin))
                energies.append(
                    (mass * rate @ rate + inertia * spin @ spin, rate @ rate + spin @ spin)
                )
            most = max(range(len(each)), key=energies.__getitem__)
            centre, rate, spin = moves[most]
            largest = max(size for _, size in energies)
            moving = tuple(
                name
                for name, (_, size) in zip(self._names, energies, strict=True)
                if size > _STILL**2 * largest
            )
            turn, speed = float(np.linalg.norm(spin)), float(np.linalg.norm(rate))
            slides = turn <= _STILL * speed
            axis = rate / (speed or 1.0) if slides else spin / turn
            point = None if slides else tuple(map(float, centre + np.cross(spin, rate) / turn**2))
            pitch = 0.0 if slides else float(spin @ rate) / turn**2
            return FreeMotion(
                self._names[most], tuple(map(float, axis)), point, pitch, moving, is_loaded
            )

        both = ((loaded, True), (unloaded, False))
        return tuple(
            describe(way, is_loaded=is_loaded)
            for part, is_loaded in both
            for way in _readable(part).T
        )

    def _by_force(self, evaluator: Evaluator, x: Array, directions: Array) -> tuple[Array, Array]:
        """Split motions into those with and without force in the pose, at a small speed, or after a small step."""
        if self._is_carried:
            return directions, directions[
                :, :0
            ]  # the inertial forces include weights of bodies in moving axes
        model, n_q, n_v = evaluator.model, evaluator.n_q, evaluator.n_v
        active = np.ones(len(model.switches))  # include stops that are not in contact

        def force(x: Array, left: Array) -> Array:
            """Return the force along the remaining motions at a state."""
            return np.asarray(
                left @ (left.T @ self._force(x, evaluator.u, evaluator.p, active).full()[:, 0])
            )

        def forces() -> Iterator[Array]:
            """Yield forces, the cheapest to compute first."""
            reference = force(x, directions)
            yield reference
            steps = [sign * direction for direction in directions.T for sign in (_NUDGE, -_NUDGE)]
            for step in steps:
                moving = x.copy()
                moving[n_q : n_q + n_v] += step
                yield (force(moving, directions) - reference) / _NUDGE
            for step in steps:
                near = close_loops(evaluator, evaluator.move(x, step), np.ones(n_v))
                yield (force(near, motions_left(evaluator.at(near)[1])) - reference) / _NUDGE

        rows: list[Array] = []
        for row in forces():
            rows.append(row @ directions)
            _, values, right = np.linalg.svd(np.array(rows))
            rank = int(np.sum(values > _NOTHING * max(1.0, np.max(values, initial=0.0))))
            if rank == directions.shape[1]:
                break
        return directions @ right[:rank].T, directions @ right[rank:].T


def _motion(body: Body, v: ca.SX) -> ca.SX:
    """Return a body's centre, mass and trace of its inertia, then the slopes of its velocity and spin by the speeds."""
    frame, properties, carrier = body.frame, body.mass_properties, body.carrier
    point = frame.point(frame.design if properties is None else properties.centre)
    rate, spin = carrier.outward(carrier.velocity(point)), carrier.outward(body.spin)
    mass = (
        ca.SX(3, 1)
        if properties is None
        else ca.vertcat(properties.mass, ca.trace(properties.inertia), 0.0)
    )
    return ca.horzcat(carrier.place(point.value), mass, ca.jacobian(rate, v), ca.jacobian(spin, v))


def _readable(directions: Array) -> Array:
    """Return a basis of the same motions in which each has a coordinate that moves in no other."""
    from scipy.linalg import qr

    if not directions.shape[1]:
        return directions
    own = np.sort(qr(directions.T, pivoting=True, mode="r")[1][: directions.shape[1]])
    return np.asarray(directions @ np.linalg.inv(directions[own]))
