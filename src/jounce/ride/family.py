"""Linear models as functions of a rig's numbers: matrices about static equilibrium, and their exact slopes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from jounce.core.errors import JounceError, SimulationError
from jounce.core.types import Array
from jounce.mechanics.facts import ROAD, is_road
from jounce.parts import Rig
from jounce.parts.rig import structure_of, unknown_path
from jounce.parts.vehicles import Place, Vehicle
from jounce.simulation.compiled import Compiled, compile_rig
from jounce.simulation.statics import Equilibrium, find_equilibrium, for_small_motions

_STEP = 1e-3  # relative, of differences for mechanisms


@dataclass(frozen=True)
class Matrices:
    """Linear model, or its slope along one number: ``dx/dt = A x + sum_j B_j d^j z/dt^j``, ``y = C x + D z ...``, SI.

    ``A`` (n, n) and ``C`` (outputs, n) act on the states, ``B`` (order, n, wheels) and ``D`` (order, outputs, wheels)
    on the heights of the road under the wheels and their time derivatives; ``static`` holds the static values of the
    outputs.
    """

    A: Array
    B: Array
    C: Array
    D: Array
    static: Array

    def of_rows(self, rows: Sequence[int]) -> Matrices:
        """The model with some of its outputs only."""
        chosen = list(rows)
        return Matrices(self.A, self.B, self.C[chosen], self.D[:, chosen], self.static[chosen])


@dataclass(frozen=True)
class LinearFamily:
    """Linear models of one rig for any values of some of its numbers, the ``paths``; the rig gives all others."""

    rig: Rig
    paths: tuple[str, ...] = ()
    _last: dict[str, Any] = field(default_factory=dict, init=False, repr=False, compare=False)

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
        if not isinstance(self.rig, Vehicle):
            return np.zeros_like(first)
        value = self.rig.parameters()[path]
        step = 0.5 * abs(value) or 1.0
        try:
            other = self.rig.with_changes({path: value + step})
        except JounceError:  # the other side is allowed then
            step = -step
            other = self.rig.with_changes({path: value + step})
        return np.asarray((_geometry(other, self.wheels) - first) / step)

    def at(self, values: Array | None = None, *, slopes: bool = True) -> tuple[Matrices, tuple[Matrices, ...]]:
        """Model at some values (SI) of the numbers, those of the rig by default, and its slope along each of them."""
        wanted = np.asarray(self.start if values is None else values, dtype=float)
        key = wanted.tobytes(), slopes
        last = self._last.get("model")  # which several roads ask for
        if last is None or last[0] != key:
            last = self._last["model"] = key, self._at(wanted, slopes)
        return last[1]

    def _at(self, values: Array, slopes: bool) -> tuple[Matrices, tuple[Matrices, ...]]:
        given = dict(zip(self.paths, values, strict=True))
        compiled = self.compiled
        p = compiled.parameter_values({**self.rig.parameters(), **{path: float(v) for path, v in given.items()}})
        if compiled.facts.projects:
            return self._by_differences(p, slopes=slopes)
        return self._exactly(p, slopes=slopes)

    def _used(self, path: str) -> int | None:
        """Place of a number among the model's parameters; None where the model does not feel it."""
        known = self.compiled.facts.parameters
        return known.index(path) if path in known else None

    def _exactly(self, p: Array, *, slopes: bool) -> tuple[Matrices, tuple[Matrices, ...]]:
        compiled = self.compiled
        graphs, u = _graphs(compiled, self.rig), compiled.inputs(0.0)
        equilibrium = _balanced(compiled, p, u)
        modes = equilibrium.modes
        parts = [np.asarray(part) for part in graphs.values(equilibrium.x, u, p, modes)]
        model = self._shaped(parts)
        found: list[Matrices] = []
        for path in self.paths if slopes else ():
            place, dp = self._used(path), np.zeros(len(p))
            if place is not None:
                dp[place] = 1.0
            push = np.asarray(graphs.push(equilibrium.x, u, p, modes, dp)).ravel()
            dx = -np.linalg.lstsq(model.A, push, rcond=None)[0]
            along = graphs.along(equilibrium.x, u, p, modes, dx, dp)
            found.append(self._shaped([np.asarray(part) for part in along]))
        return model, tuple(found)

    def _shaped(self, parts: Sequence[Array]) -> Matrices:
        a, b, c, d, static = parts
        order, wheels = self.compiled.facts.track_order, len(self.wheels)
        b3, d3 = (np.moveaxis(part.reshape(len(part), wheels, order), 2, 0) for part in (b, d))
        return Matrices(a, b3, c, d3, static.ravel())

    def _by_differences(self, p: Array, *, slopes: bool) -> tuple[Matrices, tuple[Matrices, ...]]:
        model, pose = self._numeric(p)
        found: list[Matrices] = []
        for path in self.paths if slopes else ():
            place = self._used(path)
            step = _STEP * (abs(p[place]) or 1.0) if place is not None else 1.0
            sides = []
            for count in (-2, -1, 1, 2):
                moved = p.copy()
                if place is not None:
                    moved[place] += count * step
                sides.append(self._numeric(moved, pose)[0])
            weights = (1.0, -8.0, 8.0, -1.0)
            names = ("A", "B", "C", "D", "static")
            found.append(
                Matrices(
                    *(
                        sum(w * getattr(side, name) for w, side in zip(weights, sides, strict=True)) / (12.0 * step)
                        for name in names
                    )
                )
            )
        return model, tuple(found)

    def _numeric(self, p: Array, pose: Array | None = None) -> tuple[Matrices, Array]:
        """Model about equilibrium, sought from a pose, and the pose found."""
        compiled, u = self.compiled, self.compiled.inputs(0.0)
        equilibrium = _balanced(compiled, p, u, pose)
        where = (equilibrium.x, u, p, equilibrium.modes)
        across, along = compiled.slopes("x", *where), compiled.slopes("u", *where)
        columns = _road_columns(compiled)
        parts = [
            equilibrium.pick @ across["rate"] @ equilibrium.lift,
            equilibrium.pick @ along["rate"][:, columns],
            across["output"] @ equilibrium.lift,
            along["output"][:, columns],
            compiled.evaluate("output", *where),
        ]
        return self._shaped(parts), equilibrium.x[: compiled.facts.counts[0]]


