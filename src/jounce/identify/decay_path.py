"""The free decay with quadratic drag, integrated in small steps because it has no closed form."""

from __future__ import annotations

import numpy as np

from jounce.core.types import Array
from jounce.kernel.call import Loop

_follow = Loop("drag")


def drag_path(
    since: Array,
    angular_frequency: float,
    damping_ratio: float,
    friction: float,
    drag: float,
    release: float,
) -> Array:
    """Compute displacement (m), velocity (m/s) and acceleration (m/s^2) of a decay; shape (3, n).

    ``since`` are ascending times from the release (s). The mass obeys x'' + 2 damping_ratio angular_frequency x' +
    drag x' |x'| + angular_frequency^2 (x + friction sign(x')) = 0 from x = ``release`` (m) at rest; ``drag`` is in 1/m,
    ``friction`` the deflection F_c / k in m. The mass is held before the release, and sticks at a turning point
    within ``friction`` of the equilibrium.
    """
    times = np.ascontiguousarray(since, dtype=np.float64)
    path = np.zeros((3, len(times)))
    _follow(times, angular_frequency, damping_ratio, friction, drag, release, path)
    return path
