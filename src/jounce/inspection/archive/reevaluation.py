"""Re-evaluation of all stored records in parallel processes."""

from __future__ import annotations

import os
import signal
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from jounce.core.errors import (
    JounceError,
    RecordingError,
    ResourceError,
    is_of_system,
    resource_error,
)
from jounce.core.processes import check_workers, starting_workers
from jounce.core.serialise import to_plain
from jounce.inspection.archive.entries import Grading, RecordEntry, unpack
from jounce.inspection.archive.lane import (
    grading_of,
    inspect_record,
    read_entry,
    refusal_of,
    stored_tester,
)
from jounce.inspection.archive.store import Store
from jounce.inspection.limits import Limits, load_limits
from jounce.parts.files import rig_from_table

if TYPE_CHECKING:
    import xarray as xr

    from jounce.core.findings import Finding
    from jounce.parts.testers import Tester

_BATCH = 20  # records per batch: larger batches reduce overhead, smaller ones balance the load
_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")


@dataclass(frozen=True)
class Reevaluation:
    """Outcome of the re-evaluation of all records."""

    records: int
    added: int = 0  # new gradings
    unchanged: int = (
        0  # records whose newest grading is already identical, with the same limits and software
    )
    # number of verdicts by old and new value
    changes: Mapping[tuple[str, str], int] = field(default_factory=dict)
    changed: tuple[int, ...] = ()  # numbers of these records
    # records that could not be read, with the reason; their gradings are kept
    failed: Mapping[int, str] = field(default_factory=dict)


@dataclass(frozen=True)
class _Outcome:
    number: int
    before: str = ""
    grading: Grading | None = None
    problem: str = ""


def reevaluate(
    store: Store,
    limits: Limits | None = None,
    *,
    tester: Tester | None = None,
    workers: int = 2,
    from_files: bool = False,
    say: Callable[[int, int], None] | None = None,
) -> Reevaluation:
    """Evaluate and grade all stored records again, adding new gradings to the existing ones.

    Gradings are stored in batches, so completed work is kept after an interruption. ``tester`` applies to records with
    an unknown tester. With ``workers`` (processes) 1 the work is done in this process. ``from_files`` reads the
    original files again instead of the stored signals. ``say`` is called with the completed and total counts.
    """
    numbers = store.numbers()
    task = _Reevaluation(
        store.address, limits if limits is not None else load_limits(), tester, from_files
    )
    batches = [numbers[start : start + _BATCH] for start in range(0, len(numbers), _BATCH)]
    added, done, changed = 0, 0, []
    changes: Counter[tuple[str, str]] = Counter()
    failed: dict[int, str] = {}
    with _results(task, batches, min(workers, len(batches))) as results:
        for batch in results:
            new = [
                (outcome.number, outcome.grading)
                for outcome in batch
                if outcome.grading is not None
            ]
            store.add_gradings(new)
            added, done = added + len(new), done + len(batch)
            failed |= {outcome.number: outcome.problem for outcome in batch if outcome.problem}
            for outcome in batch:
                if outcome.grading is not None and outcome.grading.verdict != outcome.before:
                    changes[outcome.before, outcome.grading.verdict] += 1
                    changed.append(outcome.number)
            if say is not None:
                say(done, len(numbers))
    same = len(numbers) - added - len(failed)
    return Reevaluation(len(numbers), added, same, dict(changes), tuple(changed), failed)


@dataclass(frozen=True)
class _Reevaluation:
    address: str
    limits: Limits
    tester: Tester | None
    from_files: bool


@contextmanager
def _results(
    task: _Reevaluation, batches: list[list[int]], workers: int
) -> Iterator[Iterable[list[_Outcome]]]:
    """Yield the outcomes of the batches in order as they are completed."""
    if workers <= 1:
        store = Store(task.address, read_only=True)
        yield (_work_on(store, task, batch) for batch in batches)
        store.close()
        return
    check_workers()
    import multiprocessing

    context = multiprocessing.get_context("spawn")
    with _one_thread_each():
        with starting_workers():
            pool = ProcessPoolExecutor(
                workers, mp_context=context, initializer=_begin, initargs=(task,)
            )
        try:
            with starting_workers():
                results = pool.map(_work, batches)
            yield results
        except BrokenProcessPool:
            raise ResourceError(
                "a process was terminated externally",
                hint="Completed work is stored; run the command again to continue.",
            ) from None
        finally:
            pool.shutdown(cancel_futures=True)


@contextmanager
def _one_thread_each() -> Iterator[None]:
    """Limit each process started in this context to one core."""
    before = {name: os.environ.get(name) for name in _THREADS}
    os.environ.update(dict.fromkeys(_THREADS, "1"))
    try:
        yield
    finally:
        for name, value in before.items():
            if value is None:
                del os.environ[name]
            else:
                os.environ[name] = value


_open: dict[str, Any] = {}


def _begin(task: _Reevaluation) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # only the main process handles interrupts
    _open.update(task=task, store=Store(task.address, read_only=True))


def _work(batch: list[int]) -> list[_Outcome]:
    return _work_on(_open["store"], _open["task"], batch)


def _work_on(store: Store, task: _Reevaluation, batch: list[int]) -> list[_Outcome]:
    return [_reevaluate_record(store, task, number) for number in batch]


def _reevaluate_record(store: Store, task: _Reevaluation, number: int) -> _Outcome:
    """Evaluate one record again; a failure does not stop the others."""
    try:
        newest = store.newest_grading(number)
        entry = store.entry(number)
    except RecordingError as error:
        return _Outcome(number, problem=error.message())
    before = "" if newest is None else newest.verdict
    try:
        tester = (
            task.tester
            if entry.tester_table is None and task.tester is not None
            else stored_tester(entry)
        )
        read = stored_signals(store, number, entry, tester, from_files=task.from_files)
        inspection = inspect_record(
            entry.name, tester, stored_vehicle(entry), entry.methods or None, task.limits, read=read
        )
        grading = grading_of(inspection.graded)
    except _Lost as error:
        return _Outcome(number, before, problem=error.args[0])
    except Exception as error:  # noqa: BLE001 - one record must not stop ten thousand
        if is_of_system(error):
            raise resource_error(error, entry.name) from None
        problem = (
            error
            if isinstance(error, JounceError)
            else RuntimeError(f"the evaluation failed: {error!r}")
        )
        grading = refusal_of(problem, task.limits)
    return _Outcome(
        number, before, None if newest is not None and _is_same(newest, grading) else grading
    )


class _Lost(RecordingError):
    """The bytes of a record differ from those imported."""


def stored_signals(
    store: Store, number: int, entry: RecordEntry, tester: Tester, *, from_files: bool = False
) -> tuple[xr.Dataset, list[Finding]]:
    """Return the signals of a stored record with the findings of its reader."""
    try:
        packed = None if from_files else store.signals(number)
        if packed is not None:
            return unpack(packed)
    except RecordingError:
        pass  # the file is authoritative; the signals only save time
    try:
        content, sidecar = store.content(number)
    except RecordingError as error:
        raise _Lost(error.message()) from None
    return read_entry(replace(entry, content=content, sidecar=sidecar), tester)


def stored_vehicle(entry: RecordEntry) -> Any:
    """Return the vehicle of a stored record from its description; ``None`` if it has none."""
    return (
        None
        if entry.vehicle_table is None
        else rig_from_table(dict(entry.vehicle_table), where=entry.vehicle)
    )


def _is_same(first: Grading, second: Grading) -> bool:
    return first == replace(second, result=to_plain(second.result))
