"""Covariances under white noise that reaches a linear model at several times: exact, with exact slopes.

The heights of a road whose velocity is white noise wander without limit, so states are taken relative to what the
model does when the road moves slowly: ``x_rel = x - E z`` with ``A E + B0 = 0``. Then ``dx_rel/dt = A x_rel +
(B1 - E) dz/dt``, and an output is stationary exactly if what is left of ``C E + D0`` sums to nothing over the wheels
that one noise drives. Wheel ``l`` follows wheel ``k`` by ``s``: their cross term is ``exp(A s) X`` with
``A X + X A' + b_k b_l' = 0``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from jounce.core.errors import SimulationError
from jounce.core.types import Array, Complex
from jounce.ride.family import LinearFamily, Matrices, without_unreached
from jounce.ride.surface import Surface

# white noise ----------------------------------------------------------------------------------------------------------


_NOTHING = 1e-9
"""What is left of a sum of terms is nothing below this share of their sizes."""
_DEFECTIVE = 1e5  # condition of the eigenvectors beyond which they are not used
_BEGINS = 1e-5  # the same of slopes, which may be differences
WANDERS = "follows the height of the road, which wanders without limit under white noise"
KICKED = "feels the road's vertical velocity directly, whose variance is infinite under white noise"


@dataclass(frozen=True)
class Relative:
    """Linear model with states relative to the quasi-static motion: ``dx/dt = A x + b v``, ``y = C x + d z + f v``.

    ``z`` are the heights of the wheels' road (m), ``v`` their rates; ``E`` is the quasi-static motion, shape (n,
    wheels), and ``scale`` the size of the terms that ``d`` is a sum of. Also used for the slopes of all that.
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
    """Take the states relative to the quasi-static motion, in which the road's acceleration must not matter."""
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
    """Sort wheels by what drives them: one noise for all (``same``), or one for each side (1 left, -1 right)."""
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
    """Variances of the outputs of a relative model under unit white noise, and their slopes."""

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
    return Matrices(a, b, c, np.stack([np.zeros_like(model.D[0]), model.D[1]]), model.static)


def cut_off_slope(along: Matrices, rate: float) -> Matrices:
    """Slope of that model, from the slope of the matrices; ``rate`` in 1/s."""
    found: dict[str, Any] = vars(with_cut_off(along, rate)).copy()
    n = len(along.A)
    found["A"] = found["A"].copy()
    found["A"][n:, n:] = 0.0
    found["B"] = found["B"].copy()
    found["B"][1, n:] = 0.0
    return Matrices(**found)


# a band of frequencies ------------------------------------------------------------------------------------------------


_PANELS = 12  # a decade
_POINTS = 8  # of Gauss and Legendre in each panel
_NEAR = tuple(0.4 * 2.5**k for k in range(9))  # half widths of a resonance at which panels end
_FAR = 0.3  # of its frequency, beyond which a resonance needs no panels of its own
_PERIODS = 0.4  # of the waves between front and rear that a panel may hold
_CHUNK = 80  # nodes summed at once: small products stay on one core, and several cores would only wait for each other
_DEFECTIVE_BAND = 1e6  # condition of the eigenvectors beyond which they are not used


def frequencies(low: float, high: float, a: Array, delay: float) -> tuple[Array, Array]:
    """Nodes and weights (Hz) of a quadrature over a band that resolves a model's resonances and longest delay (s)."""
    count = max(1, int(np.ceil(_PANELS * np.log10(high / low))))
    edges = [*np.geomspace(low, high, count + 1)]
    for value in np.linalg.eigvals(a):
        middle, width = abs(value.imag) / (2.0 * np.pi), abs(value.real) / (2.0 * np.pi)
        if value.imag > 0.0:
            reach = [share * width for share in _NEAR if share * width < _FAR * middle]
            edges += [middle + side * way for way in reach for side in (-1.0, 1.0)]
    inside = np.unique([edge for edge in edges if low <= edge <= high])
    if delay > 0.0:
        parts = np.maximum(1, np.ceil(np.diff(inside) * delay / _PERIODS).astype(int))
        first, width = np.repeat(inside[:-1], parts), np.repeat(np.diff(inside) / parts, parts)
        place = np.arange(len(first)) - np.repeat(np.cumsum(parts) - parts, parts)
        inside = np.append(first + place * width, inside[-1])
    points, weights = np.polynomial.legendre.leggauss(_POINTS)
    half, middle_of = 0.5 * np.diff(inside), 0.5 * (inside[1:] + inside[:-1])
    nodes = (middle_of[:, None] + half[:, None] * points).ravel()
    return nodes, (half[:, None] * weights).ravel()


