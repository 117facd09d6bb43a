"""Long-running jobs in separate processes, which continue when the page is closed or the server stops.

All data of a job are stored in the folder ``.jounce/jobs/ID`` of the project (see `jounce.web.worker`). The server
only starts jobs, reads their state, and requests cancellation. A copied project may contain jobs: unreadable or
invalid ones are skipped. Jobs are numbered, and their durations use a monotonic clock.
"""

from __future__ import annotations

import contextlib
import json
import os
import re
import secrets
import select
import shutil
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, TypeVar

from pydantic import BaseModel, Field, FiniteFloat

from jounce.core.commands import command_line
from jounce.core.errors import DescriptionError, JounceError, Message, OutputError
from jounce.core.locking import is_held
from jounce.core.phrases import Phrase, Translated, german_of
from jounce.core.writing import ALLOW_OVERWRITING
from jounce.kernel.apart import SPLITS
from jounce.web.project import Project
from jounce.web.tasks import AnyTask, JobSpec, spec_of
from jounce.web.untrusted import content, is_regular, mark, plain_json
from jounce.web.worker import ALIVE, CANCEL, END, JOB, PROBLEMS, PROGRESS, RESULT, put

PLACE = "jobs"
_MOST_RUNNING, _MOST_KEPT, _MOST_LOOKED_AT = 8, 200, 1000
_NAME, _GREATEST = (
    re.compile(r"[0-9]{1,8}(-[0-9a-f]{1,16}){1,3}"),
    99_999_999,
)  # number, and a unique suffix
_JUST_BEGUN = 15.0  # s within which a new process must have locked its file ``alive``
_LONGEST, _LONGEST_RESULT = (
    2_000_000,
    20_000_000,
)  # maximum bytes of a job's state, and of its result
_FREE = 50  # number of checks that find the file unlocked
_BEHIND = 5  # niceness of a job relative to the page
_LOOKED = 0.1  # s for which the list of all jobs is considered current


class _Job(BaseModel):
    """Description of a job, read from its folder."""

    kind: str | None = None
    asked: dict[str, Any] | None = None
    title: str = ""
    python: str = ""
    command: str = ""
    files: dict[str, str] = Field(default_factory=dict)
    out: str = ""
    page: str = ""
    begun: FiniteFloat
    clock: FiniteFloat | None = None


class _End(BaseModel):
    """End of a job: exit code, time (s since 1970), and monotonic time."""

    code: int
    ended: FiniteFloat
    clock: FiniteFloat | None = None


class _Progress(BaseModel):
    """Progress of a job, with its time."""

    at: FiniteFloat | None = None
    clock: FiniteFloat | None = None
    said: str = ""
    said_german: str | None = None
    share: FiniteFloat | None = None
    left: FiniteFloat | None = None
    stage: tuple[int, int] | None = None
    steps: list[dict[str, Any]] = Field(default_factory=list)


_Said = TypeVar("_Said", _Job, _End, _Progress)


