"""The process of one job: it runs a command and stores its progress and result on disk.

The job is described by ``job.json`` in its folder. While the process runs it holds the lock on ``alive``, which the
system releases however it ends. A restarted server identifies running jobs by this lock and the other files in the
folder. The process stops when a file ``cancel`` appears, as a command does on Ctrl-C.
"""

from __future__ import annotations

import gc
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
from jounce.web.memory import drop_program_pages

JOB, PROGRESS, RESULT, PROBLEMS, END, ALIVE, CANCEL = (
    "job.json", "progress.json", "result.json", "problems.txt", "end.json", "alive", "cancel",
)  # fmt: skip
_BETWEEN, _LOOKS = (
    0.2,
    0.2,
)  # s between two writes of the state, and between two checks for cancellation
_PATIENCE = 10.0  # s within which a cancelled command must stop before it is killed
_TRIALS = 50
_MOST_STEPS = 400  # maximum number of search steps kept


def _hold(file: Path) -> bool:
    """Lock a file until this process ends, waiting while another process tests the lock."""
    for _ in range(_TRIALS):
        if hold(file) is not None:
            return True
        time.sleep(_LOOKS / 10.0)
    return False


def put(file: Path, plain: Mapping[str, Any]) -> None:
    """Write plain data atomically: a reader finds either the old or the new version."""
    temporary = file.with_name(f".{file.name}.{os.getpid()}")
    temporary.write_text(to_json(plain, indent=None), encoding="utf-8")
    temporary.replace(file)


def _end_record(code: int) -> dict[str, Any]:
    return {"code": code, "ended": time.time(), "clock": time.monotonic()}


class _Told:
    """Progress of the work, written to disk periodically."""

    def __init__(self, file: Path) -> None:
        self.file, self.written = file, 0.0
        self.line: Any = None
        self.heard: str | None = None
        self.steps: deque[dict[str, Any]] = deque(maxlen=_MOST_STEPS)
        self.search = ""
        self.lock = threading.Lock()

    def follow(self, line: Any) -> None:
        """Store the current activity reported by the command."""
        self.line = line
        self.write()

    def hear(self, text: str | None) -> None:
        """Store what a question waits for."""
        self.heard = getattr(text, "what", text)
        self.write()

    def watch(self, numbers: Mapping[str, Any]) -> None:
        """Store a step of a search; a new search starts if the activity or the free parameters change."""
        search = f"{self.line.said if self.line else ''} {list(numbers['parameters'])}"
        if search != self.search:
            self.search = search
            self.steps.clear()
        self.steps.append(dict(numbers))
        self.write()

    def write(self, *, last: bool = False) -> None:
        """Write the state, unless it was written recently."""
        with self.lock:
            if not last and time.monotonic() - self.written < _BETWEEN:
                return
            line = self.line
            state: dict[str, Any] = {
                "at": time.time(),
                "clock": time.monotonic(),
                "steps": list(self.steps),
            }
            if self.heard is not None:
                state |= {
                    "said": self.heard,
                    "said_german": german_of(self.heard),
                    "share": getattr(self.heard, "share", None),
                }
            if line is not None:
                said = line.waits or line.said
                state |= {
                    "said": said,
                    "said_german": german_of(said),
                    "share": line.share(),
                    "left": line.left(),
                    "stage": line.stage(),
                }
            put(self.file, state)
            self.written = time.monotonic()


def _stop_when_wanted(folder: Path) -> None:
    """Stop the command as Ctrl-C does; if it does not respond, end this process and its children."""
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
    """Run the job of a folder; return the exit code of its command."""
    if not _hold(folder / ALIVE):  # another process runs it
        return 2
    job = json.loads((folder / JOB).read_text(encoding="utf-8"))
    signal.signal(
        signal.SIGINT, signal.default_int_handler
    )  # a shell may have set it to be ignored
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
            from jounce.core.waiting import heard_by
            from jounce.web.questions import answer

            with heard_by(progress.hear):
                code = answer(job["question"], folder)
        else:
            from jounce.cli import main
            from jounce.cli.reply import followed_by
            from jounce.core.waiting import watched_by

            sys.argv = ["jounce", *job["words"]]  # results store it
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
    """Import common modules, report readiness, then run the job of each folder named on standard input.

    Each job runs in its own child process; the folder is preceded by the child's niceness increment.
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
    gc.collect()
    gc.freeze()  # a collection in a child would copy all pages
    drop_program_pages()
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)  # their outcome is read only from their files
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
        except Exception:  # noqa: BLE001 - the page shows its last line as the reason
            traceback.print_exc()
        finally:
            sys.stderr.flush()
            os._exit(code)
