"""Quantities on a measured K&C sheet, with units and signs, and how left and right answer each other in a test."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from jounce.kc.tests import TESTS

Axis = Literal["x", "y", "z", "turn", "road x", "road y", "road z", "toe", "camber", "steer", ""]
"""What of a sign convention decides the sign of a quantity; empty: the same sign in every convention."""


INPUTS: Mapping[str, str] = {
    "heights": "contact_point_z",
    "roll": "roll_angle",
    "rack": "rack_travel",
    "lateral": "lateral_force",
    "longitudinal": "longitudinal_force",
    "aligning": "aligning_moment",
}
"""Quantity that the input is made of, by the kind of a test."""


def mirror_of(test: str) -> int:
    """Return 1 if the wheels answer a test as mirror images, -1 as opposites of them, 0 if only one is loaded.

    >>> mirror_of("lateral-opposed"), mirror_of("lateral-in-phase"), mirror_of("lateral-left"), mirror_of("roll")
    (1, -1, 0, -1)
    """
    kind, (left, right) = TESTS[test].kind, TESTS[test].shares
    if kind in ("lateral", "aligning"):
        return int(-left * right)
    return -1 if kind in ("roll", "rack") else 1


@dataclass(frozen=True)
class KcQuantity:
    """A quantity of a sheet.

    Attributes
    ----------
    label : str
        What it is.
    positive : str
        Its sign.
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
    positive: str
    unit: str
    usual: str
    axis: Axis = ""
    mirror: int = 1
    target: str = ""
    times: int = 1


WHEEL_QUANTITIES: Mapping[str, KcQuantity] = {
    "toe": KcQuantity("toe angle", "toe-in", "rad", "deg", "toe"),
    "camber": KcQuantity("camber angle", "top outward", "rad", "deg", "camber"),
    "steer": KcQuantity("steer angle", "about +z", "rad", "deg", "steer", -1),
    "caster": KcQuantity("caster angle", "top rearward", "rad", "deg"),
    "spin": KcQuantity("rotation of the wheel carrier about the wheel's axis", "as in rolling forward", "rad", "deg"),
    "wheel_centre_x": KcQuantity("wheel centre, from design", "forward", "m", "mm", "x"),
    "wheel_centre_y": KcQuantity("wheel centre, from design", "to the left", "m", "mm", "y", -1),
    "wheel_centre_z": KcQuantity("wheel centre, from design", "up", "m", "mm", "z"),
    "contact_point_x": KcQuantity("contact point, from design", "forward", "m", "mm", "x"),
    "contact_point_y": KcQuantity("contact point, from design", "to the left", "m", "mm", "y", -1),
    "contact_point_z": KcQuantity("contact point, from design", "up", "m", "mm", "z"),
    "vertical_force": KcQuantity("force of the road on the tyre", "up", "N", "N", "road z"),
    "lateral_force": KcQuantity("force of the road on the tyre", "to the left", "N", "N", "road y", -1),
    "longitudinal_force": KcQuantity("force of the road on the tyre", "forward", "N", "N", "road x"),
    "aligning_moment": KcQuantity("moment of the road on the tyre", "about +z", "N*m", "N*m", "road z", -1),
    "spring_force": KcQuantity("force of the spring", "compression", "N", "N"),
    "wheel_travel": KcQuantity("wheel travel", "bump", "m", "mm", target="wheel_centre_z"),
    "pad_height": KcQuantity("height of the pad", "up", "m", "mm", target="contact_point_z"),
    "wheel_load": KcQuantity("wheel load", "compression", "N", "N", target="vertical_force"),
    "brake_force": KcQuantity("brake force", "rearward", "N", "N", target="longitudinal_force", times=-1),
    "toe_front_gauge": KcQuantity("dial gauge at the front of the wheel", "outward", "m", "mm"),
    "toe_rear_gauge": KcQuantity("dial gauge at the rear of the wheel", "outward", "m", "mm"),
}  # fmt: skip
"""Quantities of each wheel by name."""

AXLE_QUANTITIES: Mapping[str, KcQuantity] = {
    "rack_travel": KcQuantity("travel of the rack on the body", "to the left", "m", "mm", "y"),
    "rack_force": KcQuantity("force of the handwheel on the rack", "to the left", "N", "N", "y"),
    "handwheel_angle": KcQuantity("handwheel angle", "to the left", "rad", "deg", "steer"),
    "handwheel_torque": KcQuantity("handwheel torque", "to the left", "N*m", "N*m", "steer"),
    "roll_angle": KcQuantity("roll angle of the pads", "left pad up", "rad", "deg", "turn"),
    "gauge_base": KcQuantity("distance of the two toe gauges", "", "m", "mm"),
    "input": KcQuantity("input of the test", "", "", ""),
}
"""Quantities of the axle by name."""

QUANTITIES: Mapping[str, KcQuantity] = {**WHEEL_QUANTITIES, **AXLE_QUANTITIES}
"""Every quantity that a column of a measured sheet may hold."""

ZEROED = ("wheel_centre_x", "wheel_centre_y", "wheel_centre_z",
          "contact_point_x", "contact_point_y", "contact_point_z", "spin")  # fmt: skip
"""Movements from the design position: measured sheets are zeroed where the input is zero."""
WHEELS = ("left", "right")
READING = {"rad": 1.75e-4, "m": 1e-4, "N": 10.0, "N*m": 1.0}
"""Differences, SI, below what a laboratory reads: 0.01 deg, 0.1 mm, 10 N, 1 N m."""


def quantity_name(variable: str) -> str:
    """Return the quantity of a variable of a sheet.

    >>> quantity_name("left.toe"), quantity_name("rack_travel")
    ('toe', 'rack_travel')
    """
    return variable.removeprefix("left.").removeprefix("right.")
