"""Child processes: started with pipes or forked, watched, limited and ended."""

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
        What is run.
    purpose : str
        What it is for, as the error says it where the system starts none ("a process to read files in").
    environment : mapping, optional
        Variables that differ from those of this process.
    folder : Path, optional
        Where it works; here by default.
    is_own_session : bool
        Whether signals to its process group do not reach this one, and it is ended with all that it has started.
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
        """Write to its standard input; OSError if it has ended."""
        self._stdin.write(content)

    def read(self, count: int, patience: float | None = None) -> bytes:
        """Read some bytes of its answer; EOFError if it has ended, TimeoutError if none arrives in time.

        Windows cannot wait for a pipe: there it has all the time.
        """
        if (
            patience
            and sys.platform != "win32"
            and not select.select([self._stdout], [], [], patience)[0]
        ):
            raise TimeoutError
        return bytes(self.fill(bytearray(count)))

    def fill(self, room: Any) -> Any:
        """Read its answer into a buffer; EOFError if it ends before the buffer is full."""
        view, got = memoryview(room), 0
        while got < len(view):
            count = self._stdout.readinto(view[got:])  # type: ignore[attr-defined]
            if not count:
                raise EOFError
            got += count
        return room

    def kill(self) -> None:
        """End it at once, with all processes that it started in its session."""
        with contextlib.suppress(OSError):
            if self._is_own_session and os.name == "posix":
                os.killpg(self.process.pid, signal.SIGKILL)
            else:
                self.process.kill()

    def end(self, patience: float = 0.0) -> None:
        """Close its pipes, wait some time (s) for it to end by itself, and kill it otherwise."""
        for pipe in (self._stdin, self._stdout):
            with contextlib.suppress(OSError):
                pipe.close()
        try:
            self.process.wait(patience)
        except subprocess.TimeoutExpired:
            self.kill()
            self.process.wait()


LIMITS_MEMORY = sys.platform.startswith("linux")
"""Whether the system holds a process to the memory that it may take; elsewhere a watch looks at it from outside."""
_BETWEEN_LOOKS = 0.25  # s: a process may take too much for so long


class ProcessWatch(threading.Thread):
    """Ends a child that exceeds its time or, on systems that report but do not limit memory, its memory."""

    def __init__(self, process: subprocess.Popen[bytes], seconds: float, memory: float) -> None:
        super().__init__(daemon=True)
        self.process, self.end, self.memory = process, time.monotonic() + seconds, memory
        self.over = threading.Event()
        self.is_late = self.is_too_large = False

    def run(self) -> None:
        """Watch it until it has answered."""
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
    """Bytes that another process takes, as Windows or the system's ``ps`` says; 0 where nobody tells."""
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
    """Bytes that the process of a handle keeps for itself; 0 where Windows does not tell."""
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


# limits that a process holds itself to -------------------------------------------------------------------------------


def limit(memory: float, seconds: float) -> None:
    """Limit memory and computing time from now on, if the system can."""
    try:
        import resource
    except ImportError:  # Windows: the clock of the parent alone
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
    """Bytes of data that this process may use, which the limit counts; 0 where the system does not tell."""
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


# split off, without pipes to it ------------------------------------------------------------------------------------

_PIECE = 1 << 20


def bytes_from_fork(
    make: Callable[[], bytes], lock: contextlib.AbstractContextManager[Any], longest: float
) -> bytes | None:
    """Return the result of ``make`` in a fork of this process; None if it raises, crashes or exceeds its time (s).

    The process splits while ``lock`` is held, which the child needs free.
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
            os.kill(child, signal.SIGKILL)  # not waited for yet: it is still this one
        status = os.waitpid(child, 0)[1]
    return None if status else content


def _do(make: Callable[[], bytes], writing: int) -> None:
    """In the child: make it, hand it over, end without what a process does at its end."""
    code = 1
    try:
        os.closerange(
            3, writing
        )  # connections of the server, which must not live on with this child
        os.closerange(writing + 1, os.sysconf("SC_OPEN_MAX"))
        content = make()
        with os.fdopen(writing, "wb") as stream:
            stream.write(content)
        code = 0
    finally:
        os._exit(code)


def _all_of(reading: int, longest: float) -> bytes | None:
    """All bytes of a pipe until its other end closes; None where that takes too long."""
    pieces: list[bytes] = []
    end = time.monotonic() + longest
    while select.select([reading], [], [], max(0.0, end - time.monotonic()))[0]:
        piece = os.read(reading, _PIECE)
        if not piece:
            return b"".join(pieces)
        pieces.append(piece)
    return None
