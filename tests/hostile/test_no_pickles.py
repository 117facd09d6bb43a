"""No file is unpickled that others could have put there."""

import subprocess
import sys

_ALL_OF_PINT = "from jounce.core.units import to_si; print(to_si('1 slug/furlong', 'kg/m'))"


def test_the_library_of_units_neither_keeps_nor_reads_pickles(tmp_path, monkeypatch):
    """pint's cache is a folder of pickles below XDG_CACHE_HOME; whoever writes there ran code in every command."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    ended = subprocess.run(
        [sys.executable, "-c", _ALL_OF_PINT], capture_output=True, text=True, timeout=60, check=True
    )
    assert ended.stdout.startswith("0.0725")
    assert not [file for file in tmp_path.rglob("*") if file.is_file()]
