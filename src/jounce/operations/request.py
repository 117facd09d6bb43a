"""Requests: an operation with the given values of its parameters."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, TypeAlias

from jounce.core.errors import JounceError
from jounce.operations.index import Operation, Parameter, resolve

_NOTHING: tuple[Any, ...] = (None, [], {})
Values: TypeAlias = "Sequence[tuple[Parameter, Any]]"


@dataclass(frozen=True)
class Request:
    """One request, the same for command line, job and Python.

    Attributes
    ----------
    operation : Operation
        Requested operation.
    given : dict
        Values by option, as given: text, numbers and switches.
    """

    operation: Operation
    given: Mapping[str, Any]

    def values(self) -> Iterator[tuple[Parameter, Any]]:
        """Yield each parameter with a value, either as given or the default."""
        for parameter in self.operation.parameters:
            value = self.given.get(parameter.option)
            value = parameter.default if value in _NOTHING and not parameter.is_required else value
            is_given = value not in _NOTHING and not value == parameter.default == ""
            if is_given or parameter.is_required:
                yield parameter, value

    def read(self) -> Values:
        """Convert all values, so that an invalid one raises an error before anything is created.

        Raises
        ------
        DescriptionError
            If a value cannot be parsed; the message names the option.
        """
        return [
            (parameter, parameter.mark.read(value, parameter.place))
            for parameter, value in self.values()
        ]

    def make(self, values: Values) -> dict[str, Any]:
        """Build the parameters that consist of several options from the converted values."""
        made = {}
        for name, makes in self.operation.makers.items():
            with naming_options(
                [parameter for parameter in self.operation.parameters if parameter.made == name]
            ):
                options = {
                    parameter.name: value for parameter, value in values if parameter.made == name
                }
                made[name] = resolve(makes.maker)(**options)
        return made

    def call(
        self,
        values: Values,
        made: Mapping[str, Any],
        say: Callable[[str], None] = lambda _: None,
        show: Callable[[object], None] = lambda _: None,
    ) -> Any:
        """Call the function with the converted values; ``say`` shows progress, ``show`` finished parts."""
        arguments = {
            **made,
            **{parameter.name: value for parameter, value in values if not parameter.made},
        }
        given = {"progress": say} if self.operation.has_progress else {}
        given |= {"each": show} if self.operation.has_each else {}
        with naming_options(self.operation.parameters):
            return resolve(self.operation.function)(**arguments, **given)

    def words(self) -> list[str]:
        """Write the request as words of a command; an equals sign keeps each value with its option."""
        words = self.operation.command.split()
        for parameter, value in self.values():
            if parameter not in self.operation.options:
                continue
            if parameter.is_positional:
                words += parameter.mark.texts(value)
            elif value is True:
                words.append(parameter.flag)
            elif value is not False and value != parameter.default:
                words += [f"{parameter.flag}={text}" for text in parameter.mark.texts(value)]
        return words

    def python(self) -> str:
        """Write the request as Python that prints its result."""
        return f"import jounce as jn\n\nresult = {self.expression()}\nprint(result)\n"

    def expression(self) -> str:
        """Write the request as a call of the public function."""
        name = (self.operation.python or self.operation.function).partition(":")[2]
        arguments = []
        for made, makes in self.operation.makers.items():
            options = {
                p.name: p.mark.read(value, p.place) for p, value in self.values() if p.made == made
            }
            text = (
                resolve(makes.python)(**options)
                if makes.python
                else _in_python(resolve(makes.maker), options)
            )
            arguments.append(f"{made}={text}")
        for parameter, value in self.values():
            if (
                parameter.made or value is False
            ):  # a switch that is off, which the function may lack
                continue
            is_text = parameter.takes_text and isinstance(value, str)
            written = repr(value) if is_text else parameter.mark.python(value, parameter.place)
            arguments.append(f"{parameter.name}={written}")
        lines = "".join(f"    {argument},\n" for argument in arguments)
        return f"jn.{name}(\n{lines})"


def _in_python(maker: Callable[..., Any], options: Mapping[str, Any]) -> str:
    """Format the result of a maker as Python: a description by its fields, anything else as the value itself."""
    if not isinstance(maker, type):
        return repr(maker(**options))
    fields = ", ".join(f"{name}={value!r}" for name, value in options.items())
    return f"jn.{maker.__name__}({fields})"


@contextmanager
def naming_options(parameters: Iterable[Parameter]) -> Iterator[None]:
    """Replace a parameter's name by its option in errors."""
    try:
        yield
    except JounceError as error:
        places = {parameter.name: parameter.place for parameter in parameters}
        if error.where not in places:
            raise
        where = places[error.where]
        kind = type(error)
        raise kind(
            error.what, where=where, found=error.found, allowed=error.allowed, hint=error.hint
        ) from None
