"""A sketch of a rig or vehicle as a small SVG picture, to recognise it in a list."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from jounce.core.types import Array
from jounce.parts.axles import DependentAxle
from jounce.parts.corners import Corner
from jounce.parts.rig import Rig
from jounce.parts.vehicles import FullCar, FullCar3D, Vehicle
from jounce.plots.figures import PALETTE
from jounce.plots.mechanisms.dependent import dependent_lines
from jounce.plots.mechanisms.drawing import RUBBER, circle, coil, views_of
from jounce.plots.mechanisms.scene import Scene, scene_of

_SIZE = (160.0, 110.0)  # px
_MARGIN = 6.0
_INK = "#22262b"


def sketch(rig: Rig | Vehicle) -> str:
    """Draw a rig or vehicle without words, as the text of an SVG picture of 160 by 110 px.

    A corner with hardpoints is drawn from ahead, inboard and above at design; of a vehicle of such corners, the whole
    front axle is. A solid axle or twist beam is drawn with both wheels, from behind. Every other model is drawn as
    masses on springs: one axle, two seen from the side, or the four wheels of a full car, those of the far side behind.

    Parameters
    ----------
    rig : Rig or Vehicle
        Rig or vehicle.

    Returns
    -------
    str
        SVG, for a light background.

    Examples
    --------
    >>> import jounce as jn
    >>> sketch(jn.load("kart-double-wishbone"))[:28]
    '<svg xmlns="http://www.w3.or'
    """
    if isinstance(rig, FullCar3D):
        rig = next(
            (end.corner for end in (rig.front, rig.rear) if end.corner), rig.front.suspension
        )
        if isinstance(rig, DependentAxle):
            return _picture(_axle(rig))
        scene = scene_of(rig)
        return _picture([*_mechanism(scene, mirrored=True), *_mechanism(scene)])
    if isinstance(rig, Corner):
        return _picture(_mechanism(scene_of(rig)))
    if isinstance(rig, DependentAxle):
        return _picture(_axle(rig))
    if isinstance(rig, FullCar):
        return _picture(_four_wheels())
    return _picture(_lumped(2 if isinstance(rig, Vehicle) else 1))


_Line = tuple[Array, str, float]  # points on paper, shape (n, 2), y up; colour; width in px


def _mechanism(scene: Scene, *, mirrored: bool = False) -> Iterable[_Line]:
    """Draw a left corner, or its mirror image at the right."""
    side = np.array([1.0, -1.0 if mirrored else 1.0, 1.0])
    for points, colour, width in _parts(scene):
        yield views_of(scene)[3].flat(points * side), colour, width


def _parts(scene: Scene) -> Iterable[_Line]:
    """Return the lines of a corner in space, each with its colour and width."""
    pose = scene.design
    for share in (-0.5, 0.5):
        middle = pose.points["wheel_centre"] + share * scene.width * pose.spin_axis
        yield circle(middle, pose.spin_axis, scene.radius), RUBBER, 1.2
    for part in scene.parts:
        if all(name in pose.points for name in part.points):
            points = np.array([pose.points[name] for name in (*part.points, part.points[0])])
            closed = points if part.plate else points[:-1]
            yield closed, part.colour, 2.6
    if scene.spring is not None:
        bottom, top = (pose.points[name] for name in scene.spring)
        yield coil(bottom, top, scene.coil_radius), scene.strut_colour, 1.2
    if scene.damper is not None:
        yield (
            np.array([pose.points[name] for name in scene.damper]),
            scene.strut_colour,
            2.2,
        )


_ABOVE_AND_BEHIND = np.array([[-0.3, -0.95, 0.0], [0.35, -0.1, 0.93]])
"""View of a dependent axle: directions to the right and up on paper."""
_AXLE_COLOURS = {"beam": (_INK, 2.8), "link": (PALETTE[0], 2.0), "strut": (PALETTE[3], 1.8)}


def _axle(rig: DependentAxle) -> Iterable[_Line]:
    """Draw a dependent axle with both wheels, from above and behind."""
    centre, radius = np.array(rig.hardpoints.wheel_centre), float(rig.wheel.radius)
    for side in (1.0, -1.0):
        mirror = np.array([1.0, side, 1.0])
        for share in (-0.3, 0.3):
            middle = centre * mirror + share * radius * np.array([0.0, 1.0, 0.0])
            rim = circle(middle, np.array([0.0, 1.0, 0.0]), radius)
            yield rim @ _ABOVE_AND_BEHIND.T, RUBBER, 1.2
        for line in dependent_lines(rig):
            if line.is_mirrored or side > 0.0:
                colour, width = _AXLE_COLOURS[line.part]
                yield (np.array(line.places) * mirror) @ _ABOVE_AND_BEHIND.T, colour, width


def _lumped(axles: int) -> Iterable[_Line]:
    """Draw masses on springs: a body, and at each axle a spring, a wheel and the road."""
    places = np.linspace(-1.0, 1.0, axles) if axles > 1 else np.zeros(1)
    reach = 1.5 if axles > 1 else 0.7
    body = np.array([[-reach, 1.6], [reach, 1.6], [reach, 2.1], [-reach, 2.1], [-reach, 1.6]])
    yield body, _INK, 2.2
    zigzag = np.array([0.0, 0.0, 1.0, -1.0, 1.0, -1.0, 1.0, 0.0, 0.0])
    turn = np.linspace(0.0, 2.0 * np.pi, 49)
    for place in places:
        height = np.array([0.75, 0.85, 0.93, 1.06, 1.19, 1.32, 1.42, 1.5, 1.6])
        yield np.stack([place - 0.12 + 0.13 * zigzag, height], axis=-1), PALETTE[3], 1.6
        tube = [[0.22, 0.75], [0.22, 1.1], [0.13, 1.1], [0.31, 1.1], [0.22, 1.1], [0.22, 1.6]]
        yield np.add(tube, [place, 0.0]), PALETTE[3], 1.8
        yield np.stack([place + 0.4 * np.cos(turn), 0.4 + 0.4 * np.sin(turn)], axis=-1), RUBBER, 2.6
        yield np.array([[place, 0.4], [place, 0.75]]), _INK, 1.8
        yield np.array([[place - 0.25, 0.75], [place + 0.35, 0.75]]), _INK, 1.8
    yield np.array([[-reach - 0.3, 0.0], [reach + 0.3, 0.0]]), RUBBER, 1.4


_BEHIND = np.array([0.62, 0.5])  # where the far side of a car is on paper
_FAR = 0.6  # of the width of a line: what is further away


def _four_wheels() -> Iterable[_Line]:
    """Draw a body on four springs: the near side, the far side behind it, and the edges between both."""
    near = list(_lumped(2))
    for points, colour, width in near[:-1]:  # without a road of its own
        yield points + _BEHIND, colour, _FAR * width
    for corner in near[0][0][:4]:
        yield np.array([corner, corner + _BEHIND]), _INK, _FAR * near[0][2]
    yield from near


def _picture(lines: Iterable[_Line]) -> str:
    drawn = list(lines)
    every = np.vstack([points for points, _, _ in drawn])
    low, high = every.min(axis=0), every.max(axis=0)
    room = np.array(_SIZE) - 2.0 * _MARGIN
    scale = float(np.min(room / np.maximum(high - low, 1e-9)))
    middle = 0.5 * (low + high)
    width, height = _SIZE
    paths = "".join(
        f'<path stroke="{colour}" stroke-width="{thick}" d="'
        + "".join(
            f"{'L' if k else 'M'}{0.5 * width + scale * (x - middle[0]):.1f} "
            f"{0.5 * height - scale * (y - middle[1]):.1f}"
            for k, (x, y) in enumerate(points)
        )
        + '"/>'
        for points, colour, thick in drawn
    )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" fill="none" '
        f'stroke-linejoin="round" stroke-linecap="round">{paths}</svg>'
    )
