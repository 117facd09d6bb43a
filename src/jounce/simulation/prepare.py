"""Preparation of runs: equilibrium, typical sizes, method, step control and all arrays, computed before the run."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import SimulationError
from jounce.core.phrases import Phrase
from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.kernel.engine import NO_FEEDBACK, Control, Feedback, Problem, Samples, Status, flatten
from jounce.kernel.methods import explicit, implicit
from jounce.kernel.methods.exact import Plan, plan, propagate
from jounce.kernel.methods.propagators import Calls
from jounce.mechanics.facts import SLOPE_LANES, is_road
from jounce.simulation.compiled import Compiled
from jounce.simulation.result import Solution
from jounce.simulation.settings import MAX_STEPS, Method
from jounce.simulation.statics import Equilibrium, find_equilibrium, state_scale

# The share of the tolerance per step with which a whole run meets its tolerance was determined on the shipped models,
# several roads and speeds (tests/physics/test_tolerance.py): errors of steps add up, and accelerations are not
# controlled.
STEP_SHARE = 0.003  # share of the tolerance for one step of the explicit method
_SHORT_SHARE = 0.03  # as above for the pair of lower order, whose total error is smaller for the same error per step
IMPLICIT_SHARE = (
    0.08  # as above for the implicit method: stiff parts with dry friction need the smaller share
)
_LONGEST, _SHORT, _IMPLICIT = (
    1.2,
    0.4,
    1.2,
)  # radians of the fastest motion in one step of each method at a tolerance of 1e-5
_STAGES, _SHORT_STAGES = (
    16.0,
    7.0,
)  # rate evaluations in a step of either pair, including its interpolant
_STABLE = 0.4  # share of the fastest decay at rest that the method must resolve: friction soon starts to slide
_LONG_RUN = (
    5000.0  # radians of the fastest motion: shorter runs take less time than the choice of a method
)
_FASTER = 4.0  # the implicit method is faster if it needs fewer steps by at least this factor
_CARRIED = (
    1e-2  # modes with at least this share of the quasi-static motion must be visible in the samples
)
_FELT = 300.0  # in tolerances: oscillations of modes with at least this share must be resolved
_HOPELESS = (
    MAX_STEPS  # of the longest length that a run needs: it would stop there after ten seconds
)
_SINGULAR = (
    0.05  # a mechanism counts as locked up below this share of the loops' initial conditioning
)


@dataclass(frozen=True)
class PreparedRun:
    """A run with everything allocated and precomputed; ``run`` may be called repeatedly and writes to ``out``.

    ``stiff`` returns the control of the implicit method, None if only the explicit method is possible; ``method`` is
    tried first. If an explicit run exceeds its number of steps, the implicit method is tried. ``equilibrium`` is that
    under the inputs ``still``, if the run starts from one; ``feedback`` is a controller, ``begin`` resets its state.
    """

    compiled: Compiled
    problem: Problem
    control: Control
    out: Samples
    exact: Plan | None
    modes: Array
    equilibrium: Equilibrium | None
    still: Array
    stiff: Callable[[], Control] | None = None
    method: Method = "explicit"
    feedback: Feedback = NO_FEEDBACK
    begin: Callable[[], None] | None = None

    def run(self) -> Solution:
        """Fill the arrays and return how the run ended."""
        counts, method = np.zeros(3, dtype=np.int64), "exact"
        if self.exact is not None:
            self.start()
            code = propagate(self.problem, self.control, self.exact, self.out, counts)
        else:
            method, code = self._integrate(counts)
        out, free = self.out, len(self.compiled.free)
        tables = ((out.states, out.tangents), (out.outputs, out.carried[:, len(out.outputs) :]))
        slopes = [
            table.reshape(len(out.times), len(of), free).transpose(1, 2, 0) for of, table in tables
        ]
        steps, rejected, events = (int(count) for count in counts)
        arrays = (out.times, out.states, out.outputs, self._status_of(Status.of(code)))
        return Solution(*arrays, steps, rejected, events, slopes[0], slopes[1], method)

    def _status_of(self, status: Status) -> Status:
        """Return the status of the run; a diverged run whose loops approach a singular configuration has locked up."""
        if status in (Status.COMPLETED, Status.LOOP_OPENED) or not self.compiled.facts.constraints:
            return status
        conditioning = self.out.projected[1, np.isfinite(self.out.states[0])]
        lost = len(conditioning) > 1 and conditioning[-1] < _SINGULAR * conditioning[0]
        return Status.LOCKED_UP if lost else status

    def start(self) -> None:
        """Reset all state changed by a previous run."""
        self.problem.piece[:] = self.problem.tracks.first[:-1]
        self.problem.m[:] = self.modes
        if self.begin is not None:
            self.begin()

    def _integrate(self, counts: NDArray[np.int64]) -> tuple[str, int]:
        """Integrate and return the name of the method and the return code."""
        self.start()
        code = Status.TOO_MANY_STEPS.code
        if self.method != "implicit":
            code = explicit.integrate(self.problem, self.control, self.out, counts, self.feedback)
        if self.stiff is None or code != Status.TOO_MANY_STEPS.code:
            return "explicit", code
        from jounce.simulation.linear_systems import slopes_of

        self.start()
        counts[:] = 0
        return "implicit", implicit.integrate(
            self.problem, slopes_of(self.compiled), self.stiff(), self.out, counts
        )


def prepare(
    compiled: Compiled,
    p: Array,
    signals: Segments | Sequence[Segments],
    times: Array,
    *,
    tolerance: float = 1e-5,
    offset: Array | None = None,
    method: Method = "auto",
    along: Array | None = None,
    out: Samples | None = None,
) -> PreparedRun:
    """Prepare a run from static equilibrium under the signals at ``times[0]``.

    The output ``times`` (s) ascend. ``p`` contains all parameter values, SI; free parameters of the model add their
    sensitivities (``along`` as in :meth:`Compiled.extended`). ``signals`` contains every track against time: road
    heights (m), loads; or one signal for a model with one track. ``tolerance`` and ``method`` are as in
    :class:`RunSettings`. The run starts at the equilibrium plus ``offset`` and fills ``out``, or new arrays.
    """
    if method == "implicit" and compiled.free:
        raise SimulationError(
            "the implicit method does not support sensitivities",
            where="method",
            found=f"implicit, with {len(compiled.free)} free parameters",
            allowed="auto, explicit",
        )
    n_q, n_v = compiled.facts.counts
    tracks = dict(
        zip(
            compiled.facts.tracks,
            [signals] if isinstance(signals, Segments) else signals,
            strict=True,
        )
    )
    still = compiled.inputs(
        {name: float(signal.evaluate(times[:1])[0][0]) for name, signal in tracks.items()}
    )
    rest = find_equilibrium(compiled, p, still)
    x = rest.x if offset is None else rest.x + offset
    modes = rest.modes if offset is None else compiled.sides(x, still, p)
    scale = state_scale(
        rest, n_q, n_v, _motion_size(tracks, rest.x[:n_q] - compiled.facts.start, offset)
    )
    band = dead_band(compiled, p, rest, scale, still)
    pieces = flatten([signal.with_finite_slopes() for signal in tracks.values()])
    problem = Problem(
        compiled.engine,
        pieces,
        pieces.first[:-1].copy(),
        compiled.extend(p, along),
        modes.copy(),
        np.concatenate([x, _equilibrium_sensitivity(compiled, p, rest, still, along)]),
        len(still),
    )
    control = Control(
        STEP_SHARE * tolerance, 0.1 * scale, band, MAX_STEPS, float(times[-1] - times[0])
    )
    exact = _exact(compiled, problem, control, times) if method == "auto" else None
    out = room(compiled, times) if out is None else out
    prepared = PreparedRun(compiled, problem, control, out, exact, modes, rest, still)
    if exact is not None:  # exact propagation has no error to control
        return prepared
    waves = max((signal.fastest_wave for signal in tracks.values()), default=0.0)
    limit = float(explicit_limit(rest.fastest_oscillation, rest.fastest_decay, waves))
    control = control._replace(longest=longest_step(limit, tolerance))
    if _edges_set_the_step(tracks.values(), times, limit, tolerance):
        control = control._replace(tolerance=_SHORT_SHARE * tolerance)
        problem = problem._replace(engine=compiled.short_engine)
    prepared = replace(prepared, problem=problem, control=control)
    duration = float(times[-1] - times[0])
    hopeless = _HOPELESS if offset is None else math.inf  # rates differ away from rest
    if compiled.free or method == "explicit":
        _check_steps(duration / control.longest, hopeless, limit, duration)
        return prepared
    # The modes are examined only if the implicit method may be used: they cost as much as a short run.
    shares = cache(lambda: modal_shares(compiled, p, rest, still))

    @cache
    def stiff() -> Control:
        # In a longer step, samples would be less accurate than its end, or a contact could be missed.
        longest = longest_implicit_step(max(shares().fastest(_CARRIED), waves, 1e-3), tolerance)
        return control._replace(tolerance=IMPLICIT_SHARE * tolerance, longest=longest)

    long = limit * duration > _LONG_RUN
    implicitly = method == "implicit" or (
        long and implicit_is_faster(shares(), waves, limit, tolerance)
    )
    if implicitly or duration / control.longest > hopeless:
        implicitly = True  # otherwise it would start only after all steps of the explicit method
        fastest = shares().fastest(_CARRIED)
        place = compiled.facts.states[shares().place_of(fastest)] if fastest > waves else ""
        _check_steps(duration / stiff().longest, hopeless, max(fastest, waves), duration, place)
    return replace(prepared, stiff=stiff, method="implicit" if implicitly else "explicit")


def dead_band(compiled: Compiled, p: Array, rest: Equilibrium, scale: Array, u: Array) -> Array:
    """Return the tolerance of each switching function about zero: 1e-9 of its change in a typical motion."""
    if not compiled.facts.switches:
        return np.zeros(0)
    changed, at_rest = (
        compiled.evaluate("switch", where, u, p, rest.modes) for where in (rest.x + scale, rest.x)
    )
    return np.asarray(1e-9 * np.abs(changed - at_rest) + 1e-14)


def _check_steps(steps: float, most: float, rate: float, duration: float, place: str = "") -> None:
    """Refuse a run whose fastest motion (rad/s) over its duration (s) needs more steps than allowed."""
    if steps > most:
        raise SimulationError(
            "the fastest motion is too fast for a run of this length",
            where=place,
            found=f"{rate / (2.0 * math.pi):.3g} Hz for {duration:.4g} s, {steps:.2g} steps at least",
            allowed=Phrase("{most:.2g} steps", most=most),
            hint="Check masses and stiffnesses for wrong units, or shorten the run.",
        )


def room(compiled: Compiled, times: Array, outputs: int | None = None) -> Samples:
    """Allocate the arrays of a run sampled at ``times`` (s), for all or ``outputs`` outputs, filled with NaN."""
    facts, free, count = compiled.facts, len(compiled.free), len(times)
    n, outputs = len(facts.states), len(facts.outputs) if outputs is None else outputs
    return Samples(
        np.ascontiguousarray(times, dtype=np.float64),
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
    return prepare(
        compiled, p, signals, times, tolerance=tolerance, offset=offset, method=method
    ).run()


def _exact(compiled: Compiled, problem: Problem, control: Control, times: Array) -> Plan | None:
    """Return the plan of exact propagation; None if the model or the road does not allow it."""
    zero, names = compiled.facts.linear_without, compiled.facts.parameters
    if compiled.free or zero is None or any(problem.p[names.index(name)] != 0.0 for name in zero):
        return None
    address = compiled.native.address
    calls = Calls(
        address["rate"],
        address["switch"],
        address.get("switch_many", 0),
        address["slopes"],
        SLOPE_LANES,
    )
    return plan(problem, control, calls, compiled.shapes["slopes"][0], times)


@dataclass(frozen=True)
class ModalShares:
    """Undamped natural frequencies at rest (rad/s), and each mode's share of the quasi-static motion over the road.

    ``place`` is the index of the state with the largest motion in each mode.
    """

    frequency: Array
    share: Array
    place: NDArray[np.int64]

    def fastest(self, share: float) -> float:
        """Return the highest frequency (rad/s) among the modes with at least this share."""
        return float(np.max(self.frequency[self.share >= share], initial=0.0))

    def place_of(self, frequency: float) -> int:
        """Return the index of the state with the largest motion in the mode of a frequency (rad/s)."""
        return int(self.place[np.argmin(np.abs(self.frequency - frequency))])


def modal_shares(compiled: Compiled, p: Array, rest: Equilibrium, u: Array) -> ModalShares:
    """Return the undamped modes that a road can excite; friction is ignored since it soon starts to slide."""
    f, order = len(rest.free), compiled.facts.track_order
    squares, shapes = np.linalg.eig(-rest.reduced[f : 2 * f, :f])
    pull = rest.pick[f : 2 * f] @ compiled.evaluate("rate_u", rest.x, u, p, rest.modes)[:, ::order]
    firm = np.where(
        squares == 0.0, np.inf, squares
    )  # a neutral motion, such as yaw, has no quasi-static response
    weights = np.linalg.norm(
        np.linalg.lstsq(shapes, pull.astype(complex), rcond=None)[0] / firm[:, None], axis=1
    )
    displacements = rest.lift[: compiled.facts.counts[0], :f] @ shapes
    sizes = weights * np.linalg.norm(displacements, axis=0)
    shares = sizes / max(float(np.max(sizes, initial=0.0)), 1e-300)
    return ModalShares(np.sqrt(np.abs(squares)), shares, np.argmax(np.abs(displacements), axis=0))


def implicit_is_faster(
    shares: ModalShares, waves: float, explicit: float, tolerance: float
) -> bool:
    """Whether the explicit method's limit is too far above the fastest relevant motion or road wave (all rad/s)."""
    return explicit > _FASTER * max(shares.fastest(_FELT * tolerance), waves)


