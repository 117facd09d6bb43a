"""Native code is kept where that is possible, and taken for no other kernel's."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

from jounce.core import ownership
from jounce.core.ownership import ForeignError
from jounce.kernel import native


def test_without_a_home_folder_models_are_compiled_all_the_same(monkeypatch):
    def homeless() -> None:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.delenv("JOUNCE_CACHE_DIR", raising=False)
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(native.Path, "home", homeless)
    with pytest.raises(RuntimeError):
        native.cache_folder()
    assert native.recall("key") is None
    native.keep("key", b"code")


def test_native_code_is_not_taken_from_another_kernel(monkeypatch, tmp_path):
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path))
    made = []

    def make() -> native.Source:
        made.append(1)
        return native.Source({})

    for digest in ("one kernel", "one kernel", "another kernel"):
        monkeypatch.setattr(native, "digest_of", lambda *_, digest=digest: digest)
        native.kept_code("nothing", make)
    assert len(made) == 2


@pytest.fixture
def cache(monkeypatch, tmp_path):
    """A cache with an entry, which is read; jounce is its owner's alone."""
    module = tmp_path / "native.py"
    module.touch(0o644)
    monkeypatch.setattr(ownership, "__file__", str(module))
    monkeypatch.setattr(ownership, "_is_private", lambda *_: False)
    folder = tmp_path / "cache"
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(folder))
    native._TOLD.clear()
    native.keep("key", b"code")
    assert native.recall("key") == b"code"
    return folder


OPEN = {"a file that all may write": ("key.o", 0o666), "a folder that all may write": (".", 0o777)}
OPEN |= {"a file of a group": ("key.o", 0o664), "a folder of a group": (".", 0o775)}


@pytest.mark.parametrize("what", OPEN)
def test_code_that_others_could_have_written_is_not_run_and_that_is_said(cache, caplog, what) -> None:
    name, mode = OPEN[what]
    (cache / name).chmod(mode)
    assert native.recall("key") is native.recall("key") is None
    (said,) = caplog.messages
    assert str(cache) in said
    assert "can be written by others" in said
    native.keep("another", b"code")
    assert (cache / "another.o").exists() == (name != ".")
    (cache / name).chmod(0o644 if name != "." else 0o755)
    assert native.recall("key") == b"code"


def is_ours(found: os.stat_result, where: Path) -> bool:
    try:
        ownership._check(found, where)
    except ForeignError:
        return False
    return True


def test_code_of_another_user_is_not_run_unless_jounce_is_theirs(cache, monkeypatch) -> None:
    own = Path(ownership.__file__).stat()
    for user, trusted in {0: True, own.st_uid: True, os.geteuid(): True, 54321: False}.items():
        found = os.stat_result((stat.S_IFREG | 0o644, 0, 0, 1, user, 54321, 0, 0, 0, 0))
        assert is_ours(found, cache) == trusted
    if os.geteuid() == 0:
        os.chown(cache / "key.o", 54321, -1)
        assert native.recall("key") is None


def test_what_is_open_to_others_as_jounce_itself_is_is_run(cache, monkeypatch) -> None:
    """Where all files are made for their group (umask 002), or no modes are known, refusing wins nothing."""
    (cache / "key.o").chmod(0o664)
    own = (cache / "key.o").stat()
    monkeypatch.setattr(ownership, "__file__", str(cache / "key.o"))
    assert is_ours(own, cache)
    found = os.stat_result((own.st_mode, 0, 0, 1, own.st_uid, own.st_gid + 1, 0, 0, 0, 0))
    assert not is_ours(found, cache)  # another group


def test_what_is_no_file_is_not_waited_for(cache) -> None:
    (cache / "key.o").unlink()
    os.mkfifo(cache / "key.o")
    assert native.recall("key") is None
    (cache / "key.o").unlink()
    (cache / "key.o").mkdir()
    assert native.recall("key") is None


def test_code_of_modules_that_were_edited_meanwhile_is_not_kept(cache, monkeypatch) -> None:
    monkeypatch.setattr(native, "edited_since", lambda *_: True)
    native.keep("another", b"code")
    assert native.recall("another") is None
