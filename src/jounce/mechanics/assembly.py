"""Assembly: find a pose that closes all loops from a rough one; report changed coordinates and faulty joints.

It evaluates the symbolic model with CasADi, before anything is compiled.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from jounce.core.errors import AssemblyError, unknown
from jounce.core.remembered import once_per_object
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.mechanics.facts import Equation
from jounce.mechanics.model import Model

_ITERATIONS = 100  # maximum of damped Newton steps: rough poses are far from closed
_ALSO_OPEN = 0.05  # a joint is also named if its gap is at least this share of the widest; a choice
_CLOSED = 1e-12  # m or rad: rounding of positions of a few metres
_HELD = (
    0.0,
    1e-3,
)  # compliance of a given coordinate relative to the others: fixed, otherwise stiff
_DEPENDENT = 1e-9  # singular value of the loop equations, relative to the largest, below which one is redundant
_NO_SLOPE = 1e-12  # m, 1: below this slope an equation has no effect in this pose
_FIRM = (
    1e-2  # singular value above which equations without their redundant ones are well conditioned
)
_PART = 1e-6  # an equation is named if its share in a dependence is at least this
_NUDGE = (
    1e-3  # m or rad: motion that tells a singular pose from equations that are redundant everywhere
)
_MOVED = 1e-9  # m or rad: larger changes of a coordinate are reported
_KEPT = 1e-10  # rate at which the loops may still open, relative to the speeds

_Groups = tuple[tuple[Equation, ...], ...]
"""Groups of loop equations; one in each group follows from the others."""


@dataclass(frozen=True)
class Displacement:
    """A coordinate, or a given speed, that assembly changed.

    Attributes
    ----------
    coordinate : str
        Its name.
    before, after : float
        Value before and after, m or rad, m/s or rad/s.
    """

    coordinate: str
    before: float
    after: float


@dataclass(frozen=True)
class Assembly:
    """A pose that closes all loops.

    Attributes
    ----------
    x : ndarray, shape (n,)
        States, SI: coordinates, speeds, internal states.
    displacements : tuple of Displacement
        Coordinates that differ from their given or design values, and speeds that differ from their given values.
    redundant : tuple of tuple of str
        Groups of redundant loop equations.
    freedom : int
        Number of free motions.
    """

    x: Array
    displacements: tuple[Displacement, ...]
    redundant: tuple[tuple[str, ...], ...]
    freedom: int


@once_per_object
def _loops_of(model: Model) -> ca.Function:
    """Return a function for the loop equations of a model and the other results of :meth:`Evaluator.at`."""
    n_q, n_v = model.facts.counts
    q, v = model.x[:n_q], model.x[n_q : n_q + n_v]
    kinematics = ca.jacobian(model.rate[:n_q], v)
    slope = ca.jacobian(model.constraint, q)
    drift, order = ca.SX(model.constraint.shape[0], 1), model.track_order
    for i in range(order - 1 if model.tracks else 0):
        drift += ca.jtimes(model.constraint, model.u[i::order], model.u[i + 1 :: order])
    inputs = [model.x, model.u, model.p]
    return ca.Function("loops", inputs, [model.constraint, slope @ kinematics, kinematics, drift])


class Evaluator:
    """Evaluates a model's loop equations for fixed parameters and inputs."""

    def __init__(self, model: Model, p: Array, u: Array) -> None:
        self.model, self.p, self.u = model, p, u
        self.n_q, self.n_v = model.facts.counts
        self._functions = _loops_of(model)

    def at(self, x: Array) -> tuple[Array, Array, Array, Array]:
        """Return residual, its slope and the coordinates' rates by the speeds, and the drift by the inputs' rates."""
        value, slope, kinematics, drift = (
            part.full() for part in self._functions(x, self.u, self.p)
        )
        return value[:, 0], slope, kinematics, drift[:, 0]

    def move(self, x: Array, displacement: Array) -> Array:
        """Return the states after a small displacement, with quaternions normalised."""
        result = x.copy()
        result[: self.n_q] += self.at(x)[2] @ displacement
        _normalise(self.model, result)
        return result


