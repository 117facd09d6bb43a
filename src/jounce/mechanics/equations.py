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
    mass = Ldl(matrix)
    count = constraint.value.shape[0]
    if count == 0:
        acceleration = mass.solve(ca.densify(force))
        none = ca.SX(0, 1)
        return Solved(
            acceleration,
            none,
            move(ca.SX(size, 1)),
            v,
            ca.SX(1.0),
            residual=lambda a, _: force - matrix @ a,
            answer=mass.solve,
            correction=lambda _: ca.SX(size, 1),
        )
    gradient = ca.jacobian(constraint.rate, v)
    rows = mass.forward(gradient.T)
    scaled = mass.scale(rows)
    reduced_matrix = rows.T @ scaled
    reduced = Ldl(reduced_matrix)

    def balance(applied: ca.SX, bias: ca.SX) -> tuple[ca.SX, ca.SX]:
        half = mass.forward(ca.densify(applied))
        multipliers = reduced.solve(-bias - scaled.T @ half)
        return mass.backward(mass.scale(half + rows @ multipliers)), multipliers

    def correction(violation: ca.SX) -> ca.SX:
        return mass.backward(scaled @ reduced.solve(violation))

    shares = [pivot / entry for pivot, entry in zip(reduced.pivots, _diagonal(reduced_matrix), strict=True)]
    worst = shares[0]
    for share in shares[1:]:
        worst = ca.fmin(worst, share)
    return Solved(
        *balance(force, constraint.bias),
        move(-correction(constraint.value)),
        v - correction(constraint.rate),
        worst,
        residual=lambda a, m: ca.vertcat(force - matrix @ a + gradient.T @ m, gradient @ a + constraint.bias),
        answer=lambda change: ca.vertcat(*balance(change[:size], change[size:])),
        correction=correction,
    )


def _diagonal(matrix: ca.SX) -> list[ca.SX]:
    """Diagonal entries in the order of the pivots."""
    return [matrix[i, i] for i in reversed(range(matrix.shape[0]))]
