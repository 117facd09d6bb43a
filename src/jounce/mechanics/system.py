"""Symbolic authoring: coordinates, masses and force elements in, equations of motion out.

Every force element acts along an expression of the coordinates (a height, a length, an angle): its power is its
magnitude times the rate of that expression. The lumped models are built as a :class:`System`; a spatial mechanism is a
system with bodies and joints. Systems only collect parts; :func:`jounce.mechanics.equations.form` forms the equations.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator, Sequence
from contextlib import contextmanager
from functools import wraps
from typing import Any, Concatenate, ParamSpec, TypeVar

import casadi as ca

from jounce.core.errors import AssemblyError, unknown
from jounce.mechanics.equations import Collection, Constraint, InertialTerms, PointMass, Track, form
from jounce.mechanics.expressions import check_name, expression_of
from jounce.mechanics.facts import Equation, Output, speed_of
from jounce.mechanics.model import Model
from jounce.mechanics.rotations import quaternion_rate

_Arguments = ParamSpec("_Arguments")
_Answer = TypeVar("_Answer")
_Builder = TypeVar("_Builder", bound="System")


def all_or_nothing(
    method: Callable[Concatenate[_Builder, _Arguments], _Answer],
) -> Callable[Concatenate[_Builder, _Arguments], _Answer]:
    """Decorate a builder method to add nothing if it raises: truncate the builder to its previous size."""

    @wraps(method)
    def attempt(self: _Builder, /, *given: _Arguments.args, **named: _Arguments.kwargs) -> _Answer:
        before = [(part, len(part)) for part in self.growing()]
        try:
            return method(self, *given, **named)
        except Exception:
            for part, size in before:
                while len(part) > size:
                    part.popitem() if isinstance(part, dict) else part.pop()
            raise

    return attempt


class System:
    """A mechanical system under construction.

    Add coordinates, parameters and inputs, then masses, forces and outputs; then call ``finish``.
    """

    def __init__(self) -> None:
        self.collection = Collection()
        self._scope = ("", "")

    def growing(self) -> list[dict[Any, Any] | list[Any]]:
        """Return all containers that grow when parts are added."""
        return [
            part
            for part in (*vars(self).values(), *vars(self.collection).values())
            if isinstance(part, dict | list)
        ]

    @contextmanager
    def within(self, place: str, path: str | None = None) -> Iterator[None]:
        """Prefix every name created inside with ``place.`` and every parameter with ``path.`` (``place`` by default).

        This lets a law or suspension be built several times; corners with the same ``path`` share their numbers.
        """
        before = self._scope
        self._scope = f"{before[0]}{place}.", f"{before[1]}{place if path is None else path}."
        try:
            yield
        finally:
            self._scope = before

    def share(self, speeds: Sequence[str]) -> None:
        """Declare the speeds of a body that carries several suspensions, each complete for a fixed body."""
        self.collection.shared = tuple(speeds)

    def alike(self, prefixes: Sequence[tuple[str, ...]], groups: Sequence[tuple[int, ...]]) -> None:
        """Declare similar parts by the prefixes of their names, and the groups that are computed together."""
        self.collection.alike = tuple(prefixes), tuple(groups)

    def constant(self, name: str, value: float) -> ca.SX:
        """Return a symbol for a number (``value``, SI), which lets expressions that differ only in it be similar."""
        name = self._require_unused(name, self.collection.constants)
        self.collection.constants[name] = ca.SX.sym(name), value
        return self.collection.constants[name][0]

    def name_at_place(self, name: str) -> str:
        """Return a name with the current prefix."""
        return self._scope[0] + name

    def coordinate(self, name: str, unit: str = "m") -> ca.SX:
        """Add a coordinate and return its symbol; its speed has the channel's name (``vz``, ``pitch_rate``)."""
        return self.coordinates([name], [speed_of(name)], units=[unit])[0][0]

    def coordinates(
        self,
        names: Sequence[str],
        speeds: Sequence[str],
        start: Sequence[float] | None = None,
        units: Sequence[str] | None = None,
    ) -> tuple[ca.SX, ca.SX]:
        """Add coordinates (from ``start``, in ``units``, default m) with their speeds; return the symbols of both."""
        units = units or ["m"] * len(names)
        q, v = self._symbols_of(
            names, units, start or [0.0] * len(names), speeds, [f"{unit}/s" for unit in units]
        )
        self.collection.rates.append(v)
        return q, v

    def coordinate_named(self, name: str) -> ca.SX:
        """Return the symbol of a coordinate."""
        known = self.collection.coordinates
        if self.name_at_place(check_name(name, "coordinate")) not in known:
            raise unknown(name, known, what="coordinate")
        return known[self.name_at_place(name)]

    def quaternion(self, name: str) -> tuple[ca.SX, ca.SX]:
        """Add an orientation: four coordinates, three speeds (rad/s in the body's axes); return the symbols of both."""
        first = len(self.collection.coordinates)
        names, speeds = [f"{name}.e{i}" for i in range(4)], [f"{name}.w{axis}" for axis in "xyz"]
        e, w = self._symbols_of(names, ["1"] * 4, (1.0, 0.0, 0.0, 0.0), speeds, ["rad/s"] * 3)
        self.collection.quaternions[self.name_at_place(name)] = first
        self.collection.rates.append(quaternion_rate(e, w))
        return e, w

    def _symbols_of(
        self,
        names: Sequence[str],
        units: Sequence[str],
        start: Sequence[float],
        speeds: Sequence[str],
        speed_units: Sequence[str],
    ) -> tuple[ca.SX, ca.SX]:
        into = self.collection
        names = [self._require_unused(name, {**into.coordinates, **into.speeds}) for name in names]
        speeds = [
            self._require_unused(name, {**into.coordinates, **into.speeds}) for name in speeds
        ]
        into.units.update(zip((*names, *speeds), (*units, *speed_units), strict=True))
        into.start.update(zip(names, start, strict=True))
        into.coordinates.update({name: ca.SX.sym(name) for name in names})
        into.speeds.update({name: ca.SX.sym(name) for name in speeds})
        into.accelerations.update({name: ca.SX.sym(f"{name} rate") for name in speeds})
        q = ca.vertcat(*(into.coordinates[name] for name in names))
        return q, ca.vertcat(*(into.speeds[name] for name in speeds))

    def internal_state(self, name: str) -> ca.SX:
        """Add a first-order state (hysteresis, actuator); set its rate later with ``set_internal_rate``."""
        name = self._require_unused(name, self.collection.internal)
        self.collection.internal[name] = (ca.SX.sym(name), None)
        return self.collection.internal[name][0]

    def set_internal_rate(self, name: str, rate: ca.SX) -> None:
        """Set the rate of an internal state."""
        name, known = (
            self.name_at_place(check_name(name, "internal state")),
            self.collection.internal,
        )
        if name not in known:
            raise unknown(name, known, what="internal state")
        known[name] = (known[name][0], expression_of(rate, f"rate of {name}"))

    def track(self, name: str) -> Track:
        """Add a prescribed input motion and return its value and rates."""
        name = self._require_unused(name, self.collection.tracks)
        symbols = (ca.SX.sym(text) for text in (name, f"{name} rate", f"{name} acceleration"))
        self.collection.tracks[name] = Track(*symbols)
        return self.collection.tracks[name]

    def parameter(self, path: str) -> ca.SX:
        """Return the symbol of the number at ``path`` of the description; the same path gives the same symbol."""
        path = self._scope[1] + check_name(path, "parameter")
        if path not in self.collection.parameters:
            self.collection.parameters[path] = ca.SX.sym(path)
        return self.collection.parameters[path]

    def parameter_at(self, path: str) -> ca.SX:
        """Return the symbol of the number at a full path, regardless of the current prefix."""
        return self.collection.parameters.setdefault(path, ca.SX.sym(path))

    def switch(self, name: str, expression: ca.SX) -> ca.SX:
        """Return the mode symbol that is 1 where ``expression`` is above zero and 0 elsewhere."""
        placed = self._require_unused(name, self.collection.switches)
        mode = ca.SX.sym(placed)
        self.collection.switches[placed] = (mode, expression_of(expression, f"switch {name}"))
        return mode

    def inertia(self, inertia: InertialTerms) -> None:
        """Add an object with mass."""
        self.collection.inertias.append(inertia)

    def point_mass(self, mass: ca.SX, position: ca.SX) -> None:
        """Add a mass (kg) at a position (m; a height or a 3-vector)."""
        rate = self.rate_of(position)
        self.inertia(PointMass(mass, rate, self.collection.bias_of(rate)))

    def force(self, along: ca.SX, magnitude: ca.SX) -> None:
        """Add a force element: a positive ``magnitude`` (N) increases ``along`` (m)."""
        self.load(self.rate_of(along), magnitude)

    def load(self, rate: ca.SX, magnitude: ca.SX) -> None:
        """Add a force with the power ``magnitude * rate``; both may be vectors."""
        self.collection.loads.append((rate, magnitude))

    def constrain(
        self, equations: Sequence[Equation], value: ca.SX, rate: ca.SX, bias: ca.SX
    ) -> ca.SX:
        """Add equations ``value = 0`` with rate and bias; return the symbols of their multipliers (forces)."""
        before = (
            equation
            for constraint in self.collection.constraints
            for equation in constraint.equations
        )
        known = {equation.name: equation.joint for equation in before}
        for equation in equations:
            if equation.name in known:
                text, names = (
                    "an equation with this name already exists",
                    f"{equation.name} of {known[equation.name]}",
                )
                raise AssemblyError(
                    text,
                    where=equation.joint,
                    found=names,
                    hint="Rename one of the two.",
                )
        multipliers = ca.vertcat(
            *(ca.SX.sym(f"{equation.name} multiplier") for equation in equations)
        )
        self.collection.constraints.append(
            Constraint(tuple(equations), value, rate, bias, multipliers)
        )
        return multipliers

    def rate_of(self, expression: ca.SX) -> ca.SX:
        """Return the time derivative of an expression of coordinates and tracks."""
        return self.collection.rate_of(expression)

    def acceleration_of(self, expression: ca.SX) -> ca.SX:
        """Return the second time derivative of an expression of coordinates (for outputs only)."""
        rate = self.rate_of(expression)
        return self.collection.bias_of(rate) + self.accelerated(rate)

    def accelerated(self, rate: ca.SX) -> ca.SX:
        """Return the time derivative of a rate, including accelerations (for outputs only)."""
        return self.collection.accelerated(rate)

    def output(self, name: str, expression: ca.SX, unit: str, long_name: str) -> None:
        """Add an output signal."""
        name = self._require_unused(name, {known.name for known in self.collection.outputs})
        shown = expression_of(expression, f"output {name}")
        if shown.shape != (1, 1):
            count, hint = f"{shown.numel()} expressions", "Use one of them, such as force[0]."
            raise AssemblyError(
                "a single expression is required", where=f"output {name}", found=count, hint=hint
            )
        self.collection.outputs[Output(name, unit, long_name)] = shown

    def finish(self) -> Model:
        """Form the equations of motion."""
        return form(self.collection)

    def _require_unused(self, name: str, names: Container[str]) -> str:
        """Prefix a name, and refuse a name that is already in use."""
        name = self.name_at_place(check_name(name))
        _refuse_twice(name, names)
        return name


def _refuse_twice(name: str, names: Container[str]) -> None:
    if name in names:
        raise AssemblyError("the name is used twice", where=name)
