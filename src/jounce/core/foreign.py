"""Convert numbers and arrays of other libraries to floats and their unit.

Libraries are recognised by attributes of their objects (``__array__``, ``magnitude`` and ``units``, ``attrs``) and are
not imported.
"""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime, timedelta
from decimal import Decimal
from numbers import Real
from typing import Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import JounceError, show_value
from jounce.core.phrases import Phrase
from jounce.core.types import Array


def plain_numbers(values: object, where: str, error: type[JounceError]) -> tuple[Array, str]:
    """Convert values to floats and their unit; the unit is empty if they have none."""
    try:
        array, unit = _numbers(values)
        if array.dtype.kind not in "mM":
            return np.asarray(array, dtype=np.float64), unit
        _refuse(np.isnat(array), "is missing")
        if array.dtype.kind == "M":
            if not array.ndim:
                raise _NoNumberError("a single point in time is not a number")
            array = array - array[:1]
        if np.datetime_data(array.dtype)[0] in ("generic", "Y", "M"):
            raise _NoNumberError("durations in months or years, or without a unit")
        return np.asarray(array / np.timedelta64(1, "s"), dtype=np.float64), "s"
    except _NoNumberError as fault:
        raise error(str(fault), where=where, allowed="real numbers") from None
    except Exception as fault:  # noqa: BLE001 - of any library, e.g. for a tensor in GPU memory
        text = " ".join(str(fault).split())
        raise error(
            f"not an array of numbers ({text})", where=where, found=type(values).__name__
        ) from None


class _NoNumberError(Exception):
    """A value is not a number; the message is the reason."""


def _numbers(values: Any) -> tuple[NDArray[Any], str]:
    """Return numbers, durations or instants as a plain array, and their unit."""
    values, unit = _bare(values)
    if hasattr(values, "__dask_graph__"):
        values = values.compute()  # its own conversion loses masks
    if isinstance(values, Sequence) and not isinstance(values, str | bytes):
        array, of_items = _stack(list(values))
        return array, unit or of_items
    array = np.asanyarray(values)
    _refuse(getattr(array, "mask", False), "is masked")
    array = np.asarray(array)
    kind = array.dtype.kind
    if kind == "O":
        array, of_items = _stack(list(array)) if array.ndim else _scalar(array.item())
        return array, unit or of_items
    if kind == "c":
        _refuse(array.imag != 0.0, "has an imaginary part")
        return array.real, unit
    if kind not in "biufmM" and (
        kind != "V" or array.dtype.type is np.void
    ):  # bfloat16 has the kind "V"
        raise _NoNumberError(
            "text, not numbers"
            if kind in "SUT"
            else Phrase("{dtype} is not a numeric type", dtype=array.dtype)
        )
    return array, unit


def _bare(values: Any) -> tuple[Any, str]:
    """Separate values from their unit, which is ``"1"`` for a plain number and empty if there is none."""
    if hasattr(values, "magnitude") and hasattr(values, "units"):  # Pint
        return values.magnitude, _unit(format(values.units, "D"))
    if isinstance(values, np.ndarray):  # Astropy, unyt
        unit = getattr(values, "unit", getattr(values, "units", None))
        _refuse(getattr(values, "mask", False), "is masked")
        return (values, "") if unit is None else (values.view(np.ndarray), _unit(str(unit)))
    if hasattr(values, "data_vars"):
        raise _NoNumberError(
            "a whole Dataset; give the values of one channel, e.g. run['sprung.az']"
        )
    attributes: Any = getattr(values, "attrs", None)
    unit = attributes.get("units") if hasattr(attributes, "get") else None
    if unit is None:
        unit = getattr(values, "units", getattr(getattr(values, "dtype", None), "units", None))
    unit = unit.decode() if isinstance(unit, bytes) else unit if isinstance(unit, str) else ""
    if type(values).__module__.startswith("xarray."):  # its own conversion loses masks and units
        values, own = _bare(values.variable.data if hasattr(values, "variable") else values.data)
        return values, own or unit
    return values, unit


def _unit(text: str) -> str:
    return "1" if text in ("", "dimensionless") else text


def _stack(items: list[Any]) -> tuple[NDArray[Any], str]:
    """Join items to one array; they must have the same type and unit."""
    kinds_of_items = {type(item) for item in items}
    if np.timedelta64 not in kinds_of_items and all(
        issubclass(kind, _REAL) for kind in kinds_of_items
    ):
        return np.array(items, dtype=np.float64), ""
    parts = [_numbers(item) for item in items]
    if len({part.shape for part, _ in parts}) > 1:
        raise _NoNumberError("rows of different lengths")
    kinds = {part.dtype.kind if part.dtype.kind in "mM" else "f" for part, _ in parts}
    units = {unit for _, unit in parts}
    if len(kinds) > 1 or len(units) > 1:
        raise _NoNumberError(
            Phrase(
                "values of several quantities or units ({units})",
                units=", ".join(sorted(units | kinds)),
            )
        )
    return np.array([part for part, _ in parts]), units.pop()


def _scalar(value: Any) -> tuple[NDArray[Any], str]:
    """Convert a single object for which NumPy has no type."""
    if isinstance(value, Real | Decimal):
        return np.array(float(value)), ""
    for convert in ("to_timedelta64", "to_datetime64"):  # pandas
        if hasattr(value, convert):
            return np.array(getattr(value, convert)()), _ZONED if getattr(
                value, "tzinfo", None
            ) else ""
    if hasattr(value, "as_py"):  # Arrow
        return _numbers(value.as_py())
    if isinstance(value, timedelta):
        return np.array(value, "m8[us]"), ""
    if isinstance(value, datetime):
        if value.tzinfo is not None:
            return np.array(value.astimezone(UTC).replace(tzinfo=None), "M8[us]"), _ZONED
        return np.array(value, "M8[us]"), ""
    raise _NoNumberError(Phrase("{value} is not a number", value=show_value(value)))


_REAL = (float, int, np.floating, np.integer)  # NumPy's durations are integers, too
_ZONED = "instants with a time zone"


def _refuse(wrong: NDArray[np.bool_] | bool, what: str) -> None:
    if np.any(wrong):
        at = f"sample {int(np.argmax(wrong)) + 1} " if np.ndim(wrong) else "the number "
        raise _NoNumberError(at + what)
