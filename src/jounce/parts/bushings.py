"""Elastic parts of a suspension: bushings with own axes, mounts, subframe, wheel bearing, and links that yield."""

from __future__ import annotations

import math
from typing import Annotated, Any, Self

import numpy as np
from pydantic import Field, model_validator

from jounce.core.description import Description
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import PositiveStiffness, Unit
from jounce.parts.bodies import (
    DampingTriple,
    Direction,
    ForceTriple,
    FrictionTorqueTriple,
    FrictionTriple,
    Point,
    RotationalStiffnessTriple,
    StiffnessTriple,
    TorqueTriple,
    Triple,
)
from jounce.parts.curves import PolynomialCurve, RotationalTableCurve, TableCurve
from jounce.parts.tables import on_lines

DIRECTIONS = ("x", "y", "z", "rx", "ry", "rz")
"""Directions of a bushing: displacements along its axes, then rotations about them."""
REVERSED = ("y", "rx", "rz")
"""Directions whose sign a reflection at y = 0 reverses, in right-handed axes on both sides."""
SLIP_TRAVEL = 1e-4
"""m: displacement at which friction slips without a given ``friction_stiffness``; for rotations see `SLIP_ANGLE`."""
SLIP_ANGLE = math.radians(0.1)
_SHORTEST = 1e-9  # of a direction, whose length does not matter otherwise
_PARALLEL = 1e-3  # rad: directions at a smaller angle do not define axes
_NO_LOAD = (0.0, 0.0, 0.0)

Along = Annotated[PolynomialCurve | TableCurve, Field(discriminator="kind")]
About = Annotated[PolynomialCurve | RotationalTableCurve, Field(discriminator="kind")]
BushingCurve = PolynomialCurve | TableCurve | RotationalTableCurve


def load_of(curve: BushingCurve, displacement: Any) -> Array:
    """Return force (N) or torque (N m) of a bushing's curve at displacements (m) or angles (rad).

    >>> load_of(PolynomialCurve(coefficients=(1e6, 0.0, 1e10)), [-1e-3, 0.0, 2e-3]).tolist()
    [-1010.0, 0.0, 2080.0]
    """
    at = np.asarray(displacement, dtype=float)
    if isinstance(curve, PolynomialCurve):
        return np.asarray(sum(c * at ** (i + 1) for i, c in enumerate(curve.coefficients)))
    points, loads = points_of(curve)
    return on_lines(points, loads, at)


