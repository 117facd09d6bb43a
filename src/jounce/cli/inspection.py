"""``jounce inspect``: shock absorbers on testers."""

from __future__ import annotations

import typer

from jounce.cli import inspect_evaluate, inspect_simulate, inspect_store

app = typer.Typer(
    help=(
        "Shock-absorber inspection: simulate testers, evaluate and grade their records, print protocols, and keep all "
        "of it in the lane's record store (--store lane.sqlite)."
    ),
    no_args_is_help=True,
)
app.command("simulate")(inspect_simulate.simulate)
app.command("evaluate")(inspect_evaluate.evaluate)
inspect_store.register(app)
