"""``jounce study inspection-equivalence``: what three shock-absorber tests say of the same car."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import AsJson, Changes, Force, RigName, changes
from jounce.cli.outputs import FigureFile, check_outputs, write_picture
from jounce.cli.reply import Reply, progress
from jounce.cli.rigs import chosen_rig
from jounce.cli.tables import show_written, table

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.inspection.equivalence import Equivalence, Factor


def register(app: typer.Typer) -> None:
    """Add the command to ``jounce study``."""
    app.command("inspection-equivalence")(equivalence)


def equivalence(
    rig: RigName,
    points: Annotated[int, typer.Option(min=2, max=200, help="Values of tyre stiffness, load and friction.")] = 28,
    set_: Changes = None,
    limits: Annotated[Path | None, typer.Option(help="Another limits file.")] = None,
    figure: FigureFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Compare adhesion, phase angle and THETA of one wheel over damper wear, tyre stiffness, load and friction.

    Example: jounce study inspection-equivalence audi-a6-quarter-car --figure tests.png
    """
    check_outputs(figure=figure, force=force)
    wanted = changes(set_)
    with progress() as say:
        say("loading")
        from jounce.inspection.equivalence import compare_tests, usual_factors
        from jounce.inspection.limits import load_limits

        study = compare_tests(
            chosen_rig(rig, wanted),  # type: ignore[arg-type]
            factors=usual_factors(points),
            limits=load_limits(limits),
            workers=os.cpu_count() or 1,
            progress=lambda share: say(f"testing: {100.0 * share:.0f} %"),
        )
        write_picture(study, figure, force=force)
    plain = {"rig": rig, "changes": wanted, **study.to_dict(), "figure": figure and str(figure)}
    return Reply(plain, lambda console: _draw(console, plain, study), as_json)


def _draw(console: Console, plain: dict[str, Any], study: Equivalence) -> None:
    factors = {factor.name: factor for factor in study.factors}
    rows = [
        (
            factors[one.factor].label,
            one.method,
            f"{one.rejected_sound} of {one.sound}",
            _range(factors[one.factor], one.rejected_at),
            f"{one.passed_worn} of {one.worn}",
            _range(factors[one.factor], one.passed_at),
        )
        for one in study.disagreements
    ]
    header = ("varied", "method", "sound rejected", "at", "worn passed", "at")
    title = (
        f"{plain['rig']}: sound is a damper that lost up to {100.0 * plain['sound_up_to']:.0f} %, worn one that lost "
    )
    title += f"{100.0 * plain['worn_from']:.0f} % or more (estimated)"
    console.print(table(title, header, rows, text=tuple(range(6))))
    console.print(f"{plain['tests']} simulated tests, limits {plain['limits']}")
    show_written(console, plain)


def _range(factor: Factor, ends: tuple[float, float] | None) -> str:
    return " to ".join(f"{factor.scale * end:.4g}" for end in dict.fromkeys(ends or ()))
