"""Write names for type checkers, JSON schemas for editors and tables for the docs from registries and command line.

``make faces`` runs this after an operation, a road, a controller or a description has changed: it writes the last part
of the stubs (``__init__.pyi``), the index of operations, ``docs/schemas`` and the quantities of the workbench's pages,
which are committed. The tables and the reference of the commands are written when the documentation is built.
"""

from __future__ import annotations

import builtins
import inspect
import json
import sys
import typing
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import fields, is_dataclass
from functools import reduce
from operator import or_
from pathlib import Path
from types import SimpleNamespace, UnionType
from typing import Any

import numpy as np
import typer
from pydantic import TypeAdapter

import jounce
from jounce.campaign.description import Campaign
from jounce.campaign.truth import BenchTruth
from jounce.cli.entry import application
from jounce.cli.everywhere import with_shared_options
from jounce.control import CONTROLS
from jounce.control.controller import FILE_CONTROLS
from jounce.core.display import display_unit
from jounce.core.kinds import FILE_REF
from jounce.core.results import marks_of
from jounce.design.kinematic_study import KinematicStudy
from jounce.design.optimisation_study import OptimisationStudy
from jounce.design.pareto import ParetoFront
from jounce.identify.decay import DecayEstimates
from jounce.identify.stiffness import TrialStiffness
from jounce.inspection.archive.history import Trend
from jounce.inspection.limits import Limits
from jounce.inspection.methods import METHODS, QUANTITIES
from jounce.inspection.quantities import NUMBERS as WHEEL_NUMBERS
from jounce.inspection.quantities import WheelQuantity
from jounce.inspection.record import NUMBERS, SIDES, TEXTS
from jounce.kinematics.catalogue import CATALOGUE as KINEMATIC_QUANTITIES
from jounce.kinematics.catalogue import Quantity
from jounce.mechanics.joints import Joint
from jounce.operations.describe import describe_operations
from jounce.parts.files import RIGS, VEHICLES
from jounce.parts.rig import Rig
from jounce.parts.testers import Tester
from jounce.recordings.readers import READERS
from jounce.ride.catalogue import CATALOGUE as RIDE_METRICS
from jounce.ride.study import MERITS
from jounce.roads import ROADS, Road
from jounce.roads.loading import SCHEMA
from jounce.roads.trial import Trial
from jounce.variants.study import SweepStudy
from jounce.web import command as _workbench  # noqa: F401 - it adds its command
from jounce.web.forms import Form, FormProblem
from jounce.web.project import Entry, Text, Version

DOCS = Path(__file__).parent
SCHEMAS = DOCS / "schemas"
TABLES = DOCS / "_generated"
SOURCE = Path(jounce.__file__).parent
DIALECT = "https://json-schema.org/draft/2020-12/schema"
BOUNDS = {
    "description": 'share of the start value to either side ("10 %"), or [lower, upper] with units',
    "anyOf": [
        {"type": "string"},
        {"type": "number"},
        {"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": ["number", "string"]}},
    ],
}
VALUE = {"type": ["number", "string", "boolean"]}


def rig_schema() -> dict[str, Any]:
    """Schema of a rig file: any of the models, ``model`` says which."""
    schema: dict[str, Any] = TypeAdapter(reduce(or_, RIGS.values())).json_schema(by_alias=True)
    _complete_models(schema["$defs"], RIGS.values())
    return {"$schema": DIALECT, "title": "jounce rig file", "required": ["schema"], **schema}


def vehicle_schema() -> dict[str, Any]:
    """Schema of a vehicle file: any of the models; a name can replace a corner or an axle of a 3-D car."""
    schema: dict[str, Any] = TypeAdapter(reduce(or_, VEHICLES.values())).json_schema(by_alias=True)
    _complete_models(schema["$defs"], [*RIGS.values(), *VEHICLES.values()])
    axle = schema["$defs"]["SpatialAxle"]["properties"]
    name = {"type": "string", "description": "name of a shipped rig, or path of a rig file"}
    for part in ("corner", "axle"):
        axle[part] = {"anyOf": [name, axle[part]]}
    return {"$schema": DIALECT, "title": "jounce vehicle file", "required": ["schema"], **schema}


