"""``jounce check``: every file is judged, every problem is said, none hides another."""

from __future__ import annotations

from pathlib import Path

import pytest

from jounce.inspection.limits import shipped_limits
from jounce.operations.index import operations
from jounce.operations.request import Request
from jounce.parts.testers import library as shipped_testers


def test_everything_in_order(
    cli, campaign: Path, bump: Path, decay_file: Path, spring_files: list[Path]
) -> None:
    files = (
        campaign,
        bump,
        decay_file,
        spring_files[0],
        campaign.parent / "rig.toml",
        "trial_1.csv",
    )
    outcome = cli("check", *files, "--json")
    assert outcome.exit_code == 0, outcome.err
    assert outcome.json["ok"] is True
    kinds = [item["kind"] for item in outcome.json["files"]]
    assert kinds == ["campaign", "road", "recording", "force-deflection trial", "rig", "recording"]
    assert "ok" in cli("check", *files).out


def test_every_bad_file_is_reported(cli, bump: Path, tmp_path: Path) -> None:
    (tmp_path / "one.toml").write_text('kind = "half-sine"\nheight = "10 mm"\n', encoding="utf-8")
    (tmp_path / "two.toml").write_text('schema = "jounce.rigs/1"\n', encoding="utf-8")
    outcome = cli("check", "one.toml", bump, "two.toml", "three.toml", "--json")
    assert outcome.exit_code == 2
    assert [item["ok"] for item in outcome.json["files"]] == [False, True, False, False]
    assert "one.toml: length: the key is missing" in outcome.err
    assert "two.toml: unknown schema 'jounce.rigs/1'" in outcome.err
    assert "Did you mean 'jounce.rig/1'?" in outcome.err
    assert "three.toml: no such file" in outcome.err
    assert outcome.err.count("\n") == 3


@pytest.mark.parametrize(
    ("old", "new", "messages"),
    [
        ('"rig.toml"', '"rigs.toml"', ["rigs.toml: no such file"]),
        ('"trial_2.csv"', '"trial_3.csv"', ["trial 2", "trial_3.csv: no such file"]),
        ('"spring_*.csv"', '"tyre_*.csv"', ["bench.spring: no file matches; found 'tyre_*.csv'"]),
        (
            'road = "A"',
            'road = "B"',
            ["trial 1: unknown road 'B'; allowed: A", "trial 2: unknown road 'B'"],
        ),
        ('"1.95 m/s"', '"1.95"', ["campaign.toml, line 12: trial[0].speed: the unit is missing"]),
        ("number = 2", "number = 1", ["trial number 1 is given twice"]),
        (
            "recording",
            "recordin",
            ["campaign.toml, line 14: trial[0].recordin: unknown key", "Did you mean 'recording'?"],
        ),
        (
            '"half-sine"',
            '"half-sin"',
            ["campaign.toml, line 6: roads.A.kind", "Did you mean 'half-sine'?"],
        ),
        ('"10 mm"', '"10 N"', ["campaign.toml, line 7: roads.A.height: wrong unit"]),
    ],
)
def test_broken_campaigns(old: str, new: str, messages: list[str], cli, campaign: Path) -> None:
    campaign.write_text(campaign.read_text(encoding="utf-8").replace(old, new), encoding="utf-8")
    outcome = cli("check", campaign)
    assert outcome.exit_code == 2
    for message in messages:
        assert message in outcome.err


def test_two_problems_of_one_campaign(cli, campaign: Path) -> None:
    (campaign.parent / "rig.toml").unlink()
    (campaign.parent / "trial_2.csv").write_text(
        "time [s], sprung.az [m/s^2]\n0, 1\n0, 2\n0, 3\n", encoding="utf-8"
    )
    outcome = cli("check", campaign, "--json")
    assert outcome.exit_code == 2
    problems = outcome.json["files"][0]["problems"]
    assert len(problems) == 2
    assert "rig.toml: no such file" in problems[0]
    assert "trial 2" in problems[1]
    assert "trial_2.csv" in problems[1]


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("", "pass.csv: the file is empty"),
        (
            "displacement [mm], force\n0, 0\n1, 22\n2, 44\n",
            "pass.csv: column 'force': the column has no unit",
        ),
        ("x [m], z [N]\n0, 0\n1, 22\n2, 44\n", "pass.csv: column 'z [N]': wrong unit"),
        ("time [s], sprung.az [m/s^2]\n0, 1\n0.1, nan\n0.2, 3\n0.3, 4\n", "pass.csv, line 3"),
        ("time [s], sprung.az [m/s^2]\n0, 1\n0.1, 2\n0.05, 3\n0.3, 4\n", "pass.csv"),
        ("time [s], a [m/s^2]\n0, 1\n0.1, 2\n0.2, 3\n0.3, 4\n", "pass.csv: no channel was found"),
    ],
)
def test_bad_recordings(content: str, message: str, cli, tmp_path: Path) -> None:
    (tmp_path / "pass.csv").write_text(content, encoding="utf-8")
    outcome = cli("check", "pass.csv")
    assert outcome.exit_code == 2
    assert message in outcome.err


