from __future__ import annotations

import re
import signal
from pathlib import Path
from types import SimpleNamespace

import h5py
import numpy as np
import pytest
from scipy.io import savemat

from jounce.core.columns import Column, ColumnTable
from jounce.core.errors import DescriptionError, RecordingError
from jounce.recordings import (
    READERS,
    check_recording,
    isolated,
    read_columns,
    read_recording,
    readers,
    recording,
    write_recording,
)

TIME = np.arange(40) * 0.001
WAVE = np.sin(TIME * 200.0)


def write(path: Path, header: str, *columns: np.ndarray, separator: str = ",") -> Path:
    rows = [separator.join(repr(float(v)) for v in row) for row in zip(*columns, strict=True)]
    path.write_text("\n".join([header, *rows]) + "\n")
    return path


def test_units_and_order_do_not_matter(tmp_path: Path) -> None:
    file = write(
        tmp_path / "a.csv",
        "unsprung.az [g]; time [ms]; strut.deflection [mm]; tyre.force [kN]; road.slope",
        WAVE,
        TIME * 1e3,
        WAVE * 10.0,
        WAVE + 0.2,
        WAVE / 7.0,
        separator=";",
    )
    run, findings = read_recording(file)
    check_recording(run)
    assert findings == []
    np.testing.assert_allclose(run["unsprung.az"], WAVE * 9.80665, rtol=1e-14)
    np.testing.assert_allclose(run["strut.deflection"], WAVE * 0.01, rtol=1e-14)
    np.testing.assert_allclose(run["tyre.force"], (WAVE + 0.2) * 1e3, rtol=1e-14)
    np.testing.assert_array_equal(run["road.slope"], WAVE / 7.0)  # a plain number needs no unit
    np.testing.assert_allclose(run["time"], TIME, rtol=0.0, atol=1e-15)


def test_mapping_by_name_and_by_unit(tmp_path: Path) -> None:
    file = write(
        tmp_path / "a.csv", "t, AccBody [g], F_kN, temperature_1 [K]", TIME, WAVE, WAVE, WAVE
    )
    columns = {"time": "t [s]", "sprung.az": "AccBody", "strut.force": "F_kN [kN]"}
    run, findings = read_recording(file, columns=columns)
    assert sorted(run.data_vars) == ["sprung.az", "strut.force"]
    np.testing.assert_allclose(run["strut.force"], WAVE * 1e3, rtol=1e-14)
    (finding,) = findings
    assert finding.severity == "note"
    assert "temperature_1 [K]" in finding.message


def test_all_columns_renamed_in_order(tmp_path: Path) -> None:
    file = write(tmp_path / "a.csv", "a, b", TIME, WAVE)
    run, _ = read_recording(file, columns="time [s], sprung.az [m/s^2]")
    np.testing.assert_array_equal(run["sprung.az"], WAVE)
    with pytest.raises(RecordingError, match=r"names 1 columns, but the file has 2.*found 'a, b'"):
        read_recording(file, columns="time [s]")


@pytest.mark.parametrize(
    ("header", "columns", "error", "message"),
    [
        (
            "u [s], sprung.az [g]",
            None,
            RecordingError,
            "no column 'time'; found 'u .s., sprung.az .g.'.*Map the time column",
        ),
        (
            "time [s], sprung.az",
            None,
            RecordingError,
            "column 'sprung.az': the column has no unit.*sprung.az .m/s.2.",
        ),
        ("time, sprung.az [g]", None, RecordingError, "column 'time': the column has no unit"),
        (
            "time [s], sprung.az [mm]",
            None,
            DescriptionError,
            "column 'sprung.az .mm.': wrong unit; found 'mm'",
        ),
        (
            "time [mm], sprung.az [g]",
            None,
            DescriptionError,
            "wrong unit; found 'mm'; allowed: a unit that.*to s",
        ),
        ("time [s], a [g]", None, RecordingError, "no channel was found"),
        ("time [s], a [g]", {"sprung.az": "b"}, RecordingError, "no column 'b'"),
        (
            "time [s], AccBody [g]",
            {"sprung.az": "AccBdy"},
            RecordingError,
            "Did you mean 'AccBody'",
        ),
        (
            "time [s], a [g]",
            {"sprung.foo": "a"},
            RecordingError,
            "not a known quantity; found 'foo'",
        ),
        (
            "time [s], a [g]",
            {"sprung.az": "a [m/s^2]"},
            RecordingError,
            "a different unit; found 'g'; allowed: m/s.2",
        ),
    ],
)
def test_bad_columns(
    tmp_path: Path,
    header: str,
    columns: dict[str, str] | None,
    error: type[Exception],
    message: str,
) -> None:
    file = write(tmp_path / "a.csv", header, TIME, WAVE)
    with pytest.raises(error, match=message):
        read_recording(file, columns=columns)


