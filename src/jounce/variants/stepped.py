"""Variants of a model in vectors with common steps: each state is a vector with one lane per variant.

All variants have the same laws and road edges, and nearly the same permissible steps. A block of variants therefore
runs as one system: its step is the shortest that any variant requires, and it stops at the events of every variant. The
composition of a block changes the steps and thereby a result by less than the tolerance; the number of threads has no
effect. A variant that cannot be run this way runs individually.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from jounce.core.remembered import Recent
from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.kernel.engine import Control, Engine, Samples, Status
from jounce.kernel.methods import explicit
from jounce.kernel.methods.explicit import shorten
from jounce.kernel.methods.runge_kutta import SHORT_NAMES, STEP_NAMES
from jounce.kernel.native import Native, Source, code_from_cache
from jounce.simulation.compiled import Compiled
from jounce.simulation.prepare import PreparedRun, explicit_limit, longest_step
from jounce.simulation.settings import MAX_STEPS
from jounce.variants.threads import processors, share

LEAST, LEAST_WITH_LOOPS = 16, 256
"""Number of variants below which compiling code for blocks (0.5 s; 2 s for mechanisms with loops) does not pay off."""
_MOST_STATES = (
    40  # of a mechanism: cars with four corners already fill the vectors with their corners
)
WIDTH = 8
"""Variants in a block: two registers of AVX2, one of AVX-512."""
_ITERATIONS = 30  # at most; a variant that needs more runs individually
_UNBALANCED = 1e-6  # m/s^2: as in `simulation.statics`
_SETTLED = 1e-11  # relative step: rounding error of the equilibrium
_PROJECTIONS = 3  # Newton steps onto the loops
_KEPT = 5  # iterations with the same Jacobian, which changes little about rest
_MOVE = 1e-6  # m, rad, m/s or rad/s: half step of central differences
_SPARE = 2.0  # largest ratio of a variant's rates to those of the base

Take = Callable[[int, Array, Array], None]
"""Consumer of a block: its number, states and outputs, both (rows, lanes, samples)."""


def in_blocks(compiled: Compiled, parameters: Array, width: int = WIDTH) -> Array:
    """Return the extended parameters of each row in blocks of lanes; the last block is padded with the first row."""
    short = -len(parameters) % width
    rows = np.array([compiled.extend(row) for row in parameters])
    rows = np.concatenate([rows, np.tile(rows[:1], (short, 1))])
    return np.ascontiguousarray(rows.reshape(-1, width, rows.shape[1]).transpose(0, 2, 1))


@dataclass(frozen=True)
class Rest:
    """Equilibria of variants: states and modes (blocks, rows, lanes).

    ``lost`` flags variants without equilibrium; ``limit`` is the rate that limits the step of each (rad/s); both
    (blocks, lanes).
    """

    x: Array
    modes: Array
    lost: NDArray[np.bool_]
    limit: Array


def can_step(compiled: Compiled, count: int) -> bool:
    """Whether ``count`` variants of a model can be stepped; its states must be coordinates and speeds only."""
    facts = compiled.facts
    if facts.projects:
        worth = count >= LEAST_WITH_LOOPS and len(facts.states) <= _MOST_STATES
    else:
        worth = count >= LEAST and len(facts.coordinates) == len(facts.speeds)
    return worth and not facts.internal and bool(compiled.identity)


def code_of(
    compiled: Compiled, channels: Sequence[int], width: int = WIDTH
) -> tuple[Native, Native]:
    """Return native code of a block: rate, switch, projection and steps; and the requested outputs."""

    def steps() -> Source:
        from jounce.kernel.lowering import Wide
        from jounce.kernel.methods.runge_kutta import Step

        graphs, facts = compiled.functions, compiled.facts
        functions = {name: Wide(graphs[name], width) for name in ("rate", "switch")}
        if facts.projects:
            functions |= {
                name: Wide(graphs["project_many"], width) for name in ("project", "project_many")
            }
        inputs, n = len(facts.tracks) * facts.track_order, len(facts.states)
        return Source(
            functions, Step("rate", n * width, n * width, inputs, len(facts.switches) * width)
        )

    return _code(compiled, f"stepped {width}", steps), code_of_outputs(compiled, channels, width)


def code_of_outputs(compiled: Compiled, channels: Sequence[int], width: int = 0) -> Native:
    """Return native code of the requested outputs of a block, or, without ``width``, of one variant."""

    def outputs() -> Source:
        import casadi as ca

        from jounce.kernel.lowering import Wide

        graph = compiled.functions["output"]
        arguments = [ca.SX.sym(name, graph.size1_in(i)) for i, name in enumerate("xupm")]
        shown = ca.Function(
            "output", arguments, [ca.cse(ca.densify(graph(*arguments)[list(channels)]))]
        )
        return Source({"output": Wide(shown, width) if width else shown})

    return _code(compiled, f"outputs {width} {[*channels]}", outputs)


def _code(compiled: Compiled, key: str, source: Callable[[], Source]) -> Native:
    whole = f"{compiled.identity} {key}"
    return _codes.of(whole, lambda: code_from_cache(whole, source)[0])


_codes: Recent[Native] = Recent()


@dataclass(frozen=True)
class LaneBlocks:
    """Variants of a model in blocks of lanes, over one trial.

    ``base`` is the prepared run of one variant, whose method and signals all variants share; ``numbers`` are the
    extended parameters, (blocks, numbers, lanes); ``channels`` are the requested outputs.
    """

    compiled: Compiled
    base: PreparedRun
    numbers: Array
    signals: Sequence[Segments]
    channels: Sequence[int]
    tolerance: float

    @property
    def native(self) -> tuple[Native, Native]:
        """Code of a block (see :func:`code_of`)."""
        return code_of(self.compiled, self.channels, self.numbers.shape[2])

    def _evaluate(self, name: str, rows: int, x: Array, modes: Array) -> Array:
        """Evaluate a native function for all blocks; return (blocks, rows, lanes)."""
        wide, still, native = self.numbers.shape[2], self.base.still, self.native[0]
        blocks = zip(x, self.numbers, modes, strict=True)
        blocks_of_results = [
            native.evaluate(name, (rows * wide,), a.ravel(), still, p.ravel(), m.ravel())
            for a, p, m in blocks
        ]
        return np.array(blocks_of_results).reshape(len(x), rows, wide)

    def rest(self) -> Rest:
        """Find the equilibria of all variants by Newton's method, starting from that of the base.

        Modes follow their switches. Only the free motions of the base are solved for; a mechanism is projected onto its
        loops after each step. Variants without equilibrium, or with motions more than twice as fast as those of the
        base, are marked as lost; the base takes their lanes.
        """
        facts, at = self.compiled.facts, self.base.equilibrium
        assert at is not None
        blocks, _, wide = self.numbers.shape
        free, switches = len(at.free), len(facts.switches)
        rows = len(facts.coordinates) + at.free
        x, modes = (np.tile(part[None, :, None], (blocks, 1, wide)) for part in (at.x, at.modes))
        x, opened = self._close_loops(x, modes)
        slopes = self._slopes(x, modes)
        for turn in range(_ITERATIONS):
            falling = self._evaluate("rate", len(at.x), x, modes)[:, rows].transpose(0, 2, 1)
            step = -np.linalg.solve(
                slopes[..., free:, :free], np.where(np.isfinite(falling), falling, 0.0)[..., None]
            )
            x, opened = self._close_loops(
                x + np.einsum("sf,blf->bsl", at.lift[:, :free], step[..., 0]), modes, 1
            )
            sides = modes
            if switches:
                sides = (self._evaluate("switch", switches, x, np.ones_like(modes)) > 0.0).astype(
                    float
                )
            size = 1e-13 + _SETTLED * np.abs(x[:, : len(facts.coordinates)]).max(axis=1)
            settled = (np.abs(step[..., 0]).max(axis=2) <= size) & (sides == modes).all(axis=1)
            changed, modes = not np.array_equal(sides, modes), sides
            if settled.all():
                break
            if changed or turn % _KEPT == 0:
                slopes = self._slopes(x, modes)
        slopes = self._slopes(x, modes)
        falling = self._evaluate("rate", len(at.x), x, modes)[:, rows]
        oscillation = np.sqrt(np.abs(np.linalg.eigvals(slopes[..., free:, :free])).max(axis=2))
        waves = max((signal.fastest_wave for signal in self.signals), default=0.0)
        limit = explicit_limit(oscillation, np.abs(np.linalg.eigvals(slopes)).max(axis=2), waves)
        usual = explicit_limit(at.fastest_oscillation, at.fastest_decay, waves)
        balanced = (np.abs(falling).max(axis=1) <= _UNBALANCED) & (opened <= _UNBALANCED)
        lost = ~(settled & balanced & (limit <= _SPARE * usual))
        x[:] = np.where(lost[:, None], at.x[:, None], x)
        modes = np.where(lost[:, None], at.modes[:, None], modes)
        self.numbers[:] = np.where(lost[:, None], self.base.problem.p[:, None], self.numbers)
        return Rest(x, modes, lost, np.where(lost, usual, limit))

    def _close_loops(
        self, x: Array, modes: Array, times: int = _PROJECTIONS
    ) -> tuple[Array, Array]:
        """Project states onto the loops ``times`` times; return them and the last loop residuals (blocks, lanes)."""
        residual = np.zeros((len(x), 2, x.shape[2]))
        for _ in range(times if self.compiled.facts.projects else 0):
            projected = self._evaluate("project", 2 + x.shape[1], x, modes)
            residual, x = projected[:, :2], projected[:, 2:]
        return x, residual[:, 0]

    def _slopes(self, x: Array, modes: Array) -> Array:
        """Return the Jacobian of speeds and accelerations of the free motions, (blocks, lanes, rows, columns).

        It is computed by central differences on the loops of each variant. Unusable Jacobians are replaced by the
        identity.
        """
        at = self.base.equilibrium
        assert at is not None
        displacements, rates = [], []
        for motion in at.lift.T:
            there = [
                self._close_loops(x + side * motion[None, :, None], modes, 1)[0]
                for side in (_MOVE, -_MOVE)
            ]
            rate = [self._evaluate("rate", len(at.x), place, modes) for place in there]
            displacements.append(np.einsum("rn,bnl->blr", at.pick, there[0] - there[1]))
            rates.append(np.einsum("rn,bnl->blr", at.pick, rate[0] - rate[1]))
        by, rate_slopes = np.stack(displacements, axis=-1), np.stack(rates, axis=-1)
        identity = np.eye(at.lift.shape[1])
        usable = np.isfinite(by).all(axis=(2, 3)) & np.isfinite(rate_slopes).all(axis=(2, 3))
        by, rate_slopes = (
            np.where(usable[..., None, None], part, identity) for part in (by, rate_slopes)
        )
        usable &= np.linalg.det(by) != 0.0  # no free motion where loops cannot be closed
        by, rate_slopes = (
            np.where(usable[..., None, None], part, identity) for part in (by, rate_slopes)
        )
        slopes = np.linalg.solve(by.swapaxes(2, 3), rate_slopes.swapaxes(2, 3)).swapaxes(2, 3)
        free = len(at.free)
        usable &= np.linalg.det(slopes[..., free:, :free]) != 0.0
        return np.where(usable[..., None, None], slopes, np.roll(identity, free, axis=0))

    def outputs_at_rest(self, rest: Rest, block: int) -> Array:
        """Return the requested outputs at rest, (rows, lanes)."""
        numbers, compiled, still = self.numbers[block], self.compiled, self.base.still
        x, modes = rest.x[block].T.copy(), rest.modes[block].T.copy()
        result = [
            compiled.evaluate("output", a, still, p, m)
            for a, p, m in zip(x, numbers.T.copy(), modes, strict=True)
        ]
        return np.array(result)[:, list(self.channels)].T

    def run(self, rest: Rest, take: Take, threads: int | None = None) -> NDArray[np.bool_]:
        """Run all blocks and pass their results to ``take``; return flags of variants that reached the end."""
        ran = np.zeros(len(self.numbers), dtype=bool)
        workers = min(threads or processors(), len(ran))

        def follow(blocks: Iterator[int]) -> None:
            out = self._room()
            for block in blocks:
                if self._integrate(rest, block, out) is Status.COMPLETED:
                    wide, samples = self.numbers.shape[2], len(out.times)
                    ran[block] = True
                    take(
                        block,
                        *(part.reshape(-1, wide, samples) for part in (out.states, out.outputs)),
                    )

        share(range(len(ran)), follow, workers)
        return ran

    def _integrate(self, rest: Rest, block: int, out: Samples) -> Status:
        base, wide = self.base, self.numbers.shape[2]
        steps = {**dict(zip(STEP_NAMES, STEP_NAMES, strict=True))}
        short = base.problem.engine.first != 1
        if short:
            steps |= SHORT_NAMES
        address, output = self.native[0].address, self.native[1].address["output"]
        loops = (address.get(name, 0) for name in ("project", "project_many"))
        engine = Engine(
            address["rate"], output, 0, *loops, *(address[steps[name]] for name in STEP_NAMES)
        )
        if short:
            engine = shorten(engine, engine.step, engine.dense, engine.error)
        problem = base.problem._replace(
            engine=engine,
            piece=base.problem.tracks.first[:-1].copy(),
            p=self.numbers[block].flatten(),
            m=rest.modes[block].flatten(),  # changed in place
            x0=rest.x[block].flatten(),
        )
        control = Control(
            base.control.tolerance / math.sqrt(wide),  # the error norm is a mean over all lanes
            np.repeat(base.control.scale, wide),
            np.repeat(base.control.dead_band, wide),
            MAX_STEPS,
            longest_step(float(rest.limit[block].max()), self.tolerance),
        )
        return Status.of(
            explicit.integrate(problem, control, out, np.zeros(3, dtype=np.int64), systems=wide)
        )

    def _room(self) -> Samples:
        wide, samples = self.numbers.shape[2], self.base.out
        states, outputs = (
            np.empty((rows * wide, len(samples.times)))
            for rows in (len(samples.states), len(self.channels))
        )
        projected = np.empty((len(samples.projected) * wide, len(samples.times)))
        return Samples(samples.times, states, np.empty_like(samples.inputs), outputs, projected)
