"""``jounce steering-effort``: force on the rack and torque at the handwheel for loads of the road."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from jounce.cli.kinematics import draw_sweep, plain_sweep
from jounce.cli.options import (
    AsJson,
    Changes,
    FigureFile,
    Force,
    RigName,
    bare_numbers,
    changes,
    check_outputs,
    chosen_rig,
    write_picture,
)
from jounce.cli.reply import DONE, REFUSED, Reply, progress, tell
from jounce.core.errors import DescriptionError
from jounce.core.typed import pairs, quantity

if TYPE_CHECKING:
    from jounce.kinematics import ContactLoad

_LOAD = 'lateral_force="2 kN"'


def steering_effort(
    rig: RigName,
    load: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=VALUE",
            help=f"Load of the road on each wheel, ground axes: {_LOAD} (to the left), longitudinal_force (forward), "
            "vertical_force, aligning_torque (about +z), through=wheel_centre. Repeat it.",
        ),
    ] = None,
    left: Annotated[
        list[str] | None, typer.Option(metavar="NAME=VALUE", help="What differs on the left wheel, as --load.")
    ] = None,
    right: Annotated[
        list[str] | None, typer.Option(metavar="NAME=VALUE", help="What differs on the right wheel, as --load.")
    ] = None,
    rack: Annotated[
        str, typer.Option(help='Rack travel, positive to the left: "-20 mm:20 mm:5 mm", or a single value.')
    ] = "0 mm",
    travel: Annotated[str, typer.Option(help="Travel of both wheels, bump positive.")] = "0 mm",
    set_: Changes = None,
    out: Annotated[Path | None, typer.Option(help="Write the sweep: EFFORT.nc or EFFORT.csv, SI.")] = None,
    figure: FigureFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Give the force on the rack and the torque at the handwheel that loads of the road on both wheels ask for.

    Example: jounce steering-effort formula-student-front --rack "-20 mm:20 mm:5 mm" --load vertical_force="700 N"
    --left lateral_force="400 N" --right lateral_force="900 N" --set steering='{rack_ratio = "13 mm/rad"}'
    """
    from jounce.kinematics import steering_effort as effort
    from jounce.kinematics.sweeps import SWEEP_FILES, text_range

    if out is not None:
        SWEEP_FILES.check(out, force=force)
    check_outputs(figure=figure, force=force)
    with progress() as say:
        say("loading")
        chosen = chosen_rig(rig, changes(set_))
        both = pairs(load, "--load", _LOAD)
        one, other = (
            _load({**both, **pairs(texts, option, _LOAD)}, option)
            for texts, option in ((left, "--left"), (right, "--right"))
        )
        say("sweeping")
        found = effort(chosen, one, other, text_range(rack, "m", "--rack"), quantity(travel, "m", "--travel"))
        if out is not None:
            SWEEP_FILES.write(found, out, force=force)

        def picture() -> object:
            from jounce.plots.kinematics import kinematic_curves

            known = [str(name) for name in found.data_vars]
            names = ("rack_force", "pinion_torque", "handwheel_torque")
            return kinematic_curves(found, [name for name in names if name in known])

        drawn, missing = write_picture(picture, figure, f"Steering effort of {rig}", force=force)
    stopped = str(found.attrs["stopped"])
    if stopped:
        tell(f"{stopped}. The poses before that are kept.")
    written = [path for path in (None if out is None else str(out), drawn) if path is not None]
    exit_code = REFUSED if stopped else DONE
    return Reply(
        plain_sweep(found),
        lambda console: draw_sweep(console, f"Steering effort of {rig}", found, written),
        as_json,
        exit_code,
        missing,
    )


def _load(given: dict[str, str], option: str) -> ContactLoad:
    from jounce.kinematics import ContactLoad

    if not given:
        allowed = f"--load {_LOAD}, or --left and --right"
        raise DescriptionError("no load of the road", where=option, allowed=allowed)
    return ContactLoad.from_table(bare_numbers(ContactLoad, given, f"{option} {{}}".format), where=option)
