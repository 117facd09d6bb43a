"""Channels of several rates in one file: each is read at its own instants, and what lies between them is told.

The files are synthetic, in the grammars of loggers: rows with blank cells and a time column for each rate as TwinCAT's
Scope exports them ("Timelines", "Interpolation: None", https://infosys.beckhoff.com, TE13xx), the heads of MoTeC i2 and
AiM Race Studio as public programs write and parse them.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from jounce.core import columns
from jounce.core.errors import RecordingError, ResourceError
from jounce.core.types import Array
from jounce.recordings import read_columns, read_recording, write_recording

FAST = np.arange(1000) * 0.001
EVERY = 8
SLOW = FAST[::EVERY]
BOTH = {"time": "Zeit", "sprung.az": "acc", "strut.deflection": "travel [mm]"}


def acceleration(time: Any) -> Array:
    return np.asarray(3.0 * np.sin(2.0 * np.pi * 9.0 * time), dtype=float)


def travel(time: Any) -> Array:
    return np.asarray(0.02 * np.cos(2.0 * np.pi * 2.0 * time), dtype=float)


def with_blanks(
    missing: str = "", drop: tuple[int, ...] = (), comma: bool = False, clock: str = "Zeit [s]"
) -> str:
    cells = [
        f"{t:.3f};{acceleration(t):.7f};"
        + (f"{1e3 * travel(t):.7f}" if i % EVERY == 0 and i not in drop else missing)
        for i, t in enumerate(FAST)
    ]
    rows = "\n".join(cells)
    return f"{clock};acc [m/s^2];travel [mm]\n" + (rows.replace(".", ",") if comma else rows) + "\n"


def with_two_times(
    first: str = "Zeit 1 [s]", second: str = "Zeit 2 [s]", delay: float = 0.0
) -> str:
    slow = [f"{t + delay:.4f};{1e3 * travel(t + delay):.7f}" for t in SLOW] + [";"] * (
        FAST.size - SLOW.size
    )
    rows = [f"{t:.3f};{acceleration(t):.7f};{late}" for t, late in zip(FAST, slow, strict=True)]
    return f"{first};acc [m/s^2];{second};travel [mm]\n" + "\n".join(rows) + "\n"


def held_to_truth(file: Path, text: str, **told: Any) -> list[str]:
    """Read it, hold both channels against the truth; what was found."""
    file.write_text(text)
    run, findings = read_recording(file, **{"columns": BOTH, **told})
    time = run["time"].to_numpy()
    assert float(time[1] - time[0]) == pytest.approx(0.001)
    assert (time[0], time[-1]) >= (0.0, 0.99)
    assert time[-1] <= SLOW[-1] + 0.0041  # nothing is made up behind the last sample
    np.testing.assert_allclose(run["sprung.az"], acceleration(time), atol=1e-6)
    np.testing.assert_allclose(
        run["strut.deflection"], travel(time), atol=2e-6
    )  # a staircase is 1e-3 m off
    assert run["strut.deflection"].attrs["recorded_rate"] == 125.0
    assert "recorded_rate" not in run["sprung.az"].attrs
    assert run.attrs["recorded_rates"] == "strut.deflection 125 Hz, between them a spline"
    return [found.message for found in findings]


@pytest.mark.parametrize("missing", ["", "NaN", "-", "#N/A", "#NV", "null"])
def test_blank_cells_between_the_samples_of_a_slower_channel(tmp_path: Path, missing: str) -> None:
    told = held_to_truth(tmp_path / "a.csv", with_blanks(missing))
    assert any(
        "recorded at 125 Hz, whereas the recording has 1000 Hz" in one
        and "nothing was measured above 62.5 Hz" in one
        for one in told
    )
    assert any("all channels were recorded only from 0 s to 0.992 s" in one for one in told)
    held_to_truth(tmp_path / "b.csv", with_blanks(missing, comma=True))


def test_a_time_column_for_each_rate(tmp_path: Path) -> None:
    plain = {name: at for name, at in BOTH.items() if name != "time"}
    for first, second in (
        ("Zeit 1 [s]", "Zeit 2 [s]"),
        ("time [s]", "time [s]"),
        ("Time - acc (s)", "Time - travel (s)"),
    ):
        for delay in (0.0, 0.0004):
            held_to_truth(tmp_path / "a.csv", with_two_times(first, second, delay), columns=plain)
    held_to_truth(tmp_path / "a.csv", with_two_times(), columns=plain | {"time": "Zeit 1"})
    held_to_truth(tmp_path / "a.csv", with_two_times(), columns=plain | {"time": "Zeit 2"})


def test_rows_of_two_clocks_put_together(tmp_path: Path) -> None:
    other: Any = 0.0004 + np.arange(330) * 0.003
    rows = {t: f"{acceleration(t):.7f};" for t in FAST} | {
        t: f";{1e3 * travel(t):.7f}" for t in other
    }
    text = "time [s];sprung.az [m/s^2];strut.deflection [mm]\n" + "\n".join(
        f"{t:.4f};{rows[t]}" for t in sorted(rows)
    )
    (tmp_path / "a.csv").write_text(text + "\n")
    run, _ = read_recording(tmp_path / "a.csv")
    time = run["time"].to_numpy()
    assert (time[0], time[-1], run["strut.deflection"].attrs["recorded_rate"]) == pytest.approx(
        (0.001, 0.987, 1000 / 3)
    )
    np.testing.assert_allclose(run["sprung.az"], acceleration(time), atol=1e-6)
    np.testing.assert_allclose(run["strut.deflection"], travel(time), atol=1e-6)


def test_a_step_in_place_of_time_is_that_of_the_rows(tmp_path: Path) -> None:
    plain = {name: at for name, at in BOTH.items() if name != "time"}
    held_to_truth(tmp_path / "a.csv", with_blanks(), columns=plain, sample_time="1 ms")
    held_to_truth(tmp_path / "a.csv", with_blanks(clock="Zeit"), sample_time="1 ms")


def test_gaps_are_no_rate(tmp_path: Path) -> None:
    file = tmp_path / "a.csv"
    for drop in ((80,), (80, 88, 400)):
        file.write_text(with_blanks(drop=drop))
        with pytest.raises(
            RecordingError, match=r"line 3: column 'travel \[mm\]': the cell is blank.*resample"
        ):
            read_recording(file, columns=BOTH)
        run, findings = read_recording(file, columns=BOTH, resample="1 ms")
        widest = 0.016 if len(drop) == 1 else 0.024
        assert any(f"of strut.deflection is {widest:g} s" in one.message for one in findings)
        np.testing.assert_allclose(
            run["strut.deflection"], travel(run["time"].to_numpy()), atol=3e-5
        )
    file.write_text(with_blanks().replace("\n0.500;", "\n0.500;-", 1).replace("0.500;-", "0.500;x"))
    with pytest.raises(RecordingError, match=r"line 502.*text in a number column"):
        read_recording(file, columns=BOTH)
    file.write_text(with_blanks())
    with pytest.raises(RecordingError, match=r"line 3: column 'travel \[mm\]': the cell is blank"):
        read_columns(file, {"acc": "m/s^2", "travel": "m"})


def test_a_channel_as_fast_as_its_samples_is_doubted(tmp_path: Path) -> None:
    rng = np.random.default_rng(5)
    rows = [
        f"{t:.3f};{acceleration(t):.6f};{f'{rng.normal():.4f}' if i % EVERY == 0 else ''}"
        for i, t in enumerate(FAST)
    ]
    (tmp_path / "a.csv").write_text(
        "time [s];sprung.az [m/s^2];strut.deflection [mm]\n" + "\n".join(rows)
    )
    _, findings = read_recording(tmp_path / "a.csv")
    (found,) = [one for one in findings if "recorded at" in one.message]
    assert (found.severity, found.value) == ("warning", 125.0)
    assert "of the power is above 31.25 Hz" in found.message


def test_marks_of_lower_rates_are_written_and_read(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text(with_blanks())
    run, _ = read_recording(tmp_path / "a.csv", columns=BOTH)
    again, _ = read_recording(write_recording(run, tmp_path / "a.nc"))
    assert again.attrs["recorded_rates"] == run.attrs["recorded_rates"]


def test_heads_of_loggers(tmp_path: Path) -> None:
    rows = [f'"{t:.3f}","{acceleration(t):.6f}","{1e3 * travel(t):.6f}","3"' for t in FAST]
    motec = ['"Format","MoTeC CSV File",,,"Workbook",""', '"Venue","Ring",,,"Worksheet",""',
             '"Sample Rate","1000.000","Hz",,"End Time","0.999","s"', '"Beacon Markers","10.2 33.1"', "", "",
             '"Time","sprung.az","strut.deflection","Gear"', '"s","m/s/s","mm",""', "", ""]  # fmt: skip
    aim = ['"Format","AiM CSV File"', '"Session","Test"', '"Time","10:00 AM"', '"Sample Rate","1000"',
           '"Segment Times","1:24.430","1:15.77"', "", '"Time","sprung.az","strut.deflection","GPS Nsat"',
           '"sec","m/s^2","mm","#"', "", ""]  # fmt: skip
    for head in (motec, aim):
        (tmp_path / "a.csv").write_text("\r\n".join([*head, *rows]) + "\r\n")
        run, findings = read_recording(tmp_path / "a.csv")
        np.testing.assert_allclose(run["time"], FAST, atol=1e-12)
        np.testing.assert_allclose(run["sprung.az"], acceleration(FAST), atol=1e-6)
        np.testing.assert_allclose(run["strut.deflection"], travel(FAST), atol=1e-8)
        assert any("is used as the time" in one.message for one in findings)


@pytest.mark.parametrize(
    ("stamp", "start"),
    [
        (
            lambda t: (
                f"{12 + (t + 3599.5) // 3600:02.0f}:{(t + 3599.5) % 3600 // 60:02.0f}:{(t + 59.5) % 60:06.3f}"
            ),
            "",
        ),
        (
            lambda t: (
                f"23:59:{59.5 + t:06.3f}" if t < 0.5 else f"00:00:{t - 0.5:06.3f}".replace(".", ",")
            ),
            "midnight",
        ),
        (
            lambda t: (
                f"2026-03-29T{'01:59' if t < 0.5 else '03:00'}:{(t + 59.5) % 60:06.3f}+0{1 + (t >= 0.5)}:00"
            ),
            "",
        ),
        (
            lambda t: (
                f"2026-02-28 23:59:{59.5 + t:06.3f}"
                if t < 0.5
                else f"2026-03-01 00:00:{t - 0.5:06.3f}"
            ),
            "",
        ),
    ],
)
def test_clocks_of_day_and_of_the_calendar(
    tmp_path: Path, stamp: Callable[[float], str], start: str
) -> None:
    rows = "\n".join(f"{stamp(round(t, 6))};{acceleration(t):.6f}" for t in FAST)
    (tmp_path / "a.csv").write_text("time;sprung.az [m/s^2]\n" + rows + "\n")
    run, findings = read_recording(tmp_path / "a.csv")
    np.testing.assert_allclose(run["time"], FAST, atol=1e-9)
    assert start in findings[0].message
    for wrong in (rows.replace("\n", "\nx", 1), rows.splitlines()[5] + "\n" + rows):
        (tmp_path / "a.csv").write_text("time;sprung.az [m/s^2]\n" + wrong + "\n")
        with pytest.raises(RecordingError, match=r"text in a number column|does not increase"):
            read_recording(tmp_path / "a.csv")


@pytest.mark.parametrize("name", ["time of day [s]", "Time lap [s]", "t_oil [s]", "time 2 [s]"])
def test_other_times_of_the_same_rows_are_no_clocks(tmp_path: Path, name: str) -> None:
    """A lap's time or one of day beside the clock; one that is called as the clock is and goes otherwise is one."""
    scale, zero = (1.0, 4e4) if "day" in name else (2.0, 0.0)
    rows = [
        f"{t:.3f};{acceleration(t):.6f};{scale * t + zero:.3f};{1e3 * travel(t):.6f}" for t in FAST
    ]
    (tmp_path / "a.csv").write_text(
        f"time [s];sprung.az [m/s^2];{name};strut.deflection [mm]\n" + "\n".join(rows)
    )
    run, _ = read_recording(tmp_path / "a.csv")
    if name == "time 2 [s]":
        assert run["strut.deflection"].attrs["recorded_rate"] == 500.0
        np.testing.assert_allclose(
            run["strut.deflection"], travel(0.5 * run["time"].to_numpy()), atol=1e-6
        )
    else:
        np.testing.assert_allclose(run["time"], FAST, atol=1e-12)
        np.testing.assert_allclose(run["strut.deflection"], travel(FAST), atol=1e-6)