class Inverse:
    """``(s - A)^-1`` at many frequencies (rad/s times i), by eigenvectors where they are independent."""

    def __init__(self, a: Array, s: Complex) -> None:
        self.a, self.s = a, s
        values, self._vectors = np.linalg.eig(a)
        self._are_independent = bool(np.linalg.cond(self._vectors) < _DEFECTIVE_BAND)
        self._shares = 1.0 / (s[:, None] - values)
        self._left = np.linalg.inv(self._vectors) if self._are_independent else self._vectors

    def times(self, b: Array) -> Complex:
        """Inverse times b, shape (n, m): shape (f, n, m)."""
        if self._are_independent:
            return np.asarray(self._vectors @ (self._shares[:, :, None] * (self._left @ b)))
        return np.asarray(np.linalg.solve(self._shifted(), np.broadcast_to(b, (len(self.s), *b.shape))))

    def before(self, c: Array) -> Complex:
        """C, shape (m, n), times the inverse: shape (f, m, n)."""
        if self._are_independent:
            return np.asarray(((c @ self._vectors) * self._shares[:, None, :]) @ self._left)
        turned = np.linalg.solve(np.swapaxes(self._shifted(), 1, 2), np.broadcast_to(c.T, (len(self.s), *c.T.shape)))
        return np.asarray(np.swapaxes(turned, 1, 2))

    def _shifted(self) -> Complex:
        return np.asarray(self.s[:, None, None] * np.eye(len(self.a)) - self.a)


@dataclass(frozen=True)
class _Pull:
    """Slopes of the variances along A (outputs, n, n; turned), b, C, d, f and the delays of one source."""

    matrix: Array
    drive: Array
    state: Array
    height: Array
    rate: Array
    delay: Array


@dataclass(frozen=True)
class Band:
    """What arrives at the wheels at some frequencies.

    ``power`` is the density of the road's height times the weight of the node (m^2); ``gain`` the squared magnitude by
    which each output is weighted, shape (outputs, f); ``coherence`` the root of that of left and right where they are
    two sources, None where sources are independent.
    """

    frequency: Array
    power: Array
    gain: Array
    coherence: Array | None = None