def _complete_models(definitions: dict[str, Any], models: Iterable[type[Rig]]) -> None:
    """Describe the key that selects a class, keys that kinematics do not need, and the second place of a bump stop."""
    for curve in ("PolynomialCurve", "PowerCurve", "RotationalTableCurve", "TableCurve"):
        definitions[curve]["required"] = ["kind", *definitions[curve]["required"]]
    for model in models:
        definition = definitions.get(model.__name__)
        if definition is not None:
            left_out = (
                ("bodies", "strut", "tyre") if definition["properties"].pop("without", None) else ()
            )
            definition["required"] = [
                "model",
                *(name for name in definition["required"] if name not in left_out),
            ]
            if "strut" in definition["properties"]:
                strut = definition["properties"]["strut"]["$ref"].rpartition("/")[2]
                stop = definitions[strut]["properties"]["bump_stop"]
                definition["properties"]["bump_stop"] = {
                    **stop,
                    "description": "the same as strut.bump_stop",
                }


def road_schema() -> dict[str, Any]:
    """Schema of a road file: one road table at top level, ``kind`` required."""
    schema = ROADS.adapter().json_schema(by_alias=True)
    for kind in ROADS.values():
        definition = schema["$defs"][kind.__name__]
        definition["properties"]["schema"] = {"const": SCHEMA}
        definition["required"] = ["kind", *definition.get("required", [])]
        if "of" in definition["properties"]:
            name = {
                "type": "string",
                "description": "in a campaign: the name of another of its roads",
            }
            definition["properties"]["of"] = {"anyOf": [name, definition["properties"]["of"]]}
    return {"$schema": DIALECT, "title": "jounce road file", **schema}


def campaign_schema() -> dict[str, Any]:
    """Schema of a campaign file; its roads are those of road files."""
    schema = Campaign.model_json_schema(by_alias=True)
    definitions = schema["$defs"]
    schema["properties"]["roads"]["additionalProperties"] = {FILE_REF: ROADS.schema}
    definitions["UpdateEntry"]["properties"]["free"]["additionalProperties"] = BOUNDS
    definitions["TrialEntry"]["properties"]["changes"]["additionalProperties"] = VALUE
    return {"$schema": DIALECT, **schema, "title": "jounce campaign file"}


def truth_schema() -> dict[str, Any]:
    """Schema of a truth file; it may change any value of its rig."""
    schema = BenchTruth.model_json_schema(by_alias=True)
    return {"$schema": DIALECT, **schema, "title": "jounce truth file"}


def control_schema() -> dict[str, Any]:
    """Schema of a control file: any of the laws, by any of its names."""
    known = {**CONTROLS, **FILE_CONTROLS}
    laws = {kind.law for kind in known.values()}
    schema: dict[str, Any] = TypeAdapter(
        reduce(or_, sorted(laws, key=lambda law: law.__name__))
    ).json_schema(by_alias=True)
    for law in laws:
        definition = schema["$defs"][law.__name__]
        names = [name for name, kind in known.items() if kind.law is law]
        definition["properties"]["law"] = {"enum": names}
        definition["required"] = ["schema", "law"]
    return {"$schema": DIALECT, **schema, "title": "jounce control file"}


def tester_schema() -> dict[str, Any]:
    """Schema of a tester file."""
    schema = Tester.model_json_schema(by_alias=True)
    schema["required"] = ["schema", *schema["required"]]
    return {"$schema": DIALECT, **schema, "title": "jounce tester file"}


def limits_schema() -> dict[str, Any]:
    """Schema of a limits file: edges of bands have the unit of their quantity, or none."""
    schema = Limits.model_json_schema(by_alias=True)
    schema["required"] = ["schema", *schema["required"]]
    schema["properties"]["methods"]["propertyNames"] = {"enum": list(METHODS)}
    definitions = schema["$defs"]
    for side in ("from", "to"):
        edge = {
            "type": ["number", "string"],
            "description": "with a unit, or bare: SI, degrees for angles; none: open",
        }
        definitions["VerdictBand"]["properties"][side] = edge
    for name in ("Criterion", "Condition", "DifferenceCriterion"):
        definitions[name]["properties"]["quantity"]["enum"] = list(QUANTITIES)
    return {"$schema": DIALECT, **schema, "title": "jounce limits file"}


