"""The processor of this process, and compiling of LLVM modules to code in memory."""

from __future__ import annotations

import contextlib
import os
import threading
from collections.abc import Iterable
from functools import cache
from typing import Any

import llvmlite
from llvmlite import binding as llvm

from jounce.core.errors import SimulationError

IN_LLVM = threading.RLock()
"""Held while code is compiled or loaded; forking needs it too, so that a child never inherits LLVM half-changed."""


class Address(int):
    """Address of a loaded function. It holds a reference to the code, which is not unloaded before the address dies."""

    def __new__(cls, value: int, code: Any) -> Address:
        """Store the object that keeps the code loaded with the address."""
        address = super().__new__(cls, value)
        address._code = code
        return address

    _code: Any


class MachineCode:
    """Loaded machine code; ``address[name]`` is the address of the function of that name."""

    def __init__(self, objects: Iterable[bytes], names: tuple[str, ...]) -> None:
        with IN_LLVM:
            engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), this_machine())
            for code in objects:
                engine.add_object_file(llvm.ObjectFileRef.from_data(code))
            engine.finalize_object()
            self.address = {
                name: Address(engine.get_function_address(name), engine) for name in names
            }
        if not all(self.address.values()):
            raise ValueError("the object lacks a function")


def machine_code(module: Any, machine: Any, level: int, *, vectors: bool = True) -> bytes:
    """Optimise a module, and return the object for a machine."""
    optimise(module, machine, level, vectors=vectors)
    return bytes(machine.emit_object(module))


def optimise(module: Any, machine: Any, level: int, *, vectors: bool = True) -> None:
    """Run LLVM's passes over a module; loops are vectorised from level 2 on if ``vectors`` is true."""
    tuning = llvm.create_pipeline_tuning_options(speed_level=level)
    tuning.loop_vectorization, tuning.slp_vectorization = (
        vectors and level > 1,
        False,
    )  # packing scalars costs more than it gains
    tuning.loop_unrolling = level > 1  # at level 1 unrolled loops would not be vectorised later
    builder = llvm.create_pass_builder(machine, tuning)
    builder.getModulePassManager().run(module, builder)


@cache
def _initialise() -> None:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()


def this_machine(level: int = 3) -> Any:
    """Return LLVM's target machine for this process; level 0 compiles fastest, level 3 gives the fastest code."""
    _initialise()
    return llvm.Target.from_default_triple().create_target_machine(
        opt=level, cpu=processor(), features=_features(), jit=True
    )


LEVEL_3 = (
    "avx2",
    "bmi",
    "bmi2",
    "f16c",
    "fma",
    "lzcnt",
    "movbe",
)  # Intel from 2013 on, AMD from 2015 on
LEVELS: dict[str, tuple[str, ...]] = {
    "x86-64": (),
    "x86-64-v2": ("cx16", "popcnt", "sse4.2", "ssse3"),
    "x86-64-v3": LEVEL_3,
}
"""Processor levels that ``JOUNCE_PROCESSOR`` may name with the features each needs (x86-64 psABI)."""


@cache
def processor() -> str:
    """Return the processor that code is compiled for: this one, or the level in ``JOUNCE_PROCESSOR``.

    Raises
    ------
    SimulationError
        If there is no such level, or this processor is below it: illegal instructions would end the process.
    """
    level = os.environ.get("JOUNCE_PROCESSOR")
    if not level:
        return str(llvm.get_host_cpu_name())
    if level not in levels():
        raise SimulationError(
            "code cannot be generated for this processor level",
            where="JOUNCE_PROCESSOR",
            found=level,
            allowed=", ".join(levels()) or "none: this processor is not x86-64",
            hint="Unset it, so that code is generated for the processor of this machine.",
        )
    return level


def levels() -> list[str]:
    """Return the levels that this processor reaches."""
    available = _instructions()
    known = LEVELS if llvm.get_process_triple().startswith("x86_64") else {}
    return [
        name
        for name, needs in known.items()
        if all(available.get(feature, False) for feature in needs)
    ]


@cache
def features() -> dict[str, bool]:
    """Return whether code may use each instruction set, by name; empty if LLVM does not know the processor."""
    available = _instructions()
    return (
        dict.fromkeys(LEVELS[processor()], True)
        if os.environ.get("JOUNCE_PROCESSOR")
        else available
    )


def _instructions() -> dict[str, bool]:
    with contextlib.suppress(RuntimeError):
        return dict(llvm.get_host_cpu_features())
    return {}


def vector_width() -> int:
    """Doubles per widest vector of this processor: 8 with AVX-512, else 4 (two vectors of 2 on SSE and NEON)."""
    return 8 if features().get("avx512f", False) else 4


def _features() -> str:
    return ",".join(f"{'+' if has else '-'}{name}" for name, has in sorted(features().items()))


def compiled_for() -> str:
    """Identify system, processor and compiler versions; code made for another combination is not used.

    A cache folder may be shared with other systems (a container's home), whose objects LLVM aborts on.
    """
    versions = f"{llvmlite.__version__} {llvm.llvm_version_info}"
    return f"{versions} {llvm.get_process_triple()} {processor()} {_features()}"
