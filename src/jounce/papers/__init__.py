"""The two papers rebuilt with the public interface only: their rigs, benches and figures, with the correct values."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
Progress: TypeAlias = Callable[[str], None]


class Counted(str):
    """Progress of a number of things: its text, the share that is done, and the phase that both belong to."""

    share: float
    phase: str

    def __new__(cls, phase: str, which: int, count: int, name: object) -> Counted:
        """Say which of so many things is worked on."""
        progress = super().__new__(cls, f"{phase} {which} of {count}: {name}")
        progress.phase, progress.share = phase, (which - 1) / max(1, count)
        return progress


def no_progress(text: str) -> None:
    """Ignore a progress line."""
