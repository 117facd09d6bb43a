"""Two papers reproduced with the public interface only: their rigs, benches and figures, with corrected values."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
Progress: TypeAlias = Callable[[str], None]


class Counted(str):
    """Progress through several items: its text, the completed fraction, and the phase it belongs to."""

    share: float
    phase: str

    def __new__(cls, phase: str, which: int, count: int, name: object) -> Counted:
        """Make the text for item ``which`` of ``count``."""
        progress = super().__new__(cls, f"{phase} {which} of {count}: {name}")
        progress.phase, progress.share = phase, (which - 1) / max(1, count)
        return progress


def no_progress(text: str) -> None:
    """Ignore a progress line."""