@dataclass(frozen=True)
class BandVariance:
    """Variances of the outputs of a relative model over a band, and their slopes."""

    model: Relative
    sources: tuple[Source, ...]
    band: Band

    @cached_property
    def _s(self) -> Complex:
        return np.asarray(2j * np.pi * self.band.frequency)

    @cached_property
    def _inverse(self) -> Inverse:
        return Inverse(self.model.A, self._s)

    def _summed(self, table: Array, source: Source) -> Array:
        """One column for each group of wheels."""
        return np.stack([table[:, list(group.wheels)].sum(axis=1) for group in source], axis=1)

    @cached_property
    def _waves(self) -> list[Complex]:
        """Phase of each group, for each source: shape (f, groups)."""
        delays = [np.array([group.delay for group in source]) for source in self.sources]
        return [np.asarray(np.exp(-self._s[:, None] * delay)) for delay in delays]

    @cached_property
    def _moved(self) -> list[Complex]:
        """States for unit rate of the road, for each source: shape (f, n, groups)."""
        return [self._inverse.times(self._summed(self.model.b, source)) for source in self.sources]

    @cached_property
    def _by_group(self) -> list[Complex]:
        """Response to unit height, each group at its time: shape (f, outputs, groups)."""
        found = []
        for source, moved, waves in zip(self.sources, self._moved, self._waves, strict=True):
            whole = self.model.C @ moved + self._summed(self.model.f, source)
            height = whole * self._s[:, None, None] + self._summed(self.model.d, source)
            found.append(height * waves[:, None, :])
        return found

    @cached_property
    def _responses(self) -> list[Complex]:
        """Response of each output to each source, shape (outputs, f)."""
        return [np.asarray(part.sum(axis=2).T) for part in self._by_group]

    @cached_property
    def _weights(self) -> Array:
        """What a squared response counts, shape (outputs, f)."""
        return self.band.power * self.band.gain

    def shares(self) -> Array:
        """What each frequency gives to the variance of each output, in the square of its SI unit: (outputs, f)."""
        found = np.sum([np.abs(part) ** 2 for part in self._responses], axis=0)
        if self.band.coherence is not None:
            found = found + 2.0 * self.band.coherence * self._shared()
        return np.asarray(found * self._weights)

    def variances(self) -> Array:
        """Variance of each output, in the square of its SI unit."""
        return np.asarray(np.sum(self.shares(), axis=1))

    def _shared(self) -> Array:
        left, right = self._responses
        return np.asarray((left * right.conj()).real)

    @cached_property
    def _pulls(self) -> list[_Pull]:
        """How the variances follow the parts of the model, for each source: once for all slopes."""
        seen = self._inverse.before(self.model.C)
        return [self._pull(i, seen) for i in range(len(self.sources))]

    def _pull(self, i: int, seen: Complex) -> _Pull:
        answer = self._responses[i].conj()
        if self.band.coherence is not None:
            answer = answer + self.band.coherence * self._responses[1 - i].conj()
        answer = 2.0 * answer * self._weights
        waves = self._waves[i]
        rates = waves * self._s[:, None]
        state = np.einsum("fng,fg->fn", self._moved[i], rates)
        return _Pull(
            _summed_products(state, answer, seen),
            np.swapaxes(_summed_products(rates, answer, seen), 1, 2),
            np.einsum("rf,fn->rn", answer, state).real,  # without the cores of a matrix product, as above
            np.einsum("rf,fg->rg", answer, waves).real,
            np.einsum("rf,fg->rg", answer, rates).real,
            np.einsum("rf,f,frg->rg", answer, self._s, self._by_group[i]).real,
        )

    def slopes(self, along: Relative, later: Array, coherence: Array | None = None) -> Array:
        """Slope of the variances along a number, from those of model, delays (``later``, s) and coherence."""
        total = np.zeros(len(self.model.C))
        for source, pull in zip(self.sources, self._pulls, strict=True):
            late = np.array([later[group.wheels[0]] for group in source])
            total += np.einsum("rij,ji->r", pull.matrix, along.A)
            total += np.einsum("rjg,jg->r", pull.drive, self._summed(along.b, source))
            total += np.sum(pull.state * along.C, axis=1) - pull.delay @ late
            total += np.sum(pull.height * self._summed(along.d, source), axis=1)
            total += np.sum(pull.rate * self._summed(along.f, source), axis=1)
        if coherence is not None:
            total += np.sum(2.0 * coherence * self._shared() * self._weights, axis=1)
        return total


def _summed_products(left: Complex, weights: Complex, right: Complex) -> Array:
    """Real part of the sum over f of weights (r, f) times left (f, n) times right (f, r, m): shape (r, n, m)."""
    total: Array = np.zeros((weights.shape[0], left.shape[1], right.shape[2]))
    for first in range(0, len(left), _CHUNK):
        part = slice(first, first + _CHUNK)
        total += ((left[part].T * weights[:, None, part]) @ np.swapaxes(right[part], 0, 1)).real
    return total


def longest_delay(sources: Sequence[Source]) -> float:
    """Longest delay (s) between wheels that one source drives."""
    return max(source[-1].delay - source[0].delay for source in sources)


# variances of the signals of a rig ------------------------------------------------------------------------------------


Gain = Callable[[Array], Array]
"""Magnitude (1) of a weighting at frequencies (Hz)."""
_TRACK_STEP = 1e-4  # relative, of the difference that gives the slope of a coherence


@dataclass(frozen=True)
class Signal:
    """A channel by its place among the outputs, and the weighting of its frequencies, if any."""

    output: int
    gain: Gain | None = None


@dataclass(frozen=True)
class Moments:
    """Variances and static values of signals, SI, shape (signals,), and their slopes, shape (numbers, signals).

    ``absent`` gives the reason for signals without a stationary variance; ``model`` and ``slopes`` are the linear model
    with all its outputs and its slopes, none where they were not wanted.
    """

    variances: Array
    static: Array
    variance_slopes: Array
    static_slopes: Array
    absent: dict[int, str]
    model: Matrices
    slopes: tuple[Matrices, ...]


