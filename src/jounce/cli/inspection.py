"""``jounce inspect``: shock absorbers on testers."""

from __future__ import annotations

import typer

from jounce.cli import inspect_evaluate, inspect_simulate, inspect_store

app = typer.Typer(help="Shock-absorber inspection: simulate testers, evaluate their records.", no_args_is_help=True)
app.command("simulate")(inspect_simulate.simulate)
app.command("evaluate")(inspect_evaluate.evaluate)
inspect_store.register(app)