def test_bad_rows_are_named_by_their_line(tmp_path: Path) -> None:
    time = TIME.copy()
    time[4] = time[3]
    file = write(tmp_path / "a.csv", "# made by hand\n\ntime [s], sprung.az [g]", time, WAVE)
    with pytest.raises(RecordingError, match=r"a\.csv: time: time does not increase at line 8"):
        read_recording(file)


def test_bad_files(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match="no such file"):
        read_recording(tmp_path / "none.csv")
    with pytest.raises(RecordingError, match="a folder, not a file"):
        read_recording(tmp_path)
    for reader in READERS:
        file = tmp_path / f"empty{reader.suffixes[0]}"
        file.write_bytes(b"")
        with pytest.raises(RecordingError, match="the file is empty"):
            read_recording(file)
    other = tmp_path / "a.xyz"
    other.write_text("1")
    with pytest.raises(
        RecordingError, match=r"not belong to a known format; found '\.xyz'; allowed: .*\.csv"
    ):
        read_recording(other)
    for suffix in (".nc", ".mat"):
        broken = tmp_path / f"broken{suffix}"
        broken.write_bytes(b"this is neither one nor the other" * 20)
        with pytest.raises(RecordingError, match=r"broken\.\w+: not a"):
            read_recording(broken)


def test_small_jitter_is_resampled(tmp_path: Path) -> None:
    jittered = TIME + 4e-6 * np.sin(TIME * 3000.0) * np.sign(TIME * (TIME[-1] - TIME))
    file = write(
        tmp_path / "a.csv", "time [s], sprung.az [m/s^2]", jittered, np.sin(jittered * 200.0)
    )
    run, findings = read_recording(file)
    assert "resampled" in findings[0].message
    np.testing.assert_allclose(
        run["sprung.az"], WAVE, rtol=0.0, atol=2e-5
    )  # the shift itself would be 8e-4
    np.testing.assert_allclose(np.diff(run["time"]), 0.001, rtol=1e-9)


def test_sample_time_instead_of_a_time_column(tmp_path: Path) -> None:
    file = write(tmp_path / "a.csv", "sprung.az [g], unsprung.az [g]", WAVE, WAVE)
    run, findings = read_recording(file, sample_time="2 ms")
    assert float(run["time"][-1]) == pytest.approx(39 * 0.002, rel=1e-14)
    assert findings == []
    with pytest.raises(RecordingError, match="not positive"):
        read_recording(file, sample_time=0.0)
    with pytest.raises(DescriptionError, match="unit is missing"):
        read_recording(file, sample_time="2")
    with pytest.raises(RecordingError, match="too few"):
        read_recording(write(tmp_path / "b.csv", "sprung.az [g]", WAVE[:3]), sample_time="2 ms")


def test_columns_without_time(tmp_path: Path) -> None:
    file = write(tmp_path / "a.csv", "force [kN], travel_mm", WAVE, WAVE)
    wanted = {"displacement": "m", "force": "N"}
    values, findings = read_columns(file, wanted, columns={"displacement": "travel_mm [mm]"})
    assert list(values) == ["displacement", "force"]
    np.testing.assert_allclose(values["displacement"], WAVE * 1e-3, rtol=1e-14)
    assert findings == []
    with pytest.raises(RecordingError, match="no column 'displacement'"):
        read_columns(file, wanted)
    with pytest.raises(RecordingError, match=r"columns names 'forse'.*Did you mean 'force'"):
        read_columns(file, wanted, columns={"forse": "force"})
    constant = write(tmp_path / "b.csv", "force [kN], displacement [mm]", WAVE, WAVE * 0.0)
    assert "constant" in read_columns(constant, wanted)[1][0].message


