"""Reading and writing of rig and vehicle files, with engineering units, and the shipped library."""

from __future__ import annotations

import math
import os
import re
import textwrap
import tomllib
from collections.abc import Mapping, Sequence
from functools import reduce
from pathlib import Path
from typing import Any

import numpy as np
import tomlkit

from jounce.core.description import check_schema, join_path, line_of, read_toml
from jounce.core.errors import DescriptionError, at_line, below, nearest, unknown
from jounce.core.files import find_file, shipped_files
from jounce.core.phrases import Phrase
from jounce.core.text import in_one_line, quote
from jounce.core.units import conversion_factor, to_si
from jounce.core.writing import check_writable, write_atomically
from jounce.parts.axles import DependentAxle
from jounce.parts.corners import Corner, Hardpoints
from jounce.parts.rig import (
    MODELS,
    Rig,
    check_rig,
    parameters_of,
    split_path,
    unit_of,
    unknown_path,
)

_WIDTH = 120  # maximum line length of a rig file
_NUMBER_AND_UNIT = re.compile(r"\s*[-+]?[\d.]+(?:[eE][-+]?\d+)?\s*([^\d\s].*?)\s*$")
_ORDER = [
    "schema",
    "model",
    "source",
    "estimated",
    "gravity",
    "side",
    "guide",
    "guide_friction",
    "hardpoints",
]
_ORDER += ["wheel", "sprung", "unsprung", "bodies", "strut", "torsion_bar", "third_spring"]
_ORDER += ["steering", "anti_roll_bar", "bushings", "subframe", "bearing", "links", "tyre"]
_SHOWN: dict[str, tuple[str, float]] = {
    "m": ("mm", 1e-3),
    "rad": ("deg", float(np.pi / 180.0)),
    "N/m": ("N/mm", 1e3),
    "N/m^3": ("N/mm^3", 1e9),
}
"""Units written instead of SI: name and factor to SI."""
_DIGITS = {"m": 9, "kg": 9, "kg*m^2": 6}
"""Significant digits by SI unit; more would only show the rounding of conversions."""


def rig_text(rig: Rig, comments: Sequence[str] = ()) -> str:
    """Format a rig as TOML, every value with its unit, below ``comments`` (paragraphs).

    Omits defaults that were not set explicitly. Inertias have at least six significant digits, lengths nine.

    >>> from jounce.parts import load
    >>> rig_text(load("kart-quarter-car"), ["A kart."]).splitlines()[:2]
    ['# A kart.', 'schema = "jounce.rig/1"']
    """
    table = rig.model_dump(by_alias=True, exclude_none=True, exclude_unset=True)
    table = {
        "schema": getattr(rig, "schema_", "jounce.rig/1"),
        "model": getattr(rig, "model", ""),
        **table,
    }
    keys = [*(key for key in _ORDER if key in table), *(key for key in table if key not in _ORDER)]
    head = [
        f"# {line}"
        for comment in comments
        for line in textwrap.wrap(in_one_line(comment), _WIDTH - 2)
    ]
    plain = [
        f"{key} = {_value(rig, key, table[key])}"
        for key in keys
        if not isinstance(table[key], Mapping)
    ]
    body = [
        line
        for key in keys
        if isinstance(table[key], Mapping)
        for line in _section(rig, key, table[key])
    ]
    return "\n".join([*head, *plain, *body, ""])


def _section(rig: Rig, path: str, table: Mapping[str, Any], header: str = "") -> list[str]:
    """Format a table as lines: small tables of plain values inline, others as separate sections.

    ``header`` is that of a table in a list, whose entries have no number there.
    """
    keys = sorted(table, key=lambda name: path == "hardpoints" and name in Hardpoints.model_fields)
    own, below = [], []
    title = header.strip("[]") or path
    for key in keys:
        value = table[key]
        if isinstance(value, Mapping) and not all(
            isinstance(item, (str, bool, float)) for item in value.values()
        ):
            inner = f"[{title}.{key}]" if header else ""
            below += _section(rig, f"{path}.{key}", value, inner)
        elif _holds_tables(value):
            for i, item in enumerate(value):
                below += _section(rig, f"{path}.{key}[{i}]", item, f"[[{title}.{key}]]")
        else:
            own.append(f"{key} = {_value(rig, f'{path}.{key}', value)}")
    return [*(["", header or f"[{path}]", *own] if own else []), *below]


