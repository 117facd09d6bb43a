"""Covariances under white noise that reaches a linear model at several times: exact, with exact slopes.

The heights of a road whose velocity is white noise wander without limit, so states are taken relative to what the
model does when the road moves slowly: ``x_rel = x - E z`` with ``A E + B0 = 0``. Then ``dx_rel/dt = A x_rel +
(B1 - E) dz/dt``, and an output is stationary exactly if what is left of ``C E + D0`` sums to nothing over the wheels
that one noise drives. Wheel ``l`` follows wheel ``k`` by ``s``: their cross term is ``exp(A s) X`` with
``A X + X A' + b_k b_l' = 0``.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from jounce.core.errors import SimulationError
from jounce.core.types import Array
from jounce.ride.family import Matrices

_NOTHING = 1e-9
"""What is left of a sum of terms is nothing below this share of their sizes."""
_DEFECTIVE = 1e5  # condition of the eigenvectors beyond which they are not used
_BEGINS = 1e-5  # the same of slopes, which may be differences
WANDERS = "follows the height of the road, which wanders without limit under white noise"
KICKED = "feels the road's vertical velocity directly, whose variance is infinite under white noise"


@dataclass(frozen=True)
class Relative:
    """Linear model with states relative to the quasi-static motion: ``dx/dt = A x + b v``, ``y = C x + d z + f v``.

    ``z`` are the heights of the wheels' road (m), ``v`` their rates. Also used for the slopes of all that.

    Attributes
    ----------
    A, C : ndarray, shape (n, n) and (outputs, n)
        States and outputs.
    b : ndarray, shape (n, wheels)
        Drive by the rates.
    d, f : ndarray, shape (outputs, wheels)
        Direct part of heights and rates.
    scale : ndarray, shape (outputs, wheels)
        Size of the terms that ``d`` is a sum of.
    E : ndarray, shape (n, wheels)
        Quasi-static motion.
    """

    A: Array
    C: Array
    b: Array
    d: Array
    f: Array
    scale: Array
    E: Array


def check_stable(a: Array) -> None:
    """Refuse a model that does not come to rest by itself."""
    values = np.linalg.eigvals(a)
    worst = values[np.argmax(values.real)]
    if worst.real > -1e-9 * float(np.max(np.abs(values), initial=1e-300)):
        raise SimulationError(
            "the linear model about rest is not asymptotically stable, so nothing is stationary",
            where="stationary response",
            found=f"eigenvalue {worst.real:.4g} {worst.imag:+.4g}j 1/s",
            allowed="negative real parts",
            hint="Is there a damper? Hysteresis and friction without a rate have no linear model that comes to rest.",
        )


def relative(model: Matrices) -> Relative:
    """Take the states relative to the quasi-static motion.

    Raises
    ------
    SimulationError
        For a model that is not asymptotically stable, or that feels the road's acceleration.
    """
    check_stable(model.A)
    if np.any(model.B[2:]) or np.any(model.D[2:]):
        raise SimulationError(
            "the model feels the acceleration of the road, as a wheel without a tyre does",
            where="stationary response",
            hint="Give the rig a tyre.",
        )
    e = -np.linalg.solve(model.A, model.B[0])
    d = model.C @ e + model.D[0]
    scale = np.abs(model.C) @ np.abs(e) + np.abs(model.D[0])
    return Relative(model.A, model.C, model.B[1] - e, d, model.D[1], scale, e)


def relative_slope(model: Matrices, whole: Relative, along: Matrices, size: float) -> Relative:
    """Slope of all that along a number of some ``size`` (in its SI unit), from the slope of the matrices."""
    e = -np.linalg.solve(model.A, along.B[0] + along.A @ whole.E)
    d = along.C @ whole.E + model.C @ e + along.D[0]
    sizes = np.abs(np.linalg.inv(model.A)) @ (np.abs(along.B[0]) + np.abs(along.A) @ np.abs(whole.E))
    scale = np.abs(along.C) @ np.abs(whole.E) + np.abs(model.C) @ sizes + np.abs(along.D[0])
    return Relative(along.A, along.C, along.B[1] - e, d, along.D[1], np.maximum(scale, whole.scale / size), e)


@dataclass(frozen=True)
class Group:
    """Wheels that one noise drives at one time: how much later than the first (s), and who they are."""

    delay: float
    wheels: tuple[int, ...]


Source = tuple[Group, ...]
"""One noise and its wheels, by rising delay."""


def sources_of(delays: Sequence[float], sides: Sequence[int], *, same: bool) -> tuple[Source, ...]:
    """Sort wheels by what drives them: one noise for all (``same``), or one for each side.

    Parameters
    ----------
    delays : sequence of float
        Of each wheel, s.
    sides : sequence of int
        1 left, -1 right, 0 in the middle.
    same : bool
        Whether left and right feel the same road.
    """
    found = []
    for side in (0,) if same else sorted(set(sides), reverse=True):
        members = [i for i in range(len(delays)) if same or sides[i] == side]
        times = sorted({delays[i] for i in members})
        found.append(tuple(Group(time, tuple(i for i in members if delays[i] == time)) for time in times))
    return tuple(found)


def _sum(terms: Iterable[Array]) -> Array:
    return np.asarray(np.sum(list(terms), axis=0), dtype=np.float64)


class Schur:
    """Lyapunov equations ``A X + X A' + Q = 0`` of one matrix (n, n), solved by its Schur form."""

    def __init__(self, a: Array) -> None:
        from scipy.linalg import schur

        self.form, self.basis = schur(a, output="real")

    def solve(self, q: Array) -> Array:
        """Give X for any Q (n, n)."""
        from scipy.linalg.lapack import dtrsyl

        inner = self.basis.T @ q @ self.basis
        found, scale, _ = dtrsyl(self.form, self.form, -inner, tranb="T")
        return np.asarray(scale * (self.basis @ found @ self.basis.T), dtype=np.float64)


