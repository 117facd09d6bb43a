"""Static equilibrium, the free motions about it, and typical sizes of the states."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields
from functools import cache, cached_property

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import SimulationError
from jounce.core.remembered import Recent, once_per_object
from jounce.core.types import Array
from jounce.mechanics.facts import ModelFacts, is_road
from jounce.roads.trial import LOADS
from jounce.simulation.compiled import Compiled

_ITERATIONS = 60  # maximum of Newton steps; rigs of the library need up to 7
_SAGS = (
    0.0,
    1e-4,
    1e-3,
    1e-2,
    1e-1,
)  # m: initial compressions, for springs that are soft at first
_FAR = 1e3  # m: a step of this length means that nothing supports the weight
_UNDECIDED = 1e13  # condition number of the balance above which a part turns or slides freely: 1e-3 over rounding
_HEAVE = "sprung.distance"  # the coordinate that lowers a whole rig onto its tyre
_STRIDE = 0.05  # m or rad: a linkage is nearly linear within it
_STRIDES = 200  # ten metres in total
_TOGGLE = 10.0  # factor by which a strut's lever shrinks near a dead point of the linkage
_SLOWEST, _QUICKEST = 1.0, 1e16  # 1/s^2
_DRIFT = 1e-6  # 1/s^2: slower growth (by a factor of e in a quarter of an hour) counts as neutral
_SHARE_OF_FALL = 0.1  # share of the fastest speed in a fall: slower speeds are not named
_PROJECTIONS = 3  # Newton steps that close the loops after a stride
_UNBALANCED = 1e-6  # m/s^2: a ten-millionth of g
_ROUNDINGS = 8.0  # error of a balance of many terms, in roundings of one product
_PLACES = 1.0  # m, typical size of a hardpoint's coordinates
_EPSILON = float(np.finfo(float).eps)
_EDGE = 1e-12  # SI: a switch this close to zero is at its edge
_INDEPENDENT = 1e-9  # smallest singular value of independent constraints, relative to the largest


@dataclass(frozen=True)
class Equilibrium:
    """A state of rest and the linear map of small free motions about it.

    Attributes
    ----------
    x, modes : ndarray
        States and modes of the switches.
    slope : ndarray, shape (n, n)
        Jacobian of the rates.
    free : ndarray of int, shape (f,)
        Independent speeds; the loops determine the others.
    lift : ndarray, shape (n, r)
        Map from reduced states (displacements and speeds of the free motions, then internal states) to states.
    pick : ndarray, shape (r, n)
        Map from rates of the states to rates of the reduced states.
    reduced : ndarray, shape (r, r)
        Jacobian of the reduced states' rates.
    balance : ndarray, shape (d + k, d)
        Jacobian of the balance (rates that must vanish, loop equations) by the unknowns.
    moved : ndarray, shape (n, d)
        Map from unknowns to states: displacements by the speeds, and internal states that change at rest (a hysteretic
        state that changes only with the damper stays at zero).
    rows : ndarray of int
        Rates that must vanish.
    """

    x: Array
    modes: Array
    slope: Array
    free: NDArray[np.intp]
    lift: Array
    pick: Array
    reduced: Array
    balance: Array
    moved: Array
    rows: NDArray[np.intp]

    @cached_property
    def fastest_oscillation(self) -> float:
        """Highest undamped angular frequency of the free motions, rad/s."""
        f = len(self.free)
        return float(
            np.sqrt(np.max(np.abs(np.linalg.eigvals(self.reduced[f : 2 * f, :f])), initial=0.0))
        )

    @cached_property
    def fastest_decay(self) -> float:
        """Largest rate of a free motion, 1/s."""
        return float(np.max(np.abs(np.linalg.eigvals(self.reduced)), initial=0.0))


def find_equilibrium(
    compiled: Compiled, p: Array, u: Array, start: Array | None = None
) -> Equilibrium:
    """Find the static equilibrium for given inputs; recent equilibria of the model are cached.

    It is solved by :func:`_solve_equilibrium`; its arrays are read-only.
    """

    def make() -> Equilibrium:
        rest = _solve_equilibrium(compiled, p, u, start)
        for field in fields(rest):
            getattr(rest, field.name).setflags(write=False)
        return rest

    recent: Recent[Equilibrium] = compiled.equilibria
    return recent.of((p.tobytes(), u.tobytes(), None if start is None else start.tobytes()), make)


def for_small_motions(compiled: Compiled, rest: Equilibrium, p: Array, u: Array) -> Equilibrium:
    """Return the state of rest for linear models: a switch at its edge is averaged over its two sides.

    At rest a damper is neither in bump nor in rebound. In harmonic motion the mean of its two slopes dissipates the
    same energy; the same applies to a table with a point at zero velocity.
    """
    still = np.zeros_like(u)
    still[:: compiled.facts.track_order] = u[:: compiled.facts.track_order]
    edge = np.abs(compiled.evaluate("switch", rest.x, still, p, rest.modes)) < _EDGE
    halved = (
        _rest(compiled, rest.x, still, p, np.where(edge, 0.5, rest.modes)) if edge.any() else None
    )
    return rest if halved is None else halved


def in_terms_of(
    compiled: Compiled, rest: Equilibrium, free: NDArray[np.intp]
) -> tuple[Array, Array]:
    """Return ``lift`` and ``pick`` of a state of rest for other ``free`` speeds, such as those of a different state."""
    (n_q, n_v), count = compiled.facts.counts, len(rest.free)
    if np.array_equal(free, rest.free):
        return rest.lift, rest.pick
    motions = rest.lift[n_q : n_q + n_v, count : 2 * count]
    return _lift(
        rest.slope,
        n_q,
        n_v,
        free,
        np.asarray(motions @ np.linalg.inv(motions[free]), dtype=np.float64),
    )


def falling(compiled: Compiled, x: Array, u: Array, p: Array) -> list[str]:
    """Return the speeds of all motions in which a mechanism falls from a state of rest; empty if it is stable.

    Growth is uncertain by rounding of the stiffest springs' forces: slower growth may be neutral.
    """
    still = np.zeros_like(u)
    still[:: compiled.facts.track_order] = u[:: compiled.facts.track_order]
    now = _balance(compiled, x, still, p, compiled.sides(x, still, p))
    values, vectors = np.linalg.eig(now.pull)
    falls = values.real > max(_DRIFT, now.rounding(np.maximum(np.abs(x), _PLACES)))
    motions = np.abs(now.motions @ vectors[:, falls])
    named = np.any(motions > _SHARE_OF_FALL * np.max(motions, axis=0, initial=0.0), axis=1)
    return [compiled.facts.speeds[i] for i in np.flatnonzero(named)]


Balanced = Callable[[Array, Array, Array, Array], Sequence[Array]]
"""Function for rates (members, n, 1), slopes (members, n, n) and switches (members, k, 1) of many x, u, p and m."""


def rests_for_small_motions(
    compiled: Compiled, balanced: Balanced, p: Array, u: Array
) -> tuple[Array, Array]:
    """Return states of rest and modes as in :func:`for_small_motions` for many parameter sets, without loops.

    Newton's method runs for all (members, ...) at once; members that do not converge are solved one by one, with an
    error if there is no equilibrium. ``balanced`` returns the rates that must vanish.
    """
    x, modes = (
        np.zeros((len(p), compiled.state_count)),
        np.zeros((len(p), len(compiled.facts.switches))),
    )
    remaining = np.arange(len(p))
    for guess in _starts(compiled, u[0], None):
        states, sides, settled = _newton_side_by_side(
            compiled, balanced, p[remaining], u[remaining], guess
        )
        x[remaining[settled]], modes[remaining[settled]] = states[settled], sides[settled]
        remaining = remaining[~settled]
        if not len(remaining):
            break
    for k in remaining:
        rest = for_small_motions(compiled, find_equilibrium(compiled, p[k], u[k]), p[k], u[k])
        x[k], modes[k] = rest.x, rest.modes
    return x, modes


_FEW = 12  # Newton steps for many members at once: slower members are solved individually


def _newton_side_by_side(
    compiled: Compiled, balanced: Balanced, p: Array, u: Array, guess: Array
) -> tuple[Array, Array, NDArray[np.bool_]]:
    """Return states, modes, and which of them are at rest; see :func:`_newton`."""
    n_q, n_v = compiled.facts.counts
    first, count = n_q + n_v, compiled.state_count
    x = np.tile(guess, (len(p), 1))
    modes = np.ones((len(p), len(compiled.facts.switches)))
    rate, slope, switch = balanced(x, u, p, modes)
    if modes.size:
        modes = (switch[:, :, 0] > 0.0).astype(float)
        rate, slope, _ = balanced(x, u, p, modes)
    diagonal = np.einsum("sii->si", slope) != 0.0
    internal = [i for i in range(first, count) if diagonal[:, i].any()]
    rows = [*range(n_q, first), *internal]
    settled, lost = np.zeros(len(p), dtype=bool), np.zeros(len(p), dtype=bool)
    for _ in range(_FEW):
        motions = np.zeros((len(p), count, len(rows)))
        motions[:, :n_q, :n_v] = slope[:, :n_q, n_q:first]
        motions[:, internal, range(n_v, len(rows))] = 1.0
        try:
            step = np.asarray(
                np.linalg.solve(slope[:, rows] @ motions, -rate[:, rows]), dtype=np.float64
            )
        except np.linalg.LinAlgError:
            break
        steps = (motions @ step)[:, :, 0]
        x = np.where(settled[:, None], x, x + steps)
        rate, slope, switch = balanced(x, u, p, modes)
        sides = (switch[:, :, 0] > 0.0).astype(float)
        small = _are_small(step[:, :n_v, 0], x[:, :n_q]) & _are_small(
            step[:, n_v:, 0], x[:, first:]
        )
        lost |= ~np.all(np.abs(step[:, :n_v, 0]) <= _FAR, axis=1)  # and if a step is NaN
        settled |= (sides == modes).all(axis=1) & small & ~lost
        if (settled | lost).all():
            break
        if (sides != modes).any():
            modes = np.where(settled[:, None], modes, sides)
            rate, slope, _ = balanced(x, u, p, modes)
    settled &= _are_balanced(x, rate, slope, rows)
    edge = (
        np.abs(balanced(x, u, p, modes)[2][:, :, 0]) < _EDGE
        if modes.size
        else np.zeros(modes.shape, dtype=bool)
    )
    if edge.any():
        halved = np.where(edge, 0.5, modes)
        rate, slope, _ = balanced(x, u, p, halved)
        modes = np.where(_are_balanced(x, rate, slope, rows)[:, None], halved, modes)
    return x, modes, settled


def _are_small(steps: Array, sizes: Array) -> NDArray[np.bool_]:
    """Whether each of many steps is within rounding; see :func:`_is_small`."""
    # Near the end, a Newton step loses some of the 16 digits.
    most, size = (np.max(np.abs(values), axis=1, initial=0.0) for values in (steps, sizes))
    return np.asarray(most <= 1e-13 + 1e-11 * size)


def _are_balanced(x: Array, rate: Array, slope: Array, rows: list[int]) -> NDArray[np.bool_]:
    """Whether the remaining imbalance of each of many states is rounding; see :func:`_rest`."""
    rounding = _EPSILON * np.max(
        np.abs(slope[:, rows]) @ np.abs(x)[:, :, None], axis=(1, 2), initial=0.0
    )
    left = np.max(np.abs(rate[:, rows]), axis=(1, 2), initial=0.0)
    return np.asarray(left <= _UNBALANCED + _ROUNDINGS * rounding)


def _solve_equilibrium(compiled: Compiled, p: Array, u: Array, start: Array | None) -> Equilibrium:
    """Solve the static equilibrium for given inputs (their rates taken as zero) by a semi-smooth Newton method.

    It begins at the coordinates ``start``, by default the design pose. Without an equilibrium it raises an error, since
    a run from a guess would begin with a transient.
    """
    still = np.zeros_like(u)
    order = compiled.facts.track_order
    still[::order] = u[::order]
    p = compiled.plain.extend(p)
    for guess in _starts(
        compiled, still, start
    ):  # springs that are soft at first need a start that compresses them
        rest = _newton(compiled, p, still, guess)
        if rest is not None:
            return rest
    raise SimulationError(
        "no static equilibrium was found",
        where="the mechanism" if compiled.facts.projects else ", ".join(compiled.facts.coordinates),
        hint=_load_hint(compiled, u)
        or _joint_hint(compiled)
        or "Check masses, spring rate or curve (it must carry the weight), preload and bump stops.",
    )


def _load_hint(compiled: Compiled, u: Array) -> str:
    values = u[:: compiled.facts.track_order]
    loads = [
        f"{name} {value:g}"
        for name, value in zip(compiled.facts.tracks, values, strict=True)
        if value and name in LOADS
    ]
    if not loads:
        return ""
    given = ", ".join(loads)
    return f"With {given} (SI) from the very start the car tips over or nothing holds it; begin later or lower it."


def _joint_hint(compiled: Compiled) -> str:
    if "guide_joint.e0" not in compiled.facts.coordinates:
        return ""
    return (
        "A body on guide and joint tips over unless the tyre's force passes near the joint and the centre of mass lies "
        "well below it; check sprung.joint, sprung.centre_of_mass and the spring."
    )


def _starts(compiled: Compiled, u: Array, start: Array | None) -> Iterator[Array]:
    facts = compiled.facts
    count = len(facts.coordinates)
    first = np.zeros(compiled.state_count)
    first[:count] = facts.start if start is None else start
    roads = [u[i * facts.track_order] for i, track in enumerate(facts.tracks) if is_road(track)]
    road = float(np.mean(roads)) if roads else 0.0
    if start is not None:
        yield first
        return
    heave, heights, depth = _sinking(facts)
    if facts.projects:
        for sag in _SAGS if heave.any() else (0.0,):
            yield first + heave * (road - sag)
        return
    for sag in _SAGS:
        yield first + heights * road - sag * depth


@once_per_object
def _sinking(facts: ModelFacts) -> tuple[Array, Array, Array]:
    """Return which states lower a mechanism, which are heights, and how far each sinks per 1 m sag of every spring."""
    heave = np.array([name == _HEAVE for name in facts.states], dtype=float)
    heights = np.array([name.endswith(".z") for name in facts.states], dtype=float)
    return (
        heave,
        heights,
        heights * np.cumsum(heights[::-1])[::-1],
    )  # the upper masses sag with the springs below


def _newton(compiled: Compiled, p: Array, u: Array, x: Array) -> Equilibrium | None:
    """Apply Newton's method from ``x``; modes follow their switches; return None unless it converges to equilibrium.

    A rig at rest past a toggle, with springs in tension instead of compression, is rejected.
    """
    n_q, n_v = compiled.facts.counts
    modes, pace = compiled.sides(x, u, p), _SLOWEST
    x = first = _close_loops(
        compiled, x, u, p, modes
    )  # a steered wheel opens the loops of the design pose
    for _ in range(_STRIDES if compiled.facts.projects else _ITERATIONS):
        if not np.isfinite(x).all():
            return None
        now = _balance(compiled, x, u, p, modes)
        step = (_solve if compiled.facts.projects else _solve_square)(now.matrix, -now.residual)
        if step is None or _largest(step[:n_v]) > _FAR:
            return None
        if compiled.facts.projects and (_largest(step[:n_v]) > _STRIDE or now.leaves_open(x, step)):
            # A mechanism's path is curved: take short steps, and close the loops after each.
            damped_step = _with_inertia(now, n_v, pace)
            if damped_step is None:
                return None
            step, pace = damped_step
        x = _close_loops(compiled, x + now.moved @ step, u, p, modes)
        sides = (compiled.evaluate("switch", x, u, p, modes) > 0.0).astype(float)
        settled = (
            (sides == modes).all()
            and _is_small(step[:n_v], x[:n_q])
            and _is_small(step[n_v:], x[n_q + n_v :])
        )
        modes = sides
        if settled:
            toggled = pace != _SLOWEST and _is_past_toggle(compiled, first, x, u, p, modes)
            return None if toggled else _rest(compiled, x, u, p, modes)
    return None


def _is_past_toggle(
    compiled: Compiled, first: Array, x: Array, u: Array, p: Array, modes: Array
) -> bool:
    """Whether a wheel has travelled far, and its strut is extended instead of compressed, or has almost no lever."""
    before, after = (_struts(compiled, at, u, p, modes) for at in (first, x))
    for (lever, *start), (levered, *end) in zip(before, after, strict=True):
        travel, shorter = end[0] - start[0], end[1] - start[1]
        if abs(travel) > _STRIDE and (
            lever * travel * shorter < 0.0 or abs(levered) > _TOGGLE * abs(lever)
        ):
            return True
    return False


def _struts(
    compiled: Compiled, x: Array, u: Array, p: Array, modes: Array
) -> list[tuple[float, float, float]]:
    """Return each strut's shortening per rise of its wheel against the body (1), that rise (m), and deflection (m)."""
    names, now = compiled.output_names, _balance(compiled, x, u, p, modes)
    lift, _ = _lift(now.slope, *compiled.facts.counts, now.free, now.motions)
    along = (
        compiled.slopes("x", x, u, p, modes)["output"] @ lift[:, len(now.free) : 2 * len(now.free)]
    )
    values, struts = compiled.evaluate("output", x, u, p, modes), []
    for place in (
        name.removesuffix("strut.velocity") for name in names if name.endswith("strut.velocity")
    ):
        required = [
            f"{place}{word}" for word in ("unsprung.vz", "sprung.vz", "unsprung.z", "sprung.z")
        ]
        if not set(required) <= set(names):
            continue
        wheel, body, up, down = (names.index(name) for name in required)
        parting, velocity = along[wheel] - along[body], along[names.index(f"{place}strut.velocity")]
        lever = float(velocity @ parting / (parting @ parting))
        struts.append(
            (
                lever,
                float(values[up] - values[down]),
                float(values[names.index(f"{place}strut.deflection")]),
            )
        )
    return struts