def record_schema() -> dict[str, Any]:
    """Schema of the TOML file of a tester's record; unknown keys are stored and reported."""
    texts: dict[str, Any] = {name: {"type": "string"} for name in TEXTS}
    texts["axle"] = {"enum": ["front", "rear"]}
    texts["date"] = {"description": "a date, or text"}
    texts["wheel_order"] = {"type": ["array", "string"], "items": {"enum": list(SIDES)}}
    numbers = {
        name: {"type": ["number", "string"], "description": f"in {si}"}
        for name, si in NUMBERS.items()
    }
    wheel = {"type": "object", "properties": numbers}
    properties = {**texts, **dict.fromkeys(SIDES, wheel)}
    return {
        "$schema": DIALECT,
        "title": "jounce header of a record",
        "type": "object",
        "properties": properties,
    }


def _written(schema: Any) -> Any:
    """Keep the first paragraph of every description, as the others concern Python; refer to other files."""
    if isinstance(schema, dict):
        return {
            "$ref" if key == FILE_REF else key: " ".join(value.split("\n\n")[0].split())
            if key == "description" and isinstance(value, str)
            else _written(value)
            for key, value in schema.items()
        }
    return [_written(item) for item in schema] if isinstance(schema, list) else schema


def _shared(own: dict[str, Any], other: dict[str, Any]) -> set[str]:
    """Names of the definitions that two schemas share, with everything that they refer to."""
    found = {name for name, definition in own.items() if other.get(name) == definition}
    while lost := {
        name for name in found if not {ref.rpartition("/")[2] for ref in _refs(own[name])} <= found
    }:
        found -= lost
    return found


def _refs(schema: Any) -> Iterator[str]:
    if isinstance(schema, dict):
        for key, value in schema.items():
            yield from [value] if key == "$ref" else _refs(value)
    elif isinstance(schema, list):
        for item in schema:
            yield from _refs(item)


def _redirected(schema: Any, places: dict[str, str]) -> Any:
    """Refer to the definitions of other files."""
    if isinstance(schema, dict):
        return {key: _redirected(value, places) for key, value in schema.items()}
    if isinstance(schema, list):
        return [_redirected(item, places) for item in schema]
    return places.get(schema, schema) if isinstance(schema, str) else schema


def design_schema() -> dict[str, Any]:
    """Schema of a study file of hardpoints from targets."""
    schema = KinematicStudy.model_json_schema(by_alias=True)
    schema["required"] = ["schema", *(name for name in schema["required"] if name != "schema")]
    return {"$schema": DIALECT, "title": "jounce design study file", **schema}


def sweep_schema() -> dict[str, Any]:
    """Schema of a sweep; the ranges of a number have its unit."""
    schema = SweepStudy.model_json_schema(by_alias=True)
    schema["required"] = ["schema", *(name for name in schema["required"] if name != "schema")]
    trial = Trial.model_json_schema(by_alias=True)
    properties = {
        name: one
        for name, one in trial["properties"].items()
        if name not in ("road", "right", "excitation")
    }
    road = {"anyOf": [{"type": "string"}, {FILE_REF: ROADS.schema}]}
    file = {
        "type": ["string", "object"],
        "description": "a recording with time and road.z, or {file = ..., ...}",
    }
    schema["properties"]["trial"] |= {
        "properties": {"road": road, "right": road, "excitation": file, **properties},
        "additionalProperties": False,
    }
    schema["$defs"] |= {
        name: one
        for name, one in trial["$defs"].items()
        if any(name in ref for ref in _refs(properties))
    }
    number = {"type": ["number", "string"]}
    schema["properties"]["vary"]["additionalProperties"] = {
        "description": '"20 %", [values], or {mean, sd} or {low, mode, high} with units',
        "anyOf": [
            {"type": "string"},
            {"type": "array", "minItems": 1, "items": number},
            {"type": "object", "additionalProperties": number},
        ],
    }
    return {"$schema": DIALECT, "title": "jounce sweep file", **schema}


def optimisation_schema() -> dict[str, Any]:
    """Schema of a study of the best design or of a front."""
    schema = OptimisationStudy.model_json_schema(by_alias=True)
    schema["required"] = ["schema", *(name for name in schema["required"] if name != "schema")]
    return {"$schema": DIALECT, "title": "jounce optimisation study file", **schema}


