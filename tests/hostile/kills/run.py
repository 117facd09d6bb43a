"""Kills commands at moments of their work and looks at what they leave: every file whole or absent, and nothing more.

Each moment is a round in a folder as it was before the work. A process forked from this one, in which everything is
imported already, does the work and is killed by SIGKILL: before its n-th step that changes a disk (a file opened for
writing, a rename, a folder made, a statement of SQL), n spread over all of them, or at a random time. Then another
one does the same work to its end. What may be there is what was there before, or what is there after undisturbed
work, byte for byte, and never some of both where files belong together.

    python run.py FOLDER KILLS SEED JOB...    folder that is empty, kills of each job; prints counts as JSON
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import random
import shutil
import signal
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import sqlalchemy

STEPS = {"os.rename", "os.remove", "os.mkdir", "os.rmdir", "os.link", "os.symlink", "os.chmod", "os.truncate"}
WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT
Listing = dict[str, bytes]


@dataclass
class Job:
    """Work in the folder that a process stands in; ``together`` are files that must not be some old and some new."""

    prepare: Callable[[], object]
    work: Callable[[], object]
    together: tuple[str, ...] = ()
    always: tuple[str, ...] = ()  # files that are never absent
    between: tuple[bytes, ...] = ()  # contents that are neither old nor new, and whole
    state: Callable[[Path], Listing] = field(default=lambda folder: listing(folder))  # noqa: PLW0108 - it is defined below


def listing(folder: Path) -> Listing:
    files = ((file, file.relative_to(folder)) for file in sorted(folder.rglob("*")) if file.is_file())
    own = ((file, name) for file, name in files if not any(part.startswith(".jounce-") for part in name.parts))
    return {str(name): file.read_bytes() for file, name in own}


def leftovers(*folders: Path) -> list[str]:
    return [str(file) for folder in folders for file in folder.rglob(".*")]


class Steps:
    """Counts the steps of this process that change a disk; kills it before the one that was chosen."""

    def __init__(self, last: int = 0) -> None:
        self.count, self.last = 0, last
        sys.addaudithook(self._look)
        for name in ("before_cursor_execute", "commit"):
            sqlalchemy.event.listen(sqlalchemy.Engine, name, lambda *_: self._step())

    def _look(self, event: str, arguments: tuple[Any, ...]) -> None:
        if event == "open":
            flags = arguments[2] if isinstance(arguments[2], int) else 0
            if flags & WRITING and str(arguments[0]) != os.devnull:
                self._step()
        elif event in STEPS:
            self._step()

    def _step(self) -> None:
        self.count += 1
        if self.count == self.last:
            os.kill(os.getpid(), signal.SIGKILL)


def forked(folder: Path, work: Callable[[], object], last: int = 0) -> int:
    """Start a process that works in a folder; it writes how many steps it took beside the folder."""
    child = os.fork()
    if child:
        return child
    code = 1
    try:
        os.chdir(folder)
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, 1)
        steps = Steps(last)
        work()
        count = steps.count
        folder.with_name("steps").write_text(str(count))
        code = 0
    except BaseException as error:  # noqa: BLE001 - told by the code
        sys.stderr.write(f"{type(error).__name__}: {error}\n")
    finally:
        os._exit(code)


def ended(child: int) -> int:
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def undisturbed(folder: Path, work: Callable[[], object]) -> None:
    code = ended(forked(folder, work))
    assert code == 0, f"undisturbed work failed: {code}"


def warmed(folder: Path, job: Job) -> None:
    """Do the work once here, so that nothing has to be imported or compiled at the moments."""
    from jounce.core import writing

    folder.mkdir()
    with contextlib.chdir(folder), Path(os.devnull).open("w") as nowhere, contextlib.redirect_stdout(nowhere):
        job.prepare()
        job.work()
    writing._sweep.cache_clear()


def check(job: Job, before: Listing, after: Listing, found: Listing) -> None:
    for name, content in found.items():
        known = [state[name] for state in (before, after) if name in state]
        assert content in [*known, *job.between], f"{name} is neither as before nor as after"
    lost = [name for name in ({*before} - {*after} | {*job.always}) if name not in found]
    assert not lost, f"lost: {lost}"
    changed = [name for name in job.together if name in found and before.get(name) != after.get(name)]
    assert len({found[name] == after[name] for name in changed}) < 2, f"a mixture of old and new: {changed}"


def run(job: Job, folder: Path, kills: int, rng: random.Random) -> dict[str, int]:
    base, here, temporary = folder / "base", folder / "here", Path(tempfile.gettempdir())
    base.mkdir()
    undisturbed(base, job.prepare)
    before = job.state(base)
    shutil.copytree(base, here)
    started = time.monotonic()
    undisturbed(here, job.work)
    longest, steps = time.monotonic() - started, int((folder / "steps").read_text())
    after = job.state(here)
    assert after != before, "the work changes nothing"
    seen = {"moments": 0, "kills": 0, "steps": steps, "unchanged": 0, "partly": 0, "done": 0}
    for k in range(kills):
        shutil.rmtree(here)
        shutil.copytree(base, here)
        by_step = k % 4 != 3
        child = forked(here, job.work, last=1 + int(steps * (k + rng.random()) / kills) if by_step else 0)
        if not by_step:
            time.sleep(rng.uniform(0.0, longest))
            with contextlib.suppress(ProcessLookupError):
                os.kill(child, signal.SIGKILL)
        code = ended(child)
        assert code in (0, -signal.SIGKILL), f"moment {k} of {steps}: {code}"
        found = job.state(here)
        check(job, before, after, found)
        seen["moments"] += 1
        seen["kills"] += code != 0
        seen["unchanged" if found == before else "done" if found == after else "partly"] += 1
        undisturbed(here, job.work)
        assert job.state(here) == after, f"moment {k} of {steps}: the same work again gives something else"
        left = leftovers(here, temporary)
        assert not left, f"moment {k} of {steps}: {left}"
    return seen


def jounce(*words: str) -> None:
    from jounce.cli import main

    code = main(list(words))
    assert code == 0, f"{words}: {code}"


def recording() -> Job:
    def prepare() -> None:
        rows = "".join(f"{k / 1000},{1e-3 * (k % 7)}\n" for k in range(300))
        Path("base.csv").write_text(f"time [s], road.z [m]\n{rows}", encoding="utf-8")
        Path("run.nc").write_bytes(b"mine")

    command = ("simulate", "kart-quarter-car", "--excitation", "base.csv", "--out", "run.nc", "--force")
    return Job(prepare, lambda: jounce(*command), always=("run.nc",))


def report() -> Job:
    from jounce.plots.style import new_figure
    from jounce.report import Page, Picture, Section, render, write_page

    def write(title: str) -> None:
        def page() -> Page:
            figure = new_figure(1.2)
            figure.subplots().plot([0.0, 1.0], [0.0, len(title)])
            picture = Picture(figure, "line", "A line.", "A line.")
            return Page(title, (Section("Line", (picture,)),))

        files: dict[str, str | bytes] = {f"{k}.json": title * 1000 * k for k in range(5)}
        write_page(page, "out", files=files, force=True)

    def prepare() -> None:
        write("old")
        Path("out", "notes.txt").write_text("mine")

    together = tuple(f"out/{k}.json" for k in range(1, 5))
    between = (render._NOT_YET.encode(),)
    return Job(prepare, lambda: write("another"), together=together, between=between)


def campaign() -> Job:
    from jounce.campaign import new_campaign, run
    from jounce.report import render

    folder = Path(tempfile.mkdtemp())
    file = new_campaign(folder / "mine")
    text = file.read_text(encoding="utf-8").split("[[trial]]")
    file.write_text("[[trial]]".join(text[:2]) + UPDATE, encoding="utf-8")
    result = run.run_campaign(file)  # what is computed changes no disk: once for all moments
    shutil.rmtree(folder)

    def work() -> None:
        import jounce.campaign

        jounce.campaign.run_campaign = lambda *_, **__: result
        Path("campaign.toml").touch()
        from jounce.cli import main

        assert main(["campaign", "run", "campaign.toml", "--out", "out", "--force"]) == 0

    return Job(lambda: Path("campaign.toml").touch(), work, between=(render._NOT_YET.encode(),))


UPDATE = """
[[update]]
name = "damping"
free = {"strut.damper.coefficient" = "50 %"}
method = "least-squares"
trials = [1]
"""


def records(folder: Path) -> Listing:
    """Records of the store by number: a hash of what was stored, and the verdict; looked at in a process of its own."""
    child = forked(folder, look)
    assert ended(child) == 0, "the store is damaged"
    answer: dict[str, str] = json.loads(folder.with_name("records").read_text())
    return {name: text.encode() for name, text in answer.items()}


def look() -> None:
    from jounce.inspection.archive.store import Store

    found = {}
    if Path("lane.sqlite").exists():
        store = Store("lane.sqlite", read_only=True)
        assert store.problems() == []
        for number in store.numbers():
            content = hashlib.sha256(store.content(number)[0]).hexdigest()
            found[f"{number}"] = f"{content} {store.newest_grading(number).verdict} {len(store.gradings(number))}"
        store.close()
    Path("../records").write_text(json.dumps(found))


def store() -> Job:
    def prepare() -> None:
        for k in range(3):
            rows = "\n".join(str(k * i) for i in range(50))
            Path(f"{k}.csv").write_text(f'# plate_number = "B {k}"\ntime [s], left.plate.z [mm]\n{rows}\n')

    def work() -> None:
        from jounce.cli import main

        main(["inspect", "import", "0.csv", "1.csv", "2.csv", "--store", "lane.sqlite"])

    return Job(prepare, work, state=records)


def cache() -> Job:
    import casadi as ca

    from jounce.kernel.native import compile_functions

    x, u, p, m = (ca.SX.sym(name, 1) for name in "xupm")

    def work() -> None:
        os.environ["JOUNCE_CACHE_DIR"] = str(Path("cache").absolute())
        for factor in (2.0, 3.0):
            compile_functions({"f": ca.Function("f", [x, u, p, m], [factor * x + u])})

    return Job(lambda: None, work)


JOBS: dict[str, Callable[[], Job]] = {
    "recording": recording,
    "report": report,
    "campaign": campaign,
    "store": store,
    "cache": cache,
}


def main(folder: Path, kills: int, seed: int, names: list[str]) -> dict[str, dict[str, int]]:
    (folder / "tmp").mkdir()
    tempfile.tempdir = str(folder / "tmp")
    os.environ.setdefault("JOUNCE_CACHE_DIR", str(folder / "code"))
    found = {}
    for name in names:
        (folder / name).mkdir()
        job = JOBS[name]()
        warmed(folder / name / "warm", job)
        found[name] = run(job, folder / name, kills, random.Random(f"{seed} {name}"))
    return found


if __name__ == "__main__":
    sys.stdout.write(json.dumps(main(Path(sys.argv[1]).absolute(), int(sys.argv[2]), int(sys.argv[3]), sys.argv[4:])))
