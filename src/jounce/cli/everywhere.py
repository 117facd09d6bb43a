"""Features of all commands: display options, and help with descriptive placeholders for values."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

import typer

from jounce.core.display import local_units, use_units


@dataclass
class DisplayOptions:
    """Display options of one command."""

    every_row: bool = False  # show all rows of long tables
    opens: bool = False  # open the written page


VIEW = DisplayOptions()
_PANEL = "Everywhere"


@contextmanager
def as_usual() -> Iterator[None]:
    """Reset the display options of one command line after a block."""
    before = VIEW.every_row, VIEW.opens
    VIEW.every_row, VIEW.opens = False, False
    try:
        with local_units("metric"):
            yield
    finally:
        VIEW.every_row, VIEW.opens = before


def _options(
    open_: Annotated[
        bool,
        typer.Option(
            "--open", rich_help_panel=_PANEL, help="Open the page that is written in the browser."
        ),
    ] = False,
    every_row: Annotated[
        bool,
        typer.Option(
            "--all",
            rich_help_panel=_PANEL,
            help="Every row of long tables; what is piped has them all.",
        ),
    ] = False,
    units: Annotated[
        Literal["metric", "imperial"],
        typer.Option(
            rich_help_panel=_PANEL,
            help="Units of tables, figures and reports: mm, N/mm, MPa, or in, lbf/in, lb, psi, mph. JSON and "
            "recordings stay SI.",
        ),
    ] = "metric",
) -> None:
    """Declare the options; the function does nothing."""


def _open(value: bool) -> None:
    VIEW.opens = VIEW.opens or value


def _all(value: bool) -> None:
    VIEW.every_row = VIEW.every_row or value


_TAKEN: Mapping[str, Callable[[Any], None]] = {
    "open_": _open,
    "every_row": _all,
    "units": use_units,
}


def with_shared_options(command: Any) -> Any:
    """Return the command and its subcommands with the shared options added."""
    inner = getattr(command, "commands", None)
    if inner is None:
        command.params += [
            option
            for option in _everywhere()
            if option.name != "open_" or _writes_pages(command.params)
        ]
    kinds = {
        name: hint
        for function in (_options, command.callback)
        for name, hint in _hints(function).items()
    }
    for parameter in [*command.params, command.get_help_option(typer.Context(command))]:
        if parameter is not None:
            parameter.metavar = word_of(parameter, kinds.get(parameter.name))
            if parameter.param_type_name == "argument":
                parameter.display_type_rich = _nothing  # next to its name
    for subcommand in (inner or {}).values():
        with_shared_options(subcommand)
    return command


def _hints(function: Callable[..., Any] | None) -> dict[str, Any]:
    return get_type_hints(function) if function else {}


def _nothing(**_: Any) -> None:
    return None


def _everywhere() -> list[Any]:
    """Create the options separately for each command, because a parser stores its state in them."""
    app = typer.Typer(add_completion=False)
    app.command()(_options)
    options: list[Any] = typer.main.get_command(app).params
    for option in options:
        option.expose_value = False
        option.callback = _take_option
    return options


def _take_option(context: Any, option: Any, value: Any) -> None:
    if not context.resilient_parsing:
        _TAKEN[option.name](value)


def _writes_pages(options: list[Any]) -> bool:
    helps = [str(getattr(option, "help", "")) for option in options]
    return any("report" in text.lower() or ".html" in text for text in helps)


_WORDS = {
    "camber": "ANGLE",
    "toe": "ANGLE",
    "travel": "RANGE",
    "rack": "RANGE",
    "roll": "RANGE",
    "wear": "SHARE",
    "noise": "SHARE",
    "duration": "TIME",
    "from": "TIME",
    "to": "TIME",
    "interval": "TIME",
    "settle": "TIME",
    "resample": "TIME",
    "discard-below": "LENGTH",
    "offset": "LENGTH",
    "segment": "LENGTH",
    "load": "FORCE",
    "holding": "METRIC",
    "comfort": "METRIC",
    "since": "DAY",
    "until": "DAY",
    "date": "DAY",
    "inspector": "NAME",
    "place": "NAME",
    "slow": "FACTOR",
    "lumped": "RIG",
    "limits": "FILE",
}
"""Placeholders for options whose names do not end with a suitable word."""


def word_of(parameter: Any, kind: Any) -> str | None:
    """Return the placeholder of an option's value in the help: none for a switch, choices, or a technical term.

    Arguments keep their own. The kind is taken from the signature, because Typer's classes differ between versions.
    """
    if parameter.metavar is not None or parameter.param_type_name == "argument":
        return parameter.metavar  # type: ignore[no-any-return]
    if getattr(parameter, "is_flag", False):
        return ""
    while get_origin(kind) in (Union, UnionType, list):  # optional, or repeatable
        kind = next(part for part in get_args(kind) if part is not NoneType)
    if get_origin(kind) is Literal:
        return "|".join(get_args(kind))
    if issubclass(kind, Enum):
        return "|".join(str(choice.value) for choice in kind)
    name = parameter.opts[0].lstrip("-")
    if name in _WORDS:
        return _WORDS[name]
    if kind is Path:
        return "DIR" if "older" in str(parameter.help) else "FILE"
    return "NUMBER" if kind is int else name.rpartition("-")[2].upper()


def open_pages(plain: Mapping[str, Any]) -> None:
    """Open the page that a command has written, if requested; report if there is none."""
    if not VIEW.opens:
        return
    import webbrowser

    page = next(_pages(plain), None)
    if page is None:
        said = "--open: no page was written. Ask for one, e.g. with --report page.html."
    elif webbrowser.open(page.resolve().as_uri()):
        return
    else:
        said = f"--open: no browser was found. Open {page} in one."
    sys.stderr.write(f"jounce: {said}\n")


def _pages(value: Any) -> Iterator[Path]:
    if isinstance(value, Mapping):
        for item in value.values():
            yield from _pages(item)
    elif isinstance(value, list | tuple):
        for item in value:
            yield from _pages(item)
    elif isinstance(value, str | Path) and value:
        file = Path(value)
        for page in (file, file / "report.html"):
            if page.suffix == ".html" and page.is_file():
                yield page
