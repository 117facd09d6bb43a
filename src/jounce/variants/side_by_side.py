"""Variants of a piecewise linear model in vector registers: native code that sums the samples of their outputs."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from jounce.core.errors import SimulationError
from jounce.core.segments import CIRCLE, Segments
from jounce.core.types import Array
from jounce.kernel.engine import Control, Problem, Samples, flatten
from jounce.kernel.methods import lanes
from jounce.kernel.methods.exact import (
    MOST_WAVES,
    parts_for,
    rate_bound_of,
    run_of,
    signals_of,
    typical_step,
)
from jounce.kernel.methods.propagators import Calls, propagators, terms_of
from jounce.mechanics.facts import SLOPE_LANES
from jounce.simulation.compiled import Compiled
from jounce.simulation.prepare import dead_band
from jounce.simulation.statics import find_equilibrium, state_scale
from jounce.variants.threads import processors, share

_SPARE = 1.3  # largest ratio of a variant's rates to those for which the step is chosen
LEAST = 4
"""Number of variants below which the shared preparation takes longer than individual runs."""
_FEW = 64  # variants below which a further thread gains nothing
_TURNS = 4  # a worker takes this fraction of its equal share of the remaining variants at a time
_MOST_STEPS = 20_000_000  # of a variant: longer runs are integrated one by one
_LINE = 64  # bytes of a line of the processor's cache


@dataclass(frozen=True)
class Sums:
    """Results of each variant and channel: mean, mean square, minimum and maximum about ``rest``.

    All have one row per variant; ``rest`` is the value at rest. ``alone`` flags variants without results: they have
    different contacts at rest, or cannot be integrated with the common step. ``events`` counts switching events.
    ``sums`` are the raw sums over ``samples`` samples.
    """

    sums: Array
    samples: int
    rest: Array
    alone: NDArray[np.bool_]
    events: NDArray[np.int64]

    @property
    def mean(self) -> Array:
        """Mean about the value at rest."""
        return np.asarray(self.sums[:, 0 :: lanes.SUMS] / self.samples)

    @property
    def square(self) -> Array:
        """Mean square about the value at rest."""
        return np.asarray(self.sums[:, 1 :: lanes.SUMS] / self.samples)

    @property
    def least(self) -> Array:
        """Minimum relative to the value at rest."""
        return self.sums[:, 2 :: lanes.SUMS]

    @property
    def most(self) -> Array:
        """Maximum relative to the value at rest."""
        return self.sums[:, 3 :: lanes.SUMS]


@dataclass(frozen=True)
class SharedLayout:
    """Preparation shared by all variants of a model over one trial, without their parameters and arrays.

    Parameters with the indices ``zero`` must be 0; ``samples`` is the number of samples. ``rooms`` are work arrays
    released by threads for reuse, since allocating one takes as long as a dozen variants.
    """

    work: lanes.Work
    zero: tuple[int, ...]
    samples: int
    rooms: list[lanes.Work] = field(default_factory=list, compare=False)


def sums_side_by_side(
    layout: SharedLayout,
    parameters: Array,
    threads: int | None = None,
    meanwhile: Callable[[], object] | None = None,
) -> Sums | None:
    """Run variants, one row of parameter values (SI) each; None if they cannot run in vectors or are too few.

    ``meanwhile`` is other work for this thread while the others wake up.
    """
    count = len(parameters)
    if count < LEAST or np.any(parameters[:, list(layout.zero)] != 0.0):
        return None
    channels = len(layout.work.chosen)
    sums, rest = np.full((count, lanes.SUMS * channels), np.nan), np.full((count, channels), np.nan)
    events, alone = np.zeros((2, count), dtype=np.int64)
    rows = np.ascontiguousarray(parameters)

    def take(spans: Iterator[tuple[int, int]]) -> None:
        """Take the next span as soon as one is finished."""
        try:
            room = layout.rooms.pop()
        except IndexError:
            room = _with_own_arrays(layout.work)
        own = room._replace(parameters=rows, sums=sums, rest=rest, events=events, alone=alone)
        for span in spans:
            own.span[:] = span
            lanes.follow(own)
        layout.rooms.append(room)

    workers = min(threads or processors(), max(count // _FEW, 1))
    share(_spans(count, layout.work.room.kept.shape[1], workers), take, workers, meanwhile)
    return Sums(sums, layout.samples, rest, alone == 1, events)


def lay_out(
    compiled: Compiled,
    base: Array,
    signals: Sequence[Segments],
    times: Array,
    channels: Sequence[int],
) -> SharedLayout | None:
    """Prepare what variants of a model share over one trial; None if the model or the trial is not suitable.

    ``base`` has the parameter values (SI) of a typical variant; ``times`` (s) are evenly spaced sample times;
    ``channels`` are the indices of the outputs.
    """
    facts, zero = compiled.facts, compiled.facts.linear_without
    if zero is None or facts.constraints or len(times) < 2 or not compiled.identity:
        return None
    if any(np.any(signal.kind == CIRCLE) for signal in signals):
        return None
    step = typical_step(times, np.diff(times))
    if np.max(np.abs(np.diff(times) - step)) > 1e-9 * step:
        return None
    order, count = facts.track_order, len(facts.tracks)
    tracks = flatten(list(signals))
    frequency = lanes.frequencies(tracks)
    if len(frequency) > MOST_WAVES:
        return None
    still = compiled.inputs(
        {
            name: float(s.evaluate(times[:1])[0][0])
            for name, s in zip(facts.tracks, signals, strict=True)
        }
    )
    try:
        rest = find_equilibrium(compiled, base, still)
    except SimulationError:  # variants with an equilibrium run one by one
        return None
    some = (rest.modes, np.ones_like(rest.modes), np.zeros_like(rest.modes))[
        : 3 if len(rest.modes) else 1
    ]
    if not all(
        _outputs_are_linear(compiled, base, rest.x, modes, still, channels) for modes in some
    ):
        return None
    scale = state_scale(rest, *facts.counts, 1.0)
    inputs, each = order * count, signals_of(tracks, order * count)
    address = compiled.native.address
    calls = Calls(
        address["rate"],
        address["switch"],
        address.get("switch_many", 0),
        address["slopes"],
        SLOPE_LANES,
    )
    sizes = (len(facts.states), count, order, each)
    props = propagators(
        calls, sizes, compiled.shapes["slopes"][0], len(facts.switches), frequency, scale
    )
    problem = Problem(
        compiled.engine,
        tracks,
        tracks.first[:-1].copy(),
        compiled.extend(base),
        rest.modes.copy(),
        rest.x.copy(),
        inputs,
    )
    watched = len(facts.switches) > 0
    z = max(rate_bound_of(problem, props), float(frequency[-1])) * step * _SPARE
    parts = parts_for(z, watched)
    if parts * len(times) > _MOST_STEPS:
        return None
    fastest = z / parts
    if fastest > 1.0:
        return None
    band = dead_band(compiled, base, rest, scale, still)
    control = Control(0.0, scale, band, _MOST_STEPS, float(times[-1] - times[0]))
    nothing = Samples(
        np.zeros(0),
        *(np.zeros((rows, 0)) for rows in (len(facts.states), inputs, len(facts.outputs), 0)),
    )
    props = props._replace(step=step / parts)
    run = run_of(problem, control, props, nothing, np.zeros(3, dtype=np.int64))
    jumping, terms = lanes.jumps(tracks, each), terms_of(fastest)
    nodes = times if parts == 1 else (times[:-1, None] + step / parts * np.arange(parts)).ravel()
    nodes = nodes if parts == 1 else np.append(nodes, times[-1])
    course, together = lanes.course(tracks, each, inputs, nodes, jumping, terms, frequency)
    depends = lanes.dependence(compiled.identity, lambda: compiled.functions["output"])
    rows = tuple(depends[channel] for channel in channels)
    lane_sizes = lanes.Sizes(
        len(facts.states),
        count,
        len(course.felt),
        inputs,
        rows,
        len(facts.switches),
        len(jumping),
        together,
        terms,
        parts > 1,
    )
    functions = compiled.functions
    code = lanes.code(
        compiled.identity, lane_sizes, lambda: (functions["switch"], functions["rate"])
    )
    look, glance = code.address[:2]
    work = lanes.Work(
        run,
        lanes.Addresses(
            address["derived"],
            address["output"],
            look,
            glance,
            np.array(code.address[2:], dtype=np.int64),
        ),
        course,
        lanes.room(code.sizes, run, compiled.scalars, len(facts.outputs)),
        np.zeros((0, len(base))),
        np.zeros(2, dtype=np.int64),
        np.array(channels, dtype=np.int64),
        rest.modes.copy(),
        np.array(jumping, dtype=np.int64),
        np.array(code.numbers, dtype=np.int64),
        np.array([step / parts]),
        parts,
        terms,
        fastest,
        1e-12 * max(1.0, abs(float(times[-1]))),
        np.zeros((0, lanes.SUMS * len(channels))),
        np.zeros((0, len(channels))),
        np.zeros(0, dtype=np.int64),
        np.zeros(0, dtype=np.int64),
        np.array([place for row in rows for place in row], dtype=np.int64),
        np.cumsum([0, *map(len, rows)], dtype=np.int64),
    )
    return SharedLayout(work, tuple(facts.parameters.index(name) for name in zero), len(times))


def _spans(count: int, wide: int, workers: int) -> list[tuple[int, int]]:
    """Return spans of whole blocks for distribution; they get smaller so that all workers finish together."""
    spans, first, left = [], 0, -(-count // wide)
    while left:
        blocks = max(left // (_TURNS * workers), 1) if workers > 1 else left
        spans.append((first, min(first + wide * blocks, count)))
        first, left = first + wide * blocks, left - blocks
    return spans


def _with_own_arrays(work: lanes.Work) -> lanes.Work:
    """Return a copy of the work with its own work arrays."""
    run = work.run
    problem = run.problem._replace(piece=run.problem.piece.copy(), m=run.problem.m.copy())
    props = run.props._replace(
        scratch=type(run.props.scratch)(*(array.copy() for array in run.props.scratch))
    )
    own = {
        name: getattr(run, name).copy()
        for name in ("x", "trial", "time", "u", "part", "orders", "counts", "marks")
    }
    room = work.room._replace(**{name: array.copy() for name, array in work.room._asdict().items()})
    room = room._replace(  # arrays that a step reads and writes one vector at a time
        kept=_align(room.kept), next=_align(room.next), variant=_align(room.variant)
    )
    return work._replace(
        run=run._replace(problem=problem, props=props, **own), room=room, span=work.span.copy()
    )


def _align(array: Array) -> Array:
    """Return a copy aligned to a cache line: steps take 1.5 times as long if vectors cross lines."""
    room = np.empty(array.nbytes + _LINE, dtype=np.uint8)
    in_line: Array = np.ndarray(array.shape, array.dtype, room.data, -room.ctypes.data % _LINE)
    in_line[...] = array
    return in_line


def _outputs_are_linear(
    compiled: Compiled, p: Array, x: Array, modes: Array, u: Array, channels: Sequence[int]
) -> bool:
    """Whether outputs are linear in states and inputs (a power is not), tested at three points."""
    chosen = list(channels)
    at = compiled.evaluate("output", x, u, p, modes)[chosen]
    by_x, by_u = (compiled.slopes(by, x, u, p, modes)["output"][chosen] for by in "xu")
    random = np.random.default_rng(0)
    for _ in range(3):
        dx, du = 0.1 * random.standard_normal(len(x)), 0.1 * random.standard_normal(len(u))
        outputs = compiled.evaluate("output", x + dx, u + du, p, modes)[chosen]
        linear = at + by_x @ dx + by_u @ du
        size = np.abs(at) + np.abs(by_x) @ np.abs(dx) + np.abs(by_u) @ np.abs(du)
        if np.any(np.abs(outputs - linear) > 1e-9 * size + 1e-300):
            return False
    return True
