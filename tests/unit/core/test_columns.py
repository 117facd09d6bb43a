"""Number columns from text files: what is read, and one clear message for each thing that is wrong."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from jounce.core.columns import read_columns_csv
from jounce.core.errors import DescriptionError, RecordingError


def written(folder: Path, content: str | bytes) -> Path:
    file = folder / "bench.csv"
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    return file


@pytest.mark.parametrize("separator", [",", ";", "\t", ", "])
def test_reads_every_separator(tmp_path: Path, separator: str) -> None:
    rows = [["time [s]", "sprung.az [m/s^2]"], ["0", "1.5"], ["1e-3", "-.25"]]
    table = read_columns_csv(written(tmp_path, "\n".join(separator.join(row) for row in rows) + "\n"))
    assert table.names == ("time", "sprung.az")
    assert [column.unit for column in table] == ["s", "m/s^2"]
    np.testing.assert_array_equal(table["time"].values, [0.0, 0.001])
    np.testing.assert_array_equal(table["sprung.az [m/s^2]"].values, [1.5, -0.25])


def test_keeps_comments_before_the_header_and_skips_blank_lines(tmp_path: Path) -> None:
    table = read_columns_csv(written(tmp_path, "# trial 3\n#speed 1.95\n\nx [m],z [m]\n0,0\n\n1,2\n\n"))
    assert table.comments == ("trial 3", "speed 1.95")
    assert len(table[0].values) == 2


def test_reads_windows_lines_byte_order_mark_and_quotes(tmp_path: Path) -> None:
    table = read_columns_csv(written(tmp_path, b'\xef\xbb\xbf"x [mm]","f, raw [N]"\r\n"1",2\r\n'))
    assert table.names == ("x", "f, raw")
    assert table["x"].in_si("m")[0] == pytest.approx(1e-3, rel=1e-15)


def test_reads_files_of_old_spreadsheets(tmp_path: Path) -> None:
    assert read_columns_csv(written(tmp_path, "winkel [°]\n1\n".encode("cp1252")))[0].unit == "°"
    assert read_columns_csv(written(tmp_path, "t [s]\tz [m]\n0\t1\n".encode("utf-16"))).names == ("t", "z")


def test_a_trailing_separator_everywhere_is_accepted(tmp_path: Path) -> None:
    table = read_columns_csv(written(tmp_path, "x [m],z [m],\n0,1,\n1,2,\n"))
    assert table.names == ("x", "z")
    np.testing.assert_array_equal(table["z"].values, [1.0, 2.0])


@pytest.mark.parametrize(
    ("content", "line", "says"),
    [
        ("", None, "the file is empty"),
        ("# only a comment\n\n", None, "the file is empty"),
        ("x [m],z [m]\n", 1, "no rows"),
        ("0,1\n1,2\n", 1, "header is missing"),
        ("x [m],z [m]\n0,1\n1,two\n", 3, "text in a number column; found 'two'"),
        ("x [m],z [m]\n0,1_000\n", 2, "text in a number column"),
        ("x,z\nm,mm\n0,1\n", 2, "Units belong into the header"),
        ("x [m],z [m]\n0,1\n1\n", 3, "1 cells"),
        ("x [m],z [m]\n0,1\n1,2,3\n", 3, "3 cells"),
        ("x [m],z [m]\n0,1,\n1,2,\n", 2, "ends with a comma"),
        ("x [m],z [m],\n0,1\n", 2, "header ends with a comma"),
        ("x [m],z [m],\n0,1,\n1,2,5\n", 3, "header ends with a comma"),
        ("x [m],z [m]\n0,1\n1,\n", 3, "blank"),
        ("x [m],z [m]\n0,nan\n", 2, "not a finite number"),
        ("x [m],z [m]\n0,-inf\n", 2, "not a finite number"),
        ("x [m];z [m]\n0;1,5\n", 2, "decimal comma; found '1,5'"),
        ("x [m],z [m]\n0,1,1,5\n", 2, "Write 1.5, not 1,5"),
        ("x [m],,z [m]\n0,1,2\n", 1, "column 2 has no name"),
        ("x [m],x [mm]\n0,1\n", 1, "two columns are named 'x'"),
        (b"x [m]\n\0\1\2", None, "not a text file"),
    ],
)
def test_says_what_is_wrong_and_where(tmp_path: Path, content: str | bytes, line: int | None, says: str) -> None:
    with pytest.raises(RecordingError) as caught:
        read_columns_csv(written(tmp_path, content))
    message = str(caught.value)
    assert says in message
    assert f"bench.csv, line {line}" in message if line else "bench.csv" in message


def test_missing_file_column_and_unit(tmp_path: Path) -> None:
    with pytest.raises(RecordingError, match=r"none\.csv: no such file"):
        read_columns_csv(tmp_path / "none.csv")
    table = read_columns_csv(written(tmp_path, "sprung.az [g],force\n1,2\n"))
    assert table["sprung.az"].in_si("m/s^2")[0] == 9.80665  # ISO 80000-3 standard gravity
    with pytest.raises(RecordingError, match=r"no column 'sprung\.ay'.*Did you mean 'sprung\.az'"):
        table["sprung.ay"]
    with pytest.raises(RecordingError, match=r"column 'force': the header has no unit; allowed: 'force \[N\]'"):
        table["force"].in_si("N")
    with pytest.raises(DescriptionError, match=r"column 'sprung\.az \[g\]': wrong unit"):
        table["sprung.az"].in_si("m")
