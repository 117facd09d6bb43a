from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import jounce as jn

RIG = jn.load("reference-double-wishbone")


@pytest.fixture(scope="module")
def sweep() -> xr.Dataset:
    return jn.sweep_travel(RIG, [-0.02, 0.0, 0.02], rack=[-0.005, 0.005])


def test_netcdf_gives_everything_back(sweep: xr.Dataset, tmp_path: Path) -> None:
    file = jn.write_sweep(sweep, tmp_path / "sweep.nc")
    with xr.open_dataset(file, engine="h5netcdf") as read:
        xr.testing.assert_identical(read.drop_attrs(), sweep.drop_attrs())
        assert read["camber"].attrs == sweep["camber"].attrs
        assert read.attrs["status"] == "completed"


def test_csv_has_one_row_a_pose(sweep: xr.Dataset, tmp_path: Path) -> None:
    header, *rows = (
        jn.write_sweep(sweep, tmp_path / "sweep.csv").read_text(encoding="utf-8").splitlines()
    )
    names = [name.strip() for name in header.split(",")]
    assert names[:2] == ["wheel_travel [m]", "rack_travel [m]"]
    table = np.array([[float(cell) for cell in row.split(",")] for row in rows])
    assert table.shape == (6, len(names))
    camber = table[:, names.index("camber [rad]")].reshape(3, 2)
    assert np.array_equal(camber, sweep["camber"])
    assert np.array_equal(table[:, 1].reshape(3, 2)[0], [-0.005, 0.005])


def test_values_at_infinity_stay_empty(tmp_path: Path) -> None:
    """A wheel that does not lean has its front instant centre at infinity."""
    arm = jn.load("semi-trailing-arm")
    outer, inner = arm.hardpoints.arm_outer, arm.hardpoints.arm_inner
    arm = arm.with_changes(
        {"hardpoints.arm_inner": [outer[0], inner[1], outer[2]], "wheel.camber": 0.0}
    )
    found = jn.sweep_travel(arm, [0.0, 0.01])
    assert not np.any(np.isfinite(found["instant_centre_y"]))
    header, first, *_ = (
        jn.write_sweep(found, tmp_path / "arm.csv").read_text(encoding="utf-8").splitlines()
    )
    assert first.split(",")[header.split(",").index("instant_centre_y [m]")] == ""


def test_files_are_not_overwritten_unasked(sweep: xr.Dataset, tmp_path: Path) -> None:
    file = tmp_path / "sweep.csv"
    file.write_text("mine", encoding="utf-8")
    with pytest.raises(jn.OutputError, match="exists"):
        jn.write_sweep(sweep, file)
    assert file.read_text(encoding="utf-8") == "mine"
    jn.write_sweep(sweep, file, force=True)
    assert file.read_text(encoding="utf-8") != "mine"
    with pytest.raises(jn.OutputError, match="not written in this format"):
        jn.write_sweep(sweep, tmp_path / "sweep.xlsx")
    with pytest.raises(jn.OutputError, match="folder"):
        jn.write_sweep(sweep, tmp_path / "missing" / "sweep.nc")
