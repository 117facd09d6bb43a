"""Files written whole or not at all, without ever losing one that was there."""

from __future__ import annotations

import contextlib
import os
import platform
import shutil
import tempfile
import time
import zlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from jounce.core.errors import OutputError


def check_writable(path: Path | str, *, what: str = "files", suffixes: Sequence[str] = (), force: bool = False) -> Path:
    """Refuse an output of another suffix, that exists (without ``force``) or whose folder is missing; give the path."""
    file = Path(path)
    if suffixes and file.suffix.lower() not in suffixes:
        problem, allowed = f"{what} are not written in this format", ", ".join(suffixes)
        raise OutputError(problem, where=str(file), found=file.suffix, allowed=allowed)
    if file.exists() and not force:
        raise OutputError("the output exists", where=str(file), hint="Choose another name or allow it with --force.")
    if not file.parent.is_dir():
        raise OutputError("the folder of the output does not exist", where=str(file.parent), hint="Create it first.")
    return file


def write_atomically(path: Path | str, content: bytes | str, *, force: bool = False) -> Path:
    """Write a file through a temporary one and a rename, so that nobody ever sees half of it."""
    file = check_writable(path, force=force)
    with replacing(file) as temporary:
        temporary.write_bytes(content.encode() if isinstance(content, str) else content)
    return file


@dataclass(frozen=True)
class Formats:
    """File formats that one kind of result can be written in.

    Attributes
    ----------
    what : str
        The kind of result, as messages name it, e.g. ``"recordings"``.
    writers : mapping of str to callable
        By suffix in small letters: takes the result and the path of a file to fill.
    """

    what: str
    writers: Mapping[str, Callable[[Any, Path], object]]

    def check(self, path: Path | str, *, force: bool = False) -> Path:
        """Refuse, before the work, a file that could not be written after it; give the path."""
        return check_writable(path, what=self.what, suffixes=tuple(self.writers), force=force)

    def write(self, result: Any, path: Path | str, *, force: bool = False) -> Path:
        """Write a result in the format that the suffix names; give the path."""
        file = self.check(path, force=force)
        with replacing(file) as temporary:
            self.writers[file.suffix.lower()](result, temporary)
        return file


@contextmanager
def replacing(file: Path) -> Iterator[Path]:
    """Give a temporary file beside ``file`` that takes its place when the block ends well, and is removed otherwise."""
    with _told(file, "the file cannot be written"):
        _sweep(file.parent)
        suffix = file.suffix if len(file.suffix) <= _LONGEST_SUFFIX else ""
        handle, name = tempfile.mkstemp(dir=file.parent, prefix=_own_prefix(), suffix=suffix)
        os.close(handle)
        temporary = Path(name)
        try:
            yield temporary
            temporary.chmod(0o644)  # mkstemp made it private
            temporary.replace(file)
        except BaseException:
            temporary.unlink(missing_ok=True)
            raise


def write_files(folder: Path | str, contents: Mapping[str, bytes | str], *, force: bool = False) -> list[Path]:
    """Write files below a folder, which is made: all of them, or none.

    They are written into a folder beside it first. That takes its place where nothing is in the way; otherwise the
    files are moved into it one by one, whole each, and what else it holds stays.

    Parameters
    ----------
    folder : path
        Where to.
    contents : mapping of str to (bytes or str)
        Content by name; a name may lie in folders of its own.
    force : bool
        Overwrite existing files.

    Returns
    -------
    list of Path
        The files, in the order given.

    Raises
    ------
    OutputError
        When one of the files exists, without ``force``; for a file where a folder is to be and the reverse; for a name
        that leads out of the folder; for a disk that is full or refuses. Then nothing is changed.

    Examples
    --------
    >>> made = write_files(tempfile.mkdtemp(), {"notes.txt": "rig 2", "trials/01.csv": "time [s]"})
    >>> [file.name for file in made]
    ['notes.txt', '01.csv']
    """
    root = Path(folder).resolve()
    files = {root / name: content for name, content in contents.items()}
    _check_room(root, files, force=force)
    with _told(root, "the folder cannot be written"):
        root.parent.mkdir(parents=True, exist_ok=True)
        _sweep(root.parent)
        built = Path(tempfile.mkdtemp(dir=root.parent, prefix=_own_prefix()))
        try:
            for name, content in contents.items():
                target = built / name
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(content.encode() if isinstance(content, str) else content)
            _move(built, root, contents)
        finally:
            shutil.rmtree(built, ignore_errors=True)
    return [Path(folder) / name for name in contents]


def _check_room(root: Path, files: Iterable[Path], *, force: bool) -> None:
    if root.exists() and not root.is_dir():
        raise OutputError("a file stands where the folder should be", where=str(root), hint="Choose another name.")
    for file in files:
        if not file.resolve().is_relative_to(root):
            raise OutputError("the file would lie outside the folder", where=str(root), found=str(file))
        if file.is_dir():
            raise OutputError("a file cannot be written where a folder is", where=str(file))
        if any(parent.is_file() for parent in file.parents if parent.is_relative_to(root)):
            raise OutputError("a folder cannot be made where a file is", where=str(file.parent))
        if file.exists() and not force:
            check_writable(file)


def _move(built: Path, root: Path, names: Iterable[str]) -> None:
    """Rename the whole folder where nothing is in its way, otherwise file by file."""
    built.chmod(0o755)  # mkdtemp made it private
    if not root.exists() or not any(root.iterdir()):
        if root.exists():
            root.rmdir()
        built.rename(root)
        return
    for name in names:
        target = root / name
        target.parent.mkdir(parents=True, exist_ok=True)
        (built / name).replace(target)


@contextmanager
def _told(where: Path, what: str) -> Iterator[None]:
    """Turn what the system refuses into the product's own error."""
    try:
        yield
    except OSError as error:
        raise OutputError(
            what,
            where=str(where),
            found=error.strerror or str(error),
            hint="Check the path, the permissions and the space on the disk.",
        ) from error


_LONGEST_SUFFIX = 16
_DAY = 86400.0


def _own_prefix() -> str:
    """Begin of the names of this process's temporary files, from which another one sees whether it still runs."""
    return f".jounce-{zlib.crc32(platform.node().encode()):08x}-{os.getpid()}-"


@cache
def _sweep(folder: Path) -> None:
    """Remove what a killed process has left in a folder: of this machine at once, of others after a day."""
    machine = _own_prefix().rsplit("-", 2)[0]
    for left in folder.glob(".jounce-*-*-*"):
        with contextlib.suppress(OSError, ValueError):
            here, process = left.name.rsplit("-", 2)[0] == machine, int(left.name.rsplit("-", 2)[1])
            if time.time() - left.stat().st_mtime > _DAY or (here and not _runs(process)):
                shutil.rmtree(left) if left.is_dir() else left.unlink()


def _runs(process: int) -> bool:
    """Whether a process of this machine still runs; yes where the system does not tell without harm."""
    if os.name != "posix":
        return True
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except OSError:  # somebody else's
        return True
    return True
