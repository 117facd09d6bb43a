"""Operations: public functions whose signature and docstring describe their command, their job and their form.

Types say what Python takes. A mark beside a type says how people give the value: the unit of a typed number, how pairs
are written, which options make a rig. The function itself stays as it is; `jounce.operations` derives the faces::

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
    "figure",
    "figures",
    "folder",
    "report",
]
"""What a result can be written as: see `jounce.cli.outputs`."""


@dataclass(frozen=True)
class Mark:
    """How people give a parameter: as text, unless a subclass says otherwise.

    Attributes
    ----------
    help : str
        Help of the option; the docstring of the function has it where this is empty.
    metavar : str
        Word for the value in the help of a command.
    """

    help: str = ""
    metavar: str = ""
    is_repeated: ClassVar[bool] = False

    def read(self, given: Any, where: str) -> Any:  # noqa: ARG002 - of those that convert
        """Convert the given values to those that the function takes; errors name the option ``where``."""
        return given

    def texts(self, given: Any) -> list[str]:
        """Write the given values as values of the option, one for each repetition."""
        return [str(given)]

    def python(self, given: Any, where: str) -> str:
        """Write the given values as Python."""
        return repr(self.read(given, where))


@dataclass(frozen=True)
class Number(Mark):
    """A number with a unit; a bare number is in SI."""

    unit: str = "1"
    is_positive: bool = False
    most: float | None = None  # of bare numbers, SI: a larger one lacks its unit

    def read(self, given: Any, where: str) -> float:
        """Convert the number to SI."""
        from jounce.core.typed import positive_quantity, quantity

        return (positive_quantity if self.is_positive else quantity)(
            str(given), self.unit, where, most=self.most
        )


@dataclass(frozen=True)
class Field(Mark):
    """A field of a description, which converts its values itself; a bare number must be plausible in SI."""

    unit: str = ""
    most: float | None = None

    def read(self, given: Any, where: str) -> str | float:
        """Refuse a bare number that is implausible."""
        from jounce.core.typed import bare_number
        from jounce.core.units import bare_si

        value = bare_number(str(given))
        is_bare = bool(self.unit) and isinstance(value, float)
        return bare_si(float(value), self.unit, where=where, most=self.most) if is_bare else value


@dataclass(frozen=True)
class File(Mark):
    """A file; a shell completes names of the library of these packages, too."""

    shipped: tuple[str, ...] = ()


@dataclass(frozen=True)
class Texts(Mark):
    """Several texts."""

    is_repeated: ClassVar[bool] = True

    def texts(self, given: Any) -> list[str]:
        """Write each."""
        return [str(text) for text in given]


@dataclass(frozen=True)
class Count(Mark):
    """A whole number; forms show the bounds, the function refuses what lies outside of them."""

    least: int | None = None
    most: int | None = None


@dataclass(frozen=True)
class Switch(Mark):
    """True or false."""


@dataclass(frozen=True)
class Pairs(Mark):
    """A mapping, given as repeated ``NAME=VALUE``."""

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
        """Write the description by its fields."""
        fields = ", ".join(f"{name}={text!r}" for name, text in super().read(given, where).items())
        return f"jn.{self.of.partition(':')[2]}({fields})"


@dataclass(frozen=True)
class Columns(Pairs):
    """Columns by quantity, one or several pairs in each text; or all names of a file without a header in one text."""

    def read(self, given: Any, where: str) -> Any:
        """Split the pairs; names in order stay one text."""
        if isinstance(given, Mapping):
            return dict(given)
        if len(given) == 1 and "=" not in given[0] and "[" in given[0]:
            return given[0]
        parts = [part for text in given for part in re.split(r",\s*(?=[\w.]+\s*=)", text)]
        return super().read(parts, where)


@dataclass(frozen=True)
class Names(Pairs):
    """Names of another program, each with the name that it has here: repeated ``THEIRS=OURS``."""

    def read(self, given: Any, where: str) -> dict[str, str]:
        """Split the pairs at their last equals sign."""
        return dict(
            given if isinstance(given, Mapping) else (self._pair(text, where) for text in given)
        )

    def _pair(self, text: str, where: str) -> tuple[str, str]:
        from jounce.core.errors import DescriptionError

        theirs, equals, ours = (part.strip() for part in text.rpartition("="))
        if not (theirs and equals and ours):
            raise DescriptionError("not two names", where=where, found=text, allowed="THEIRS=OURS")
        return theirs, ours


@dataclass(frozen=True)
class Ranges(Pairs):
    """Pairs of a name and ``LOW..HIGH UNIT``, or any other value that the function takes."""

    def value(self, text: str) -> Any:
        """Convert a range to a pair."""
        from jounce.core.typed import ends

        return ends(text) or text


@dataclass(frozen=True)
class Settings(Pairs):
    """Pairs of a path and a value as TOML writes it."""

    def value(self, text: str) -> Any:
        """Convert the value as a TOML file would."""
        from jounce.core.typed import toml_value

        return toml_value(text)


@dataclass(frozen=True)
class Band(Mark):
    """``LOW..HIGH``, or a word that the function knows."""

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
    """A value built from several options: the parameters of its maker.

    Attributes
    ----------
    maker, python : str
        ``module:function``: the one makes the value of the options, the other writes that as Python; where it is
        empty, Python has the value itself. The maker may be a description: its fields are the options then.
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
    example: str = ""
    note: str = ""


REGISTERED: dict[str, Registration] = {}
_F = TypeVar("_F", bound=Callable[..., Any])


def operation(command: str, **more: Any) -> Callable[[_F], _F]:
    """Register a public function as an operation, and leave it as it is.

    Parameters
    ----------
    command : str
        Words of its command, such as ``"design pareto"``.
    **more
        ``named``: parameters whose option has another name. ``faces``: defaults of options that differ from those of
        the function. ``python_only``: parameters without an option. ``arguments``: how many of its first parameters a
        command takes without a name. ``echo``: keys of ``--json`` that repeat an option, or several by their names.
        ``offers``: what the result can be written as; ``required``: those of them that must be asked for;
        ``names_files``: whether ``--json`` names these files.
        ``check``: ``module:function`` that refuses options before the work; it takes all of them, by name, as given.
        ``python``: ``module:function`` that Python is offered instead, where it gives another form of the result.
        ``page``: ``module:function`` that puts the result on a page; ``terminal``: that puts on a page what a terminal
        shows, where this is less. ``figure``: ``module:function`` that draws it, where this is not the figure of its
        type. ``title``, ``comment``: head of the page and first line of a rig file, with options and ``result`` in
        braces. ``doing``: what is shown while it runs.
        ``example``: a command line. ``note``: what the help of the command says below its first line.

    Notes
    -----
    A parameter ``progress`` is no option: faces pass a function that shows a text. Nor is ``each``: it shows a part
    of the result as soon as that is done, or a text that says what is wrong with it. The result has ``to_dict``.
    Where it is not whole, ``stopped`` says why, and ``problems`` what is wrong, one by one (exit code 2); where
    that was shown already, ``is_whole`` is false. ``remark`` is what else to say on stderr; where it is not what
    was wanted, ``is_met`` is false (exit code 1). ``missing`` are findings about what could not be drawn.
    ``when_interrupted`` is what to say where writing it is interrupted. ``printed`` is text that a terminal gets in
    place of the page where no file is written; warnings among the findings go to stderr.
    What it can be written as asks for more: ``rig``, ``rig_text``, ``recording()``, ``rows()``, ``data``, ``table()``.
    """

    def register(function: _F) -> _F:
        REGISTERED[command] = Registration(function, command, **more)
        return function

    return register
