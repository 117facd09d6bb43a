"""Public docstrings say what a reader needs: every argument by its name, every physical value with its unit.

Three levels: what ``jounce`` exports needs full numpydoc sections and an example; what a package exports needs at
least a sentence that names each physical argument and a unit; inside a package, sections must be true where written.
Fields of descriptions carry their unit in their annotation.
"""

from __future__ import annotations

import dataclasses
import inspect
import re
from collections.abc import Callable
from enum import IntEnum
from typing import Any

from pydantic import BaseModel

from jounce.core import units

_SECTION = re.compile(r"^([A-Z][A-Za-z ]+)\n-{3,}[ ]*$", re.MULTILINE)
_UNIT = re.compile(
    r"(?<![\w'’])(?:kg|N|kN|Pa|kPa|MPa|Hz|rad|deg|m|mm|s|ms|J|W|dB|g|1|%|SI)(?![\w'’])|N/m|m/s|N\*s/m"
    r"|(?i:dimensionless|relative|ratio|fraction|per ?cent|radian|degree|metre|inch|second|newton|same unit|units? of)"
    r"|in ``(?:unit|si)``",
)
_PHYSICAL = re.compile(
    r"\bfloat\b|\bnp\.float64\b|\bNDArray\b|\bndarray\b|\bArray\w*\b|\bArrayLike\b|\bFloats?\b"
)
_WITH_UNIT = {
    name
    for name, value in vars(units).items()
    if any(isinstance(item, units.Unit) for item in getattr(value, "__metadata__", ()))
}
_EMPTY_WORDS = {"a", "an", "the", "of", "for", "from", "to", "and", "or", "in", "this", "it", "its"}
_EMPTY_WORDS |= {"get", "give", "return", "do"}


class Level(IntEnum):
    """How far a name is seen."""

    INSIDE = 0
    PACKAGE = 1
    PUBLIC = 2


def sections(text: str) -> dict[str, str]:
    """Sections of a numpydoc text by their heading; what stands before the first one is ``""``."""
    parts = _SECTION.split(inspect.cleandoc(text))
    return {"": parts[0], **dict(zip(parts[1::2], parts[2::2], strict=True))}


def documented(section: str) -> dict[str, str]:
    """Entries of a section by name: type and description as one text."""
    found: dict[str, str] = {}
    names: list[str] = []
    for line in section.splitlines():
        if line and not line[0].isspace():
            head, _, kind = line.partition(" : ")
            names = [name.strip().lstrip("*") for name in head.split(",")]
            found.update(dict.fromkeys(names, kind))
        else:
            found.update({name: f"{found[name]} {line.strip()}" for name in names})
    return found


def is_physical(annotation: object) -> bool:
    """Tell whether values of this annotation are numbers with a unit."""
    text = (
        annotation
        if isinstance(annotation, str)
        else getattr(annotation, "__name__", str(annotation))
    )
    text = re.sub(
        r"^Annotated\[(.*?), (?:\w+\(.*|[A-Z_]+)\]$", r"\1", text
    )  # a mark says how it is given
    if "Callable" in text or "Literal" in text:
        return False
    return bool(_PHYSICAL.search(text)) or any(
        re.search(rf"\b{name}\b", text) for name in _WITH_UNIT
    )


def arguments_of(thing: Any) -> dict[str, object]:
    """Names and annotations of what a function takes, or of what a class is built from."""
    if isinstance(thing, type) and issubclass(thing, BaseModel):
        return {}  # fields carry their unit in their annotation; see field_problems
    if dataclasses.is_dataclass(thing):
        return {
            field.name: field.type
            for field in dataclasses.fields(thing)
            if not field.name.startswith("_")
        }
    if isinstance(thing, type) and "__init__" not in vars(thing):
        return {}
    parameters = inspect.signature(thing).parameters.values()
    return {item.name: item.annotation for item in parameters if item.name not in ("self", "cls")}


