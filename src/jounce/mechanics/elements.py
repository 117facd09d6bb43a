"""Force laws as expressions, shared by every model. Compression and bump are positive.

Each law takes its structure from the description (branch, number of knots) and the paths of its numbers. The numbers
themselves are parameters of the model.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import casadi as ca

from jounce.mechanics.system import System
from jounce.parts.bushings import BushingCurve, points_of
from jounce.parts.curves import (
    Curve,
    PolynomialCurve,
    PowerCurve,
    RotationalTableCurve,
    TableCurve,
)
from jounce.parts.dampers import ClickDamper, DamperLaw, Grid, MapDamper
from jounce.parts.elements import BumpStop, Friction, Spring, Tyre

_SLIDING = 3.0  # in regularisation velocities; tanh(3) = 0.995


def curve_force(system: System, curve: Curve, path: str, deflection: ca.SX) -> ca.SX:
    """Return the force (N) of a curve at a deflection (m)."""
    if isinstance(curve, PolynomialCurve):
        force = ca.SX(0)
        for i in reversed(range(len(curve.coefficients))):
            force = (force + system.parameter(f"{path}.coefficients[{i}]")) * deflection
        return force
    if isinstance(curve, PowerCurve):
        loaded = system.switch(f"{path} loaded", deflection)
        positive = ca.fmax(deflection, 1e-300)
        exponent = system.parameter(f"{path}.exponent")
        return (
            loaded * system.parameter(f"{path}.coefficient") * ca.exp(exponent * ca.log(positive))
        )
    assert isinstance(curve, TableCurve)
    return table_force(system, path, "deflection", len(curve.deflection), deflection)


def table_force(system: System, path: str, variable: str, points: int, x: ca.SX) -> ca.SX:
    """Interpolate the points ``path.variable[i]``, ``path.force[i]`` linearly; extrapolate beyond the ends."""
    knots = [system.parameter(f"{path}.{variable}[{i}]") for i in range(points)]
    forces = [system.parameter(f"{path}.force[{i}]") for i in range(points)]
    slopes = [(forces[i + 1] - forces[i]) / (knots[i + 1] - knots[i]) for i in range(points - 1)]
    force = forces[0] + slopes[0] * (x - knots[0])
    for i in range(1, points - 1):
        beyond = x - knots[i]
        force += (
            system.switch(f"{path}.{variable}[{i}]", beyond) * (slopes[i] - slopes[i - 1]) * beyond
        )
    return force


def bushing_curve(
    system: System, curve: BushingCurve, path: str, displacement: ca.SX
) -> tuple[ca.SX, ca.SX]:
    """Return the resistance (N, N m) of a bushing's curve at a displacement (m, rad), and its energy (J)."""
    if isinstance(curve, PolynomialCurve):
        numbers = [
            system.parameter(f"{path}.coefficients[{i}]") for i in range(len(curve.coefficients))
        ]
        energy = sum(c * displacement ** (i + 2) / (i + 2) for i, c in enumerate(numbers))
        return curve_force(system, curve, path, displacement), energy
    knots, slopes, first = _segments(system, curve, path)
    start = displacement - knots[0]
    load = first + slopes[0] * start
    energy = first * displacement + 0.5 * slopes[0] * (start**2 - knots[0] ** 2)
    for i in range(1, len(slopes)):
        beyond, bend = displacement - knots[i], slopes[i] - slopes[i - 1]
        past = system.switch(f"{path}[{i}]", beyond)
        load += past * bend * beyond
        energy += 0.5 * bend * (past * beyond**2 - ca.fmin(knots[i], 0.0) ** 2)
    return load, energy


def bushing_slope(system: System, curve: BushingCurve, path: str) -> ca.SX:
    """Return the slope of a bushing's curve at design (N/m, N m/rad); at a kink the mean of both sides."""
    if isinstance(curve, PolynomialCurve):
        return system.parameter(f"{path}.coefficients[0]")
    knots, slopes, _ = _segments(system, curve, path)
    past = [0.5 * (1.0 - ca.sign(knot)) for knot in knots]
    return slopes[0] + sum(past[i] * (slopes[i] - slopes[i - 1]) for i in range(1, len(slopes)))


