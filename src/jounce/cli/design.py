"""``jounce design``: springs for a frequency, best numbers within bounds, comfort against road holding."""

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
        Path, typer.Argument(metavar="STUDY.toml", help='Study file, schema = "jounce.design/1".', show_default=False)
    ],
    out: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Write front.csv, results.json, front.png and a rig for each design."),
    ] = None,
    points: Annotated[int, typer.Option(help="About how many designs.")] = 20,
    starts: Annotated[int, typer.Option(min=1, help="Number of searches for the best of each goal.")] = 4,
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

        found, sources = run_study(study, lambda asked, task: front_of(task, points, starts, asked.seed))
        missing: Sequence[Finding] = ()
        if out is not None:
            say("drawing")
            missing = _write_front(found, sources, out, force=force)
    plain = {**found.to_dict(), "out": out and str(out)}
    return Reply(plain, lambda console: draw_kinematic_front(console, plain, found), as_json, missing=missing)


def _write_front(found: KinematicFront, sources: Mapping[str, Path], out: Path, *, force: bool) -> Sequence[Finding]:
    """Write the designs of a front with their rigs, and its picture; give what could not be drawn."""
    from jounce.core.serialise import to_json
    from jounce.core.writing import write_files
    from jounce.parts.files import updated_text

    texts = {name: file.read_text(encoding="utf-8") for name, file in sources.items()}
    files: dict[str, bytes | str] = {"front.csv": found.table(), "results.json": to_json(found.to_dict()) + "\n"}
    for k in range(len(found.designs)):
        for name, rig in found.rigs(k).items():
            files[f"{name or 'rig'}-{k + 1:02d}.toml"] = updated_text(texts[name], rig)
    with drawing() as missing:
        from jounce.plots.figures import rendered
        from jounce.plots.kinematic_design import front_lines

        files["front.png"] = rendered(front_lines(found), [".png"])[".png"]
    write_files(out, files, force=force)
    return missing


def draw_kinematic_front(console: Console, plain: dict[str, Any], found: KinematicFront) -> None:
    """Print the designs of a front with their goals, and the numbers that move."""
    from jounce.core.display import display_unit
    from jounce.plots.kinematic_design import point_name

    unit = display_unit("m")
    paths = list(found.before.moved)
    heads = [f"{point_name(path)} by {unit.name}" if "hardpoints." in path else f"{path} by" for path in paths]
    rows = []
    for label, one in [("before", found.before), *((str(k + 1), one) for k, one in enumerate(found.designs))]:
        moved = (
            (one.moved[path] - found.before.moved[path]) * (unit.factor if "hardpoints." in path else 1.0)
            for path in paths
        )
        rows.append((label, *one.goals.values(), "met" if one.met else "", *(round(value, 3) for value in moved)))
    columns = ("design", *found.goals, "", *heads)
    title = "Goals, root mean square in tolerances, and what was moved"
    console.print(table(title, columns, rows, text=(0, 1 + len(found.goals))))
    count = len(found.designs)
    console.print(f"{count} design{'' if count == 1 else 's'}, {found.evaluations} computed")
    show_findings(console, found.findings)
    show_written(console, plain)
