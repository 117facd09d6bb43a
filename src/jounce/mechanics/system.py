"""Symbolic authoring: coordinates, masses and force elements in, equations of motion out.

Every force element acts along an expression of the coordinates (a height, a length, an angle): its magnitude does work
on the rate of that expression. Points are 3-vectors of expressions, so the lumped models and spatial mechanisms take
the same route: ``M(q) a = Q(q, v, ...)`` with the mass matrix from the Jacobians of the mass positions.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from jounce.core.errors import AssemblyError
from jounce.mechanics.linear_algebra import ldl_solve
from jounce.mechanics.model import Model, Output


@dataclass(frozen=True)
class Track:
    """A prescribed motion: its value and its time derivative as symbols."""

    value: ca.SX
    rate: ca.SX


class System:
    """A mechanical system under construction.

    Order of work: coordinates, parameters and inputs; masses; forces; outputs; ``finish``.
    """

    def __init__(self) -> None:
        self._coordinates: dict[str, tuple[ca.SX, ca.SX]] = {}
        self._internal: dict[str, tuple[ca.SX, ca.SX | None]] = {}
        self._tracks: dict[str, Track] = {}
        self._parameters: dict[str, ca.SX] = {}
        self._switches: dict[str, tuple[ca.SX, ca.SX]] = {}
        self._masses: list[tuple[ca.SX, ca.SX]] = []
        self._forces: list[tuple[ca.SX, ca.SX]] = []
        self._outputs: dict[Output, ca.SX] = {}
        self._accelerations: dict[str, ca.SX] = {}

    def coordinate(self, name: str) -> ca.SX:
        """Add a coordinate and give its symbol."""
        self._refuse_twice(name, self._coordinates)
        symbol = ca.SX.sym(name)
        self._coordinates[name] = (symbol, ca.SX.sym(f"{name}_rate"))
        self._accelerations[name] = ca.SX.sym(f"{name}_acceleration")
        return symbol

    def internal_state(self, name: str) -> ca.SX:
        """Add a first-order state (hysteresis, actuator); give its rate later with ``set_internal_rate``."""
        self._refuse_twice(name, self._internal)
        symbol = ca.SX.sym(name)
        self._internal[name] = (symbol, None)
        return symbol

    def set_internal_rate(self, name: str, rate: ca.SX) -> None:
        """Say how fast an internal state changes."""
        self._internal[name] = (self._internal[name][0], rate)

    def track(self, name: str) -> Track:
        """Add a prescribed input motion and give its value and rate."""
        self._refuse_twice(name, self._tracks)
        self._tracks[name] = Track(ca.SX.sym(name), ca.SX.sym(f"{name}_rate"))
        return self._tracks[name]

    def parameter(self, path: str) -> ca.SX:
        """Give the symbol of the number at ``path`` of the description; the same path gives the same symbol."""
        if path not in self._parameters:
            self._parameters[path] = ca.SX.sym(path)
        return self._parameters[path]

    def switch(self, name: str, expression: ca.SX) -> ca.SX:
        """Give the mode symbol that is 1 where ``expression`` is above zero and 0 elsewhere."""
        self._refuse_twice(name, self._switches)
        mode = ca.SX.sym(name)
        self._switches[name] = (mode, ca.SX(expression))
        return mode

    def point_mass(self, mass: ca.SX, position: ca.SX) -> None:
        """Add a mass (kg) at a position (m; a height or a 3-vector)."""
        self._masses.append((mass, position))

    def force(self, along: ca.SX, magnitude: ca.SX) -> None:
        """Add a force element: ``magnitude`` (N) pushes ``along`` (m) to greater values."""
        self._forces.append((along, magnitude))

    def rate_of(self, expression: ca.SX) -> ca.SX:
        """Give the time derivative of an expression of coordinates and tracks."""
        moving = [*self._coordinates.values(), *((t.value, t.rate) for t in self._tracks.values())]
        values, rates = (ca.vertcat(*column) for column in zip(*moving, strict=True))
        return ca.jtimes(expression, values, rates)

    def acceleration_of(self, expression: ca.SX) -> ca.SX:
        """Give the second time derivative of an expression of coordinates (for outputs only)."""
        q, v = self._symbols()
        accelerations = ca.vertcat(*self._accelerations.values())
        rate = ca.jtimes(expression, q, v)
        return ca.jtimes(rate, q, v) + ca.jtimes(rate, v, accelerations)

    def output(self, name: str, expression: ca.SX, unit: str, long_name: str) -> None:
        """Add a signal the model can give."""
        self._outputs[Output(name, unit, long_name)] = ca.SX(expression)

    def finish(self) -> Model:
        """Form the equations of motion."""
        q, v = self._symbols()
        acceleration = self._solve(q, v)
        x = ca.vertcat(q, v, *(symbol for symbol, _ in self._internal.values()))
        rate = ca.vertcat(v, acceleration, *self._internal_rates())
        output = ca.substitute(
            ca.vertcat(*self._outputs.values()), ca.vertcat(*self._accelerations.values()), acceleration
        )
        return Model(
            coordinates=tuple(self._coordinates),
            internal=tuple(self._internal),
            tracks=tuple(self._tracks),
            parameters=tuple(self._parameters),
            switches=tuple(self._switches),
            outputs=tuple(self._outputs),
            x=x,
            u=ca.vertcat(*(part for track in self._tracks.values() for part in (track.value, track.rate))),
            p=ca.vertcat(*self._parameters.values()),
            m=ca.vertcat(*(mode for mode, _ in self._switches.values())),
            rate=ca.cse(rate),
            output=ca.cse(output),
            switch=ca.vertcat(*(expression for _, expression in self._switches.values())),
        )

    def _internal_rates(self) -> list[ca.SX]:
        rates = []
        for name, (_, rate) in self._internal.items():
            if rate is None:
                raise AssemblyError("an internal state has no rate", where=name, hint="Call set_internal_rate.")
            rates.append(rate)
        return rates

    def _symbols(self) -> tuple[ca.SX, ca.SX]:
        if not self._coordinates:
            raise AssemblyError("a system without coordinates", hint="Add one with coordinate(name).")
        q, v = zip(*self._coordinates.values(), strict=True)
        return ca.vertcat(*q), ca.vertcat(*v)

    def _solve(self, q: ca.SX, v: ca.SX) -> ca.SX:
        """Accelerations from the mass matrix and the generalised forces."""
        size = q.shape[0]
        inertia, load = ca.SX(size, size), ca.SX(size, 1)
        for mass, position in self._masses:
            jacobian = ca.jacobian(position, q)
            inertia += mass * (jacobian.T @ jacobian)
            load -= jacobian.T @ (mass * ca.jtimes(jacobian @ v, q, v))
        for along, magnitude in self._forces:
            load += ca.jacobian(along, q).T * magnitude
        return ldl_solve(inertia, ca.densify(load))

    @staticmethod
    def _refuse_twice(name: str, names: object) -> None:
        if name in names:  # type: ignore[operator]
            raise AssemblyError("the name is used twice", where=name)
