"""Machine-independent code (LLVM bitcode) of a loop, with an entry that takes Python objects without conversion.

A loop is compiled for the one signature given by its annotations. Numba would also optimise and generate code for each
part separately, although only the entry is called. Here the parts are only linked, and because only the entry is
visible, LLVM inlines better.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from typing import Annotated, Any, get_args, get_origin, get_type_hints

from llvmlite import binding as llvm
from llvmlite import ir
from numba import njit, types
from numba.core import cgutils, codegen
from numba.core.registry import cpu_target

from jounce.kernel.arrays import Layout
from jounce.kernel.cache import join
from jounce.kernel.loops import ENTRY, FAILED, LOOPS, UNLOCKED
from jounce.kernel.machine import optimise, this_machine

_BYTE, _SHORT, _INDEX = ir.IntType(8), ir.IntType(32), ir.IntType(64)
_POINTER, _DOUBLE = _BYTE.as_pointer(), ir.DoubleType()
_KINDS = (types.float64, types.int64, types.complex128)  # in the order of ``call._facts``
_NUMBERS = {int: types.int64, float: types.float64, bool: types.boolean}
_ALIGNED, _ORDERS = 0x100, {"C": 0x1, "F": 0x2}  # flags of NumPy's arrays

Leaf = tuple[tuple[tuple[int, str], ...], str]
"""Where a thing lies in the arguments (place and name, level by level), and what it has to be."""


def function_of(name: str) -> Any:
    """Return a loop compiled with Numba's own entry."""
    return njit(error_model="numpy", _nrt=False)(_part(name).py_func)


def bitcode_of(name: str) -> bytes:
    """Compile a loop to bitcode that includes the checks of its arguments."""
    loop = _part(name)
    hints = get_type_hints(loop.py_func, include_extras=True)
    hints.pop("return")
    arguments = tuple(_type_of(hint) for hint in hints.values())
    cpu_target.target_context.refresh()
    with _parts_as_they_are():
        loop.compile(arguments)
        compiled = loop.overloads[arguments]
        module = _linked(compiled.library)
    entry = _Entry(compiled.fndesc, list(hints), unlocked=name in UNLOCKED)
    module.link_in(llvm.parse_assembly(str(entry.module)))
    for number, thing in enumerate([*module.functions, *module.global_variables]):
        if not thing.is_declaration and thing.name != ENTRY:
            thing.linkage = "internal"
            thing.name = f"part_{number}"  # Numba's names hold whole signatures, and addresses of this process
    # What holds on every machine is done here: it shrinks the code to a quarter.
    optimise(module, this_machine(), 1)
    module.name = name
    module.verify()
    return join({"leaves": entry.leaves}, module.as_bitcode())


def _part(name: str) -> Any:
    module, function = LOOPS[name]
    return getattr(import_module(f"jounce.kernel.loops.{module}"), function)


def _type_of(hint: Any) -> Any:
    """Return the Numba type of an annotation."""
    if hint in _NUMBERS:
        return _NUMBERS[hint]
    if get_origin(hint) is Annotated:
        _, layout = get_args(hint)
        assert isinstance(layout, Layout)
        return types.Array(getattr(types, layout.dtype), layout.dimensions, layout.order)
    fields = get_type_hints(hint, include_extras=True)
    return types.BaseTuple.from_types(tuple(_type_of(fields[name]) for name in hint._fields), hint)


@contextmanager
def _parts_as_they_are() -> Iterator[None]:
    """Prevent Numba from optimising the parts and from generating machine code for them."""
    library, code = codegen.CPUCodeLibrary, codegen.JITCPUCodegen
    kept = library.finalize, library._optimize_functions, code.set_env

    def lay_out(self: Any, module: Any) -> None:
        module.data_layout = self._codegen._data_layout

    def finish(self: Any) -> None:
        self._finalized = True

    library.finalize, library._optimize_functions, code.set_env = finish, lay_out, lambda *_: None
    try:
        yield
    finally:
        library.finalize, library._optimize_functions, code.set_env = kept


