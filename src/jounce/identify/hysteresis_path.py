"""The normalised Bouc-Wen state along a measured path."""

from __future__ import annotations

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.phrases import Phrase
from jounce.core.samples import as_samples
from jounce.core.types import Array
from jounce.core.units import as_number
from jounce.kernel.call import Loop

_follow = Loop("hysteresis")
_RANGES = {"rate": (0.0, 1e30), "sigma": (0.5, 1e6), "exponent": (1.0, 1e3), "start": (-1.0, 1.0)}
_BEYOND = 0.01  # slopes by differences at a bound look a little beyond it


def bouc_wen_path(
    displacement: Array, rate: float, sigma: float, exponent: float, start: float
) -> Array:
    """Follow ``z' = rate (v - sigma |v| |z|^(n-1) z + (sigma - 1) v |z|^n)`` along a path of displacements.

    The law depends on the path only, not on time. Between two samples the motion is assumed to be monotonic, and the
    path is subdivided to keep the change of state per Runge-Kutta step small.

    Parameters
    ----------
    displacement : array (n,)
        Displacements in the order of the motion [m].
    rate : float
        Inverse of the distance over which the force builds up [1/m], at least 0.
    sigma : float
        Shape of the unloading [1], 1/2 to 1e6; 1/2 is symmetric.
    exponent : float
        n, sharpness of the yield [1], 1 to 1000.
    start : float
        z at the first sample [1], -1 to 1.

    Returns
    -------
    array (n,)
        z at each sample [1], within -1...1.

    Raises
    ------
    DescriptionError
        A path that is not a list of finite displacements, or a parameter out of range.

    Examples
    --------
    >>> path = np.array([0.0, 0.001, 0.002])    # m; z = 1 - exp(-rate x)
    >>> bouc_wen_path(path, 1e3, 0.5, 1.0, 0.0).round(3).tolist()
    [0.0, 0.632, 0.865]

    References
    ----------
    Ikhouane and Rodellar (2007), Systems with Hysteresis, Wiley (normalised form).
    """
    path = as_samples(displacement, "m", where="displacement", error=DescriptionError)
    if path.ndim != 1 or not np.all(np.isfinite(path)):
        raise DescriptionError(
            "invalid path",
            where="displacement",
            found=f"shape {path.shape}",
            allowed="finite numbers of shape (n,)",
        )
    rate, sigma, exponent, start = (
        as_number(value, "1/m" if name == "rate" else "1", where=name)
        for name, value in zip(_RANGES, (rate, sigma, exponent, start), strict=True)
    )
    for name, value, (least, most) in zip(
        _RANGES, (rate, sigma, exponent, start), _RANGES.values(), strict=True
    ):
        if not least - _BEYOND <= value <= most + _BEYOND:
            raise DescriptionError(
                "out of range",
                where=name,
                found=value,
                allowed=Phrase("{least:g} to {most:g}", least=least, most=most),
            )
    state = np.empty(len(path))
    _follow(path, rate, sigma, exponent, start, state)
    return state
