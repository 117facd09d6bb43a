"""Write files completely or not at all, and never lose an existing file."""

from __future__ import annotations

import contextlib
import os
import platform
import secrets
import shutil
import stat
import tempfile
import time
import zlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

from jounce.core.errors import WHERE_WRITTEN, DiskError, OutputError, is_of_system, resource_error
from jounce.core.locking import holding
from jounce.core.optional import require

ALLOW_OVERWRITING = "Choose another name, or overwrite it with --force."
"""Advice if an existing file would be overwritten."""


def check_writable(
    path: Path | str, *, what: str = "files", suffixes: Sequence[str] = (), force: bool = False
) -> Path:
    """Return the path of an output; refuse a wrong suffix, an existing file (unless ``force``), a missing folder."""
    file = Path(path)
    if file.exists() and not file.is_file() and not file.is_dir():
        hint = "Write to a file and read that; only the output of --json can go to a pipe."
        raise OutputError(
            "a pipe or a device, which a file cannot replace", where=str(file), hint=hint
        )
    if suffixes and file.suffix.lower() not in suffixes:
        problem, allowed = f"{what} are not written in this format", ", ".join(suffixes)
        raise OutputError(problem, where=str(file), found=file.suffix, allowed=allowed)
    if file.is_dir():
        raise OutputError(
            "a folder with the name of the file exists",
            where=str(file),
            hint="Choose another name.",
        )
    if file.exists() and not force:
        raise OutputError("the output already exists", where=str(file), hint=ALLOW_OVERWRITING)
    if not file.parent.is_dir():
        raise OutputError(
            "the output folder does not exist",
            where=str(file.parent),
            hint="Create the folder first.",
        )
    return file


def write_atomically(path: Path | str, content: bytes | str, *, force: bool = False) -> Path:
    """Write a file through a temporary file and a rename: it is never visible in an incomplete state."""
    file = check_writable(path, force=force)
    with replacing(file, force=force) as temporary:
        temporary.write_bytes(content.encode() if isinstance(content, str) else content)
    return file


@dataclass(frozen=True)
class Formats:
    """File formats for one kind of result.

    Attributes
    ----------
    what : str
        Name of the kind of result in messages, e.g. ``"recordings"``.
    writers : mapping of str to callable
        By lower-case suffix: function of the result and the path of the file to write.
    needs : mapping of str to tuple of str
        By suffix: optional package that a writer needs, and its extra.
    """

    what: str
    writers: Mapping[str, Callable[[Any, Path], object]]
    needs: Mapping[str, tuple[str, str]] = field(default_factory=dict)

    def check(self, path: Path | str, *, force: bool = False) -> Path:
        """Check before the work that a file can be written afterwards; return the path."""
        file = check_writable(path, what=self.what, suffixes=tuple(self.writers), force=force)
        if file.suffix.lower() in self.needs:
            require(*self.needs[file.suffix.lower()])
        return file

    def write(self, result: Any, path: Path | str, *, force: bool = False) -> Path:
        """Write a result in the format given by the suffix; return the path."""
        file = self.check(path, force=force)
        with replacing(file, force=force) as temporary:
            self.writers[file.suffix.lower()](result, temporary)
        return file


@contextmanager
def replacing(
    file: Path, *, force: bool = True, most: int = 0o777, lasting: bool = True
) -> Iterator[Path]:
    """Return a temporary file next to ``file`` that replaces it if the block succeeds, and is removed otherwise.

    Without ``force``, a file written there by a different process in the meantime is kept, and an error is raised. A
    replaced file keeps its mode, limited to the bits in ``most``. A ``lasting`` file is flushed to the disk before it
    is renamed: after a power failure either the old or the new file is complete.
    """
    with _as_output_error(file, "the file cannot be written"):
        temporary = temporary_beside(file, most=most)
        try:
            yield temporary
            if lasting:
                _write_through(temporary)
            _copy_mode(file, temporary, most)
            if force or file.is_symlink():
                temporary.replace(file)
            else:
                _put(temporary, file)
        except BaseException:
            temporary.unlink(missing_ok=True)
            raise


