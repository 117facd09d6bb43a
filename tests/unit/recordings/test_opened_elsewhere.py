"""What jounce writes is opened by other programs, as `tests/files/foreign/check.py` opens it: names, units and values.

Here by those that are there; by all of them where that script is run by hand.
"""

from __future__ import annotations

import shutil
import sys
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

import pytest

from jounce.recordings import recording, write_recording

FOREIGN = Path(__file__).parents[2] / "files" / "foreign"
sys.path.insert(0, str(FOREIGN))
check, make = import_module("check"), import_module("make")
sys.path.remove(str(FOREIGN))

OPENERS = [
    pytest.param(
        library,
        rest,
        marks=pytest.mark.slow if library in make.PROGRAMS else (),
        id=f"{library} {rest}",
    )
    for library, rest in check.OPENERS
    if (shutil.which(make.PROGRAMS[library][0]) if library in make.PROGRAMS else find_spec(library))
]


def test_enough_of_them_are_here() -> None:
    assert {"h5py", "pandas", "pyarrow", "scipy", "asammdf", "numpy", "xarray"} <= {
        one.values[0] for one in OPENERS
    }


@pytest.mark.parametrize(("library", "rest"), OPENERS)
def test_other_programs_read_what_is_written(library: str, rest: str, tmp_path: Path) -> None:
    texts = {"sprung.az": "vertical acceleration, Größe", "strut.force": ""}
    channels = {name: (values, unit, texts[name]) for name, (values, unit) in make.CHANNELS.items()}
    run = recording(
        make.TIME, channels, attributes={"made_by": "bench 3, Prüfstand", "speed": 1.95}
    )
    suffix, _, engine = rest.partition(" ")
    if engine in ("netcdf4", "calamine"):
        pytest.importorskip({"netcdf4": "netCDF4", "calamine": "python_calamine"}[engine])
    file = write_recording(run, tmp_path / f"run{suffix}")
    try:
        opened = check.OPENERS[library, rest](file)
    except ImportError as refused:  # pandas wants a newer openpyxl than jounce does
        pytest.skip(str(refused))
    assert check.differing(opened) == ""
