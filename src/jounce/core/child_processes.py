"""Start child processes with pipes or by a fork; monitor, limit and end them."""

from __future__ import annotations

import contextlib
import os
import select
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from jounce.core.errors import resource_error


class ChildProcess:
    """A process that receives requests and answers through pipes.

    Parameters
    ----------
    command : sequence of str
        Command to run.
    purpose : str
        Description of the process for the error raised if it cannot be started ("a process to read files in").
    environment : mapping, optional
        Variables that differ from those of this process.
    folder : Path, optional
        Working directory; by default that of this process.
    is_own_session : bool
        Whether it gets its own session: signals to its process group do not reach this process, and ending it also
        ends all processes it has started.
    """

    def __init__(
        self, command: Sequence[str], purpose: str, *, environment: Mapping[str, str] | None = None,
        folder: Path | None = None, is_own_session: bool = False,
    ) -> None:  # fmt: skip
        self._is_own_session = is_own_session
        try:
            self.process = subprocess.Popen(
                command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                bufsize=0,
                cwd=folder,
                env=None if environment is None else {**os.environ, **environment},
                start_new_session=is_own_session,
            )
        except OSError as error:
            raise resource_error(error, purpose) from None
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self._stdin, self._stdout = self.process.stdin, self.process.stdout

    def send(self, content: bytes) -> None:
        """Write to its standard input; raise OSError if it has ended."""
        self._stdin.write(content)

    def read(self, count: int, patience: float | None = None) -> bytes:
        """Read ``count`` bytes of its answer; raise EOFError if it has ended, TimeoutError if they arrive too late.

        Windows cannot wait for a pipe with a timeout: there is no limit.
        """
        if (
            patience
            and sys.platform != "win32"
            and not select.select([self._stdout], [], [], patience)[0]
        ):
            raise TimeoutError
        return bytes(self.fill(bytearray(count)))

    def fill(self, room: Any) -> Any:
        """Read its answer into a buffer; raise EOFError if it ends before the buffer is full."""
        view, got = memoryview(room), 0
        while got < len(view):
            count = self._stdout.readinto(view[got:])  # type: ignore[attr-defined]
            if not count:
                raise EOFError
            got += count
        return room

    def kill(self) -> None:
        """Kill it, with all processes that it started in its session."""
        with contextlib.suppress(OSError):
            if self._is_own_session and os.name == "posix":
                os.killpg(self.process.pid, signal.SIGKILL)
            else:
                self.process.kill()

    def end(self, patience: float = 0.0) -> None:
        """Close its pipes, wait up to ``patience`` (s) for it to end, and kill it otherwise."""
        for pipe in (self._stdin, self._stdout):
            with contextlib.suppress(OSError):
                pipe.close()
        try:
            self.process.wait(patience)
        except subprocess.TimeoutExpired:
            self.kill()
            self.process.wait()


LIMITS_MEMORY = sys.platform.startswith("linux")
"""Whether the system enforces the memory limit of a process; otherwise its parent monitors it."""
_BETWEEN_LOOKS = 0.25  # s: a process may exceed its memory for this time


class ProcessWatch(threading.Thread):
    """Thread that ends a child if it exceeds its time or, on systems that do not enforce a limit, its memory."""

    def __init__(self, process: subprocess.Popen[bytes], seconds: float, memory: float) -> None:
        super().__init__(daemon=True)
        self.process, self.end, self.memory = process, time.monotonic() + seconds, memory
        self.over = threading.Event()
        self.is_late = self.is_too_large = False

    def run(self) -> None:
        """Monitor it until it has answered."""
        while (left := self.end - time.monotonic()) > 0.0:
            if self.over.wait(left if LIMITS_MEMORY else min(left, _BETWEEN_LOOKS)):
                return
            if not LIMITS_MEMORY and _memory_of(self.process) > self.memory:
                self.is_too_large = True
                self.process.kill()
                return
        self.is_late = True
        self.process.kill()


def _memory_of(process: subprocess.Popen[bytes]) -> float:
    """Memory (bytes) of another process, as Windows or the system's ``ps`` reports it; 0 if unknown."""
    try:
        if sys.platform == "win32":
            return _memory_on_windows(int(process._handle))  # type: ignore[attr-defined,unused-ignore]
        asked = ["/bin/ps", "-o", "rss=", "-p", str(process.pid)]
        return 1024.0 * float(
            subprocess.run(asked, capture_output=True, timeout=5.0, check=False).stdout
        )
    except (OSError, ValueError, AttributeError, subprocess.TimeoutExpired):
        return 0.0


