"""Who works on the shards of a sweep: this process, processes of this machine, or a cluster."""

from __future__ import annotations

import multiprocessing
import pickle
import signal
from collections.abc import Generator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from functools import lru_cache
from importlib import metadata
from typing import TYPE_CHECKING, Any

from jounce.core.errors import JounceError
from jounce.core.optional import require
from jounce.core.types import Array

if TYPE_CHECKING:
    from jounce.variants.many import Work

Results = Generator[tuple[int, bytes], None, None]
_WAITING = 2  # tasks each worker has before it: enough never to stand idle, few enough for memory
_MOST_ENDS = 3  # how often workers may be ended from outside before anything more is done


@dataclass(frozen=True)
class Task:
    """The variants of one shard.

    Attributes
    ----------
    number : int
        Of the shard.
    first : int
        Number of its first variant.
    columns : mapping
        Path of a number to its value (SI) in each variant.
    version : str
        That of jounce which all results are to come from.
    """

    number: int
    first: int
    columns: Mapping[str, Array]
    version: str


def here(work: Work, tasks: Sequence[Task], threads: int | None) -> Results:
    """Give number and content of every shard, worked on in this process."""
    from jounce.variants.shards import shard_of

    for task in tasks:
        yield task.number, shard_of(work, task, threads)


def on_processes(workers: int, work: Work, tasks: Sequence[Task]) -> Results:
    """Give number and content of shards as processes finish them; one that is ended from outside is replaced."""
    packed, left, ends = pickle.dumps(work), {task.number: task for task in tasks}, 0
    while left:
        try:
            for number, content in _pooled(workers, packed, list(left.values())):
                del left[number]
                ends = 0
                yield number, content
        except BrokenProcessPool:
            ends += 1
            if ends >= _MOST_ENDS:
                raise JounceError(
                    "a worker process was ended from outside, again and again",
                    found=f"{ends} times in a row, {len(left)} shards left",
                    hint="Is there memory enough? What was done is kept: resume with fewer workers.",
                ) from None


def _pooled(workers: int, packed: bytes, tasks: Sequence[Task]) -> Results:
    others = set(multiprocessing.active_children())
    pool = ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn"), initializer=_begin)
    waiting: set[Future[tuple[int, bytes]]] = set()
    pending = iter(tasks)
    is_done = False
    try:
        while True:
            for task in pending:
                waiting.add(pool.submit(work_on, packed, task))
                if len(waiting) >= _WAITING * workers:
                    break
            if not waiting:
                is_done = True
                return
            done, waiting = wait(waiting, return_when=FIRST_COMPLETED)
            for future in done:
                yield future.result()
    finally:
        if not is_done:  # nobody waits for what would be thrown away
            for process in set(multiprocessing.active_children()) - others:
                process.terminate()
        pool.shutdown(cancel_futures=True)


def _begin() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the first process tells when to stop


def work_on(packed: bytes, task: Task) -> tuple[int, bytes]:
    """Work on a task in another process, on one of its threads."""
    from jounce.variants.shards import shard_of

    own = metadata.version("jounce")
    if own != task.version:
        raise JounceError("a worker has another version of jounce", found=own, allowed=task.version)
    return task.number, shard_of(_unpacked(packed), task, 1)


@lru_cache(maxsize=2)
def _unpacked(packed: bytes) -> Work:
    found: Work = pickle.loads(packed)
    return found


def on_cluster(client: Any, work: Work, tasks: Sequence[Task]) -> Results:
    """Give number and content of shards as the workers of a Dask cluster finish them; who vanishes is replaced."""
    distributed = require("distributed", "cluster")
    packed, pending = pickle.dumps(work), iter(tasks)
    following, waiting = distributed.as_completed(with_results=True), set()
    window = max(_WAITING * len(client.scheduler_info()["workers"]), 1)

    def submit(most: int) -> None:
        for _, task in zip(range(most), pending, strict=False):
            future = client.submit(work_on, packed, task, pure=False)
            waiting.add(future)
            following.add(future)

    try:
        submit(window)
        for future, (number, content) in following:
            waiting.discard(future)
            yield number, content
            submit(1)
    finally:
        client.cancel(list(waiting))
