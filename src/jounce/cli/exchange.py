"""``jounce export``: rigs for other programs."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal, cast

import typer

from jounce.cli.options import LENGTH, AsJson, Changes, Force, RigName, changes, chosen_rig, optional_positive
from jounce.cli.reply import Reply, progress, show_findings, show_written
from jounce.core.errors import DescriptionError, unknown

if TYPE_CHECKING:
    from rich.console import Console

    from jounce.exchange.fmu import FmuExport

export_app = typer.Typer(no_args_is_help=True, help="Write rigs for other programs.")


@export_app.callback()
def _export() -> None:
    """Keep the name of the format part of the command even where there is only one."""


@export_app.command("fmu")
def fmu(
    rig: RigName,
    out: Annotated[Path, typer.Option(metavar="CAR.fmu", help="File to write.")],
    fmi: Annotated[int, typer.Option(help="Version of FMI: 2 or 3.")] = 3,
    platform: Annotated[
        list[str] | None,
        typer.Option(
            metavar="PLATFORM",
            help="Compile for x86_64-linux, aarch64-linux, x86_64-windows, x86_64-darwin or aarch64-darwin; repeat it. "
            "Default: this machine. Others need the extra fmu.",
        ),
    ] = None,
    sources_only: Annotated[bool, typer.Option("--sources-only", help="Compile nothing: the FMU holds its C.")] = False,
    control: Annotated[
        str | None, typer.Option(help="Controller to put in: a name such as skyhook, or a file.")
    ] = None,
    tester: Annotated[
        str | None, typer.Option(help="Put it on a tester of shock absorbers: a name such as eusama, or a file.")
    ] = None,
    axle: Annotated[
        str | None, typer.Option(help="Axle of a vehicle on the tester: front or rear. Default: front.")
    ] = None,
    controller_only: Annotated[
        bool, typer.Option("--controller-only", help="Write the controller by itself, as it is tuned for the rig.")
    ] = False,
    set_: Changes = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Write a rig or vehicle as a Functional Mock-up Unit: model exchange and co-simulation in one file.

    Example: jounce export fmu kart-quarter-car --out kart.fmu
    """
    if sources_only and platform:
        what = "--platform says for what is compiled, and --sources-only that nothing is"
        raise DescriptionError(what, found=platform, hint="Leave one of them out.")
    axles = ("front", "rear")
    if axle is not None and axle not in axles:
        raise unknown(axle, axles, what="axle", where="--axle")
    if axle is not None and tester is None:
        raise DescriptionError(
            "only a tester takes one axle", where="--axle", found=axle, allowed="--axle with --tester"
        )
    with progress() as say:
        say("loading")
        from jounce.exchange.fmu import export_fmu

        chosen = chosen_rig(rig, changes(set_))
        say("writing the FMU")
        version = cast("Literal[2, 3]", fmi)
        platforms = () if sources_only else platform or None
        on = {"tester": tester, "axle": axle or "front", "controller_only": controller_only}
        made = export_fmu(chosen, out, version=version, platforms=platforms, control=control, force=force, **on)  # type: ignore[arg-type]
    plain = {"rig": rig, "control": control, "tester": tester, **made.to_dict(), "out": str(out)}
    return Reply(plain, lambda console: _draw(console, made, plain), as_json)


