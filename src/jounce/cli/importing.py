"""``jounce import``: models of other programs as rig files."""

from __future__ import annotations

import typer

from jounce.cli.derived import add_commands

app = typer.Typer(no_args_is_help=True, help="Convert models of other programs to rig files.")
add_commands(app, "import")
