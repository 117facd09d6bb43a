"""``jounce export``: rigs for other programs."""

from __future__ import annotations

import typer

from jounce.cli.derived import add_commands

export_app = typer.Typer(no_args_is_help=True, help="Write rigs for other programs.")
add_commands(export_app, "export")