def _write_through(file: Path) -> None:
    """Flush the content of a file to the disk: some file systems report only here that it is full."""
    handle = os.open(file, os.O_RDWR)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def _put(temporary: Path, file: Path) -> None:
    """Rename a file unless the name exists, which only a hard link can test safely."""
    try:
        os.link(temporary, file)
    except FileExistsError:
        check_writable(file)
        raise
    except OSError:  # a disk without hard links
        temporary.replace(check_writable(file))
    else:
        with contextlib.suppress(
            OSError
        ):  # the file is complete; the next process removes the temporary one
            temporary.unlink()


def temporary_beside(file: Path, *, most: int = 0o777) -> Path:
    """Create an empty temporary file of this process next to a file; remove those of killed processes.

    The system applies the user's umask when it creates the file: reading the umask requires setting it, which would
    affect other threads. The file never has wider permissions than the file it replaces.
    """
    with _as_output_error(file, "the file cannot be written"):
        _sweep(file.parent)
        suffix = file.suffix if len(file.suffix) <= _LONGEST_SUFFIX else ""
        temporary = file.parent / f"{_own_prefix()}{secrets.token_hex(4)}{suffix}"
        mode = _mode_of(file)
        allowed = (0o666 if mode is None else mode | 0o600) & most
        os.close(os.open(temporary, os.O_CREAT | os.O_EXCL | os.O_WRONLY, allowed))
        return temporary


def _mode_of(file: Path) -> int | None:
    """Mode of a file; None if it does not exist."""
    try:
        return file.stat().st_mode & 0o777
    except OSError:
        return None


def _copy_mode(file: Path, copy: Path, most: int = 0o777) -> None:
    """Copy the mode of the replaced file, if there is one."""
    mode = _mode_of(file)
    if mode is not None:
        with contextlib.suppress(OSError):  # a disk without permissions
            copy.chmod(mode & most)


def sweep_beside(file: Path) -> None:
    """Remove temporary files of this user's killed processes next to a file."""
    _sweep(file.parent)


def write_files(
    folder: Path | str, contents: Mapping[str, bytes | str], *, force: bool = False
) -> list[Path]:
    """Write files below a folder, which is created if missing: all of them, or none.

    They are written to a temporary folder first. If the folder does not exist, the temporary folder is renamed to it.
    Otherwise existing files of the same names are moved out and the new ones in; other files are not touched. If this
    process is killed in between, the next process that writes there either restores the old files or completes the
    exchange.

    Parameters
    ----------
    folder : path
        Destination.
    contents : mapping of str to (bytes or str)
        Content by name; a name may include folders.
    force : bool
        Overwrite existing files.

    Returns
    -------
    list of Path
        The files, in the order given.

    Raises
    ------
    OutputError
        If one of the files exists (without ``force``), a file is in the way of a folder or the reverse, a name leads
        out of the folder, or the disk is full or read-only. Nothing is changed then.

    Examples
    --------
    >>> made = write_files(tempfile.mkdtemp(), {"notes.txt": "rig 2", "trials/01.csv": "time [s]"})
    >>> [file.name for file in made]
    ['notes.txt', '01.csv']
    """
    root = resolve_path(folder)
    files = {root / name: content for name, content in contents.items()}
    _check_room(root, files, force=force)
    with _as_output_error(root, "the folder cannot be written"):
        is_there = root.is_dir()
        # Next to the files to be moved: an existing folder may be on a disk of its own.
        place = root if is_there else root.parent
        place.mkdir(parents=True, exist_ok=True)
        _sweep(root.parent)  # left by a process killed just after it had renamed the folder
        _sweep(place)
        aside = Path(tempfile.mkdtemp(dir=place, prefix=_own_prefix()))
        try:
            built = aside / _NEW
            for name, content in contents.items():
                target = built / name
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_bytes(content.encode() if isinstance(content, str) else content)
                _write_through(target)
                _copy_mode(root / name, target)
            built.mkdir(exist_ok=True)  # also without files
            if is_there:
                with holding(root):
                    _check_room(
                        root, files, force=force
                    )  # a different process may have written here
                    _exchange(root, aside, list(contents))
            elif not _move_into_place(built, root):
                return write_files(
                    folder, contents, force=force
                )  # a different process has created the folder in the meantime
        finally:
            _remove(aside)
    return [Path(folder) / name for name in contents]


