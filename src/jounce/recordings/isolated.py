"""Run the readers of binary formats in a child process, which a damaged file may crash or block without other harm.

One child serves many files to save its start-up time. Requests and replies are JSON, followed by the raw bytes of
arrays: nothing from a file is executed or unpickled. Memory and time limits of the child depend on the size of the
file.
"""

from __future__ import annotations

import atexit
import contextlib
import json
import os
import signal
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import IO, Any

import numpy as np

from jounce.core import errors, optional
from jounce.core.child_processes import (
    ChildProcess,
    ProcessWatch,
    has_less_than,
    limit,
    resident_memory,
)
from jounce.core.columns import Column, ColumnTable
from jounce.core.errors import (
    JounceError,
    RecordingError,
    ResourceError,
    resource_error,
    show_value,
    unforeseen,
)
from jounce.core.findings import finding_of
from jounce.core.phrases import Phrase
from jounce.core.serialise import to_plain
from jounce.recordings.reader import Reader, ReaderOptions, SignalTable

MEMORY, MEMORY_A_BYTE = 1.5e9, 32.0
"""Memory limit for reading a file: bytes, plus bytes for each byte of the file."""
TIME, TIME_A_BYTE = 10.0, 1e-6
"""CPU time limit for reading a file: seconds, plus seconds for each byte; elapsed time may be three times that."""

_PATH = "import json, sys; sys.path[:] = json.loads(sys.argv[1])\n"
_CHILD = f"""{_PATH}from jounce.recordings.isolated import serve
from jounce.recordings.readers import READERS
serve(READERS)"""
_NUMBERS = "fiub"
_READY = b"+"
"""Byte that a child sends once it has loaded its modules."""
_LARGEST_WORKER = 1e9  # bytes that a child may keep between two files


def is_possible() -> bool:
    """Whether this process can start another Python interpreter: not if embedded, frozen or in a browser."""
    name = Path(sys.executable or "").name.lower()
    return name.startswith(("python", "pypy")) and not getattr(sys, "frozen", False)


def read_isolated(reader: Reader, path: Path, options: ReaderOptions) -> SignalTable:
    """Read a file with a built-in reader in a child process; its crash or time-out raises RecordingError."""
    child = _take_child()
    try:
        answer, arrays = child.ask(reader.name, path, options)
    except BaseException:
        child.end()
        raise
    if answer["is_last"]:
        child.end()
    else:
        _IDLE.append(child)
    if "error" in answer:
        raise _error(answer["error"])
    return _signals(answer["signals"], arrays)


def prepare() -> None:
    """Start a child process unless one is idle; do not wait until it is ready."""
    if not _IDLE:
        _IDLE.append(_Child())


class _Child(ChildProcess):
    """A process that reads files."""

    def __init__(self) -> None:
        threads = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
        command = [sys.executable, "-P", "-c", _CHILD, json.dumps(sys.path)]
        super().__init__(command, "a process to read files in", environment=threads)
        self.is_ready = False

    def ask(
        self, reader: str, path: Path, options: ReaderOptions
    ) -> tuple[dict[str, Any], list[Any]]:
        """Request a file and return the child's reply with its arrays."""
        size = path.stat().st_size
        seconds, memory = TIME + size * TIME_A_BYTE, MEMORY + size * MEMORY_A_BYTE
        request = {
            "reader": reader,
            "path": str(path),
            "folder": _folder(),
            "variable": options.variable,
            "header": options.header,
            "database": None if options.database is None else str(options.database),
            "memory": memory,
            "seconds": seconds,
        }
        watch = ProcessWatch(self.process, 3.0 * seconds, memory)
        watch.start()
        try:
            self.is_ready = self.is_ready or self.read(1) == _READY
            self.send(json.dumps(request).encode() + b"\n")
            return _receive(self)
        except (EOFError, BrokenPipeError, ConnectionError):
            if watch.is_too_large:
                raise too_much_memory(MemoryError(), str(path), memory) from None
            raise self._fate(path, seconds, late=watch.is_late) from None
        finally:
            watch.over.set()

    def _fate(self, path: Path, seconds: float, *, late: bool) -> RecordingError | ResourceError:
        """Return the error that explains why the child ended: a damaged file or a lack of system resources."""
        code = self.process.wait()
        if not late and (-code in _FROM_OUTSIDE or not self.is_ready):
            how = f"{signal.Signals(-code).name}" if code < 0 else f"exit code {code}"
            return ResourceError(
                "the reading process was terminated externally"
                if self.is_ready
                else "the reading process does not start",
                where=str(path),
                found=how,
                hint="Check that enough memory, processes and file handles are available, then read the file again.",
            )
        if late or -code == getattr(signal, "SIGXCPU", None):
            return RecordingError(
                "reading does not finish, so the file is damaged",
                where=str(path),
                found=f"more than {seconds:.0f} s",
                allowed=Phrase(
                    "{time:.0f} s plus 1 s for every {time_a_byte:.0f} MB",
                    time=TIME,
                    time_a_byte=1e-06 / TIME_A_BYTE,
                ),
                hint="Use an undamaged copy.",
            )
        with contextlib.suppress(ValueError):
            return RecordingError(
                Phrase(
                    "the reading process crashed ({name}), so the file is damaged",
                    name=signal.Signals(-code).name,
                ),
                where=str(path),
                hint="Use an undamaged copy.",
            )
        return RecordingError(
            Phrase("the reading process ended unexpectedly (exit code {code})", code=code),
            where=str(path),
            hint="Use an undamaged copy.",
        )


