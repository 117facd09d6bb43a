"""Exact covariances, and their slopes, of linear models under white noise with delays between wheels.

The height of a road with white-noise velocity is unbounded, so states are taken relative to the quasi-static
response of the model: ``x_rel = x - E z`` with ``A E + B0 = 0``. Then ``dx_rel/dt = A x_rel +
(B1 - E) dz/dt``, and an output is stationary exactly if the remainder of ``C E + D0`` sums to zero over the wheels
that one noise drives. Wheel ``l`` follows wheel ``k`` by ``s``: their cross term is ``exp(A s) X`` with
``A X + X A' + b_k b_l' = 0``.

All functions work on many stacked models, such as the samples of a distribution: members are the first axis of
arrays; slopes have the parameters as second axis. Models are small; a Python loop would take far longer than their
arithmetic.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import pairwise
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import SimulationError
from jounce.core.types import Array, Complex
from jounce.ride.family import (
    Eigen,
    Families,
    LinearModels,
    Matrices,
    has_neutral,
    side_by_side,
    without_unreached,
)
from jounce.ride.surface import Surface

# white noise ----------------------------------------------------------------------------------------------------------


_NOTHING = 1e-9
"""Relative size below which a sum of terms is considered zero: above rounding, below any real remainder."""
_BEGINS = 1e-5  # same tolerance for slopes, which may be finite differences
WANDERS = "follows the height of the road, which wanders without limit under white noise"
KICKED = "feels the road's vertical velocity directly, whose variance is infinite under white noise"


@dataclass(frozen=True)
class Relative:
    """Linear models with states relative to the quasi-static response: ``dx/dt = A x + b v``, ``y = C x + d z + f v``.

    ``z`` are the heights of the road under the wheels (m), ``v`` their rates; ``E`` is the quasi-static response, shape
    (members, n, wheels), and ``scale`` the size of the terms that sum to ``d``. The class also holds slopes of all
    these, with the parameters as second axis.
    """

    A: Array
    C: Array
    b: Array
    d: Array
    f: Array
    scale: Array
    E: Array


def check_stable(values: Complex) -> None:
    """Raise an error for models that are not asymptotically stable, by their eigenvalues (..., n) in 1/s."""
    grows = np.max(values.real, axis=-1) > -1e-9 * np.max(
        np.abs(values), axis=-1, initial=1e-300
    )  # above rounding
    if np.any(grows):
        unstable = values[grows][0]
        worst = unstable[np.argmax(unstable.real)]
        raise SimulationError(
            "the linear model about rest is not asymptotically stable, so there is no stationary response",
            where="stationary response",
            found=f"eigenvalue {worst.real:.4g} {worst.imag:+.4g}j 1/s",
            allowed="negative real parts",
            hint="Does the rig have a damper? The linear model of hysteresis or friction alone does not come to rest.",
        )


def relative(model: Matrices, values: Complex) -> Relative:
    """Transform states relative to the quasi-static response; reject models that depend on the road's acceleration.

    ``values`` are the eigenvalues of the models, 1/s.
    """
    check_stable(values)
    if np.any(model.B[..., 2:, :, :]) or np.any(model.D[..., 2:, :, :]):
        raise SimulationError(
            "the model depends on the acceleration of the road, like a wheel without a tyre",
            where="stationary response",
            hint="Add a tyre to the rig.",
        )
    b, d = (np.moveaxis(part, -3, 0) for part in (model.B, model.D))
    e = -np.linalg.solve(model.A, b[0])
    scale = np.abs(model.C) @ np.abs(e) + np.abs(d[0])
    return Relative(model.A, model.C, b[1] - e, model.C @ e + d[0], d[1], scale, e)


def relative_slopes(model: Matrices, whole: Relative, along: Matrices, sizes: Array) -> Relative:
    """Slopes of a relative model along parameters of some ``sizes`` (members, parameters; SI), from matrix slopes."""
    b, d = (np.moveaxis(part, -3, 0) for part in (along.B, along.D))
    a, c, still = model.A[:, None], model.C[:, None], whole.E[:, None]
    e = -np.linalg.solve(a, b[0] + along.A @ still)
    left = along.C @ still + c @ e + d[0]
    response_sizes = np.abs(np.linalg.inv(a)) @ (np.abs(b[0]) + np.abs(along.A) @ np.abs(still))
    scale = np.abs(along.C) @ np.abs(still) + np.abs(c) @ response_sizes + np.abs(d[0])
    scale = np.maximum(scale, whole.scale[:, None] / sizes[:, :, None, None])
    return Relative(along.A, along.C, b[1] - e, left, d[1], scale, e)


@dataclass(frozen=True)
class WheelGroup:
    """Wheels driven by one noise at the same time, and their delay after the first (s, per member)."""

    delay: Array
    wheels: tuple[int, ...]


Number = TypeVar("Number", np.float64, np.complex128)
Source = tuple[WheelGroup, ...]
"""One noise source: groups of wheels in order of increasing delay."""


def sources_of(delays: Array, sides: Sequence[int], *, same: bool) -> tuple[Source, ...] | None:
    """Group wheels by noise source: one for all (``same``), or one per side (1 left, -1 right).

    ``delays`` (members, wheels) are in s. Returns None if members differ in the order of the wheels
    or in the wheels that share a delay.
    """
    sources = []
    for side in (0,) if same else sorted(set(sides), reverse=True):
        members = [i for i in range(len(sides)) if same or sides[i] == side]
        times = sorted({float(delays[0, i]) for i in members})
        groups = [tuple(i for i in members if delays[0, i] == time) for time in times]
        firsts = delays[:, [wheels[0] for wheels in groups]]
        if np.any(np.diff(firsts, axis=1) <= 0.0):
            return None
        if any(np.any(delays[:, list(wheels)] != delays[:, [wheels[0]]]) for wheels in groups):
            return None
        sources.append(tuple(WheelGroup(firsts[:, k], wheels) for k, wheels in enumerate(groups)))
    return tuple(sources)


def _sum_groups(table: Array, source: Source) -> Array:
    """Sum columns (..., wheels) over the wheels of each group; shape (..., groups)."""
    return np.stack([table[..., list(group.wheels)].sum(axis=-1) for group in source], axis=-1)


def _outer(first: Array, second: Array) -> Array:
    return np.asarray(first[..., :, None] * second[..., None, :])


def _transpose(matrices: NDArray[Number]) -> NDArray[Number]:
    return np.swapaxes(matrices, -1, -2)


class Lyapunov:
    """Equations ``A X + X A' + Q = 0`` of matrices (members, n, n): by eigenvectors, or by Schur forms without them."""

    def __init__(self, a: Array, eigen: Eigen) -> None:
        self.a, self.eigen = a, eigen
        self._sums = eigen.values[:, :, None] + eigen.values[:, None, :]
        self._schur: dict[int, tuple[Array, Array]] = {}

    def solve(self, q: Array) -> Array:
        """Return X for any Q (members, n, n), or (members, parameters, n, n)."""
        solution = self._by_eigenvectors(q)
        a = self._beside(self.a, q)
        residual = a @ solution + solution @ _transpose(a) + q
        solution = solution + self._by_eigenvectors(
            residual
        )  # one refinement removes the rounding of the eigenvectors
        for k in np.flatnonzero(~self.eigen.is_sound):
            for place in np.ndindex(q.shape[1:-2]):
                solution[(k, *place)] = self._by_schur(int(k), q[(k, *place)])
        return solution

    def _beside(self, part: Any, q: Array) -> Any:
        return part if q.ndim == self.a.ndim else part[:, None]

    def _by_eigenvectors(self, q: Array) -> Array:
        vectors, inverse, sums = (
            self._beside(part, q) for part in (self.eigen.vectors, self.eigen.inverse, self._sums)
        )
        inner = inverse @ q @ _transpose(inverse)
        return np.asarray((vectors @ (-inner / sums) @ _transpose(vectors)).real)

    def _by_schur(self, k: int, q: Array) -> Array:
        from scipy.linalg import schur
        from scipy.linalg.lapack import dtrsyl

        if k not in self._schur:
            self._schur[k] = schur(self.a[k], output="real")
        form, basis = self._schur[k]
        solution, scale, _ = dtrsyl(form, form, -(basis.T @ q @ basis), tranb="T")
        return np.asarray(scale * (basis @ solution @ basis.T), dtype=np.float64)


