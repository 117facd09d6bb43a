"""``jounce analyse`` through its entry point: tables, files, JSON, and one message for each mistake."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from two_masses import TwoMasses

import jounce as jn
from jounce.cli import main


@pytest.fixture
def lap(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """A lap as a laboratory writes it: other names, accelerations in g."""
    monkeypatch.chdir(tmp_path)
    t, road, both = TwoMasses().drive(0, 60.0)
    rows = np.column_stack([t, 1e3 * road, both / 9.80665])
    np.savetxt(
        "lap.csv", rows, "%.6f", ";", header="t [s];laser [mm];body [g];wheel [g]", comments=""
    )
    return "lap.csv"


COLUMNS = [
    "--columns",
    "time=t",
    "--columns",
    "road.z=laser",
    "--columns",
    "sprung.az=body",
    "--columns",
    "unsprung.az=wheel",
]


def _answer(capsys: pytest.CaptureFixture[str], *words: str) -> dict[str, object]:
    assert main(["analyse", *words, *COLUMNS, "--json"]) == 0
    plain: dict[str, object] = json.loads(capsys.readouterr().out)
    return plain


def test_every_command_answers_with_its_files(lap: str, capsys: pytest.CaptureFixture[str]) -> None:
    asked = {
        "statistics": [],
        "spectrum": ["--band", "0.5..40 Hz"],
        "transfer": ["--input", "road.z", "--output", "sprung.az", "--estimator", "Hv"],
        "modes": [
            "--input",
            "road.z",
            "--from",
            "1 s",
            "--rig",
            "audi-a6-quarter-car",
            "--set",
            "sprung.mass=350 kg",
        ],
        "integrate": ["--channel", "sprung.az", "--above", "0.5 Hz"],
    }
    for name, words in asked.items():
        files = ["--out", f"{name}.csv", "--figure", f"{name}.svg", "--report", f"{name}.html"]
        plain = _answer(capsys, name, lap, *words, *files)
        assert plain["record"] == "lap.csv"
        for suffix in ("csv", "svg", "html"):
            assert Path(f"{name}.{suffix}").stat().st_size > 200
    motion, _ = jn.read_recording("integrate.csv")
    assert list(motion.data_vars) == ["sprung.az", "sprung.vz", "sprung.z"]


def test_numbers_are_si_and_tables_in_units_that_are_shown(
    lap: str, capsys: pytest.CaptureFixture[str]
) -> None:
    plain = _answer(capsys, "statistics", lap)
    rms = {row["channel"]: row["rms"]["value"] for row in plain["channels"]}  # type: ignore[attr-defined]
    assert 3.0 < rms["unsprung.az"] < 9.0  # m/s^2
    assert main(["analyse", "statistics", lap, *COLUMNS]) == 0
    shown = capsys.readouterr().out
    assert "mm" in shown
    assert "m/s²" in shown


def test_modes_are_found_from_a_file_and_count_is_asked_for(
    lap: str, capsys: pytest.CaptureFixture[str]
) -> None:
    plain = _answer(capsys, "modes", lap, "--input", "road.z", "--count", "2")
    values = [mode["frequency"]["value"] for mode in plain["modes"]]  # type: ignore[attr-defined]
    assert values == pytest.approx([f for f, _ in TwoMasses().modes()], rel=0.03)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["spectrum", "--segment", "1 h"], "the segment does not fit the record"),
        (["spectrum", "--channel", "sprung.ax"], "no channel 'sprung.ax'"),
        (["spectrum", "--band", "5"], "--band"),
        (["statistics", "--from", "2 min"], "the section has too few samples"),
        (
            ["transfer", "--input", "road.z", "--output", "sprung.az", "--estimator", "H4"],
            "unknown estimator",
        ),
        (["modes", "--input", "road.z", "--band", "3..4 Hz"], "the band is too narrow for modes"),
        (
            ["modes", "--input", "road.z", "--count", "0"],
            "--count: invalid number of modes; found 0; allowed: 1 to 6",
        ),
        (
            ["modes", "--input", "road.z", "--count", "7"],
            "--count: invalid number of modes; found 7; allowed: 1 to 6",
        ),
        (
            ["modes", "--input", "road.z", "--set", "sprung.mass=350 kg"],
            "--set: there is no rig to change",
        ),
        (
            ["transfer", "--input", "road.z", "--output", "sprung.az", "--set", "a=1"],
            "--set: there is no rig to change",
        ),
        (["statistics", "--channel", ""], "no channel ''"),
        (["integrate", "--channel", "road.z"], "only accelerations are integrated"),
    ],
)
def test_mistakes_are_one_message(
    lap: str, capsys: pytest.CaptureFixture[str], words: list[str], message: str
) -> None:
    assert main(["analyse", words[0], lap, *words[1:], *COLUMNS]) == 2
    told = capsys.readouterr().err
    assert message in told
    assert told.count("\n") <= 3


def test_gaps_and_channels_of_two_rates_are_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    t = np.arange(4000) / 200.0
    rows = [f"{a:.4f},{b:.5f}" for a, b in zip(t, np.sin(t * 20.0), strict=True)]
    gap = tmp_path / "gap.csv"
    gap.write_text("time [s],sprung.az [m/s^2]\n" + "\n".join([*rows[:1000], *rows[1200:]]) + "\n")
    assert main(["analyse", "spectrum", str(gap)]) == 2
    assert "200 samples missing there" in capsys.readouterr().err
    assert main(["analyse", "spectrum", str(gap), "--resample", "5 ms"]) == 0
    assert "the largest gap" in capsys.readouterr().out


def test_python_that_is_offered_gives_the_same(
    lap: str, capsys: pytest.CaptureFixture[str]
) -> None:
    from jounce.operations.index import operations
    from jounce.operations.request import Request

    given = {
        "record": lap,
        "columns": ["time=t", "sprung.az=body"],
        "channel": ["sprung.az"],
        "band": "0.5..40 Hz",
    }
    text = Request(operations()["analyse spectrum"], given).python()
    assert "jn.estimate_spectra(" in text
    exec(compile(text, "offered", "exec"), {})  # noqa: S102 - our own text
    assert capsys.readouterr().out


def test_volts_become_what_their_sensors_measure(
    lap: str, capsys: pytest.CaptureFixture[str]
) -> None:
    text = Path(lap).read_text(encoding="utf-8").replace("body [g]", "ch0 [V]")
    Path("volts.csv").write_text(text, encoding="utf-8")
    sensors = 'schema = "jounce.sensors/1"\n[sensors."sprung.az"]\ncolumn = "ch0"\nsensitivity = "1 V/g"\n'
    Path("card.toml").write_text(sensors, encoding="utf-8")
    words = ("analyse", "statistics", "--channel", "sprung.az", "--json")
    assert main([*words, lap, *COLUMNS]) == 0
    in_g = json.loads(capsys.readouterr().out)["channels"][0]
    columns = [word for word in COLUMNS if word != "sprung.az=body"]
    del columns[columns.index("road.z=laser") + 1]
    assert main([*words, "volts.csv", *columns, "--sensors", "card.toml"]) == 0
    in_volts = json.loads(capsys.readouterr().out)["channels"][0]
    assert in_volts["rms"]["value"] == pytest.approx(in_g["rms"]["value"], rel=1e-9)
    assert main([*words, "volts.csv", *columns, "--sensors", "nowhere.toml"]) == 2
    assert "nowhere.toml" in capsys.readouterr().err
