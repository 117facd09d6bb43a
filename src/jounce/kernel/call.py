"""Call native code by address from Numba."""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic


@intrinsic  # type: ignore[untyped-decorator]
def call_native(typing_context: Any, address: Any, x: Any, u: Any, p: Any, m: Any, out: Any) -> Any:  # noqa: ANN401, ARG001
    """Call ``void f(double* x, double* u, double* p, double* m, double* out)`` at an address."""
    signature = types.void(types.int64, x, u, p, m, out)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:  # noqa: ANN401
        pointer = ir.DoubleType().as_pointer()
        function = ir.FunctionType(ir.VoidType(), [pointer] * 5).as_pointer()
        arrays = [
            context.make_array(kind)(context, builder, value).data
            for kind, value in zip(signature.args[1:], arguments[1:], strict=True)
        ]
        builder.call(builder.inttoptr(arguments[0], function), arrays)
        return cgutils.get_null_value(ir.IntType(8).as_pointer())

    return signature, generate
