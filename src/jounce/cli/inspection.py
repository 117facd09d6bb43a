"""``jounce inspect``: shock absorbers on testers, simulated and measured, graded, and kept in the lane's store."""

from __future__ import annotations

import typer

from jounce.cli.derived import add_commands

app = typer.Typer(
    help=(
        "Shock-absorber inspection: simulate testers, evaluate and grade their records, print protocols, and keep all "
        "of it in the lane's record store (--store lane.sqlite)."
    ),
    no_args_is_help=True,
)
add_commands(app, "inspect")
