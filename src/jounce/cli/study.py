"""``jounce study``: shipped studies on real measurements."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import AsJson, Force
from jounce.cli.reply import Reply, progress
from jounce.cli.tables import show_findings, table

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.studies.proving_ground import ProvingGround

app = typer.Typer(no_args_is_help=True, help="Shipped studies on real measurements.")


@app.callback()
def _study() -> None:
    """Keep the name of a study part of the command even where there is only one."""


@app.command("proving-ground")
def proving_ground(
    out: Annotated[Path | None, typer.Option(help="Folder for report, figures and results.json.")] = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Drive a real vehicle with a measured damper over a measured course; without --out nothing is written.

    Example: jounce study proving-ground --out proving-ground
    """
    from jounce.report.folder import check_folder

    if out is not None:
        check_folder(out, force=force)
    with progress() as say:
        from jounce.studies.proving_ground import run_proving_ground

        study = run_proving_ground(progress=say)
        if out is not None:
            from jounce.report.proving_ground import write_proving_ground

            write_proving_ground(study, out, force=force, progress=say)
    plain = {**study.to_dict(), "out": None if out is None else str(out)}
    return Reply(plain, lambda console: _draw(console, plain, study, out), as_json)


def _draw(console: Console, plain: dict[str, Any], study: ProvingGround, out: Path | None) -> None:
    rows = [
        (record, law, 100.0 * fit["nrmse"], fit["r2"])
        for record, laws in plain["damper_fits"].items()
        for law, fit in laws.items()
    ]
    console.print(table("Measured damper", ("record", "law", "NRMSE %", "R2"), rows, text=(0, 1)))
    model = [
        (item["name"], item["value"], item["unit"], "estimated" if item["is_estimated"] else "")
        for item in plain["model"]
    ]
    console.print(table("Quarter car (SI)", ("quantity", "value", "unit", ""), model, text=(0, 2, 3)))
    rows = [
        (name, damper, *values) for name, by_damper in plain["figures"].items() for damper, values in by_damper.items()
    ]
    header = ("figure (SI)", "damper", *(f"{3.6 * speed:.0f} km/h" for speed in plain["speed"]))
    console.print(table("Ride over the measured course, unweighted", header, rows, text=(0, 1)))
    show_findings(console, study.findings)
    console.print(
        "nothing was written: give --out DIR" if out is None else f"written: {out}, open {out / 'report.html'}"
    )
