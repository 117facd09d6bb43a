"""Settings of a run: sampling, tolerance, method and limits."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Literal, get_args

import numpy as np

from jounce.core.errors import SimulationError
from jounce.core.phrases import Phrase
from jounce.core.types import Array
from jounce.core.units import as_number

Method = Literal["auto", "explicit", "implicit"]
Start = Literal["rest", "periodic"] | int | str
"""Start of a run on a belt: at rest, periodic, or after a number of loops."""
METHODS: tuple[str, ...] = get_args(Method)
MAX_STEPS = 5_000_000
"""Maximum number of accepted and rejected steps of a run: minutes of computing."""
_MAX_SAMPLES = (
    20_000_000  # a dozen channels with this many samples (2 GB) fill the memory of a small computer
)
_SHARED_SAMPLES = (
    100_000  # maximum size of time arrays shared between runs: 0.8 MB each, at most eight
)
_FINEST, COARSEST = 1e-13, 1e-1
"""Tolerance limits: rounding, and the largest useful one."""


@dataclass(frozen=True)
class RunSettings:
    """Sampling and integration of a run; ``simulate`` and related functions take these as keywords.

    Attributes
    ----------
    output_step : float
        Step of the output samples, s. Samples are interpolated from the solution; a short output step does not improve
        accuracy.
    tolerance : float
        Relative error of the displacements: their largest error over the range they sweep; 1e-13 to 0.1.
    method : {"auto", "explicit", "implicit"}
        Integration method: explicit, with steps as small as the fastest motion requires, or implicit, if that motion
        is stiff and of little interest. ``"auto"`` selects the faster method, propagates models that are linear between
        switches exactly, and reduces corners with travel only, alone or under a car, to one coordinate each
        (``"reduced explicit"``, ``"reduced implicit"``); a named method uses the full mechanism.
        ``attrs["method"]`` of a run is the method used.

    Raises
    ------
    SimulationError
        If a setting is out of range.

    Examples
    --------
    >>> RunSettings(output_step=0.5).times(1.2).tolist()   # s
    [0.0, 0.5, 1.0, 1.2]
    """

    output_step: float = 1e-3
    tolerance: float = 1e-5
    method: Method = "auto"

    def __post_init__(self) -> None:
        for name, si, unit in (("output_step", "s", " in s"), ("tolerance", "1", "")):
            value = getattr(self, name)
            if isinstance(value, str):
                raise SimulationError(
                    "not a number",
                    where=name,
                    found=value,
                    allowed=Phrase("a number{unit}", unit=unit),
                )
            object.__setattr__(self, name, as_number(value, si, where=name))
        if not (np.isfinite(self.output_step) and self.output_step > 0.0):
            raise SimulationError(
                "invalid output step",
                where="output_step",
                found=self.output_step,
                allowed="above 0 s",
            )
        if not _FINEST <= self.tolerance <= COARSEST:
            allowed = Phrase("{finest:g} to {coarsest:g}", finest=_FINEST, coarsest=COARSEST)
            raise SimulationError(
                "invalid tolerance", where="tolerance", found=self.tolerance, allowed=allowed
            )
        if self.method not in METHODS:
            raise SimulationError(
                "unknown integration method",
                where="method",
                found=self.method,
                allowed=", ".join(METHODS),
            )

    def times(self, duration: float) -> Array:
        """Return the output times of a run of ``duration`` (s); refuse more samples than fit into memory."""
        if duration / self.output_step > _MAX_SAMPLES:
            raise SimulationError(
                "too many samples",
                where="duration, output_step",
                found=f"{duration / self.output_step:.3g}",
                allowed=Phrase("at most {max_samples}", max_samples=_MAX_SAMPLES),
                hint="Shorten the run or lengthen the output step.",
            )
        few = duration / self.output_step <= _SHARED_SAMPLES
        return (_shared_times if few else output_times)(float(duration), float(self.output_step))


def output_times(duration: float, output_step: float) -> Array:
    """Return the times from 0 to ``duration`` (s) inclusive; the last step may be shorter."""
    count = int(
        np.floor(duration / output_step + 1e-9)
    )  # 0.3 s in steps of 0.1 s are three steps in spite of rounding
    times = np.arange(count + 1, dtype=np.float64) * np.float64(output_step)
    return times if duration - times[-1] < 1e-9 * duration else np.append(times, duration)


@lru_cache(8)
def _shared_times(duration: float, output_step: float) -> Array:
    """Return the same read-only array for all runs, so that derived results can be shared as well."""
    times = output_times(duration, output_step)
    times.setflags(write=False)
    return times
