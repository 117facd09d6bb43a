"""What a process finds around it: closed and full streams, odd variables, a folder that is gone. None is a crash."""

from __future__ import annotations

import errno
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from jounce.cli import entry, main
from jounce.cli.reply import make_streams_usable

posix = pytest.mark.skipif(os.name != "posix", reason="streams are closed otherwise elsewhere")
COMMAND = [sys.executable, "-m", "jounce"]


def closing(*numbers: int) -> Callable[[], None]:
    def close() -> None:
        for number in numbers:
            os.close(number)

    return close


@posix
@pytest.mark.parametrize(
    ("closed", "words", "code"),
    [
        ((1,), ["version"], 0),
        ((2,), ["modes", "nothing"], 2),
        ((0, 1, 2), ["campaign", "new", "mine"], 0),
    ],
)
def test_closed_streams_change_nothing(
    closed: tuple[int, ...], words: list[str], code: int, tmp_path: Path
) -> None:
    ran = subprocess.run(
        [*COMMAND, *words],
        cwd=tmp_path,
        capture_output=True,
        preexec_fn=closing(*closed),
        check=False,
    )
    assert ran.returncode == code, ran.stderr
    assert ran.stderr == b""
    assert (tmp_path / "mine" / "campaign.toml").is_file() == (words[0] == "campaign")


def test_streams_that_a_program_does_not_have() -> None:
    with pytest.MonkeyPatch.context() as patch:
        for name in ("stdin", "stdout", "stderr"):  # as in programs of Windows without a console
            patch.setattr(sys, name, None)
        assert main(["modes", "nothing"]) == 2
        for stream in (sys.stdin, sys.stdout, sys.stderr):
            stream.close()


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no device that is always full")
@pytest.mark.parametrize("words", [["version", "--json"], ["modes", "--help"]])
def test_an_answer_that_does_not_fit_is_told(words: list[str]) -> None:
    with Path("/dev/full").open("wb") as full:
        ran = subprocess.run(
            [*COMMAND, *words], stdout=full, stderr=subprocess.PIPE, text=True, check=False
        )
    assert ran.returncode == 2
    hint = "Check the path, the permissions and the free disk space."
    assert ran.stderr == f"jounce: standard output: {os.strerror(errno.ENOSPC)}. {hint}\n"


@posix
def test_nobody_reads_what_is_said() -> None:
    reads, writes = os.pipe()
    os.close(reads)
    helped = subprocess.run(
        [*COMMAND, "--help"], stdout=writes, stderr=subprocess.PIPE, check=False
    )
    refused = subprocess.run(
        [*COMMAND, "modes", "nothing"], stdout=subprocess.PIPE, stderr=writes, check=False
    )
    os.close(writes)
    assert (helped.returncode, helped.stderr) == (141, b"")
    assert (refused.returncode, refused.stdout) == (2, b"")


@posix
def test_a_folder_that_is_gone_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "gone").mkdir()
    os.chdir("gone")
    (tmp_path / "gone").rmdir()
    assert main(["campaign", "new", "mine"]) == 2
    assert capsys.readouterr().err.startswith(
        "jounce: the current folder: No such file or directory. "
    )


@pytest.mark.parametrize("columns", ["1", "9" * 30, "\u00b2"])
def test_widths_that_no_terminal_has(columns: str, monkeypatch: pytest.MonkeyPatch, capsys) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    assert main(["version"]) == 0
    assert "python 3" in capsys.readouterr().out
    assert main(["modes", "--help"]) == 0
    assert max(map(len, capsys.readouterr().out.splitlines())) in range(20, 1001)
    monkeypatch.setenv("COLUMNS", "72")
    make_streams_usable()
    assert os.environ["COLUMNS"] == "72"


def test_a_window_that_figures_do_not_need() -> None:
    script = "from jounce.plots.figures import style\nwith style(): import matplotlib.figure"
    asked = [sys.executable, "-c", script]
    environment = {**os.environ, "MPLBACKEND": "nonsense"}
    ran = subprocess.run(asked, env=environment, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr


def test_a_library_that_cannot_be_loaded_is_told(monkeypatch: pytest.MonkeyPatch, capsys) -> None:
    def missing(_: object) -> None:
        raise ImportError("libsqlite3.so.0: failed to map segment from shared object")

    monkeypatch.setattr(entry, "_answer", missing)
    assert main(["version"]) == 2
    said = capsys.readouterr().err
    assert said.startswith(
        "jounce: a library cannot be loaded; found 'libsqlite3.so.0: failed to map"
    )
    assert "memory" in said