def test_cells_that_are_no_numbers_are_shown(tmp_path: Path) -> None:
    for cells in ("50 %", "0x1f", "True", "20\u00a0000"):
        rows = "\n".join(f"{t:.3f};{cells}" for t in FAST[:20])
        (tmp_path / "a.csv").write_text("time [s];strut.force [N]\n" + rows, encoding="utf-8")
        with pytest.raises(
            RecordingError,
            match=rf"line 2: column 'strut.force \[N\]': text .*; found '{cells[:2]}",
        ):
            read_recording(tmp_path / "a.csv")


def test_names_that_differ_by_case_are_told(tmp_path: Path) -> None:
    rows = "\n".join(f"{t:.3f};{acceleration(t):.6f};{acceleration(t):.6f}" for t in FAST)
    (tmp_path / "a.csv").write_text("time [s];sprung.az [m/s^2];Sprung.az [cm/s^2]\n" + rows)
    _, findings = read_recording(tmp_path / "a.csv")
    assert "names differ only by case: sprung.az, Sprung.az" in findings[0].message


def test_a_text_that_no_memory_holds_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "a.csv").write_text(with_blanks())
    read_recording(tmp_path / "a.csv", columns=BOTH)
    monkeypatch.setattr(columns, "_MEMORY_A_BYTE", 1_000_000_000_000)
    if Path("/proc/meminfo").exists():
        with pytest.raises(
            ResourceError, match=r"the file needs more memory than is available.*GB of text"
        ):
            read_recording(tmp_path / "a.csv", columns=BOTH)


