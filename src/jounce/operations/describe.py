"""Write the index of operations from signatures, marks and docstrings (``make faces``)."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator
from dataclasses import asdict, fields, replace
from importlib import import_module
from types import NoneType
from typing import Any, get_args, get_type_hints

from jounce.core.operation import REGISTERED, Count, MadeBy, Mark, Registration, Switch
from jounce.operations.index import Operation, Parameter, resolve

MODULES = ("jounce.design.pareto", "jounce.design.springs")
"""Modules whose functions are operations, in the order of their commands in the help."""


def described() -> list[dict[str, Any]]:
    """Describe every operation as plain data, for ``index.json``."""
    for module in MODULES:
        import_module(module)
    return [_plain(_operation(registration)) for registration in REGISTERED.values()]


def _operation(registration: Registration) -> Operation:
    function = registration.function
    makers = {name: mark for name, mark in _marks(function).items() if isinstance(mark, MadeBy)}
    parameters = tuple(_parameters(function, registration))
    first = next(index for index, parameter in enumerate(parameters) if parameter.is_required)
    positional = replace(parameters[first], is_positional=True)
    return Operation(
        registration.command,
        f"{function.__module__}:{function.__name__}",
        (inspect.getdoc(function) or "").partition("\n")[0],
        (*parameters[:first], positional, *parameters[first + 1 :]),
        makers,
        *(getattr(registration, name) for name in ("echo", "offers", "page", "comment", "doing", "example")),
    )


def _parameters(function: Callable[..., Any], registration: Registration, made: str = "") -> Iterator[Parameter]:
    """Read a function's parameters; a value made of options gives those of its maker."""
    marks, documented = _marks(function), parameter_texts(function)
    hints = get_type_hints(function)
    for name, parameter in inspect.signature(function).parameters.items():
        mark = marks[name]
        if name in registration.python_only:
            continue
        if isinstance(mark, MadeBy):
            yield from _parameters(resolve(mark.maker), registration, name)
            continue
        option = registration.named.get(name, name)
        default = registration.faces.get(option, None if parameter.default is parameter.empty else parameter.default)
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


def _marks(function: Callable[..., Any]) -> dict[str, Mark | MadeBy]:
    """Give the mark of each parameter; whole numbers and switches need none."""
    hints = get_type_hints(function, include_extras=True)
    found: dict[str, Mark | MadeBy] = {}
    for name in inspect.signature(function).parameters:
        marks = [mark for mark in getattr(hints[name], "__metadata__", ()) if isinstance(mark, Mark | MadeBy)]
        usual = {bool: Switch(), int: Count()}.get(hints[name], Mark())
        found[name] = marks[0] if marks else usual
    return found


def _members(hint: Any) -> set[Any]:
    return {*get_args(hint), hint} - {NoneType}


def parameter_texts(function: Callable[..., Any]) -> dict[str, str]:
    """Give what a numpydoc docstring says of each parameter."""
    part = re.search(r"Parameters\n-+\n(.*?)(?=^\w+\n-+$|\Z)", inspect.getdoc(function) or "", re.MULTILINE | re.DOTALL)
    texts = re.findall(r"^([\w, ]+) :[^\n]*\n((?:[ ]+[^\n]*\n?)*)", part[1] if part else "", re.MULTILINE)
    return {name.strip(): " ".join(text.split()) for names, text in texts for name in names.split(",")}


def _plain(operation: Operation) -> dict[str, Any]:
    """Leave out what has its usual value."""
    plain = asdict(operation)
    plain["parameters"] = [_plain_parameter(parameter) for parameter in operation.parameters]
    return plain


def _plain_parameter(parameter: Parameter) -> dict[str, Any]:
    mark = {field.name: getattr(parameter.mark, field.name) for field in fields(parameter.mark)}
    given = {field.name: getattr(parameter, field.name) for field in fields(parameter) if field.name != "mark"}
    usual = {field.name: field.default for field in fields(Parameter)}
    rest = {name: value for name, value in given.items() if value != usual[name]}
    return {**rest, "mark": {"kind": type(parameter.mark).__name__, **{k: v for k, v in mark.items() if v}}}
