"""Compilation of an FMU's C code: zig (the extra ``fmu``) for all platforms, or the system compiler for its own."""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from jounce.control.fmu.platforms import PLATFORMS, this_platform
from jounce.core.errors import OutputError, is_of_system, resource_error, unknown
from jounce.core.phrases import Phrase
from jounce.core.programs import program_on_path
from jounce.kernel.cache import cache_folder

C = Path(__file__).parent / "c"
_LARGE = 1_000_000  # bytes of C: above it, -O2 compiles 1.5 times as long without faster branch-free code
_FLAGS = (
    "-std=c99", "-ffp-contract=off", "-fno-math-errno", "-fvisibility=default", "-fPIC", "-shared",
    "-fno-tree-slp-vectorize",  # states are stored singly: a vector load by GCC would wait for both stores
)  # fmt: skip
_LONGEST = 600.0  # s: time limit of a compiler


def compiler_for(platforms: Sequence[str]) -> tuple[str, list[str]] | None:
    """Find a compiler for all given platforms; return its name and command, or None."""
    for name in platforms:
        if name not in PLATFORMS:
            raise unknown(name, PLATFORMS, what="platform", where="export")
    if importlib.util.find_spec("ziglang") is not None:
        return "zig", [sys.executable, "-P", "-m", "ziglang", "cc"]
    if list(platforms) == [this_platform()]:
        for name in ("cc", "gcc", "clang"):
            result = program_on_path(name)
            if result is not None:
                return "cc", [result]
    return None


def compile_library(
    folder: Path, version: int, platform: str, compiler: tuple[str, list[str]]
) -> bytes:
    """Compile ``model.c`` in ``folder`` with the interface of an FMI version; return the shared library."""
    name, command = compiler
    out, target = folder / f"{platform}{PLATFORMS[platform].suffix}", PLATFORMS[platform].target
    words = [
        *command,
        *_FLAGS,
        "-O1" if (folder / "model.c").stat().st_size > _LARGE else "-O2",
        f"-I{C}",
        f"-I{folder}",
    ]
    if name == "zig":
        words += ["-target", target, "-s", "-g0"]
    if "darwin" in platform:
        words.append("-Wl,-no_uuid") if name != "zig" else None
    words += [
        "-o",
        str(out),
        str(folder / "model.c"),
        str(C / "core.c"),
        str(C / f"fmi{version}.c"),
    ]
    if "linux" in platform:
        words.append("-lm")
    places = {
        **os.environ,
        **dict.fromkeys(("TMPDIR", "TMP", "TEMP"), str(folder)),
    }  # temporary files are removed with the folder
    if name == "zig":
        places = {
            "ZIG_GLOBAL_CACHE_DIR": _zig_folder(folder),
            **places,
            "ZIG_LOCAL_CACHE_DIR": str(folder / "zig"),
        }
    try:
        done = subprocess.run(
            words, capture_output=True, text=True, check=False, timeout=_LONGEST, env=places
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        if is_of_system(error):
            raise resource_error(error, f"{platform}, {name}") from None
        raise OutputError(
            Phrase("compilation of the FMU's C code failed: {error}", error=str(error)),
            where=platform,
            hint=_HINT,
        ) from None
    if done.returncode:
        raise OutputError(
            "compilation of the FMU's C code failed",
            where=f"{platform}, {name}",
            found=done.stderr.strip()[-1000:],
            hint=_HINT,
        )
    return out.read_bytes()


def _zig_folder(folder: Path) -> str:
    """Return the folder of zig's platform libraries, slow to build: jounce's cache or a temporary folder."""
    try:
        return str(cache_folder() / "zig")
    except RuntimeError:
        return str(folder / "zig")


_HINT = "Export sources only (no platform), and compile them on the target."
