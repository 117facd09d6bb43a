"""``jounce damper``: the damper's workbench."""

from __future__ import annotations

import typer

from jounce.cli.derived import add_commands

app = typer.Typer(
    no_args_is_help=True,
    help="Dampers from a test rig (dyno): their map over velocity and clicks; from the track: their histograms.",
)
add_commands(app, "damper")
