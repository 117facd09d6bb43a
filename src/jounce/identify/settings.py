"""Settings of an update: compared channels, search options, and uncertain inputs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from jounce.core.errors import FitError
from jounce.identify.doubt import Doubt, doubts_of
from jounce.identify.estimate import Estimate
from jounce.simulation.settings import RunSettings

METHODS = ("bfgs", "least-squares")


@dataclass(frozen=True)
class UpdateSettings:
    """Settings of an update; ``update_model``, ``posterior`` and related functions take these as keywords.

    Attributes
    ----------
    name, method, weights, channels, align, lag_bound, starts, seed, tolerance, doubt, nuisances, bench
        As for :func:`jounce.update_model`.
    doubts : Doubt or None
        ``doubt``, converted if it was given as a table.

    Raises
    ------
    FitError
        For an invalid method, alignment, number of starts or largest lag.
    DescriptionError
        For invalid doubts.
    SimulationError
        For a tolerance out of range.
    """

    name: str = "update"
    method: str = "least-squares"
    weights: str | Mapping[str, float] = "printed"
    channels: Sequence[str] | None = None
    align: str | None = None
    lag_bound: float = 0.02
    starts: int | None = None
    seed: int = 1
    tolerance: float = 1e-8
    doubt: Doubt | Mapping[str, Any] | None = None
    nuisances: Mapping[str, Any] | None = None
    bench: Mapping[str, Estimate] | None = None
    doubts: Doubt | None = field(init=False, default=None)

    def __post_init__(self) -> None:
        if self.method not in METHODS:
            raise FitError("unknown method", found=self.method, allowed=", ".join(METHODS))
        if self.align not in (None, "lag"):
            raise FitError(
                "unknown alignment", where=self.name, found=self.align, allowed='none, or "lag"'
            )
        if self.starts is not None and self.starts < 1:
            raise FitError(
                "invalid number of starts", where=self.name, found=self.starts, allowed="1 or more"
            )
        if not (np.isfinite(self.lag_bound) and self.lag_bound > 0.0):
            raise FitError(
                "invalid largest lag",
                where=self.name,
                found=f"{self.lag_bound} s",
                allowed="above 0 s",
            )
        object.__setattr__(self, "tolerance", RunSettings(tolerance=self.tolerance).tolerance)
        object.__setattr__(self, "doubts", None if self.doubt is None else doubts_of(self.doubt))

    @property
    def fits_lags(self) -> bool:
        """Whether the lag of each recording is estimated as well."""
        return self.align == "lag"
