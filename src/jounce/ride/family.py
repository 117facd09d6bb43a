"""Linear models as functions of a rig's numbers: matrices about static equilibrium, and their exact slopes."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import DescriptionError, JounceError
from jounce.core.remembered import Recent
from jounce.core.types import Array, Complex
from jounce.mechanics.facts import ROAD, is_road
from jounce.parts import Rig
from jounce.parts.rig import structure_of, unit_of, unknown_path
from jounce.parts.vehicles import Place, Vehicle, track_width
from jounce.simulation.compiled import Compiled, compile_rig
from jounce.simulation.statics import find_equilibrium, for_small_motions, in_terms_of, rests_for_small_motions

_STEP = 1e-3  # relative, of differences for mechanisms
_ASIDE = 0.5, -0.5, 1e-3, -1e-3  # the same for distances, which are affine
_DEPENDENT = 1e5  # condition of the eigenvectors beyond which they are not used


@dataclass(frozen=True)
class Matrices:
    """Linear model, or its slope along one number: ``dx/dt = A x + sum_j B_j d^j z/dt^j``, ``y = C x + D z ...``, SI.

    ``A`` (n, n) and ``C`` (outputs, n) act on the states, ``B`` (order, n, wheels) and ``D`` (order, outputs, wheels)
    on the heights of the road under the wheels and their time derivatives; ``static`` (outputs,) holds the static
    values of the outputs. Many models stand side by side along further axes before these.
    """

    A: Array
    B: Array
    C: Array
    D: Array
    static: Array

    def of_rows(self, rows: Sequence[int]) -> Matrices:
        """The model with some of its outputs only."""
        chosen = list(rows)
        return Matrices(self.A, self.B, self.C[..., chosen, :], self.D[..., chosen, :], self.static[..., chosen])

    def __getitem__(self, k: Any) -> Matrices:
        """One or some of the models that stand side by side."""
        return Matrices(self.A[k], self.B[k], self.C[k], self.D[k], self.static[k])


PARTS = ("A", "B", "C", "D", "static")


def side_by_side(models: Sequence[Matrices]) -> Matrices:
    """Many models of one size as one, along a first axis."""
    return Matrices(*(np.stack([getattr(one, name) for one in models]) for name in PARTS))


class Eigen:
    """Eigenvalues (..., n) and eigenvectors of matrices (..., n, n) in 1/s.

    ``is_sound`` tells for each of them whether the vectors are independent enough to be used; where they are not, unit
    vectors stand in their place.
    """

    def __init__(self, a: Array) -> None:
        values, vectors = np.linalg.eig(a)
        self.values, vectors = np.asarray(values, dtype=complex), np.asarray(vectors, dtype=complex)
        unit = np.eye(a.shape[-1], dtype=complex)
        with np.errstate(all="ignore"):
            sound = np.linalg.det(vectors) != 0.0
            inverse = np.linalg.inv(np.where(sound[..., None, None], vectors, unit))
            condition = np.linalg.norm(vectors, axis=(-2, -1)) * np.linalg.norm(inverse, axis=(-2, -1))
        self.is_sound = sound & (condition < _DEPENDENT)
        kept = self.is_sound[..., None, None]
        self.vectors, self.inverse = np.where(kept, vectors, unit), np.where(kept, inverse, unit)

    def of(self, members: slice) -> Eigen:
        """Those of some of the matrices."""
        found = object.__new__(Eigen)
        found.values, found.is_sound = self.values[members], self.is_sound[members]
        found.vectors, found.inverse = self.vectors[members], self.inverse[members]
        return found


@dataclass(frozen=True)
class LinearModels:
    """Models side by side (members, ...), and their slopes along numbers (members, numbers, ...)."""

    model: Matrices
    along: Matrices

    @cached_property
    def eigen(self) -> Eigen:
        """Eigenvalues and eigenvectors of the models."""
        return Eigen(self.model.A)


@dataclass(frozen=True)
class LinearFamily:
    """Linear models of one rig for any values of some of its numbers, the ``paths``; the rig gives all others."""

    rig: Rig
    paths: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        known = self.rig.parameters()
        for path in self.paths:
            if path not in known:
                raise unknown_path(f"parameters: {path}", known, name=path)

    @cached_property
    def compiled(self) -> Compiled:
        """The rig's model."""
        return compile_rig(self.rig)

    @property
    def is_exact(self) -> bool:
        """Whether slopes are exact; those of mechanisms with loops are differences of fourth order."""
        return not self.compiled.facts.projects

    @cached_property
    def start(self) -> Array:
        """Values of the numbers that vary, as in the rig, SI."""
        values = self.rig.parameters()
        return np.array([values[path] for path in self.paths])

    @cached_property
    def wheels(self) -> tuple[str, ...]:
        """Corner of each wheel; an empty text where there is only one."""
        tracks = self.compiled.facts.tracks
        return tuple(track.removesuffix(ROAD).removesuffix(".") for track in tracks if is_road(track))

    @cached_property
    def places(self) -> tuple[Place, ...]:
        """Where each wheel stands."""
        return _places(self.rig, self.wheels)

    @cached_property
    def geometry(self) -> tuple[Array, Array]:
        """How far each wheel follows the first and the width between left and right (all m), and their slopes.

        Shapes (wheels + 1,) and (numbers, wheels + 1); they are affine in every number.
        """
        first = _geometry(self.rig, self.wheels)
        slopes = [self._moved(path, first) for path in self.paths]
        return first, np.array(slopes).reshape(len(self.paths), len(first))

    def geometry_at(self, values: Array | None = None) -> Array:
        """Distances of ``geometry`` (m) at some values (SI) of the numbers."""
        first, slopes = self.geometry
        return first if values is None else np.asarray(first + (values - self.start) @ slopes)

    def _moved(self, path: str, first: Array) -> Array:
        if not isinstance(self.rig, Vehicle) or unit_of(self.rig, path) != "m":
            return np.zeros_like(first)
        value = self.rig.parameters()[path]
        for step in np.multiply(_ASIDE, abs(value) or 1.0):
            with contextlib.suppress(JounceError):  # another one is allowed then
                other = self.rig.with_changes({path: value + float(step)})
                return np.asarray((_geometry(other, self.wheels) - first) / step)
        raise DescriptionError("no value beside this one is allowed", where=f"parameters: {path}", found=f"{value:g} m")

    def at(self, values: Array | None = None, *, slopes: bool = True) -> tuple[Matrices, Matrices]:
        """Model at some values (SI) of the numbers, those of the rig by default; its slopes, one for each of them."""
        given = self.start if values is None else np.asarray(values, dtype=float)
        found = Families((self,)).at(given[None], slopes=slopes)
        return found.model[0], found.along[0]


