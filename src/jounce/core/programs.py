"""Find external programs in the folders of PATH, never in the current folder."""

from __future__ import annotations

import os
import sys
from pathlib import Path


def program_on_path(name: str) -> str | None:
    """Find a program in the absolute folders of PATH; None if it is missing.

    Unlike ``shutil.which`` it searches neither the current folder, which Windows searches first, nor relative folders
    in PATH: an unpacked archive may contain a program of that name.

    Examples
    --------
    >>> program_on_path("no-such-program") is None
    True
    """
    suffixes = (
        os.environ.get("PATHEXT", ".EXE").split(os.pathsep) if sys.platform == "win32" else [""]
    )
    for folder in os.environ.get("PATH", os.defpath).split(os.pathsep):
        for suffix in suffixes:
            file = Path(folder.strip('"')) / f"{name}{suffix}"
            if file.is_absolute() and file.is_file() and os.access(file, os.X_OK):
                return str(file)
    return None
