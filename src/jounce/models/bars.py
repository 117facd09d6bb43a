"""Poses of anti-roll bars: an arm about an axis held by a link, and a T-bar held by the links of both wheels.

A T-bar is a stem, hinged across the car, with a bar across its end. Its hinge angle and twist follow from the ends of
the two links on the suspensions. There is no closed form: a fixed number of Newton steps is unrolled, the first ones at
positions between the design pose and the pose. Rates are those for constant link lengths.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import casadi as ca

from jounce.mechanics.rotations import rotate, unit

_ON_THE_WAY, _STEPS = (
    (0.25, 0.5, 0.75),
    5,
)  # the error after the first full step is below rounding after four more
_CLOSED = 1e-9  # m^2
_ACROSS = ca.SX([0.0, 1.0, 0.0])


@dataclass(frozen=True)
class Swing:
    """Angles (rad) of an arm about an axis at which a link of fixed length reaches a point.

    The angle is ``middle`` plus ``branch`` (1 or -1) times the arc cosine of ``cosine``.
    """

    middle: ca.SX
    cosine: ca.SX
    branch: ca.SX

    @classmethod
    def of(cls, axis: ca.SX, arm: ca.SX, far: ca.SX, end: ca.SX) -> Swing:
        """Create from design positions of arm and far link end, and that end's position, all m from the axis."""
        link, along = far - arm, ca.dot(axis, arm)

        def parts(d: ca.SX) -> tuple[ca.SX, ca.SX]:
            return ca.dot(arm - along * axis, d), ca.dot(ca.cross(axis, arm), d)

        a, b = parts(end)
        needed = 0.5 * (ca.dot(arm, arm) + ca.dot(end, end) - ca.dot(link, link)) - along * ca.dot(
            axis, end
        )
        return cls(ca.atan2(b, a), needed / ca.sqrt(a**2 + b**2), ca.sign(parts(far)[1]))

    @property
    def angle(self) -> ca.SX:
        """Return the rotation from design, right-handed; NaN if the link does not reach."""
        return self.middle - self.branch * ca.acos(self.cosine)


@dataclass(frozen=True)
class TBar:
    """Pose of a T-bar, in axes of the car's body with the origin at the stem's hinge.

    ``hinge`` (rad, about +y) and ``twist`` (rad, about the stem) are NaN if the links do not reach. ``tips`` are the
    ends of the bar (m), ``ways`` unit vectors from there along the links, left and right; ``levers`` (2, 2) are the
    rates of each link's length (rows) for unit rates of hinge and twist (columns), m/rad.
    """

    hinge: ca.SX
    twist: ca.SX
    tips: tuple[ca.SX, ca.SX]
    ways: tuple[ca.SX, ca.SX]
    levers: ca.SX

    @property
    def twist_slopes(self) -> tuple[ca.SX, ca.SX]:
        """Return slopes of the twist by the positions of the links' far ends, rad/m, at constant link lengths."""
        (a, b), (c, d) = (ca.horzsplit(row) for row in ca.vertsplit(self.levers))
        gap = a * d - b * c
        return -c / gap * self.ways[0], a / gap * self.ways[1]


def t_bar(stem: ca.SX, arms: Sequence[ca.SX], far: Sequence[ca.SX], ends: Sequence[ca.SX]) -> TBar:
    """Return the pose of a T-bar with closed links.

    ``stem``, its ``arms`` (ends of the bar) and ``far`` (the links' far ends) are design positions, ``ends`` the
    current positions of the far ends; all in m from the stem's hinge, left before right.
    """
    along = unit(stem)
    lengths = [ca.dot(end - arm, end - arm) for arm, end in zip(arms, far, strict=True)]
    hinge, twist = ca.SX(0.0), ca.SX(0.0)
    for share in (
        *_ON_THE_WAY,
        *[1.0] * _STEPS,
    ):  # from design, to stay on the design's assembly branch
        placed = [start + share * (end - start) for start, end in zip(far, ends, strict=True)]
        tips, links, levers = _ends_and_links(along, arms, placed, hinge, twist)
        off = [
            0.5 * (ca.dot(link, link) - length) for link, length in zip(links, lengths, strict=True)
        ]
        (a, b), (c, d) = levers
        gap = a * d - b * c
        hinge, twist = (
            hinge + (d * off[0] - b * off[1]) / gap,
            twist + (a * off[1] - c * off[0]) / gap,
        )
    tips, links, levers = _ends_and_links(along, arms, ends, hinge, twist)
    left = [
        ca.fabs(ca.dot(link, link) - length) for link, length in zip(links, lengths, strict=True)
    ]
    closed = ca.fmax(*left) < _CLOSED
    hinge, twist = (ca.if_else(closed, angle, ca.SX.nan()) for angle in (hinge, twist))
    sizes = [ca.sqrt(length) for length in lengths]
    directions = [link / size for link, size in zip(links, sizes, strict=True)]
    rows = [ca.horzcat(*row) / size for row, size in zip(levers, sizes, strict=True)]
    return TBar(hinge, twist, (tips[0], tips[1]), (directions[0], directions[1]), ca.vertcat(*rows))


@cache
def t_bar_function() -> ca.Function:
    """Return the T-bar as a numeric function: hinge, twist, tips, ways (3, 2) and levers of arguments (3, 2)."""
    stem = ca.SX.sym("stem", 3)
    pairs = [ca.SX.sym(name, 3, 2) for name in ("arms", "far", "ends")]
    bar = t_bar(stem, *(ca.horzsplit(pair) for pair in pairs))
    outputs = [bar.hinge, bar.twist, ca.horzcat(*bar.tips), ca.horzcat(*bar.ways), bar.levers]
    return ca.Function("t_bar", [stem, *pairs], [ca.densify(part) for part in outputs])


def _ends_and_links(
    along: ca.SX, arms: Sequence[ca.SX], ends: Sequence[ca.SX], hinge: ca.SX, twist: ca.SX
) -> tuple[list[ca.SX], list[ca.SX], list[tuple[ca.SX, ca.SX]]]:
    """Return the bar's ends, links, and negated slopes of half the squared link lengths by hinge and twist."""
    stem = rotate(along, _ACROSS, hinge)
    tips = [rotate(rotate(arm, along, twist), _ACROSS, hinge) for arm in arms]
    links = [end - tip for end, tip in zip(ends, tips, strict=True)]
    levers = [
        (ca.dot(link, ca.cross(_ACROSS, tip)), ca.dot(link, ca.cross(stem, tip)))
        for link, tip in zip(links, tips, strict=True)
    ]
    return tips, links, levers