def docstring_problems(name: str, thing: Any, level: Level) -> list[str]:
    """Judge the docstring of one function or class."""
    text = (
        vars(thing).get("__doc__") if isinstance(thing, type) else getattr(thing, "__doc__", None)
    )
    if not text or text.startswith(
        f"{getattr(thing, '__name__', '')}("
    ):  # what dataclasses write themselves
        return [f"{name}: no docstring"]
    parts = sections(text)
    entries = documented(parts.get("Parameters", "")) | documented(parts.get("Attributes", ""))
    problems = [f"{name}: the docstring only repeats the name"] if _repeats(name, parts[""]) else []
    problems += _name_problems(name, thing, entries, level)
    if level >= Level.PACKAGE:
        all_si = isinstance(thing, type) and re.search(r"\bSI\b", parts[""])
        problems += [] if all_si else _unit_problems(name, arguments_of(thing), entries, text)
    if level >= Level.PACKAGE and not isinstance(thing, type):
        problems += _return_problems(name, thing, parts, level)
    if level == Level.PUBLIC and not isinstance(thing, type) and ">>>" not in text:
        problems.append(f"{name}: no example (>>>)")
    return problems


def _name_problems(name: str, thing: Any, entries: dict[str, str], level: Level) -> list[str]:
    if isinstance(thing, type) and issubclass(thing, BaseModel):
        if inspect.isabstract(thing):
            return []  # its subclasses may have to define what it documents
        known = {field.alias or key for key, field in thing.model_fields.items()} | {
            *vars(thing),
            *thing.model_fields,
        }
        return [
            f"{name}: documents {extra!r}, which it does not have"
            for extra in entries
            if extra not in known
        ]
    arguments = set(arguments_of(thing))
    known = arguments | (
        {key for base in thing.__mro__ for key in vars(base)} if isinstance(thing, type) else set()
    )
    problems = [
        f"{name}: documents {extra!r}, which it does not have"
        for extra in sorted(set(entries) - known)
    ]
    if entries or level == Level.PUBLIC:
        problems += [
            f"{name}: {missing!r} is not documented" for missing in sorted(arguments - set(entries))
        ]
    return problems


def _unit_problems(
    name: str, arguments: dict[str, object], entries: dict[str, str], text: str
) -> list[str]:
    problems = []
    for argument, annotation in arguments.items():
        if is_physical(annotation):
            said = entries.get(argument) or (
                text if not entries and re.search(rf"\b{argument}\b", text) else ""
            )
            if not _UNIT.search(said):
                problems.append(f"{name}: no unit is given for {argument!r}")
    return problems


def _return_problems(
    name: str, thing: Callable[..., Any], parts: dict[str, str], level: Level
) -> list[str]:
    annotation = inspect.signature(thing).return_annotation
    if annotation in (None, "None", inspect.Signature.empty):
        return []
    if level == Level.PUBLIC and not {"Returns", "Yields"} & set(parts):
        return [f"{name}: no Returns section"]
    said = parts.get("Returns") or parts.get("Yields") or parts[""]
    if is_physical(annotation) and not _UNIT.search(said):
        return [f"{name}: no unit is given for what it returns"]
    return []


def _repeats(name: str, summary: str) -> bool:
    words = set(re.findall(r"[a-z]+", summary.lower())) - _EMPTY_WORDS
    own = set(
        re.findall(r"[a-z]+", re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name.rpartition(".")[2]).lower())
    )
    return bool(words) and {word.rstrip("s") for word in words} <= {
        word.rstrip("s") for word in own
    }


def field_problems(name: str, kind: type[BaseModel]) -> list[str]:
    """Numbers of a description whose annotation carries no unit."""
    return [
        f"{name}.{field}: a number without a unit in its annotation"
        for field, detail in kind.model_fields.items()
        if _has_bare_number(detail.annotation)
        and not any(isinstance(m, units.Unit) for m in detail.metadata)
    ]


def _has_bare_number(annotation: Any) -> bool:
    if any(isinstance(item, units.Unit) for item in getattr(annotation, "__metadata__", ())):
        return False
    return annotation is float or any(
        _has_bare_number(part) for part in getattr(annotation, "__args__", ())
    )
