"""Slopes of a K&C test as laboratories fit them: a straight line over a stated range about a stated point."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.kc.loops import lines_of

if TYPE_CHECKING:
    import xarray as xr

_ROUNDING = 1e-12  # SI, and as a share of the values
_GRID = 41


def kc_slopes(
    dataset: xr.Dataset,
    about: float | str = 0.0,
    within: float | str | tuple[float | str, float | str] | None = None,
) -> xr.Dataset:
    """Fit a straight line to every quantity of a K&C test over its input.

    Parameters
    ----------
    dataset : xarray.Dataset
        One test, simulated or measured: quantities over ``sample`` with the coordinate ``input``.
    about : float or str
        Input at which the intercept is given, in the SI unit of the input or as text with a unit.
    within : float, str or tuple, optional
        Half of the range about that point, or its two ends: ``"1 kN"``, ``(-0.02, "30 mm")``. None: the whole test.

    Returns
    -------
    xarray.Dataset
        Over ``quantity``: ``slope`` (SI unit of the quantity over that of the input, see the coordinate ``unit``),
        ``intercept`` (SI, the line's value at ``about``), ``nonlinearity`` (largest distance of the mean curve from
        the line, as a share of the line's range; NaN for a flat line) and ``hysteresis`` (largest opening of the loop,
        as a share of the range of the mean curve; NaN for a constant). The range that was fitted is in the attributes
        ``low`` and ``high``.

    Raises
    ------
    DescriptionError
        If the dataset has no input, or fewer than two different inputs lie in the range.

    Examples
    --------
    >>> import numpy as np
    >>> import xarray as xr
    >>> x = np.linspace(-0.05, 0.05, 41)
    >>> toe = ("sample", 0.002 - 0.1 * x, {"units": "rad"})                 # synthetic: a straight bump steer
    >>> test = xr.Dataset({"left.toe": toe}, {"input": ("sample", x, {"units": "m"})})
    >>> fit = kc_slopes(test, within="20 mm").sel(quantity="left.toe")
    >>> round(float(fit["slope"]), 9), str(fit["unit"].values), round(float(fit["intercept"]), 9)
    (-0.1, 'rad/m', 0.002)
    """
    if "input" not in dataset.coords:
        raise DescriptionError("the dataset has no input", where="dataset", allowed="a K&C test")
    sweep = np.asarray(dataset["input"].values, dtype=float)
    unit = str(dataset["input"].attrs.get("units", "1"))
    centre = to_si(about, unit, where="about")
    low, high = _range(centre, within, unit, sweep)
    variables = dataset.variables
    names = [name for name in dataset.data_vars if variables[name].dims == ("sample",)]
    rows = np.full((4, len(names)), np.nan)
    slack = 1e-9 * float(np.ptp(sweep))
    inside = (sweep >= low - slack) & (sweep <= high + slack)
    if np.unique(sweep[inside]).size < 2:
        raise DescriptionError(
            "fewer than two inputs in the range",
            where="within",
            found=f"{low:g} to {high:g} {unit}",
            allowed=Phrase(
                "a part of {low:g} to {high:g} {unit}",
                low=float(sweep.min()),
                high=float(sweep.max()),
                unit=unit,
            ),
        )
    for k, name in enumerate(names):
        rows[:, k] = _fit(
            sweep, np.asarray(variables[name].values, dtype=float), inside, centre, low, high
        )
    return _result(dataset, [str(name) for name in names], rows, unit, (centre, low, high))


def _range(
    centre: float,
    within: float | str | tuple[float | str, float | str] | None,
    unit: str,
    sweep: Array,
) -> tuple[float, float]:
    if within is None:
        return float(np.min(sweep)), float(np.max(sweep))
    if isinstance(within, tuple | list):
        if len(within) != 2:
            raise DescriptionError(
                "not a range", where="within", found=str(within), allowed="two ends"
            )
        low, high = (to_si(end, unit, where="within") for end in within)
    else:
        half = to_si(within, unit, where="within")
        low, high = centre - half, centre + half
    if not low < high:
        raise DescriptionError(
            "not a range", where="within", found=f"{low:g} to {high:g}", allowed="a lower end first"
        )
    return low, high


def _fit(
    sweep: Array,
    values: Array,
    inside: NDArray[np.bool_],
    centre: float,
    low: float,
    high: float,
) -> tuple[float, float, float, float]:
    """Return slope, intercept, nonlinearity and hysteresis of one quantity; NaN if it is not known."""
    used = inside & np.isfinite(values)
    x, y = sweep[used] - centre, values[used]
    if np.unique(x).size < 2:
        return np.nan, np.nan, np.nan, np.nan
    mean = float(x.mean())
    slope = float(((x - mean) * (y - y.mean())).sum() / ((x - mean) ** 2).sum())
    intercept = float(y.mean()) - slope * mean
    grid = np.linspace(max(low, float(sweep.min())), min(high, float(sweep.max())), _GRID)
    lines = lines_of(sweep, values, grid)
    curve = lines.mean
    away = np.abs(curve - intercept - slope * (grid - centre))
    line, span = abs(slope) * float(np.ptp(grid)), float(np.nanmax(curve) - np.nanmin(curve))
    least = _ROUNDING * max(float(np.max(np.abs(y))), 1.0)
    return (
        slope,
        intercept,
        float(np.nanmax(away)) / line if line > least else np.nan,
        lines.opening / span if span > least else np.nan,
    )


def _result(
    dataset: xr.Dataset,
    names: list[str],
    rows: Array,
    unit: str,
    about: tuple[float, float, float],
) -> xr.Dataset:
    import xarray as xr

    units = [str(dataset.variables[name].attrs.get("units", "1")) for name in names]
    made = xr.Dataset(
        {
            "slope": ("quantity", rows[0], {"long_name": "slope over the input"}),
            "intercept": ("quantity", rows[1], {"long_name": "value of the line at the point"}),
            "nonlinearity": ("quantity", rows[2], {"units": "1", "long_name": "nonlinearity"}),
            "hysteresis": ("quantity", rows[3], {"units": "1", "long_name": "hysteresis"}),
        },
        {
            "quantity": ("quantity", names),
            "unit": ("quantity", [slope_unit(own, unit) for own in units]),
            "own_unit": ("quantity", units),
        },
        {"about": about[0], "low": about[1], "high": about[2], "input_unit": unit},
    )
    kept = {key: dataset.attrs[key] for key in ("test", "model") if key in dataset.attrs}
    return made.assign_attrs(kept)


def slope_unit(unit: str, over: str) -> str:
    """Return the unit of a slope.

    >>> slope_unit("rad", "N*m"), slope_unit("m", "m"), slope_unit("m", "1")
    ('rad/(N*m)', '1', 'm')
    """
    if unit == over:
        return "1"
    if over in ("", "1"):
        return unit
    return f"{unit}/({over})" if "*" in over or "/" in over else f"{unit}/{over}"
