"""Pipes as input files: ``jounce modes <(cat rig.toml)``, ``/dev/stdin``, named pipes (``mkfifo``).

A reader may open a file twice, and identifies its format by the suffix. Each pipe is therefore read once into a
temporary file with the suffix that matches its content; the file is deleted when the command ends.
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
"""Options for output files: a pipe is rejected there."""
_PATIENCE, _PAUSE = (
    3.0,
    0.01,
)  # s to wait until a named pipe is opened for writing; s between two checks
_LARGEST = 1_000_000_000  # bytes
_SHARE = 1 << 20
_BEGINS = {
    b"\x89HDF": ".nc",
    b"CDF": ".nc",
    b"PAR1": ".parquet",
    b"MDF ": ".mf4",
    b"MATLAB": ".mat",
    b"TDSm": ".tdms",
    b"FORMAT": ".rsp",
    b"<": ".xml",
    b"{": ".json",
}
"""First bytes of each file format, and its suffix."""


@contextmanager
def without_pipes(words: Sequence[str]) -> Iterator[list[str]]:
    """Return a command line with readable pipes replaced by temporary files."""
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
    """Return the pipe named by a word or its option value; ``None`` if it is not a pipe, or is an output."""
    option, _, value = word.rpartition("=") if word.startswith("--") else ("", "", word)
    try:
        is_pipe = stat.S_ISFIFO(os.stat(value).st_mode)  # noqa: PTH116 - a word may not be a path
    except (OSError, ValueError):
        return None
    return value if is_pipe and option not in _OUTPUTS else None


def _copy_named(pipe: str, folder: Path) -> Path:
    """Read a named pipe to its end; return the file with its content."""
    handle = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    try:
        begin = _wait_for_writer(handle, pipe)
        os.set_blocking(handle, True)
        own = folder / str(len(os.listdir(folder)))  # noqa: PTH208 - two pipes may have the same name
        own.mkdir()
        return _copy(handle, own, Path(pipe).name, begin)
    finally:
        os.close(handle)


def _wait_for_writer(handle: int, pipe: str) -> bytes:
    """Wait until a process has opened a pipe for writing; return the data received so far.

    Raises
    ------
    DescriptionError
        If no process opens it in time. After that, there is no time limit for writing.
    """
    end = time.monotonic() + _PATIENCE
    while time.monotonic() < end:
        try:
            if begin := os.read(handle, _SHARE):
                return begin
        except BlockingIOError:  # open for writing, but empty
            return b""
        time.sleep(_PAUSE)
    waited, hint = f"none within {_PATIENCE:g} s", "Start the writing process first."
    raise DescriptionError("no process writes into this pipe", where=pipe, found=waited, hint=hint)


def _number(match: re.Match[str]) -> int:
    return int(match["number"] or 0)


def _is_readable(number: int) -> bool:
    """Whether a file descriptor is a pipe or file open for reading, not an output."""
    try:
        import fcntl

        mode = os.fstat(number).st_mode
        writes = fcntl.fcntl(number, fcntl.F_GETFL) & os.O_ACCMODE == os.O_WRONLY
    except (ImportError, OSError):
        return False
    return not writes and (stat.S_ISFIFO(mode) or stat.S_ISSOCK(mode) or stat.S_ISREG(mode))


def _copy(number: int, folder: Path, name: str = "", begin: bytes = b"") -> Path:
    """Read a file descriptor to its end, after data already read; return the file with the content."""
    name = name or ("stdin" if number == 0 else f"pipe-{number}")
    file, size = folder / name, 0
    try:
        with os.fdopen(os.dup(number), "rb") as source, file.open("wb") as target:
            target.write(begin)
            while share := source.read(_SHARE):
                size += len(share)
                if size > _LARGEST:
                    allowed = Phrase("up to {largest:.3g} GB", largest=_LARGEST / 1e9)
                    raise DescriptionError(
                        "the pipe delivers more data than allowed", where=name, allowed=allowed
                    )
                target.write(share)
    except OSError as error:
        hint = "Check the free space in the temporary folder (TMPDIR)."
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