@dataclass(frozen=True)
class Families:
    """Linear models of rigs that differ in numbers only, side by side: the same numbers of each may vary."""

    members: tuple[LinearFamily, ...]
    _last: dict[str, Any] = field(default_factory=dict, init=False, repr=False, compare=False)

    @property
    def first(self) -> LinearFamily:
        """The first of them, which has what all share."""
        return self.members[0]

    def __len__(self) -> int:
        return len(self.members)

    @cached_property
    def start(self) -> Array:
        """Values of the numbers that vary, as in each rig, SI: shape (members, numbers)."""
        return np.array([member.start for member in self.members])

    def geometry_at(self, values: Array) -> Array:
        """Distances of :attr:`LinearFamily.geometry` (m) at values (members, numbers): (members, wheels + 1)."""
        first, slopes = self._geometry
        return np.asarray(first + np.einsum("sn,snw->sw", values - self.start, slopes))

    @cached_property
    def _geometry(self) -> tuple[Array, Array]:
        found = [member.geometry for member in self.members]
        return np.array([first for first, _ in found]), np.array([slopes for _, slopes in found])

    @property
    def geometry_slopes(self) -> Array:
        """Slopes of those distances, shape (members, numbers, wheels + 1)."""
        return self._geometry[1]

    def at(self, values: Array, *, slopes: bool = True) -> LinearModels:
        """Models at values (members, numbers), SI, and their slopes."""
        wanted = np.asarray(values, dtype=float)
        key = wanted.tobytes(), slopes
        last: tuple[object, LinearModels] | None = self._last.get("models")  # which several roads ask for
        if last is None or last[0] != key:
            last = self._last["models"] = key, LinearModels(*self._at(wanted, slopes))
        return last[1]

    def _at(self, values: Array, slopes: bool) -> tuple[Matrices, Matrices]:
        p = self._parameters.copy()
        for place, column in zip(self._places, values.T, strict=True):
            if place is not None:
                p[:, place] = column
        if not self.first.compiled.facts.projects:
            return self._exactly(p, slopes=slopes)
        found = [self._by_differences(one, slopes=slopes) for one in p]
        return side_by_side([model for model, _ in found]), side_by_side([along for _, along in found])

    @cached_property
    def _parameters(self) -> Array:
        """The model's parameters of each rig, shape (members, parameters)."""
        compiled = self.first.compiled
        return np.array([compiled.parameter_values(member.rig.parameters()) for member in self.members])

    @cached_property
    def _places(self) -> list[int | None]:
        """Place of each number among the model's parameters; None where the model does not feel it."""
        known = self.first.compiled.facts.parameters
        return [known.index(path) if path in known else None for path in self.first.paths]

    def _exactly(self, p: Array, *, slopes: bool) -> tuple[Matrices, Matrices]:
        compiled = self.first.compiled
        graphs, u = _graphs(compiled, self.first.rig), np.tile(compiled.inputs(0.0), (len(p), 1))
        x, modes = rests_for_small_motions(compiled, graphs.rest, p, u)
        model = self._shaped(graphs.values(x, u, p, modes))
        count = len(self._places) if slopes else 0
        if not count:
            return model, _none_of(model)
        moved = np.zeros((len(p), count, p.shape[1]))
        for i, place in enumerate(self._places):
            if place is not None:
                moved[:, i, place] = 1.0
        dp = moved.reshape(-1, p.shape[1])
        where = [np.repeat(part, count, axis=0) for part in (x, u, p, modes)]
        push = graphs.push(*where, dp)[0].reshape(len(p), count, -1)
        loose = np.linalg.pinv(model.A, rcond=len(model.A[0]) * np.finfo(float).eps)  # neutral motions do not move
        dx = -np.einsum("sij,snj->sni", loose, push).reshape(-1, x.shape[1])
        along = graphs.along(*where, dx, dp)
        return model, self._shaped([part.reshape(len(p), count, *part.shape[1:]) for part in along])

    def _shaped(self, parts: Sequence[Array]) -> Matrices:
        a, b, c, d, static = parts
        order, wheels = self.first.compiled.facts.track_order, len(self.first.wheels)
        b3, d3 = (np.moveaxis(part.reshape(*part.shape[:-1], wheels, order), -1, -3) for part in (b, d))
        return Matrices(a, b3, c, d3, static.reshape((*static.shape[: a.ndim - 2], -1)))

    def _by_differences(self, p: Array, *, slopes: bool) -> tuple[Matrices, Matrices]:
        """Model of one member and its slopes."""
        model, (pose, free) = self._numeric(p)
        weights = (1.0, -8.0, 8.0, -1.0)
        found: list[Matrices] = []
        for place in self._places if slopes else ():
            step = _STEP * (abs(p[place]) or 1.0) if place is not None else 1.0
            sides = []
            for count in (-2, -1, 1, 2):
                moved = p.copy()
                if place is not None:
                    moved[place] += count * step
                sides.append(self._numeric(moved, pose, free)[0])
            found.append(
                Matrices(
                    *(
                        sum(w * getattr(side, name) for w, side in zip(weights, sides, strict=True)) / (12.0 * step)
                        for name in PARTS
                    )
                )
            )
        return model, side_by_side(found) if found else _none_of(model[None])[0]

    def _numeric(
        self, p: Array, pose: Array | None = None, free: NDArray[np.intp] | None = None
    ) -> tuple[Matrices, tuple[Array, NDArray[np.intp]]]:
        """Model about equilibrium, sought from a pose, in terms of some ``free`` speeds; the pose, and those speeds.

        Models that are to be compared need the same: which are the best ones changes from pose to pose.
        """
        compiled = self.first.compiled
        u = compiled.inputs(0.0)
        equilibrium = find_equilibrium(compiled, p, u, pose)
        equilibrium = for_small_motions(compiled, equilibrium, p, u)
        free = equilibrium.free if free is None else free
        lift, pick = in_terms_of(compiled, equilibrium, free)
        where = (equilibrium.x, u, p, equilibrium.modes)
        across, along = compiled.slopes("x", *where), compiled.slopes("u", *where)
        columns = _road_columns(compiled)
        parts = [
            pick @ across["rate"] @ lift,
            pick @ along["rate"][:, columns],
            across["output"] @ lift,
            along["output"][:, columns],
            compiled.evaluate("output", *where),
        ]
        return self._shaped(parts), (equilibrium.x[: compiled.facts.counts[0]], free)


