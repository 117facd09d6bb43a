"""``jounce export``: rigs for other programs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal, cast

import typer

from jounce.cli.options import AsJson, Changes, Force, RigName, changes, chosen_rig
from jounce.cli.reply import Reply, progress, show_findings, show_written
from jounce.core.errors import DescriptionError

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.exchange.fmu import FmuExport

export_app = typer.Typer(no_args_is_help=True, help="Write rigs for other programs.")


@export_app.callback()
def _export() -> None:
    """Keep the name of the format part of the command even where there is only one."""


@export_app.command("fmu")
def fmu(
    rig: RigName,
    out: Annotated[Path, typer.Option(metavar="CAR.fmu", help="File to write.")],
    fmi: Annotated[int, typer.Option(help="Version of FMI: 2 or 3.")] = 3,
    platform: Annotated[
        list[str] | None,
        typer.Option(
            metavar="PLATFORM",
            help="Compile for x86_64-linux, aarch64-linux, x86_64-windows, x86_64-darwin or aarch64-darwin; repeat it. "
            "Default: this machine. Others need the extra fmu.",
        ),
    ] = None,
    sources_only: Annotated[bool, typer.Option("--sources-only", help="Compile nothing: the FMU holds its C.")] = False,
    control: Annotated[
        str | None, typer.Option(help="Controller to put in: a name such as skyhook, or a file.")
    ] = None,
    set_: Changes = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Write a rig or vehicle as a Functional Mock-up Unit: model exchange and co-simulation in one file.

    Example: jounce export fmu kart-quarter-car --out kart.fmu
    """
    if sources_only and platform:
        what = "--platform says for what is compiled, and --sources-only that nothing is"
        raise DescriptionError(what, found=platform, hint="Leave one of them out.")
    with progress() as say:
        say("loading")
        from jounce.exchange.fmu import export_fmu

        chosen = chosen_rig(rig, changes(set_))
        say("writing the FMU")
        version = cast("Literal[2, 3]", fmi)
        platforms = () if sources_only else platform or None
        made = export_fmu(chosen, out, version=version, platforms=platforms, control=control, force=force)
    plain = {"rig": rig, "control": control, **made.to_dict(), "out": str(out)}
    return Reply(plain, lambda console: _draw(console, made, plain), as_json)


def _draw(console: Console, made: FmuExport, plain: dict[str, object]) -> None:
    binaries = f"for {', '.join(made.platforms)}" if made.platforms else "as sources only"
    console.print(f"FMI {made.version}.0, model exchange and co-simulation, {binaries}")
    console.print(f"inputs: {', '.join(made.inputs) or 'none'}")
    console.print(f"{len(made.outputs)} outputs, {made.states} states, {made.parameters} parameters (rig.*)")
    show_findings(console, list(made.findings))
    show_written(console, plain)
