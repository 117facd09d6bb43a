"""Write the index of operations from signatures, marks and docstrings (``make faces``)."""

from __future__ import annotations

import builtins
import inspect
import re
from collections.abc import Callable, Iterator
from dataclasses import asdict, fields, replace
from importlib import import_module
from types import NoneType
from typing import Any, get_args, get_type_hints

from pydantic.fields import FieldInfo

from jounce.core.description import Description
from jounce.core.display import DisplayUnit, display_unit
from jounce.core.operation import REGISTERED, Count, Field, MadeBy, Mark, Registration, Switch
from jounce.core.typed import LONGEST
from jounce.core.units import Unit
from jounce.operations.index import Operation, Parameter, resolve

MODULES = (
    "jounce.analysis.statistics",
    "jounce.analysis.spectrum",
    "jounce.analysis.transfer",
    "jounce.analysis.modes",
    "jounce.analysis.integrate",
    "jounce.bench.drive",
    "jounce.bench.similitude",
    "jounce.bench.springs",
    "jounce.report.campaign_folder",
    "jounce.campaign.new",
    "jounce.operations.papers",
    "jounce.operations.checks",
    "jounce.operations.library",
    "jounce.campaign.bench_fits",
    "jounce.campaign.model_choice",
    "jounce.campaign.posterior",
    "jounce.campaign.test_sheet",
    "jounce.dampers.map",
    "jounce.dampers.sheet",
    "jounce.dampers.compared",
    "jounce.design.clicks",
    "jounce.dampers.histograms",
    "jounce.design.adjustment",
    "jounce.design.studied",
    "jounce.design.measured_poses",
    "jounce.design.best_design",
    "jounce.design.model_comparison",
    "jounce.design.pareto",
    "jounce.design.springs",
    "jounce.exchange.fmu.export",
    "jounce.exchange.equations",
    "jounce.exchange.points",
    "jounce.exchange.chrono",
    "jounce.exchange.mjcf",
    "jounce.exchange.roads",
    "jounce.identify.calibration",
    "jounce.parts.importers.chrono",
    "jounce.parts.importers.adams",
    "jounce.parts.importers.hardpoints",
    "jounce.parts.importers.mjcf",
    "jounce.inspection.rig_inspection",
    "jounce.report.inspected",
    "jounce.inspection.archive.storing",
    "jounce.inspection.archive.questions",
    "jounce.inspection.equivalence",
    "jounce.kinematics.swept",
    "jounce.kc.sheet",
    "jounce.kinematics.axle_loads",
    "jounce.kinematics.clearance_study",
    "jounce.kinematics.steering_loads",
    "jounce.ride.drives",
    "jounce.ride.measured",
    "jounce.ride.modal",
    "jounce.roughness.iri",
    "jounce.simulation.trial_run",
    "jounce.springs.map",
    "jounce.variants.limits",
    "jounce.variants.sweeping",
)
"""Modules whose functions are operations, in the order of their commands in the help."""
PROGRESS, EACH = "progress", "each"
"""Callback parameters: one shows a text, the other a part of the result."""


def describe_operations() -> list[dict[str, Any]]:
    """Describe every operation as plain data, for ``index.json``."""
    for module in MODULES:
        import_module(module)
    registered = sorted(
        REGISTERED.values(), key=lambda operation: MODULES.index(operation.function.__module__)
    )
    return [_plain(_operation(registration)) for registration in registered]


def _operation(registration: Registration) -> Operation:
    function = registration.function
    makers = {name: mark for name, mark in _marks(function).items() if isinstance(mark, MadeBy)}
    parameters = [*_parameters(function, registration)]
    arguments = [
        replace(parameter, is_positional=True) for parameter in parameters[: registration.arguments]
    ]
    return Operation(
        registration.command,
        f"{function.__module__}:{function.__name__}",
        (inspect.getdoc(function) or "").partition("\n")[0],
        (*arguments, *parameters[registration.arguments :]),
        makers,
        PROGRESS in inspect.signature(function).parameters,
        **{field.name: getattr(registration, field.name) for field in fields(Operation)[6:-1]},
        has_each=EACH in inspect.signature(function).parameters,
    )


