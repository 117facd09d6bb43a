"""Convert results to plain data and strict JSON."""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Mapping
from typing import Any, ClassVar, cast

import numpy as np

from jounce.core.shown import Shown


class Plain(Shown):
    """Mix-in for results (dataclasses): ``to_dict`` returns their fields as plain data.

    A class lists omitted fields in ``left_out`` and additional properties in ``also``; classes with a different layout
    override ``to_dict`` (see `plain_table`).

    Examples
    --------
    >>> @dataclasses.dataclass
    ... class Drop(Plain):
    ...     left_out = ("times",)
    ...     height: float
    ...     times: tuple[float, ...] = ()
    >>> Drop(0.08).to_dict()
    {'height': 0.08}
    """

    left_out: ClassVar[tuple[str, ...]] = ()
    also: ClassVar[tuple[str, ...]] = ()

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI."""
        fields = (field.name for field in dataclasses.fields(cast("Any", self)))
        names = [*(name for name in fields if name not in self.left_out), *self.also]
        return plain_table({name: getattr(self, name) for name in names})


def plain_table(values: Mapping[str, Any]) -> dict[str, Any]:
    """Convert values to plain data: dicts, lists, text, finite numbers and None, ready for strict JSON.

    Parameters
    ----------
    values : mapping
        Results, arrays and numbers by name; units stay as they are.

    Returns
    -------
    dict
        The same names; NaN and infinities become None.

    Examples
    --------
    >>> plain_table({"rate": np.float64(22e3), "points": np.array([0.0, np.nan]), "pair": (1, True)})
    {'rate': 22000.0, 'points': [0.0, None], 'pair': [1, True]}
    """
    return {str(key): to_plain(item) for key, item in values.items()}


def to_plain(value: Any) -> Any:
    """Convert a result to dicts, lists, text, finite numbers and None (for NaN and infinities)."""
    if isinstance(value, Plain):
        return value.to_dict()
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return {
            field.name: to_plain(getattr(value, field.name)) for field in dataclasses.fields(value)
        }
    if isinstance(value, Mapping):
        return plain_table(value)
    if isinstance(value, np.ndarray):
        return to_plain(value.tolist())
    if isinstance(value, (list, tuple)):
        return [to_plain(item) for item in value]
    if isinstance(value, np.generic):
        return to_plain(value.item())
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    return value if value is None or isinstance(value, (bool, int, str)) else str(value)


def to_json(value: Any, *, indent: int | None = 2) -> str:
    """Write a result as strict JSON text (no NaN)."""
    return json.dumps(to_plain(value), indent=indent, allow_nan=False, ensure_ascii=False)
