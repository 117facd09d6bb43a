"""A builder of LLVM IR that writes the instructions of long functions as text at once.

A car's functions have thirty thousand instructions. As llvmlite objects, each with a name lookup and a final conversion
to text, they take three times as long.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import count
from typing import Any

from llvmlite import ir

_NUMBERS = count()  # one for all functions: names need only be different


class _Line(ir.Value):  # type: ignore[misc]
    """An instruction as text, with its result if it has one."""

    __slots__ = ("reference", "text", "type")

    def __init__(self, kind: ir.Type, reference: str, text: str) -> None:
        self.type, self.reference, self.text = kind, reference, text

    def get_reference(self) -> str:
        """Return the name of the result for use in other instructions."""
        return self.reference

    def __str__(self) -> str:
        return self.text


class Builder(ir.IRBuilder):  # type: ignore[misc]
    """Emits the most frequent instructions of lowering; llvmlite emits the others."""

    def _write(self, kind: ir.Type, text: str) -> ir.Value:
        reference = f"%v{next(_NUMBERS)}"
        line = _Line(kind, reference, f"{reference} = {text}")
        self._insert(line)
        return line

    def _binary(self, operation: str, x: ir.Value, y: ir.Value, flags: Sequence[str]) -> ir.Value:
        if x.type is not y.type and x.type != y.type:
            raise ValueError(f"operands of {operation} differ: {x.type} and {y.type}")
        words = " ".join((operation, *flags))
        return self._write(x.type, f"{words} {x.type} {x.get_reference()}, {y.get_reference()}")

    def fadd(
        self, lhs: ir.Value, rhs: ir.Value, name: str = "", flags: Sequence[str] = ()
    ) -> ir.Value:
        """Emit a sum."""
        return self._binary("fadd", lhs, rhs, flags)

    def fsub(
        self, lhs: ir.Value, rhs: ir.Value, name: str = "", flags: Sequence[str] = ()
    ) -> ir.Value:
        """Emit a difference."""
        return self._binary("fsub", lhs, rhs, flags)

    def fmul(
        self, lhs: ir.Value, rhs: ir.Value, name: str = "", flags: Sequence[str] = ()
    ) -> ir.Value:
        """Emit a product."""
        return self._binary("fmul", lhs, rhs, flags)

    def fdiv(
        self, lhs: ir.Value, rhs: ir.Value, name: str = "", flags: Sequence[str] = ()
    ) -> ir.Value:
        """Emit a quotient."""
        return self._binary("fdiv", lhs, rhs, flags)

    def fneg(self, arg: ir.Value, name: str = "", flags: Sequence[str] = ()) -> ir.Value:
        """Emit a negation."""
        return self._write(
            arg.type, f"{' '.join(('fneg', *flags))} {arg.type} {arg.get_reference()}"
        )

    def gep(
        self, ptr: ir.Value, indices: Sequence[ir.Value], *more: Any, **options: Any
    ) -> ir.Value:
        """Emit an address offset by a number of elements."""
        if len(indices) != 1 or more or options:
            return super().gep(ptr, indices, *more, **options)
        (index,) = indices
        text = f"{ptr.type} {ptr.get_reference()}, {index.type} {index.get_reference()}"
        return self._write(ptr.type, f"getelementptr {ptr.type.pointee}, {text}")

    def bitcast(self, value: ir.Value, typ: ir.Type, name: str = "") -> ir.Value:
        """Emit a bitcast to another type."""
        if value.type == typ:
            return value
        return self._write(typ, f"bitcast {value.type} {value.get_reference()} to {typ}")

    def load(
        self, ptr: ir.Value, name: str = "", align: int | None = None, typ: ir.Type | None = None
    ) -> ir.Value:
        """Load from an address."""
        kind = ptr.type.pointee if typ is None else typ
        return self._write(
            kind, f"load {kind}, {ptr.type} {ptr.get_reference()}{_alignment(align)}"
        )

    def store(self, value: ir.Value, ptr: ir.Value, align: int | None = None) -> ir.Value:
        """Store to an address."""
        if value.type is not ptr.type.pointee and value.type != ptr.type.pointee:
            raise TypeError(f"cannot store {value.type} at {ptr.type}")
        text = f"store {value.type} {value.get_reference()}, {ptr.type} {ptr.get_reference()}{_alignment(align)}"
        line = _Line(ir.VoidType(), "", text)
        self._insert(line)
        return line

    def extract_element(self, vector: ir.Value, idx: ir.Value, name: str = "") -> ir.Value:
        """Extract a lane."""
        text = f"{vector.type} {vector.get_reference()}, {idx.type} {idx.get_reference()}"
        return self._write(vector.type.element, f"extractelement {text}")

    def insert_element(
        self, vector: ir.Value, value: ir.Value, idx: ir.Value, name: str = ""
    ) -> ir.Value:
        """Replace a lane."""
        parts = ", ".join(f"{part.type} {part.get_reference()}" for part in (vector, value, idx))
        return self._write(vector.type, f"insertelement {parts}")


def _alignment(align: int | None) -> str:
    return "" if align is None else f", align {align}"
