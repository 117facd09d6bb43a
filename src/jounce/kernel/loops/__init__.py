"""The loops themselves, as Numba compiles them: where jounce is built, and where nothing of that can be used.

Nothing here is imported by a run: it calls the machine code by name (``kernel.call``). ``build`` makes that code,
``python -m jounce.kernel.loops.make`` all of it; ``compiling`` says how Numba compiles.
"""

from __future__ import annotations

import platform
import sys
from dataclasses import dataclass
from pathlib import Path

from jounce.kernel.machine import LEVEL_3

SOURCES = ("kernel/loops", "kernel/methods", "kernel/arrays", "kernel/engine", "kernel/poses")
"""What the loops are made of, and what they are called with: built code is that of these modules as they are."""

LOOPS = {
    "evaluate": ("evaluate", "evaluate"),
    "exact": ("exact", "propagate"),
    "explicit": ("explicit", "integrate"),
    "implicit": ("implicit", "integrate"),
    "lanes": ("lanes", "follow"),
    "rate_bound": ("exact", "bound_rates"),
    "poses": ("poses", "walk_poses"),
    "pose_variants": ("poses", "walk_variants"),
    "quarter_car": ("quarter_car", "equations"),
    "turn_forces": ("turn_forces", "find"),
    "warping": ("warping", "path_back"),
    "hysteresis": ("hysteresis", "follow"),
    "drag": ("drag", "follow"),
}
"""Loops that are called from Python: module and function."""

UNLOCKED = ("lanes", "exact", "explicit", "implicit")
"""Loops that let go of the interpreter's lock while they run; a Python function that they call takes it by itself."""

ENTRY = "entry"
"""Name of the function that a loop's code is called by."""

FAILED = -(1 << 62)
"""What the code gives where the loop itself raises."""

BUILT = Path(__file__).parent / "built"
"""Where built code lies: ``<loop>.bc`` for every machine, ``<platform>/<loop>.o`` for one."""


@dataclass(frozen=True)
class Platform:
    """What objects are made for; a processor without what they ``need`` takes the bitcode."""

    triple: str
    processor: str
    needs: tuple[str, ...] = ()


PLATFORMS = {
    "linux-x86_64": Platform("x86_64-unknown-linux-gnu", "x86-64-v3", LEVEL_3),
    "linux-aarch64": Platform("aarch64-unknown-linux-gnu", "generic"),
    "darwin-x86_64": Platform("x86_64-apple-macosx11.0", "x86-64-v3", LEVEL_3),
    "darwin-arm64": Platform("arm64-apple-macosx11.0", "apple-m1"),
    "windows-amd64": Platform(
        "x86_64-pc-windows-msvc-elf", "x86-64-v3", LEVEL_3
    ),  # MCJIT loads ELF there, too
}


def this_platform() -> str:
    """Name of the platform that this process runs on, which need not be among ``PLATFORMS``."""
    system = "windows" if sys.platform == "win32" else sys.platform
    return f"{system}-{platform.machine().lower()}"


def key_of(loop: str, digest: str, platform: str = "bitcode") -> str:
    """What built code was made for: it is no other loop's, no other platform's, and of the sources as they are."""
    return f"{loop} {platform} {digest}"
