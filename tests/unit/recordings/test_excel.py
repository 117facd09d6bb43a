"""Workbooks of Excel: as loggers and people write them, and as a recording is kept in one."""

from __future__ import annotations

from datetime import datetime, time, timedelta
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.core.errors import OutputError, RecordingError
from jounce.core.workbooks import workbook_of
from jounce.recordings import writers

openpyxl = pytest.importorskip("openpyxl")
SAMPLES = [[0.001 * i, 200.0 + (7 * i) % 13] for i in range(50)]


def book(file: Path, **sheets: list[list[Any]]) -> Path:
    """A workbook as openpyxl writes it."""
    made = openpyxl.Workbook()
    made.remove(made.active)
    for name, rows in sheets.items():
        sheet = made.create_sheet(name)
        for row in rows:
            sheet.append(row)
    made.save(file)
    return file


def force_of(file: Path, **options: Any) -> np.ndarray:
    return jn.read_recording(file, **options)[0]["tyre.force"].to_numpy()


def test_a_header_with_units_below_a_title_and_beside_a_margin(tmp_path: Path) -> None:
    rows = [
        ["Prüfstand 3"],
        [],
        [None, "time [ms]", "tyre.force [kN]", None],
        *([None, 1e3 * t, f / 1e3] for t, f in SAMPLES),
    ]
    found, findings = jn.read_recording(book(tmp_path / "a.xlsx", Messung=rows))
    np.testing.assert_allclose(found["tyre.force"], [f for _, f in SAMPLES], rtol=1e-15)
    np.testing.assert_allclose(found["time"], [t for t, _ in SAMPLES], atol=1e-18)
    assert any("row 3 was taken as the header" in one.message for one in findings)


def test_units_in_a_row_of_their_own_and_a_column_of_text(tmp_path: Path) -> None:
    rows = [["time", "tyre.force", "note"], ["s", "N", "-"], *([t, f, "ok"] for t, f in SAMPLES)]
    np.testing.assert_array_equal(
        force_of(book(tmp_path / "a.xlsx", run=rows)), [f for _, f in SAMPLES]
    )


@pytest.mark.parametrize(
    "instant",
    [
        lambda t: datetime(2026, 5, 3, 23, 59, 59, 990_000) + timedelta(seconds=t),  # noqa: DTZ001 - as Excel has it
        lambda t: time(9, 0, 0, round(1e6 * t)),
        lambda t: timedelta(hours=30, seconds=t),
    ],
)
def test_instants_are_seconds(tmp_path: Path, instant) -> None:
    rows = [["clock", "tyre.force [N]"], *([instant(t), f] for t, f in SAMPLES)]
    found, _ = jn.read_recording(book(tmp_path / "a.xlsx", run=rows), columns={"time": "clock [s]"})
    np.testing.assert_allclose(np.diff(found["time"]), 1e-3, rtol=1e-6)
    np.testing.assert_array_equal(found["tyre.force"], [f for _, f in SAMPLES])


