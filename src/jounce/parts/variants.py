"""Variants of a rig: a different strut angle, or worn dampers."""

from __future__ import annotations

import math
import re
from typing import TypeVar, cast

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding, finding
from jounce.core.phrases import Phrase
from jounce.core.units import to_si
from jounce.parts.advice import STEEP_STRUT
from jounce.parts.bodies import Triple
from jounce.parts.corners import Corner, McPherson
from jounce.parts.rig import Rig
from jounce.parts.vehicles import QuarterCar

R = TypeVar("R", bound=Rig)
LARGEST = 1.2
"""Maximum angle of a strut to either side, rad."""
_OWN_ENDS = ("spring_bottom", "spring_top", "damper_bottom", "damper_top")


def strut_angle(rig: Rig) -> float:
    """Return the angle of the strut to the vertical, rad; for a 3-D rig in front view at design, positive inboard.

    Raises an error for McPherson struts, struts on a rocker, and separate lines of spring and damper.

    >>> from jounce.parts import load
    >>> round(float(np.degrees(strut_angle(load("kart-double-wishbone")))), 2)
    26.0
    """
    if isinstance(rig, QuarterCar):
        return rig.strut.angle
    bottom, top = _ends(rig)
    return float(np.arctan2(cast(Corner, rig).sign * (bottom[1] - top[1]), top[2] - bottom[2]))


def with_strut_angle(rig: R, angle: float | str) -> R:
    """Return a copy of the rig with its strut at a given angle to the vertical.

    For a lumped rig this changes ``strut.angle``. In a 3-D rig the upper end of the strut rotates about its lower end
    in the transverse plane. Design length, x coordinates, free length or preload and all other values are kept, so the
    equilibrium changes.

    Parameters
    ----------
    rig : Rig
        A lumped or 3-D rig; it is not modified.
    angle : float or str
        rad, or text with a unit; in front view, positive if the upper end leans inboard, on both sides of the car.

    Returns
    -------
    Rig
        A rig of the same model.

    Raises
    ------
    DescriptionError
        For an absolute angle above 1.2 rad, or a rig whose strut cannot be rotated independently.

    Examples
    --------
    >>> from jounce.parts import load
    >>> rig = with_strut_angle(load("kart-double-wishbone"), "16 deg")
    >>> [round(1e3 * x, 2) for x in rig.hardpoints.strut_top]   # mm
    [30.0, 279.87, 242.25]
    """
    wanted = to_si(angle, "rad", where="strut angle")
    if isinstance(rig, QuarterCar):
        return rig.with_changes({"strut.angle": wanted})
    if not abs(wanted) <= LARGEST:
        raise DescriptionError(
            "out of range",
            where="strut angle",
            found=angle,
            allowed=Phrase(
                "{largest:g} to {second_largest:g} rad", largest=-LARGEST, second_largest=LARGEST
            ),
        )
    bottom, top = _ends(rig)
    reach = float(np.hypot(top[1] - bottom[1], top[2] - bottom[2]))
    inboard = -cast(Corner, rig).sign
    return rig.with_changes(
        {
            "hardpoints.strut_top[1]": bottom[1] + inboard * reach * float(np.sin(wanted)),
            "hardpoints.strut_top[2]": bottom[2] + reach * float(np.cos(wanted)),
        }
    )


def strut_angle_findings(angle: float, place: str) -> list[Finding]:
    """Return a warning for a strut angle (rad) that the literature rejects; ``place`` is the path of the setting."""
    if abs(angle) <= STEEP_STRUT + 1e-9:
        return []
    return [finding("parts.strut_leans_estimate", place, angle, angle=angle)]


def _ends(rig: Rig) -> tuple[Triple, Triple]:
    """Return lower and upper end of a strut, or raise an error if the strut cannot be rotated."""
    if not isinstance(rig, Corner):
        raise DescriptionError(
            "this rig has no strut whose angle can be changed", where="strut angle"
        )
    points, moved, allowed = rig.hardpoints, "strut_top", ""
    rig.require("strut", what="the angle of the strut")
    own = [name for name in _OWN_ENDS if getattr(points, name) is not None]
    if isinstance(rig, McPherson):
        cause = 'model = "mcpherson"'
        problem = (
            "a McPherson strut guides the wheel: inclining it would change the whole suspension"
        )
    elif rig.strut.on == "rocker":
        cause = 'strut.on = "rocker"'
        problem = (
            "the strut is on a rocker: its angle in front view does not determine the motion ratio"
        )
    elif own:
        cause, moved = ", ".join(f"hardpoints.{name}" for name in own), own[-1]
        problem = "spring and damper are not collinear, so no single angle describes them"
        allowed = "rigs whose strut has only strut_bottom and strut_top"
    else:
        return cast(Triple, points.strut_bottom), cast(Triple, points.strut_top)
    hint = Phrase(
        'Move its hardpoints instead: changes = {{"hardpoints.{moved}" = [...]}} in a trial.',
        moved=moved,
    )
    raise DescriptionError(problem, where="strut angle", found=cause, allowed=allowed, hint=hint)


_LAW = re.compile(
    r"(^|\.)damper\.(\w*coefficient|force|hysteretic_force|force(\[\d+\])+)$"  # a damper's own table
    r"|^(?!.*tyre\.).*(^|\.)damping_coefficient$"  # or a single number of an axle
)


def wear_dampers(rig: R, wear: float) -> R:
    """Return a copy of a rig whose dampers have lost a fraction ``wear`` of their force: 0 new, 1 no damping.

    Tyres, springs and friction are unchanged.

    >>> from jounce.parts import load
    >>> wear_dampers(load("audi-a6-quarter-car"), 0.25).strut.damper.coefficient   # N s/m, of 2000
    1500.0
    """
    if not (math.isfinite(wear) and 0.0 <= wear <= 1.0):
        raise DescriptionError(
            "invalid wear", where="wear", found=wear, allowed="0 (new) to 1 (no damper at all)"
        )
    forces = {path: value for path, value in rig.parameters().items() if _LAW.search(path)}
    return rig.with_changes({path: (1.0 - wear) * value for path, value in forces.items()})