def _parameters(
    function: Callable[..., Any], registration: Registration, made: str = ""
) -> Iterator[Parameter]:
    """Read a function's parameters; a value made of options gives those of its maker."""
    marks, documented = _marks(function), parameter_texts(function)
    hints = _hints(function)
    for name, parameter in inspect.signature(function).parameters.items():
        mark = marks[name]
        if name in (PROGRESS, EACH, *registration.python_only):
            continue
        if isinstance(mark, MadeBy):
            maker = resolve(mark.maker)
            parts = _fields if isinstance(maker, type) else _parameters
            yield from parts(maker, registration, name)
            continue
        option = registration.named.get(name, name)
        default = registration.faces.get(
            option, None if parameter.default is parameter.empty else parameter.default
        )
        yield Parameter(
            name,
            option,
            replace(mark, help=mark.help or documented.get(name, "")),
            default,
            parameter.default is parameter.empty and option not in registration.faces,
            made=made,
            takes_text=str in _members(hints[name]),
            source=f"{function.__module__}:{function.__name__}",
        )


def _fields(kind: type[Description], registration: Registration, made: str) -> Iterator[Parameter]:
    """Read the fields of a description, with their defaults in the help."""
    documented = parameter_texts(kind)
    for name, field in kind.model_fields.items():
        if name in registration.python_only:
            continue
        unit = next((item.si for item in field.metadata if isinstance(item, Unit)), "")
        most = LONGEST if unit == "m" else None
        mark = Field(f"{documented[name]}{_default_of(field, unit)}", "VALUE", unit, most)
        option = registration.named.get(name, name)
        yield Parameter(name, option, mark, made=made, source=f"{kind.__module__}:{kind.__name__}")


def _default_of(field: FieldInfo, unit: str) -> str:
    if field.default is None or field.is_required():
        return ""
    is_estimated = isinstance(field.json_schema_extra, dict) and field.json_schema_extra.get(
        "estimated"
    )
    shown = display_unit(unit) if unit in ("m", "rad") else DisplayUnit(unit.removesuffix("1"), 1.0)
    is_number = isinstance(field.default, float)
    written = (
        f"{field.default * shown.factor:.6g} {shown.name}".strip() if is_number else field.default
    )
    return f" Default: {written}{' (estimated)' if is_estimated else ''}."


def _marks(function: Callable[..., Any]) -> dict[str, Mark | MadeBy]:
    """Return the mark of each parameter; integers and switches need none."""
    hints = _hints(function, include_extras=True)
    marked: dict[str, Mark | MadeBy] = {}
    for name in inspect.signature(function).parameters:
        marks = [
            mark
            for mark in getattr(hints[name], "__metadata__", ())
            if isinstance(mark, Mark | MadeBy)
        ]
        usual = {bool: Switch(), int: Count()}.get(hints[name], Mark())
        marked[name] = marks[0] if marks else usual
    return marked


class _Names(dict[str, Any]):
    """Return the names of a module, including those imported for type checkers only."""

    def __missing__(self, name: str) -> Any:
        return getattr(builtins, name, Any)


def _hints(function: Callable[..., Any], **options: Any) -> dict[str, Any]:
    """Evaluate the types of parameters."""
    modules = {"xr": import_module("xarray"), "pd": import_module("pandas")}
    names = _Names({**modules, **getattr(function, "__globals__", {})})
    return get_type_hints(function, localns=names, **options)


def _members(hint: Any) -> set[Any]:
    return {*get_args(hint), hint} - {NoneType}


def parameter_texts(function: Callable[..., Any]) -> dict[str, str]:
    """Return the numpydoc text of each parameter, or of each field of a description."""
    part = re.search(
        r"(?:Parameters|Attributes)\n-+\n(.*?)(?=^\w+\n-+$|\Z)",
        inspect.getdoc(function) or "",
        re.MULTILINE | re.DOTALL,
    )
    texts = re.findall(
        r"^([\w, ]+) :[^\n]*\n((?:[ ]+[^\n]*\n?)*)", part[1] if part else "", re.MULTILINE
    )
    return {
        name.strip(): " ".join(text.split()) for names, text in texts for name in names.split(",")
    }


def _plain(operation: Operation) -> dict[str, Any]:
    """Omit entries with default values."""
    plain = asdict(operation)
    plain["parameters"] = [_plain_parameter(parameter) for parameter in operation.parameters]
    return plain


def _plain_parameter(parameter: Parameter) -> dict[str, Any]:
    mark = {field.name: getattr(parameter.mark, field.name) for field in fields(parameter.mark)}
    given = {
        field.name: getattr(parameter, field.name)
        for field in fields(parameter)
        if field.name != "mark"
    }
    usual = {field.name: field.default for field in fields(Parameter)}
    rest = {name: value for name, value in given.items() if value != usual[name]}
    return {
        **rest,
        "mark": {"kind": type(parameter.mark).__name__, **{k: v for k, v in mark.items() if v}},
    }
