"""Files are open to those whom the user's mask lets in; one that is replaced stays as open as it was."""

from __future__ import annotations

import os
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest

import jounce as jn
from jounce.core.writing import replacing, write_atomically, write_files
from jounce.inspection.archive.store import Store
from jounce.kernel import cache
from jounce.plots.figures import write_figure

pytestmark = pytest.mark.skipif(os.name != "posix", reason="modes are those of POSIX")


@pytest.fixture(params=[0o077, 0o022, 0o002], ids="{:03o}".format)
def mask(request: pytest.FixtureRequest) -> Iterator[int]:
    before = os.umask(request.param)
    yield request.param
    os.umask(before)


def mode(file: Path) -> str:
    return f"{file.stat().st_mode & 0o777:o}"


def test_new_files_are_as_open_as_the_mask_lets_them_be(tmp_path: Path, mask: int) -> None:
    write_atomically(tmp_path / "one.txt", "one")
    (two,) = write_files(tmp_path / "folder", {"two.txt": "two"})
    (three,) = write_files(tmp_path / "folder", {"in/three.txt": "three"})
    figure = write_figure(
        jn.plots.modes(jn.modes(jn.load("kart-quarter-car"))), tmp_path / "four.svg"
    )
    store = Store(tmp_path / "lane.sqlite")
    files = [tmp_path / "one.txt", two, three, figure, tmp_path / "lane.sqlite"]
    assert {mode(file) for file in files} == {f"{0o666 & ~mask:o}"}
    assert {mode(folder) for folder in (two.parent, three.parent)} == {f"{0o777 & ~mask:o}"}
    assert store.numbers() == []


def test_a_file_that_is_replaced_stays_as_open_as_it_was(tmp_path: Path, mask: int) -> None:
    for kept in (0o600, 0o640, 0o664, 0o444):
        one, two = tmp_path / f"{kept:o}.txt", tmp_path / f"{kept:o}" / "two.txt"
        write_atomically(one, "old")
        write_files(two.parent, {"two.txt": "old"})
        one.chmod(kept)
        two.chmod(kept)
        write_atomically(one, "new", force=True)
        write_files(two.parent, {"two.txt": "new"}, force=True)
        assert (one.read_text(), two.read_text()) == ("new", "new")
        assert (mode(one), mode(two)) == (f"{kept:o}", f"{kept:o}")


def test_what_takes_the_place_of_a_private_file_is_private_from_its_first_byte(
    tmp_path: Path, mask: int
) -> None:
    file = tmp_path / "plates.csv"
    file.touch()
    file.chmod(0o600)
    with replacing(file) as temporary:
        assert mode(temporary) == "600"


def test_code_is_never_open_to_be_written_by_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, mask: int
) -> None:
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path / "cache"))
    cache.keep("a" * 64, b"code")
    file = tmp_path / "cache" / f"{'a' * 64}.o"
    assert mode(file) == f"{0o644 & ~mask:o}"
    assert cache.recall("a" * 64) == b"code"
    file.chmod(0o666)  # and what somebody has opened is closed again where it is made anew
    cache.keep("a" * 64, b"code")
    assert mode(file) == "644"


def test_the_mask_of_other_threads_stays(tmp_path: Path) -> None:
    """To read the mask it would have to be set for a moment, for all threads."""
    before, wrong, ended = os.umask(0o027), [], threading.Event()

    def write() -> None:
        for k in range(300):
            (tmp_path / f"{k}").touch()
            wrong.extend([mode(tmp_path / f"{k}")] * (mode(tmp_path / f"{k}") != "640"))
        ended.set()

    thread = threading.Thread(target=write)
    thread.start()
    while not ended.is_set():
        write_atomically(tmp_path / "file.txt", "x", force=True)
    thread.join()
    os.umask(before)
    assert wrong == []
