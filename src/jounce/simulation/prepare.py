"""A run laid out: equilibrium, sizes, method and step control, and all arrays; running it only computes."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import SimulationError
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

# How tight a step must be held so that a whole run keeps its tolerance was tried out on the shipped models, several
# roads and speeds (tests/physics/test_tolerance.py): errors of single steps add up, and accelerations are not looked
# at.
STEP_SHARE = 0.003  # of the tolerance for one step of the explicit method
_SHORT_SHARE = 0.03  # the same for the pair of lower order, which errs less in all for what it allows in a step
IMPLICIT_SHARE = 0.08  # the same for the implicit method: stiff parts with dry friction need the more careful share
_LONGEST, _SHORT, _IMPLICIT = 1.2, 0.4, 1.2  # radians of the fastest motion in one step of each at a tolerance of 1e-5
_STAGES, _SHORT_STAGES = 16.0, 7.0  # rates that a step of either pair evaluates, with its interpolant
_STABLE = 0.4  # share of the fastest decay at rest that the method must resolve: friction holding a rig, sensitivities
_LONG_RUN = 5000.0  # radians of the fastest motion, beyond which it is worth asking for the implicit method
_FASTER = 4.0  # steps of the explicit method for one of the implicit method, above which the latter is faster
_CARRIED = 1e-2  # share of the quasi-static motion at which a mode must be seen in the samples
_FELT = 300.0  # tolerances: share at which a mode must be followed through its oscillations
_HOPELESS = MAX_STEPS  # of the longest length that a run needs: it would end there, ten seconds later
_SINGULAR = 0.05  # share of the loops' conditioning at the start that is left where a mechanism counts as locked up


@dataclass(frozen=True)
class Prepared:
    """A run with everything laid out: ``run`` only computes, into ``out``, as often as wanted.

    ``stiff`` says how the implicit method is steered, None where there is only the explicit one; ``method`` is the one
    used first. In place of an explicit run that used up its steps the implicit method has a try. ``equilibrium`` is
    that under the inputs ``still``, if it starts from one; ``feedback`` is a controller, and ``begin`` sets back
    what it keeps.
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
        """Fill the arrays and say how the run ended."""
        counts, method = np.zeros(3, dtype=np.int64), "exact"
        if self.exact is not None:
            self.start()
            code = propagate(self.problem, self.control, self.exact, self.out, counts)
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

    def start(self) -> None:
        """Set back what a run before has moved."""
        self.problem.piece[:] = self.problem.tracks.first[:-1]
        self.problem.m[:] = self.modes
        if self.begin is not None:
            self.begin()

    def _integrate(self, counts: NDArray[np.int64]) -> tuple[str, int]:
        """Name of the method and return code."""
        self.start()
        code = Status.TOO_MANY_STEPS.code
        if self.method != "implicit":
            code = explicit.integrate(self.problem, self.control, self.out, counts, self.feedback)
        if self.stiff is None or code != Status.TOO_MANY_STEPS.code:
            return "explicit", code
        from jounce.simulation.linear_systems import slopes_of

        self.start()
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
    along: Array | None = None,
    out: Samples | None = None,
) -> Prepared:
    """Lay out a run from static equilibrium under what the signals are at ``times[0]``.

    The output ``times`` (s) ascend. ``p`` are all parameter values, SI; the free ones of the model bring their
    sensitivities along (``along`` is as :meth:`Compiled.extended` has it). ``signals`` has every track against time:
    road heights (m), loads; one alone for a model with one track. ``tolerance`` and ``method`` are as
    :class:`RunSettings` has them; ``offset`` is added to the equilibrium: where the run starts. It fills ``out``, in
    place of new arrays.
    """
    if method == "implicit" and compiled.free:
        raise SimulationError(
            "the implicit method carries no sensitivities",
            where="method",
            found=f"implicit, with {len(compiled.free)} free parameters",
            allowed="auto, explicit",
        )
    n_q, n_v = compiled.facts.counts
    tracks = dict(zip(compiled.facts.tracks, [signals] if isinstance(signals, Segments) else signals, strict=True))
    still = compiled.inputs({name: float(signal.evaluate(times[:1])[0][0]) for name, signal in tracks.items()})
    rest = find_equilibrium(compiled, p, still)
    x = rest.x if offset is None else rest.x + offset
    modes = rest.modes if offset is None else compiled.sides(x, still, p)
    scale = state_scale(rest, n_q, n_v, _motion_size(tracks, rest.x[:n_q] - compiled.facts.start, offset))
    band = dead_band(compiled, p, rest, scale, still)
    pieces = flatten([signal.with_finite_slopes() for signal in tracks.values()])
    problem = Problem(
        compiled.engine,
        pieces,
        pieces.first[:-1].copy(),
        compiled.extended(p, along),
        modes.copy(),
        np.concatenate([x, _equilibrium_sensitivity(compiled, p, rest, still, along)]),
        len(still),
    )
    control = Control(STEP_SHARE * tolerance, 0.1 * scale, band, MAX_STEPS, float(times[-1] - times[0]))
    exact = _exact(compiled, problem, control, times) if method == "auto" else None
    out = room(compiled, times) if out is None else out
    prepared = Prepared(compiled, problem, control, out, exact, modes, rest, still)
    if exact is not None:  # whose steps have no error that could be controlled
        return prepared
    waves = max((signal.fastest_wave for signal in tracks.values()), default=0.0)
    limit = float(explicit_limit(rest.fastest_oscillation, rest.fastest_decay, waves))
    control = control._replace(longest=longest_step(limit, tolerance))
    if _edges_set_the_step(tracks.values(), times, limit, tolerance):
        control = control._replace(tolerance=_SHORT_SHARE * tolerance)
        problem = problem._replace(engine=compiled.short_engine)
    prepared = replace(prepared, problem=problem, control=control)
    lasting = float(times[-1] - times[0])
    hopeless = _HOPELESS if offset is None else math.inf  # away from rest other rates hold
    if compiled.free or method == "explicit":
        _check_steps(lasting / control.longest, hopeless, limit, lasting)
        return prepared
    # The modes are only looked at where the implicit method may have its turn: they cost as much as a short run.
    shares = cache(lambda: modal_shares(compiled, p, rest, still))

    @cache
    def stiff() -> Control:
        # Beyond this step samples inside it would be worse than its end, or a contact could be passed over.
        longest = longest_implicit_step(max(shares().fastest(_CARRIED), waves, 1e-3), tolerance)
        return control._replace(tolerance=IMPLICIT_SHARE * tolerance, longest=longest)

    long = limit * lasting > _LONG_RUN
    implicitly = method == "implicit" or (long and implicit_is_faster(shares(), waves, limit, tolerance))
    if implicitly or lasting / control.longest > hopeless:
        implicitly = True  # or it would have its turn after all steps of the explicit method
        fastest = shares().fastest(_CARRIED)
        place = compiled.facts.states[shares().place_of(fastest)] if fastest > waves else ""
        _check_steps(lasting / stiff().longest, hopeless, max(fastest, waves), lasting, place)
    return replace(prepared, stiff=stiff, method="implicit" if implicitly else "explicit")


