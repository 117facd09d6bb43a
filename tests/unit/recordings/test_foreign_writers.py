"""Files that other libraries and programs wrote (`tests/files/foreign`) are read whole: names, units and values."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from jounce.core.errors import RecordingError
from jounce.recordings import read_recording

FOREIGN = Path(__file__).parents[2] / "files" / "foreign"
FILES = sorted(
    file for file in FOREIGN.iterdir() if file.is_file() and file.suffix not in (".py", ".md")
)
TIME = np.arange(40) / 100.0
TRUTH = {
    "sprung.az": (np.round(2.0 * np.sin(9.0 * TIME), 6), "m/s^2"),
    "strut.force": (np.round(200.0 + 50.0 * np.cos(9.0 * TIME), 4), "N"),
}

PRECISION = {"float.rsp": 6e-8, "int.rsp": 0.501 / 32752}
"""Of the largest number, where a format does not store doubles."""


def options(file: Path) -> dict[str, Any]:
    """What only the user knows: a matrix has no units, a universal file names of up to ten letters."""
    if file.suffix == ".mat":
        return {"columns": {"time": "t [s]", "sprung.az": "az [m/s^2]", "strut.force": "F [N]"}}
    return {"columns": {"strut.force": "strut.forc"}} if file.suffix == ".uff" else {}


@pytest.mark.parametrize(
    "begin", [b"# Created by Octave 7.3.0, Sat Nov 28", b"Octave-1-L\0\1", b"\x89HDF\r\n\x1a\n"]
)
def test_a_mat_file_in_a_format_of_octave_is_refused_with_what_to_do(
    tmp_path: Path, begin: bytes
) -> None:
    (tmp_path / "a.mat").write_bytes(begin + bytes(200))
    with pytest.raises(
        RecordingError, match=r"a\.mat: a file in an Octave or HDF5 format.*save -v7 FILE\.mat"
    ):
        read_recording(tmp_path / "a.mat")


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.name)
def test_a_file_of_another_program_is_read_whole(file: Path) -> None:
    run, findings = read_recording(file, **options(file))
    assert {name: one.attrs["units"] for name, one in run.data_vars.items()} == {
        name: unit for name, (_, unit) in TRUTH.items()
    }
    np.testing.assert_allclose(run["time"], TIME, rtol=0.0, atol=1e-9)
    for name, (values, _) in TRUTH.items():
        within = PRECISION.get(file.name.rpartition("-")[2], 1e-9) * np.abs(values).max()
        np.testing.assert_allclose(run[name], values, rtol=0.0, atol=within)
    assert [str(one) for one in findings if one.severity != "note"] == []
