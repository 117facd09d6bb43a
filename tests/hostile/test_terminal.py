"""Text from files never steers a terminal, and is never markup in a picture."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from jounce.cli import main
from jounce.core.text import visible

EVIL = "\x1b]0;owned\x07\x1b[2J\x9b31m\u202egpj.exe\u2028\r\x00"
STEERS = set("\x1b\x07\x9b\u202e\u2028\r\x00")


@pytest.mark.parametrize("json_too", [[], ["--json"]])
def test_names_in_a_recording(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], json_too: list[str]
) -> None:
    file = tmp_path / "evil.csv"
    file.write_text(
        f"time [s], {EVIL.replace(chr(13), '').replace(chr(0), '')} [m]\n0,1\n1,2\n",
        encoding="utf-8",
    )
    assert main(["check", str(file), *json_too]) == 2
    said = capsys.readouterr()
    assert not STEERS & set(said.out + said.err)
    assert "owned" in said.err + said.out
    if json_too:
        assert "owned" in json.loads(said.out)["files"][0]["problems"][0]


def test_names_on_the_command_line_and_in_tables(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["modes", f"no{EVIL}rig"]) == 2
    rig = tmp_path / "rig.toml"
    main(["library", "kart-quarter-car"])
    text = capsys.readouterr().out
    rig.write_text(text.replace('source = "', 'source = "\\u001b[2J\\u202e', 1), encoding="utf-8")
    assert main(["check", str(rig)]) == 0
    said = capsys.readouterr()
    assert not STEERS & set(said.out + said.err)


def test_json_stays_the_same_text(capsys: pytest.CaptureFixture[str]) -> None:
    from jounce.cli.reply import print_json

    plain = {f"a{EVIL}": [EVIL, "µ·é \U0001f600\n\t"]}
    print_json(plain)
    said = capsys.readouterr().out
    assert json.loads(said) == plain
    assert not STEERS & set(said)


@pytest.mark.parametrize("text", ["5 N·s/m", "Größe", "車", "\U0001f600", "a\tb\n"])
def test_other_text_stays(text: str) -> None:
    assert visible(text) == text


@pytest.mark.parametrize("name", ["$x^$", "cost $1", "${\\frac", "a_b^c_", "%s {0}"])
def test_names_are_no_markup_in_pictures(name: str) -> None:
    from jounce.plots.figures import in_style, new_figure, render_figure

    @in_style
    def draw():
        figure = new_figure(2.0)
        axes = figure.subplots()
        axes.plot([0.0, 1.0], label=name)
        axes.set_title(name)
        axes.legend()
        return figure

    svg = render_figure(draw(), [".svg"])[".svg"].decode()
    assert svg.count(f">{name}</text>") == 2
