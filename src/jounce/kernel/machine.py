"""The processor that this process runs on, and LLVM's way from a module to code in memory."""

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
"""Held by whoever compiles or loads code: a process is split only while nobody does, or its half would find it torn."""


class Address(int):
    """Where a function of loaded code lives. Whoever holds the address holds the code: it is not unloaded before."""

    def __new__(cls, value: int, code: Any) -> Address:
        """Tie an address to what keeps its code loaded."""
        address = super().__new__(cls, value)
        address._code = code
        return address

    _code: Any


class Code:
    """Loaded machine code; ``address[name]`` is where the function of that name lives."""

    def __init__(self, objects: Iterable[bytes], names: tuple[str, ...]) -> None:
        with IN_LLVM:
            engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), this_machine())
            for code in objects:
                engine.add_object_file(llvm.ObjectFileRef.from_data(code))
            engine.finalize_object()
            self.address = {name: Address(engine.get_function_address(name), engine) for name in names}
        if not all(self.address.values()):
            raise ValueError("the object lacks a function")


def machine_code(module: Any, machine: Any, level: int, *, vectors: bool = True) -> bytes:
    """Optimise a module, and give the object for a machine."""
    optimise(module, machine, level, vectors=vectors)
    return bytes(machine.emit_object(module))


def optimise(module: Any, machine: Any, level: int, *, vectors: bool = True) -> None:
    """Run LLVM's passes over a module; from level 2 on loops are made vectors where they shall be."""
    tuning = llvm.create_pipeline_tuning_options(speed_level=level)
    tuning.loop_vectorization, tuning.slp_vectorization = (
        vectors and level > 1,
        False,
    )  # packing scalars costs more than it gains
    tuning.loop_unrolling = level > 1  # unrolled loops would not become vectors any more
    builder = llvm.create_pass_builder(machine, tuning)
    builder.getModulePassManager().run(module, builder)


@cache
def _initialise() -> None:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()


def this_machine(level: int = 3) -> Any:
    """Give the machine that this process runs on; at level 0 its code is made quickly rather than quick."""
    _initialise()
    return llvm.Target.from_default_triple().create_target_machine(
        opt=level, cpu=processor(), features=_features(), jit=True
    )


LEVEL_3 = ("avx2", "bmi", "bmi2", "f16c", "fma", "lzcnt", "movbe")  # Intel from 2013 on, AMD from 2015 on
LEVELS: dict[str, tuple[str, ...]] = {
    "x86-64": (),
    "x86-64-v2": ("cx16", "popcnt", "sse4.2", "ssse3"),
    "x86-64-v3": LEVEL_3,
}
"""Levels of processors that ``JOUNCE_PROCESSOR`` may name, and what each needs: those of the x86-64 psABI."""


@cache
def processor() -> str:
    """Name of the processor that code is made for: this one, or the level that ``JOUNCE_PROCESSOR`` names.

    Raises
    ------
    SimulationError
        Where there is no such level, or this processor is below it: its code would end the process.
    """
    level = os.environ.get("JOUNCE_PROCESSOR")
    if not level:
        return str(llvm.get_host_cpu_name())
    if level not in levels():
        raise SimulationError(
            "code cannot be made for this level of processors",
            where="JOUNCE_PROCESSOR",
            found=level,
            allowed=", ".join(levels()) or "nothing: this processor is no x86-64",
            hint="Unset it: code is then made for the processor that is there.",
        )
    return level


def levels() -> list[str]:
    """Levels that this processor reaches."""
    there = _instructions()
    known = LEVELS if llvm.get_process_triple().startswith("x86_64") else {}
    return [name for name, needs in known.items() if all(there.get(one, False) for one in needs)]


@cache
def features() -> dict[str, bool]:
    """Special instructions that code may use by name, whether it may; none where LLVM does not know the processor."""
    there = _instructions()
    return dict.fromkeys(LEVELS[processor()], True) if os.environ.get("JOUNCE_PROCESSOR") else there


def _instructions() -> dict[str, bool]:
    with contextlib.suppress(RuntimeError):
        return dict(llvm.get_host_cpu_features())
    return {}


def vector_width() -> int:
    """Numbers that the widest vectors of this processor hold: eight with AVX-512, else four (or two of two)."""
    return 8 if features().get("avx512f", False) else 4


def _features() -> str:
    return ",".join(f"{'+' if has else '-'}{name}" for name, has in sorted(features().items()))


def compiled_for() -> str:
    """System and processor, and versions of the compiler: code for others is not taken.

    A folder may be shared with other systems (a container's home), and LLVM ends a process that gives it their objects.
    """
    versions = f"{llvmlite.__version__} {llvm.llvm_version_info}"
    return f"{versions} {llvm.get_process_triple()} {processor()} {_features()}"
