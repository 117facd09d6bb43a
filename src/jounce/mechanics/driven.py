"""Quasistatic mechanisms, and fully driven ones whose loop equations alone determine poses and rates."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca

from jounce.core.errors import AssemblyError
from jounce.mechanics.equations import Track
from jounce.mechanics.linear_algebra import Ldl
from jounce.mechanics.mechanism import Mechanism


@dataclass(frozen=True)
class Statics:
    """A mechanism without masses: symbols, generalised forces, loop equations with rate and bias."""

    q: ca.SX
    v: ca.SX
    p: ca.SX
    parameters: tuple[str, ...]
    start: tuple[float, ...]
    rates: ca.SX
    load: ca.SX
    joints: tuple[str, ...]
    constraint: ca.SX
    constraint_rate: ca.SX
    constraint_bias: ca.SX
    moved: Callable[[ca.SX], ca.SX]


class Quasistatic(Mechanism):
    """A mechanism without time: switches follow the sign of their expressions, hysteresis states are zero."""

    def switch(self, name: str, expression: ca.SX) -> ca.SX:  # noqa: ARG002 - as the base class names them
        """Return 1 where the expression is above zero and 0 elsewhere."""
        return ca.SX(expression) > 0.0

    def internal_state(self, name: str) -> ca.SX:  # noqa: ARG002
        """Return zero, the initial value."""
        return ca.SX(0.0)

    def set_internal_rate(self, name: str, rate: ca.SX) -> None:
        """Do nothing: internal states stay zero."""

    def derivative(self, expression: ca.SX) -> ca.SX:
        """Return the time derivative of an expression of coordinates, tracks, their rates and speeds."""
        return self.collection.bias_of(expression) + self.accelerated(expression)

    def with_accelerations(self, expression: ca.SX, accelerations: ca.SX) -> ca.SX:
        """Substitute the accelerations of the speeds in an expression."""
        return ca.substitute(expression, self.collection.a, ca.densify(accelerations))

    def parameter_symbols(self) -> dict[str, ca.SX]:
        """Return the symbols of all parameters by path."""
        return dict(self.collection.parameters)

    def statics(self) -> Statics:
        """Return forces and loop equations without masses and weights."""
        collected = self.collection
        loops = collected.constraint()
        return Statics(
            q=collected.q,
            v=collected.v,
            p=ca.vertcat(*collected.parameters.values()),
            parameters=tuple(collected.parameters),
            start=tuple(collected.start.values()),
            rates=ca.vertcat(*collected.rates),
            load=collected.force_on(collected.v),
            joints=tuple(equation.joint for equation in loops.equations),
            constraint=loops.value,
            constraint_rate=loops.rate,
            constraint_bias=loops.bias,
            moved=collected.displace,
        )


class DrivenMechanism:
    """A mechanism, complete except for outputs, with all motions driven: as many loop equations as speeds."""

    def __init__(self, mechanism: Quasistatic, tracks: list[Track]) -> None:
        self.mechanism, self.tracks = mechanism, tracks
        self.statics = mechanism.statics()
        self.gradient = ca.jacobian(self.statics.constraint_rate, self.statics.v)
        if self.gradient.shape[0] != self.gradient.shape[1]:
            raise AssemblyError(
                "the numbers of motions and drives must be equal", found=f"{self.gradient.shape}"
            )
        self._normal = Ldl(self.gradient @ self.gradient.T)
        self._rates = [
            -self._solve(self._still(which)(self.statics.constraint_rate))
            for which in range(len(tracks))
        ]

    def along(self, which: int) -> Callable[[ca.SX], ca.SX]:
        """Return the substitution of all rates by those for a unit rate of one track at constant track rates."""
        return self._substitution(which, self._rates[which])

    def accelerated(self, expression: ca.SX) -> ca.SX:
        """Return an expression of coordinates, speeds and accelerations for a constant unit rate of the first track."""
        accelerations = -self._solve(self.statics.constraint_bias)
        return self.along(0)(self.mechanism.with_accelerations(expression, accelerations))

    def pose(self) -> ca.SX:
        """Return coordinates after a Newton step, residual before it, and slopes of the coordinates along each track.

        The step starts from normalised quaternions: extrapolated quaternions are not, and would hide a residual.
        """
        statics = self.statics
        pose = statics.moved(-self._solve(statics.constraint))
        residual = ca.sqrt(ca.dot(statics.constraint, statics.constraint))
        slopes = [self.along(which)(statics.rates) for which in range(len(self.tracks))]
        start = ca.SX(statics.q)
        for first in self.mechanism.collection.quaternions.values():
            e = statics.q[first : first + 4]
            start[first : first + 4] = e / ca.sqrt(ca.dot(e, e))
        return ca.substitute(ca.vertcat(pose, residual, *slopes), statics.q, start)

    def follow(self, expression: ca.SX, numbers: ca.SX, change: ca.SX) -> ca.SX:
        """Return the change of an expression for a change of tracks and parameters, with the loops kept closed."""
        displacement = self.yielding(ca.jtimes(self.statics.constraint, numbers, change))
        return ca.jtimes(
            expression, ca.vertcat(self.statics.q, numbers), ca.vertcat(displacement, change)
        )

    def yielding(self, opened: ca.SX) -> ca.SX:
        """Return slopes of the coordinates that cancel a given rate of opening of the loops."""
        return ca.substitute(self.statics.rates, self.statics.v, ca.densify(-self._solve(opened)))

    def _solve(self, right: ca.SX) -> ca.SX:
        """Return the speeds (or small displacements) that cause this rate of the loop equations."""
        return self.gradient.T @ self._normal.solve(ca.densify(right))

    def _still(self, which: int) -> Callable[[ca.SX], ca.SX]:
        return self._substitution(which, ca.SX.zeros(self.statics.v.shape[0]))

    def _substitution(self, which: int, speeds: ca.SX) -> Callable[[ca.SX], ca.SX]:
        tracks = self.tracks
        symbols = [
            self.statics.v,
            *(track.rate for track in tracks),
            *(track.acceleration for track in tracks),
        ]
        rates = [ca.SX(float(k == which)) for k in range(len(tracks))]
        values = [ca.densify(speeds), *rates, *(ca.SX(0.0) for _ in tracks)]

        def substitute(expression: ca.SX) -> ca.SX:
            return ca.substitute(
                ca.densify(expression), ca.vertcat(*symbols), ca.densify(ca.vertcat(*values))
            )

        return substitute