def _none_of(model: Matrices) -> Matrices:
    """Slopes of models (members, ...) along no numbers."""
    return Matrices(*(np.zeros((len(part), 0, *part.shape[1:])) for part in (getattr(model, name) for name in PARTS)))


def _places(rig: Rig, wheels: Sequence[str]) -> tuple[Place, ...]:
    known: Mapping[str, Place] = rig.wheels if isinstance(rig, Vehicle) else {}
    return tuple(known.get(wheel, Place(0.0, 0)) for wheel in wheels)


def _geometry(rig: Rig, wheels: Sequence[str]) -> Array:
    return np.array([*(place.behind for place in _places(rig, wheels)), track_width(rig)])


def _road_columns(compiled: Compiled) -> list[int]:
    facts = compiled.facts
    order = facts.track_order
    return [i * order + j for i, track in enumerate(facts.tracks) if is_road(track) for j in range(order)]


@dataclass(frozen=True)
class _Graphs:
    """Matrices of a model, what pushes it from rest along a parameter, and the matrices' change along a direction.

    ``rest`` gives rates, their slopes by the states, and switches.
    """

    rest: _Each
    values: _Each
    push: _Each
    along: _Each


_made: Recent[_Graphs] = Recent()


def _graphs(compiled: Compiled, rig: Rig) -> _Graphs:
    return _made.of((type(rig).__name__, structure_of(rig)), lambda: _built(compiled))