def schemas() -> dict[str, str]:
    """All schemas: file name to text. Later files refer to definitions in earlier ones."""
    makers = {
        "rig": rig_schema,
        "vehicle": vehicle_schema,
        "road": road_schema,
        "campaign": campaign_schema,
        "truth": truth_schema,
    }
    makers |= {
        "control": control_schema,
        "tester": tester_schema,
        "limits": limits_schema,
        "record": record_schema,
    }
    makers |= {"design": design_schema, "sweep": sweep_schema, "optimisation": optimisation_schema}
    found: dict[str, Any] = {}
    for kind, make in makers.items():
        schema, name = _written(make()), f"{kind}.schema.json"
        for other, earlier in found.items():
            shared = _shared(schema.get("$defs", {}), earlier.get("$defs", {}))
            for each in shared:
                del schema["$defs"][each]
            schema = _redirected(
                schema, {f"#/$defs/{each}": f"{other}#/$defs/{each}" for each in shared}
            )
        found[name] = schema
    return {
        name: json.dumps(schema, indent=1, allow_nan=False) + "\n" for name, schema in found.items()
    }


INDEX = SOURCE / "operations" / "index.json"


def operations_index() -> str:
    """Operations as their functions describe them, for faces that import none of these."""
    return json.dumps(describe_operations(), indent=1, ensure_ascii=False) + "\n"


PAGE_QUANTITIES = DOCS.parent / "viewer" / "src" / "workbench" / "quantities.json"


def page_quantities() -> str:
    """Quantities of the workbench's pages with labels and units: of wheels, rides, decays and stiffnesses."""

    def said(part: Any) -> str:
        return part(SimpleNamespace(motion="translation")) if callable(part) else part

    def estimates(result: type) -> dict[str, Any]:
        marks = marks_of(result)
        return {
            name: (said(mark.label), *_shown(said(mark.unit)))
            for name, mark in marks.items()
            if mark.unit
        }

    units = {row.unit for row in RIDE_METRICS} | {"kg", "kg*m^2", "N/m", "N*s/m", "rad"}
    found = {
        "inspection": [
            (row.name, row.english, row.german, row.unit or "–", row.factor)
            for row in WHEEL_NUMBERS.values()
        ],
        "merits": [(row.name, row.label, *_shown(row.unit)) for row in MERITS],
        "units": {si: _shown(si) for si in sorted(units)},
        "estimates": {"decay": estimates(DecayEstimates), "stiffness": estimates(TrialStiffness)},
    }
    return json.dumps(found, indent=1, ensure_ascii=False) + "\n"


ANSWERS = PAGE_QUANTITIES.with_name("answers.ts")
ANSWERED = (
    Entry,
    Text,
    Version,
    FormProblem,
    Form,
    ParetoFront,
    Trend,
)


def page_answers() -> str:
    """Types of answers that pages read: the fields of results, written for TypeScript."""
    kinds, written = list(ANSWERED), []
    for kind in kinds:  # grows by the classes of their fields
        lines = [
            f"  {one.name}: {_typescript(_hint(kind, one.type), kinds)};" for one in fields(kind)
        ]
        written.append("\n".join([f"export interface {kind.__name__} {{", *lines, "}"]))
    head = "/** Answers of the server: the fields of results in Python, written by `make faces`. */"
    return "\n\n".join([head, *written]) + "\n"


class _Names(dict[str, Any]):
    """Names of a module and of typing; a name imported only for type checkers means any type."""

    def __missing__(self, name: str) -> Any:
        return getattr(typing, name, getattr(builtins, name, Any))


def _hint(kind: type, annotation: Any) -> Any:
    names = _Names(vars(sys.modules[kind.__module__]))
    return eval(annotation, {}, names) if isinstance(annotation, str) else annotation  # noqa: S307 - our own source


def _typescript(hint: Any, kinds: list[type]) -> str:
    """Write a type for TypeScript; a dataclass is written by its name and added to the types to write."""
    plain = {
        str: "string",
        bool: "boolean",
        int: "number",
        float: "number",
        type(None): "null",
        None: "null",
    }
    origin, parts = typing.get_origin(hint), typing.get_args(hint)
    if origin is typing.Annotated:
        return _typescript(parts[0], kinds)
    if origin is typing.Literal:
        return " | ".join(json.dumps(part) for part in parts)
    if origin in (typing.Union, UnionType):
        return " | ".join(_typescript(part, kinds) for part in parts)
    if origin is np.ndarray:
        return "number[]"
    if isinstance(origin, type) and issubclass(origin, Mapping):
        return f"Record<string, {_typescript(parts[1], kinds)}>"
    if isinstance(origin, type) and issubclass(origin, Sequence):
        several = [part for part in parts if part is not Ellipsis]
        if len(several) > 1:
            return f"[{', '.join(_typescript(part, kinds) for part in several)}]"
        item = _typescript(several[0], kinds)
        return f"({item})[]" if " " in item and "<" not in item else f"{item}[]"
    if is_dataclass(hint) and isinstance(hint, type):
        if hint not in kinds:
            kinds.append(hint)
        return hint.__name__
    return plain.get(hint, "unknown")


