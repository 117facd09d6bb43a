"""``jounce bench``: the laboratory bench, its drive, its prototype, its springs."""

from __future__ import annotations

import typer

from jounce.cli.derived import add_commands

app = typer.Typer(
    no_args_is_help=True,
    help="The laboratory bench: belt speed, drive, similitude, choice of spring.",
)
add_commands(app, "bench")
