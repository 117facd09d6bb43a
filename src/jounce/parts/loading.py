"""Rig and vehicle files: read, write back changed values, and the shipped library."""

from __future__ import annotations

import re
from functools import reduce
from pathlib import Path
from typing import Any

import tomlkit

from jounce.core.description import check_schema, dotted, line_of, read_toml
from jounce.core.errors import DescriptionError, nearest, unknown
from jounce.core.files import chosen_file, shipped_files
from jounce.parts.corner import Corner
from jounce.parts.parameters import split_path, unit_of, unknown_path
from jounce.parts.rigs import RIGS, Rig
from jounce.parts.vehicles import VEHICLES
from jounce.parts.writing import rig_text

SCHEMAS: dict[str, dict[str, type[Rig]]] = {"jounce.rig/1": RIGS, "jounce.vehicle/1": {**VEHICLES}}
"""Models by their name in a file, for each kind of file."""
CORNERS = tuple(name for name, rig in RIGS.items() if issubclass(rig, Corner))
"""Models of rigs that may be the corner of a vehicle."""


def library() -> dict[str, Path]:
    """Give the shipped rigs and vehicles: name to file."""
    return shipped_files("jounce.parts", "library")


def rig_path(name: str | Path) -> Path:
    """Find the file of a rig: a path, or the name of a shipped one."""
    return chosen_file(name, library(), "rig")


def load(name: str | Path) -> Rig:
    """Load a rig or a vehicle from a TOML file or, by name, from the shipped library.

    Parameters
    ----------
    name : str or Path
        Path to a file, or the name of a shipped rig or vehicle (see ``jounce library``).

    Returns
    -------
    Rig
        The frozen description; a vehicle is one, too.

    Raises
    ------
    DescriptionError
        With file, line, path, found value, what is allowed and the nearest match.

    Examples
    --------
    >>> load("kart-quarter-car").sprung.mass
    16.0
    """
    path = rig_path(name)
    table, text = read_toml(path)
    return rig_from_table(table, where=str(path), text=text)


def rig_from_table(table: dict[str, Any], *, where: str = "", text: str = "") -> Rig:
    """Build the rig or vehicle that a TOML table describes; ``schema`` and ``model`` select its class."""
    models = SCHEMAS[check_schema(table, tuple(SCHEMAS), where)]
    model = table.get("model")
    if not isinstance(model, str):
        raise DescriptionError("the key 'model' is missing", where=where, allowed=", ".join(models))
    if model not in models:
        other = next((schema for schema, names in SCHEMAS.items() if model in names), None)
        if other is not None:
            raise DescriptionError(
                f"the model {model!r} is of another schema",
                where=where,
                found=str(table["schema"]),
                allowed=f'schema = "{other}"',
            )
        raise unknown(model, models, what="model", where=where)
    return models[model].from_table(_with_corners(table, where, text), where=where, text=text)


def _with_corners(table: dict[str, Any], where: str, text: str) -> dict[str, Any]:
    """Give a vehicle's table with the rigs in place of the names that its axles have as ``corner``."""
    found = dict(table)
    for axle in ("front", "rear"):
        entry = table.get(axle)
        if isinstance(entry, dict) and not isinstance(entry.get("corner", {}), dict):
            line = line_of(text, (axle, "corner")) if text else None
            place = ": ".join(filter(None, (f"{where}, line {line}" if line else where, f"{axle}.corner")))
            found[axle] = {**entry, "corner": _corner(entry["corner"], Path(where).parent if where else None, place)}
    return found


def _corner(name: Any, folder: Path | None, place: str) -> dict[str, Any]:
    """Table of the corner that a vehicle names: a file in the vehicle's folder, any file, or a shipped rig."""
    if not isinstance(name, str):
        raise DescriptionError("not a corner", where=place, found=repr(name), allowed=_shipped_corners())
    file = folder / name if folder is not None else Path(name)
    if not file.is_file():
        file = library()[name] if name in library() else Path(name)
    if not file.is_file():
        raise DescriptionError(
            "no such file and no shipped corner",
            where=place,
            found=name,
            allowed=_shipped_corners(),
            hint=nearest(name, library()),
        )
    table, text = read_toml(file)
    if table.get("model") in {model for models in SCHEMAS.values() for model in models} - set(CORNERS):
        found = f"{name}, model {table['model']!r}"
        raise DescriptionError("not a 3-D corner", where=place, found=found, allowed=", ".join(CORNERS))
    rig_from_table(table, where=str(file), text=text)  # its errors are those of its own file
    return table


def _shipped_corners() -> str:
    """What may be the corner of a vehicle."""
    corners = [shipped for shipped, file in library().items() if read_toml(file)[0].get("model") in CORNERS]
    return f"a table, a .toml file from this file's folder, or one of {', '.join(corners)}"


def changed_text(text: str, rig: Rig, values: dict[str, float]) -> str:
    """Write new values (SI, by path) into the text of a rig file; comments and everything else stay as they were."""
    document = tomlkit.parse(text)
    known = rig.parameters()
    for path, value in values.items():
        if path not in known:
            raise unknown_path(path, known)
        here: Any = document
        *parents, last = split_path(path)
        if parents[:2] == ["strut", "bump_stop"] and "bump_stop" in document:
            del parents[0]  # the file gives the strut's stop at its top level
        for i, part in enumerate(parents):
            if isinstance(part, str) and part not in here:
                here[part] = _written(rig, parents[: i + 1])
            elif isinstance(here[part], str):  # a corner by its name: what it is stands in its place
                here[part] = tomlkit.parse(rig_text(reduce(getattr, map(str, parents[: i + 1]), rig)))
            here = here[part]
        here[last] = _quantity(value, unit_of(rig, path))
    return tomlkit.dumps(document)


def _written(rig: Rig, parents: list[str | int]) -> Any:
    """What stands for a part that the file leaves to its default: an empty table, or the whole list of numbers."""
    name = dotted(tuple(parents))
    known = rig.parameters()
    values = [path for path in known if re.fullmatch(rf"{re.escape(name)}\[\d+\]", path)]
    return [_quantity(known[path], unit_of(rig, path)) for path in values] or tomlkit.inline_table()


def _quantity(value: float, unit: str) -> float | str:
    return float(value) if unit == "1" else f"{float(value)!r} {unit}"
