"""Commands to copy are words again in the shell that they are pasted into."""

from __future__ import annotations

import subprocess
import sys

import pytest

from jounce.core.commands import command_line, words_of

WORDS = [
    "plain",
    "--out=C:\\runs\\a.nc",
    "front axle.toml",
    "it's",
    "a&b",
    "(1)",
    "käfig.csv",
    "x;y",
    "%TEMP%",
    "",
    "{a}",
]


def test_a_posix_shell_takes_them_apart_as_they_were() -> None:
    words = [*WORDS, "$HOME", '"', "`id`", "a\\b", "\n"]
    shown = [sys.executable, "-c", "import sys; print(sys.argv[1:])", *words]
    done = subprocess.run(
        ["/bin/sh", "-c", command_line(shown)], capture_output=True, text=True, check=True
    )
    assert done.stdout == f"{words}\n"
    assert words_of(command_line(words)) == words


@pytest.mark.parametrize(
    ("word", "wanted"),
    [
        ("plain", "plain"),
        ("--out=C:\\runs\\a.nc", "--out=C:\\runs\\a.nc"),
        ("front axle.toml", '"front axle.toml"'),
        ("it's", '"it\'s"'),
        ("R&D.toml", '"R&D.toml"'),
        ("a(1).csv", '"a(1).csv"'),
        ("a;b", '"a;b"'),
        ("käfig.csv", '"käfig.csv"'),
        ("@all", '"@all"'),
        ("C:\\my runs\\", '"C:\\my runs\\\\"'),
        ("", '""'),
        ("$cost.toml", "'$cost.toml'"),
        ("it's $1", "'it''s $1'"),
    ],
)
def test_on_windows_they_are_what_powershell_takes(
    monkeypatch: pytest.MonkeyPatch, word: str, wanted: str
) -> None:
    monkeypatch.setattr(sys, "platform", "win32")
    assert command_line(["jounce", word]) == f"jounce {wanted}"


def test_on_windows_words_of_a_line_are_those_that_made_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "platform", "win32")
    words = [word for word in WORDS if word]
    assert words_of(command_line(words)) == words
