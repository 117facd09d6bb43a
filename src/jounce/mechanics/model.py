"""A finished symbolic model: what every engine, linearisation and gradient is derived from."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

_KINKED = {
    getattr(ca, f"OP_{name}")
    for name in (
        "SIGN",
        "FABS",
        "FLOOR",
        "CEIL",
        "FMIN",
        "FMAX",
        "IF_ELSE_ZERO",
        "LT",
        "LE",
        "EQ",
        "NE",
        "COPYSIGN",
        "FMOD",
    )
}  # a derivative does not show these


@dataclass(frozen=True)
class Output:
    """One signal a model can give: its channel name, SI unit and label."""

    name: str
    unit: str
    long_name: str


@dataclass(frozen=True)
class Model:
    """Symbolic equations ``dx/dt = rate(x, u, p, m)``, outputs and switching functions.

    The state ``x`` is (coordinates, their velocities, internal states). The inputs ``u`` are, for each track, its value
    and its time derivative. ``m`` holds one mode (0 or 1) for each switch: within a step modes are constant and all
    equations smooth; mode ``i`` is 1 exactly where ``switch[i] > 0``.

    Attributes
    ----------
    coordinates, internal, tracks, parameters, switches : tuple of str
        Names, in the order of the symbols.
    outputs : tuple of Output
        Signals, in the order of ``output``.
    x, u, p, m : casadi.SX
        Symbols of states, inputs, parameters and modes.
    rate, output, switch : casadi.SX
        Expressions of the symbols.
    """

    coordinates: tuple[str, ...]
    internal: tuple[str, ...]
    tracks: tuple[str, ...]
    parameters: tuple[str, ...]
    switches: tuple[str, ...]
    outputs: tuple[Output, ...]
    x: ca.SX
    u: ca.SX
    p: ca.SX
    m: ca.SX
    rate: ca.SX
    output: ca.SX
    switch: ca.SX

    @property
    def states(self) -> tuple[str, ...]:
        """Names of all states: coordinates, velocities (``... rate``), internal states."""
        return (*self.coordinates, *(f"{name} rate" for name in self.coordinates), *self.internal)

    def is_linear(self) -> bool:
        """Tell whether rates and outputs are affine in states and inputs and nothing switches or jumps."""
        signals = ca.vertcat(self.x, self.u)
        equations = ca.Function("equations", [signals, self.p, self.m], [ca.vertcat(self.rate, self.output)])
        operations = {equations.instruction_id(k) for k in range(equations.n_instructions())}
        if self.switches or operations & _KINKED:
            return False
        slopes = ca.jacobian(ca.vertcat(self.rate, self.output), signals)
        return not ca.depends_on(slopes, signals)
