"""Truths that come with jounce, by name and file: known without loading them."""

from __future__ import annotations

from pathlib import Path

from jounce.core.files import shipped_files


def truth_library() -> dict[str, Path]:
    """Truths that come with jounce: name to file."""
    return shipped_files("jounce.campaign", "library")
