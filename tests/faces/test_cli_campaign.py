"""``jounce campaign`` and ``demo``: the whole way, and what happens when a part of it fails."""

from __future__ import annotations

import json
from pathlib import Path

import pytest


def test_run(cli, campaign: Path, tmp_path: Path) -> None:
    outcome = cli("campaign", "run", campaign, "--out", "results", "--json")
    assert outcome.exit_code == 0, outcome.err
    assert outcome.err == ""
    found = outcome.json
    fitted = found["updates"][0]["parameters"]["strut.damper.coefficient"]
    assert fitted["value"] == pytest.approx(180.0, rel=1e-3)  # what the recordings were made with
    assert found["updates"][0]["reduction_percent"] > 99.0
    assert [trial["number"] for trial in found["trials"]] == [1, 2]
    written = json.loads((tmp_path / "results" / "results.json").read_text(encoding="utf-8"))
    assert written["updates"] == found["updates"]
    assert (tmp_path / "results" / "report.html").stat().st_size > 1000


def test_the_paper_s_figures_are_written_where_they_are_asked_for(
    cli, campaign: Path, tmp_path: Path
) -> None:
    outcome = cli("campaign", "run", campaign, "--out", "results", "--figure", "paper", "--json")
    assert outcome.exit_code == 0, outcome.err
    names = [
        f"figures/paper-figure-{name}{suffix}"
        for name in ("4a", "6", "8")
        for suffix in (".svg", ".png")
    ]
    assert outcome.json["figures"] == names
    assert all((tmp_path / "results" / name).stat().st_size > 1000 for name in names)
    assert cli("campaign", "run", campaign, "--out", "other", "--figure", "mine").exit_code == 2


def test_figures_of_the_report_are_written_where_they_are_asked_for(
    cli, campaign: Path, tmp_path: Path
) -> None:
    outcome = cli(
        "campaign",
        "run",
        campaign,
        "--out",
        "results",
        "--figure",
        "svg",
        "--figure",
        "png",
        "--json",
    )
    assert outcome.exit_code == 0, outcome.err
    names = set(outcome.json["figures"])
    assert {"figures/trial-01.svg", "figures/trial-01.png", "figures/bench-spring.svg"} <= names
    assert {
        f"figures/{file.name}" for file in (tmp_path / "results" / "figures").iterdir()
    } == names
    more = ("--report", "pdf", "--table", "csv")
    assert cli("campaign", "run", campaign, "--out", "plain", *more).exit_code == 0
    assert not (tmp_path / "plain" / "figures").exists()
    assert (tmp_path / "plain" / "report.pdf").read_bytes().startswith(b"%PDF")
    assert len(list((tmp_path / "plain" / "tables").iterdir())) > 5


def test_synthesise(cli, tmp_path: Path) -> None:
    change = 'rig.strut.damper={coefficient = "104 N*s/m"}'
    outcome = cli(
        "campaign",
        "synthesise",
        "made",
        "--seed",
        "7",
        "--duration",
        "1 s",
        "--set",
        change,
        "--json",
    )
    assert outcome.exit_code == 0, outcome.err
    assert outcome.json["changes"] == {"rig.strut.damper": {"coefficient": "104 N*s/m"}}
    assert {"campaign.toml", "truth.toml", "trials/16.csv", "bench/decay_4.csv"} <= set(
        outcome.json["files"]
    )
    checked = cli("check", "made/truth.toml")
    assert checked.exit_code == 0
    assert "records sprung.az" in checked.out
    again = cli("campaign", "synthesise", "made", "--seed", "8")
    assert again.exit_code == 2
    assert "not empty" in again.err
    wrong = cli("campaign", "synthesise", "other", "--set", "belt.speed=1")
    assert wrong.exit_code == 2
    assert "speed_drop" in wrong.err
    assert not (tmp_path / "other").exists()


def test_one_bad_trial_does_not_lose_the_others(cli, campaign: Path, tmp_path: Path) -> None:
    (tmp_path / "trial_2.csv").write_text(
        "time [s], sprung.az [m/s^2]\n0, 1\n0, 2\n", encoding="utf-8"
    )
    outcome = cli("campaign", "run", campaign, "--out", "results", "--json")
    assert outcome.exit_code == 1
    found = outcome.json
    assert found["is_complete"] is False
    assert found["updates"][0]["reduction_percent"] > 99.0
    assert found["trials"][1]["verdict"] == "not usable"
    assert any(
        item["severity"] == "problem" and item["place"] == "trial 2" for item in found["findings"]
    )
    assert (tmp_path / "results" / "results.json").exists()


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('road = "A"', 'road = "a"', "unknown road 'a'; allowed: A"),
        ("number = 2", 'number = "two"', "campaign.toml, line 17: trial[1].number"),
        ("[bench.spring]", "[bench.sprng]", "Did you mean 'spring'?"),
        ('"rig.toml"', '"gone.toml"', "gone.toml: no such file"),
    ],
)
def test_bad_campaigns_write_nothing(
    old: str, new: str, message: str, cli, campaign: Path, tmp_path: Path
) -> None:
    campaign.write_text(campaign.read_text(encoding="utf-8").replace(old, new), encoding="utf-8")
    outcome = cli("campaign", "run", campaign, "--out", "results")
    assert outcome.exit_code == 2
    assert message in outcome.err
    assert not (tmp_path / "results").exists()


