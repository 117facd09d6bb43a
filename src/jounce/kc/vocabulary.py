"""Names of tests and quantities on a K&C sheet, with units, and how left and right answer each other."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

Axis = Literal["x", "y", "z", "turn", "road x", "road y", "road z", "toe", "camber", "steer", ""]
"""What of a sign convention decides the sign of a quantity; empty: the same sign in every convention."""


@dataclass(frozen=True)
class KcTest:
    """A test of the laboratory.

    Attributes
    ----------
    label : str
        What is swept.
    unit : str
        SI unit of the input.
    mirror : {1, -1, 0}
        1: the wheels answer as mirror images, -1: as opposites of mirror images, 0: neither, only one wheel is loaded.
    quantity : str
        Quantity that the input is made of.
    """

    label: str
    unit: str
    mirror: int
    quantity: str


KC_TESTS: Mapping[str, KcTest] = {
    "bounce": KcTest("height of both pads, bump positive", "m", 1, "contact_point_z"),
    "roll": KcTest("roll of the pads, left pad up positive", "rad", -1, "roll_angle"),
    "steer": KcTest("rack travel, to the left positive", "m", -1, "rack_travel"),
    "lateral-in-phase": KcTest("lateral force per wheel, left positive", "N", -1, "lateral_force"),
    "lateral-opposed": KcTest("lateral force per wheel, outwards positive", "N", 1, "lateral_force"),
    "lateral-left": KcTest("lateral force on the left wheel", "N", 0, "lateral_force"),
    "lateral-right": KcTest("lateral force on the right wheel", "N", 0, "lateral_force"),
    "lateral-trail": KcTest("lateral force per wheel, behind the patch", "N", -1, "lateral_force"),
    "braking": KcTest("force per wheel, rearward positive", "N", 1, "longitudinal_force"),
    "braking-inboard": KcTest("force per wheel, rearward positive", "N", 1, "longitudinal_force"),
    "driving": KcTest("force per wheel, forward positive", "N", 1, "longitudinal_force"),
    "driving-hub": KcTest("force per wheel, forward positive", "N", 1, "longitudinal_force"),
    "aligning-in-phase": KcTest("moment per wheel about +z", "N*m", -1, "aligning_moment"),
    "aligning-opposed": KcTest("moment, left wheel +z, right wheel -z", "N*m", 1, "aligning_moment"),
}  # fmt: skip
"""Every test by its name, in the order of the sheet."""


@dataclass(frozen=True)
class KcQuantity:
    """A quantity of a sheet.

    Attributes
    ----------
    label : str
        What it is, with its sign.
    unit : str
        SI unit.
    usual : str
        Unit in which laboratories and workshops write it.
    axis : str
        What of a sign convention decides its sign.
    mirror : {1, -1}
        1: equal on both wheels if these are mirror images, -1: opposite.
    target : str
        Quantity that a reading of it is stored as; empty: itself.
    times : {1, -1}
        Sign of the reading in that quantity.
    """

    label: str
    unit: str
    usual: str
    axis: Axis = ""
    mirror: int = 1
    target: str = ""
    times: int = 1


WHEEL_QUANTITIES: Mapping[str, KcQuantity] = {
    "toe": KcQuantity("toe angle, toe-in positive", "rad", "deg", "toe"),
    "camber": KcQuantity("camber angle, top outward positive", "rad", "deg", "camber"),
    "steer": KcQuantity("steer angle about +z", "rad", "deg", "steer", -1),
    "caster": KcQuantity("caster angle, top rearward positive", "rad", "deg"),
    "spin": KcQuantity("rotation of the wheel carrier, forward rolling positive", "rad", "deg"),
    "wheel_centre_x": KcQuantity("movement of the wheel centre, forward", "m", "mm", "x"),
    "wheel_centre_y": KcQuantity("movement of the wheel centre, to the left", "m", "mm", "y", -1),
    "wheel_centre_z": KcQuantity("movement of the wheel centre, up", "m", "mm", "z"),
    "contact_point_x": KcQuantity("movement of the contact point, forward", "m", "mm", "x"),
    "contact_point_y": KcQuantity("movement of the contact point, to the left", "m", "mm", "y", -1),
    "contact_point_z": KcQuantity("movement of the contact point, up", "m", "mm", "z"),
    "vertical_force": KcQuantity("force of the road on the tyre, up", "N", "N", "road z"),
    "lateral_force": KcQuantity("force of the road on the tyre, to the left", "N", "N", "road y", -1),
    "longitudinal_force": KcQuantity("force of the road on the tyre, forward", "N", "N", "road x"),
    "aligning_moment": KcQuantity("moment of the road on the tyre about +z", "N*m", "N*m", "road z", -1),
    "spring_force": KcQuantity("force of the spring, compression positive", "N", "N"),
    "wheel_travel": KcQuantity("wheel travel, bump positive", "m", "mm", target="wheel_centre_z"),
    "pad_height": KcQuantity("height of the pad, up positive", "m", "mm", target="contact_point_z"),
    "wheel_load": KcQuantity("wheel load, compression positive", "N", "N", target="vertical_force"),
    "brake_force": KcQuantity("brake force, rearward positive", "N", "N", target="longitudinal_force", times=-1),
    "toe_front_gauge": KcQuantity("dial gauge at the front of the wheel, outward positive", "m", "mm"),
    "toe_rear_gauge": KcQuantity("dial gauge at the rear of the wheel, outward positive", "m", "mm"),
}  # fmt: skip
"""Quantities of each wheel by name."""

AXLE_QUANTITIES: Mapping[str, KcQuantity] = {
    "rack_travel": KcQuantity("rack travel, to the left positive", "m", "mm", "y"),
    "rack_force": KcQuantity("force of the rack, to the left positive", "N", "N", "y"),
    "handwheel_angle": KcQuantity("handwheel angle, to the left positive", "rad", "deg", "steer"),
    "handwheel_torque": KcQuantity("handwheel torque, to the left positive", "N*m", "N*m", "steer"),
    "roll_angle": KcQuantity("roll angle of the pads, left pad up positive", "rad", "deg", "turn"),
    "gauge_base": KcQuantity("distance of the two toe gauges", "m", "mm"),
    "input": KcQuantity("input of the test", "", ""),
}
"""Quantities of the axle by name."""

QUANTITIES: Mapping[str, KcQuantity] = {**WHEEL_QUANTITIES, **AXLE_QUANTITIES}
"""Every quantity that a column of a measured sheet may hold."""

ZEROED = ("wheel_centre_x", "wheel_centre_y", "wheel_centre_z",
          "contact_point_x", "contact_point_y", "contact_point_z", "spin")  # fmt: skip
"""Movements from the design position: measured sheets are zeroed where the input is zero."""
WHEELS = ("left", "right")


def quantity_name(variable: str) -> str:
    """Return the quantity of a variable of a sheet.

    >>> quantity_name("left.toe"), quantity_name("rack_travel")
    ('toe', 'rack_travel')
    """
    return variable.removeprefix("left.").removeprefix("right.")
