"""``jounce study audi-a6-...``: JSON as promised, text, folders, mistakes."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from jounce.recordings import read_recording

WINDOWS = [(3.0, 6.0), (6.0, 8.0), (8.0, 10.0)]


@pytest.mark.parametrize(("name", "sign"), [("audi-a6-case-a", 1.0), ("audi-a6-case-b", -1.0)])
def test_json_of_a_case(cli, tmp_path: Path, name: str, sign: float):
    found = cli("study", name, "--json")
    assert found.exit_code == 0
    runs = found.json["runs"]
    assert [round(sign * run["moment"], 6) for run in runs] == [100.0] * 3 + [2699.4] * 3
    assert [run["variant"] for run in runs] == ["simulink", "sign-corrected", "physical"] * 2
    for run in runs:
        assert run["statics"]["z"] == pytest.approx(-0.16391198, abs=1e-8)
        assert run["statics"]["theta"] == pytest.approx(-0.00338437, abs=1e-8)
        for output in ("z", "theta"):
            windows = run["outputs"][output]["windows"]
            assert [(one["start"], one["end"]) for one in windows] == WINDOWS
            assert all(
                set(one) == {"start", "end", "min", "t_min", "max", "t_max"} for one in windows
            )
    assert found.json["out"] is None
    assert not list(tmp_path.iterdir())


def test_text_of_a_case(cli, tmp_path: Path):
    found = cli("study", "audi-a6-case-a")
    assert found.exit_code == 0
    assert "−60.932" in found.out
    assert "warning: simulink:" in found.out
    assert found.out.rstrip().endswith("nothing was written; give --out DIR to keep the results")
    assert not list(tmp_path.iterdir())


def test_a_case_into_a_folder(cli, tmp_path: Path):
    folder = tmp_path / "b"
    folder.mkdir()
    (folder / "report.html").write_text("mine")
    refused = cli("study", "audi-a6-case-b", "--out", "b")
    assert refused.exit_code == 2
    assert "--force" in refused.err
    assert (folder / "report.html").read_text() == "mine"
    assert cli("study", "audi-a6-case-b", "--out", "b", "--force").exit_code == 0
    names = {str(file.relative_to(folder)) for file in folder.rglob("*") if file.is_file()}
    figures = (
        "figure-14-bounce",
        "figure-15-pitch",
        "figure-16-signals-100Nm",
        "figure-16-signals-2699Nm",
        "start-up",
    )
    assert {f"figures/{name}{suffix}" for name in figures for suffix in (".svg", ".png")} <= names
    assert len([name for name in names if name.startswith("curves/")]) == 12
    run, _ = read_recording(folder / "curves" / "physical-100Nm.nc")
    table, _ = read_recording(folder / "curves" / "physical-100Nm.csv")
    assert float(run["pitch.moment"].min()) == -100.0
    assert float(abs(run["bounce.displacement"] - table["bounce.displacement"]).max()) == 0.0
    assert float(run["front.road.z"].min()) == pytest.approx(-0.02, abs=1e-12)
    results = json.loads((folder / "results.json").read_text(encoding="utf-8"))
    assert len(results["runs"]) == 6
    page = (folder / "report.html").read_text(encoding="utf-8")
    for words in ("38 N/m", "4201.7", "33.728 N/mm", "130 mm", "+3.570 1/s", "43.9 mm"):
        assert words in page, words


def test_exciter(cli, tmp_path: Path):
    found = cli("study", "audi-a6-excenter", "--json")
    assert found.exit_code == 0
    assert [run["variant"] for run in found.json["runs"]] == ["summed", "series", "two-mass"]
    assert found.json["torque_of_eq_5"] == pytest.approx(70.03, abs=0.0051)
    assert "unsprung.mass" in found.json["estimated"]
    assert not list(tmp_path.iterdir())
    text = cli("study", "audi-a6-excenter", "--amplitude", "0.5 mm", "--out", "e")
    assert text.exit_code == 0
    assert "70.03 N·m (the paper: 4201.7 N·m)" in text.out
    assert (tmp_path / "e" / "figures" / "figure-8-spring.svg").is_file()
    assert (tmp_path / "e" / "curves" / "two-mass.nc").is_file()


@pytest.mark.parametrize(
    "words",
    [
        ("--amplitude", "0 mm"),
        ("--amplitude", "3 m"),
        ("--amplitude", "3 kg"),
        ("--plate-mass", "-1 kg"),
    ],
)
def test_wrong_inputs_of_the_exciter(cli, words: tuple[str, ...]):
    found = cli("study", "audi-a6-excenter", *words)
    assert found.exit_code == 2
    assert words[0].strip("-").replace("-", "_") in found.err.replace("-", "_")
    assert "allowed" in found.err
