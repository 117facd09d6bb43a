"""``jounce fit``: stiffness, decays, damper laws, calibrations and hardpoints from measured files."""

from __future__ import annotations

import typer

from jounce.cli.derived import add_commands

app = typer.Typer(
    no_args_is_help=True, help="Find stiffness, damping and damper laws from measurements."
)
add_commands(app, "fit")