class Jobs:
    """The jobs of a project."""

    def __init__(self, project: Project) -> None:
        self.project = project
        self.begun: dict[str, float] = {}  # monotonic start times of jobs started by this server
        self.processes: dict[str, subprocess.Popen[bytes]] = {}
        self.ended: dict[str, dict[str, Any]] = {}
        self.awaited: dict[str, Path] = {}  # folders of short tasks, by title
        self.ready: subprocess.Popen[bytes] | None = None
        self.closing = threading.Event()  # the server is stopping: no client receives answers
        self.lock, self.read, self.known = threading.Lock(), 0.0, []  # type: tuple[Any, float, list[dict[str, Any]]]

    @property
    def folder(self) -> Path:
        """Return the folder of the jobs."""
        return self.project.own(PLACE)

    def begin(self, task: AnyTask) -> dict[str, Any]:
        """Start a job; return its state."""
        spec = spec_of(task, self.project)
        with self.lock:
            running = [job for job in self._all() if job["state"] == "running"]
            if len(running) >= _MOST_RUNNING:
                hint = "Wait for one of them, or cancel it."
                raise OutputError(
                    "too many jobs are running", where="jobs", found=len(running), hint=hint
                )
            clash = next((job for job in running if spec.out and job["out"] == spec.out), None)
            if clash is not None:
                hint = "Wait for that job, or choose another folder."
                raise OutputError(
                    "another job is writing to this folder",
                    where=spec.out,
                    found=clash["title"],
                    hint=hint,
                )
            self._forget_old()
            number = max((_number(name) for name in self._names()), default=0) + 1
            name = f"{min(number, _GREATEST):06d}-{secrets.token_hex(4)}"
            self.begun[name] = time.monotonic()
            folder = self._write_job(self.folder / name, spec, task)
            if not (self._has_loaded() and self._split(folder, _BEHIND)):
                self.processes[name] = _start_process(folder)
            self.read = 0.0
            return self.state(name)

    def ask(self, spec: JobSpec) -> dict[str, Any]:
        """Run a short task in a separate process with limits, and wait for its result."""
        with self._finished(spec) as folder:
            page = folder / "report.html"
            text = page.read_text(encoding="utf-8") if page.is_file() else ""
            return {"result": _result(folder), "page": text, **equivalents(spec)}

    def document(self, spec: JobSpec, name: str = "report.pdf") -> bytes:
        """Run a short task that writes a file into its folder, wait for it, and return the content of the file."""
        with self._finished(spec) as folder:
            return (folder / name).read_bytes()

    @contextlib.contextmanager
    def _finished(self, spec: JobSpec) -> Iterator[Path]:
        """Run a task in a separate process; give its folder once it has ended well."""
        with tempfile.TemporaryDirectory(prefix="jounce-") as place:
            folder = self._write_job(Path(place) / "asked", spec, None)
            self.awaited[spec.title] = folder
            try:
                self._apart(folder, light=spec.light)
                is_over = _is_over(folder, spec.patience, self.closing)
            finally:
                self.awaited.pop(spec.title, None)
            if not is_over:
                mark(folder / CANCEL)
                limit = f"more than {spec.patience:.0f} s"
                raise DescriptionError("this takes too long", where=spec.title, found=limit)
            end = _read_model(_End, folder / END)
            outcome = _outcome(folder, end.code if end else -1)
            if outcome["error"] is not None:
                raise Refused(outcome["error"])
            yield folder

    def prepare(self) -> None:
        """Start a process that forks workers for the page's requests, because starting a process is slow."""
        with self.lock:
            if self.closing.is_set():
                return
            if SPLITS and (self.ready is None or self.ready.poll() is not None):
                self.ready = _waiting()

    def share_of(self, title: str) -> float | None:
        """Return the completed share of a short task that somebody waits for; None if it is unknown."""
        folder = self.awaited.get(title)
        progress = folder and _read_model(_Progress, folder / PROGRESS)
        return progress.share if progress else None

    def _apart(self, folder: Path, *, light: bool) -> None:
        """Start a process that works on a folder; a light task does not wait for the standby process to load."""
        if not light:
            self.prepare()
        with self.lock:
            is_begun = (not light or self._has_loaded()) and self._split(folder, 0)
        if not is_begun:
            _start_process(folder, waited=True)

    def _has_loaded(self) -> bool:
        """Whether the standby process has reported that it is loaded; it starts after the first page."""
        said = None if self.ready is None else self.ready.stdout
        return said is not None and bool(select.select([said], [], [], 0.0)[0])

    def _split(self, folder: Path, behind: int) -> bool:
        """Fork the standby process for a folder, with a niceness increment; ``False`` without such a process."""
        if self.ready is None or self.ready.stdin is None or self.ready.poll() is not None:
            return False
        try:
            self.ready.stdin.write(f"{behind} {folder}\n".encode())
            self.ready.stdin.flush()
        except OSError:  # it has exited
            return False
        return True

    def end(self) -> None:
        """Stop the standby process; jobs continue."""
        self.closing.set()
        if self.ready is not None:
            with self.ready:
                self.ready.kill()

    def all(self) -> list[dict[str, Any]]:
        """Return the state of all jobs, newest first."""
        with self.lock:
            if time.monotonic() - self.read > _LOOKED:
                self.known, self.read = self._all(), time.monotonic()
            return self.known

    def state(self, name: str) -> dict[str, Any]:
        """Return the state of a job."""
        if name in self.ended:
            return self.ended[name]
        folder = self._place(name)
        job, progress = self._job(name), _read_model(_Progress, folder / PROGRESS) or _Progress()
        is_cancelled = os.path.lexists(folder / CANCEL)
        answer = {
            "id": name,
            **job.model_dump(exclude={"clock"}),
            "error": None,
            "german": None,
            "ended": None,
        }
        answer |= progress.model_dump(exclude={"at", "clock"})
        end = _read_model(_End, folder / END)
        if end is None and self._lives(name, folder):
            lasted = (
                None if job.clock is None else float(round(max(0.0, time.monotonic() - job.clock)))
            )
            return answer | {"state": "cancelling" if is_cancelled else "running", "lasted": lasted}
        end = end or _read_model(
            _End, folder / END
        )  # it may have been written between the two reads
        outcome = _outcome(folder, end.code if end else None)
        state = outcome["state"] if not is_cancelled or outcome["state"] == "done" else "cancelled"
        here, error = f"{self.project.root}{os.sep}", outcome["error"] or {}
        last, ended = (end.clock, end.ended) if end else (progress.clock, progress.at)
        lasted = None if last is None or job.clock is None else max(0.0, last - job.clock)
        answer |= {"state": state, "code": end and end.code, "ended": ended, "lasted": lasted}
        if state == "failed":
            answer["error"], answer["german"] = (
                (error.get(key) or "").replace(here, "") or None for key in ("text", "german")
            )
        if (
            end is None
        ):  # checked again: a job just started by another server may take a moment to lock its file
            return answer | {"error": _LOST, "german": german_of(_LOST)}
        self.ended[name] = answer
        return answer

    def result(self, name: str) -> Any:
        """Return the output of a job's command."""
        return _result(self._place(name))

    def cancel(self, name: str) -> dict[str, Any]:
        """Request a job to stop; finished results are kept."""
        mark(self._place(name) / CANCEL)
        self.read = 0.0
        return self.state(name)

    def again(self, name: str) -> AnyTask:
        """Return the request of a job, to run it again: a sweep resumes where it stopped."""
        from jounce.web.tasks import task_of

        task = task_of(self._job(name).asked or {})
        if hasattr(task, "resume") and self.state(name)["state"] != "done":
            return task.model_copy(update={"resume": True, "force": False})
        return task.model_copy(update={"force": True}) if hasattr(task, "force") else task

    def forget(self, name: str) -> None:
        """Remove a finished job from the list; files it wrote into the project are kept."""
        if self.state(name)["state"] in ("running", "cancelling"):
            raise OutputError("the job is still running", where=name, hint="Cancel the job first.")
        _remove(self._place(name))
        self.ended.pop(name, None)
        self.read = 0.0

    def page(self, name: str) -> Path | None:
        """Return the report that a job wrote, if any."""
        own = self._place(name) / "report.html"
        if is_regular(own):
            return own
        page = self.state(name).get("page")
        file = self.project.inside(str(page)) if page else None
        return file if file is not None and file.is_file() else None

    def _all(self) -> list[dict[str, Any]]:
        states: list[dict[str, Any]] = []
        for name in self._names()[:_MOST_LOOKED_AT]:
            with contextlib.suppress(DescriptionError, OutputError):  # not created by jounce
                states.append(self.state(name))
            if len(states) == _MOST_KEPT:
                break
        return states

    def _names(self) -> list[str]:
        """Return the names of potential job folders, highest number first."""
        try:
            with os.scandir(self.folder) as entries:
                names = [entry.name for entry in entries if _NAME.fullmatch(entry.name)]
        except (OSError, OutputError):  # no job was started yet, or it is not a folder
            return []
        return sorted(names, key=lambda name: (_number(name), name), reverse=True)

    def _forget_old(self) -> None:
        for job in self._all()[_MOST_KEPT // 2 :]:
            if job["state"] not in ("running", "cancelling"):
                with contextlib.suppress(OutputError):
                    _remove(self.folder / job["id"])
                self.ended.pop(job["id"], None)

    def _place(self, name: str) -> Path:
        if not _NAME.fullmatch(name) or not is_regular(self.project.own(PLACE, name) / JOB):
            raise DescriptionError("no such job", where="job", found=name)
        return self.folder / name

    def _job(self, name: str) -> _Job:
        job = _read_model(_Job, self._place(name) / JOB)
        if job is None:
            raise DescriptionError("no such job", where="job", found=name)
        return job

    def _lives(self, name: str, folder: Path) -> bool:
        process = self.processes.get(name)
        if process is not None:
            if process.poll() is None:
                return True
            self.processes.pop(name, None)  # a concurrent request may have removed it
            return False
        if is_regular(folder / ALIVE):
            return is_held(folder / ALIVE)
        return time.monotonic() - self.begun.get(name, -_JUST_BEGUN) < _JUST_BEGUN

    def _write_job(self, folder: Path, spec: JobSpec, task: AnyTask | None) -> Path:
        """Write the task of a job and the words of its command."""
        folder.mkdir(parents=True, mode=0o700)
        hidden = [word.replace("{folder}", str(folder)) for word in spec.hidden]
        about: dict[str, Any] = {
            "kind": task and task.kind,
            "asked": task and task.model_dump(),
            "title": spec.title,
        }
        about |= {
            "root": str(self.project.root),
            "begun": time.time(),
            "clock": time.monotonic(),
            "out": spec.out,
            "page": spec.page,
            **equivalents(spec),
        }
        does = (
            {"question": spec.question} if spec.question else {"words": spec.words, "own": hidden}
        )
        put(folder / JOB, about | does | {"limits": spec.limits})
        return folder


_LOST = "The process was killed, or the computer was shut down."


class Refused(JounceError):
    """Error reported by a command in another process, with its original text."""

    def __init__(self, error: Mapping[str, Any]) -> None:
        self.text = Translated(str(error["text"]), error.get("german"))
        words = {name: str(error.get(name) or "") for name in ("where", "allowed", "hint")}
        super().__init__(str(error.get("what") or self.text), found=error.get("found"), **words)

    def message(self, *, placed: bool = True, within: str = "") -> Phrase:  # noqa: ARG002 - the text is fixed
        """Return the original text."""
        return self.text


def equivalents(spec: JobSpec) -> dict[str, Any]:
    """Return equivalent Python code and command."""
    return {"python": spec.python, "command": command_line(["jounce", *spec.words]) if spec.words else spec.command,
            "files": spec.files}  # fmt: skip


def _start_process(folder: Path, *, waited: bool = False) -> subprocess.Popen[bytes]:
    """Start a process for the job of a folder, which outlives this one; it yields to the page unless the page waits."""
    with (folder / RESULT).open("wb") as out, (folder / PROBLEMS).open("wb") as problems:
        apart: dict[str, Any] = {"start_new_session": True}
        if sys.platform == "win32":
            behind = 0 if waited else subprocess.BELOW_NORMAL_PRIORITY_CLASS
            apart = {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP | behind}
        try:
            process = subprocess.Popen(
                [sys.executable, "-P", "-c", _CHILD, json.dumps(sys.path), str(folder), str(0 if waited else _BEHIND)],
                stdin=subprocess.DEVNULL, stdout=out, stderr=problems, env=os.environ | {"PYTHONUTF8": "1"}, **apart,
            )  # fmt: skip
        except OSError as error:
            what = f"no worker process could be started ({error.strerror or error})"
            raise OutputError(what, where="jobs", hint="Close other programs.") from None
    threading.Thread(target=process.wait, daemon=True).start()  # its exit is always collected
    return process


def _waiting() -> subprocess.Popen[bytes]:
    """Start a process that imports the modules of commands and then forks for each folder it receives."""
    threads = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
    return subprocess.Popen(
        [sys.executable, "-P", "-c", _WAITING, json.dumps(sys.path)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        env=os.environ | threads | {"PYTHONUTF8": "1"},
        start_new_session=True,
    )


def _is_over(folder: Path, patience: float, closing: threading.Event) -> bool:
    """Wait until the work on a folder has ended; ``False`` if it continues or the client has gone."""
    end, free = time.monotonic() + patience, 0
    while time.monotonic() < end:
        if (folder / END).exists():
            return True
        free = free + 1 if (folder / ALIVE).exists() and not is_held(folder / ALIVE) else 0
        if free > _FREE:  # longer than a starting process leaves it unlocked
            return True
        if closing.wait(_LOOKED / 5.0):
            break
    return False


_WAITING = """import json, pathlib, sys
sys.path[:] = json.loads(sys.argv[1])
from jounce.web.worker import split_when_told
split_when_told()"""
_CHILD = """import json, os, pathlib, sys
sys.path[:] = json.loads(sys.argv[1])
if hasattr(os, "nice"): os.nice(int(sys.argv[3]))
from jounce.web.worker import work
sys.exit(work(pathlib.Path(sys.argv[2])))"""


def _outcome(folder: Path, code: int | None) -> dict[str, Any]:
    """Return the outcome of a command from its exit code, and its error text."""
    try:
        said = content(folder / PROBLEMS, _LONGEST_RESULT).decode(errors="replace")
    except (OSError, ValueError):
        said = ""
    plain = _result(folder)
    own = plain.get("error") if isinstance(plain, Mapping) else None
    if code == 130:
        return {"state": "cancelled", "error": None}
    if isinstance(plain, Mapping) and code in (0, 1, 2) and set(plain) != {"error"}:
        return {
            "state": "done",
            "error": None,
        }  # with a nonzero exit code, the result contains what failed
    if isinstance(own, Mapping):
        return {
            "state": "failed",
            "error": {**own, "text": str(own.get("message", "")), **without_options(own)},
        }
    if code is None:
        return {"state": "stopped", "error": None}
    text = (
        said.strip().splitlines()[-1] if said.strip() else f"The process ended (exit code {code})."
    )
    return {"state": "failed", "error": {"text": text.removeprefix("jounce: "), "what": text}}


_ADVICE = {
    "the output already exists": "Choose another name.",
    "the output folder is not empty": "Choose another name, or restart the job to replace the existing output.",
}


def without_options(error: Mapping[str, Any]) -> dict[str, Any]:
    """Return an error message for the page if the original hint names a command-line option; otherwise empty."""
    if error.get("hint") != ALLOW_OVERWRITING:
        return {}
    what = error["what"]
    message = Message(what, where=error["where"] or "", hint=_ADVICE[what])
    return {"text": message, "german": message.german(), "hint": _ADVICE[what]}


def _number(name: str) -> int:
    return int(name.partition("-")[0])


def _remove(folder: Path) -> None:
    try:
        shutil.rmtree(folder)
    except (OSError, RecursionError) as error:
        hint = "Remove the folder by hand."
        raise OutputError(
            "the folder of the job cannot be removed", where=folder.name, hint=hint
        ) from error


def _read_model(kind: type[_Said], file: Path) -> _Said | None:
    """Read a file of a job; ``None`` if it is missing or invalid."""
    try:
        return kind.model_validate(plain_json(content(file, _LONGEST)))
    except (OSError, ValueError):  # includes pydantic's errors
        return None


def _result(folder: Path) -> Any:
    try:
        return plain_json(content(folder / RESULT, _LONGEST_RESULT))
    except (OSError, ValueError):
        return None