class Flow:
    """Exponentials of matrices (members, n, n; 1/s) over times, and their slopes: by eigenvectors if sound."""

    def __init__(self, a: Array, eigen: Eigen) -> None:
        self.a, self.eigen = a, eigen

    def at(self, time: Array) -> Array:
        """Return the flow over the time of each member, s."""
        eigen = self.eigen
        exponentials = np.exp(eigen.values * time[:, None])
        flow = np.asarray(((eigen.vectors * exponentials[:, None, :]) @ eigen.inverse).real)
        for k in np.flatnonzero(~eigen.is_sound):
            from scipy.linalg import expm

            flow[k] = expm(self.a[k] * time[k])
        return flow

    def slopes(self, time: Array, along: Array) -> Array:
        """Return slopes of the flow over each member's time (s), from matrix slopes (members, numbers, n, n)."""
        eigen = self.eigen
        scaled = eigen.values * time[:, None]
        first, second = scaled[:, :, None], scaled[:, None, :]
        half = 0.5 * (first - second)
        is_near = np.abs(half) < 1e-3  # the next term of the series, half^6 / 5040, is below 1e-21
        safe = np.where(is_near, 1.0, half)
        sinh_over_half = 1.0 + half**2 / 6.0 + half**4 / 120.0
        divided = np.where(
            is_near,
            np.exp(0.5 * (first + second)) * sinh_over_half,
            (np.exp(first) - np.exp(second)) / (2.0 * safe),
        )
        vectors, inverse = eigen.vectors[:, None], eigen.inverse[:, None]
        inner = (divided * time[:, None, None])[:, None] * (inverse @ along @ vectors)
        slopes = np.asarray((vectors @ inner @ inverse).real)
        for k in np.flatnonzero(~eigen.is_sound):
            from scipy.linalg import expm_frechet

            for i, part in enumerate(along[k]):
                slopes[k, i] = expm_frechet(self.a[k] * time[k], part * time[k], compute_expm=False)
        return slopes