def _with_inertia(now: _Balance, n_v: int, pace: float) -> tuple[Array, float] | None:
    """Return an implicit integration step from rest, limited to a stride, and the pace of the next step.

    It follows the mechanism's own motion. Newton's direction alone may lead far away along a weakly constrained motion
    to unreachable poses, such as a car standing on its nose; to an unstable equilibrium; or nowhere, if nothing
    supports a wheel off the road. The pace (1/s^2) is the inverse square of the time step; steps at the pace at
    which a motion falls, or faster, go downhill.
    """
    rows, least = np.arange(len(now.free)), 2.0 * max(now.growth, 0.0)
    while pace < _QUICKEST:
        matrix = now.matrix.copy()
        matrix[rows, now.free] -= least + pace
        step = _solve(matrix, -now.residual)
        if step is not None and _largest(step[:n_v]) <= _STRIDE:
            return step, max(0.25 * pace, 2.0 * _SLOWEST)
        pace *= 2.0
    return None


def _is_small(step: Array, size: Array) -> bool:
    """Whether a step is within rounding of the quantity that it changes."""
    return _largest(step) <= 1e-13 + 1e-11 * _largest(size)


def _largest(values: Array) -> float:
    """Return the largest magnitude; the methods take a third of the time of NumPy's functions."""
    return float(np.abs(values).max(initial=0.0))


