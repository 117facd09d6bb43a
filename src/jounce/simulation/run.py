"""Simulate a rig on a trial."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import SimulationError, nearest
from jounce.core.segments import SINE, Segments
from jounce.core.types import Array
from jounce.kernel import implicit, linear, linear_plan
from jounce.kernel.explicit import Control, Problem, integrate
from jounce.kernel.feedback import NO_FEEDBACK, Feedback
from jounce.kernel.propagators import Calls
from jounce.kernel.sampling import Samples
from jounce.kernel.status import Status
from jounce.kernel.tracks import flatten
from jounce.mechanics.model import Facts, is_road
from jounce.parts import Rig
from jounce.recordings.schema import recording
from jounce.roads import Trial
from jounce.simulation.branch import flipped_at, ran_away_at
from jounce.simulation.compiled import Compiled, compile_rig
from jounce.simulation.excitation import excitation
from jounce.simulation.programs import SLOPE_LANES
from jounce.simulation.statics import Rest, find_rest, state_scale
from jounce.simulation.stiff import STEP_SHARE as IMPLICIT_SHARE
from jounce.simulation.stiff import Method, check_method, longest_step, pace_of, pays, slopes_of

if TYPE_CHECKING:
    import xarray as xr

    from jounce.simulation.controlled import AnyControl

MAX_STEPS, _MAX_SAMPLES = 5_000_000, 20_000_000
_STABLE = 0.4  # share of the fastest decay at rest that the method must resolve: friction holding a rig, sensitivities
_LONGEST = 1.2  # radians of the fastest oscillation in one step, at a tolerance of 1e-5
_LONG_RUN = 5000.0  # radians of the fastest motion, beyond which it is worth asking whether the implicit method pays
_SINGULAR = 0.05  # share of the loops' conditioning at the start that is left where a mechanism counts as locked up
_SHORT_SHARE = 0.03  # the same for the pair of lower order, which errs less in all for what it allows in a step
_SHORT = 0.4  # radians of the fastest oscillation in a step of the pair of lower order, at a tolerance of 1e-5
_STAGES, _SHORT_STAGES = 16.0, 7.0  # rates that a step of either pair evaluates, with its interpolant
_FINEST, _COARSEST = 1e-13, 1e-1
STEP_SHARE = 0.003  # of the tolerance for one step: keeps the global error of the shipped models below it


@dataclass(frozen=True)
class Solution:
    """Arrays of one run.

    Attributes
    ----------
    time : ndarray, shape (n,)
        Output times, s.
    states, outputs : ndarray, shape (n_states, n), (n_outputs, n)
        One row a signal, SI.
    status : Status
        How the run ended.
    steps, rejected, events : int
        Work done.
    state_slopes, output_slopes : ndarray, shape (n_states, n_free, n), (n_outputs, n_free, n)
        Sensitivities to the free parameters, SI.
    method : {"exact", "explicit", "implicit"}
        What computed them.
    """

    time: Array
    states: Array
    outputs: Array
    status: Status
    steps: int
    rejected: int
    events: int
    state_slopes: Array
    output_slopes: Array
    method: str


def output_times(duration: float, output_step: float) -> Array:
    """Times from 0 to ``duration`` (s), both included; the last step may be shorter."""
    count = int(np.floor(duration / output_step + 1e-9))
    times = np.arange(count + 1, dtype=np.float64) * np.float64(output_step)
    return times if duration - times[-1] < 1e-9 * duration else np.append(times, duration)


@dataclass(frozen=True)
class Prepared:
    """A run with everything laid out: ``run`` only computes, into ``out``, as often as wanted.

    ``stiff`` says how the implicit method is steered, None where there is only the explicit one; ``method`` is the one
    used first. In place of an explicit run that used up its steps the implicit method has a try. ``rest`` is the
    equilibrium under the inputs ``still``, if it starts from one; ``feedback`` is a controller, and ``begin`` sets back
    what it keeps.
    """

    compiled: Compiled
    problem: Problem
    control: Control
    out: Samples
    exact: linear_plan.Plan | None
    modes: Array
    rest: Rest | None
    still: Array
    stiff: Callable[[], Control] | None = None
    method: Method = "explicit"
    feedback: Feedback = NO_FEEDBACK
    begin: Callable[[], None] | None = None

    def run(self) -> Solution:
        """Fill the arrays and say how the run ended."""
        counts, method = np.zeros(3, dtype=np.int64), "exact"
        if self.exact is not None:
            self._start()
            code = linear.propagate(self.problem, self.control, self.exact, self.out, counts)
        else:
            method, code = self._integrate(counts)
        out, free = self.out, len(self.compiled.free)
        tables = ((out.states, out.tangents), (out.outputs, out.carried[:, len(out.outputs) :]))
        slopes = [table.reshape(len(out.times), len(of), free).transpose(1, 2, 0) for of, table in tables]
        steps, rejected, events = (int(count) for count in counts)
        found = (out.times, out.states, out.outputs, self._ended(Status.of(code)))
        return Solution(*found, steps, rejected, events, slopes[0], slopes[1], method)

    def _ended(self, status: Status) -> Status:
        """How the run ended; what explodes while its loops come to a singular configuration has locked up."""
        if status in (Status.COMPLETED, Status.LOOP_OPENED) or not self.compiled.facts.constraints:
            return status
        conditioning = self.out.projected[1, np.isfinite(self.out.states[0])]
        lost = len(conditioning) > 1 and conditioning[-1] < _SINGULAR * conditioning[0]
        return Status.LOCKED_UP if lost else status

    def _start(self) -> None:
        self.problem.piece[:] = self.problem.tracks.first[:-1]
        self.problem.m[:] = self.modes
        if self.begin is not None:
            self.begin()

    def _integrate(self, counts: NDArray[np.int64]) -> tuple[str, int]:
        """Name of the method and return code."""
        self._start()
        code = Status.TOO_MANY_STEPS.code
        if self.method != "implicit":
            code = integrate(self.problem, self.control, self.out, counts, self.feedback)
        if self.stiff is None or code != Status.TOO_MANY_STEPS.code:
            return "explicit", code
        self._start()
        counts[:] = 0
        return "implicit", implicit.integrate(self.problem, slopes_of(self.compiled), self.stiff(), self.out, counts)


def prepare(
    compiled: Compiled,
    p: Array,
    signals: Segments | Sequence[Segments],
    times: Array,
    *,
    tolerance: float = 1e-5,
    offset: Array | None = None,
    method: Method = "auto",
) -> Prepared:
    """Lay out a run from static equilibrium under what the signals are at ``times[0]``.

    Parameters
    ----------
    compiled : Compiled
        Model with native code; its free parameters bring their sensitivities along.
    p : ndarray, shape (n_parameters,)
        Parameter values, SI.
    signals : Segments or sequence of Segments
        Every track of the model against time (s): road heights (m), loads; one alone for a model with one track.
    times : ndarray, shape (n,)
        Output times, s, ascending.
    tolerance : float
        Relative error of the displacements.
    offset : ndarray, shape (n_states,), optional
        Added to the equilibrium: where the run starts.
    method : {"auto", "explicit", "implicit"}
        How to integrate; by itself the one that is likely to be faster, and exact propagation where that is possible.
    """
    check_method(method, compiled)
    n_q, n_v = compiled.facts.counts
    tracks = dict(zip(compiled.facts.tracks, [signals] if isinstance(signals, Segments) else signals, strict=True))
    still = compiled.inputs({name: float(signal.evaluate(times[:1])[0][0]) for name, signal in tracks.items()})
    rest = find_rest(compiled, p, still)
    x = rest.x if offset is None else rest.x + offset
    modes = rest.modes if offset is None else _modes(compiled, x, p, still)
    scale = state_scale(rest, n_q, n_v, _motion_size(tracks, rest.x[:n_q] - compiled.facts.start, offset))
    band = _dead_band(compiled, p, rest, scale, still)
    waves = max((_waves(signal) for signal in tracks.values()), default=0.0)
    limit = _explicit_limit(rest, waves)
    short = _edges_rule(tracks.values(), times, limit, tolerance)
    share = _SHORT_SHARE if short else STEP_SHARE
    control = Control(share * tolerance, 0.1 * scale, band, MAX_STEPS, _longest_step(limit, tolerance))
    start = np.concatenate([x, _rest_sensitivity(compiled, p, rest, still)])
    pieces = flatten([signal.with_finite_slopes() for signal in tracks.values()])
    values = compiled.extended(p)
    engine = compiled.short_engine if short else compiled.engine
    problem = Problem(engine, pieces, pieces.first[:-1].copy(), values, modes.copy(), start, len(still))
    exact = _exact(compiled, problem, control, times) if method == "auto" else None
    prepared = Prepared(compiled, problem, control, room(compiled, times), exact, modes, rest, still)
    if exact is not None or compiled.free or method == "explicit":
        return prepared
    pace = cache(lambda: pace_of(compiled, p, rest, still))

    @cache
    def stiff() -> Control:
        return control._replace(tolerance=IMPLICIT_SHARE * tolerance, longest=longest_step(pace(), waves, tolerance))

    long = limit * float(times[-1] - times[0]) > _LONG_RUN
    implicitly = method == "implicit" or (long and pays(pace(), waves, limit, tolerance))
    return replace(prepared, stiff=stiff, method="implicit" if implicitly else "explicit")


def room(compiled: Compiled, times: Array) -> Samples:
    """Arrays for a run sampled at ``times`` (s); what is not reached stays without a number."""
    facts, free, count = compiled.facts, len(compiled.free), len(times)
    n, outputs = len(facts.states), len(facts.outputs)
    return Samples(
        times,
        np.full((n, count), np.nan),
        np.empty((len(facts.tracks) * facts.track_order, count)),
        np.full((outputs, count), np.nan),
        np.empty((n + 2 if facts.projects else 0, count)),
        np.full((count, n * free), np.nan),
        np.full((count, outputs * (1 + free) if free else 0), np.nan),
    )


def solve(
    compiled: Compiled,
    p: Array,
    signals: Segments | Sequence[Segments],
    times: Array,
    *,
    tolerance: float = 1e-5,
    offset: Array | None = None,
    method: Method = "auto",
) -> Solution:
    """Run a model once; arguments as for :func:`prepare`."""
    return prepare(compiled, p, signals, times, tolerance=tolerance, offset=offset, method=method).run()


def _exact(compiled: Compiled, problem: Problem, control: Control, times: Array) -> linear_plan.Plan | None:
    """Plan of exact propagation; None when the model or the road is not for it."""
    zero, names = compiled.facts.linear_without, compiled.facts.parameters
    if compiled.free or zero is None or any(problem.p[names.index(name)] != 0.0 for name in zero):
        return None
    address = compiled.native.address
    calls = Calls(address["rate"], address["switch"], address.get("switch_many", 0), address["slopes"], SLOPE_LANES)
    return linear_plan.plan(problem, control, calls, compiled.shapes["slopes"][0], times)


def simulate(
    rig: Rig,
    trial: Trial,
    *,
    output_step: float = 1e-3,
    tolerance: float = 1e-5,
    method: Method = "auto",
    offset: dict[str, float] | None = None,
    detail: bool = False,
    check: bool = True,
    control: AnyControl | None = None,
) -> xr.Dataset:
    """Simulate a rig over a trial, from static equilibrium.

    Parameters
    ----------
    rig : Rig
        What is tested.
    trial : Trial
        Road and speed, or a base motion, and the duration.
    output_step : float
        Distance of the output samples, s.
    tolerance : float
        Relative error of the displacements.
    method : {"auto", "explicit", "implicit"}
        How to integrate: with steps as small as the fastest motion asks, or, where that is stiff and matters little,
        with the implicit method. By itself the one that is likely to be faster; ``attrs["method"]`` says which ran
        (``"exact"`` for models that are linear between their switches).
    offset : dict, optional
        Starts the run away from equilibrium: state, e.g. ``"sprung.z"`` or ``"sprung.vz"`` (`equilibrium` gives their
        names), to m or m/s (rad, rad/s); at rest otherwise.
    detail : bool
        For 3-D rigs also all hardpoints (m), joint reactions (N, N m, on the second body, ground axes), energies (J).
    check : bool
        Raise when the run does not reach its end; otherwise ``attrs["status"]`` says how it ended.
    control : Controller, str, Path or callable, optional
        Controls all struts (see ``jounce.control``): a controller, its name (``"skyhook"``), a TOML file, or a function
        ``control(measurement, t) -> command``. Adds ``command`` and ``actuator.force`` (N) of every corner.

    Returns
    -------
    xarray.Dataset
        One variable a channel on ``time`` (s), each with ``units`` (SI), ``long_name`` and ``place``. z is up,
        deflections and forces are positive in compression, accelerations are kinematic (zero at rest).

    Raises
    ------
    SimulationError
        When there is no equilibrium or, with ``check``, when the run does not reach its end.

    Examples
    --------
    >>> import jounce as jn
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="1 s")
    >>> run = jn.simulate(jn.load("kart-quarter-car"), trial)
    >>> bool(run["tyre.force"].min() == 0.0)   # the tyre lifts off
    True
    """
    check_settings(trial.duration, output_step, tolerance)
    check_method(method)
    from jounce.simulation.controlled import close_loop, complain  # they stand on this module
    from jounce.simulation.stability import check_stable

    loop = close_loop(rig, control)
    compiled = compile_rig(rig, detail=detail, actuator=loop.actuator if loop else None)
    p = compiled.parameter_values({**rig.parameters(), **(loop.parameters(compiled) if loop else {})})
    times = output_times(trial.duration, output_step)
    start = _offset(compiled, offset)
    signals = excitation(compiled.facts, rig, trial)
    if loop and method == "implicit":
        raise SimulationError("controlled runs are explicit", where="method", found=method, allowed="auto, explicit")
    if loop:
        signals, method = loop.with_rest(compiled, signals), "explicit"
    prepared = prepare(compiled, p, signals, times, tolerance=tolerance, offset=start, method=method)
    if loop:
        if check and prepared.rest is not None:
            check_stable(loop, compiled, p, prepared.rest, prepared.still)
        prepared = loop.around(compiled, prepared, signals)
    solution = prepared.run()
    if loop:
        complain(loop)
    solution = held_to_its_branch(compiled, solution)
    reach = samples_reached(solution, compiled.facts, check=check)
    channels = {
        output.name: (solution.outputs[i, :reach], output.unit, output.long_name)
        for i, output in enumerate(compiled.facts.outputs)
    }
    run = recording(times[:reach], channels)
    run.attrs["status"] = solution.status.name.lower()
    run.attrs["method"], run.attrs["steps"], run.attrs["events"] = solution.method, solution.steps, solution.events
    return run


def held_to_its_branch(compiled: Compiled, solution: Solution) -> Solution:
    """Give the run up to where a wheel flips over or a suspension runs away, with a status that says so."""
    left, status = flipped_at(compiled.output_names, solution.outputs), Status.FLIPPED
    if left is None and solution.status in (Status.COMPLETED, Status.NOT_FINITE):
        left, status = ran_away_at(compiled.output_names, solution.outputs), Status.RUN_AWAY
    if left is None:
        return solution
    solution.states[:, left + 1 :] = np.nan
    return replace(solution, status=status)


def check_settings(duration: float, output_step: float, tolerance: float) -> None:
    """Refuse an output step (s) or a tolerance that make no sense, and runs of more samples than memory holds."""
    if not (np.isfinite(output_step) and output_step > 0.0):
        raise SimulationError("not an output step", where="output_step", found=output_step, allowed="above 0 s")
    if duration / output_step > _MAX_SAMPLES:
        raise SimulationError(
            "too many samples",
            where="duration, output_step",
            found=f"{duration / output_step:.3g}",
            allowed=f"at most {_MAX_SAMPLES}",
            hint="Shorten the run or lengthen the output step.",
        )
    if not _FINEST <= tolerance <= _COARSEST:
        raise SimulationError(
            "not a tolerance", where="tolerance", found=tolerance, allowed=f"{_FINEST:g} to {_COARSEST:g}"
        )


def samples_reached(solution: Solution, facts: Facts, *, check: bool) -> int:
    """Number of samples that were computed; all of them, or an error with ``check``."""
    if solution.status is Status.COMPLETED:
        return len(solution.time)
    reached = int(np.sum(np.isfinite(solution.states[0])))
    if check:
        at = max(reached - 1, 0)
        last = f"it stopped after {solution.time[at]:.4g} s: {solution.status.help}{_pose(solution, facts, at)}"
        raise SimulationError(f"the run did not reach its end; {last}")
    return reached


def _pose(solution: Solution, facts: Facts, at: int) -> str:
    """Pose of a mechanism at a sample, where the mechanism is what stopped the run."""
    if solution.status not in (Status.LOOP_OPENED, Status.LOCKED_UP, Status.FLIPPED):
        return ""
    values = zip(facts.coordinates, solution.states[:, at], strict=False)
    return "; pose: " + ", ".join(f"{name} = {value:.5g}" for name, value in values)


def _offset(compiled: Compiled, offset: dict[str, float] | None) -> Array | None:
    if not offset:
        return None
    names = compiled.facts.states
    for name in offset:
        if name not in names:
            hint = nearest(name, names)
            raise SimulationError("not a state of the model", where=name, allowed=", ".join(names), hint=hint)
        if not np.isfinite(offset[name]):
            raise SimulationError(
                "not a finite number", where=f"offset: {name}", found=offset[name], allowed="m or m/s"
            )
    return np.array([offset.get(name, 0.0) for name in names])


def _motion_size(tracks: dict[str, Segments], rest: Array, offset: Array | None) -> float:
    """How far things will move, m: the roads' range or the start offset, at least a thousandth of the static drop."""
    moved = 0.0 if offset is None else float(np.max(np.abs(offset[: len(rest)])))
    roads = [_range(signal) for name, signal in tracks.items() if is_road(name)]
    return max(*roads, moved, 1e-3 * float(np.max(np.abs(rest))), 1e-9)