@dataclass(frozen=True)
class Covariance:
    """Variances of the outputs of relative models under unit white noise, and their slopes."""

    model: Relative
    eigen: Eigen
    sources: tuple[Source, ...]

    @cached_property
    def _lyapunov(self) -> Lyapunov:
        return Lyapunov(self.model.A, self.eigen)

    @cached_property
    def _flows(self) -> Flow:
        return Flow(self.model.A, self.eigen)

    def absent(self) -> dict[int, str]:
        """Return outputs without a stationary variance in some member, with the reason."""
        model, reasons = self.model, {}
        size = np.abs(model.C) @ np.abs(model.b)
        for source in self.sources:
            wheels = [i for group in source for i in group.wheels]
            wanders = np.abs(model.d[..., wheels].sum(axis=-1)) > _NOTHING * model.scale[
                ..., wheels
            ].sum(axis=-1)
            kicked = np.any(
                np.abs(_sum_groups(model.f, source)) > _NOTHING * _sum_groups(size, source), axis=-1
            )
            wanders, kicked = wanders.any(axis=0), kicked.any(axis=0)
            reasons.update(dict.fromkeys(map(int, np.flatnonzero(wanders)), WANDERS))
            reasons.update(dict.fromkeys(map(int, np.flatnonzero(kicked & ~wanders)), KICKED))
        return reasons

    def variances(self) -> Array:
        """Return the variance of each output (members, outputs) for unit noise; meaningless for absent outputs."""
        total = np.zeros(self.model.C.shape[:-1])
        for i, source in enumerate(self.sources):
            total += np.einsum("sij,sjk,sik->si", self.model.C, self._states[i], self.model.C)
            total += self._offset(source)
        return total

    @cached_property
    def _states(self) -> list[Array]:
        """Covariance of the relative states, for each source."""
        return [self._state(source) for source in self.sources]

    def _state(self, source: Source) -> Array:
        drives = self._drives(source)
        covariance = self._lyapunov.solve(_sum(_outer(b, b) for _, b in drives))
        for i, (delay, b) in enumerate(drives):
            for later_delay, later_b in drives[i + 1 :]:
                cross = self._flows.at(later_delay - delay) @ self._lyapunov.solve(
                    _outer(b, later_b)
                )
                covariance = covariance + cross + _transpose(cross)
        return np.asarray(covariance)

    def _drives(self, source: Source) -> list[tuple[Array, Array]]:
        return [
            (group.delay, self.model.b[..., list(group.wheels)].sum(axis=-1)) for group in source
        ]

    def _steps(self, source: Source, d: Array) -> list[tuple[Array, Array, Array]]:
        """Return intervals between delays: start, end (s), and each output's step up to then for a unit road step."""
        intervals, reached = [], np.zeros(d.shape[:-1])
        for group, after in pairwise(source):
            reached = reached + d[..., list(group.wheels)].sum(axis=-1)
            intervals.append((group.delay, after.delay, reached))
        return intervals

    def _reach(self, time: Array) -> Array:
        """Integrate the flow from 0 to a time."""
        a = self.model.A
        return np.asarray(
            np.linalg.solve(a, self._flows.at(time) - np.eye(a.shape[-1])), dtype=np.float64
        )

    def _offset(self, source: Source) -> Array:
        """Return the variance due to height differences between wheels."""
        variance = np.zeros(self.model.C.shape[:-1])
        for begin, end, reached in self._steps(source, self.model.d):
            variance += reached**2 * (end - begin)[:, None]
            for delay, b in self._drives(source):
                if delay[0] <= begin[0]:
                    response = (self._reach(end - delay) - self._reach(begin - delay)) @ b[
                        :, :, None
                    ]
                    variance += 2.0 * reached * (self.model.C @ response)[:, :, 0]
        return variance

    def slopes(self, along: Relative, later: Array) -> Array:
        """Return slopes (members, parameters, outputs) of the variances from those of model and delays (``later``, s).

        ``later`` has the shape (members, parameters, wheels). The slope is NaN for an output that would start to follow
        the road's height if the parameter changed.
        """
        total = np.zeros(along.C.shape[:-1])
        for i, source in enumerate(self.sources):
            change = self._state_slopes(source, along, later)
            total += 2.0 * np.einsum("snij,sjk,sik->sni", along.C, self._states[i], self.model.C)
            total += np.einsum("sij,snjk,sik->sni", self.model.C, change, self.model.C)
            total += self._offset_slopes(source, along, later)
            wheels = [i for group in source for i in group.wheels]
            begins = np.abs(along.d[..., wheels].sum(axis=-1)) > _BEGINS * along.scale[
                ..., wheels
            ].sum(axis=-1)
            total[begins] = np.nan
        return total

    def _moving(
        self, source: Source, along: Relative, later: Array
    ) -> list[tuple[Array, Array, Array, Array]]:
        """Yield delay and drive of each group, and their slopes."""
        return [
            (time, b, later[..., group.wheels[0]], along.b[..., list(group.wheels)].sum(axis=-1))
            for (time, b), group in zip(self._drives(source), source, strict=True)
        ]

    def _solve_slopes(self, solution: Array, noise: Array, along: Array) -> Array:
        """Slopes of X with ``A X + X A' + Q = 0`` from those of Q and A."""
        whole = solution[:, None]
        return self._lyapunov.solve(along @ whole + whole @ _transpose(along) + noise)

    def _state_slopes(self, source: Source, along: Relative, later: Array) -> Array:
        groups = self._moving(source, along, later)
        own = self._lyapunov.solve(_sum(_outer(b, b) for _, b, _, _ in groups))
        noise = _sum(_outer(b[:, None], e) + _outer(e, b[:, None]) for _, b, _, e in groups)
        total = self._solve_slopes(own, noise, along.A)
        for i, (first, b, first_later, b_slopes) in enumerate(groups):
            for second, later_b, second_later, later_b_slopes in groups[i + 1 :]:
                x = self._lyapunov.solve(_outer(b, later_b))
                noise = _outer(b_slopes, later_b[:, None]) + _outer(b[:, None], later_b_slopes)
                slopes = self._solve_slopes(x, noise, along.A)
                flow, flow_slopes = self._flow_slopes(
                    second - first, second_later - first_later, along.A
                )
                cross = flow_slopes @ x[:, None] + flow[:, None] @ slopes
                total = total + cross + _transpose(cross)
        return np.asarray(total)

    def _flow_slopes(self, time: Array, later: Array, along: Array) -> tuple[Array, Array]:
        """Flow over a time and its slopes along parameters that change A and the time."""
        flow = self._flows.at(time)
        return flow, self._flows.slopes(time, along) + (self.model.A @ flow)[:, None] * later[
            :, :, None, None
        ]

    def _reach_slopes(self, time: Array, later: Array, along: Array) -> tuple[Array, Array]:
        flow, slopes = self._flow_slopes(time, later, along)
        a = self.model.A
        reach = np.linalg.solve(a, flow - np.eye(a.shape[-1]))
        reach_slopes = np.linalg.solve(a[:, None], slopes - along @ reach[:, None])
        return np.asarray(reach, dtype=np.float64), np.asarray(reach_slopes, dtype=np.float64)

    def _offset_slopes(self, source: Source, along: Relative, later: Array) -> Array:
        total, model = np.zeros(along.C.shape[:-1]), self.model
        groups = self._moving(source, along, later)
        step_slopes = self._steps(source, along.d)
        for i, (begin, end, before) in enumerate(self._steps(source, model.d)):
            step, lengthening, reached = (
                step_slopes[i][2],
                groups[i + 1][2] - groups[i][2],
                before[:, None],
            )
            total += (
                2.0 * reached * step * (end - begin)[:, None, None]
                + reached**2 * lengthening[:, :, None]
            )
            for delay, b, delayed, b_slopes in groups[: i + 1]:
                late, late_slopes = self._reach_slopes(
                    end - delay, groups[i + 1][2] - delayed, along.A
                )
                soon, soon_slopes = self._reach_slopes(
                    begin - delay, groups[i][2] - delayed, along.A
                )
                reach = (late - soon)[:, None]
                path = (late - soon) @ b[:, :, None]
                path_slopes = (late_slopes - soon_slopes) @ b[:, None, :, None] + reach @ b_slopes[
                    ..., None
                ]
                total += 2.0 * step * (model.C @ path)[:, None, :, 0]
                total += (
                    2.0
                    * reached
                    * (along.C @ path[:, None] + model.C[:, None] @ path_slopes)[..., 0]
                )
        return total


