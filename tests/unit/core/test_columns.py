"""Number columns from text files: what is read, and one clear message for each thing that is wrong."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from jounce.core import columns, units
from jounce.core.columns import ColumnTable, read_columns_csv
from jounce.core.errors import DescriptionError, RecordingError


def written(folder: Path, content: str | bytes) -> Path:
    file = folder / "bench.csv"
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    return file


def told(table: ColumnTable) -> list[str]:
    return [remark.message for remark in table.remarks]


def ask_for_every_column(file: Path) -> None:
    table = read_columns_csv(file)
    for column in table:
        table[column.name]


@pytest.mark.parametrize("separator", [",", ";", "\t", ", "])
def test_reads_every_separator(tmp_path: Path, separator: str) -> None:
    rows = [["time [s]", "sprung.az [m/s^2]"], ["0", "1.5"], ["1e-3", "-.25"]]
    table = read_columns_csv(
        written(tmp_path, "\n".join(separator.join(row) for row in rows) + "\n")
    )
    assert table.names == ("time", "sprung.az")
    assert [column.unit for column in table] == ["s", "m/s^2"]
    np.testing.assert_array_equal(table["time"].values, [0.0, 0.001])
    np.testing.assert_array_equal(table["sprung.az [m/s^2]"].values, [1.5, -0.25])


def test_keeps_comments_before_the_header_and_skips_blank_lines(tmp_path: Path) -> None:
    table = read_columns_csv(
        written(tmp_path, "# trial 3\n#speed 1.95\n\nx [m],z [m]\n0,0\n\n1,2\n\n")
    )
    assert table.comments == ("trial 3", "speed 1.95")
    assert len(table[0].values) == 2


def test_reads_windows_lines_byte_order_mark_and_quotes(tmp_path: Path) -> None:
    table = read_columns_csv(written(tmp_path, b'\xef\xbb\xbf"x [mm]","f, raw [N]"\r\n"1",2\r\n'))
    assert table.names == ("x", "f, raw")
    assert table["x"].in_si("m")[0] == pytest.approx(1e-3, rel=1e-15)


def test_reads_files_of_old_spreadsheets(tmp_path: Path) -> None:
    assert read_columns_csv(written(tmp_path, "winkel [°]\n1\n".encode("cp1252")))[0].unit == "°"
    assert read_columns_csv(written(tmp_path, "t [s]\tz [m]\n0\t1\n".encode("utf-16"))).names == (
        "t",
        "z",
    )


@pytest.mark.parametrize(
    "end", [b"\x1a", b"\r\n\x1a", b"\r\n\x1a\x1a\x1a", b"\r\n\x1a\r\n", b"\r\n\x1a" + 100 * b"\0"]
)
def test_the_end_mark_of_dos_is_no_row(tmp_path: Path, end: bytes) -> None:
    table = read_columns_csv(written(tmp_path, b"x [mm];z [mm]\r\n0;1\r\n1;2" + end))
    assert table["z"].values.tolist() == [1.0, 2.0]


@pytest.mark.parametrize("end", [b"\r\n\x1a\r\n2;3\r\n", b"\r\n\0\0"])
def test_an_end_mark_before_other_rows_and_zeros_without_one_are_refused(
    tmp_path: Path, end: bytes
) -> None:
    with pytest.raises(RecordingError, match=r"as many cells|not a text file"):
        read_columns_csv(written(tmp_path, b"x [mm];z [mm]\r\n0;1\r\n1;2" + end))


def test_names_of_r_have_their_units(tmp_path: Path) -> None:
    head = '"","time..s.","sprung.az..m.s.2.","v..m.s..1.","c..N.s.mm.","k..N.m.","Weg...mm","a.b"'
    table = read_columns_csv(written(tmp_path, f'{head}\n"1",0,1,2,3,4,5,6\n"2",1,2,NA,4,5,6,7\n'))
    assert [(one.name, one.unit) for one in table][1:] == [
        ("time", "s"),
        ("sprung.az", "m/s^2"),
        ("v", "m s^-1"),
        ("c", "N s/mm"),
        ("k..N.m.", ""),  # N m, or N/m
        ("Weg...mm", ""),
        ("a.b", ""),
    ]
    assert table["sprung.az..m.s.2."] is table["sprung.az"]
    with pytest.raises(
        RecordingError,
        match=r"no column 'k'; .*map the column with its unit: k = 'k..N.m. \[UNIT\]'",
    ):
        table["k"]
    with pytest.raises(RecordingError, match=r"line 3: column 'v..m.s..1.': .*'NA'"):
        table["v"].readable()


def test_a_unit_that_is_read_from_r_is_not_another_usual_one() -> None:
    """A point may stand for a multiplication, a division, a power or a blank: of usual units only one may be so."""
    usual = (
        {unit for others in units._EVERYDAY.values() for unit in others}
        | set(units._EVERYDAY)
        | set(units._MEANT)
    )
    usual |= {
        "N*mm",
        "N*s/mm",
        "N*m/rad",
        "N*m/deg",
        "kg*m^2",
        "N s",
        "N*m*s",
        "N/m^2",
        "N s/m",
        "N/s",
    }
    for unit in usual - {"%"}:
        read = columns._UNITS_OF_R.get(re.sub("[^A-Za-z0-9]", ".", unit))
        assert read is None or units.conversion_factor(unit, read) == pytest.approx(
            1.0, rel=1e-15
        ), unit
    assert all(map(units.is_unit, columns._UNITS_OF_R.values()))


def test_names_in_the_last_comment_are_those_of_numpy(tmp_path: Path) -> None:
    np.savetxt(
        tmp_path / "a.txt", [[0.0, 1.0], [1.0, 2.0]], header="bench 3\n\ntime [s] strut.force [N]"
    )
    table = read_columns_csv(tmp_path / "a.txt")
    assert [one.label for one in table] == ["time [s]", "strut.force [N]"]
    assert (table.comments, told(table)) == (
        ("bench 3", ""),
        ["the names were read from the last comment"],
    )
    for comment in ("bench 3", "time [s], force [N], more", "1, 2"):
        with pytest.raises(RecordingError, match="the header is missing"):
            read_columns_csv(written(tmp_path, f"# {comment}\n0,1\n1,2\n"))


def test_rows_of_r_have_names_that_have_no_header(tmp_path: Path) -> None:
    table = read_columns_csv(written(tmp_path, '"t" "az..g."\n"1" 0 1.5\n"2" 0.1 2.5\n'))
    assert [one.label for one in table] == ["column 1", "t", "az [g]"]
    assert table["az"].values.tolist() == [1.5, 2.5]
    with pytest.raises(
        RecordingError, match="as many cells"
    ):  # no names: a column without a header, or names
        read_columns_csv(written(tmp_path, "t,az\n1,0,1.5\n2,0.1,2.5\n"))


@pytest.mark.parametrize(
    "cells",
    [("0 days 00:00:00", "0 days 00:00:00.010000"), ("1 days 23:59:59.995", "2 days 00:00:00.005")],
)
def test_durations_of_pandas_are_seconds(tmp_path: Path, cells: tuple[str, str]) -> None:
    table = read_columns_csv(written(tmp_path, f"time,z [m]\n{cells[0]},1\n{cells[1]},2\n"))
    np.testing.assert_allclose(table["time"].in_si("s"), [0.0, 0.01], atol=1e-12)


@pytest.mark.parametrize(
    "cell", ["nan", "NaN", "NA", "<NA>", "#N/A", "-1.#IND", "1.#QNAN", "NULL", "NaT", ""]
)
def test_what_programs_write_for_no_number_is_a_gap(tmp_path: Path, cell: str) -> None:
    table = read_columns_csv(written(tmp_path, f"t [s],z [m]\n0,1\n1,{cell}\n2,3\n"))
    part = table.columns[1].part
    assert part is not None
    assert part[1].tolist() == [1.0, 3.0]


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("first", ["", "sep=;\n", "\ufeff", "\ufeffsep=;\n"])
def test_line_ends_and_first_lines_of_spreadsheets(tmp_path: Path, first: str, end: str) -> None:
    table = read_columns_csv(
        written(tmp_path, f'{first}"t [s]";"z [m]"\n"0";"1,5"\n"1";"2,5"\n'.replace("\n", end))
    )
    assert [one.label for one in table] == ["t [s]", "z [m]"]
    assert table["z"].values.tolist() == [1.5, 2.5]


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
        ("x [m],z [m]\n0,1\n1\n", 3, "1 cells"),
        ("x [m],z [m]\n0,1\n1,2,3\n", 3, "3 cells"),
        ("x [m],z [m],\n0,1,\n1,2,5\n", 3, "header ends with a comma"),
        ("x [m],z [m]\n0,1\n1,\n", 3, "blank"),
        ("x [m],z [m]\n0,nan\n", 2, "not a finite number"),
        ("x [m],z [m]\n0,-inf\n", 2, "not a finite number"),
        ("x [m],z [m]\n0,1,1,5\n", 2, "write 1.5, not 1,5"),
        (
            'x [m],z [m]\n0.5,"1,5"\n',
            None,
            "decimal commas and decimal points in one file; found \"'1,5' (line 2, column",
        ),
        ("x [m];z [m]\n0.5;1,234\n", None, "Are the points thousands separators?"),
        ("x [m];z [m]\n0;1.234,5\n", 2, "text in a number column; found '1.234,5'"),
        ("x [m],,z [m]\n0,1,2\n", None, "column 2 has no name"),
        ("x [m],x [mm]\n0,1\n", None, "2 columns are named 'x'"),
        ("x [m],x [m]\n0,1\n", None, "2 columns are named 'x'"),
        ("x [m],two\n0,1\n1,two\n", 3, "text in a number column; found 'two'"),
        ("x [m],two\n0,one\n1,two\n", 2, "No cell of the column is a number"),
        ("x [m],none\n0,\n1,\n", None, "all cells of the column are empty"),
        (f"x [m],{'y' * 2000} [m]\n0,1\n", 1, "a cell of the header is too long"),
        (f"x [m],{'y' * 200_000} [m]\n0,1\n", None, "not a table (field larger than field limit"),
        (b"x [m]\n\0\1\2", None, "not a text file"),
    ],
)
def test_says_what_is_wrong_and_where(
    tmp_path: Path, content: str | bytes, line: int | None, says: str
) -> None:
    with pytest.raises(RecordingError) as caught:
        ask_for_every_column(written(tmp_path, content))
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
    with pytest.raises(
        RecordingError, match=r"column 'force': the header has no unit; allowed: 'force \[N\]'"
    ):
        table["force"].in_si("N")
    with pytest.raises(DescriptionError, match=r"column 'sprung\.az \[g\]': wrong unit"):
        table["sprung.az"].in_si("m")


@pytest.mark.parametrize(
    ("header", "unit"),
    [
        ("Force [kN]", "kN"), ("Force (kN)", "kN"), ("Force / kN", "kN"), ("Force in kN", "kN"), ("Force[kN]", "kN"),
        ("Force", ""), ("Force (L)", ""), ("Force (front)", ""), ("Force (1)", ""), ("Force / left", ""),
        ("Force (L) [kN]", "kN"), ("Force (L) (kN)", "kN"), ("Force [L] (kN)", "kN"), ("(kN)", ""), ("Force/kN", ""),
    ],
)  # fmt: skip
def test_units_of_headers_as_engineers_write_them(tmp_path: Path, header: str, unit: str) -> None:
    table = read_columns_csv(written(tmp_path, f"t (s);{header}\n0;1\n"))
    assert table[1].unit == unit
    assert table[1].name == (
        re.sub(r"( in | / |\[|\(|)kN[\])]?$", "", header).strip() if unit else header
    )
    assert table[header].values.tolist() == [1.0]  # it is found as it is written, too
    assert table[table[1].label] is table[1]


@pytest.mark.parametrize("units", ["s;kN;-", "[s];[kN];[-]", "(s);(kN);()", "s;kN;"])
def test_units_in_a_line_of_their_own(tmp_path: Path, units: str) -> None:
    table = read_columns_csv(written(tmp_path, f"time;force;count\n{units}\n0;1;5\n1;2;6\n"))
    assert [column.unit for column in table] == ["s", "kN", ""]
    assert table["force"].values.tolist() == [1.0, 2.0]
    assert told(table) == ["the units were read from the line below the names"]
    assert table.name_row(0) == "line 3"


@pytest.mark.parametrize("separator", [";", "\t", " ", '","'])
def test_decimal_commas_are_read_and_said(tmp_path: Path, separator: str) -> None:
    quote = '"' if '"' in separator else ""
    rows = [["Zeit [s]", "Weg [mm]", "Nr"], ["0,001", "-1,5e-3", "1"], ["0,002", "7", "2"]]
    content = "\r\n".join(quote + separator.join(row) + quote for row in rows)
    table = read_columns_csv(written(tmp_path, content))
    assert table.names == ("Zeit", "Weg", "Nr")
    np.testing.assert_array_equal(table["Weg"].values, [-1.5e-3, 7.0])
    np.testing.assert_array_equal(table["Zeit"].values, [0.001, 0.002])
    assert told(table) == ["decimal commas were read as decimal points"]


def test_a_column_nobody_asks_for_may_hold_anything(tmp_path: Path) -> None:
    rows = "0,001;ok;;21.11.2026 10:00;1;1,5\n0,002;stop;;21.11.2026 10:01;;2,5\n"
    table = read_columns_csv(
        written(tmp_path, f"Zeit [s];remark;empty;date;half;force [N]\n{rows}")
    )
    np.testing.assert_array_equal(table["force"].values, [1.5, 2.5])
    assert [column.name for column in table if column.fault is not None] == [
        "remark",
        "empty",
        "date",
        "half",
    ]


def test_trailing_separators_anywhere_are_accepted(tmp_path: Path) -> None:
    for content in (
        "x [m],z [m]\n0,1,\n1,2,\n",
        "x [m],z [m],\n0,1\n1,2\n",
        "x [m],z [m],\n0,1,\n1,2\n",
    ):
        table = read_columns_csv(written(tmp_path, content))
        assert (table.names, table["z"].values.tolist()) == (("x", "z"), [1.0, 2.0])


def test_columns_twice_are_one_where_they_agree(tmp_path: Path) -> None:
    table = read_columns_csv(
        written(tmp_path, "t [s],F [N],t [s],a [g],F [N]\n0,1,0,5,2\n1,2,1,6,3\n")
    )
    assert table["t"].values.tolist() == [0.0, 1.0]
    with pytest.raises(RecordingError, match="2 columns are named 'F'"):
        table["F"]


def test_blanks_separate_where_nothing_else_does(tmp_path: Path) -> None:
    for header in ("time [s] force [kN]", "time[s]   force (raw) [kN]", "time_s   force"):
        table = read_columns_csv(written(tmp_path, f"{header}\n 0.0  1.5\n 1.0  -2.5 \n"))
        assert table[1].values.tolist() == [1.5, -2.5]
        assert table[0].unit == ("" if "_" in header else "s")


LOGGERS = {
    "one text": "Damper dyno, run 7\ntime [s];force [N]\n0;1\n1;2\n",
    "settings": "Logger X\nSample rate;1000\nChannels;2\n\ntime [s];force [N]\n0;1\n1;2\n",
    "settings in as many cells": "Make;Logger X\nRate;1000\nDate;21.11.2026\ntime;force\ns;N\n0;1\n1;2\n",
    "numbers before": "1000\n2\ntime [s],force [N]\n0,1\n1,2\n",
    "commas in prose": "Measured by A. B., on 21.11.2026, wet\ntime [s],force [N]\n0,1\n1,2\n",
    "tabs": "Operator:\tA. B.\nGain\t1.0\t(all)\ntime (s)\tforce (N)\t\n0\t1\t\n1\t2\t\n",
    "blanks": "Measured by A. B.\ntime [s]  force [N]\n0 1\n1 2\n",
    "decimal commas": "Prüfstand 3\nRate;1000,0\nZeit;Kraft\n[s];[N]\n0,0;1,0\n1,0;2,0\n",
    "a comment, too": "# axle = 'front'\nLogger X\n\ntime [s];force [N]\n0;1\n1;2\n",
}


@pytest.mark.parametrize("content", LOGGERS.values(), ids=LOGGERS)
def test_text_that_a_logger_writes_before_the_header_is_passed_over_and_said(
    tmp_path: Path, content: str
) -> None:
    table = read_columns_csv(written(tmp_path, content))
    assert [column.unit for column in table] == ["s", "N"]
    assert table[0].values.tolist() == [0.0, 1.0]
    assert table[1].values.tolist() == [1.0, 2.0]
    line = next(
        i
        for i, text in enumerate(content.splitlines(), 1)
        if text.lower().startswith(("time", "zeit"))
    )
    assert told(table)[0] == f"line {line} was taken as the header; the text before it was skipped"
    assert table.lines[0] > line


@pytest.mark.parametrize(
    "content",
    [
        "time [s];force [N]\nstart;none\n0;1\n",  # a row of text is a fault of its columns, not another header
        "time [s];force [N]\n0;1\nnew time [s];new force [N]\n1;2\n",  # nor is a second table the first one
        "day;force\nMon;5\nTue;missing\nWed;6\n",
        "a;b;c\n1;2\n3;4\n",  # rows without a header that fits them
        "0;1\n1;2\n",
    ],
)
def test_rows_are_never_passed_over_as_if_they_were_such_text(tmp_path: Path, content: str) -> None:
    try:
        table = read_columns_csv(written(tmp_path, content))
    except RecordingError:
        return
    assert not any("skipped" in remark for remark in told(table))
    assert table.lines[0] == 2
