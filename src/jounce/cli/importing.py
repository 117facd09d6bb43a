"""``jounce import``: descriptions of other programs as rig files."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import AsJson, Force, optional_positive
from jounce.cli.reply import Reply
from jounce.cli.tables import show_findings

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.core.findings import Finding

app = typer.Typer(no_args_is_help=True, help="Read descriptions of other programs as rig files.")


@app.callback()
def _import() -> None:
    """Keep the name of a program part of the command even where there is only one."""


@app.command("chrono")
def chrono(
    file: Annotated[Path, typer.Argument(metavar="FILE.json", help="DoubleWishbone, MacPhersonStrut or MultiLink.")],
    out: Annotated[Path | None, typer.Option(help="Rig file to write; without it, it goes to stdout.")] = None,
    wheel_radius: Annotated[str | None, typer.Option(help="Undeformed tyre; estimated 330 mm.")] = None,
    wheel_mass: Annotated[str | None, typer.Option(help="Rim and tyre; estimated 20 kg.")] = None,
    tyre_stiffness: Annotated[str | None, typer.Option(help="Estimated 250 N/mm.")] = None,
    sprung_mass: Annotated[
        str | None, typer.Option(help="Body on this wheel; estimated as what the spring carries at design.")
    ] = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Read a suspension of Project Chrono as the left corner of a 3-D rig.

    Example: jounce import chrono suspension.json --out rig.toml --wheel-radius "344 mm"
    """
    from jounce.core.serialise import check_writable, write_atomically
    from jounce.parts import rig_findings
    from jounce.parts.importers import import_chrono

    if out is not None:
        check_writable(out, force=force)
    rig, findings, text = import_chrono(
        file,
        wheel_radius=optional_positive(wheel_radius, "m", "--wheel-radius"),
        wheel_mass=optional_positive(wheel_mass, "kg", "--wheel-mass"),
        tyre_stiffness=optional_positive(tyre_stiffness, "N/m", "--tyre-stiffness"),
        sprung_mass=optional_positive(sprung_mass, "kg", "--sprung-mass"),
    )
    found = [*findings, *rig_findings(rig, "" if out is None else str(out))]
    if out is not None:
        write_atomically(out, text, force=force)
    plain = {
        "file": str(file),
        "model": getattr(rig, "model", ""),
        "source": rig.source,
        "estimated": list(rig.estimated),
        "findings": found,
        "out": None if out is None else str(out),
        "text": text,
    }
    return Reply(plain, lambda console: _draw(console, plain, found), as_json)


def _draw(console: Console, plain: dict[str, Any], findings: list[Finding]) -> None:
    """Show the rig file alone on stdout, or what was written and what to know about it."""
    if plain["out"] is None:
        sys.stdout.write(plain["text"])
        sys.stderr.writelines(f"{finding}\n" for finding in findings if finding.severity != "note")
        return
    console.print(f"{plain['out']}: {plain['model']}, {plain['source']}")
    console.print(f"estimated: {', '.join(plain['estimated']) or 'nothing'}")
    show_findings(console, findings)