def test_controllers(cli, tmp_path: Path) -> None:
    file = tmp_path / "law.toml"
    file.write_text('schema = "jounce.control/1"\nlaw = "skyhook"\n', encoding="utf-8")
    assert cli("check", file, "--json").json["files"][0]["kind"] == "control"
    file.write_text('schema = "jounce.control/1"\nlaw = "skyhok"\n', encoding="utf-8")
    outcome = cli("check", file)
    assert outcome.exit_code == 2
    assert "Did you mean 'skyhook'?" in outcome.err


@pytest.fixture
def tester_file(tmp_path: Path) -> Path:
    file = tmp_path / "lane.toml"
    file.write_text(
        shipped_testers()["egea-specsus2018"].read_text(encoding="utf-8"), encoding="utf-8"
    )
    return file


@pytest.fixture
def limits_file(tmp_path: Path) -> Path:
    file = tmp_path / "limits.toml"
    file.write_text(shipped_limits().read_text(encoding="utf-8"), encoding="utf-8")
    return file


def changed(file: Path, old: str, new: str) -> tuple[Path, int]:
    """Change a file at one place; give the line of it."""
    text = file.read_text(encoding="utf-8")
    assert old in text
    file.write_text(text.replace(old, new, 1), encoding="utf-8")
    return file, text[: text.index(old.lstrip())].count("\n") + 1


def test_testers_and_limits(cli, tester_file: Path, limits_file: Path) -> None:
    shipped = list(shipped_testers().values())
    outcome = cli("check", tester_file, limits_file, *shipped, "--json")
    assert outcome.exit_code == 0, outcome.err
    found = outcome.json["files"]
    assert [item["kind"] for item in found] == ["tester", "limits", *["tester"] * len(shipped)]
    assert not any(item["notes"] for item in found)
    assert "rigid-plate, evaluated by egea" in found[0]["what"]
    names = "body-damping, explained-force, explained-force-on-rigid-plates, locked, "
    assert f"eusama, egea, theta, boge, tyre-rigidity, {names}" in found[1]["what"]


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('stroke = "6 mm"', 'stroke = "6 N"', "stroke: wrong unit; found '6 N'"),
        ("\nplate_mass =", "\nplate_mas =", "Did you mean 'plate_mass'?"),
        (
            'kind = "rigid-plate"',
            'kind = "rigid"',
            "kind: input should be 'rigid-plate' or 'sprung-plate'",
        ),
        ('sweep_rate = "2.5 Hz/s"', 'sweep_rate = "-1 Hz/s"', "programme.sweep_rate: out of range"),
    ],
)
def test_broken_testers(old: str, new: str, message: str, cli, tester_file: Path) -> None:
    file, line = changed(tester_file, old, new)
    outcome = cli("check", file)
    assert outcome.exit_code == 2
    assert f"lane.toml, line {line}: " in outcome.err
    assert message in outcome.err
    assert outcome.err.count("\n") == 1


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('{ from = "20 %", to = "40 %"', '{ from = "22 %", to = "40 %"', "a gap from 20 % to 22 %"),
        ('{ from = "35 deg"', '{ from = "35 N"', "methods.egea.bands[1].from: wrong unit"),
        (
            "{ from = 0.10, to = 0.13, label",
            "{ from = 0.10, to = 0.13, lable",
            "Did you mean 'label'?",
        ),
        ('quantity = "theta_road"', 'quantity = "theta_raod"', "Did you mean 'theta_road'?"),
    ],
)
def test_broken_limits(old: str, new: str, message: str, cli, limits_file: Path) -> None:
    file, line = changed(limits_file, old, new)
    outcome = cli("check", file)
    assert outcome.exit_code == 2
    assert f"limits.toml, line {line}: " in outcome.err
    assert message in outcome.err
    assert outcome.err.count("\n") == 1


