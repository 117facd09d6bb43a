"""Pages of the reference that are written when the documentation is built: Python names by subject, files key by key.

Names, their order and their texts come from ``jounce`` itself, the keys of files from ``schemas``, which ``make faces``
writes from the classes that read them.
"""

from __future__ import annotations

import inspect
import json
import re
import types
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jounce

FOLDER = Path(__file__).parent / "reference" / "api"
KEYS = Path(__file__).parent / "reference" / "keys"
SCHEMAS = Path(__file__).parent / "schemas"
SUBJECTS = {
    "parts": "Rigs, vehicles, testers: descriptions",
    "recordings": "Recordings",
    "roads": "Roads, excitations, trials",
    "roughness": "Roughness of roads",
    "control": "Controllers and actuators",
    "mechanics": "Mechanisms of your own: jn.mechanics",
    "simulation": "Runs, statics, modes, sensitivities",
    "kinematics": "Kinematics, loads, compliance, clearances",
    "kc": "Kinematics-and-compliance laboratory",
    "ride": "Ride comfort and road holding",
    "variants": "Many runs",
    "identify": "Identification and updating",
    "dampers": "Maps of dampers",
    "springs": "Maps of springs and bump stops",
    "campaign": "Bench campaigns",
    "analysis": "Analysis of records",
    "bench": "The bench",
    "testers": "Testers",
    "inspection": "Inspection of shock absorbers",
    "design": "Design",
    "exchange": "Other programs",
    "plots": "Pictures: jn.plots",
    "report": "Reports",
    "notebook": "Notebooks",
    "web": "The workbench",
    "papers": "Both papers",
    "operations": "Checks of files",
    "core": "Units, errors, findings",
}


def names() -> dict[str, list[tuple[str, Any]]]:
    """All public names of ``import jounce`` by package, with the names of public modules."""
    found: dict[str, list[tuple[str, Any]]] = {package: [] for package in SUBJECTS}
    for name in sorted(jounce.__all__, key=str.lower):
        value = getattr(jounce, name)
        if isinstance(value, types.ModuleType):
            inner = sorted(getattr(value, "__all__", ()), key=str.lower)
            found[value.__name__.split(".")[1]] += [
                (f"{name}.{word}", getattr(value, word)) for word in inner
            ]
        else:
            found[_module_of(value).split(".")[1]].append((name, value))
    return {package: members for package, members in found.items() if members}


def _module_of(value: Any) -> str:
    """Module in which an object is defined."""
    return str(inspect.unwrap(value).__module__)


def api_page(package: str, members: list[tuple[str, Any]]) -> str:
    """One page: a list of names, then each name with its docstring."""
    lines = [f"# {SUBJECTS[package]}", "", "| name | what it is |", "|---|---|"]
    lines += [f"| [`{name}`](#{_anchor(name)}) | {_summary(value)} |" for name, value in members]
    for name, value in members:
        lines += ["", f"({_anchor(name)})=", f"## {name}", ""]
        if inspect.isclass(value) or inspect.isfunction(value):
            directive = "autoclass" if inspect.isclass(value) else "autofunction"
            target = f"{_module_of(value)}.{value.__qualname__}"
            lines += ["```{eval-rst}", f".. {directive}:: {target}", "```"]
        else:
            lines += [f"A value: `{value!r:.300}`."]
    return "\n".join(lines) + "\n"


def _anchor(name: str) -> str:
    """Without capitals, as anchors are: ``Gradient`` and ``gradient`` are two."""
    kind = "class" if name.rpartition(".")[2][:1].isupper() else "name"
    return f"{kind}-{name.lower().replace('.', '-')}"


def _summary(value: Any) -> str:
    text = inspect.getdoc(value) if inspect.isclass(value) or inspect.isfunction(value) else ""
    first = " ".join((text or "").partition("\n\n")[0].split())
    return re.sub(r"``", "`", re.sub(r":\w+:`~?([^`]*)`", r"`\1`", first)).replace("|", "\\|")


