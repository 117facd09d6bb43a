"""Symbolic authoring: coordinates, masses and force elements in, equations of motion out.

Every force element acts along an expression of the coordinates (a height, a length, an angle): its magnitude does work
on the rate of that expression. Points are 3-vectors of expressions, so the lumped models and spatial mechanisms take
the same route (see ``equations``).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass

import casadi as ca

from jounce.core.errors import AssemblyError
from jounce.mechanics.equations import Constraint, Inertia, PointMass, Solved, solve
from jounce.mechanics.model import Alike, Balance, Model, Output, speed_of, with_numbers


@dataclass(frozen=True)
class Track:
    """A prescribed motion: its value and its first two time derivatives as symbols."""

    value: ca.SX
    rate: ca.SX
    acceleration: ca.SX


class System:
    """A mechanical system under construction.

    Order of work: coordinates, parameters and inputs; masses; forces; outputs; ``finish``.
    """

    def __init__(self) -> None:
        self._coordinates: dict[str, ca.SX] = {}
        self._speeds: dict[str, ca.SX] = {}
        self._rates: list[ca.SX] = []
        self._quaternions: list[int] = []
        self._start: dict[str, float] = {}
        self._internal: dict[str, tuple[ca.SX, ca.SX | None]] = {}
        self._tracks: dict[str, Track] = {}
        self._parameters: dict[str, ca.SX] = {}
        self._switches: dict[str, tuple[ca.SX, ca.SX]] = {}
        self._inertias: list[Inertia] = []
        self._loads: list[tuple[ca.SX, ca.SX]] = []
        self._constraints: list[Constraint] = []
        self._outputs: dict[Output, ca.SX] = {}
        self._accelerations: dict[str, ca.SX] = {}
        self._dropped: frozenset[str] = frozenset()
        self._scope = ("", "")
        self._shared: tuple[str, ...] = ()
        self._constants: dict[str, tuple[ca.SX, float]] = {}
        self._alike: Alike | None = None

    @contextmanager
    def within(self, place: str, path: str | None = None) -> Iterator[None]:
        """Put ``place.`` before every name and ``path.`` (the place by default) before every parameter made inside.

        So one law or suspension is built several times; corners of one ``path`` share their numbers.
        """
        before = self._scope
        self._scope = f"{before[0]}{place}.", f"{before[1]}{place if path is None else path}."
        try:
            yield
        finally:
            self._scope = before

    def share(self, speeds: Sequence[str]) -> None:
        """Name the speeds of a body that carries several suspensions, each of them complete with the body held."""
        self._shared = tuple(speeds)

    def alike(self, prefixes: Sequence[tuple[str, ...]], groups: Sequence[tuple[int, ...]]) -> None:
        """Say which parts are built alike, by what their names begin with, and which of them are computed together."""
        self._alike = tuple(prefixes), tuple(groups)

    def constant(self, name: str, value: float) -> ca.SX:
        """Give a symbol that stands for a number (``value``, SI): expressions that differ in it only are alike."""
        name = self.placed(name)
        self._refuse_twice(name, self._constants)
        self._constants[name] = ca.SX.sym(name), value
        return self._constants[name][0]

    def placed(self, name: str) -> str:
        """Give a name with the place that is being built before it."""
        return self._scope[0] + name

    def coordinate(self, name: str) -> ca.SX:
        """Add a coordinate and give its symbol; its speed is called as the channel is (``vz``, ``pitch_rate``)."""
        return self.coordinates([name], [speed_of(name)])[0][0]

    def coordinates(
        self, names: Sequence[str], speeds: Sequence[str], start: Sequence[float] | None = None
    ) -> tuple[ca.SX, ca.SX]:
        """Add coordinates (from ``start``, m or rad) with as many speeds, their rates; give the symbols of both."""
        q, v = self._symbols_of(names, speeds, start)
        self._rates.append(v)
        return q, v

    def coordinate_named(self, name: str) -> ca.SX:
        """Give the symbol of a coordinate."""
        return self._coordinates[self.placed(name)]

    def quaternion(self, name: str) -> tuple[ca.SX, ca.SX]:
        """Add an orientation: four coordinates, three speeds (rad/s in the body's axes); give the symbols of both."""
        from jounce.mechanics.rotations import quaternion_rate

        self._quaternions.append(len(self._coordinates))
        names = [f"{name}.e{i}" for i in range(4)]
        e, w = self._symbols_of(names, [f"{name}.w{axis}" for axis in "xyz"], (1.0, 0.0, 0.0, 0.0))
        self._rates.append(quaternion_rate(e, w))
        return e, w

    def _symbols_of(
        self, names: Sequence[str], speeds: Sequence[str], start: Sequence[float] | None
    ) -> tuple[ca.SX, ca.SX]:
        names, speeds = ([self.placed(name) for name in given] for given in (names, speeds))
        for name in (*names, *speeds):
            self._refuse_twice(name, {**self._coordinates, **self._speeds})
        self._start.update(zip(names, start or [0.0] * len(names), strict=True))
        self._coordinates.update({name: ca.SX.sym(name) for name in names})
        self._speeds.update({name: ca.SX.sym(name) for name in speeds})
        self._accelerations.update({name: ca.SX.sym(f"{name} rate") for name in speeds})
        q = ca.vertcat(*(self._coordinates[name] for name in names))
        return q, ca.vertcat(*(self._speeds[name] for name in speeds))

    def internal_state(self, name: str) -> ca.SX:
        """Add a first-order state (hysteresis, actuator); give its rate later with ``set_internal_rate``."""
        name = self.placed(name)
        self._refuse_twice(name, self._internal)
        symbol = ca.SX.sym(name)
        self._internal[name] = (symbol, None)
        return symbol

    def set_internal_rate(self, name: str, rate: ca.SX) -> None:
        """Say how fast an internal state changes."""
        name = self.placed(name)
        self._internal[name] = (self._internal[name][0], rate)

    def track(self, name: str) -> Track:
        """Add a prescribed input motion and give its value and rates."""
        name = self.placed(name)
        self._refuse_twice(name, self._tracks)
        symbols = (ca.SX.sym(text) for text in (name, f"{name} rate", f"{name} acceleration"))
        self._tracks[name] = Track(*symbols)
        return self._tracks[name]

    def parameter(self, path: str) -> ca.SX:
        """Give the symbol of the number at ``path`` of the description; the same path gives the same symbol."""
        path = self._scope[1] + path
        if path not in self._parameters:
            self._parameters[path] = ca.SX.sym(path)
        return self._parameters[path]

    def switch(self, name: str, expression: ca.SX) -> ca.SX:
        """Give the mode symbol that is 1 where ``expression`` is above zero and 0 elsewhere."""
        name = self.placed(name)
        self._refuse_twice(name, self._switches)
        mode = ca.SX.sym(name)
        self._switches[name] = (mode, ca.SX(expression))
        return mode

    def inertia(self, inertia: Inertia) -> None:
        """Add something with mass."""
        self._inertias.append(inertia)

    def point_mass(self, mass: ca.SX, position: ca.SX) -> None:
        """Add a mass (kg) at a position (m; a height or a 3-vector)."""
        rate = self.rate_of(position)
        self.inertia(PointMass(mass, rate, self._bias_of(rate)))

    def force(self, along: ca.SX, magnitude: ca.SX) -> None:
        """Add a force element: ``magnitude`` (N) pushes ``along`` (m) to greater values."""
        self.load(self.rate_of(along), magnitude)

    def load(self, rate: ca.SX, magnitude: ca.SX) -> None:
        """Add a force that does the power ``magnitude * rate``; both may be vectors."""
        self._loads.append((rate, magnitude))

    def constrain(self, names: Sequence[str], value: ca.SX, rate: ca.SX, bias: ca.SX) -> ca.SX:
        """Add equations ``value = 0`` with their two rates; give the symbols of their multipliers (forces)."""
        names = [self.placed(name) for name in names]
        known = {name for constraint in self._constraints for name in constraint.names}
        for name in names:
            self._refuse_twice(name, known)
        multipliers = ca.vertcat(*(ca.SX.sym(f"{name} multiplier") for name in names))
        self._constraints.append(Constraint(tuple(names), value, rate, bias, multipliers))
        return multipliers

    def rate_of(self, expression: ca.SX) -> ca.SX:
        """Give the time derivative of an expression of coordinates and tracks."""
        tracks = self._tracks.values()
        values = ca.vertcat(*self._coordinates.values(), *(track.value for track in tracks))
        return ca.jtimes(expression, values, ca.vertcat(*self._rates, *(track.rate for track in tracks)))

    def acceleration_of(self, expression: ca.SX) -> ca.SX:
        """Give the second time derivative of an expression of coordinates (for outputs only)."""
        rate = self.rate_of(expression)
        return self._bias_of(rate) + self.accelerated(rate)

    def accelerated(self, rate: ca.SX) -> ca.SX:
        """Give what the accelerations make of a rate (for outputs only)."""
        return ca.jtimes(rate, ca.vertcat(*self._speeds.values()), ca.vertcat(*self._accelerations.values()))

    def _bias_of(self, rate: ca.SX) -> ca.SX:
        """Time derivative of a rate with all speeds kept."""
        tracks = self._tracks.values()
        moving = ca.vertcat(
            *self._coordinates.values(), *(track.value for track in tracks), *(track.rate for track in tracks)
        )
        rates = ca.vertcat(*self._rates, *(track.rate for track in tracks), *(track.acceleration for track in tracks))
        return ca.jtimes(rate, moving, rates)

    def output(self, name: str, expression: ca.SX, unit: str, long_name: str) -> None:
        """Add a signal the model can give."""
        name = self.placed(name)
        made = Output(name, unit, long_name)
        if made not in self._outputs:
            self._refuse_twice(name, {known.name for known in self._outputs})
        self._outputs[made] = ca.SX(expression)

    def finish(self) -> Model:
        """Form the equations of motion."""
        if not self._coordinates:
            raise AssemblyError("a system without coordinates", hint="Add one with coordinate(name).")
        q, v = ca.vertcat(*self._coordinates.values()), ca.vertcat(*self._speeds.values())
        internal = ca.vertcat(*(symbol for symbol, _ in self._internal.values()))
        constraint = self._all_constraints()
        shared = [list(self._speeds).index(name) for name in self._shared]
        solved = solve(v, self._inertias, self._load(v), constraint, self._moved, shared)
        dropped = ca.vertcat(*(row for name, row in self._multipliers() if name in self._dropped))
        unknown = ca.vertcat(*self._accelerations.values(), constraint.multipliers, dropped)
        found = ca.densify(ca.vertcat(solved.acceleration, solved.multipliers, ca.SX(dropped.shape[0], 1)))
        balance = self._balance(solved, unknown, found, constraint)
        rate, output = (ca.substitute(part, unknown, found) for part in (balance.rate, balance.output))
        order = self._track_order(ca.vertcat(rate, output))
        model = Model(
            coordinates=tuple(self._coordinates),
            speeds=tuple(self._speeds),
            internal=tuple(self._internal),
            constraints=constraint.names,
            tracks=tuple(self._tracks),
            track_order=order,
            parameters=tuple(self._parameters),
            switches=tuple(self._switches),
            outputs=tuple(self._outputs),
            start=tuple(self._start.values()),
            loops=self.loops(),
            x=ca.vertcat(q, v, internal),
            u=ca.vertcat(*(_inputs(track, order) for track in self._tracks.values())),
            p=ca.vertcat(*self._parameters.values()),
            m=ca.vertcat(*(mode for mode, _ in self._switches.values())),
            rate=ca.cse(rate),
            output=ca.cse(output),
            switch=ca.vertcat(*(expression for _, expression in self._switches.values())),
            constraint=ca.cse(constraint.value),
            projection=ca.cse(self._projection(solved, internal, constraint)),
            balance=balance,
            alike=self._alike,
        )
        return with_numbers(model, self._constants) if self._constants else model

    def _balance(self, solved: Solved, unknown: ca.SX, found: ca.SX, constraint: Constraint) -> Balance:
        """How rates and outputs follow from accelerations and multipliers."""
        accelerations, rows = ca.vertcat(*self._accelerations.values()), unknown.shape[0]
        lacking = ca.SX(rows - len(self._accelerations) - constraint.value.shape[0], 1)  # multipliers of dropped rows
        return Balance(
            unknown=unknown,
            found=found,
            residual=solved.residual(accelerations, constraint.multipliers),
            answer=lambda change: ca.vertcat(solved.answer(change), lacking),
            rate=ca.vertcat(*self._rates, accelerations, *self._internal_rates()),
            output=ca.vertcat(*self._outputs.values()),
            moved=self._moved,
            correction=solved.correction,
            constraint_rate=constraint.rate,
        )

    def loops(self) -> dict[str, tuple[str, ...]]:
        """Joint that closes a loop to the joints around it; nothing where there is no tree of joints."""
        return {}

    def _load(self, v: ca.SX) -> ca.SX:
        load = ca.SX(v.shape[0], 1)
        together: dict[tuple[int, ...], tuple[ca.SX, ca.SX]] = {}  # forces on one point are added first
        for rate, magnitude in self._loads:
            key = tuple(element.element_hash() for element in ca.vertsplit(ca.densify(rate)))
            _, before = together.get(key, (rate, ca.SX(0.0)))
            together[key] = rate, before + magnitude
        for rate, magnitude in together.values():
            load += ca.jacobian(rate, v).T @ magnitude
        return load

    def _all_constraints(self) -> Constraint:
        """All loop equations in one, without those that repeat others."""
        each = self._constraints
        names = [name for constraint in each for name in constraint.names]
        kept = [i for i, name in enumerate(names) if name not in self._dropped]
        if not kept:
            return Constraint((), *[ca.SX(0, 1)] * 4)
        columns = zip(*((c.value, c.rate, c.bias, c.multipliers) for c in each), strict=True)
        return Constraint(tuple(names[i] for i in kept), *(ca.vertcat(*column)[kept] for column in columns))

    def _multipliers(self) -> list[tuple[str, ca.SX]]:
        """Names of the loop equations with their multipliers."""
        return [(name, c.multipliers[i]) for c in self._constraints for i, name in enumerate(c.names)]

    def _moved(self, displacement: ca.SX) -> ca.SX:
        """Coordinates after a small displacement in terms of the speeds; quaternions have length one again."""
        rate = ca.vertcat(*self._rates)
        v = ca.vertcat(*self._speeds.values())
        moved = ca.vertcat(*self._coordinates.values()) + ca.substitute(rate, v, ca.densify(displacement))
        for first in self._quaternions:
            e = moved[first : first + 4]
            moved[first : first + 4] = e / ca.sqrt(ca.dot(e, e))
        return moved

    def _projection(self, solved: Solved, internal: ca.SX, constraint: Constraint) -> ca.SX:
        """Projected states, size of the residual before, conditioning; nothing where nothing can drift."""
        if not constraint.names and not self._quaternions:
            return ca.SX(0, 1)
        residual = ca.sqrt(ca.dot(constraint.value, constraint.value)) if constraint.names else ca.SX(0.0)
        return ca.vertcat(solved.coordinates, solved.speeds, internal, residual, solved.conditioning)

    def _track_order(self, expression: ca.SX) -> int:
        accelerations = ca.vertcat(*(track.acceleration for track in self._tracks.values()))
        return 3 if self._tracks and ca.depends_on(expression, accelerations) else 2

    def _internal_rates(self) -> list[ca.SX]:
        rates = []
        for name, (_, rate) in self._internal.items():
            if rate is None:
                raise AssemblyError("an internal state has no rate", where=name, hint="Call set_internal_rate.")
            rates.append(rate)
        return rates

    @staticmethod
    def _refuse_twice(name: str, names: object) -> None:
        if name in names:  # type: ignore[operator]
            raise AssemblyError("the name is used twice", where=name)


def _inputs(track: Track, order: int) -> ca.SX:
    return ca.vertcat(track.value, track.rate, track.acceleration)[:order]