@pytest.mark.parametrize("suffix", [".nc", ".csv"])
def test_written_recordings_come_back(tmp_path: Path, suffix: str) -> None:
    run = recording(
        TIME,
        {
            "sprung.az": (WAVE / 3.0, "m/s^2", ""),
            "road.slope": (WAVE / 7.0, "1", ""),
            "pitch": (WAVE, "rad", "nod"),
        },
        attributes={"source": "test", "speed": 1.95, "ok": True, "list": [1, 2], "none": None},
    )
    file = write_recording(run, tmp_path / f"run{suffix}")
    back, findings = read_recording(file)
    assert findings == []
    assert back.equals(run)
    assert [path.name for path in tmp_path.iterdir()] == [file.name]  # no temporary file is left
    if suffix == ".nc":
        assert back["pitch"].attrs == run["pitch"].attrs
        assert {k: back.attrs[k] for k in ("source", "speed", "ok")} == {
            "source": "test",
            "speed": 1.95,
            "ok": "true",
        }
    assert run.attrs["ok"] is True  # the caller's recording is untouched


def test_netcdf_of_others(tmp_path: Path) -> None:
    run = recording(TIME * 1e3, {"sprung.az": (WAVE, "g", "")}).assign(mass=16.0)
    run["time"].attrs["units"] = "ms"
    run.to_netcdf(tmp_path / "a.nc", engine="h5netcdf")
    back, findings = read_recording(tmp_path / "a.nc")
    np.testing.assert_allclose(back["sprung.az"], WAVE * 9.80665, rtol=1e-14)
    assert float(back["time"][-1]) == pytest.approx(0.039, rel=1e-12)
    assert "mass" in findings[0].message
    run.rename(time="t").to_netcdf(tmp_path / "b.nc", engine="h5netcdf")
    other, findings = read_recording(tmp_path / "b.nc")
    assert other["sprung.az"].equals(back["sprung.az"])
    assert "'t [ms]' is used as the time" in [one.message for one in findings]
    run["sprung.az"] = run["sprung.az"].where(run["time"] != run["time"][5])
    run.to_netcdf(tmp_path / "c.nc", engine="h5netcdf")
    with pytest.raises(RecordingError, match=r"sprung\.az: not a finite number at row 6"):
        read_recording(tmp_path / "c.nc")


def test_matlab_version_5(tmp_path: Path) -> None:
    file = tmp_path / "a.mat"
    content = {
        "x_F": np.stack((WAVE, WAVE * 2.0, WAVE * 3.0), axis=1),
        "Tout": TIME[None, :],
        "Ts": 0.001,
        "n": "text",
    }
    savemat(file, content)
    columns = {
        "time": "Tout [s]",
        "strut.deflection": "x_F(:,1) [mm]",
        "strut.force": "x_F(:,3) [N]",
    }
    run, findings = read_recording(file, columns=columns)
    np.testing.assert_allclose(run["strut.deflection"], WAVE * 1e-3, rtol=1e-14)
    np.testing.assert_allclose(run["strut.force"], WAVE * 3.0, rtol=1e-14)
    assert "x_F(:,2)" in findings[0].message
    header = "displacement [mm], velocity [mm/s], force [N]"
    for variable in ("x_F", ""):
        values, _ = read_columns(
            file, {"force": "N", "velocity": "m/s"}, columns=header, variable=variable
        )
        np.testing.assert_allclose(values["velocity"], WAVE * 2e-3, rtol=1e-14)
    with pytest.raises(
        RecordingError,
        match=r"no numeric variable 'x_f'; found '.*x_F \(40 x 3\).*Did you mean 'x_F'",
    ):
        read_columns(file, {"force": "N"}, columns=header, variable="x_f")
    with pytest.raises(RecordingError, match=r"names 2 columns, but 'x_F' has"):
        read_columns(file, {"force": "N"}, columns="a [m], b [N]", variable="x_F")
    with pytest.raises(
        RecordingError, match=r"0 variables have as many columns as the given header \(2\)"
    ):
        read_columns(file, {"force": "N"}, columns="a [m], force [N]")
    for given in (
        "force [N]",
        "force",
    ):  # a header of one name is for the one vector, not for a number or a matrix
        content = {"a": 3.0, "b": WAVE[:, None], "c": np.stack((WAVE, WAVE), axis=1)}
        savemat(file, content)
        values, _ = read_columns(file, {"force": "N"}, columns="force [N]")
        np.testing.assert_array_equal(values["force"], WAVE)
        savemat(file, content | {"d": WAVE})
        with pytest.raises(
            RecordingError,
            match=r"2 variables have as many.*\(1\); found 'b \(40 x 1\), c \(40 x 2\), d",
        ):
            read_columns(file, {"force": "N"}, columns=given)
    savemat(
        file,
        {"t": TIME, "az": WAVE, "long": np.arange(50.0), "wide": np.zeros((40, 65)), "one": 1.0},
    )
    run, findings = read_recording(file, columns={"time": "t [s]", "sprung.az": "az [g]"})
    assert run.sizes["time"] == 40
    assert "left out: long" in findings[-1].message
    assert "wide" not in " ".join(one.message for one in findings)
    savemat(file, {"wide": np.stack([WAVE] * 65, axis=1)})
    named = ", ".join(f"c{i} [N]" for i in range(64)) + ", force [N]"
    np.testing.assert_array_equal(
        read_columns(file, {"force": "N"}, columns=named)[0]["force"], WAVE
    )
    savemat(
        file, {"a": TIME[:30], "b": WAVE[:30], "c": WAVE, "d": TIME}
    )  # as many of each: the longer ones
    assert read_columns(file, {"force": "N"}, columns={"force": "c [N]"})[0]["force"].size == 40
    savemat(file, {"a": "only text"})
    with pytest.raises(RecordingError, match="no numeric variable"):
        read_recording(file)


