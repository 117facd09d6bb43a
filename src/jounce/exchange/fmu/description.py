"""XML files and documentation page of an FMU, generated from one list of variables."""

from __future__ import annotations

import html
import math
from dataclasses import dataclass
from xml.etree import ElementTree as ET

from jounce.core.units import base_units
from jounce.exchange.fmu.variables import ModelVariable, Variables

FILE = "model"
"""Name of the binary in the archive."""
STEP = 1e-3  # s, suggested communication step: the output step of simulate


@dataclass(frozen=True)
class Head:
    """Header of the model description: name and text of the model, the tool, and the token that identifies its code."""

    name: str
    text: str
    tool: str
    token: str
    adjoint: bool
    sources: bool


def _text(value: float | bool) -> str:
    return str(value).lower() if isinstance(value, bool) else repr(float(value))


def _attributes(variable: ModelVariable) -> dict[str, str]:
    """Return attributes common to FMI 2.0 and 3.0."""
    attributes = {"name": variable.name, "valueReference": str(variable.reference)}
    if variable.text:
        attributes["description"] = variable.text
    attributes |= {"causality": variable.causality, "variability": variable.variability}
    if variable.initial:
        attributes["initial"] = variable.initial
    return attributes


def _number(variable: ModelVariable) -> dict[str, str]:
    """Return unit, range and start value."""
    number = {} if variable.is_boolean or not variable.unit else {"unit": variable.unit}
    for name, value in (("min", variable.least), ("max", variable.most), ("start", variable.start)):
        if value is not None:
            number[name] = _text(value)
    return number


def _units(variables: Variables) -> list[ET.Element]:
    """Return units with their base powers; display units are mm and degrees."""
    units = []
    for name in sorted({v.unit for v in variables.everything if v.unit and not v.is_boolean}):
        element = ET.Element("Unit", name=name)
        ET.SubElement(
            element, "BaseUnit", {base: str(power) for base, power in base_units(name).items()}
        )
        if name == "m":
            ET.SubElement(element, "DisplayUnit", name="mm", factor="1000.0")
        if name == "rad":
            ET.SubElement(element, "DisplayUnit", name="deg", factor=repr(180.0 / math.pi))
        units.append(element)
    return units


def _common(root: ET.Element, variables: Variables) -> ET.Element:
    """Add units, log categories and default experiment; return the element of the variables."""
    ET.SubElement(root, "UnitDefinitions").extend(_units(variables))
    categories = ET.SubElement(root, "LogCategories")
    for name in ("logStatusWarning", "logStatusError"):
        ET.SubElement(categories, "Category", name=name)
    ET.SubElement(
        root,
        "DefaultExperiment",
        startTime="0",
        stopTime="1",
        tolerance="1e-5",
        stepSize=repr(STEP),
    )
    return ET.SubElement(root, "ModelVariables")


def description(version: int, variables: Variables, head: Head) -> bytes:
    """Return the content of ``modelDescription.xml``."""
    return _to_xml((_fmi2 if version == 2 else _fmi3)(variables, head))


def _fmi3(variables: Variables, head: Head) -> ET.Element:
    root = ET.Element(
        "fmiModelDescription", fmiVersion="3.0", modelName=head.name, instantiationToken=head.token,
        description=head.text, generationTool=head.tool, variableNamingConvention="structured",
    )  # fmt: skip
    can = {"modelIdentifier": FILE, "canGetAndSetFMUState": "true", "canSerializeFMUState": "true"}
    can |= {
        "providesDirectionalDerivatives": "true",
        "providesAdjointDerivatives": _text(head.adjoint),
    }
    ET.SubElement(root, "ModelExchange", {**can, "needsCompletedIntegratorStep": "true"})
    ET.SubElement(root, "CoSimulation", {**can, "canHandleVariableCommunicationStepSize": "true"})
    table = _common(root, variables)
    for v in variables.everything:
        more = {} if v.derivative is None else {"derivative": str(v.derivative)}
        ET.SubElement(
            table,
            "Boolean" if v.is_boolean else "Float64",
            {**_attributes(v), **more, **_number(v)},
        )
    structure = ET.SubElement(root, "ModelStructure")
    # Some importers refuse unknowns without dependencies; initially all depend on inputs and parameters.
    known = [
        v
        for v in variables.everything
        if v.causality in ("input", "parameter") and not v.is_boolean
    ]
    whole = " ".join(str(v.reference) for v in known)
    groups = {
        "Output": variables.outputs,
        "ContinuousStateDerivative": variables.derivatives,
        "InitialUnknown": variables.unknown_at_start,
        "EventIndicator": variables.indicators,
    }
    for kind, group in groups.items():
        for v in group:
            follows = whole if kind == "InitialUnknown" else " ".join(map(str, v.depends or ()))
            ET.SubElement(structure, kind, valueReference=str(v.reference), dependencies=follows)
    return root


