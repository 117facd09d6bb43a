"""The index of operations: parameters, help and defaults of each, without the functions themselves."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib import import_module, resources
from typing import Any

from jounce.core.operation import MARKS, MadeBy, Mark


@dataclass(frozen=True)
class Parameter:
    """One parameter as presented by front ends.

    Attributes
    ----------
    name : str
        Name in the function, or in the maker of one of its parameters.
    option : str
        Name in commands and jobs, with underscores.
    mark : Mark
        Form in which the value is given.
    default : object
        Default of the option, as typed; ``None`` without one.
    is_required, is_positional : bool
        Whether it is required, and whether a command accepts it without its name.
    made : str
        Parameter of the function that it is part of; empty if it is a parameter itself.
    takes_text : bool
        Whether the function parses typed text itself.
    source : str
        ``module:function`` whose signature and docstring describe it.
    """

    name: str
    option: str
    mark: Mark
    default: Any = None
    is_required: bool = False
    is_positional: bool = False
    made: str = ""
    takes_text: bool = False
    source: str = ""

    @property
    def flag(self) -> str:
        """Return the option as written on a command line.

        >>> Parameter("damping_ratio", "damping_ratio", Mark()).flag
        '--damping-ratio'
        """
        return f"--{self.option.replace('_', '-')}"

    @property
    def place(self) -> str:
        """Return the name of the value in messages: its option, or its placeholder in the help if it has none."""
        word = self.mark.metavar.removesuffix("...") or self.option.upper()
        return word if self.is_positional else self.flag


@dataclass(frozen=True)
class Operation:
    """One operation.

    Attributes
    ----------
    function : str
        ``module:name``.
    summary : str
        First line of its docstring.
    parameters : tuple of Parameter
        In the order of the command.
    makers : dict
        Functions that create parameters from options, by parameter.
    has_progress : bool
        Whether the function accepts ``progress``, which shows a text while it runs.
    has_each : bool
        Whether it accepts ``each``, which shows each part of the result as soon as it is available.
    command, echo, offers, required, names_files, check, python, page, terminal, figure
        Arguments of :func:`jounce.core.operation.operation`.
    title, comment, doing, stages, example, note
        Text arguments of the same function.
    """

    command: str
    function: str
    summary: str
    parameters: tuple[Parameter, ...]
    makers: Mapping[str, MadeBy]
    has_progress: bool
    echo: Mapping[str, str | tuple[str, ...]]
    offers: tuple[str, ...]
    required: tuple[str, ...]
    names_files: bool
    check: str
    python: str
    page: str
    terminal: str
    figure: str
    title: str
    comment: str
    doing: str
    example: str
    note: str = ""
    stages: tuple[str, ...] = ()
    has_each: bool = False

    @property
    def options(self) -> tuple[Parameter, ...]:
        """Return parameters with distinct options: several makers may use the same option."""
        first = {parameter.option: parameter for parameter in reversed(self.parameters)}
        return tuple(
            parameter for parameter in self.parameters if first[parameter.option] is parameter
        )

    @property
    def subject(self) -> str:
        """Return the option of the subject, which a command accepts without its name; empty if there is none."""
        return next(
            (parameter.option for parameter in self.parameters if parameter.is_positional), ""
        )


def resolve(path: str) -> Any:
    """Import ``module:name``."""
    module, _, name = path.partition(":")
    return getattr(import_module(module), name)


@cache
def operations() -> dict[str, Operation]:
    """Read the index: operations by command."""
    text = resources.files("jounce.operations").joinpath("index.json").read_text(encoding="utf-8")
    return {row["command"]: _operation(row) for row in json.loads(text)}


def _operation(row: Mapping[str, Any]) -> Operation:
    parameters = tuple(_parameter(given) for given in row["parameters"])
    makers = {name: MadeBy(**given) for name, given in row["makers"].items()}
    echo = {
        key: tuple(options) if isinstance(options, list) else options
        for key, options in row["echo"].items()
    }
    texts = {name: tuple(row.get(name, ())) for name in ("offers", "required", "stages")}
    return Operation(**{**row, "parameters": parameters, "makers": makers, "echo": echo, **texts})


def _parameter(row: Mapping[str, Any]) -> Parameter:
    given: dict[str, Any] = dict(row["mark"])
    kind: Any = MARKS[given.pop("kind")]
    values = {
        name: tuple(value) if isinstance(value, list) else value for name, value in given.items()
    }
    return Parameter(**{**row, "mark": kind(**values)})