def longest_implicit_step(fastest: float, tolerance: float) -> float:
    """Return the longest step (s) for the fastest motion (rad/s) visible in samples; the interpolant has order 4."""
    return float(_IMPLICIT * (tolerance / 1e-5) ** 0.2 / fastest)


def _motion_size(tracks: dict[str, Segments], rest: Array, offset: Array | None) -> float:
    """Return the typical motion (m): roads' range or start offset, at least a thousandth of the static deflection."""
    shift = 0.0 if offset is None else float(np.max(np.abs(offset[: len(rest)])))
    roads = [signal.extent for name, signal in tracks.items() if is_road(name)]
    return max(*roads, shift, 1e-3 * float(np.max(np.abs(rest))), 1e-9)


def longest_step(fastest: float, tolerance: float) -> float:
    """Return the step (s) above which the interpolant would be less accurate than the step's end.

    It is a share of the period of the fastest oscillation. It also prevents a step from skipping a whole contact after
    a flight, during which the road does not act on the wheel.
    """
    return float(_LONGEST * (tolerance / 1e-5) ** 0.125 / fastest)


def _edges_set_the_step(
    signals: Iterable[Segments], times: Array, limit: float, tolerance: float
) -> bool:
    """Whether edges of the inputs limit steps so much that the pair of lower order needs fewer stages in total.

    Steps of both pairs end on every edge; between edges each takes as many steps as the tolerance requires.
    """
    inner = [
        signal.edges[(signal.edges > times[0]) & (signal.edges < times[-1])] for signal in signals
    ]
    gaps = np.diff(np.unique(np.concatenate([times[:1], *inner, times[-1:]])))
    long, short = longest_step(limit, tolerance), _SHORT * (tolerance / 1e-5) ** 0.2 / limit
    stages = [
        each * float(np.sum(np.ceil(gaps / step)))
        for each, step in ((_STAGES, long), (_SHORT_STAGES, short))
    ]
    return stages[1] < stages[0]


def explicit_limit(oscillation: Array | float, decay: Array | float, waves: float) -> Array:
    """Return the rate that limits explicit steps, rad/s: the fastest oscillation, wave or decay."""
    # Undamped oscillations: a soft mode with a stiff damper decays but does not oscillate.
    return np.maximum(np.maximum(oscillation, _STABLE * np.asarray(decay)), max(waves, 1e-3))


def _equilibrium_sensitivity(
    compiled: Compiled, p: Array, rest: Equilibrium, u: Array, along: Array | None
) -> Array:
    """Return the derivatives of the equilibrium by the free parameters (implicit function theorem), state by state."""
    if not compiled.free:
        return np.zeros(0)
    rate, loops = compiled.free_slopes(rest.x, u, p, rest.modes, along)
    if len(loops):
        shift = np.linalg.lstsq(rest.balance, -np.vstack([rate[rest.rows], loops]), rcond=None)[0]
    else:
        shift = np.linalg.solve(rest.balance, -rate[rest.rows])
    return np.asarray((rest.moved @ shift).ravel())