def dead_band(compiled: Compiled, p: Array, rest: Equilibrium, scale: Array, u: Array) -> Array:
    """How far each switching function may be on the wrong side: 1e-9 of what a typical motion makes of it."""
    if not compiled.facts.switches:
        return np.zeros(0)
    moved, there = (compiled.evaluate("switch", where, u, p, rest.modes) for where in (rest.x + scale, rest.x))
    return np.asarray(1e-9 * np.abs(moved - there) + 1e-14)


def _check_steps(steps: float, most: float, rate: float, lasting: float, place: str = "") -> None:
    """Refuse a run whose fastest motion (rad/s), followed for so long (s), takes more steps than there may be."""
    if steps > most:
        raise SimulationError(
            "the fastest motion is too fast for a run as long as this",
            where=place,
            found=f"{rate / (2.0 * math.pi):.3g} Hz for {lasting:.4g} s, {steps:.2g} steps at least",
            allowed=f"{most:.2g} steps",
            hint="Check masses and stiffnesses for slips in their units, or shorten the run.",
        )


def room(compiled: Compiled, times: Array, outputs: int | None = None) -> Samples:
    """Arrays for a run sampled at ``times`` (s), of all ``outputs`` or so many; what is not reached has no number."""
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
    return prepare(compiled, p, signals, times, tolerance=tolerance, offset=offset, method=method).run()


def _exact(compiled: Compiled, problem: Problem, control: Control, times: Array) -> Plan | None:
    """Plan of exact propagation; None when the model or the road is not for it."""
    zero, names = compiled.facts.linear_without, compiled.facts.parameters
    if compiled.free or zero is None or any(problem.p[names.index(name)] != 0.0 for name in zero):
        return None
    address = compiled.native.address
    calls = Calls(address["rate"], address["switch"], address.get("switch_many", 0), address["slopes"], SLOPE_LANES)
    return plan(problem, control, calls, compiled.shapes["slopes"][0], times)


