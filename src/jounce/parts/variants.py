"""The same rig with its strut at another angle, or with worn dampers."""

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
"""Angle in rad to either side that a strut may take."""
_OWN_ENDS = ("spring_bottom", "spring_top", "damper_bottom", "damper_top")


def strut_angle(rig: Rig) -> float:
    """Angle of the strut to the vertical, rad; of a 3-D rig in front view at design, positive where it leans inboard.

    A McPherson strut, a strut on a rocker, and spring and damper that are not on one line have none: they are refused.

    >>> from jounce.parts import load
    >>> round(float(np.degrees(strut_angle(load("kart-double-wishbone")))), 2)
    26.0
    """
    if isinstance(rig, QuarterCar):
        return rig.strut.angle
    bottom, top = _ends(rig)
    return float(np.arctan2(cast(Corner, rig).sign * (bottom[1] - top[1]), top[2] - bottom[2]))


def with_strut_angle(rig: R, angle: float | str) -> R:
    """Give the rig with its strut at another angle to the vertical.

    A lumped rig gets another ``strut.angle``. In a 3-D rig the upper end of the strut turns about its lower end in the
    transverse plane, at constant design length: x of the strut, free length or preload, and everything else are kept,
    so the equilibrium becomes another one.

    Parameters
    ----------
    rig : Rig
        Lumped or 3-D; it is not changed.
    angle : float or str
        rad, or text with a unit; seen from the front, positive where the upper end leans inboard, on either side of
        the car.

    Returns
    -------
    Rig
        Of the same kind.

    Raises
    ------
    DescriptionError
        For an angle beyond 1.2 rad to either side, or a rig whose strut cannot be turned by itself.

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
    """Warn of a strut angle (rad) that the literature rejects; ``place`` is where it was set."""
    if abs(angle) <= STEEP_STRUT + 1e-9:
        return []
    return [finding("parts.strut_leans_estimate", place, angle, angle=angle)]


def _ends(rig: Rig) -> tuple[Triple, Triple]:
    """Lower and upper end of a strut that can be turned; the reason where it cannot."""
    if not isinstance(rig, Corner):
        raise DescriptionError("this rig has no strut that could be turned", where="strut angle")
    points, moved, allowed = rig.hardpoints, "strut_top", ""
    rig.require("strut", what="the angle of the strut")
    own = [name for name in _OWN_ENDS if getattr(points, name) is not None]
    if isinstance(rig, McPherson):
        cause = 'model = "mcpherson"'
        problem = "a McPherson strut guides the wheel: turning it would change the whole suspension"
    elif rig.strut.on == "rocker":
        cause = 'strut.on = "rocker"'
        problem = "the strut is on a rocker: its angle in front view does not decide its leverage"
    elif own:
        cause, moved = ", ".join(f"hardpoints.{name}" for name in own), own[-1]
        problem = "spring and damper are not on one line, so that no single angle describes them"
        allowed = "rigs that give strut_bottom and strut_top only"
    else:
        return cast(Triple, points.strut_bottom), cast(Triple, points.strut_top)
    hint = Phrase(
        'Move its hardpoints instead: changes = {{"hardpoints.{moved}" = [...]}} in a trial.',
        moved=moved,
    )
    raise DescriptionError(problem, where="strut angle", found=cause, allowed=allowed, hint=hint)


_LAW = re.compile(
    r"(^|\.)damper\.(\w*coefficient|force|hysteretic_force|force(\[\d+\])+)$"  # a damper's own table
    r"|^(?!.*tyre\.).*(^|\.)damping_coefficient$"  # or one number of an axle
)


def wear_dampers(rig: R, wear: float) -> R:
    """A copy of a rig or vehicle whose dampers have lost a share ``wear`` of their force: 0 new, 1 no damper at all.

    Tyres, springs and friction stay as they are.

    >>> from jounce.parts import load
    >>> wear_dampers(load("audi-a6-quarter-car"), 0.25).strut.damper.coefficient   # N s/m, of 2000
    1500.0
    """
    if not (math.isfinite(wear) and 0.0 <= wear <= 1.0):
        raise DescriptionError(
            "not a wear", where="wear", found=wear, allowed="0 (new) to 1 (no damper at all)"
        )
    forces = {path: value for path, value in rig.parameters().items() if _LAW.search(path)}
    return rig.with_changes({path: (1.0 - wear) * value for path, value in forces.items()})
