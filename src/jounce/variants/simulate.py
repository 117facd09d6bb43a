"""Simulation of many variants of a rig over a trial, in memory or into a folder."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from jounce.core.errors import DescriptionError
from jounce.core.phrases import Phrase
from jounce.core.seeds import is_whole
from jounce.core.waiting import report_work
from jounce.parts import Rig, as_rig
from jounce.recordings.carried import by_path
from jounce.roads import HoldsTrial, Trial, as_trial
from jounce.simulation.settings import Method, RunSettings
from jounce.variants.many import Variants, read_request
from jounce.variants.shards import keep_in_shards

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr

    from jounce.control import Controller
    from jounce.simulation.controlled import AnyControl

_MOST_SAMPLES = 400_000_000  # values of channels over time: 3.2 GB


def simulate_many(  # noqa: PLR0913 - all but three are settings with a default
    rig: Rig | str | Path,
    trial: Trial | HoldsTrial,
    variants: Variants | pd.DataFrame,
    *,
    metrics: Sequence[str] | str | None = None,
    outputs: Sequence[str] | str | None = None,
    output_step: float = 1e-3,
    tolerance: float = 1e-5,
    method: Method = "auto",
    control: AnyControl | None = None,
    threads: int | None = None,
    out: Path | str | None = None,
    resume: bool = False,
    workers: int = 1,
    client: Any = None,
) -> xr.Dataset:
    """Simulate many variants of a rig over a trial, each from its own static equilibrium.

    Piecewise linear models run in vector registers, with threads sharing the variants; only sums of the samples are
    stored. A variant passes its events individually and then rejoins the others. Corners reduced to one coordinate,
    other models without loops and, from 256 variants on, corners modelled as mechanisms are integrated in blocks with
    common steps, which changes their results by less than the tolerance. All other variants are run one by one as by
    :func:`simulate`. The results do not depend on the number of threads.

    Parameters
    ----------
    rig : Rig, str or Path
        Base of all variants: a rig or a vehicle, its file or its name in the library.
    trial : Trial
        Trial of all variants.
    variants : mapping, DataFrame or Design
        Path of a parameter to its value in each variant, SI or texts with units, all of the same length; a table with
        such columns, ``path [unit]`` or in SI; or a design (:func:`grid`, :func:`sobol`, :func:`latin_hypercube`,
        :func:`monte_carlo`). Paths are those of the rig (``"strut.spring.rate"``) and names of its adjustments
        (``"upper_arm_length"``, applied last; see :func:`apply_adjustments`), of the trial (``"trial.speed"``,
        ``"trial.road.seed"``), and of a controller (``"control.rate"``).
    metrics : sequence of str, optional
        Metrics to store for each run: ``rms``, ``mean``, ``min``, ``max``, ``range`` or ``peak`` of a channel (``"rms
        sprung.az"``), a weighting of ISO 2631-1 (``"Wk sprung.az"``), or ``absorbed_power`` (W) or ``shock`` of an
        acceleration, computed from the samples. ``rms`` is about the
        value at rest (with a controller, about the first sample). A channel name without corner selects that channel of
        all corners.
    outputs : sequence of str, optional
        Channels to store over time; all channels if neither ``metrics`` nor ``outputs`` is given.
    output_step, tolerance, method : float, float, {"auto", "explicit", "implicit"}
        As for :class:`jounce.simulation.RunSettings`; s, 1.
    control : Controller, str, Path or callable, optional
        As for :func:`simulate`.
    threads : int, optional
        Number of threads; by default one per processor.
    out : path, optional
        Folder in which results are stored in shards as they are computed, which lets long sweeps be resumed;
        :func:`load_sweep` reads it. The shards are netCDF files or, if the name ends in ``.zarr``, the chunks of a Zarr
        group.
    resume : bool
        Whether to continue an interrupted sweep in ``out``; the study must be unchanged.
    workers : int
        Number of processes; 1 uses the current process only. With more, the calling script needs ``if __name__ ==
        "__main__":``, as usual for multiprocessing in Python.
    client : dask.distributed.Client, optional
        A cluster that computes the shards instead (extra ``cluster``).

    Returns
    -------
    xarray.Dataset
        Metrics on ``variant`` and channels on ``variant`` and ``time`` (s), each with ``units`` (SI) and ``long_name``;
        the varied parameters are coordinates. A variant that does not run has NaN values and the reason in ``reason``.
        ``attrs["side_by_side"]`` is the number of variants that ran in vector registers, ``attrs["outside"]`` the
        number of variants with a parameter outside its allowed range. Findings of controllers are in
        ``attrs["findings"]``, each once, with the number of variants concerned in ``attrs["finding_variants"]``.
        Channels over time that do not fit into memory stay in ``out``.

    Raises
    ------
    DescriptionError
        For unknown paths, channels or metrics, values of different lengths, a range beyond the limits of the
        description, or results that do not fit into memory.
    OutputError
        For a folder with other content, a resumed sweep that differs from the stored one (the message lists the
        differences), or insufficient disk space.
    RecordingError
        If runs are too short for a weighting, as in :func:`ride_metrics`.
    SimulationError
        If the unchanged rig does not run on the trial.

    Examples
    --------
    >>> import jounce as jn
    >>> rig = jn.load("audi-a6-quarter-car")
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="1 m"), speed="10 m/s", duration="1 s")
    >>> many = jn.simulate_many(rig, trial, {"strut.damper.coefficient": [1000.0, 2000.0]}, metrics=["max sprung.az"])
    >>> bool(many["max sprung.az"][0] < many["max sprung.az"][1])   # the softer damper
    True
    """
    trial = as_trial(trial)
    _check_threads(threads)
    if not is_whole(workers) or workers < 1:
        raise DescriptionError(
            "invalid number of processes", where="workers", found=workers, allowed="1 or more"
        )
    work, columns = read_request(
        as_rig(rig),
        trial,
        by_path(variants),
        RunSettings(output_step, tolerance, method),
        metrics,
        outputs,
        _as_controller(control),
    )
    count = len(next(iter(columns.values())))
    if out is not None:
        return keep_in_shards(
            work, columns, out, resume=resume, workers=workers, client=client, threads=threads
        )
    for name, given in (
        ("resume", resume),
        ("workers", workers > 1),
        ("client", client is not None),
    ):
        if given:
            hint = "Give out=, a folder in which results are stored during the sweep."
            raise DescriptionError("requires a folder for the results", where=name, hint=hint)
    _check_size(count, len(work.channels), len(work.study.settings.times(trial.duration)))
    with report_work(Phrase("simulating {count} variants", count=f"{count:,}".replace(",", " "))):
        return work.run(columns, threads=threads)


def _as_controller(control: AnyControl | None) -> Controller | None:
    if control is None:
        return None
    from jounce.control import as_controller

    return as_controller(control)


def _check_threads(threads: int | None) -> None:
    if threads is not None and (not is_whole(threads) or threads < 1):
        raise DescriptionError(
            "invalid number of threads", where="threads", found=threads, allowed="1 or more"
        )


def _check_size(count: int, channels: int, samples: int) -> None:
    if count * channels * samples > _MOST_SAMPLES:
        raise DescriptionError(
            "too many samples to store",
            where="variants, outputs, output_step",
            found=f"{count} variants of {channels} channels with {samples} samples",
            allowed=Phrase("{most_samples:.0e} numbers", most_samples=_MOST_SAMPLES),
            hint="Request metrics, fewer outputs, or a longer output step.",
        )