def _linked(library: Any) -> Any:
    """Return the module of a library, linked with all functions that it calls."""
    module, seen, waiting = library._final_module.clone(), set(), list(library._linking_libraries)
    while waiting:
        part = waiting.pop(0)
        if part not in seen:
            seen.add(part)
            waiting += part._linking_libraries
            module.link_in(part._get_module_for_linking(), preserve=True)
    return module


class _Entry:
    """``int64 entry(PyObject* arguments, int64* facts)``: walk the arguments, check them, call the loop.

    It returns the result of the loop, -1 - i if leaf ``i`` has the wrong type or layout, and FAILED if the loop
    raises an exception. Errors of Python itself (a text instead of a number) remain set. An ``unlocked`` loop runs
    without the interpreter lock.
    """

    def __init__(self, loop: Any, names: list[str], *, unlocked: bool = False) -> None:
        self.context = cpu_target.target_context
        self.module = self.context.codegen().create_library(ENTRY).create_ir_module(ENTRY)
        self.leaves: list[Leaf] = []
        function = ir.Function(
            self.module, ir.FunctionType(_INDEX, [_POINTER, _INDEX.as_pointer()]), ENTRY
        )
        self.builder = b = ir.IRBuilder(function.append_basic_block())
        self.is_array = self._array_check()
        arguments, self.facts = function.args
        values = self._items(arguments, loop.argtypes, names, ())
        error = b.call(self._python("PyErr_Occurred", _POINTER, []), [])
        with b.if_then(b.icmp_unsigned("!=", error, _POINTER(None)), likely=False):
            b.ret(_INDEX(0))
        kind = self.context.call_conv.get_function_type(loop.restype, loop.argtypes)
        target = cgutils.get_or_insert_function(self.module, kind, loop.llvm_func_name)
        lock = b.call(self._python("PyEval_SaveThread", _POINTER, []), []) if unlocked else None
        status, result = self.context.call_conv.call_function(
            b, target, loop.restype, loop.argtypes, values
        )
        if unlocked:
            b.call(self._python("PyEval_RestoreThread", ir.VoidType(), [_POINTER]), [lock])
        with b.if_then(status.is_error, likely=False):
            b.ret(_INDEX(FAILED))
        b.ret(_INDEX(0) if loop.restype == types.none else result)

    def _python(self, name: str, result: Any, arguments: list[Any]) -> Any:
        return cgutils.get_or_insert_function(self.module, ir.FunctionType(result, arguments), name)

    def _items(
        self, value: Any, kinds: Any, names: Any, path: tuple[tuple[int, str], ...]
    ) -> list[Any]:
        """Return the items of a tuple."""
        b = self.builder
        size = b.call(self._python("PyTuple_Size", _INDEX, [_POINTER]), [value])
        self._check(b.icmp_signed("==", size, _INDEX(len(kinds))), path, f"a tuple of {len(kinds)}")
        item = self._python("PyTuple_GetItem", _POINTER, [_POINTER, _INDEX])
        return [
            self._value(b.call(item, [value, _INDEX(i)]), kind, (*path, (i, name)))
            for i, (kind, name) in enumerate(zip(kinds, names, strict=True))
        ]

    def _check(self, holds: Any, path: tuple[tuple[int, str], ...], wanted: str) -> None:
        self.leaves.append((path, wanted))
        with self.builder.if_then(self.builder.not_(holds), likely=False):
            # What asking no tuple for its size has left.
            self.builder.call(self._python("PyErr_Clear", ir.VoidType(), []), [])
            self.builder.ret(_INDEX(-len(self.leaves)))

    def _value(self, value: Any, kind: Any, path: tuple[tuple[int, str], ...]) -> Any:
        b = self.builder
        if isinstance(kind, types.BaseTuple):
            items = self._items(value, kind.types, kind.instance_class._fields, path)
            return self.context.make_tuple(b, kind, items)
        if isinstance(kind, types.Array):
            return self._array(value, kind, path)
        if isinstance(kind, types.Boolean):
            truth = b.call(self._python("PyObject_IsTrue", _SHORT, [_POINTER]), [value])
            return b.icmp_signed("!=", truth, _SHORT(0))
        if isinstance(kind, types.Float):
            return b.call(self._python("PyFloat_AsDouble", _DOUBLE, [_POINTER]), [value])
        return b.call(self._python("PyLong_AsLongLong", _INDEX, [_POINTER]), [value])

    def _array(self, value: Any, kind: Any, path: tuple[tuple[int, str], ...]) -> Any:
        b, size = self.builder, kind.ndim
        order = _ALIGNED | _ORDERS[kind.layout]
        number = b.load(b.gep(self.facts, [_INDEX(2 + _KINDS.index(kind.dtype))]))
        sound = b.call(self.is_array, [value, self.facts, _SHORT(size), number, _SHORT(order)])
        self._check(
            sound, path, f"{kind.dtype}, {size} dimension{'s' * (size != 1)}, order {kind.layout}"
        )
        head = b.load(b.gep(self.facts, [_INDEX(1)]))
        array = self.context.make_array(kind)(self.context, b)
        fields = [_field(b, value, head, offset, _INDEX.as_pointer()) for offset in (16, 24)]
        shape, strides = (
            [b.load(b.gep(field, [_INDEX(i)])) for i in range(size)] for field in fields
        )
        count = shape[0]
        for length in shape[1:]:
            count = b.mul(count, length)
        array.meminfo = cgutils.get_null_value(array.meminfo.type)
        array.parent = cgutils.get_null_value(array.parent.type)
        array.nitems, array.itemsize = count, _INDEX(kind.dtype.bitwidth // 8)
        array.data = b.bitcast(_field(b, value, head, 0, _POINTER), array.data.type)
        array.shape, array.strides = (
            cgutils.pack_array(b, values, ty=_INDEX) for values in (shape, strides)
        )
        return array._getvalue()

    def _array_check(self) -> Any:
        """``bool(array, facts, dimensions, number of its type, flags)``: check that an object is such an array."""
        kinds = [_POINTER, _INDEX.as_pointer(), _SHORT, _INDEX, _SHORT]
        function = ir.Function(self.module, ir.FunctionType(ir.IntType(1), kinds), "is_array")
        function.attributes.add("noinline")
        value, facts, dimensions, number, flags = function.args
        b = ir.IRBuilder(function.append_basic_block())

        def demand(holds: Any) -> None:
            with b.if_then(b.not_(holds), likely=False):
                b.ret(ir.IntType(1)(0))

        kind, head = (b.load(b.gep(facts, [_INDEX(i)])) for i in range(2))
        demand(b.icmp_unsigned("==", _field(b, value, head, -8, _INDEX), kind))
        demand(b.icmp_unsigned("==", _field(b, value, head, 8, _SHORT), dimensions))
        demand(b.icmp_unsigned("==", b.and_(_field(b, value, head, 48, _SHORT), flags), flags))
        type_of_items = _field(b, value, head, 40, _POINTER)
        demand(b.icmp_unsigned("==", _field(b, type_of_items, head, 10, _BYTE), _BYTE(ord("="))))
        b.ret(
            b.icmp_signed("==", b.sext(_field(b, type_of_items, head, 12, _SHORT), _INDEX), number)
        )
        return function


def _field(builder: Any, value: Any, head: Any, offset: int, kind: Any) -> Any:
    """Return the value ``offset`` bytes after the head of an object."""
    place = builder.gep(value, [builder.add(head, _INDEX(offset))])
    return builder.load(builder.bitcast(place, kind.as_pointer()))
