"""Equations of motion of a collection: ``M a = Q + G^T lambda``, ``G a + gamma = 0``, solved in the graph.

``v`` are the speeds, ``a`` their rates; the coordinates follow ``dq/dt = N(q) v``. ``form`` turns a
:class:`Collection` into a :class:`Model`. It does not modify the collection, which can be formed again without other
loop equations.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Protocol

import casadi as ca

from jounce.core.errors import AssemblyError
from jounce.mechanics.facts import Equation, Output
from jounce.mechanics.linear_algebra import Ldl
from jounce.mechanics.model import Alike, Balance, Model, with_numbers


class InertialTerms(Protocol):
    """Contributions of an object with mass to the mass matrix and to the bias forces."""

    def matrix(self, v: ca.SX) -> ca.SX:
        """Return the mass matrix for the speeds ``v``."""

    def bias(self, v: ca.SX) -> ca.SX:
        """Return the generalised inertial force at constant speeds."""


@dataclass(frozen=True)
class PointMass:
    """A mass (kg) whose velocity is ``rate`` (m/s) and whose acceleration at constant speeds is ``bias``."""

    mass: ca.SX
    rate: ca.SX
    bias_acceleration: ca.SX

    def matrix(self, v: ca.SX) -> ca.SX:
        """Mass matrix."""
        jacobian = ca.jacobian(self.rate, v)
        return self.mass * (jacobian.T @ jacobian)

    def bias(self, v: ca.SX) -> ca.SX:
        """Return the inertial force of the bias."""
        return ca.jacobian(self.rate, v).T @ (self.mass * self.bias_acceleration)


@dataclass(frozen=True)
class Constraint:
    """Equations ``value = 0`` with their first rate, and their second rate at zero accelerations."""

    equations: tuple[Equation, ...]
    value: ca.SX
    rate: ca.SX
    bias: ca.SX
    multipliers: ca.SX


@dataclass(frozen=True)
class Track:
    """A prescribed motion: its value and its first two time derivatives as symbols."""

    value: ca.SX
    rate: ca.SX
    acceleration: ca.SX


@dataclass
class Collection:
    """Everything that forms the equations of motion: symbols by name, masses, forces, constraints, signals."""

    coordinates: dict[str, ca.SX] = field(default_factory=dict)
    speeds: dict[str, ca.SX] = field(default_factory=dict)
    accelerations: dict[str, ca.SX] = field(default_factory=dict)  # by the names of their speeds
    units: dict[str, str] = field(default_factory=dict)  # of coordinates and speeds
    rates: list[ca.SX] = field(default_factory=list)  # of the coordinates, in groups
    quaternions: dict[str, int] = field(
        default_factory=dict
    )  # joint to the first of four coordinates
    start: dict[str, float] = field(default_factory=dict)  # coordinates in the design pose
    internal: dict[str, tuple[ca.SX, ca.SX | None]] = field(
        default_factory=dict
    )  # first-order states and rates
    tracks: dict[str, Track] = field(default_factory=dict)
    parameters: dict[str, ca.SX] = field(default_factory=dict)
    switches: dict[str, tuple[ca.SX, ca.SX]] = field(
        default_factory=dict
    )  # mode symbols, and the expressions whose sign sets them
    inertias: list[InertialTerms] = field(default_factory=list)
    loads: list[tuple[ca.SX, ca.SX]] = field(
        default_factory=list
    )  # rates, and forces that do power on them
    constraints: list[Constraint] = field(default_factory=list)
    outputs: dict[Output, ca.SX] = field(default_factory=dict)
    constants: dict[str, tuple[ca.SX, float]] = field(
        default_factory=dict
    )  # symbols that replace numbers
    shared: tuple[str, ...] = ()  # speeds of a body that carries several suspensions
    alike: Alike | None = None  # parts of identical structure
    loops: dict[str, tuple[str, ...]] = field(
        default_factory=dict
    )  # closing joint to all joints around its loop, itself first

    def copy(self) -> Collection:
        """Return a copy to which more can be added."""
        result = copy.copy(self)
        for name, value in vars(self).items():
            if isinstance(value, dict | list):
                setattr(result, name, value.copy())
        return result

    @property
    def q(self) -> ca.SX:
        """All coordinates."""
        return ca.vertcat(*self.coordinates.values())

    @property
    def v(self) -> ca.SX:
        """All speeds."""
        return ca.vertcat(*self.speeds.values())

    @property
    def a(self) -> ca.SX:
        """All accelerations."""
        return ca.vertcat(*self.accelerations.values())

    def rate_of(self, expression: ca.SX) -> ca.SX:
        """Return the time derivative of an expression of coordinates and tracks."""
        tracks = self.tracks.values()
        values = ca.vertcat(*self.coordinates.values(), *(track.value for track in tracks))
        return ca.jtimes(
            expression, values, ca.vertcat(*self.rates, *(track.rate for track in tracks))
        )

    def bias_of(self, rate: ca.SX) -> ca.SX:
        """Return the time derivative of a rate at constant speeds."""
        tracks = self.tracks.values()
        moving = ca.vertcat(
            *self.coordinates.values(),
            *(track.value for track in tracks),
            *(track.rate for track in tracks),
        )
        rates = ca.vertcat(
            *self.rates,
            *(track.rate for track in tracks),
            *(track.acceleration for track in tracks),
        )
        return ca.jtimes(rate, moving, rates)

    def accelerated(self, rate: ca.SX) -> ca.SX:
        """Return the time derivative of a rate, including accelerations."""
        return ca.jtimes(rate, self.v, self.a)

    def force_on(self, v: ca.SX) -> ca.SX:
        """Return the generalised force of all loads on the speeds ``v``."""
        load = ca.SX(v.shape[0], 1)
        together: dict[
            tuple[int, ...], tuple[ca.SX, ca.SX]
        ] = {}  # forces on one point are added first
        for rate, magnitude in self.loads:
            key = tuple(element.element_hash() for element in ca.vertsplit(ca.densify(rate)))
            _, before = together.get(key, (rate, ca.SX(0.0)))
            together[key] = rate, before + magnitude
        for rate, magnitude in together.values():
            load += ca.jacobian(rate, v).T @ magnitude
        return load

    def constraint(self, dropped: frozenset[str] = frozenset()) -> Constraint:
        """Return all loop equations as one constraint, without those named in ``dropped``."""
        equations = [
            equation for constraint in self.constraints for equation in constraint.equations
        ]
        remaining = [i for i, equation in enumerate(equations) if equation.name not in dropped]
        if not remaining:
            return Constraint((), *[ca.SX(0, 1)] * 4)
        columns = zip(
            *((c.value, c.rate, c.bias, c.multipliers) for c in self.constraints), strict=True
        )
        return Constraint(
            tuple(equations[i] for i in remaining),
            *(ca.vertcat(*column)[remaining] for column in columns),
        )

    def displace(self, displacement: ca.SX) -> ca.SX:
        """Return the coordinates after a small displacement in terms of the speeds, with quaternions normalised."""
        q = self.q + ca.substitute(ca.vertcat(*self.rates), self.v, ca.densify(displacement))
        for first in self.quaternions.values():
            e = q[first : first + 4]
            q[first : first + 4] = e / ca.sqrt(ca.dot(e, e))
        return q


def form(collection: Collection, dropped: frozenset[str] = frozenset()) -> Model:
    """Form the equations of motion, without the redundant loop equations named in ``dropped``."""
    if not collection.coordinates:
        raise AssemblyError("a system without coordinates", hint="Add one with coordinate(name).")
    internal_rates = [slope for _, slope in collection.internal.values() if slope is not None]
    if len(internal_rates) < len(collection.internal):
        names = ", ".join(name for name, (_, slope) in collection.internal.items() if slope is None)
        raise AssemblyError(
            "an internal state has no rate", where=names, hint="Call set_internal_rate."
        )
    q, v, a = collection.q, collection.v, collection.a
    internal = ca.vertcat(*(symbol for symbol, _ in collection.internal.values()))
    constraint = collection.constraint(dropped)
    shared = [list(collection.speeds).index(name) for name in collection.shared]
    solved = solve(
        v, collection.inertias, collection.force_on(v), constraint, collection.displace, shared
    )
    gone = [
        c.multipliers[i]
        for c in collection.constraints
        for i, e in enumerate(c.equations)
        if e.name in dropped
    ]
    lacking = ca.SX(len(gone), 1)  # dropped equations carry no force
    unknown = ca.vertcat(a, constraint.multipliers, *gone)
    solution = ca.densify(ca.vertcat(solved.acceleration, solved.multipliers, lacking))
    balance = Balance(
        unknown=unknown,
        found=solution,
        residual=solved.residual(a, constraint.multipliers),
        answer=lambda change: ca.vertcat(solved.answer(change), lacking),
        rate=ca.vertcat(*collection.rates, a, *internal_rates),
        output=ca.vertcat(*collection.outputs.values()),
        moved=collection.displace,
        correction=solved.correction,
        constraint_rate=constraint.rate,
    )
    rate, output = ca.substitute([balance.rate, balance.output], [unknown], [solution])
    accelerations = ca.vertcat(*(track.acceleration for track in collection.tracks.values()))
    order = 3 if collection.tracks and ca.depends_on(ca.vertcat(rate, output), accelerations) else 2
    projection = ca.SX(0, 1)  # no loops, no drift
    if constraint.equations or collection.quaternions:
        left = (
            ca.sqrt(ca.dot(constraint.value, constraint.value))
            if constraint.equations
            else ca.SX(0.0)
        )
        projection = ca.vertcat(
            solved.coordinates, solved.speeds, internal, left, solved.conditioning
        )
    inputs = (
        ca.vertcat(t.value, t.rate, t.acceleration)[:order] for t in collection.tracks.values()
    )
    model = Model(
        coordinates=tuple(collection.coordinates),
        speeds=tuple(collection.speeds),
        internal=tuple(collection.internal),
        constraints=tuple(equation.name for equation in constraint.equations),
        tracks=tuple(collection.tracks),
        track_order=order,
        parameters=tuple(collection.parameters),
        switches=tuple(collection.switches),
        outputs=tuple(collection.outputs),
        start=tuple(collection.start.values()),
        loops=collection.loops,
        units=tuple(
            collection.units[name] for name in (*collection.coordinates, *collection.speeds)
        ),
        quaternions=collection.quaternions,
        equations=constraint.equations,
        x=ca.vertcat(q, v, internal),
        u=ca.vertcat(*inputs),
        p=ca.vertcat(*collection.parameters.values()),
        m=ca.vertcat(*(mode for mode, _ in collection.switches.values())),
        rate=rate,
        output=output,
        switch=ca.vertcat(*(expression for _, expression in collection.switches.values())),
        constraint=constraint.value,
        projection=projection,
        balance=balance,
        alike=collection.alike,
    )
    return with_numbers(model, collection.constants) if collection.constants else model


@dataclass(frozen=True)
class Solved:
    """Accelerations, multipliers, projected coordinates and speeds, and the conditioning of the constraints.

    The functions reuse the same factors, so that derivatives need not differentiate them. ``residual`` is the force
    balance, then the second rates of the constraints, for given accelerations and multipliers. ``answer`` returns the
    change of accelerations and multipliers that cancels a change of the residual. ``correction`` returns the
    displacement (or change of the speeds) that cancels a constraint residual (or its rate).
    """

    acceleration: ca.SX
    multipliers: ca.SX
    coordinates: ca.SX
    speeds: ca.SX
    conditioning: ca.SX
    residual: Callable[[ca.SX, ca.SX], ca.SX]
    answer: Callable[[ca.SX], ca.SX]
    correction: Callable[[ca.SX], ca.SX]


def solve(
    v: ca.SX,
    inertias: Sequence[InertialTerms],
    load: ca.SX,
    constraint: Constraint,
    move: Callable[[ca.SX], ca.SX],
    shared: Sequence[int] = (),
) -> Solved:
    """Solve for the accelerations under a load; return one step of the mass-orthogonal projection onto the constraints.

    ``move`` returns the coordinates after a small displacement in terms of the speeds. The ``shared`` speeds belong to
    a body that carries several otherwise independent loops. They are solved for last, which keeps the loops decoupled.
    """
    size = v.shape[0]
    matrix, force = ca.SX(size, size), ca.SX(load)
    for inertia in inertias:
        matrix += inertia.matrix(v)
        force -= inertia.bias(v)
    if constraint.value.shape[0] == 0:
        return _solve_unconstrained(v, matrix, force, move)
    gradient = ca.jacobian(constraint.rate, v)
    loops = _LoopFactors(matrix, gradient) if not shared else _SharedLoops(matrix, gradient, shared)

    def correction(residual: ca.SX) -> ca.SX:
        return loops.displacement(residual)

    return Solved(
        *loops.balance(force, constraint.bias),
        move(-correction(constraint.value)),
        v - correction(constraint.rate),
        loops.conditioning(),
        residual=lambda a, m: ca.vertcat(
            force - matrix @ a + gradient.T @ m, gradient @ a + constraint.bias
        ),
        answer=lambda change: ca.vertcat(*loops.balance(change[:size], change[size:])),
        correction=correction,
    )


def _solve_unconstrained(
    v: ca.SX, matrix: ca.SX, force: ca.SX, move: Callable[[ca.SX], ca.SX]
) -> Solved:
    """Solve for the accelerations of a system without loops."""
    mass, size = Ldl(matrix), v.shape[0]
    return Solved(
        mass.solve(ca.densify(force)),
        ca.SX(0, 1),
        move(ca.SX(size, 1)),
        v,
        ca.SX(1.0),
        residual=lambda a, _: force - matrix @ a,
        answer=mass.solve,
        correction=lambda _: ca.SX(size, 1),
    )


class _LoopFactors:
    """Factors of mass matrix and constraints, for the balance ``M a = Q + G^T lambda``, ``G a + bias = 0``."""

    def __init__(self, matrix: ca.SX, gradient: ca.SX) -> None:
        self._mass = Ldl(matrix)
        self._rows = self._mass.forward(gradient.T)
        self._scaled = self._mass.scale(self._rows)
        self._matrix = self._rows.T @ self._scaled
        self._reduced = Ldl(self._matrix)

    def balance(self, applied: ca.SX, bias: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Return accelerations and multipliers, one column per right-hand side."""
        half = self._mass.forward(ca.densify(applied))
        multipliers = self._reduced.solve(-bias - self._scaled.T @ half)
        return self._mass.backward(self._mass.scale(half + self._rows @ multipliers)), multipliers

    def displacement(self, residual: ca.SX) -> ca.SX:
        """Return the displacement of minimum mass-weighted norm that causes a given change of the constraints."""
        return self._mass.backward(self._scaled @ self._reduced.solve(residual))

    def conditioning(self) -> ca.SX:
        """Return the conditioning of the constraints: 1 independent, 0 singular."""
        shares = [
            pivot / entry
            for pivot, entry in zip(self._reduced.pivots, _diagonal(self._matrix), strict=True)
        ]
        worst = shares[0]
        for share in shares[1:]:
            worst = ca.fmin(worst, share)
        return worst


