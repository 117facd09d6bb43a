"""Long sweeps on disk: results in shards, each complete or absent, and the study that a resumed sweep must match.

The file name of a shard contains its number and checksum; the file appears by a single rename. A killed process
therefore leaves no half-written shard, and later damage is detected. A shard is a netCDF file or, in a folder with a
name ending in ``.zarr``, the record of its chunks in a Zarr group. ``sweep.json`` stores everything that determines the
results.
"""

from __future__ import annotations

import hashlib
import io
import json
import math
import os
import re
import shutil
import sys
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import closing, contextmanager
from dataclasses import dataclass
from functools import cached_property
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from jounce.core.commands import command_line
from jounce.core.errors import DescriptionError, OutputError
from jounce.core.files import content_of
from jounce.core.locking import hold
from jounce.core.phrases import Phrase
from jounce.core.processes import check_workers, refusal
from jounce.core.serialise import to_json, to_plain
from jounce.core.text import qualify
from jounce.core.types import Array
from jounce.core.writing import check_folder, resolve_path, write_atomically
from jounce.variants import zarr_shards
from jounce.variants.findings import Tally
from jounce.variants.many import VariantWork
from jounce.variants.threads import processors
from jounce.variants.workers import Task, here, on_cluster, on_processes, own_locks
from jounce.variants.zarr_shards import checksum

if TYPE_CHECKING:
    import xarray as xr

SCHEMA = "jounce.sweep-results/1"
MANIFEST, SHARDS = "sweep.json", "shards"
Say = Callable[[int, int], None]
_NAME = re.compile(r"(\d{6})\.([0-9a-f]{32})\.(nc|json)")
_AIM = (
    4.0  # s of work per shard: an interruption loses little, and a cluster's overhead is negligible
)
_TRIED = 0.5  # s spent on measuring the time per variant
_MOST_SHARDS = 1_000_000  # file names have six digits
_LARGEST, _MOST_BYTES = 65_536, 100e6  # maximum variants and bytes per shard
_LONG = 20.0  # s of work from which starting several processes pays off
_TASK = 0.2  # s, minimum work per shard for another process
_PER_WORKER = 4  # minimum shards per worker, so that all finish at about the same time
_OVERHEAD = 60_000  # bytes of a netCDF file without its data
_MOST_NUMBERS = 400_000_000  # values in one dataset: 3.2 GB
_COUNTED = ("side_by_side", "outside")  # attributes that are summed over shards
_MOST_DIFFERENCES = 5  # listed in an error
_COLUMN = re.compile(
    r"(\d+) from (\S+) to (\S+), [0-9a-f]{16}"
)  # values of a parameter, as `study_of` writes them
_NEAR = 0.02  # tolerance on the ends of a redrawn parameter, as a share of its range
_LONG_LIST = 50  # values: longer lists are shown as a digest in an error


@dataclass(frozen=True)
class KeptSweep:
    """A folder with a sweep, finished or not.

    Attributes
    ----------
    folder : Path
        Its path.
    about : dict
        Content of ``sweep.json``: ``count`` and ``shard`` (variants), ``study``, ``command``, version.
    """

    folder: Path
    about: Mapping[str, Any]

    @property
    def count(self) -> int:
        """Number of variants of the entire sweep."""
        return int(self.about["count"])

    @property
    def is_zarr(self) -> bool:
        """Whether the folder is a Zarr group."""
        return self.about.get("format") == "zarr"

    @cached_property
    def spans(self) -> list[tuple[int, int]]:
        """First variant of each shard and the end of its range (exclusive)."""
        size = int(self.about["shard"])
        return [(first, min(first + size, self.count)) for first in range(0, self.count, size)]

    def names(self) -> dict[int, list[Path]]:
        """Return the files of each shard: one, or more if a damaged file exists."""
        result: dict[int, list[Path]] = {}
        for file in sorted((self.folder / SHARDS).glob(f"*{self._suffix}")):
            match = _NAME.fullmatch(file.name)
            if match is not None and file.is_file() and int(match[1]) < len(self.spans):
                result.setdefault(int(match[1]), []).append(file)
        return result

    def whole(self) -> dict[int, Path]:
        """Return the undamaged shards by number."""
        result = {}
        for number, files in self.names().items():
            good = [file for file in files if self._is_whole(file)]
            if good:
                result[number] = good[0]
        return result

    def write(self, number: int, content: bytes) -> None:
        """Store a shard, given as a netCDF file, and remove damaged files of the same number."""
        if self.is_zarr:
            content = zarr_shards.put(
                self.folder, number, _dataset(content), self.count, int(self.about["shard"])
            )
        name = f"{number:06d}.{checksum(content)}{self._suffix}"
        (self.folder / SHARDS).mkdir(exist_ok=True)
        write_atomically(self.folder / SHARDS / name, content, force=True)
        for file in (self.folder / SHARDS).glob(f"{number:06d}.*{self._suffix}"):
            if file.name != name:
                file.unlink(missing_ok=True)

    def read(self, number: int) -> xr.Dataset | None:
        """Read a shard; None if it is damaged."""
        for file in self.names()[number]:
            content = file.read_bytes()
            if checksum(content) != file.name.split(".")[1]:
                continue
            shard = zarr_shards.take(self.folder, content) if self.is_zarr else _dataset(content)
            if shard is not None:
                return shard
        return None

    @property
    def _suffix(self) -> str:
        return ".json" if self.is_zarr else ".nc"

    def _is_whole(self, file: Path) -> bool:
        try:
            content = file.read_bytes()
        except OSError:
            return False
        is_own = checksum(content) == file.name.split(".")[1]
        return is_own and (not self.is_zarr or zarr_shards.is_whole(self.folder, content))