def _shown(si: str) -> tuple[str, float]:
    """Name and conversion factor of the display unit for an SI unit."""
    unit = display_unit(si)
    return unit.name or "–", unit.factor


def committed() -> dict[Path, str]:
    """Give all files that are committed: stubs, the index of operations, schemas and quantities of the pages."""
    written = {
        **stubs(),
        INDEX: operations_index(),
        PAGE_QUANTITIES: page_quantities(),
        ANSWERS: page_answers(),
    }
    return written | {SCHEMAS / name: text for name, text in schemas().items()}


STUB_PART = "# isort: split\n# Written by `make faces`: members of the registries."


def stubs() -> dict[Path, str]:
    """Stubs with the members of the registries after the hand-written part: file to text."""
    roads = list(ROADS.values())
    laws = {control.law for control in (*CONTROLS.values(), *FILE_CONTROLS.values())}
    members = {
        SOURCE / "__init__.pyi": [*roads, *laws],
        SOURCE / "roads" / "__init__.pyi": roads,
        SOURCE / "control" / "__init__.pyi": list(laws),
    }
    found = {}
    for file, classes in members.items():
        package = ".".join(["jounce", *file.parent.relative_to(SOURCE).parts])
        modules = {kind.__name__: kind.__module__.removeprefix(package) for kind in classes}
        written = file.read_text(encoding="utf-8").replace(STUB_PART, "").splitlines()
        by_hand = [
            line
            for line in written
            if not line.startswith("from ") or line.split()[-1] not in modules
        ]
        lines = (
            f"from {modules[name]} import {name} as {name}"
            for name in sorted(modules, key=_as_ruff_sorts)
        )
        found[file] = "\n".join(
            ["\n".join(by_hand).rstrip(), "", STUB_PART, *sorted(lines, key=_module), ""]
        )
    return found


def _module(line: str) -> str:
    return line.split()[1]


def _as_ruff_sorts(name: str) -> tuple[bool, str]:
    """Sort names in capitals first."""
    return not name.isupper(), name.lower()


def tables() -> dict[str, str]:
    """Tables of the registries for the pages that include them: file name to text in Markdown."""
    needs = {"rack": "tie rod", "axis": "steering axis", "bar": "anti-roll bar"}
    needs["stiffness"] = "tyre stiffness, or curve and `undeformed_radius`"

    def positive(row: Quantity) -> str:
        return row.sign.removeprefix("positive: ")

    return {
        "roads.md": _table(("`kind`", "keys", "what it is"), _road_rows()),
        "readers.md": _table(
            ("format", "suffixes", "extra"),
            [
                (row.label, _codes(row.suffixes), f"`{row.extra}`" if row.extra else "")
                for row in READERS
            ],
        ),
        "ride-metrics.md": _table(
            ("metric", "unit", "what it is", "what it is not"),
            [(f"`{row.name}`", row.unit, row.label, row.is_not) for row in RIDE_METRICS],
        ),
        "kinematic-quantities.md": _table(
            ("name", "unit", "what", "positive", "clause", "needs"),
            [
                (
                    f"`{row.name}`",
                    row.unit,
                    row.long_name,
                    positive(row),
                    row.clause,
                    needs.get(row.needs, ""),
                )
                for row in KINEMATIC_QUANTITIES
            ],
        ),
        "joints.md": _table(
            ("joint", "takes", "coordinates", "what it is", "hangs", "closes"), _joint_rows()
        ),
        "inspection-methods.md": _table(
            ("method", "plates", "shipped tester", "graded values"),
            [
                (
                    f"`{key}`",
                    " and ".join(row.plates),
                    f"`{row.tester}`",
                    ", ".join(_graded(QUANTITIES[name]) for name in row.numbers),
                )
                for key, row in METHODS.items()
            ],
        ),
        "controllers.md": _table(
            ("name", "class", "what it does"),
            [
                (f"`{name}`", f"`{control.law.__name__}`", control.summary)
                for name, control in CONTROLS.items()
            ],
        ),
    }


