"""Text files of LabVIEW, written here in the grammar of its specification: synthetic, no file of a laboratory."""

from __future__ import annotations

import numpy as np
import pytest

from jounce.core.errors import RecordingError
from jounce.recordings import read_recording

TIME = 0.25 + np.arange(40) * 1e-3
BODY, HEIGHT = np.sin(40.0 * TIME), 5.0 * np.cos(20.0 * TIME)


def written(path, *, columns="One", mark=".", separator="Tab", steps=("0.001", "0.001"), segments=1, special=""):
    """Write two channels, in g and mm."""
    between = {"Tab": "\t", "Comma": ","}[separator]

    def row(*cells):
        return between.join(cells)

    def number(value):
        return f"{value:.7f}".replace(".", mark)

    head = [row("LabVIEW Measurement"), row("Writer_Version", "2"), row("Separator", separator)]
    head += [row("Decimal_Separator", mark), row("X_Columns", columns), row("Date", "2024/05/06")]
    head += [row("***End_of_Header***"), ""]
    segment = [row("Channels", "2"), row("Samples", "40", "40"), row("Y_Unit_Label", "g", "mm"), *special.splitlines()]
    segment += [row("X_Dimension", "Time", "Time"), row("X0", *[number(0.25)] * 2)]
    segment += [row("Delta_X", *(step.replace(".", mark) for step in steps)), row("***End_of_Header***", "", "")]
    names = ("X_Value", "sprung.az", *(["X_Value"] if columns == "Multi" else []), "sprung.z", "Comment")
    segment.append(row(*names))
    for t, a, z in zip(TIME, BODY, HEIGHT, strict=True):
        first = "" if columns == "No" else number(t)
        segment.append(row(first, number(a), *([first] if columns == "Multi" else []), number(z)))
    path.write_text("\r\n".join([*head, *segment * segments, ""]), newline="")
    return path


@pytest.mark.parametrize("name", ["run.lvm", "run.txt"])
@pytest.mark.parametrize(
    "how",
    [
        {},
        {"columns": "No"},
        {"columns": "Multi"},
        {"mark": ","},
        {"mark": ",", "columns": "No"},
        {"separator": "Comma"},
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
    [({"segments": 2}, "found '2 segments'"), ({"steps": ("0.001", "0.01")}, "channels begin or step differently")],
)
def test_what_is_no_one_table_is_refused(tmp_path, how, said):
    with pytest.raises(RecordingError, match=said):
        read_recording(written(tmp_path / "run.lvm", **how))


def test_channels_whose_times_differ_are_refused_whatever_the_header_says(tmp_path):
    file = written(tmp_path / "run.lvm", columns="Multi")
    lines = file.read_text().splitlines()
    cells = lines[-1].split("\t")
    lines[-1] = "\t".join([*cells[:2], "0.3400000", *cells[3:]])
    file.write_text("\n".join(lines))
    with pytest.raises(RecordingError, match=f"line {len(lines)}: channels begin or step.*0.2890000 and 0.34"):
        read_recording(file)


def test_times_that_count_from_a_far_past_follow_from_their_step(tmp_path):
    file = written(tmp_path / "run.lvm", columns="No")
    file.write_text(file.read_text().replace("0.2500000", "3660000000.0"))
    record, _ = read_recording(file)
    assert np.diff(record["time"].to_numpy()) == pytest.approx(np.full(39, 1e-3), abs=1e-6)


@pytest.mark.parametrize(
    ("columns", "told", "said"),
    [("One", 38, "rows were added to it"), ("No", 41, "it was cut off; what is there was read"), ("No", 40, None)],
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
    with pytest.raises(RecordingError, match=r"found 'no data'.*Is the file whole\?"):
        read_recording(tmp_path / "cut.lvm")
    with pytest.raises(RecordingError, match="not a LabVIEW measurement file"):
        read_recording(tmp_path / "other.lvm")
