"""Descriptions: frozen, validated data read from TOML, with errors that name file, line and path."""

from __future__ import annotations

import codecs
import re
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self, TypeVar, cast, get_origin

from pydantic import (
    BaseModel,
    ConfigDict,
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    Strict,
    ValidationError,
)
from pydantic_core import CoreSchema

from jounce.core.arguments import fits
from jounce.core.errors import (
    DescriptionError,
    as_found,
    at_line,
    below,
    nearest,
    show_value,
    unknown,
)
from jounce.core.files import content_of, existing_file
from jounce.core.kinds import FILE_REF, Kinds
from jounce.core.old_names import old_method
from jounce.core.phrases import Phrase, Phrases
from jounce.core.shown import Shown
from jounce.core.text import qualify

D = TypeVar("D", bound="Description")
Whole = Annotated[int, Strict()]
"""An integer field of a description; ``true`` and ``"1"`` are not accepted."""
Seed = Annotated[Whole, Field(ge=0, lt=2**63)]
"""Seed of a random number generator."""


if TYPE_CHECKING:
    from pydantic._internal._model_construction import ModelMetaclass
else:
    ModelMetaclass = type(BaseModel)


class _DescriptionType(ModelMetaclass):
    """Converts errors to jounce errors only at the outermost construction, which preserves the path of nested parts."""

    def __call__(cls, *arguments: Any, **fields: Any) -> Any:  # noqa: N805
        if arguments:
            allowed = ", ".join(cls.model_fields)  # type: ignore[attr-defined]
            raise DescriptionError(
                "fields must be given by name", where=cls.__name__, allowed=allowed
            )
        try:
            return super().__call__(**fields)
        except ValidationError as error:
            raise description_error(error, cast("type[BaseModel]", cls)) from None


class Description(Shown, BaseModel, metaclass=_DescriptionType):
    """Base class of descriptions: frozen, refuses unknown keys, reads physical values with units."""

    model_config = ConfigDict(
        frozen=True,
        extra="forbid",
        populate_by_name=True,
        protected_namespaces=(),
        defer_build=True,
    )  # validators are built on first use: there are hundreds, and a process uses only a few

    kinds: ClassVar[Kinds | None] = None  # set by the base of a family of descriptions

    @classmethod
    def __pydantic_init_subclass__(cls, **_: Any) -> None:
        if cls.kinds is not None:
            cls.kinds.join(cls)

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        family: Kinds | None = vars(cls).get("kinds")
        return handler(source) if family is None else family.core_schema(cls)

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        family: Kinds | None = vars(cls).get("kinds")
        return handler(schema) if family is None else {FILE_REF: family.schema}

    def __setattr__(self, name: str, value: Any) -> None:
        if not name.startswith("_"):  # pydantic's own attributes
            raise self._frozen(name, value)
        super().__setattr__(name, value)

    def __delattr__(self, name: str) -> None:
        if not name.startswith("_"):
            raise self._frozen(name, "...")
        super().__delattr__(name)

    def _frozen(self, name: str, value: object) -> DescriptionError:
        if name not in type(self).model_fields:
            return unknown(name, type(self).model_fields, what="field", where=type(self).__name__)
        change = f"'{name}': {show_value(value)}"
        if hasattr(self, "with_changes"):
            hint = Phrase("Make a changed copy: with_changes({{{change}}}).", change=change)
        else:
            hint = Phrase(
                "Make a changed copy: model_copy(update={{{change}}}), or for a whole rig: rig.with_changes(...).",
                change=change,
            )
        return DescriptionError(
            "descriptions cannot be modified", where=f"{type(self).__name__}.{name}", hint=hint
        )

    def model_copy(self, *, update: Mapping[str, Any] | None = None, deep: bool = False) -> Self:
        """Return a copy; unknown fields and values of a wrong type are handled as in a new description."""
        kinds = type(self).model_fields
        if all(
            name in kinds and fits(value, kinds[name].annotation)
            for name, value in (update or {}).items()
        ):
            return super().model_copy(update=update, deep=deep)
        return self.with_fields(**(update or {}))

    def with_fields(self, **fields: Any) -> Self:
        """Return a copy with changed values, validated as a whole; defaults that were not set stay unset."""
        own = {
            name: getattr(self, name)
            for name in type(self).model_fields
            if name in self.model_fields_set
        }
        return type(self)(**{**own, **fields})

    changed: ClassVar[Any] = old_method("Description.changed", "with_fields")

    def __getstate__(self) -> dict[Any, Any]:
        """Return a state that pickles to the same bytes in every process: no derived values, and no set of strings."""
        fields = type(self).model_fields
        state = super().__getstate__()
        own = {name: value for name, value in state["__dict__"].items() if name in fields}
        return state | {
            "__dict__": own,
            "__pydantic_fields_set__": sorted(state["__pydantic_fields_set__"]),
        }

    def __setstate__(self, state: dict[Any, Any]) -> None:
        super().__setstate__(
            state | {"__pydantic_fields_set__": set(state["__pydantic_fields_set__"])}
        )

    @classmethod
    def from_table(
        cls,
        table: dict[str, Any],
        *,
        where: str = "",
        text: str = "",
        path: tuple[str | int, ...] = (),
    ) -> Self:
        """Build from a TOML table; ``where``, ``text`` (the file's content) and ``path`` in it locate errors."""
        try:
            return cls.model_validate(table)
        except ValidationError as error:
            raise description_error(error, cls, where=where, text=text, path=path) from None


