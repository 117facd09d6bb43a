"""Variants of a model without loops side by side in steps of one length: each state is a vector, a lane for each.

The laws of all variants are the same, and so are the edges of their road; how long a step may be hardly differs. A
block of variants therefore runs as one system, whose step is as short as the most demanding of them asks, and which
stops at every event of any of them. Which variants share a block moves a result by less than the tolerance, since steps
fall elsewhere; threads do not. A variant that cannot be followed so is left to run by itself.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from jounce.core.segments import Segments
from jounce.core.types import Array
from jounce.kernel.engine import Control, Engine, Samples, Status
from jounce.kernel.methods import explicit
from jounce.kernel.methods.explicit import shortened
from jounce.kernel.methods.runge_kutta import SHORT_NAMES, STEP_NAMES
from jounce.kernel.native import Native, Source, kept_code
from jounce.simulation.compiled import Compiled
from jounce.simulation.prepare import Prepared, explicit_limit, longest_step
from jounce.simulation.settings import MAX_STEPS

LEAST = 16
"""Variants below which code for blocks is not worth its making, half a second once for each choice of channels."""
WIDTH = 8
"""Variants in a block: two registers of AVX2, one of AVX-512."""
_ITERATIONS = 30
_UNBALANCED = 1e-6  # m/s^2
_SETTLED = 1e-11
_SPARE = 2.0  # by which the motions of a variant may be faster than those of the base

Take = Callable[[int, Array, Array], None]
"""What is made of a block: its number, states and outputs, both (rows, lanes, samples)."""


def in_blocks(compiled: Compiled, parameters: Array, width: int = WIDTH) -> Array:
    """Extended parameters of each row, in blocks of lanes; the first row fills up the last block."""
    short = -len(parameters) % width
    rows = np.array([compiled.extended(row) for row in parameters])
    rows = np.concatenate([rows, np.tile(rows[:1], (short, 1))])
    return np.ascontiguousarray(rows.reshape(-1, width, rows.shape[1]).transpose(0, 2, 1))


@dataclass(frozen=True)
class Rest:
    """Where variants rest: states and modes (blocks, rows, lanes).

    ``lost`` are those that do not rest, ``limit`` is what limits the steps of each (rad/s): (blocks, lanes).
    """

    x: Array
    modes: Array
    lost: NDArray[np.bool_]
    limit: Array


def can_step(compiled: Compiled) -> bool:
    """Tell whether a model is for this: no loops to close, nothing but coordinates and their speeds."""
    facts = compiled.facts
    plain = not facts.internal and len(facts.coordinates) == len(facts.speeds)
    return plain and not facts.projects and bool(compiled.identity)


def code_of(compiled: Compiled, channels: Sequence[int], width: int = WIDTH) -> Native:
    """Native code of a block: rate, switch, steps and some outputs, and ``rest``: accelerations and their slopes."""

    def source() -> Source:
        import casadi as ca

        from jounce.kernel.lowering import Wide
        from jounce.kernel.methods.runge_kutta import Step

        graphs, facts = compiled.functions, compiled.facts
        n, places = len(facts.states), len(facts.coordinates)
        made = {name: graphs[name] for name in ("rate", "switch")}
        arguments = [ca.SX.sym(name, graphs["rate"].size1_in(i)) for i, name in enumerate("xupm")]
        shown = ca.cse(ca.densify(graphs["output"](*arguments)[list(channels)]))
        made["output"] = ca.Function("output", arguments, [shown])
        falling = graphs["rate"](*arguments)[places:]
        slopes = ca.densify(ca.jacobian(falling, arguments[0]))
        found = ca.cse(ca.densify(ca.vertcat(falling, ca.vec(slopes.T))))
        made["rest"] = ca.Function("rest", arguments, [found])
        inputs, switches = len(facts.tracks) * facts.track_order, len(facts.switches)
        step = Step("rate", n * width, n * width, inputs, switches * width)
        return Source({name: Wide(function, width) for name, function in made.items()}, step)

    key = f"{compiled.identity} stepped {width} {[*channels]}"
    if key not in _codes:
        _codes[key] = kept_code(key, source)[0]
    return _codes[key]


_codes: dict[str, Native] = {}


@dataclass(frozen=True)
class Blocks:
    """Variants of a model in blocks of lanes, over one course.

    ``base`` is a run of one variant, laid out, whose method and signals all of them share; ``numbers`` are the extended
    parameters, (blocks, numbers, lanes), ``channels`` those outputs that are wanted.
    """

    compiled: Compiled
    base: Prepared
    numbers: Array
    signals: Sequence[Segments]
    channels: Sequence[int]
    tolerance: float

    @property
    def native(self) -> Native:
        """Code of a block."""
        return code_of(self.compiled, self.channels, self.numbers.shape[2])

    def _evaluate(self, name: str, rows: int, x: Array, modes: Array) -> Array:
        """A function of all blocks: (blocks, rows, lanes)."""
        wide, still, native = self.numbers.shape[2], self.base.still, self.native
        blocks = zip(x, self.numbers, modes, strict=True)
        found = [native.evaluate(name, (rows * wide,), a.ravel(), still, p.ravel(), m.ravel()) for a, p, m in blocks]
        return np.array(found).reshape(len(x), rows, wide)

    def rest(self) -> Rest:
        """Find where all variants rest, beginning with the base: Newton's method, modes following their switches.

        Variants that do not, or move more than twice as fast as the base, are lost: the base stands in for them.
        """
        facts, at = self.compiled.facts, self.base.equilibrium
        assert at is not None
        blocks, _, wide = self.numbers.shape
        places, switches = len(facts.coordinates), len(facts.switches)
        x = np.tile(at.x[None, :, None], (blocks, 1, wide))
        modes = np.tile(at.modes[None, :, None], (blocks, 1, wide))
        falling, slopes = self._falling(x, modes)
        for _ in range(_ITERATIONS):
            step = -np.linalg.solve(slopes[..., :places], falling[..., None])[..., 0].transpose(0, 2, 1)
            x[:, :places] += step
            sides = modes
            if switches:
                sides = (self._evaluate("switch", switches, x, np.ones_like(modes)) > 0.0).astype(float)
            size = 1e-13 + _SETTLED * np.abs(x[:, :places]).max(axis=1)
            settled = (np.abs(step).max(axis=1) <= size) & (sides == modes).all(axis=1)
            modes = sides
            falling, slopes = self._falling(x, modes)
            if settled.all():
                break
        whole = np.zeros((blocks, wide, 2 * places, 2 * places))
        whole[..., range(places), range(places, 2 * places)] = 1.0
        whole[..., places:, :] = slopes
        oscillation = np.sqrt(np.abs(np.linalg.eigvals(slopes[..., :places])).max(axis=2))
        waves = max((signal.fastest_wave for signal in self.signals), default=0.0)
        limit = explicit_limit(oscillation, np.abs(np.linalg.eigvals(whole)).max(axis=2), waves)
        usual = explicit_limit(at.fastest_oscillation, at.fastest_decay, waves)
        lost = ~(settled & (np.abs(falling).max(axis=2) <= _UNBALANCED) & (limit <= _SPARE * usual))
        x[:] = np.where(lost[:, None], at.x[:, None], x)
        modes = np.where(lost[:, None], at.modes[:, None], modes)
        self.numbers[:] = np.where(lost[:, None], self.base.problem.p[:, None], self.numbers)
        return Rest(x, modes, lost, np.where(lost, usual, limit))

    def _falling(self, x: Array, modes: Array) -> tuple[Array, Array]:
        """Accelerations (blocks, lanes, speeds) and their slopes by the states; zero and one where they are no use."""
        places, wide = len(self.compiled.facts.coordinates), self.numbers.shape[2]
        found = self._evaluate("rest", places * (1 + 2 * places), x, modes)
        slopes = found[:, places:].reshape(len(x), places, 2 * places, wide).transpose(0, 3, 1, 2)
        falling = found[:, :places].transpose(0, 2, 1)
        usable = np.asarray(np.isfinite(slopes).all(axis=(2, 3)) & np.isfinite(falling).all(axis=2))
        slopes = np.where(usable[..., None, None], slopes, np.eye(places, 2 * places))
        usable &= np.linalg.det(slopes[..., :places]) != 0.0
        slopes = np.where(usable[..., None, None], slopes, np.eye(places, 2 * places))
        return np.where(usable[..., None], falling, np.inf), slopes

    def outputs_at_rest(self, rest: Rest, block: int) -> Array:
        """The outputs wanted, (rows, lanes)."""
        numbers, compiled, still = self.numbers[block], self.compiled, self.base.still
        x, modes = rest.x[block].T.copy(), rest.modes[block].T.copy()
        found = [
            compiled.evaluate("output", a, still, p, m) for a, p, m in zip(x, numbers.T.copy(), modes, strict=True)
        ]
        return np.array(found)[:, list(self.channels)].T

    def run(self, rest: Rest, take: Take, threads: int | None = None) -> NDArray[np.bool_]:
        """Run all blocks and hand on what each gives; tell which reached their end."""
        ran = np.zeros(len(self.numbers), dtype=bool)
        workers = min(threads or os.cpu_count() or 1, len(ran))

        def share(first: int) -> None:
            out = self._room()
            for block in range(first, len(ran), workers):
                if self._integrate(rest, block, out) is Status.COMPLETED:
                    wide, samples = self.numbers.shape[2], len(out.times)
                    ran[block] = True
                    take(block, *(part.reshape(-1, wide, samples) for part in (out.states, out.outputs)))

        if workers == 1:
            share(0)
        else:
            with ThreadPoolExecutor(workers) as pool:
                list(pool.map(share, range(workers)))
        return ran

    def _integrate(self, rest: Rest, block: int, out: Samples) -> Status:
        base, wide = self.base, self.numbers.shape[2]
        steps = {**dict(zip(STEP_NAMES, STEP_NAMES, strict=True))}
        short = base.problem.engine.first != 1
        if short:
            steps |= SHORT_NAMES
        address = self.native.address
        engine = Engine(address["rate"], address["output"], 0, 0, 0, *(address[steps[name]] for name in STEP_NAMES))
        if short:
            engine = shortened(engine, engine.step, engine.dense, engine.error)
        problem = base.problem._replace(
            engine=engine,
            piece=base.problem.tracks.first[:-1].copy(),
            p=self.numbers[block].flatten(),
            m=rest.modes[block].flatten(),  # changed in place
            x0=rest.x[block].flatten(),
        )
        control = Control(
            base.control.tolerance / math.sqrt(wide),  # an error of one lane alone is a mean of all
            np.repeat(base.control.scale, wide),
            np.repeat(base.control.dead_band, wide),
            MAX_STEPS,
            longest_step(float(rest.limit[block].max()), self.tolerance),
        )
        return Status.of(explicit.integrate(problem, control, out, np.zeros(3, dtype=np.int64)))

    def _room(self) -> Samples:
        wide, one = self.numbers.shape[2], self.base.out
        states, outputs = (np.empty((rows * wide, len(one.times))) for rows in (len(one.states), len(self.channels)))
        return Samples(one.times, states, np.empty_like(one.inputs), outputs, np.empty((0, len(one.times))))
