"""Rigs as text of a rig file, with the units that people use."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from jounce.parts.hardpoints import Hardpoints
from jounce.parts.parameters import unit_of
from jounce.parts.rig import Rig

_WIDTH = 120
_ORDER = ["schema", "model", "source", "estimated", "gravity", "side", "guide", "guide_friction", "hardpoints"]
_ORDER += ["wheel", "sprung", "unsprung", "bodies", "strut", "steering", "anti_roll_bar", "bushings", "tyre"]
_SHOWN: dict[str, tuple[str, float]] = {
    "m": ("mm", 1e-3),
    "rad": ("deg", float(np.pi / 180.0)),
    "N/m": ("N/mm", 1e3),
    "N/m^3": ("N/mm^3", 1e9),
}
"""Units shown instead of SI: name and size."""
_DIGITS = {"m": 9, "kg": 9, "kg*m^2": 6}
"""Significant digits by SI unit; more are never needed and show the rounding of conversions."""


def rig_text(rig: Rig, comments: Sequence[str] = ()) -> str:
    """Write a rig as TOML, every value with its unit.

    Parameters
    ----------
    rig : Rig
        What it was made from is written; defaults that nobody gave are not.
    comments : sequence of str
        Paragraphs that stand above it.

    Returns
    -------
    str
        Text of a rig file; what it describes is the rig, to at least six digits of inertias and nine of lengths.

    Examples
    --------
    >>> from jounce.parts import load
    >>> rig_text(load("kart-quarter-car"), ["A kart."]).splitlines()[:2]
    ['# A kart.', 'schema = "jounce.rig/1"']
    """
    table = rig.model_dump(by_alias=True, exclude_none=True, exclude_unset=True)
    table = {"schema": getattr(rig, "schema_", "jounce.rig/1"), "model": getattr(rig, "model", ""), **table}
    keys = [*(key for key in _ORDER if key in table), *(key for key in table if key not in _ORDER)]
    head = [f"# {line}" for comment in comments for line in textwrap.wrap(comment, _WIDTH - 2)]
    plain = [f"{key} = {_value(rig, key, table[key])}" for key in keys if not isinstance(table[key], Mapping)]
    body = [line for key in keys if isinstance(table[key], Mapping) for line in _section(rig, key, table[key])]
    return "\n".join([*head, *plain, *body, ""])


def _section(rig: Rig, path: str, table: Mapping[str, Any]) -> list[str]:
    """Lines of a table: small tables of plain values in one line, others as sections of their own."""
    keys = sorted(table, key=lambda name: path == "hardpoints" and name in Hardpoints.model_fields)
    own, below = [], []
    for key in keys:
        value = table[key]
        if isinstance(value, Mapping) and not all(isinstance(item, (str, bool, float)) for item in value.values()):
            below += _section(rig, f"{path}.{key}", value)
        else:
            own.append(f"{key} = {_value(rig, f'{path}.{key}', value)}")
    return [*(["", f"[{path}]", *own] if own else []), *below]


def _value(rig: Rig, path: str, value: Any) -> str:
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{key} = {_value(rig, f'{path}.{key}', item)}" for key, item in value.items()) + "}"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, (list, tuple)):
        return _list([_value(rig, f"{path}[{i}]", item) for i, item in enumerate(value)])
    si = unit_of(rig, path)
    if si == "1":
        return repr(float(value))
    unit, size = _SHOWN.get(si, (si, 1.0))
    text = f"{float(value) / size:.{_DIGITS.get(si, 12)}g}"
    return f'"{"0" if text == "-0" else text} {unit}"'


def _list(items: list[str]) -> str:
    """A list in one line, or in several where it would be too long."""
    line = "[" + ", ".join(items) + "]"
    if len(line) < _WIDTH - 20 and "\n" not in line:
        return line
    if any(item.startswith("[") for item in items):
        return "[\n" + "".join(f"  {item},\n" for item in items) + "]"
    rows = textwrap.wrap(", ".join(item.replace(" ", "\0") for item in items), _WIDTH - 4)
    return "[\n" + "".join(f"  {row.replace(chr(0), ' ')}\n" for row in rows) + "]"
