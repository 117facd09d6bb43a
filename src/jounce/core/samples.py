"""Numbers and arrays of Python users as floats in SI: one border for all functions that take them."""

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
    """Return numbers of any library as an array of floats in ``si``; without it, in the unit that they have.

    Bare numbers are in ``si``. A unit that the values carry is converted: that of a quantity (Pint, Astropy), or the
    attribute ``units`` (xarray, netCDF). Durations become seconds, instants seconds since the first one. An ``error``
    at the place ``where`` refuses text, masked or missing samples and imaginary parts; NaN is for the caller to judge.
    Arrays of floats are given back without a copy.

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
    """Return values in ``si``, shape (n,) for n of them: an array as above, or numbers and texts with units in a list.

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
    """Return an array or column of any library as a list of numbers, or texts with its unit; other objects unchanged.

    >>> as_list(np.array([0, 500], "m8[ms]"))
    ['0.0 s', '0.5 s']
    """
    if not hasattr(values, "__array__") or _dimensions(values) == 0:
        return values
    try:
        array, unit = plain_numbers(values, "", DescriptionError)
    except DescriptionError:  # each is refused at its place
        return list(values) if isinstance(values, Iterable) else values
    if not unit:
        return array.tolist()
    rows = [[f"{number!r} {unit}" for number in row] for row in np.atleast_2d(array).tolist()]
    return rows if array.ndim > 1 else rows[0]


Listed = BeforeValidator(as_list)
"""Pydantic annotation of a field of several numbers, which then also accepts arrays and columns."""


def _dimensions(values: object) -> int:
    return int(getattr(values, "ndim", isinstance(values, Iterable)))
