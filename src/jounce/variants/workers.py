"""Execution of the shards of a sweep: in this process, in local processes, or on a cluster."""

from __future__ import annotations

import itertools
import logging
import multiprocessing
import multiprocessing.connection
import os
import pickle
import signal
import sys
import threading
from collections.abc import Generator, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module, metadata
from typing import Any

from jounce.core.errors import JounceError, value_or_kind
from jounce.core.optional import require
from jounce.core.phrases import Phrase
from jounce.core.process_settings import PROCESS_SETTINGS
from jounce.core.processes import NoWorkersError, starting_workers
from jounce.core.trust import trust_said, trusting
from jounce.core.types import Array
from jounce.recordings.writers import netcdf_of
from jounce.variants.many import VariantWork

Results = Generator[tuple[int, bytes], None, None]
_LOG = logging.getLogger("jounce")
_WAITING = 2  # tasks queued per worker: enough to keep it busy, few enough to limit memory
_PATIENCE, _JOINING = 10.0, 30.0  # s: for a scheduler to answer, for a first worker to join
_MOST_ENDS = 3  # number of times that workers may be killed before a result arrives


@dataclass(frozen=True)
class Task:
    """The variants of one shard.

    Attributes
    ----------
    number : int
        Number of the shard.
    first : int
        Number of its first variant.
    columns : mapping
        Path of a parameter to its value (SI) in each variant.
    version : str
        Version of jounce that must compute all results.
    """

    number: int
    first: int
    columns: Mapping[str, Array]
    version: str


def shard_of(work: VariantWork, task: Task, threads: int | None) -> bytes:
    """Run the variants of a task; return the content of their shard."""
    shard = work.run(task.columns, first=task.first, threads=threads)
    with own_locks():
        return netcdf_of(shard)


@contextmanager
def own_locks() -> Iterator[None]:
    """Prevent xarray from requesting locks of in-memory data from the cluster of this process."""
    if sys.modules.get("dask") is None:
        yield
        return
    dask = import_module("dask")  # waits if another thread is still importing it

    with PROCESS_SETTINGS, dask.config.set(scheduler="synchronous"):
        yield


def here(work: VariantWork, tasks: Sequence[Task], threads: int | None) -> Results:
    """Yield number and content of every shard, computed in this process."""
    for task in tasks:
        yield task.number, shard_of(work, task, threads)


def on_processes(workers: int, work: VariantWork, tasks: Sequence[Task]) -> Results:
    """Yield number and content of shards as processes finish them; a killed process is replaced."""
    packed, left, ends = _pack(work), {task.number: task for task in tasks}, 0
    while left:
        try:
            for number, content in _run_pool(workers, packed, list(left.values())):
                del left[number]
                ends = 0
                yield number, content
        except NoWorkersError as error:
            _LOG.warning("%s This process works alone.", error)
            yield from here(work, list(left.values()), None)
            return
        except BrokenProcessPool:
            ends += 1
            if ends >= _MOST_ENDS:
                raise JounceError(
                    "a worker process was repeatedly killed from outside",
                    found=f"{ends} times in a row, {len(left)} shards left",
                    hint=(
                        "Check the memory and the process limit (ulimit -u). Finished results are kept: resume "
                        "with fewer workers."
                    ),
                ) from None


def _run_pool(workers: int, packed: bytes, tasks: Sequence[Task]) -> Results:
    others = set(multiprocessing.active_children())
    with starting_workers():
        pool = ProcessPoolExecutor(
            workers, mp_context=multiprocessing.get_context("spawn"), initializer=_begin
        )
    waiting: set[Future[tuple[int, bytes]]] = set()
    pending = iter(tasks)
    is_done = False
    try:
        while True:
            for task in pending:
                with starting_workers():
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
        if not is_done:  # do not wait for results that would be discarded
            for process in set(multiprocessing.active_children()) - others:
                process.terminate()
        with suppress(RuntimeError):  # raised by a pool that could not start its thread
            pool.shutdown(cancel_futures=True)


def _begin() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent process decides when to stop
    threading.Thread(target=_end_with_the_first, name="jounce watches", daemon=True).start()


def _end_with_the_first() -> None:
    """Exit with the parent process: if it is killed, nothing collects the results."""
    first = multiprocessing.parent_process()
    if first is not None:
        multiprocessing.connection.wait([first.sentinel])
        os._exit(1)


_ONE_AT_A_TIME = threading.Lock()
"""Workers of a cluster may have several threads, but a compiled model has one set of work arrays per process."""


