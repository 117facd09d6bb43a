"""Two processes in one folder, one file, one cache: each does its work whole, the later one wins."""

from __future__ import annotations

import contextlib
import os
import subprocess
import sys
from pathlib import Path

import pytest

from jounce.core import writing
from jounce.core.errors import OutputError
from jounce.core.writing import write_files

WRITER = """
import sys
from jounce.core.writing import write_atomically, write_files
who = sys.argv[1]
for k in range(40):
    write_files("out", {f"{i}.txt": who * 1000 for i in range(12)}, force=True)
    write_atomically("one.txt", who * 100_000, force=True)
"""


def test_folders_and_files_are_those_of_one_of_them(tmp_path: Path) -> None:
    asked = [[sys.executable, "-c", WRITER, who] for who in "ab"]
    both = [subprocess.Popen(one, cwd=tmp_path, stderr=subprocess.PIPE) for one in asked]
    assert [one.communicate(timeout=120)[1] for one in both] == [b"", b""]
    contents = {file.read_text() for file in (tmp_path / "out").iterdir()}
    assert contents in ({"a" * 1000}, {"b" * 1000})
    assert (tmp_path / "one.txt").read_text() in ("a" * 100_000, "b" * 100_000)
    assert sorted(file.name for file in tmp_path.iterdir()) == ["one.txt", "out"]
    assert len(list((tmp_path / "out").iterdir())) == 12


@pytest.mark.parametrize("force", [False, True])
def test_a_folder_that_appears_meanwhile(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, force: bool
) -> None:
    renamed = writing._move_into_place

    def late(built: Path, root: Path) -> bool:
        root.mkdir()
        (root / "a.txt").write_text("theirs")
        return renamed(built, root)

    monkeypatch.setattr(writing, "_move_into_place", late)
    if force:
        write_files(tmp_path / "out", {"a.txt": "ours"}, force=True)
    else:
        with pytest.raises(OutputError, match="the output already exists"):
            write_files(tmp_path / "out", {"a.txt": "ours"})
    assert (tmp_path / "out" / "a.txt").read_text() == ("ours" if force else "theirs")
    assert [file.name for file in tmp_path.iterdir()] == ["out"]


@pytest.mark.parametrize("has_links", [True, False])
def test_a_file_that_appears_meanwhile(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, has_links: bool
) -> None:
    if not has_links:

        def refused(*_: object) -> None:
            raise PermissionError(1, "Operation not permitted")

        monkeypatch.setattr(os, "link", refused)
    file = tmp_path / "run.csv"
    for force in (False, True):
        with contextlib.ExitStack() as stack:
            if not force:
                stack.enter_context(pytest.raises(OutputError, match="the output already exists"))
            with writing.replacing(file, force=force) as temporary:
                temporary.write_text("ours")
                file.write_text("theirs")
        assert file.read_text() == ("ours" if force else "theirs")
        assert [one.name for one in tmp_path.iterdir()] == ["run.csv"]
        file.unlink()
    writing.write_atomically(file, "ours")
    assert file.read_text() == "ours"
    assert [one.name for one in tmp_path.iterdir()] == ["run.csv"]
    assert file.stat().st_nlink == 1