def _joint_rows() -> Iterator[tuple[str, ...]]:
    """Every class of joint; those that cannot attach a body come last."""
    for joint in sorted(_kinds_of(Joint), key=lambda one: not one.hangs):
        coordinates = [f"`.{tag}` ({unit})" for tag, unit in joint.coordinates]
        numbers = [
            (one.name, one.metadata["unit"]) for one in fields(joint) if "read" in one.metadata
        ]
        takes = ", ".join(
            f"`{name}`" if unit == "1" else f"`{name}` ({unit})" for name, unit in numbers
        )
        quaternion = (
            ["quaternion `.e0` to `.e3` against the ground"] if joint.has_quaternion else []
        )
        says = (inspect.getdoc(joint) or "").partition("\n\n")[0].replace("\n", " ")
        answers = ("yes" if joint.hangs else "no", "yes" if joint.closes else "no")
        shown = ", ".join([*coordinates, *quaternion]) or "none"
        yield (f"`{joint.__name__}`", takes or "none", shown, says, *answers)


def _kinds_of(base: type[Joint]) -> list[type[Joint]]:
    found = [one for kind in base.__subclasses__() for one in (kind, *_kinds_of(kind))]
    return [one for one in found if one.kind]


def _graded(row: WheelQuantity) -> str:
    return f"{row.english} `{row.name}`" + (f" [{row.unit}]" if row.unit else "")


def _road_rows() -> Iterator[tuple[str, str, str]]:
    """Kind, own keys (optional ones in brackets) and first sentence of every road, module by module."""
    shared = {"kind", "start", "recurrence"}
    order = ("obstacles", "waves", "rough", "measured")  # other modules behind them
    places = {name: place for place, name in enumerate(order)}

    def place(item: tuple[str, type[Road]]) -> tuple[int, str, int]:
        module = item[1].__module__.rpartition(".")[2]
        return places.get(module, len(places)), module, inspect.getsourcelines(item[1])[1]

    for word, road in sorted(ROADS.items(), key=place):
        fields = {
            field.alias or name: field
            for name, field in road.model_fields.items()
            if name not in shared
        }
        keys = ", ".join(
            f"`{name}`" if field.is_required() else f"[`{name}`]" for name, field in fields.items()
        )
        summary = (road.__doc__ or "").strip().split("\n\n")[0]
        yield f"`{word}`", keys, " ".join(summary.split()).replace("``", "`")


def _codes(words: Iterable[str]) -> str:
    return ", ".join(f"`{word}`" for word in words)


def _table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = [
        header,
        ["---"] * len(header),
        *([cell.replace("|", "\\|") for cell in row] for row in rows),
    ]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def commands() -> dict[str, str]:
    """Reference of every command by its full name, e.g. ``jounce fit decay``: its help, arguments and options."""
    found: dict[str, str] = {}
    pending: list[tuple[str, Any]] = [
        ("jounce", with_shared_options(typer.main.get_command(application())))
    ]
    while pending:
        name, command = pending.pop()
        inner = getattr(command, "commands", {})
        pending += [(f"{name} {word}", item) for word, item in inner.items()]
        if not inner:
            text = inspect.cleandoc(command.help).partition("Example:")[0]
            rows = [_option(item) for item in command.params if not {*item.opts} & _EVERYWHERE]
            found[name] = text + (_table(("option", "", "default"), rows) if rows else "")
    return found


_EVERYWHERE = {"--json", "--force", "--help", "--open", "--all", "--units"}


def _option(item: Any) -> tuple[str, str, str]:
    """Name with its value, help and default of an argument or option."""
    is_flag = getattr(item, "is_flag", False)
    names = "/".join([*item.opts, *item.secondary_opts]) if item.param_type_name == "option" else ""
    value = item.metavar or (item.name.upper() if names == "" else "" if is_flag else "VALUE")
    default = (
        ""
        if item.default in (None, "") or is_flag or not item.show_default
        else f"`{item.default}`"
    )
    words = (getattr(item, "help", None) or "").replace("\\[", "[")
    return (
        f"`{' '.join(filter(None, (names, value)))}`",
        words,
        "required" if item.required else default,
    )


def write_tables() -> None:
    """Write tables and references for the build of the documentation."""
    TABLES.mkdir(exist_ok=True)
    references = {f"{name.replace(' ', '-')}.md": text for name, text in commands().items()}
    for name, text in {**tables(), **references}.items():
        if not (TABLES / name).is_file() or (TABLES / name).read_text(encoding="utf-8") != text:
            (TABLES / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    for file, text in committed().items():
        file.write_text(text, encoding="utf-8")
