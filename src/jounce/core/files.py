"""Find and read files given by a path, or by the name of a file shipped with jounce."""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from importlib import resources
from pathlib import Path

from jounce.core.errors import (
    DescriptionError,
    DiskError,
    JounceError,
    RecordingError,
    is_of_system,
    nearest,
)
from jounce.core.phrases import Phrase


def existing_file(path: Path | str, error: type[JounceError] = DescriptionError) -> Path:
    """Return the path of a file; raise if it does not exist."""
    file = Path(path)
    root = _ROOT.get() or _ALWAYS.get("root")
    if root is not None and not _lies_in(file, root):
        raise error(
            "outside of the folder that may be read",
            where=str(file),
            allowed=f"files below {root.name}",
        )
    if not (_is_file(file) or _is_put_back(file)):
        raise error(_instead(file), where=str(file), hint="Check the path and the name.")
    return file


_ROOT: ContextVar[Path | None] = ContextVar("root", default=None)
_ALWAYS: dict[str, Path] = {}


def always_below(folder: Path) -> None:
    """Restrict reading to a folder permanently, in all threads of this process: for servers."""
    _ALWAYS["root"] = folder.resolve()


@contextmanager
def only_below(folder: Path) -> Iterator[None]:
    """Restrict reading in a block to a folder (after following links) and the package."""
    before = _ROOT.set(folder.resolve())
    try:
        yield
    finally:
        _ROOT.reset(before)


def _lies_in(file: Path, root: Path) -> bool:
    try:
        place = file.resolve()
    except (OSError, ValueError, RuntimeError):  # an invalid name, or circular links
        return False
    return place.is_relative_to(root) or place.is_relative_to(Path(str(resources.files("jounce"))))


def _is_file(file: Path) -> bool:
    """Whether a path is a file; False for invalid names."""
    try:
        return file.is_file()
    except OSError as error:
        if error.errno == errno.ENAMETOOLONG:
            return False
        raise


def _is_put_back(file: Path) -> bool:
    """Complete or undo an interrupted exchange of files; return whether the file exists then."""
    from jounce.core.writing import sweep_beside

    with suppress(JounceError, OSError, ValueError):
        sweep_beside(file)
        return _is_file(file)
    return False


def _instead(file: Path) -> str:
    if len(file.name) > _LONGEST_NAME:
        return _MISSING
    if file.is_dir():
        return "a folder, not a file"
    return "a pipe or a device, not a file" if file.exists() else _MISSING


State = tuple[int, int, int, int]


def state_of(file: Path) -> State:
    """Identify a file's content for caches; the state also differs for different content of the same size and date.

    Modification times can be set by programs, and clocks can stop or jump. The state therefore includes the inode and
    the time of its last change.
    """
    state = file.stat()
    return state.st_ino, state.st_size, state.st_mtime_ns, state.st_ctime_ns


_LARGEST = 1_000_000_000  # bytes: fits into memory together with its numbers


def content_of(
    path: Path | str, error: type[JounceError] = DescriptionError, *, most: int = _LARGEST
) -> bytes:
    """Return the content of a regular file of at most ``most`` bytes.

    It is opened without blocking and then examined, because a pipe could block.
    """
    file = existing_file(path, error)
    flags = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
    with os.fdopen(os.open(file, flags), "rb") as stream:
        status = os.fstat(stream.fileno())
        if not stat.S_ISREG(status.st_mode):
            raise error("a pipe or a device, not a file", where=str(file))
        if status.st_size > most:
            size, allowed = (f"{number / 1e9:.3g} GB" for number in (status.st_size, most))
            raise error(
                "too large to be read as a whole",
                where=str(file),
                found=size,
                allowed=f"up to {allowed}",
            )
        with reading(file, error):
            return stream.read(most)


@contextmanager
def reading(file: Path, error: type[JounceError]) -> Iterator[None]:
    """Convert system errors within a block that reads a file to an ``error`` that names it."""
    try:
        yield
    except OSError as refused:
        kind = DiskError if is_of_system(refused) else error
        raise kind(
            "the file cannot be read", where=str(file), found=refused.strerror or str(refused)
        ) from None


_MISSING = "no such file"
_LONGEST_NAME = 1000  # characters; systems allow 255 bytes


def shipped_files(package: str, folder: str, suffix: str = ".toml") -> dict[str, Path]:
    """Return the files shipped with a package, by name.

    >>> list(shipped_files("jounce.roads", "library", ".crg"))
    ['detrended_rms_course_1in']
    """
    root = Path(str(resources.files(package))) / folder
    return {file.stem: file for file in sorted(root.glob(f"*{suffix}"))}


def find_file(
    name: Path | str,
    shipped: Mapping[str, Path],
    what: str,
    *,
    others: str = "a path to a .toml file",
) -> Path:
    """Find a file by a path (recognised by its suffix, or because it exists), or by the name of a shipped file.

    >>> find_file("eusama", {"eusama": Path("library/eusama.toml")}, "tester").name
    'eusama.toml'
    """
    file = Path(name)
    if file.suffix == ".toml" or _is_file(file):
        return file
    if str(name) not in shipped:
        missing = _instead(file) if str(name) else _MISSING
        unknown = Phrase(
            "no such file, and no {kind} of that name in the library", kind=Phrase(what)
        )
        raise DescriptionError(
            unknown if missing == _MISSING else missing,
            where=str(name),
            allowed=Phrase(
                "{others}, or one of {names}", others=Phrase(others), names=", ".join(shipped)
            ),
            hint=nearest(str(name), shipped),
        )
    return shipped[str(name)]


def matching_files(names: Sequence[str], where: str) -> list[Path]:
    """Return paths unchanged, and expand patterns that the shell did not expand."""
    matching: list[Path] = []
    for name in names:
        path = Path(name)
        if path.exists() or not any(mark in name for mark in "*?["):
            matching.append(path)
            continue
        try:
            matches = sorted(Path(path.anchor or ".").glob(str(path.relative_to(path.anchor))))
        except ValueError:  # not a pattern
            matches = []
        if not matches:
            raise RecordingError(
                "no file matches", where=where, found=name, hint="Check the folder and the pattern."
            )
        matching += matches
    return matching