def work_on(packed: bytes, task: Task) -> tuple[int, bytes]:
    """Work on a task in another process, on one of its threads."""
    own = metadata.version("jounce")
    if own != task.version:
        raise JounceError(
            "a worker has a different version of jounce", found=own, allowed=task.version
        )
    trust, work = _unpack(packed)
    with _ONE_AT_A_TIME, trusting(trust):
        return task.number, shard_of(work, task, 1)


def _pack(work: VariantWork) -> bytes:
    """Pack the input of all tasks, and the user's choice whether FMUs may run in the worker's own process."""
    return pickle.dumps((trust_said(), work))


@lru_cache(maxsize=2)
def _unpack(packed: bytes) -> tuple[bool | None, VariantWork]:
    result: tuple[bool | None, VariantWork] = pickle.loads(packed)
    return result


@contextmanager
def cluster_at(address: str) -> Iterator[Any]:
    """Yield a client of the Dask scheduler at an address; raise an error if unreachable or if versions differ."""
    distributed = require("distributed", "cluster")
    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # jounce reports errors once
    hint = (
        "Start a scheduler with: dask scheduler, and on each machine: dask worker ADDRESS "
        "--nworkers auto --nthreads 1"
    )
    try:
        client = distributed.Client(address, timeout=_PATIENCE, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        cause = " ".join(str(error).split()) or type(error).__name__
        raise JounceError(
            "the scheduler does not answer", where=address, found=cause, hint=hint
        ) from None
    with client:
        yield client


def check_cluster(client: Any) -> None:
    """Raise an error for a cluster without workers, or with versions of packages that could change results."""
    distributed = require("distributed", "cluster")
    if not hasattr(client, "scheduler"):
        raise JounceError(
            Phrase("{client} is not a cluster", client=value_or_kind(client)),
            where="client",
            allowed="a dask.distributed.Client",
        )
    where = str(getattr(client.scheduler, "address", "client"))
    try:
        client.wait_for_workers(1, timeout=_JOINING)
    except (TimeoutError, distributed.TimeoutError):
        hint: str = Phrase(
            "Start workers: dask worker {where} --nworkers auto --nthreads 1", where=where
        )
        raise JounceError("no worker has joined the cluster", where=where, hint=hint) from None
    own = _versions()
    try:
        others = client.run(_versions)
    except ModuleNotFoundError as error:
        raise _not_there(error) from None
    for worker, versions in others.items():
        differs = {
            name: f"{version} there, {own[name]} here"
            for name, version in versions.items()
            if version != own[name]
        }
        if differs:
            differences = "; ".join(f"{name} {words}" for name, words in differs.items())
            hint = "Install the same versions on all machines."
            raise JounceError(
                "a worker has different versions", where=str(worker), found=differences, hint=hint
            )


def _versions() -> dict[str, str]:
    """Versions of packages that determine the results or the communication of processes."""
    own = {name: metadata.version(name) for name in ("jounce", "numpy", "distributed")}
    return {"python": f"{sys.version_info.major}.{sys.version_info.minor}", **own}


def _not_there(error: ModuleNotFoundError) -> JounceError:
    return JounceError(
        "a package is missing on a worker", found=error.name, hint="Install jounce on all machines."
    )


def on_cluster(client: Any, work: VariantWork, tasks: Sequence[Task]) -> Results:
    """Yield number and content of shards as the workers of a Dask cluster finish them; lost workers are replaced."""
    distributed = require("distributed", "cluster")
    check_cluster(client)
    packed, pending = _pack(work), iter(tasks)
    following = distributed.as_completed(loop=client.loop, with_results=True)
    waiting: set[Any] = set()

    def submit() -> None:
        """Submit enough tasks for every available worker."""
        most = max(_WAITING * len(client.scheduler_info(n_workers=-1)["workers"]), 1)
        for task in itertools.islice(pending, max(most - len(waiting), 0)):
            future = client.submit(work_on, packed, task, pure=False)
            waiting.add(future)
            following.add(future)

    try:
        submit()
        for future, result in following:
            waiting.discard(future)
            if isinstance(result, BaseException):  # the worker reports lost tasks this way
                raise result
            yield result
            submit()
    except ModuleNotFoundError as error:
        raise _not_there(error) from None
    except distributed.KilledWorker as error:
        hint = "Check the memory. Finished results are kept: resume the sweep."
        raise JounceError("workers were repeatedly killed", found=str(error), hint=hint) from None
    except (distributed.comm.CommClosedError, distributed.CancelledError):
        raise JounceError(
            "the scheduler is no longer reachable",
            hint="Finished results are kept: resume the sweep.",
        ) from None
    finally:
        with suppress(Exception):  # the scheduler may be gone
            client.cancel(list(waiting))
