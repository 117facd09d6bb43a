"""Linear models about static equilibrium as functions of a rig's parameters, with exact slopes."""

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
from jounce.simulation.statics import (
    find_equilibrium,
    for_small_motions,
    in_terms_of,
    rests_for_small_motions,
)

_STEP = (
    1e-3  # relative step for mechanisms: fourth order, so truncation is 1e-12 and rounding 1e-13
)
_ASIDE = (
    0.5,
    -0.5,
    1e-3,
    -1e-3,
)  # relative steps for distances: these are affine, so any step is exact
_DEPENDENT = 1e5  # condition number of the eigenvectors (five lost digits) above which Lyapunov equations are solved


@dataclass(frozen=True)
class Matrices:
    """Linear model, or its slope along a parameter, SI: ``dx/dt = A x + sum_j B_j d^j z/dt^j``, ``y = C x + D z ...``.

    ``A`` (n, n) and ``C`` (outputs, n) act on the states, ``B`` (order, n, wheels) and ``D`` (order, outputs, wheels)
    on the heights of the road under the wheels and their time derivatives; ``static`` (outputs,) holds the static
    values of the outputs. Several models are stacked along leading axes.
    """

    A: Array
    B: Array
    C: Array
    D: Array
    static: Array

    def of_rows(self, rows: Sequence[int]) -> Matrices:
        """Return the model with a subset of its outputs."""
        chosen = list(rows)
        return Matrices(
            self.A, self.B, self.C[..., chosen, :], self.D[..., chosen, :], self.static[..., chosen]
        )

    def __getitem__(self, k: Any) -> Matrices:
        """Return one or some of the stacked models."""
        return Matrices(self.A[k], self.B[k], self.C[k], self.D[k], self.static[k])


PARTS = ("A", "B", "C", "D", "static")


def side_by_side(models: Sequence[Matrices]) -> Matrices:
    """Stack models of one size along a first axis."""
    return Matrices(*(np.stack([getattr(model, name) for model in models]) for name in PARTS))


class Eigen:
    """Eigenvalues (..., n) and eigenvectors of matrices (..., n, n) in 1/s.

    ``is_sound`` is true for each matrix with sufficiently independent eigenvectors; the others are replaced by unit
    vectors.
    """

    def __init__(self, a: Array) -> None:
        values, vectors = np.linalg.eig(a)
        self.values, vectors = np.asarray(values, dtype=complex), np.asarray(vectors, dtype=complex)
        unit = np.eye(a.shape[-1], dtype=complex)
        with np.errstate(all="ignore"):
            sound = np.linalg.det(vectors) != 0.0
            inverse = np.linalg.inv(np.where(sound[..., None, None], vectors, unit))
            condition = np.linalg.norm(vectors, axis=(-2, -1)) * np.linalg.norm(
                inverse, axis=(-2, -1)
            )
        self.is_sound = sound & (condition < _DEPENDENT)
        chosen = self.is_sound[..., None, None]
        self.vectors, self.inverse = (
            np.where(chosen, vectors, unit),
            np.where(chosen, inverse, unit),
        )

    def of(self, members: slice) -> Eigen:
        """Return the eigenvalues and eigenvectors of some matrices."""
        eigen = object.__new__(Eigen)
        eigen.values, eigen.is_sound = self.values[members], self.is_sound[members]
        eigen.vectors, eigen.inverse = self.vectors[members], self.inverse[members]
        return eigen


@dataclass(frozen=True)
class LinearModels:
    """Stacked models (members, ...), and their slopes along parameters (members, parameters, ...)."""

    model: Matrices
    along: Matrices

    @cached_property
    def eigen(self) -> Eigen:
        """Eigenvalues and eigenvectors of the models."""
        return Eigen(self.model.A)


