"""Sweeps as files: the rig, the trial, the distributions of parameters, and the results to store."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
from pydantic import Field, model_validator

from jounce.core.description import Description, Seed, Whole, line_of, read_description
from jounce.core.errors import JounceError, as_found, at_line, below
from jounce.core.misplaced import error_at
from jounce.core.phrases import Phrase
from jounce.core.serialise import Plain, to_json
from jounce.core.text import guard_formula
from jounce.core.types import Array
from jounce.core.units import PositiveTime, Unit
from jounce.core.writing import resolve_path
from jounce.parts.files import load, rig_named_in
from jounce.roads import Trial
from jounce.roads.loading import load_road, read_roads
from jounce.simulation.settings import Method, RunSettings
from jounce.variants.designs import DESIGNS, MOST
from jounce.variants.many import Variants, VariantWork, read_request
from jounce.variants.shards import Say, keep_in_shards, read_kept
from jounce.variants.summary import Summary, summarise

if TYPE_CHECKING:
    import xarray as xr

    from jounce.control import Controller

_MOST_ROWS = 100_000
"""Maximum number of variants in a table, so that spreadsheets can open it."""
SCHEMA: Literal["jounce.sweep/1"] = "jounce.sweep/1"
Layout = Literal["list", "grid", "latin-hypercube", "sobol", "monte-carlo", "morris", "saltelli"]


class SweepDesign(Description):
    """Design of the variants: ``count`` points of a ``kind``, drawn with ``seed``.

    A ``grid`` has every combination of the values, a ``list`` one value of each parameter per variant; ``grid`` and
    ``list`` have no count. For ``morris`` the count is the number of trajectories, for ``saltelli`` the number of pairs
    of points.
    """

    kind: Layout
    count: Annotated[Whole, Field(ge=1, le=MOST)] | None = None
    seed: Seed = 0

    @model_validator(mode="after")
    def _check_count(self) -> SweepDesign:
        if (self.kind in ("list", "grid")) != (self.count is None):
            said = (
                "has as many variants as its values give"
                if self.kind in ("list", "grid")
                else "needs a count"
            )
            raise error_at(
                ("count",),
                Phrase("a design of kind {kind!r} {said}", kind=self.kind, said=said),
                found=as_found(self.count),
            )
        return self


class SweepStudy(Description):
    """A sweep: the ``rig`` (a file, or the name of a shipped rig), its trial, varied parameters, and results to store.

    ``trial`` has the keys of a trial; its roads are tables, files, names or classes (``"iso:C"``). ``vary`` maps the
    path of each parameter, or the name of an adjustment, to its range, distribution or values; ``metrics`` are computed
    from each run, ``outputs`` are channels stored over time, ``control`` is the name or file of a controller.
    """

    schema_: Literal["jounce.sweep/1"] = Field(default=SCHEMA, alias="schema")
    rig: str
    trial: dict[str, Any]
    design: SweepDesign
    vary: dict[str, Any] = Field(min_length=1)
    metrics: tuple[str, ...] = ()
    outputs: tuple[str, ...] = ()
    control: str | None = None
    output_step: PositiveTime = 1e-3
    tolerance: Annotated[float, Unit("1", above=0.0)] = 1e-5
    method: Method = "auto"

    @model_validator(mode="after")
    def _check_results(self) -> SweepStudy:
        if not self.metrics and not self.outputs:
            raise error_at(
                ("metrics",),
                "no results are stored; give metrics, e.g. ['rms sprung.az'], or outputs",
            )
        return self


@dataclass(frozen=True)
class ReadSweep:
    """A sweep read from its file: the work, and the values (SI) of every variant by path."""

    study: SweepStudy
    work: VariantWork
    columns: dict[str, Array]

    @property
    def count(self) -> int:
        """Number of variants of the sweep."""
        return len(next(iter(self.columns.values())))


@dataclass(frozen=True)
class SweepResult(Plain):
    """Statistics of a sweep, sensitivities of its metrics, and the underlying data.

    Attributes
    ----------
    study : str
        The file of the study.
    out : str
        Folder of the results.
    command : str
        Command that started the sweep.
    seed : int or None
        Seed of the variants, if they are drawn at random.
    summary : Summary
        Statistics and sensitivities of every metric, and reasons of failed variants.
    data : xarray.Dataset
        As returned by :func:`load_sweep`.
    """

    left_out = ("data",)
    when_interrupted = "what is finished is kept; the same command with --resume goes on."
    study: str
    out: str
    command: str
    seed: int | None
    summary: Summary
    data: xr.Dataset = field(repr=False)

    @property
    def is_met(self) -> bool:
        """Whether at least one variant ran."""
        return bool(self.summary.ran)

    def files(self) -> dict[str, bytes | str]:
        """Return the study, the summary, and a table of the variants by file name."""
        study = Path(self.study).read_text(encoding="utf-8")
        return {
            "study.toml": study,
            "summary.json": f"{to_json(self)}\n",
            "variants.csv": self.table(),
        }

    def table(self) -> str:
        """Return the variants with their parameters and metrics as CSV, SI; for large sweeps only the first ones."""
        data = self.data.drop_dims("time", errors="ignore").isel(variant=slice(0, _MOST_ROWS))
        names = [
            str(name)
            for name in (*data.coords, *data.data_vars)
            if name not in ("variant", "reason")
        ]
        frame = data.reset_coords()[[*names, "reason"]].to_dataframe().reset_index()
        header = {
            name: guard_formula(f"{name} [{data[name].attrs.get('units', '1')}]") for name in names
        }
        frame = frame.map(lambda cell: guard_formula(cell) if isinstance(cell, str) else cell)
        return str(frame.rename(columns=header).to_csv(index=False, lineterminator="\n"))


def run_sweep(
    study: Path | str,
    out: Path | str,
    *,
    resume: bool = False,
    force: bool = False,
    workers: int | None = 1,
    client: Any = None,
    say: Say = lambda _done, _count: None,
    command: str = "",
) -> SweepResult:
    """Run the sweep that a file describes into a folder, in shards that survive an interruption.

    Parameters
    ----------
    study : path
        A file of the schema ``jounce.sweep/1``.
    out : path
        Folder of the results.
    resume : bool
        Whether to continue an interrupted sweep, or start it if there is none.
    force : bool
        Whether to replace an earlier sweep in the folder, deleting its shards.
    workers : int, optional
        Number of processes, as for :func:`simulate_many`; None for one per processor if that pays off.
    client : dask.distributed.Client, optional
        A cluster that does the work instead.
    say : callable
        Called with the number of finished variants and the total.
    command : str
        Command line, stored with the results.

    Returns
    -------
    SweepResult
        Statistics and data.

    Raises
    ------
    DescriptionError
        For an invalid study, with file and line.
    OutputError
        As for :func:`simulate_many`.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> folder = pathlib.Path(tempfile.mkdtemp())
    >>> text = '''
    ... schema = "jounce.sweep/1"
    ... rig = "audi-a6-quarter-car"
    ... metrics = ["rms sprung.az"]
    ... trial = {speed = "10 m/s", duration = "1 s", road = {kind = "half-sine", height = "10 mm", length = "1 m"}}
    ... design = {kind = "grid"}
    ... vary = {"sprung.mass" = ["400 kg", "500 kg"]}
    ... '''
    >>> _ = (folder / "study.toml").write_text(text)
    >>> result = run_sweep(folder / "study.toml", folder / "out")
    >>> result.summary.count, result.summary.metrics[0].name
    (2, 'rms sprung.az')
    """
    sweep = read_sweep(study)
    data = keep_in_shards(
        sweep.work,
        sweep.columns,
        out,
        resume=resume,
        force=force,
        workers=workers,
        client=client,
        say=say,
        command=command,
    )
    shards = read_kept(resolve_path(out, home=True))
    seed = sweep.study.design.seed if sweep.study.design.count is not None else None
    return SweepResult(
        str(study), str(out), str(shards.about["command"]), seed, summarise(data), data
    )


def extreme_runs(sweep: ReadSweep, data: xr.Dataset) -> dict[str, xr.Dataset]:
    """Run the unchanged rig, and the variants with the lowest and the highest first metric; return runs by label.

    The result is empty without a metric, or if none of them runs.
    """
    from jounce.simulation import simulate

    if not sweep.work.metrics:
        return {}
    name, study = sweep.work.metrics[0].text, sweep.work.study
    values = data[name].to_numpy()
    chosen: dict[str, dict[str, float]] = {"rig as it is": {}}
    if np.any(np.isfinite(values)):
        for words, row in (("least", np.nanargmin(values)), ("greatest", np.nanargmax(values))):
            changes = {path: float(data[path][row]) for path in sweep.columns}
            chosen[f"{words} {name} (variant {int(data['variant'][row])})"] = changes
    result = {}
    for words, changes in chosen.items():
        rig, trial, control = study.variant(changes)
        with contextlib.suppress(JounceError):  # variants may run even if the base rig does not
            result[words] = simulate(
                rig,
                trial,
                control=control,
                output_step=study.settings.output_step,
                tolerance=study.settings.tolerance,
                method=study.settings.method,
            )
    return result


def read_sweep(path: Path | str) -> ReadSweep:
    """Read a sweep and everything it refers to; errors name the file and the line."""
    study, text = read_description(SweepStudy, path, SCHEMA)
    file = Path(path)
    rig = load(rig_named_in(study.rig, file))
    try:
        trial = read_trial(study.trial, file, text)
        variants = _variants(study)
        settings = RunSettings(study.output_step, study.tolerance, study.method)
        work, columns = read_request(
            rig,
            trial,
            variants,
            settings,
            list(study.metrics),
            list(study.outputs),
            _control(study, file),
        )
    except JounceError as error:
        raise _place_error(error, file, text, study) from None
    return ReadSweep(study, work, columns)


def _variants(study: SweepStudy) -> Variants:
    design = study.design
    if design.kind == "list":
        return study.vary
    make: Callable[..., Variants] = DESIGNS[design.kind]
    return (
        make(study.vary)
        if design.count is None
        else make(study.vary, design.count, seed=design.seed)
    )


def read_trial(
    table: dict[str, Any], file: Path, text: str, place: tuple[str, ...] = ("trial",)
) -> Trial:
    """Read a trial; its roads may be tables, files next to the study, names or classes."""
    trial = dict(table)
    for side in ("road", "right"):
        given = table.get(side)
        if isinstance(given, str):
            beside = file.parent / given
            driven = _metres(table) if given.lower().startswith("iso:") else None
            try:
                trial[side] = load_road(
                    beside if beside.suffix and beside.is_file() else given, length=driven
                )
            except JounceError as error:
                raise _with_place(
                    error,
                    file,
                    line_of(text, (*place, side)),
                    f"{'.'.join(place)}.{side}: {error.where}",
                ) from None
        elif isinstance(given, dict):
            read = read_roads(
                {side: given}, where=str(file), text=text, folder=file.parent, path=place
            )
            trial[side] = read[side]
    given = table.get("excitation")
    if isinstance(given, str):
        trial["excitation"] = file.parent / given
    elif isinstance(given, dict) and isinstance(given.get("file"), str):
        trial["excitation"] = {**given, "file": file.parent / given["file"]}
    return Trial.from_table(trial, where=str(file), text=text, path=place)


def _metres(table: dict[str, Any]) -> float | None:
    """Return the driven distance; None for invalid values, which the trial itself rejects."""
    from jounce.core.units import positive_si

    try:
        return positive_si(table["speed"], "m/s", where="") * positive_si(
            table["duration"], "s", where=""
        )
    except (JounceError, KeyError):
        return None


def _control(study: SweepStudy, file: Path) -> Controller | None:
    if study.control is None:
        return None
    from jounce.control import controller

    beside = file.parent / study.control
    return controller(beside if beside.suffix == ".toml" else study.control)


def _place_error(error: JounceError, file: Path, text: str, study: SweepStudy) -> JounceError:
    """Add file and line to an error that refers to a key of the study."""
    place = error.where.removeprefix("variants: ")
    varied_path = next(
        (
            path
            for path in study.vary
            if place == path or place.startswith((f"{path}:", f"{path}["))
        ),
        None,
    )
    head = place.partition("[")[0].partition(":")[0]
    if varied_path is not None:
        line = line_of(text, ("vary", varied_path))
        place = f"vary.{place}"
    elif head in ("metrics", "outputs", "output_step", "tolerance", "method", "control", "design"):
        line = line_of(text, (head,))
    elif head in ("variants", "count", "seed"):
        line, place = line_of(text, ("design",)), "design"
    else:
        return error
    return _with_place(error, file, line, place)


def _with_place(error: JounceError, file: Path, line: int | None, place: str) -> JounceError:
    where = below(at_line(file, line), place)
    return type(error)(
        error.what, where=where, found=error.found, allowed=error.allowed, hint=error.hint
    )