def _close_loops(compiled: Compiled, x: Array, u: Array, p: Array, modes: Array) -> Array:
    """Move a state onto the loops."""
    for _ in range(_PROJECTIONS if compiled.facts.projects else 0):
        x = compiled.project(x, u, p, modes)
    return x


def _solve_square(matrix: Array, rhs: Array) -> Array | None:
    """Solve the system if the balance determines every motion, as in lumped models; otherwise return None."""
    try:
        solution: Array = np.asarray(np.linalg.solve(matrix, rhs), dtype=np.float64)
    except np.linalg.LinAlgError:
        return None
    return solution if np.isfinite(solution).all() else None


def _solve(matrix: Array, rhs: Array) -> Array | None:
    """Solve a square system, with minimum norm if loops are redundant or a motion is undetermined.

    Rows and columns are first scaled to a maximum of one, to balance stiffnesses and units.
    """
    rows = np.max(np.abs(matrix), axis=1, keepdims=True)
    scaled = matrix / np.where(rows > 0.0, rows, 1.0)
    columns = np.max(np.abs(scaled), axis=0)
    columns = np.where(columns > 0.0, columns, 1.0)
    scaled, target = scaled / columns, rhs / np.where(rows > 0.0, rows, 1.0)[:, 0]
    try:
        square = scaled.shape[0] == scaled.shape[1] and np.linalg.cond(scaled) < _UNDECIDED
        solution = (
            np.linalg.solve(scaled, target)
            if square
            else np.linalg.lstsq(scaled, target, rcond=1.0 / _UNDECIDED)[0]
        )
    except np.linalg.LinAlgError:
        return None
    unscaled: Array = np.asarray(solution / columns, dtype=np.float64)
    return unscaled if np.all(np.isfinite(unscaled)) else None


