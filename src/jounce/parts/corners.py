"""3-D rigs: corners as mechanisms of rigid bodies between named hardpoints, one class for each suspension."""

from __future__ import annotations

from typing import Literal

from jounce.core.description import Description
from jounce.parts.bodies import RigidBody
from jounce.parts.corner import Corner
from jounce.parts.hardpoints import (
    DoubleWishboneHardpoints,
    FiveLinkHardpoints,
    McPhersonHardpoints,
    TrailingArmHardpoints,
)
from jounce.parts.struts import AntiRollBar, Bushing, SpatialStrut, Steering

__all__ = ["Corner", "DoubleWishbone", "FiveLink", "McPherson", "TrailingArm"]


class DoubleWishboneBodies(Description):
    """Bodies of a double wishbone; the upright carries the wheel unless ``wheel`` is a body of its own."""

    lower_arm: RigidBody
    upper_arm: RigidBody
    upright: RigidBody
    tie_rod: RigidBody | None = None
    rocker: RigidBody | None = None
    wheel: RigidBody | None = None


class DoubleWishboneStrut(SpatialStrut):
    """Strut on an arm, the upright or a rocker, whose push rod stands on the body ``pushrod_on``."""

    on: Literal["lower_arm", "upper_arm", "upright", "rocker"] = "lower_arm"
    pushrod_on: Literal["lower_arm", "upper_arm", "upright"] = "lower_arm"


class DoubleWishboneBar(AntiRollBar):
    """Anti-roll bar linked to an arm or the upright."""

    on: Literal["lower_arm", "upper_arm", "upright"] = "lower_arm"


class DoubleWishboneBushings(Description):
    """Bushings in place of the arms' joints on the body."""

    lower_arm_front: Bushing | None = None
    lower_arm_rear: Bushing | None = None
    upper_arm_front: Bushing | None = None
    upper_arm_rear: Bushing | None = None
    tie_rod_inner: Bushing | None = None


class DoubleWishbone(Corner):
    """Double wishbone: two arms, an upright between their ball joints, a tie rod, a strut."""

    model: Literal["double-wishbone"] = "double-wishbone"
    hardpoints: DoubleWishboneHardpoints
    bodies: DoubleWishboneBodies
    strut: DoubleWishboneStrut
    steering: Steering | None = None
    anti_roll_bar: DoubleWishboneBar | None = None
    bushings: DoubleWishboneBushings = DoubleWishboneBushings()


class McPhersonBodies(Description):
    """Bodies of a McPherson suspension; ``strut`` is the part that slides in the upright and hangs on the body."""

    lower_arm: RigidBody
    upright: RigidBody
    strut: RigidBody | None = None
    tie_rod: RigidBody | None = None
    wheel: RigidBody | None = None


class McPhersonStrut(SpatialStrut):
    """Strut that guides the upright."""

    on: Literal["upright"] = "upright"


class McPhersonBar(AntiRollBar):
    """Anti-roll bar linked to the arm or the upright."""

    on: Literal["lower_arm", "upright"] = "upright"


class McPhersonBushings(Description):
    """Bushings in place of the arm's joints on the body."""

    lower_arm_front: Bushing | None = None
    lower_arm_rear: Bushing | None = None
    tie_rod_inner: Bushing | None = None
    strut_top: Bushing | None = None


class McPherson(Corner):
    """McPherson strut: one arm, a tie rod, and a strut that guides the upright."""

    model: Literal["mcpherson"] = "mcpherson"
    hardpoints: McPhersonHardpoints
    bodies: McPhersonBodies
    strut: McPhersonStrut
    steering: Steering | None = None
    anti_roll_bar: McPhersonBar | None = None
    bushings: McPhersonBushings = McPhersonBushings()


class FiveLinkBodies(Description):
    """Bodies of a five-link suspension; a link without mass is a rod of fixed length."""

    upright: RigidBody
    link_1: RigidBody | None = None
    link_2: RigidBody | None = None
    link_3: RigidBody | None = None
    link_4: RigidBody | None = None
    link_5: RigidBody | None = None
    rocker: RigidBody | None = None
    wheel: RigidBody | None = None


class FiveLinkStrut(SpatialStrut):
    """Strut on the upright, a link that is a body, or a rocker."""

    on: Literal["upright", "link_1", "link_2", "link_3", "link_4", "link_5", "rocker"] = "upright"
    pushrod_on: Literal["upright"] = "upright"


class FiveLinkBar(AntiRollBar):
    """Anti-roll bar linked to the upright."""

    on: Literal["upright"] = "upright"


class FiveLinkBushings(Description):
    """Bushings in place of the links' joints on the body."""

    link_1_inner: Bushing | None = None
    link_2_inner: Bushing | None = None
    link_3_inner: Bushing | None = None
    link_4_inner: Bushing | None = None
    link_5_inner: Bushing | None = None


class FiveLink(Corner):
    """Five links between body and upright; links that share a point are an arm. Link 5 is the toe link or tie rod."""

    model: Literal["five-link"] = "five-link"
    hardpoints: FiveLinkHardpoints
    bodies: FiveLinkBodies
    strut: FiveLinkStrut
    steering: Steering | None = None
    anti_roll_bar: FiveLinkBar | None = None
    bushings: FiveLinkBushings = FiveLinkBushings()


class TrailingArmBodies(Description):
    """Bodies of a trailing arm; the arm carries the wheel unless ``wheel`` is a body of its own."""

    arm: RigidBody
    wheel: RigidBody | None = None


class TrailingArmStrut(SpatialStrut):
    """Strut on the arm."""

    on: Literal["arm"] = "arm"


class TrailingArmBar(AntiRollBar):
    """Anti-roll bar linked to the arm."""

    on: Literal["arm"] = "arm"


class TrailingArmBushings(Description):
    """Bushings in place of the arm's joints on the body."""

    arm_inner: Bushing | None = None
    arm_outer: Bushing | None = None


class TrailingArm(Corner):
    """Trailing or semi-trailing arm: one body that carries the wheel, on an axis through two points of the body."""

    model: Literal["trailing-arm"] = "trailing-arm"
    hardpoints: TrailingArmHardpoints
    bodies: TrailingArmBodies
    strut: TrailingArmStrut
    anti_roll_bar: TrailingArmBar | None = None
    bushings: TrailingArmBushings = TrailingArmBushings()