@dataclass(frozen=True)
class ModalShares:
    """Undamped natural frequencies at rest (rad/s) and what share of the quasi-static motion over the road each has.

    ``place`` is the number of the state that each moves most.
    """

    frequency: Array
    share: Array
    place: NDArray[np.int64]

    def fastest(self, share: float) -> float:
        """Highest frequency (rad/s) among the modes with at least a share."""
        return float(np.max(self.frequency[self.share >= share], initial=0.0))

    def place_of(self, frequency: float) -> int:
        """Number of the state that the mode of a frequency (rad/s) moves most."""
        return int(self.place[np.argmin(np.abs(self.frequency - frequency))])


def modal_shares(compiled: Compiled, p: Array, rest: Equilibrium, u: Array) -> ModalShares:
    """Find out which modes a road can move, without damping, since friction that sticks at rest soon slides."""
    f, order = len(rest.free), compiled.facts.track_order
    squares, shapes = np.linalg.eig(-rest.reduced[f : 2 * f, :f])
    pulled = rest.pick[f : 2 * f] @ compiled.evaluate("rate_u", rest.x, u, p, rest.modes)[:, ::order]
    firm = np.where(squares == 0.0, np.inf, squares)  # what nothing holds, such as yaw, has no quasi-static motion
    weights = np.linalg.norm(np.linalg.lstsq(shapes, pulled.astype(complex), rcond=None)[0] / firm[:, None], axis=1)
    moved = rest.lift[: compiled.facts.counts[0], :f] @ shapes
    sizes = weights * np.linalg.norm(moved, axis=0)
    shares = sizes / max(float(np.max(sizes, initial=0.0)), 1e-300)
    return ModalShares(np.sqrt(np.abs(squares)), shares, np.argmax(np.abs(moved), axis=0))


def implicit_is_faster(shares: ModalShares, waves: float, explicit: float, tolerance: float) -> bool:
    """Compare what limits the explicit method with the fastest motion that matters or wave of the road (all rad/s)."""
    return explicit > _FASTER * max(shares.fastest(_FELT * tolerance), waves)


def longest_implicit_step(fastest: float, tolerance: float) -> float:
    """Longest step (s) for the fastest motion (rad/s) that samples must show; the interpolant is of order 4."""
    return float(_IMPLICIT * (tolerance / 1e-5) ** 0.2 / fastest)


def _motion_size(tracks: dict[str, Segments], rest: Array, offset: Array | None) -> float:
    """How far things will move, m: the roads' range or the start offset, at least a thousandth of the static drop."""
    moved = 0.0 if offset is None else float(np.max(np.abs(offset[: len(rest)])))
    roads = [signal.extent for name, signal in tracks.items() if is_road(name)]
    return max(*roads, moved, 1e-3 * float(np.max(np.abs(rest))), 1e-9)


def longest_step(fastest: float, tolerance: float) -> float:
    """Step (s) beyond which the interpolant inside it would be worse than its end: a share of the fastest oscillation.

    In flight the wheel does not feel the road; this also keeps steps from passing over a whole contact.
    """
    return float(_LONGEST * (tolerance / 1e-5) ** 0.125 / fastest)


def _edges_set_the_step(signals: Iterable[Segments], times: Array, limit: float, tolerance: float) -> bool:
    """Tell whether edges of the inputs keep steps so short that the pair of lower order needs fewer stages in all.

    Both pairs land on every edge; between two of them each takes as many steps as the tolerance asks.
    """
    inner = [signal.edges[(signal.edges > times[0]) & (signal.edges < times[-1])] for signal in signals]
    gaps = np.diff(np.unique(np.concatenate([times[:1], *inner, times[-1:]])))
    long, short = longest_step(limit, tolerance), _SHORT * (tolerance / 1e-5) ** 0.2 / limit
    stages = [each * float(np.sum(np.ceil(gaps / step))) for each, step in ((_STAGES, long), (_SHORT_STAGES, short))]
    return stages[1] < stages[0]


def explicit_limit(oscillation: Array | float, decay: Array | float, waves: float) -> Array:
    """What limits the steps of the explicit method, rad/s: the fastest oscillation, wave or decay."""
    # The oscillations are those without damping: a stiff damper of a soft mode decays but does not oscillate.
    return np.maximum(np.maximum(oscillation, _STABLE * np.asarray(decay)), max(waves, 1e-3))


def _equilibrium_sensitivity(compiled: Compiled, p: Array, rest: Equilibrium, u: Array, along: Array | None) -> Array:
    """How the equilibrium moves with the free parameters (implicit function theorem), state after state."""
    if not compiled.free:
        return np.zeros(0)
    rate, loops = compiled.free_slopes(rest.x, u, p, rest.modes, along)
    if len(loops):
        shift = np.linalg.lstsq(rest.balance, -np.vstack([rate[rest.rows], loops]), rcond=None)[0]
    else:
        shift = np.linalg.solve(rest.balance, -rate[rest.rows])
    return np.asarray((rest.moved @ shift).ravel())
