"""Check integers from users: counts, and seeds of random numbers."""

from __future__ import annotations

import numpy as np

from jounce.core.errors import DescriptionError, JounceError


def is_whole(number: object) -> bool:
    """Whether a value is an integer of Python or NumPy."""
    return isinstance(number, int | np.integer) and not isinstance(number, bool)


def check_seed(seed: object, error: type[JounceError] = DescriptionError) -> None:
    """Refuse invalid seeds."""
    if not is_whole(seed) or seed < 0:  # type: ignore[operator]
        raise error("invalid seed", where="seed", found=seed, allowed="a whole number, 0 or more")
