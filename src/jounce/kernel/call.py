"""Call native code by address from Numba."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic


@intrinsic  # type: ignore[untyped-decorator]
def call_native(
    typing_context: Any, address: Any, x: Any, x_row: Any, u: Any, p: Any, m: Any, out: Any, out_row: Any  # noqa: ANN401, ARG001
) -> Any:  # noqa: ANN401
    """Call ``void f(double* x, double* u, double* p, double* m, double* out)`` at an address.

    ``x`` and ``out`` are C-ordered matrices; the call reads row ``x_row`` of one and writes row ``out_row`` of the other.
    """
    signature = types.void(types.int64, x, types.int64, u, p, m, out, types.int64)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:  # noqa: ANN401
        pointer = ir.DoubleType().as_pointer()
        function = ir.FunctionType(ir.VoidType(), [pointer] * 5).as_pointer()

        def start(i: int, row: int | None = None) -> Any:  # noqa: ANN401
            array = context.make_array(signature.args[i])(context, builder, arguments[i])
            if row is None:
                return array.data
            width = builder.extract_value(array.shape, 1)
            return builder.gep(array.data, [builder.mul(arguments[row], width)])

        inputs = [start(1, 2), start(3), start(4), start(5), start(6, 7)]
        builder.call(builder.inttoptr(arguments[0], function), inputs)
        return cgutils.get_null_value(ir.IntType(8).as_pointer())

    return signature, generate
