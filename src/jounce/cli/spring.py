"""``jounce spring``: springs and bump stops from a press."""

from __future__ import annotations

import typer

from jounce.cli.derived import add_commands

app = typer.Typer(
    no_args_is_help=True, help="Springs and bump stops from a press: their map over loading speed."
)
add_commands(app, "spring")