@pytest.mark.parametrize(
    "head", [["time [s]"], ["time"], ["time [ms]"], ["time", "s"], ["time", "ms"]]
)
@pytest.mark.parametrize(
    "instant",
    [
        lambda t: datetime(2026, 5, 3, 23, 59, 59, 990_000) + timedelta(seconds=t),  # noqa: DTZ001 - as Excel has it
        lambda t: time(9, 0, 0, round(1e6 * t)),
        lambda t: timedelta(seconds=t),
    ],
)
def test_clocks_and_durations_need_no_unit(tmp_path: Path, instant, head: list[str]) -> None:
    rows = [
        list(row)
        for row in zip(head, ["tyre.force", "N"] if head[1:] else ["tyre.force [N]"], strict=True)
    ]
    found, _ = jn.read_recording(
        book(tmp_path / "a.xlsx", run=[*rows, *([instant(t), f] for t, f in SAMPLES)])
    )
    np.testing.assert_allclose(found["time"], [t for t, _ in SAMPLES], rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("head", ["time [s]", "time"])
@pytest.mark.parametrize("since", ["0 s", "2026-03-29 01:59:59.99"])
def test_times_that_pandas_writes_are_seconds(tmp_path: Path, head: str, since: str) -> None:
    pd = pytest.importorskip("pandas")
    first = pd.Timedelta(since) if since == "0 s" else pd.Timestamp(since)
    times = first + pd.to_timedelta([t for t, _ in SAMPLES], unit="s")
    pd.DataFrame({head: times, "tyre.force [N]": [f for _, f in SAMPLES]}).to_excel(
        tmp_path / "a.xlsx", index=False
    )
    found, _ = jn.read_recording(tmp_path / "a.xlsx")
    np.testing.assert_allclose(found["time"], [t for t, _ in SAMPLES], rtol=1e-12, atol=1e-12)


def test_seconds_shown_without_decimals_stay_seconds(tmp_path: Path) -> None:
    rows = [["time [s]", "tyre.force [N]"], *([1e-3 * i / 7.0, 200.0] for i in range(50))]
    file = book(tmp_path / "a.xlsx", run=rows)
    workbook = openpyxl.load_workbook(file)
    for row in workbook.active.iter_rows():
        row[0].number_format = "0"
    workbook.save(file)
    assert float(jn.read_recording(file)[0]["time"][7]) == 1e-3


def test_of_several_sheets_with_numbers_one_is_chosen(tmp_path: Path) -> None:
    head = ["time [s]", "tyre.force [N]"]
    sheets = {
        "first": [head, *SAMPLES],
        "second": [head, *([t, -f] for t, f in SAMPLES)],
        "notes": [["by hand"]],
    }
    file = book(tmp_path / "a.xlsx", **sheets)
    with pytest.raises(
        RecordingError,
        match=r"several sheets contain numbers; found 'first, second'.*Select a sheet: variable",
    ):
        jn.read_recording(file)
    assert np.all(force_of(file, variable="second") < 0.0)
    with pytest.raises(RecordingError, match=r"no sheet 'secnd'.*second"):
        jn.read_recording(file, variable="secnd")
    with pytest.raises(RecordingError, match="no sheet with numbers"):
        jn.read_recording(book(tmp_path / "b.xlsx", notes=[["by hand"]]))


def test_what_nobody_calculated_is_no_number(tmp_path: Path) -> None:
    """Formulas that were written by a program, and never seen by Excel, have no values."""
    rows = [["time [s]", "tyre.force [N]"], *([t, f"=2*{f}"] for t, f in SAMPLES)]
    with pytest.raises(
        RecordingError, match=r"column 'tyre\.force \[N\]': all cells of the column are empty"
    ):
        jn.read_recording(book(tmp_path / "a.xlsx", run=rows), columns={"tyre.force": "tyre.force"})


@pytest.mark.parametrize(
    "content", [b"", b"PK\x03\x04 and no more", b"time [s], tyre.force [N]\n0, 1\n"]
)
def test_what_is_no_workbook(tmp_path: Path, content) -> None:
    file = tmp_path / "a.xlsx"
    file.write_bytes(content)
    with pytest.raises(RecordingError, match=r"not an Excel workbook, or damaged|empty"):
        jn.read_recording(file)


def recording(
    values: Any = tuple(range(9)), name: str = "tyre.force", **attributes: Any
) -> xr.Dataset:
    about = {"units": "m/s^2" if name.endswith("az") else "N", "long_name": "=1+1"}
    clock = {"time": ("time", np.arange(len(values)) * 0.01, {"units": "s"})}
    return xr.Dataset({name: ("time", np.array(values), about)}, clock, attributes)


def test_texts_are_no_formulas_and_long_ones_are_whole(tmp_path: Path) -> None:
    run = recording(name="=front.az", note="ä\x07" * 30_000, count=3)
    again, _ = jn.read_recording(jn.write_recording(run, tmp_path / "a.xlsx"))
    assert again.attrs == run.attrs
    assert again["=front.az"].attrs["long_name"] == "=1+1"
    seen = openpyxl.load_workbook(tmp_path / "a.xlsx")["recording"]
    assert [cell.data_type for cell in seen[1]] == ["s", "s"]
    assert seen["B3"].value == 1.0


@pytest.mark.parametrize("value", [5e-324, 0.1 + 0.2, 1.0000000000000002, -0.0, 2.0**53 + 2.0])
def test_numbers_come_back_to_the_last_bit(tmp_path: Path, value: float) -> None:
    file = tmp_path / "a.xlsx"
    file.write_bytes(
        workbook_of({"run": [("time [s]", "tyre.force [N]"), (0.0, value), (0.01, 1.0)]})
    )
    found = jn.read_columns(file, {"tyre.force": "N"})[0]["tyre.force"]
    assert found[0] == value


def test_what_a_sheet_cannot_hold(tmp_path: Path, monkeypatch) -> None:
    for value in (np.nan, np.inf):
        with pytest.raises(
            OutputError, match=r"tyre\.force: a sheet can store only finite numbers.*Write \.nc"
        ):
            jn.write_recording(recording([*range(8), value]), tmp_path / "a.xlsx")
    monkeypatch.setattr(writers, "MOST_ROWS", 3)
    with pytest.raises(
        OutputError, match=r"more than an Excel sheet can store; found '10 rows, 2 columns'"
    ):
        jn.write_recording(recording(), tmp_path / "a.xlsx")
    assert not list(tmp_path.iterdir())


NO_NUMBERS = {
    "a date": datetime(2026, 5, 3, 12),  # noqa: DTZ001 - as Excel has it
    "a time of day": time(0, 0),
    "a duration": timedelta(0),
    "a truth value": False,
    "an error": "#DIV/0!",
}


@pytest.mark.parametrize("heads", [
    [["time [s]", "sprung.az [m/s^2]", "tyre.force [N]"]], [["time [s]", "sprung.az", "tyre.force [N]"]],
    [["time", "sprung.az", "tyre.force"], ["s", "m/s^2", "N"]],
])  # fmt: skip
@pytest.mark.parametrize("rows", [range(50), [20]], ids=["all", "one"])
@pytest.mark.parametrize("kind", NO_NUMBERS)
def test_cells_of_a_channel_that_are_no_numbers(
    tmp_path: Path, kind: str, rows: list[int], heads: list[list[str]]
) -> None:
    """A duration was read as seconds (a number that is shown as hours is one), and such a column was left out."""
    table = [[t, NO_NUMBERS[kind] if i in rows else 1.0, f] for i, (t, f) in enumerate(SAMPLES)]
    file = book(tmp_path / "a.xlsx", run=[*heads, *table])
    cell = rf"sheet 'run', cell B{rows[0] + 1 + len(heads)} \(column 'sprung\.az.*{kind} in a column of numbers; found"
    with pytest.raises(RecordingError, match=cell + r".*format it as a number"):
        jn.read_recording(file)
    assert jn.read_columns(file, {"tyre.force": "N"})[0]["tyre.force"].size == len(SAMPLES)


@pytest.mark.parametrize("kind", NO_NUMBERS)
def test_cells_of_a_clock_that_are_of_another_kind(tmp_path: Path, kind: str) -> None:
    table = [[NO_NUMBERS[kind] if i == 20 else t, f] for i, (t, f) in enumerate(SAMPLES)]
    with pytest.raises(
        RecordingError, match=rf"cell A22 \(column 'time \[s\]'\): {kind} in a column of numbers"
    ):
        jn.read_recording(book(tmp_path / "a.xlsx", run=[["time [s]", "tyre.force [N]"], *table]))


def _second_of_a_day(seconds):
    return datetime(2026, 5, 3, second=seconds)  # noqa: DTZ001 - as Excel has it


@pytest.mark.parametrize("instant", [timedelta, _second_of_a_day])
def test_a_unit_that_is_none_of_time_stays(tmp_path: Path, instant) -> None:
    """A column that is no channel: its values were seconds, whatever its unit said."""
    rows = [
        ["time [s]", "heat [degC]"],
        *([t, instant(seconds=i)] for i, (t, _) in enumerate(SAMPLES)),
    ]
    with pytest.raises(RecordingError, match=r"cell B2 \(column 'heat \[degC\]'\): a d"):
        jn.read_columns(book(tmp_path / "a.xlsx", run=rows), {"heat": "s"})
