"""Clearances for commands and pages: one line per pair of bodies, and the minimum distance of each pair."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding, finding
from jounce.core.operation import MadeBy, Texts, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain, to_plain
from jounce.core.typed import quantity
from jounce.kinematics.clearances import Rim, Shape, Solid, clearances, link_lengths
from jounce.kinematics.options import RACK, TRAVEL
from jounce.kinematics.sweeps import Values, sweep_values
from jounce.kinematics.swept import plain_sweep
from jounce.parts import Rig, as_rig
from jounce.parts.options import AnyRig

if TYPE_CHECKING:
    import xarray as xr

_BODY = "tie_rod_inner-tie_rod_outer 8 mm"
_RIM = re.compile(r"rim\s+(?P<radius>.+?)\s+from\s+(?P<inner>.+?)\s+to\s+(?P<outer>.+)")
_ALLOWED = f'NAME: BODY, BODY; a body is "{_BODY}" or "rim 115 mm from -90 mm to 20 mm"'
_WIDEST = 1.0  # m: of a body; a larger bare number is taken for millimetres


@dataclass(frozen=True)
class ClearanceStudy(Plain):
    """Distances of bodies of a corner, and lengths of its links.

    Attributes
    ----------
    rig : Rig
        The corner.
    lengths : dict
        Link to its length at design, m.
    data : xarray.Dataset or None
        Every distance over travel and rack, m; None without pairs.
    """

    rig: Rig
    lengths: dict[str, float]
    data: xr.Dataset | None

    @property
    def stopped(self) -> str:
        """Reason for the early end of the sweep; empty if it is complete."""
        why = "" if self.data is None else str(self.data.attrs["stopped"])
        return f"{why}. The poses before that are kept" if why else ""

    @property
    def least(self) -> dict[str, dict[str, float]]:
        """Minimum distance of each pair, and travel and rack travel where it occurs, m."""
        return (
            {}
            if self.data is None
            else {str(name): _least(self.data, str(name)) for name in self.data.data_vars}
        )

    @property
    def findings(self) -> tuple[Finding, ...]:
        """Pairs that overlap."""
        return tuple(
            finding(
                "kinematics.bodies_overlap", name, least["clearance"], overlap=-least["clearance"]
            )
            for name, least in self.least.items()
            if least["clearance"] < 0.0
        )

    def to_dict(self) -> dict[str, Any]:
        """Return plain values, SI."""
        return {
            "lengths": self.lengths,
            "least": self.least,
            "quantities": {} if self.data is None else plain_sweep(self.data),
            "findings": to_plain(self.findings),
        }


def named_pairs(
    between: Annotated[
        Sequence[str] | None,
        Texts(
            f'Two bodies that may touch: "rod in rim: {_BODY}, rim 115 mm from -90 mm to 20 mm". A body is '
            "hardpoints, joined by hyphens where it is a bar, and its radius; or the inside of the rim, its offsets "
            "from the wheel centre, outboard positive. Repeat it.",
            "NAME: BODY, BODY",
        ),
    ] = None,
) -> dict[str, tuple[Shape, Shape]]:
    """Read pairs of bodies by name."""
    named: dict[str, tuple[Shape, Shape]] = {}
    for text in between or ():
        name, colon, rest = text.partition(":")
        name, bodies = name.strip(), rest.split(",")
        if not (colon and name) or len(bodies) != 2:
            raise DescriptionError(
                "two different bodies are required", where="--between", found=text, allowed=_ALLOWED
            )
        if name in named:
            raise DescriptionError(
                Phrase("{name!r} is given twice", name=name), where="--between", found=text
            )
        where = f"--between {name}"
        named[name] = (_body(bodies[0].strip(), where), _body(bodies[1].strip(), where))
    return named


def pairs_in_python(between: Sequence[str] | None = None) -> str:
    """Write pairs of bodies as Python.

    >>> pairs_in_python(["points: a, b 8 mm"])
    "{'points': (jn.Solid(points=('a',), places=(), radius=0.0), jn.Solid(points=('b',), places=(), radius=0.008))}"
    """
    pairs = (
        f"{name!r}: (jn.{first!r}, jn.{second!r})"
        for name, (first, second) in named_pairs(between).items()
    )
    return f"{{{', '.join(pairs)}}}"


def check_between(between: Sequence[str] | None, **given: object) -> None:
    """Raise an error for distance options if no distance is requested."""
    for option in () if between else ("out", "figure", "travel", "rack"):
        if given[option] is not None:
            allowed = f"--between {_ALLOWED}"
            raise DescriptionError(
                "no distances are requested", where=f"--{option}", allowed=allowed
            )


@operation(
    "clearances",
    named={"changes": "set"},
    offers=("sweep", "figure"),
    check="jounce.kinematics.clearance_study:check_between",
    figure="jounce.plots.kinematics:clearances",
    page="jounce.report.clearances:clearances_page",
    title="Clearances of {rig}",
    doing="sweeping",
    example='jounce clearances formula-student-front --travel "-25 mm:25 mm:5 mm" --rack "-20 mm:20 mm:10 mm" '
    '--between "rod in rim: tie_rod_inner-tie_rod_outer 8 mm, rim 115 mm from -90 mm to 20 mm"',
)
def study_clearances(
    rig: AnyRig,
    pairs: Annotated[
        Mapping[str, Sequence[Shape]] | None,
        MadeBy(
            "jounce.kinematics.clearance_study:named_pairs",
            "jounce.kinematics.clearance_study:pairs_in_python",
        ),
    ] = None,
    travel: Annotated[Values | None, TRAVEL] = None,
    rack: Annotated[Values | None, RACK] = None,
) -> ClearanceStudy:
    """Compute minimum distances of bodies of a corner over travel and rack, and the lengths of its links.

    Parameters
    ----------
    rig : Rig, str or Path
        A corner, its file or its name in the library.
    pairs : mapping, optional
        Name to two bodies, as for :func:`jounce.clearances`.
    travel, rack : values, optional
        Wheel travel (bump positive) and rack travel (positive to the left), m.

    Returns
    -------
    ClearanceStudy
        SI.

    Examples
    --------
    >>> import jounce as jn
    >>> pair = (jn.Solid(points=["tie_rod_outer"]), jn.Solid(points=["lower_ball_joint"], radius="10 mm"))
    >>> study = study_clearances("formula-student-front", {"rod and joint": pair}, "-20 mm:20 mm:20 mm")
    >>> study.least["rod and joint"]["clearance"] > 0.0
    True
    """
    rig = as_rig(rig)
    lengths = link_lengths(rig)
    if not pairs:
        return ClearanceStudy(rig, lengths, None)
    over_travel = 0.0 if travel is None else sweep_values(travel, "travel")
    over_rack = None if rack is None else sweep_values(rack, "rack")
    data = clearances(rig, pairs, over_travel, over_rack)
    if data.sizes["wheel_travel"] == 1 < data.sizes["rack_travel"]:
        data = data.isel(wheel_travel=0)
    return ClearanceStudy(rig, lengths, data)


def _body(text: str, where: str) -> Solid | Rim:
    rim = _RIM.fullmatch(text)
    if rim is not None:
        sizes = {
            name: quantity(value, "m", where, most=_WIDEST)
            for name, value in rim.groupdict().items()
        }
        return Rim.from_table(sizes, where=where)
    points, _, radius = text.partition(" ")
    names = [name.strip() for name in points.split("-")]
    if not all(names) or names == ["rim"]:
        raise DescriptionError("not a body", where=where, found=text, allowed=_ALLOWED)
    size = quantity(radius.strip(), "m", where, most=_WIDEST) if radius.strip() else 0.0
    return Solid.from_table({"points": names, "radius": size}, where=where)


def _least(data: xr.Dataset, name: str) -> dict[str, float]:
    """Return the minimum distance and where it occurs, m."""
    values = data[name]
    at = np.unravel_index(int(np.nanargmin(values.to_numpy())), values.shape)
    place = values[dict(zip(values.dims, at, strict=True))]
    return {
        "clearance": float(place),
        **{along: float(place[along]) for along in ("wheel_travel", "rack_travel")},
    }
