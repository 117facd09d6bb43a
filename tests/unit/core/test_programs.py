"""Programs are those of the path: never of the folder that one stands in, which an archive may have brought."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from jounce.core.programs import program_on_path


def made(folder: Path, name: str, mode: int = 0o755) -> Path:
    folder.mkdir(exist_ok=True)
    file = folder / name
    file.write_text("#!/bin/sh\n")
    file.chmod(mode)
    return file


def test_the_first_folder_that_has_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made(tmp_path / "a", "other")
    first, _ = made(tmp_path / "b", "cc"), made(tmp_path / "c", "cc")
    monkeypatch.setenv("PATH", os.pathsep.join(str(tmp_path / one) for one in "abc"))
    assert program_on_path("cc") == str(first)
    assert program_on_path("gcc") is None


def test_the_current_folder_is_not_looked_in(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made(tmp_path, "cc")
    made(tmp_path / "sub", "cc")
    monkeypatch.chdir(tmp_path)
    for path in ("", ".", os.pathsep, "sub", f"sub{os.pathsep}."):
        monkeypatch.setenv("PATH", path)
        assert program_on_path("cc") is None
    monkeypatch.delenv("PATH")
    assert program_on_path("cc") != str(tmp_path / "cc")


@pytest.mark.skipif(os.name != "posix", reason="rights to run are a thing of POSIX")
def test_what_cannot_be_run_is_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made(tmp_path, "cc", 0o644)
    (tmp_path / "gcc").mkdir()
    monkeypatch.setenv("PATH", str(tmp_path))
    assert program_on_path("cc") is program_on_path("gcc") is None


def test_suffixes_of_windows(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = made(tmp_path, "ffmpeg.BAT")
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setenv("PATHEXT", os.pathsep.join((".EXE", ".BAT")))
    assert program_on_path("ffmpeg") == str(file)
    monkeypatch.delenv("PATHEXT")
    assert program_on_path("ffmpeg") is None
