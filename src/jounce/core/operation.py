"""Operations: public functions whose signature and docstring define their command, their job and their form.

Type annotations define the values in Python. A mark in an annotation defines how users enter the value: the unit of a
number, the syntax of pairs, the options from which a rig is built. The function itself is not changed;
`jounce.operations` derives the interfaces::

    @operation("design pareto", named={"constraints": "limit"}, offers=("figure", "report"))
    def pareto(rig: AnyRig, free: Annotated[Mapping[str, Bounds], Ranges()], *, points: int = 25) -> ParetoFront: ...
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any, ClassVar, Literal, TypeVar

Offer = Literal[
    "rig",
    "changed_rig",
    "rig_text",
    "imported_rig",
    "recording",
    "test_record",
    "numbers",
    "sweep",
    "table",
    "tables",
    "figure",
    "figures",
    "folder",
    "report",
]
"""Kinds of output of a result: see `jounce.cli.outputs`."""


@dataclass(frozen=True)
class Mark:
    """How users enter a parameter: as text, unless a subclass overrides it.

    Attributes
    ----------
    help : str
        Help of the option; if empty, it is taken from the docstring of the function.
    metavar : str
        Placeholder of the value in the help of a command.
    """

    help: str = ""
    metavar: str = ""
    is_repeated: ClassVar[bool] = False

    def read(self, given: Any, where: str) -> Any:  # noqa: ARG002 - used by subclasses
        """Convert the given values to arguments of the function; errors name the option ``where``."""
        return given

    def texts(self, given: Any) -> list[str]:
        """Write the given values as option values, one for each repetition of the option."""
        return [str(given)]

    def python(self, given: Any, where: str) -> str:
        """Write the given values as Python code."""
        return repr(self.read(given, where))


@dataclass(frozen=True)
class Number(Mark):
    """A number with a unit; a bare number is in SI."""

    unit: str = "1"
    is_positive: bool = False
    most: float | None = None  # of bare numbers, SI: for a larger one the unit is required

    def read(self, given: Any, where: str) -> float:
        """Convert the number to SI."""
        from jounce.core.typed import positive_quantity, quantity

        return (positive_quantity if self.is_positive else quantity)(
            str(given), self.unit, where, most=self.most
        )


@dataclass(frozen=True)
class Field(Mark):
    """A field of a description, which converts its value itself; a bare number must be plausible in SI."""

    unit: str = ""
    most: float | None = None

    def read(self, given: Any, where: str) -> str | float:
        """Return the value; refuse an implausible bare number."""
        from jounce.core.typed import bare_number
        from jounce.core.units import bare_si

        value = bare_number(str(given))
        is_bare = bool(self.unit) and isinstance(value, float)
        return bare_si(float(value), self.unit, where=where, most=self.most) if is_bare else value


@dataclass(frozen=True)
class File(Mark):
    """A file; shell completion also offers the files shipped with the given packages."""

    shipped: tuple[str, ...] = ()


@dataclass(frozen=True)
class Texts(Mark):
    """Several texts."""

    is_repeated: ClassVar[bool] = True

    def texts(self, given: Any) -> list[str]:
        """Write each text as an option value."""
        return [str(text) for text in given]


@dataclass(frozen=True)
class Count(Mark):
    """A whole number; forms show the bounds, and the function checks them."""

    least: int | None = None
    most: int | None = None


@dataclass(frozen=True)
class Switch(Mark):
    """True or false."""


@dataclass(frozen=True)
class Pairs(Mark):
    """A mapping, given as a repeated ``NAME=VALUE``."""

    example: str = ""
    is_repeated: ClassVar[bool] = True

    def read(self, given: Any, where: str) -> dict[str, Any]:
        """Split the pairs and convert each value."""
        from jounce.core.typed import pairs

        texts = given if isinstance(given, Mapping) else pairs(given, where, self.example)
        return {name: self.value(text) for name, text in texts.items()}

    def value(self, text: str) -> Any:
        """Convert one value."""
        return text

    def texts(self, given: Any) -> list[str]:
        """Write the pairs."""
        return (
            [f"{name}={text}" for name, text in given.items()]
            if isinstance(given, Mapping)
            else list(given)
        )


@dataclass(frozen=True)
class Described(Pairs):
    """Fields of a description, ``module:class``."""

    of: str = ""

    def read(self, given: Any, where: str) -> Any:
        """Build the description; bare numbers must be plausible in SI."""
        from jounce.core.typed import bare_numbers

        module, _, name = self.of.partition(":")
        kind = getattr(import_module(module), name)
        return kind.from_table(
            bare_numbers(kind, super().read(given, where), f"{where} {{}}".format), where=where
        )

    def python(self, given: Any, where: str) -> str:
        """Write the description as Python code with its fields."""
        fields = ", ".join(f"{name}={text!r}" for name, text in super().read(given, where).items())
        return f"jn.{self.of.partition(':')[2]}({fields})"


@dataclass(frozen=True)
class Columns(Pairs):
    """Columns by quantity, one or more pairs in each text; or all names of a file without a header in one text."""

    def read(self, given: Any, where: str) -> Any:
        """Split the pairs; an ordered list of names is kept as one text."""
        if isinstance(given, Mapping):
            return dict(given)
        if len(given) == 1 and "=" not in given[0] and "[" in given[0]:
            return given[0]
        parts = [part for text in given for part in re.split(r",\s*(?=[\w.]+\s*=)", text)]
        return super().read(parts, where)


@dataclass(frozen=True)
class Names(Pairs):
    """Names in a different program with their names in jounce: a repeated ``THEIRS=OURS``."""

    def read(self, given: Any, where: str) -> dict[str, str]:
        """Split the pairs at their last equals sign."""
        return dict(
            given if isinstance(given, Mapping) else (self._pair(text, where) for text in given)
        )

    def _pair(self, text: str, where: str) -> tuple[str, str]:
        from jounce.core.errors import DescriptionError

        theirs, equals, ours = (part.strip() for part in text.rpartition("="))
        if not (theirs and equals and ours):
            raise DescriptionError(
                "two names are required", where=where, found=text, allowed="THEIRS=OURS"
            )
        return theirs, ours


@dataclass(frozen=True)
class Ranges(Pairs):
    """Pairs of a name and ``LOW..HIGH UNIT``, or any other value that the function accepts."""

    def value(self, text: str) -> Any:
        """Convert a range to a pair."""
        from jounce.core.typed import ends

        return ends(text) or text


@dataclass(frozen=True)
class Settings(Pairs):
    """Pairs of a path and a value in TOML syntax."""

    def value(self, text: str) -> Any:
        """Convert the value as in a TOML file."""
        from jounce.core.typed import toml_value

        return toml_value(text)


@dataclass(frozen=True)
class Band(Mark):
    """``LOW..HIGH``, or a word that the function accepts."""

    unit: str = "1"
    words: tuple[str, ...] = ()

    def read(self, given: Any, where: str) -> Any:
        """Convert both ends to SI."""
        from jounce.core.typed import ends, quantity, unreadable_band

        if given in self.words:
            return given
        pair = ends(given)
        if pair is None:
            raise unreadable_band(given, where, self.words)
        return tuple(quantity(str(end), self.unit, where) for end in pair)


_KINDS = (
    Mark,
    Number,
    Field,
    File,
    Texts,
    Count,
    Switch,
    Pairs,
    Described,
    Columns,
    Names,
    Ranges,
    Settings,
    Band,
)
MARKS: Mapping[str, type[Mark]] = {kind.__name__: kind for kind in _KINDS}


@dataclass(frozen=True)
class MadeBy:
    """A value built from several options, which are the parameters of its maker.

    Attributes
    ----------
    maker, python : str
        ``module:function``: ``maker`` builds the value from the options, ``python`` writes this as Python code; if
        ``python`` is empty, the value itself is written. The maker may be a description, whose fields are the options.
    """

    maker: str
    python: str = ""


@dataclass(frozen=True)
class Registration:
    """The registration of a function; see :func:`operation`."""

    function: Callable[..., Any]
    command: str
    named: Mapping[str, str] = field(default_factory=dict)
    faces: Mapping[str, Any] = field(default_factory=dict)
    python_only: tuple[str, ...] = ()
    arguments: int = 1
    echo: Mapping[str, str | tuple[str, ...]] = field(default_factory=dict)
    offers: tuple[Offer, ...] = ()
    required: tuple[Offer, ...] = ()
    names_files: bool = True
    check: str = ""
    python: str = ""
    page: str = ""
    terminal: str = ""
    figure: str = ""
    title: str = ""
    comment: str = ""
    doing: str = "computing"
    stages: tuple[str, ...] = ()
    example: str = ""
    note: str = ""


REGISTERED: dict[str, Registration] = {}
_F = TypeVar("_F", bound=Callable[..., Any])


def operation(command: str, **more: Any) -> Callable[[_F], _F]:
    """Register a public function as an operation, without changing it.

    Parameters
    ----------
    command : str
        Words of its command, such as ``"design pareto"``.
    **more
        ``named``: options whose name differs from that of the parameter. ``faces``: defaults of options that differ
        from those of the function. ``python_only``: parameters without an option. ``arguments``: number of leading
        parameters that are positional in the command. ``echo``: keys of ``--json`` that repeat one option, or several
        by name. ``offers``: outputs that the result can be written to; ``required``: outputs that must be given;
        ``names_files``: whether ``--json`` lists these files. ``check``: ``module:function`` that validates options
        before the work; it receives all of them by name, as given. ``python``: ``module:function`` shown in Python code
        instead, if it returns a different form of the result. ``page``: ``module:function`` that puts the result on a
        page; ``terminal``: the same for a terminal, if that shows less. ``figure``: ``module:function`` that draws the
        result, if it is not the figure of its type. ``title``, ``comment``: heading of the page and first line of a rig
        file, with options and ``result`` in braces. ``doing``: text shown while it runs. ``stages``: how its
        progress texts begin, stage by stage, if there are several, with ``|`` between those of one stage and its part
        of the whole after a ``*``, if that is not one. ``example``: a command line.
        ``note``: help of the command below its first line.

    Notes
    -----
    The parameters ``progress`` and ``each`` are not options. Interfaces pass functions: ``progress`` shows a text,
    ``each`` shows a part of the result as soon as it is complete, or a text with its error.

    The result has ``to_dict``. If it is incomplete, ``stopped`` is the reason and ``problems`` lists the errors (exit
    code 2); if they were already shown, ``is_whole`` is false. ``remark`` is further text for stderr. If the goal was
    not reached, ``is_met`` is false (exit code 1). ``missing`` has findings about figures that could not be drawn.
    ``when_interrupted`` is the message if writing is interrupted. ``printed`` is text for the terminal instead of the
    page if no file is written; warnings among the findings go to stderr. Some outputs need further attributes:
    ``rig``, ``rig_text``, ``recording()``, ``rows()``, ``data``, ``table()``, ``sheets()``.
    """

    def register(function: _F) -> _F:
        REGISTERED[command] = Registration(function, command, **more)
        return function

    return register
