"""Number columns are read at once where nothing is odd; cell by cell, with the same numbers or message, elsewhere."""

from __future__ import annotations

import random
from contextlib import contextmanager
from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest

from jounce.core import columns, plain_rows
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
    cells = [
        (column.label, column.written, column.values.tobytes(), str(column.fault), str(column.part))
        for column in table
    ]
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


def same_in_bulk(file: Path, monkeypatch: pytest.MonkeyPatch) -> bool:
    """Compare both readers of a text; return whether it was read in bulk."""
    with monkeypatch.context() as patched:
        patched.setattr(columns, "_FEW", 2)
        with monkeypatch.context() as slow:
            slow.setattr(columns, "_read_in_bulk", lambda *_: None)
            wanted = outcome(file)
        patched.setattr(columns, "_HEAD", 6)
        patched.setattr(plain_rows, "_PIECE", 150)
        is_read = columns._read_in_bulk(columns.text_of(file), file, 0) is not None
        assert outcome(file) == wanted
    return is_read


@pytest.mark.parametrize("separator", [",", "; ", " "])
@pytest.mark.parametrize(
    "cell", [*CELLS, "3e 4", "3E +4", "1e+", "1.5\n", "\n", "\r", "# 3", "1.000", "12:01"]
)
def test_a_long_text_is_read_in_bulk_with_the_same_outcome(
    tmp_path: Path, monkeypatch, cell: str, separator: str
) -> None:
    file = tmp_path / "odd.csv"
    good = separator.join(("0.5", "1.25"))
    was_read = []
    for row in (separator.join((cell, "3")), separator.join(("3", cell))):
        for at in (0, 20, 29):
            rows = [good] * 30
            rows[at] = row
            text = "\n".join(["# a", "", separator.join(("t [s]", "z [m]")), *rows])
            file.write_text(text, encoding="utf-8", newline="")
            was_read.append(same_in_bulk(file, monkeypatch))
    plain = {"1", "1e-3", "-.25", "+7", "5.", "4.9e-324", "1e308", "-0", "0e9", "1E5", "1.000"}
    assert cell not in plain or all(was_read)


@pytest.mark.parametrize("seed", range(8))
def test_random_texts_are_read_in_bulk_with_the_same_outcome(
    tmp_path: Path, monkeypatch, seed: int
) -> None:
    choice = random.Random(seed)
    file = tmp_path / "random.txt"
    was_read = 0
    for _ in range(25):
        separator = choice.choice([",", ";", "\t", " ", "; ", "  "])
        width, end = choice.randint(1, 4), choice.choice(["\n", "\r\n"])
        kinds = [choice.choice(KINDS) for _ in range(width)]
        comma = "," not in separator and choice.random() < 0.3
        tail = separator if choice.random() < 0.2 else ""
        rows = [
            separator.join(kind % choice.uniform(*span) for kind, span in kinds) for _ in range(30)
        ]
        if comma:
            rows = [row.replace(".", ",") for row in rows]
        if choice.random() < 0.3:
            rows[choice.randrange(30)] += choice.choice(
                [separator, "1", "-", " ", "e", '"', ",", ".", "#", "\v", "é"]
            )
        if choice.random() < 0.1:
            rows[-1] = rows[-1][:-3]
        names = separator.join(f"c{k} [m]" for k in range(width))
        above = choice.choice([[], ["# made today"], ["Device;7", "Rate;10"], ["# a", ""]])
        text = end.join([*above, names, *(row + tail for row in rows)])
        file.write_bytes((text + choice.choice(["", end, end + end, "\x1a"])).encode())
        was_read += same_in_bulk(file, monkeypatch)
    assert was_read > 3


KINDS = [("%.3f", (-5, 5)), ("%.6g", (-1e6, 1e6)), ("%.17g", (-1, 1)), ("%d", (0, 1500)), ("%+.2e", (1, 9)),
         ("%8.1f", (0, 99)), ("%.3f", (1, 900)), ("%.25e", (-1, 1))]  # fmt: skip


def test_numbers_in_bulk_are_rounded_correctly() -> None:
    noise = np.random.default_rng(0)
    numbers = noise.integers(0, 2**63, 20_000, dtype=np.uint64).view(float)
    cells = [
        form % float(number)
        for number in numbers[np.isfinite(numbers)]
        for form in ("%r", "%.20e", "%.5g")
    ]
    cells += [
        format((Decimal(low) + Decimal(np.nextafter(low, np.inf))) / 2, "f")
        for low in noise.uniform(1.0, 2.0, 2000)
    ]
    wanted = np.array([float(cell) for cell in cells])
    rows = plain_rows.parse_plain_rows("\n".join(cells), 1, ",", lambda _: None)
    assert rows is not None
    assert rows.columns[0].tobytes() == wanted.tobytes()


def test_a_long_text_shows_its_progress(tmp_path: Path, monkeypatch) -> None:
    file = tmp_path / "long.csv"
    file.write_text("time [s],z [m]\n" + "0.5,1.25\n" * 5000)
    monkeypatch.setattr(plain_rows, "_PIECE", 9000)
    stages: list[tuple[str, float]] = []

    @contextmanager
    def report(stage):
        follow = plain_rows._parse
        with monkeypatch.context() as patched:
            patched.setattr(
                plain_rows,
                "_parse",
                lambda *asked: stages.append((str(stage()), stage().share)) or follow(*asked),
            )
            yield

    monkeypatch.setattr(columns, "report_work", report)
    assert len(read_columns_csv(file)["z"].values) == 5000
    assert stages[0] == ("reading long.csv: 0 %", 0.0)
    assert [share for _, share in stages] == sorted({share for _, share in stages})
    assert 0.7 < stages[-1][1] < 1.0


def test_quoted_numbers_are_read_as_without_quotes(tmp_path):
    rows = [f"{k / 100},{k * 1.5}" for k in range(50)]
    plain, quoted = tmp_path / "plain.csv", tmp_path / "quoted.csv"
    plain.write_text("time [s],force [N]\n" + "\n".join(rows))
    marks = ['"' + row.replace(",", '","') + '"' for row in rows]
    quoted.write_text("time [s],force [N]\n" + "\n".join(marks))
    for own, other in zip(read_columns_csv(quoted), read_columns_csv(plain), strict=True):
        np.testing.assert_array_equal(own.values, other.values)
    quoted.write_text('time [s],force [N]\n"0,5"\n"1,5"\n')  # one cell a row, not two
    with pytest.raises(RecordingError):
        read_columns_csv(quoted)