def write_api() -> None:
    """Write one page per subject and their index; unchanged pages are not written."""
    FOLDER.mkdir(exist_ok=True)
    pages = {package: api_page(package, members) for package, members in names().items()}
    listed = "\n".join(pages)
    pages["index"] = (
        "# Python names\n\nEverything here is an attribute of `jounce`, by convention `import jounce as jn`. "
        f"Examples are run by the tests.\n\n```{{toctree}}\n:maxdepth: 1\n\n{listed}\n```\n"
    )
    for name, text in pages.items():
        _write(FOLDER / f"{name}.md", text)
    for file in FOLDER.glob("*.md"):
        if file.stem not in pages:
            file.unlink()


def _write(file: Path, text: str) -> None:
    if not file.is_file() or file.read_text(encoding="utf-8") != text:
        file.write_text(text, encoding="utf-8")


# --- files -----------------------------------------------------------------------------------------------------------


def files() -> dict[str, str]:
    """One page per kind of description: its tables and their keys, from its schema."""
    pages = {}
    for file in sorted(SCHEMAS.glob("*.schema.json")):
        kind = file.name.partition(".")[0]
        schema = json.loads(file.read_text(encoding="utf-8"))
        parts = [
            f"# Keys of a {kind} file",
            "",
            f"{{download}}`{file.name} </schemas/{file.name}>`",
            "",
        ]
        for title, table in _tables(schema):
            says = _text(table.get("description", ""))
            parts += [f"**{title}**" + (f": {says}" if says else ""), "", *_rows(table), ""]
        pages[kind] = "\n".join(parts) + "\n"
    return pages


def _tables(schema: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """The file itself, if it is one table, and every table in it."""
    if schema.get("properties"):
        yield "the file", schema
    for name, table in sorted(schema.get("$defs", {}).items()):
        if table.get("properties"):
            yield name, table


def _rows(table: dict[str, Any]) -> list[str]:
    lines = ["| key | value | default |", "|---|---|---|"]
    required = set(table.get("required", ()))
    for key, value in table["properties"].items():
        default = "required" if key in required else _default(value.get("default"))
        says = _text(value.get("description", ""))
        kind = _kind(value)
        lines.append(f"| `{key}` | {kind}{': ' if kind and says else ''}{says} | {default} |")
    return lines


def _default(value: Any) -> str:
    return (
        ""
        if value in (None, "", []) or isinstance(value, dict)
        else f"`{json.dumps(value)}`".replace("|", "\\|")
    )


def _text(words: str) -> str:
    said = re.sub(
        r"text with a unit that converts to (\S+), or a bare number in \1",
        r"in \1",
        " ".join(words.split()),
    )
    return re.sub(r"^in 1$", "number, or in %", said).replace("``", "`").replace("|", "\\|")


def _kind(value: dict[str, Any]) -> str:
    """Permitted values of a key, in words."""
    if "$ref" in value:
        return f"table `{value['$ref'].rpartition('/')[2]}`"
    if "const" in value:
        return f"`{json.dumps(value['const'])}`"
    if "enum" in value:
        return " or ".join(f"`{json.dumps(one)}`" for one in value["enum"]).replace("|", "\\|")
    choices = value.get("anyOf") or value.get("oneOf")
    if choices:
        if "unit that converts" in value.get("description", ""):
            return ""  # the description says it: text with a unit, or a number
        kinds = [_kind(one) for one in choices if one.get("type") != "null"]
        return " or ".join(dict.fromkeys(kind for kind in kinds if kind))
    if value.get("type") == "array":
        inner = _kind(value.get("items", {})) if isinstance(value.get("items"), dict) else ""
        return f"list of {inner}" if inner else "list"
    if value.get("type") == "object":
        inner = (
            _kind(value["additionalProperties"])
            if isinstance(value.get("additionalProperties"), dict)
            else ""
        )
        return f"table of {inner}" if inner else "table"
    return {
        "string": "text",
        "number": "number",
        "integer": "whole number",
        "boolean": "true or false",
    }.get(str(value.get("type", "")), "")


def write() -> None:
    """Write both."""
    write_api()
    KEYS.mkdir(exist_ok=True)
    for kind, text in files().items():
        _write(KEYS / f"{kind}.md", text)
