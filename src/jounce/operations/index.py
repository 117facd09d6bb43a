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
    """One parameter as faces ask for it.

    Attributes
    ----------
    name : str
        Of the function, or of the maker of one of its parameters.
    option : str
        As commands and jobs call it, with underscores.
    mark : Mark
        How it is given.
    default : object
        Of the option, as people type it; None without one.
    is_required, is_positional : bool
        Whether it must be given, and whether a command takes it without its name.
    made : str
        Parameter of the function that it helps to make; empty where it is one itself.
    takes_text : bool
        Whether the function reads what people type by itself.
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
        """Give the option as it is written on a command line.

        >>> Parameter("damping_ratio", "damping_ratio", Mark()).flag
        '--damping-ratio'
        """
        return f"--{self.option.replace('_', '-')}"

    @property
    def place(self) -> str:
        """Name of the value in messages: its option, or what stands for it in the help where it has none."""
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
        Parameter of the function to what makes it of options.
    has_progress : bool
        Whether the function takes ``progress``, which shows a text while it runs.
    has_each : bool
        Whether it takes ``each``, which shows each part of the result as soon as it is done.
    command, echo, offers, required, names_files, check, python, page, terminal, figure
        As :func:`jounce.core.operation.operation` takes them.
    title, comment, doing, example, note
        Texts, as it takes them.
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
    has_each: bool = False

    @property
    def options(self) -> tuple[Parameter, ...]:
        """Parameters whose option no earlier one has: several makers may take the same option."""
        first = {parameter.option: parameter for parameter in reversed(self.parameters)}
        return tuple(
            parameter for parameter in self.parameters if first[parameter.option] is parameter
        )

    @property
    def subject(self) -> str:
        """Option of the subject: the one that a command takes without its name; empty without one."""
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
    texts = {name: tuple(row[name]) for name in ("offers", "required")}
    return Operation(**{**row, "parameters": parameters, "makers": makers, "echo": echo, **texts})


def _parameter(row: Mapping[str, Any]) -> Parameter:
    given: dict[str, Any] = dict(row["mark"])
    kind: Any = MARKS[given.pop("kind")]
    values = {
        name: tuple(value) if isinstance(value, list) else value for name, value in given.items()
    }
    return Parameter(**{**row, "mark": kind(**values)})
