"""Pipes, sockets and devices in the place of files: nothing waits for them, and nothing is read from them."""

from __future__ import annotations

import io
import json
import os
import socket
import subprocess
import sys
import zipfile
from pathlib import Path

import openpyxl
import pytest

from jounce.cli import main
from jounce.core.description import read_toml
from jounce.core.errors import DescriptionError, RecordingError
from jounce.core.files import content_of, existing_file
from jounce.inspection.archive.store import Store
from jounce.inspection.archive.watching import FolderWatch
from jounce.parts.importers import import_hardpoints
from jounce.parts.importers.chrono_file import read_json

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
    [
        "simulate",
        "kart-quarter-car",
        "--road",
        "pipe.toml",
        "--speed",
        "1 m/s",
        "--duration",
        "1 s",
    ],
    ["simulate", "kart-quarter-car", "--road", "pipe.crg", "--speed", "1 m/s", "--duration", "1 s"],
    ["simulate", "kart-quarter-car", "--excitation", "pipe.csv"],
    *(
        ["plot", f"pipe.{suffix}", "--figure", "out.png"]
        for suffix in ("csv", "mat", "nc", "tdms", "uff", "mf4")
    ),
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


@pytest.mark.slow
def test_no_command_waits_for_a_pipe(tmp_path: Path) -> None:
    for suffix in {
        file.partition(".")[2]
        for command in COMMANDS
        for file in command
        if file.startswith("pipe.")
    }:
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
        ran = subprocess.run(
            asked, cwd=tmp_path, capture_output=True, text=True, timeout=120, check=False
        )
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
    with pytest.raises(
        RecordingError, match=r"too large to be read as a whole; found '5 GB'; allowed: up to 1 GB"
    ):
        content_of(tmp_path / "large.csv", RecordingError)
    assert (
        main(
            [
                "inspect",
                "import",
                str(tmp_path / "large.csv"),
                "--store",
                str(tmp_path / "lane.sqlite"),
            ]
        )
        == 2
    )


def test_what_is_opened_is_what_is_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    os.mkfifo(tmp_path / "pipe.csv")
    monkeypatch.setattr(
        "jounce.core.files.existing_file", lambda path, _: Path(path)
    )  # it was one just before
    with pytest.raises(DescriptionError, match="a pipe or a device"):
        content_of(tmp_path / "pipe.csv")


def test_names_that_no_file_has(tmp_path: Path) -> None:
    with pytest.raises(DescriptionError, match="no such file"):
        existing_file("a\0b")
    assert main(["modes", "a\0b.toml"]) == 2
    assert main(["modes", "x" * 5000 + ".toml"]) == 2


def test_paths_that_lead_nowhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys) -> None:
    """A link to itself, a home of nobody, and a NUL, which no argument of a program has."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "loop").symlink_to("loop")
    for folder in ("loop", "loop/x", "~no-such-user/x"):
        assert main(["campaign", "synthesise", folder]) == 2
        assert capsys.readouterr().err.startswith(f"jounce: {folder}: the path is invalid")
    assert main(["campaign", "new", "loop"]) == 2
    assert main(["check", "loop"]) == 2
    assert "internal" not in capsys.readouterr().err
    for words in (
        ["modes", "a\0b"],
        ["inspect", "search", "--store", "a\0"],
        ["campaign", "new", "\0"],
    ):
        assert main(words) == 2
        assert "an argument with a NUL character" in capsys.readouterr().err
    assert [one.name for one in tmp_path.iterdir()] == ["loop"]


@pytest.mark.skipif(not Path("/proc/self/mem").exists(), reason="a thing of Linux")
@pytest.mark.parametrize("command", [["modes"], ["check"], ["iri"]])
def test_a_file_that_cannot_be_read_is_named(command: list[str], tmp_path: Path, capsys) -> None:
    for suffix in (".toml", ".csv"):
        (tmp_path / f"a{suffix}").symlink_to("/proc/self/mem")
        assert main([*command, str(tmp_path / f"a{suffix}")]) == 2
        said = capsys.readouterr().err
        assert f"a{suffix}" in said
        assert "internal" not in said


def test_descriptions_of_every_system_are_read(tmp_path: Path) -> None:
    for end in ("\n", "\r\n", "\r"):
        (tmp_path / "road.toml").write_bytes(
            end.join(['schema = "jounce.road/1"', 'kind = "step"', 'height = "1 cm"', ""]).encode()
        )
        assert main(["check", str(tmp_path / "road.toml")]) == 0


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "utf-16-be"])
def test_descriptions_with_a_mark_of_their_encoding_are_read(encoding: str, tmp_path: Path) -> None:
    """As editors of Windows save them, and PowerShell what a command prints."""
    mark = "\ufeff" if encoding == "utf-16-be" else ""
    (tmp_path / "a.toml").write_bytes(
        f'{mark}schema = "jounce.road/1"\nkind = "step"\nheight = "1 cm"'.encode(encoding)
    )
    assert read_toml(tmp_path / "a.toml")[0]["kind"] == "step"
    (tmp_path / "a.json").write_bytes(f'{mark}{{"Name": "ä"}}'.encode(encoding))
    assert read_json(tmp_path / "a.json") == {"Name": "ä"}


def test_half_a_letter_is_no_text(tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_bytes("a = 1".encode("utf-16")[:-1])
    with pytest.raises(DescriptionError, match="not a text file"):
        read_toml(tmp_path / "a.toml")


@pytest.mark.parametrize(
    ("told", "row"), [("A1:XFD1048576", 1048576), ("A1:D2", 10**10), ("A1", 30_000)]
)
def test_sheets_that_tell_billions_of_cells(tmp_path: Path, told: str, row: int) -> None:
    sheet = f"""<worksheet xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"><dimension ref="{told}"/>
    <sheetData><row r="1"><c r="A1"><v>1</v></c></row><row r="{row}"><c r="A{row}"><v>1</v></c></row></sheetData>
    </worksheet>"""
    book, small, large = openpyxl.Workbook(), io.BytesIO(), tmp_path / "points.xlsx"
    book.save(small)
    with (
        zipfile.ZipFile(small) as archive,
        zipfile.ZipFile(large, "w", zipfile.ZIP_DEFLATED) as made,
    ):
        for info in archive.infolist():
            made.writestr(
                info.filename, sheet if info.filename.endswith("sheet1.xml") else archive.read(info)
            )
    with pytest.raises(DescriptionError, match="too many rows"):
        import_hardpoints(large)