def _built(compiled: Compiled) -> _Graphs:
    import casadi as ca

    model = compiled.model
    columns = _road_columns(compiled)
    by_x = ca.jacobian(ca.vertcat(model.rate, model.output), model.x)
    by_u = ca.jacobian(ca.vertcat(model.rate, model.output), model.u)[:, columns]
    n = model.x.shape[0]
    parts = [ca.densify(part) for part in (by_x[:n, :], by_u[:n, :], by_x[n:, :], by_u[n:, :], model.output)]
    where = [model.x, model.u, model.p, model.m]
    dx, dp = ca.SX.sym("dx", n), ca.SX.sym("dp", model.p.shape[0])
    flat = ca.vertcat(*(ca.vec(part) for part in parts))
    change = ca.jtimes(flat, ca.vertcat(model.x, model.p), ca.vertcat(dx, dp))
    changes, begin = [], 0
    for part in parts:
        changes.append(ca.densify(ca.reshape(change[begin : begin + part.numel()], part.shape)))
        begin += part.numel()
    push = ca.densify(ca.jtimes(model.rate, model.p, dp))
    return _Graphs(
        _Each("rest", where, [ca.densify(part) for part in (model.rate, by_x[:n, :], model.switch)]),
        _Each("values", where, parts),
        _Each("push", [*where, dp], [push]),
        _Each("along", [*where, dx, dp], changes),
    )


