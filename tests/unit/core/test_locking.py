"""One process at a time: what one holds, others do not get, on Windows too, until it lets go or ends."""

from __future__ import annotations

import errno
import fcntl
import os
import subprocess
import sys
import types
from pathlib import Path

import pytest

from jounce.core import locking
from jounce.core.locking import hold, holding, is_held

OTHER = "import pathlib, sys; from jounce.core.locking import is_held; print(is_held(pathlib.Path(sys.argv[1])))"


def held_elsewhere(place: Path) -> bool:
    """Whether a process of its own finds the place held."""
    done = subprocess.run(
        [sys.executable, "-c", OTHER, str(place)], capture_output=True, text=True, check=True
    )
    return {"True": True, "False": False}[done.stdout.strip()]


@pytest.mark.parametrize("kind", ["file", "folder"])
def test_another_process_is_kept_out_until_this_one_lets_go(tmp_path: Path, kind: str) -> None:
    place = tmp_path if kind == "folder" else tmp_path / "alive"
    assert not held_elsewhere(place)
    with holding(place):
        assert held_elsewhere(place)
    assert not held_elsewhere(place)


@pytest.mark.parametrize("kind", ["file", "folder"])
def test_on_windows_a_byte_is_locked_of_the_file_or_of_one_for_the_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    """As the documentation of `msvcrt.locking` says: what is locked by another handle is refused with EACCES."""
    taken: dict[tuple[int, int], int] = {}

    def lock(handle: int, how: int, count: int) -> None:
        assert (how, count) == (2, 1)
        about = os.fstat(handle)
        owner = taken.setdefault((about.st_dev, about.st_ino), handle)
        if owner != handle and is_open(owner):
            raise OSError(errno.EACCES, "Permission denied")
        taken[about.st_dev, about.st_ino] = handle

    def is_open(handle: int) -> bool:
        try:
            fcntl.fcntl(handle, fcntl.F_GETFD)
        except OSError:
            return False
        return True

    project, temporary = tmp_path / "project", tmp_path / "temporary"
    project.mkdir()
    temporary.mkdir()
    monkeypatch.setattr(sys, "platform", "win32")
    monkeypatch.setattr(locking.tempfile, "gettempdir", lambda: str(temporary))
    monkeypatch.setitem(sys.modules, "msvcrt", types.SimpleNamespace(locking=lock, LK_NBLCK=2))
    place = project if kind == "folder" else project / "alive"
    first = hold(place)
    assert first is not None
    assert hold(place) is None
    assert is_held(place)
    other = hold(tmp_path if kind == "folder" else project / "other")
    assert other is not None
    os.close(first)
    assert not is_held(place)
    os.close(other)
    assert {one.name for one in project.iterdir()} == (
        set() if kind == "folder" else {"alive", "other"}
    )


def test_where_nothing_can_be_locked_nobody_is_kept_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(handle: int, how: int) -> None:
        raise OSError(errno.ENOLCK, "No locks available")

    monkeypatch.setattr(fcntl, "flock", refuse)
    assert not is_held(tmp_path)