def _dataset(content: bytes) -> xr.Dataset:
    import xarray as xr

    with own_locks():
        return xr.load_dataset(io.BytesIO(content), engine="h5netcdf")


def keep_in_shards(
    work: VariantWork,
    columns: Mapping[str, Array],
    out: Path | str,
    *,
    resume: bool = False,
    force: bool = False,
    workers: int | None = 1,
    client: Any = None,
    threads: int | None = None,
    say: Say = lambda _done, _count: None,
    command: str = "",
) -> xr.Dataset:
    """Run variants into a folder, shard by shard; return the result of :func:`load_sweep`.

    ``say`` is called with the number of finished variants and the total; ``command`` is the command line. With
    ``workers=None`` there is one worker per processor if variants run individually and take long.
    """
    folder = resolve_path(out, home=True)
    study, goes_on = study_of(work, columns), (folder / MANIFEST).is_file() and resume
    shards = read_kept(folder) if goes_on else None
    if shards is not None:
        _check_same(shards, study)
    else:
        _refuse_taken(folder, force=force)
    pace = _pace(work, columns) if shards is None or workers is None else _Pace(0.0, is_alone=False)
    if workers is None:
        lasts = pace.seconds * len(next(iter(columns.values())))
        workers = processors() if pace.is_alone and lasts > _LONG and refusal() is None else 1
    if workers > 1 and client is None:
        check_workers()
    begins = shards is None
    if shards is None:
        size = _size(work, columns, workers if client is None else 64, pace)
        shards = _plan(folder, work, columns, study, size, command)
    folder.mkdir(parents=True, exist_ok=True)
    with _lock(folder):
        if begins:
            _begin(shards)
        done = shards.whole()
        _check_disk(
            shards,
            work,
            [shards.spans[number] for number in range(len(shards.spans)) if number not in done],
        )
        version, finished = (
            _version(),
            sum(shards.spans[number][1] - shards.spans[number][0] for number in done),
        )
        say(finished, shards.count)
        tasks = [
            Task(
                number,
                first,
                {path: column[first:end] for path, column in columns.items()},
                version,
            )
            for number, (first, end) in enumerate(shards.spans)
            if number not in done
        ]
        if client is not None:
            results = on_cluster(client, work, tasks)
        elif workers > 1:
            results = on_processes(min(workers, len(tasks)), work, tasks)
        else:
            results = here(work, tasks, threads)
        with closing(results):  # close at once however the loop ends, to stop the workers
            for number, content in results:
                _write(shards, number, content)
                finished += shards.spans[number][1] - shards.spans[number][0]
                say(finished, shards.count)
    result = load_sweep(folder)
    if shards.is_zarr:
        zarr_shards.describe(folder, result.attrs)
    return result


def _refuse_taken(folder: Path, *, force: bool) -> None:
    """Reject a folder that is not empty; explain how to resume if it contains a sweep."""
    if not force and (folder / MANIFEST).is_file():
        shards = read_kept(folder)
        raise OutputError(
            "the folder contains a sweep",
            where=str(folder),
            found=f"{len(shards.names())} of {len(shards.spans)} shards",
            hint=(
                "Continue with --resume (in Python resume=True), or choose another folder; --force "
                "discards the existing results."
            ),
        )
    check_folder(folder, force=force)