def test_faces_show_the_rates(tmp_path: Path) -> None:
    """The workbench's page of imports and ``jounce check`` say what the reader says."""
    from jounce.operations.checks import check_file
    from jounce.web.questions import preview

    file = tmp_path / "a.csv"
    file.write_text(
        with_blanks(clock="time [s]")
        .replace("acc [", "sprung.az [")
        .replace("travel [", "strut.deflection [")
    )
    asked = dict.fromkeys(
        ("variable", "sample_time", "resample", "stroke_positive", "force_positive"), ""
    )
    shown = preview({"files": [str(file)], "form": "recording", "columns": {}, **asked})
    assert [column["count"] for column in shown["columns"]] == [1000, 1000, 125]
    told = [found["message"] for found in shown["findings"]]
    assert all(text in str(note) for text, note in zip(told, check_file(file).notes, strict=True))
    assert "recorded at 125 Hz" in told[1]


def test_marks_that_may_separate_thousands_are_refused(tmp_path: Path) -> None:
    newtons = (1000.0 + 400.0 * np.sin(20.0 * FAST)).round().astype(int)
    for mark in ".,":
        force = [
            str(one) if one < 1000 else f"{one // 1000}{mark}{one % 1000:03}" for one in newtons
        ]
        text = (
            "time [ms];strut.force [N]\n"
            + "\n".join(f"{i};{one}" for i, one in enumerate(force))
            + "\n"
        )
        (tmp_path / "a.csv").write_text(text)
        with pytest.raises(
            RecordingError,
            match=rf"line \d+\): all marks are followed by three digits|'1\{mark}000'",
        ):
            read_recording(tmp_path / "a.csv")
        decimals = text.replace(
            f"1{mark}000\n", f"1{mark}5\n"
        )  # with that, they can only be decimals
        (tmp_path / "a.csv").write_text(decimals)
        assert read_recording(tmp_path / "a.csv")[0]["strut.force"].max() < 1000.0
    for between in ",;":  # whether a comma separates the columns, too, or not
        big = "\n".join(f'{i}{between}"{20 + i // 500},{i % 500:03}"' for i in range(1000))
        (tmp_path / "a.csv").write_text(f"time [ms]{between}strut.force [N]\n{big}\n")
        if between == ";":
            assert "if they separate thousands" in read_recording(tmp_path / "a.csv")[1][0].message
        else:
            with pytest.raises(RecordingError, match="thousands separators, or decimals"):
                read_recording(tmp_path / "a.csv")


@pytest.mark.parametrize("step", [1e-13, 1e-99, 5e-324])
@pytest.mark.parametrize("option", ["sample_time", "resample"])
def test_a_step_shorter_than_that_of_any_logger(tmp_path: Path, option: str, step: float) -> None:
    """A decay at such a sample time was an internal error of its fit."""
    (tmp_path / "a.csv").write_text(
        "time [s],sprung.z [mm]\n" + "".join(f"{i},{i}\n" for i in range(20))
    )
    with pytest.raises(
        RecordingError, match=r"a\.csv: the (sample time|step to resample to) is too short; found"
    ):
        read_recording(tmp_path / "a.csv", **{option: step})
