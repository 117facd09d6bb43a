"""One native function called once, with far less around it than ``ctypes`` puts there."""

from __future__ import annotations

from jounce.kernel.arrays import Vector
from jounce.kernel.loops.compiling import call_one, part


@part()
def evaluate(function: int, x: Vector, u: Vector, p: Vector, m: Vector, out: Vector) -> int:
    """Let the function at an address fill ``out``, a matrix column by column."""
    call_one(function, x, u, p, m, out)
    return 0
