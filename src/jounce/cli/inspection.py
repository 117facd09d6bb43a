"""``jounce inspect``: shock absorbers on testers."""

from __future__ import annotations

import typer

from jounce.cli import inspect_simulate

app = typer.Typer(help="Shock-absorber inspection: simulate testers.", no_args_is_help=True)
app.command("simulate")(inspect_simulate.simulate)
