"""Native code of expression graphs, compiled once and stored on disk."""

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

from jounce.core.phrases import Phrase
from jounce.core.waiting import report_work
from jounce.kernel.apart import compile_in_child
from jounce.kernel.cache import join, keep, key_here, recall, split, why_not_kept
from jounce.kernel.call import Loop
from jounce.kernel.machine import IN_LLVM, MachineCode, machine_code, this_machine

if TYPE_CHECKING:
    from jounce.kernel.lowering import AnyFunction, Lowering

MANY = ("output", "project_many", "switch_many")
SELDOM = frozenset(
    {"slopes", "switch_slope", "derived", "derived_lanes", "constraint", "constraint_s"}
)
"""Functions called a few times per run: compiled without optimisation, which takes longer than it saves."""


class AnyStep(Protocol):
    """Functions around those of a model, emitted as native code (steps, loops over rows)."""

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the functions."""

    def add(self, lowering: Lowering) -> None:
        """Append the functions."""


SINGLE = {"project": "project_many"}
"""Functions of one sample, derived from the function of many samples if the module has one."""


@dataclass(frozen=True)
class Source:
    """Source of native code: functions by name, the step around them, and notes stored with the code."""

    functions: Mapping[str, AnyFunction]
    step: AnyStep | None = None
    notes: str = ""


class Native(MachineCode):
    """Native code of a model; ``address[name]`` is the address of the function of that name."""

    def evaluate(
        self, name: str, shape: tuple[int, ...], *inputs: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Call one function ``f(x, u, p, m)`` from Python; matrices come column-major, as CasADi stores them."""
        out = np.empty(math.prod(shape))
        address = self.address[name]
        try:
            _evaluate(address, *inputs, out)
        except TypeError:  # an argument is no contiguous array of doubles
            _evaluate(
                address,
                *(np.ascontiguousarray(value, dtype=np.float64).ravel() for value in inputs),
                out,
            )
        return out if len(shape) == 1 else out.reshape(shape, order="F")


_evaluate = Loop("evaluate")


def compile_functions(functions: Mapping[str, AnyFunction], step: AnyStep | None = None) -> Native:
    """Compile SX functions (all inputs and outputs dense) for this processor, or load them from the cache.

    ``step`` adds the functions of an integration step around them.
    """
    import casadi as ca

    digest = hashlib.sha256(repr(step).encode())
    for name, function in functions.items():
        graph, form = (
            (function, "()")
            if isinstance(function, ca.Function)
            else (function.function, function.form)
        )
        digest.update(f"\n{name} {form}\n{graph.serialize()}".encode())
    return code_from_cache(digest.hexdigest(), lambda: Source(functions, step))[0]


def code_from_cache(identity: str, make: Callable[[], Source]) -> tuple[Native, str]:
    """Return native code and the notes of its source from the cache, or compile and store them.

    ``identity`` covers everything that the code depends on, except this processor, the kernel and versions of the
    compiler; ``make`` returns the functions if the cache has no valid entry.
    """
    key = key_here(identity)
    cached = recall(key)
    if cached is not None:
        with contextlib.suppress(Exception):  # any failure: rebuild
            return _load(cached)
    why = why_not_kept()
    once = Phrase("in every process: {why}", why=why) if why else Phrase("once on this machine")
    with (
        report_work(Phrase("compiling the model ({once})", once=once)),
        _without_garbage_collection(),
    ):
        content = compile_in_child(lambda: _compile_entry(make)) or _compile_entry(make)
        keep(key, content)
    return _load(content)


def _compile_entry(make: Callable[[], Source]) -> bytes:
    """Compile the functions to one cache entry.

    The entry holds object files: loading takes a millisecond, compiling the same functions takes seconds.
    """
    source = make()
    names = [
        *source.functions,
        *_singles(source.functions),
        *(source.step.names if source.step else ()),
    ]
    with IN_LLVM:
        objects = _emit(source.functions, source.step)
    head = {"names": names, "notes": source.notes, "sizes": [len(code) for code in objects]}
    return join(head, b"".join(objects))


@contextlib.contextmanager
def _without_garbage_collection() -> Iterator[None]:
    """Stop the garbage collector: compiling creates a million small objects, hardly any of them garbage.

    They are released inside this context; otherwise the first collection after it would visit each of them.
    """
    collects = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if collects:
            gc.enable()


def _load(content: bytes) -> tuple[Native, str]:
    head, code = split(content)
    ends = [0, *accumulate(head["sizes"])]
    objects = (code[begin:end] for begin, end in pairwise(ends))
    return Native(objects, tuple(head["names"])), str(head["notes"])


def _singles(functions: Mapping[str, object]) -> dict[str, str]:
    return {
        name: many for name, many in SINGLE.items() if many in functions and name not in functions
    }


def _emit(functions: Mapping[str, AnyFunction], step: AnyStep | None = None) -> list[bytes]:
    """Compile the objects: one of the functions that a run calls often, one of those in ``SELDOM``."""
    from jounce.kernel.lowering import Lowering

    often, seldom = (
        Lowering(),
        Lowering(),
    )  # two modules: the optimisation level holds for a whole module
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
    # Without a step there are tens of poses, not thousands of samples: vectorising does not pay, and the attempt
    # takes half the time (2 of 4 s for the slopes of a corner along six coordinates of its hardpoints).
    objects = [machine_code(_parse(often), this_machine(), 3, vectors=step is not None)]
    if not SELDOM.isdisjoint(functions):
        objects.append(bytes(this_machine(0).emit_object(_parse(seldom))))
    return objects


def _parse(lowering: Lowering) -> Any:
    """Parse the module by LLVM; llvmlite's own blocks and instructions, which form reference cycles, are released."""
    module = llvm.parse_assembly(str(lowering.module))
    for function in lowering.module.functions:
        for block in function.blocks:
            block.instructions = []
    module.verify()
    return module
