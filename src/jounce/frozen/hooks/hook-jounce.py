"""Hook for PyInstaller: modules imported by name, data files, and sources for checking compiled code."""

from __future__ import annotations

import re
from importlib.metadata import metadata
from importlib.util import find_spec
from pathlib import Path

from PyInstaller.utils.hooks import collect_data_files, collect_submodules, copy_metadata

_NOT_RUN = ("jounce.frozen", "jounce.kernel.loops.")

datas = [
    *collect_data_files("jounce", include_py_files=True),
    *copy_metadata("jounce", recursive=True),
]
hiddenimports = collect_submodules("jounce", lambda name: not name.startswith(_NOT_RUN))
# Packages of extras are also imported by name: include those installed in the build environment.
_extras = "|".join({*(metadata("jounce").get_all("Provides-Extra") or ())} - {"loops"})
_asked = re.compile(rf'\("(\w+)[\w.]*", "(?:{_extras})"\)')
_sources = [file.read_text(encoding="utf-8") for file in Path(__file__).parents[2].rglob("*.py")]
hiddenimports += sorted(
    {name for text in _sources for name in _asked.findall(text) if find_spec(name)}
)
excludedimports = [
    "IPython",
    "numba",
]  # IPython is only used inside notebooks, and the loops are precompiled
