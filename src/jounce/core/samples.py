"""Convert numbers and arrays passed by Python users to floats in SI, in the same way for all functions."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from pydantic import BeforeValidator

from jounce.core.errors import DescriptionError, JounceError, RecordingError
from jounce.core.foreign import plain_numbers
from jounce.core.types import Array
from jounce.core.units import conversion_factor, to_si


def as_samples(
    values: object, si: str = "", *, where: str, error: type[JounceError] = RecordingError
) -> Array:
    """Return numbers of any library as an array of floats in ``si``, or in their own unit if ``si`` is empty.

    Bare numbers are taken to be in ``si``. Values with a unit are converted: quantities (Pint, Astropy), or arrays with
    an attribute ``units`` (xarray, netCDF). Durations become seconds, instants seconds since the first one. Text,
    masked or missing samples and imaginary parts raise an ``error`` at ``where``; NaN is left to the caller. Arrays of
    floats are returned without a copy.

    >>> as_samples(np.array([0, 500], "m8[ms]"), "s", where="time").tolist()
    [0.0, 0.5]
    """
    if (
        type(values) is np.ndarray
        and values.dtype == np.float64
        and (values.ndim != 1 or values.flags.c_contiguous)
    ):
        return values
    array, unit = plain_numbers(values, where, error)
    factor = conversion_factor(unit, si, where=where) if unit and si else 1.0
    return (
        (np.ascontiguousarray(array) if array.ndim == 1 else array)
        if factor == 1.0
        else array * factor
    )


def as_values(values: object, si: str, *, where: str) -> Array:
    """Return values in ``si``, shape (n,): from an array as above, or from a list of numbers and texts with units.

    >>> as_values(["-4 cm", 0.0, "40 mm"], "m", where="travel").tolist()
    [-0.04, 0.0, 0.04]
    """
    if isinstance(values, str) or _dimensions(values) == 0:
        return np.array([to_si(values, si, where=where)])
    if (
        isinstance(values, Iterable)
        and getattr(getattr(values, "dtype", None), "kind", "O") in "OUTb"
    ):
        return np.array([to_si(value, si, where=f"{where}[{i}]") for i, value in enumerate(values)])
    array = as_samples(values, si, where=where, error=DescriptionError)
    if array.ndim != 1:
        raise DescriptionError(
            "not a list of values", where=where, found=f"an array of shape {array.shape}"
        )
    return array


def as_list(values: object) -> object:
    """Return an array of any library as a list of numbers, or of texts with its unit; return other objects unchanged.

    >>> as_list(np.array([0, 500], "m8[ms]"))
    ['0.0 s', '0.5 s']
    """
    if not hasattr(values, "__array__") or _dimensions(values) == 0:
        return values
    try:
        array, unit = plain_numbers(values, "", DescriptionError)
    except DescriptionError:  # each value is refused individually later
        return list(values) if isinstance(values, Iterable) else values
    if not unit:
        return array.tolist()
    rows = [[f"{number!r} {unit}" for number in row] for row in np.atleast_2d(array).tolist()]
    return rows if array.ndim > 1 else rows[0]


Listed = BeforeValidator(as_list)
"""Pydantic annotation that makes a field of several numbers also accept arrays and columns."""


def _dimensions(values: object) -> int:
    return int(getattr(values, "ndim", isinstance(values, Iterable)))
