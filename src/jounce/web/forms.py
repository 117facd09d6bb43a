"""A rig's text as a form: its schema, its values, and changes of single values that keep all comments."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from difflib import unified_diff
from functools import cache
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import tomlkit
from tomlkit.exceptions import TOMLKitError

from jounce.core.commands import command_line
from jounce.core.description import join_path, toml_error, toml_table
from jounce.core.errors import DescriptionError, JounceError
from jounce.core.files import only_below
from jounce.core.phrases import Phrase
from jounce.core.usual_units import usual_unit
from jounce.web.answers import changed_by, describe_rig, rig_in, word
from jounce.web.project import Project

if TYPE_CHECKING:
    from jounce.parts import Rig

Key = str | int


_ROUNDING = 4e-16
"""Of a conversion: 141 mm and 0.141 m are the same length, though their last bits differ; a page writes 141 mm."""


@dataclass(frozen=True)
class FormProblem:
    """A problem of a text: path of the value (empty for the whole text), line (0 for none), message."""

    path: str
    line: int
    text: str
    german: str | None


@dataclass(frozen=True)
class Form:
    """A rig's text with its parsed content.

    ``values`` are the values as typed, ``rig`` the parameters by path if the text is valid, ``changed`` the lines
    that differ from the saved file, ``notes`` the units in which bare numbers were read, ``python`` code for the same
    edit or view, ``command`` a command that shows the saved file.
    """

    text: str
    values: dict[str, Any]
    model: str
    problems: tuple[FormProblem, ...] = ()
    rig: dict[str, Any] | None = None
    changed: tuple[str, ...] = field(default=())
    notes: tuple[FormProblem, ...] = ()
    python: str = ""
    command: str = ""


@cache
def schema(model: str) -> dict[str, Any]:
    """Return the JSON schema of a model of rigs or vehicles."""
    from jounce.core.errors import unknown
    from jounce.parts.files import RIGS, VEHICLES

    models = {**RIGS, **VEHICLES}
    if model not in models:
        raise unknown(model, models, what="model", where="model")
    plain: dict[str, Any] = models[model].model_json_schema(by_alias=True)
    plain["properties"].pop("without", None)  # a text omits these parts instead of listing them
    return plain


def form_of(
    project: Project,
    path: str,
    text: str,
    sets: Sequence[tuple[Sequence[Key], Any]] = (),
    changes: Mapping[str, Any] | None = None,
) -> Form:
    """Parse a text as the present or future content of the file at that path.

    ``sets`` first assigns values as typed to keys (``None`` removes a key); ``changes`` then assigns numbers (SI or
    with units) to paths.
    """
    file = project.inside(path)
    notes: list[FormProblem] = []
    try:
        for keys, value in sets:
            text = _with_value(text, keys, _with_unit(text, keys, value, notes))
        values = toml_table(text)
    except tomllib.TOMLDecodeError as error:
        return Form(text, {}, "", _problems(toml_error(error, ""), {}))
    model = str(values.get("model", ""))
    saved = project.read(path).text if file.is_file() else ""
    try:
        with only_below(project.root):
            rig = rig_in(project, path, text)
            if changes:
                from jounce.parts.files import changed_text

                now = rig.with_changes(dict(changes)).parameters()
                given = {path: now[path] for path in changes}
                text = changed_text(text, rig, given, rounding=_ROUNDING)
                values, rig = toml_table(text), rig_in(project, path, text)
            numbers, python = describe_rig(rig, path), _python(project, path, saved, rig)
    except JounceError as error:
        problems, differing = _problems(error, values), _differing(saved, text)
        return Form(text, values, model, problems, None, differing, tuple(notes))
    is_saved = text == saved.replace("\r\n", "\n")  # a command can only read the saved file
    command = command_line(["jounce", "check", word(path)]) if is_saved else ""
    differing = _differing(saved, text)
    return Form(text, values, model, (), numbers, differing, tuple(notes), python, command)


def _with_unit(text: str, keys: Sequence[Key], value: Any, notes: list[FormProblem]) -> Any:
    """Return a bare number with the usual unit of its file, and note it; other values are unchanged."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return value
    values = toml_table(text)
    try:
        si = _si_at(schema(str(values.get("model", ""))), keys)
    except JounceError:
        return value
    unit = usual_unit(values, keys, float(value), si) if si and si != "1" else ""
    if not unit or value == 0:
        return value
    note = Phrase("{number:.10g} is read as {number:.10g} {unit}; write a unit to mean another.",
                  number=value, unit=unit)  # fmt: skip
    notes.append(FormProblem(join_path(tuple(keys)), 0, note, note.german()))
    return f"{value:.10g} {unit}"


