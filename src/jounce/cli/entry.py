"""The entry point: find the command, run it, print its reply, turn every error into one message and an exit code."""

from __future__ import annotations

import contextlib
import errno
import os
import sys
import traceback
from collections.abc import Sequence
from enum import StrEnum
from functools import cache
from typing import Annotated, Any

import typer

from jounce.cli import (
    analysis,
    bench,
    campaign,
    damper,
    design,
    exchange,
    fit,
    importing,
    inspection,
    pictures,
    spring,
    study,
)
from jounce.cli.added import ADDED
from jounce.cli.derived import command_function
from jounce.cli.everywhere import as_usual, open_pages, with_shared_options
from jounce.cli.options import AsJson
from jounce.cli.pipes import without_pipes
from jounce.cli.reply import (
    DONE,
    FAILED,
    PIPE_CLOSED,
    REFUSED,
    Reply,
    lead_nowhere,
    make_streams_usable,
    refuse,
    report_error,
    tell,
)
from jounce.core.errors import (
    JounceError,
    OutputError,
    ResourceError,
    is_of_system,
    nearest,
    resource_error,
    unforeseen,
)
from jounce.core.interrupts import INTERRUPTED, signal_of, uncovering_interrupts
from jounce.core.phrases import Phrase
from jounce.core.text import shorten
from jounce.core.trust import trusting

EPILOG = 'Values carry their units: --speed "1.95 m/s"; bare numbers are SI. --debug shows the traceback of a crash.'
_LONGEST = 1000  # maximum characters of a message of the command-line parser
_TOO_LARGE = "Reduce the number of samples with a shorter duration or a larger output step."
_SAMPLED = {"simulate", "ride", "compare", "speed-limit", "sweep"}
_SAMPLED |= {"animate", "plot", "campaign", "demo"}
_CLICK_ERROR: type[Exception] = next(
    kind for kind in typer.BadParameter.__mro__ if kind.__name__ == "ClickException"
)


def _panels() -> dict[str, dict[str, Any]]:
    """Commands and groups by the panel of the help in which they are listed."""
    return {
        "From measurements to decisions": {
            "bench": bench.app,
            "analyse": analysis.app,
            "fit": fit.app,
            "damper": damper.app,
            "spring": spring.app,
            "campaign": campaign.app,
            "inspect": inspection.app,
            "study": study.app,
            "demo": campaign.demo,
        },
        "Simulation": {
            "simulate": command_function("simulate"),
            "modes": command_function("modes"),
            "ride": command_function("ride"),
            "ride-metrics": command_function("ride-metrics"),
            "compare": command_function("compare"),
            "speed-limit": command_function("speed-limit"),
            "sweep": command_function("sweep"),
            "iri": command_function("iri"),
        },
        "Kinematics and design": {
            "kinematics": command_function("kinematics"),
            "kc": command_function("kc"),
            "adjust": command_function("adjust"),
            "load-cases": command_function("load-cases"),
            "clearances": command_function("clearances"),
            "steering-effort": command_function("steering-effort"),
            "design": design.app,
        },
        "Files and pictures": {
            "check": command_function("check"),
            "library": command_function("library"),
            "import": importing.app,
            "export": exchange.export_app,
            "plot": pictures.plot,
            "draw": pictures.draw,
            "animate": pictures.animate,
        },
        "Workbench and shell": {**ADDED, "completion": completion, "version": version},
    }


def application() -> typer.Typer:
    """Assemble the commands."""
    app = typer.Typer(
        name="jounce",
        help="From bench measurements to a validated suspension model, and from the model to decisions.",
        epilog=EPILOG,
        no_args_is_help=True,
        add_completion=False,
        rich_markup_mode="rich",
    )
    for panel, rows in _panels().items():
        for name, row in rows.items():
            if isinstance(row, typer.Typer):
                app.add_typer(row, name=name, rich_help_panel=panel)
            else:
                app.command(name, rich_help_panel=panel)(row)

    @app.callback()
    def above(  # the options before a command
        shows_version: Annotated[
            bool, typer.Option("--version", help="Print versions (same as `jounce version`).")
        ] = False,
    ) -> None:
        """Declare the options; the function does nothing."""

    return app