@dataclass(frozen=True)
class _Balance:
    """Balance about a state: slope of the rates, free motions, unknowns and their equations."""

    slope: Array
    free: NDArray[np.intp]
    motions: Array
    moved: Array
    rows: NDArray[np.intp]
    matrix: Array
    residual: Array

    @property
    def pull(self) -> Array:
        """Accelerations of the free motions per small displacement, 1/s^2: negative for a restoring force."""
        return np.asarray(
            self.slope[self.rows[: len(self.free)]]
            @ self.moved[:, : len(self.motions)]
            @ self.motions
        )

    @property
    def growth(self) -> float:
        """Square of the largest growth rate of a free motion, 1/s^2; negative if all are stable."""
        return float(np.max(np.linalg.eigvals(self.pull).real, initial=-np.inf))

    def rounding(self, size: Array) -> float:
        """Return the imbalance (m/s^2) that rounding alone may cause for coordinates of given sizes."""
        return _ROUNDINGS * _EPSILON * _largest(np.abs(self.slope[self.rows]) @ size)

    def leaves_open(self, x: Array, step: Array) -> bool:
        """Whether a step leaves an imbalance: a motion without restoring force is driven."""
        left = _largest(self.matrix @ step + self.residual)
        return left > _UNBALANCED * (1.0 + _largest(self.residual)) + self.rounding(
            np.maximum(np.abs(x), _PLACES)
        )


