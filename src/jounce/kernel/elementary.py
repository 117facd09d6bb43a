"""Sine, cosine and inverse tangent of vectors by basic operations: library functions take one number per call.

Each result is within two units in the last place of the library's, for angles up to a million radians.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from llvmlite import ir

Call = Callable[[str, Sequence[ir.Value]], ir.Value]
"""Function that calls an LLVM intrinsic on vectors by its short name."""

_FUSED = (
    "contract",
)  # products may be fused into sums, but not reordered: the argument reduction relies on rounding
# A quarter of a turn in parts (fdlibm, e_rem_pio2.c). The first two have 33 bits: their products with counts up to 2^20
# are exact, whether the processor fuses them into the difference or not.
_QUARTER = (1.57079632673412561417e00, 6.07710050630396597660e-11, 2.02226624879595063154e-21)
# Polynomials of the square of an angle up to an eighth of a turn (fdlibm, k_sin.c and k_cos.c), highest power first.
_SINE = (
    1.58969099521155010221e-10,
    -2.50507602534068634195e-08,
    2.75573137070700676789e-06,
    -1.98412698298579493134e-04,
    8.33333333332248946124e-03,
    -1.66666666666666324348e-01,
)
_COSINE = (
    -1.13596475577881948265e-11,
    2.08757232129817482790e-09,
    -2.75573143513906633035e-07,
    2.48015872894767294178e-05,
    -1.38888888888741095749e-03,
    4.16666666666666019037e-02,
)
# Quotient of polynomials of the square of a ratio up to 0.66 (Cephes, atan.c), highest power first.
_ABOVE = (
    -8.750608600031904122785e-1,
    -1.615753718733365076637e1,
    -7.500855792314704667340e1,
    -1.228866684490136173410e2,
    -6.485021904942025371773e1,
)
_BELOW = (
    1.0,
    2.485846490142306297962e1,
    1.650270098316988542046e2,
    4.328810604912902668951e2,
    4.853903996359136964868e2,
    1.945506571482613964425e2,
)
_TURNED = 0.66  # ratio (Cephes, atan.c) above which an angle is computed from its difference to 45 degrees
_HALF, _EIGHTH, _LACKS = math.pi / 2.0, math.pi / 4.0, 3.061616997868383e-17


class _Arithmetic:
    """Operations on vectors of one type; operands may also be numbers."""

    def __init__(self, builder: ir.IRBuilder, kind: ir.VectorType) -> None:
        self._b, self._kind = builder, kind

    def of(self, value: ir.Value | float) -> ir.Value:
        """Broadcast a number to a vector."""
        return (
            ir.Constant(self._kind, [value] * self._kind.count)
            if isinstance(value, float)
            else value
        )

    def add(self, x: ir.Value | float, y: ir.Value | float) -> ir.Value:
        return self._b.fadd(self.of(x), self.of(y), flags=_FUSED)

    def subtract(self, x: ir.Value | float, y: ir.Value | float) -> ir.Value:
        return self._b.fsub(self.of(x), self.of(y), flags=_FUSED)

    def multiply(self, x: ir.Value | float, y: ir.Value | float) -> ir.Value:
        return self._b.fmul(self.of(x), self.of(y), flags=_FUSED)

    def polynomial(self, x: ir.Value, coefficients: Sequence[float]) -> ir.Value:
        """Emit a polynomial by Horner's rule."""
        value: ir.Value | float = coefficients[0]
        for coefficient in coefficients[1:]:
            value = self.add(self.multiply(value, x), coefficient)
        return value


def sine_and_cosine(b: ir.IRBuilder, call: Call, x: ir.Value) -> tuple[ir.Value, ir.Value]:
    """Emit sine and cosine of angles (rad)."""
    of = _Arithmetic(b, x.type)
    quarters = call("rint", [of.multiply(x, 2.0 / math.pi)])
    angle = x
    for part in _QUARTER:
        angle = of.subtract(angle, of.multiply(quarters, part))
    square = of.multiply(angle, angle)
    sine = of.add(angle, of.multiply(of.multiply(angle, square), of.polynomial(square, _SINE)))
    curved = of.multiply(of.multiply(square, square), of.polynomial(square, _COSINE))
    cosine = of.add(of.subtract(1.0, of.multiply(square, 0.5)), curved)
    within = of.subtract(
        quarters, of.multiply(call("floor", [of.multiply(quarters, 0.25)]), 4.0)
    )  # 0, 1, 2, 3
    first, second, third = (b.fcmp_ordered("==", within, of.of(float(k))) for k in (1, 2, 3))
    crossed = b.or_(first, third)
    unsigned = b.select(crossed, cosine, sine), b.select(crossed, sine, cosine)
    negative = b.or_(second, third), b.or_(first, second)
    return tuple(
        b.select(turn, b.fneg(value), value) for turn, value in zip(negative, unsigned, strict=True)
    )


def angle_of(b: ir.IRBuilder, call: Call, y: ir.Value, x: ir.Value) -> ir.Value:
    """Emit the angle (rad) from the x axis to the points (x, y), like ``atan2``."""
    of, zero = _Arithmetic(b, x.type), ir.Constant(x.type, None)
    across, along = call("fabs", [y]), call("fabs", [x])
    steep = b.fcmp_ordered(">", across, along)
    short, long = b.select(steep, along, across), b.select(steep, across, along)
    turned = b.fcmp_ordered(">", short, of.multiply(long, _TURNED))
    above = b.select(turned, of.subtract(short, long), short)
    below = b.select(turned, of.add(short, long), long)
    nowhere = b.fcmp_ordered("==", below, zero)
    ratio = b.fdiv(above, b.select(nowhere, of.of(1.0), below))
    square = of.multiply(ratio, ratio)
    quotient = b.fdiv(of.polynomial(square, _ABOVE), of.polynomial(square, _BELOW))
    angle = of.add(ratio, of.multiply(of.multiply(ratio, square), quotient))
    angle = b.select(turned, of.add(of.add(angle, _LACKS), _EIGHTH), angle)
    angle = b.select(steep, of.add(of.subtract(2.0 * _LACKS, angle), _HALF), angle)
    behind = of.add(of.subtract(4.0 * _LACKS, angle), 2.0 * _HALF)
    sign = call("copysign", [of.of(1.0), x])  # that of a zero too
    angle = b.select(b.fcmp_ordered("<", sign, zero), behind, angle)
    return call("copysign", [angle, y])