class _Block:
    """Loops and speeds coupled to others only by the shared speeds; ``follow`` and ``react`` are their responses."""

    def __init__(
        self, matrix: ca.SX, gradient: ca.SX, speeds: list[int], rows: list[int], shared: list[int]
    ) -> None:
        self.speeds, self.rows = speeds, rows
        own = gradient[rows, speeds]
        self.loops = (
            _LoopFactors(matrix[speeds, speeds], own) if rows else _Free(matrix[speeds, speeds])
        )
        self._coupling, self._pull = matrix[speeds, shared], gradient[rows, shared]
        columns = [
            self.loops.balance(-self._coupling[:, j], self._pull[:, j]) for j in range(len(shared))
        ]
        self.follow: ca.SX
        self.react: ca.SX
        self.follow, self.react = (ca.horzcat(*parts) for parts in zip(*columns, strict=True))

    @property
    def share(self) -> ca.SX:
        """Return the contribution of the block to the mass matrix of the shared speeds."""
        result: ca.SX = self._pull.T @ self.react - self._coupling.T @ self.follow
        return result

    def pull(self, alone: ca.SX, multipliers: ca.SX) -> ca.SX:
        """Return the force that the block's own motion exerts on the shared speeds."""
        return self._pull.T @ multipliers - self._coupling.T @ alone