@dataclass(frozen=True)
class LinearFamily:
    """Linear models of one rig as functions of the parameters ``paths``; all others are fixed by the rig."""

    rig: Rig
    paths: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        known = self.rig.parameters()
        for path in self.paths:
            if path not in known:
                raise unknown_path(f"parameters: {path}", known, name=path)

    @cached_property
    def compiled(self) -> Compiled:
        """The compiled model."""
        return compile_rig(self.rig)

    @property
    def is_exact(self) -> bool:
        """Whether slopes are exact; those of mechanisms with loops are fourth-order differences."""
        return not self.compiled.facts.projects

    @cached_property
    def start(self) -> Array:
        """Values of the free parameters in the rig, SI."""
        values = self.rig.parameters()
        return np.array([values[path] for path in self.paths])

    @cached_property
    def wheels(self) -> tuple[str, ...]:
        """Corner of each wheel; "" for a single wheel."""
        tracks = self.compiled.facts.tracks
        return tuple(
            track.removesuffix(ROAD).removesuffix(".") for track in tracks if is_road(track)
        )

    @cached_property
    def places(self) -> tuple[Place, ...]:
        """Position of each wheel in the vehicle."""
        return _places(self.rig, self.wheels)

    @cached_property
    def geometry(self) -> tuple[Array, Array]:
        """Distance of each wheel behind the first and width between left and right (all m), and their slopes.

        Shapes (wheels + 1,) and (parameters, wheels + 1); they are affine in every parameter.
        """
        first = _geometry(self.rig, self.wheels)
        slopes = [self._geometry_slope(path, first) for path in self.paths]
        return first, np.array(slopes).reshape(len(self.paths), len(first))

    def geometry_at(self, values: Array | None = None) -> Array:
        """Return the distances of ``geometry`` (m) at values (SI) of the parameters."""
        first, slopes = self.geometry
        return first if values is None else np.asarray(first + (values - self.start) @ slopes)

    def _geometry_slope(self, path: str, first: Array) -> Array:
        if not isinstance(self.rig, Vehicle) or unit_of(self.rig, path) != "m":
            return np.zeros_like(first)
        value = self.rig.parameters()[path]
        for step in np.multiply(_ASIDE, abs(value) or 1.0):
            with contextlib.suppress(JounceError):  # a step out of the allowed range: try the next
                changed = self.rig.with_changes({path: value + float(step)})
                return np.asarray((_geometry(changed, self.wheels) - first) / step)
        raise DescriptionError(
            "this parameter cannot be changed here",
            where=f"parameters: {path}",
            found=f"{value:g} m",
        )

    def at(self, values: Array | None = None, *, slopes: bool = True) -> tuple[Matrices, Matrices]:
        """Return the model at values (SI) of the parameters, by default those of the rig, and its slope along each."""
        point = self.start if values is None else np.asarray(values, dtype=float)
        models = Families((self,)).at(point[None], slopes=slopes)
        return models.model[0], models.along[0]


