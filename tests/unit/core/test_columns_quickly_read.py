"""Number columns are read at once where nothing is odd; cell by cell, with the same numbers or message, elsewhere."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from jounce.core import columns
from jounce.core.columns import read_columns_csv, read_comments_csv
from jounce.core.errors import RecordingError

CELLS = [
    "1", " 2.5 ", "1e-3", "-.25", "+7", "5.", "0.1234567890123456789", "4.9e-324", "1e308", "-0", "0e9", "1E5",
    "1_0", "nan", "inf", "-Infinity", "", " ", '"3"', '"3', "1,5", "0x10", "1e400", "١٢", "1d3", "1.5f", "#3", "1 2",
    "\xa01", "1\xa0", "1e", "--1", ".", "1j", "(1)", "1;2", "1\t2", "\ufeff1", "True", "1\x1c2", "'1'", "1%", "1 N",
]  # fmt: skip


def outcome(file: Path) -> object:
    try:
        table = read_columns_csv(file)
    except RecordingError as error:
        return str(error)
    cells = [(column.values.tobytes(), str(column.fault)) for column in table]
    return cells, list(table.lines), table.comments, table.remarks


@pytest.mark.parametrize("separator", [",", ";", "\t"])
@pytest.mark.parametrize("cell", CELLS)
def test_same_as_cell_by_cell(tmp_path: Path, monkeypatch, cell: str, separator: str) -> None:
    file = tmp_path / "odd.csv"
    header, good = separator.join(("t [s]", "z [m]")), separator.join(("0.5", "1.25"))
    for place, row in enumerate((separator.join((cell, "3")), separator.join(("3", cell)))):
        for at in (0, 2):
            rows = [good, "", good]
            rows.insert(at, row)
            file.write_text("\n".join([f"# place {place}", header, *rows]), encoding="utf-8")
            quick = outcome(file)
            with monkeypatch.context() as patched:
                patched.setattr(columns, "_plain_numbers", lambda *_: None)
                assert outcome(file) == quick


def test_usual_records_need_no_look_at_cells(tmp_path: Path, monkeypatch) -> None:
    values = np.column_stack(
        [np.arange(2000) / 1000.0, np.random.default_rng(0).normal(0.0, 3.0, (2000, 4))]
    )
    file = tmp_path / "lane.csv"
    head = "# axle = 'front'\ntime [s], left.plate.z [mm], left.plate.force [N], right.plate.z [mm], b [N]"
    np.savetxt(
        file,
        values,
        fmt=["%.3f", "%.4f", "%.17g", "%.4e", "%12.1f"],
        delimiter=", ",
        header=head,
        comments="",
    )
    looked: list[str] = []
    monkeypatch.setattr(
        columns,
        "_cells",
        lambda line, mark, kept=columns._cells: looked.append(line) or kept(line, mark),
    )
    table = read_columns_csv(file)
    assert np.array_equal(table["left.plate.force"].values, values[:, 2])
    assert table.name_row(1999) == "line 2002"
    assert len(looked) <= 5  # header and first rows, to tell which is which


def test_comments_alone(tmp_path: Path) -> None:
    file = tmp_path / "a.csv"
    file.write_bytes(b"\xef\xbb\xbf#a = 1\r\n\r\n  # b\r\nx,y\r\n# c\r\n1,")
    assert read_comments_csv(file) == ("a = 1", "b")
    file.write_text("")
    assert read_comments_csv(file) == ()
