"""Command lines to copy, quoted for the shell of this system."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from collections.abc import Iterable

_PLAIN = re.compile(r"[\w./\\:=+-]+", re.ASCII)


def command_line(words: Iterable[str]) -> str:
    """Join words to one line to paste: for a POSIX shell, or on Windows for PowerShell and the command prompt.

    On Windows both accept double quotes, but PowerShell interprets ``$`` and backticks inside them. A word that
    contains one is put in single quotes, which only PowerShell understands.

    >>> command_line(["jounce", "check", "front axle.toml"]).replace('"', "'")
    "jounce check 'front axle.toml'"
    """
    return " ".join(
        _for_windows(word) if sys.platform == "win32" else shlex.quote(word) for word in words
    )


def words_of(line: str) -> list[str]:
    """Split a line made by ``command_line`` on this system into its words.

    >>> words_of(command_line(["jounce", "check", "front axle.toml"]))
    ['jounce', 'check', 'front axle.toml']
    """
    if sys.platform != "win32":
        return shlex.split(line)
    return [word[1:-1] if word[0] in "\"'" else word for word in shlex.split(line, posix=False)]


def _for_windows(word: str) -> str:
    if _PLAIN.fullmatch(word):
        return word
    if re.search("[$`]", word):
        return "'" + word.replace("'", "''") + "'"
    plain = subprocess.list2cmdline([word])
    return plain if plain.startswith('"') else f'"{plain}"'


def typed_command(word: str) -> str:
    """Return the command line of this process if its command is that word, otherwise an empty text."""
    return command_line(["jounce", *sys.argv[1:]]) if sys.argv[1:2] == [word] else ""
