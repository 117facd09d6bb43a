"""A process that is killed while it exchanges the files of a folder loses none of them, and mixes nothing."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from jounce.core import writing
from jounce.core.files import existing_file
from jounce.core.writing import write_files

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="needs processes that are forked")
NAMES = ("campaign.toml", "rig.toml", "trials/01.csv", "trials/02.csv")
OLD, NEW = (dict.fromkeys(NAMES, age) for age in ("old", "new"))
KEPT = "notes.txt"


def contents(folder: Path) -> dict[str, str]:
    files = [file for file in folder.rglob("*") if file.is_file()]
    return {file.relative_to(folder).as_posix(): file.read_text() for file in files}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    write_files(tmp_path / "mine", OLD)
    (tmp_path / "mine" / KEPT).write_text("by hand")
    return tmp_path / "mine"


@pytest.fixture(autouse=True)
def _as_another_process(monkeypatch):
    """What a process has swept once it does not sweep again; here each step counts as a process of its own."""
    monkeypatch.setattr(writing, "_sweep", writing._sweep.__wrapped__)


def killed_at(step: int, folder: Path) -> bool:
    """Write new files in a child that ends before its nth operation on the disk; whether it got that far."""
    child = os.fork()
    if child == 0:
        left = step

        def counted(act):
            def do(*arguments, **options):
                nonlocal left
                left -= 1
                if left == 0:
                    os._exit(9)
                return act(*arguments, **options)

            return do

        for name in ("rename", "mkdir", "write_bytes", "unlink"):
            setattr(Path, name, counted(getattr(Path, name)))
        writing.shutil.rmtree = counted(writing.shutil.rmtree)
        write_files(folder, NEW, force=True)
        os._exit(0)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 9


def test_killed_at_every_step(folder: Path):
    seen, step = set(), 1
    while killed_at(step, folder):
        write_files(folder, {"other.txt": "by whoever comes next"}, force=True)
        there = contents(folder)
        assert there.pop(KEPT) == "by hand"
        assert there.pop("other.txt")
        assert there in (OLD, NEW), f"step {step}"
        seen.add(there["rig.toml"])
        assert not list(folder.glob(".jounce-*"))
        write_files(folder, OLD, force=True)
        step += 1
    assert seen == {"old", "new"}
    assert step > 20


def test_whoever_reads_finds_the_file(folder: Path):
    step = 1
    while killed_at(step, folder):
        assert existing_file(folder / "rig.toml").read_text() in ("old", "new")
        write_files(folder, OLD, force=True)
        step += 1


@pytest.mark.parametrize("refused", range(1, 10))
@pytest.mark.parametrize("lasting", [False, True])
def test_a_disk_that_refuses(folder: Path, monkeypatch, refused: int, lasting: bool):
    """Moves fail from the nth on, or once: the old files stay or come back, at the latest with the next process."""
    count, rename = 0, Path.rename

    def failing(self, target):
        nonlocal count
        count += 1
        if count == refused or (lasting and count > refused):
            raise OSError(28, "No space left on device")
        return rename(self, target)

    with monkeypatch.context() as patch:
        patch.setattr(Path, "rename", failing)
        with pytest.raises(writing.OutputError, match="No space left"):
            write_files(folder, NEW, force=True)
    monkeypatch.setattr(
        writing, "_THIS_RUN", "000000"
    )  # as if the next process had this one's number
    write_files(folder, {"other.txt": ""}, force=True)
    there = contents(folder)
    del there[KEPT], there["other.txt"]
    assert there in (OLD, NEW)
    assert there == OLD or lasting
