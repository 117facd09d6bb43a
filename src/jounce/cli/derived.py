"""Commands of operations: options, help and output are derived from the index."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Callable, Mapping
from keyword import iskeyword
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import AsJson, Force, names_in, warn, warn_of
from jounce.cli.outputs import OUTPUTS, Answered, Files
from jounce.cli.reply import DONE, FAILED, REFUSED, Reply, progress, show_written, tell
from jounce.core.operation import Count, File, Pairs, Switch
from jounce.core.text import visible
from jounce.operations.index import Operation, Parameter, operations, resolve
from jounce.operations.request import Request

if TYPE_CHECKING:
    from rich.console import Console


def add_commands(app: typer.Typer, group: str) -> None:
    """Add the commands whose words begin with ``group``, or all single-word commands if it is empty."""
    for operation in operations().values():
        first, _, name = operation.command.rpartition(" ")
        if first == group:
            app.command(name)(command_of(operation))


def command_function(command: str) -> Callable[..., Reply]:
    """Return the command of an operation by its words."""
    return command_of(operations()[command])


def command_of(operation: Operation) -> Callable[..., Reply]:
    """Create the function whose signature Typer reads."""

    def command(**given: Any) -> Reply:
        return answer(operation, given)

    own = [_parameter(parameter) for parameter in operation.options]
    offers = [offer for offer in operation.offers if offer not in _own(operation)]
    files = [
        (OUTPUTS[offer].option, OUTPUTS[offer].kind, _default(operation, offer)) for offer in offers
    ]
    force = [("force", Force, False)] if files else []
    shared = [*files, *force, ("as_json", AsJson, False)]
    own += [
        inspect.Parameter(name, _KEYWORD, default=default, annotation=kind)
        for name, kind, default in shared
    ]
    required_first = sorted(
        own, key=lambda parameter: parameter.default is not inspect.Parameter.empty
    )
    command.__signature__ = inspect.Signature(required_first)  # type: ignore[attr-defined]
    command.__annotations__ = {parameter.name: parameter.annotation for parameter in own}
    command.__doc__ = "\n\n".join(
        filter(None, (operation.summary, operation.note, f"Example: {operation.example}"))
    )
    return command


_KEYWORD = inspect.Parameter.KEYWORD_ONLY


def _own(operation: Operation) -> list[str]:
    """Return the offers whose option is a parameter of the function, which writes that folder itself."""
    options = {parameter.option for parameter in operation.parameters}
    return [offer for offer in operation.offers if OUTPUTS[offer].option in options]


def _default(operation: Operation, offer: str) -> Any:
    """Return the default of an output option: required, or no output."""
    return inspect.Parameter.empty if offer in operation.required else None


def _parameter(parameter: Parameter) -> inspect.Parameter:
    """Convert a parameter to the form that Typer reads."""
    mark, default = parameter.mark, parameter.default
    kind: Any = int if isinstance(mark, Count) else bool if isinstance(mark, Switch) else str
    kind = list[str] if mark.is_repeated else kind
    metavar = mark.metavar or ("FILE" if isinstance(mark, File) else None)
    completion = names_in(*mark.shipped) if isinstance(mark, File) and mark.shipped else None
    said: dict[str, Any] = {"help": mark.help, "autocompletion": completion}
    if parameter.is_positional:
        option: Any = typer.Argument(
            metavar=mark.metavar or parameter.option.upper(), show_default=False, **said
        )
    else:
        option = typer.Option(parameter.flag, metavar=metavar, **said)
    if parameter.is_required:
        return inspect.Parameter(
            _python_name(parameter), _KEYWORD, annotation=Annotated[kind, option]
        )
    kind = kind if default is not None else kind | None
    return inspect.Parameter(
        _python_name(parameter), _KEYWORD, default=default, annotation=Annotated[kind, option]
    )


def _python_name(parameter: Parameter) -> str:
    is_taken = iskeyword(parameter.option) or parameter.option == "set"
    return f"{parameter.option}_" if is_taken else parameter.option


def answer(operation: Operation, given: Mapping[str, Any]) -> Reply:
    """Run an operation with the arguments of the command line, write the requested files, and reply."""
    asked = {offer: given[OUTPUTS[offer].option] for offer in operation.offers}
    files = Files(asked, given.get("force", False), _own(operation))
    files.check()
    if operation.check:
        resolve(operation.check)(**given)
    request = Request(operation, {p.option: given[_python_name(p)] for p in operation.parameters})
    values = request.read()
    typed = {p.option: p.default for p in operation.parameters} | {
        p.option: value for p, value in request.values()
    }
    with progress(operation.stages) as say:
        say("loading")
        resolve(operation.function)
        made = request.make(values)
        for name, value in made.items():
            if hasattr(value, "parameters"):
                warn_of(
                    value,
                    next(str(typed[p.option]) for p in operation.parameters if p.made == name),
                )
        say(operation.doing)
        result = request.call(values, made, say, _shower(given["as_json"]))
    named = {OUTPUTS[offer].option: file for offer, file in asked.items()} | _stems(
        operation, typed
    )
    title = operation.title.format(**named, result=result)
    plain = {**_echo(operation, {p.option: value for p, value in values}), **result.to_dict()}
    subject = str(typed.get(operation.subject, ""))
    answered = Answered(
        operation, subject, result, plain, title, operation.comment.format(**typed, result=result)
    )
    try:
        missing = [*files.write(answered), *getattr(result, "missing", ())]
    except KeyboardInterrupt as error:
        if hint := getattr(result, "when_interrupted", ""):
            error.add_note(hint)
        raise
    names = ("out", "figure", "report", *(OUTPUTS[offer].name for offer in operation.offers))
    written = {name: plain[name] for name in names if name in plain}
    if not operation.names_files:
        plain = {name: value for name, value in plain.items() if name not in written}

    def draw(console: Console) -> None:
        from jounce.cli.terminal import show_page

        text = getattr(result, "printed", "")
        if text and not any(written.values()):
            sys.stdout.write(text)
            warn(plain.get("findings", ()))
            return
        show_page(console, answered.summary())
        show_written(console, {**written, "out": _with_page(written.get("out"))})

    return Reply(plain, draw, given["as_json"], _exit_code(result), missing)


def _shower(as_json: bool) -> Callable[[object], None]:
    """Show each part of a result immediately: on stdout unless JSON follows, error messages on stderr."""

    def show(part: object) -> None:
        if isinstance(part, str):
            tell(part)
        elif not as_json:
            sys.stdout.write(visible(f"{part}\n"))
            sys.stdout.flush()

    return show


def _with_page(out: str | None) -> str | None:
    """Return the name of an output folder with its report."""
    page = Path(out or "") / "report.html"
    return f"{out}, open {page}" if out and page.is_file() else out


def _stems(operation: Operation, typed: Mapping[str, Any]) -> dict[str, Any]:
    """Return the arguments as typed, files without folder and suffix; empty without arguments."""
    files = {p.option for p in operation.parameters if isinstance(p.mark, File)}
    return {
        option: "" if value is None else Path(str(value)).stem if option in files else value
        for option, value in typed.items()
    }


def _echo(operation: Operation, read: Mapping[str, Any]) -> dict[str, Any]:
    """Return the options to repeat in the output, with an empty mapping for missing pairs."""
    absent: dict[str, Any] = {
        p.option: {} if isinstance(p.mark, Pairs) else None for p in operation.parameters
    }
    values = {**absent, **read}
    return {
        key: values[options]
        if isinstance(options, str)
        else {option: values[option] for option in options}
        for key, options in operation.echo.items()
    }


def _exit_code(result: Any) -> int:
    """Print on stderr why a result is incomplete, and its findings; return the exit code."""
    stopped, remark = getattr(result, "stopped", ""), getattr(result, "remark", "")
    wrong = [f"{stopped}."] if stopped else getattr(result, "problems", ())
    for problem in wrong:
        tell(problem)
    if wrong or not getattr(result, "is_whole", True):
        return REFUSED
    if remark:
        tell(remark)
    return DONE if getattr(result, "is_met", True) else FAILED
