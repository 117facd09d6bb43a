"""Folders of laboratories as they are found: languages, weights for forces, files without a time, repeats, tables."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.campaign.laboratory import read_trials, unread_headings
from jounce.campaign.recogniser import recognise
from jounce.core.errors import RecordingError

SETTINGS = """schema = "jounce.laboratory/1"
sprung_mass = "16 kg"
unsprung_mass = "5 kg"
obstacle = {height = "10 mm", length = "60 mm"}
belt = {length = "1.97 m"}
[channels]
body = {measures = "sprung.az", sensitivity = "100 mV/g"}
"""
TABLE = "trial,speed [m/s],angle [deg],pressure [MPa],profile\n1,1.95,26,0.31,A\n2,2.86,,,\n3,3.79,16,0.25,B 0.10\n"


def _record(
    file: Path, columns: str = "time [s],body [V]", rate: float = 1000.0, before: str = ""
) -> None:
    time = np.arange(2000) / rate
    rows = "\n".join(f"{t:.4f},{v:.4f}" for t, v in zip(time, np.sin(40.0 * time), strict=True))
    file.write_text(f"{before}{columns}\n{rows}\n", encoding="utf-8")


@pytest.fixture
def lab(tmp_path: Path) -> Path:
    place = tmp_path / "lab"
    place.mkdir()
    (place / "settings.toml").write_text(SETTINGS, encoding="utf-8")
    (place / "table.csv").write_text(TABLE, encoding="utf-8")
    for number in (1, 2, 3):
        _record(place / f"run{number}.csv")
    return place


HEADINGS = {
    "paper": "Trial Number,Passage speed [m/s],Shock absorber assembling angle [°],Tire Pressure [Mpa],"
    "Obstacle Profile",
    "german": "Versuch;Bandgeschwindigkeit in m/s;Einbauwinkel [°];Reifendruck [MPa];Hindernisprofil",
    "spanish": "Ensayo,Velocidad de paso [m/s],Ángulo del amortiguador [°],Presión [MPa],Perfil del obstáculo",
    "polish": "nr;prędkość [m/s];kąt [°];ciśnienie [MPa];profil przeszkody",
    "short": "N,v [m/s],θ [deg],p [MPa],profile",
}


@pytest.mark.parametrize("language", HEADINGS)
@pytest.mark.parametrize("encoding", ["utf-8", "cp1250"])
def test_a_table_in_another_language_gives_the_same_trials(
    tmp_path: Path, language: str, encoding: str
) -> None:
    head = HEADINGS[language]
    if encoding == "cp1250" and language in ("spanish", "short"):
        pytest.skip("no letters of that code page")
    mark = ";" if ";" in head else ","
    rows = ["1|1.95|26|0.31|A", "2|2.86|||", "4|1.97|||B (x = 0.10 m)", "9|1.92|16|0.25|A"]
    cells = [row.split("|") for row in rows]
    if mark == ";":
        cells = [[cell.replace(".", ",") for cell in row] for row in cells]
    file = tmp_path / "table.csv"
    file.write_bytes(
        ("\n".join([head, *(mark.join(row) for row in cells)]) + "\n").encode(encoding)
    )
    trials = read_trials(file)
    assert [(row.number, row.speed, row.pitch) for row in trials] == [
        (1, 1.95, None), (2, 2.86, None), (4, 1.97, 0.1), (9, 1.92, None),
    ]  # fmt: skip
    assert [round(np.degrees(row.angle)) for row in trials] == [26, 26, 26, 16]
    assert [row.pressure for row in trials] == pytest.approx([0.31e6, 0.31e6, 0.31e6, 0.25e6])
    assert unread_headings(file) == []


def test_units_of_a_table_may_stand_in_a_row_of_their_own(tmp_path: Path) -> None:
    file = tmp_path / "table.csv"
    file.write_text(
        "Run No.,Belt speed,Damper angle,Tyre pressure\n,km/h,deg,psi\n7,7.2,26,45\n",
        encoding="utf-8",
    )
    (row,) = read_trials(file)
    assert (row.number, row.speed, row.pressure) == (
        7,
        pytest.approx(2.0),
        pytest.approx(310264.0, rel=1e-5),
    )


def test_a_column_and_a_profile_that_are_not_understood_are_named(
    lab: Path, tmp_path: Path
) -> None:
    (lab / "table.csv").write_text(
        "trial,speed,remark,profile\n1,1.95,warm,A\n2,2.86,,ramp\n", encoding="utf-8"
    )
    made = jn.campaign_from_folder(tmp_path / "made", lab)
    told = {item.code: str(item) for item in made.findings}
    assert "remark" in told["campaign.columns_not_read"]
    assert "trial 2" in told["campaign.profile_taken_for_one"]
    assert "ramp" in told["campaign.profile_taken_for_one"]


def test_weights_are_forces_where_there_is_a_displacement(lab: Path, tmp_path: Path) -> None:
    way = np.linspace(0.0, 10.0, 21)
    rows = "\n".join(f"{x:.2f};{23.0 * x / 9.80665:.4f}".replace(".", ",") for x in way)
    (lab / "resorte1.csv").write_text("desplazamiento (mm);carga (kg)\n" + rows, encoding="utf-8")
    rows = "\n".join(f"{x:.2f};{140.0 * x / 9.80665:.4f}".replace(".", ",") for x in way)
    (lab / "neumático_45psi.csv").write_text(
        "desplazamiento (mm);carga (kg)\n" + rows, encoding="utf-8"
    )
    made = jn.campaign_from_folder(tmp_path / "made", lab)
    kinds = {item.file.name: item.kind for item in made.files}
    assert (kinds["resorte1.csv"], kinds["neumático_45psi.csv"]) == ("spring", "tyre")
    text = made.campaign.read_text(encoding="utf-8")
    assert '"carga (kg) [kgf]"' in text
    assert '[bench.tyre."0.31 MPa"]' in text  # 45 psi are what the table rounds to 0.31 MPa


def test_a_time_without_a_unit_and_one_in_the_header_are_understood(
    lab: Path, tmp_path: Path
) -> None:
    _record(lab / "run1.csv", "t,body", rate=2000.0)
    rows = "\n".join(f"{v:.4f}\t{v:.4f}" for v in np.sin(0.02 * np.arange(2000)))
    (lab / "run2.csv").write_text(
        f"Run: 2\nSample rate: 2 kHz\nch1: body, V\n\nch1\tch2\n{rows}\n", encoding="utf-8"
    )
    made = jn.campaign_from_folder(tmp_path / "made", lab)
    trials = {item.number: item for item in made.files if item.kind == "trial"}
    assert trials[1].time == "t [s]"
    assert trials[2].sample_time == pytest.approx(5e-4)
    text = made.campaign.read_text(encoding="utf-8")
    assert 'time = "t [s]"' in text
    assert 'sample_time = "0.0005 s"' in text


def test_records_without_any_time_say_what_to_write(lab: Path) -> None:
    rows = "\n".join(f"{v:.4f}\t{v:.4f}" for v in np.sin(0.02 * np.arange(2000)))
    (lab / "run2.csv").write_text(f"body [V]\thub [V]\n{rows}\n", encoding="utf-8")
    item = next(item for item in recognise(lab) if item.file.name == "run2.csv")
    assert item.kind == "unknown"
    assert "sample_time in the settings" in item.why


def test_a_repeat_and_a_stray_record_cost_no_trial_its_number(lab: Path, tmp_path: Path) -> None:
    for number in (1, 2, 3):
        (lab / f"run{number}.csv").rename(lab / f"P{number}_031_26_A_01.csv")
    _record(lab / "P2_031_26_A_02.csv")
    _record(lab / "idle.csv")
    made = jn.campaign_from_folder(tmp_path / "made", lab)
    numbers = {item.file.name: item.number for item in made.files if item.kind == "trial"}
    assert numbers == {
        "P1_031_26_A_01.csv": 1, "P2_031_26_A_01.csv": 2, "P2_031_26_A_02.csv": 2, "P3_031_26_A_01.csv": 3,
        "idle.csv": None,
    }  # fmt: skip
    places = {item.code: item.place for item in made.findings}
    assert places["campaign.another_record"] == "P2_031_26_A_02.csv"
    assert places["campaign.no_number"] == "idle.csv"
    assert made.campaign.read_text(encoding="utf-8").count("recording =") == 3


def test_decays_at_other_angles_than_the_rigs_are_left_out(lab: Path, tmp_path: Path) -> None:
    time = np.arange(4000) / 1000.0
    rows = "\n".join(
        f"{t:.3f},{v:.5f}"
        for t, v in zip(time, np.exp(-3.0 * time) * np.cos(32.0 * time), strict=True)
    )
    for angle in (16, 26):
        (lab / f"bounce_{angle}deg.csv").write_text("time [s],body [V]\n" + rows, encoding="utf-8")
    made = jn.campaign_from_folder(tmp_path / "made", lab)
    places = {item.code: item.place for item in made.findings}
    assert places["campaign.decay_at_another_angle"] == "bounce_16deg.csv"
    text = made.campaign.read_text(encoding="utf-8")
    assert "bounce_26deg" in text
    assert "bounce_16deg" not in text


def test_a_table_without_its_headings_says_what_it_found(tmp_path: Path) -> None:
    file = tmp_path / "table.csv"
    file.write_text("Table 2\n\nwhat,how fast\n1,1.95\n", encoding="utf-8")
    with pytest.raises(RecordingError, match="what, how fast"):
        read_trials(file)


def test_a_record_of_another_rate_is_named(lab: Path, tmp_path: Path) -> None:
    _record(lab / "run2.csv", rate=500.0)
    made = jn.campaign_from_folder(tmp_path / "made", lab)
    (told,) = [item for item in made.findings if item.code == "campaign.another_rate"]
    assert told.place == "run2.csv"
    assert told.value == pytest.approx(500.0)


def test_a_doubtful_test_and_one_with_other_headings_leave_the_others_alone(
    lab: Path, tmp_path: Path
) -> None:
    way = np.linspace(0.0, 10.0, 21)

    def write(name: str, rate: float, columns: str = "Einfederung [mm],Radlast [N]") -> None:
        rows = "\n".join(f"{x:.2f},{rate * x:.4f}" for x in way)
        (lab / name).write_text(f"{columns}\n{rows}\n", encoding="utf-8")

    write("tyre_0.31MPa_1.csv", 140.0)
    write("tyre_0.31MPa_2.csv", 141.0)
    write("tyre_0.31MPa_3.csv", 139.0, "way [mm],load [N]")
    write("tyre_0.31MPa_9.csv", 22.0)  # a spring, by its rate
    made = jn.campaign_from_folder(tmp_path / "made", lab)
    places = {item.code: item.place for item in made.findings}
    assert places["campaign.doubtful_test_left_out"] == "tyre_0.31MPa_9.csv"
    assert places["campaign.other_columns"] == "tyre_0.31MPa_3.csv"
    text = made.campaign.read_text(encoding="utf-8")
    assert [name in text for name in ("MPa_1", "MPa_2", "MPa_3", "MPa_9")] == [
        True,
        True,
        False,
        False,
    ]


def test_columns_of_the_settings_that_no_record_has_are_named(lab: Path, tmp_path: Path) -> None:
    settings = SETTINGS.replace(
        '"1.97 m"}', '"1.97 m", radius = "50 mm", pulses = 12, column = "photo"}'
    )
    (lab / "settings.toml").write_text(settings.replace("body =", "bodi ="), encoding="utf-8")
    made = jn.campaign_from_folder(tmp_path / "made", lab)
    told = {
        item.place: str(item) for item in made.findings if item.code == "campaign.no_such_column"
    }
    assert set(told) == {"channels.bodi", "belt.column"}
    assert "the records have body" in told["channels.bodi"]


def test_pulses_without_a_belt_column_are_named(lab: Path, tmp_path: Path) -> None:
    time = np.arange(3000) / 1000.0
    for number in (1, 2, 3):
        rows = "\n".join(f"{t:.4f},{np.sin(40.0 * t):.4f},{5.0 * (t % 0.1 < 0.04)}" for t in time)
        (lab / f"run{number}.csv").write_text(
            f"time [s],body [V],photo [V]\n{rows}\n", encoding="utf-8"
        )
    made = jn.campaign_from_folder(tmp_path / "made", lab)
    (told,) = [item for item in made.findings if item.code == "campaign.pulses_not_used"]
    assert "photo [V]" in str(told)


def test_the_damping_of_the_tyre_is_fitted_where_nobody_measured_it(
    lab: Path, tmp_path: Path
) -> None:
    made = jn.campaign_from_folder(tmp_path / "made", lab)
    assert '"tyre.damping_coefficient" = ["0 N*s/m"' in made.campaign.read_text(encoding="utf-8")
    (lab / "settings.toml").write_text('rig = "kart-quarter-car"\n' + SETTINGS, encoding="utf-8")
    made = jn.campaign_from_folder(tmp_path / "own", lab)
    assert "tyre.damping_coefficient" not in made.campaign.read_text(encoding="utf-8")