class _Free:
    """Factors for speeds without loops, with the interface of ``_LoopFactors``."""

    def __init__(self, matrix: ca.SX) -> None:
        self._mass, self._size = Ldl(matrix), matrix.shape[0]

    def balance(self, applied: ca.SX, _: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Return accelerations, and no multipliers."""
        return self._mass.solve(ca.densify(applied)), ca.SX(0, 1)

    def displacement(self, _: ca.SX) -> ca.SX:
        """Return an empty displacement."""
        return ca.SX(self._size, 1)

    def conditioning(self) -> ca.SX:
        """Never singular."""
        return ca.SX(1.0)


class _SharedLoops:
    """Factors that solve for the shared speeds last; the loops' response to these determines their effective mass."""

    def __init__(self, matrix: ca.SX, gradient: ca.SX, shared: Sequence[int]) -> None:
        self._shared, self._size = list(shared), matrix.shape[0]
        inner = [i for i in range(matrix.shape[0]) if i not in shared]
        self._blocks = [
            _Block(matrix, gradient, *rows, self._shared)
            for rows in _blocks(matrix, gradient, inner)
        ]
        effective = matrix[self._shared, self._shared]
        for block in self._blocks:
            effective -= block.share
        self._mass = Ldl(effective)

    def balance(self, applied: ca.SX, bias: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Return accelerations and multipliers."""
        alone = [
            block.loops.balance(applied[block.speeds], bias[block.rows]) for block in self._blocks
        ]
        force = applied[self._shared]
        for block, terms in zip(self._blocks, alone, strict=True):
            force += block.pull(*terms)
        carrier = self._mass.solve(ca.densify(force))
        accelerations, multipliers = ca.SX(self._size, 1), ca.SX(bias.shape[0], 1)
        accelerations[self._shared] = carrier
        for block, (own, reaction) in zip(self._blocks, alone, strict=True):
            accelerations[block.speeds] = own + block.follow @ carrier
            multipliers[block.rows] = reaction + block.react @ carrier
        return accelerations, multipliers

    def displacement(self, residual: ca.SX) -> ca.SX:
        """Return the displacement of minimum mass-weighted norm with the shared speeds held."""
        result = ca.SX(self._size, 1)
        for block in self._blocks:
            result[block.speeds] = block.loops.displacement(residual[block.rows])
        return result

    def conditioning(self) -> ca.SX:
        """Return the conditioning of the loops with the shared speeds held."""
        worst = self._blocks[0].loops.conditioning()
        for block in self._blocks[1:]:
            worst = ca.fmin(worst, block.loops.conditioning())
        return worst


def _blocks(
    matrix: ca.SX, gradient: ca.SX, inner: Sequence[int]
) -> list[tuple[list[int], list[int]]]:
    """Return the connected groups of ``inner`` speeds and constraint rows."""
    block = {i: i for i in inner}

    def join(members: list[int]) -> None:
        joined = {block[i] for i in members}
        for i, old in block.items():
            if old in joined:
                block[i] = min(joined)

    masses, pattern = matrix.sparsity(), gradient.sparsity()
    rows = [[i for i in inner if pattern.has_nz(k, i)] for k in range(gradient.shape[0])]
    for members in rows + [[i, j] for i in inner for j in inner if masses.has_nz(i, j)]:
        join(members)
    each = [[i for i in inner if block[i] == first] for first in dict.fromkeys(block.values())]
    return [(own, [k for k, members in enumerate(rows) if set(members) & set(own)]) for own in each]


def _diagonal(matrix: ca.SX) -> list[ca.SX]:
    """Return the diagonal entries in the order of the pivots."""
    return [matrix[i, i] for i in reversed(range(matrix.shape[0]))]