def test_matlab_version_7_3(tmp_path: Path) -> None:
    file = tmp_path / "a.mat"
    with h5py.File(
        file, "w", userblock_size=512
    ) as content:  # a version 7.3 file is HDF5 behind a MATLAB header
        for name, values in {"x_F": np.stack((TIME, WAVE), axis=0), "t": TIME[:, None]}.items():
            content[name] = values
            content[name].attrs["MATLAB_class"] = np.bytes_("double")
        content["remark"] = np.array([[104], [105]], dtype=np.uint16)
        content["remark"].attrs["MATLAB_class"] = np.bytes_("char")
    header = b"MATLAB 7.3 MAT-file".ljust(124) + b"\x00\x02IM"
    file.write_bytes(header + file.read_bytes()[128:])
    run, _ = read_recording(file, columns="time [s], sprung.az [m/s^2]", variable="x_F")
    np.testing.assert_array_equal(run["sprung.az"], WAVE)


def test_variable_is_refused_where_it_means_nothing(tmp_path: Path) -> None:
    file = write(tmp_path / "a.csv", "time [s], sprung.az [g]", TIME, WAVE)
    with pytest.raises(RecordingError, match="a variable cannot be chosen"):
        read_recording(file, variable="x_F")


def test_registry_rows_are_complete() -> None:
    suffixes = [suffix for reader in READERS for suffix in reader.suffixes]
    assert len(set(suffixes)) == len(suffixes) - 1  # .dat is text or MDF, as its first bytes say
    for reader in READERS:
        assert all((reader.name, reader.label, reader.source, reader.example))
        assert all(
            suffix.startswith(".") and suffix == suffix.lower() for suffix in reader.suffixes
        )


def test_a_format_is_one_function(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(readers, "READERS", [*READERS])

    @readers.reader("pairs", "pairs of numbers", (".pairs",), source="this test", example="0 1")
    def read_pairs(path: Path, options: readers.ReaderOptions) -> readers.SignalTable:
        time, values = np.loadtxt(path).T
        columns = Column("time", "s", time), Column("sprung.az", "m/s^2", values)
        return readers.SignalTable(ColumnTable(columns, (), str(path)))

    file = tmp_path / "run.pairs"
    np.savetxt(file, [[0.001 * i, i % 3] for i in range(20)])
    run, _ = read_recording(file)
    assert float(run["sprung.az"].max()) == 2.0
    with pytest.raises(RecordingError, match=r"a variable cannot be chosen.*found 'x'"):
        read_recording(file, variable="x")


@pytest.mark.skipif(not hasattr(signal, "SIGXCPU"), reason="limits of POSIX")
def test_a_reader_whose_time_is_spent_is_told_from_one_that_crashed() -> None:
    child = object.__new__(isolated._Child)
    child.is_ready = True
    for code, says in (
        (signal.SIGXCPU, "does not finish"),
        (signal.SIGSEGV, r"process crashed \(SIGSEGV\)"),
    ):
        child.process = SimpleNamespace(wait=lambda code=code: -code)
        assert re.search(says, str(child._fate(Path("a.csv"), 9.0, late=False)))


@pytest.mark.parametrize("cell", ["1.5d+00", "0x1.8p+0", "1\u00b75", "23/11/2026 00:00:01.5"])
def test_times_as_other_languages_write_them_are_named(tmp_path: Path, cell: str) -> None:
    file = tmp_path / "a.csv"
    file.write_text("time [s], sprung.az [m/s^2]\n" + f"{cell}, {cell}\n" * 20, encoding="utf-8")
    with pytest.raises(
        RecordingError, match=r"a\.csv, line 2: column 'time \[s\]': text in a number column"
    ):
        read_recording(file)
