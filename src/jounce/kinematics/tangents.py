"""Exact derivatives of all catalogue rows, or of positions, along changes of the description, at all poses at once."""

from __future__ import annotations

import ctypes
from functools import cached_property

import numpy as np

from jounce.core.types import Array
from jounce.kernel.poses import REACHED
from jounce.kinematics.sweeps import PreparedSweep

_MANY = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 5, *[ctypes.c_int64] * 3)


class Tangents:
    """Slopes at the poses of the last run of a sweep.

    ``directions`` (tracks and parameters, n) has in each column the change of travel and rack (m) and of the model's
    ``parameters``; the loops stay closed. With ``places`` the slopes are those of the model's ``points`` (x, y, z of
    each), camber and steer, in place of the rows.
    """

    def __init__(self, sweep: PreparedSweep, directions: Array, *, places: bool = False) -> None:
        self.sweep, self._places = sweep, places
        self.count, self.poses = directions.shape[1], len(sweep.layout.place)
        size = len(sweep.walk.start)
        self._states = np.empty((size + len(directions), self.count, self.poses))
        self._states[size:] = directions[:, :, None]
        rows = 3 * len(sweep.model.point_names) + 2 if places else len(sweep.model.rows)
        self._out = np.empty((rows, self.count, self.poses))

    @cached_property
    def _evaluate(self) -> ctypes._FuncPointer:
        model = self.sweep.model  # keeps the code alive
        return _MANY((model.place_tangents if self._places else model.tangents).address["output"])

    def run(self) -> Array:
        """Compute the slopes, shape (rows, directions, targets of the walk), NaN for a pose out of reach."""
        poses, walk = self.sweep.found, self.sweep.walk
        size, samples = len(walk.start), self.count * self.poses
        self._states[:size] = poses.poses[:, None, :]
        inputs = np.ascontiguousarray(np.tile(poses.inputs, (1, self.count)))
        arrays = (self._states, inputs, walk.p, np.zeros(1), self._out)
        self._evaluate(
            *(array.__array_interface__["data"][0] for array in arrays), samples, 0, samples
        )
        return np.where(poses.outcome == REACHED, self._out, np.nan)
