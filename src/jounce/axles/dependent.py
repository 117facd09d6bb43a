"""Dependent axles with their body held: a solid axle on its links, a twist beam as two halves on a torsion spring."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from jounce.axles.assembly import GROUND
from jounce.axles.builder import LEFT, SIDES, AxleBuilder
from jounce.axles.corners import BuiltAxle
from jounce.core.errors import DescriptionError
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.kernel import equilibrium as eq
from jounce.parts import Corner
from jounce.parts.axles import DependentAxle, SolidAxle, TwistBeam

_FREE = 1e-9  # smallest singular value of the constraints, relative to the largest
_MOTIONS = 2  # of an axle: both wheels together, and opposed


def build_axle(rig: Corner | DependentAxle, varied: Sequence[str] = ()) -> AxleBuilder:
    """Build the axle of a corner, a solid axle or a twist beam; see `AxleBuilder` for ``varied``."""
    if isinstance(rig, SolidAxle):
        return BuiltSolidAxle(rig, varied)
    if isinstance(rig, TwistBeam):
        return BuiltTwistBeam(rig, varied)
    return BuiltAxle(rig, varied)


def with_ideal_joints(rig: DependentAxle) -> DependentAxle | None:
    """Return an axle with ball joints for bushings and rigid links; None if its links then bind or do not guide it."""
    ideal: dict[str, object] = {"bearing": None}
    ideal |= {name: type(getattr(rig, name))() for name in ("bushings", "links")}
    rigid = rig.model_copy(update=ideal)
    if rigid == rig:
        return rig
    try:
        build_axle(rigid)
    except DescriptionError:
        return None
    return rigid


class _Dependent(AxleBuilder):
    rig: DependentAxle

    def _finish(self) -> None:
        """Add springs, wheels and the bar of both sides."""
        for side in SIDES:
            self.side = side
            self.add_strut()
            self.add_wheel()
        self.add_bar()
        self.check()

    def check(self) -> None:
        """Refuse links that bind, and links that do not guide the axle."""
        free, repeated, _ = freedom(self)
        if repeated:
            raise DescriptionError(
                "parts hold the axle twice in the same way",
                where="hardpoints",
                found=Phrase("{count} equations that repeat others", count=repeated),
                allowed="none",
                hint="Do two links coincide? Links that share a load need bushings.",
            )
        if free < _MOTIONS:
            raise DescriptionError(
                "the links bind: with ideal joints the wheels cannot move together and opposed",
                where="hardpoints",
                found=Phrase("{count} free motions", count=free),
                allowed=Phrase("{count}", count=_MOTIONS),
                hint="Give bushings to the links, or use fewer: three links and a Panhard rod, or four without it.",
            )
        free, _, left = freedom(self, elastic=True)
        if left:
            raise DescriptionError(
                "the links do not guide the axle",
                where="hardpoints",
                found=Phrase("{count} motions that do not lift a wheel", count=left),
                allowed="none",
                hint="Add a Panhard rod, a Watt linkage or upper links.",
            )


class BuiltSolidAxle(_Dependent):
    """A solid axle: one beam with both wheels."""

    rig: SolidAxle

    def carrier(self, name: str) -> int:
        """Return the beam: nothing else carries parts."""
        del name
        return self.shared("axle")

    def _build(self) -> None:
        axle, points = self.shared("axle"), self.rig.hardpoints
        for side in SIDES:
            self.side = side
            self.upright[side] = axle
            self.rod("lower_link", ("lower_link_body", "lower_link_axle"), (GROUND, axle))
            if points.upper_link_axle is not None and not points.has_centre_link:
                self.rod("upper_link", ("upper_link_body", "upper_link_axle"), (GROUND, axle))
        self.side = "left"
        if points.has_centre_link:
            self.rod("upper_link", ("upper_link_body", "upper_link_axle"), (GROUND, axle))
        if points.panhard_axle is not None:
            self.rod("panhard", ("panhard_body", "panhard_axle"), (GROUND, axle))
        if points.watt_pivot is not None:
            lever = self.shared("watt_lever")
            pivot = self.point("watt_pivot")
            self.carry(axle, "watt_pivot")
            self.assembly.hinge("watt_pivot", (axle, axle), lever, (pivot, pivot + 0.1 * _AHEAD))
            for name in ("watt_upper", "watt_lower"):
                self.rod(name, (f"{name}_body", f"{name}_axle"), (GROUND, lever))
        self._finish()


class BuiltTwistBeam(_Dependent):
    """A twist beam: its halves share the axis of twist through the shear centre."""

    rig: TwistBeam

    def carrier(self, name: str) -> int:
        """Return the half of this side."""
        del name
        return self.own("half")

    def _build(self) -> None:
        for side in SIDES:
            self.side = side
            half = self.upright[side] = self.own("half")
            pivot = self.point("pivot")
            self.carry(half, "pivot", "shear_centre")
            if self.is_soft("pivot"):
                self.joint("pivot", GROUND, half)
            elif side == "left":
                self.assembly.ball(self.called("pivot"), GROUND, half, pivot)
            else:  # the beam keeps the distance of ideal pivots
                for direction in (_AHEAD, _UP):
                    at = direction + 0.0 * pivot
                    self.assembly.along(self.called("pivot"), GROUND, half, (pivot, pivot), at)
        self.side = "left"
        centre = self.point("shear_centre")
        left, right = self.upright["left"], self.upright["right"]
        self.assembly.hinge("beam", (left, left), right, (centre, centre + 0.1 * LEFT))
        stiffness = self.number("beam.torsional_stiffness")
        self.assembly.twist("beam", left, right, LEFT + 0.0 * centre, stiffness)
        self._finish()


_AHEAD = np.array([[1.0], [0.0], [0.0]])
_UP = np.array([[0.0], [0.0], [1.0]])


def freedom(axle: AxleBuilder, *, elastic: bool = False) -> tuple[int, int, int]:
    """Return free motions of the joints at design, repeated equations, and motions left when both wheels are held.

    With ``elastic``, bushings count as joints in the directions in which they have stiffness.
    """
    assembly = axle.assembly
    arrays, _ = assembly.arrays()
    rows = []

    def add(first: int, second: int, force: Array, moment: Array) -> None:
        row = np.zeros(6 * len(assembly.bodies))
        for body, sign in ((second, 1.0), (first, -1.0)):
            if body != GROUND:
                row[6 * body : 6 * body + 6] += sign * np.concatenate([force, moment])
        rows.append(row)

    for element, data in zip(assembly.elements, arrays.data, strict=True):
        ends, at = (element.first, element.second), data[eq.Q : eq.Q + 3]
        if element.kind == eq.POINT:
            for direction in np.eye(3):
                add(*ends, direction, np.cross(at, direction))
        elif element.kind == eq.DISTANCE:
            direction = at - data[eq.P : eq.P + 3]
            add(*ends, direction, np.cross(at, direction))
        elif element.kind == eq.DOT and not element.is_control:
            direction = data[eq.ALONG : eq.ALONG + 3]
            add(*ends, direction, np.cross(at, direction))
        elif element.kind == eq.ALIGN:
            turn = np.cross(data[eq.P : eq.P + 3], data[eq.A : eq.A + 3])
            add(*ends, np.zeros(3), turn)
        elif element.kind == eq.BUSHING and elastic:
            for k, direction in enumerate(data[eq.A : eq.A + 9].reshape(3, 3)):
                law = element.laws[k] is not None, element.laws[3 + k] is not None
                if data[eq.K + k] > 0.0 or law[0]:
                    add(*ends, direction, np.cross(data[eq.P : eq.P + 3], direction))
                if data[eq.K + 3 + k] > 0.0 or law[1]:
                    add(*ends, np.zeros(3), direction)
    count, unknowns = len(rows), 6 * len(assembly.bodies)
    free = unknowns - _rank(rows)
    for wheel, body in zip(arrays.wheels, arrays.carriers, strict=True):
        add(GROUND, int(body), np.array([0.0, 0.0, 1.0]), np.cross(wheel[:3], [0.0, 0.0, 1.0]))
    return free, count - (unknowns - free), unknowns - _rank(rows)


def _rank(rows: list[Array]) -> int:
    if not rows:
        return 0
    unit = [row / np.linalg.norm(row) for row in rows]
    sizes = np.linalg.svd(np.array(unit), compute_uv=False)
    return int(np.sum(sizes > _FREE * sizes[0]))
