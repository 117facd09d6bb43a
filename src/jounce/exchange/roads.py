"""Export of roads as OpenCRG or as a table."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import numpy as np

from jounce.core.errors import DescriptionError
from jounce.core.findings import Finding, finding
from jounce.core.operation import File, Number, Switch, operation
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain
from jounce.core.typed import LONGEST
from jounce.core.types import Array
from jounce.core.writing import Formats
from jounce.roads import load_road
from jounce.roads.road import Road

STEP, WIDTH = (
    0.01,
    4.0,
)  # m, chosen: `exchange.height_lost` reports a step that is too coarse; cars are narrower than the width
_MOST = 2_000_000  # maximum number of points: limits the file size


@dataclass(frozen=True)
class RoadExport(Plain):
    """Result of a road's export.

    Attributes
    ----------
    path : Path
        The file written.
    points : int
        Number of cross sections.
    length, step : float
        Length of the road and distance between points, m.
    findings : tuple of Finding
        Properties of the road that points cannot represent.
    """

    path: Path
    points: int
    length: float
    step: float
    findings: tuple[Finding, ...]


@operation(
    "export road",
    named={"path": "out"},
    faces={"step": None},
    echo={"road": "road", "out": "out"},
    page="jounce.report.exchange:road_export_page",
    title="{road}",
    doing="writing the road",
    example='jounce export road iso:C --length "100 m" --out class-c.crg',
)
def write_road(
    road: Annotated[
        Road | str | Path,
        File("A road file, a shipped road, or iso:A to iso:H.", "ROAD", ("roads",)),
    ],
    path: Annotated[Path | str, File("File to write: .crg or .csv.", "FILE")],
    *,
    length: Annotated[
        float | None,
        Number(
            "Length of the course. Default: to the road's end.", "LENGTH", "m", is_positive=True
        ),
    ] = None,
    step: Annotated[
        float,
        Number(
            "Distance between points. Default: 10 mm.",
            "LENGTH",
            "m",
            is_positive=True,
            most=LONGEST,
        ),
    ] = STEP,
    force: Annotated[bool, Switch("Overwrite existing output.")] = False,
) -> RoadExport:
    """Write any road as OpenCRG, or as a table of distance and height.

    OpenCRG (``.crg``) describes a straight road, 4 m wide, with constant height across. A table (``.csv``) has columns
    x and z.

    Parameters
    ----------
    road : Road, str or Path
        Obstacle, waves, random or measured road, its file, or a name such as ``"iso:C"``.
    path : Path or str
        File to write.
    length : float, optional
        Length from distance 0, m. By default to the end of the road, or half a metre past an obstacle.
    step : float
        Distance between points, m; the road is linear between them.
    force : bool
        Overwrite an existing file.

    Returns
    -------
    RoadExport
        The file written; a finding reports the maximum error between points.

    Raises
    ------
    DescriptionError
        For a length or step that is not above 0, a length beyond the road's end, or too many points.
    OutputError
        For a different suffix, or an existing file.

    Examples
    --------
    >>> import tempfile
    >>> import jounce as jn
    >>> road = jn.HalfSine(height="10 mm", length="0.5 m", start="1 m")
    >>> made = write_road(road, tempfile.mkdtemp() + "/bump.crg")
    >>> again = jn.load_road(made.path)
    >>> round(float(again.height_at(1.25)), 9)   # m
    0.01
    """
    ROAD_FORMATS.check(path, force=force)
    if not isinstance(road, Road):
        road = load_road(road) if length is None else load_road(road, length=length)
    known = road.known_length()
    if length is None:
        length = known if np.isfinite(known) else road.end() + 0.5
    for name, value in (("length", length), ("step", step)):
        if not (np.isfinite(value) and value > 0.0):
            raise DescriptionError(
                "out of range", where=name, found=f"{value} m", allowed="above 0 m"
            )
    if length > known * (1.0 + 1e-9):
        raise DescriptionError(
            "the road is not known over this distance",
            where="length",
            found=f"{length:g} m",
            allowed=Phrase("up to {known:g} m", known=known),
        )
    count = round(length / step) + 1
    if not 2 <= count <= _MOST:
        raise DescriptionError(
            "invalid number of points", where="step", found=f"{count} points",
            allowed=Phrase("2 to {most}", most=_MOST), hint="Change the step or the length.",
        )  # fmt: skip
    x = step * np.arange(count)
    height = road.height_at(np.minimum(x, known))
    fine = step * (np.arange(0, count - 1, max(1, count // 50_000)) + 0.5)
    lost = float(np.abs(road.height_at(np.minimum(fine, known)) - np.interp(fine, x, height)).max())
    findings: tuple[Finding, ...] = ()
    if lost > 1e-6:  # m: smaller errors do not affect a tyre
        findings = (finding("exchange.height_lost", str(path), lost, lost=lost, step=step),)
    file = ROAD_FORMATS.write((x, height), path, force=force)
    return RoadExport(file, count, float(x[-1]), step, findings)


def _crg(course: tuple[Array, Array], file: Path) -> None:
    import pyopencrg

    x, height = course
    edges = 0.5 * WIDTH * np.array([-1.0, 1.0])
    road = pyopencrg.CrgRoad(
        np.column_stack([height, height]), u_inc=float(x[1]), v=edges, comments=["jounce"]
    )
    road.save(str(file), "KDBI")


def _table(course: tuple[Array, Array], file: Path) -> None:
    rows = "".join(f"{x:.9g},{height + 0.0:.9g}\n" for x, height in zip(*course, strict=True))
    file.write_text(f"x [m],z [m]\n{rows}", encoding="utf-8", newline="\n")


ROAD_FORMATS = Formats("roads", {".crg": _crg, ".csv": _table})
"""Formats of road files."""
