"""Write docs/schemas: JSON schemas of all files that users write, made from the descriptions that read them.

Run ``python docs/make_schemas.py`` after a description has changed; a test compares the files with what this gives.
"""

from __future__ import annotations

import json
from functools import reduce
from operator import or_
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter

from jounce.campaign.description import Campaign
from jounce.control import CONTROLS
from jounce.core.kinds import FILE_REF
from jounce.inspection.limits import METHODS, Limits
from jounce.inspection.quantities import QUANTITIES
from jounce.inspection.record import NUMBERS, SIDES, TEXTS
from jounce.parts.files import RIGS, VEHICLES
from jounce.parts.testers import Tester
from jounce.roads import ROADS
from jounce.roads.loading import SCHEMA

FOLDER = Path(__file__).parent / "schemas"
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
    definitions = schema["$defs"]
    for curve in ("PolynomialCurve", "PowerCurve", "TableCurve"):
        definitions[curve]["required"] = ["kind", *definitions[curve]["required"]]
    for model in RIGS.values():
        definition = definitions[model.__name__]
        strut = definition["properties"]["strut"]["$ref"].rpartition("/")[2]
        definition["properties"]["bump_stop"] = {
            **definitions[strut]["properties"]["bump_stop"],
            "description": "the same as strut.bump_stop",
        }
        definition["required"] = ["schema", "model", *definition["required"]]
    return {"$schema": DIALECT, **schema, "title": "jounce rig file"}


def vehicle_schema() -> dict[str, Any]:
    """Schema of a vehicle file: any of the models; a corner of a 3-D car may be a name."""
    schema: dict[str, Any] = TypeAdapter(reduce(or_, VEHICLES.values())).json_schema(by_alias=True)
    definitions = schema["$defs"]
    for curve in ("PolynomialCurve", "PowerCurve", "TableCurve"):
        definitions[curve]["required"] = ["kind", *definitions[curve]["required"]]
    for model in VEHICLES.values():
        definition = definitions[model.__name__]
        definition["required"] = ["schema", "model", *definition["required"]]
    corner = definitions["SpatialAxle"]["properties"]["corner"]
    name = {"type": "string", "description": "name of a shipped rig, or path of a rig file"}
    definitions["SpatialAxle"]["properties"]["corner"] = {"anyOf": [name, corner]}
    return {"$schema": DIALECT, **schema, "title": "jounce vehicle file"}


def road_schema() -> dict[str, Any]:
    """Schema of a road file: one road table at top level, ``kind`` required."""
    schema = ROADS.adapter().json_schema(by_alias=True)
    for kind in ROADS.values():
        definition = schema["$defs"][kind.__name__]
        definition["properties"]["schema"] = {"const": SCHEMA}
        definition["required"] = ["kind", *definition.get("required", [])]
        if "of" in definition["properties"]:
            name = {"type": "string", "description": "in a campaign: the name of another of its roads"}
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


def control_schema() -> dict[str, Any]:
    """Schema of a control file: any of the laws, by any of the names that stand for it."""
    laws = {kind.law for kind in CONTROLS.values()}
    schema: dict[str, Any] = TypeAdapter(reduce(or_, sorted(laws, key=lambda law: law.__name__))).json_schema(
        by_alias=True
    )
    for law in laws:
        definition = schema["$defs"][law.__name__]
        names = [name for name, kind in CONTROLS.items() if kind.law is law]
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
        edge = {"type": ["number", "string"], "description": "with a unit, or bare: SI, degrees for angles; none: open"}
        definitions["Band"]["properties"][side] = edge
    for name in ("Criterion", "Condition", "DifferenceCriterion"):
        definitions[name]["properties"]["quantity"]["enum"] = list(QUANTITIES)
    return {"$schema": DIALECT, **schema, "title": "jounce limits file"}


def record_schema() -> dict[str, Any]:
    """Schema of the file beside a tester's record; further keys are kept and said."""
    texts: dict[str, Any] = {name: {"type": "string"} for name in TEXTS}
    texts["axle"] = {"enum": ["front", "rear"]}
    texts["date"] = {"description": "a date, or text"}
    texts["wheel_order"] = {"type": ["array", "string"], "items": {"enum": list(SIDES)}}
    numbers = {name: {"type": ["number", "string"], "description": f"in {si}"} for name, si in NUMBERS.items()}
    wheel = {"type": "object", "properties": numbers}
    properties = {**texts, **dict.fromkeys(SIDES, wheel)}
    return {"$schema": DIALECT, "title": "jounce header of a record", "type": "object", "properties": properties}


def _written(schema: Any) -> Any:
    """Keep the first paragraph of every description, the rest is written for Python; refer to other files."""
    if isinstance(schema, dict):
        return {
            "$ref" if key == FILE_REF else key: " ".join(value.split("\n\n")[0].split())
            if key == "description" and isinstance(value, str)
            else _written(value)
            for key, value in schema.items()
        }
    return [_written(item) for item in schema] if isinstance(schema, list) else schema


def texts() -> dict[str, str]:
    """Give all schemas: file name to text."""
    schemas = {"rig": rig_schema(), "vehicle": vehicle_schema(), "campaign": campaign_schema(), "road": road_schema()}
    schemas |= {"control": control_schema(), "tester": tester_schema(), "limits": limits_schema()}
    schemas["record"] = record_schema()
    return {
        f"{name}.schema.json": json.dumps(_written(schema), indent=1, allow_nan=False) + "\n"
        for name, schema in schemas.items()
    }


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    for file, text in texts().items():
        (FOLDER / file).write_text(text, encoding="utf-8")
