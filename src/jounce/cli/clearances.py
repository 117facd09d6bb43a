"""``jounce clearances``: distances of links, points and rim of a corner over travel and rack, and lengths of links."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from jounce.cli.kinematics import plain_sweep
from jounce.cli.options import (
    STROKE,
    AsJson,
    Changes,
    FigureFile,
    Force,
    RigName,
    changes,
    check_outputs,
    chosen_rig,
    write_picture,
)
from jounce.cli.reply import DONE, REFUSED, Reply, progress, show_findings, show_written, table, tell
from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding
from jounce.core.typed import quantity

if TYPE_CHECKING:
    import xarray as xr
    from rich.console import Console

    from jounce.kinematics import Rim, Solid

_BODY = "tie_rod_inner-tie_rod_outer 8 mm"
_RIM = re.compile(r"rim\s+(?P<radius>.+?)\s+from\s+(?P<inner>.+?)\s+to\s+(?P<outer>.+)")
_ALLOWED = f'NAME: BODY, BODY; a body is "{_BODY}" or "rim 115 mm from -90 mm to 20 mm"'


def clearances(
    rig: RigName,
    between: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME: BODY, BODY",
            help=f'Two bodies that may touch: "rod in rim: {_BODY}, rim 115 mm from -90 mm to 20 mm". A body is '
            "hardpoints, joined by hyphens where it is a bar, and its radius; or the inside of the rim, its offsets "
            "from the wheel centre, outboard positive. Repeat it.",
        ),
    ] = None,
    travel: Annotated[
        str | None, typer.Option(help='Wheel travel, bump positive: "-30 mm:30 mm:5 mm", or a single value.')
    ] = None,
    rack: Annotated[
        str | None, typer.Option(help='Rack travel, positive to the left: "-20 mm:20 mm:5 mm", or a single value.')
    ] = None,
    set_: Changes = None,
    out: Annotated[Path | None, typer.Option(help="Write every distance: CLEARANCES.csv or .nc, SI.")] = None,
    figure: FigureFile = None,
    force: Force = False,
    as_json: AsJson = False,
) -> Reply:
    """Give the least distances of bodies of a corner over travel and rack, and the lengths of its links.

    Example: jounce clearances formula-student-front --travel "-25 mm:25 mm:5 mm" --rack "-20 mm:20 mm:10 mm"
    --between "rod in rim: tie_rod_inner-tie_rod_outer 8 mm, rim 115 mm from -90 mm to 20 mm"
    """
    from jounce.kinematics import clearances as distances
    from jounce.kinematics import link_lengths
    from jounce.kinematics.sweeps import SWEEP_FILES, text_range

    if out is not None:
        SWEEP_FILES.check(out, force=force)
    check_outputs(figure=figure, force=force)
    if between is None:
        given = {"--out": out, "--figure": figure, "--travel": travel, "--rack": rack}
        for option, value in given.items():
            if value is not None:
                raise DescriptionError("no distances are asked for", where=option, allowed=f"--between {_ALLOWED}")
    with progress() as say:
        say("loading")
        chosen, found = chosen_rig(rig, changes(set_)), None
        lengths = link_lengths(chosen)
        if between is not None:
            say("sweeping")
            moved = [
                None if text is None else text_range(text, "m", o)
                for text, o in ((travel, "--travel"), (rack, "--rack"))
            ]
            found = distances(chosen, _pairs(between), 0.0 if moved[0] is None else moved[0], moved[1])
            found = _of_rack(found) if found.sizes["wheel_travel"] == 1 < found.sizes["rack_travel"] else found
        if out is not None and found is not None:
            SWEEP_FILES.write(found, out, force=force)
        drawn, missing = write_picture(lambda: _curves(found), figure, force=force)
    stopped = "" if found is None else str(found.attrs["stopped"])
    if stopped:
        tell(f"{stopped}. The poses before that are kept.")
    least = {} if found is None else {str(name): _least(found, str(name)) for name in found.data_vars}
    findings = [
        Finding(name, "warning", f"the bodies overlap by {-1e3 * one['clearance']:.4g} mm.", one["clearance"])
        for name, one in least.items()
        if one["clearance"] < 0.0
    ]
    plain: dict[str, Any] = {
        "lengths": lengths,
        "least": least,
        "quantities": {} if found is None else plain_sweep(found),
        "findings": findings,
        "out": None if out is None else str(out),
        "figure": drawn,
    }
    exit_code = REFUSED if stopped else DONE
    return Reply(plain, lambda console: _draw(console, rig, plain), as_json, exit_code, missing=missing)


def _pairs(texts: list[str]) -> dict[str, tuple[Solid | Rim, Solid | Rim]]:
    found = {}
    for text in texts:
        name, colon, rest = text.partition(":")
        name, bodies = name.strip(), rest.split(",")
        if not (colon and name) or len(bodies) != 2:
            raise DescriptionError("not two bodies", where="--between", found=text, allowed=_ALLOWED)
        if name in found:
            raise DescriptionError(f"{name!r} is given twice", where="--between", found=text)
        where = f"--between {name}"
        found[name] = (_body(bodies[0].strip(), where), _body(bodies[1].strip(), where))
    return found


def _body(text: str, where: str) -> Solid | Rim:
    from jounce.kinematics import Rim, Solid

    rim = _RIM.fullmatch(text)
    if rim is not None:
        return Rim.from_table(
            {name: quantity(value, "m", where, most=STROKE) for name, value in rim.groupdict().items()}, where=where
        )
    points, _, radius = text.partition(" ")
    names = [name.strip() for name in points.split("-")]
    if not all(names) or names == ["rim"]:
        raise DescriptionError("not a body", where=where, found=text, allowed=_ALLOWED)
    size = quantity(radius.strip(), "m", where, most=STROKE) if radius.strip() else 0.0
    return Solid.from_table({"points": names, "radius": size}, where=where)


def _of_rack(found: xr.Dataset) -> xr.Dataset:
    """Distances over the rack alone, where there is one travel."""
    return found.isel(wheel_travel=0)


def _least(found: xr.Dataset, name: str) -> dict[str, float]:
    """Least distance and where it is, m."""
    import numpy as np

    values = found[name]
    at = np.unravel_index(int(np.nanargmin(values.to_numpy())), values.shape)
    place = values[dict(zip(values.dims, at, strict=True))]
    return {
        "clearance": float(place),
        **{along: float(place[along]) for along in ("wheel_travel", "rack_travel")},
    }


def _curves(found: xr.Dataset | None) -> Any:
    from jounce.plots.kinematics import kinematic_curves

    assert found is not None
    return kinematic_curves(found, [str(name) for name in found.data_vars])


def _draw(console: Console, rig: str, plain: dict[str, Any]) -> None:
    if plain["least"]:
        rows = [
            (name, *(1e3 * one[key] for key in ("clearance", "wheel_travel", "rack_travel")))
            for name, one in plain["least"].items()
        ]
        header = ("between", "least clearance mm", "at travel mm", "at rack mm")
        console.print(table(f"Clearances of {rig}, negative where bodies overlap", header, rows))
    rows = [(name, 1e3 * length) for name, length in plain["lengths"].items()]
    console.print(table(f"Lengths of links of {rig} at design", ("between", "length mm"), rows))
    show_findings(console, plain["findings"])
    show_written(console, plain)