def _write(shards: KeptSweep, number: int, content: bytes) -> None:
    """Store a shard; if the disk is full, explain how to resume."""
    try:
        shards.write(number, content)
    except OutputError as error:
        hint = f"What is finished is kept: make room, then resume. {error.hint}".rstrip()
        raise OutputError(
            error.what, where=error.where, found=error.found, allowed=error.allowed, hint=hint
        ) from None


def load_sweep(folder: Path | str, *, channels: bool | None = None) -> xr.Dataset:
    """Read the results of a finished or unfinished sweep from its folder.

    Parameters
    ----------
    folder : path
        Folder given as ``out=`` of :func:`simulate_many` or ``--out`` of ``jounce sweep``.
    channels : bool, optional
        Whether to read channels over time as well; by default if they have at most 4e8 values (3.2 GB).

    Returns
    -------
    xarray.Dataset
        As returned by :func:`simulate_many`, for the finished variants; damaged shards are skipped.
        ``attrs["variants"]`` is the total number of variants of the sweep.

    Raises
    ------
    OutputError
        If the folder does not contain a sweep.

    Examples
    --------
    >>> import tempfile
    >>> import jounce as jn
    >>> trial = jn.Trial(road=jn.HalfSine(height="10 mm", length="1 m"), speed="10 m/s", duration="1 s")
    >>> dampers = {"strut.damper.coefficient": [1000.0, 2000.0]}
    >>> out = tempfile.mkdtemp()
    >>> many = jn.simulate_many(jn.load("audi-a6-quarter-car"), trial, dampers, metrics="max sprung.az", out=out)
    >>> jn.load_sweep(out).identical(many)
    True
    """
    import xarray as xr

    shards = read_kept(resolve_path(folder, home=True))
    spans = {number: shards.spans[number] for number in shards.names()}
    count = sum(end - first for first, end in spans.values())
    arrays: dict[str, Array] = {}
    first_shard, row, tally, findings = None, 0, dict.fromkeys(_COUNTED, 0), Tally()
    for number in sorted(spans):
        shard = shards.read(number)
        if shard is None:
            continue
        if channels is None:
            over_time = [
                variable for variable in shard.data_vars.values() if "time" in variable.dims
            ]
            channels = count * sum(array[0].size for array in over_time) <= _MOST_NUMBERS
        if not channels:
            shard = shard.drop_dims("time", errors="ignore")
        if first_shard is None:
            first_shard = shard
            arrays = {
                str(name): np.empty(
                    (count, *variable.shape[1:]),
                    dtype=variable.dtype if variable.dtype.kind in "fi" else object,
                )
                for name, variable in shard.variables.items()
                if "variant" in variable.dims
            }
        size = shard.sizes["variant"]
        for name, values in arrays.items():
            values[row : row + size] = shard[name].to_numpy()
        row += size
        for name in _COUNTED:
            tally[name] += int(shard.attrs.get(name, 0))
        findings.merge(shard.attrs)
    if first_shard is None:
        return xr.Dataset(attrs={"variants": shards.count})
    variables = {
        str(name): xr.Variable(
            variable.dims,
            arrays[str(name)][:row] if str(name) in arrays else variable.to_numpy(),
            variable.attrs,
        )
        for name, variable in first_shard.variables.items()
    }
    coordinates = {name: variables[str(name)] for name in map(str, first_shard.coords)}
    data = {name: variable for name, variable in variables.items() if name not in coordinates}
    attributes = {
        **to_plain(first_shard.attrs),
        **tally,
        **findings.attributes(),
        "variants": shards.count,
    }
    return xr.Dataset(data, coordinates, attributes)


def read_kept(folder: Path) -> KeptSweep:
    """Read the description of a sweep from its folder."""
    file = folder / MANIFEST
    try:
        if not file.is_file():
            raise OutputError(
                "the folder contains no sweep",
                where=str(folder),
                allowed=Phrase("a folder with {manifest}", manifest=MANIFEST),
            )
        about = json.loads(content_of(file, OutputError))
        shards = KeptSweep(folder, about)
        size = int(about["shard"])
        if (
            about["schema"] == SCHEMA
            and 1 <= shards.count <= _MOST_SHARDS * size
            and size >= 1
            and "study" in about
        ):
            return shards
    except (ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError):
        pass
    raise OutputError(
        "this file does not describe a sweep",
        where=str(file),
        hint="Start the sweep again in a different folder.",
    )


