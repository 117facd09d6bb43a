"""``jounce draw`` and ``jounce animate``: pictures by the command line, and what one can get wrong."""

from __future__ import annotations

from pathlib import Path

import pytest

RIG = "kart-double-wishbone"
TRAVEL = ("--travel", "-20 mm:20 mm:10 mm")
DRIVE = ("--speed", "1.95 m/s", "--duration", "0.3 s")


def test_draw_chooses_a_name_and_never_overwrites(cli, tmp_path: Path) -> None:
    assert cli("draw", RIG).out == f"written: {RIG}.png\n"
    picture = tmp_path / f"{RIG}.png"
    assert picture.read_bytes().startswith(b"\x89PNG")
    picture.write_text("mine", encoding="utf-8")
    again = cli("draw", RIG)
    assert again.exit_code == 2
    assert "the output already exists" in again.err
    assert picture.read_text(encoding="utf-8") == "mine"
    assert cli("draw", RIG, "--force").exit_code == 0
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_draw_changes_and_poses(cli, tmp_path: Path) -> None:
    plain = cli(
        "draw", RIG, *TRAVEL, "--set", "wheel.camber=-2 deg", "--figure", "a.svg", "--json"
    ).json
    assert plain["poses"] == pytest.approx([-0.02, -0.01, 0.0, 0.01, 0.02])
    assert plain["changes"] == {"wheel.camber": "-2 deg"}
    text = (tmp_path / "a.svg").read_text(encoding="utf-8")
    assert "wheel travel −10 mm" in text
    assert "upper_ball_joint" in text
    cli("draw", RIG, "--no-names", "--figure", "b.svg")
    assert "upper_ball_joint" not in (tmp_path / "b.svg").read_text(encoding="utf-8")


def test_draw_over_the_rack(cli, tmp_path: Path) -> None:
    rack = ("--rack", "-5 mm:5 mm:5 mm", "--travel", "10 mm")
    assert cli("draw", RIG, *rack, "--figure", "a.svg").exit_code == 0
    assert "rack travel +5 mm" in (tmp_path / "a.svg").read_text(encoding="utf-8")


def test_draw_keeps_what_is_within_reach(cli, tmp_path: Path) -> None:
    outcome = cli(
        "draw",
        "reference-double-wishbone",
        "--travel",
        "-300 mm:300 mm:100 mm",
        "--figure",
        "a.svg",
        "--json",
    )
    assert outcome.exit_code == 2
    assert "end of its travel" in outcome.err
    assert outcome.json["poses"] == pytest.approx([-0.2, -0.1, 0.0, 0.1, 0.2])
    assert (tmp_path / "a.svg").exists()


def test_animate_a_sweep(cli, tmp_path: Path) -> None:
    plain = cli("animate", RIG, *TRAVEL, "--report", "a.html", "--json").json
    assert (plain["over"], plain["poses"], plain["out"]) == ("wheel_travel", 5, "a.html")
    assert "data-viewer" in (tmp_path / "a.html").read_text(encoding="utf-8")


def test_animate_a_drive(cli, bump: Path, tmp_path: Path) -> None:
    words = ("animate", RIG, "--road", bump, *DRIVE)
    plain = cli(*words, "--report", "a.html", "--json").json
    assert (plain["over"], plain["poses"]) == ("time", 301)
    assert plain["findings"] == []
    assert '"road":{"x":[' in (tmp_path / "a.html").read_text(encoding="utf-8")
    assert (
        cli(*words, "--between", "0.1 s:0.12 s", "--frames", 3, "--figure", "a.gif").exit_code == 0
    )
    assert (tmp_path / "a.gif").read_bytes().startswith(b"GIF89a")


def test_animate_says_when_nothing_happens(cli, bump: Path) -> None:
    short = ("--speed", "1.95 m/s", "--duration", "0.05 s")
    assert (
        "ends before the obstacle begins"
        in cli("animate", RIG, "--road", bump, *short, "--report", "a.html").out
    )


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (("draw", "kart-quarter-car"), "only a 3-D rig of one corner can be drawn"),
        (("draw", RIG, "--figure", "a.jpg"), "not written in this format"),
        (("draw", RIG, "--figure", "no/a.png"), "does not exist"),
        (("draw", RIG, "--travel", "-20 mm:20 mm:1 mm"), "too many poses"),
        (("draw", RIG, *TRAVEL, "--rack", "-1 mm:1 mm:1 mm"), "only one motion can be swept"),
        (("draw", RIG, "--travel", "5 kg"), "--travel"),
        (("animate", RIG, "--report", "a.html"), "no motion is given"),
        (
            ("animate", RIG, *TRAVEL, "--speed", "1 m/s", "--report", "a.html"),
            "both a sweep and a run",
        ),
        (("animate", RIG, *TRAVEL, "--figure", "a.avi"), "not written in this format"),
        (("animate", RIG, *TRAVEL, "--slow", "0", "--report", "a.html"), "--slow"),
        (("animate", RIG, *TRAVEL, "--between", "5 mm", "--report", "a.html"), "invalid range"),
        (
            ("animate", RIG, *TRAVEL, "--between", "0 mm:50 mm", "--report", "a.html"),
            "no pose at this wheel travel",
        ),
        (
            ("animate", RIG, "--road", "bump.toml", "--speed", "1 m/s", "--report", "a.html"),
            "--duration is missing",
        ),
        (
            ("animate", "kart-quarter-car", *TRAVEL, "--report", "a.html"),
            "only a 3-D rig of one corner can be drawn",
        ),
    ],
)
def test_mistakes(cli, bump: Path, words: tuple[str, ...], message: str, tmp_path: Path) -> None:
    outcome = cli(*words)
    assert outcome.exit_code == 2
    assert message in outcome.err
    assert [file.name for file in tmp_path.iterdir()] == ["bump.toml"]


def test_centres_are_drawn_at_design(cli, tmp_path: Path) -> None:
    outcome = cli("draw", "formula-student-front", "--centres", "--figure", "centres.svg")
    assert outcome.exit_code == 0, outcome.err
    text = (tmp_path / "centres.svg").read_text(encoding="utf-8")
    for words in ("instant centre", "roll centre height", "front view", "29.13"):
        assert words in text
    outcome = cli(
        "draw", "formula-student-front", "--centres", "--travel", "10 mm", "--figure", "other.svg"
    )
    assert outcome.exit_code == 2
    assert "--centres" in outcome.err
    assert not (tmp_path / "other.svg").exists()