def version(as_json: AsJson = False) -> Reply:
    """Print the version of jounce, of what it runs on, and the folder that keeps compiled models.

    Example: jounce version
    """
    import platform
    from importlib import metadata

    def installed_version(name: str) -> str | None:
        try:
            return metadata.version(name)
        except metadata.PackageNotFoundError:
            return None

    from jounce.kernel.cache import cache_folder, why_not_kept

    cache: str | None = None
    with contextlib.suppress(RuntimeError):
        cache = str(cache_folder())
    plain: dict[str, str | None] = {
        "jounce": metadata.version("jounce"),
        "python": platform.python_version(),
    }
    plain |= {
        name: installed_version(name) for name in ("casadi", "llvmlite", "numba", "numpy", "scipy")
    }
    plain |= {
        "system": platform.platform(),
        "cache": cache,
        "cache_unusable": why_not_kept() or None,
    }
    rows = [
        f"{name} {value or 'none'}" for name, value in plain.items() if name != "cache_unusable"
    ]
    if why := plain["cache_unusable"]:
        rows.append(
            f"compiled models are not kept, every process makes its own: {why}. Set JOUNCE_CACHE_DIR"
        )
    return Reply(plain, lambda out: out.print(*rows, sep="\n", soft_wrap=True), as_json)


class Shell(StrEnum):
    """Shells with command completion."""

    BASH = "bash"
    ZSH = "zsh"
    FISH = "fish"
    POWERSHELL = "powershell"


def completion(
    shell: Annotated[Shell, typer.Argument(metavar="SHELL", help="bash, zsh, fish or powershell.")],
    install: Annotated[
        bool,
        typer.Option(
            "--install",
            help="Add it to what the shell reads when it starts, instead of printing it.",
        ),
    ] = False,
    as_json: AsJson = False,
) -> Reply:
    """Print the script with which a shell completes commands, options and names of the library, or install it.

    Example: jounce completion bash --install
    """
    from typer.completion import get_completion_script  # type: ignore[attr-defined]
    from typer.completion import install as install_completion  # type: ignore[attr-defined]

    if install:
        try:
            _, file = install_completion(shell.value, "jounce", _COMPLETION)
        except RuntimeError:  # of pathlib
            raise OutputError(
                "the home folder with the settings of the shell is unknown",
                where="--install",
                hint="Set HOME, or print the script without --install and let the shell read it.",
            ) from None
        plain = {"shell": shell.value, "installed": str(file)}
        return Reply(
            plain, lambda out: out.print(f"installed: {file}; it works in new shells"), as_json
        )
    script = get_completion_script(prog_name="jounce", complete_var=_COMPLETION, shell=shell.value)
    return Reply(
        {"shell": shell.value, "script": script},
        lambda out: out.out(script, highlight=False),
        as_json,
    )


_COMPLETION = "_JOUNCE_COMPLETE"
"""Environment variable with which a shell requests completions."""


