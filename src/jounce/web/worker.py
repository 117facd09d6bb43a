"""The process that does one job: it runs a command, and keeps on the disk how far it is and what came of it.

It does what ``job.json`` in the folder of the job says. While it lives it holds the lock on
``alive``, which goes with it however it ends: a server that was started again since knows the job by that, and by the
files beside it. It stops where a file ``cancel`` appears, as a command does at Ctrl-C.
"""

from __future__ import annotations

import json
import os
import signal
import sys
import threading
import time
import traceback
from collections import deque
from collections.abc import Mapping
from importlib import import_module
from pathlib import Path
from typing import Any

from jounce.core.locking import hold
from jounce.core.phrases import german_of
from jounce.core.serialise import to_json

JOB, PROGRESS, RESULT, PROBLEMS, END, ALIVE, CANCEL = (
    "job.json", "progress.json", "result.json", "problems.txt", "end.json", "alive", "cancel",
)  # fmt: skip
_BETWEEN, _LOOKS = (
    0.2,
    0.2,
)  # s between two states on the disk, and between two looks for the wish to stop
_PATIENCE = 10.0  # s in which a command that is to stop does so, before it is ended
_TRIALS = 50
_MOST_STEPS = 400  # of a search that are kept


def _hold(file: Path) -> bool:
    """Hold a file until this process ends, as soon as whoever asks whether it is held has let it go."""
    for _ in range(_TRIALS):
        if hold(file) is not None:
            return True
        time.sleep(_LOOKS / 10.0)
    return False


def put(file: Path, plain: Mapping[str, Any]) -> None:
    """Write plain data so that a reader finds the old or the new, whole."""
    temporary = file.with_name(f".{file.name}.{os.getpid()}")
    temporary.write_text(to_json(plain, indent=None), encoding="utf-8")
    temporary.replace(file)


def _end_record(code: int) -> dict[str, Any]:
    return {"code": code, "ended": time.time(), "clock": time.monotonic()}


class _Told:
    """How far the work is, written to the disk now and then."""

    def __init__(self, file: Path) -> None:
        self.file, self.written = file, 0.0
        self.line: Any = None
        self.steps: deque[dict[str, Any]] = deque(maxlen=_MOST_STEPS)
        self.search = ""
        self.lock = threading.Lock()

    def follow(self, line: Any) -> None:
        """Take what the command says that it does."""
        self.line = line
        self.write()

    def watch(self, numbers: Mapping[str, Any]) -> None:
        """Take a step of a search: a new one begins where another thing is done, or other numbers are free."""
        search = f"{self.line.said if self.line else ''} {list(numbers['parameters'])}"
        if search != self.search:
            self.search = search
            self.steps.clear()
        self.steps.append(dict(numbers))
        self.write()

    def write(self, *, last: bool = False) -> None:
        """Write the state, unless that was done just now."""
        with self.lock:
            if not last and time.monotonic() - self.written < _BETWEEN:
                return
            line = self.line
            state: dict[str, Any] = {
                "at": time.time(),
                "clock": time.monotonic(),
                "steps": list(self.steps),
            }
            if line is not None:
                said = line.waits or line.said
                state |= {
                    "said": said,
                    "said_german": german_of(said),
                    "share": line.share(),
                    "left": line.left(),
                }
            put(self.file, state)
            self.written = time.monotonic()


def _stop_when_wanted(folder: Path) -> None:
    """Stop the command as Ctrl-C does; where it does not listen, end this process and what it has started."""
    while not (folder / CANCEL).exists():
        time.sleep(_LOOKS)
    signal.raise_signal(signal.SIGINT) if sys.platform == "win32" else os.kill(
        os.getpid(), signal.SIGINT
    )
    time.sleep(_PATIENCE)
    put(folder / END, _end_record(130))
    if sys.platform != "win32" and os.getpgrp() == os.getpid():
        os.killpg(os.getpgrp(), signal.SIGKILL)
    os._exit(130)


def work(folder: Path) -> int:
    """Do the job of a folder; give the exit code of its command."""
    if not _hold(folder / ALIVE):  # another process does it
        return 2
    job = json.loads((folder / JOB).read_text(encoding="utf-8"))
    signal.signal(
        signal.SIGINT, signal.default_int_handler
    )  # which a shell may have told to ignore it
    threading.Thread(target=_stop_when_wanted, args=(folder,), daemon=True).start()
    os.chdir(job["root"])
    progress = _Told(folder / PROGRESS)
    code = 1
    try:
        from jounce.core.files import always_below

        always_below(Path(job["root"]))
        if job.get("limits"):
            from jounce.core.child_processes import limit

            limit(*job["limits"])
        if "question" in job:
            from jounce.web.questions import answer

            code = answer(job["question"])
        else:
            from jounce.cli import main
            from jounce.cli.reply import followed_by
            from jounce.core.waiting import watched_by

            sys.argv = ["jounce", *job["words"]]  # which results keep
            with followed_by(progress.follow), watched_by(progress.watch):
                code = main([*job["words"], *job["own"], "--json"])
    except KeyboardInterrupt:
        code = 130
    except MemoryError:
        sys.stderr.write("jounce: it takes more memory than is allowed here.\n")
    finally:
        sys.stdout.flush()
        progress.write(last=True)
        put(folder / END, _end_record(code))
    return code


_USUAL = (
    "jounce.campaign",
    "jounce.identify.decay",
    "jounce.inspection.evaluation",
    "jounce.parts",
    "jounce.plots",
)


def split_when_told() -> None:
    """Load what most commands need, and say so; then do the job of each folder that standard input names.

    Each is done in a child of its own; before its folder stands by how much that is nicer than others.
    """
    from jounce.cli import main  # noqa: F401

    for name in (
        "xarray",
        "scipy.optimize",
        "scipy.signal",
        "pandas",
        "pydantic",
        "jounce.report.recordings",
        *_USUAL,
    ):
        import_module(name)
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # nobody asks how they ended but by their files
    sys.stdout.write("loaded\n")
    sys.stdout.flush()
    while line := sys.stdin.readline().strip():
        if os.fork():
            continue
        code, (behind, _, folder) = 1, line.partition(" ")
        try:
            os.nice(int(behind))
            signal.signal(signal.SIGCHLD, signal.SIG_DFL)
            os.setsid()
            os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
            for stream, name in ((1, RESULT), (2, PROBLEMS)):
                os.dup2(
                    os.open(Path(folder) / name, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600),
                    stream,
                )
            code = work(Path(folder))
        except Exception:  # noqa: BLE001 - its last line is the reason that the page shows
            traceback.print_exc()
        finally:
            sys.stderr.flush()
            os._exit(code)
