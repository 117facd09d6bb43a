from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from jounce.core.errors import OutputError, RecordingError
from jounce.recordings import read_recording, recording, to_pandas, write_recording

RUN = recording(np.arange(9) * 0.1, {"sprung.z": (np.arange(9.0) ** 2, "m", "")})


@pytest.mark.parametrize("suffix", [".nc", ".csv"])
def test_existing_file_needs_force(tmp_path: Path, suffix: str) -> None:
    file = tmp_path / f"run{suffix}"
    file.write_text("precious")
    with pytest.raises(OutputError, match=r"the output already exists.*--force"):
        write_recording(RUN, file)
    assert file.read_text() == "precious"
    assert write_recording(RUN, file, force=True) == file
    assert read_recording(file)[0].equals(RUN)


def test_missing_folder_and_unknown_format(tmp_path: Path) -> None:
    with pytest.raises(OutputError, match="output folder does not exist"):
        write_recording(RUN, tmp_path / "none" / "run.nc")
    with pytest.raises(
        OutputError, match=r"not written in this format; found '\.txt'; allowed: \.nc, \.csv"
    ):
        write_recording(RUN, tmp_path / "run.txt")


def test_a_table_of_pandas_is_of_one_dimension() -> None:
    frame = to_pandas(RUN.assign_coords(place=3.0).assign(mass=2.0))
    assert (frame.index.name, list(frame)) == ("time [s]", ["sprung.z [m]"])
    assert frame.loc[0.2, "sprung.z [m]"] == 4.0
    for dataset, found in ((RUN.expand_dims("trial"), "trial, time"), (RUN.isel(time=0), "none")):
        with pytest.raises(
            RecordingError, match=f"dataset: not a table; found 'dimensions {found}'"
        ):
            to_pandas(dataset)


def test_failure_leaves_nothing(tmp_path: Path) -> None:
    bad = RUN.assign({"sprung.az": ("time", np.array([{}] * 9, dtype=object))})
    with pytest.raises(Exception, match=r"object|dtype|type"):
        write_recording(bad, tmp_path / "run.nc")
    assert list(tmp_path.iterdir()) == []


def test_csv_is_readable_text(tmp_path: Path) -> None:
    lines = write_recording(RUN, tmp_path / "run.csv").read_text().splitlines()
    assert lines[:3] == ["time [s],sprung.z [m]", "0.0,0.0", "0.1,1.0"]