def test_existing_results_are_kept(cli, campaign: Path, tmp_path: Path) -> None:
    (tmp_path / "results").mkdir()
    mine = tmp_path / "results" / "report.html"
    mine.write_text("mine", encoding="utf-8")
    outcome = cli("campaign", "run", campaign, "--out", "results")
    assert outcome.exit_code == 2
    assert "--force" in outcome.err
    assert mine.read_text(encoding="utf-8") == "mine"
    forced = cli("campaign", "run", campaign, "--out", "results", "--force")
    assert forced.exit_code == 0
    for word in ("strut.damper.coefficient", "held out", "sprung.az", "report.html"):
        assert word in forced.out
    assert mine.read_text(encoding="utf-8") != "mine"
    onto_a_file = cli("campaign", "run", campaign, "--out", "rig.toml")
    assert onto_a_file.exit_code == 2
    assert "rig.toml: the output is a file, not a folder" in onto_a_file.err


def test_new_campaign_can_be_checked(cli, tmp_path: Path) -> None:
    outcome = cli("campaign", "new", "mine", "--json")
    assert outcome.exit_code == 0, outcome.err
    assert "campaign.toml" in outcome.json["files"]
    assert cli("check", "mine/campaign.toml", "mine/rig.toml").exit_code == 0
    assert sorted(outcome.json["files"]) == sorted(
        str(file.relative_to(tmp_path / "mine"))
        for file in (tmp_path / "mine").rglob("*")
        if file.is_file()
    )
    (tmp_path / "mine" / "rig.toml").write_text("mine", encoding="utf-8")
    again = cli("campaign", "new", "mine")
    assert again.exit_code == 2
    assert "the output already exists" in again.err
    assert (tmp_path / "mine" / "rig.toml").read_text(encoding="utf-8") == "mine"


@pytest.mark.slow
def test_demo_makes_numbered_folders(cli, tmp_path: Path) -> None:
    outcome = cli("demo", "--json")
    assert outcome.exit_code == 0
    assert outcome.json["out"].endswith("demo-1")
    assert "synthetic" in outcome.json["synthetic"]
    assert (tmp_path / "demo-1" / "report.html").exists()
    told = cli("demo", "--quick", "--out", "a demo").out
    assert told.splitlines()[-2] == f"the report: {(tmp_path / 'a demo' / 'report.html').as_uri()}"
    assert told.splitlines()[-1] == "the workbench: jounce serve 'a demo'"
    refused = cli("demo", "--out", "demo-1")
    assert refused.exit_code == 2
    assert "--force" in refused.err


def test_posterior_and_the_next_trial(cli, campaign: Path, tmp_path: Path) -> None:
    outcome = cli("campaign", "posterior", campaign, "--out", "sure", "--draws", "1000", "--json")
    assert outcome.exit_code == 0, outcome.err
    found = outcome.json
    low, high = found["parameters"]["strut.damper.coefficient"]["interval"]
    assert 170.0 < low < high < 190.0
    assert found["counted"] == "noise only"
    made = {
        str(file.relative_to(tmp_path / "sure"))
        for file in (tmp_path / "sure").rglob("*")
        if file.is_file()
    }
    assert {
        "report.html",
        "posterior.json",
        "draws.nc",
        "draws.png",
        "profiles.png",
        "bands/trial-1.csv",
    } <= made
    again = cli("campaign", "posterior", campaign, "--out", "sure", "--draws", "1000")
    assert again.exit_code == 2
    unknown = cli("campaign", "posterior", campaign, "--out", "other", "--strategy", "none of them")
    assert unknown.exit_code == 2
    assert "unknown update" in unknown.err
    assert not (tmp_path / "other").exists()
    ranked = cli(
        "campaign",
        "next",
        campaign,
        "--speed",
        "1 m/s",
        "--speed",
        "2 m/s",
        "--count",
        "2",
        "--json",
    )
    assert ranked.exit_code == 0, ranked.err
    gains = [one["gain"] for one in ranked.json["candidates"]]
    assert gains == sorted(gains, reverse=True)
    assert len(ranked.json["series"]) == 2
    assert cli("campaign", "next", campaign, "--road", "nowhere").exit_code == 2
