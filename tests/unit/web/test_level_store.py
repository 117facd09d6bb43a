"""Records that were read are kept for the next server: whole or not at all, bounded, and never of another content."""

from __future__ import annotations

import os
import shutil
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from jounce.core.errors import JounceError

pytest.importorskip("fastapi")
from jounce.web import level_store
from jounce.web.jobs import Jobs
from jounce.web.levels import write_levels
from jounce.web.project import Project
from jounce.web.records import Records

CONTENT = "time [s],x [mm]\n" + "".join(f"{k / 10},{k % 7}\n" for k in range(2000))


@pytest.fixture
def serve(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Callable[[], tuple[Records, list[str]]]:
    """Start the records of another server; return them, and the titles of what it reads."""
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path / "cache"))
    (tmp_path / "project").mkdir()
    (tmp_path / "project" / "run.csv").write_text(CONTENT)

    def start() -> tuple[Records, list[str]]:
        jobs = Jobs(Project(tmp_path / "project"))
        asked: list[str] = []

        def ask(spec: Any) -> None:
            asked.append(spec.title)
            write_levels(Path(spec.question["file"]), Path(spec.question["folder"]))

        jobs.ask = ask
        return Records(jobs.project, jobs), asked

    return start


def entries(tmp_path: Path) -> list[Path]:
    return [entry for entry in (tmp_path / "cache" / "records").iterdir() if entry.name[0] != "."]


def test_a_restarted_server_opens_a_record_without_reading_it(serve: Any, tmp_path: Path) -> None:
    first, asked = serve()
    wanted = first.open("run.csv").viewer(["x"], 0.0, 200.0, 50).scenes[0].panes[0].curves[0].values
    first.end()
    assert asked == ["Reading run.csv"]
    again, asked = serve()
    levels = again.open("run.csv")
    values = levels.viewer(["x"], 0.0, 200.0, 50).scenes[0].panes[0].curves[0].values
    np.testing.assert_array_equal(values, wanted)
    assert asked == []
    (tmp_path / "project" / "run.csv").write_text(CONTENT.replace("0.1,1", "0.1,5"))
    assert again.open("run.csv").samples("x")[1] == 5.0
    assert asked == ["Reading run.csv"]
    again.end()
    assert len(entries(tmp_path)) == 2
    assert not list((tmp_path / "cache" / "records").glob(".jounce-*"))


@pytest.mark.parametrize("name", ["0.npy", "0.levels.npy", "about.json", "seal.json"])
@pytest.mark.parametrize("damage", ["cut", "changed", "gone", "no entry"])
def test_a_damaged_entry_is_read_anew(serve: Any, tmp_path: Path, name: str, damage: str) -> None:
    first, _ = serve()
    first.open("run.csv")
    first.end()
    (entry,) = entries(tmp_path)
    file = entry / name
    content = file.read_bytes()
    if damage == "cut":
        file.write_bytes(content[:-7])
    elif damage == "changed":
        middle = len(content) // 2
        file.write_bytes(content[:middle] + b"\xff\xfe" + content[middle + 2 :])
    elif damage == "gone":
        file.unlink()
    else:
        shutil.rmtree(entry)
        entry.write_bytes(content)
    again, asked = serve()
    assert again.open("run.csv").samples("x")[:3].tolist() == [0.0, 1.0, 2.0]
    assert asked == ["Reading run.csv"]
    again.end()
    if damage != "no entry":
        third, asked = serve()
        third.open("run.csv")
        third.end()
        assert asked == []


def test_entries_of_another_version_of_the_reader_are_not_used(
    serve: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, _ = serve()
    first.open("run.csv")
    first.end()
    monkeypatch.setattr(level_store, "digest_of", lambda *_: "a later version")
    again, asked = serve()
    again.open("run.csv")
    again.end()
    assert asked == ["Reading run.csv"]


def test_the_oldest_entries_go_when_all_are_too_large(
    serve: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    records, _ = serve()
    records.open("run.csv")
    size = sum(file.stat().st_size for file in entries(tmp_path)[0].iterdir())
    monkeypatch.setattr(level_store, "_MOST_BYTES", int(2.5 * size))
    os.utime(entries(tmp_path)[0], (1e9, time.time() - 3600.0))
    seen = [entries(tmp_path)[0].name]
    for k in range(2):
        (tmp_path / "project" / f"{k}.csv").write_text(CONTENT)
        records.open(f"{k}.csv")
        seen += [entry.name for entry in entries(tmp_path) if entry.name not in seen]
    assert {entry.name for entry in entries(tmp_path)} == set(seen[1:])
    monkeypatch.setattr(level_store, "_MOST_BYTES", size // 2)
    (tmp_path / "project" / "last.csv").write_text(CONTENT)
    assert records.open("last.csv").about["count"] == 2000  # not kept, and nothing else is lost
    assert {entry.name for entry in entries(tmp_path)} == set(seen[1:])
    records.end()


def test_entries_that_were_not_used_for_a_month_go(serve: Any, tmp_path: Path) -> None:
    records, _ = serve()
    records.open("run.csv")
    (old,) = entries(tmp_path)
    os.utime(old, (1e9, time.time() - 40 * 86400.0))
    (tmp_path / "project" / "new.csv").write_text(CONTENT)
    records.open("new.csv")
    records.end()
    assert old not in entries(tmp_path)
    assert len(entries(tmp_path)) == 1


@pytest.mark.skipif(os.name != "posix", reason="modes have no meaning there")
def test_without_a_cache_folder_of_the_user_nothing_is_kept(serve: Any, tmp_path: Path) -> None:
    (tmp_path / "cache").mkdir()
    (tmp_path / "cache").chmod(0o777)
    for _ in range(2):
        records, asked = serve()
        records.open("run.csv")
        records.end()
        assert asked == ["Reading run.csv"]


def test_a_disk_without_links_keeps_nothing(serve: Any, tmp_path: Path, monkeypatch) -> None:
    def refuse(*_: Any) -> None:
        raise PermissionError(1, "no links")

    monkeypatch.setattr(os, "link", refuse)
    for _ in range(2):
        records, asked = serve()
        assert records.open("run.csv").about["count"] == 2000
        records.end()
        assert asked == ["Reading run.csv"]
    assert entries(tmp_path) == []


def test_the_share_of_a_text_that_is_read_is_known(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The whole way: the reader reports, its process writes, the server answers."""
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path / "cache"))
    rows = "".join(
        f"{k / 1000:.3f},{k % 999 / 7:.12f},{k % 777 / 13:.12f}\n" for k in range(30_000)
    )
    (tmp_path / "long.csv").write_text("time [s],x [mm],y [mm]\n" + 80 * rows)
    jobs = Jobs(Project(tmp_path))
    records = Records(jobs.project, jobs)
    assert records.reading() == []
    with ThreadPoolExecutor(1) as apart:
        opened = apart.submit(records.open, "long.csv")
        readings = []
        while not opened.done():
            readings += records.reading()
            time.sleep(0.02)
    with pytest.raises(JounceError, match="time does not increase"):
        opened.result()
    shares = [reading["share"] for reading in readings]
    known = [share for share in shares if share is not None]
    assert shares[0] is None
    assert known == sorted(known)
    assert any(0.0 < share < 1.0 for share in known)
    assert {reading["path"] for reading in readings} == {"long.csv"}
    assert readings[-1]["seconds"] > readings[0]["seconds"]
    assert records.reading() == []
    records.end()
    jobs.end()
