"""Contact point of a wheel: the lowest point of its disc, in the wheel's plane.

With the wheel's axis ``a`` and the road's normal ``n``, both unit vectors, the disc is inclined by the angle ``gamma``
whose sine is the magnitude of ``a . n``. The point is one loaded radius from the wheel's centre along

    d = (a (a . n) - n) / cos(gamma)

At a height ``h`` of the wheel's centre above the road, the road is ``h / cos(gamma)`` away along ``d``. All of jounce
uses this contact point: kinematics, load cases, compliance, simulations of cars and pictures.
"""

from __future__ import annotations

from typing import Any


def towards_road(axis: Any, normal: Any) -> tuple[tuple[Any, Any, Any], Any]:
    """Return the unit vector from a wheel's centre to its contact point, and the cosine of the wheel's inclination.

    ``axis`` and ``normal`` are x, y, z of unit vectors along the wheel's axis (either direction) and out of the road:
    numbers, arrays or expressions. The results have the same type.
    """
    lean = axis[0] * normal[0] + axis[1] * normal[1] + axis[2] * normal[2]
    upright = (1.0 - lean * lean) ** 0.5
    x, y, z = ((lean * axis[i] - normal[i]) / upright for i in range(3))
    return (x, y, z), upright