def _range(signal: Segments) -> float:
    """Difference of the highest and the lowest value, at the ends and in the middle of the pieces."""
    first, last = signal.edges[:-1], signal.edges[1:]
    points = np.concatenate([first, 0.5 * (first + last), np.nextafter(last, first)])
    return float(np.ptp(signal.evaluate(points)[0]))


def _modes(compiled: Compiled, x: Array, p: Array, u: Array) -> Array:
    modes = np.ones(len(compiled.facts.switches))
    values = compiled.evaluate("switch", x, u, p, modes)
    return (values > 0.0).astype(float)


def _longest_step(fastest: float, tolerance: float) -> float:
    """Step (s) beyond which the interpolant inside it would be worse than its end: a share of the fastest oscillation.

    In flight the wheel does not feel the road; this also keeps steps from passing over a whole contact.
    """
    return float(_LONGEST * (tolerance / 1e-5) ** 0.125 / fastest)


def _edges_rule(signals: Iterable[Segments], times: Array, limit: float, tolerance: float) -> bool:
    """Tell whether edges of the inputs keep steps so short that the pair of lower order needs fewer stages in all.

    Both pairs land on every edge; between two of them each takes as many steps as the tolerance asks.
    """
    inner = [signal.edges[(signal.edges > times[0]) & (signal.edges < times[-1])] for signal in signals]
    gaps = np.diff(np.unique(np.concatenate([times[:1], *inner, times[-1:]])))
    long, short = _longest_step(limit, tolerance), _SHORT * (tolerance / 1e-5) ** 0.2 / limit
    stages = [each * float(np.sum(np.ceil(gaps / step))) for each, step in ((_STAGES, long), (_SHORT_STAGES, short))]
    return stages[1] < stages[0]


