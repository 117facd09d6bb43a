"""Name and file of the shipped limits, available without loading them."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

SHIPPED = "jounce"
"""Name of the shipped limits."""


def shipped_limits() -> Path:
    """Return the path of the shipped limits file, a template for custom limits."""
    return Path(str(resources.files("jounce.inspection") / "limits.toml"))