def assemble(
    model: Model,
    p: Array,
    u: Array,
    start: Mapping[str, float | str] | None = None,
    *,
    redundant: str = "refuse",
) -> Assembly:
    """Find a pose near the start that closes all loops, and speeds that keep them closed.

    Parameters
    ----------
    model : Model
        The equations.
    p, u : ndarray
        Parameters and inputs, SI.
    start : mapping, optional
        Known coordinates (m, rad) and speeds (m/s, rad/s) by name, or text with a unit; these are changed as little
        as possible. Quaternions are normalised.
    redundant : {"refuse", "keep"}
        Treatment of redundant loop equations.

    Returns
    -------
    Assembly
        States, changed coordinates, redundant equations, number of free motions.

    Raises
    ------
    AssemblyError
        If the loops cannot be closed, are redundant, or are singular in this pose; the message names the joints.
    """
    if redundant not in ("refuse", "keep"):
        raise unknown(redundant, ("refuse", "keep"), what="choice", where="redundant")
    given = _read_start(model, start or {})
    x = np.zeros(model.x.shape[0])
    x[: len(model.start)] = model.start
    first = np.array([given.get(name, value) for name, value in zip(model.states, x, strict=True)])
    _normalise(model, first)
    if not model.constraints:
        return Assembly(first, (), (), len(model.speeds))
    evaluator = Evaluator(model, p, u)
    pose, weights = _closed_near(evaluator, first, given)
    _, slope, _, drift = evaluator.at(pose)
    groups = _dependences(slope, model.equations)
    if groups and redundant == "refuse":
        _explain(evaluator, pose, groups)
    pose = _with_speeds(evaluator, pose, slope, drift, weights)
    named = tuple(tuple(equation.name for equation in group) for group in groups)
    freedom = slope.shape[1] - slope.shape[0] + len(groups)
    return Assembly(pose, _displacements(model, first, pose, given), named, freedom)


def _read_start(model: Model, start: Mapping[str, float | str]) -> dict[str, float]:
    """Start values in SI."""
    units, given = dict(zip(model.states, model.units, strict=False)), {}
    for name, value in start.items():
        if name not in model.states:
            raise unknown(name, model.states, what="coordinate or speed", where="start")
        given[name] = to_si(value, units.get(name, "1"), where=f"start: {name}")
    return given


def _normalise(model: Model, x: Array) -> None:
    """Normalise all quaternions of a state, in place."""
    for joint, i in model.quaternions.items():
        length = np.linalg.norm(x[i : i + 4])
        if not length > 0.0:
            raise AssemblyError(
                "no orientation",
                where=joint,
                found="a quaternion of zeros",
                allowed="e0 to e3 of the orientation",
            )
        x[i : i + 4] /= length


def orientation(joint: str, axis: Sequence[float], angle: float | str) -> dict[str, float]:
    """Return the start of a rotated spherical joint or free body as a quaternion.

    Parameters
    ----------
    joint : str
        Its name.
    axis : sequence of float, shape (3,)
        Axis of the rotation, ground axes, of any length (1).
    angle : float or str
        rad, or text with a unit; right-handed.

    Returns
    -------
    dict
        Coordinate to value (1), for ``start``.

    Raises
    ------
    AssemblyError
        If the axis is zero.

    Examples
    --------
    >>> {name: round(value, 3) for name, value in orientation("tip", axis=(0, 2, 0), angle="90 deg").items()}
    {'tip.e0': 0.707, 'tip.e1': 0.0, 'tip.e2': 0.707, 'tip.e3': 0.0}
    """
    along = np.array([float(part) for part in axis])
    length = float(np.linalg.norm(along))
    if along.shape != (3,) or not (np.isfinite(length) and length > 0.0):
        raise AssemblyError("an axis without direction", where=joint, found=tuple(axis))
    half = 0.5 * to_si(angle, "rad", where=f"angle of {joint}")
    parts = (np.cos(half), *(np.sin(half) * along / length))
    return {f"{joint}.e{i}": float(part) for i, part in enumerate(parts)}


