"""Poses of a dependent axle at pairs of wheel travels, and its exact rates while wheels move together or opposed.

The body is held and the heights of both wheel centres are prescribed. Joints are ideal if the axle then moves as an
axle does; otherwise its bushings yield as described, without springs, bars and preloads, which only forces would
balance.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from jounce.axles.assembly import GROUND, STEP
from jounce.axles.builder import SIDES
from jounce.axles.dependent import build_axle, with_ideal_joints
from jounce.axles.wheels import down, moved, turned, wheel_quantities
from jounce.core.types import Array
from jounce.kernel import equilibrium as eq
from jounce.kinematics.axle import WheelRows
from jounce.kinematics.sweeps import End
from jounce.parts.axles import DependentAxle

MOTIONS = ("together", "opposed")
"""Motions of the wheels: both rise, or the left rises and the right falls."""
_SIGNS = (1.0, -1.0)
_APPROACH = 5e-3  # m: longest step on the way to a pose
_STRUT = ("spring", "bump_stop", "rebound_stop", "damper", "friction")
_ODD = ("steer", "wheel_centre_y", "contact_point_y")  # they change sign when mirrored in y


@dataclass(frozen=True)
class AxlePoses:
    """An axle at pairs of travels, shape (n, 2) in m, NaN out of reach.

    ``poses`` has the shape (n, bodies, 12). ``rates`` (n, bodies, 6, 2) are velocities, of the point now at the
    ground's origin, and rotations of all bodies for a unit rise of each wheel centre. ``forces`` (n, 2) hold
    the wheel centres, N; ``force_rates`` (n, 2, 2) are their slopes, N/m.
    """

    axle: SweptAxle
    travels: Array
    poses: Array
    rates: Array
    forces: Array
    force_rates: Array
    ends: tuple[End, ...]

    @cached_property
    def reached(self) -> NDArray[np.bool_]:
        """Which pairs are reached."""
        return np.asarray(np.isfinite(self.poses).all(axis=(1, 2)))

    def without(self, lost: NDArray[np.bool_], wanted: Array) -> AxlePoses:
        """Return the poses without those ``lost`` on the way to other travels (n, 2), m, and only the ends of these."""
        names = "poses", "rates", "forces", "force_rates"
        arrays = {name: getattr(self, name).copy() for name in names}
        for values in arrays.values():
            values[lost] = np.nan
        ends = [_end(self.travels[k], wanted[k]) for k in np.flatnonzero(lost)]
        return replace(self, **arrays, ends=tuple(ends))

    def along(self, motion: str) -> Array:
        """Velocities and rotations of all bodies along a motion, shape (n, bodies, 6)."""
        sign = 1.0 if motion == "together" else -1.0
        return np.asarray(self.rates[..., 0] + sign * self.rates[..., 1])

    def velocity(self, rates: Array, body: int, point: Array) -> Array:
        """Velocity of a point (n, 3), now on a body, shape (n, 3)."""
        if body == GROUND:
            return np.zeros_like(point)
        return np.asarray(rates[:, body, :3] + np.cross(rates[:, body, 3:], point))

    def wheel(self, side: int, motion: str) -> WheelRows:
        """Return rows of a wheel in the axes of a left wheel; slopes are per its own rise along a motion."""
        sign = _SIGNS[side]
        body, centre, axis, radius = self.axle.wheels[side]
        rates = self.along(motion) * (1.0 if motion == "together" else sign)
        pose, rate = self.poses[:, body], rates[:, body]
        turn = rate[:, 3:]
        matrix = pose[:, 3:].reshape(-1, 3, 3)
        spun = np.stack([np.cross(turn, matrix[:, :, k]) for k in range(3)], axis=2)
        moving = np.concatenate(
            [rate[:, :3] + np.cross(turn, pose[:, :3]), spun.reshape(-1, 9)], axis=1
        )
        with np.errstate(invalid="ignore"):  # out of reach
            found = wheel_quantities(
                pose + 1j * STEP * moving, centre, axis, np.array([radius], dtype=complex), sign
            )
        rows = {name: np.real(value) for name, value in found.items()}
        slopes = {name: np.imag(value) / STEP for name, value in found.items()}
        at_design = centre + radius * down(axis)
        for k, name in enumerate("xyz"):
            rows[f"wheel_centre_{name}"] = rows[f"wheel_centre_{name}"] + centre[k]
            rows[f"contact_point_{name}"] = rows[f"contact_point_{name}"] + at_design[k]
        now = moved(pose, centre)
        reach = radius * down(turned(pose, axis))
        patch, hub = (self.velocity(rates, body, place) for place in (now + reach, now))
        rows |= {
            "half_track_change": sign * (rows["contact_point_y"] - at_design[1]),
            "camber_gain": slopes["camber"],
            "bump_steer": slopes["steer"],
            "half_track_gradient": sign * slopes["contact_point_y"],
            "wheel_centre_longitudinal_slope": hub[:, 0] / hub[:, 2],
            "wheel_centre_lateral_slope": sign * hub[:, 1] / hub[:, 2],
            "contact_patch_recession": patch[:, 0] / patch[:, 2],
            "wheel_centre_recession": hub[:, 0] / patch[:, 2],
            "patch_rise": patch[:, 2] / hub[:, 2],
        }
        rows = {
            name: sign * value if name in (*_ODD, "bump_steer") else value
            for name, value in rows.items()
        }
        return WheelRows(rows, radius)

    def carried(self, side: int, place: Array, motion: str) -> Array:
        """Velocity of a place on a wheel's carrier along a motion, m per unit rise, shape (n, 3)."""
        return self.velocity(self.along(motion), self.axle.wheels[side][0], place)

    def length(self, name: str) -> tuple[Array, Array] | None:
        """Return length (m) of a line, and its rate along each motion, shape (n, 2); None if there is no such line."""
        if name not in self.axle.lines:
            return None
        first, second, start, end = self.axle.lines[name]
        ends = []
        for body, point in ((first, start), (second, end)):
            still = np.broadcast_to(point, (len(self.poses), 3))
            ends.append(still if body == GROUND else moved(self.poses[:, body], point))
        reach = ends[1] - ends[0]
        size = np.linalg.norm(reach, axis=1)
        rates = [
            (
                reach
                * (
                    self.velocity(self.along(motion), second, ends[1])
                    - self.velocity(self.along(motion), first, ends[0])
                )
            ).sum(axis=1)
            / size
            for motion in MOTIONS
        ]
        return size, np.stack(rates, axis=1)


