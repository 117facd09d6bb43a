"""HDF5 files that announce more samples than they hold, and readers that answer with something that is no table."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
import pytest

from jounce.core.columns import Column, ColumnTable
from jounce.core.errors import RecordingError
from jounce.recordings import read_recording, readers
from jounce.recordings.hdf5 import check_size, read_part, rows_on_disk

TIME = np.arange(3000) * 0.001
WAVE = np.sin(TIME * 20.0)


def written(file: Path, announced: int, held: int, *, matlab: bool = False) -> Path:
    with h5py.File(file, "w", userblock_size=512 if matlab else 0) as content:
        for name, values, unit in (("time", TIME, "s"), ("sprung.az", WAVE, "g")):
            shape = (1, announced) if matlab else (announced,)
            signal = content.create_dataset(
                name, shape, float, chunks=(1, 1000) if matlab else (1000,)
            )
            signal[..., :held] = values[:held]
            signal.attrs["units"] = unit
            if matlab:
                signal.attrs["MATLAB_class"] = np.bytes_("double")
        if not matlab:
            content["time"].make_scale("time")
            content["sprung.az"].dims[0].attach_scale(content["time"])
    if matlab:
        file.write_bytes(
            b"MATLAB 7.3 MAT-file".ljust(124) + b"\x00\x02IM" + file.read_bytes()[128:]
        )
    return file


@pytest.mark.parametrize("suffix", [".nc", ".mat"])
def test_a_file_that_announces_more_than_it_holds(tmp_path: Path, suffix: str) -> None:
    told = (
        {"columns": {"time": "time [s]", "sprung.az": "sprung.az [g]"}} if suffix == ".mat" else {}
    )
    for announced in (5000, 2_000_000_000):  # the larger one would be 16 GB
        file = written(tmp_path / f"a{suffix}", announced, 3000, matlab=suffix == ".mat")
        run, findings = read_recording(file, **told)
        problems = [finding for finding in findings if finding.severity == "problem"]
        assert len(problems) == 2
        assert problems[0].value == 3000.0
        assert f"declares {announced} samples but contains 3000" in problems[0].message
        np.testing.assert_allclose(run["sprung.az"], 9.80665 * WAVE)
    with pytest.raises(RecordingError, match="contains none of the samples"):
        read_recording(
            written(tmp_path / f"b{suffix}", 2_000_000_000, 0, matlab=suffix == ".mat"), **told
        )


def test_a_gap_within_is_no_end(tmp_path: Path) -> None:
    file = written(tmp_path / "a.nc", 5000, 1000)
    with h5py.File(file, "a") as content:
        content["sprung.az"][4000:5000] = 1.0
    with pytest.raises(RecordingError, match="some parts of the record were never written"):
        read_recording(file)


def test_a_piece_that_is_listed_and_lies_nowhere_was_never_written(tmp_path: Path) -> None:
    file = written(tmp_path / "a.nc", 3000, 3000)
    with h5py.File(file) as content:
        begin = content["sprung.az"].id.get_chunk_info(1).byte_offset
    key = (1000).to_bytes(8, "little") + bytes(8)  # where the piece begins, and then where it lies
    whole = file.read_bytes()
    assert whole.count(key + begin.to_bytes(8, "little")) == 1
    file.write_bytes(whole.replace(key + begin.to_bytes(8, "little"), key + b"\xff" * 8))
    with pytest.raises(
        RecordingError, match=r"some parts of the record were never written; found '2 of 3 pieces'"
    ):
        read_recording(file)


def test_numbers_of_a_kind_that_no_program_writes(tmp_path: Path) -> None:
    """One bit of a kind's exponent makes other numbers of all, which look like those of a recording."""
    odd = h5py.h5t.IEEE_F64LE.copy()
    odd.set_ebias(odd.get_ebias() ^ 2)
    for kind, is_refused in (
        (odd, True),
        (h5py.h5t.IEEE_F32BE, False),
        (h5py.h5t.STD_I16LE, False),
    ):
        with h5py.File(tmp_path / "a.h5", "w") as content:
            space = h5py.h5s.create_simple((4,))
            signal = h5py.Dataset(h5py.h5d.create(content.id, b"a", kind, space))
            signal[:] = [1, 2, 3, 4]
            if is_refused:
                with pytest.raises(RecordingError, match="a: an impossible number type"):
                    read_part(signal, "a.h5")
            else:
                np.testing.assert_array_equal(read_part(signal, "a.h5")[0], [1, 2, 3, 4])