def _segments(
    system: System, curve: TableCurve | RotationalTableCurve, path: str
) -> tuple[list[ca.SX], list[ca.SX], ca.SX]:
    """Return knots and slopes of a bushing's table, and its first load."""
    variable, load = (
        ("deflection", "force") if isinstance(curve, TableCurve) else ("angle", "torque")
    )
    count = len(points_of(curve)[0])
    knots = [system.parameter(f"{path}.{variable}[{i}]") for i in range(count)]
    loads = [system.parameter(f"{path}.{load}[{i}]") for i in range(count)]
    slopes = [(loads[i + 1] - loads[i]) / (knots[i + 1] - knots[i]) for i in range(count - 1)]
    return knots, slopes, loads[0]


def spring_force(system: System, spring: Spring, path: str, deflection: ca.SX) -> ca.SX:
    """Return the spring force (N): preload plus rate or curve."""
    preload = system.parameter(f"{path}.preload")
    if spring.curve is not None:
        return preload + curve_force(system, spring.curve, f"{path}.curve", deflection)
    return preload + system.parameter(f"{path}.rate") * deflection


@dataclass(frozen=True)
class ModelPoint:
    """Operating point of a damper law (``OperatingPoint``) in symbols of a model; ``path`` leads to its parameters."""

    system: System
    path: str
    deflection: ca.SX
    velocity: ca.SX
    length: ca.SX | None
    numbers: Callable[[str], ca.SX] | None

    def number(self, name: str) -> ca.SX:
        """Return the symbol of a parameter."""
        return (
            self.system.parameter(f"{self.path}.{name}")
            if self.numbers is None
            else self.numbers(name)
        )

    def switch(self, name: str, x: ca.SX) -> ca.SX:
        """Return a mode symbol; integration steps end where ``x`` changes sign."""
        return self.system.switch(f"{self.path} {name}", x)

    def table(self, variable: str, x: ca.SX, points: int) -> ca.SX:
        """Return the force at ``x``, interpolated and extrapolated linearly from the law's points."""
        return table_force(self.system, self.path, variable, points, x)

    def grid(self, damper: Grid) -> ca.SX:
        """Return the force of a grid at the current velocity, and length or clicks."""
        if isinstance(damper, ClickDamper):
            return click_force(self.system, damper, self.path, self.number("clicks"), self.velocity)
        assert self.length is not None, "maps are laws of 3-D struts, which have a length"
        return damper_map_force(self.system, damper, self.path, self.length, self.velocity)

    def state(self, name: str, rate: Callable[[ca.SX], ca.SX]) -> ca.SX:
        """Add a first-order state."""
        state = self.system.internal_state(f"{self.path} {name}")
        self.system.set_internal_rate(f"{self.path} {name}", rate(state))
        return state


def damper_force(
    system: System,
    damper: DamperLaw,
    path: str,
    deflection: ca.SX,
    velocity: ca.SX,
    number: Callable[[str], ca.SX] | None = None,
    *,
    length: ca.SX | None = None,
) -> ca.SX:
    """Return the damper force (N) at a deflection (m) and its rate (m/s); a map also needs the ``length`` (m).

    ``number`` returns the numbers of a closed-form law (not of a table) that are not model parameters themselves.
    """
    return damper.evaluate(ModelPoint(system, path, deflection, velocity, length, number))


def click_force(
    system: System, damper: ClickDamper, path: str, clicks: ca.SX, velocity: ca.SX
) -> ca.SX:
    """Return the force (N) of an adjustable damper at its clicks and a velocity (m/s).

    Clicks do not move during a run: their hinges are plain maxima, on which no integration step has to end.
    """
    knots = [system.parameter(f"{path}.measured_clicks[{i}]") for i in range(len(damper.rows))]
    past = [ca.fmax(clicks - knot, 0.0) for knot in knots]
    return _grid_force(system, damper, path, knots, past, velocity)


def damper_map_force(
    system: System, damper: MapDamper, path: str, length: ca.SX, velocity: ca.SX
) -> ca.SX:
    """Return the bilinearly interpolated damper force (N) of a map over length (m) and velocity (m/s).

    It is extrapolated linearly in velocity. Each cell of the grid is a product of hinge functions, which
    lets integration steps end on grid lines.
    """
    knots = [system.parameter(f"{path}.length[{i}]") for i in range(len(damper.rows))]
    past = [
        system.switch(f"{path}.length[{i}]", length - knot) * (length - knot)
        for i, knot in enumerate(knots)
    ]
    return _grid_force(system, damper, path, knots, past, velocity)