class Flow:
    """Exponential of a matrix (n, n, in 1/s) over times, and its slopes, by eigenvectors where they are independent."""

    def __init__(self, a: Array) -> None:
        self.a = a
        self._values, self._vectors = np.linalg.eig(a)
        self._are_independent = bool(np.linalg.cond(self._vectors) < _DEFECTIVE)
        self._inverse = np.linalg.inv(self._vectors) if self._are_independent else self._vectors
        self._known: dict[float, Array] = {}

    def at(self, time: float) -> Array:
        """Flow over a time, s."""
        if time not in self._known:
            self._known[time] = self._exponential(time)
        return self._known[time]

    def _exponential(self, time: float) -> Array:
        if self._are_independent:
            return np.asarray(((self._vectors * np.exp(self._values * time)) @ self._inverse).real)
        from scipy.linalg import expm

        return np.asarray(expm(self.a * time), dtype=np.float64)

    def slope(self, time: float, along: Array) -> Array:
        """Slope of the flow over a time (s) along that of the matrix."""
        if time == 0.0:
            return np.zeros_like(self.a)
        if not self._are_independent:
            from scipy.linalg import expm_frechet

            return np.asarray(expm_frechet(self.a * time, along * time, compute_expm=False), dtype=np.float64)
        first, second = self._values[:, None] * time, self._values[None, :] * time
        half = 0.5 * (first - second)
        is_near = np.abs(half) < 1e-3
        safe = np.where(is_near, 1.0, half)
        steep = 1.0 + half**2 / 6.0 + half**4 / 120.0
        divided = np.where(
            is_near, np.exp(0.5 * (first + second)) * steep, (np.exp(first) - np.exp(second)) / (2.0 * safe)
        )
        inner = divided * (self._inverse @ along @ self._vectors) * time
        return np.asarray((self._vectors @ inner @ self._inverse).real)


