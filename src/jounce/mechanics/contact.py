"""Contact point of a wheel: the lowest point of its disc, in the wheel's plane.

With the wheel's axis ``a`` and the road's normal ``n``, both unit vectors, the disc leans by the angle ``gamma`` whose
sine is the size of ``a . n``. From the wheel's centre the point lies a loaded radius along

    d = (a (a . n) - n) / cos(gamma)

away. Whatever stands still on the road while the wheel's centre is ``h`` above it is ``h / cos(gamma)`` away along
``d``. All of jounce takes this one point: kinematics, load cases, compliance, runs of cars, pictures.
"""

from __future__ import annotations

from typing import Any


def towards_road(axis: Any, normal: Any) -> tuple[tuple[Any, Any, Any], Any]:
    """Unit vector from a wheel's centre to its contact point, and the cosine of the wheel's inclination.

    ``axis`` and ``normal`` are x, y, z of unit vectors along the wheel's axis (either way) and out of the road:
    numbers, arrays or expressions; results are of the same kind.
    """
    lean = axis[0] * normal[0] + axis[1] * normal[1] + axis[2] * normal[2]
    upright = (1.0 - lean * lean) ** 0.5
    x, y, z = ((lean * axis[i] - normal[i]) / upright for i in range(3))
    return (x, y, z), upright