def _balance(compiled: Compiled, x: Array, u: Array, p: Array, modes: Array) -> _Balance:
    """Form the equations of rest: accelerations of free motions, loops, and rates of internal states must vanish."""
    facts, (n_q, n_v) = compiled.facts, compiled.facts.counts
    slopes, first = compiled.slopes("x", x, u, p, modes), n_q + n_v
    slope = slopes["rate"]
    internal = [i for i in range(first, len(slope)) if slope[i, i] != 0.0]
    motions_of_states = np.zeros((len(slope), n_v + len(internal)))
    motions_of_states[:n_q, :n_v] = slope[:n_q, n_q:first]
    if internal:
        motions_of_states[internal, range(n_v, n_v + len(internal))] = 1.0
    loops = slopes["constraint"] @ motions_of_states if facts.constraints else None
    free, motions = _every_motion(n_v) if loops is None else free_motions(loops[:, :n_v], n_v)
    rows = np.append(n_q + free, internal) if internal else n_q + free
    matrix, residual = (
        slope[rows] @ motions_of_states,
        compiled.evaluate("rate", x, u, p, modes)[rows],
    )
    if loops is not None:
        matrix = np.vstack([matrix, loops])
        residual = np.concatenate([residual, compiled.evaluate("constraint", x, u, p, modes)])
    return _Balance(slope, free, motions, motions_of_states, rows, matrix, residual)


