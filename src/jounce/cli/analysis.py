"""``jounce analyse``: statistics, spectra, transfer functions, modes and motion of measured records."""

from __future__ import annotations

import typer

from jounce.cli.derived import add_commands

app = typer.Typer(
    no_args_is_help=True,
    help="Look at a record: statistics, spectra, transfer functions, modes, integrated motion.",
)
add_commands(app, "analyse")
