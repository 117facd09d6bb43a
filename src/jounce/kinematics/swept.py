"""Sweeps for commands and pages: choice of the kind of sweep, and values as plain data."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np

from jounce.core.columns import read_columns_csv
from jounce.core.errors import DescriptionError
from jounce.core.operation import Described, File, Mark, Switch, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain
from jounce.kinematics.axle import sweep_steering
from jounce.kinematics.both_wheels import sweep_axle
from jounce.kinematics.options import RACK, TRAVEL
from jounce.kinematics.sweeps import (
    AxleLayout,
    Values,
    sweep_path,
    sweep_rack,
    sweep_values,
)
from jounce.kinematics.travel_and_roll import sweep_roll, sweep_travel
from jounce.parts import Rig, as_rig
from jounce.parts.options import AnyRig

if TYPE_CHECKING:
    import xarray as xr

OF_WHEEL = {"travel": "m", "rack": "m"}
OF_AXLE = {
    "left_travel": "m", "right_travel": "m", "heave": "m", "roll": "rad", "pitch": "rad", "rack": "m",
    "handwheel": "rad",
}  # fmt: skip
"""Columns of a table of poses, with their units."""


@dataclass(frozen=True)
class Swept(Plain):
    """A sweep of a rig.

    Attributes
    ----------
    rig : Rig
        The swept rig.
    data : xarray.Dataset
        Every quantity, SI.
    """

    rig: Rig
    data: xr.Dataset

    @property
    def stopped(self) -> str:
        """Reason for the early end of the sweep; empty if it is complete."""
        why = str(self.data.attrs["stopped"])
        return f"{why}. The poses before that are kept" if why else ""

    @property
    def remark(self) -> str:
        """Further findings."""
        return str(self.data.attrs.get("findings", ""))

    def to_dict(self) -> dict[str, Any]:
        """Return every quantity with its unit and its values, SI; None where there is no finite value."""
        return plain_sweep(self.data)


def plain_sweep(sweep: xr.Dataset) -> dict[str, Any]:
    """Return every quantity with its unit and values in SI; None where there is no finite value."""
    shape = tuple(sweep.sizes.values())
    quantities = {}
    for name in map(str, (*sweep.coords, *sweep.data_vars)):
        variable = sweep[name]
        values = variable.to_numpy()
        if name in sweep.coords and name not in sweep.dims:
            values = np.broadcast_to(values, shape)
        quantities[name] = {
            "units": str(variable.attrs.get("units", "1")),
            "values": values.tolist(),
        }
    return quantities


@operation(
    "kinematics",
    named={"changes": "set"},
    offers=("sweep", "figures", "report"),
    names_files=False,
    figure="jounce.plots.kinematics:write_swept",
    page="jounce.report.swept:swept_page",
    title="Kinematics of {rig}",
    doing="sweeping",
    example='jounce kinematics reference-double-wishbone --travel "-80 mm:80 mm:4 mm" --out sweep.nc',
)
def sweep_kinematics(  # noqa: PLR0913 - each is a coordinate of its own
    rig: AnyRig,
    travel: Annotated[Values | None, TRAVEL] = None,
    rack: Annotated[Values | None, RACK] = None,
    roll: Annotated[
        Values | None,
        Mark('Instead of --travel: body roll over an axle, "-4 deg:4 deg:1 deg".', "RANGE"),
    ] = None,
    *,
    axle: Annotated[
        bool, Switch("With --rack only: both wheels of an axle, and Ackermann percentage.")
    ] = False,
    right: Annotated[
        Rig | str | Path | None,
        File(
            "The right corner of an axle that is no mirror image of the left one.",
            "RIG",
            shipped=("parts",),
        ),
    ] = None,
    left_travel: Annotated[
        Values | None,
        Mark(
            "Travel of the left wheel of an axle, pose by pose; --right-travel likewise.", "RANGE"
        ),
    ] = None,
    right_travel: Annotated[
        Values | None, Mark("Travel of the right wheel, pose by pose.", "RANGE")
    ] = None,
    heave: Annotated[
        Values | None,
        Mark(
            "Rise of the body above the road, pose by pose, together with --roll and --pitch.",
            "RANGE",
        ),
    ] = None,
    pitch: Annotated[
        Values | None, Mark("Pitch of the body, nose down positive, pose by pose.", "RANGE")
    ] = None,
    handwheel: Annotated[
        Values | None,
        Mark(
            'Angle of the handwheel, to the left positive, in place of --rack: "-90 deg:90 deg:15 deg".',
            "RANGE",
        ),
    ] = None,
    poses: Annotated[
        Path | str | None,
        File(
            "Poses one by one, as a table or a log has them: columns travel and rack, or for an axle any of "
            "left_travel, right_travel, heave, roll, pitch, rack, handwheel, each with its unit in the header.",
            "FILE.csv",
        ),
    ] = None,
    vehicle: Annotated[
        AxleLayout | None,
        Described(
            'Layout for anti-dive, anti-lift and anti-squat: axle=front, wheelbase="2.7 m", '
            'centre_of_mass_height="550 mm", brake_share=0.6. Repeat it.',
            "NAME=VALUE",
            'wheelbase="2.7 m"',
            "jounce.kinematics.sweeps:AxleLayout",
        ),
    ] = None,
    points: Annotated[
        bool, Switch("With --travel or --rack: include the positions of all hardpoints.")
    ] = False,
) -> Swept:
    """Sweep a suspension and list its kinematic quantities: camber, toe, roll centre, wheel rate and more.

    The arguments determine the kind of sweep: :func:`jounce.sweep_travel`, ``sweep_rack``, ``sweep_roll``,
    ``sweep_steering``, ``sweep_axle`` or ``sweep_path``. Values are numbers in SI, or text such as
    ``"-80 mm:80 mm:4 mm"``.

    Parameters
    ----------
    rig : Rig, str or Path
        Rig, its file or its name in the library.
    travel, rack : values, optional
        Wheel travel (bump positive) and rack travel (positive to the left), m.
    roll : values, optional
        Body roll over an axle, rad.
    axle : bool
        Whether both wheels of an axle are steered by the rack.
    right : Rig, str or Path, optional
        The right corner, if it is not the mirror image of the left one.
    left_travel, right_travel, heave : values, optional
        Travel of both wheels, and rise of the body above the road, pose by pose, m.
    pitch : values, optional
        Pitch of the body, nose down positive, pose by pose, rad.
    handwheel : values, optional
        Angle of the handwheel, positive to the left, rad.
    poses : path, optional
        Table of individual poses.
    vehicle : AxleLayout, optional
        Layout for anti-dive, anti-lift and anti-squat.
    points : bool
        Whether positions of all hardpoints are included.

    Returns
    -------
    Swept
        SI.

    Raises
    ------
    DescriptionError
        If there is nothing to sweep, or for incompatible arguments.

    Examples
    --------
    >>> found = sweep_kinematics("reference-double-wishbone", "-40 mm:40 mm:20 mm")
    >>> found.data.sizes["wheel_travel"], found.stopped
    (5, '')
    """
    rig = as_rig(rig)
    other = None if right is None else as_rig(right)
    of_axle = {
        "left_travel": left_travel,
        "right_travel": right_travel,
        "heave": heave,
        "pitch": pitch,
    }
    of_axle |= {"handwheel": handwheel}
    given = {name: values for name, values in of_axle.items() if values is not None}
    if poses is not None:
        beside = {"axle": axle, **dict.fromkeys(given, True)}
        beside |= {"travel": travel is not None, "rack": rack is not None, "roll": roll is not None}
        _refuse_beside(beside)
        return Swept(rig, _sweep_poses(rig, other, Path(poses), vehicle, points=points))
    if other is not None or given:
        _refuse_beside({"travel": travel is not None, "axle": axle, "points": points})
        more = {
            name: values for name, values in (("roll", roll), ("rack", rack)) if values is not None
        }
        read = {name: sweep_values(values, name, OF_AXLE[name]) if isinstance(values, str) else values
                for name, values in (given | more).items()}  # fmt: skip
        return Swept(rig, sweep_axle(rig, right=other, vehicle=vehicle, **read))
    if roll is not None or axle:
        if points:
            raise DescriptionError(
                "hardpoints are not available for a sweep of an axle",
                where="points",
                hint="Leave it out.",
            )
        return Swept(rig, _sweep_axle(rig, travel, rack, roll, vehicle))
    return Swept(rig, _sweep_wheel(rig, travel, rack, vehicle, points=points))


def _sweep_wheel(
    rig: Rig,
    travel: Values | None,
    rack: Values | None,
    vehicle: AxleLayout | None,
    *,
    points: bool,
) -> xr.Dataset:
    steered = None if rack is None else sweep_values(rack, "rack")
    if travel is None:
        if steered is None:
            example = '--travel "-80 mm:80 mm:4 mm", --rack or --roll'
            raise DescriptionError(
                "nothing to sweep is given", where="jounce kinematics", allowed=example
            )
        return sweep_rack(rig, steered, vehicle=vehicle, points=points)
    lifted = sweep_values(travel, "travel")
    if steered is not None and len(steered) > 1 and len(lifted) == 1:
        return sweep_rack(rig, steered, float(lifted[0]), vehicle=vehicle, points=points)
    pair = steered if steered is None or len(steered) > 1 else float(steered[0])
    return sweep_travel(rig, lifted, pair, vehicle=vehicle, points=points)


def _refuse_beside(given: Mapping[str, bool]) -> None:
    """Raise an error for arguments that do not apply to individual poses."""
    for name, is_given in given.items():
        if is_given:
            hint = (
                "For an axle, use --left-travel and --right-travel."
                if name == "travel"
                else "Leave it out."
            )
            raise DescriptionError("not available for individual poses", where=name, hint=hint)


def _sweep_poses(
    rig: Rig, right: Rig | None, file: Path, vehicle: AxleLayout | None, *, points: bool
) -> xr.Dataset:
    """Sweep the poses of a file, for a wheel or an axle."""
    table = read_columns_csv(file)
    names = set(table.names)
    of_axle = right is not None or bool(names & (OF_AXLE.keys() - OF_WHEEL.keys()))
    units = OF_AXLE if of_axle else OF_WHEEL
    if not names & units.keys() or (of_axle and "travel" in names):
        allowed = f"columns {', '.join(OF_WHEEL)} of a wheel, or {', '.join(OF_AXLE)} of an axle"
        raise DescriptionError(
            "the poses are neither those of a wheel nor of an axle",
            where=str(file),
            found=", ".join(table.names),
            allowed=allowed,
        )
    values = {name: table[name].in_si(unit) for name, unit in units.items() if name in names}
    if of_axle:
        _refuse_beside({"points": points})
        return sweep_axle(rig, right=right, vehicle=vehicle, **values)
    lifted, steered = (values.get(name, 0.0) for name in OF_WHEEL)
    return sweep_path(rig, lifted, steered, vehicle=vehicle, points=points)


def _sweep_axle(
    rig: Rig,
    travel: Values | None,
    rack: Values | None,
    roll: Values | None,
    vehicle: AxleLayout | None,
) -> xr.Dataset:
    if roll is None:
        if rack is None:
            raise DescriptionError(
                "nothing to sweep is given",
                where="axle",
                allowed='--rack "-20 mm:20 mm:5 mm", or --roll',
            )
        lifted = 0.0 if travel is None else _single(travel, "travel", "with --axle")
        return sweep_steering(rig, sweep_values(rack, "rack"), lifted, vehicle=vehicle)
    if travel is not None:
        raise DescriptionError(
            "wheel travel follows from the roll angle and cannot be set",
            where="travel",
            hint="Leave out --travel or --roll.",
        )
    if vehicle is not None:
        raise DescriptionError(
            "a roll sweep has no anti-dive percentages",
            where="vehicle",
            hint="Leave it out, or sweep --travel.",
        )
    at = 0.0 if rack is None else _single(rack, "rack", "with --roll")
    return sweep_roll(rig, sweep_values(roll, "roll", "rad"), at)


def _single(values: Values, name: str, why: str) -> float:
    read = sweep_values(values, name)
    if len(read) > 1:
        raise DescriptionError(
            Phrase("only a single value can be used {why}", why=why),
            where=name,
            found=f"{len(read)} values",
        )
    return float(read[0])
