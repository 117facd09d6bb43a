from __future__ import annotations

import errno
import os
from pathlib import Path

import pytest

from jounce.core.errors import OutputError
from jounce.core.writing import check_folder
from jounce.report.render import write_folder

FILES = {"report.html": "<p>new</p>", "figures/a.svg": b"<svg/>"}


def listing(folder: Path) -> dict[str, str]:
    return {
        str(file.relative_to(folder)): file.read_text(encoding="utf-8")
        for file in sorted(folder.rglob("*"))
        if file.is_file()
    }


NEW = {"figures/a.svg": "<svg/>", "report.html": "<p>new</p>"}


@pytest.mark.parametrize("exists", [False, True])
def test_new_or_empty_folder(exists: bool, tmp_path: Path) -> None:
    out = tmp_path / "deep" / "out"
    if exists:
        out.mkdir(parents=True)
    assert write_folder(out, FILES) == [out / "report.html", out / "figures" / "a.svg"]
    assert listing(out) == NEW
    assert [entry.name for entry in out.parent.iterdir()] == ["out"]  # nothing temporary is left
    assert oct(out.stat().st_mode & 0o777) == "0o755"


def test_full_folder_is_refused(tmp_path: Path) -> None:
    (tmp_path / "mine.txt").write_text("mine", encoding="utf-8")
    with pytest.raises(OutputError, match=r"not empty.*--force"):
        write_folder(tmp_path, FILES)
    assert listing(tmp_path) == {"mine.txt": "mine"}


def test_force_replaces_its_own_files_only(tmp_path: Path) -> None:
    out = tmp_path / "out"
    (out / "figures").mkdir(parents=True)
    for name in ("mine.txt", "report.html", "figures/old.svg"):
        (out / name).write_text("old", encoding="utf-8")
    write_folder(out, FILES, force=True)
    assert listing(out) == {**NEW, "mine.txt": "old", "figures/old.svg": "old"}
    assert [entry.name for entry in tmp_path.iterdir()] == ["out"]


@pytest.mark.parametrize("force", [False, True])
def test_a_file_in_its_place(force: bool, tmp_path: Path) -> None:
    out = tmp_path / "out"
    out.write_text("mine", encoding="utf-8")
    with pytest.raises(OutputError, match="is a file, not a folder"):
        write_folder(out, FILES, force=force)
    assert out.read_text(encoding="utf-8") == "mine"


def test_folder_where_a_file_should_be(tmp_path: Path) -> None:
    (tmp_path / "report.html" / "mine").mkdir(parents=True)
    with pytest.raises(OutputError, match="a folder with this name exists"):
        write_folder(tmp_path, FILES, force=True)


def test_file_where_a_folder_should_be(tmp_path: Path) -> None:
    (tmp_path / "figures").write_text("mine", encoding="utf-8")
    (tmp_path / "report.html").write_text("old", encoding="utf-8")
    with pytest.raises(OutputError, match="a file with this name exists"):
        write_folder(tmp_path, FILES, force=True)
    assert listing(tmp_path) == {"figures": "mine", "report.html": "old"}


def test_nothing_escapes_the_folder(tmp_path: Path) -> None:
    with pytest.raises(OutputError):
        write_folder(tmp_path / "out", {"../evil.html": "x"})
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("force", [False, True])
def test_full_disk_changes_nothing(
    force: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "out"
    if force:
        out.mkdir()
        (out / "report.html").write_text("old", encoding="utf-8")
    whole = Path.write_bytes

    def full(self: Path, content: bytes) -> int:
        if self.name == "a.svg":
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return whole(self, content)

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(OutputError, match=r"cannot be written.*No space left"):
        write_folder(out, FILES, force=force)
    assert listing(tmp_path) == ({"out/report.html": "old"} if force else {})


def test_link_to_a_folder(tmp_path: Path) -> None:
    real = tmp_path / "real"
    real.mkdir()
    (tmp_path / "link").symlink_to(real)
    write_folder(tmp_path / "link", FILES)
    assert listing(real) == NEW
    assert (tmp_path / "link").is_symlink()


def test_check_alone_writes_nothing(tmp_path: Path) -> None:
    assert check_folder(tmp_path / "new") == (tmp_path / "new").resolve()
    assert list(tmp_path.iterdir()) == []
