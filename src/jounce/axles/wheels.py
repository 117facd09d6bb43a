"""Places, directions and angles of a wheel on a moved body; on complex numbers, too, for exact slopes."""

from __future__ import annotations

import numpy as np

from jounce.axles.assembly import Numbers

_AXES = "xyz"


def moved(pose: Numbers, point: Numbers) -> Numbers:
    """Return a point of the design moved with poses (..., 12), shape (..., 3)."""
    return np.asarray(pose[..., :3] + turned(pose, point))


def turned(pose: Numbers, direction: Numbers) -> Numbers:
    """Return a direction of the design turned with poses (..., 12), shape (..., 3)."""
    rows = pose[..., 3:].reshape(*pose.shape[:-1], 3, 3)
    return np.asarray((rows * direction[..., None, :]).sum(axis=-1))


def wheel_quantities(
    pose: Numbers, centre: Numbers, axis: Numbers, radius: Numbers, side: float
) -> dict[str, Numbers]:
    """Return angles (rad) and displacements (m) of a wheel; works on complex numbers, too.

    ``pose`` has the shape (n, 12), ``centre`` and ``axis`` (..., 3); ``side`` is 1 for the left wheel, else -1.
    """
    now, spin_axis = moved(pose, centre), turned(pose, axis)
    leftward = side * spin_axis
    level = np.sqrt(1.0 - leftward[..., 2] ** 2)
    ahead = np.stack([leftward[..., 1], -leftward[..., 0], 0.0 * level], axis=-1) / level[..., None]
    mark = np.stack([side * axis[..., 1], -side * axis[..., 0], 0.0 * axis[..., 0]], axis=-1)
    mark = mark / np.sqrt((mark**2).sum(axis=-1))[..., None]
    mark = turned(pose, mark)
    upward = _cross(ahead, leftward)
    steer = _angle(-leftward[..., 0], leftward[..., 1])
    towards_road = down(spin_axis)
    contact = now + radius[..., None] * towards_road
    contact_at_design = centre + radius[..., None] * down(axis)
    out = {
        "toe": -side * steer,
        "camber": -_arcsine(spin_axis[..., 2]),
        "steer": steer,
        "spin": _angle(-(mark * upward).sum(axis=-1), (mark * ahead).sum(axis=-1)),
    }
    for name, change in (
        ("wheel_centre", now - centre),
        ("contact_point", contact - contact_at_design),
    ):
        out |= {f"{name}_{axis_name}": change[..., i] for i, axis_name in enumerate(_AXES)}
    return out


def down(axis: Numbers) -> Numbers:
    """Return the unit vector from a wheel's centre to its contact point, in the wheel's plane."""
    z = axis[..., 2]
    level = np.sqrt(1.0 - z**2)
    parts = [axis[..., 0] * z / level, axis[..., 1] * z / level, -level]
    return np.stack(parts, axis=-1)


def _cross(a: Numbers, b: Numbers) -> Numbers:
    parts = [
        a[..., (i + 1) % 3] * b[..., (i + 2) % 3] - a[..., (i + 2) % 3] * b[..., (i + 1) % 3]
        for i in range(3)
    ]
    return np.stack(parts, axis=-1)


def _angle(sine: Numbers, cosine: Numbers) -> Numbers:
    """Return the angle of two numbers; of complex ones with its exact slope as imaginary part."""
    angle = np.arctan2(np.real(sine), np.real(cosine))
    if not np.iscomplexobj(sine):
        return np.asarray(angle)
    square = np.real(sine) ** 2 + np.real(cosine) ** 2
    slope = np.real(cosine) * np.imag(sine) - np.real(sine) * np.imag(cosine)
    return np.asarray(angle + 1j * slope / square)


def _arcsine(value: Numbers) -> Numbers:
    return _angle(value, np.sqrt(1.0 - value**2))


def caster_of(lower: Numbers, upper: Numbers) -> Numbers:
    """Return the caster angle of the line through two points, rad, top rearward positive."""
    line = upper - lower
    return _angle(-line[..., 0], line[..., 2])
