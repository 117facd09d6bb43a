"""Calls of the native loops over rows (``methods.rows``)."""

from __future__ import annotations

from typing import Any

from numba import types
from numba.extending import intrinsic

from jounce.kernel.loops.compiling import array_of, call_address, row_of


@intrinsic  # type: ignore[untyped-decorator]
def add_rows(
    typing_context: Any,
    address: Any,
    to: Any,
    row: Any,
    matrix: Any,
    first: Any,
    weights: Any,
    at: Any,
    count: Any,
    stride: Any,
) -> Any:
    """``to[row] += sum_j weight_j matrix[first + j]``, ``j < count``; weights are ``stride`` apart, from ``at`` on."""
    integer = types.int64
    signature = types.void(
        integer, to, integer, matrix, integer, weights, integer, integer, integer
    )

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        weights = array_of(context, builder, signature, arguments, 5)
        rows = [row_of(context, builder, signature, arguments, i, i + 1) for i in (1, 3)]
        return call_address(
            builder,
            arguments[0],
            [*rows, builder.gep(weights.data, [arguments[6]]), *arguments[7:]],
        )

    return signature, generate


@intrinsic  # type: ignore[untyped-decorator]
def set_rows(
    typing_context: Any, address: Any, to: Any, first: Any, matrix: Any, row: Any, count: Any
) -> Any:
    """Set ``count`` rows to one row of a matrix."""
    integer = types.int64
    signature = types.void(integer, to, integer, matrix, integer, integer)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        rows = [row_of(context, builder, signature, arguments, i, i + 1) for i in (1, 3)]
        return call_address(builder, arguments[0], [*rows, arguments[5]])

    return signature, generate


@intrinsic  # type: ignore[untyped-decorator]
def march(
    typing_context: Any,
    address: Any,
    rows: Any,
    count: Any,
    matrix: Any,
    first: Any,
    forced: Any,
    signals: Any,
    to: Any,
) -> Any:
    """Write the states after each of ``count`` steps from the state in row 0 into the columns of ``to``.

    ``x <- x + E x + rows[k + 1] + sum_j signals[j, k] matrix[first + j]``, ``j < forced``; the images of ``E`` are the
    first rows of ``matrix``. ``signals`` and ``to`` have equally many columns.
    """
    integer = types.int64
    signature = types.void(integer, rows, integer, matrix, integer, integer, signals, to)

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        arrays = {i: array_of(context, builder, signature, arguments, i) for i in (1, 3, 6, 7)}
        forcing = row_of(context, builder, signature, arguments, 3, 4)
        stride = builder.extract_value(arrays[6].shape, 1)
        data = [arrays[1].data, arrays[3].data, forcing, arrays[6].data, arrays[7].data]
        return call_address(builder, arguments[0], [*data, arguments[2], arguments[5], stride])

    return signature, generate