def _sum(terms: Iterable[Array]) -> Array:
    return np.asarray(np.sum(list(terms), axis=0), dtype=np.float64)


def with_cut_off(model: Matrices, rate: float) -> Matrices:
    """Add the road heights under the wheels as states: ``dz/dt = -rate z + w``, ``rate`` in 1/s.

    The noises ``w`` drive the resulting model as height rates drive other models. It has no quasi-static response.
    """
    b, d = (np.moveaxis(part, -3, 0) for part in (model.B, model.D))
    *stack, n, wheels = b.shape[1:]
    zero, identity = (
        np.zeros((*stack, wheels, n)),
        np.broadcast_to(np.eye(wheels), (*stack, wheels, wheels)),
    )
    a = np.block([[model.A, b[0] - rate * b[1]], [zero, -rate * identity]])
    c = np.concatenate([model.C, d[0] - rate * d[1]], axis=-1)
    inputs = np.concatenate([b[1], identity], axis=-2)
    pushes = np.stack([np.zeros_like(inputs), inputs], axis=-3)
    return Matrices(a, pushes, c, np.stack([np.zeros_like(d[0]), d[1]], axis=-3), model.static)


def cut_off_slopes(along: Matrices, rate: float) -> Matrices:
    """Slopes of the models of ``with_cut_off``, from the slopes of the matrices; ``rate`` in 1/s."""
    slopes = with_cut_off(along, rate)
    n = along.A.shape[-1]
    slopes.A[..., n:, n:] = 0.0
    slopes.B[..., 1, n:, :] = 0.0
    return slopes


# a band of frequencies ------------------------------------------------------------------------------------------------


# Four times as many panels change standard deviations of kart, half and full car on class D by less than 1e-12.
_PANELS = 12  # a decade
_POINTS = 8  # Gauss-Legendre points of a panel
_NEAR = np.array([0.4 * 2.5**k for k in range(9)])  # half widths of a resonance at which panels end
_FAR = 0.3  # share of its frequency beyond which a resonance needs no additional panels
_PERIODS = 0.4  # maximum number of wave periods between front and rear per panel
_SMALL = 16_000  # terms per product: BLAS computes small products on one core, which is faster than several


