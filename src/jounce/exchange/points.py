"""Export of hardpoints of a 3-D rig as a table or a CAD drawing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from jounce.core.operation import File, Switch, operation
from jounce.core.serialise import Plain
from jounce.core.writing import Formats
from jounce.exchange.corners import corner_of
from jounce.parts import DependentAxle, Rig, as_rig
from jounce.parts.bodies import Triple
from jounce.parts.corners import Corner
from jounce.parts.options import AnyRig

_MM = 1e3
_LINES = (
    ("strut_bottom", "strut_top"),
    ("pushrod_outer", "pushrod_inner"),
    ("rocker_pivot", "rocker_axis"),
    ("rocker_pivot", "pushrod_inner"),
    ("rocker_pivot", "strut_bottom"),
    ("arm_inner", "arm_outer"),
    ("arm_inner", "wheel_centre"),
    ("arm_outer", "wheel_centre"),
    ("arb_pivot", "arb_arm_end"),
    ("arb_arm_end", "arb_link_end"),
)
"""Lines drawn between points in addition to the links."""
_TEXT = 8.0  # mm: text height


@dataclass(frozen=True)
class HardpointExport(Plain):
    """Exported hardpoints by name: x forward, y left, z up from the road, m."""

    hardpoints: Mapping[str, Triple]


@operation(
    "export hardpoints",
    named={"changes": "set", "path": "out"},
    echo={"rig": "rig", "out": "out"},
    python="jounce.exchange.points:write_hardpoints",
    page="jounce.report.exchange:hardpoint_export_page",
    title="{rig}",
    doing="writing the points",
    example="jounce export hardpoints kart-double-wishbone --out points.csv",
)
def export_hardpoints(
    rig: AnyRig,
    path: Annotated[Path | str, File("File to write: .csv or .dxf, in mm.", "FILE")],
    *,
    force: Annotated[bool, Switch("Overwrite existing output.")] = False,
) -> HardpointExport:
    """Write the hardpoints of a 3-D rig as a table, or as a drawing for CAD.

    Same as :func:`jounce.write_hardpoints`.
    """
    chosen = as_rig(rig)
    write_hardpoints(chosen, path, force=force)
    return HardpointExport(_described(chosen).hardpoints.given())


def write_hardpoints(rig: Rig, path: Path | str, *, force: bool = False) -> Path:
    """Write the hardpoints of a 3-D rig as a table (``.csv``) or a drawing (``.dxf``), in mm.

    The table has columns ``name``, ``x [mm]``, ``y [mm]``, ``z [mm]`` (x forward, y left, z up; z = 0 is the road).
    ``jounce import hardpoints`` reads it. The drawing contains points with their names, and lines along the links.

    Parameters
    ----------
    rig : Rig
        3-D corner of a car, or a dependent axle, whose left side is written.
    path : Path or str
        File to write.
    force : bool
        Overwrite an existing file.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    OutputError
        For a rig without hardpoints, a different suffix, or an existing file.

    Examples
    --------
    >>> import tempfile
    >>> import jounce as jn
    >>> file = write_hardpoints(jn.load("kart-double-wishbone"), tempfile.mkdtemp() + "/points.csv")
    >>> file.read_text().splitlines()[0]
    'name,x [mm],y [mm],z [mm]'
    """
    return POINT_FORMATS.write(_described(rig), path, force=force)


def _described(rig: Rig) -> Corner | DependentAxle:
    if isinstance(rig, DependentAxle):
        return rig
    return corner_of(rig, "the rig has no hardpoints")


def _table(rig: Corner | DependentAxle, file: Path) -> None:
    rows = [
        f"{name},{','.join(map(_number, point))}" for name, point in rig.hardpoints.given().items()
    ]
    file.write_text(
        "\n".join(["name,x [mm],y [mm],z [mm]", *rows, ""]), encoding="utf-8", newline="\n"
    )


def _number(metres: float) -> str:
    return f"{_MM * metres:.9g}"


def _lines(rig: Corner | DependentAxle) -> Iterator[tuple[Triple, Triple]]:
    given = rig.hardpoints.given()
    if isinstance(rig, DependentAxle):
        links = [name.removesuffix("_body") for name in given if name.endswith("_body")]
        rods = [*((f"{name}_body", f"{name}_axle") for name in links), ("pivot", "wheel_centre")]
    else:
        rods = list(type(rig.hardpoints).rods)
    for first, other in (*rods, *_LINES):
        if first in given and other in given:
            yield given[first], given[other]


def _drawing(rig: Corner | DependentAxle, file: Path) -> None:
    """Write DXF in its oldest version (R12), which all CAD programs read."""
    pairs: list[tuple[int, str]] = [
        (0, "SECTION"),
        (2, "HEADER"),
        (9, "$ACADVER"),
        (1, "AC1009"),
        (0, "ENDSEC"),
    ]
    pairs += [(0, "SECTION"), (2, "ENTITIES")]
    for name, point in rig.hardpoints.given().items():
        pairs += [(0, "POINT"), (8, "hardpoints"), *_at(10, point)]
        pairs += [(0, "TEXT"), (8, "names"), *_at(10, point), (40, f"{_TEXT:g}"), (1, name)]
    for first, other in _lines(rig):
        pairs += [(0, "LINE"), (8, "links"), *_at(10, first), *_at(11, other)]
    pairs += [(0, "ENDSEC"), (0, "EOF")]
    file.write_text(
        "".join(f"{code:3d}\n{value}\n" for code, value in pairs), encoding="ascii", newline="\n"
    )


def _at(code: int, point: Triple) -> list[tuple[int, str]]:
    return [(code + 10 * axis, _number(value)) for axis, value in enumerate(point)]


POINT_FORMATS = Formats("hardpoints", {".csv": _table, ".dxf": _drawing})
"""Formats of hardpoint files."""
