"""Text files of LabVIEW: two that it wrote (tests/files/labview), and synthetic ones written here in their layout."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from jounce.core.errors import RecordingError
from jounce.recordings import read_recording
from jounce.recordings.reader import ReaderOptions
from jounce.recordings.readers import read_signals

FILES = Path(__file__).parents[2] / "files" / "labview"
TIME = 0.25 + np.arange(40) * 1e-3
BODY, HEIGHT = np.sin(40.0 * TIME), 5.0 * np.cos(20.0 * TIME)


def written(
    path,
    *,
    columns="One",
    mark=".",
    separator="Tab",
    header=None,
    times=(TIME, TIME),
    digits=7,
    segments=1,
    special="",
):
    """Write two channels, in g and mm, in the layout of LabVIEW; ``header`` replaces or leaves out what it says."""
    between = {"Tab": "\t", "Comma": ","}[separator]
    is_multi = columns == "Multi"

    def row(*cells):
        return between.join(cells)

    def number(value):
        return f"{value:.{digits}f}".replace(".", mark)

    def of_channels(tag, first, second):
        return row(tag, first, *[""] * is_multi, second, "")

    says = {"Samples": ("40", "40"), "Y_Unit_Label": ("g", "mm"), "X_Dimension": ("Time", "Time")}
    says |= {"X0": (number(0.25),) * 2, "Delta_X": (number(1e-3),) * 2} | (header or {})
    head = [row("LabVIEW Measurement", ""), row("Writer_Version", "2"), row("Separator", separator)]
    head += [row("Decimal_Separator", mark), row("X_Columns", columns), row("Date", "2024/05/06")]
    head += [row("***End_of_Header***", ""), row("", "")]
    segment = [of_channels("Channels", "2", ""), *special.splitlines()]
    segment += [of_channels(tag, *cells) for tag, cells in says.items() if cells]
    segment += [of_channels("***End_of_Header***", "", "")]
    segment.append(row("X_Value", "sprung.az", *["X_Value"] * is_multi, "sprung.z", "Comment"))
    for *instants, a, z in zip(*times, BODY, HEIGHT, strict=True):
        first, second = ("" if columns == "No" or t is None else number(t) for t in instants)
        segment.append(row(first, number(a), *[second] * is_multi, number(z)))
    path.write_text("\r\n".join([*head, *segment * segments, ""]), newline="")
    return path


def with_line(file, number, line):
    """Replace a line of a file, from 0."""
    lines = file.read_text().splitlines()
    lines[number] = line
    file.write_text("\n".join([*lines, ""]))
    return file


@pytest.mark.parametrize("name", ["run.lvm", "run.txt"])
@pytest.mark.parametrize(
    "how",
    [
        {},
        {"columns": "No"},
        {"columns": "Multi"},
        {"columns": "Multi", "separator": "Comma"},
        {"columns": "Multi", "mark": ","},
        {"mark": ","},
        {"mark": ",", "columns": "No"},
        {"separator": "Comma"},
        {"columns": "No", "header": {"X_Dimension": None, "Samples": None}},
        {"special": "***Start_Special***\nX0\tnothing\n***End_Special***"},
    ],
)
def test_channels_have_their_units_and_times(tmp_path, name, how):
    record, findings = read_recording(written(tmp_path / name, **how))
    assert record["time"].to_numpy() == pytest.approx(TIME, abs=1e-9)
    assert record["sprung.az"].to_numpy() == pytest.approx(9.80665 * BODY, abs=1e-5)
    assert record["sprung.z"].to_numpy() == pytest.approx(1e-3 * HEIGHT, abs=1e-9)
    assert all("decimal commas" in one.message for one in findings)


@pytest.mark.parametrize(
    ("how", "said"),
    [
        ({"segments": 2}, "found '2 segments'"),
        (
            {"header": {"Delta_X": ("0.001", "0.01")}},
            "Delta_X: the channels have different start times or steps; found '0.001 s and 0.01 s'",
        ),
        (
            {"header": {"X0": ("0", "0.1")}, "columns": "Multi"},
            "X0: the channels have different start times or steps; found '0 s and 0.1",
        ),
        (
            {"header": {"X_Dimension": ("Time", "Frequency")}},
            "no time signals; found 'Frequency'",
        ),
        (
            {"header": {"Delta_X": ("NaN", "NaN")}},
            "Delta_X: invalid number of seconds; found 'NaN'",
        ),
        ({"header": {"X0": None, "Delta_X": None}, "columns": "No"}, "time is zero in every row"),
    ],
)
def test_what_is_no_one_table_is_refused(tmp_path, how, said):
    with pytest.raises(RecordingError, match=said):
        read_recording(written(tmp_path / "run.lvm", **how))


@pytest.mark.parametrize(
    ("name", "labels", "rows"),
    [
        (
            "multi_time_column.lvm",
            ["time [s]", "Voltage [Volts]", "Acceleration [g]"],
            [
                [0.0, -0.035229, 0.532608],
                [1.953125e-5, -0.034882, 0.502991],
                [3.90625e-5, -0.034191, 0.467541],
            ],
        ),
        (
            "x_columns_multi.lvm",
            ["time [s]", "Untitled", "Untitled 1"],
            [[0.0, 1.0, 4.0], [1.0, 2.5, 5.0], [2.0, -3.25, 6.0]],
        ),
    ],
)
def test_files_of_labview_with_a_column_of_times_for_each_channel(name, labels, rows):
    table = read_signals(FILES / name, ReaderOptions()).columns
    assert [column.label for column in table] == labels
    assert np.column_stack([column.values for column in table]) == pytest.approx(
        np.array(rows), rel=1e-12
    )


@pytest.mark.parametrize("columns", ["No", "One", "Multi"])
@pytest.mark.parametrize("units", [("", "mm"), ("g", "")])
def test_a_unit_that_is_missing_is_that_of_its_own_channel(tmp_path, columns, units):
    file = written(tmp_path / "run.lvm", columns=columns, header={"Y_Unit_Label": units})
    assert [column.unit for column in read_signals(file, ReaderOptions()).columns] == ["s", *units]


def test_what_the_header_says_of_a_column_of_times_is_refused(tmp_path):
    file = written(tmp_path / "run.lvm", columns="Multi")
    file.write_text(file.read_text().replace("Y_Unit_Label\tg\t\tmm", "Y_Unit_Label\tg\tmm"))
    with pytest.raises(
        RecordingError,
        match=r"Y_Unit_Label: the header has an entry for a column of X .*'mm' in column 3",
    ):
        read_recording(file)


@pytest.mark.parametrize("step", [None, ("1.0", "1.0"), ("0.001", "0.001")])
def test_channels_whose_times_differ_are_refused_whatever_the_header_says(tmp_path, step):
    how = {"columns": "Multi", "digits": 12, "header": {"Delta_X": step}}
    late = TIME + np.where(np.arange(40) == 39, 2e-6, 0.0)
    with pytest.raises(
        RecordingError,
        match=r"line 5[56]: the channels have different start times or steps.*0.289000000000 s and 0.289002000000 s",
    ):
        read_recording(written(tmp_path / "late.lvm", times=(TIME, late), **how))
    record, findings = read_recording(
        written(tmp_path / "same.lvm", times=(TIME, TIME + 1e-12), **how)
    )
    assert record["time"].to_numpy() == pytest.approx(TIME, abs=1e-9)
    assert not findings


@pytest.mark.parametrize(
    ("columns", "cells"),
    [("One", "{}\t1\t1"), ("Multi", "{}\t1\t0.289\t1"), ("Multi", "0.289\t1\t{}\t1")],
)
@pytest.mark.parametrize("cell", ["n/a", "NaN", "Inf"])
def test_a_time_that_is_no_number_is_named_by_its_line(tmp_path, columns, cells, cell):
    file = with_line(written(tmp_path / "run.lvm", columns=columns), -1, cells.format(cell))
    with pytest.raises(
        RecordingError, match=f"line 56: X_Value: invalid number of seconds; found '{cell}'"
    ):
        read_recording(file)


@pytest.mark.parametrize("shorter", [0, 1])
def test_a_channel_that_ends_earlier_leaves_the_times_to_the_other(tmp_path, shorter):
    file = written(tmp_path / "run.lvm", columns="Multi", header={"Delta_X": ("1.0", "1.0")})
    for row in (37, 38, 39):
        cells = [[f"{TIME[row]:.7f}", "1.0"], [f"{TIME[row]:.7f}", "2.0"]]
        cells[shorter] = [" ", " "]
        with_line(file, row - 40, "\t".join([*cells[0], *cells[1]]))
    table = read_signals(file, ReaderOptions()).columns
    assert table["time"].values == pytest.approx(TIME, abs=1e-9)
    rows, _ = table.columns[1 + shorter].part
    assert rows.tolist() == list(range(37))
    assert table[2 - shorter].values[-1] == 2.0 - shorter


def test_channels_without_samples_have_no_say(tmp_path):
    how = {"Samples": ("40", "0"), "Delta_X": ("0.001", "1.000000")}
    record, _ = read_recording(written(tmp_path / "run.lvm", header=how))
    assert record["time"].to_numpy() == pytest.approx(TIME, abs=1e-9)


def test_decimal_commas_that_the_header_does_not_tell_are_seen(tmp_path):
    file = written(tmp_path / "run.lvm", mark=",", columns="No")
    file.write_text(file.read_text().replace("Decimal_Separator\t,\n", ""))
    record, _ = read_recording(file)
    assert record["time"].to_numpy() == pytest.approx(TIME, abs=1e-9)


def test_points_beside_times_with_commas_are_read(tmp_path):
    """LabVIEW writes them where it is told to write points on a machine of commas."""
    file = written(tmp_path / "run.lvm", mark=",")
    head, names, rows = file.read_text().partition("Comment\n")
    rows = [
        time + "\t" + cells.replace(",", ".")
        for time, _, cells in (row.partition("\t") for row in rows.splitlines())
    ]
    file.write_text(head + names + "\n".join([*rows, ""]))
    record, _ = read_recording(file)
    assert record["time"].to_numpy() == pytest.approx(TIME, abs=1e-9)
    assert record["sprung.z"].to_numpy() == pytest.approx(1e-3 * HEIGHT, abs=1e-9)


@pytest.mark.parametrize("columns", ["One", "Multi"])
def test_times_of_six_decimals_are_those_of_the_header(tmp_path, columns):
    exact = 0.25 + np.arange(40) / 51200
    how = {"times": (exact, exact), "digits": 6, "header": {"Delta_X": ("1.953125E-5",) * 2}}
    record, findings = read_recording(written(tmp_path / "run.lvm", columns=columns, **how))
    assert record["time"].to_numpy() == pytest.approx(exact, abs=1e-12)
    assert not findings
    gap = with_line(written(tmp_path / "gap.lvm", columns=columns, **how), -5, "")
    with pytest.raises(RecordingError, match="1 sample missing there"):
        read_recording(gap)


@pytest.mark.parametrize(("rate", "begins"), [(1000, 3.66e9), (51200, 0.0)])
def test_times_that_count_from_a_far_past_follow_from_their_step(tmp_path, rate, begins):
    how = {"X0": ("3660000000.0",) * 2, "Delta_X": (f"{1 / rate!r}",) * 2}
    record, findings = read_recording(written(tmp_path / "run.lvm", columns="No", header=how))
    assert record["time"].to_numpy() == pytest.approx(
        begins + np.arange(40) / rate, abs=1e-6 if begins else 1e-12
    )
    assert not findings


@pytest.mark.parametrize(
    ("columns", "told", "said"),
    [
        ("One", 38, "rows were added"),
        ("No", 41, "it was cut off, and only the samples it contains were read"),
        ("No", 40, None),
    ],
)
def test_other_numbers_of_rows_than_the_header_announces_are_told(tmp_path, columns, told, said):
    file = written(tmp_path / "run.lvm", columns=columns)
    file.write_text(file.read_text().replace("Samples\t40\t40", f"Samples\t{told}\t{told}"))
    record, findings = read_recording(file)
    assert record.sizes["time"] == 40
    assert [one.message.rpartition(": ")[2] for one in findings] == ([said] if said else [])


def test_a_file_that_ends_in_its_header_and_another_text_are_refused(tmp_path):
    whole = written(tmp_path / "run.lvm").read_text()
    (tmp_path / "cut.lvm").write_text(whole[: whole.rindex("X_Dimension")])
    (tmp_path / "other.lvm").write_text("time [s], sprung.az [m/s^2]\n0, 1\n")
    with pytest.raises(RecordingError, match=r"found 'no data'.*Is the file complete\?"):
        read_recording(tmp_path / "cut.lvm")
    (tmp_path / "bare.lvm").write_text(whole.replace("X_Value\tsprung.az", "sprung.az"))
    with pytest.raises(
        RecordingError, match=r"line 16: the column names are missing; found 'sprung.az'"
    ):
        read_recording(tmp_path / "bare.lvm")
    with pytest.raises(RecordingError, match="not a LabVIEW measurement file"):
        read_recording(tmp_path / "other.lvm")


STAMPS = {"Date": ("2024/05/06", "2024/05/06"), "Time": ("10:45:47,0352", "10:45:47,0352")}


@pytest.mark.parametrize("columns", ["One", "Multi", "No"])
@pytest.mark.parametrize(
    ("day", "time"),
    [
        ("2024/05/06", "10:45:47,1352"),
        ("2024/05/07", "10:45:47,0352"),
        ("2024/05/06", "10:45:47,0354"),
        ("never", "x"),
    ],
)
def test_channels_that_began_at_different_times_of_the_day_are_refused(
    tmp_path, columns, day, time
):
    """They were read as if they had begun together: X0 counts from each one's own stamp."""
    header = {"Date": ("2024/05/06", day), "Time": ("10:45:47,0352", time)}
    file = written(tmp_path / "run.lvm", columns=columns, header=header)
    with pytest.raises(
        RecordingError,
        match=r"Date, Time: the channels have different start times or steps; found '2024/05/06 10:45",
    ):
        read_recording(file)


