"""``jounce campaign`` and ``jounce demo``: bench campaigns, a commented template, and the shipped example."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.derived import add_commands
from jounce.cli.options import AsJson, Force, check_outputs
from jounce.cli.reply import DONE, FAILED, Reply, progress
from jounce.core.commands import command_line
from jounce.operations.index import operations
from jounce.operations.request import naming_options

if TYPE_CHECKING:
    from rich.console import Console


_RUN = {parameter.option: parameter for parameter in operations()["campaign run"].parameters}


def _like(option: str) -> Any:
    """Create an option of the demo from that of `campaign run`."""
    mark = _RUN[option].mark
    return Annotated[
        list[str] | None, typer.Option(f"--{option}", metavar=mark.metavar, help=mark.help)
    ]


Figures, Tables, Reports = _like("figure"), _like("table"), _like("report")
app = typer.Typer(no_args_is_help=True, help="Evaluate a bench campaign, or start a new one.")


add_commands(app, "campaign")


def demo(
    out: Annotated[
        Path | None, typer.Option(help="Output folder; by default a new numbered one.")
    ] = None,
    quick: Annotated[
        bool,
        typer.Option(
            "--quick", help="Model the prototype as a quarter car instead of a double wishbone."
        ),
    ] = False,
    figure: Figures = None,  # type: ignore[valid-type]
    table_: Tables = None,  # type: ignore[valid-type]
    report: Reports = None,  # type: ignore[valid-type]
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Copy the shipped campaign (synthetic measurements) into a folder and run it, with the rig modelled in 3-D.

    Example: jounce demo --out jounce-demo
    """
    from jounce.report.campaign_folder import STAGES, check_forms, reported_page, write_reported

    check_outputs(folder=out, force=force)
    asked = {"figures": figure or (), "tables": table_ or (), "reports": report or ()}
    with naming_options(_RUN.values()):
        check_forms(**asked)
    with progress(STAGES) as say:
        from jounce.papers.demo import run_demo

        folder, result = run_demo(out, quick=quick, force=force, progress=say)
        say("writing the report")
        # the folder now contains the campaign, but no other files of these names
        reported = write_reported(result, folder, force=True, **asked)

    def draw(console: Console) -> None:
        from jounce.cli.terminal import show_page

        show_page(console, reported_page(reported, title=result.campaign.title))
        page = folder.resolve() / "report.html"
        if page.is_file():
            console.print(f"the report: {page.as_uri()}", soft_wrap=True, highlight=False)
        console.print(
            f"the workbench: {command_line(['jounce', 'serve', str(folder)])}",
            soft_wrap=True,
            highlight=False,
        )

    return Reply(
        reported.to_dict(), draw, as_json, DONE if reported.is_met else FAILED, reported.missing
    )
