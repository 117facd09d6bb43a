"""Equations of motion ``M a = Q + G^T lambda``, ``G a + gamma = 0``, solved in the graph; projection onto constraints.

``v`` are the speeds, ``a`` their rates; the coordinates follow ``dq/dt = N(q) v``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

import casadi as ca

from jounce.mechanics.linear_algebra import Ldl


class Inertia(Protocol):
    """Something with mass: what it adds to the mass matrix and to the bias forces."""

    def matrix(self, v: ca.SX) -> ca.SX:
        """Mass matrix for the speeds ``v``."""

    def bias(self, v: ca.SX) -> ca.SX:
        """Generalised inertial force that is left when no speed changes."""


@dataclass(frozen=True)
class PointMass:
    """A mass (kg) whose velocity is ``rate`` (m/s) and whose acceleration is ``bias`` when no speed changes."""

    mass: ca.SX
    rate: ca.SX
    bias_acceleration: ca.SX

    def matrix(self, v: ca.SX) -> ca.SX:
        """Mass matrix."""
        jacobian = ca.jacobian(self.rate, v)
        return self.mass * (jacobian.T @ jacobian)

    def bias(self, v: ca.SX) -> ca.SX:
        """Inertial force of the bias."""
        return ca.jacobian(self.rate, v).T @ (self.mass * self.bias_acceleration)


@dataclass(frozen=True)
class Constraint:
    """Equations ``value = 0`` with their rate and the part of the second rate that no acceleration makes."""

    names: tuple[str, ...]
    value: ca.SX
    rate: ca.SX
    bias: ca.SX
    multipliers: ca.SX


@dataclass(frozen=True)
class Solved:
    """Accelerations, multipliers, projected coordinates and speeds, how far from singular the constraints are.

    The functions use the same factors, for derivatives that do not differentiate them: ``residual`` (force balance,
    then second rates of the constraints) of given accelerations and multipliers, ``answer`` the change of both that
    takes back a change of the residual, ``correction`` the displacement (or change of the speeds) that takes back a
    violation (or its rate).
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
    inertias: Sequence[Inertia],
    load: ca.SX,
    constraint: Constraint,
    move: Callable[[ca.SX], ca.SX],
    shared: Sequence[int] = (),
) -> Solved:
    """Solve for the accelerations, and give one step of the mass-orthogonal projection onto the constraints.

    Parameters
    ----------
    v : casadi.SX
        Speeds.
    inertias : sequence of Inertia
        All masses.
    load : casadi.SX
        Generalised applied forces.
    constraint : Constraint
        All loop constraints, stacked.
    move : callable
        Gives the coordinates after a small displacement (in terms of the speeds).
    shared : sequence of int
        Speeds that several loops share (a body that carries them): decided last, so that the loops stay apart. The
        loops must be independent of each other without these speeds.

    Returns
    -------
    Solved
        Expressions.
    """
    size = v.shape[0]
    matrix, force = ca.SX(size, size), ca.SX(load)
    for inertia in inertias:
        matrix += inertia.matrix(v)
        force -= inertia.bias(v)
    if constraint.value.shape[0] == 0:
        return _unconstrained(v, matrix, force, move)
    gradient = ca.jacobian(constraint.rate, v)
    loops = _Loops(matrix, gradient) if not shared else _SharedLoops(matrix, gradient, shared)

    def correction(violation: ca.SX) -> ca.SX:
        return loops.displaced(violation)

    return Solved(
        *loops.balance(force, constraint.bias),
        move(-correction(constraint.value)),
        v - correction(constraint.rate),
        loops.conditioning(),
        residual=lambda a, m: ca.vertcat(force - matrix @ a + gradient.T @ m, gradient @ a + constraint.bias),
        answer=lambda change: ca.vertcat(*loops.balance(change[:size], change[size:])),
        correction=correction,
    )


def _unconstrained(v: ca.SX, matrix: ca.SX, force: ca.SX, move: Callable[[ca.SX], ca.SX]) -> Solved:
    """Accelerations where nothing closes a loop."""
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


class _Loops:
    """Factors of mass matrix and constraints, for the balance ``M a = Q + G^T lambda``, ``G a + bias = 0``."""

    def __init__(self, matrix: ca.SX, gradient: ca.SX) -> None:
        self._mass = Ldl(matrix)
        self._rows = self._mass.forward(gradient.T)
        self._scaled = self._mass.scale(self._rows)
        self._matrix = self._rows.T @ self._scaled
        self._reduced = Ldl(self._matrix)

    def balance(self, applied: ca.SX, bias: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Accelerations and multipliers; one column for each of the given ones."""
        half = self._mass.forward(ca.densify(applied))
        multipliers = self._reduced.solve(-bias - self._scaled.T @ half)
        return self._mass.backward(self._mass.scale(half + self._rows @ multipliers)), multipliers

    def displaced(self, violation: ca.SX) -> ca.SX:
        """Shortest displacement, in terms of the mass matrix, that makes a change of the constraints."""
        return self._mass.backward(self._scaled @ self._reduced.solve(violation))

    def conditioning(self) -> ca.SX:
        """How far from singular the constraints are: 1 independent, 0 singular."""
        shares = [pivot / entry for pivot, entry in zip(self._reduced.pivots, _diagonal(self._matrix), strict=True)]
        worst = shares[0]
        for share in shares[1:]:
            worst = ca.fmin(worst, share)
        return worst


class _SharedLoops:
    """The same with the shared speeds decided last: what the loops answer to them makes their effective mass."""

    def __init__(self, matrix: ca.SX, gradient: ca.SX, shared: Sequence[int]) -> None:
        self._shared = list(shared)
        self._inner = [i for i in range(matrix.shape[0]) if i not in shared]
        self._loops = _Loops(matrix[self._inner, self._inner], gradient[:, self._inner])
        self._coupling, self._pull = matrix[self._inner, self._shared], gradient[:, self._shared]
        columns = [self._loops.balance(-self._coupling[:, j], self._pull[:, j]) for j in range(len(self._shared))]
        self._follow, self._react = (ca.horzcat(*parts) for parts in zip(*columns, strict=True))
        effective = matrix[self._shared, self._shared] + self._coupling.T @ self._follow - self._pull.T @ self._react
        self._mass = Ldl(effective)

    def balance(self, applied: ca.SX, bias: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Accelerations and multipliers."""
        alone, multipliers = self._loops.balance(applied[self._inner], bias)
        force = applied[self._shared] + self._pull.T @ multipliers - self._coupling.T @ alone
        carrier = self._mass.solve(ca.densify(force))
        found = ca.SX(applied.shape[0], 1)
        found[self._shared] = carrier
        found[self._inner] = alone + self._follow @ carrier
        return found, multipliers + self._react @ carrier

    def displaced(self, violation: ca.SX) -> ca.SX:
        """Shortest displacement, in terms of the mass matrix, with the shared speeds held."""
        found = ca.SX(len(self._shared) + len(self._inner), 1)
        found[self._inner] = self._loops.displaced(violation)
        return found

    def conditioning(self) -> ca.SX:
        """How far from singular the loops are with the shared speeds held."""
        return self._loops.conditioning()


def _diagonal(matrix: ca.SX) -> list[ca.SX]:
    """Diagonal entries in the order of the pivots."""
    return [matrix[i, i] for i in reversed(range(matrix.shape[0]))]