@pytest.mark.parametrize("second", ["10:45:47,0352", "10:45:47.035209", ""])
def test_stamps_that_are_the_same_within_a_tenth_of_a_step_are(tmp_path, second):
    header = STAMPS | {"Time": ("10:45:47,0352", second)}
    run, _ = read_recording(written(tmp_path / "run.lvm", columns="Multi", header=header))
    plain, _ = read_recording(written(tmp_path / "plain.lvm", columns="Multi"))
    assert run.equals(plain)


def test_stamps_of_many_decimals_are_told_apart_by_no_more_than_they_are(tmp_path):
    """Of seconds since some year floats hold 1e-7 s: at 1 MHz that was a tenth of a step."""
    stamps = {
        "Date": ("2024/05/06",) * 2,
        "Time": ("10:45:47.0352557312499836422", "10:45:47.03525573"),
    }
    header = stamps | {"X0": ("0", "0"), "Delta_X": ("1E-6", "1E-6")}
    run, _ = read_recording(written(tmp_path / "run.lvm", columns="No", header=header))
    assert float(run["time"][1]) == pytest.approx(1e-6)


def test_times_that_jitter_by_more_than_their_last_decimal_are_no_rounded_ones(tmp_path):
    """They were those of the header, though nine decimals were written."""
    count, step = len(BODY), 1e-5
    jitter = 4.5e-7 * np.sin(7.0 * np.arange(count))
    times = step * np.arange(count) + jitter
    how = {"header": {"X0": ("0", "0"), "Delta_X": ("0.000010", "0.000010")}, "digits": 9}
    with pytest.raises(RecordingError, match=r"the time step jitters by 3\.\d+ %"):
        read_recording(written(tmp_path / "run.lvm", times=(times, times), **how))


def test_times_far_from_zero_are_rounded_ones_as_floats_hold_them(tmp_path):
    start, step = 3_660_000_000.123457, 1.953125e-5
    times = start + step * np.arange(len(BODY))
    how = {"header": {"X0": (repr(start),) * 2, "Delta_X": (repr(step),) * 2}, "digits": 6}
    run, _ = read_recording(written(tmp_path / "run.lvm", times=(times, times), **how))
    assert np.diff(run["time"].to_numpy()) == pytest.approx(step, rel=1e-9)
