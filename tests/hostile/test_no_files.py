"""Pipes, sockets and devices in the place of files: nothing waits for them, and nothing is read from them."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from jounce.cli import main
from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.files import content_of, existing_file
from jounce.inspection.archive.store import Store
from jounce.inspection.archive.watching import FolderWatch

pytestmark = pytest.mark.skipif(os.name != "posix", reason="pipes with names are a thing of POSIX")

# One process for all commands, with a limit of time for all of them.
ALL = """
import json, sys
from jounce.cli import main
for command in json.loads(sys.argv[1]):
    print(main(command), " ".join(command), file=sys.stderr, flush=True)
"""
COMMANDS = [
    ["check", "pipe.toml"],
    ["check", "pipe.csv"],
    ["modes", "pipe.toml"],
    ["campaign", "run", "pipe.toml", "--out", "results"],
    ["simulate", "kart-quarter-car", "--road", "pipe.toml", "--speed", "1 m/s", "--duration", "1 s"],
    ["simulate", "kart-quarter-car", "--road", "pipe.crg", "--speed", "1 m/s", "--duration", "1 s"],
    ["simulate", "kart-quarter-car", "--excitation", "pipe.csv"],
    *(["plot", f"pipe.{suffix}", "--figure", "out.png"] for suffix in ("csv", "mat", "nc", "tdms", "uff", "mf4")),
    ["iri", "pipe.csv"],
    ["import", "tir", "pipe.tir"],
    ["import", "chrono", "pipe.json"],
    ["inspect", "evaluate", "pipe.csv"],
    ["inspect", "import", "pipe.csv", "--store", "lane.sqlite"],
    ["inspect", "search", "--store", "pipe.sqlite"],
    ["plot", "/dev/zero", "--figure", "out.png"],
    ["modes", "/dev/zero"],
    ["modes", "socket.toml"],
]


def test_no_command_waits_for_a_pipe(tmp_path: Path) -> None:
    for suffix in {file.partition(".")[2] for command in COMMANDS for file in command if file.startswith("pipe.")}:
        os.mkfifo(tmp_path / f"pipe.{suffix}")
    with socket.socket(socket.AF_UNIX) as listening:
        here = os.open(".", os.O_RDONLY)
        os.chdir(tmp_path)  # names of sockets are short
        try:
            listening.bind("socket.toml")
        finally:
            os.fchdir(here)
            os.close(here)
        asked = [sys.executable, "-c", ALL, json.dumps(COMMANDS)]
        ran = subprocess.run(asked, cwd=tmp_path, capture_output=True, text=True, timeout=120, check=False)
    codes = {line[2:]: line[0] for line in ran.stderr.splitlines() if line[:1].isdigit()}
    assert codes == {" ".join(command): "2" for command in COMMANDS}, ran.stderr
    assert "internal" not in ran.stderr


def test_a_watch_tells_a_pipe_once_and_goes_on(tmp_path: Path) -> None:
    store = Store(tmp_path / "lane.sqlite")
    watch = FolderWatch(tmp_path, store, settle=0.0)
    os.mkfifo(tmp_path / "a.csv")
    (tmp_path / "b.csv").write_text("time [s], left.pl")
    (tmp_path / "c.csv").symlink_to("nowhere")
    seen = {one.file.name: one.problem for one in watch.look()}
    assert list(seen) == ["a.csv", "b.csv"]
    assert "a pipe or a device, not a file" in str(seen["a.csv"])
    assert watch.look() == []
    store.close()


def test_sizes_are_bounded(tmp_path: Path) -> None:
    with (tmp_path / "large.csv").open("wb") as stream:
        stream.truncate(5_000_000_000)
    with pytest.raises(RecordingError, match=r"too large to be read as a whole; found '5 GB'; allowed: up to 1 GB"):
        content_of(tmp_path / "large.csv", RecordingError)
    assert main(["inspect", "import", str(tmp_path / "large.csv"), "--store", str(tmp_path / "lane.sqlite")]) == 2


def test_what_is_opened_is_what_is_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    os.mkfifo(tmp_path / "pipe.csv")
    monkeypatch.setattr("jounce.core.files.existing_file", lambda path, _: Path(path))  # it was one just before
    with pytest.raises(DescriptionError, match="a pipe or a device"):
        content_of(tmp_path / "pipe.csv")


def test_names_that_no_file_has(tmp_path: Path) -> None:
    with pytest.raises(DescriptionError, match="no such file"):
        existing_file("a\0b")
    assert main(["modes", "a\0b.toml"]) == 2
    assert main(["modes", "x" * 5000 + ".toml"]) == 2
