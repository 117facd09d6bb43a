"""Threads that share work, and wait a while for more.

To start a thread and to see it off takes as long as it works on a hundred variants of a small model.
"""

from __future__ import annotations

import contextlib
import math
import os
import threading
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import TypeVar

Item = TypeVar("Item")
_Job = Callable[[], None]
_WAITS = 0.5  # s that an idle thread waits for more work
_free: list[SimpleQueue[_Job]] = []  # job queue of each idle thread
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_free.clear)  # a fork has no other threads


def processors() -> int:
    """Number of processors that this process may use: those of the machine, or fewer if it is bound to fewer.

    A container that may use as much time as some processors have counts as these.

    >>> processors() >= 1
    True
    """
    there = (
        len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    )
    return max(1, math.ceil(min(there, time_share())))


@cache
def time_share(
    groups: Path = Path("/sys/fs/cgroup"), own: Path = Path("/proc/self/cgroup")
) -> float:
    """Processor time per time that the control groups of this process allow; infinite without a limit.

    That of version 2: ``cpu.max`` has the time and the period in which it may be used, for the group and those above.
    """
    try:
        line = next(line for line in own.read_bytes().splitlines() if line.startswith(b"0::"))
    except (OSError, StopIteration):
        return math.inf
    path = os.fsdecode(line.removeprefix(b"0::/"))  # any bytes: names of groups need not be text
    least = math.inf
    for folder in (groups / path, *(groups / path).parents):
        with contextlib.suppress(OSError, ValueError):  # no limit here, or "max"
            most, period = map(int, (folder / "cpu.max").read_text().split())
            least = min(least, most / period)
    return least


def share(
    items: Iterable[Item],
    take: Callable[[Iterator[Item]], None],
    workers: int,
    meanwhile: Callable[[], object] | None = None,
) -> None:
    """Let threads, including this one, take items from one iterator until it is exhausted.

    ``take`` is called once in each of them. Where one fails, it leaves nothing to the others, and its error is raised
    when all are done. This thread does ``meanwhile`` while the others wake up.

    >>> found = []
    >>> share(range(4), lambda some: found.extend(i * i for i in some), 2)
    >>> sorted(found)
    [0, 1, 4, 9]
    """
    left = iter(list(items))  # whose items threads may take without a lock
    done: SimpleQueue[BaseException | None] = SimpleQueue()

    def work() -> None:
        error: BaseException | None = None
        try:
            take(left)
        except BaseException as problem:  # noqa: BLE001 - raised by who asked for it
            error = problem
            list(left)
        done.put(error)

    others = 0
    with contextlib.suppress(
        RuntimeError
    ):  # no more threads available: the existing ones do the work
        while others < workers - 1:
            _hand_over(work)
            others += 1
    try:
        if meanwhile is not None:
            meanwhile()
        work()
        errors = [done.get() for _ in range(others + 1)]
    finally:
        list(left)  # an interrupt while waiting also leaves nothing to the others
    for error in errors:
        if error is not None:
            raise error


def _hand_over(job: _Job) -> None:
    """Return a job to a thread that waits for one, or to a new one."""
    try:
        jobs = _free.pop()
    except IndexError:
        jobs = SimpleQueue()
        threading.Thread(target=_live, args=(jobs,), name="jounce works", daemon=True).start()
    jobs.put(job)


def _live(jobs: SimpleQueue[_Job]) -> None:
    while True:
        try:
            job = jobs.get(timeout=_WAITS)
        except Empty:
            try:
                _free.remove(jobs)
            except ValueError:  # another thread has just taken it: the job is on its way
                continue
            return
        job()
        del job  # and all that it holds
        _free.append(jobs)
