"""Numba settings of the loops, calls from loops to native code by address, and sums in arbitrary order."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba import njit, types
from numba.core import cgutils
from numba.extending import intrinsic


def part(**options: Any) -> Callable[[Callable[..., Any]], Any]:
    """Compile a part of the loops without Python and C entries, which take most of the compile time for many arrays."""

    def compile_one(function: Callable[..., Any]) -> Any:
        inner = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}
        # A part inherits what it does not say from the one that calls it first: without a word, all that a part that is
        # to be inlined calls would be inlined, too, and loops compile for twice as long.
        settings = {"forceinline": False, **inner, **options}
        dispatcher = njit(error_model="numpy", _nrt=False, **settings)(function)
        template = dispatcher.get_call_template

        def one_for_all_numbers(arguments: Any, keywords: Any) -> Any:
            # Numba would compile a part once more for every constant that it is called with, which takes a fifth of the
            # time of all and gains nothing: what is worth a constant is inlined by LLVM.
            return template(tuple(types.unliteral(kind) for kind in arguments), keywords)

        dispatcher.get_call_template = one_for_all_numbers
        return dispatcher

    return compile_one


FAST = {"reassoc", "contract", "arcp", "nsz"}
"""What LLVM may do where the order of a sum does not matter; NaN stays NaN."""


@part(fastmath=FAST)
def dot(a, b):  # type: ignore[no-untyped-def] # noqa: ANN001, ANN201
    """Return the sum of products of two arrays of equal length, in arbitrary order."""
    total = 0.0
    for i in range(a.size):
        total += a[i] * b[i]
    return total


def array_of(context: Any, builder: Any, signature: Any, arguments: Any, i: int) -> Any:
    """Return argument ``i`` as an array with its data and shape."""
    return context.make_array(signature.args[i])(context, builder, arguments[i])


def row_of(context: Any, builder: Any, signature: Any, arguments: Any, i: int, row: int) -> Any:
    """Return a pointer to the row of the C-ordered matrix ``i`` that argument ``row`` selects."""
    array = array_of(context, builder, signature, arguments, i)
    return builder.gep(
        array.data, [builder.mul(arguments[row], builder.extract_value(array.shape, 1))]
    )


def call_address(builder: Any, address: Any, arguments: list[Any]) -> Any:
    """Call a function without a result by its address, with arguments of their own types."""
    function = ir.FunctionType(
        ir.VoidType(), [argument.type for argument in arguments]
    ).as_pointer()
    builder.call(builder.inttoptr(address, function), arguments)
    return cgutils.get_null_value(ir.IntType(8).as_pointer())


@intrinsic  # type: ignore[untyped-decorator]
def call_native(
    typing_context: Any,
    address: Any,
    x: Any,
    x_row: Any,
    u: Any,
    p: Any,
    m: Any,
    out: Any,
    out_row: Any,
) -> Any:
    """Call ``void f(double* x, double* u, double* p, double* m, double* out)`` at an address.

    ``x`` and ``out`` are C-ordered matrices; the call reads row ``x_row`` of one, writes row ``out_row`` of the other.
    """
    signature = types.void(types.int64, x, types.int64, u, p, m, out, types.int64)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        at = (context, builder, signature, arguments)
        between = [array_of(*at, i).data for i in (3, 4, 5)]
        return call_address(builder, arguments[0], [row_of(*at, 1, 2), *between, row_of(*at, 6, 7)])

    return signature, generate


@intrinsic  # type: ignore[untyped-decorator]
def call_step(
    typing_context: Any, address: Any, rows: Any, u: Any, p: Any, m: Any, g: Any, h: Any
) -> Any:
    """Call ``void f(double* rows, double* u, double* p, double* m, double* g, double h)`` at an address."""
    signature = types.void(types.int64, rows, u, p, m, g, types.float64)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        at = (context, builder, signature, arguments)
        return call_address(
            builder, arguments[0], [*(array_of(*at, i).data for i in range(1, 6)), arguments[6]]
        )

    return signature, generate


@intrinsic  # type: ignore[untyped-decorator]
def call_many(
    typing_context: Any,
    address: Any,
    x: Any,
    u: Any,
    p: Any,
    m: Any,
    out: Any,
    first: Any,
    count: Any,
) -> Any:
    """Call ``void f(x, u, p, m, out, int64 total, int64 first, int64 count)`` at an address.

    ``x``, ``u`` and ``out`` are C-ordered matrices with one row per element and one column per sample.
    """
    signature = types.void(types.int64, x, u, p, m, out, types.int64, types.int64)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        at = (context, builder, signature, arguments)
        arrays = [array_of(*at, i) for i in range(1, 6)]
        total = builder.extract_value(arrays[0].shape, 1)
        pointers = [array.data for array in arrays]
        return call_address(builder, arguments[0], [*pointers, total, arguments[6], arguments[7]])

    return signature, generate


@intrinsic  # type: ignore[untyped-decorator]
def call_one(typing_context: Any, address: Any, x: Any, u: Any, p: Any, m: Any, out: Any) -> Any:
    """Call a function of one sample, or a function of many samples with one: it ignores the additional arguments."""
    signature = types.void(types.int64, x, u, p, m, out)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        pointers = [array_of(context, builder, signature, arguments, i).data for i in range(1, 6)]
        total, first, count = (ir.IntType(64)(number) for number in (1, 0, 1))
        return call_address(builder, arguments[0], [*pointers, total, first, count])

    return signature, generate


@intrinsic  # type: ignore[untyped-decorator]
def sine_and_cosine(typing_context: Any, angle: Any) -> Any:
    """Return sine and cosine by calls that the optimiser may not move out of their branch, unlike ``math.sin``."""
    signature = types.UniTuple(types.float64, 2)(types.float64)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        kind = ir.FunctionType(ir.DoubleType(), [ir.DoubleType()])
        functions = [
            cgutils.get_or_insert_function(builder.module, kind, name) for name in ("sin", "cos")
        ]
        values = [builder.call(function, arguments) for function in functions]
        return context.make_tuple(builder, signature.return_type, values)

    return signature, generate