def _waves(road: Segments) -> float:
    """Fastest sine of the road, rad/s."""
    return float(np.max(np.abs(road.coefficients[road.kind == SINE, 2]) * road.rate, initial=0.0))


def _explicit_limit(rest: Rest, waves: float) -> float:
    """What limits the steps of the explicit method, rad/s: the fastest oscillation, wave or decay."""
    f = len(rest.free)
    stiffness = np.max(np.abs(np.linalg.eigvals(rest.reduced[f : 2 * f, :f])), initial=0.0)
    decay = float(np.max(np.abs(np.linalg.eigvals(rest.reduced)), initial=0.0))
    return max(float(np.sqrt(stiffness)), waves, _STABLE * decay, 1e-3)


def _dead_band(compiled: Compiled, p: Array, rest: Rest, scale: Array, u: Array) -> Array:
    """How far a switching function may be on the wrong side: 1e-9 of what a typical motion makes of it."""
    if not compiled.facts.switches:
        return np.zeros(0)
    moved = compiled.evaluate("switch", rest.x + scale, u, p, rest.modes)
    still = compiled.evaluate("switch", rest.x, u, p, rest.modes)
    return np.asarray(1e-9 * np.abs(moved - still) + 1e-14)


def _rest_sensitivity(compiled: Compiled, p: Array, rest: Rest, u: Array) -> Array:
    """How the equilibrium moves with the free parameters (implicit function theorem), state after state."""
    if not compiled.free:
        return np.zeros(0)
    rate, loops = compiled.free_slopes(rest.x, u, p, rest.modes)
    if len(loops):
        shift = np.linalg.lstsq(rest.balance, -np.vstack([rate[rest.rows], loops]), rcond=None)[0]
    else:
        shift = np.linalg.solve(rest.balance, -rate[rest.rows])
    return np.asarray((rest.moved @ shift).ravel())
