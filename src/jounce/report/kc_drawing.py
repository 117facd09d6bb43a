"""Drawing of an axle on the K&C rig with the input of a test, as shapes of a page's figure."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.types import Array
from jounce.parts import Corner, DependentAxle
from jounce.plots.mechanisms.dependent import dependent_lines
from jounce.report.chart import Panel

if TYPE_CHECKING:
    from jounce.kc.tests import KCTest

_WIDTH, _HEIGHT, _ROOM = 460, 190, 34
_ARROW = 46.0
_SLENDER = 0.65  # width of a tyre over its radius, where nothing says it
_BEHIND = np.array([[0.0, -1.0, 0.0], [0.0, 0.0, 1.0]])
_ABOVE = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0]])
"""Views with the left wheel on the left: directions to the right and up on paper, in ISO axes."""
_SIDES = (1.0, -1.0)


_Line = tuple[list[Array], bool]
"""Places of a line on the left side or the middle, and whether the right side has its mirror image."""


def axle_drawing(rig: Any, test: KCTest) -> Panel | None:
    """Draw both wheels with their links and the input of a test: from behind, or from above with forward up."""
    if isinstance(rig, DependentAxle):
        points = {name: np.array(place) for name, place in rig.hardpoints.given().items()}
        radius = float(rig.wheel.radius)
        spin, width = np.array([0.0, 1.0, 0.0]), _SLENDER * radius
        contact = points["wheel_centre"] - np.array([0.0, 0.0, radius])
        lines: list[_Line] = [(line.places, line.is_mirrored) for line in dependent_lines(rig)]
    elif isinstance(rig, Corner):
        from jounce.plots.mechanisms.scene import scene_of

        scene = scene_of(rig if rig.side == "left" else rig.mirrored())
        points = {name: np.asarray(place) for name, place in scene.design.points.items()}
        radius, width = scene.radius, scene.width
        spin, contact = scene.design.spin_axis, scene.design.contact
        parts = [part.points for part in scene.parts]
        parts += [ends for ends in (scene.spring, scene.damper) if ends]
        lines = [([points[name] for name in names if name in points], True) for names in parts]
    else:
        return None
    return _drawing(
        test, points, lines, _wheel(points["wheel_centre"], spin, radius, width), contact
    )


def _drawing(
    test: KCTest, points: dict[str, Array], lines: list[_Line], wheel: Array, contact: Array
) -> Panel:
    view = _BEHIND if test.kind in ("heights", "roll", "lateral") else _ABOVE
    every = np.vstack([wheel, *(np.array(line) for line, _ in lines if line)])
    every = np.vstack([every, every * [1.0, -1.0, 1.0]])
    to_paper = _projection(every, view)
    shapes: list[str] = []
    for side in _SIDES:
        mirror = np.array([1.0, side, 1.0])
        shapes.append(_polygon(to_paper(_hull(wheel * mirror, view))))
        shapes += [
            _line(to_paper(np.array(line) * mirror), closed=len(line) > 2)
            for line, is_mirrored in lines
            if len(line) > 1 and (is_mirrored or side > 0.0)
        ]
    centre = points["wheel_centre"]
    ground = to_paper(np.array([contact, contact * [1.0, -1.0, 1.0]]))
    if view is _BEHIND:
        y = ground[0, 1]
        shapes.append(f'<path class="axis" d="M6 {y:.1f}H{_WIDTH - 6}"/>')
    shapes += _input(test, to_paper, contact, centre, points)
    names = "seen from behind" if view is _BEHIND else "seen from above, forward is up"
    shapes.append(f'<text class="note" x="6" y="{_HEIGHT - 4}">{names}</text>')
    for side, name in zip(_SIDES, ("left", "right"), strict=True):
        x = to_paper(centre * np.array([1.0, side, 1.0]))[0]
        shapes.append(f'<text x="{x:.0f}" y="14" text-anchor="middle">{name}</text>')
    return Panel((), width=_WIDTH, height=_HEIGHT, drawn="".join(shapes))


def _wheel(centre: Array, axis: Array, radius: float, width: float) -> Array:
    from jounce.plots.mechanisms.drawing import tyre

    return tyre(centre, axis, radius, width).reshape(-1, 3)


def _hull(points: Array, view: Array) -> Array:
    """Return the outline of points in a view, as points in space on the plane of the view."""
    from jounce.plots.mechanisms.drawing import outline

    return outline(points @ view.T) @ view


def _projection(points: Array, view: Array) -> Any:
    flat = points @ view.T
    low, high = flat.min(axis=0), flat.max(axis=0)
    size = np.array([_WIDTH - 2.0 * _ROOM, _HEIGHT - 2.0 * _ROOM])
    scale = float((size / np.maximum(high - low, 1e-6)).min())
    middle = 0.5 * (low + high)

    def to_paper(places: Array) -> Array:
        at = (np.asarray(places) @ view.T - middle) * scale
        return np.stack([0.5 * _WIDTH + at[..., 0], 0.5 * _HEIGHT - at[..., 1]], axis=-1)

    return to_paper


def _path(points: Array) -> str:
    return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in points)


def _polygon(points: Array) -> str:
    return f'<path d="{_path(points)}Z" style="fill:var(--faint);stroke:var(--rubber)"/>'


def _line(points: Array, *, closed: bool) -> str:
    return f'<path class="l" d="{_path(points)}{"Z" if closed else ""}"/>'


def _input(
    test: KCTest, to_paper: Any, contact: Array, centre: Array, points: dict[str, Array]
) -> Iterator[str]:
    """Yield arrows of a positive input."""
    if test.kind == "rack":
        inner = points.get("tie_rod_inner", points.get("link_5_inner", centre))
        at = to_paper(inner * [1.0, 0.0, 1.0])
        yield _arrow(at, np.array([-1.0, 0.0]))
        return
    for side, share in zip(_SIDES, test.shares, strict=True):
        mirror = np.array([1.0, side, 1.0])
        place = contact if test.through == "contact_point" else centre
        at = to_paper(place * mirror)
        if test.kind in ("heights", "roll"):
            up = side if test.kind == "roll" else 1.0
            yield _arrow(at + np.array([0.0, 0.5 * _ROOM * up]), np.array([0.0, -up]), 0.5)
        elif share and test.kind == "aligning":
            yield _turn(at, share)
        elif share:
            along = [-share, 0.0] if test.kind == "lateral" else [0.0, -test.direction]
            yield _arrow(at, np.array(along))


def _arrow(at: Array, along: Array, size: float = 1.0) -> str:
    """Draw an arrow that begins at a place on paper."""
    end = at + size * _ARROW * along
    across = np.array([-along[1], along[0]])
    head = np.array([end, end - 9.0 * along + 4.5 * across, end - 9.0 * along - 4.5 * across])
    shaft = np.array([at, end - 8.0 * along])
    return f'<path class="l after thick" d="{_path(shaft)}"/><path class="m after" d="{_path(head)}Z"/>'


def _turn(at: Array, share: float) -> str:
    """Draw an arrow about the vertical axis, counter-clockwise from above if the share is positive."""
    radius, way = 26.0, float(np.sign(share))
    angles = way * np.linspace(-0.3, 1.25 * np.pi, 24)
    arc = at + radius * np.stack([np.cos(angles), -np.sin(angles)], axis=-1)
    along = way * np.array([-np.sin(angles[-1]), -np.cos(angles[-1])])
    across = np.array([-along[1], along[0]])
    end = arc[-1]
    head = np.array([end + 9.0 * along, end + 4.5 * across, end - 4.5 * across])
    return (
        f'<path class="l after thick" d="{_path(arc)}"/><path class="m after" d="{_path(head)}Z"/>'
    )