_LARGEST = 5_000_000  # bytes: larger than any description


def description_text(path: Path | str) -> str:
    """Return the text of a file not larger than a description; raise UnicodeDecodeError if it is not text.

    The encoding is UTF-8, or UTF-16 with a byte order mark, as PowerShell and Windows editors write it.
    """
    file = existing_file(path)
    if file.stat().st_size > _LARGEST:
        allowed = Phrase("at most {largest} MB of text", largest=_LARGEST // 1_000_000)
        raise DescriptionError(
            "the file is too large for a description", where=str(file), allowed=allowed
        )
    content = content_of(file)
    is_wide = content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    text = content.decode("utf-16" if is_wide else "utf-8-sig")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def read_toml(path: Path | str) -> tuple[dict[str, Any], str]:
    """Read a TOML file; return its table and text. Refuse a missing or empty file, and invalid TOML with its line."""
    file = existing_file(path)
    try:
        text = description_text(file)
    except UnicodeDecodeError:
        raise DescriptionError(
            "not a text file",
            where=str(file),
            allowed="TOML text in UTF-8",
            hint="Was a recording given instead?",
        ) from None
    if not text.strip():
        raise DescriptionError("the file is empty", where=str(file), allowed="a TOML description")
    try:
        return toml_table(text), text
    except tomllib.TOMLDecodeError as error:
        raise toml_error(error, str(file)) from None


def toml_table(text: str) -> dict[str, Any]:
    """Parse TOML; raise TOMLDecodeError for all errors, including excessive nesting and integers."""
    # Checked before parsing, which takes seconds for tens of thousands, and quadratic time in the length of a key.
    if text.count("\n[") > _MOST_TABLES or text.count("=") > _MOST_KEYS:
        raise tomllib.TOMLDecodeError(f"more than {_MOST_TABLES} tables or {_MOST_KEYS} keys")
    if _LONG_KEY.search(text):
        raise tomllib.TOMLDecodeError(f"a key of more than {_DEEPEST} parts")
    try:
        table = tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        raise
    except RecursionError:
        raise tomllib.TOMLDecodeError("nested too deeply") from None
    except ValueError:
        raise tomllib.TOMLDecodeError("an integer of thousands of digits") from None
    if is_nested_deeply(table):
        raise tomllib.TOMLDecodeError("nested too deeply")
    return table


_PLACE_IN_TOML = re.compile(
    r"(?P<what>.*?) \(at (?:line (?P<line>\d+), column (?P<column>\d+)|end of document)\)",
    re.DOTALL,
)
"""Message of Python's parser; before Python 3.14 it has the position in its text only."""


def toml_error(error: tomllib.TOMLDecodeError, where: str) -> DescriptionError:
    """Return the error for a text that is not valid TOML, with its line."""
    parts = _PLACE_IN_TOML.fullmatch(str(error))
    if parts is None:
        reason: str = Phrase(str(error))
    elif parts["line"] is None:
        reason = Phrase("{what} (at end of document)", what=Phrase(parts["what"]))
    else:
        at = {"line": int(parts["line"]), "column": int(parts["column"])}
        reason = Phrase(
            "{what} (at line {line}, column {column})", what=Phrase(parts["what"]), **at
        )
    refusal = DescriptionError(Phrase("not valid TOML: {reason}", reason=reason), where=where)
    refusal.line = int(parts["line"]) if parts and parts["line"] else None
    return refusal


_DEEPEST = 30  # nested tables: more than in any description
_MOST_TABLES, _MOST_KEYS = 10_000, 100_000
_LONG_KEY = re.compile(
    rf"""(?<![\w-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){{{_DEEPEST}}}"""
)


def is_nested_deeply(value: object) -> bool:
    """Whether tables and lists are nested more deeply than in any description, so that recursion may fail.

    >>> is_nested_deeply({"a": [{"b": 1}]})
    False
    """
    level: list[object] = [value]
    for _ in range(_DEEPEST):
        level = [
            inner
            for item in level
            if isinstance(item, (dict, list))
            for inner in (item.values() if isinstance(item, dict) else item)
            if isinstance(inner, (dict, list))
        ]
        if not level:
            return False
    return True


_SCHEMA = re.compile(r"""^[ \t]*(["']?)schema\1[ \t]*=[ \t]*(["'])(?P<name>.*?)\2""", re.MULTILINE)


def schema_named_in(path: Path) -> str:
    """Return the schema named in a TOML file, even if the file is invalid; empty without one."""
    if path.suffix != ".toml" or not path.is_file():
        return ""
    result = _SCHEMA.search(path.read_text(encoding="utf-8", errors="replace"))
    return result["name"] if result else ""


def check_schema(table: dict[str, Any], expected: tuple[str, ...], where: str) -> str:
    """Return the schema name of a file; refuse unexpected ones."""
    schema = table.get("schema")
    if schema in expected:
        return str(schema)
    raise DescriptionError(
        "the schema line is missing or wrong",
        where=where,
        found=schema,
        allowed=" or ".join(f'schema = "{name}"' for name in expected),
        hint="Is this the right kind of file?",
    )


Described = TypeVar("Described", bound=Description)


def read_description(kind: type[Described], path: Path | str, schema: str) -> tuple[Described, str]:
    """Read a file with this schema line as a description; return the description and the file's text."""
    table, text = read_toml(path)
    check_schema(table, (schema,), str(path))
    return kind.from_table(table, where=str(path), text=text), text


_NAME = r"(?:[\w-]+|\"[^\"]*\"|'[^']*')"
_HEADER = re.compile(rf"\s*\[(\[?)\s*({_NAME}(?:\s*\.\s*{_NAME})*)\s*\]\]?\s*(?:#.*)?$")
_KEY = re.compile(rf"\s*({_NAME}(?:\s*\.\s*{_NAME})*)\s*=")
_LONG_TEXT = re.compile(r"(\"\"\"|''')(?:.|\n)*?\1")
_TOKEN = re.compile(r"\"(?:\\.|[^\"\\\n])*\"|'[^'\n]*'|#[^\n]*|[\[\]{},]|[^\s\[\]{},\"'#]+")


def line_of(text: str, path: tuple[str | int, ...]) -> int | None:
    """Find the line (from 1) on which the value at ``path``, or the innermost table around it, is written."""
    best, best_depth, seen = None, 0, dict[tuple[str, ...], int]()
    table: tuple[str | int, ...] = ()
    flat = _LONG_TEXT.sub(lambda found: "\n" * found[0].count("\n"), text)
    lines = flat.split("\n")
    for number, line in enumerate(lines, 1):
        header, key = _HEADER.match(line), _KEY.match(line)
        if header:
            names = _split_key(header[2])
            if header[1]:
                seen[names] = seen.get(names, -1) + 1
            here = table = _path_with_entries(names, seen)
        elif key:
            here = (*table, *_split_key(key[1]))
        else:
            continue
        if path[: len(here)] == here and len(here) > best_depth:
            best, best_depth = number, len(here)
    entry = path[best_depth] if len(path) > best_depth else ""
    if best is not None and isinstance(entry, int):
        return best + _lines_before(entry, "\n".join(lines[best - 1 :]))
    return best


def _lines_before(entry: int, text: str) -> int:
    """Number of lines from the start of ``key = [...]`` to an entry of the list; 0 if it is not found."""
    key = _KEY.match(text)
    depth = commas = 0
    for token in _TOKEN.finditer(text, key.end() if key else len(text)):
        mark = token[0]
        if mark.startswith("#"):
            continue
        if depth == 1 and commas == entry and mark not in ("]", ","):
            return text.count("\n", 0, token.start())
        depth += (mark in ("[", "{")) - (mark in ("]", "}"))
        commas += depth == 1 and mark == ","
        if depth <= 0:
            break
    return 0


def _split_key(text: str) -> tuple[str, ...]:
    return tuple(part.strip("\"'") for part in re.findall(_NAME, text))


def _path_with_entries(
    names: tuple[str, ...], seen: dict[tuple[str, ...], int]
) -> tuple[str | int, ...]:
    """Path of a table, with the index of the array entry it belongs to."""
    path: list[str | int] = []
    for depth, name in enumerate(names, 1):
        path.append(name)
        if names[:depth] in seen:
            path.append(seen[names[:depth]])
    return tuple(path)


def join_path(path: tuple[str | int, ...]) -> str:
    """Write a path as users do: ``trial[2].speed``."""
    text = ""
    for part in path:
        if isinstance(part, int):
            text += f"[{part}]"
        else:
            text = qualify(text, part)
    return text


def description_error(
    error: ValidationError,
    kind: type[BaseModel],
    *,
    where: str = "",
    text: str = "",
    path: tuple[str | int, ...] = (),
) -> DescriptionError:
    """Convert pydantic's report to one jounce error of at most five lines; ``path`` is the location of ``kind``."""
    every = error.errors()
    items = every[:_MOST_PROBLEMS]  # names are compared in pairs: quadratic time
    misspelt = [item for item in items if item["type"] == "extra_forbidden"]
    items = [
        item for item in items if not (item["type"] == "missing" and _is_misspelt(item, misspelt))
    ]
    items = [
        item for item in items if not (item["type"] == "too_short" and _is_within(item, items))
    ]
    problems = [_problem(item, kind, where, text, path) for item in items[:5]]
    if len(problems) == 1:
        return problems[0]
    lines: list[str] = [problem.message() for problem in problems]
    if len(items) > 5:
        lines.append(
            Phrase("(and {count} more)", count=len(items) - 5 + len(every[_MOST_PROBLEMS:]))
        )
    several = DescriptionError(Phrases("\n", lines))
    several.problems = problems
    return several


_MOST_PROBLEMS = 200


def _is_misspelt(item: Any, unknown_keys: list[Any]) -> bool:
    """Whether the same table has a similar unknown key, whose own message suffices."""
    *table, name = item["loc"]
    beside = [str(other["loc"][-1]) for other in unknown_keys if list(other["loc"][:-1]) == table]
    return isinstance(name, str) and bool(nearest(name, beside))


def _is_within(whole: Any, items: list[Any]) -> bool:
    """Whether a list is too short only because some of its entries are invalid."""
    depth = len(whole["loc"])
    return any(item["loc"][:depth] == whole["loc"] and len(item["loc"]) > depth for item in items)


def _problem(
    item: Any, kind: type[BaseModel], where: str, text: str, above: tuple[str | int, ...]
) -> DescriptionError:
    """Convert one problem to an error with its location."""
    within, models = _user_path(
        kind, item["loc"][:-1] if item["type"] == "extra_forbidden" else item["loc"]
    )
    path = (*above, *within, *(item["loc"][-1:] if item["type"] == "extra_forbidden" else ()))
    if item["type"] == "misplaced":
        path = (*path, *item["ctx"]["path"])
    line = line_of(text, path) if text else None
    place = below(at_line(where, line) if where else "", join_path(path))
    problem = DescriptionError(**_parts(item, path, models), where=place or kind.__name__)
    problem.path, problem.line = path, line
    return problem


def _parts(item: Any, path: tuple[str | int, ...], models: list[type[BaseModel]]) -> dict[str, Any]:
    """Parts of the error for a problem that pydantic reports: what, found, allowed and hint."""
    context = item.get("ctx", {})
    match item["type"]:
        case "extra_forbidden":
            fields = {
                field.alias or name
                for model in models
                for name, field in model.model_fields.items()
            }
            hint = nearest(str(path[-1]), fields)
            return {"what": "unknown key", "allowed": ", ".join(sorted(fields)), "hint": hint}
        case "missing":
            return {"what": "the key is missing and has no default"}
        case "union_tag_invalid":
            tags = [tag.strip(" '") for tag in context["expected_tags"].split(",")]
            named = context["discriminator"].strip("'")
            key = "kind" if named.endswith("()") else named
            what = Phrase("unknown {kind} {name}", kind=key, name=show_value(context["tag"]))
            return {"what": what, "allowed": ", ".join(tags), "hint": nearest(context["tag"], tags)}
        case "union_tag_not_found":
            return {
                "what": Phrase(
                    "the key {key}, which selects the kind, is missing",
                    key=context["discriminator"],
                )
            }
        case "misplaced":
            return dict(context["parts"])
        case "value_error" if isinstance(context["error"].args[0], Phrase):
            return {"what": context["error"].args[0]}
        case "value_error":
            return {"what": _of_pydantic(item)}
    parts: dict[str, Any] = {"what": _of_pydantic(item), "found": as_found(item["input"])}
    if item["type"] == "literal_error" and isinstance(item["input"], str):
        parts["hint"] = nearest(item["input"], re.findall(r"'([^']*)'", context["expected"]))
    return parts


def _of_pydantic(item: Any) -> str:
    """Message in pydantic's own words; only the most common ones are translated."""
    message = item["msg"].removeprefix("Value error, ")
    return f"{message[0].lower()}{message[1:]}"


def _user_path(
    kind: type[BaseModel], loc: tuple[str | int, ...]
) -> tuple[tuple[str | int, ...], list[type[BaseModel]]]:
    """Path as the user wrote it, without pydantic's own names, and the descriptions allowed there."""
    current: list[type[BaseModel]] = [kind]
    path: list[str | int] = []
    for part in loc:
        if isinstance(part, str) and part.startswith(("function-", "tagged-")):
            continue
        chosen = [model for model in current if len(current) > 1 and part in _tags(model)]
        if chosen:  # pydantic names the member of a union by its tag
            current = chosen
            continue
        path.append(part)
        if isinstance(part, str):
            step = [inner for model in current for inner in _models_of(_annotation(model, part))]
            current = step or current
    return tuple(path), current


def _tags(model: type[BaseModel]) -> set[str]:
    literals = (
        field.default
        for field in model.model_fields.values()
        if get_origin(field.annotation) is Literal
    )
    return {default for default in literals if isinstance(default, str)}


def _annotation(model: type[BaseModel], name: str) -> Any:
    for key, field in model.model_fields.items():
        if name in (key, field.alias):
            return field.annotation
    return None


def _models_of(annotation: Any) -> list[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        family = vars(annotation).get("kinds")
        return [*family.values()] if isinstance(family, Kinds) else [annotation]
    return [models for part in getattr(annotation, "__args__", ()) for models in _models_of(part)]