def _rest(compiled: Compiled, x: Array, u: Array, p: Array, modes: Array) -> Equilibrium | None:
    now = _balance(compiled, x, u, p, modes)
    # Behind very stiff bushings the last bit of a position exceeds the absolute limit. A mechanism's coordinates count
    # from the design pose, but positions of about a metre from the origin are rounded.
    size = np.maximum(np.abs(x), _PLACES) if compiled.facts.projects else np.abs(x)
    if _largest(now.residual) > _UNBALANCED + now.rounding(size):
        return None
    lift, pick = _lift(now.slope, *compiled.facts.counts, now.free, now.motions)
    reduced = pick @ now.slope @ lift
    return Equilibrium(
        x, modes, now.slope, now.free, lift, pick, reduced, now.matrix, now.moved, now.rows
    )


def free_motions(loops: Array | None, n_v: int) -> tuple[NDArray[np.intp], Array]:
    """Return independent speeds, and the motions (n_v, f) for a unit value of each.

    ``loops`` (k, n_v) is the Jacobian of the loop equations by the ``n_v`` speeds.
    """
    if loops is None or not len(loops):
        return _every_motion(n_v)
    _, values, rows = np.linalg.svd(loops)
    rank = int(np.sum(values > _INDEPENDENT * values[0]))
    null = rows[rank:].T
    free: list[int] = []
    remainder = null.copy()
    # Select the largest rows orthogonal to the previous ones: the others then follow without large factors.
    for _ in range(null.shape[1]):
        row = int(np.argmax(np.linalg.norm(remainder, axis=1)))
        free.append(row)
        direction = remainder[row] / np.linalg.norm(remainder[row])
        remainder = remainder - np.outer(remainder @ direction, direction)
    chosen = np.array(sorted(free), dtype=np.intp)
    return chosen, np.asarray(null @ np.linalg.inv(null[chosen]))


