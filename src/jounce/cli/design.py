"""``jounce design``: springs for a frequency, best numbers within bounds, comfort against road holding."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.derived import add_commands
from jounce.cli.options import (
    AsJson,
    FigureFile,
    Force,
    ReportFile,
    check_outputs,
    write_picture,
    write_report,
)
from jounce.cli.reply import DONE, FAILED, Reply, drawing, progress, show_findings, show_written, table

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.design.hardpoint_front import KinematicFront
    from jounce.design.kinematics import KinematicDesign, TargetResult
    from jounce.report import Page


app = typer.Typer(no_args_is_help=True, help="Springs, dampers, hardpoints and best designs.")
add_commands(app, "design")


@app.command("kinematics")
def kinematics(
    study: Annotated[
        Path, typer.Argument(metavar="STUDY.toml", help='Study file, schema = "jounce.design/1".', show_default=False)
    ],
    out: Annotated[
        Path | None,
        typer.Option(metavar="DIR", help="Write report, rig.toml, results.json, tables and pictures into this folder."),
    ] = None,
    starts: Annotated[int | None, typer.Option(min=1, help="Number of searches; the study's own by default.")] = None,
    figure: FigureFile = None,
    report: ReportFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Find the hardpoints that give wanted kinematic values and curves. Exit code 1 where targets are missed.

    Example: jounce design kinematics study.toml --out designed
    """
    check_outputs(folder=out, figure=figure, report=report, force=force)
    with progress() as say:
        say("searching")
        from jounce.design.kinematics import design, run_study

        found, sources = run_study(study, lambda asked, task: design(task, starts or asked.starts, asked.seed))
        missing: Sequence[Finding] = ()
        if out is not None:
            say("drawing")
            missing = _write_kinematics(found, sources, study.stem, out, force=force)
        title = _title(sources, study.stem)
        drawn, undrawn = write_picture(found, figure, title, force=force)
        page, without = write_report(lambda: _kinematic_page(found, title), report, force=force)
    plain = {**found.to_dict(), "out": out and str(out), "figure": drawn, "report": page}
    missing = [*missing, *undrawn, *without]
    code = DONE if found.met else FAILED
    return Reply(plain, lambda console: draw_kinematics(console, plain, found), as_json, code, missing)


def _title(sources: Mapping[str, Path], name: str) -> str:
    one = next(iter(sources.values())).stem
    return f"Kinematics of {one if len(sources) == 1 else name}"


def _kinematic_page(found: KinematicDesign, title: str, pictures: Mapping[str, Figure] | None = None) -> Page:
    from jounce.report import kinematic_design_page

    return kinematic_design_page(found, title=title, pictures=pictures)


def _write_kinematics(
    found: KinematicDesign, sources: Mapping[str, Path], name: str, out: Path, *, force: bool
) -> Sequence[Finding]:
    """Write what was found, and then its page; give what could not be drawn."""
    from jounce.core.serialise import to_json
    from jounce.parts.files import updated_text
    from jounce.plots.figures import rendered
    from jounce.plots.kinematic_design import design_pictures
    from jounce.report import write_page

    computed: dict[str, bytes | str] = {
        f"{name or 'rig'}.toml": updated_text(sources[name].read_text(encoding="utf-8"), rig)
        for name, rig in found.rigs.items()
    }
    computed |= {
        "results.json": to_json(found.results()) + "\n",
        "targets.csv": found.curve_table(),
        "sensitivity.csv": found.sensitivity_table(),
        "tradeoffs.csv": found.tradeoff_table(),
        "identified.csv": found.identified_table(),
    }
    computed |= {f"spread-{name}.csv" if name else "spread.csv": one.table() for name, one in found.spread.items()}

    def page() -> Page:
        pictures = {label: draw() for label, draw in design_pictures(found).items()}
        whole = _kinematic_page(found, _title(sources, name), pictures)
        drawn = {f"{label}.png": rendered(picture, [".png"])[".png"] for label, picture in pictures.items()}
        return replace(whole, files=tuple(drawn.items()))

    with drawing() as missing:
        write_page(page, out, files=computed, force=force)
    return missing


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
    """Find hardpoints between goals that compete: designs of which none is better in every goal than another.

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


def draw_kinematics(console: Console, plain: dict[str, Any], found: KinematicDesign) -> None:
    """Print targets before and after, what was moved, what fights."""
    from jounce.core.display import display_unit

    rows = []
    for target in found.targets:
        unit = display_unit(target.unit)
        worst = [target.worst(value) for value in (target.before, target.after)]
        ends = [_shown(value, target) * unit.factor for value in (target.before, target.after)]
        poses = " → ".join(dict.fromkeys(target.pose(k) for k, _ in worst))
        name = f"{target.rig} {target.quantity}".strip()
        if isinstance(target.after, list):
            name += ", farthest from its curve" if target.has_curve else ", worst of its curve"
        met = "met" if target.met else "missed"
        met += ", must hold" if target.must else ""
        wanted = _wanted_text(target, unit.factor)
        rows.append((name, poses, unit.name or "1", *ends, wanted, target.tolerance * unit.factor, met))
    header = ("target", "at", "unit", "before", "after", "wanted", "tolerance", "")
    console.print(table("Targets", header, rows, text=(0, 1, 2, 5, 7)))
    moved = []
    for path, change in found.moved.items():
        unit = display_unit("m" if "hardpoints." in path else "1")
        numbers = (change.before, change.after, change.after - change.before)
        moved.append((path, unit.name or "SI", *(round(value * unit.factor, 6) for value in numbers)))
    console.print(table("Moved", ("number", "unit", "before", "after", "by"), moved, text=(0, 1)))
    for fight in found.fighting():
        missed, other = (f"{found.targets[i].label} (target {i})" for i in (fight.missed, fight.other))
        console.print(f"{missed} fights {other}: what brings one nearer takes the other away ({fight.cosine:.2f})")
    for name, spread in found.spread.items():
        of = f" of {name}" if name else ""
        better = f", {100.0 * spread.met_adjusted:.0f} % adjusted" if spread.adjustments else ""
        console.print(f"{spread.cars} cars{of}: {100.0 * spread.met:.0f} % meet all targets as built{better}")
        unit = display_unit("m")
        for setting, need in spread.adjustments.items():
            reach = f"{need.low * unit.factor:.3g} to {need.high * unit.factor:.3g} {unit.name}"
            console.print(f"{setting}: 95 % of the cars need {reach}")
        show_findings(console, spread.findings)
    good = sum(start.met for start in found.starts)
    console.print(f"{good} of {len(found.starts)} starts met all targets; {found.evaluations} designs computed")
    show_findings(console, found.findings)
    show_written(console, plain)


def _shown(value: float | list[float], target: TargetResult) -> float:
    """A value, or of a curve the one farthest from what is wanted; how far it is where each pose wants its own."""
    k, off = target.worst(value)
    return off if target.has_curve else value if isinstance(value, float) else value[k]


def _wanted_text(target: TargetResult, factor: float) -> str:
    if target.limits:
        low, high = (None if end is None else f"{end * factor:.5g}" for end in target.wanted)
        return f"at most {high}" if low is None else f"at least {low}" if high is None else f"{low} … {high}"
    return "0 from it" if target.has_curve else f"{target.wanted * factor:.5g}"
