"""A measured file by others: magneto-rheological damper, MIT licence, see tests/files/mr_damper_labcontrol."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat

from jounce.recordings import check_recording, read_columns, read_recording

pytestmark = pytest.mark.source(
    kind="measured",
    of="signals and identification",
    key="vargas-mr-damper",
    where="ensaio.A.1.mat",
    tolerance="the digits of the file",
)

FILE = Path(__file__).parents[1] / "files" / "mr_damper_labcontrol" / "ensaio.A.1.mat"
HEADER = "displacement [mm], velocity [mm/s], force [N]"


def test_columns_in_si() -> None:
    raw = loadmat(FILE)["x_F"]
    wanted = {"displacement": "m", "velocity": "m/s", "force": "N"}
    values, findings = read_columns(FILE, wanted, columns=HEADER, variable="x_F")
    assert findings == []
    for column, (name, scale) in enumerate(
        (("displacement", 1e-3), ("velocity", 1e-3), ("force", 1.0))
    ):
        np.testing.assert_allclose(values[name], raw[:, column] * scale, rtol=1e-14, atol=0.0)
    assert values["force"].max() == pytest.approx(1013.5, abs=0.1)


def test_recording_with_its_own_clock_or_a_given_step() -> None:
    mapped = {
        "time": "Tout [s]",
        "strut.deflection": "x_F(:,1) [mm]",
        "strut.force": "x_F(:,3) [N]",
    }
    clocked, _ = read_recording(FILE, columns=mapped)
    stepped, _ = read_recording(FILE, columns=HEADER, variable="x_F", sample_time="10 ms")
    check_recording(clocked)
    assert clocked.sizes["time"] == 1501
    np.testing.assert_allclose(
        np.diff(clocked["time"]), 0.01, rtol=1e-9
    )  # 100 Hz, as its authors say
    np.testing.assert_array_equal(clocked["strut.force"], stepped["force"])
