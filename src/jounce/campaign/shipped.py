"""Shipped truths, by name and file: listed without loading them."""

from __future__ import annotations

from pathlib import Path

from jounce.core.files import shipped_files


def truth_library() -> dict[str, Path]:
    """Shipped truths: name to file."""
    return shipped_files("jounce.campaign", "library")