def _holds_tables(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and bool(value) and isinstance(value[0], Mapping)


def _value(rig: Rig, path: str, value: Any) -> str:
    if isinstance(value, Mapping):
        return (
            "{"
            + ", ".join(
                f"{key} = {_value(rig, f'{path}.{key}', item)}" for key, item in value.items()
            )
            + "}"
        )
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return quote(value)
    if isinstance(value, (list, tuple)):
        return _list([_value(rig, f"{path}[{i}]", item) for i, item in enumerate(value)])
    si = unit_of(rig, path)
    if si == "1":
        return repr(float(value))
    unit, size = _SHOWN.get(si, (si, 1.0))
    text = f"{float(value) / size:.{_DIGITS.get(si, 12)}g}"
    return f'"{"0" if text == "-0" else text} {unit}"'


def _list(items: list[str]) -> str:
    """Format a list on one line, or on several if it would be too long."""
    line = "[" + ", ".join(items) + "]"
    if len(line) < _WIDTH - 20 and "\n" not in line:
        return line
    if any(item.startswith("[") for item in items):
        return "[\n" + "".join(f"  {item},\n" for item in items) + "]"
    rows = textwrap.wrap(", ".join(item.replace(" ", "\0") for item in items), _WIDTH - 4)
    return "[\n" + "".join(f"  {row.replace(chr(0), ' ')}\n" for row in rows) + "]"


RIGS, VEHICLES = MODELS["jounce.rig/1"], MODELS["jounce.vehicle/1"]


def library() -> dict[str, Path]:
    """Return the shipped rigs and vehicles: name to path."""
    return shipped_files("jounce.parts", "library")


def rig_path(name: str | Path) -> Path:
    """Find the file of a rig by its path, or by the name of a shipped rig."""
    return find_file(name, library(), "rig")


def rig_named_in(name: str, file: Path) -> Path:
    """Find the rig that a description refers to: a file next to it, or a shipped rig; errors name the description."""
    beside = file.parent / name
    if beside.suffix == ".toml":
        return beside
    try:
        return beside if len(name) < _LONGEST_NAME and beside.is_file() else rig_path(name)
    except DescriptionError as error:
        source, place = error.where, f"{file}: rig"
        raise DescriptionError(
            error.what, where=place, found=source, allowed=error.allowed, hint=error.hint
        ) from None


_LONGEST_NAME = 255  # characters: the limit of common file systems


def load(name: str | Path) -> Rig:
    """Load a rig or a vehicle from a TOML file or, by name, from the shipped library.

    Parameters
    ----------
    name : str or Path
        Path to a file, or the name of a shipped rig or vehicle (see ``jounce library``).

    Returns
    -------
    Rig
        The immutable description; vehicles are rigs, too.

    Raises
    ------
    DescriptionError
        With file, line, path, value found, allowed values and the nearest match.

    Examples
    --------
    >>> load("kart-quarter-car").sprung.mass
    16.0
    """
    path = rig_path(name)
    table, text = read_toml(path)
    return rig_from_table(table, where=str(path), text=text)


def as_rig(given: Rig | str | Path) -> Rig:
    """Return a rig unchanged, or load it from a file or by its name in the library.

    >>> as_rig("kart-quarter-car") == load("kart-quarter-car")
    True
    """
    return check_rig(load(given) if isinstance(given, str | Path) else given)


def rig_from_table(table: dict[str, Any], *, where: str = "", text: str = "") -> Rig:
    """Build the rig or vehicle that a TOML table describes; ``schema`` and ``model`` select its class."""
    models = MODELS[check_schema(table, tuple(MODELS), where)]
    model = table.get("model")
    if not isinstance(model, str):
        raise DescriptionError("the key 'model' is missing", where=where, allowed=", ".join(models))
    if model not in models:
        other = next((schema for schema, names in MODELS.items() if model in names), None)
        if other is not None:
            raise DescriptionError(
                Phrase("the model {model!r} belongs to a different schema", model=model),
                where=where,
                found=str(table["schema"]),
                allowed=Phrase('schema = "{other}"', other=other),
            )
        raise unknown(model, models, what="model", where=where)
    return models[model].from_table(_with_corners(table, where, text), where=where, text=text)


def _with_corners(table: dict[str, Any], where: str, text: str) -> dict[str, Any]:
    """Return a vehicle's table with each name of a ``corner`` or ``axle`` replaced by the table of its rig."""
    vehicle = dict(table)
    for end in ("front", "rear"):
        for part in _PARTS:
            entry = vehicle.get(end)
            if isinstance(entry, dict) and not isinstance(entry.get(part, {}), dict):
                line = line_of(text, (end, part)) if text else None
                place = below(at_line(where, line) if where else "", f"{end}.{part}")
                folder = Path(where).parent if where else None
                vehicle[end] = {**entry, part: _read_suspension(entry[part], folder, place, part)}
    return vehicle


_PARTS: dict[str, type[Rig]] = {"corner": Corner, "axle": DependentAxle}
_NOT_THIS = {"corner": "not a 3-D corner", "axle": "not a solid axle or twist beam"}


def _read_suspension(name: Any, folder: Path | None, place: str, part: str) -> dict[str, Any]:
    """Read the table of the rig that a vehicle names: a file in the vehicle's folder, any file, or a shipped rig."""
    if not isinstance(name, str):
        raise DescriptionError(
            "not a corner" if part == "corner" else _NOT_THIS[part],
            where=place,
            found=repr(name),
            allowed=_shipped_suspensions(part),
        )
    file = folder / name if folder is not None else Path(name)
    if not file.is_file():
        file = library()[name] if name in library() else Path(name)
    if not file.is_file():
        raise DescriptionError(
            "no such file, and no corner of that name in the library"
            if part == "corner"
            else "no such file, and no axle of that name in the library",
            where=place,
            found=name,
            allowed=_shipped_suspensions(part),
            hint=nearest(name, library()),
        )
    table, text = read_toml(file)
    known = _models_of(part)
    if table.get("model") in {model for models in MODELS.values() for model in models}.difference(
        known
    ):
        model = f"{name}, model {table['model']!r}"
        raise DescriptionError(_NOT_THIS[part], where=place, found=model, allowed=", ".join(known))
    rig_from_table(
        table, where=str(file), text=text
    )  # validate: errors refer to the rig's own file
    return table


def _models_of(part: str) -> list[str]:
    """Return the models of rigs that can be a ``corner`` or an ``axle`` of a vehicle."""
    return [name for name, rig in RIGS.items() if issubclass(rig, _PARTS[part])]


def _shipped_suspensions(part: str) -> str:
    """Describe the rigs that a vehicle can refer to."""
    models = _models_of(part)
    rigs = [
        shipped for shipped, file in library().items() if read_toml(file)[0].get("model") in models
    ]
    return f"a table, a .toml file from this file's folder, or one of {', '.join(rigs)}"


def changed_text(text: str, rig: Rig, values: dict[str, float], *, rounding: float = 0.0) -> str:
    """Write new values (SI, by path) into the text of a rig file; comments and all other text remain unchanged.

    A value is written in the unit of the file if it is read again to the last bit, or within a relative ``rounding``.
    """
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
                here[part] = _write_default(rig, parents[: i + 1])
            elif isinstance(here[part], str):  # a corner given by name: replace the name by the rig
                here[part] = tomlkit.parse(
                    rig_text(reduce(getattr, map(str, parents[: i + 1]), rig))
                )
            here = here[part]
        here[last] = _as_before(here, last, value, unit_of(rig, path), rounding)
    return tomlkit.dumps(document)


def updated_text(text: str, rig: Rig, where: str = "") -> str:
    """Write the values of ``rig`` into the text of its original rig file; ``where`` is the path of the file.

    Changed numbers are replaced in place. If a law changed its kind (e.g. a tyre stiffness became a curve), its table
    is replaced. All other text, including comments, remains unchanged.
    """
    document = tomlkit.parse(text)
    described = rig_from_table(tomllib.loads(text), where=where)
    _reshape(document, _table(rig), _table(described))
    reshaped = tomlkit.dumps(document)
    before, after = (
        parameters_of(rig_from_table(tomllib.loads(reshaped), where=where)),
        parameters_of(rig),
    )
    return changed_text(
        reshaped, rig, {path: value for path, value in after.items() if before.get(path) != value}
    )


def _table(rig: Rig) -> dict[str, Any]:
    table: dict[str, Any] = rig.model_dump(by_alias=True, exclude_none=True)
    return table


def _reshape(here: Any, wanted: dict[str, Any], described: dict[str, Any]) -> None:
    """Adapt the keys of a table to ``wanted``; numbers present in both are left to be replaced in place."""
    for key in [key for key in here if key not in wanted]:
        del here[key]
    for key, value in wanted.items():
        old = described.get(key)
        if isinstance(value, dict) and isinstance(old, dict):
            if isinstance(here.get(key), str):  # a corner given by name
                if _has_other_parts(value, old):
                    here[key] = _plain(value)
            elif key in here:
                _reshape(here[key], value, old)
            elif value:
                here[key] = _plain(value)
        elif isinstance(old, tuple) and _holds_tables(old) and len(value) == len(old):
            for item, inner, before in zip(here[key], value, old, strict=True):
                _reshape(item, inner, before)
        elif old is None or _is_another_law(value, old):
            here[key] = _plain(value)


def _has_other_parts(value: Any, old: Any) -> bool:
    """Whether anything other than numbers differs."""
    if isinstance(value, dict) and isinstance(old, dict):
        return value.keys() != old.keys() or any(
            _has_other_parts(value[key], old[key]) for key in value
        )
    return _is_another_law(value, old)


def _is_another_law(value: Any, old: Any) -> bool:
    """Whether a text (the kind of a law) or the number of points differs, also inside of lists."""
    if isinstance(value, tuple):
        return len(value) != len(old) or any(map(_has_other_parts, value, old))
    return isinstance(value, str) and value != old


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    return [_plain(item) for item in value] if isinstance(value, tuple) else value


def save(
    rig: Rig, path: Path | str, *, like: Path | str | None = None, force: bool = False
) -> Path:
    """Write a rig or a vehicle as a TOML file that :func:`load` reads.

    Parameters
    ----------
    rig : Rig
        The rig to write; every number gets its unit.
    path : Path or str
        The file, ``.toml``.
    like : Path or str, optional
        A rig file, or the name of a shipped rig, to use as template: comments, order and units are kept, only
        differences are written. By default, an existing file that is overwritten is the template.
    force : bool
        Overwrite an existing file.

    Returns
    -------
    Path
        The file written.

    Raises
    ------
    OutputError
        For an existing file without ``force``, a missing folder, or a different suffix.
    DescriptionError
        If ``like`` is not a rig file.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> from jounce.parts import load
    >>> rig = load("formula-student-front").with_changes({"hardpoints.tie_rod_inner[2]": "151 mm"})
    >>> file = save(rig, pathlib.Path(tempfile.mkdtemp()) / "front.toml", like="formula-student-front")
    >>> load(file) == rig, "# on the rocker" in file.read_text(encoding="utf-8")
    (True, True)
    """
    file = check_writable(path, what="rigs", suffixes=(".toml",), force=force)
    model = rig_path(like) if like is not None else file if file.is_file() else None
    if model is None:
        return write_atomically(file, rig_text(rig), force=force)
    text = _rebase_corners(read_toml(model)[1], model.parent, file.parent)
    described = rig_from_table(tomllib.loads(text), where=str(file), text=text)
    if type(described) is not type(rig):
        if like is None:  # a file of a different model has nothing to keep
            return write_atomically(file, rig_text(rig), force=force)
        models = f"a {getattr(described, 'model', '')} for a {getattr(rig, 'model', '')}"
        raise DescriptionError(
            "the file describes a different model", where=str(model), found=models
        )
    return write_atomically(file, updated_text(text, rig, str(file)), force=force)


def _rebase_corners(text: str, before: Path, after: Path) -> str:
    """Make the corner paths in a vehicle's text relative to the folder ``after``."""
    if before.resolve() == after.resolve():
        return text
    document = tomlkit.parse(text)
    for axle in ("front", "rear"):
        entry = document.get(axle)
        if not isinstance(entry, dict):
            continue
        part = "axle" if "axle" in entry else "corner"
        name = entry.get(part)
        if isinstance(name, str) and (before / name).is_file():
            entry[part] = Path(os.path.relpath(before / name, after)).as_posix()
    return tomlkit.dumps(document)


def _write_default(rig: Rig, parents: list[str | int]) -> Any:
    """Return the TOML item of a part that the file omits: an empty table, or the full list of default numbers."""
    name = join_path(tuple(parents))
    known = rig.parameters()
    values = [path for path in known if re.fullmatch(rf"{re.escape(name)}\[\d+\]", path)]
    return [_quantity(known[path], unit_of(rig, path)) for path in values] or tomlkit.inline_table()


def _as_before(here: Any, key: str | int, value: float, unit: str, rounding: float) -> float | str:
    """Format a value in the unit used in the file."""
    try:
        before = here[key]
    except (KeyError, IndexError, TypeError):
        return _quantity(value, unit)
    match = _NUMBER_AND_UNIT.match(before) if isinstance(before, str) else None
    if match is None or match[1] == unit or unit == "1":
        return _quantity(value, unit)
    try:
        factor = conversion_factor(match[1], unit)
    except DescriptionError:
        return _quantity(value, unit)
    text = f"{float(value) / factor:.12g} {match[1]}"
    is_same = math.isclose(to_si(text, unit), value, rel_tol=rounding)
    return text if is_same else _quantity(value, unit)


def _quantity(value: float, unit: str) -> float | str:
    return float(value) if unit == "1" else f"{float(value)!r} {unit}"
