"""A dependent axle at design: beam or arms, links, struts and anti-roll bar, as a scene and as lines."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from jounce.core.types import Array
from jounce.parts.axles import DependentAxle, TwistBeam
from jounce.plots.figures import INK, PALETTE
from jounce.plots.mechanisms.scene import (
    BAR,
    COLOURS,
    MIDDLE,
    USUAL_WIDTH,
    Bracket,
    Part,
    Pose,
    Scene,
    contact_points,
    ends_of,
    spin_axes,
    with_middle,
)

_AXLE_MIDDLE, _BEAM_END = "axle_middle", "beam_end"
_BEAMS = {"axle", "arm", "beam", "watt_lever"}


class DrawnLine(NamedTuple):
    """Places (m) on the left side or in the middle, their part, and whether the right has a mirror image."""

    places: list[Array]
    part: str
    is_mirrored: bool = True


def dependent_scene(rig: DependentAxle, side: str = "left") -> Scene:
    """Make the scene of one side of a solid axle or a twist beam; what exists once belongs to the left side."""
    sign = 1.0 if side == "left" else -1.0
    once = set() if side == "left" else set(type(rig.hardpoints).one_sided)
    mirror = np.array([1.0, sign, 1.0])
    given = rig.hardpoints.given()
    points = {name: np.array(place) * mirror for name, place in given.items() if name not in once}
    feet = _feet({name: np.array(place) for name, place in given.items()}, sign)
    points = with_middle(points | feet)
    parts = [
        Part(name, ends, INK if name in _BEAMS else COLOURS.get(name, PALETTE[0]))
        for name, ends in _lines(rig)
        if set(ends) <= points.keys()
    ]
    wheel = rig.wheel
    axis = spin_axes(np.array(wheel.camber), np.array(-sign * wheel.toe), sign)
    contact = contact_points(points["wheel_centre"], axis, wheel.radius)
    on_body = {name for name in points if name.endswith("_body")} | {
        name for name in ("pivot", "arb_pivot", "strut_top", "spring_top", "damper_top")
        if name in points
    }  # fmt: skip
    return Scene(
        f"{'twist beam' if isinstance(rig, TwistBeam) else 'solid axle'}, {side} side",
        sign,
        tuple(parts),
        tuple(_brackets(points)),
        frozenset(on_body),
        ends_of(given, "spring"),
        ends_of(given, "damper"),
        None,
        wheel.radius,
        wheel.radius,
        wheel.width or USUAL_WIDTH * wheel.radius,
        Pose(points, axis, contact, float(contact[2]), label="design position"),
        frozenset({*MIDDLE.values(), *(feet.keys() - given.keys())}),
    )


def _lines(rig: DependentAxle) -> Iterator[tuple[str, tuple[str, ...]]]:
    names = rig.hardpoints.given()
    if isinstance(rig, TwistBeam):
        yield "arm", ("pivot", "wheel_centre")
        yield "beam", (_BEAM_END, "shear_centre")
    else:
        yield "axle", ("wheel_centre", _AXLE_MIDDLE)
        for name in (name.removesuffix("_axle") for name in names if name.endswith("_axle")):
            yield name, (f"{name}_body", f"{name}_axle")
        if "watt_pivot" in names:
            yield "watt_lever", ("watt_upper_axle", "watt_pivot", "watt_lower_axle")
    if "arb_pivot" in names:
        yield "anti_roll_bar", (MIDDLE["arb_pivot"], *BAR)


def _feet(points: Mapping[str, Array], sign: float) -> dict[str, Array]:
    """Return where beams end that no hardpoint describes."""
    centre = points["wheel_centre"]
    if "shear_centre" not in points:
        return {_AXLE_MIDDLE: centre * [1.0, 0.0, 1.0]}
    # The beam joins the arms where its shear centre lies.
    pivot, shear = points["pivot"], points["shear_centre"]
    share = (pivot[0] - shear[0]) / (pivot[0] - centre[0]) if pivot[0] != centre[0] else 0.5
    end = (pivot + np.clip(share, 0.0, 1.0) * (centre - pivot)) * [1.0, sign, 1.0]
    return {_BEAM_END: end, "shear_centre": shear}


def _brackets(points: Mapping[str, Array]) -> Iterator[Bracket]:
    """Yield what connects links with a solid axle."""
    if _AXLE_MIDDLE not in points:
        return
    half = float(points["wheel_centre"][1])
    for name, place in points.items():
        if name == "watt_pivot" or (name.endswith("_axle") and not name.startswith("watt")):
            share = float(place[1]) / half
            yield Bracket(name, _AXLE_MIDDLE, "wheel_centre", share, INK)


def dependent_lines(rig: DependentAxle) -> Iterator[DrawnLine]:
    """Yield the lines of a solid axle or a twist beam."""
    scene = dependent_scene(rig)
    points, once = scene.design.points, set(type(rig.hardpoints).one_sided) - {"shear_centre"}
    if getattr(rig.hardpoints, "has_centre_link", False):
        once |= {"upper_link_axle", "upper_link_body"}
    for part in scene.parts:
        kind = "beam" if part.name in _BEAMS else "link"
        yield DrawnLine([points[name] for name in part.points], kind, not once & {*part.points})
    for item in scene.brackets:
        first, second = points[item.first], points[item.second]
        holder = first + item.share * (second - first)
        yield DrawnLine([points[item.point], holder], "beam", item.point not in once)
    for ends in dict.fromkeys((scene.spring, scene.damper)):
        if ends is not None:
            yield DrawnLine([points[name] for name in ends], "strut")
