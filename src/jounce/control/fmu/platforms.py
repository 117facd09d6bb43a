"""Platforms of FMU binaries."""

from __future__ import annotations

import platform as machine
from dataclasses import dataclass


@dataclass(frozen=True)
class BinaryPlatform:
    """Platform of an FMU's binary: folder name in FMI 2.0, compiler target, and file suffix."""

    fmi2: str
    target: str
    suffix: str


PLATFORMS = {
    "x86_64-linux": BinaryPlatform("linux64", "x86_64-linux-gnu.2.17", ".so"),
    "aarch64-linux": BinaryPlatform("aarch64-linux", "aarch64-linux-gnu.2.17", ".so"),
    "x86_64-windows": BinaryPlatform("win64", "x86_64-windows-gnu", ".dll"),
    "x86_64-darwin": BinaryPlatform("darwin64", "x86_64-macos", ".dylib"),
    "aarch64-darwin": BinaryPlatform("aarch64-darwin", "aarch64-macos", ".dylib"),
}
"""Platforms by their names in FMI 3.0."""


def this_platform() -> str:
    """Return the name of the current platform in FMI 3.0.

    >>> this_platform().count("-")
    1
    """
    kind = {"amd64": "x86_64", "x86_64": "x86_64", "arm64": "aarch64", "aarch64": "aarch64"}
    name = machine.machine().lower()
    return f"{kind.get(name, name)}-{machine.system().lower()}"
