"""Lets the n-th operation on files of each writer go wrong, and looks at what is there then and what was said.

A writer is a command, or what a page of the workbench asks. A process forked from this one, in which everything is
imported and compiled already, does its work in a folder that holds what was there before; a library (``faults.c``)
counts the operations on files of that process and of all that it starts, and lets the n-th go wrong:

    kill     everything is killed before the operation           full     no space from there on; half of a write fits
    half     it is killed once half of a write is on the disk    once     no space for this operation only
    refused  an input/output error for this operation only

Then the work is done again, undisturbed. What may be there is what was there before or what is there after undisturbed
work, byte for byte; success may be said of the whole only.

    python tests/hostile/faults/run.py [--writers WORD...] [--most N] [--modes MODE...] [--list]
"""

from __future__ import annotations

import argparse
import atexit
import contextlib
import ctypes
import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from jounce.core.errors import JounceError

sys.path.insert(0, str(Path(__file__).parents[1]))
MODES = {"kill": 1, "half": 2, "full": 3, "once": 4, "refused": 5}
GROWS, WRITES = 1, 2  # kinds of operations, as faults.c has them
ALL, SAMPLE, LONG = (
    100,
    24,
    240,
)  # operations that are all tried, how many of more, s that work may take
Listing = dict[str, str]


class Seen(ctypes.Structure):
    _fields_ = (
        ("count", ctypes.c_long),
        ("hit", ctypes.c_long),
        ("code", ctypes.c_int),
        ("hung", ctypes.c_int),
    )


@dataclass
class Writer:
    """Work in the folder that a process stands in, after ``prepare``; gives an exit code and prints what it says."""

    name: str
    work: Callable[[], int]
    prepare: Callable[[], object] = lambda: None
    between: tuple[bytes, ...] = ()  # contents that are neither old nor new, and whole
    first: frozenset[str] = frozenset()  # files that are there together before the others
    parts: bool = False  # files that are whole each, and do not belong together
    optional: bool = False  # where it cannot be written, the work goes on
    again: Callable[[], int] | None = None


@dataclass
class Judged:
    faults: Counter[str] = field(default_factory=Counter)
    broken: list[str] = field(default_factory=list)


def library(folder: Path) -> ctypes.CDLL:
    made = folder / "faults.so"
    source = Path(__file__).with_name("faults.c")
    subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-o", str(made), str(source)], check=True)
    return ctypes.CDLL(str(made))


class Disk:
    """A folder in which work is done again and again, from the same state."""

    def __init__(self, folder: Path, faults: ctypes.CDLL) -> None:
        self.faults, self.base, self.here = faults, folder / "base", folder / "here"
        self.log, self.said = folder / "log", folder / "said"

    def reset(self) -> None:
        shutil.rmtree(self.here, ignore_errors=True)
        shutil.copytree(self.base, self.here, symlinks=True)

    def run(
        self, work: Callable[[], object], at: int = 0, mode: int = 0, *, armed: bool = True
    ) -> Seen:
        """Do work in a process of its own."""
        sys.stdout.flush()
        child = os.fork()
        if child == 0:
            _work(self, work, armed=armed)
        seen = Seen()
        if not armed:
            seen.code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
            return seen
        root, log = f"{self.here}/".encode(), str(self.log).encode()
        error = self.faults.watch(child, root, at, mode, LONG, log, ctypes.byref(seen))
        if error:
            raise OSError(error, "processes cannot be traced here")
        return seen

    def operations(self) -> list[tuple[str, int, str]]:
        rows = (
            line.split("\t")
            for line in self.log.read_text(errors="replace").splitlines()
            if line.count("\t") > 1
        )
        return [(row[0], int(row[1]), row[2]) for row in rows]

    def text(self) -> str:
        return self.said.read_text(encoding="utf-8", errors="replace")

    def listing(self) -> Listing:
        """Digests of the files by name; of a store its records."""
        found = {}
        for file in sorted((self.here / "work").rglob("*")):
            name = file.relative_to(self.here / "work")
            if (
                not file.is_file()
                or any(part.startswith(".jounce-") for part in name.parts)
                or _is_aside(file)
            ):
                continue
            if file.suffix == ".sqlite":
                seen = self.run(partial(_look, file, self.said), armed=False)
                found[str(name)] = self.text() if seen.code == 0 else f"damaged: {self.text()}"
            else:
                found[str(name)] = hashlib.sha256(file.read_bytes()).hexdigest()
        return found

    def leftovers(self) -> list[str]:
        left = [*(self.here / "tmp").iterdir(), *(self.here / "work").rglob(".jounce-*")]
        return sorted({str(file.relative_to(self.here)) for file in left})


def _is_aside(file: Path) -> bool:
    """SQLite's own files beside a store, and what is only held."""
    return file.name.endswith(("-wal", "-shm", "-journal")) or file.name in ("alive",)


