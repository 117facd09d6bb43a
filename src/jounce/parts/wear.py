"""Worn dampers: the same rig with less damper force."""

from __future__ import annotations

import math
import re
from typing import TypeVar

from jounce.core.errors import DescriptionError
from jounce.parts.rig import Rig

R = TypeVar("R", bound=Rig)
_LAW = re.compile(
    r"(^|\.)damper\.(\w*coefficient|force|hysteretic_force|force(\[\d+\])+)$"  # a damper's own table
    r"|^(?!.*tyre\.).*(^|\.)damping_coefficient$"  # or one number of an axle
)


def worn(rig: R, wear: float) -> R:
    """Give a rig whose dampers have lost a share of their force.

    Parameters
    ----------
    rig : Rig
        A rig or a vehicle; tyres, springs and friction stay as they are.
    wear : float
        Share that is lost: 0 new, 1 no damper at all.

    Returns
    -------
    Rig
        A copy.

    Raises
    ------
    DescriptionError
        For a wear outside of 0 to 1.

    Examples
    --------
    >>> from jounce.parts import load
    >>> worn(load("audi-a6-quarter-car"), 0.25).strut.damper.coefficient   # N s/m, of 2000
    1500.0
    """
    if not (math.isfinite(wear) and 0.0 <= wear <= 1.0):
        raise DescriptionError("not a wear", where="wear", found=wear, allowed="0 (new) to 1 (no damper at all)")
    forces = {path: value for path, value in rig.parameters().items() if _LAW.search(path)}
    return rig.with_changes({path: (1.0 - wear) * value for path, value in forces.items()})
