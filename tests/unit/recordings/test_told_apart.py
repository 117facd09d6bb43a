"""Files as loggers and colleagues write them: clocks, units, headers and signs that contradict themselves."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from jounce.core.errors import DescriptionError, RecordingError
from jounce.recordings import read_recording
from jounce.recordings.plausibility import implausible

TIME = np.arange(1000) * 0.002
ACCELERATION = 3.0 * np.sin(9.0 * TIME) + 0.4 * np.cos(60.0 * TIME)
STROKE = 0.02 * np.sin(9.0 * TIME)


def written(file: Path, header: str, *columns: np.ndarray, separator: str = ",") -> Path:
    rows = (separator.join(f"{value:.8g}" for value in row) for row in zip(*columns, strict=True))
    file.write_text("\n".join([*([header] if header else []), *rows]) + "\n")
    return file


@pytest.mark.parametrize(("rate", "told"), [(500.0, True), (125.0, True), (50.0, True)])
def test_seconds_called_milliseconds_are_doubted(tmp_path: Path, rate: float, told: bool) -> None:
    time = np.arange(1000) / rate
    file = written(
        tmp_path / "a.csv",
        "time [ms], sprung.az [m/s^2]",
        time,
        np.interp(time, TIME, ACCELERATION),
    )
    _, findings = read_recording(file)
    assert any("s rather than ms" in one.message for one in findings) is told


@pytest.mark.parametrize(("rate", "count"), [(50e3, 100_000), (20e3, 20_000), (1e3, 200)])
def test_fast_and_short_records_are_not_doubted(rate: float, count: int) -> None:
    values = np.sin(np.arange(count) * 0.01)
    assert implausible({"sprung.az": values}, 1.0 / rate, where="a.csv") == []


@pytest.mark.parametrize(
    "names", [("strut.deflection", "strut.deflection_velocity"), ("displacement", "velocity")]
)
def test_a_rate_without_sign_or_with_the_other_one_is_told(names: tuple[str, str]) -> None:
    rate = np.gradient(STROKE, TIME)
    for given, severity, words in (
        (np.abs(rate), "problem", "absolute value of the rate"), (-rate, "warning", "with the opposite sign")
    ):  # fmt: skip
        (told,) = implausible(dict(zip(names, (STROKE, given), strict=True)), 0.002, where="")
        assert told.severity == severity
        assert words in told.message
    assert implausible(dict(zip(names, (STROKE, rate), strict=True)), 0.002, where="") == []


@pytest.mark.parametrize("suffix", [".dat", ".csv", ".txt"])
@pytest.mark.parametrize("separator", [",", ";", "\t", " "])
def test_text_is_read_without_a_header_and_as_dat(
    tmp_path: Path, suffix: str, separator: str
) -> None:
    file = written(tmp_path / f"a{suffix}", "", TIME, ACCELERATION, separator=separator)
    run, _ = read_recording(file, columns="time [s], sprung.az [m/s^2]")
    assert np.allclose(run["sprung.az"], ACCELERATION, atol=1e-6)
    with pytest.raises(RecordingError, match="names 3 columns, but the file has 2"):
        read_recording(file, columns="time [s], sprung.az [m/s^2], sprung.z [m]")
    with pytest.raises(RecordingError, match=r"the header is missing.*give all names in order"):
        read_recording(file)
    headed = written(tmp_path / f"b{suffix}", "time [s],sprung.az [g]".replace(",", separator), TIME, ACCELERATION,
                     separator=separator)  # fmt: skip
    assert np.allclose(read_recording(headed)[0]["sprung.az"], 9.80665 * ACCELERATION, atol=1e-6)


def test_lines_of_a_text_without_header_are_counted_as_they_stand(tmp_path: Path) -> None:
    file = tmp_path / "a.csv"
    file.write_text(
        "# bench 3\n" + "\n".join(f"{i}, {i % 7}" for i in range(20)).replace("8, 1", "8, half")
    )
    with pytest.raises(RecordingError, match="line 10"):
        read_recording(file, columns="time [s], sprung.az [m/s^2]")


def test_a_binary_dat_is_still_mdf(tmp_path: Path) -> None:
    file = tmp_path / "a.dat"
    file.write_bytes(b"MDF     3.30    nothing else")
    with pytest.raises(RecordingError, match="MDF"):
        read_recording(file)


def test_turning_is_read_in_any_unit(tmp_path: Path) -> None:
    names = "time [s], angular_velocity [deg/s], gyro/(rad/s), body.pitch_rate [°/s]"
    file = written(tmp_path / "a.csv", names, TIME, ACCELERATION, ACCELERATION, ACCELERATION)
    run, _ = read_recording(file, columns={"roll_rate": "gyro"})
    for name, factor in (
        ("angular_velocity", np.pi / 180.0),
        ("roll_rate", 1.0),
        ("body.pitch_rate", np.pi / 180.0),
    ):
        assert np.allclose(run[name], factor * ACCELERATION, atol=1e-6)
        assert run[name].attrs["units"] == "rad/s"


def test_a_channel_without_unit_that_nobody_maps_refuses_nothing(tmp_path: Path) -> None:
    header = "time [s], sprung.az [m/s^2], body.pitch_rate, wheel.force"
    file = written(tmp_path / "a.csv", header, TIME, ACCELERATION, STROKE, STROKE)
    run, (told,) = read_recording(file)
    assert list(run) == ["sprung.az"]
    assert (
        "body.pitch_rate = 'body.pitch_rate [rad/s]', wheel.force = 'wheel.force [N]'"
        in told.message
    )
    assert told.severity == "warning"
    mapped, _ = read_recording(file, columns={"wheel.force": "wheel.force [kN]"})
    assert np.allclose(mapped["wheel.force"], 1e3 * STROKE, atol=1e-4)
    with pytest.raises(RecordingError, match="the column has no unit"):
        read_recording(file, columns={"wheel.force": "wheel.force"})
    with pytest.raises(RecordingError, match="the column has no unit"):
        read_recording(written(tmp_path / "b.csv", "time [s], sprung.az", TIME, ACCELERATION))


def test_a_wrong_unit_of_a_header_is_overridden_as_the_message_says(tmp_path: Path) -> None:
    file = written(tmp_path / "a.csv", "time [s], sprung.az [N]", TIME, ACCELERATION)
    with pytest.raises(DescriptionError, match=r"--columns NAME='sprung\.az \[N\] \[m/s\^2\]'"):
        read_recording(file)
    with pytest.raises(RecordingError, match=r"'sprung\.az \[N\] \[m/s\^2\]'"):
        read_recording(file, columns={"sprung.az": "sprung.az [m/s^2]"})
    run, _ = read_recording(file, columns={"sprung.az": "sprung.az [N] [m/s^2]"})
    assert np.allclose(run["sprung.az"], ACCELERATION, atol=1e-6)
    large = written(tmp_path / "b.csv", "time [s], strut.deflection [m]", TIME, 1e3 * STROKE)
    _, (told,) = read_recording(large)
    assert told.message.endswith("Then map it as 'strut.deflection [m] [mm]' with columns")
    run, findings = read_recording(large, columns={"strut.deflection": "strut.deflection [m] [mm]"})
    assert np.allclose(run["strut.deflection"], STROKE, atol=1e-6)
    assert findings == []


def test_rows_of_a_sheet_are_chosen_and_named(tmp_path: Path) -> None:
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.title = "Run 1"
    for first in (0.0, 5.0):
        sheet.append(["time [s]", "sprung.az [m/s^2]", "note"])
        for i in range(12):
            sheet.append([0.01 * i, first + i % 3, "x"])
        sheet.append([])
    book.save(file := tmp_path / "a.xlsx")
    for variable, first in (
        ("Run 1!1:13", 0.0),
        ("!A15:C27", 5.0),
        ("Run 1!$A$15:$B$27", 5.0),
        ("run!15:27", None),
    ):
        if first is None:
            with pytest.raises(RecordingError, match="no sheet 'run'"):
                read_recording(file, variable=variable)
        else:
            run, _ = read_recording(file, variable=variable)
            assert run["sprung.az"].to_numpy()[:4].tolist() == [
                first,
                first + 1.0,
                first + 2.0,
                first,
            ]
            assert run.time.size == 12
    with pytest.raises(RecordingError, match="'Run 1!A5:D300'"):
        read_recording(file, variable="Run 1!A5")
    sheet["B5"] = "half"
    sheet["B18"] = None
    book.save(file)
    with pytest.raises(RecordingError, match=r"sheet 'Run 1', cell B5"):
        read_recording(file, variable="Run 1!1:13")
    with pytest.raises(RecordingError, match=r"sheet 'Run 1', row 18"):
        read_recording(file, variable="Run 1!15:27")
