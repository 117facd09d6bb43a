"""Static equilibrium of rigid parts: unknown forces and torques in joints, one linear system a pose."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from jounce.core.types import Array

BODY = ""
"""What carries everything: the car's body with the rack on it. It is not one of the parts in balance."""


@dataclass
class Balance:
    """Parts in balance at n poses; an unknown is what the part nearer to the wheel does to the one nearer to the body.

    Attributes
    ----------
    parts : tuple of str
        Parts whose forces and torques must balance.
    poses : int
        Number of poses.
    """

    parts: tuple[str, ...]
    poses: int
    _columns: list[Array] = field(default_factory=list)
    _shared: list[tuple[Array, list[int], list[int]]] = field(default_factory=list)
    _load: Array = field(init=False)

    def __post_init__(self) -> None:
        self._load = np.zeros((self.poses, 6 * len(self.parts)))

    def load(self, part: str, force: Array, point: Array, torque: Array) -> None:
        """Apply a force (N, shape (n, 3)) at a point (m) and a torque (N m) to a part."""
        self._load += self._wrench(part, force, point) + self._turn(part, torque)

    def along(self, inner: str, outer: str, direction: Array, at: Array) -> int:
        """Add an unknown force along a direction, shape (n, 3), at a point; give its place among the unknowns."""
        self._columns.append(self._wrench(inner, direction, at) - self._wrench(outer, direction, at))
        return len(self._columns) - 1

    def about(self, inner: str, outer: str, direction: Array) -> int:
        """Add an unknown torque about a direction."""
        self._columns.append(self._turn(inner, direction) - self._turn(outer, direction))
        return len(self._columns) - 1

    def joint(self, inner: str, outer: str, at: Array) -> list[int]:
        """Add a ball joint: three unknown forces along the ground's axes."""
        return [self.along(inner, outer, np.tile(axis, (self.poses, 1)), at) for axis in np.eye(3)]

    def share(self, axis: Array, one: list[int], other: list[int]) -> None:
        """Let two joints share the force along an axis equally; without that a shaft in two bearings has no answer."""
        self._shared.append((axis, one, other))

    def solve(self) -> Array:
        """Solve for all unknowns, shape (n, unknowns)."""
        count = len(self._columns)
        matrix = np.zeros((self.poses, count, count))
        right = np.zeros((self.poses, count))
        rows = 6 * len(self.parts)
        matrix[:, :rows] = np.stack(self._columns, axis=2)
        right[:, :rows] = -self._load
        for i, (axis, one, other) in enumerate(self._shared):
            matrix[:, rows + i, one] += axis
            matrix[:, rows + i, other] -= axis
        return np.asarray(np.linalg.solve(matrix, right[:, :, None])[:, :, 0])

    def _wrench(self, part: str, force: Array, point: Array) -> Array:
        rows = np.zeros((self.poses, 6 * len(self.parts)))
        if part != BODY:
            first = 6 * self.parts.index(part)
            rows[:, first : first + 3] = force
            rows[:, first + 3 : first + 6] = np.cross(point, force)
        return rows

    def _turn(self, part: str, torque: Array) -> Array:
        rows = np.zeros((self.poses, 6 * len(self.parts)))
        if part != BODY:
            first = 6 * self.parts.index(part)
            rows[:, first + 3 : first + 6] = torque
        return rows