def _places(rig: Rig, wheels: Sequence[str]) -> tuple[Place, ...]:
    known: Mapping[str, Place] = rig.wheels if isinstance(rig, Vehicle) else {}
    return tuple(known.get(wheel, Place(0.0, 0)) for wheel in wheels)


def _geometry(rig: Rig, wheels: Sequence[str]) -> Array:
    return np.array([*(place.behind for place in _places(rig, wheels)), _track_width(rig)])


def _track_width(rig: Rig) -> float:
    """Mean distance between left and right wheels, m; 0 where there is only one side."""
    widths = []
    for name in ("front", "rear"):
        axle = getattr(rig, name, None)
        corner = getattr(axle, "corner", None)
        if corner is not None:
            widths.append(2.0 * abs(corner.hardpoints.wheel_centre[1]))
        else:
            widths.append(getattr(axle, "track", 0.0))
    return float(np.mean(widths))


def _road_columns(compiled: Compiled) -> list[int]:
    facts = compiled.facts
    order = facts.track_order
    return [i * order + j for i, track in enumerate(facts.tracks) if is_road(track) for j in range(order)]


def _balanced(compiled: Compiled, p: Array, u: Array, pose: Array | None = None) -> Equilibrium:
    """Static equilibrium, as small motions see it."""
    equilibrium = find_equilibrium(compiled, p, u, pose)
    if not np.all(np.isfinite(equilibrium.x)):
        raise SimulationError("no static equilibrium was found", where="linear model")
    return for_small_motions(compiled, equilibrium, p, u)


@dataclass(frozen=True)
class _Graphs:
    """Matrices of a model, what pushes it from rest along a parameter, and the matrices' change along a direction."""

    values: Any
    push: Any
    along: Any


_made: dict[tuple[str, str], _Graphs] = {}


def _graphs(compiled: Compiled, rig: Rig) -> _Graphs:
    key = type(rig).__name__, structure_of(rig)
    if key not in _made:
        _made[key] = _built(compiled)
    return _made[key]


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
        ca.Function("values", where, parts),
        ca.Function("push", [*where, dp], [push]),
        ca.Function("along", [*where, dx, dp], changes),
    )


# without motions that the road never reaches --------------------------------------------------------------------------


_NEUTRAL = 1e-6  # of the largest eigenvalue: rounding of a double eigenvalue at zero
_UNREACHED = 1e-7


def without_unreached(model: Matrices, slopes: Sequence[Matrices]) -> tuple[Matrices, list[Matrices]]:
    """A model and its slopes without neutral motions, or as they are where the road reaches those."""
    values = np.linalg.eigvals(model.A)
    bound = -_NEUTRAL * float(np.max(np.abs(values), initial=0.0))
    if not len(values) or float(np.max(values.real)) < bound:
        return model, list(slopes)
    from scipy.linalg import schur

    form, basis, count = schur(model.A, output="real", sort=lambda real, _: real < bound)
    if count == len(form):
        return model, list(slopes)
    kept, left = basis[:, :count], basis[:, count:]
    for b in model.B:
        if np.max(np.abs(left.T @ b), initial=0.0) > _UNREACHED * max(float(np.max(np.abs(b), initial=0.0)), 1.0):
            return model, list(slopes)
    found = _reduced(model, kept)
    return found, [_moved(model, part, form, kept, left) for part in slopes]


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
