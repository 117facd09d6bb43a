"""Lower CasADi SX functions to LLVM IR: one native function each, without branches.

A function may also compute tangents: some of its inputs and outputs are *lanes*, several adjacent numbers that undergo
the same operations. A value that depends on no lane stays a scalar, and is broadcast only where it meets a vector.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeAlias

import casadi as ca
from llvmlite import binding as llvm
from llvmlite import ir

from jounce.kernel.builder import Builder
from jounce.kernel.elementary import angle_of, sine_and_cosine
from jounce.kernel.machine import vector_width
from jounce.kernel.packing import Emission, Packed

_OPCODES = {getattr(ca, name): name for name in dir(ca) if name.startswith("OP_")}
# Sums may be reordered and fused, as in any optimised dot product. NaN and infinity keep their meaning: a run detects
# divergence by them.
_FAST = ("contract", "reassoc", "nsz", "arcp")
_DOUBLE, _INDEX = ir.DoubleType(), ir.IntType(64)
_ZERO, _ONE = ir.Constant(_DOUBLE, 0.0), ir.Constant(_DOUBLE, 1.0)
_INTRINSICS = {
    "OP_SIN": "sin",
    "OP_COS": "cos",
    "OP_SQRT": "sqrt",
    "OP_EXP": "exp",
    "OP_LOG": "log",
    "OP_FABS": "fabs",
    "OP_FLOOR": "floor",
    "OP_CEIL": "ceil",
    "OP_POW": "pow",
    "OP_CONSTPOW": "pow",
    "OP_FMIN": "minnum",
    "OP_FMAX": "maxnum",
    "OP_COPYSIGN": "copysign",
}
_LIBRARY = {
    "OP_TAN": "tan",
    "OP_TANH": "tanh",
    "OP_SINH": "sinh",
    "OP_COSH": "cosh",
    "OP_ASIN": "asin",
    "OP_ACOS": "acos",
    "OP_ATAN": "atan",
    "OP_ATAN2": "atan2",
    "OP_LOG1P": "log1p",
    "OP_EXPM1": "expm1",
    "OP_HYPOT": "hypot",
}
if (
    llvm.llvm_version_info[0] >= 20
):  # loops with intrinsics can be vectorised, those with library calls cannot
    for _name in ("TAN", "TANH", "SINH", "COSH", "ASIN", "ACOS", "ATAN", "ATAN2"):
        _INTRINSICS[f"OP_{_name}"] = _LIBRARY.pop(f"OP_{_name}")
_COMPARISONS = {"OP_LT": "<", "OP_LE": "<=", "OP_EQ": "==", "OP_NE": "!="}
_SIDE_BY_SIDE = {"ASSIGN", "ADD", "SUB", "MUL", "DIV", "SQ", "TWICE", "NEG"}
_WIDE = {"SQRT", "FABS", "FMIN", "FMAX"}
_ANGULAR = {"SIN", "COS", "ASIN", "ACOS", "ATAN", "ATAN2"}
_LINEAR = {
    "OP_ASSIGN",
    "OP_ADD",
    "OP_SUB",
    "OP_MUL",
    "OP_DIV",
    "OP_NEG",
    "OP_TWICE",
    "OP_IF_ELSE_ZERO",
}
_DIRECT: dict[str, Callable[..., ir.Value]] = {
    "OP_ASSIGN": lambda _, x: x,
    "OP_ADD": lambda b, x, y: b.fadd(x, y, flags=_FAST),
    "OP_SUB": lambda b, x, y: b.fsub(x, y, flags=_FAST),
    "OP_MUL": lambda b, x, y: b.fmul(x, y, flags=_FAST),
    "OP_DIV": lambda b, x, y: b.fdiv(x, y, flags=_FAST),
    "OP_SQ": lambda b, x: b.fmul(x, x, flags=_FAST),
    "OP_TWICE": lambda b, x: b.fadd(x, x, flags=_FAST),
    "OP_NEG": lambda b, x: b.fneg(x),
    "OP_INV": lambda b, x: b.fdiv(_ONE, x, flags=_FAST),
    "OP_SIGN": lambda b, x: _sign(b, x),  # noqa: PLW0108 defined below
    "OP_NOT": lambda b, x: _as_double(b, "==", x, _ZERO),
    "OP_AND": lambda b, x, y: b.fmul(_truth(b, x), _truth(b, y)),
    "OP_IF_ELSE_ZERO": lambda b, condition, x: _if_else_zero(b, condition, x),  # noqa: PLW0108
}


@dataclass(frozen=True)
class Lanes:
    """A function of (x, u, p, m), linear in the lanes, which are the last elements of its inputs and output.

    Each lane is ``count`` numbers side by side; ``first`` are the numbers of elements of x, u, p, m and output before
    the first lane.
    """

    function: ca.Function
    count: int
    first: tuple[int, int, int, int, int]

    @property
    def form(self) -> str:
        """All dependencies of the code except the function, for the cache key."""
        return f"{(self.count, self.first)}"

    def place(self, argument: int, element: int) -> tuple[int, bool]:
        """Return the index of an element in its array, and whether it is a lane."""
        first = self.first[argument]
        return (
            (element, False) if element < first else (first + (element - first) * self.count, True)
        )


@dataclass(frozen=True)
class Wide:
    """A function of (x, u, p, m) of ``count`` systems side by side, which share the inputs u.

    An element of x, p, m and of the output is ``count`` numbers, one per system.
    """

    function: ca.Function
    count: int

    @property
    def form(self) -> str:
        """All dependencies of the code except the function, for the cache key."""
        return f"wide {self.count}"


AnyFunction: TypeAlias = ca.Function | Lanes | Packed | Wide


class Lowering:
    """Builds one module of native functions from CasADi functions with inputs (x, u, p, m) and one output."""

    def __init__(self) -> None:
        self.module = ir.Module(name="jounce")
        self._externals: dict[str, ir.Function] = {}
        self._cache: dict[tuple[int, str], tuple[ir.Value, Any]] = {}

    def add(self, name: str, function: AnyFunction, *, seldom: bool = False) -> None:
        """Append ``void name(double* x, double* u, double* p, double* m, double* out)``; arrays must not overlap.

        A function called ``seldom`` is cut into blocks: compile time grows faster than linearly with block length.
        """
        native = self.declare(name, [_DOUBLE.as_pointer()] * 5)
        builder = (
            _Blocks(native.append_basic_block()) if seldom else Builder(native.append_basic_block())
        )
        if isinstance(function, Packed):

            def point(argument: int, element: int) -> ir.Value:
                return builder.gep(native.args[argument], [_INDEX(element)])

            self._side_by_side(builder, function, native.args[2], point)
            builder.ret_void()
            return
        wide_in = (0, 0, 0, 0, 0) if isinstance(function, Wide) else (1 << 62,) * 5
        lanes = (
            function
            if isinstance(function, Lanes)
            else Lanes(_graph_of(function), _count_of(function), wide_in)
        )
        vector = ir.VectorType(_DOUBLE, lanes.count).as_pointer()

        def at(argument: int, element: int) -> ir.Value:
            shared = argument == 1 and isinstance(function, Wide)
            place, wide = (element, False) if shared else lanes.place(argument, element)
            pointer = builder.gep(native.args[argument], [_INDEX(place)])
            return builder.bitcast(pointer, vector) if wide else pointer

        self._body(
            builder,
            lanes.function,
            load=lambda argument, element: builder.load(at(argument, element), align=8),
            store=lambda value, element: self._store(builder, value, at(4, element)),
            operation=self._each if isinstance(function, Wide) else None,
        )
        builder.ret_void()

    def add_many(self, name: str, function: AnyFunction) -> None:
        """Append ``void name(x, u, p, m, out, int64 total, int64 first, int64 count)`` for ``count`` samples.

        ``x``, ``u`` and ``out`` hold one row of ``total`` samples for each element; ``p`` and ``m`` are the same for
        all of them. A wide function is computed system by system. LLVM vectorises over the samples of
        small functions by itself; for large ones the vectors are emitted here, in half of LLVM's time.

        Raises
        ------
        NotImplementedError
            For a function with lanes.
        """
        if isinstance(function, Lanes):
            raise NotImplementedError("lanes of many samples")
        native = self.declare(name, [_DOUBLE.as_pointer()] * 5 + [_INDEX] * 3)
        builder = Builder(native.append_basic_block("entry"))
        with builder.if_then(builder.icmp_signed("<", _INDEX(0), native.args[7])):
            if isinstance(function, Wide) or (
                isinstance(function, ca.Function) and function.n_instructions() > _SMALL
            ):
                self._in_vectors(builder, native, function)
            else:
                self._one_by_one(builder, native, function)
        builder.ret_void()

    def _one_by_one(
        self, builder: ir.IRBuilder, native: ir.Function, function: ca.Function | Packed
    ) -> None:
        first, count = native.args[6:]
        with _loop(builder, first, builder.add(first, count)) as sample:

            def place(argument: int, element: int) -> ir.Value:
                return self._sample(builder, native, (argument, element), 1, _INDEX(0), sample)

            if isinstance(function, Packed):
                self._side_by_side(builder, function, native.args[2], place)
            else:
                self._body(
                    builder,
                    function,
                    load=lambda argument, element: builder.load(place(argument, element)),
                    store=lambda value, element: builder.store(value, place(4, element)),
                )

    def _in_vectors(
        self, builder: ir.IRBuilder, native: ir.Function, function: ca.Function | Wide
    ) -> None:
        """Emit all samples of each system in vectors, the last of which ends with the last sample.

        Fewer samples than a vector holds are copied to a buffer of one vector, on which the function calls itself.
        """
        graph, wide, (first, count) = _graph_of(function), _count_of(function), native.args[6:]
        width = wide if wide > 1 else vector_width()
        vector, size = ir.VectorType(_DOUBLE, width).as_pointer(), _INDEX(width)
        with builder.if_else(builder.icmp_signed("<", count, size)) as (few, enough):
            with few:
                rows = {
                    0: graph.numel_in(0) * wide,
                    1: graph.numel_in(1),
                    4: graph.numel_out(0) * wide,
                }
                self._padded_call(builder, native, rows, width)
            with enough:
                last = builder.sub(builder.add(first, count), size)
                vectors = builder.udiv(builder.add(count, _INDEX(width - 1)), size)
                with (
                    _loop(builder, _INDEX(0), _INDEX(wide)) as system,
                    _loop(builder, _INDEX(0), vectors) as k,
                ):
                    sample = builder.add(first, builder.mul(k, size))
                    sample = builder.select(builder.icmp_signed("<", sample, last), sample, last)

                    def load(argument: int, element: int) -> ir.Value:
                        place = self._sample(
                            builder, native, (argument, element), wide, system, sample
                        )
                        return builder.load(
                            builder.bitcast(place, vector) if argument < 2 else place, align=8
                        )

                    def store(value: ir.Value, element: int) -> None:
                        place = self._sample(builder, native, (4, element), wide, system, sample)
                        self._store(builder, value, builder.bitcast(place, vector))

                    self._body(builder, graph, load, store, self._each)

    def _padded_call(
        self, builder: ir.IRBuilder, native: ir.Function, rows: dict[int, int], width: int
    ) -> None:
        """Emit a call of a function for one whole vector of samples, filled up with copies of the first sample."""
        x, u, p, m, out, total, first, count = native.args
        size = _INDEX(width)
        with builder.goto_entry_block():  # allocated once, not in a loop
            buffers = {
                i: builder.alloca(_DOUBLE, max(length, 1) * width) for i, length in rows.items()
            }

        def copy(
            argument: int, to: ir.Value, step: ir.Value, of: ir.Value, step_of: ir.Value
        ) -> None:
            builder.call(self._copy, [to, step, of, step_of, _INDEX(rows[argument])])

        with _loop(builder, _INDEX(0), size) as k:
            sample = builder.add(
                first, builder.select(builder.icmp_signed("<", k, count), k, _INDEX(0))
            )
            for i, array in ((0, x), (1, u)):
                copy(i, builder.gep(buffers[i], [k]), size, builder.gep(array, [sample]), total)
        builder.call(native, [buffers[0], buffers[1], p, m, buffers[4], size, _INDEX(0), size])
        with _loop(builder, _INDEX(0), count) as k:
            copy(
                4,
                builder.gep(out, [builder.add(first, k)]),
                total,
                builder.gep(buffers[4], [k]),
                size,
            )

    @cached_property
    def _copy(self) -> ir.Function:
        """``void copy(to, step, of, step_of, count)``: copy numbers with strides."""
        pointer = _DOUBLE.as_pointer()
        kind = ir.FunctionType(ir.VoidType(), [pointer, _INDEX, pointer, _INDEX, _INDEX])
        native = ir.Function(self.module, kind, "copy")
        native.linkage = "internal"
        native.attributes.add("noinline")
        to, step, of, step_of, count = native.args
        builder = Builder(native.append_basic_block())
        with (
            builder.if_then(builder.icmp_signed("<", _INDEX(0), count)),
            _loop(builder, _INDEX(0), count) as k,
        ):
            value = builder.load(builder.gep(of, [builder.mul(k, step_of)]))
            builder.store(value, builder.gep(to, [builder.mul(k, step)]))
        builder.ret_void()
        return native

    def _sample(
        self,
        builder: ir.IRBuilder,
        native: ir.Function,
        leaf: tuple[int, int],
        wide: int,
        system: ir.Value,
        sample: ir.Value,
    ) -> ir.Value:
        """Emit the address of an element of an argument of a function of many samples."""
        argument, element = leaf
        alone = argument == 1 or wide == 1
        own = _INDEX(element) if alone else builder.add(_INDEX(element * wide), system)
        if argument in (0, 1, 4):
            own = builder.add(builder.mul(own, native.args[5]), sample)
        return builder.gep(native.args[argument], [own])

    def add_wide(
        self,
        name: str,
        function: ca.Function,
        count: int,
        total: int | None = None,
        *,
        inlined: bool = False,
    ) -> None:
        """Append ``void name(x, u, p, m, out)`` for the first ``count`` of ``total`` samples (or all), in vectors.

        ``x``, ``u`` and ``out`` hold one row of ``total`` samples for each element; ``p`` and ``m`` are the same for
        all of them. The last vector ends with the last sample. LLVM vectorises the loop of ``add_many`` by itself
        only for small functions, and takes three times as long. An ``inlined`` function is inlined
        where it is called, and computes few samples one by one.
        """
        native = self.declare(name, [_DOUBLE.as_pointer()] * 5, inlined=inlined)
        width, rows = (
            1 if inlined and count <= _FEW else vector_width(),
            count if total is None else total,
        )
        kind = (ir.VectorType(_DOUBLE, width) if width > 1 else _DOUBLE).as_pointer()
        entry, loop, leave = (
            native.append_basic_block(part) for part in ("entry", "loop", "leave")
        )
        Builder(entry).branch(loop)
        builder = Builder(loop)
        first = builder.phi(_INDEX)
        first.add_incoming(_INDEX(0), entry)

        def place(argument: int, element: int) -> ir.Value:
            if argument in (2, 3):
                return builder.gep(native.args[argument], [_INDEX(element)])
            row = builder.gep(native.args[argument], [builder.add(first, _INDEX(element * rows))])
            return builder.bitcast(row, kind)

        self._body(
            builder,
            function,
            load=lambda argument, element: builder.load(place(argument, element), align=8),
            store=lambda value, element: self._store(builder, value, place(4, element)),
            operation=self._each,
        )
        following, last = builder.add(first, _INDEX(width)), _INDEX(count - width)
        if count % width:
            following = builder.select(builder.icmp_signed(">", following, last), last, following)
        first.add_incoming(following, builder.block)
        builder.cbranch(builder.icmp_signed("<", first, last), loop, leave)
        Builder(leave).ret_void()

    def add_sum(self, name: str, function: ca.Function, total: int, count: int) -> None:
        """Append ``void name(x, u, p, m, out)``: the sum of a function over the first ``count`` samples.

        ``x`` holds one row of ``total`` samples for each element, ``m`` one row; ``u`` and ``p`` are the same for all
        samples. Every output is a sum.
        """
        native = self.declare(name, [_DOUBLE.as_pointer()] * 5)
        entry, loop, leave = (
            native.append_basic_block(part) for part in ("entry", "loop", "leave")
        )
        Builder(entry).branch(loop)
        builder = Builder(loop)
        sample = builder.phi(_INDEX)
        sums = [builder.phi(_DOUBLE) for _ in range(function.numel_out(0))]
        places = {0: lambda i: builder.add(_INDEX(i * total), sample), 3: lambda _: sample}
        terms: dict[int, ir.Value] = {}
        self._body(
            builder,
            function,
            load=lambda a, i: builder.load(builder.gep(native.args[a], [places.get(a, _INDEX)(i)])),
            store=lambda value, element: terms.update({element: value}),
        )
        further = [builder.fadd(part, terms[i], flags=_FAST) for i, part in enumerate(sums)]
        following = builder.add(sample, _INDEX(1))
        builder.cbranch(builder.icmp_signed("<", following, _INDEX(count)), loop, leave)
        sample.add_incoming(_INDEX(0), entry)
        sample.add_incoming(following, loop)
        for part, value in zip(sums, further, strict=True):
            part.add_incoming(_ZERO, entry)
            part.add_incoming(value, loop)
        builder = Builder(leave)
        for i, value in enumerate(further):
            builder.store(value, builder.gep(native.args[4], [_INDEX(i)]))
        builder.ret_void()

    def add_single(self, name: str, many: str) -> None:
        """Append ``void name(x, u, p, m, out)``: one sample of a function of many."""
        native = self.declare(name, [_DOUBLE.as_pointer()] * 5)
        builder = Builder(native.append_basic_block())
        builder.call(self.module.globals[many], [*native.args, _INDEX(1), _INDEX(0), _INDEX(1)])
        builder.ret_void()

    def _side_by_side(
        self,
        builder: ir.IRBuilder,
        packed: Packed,
        p: ir.Value,
        place: Callable[[int, int], ir.Value],
    ) -> None:
        """Emit the body of a function with parts side by side; ``place`` gives the address of an element."""
        self._cache = {}
        emission = Emission(packed, _Native(self, builder, p, place))
        for element, node in packed.graph.results.items():
            builder.store(emission.number(node), place(4, element))

    def _wide(self, b: ir.IRBuilder, operation: str, x: list[ir.Value]) -> ir.Value | None:
        """Emit an operation on vectors, lane by lane; return None if it exists for scalars only."""
        name, kind = operation.removeprefix("OP_"), x[0].type
        if name in _SIDE_BY_SIDE:
            return _DIRECT[operation](b, *x)
        if name == "INV":
            return b.fdiv(ir.Constant(kind, [1.0] * kind.count), x[0], flags=_FAST)
        if name == "IF_ELSE_ZERO":
            zero = ir.Constant(kind, None)
            return b.select(b.fcmp_unordered("!=", x[0], zero), x[1], zero)
        if name in _WIDE:
            return self._intrinsic(b, _INTRINSICS[operation], x)
        if name in _ANGULAR:
            return self._angular(b, name, x)
        return None

    def _intrinsic(self, b: ir.IRBuilder, name: str, x: Sequence[ir.Value]) -> ir.Value:
        kind = x[0].type
        full = f"llvm.{name}.v{kind.count}f64"
        if full not in self._externals:
            self._externals[full] = ir.Function(
                self.module, ir.FunctionType(kind, [kind] * len(x)), full
            )
        return b.call(self._externals[full], x)

    def _angular(self, b: ir.IRBuilder, name: str, x: list[ir.Value]) -> ir.Value:
        """Emit sine, cosine and their inverses; LLVM would call a library for each lane."""

        def call(intrinsic: str, values: Sequence[ir.Value]) -> ir.Value:
            return self._intrinsic(b, intrinsic, values)

        if name in ("SIN", "COS"):
            both = self._once("sine and cosine", x[0], lambda: sine_and_cosine(b, call, x[0]))
            return both[0 if name == "SIN" else 1]
        if name == "ATAN2":
            return angle_of(b, call, *x)
        unity = ir.Constant(x[0].type, [1.0] * x[0].type.count)
        if name == "ATAN":
            return angle_of(b, call, x[0], unity)
        other = call("sqrt", [b.fmul(b.fsub(unity, x[0]), b.fadd(unity, x[0]))])
        return angle_of(b, call, *((x[0], other) if name == "ASIN" else (other, x[0])))

    def declare(self, name: str, arguments: list[Any], *, inlined: bool = False) -> ir.Function:
        """Append an empty function; its pointers must not overlap. An ``inlined`` one is internal to the module."""
        native = ir.Function(self.module, ir.FunctionType(ir.VoidType(), arguments), name)
        if inlined:
            native.linkage = "internal"
            native.attributes.add("alwaysinline")
        for argument in native.args[:5]:
            argument.attributes.add("noalias")
        return native

    def _body(
        self,
        builder: ir.IRBuilder,
        function: ca.Function,
        load: Callable[[int, int], ir.Value],
        store: Callable[[ir.Value, int], Any],
        operation: Callable[[ir.IRBuilder, str, list[ir.Value]], ir.Value] | None = None,
    ) -> None:
        operate, work = operation or self._operation, dict[int, ir.Value]()
        self._cache = {}
        for k in range(function.n_instructions()):
            code = _OPCODES[function.instruction_id(k)]
            inputs, outputs = function.instruction_input(k), function.instruction_output(k)
            if code == "OP_CONST":
                work[outputs[0]] = ir.Constant(_DOUBLE, function.instruction_constant(k))
            elif code == "OP_INPUT":
                work[outputs[0]] = load(inputs[0], inputs[1])
            elif code == "OP_OUTPUT":
                store(work[inputs[0]], outputs[1])
            else:
                work[outputs[0]] = operate(builder, code, [work[i] for i in inputs])

    def _each(self, b: ir.IRBuilder, operation: str, x: list[ir.Value]) -> ir.Value:
        """Emit an operation on scalars and vectors of samples, sample by sample if it has no vector form."""
        kinds = [value.type for value in x if isinstance(value.type, ir.VectorType)]
        if not kinds:
            return self._operation(b, operation, x)
        x = [self._spread(b, value, kinds[0]) for value in x]
        wide = self._wide(b, operation, x)
        if wide is not None:
            return wide
        vector = ir.Constant(kinds[0], ir.Undefined)
        for i in range(kinds[0].count):
            place = ir.IntType(32)(i)
            scalar = self._operation(b, operation, [b.extract_element(value, place) for value in x])
            vector = b.insert_element(vector, scalar, place)
        return vector

    def _operation(self, b: ir.IRBuilder, operation: str, x: list[ir.Value]) -> ir.Value:
        wide = [value.type for value in x if isinstance(value.type, ir.VectorType)]
        if wide:
            if operation not in _LINEAR or (operation == "OP_DIV" and x[1].type == wide[-1]):
                raise NotImplementedError(f"the operation {operation} has no form for lanes")
            if operation == "OP_DIV":  # one division per divisor instead of one per lane
                operation, x = "OP_MUL", [x[0], self._inverse(b, x[1])]
            if operation != "OP_IF_ELSE_ZERO":
                x = [self._spread(b, value, wide[0]) for value in x]
        if operation in _DIRECT:
            return _DIRECT[operation](b, *x)
        if operation in _COMPARISONS:
            return _as_double(b, _COMPARISONS[operation], *x)
        if operation in _INTRINSICS:
            return self._call(b, f"llvm.{_INTRINSICS[operation]}.f64", x)
        if operation in _LIBRARY:
            return self._call(b, _LIBRARY[operation], x)
        if operation == "OP_OR":
            return self._call(b, "llvm.maxnum.f64", [_truth(b, value) for value in x])
        raise NotImplementedError(f"the operation {operation} has no native form")

    def _call(self, b: ir.IRBuilder, name: str, x: list[ir.Value]) -> ir.Value:
        if name not in self._externals:
            self._externals[name] = ir.Function(
                self.module, ir.FunctionType(_DOUBLE, [_DOUBLE] * len(x)), name
            )
        return b.call(self._externals[name], x)

    def _store(self, b: ir.IRBuilder, value: ir.Value, pointer: ir.Value) -> None:
        b.store(self._spread(b, value, pointer.type.pointee), pointer, align=8)

    def _inverse(self, b: ir.IRBuilder, x: ir.Value) -> ir.Value:
        return self._once("inverse", x, lambda: _DIRECT["OP_INV"](b, x))

    def _spread(self, b: ir.IRBuilder, x: ir.Value, kind: ir.Type) -> ir.Value:
        """Broadcast a scalar if ``kind`` is a vector."""
        return x if x.type == kind else self._once("spread", x, lambda: _spread(b, x, kind))

    def _once(self, what: str, x: ir.Value, make: Callable[[], Any]) -> Any:
        """Return the cached result of ``make`` for a value in this function; storing the value keeps its id unique."""
        key = (id(x), what)
        if key not in self._cache:
            self._cache[key] = x, make()
        return self._cache[key][1]


def _graph_of(function: ca.Function | Wide) -> ca.Function:
    return function.function if isinstance(function, Wide) else function


def _count_of(function: object) -> int:
    """Return the number of systems of a function."""
    return function.count if isinstance(function, Wide) else 1


_SMALL = 300  # instructions; chosen with the double wishbone (0.79 s to compile instead of 0.93 s), limit not scanned
"""Largest function whose loop over samples LLVM vectorises; for larger ones the vectors are emitted here."""
_FEW = 8
"""Inlined functions of at most this many samples stay scalar: vector loads right after scalar stores stall."""


@contextmanager
def _loop(builder: ir.IRBuilder, first: ir.Value, end: ir.Value) -> Iterator[ir.Value]:
    """Emit a loop over the integers ``first <= number < end``; it runs at least once."""
    before, loop = builder.block, builder.append_basic_block("loop")
    builder.branch(loop)
    builder.position_at_end(loop)
    number = builder.phi(_INDEX)
    number.add_incoming(first, before)
    yield number
    following, after = builder.add(number, _INDEX(1)), builder.append_basic_block("after")
    number.add_incoming(following, builder.block)
    builder.cbranch(builder.icmp_signed("<", following, end), loop, after)
    builder.position_at_end(after)


_LONGEST = 250  # instructions; from about there the compiler's time for a block grows faster than its length


class _Blocks(Builder):
    """Builder that starts a new block after ``_LONGEST`` instructions."""

    def _insert(self, instruction: Any) -> None:
        super()._insert(instruction)
        if len(self.block.instructions) >= _LONGEST and not isinstance(instruction, ir.Terminator):
            following = self.append_basic_block()
            self.branch(following)
            self.position_at_end(following)


def _spread(b: ir.IRBuilder, x: ir.Value, kind: ir.VectorType) -> ir.Value:
    if isinstance(x, ir.Constant):
        return ir.Constant(kind, [x.constant] * kind.count)
    undefined, first = ir.Constant(kind, ir.Undefined), ir.IntType(32)(0)
    mask = ir.Constant(ir.VectorType(ir.IntType(32), kind.count), None)
    return b.shuffle_vector(b.insert_element(undefined, x, first), undefined, mask)


@dataclass(frozen=True)
class _Native:
    """Emits parts side by side as native code; ``place`` gives the address of an element, ``p`` the parameters."""

    lowering: Lowering
    builder: ir.IRBuilder
    p: ir.Value
    place: Callable[[int, int], ir.Value]

    def constant(self, value: float) -> ir.Value:
        return ir.Constant(_DOUBLE, value)

    def load(self, argument: int, element: int) -> ir.Value:
        return self.builder.load(self.place(argument, element))

    def load_wide(self, offset: int, count: int) -> ir.Value:
        pointer = self.builder.gep(self.p, [_INDEX(offset)])
        return self.builder.load(
            self.builder.bitcast(pointer, ir.VectorType(_DOUBLE, count).as_pointer()), align=8
        )

    def scalar(self, operation: str, values: list[ir.Value]) -> ir.Value:
        return self.lowering._operation(self.builder, operation, values)

    def wide(self, operation: str, values: list[ir.Value]) -> ir.Value | None:
        return self.lowering._wide(self.builder, operation, values)

    def lane(self, vector: ir.Value, lane: int) -> ir.Value:
        return self.builder.extract_element(vector, ir.IntType(32)(lane))

    def gather(self, values: list[ir.Value]) -> ir.Value:
        kind = ir.VectorType(_DOUBLE, len(values))
        if all(value is values[0] for value in values):
            return _spread(self.builder, values[0], kind)
        if all(isinstance(value, ir.Constant) for value in values):
            return ir.Constant(kind, [value.constant for value in values])
        vector = ir.Constant(kind, ir.Undefined)
        for k, value in enumerate(values):
            vector = self.builder.insert_element(vector, value, ir.IntType(32)(k))
        return vector


def _sign(b: ir.IRBuilder, x: ir.Value) -> ir.Value:
    sign = b.fsub(_as_double(b, ">", x, _ZERO), _as_double(b, "<", x, _ZERO))
    return b.select(b.fcmp_unordered("uno", x, x), x, sign)


def _truth(b: ir.IRBuilder, x: ir.Value) -> ir.Value:
    return _as_double(b, "!=", x, _ZERO)


def _as_double(b: ir.IRBuilder, comparison: str, x: ir.Value, y: ir.Value) -> ir.Value:
    return b.uitofp(b.fcmp_ordered(comparison, x, y), _DOUBLE)


def _if_else_zero(b: ir.IRBuilder, condition: ir.Value, x: ir.Value) -> ir.Value:
    zero = ir.Constant(x.type, None)  # of a vector, all zeros
    return b.select(b.fcmp_unordered("!=", condition, _ZERO), x, zero)