def removable(
    model: Model,
    p: Array,
    u: Array,
    start: Mapping[str, float | str] | None = None,
    known: Iterable[frozenset[str]] = (),
) -> frozenset[str]:
    """Return loop equations that are redundant at a pose; reuse the choices ``known`` if they still apply.

    Refuses loops that cannot be closed, and singular configurations, where redundancy is undecidable.
    """
    from scipy.linalg import qr

    x = assemble(model, p, u, start, redundant="keep").x
    evaluator = Evaluator(model, p, u)
    slope = evaluator.at(x)[1]
    groups = _dependences(slope, model.equations)
    if not groups:
        return frozenset()
    scaled = slope / np.maximum(np.linalg.norm(slope, axis=1), 1e-300)[:, None]
    for dropped in known:
        remaining = np.array([name not in dropped for name in model.constraints])
        if (
            np.sum(remaining) + len(groups) == len(remaining)
            and np.linalg.svd(scaled[remaining])[1][-1] > _FIRM
        ):
            return dropped
    if _is_singular_here_only(evaluator, x, len(groups)):
        raise _singular(groups)
    _, triangle, order = qr(scaled.T, pivoting=True, mode="economic")
    rank = int(np.sum(np.abs(np.diag(triangle)) > _DEPENDENT * abs(triangle[0, 0])))
    return frozenset(model.constraints[i] for i in order[rank:])


def refuse_singular(model: Model, x: Array, u: Array, p: Array) -> None:
    """Refuse a closed pose in which loop equations are redundant although they are independent nearby."""
    evaluator = Evaluator(model, p, u)
    groups = _dependences(evaluator.at(x)[1], model.equations) if model.constraints else ()
    if groups and _is_singular_here_only(evaluator, x, len(groups)):
        raise _singular(groups)


def _closed_near(
    evaluator: Evaluator, first: Array, given: Mapping[str, float]
) -> tuple[Array, tuple[Array, ...]]:
    """Close the loops with given coordinates fixed or, if necessary, slightly changed; also return the compliances."""
    weights = tuple(_weights(evaluator.model, given, held) for held in _HELD)
    try:
        return close_loops(evaluator, first, weights[0]), weights
    except AssemblyError:
        return close_loops(evaluator, first, weights[1]), weights


def _weights(model: Model, given: Mapping[str, float], held: float) -> Array:
    """Return the compliance of each speed's motion; ``held`` for given coordinates and speeds."""
    n_q, n_v = model.facts.counts
    weights = np.ones(n_v)
    slope = ca.Function(
        "slope", [model.x], [ca.jacobian(model.rate[:n_q], model.x[n_q : n_q + n_v])]
    )
    pattern = np.abs(slope(np.ones(model.x.shape[0])).full()) > 0.0
    for name in given:
        if name in model.coordinates:
            weights[pattern[model.coordinates.index(name)]] = held
        elif name in model.speeds:
            weights[model.speeds.index(name)] = held
    return weights


def close_loops(evaluator: Evaluator, x: Array, weights: Array) -> Array:
    """Solve the loop equations by damped Newton steps of minimum weighted norm."""
    value, slope, _, _ = evaluator.at(x)
    _refuse_undefined(evaluator.model, value, slope)
    for _ in range(_ITERATIONS):
        if np.max(np.abs(value), initial=0.0) < _CLOSED:
            return x
        step = -weights * np.linalg.lstsq(slope * weights, value, rcond=1e-12)[0]
        share, better = 1.0, None
        while share > 1e-4:  # thirteen halvings: shorter steps make no progress
            trial = evaluator.move(x, share * step)
            closer = evaluator.at(trial)
            if np.linalg.norm(closer[0]) < np.linalg.norm(value):
                better = trial, closer
                break
            share *= 0.5
        if better is None:
            break
        x, (value, slope, _, _) = better
    if float(np.max(np.abs(value))) < 1e-9:  # m or rad: as far as rounding lets the steps come
        return x
    raise _open(evaluator.model, value)