_FROM_OUTSIDE = {getattr(signal, name, None) for name in ("SIGKILL", "SIGTERM", "SIGHUP")}
"""Signals sent by a user, or by a system short of memory, but not by libraries."""


def _folder() -> str:
    """Return the current working directory, or the root directory if it no longer exists."""
    with contextlib.suppress(OSError):
        return str(Path.cwd())
    return os.sep


_IDLE: list[_Child] = []


def _take_child() -> _Child:
    """Return an idle child, or start a new one."""
    with contextlib.suppress(IndexError):
        while True:
            child = _IDLE.pop()
            if child.process.poll() is None:
                return child
            child.end()
    return _Child()


@atexit.register
def _end_all() -> None:
    while _IDLE:
        _IDLE.pop().end()


def _forget() -> None:
    """Forget inherited children after a fork: they belong to the parent process."""
    for child in _IDLE:
        child.process.returncode = 0
    _IDLE.clear()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget)


# --- child process


def serve(readers: Sequence[Reader]) -> None:
    """Answer requests for these readers from standard input until it ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent decides
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # keep output of libraries out of the replies
    answers.write(_READY)
    answers.flush()
    for line in sys.stdin.buffer:
        request = json.loads(line)
        arrays: list[np.ndarray[Any, Any]] = []
        answer: dict[str, Any] = {}
        try:
            os.chdir(request["folder"])
            limit(request["memory"], request["seconds"])
            answer["signals"] = _plain_signals(_read(readers, request), arrays)
        except JounceError as error:
            answer, arrays = {"error": _plain_error(error)}, []
        except MemoryError as error:
            path, memory = request["path"], request["memory"]
            known = (
                resource_error(error, path)
                if has_less_than(memory)
                else too_much_memory(error, path, memory)
            )
            answer, arrays = {"error": _plain_error(known)}, []
        except Exception as error:  # noqa: BLE001 - the parent must receive any error
            answer, arrays = (
                {"error": _plain_error(unforeseen(error, request["path"], RecordingError))},
                [],
            )
        os.chdir(
            Path(sys.executable).anchor or os.sep
        )  # some systems cannot remove the working directory of a process
        answer["is_last"] = resident_memory() > _LARGEST_WORKER
        _send(answers, answer, arrays)


def too_much_memory(error: MemoryError, path: str, allowed: float = 0.0) -> RecordingError:
    """Return the error about a file that needs more memory than its limit, or than is available."""
    return RecordingError(
        f"the file takes more memory than {'a file of its size may' if allowed else 'there is'}",
        where=path,
        found=str(error) or None,
        allowed=Phrase("{allowed:.1f} GB", allowed=allowed / 1e9) if allowed else "",
        hint="The file is damaged, or contains far more data than its size suggests.",
    )


def _read(readers: Sequence[Reader], request: Mapping[str, Any]) -> SignalTable:
    database = None if request["database"] is None else Path(request["database"])
    reader = next(candidate for candidate in readers if candidate.name == request["reader"])
    return reader.read(
        Path(request["path"]), ReaderOptions(request["variable"], request["header"], database)
    )


# --- messages on the pipe


def _send(stream: IO[bytes], answer: Mapping[str, Any], arrays: list[Any]) -> None:
    text = json.dumps(answer).encode()
    stream.write(len(text).to_bytes(8, "little") + text)
    for array in arrays:
        stream.write(_bytes_of(np.ascontiguousarray(array)))
    stream.flush()


def _receive(child: ChildProcess) -> tuple[dict[str, Any], list[Any]]:
    size = int.from_bytes(child.read(8), "little")
    answer: dict[str, Any] = json.loads(child.read(size))
    arrays = []
    for dtype, shape in answer.get("signals", {}).get("arrays", ()):
        array = np.empty(shape, np.dtype(dtype))
        if array.size:
            child.fill(_bytes_of(array))
        arrays.append(array)
    return answer, arrays


def _bytes_of(array: Any) -> memoryview:
    return memoryview(array.reshape(-1)).cast("B")


def _plain_signals(signals: SignalTable, arrays: list[Any]) -> dict[str, Any]:
    def pack(value: Any) -> Any:
        return _plain(value, arrays)

    plain = {
        "tables": [
            {
                "columns": [
                    [
                        column.name,
                        column.unit,
                        pack(column.values),
                        column.file,
                        None if column.fault is None else _plain_error(column.fault),
                        column.written,
                        None
                        if column.part is None
                        else [pack(column.part[0]), pack(column.part[1])],
                    ]
                    for column in table
                ],
                "comments": table.comments,
                "file": table.file,
                "lines": list(table.lines),
                "remarks": to_plain(table.remarks),
            }
            for table in signals.tables
        ],
        "long_names": dict(signals.long_names),
        "attributes": {name: pack(value) for name, value in signals.attributes.items()},
        "left_out": signals.left_out,
        "findings": [to_plain(item) | {"value": pack(item.value)} for item in signals.findings],
    }
    return {**plain, "arrays": [[array.dtype.str, array.shape] for array in arrays]}


def _signals(plain: Mapping[str, Any], arrays: list[Any]) -> SignalTable:
    def unpack(value: Any) -> Any:
        return _unpack(value, arrays)

    tables = [
        ColumnTable(
            tuple(
                Column(
                    name,
                    unit,
                    unpack(values),
                    file,
                    None if fault is None else _error(fault),  # type: ignore[arg-type]
                    written,
                    None if part is None else (unpack(part[0]), unpack(part[1])),
                )
                for name, unit, values, file, fault, written, part in table["columns"]
            ),
            tuple(table["comments"]),
            table["file"],
            table["lines"],
            tuple(map(finding_of, table["remarks"])),
        )
        for table in plain["tables"]
    ]
    return SignalTable(
        tables[0],
        plain["long_names"],
        {name: unpack(value) for name, value in plain["attributes"].items()},
        tuple(plain["left_out"]),
        tuple(tables[1:]),
        tuple(finding_of(item | {"value": unpack(item["value"])}) for item in plain["findings"]),
    )


def _plain(value: Any, arrays: list[Any]) -> Any:
    """Convert a value to JSON; arrays are appended to ``arrays``. Other objects are converted to text."""
    if value is None or isinstance(value, (bool, int, str)) or type(value) is float:
        return value
    if isinstance(value, np.generic) and value.dtype.kind in "U":
        return str(value)
    if isinstance(value, (np.ndarray, np.generic)) and np.asarray(value).dtype.kind in _NUMBERS:
        arrays.append(np.asarray(value))
        return {"array": len(arrays) - 1, "is_scalar": isinstance(value, np.generic)}
    if isinstance(value, np.ndarray):
        return {"texts": [_text(item) for item in value.ravel()]}
    return _text(value)


def _text(value: Any) -> str:
    return value.decode(errors="replace") if isinstance(value, bytes) else str(value)


def _unpack(value: Any, arrays: list[Any]) -> Any:
    if not isinstance(value, dict):
        return value
    if "texts" in value:
        return np.array(value["texts"], dtype=object)
    array = arrays[value["array"]]
    return array[()] if value["is_scalar"] else array


_KINDS: dict[str, Callable[..., JounceError]] = {
    kind.__name__: kind
    for module in (errors, optional)
    for kind in vars(module).values()
    if isinstance(kind, type) and issubclass(kind, JounceError)
}


def _plain_error(error: JounceError) -> dict[str, Any]:
    value = (
        error.found
        if isinstance(error.found, (str, int, float, type(None)))
        else show_value(error.found)
    )
    return {
        "kind": type(error).__name__,
        "parts": [error.what, error.where, value, error.allowed, error.hint],
    }


def _error(plain: Mapping[str, Any]) -> JounceError:
    what, where, value, allowed, hint = plain["parts"]
    return _KINDS.get(plain["kind"], RecordingError)(
        what, where=where, found=value, allowed=allowed, hint=hint
    )
