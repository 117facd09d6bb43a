"""Rig tables as text of a rig file, with the units that people use."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

_WIDTH = 120
_UNITS = {
    "length": ("mm", 1e-3),
    "mass": ("kg", 1.0),
    "inertia": ("kg*m^2", 1.0),
    "rate": ("N/mm", 1e3),
    "force": ("N", 1.0),
    "velocity": ("m/s", 1.0),
    "angle": ("deg", float(np.pi / 180.0)),
    "progression": ("N/mm^3", 1e9),
    "damping": ("N*s/m", 1.0),
}
_DIGITS = {"inertia": 6, "length": 9, "mass": 9}
_KINDS = {
    "radius": "length",
    "undeformed_radius": "length",
    "centre_of_mass": "length",
    "free_length": "length",
    "deflection": "length",
    "length": "length",
    "gap": "length",
    "rack_travel": "length",
    "mass": "mass",
    "rate": "rate",
    "stiffness": "rate",
    "preload": "force",
    "force": "force",
    "velocity": "velocity",
    "camber": "angle",
    "toe": "angle",
    "progression": "progression",
    "coefficient": "damping",
    "damping_coefficient": "damping",
    **dict.fromkeys(("xx", "yy", "zz", "xy", "xz", "yz"), "inertia"),
}
"""Kind of the value under each key of the tables that are written; keys of hardpoints are lengths."""


def rig_text(table: Mapping[str, Any], comments: Sequence[str] = ()) -> str:
    """Write a rig's table (SI) as TOML, values with units; ``comments`` stand above it, each a paragraph."""
    lines = [line for comment in comments for line in textwrap.wrap(comment, _WIDTH - 2)]
    head = [f"# {line}" for line in lines]
    plain = [f"{key} = {_value(key, value)}" for key, value in table.items() if not isinstance(value, Mapping)]
    body = [line for key, value in table.items() if isinstance(value, Mapping) for line in _section(key, value)]
    return "\n".join([*head, *plain, *body, ""])


def _section(name: str, table: Mapping[str, Any]) -> list[str]:
    """Lines of a table: small tables of plain values in one line, others as sections of their own."""
    own, below = [], []
    for key, value in table.items():
        if isinstance(value, Mapping) and not _is_small(value):
            below += _section(f"{name}.{key}", value)
        else:
            own.append(f"{key} = {_value('length' if name == 'hardpoints' else key, value)}")
    return [*(["", f"[{name}]", *own] if own else []), *below]


def _is_small(table: Mapping[str, Any]) -> bool:
    return all(isinstance(value, (str, bool, float, int)) for value in table.values())


def _value(key: str, value: Any) -> str:
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{name} = {_value(name, item)}" for name, item in value.items()) + "}"
    if isinstance(value, (str, bool)):
        return str(value).lower() if isinstance(value, bool) else json.dumps(value, ensure_ascii=False)
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        return _list([_value(key, item) for item in value])
    kind = _KINDS.get(key)
    if kind is None:
        return _number(float(value))
    unit, size = _UNITS[kind]
    digits = _DIGITS.get(kind, 12)
    return f'"{_number(float(value) / size, digits)} {unit}"'


def _list(items: list[str]) -> str:
    """A list in one line, or in several where it would be too long."""
    line = "[" + ", ".join(items) + "]"
    if len(line) < _WIDTH - 20 and "\n" not in line:
        return line
    if any(item.startswith("[") for item in items):
        return "[\n" + "".join(f"  {item},\n" for item in items) + "]"
    rows = textwrap.wrap(", ".join(item.replace(" ", "\0") for item in items), _WIDTH - 4)
    return "[\n" + "".join(f"  {row.replace(chr(0), ' ')}\n" for row in rows) + "]"


def _number(value: float, digits: int = 12) -> str:
    """Write a number in so many significant digits that the rounding of unit conversions is hidden."""
    text = f"{value:.{digits}g}"
    return "0" if text == "-0" else text
