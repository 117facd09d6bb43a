"""Loops over states with vector instructions: states lie side by side in rows, padded to whole vectors.

A matrix is stored by its columns, one per row of the array, so a product is a weighted sum of rows. The
loops are native code for one row length, created by ``row_loops`` and called by address.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

from llvmlite import ir

from jounce.core.remembered import Recent
from jounce.kernel.native import Native, Source, code_from_cache

if TYPE_CHECKING:
    from jounce.kernel.lowering import Lowering

_DOUBLE, _INDEX, _LANE = ir.DoubleType(), ir.IntType(64), ir.IntType(32)
_POINTER, _WIDEST = _DOUBLE.as_pointer(), 8
_NAMES = ("add_rows", "set_rows", "march")


class RowLoops(NamedTuple):
    """Addresses of the loops."""

    add: int
    set: int
    march: int


def padded_length(count: int) -> int:
    """Return the row length for a number of states."""
    return 4 if count <= 4 else -(-count // _WIDEST) * _WIDEST


def row_loops(width: int, count: int) -> RowLoops:
    """Return the native loops for rows of ``width`` numbers, of which ``count`` are states."""

    def make() -> Native:
        return code_from_cache(f"rows {width} {count}", lambda: Source({}, _Loops(width, count)))[0]

    native = _loops.of((width, count), make)
    return RowLoops(*(native.address[name] for name in _NAMES))


_loops: Recent[Native] = Recent()


@dataclass(frozen=True)
class _Loops:
    """Functions of the native module."""

    width: int
    count: int

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the functions."""
        return _NAMES

    def add(self, lowering: Lowering) -> None:
        """Append the functions."""
        _add_rows(lowering.module, self.width)
        _set_rows(lowering.module, self.width)
        _march(lowering.module, self.width, self.count)


class _Rows:
    """Matrix in a loop under construction, read and written as vectors."""

    def __init__(self, builder: Any, data: Any, width: int) -> None:
        self._builder, self._data, self._width = builder, data, width
        self.vector = ir.VectorType(_DOUBLE, min(width, _WIDEST))
        self.places = range(0, width, self.vector.count)

    def _at(self, row: Any, place: int) -> Any:
        b = self._builder
        start = b.add(b.mul(row, _INDEX(self._width)), _INDEX(place))
        return b.bitcast(b.gep(self._data, [start]), self.vector.as_pointer())

    def load(self, row: Any) -> list[Any]:
        """Load the vectors of a row."""
        return [self._builder.load(self._at(row, place), align=8) for place in self.places]

    def store(self, values: list[Any], row: Any) -> None:
        """Store the vectors of a row."""
        for value, place in zip(values, self.places, strict=True):
            self._builder.store(value, self._at(row, place), align=8)


def _variable(builder: Any, value: Any) -> Any:
    """Allocate a variable on the stack of the function."""
    with builder.goto_entry_block():
        place = builder.alloca(value.type)
    builder.store(value, place)
    return place


@contextmanager
def _counting(builder: Any, start: Any, stop: Any, step: Any) -> Iterator[Any]:
    """Emit a loop over ``range(start, stop, step)``."""
    before = builder.block
    head, body, leave = (builder.append_basic_block(name) for name in ("head", "body", "leave"))
    builder.branch(head)
    builder.position_at_end(head)
    index = builder.phi(_INDEX)
    index.add_incoming(start, before)
    builder.cbranch(builder.icmp_signed("<", index, stop), body, leave)
    builder.position_at_end(body)
    yield index
    index.add_incoming(builder.add(index, step), builder.block)
    builder.branch(head)
    builder.position_at_end(leave)


def _lane(builder: Any, value: Any, lane: int) -> Any:
    """Broadcast one element of ``value`` to a vector."""
    mask = ir.Constant(ir.VectorType(_LANE, value.type.count), [lane] * value.type.count)
    return builder.shuffle_vector(value, ir.Constant(value.type, ir.Undefined), mask)


def _spread(builder: Any, value: Any, vector: ir.VectorType) -> Any:
    """Broadcast a number to a vector."""
    return _lane(
        builder, builder.insert_element(ir.Constant(vector, ir.Undefined), value, _LANE(0)), 0
    )


def _add_product(builder: Any, x: Any, y: Any, total: Any) -> Any:
    return builder.fadd(builder.fmul(x, y, flags=("contract",)), total, flags=("contract",))


def _function(
    module: ir.Module, name: str, pointers: int, integers: int
) -> tuple[ir.Function, ir.IRBuilder]:
    kinds = [_POINTER] * pointers + [_INDEX] * integers
    function = ir.Function(module, ir.FunctionType(ir.VoidType(), kinds), name)
    return function, ir.IRBuilder(function.append_basic_block())