_SI = re.compile(r"bare number in (\S+)")


def _si_at(model: Mapping[str, Any], keys: Sequence[Key]) -> str:
    """Return the SI unit of the value at some keys of a schema; empty if it has none."""
    choices: list[Any] = [model]

    def resolved(part: Mapping[str, Any]) -> list[Any]:
        if "$ref" in part:
            return resolved(model["$defs"][part["$ref"].rpartition("/")[2]])
        inner = [*part.get("anyOf", []), *part.get("oneOf", [])]
        return [part, *(choice for one in inner for choice in resolved(one))]

    for key in keys:
        parts = [part for choice in choices for part in resolved(choice)]
        if isinstance(key, int):
            fixed = [part.get("prefixItems", [])[key : key + 1] for part in parts]
            choices = [item for items in fixed for item in items]
            choices += [part["items"] for part in parts if isinstance(part.get("items"), dict)]
        else:
            choices = [
                part["properties"][key] for part in parts if key in part.get("properties", {})
            ]
    said = [_SI.search(part.get("description", "")) for c in choices for part in resolved(c)]
    return next((match[1] for match in said if match is not None), "")


def _with_value(text: str, keys: Sequence[Key], value: Any) -> str:
    """Set or remove the value at a sequence of keys; the remaining text is unchanged."""
    if not keys:
        raise DescriptionError("no key is given", where="sets")
    try:
        document = tomlkit.parse(text)
        here: Any = document
        for key, following in pairwise(keys):
            if isinstance(key, str) and key not in here:
                here[key] = tomlkit.array() if isinstance(following, int) else tomlkit.table()
            here = here[key]
        last = keys[-1]
        if value is None:
            here.pop(last)
        elif isinstance(last, int) and last == len(here):
            here.append(value)
        else:
            here[last] = value
    except TOMLKitError as error:
        raise tomllib.TOMLDecodeError(str(error)) from None
    except (KeyError, IndexError, TypeError, AttributeError):
        place = ".".join(map(str, keys))
        raise DescriptionError("no such key in this text", where=place) from None
    written: str = tomlkit.dumps(document)
    toml_table(written)  # checks that it can be parsed again
    return written


def _python(project: Project, path: str, saved: str, rig: Rig) -> str:
    """Return Python code that applies the text's changes to the saved file, if only numbers changed."""
    load = f"import jounce as jn\n\nrig = jn.load({path!r})"
    try:
        before = rig_in(project, path, saved)
        if before == rig:
            return f"{load}\nprint(rig)\n"
        known = before.parameters()
        changes = {
            name: value for name, value in rig.parameters().items() if known.get(name) != value
        }
        if before.with_changes(changes) == rig:
            return f"{load}{changed_by(changes)}\njn.save(rig, {path!r}, force=True)\n"
    except JounceError:
        pass  # not saved yet, or different parts
    return f"{load}  # once it is saved: more than numbers is changed\nprint(rig)\n"


def _problems(error: JounceError, values: Mapping[str, Any]) -> tuple[FormProblem, ...]:
    """Return the problems of an error, each at its value; if that is not in the text, the message names it."""
    problems = []
    for each in error.problems or (error,):
        path = join_path(each.path) or (
            each.where if each.where.partition(".")[0].partition("[")[0] in values else ""
        )
        text = each.message(placed=not path)
        problems.append(FormProblem(path, each.line or 0, text, text.german()))
    return tuple(problems)


def _differing(before: str, after: str) -> tuple[str, ...]:
    """Return removed and added lines with their context, as in a unified diff."""
    lines = unified_diff(before.splitlines(), after.splitlines(), lineterm="", n=2)
    return tuple(line for line in lines if not line.startswith(("---", "+++")))