def _refuse_undefined(model: Model, value: Array, slope: Array) -> None:
    """Refuse loop equations that are not finite, such as those with an axis set to zero by a parameter."""
    broken = ~(np.isfinite(value) & np.all(np.isfinite(slope), axis=1))
    if np.any(broken):
        joints = dict.fromkeys(
            equation.joint for equation, no in zip(model.equations, broken, strict=True) if no
        )
        hint = "Check the axes and positions of the joints in its loop, and the motions."
        raise AssemblyError(
            "the loop cannot be computed", where=", ".join(joints), found="not a number", hint=hint
        )


def _open(model: Model, value: Array) -> AssemblyError:
    """Return the error that names the open loops, the widest first."""
    order = np.argsort(-np.abs(value))
    worst = [
        model.equations[i] for i in order if abs(value[i]) > _ALSO_OPEN * abs(value[order[0]])
    ][:6]
    joints = list(dict.fromkeys(equation.joint for equation in worst))
    pairs = list(zip(model.equations, value, strict=True))
    shown = [
        _gap(joint, [(e.unit, float(x)) for e, x in pairs if e.joint == joint]) for joint in joints
    ]
    return AssemblyError(
        "the mechanism cannot be assembled",
        where=", ".join(joints),
        found=", ".join(shown),
        allowed="closed loops",
        hint="Check the positions of these joints, or give coordinates closer to the desired pose.",
    )


def _gap(joint: str, rows: list[tuple[str, float]]) -> str:
    """Describe the gap of an open joint: a distance, else an angle, else the residual of its equation."""
    place, turn = (
        float(np.linalg.norm([value for own, value in rows if own == unit]))
        for unit in ("m", "rad")
    )
    if place > _ALSO_OPEN * turn:  # m, rad
        return f"{joint} has a gap of {place:.4g} m"
    if turn > 0.0:
        return f"{joint} is misaligned by {np.degrees(np.arcsin(min(turn, 1.0))):.4g} degrees"
    return (
        f"{joint} violates its condition by {abs(rows[0][1]):.4g} (a rod by that half of the "
        "square of its length, m^2)"
    )


def _dependences(slope: Array, equations: tuple[Equation, ...]) -> _Groups:
    """Return groups of equations in each of which one follows from the others."""
    scale = np.linalg.norm(slope, axis=1)
    groups = [(equations[i],) for i in np.flatnonzero(scale <= _NO_SLOPE)]
    rows = np.flatnonzero(scale > _NO_SLOPE)
    if not len(rows):
        return tuple(groups)
    left, values, _ = np.linalg.svd(slope[rows] / scale[rows, None])
    rank = int(np.sum(values > _DEPENDENT * values[0]))
    null = left[:, rank:]
    while null.shape[1]:
        row = int(np.argmax(np.max(np.abs(null), axis=1)))
        column = int(np.argmax(np.abs(null[row])))
        direction = null[:, column] / null[row, column]
        groups.append(tuple(equations[rows[i]] for i in np.flatnonzero(np.abs(direction) > _PART)))
        null = np.delete(null - np.outer(direction, null[row]), column, axis=1)
        if null.shape[1]:
            null = np.linalg.qr(null)[0]
    return tuple(groups)


def motions_left(slope: Array) -> Array:
    """Return orthonormal motions of the speeds that keep all loops closed, shape (n, f)."""
    if not slope.shape[0]:
        return np.eye(slope.shape[1])
    sizes = np.linalg.norm(slope, axis=1)
    _, values, rows = np.linalg.svd(slope / np.where(sizes > _NO_SLOPE, sizes, 1.0)[:, None])
    return np.asarray(rows[int(np.sum(values > _DEPENDENT * max(values[0], _NO_SLOPE))) :].T)


