"""Native code is never taken from where somebody else could have put it; then it is made again, which is said once."""

from __future__ import annotations

import ast
import logging
import os
import subprocess
import sys
from pathlib import Path

import pytest

import jounce
from jounce.core import ownership
from jounce.core.ownership import ForeignError, own_folder, read_own
from jounce.kernel import cache, call, machine
from jounce.kernel.loops import LOOPS, this_platform

pytestmark = pytest.mark.skipif(os.name != "posix", reason="owners and modes are a thing of POSIX")
ROOT_ONLY = pytest.mark.skipif(
    os.name != "posix" or os.geteuid() != 0, reason="only root can give a file away"
)
SOMEBODY = 54321


@pytest.fixture(autouse=True)
def private(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Jounce is its owner's alone, and lies elsewhere."""
    module = tmp_path / "jounce" / "ownership.py"
    module.parent.mkdir()
    module.touch(0o644)
    monkeypatch.setattr(ownership, "__file__", str(module))
    monkeypatch.setattr(ownership, "_is_private", lambda *_: False)
    cache._TOLD.clear()


@pytest.fixture
def code(tmp_path: Path) -> Path:
    file = tmp_path / "all" / "user" / "cache" / "key.o"
    assert own_folder(file.parent) == file.parent
    file.write_bytes(b"code")
    assert read_own(file) == b"code"
    return file


def test_folders_on_the_way(code: Path) -> None:
    above = code.parents[2]
    above.chmod(0o777)  # anybody can exchange `user`
    with pytest.raises(ForeignError) as caught:
        read_own(code)
    assert caught.value.filename == str(above)
    with pytest.raises(ForeignError):
        own_folder(code.parent)
    above.chmod(0o1777)  # as /tmp: only its owner can
    assert read_own(code) == b"code"
    code.parent.chmod(0o1777)  # but anybody can put something here
    with pytest.raises(ForeignError):
        read_own(code)


def test_folders_that_hold_jounce_are_as_good_as_jounce(
    code: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(ownership, "__file__", str(code.parents[1] / "jounce.py"))
    (code.parents[1] / "jounce.py").touch(0o644)
    code.parents[2].chmod(0o777)
    assert read_own(code) == b"code"


@ROOT_ONLY
def test_what_belongs_to_somebody_else(code: Path) -> None:
    for one in (code, code.parent, code.parents[1]):
        os.chown(one, SOMEBODY, -1)
        with pytest.raises(ForeignError):
            read_own(code)
        os.chown(one, 0, -1)
    code.parents[2].chmod(0o1777)
    os.chown(code.parents[1], SOMEBODY, -1)  # made in /tmp before we came
    with pytest.raises(ForeignError):
        read_own(code)


def test_own_links_are_followed_and_every_folder_on_their_way_is_looked_at(
    code: Path, tmp_path: Path
) -> None:
    (tmp_path / "cache").symlink_to(code.parent)
    assert read_own(tmp_path / "cache" / "key.o") == b"code"
    (code.parent / "other.o").symlink_to("../cache/key.o")
    assert read_own(tmp_path / "cache" / "other.o") == b"code"
    code.parents[2].chmod(0o777)
    with pytest.raises(ForeignError):
        read_own(tmp_path / "cache" / "other.o")


@ROOT_ONLY
def test_links_of_somebody_else_to_files_of_ours_are_not_followed(
    code: Path, tmp_path: Path
) -> None:
    """What we have downloaded is ours, too, and may be code of somebody else."""
    (tmp_path / "cache").symlink_to(code.parent)
    os.chown(tmp_path / "cache", SOMEBODY, -1, follow_symlinks=False)
    with pytest.raises(ForeignError):
        read_own(tmp_path / "cache" / "key.o")


def test_links_in_a_circle(tmp_path: Path) -> None:
    (tmp_path / "a").symlink_to("b")
    (tmp_path / "b").symlink_to("a")
    with pytest.raises(OSError, match="link"):
        read_own(tmp_path / "a" / "key.o")


@pytest.mark.parametrize("kind", ["link", "pipe", "folder"])
def test_a_file_exchanged_after_its_folder_was_looked_at(
    code: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    opened = os.open
    elsewhere = tmp_path / "elsewhere.o"
    elsewhere.write_bytes(b"foreign")

    def exchanged(path, *arguments, **options):
        Path(path).unlink()
        {
            "link": lambda: Path(path).symlink_to(elsewhere),
            "pipe": lambda: os.mkfifo(path),
            "folder": Path(path).mkdir,
        }[kind]()
        return opened(path, *arguments, **options)

    monkeypatch.setattr(os, "open", exchanged)
    with pytest.raises(OSError):  # noqa: PT011 - which one is the system's business
        read_own(code)


def test_made_folders_are_private_whatever_the_mask_is(tmp_path: Path) -> None:
    before = os.umask(0)
    try:
        folder = own_folder(tmp_path / "home" / ".cache" / "jounce")
    finally:
        os.umask(before)
    assert {one.stat().st_mode & 0o777 for one in (folder, folder.parent, folder.parents[1])} == {
        0o755
    }


def test_a_relative_folder_is_not_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    """An unpacked archive belongs to whoever has unpacked it, and may hold a cache."""
    monkeypatch.chdir(tmp_path)
    cache._tell_relative.cache_clear()
    monkeypatch.setenv("JOUNCE_CACHE_DIR", "cache")
    cache.keep("key", b"code")
    assert cache.recall("key") is cache.recall("key") is None
    assert not Path("cache").exists()
    assert len(caplog.messages) == 1
    monkeypatch.delenv("JOUNCE_CACHE_DIR")
    monkeypatch.setenv("XDG_CACHE_HOME", "cache")
    assert cache.cache_folder().is_absolute()


def test_a_folder_with_many_open_files_is_told_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setenv("JOUNCE_CACHE_DIR", str(tmp_path / "cache"))
    for key in "abc":
        cache.keep(key, b"code")
        (tmp_path / "cache" / f"{key}.o").chmod(0o666)
        assert cache.recall(key) is None
    assert len(caplog.messages) == 1
    assert caplog.records[0].levelno == logging.WARNING


def test_the_group_that_systems_make_for_each_user_holds_nobody_else(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    import grp
    import pwd

    monkeypatch.undo()
    user = pwd.getpwuid(os.geteuid())
    for members, name, private in (
        ([], user.pw_name, True),
        ([user.pw_name], user.pw_name, True),
        ([], "users", False),
        (["eve"], user.pw_name, False),
    ):
        ownership._is_private.cache_clear()
        monkeypatch.setattr(
            grp, "getgrgid", lambda _, n=name, m=members: grp.struct_group((n, "x", user.pw_gid, m))
        )
        assert ownership._is_private(user.pw_gid, user.pw_uid) == private
    ownership._is_private.cache_clear()


def test_code_that_cannot_be_loaded_is_made_another_way(
    monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    """Foreign or truncated objects, and processors that LLVM does not know: the next way works, and is told."""

    def broken(*_: object) -> bytes:
        raise RuntimeError("no such processor")

    monkeypatch.setattr(call, "_read_shipped", lambda *_: b"of another version")
    monkeypatch.setattr(call, "recall", broken)
    monkeypatch.setattr(call, "_compile", broken)
    monkeypatch.setattr(call, "_by_numba", lambda _name: lambda _: 7)
    assert call._load("drag", this_platform())[1](()) == 7
    (said,) = caplog.messages
    assert "no such processor" in said


def test_a_processor_without_a_name(monkeypatch: pytest.MonkeyPatch) -> None:
    def unknown() -> None:
        raise RuntimeError

    machine.features.cache_clear()
    machine.processor.cache_clear()
    monkeypatch.delenv("JOUNCE_PROCESSOR", raising=False)
    monkeypatch.setattr(machine.llvm, "get_host_cpu_features", unknown)
    monkeypatch.setattr(machine.llvm, "get_host_cpu_name", lambda: "")
    try:
        assert machine.features() == {}
        assert machine.this_machine().triple
        assert len(cache.key_here("model")) == 64
    finally:
        machine.features.cache_clear()
        machine.processor.cache_clear()


KEEPER = """
import sys
from jounce.kernel import cache
for k in range(200):
    cache.keep("key", bytes([int(sys.argv[1])]) * 100_000)
    assert len(set(cache.recall("key"))) == 1
"""


def test_two_processes_keep_the_same_at_once(tmp_path: Path) -> None:
    environment = {**os.environ, "JOUNCE_CACHE_DIR": str(tmp_path / "cache")}
    asked = [[sys.executable, "-c", KEEPER, str(number)] for number in (1, 2)]
    both = [subprocess.Popen(one, env=environment, stderr=subprocess.PIPE) for one in asked]
    assert [one.communicate()[1] for one in both] == [b"", b""]
    assert [file.name for file in (tmp_path / "cache").iterdir()] == ["key.o"]


def numba_caches(source: str) -> list[int]:
    """Lines that have Numba keep what it compiles: it keeps it pickled, and runs what it finds."""
    calls = (node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call))
    return [one.lineno for one in calls for word in one.keywords if word.arg == "cache"]


def test_numba_reads_no_pickled_code() -> None:
    assert numba_caches("from numba import njit\n@njit(cache=True)\ndef f(): pass") == [2]
    package = Path(jounce.__file__).parent
    files = {Path(f"loops/{module}.py") for module, _ in LOOPS.values()}
    assert all((package / "kernel" / file).is_file() for file in files)
    assert {
        file: numba_caches(file.read_text())
        for file in package.rglob("*.py")
        if numba_caches(file.read_text())
    } == {}


def searching_here(source: str) -> list[int]:
    """Lines that start Python so that it takes modules from the folder one stands in, which may be anybody's."""
    lists = (
        node
        for node in ast.walk(ast.parse(source))
        if isinstance(node, ast.List) and len(node.elts) > 1
    )
    starts = (one for one in lists if ast.unparse(one.elts[0]) == "sys.executable")
    return [
        one.lineno for one in starts if ast.unparse(one.elts[1]) not in ("'-P'", "'-I'")
    ]  # -I: -P and more


def test_no_process_takes_modules_from_the_folder_one_stands_in() -> None:
    assert searching_here(
        "run([sys.executable, '-m', 'zig'])\nrun([sys.executable, '-P', '-m', 'zig'])"
    ) == [1]
    package = Path(jounce.__file__).parent
    found = {
        file: searching_here(file.read_text(encoding="utf-8")) for file in package.rglob("*.py")
    }
    assert any(
        "[sys.executable, " in file.read_text(encoding="utf-8") for file in package.rglob("*.py")
    )
    assert {file: lines for file, lines in found.items() if lines} == {}
