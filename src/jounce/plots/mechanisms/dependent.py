"""Lines that show a dependent axle at design: beam or arms, links and struts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from jounce.core.types import Array
from jounce.parts.axles import DependentAxle


class DrawnLine(NamedTuple):
    """Two places (m) on the left side or in the middle, their part, and whether the right has a mirror image."""

    places: list[Array]
    part: str
    is_mirrored: bool = True


def dependent_lines(rig: DependentAxle) -> Iterator[DrawnLine]:
    """Yield the lines of a solid axle or a twist beam."""
    points = {name: np.array(place) for name, place in rig.hardpoints.given().items()}
    yield from _twist_beam(points) if "shear_centre" in points else _solid_axle(rig, points)
    for name in ("strut", "spring", "damper"):
        if f"{name}_top" in points:
            yield DrawnLine([points[f"{name}_bottom"], points[f"{name}_top"]], "strut")


def _twist_beam(points: Mapping[str, Array]) -> Iterator[DrawnLine]:
    """Yield trailing arms, and the beam that joins them where its shear centre lies."""
    centre, pivot, shear = points["wheel_centre"], points["pivot"], points["shear_centre"]
    share = (pivot[0] - shear[0]) / (pivot[0] - centre[0]) if pivot[0] != centre[0] else 0.5
    yield DrawnLine([pivot, centre], "beam")
    yield DrawnLine([pivot + np.clip(share, 0.0, 1.0) * (centre - pivot), shear], "beam")


def _solid_axle(rig: DependentAxle, points: Mapping[str, Array]) -> Iterator[DrawnLine]:
    """Yield the axle, its links, and the brackets that carry them."""
    centre = points["wheel_centre"]
    yield DrawnLine([centre, centre * [1.0, 0.0, 1.0]], "beam")
    for name in [name.removesuffix("_axle") for name in points if name.endswith("_axle")]:
        end = points[f"{name}_axle"]
        is_single = name.startswith(("panhard", "watt")) or (
            name == "upper_link" and getattr(rig.hardpoints, "has_centre_link", False)
        )
        holder = np.array([centre[0], end[1], centre[2]])
        if name.startswith("watt"):
            holder = points.get("watt_pivot", holder)
        yield DrawnLine([points[f"{name}_body"], end], "link", not is_single)
        yield DrawnLine([end, holder], "beam", not is_single)
