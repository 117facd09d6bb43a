"""Descriptions: frozen, validated data read from TOML, with errors that name file, line and path."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any, Self, TypeVar

from pydantic import BaseModel, ConfigDict, ValidationError

from jounce.core.errors import DescriptionError, nearest

D = TypeVar("D", bound="Description")


class _DescriptionType(type(BaseModel)):  # type: ignore[misc]
    """Raises jounce errors at the outermost construction only, so that nested parts keep their path."""

    def __call__(cls, *arguments: Any, **fields: Any) -> Any:  # noqa: ANN401
        try:
            return super().__call__(*arguments, **fields)
        except ValidationError as error:
            raise description_error(error, cls) from None


class Description(BaseModel, metaclass=_DescriptionType):
    """Base of all nouns: frozen, refuses unknown keys, reads physical values with units."""

    model_config = ConfigDict(frozen=True, extra="forbid", populate_by_name=True, protected_namespaces=())

    @classmethod
    def from_table(cls, table: dict[str, Any], *, where: str = "", text: str = "") -> Self:
        """Build from a TOML table; ``where`` and ``text`` (the file's content) place the errors."""
        try:
            return cls.model_validate(table)
        except ValidationError as error:
            raise description_error(error, cls, where=where, text=text) from None


def read_toml(path: Path | str) -> tuple[dict[str, Any], str]:
    """Read a TOML file; give its table and its text.

    Raises
    ------
    DescriptionError
        When the file is missing, empty, not text, or not TOML (with the line).
    """
    file = Path(path)
    if not file.is_file():
        raise DescriptionError("no such file", where=str(file), hint="Check the path and the name.")
    try:
        text = file.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise DescriptionError(
            "not a text file", where=str(file), allowed="TOML text in UTF-8", hint="Was a recording given instead?"
        ) from None
    if not text.strip():
        raise DescriptionError("the file is empty", where=str(file), allowed="a TOML description")
    try:
        return tomllib.loads(text), text
    except tomllib.TOMLDecodeError as error:
        raise DescriptionError(f"not valid TOML: {error}", where=str(file)) from None


def line_of(text: str, path: tuple[str | int, ...]) -> int | None:
    """Find the line (from 1) on which the value at ``path`` is written; None when it is not found."""
    keys = [part for part in path if isinstance(part, str)]
    indices = [part for part in path if isinstance(part, int)]
    best, best_depth, table, array_seen = None, 0, [], dict[str, int]()
    for number, line in enumerate(text.splitlines(), 1):
        header = re.match(r"\s*\[(\[?)([^\]]+)\]", line)
        if header:
            table = _split_key(header[2])
            if header[1]:
                name = ".".join(table)
                array_seen[name] = array_seen.get(name, -1) + 1
        else:
            key = re.match(r"\s*((?:[\w-]+|\"[^\"]*\"|'[^']*')(?:\s*\.\s*(?:[\w-]+|\"[^\"]*\"|'[^']*'))*)\s*=", line)
            if key is None:
                continue
        here = table if header else [*table, *_split_key(key[1])]  # type: ignore[index]
        if array_seen.get(table[0] if table else "", None) is not None and indices:
            if keys[:1] == table[:1] and array_seen[table[0]] != indices[0]:
                continue
        depth = _common_length(here, keys)
        if depth == len(here) and depth > best_depth:
            best, best_depth = number, depth
    return best


def _split_key(text: str) -> list[str]:
    return [part.strip("\"'") for part in re.findall(r"\"[^\"]*\"|'[^']*'|[\w-]+", text)]


def _common_length(a: list[str], b: list[str]) -> int:
    return next((i for i, (x, y) in enumerate(zip(a, b, strict=False)) if x != y), min(len(a), len(b)))


def dotted(path: tuple[str | int, ...]) -> str:
    """Write a path as users do: ``trial[2].speed``."""
    text = ""
    for part in path:
        text += f"[{part}]" if isinstance(part, int) else (f".{part}" if text else str(part))
    return text


def description_error(
    error: ValidationError, kind: type[BaseModel], *, where: str = "", text: str = ""
) -> DescriptionError:
    """Turn pydantic's report into one jounce message, at most five lines."""
    problems = [_problem(item, kind, where, text) for item in error.errors()]
    more = f"\n(and {len(problems) - 5} more)" if len(problems) > 5 else ""
    return DescriptionError("\n".join(problems[:5]) + more)


def _problem(item: Any, kind: type[BaseModel], where: str, text: str) -> str:  # noqa: ANN401
    path = tuple(part for part in item["loc"] if not (isinstance(part, str) and part.startswith(("function-", "tagged-"))))
    place = dotted(path)
    line = line_of(text, path) if text else None
    prefix = f"{where}, line {line}" if where and line else where
    start = f"{prefix}: {place}" if prefix and place else (prefix or place or kind.__name__)
    if item["type"] == "extra_forbidden":
        fields = _fields_at(kind, path[:-1])
        return f"{start}: unknown key; allowed: {', '.join(sorted(fields))}. {nearest(str(path[-1]), fields)}".rstrip()
    if item["type"] == "missing":
        return f"{start}: the key is missing and has no default"
    if item["type"] in ("physical_value", "out_of_range"):
        return f"{start}: {item['msg']}".rstrip()
    message = item["msg"].removeprefix("Value error, ")
    found = "" if item["type"] == "value_error" else f"; found {item['input']!r}"
    return f"{start}: {message[0].lower()}{message[1:]}{found}"


def _fields_at(kind: type[BaseModel], path: tuple[str | int, ...]) -> set[str]:
    """Names allowed at ``path`` inside ``kind`` (aliases included)."""
    current: list[type[BaseModel]] = [kind]
    for part in path:
        if isinstance(part, int):
            continue
        step = [found for model in current for found in _models_of(_annotation(model, part))]
        current = step or current
    return {field.alias or name for model in current for name, field in model.model_fields.items()}


def _annotation(model: type[BaseModel], name: str) -> Any:  # noqa: ANN401
    for key, field in model.model_fields.items():
        if name in (key, field.alias):
            return field.annotation
    return None


def _models_of(annotation: Any) -> list[type[BaseModel]]:  # noqa: ANN401
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [found for part in getattr(annotation, "__args__", ()) for found in _models_of(part)]
