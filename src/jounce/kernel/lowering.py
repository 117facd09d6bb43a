"""Lower CasADi SX functions to LLVM IR: one native function each, scalar, without branches."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import casadi as ca
from llvmlite import ir

_OPCODES = {getattr(ca, name): name for name in dir(ca) if name.startswith("OP_")}
_FAST = ("contract", "reassoc", "nsz", "arcp")
_DOUBLE, _INDEX = ir.DoubleType(), ir.IntType(64)
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
_COMPARISONS = {"OP_LT": "<", "OP_LE": "<=", "OP_EQ": "==", "OP_NE": "!="}


class Lowering:
    """Builds one module of native functions from CasADi functions with inputs (x, u, p, m) and one output."""

    def __init__(self) -> None:
        self.module = ir.Module(name="jounce")
        self._externals: dict[str, ir.Function] = {}

    def add(self, name: str, function: ca.Function) -> None:
        """Append ``void name(double* x, double* u, double* p, double* m, double* out)``; arrays must not overlap."""
        native = self.declare(name, [_DOUBLE.as_pointer()] * 5)
        builder = ir.IRBuilder(native.append_basic_block())
        self._body(
            builder,
            function,
            load=lambda argument, element: builder.load(builder.gep(native.args[argument], [_INDEX(element)])),
            store=lambda value, element: builder.store(value, builder.gep(native.args[4], [_INDEX(element)])),
        )
        builder.ret_void()

    def add_many(self, name: str, function: ca.Function, *, internal: bool = False) -> None:
        """Append ``void name(x, u, p, m, out, int64 total, int64 first, int64 count)`` for ``count`` samples.

        ``x``, ``u`` and ``out`` hold one row of ``total`` samples for each element, so that LLVM can vectorise the
        loop over the samples; ``p`` and ``m`` are the same for all of them. An internal function is inlined where it
        is called.
        """
        native = self.declare(name, [_DOUBLE.as_pointer()] * 5 + [_INDEX] * 3)
        if internal:
            native.linkage = "internal"
            native.attributes.add("alwaysinline")
        total, first, count = native.args[5:]
        entry, loop, leave = (native.append_basic_block(part) for part in ("entry", "loop", "leave"))
        builder = ir.IRBuilder(entry)
        end = builder.add(first, count)
        builder.cbranch(builder.icmp_signed("<", first, end), loop, leave)
        builder.position_at_end(loop)
        sample = builder.phi(_INDEX)
        sample.add_incoming(first, entry)

        def place(argument: int, element: int) -> ir.Value:
            offset = builder.add(builder.mul(_INDEX(element), total), sample)
            return builder.gep(native.args[argument], [offset if argument in (0, 1, 4) else _INDEX(element)])

        self._body(
            builder,
            function,
            load=lambda argument, element: builder.load(place(argument, element)),
            store=lambda value, element: builder.store(value, place(4, element)),
        )
        following = builder.add(sample, _INDEX(1))
        sample.add_incoming(following, builder.block)
        builder.cbranch(builder.icmp_signed("<", following, end), loop, leave)
        ir.IRBuilder(leave).ret_void()

    def declare(self, name: str, arguments: list[Any]) -> ir.Function:
        """Append an empty function; its pointers must not overlap."""
        native = ir.Function(self.module, ir.FunctionType(ir.VoidType(), arguments), name)
        for argument in native.args[:5]:
            argument.attributes.add("noalias")
        return native

    def _body(
        self,
        builder: ir.IRBuilder,
        function: ca.Function,
        load: Callable[[int, int], ir.Value],
        store: Callable[[ir.Value, int], Any],
    ) -> None:
        work: dict[int, ir.Value] = {}
        for k in range(function.n_instructions()):
            operation = _OPCODES[function.instruction_id(k)]
            inputs, outputs = function.instruction_input(k), function.instruction_output(k)
            if operation == "OP_CONST":
                work[outputs[0]] = ir.Constant(_DOUBLE, function.instruction_constant(k))
            elif operation == "OP_INPUT":
                work[outputs[0]] = load(inputs[0], inputs[1])
            elif operation == "OP_OUTPUT":
                store(work[inputs[0]], outputs[1])
            else:
                work[outputs[0]] = self._operation(builder, operation, [work[i] for i in inputs])

    def _operation(self, b: ir.IRBuilder, operation: str, x: list[ir.Value]) -> ir.Value:
        one = ir.Constant(_DOUBLE, 1.0)
        direct: dict[str, Callable[[], Any]] = {
            "OP_ASSIGN": lambda: x[0],
            "OP_ADD": lambda: b.fadd(*x, flags=_FAST),
            "OP_SUB": lambda: b.fsub(*x, flags=_FAST),
            "OP_MUL": lambda: b.fmul(*x, flags=_FAST),
            "OP_DIV": lambda: b.fdiv(*x, flags=_FAST),
            "OP_SQ": lambda: b.fmul(x[0], x[0], flags=_FAST),
            "OP_TWICE": lambda: b.fadd(x[0], x[0], flags=_FAST),
            "OP_NEG": lambda: b.fneg(x[0]),
            "OP_INV": lambda: b.fdiv(one, x[0], flags=_FAST),
            "OP_SIGN": lambda: self._sign(b, x[0]),
            "OP_NOT": lambda: self._as_double(b, "==", x[0], ir.Constant(_DOUBLE, 0.0)),
            "OP_AND": lambda: b.fmul(*(self._truth(b, value) for value in x)),
            "OP_OR": lambda: self._call(b, "llvm.maxnum.f64", [self._truth(b, value) for value in x]),
            "OP_IF_ELSE_ZERO": lambda: self._if_else_zero(b, *x),
        }
        if operation in direct:
            return direct[operation]()
        if operation in _COMPARISONS:
            return self._as_double(b, _COMPARISONS[operation], *x)
        if operation in _INTRINSICS:
            return self._call(b, f"llvm.{_INTRINSICS[operation]}.f64", x)
        if operation in _LIBRARY:
            return self._call(b, _LIBRARY[operation], x)
        raise NotImplementedError(f"the operation {operation} has no native form")

    def _call(self, b: ir.IRBuilder, name: str, x: list[ir.Value]) -> ir.Value:
        if name not in self._externals:
            self._externals[name] = ir.Function(self.module, ir.FunctionType(_DOUBLE, [_DOUBLE] * len(x)), name)
        return b.call(self._externals[name], x)

    def _sign(self, b: ir.IRBuilder, x: ir.Value) -> ir.Value:
        zero = ir.Constant(_DOUBLE, 0.0)
        sign = b.fsub(self._as_double(b, ">", x, zero), self._as_double(b, "<", x, zero))
        return b.select(b.fcmp_unordered("uno", x, x), x, sign)

    def _truth(self, b: ir.IRBuilder, x: ir.Value) -> ir.Value:
        return self._as_double(b, "!=", x, ir.Constant(_DOUBLE, 0.0))

    @staticmethod
    def _as_double(b: ir.IRBuilder, comparison: str, x: ir.Value, y: ir.Value) -> ir.Value:
        return b.uitofp(b.fcmp_ordered(comparison, x, y), _DOUBLE)

    @staticmethod
    def _if_else_zero(b: ir.IRBuilder, condition: ir.Value, x: ir.Value) -> ir.Value:
        zero = ir.Constant(_DOUBLE, 0.0)
        return b.select(b.fcmp_unordered("!=", condition, zero), x, zero)
