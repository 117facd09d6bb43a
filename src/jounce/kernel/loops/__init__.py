"""Sources of the loops, compiled by Numba when jounce is built, or later if the built code cannot be used.

A run does not import this package; it calls the machine code by name (``kernel.call``). ``build`` compiles a loop,
``python -m jounce.kernel.loops.make`` all of them; ``compiling`` configures Numba.
"""

from __future__ import annotations

import platform
import sys
from dataclasses import dataclass
from pathlib import Path

from jounce.kernel.machine import LEVEL_3

SOURCES = (
    "kernel/loops",
    "kernel/methods",
    "kernel/arrays",
    "kernel/engine",
    "kernel/poses",
    "kernel/equilibrium",
)
"""Sources of the loops and of their arguments; built code is valid only for the current text of these modules."""

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
    "equilibrium": ("equilibrium", "follow"),
}
"""Loops that are called from Python: module and function."""

UNLOCKED = ("lanes", "exact", "explicit", "implicit")
"""Loops that run without the interpreter lock; a Python function called by them acquires it."""

ENTRY = "entry"
"""Name of the entry function of the code of a loop."""

FAILED = -(1 << 62)
"""Return code for an exception within the loop."""

BUILT = Path(__file__).parent / "built"
"""Folder of built code: ``<loop>.bc`` for all machines, ``<platform>/<loop>.o`` for one platform."""


@dataclass(frozen=True)
class Platform:
    """Target of built objects; processors that lack a feature in ``needs`` use the bitcode."""

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
    """Return the name of the platform of this process, which may be missing from ``PLATFORMS``."""
    system = "windows" if sys.platform == "win32" else sys.platform
    return f"{system}-{platform.machine().lower()}"


def key_of(loop: str, digest: str, platform: str = "bitcode") -> str:
    """Return the key of built code: its loop, its platform and the digest of its sources."""
    return f"{loop} {platform} {digest}"