def _fmi2(variables: Variables, head: Head) -> ET.Element:
    root = ET.Element(
        "fmiModelDescription", fmiVersion="2.0", modelName=head.name, guid=head.token, description=head.text,
        generationTool=head.tool, variableNamingConvention="structured",
        numberOfEventIndicators=str(len(variables.indicators)),
    )  # fmt: skip
    can = {"modelIdentifier": FILE, "canGetAndSetFMUstate": "true", "canSerializeFMUstate": "true"}
    can["providesDirectionalDerivative"] = "true"
    steps = {"canHandleVariableCommunicationStepSize": "true", "canInterpolateInputs": "true"}
    for use, more in (("ModelExchange", {}), ("CoSimulation", steps)):
        element = ET.SubElement(root, use, {**can, **more})
        if head.sources:
            files = ET.SubElement(element, "SourceFiles")
            for name in sources(2):
                ET.SubElement(files, "File", name=name)
    table = _common(root, variables)
    # Time is omitted: FMILibrary requires its start value. Variables are numbered from 1.
    listed = [v for v in variables.everything if v.causality != "independent"]
    index = {v.reference: i for i, v in enumerate(listed, 1)}
    for v in listed:
        scalar = ET.SubElement(table, "ScalarVariable", _attributes(v))
        typed = ET.SubElement(scalar, "Boolean" if v.is_boolean else "Real", _number(v))
        if v.derivative is not None and v.causality != "input":
            typed.set("derivative", str(index[v.derivative]))
    structure = ET.SubElement(root, "ModelStructure")
    groups = {
        "Outputs": variables.outputs,
        "Derivatives": variables.derivatives,
        "InitialUnknowns": sorted(variables.unknown_at_start, key=lambda v: index[v.reference]),
    }
    for kind, group in groups.items():
        element = ET.SubElement(structure, kind)
        for v in group:
            unknown = ET.SubElement(element, "Unknown", index=str(index[v.reference]))
            if kind != "InitialUnknowns":
                unknown.set(
                    "dependencies", " ".join(str(index[reference]) for reference in v.depends or ())
                )
    return root


def sources(version: int) -> tuple[str, ...]:
    """Return the C files of the binary."""
    return "model.c", "core.c", f"fmi{version}.c"


def build_description() -> bytes:
    """Return the content of ``sources/buildDescription.xml``, the build instructions of FMI 3.0."""
    root = ET.Element("fmiBuildDescription", fmiVersion="3.0")
    configuration = ET.SubElement(root, "BuildConfiguration", modelIdentifier=FILE)
    files = ET.SubElement(configuration, "SourceFileSet", language="C99")
    for name in sources(3):
        ET.SubElement(files, "SourceFile", name=name)
    return _to_xml(root)


def terminals(variables: Variables) -> bytes:
    """Return the content of ``terminalsAndIcons.xml``: variables grouped by connection, e.g. a road and its rate."""
    root = ET.Element("fmiTerminalsAndIcons", fmiVersion="3.0")
    picture = ET.SubElement(root, "GraphicalRepresentation")
    corners = {"x1": "-100", "y1": "-100", "x2": "100", "y2": "100"}
    ET.SubElement(picture, "CoordinateSystem", {**corners, "suggestedScalingFactorTo_mm": "0.1"})
    ET.SubElement(picture, "Icon", corners)
    table = ET.SubElement(root, "Terminals")
    for name, members in variables.terminals.items():
        terminal = ET.SubElement(table, "Terminal", name=name, matchingRule="bus")
        for member in members:
            last = member.name.rpartition(".")[2]
            ET.SubElement(
                terminal,
                "TerminalMemberVariable",
                variableKind="signal",
                memberName=last,
                variableName=member.name,
            )
    return _to_xml(root)


def page(variables: Variables, head: Head, notes: str) -> bytes:
    """Return the content of ``documentation/index.html``."""
    groups = {
        "Inputs": [v for v in variables.everything if v.causality == "input"],
        "Outputs": list(variables.outputs),
        "Parameters": [v for v in variables.everything if v.causality == "parameter"],
        "Other variables": [v for v in variables.everything if v.causality == "local"],
    }
    lines = [
        '<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">',
        f"<title>{html.escape(head.name)}</title><style>body{{font:15px/1.5 sans-serif;max-width:60em;margin:2em auto;",
        "padding:0 1em;color-scheme:light dark}table{border-collapse:collapse}",
        "td,th{text-align:left;padding:.15em 1em .15em 0;border-bottom:1px solid #8884}",
        "td:nth-child(3){text-align:right}</style>",
        f"<h1>{html.escape(head.name)}</h1><p>{html.escape(head.text)}</p>{notes}",
    ]
    for title, group in groups.items():
        if not group:
            continue
        lines.append(f"<h2>{title}</h2><table><tr><th>name<th>unit<th>start<th>meaning")
        for v in group:
            start = (
                ""
                if v.start is None
                else _text(v.start)
                if isinstance(v.start, bool)
                else f"{v.start:g}"
            )
            lines.append(
                f"<tr><td>{html.escape(v.name)}<td>{html.escape(v.unit)}<td>{start}<td>{html.escape(v.text)}"
            )
        lines.append("</table>")
    return ("\n".join(lines) + "\n").encode()


def _to_xml(root: ET.Element) -> bytes:
    ET.indent(root)
    return b'<?xml version="1.0" encoding="UTF-8"?>\n' + ET.tostring(root) + b"\n"
