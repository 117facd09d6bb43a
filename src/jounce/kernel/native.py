"""Native code of expression graphs, cached on disk.

A cache entry that is damaged or stale, or that others could have written, is rebuilt, never trusted.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import logging
import math
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import llvmlite
import numpy as np
from llvmlite import binding as llvm
from numpy.typing import NDArray

from jounce.core.errors import OutputError
from jounce.core.ownership import ForeignError, own_folder, read_own
from jounce.core.sources import digest_of, edited_since
from jounce.core.waiting import told

if TYPE_CHECKING:
    from jounce.kernel.call import Loop
    from jounce.kernel.lowering import AnyFunction, Lowering

MANY = ("output", "project_many", "switch_many")
SELDOM = ("slopes", "switch_slope", "derived", "derived_lanes", "constraint", "constraint_s")
"""Functions called a few times a run: they are compiled without the optimiser, which makes them little faster."""


class AnyStep(Protocol):
    """Functions around those of a model that are written as native code (steps, loops over rows), and their names."""

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the functions."""

    def add(self, lowering: Lowering) -> None:
        """Append the functions."""


SINGLE = {"project": "project_many"}
"""Functions of one sample that are made of those of many, where a module has these."""
_CHECKSUM, _LENGTH = 32, 8
_LOG = logging.getLogger("jounce")


@dataclass(frozen=True)
class Source:
    """What native code is made of: functions by name, the step around them, and notes that are kept with the code."""

    functions: Mapping[str, AnyFunction]
    step: AnyStep | None = None
    notes: str = ""


class Native:
    """Loaded machine code; ``address[name]`` is where the function of that name lives while this object does."""

    def __init__(self, code: bytes, names: tuple[str, ...]) -> None:
        self._engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), this_machine())
        self._engine.add_object_file(llvm.ObjectFileRef.from_data(code))
        self._engine.finalize_object()
        self.address = {name: int(self._engine.get_function_address(name)) for name in names}
        if not all(self.address.values()):
            raise ValueError("the object lacks a function")

    def evaluate(self, name: str, shape: tuple[int, ...], *inputs: NDArray[np.float64]) -> NDArray[np.float64]:
        """Call one function ``f(x, u, p, m)`` from Python; matrices come column-major, as CasADi stores them."""
        out = np.empty(math.prod(shape))
        evaluate, address = _evaluate(), self.address[name]
        try:
            evaluate(address, *inputs, out)
        except TypeError:  # an argument that is no row of numbers side by side
            evaluate(address, *(np.ascontiguousarray(value, dtype=np.float64).ravel() for value in inputs), out)
        return out if len(shape) == 1 else out.reshape(shape, order="F")


@cache
def _evaluate() -> Loop:
    from jounce.kernel.call import Loop

    return Loop("evaluate")


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
    with told("compiling the model (once on this machine)"):
        source = make()
        # Code is kept as an object file: loading one takes a millisecond, where optimising the same functions takes
        # seconds.
        names = [*source.functions, *_singles(source.functions), *(source.step.names if source.step else ())]
        content = joined({"names": names, "notes": source.notes}, _emit(source.functions, source.step))
        keep(key, content)
    return _load(content)


def _load(content: bytes) -> tuple[Native, str]:
    head, code = parted(content)
    return Native(code, tuple(head["names"])), str(head["notes"])


def key_here(identity: str) -> str:
    """Key of code for this processor, made by these versions of the kernel and the compiler."""
    target = f"{llvm.get_host_cpu_name()} {_features()} {llvm.llvm_version_info}"
    return hashlib.sha256(f"{digest_of('kernel')} {llvmlite.__version__} {target} {identity}".encode()).hexdigest()


def joined(head: dict[str, Any], code: bytes) -> bytes:
    """Give code with what is to be known of it before."""
    text = json.dumps(head).encode()
    return len(text).to_bytes(_LENGTH, "little") + text + code


def parted(content: bytes) -> tuple[dict[str, Any], bytes]:
    """Give back what ``joined`` has put together."""
    start = _LENGTH + int.from_bytes(content[:_LENGTH], "little")
    return json.loads(content[_LENGTH:start]), content[start:]


def cache_folder() -> Path:
    """Folder of compiled models: ``$JOUNCE_CACHE_DIR``, else ``$XDG_CACHE_HOME/jounce``, else ``~/.cache/jounce``.

    Raises
    ------
    RuntimeError
        Where none can be named: no home folder, or a ``$JOUNCE_CACHE_DIR`` that is not absolute. What lies below the
        folder that one happens to stand in may be anybody's, an unpacked archive's for example.
    """
    own = os.environ.get("JOUNCE_CACHE_DIR")
    if own:
        if not Path(own).is_absolute():
            _tell_relative(own)
            raise RuntimeError("no absolute path")
        return Path(own)
    shared = os.environ.get("XDG_CACHE_HOME")  # the standard says: not absolute, not valid
    return (Path(shared) if shared and Path(shared).is_absolute() else Path.home() / ".cache") / "jounce"


