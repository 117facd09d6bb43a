"""Dependent axles under a car: a solid axle on links, and a twist beam as two halves on a torsion spring.

Each side is a suspension of its own for spring, damper, tyre and bar; both share the bodies of the axle.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca

from jounce.mechanics import Mechanism
from jounce.mechanics.bodies import Body
from jounce.models.attachments import add_strut_points
from jounce.models.linkage import Linkage
from jounce.parts.axles import DependentAxle, SolidAxle, TwistBeam

_AHEAD, _ACROSS = ca.SX([1.0, 0.0, 0.0]), ca.SX([0.0, 1.0, 0.0])


class AxleSide(Linkage):
    """One side of a dependent axle; its mass is half of the axle's."""

    shared: tuple[Body, ...] = ()

    @property
    def mass(self) -> ca.SX:
        """Half of the mass of the axle, kg."""
        masses = [body.mass_properties for body in self.shared]
        return 0.5 * sum((each.mass for each in masses if each is not None), ca.SX(0.0))


def build_axle(
    rig: DependentAxle, mechanism: Mechanism, chassis: Body, end: str, sides: Mapping[str, float]
) -> dict[str, AxleSide]:
    """Add an axle at the ``end`` of a car, "front" or "rear", to its body; return its sides by name."""
    shift = {"front": 1.0, "rear": -1.0}[end] * mechanism.parameter(f"{end}.distance")
    made = {}
    for name, side in sides.items():
        with mechanism.within(f"{end}_{name}", f"{end}.axle"):
            ahead = shift - mechanism.parameter("hardpoints.wheel_centre[0]")
            made[name] = AxleSide(rig, mechanism, chassis, chassis, ahead=ahead, turned=side)  # type: ignore[arg-type]
    scope = {name: (f"{end}_{name}", f"{end}.axle") for name in sides}
    if isinstance(rig, SolidAxle):
        _solid_axle(rig, mechanism, end, made, scope)
    else:
        assert isinstance(rig, TwistBeam)
        _twist_beam(rig, mechanism, end, made, scope)
    for name, linkage in made.items():
        with mechanism.within(*scope[name]):
            add_strut_points(linkage)
    return made


def _solid_axle(
    rig: SolidAxle,
    mechanism: Mechanism,
    end: str,
    sides: dict[str, AxleSide],
    scope: Mapping[str, tuple[str, str]],
) -> None:
    points, left = rig.hardpoints, sides["left"]
    with mechanism.within(end, f"{end}.axle"):
        axle = left.body("axle")
        middle = left.hardpoint("wheel_centre") * ca.SX([1.0, 0.0, 1.0])
        mechanism.free("axle", axle, at=middle, moving_frame=left.moving_frame)
        shared = [axle]
        single = ["upper_link"] if points.has_centre_link else []
        single += ["panhard"] if points.panhard_axle is not None else []
        for name in single:
            left.rod(name, f"{name}_body", f"{name}_axle", axle)
        if points.watt_pivot is not None:
            lever = left.body("watt_lever")
            pivot = left.hardpoint("watt_pivot")
            mechanism.revolute("watt_pivot", axle, lever, at=pivot, axis=_AHEAD)
            for name in ("watt_upper", "watt_lower"):
                left.rod(name, f"{name}_body", f"{name}_axle", lever)
            shared.append(lever)
    paired = ["lower_link"]
    paired += ["upper_link"] if points.upper_link_axle and not points.has_centre_link else []
    for name, linkage in sides.items():
        linkage.shared = tuple(shared)
        with mechanism.within(*scope[name]):
            linkage.carry("axle", axle)
            for link in paired:
                linkage.rod(link, f"{link}_body", f"{link}_axle", axle)


def _twist_beam(
    rig: TwistBeam,
    mechanism: Mechanism,
    end: str,
    sides: dict[str, AxleSide],
    scope: Mapping[str, tuple[str, str]],
) -> None:
    halves = {}
    for name, linkage in sides.items():
        with mechanism.within(*scope[name]):
            halves[name] = linkage.body("half")
    left, right = (sides[name] for name in ("left", "right"))
    soft = rig.bushings.pivot is not None
    with mechanism.within(*scope["left"]):
        pivot = left.hardpoint("pivot")
        if soft:
            mechanism.free("pivot", halves["left"], moving_frame=left.moving_frame)
            left.cushion("pivot", left.chassis, halves["left"])
        else:
            mechanism.spherical("pivot", left.chassis, halves["left"], at=pivot)
    with mechanism.within(end, f"{end}.axle"):
        centre = left.hardpoint("shear_centre")
        twist = mechanism.revolute("beam", halves["left"], halves["right"], at=centre, axis=_ACROSS)
        torque = mechanism.parameter("beam.torsional_stiffness") * twist
        mechanism.force(twist, -torque)
        mechanism.output("beam.twist", twist, "rad", "twist of the beam from design")
        mechanism.output("beam.torque", torque, "N*m", "torque of the beam against its twist")
    with mechanism.within(*scope["right"]):
        pivot = right.hardpoint("pivot")
        if soft:
            right.cushion("pivot", right.chassis, halves["right"])
        else:  # the beam keeps the distance of ideal pivots
            mechanism.point_on_line(
                "pivot", right.chassis, halves["right"], at=pivot, axis=_ACROSS, point=pivot
            )
    for name, linkage in sides.items():
        linkage.shared = tuple(halves.values())
        with mechanism.within(*scope[name]):
            linkage.carry("axle", halves[name])
            linkage.owners["pivot"] = linkage.chassis
