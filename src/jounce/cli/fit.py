"""``jounce fit``: stiffness, decays and damper laws from measured files."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.derived import add_commands
from jounce.cli.options import AsJson, FigureFile, Force, check_outputs, write_picture
from jounce.cli.reply import Reply, progress, show_written
from jounce.core.errors import unknown
from jounce.core.typed import pairs

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from rich.console import Console

    from jounce.core.findings import Finding
    from jounce.report import Page


app = typer.Typer(no_args_is_help=True, help="Find stiffness, damping and damper laws from measurements.")
add_commands(app, "fit")


def _reply(plain: dict[str, Any], page: Callable[[], Page], *, as_json: bool, missing: Sequence[Finding]) -> Reply:
    """Answer with the page of the result."""

    def draw(out: Console) -> None:
        from jounce.cli.terminal import show_page

        show_page(out, page())
        show_written(out, plain)

    return Reply(plain, draw, as_json, missing=missing)


@app.command("hardpoints")
def hardpoints(
    rig: Annotated[str, typer.Argument(metavar="RIG", help="A corner with hardpoints: name or file.")],
    measured: Annotated[
        Path,
        typer.Argument(
            metavar="POSES.csv", help="Columns wheel_travel [mm], rack_travel [mm], toe [deg], camber [deg] ..."
        ),
    ],
    free: Annotated[
        list[str],
        typer.Option("--free", metavar="POINT=WITHIN", help='hardpoints.tie_rod_inner="15 mm". Repeat it.'),
    ],
    noise: Annotated[
        list[str] | None,
        typer.Option("--noise", metavar="QUANTITY=SIZE", help='Standard deviation: toe="0.02 deg". Repeat it.'),
    ] = None,
    offset: Annotated[
        list[str] | None,
        typer.Option("--offset", metavar="QUANTITY", help="A quantity whose zero is not known. Repeat it."),
    ] = None,
    starts: Annotated[int, typer.Option(min=1, help="Number of searches; the first starts from the rig.")] = 3,
    out: Annotated[Path | None, typer.Option(help="Write the rig with its points updated, RIG.toml.")] = None,
    figure: FigureFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Update hardpoints until the model gives a table of measured poses, with 95 % intervals.

    Example: jounce fit hardpoints formula-student-front poses.csv --free hardpoints.tie_rod_inner="10 mm" --offset toe
    """
    check_outputs(rig=out, figure=figure, force=force)
    widths = pairs(free, "--free", 'hardpoints.tie_rod_inner="15 mm"')
    sizes = pairs(noise, "--noise", 'toe="0.02 deg"')
    with progress() as say:
        say("loading")
        from jounce.core.columns import read_columns_csv
        from jounce.core.writing import write_atomically
        from jounce.design.measured_poses import fit_hardpoints
        from jounce.kinematics.catalogue import require_parts
        from jounce.kinematics.model import check_corner, kinematic_model
        from jounce.parts import load, rig_path
        from jounce.parts.files import updated_text

        chosen = check_corner(load(rig))
        units = {row.name: row.unit for row in kinematic_model(chosen).rows} | {"wheel_travel": "m", "rack_travel": "m"}
        columns_found = read_columns_csv(measured)
        for name in columns_found.names:
            if name not in units:
                require_parts(chosen, name)
                raise unknown(name, units, what="quantity", where=str(measured))
        poses = {name: columns_found[name].in_si(units[name]) for name in columns_found.names}
        say("searching")
        found = fit_hardpoints(chosen, poses, widths, noise=sizes, offsets=offset or (), starts=starts)
        if out is not None:
            write_atomically(out, updated_text(rig_path(rig).read_text(encoding="utf-8"), found.rig), force=force)
    drawn, missing = write_picture(found, figure, f"{rig} against {measured.name}", force=force)
    plain = {"rig": rig, **found.to_dict(), "out": out and str(out), "figure": drawn}

    def page() -> Page:
        from jounce.report import hardpoints_page

        return hardpoints_page(found, title=f"{rig} against {measured.name}")

    return _reply(plain, page, as_json=as_json, missing=missing)
