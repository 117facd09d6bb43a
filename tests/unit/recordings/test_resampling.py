"""Irregular time is brought onto constant steps on request; what became of it is said, with the largest gap."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from jounce.core.errors import DescriptionError, RecordingError
from jounce.recordings import read_recording, resample


def truth(time: np.ndarray) -> np.ndarray:
    return 3.0 * np.sin(2.0 * np.pi * 1.3 * time) + 0.8 * np.cos(2.0 * np.pi * 11.0 * time)


def written(
    folder: Path, time: np.ndarray, values: np.ndarray, header: str = "time [s], sprung.az [m/s^2]"
) -> Path:
    file = folder / "a.csv"
    rows = "\n".join(f"{t!r}, {v!r}" for t, v in zip(time.tolist(), values.tolist(), strict=True))
    file.write_text(f"{header}\n{rows}\n")
    return file


def irregular(seed: int = 0, rate: float = 1000.0, duration: float = 4.0) -> np.ndarray:
    steps = np.random.default_rng(seed).uniform(0.3, 1.7, round(duration * rate)) / rate
    return np.concatenate(([0.0], np.cumsum(steps)))


@pytest.mark.parametrize("step", ["1 ms", "2 ms", "10 ms", 0.0037])
def test_irregular_time_is_resampled_on_request(tmp_path: Path, step: str | float) -> None:
    time = irregular()
    file = written(tmp_path, time, truth(time))
    with pytest.raises(
        RecordingError,
        match=r"resample converts the record to constant steps|resample fills the gap",
    ):
        read_recording(file)
    run, (finding,) = read_recording(file, resample=step)
    wanted = float(step.split()[0]) * 1e-3 if isinstance(step, str) else step
    np.testing.assert_allclose(np.diff(run["time"]), wanted, rtol=1e-9)
    inner = slice(100, -100) if wanted < 5e-3 else slice(20, -20)
    expected = truth(run["time"].to_numpy())
    np.testing.assert_allclose(
        run["sprung.az"].to_numpy()[inner], expected[inner], rtol=0.0, atol=2e-3
    )
    assert finding.value == pytest.approx(float(np.diff(time).max()), rel=1e-12)
    assert f"the largest gap in the recorded time is {finding.value:.6g} s" in finding.message
    assert finding.severity == "note"


def test_nothing_folds_back(tmp_path: Path) -> None:
    for time in (np.arange(4000) * 0.001, irregular()):
        hum = np.sin(2.0 * np.pi * 97.0 * time)  # would be a wave of 3 Hz at 10 ms
        run, findings = read_recording(written(tmp_path, time, truth(time) + hum), resample="10 ms")
        expected = truth(run["time"].to_numpy())
        assert np.abs(run["sprung.az"].to_numpy() - expected)[20:-20].max() < 5e-3
        assert "band-limited to 40 Hz" in findings[-1].message


def test_gaps_are_bridged_by_a_line_and_told(tmp_path: Path) -> None:
    time = np.concatenate((np.arange(1000) * 0.001, 1.5 + np.arange(1000) * 0.001))
    noise = np.random.default_rng(3).normal(0.0, 0.05, time.size)
    run, findings = read_recording(written(tmp_path, time, truth(time) + noise), resample="1 ms")
    finding = findings[-1]
    assert finding.severity == "warning"
    assert finding.value == pytest.approx(0.501, abs=1e-9)
    assert "from 0.999 s" in finding.message
    within = run["sprung.az"].sel(time=slice(1.0, 1.4995)).to_numpy()
    ends = (truth(time) + noise)[[999, 1000]]
    assert ends.min() <= within.min() <= within.max() <= ends.max()  # a spline would swing to +-8


def test_a_gap_of_more_than_three_steps_is_a_warning(tmp_path: Path) -> None:
    usual, longer, shorter = "1 ms", "2 ms", "0.5 ms"
    for gap, step in (
        (2.9, usual),
        (3.1, usual),
        (5.9, longer),
        (6.1, longer),
        (2.9, shorter),
        (3.1, shorter),
    ):
        severity = "warning" if gap in (3.1, 6.1) else "note"
        time = 1e-3 * np.concatenate((np.arange(100), 99.0 + gap + np.arange(100)))
        finding = read_recording(written(tmp_path, time, truth(time)), resample=step)[1][-1]
        assert (finding.severity, finding.value) == (severity, pytest.approx(1e-3 * gap, rel=1e-9))
        assert ("band-limited" in finding.message) == (step == "2 ms")


def test_resampled_time_must_still_be_a_clock(tmp_path: Path) -> None:
    time = irregular()[:200]
    for change, message in (
        (lambda t: t[::-1].copy(), "does not increase"),
        (lambda t: np.where(np.arange(200) == 7, np.nan, t), "not a finite number"),
        (lambda t: t * 0.0, "zero in every row"),
        (lambda t: t[:5], "too few samples"),
    ):
        changed = change(time)
        with pytest.raises(RecordingError, match=message):
            read_recording(
                written(tmp_path, changed, np.sin(np.arange(changed.size))), resample="1 ms"
            )
    with pytest.raises(
        RecordingError,
        match=r"too many instants; found .* Is the time in the unit that the file states",
    ):
        read_recording(written(tmp_path, time * 1e9, truth(time)), resample="1 ms")
    file = written(tmp_path, time, truth(time))
    with pytest.raises(RecordingError, match=r"too few samples; found '[23] in steps of 0.1 s'"):
        read_recording(file, resample="100 ms")
    with pytest.raises(RecordingError, match="the step to resample to is not positive"):
        read_recording(file, resample=0.0)
    with pytest.raises(DescriptionError, match="wrong unit"):
        read_recording(file, resample="10 mm")


def test_values_are_checked_before_they_are_resampled(tmp_path: Path) -> None:
    time = irregular()[:200]
    values = truth(time)
    values[17] = np.inf
    with pytest.raises(RecordingError, match="line 19"):
        read_recording(written(tmp_path, time, values), resample="1 ms")


def test_a_sample_time_that_contradicts_the_recorded_time(tmp_path: Path) -> None:
    time = np.arange(1000) * 0.001
    file = written(tmp_path, time, truth(time))
    run, (finding,) = read_recording(file, sample_time="2 ms")
    assert (finding.severity, finding.place) == ("warning", f"{file}: time")
    assert "the record is 1.998 s long, but its recorded time gives 0.999 s" in finding.message
    assert float(run["time"][-1]) == pytest.approx(1.998)
    assert read_recording(file, sample_time="1 ms")[1] == []
    for shift, told in ((0.49e-3, []), (0.51e-3, ["warning"])):  # half a step
        late = np.where(time == time[500], time + shift, time)
        assert [
            one.severity
            for one in read_recording(written(tmp_path, late, truth(time)), sample_time="1 ms")[1]
        ] == told
    unclear = written(tmp_path, time, truth(time), "t, sprung.az [m/s^2]")
    assert read_recording(unclear, sample_time="2 ms", columns={"time": "t"})[1] == []
    broken = written(tmp_path, time, truth(time), "time [s], sprung.az [m/s^2], t").with_name(
        "a.csv"
    )
    text = (
        broken.read_text()
        .replace("\n", ", \n")
        .replace("t, \n", "t\n")
        .replace("0.5, ", "half past, ")
    )
    broken.write_text(text)
    run, findings = read_recording(
        broken, sample_time="1 ms"
    )  # a broken clock is why a step is given
    assert float(run["time"][-1]) == pytest.approx(0.999)
    assert [found.severity for found in findings] == ["note"]


def test_resampling_in_python_takes_irregular_time() -> None:
    time = irregular(1)
    instants, values = resample(time, np.stack((truth(time), 2.0 * truth(time)), axis=1), 100.0)
    np.testing.assert_allclose(
        values[20:-20, 1], 2.0 * truth(instants)[20:-20], rtol=0.0, atol=4e-3
    )


def test_testers_say_how_their_files_are_read(tmp_path: Path) -> None:
    from jounce.inspection.record import read_record
    from jounce.parts.testers import Tester, load_tester

    time = np.arange(0.0, 3.0, 0.001)
    time = np.delete(time, slice(700, 705))
    height, force = np.sin(40.0 * time) * 3.0, 4000.0 + 500.0 * np.sin(40.0 * time + 0.5)
    rows = "\n".join(
        f"{t:.6g};{z:.9g};{f:.9g}".replace(".", ",")
        for t, z, f in zip(time, height, force, strict=True)
    )
    (tmp_path / "lane.csv").write_text(f"Zeit (s);Hub (mm);Kraft (N)\n{rows}\n")
    columns = {"time": "Zeit", "left.plate.z": "Hub", "left.plate.force": "Kraft"}
    table = load_tester("eusama").model_dump(by_alias=True, exclude_none=True) | {
        "columns": columns
    }
    with pytest.raises(RecordingError, match="resample fills the gap"):
        read_record(tmp_path / "lane.csv", Tester.from_table(table))
    record, findings = read_record(
        tmp_path / "lane.csv", Tester.from_table({**table, "resample": "1 ms"})
    )
    instants = record["time"].to_numpy()
    outside = np.abs(instants - 0.7025) > 0.02
    np.testing.assert_allclose(
        record["left.plate.z"].to_numpy()[outside],
        3e-3 * np.sin(40.0 * instants)[outside],
        atol=1e-6,
    )
    assert any(
        "the largest gap in the recorded time is 0.006 s" in found.message for found in findings
    )
