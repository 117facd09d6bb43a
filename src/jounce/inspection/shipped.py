"""Shipped limits, by name and file: listed without loading them."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

SHIPPED = "jounce"
"""The name by which they are asked for."""


def shipped_limits() -> Path:
    """Return the file of the shipped limits, to be copied and changed."""
    return Path(str(resources.files("jounce.inspection") / "limits.toml"))