def _work(disk: Disk, work: Callable[[], object], *, armed: bool) -> None:
    """The child: like a process that was started for this work alone, up to its end."""
    code = 1
    try:
        os.chdir(disk.here / "work")
        tempfile.tempdir = os.environ["TMPDIR"] = str(disk.here / "tmp")
        said = os.open(disk.said, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(said, 1)
        os.dup2(said, 2)
        sys.stdout, sys.stderr = (open(stream, "w", closefd=False) for stream in (1, 2))  # noqa: SIM115
        time.time, time.time_ns = (lambda: 1.8e9), (lambda: 1_800_000_000_000_000_000)
        time.asctime = lambda *_: ""  # which SciPy writes into files
        if armed and (error := disk.faults.arm()):
            raise OSError(error, "cannot be traced")
        code = work() or 0  # type: ignore[assignment]
    except SystemExit as ended:
        code = int(ended.code or 0)
    except JounceError as error:
        sys.stderr.write(f"jounce: {error}\n")
        code = 2
    except BaseException as error:  # noqa: BLE001 - told by the code
        sys.stderr.write(f"Traceback: {type(error).__name__}: {error}\n")
    finally:
        with contextlib.suppress(BaseException):
            atexit._run_exitfuncs()
        with contextlib.suppress(BaseException):
            sys.stdout.flush()
            sys.stderr.flush()
        os._exit(code)


def _look(file: Path, said: Path) -> None:
    from jounce.inspection.archive.store import Store

    store = Store(file, read_only=True)
    found = [str(problem) for problem in store.problems()]
    for number in store.numbers():
        content, grading = (
            hashlib.sha256(store.content(number)[0]).hexdigest(),
            store.newest_grading(number),
        )
        found.append(
            f"{content} {grading and grading.verdict} {grading and grading.result.get('reasons')}"
        )
    store.close()
    sys.stdout.write(
        "\n".join(sorted(found))
    )  # a record that was left out for once gets a later number


def _settle() -> None:
    """What the next command that writes there does first."""
    from jounce.core import writing

    for folder in {Path(), *(one.parent for one in Path().rglob(".jounce-*"))}:
        writing._sweep.__wrapped__(folder)


def _quietly(disk: Disk, work: Callable[[], object]) -> None:
    """Do work in this process, so that nothing has to be imported or compiled later."""
    before, tempfile.tempdir = tempfile.tempdir, str(disk.here / "tmp")
    with (
        contextlib.chdir(disk.here / "work"),
        disk.said.open("w") as said,
        contextlib.redirect_stdout(said),
        contextlib.redirect_stderr(said),
    ):
        work()
    tempfile.tempdir = before


def try_writer(
    writer: Writer, folder: Path, faults: ctypes.CDLL, modes: list[str], most: int
) -> Judged:
    from jounce.core import writing

    disk = Disk(folder, faults)
    for name in ("work", "tmp"):
        (disk.here / name).mkdir(parents=True)
    _quietly(disk, writer.prepare)
    disk.here.rename(disk.base)
    disk.reset()
    _quietly(disk, writer.work)
    disk.reset()
    writing._sweep.cache_clear()
    before = disk.listing()
    seen = disk.run(writer.work)
    assert seen.code in (0, 1), f"{writer.name}: undisturbed work failed: {disk.text()}"
    good, operations = seen.code, disk.operations()
    after = disk.listing()
    assert not disk.leftovers(), disk.leftovers()
    again = writer.again or writer.work
    disk.reset()
    time.sleep(1.1)  # some files tell when they were written, to the second
    disk.run(writer.work)
    varied = {name for name, digest in disk.listing().items() if after.get(name) != digest}
    judged = Judged()
    assert operations, f"{writer.name}: writes nothing"
    judged.faults["operations"] = len(operations)
    if varied:
        print(f"  differs by itself: {sorted(varied)}")
    count = len(operations)
    chosen = range(1, count + 1) if count <= min(ALL, most) else sorted(
        {1 + round(k * (count - 1) / (min(SAMPLE, most) - 1)) for k in range(min(SAMPLE, most))})  # fmt: skip
    for mode in modes:
        for at in chosen:
            kind = operations[at - 1][1]
            if (mode == "half" and not kind & WRITES) or (
                mode in ("full", "once") and not kind & GROWS
            ):
                continue
            disk.reset()
            seen = disk.run(writer.work, at, MODES[mode])
            if not seen.hit:
                continue
            judged.faults[mode] += 1
            said, hit = disk.text(), " ".join(map(str, disk.operations()[at - 1]))
            killed = mode in ("kill", "half")
            wrong = _said_wrong(seen, said, good, killed=killed)
            if (
                killed or mode == "full"
            ):  # where nothing can be moved back either, the next process does it
                disk.run(_settle, armed=False)
            found = disk.listing()
            wrong += _wrong(writer, before, after, found, varied)
            if seen.code == good and not killed and not writer.optional:
                bad = [
                    name
                    for name in {*after} | {*found}
                    if name not in varied and found.get(name) != after.get(name)
                ]
                wrong += [f"success told, but not whole: {bad}"] if bad else []
            repeated = disk.run(again, armed=False)
            there = any(
                text in disk.text()
                for text in ("output already exists", "file exists", "not empty")
            )  # whole already
            if repeated.code != good and not (not _differing(after, found, varied) and there):
                wrong.append(f"again: {repeated.code} {disk.text().strip()[:200]}")
            bad = _differing(after, disk.listing(), varied)
            wrong += [f"again gives something else: {bad} {disk.text()[:200]}"] if bad else []
            left = disk.leftovers()
            wrong += [f"left: {left}"] if left else []
            if wrong:
                first = said.strip().replace("\n", " ")[-160:]
                judged.broken.append(
                    f"{writer.name}: {mode} {at}/{count} ({hit}): {'; '.join(wrong)} | {seen.code} {first}"
                )
    shutil.rmtree(folder, ignore_errors=True)
    return judged


def _differing(after: Listing, found: Listing, varied: set[str]) -> list[str]:
    return sorted(
        name for name in ({*after} | {*found}) - varied if found.get(name) != after.get(name)
    )


def _said_wrong(seen: Seen, said: str, good: int, *, killed: bool) -> list[str]:
    if seen.hung:
        return ["hung"]
    if killed:
        return [] if seen.code == -9 else [f"killed, and ended with {seen.code}"]
    if "internal error" in said or "Traceback" in said or seen.code not in (0, 1, 2):
        return [f"unclear ({seen.code})"]
    if seen.code == 2 and "jounce: " not in said:
        return ["nothing told"]
    return []


def _wrong(
    writer: Writer, before: Listing, after: Listing, found: Listing, varied: set[str]
) -> list[str]:
    between = {hashlib.sha256(content).hexdigest() for content in writer.between}
    wrong = []
    for name, digest in found.items():
        if name.endswith(".sqlite") and {*digest.splitlines()} <= {*after[name].splitlines()}:
            continue  # some of the records
        if name not in varied and digest not in {before.get(name), after.get(name)} | between:
            wrong.append(f"half: {name} {digest if digest.startswith('damaged') else ''}")
    lost = [name for name in before if name in after and name not in found]
    wrong += [f"lost: {lost}"] if lost else []
    changed = [
        name
        for name in {*before} | {*after}
        if before.get(name) != after.get(name) and name not in varied
    ]
    is_new = {
        found.get(name) == after.get(name) for name in changed if found.get(name) not in between
    }
    new = {name for name in changed if found.get(name) == after.get(name)}
    if len(is_new) > 1 and new != writer.first and not (writer.parts or writer.optional):
        wrong.append(f"a mixture: {sorted(new)} are new")
    return wrong


def main() -> int:
    asked = argparse.ArgumentParser()
    asked.add_argument("--writers", nargs="*", default=[])
    asked.add_argument("--most", type=int, default=ALL)
    asked.add_argument("--modes", nargs="*", default=list(MODES), choices=list(MODES))
    asked.add_argument("--list", action="store_true")
    given = asked.parse_args()
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    sys.dont_write_bytecode = True
    from faults.writers import writers

    folder = Path(tempfile.mkdtemp(prefix="jounce-faults-"))  # not one that goes as a child ends
    try:
        os.chdir(folder)
        os.environ.setdefault("JOUNCE_CACHE_DIR", str(folder / "code"))
        os.environ["JOUNCE_FAULTS"] = str(folder / "files")
        totals, broken, tried = Counter[str](), 0, 0
        faults = library(folder)
        for writer in writers():
            if given.writers and not any(word in writer.name for word in given.writers):
                continue
            if given.list:
                print(writer.name)
                continue
            begun = time.monotonic()
            own = folder / "own"
            own.mkdir()
            try:
                judged = try_writer(writer, own, faults, given.modes, given.most)
            except AssertionError as error:
                print(f"{writer.name}: cannot be tried: {error}", flush=True)
                os.chdir(folder)
                shutil.rmtree(own)
                continue
            os.chdir(folder)
            tried += 1
            totals += judged.faults
            broken += len(judged.broken)
            counts = " ".join(
                f"{mode} {judged.faults[mode]}" for mode in ("operations", *given.modes)
            )
            print(
                f"{writer.name}: {counts} broken {len(judged.broken)} ({time.monotonic() - begun:.0f} s)",
                flush=True,
            )
            for line in judged.broken:
                print(f"  {line}", flush=True)
        hit = sum(totals[mode] for mode in given.modes)
        print(json.dumps({"writers": tried, "faults": hit, **totals, "broken": broken}))
    finally:
        os.chdir("/")
        shutil.rmtree(folder, ignore_errors=True)
    return int(broken > 0)


if __name__ == "__main__":
    raise SystemExit(main())