# identity of a sweep --------------------------------------------------------------------------------------------------


def study_of(work: VariantWork, columns: Mapping[str, Array]) -> dict[str, Any]:
    """Return everything that determines the results as plain data: files by content, long lists by digest."""
    study = work.study
    if study.control is not None and callable(getattr(study.control, "function", None)):
        raise DescriptionError(
            "a Python function cannot be stored with its results",
            where="control",
            allowed="the name or file of a controller",
            hint="Leave out out=, or write the law as a file.",
        )
    described = {"rig": study.rig, "trial": study.trial, "control": study.control}
    return {
        **{
            name: None if part is None else _plain(part.model_dump(by_alias=True))
            for name, part in described.items()
        },
        "settings": to_plain(study.settings),
        "metrics": [metric.text for metric in work.metrics],
        "outputs": list(work.channels),
        "variants": {
            **work.design,
            **{
                path: f"{len(column)} from {column.min():.6g} to {column.max():.6g}, {_digest(column.tobytes())}"
                for path, column in columns.items()
            },
        },
        "jounce": _version(),
    }


def _plain(value: Any) -> Any:
    if isinstance(value, Path):
        content = value.read_bytes() if value.is_file() else b""
        return {"file": str(value), "content": _digest(content)}
    if isinstance(value, Mapping):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        if len(value) > _LONG_LIST:
            return f"{len(value)} values, {_digest(to_json(value, indent=None).encode())}"
        return [_plain(item) for item in value]
    return to_plain(value)


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:16]


def _version() -> str:
    return metadata.version("jounce")


def _flatten(value: Any, path: str = "") -> dict[str, Any]:
    if isinstance(value, Mapping):
        inner = [_flatten(item, qualify(path, str(key))) for key, item in value.items()]
    elif isinstance(value, list):
        inner = [_flatten(item, f"{path}[{i}]") for i, item in enumerate(value)]
    else:
        return {path: value}
    return {key: item for part in inner for key, item in part.items()}


def _check_same(shards: KeptSweep, study: Mapping[str, Any]) -> None:
    """Raise an error if the stored study differs from the present one, listing the differences."""
    before, now = _flatten(shards.about["study"]), _flatten(json.loads(to_json(study)))
    changed = [path for path in dict.fromkeys([*before, *now]) if before.get(path) != now.get(path)]
    if not changed:
        return
    drawn_anew = bool({"variants.seed", "variants.design"} & set(changed))
    texts = [
        _change_text(path, before.get(path), now.get(path), drawn_anew=drawn_anew)
        for path in changed
    ]
    texts = list(dict.fromkeys(filter(None, texts)))
    more = f" and {len(texts) - _MOST_DIFFERENCES} more" if len(texts) > _MOST_DIFFERENCES else ""
    raise OutputError(
        "the stored sweep is not the one to be resumed",
        where=str(shards.folder),
        found=f"{'; '.join(texts[:_MOST_DIFFERENCES])}{more}",
        hint="Undo the changes, or start in a different folder.",
    )


def _change_text(path: str, before: Any, now: Any, *, drawn_anew: bool) -> str:
    """Describe a change at a path; empty if it follows from another reported change."""
    columns = [_COLUMN.fullmatch(str(value)) for value in (before, now)]
    if columns[0] is None or columns[1] is None:
        return f"{path}: {_short(before)} before, {_short(now)} now"
    (count, *ends), (others, *other_ends) = (
        column.groups()[:3] for column in columns if column is not None
    )
    low, high, other_low, other_high = map(float, (*ends, *other_ends))
    near = _NEAR * max(high - low, other_high - other_low)
    if count == others and abs(low - other_low) <= near and abs(high - other_high) <= near:
        return "" if drawn_anew else f"{path}: other values"
    return (
        f"{path}: {' to '.join(ends)} before, {' to '.join(other_ends)} now"
        if count == others
        else (f"variants: {count} before, {others} now")
    )


def _short(value: Any) -> str:
    text = "nothing" if value is None else str(value)
    return text if len(text) < 60 else f"{text[:57]}…"


# the folder -----------------------------------------------------------------------------------------------------------