def resolve_path(path: Path | str, *, home: bool = False) -> Path:
    """Return an absolute path without links; expand ``~`` if ``home``. Refuse invalid paths."""
    try:
        place = (Path(path).expanduser() if home else Path(path)).resolve()
        # Python 3.13 returns it unchanged, older versions raise; a name that is too long is not a link.
        if any(os.path.islink(each) for each in (place, *place.parents)):  # noqa: PTH114
            raise RuntimeError("a link that leads to itself")
        return place
    except (
        RuntimeError,
        ValueError,
    ) as error:  # circular links, unknown users, NUL
        hint = "Choose another name."
        raise OutputError(
            "the path is invalid", where=str(path), found=str(error), hint=hint
        ) from None


def check_folder(out: Path | str, *, force: bool = False) -> Path:
    """Return the path of a folder; refuse a folder that is not empty (unless ``force``), or a file of that name."""
    folder = resolve_path(out, home=True)
    with _as_output_error(folder, "the folder cannot be written"):
        if folder.exists() and not folder.is_dir():
            raise OutputError(
                "the output is a file, not a folder", where=str(folder), hint="Choose another name."
            )
        if folder.is_dir() and not force and not is_empty(folder):
            raise OutputError(
                "the output folder is not empty", where=str(folder), hint=ALLOW_OVERWRITING
            )
        there = next(parent for parent in folder.parents if parent.exists())
        if not there.is_dir():
            raise OutputError(
                "a folder cannot be created inside a file", where=str(folder), found=str(there)
            )
    return folder


def _check_room(root: Path, files: Iterable[Path], *, force: bool) -> None:
    if root.exists() and not root.is_dir():
        raise OutputError(
            "a file with the name of the folder exists",
            where=str(root),
            hint="Choose another name.",
        )
    for file in files:
        if not resolve_path(file).is_relative_to(root):
            raise OutputError(
                "the file would be outside the folder", where=str(root), found=str(file)
            )
        if file.is_dir():
            raise OutputError(
                "the file cannot be written: a folder with this name exists", where=str(file)
            )
        if any(parent.is_file() for parent in file.parents if parent.is_relative_to(root)):
            raise OutputError(
                "the folder cannot be created: a file with this name exists", where=str(file.parent)
            )
        if file.exists() and not force:
            check_writable(file)


def _move_into_place(built: Path, root: Path) -> bool:
    """Rename a folder; return whether the name was free, or False if a different process has taken it."""
    try:
        built.rename(root)
    except OSError:
        if not root.is_dir():
            raise
        return False
    return True


_NEW, _READY, _OLD = "jounce-new", "jounce-ready", "jounce-old"
"""Subfolders of the temporary folder: new files, new files after all old ones are moved out, and old files."""


def _exchange(root: Path, aside: Path, names: Sequence[str]) -> None:
    """Move the old files out of a folder and then the new ones in: all of them, or none.

    After an interrupt, :func:`_settle` continues: with the new files if they were complete, else with the old ones.
    """
    try:
        _move([name for name in names if os.path.lexists(root / name)], root, aside / _OLD)
        (aside / _NEW).rename(aside / _READY)
        _move(names, aside / _READY, root)
    except BaseException:
        with contextlib.suppress(OSError):
            if (aside / _READY).is_dir():
                _move(
                    [name for name in names if os.path.lexists(root / name)], root, aside / _READY
                )
                (aside / _READY).rename(aside / _NEW)
        raise


def _move(names: Iterable[str], source: Path, target: Path) -> None:
    for name in names:
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        (source / name).rename(target / name)


