"""Shapes for drawing: views, the silhouette of a wheel, the coil of a spring. Nothing here is a result."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from jounce.core.types import Array

_AROUND = 72
_TYRE = ((-0.5, 0.9), (-0.42, 0.975), (-0.25, 1.0), (0.25, 1.0), (0.42, 0.975), (0.5, 0.9))
COILS = 8.0


@dataclass(frozen=True)
class View:
    """A direction to look in, without perspective.

    Attributes
    ----------
    name : str
        What the picture is called.
    right, up : ndarray, shape (3,)
        Unit vectors of ground axes that point to the right and up on paper.
    """

    name: str
    right: Array
    up: Array

    @property
    def back(self) -> Array:
        """Unit vector towards the one who looks, shape (3,)."""
        return np.cross(self.right, self.up)

    def flat(self, points: Array) -> Array:
        """Places on paper, shape (..., 2), of points in space, shape (..., 3), in their unit."""
        return np.stack([points @ self.right, points @ self.up], axis=-1)


def axis_view(name: str, right: tuple[float, float, float], up: tuple[float, float, float]) -> View:
    """Look along a ground axis."""
    return View(name, np.array(right), np.array(up))


def oblique_view(name: str, azimuth: float, elevation: float) -> View:
    """Look from a place ``azimuth`` (rad, from straight ahead of the car towards its left) and ``elevation`` (rad)."""
    right = np.array([-np.sin(azimuth), np.cos(azimuth), 0.0])
    back = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
    return View(name, right, np.cross(back, right))


def _across(axis: Array) -> tuple[Array, Array]:
    """Two unit vectors across an axis and each other; the second is as upright as can be."""
    level = np.cross(axis, [0.0, 0.0, 1.0])
    size = np.linalg.norm(level)
    level = level / size if size > 1e-9 else np.array([1.0, 0.0, 0.0])
    return level, np.cross(level, axis)


def circle(centre: Array, axis: Array, radius: float) -> Array:
    """Points on a closed circle in space, shape (n, 3)."""
    first, second = _across(axis)
    angle = np.linspace(0.0, 2.0 * np.pi, _AROUND + 1)[:, None]
    return np.asarray(centre + radius * (np.cos(angle) * first + np.sin(angle) * second))


def tyre(centre: Array, axis: Array, radius: float, width: float, ground: float | None = None) -> Array:
    """Rings of a tyre's surface, shape (rings, n, 3); what would stand below ``ground`` (m) is pressed flat."""
    rings = np.stack([circle(centre + share * width * axis, axis, size * radius) for share, size in _TYRE])
    if ground is not None:
        rings[..., 2] = np.maximum(rings[..., 2], ground)
    return rings


def outline(points: Array) -> Array:
    """Corners of the convex outline of points on paper, shape (n, 2) to (m, 2), counter-clockwise.

    Examples
    --------
    >>> outline(np.array([[0.0, 0.0], [1.0, 0.0], [0.5, 0.2], [1.0, 1.0], [0.0, 1.0]])).tolist()
    [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
    """
    ordered = [tuple(point) for point in np.unique(points.reshape(-1, 2), axis=0)]
    if len(ordered) < 3:
        return np.array(ordered)
    halves = []
    for run in (ordered, ordered[::-1]):
        half: list[tuple[float, float]] = []
        for x, y in run:
            while len(half) > 1 and _turn(half[-2], half[-1], (x, y)) <= 0.0:
                half.pop()
            half.append((x, y))
        halves.append(half[:-1])
    return np.array(halves[0] + halves[1])


def _turn(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def coil(bottom: Array, top: Array, radius: float) -> Array:
    """Helix between two points, shape (n, 3), with straight ends."""
    axis = (top - bottom) / np.linalg.norm(top - bottom)
    first, second = _across(axis)
    share = np.linspace(0.0, 1.0, int(24 * COILS) + 1)
    reach = np.clip(np.minimum(share, 1.0 - share) * 3.0 * COILS, 0.0, 1.0)[:, None]
    angle = 2.0 * np.pi * COILS * share[:, None]
    turned = np.cos(angle) * first + np.sin(angle) * second
    turns = bottom + (0.08 + 0.84 * share[:, None]) * (top - bottom) + radius * reach * turned
    return np.vstack([bottom, turns, top])