@dataclass(frozen=True)
class Families:
    """Stacked linear models of rigs that differ only in parameter values and have the same free parameters."""

    members: tuple[LinearFamily, ...]
    _last: dict[str, Any] = field(default_factory=dict, init=False, repr=False, compare=False)

    @property
    def first(self) -> LinearFamily:
        """First member, which represents the shared structure."""
        return self.members[0]

    def __len__(self) -> int:
        return len(self.members)

    @cached_property
    def start(self) -> Array:
        """Values of the free parameters in each rig, SI: shape (members, parameters)."""
        return np.array([member.start for member in self.members])

    def geometry_at(self, values: Array) -> Array:
        """Return distances of ``LinearFamily.geometry`` (m), (members, wheels + 1), at values (members, parameters)."""
        first, slopes = self._geometry
        return np.asarray(first + np.einsum("sn,snw->sw", values - self.start, slopes))

    @cached_property
    def _geometry(self) -> tuple[Array, Array]:
        geometries = [member.geometry for member in self.members]
        return np.array([first for first, _ in geometries]), np.array(
            [slopes for _, slopes in geometries]
        )

    @property
    def geometry_slopes(self) -> Array:
        """Slopes of those distances, shape (members, parameters, wheels + 1)."""
        return self._geometry[1]

    def at(self, values: Array, *, slopes: bool = True) -> LinearModels:
        """Return models at values (members, parameters), SI, and their slopes."""
        wanted = np.asarray(values, dtype=float)
        key = wanted.tobytes(), slopes
        last: tuple[object, LinearModels] | None = self._last.get(
            "models"
        )  # results are reused for several roads
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
        models = [self._by_differences(row, slopes=slopes) for row in p]
        return side_by_side([model for model, _ in models]), side_by_side(
            [along for _, along in models]
        )

    @cached_property
    def _parameters(self) -> Array:
        """Model parameters of each rig, shape (members, parameters)."""
        compiled = self.first.compiled
        return np.array(
            [compiled.parameter_values(member.rig.parameters()) for member in self.members]
        )

    @cached_property
    def _places(self) -> list[int | None]:
        """Index of each free parameter among the model's; None if the model does not depend on it."""
        known = self.first.compiled.facts.parameters
        return [known.index(path) if path in known else None for path in self.first.paths]

    def _exactly(self, p: Array, *, slopes: bool) -> tuple[Matrices, Matrices]:
        compiled = self.first.compiled
        graphs, u = _graphs(compiled, self.first.rig), np.tile(compiled.inputs(0.0), (len(p), 1))
        x, modes = rests_for_small_motions(compiled, graphs.rest, p, u)
        model = self._reshape(graphs.values(x, u, p, modes))
        count = len(self._places) if slopes else 0
        if not count:
            return model, _none_of(model)
        directions = np.zeros((len(p), count, p.shape[1]))
        for i, place in enumerate(self._places):
            if place is not None:
                directions[:, i, place] = 1.0
        dp = directions.reshape(-1, p.shape[1])
        where = [np.repeat(part, count, axis=0) for part in (x, u, p, modes)]
        push = graphs.push(*where, dp)[0].reshape(len(p), count, -1)
        inverse = np.linalg.pinv(
            model.A, rcond=len(model.A[0]) * np.finfo(float).eps
        )  # neutral motions stay fixed
        dx = -np.einsum("sij,snj->sni", inverse, push).reshape(-1, x.shape[1])
        along = graphs.along(*where, dx, dp)
        return model, self._reshape(
            [part.reshape(len(p), count, *part.shape[1:]) for part in along]
        )

    def _reshape(self, parts: Sequence[Array]) -> Matrices:
        a, b, c, d, static = parts
        order, wheels = self.first.compiled.facts.track_order, len(self.first.wheels)
        b3, d3 = (
            np.moveaxis(part.reshape(*part.shape[:-1], wheels, order), -1, -3) for part in (b, d)
        )
        return Matrices(a, b3, c, d3, static.reshape((*static.shape[: a.ndim - 2], -1)))

    def _by_differences(self, p: Array, *, slopes: bool) -> tuple[Matrices, Matrices]:
        """Return the model of one member and its slopes."""
        model, (pose, free) = self._numeric(p)
        weights = (1.0, -8.0, 8.0, -1.0)
        slope_matrices: list[Matrices] = []
        for place in self._places if slopes else ():
            step = _STEP * (abs(p[place]) or 1.0) if place is not None else 1.0
            sides = []
            for count in (-2, -1, 1, 2):
                changed = p.copy()
                if place is not None:
                    changed[place] += count * step
                sides.append(self._numeric(changed, pose, free)[0])
            slope_matrices.append(
                Matrices(
                    *(
                        sum(w * getattr(side, name) for w, side in zip(weights, sides, strict=True))
                        / (12.0 * step)
                        for name in PARTS
                    )
                )
            )
        return model, side_by_side(slope_matrices) if slope_matrices else _none_of(model[None])[0]

    def _numeric(
        self, p: Array, pose: Array | None = None, free: NDArray[np.intp] | None = None
    ) -> tuple[Matrices, tuple[Array, NDArray[np.intp]]]:
        """Return the model about equilibrium in terms of some ``free`` speeds, that pose, and those speeds.

        ``pose`` is the initial value of the search. Compared models need the same free speeds, because the best choice
        differs between poses.
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
        return self._reshape(parts), (equilibrium.x[: compiled.facts.counts[0]], free)


def _none_of(model: Matrices) -> Matrices:
    """Return empty slopes for models (members, ...): no parameters."""
    return Matrices(
        *(
            np.zeros((len(part), 0, *part.shape[1:]))
            for part in (getattr(model, name) for name in PARTS)
        )
    )


def _places(rig: Rig, wheels: Sequence[str]) -> tuple[Place, ...]:
    known: Mapping[str, Place] = rig.wheels if isinstance(rig, Vehicle) else {}
    return tuple(known.get(wheel, Place(0.0, 0)) for wheel in wheels)


def _geometry(rig: Rig, wheels: Sequence[str]) -> Array:
    return np.array([*(place.behind for place in _places(rig, wheels)), track_width(rig)])


def _road_columns(compiled: Compiled) -> list[int]:
    facts = compiled.facts
    order = facts.track_order
    return [
        i * order + j
        for i, track in enumerate(facts.tracks)
        if is_road(track)
        for j in range(order)
    ]


@dataclass(frozen=True)
class _Graphs:
    """Graphs of a model: matrices, force along a parameter at rest, and change of the matrices along a direction.

    ``rest`` computes rates, their slopes by the states, and switches.
    """

    rest: _Each
    values: _Each
    push: _Each
    along: _Each


_graphs_of: Recent[_Graphs] = Recent()


def _graphs(compiled: Compiled, rig: Rig) -> _Graphs:
    return _graphs_of.of((type(rig).__name__, structure_of(rig)), lambda: _build_graphs(compiled))


def _build_graphs(compiled: Compiled) -> _Graphs:
    import casadi as ca

    model = compiled.model
    columns = _road_columns(compiled)
    by_x = ca.jacobian(ca.vertcat(model.rate, model.output), model.x)
    by_u = ca.jacobian(ca.vertcat(model.rate, model.output), model.u)[:, columns]
    n = model.x.shape[0]
    parts = [
        ca.densify(part)
        for part in (by_x[:n, :], by_u[:n, :], by_x[n:, :], by_u[n:, :], model.output)
    ]
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
        _Each(
            "rest", where, [ca.densify(part) for part in (model.rate, by_x[:n, :], model.switch)]
        ),
        _Each("values", where, parts),
        _Each("push", [*where, dp], [push]),
        _Each("along", [*where, dx, dp], changes),
    )


class _Each:
    """A function of vectors, called for many rows (members, size) at once: results (members, rows, columns).

    Each call uses its own workspace, so threads never share one, and releases it for the next call.
    """

    def __init__(self, name: str, given: list[Any], results: list[Any]) -> None:
        import casadi as ca

        self._function = ca.Function(name, given, results)
        self._ready: dict[int, list[tuple[Any, Any, list[Array], list[Array]]]] = {}

    def __call__(self, *given: Array) -> list[Array]:
        free = self._ready.setdefault(len(given[0]), [])
        try:
            workspace = free.pop()
        except IndexError:
            workspace = self._workspace(len(given[0]))
        _, call, into, outputs = workspace
        for place, values in zip(into, given, strict=True):
            place[:] = values
        call()
        results = [np.swapaxes(part, 1, 2).copy() for part in outputs]
        free.append(workspace)
        return results

    def _workspace(self, count: int) -> tuple[Any, Any, list[Array], list[Array]]:
        """Allocate for ``count`` rows; stacked rows are CasADi's consecutive columns, so nothing is transposed."""
        function = self._function.map(count)
        plain = self._function
        buffer, call = function.buffer()
        into = [np.zeros((count, plain.size1_in(i))) for i in range(plain.n_in())]
        outputs = [
            np.zeros((count, plain.size2_out(i), plain.size1_out(i))) for i in range(plain.n_out())
        ]
        for i, place in enumerate(into):
            buffer.set_arg(i, place.data)
        for i, place in enumerate(outputs):
            buffer.set_res(i, place.data)
        return buffer, call, into, outputs


