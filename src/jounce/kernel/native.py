"""Native code of expression graphs, cached on disk. A damaged or stale cache entry is rebuilt, never trusted."""

from __future__ import annotations

import contextlib
import ctypes
import hashlib
import os
import tempfile
from functools import cache
from pathlib import Path
from typing import Any

import casadi as ca
import llvmlite
import numpy as np
from llvmlite import binding as llvm
from numpy.typing import NDArray

from jounce.kernel.lowering import Lowering
from jounce.kernel.steps import STEP_NAMES, Step, add_step_functions

_FORMAT = "jounce-kernel-15"
MANY = ("output", "output_s", "project_many")
_PROTOTYPE = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 5, *[ctypes.c_int64] * 3)


class Native:
    """Loaded machine code; ``address[name]`` is where the function of that name lives while this object does."""

    def __init__(self, code: bytes, names: tuple[str, ...]) -> None:
        self._engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), _machine())
        self._engine.add_object_file(llvm.ObjectFileRef.from_data(code))
        self._engine.finalize_object()
        self.address = {name: int(self._engine.get_function_address(name)) for name in names}
        if not all(self.address.values()):
            raise ValueError("the object lacks a function")
        self._calls = {name: _PROTOTYPE(address) for name, address in self.address.items()}

    def evaluate(self, name: str, shape: tuple[int, ...], *inputs: NDArray[np.float64]) -> NDArray[np.float64]:
        """Call one function ``f(x, u, p, m)`` from Python; matrices come column-major, as CasADi stores them."""
        out = np.empty(shape, order="F")
        arrays = [np.ascontiguousarray(value, dtype=np.float64) for value in inputs]
        self._calls[name](*(array.ctypes.data for array in arrays), out.ctypes.data, 1, 0, 1)
        return out


def compile_functions(functions: dict[str, ca.Function], step: Step | None = None) -> Native:
    """Compile SX functions for this processor, or load them from the cache.

    Parameters
    ----------
    functions : dict
        Name to CasADi function; all inputs and outputs dense.
    step : Step, optional
        Adds the functions of an integration step (``STEP_NAMES``) around the rate and switching functions.

    Returns
    -------
    Native
        Machine code with one address for each name.
    """
    key = _key(functions, step)
    names = (*functions, *(STEP_NAMES if step else ()))
    cached = _read(key)
    if cached is not None:
        with contextlib.suppress(Exception):  # whatever is wrong with it: rebuild
            return Native(cached, names)
    code = _emit(functions, step)
    _write(key, code)
    return Native(code, names)


def cache_folder() -> Path:
    """Folder of compiled models: ``$JOUNCE_CACHE_DIR``, else ``$XDG_CACHE_HOME/jounce``, else ``~/.cache/jounce``."""
    own = os.environ.get("JOUNCE_CACHE_DIR")
    if own:
        return Path(own)
    shared = os.environ.get("XDG_CACHE_HOME")
    return (Path(shared) if shared else Path.home() / ".cache") / "jounce"


def _key(functions: dict[str, ca.Function], step: Step | None) -> str:
    target = f"{llvm.get_host_cpu_name()} {llvm.get_host_cpu_features().flatten()} {llvm.llvm_version_info}"
    digest = hashlib.sha256(f"{_FORMAT} {llvmlite.__version__} {target} {step}".encode())
    for name, function in functions.items():
        digest.update(f"\n{name}\n{function.serialize()}".encode())
    return digest.hexdigest()


def _emit(functions: dict[str, ca.Function], step: Step | None = None) -> bytes:
    lowering = Lowering()
    for name, function in functions.items():
        (lowering.add_many if name in MANY else lowering.add)(name, function)
    if step:
        add_step_functions(lowering, step)
    module = llvm.parse_assembly(str(lowering.module))
    module.verify()
    tuning = llvm.create_pipeline_tuning_options(speed_level=3)
    tuning.loop_vectorization = tuning.slp_vectorization = True
    builder = llvm.create_pass_builder(_machine(), tuning)
    builder.getModulePassManager().run(module, builder)
    return bytes(_machine().emit_object(module))


@cache
def _initialise() -> None:
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()


def _machine() -> Any:
    _initialise()
    return llvm.Target.from_default_triple().create_target_machine(
        opt=3, cpu=llvm.get_host_cpu_name(), features=llvm.get_host_cpu_features().flatten(), jit=True
    )


def _read(key: str) -> bytes | None:
    """Give a cached object whose checksum holds, else None."""
    try:
        content = (cache_folder() / f"{key}.o").read_bytes()
    except (OSError, RuntimeError):  # RuntimeError: there is no home folder
        return None
    checksum, code = content[:32], content[32:]
    return code if code and _checksum(key, code) == checksum else None


def _checksum(key: str, code: bytes) -> bytes:
    """Checksum of an entry, with what it was made for."""
    return hashlib.sha256(key.encode() + code).digest()


def _write(key: str, code: bytes) -> None:
    """Store an object through a temporary file and a rename; a folder that cannot be written means no cache."""
    with contextlib.suppress(OSError, RuntimeError):  # RuntimeError: there is no home folder
        folder = cache_folder()
        folder.mkdir(parents=True, exist_ok=True)
        handle, name = tempfile.mkstemp(dir=folder)
        with os.fdopen(handle, "wb") as stream:
            stream.write(_checksum(key, code) + code)
        Path(name).replace(folder / f"{key}.o")