def test_numbers_that_lie_in_other_files_are_not_read(tmp_path: Path) -> None:
    (tmp_path / "secret").write_bytes(bytes(range(24)))
    with h5py.File(tmp_path / "a.h5", "w") as content:
        content.create_dataset("a", (3,), float, external=[(str(tmp_path / "secret"), 0, 24)])
        layout = h5py.VirtualLayout((3,), float)
        layout[:] = h5py.VirtualSource(str(tmp_path / "a.h5"), "a", (3,))
        content.create_virtual_dataset("b", layout)
        for name in ("a", "b"):
            with pytest.raises(RecordingError, match=f"{name}: the data are stored in other files"):
                read_part(content[name], "a.h5")


@pytest.mark.parametrize(
    ("values", "says"),
    [
        (
            np.zeros((40, 2)),
            r"sprung\.az \[g\]: a column does not contain real numbers: the reader 'odd'.*shape \(40, 2\)",
        ),
        (np.zeros(40, dtype=complex), "does not contain real numbers.*complex128"),
        ([0.0] * 40, "does not contain real numbers.*no array"),
        (np.zeros(0), "does not contain real numbers"),
        (np.array(1.0), "does not contain real numbers"),
        (
            np.zeros(39),
            r"the columns have different lengths: the reader 'odd'.*time \[s\]: 40, sprung\.az \[g\]: 39",
        ),
    ],
)
def test_an_answer_that_is_no_table_is_refused_where_readers_are_called(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, values: object, says: str
) -> None:
    monkeypatch.setattr(readers, "READERS", [*readers.READERS])

    @readers.reader("odd", "odd", (".odd",), source="this test", example="none")
    def read_odd(path: Path, options: readers.ReaderOptions) -> readers.SignalTable:
        columns = Column("time", "s", TIME[:40]), Column("sprung.az", "g", values)  # type: ignore[arg-type]
        return readers.SignalTable(ColumnTable(columns, (), str(path)))

    (tmp_path / "a.odd").write_text("1")
    with pytest.raises(RecordingError, match=says):
        read_recording(tmp_path / "a.odd")


def test_signals_that_were_never_recorded_at_once_have_no_time_in_common(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(readers, "READERS", [*readers.READERS])
    starts = [0.0, 0.01]

    @readers.reader("odd", "odd", (".odd",), source="this test", example="none")
    def read_odd(path: Path, options: readers.ReaderOptions) -> readers.SignalTable:
        tables = [
            ColumnTable(
                (Column("time", "s", start + TIME[:40]), Column(name, "g", WAVE[:40])),
                (),
                str(path),
            )
            for start, name in zip(starts, ("sprung.az", "unsprung.az"), strict=True)
        ]
        return readers.SignalTable(tables[0], others=(tables[1],))

    (tmp_path / "a.odd").write_text("1")
    run, _ = read_recording(tmp_path / "a.odd", resample="1 ms")
    assert (run.sizes["time"], float(run["time"][0])) == (30, pytest.approx(0.01))
    starts[1] = 0.5
    with pytest.raises(RecordingError, match=r"a\.odd: the signals do not overlap in time"):
        read_recording(tmp_path / "a.odd", resample="1 ms")


def test_more_numbers_than_a_recording_can_have(tmp_path: Path) -> None:
    check_size(500_000_000, "a.nc")
    with pytest.raises(
        RecordingError, match=r"a\.nc: too many numbers; found '500000001'; allowed: up to 5e\+08"
    ):
        check_size(500_000_001, "a.nc")


@pytest.mark.parametrize("chunks", [None, (1000, 2), (700, 1), (5000, 1)])
@pytest.mark.parametrize("held", [0, 1000, 2100, 3000])
def test_rows_that_were_written_are_counted(
    tmp_path: Path, chunks: tuple[int, int] | None, held: int
) -> None:
    with h5py.File(tmp_path / "a.h5", "w") as file:
        signals = file.create_dataset(
            "a", (3000, 2), float, chunks=chunks and (min(chunks[0], 3000), chunks[1])
        )
        if held:
            signals[:held] = 1.0
        step = chunks[0] if chunks else 3000
        assert rows_on_disk(signals) == (0, min(3000, -(-held // step) * step))
        values, findings = read_part(signals, "a.h5") if held else (np.empty((0, 2)), [])
        assert values.shape == (min(3000, -(-held // step) * step), 2)
        assert [found.value for found in findings] == [float(len(values))] * (
            0 < len(values) < 3000
        )