def _explain(evaluator: Evaluator, pose: Array, groups: _Groups) -> None:
    """Refuse a singular pose and redundant equations."""
    if _is_singular_here_only(evaluator, pose, len(groups)):
        raise _singular(groups)
    loops, joints = evaluator.model.loops, _joints_of(groups)
    around = dict.fromkeys(
        other for group in groups for equation in group for other in loops.get(equation.joint, ())
    )
    place = f" in the loop of {', '.join(around)}" if around else ""
    listed = "; ".join(", ".join(equation.name for equation in group) for group in groups)
    raise AssemblyError(
        "redundant joints: their constraints are dependent",
        where="; ".join(joints),
        found=f"{_count(groups, 'superfluous equation')} ({listed}){place}",
        hint=(
            "Replace one of them by a joint with more freedom (a spherical joint for a revolute "
            'joint), or set redundant="remove".'
        ),
    )


def _singular(groups: _Groups) -> AssemblyError:
    return AssemblyError(
        "the mechanism is in a singular configuration: its loops do not determine its further motion",
        where="; ".join(_joints_of(groups)),
        found=f"{_count(groups, 'equation')} that repeat others in this pose only",
        hint="Start away from the pose in which the links are collinear.",
    )


def _joints_of(groups: _Groups) -> list[str]:
    """Return the joints of each group of equations, each joint once."""
    return list(
        dict.fromkeys(
            ", ".join(dict.fromkeys(equation.joint for equation in group)) for group in groups
        )
    )


def _count(groups: _Groups, what: str) -> str:
    return f"{len(groups)} {what}{'s' if len(groups) > 1 else ''}"


def _is_singular_here_only(evaluator: Evaluator, pose: Array, count: int) -> bool:
    """Whether the equations become independent after a small step along each motion of the mechanism."""
    _, slope, _, _ = evaluator.at(pose)
    for motion in motions_left(slope).T:
        for way in (_NUDGE, -_NUDGE):
            try:
                near = close_loops(
                    evaluator, evaluator.move(pose, way * motion), np.ones(len(motion))
                )
            except AssemblyError:
                return True
            if np.linalg.norm(near - pose) < 0.1 * _NUDGE:
                return True  # the loops prevent this motion
            fewer = len(_dependences(evaluator.at(near)[1], evaluator.model.equations))
            if fewer < count:
                return True
    return False


def _with_speeds(
    evaluator: Evaluator, pose: Array, slope: Array, drift: Array, weights: tuple[Array, ...]
) -> Array:
    """Return speeds that keep the loops closed, with the given ones unchanged if possible."""
    n_q, n_v = evaluator.n_q, evaluator.n_v
    driven = pose.copy()
    speeds = pose[n_q : n_q + n_v]
    for each in weights:
        change = each * np.linalg.lstsq(slope * each, slope @ speeds + drift, rcond=1e-12)[0]
        driven[n_q : n_q + n_v] = speeds - change
        if np.max(np.abs(slope @ driven[n_q : n_q + n_v] + drift)) < _KEPT * max(
            1.0, float(np.max(np.abs(speeds)))
        ):
            break
    return driven


def _displacements(
    model: Model, before: Array, after: Array, given: Iterable[str]
) -> tuple[Displacement, ...]:
    """Return the coordinates and given speeds that changed."""
    shown = {*model.coordinates, *given}
    each = [
        Displacement(name, float(a), float(b))
        for name, a, b in zip(model.states, before, after, strict=True)
    ]
    return tuple(
        displacement
        for displacement in each
        if displacement.coordinate in shown
        and abs(displacement.before - displacement.after)
        > _MOVED * max(1.0, abs(displacement.before))
    )
