"""Files to read: given by a path, or by the name of one that comes with jounce."""

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
    """Restrict reading to a folder from now on, in all threads of this process, which works for others."""
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
    except (OSError, ValueError, RuntimeError):  # no name, or links in a circle
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
    """Whether a file exists after completing or undoing an interrupted exchange of files."""
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
    """Identity of a file's content for caches: also differs for other content of the same size and date.

    Dates of content can be set, and clocks stand still or jump; the system's own date of the last change, and which
    file it is, tell what they do not.
    """
    state = file.stat()
    return state.st_ino, state.st_size, state.st_mtime_ns, state.st_ctime_ns


_LARGEST = 1_000_000_000  # bytes: what fits into memory with its numbers


def content_of(
    path: Path | str, error: type[JounceError] = DescriptionError, *, most: int = _LARGEST
) -> bytes:
    """Return the content of a regular file of at most ``most`` bytes.

    It is opened before it is examined, so that a pipe cannot block.
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
    """Name the file in system errors while it is read."""
    try:
        yield
    except OSError as refused:
        kind = DiskError if is_of_system(refused) else error
        raise kind(
            "the file cannot be read", where=str(file), found=refused.strerror or str(refused)
        ) from None


_MISSING = "no such file"
_LONGEST_NAME = 1000  # characters; systems take 255 bytes


def shipped_files(package: str, folder: str, suffix: str = ".toml") -> dict[str, Path]:
    """Files that come with a package: name to file.

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
    """Find the file that a user names: a path (recognised by its suffix, or because it exists), or a shipped file.

    >>> find_file("eusama", {"eusama": Path("library/eusama.toml")}, "tester").name
    'eusama.toml'
    """
    file = Path(name)
    if file.suffix == ".toml" or _is_file(file):
        return file
    if str(name) not in shipped:
        missing = _instead(file) if str(name) else _MISSING
        unknown = Phrase("no such file and no shipped {kind} of that name", kind=Phrase(what))
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
    """Return paths unchanged, and expand patterns that the shell has not expanded."""
    matching: list[Path] = []
    for name in names:
        path = Path(name)
        if path.exists() or not any(mark in name for mark in "*?["):
            matching.append(path)
            continue
        try:
            matches = sorted(Path(path.anchor or ".").glob(str(path.relative_to(path.anchor))))
        except ValueError:  # no pattern
            matches = []
        if not matches:
            raise RecordingError(
                "no file matches", where=where, found=name, hint="Check the folder and the pattern."
            )
        matching += matches
    return matching