def _sum_of_rows(
    builder: Any, start: list[Any], matrix: _Rows, count: Any, weights: Any, stride: Any
) -> list[Any]:
    """Add the weighted first ``count`` rows to a row, in two sums to shorten the dependency chain."""
    zero = ir.Constant(matrix.vector, [0.0] * matrix.vector.count)
    totals = [_variable(builder, value) for value in start]
    others = [_variable(builder, zero) for _ in start]

    def add(row: Any, sums: list[Any]) -> None:
        weight = builder.load(builder.gep(weights, [builder.mul(row, stride)]))
        spread = _spread(builder, weight, matrix.vector)
        for value, total in zip(matrix.load(row), sums, strict=True):
            builder.store(_add_product(builder, spread, value, builder.load(total)), total)

    whole = builder.and_(count, _INDEX(-2))
    with _counting(builder, _INDEX(0), whole, _INDEX(2)) as row:
        add(row, totals)
        add(builder.add(row, _INDEX(1)), others)
    with builder.if_then(builder.icmp_signed("<", whole, count)):
        add(whole, others)
    return [
        builder.fadd(*(builder.load(part) for part in pair))
        for pair in zip(totals, others, strict=True)
    ]


def _add_rows(module: ir.Module, width: int) -> None:
    """``void(to, matrix, weights, count, stride)``."""
    function, builder = _function(module, "add_rows", 3, 2)
    to, matrix, weights, count, stride = function.args
    target = _Rows(builder, to, width)
    value = _sum_of_rows(
        builder, target.load(_INDEX(0)), _Rows(builder, matrix, width), count, weights, stride
    )
    target.store(value, _INDEX(0))
    builder.ret_void()


def _set_rows(module: ir.Module, width: int) -> None:
    """``void(to, row, count)``."""
    function, builder = _function(module, "set_rows", 2, 1)
    to, row, count = function.args
    target, values = _Rows(builder, to, width), _Rows(builder, row, width).load(_INDEX(0))
    with _counting(builder, _INDEX(0), count, _INDEX(1)) as k:
        target.store(values, k)
    builder.ret_void()


def _march(module: ir.Module, width: int, states: int) -> None:
    """``void(rows, matrix, forcing, signals, to, count, forced, stride)``."""
    function, builder = _function(module, "march", 5, 3)
    for pointer in function.args[:5]:
        pointer.attributes.add("noalias")
    rows, matrix, forcing, signals, to, count, forced, stride = function.args
    given, acting = _Rows(builder, rows, width), _Rows(builder, forcing, width)
    images = [_Rows(builder, matrix, width).load(_INDEX(j)) for j in range(states)]
    variables = [_variable(builder, value) for value in given.load(_INDEX(0))]

    def act(k: Any) -> list[Any]:
        start = given.load(builder.add(k, _INDEX(1)))
        return _sum_of_rows(builder, start, acting, forced, builder.gep(signals, [k]), stride)

    def move(over: list[list[Any]], change: list[Any]) -> list[Any]:
        x = [builder.load(value) for value in variables]
        return _sum(builder, x, _apply(builder, x, over, change))

    def write(x: list[Any], k: Any) -> None:
        for j in range(states):
            place = builder.gep(
                to, [builder.add(builder.mul(_INDEX(j), stride), builder.add(k, _INDEX(1)))]
            )
            builder.store(
                builder.extract_element(x[j // given.vector.count], _LANE(j % given.vector.count)),
                place,
            )

    def advance(x: list[Any], k: Any) -> None:
        write(x, k)
        for value, place in zip(x, variables, strict=True):
            builder.store(value, place)

    # The next state waits for this one through a whole product. With the images of two steps known (e^2a - 1 once
    # more), every second state is made from the one two steps before, and the chain is half as long. Wide rows have no
    # registers left.
    paired = builder.and_(count, _INDEX(-2)) if width <= given.vector.count else _INDEX(0)
    if width <= given.vector.count:
        twice = [_apply(builder, image, images, _sum(builder, image, image)) for image in images]
        with _counting(builder, _INDEX(0), paired, _INDEX(2)) as k:
            following = builder.add(k, _INDEX(1))
            first, second = act(k), act(following)
            write(move(images, first), k)
            advance(
                move(twice, _apply(builder, first, images, _sum(builder, first, second))), following
            )
    with _counting(builder, paired, count, _INDEX(1)) as k:
        advance(move(images, act(k)), k)
    builder.ret_void()


def _apply(builder: Any, x: list[Any], images: list[list[Any]], start: list[Any]) -> list[Any]:
    """``start + E x``; summed in four parts to shorten the dependency chain."""
    vector = x[0].type
    spread = [_lane(builder, x[j // vector.count], j % vector.count) for j in range(len(images))]
    sums = []
    for b, first in enumerate(start):
        parts = [first, *[ir.Constant(vector, [0.0] * vector.count)] * 3]
        for j, weight in enumerate(spread):
            parts[j % 4] = _add_product(builder, weight, images[j][b], parts[j % 4])
        sums.append(
            builder.fadd(builder.fadd(parts[0], parts[1]), builder.fadd(parts[2], parts[3]))
        )
    return sums


def _sum(builder: Any, x: list[Any], y: list[Any]) -> list[Any]:
    return [builder.fadd(*pair) for pair in zip(x, y, strict=True)]
