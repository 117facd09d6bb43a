"""Limits that come with jounce, by name and file: known without loading them."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

SHIPPED = "jounce"
"""The name by which they are asked for."""


def shipped_limits() -> Path:
    """Give the file of the limits that come with jounce, to be copied and changed."""
    return Path(str(resources.files("jounce.inspection") / "limits.toml"))
