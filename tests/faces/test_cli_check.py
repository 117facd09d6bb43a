"""``jounce check``: every file is judged, every problem is said, none hides another."""

from __future__ import annotations

from pathlib import Path

import pytest


def test_everything_in_order(cli, campaign: Path, bump: Path, decay_file: Path, spring_files: list[Path]) -> None:
    files = (campaign, bump, decay_file, spring_files[0], campaign.parent / "rig.toml", "trial_1.csv")
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
        ('road = "A"', 'road = "B"', ["trial 1: unknown road 'B'; allowed: A", "trial 2: unknown road 'B'"]),
        ('"1.95 m/s"', '"1.95"', ["campaign.toml, line 12: trial[0].speed: the unit is missing"]),
        ("number = 2", "number = 1", ["trial number 1 is given twice"]),
        (
            "recording",
            "recordin",
            ["campaign.toml, line 14: trial[0].recordin: unknown key", "Did you mean 'recording'?"],
        ),
        ('"half-sine"', '"half-sin"', ["campaign.toml, line 6: roads.A.kind", "Did you mean 'half-sine'?"]),
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
    (campaign.parent / "trial_2.csv").write_text("time [s], sprung.az [m/s^2]\n0, 1\n0, 2\n0, 3\n", encoding="utf-8")
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
        ("displacement [mm], force\n0, 0\n1, 22\n2, 44\n", "pass.csv: column 'force': the column has no unit"),
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