@cache
def _gauss() -> tuple[Array, Array]:
    """Return points and weights of a panel on -1 to 1."""
    points, weights = np.polynomial.legendre.leggauss(_POINTS)
    return points, weights


def frequencies(low: float, high: float, values: Complex, delay: Array) -> tuple[Array, Array]:
    """Return nodes and weights (Hz) of a quadrature that resolves the models' resonances and longest delays (s).

    The eigenvalues (members, n) are in 1/s; nodes and weights have the shape (members, nodes). Members that need fewer
    nodes get extra nodes of zero weight at the end of the band.
    """
    count = max(1, int(np.ceil(_PANELS * np.log10(high / low))))
    middle, width = np.abs(values.imag) / (2.0 * np.pi), np.abs(values.real) / (2.0 * np.pi)
    reach = _NEAR * width[:, :, None]
    is_needed = (values.imag > 0.0)[:, :, None] & (reach < _FAR * middle[:, :, None])
    extra = np.concatenate([middle[:, :, None] - reach, middle[:, :, None] + reach], axis=2)
    is_needed = np.concatenate([is_needed, is_needed], axis=2) & (extra > low) & (extra < high)
    extra = np.where(is_needed, extra, high).reshape(len(values), -1)
    most_extra = int(np.max(np.count_nonzero(extra < high, axis=1), initial=0))
    common = np.geomspace(low, high, count + 1)
    edges = np.sort(
        np.concatenate(
            [np.tile(common, (len(values), 1)), np.sort(extra, axis=1)[:, :most_extra]], axis=1
        )
    )
    if np.any(delay > 0.0):
        edges = _subdivide(edges, delay)
    points, weights = _gauss()
    half, middle_of = 0.5 * np.diff(edges), 0.5 * (edges[:, 1:] + edges[:, :-1])
    nodes = middle_of[:, :, None] + half[:, :, None] * points
    return nodes.reshape(len(values), -1), (half[:, :, None] * weights).reshape(len(values), -1)


def _subdivide(edges: Array, delay: Array) -> Array:
    """Split panels until each contains only a few waves of the longest delay; other members repeat the last edge."""
    lengths = np.diff(edges)
    parts = np.maximum(1, np.ceil(lengths * delay[:, None] / _PERIODS).astype(int))
    counts = parts.sum(axis=1)
    flat = parts.ravel()
    first, width = np.repeat(edges[:, :-1].ravel(), flat), np.repeat(lengths.ravel() / flat, flat)
    place = np.arange(len(first)) - np.repeat(np.cumsum(flat) - flat, flat)
    finer = np.tile(edges[:, -1:], (1, int(counts.max()) + 1))
    member = np.repeat(np.arange(len(edges)), counts)
    finer[member, np.arange(len(first)) - np.repeat(np.cumsum(counts) - counts, counts)] = (
        first + place * width
    )
    return finer


class Inverse:
    """``(s - A)^-1`` of models at frequencies (members, f; rad/s times i): by eigenvectors if these are sound."""

    def __init__(self, a: Array, eigen: Eigen, s: Complex) -> None:
        self.a, self.eigen, self.s = a, eigen, s
        self._shares = 1.0 / (s[:, None, :] - eigen.values[:, :, None])

    def times(self, b: Array) -> Complex:
        """Inverse times vectors b, shape (members, n): shape (members, n, f)."""
        modal = self._shares * (self.eigen.inverse @ b[:, :, None])
        product = _in_parts(self.eigen.vectors, modal)
        for k in np.flatnonzero(~self.eigen.is_sound):
            product[k] = np.linalg.solve(self._shift(int(k)), b[k][:, None])[:, :, 0].T
        return np.asarray(product)

    def before(self, c: Array) -> Complex:
        """C, shape (members, m, n), times the inverse: shape (members, m, n, f)."""
        modal = (c @ self.eigen.vectors)[:, :, :, None] * self._shares[:, None]
        product = _in_parts(_transpose(self.eigen.inverse)[:, None], modal)
        for k in np.flatnonzero(~self.eigen.is_sound):
            product[k] = np.moveaxis(
                np.linalg.solve(_transpose(self._shift(int(k))), c[k].T), (0, 2), (2, 0)
            )
        return np.asarray(product)

    def _shift(self, k: int) -> Complex:
        return np.asarray(self.s[k][:, None, None] * np.eye(self.a.shape[-1]) - self.a[k])


@dataclass(frozen=True)
class _VarianceSlopes:
    """Slopes of the variances by A (members, outputs, n, n), b, C, d, f and the delays of one source."""

    matrix: Array
    drive: Array
    state: Array
    height: Array
    rate: Array
    delay: Array


@dataclass(frozen=True)
class RoadExcitation:
    """Excitation of the wheels at given frequencies (members, f).

    ``power`` is the density of the road's height times the node weight (m^2). ``gain`` is the squared magnitude of each
    output's weighting, shape (members, outputs, f), None for 1. ``coherence`` is the root of the coherence of the left
    and right sources, None for independent sources.
    """

    frequency: Array
    power: Array
    gain: Array | None = None
    coherence: Array | None = None