def _settle(aside: Path) -> bool:
    """Complete or undo an interrupted exchange; return whether all files are in their final location.

    A folder from an archive may contain links: files are never moved out of or into a linked folder.
    """
    source = aside / (_READY if _is_folder(aside / _READY) else _OLD)
    files = (
        [file for file in source.rglob("*") if not _is_folder(file)] if _is_folder(source) else []
    )
    targets = [aside.parent / file.relative_to(source) for file in files]
    root = aside.parent.resolve()
    for file, target in zip(files, targets, strict=True):
        with contextlib.suppress(OSError, OutputError):
            is_inside = resolve_path(target.parent).is_relative_to(root)
            if is_inside and not os.path.lexists(
                target
            ):  # a file may have been written there in the meantime
                target.parent.mkdir(parents=True, exist_ok=True)
                file.rename(target)
    return all(map(os.path.lexists, targets))


def _is_folder(path: Path) -> bool:
    """Whether a path is a folder, and not a link to one."""
    return path.is_dir() and not path.is_symlink()


def _remove(aside: Path) -> None:
    """Remove a temporary folder, unless it contains the only copy of a file."""
    if _settle(aside):
        shutil.rmtree(aside / _OLD, ignore_errors=True)  # first: until then the new files are valid
        shutil.rmtree(aside, ignore_errors=True)


@contextmanager
def _as_output_error(where: Path, what: str) -> Iterator[None]:
    """Convert system errors within a block to an OutputError."""
    try:
        yield
    except OSError as error:
        is_lacking = is_of_system(error)
        hint = resource_error(error).hint if is_lacking else WHERE_WRITTEN
        raise (DiskError if is_lacking else OutputError)(
            what, where=str(where), found=error.strerror or str(error), hint=hint
        ) from error


def is_empty(folder: Path) -> bool:
    """Whether a folder is empty, after temporary files of killed processes are removed."""
    _sweep(folder)
    return not any(folder.iterdir())


@contextmanager
def working_folder() -> Iterator[Path]:
    """Return a temporary folder of this process, removed when the block ends; remove those of killed processes."""
    folder = lasting_folder()
    try:
        yield folder
    except OSError as error:
        if error.filename is None or Path(os.fsdecode(error.filename)).is_relative_to(folder):
            with _as_output_error(folder, "a temporary file cannot be written"):
                raise
        raise
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def lasting_folder(place: Path | None = None) -> Path:
    """Return a folder for files that other programs open; it outlives this process, and the next call removes it.

    It is made in the system's folder of temporary files, or in ``place``.

    >>> lasting_folder().name.startswith(".jounce-")
    True
    """
    place = place or Path(tempfile.gettempdir())
    with _as_output_error(place, "no folder for temporary files can be made"):
        _sweep(place)
        return Path(tempfile.mkdtemp(prefix=_own_prefix(), dir=place))


_LONGEST_SUFFIX = 16
_DAY = 86400.0
_THIS_RUN = os.urandom(3).hex()


def _own_prefix() -> str:
    """Prefix of this process's temporary files, from which others can determine whether it is still running."""
    return f".jounce-{_machine()}-{os.getpid()}-{_THIS_RUN}-"


@cache
def _machine() -> str:
    """Scope in which process numbers are unique: the machine and, on Linux, the container."""
    inside = 0
    with contextlib.suppress(OSError):
        inside = Path("/proc/self/ns/pid").stat().st_ino
    return f"{zlib.crc32(f'{platform.node()} {inside}'.encode()):08x}"


@cache
def _sweep(folder: Path) -> None:
    """Remove temporary files of killed processes of this user: of this machine at once, of others after a day."""
    for left in folder.glob(".jounce-*-*-*"):
        # Foreign names, files that are gone, and nested folders that jounce does not create.
        with contextlib.suppress(OSError, ValueError, OverflowError, RecursionError):
            _, machine, process, rest = left.name.split("-", 3)
            status = left.lstat()
            if os.name == "posix" and status.st_uid != os.geteuid():
                continue
            if (
                machine != _machine() or os.name != "posix"
            ):  # clocks may jump: do not use them for processes of this machine
                ended = time.time() - status.st_mtime > _DAY
            elif int(process) == os.getpid():
                ended = not rest.startswith(_THIS_RUN)
            else:
                ended = not _runs(int(process))
            if ended:
                _remove(left) if stat.S_ISDIR(status.st_mode) else left.unlink()


def _runs(process: int) -> bool:
    """Whether a process is still running on this machine."""
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except OSError:  # a process of a different user
        return True
    return True
