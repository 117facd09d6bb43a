"""``jounce kinematics``: a corner or an axle swept over travel, rack or roll."""

from __future__ import annotations

import sys
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.options import AsJson, Changes, Force, RigName, changes, pairs
from jounce.cli.outputs import check_outputs
from jounce.cli.reply import DONE, REFUSED, Reply, progress
from jounce.cli.rigs import chosen_rig
from jounce.cli.tables import table
from jounce.core.errors import DescriptionError

if TYPE_CHECKING:
    import numpy as np
    import xarray as xr
    from numpy.typing import NDArray
    from rich.console import Console

    from jounce.kinematics.sweeps import AxleLayout
    from jounce.parts import Rig

_SHOWN = 7


def kinematics(
    rig: RigName,
    travel: Annotated[
        str | None, typer.Option(help='Wheel travel, bump positive: "-80 mm:80 mm:4 mm", or one value.')
    ] = None,
    rack: Annotated[
        str | None, typer.Option(help='Rack travel, positive to the left: "-20 mm:20 mm:5 mm", or one value.')
    ] = None,
    roll: Annotated[
        str | None, typer.Option(help='Instead of travel: roll of the body over an axle, "-4 deg:4 deg:1 deg".')
    ] = None,
    axle: Annotated[
        bool, typer.Option("--axle", help="With --rack alone: both wheels of an axle, and Ackermann.")
    ] = False,
    vehicle: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=VALUE",
            help='For anti-dive and the like: axle=front, wheelbase="2.7 m", centre_of_mass_height="550 mm", '
            "brake_share=0.6. Repeat it.",
        ),
    ] = None,
    points: Annotated[
        bool, typer.Option("--points", help="With --travel or --rack: add the places of all hardpoints.")
    ] = False,
    set_: Changes = None,
    out: Annotated[Path | None, typer.Option(help="Write the sweep: SWEEP.nc or SWEEP.csv.")] = None,
    plot: Annotated[Path | None, typer.Option(metavar="DIR", help="Draw every quantity into this folder.")] = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Sweep a suspension and list its kinematic quantities: camber, toe, roll centre, wheel rate and all others.

    Example: jounce kinematics reference-double-wishbone --travel "-80 mm:80 mm:4 mm" --out sweep.nc
    """
    from jounce.kinematics.sweeps import SWEEP_FILES

    if out is not None:
        SWEEP_FILES.check(out, force=force)
    check_outputs(folder=plot, force=force)
    with progress() as say:
        say("loading")
        chosen = chosen_rig(rig, changes(set_))
        say("sweeping")
        sweep = _sweep(chosen, travel, rack, roll, _vehicle(vehicle), axle=axle, points=points)
        if out is not None:
            SWEEP_FILES.write(sweep, out, force=force)
        if plot is not None:
            say("drawing")
            from jounce.plots.kinematics import write_kinematics

            write_kinematics(sweep, plot, force=force)
    stopped = str(sweep.attrs["stopped"])
    if stopped:
        sys.stderr.write(f"jounce: {stopped}. The poses before it are kept.\n")
    written = [str(path) for path in (out, plot) if path is not None]
    exit_code = REFUSED if stopped else DONE
    return Reply(plain_sweep(sweep), lambda console: _draw(console, rig, sweep, written), as_json, exit_code)


def _sweep(
    rig: Rig,
    travel: str | None,
    rack: str | None,
    roll: str | None,
    vehicle: AxleLayout | None,
    *,
    axle: bool,
    points: bool,
) -> xr.Dataset:
    from jounce.kinematics import sweep_rack, sweep_travel

    steered = None if rack is None else swept_range(rack, "m", "--rack")
    if roll is not None or axle:
        if points:
            raise DescriptionError("no hardpoints of an axle", where="--points", hint="Leave it out.")
        return _sweep_axle(rig, travel, steered, roll, vehicle)
    if travel is None:
        if steered is None:
            example = '--travel "-80 mm:80 mm:4 mm", --rack or --roll'
            raise DescriptionError("nothing is swept", where="jounce kinematics", allowed=example)
        return sweep_rack(rig, steered, vehicle=vehicle, points=points)
    lifted = swept_range(travel, "m", "--travel")
    if steered is not None and len(steered) > 1 and len(lifted) == 1:
        return sweep_rack(rig, steered, float(lifted[0]), vehicle=vehicle, points=points)
    pair = steered if steered is None or len(steered) > 1 else float(steered[0])
    return sweep_travel(rig, lifted, pair, vehicle=vehicle, points=points)


def _sweep_axle(
    rig: Rig, travel: str | None, rack: NDArray[np.float64] | None, roll: str | None, vehicle: AxleLayout | None
) -> xr.Dataset:
    from jounce.kinematics import sweep_roll, sweep_steering

    if roll is None:
        if rack is None:
            raise DescriptionError("nothing is swept", where="--axle", allowed='--rack "-20 mm:20 mm:5 mm", or --roll')
        lifted = 0.0 if travel is None else _one_value(swept_range(travel, "m", "--travel"), "--travel", "with --axle")
        return sweep_steering(rig, rack, lifted, vehicle=vehicle)
    if travel is not None:
        raise DescriptionError("roll makes its own travel", where="--travel", hint="Leave out --travel or --roll.")
    if vehicle is not None:
        raise DescriptionError("no percentages in roll", where="--vehicle", hint="Leave it out, or sweep --travel.")
    at = 0.0 if rack is None else _one_value(rack, "--rack", "with --roll")
    return sweep_roll(rig, swept_range(roll, "rad", "--roll"), at)


def swept_range(text: str, unit: str, option: str) -> NDArray[np.float64]:
    """Read ``"first:last:step"`` or one value into SI."""
    from jounce.kinematics.sweeps import text_range

    return text_range(text, unit, option)


def _one_value(values: NDArray[np.float64], option: str, why: str) -> float:
    if len(values) > 1:
        raise DescriptionError(f"only one value can be used {why}", where=option, found=f"{len(values)} values")
    return float(values[0])


def _vehicle(texts: list[str] | None) -> AxleLayout | None:
    if not texts:
        return None
    from jounce.cli.options import bare_number
    from jounce.kinematics.sweeps import AxleLayout

    given = pairs(texts, "--vehicle", 'wheelbase="2.7 m"')
    return AxleLayout.from_table({name: bare_number(value) for name, value in given.items()}, where="--vehicle")


def plain_sweep(sweep: xr.Dataset) -> dict[str, Any]:
    """Every quantity with its unit and values in SI; None where there is no finite value."""
    import numpy as np

    names = [*map(str, sweep.coords), *map(str, sweep.data_vars)]
    shape = tuple(sweep.sizes.values())
    found = {}
    for name in names:
        variable = sweep[name]
        values = variable.to_numpy()
        if name in sweep.coords and name not in sweep.dims:
            values = np.full(shape, float(values))
        found[name] = {"units": str(variable.attrs.get("units", "1")), "values": values.tolist()}
    return found


def _finite(value: float) -> float | None:
    return float(value) if isfinite(value) else None


def _draw(out: Console, rig: str, sweep: xr.Dataset, written: list[str]) -> None:
    import numpy as np

    from jounce.plots.display import display_unit

    along, *others = map(str, sweep.dims)
    shown = sweep.sel(dict.fromkeys(others, 0.0), method="nearest") if others else sweep
    count = shown.sizes[along]
    at = np.unique(np.linspace(0, count - 1, min(count, _SHOWN)).round().astype(int))
    unit = display_unit(str(sweep[along].attrs["units"]))
    rows = []
    for name, variable in shown.data_vars.items():
        values = variable.to_numpy()
        own = display_unit(str(variable.attrs["units"]), float(np.nanmax(np.abs(values), initial=0.0)))
        rows.append([str(name), own.name or "1", *(_finite(value * own.factor) for value in values[at])])
    header = ("quantity", "unit", *(f"{value * unit.factor:.4g} {unit.name}" for value in shown[along].to_numpy()[at]))
    out.print(table(f"Kinematics of {rig} over {along.replace('_', ' ')}", header, rows, text=(0, 1)))
    many = "".join(f" at each of {sweep.sizes[name]} values of {name.replace('_', ' ')}" for name in others)
    out.print(f"{count} poses{many}{', shown for the one nearest to 0' if others else ''}")
    for path in written:
        out.print(f"written: {path}")
