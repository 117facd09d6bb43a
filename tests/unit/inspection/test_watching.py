"""Watched folders: only finished files, each once, whatever else lies there."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from jounce.core.errors import JounceError, OutputError
from jounce.inspection.archive import watching
from jounce.inspection.archive.store import Store
from jounce.inspection.archive.watching import FolderWatch

HALF = '# plate_number = "B-AB 1"\n# date = 21.11.2026\ntime [s], left.plate.z [mm]\n'


class Clock:
    now = 0.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "lane").mkdir()
    return tmp_path / "lane"


@pytest.fixture
def store(tmp_path: Path) -> Store:
    return Store(tmp_path / "lane.sqlite")


def test_a_file_counts_when_it_has_stopped_growing(folder, store, clock) -> None:
    watch = FolderWatch(folder, store, settle=2.0, clock=clock)
    file = folder / "a.csv"
    for second, text in enumerate((HALF, HALF + "0, 1\n", HALF + "0, 1\n1, 2\n")):
        file.write_text(text)
        clock.now = float(second)
        assert watch.look() == []
        assert watch.waiting
    clock.now = 3.9
    assert watch.look() == []
    clock.now = 4.0
    (seen,) = watch.look()
    assert store.content(seen.imported.number)[0] == file.read_bytes()
    assert not watch.waiting
    clock.now = 99.0
    assert watch.look() == []


def test_the_file_beside_comes_along_and_a_later_one_makes_a_new_record(
    folder, store, clock
) -> None:
    watch = FolderWatch(folder, store, settle=0.0, clock=clock)
    (folder / "a.csv").write_text(HALF)
    (folder / "a.toml").write_text('plate_number = "B-XY 9"\n')
    assert store.content(watch.look()[0].imported.number)[1] == b'plate_number = "B-XY 9"\n'
    (folder / "a.toml").write_text('plate_number = "B-XY 10"\n')
    assert watch.look()[0].imported.is_new
    assert len(store.numbers()) == 2


def test_what_is_no_record_is_passed_over(folder, store) -> None:
    for name in (".hidden.csv", "~lock.csv", "note.pdf", "lane.sqlite"):
        (folder / name).write_text(HALF)
    (folder / "old.csv").mkdir()
    assert FolderWatch(folder, store, settle=0.0).look() == []


def test_an_unreadable_file_is_reported_once_and_remembered(folder, store, monkeypatch) -> None:
    (folder / "a.csv").write_text("")
    (folder / "b.csv").write_text(HALF)
    (folder / "gone.csv").symlink_to(folder / "nowhere")
    watch = FolderWatch(folder, store, settle=0.0)
    empty, half = watch.look()
    assert (empty.imported, "empty" in empty.problem) == (None, True)
    assert half.imported.verdict == "not graded"
    assert watch.look() == []
    assert FolderWatch(folder, store, settle=0.0).look() == []  # also after a new start
    (folder / "a.csv").write_text(HALF + "0, 1\n")
    assert [seen.imported.is_new for seen in watch.look()] == [True]
    assert sorted(path.name for path in folder.iterdir()) == ["a.csv", "b.csv", "gone.csv"]


def test_rights_that_are_missing(folder, store, monkeypatch) -> None:
    (folder / "a.csv").write_text(HALF)

    def refuse(self: Path, *_: object) -> bytes:
        raise PermissionError(13, "Permission denied", str(self))

    watch = FolderWatch(folder, store, settle=0.0)
    with monkeypatch.context() as context:
        context.setattr("jounce.inspection.archive.lane.content_of", refuse)
        assert [seen.problem for seen in watch.look()] == ["cannot be read: Permission denied"]
    assert watch.look() == []
    os.utime(folder / "a.csv", ns=(0, 0))
    assert len(watch.look()) == 1


def test_a_store_that_is_busy_is_tried_again(folder, store, monkeypatch) -> None:
    (folder / "a.csv").write_text(HALF)
    watch = FolderWatch(folder, store, settle=0.0)

    def busy(*_: object, **__: object) -> None:
        raise OutputError("the store cannot be used: database is locked", where=store.location)

    with monkeypatch.context() as context:
        context.setattr(watching, "import_record", busy)
        assert "tries again" in watch.look()[0].problem
        assert watch.look() == []  # said once
        assert watch.waiting
    assert watch.look()[0].imported.is_new


def test_a_folder_that_goes_away_may_come_back(folder, store) -> None:
    watch = FolderWatch(folder, store, settle=0.0)
    folder.rename(folder.parent / "away")
    assert [seen.problem for seen in watch.look()] == [
        "the folder cannot be read: No such file or directory"
    ]
    assert watch.look() == []
    folder.mkdir()
    (folder / "a.csv").write_text(HALF)
    assert len(watch.look()) == 1
    with pytest.raises(JounceError, match="no such folder"):
        FolderWatch(folder / "nowhere", store)


def test_what_jounce_writes_into_the_folder_is_no_record(folder, store, clock, monkeypatch) -> None:
    """A protocol's values and exported tables are formats that recordings are read from, or may be one day."""
    from jounce.inspection.archive.exporting import export

    monkeypatch.setattr(watching, "record_suffixes", lambda: (".csv", ".parquet", ".json"))
    watch = FolderWatch(folder, store, settle=0.0, clock=clock)
    (folder / "car.json").write_text('{\n  "schema": "jounce.protocol/1",\n  "software": {}}')
    export([{"number": 1, "wheel": "left", "adhesion": 0.5}], folder / "lane.csv")
    pytest.importorskip("pyarrow")
    export([{"number": 1, "wheel": "left", "adhesion": 0.5}], folder / "lane.parquet")
    (folder / "record.csv").write_text(HALF + "0, 1\n")
    assert [seen.file.name for seen in watch.look()] == ["record.csv"]
    assert not watch.waiting
    assert watch.look() == []
