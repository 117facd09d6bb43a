"""What looks wrong with a rig is said wherever it is used: on stderr, one line each; stdout keeps its JSON."""

from __future__ import annotations

import re
from importlib.resources import files
from pathlib import Path

import pytest

from jounce.campaign import load_truth
from jounce.inspection.limits import load_limits
from jounce.parts import Vehicle, library, load
from jounce.parts.testers import load_tester

TRIAL = ("--road", "bump.toml", "--speed", "1.95 m/s", "--duration", "0.1 s")
COMMANDS = {
    "modes": (),
    "kinematics": ("--travel", "0"),
    "simulate": TRIAL,
    "adjust": ("--set", "spring_preload=100 N"),
}


@pytest.fixture
def in_metres(tmp_path: Path) -> Path:
    """The reference rig with its millimetres given as metres."""
    text = (files("jounce") / "parts" / "library" / "reference-double-wishbone.toml").read_text(
        encoding="utf-8"
    )
    file = tmp_path / "metres.toml"
    file.write_text(re.sub(r'"(-?[\d.]+) mm"', r"\1", text), encoding="utf-8")
    return file


@pytest.mark.parametrize("command", COMMANDS)
def test_warnings_about_the_rig_are_on_stderr(
    cli, in_metres: Path, bump: Path, command: str
) -> None:
    assert bump.exists()
    outcome = cli(command, in_metres, *COMMANDS[command], "--json")
    first = outcome.err.splitlines()[0]
    assert first.startswith(f"warning: {in_metres}: hardpoints: ")
    assert "millimetres given as metres?" in first
    assert outcome.json


@pytest.mark.parametrize("command", COMMANDS)
def test_a_sound_rig_warns_of_nothing(cli, bump: Path, command: str) -> None:
    assert bump.exists()
    outcome = cli(command, "kart-double-wishbone", *COMMANDS[command], "--json")
    assert outcome.exit_code == 0
    assert outcome.err == ""


def test_changes_are_warned_of_too(cli) -> None:
    outcome = cli("modes", "kart-double-wishbone", "--set", "wheel.camber=30 deg", "--json")
    assert outcome.exit_code == 0
    assert re.fullmatch(
        r"warning: kart-double-wishbone: wheel\.camber: 30 deg is a lot.*\n", outcome.err
    )


def test_what_the_library_says_of_a_rig_is_what_the_rig_says(cli):
    listed = cli("library", "--json").json
    names = [item["name"] for kind in ("rigs", "vehicles") for item in listed[kind]]
    assert sorted(names) == sorted(library())
    for item in (*listed["rigs"], *listed["vehicles"]):
        rig = load(item["name"])
        assert (item["kind"] == "vehicle") == isinstance(rig, Vehicle)
        assert (item["what"], item["source"], item["estimated"]) == (
            rig.model,
            rig.source,
            list(rig.estimated),
        )


def test_what_the_library_says_of_testers_limits_and_truths_is_what_they_say(cli):
    """They are listed from their tables, which nobody checks then."""
    listed = cli("library", "--json").json
    for item in listed["testers"]:
        tester = load_tester(item["name"])
        assert item["what"] == f"{tester.kind}, {tester.method}"
        assert (item["source"], item["estimated"]) == (tester.source, list(tester.estimated))
    (limits,), shipped = listed["limits"], load_limits()
    assert limits["what"] == f"limits {shipped.version} of {', '.join(shipped.methods)}"
    assert limits["source"] == shipped.source
    for item in listed["truths"]:
        truth = load_truth(item["name"])
        assert item["what"] == f"of a virtual bench, {truth.true_rig().model}"
        assert (item["source"], item["estimated"]) == (truth.source, list(truth.estimated))
        assert item["name"] in cli("library").out
    assert len(listed["truths"]) > 1
