"""Simulate a user's mechanism: from given coordinates and speeds, with prescribed motions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from math import comb
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np

from jounce.core.errors import AssemblyError, SimulationError, unknown
from jounce.core.findings import Finding, finding, finding_attributes
from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.core.units import to_si
from jounce.kernel.engine import Control, Problem, Status, flatten
from jounce.mechanics import Mechanism, Model, assemble, constant
from jounce.mechanics.assembly import Assembly
from jounce.mechanics.facts import motion_of_speed
from jounce.mechanics.loads import PushApart, SpringDamper, refuse_one_point
from jounce.mechanics.mechanism import BALANCE
from jounce.parts.advice import size_findings
from jounce.recordings.schema import recording_of
from jounce.simulation.compiled import Compiled, compile_model
from jounce.simulation.prepare import (
    IMPLICIT_SHARE,
    STEP_SHARE,
    PreparedRun,
    longest_implicit_step,
    room,
)
from jounce.simulation.result import Solution, samples_reached
from jounce.simulation.settings import COARSEST, MAX_STEPS, Method, RunSettings
from jounce.simulation.singular_configurations import Begin, run_through
from jounce.simulation.statics import falling, free_motions

if TYPE_CHECKING:
    import xarray as xr

# Sizes and steps of the integration.
_SMALLEST = (
    1e-3  # m, rad, m/s or rad/s: smaller motions need not be resolved relative to their own size
)
_LONGEST = 1.2  # radians of the fastest initial motion in one step
_SHARE = 0.02  # longest step as a share of the duration
_DECAYING = (
    0.9  # share of decay in the rate of a motion above which it does not count as an oscillation
)
_STIFF, _LONG_RUN = (
    20.0,
    1e4,
)  # decay over oscillation, and decays in a run, above which the implicit method is worthwhile
_MASSLESS = (
    1e-12  # mass moved by a motion, relative to the mass of the single coordinates: rounding
)
_MOVING = 1e-3  # minimum share of a coordinate in a motion for it to be named
# Tests of a run for rounding.
_PROBES, _PROBED, _MANY_STEPS, _LOOSEST_PROBE = 6, 60, 1000, 1e-3
_CLOSE, _DIFFERENCES, _ORDER = (
    1e-3,
    6,
    8.0,
)  # of the longest step; differences of the rates; order of the methods
_UNSEEN, _SEEN, _CHEAP = (
    0.01,
    0.3,
    0.1,
)  # share of a step's error caused by rounding: negligible, large, small
_ROUNDED = 3.0  # ratio of steps to those that the motion requires
# Search for a state of rest.
_ITERATIONS, _MANY_ITERATIONS, _NEARER = (
    200,
    10_000,
    0.1,
)  # without progress, and with progress of that share of a step
_PROJECTIONS = 3  # Newton steps onto the loops, after a step of 5 cm
# m or rad: step of a mechanism on its way to rest, and step that shows that nothing holds it
_STRIDE, _FAR = 0.05, 1e6
# slopes, relative to the largest, that are rounding, and motions that no force determines
_NOISE, _UNDECIDED = 1e-11, 1e-9
_SETTLED, _UNBALANCED, _SHARE_OF_NEUTRAL = (
    1e-10,
    1e-6,
    0.1,
)  # relative step, relative rate at rest, share in a motion
_HINT = "Check masses, springs, stops and the initial pose: every weight must be supported."


def simulate_mechanism(  # noqa: PLR0913 - all but two are settings with a default
    mechanism: Mechanism,
    duration: float | str,
    *,
    start: Mapping[str, float | str] | None = None,
    motions: Mapping[str, Segments] | None = None,
    values: Mapping[str, float | str] | None = None,
    output_step: float = 1e-3,
    tolerance: float = 1e-6,
    method: Method = "auto",
    redundant: str = "refuse",
    at_rest: bool = False,
    check: bool = True,
) -> xr.Dataset:
    """Simulate a mechanism from given coordinates and speeds.

    Parameters
    ----------
    mechanism : Mechanism
        Bodies, joints, loops, forces and outputs.
    duration : float or str
        s, or text with a unit.
    start : mapping, optional
        Coordinates (m, rad) and speeds (m/s, rad/s) by name, or text with a unit; others start in the design pose, at
        rest. If loops do not allow these, the nearest pose and speeds are used, with minimum change of those given.
    motions : mapping, optional
        Motion by track, see :func:`jounce.mechanics.harmonic` and related functions.
    values : mapping, optional
        Values (SI, or text with a unit) by path that replace those as built; no recompilation.
    output_step : float
        Step of the output samples, s.
    tolerance : float
        Relative error of coordinates and speeds.
    method : {"auto", "explicit", "implicit"}
        Integration method, see :func:`jounce.simulate`; "auto" is implicit if a motion decays at the start far faster
        than any motion oscillates, and after an explicit run that exceeded its number of steps.
    redundant : {"refuse", "remove"}
        Treatment of redundant loop equations.
    at_rest : bool
        Begin in equilibrium near ``start``, with constant tracks. Speeds given in ``start`` are kept; all other motions
        are in equilibrium. Undetermined coordinates (a car's position on a level road) keep their start values. The
        nearest equilibrium may be unstable: a finding reports this if nothing moves at the start.
    check : bool
        Raise if the run stops before its end.

    Returns
    -------
    xarray.Dataset
        The outputs over ``time`` (s), SI. ``attrs["degrees_of_freedom"]`` counts the motions that the joints allow at
        the start. ``attrs["findings"]`` reports changes by assembly to the pose or to given speeds, coordinates that
        equilibrium does not determine, singular configurations passed with modified steps, and a tolerance below
        rounding. With loops it also reports the motions that they allow, motions without force, and dropped redundant
        equations.

    Raises
    ------
    AssemblyError
        If the loops cannot be closed or are redundant, or a motion of the joints moves no mass.
    SimulationError
        If a name is unknown, no equilibrium is found, or, with ``check``, the run stops before its end.

    Examples
    --------
    >>> import jounce as jn
    >>> pendulum = jn.mechanics.Mechanism()
    >>> bob = pendulum.body("bob", mass=1.0, centre_of_mass=(1.0, 0.0, 0.0))
    >>> _ = pendulum.revolute("pivot", pendulum.ground, bob, at=(0.0, 0.0, 0.0), axis=(0.0, 1.0, 0.0))
    >>> pendulum.watch_body(bob)
    >>> run = jn.simulate_mechanism(pendulum, "1 s", start={"pivot.angle": 0.0})
    >>> bool(run["bob.z"].min() < -0.99)   # it swings through its lowest point
    True
    """
    seconds = to_si(duration, "s", where="duration")
    if not seconds > 0.0:
        raise SimulationError(
            "invalid duration", where="duration", found=f"{seconds:g} s", allowed="above 0 s"
        )
    times = RunSettings(output_step, tolerance, method).times(seconds)
    if redundant not in ("refuse", "remove"):
        raise unknown(redundant, ("refuse", "remove"), what="choice", where="redundant")
    parameters, motions_by_track = (
        _values(mechanism, values or {}),
        _motions(mechanism, motions or {}),
    )
    inputs = {
        name: float(track.evaluate(np.zeros(1))[0][0]) for name, track in motions_by_track.items()
    }
    model = mechanism.model(redundant, start, values=parameters, inputs=inputs)
    p = np.array([parameters[name] for name in model.parameters])
    tracks = [motions_by_track[name] for name in model.tracks]
    u = _inputs(model.facts.track_order, tracks)
    pose = assemble(model, p, u, start, redundant="refuse" if redundant == "refuse" else "keep")
    _check_masses(mechanism, model, pose.x, u, p)
    _check_reaches(mechanism, model, pose.x, u, p)
    compiled = compile_model(model)
    first, notes = (
        pose.x,
        [_assembly_findings(pose), [*size_findings(mechanism.places(parameters), "points")]],
    )
    if at_rest:
        running = {
            name
            for name in start or {}
            if name in model.speeds and pose.x[model.states.index(name)] != 0.0
        }
        first, neutral = _at_rest(compiled, p, u, pose.x, running, model.quaternions.values())
        if model.constraints:  # close the loops again, now including the speeds of the tracks
            prescribed = [
                i
                for i, name in enumerate(model.states)
                if name not in model.speeds or name in running
            ]
            moving = {model.states[i]: float(first[i]) for i in prescribed}
            first = assemble(model, p, u, moving, redundant="keep").x
        if neutral:
            notes.append([finding("simulation.neutral", ", ".join(neutral))])
        is_moving = bool(running) or bool(u[1 :: model.facts.track_order].any())
        # a spinning body may be stabilised by its spin
        if not is_moving and (names := falling(compiled, first, u, p)):
            notes.append(
                [
                    finding(
                        "simulation.on_top", ", ".join(dict.fromkeys(map(motion_of_speed, names)))
                    )
                ]
            )

    mobility = (
        mechanism.freedoms(model).at(first, u, p) if mechanism.collection.constraints else None
    )

    def begin(x: Array, after: Array, error: float) -> PreparedRun:
        u = _inputs(model.facts.track_order, tracks, float(after[0]))
        return _prepare(compiled, p, tracks, x, u, after, error, method)

    if model.constraints:
        solution, crossings = run_through(begin, first, times, tolerance, tracks)
        notes.append([finding("simulation.singular_passed", f"{time:.6g} s") for time in crossings])
    else:
        solution = begin(first, times, tolerance).run()
    attainable = _attainable(begin, solution, tolerance)
    if attainable is not None:
        steps = solution.steps + solution.rejected
        note = finding(
            "simulation.tolerance",
            "tolerance",
            tolerance=tolerance,
            steps=steps,
            attainable=attainable,
        )
        if check and solution.status is Status.TOO_MANY_STEPS:
            raise SimulationError(
                "a tolerance below rounding accuracy",
                where="tolerance",
                found=tolerance,
                hint=note.message,
            )
        notes.append([note])
    if mobility is not None:  # without loops, every degree of freedom belongs to a named joint
        notes.append([*mobility.findings(is_driven=bool(tracks))])
    reach = samples_reached(solution, compiled.facts, check=check)
    channels = {
        output.name: (solution.outputs[i, :reach], output.unit, output.long_name)
        for i, output in enumerate(compiled.facts.outputs)
        if output.name != BALANCE or "energy.kinetic" in compiled.output_names
    }
    run = recording_of(solution.time[:reach], channels)
    run.attrs["status"] = solution.status.name.lower()
    run.attrs["method"], run.attrs["steps"], run.attrs["events"] = (
        solution.method,
        solution.steps,
        solution.events,
    )
    run.attrs["degrees_of_freedom"] = (
        len(model.speeds) if mobility is None else mobility.degrees_of_freedom
    )
    run.attrs |= finding_attributes(item for group in notes for item in group)
    return run


def _values(mechanism: Mechanism, values: Mapping[str, float | str]) -> dict[str, float]:
    """Return every parameter by path; given values replace those as built."""
    every = mechanism.with_values(values)
    lacking = [name for name in mechanism.parameters if name not in every]
    if lacking:
        raise SimulationError(
            "some parameters have no value",
            where=", ".join(lacking),
            hint="Give the values of the parameters in values.",
        )
    mechanism.check_values(every)
    return every


def _motions(mechanism: Mechanism, motions: Mapping[str, Segments]) -> dict[str, Segments]:
    for name, motion in motions.items():
        if name not in mechanism.tracks:
            raise unknown(name, mechanism.tracks, what="track", where="motions")
        if not isinstance(motion, Segments):
            hint = "Use constant(), constant_rate(), harmonic(), step() or interpolated() of jounce.mechanics."
            raise SimulationError(
                "invalid motion", where=f"motions: {name}", found=str(motion), hint=hint
            )
        if not (np.all(np.isfinite(motion.coefficients)) and np.all(np.isfinite(motion.edges))):
            raise SimulationError(
                "invalid motion", where=f"motions: {name}", found="not a finite number"
            )
    lacking = [name for name in mechanism.tracks if name not in motions]
    if lacking:
        raise SimulationError(
            "some tracks have no motion",
            where=", ".join(lacking),
            hint="Give the motions of the tracks in motions.",
        )
    return {name: motion.with_finite_slopes() for name, motion in motions.items()}


def _inputs(order: int, tracks: list[Segments], time: float = 0.0) -> Array:
    """Return the inputs at a time (s); a start does not need accelerations."""
    u = np.zeros(order * len(tracks))
    for i, track in enumerate(tracks):
        value, rate = track.evaluate(np.array([time]))
        u[i * order : i * order + 2] = value[0], rate[0]
    return u


def _check_masses(mechanism: Mechanism, model: Model, x: Array, u: Array, p: Array) -> None:
    """Refuse a mechanism if some motion of its joints moves no mass."""
    matrix = mechanism.mass_matrix(model)(x, u, p).full()
    if not np.all(np.isfinite(matrix)):
        raise SimulationError(
            "the mechanism cannot be computed: its mass matrix is not finite",
            hint="Check the axes of the joints, and how `values` changes them.",
        )
    size = np.sqrt(np.diag(matrix))
    scale = np.where(size > 0.0, size, 1.0)
    values, vectors = np.linalg.eigh(matrix / np.outer(scale, scale))
    empty = [vectors[:, i] for i in np.flatnonzero(values < _MASSLESS)]
    if empty:
        shares = [pair for vector in empty for pair in zip(model.speeds, vector, strict=True)]
        names = [name for name, share in shares if abs(share) > _MOVING]
        raise AssemblyError(
            "nothing with mass or inertia moves when these coordinates change together",
            where=", ".join(dict.fromkeys(name.removesuffix(" rate") for name in names)),
            hint="Give the bodies there mass and inertia (a point mass has no inertia of its own), or fewer joints: "
            "a massless link is a rod().",
        )


_NO_FORCE = 1e-6  # N: far below any relevant force


def _check_reaches(mechanism: Mechanism, model: Model, x: Array, u: Array, p: Array) -> None:
    """Refuse forces between coincident points: without a direction they would reverse at every step.

    A spring of zero free length has no force in that pose and is allowed.
    """
    pushing = [
        (load.name or load.kind, action.power[0][1], action.wrenches)
        for load, action in mechanism.loads
        if isinstance(load, SpringDamper | PushApart) and load.first.carrier is load.second.carrier
    ]
    if not pushing:
        return
    rows = [ca.vertcat(force, second.point - first.point) for _, force, (first, second) in pushing]
    table = (
        ca.Function("reaches", [model.x, model.u, model.p], [ca.horzcat(*rows)])(x, u, p).full().T
    )
    for (name, _, _), (force, *reach) in zip(pushing, table, strict=True):
        if abs(force) > _NO_FORCE:
            refuse_one_point(name, np.array(reach), "at the start")


def _prepare(
    compiled: Compiled,
    p: Array,
    tracks: list[Segments],
    x: Array,
    u: Array,
    times: Array,
    tolerance: float,
    method: Method,
) -> PreparedRun:
    facts = compiled.facts
    modes = (compiled.evaluate("switch", x, u, p, np.ones(len(facts.switches))) > 0.0).astype(float)
    rate = compiled.evaluate("rate", x, u, p, modes)
    if not np.all(np.isfinite(rate)):
        names = [
            name for name, value in zip(facts.states, rate, strict=True) if not np.isfinite(value)
        ]
        hint = "Check the forces and the initial state."
        raise SimulationError(
            "the rates at the start are not finite",
            where=", ".join(names),
            found="not a number",
            hint=hint,
        )
    pace, duration = (
        np.linalg.eigvals(compiled.evaluate("rate_x", x, u, p, modes)),
        float(times[-1] - times[0]),
    )
    fastest = float(np.max(np.abs(pace), initial=1e-3))
    moving = float(np.max(np.abs(pace[-pace.real < _DECAYING * np.abs(pace)]), initial=1e-3))
    longest = min(_LONGEST / fastest, _SHARE * duration)
    scale = np.full(len(x), _SMALLEST)
    control = Control(STEP_SHARE * tolerance, scale, np.full(len(modes), 1e-13), MAX_STEPS, longest)
    flat = flatten(tracks or [constant(0.0)])
    first = flat.first[: len(tracks)].copy()
    problem = Problem(compiled.engine, flat, first, compiled.extend(p), modes.copy(), x, len(u))
    prepared = PreparedRun(compiled, problem, control, room(compiled, times), None, modes, None, u)
    if method == "explicit":
        return prepared
    coarse = min(longest_implicit_step(moving, tolerance), _SHARE * duration)
    stiff = control._replace(tolerance=IMPLICIT_SHARE * tolerance, longest=coarse)
    implicitly = method == "implicit" or (
        fastest > _STIFF * moving and fastest * duration > _LONG_RUN
    )
    return replace(prepared, stiff=lambda: stiff, method="implicit" if implicitly else "explicit")


def _assembly_findings(pose: Assembly) -> list[Finding]:
    """Report coordinates and given speeds that assembly changed."""
    return [
        finding(
            "simulation.assembly_moved", moved.coordinate, before=moved.before, after=moved.after
        )
        for moved in pose.displacements
    ]


def _attainable(begin: Begin, solution: Solution, tolerance: float) -> float | None:
    """Return the smallest attainable power of ten as tolerance if rounding prevents the given one, else None.

    A rounding error ``e`` of a rate causes an error of ``h e`` in a step of ``h``. If that reaches the error allowed
    for a step, steps shrink until it does not, without a smaller total error. The steps that the motion alone requires
    are determined by a short run at a tolerance at which rounding is negligible. Both depend on the mechanism and its
    motion, not on the duration.
    """
    reached = int(np.sum(np.isfinite(solution.states[0])))
    steps_taken = solution.steps + solution.rejected
    if reached < 2 or not steps_taken:
        return None
    states, times = solution.states[:, :reached], solution.time[:reached]
    scale = np.maximum(_SMALLEST, np.max(np.abs(states - states[:, :1]), axis=1))
    share = IMPLICIT_SHARE if solution.method == "implicit" else STEP_SHARE
    samples = [(reached - 1) * i // _PROBES for i in range(1, _PROBES)]
    at = samples[_PROBES // 2 - 1]
    rounded = np.median(
        [
            _rounding(begin(states[:, i], times[i : i + 2], tolerance), states[:, i], scale)
            for i in samples
        ]
    )
    duration = float(times[-1] - times[0])
    if duration / steps_taken * rounded < _UNSEEN * share * tolerance:
        return None
    longest = begin(
        states[:, at], times[at] + np.array([0.0, _LONG_RUN]), tolerance
    ).control.longest
    loose = min(max(longest * rounded / (_UNSEEN * share), tolerance), _LOOSEST_PROBE)
    ahead = np.linspace(times[at], times[at] + _PROBED * longest, _PROBED + 1)
    probe = begin(states[:, at], ahead, loose)
    probed_run = replace(probe, control=probe.control._replace(max_steps=_MANY_STEPS)).run()
    time_covered = longest * int(np.sum(np.isfinite(probed_run.states[0])))

    def required_step(error: float) -> float:
        """Return the step (s) that the motion requires at a tolerance."""
        return float(time_covered / max(probed_run.steps, 1) * (error / loose) ** (1.0 / _ORDER))

    def is_rounding(error: float, limit: float) -> bool:
        """Whether rounding matters in such steps."""
        return bool(required_step(error) * rounded > limit * share * error)

    is_short = steps_taken > _ROUNDED * duration / min(required_step(tolerance), _SHARE * duration)
    if not is_rounding(tolerance, _CHEAP if is_short else _SEEN):
        return None
    decade = np.floor(np.log10(tolerance) + 1.0 + 1e-9)
    while is_rounding(10.0**decade, _CHEAP) and 10.0**decade < COARSEST:
        decade += 1.0
    return float(10.0**decade)


def _rounding(prepared: PreparedRun, x: Array, scale: Array) -> float:
    """Estimate the rounding of the rates along the motion at a state, relative to the sizes of the states, 1/s.

    It is estimated from sixth differences of the rates at close, even distances, which vanish for a smooth function:
    independent errors of size ``e`` have a sum of squares of ``e^2 (2 k)! / k!^2``.
    """
    compiled, (p, modes) = prepared.compiled, (prepared.problem.p, prepared.problem.m)
    close = _CLOSE * prepared.control.longest
    along = compiled.evaluate("rate", x, prepared.still, p, modes)
    rates = [
        compiled.evaluate("rate", x + i * close * along, prepared.still, p, modes)
        for i in range(_DIFFERENCES + 4)
    ]
    left = np.diff(np.array(rates) / scale, n=_DIFFERENCES, axis=0)
    return float(np.sqrt(np.mean(left**2) / comb(2 * _DIFFERENCES, _DIFFERENCES)))


def _at_rest(
    compiled: Compiled, p: Array, u: Array, x: Array, running: set[str], quaternions: Iterable[int]
) -> tuple[Array, list[str]]:
    """Find the equilibrium near a state with given speeds and constant tracks, and coordinates it does not determine.

    Newton's method solves for zero accelerations of all motions without a given speed, and for closed loops. A motion
    that changes no force has a zero column: the step of minimum norm does not change it, nor does the projection onto
    the loops. If the slope vanishes and no step is possible, the mechanism first falls a little.
    """
    from scipy.linalg import qr

    facts, (n_q, n_v) = compiled.facts, compiled.facts.counts
    still, end = np.zeros_like(u), n_q + n_v
    still[:: facts.track_order] = u[:: facts.track_order]
    p = compiled.plain.extend(p)
    runs = np.array([name in running for name in facts.speeds], dtype=bool)
    others = np.flatnonzero(~runs)
    modes = (compiled.evaluate("switch", x, still, p, np.ones(len(facts.switches))) > 0.0).astype(
        float
    )
    x, fallen = x.copy(), False

    def onto_loops(x: Array, modes: Array) -> Array:
        """Close the loops by the smallest motion of the free coordinates, and normalise quaternions."""
        for _ in range(_PROJECTIONS if facts.constraints else 0):
            slopes, gap = (
                compiled.slopes("x", x, still, p, modes),
                compiled.evaluate("constraint", x, still, p, modes),
            )
            speeds = slopes["rate"][:n_q, n_q + others]
            x = x.copy()
            x[:n_q] -= (
                speeds
                @ np.linalg.lstsq(slopes["constraint"][:, :n_q] @ speeds, gap, rcond=1e-12)[0]
            )
        for i in quaternions:
            x[i : i + 4] /= np.linalg.norm(x[i : i + 4])
        return x

    stride, nearest, idle = _STRIDE, np.inf, 0
    for tried in range(_MANY_ITERATIONS):
        if idle > _ITERATIONS:
            break
        slopes = compiled.slopes("x", x, still, p, modes)
        if facts.constraints:  # the other speeds follow from the loops
            loops = slopes["constraint"][:, :n_q] @ slopes["rate"][:n_q, n_q:end]
            x[n_q + others] = -np.linalg.lstsq(
                loops[:, others], loops[:, runs] @ x[n_q:end][runs], rcond=1e-12
            )[0]
            slopes = compiled.slopes("x", x, still, p, modes) if runs.any() else slopes
        else:
            loops = np.zeros((0, n_v))
            x[n_q + others] = 0.0
        slope = slopes["rate"]
        internal = [
            i for i in range(end, len(x)) if slope[i, i] != 0.0
        ]  # others change only during motion
        lift = np.zeros((len(x), len(others) + len(internal)))
        lift[:n_q, : len(others)] = slope[:n_q, n_q + others]
        lift[internal, range(len(others), lift.shape[1])] = 1.0
        free, _ = free_motions(loops[:, others], len(others))
        rows = np.array([*(n_q + others[free]), *internal], dtype=np.intp)
        rate = compiled.evaluate("rate", x, still, p, modes)[rows]
        matrix, residual = slope[rows] @ lift, rate
        closing: Array = np.zeros(lift.shape[1])
        directions: Array = np.eye(lift.shape[1])
        if facts.constraints:
            # First the smallest step that closes the loops, then one along the motions that they allow.
            across = slopes["constraint"] @ lift
            left = compiled.evaluate("constraint", x, still, p, modes)
            closing = np.asarray(-np.linalg.lstsq(across, left, rcond=1e-12)[0], dtype=np.float64)
            _, values, right = np.linalg.svd(across)
            directions = right[int(np.sum(values > _UNDECIDED * np.max(values, initial=0.0))) :].T
        size = np.max(np.abs(matrix), axis=1, initial=0.0)
        scale = np.maximum(size, _NOISE * (np.max(size, initial=0.0) or 1.0))[
            :, None
        ]  # keeps rounding small
        residual = (residual + matrix @ closing) / scale[:, 0]
        balance = matrix @ directions / scale
        _, values, right = np.linalg.svd(balance)
        decided = int(np.sum(values > _UNDECIDED * max(1.0, np.max(values, initial=0.0))))
        # as many accelerations as undetermined motions; the others vanish as well, or there is no rest
        chosen = (
            qr(balance.T, mode="r", pivoting=True)[1][:decided]
            if balance.size
            else np.zeros(0, dtype=int)
        )
        step = closing
        if decided:
            step = (
                step
                + directions @ np.linalg.lstsq(balance[chosen], -residual[chosen], rcond=1e-12)[0]
            )
        left_to_go = np.max(np.abs(step[: len(others)]), initial=0.0)
        if not np.all(np.isfinite(step)) or left_to_go > _FAR:
            break
        # A mechanism's path is curved: steps are short, and become longer if they converge steadily.
        nearer = left_to_go < nearest - _NEARER * stride
        nearest, idle = (left_to_go, 0) if nearer else (nearest, idle + 1)
        stride = 2.0 * stride if nearer and tried > _ITERATIONS else _STRIDE
        x = onto_loops(x + lift @ (step * (stride / max(left_to_go, stride))), modes)
        before, modes = modes, (compiled.evaluate("switch", x, still, p, modes) > 0.0).astype(float)
        if np.array_equal(before, modes) and np.max(np.abs(step), initial=0.0) < _SETTLED * (
            1.0 + np.max(np.abs(x[:n_q]))
        ):
            rate = compiled.evaluate("rate", x, still, p, modes)
            falling = [
                facts.states[i]
                for i in rows
                if abs(rate[i]) > _UNBALANCED * max(1.0, np.max(np.abs(rate)))
            ]
            fall = rate[n_q + others]
            if falling and not fallen and np.any(fall):
                fallen = True
                x = onto_loops(
                    x + lift[:, : len(others)] @ (fall * (_STRIDE / np.max(np.abs(fall)))), modes
                )
                continue
            if falling:
                names = ", ".join(dict.fromkeys(motion_of_speed(name) for name in falling))
                raise SimulationError(
                    "no static equilibrium was found: nothing supports the weight",
                    where=names,
                    hint=_HINT,
                )
            neutral = np.any(
                np.abs((directions @ right[decided:].T)[: len(others)]) > _SHARE_OF_NEUTRAL, axis=1
            )
            return x, [motion_of_speed(facts.speeds[i]) for i in others[neutral]]
    raise SimulationError("no static equilibrium was found", where="the mechanism", hint=_HINT)