@export_app.command("equations")
def equations_(
    rig: RigName,
    out: Annotated[Path, typer.Option(metavar="FILE", help="File to write: .tex, .py (SymPy), .c or .casadi.")],
    set_: Changes = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Write the equations of motion of a rig: mass matrix, forces and constraints.

    Example: jounce export equations kart-quarter-car --out kart.tex
    """
    from jounce.exchange.equations import EQUATION_FORMATS, equations

    EQUATION_FORMATS.check(out, force=force)
    with progress() as say:
        say("loading")
        found = equations(chosen_rig(rig, changes(set_)))
        say("writing the equations")
        EQUATION_FORMATS.write(found, out, force=force)
    plain = {"rig": rig, **found.to_dict(), "out": str(out)}

    def draw(console: Console) -> None:
        console.print("M a = Q + G^T lambda, G a + gamma = 0, dq/dt = dq; SI")
        for word in ("coordinates", "speeds", "inputs", "modes", "constraints"):
            console.print(f"{word}: {', '.join(plain[word]) or 'none'}")
        show_written(console, plain)

    return Reply(plain, draw, as_json)


@export_app.command("hardpoints")
def hardpoints(
    rig: RigName,
    out: Annotated[Path, typer.Option(metavar="FILE", help="File to write: .csv or .dxf, in mm.")],
    set_: Changes = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Write the hardpoints of a 3-D rig as a table, or as a drawing for CAD.

    Example: jounce export hardpoints kart-double-wishbone --out points.csv
    """
    from jounce.exchange.points import POINT_FORMATS, write_hardpoints

    POINT_FORMATS.check(out, force=force)
    chosen = chosen_rig(rig, changes(set_))
    write_hardpoints(chosen, out, force=force)
    points = {name: list(point) for name, point in chosen.hardpoints.given().items()}  # type: ignore[attr-defined]
    plain = {"rig": rig, "hardpoints": points, "out": str(out)}

    def draw(console: Console) -> None:
        console.print(f"{len(points)} hardpoints in mm: x forward, y left, z up from the road")
        show_written(console, plain)

    return Reply(plain, draw, as_json)


@export_app.command("chrono")
def chrono(
    rig: RigName,
    out: Annotated[Path, typer.Option(metavar="FILE.json", help="Suspension file of Project Chrono to write.")],
    wheel_mass: Annotated[
        str | None,
        typer.Option(help="Rim and tyre, which are in other files there: taken out of the wheel. Default: nothing."),
    ] = None,
    set_: Changes = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Write a 3-D rig as a suspension of Project Chrono: double wishbone, McPherson strut, multi-link.

    Example: jounce export chrono sedan-double-wishbone --out suspension.json
    """
    from jounce.exchange.chrono import write_chrono

    mass = optional_positive(wheel_mass, "kg", "--wheel-mass") or 0.0
    made = write_chrono(chosen_rig(rig, changes(set_)), out, wheel_mass=mass, force=force)
    plain = {"rig": rig, **made.to_dict(), "out": str(out)}

    def draw(console: Console) -> None:
        console.print(f"{made.template} of Project Chrono, left side; heights count from the wheel centre")
        show_findings(console, list(made.findings))
        show_written(console, plain)

    return Reply(plain, draw, as_json)


@export_app.command("mjcf")
def mjcf(
    rig: RigName,
    out: Annotated[Path, typer.Option(metavar="FILE.xml", help="Model of MuJoCo to write.")],
    set_: Changes = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Write a 3-D rig on its road as a model of MuJoCo (MJCF): loops by equality constraints.

    Example: jounce export mjcf kart-double-wishbone --out kart.xml
    """
    from jounce.exchange.mjcf import write_mjcf

    made = write_mjcf(chosen_rig(rig, changes(set_)), out, force=force)
    plain = {"rig": rig, **made.to_dict(), "out": str(out)}

    def draw(console: Console) -> None:
        console.print(f"{made.bodies} bodies, {made.joints} joints, {made.loops} loops; SI, all frames as at design")
        show_findings(console, list(made.findings))
        show_written(console, plain)

    return Reply(plain, draw, as_json)


@export_app.command("road")
def road_(
    road: Annotated[str, typer.Argument(metavar="ROAD", help="A road file, a shipped road, or iso:A to iso:H.")],
    out: Annotated[Path, typer.Option(metavar="FILE", help="File to write: .crg or .csv.")],
    length: Annotated[str | None, typer.Option(help="Length of the course. Default: to the road's end.")] = None,
    step: Annotated[str | None, typer.Option(help="Between points. Default: 10 mm.")] = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Write any road as OpenCRG, or as a table of distance and height.

    Example: jounce export road iso:C --length "100 m" --out class-c.crg
    """
    from jounce.exchange.roads import ROAD_FORMATS, STEP, write_road
    from jounce.roads import load_road

    ROAD_FORMATS.check(out, force=force)
    wanted = optional_positive(length, "m", "--length")
    spacing = optional_positive(step, "m", "--step", most=LENGTH)
    chosen = load_road(road) if wanted is None else load_road(road, length=wanted)
    made = write_road(chosen, out, length=wanted, step=STEP if spacing is None else spacing, force=force)
    plain = {"road": road, **made.to_dict(), "out": str(out)}

    def draw(console: Console) -> None:
        console.print(f"{made.points} points over {made.length:g} m")
        show_findings(console, list(made.findings))
        show_written(console, plain)

    return Reply(plain, draw, as_json)


def _draw(console: Console, made: FmuExport, plain: dict[str, object]) -> None:
    binaries = f"for {', '.join(made.platforms)}" if made.platforms else "as sources only"
    console.print(f"FMI {made.version}.0, model exchange and co-simulation, {binaries}")
    console.print(f"inputs: {', '.join(made.inputs) or 'none'}")
    console.print(f"outputs: {len(made.outputs)}, states: {made.states}, parameters: {made.parameters}")
    show_findings(console, list(made.findings))
    show_written(console, plain)
