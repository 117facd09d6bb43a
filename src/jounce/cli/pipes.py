"""Pipes in the place of files: ``jounce modes <(cat rig.toml)``, ``/dev/stdin``, pipes with names (``mkfifo``).

A reader may look at a file twice, and knows its format by its suffix. So each pipe is read once, into a file that goes
when the command has ended, with the suffix that its content calls for.
"""

from __future__ import annotations

import os
import re
import shutil
import stat
import time
import tomllib
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from zipfile import BadZipFile, ZipFile

from jounce.core.errors import DescriptionError, OutputError
from jounce.core.phrases import Phrase
from jounce.core.writing import lasting_folder

_PIPE = re.compile(
    r"(?P<before>(?:[^/]*=)?)(?P<path>/dev/stdin|/(?:dev|proc/self)/fd/(?P<number>\d{1,6}))"
)
_OUTPUTS = {"--out", "--figure", "--report", "--store", "--animation"}
"""Options whose files are written: a pipe there is refused, not read."""
_PATIENCE, _PAUSE = (
    3.0,
    0.01,
)  # s until somebody opens a pipe that has a name for writing; between two looks
_LARGEST = 1_000_000_000  # bytes
_SHARE = 1 << 20
_BEGINS = {
    b"\x89HDF": ".nc",
    b"CDF": ".nc",
    b"PAR1": ".parquet",
    b"MDF ": ".mf4",
    b"MATLAB": ".mat",
    b"TDSm": ".tdms",
    b"<": ".xml",
    b"{": ".json",
}
"""What files of a format begin with, and the suffix they are read by."""


@contextmanager
def without_pipes(words: Sequence[str]) -> Iterator[list[str]]:
    """Give a command line with the names of files in the place of pipes that are open for reading."""
    matches = [
        match if match and _is_readable(_number(match)) else None
        for match in map(_PIPE.fullmatch, words)
    ]
    pipes = [
        None if before in _OUTPUTS or _PIPE.fullmatch(word) else _named_pipe(word)
        for before, word in zip(["", *words], words, strict=False)
    ]
    if not any(matches) and not any(pipes):
        yield list(words)
        return
    folder = lasting_folder()
    try:
        copies = {
            number: _copy(number, folder)
            for number in {_number(match) for match in matches if match}
        }
        named = {pipe: _copy_named(pipe, folder) for pipe in dict.fromkeys(filter(None, pipes))}
        yield [
            f"{match['before']}{copies[_number(match)]}"
            if match
            else (word.removesuffix(pipe) + str(named[pipe]) if pipe else word)
            for word, match, pipe in zip(words, matches, pipes, strict=True)
        ]
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _named_pipe(word: str) -> str | None:
    """Name of the pipe that a word, or the value of its option, is; None where it is none, or one to be written to."""
    option, _, value = word.rpartition("=") if word.startswith("--") else ("", "", word)
    try:
        is_pipe = stat.S_ISFIFO(os.stat(value).st_mode)  # noqa: PTH116 - a word may be no path at all
    except (OSError, ValueError):
        return None
    return value if is_pipe and option not in _OUTPUTS else None


def _copy_named(pipe: str, folder: Path) -> Path:
    """Read what somebody writes into a pipe that has a name; give the file that holds it."""
    handle = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    try:
        begin = _wait_for_writer(handle, pipe)
        os.set_blocking(handle, True)
        own = folder / str(len(os.listdir(folder)))  # noqa: PTH208 - two pipes may have one name
        own.mkdir()
        return _copy(handle, own, Path(pipe).name, begin)
    finally:
        os.close(handle)


def _wait_for_writer(handle: int, pipe: str) -> bytes:
    """Wait until somebody has opened a pipe for writing; give what was written until then.

    Raises
    ------
    DescriptionError
        Where nobody does. Who has opened it may take any time to write.
    """
    end = time.monotonic() + _PATIENCE
    while time.monotonic() < end:
        try:
            if begin := os.read(handle, _SHARE):
                return begin
        except BlockingIOError:  # it is open for writing, and empty
            return b""
        time.sleep(_PAUSE)
    waited, hint = f"none within {_PATIENCE:g} s", "Start the process that writes to it first."
    raise DescriptionError("no process writes into this pipe", where=pipe, found=waited, hint=hint)


def _number(match: re.Match[str]) -> int:
    return int(match["number"] or 0)


def _is_readable(number: int) -> bool:
    """Whether a pipe or a file is open under a number, to be read: results are written to others."""
    try:
        import fcntl

        mode = os.fstat(number).st_mode
        writes = fcntl.fcntl(number, fcntl.F_GETFL) & os.O_ACCMODE == os.O_WRONLY
    except (ImportError, OSError):
        return False
    return not writes and (stat.S_ISFIFO(mode) or stat.S_ISSOCK(mode) or stat.S_ISREG(mode))


def _copy(number: int, folder: Path, name: str = "", begin: bytes = b"") -> Path:
    """Read what is open under a number to its end; give the file that holds it, after what was read before."""
    name = name or ("stdin" if number == 0 else f"pipe-{number}")
    file, size = folder / name, 0
    try:
        with os.fdopen(os.dup(number), "rb") as source, file.open("wb") as target:
            target.write(begin)
            while share := source.read(_SHARE):
                size += len(share)
                if size > _LARGEST:
                    allowed = Phrase("up to {largest:.3g} GB", largest=_LARGEST / 1e9)
                    raise DescriptionError("the pipe does not end", where=name, allowed=allowed)
                target.write(share)
    except OSError as error:
        hint = "Check the space there (TMPDIR)."
        raise OutputError(
            "a pipe cannot be copied", where=str(folder), found=error.strerror, hint=hint
        ) from error
    return file if file.suffix else file.rename(file.with_suffix(_suffix(file)))


def _suffix(file: Path) -> str:
    with file.open("rb") as stream:
        begin = stream.read(8)
    if begin.startswith(b"PK"):
        try:
            with ZipFile(file) as archive:
                return ".fmu" if "modelDescription.xml" in archive.namelist() else ".xlsx"
        except BadZipFile:
            return ".xlsx"
    for start, suffix in _BEGINS.items():
        if begin.startswith(start):
            return suffix
    first = next(
        (line for line in _lines(file) if line.strip() and not line.lstrip().startswith(b"#")), b""
    )
    return ".toml" if _is_toml(first) else ".csv"


def _lines(file: Path) -> Iterator[bytes]:
    with file.open("rb") as stream:
        yield from iter(lambda: stream.readline(_SHARE), b"")


def _is_toml(line: bytes) -> bool:
    """Whether a line begins a description: a table's name, or a key and its value."""
    try:
        return bool(tomllib.loads(line.decode()))
    except (UnicodeDecodeError, tomllib.TOMLDecodeError):
        return re.match(rb"\s*[\w.\"-]+\s*=", line) is not None
