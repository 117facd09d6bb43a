"""Loops by name: machine code compiled when jounce is built, loaded at the first call.

Sources of the code, in this order: the object for this platform shipped with the package, one compiled here before,
the bitcode shipped with the package (compiled for this processor, and stored), and last the sources of the loops, which
need Numba. Stale, damaged or foreign code is skipped; slow steps are logged.

A loop takes tuples, arrays and numbers without conversion: the code reads them, and checks type, number of dimensions
and memory order of every array before it reads the first.
"""

from __future__ import annotations

import contextlib
import ctypes
import logging
import sys
import sysconfig
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from llvmlite import binding as llvm

from jounce.core.errors import JounceError
from jounce.core.optional import MissingPackageError, require
from jounce.core.phrases import Phrase
from jounce.core.sources import digest_of
from jounce.core.turns import once
from jounce.core.waiting import report_work
from jounce.kernel.cache import join, keep, key_here, read_sealed, recall, split, write_sealed
from jounce.kernel.loops import (
    BUILT,
    ENTRY,
    FAILED,
    PLATFORMS,
    SOURCES,
    Platform,
    key_of,
    this_platform,
)
from jounce.kernel.machine import IN_LLVM, MachineCode, features, machine_code, this_machine

PYTHON = (
    "PyErr_Clear",
    "PyErr_Occurred",
    "PyEval_RestoreThread",
    "PyEval_SaveThread",
    "PyFloat_AsDouble",
    "PyLong_AsLongLong",
    "PyObject_IsTrue",
    "PyTuple_GetItem",
    "PyTuple_Size",
)
"""Functions of the interpreter that the code calls."""
_HERE = "this processor"
"""Stands for a platform without a shipped object."""
_PROTOTYPE = ctypes.PYFUNCTYPE(ctypes.c_int64, ctypes.py_object, ctypes.c_void_p)
_LOG = logging.getLogger("jounce")
Head = dict[str, Any]


class Loop:
    """A loop by its name (see ``loops.LOOPS``), called with the arguments of its annotations; it returns an integer.

    With ``here`` the bitcode is compiled for this processor (once, 0.25 s), instead of loading the object
    for all processors of the platform: loops that run for seconds gain 10 % from wider registers.
    """

    def __init__(self, name: str, *, here: bool = False) -> None:
        self.name, self.here = name, here

    def __call__(self, *arguments: Any) -> int:
        """Run the loop.

        Raises
        ------
        TypeError
            If an argument has another type or layout than the code expects; nothing is read or written then.
        """
        code = self._call(arguments)
        if code < 0:
            raise self._refusal(code, arguments)
        return code

    @once
    def _load(self) -> tuple[Head, Callable[[tuple[Any, ...]], int]]:
        if not objects_are_known():
            _LOG.warning(
                "this build of Python is not known to the loops of jounce: Numba compiles %r here",
                self.name,
            )
            return {}, _by_numba(self.name)
        return _load(self.name, _HERE if self.here else this_platform())

    @once
    def _call(self) -> Callable[[tuple[Any, ...]], int]:
        return self._load[1]

    def _refusal(self, code: int, arguments: tuple[Any, ...]) -> Exception:
        if code == FAILED:
            return RuntimeError(f"the loop {self.name!r} failed")
        path, wanted = self._load[0]["leaves"][-1 - code]
        value: Any = arguments
        with contextlib.suppress(Exception):
            for place, _ in path:
                value = value[place]
        where = ".".join(name for _, name in path) or "arguments"
        return TypeError(f"loop {self.name!r}: {where} is {_describe(value)}, allowed is {wanted}")


def _describe(value: Any) -> str:
    if type(value) is not np.ndarray:
        return (
            f"{type(value).__name__} of {len(value)}"
            if isinstance(value, tuple)
            else type(value).__name__
        )
    flags = value.flags
    order = "C" if flags.c_contiguous else "F" if flags.f_contiguous else "neither C nor F"
    return f"{value.dtype.str}, {value.ndim} dimensions, order {order}{'' if flags.aligned else ', unaligned'}"


@cache
def _facts() -> Any:
    """Facts of this interpreter that the code needs: array type, offset of its fields, type numbers."""
    kinds = (np.float64, np.int64, np.complex128)
    return (ctypes.c_int64 * 5)(
        id(np.ndarray), object.__basicsize__, *(np.dtype(kind).num for kind in kinds)
    )


@cache
def objects_are_known() -> bool:
    """Check that Python's tuples and NumPy's arrays have the memory layout that the code assumes."""
    if (
        sys.implementation.name != "cpython"
        or sysconfig.get_config_var("Py_GIL_DISABLED")
        or sys.byteorder != "little"
        or ctypes.sizeof(ctypes.c_void_p) != 8
    ):
        return False
    array, head = np.zeros((3, 2)), object.__basicsize__

    def at(offset: int, kind: Any) -> Any:
        return kind.from_address(id(array) + head + offset).value

    fields = (
        at(-8, ctypes.c_int64),
        at(0, ctypes.c_int64),
        at(8, ctypes.c_int32),
        at(40, ctypes.c_int64),
    )
    if fields != (id(np.ndarray), array.__array_interface__["data"][0], 2, id(array.dtype)):
        return False
    shape, strides = (
        (ctypes.c_int64 * 2).from_address(at(offset, ctypes.c_int64)) for offset in (16, 24)
    )
    kind = (ctypes.c_char.from_address(id(array.dtype) + head + 10).value, array.dtype.num)
    number = ctypes.c_int32.from_address(id(array.dtype) + head + 12).value
    flags = at(48, ctypes.c_int32)
    return (
        (tuple(shape), tuple(strides)) == (array.shape, array.strides)
        and kind == (b"=", number)
        and flags & 0x503 == 0x501  # C-contiguous, aligned, writeable, not Fortran-contiguous
    )