def test_testers_that_contradict_themselves(cli, tester_file: Path) -> None:
    changed(tester_file, "[programme]", '[columns]\n"left.plate.forse" = "F [N]"\n\n[programme]')
    changed(tester_file, 'sweep_rate = "2.5 Hz/s"', 'sweep_rate = "5 Hz/s"')
    changed(tester_file, 'end_frequency = "0 Hz"', 'end_frequency = "7 Hz"')
    changed(tester_file, "estimated = [", 'estimated = ["plate_mas", ')
    outcome = cli("check", tester_file, "--json")
    assert outcome.exit_code == 0, outcome.err
    notes = "\n".join(outcome.json["files"][0]["notes"])
    for said in (
        "Did you mean 'left.plate.force'?",
        "5 Hz/s exceeds",
        "from 25 to 7 Hz",
        "Did you mean 'plate_mass'?",
    ):
        assert said in notes


def test_headers_of_records(cli, tmp_path: Path) -> None:
    rows = "\n".join(f"{i / 1000}, {i % 7 - 3}, {4000 + i % 5}" for i in range(20))
    (tmp_path / "lane.csv").write_text(
        f"time [s], left.plate.z [mm], left.plate.force [N]\n{rows}\n", encoding="utf-8"
    )
    file = tmp_path / "lane.toml"
    file.write_text('axle = "front"\n[left]\nstatic_load = "4 kN"\n', encoding="utf-8")
    outcome = cli("check", "lane.csv", file, "--json")
    assert outcome.exit_code == 0, outcome.err
    assert [item["kind"] for item in outcome.json["files"]] == [
        "record of a tester",
        "header of a record",
    ]
    file.write_text(
        'axle = "frnt"\noperater = "x"\n[left]\nstatic_load = "4 kg"\n', encoding="utf-8"
    )
    outcome = cli("check", file)
    assert outcome.exit_code == 2
    lines = outcome.err.splitlines()
    assert "lane.toml, line 1: axle: unknown axle; found 'frnt'" in lines[0]
    assert "lane.toml, line 4: left.static_load: wrong unit; found 'kg'" in lines[1]
    assert "lane.toml, line 2" in outcome.out
    assert "Did you mean 'operator'?" in " ".join(outcome.out.split())
    assert cli("check", "lane.csv").exit_code == 2  # a record is what its header says


def test_numbers_by_their_paths(cli, tester_file: Path) -> None:
    found = cli("check", tester_file, "--parameters", "--json").json["files"][0]["parameters"]
    assert found["stroke"] == {"value": 0.006, "unit": "m"}
    assert found["programme.sweep_rate"] == {"value": 2.5, "unit": "Hz/s"}
    assert "programme.sweep_rate" in cli("check", tester_file, "--parameters").out
    shipped = cli("check", "kart-quarter-car", "--parameters", "--json").json["files"][0]
    assert shipped["file"] == "kart-quarter-car"
    assert "strut.spring.rate" in shipped["parameters"]
    assert "programme.sweep_rate" not in cli("check", tester_file).out


def test_an_fmu_lists_what_can_be_connected(cli, tmp_path: Path) -> None:
    fmu_component = pytest.importorskip("fmu_component")
    fmu_component.write(tmp_path / "part.fmu", 3, b"no library")
    outcome = cli("check", "part.fmu", "--json")
    assert outcome.exit_code == 0
    found = outcome.json["files"][0]
    assert (found["kind"], found["what"].partition(",")[0]) == ("FMU", "FMI 3.0")
    assert (
        "inputs: v_body [mm/s], v_strut [m/s], spare, deflection [mm], rate [m/s]" in found["notes"]
    )
    (tmp_path / "law.toml").write_text(
        'schema = "jounce.control/1"\nlaw = "fmu"\nfile = "sources.fmu"\n'
    )
    fmu_component.write(tmp_path / "sources.fmu", 3, b"")
    outcome = cli("check", "law.toml", "--json")
    assert outcome.exit_code == 2
    assert "only sources" in outcome.err


LABORATORY = """schema = "jounce.laboratory/1"
sprung_mass = "16 kg"
unsprung_mass = "5 kg"
obstacle = {height = "10 mm", length = "60 mm"}
trials = "trials.csv"
[channels]
ch0 = {measures = "sprung.az", sensitivity = "100 mV/g"}
"""


@pytest.fixture
def laboratory(tmp_path: Path) -> Path:
    (tmp_path / "trials.csv").write_text("trial,speed [m/s]\n1,1.95\n2,2.86\n", encoding="utf-8")
    file = tmp_path / "laboratory.toml"
    file.write_text(LABORATORY, encoding="utf-8")
    return file