@cache
def _tell_relative(given: str) -> None:
    _LOG.warning("JOUNCE_CACHE_DIR is not an absolute path: %s; no native code is kept", ascii(given))


def _singles(functions: Mapping[str, object]) -> dict[str, str]:
    return {name: many for name, many in SINGLE.items() if many in functions and name not in functions}


def _emit(functions: Mapping[str, AnyFunction], step: AnyStep | None = None) -> bytes:
    from jounce.kernel.lowering import Lowering

    lowering = Lowering()
    for name, function in functions.items():
        if name in MANY:
            lowering.add_many(name, function)
        else:
            lowering.add(name, function, seldom=name in SELDOM)
    for name, many in _singles(functions).items():
        lowering.add_single(name, many)
    if step:
        step.add(lowering)
    module = llvm.parse_assembly(str(lowering.module))
    module.verify()
    return machine_code(module, this_machine(), 3)


def machine_code(module: Any, machine: Any, level: int) -> bytes:
    """Optimise a module, and give the object for a machine."""
    optimise(module, machine, level)
    return bytes(machine.emit_object(module))


def optimise(module: Any, machine: Any, level: int) -> None:
    """Run LLVM's passes over a module; from level 2 on loops are made vectors."""
    tuning = llvm.create_pipeline_tuning_options(speed_level=level)
    tuning.loop_vectorization, tuning.slp_vectorization = level > 1, False  # packing scalars costs more than it gains
    tuning.loop_unrolling = level > 1  # unrolled loops would not become vectors any more
    builder = llvm.create_pass_builder(machine, tuning)
    builder.getModulePassManager().run(module, builder)


@cache
def _initialise() -> None:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()


def this_machine() -> Any:
    """Give the machine that this process runs on."""
    _initialise()
    return llvm.Target.from_default_triple().create_target_machine(
        opt=3, cpu=llvm.get_host_cpu_name(), features=_features(), jit=True
    )


@cache
def features() -> dict[str, bool]:
    """Special instructions of this processor by name, whether it has them; none where LLVM does not know it."""
    with contextlib.suppress(RuntimeError):
        return dict(llvm.get_host_cpu_features())
    return {}


def _features() -> str:
    return ",".join(f"{'+' if has else '-'}{name}" for name, has in sorted(features().items()))


def recall(key: str) -> bytes | None:
    """Give a cached entry whose checksum holds, else None."""
    with contextlib.suppress(RuntimeError):  # there is no home folder
        return read_sealed(cache_folder() / f"{key}.o", key)
    return None


def keep(key: str, content: bytes) -> None:
    """Store an entry; a folder that cannot be written means no cache."""
    with contextlib.suppress(RuntimeError):  # there is no home folder
        write_sealed(cache_folder() / f"{key}.o", key, content)


def read_sealed(file: Path, key: str) -> bytes | None:
    """Give what a file holds if it was written for this key, is whole, and nobody else could have put it there."""
    try:
        content = read_own(file)
    except ForeignError as error:
        _tell_foreign(file.parent, str(error.filename))
        return None
    except OSError:
        return None
    checksum, rest = content[:_CHECKSUM], content[_CHECKSUM:]
    return rest if rest and _checksum(key, rest) == checksum else None


def write_sealed(file: Path, key: str, content: bytes) -> bool:
    """Write a file whole or not at all; tell whether that was possible, where nobody else writes.

    Nothing is written where the kernel has been edited meanwhile: code of modules as they were would pass for new code.
    """
    from jounce.core.writing import replacing

    try:
        folder = own_folder(file.parent)
        if edited_since("kernel"):
            return False
        with replacing(folder / file.name) as temporary:
            temporary.write_bytes(_checksum(key, content) + content)
    except ForeignError as error:
        _tell_foreign(file.parent, str(error.filename))
        return False
    except (OSError, OutputError):
        return False
    return True


_TOLD: set[Path] = set()


def _tell_foreign(folder: Path, where: str) -> None:
    """Say once of a folder that it is not used, and why."""
    if folder not in _TOLD:
        _TOLD.add(folder)
        _LOG.warning(
            "%s belongs to another user or can be written by others: native code is neither read from there nor kept "
            "there (own it, and chmod go-w, or set JOUNCE_CACHE_DIR to a folder of your own)",
            ascii(where),
        )


def _checksum(key: str, content: bytes) -> bytes:
    """Checksum of an entry, with what it was made for."""
    return hashlib.sha256(key.encode() + content).digest()