def _plan(
    folder: Path,
    work: VariantWork,
    columns: Mapping[str, Array],
    study: Mapping[str, Any],
    size: int,
    command: str,
) -> KeptSweep:
    """Plan a new sweep; raise an error if the disk space is insufficient."""
    about = {
        "schema": SCHEMA,
        "count": len(next(iter(columns.values()))),
        "shard": size,
        "format": "zarr" if folder.suffix.lower() == ".zarr" else "netcdf",
        "jounce": _version(),
        "command": command or command_line(sys.argv),
        "study": study,
    }
    shards = KeptSweep(folder, about)
    _check_disk(shards, work, shards.spans)
    return shards


def _begin(shards: KeptSweep) -> None:
    """Write the description of the sweep, and remove shards of an earlier sweep in the folder."""
    for file in (shards.folder / SHARDS).glob("*"):
        if _NAME.fullmatch(file.name):
            file.unlink()
    zarr_shards.clear(shards.folder)
    write_atomically(shards.folder / MANIFEST, f"{to_json(shards.about)}\n", force=True)


@dataclass(frozen=True)
class _Pace:
    """Time per variant (s), and whether most variants run one by one."""

    seconds: float
    is_alone: bool


def _pace(work: VariantWork, columns: Mapping[str, Array]) -> _Pace:
    """Measure how long the first variants take."""
    count, tried, before = len(next(iter(columns.values()))), 1, 0
    work.run({path: column[:1] for path, column in columns.items()})  # compile first
    while True:
        started = time.perf_counter()
        dataset = work.run({path: column[:tried] for path, column in columns.items()}, threads=1)
        took, size = time.perf_counter() - started, dataset.sizes["variant"]
        together = dataset.attrs["side_by_side"]
        if (
            together > before and took > _TRIED
        ):  # the first variants run in vectors include compilation
            before = together
            continue
        if took > _TRIED or tried >= count:
            return _Pace(took / size, 2 * together < size)
        tried *= 4


def _size(work: VariantWork, columns: Mapping[str, Array], workers: int, pace: _Pace) -> int:
    """Return the number of variants per shard: a power of 2 that takes some seconds and fits into memory."""
    count = len(next(iter(columns.values())))
    most = [_AIM / pace.seconds, _MOST_BYTES / _bytes_of_a_variant(work, columns), _LARGEST]
    if workers > 1:
        worth = _TASK / pace.seconds  # variants below which the transfer takes longer than the work
        most.append(
            max(count / (workers * _PER_WORKER), 2.0 ** math.ceil(math.log2(max(worth, 1.0))))
        )
    return int(2 ** math.floor(math.log2(max(min(most), 1.0))))


def _bytes_of_a_variant(work: VariantWork, columns: Mapping[str, Array]) -> int:
    samples = len(
        work.study.settings.times(
            float(columns.get("trial.duration", [work.study.trial.duration])[0])
        )
    )
    return 8 * (len(columns) + len(work.metrics) + len(work.channels) * samples + 1) + 32


def _check_disk(shards: KeptSweep, work: VariantWork, spans: list[tuple[int, int]]) -> None:
    """Raise an error before the work begins if the results exceed the free disk space."""
    there = next(parent for parent in (shards.folder, *shards.folder.parents) if parent.exists())
    paths = [path for path in shards.about["study"]["variants"] if path not in ("design", "seed")]
    each = _bytes_of_a_variant(work, dict.fromkeys(paths, np.array([work.study.trial.duration])))
    needed = sum(each * (end - first) + _OVERHEAD for first, end in spans)
    free = shutil.disk_usage(there).free
    if needed > free:
        raise OutputError(
            "the results exceed the free disk space",
            where=str(shards.folder),
            found=_in_words(needed),
            allowed=_in_words(free),
            hint="Store only metrics or fewer outputs, or use a longer output step.",
        )


def _in_words(count: float) -> str:
    """Return a number of bytes as text.

    >>> _in_words(1_200_000), _in_words(3.2e9)
    ('1.2 MB', '3.2 GB')
    """
    return f"{count / 1e9:.3g} GB" if count >= 1e9 else f"{count / 1e6:.3g} MB"


@contextmanager
def _lock(folder: Path) -> Iterator[None]:
    """Lock a folder for one process at a time."""
    held = hold(folder)
    if held is None:
        raise OutputError(
            "another process is working on this sweep",
            where=str(folder),
            hint="Wait until that process ends, or stop it first.",
        )
    try:
        yield
    finally:
        os.close(held)