# models without motions that the road never excites -------------------------------------------------------------------


_NEUTRAL = 1e-6  # share of the largest eigenvalue: rounding of a double zero eigenvalue (root of 1e-16), times 100
_UNREACHED = 1e-7  # share of the road's input: above rounding, far below any road force


def has_neutral(values: Complex) -> bool:
    """Whether any model has a motion that neither grows nor decays, by the eigenvalues (..., n)."""
    bound = -_NEUTRAL * np.max(np.abs(values), axis=-1, initial=0.0)
    return bool(values.shape[-1]) and bool(np.any(np.max(values.real, axis=-1) >= bound))


def without_unreached(model: Matrices, slopes: Matrices) -> tuple[Matrices, Matrices]:
    """Return a model and its slopes (numbers, ...) without neutral motions; unchanged if the road excites those."""
    values = np.asarray(np.linalg.eigvals(model.A), dtype=np.complex128)
    if not has_neutral(values):
        return model, slopes
    from scipy.linalg import schur

    bound = -_NEUTRAL * float(np.max(np.abs(values), initial=0.0))
    form, basis, count = schur(model.A, output="real", sort=lambda real, _: real < bound)
    if count == len(form):
        return model, slopes
    reached, unreached = basis[:, :count], basis[:, count:]
    for b in model.B:
        if np.max(np.abs(unreached.T @ b), initial=0.0) > _UNREACHED * max(
            float(np.max(np.abs(b), initial=0.0)), 1.0
        ):
            return model, slopes
    reduced = _reduce(model, reached)
    along = [
        _reduce_slope(model, slopes[k], form, reached, unreached) for k in range(len(slopes.A))
    ]
    return reduced, side_by_side(along) if along else _none_of(reduced[None])[0]


def _reduce(model: Matrices, reached: Array) -> Matrices:
    b = np.stack([reached.T @ part for part in model.B])
    return Matrices(reached.T @ model.A @ reached, b, model.C @ reached, model.D, model.static)


def _reduce_slope(
    model: Matrices, along: Matrices, form: Array, reached: Array, unreached: Array
) -> Matrices:
    """Return the slope of the reduced model, including the rotation of the subspace with the parameter."""
    from scipy.linalg import solve_sylvester

    count = reached.shape[1]
    turn = solve_sylvester(
        form[count:, count:], -form[:count, :count], -unreached.T @ along.A @ reached
    )
    reduced = _reduce(along, reached)
    a, c = (
        reduced.A + reached.T @ model.A @ unreached @ turn,
        reduced.C + model.C @ unreached @ turn,
    )
    return Matrices(a, reduced.B, c, reduced.D, reduced.static)
