"""The two papers rebuilt with the public interface only: their rigs, benches and figures, with the correct values."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Array: TypeAlias = NDArray[np.float64]
Progress: TypeAlias = Callable[[str], None]


def no_progress(text: str) -> None:
    """Take no notice of a line about the progress of the work."""