def _one_thread_for_matrices() -> None:
    """Limit the numerical libraries of NumPy, imported later, to one thread unless the user has set a number.

    The matrices of fits are small: several threads double the CPU time of a campaign without a speed-up.
    """
    for library in ("OPENBLAS", "MKL", "OMP", "VECLIB"):
        name = "VECLIB_MAXIMUM_THREADS" if library == "VECLIB" else f"{library}_NUM_THREADS"
        os.environ.setdefault(name, "1")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command line.

    Parameters
    ----------
    arguments : sequence of str, optional
        Words after ``jounce``; by default those of this process.

    Returns
    -------
    int
        Exit code: 0 done, 1 something failed, 2 the request is wrong, 130 interrupted, 129 or 143 where the terminal
        was closed or the system asked to end.
    """
    make_streams_usable()
    _one_thread_for_matrices()
    words = list(sys.argv[1:] if arguments is None else arguments)
    debug = "--debug" in words
    words = [word for word in words if word != "--debug"]
    as_json = "--json" in words
    if words[:1] == ["--version"]:
        words[0] = "version"
    try:
        if any("\0" in word for word in words):
            raise JounceError(
                "an argument with a NUL character",
                found=next(word for word in words if "\0" in word),
            )
        if _COMPLETION in os.environ:
            return _complete(words)
        with trusting(False), uncovering_interrupts(), without_pipes(words) as words:
            exit_code = _answer(words)
        sys.stdout.flush()
    except (KeyboardInterrupt, typer.Abort) as error:
        for note in getattr(error, "__notes__", ()):
            tell(note)
        tell(INTERRUPTED)
        return 128 + signal_of(error)  # as shells count
    except (
        BrokenPipeError,
        SystemExit,
    ):  # the reader has closed the pipe; the help's console ends the process in that case
        lead_nowhere(sys.stdout)
        return PIPE_CLOSED
    except _CLICK_ERROR as error:
        return _explain_misuse(error, as_json=as_json)
    except JounceError as error:
        return refuse(error, as_json=as_json)
    except UnicodeEncodeError as error:
        hint = "Is its encoding something other than UTF-8?"
        return refuse(
            JounceError("text that is not valid Unicode", found=error.object, hint=hint),
            as_json=as_json,
        )
    except Exception as error:  # noqa: BLE001 - the last resort explains how to report it
        if (
            isinstance(error, MemoryError) and hasattr(error, "shape") and words[0] in _SAMPLED
        ):  # from NumPy's arrays
            return refuse(
                ResourceError("out of memory", found=str(error), hint=_TOO_LARGE), as_json=as_json
            )
        if is_of_system(error):
            return refuse(resource_error(error, _place_of(error)), as_json=as_json)
        if isinstance(error, MemoryError):
            return refuse(unforeseen(error), as_json=as_json)
        if isinstance(error, OSError):
            hint = "Check the path, the permissions and the free disk space."
            return refuse(
                OutputError(error.strerror or str(error), where=_place_of(error), hint=hint),
                as_json=as_json,
            )
        if debug:
            traceback.print_exc()
        what = shorten(f"internal error: {type(error).__name__}: {error}", _LONGEST)
        hint = "Please report it with the command and its files; --debug shows the traceback."
        plain = {"kind": "unexpected", "message": f"{what}. {hint}", "what": what, "hint": hint}
        return report_error(plain, FAILED, as_json=as_json)
    return exit_code


def _place_of(error: Exception) -> str:
    """Return the path that a system error refers to, if the error does not contain it."""
    if not isinstance(error, OSError):
        return ""
    if error.filename:
        return str(error.filename)
    if error.errno in (errno.ENOSPC, errno.EFBIG, errno.EIO):
        lead_nowhere(sys.stdout)
        return "standard output"
    try:
        os.getcwd()  # noqa: PTH109 - only checks that it exists
    except OSError:
        return "the current folder"
    return ""


@cache
def _command(word: str = "") -> Any:
    """Commands, built from their signatures once per process; only the requested one if the line begins with it.

    Any other word (an option, a misspelt name) loads all of them, to list or suggest commands.
    """
    app = application()
    commands = [one for one in app.registered_commands if one.name == word]
    groups = [one for one in app.registered_groups if one.name == word]
    if commands or groups:
        app.registered_commands, app.registered_groups = commands, groups
    return with_shared_options(typer.main.get_command(app))


def _complete(words: list[str]) -> int:
    """Respond to a completion request of a shell."""
    from typer.completion import completion_init  # type: ignore[attr-defined]

    completion_init()  # registers the shells and their request formats
    try:
        _command().main(words, prog_name="jounce", complete_var=_COMPLETION)
    except SystemExit as end:
        return int(end.code or 0)
    return DONE


def _answer(words: list[str]) -> int:
    with as_usual():
        with (
            contextlib.redirect_stdout(sys.stderr)
            if "--json" in words
            else contextlib.nullcontext()
        ):
            try:
                command = _command(words[0] if words else "")
                with command.make_context("jounce", words) as context:
                    reply = command.invoke(context)
            except typer.Exit as end:  # after --help
                return end.exit_code
        if not isinstance(reply, Reply):
            return 0
        exit_code = reply.show()
        open_pages(reply.plain)
        return exit_code


def _explain_misuse(error: Any, *, as_json: bool) -> int:
    """Explain an invalid command line."""
    context = getattr(error, "ctx", None)
    path = context.command_path if context is not None else "jounce"
    message = shorten(error.format_message().replace("Value error, ", ""), _LONGEST)
    if type(error).__name__ == "NoArgsIsHelpError":
        if not as_json:
            sys.stderr.write(f"{message}\n" if message else "")
            return REFUSED
        message = "no command is given"
    option = getattr(error, "option_name", None)
    if type(error).__name__ == "NoSuchOption" and option and context is not None:
        message = f"no such option: {option}. {_instead(option, context.command.params)}".rstrip()
    if type(error).__name__ == "MissingParameter" and (told := getattr(error.param, "help", None)):
        message = f"{message.rstrip('.')}: {told[:1].lower()}{told[1:]}"
    hint = Phrase("See `{path} --help`.", path=path)
    message = message if message.endswith((".", "?")) else f"{message}."
    plain = {
        "kind": "UsageError",
        "message": f"{message} {hint}",
        "where": path,
        "what": message,
        "hint": hint,
    }
    return report_error(plain, REFUSED, as_json=as_json)


def _instead(option: str, parameters: list[Any]) -> str:
    """Return a suggestion for an unknown option."""
    names = [name for parameter in parameters for name in parameter.opts]
    hint = nearest(option, [name for name in names if name.startswith("-")])
    if not hint and nearest(
        option.lstrip("-"), [name for name in names if not name.startswith("-")]
    ):
        return f"Give the value without {option}."
    return hint
