"""Sign conventions of measured sheets: directions of axes, angles and forces, and the factor to jounce's signs."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Literal

from jounce.core.description import Description
from jounce.core.errors import unknown
from jounce.kc.vocabulary import QUANTITIES


class SignConvention(Description):
    """Directions in which the readings of a sheet are positive. Turns and moments are right-handed about their axis.

    Attributes
    ----------
    x : {"forward", "rearward"}
        Longitudinal axis.
    y : {"left", "right"}
        Lateral axis; rack travel and rack force follow it.
    z : {"up", "down"}
        Vertical axis. Readings named wheel travel, pad height or wheel load are positive in bump in every convention.
    toe : {"in", "out"}
        Toe angles.
    camber : {"outward", "inward"}
        Camber angles: the direction in which the top leans.
    steer : {"left", "right"}
        Steer angles, handwheel angle and handwheel torque.
    forces : {"road-on-tyre", "tyre-on-road"}
        Forces and moments at the contact patch.
    """

    x: Literal["forward", "rearward"] = "forward"
    y: Literal["left", "right"] = "left"
    z: Literal["up", "down"] = "up"
    toe: Literal["in", "out"] = "in"
    camber: Literal["outward", "inward"] = "outward"
    steer: Literal["left", "right"] = "left"
    forces: Literal["road-on-tyre", "tyre-on-road"] = "road-on-tyre"

    def factor(self, quantity: str) -> int:
        """Return the factor (1 or -1) from a reading of a quantity to jounce's sign.

        >>> CONVENTIONS["j670e"].factor("wheel_centre_z"), CONVENTIONS["j670e"].factor("wheel_travel")
        (-1, 1)
        """
        axes = {
            "x": 1 if self.x == "forward" else -1,
            "y": 1 if self.y == "left" else -1,
            "z": 1 if self.z == "up" else -1,
            "toe": 1 if self.toe == "in" else -1,
            "camber": 1 if self.camber == "outward" else -1,
            "steer": 1 if self.steer == "left" else -1,
            "": 1,
        }
        road = 1 if self.forces == "road-on-tyre" else -1
        axes |= {f"road {axis}": road * axes[axis] for axis in "xyz"} | {"turn": axes["x"]}
        return axes[QUANTITIES[quantity].axis]


_RIGHT_DOWN = SignConvention(y="right", z="down", steer="right")
CONVENTIONS: Mapping[str, SignConvention] = {
    "iso": SignConvention(),
    "j670e": _RIGHT_DOWN,
    "j670-z-down": _RIGHT_DOWN,
    "j670-z-up": SignConvention(),
    "adams-car": SignConvention(x="rearward", y="right"),
    "rear-right-up": SignConvention(x="rearward", y="right"),
}
"""Conventions by name. Toe-in and camber with the top outward are positive in all of them.

``iso``: ISO 8855, x forward, y left, z up. ``j670e`` and ``j670-z-down``: SAE, x forward, y right, z down.
``j670-z-up``: the other orientation of SAE J670, the same as ISO. ``adams-car`` and ``rear-right-up``: x to the rear,
y right, z up, a steer angle to the left positive. The standards themselves were not read. Sources: MathWorks,
*Coordinate Systems in Vehicle Dynamics Blockset*; Adams Car's help, *Toe and Camber*, *Output of Suspension Analyses*.
"""


def convention_of(given: str | Mapping[str, str] | SignConvention, where: str) -> SignConvention:
    """Return a convention by its name, from a table of directions, or itself."""
    if isinstance(given, SignConvention):
        return given
    if isinstance(given, str):
        if given not in CONVENTIONS:
            raise unknown(given, CONVENTIONS, what="sign convention", where=where)
        return CONVENTIONS[given]
    return SignConvention.from_table(dict(given), where=where)


def convention_in(text: str) -> str:
    """Return the name of the convention that a preamble states; empty for none or several.

    >>> [convention_in(text) for text in ("Rig 3, axes to SAE J670e", "J670, z-up", "ISO 8855", "SAE J670")]
    ['j670e', 'j670-z-up', 'iso', '']
    """
    plain = " ".join(text.lower().replace("-", " ").split())
    names = {"iso"} if re.search(r"\biso ?8855\b", plain) else set[str]()
    if re.search(r"\badams[ /]car\b", plain):
        names.add("adams-car")
    if "j670e" in plain or re.search(r"\b(sae|j670)\b.*\bz (axis )?down\b", plain):
        names.add("j670e")
    elif re.search(r"\bj670\b.*\bz (axis )?up\b", plain):
        names.add("j670-z-up")
    return names.pop() if len(names) == 1 else ""
