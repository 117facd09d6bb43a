"""``jounce design``: springs for a frequency, optimisation within bounds, comfort against road holding."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.derived import add_commands
from jounce.cli.options import (
    AsJson,
    Force,
    check_outputs,
)
from jounce.cli.reply import Reply, drawing, progress, show_findings, show_written, table

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.design.hardpoint_front import KinematicFront


app = typer.Typer(no_args_is_help=True, help="Springs, dampers, hardpoints and best designs.")
add_commands(app, "design")


@app.command("kinematic-front")
def kinematic_front(
    study: Annotated[
        Path,
        typer.Argument(
            metavar="STUDY.toml", help='Study file, schema = "jounce.design/1".', show_default=False
        ),
    ],
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR",
            help="Write front.csv, results.json, front.png and a rig for each design.",
        ),
    ] = None,
    points: Annotated[int, typer.Option(help="About how many designs.")] = 20,
    starts: Annotated[
        int, typer.Option(min=1, help="Number of searches for the best of each goal.")
    ] = 4,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Find the Pareto front of hardpoints for competing goals.

    Targets with the same goal = "..." belong together; those that must hold are kept within their tolerances.

    Example: jounce design kinematic-front study.toml --points 12 --out front
    """
    check_outputs(folder=out, force=force)
    with progress() as say:
        say("searching")
        from jounce.design.hardpoint_front import front_of
        from jounce.design.kinematics import run_study

        front, sources = run_study(
            study, lambda asked, task: front_of(task, points, starts, asked.seed)
        )
        missing: Sequence[Finding] = ()
        if out is not None:
            say("drawing")
            missing = _write_front(front, sources, out, force=force)
    plain = {**front.to_dict(), "out": out and str(out)}
    return Reply(
        plain, lambda console: draw_kinematic_front(console, plain, front), as_json, missing=missing
    )


def _write_front(
    front: KinematicFront, sources: Mapping[str, Path], out: Path, *, force: bool
) -> Sequence[Finding]:
    """Write the designs of a front with their rigs and its figure; return what could not be drawn."""
    from jounce.core.serialise import to_json
    from jounce.core.writing import write_files
    from jounce.parts.files import updated_text

    texts = {name: file.read_text(encoding="utf-8") for name, file in sources.items()}
    files: dict[str, bytes | str] = {
        "front.csv": front.table(),
        "results.json": to_json(front.to_dict()) + "\n",
    }
    for k in range(len(front.designs)):
        for name, rig in front.rigs(k).items():
            files[f"{name or 'rig'}-{k + 1:02d}.toml"] = updated_text(texts[name], rig)
    with drawing() as missing:
        from jounce.plots.figures import render_figure
        from jounce.plots.kinematic_design import front_lines

        files["front.png"] = render_figure(front_lines(front), [".png"])[".png"]
    write_files(out, files, force=force)
    return missing


def draw_kinematic_front(console: Console, plain: dict[str, Any], front: KinematicFront) -> None:
    """Print the designs of a front with their goals and the free parameters."""
    from jounce.core.display import display_unit
    from jounce.plots.kinematic_design import point_name

    unit = display_unit("m")
    paths = list(front.before.moved)
    heads = [
        f"{point_name(path)} by {unit.name}" if "hardpoints." in path else f"{path} by"
        for path in paths
    ]
    rows = []
    for label, design in [
        ("before", front.before),
        *((str(k + 1), design) for k, design in enumerate(front.designs)),
    ]:
        moved = (
            (design.moved[path] - front.before.moved[path])
            * (unit.factor if "hardpoints." in path else 1.0)
            for path in paths
        )
        rows.append(
            (
                label,
                *design.goals.values(),
                "met" if design.met else "",
                *(round(value, 3) for value in moved),
            )
        )
    columns = ("design", *front.goals, "", *heads)
    title = "Goals, root mean square in tolerances, and what was moved"
    console.print(table(title, columns, rows, text=(0, 1 + len(front.goals))))
    count = len(front.designs)
    console.print(f"{count} design{'' if count == 1 else 's'}, {front.evaluations} computed")
    show_findings(console, front.findings)
    show_written(console, plain)
