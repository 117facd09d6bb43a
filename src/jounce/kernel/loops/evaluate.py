"""A single call of a native function with much less overhead than ``ctypes``."""

from __future__ import annotations

from jounce.kernel.arrays import Vector
from jounce.kernel.loops.compiling import call_one, part


@part()
def evaluate(function: int, x: Vector, u: Vector, p: Vector, m: Vector, out: Vector) -> int:
    """Call the function at an address, which fills the column-major matrix ``out``."""
    call_one(function, x, u, p, m, out)
    return 0
