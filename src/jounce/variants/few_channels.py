"""Variants run one by one for only a few channels: code for these channels only, in reused arrays.

A car has sixty channels. Computing all of them for a minute, in newly allocated memory each time, takes longer than the
integration.
"""

from __future__ import annotations

import threading
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from jounce.core.segments import Segments
from jounce.core.turns import once
from jounce.core.types import Array
from jounce.kernel.engine import Samples, Status
from jounce.simulation.compiled import Compiled
from jounce.simulation.prepare import prepare, room
from jounce.simulation.result import angles_of, branch_limits, flipped_at, ran_away_at
from jounce.simulation.settings import RunSettings
from jounce.variants.stepped import code_of_outputs

LEAST = 16  # runs from which compiling code for a few channels pays off
"""Number of runs below which code for only a few channels does not pay off; it takes hundredths of a second."""


def are_worth_it(compiled: Compiled) -> bool:
    """Whether code for some channels pays off; not for mechanisms with loops: cheap channels, seconds to compile."""
    return bool(compiled.identity) and not compiled.facts.projects


@dataclass(frozen=True)
class FewChannels:
    """Runs a model for some channels; a result is valid until the next run of its thread."""

    compiled: Compiled
    wanted: tuple[str, ...]
    _own: threading.local = field(default_factory=threading.local, init=False, compare=False)

    @once
    def names(self) -> tuple[str, ...]:
        """Computed channels: the requested ones, and those that detect an invalid state of the suspension."""
        known = self.compiled.output_names
        return tuple(
            dict.fromkeys(
                [*self.wanted, *(known[row] for row in branch_limits(known)), *angles_of(known)]
            )
        )

    @once
    def _rows(self) -> list[int]:
        return [self.compiled.output_names.index(name) for name in self.names]

    @once
    def _address(self) -> int:
        return code_of_outputs(self.compiled, self._rows).address["output"]

    def run(
        self, p: Array, signals: Sequence[Segments], times: Array, settings: RunSettings
    ) -> tuple[Array, Array] | None:
        """Return samples of the channels (``names``) and their values at rest.

        Return None if the run stops early or reaches an invalid state; a run with all channels gives the reason.
        """
        samples = self._samples(times)
        prepared = prepare(
            self.compiled,
            p,
            signals,
            times,
            tolerance=settings.tolerance,
            method=settings.method,
            out=samples,
        )
        problem, at = prepared.problem, prepared.equilibrium
        assert at is not None
        prepared = replace(
            prepared, problem=problem._replace(engine=problem.engine._replace(output=self._address))
        )
        result = prepared.run()
        lost = (
            result.status is not Status.COMPLETED
            or flipped_at(self.names, result.outputs) is not None
        )
        if lost or ran_away_at(self.names, result.outputs) is not None:
            return None
        return result.outputs, self.compiled.evaluate("output", at.x, prepared.still, p, at.modes)[
            self._rows
        ]

    def _samples(self, times: Array) -> Samples:
        """The arrays of this thread."""
        samples: Samples | None = getattr(self._own, "samples", None)
        if samples is None or len(samples.times) != len(times):
            samples = room(self.compiled, times, len(self.names))
        samples = samples._replace(times=times)
        self._own.samples = samples
        return samples