class SweptAxle:
    """A dependent axle ready for poses; ``is_ideal`` says that its joints are."""

    def __init__(self, rig: DependentAxle) -> None:
        self.rig = rig
        ideal = with_ideal_joints(rig)
        self.is_ideal = ideal is not None
        self.built = build_axle(rig if ideal is None else ideal)
        assembly = self.built.assembly
        arrays, self._multipliers = assembly.arrays()
        self.radius = float(arrays.wheels[0, 6])
        self.wheels = [
            (int(body), row[:3].copy(), row[3:6].copy(), float(row[6]))
            for body, row in zip(arrays.carriers, arrays.wheels, strict=True)
        ]
        self.lines = {
            element.name: (
                element.first,
                element.second,
                row[eq.P : eq.P + 3],
                row[eq.Q : eq.Q + 3],
            )
            for element, row in zip(assembly.elements, arrays.data, strict=True)
            if element.kind == eq.LINE
        }
        heights = arrays.wheels.copy()
        heights[:, 6] = 0.0  # then the lowest point is the wheel centre
        self._arrays = arrays._replace(wheels=heights, data=self._at_rest(arrays.data))
        self._controls = [name for name, *_ in assembly.controls]
        self._bodies = len(assembly.bodies)

    def _at_rest(self, data: Array) -> Array:
        """Return the numbers of all elements without friction; without springs, bars and preloads if bushings yield."""
        data = data.copy()
        for row, element in zip(data, self.built.assembly.elements, strict=True):
            if element.kind == eq.BUSHING:
                row[eq.S : eq.S + 12] = 0.0
                if not self.is_ideal:
                    row[eq.F : eq.F + 6] = 0.0
            elif element.kind == eq.LINE:
                row[[eq.SLIP, eq.HOLD]] = 0.0
                if not self.is_ideal and element.name.partition(".")[2] in _STRUT:
                    row[[eq.PRELOAD, eq.RATE, eq.FACTOR]] = 0.0
            elif element.kind == eq.TWIST and not self.is_ideal:
                row[[eq.PRELOAD, eq.RATE]] = 0.0
        return data

    def at(self, left: Array, right: Array, *, stops: bool = False) -> AxlePoses:
        """Find the poses at pairs of travels (m); with ``stops`` none beyond the first out of reach on either side."""
        travels = np.stack(np.broadcast_arrays(left, right), axis=1).astype(float)
        count, bodies = len(travels), self._bodies
        found = AxlePoses(
            self,
            travels,
            np.full((count, bodies, 12), np.nan),
            np.full((count, bodies, 6, 2), np.nan),
            np.full((count, 2), np.nan),
            np.full((count, 2, 2), np.nan),
            (),
        )
        ends: list[End] = []
        known = np.flatnonzero(np.isfinite(travels).all(axis=1))
        if known.size:
            middle = int(np.argmin(np.abs(travels[known]).sum(axis=1)))
            for chain in (known[middle:], known[:middle][::-1]):
                left_over = chain
                while left_over.size:
                    done, end = self._walk(found, left_over)
                    ends += [] if end is None else [end]
                    left_over = left_over[:0] if stops else left_over[done + 1 :]
        return AxlePoses(
            self, travels, found.poses, found.rates, found.forces, found.force_rates, tuple(ends)
        )

    def _walk(self, found: AxlePoses, chain: NDArray[np.intp]) -> tuple[int, End | None]:
        """Walk from design along a chain of pairs; return how many are reached, and the end of travel if not all."""
        stations = np.concatenate([np.zeros((1, 2)), found.travels[chain]])
        path, marks = [stations[0]], []
        for start, end in pairwise(stations):
            steps = max(1, int(np.ceil(np.abs(end - start).max() / _APPROACH)))
            path += list(start + (end - start) * (np.arange(1, steps + 1) / steps)[:, None])
            marks.append(len(path) - 1)
        targets = np.zeros((len(path), len(self._controls)))
        for k, side in enumerate(SIDES):
            column = self._controls.index(f"{side}.contact")
            targets[:, column] = np.array(path)[:, k] + self.wheels[k][1][2]
        settled, space = self._settle(targets)
        for place, mark in zip(chain, marks, strict=True):
            if settled.outcome[mark] == eq.SETTLED:
                self._keep(found, int(place), settled, mark)
        done = int(np.sum(settled.outcome[marks] == eq.SETTLED))
        if done == len(chain):
            return done, None
        last = space.pose[self._bodies : 2 * self._bodies]
        heights = [moved(last[body], centre)[2] - centre[2] for body, centre, *_ in self.wheels]
        return done, _end(np.array(heights), found.travels[chain[done]])

    def _settle(self, targets: Array) -> tuple[eq.Settled, eq.Space]:
        steps, controls = targets.shape
        mixed = (
            np.tile(np.eye(controls).ravel(), (steps, 1)),
            np.zeros((steps, controls * controls)),
        )
        path = eq.Path(*mixed, targets, np.zeros((steps, len(SIDES) * eq.LOADS)))
        places = [(-1 - wheel, 3 * wheel + k) for wheel in range(2) for k in range(3)]
        changes = np.zeros((6, eq.WIDTH))
        changes[np.arange(6), np.arange(6) % 3] = 1.0  # of the wheel centres on their carriers
        seeds = eq.Seeds(np.array(places, dtype=np.int64), changes)
        return eq.settle(self._arrays, path, seeds, self._bodies, self._multipliers, 6)

    def _keep(self, found: AxlePoses, place: int, settled: eq.Settled, mark: int) -> None:
        """Store a pose; a higher wheel centre on its carrier lowers the carrier as a lower target does."""
        poses = settled.poses[mark].reshape(-1, 12)
        found.poses[place] = poses
        slopes = settled.slopes[mark]
        first = 6 * self._bodies + self._multipliers
        rows = [first + self._controls.index(f"{side}.contact") for side in SIDES]
        for wheel, (body, *_) in enumerate(self.wheels):
            upward = poses[body, 9:12]  # the ground's z in the axes of the carrier
            along = -slopes[:, 3 * wheel : 3 * wheel + 3] @ upward
            found.rates[place, :, :, wheel] = along[: 6 * self._bodies].reshape(-1, 6)
            found.force_rates[place, :, wheel] = along[rows]
        found.forces[place] = settled.multipliers[mark, [row - 6 * self._bodies for row in rows]]


def _end(reached: Array, wanted: Array) -> End:
    """Return the end of travel of a pair (2,), m: that of the wheel with the larger travel."""
    which = int(np.argmax(np.abs(wanted)))
    return End(float(reached[which]), 0.0, float(wanted[which]), 0.0, ())
