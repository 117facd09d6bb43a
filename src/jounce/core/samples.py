"""What users of Python call numbers and arrays, as floats in SI: one border for all functions that take some.

Libraries are known by what their objects offer (``__array__``, ``magnitude`` and ``units``, ``attrs``) and not
imported.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from datetime import UTC, datetime, timedelta
from decimal import Decimal
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pydantic import BeforeValidator

from jounce.core.errors import DescriptionError, JounceError, RecordingError, shown
from jounce.core.types import Array
from jounce.core.units import conversion_factor, to_si


def as_samples(values: object, si: str = "", *, where: str, error: type[JounceError] = RecordingError) -> Array:
    """Give numbers of any library as an array of floats in ``si``; without it, in the unit that they have.

    Bare numbers are in ``si``. A unit that the values carry is converted: that of a quantity (Pint, Astropy), or the
    attribute ``units`` (xarray, netCDF). Durations become seconds, instants seconds since the first one. An ``error``
    at the place ``where`` refuses text, masked or missing samples and imaginary parts; NaN is for the caller to judge.
    Arrays of floats are given back without a copy.

    >>> as_samples(np.array([0, 500], "m8[ms]"), "s", where="time").tolist()
    [0.0, 0.5]
    """
    if type(values) is np.ndarray and values.dtype == np.float64 and (values.ndim != 1 or values.flags.c_contiguous):
        return values
    array, unit = _plain(values, where, error)
    factor = conversion_factor(unit, si, where=where) if unit and si else 1.0
    return (np.ascontiguousarray(array) if array.ndim == 1 else array) if factor == 1.0 else array * factor


def as_number(value: object, si: str, *, where: str = "") -> float:
    """Give a number of any library, or a text with its unit, as a float in ``si``; NaN is for the caller to judge.

    A DescriptionError at the place ``where`` refuses all else.

    >>> as_number(np.timedelta64(500, "ms"), "s"), as_number("500 ms", "s"), as_number(0.5, "s")
    (0.5, 0.5, 0.5)
    """
    if type(value) is float:
        return value
    if isinstance(value, str):
        return to_si(value, si, where=where)
    found = "None" if value is None else value
    refusal = DescriptionError("not a physical value", where=where, found=found, allowed=f"'<number> <unit of {si}>'")
    if isinstance(value, bool) or getattr(value, "dtype", None) == np.bool_:
        raise refusal
    try:
        array, unit = _plain(value, where, DescriptionError)
    except DescriptionError:
        raise refusal from None
    if array.ndim:
        raise refusal
    return float(array) * (conversion_factor(unit, si, where=where) if unit else 1.0)


def as_values(values: object, si: str, *, where: str) -> Array:
    """Give values in ``si``, shape (n,) for n of them: an array as above, or numbers and texts with units in a list.

    >>> as_values(["-4 cm", 0.0, "40 mm"], "m", where="travel").tolist()
    [-0.04, 0.0, 0.04]
    """
    if isinstance(values, str) or _dimensions(values) == 0:
        return np.array([to_si(values, si, where=where)])
    if isinstance(values, Iterable) and getattr(getattr(values, "dtype", None), "kind", "O") in "OUTb":
        return np.array([to_si(value, si, where=f"{where}[{i}]") for i, value in enumerate(values)])
    array = as_samples(values, si, where=where, error=DescriptionError)
    if array.ndim != 1:
        raise DescriptionError("not a list of values", where=where, found=f"an array of shape {array.shape}")
    return array


def listed(values: object) -> object:
    """Give an array or a column of any library as a list of numbers, or texts with its unit; other things as they are.

    >>> listed(np.array([0, 500], "m8[ms]"))
    ['0.0 s', '0.5 s']
    """
    if not hasattr(values, "__array__") or _dimensions(values) == 0:
        return values
    try:
        array, unit = _plain(values, "", DescriptionError)
    except DescriptionError:  # each is refused at its place
        return list(values) if isinstance(values, Iterable) else values
    if not unit:
        return array.tolist()
    rows = [[f"{number!r} {unit}" for number in row] for row in np.atleast_2d(array).tolist()]
    return rows if array.ndim > 1 else rows[0]


Listed = BeforeValidator(listed)
"""Pydantic annotation of a field of several numbers, which then takes arrays and columns, too."""


def _dimensions(values: object) -> int:
    return int(getattr(values, "ndim", isinstance(values, Iterable)))


def _plain(values: object, where: str, error: type[JounceError]) -> tuple[Array, str]:
    """Floats, and the unit that they carry; empty for none."""
    try:
        array, unit = _numbers(values)
        if array.dtype.kind not in "mM":
            return np.asarray(array, dtype=np.float64), unit
        _refuse(np.isnat(array), "is missing")
        if array.dtype.kind == "M":
            if not array.ndim:
                raise _NoNumberError("an instant is no number")
            array = array - array[:1]
        if np.datetime_data(array.dtype)[0] in ("generic", "Y", "M"):
            raise _NoNumberError("durations in months, years or no unit")
        return np.asarray(array / np.timedelta64(1, "s"), dtype=np.float64), "s"
    except _NoNumberError as fault:
        raise error(str(fault), where=where, allowed="real numbers") from None
    except Exception as fault:  # noqa: BLE001 - of any library, e.g. of a tensor that lies on a graphics card
        text = " ".join(str(fault).split())
        raise error(f"not an array of numbers ({text})", where=where, found=type(values).__name__) from None


class _NoNumberError(Exception):
    """What is no number, in words."""


def _numbers(values: Any) -> tuple[NDArray[Any], str]:
    """Numbers, durations or instants as a plain array, and the unit that they carry."""
    values, unit = _bare(values)
    if hasattr(values, "__dask_graph__"):
        values = values.compute()  # its own conversion loses masks
    if isinstance(values, Sequence) and not isinstance(values, str | bytes):
        array, of_items = _stacked(list(values))
        return array, unit or of_items
    array = np.asanyarray(values)
    _refuse(getattr(array, "mask", False), "is masked")
    array = np.asarray(array)
    kind = array.dtype.kind
    if kind == "O":
        array, of_items = _stacked(list(array)) if array.ndim else _scalar(array.item())
        return array, unit or of_items
    if kind == "c":
        _refuse(array.imag != 0.0, "has an imaginary part")
        return array.real, unit
    if kind not in "biufmM" and (kind != "V" or array.dtype.type is np.void):  # bfloat16 is a kind of "V"
        raise _NoNumberError("text, not numbers" if kind in "SUT" else f"{array.dtype} is no kind of number")
    return array, unit


def _bare(values: Any) -> tuple[Any, str]:
    """Values without the unit that they carry, and that unit: ``"1"`` for a plain number, empty where there is none."""
    if hasattr(values, "magnitude") and hasattr(values, "units"):  # Pint
        return values.magnitude, _unit(format(values.units, "D"))
    if isinstance(values, np.ndarray):  # Astropy, unyt
        unit = getattr(values, "unit", getattr(values, "units", None))
        _refuse(getattr(values, "mask", False), "is masked")
        return (values, "") if unit is None else (values.view(np.ndarray), _unit(str(unit)))
    if hasattr(values, "data_vars"):
        raise _NoNumberError("a whole Dataset; give the values of one channel, e.g. run['sprung.az']")
    attributes: Any = getattr(values, "attrs", None)
    unit = attributes.get("units") if hasattr(attributes, "get") else None
    if unit is None:
        unit = getattr(values, "units", getattr(getattr(values, "dtype", None), "units", None))
    unit = unit.decode() if isinstance(unit, bytes) else unit if isinstance(unit, str) else ""
    if type(values).__module__.startswith("xarray."):  # its own conversion loses masks and units, too
        values, own = _bare(values.variable.data if hasattr(values, "variable") else values.data)
        return values, own or unit
    return values, unit


def _unit(text: str) -> str:
    return "1" if text in ("", "dimensionless") else text


def _stacked(items: list[Any]) -> tuple[NDArray[Any], str]:
    """Items as one array; they are of one kind and carry one unit."""
    kinds_of_items = {type(item) for item in items}
    if np.timedelta64 not in kinds_of_items and all(issubclass(kind, _REAL) for kind in kinds_of_items):
        return np.array(items, dtype=np.float64), ""
    parts = [_numbers(item) for item in items]
    if len({part.shape for part, _ in parts}) > 1:
        raise _NoNumberError("rows of different lengths")
    kinds = {part.dtype.kind if part.dtype.kind in "mM" else "f" for part, _ in parts}
    units = {unit for _, unit in parts}
    if len(kinds) > 1 or len(units) > 1:
        raise _NoNumberError(f"numbers of several kinds or units ({', '.join(sorted(units | kinds))})")
    return np.array([part for part, _ in parts]), units.pop()


def _scalar(value: Any) -> tuple[NDArray[Any], str]:
    """A single object that NumPy has no type for."""
    if isinstance(value, Real | Decimal):
        return np.array(float(value)), ""
    for convert in ("to_timedelta64", "to_datetime64"):  # pandas
        if hasattr(value, convert):
            return np.array(getattr(value, convert)()), _ZONED if getattr(value, "tzinfo", None) else ""
    if hasattr(value, "as_py"):  # Arrow
        return _numbers(value.as_py())
    if isinstance(value, timedelta):
        return np.array(value, "m8[us]"), ""
    if isinstance(value, datetime):
        if value.tzinfo is not None:
            return np.array(value.astimezone(UTC).replace(tzinfo=None), "M8[us]"), _ZONED
        return np.array(value, "M8[us]"), ""
    raise _NoNumberError(f"{shown(value)} is no number")


_REAL = (float, int, np.floating, np.integer)  # NumPy's durations count as integers, too
_ZONED = "instants with a time zone"


def _refuse(wrong: NDArray[np.bool_] | bool, what: str) -> None:
    if np.any(wrong):
        at = f"sample {int(np.argmax(wrong)) + 1} " if np.ndim(wrong) else "the number "
        raise _NoNumberError(at + what)
