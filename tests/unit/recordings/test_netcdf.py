"""netCDF as other libraries write it: text of every kind, groups, dimensions, instants, gaps, and netCDF-3 by hand."""

from __future__ import annotations

import struct
from contextlib import suppress
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest
from scipy.io import netcdf_file

from jounce.core.errors import RecordingError
from jounce.recordings import read_recording

TIME = np.arange(50) * 0.01
WAVE = np.sin(9.0 * TIME)


def written(file: Path, unit: Any = "m/s^2", place: str = "", **attributes: Any) -> Path:
    """A netCDF-4 file made with HDF5, whose attributes are stored as h5py is told."""
    with h5py.File(file, "w") as whole:
        group = whole.require_group(place) if place else whole
        for name, values, own in (("time", TIME, "s"), ("sprung.az", WAVE, unit)):
            one = group.create_dataset(name, data=values)
            one.attrs["units"] = own
        group["time"].make_scale("time")
        group["sprung.az"].dims[0].attach_scale(group["time"])
        for name, value in attributes.items():
            whole.attrs[name] = value
    return file


TEXT, STRING = "m/s²", h5py.string_dtype()
UNITS = {
    "text": TEXT,
    "bytes": np.bytes_(TEXT.encode()),
    "Latin-1": np.bytes_(TEXT.encode("latin-1")),
    "closed by a zero": np.bytes_(TEXT.encode() + b"\0\0"),
    "a list of one": np.array([TEXT], dtype=STRING),
    "a list of one of fixed length": np.array([TEXT.encode()]),
    "a matrix of one": np.array([[TEXT]], dtype=STRING),
}


@pytest.mark.parametrize("kind", UNITS)
def test_a_unit_is_read_however_its_text_is_stored(tmp_path: Path, kind: str) -> None:
    run, findings = read_recording(written(tmp_path / "a.nc", UNITS[kind]))
    np.testing.assert_array_equal(run["sprung.az"], WAVE)
    assert findings == []


def test_attributes_are_plain(tmp_path: Path) -> None:
    told = {
        "title": np.bytes_(b"run 3"),
        "nothing": h5py.Empty("S1"),
        "empty": "",
        "speed": np.array([1.95]),
        "list": np.array([1, 2]),
        "names": np.array(["a", "b"], dtype=STRING),
    }
    found = read_recording(written(tmp_path / "a.nc", **told))[0].attrs
    assert {name: found[name] for name in ("title", "nothing", "empty", "speed")} == {
        "title": "run 3",
        "nothing": "",
        "empty": "",
        "speed": 1.95,
    }
    assert list(found["list"]) == [1, 2]
    assert list(found["names"]) == ["a", "b"]


def test_the_group_with_signals_is_read_and_of_several_the_chosen_one(tmp_path: Path) -> None:
    file = written(tmp_path / "a.nc", place="bench/run")
    assert read_recording(file)[0]["sprung.az"].equals(
        read_recording(file, variable="bench/run")[0]["sprung.az"]
    )
    with h5py.File(file, "a") as whole:
        whole.copy("bench", "again")
    with pytest.raises(
        RecordingError, match=r"several groups contain signals; found 'again/run, bench/run'"
    ):
        read_recording(file)
    with pytest.raises(
        RecordingError, match=r"no group 'bench/rnu' with signals; .*Did you mean 'bench/run'"
    ):
        read_recording(file, variable="bench/rnu")
    assert read_recording(file, variable="again/run")[0].sizes["time"] == 50


def classic(file: Path, *, records: bool = False, **more: Any) -> Path:
    """A netCDF-3 file written by SciPy."""
    with netcdf_file(file, "w", **more) as whole:
        whole.createDimension("time", None if records else TIME.size)
        whole.createDimension("of_nothing", 1_000_000)
        for name, values, unit in (
            ("time", TIME, "s"),
            ("sprung.az", WAVE, "m/s^2"),
            ("short", TIME, "cm"),
        ):
            one = whole.createVariable(name, "h" if name == "short" else "d", ("time",))
            one.units, one[:] = unit, np.round(100 * values) if name == "short" else values
    return file


@pytest.mark.parametrize("records", [False, True])
@pytest.mark.parametrize("version", [1, 2])
def test_netcdf_3_is_read_in_every_layout(tmp_path: Path, records: bool, version: int) -> None:
    file = classic(tmp_path / "a.nc", records=records, version=version)
    run, _ = read_recording(file, columns={"body.travel": "short"})
    np.testing.assert_array_equal(run["time"], TIME)
    np.testing.assert_array_equal(run["sprung.az"], WAVE)
    np.testing.assert_allclose(run["body.travel"], TIME, rtol=0.0, atol=1e-15)
    if records:  # a stream does not tell how many there are
        content = file.read_bytes()
        file.write_bytes(content[:4] + b"\xff" * 4 + content[8:])
        assert read_recording(file)[0].equals(run.drop_vars("body.travel"))


@pytest.mark.parametrize("records", [False, True])
def test_a_netcdf_3_file_that_was_cut_off_or_grew_is_told(tmp_path: Path, records: bool) -> None:
    content = classic(tmp_path / "a.nc", records=records).read_bytes()
    file = tmp_path / "b.nc"
    for size in range(4, len(content) - 4, 37):
        file.write_bytes(content[:size])
        with suppress(RecordingError):
            _, findings = read_recording(file)
            assert [one.severity for one in findings if "declares" in one.message], size
    file.write_bytes(content + b"rest of another file")
    _, (finding, *_) = read_recording(file)
    assert (finding.severity, finding.value) == ("warning", 20.0)


def test_netcdf_3_variables_that_lie_over_each_other_are_refused(tmp_path: Path) -> None:
    file = classic(tmp_path / "a.nc", version=1)
    content = bytearray(file.read_bytes())
    at = content.index(b"sprung.az")
    place = (
        content.index(struct.pack(">ii", 6, 8 * TIME.size), at) + 8
    )  # behind kind and size: where it begins
    content[place : place + 4] = struct.pack(
        ">i", struct.unpack(">i", content[place : place + 4])[0] - 8
    )
    file.write_bytes(content)
    with pytest.raises(
        RecordingError, match=r"a\.nc: not a netCDF file, or damaged \(variables overlap\)"
    ):
        read_recording(file)


def test_what_the_library_puts_where_nothing_was_written_is_a_gap(tmp_path: Path) -> None:
    file = classic(tmp_path / "a.nc")
    with netcdf_file(file, "a", mmap=False) as whole:
        whole.variables["sprung.az"][7] = 9.9692099683868690e36
    with pytest.raises(RecordingError, match=r"sprung\.az: not a finite number at row 8"):
        read_recording(file)


@pytest.mark.parametrize(
    ("unit", "scale"),
    [
        ("seconds since 1970-01-01", 1.0),
        ("milliseconds since 2026-11-28 12:00:00.5 +01:00", 1e3),
        ("days since 1900-1-1", 1 / 86400),
    ],
)
def test_a_time_since_an_instant_begins_at_zero(tmp_path: Path, unit: str, scale: float) -> None:
    file = tmp_path / "a.nc"
    with netcdf_file(file, "w") as whole:
        whole.createDimension("n", TIME.size)
        for name, values, own in (("time", 4e4 + scale * TIME, unit), ("sprung.az", WAVE, "m/s2")):
            one = whole.createVariable(name, "d", ("n",))
            one.units, one[:] = own, values
    run, findings = read_recording(file)
    np.testing.assert_allclose(run["time"], TIME, rtol=0.0, atol=2e-6)
    assert [one.message for one in findings if "clock" in one.message] == [
        f"'time' is a clock: {unit}"
    ]
