"""Files before they enter a campaign: kinds, what is missing, and what damaged files do to the others."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from jounce.campaign.arrivals import FilePreview, file_state, preview_files
from jounce.campaign.laboratory import read_trial_text
from jounce.core.errors import RecordingError
from jounce.core.phrases import german_of


def _machine(file: Path, head: str, factor: float = 22.0) -> Path:
    rows = "\n".join(f"{x};{factor * x}" for x in range(1, 31))
    file.write_text(f"{head}\n{rows}\n", encoding="utf-8")
    return file


def _record(file: Path, head: str = "time [s],sprung.az [m/s^2],unsprung.az [m/s^2]") -> Path:
    time = np.arange(2000) * 1e-3
    pulse = np.exp(-8.0 * np.abs(time - 0.2)) * np.sin(60.0 * time)
    rows = "\n".join(f"{t:.4f},{v:.6f},{2 * v:.6f}" for t, v in zip(time, pulse, strict=True))
    file.write_text(f"{head}\n{rows}\n", encoding="utf-8")
    return file


def _only(file: Path) -> FilePreview:
    (found,) = preview_files([file]).files
    return found


def test_a_trial_is_no_decay_though_it_falls(tmp_path: Path) -> None:
    found = _only(_record(tmp_path / "run_03.csv"))
    assert found.recognised.kind == "trial"
    assert [lack.what for lack in found.missing] == ["speed"]
    assert found.fields["number"] == 3
    decay = _only(_record(tmp_path / "decay_1.csv"))
    assert decay.recognised.kind == "decay"
    assert not decay.missing


@pytest.mark.parametrize(
    ("name", "speed"),
    [("run3_1.95ms", "1.95 m/s"), ("v2p9mps_2", "2.9 m/s"), ("07_36_km_h", "10 m/s")],
)
def test_the_speed_may_be_in_the_name(tmp_path: Path, name: str, speed: str) -> None:
    assert _only(_record(tmp_path / f"{name}.csv")).fields["speed"] == speed


def test_speed_and_pressure_may_be_in_comments(tmp_path: Path) -> None:
    head = "# Geschwindigkeit: 7,2 km/h\n# Reifendruck 3.1 bar\ntime [s],sprung.az [m/s^2],unsprung.az [m/s^2]"
    fields = _only(_record(tmp_path / "run1.csv", head)).fields
    assert (fields["speed"], fields["tyre_pressure"]) == ("2 m/s", "0.31 MPa")


def test_usual_units_are_proposed_and_a_given_unit_is_taken(tmp_path: Path) -> None:
    file = _machine(tmp_path / "feder.csv", "Weg;Kraft")
    found = _only(file)
    assert found.recognised.kind == "spring"
    assert [(lack.column, lack.proposal) for lack in found.missing] == [
        ("Weg", "mm"),
        ("Kraft", "N"),
    ]
    assert str(found.summary) == "22 N/mm, 30 rows"
    given = {str(file): {"displacement": "Weg [cm]", "force": "Kraft [N]"}}
    (mended,) = preview_files([file], given).files
    assert (str(mended.summary), mended.missing) == ("2.2 N/mm, 30 rows", ())
    assert mended.fields["columns"] == given[str(file)]
    assert german_of(mended.summary) == "2.2 N/mm, 30 Zeilen"


def test_a_falling_force_lacks_a_sign(tmp_path: Path) -> None:
    found = _only(_machine(tmp_path / "spring.csv", "displacement [mm];force [N]", -22.0))
    assert [lack.what for lack in found.missing] == ["sign"]


def test_a_table_of_trials_fills_the_trials(tmp_path: Path) -> None:
    files = [_record(tmp_path / f"run{number}.csv") for number in (1, 2)]
    table = tmp_path / "table.csv"
    table.write_text(
        "trial,speed [m/s],angle [deg],pressure [MPa],profile\n1,1.95,26,0.31,A\n2,2.8,,,B 0.1\n"
    )
    found = preview_files([*files, table])
    assert [item.recognised.kind for item in found.files] == ["trial", "trial", "table of trials"]
    assert found.files[1].fields == {
        "number": 2, "speed": "2.8 m/s", "tyre_pressure": "0.31 MPa", "road": "B 0.1", "strut_angle": "26 deg",
    }  # fmt: skip
    assert found.roads == {"B 0.1": {"kind": "train", "of": "A", "count": 5, "pitch": "0.1 m"}}
    pasted = read_trial_text("trial\tspeed [m/s]\tp [MPa]\n1\t1,5\t0,25\n")
    first = preview_files(files, rows=pasted).files[0]
    assert (first.fields["speed"], first.fields["tyre_pressure"]) == ("1.5 m/s", "0.25 MPa")


def test_damaged_files_do_not_stop_the_others(tmp_path: Path) -> None:
    good = _machine(tmp_path / "spring.csv", "displacement [mm];force [N]")
    bad = {
        "empty.csv": b"",
        "binary.csv": bytes(range(256)) * 9,
        "a.mat": b"no matlab",
        "x.docx": b"PK",
    }
    for name, content in bad.items():
        (tmp_path / name).write_bytes(content)
    found = preview_files([*(tmp_path / name for name in bad), tmp_path / "gone.csv", good]).files
    assert [item.recognised.kind for item in found] == ["unknown"] * 5 + ["spring"]
    assert all(item.summary for item in found)


def test_the_state_follows_the_content(tmp_path: Path) -> None:
    file = _machine(tmp_path / "spring.csv", "displacement [mm];force [N]")
    before = file_state(file)
    assert before == _only(file).state
    with file.open("a") as stream:
        stream.write("31;700\n")
    os.utime(file, (0, 0))
    assert file_state(file) not in (before, "")
    file.unlink()
    assert file_state(file) == ""


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("trial\tspeed [m/s]\n1\t2\n1\t3\n", "a trial is listed twice"),
        ("trial\tspeed [m/s]\n1\tfast\n", "line 2: speed"),
        ("a\tb\n1\t2\n", "no table of trials"),
        ("", "no table of trials"),
    ],
)
def test_a_pasted_table_that_is_wrong_names_its_row(text: str, said: str) -> None:
    with pytest.raises(RecordingError, match=said):
        read_trial_text(text)


def test_a_record_of_a_tester_enters_no_campaign(tmp_path: Path) -> None:
    found = _only(_record(tmp_path / "lane.csv", "time [s],left.plate.z [mm],left.plate.force [N]"))
    assert found.recognised.kind == "tester record"
    assert found.missing == ()


def test_a_profile_that_is_not_known_is_asked_for(tmp_path: Path) -> None:
    file = _record(tmp_path / "run_03.csv")
    rows = read_trial_text("trial\tspeed [m/s]\tobstacle\n3\t1.5\tkerb\n")
    (found,) = preview_files([file], rows=rows).files
    assert [(lack.what, lack.column) for lack in found.missing] == [("road", "kerb")]


@pytest.mark.parametrize(("profile", "pitch"), [("B 0.10", 0.1), ("B0.15", 0.15), ("B10 cm", 0.1)])
def test_a_train_has_its_pitch_beside_its_letter(profile: str, pitch: float) -> None:
    (row,) = read_trial_text(f"trial\tspeed [m/s]\tobstacle\n3\t1.5\t{profile}\n")
    assert (row.count, row.pitch) == (5, pytest.approx(pitch))


def test_a_whole_number_beside_a_train_is_no_pitch_in_metres() -> None:
    with pytest.raises(RecordingError, match="a train without a pitch"):
        read_trial_text("trial\tspeed [m/s]\tobstacle\n3\t1.5\tB10\n")