class _Each:
    """A function of vectors, called for many rows (members, size) at once: results (members, rows, columns).

    Each thread takes what it works in for itself, and leaves it for the next call.
    """

    def __init__(self, name: str, given: list[Any], results: list[Any]) -> None:
        import casadi as ca

        self._function = ca.Function(name, given, results)
        self._ready: dict[int, list[tuple[Any, Any, list[Array], list[Array]]]] = {}

    def __call__(self, *given: Array) -> list[Array]:
        free = self._ready.setdefault(len(given[0]), [])
        try:
            room = free.pop()
        except IndexError:
            room = self._of(len(given[0]))
        _, call, into, found = room
        for place, values in zip(into, given, strict=True):
            place[:] = values
        call()
        results = [np.swapaxes(part, 1, 2).copy() for part in found]
        free.append(room)
        return results

    def _of(self, count: int) -> tuple[Any, Any, list[Array], list[Array]]:
        """Rows side by side are columns one after the other, as CasADi has them: nothing is turned round."""
        function = self._function.map(count)
        plain = self._function
        buffer, call = function.buffer()
        into = [np.zeros((count, plain.size1_in(i))) for i in range(plain.n_in())]
        found = [np.zeros((count, plain.size2_out(i), plain.size1_out(i))) for i in range(plain.n_out())]
        for i, place in enumerate(into):
            buffer.set_arg(i, place.data)
        for i, place in enumerate(found):
            buffer.set_res(i, place.data)
        return buffer, call, into, found


# without motions that the road never reaches --------------------------------------------------------------------------


_NEUTRAL = 1e-6  # of the largest eigenvalue: rounding of a double eigenvalue at zero
_UNREACHED = 1e-7


def has_neutral(values: Complex) -> bool:
    """Whether some motion of some model neither grows nor dies, by the eigenvalues (..., n)."""
    bound = -_NEUTRAL * np.max(np.abs(values), axis=-1, initial=0.0)
    return bool(values.shape[-1]) and bool(np.any(np.max(values.real, axis=-1) >= bound))


def without_unreached(model: Matrices, slopes: Matrices) -> tuple[Matrices, Matrices]:
    """A model and its slopes (numbers, ...) without neutral motions, or as they are where the road reaches those."""
    values = np.asarray(np.linalg.eigvals(model.A), dtype=np.complex128)
    if not has_neutral(values):
        return model, slopes
    from scipy.linalg import schur

    bound = -_NEUTRAL * float(np.max(np.abs(values), initial=0.0))
    form, basis, count = schur(model.A, output="real", sort=lambda real, _: real < bound)
    if count == len(form):
        return model, slopes
    kept, left = basis[:, :count], basis[:, count:]
    for b in model.B:
        if np.max(np.abs(left.T @ b), initial=0.0) > _UNREACHED * max(float(np.max(np.abs(b), initial=0.0)), 1.0):
            return model, slopes
    found = _reduced(model, kept)
    moved = [_moved(model, slopes[k], form, kept, left) for k in range(len(slopes.A))]
    return found, side_by_side(moved) if moved else _none_of(found[None])[0]


def _reduced(model: Matrices, kept: Array) -> Matrices:
    b = np.stack([kept.T @ part for part in model.B])
    return Matrices(kept.T @ model.A @ kept, b, model.C @ kept, model.D, model.static)


def _moved(model: Matrices, along: Matrices, form: Array, kept: Array, left: Array) -> Matrices:
    """Slope of the reduced model, the subspace turning with the number."""
    from scipy.linalg import solve_sylvester

    count = kept.shape[1]
    turn = solve_sylvester(form[count:, count:], -form[:count, :count], -left.T @ along.A @ kept)
    found = _reduced(along, kept)
    a, c = found.A + kept.T @ model.A @ left @ turn, found.C + model.C @ left @ turn
    return Matrices(a, found.B, c, found.D, found.static)
