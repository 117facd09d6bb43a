"""Commands of operations: options, help and answer follow from the index."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import (
    AsJson,
    FigureFile,
    Force,
    ReportFile,
    RigFile,
    check_outputs,
    shipped,
    warn_of,
    write_picture,
    write_report,
    write_rig,
)
from jounce.cli.reply import Reply, progress, show_written
from jounce.core.operation import Count, Switch
from jounce.operations.index import Operation, Parameter, operations, resolve
from jounce.operations.request import Request

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.report import Page

OFFERS: Mapping[str, tuple[str, Any]] = {
    "rig": ("out", RigFile),
    "figure": ("figure", FigureFile),
    "report": ("report", ReportFile),
}
"""Option and type of each way to write a result."""


def add_commands(app: typer.Typer, group: str) -> None:
    """Add the commands of the operations whose words begin with ``group``; of a single word where it is empty."""
    for operation in operations().values():
        first, _, name = operation.command.rpartition(" ")
        if first == group:
            app.command(name)(command_of(operation))


def command_of(operation: Operation) -> Callable[..., Reply]:
    """Make the function whose signature the command line reads."""

    def command(**given: Any) -> Reply:
        return answer(operation, given)

    own = [_parameter(parameter) for parameter in operation.parameters]
    files = [(*OFFERS[offer], None) for offer in operation.offers]
    shared = [*files, ("force", Force, False), ("as_json", AsJson, False)]
    own += [inspect.Parameter(name, _KEYWORD, default=default, annotation=kind) for name, kind, default in shared]
    required_first = sorted(own, key=lambda parameter: parameter.default is not inspect.Parameter.empty)
    command.__signature__ = inspect.Signature(required_first)  # type: ignore[attr-defined]
    command.__annotations__ = {parameter.name: parameter.annotation for parameter in own}
    command.__doc__ = f"{operation.summary}\n\nExample: {operation.example}"
    return command


_KEYWORD = inspect.Parameter.KEYWORD_ONLY


def _parameter(parameter: Parameter) -> inspect.Parameter:
    """One parameter as Typer reads it."""
    mark, default = parameter.mark, parameter.default
    name = _python_name(parameter)
    if parameter.is_positional:
        argument = typer.Argument(metavar=parameter.option.upper(), help=mark.help, autocompletion=shipped("parts"))
        return inspect.Parameter(name, _KEYWORD, annotation=Annotated[str, argument])
    option = typer.Option(parameter.flag, metavar=mark.metavar or None, help=mark.help)
    kind: Any = int if isinstance(mark, Count) else bool if isinstance(mark, Switch) else str
    kind = list[str] if mark.is_repeated else kind
    if parameter.is_required:
        return inspect.Parameter(name, _KEYWORD, annotation=Annotated[kind, option])
    kind = kind if default is not None else kind | None
    return inspect.Parameter(name, _KEYWORD, default=default, annotation=Annotated[kind, option])


def _python_name(parameter: Parameter) -> str:
    return f"{parameter.option}_" if parameter.option in ("set",) else parameter.option


def answer(operation: Operation, given: Mapping[str, Any]) -> Reply:
    """Run an operation with what the command line gave, write what is asked for, and answer."""
    files = Files({offer: given[OFFERS[offer][0]] for offer in operation.offers}, force=given["force"])
    files.check()
    request = Request(operation, {p.option: given[_python_name(p)] for p in operation.parameters})
    values = request.read()
    typed = {parameter.option: value for parameter, value in request.values()}
    subject = str(typed[operation.subject])
    with progress() as say:
        say("loading")
        resolve(operation.function)
        made = request.make(values)
        for value in made.values():
            if hasattr(value, "parameters"):
                warn_of(value, subject)
        say(operation.doing)
        result = request.call(values, made)

    def page() -> Page:
        drawn: Page = resolve(operation.page)(result, title=Path(subject).stem)
        return drawn

    read = {parameter.option: value for parameter, value in values}
    echo = {key: read.get(option, {}) for key, option in operation.echo.items()}
    written, missing = files.write(result, page, subject, operation.comment.format(**typed))
    plain = {**echo, **result.to_dict(), **written}

    def draw(console: Console) -> None:
        from jounce.cli.terminal import show_page

        show_page(console, page())
        show_written(console, plain)

    return Reply(plain, draw, given["as_json"], missing=missing)


@dataclass(frozen=True)
class Files:
    """The files that a command writes, by what is written; None where no file is asked for."""

    asked: Mapping[str, Path | None]
    force: bool

    def check(self) -> None:
        """Refuse files that could not be written."""
        check_outputs(**self.asked, force=self.force)

    def write(
        self, result: Any, page: Callable[[], Page], title: str, comment: str
    ) -> tuple[dict[str, str | None], list[Finding]]:
        """Write the files; give their names by option, and what could not be drawn."""
        names: dict[str, str | None] = {}
        missing: list[Finding] = []
        for offer, file in self.asked.items():
            if offer == "rig":
                write_rig(result.rig, file, comment, force=self.force)
                names["out"] = None if file is None else str(file)
            elif offer == "figure":
                names["figure"], lost = write_picture(result, file, title, force=self.force)
                missing += lost
            else:
                names["report"], lost = write_report(page, file, force=self.force)
                missing += lost
        return names, missing
