"""Road holding and suspension travel at one corner: numbers from its strut's and its tyre's signals, SI."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import RecordingError
from jounce.core.types import Array
from jounce.ride.comfort import duration_of, integral


def mean(values: Array) -> float:
    """Time mean in the unit of ``values``: trapezoids, so that both ends of a record count half."""
    return integral(values, 1.0) / duration_of(values, 1.0)


def deviation(values: Array) -> float:
    """Standard deviation about the time mean, in the unit of ``values``."""
    centred = values - mean(values)
    return float(mean(centred * centred) ** 0.5)


def peak_to_peak(values: Array) -> float:
    """Largest minus smallest value, in the unit of ``values``."""
    return float(values.max() - values.min())


def peak_use(deflection: Array, rebound: float, bump: float) -> float:
    """Largest share (1) of the bump or rebound travel (m from the mean deflection) that a deflection (m) takes."""
    middle = mean(deflection)
    return max((float(deflection.max()) - middle) / bump, (middle - float(deflection.min())) / rebound)


def contacts(deflection: Array, gap: float) -> int:
    """How often (1) a deflection (m) closes a stop's gap (m); closed at the start counts as well."""
    closed = deflection > gap
    return int(np.count_nonzero(closed[1:] & ~closed[:-1])) + int(closed[0])


def share(condition: NDArray[np.bool_]) -> float:
    """Share (1) of the time in which a condition holds."""
    return mean(condition.astype(float))


def load_coefficient(load: Array) -> float:
    """Standard deviation over mean (1) of a wheel load (N)."""
    return deviation(load) / _static(load)


def adhesion(load: Array) -> float:
    """Smallest over mean wheel load (1); loads in N."""
    return smallest(load) / _static(load)


def smallest(load: Array) -> float:
    """Smallest wheel load (N)."""
    return float(load.min()) + 0.0  # never -0


def stress_factor(load: Array) -> float:
    """Mean fourth power of the wheel load (N) over the fourth power of its mean (1)."""
    relative = load / _static(load)
    return mean(relative**4)


def _static(load: Array) -> float:
    found = mean(load)
    if not found > 0.0:
        raise RecordingError("the mean wheel load is not positive", found=f"{found:g} N", allowed="above 0 N")
    return found
