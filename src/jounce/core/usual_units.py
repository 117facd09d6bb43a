"""The unit that a number without one is meant in, from the other values of its description."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from jounce.core.errors import DescriptionError
from jounce.core.units import bare_si, is_unit_of

_WITH_UNIT = re.compile(r"\s*[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\s*([^\d\s].*?)\s*")
_LONGEST = 10.0
"""Length in m that no part of a vehicle exceeds: a larger bare number is in millimetres."""


def usual_unit(values: Mapping[str, Any], keys: Sequence[str | int], number: float, si: str) -> str:
    """Return the unit of a bare number that replaces the value at some keys of a description; empty for SI.

    It is the unit of the value that is replaced, else of its neighbours, else the most frequent one in the description
    that converts to ``si``. A description that writes bare numbers there means SI, unless the number is implausible.

    Parameters
    ----------
    values : mapping
        The description as plain data, values as they are written.
    keys : sequence of str or int
        Place of the value.
    number : float
        The bare number.
    si : str
        SI unit of the value.

    Returns
    -------
    str
        A unit such as ``"mm"``; empty if the number is in ``si``.

    Examples
    --------
    >>> values = {"hardpoints": {"a": ["100 mm", "10 mm", "0 mm"], "b": [0.1, 0.2, 0.3]}, "mass": "3 kg"}
    >>> [usual_unit(values, ["hardpoints", name, 0], 150.0, "m") for name in "ab"]
    ['mm', 'mm']
    >>> usual_unit(values, ["hardpoints", "b", 0], 0.15, "m")
    ''
    """
    inside: Any = values
    around: list[Any] = [values]
    for key in keys:
        try:
            inside = inside[key]
        except (KeyError, IndexError, TypeError):
            inside = None
            break
        around.append(inside)
    own = _unit_in(inside, si)
    if own:
        return own
    if isinstance(inside, int | float) and not isinstance(inside, bool):
        return _if_implausible(number, si)
    for part in reversed(around):
        units = Counter(unit for value in _scalars(part) if (unit := _unit_in(value, si)))
        if units:
            return units.most_common(1)[0][0]
    return _if_implausible(number, si)


def _unit_in(value: Any, si: str) -> str:
    match = _WITH_UNIT.fullmatch(value) if isinstance(value, str) else None
    return match[1] if match is not None and is_unit_of(match[1], si) else ""


def _scalars(part: Any) -> Iterator[Any]:
    if isinstance(part, Mapping):
        for item in part.values():
            yield from _scalars(item)
    elif isinstance(part, list):
        for item in part:
            yield from _scalars(item)
    else:
        yield part


def _if_implausible(number: float, si: str) -> str:
    if si == "m":
        return "mm" if abs(number) >= _LONGEST else ""
    try:
        bare_si(number, si, where="")
    except DescriptionError:
        return {"rad": "deg", "N/m": "N/mm", "m/s": "km/h"}.get(si, "")
    return ""
