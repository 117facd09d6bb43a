"""Instructions for PyInstaller: the files that jounce needs, and the child processes of a frozen application.

PyInstaller finds them automatically if jounce is installed (entry point ``pyinstaller40``).
"""

from __future__ import annotations

from pathlib import Path


def hook_folders() -> list[str]:
    """Return the folders with hooks for PyInstaller."""
    return [str(Path(__file__).parent / "hooks")]
