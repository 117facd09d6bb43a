"""JSON Schema as far as the published schemas use it, references to other files included."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

TYPES: dict[str, tuple[type, ...]] = {
    "string": (str,), "boolean": (bool,), "object": (dict,), "array": (list,), "integer": (int,),
    "number": (int, float), "null": (type(None),),
}  # fmt: skip
SILENT = {"$defs", "$schema", "default", "description", "discriminator", "format", "title"}


@cache
def _content(file: Path) -> Any:
    return json.loads(file.read_text(encoding="utf-8"))


def schema_problems(value: Any, file: Path) -> list[str]:
    """What the schema in a file finds wrong with a table: path and reason."""
    return _problems(_plain(value), _content(file), file, "")


def _plain(value: Any) -> Any:
    """A TOML value as JSON has it: dates are text."""
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_plain(item) for item in value]
    return value if isinstance(value, (str, bool, int, float)) else str(value)


def _is(value: Any, kind: str) -> bool:
    return isinstance(value, TYPES[kind]) and (kind == "boolean" or not isinstance(value, bool))


def _problems(value: Any, schema: Any, file: Path, path: str) -> list[str]:
    if isinstance(schema, bool):
        return [] if schema else [f"{path}: not allowed"]
    found: list[str] = []
    for word, rule in schema.items():
        found += [] if word in SILENT else _broken(word, rule, value, schema, file, path)
    return found


def _broken(word: str, rule: Any, value: Any, schema: Any, file: Path, path: str) -> list[str]:
    if word == "$ref":
        name, _, place = rule.partition("#")
        other = file.parent / name if name else file
        inner = _content(other)
        for part in place.strip("/").split("/") if place.strip("/") else []:
            inner = inner[part]
        return _problems(value, inner, other, path)
    if word in ("anyOf", "oneOf"):
        each = [_problems(value, one, file, path) for one in rule]
        fits = sum(not problems for problems in each)
        return (
            []
            if fits == 1 or (fits and word == "anyOf")
            else [f"{path}: fits {fits} of {len(rule)}: {each}"]
        )
    if word == "type":
        kinds = rule if isinstance(rule, list) else [rule]
        return (
            [] if any(_is(value, kind) for kind in kinds) else [f"{path}: {value!r} is no {rule}"]
        )
    if word in ("const", "enum"):
        return (
            []
            if value in ([rule] if word == "const" else rule)
            else [f"{path}: {value!r} is not {rule}"]
        )
    if isinstance(value, dict):
        if word == "required":
            return [f"{path}.{key}".lstrip(".") + ": missing" for key in rule if key not in value]
        if word == "minProperties":
            return [] if len(value) >= rule else [f"{path}: fewer than {rule} keys"]
        known = schema.get("properties", {})
        rules = {
            "properties": {key: rule[key] for key in value if key in rule}
            if word == "properties"
            else {},
            "additionalProperties": dict.fromkeys(value.keys() - known.keys(), rule),
        }
        if word == "propertyNames":
            return [text for key in value for text in _problems(key, rule, file, f"{path}.{key}")]
        if word in rules:
            return [
                text
                for key, own in rules[word].items()
                for text in _problems(value[key], own, file, f"{path}.{key}".lstrip("."))
            ]
    if isinstance(value, list):
        if word == "items":
            first = len(schema.get("prefixItems", []))
            return [
                text
                for i, one in enumerate(value[first:])
                for text in _problems(one, rule, file, f"{path}[{i}]")
            ]
        if word == "prefixItems":
            return [
                text
                for i, (one, own) in enumerate(zip(value, rule, strict=False))
                for text in _problems(one, own, file, f"{path}[{i}]")
            ]
        if word in ("minItems", "maxItems"):
            wrong = len(value) < rule if word == "minItems" else len(value) > rule
            return [f"{path}: {len(value)} entries, {word} {rule}"] if wrong else []
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        limits = (
            {"minimum": value >= rule, "maximum": value <= rule}
            if isinstance(rule, (int, float))
            else {}
        )
        if limits:
            limits |= {"exclusiveMinimum": value > rule, "exclusiveMaximum": value < rule}
            return [] if limits.get(word, True) else [f"{path}: {value} against {word} {rule}"]
    known = {
        "required",
        "properties",
        "propertyNames",
        "additionalProperties",
        "items",
        "prefixItems",
        "minItems",
    }
    known |= {
        "maxItems",
        "minimum",
        "maximum",
        "exclusiveMinimum",
        "exclusiveMaximum",
        "minLength",
        "minProperties",
    }
    return [] if word in known else [f"{path}: the word {word!r} of the schema is not checked here"]