@dataclass(frozen=True)
class BandVariance:
    """Variances of the outputs of relative models over a band, and their slopes."""

    model: Relative
    eigen: Eigen
    sources: tuple[Source, ...]
    band: RoadExcitation

    @cached_property
    def _s(self) -> Complex:
        return np.asarray(2j * np.pi * self.band.frequency)

    @cached_property
    def _inverse(self) -> Inverse:
        return Inverse(self.model.A, self.eigen, self._s)

    @cached_property
    def _waves(self) -> list[Complex]:
        """Phase of each group, for each source: shape (members, groups, f)."""
        delays = [np.stack([group.delay for group in source], axis=1) for source in self.sources]
        return [
            np.asarray(np.exp(-self._s[:, None, :] * delay[:, :, None]))
            if delay.any()
            else np.ones((*delay.shape, self._s.shape[1]), dtype=complex)
            for delay in delays
        ]

    @cached_property
    def _states(self) -> list[list[Complex]]:
        """States for a unit rate of the road, for each source and group: shape (members, n, f)."""
        return [
            [self._inverse.times(b) for b in _groups(self.model.b, source)]
            for source in self.sources
        ]

    @cached_property
    def _by_group(self) -> list[list[Complex]]:
        """Response to unit height of each group: shape (members, outputs, f)."""
        responses = []
        for source, states, waves in zip(self.sources, self._states, self._waves, strict=True):
            d, f = _groups(self.model.d, source), _groups(self.model.f, source)
            responses.append(
                [
                    (
                        (_in_parts(self.model.C, states[g]) + f[g][:, :, None])
                        * self._s[:, None, :]
                        + d[g][:, :, None]
                    )
                    * waves[:, g, None, :]
                    for g in range(len(source))
                ]
            )
        return responses

    @cached_property
    def _responses(self) -> list[Complex]:
        """Response of each output to each source, shape (members, outputs, f)."""
        return [np.asarray(sum(part[1:], start=part[0])) for part in self._by_group]

    @cached_property
    def _weights(self) -> Array:
        """Weight of a squared response, shape (members, outputs or 1, f)."""
        power = self.band.power[:, None, :]
        return np.asarray(power if self.band.gain is None else power * self.band.gain)

    def shares(self) -> Array:
        """Contribution of each frequency to the variance of each output, in the square of its SI unit."""
        power = sum(part.real**2 + part.imag**2 for part in self._responses)
        if self.band.coherence is not None:
            power = power + 2.0 * self.band.coherence[:, None, :] * self._cross_power()
        return np.asarray(power * self._weights)

    def variances(self) -> Array:
        """Variance of each output (members, outputs), in the square of its SI unit."""
        return np.asarray(np.sum(self.shares(), axis=-1))

    def _cross_power(self) -> Array:
        left, right = self._responses
        return np.asarray((left * right.conj()).real)

    @cached_property
    def _pulls(self) -> list[_VarianceSlopes]:
        """Slopes of the variances by the parts of the models per source, computed once for all parameters."""
        modal = self._inverse.before(self.model.C)
        return [self._pull(i, modal) for i in range(len(self.sources))]

    def _pull(self, i: int, modal: Complex) -> _VarianceSlopes:
        answer = self._responses[i].conj()
        if self.band.coherence is not None:
            answer = answer + self.band.coherence[:, None, :] * self._responses[1 - i].conj()
        answer = 2.0 * answer * self._weights
        waves, n = self._waves[i], self.model.A.shape[-1]
        rates = waves * self._s[:, None, :]
        state = sum(states * rates[:, g, None, :] for g, states in enumerate(self._states[i]))
        late = np.stack(
            [
                np.sum(answer * self._s[:, None, :] * part, axis=2).real
                for part in self._by_group[i]
            ],
            -1,
        )
        driven = np.concatenate([state, rates], axis=1)
        inner = _summed_products(modal * answer[:, :, None, :], driven[:, None])
        outer = _summed_products(answer, np.concatenate([driven, waves], axis=1))
        end = driven.shape[1]
        return _VarianceSlopes(
            inner[..., :n],
            inner[..., n:],
            outer[..., :n],
            outer[..., end:],
            outer[..., n:end],
            late,
        )

    def slopes(self, along: Relative, later: Array, coherence: Array | None = None) -> Array:
        """Return slopes (members, parameters, outputs) of the variances, from those of models, delays and coherence.

        ``later`` are those of the delays (members, parameters, wheels), s; ``coherence`` (members, parameters, f).
        """
        total = np.zeros(along.C.shape[:-1])
        for source, pull in zip(self.sources, self._pulls, strict=True):
            late = np.stack([later[..., group.wheels[0]] for group in source], axis=-1)
            total += np.einsum("srji,snji->snr", pull.matrix, along.A)
            total += np.einsum("srjg,snjg->snr", pull.drive, _sum_groups(along.b, source))
            total += np.einsum("srj,snrj->snr", pull.state, along.C) - np.einsum(
                "srg,sng->snr", pull.delay, late
            )
            total += np.einsum("srg,snrg->snr", pull.height, _sum_groups(along.d, source))
            total += np.einsum("srg,snrg->snr", pull.rate, _sum_groups(along.f, source))
        if coherence is not None:
            total += np.einsum("snf,srf->snr", 2.0 * coherence, self._cross_power() * self._weights)
        return total