def test_settings_of_a_laboratory(cli, laboratory: Path) -> None:
    outcome = cli("check", laboratory, "--json")
    assert outcome.exit_code == 0, outcome.err
    (item,) = outcome.json["files"]
    assert item["kind"] == "laboratory"
    assert (
        item["what"]
        == "settings of a laboratory: obstacle of 10 mm by 60 mm; channels sprung.az; 2 trials"
    )


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            '"100 mV/g"',
            '"100 mV"',
            "laboratory.toml, line 7: channels.ch0.sensitivity: a sensitivity with its units is required",
        ),
        (
            '"sprung.az"',
            '"body.q"',
            "laboratory.toml, line 7: channels.ch0.measures: 'body.q' does not name a known",
        ),
        ('"10 mm"', '"10 N"', "laboratory.toml, line 4: obstacle.height: wrong unit"),
        ('sprung_mass = "16 kg"', "", "laboratory.toml: sprung_mass and unsprung_mass are missing"),
        (
            'sprung_mass = "16 kg"',
            'rig = "kart-quater-car"',
            "laboratory.toml: rig: no such file, and no rig",
        ),
        ('"trials.csv"', '"table.csv"', "laboratory.toml: trials: no such file; found 'table.csv'"),
        ("trials", "trails", "laboratory.toml, line 5: trails: unknown key"),
    ],
)
def test_broken_laboratories(old: str, new: str, message: str, cli, laboratory: Path) -> None:
    laboratory.write_text(LABORATORY.replace(old, new, 1), encoding="utf-8")
    outcome = cli("check", laboratory)
    assert outcome.exit_code == 2
    assert message in outcome.err


def test_files_are_checked_by_python_as_by_the_command(cli, bump: Path, tmp_path: Path) -> None:
    (tmp_path / "two.toml").write_text('schema = "jounce.rigs/1"\n', encoding="utf-8")
    request = Request(operations()["check"], {"given": [bump.name, "two.toml", "kart-quarter-car"]})
    names: dict[str, object] = {}
    exec(request.python(), names)  # noqa: S102 - that is what it is for
    outcome = cli(*request.words(), "--json")
    assert outcome.exit_code == 2
    assert outcome.json == names["result"].to_dict()
    assert outcome.err.splitlines() == [
        f"jounce: {problem}" for problem in names["result"].problems
    ]


LAYOUT = """schema = "jounce.layout/1"
axis = "time"
cursors = [0.1, 0.2]
[[recordings]]
path = "trial_1.csv"
[[graphs]]
channels = ["sprung.az", "twice"]
[[formulas]]
name = "twice"
formula = "2 * sprung.az"
"""


def test_layouts_are_checked_with_their_formulas_and_recordings(cli, campaign: Path) -> None:
    folder = campaign.parent / "layouts"
    folder.mkdir()
    (folder / "good.toml").write_text(LAYOUT, encoding="utf-8")
    outcome = cli("check", folder / "good.toml", "--json")
    assert outcome.exit_code == 0, outcome.err
    (only,) = outcome.json["files"]
    assert (only["kind"], only["what"]) == ("layout", "1 recording, 1 graph, 1 formula")
    bad = LAYOUT.replace("2 * sprung.az", "2 * (sprung.az").replace("trial_1", "trial_9")
    (folder / "bad.toml").write_text(bad, encoding="utf-8")
    (folder / "odd.toml").write_text(LAYOUT.replace("axis", "axes"), encoding="utf-8")
    outcome = cli("check", folder, "--json")
    assert outcome.exit_code == 2
    assert [item["ok"] for item in outcome.json["files"]] == [False, True, False]
    assert "bad.toml: twice = 2 * (sprung.az: the formula cannot be read" in outcome.err
    assert "bad.toml: recordings: no such file; found 'trial_9.csv'" in outcome.err
    assert "odd.toml, line 2: axes: unknown key" in outcome.err


def test_a_project_is_checked_as_a_whole(cli, campaign: Path, tmp_path: Path) -> None:
    (campaign.parent / ".jounce").mkdir()
    (campaign.parent / ".jounce" / "old.toml").write_text("x", encoding="utf-8")
    outcome = cli("check", campaign.parent, "--json")
    assert outcome.exit_code == 0, outcome.err
    assert {item["kind"] for item in outcome.json["files"]} == {"campaign", "rig", "road"}
    (tmp_path / "empty").mkdir()
    outcome = cli("check", "empty")
    assert outcome.exit_code == 2
    assert "empty: the folder has no description" in outcome.err
