"""Rows of the benchmark table on scaling: variants, draws of a posterior, starts of an update, tasks of a cluster.

``python benchmarks/scale_rows.py`` prints them alone, in about a minute. Most are timed once, since each lasts
seconds, variants by the median of three runs or more after a warm one; the cluster is one worker beside the same work
here on one thread, so that two cores do not blur its overhead.
"""

from __future__ import annotations

import itertools
import sys
import time
from collections.abc import Callable
from functools import partial
from importlib import metadata
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

from timing import Row, markdown, median_time

import jounce as jn
from jounce.papers.demo import prepare_demo
from jounce.simulation.settings import RunSettings
from jounce.variants.many import read_request
from jounce.variants.workers import Task, here, on_cluster

_RIG = "kart-quarter-car"
_COUNTS = (1_000, 10_000, 100_000, 1_000_000)
_TASKS, _TASK_OF = 4, 1.0  # tasks, and how long each lasts, s


def scale_rows() -> list[Row]:
    """Variants, draws, starts and tasks."""
    return [*_variants(), _posterior(), _starts(), *_cluster()]


def _once(run: Callable[[], object]) -> float:
    begin = time.perf_counter()
    run()
    return time.perf_counter() - begin


def _course() -> jn.Trial:
    road = jn.Iso8608(class_="C", length="40 m", step="5 cm", seed=1)
    return jn.Trial(road=road, speed="10 m/s", duration="3 s")


def _design(count: int, seed: int = 1) -> jn.variants.designs.Design:
    return jn.sobol(
        {"strut.spring.rate": "20 %", "sprung.mass": ["14 kg", "18 kg"]}, count, seed=seed
    )


def _variants() -> list[Row]:
    """A Sobol study of linear quarter cars, from a thousand to a million; the time of one variant."""
    rig, trial = jn.load(_RIG).with_changes({"tyre.lift_off": False}), _course()

    seeds = itertools.count(1)  # no study is made twice

    def run(count: int) -> object:
        return jn.simulate_many(rig, trial, _design(count, next(seeds)), metrics=["rms sprung.az"])

    run(_COUNTS[0])
    rows: list[Row] = []
    for count in _COUNTS:
        one = median_time(partial(run, count), repeats=400, budget=2.0) / count
        words = f"of {count:,}".replace(",", " ")
        ratio = one / rows[0].median if rows else 1.0
        target = "≤ 1.1 of the first" if rows else ""
        rows.append(
            Row(
                "one variant of a Sobol study, linear quarter car, 3 s at 1 kHz",
                words,
                one,
                None,
                ratio,
                target,
            )
        )
    return rows


def _posterior() -> Row:
    """Draws of the shipped campaign's strategy 2, its fit and its predictions within."""
    with TemporaryDirectory() as folder:
        campaign = prepare_demo(Path(folder) / "demo")
        seconds = _once(lambda: jn.campaign_posterior(campaign, "strategy 2", draws=100_000))
    return Row(
        "posterior of strategy 2 of the shipped campaign",
        "jounce, 100 000 draws",
        seconds,
        None,
        None,
        "≤ 60 s",
    )


def _starts() -> Row:
    """Ten parameters of a half car from two hundred points, against its own noise-free data."""
    rig = jn.load("audi-a6-half-car-4dof")
    trial = jn.Trial(
        road=jn.HalfSine(height="30 mm", length="1 m", start="1 m"), speed="10 m/s", duration="2 s"
    )
    values = rig.parameters()
    truth = rig.with_changes(
        {path: values[path] * (1.05 if i % 2 else 0.95) for i, path in enumerate(_TEN)}
    )
    measured = jn.simulate(truth, trial)[
        ["body.az", "body.pitch", "front.unsprung.az", "rear.unsprung.az"]
    ]
    fit = jn.FitTrial("one", rig, trial, measured)
    seconds = _once(lambda: jn.update_model([fit], dict.fromkeys(_TEN, "20 %"), starts=200))
    return Row(
        "update of ten parameters of a half car, 200 starts",
        "jounce",
        seconds,
        None,
        None,
        "≤ 10 s",
    )


def _cluster() -> list[Row]:
    """The same shards here on one thread and on a cluster of one worker; nothing without the extra ``cluster``."""
    if find_spec("distributed") is None:
        return []
    from distributed import Client, LocalCluster

    rig, trial = jn.load(_RIG), _course()
    settings, metrics = RunSettings(), ["rms sprung.az"]
    work, columns = read_request(rig, trial, _design(4096), settings, metrics, None, None)
    work.run(columns, threads=1)
    size = max(1, int(4096 * _TASK_OF / _once(lambda: work.run(columns, threads=1))))
    work, columns = read_request(rig, trial, _design(_TASKS * size), settings, metrics, None, None)
    version = metadata.version("jounce")
    tasks = [
        Task(
            i,
            i * size,
            {path: column[i * size : (i + 1) * size] for path, column in columns.items()},
            version,
        )
        for i in range(_TASKS)
    ]
    with (
        LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster) as client,
    ):
        list(on_cluster(client, work, tasks[:1]))
        own, away = (
            _once(lambda run=run: list(run()))
            for run in (lambda: here(work, tasks, 1), lambda: on_cluster(client, work, tasks))
        )
    problem = f"{_TASKS} sweep tasks of {own / _TASKS:.1f} s"
    return [
        Row(problem, "jounce, in one process on one thread", own, None, 1.0),
        Row(problem, "a Dask cluster of one worker", away, None, away / own, "≤ 1.1"),
    ]


_TEN = (
    "body.mass", "body.pitch_inertia", "front.unsprung_mass", "front.tyre.stiffness", "front.spring_rate",
    "front.damping_coefficient", "rear.unsprung_mass", "rear.tyre.stiffness", "rear.spring_rate",
    "rear.damping_coefficient",
)  # fmt: skip


if __name__ == "__main__":
    sys.stdout.write(markdown(scale_rows()) + "\n")
