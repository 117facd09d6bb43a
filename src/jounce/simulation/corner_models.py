"""Quarter-car equivalents of the corners of a rig or vehicle about static equilibrium, for the design of gains."""

from __future__ import annotations

import numpy as np

from jounce.control.design import CornerModel
from jounce.core.errors import SimulationError
from jounce.core.types import Array
from jounce.parts import Rig
from jounce.parts.vehicles import Vehicle
from jounce.simulation.compiled import Compiled, compile_rig
from jounce.simulation.linear_model import numbers_without_friction
from jounce.simulation.statics import Equilibrium, find_equilibrium

_TYPICAL_VELOCITY = (
    0.3  # m/s, for the damper's mean coefficient; r.m.s. on a class C road at 20 m/s is 0.2 to 0.25
)


def corners_of(rig: Rig) -> tuple[str, ...]:
    """Return the names of the corners; "" for the only corner of a quarter car or a 3-D corner."""
    return tuple(rig.corners) if isinstance(rig, Vehicle) else ("",)


def corner_models(rig: Rig) -> dict[str, CornerModel]:
    """Compute the quarter-car equivalents of all corners.

    The sprung mass is the static share of the body's load. Spring, tyre and unsprung mass follow from the linearised
    model. Anti-roll bars and dry friction are ignored; the damper has its mean coefficient at 0.3 m/s.

    Parameters
    ----------
    rig : Rig
        Rig or vehicle.

    Returns
    -------
    dict
        Equivalent by corner (``""`` for a quarter car).

    Raises
    ------
    SimulationError
        If there is no equilibrium, or no gravity to determine the load of a corner.

    Examples
    --------
    >>> from jounce.parts import load
    >>> round(corner_models(load("kart-quarter-car"))[""].sprung_mass, 6)   # kg
    16.0
    """
    values = numbers_without_friction(rig)
    gravity = values.get("gravity", 0.0)
    if gravity <= 0.0:
        raise SimulationError(
            "without gravity, the load of a corner is undefined",
            where="gravity",
            found=gravity,
            allowed="above 0 m/s^2",
        )
    compiled = compile_rig(rig)
    p = compiled.parameter_values(values)
    still = compiled.inputs(0.0)
    rest = find_equilibrium(compiled, p, still)
    view = _View(compiled, p, rest, still)
    return {
        corner: _corner(view, f"{corner}." if corner else "", gravity) for corner in corners_of(rig)
    }


class _View:
    """Outputs of a model at rest by channel, and their slopes by free displacements and speeds."""

    def __init__(self, compiled: Compiled, p: Array, rest: Equilibrium, still: Array) -> None:
        self._compiled, self._p, self._rest, self._still = compiled, p, rest, still
        slopes = compiled.slopes("x", rest.x, still, p, rest.modes)["output"] @ rest.lift
        free = len(rest.free)
        self._along = slopes[:, :free], slopes[:, free : 2 * free]
        self._driven = compiled.slopes("u", rest.x, still, p, rest.modes)["output"]
        self._value = compiled.evaluate("output", rest.x, still, p, rest.modes)
        self._names = compiled.output_names

    def has(self, name: str) -> bool:
        return name in self._names

    def value(self, name: str) -> float:
        return float(self._value[self._names.index(name)])

    def row(self, name: str, rates: bool = False) -> Array:
        return np.asarray(self._along[rates][self._names.index(name)])

    def driven(self, name: str, track: str) -> float:
        facts = self._compiled.facts
        return float(
            self._driven[self._names.index(name), facts.tracks.index(track) * facts.track_order]
        )

    def at_velocity(self, name: str, velocity: str, value: float) -> float:
        """Return an output for a value of a velocity channel (m/s), with all displacements as at rest."""
        row = self.row(velocity, rates=True)
        reduced = np.zeros(self._rest.lift.shape[1])
        reduced[len(row) : 2 * len(row)] = row / (row @ row) * value
        x = self._rest.x + self._rest.lift @ reduced
        modes = self._compiled.sides(x, self._still, self._p)
        return float(
            self._compiled.evaluate("output", x, self._still, self._p, modes)[
                self._names.index(name)
            ]
        )


def _corner(view: _View, prefix: str, gravity: float) -> CornerModel:
    force, deflection, velocity = (
        f"{prefix}strut.{word}" for word in ("force", "deflection", "velocity")
    )
    body, wheel = f"{prefix}sprung.vz", f"{prefix}unsprung.vz"
    if not view.has(body):
        raise SimulationError(
            "nothing to control: the body is fixed",
            where="guide",
            found="fixed",
            allowed="a body that can move",
        )
    parting = -view.row(body, rates=True)
    if view.has(wheel):
        parting = parting + view.row(wheel, rates=True)
    r = _share(view.row(velocity, rates=True), parting)
    forces = [view.at_velocity(force, velocity, sign * _TYPICAL_VELOCITY) for sign in (1.0, -1.0)]
    damping = (forces[0] - forces[1]) / (2.0 * _TYPICAL_VELOCITY) * r**2
    spring = _share(view.row(force), view.row(deflection)) * r**2
    mass, stiffness, load = 0.0, 0.0, view.value(force) * r
    if view.has(wheel):
        tyre, road = f"{prefix}tyre.force", f"{prefix}road.z"
        stiffness = _share(view.row(tyre), view.row(f"{prefix}tyre.deflection"))
        mass = view.driven(tyre, road) / view.driven(f"{prefix}unsprung.az", road)
        load = view.value(tyre) - mass * gravity
    if load <= 0.0:
        place = prefix.removesuffix(".") or "the wheel"
        raise SimulationError(
            "a corner carries no part of the body weight", where=place, found=f"{load:.4g} N"
        )
    return CornerModel(
        load / gravity, mass, spring, stiffness, damping, r, gravity, view.value(deflection)
    )


def _share(row: Array, of: Array) -> float:
    """Return the factor between two proportional slopes."""
    return float(row @ of / (of @ of))