def _grid_force(
    system: System,
    damper: Grid,
    path: str,
    knots: list[ca.SX],
    past: list[ca.SX],
    velocity: ca.SX,
) -> ca.SX:
    """Return the bilinearly interpolated force (N); ``past`` is how far each knot of the rows has been passed."""
    columns = len(damper.velocity)
    speeds = [system.parameter(f"{path}.velocity[{j}]") for j in range(columns)]
    over = [
        system.switch(f"{path}.velocity[{j}]", velocity - speeds[j]) for j in range(1, columns - 1)
    ]

    def along(i: int) -> ca.SX:
        forces = [system.parameter(f"{path}.force[{i}][{j}]") for j in range(columns)]
        slopes = [
            (forces[j + 1] - forces[j]) / (speeds[j + 1] - speeds[j]) for j in range(columns - 1)
        ]
        force = forces[0] + slopes[0] * (velocity - speeds[0])
        for j in range(1, columns - 1):
            force += over[j - 1] * (slopes[j] - slopes[j - 1]) * (velocity - speeds[j])
        return force

    curves = [along(i) for i in range(len(knots))]
    shares = [(past[i] - past[i + 1]) / (knots[i + 1] - knots[i]) for i in range(len(knots) - 1)]
    return curves[0] + sum(
        (share * (curves[i + 1] - curves[i]) for i, share in enumerate(shares)), ca.SX(0.0)
    )


def tyre_force(
    system: System,
    tyre: Tyre,
    deflection: ca.SX,
    rate: ca.SX,
    law: Callable[[ca.SX, ca.SX], ca.SX] | None = None,
) -> ca.SX:
    """Compute the contact force (N) of a radial tyre at a deflection (m) and its rate (m/s); with lift-off at least 0.

    ``law`` computes a modified force from the tyre's own force and its contact state (1 or 0).
    """
    if tyre.curve is not None:
        elastic = curve_force(system, tyre.curve, "tyre.curve", deflection)
    else:
        elastic = system.parameter("tyre.stiffness") * deflection
    force = elastic + system.parameter("tyre.damping_coefficient") * rate
    if law is not None:
        force = law(force, deflection > 0.0 if tyre.lift_off else ca.SX(1.0))
    if tyre.lift_off:
        force *= system.switch(
            "tyre contact", ca.fmin(force, _contact_stiffness(system, tyre) * deflection)
        )
    return force


def _contact_stiffness(system: System, tyre: Tyre) -> ca.SX:
    """Return a stiffness (N/m) of the tyre's magnitude that converts deflection to newtons for the contact test."""
    curve = tyre.curve
    if curve is None:
        return system.parameter("tyre.stiffness")
    if isinstance(curve, PolynomialCurve):
        return ca.fabs(system.parameter("tyre.curve.coefficients[0]")) + 1.0
    if isinstance(curve, PowerCurve):
        return system.parameter("tyre.curve.coefficient")
    last = len(curve.deflection) - 1
    rise = system.parameter(f"tyre.curve.force[{last}]") - system.parameter("tyre.curve.force[0]")
    return ca.fabs(rise) / (
        system.parameter(f"tyre.curve.deflection[{last}]")
        - system.parameter("tyre.curve.deflection[0]")
    )


def friction_force(system: System, friction: Friction | None, path: str, velocity: ca.SX) -> ca.SX:
    """Return regularised Coulomb friction (N) by velocity, and by travel if it builds up; zero without friction.

    A switch where the force is nearly fully developed makes steps end on both sides of the narrow layer in which it
    changes sign.
    """
    if friction is None:
        return ca.SX(0)
    sharpness = velocity / system.parameter(f"{path}.regularisation_velocity")
    system.switch(f"{path} sliding", ca.fabs(sharpness) - _SLIDING)
    sliding = ca.tanh(sharpness)
    if friction.presliding is not None:
        built_up = system.internal_state(f"{path} built up")
        forward = 2.0 * system.switch(f"{path} forward", velocity) - 1.0
        rate = (velocity - forward * velocity * built_up) / system.parameter(
            f"{path}.presliding_distance"
        )
        system.set_internal_rate(f"{path} built up", rate)
        sliding += system.parameter(f"{path}.presliding") * (built_up - sliding)
    return system.parameter(f"{path}.force") * sliding


def bump_stop_force(system: System, stop: BumpStop | None, path: str, deflection: ca.SX) -> ca.SX:
    """Return the force (N) of a stop in contact when the deflection exceeds its gap; zero without a stop."""
    if stop is None:
        return ca.SX(0)
    depth = deflection - system.parameter(f"{path}.gap")
    touching = system.switch(f"{path} touching", depth)
    return (
        touching
        * depth
        * (system.parameter(f"{path}.rate") + system.parameter(f"{path}.progression") * depth**2)
    )
