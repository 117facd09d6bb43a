"""Native code is kept where that is possible, and taken for no other kernel's."""

from __future__ import annotations

import gc
import os
import stat
import sys
from pathlib import Path

import pytest

from jounce.core import ownership
from jounce.core.ownership import ForeignError
from jounce.kernel import cache, machine, native


def test_without_a_home_folder_models_are_compiled_all_the_same(monkeypatch):
    def homeless() -> None:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.delenv("JOUNCE_CACHE_DIR", raising=False)
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(cache.Path, "home", homeless)
    with pytest.raises(RuntimeError):
        cache.cache_folder()
    assert cache.recall("key") is None
    cache.keep("key", b"code")


def test_native_code_is_not_taken_from_another_system(monkeypatch):
    """LLVM ends a process that loads an object of another format: nothing could be caught."""
    here = cache.key_here("model")
    assert cache.key_here("model") == here
    for triple in (
        "x86_64-apple-darwin23.0.0",
        "x86_64-pc-windows-msvc",
        "aarch64-unknown-linux-gnu",
    ):
        monkeypatch.setattr(machine.llvm, "get_process_triple", lambda triple=triple: triple)
        assert cache.key_here("model") != here


def test_native_code_is_not_taken_from_another_kernel(monkeypatch, tmp_path):
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path))
    made = []

    def make() -> native.Source:
        made.append(1)
        return native.Source({})

    for digest in ("one kernel", "one kernel", "another kernel"):
        monkeypatch.setattr(cache, "digest_of", lambda *_, digest=digest: digest)
        native.code_from_cache("nothing", make)
    assert len(made) == 2


@pytest.fixture
def folder(monkeypatch, tmp_path):
    """A cache with an entry, which is read; jounce is its owner's alone."""
    module = tmp_path / "native.py"
    module.touch(0o644)
    monkeypatch.setattr(ownership, "__file__", str(module))
    monkeypatch.setattr(ownership, "_is_private", lambda *_: False)
    folder = tmp_path / "cache"
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(folder))
    cache._TOLD.clear()
    cache.keep("key", b"code")
    assert cache.recall("key") == b"code"
    return folder


OPEN = {"a file that all may write": ("key.o", 0o666), "a folder that all may write": (".", 0o777)}
OPEN |= {"a file of a group": ("key.o", 0o664), "a folder of a group": (".", 0o775)}


@pytest.mark.parametrize("what", OPEN)
def test_code_that_others_could_have_written_is_not_run_and_that_is_said(
    folder, caplog, what
) -> None:
    name, mode = OPEN[what]
    (folder / name).chmod(mode)
    assert cache.recall("key") is cache.recall("key") is None
    (said,) = caplog.messages
    assert str(folder) in said
    assert "can be written by others" in said
    cache.keep("another", b"code")
    assert (folder / "another.o").exists() == (name != ".")
    (folder / name).chmod(0o644 if name != "." else 0o755)
    assert cache.recall("key") == b"code"


def is_ours(found: os.stat_result, where: Path) -> bool:
    try:
        ownership._check(found, where)
    except ForeignError:
        return False
    return True


def test_code_of_another_user_is_not_run_unless_jounce_is_theirs(folder, monkeypatch) -> None:
    own = Path(ownership.__file__).stat()
    for user, trusted in {0: True, own.st_uid: True, os.geteuid(): True, 54321: False}.items():
        found = os.stat_result((stat.S_IFREG | 0o644, 0, 0, 1, user, 54321, 0, 0, 0, 0))
        assert is_ours(found, folder) == trusted
    if os.geteuid() == 0:
        os.chown(folder / "key.o", 54321, -1)
        assert cache.recall("key") is None


def test_what_is_open_to_others_as_jounce_itself_is_is_run(folder, monkeypatch) -> None:
    """Where all files are made for their group (umask 002), or no modes are known, refusing wins nothing."""
    (folder / "key.o").chmod(0o664)
    own = (folder / "key.o").stat()
    monkeypatch.setattr(ownership, "__file__", str(folder / "key.o"))
    assert is_ours(own, folder)
    found = os.stat_result((own.st_mode, 0, 0, 1, own.st_uid, own.st_gid + 1, 0, 0, 0, 0))
    assert not is_ours(found, folder)  # another group


def test_what_is_no_file_is_not_waited_for(folder) -> None:
    (folder / "key.o").unlink()
    os.mkfifo(folder / "key.o")
    assert cache.recall("key") is None
    (folder / "key.o").unlink()
    (folder / "key.o").mkdir()
    assert cache.recall("key") is None


def test_code_of_modules_that_were_edited_meanwhile_is_not_kept(folder, monkeypatch) -> None:
    monkeypatch.setattr(cache, "edited_since", lambda *_: True)
    cache.keep("another", b"code")
    assert cache.recall("another") is None


@pytest.mark.parametrize("collects", [True, False])
def test_garbage_is_collected_again_after_a_model_was_compiled(monkeypatch, folder, collects):
    seen = []

    def make() -> native.Source:
        seen.append(gc.isenabled())
        raise ValueError("no such model")

    (gc.enable if collects else gc.disable)()
    try:
        with pytest.raises(ValueError, match="no such model"):
            native.code_from_cache("nothing", make)
        assert (seen, gc.isenabled()) == ([False], collects)
    finally:
        gc.enable()


def test_twins_have_the_code_that_users_have(optimised):
    """Most of the other tests have code that is made quickly: the two are kept apart."""
    key = cache.key_here("a model")
    assert (native.machine_code, native.key_here("a model")) == (machine.machine_code, key)


@pytest.mark.parametrize(
    ("system", "set_", "wanted"),
    [
        ("linux", {}, "home/.cache/jounce"),
        ("darwin", {}, "home/Library/Caches/jounce"),
        ("win32", {"LOCALAPPDATA": "local"}, "local/jounce/Cache"),
        ("win32", {}, "home/AppData/Local/jounce/Cache"),
        *(
            (system, {"XDG_CACHE_HOME": "shared"}, "shared/jounce")
            for system in ("linux", "darwin", "win32")
        ),
        *((system, {"JOUNCE_CACHE_DIR": "own"}, "own") for system in ("linux", "darwin", "win32")),
    ],
)
def test_the_cache_lies_where_the_system_keeps_caches(tmp_path, monkeypatch, system, set_, wanted):
    for name in ("JOUNCE_CACHE_DIR", "XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    for name, folder in set_.items():
        monkeypatch.setenv(name, str(tmp_path / folder))
    monkeypatch.setattr(Path, "home", lambda: tmp_path / "home")
    monkeypatch.setattr(sys, "platform", system)
    assert cache.cache_folder() == tmp_path / wanted