@cache
def _every_motion(n_v: int) -> tuple[NDArray[np.intp], Array]:
    """Return the result of :func:`free_motions` without loops."""
    free, motions = np.arange(n_v), np.eye(n_v)
    for part in (free, motions):
        part.setflags(write=False)
    return free, motions


def _lift(
    slope: Array, n_q: int, n_v: int, free: NDArray[np.intp], motions: Array
) -> tuple[Array, Array]:
    """Return the maps from reduced states to states, and from rates of the states to rates of the reduced states.

    The rate of a reduced displacement is its speed; that of a reduced speed is the acceleration of the free motion.
    """
    n, f = len(slope), len(free)
    internal = n - n_q - n_v
    lift, pick = np.zeros((n, 2 * f + internal)), np.zeros((2 * f + internal, n))
    lift[:n_q, :f] = slope[:n_q, n_q : n_q + n_v] @ motions
    lift[n_q : n_q + n_v, f : 2 * f] = motions
    if internal:
        lift[n_q + n_v :, 2 * f :] = pick[2 * f :, n_q + n_v :] = np.eye(internal)
    kinematics = slope[:n_q, n_q : n_q + n_v]
    plain = n_q == n_v and np.array_equal(kinematics, _every_motion(n_v)[1])
    pick[:f, :n_q] = (_every_motion(n_v)[1] if plain else np.linalg.pinv(kinematics))[free]
    pick[f + np.arange(f), n_q + free] = 1.0
    return lift, pick


def state_scale(rest: Equilibrium, n_q: int, n_v: int, size: float) -> Array:
    """Return the typical size of each state for a motion of ``size`` metres: displacements, speeds, internal states."""
    scale = np.ones(len(rest.x))
    f = len(rest.free)
    stiffness = np.abs(np.diag(rest.reduced[f : 2 * f, :f]))
    fastest = np.zeros(n_v) + np.sqrt(np.max(stiffness, initial=0.0))
    fastest[rest.free] = np.sqrt(stiffness)
    scale[:n_q] = size
    scale[n_q : n_q + n_v] = size * np.maximum(fastest, 1.0)
    return scale