@dataclass(frozen=True)
class Analysis:
    """Random vibration of one rig on one road; a weighted signal needs a surface with a band."""

    family: LinearFamily
    surface: Surface
    signals: tuple[Signal, ...]

    def at(self, values: Array | None = None, *, slopes: bool = True) -> Moments:
        """Variances at some values (SI) of the numbers, those of the rig by default."""
        given = self.family.start if values is None else values
        model, along = self.family.at(given, slopes=slopes)
        rows = [signal.output for signal in self.signals]
        chosen, moving = without_unreached(model.of_rows(rows), [part.of_rows(rows) for part in along])
        if self.surface.band is None:
            found = self._white(chosen, moving, given)
        else:
            found = self._banded(chosen, moving, given)
        count = len(self.signals)
        static_slopes = np.array([part.static for part in moving]).reshape(len(moving), count)
        variance_slopes = np.array(found[1]).reshape(len(moving), count)
        return Moments(found[0], chosen.static, variance_slopes, static_slopes, found[2], model, along)

    def densities(self, frequency: Array) -> Array:
        """One-sided densities of the signals, (signals, f), their SI units squared per Hz, at frequencies (f,) in Hz.

        The surface must have a band; outside it they are 0.
        """
        values = self.family.start
        model, _ = self.family.at(values, slopes=False)
        chosen, _ = without_unreached(model.of_rows([signal.output for signal in self.signals]), [])
        sources, surface = self._sources(values), self.surface
        assert surface.band is not None
        n = frequency / surface.speed
        inside = (n >= surface.band[0]) & (n <= surface.band[1])
        track = float(self.family.geometry_at(values)[-1])
        shared = surface.shared(n, track) if len(sources) == 2 else None
        gain = np.ones((len(self.signals), len(n)))
        band = Band(frequency, inside * surface.heights(n) / surface.speed, gain, shared)
        return BandVariance(relative(chosen), sources, band).shares()

    def _sources(self, values: Array) -> tuple[Source, ...]:
        delays = self.family.geometry_at(values)[:-1] / self.surface.speed
        sides = [place.side for place in self.family.places]
        return sources_of([float(delay) for delay in delays], sides, same=self.surface.sides == "same")

    @cached_property
    def _later(self) -> Array:
        """Slopes of the delays, s, shape (numbers, wheels)."""
        return np.asarray(self.family.geometry[1][:, :-1] / self.surface.speed)

    def _white(
        self, model: Matrices, along: Sequence[Matrices], values: Array
    ) -> tuple[Array, list[Array], dict[int, str]]:
        rate, intensity = self.surface.corner_rate, self.surface.intensity
        whole = model if rate is None else with_cut_off(model, rate)
        parts = along if rate is None else [cut_off_slope(part, rate) for part in along]
        found = relative(whole)
        covariance = Covariance(found, self._sources(values))
        slopes = [
            intensity * covariance.slopes(relative_slope(whole, found, part, size), later)
            for part, later, size in zip(parts, self._later, _sizes(values), strict=True)
        ]
        return intensity * covariance.variances(), slopes, covariance.absent()

    def _banded(
        self, model: Matrices, along: Sequence[Matrices], values: Array
    ) -> tuple[Array, list[Array], dict[int, str]]:
        found, sources = relative(model), self._sources(values)
        band = self._band(found, sources, float(self.family.geometry_at(values)[-1]))
        variance = BandVariance(found, sources, band)
        slopes = []
        for i, part in enumerate(along):
            wider = self._coherence_slope(band, i, values)
            moving = relative_slope(model, found, part, _sizes(values)[i])
            slopes.append(variance.slopes(moving, self._later[i], wider))
        return variance.variances(), slopes, {}

    def _band(self, model: Relative, sources: tuple[Source, ...], track: float) -> Band:
        surface = self.surface
        assert surface.band is not None
        low, high = (n * surface.speed for n in surface.band)
        frequency, weights = frequencies(low, high, model.A, longest_delay(sources))
        n = frequency / surface.speed
        gain = np.ones((len(self.signals), len(n)))
        for row, signal in zip(gain, self.signals, strict=True):
            if signal.gain is not None:
                row[:] = np.abs(signal.gain(frequency)) ** 2
        shared = surface.shared(n, track) if len(sources) == 2 else None
        return Band(frequency, weights * surface.heights(n) / surface.speed, gain, shared)

    def _coherence_slope(self, band: Band, number: int, values: Array) -> Array | None:
        """Slope of the root of the coherence along a number that moves left and right apart."""
        wider = float(self.family.geometry[1][number, -1])
        if band.coherence is None or wider == 0.0:
            return None
        track = float(self.family.geometry_at(values)[-1])
        n, step = band.frequency / self.surface.speed, _TRACK_STEP * track
        sides = [self.surface.shared(n, track + sign * step) for sign in (1.0, -1.0)]
        assert sides[0] is not None
        assert sides[1] is not None
        return np.asarray(wider * (sides[0] - sides[1]) / (2.0 * step))


def _sizes(values: Array) -> list[float]:
    """Size of each number, 1 (of its SI unit) for zero."""
    return [abs(float(value)) or 1.0 for value in values]