def points_of(
    curve: TableCurve | RotationalTableCurve,
) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return displacements (m) or angles (rad) of a table, and its forces (N) or torques (N m)."""
    if isinstance(curve, TableCurve):
        return curve.deflection, curve.force
    return curve.angle, curve.torque


class BushingCurves(Description):
    """Curves of a bushing that replace its stiffness in some directions.

    Along x, y and z: force (N) over displacement (m). About them: torque (N m) over angle (rad). Each is positive for a
    positive displacement of the second body (the wheel's side), which it resists.
    """

    x: Along | None = None
    y: Along | None = None
    z: Along | None = None
    rx: About | None = None
    ry: About | None = None
    rz: About | None = None

    @model_validator(mode="after")
    def _resist(self) -> Self:
        for name in DIRECTIONS:
            curve = getattr(self, name)
            if isinstance(curve, PolynomialCurve):
                _refuse_negative(name, curve.coefficients[0])
            elif curve is not None:
                _refuse_falling(name, curve)
        return self


def _refuse_negative(name: str, slope: float) -> None:
    if slope < 0.0:
        raise error_at(
            (name, "coefficients"),
            "a bushing with negative stiffness at design",
            found=Phrase("{slope:g}", slope=slope),
            allowed="at least 0 for the first coefficient",
        )


def _refuse_falling(name: str, curve: TableCurve | RotationalTableCurve) -> None:
    """Refuse tables whose loads fall, and tables that do not reach the design position."""
    at, load = points_of(curve)
    abscissa, ordinate = (
        ("deflection", "force") if isinstance(curve, TableCurve) else ("angle", "torque")
    )
    if not at[0] <= 0.0 <= at[-1]:
        raise error_at(
            (name, abscissa),
            "does not include 0, the design position",
            found=Phrase("{first:g} to {last:g}", first=at[0], last=at[-1]),
            allowed="points on both sides of 0",
        )
    for i in range(1, len(load)):
        if load[i] < load[i - 1]:
            raise error_at(
                (name, ordinate),
                "falls, so the bushing would not resist",
                found=Phrase("{after:g} after {before:g}", after=load[i], before=load[i - 1]),
                allowed="values that do not fall from one point to the next",
            )


class Bushing(Description):
    """Elastic joint in place of an ideal one, in six directions: along and about its axes x, y and z.

    Displacements and rotations are those of the second body, on the wheel's side, relative to the first. The load on
    the second body is ``preload`` minus stiffness times displacement; a direction of ``curves`` takes its curve
    instead of the stiffness (N/m, N m/rad). The axes are those of the design pose, or own ones: ``x_axis`` and
    ``z_axis`` are directions there, and y completes them. If both are given, ``z_axis`` is made perpendicular. The axes
    move with the first body. ``friction`` is the load (N, N m) at which a direction slips, in parallel with the
    elastic load. It builds up with ``friction_stiffness``, by default within 0.1 mm or 0.1 degrees. Losses follow from
    ``damping`` (N s/m) or from a ``loss_angle`` (rad) between load and displacement.
    """

    stiffness: StiffnessTriple = _NO_LOAD
    rotational_stiffness: RotationalStiffnessTriple = _NO_LOAD
    damping: DampingTriple = _NO_LOAD
    x_axis: Direction | None = None
    z_axis: Direction | None = None
    curves: BushingCurves | None = None
    preload: ForceTriple | None = None
    rotational_preload: TorqueTriple | None = None
    friction: FrictionTriple | None = None
    rotational_friction: FrictionTorqueTriple | None = None
    friction_stiffness: StiffnessTriple | None = None
    rotational_friction_stiffness: RotationalStiffnessTriple | None = None
    loss_angle: Annotated[float, Unit("rad", at_least=0.0, at_most=1.5)] | None = None

    @model_validator(mode="after")
    def _is_possible(self) -> Self:
        self._check_stiffness()
        self._check_axes()
        self._check_friction()
        if self.loss_angle is not None and any(self.damping):
            raise error_at(
                ("loss_angle",),
                "the losses are given twice, by loss_angle and damping",
                allowed="one of them",
            )
        return self

    @property
    def axes(self) -> Array:
        """Its axes x, y and z as columns, unit vectors in the axes of the design pose, shape (3, 3)."""
        x, z = np.array(self.x_axis or (1.0, 0.0, 0.0)), np.array(self.z_axis or (0.0, 0.0, 1.0))
        if self.x_axis is None:  # the given axis is kept
            z = z / np.linalg.norm(z)
            x = x - (x @ z) * z
        x = x / np.linalg.norm(x)
        z = z - (z @ x) * x
        z = z / np.linalg.norm(z)
        return np.stack([x, np.cross(z, x), z], axis=1)

    @property
    def preloads(self) -> Array:
        """Load on the second body at design along and about its axes, N and N m, shape (6,)."""
        return np.array([*(self.preload or _NO_LOAD), *(self.rotational_preload or _NO_LOAD)])

    @property
    def tangents(self) -> Array:
        """Stiffness at design along and about its axes, curves included, N/m and N m/rad, shape (6,)."""
        linear = (*self.stiffness, *self.rotational_stiffness)
        return np.array(
            [
                _slope_at_design(curve) if curve is not None else stiffness
                for curve, stiffness in zip(self.curve_of_each, linear, strict=True)
            ]
        )

    @property
    def curve_of_each(self) -> tuple[BushingCurve | None, ...]:
        """Curve of each of the six directions, None where the stiffness acts."""
        return tuple(getattr(self.curves, name, None) for name in DIRECTIONS)

    @property
    def slip_loads(self) -> Array:
        """Friction along and about its axes, N and N m, shape (6,)."""
        return np.array([*(self.friction or _NO_LOAD), *(self.rotational_friction or _NO_LOAD)])

    @property
    def slip_stiffnesses(self) -> Array:
        """Stiffness with which the friction builds up, N/m and N m/rad, shape (6,); 0 without friction."""
        given = (self.friction_stiffness, self.rotational_friction_stiffness)
        slip = self.slip_loads
        return np.concatenate(
            [
                load / travel if stiffness is None else np.where(load > 0.0, stiffness, 0.0)
                for load, travel, stiffness in zip(
                    (slip[:3], slip[3:]), (SLIP_TRAVEL, SLIP_ANGLE), given, strict=True
                )
            ]
        )

    @property
    def loose(self) -> tuple[str, ...]:
        """Directions along which it carries nothing at design."""
        return tuple(
            name
            for name, slope in zip(DIRECTIONS[:3], self.tangents[:3], strict=True)
            if slope == 0.0
        )

    def _check_stiffness(self) -> None:
        if "stiffness" in self.model_fields_set:
            return
        missing = [name for name in DIRECTIONS[:3] if getattr(self.curves, name, None) is None]
        if missing:
            raise error_at(
                ("stiffness",),
                Phrase("is missing along {names}", names=", ".join(missing)),
                allowed="stiffness for x, y and z, or a curve for each of them",
            )

    def _check_axes(self) -> None:
        for name in ("x_axis", "z_axis"):
            axis = getattr(self, name)
            if axis is not None and math.hypot(*axis) < _SHORTEST:
                raise error_at((name,), "has no direction", allowed="numbers that are not all 0")
        x, z = np.array(self.x_axis or (1.0, 0.0, 0.0)), np.array(self.z_axis or (0.0, 0.0, 1.0))
        across = np.linalg.norm(np.cross(x, z)) / (np.linalg.norm(x) * np.linalg.norm(z))
        if across < _PARALLEL:
            given = "z_axis" if self.z_axis is not None else "x_axis"
            raise error_at(
                (given,),
                "x_axis and z_axis are parallel",
                allowed="two directions that differ",
                hint=""
                if self.x_axis and self.z_axis
                else "Without x_axis it is [1, 0, 0], without z_axis [0, 0, 1]: give both.",
            )

    def _check_friction(self) -> None:
        for name in ("friction", "rotational_friction"):
            load, stiffness = getattr(self, name), getattr(self, f"{name}_stiffness")
            if stiffness is None:
                continue
            if load is None:
                raise error_at((f"{name}_stiffness",), Phrase("needs {name}", name=name))
            for i, (slip, rate) in enumerate(zip(load, stiffness, strict=True)):
                if slip > 0.0 and rate == 0.0:
                    raise error_at(
                        (f"{name}_stiffness", i),
                        "friction without stiffness would never build up",
                        allowed=Phrase("above {bound:g}", bound=0.0),
                    )


def _slope_at_design(curve: BushingCurve) -> float:
    """Return the slope of a curve at 0, N/m or N m/rad; at a kink the mean of both sides."""
    if isinstance(curve, PolynomialCurve):
        return curve.coefficients[0]
    at, load = (np.array(row) for row in points_of(curve))
    slopes = np.diff(load) / np.diff(at)
    last = len(slopes) - 1
    sides = [np.clip(np.searchsorted(at, 0.0, side) - 1, 0, last) for side in ("left", "right")]
    return float(slopes[sides].mean())


class Mount(Bushing):
    """Bushing between the car's body and a part that belongs to both sides, at ``point`` (m).

    The first body is the car's. The other side has its mirror image; a mount in the centre plane of the car counts
    once.
    """

    point: Point


class Subframe(Description):
    """Body on ``mounts`` that carries hardpoints of the body's side, of both wheels of the axle, and the ``"rack"``."""

    carries: tuple[str, ...] = Field(min_length=1)
    mounts: tuple[Mount, ...] = Field(min_length=1)

    @model_validator(mode="after")
    def _carries_each_once(self) -> Self:
        for i, name in enumerate(self.carries):
            if name in self.carries[:i]:
                raise error_at(("carries", i), Phrase("{name} is given twice", name=name))
        return self


class WheelBearing(Description):
    """Stiffness of wheel bearing and hub at the wheel centre; without a value it is rigid in these directions.

    x is forward, y along the wheel's axis and z up, in the plane of the wheel: ``stiffness`` (N/m) is radial, axial and
    radial, ``rotational_stiffness`` (N m/rad) is about x (camber), y (spin, which has no effect) and z (steer).
    """

    stiffness: StiffnessTriple | None = None
    rotational_stiffness: RotationalStiffnessTriple | None = None

    @model_validator(mode="after")
    def _holds_the_wheel(self) -> Self:
        for name, directions in (("stiffness", (0, 1, 2)), ("rotational_stiffness", (0, 2))):
            for i in directions:
                if (values := getattr(self, name)) is not None and values[i] == 0.0:
                    raise error_at(
                        (name, i),
                        "does not hold the wheel",
                        found=Phrase("0"),
                        allowed=Phrase("above {bound:g}", bound=0.0),
                        hint="A bearing without this key is rigid.",
                    )
        return self


class Link(Description):
    """Stiffness (N/m) of a link along its line, or of an arm at its ball joint, equal in all directions."""

    stiffness: PositiveStiffness


def mirror_bushing(table: dict[str, Any]) -> dict[str, Any]:
    """Return the table of a bushing or mount mirrored at y = 0, SI.

    Axes and points are mirrored. Both sides have right-handed axes, so displacement along y and rotation about x and z
    change their signs; preloads and curves in these directions follow.
    """
    mirrored = dict(table)
    for key in ("point", "x_axis", "z_axis", "preload"):
        if key in table:
            mirrored[key] = _mirror_vector(table[key])
    if "rotational_preload" in table:
        x, y, z = table["rotational_preload"]
        mirrored["rotational_preload"] = (-x, y, -z)
    if "curves" in table:
        mirrored["curves"] = {
            name: _reverse(curve) if name in REVERSED else curve
            for name, curve in table["curves"].items()
        }
    return mirrored


def _mirror_vector(vector: Triple) -> Triple:
    return vector[0], -vector[1], vector[2]


def _reverse(curve: dict[str, Any]) -> dict[str, Any]:
    """Return the curve ``-f(-x)``: that of a displacement counted the other way."""
    if "coefficients" in curve:
        signed = tuple(c if i % 2 == 0 else -c for i, c in enumerate(curve["coefficients"]))
        return {**curve, "coefficients": signed}
    rows = {key: row for key, row in curve.items() if key != "kind"}
    return {**curve, **{key: tuple(-value for value in reversed(row)) for key, row in rows.items()}}
