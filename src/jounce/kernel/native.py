"""Native code of expression graphs, made once and kept on disk."""

from __future__ import annotations

import contextlib
import gc
import hashlib
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import accumulate, pairwise
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from llvmlite import binding as llvm
from numpy.typing import NDArray

from jounce.core.waiting import told
from jounce.kernel.apart import compile_in_child
from jounce.kernel.cache import joined, keep, key_here, parted, recall, why_not_kept
from jounce.kernel.call import Loop
from jounce.kernel.machine import IN_LLVM, Code, machine_code, this_machine

if TYPE_CHECKING:
    from jounce.kernel.lowering import AnyFunction, Lowering

MANY = ("output", "project_many", "switch_many")
SELDOM = frozenset({"slopes", "switch_slope", "derived", "derived_lanes", "constraint", "constraint_s"})
"""Functions called a few times a run: they are compiled without optimising, which would make them little faster."""


class AnyStep(Protocol):
    """Functions around those of a model that are written as native code (steps, loops over rows), and their names."""

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the functions."""

    def add(self, lowering: Lowering) -> None:
        """Append the functions."""


SINGLE = {"project": "project_many"}
"""Functions of one sample that are made of those of many, where a module has these."""


@dataclass(frozen=True)
class Source:
    """What native code is made of: functions by name, the step around them, and notes that are kept with the code."""

    functions: Mapping[str, AnyFunction]
    step: AnyStep | None = None
    notes: str = ""


class Native(Code):
    """Native code of a model; ``address[name]`` is where the function of that name lives."""

    def evaluate(self, name: str, shape: tuple[int, ...], *inputs: NDArray[np.float64]) -> NDArray[np.float64]:
        """Call one function ``f(x, u, p, m)`` from Python; matrices come column-major, as CasADi stores them."""
        out = np.empty(math.prod(shape))
        address = self.address[name]
        try:
            _evaluate(address, *inputs, out)
        except TypeError:  # an argument that is no row of numbers side by side
            _evaluate(address, *(np.ascontiguousarray(value, dtype=np.float64).ravel() for value in inputs), out)
        return out if len(shape) == 1 else out.reshape(shape, order="F")


_evaluate = Loop("evaluate")


def compile_functions(functions: Mapping[str, AnyFunction], step: AnyStep | None = None) -> Native:
    """Compile SX functions (all inputs and outputs dense) for this processor, or load them from the cache.

    ``step`` adds the functions of an integration step around them.
    """
    import casadi as ca

    digest = hashlib.sha256(repr(step).encode())
    for name, function in functions.items():
        graph, form = (function, "()") if isinstance(function, ca.Function) else (function.function, function.form)
        digest.update(f"\n{name} {form}\n{graph.serialize()}".encode())
    return kept_code(digest.hexdigest(), lambda: Source(functions, step))[0]


def kept_code(identity: str, make: Callable[[], Source]) -> tuple[Native, str]:
    """Give native code and the notes of its source from the cache, or make them and keep them.

    ``identity`` says everything that the code depends on, apart from this processor, the kernel and versions of the
    compiler; ``make`` gives the functions where the cache holds no sound entry.
    """
    key = key_here(identity)
    cached = recall(key)
    if cached is not None:
        with contextlib.suppress(Exception):  # whatever is wrong with it: rebuild
            return _load(cached)
    once = f"in every process: {why}" if (why := why_not_kept()) else "once on this machine"
    with told(f"compiling the model ({once})"), _garbage_waits():
        content = compile_in_child(lambda: _made(make)) or _made(make)
        keep(key, content)
    return _load(content)


def _made(make: Callable[[], Source]) -> bytes:
    """Make an entry of the cache.

    Code is kept as an object file: loading one takes a millisecond, where optimising the same functions takes seconds.
    """
    source = make()
    names = [*source.functions, *_singles(source.functions), *(source.step.names if source.step else ())]
    with IN_LLVM:
        objects = _emit(source.functions, source.step)
    head = {"names": names, "notes": source.notes, "sizes": [len(code) for code in objects]}
    return joined(head, b"".join(objects))


@contextlib.contextmanager
def _garbage_waits() -> Iterator[None]:
    """Collect no garbage for a while: a model is made of a million small objects, and hardly one of them is any.

    They are let go before its end, or the first collection would look at each of them.
    """
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()


def _load(content: bytes) -> tuple[Native, str]:
    head, code = parted(content)
    ends = [0, *accumulate(head["sizes"])]
    objects = (code[begin:end] for begin, end in pairwise(ends))
    return Native(objects, tuple(head["names"])), str(head["notes"])


def _singles(functions: Mapping[str, object]) -> dict[str, str]:
    return {name: many for name, many in SINGLE.items() if many in functions and name not in functions}


def _emit(functions: Mapping[str, AnyFunction], step: AnyStep | None = None) -> list[bytes]:
    """Objects of functions: those that a run calls again and again, and those called seldom."""
    from jounce.kernel.lowering import Lowering

    often, seldom = Lowering(), Lowering()  # two modules: how code is made is said for a whole one
    for name, function in functions.items():
        if name in SELDOM:
            seldom.add(name, function, seldom=True)
        elif name in MANY:
            often.add_many(name, function)
        else:
            often.add(name, function)
    for name, many in _singles(functions).items():
        often.add_single(name, many)
    if step:
        step.add(often)
    # Of poses there are tens, not thousands as of a run's samples, and to find that so large a loop is none for vectors
    # takes longer than all else: 2 of 4 s for the slopes of a corner along six coordinates of its hardpoints.
    made = [machine_code(_parsed(often), this_machine(), 3, vectors=step is not None)]
    if not SELDOM.isdisjoint(functions):
        made.append(bytes(this_machine(0).emit_object(_parsed(seldom))))
    return made


def _parsed(lowering: Lowering) -> Any:
    """The module as LLVM has it; what it was written as, where blocks and instructions hold each other, is let go."""
    module = llvm.parse_assembly(str(lowering.module))
    for function in lowering.module.functions:
        for block in function.blocks:
            block.instructions = []
    module.verify()
    return module