@dataclass(frozen=True)
class Covariance:
    """Variances of the outputs of a relative model under unit white noise, and their slopes.

    Attributes
    ----------
    model : Relative
        The model.
    sources : tuple
        What drives which wheel when.
    """

    model: Relative
    sources: tuple[Source, ...]

    @cached_property
    def _schur(self) -> Schur:
        return Schur(self.model.A)

    def absent(self) -> dict[int, str]:
        """Outputs that have no stationary variance, with the reason."""
        model, found = self.model, {}
        size = np.abs(model.C) @ np.abs(model.b)
        for source in self.sources:
            wheels = [i for group in source for i in group.wheels]
            left = np.abs(model.d[:, wheels].sum(axis=1)) > _NOTHING * model.scale[:, wheels].sum(axis=1)
            kicked = np.zeros(len(left), dtype=bool)
            for group in source:
                chosen = list(group.wheels)
                kicked |= np.abs(model.f[:, chosen].sum(axis=1)) > _NOTHING * size[:, chosen].sum(axis=1)
            found.update(dict.fromkeys(map(int, np.flatnonzero(left)), WANDERS))
            found.update(dict.fromkeys(map(int, np.flatnonzero(kicked & ~left)), KICKED))
        return found

    def variances(self) -> Array:
        """Variance of each output for noise of intensity 1; without meaning for those that are absent."""
        total = np.zeros(len(self.model.C))
        for source in self.sources:
            state = self._state(source)
            total += np.einsum("ij,jk,ik->i", self.model.C, state, self.model.C)
            total += self._offset(source)
        return total

    def _state(self, source: Source) -> Array:
        """Covariance of the relative states."""
        drives = self._drives(source)
        found = self._schur.solve(_sum(np.outer(b, b) for _, b in drives))
        for i, (first, b) in enumerate(drives):
            for second, other in drives[i + 1 :]:
                cross = self._flow(second - first) @ self._schur.solve(np.outer(b, other))
                found = found + cross + cross.T
        return np.asarray(found)

    def _drives(self, source: Source) -> list[tuple[float, Array]]:
        return [(group.delay, self.model.b[:, list(group.wheels)].sum(axis=1)) for group in source]

    @cached_property
    def _flows(self) -> Flow:
        return Flow(self.model.A)

    def _flow(self, time: float) -> Array:
        return self._flows.at(time)

    def _steps(self, source: Source, d: Array) -> list[tuple[float, float, Array]]:
        """Between the delays: begin, end (s) and how far an output is moved by a unit step of the road meanwhile."""
        found, reached = [], np.zeros(len(d))
        for group, after in pairwise(source):
            reached = reached + d[:, list(group.wheels)].sum(axis=1)
            found.append((group.delay, after.delay, reached))
        return found

    def _reach(self, time: float) -> Array:
        """Integral of the flow from 0 to a time."""
        return np.asarray(np.linalg.solve(self.model.A, self._flow(time) - np.eye(len(self.model.A))), dtype=np.float64)

    def _offset(self, source: Source) -> Array:
        """What heights that differ between wheels add to the variances."""
        found = np.zeros(len(self.model.C))
        for begin, end, reached in self._steps(source, self.model.d):
            found += reached**2 * (end - begin)
            for delay, b in self._drives(source):
                if delay <= begin:
                    moved = (self._reach(end - delay) - self._reach(begin - delay)) @ b
                    found += 2.0 * reached * (self.model.C @ moved)
        return found

    def slopes(self, along: Relative, later: Array) -> Array:
        """Slope of the variances along a number: ``along`` of the model, ``later`` (wheels,) of the delays, s.

        What would begin to follow the road's height when the number moves has none: not a number.
        """
        total = np.zeros(len(self.model.C))
        for source in self.sources:
            state = self._state(source)
            change = self._state_slope(source, along, later)
            total += 2.0 * np.einsum("ij,jk,ik->i", along.C, state, self.model.C)
            total += np.einsum("ij,jk,ik->i", self.model.C, change, self.model.C)
            total += self._offset_slope(source, along, later)
            wheels = [i for group in source for i in group.wheels]
            begins = np.abs(along.d[:, wheels].sum(axis=1)) > _BEGINS * along.scale[:, wheels].sum(axis=1)
            total[begins] = np.nan
        return total

    def _moving(self, source: Source, along: Relative, later: Array) -> list[tuple[float, Array, float, Array]]:
        """Delay, drive, and the slopes of both for each group."""
        return [
            (time, b, float(later[group.wheels[0]]), along.b[:, list(group.wheels)].sum(axis=1))
            for (time, b), group in zip(self._drives(source), source, strict=True)
        ]

    def _solve_slope(self, solution: Array, noise: Array, along: Array) -> Array:
        """Slope of X with ``A X + X A' + Q = 0`` from those of Q and A."""
        return self._schur.solve(along @ solution + solution @ along.T + noise)

    def _state_slope(self, source: Source, along: Relative, later: Array) -> Array:
        groups = self._moving(source, along, later)
        own = self._schur.solve(_sum(np.outer(b, b) for _, b, _, _ in groups))
        found = self._solve_slope(own, _sum(np.outer(b, e) + np.outer(e, b) for _, b, _, e in groups), along.A)
        for i, (first, b, first_later, moved) in enumerate(groups):
            for second, other, second_later, other_moved in groups[i + 1 :]:
                x = self._schur.solve(np.outer(b, other))
                slope = self._solve_slope(x, np.outer(moved, other) + np.outer(b, other_moved), along.A)
                flow, flow_slope = self._flow_slope(second - first, second_later - first_later, along.A)
                cross = flow_slope @ x + flow @ slope
                found = found + cross + cross.T
        return np.asarray(found)

    def _flow_slope(self, time: float, later: float, along: Array) -> tuple[Array, Array]:
        """Flow over a time and its slope along a number that moves A and the time."""
        flow = self._flow(time)
        return flow, self._flows.slope(time, along) + self.model.A @ flow * later

    def _reach_slope(self, time: float, later: float, along: Array) -> tuple[Array, Array]:
        flow, slope = self._flow_slope(time, later, along)
        reach = np.linalg.solve(self.model.A, flow - np.eye(len(along)))
        moved = np.linalg.solve(self.model.A, slope - along @ reach)
        return np.asarray(reach, dtype=np.float64), np.asarray(moved, dtype=np.float64)

    def _offset_slope(self, source: Source, along: Relative, later: Array) -> Array:
        found, model = np.zeros(len(self.model.C)), self.model
        groups = self._moving(source, along, later)
        moved = self._steps(source, along.d)
        for i, (begin, end, reached) in enumerate(self._steps(source, model.d)):
            step, lengthening = moved[i][2], groups[i + 1][2] - groups[i][2]
            found += 2.0 * reached * step * (end - begin) + reached**2 * lengthening
            for delay, b, delayed, b_slope in groups[: i + 1]:
                late, late_slope = self._reach_slope(end - delay, groups[i + 1][2] - delayed, along.A)
                soon, soon_slope = self._reach_slope(begin - delay, groups[i][2] - delayed, along.A)
                path, path_slope = (late - soon) @ b, (late_slope - soon_slope) @ b + (late - soon) @ b_slope
                found += 2.0 * step * (model.C @ path)
                found += 2.0 * reached * (along.C @ path + model.C @ path_slope)
        return found


def with_cut_off(model: Matrices, rate: float) -> Matrices:
    """Model whose wheels' heights are states of their own: ``dz/dt = -rate z + w``, ``rate`` in 1/s.

    The result is driven by the noises ``w`` as others by the rates of heights; it has no quasi-static motion left.
    """
    n, wheels = model.B.shape[1:]
    a = np.block([[model.A, model.B[0] - rate * model.B[1]], [np.zeros((wheels, n)), -rate * np.eye(wheels)]])
    c = np.hstack([model.C, model.D[0] - rate * model.D[1]])
    b = np.stack([np.zeros((n + wheels, wheels)), np.vstack([model.B[1], np.eye(wheels)])])
    return Matrices(a, b, c, np.stack([np.zeros_like(model.D[0]), model.D[1]]), model.rest)


def cut_off_slope(along: Matrices, rate: float) -> Matrices:
    """Slope of that model, from the slope of the matrices; ``rate`` in 1/s."""
    found: dict[str, Any] = vars(with_cut_off(along, rate)).copy()
    n = len(along.A)
    found["A"] = found["A"].copy()
    found["A"][n:, n:] = 0.0
    found["B"] = found["B"].copy()
    found["B"][1, n:] = 0.0
    return Matrices(**found)