def _memory_on_windows(handle: int) -> float:
    """Private memory (bytes) of the process with a handle; 0 if Windows does not report it."""
    import ctypes

    sizes = (
        "PeakWorkingSet",
        "WorkingSet",
        "PeakPagedPool",
        "PagedPool",
        "PeakPool",
        "Pool",
        "Pagefile",
        "PeakFile",
    )

    class Counters(ctypes.Structure):
        """PROCESS_MEMORY_COUNTERS."""

        _fields_ = [
            ("size", ctypes.c_uint32),
            ("faults", ctypes.c_uint32),
            *((name, ctypes.c_size_t) for name in sizes),
        ]

    counters = Counters(size=ctypes.sizeof(Counters))
    ask = ctypes.WinDLL("kernel32").K32GetProcessMemoryInfo  # type: ignore[attr-defined,unused-ignore]
    ask.argtypes, ask.restype = (ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint32), ctypes.c_int
    return (
        float(counters.Pagefile) if ask(handle, ctypes.addressof(counters), counters.size) else 0.0
    )


# limits that a process sets for itself -------------------------------------------------------------------------------


def limit(memory: float, seconds: float) -> None:
    """Limit memory and computing time of this process, if the system supports it."""
    try:
        import resource
    except ImportError:  # Windows: only the parent's clock limits it
        return
    own = resource.getrusage(resource.RUSAGE_SELF)
    for kind, most in (
        (resource.RLIMIT_DATA, int(_used_memory() + memory)),
        (resource.RLIMIT_CPU, int(own.ru_utime + own.ru_stime + seconds) + 1),
        (resource.RLIMIT_CORE, 0),
    ):
        _, hard = resource.getrlimit(kind)
        with contextlib.suppress(ValueError, OSError):
            resource.setrlimit(
                kind, (most if hard == resource.RLIM_INFINITY else min(most, hard), hard)
            )


def has_less_than(memory: float) -> bool:
    """Whether the user or the system gives this process less memory than a file may take."""
    try:
        import resource
    except ImportError:
        return False
    most = [resource.getrlimit(kind)[1] for kind in (resource.RLIMIT_DATA, resource.RLIMIT_AS)]
    return any(
        0 <= limit < _used_memory() + memory for limit in most if limit != resource.RLIM_INFINITY
    )


def _used_memory() -> float:
    """Memory (bytes) of this process that counts towards the limit; 0 if the system does not report it."""
    return _memory_told(5)


def resident_memory() -> float:
    """Bytes that this process actually uses (libraries reserve far more); 0 if the system does not report it."""
    return _memory_told(1)


def _memory_told(column: int) -> float:
    try:
        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[column])
    except (OSError, ValueError, IndexError):
        return 0.0
    return float(pages * os.sysconf("SC_PAGE_SIZE"))


# forked processes -------------------------------------------------------------------------------------------------

_PIECE = 1 << 20


def bytes_from_fork(
    make: Callable[[], bytes], lock: contextlib.AbstractContextManager[Any], longest: float
) -> bytes | None:
    """Return the result of ``make`` in a fork of this process; None if it raises, crashes or exceeds its time (s).

    The process forks while it holds ``lock``: no other thread can hold it in the child.
    """
    reading, writing = os.pipe()
    with lock:
        child = os.fork()
    if child == 0:
        _do(make, writing)
    os.close(writing)
    content = None
    try:
        content = _all_of(reading, longest)
    finally:
        os.close(reading)
        if content is None:
            os.kill(child, signal.SIGKILL)  # not reaped yet: the number is still valid
        status = os.waitpid(child, 0)[1]
    return None if status else content


def _do(make: Callable[[], bytes], writing: int) -> None:
    """In the child: make the result, write it to the pipe, and end without cleanup handlers."""
    code = 1
    try:
        os.closerange(3, writing)  # connections of the server must not stay open in this child
        os.closerange(writing + 1, os.sysconf("SC_OPEN_MAX"))
        content = make()
        with os.fdopen(writing, "wb") as stream:
            stream.write(content)
        code = 0
    finally:
        os._exit(code)


def _all_of(reading: int, longest: float) -> bytes | None:
    """Read all bytes of a pipe until its other end closes; None if that takes too long."""
    pieces: list[bytes] = []
    end = time.monotonic() + longest
    while select.select([reading], [], [], max(0.0, end - time.monotonic()))[0]:
        piece = os.read(reading, _PIECE)
        if not piece:
            return b"".join(pieces)
        pieces.append(piece)
    return None
