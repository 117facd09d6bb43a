"""``jounce demo``: the shipped campaign, from measurements to the report."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from jounce.cli.campaign import campaign_reply
from jounce.cli.options import AsJson, Force
from jounce.cli.outputs import check_outputs
from jounce.cli.reply import Reply, progress


def demo(
    out: Annotated[Path | None, typer.Option(help="Folder to write; without it a new numbered one.")] = None,
    quick: Annotated[
        bool, typer.Option("--quick", help="Take the prototype for a quarter car instead of its double wishbone.")
    ] = False,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Copy the shipped campaign (synthetic measurements) into a folder and run it, with the rig in 3-D.

    Example: jounce demo --out jounce-demo
    """
    check_outputs(folder=out, force=force)
    with progress() as say:
        from jounce.papers.demo import run_demo
        from jounce.report import write_campaign

        folder, result = run_demo(out, quick=quick, force=force, progress=say)
        say("writing the report")
        write_campaign(result, folder, force=True)  # it holds the campaign by now, and nothing else of these names
    return campaign_reply(result, folder, as_json=as_json)
