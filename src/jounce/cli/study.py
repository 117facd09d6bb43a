"""``jounce study``: shipped studies, on real measurements, of models, of shock-absorber tests, and of the papers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from jounce.cli.derived import add_commands
from jounce.cli.options import STROKE, AsJson, Force, check_outputs
from jounce.cli.reply import Reply, drawing, progress
from jounce.core.typed import positive_quantity, quantity

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.core.findings import Finding


app = typer.Typer(no_args_is_help=True, help="Shipped studies.")


@app.callback()
def _study() -> None:
    """Callback that keeps the study name a part of the command even if there is only one study."""


@app.command("proving-ground")
def proving_ground(
    out: Annotated[
        Path | None, typer.Option(help="Folder for report, figures and results.json.")
    ] = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Drive a real vehicle with a measured damper over a measured course. Without --out nothing is written.

    Example: jounce study proving-ground --out proving-ground
    """
    check_outputs(folder=out, force=force)
    with progress() as say:
        from jounce.papers.proving_ground import run_proving_ground

        study = run_proving_ground(progress=say)
        missing = _write(study, out, "proving_ground", say, force=force)
    plain = {**study.to_dict(), "out": None if out is None else str(out)}
    return Reply(plain, partial(_draw, study, "proving_ground", out), as_json, missing=missing)


def _draw(study: object, name: str, out: Path | None, console: Console) -> None:
    """Print the page of a study without its curves, and the location of the full report."""
    from jounce.cli.terminal import show_page
    from jounce.report import papers

    show_page(console, getattr(papers, f"{name}_summary")(study))
    console.print(
        "nothing was written; give --out DIR to keep the results"
        if out is None
        else f"written: {out}, open {out / 'report.html'}"
    )


def _write(
    study: object, out: Path | None, name: str, say: Callable[[str], None], *, force: bool
) -> Sequence[Finding]:
    """Write the results of a study and its page into a folder, if given; return what could not be drawn."""
    if out is None:
        return ()
    from jounce.report import papers, write_page
    from jounce.report.render import figures_here

    files = getattr(papers, f"{name}_files")(study)
    with drawing() as missing:
        page = getattr(papers, f"{name}_page")
        write_page(
            lambda: page(study), out, files=files, force=force, figures=figures_here(), progress=say
        )
    return missing


Out = Annotated[
    Path | None,
    typer.Option(help="Folder for report, figures, curves (CSV, netCDF) and results.json."),
]


@app.command("audi-a6-case-a")
def case_a(out: Out = None, force: Force = False, as_json: AsJson = False) -> Reply:
    """Brake the paper's Audi A6 onto a 5 cm obstacle, in three variants. Without --out nothing is written.

    Example: jounce study audi-a6-case-a --out case-a
    """
    return _case("case-a", out, force, as_json)


@app.command("audi-a6-case-b")
def case_b(out: Out = None, force: Force = False, as_json: AsJson = False) -> Reply:
    """Accelerate the paper's Audi A6 into a 2 cm pothole, in three variants. Without --out nothing is written.

    Example: jounce study audi-a6-case-b --json
    """
    return _case("case-b", out, force, as_json)


@app.command("audi-a6-excenter")
def exciter(
    amplitude: Annotated[
        str, typer.Option(help="Of the exciter: half the stroke. Estimated.")
    ] = "3 mm",
    plate_mass: Annotated[str, typer.Option(help="Mass of the plate. Estimated.")] = "20 kg",
    out: Out = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Put the paper's front corner on a driven plate, in three models. Without --out nothing is written.

    Example: jounce study audi-a6-excenter --amplitude "3 mm"
    """
    size = positive_quantity(amplitude, "m", "--amplitude", most=STROKE)
    mass = quantity(plate_mass, "kg", "--plate-mass")
    check_outputs(folder=out, force=force)
    with progress() as say:
        from jounce.papers.audi_a6_exciter import run_eccentric_exciter

        study = run_eccentric_exciter(size, mass, progress=say)
        missing = _write(study, out, "exciter", say, force=force)
    plain = {**study.to_dict(), "out": None if out is None else str(out)}
    return Reply(plain, partial(_draw, study, "exciter", out), as_json, missing=missing)


def _case(name: str, out: Path | None, force: bool, as_json: bool) -> Reply:
    check_outputs(folder=out, force=force)
    with progress() as say:
        from jounce.papers.audi_a6 import run_audi_a6

        study = run_audi_a6(name, progress=say)
        missing = _write(study, out, "audi_case", say, force=force)
    plain = {**study.to_dict(), "out": None if out is None else str(out)}
    return Reply(plain, partial(_draw, study, "audi_case", out), as_json, missing=missing)


add_commands(app, "study")
