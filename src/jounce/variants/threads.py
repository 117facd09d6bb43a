"""Worker threads that share work and stay alive for a while to receive more.

Starting and ending a thread takes as long as a hundred variants of a small model.
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
    """Return the number of processors available to this process, considering its CPU affinity.

    A CPU time limit of a container counts as the equivalent number of processors.

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
    """Return the CPU time per elapsed time allowed by the control groups of this process; infinite without a limit.

    For cgroup version 2: ``cpu.max`` has quota and period, for the group and its ancestors.
    """
    try:
        line = next(line for line in own.read_bytes().splitlines() if line.startswith(b"0::"))
    except (OSError, StopIteration):
        return math.inf
    path = os.fsdecode(line.removeprefix(b"0::/"))  # group names may be any bytes
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

    ``take`` is called once in each thread. If one fails, the remaining items are dropped, and its error is raised when
    all threads are done. This thread calls ``meanwhile`` while the others wake up.

    >>> found = []
    >>> share(range(4), lambda some: found.extend(i * i for i in some), 2)
    >>> sorted(found)
    [0, 1, 4, 9]
    """
    left = iter(list(items))  # threads can take its items without a lock
    done: SimpleQueue[BaseException | None] = SimpleQueue()

    def work() -> None:
        error: BaseException | None = None
        try:
            take(left)
        except BaseException as problem:  # noqa: BLE001 - raised again by the caller
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
        list(left)  # an interrupt while waiting also drops the remaining items
    for error in errors:
        if error is not None:
            raise error


def _hand_over(job: _Job) -> None:
    """Pass a job to a waiting thread, or to a new one."""
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
            except ValueError:  # another thread has just taken it: a job will arrive
                continue
            return
        job()
        del job  # and everything it references
        _free.append(jobs)