def _load(name: str, platform: str) -> tuple[Head, Callable[[tuple[Any, ...]], int]]:
    """Load the code of a loop from the first source that works."""
    sources: tuple[Callable[[], bytes | None], ...] = (
        lambda: _read_shipped(name, platform),
        lambda: recall(key_here(f"loop {name}")),
    )
    for read in sources:
        with contextlib.suppress(Exception):  # any failure: try the next source
            content = read()
            if content is not None:
                return _ready(content)
    try:
        return _ready(_compile(name, platform))
    except JounceError:  # Numba is missing
        raise
    except Exception as error:  # noqa: BLE001 - LLVM raises RuntimeError, ValueError and OSError here
        _LOG.warning(
            "the code of the loop %r cannot be loaded here (%s): Numba compiles it", name, error
        )
        return {}, _by_numba(name)


def _ready(content: bytes) -> tuple[Head, Callable[[tuple[Any, ...]], int]]:
    for symbol in PYTHON:
        llvm.add_symbol(
            symbol, ctypes.cast(getattr(ctypes.pythonapi, symbol), ctypes.c_void_p).value
        )
    head, code = split(content)
    address, facts = MachineCode([code], (ENTRY,)).address[ENTRY], _facts()
    function, place = _PROTOTYPE(address), ctypes.addressof(facts)

    # keeps the code loaded as long as this function lives
    def call(arguments: tuple[Any, ...], _held: Any = (address, facts)) -> int:
        return int(function(arguments, place))

    return head, call


def _read_shipped(name: str, platform: str) -> bytes | None:
    if not _suits(platform):
        return None
    return read_sealed(BUILT / platform / f"{name}.o", key_of(name, digest_of(*SOURCES), platform))


@cache
def _suits(platform: str) -> bool:
    """Check that the package ships objects for this platform and that its processor can run them."""
    if platform not in PLATFORMS:
        return False
    return all(features().get(feature, False) for feature in PLATFORMS[platform].needs)


def _compile(name: str, platform: str) -> bytes:
    """Compile the bitcode of a loop (made from its sources if none was shipped), and store the object."""
    content = read_sealed(BUILT / f"{name}.bc", key_of(name, digest_of(*SOURCES)))
    with contextlib.suppress(Exception):  # for example bitcode of a newer LLVM
        if content is not None:
            return _compile_and_store(content, name, platform)
    return _compile_and_store(bitcode_from_sources(name), name, platform)


def _compile_and_store(bitcode: bytes, name: str, platform: str) -> bytes:
    """Compile the object of a loop, and store it beside its sources if possible, else in the user's cache."""
    if _suits(platform):
        content = object_for(bitcode, PLATFORMS[platform])
        key = key_of(name, digest_of(*SOURCES), platform)
        if write_sealed(BUILT / platform / f"{name}.o", key, content):
            return content
    else:
        content = object_for(bitcode)
    keep(key_here(f"loop {name}"), content)
    return content


def bitcode_from_sources(name: str) -> bytes:
    """Compile a loop with Numba, and store its bitcode beside the sources if possible."""
    _require_numba()
    from jounce.kernel.loops.build import bitcode_of

    _LOG.warning("compiling the loop %r (once; 2 to 30 s)", name)
    with (
        report_work(Phrase("compiling the loop {name!r} (once on this machine)", name=name)),
        IN_LLVM,
    ):
        content = bitcode_of(name)
    write_sealed(BUILT / f"{name}.bc", key_of(name, digest_of(*SOURCES)), content)
    return content


def _require_numba() -> None:
    """Raise if Numba is missing; for a source tree whose loops were never built the hint is to build them."""
    root = Path(__file__).parents[3]
    try:
        require("numba", "loops")
    except MissingPackageError:
        if not (root / "Makefile").is_file():
            raise
        raise MissingPackageError(
            "the loops of these sources are not built, and numba is not installed",
            where=str(root),
            hint="Run `make loops`.",
        ) from None


def object_for(bitcode: bytes, platform: Platform | None = None) -> bytes:
    """Compile the object of a loop for a platform, or for this processor if none is given."""
    machine = this_machine()
    if platform is not None:
        # On Windows llvmlite itself sets ELF.
        triple = (
            platform.triple.removesuffix("-elf") if sys.platform == "win32" else platform.triple
        )
        target = llvm.Target.from_triple(triple)
        machine = target.create_target_machine(cpu=platform.processor, opt=3, jit=True)
    head, code = split(bitcode)
    module = llvm.parse_bitcode(code)
    module.triple, module.data_layout = machine.triple, str(machine.target_data)
    return join(head, machine_code(module, machine, 2))


def _by_numba(name: str) -> Callable[[tuple[Any, ...]], int]:
    """Compile a loop by Numba with Numba's own entry: slower to start, but works with every build of Python."""
    _require_numba()
    from jounce.kernel.loops.build import function_of

    with IN_LLVM:
        function = function_of(name)
    return lambda arguments: int(function(*arguments) or 0)
