"""What PyInstaller is told of jounce: which files it needs, and what its child processes do in a frozen application.

PyInstaller asks by itself wherever jounce is installed (entry point ``pyinstaller40``).
"""

from __future__ import annotations

from pathlib import Path


def hook_folders() -> list[str]:
    """Give the folders with hooks for PyInstaller."""
    return [str(Path(__file__).parent / "hooks")]