def _groups(table: Array, source: Source) -> list[Array]:
    """Sum columns over the wheels of each group; one array (members, ...) per group."""
    return [table[..., list(group.wheels)].sum(axis=-1) for group in source]


def _in_parts(left: Array | Complex, right: Complex) -> Complex:
    """Multiply matrices (..., i, j) by many columns (..., j, f), in blocks of columns."""
    rows, inner = left.shape[-2:]
    step = max(8, _SMALL // (rows * inner))
    if step >= right.shape[-1]:
        return np.asarray(left @ right)
    product = np.empty((*right.shape[:-2], rows, right.shape[-1]), dtype=complex)
    for first in range(0, right.shape[-1], step):
        np.matmul(left, right[..., first : first + step], out=product[..., first : first + step])
    return product


def _summed_products(left: Complex, right: Complex) -> Array:
    """Return the real part of the sums over f of left (..., i, f) times right (..., j, f): shape (..., i, j)."""
    total: Array = np.zeros((*left.shape[:-1], right.shape[-2]))
    step = max(8, _SMALL // (left.shape[-2] * right.shape[-2]))
    for first in range(0, left.shape[-1], step):
        part = slice(first, first + step)
        total += (left[..., part] @ _transpose(right[..., part])).real
    return total


def longest_delay(sources: Sequence[Source]) -> Array:
    """Return the longest delay (s) of each member between wheels driven by one source."""
    return np.asarray(np.max([source[-1].delay - source[0].delay for source in sources], axis=0))


# variances of the signals of rigs -------------------------------------------------------------------------------------


Gain = Callable[[Array], Array]
"""Magnitude (1) of a weighting at frequencies (Hz)."""
_TRACK_STEP = 1e-4  # relative step of the finite difference for the slope of a coherence: truncation error 1e-8
_AT_ONCE = (
    256  # members times states times signals: larger blocks no longer fit the processor's cache
)


@dataclass(frozen=True)
class Signal:
    """A channel by its output index, with an optional frequency weighting."""

    output: int
    gain: Gain | None = None


@dataclass(frozen=True)
class Moments:
    """Variances and static values of signals, SI, (members, signals), and their slopes, (members, parameters, signals).

    ``absent`` gives the reason for signals without a stationary variance; ``linear`` holds the linear models with all
    their outputs and, if requested, their slopes.
    """

    variances: Array
    static: Array
    variance_slopes: Array
    static_slopes: Array
    absent: dict[int, str]
    linear: LinearModels


@dataclass(frozen=True)
class RandomVibration:
    """Random vibration of stacked rigs on one road; a weighted signal needs a surface with a band."""

    families: Families
    surface: Surface
    signals: tuple[Signal, ...]

    def at(self, values: Array | None = None, *, slopes: bool = True) -> Moments:
        """Compute variances at values (members, parameters; SI), by default those of the rigs."""
        point = self.families.start if values is None else np.asarray(values, dtype=float)
        linear = self.families.at(point, slopes=slopes)
        step = max(1, _AT_ONCE // max(1, linear.model.A.shape[-1] * len(self.signals)))
        groups = [slice(first, first + step) for first in range(0, len(point), step)]
        parts = [part for group in groups for part in self._members(linear, point, group)]
        absent = {i: reason for _, _, reasons in parts for i, reason in reasons.items()}
        rows = [signal.output for signal in self.signals]
        return Moments(
            np.concatenate([variances for variances, _, _ in parts]),
            linear.model.static[..., rows],
            np.concatenate([variance_slopes for _, variance_slopes, _ in parts]),
            linear.along.static[..., rows],
            absent,
            linear,
        )

    def _members(
        self, linear: LinearModels, values: Array, group: slice
    ) -> list[tuple[Array, Array, dict[int, str]]]:
        """Compute variances, slopes and absent signals of some members, jointly or individually if they differ."""
        sources = self._sources(values, group)
        count = len(values[group])
        if count > 1 and (sources is None or has_neutral(linear.eigen.values[group])):
            places = range(group.start, group.start + count)
            return [part for k in places for part in self._members(linear, values, slice(k, k + 1))]
        assert sources is not None
        rows = [signal.output for signal in self.signals]
        model, along = linear.model[group].of_rows(rows), linear.along[group].of_rows(rows)
        eigen = linear.eigen.of(group)
        if has_neutral(eigen.values):
            reduced, reduced_along = without_unreached(model[0], along[0])
            model, along, eigen = (
                side_by_side([reduced]),
                side_by_side([reduced_along]),
                Eigen(reduced.A[None]),
            )
        part = _Part(self, model, along, eigen, sources, values, group)
        return [part.white() if self.surface.band is None else part.over_band()]

    def _sources(self, values: Array, group: slice) -> tuple[Source, ...] | None:
        delays = self.families.geometry_at(values)[group, :-1] / self.surface.speed
        sides = [place.side for place in self.families.first.places]
        return sources_of(delays, sides, same=self.surface.sides == "same")

    def densities(self, frequency: Array) -> Array:
        """Return one-sided densities (signals, f) in SI units squared per Hz, at frequencies (f,) in Hz.

        The first member is used. The surface must have a band; the densities are 0 outside it.
        """
        values, first = self.families.start[:1], slice(0, 1)
        linear = Families(self.families.members[:1]).at(values, slopes=False)
        model = linear.model.of_rows([signal.output for signal in self.signals])[0]
        reduced = side_by_side([without_unreached(model, linear.along.of_rows([])[0])[0]])
        sources, surface = self._sources(values, first), self.surface
        assert sources is not None
        assert surface.band is not None
        eigen, n = Eigen(reduced.A), frequency / surface.speed
        inside = (n >= surface.band[0]) & (n <= surface.band[1])
        track = float(self.families.geometry_at(values)[0, -1])
        coherence = surface.root_coherence(n, track) if len(sources) == 2 else None
        power = inside * surface.heights(n) / surface.speed
        band = RoadExcitation(
            frequency[None], power[None], None, None if coherence is None else coherence[None]
        )
        shares: Array = BandVariance(
            relative(reduced, eigen.values), eigen, sources, band
        ).shares()[0]
        return shares


@dataclass(frozen=True)
class _Part:
    """Similar members of an analysis: models without neutral motions, and sources."""

    analysis: RandomVibration
    model: Matrices
    along: Matrices
    eigen: Eigen
    sources: tuple[Source, ...]
    values: Array
    group: slice

    @property
    def _sizes(self) -> Array:
        """Absolute value of each parameter; 1 (of its SI unit) for zero."""
        sizes = np.abs(self.values[self.group])
        return np.where(sizes > 0.0, sizes, 1.0)

    @property
    def _geometry_slopes(self) -> Array:
        """Slopes of delays (times speed) and of the width, m, for the requested parameters."""
        return np.asarray(
            self.analysis.families.geometry_slopes[self.group, : self.along.A.shape[1]]
        )

    @property
    def _later(self) -> Array:
        """Slopes of the delays, s, shape (members, parameters, wheels)."""
        return np.asarray(self._geometry_slopes[..., :-1] / self.analysis.surface.speed)

    @property
    def _track(self) -> Array:
        """Width between left and right of each member, m, shape (members, 1)."""
        return np.asarray(self.analysis.families.geometry_at(self.values)[self.group, -1:])

    def white(self) -> tuple[Array, Array, dict[int, str]]:
        """Return variances, slopes and absent signals under white noise."""
        rate, intensity = self.analysis.surface.corner_rate, self.analysis.surface.intensity
        model, along, eigen = self.model, self.along, self.eigen
        if rate is not None:
            model, along = with_cut_off(model, rate), cut_off_slopes(along, rate)
            eigen = Eigen(model.A)
        relative_model = relative(model, eigen.values)
        covariance = Covariance(relative_model, eigen, self.sources)
        slopes = np.zeros(along.C.shape[:-1])
        if slopes.size:
            relative_along = relative_slopes(
                model, relative_model, along, self._sizes[:, : along.A.shape[1]]
            )
            slopes = intensity * covariance.slopes(relative_along, self._later)
        return intensity * covariance.variances(), slopes, covariance.absent()

    def over_band(self) -> tuple[Array, Array, dict[int, str]]:
        """Return variances and slopes over the road's spectrum; no signal is absent."""
        relative_model, along = relative(self.model, self.eigen.values), self.along
        band = self._band()
        variance = BandVariance(relative_model, self.eigen, self.sources, band)
        slopes = np.zeros(along.C.shape[:-1])
        if slopes.size:
            relative_along = relative_slopes(
                self.model, relative_model, along, self._sizes[:, : along.A.shape[1]]
            )
            slopes = variance.slopes(relative_along, self._later, self._coherence_slopes(band))
        return variance.variances(), slopes, {}

    def _band(self) -> RoadExcitation:
        surface, signals = self.analysis.surface, self.analysis.signals
        assert surface.band is not None
        low, high = (n * surface.speed for n in surface.band)
        frequency, weights = frequencies(low, high, self.eigen.values, longest_delay(self.sources))
        n, flat = frequency / surface.speed, frequency.ravel()
        gain = None
        if any(signal.gain is not None for signal in signals):
            gains = [
                np.ones(flat.shape) if signal.gain is None else signal.gain(flat)
                for signal in signals
            ]
            gain = np.stack([(np.abs(values) ** 2).reshape(n.shape) for values in gains], axis=1)
        coherence = surface.root_coherence(n, self._track) if len(self.sources) == 2 else None
        heights = surface.heights(n.ravel()).reshape(n.shape)
        return RoadExcitation(frequency, weights * heights / surface.speed, gain, coherence)

    def _coherence_slopes(self, band: RoadExcitation) -> Array | None:
        """Slopes of the root of the coherence along parameters that change the width: (members, parameters, f)."""
        wider = self._geometry_slopes[..., -1]
        if band.coherence is None or not wider.any():
            return None
        surface, track = self.analysis.surface, self._track
        n, step = band.frequency / surface.speed, _TRACK_STEP * track
        above, below = (surface.root_coherence(n, track + sign * step) for sign in (1.0, -1.0))
        assert above is not None
        assert below is not None
        return np.asarray(wider[:, :, None] * ((above - below) / (2.0 * step))[:, None, :])
