"""Responses to the page: runs and sweeps as curves of the viewer, with equivalent Python code and command."""

from __future__ import annotations

import threading
import time
from collections import OrderedDict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from hashlib import sha256
from tomllib import TOMLDecodeError
from typing import TYPE_CHECKING, Annotated, Any

import tomlkit
from pydantic import BeforeValidator, Field

from jounce.core.commands import command_line
from jounce.core.errors import DescriptionError, JounceError
from jounce.core.findings import with_german
from jounce.core.phrases import Phrase
from jounce.core.remembered import Recent
from jounce.operations.index import operations
from jounce.operations.request import Request
from jounce.web.project import Project

if TYPE_CHECKING:
    import xarray as xr

    from jounce.parts import Rig
    from jounce.parts.differences import DescriptionDifferences
    from jounce.report.live import Viewer
    from jounce.roads import Trial

Changes = Mapping[str, float | str]


def _listed(given: Any) -> Any:
    return ([given] if given else []) if isinstance(given, str) else given


Others = Annotated[list[str], BeforeValidator(_listed), Field(max_length=5)]
"""What to compare with, or a single name: rigs, earlier versions, shipped rigs; of a trial also saved runs."""
ONE = (
    threading.Lock()
)  # a run takes milliseconds: requests are serialised, and nothing is compiled twice
MOST = 7  # curves to compare: as many as there are colours and line styles
_MOST_DONE, _LARGEST_DONE = (
    MOST + 1,
    50_000_000,
)  # cached runs, and bytes of those beyond the two being compared
_STEP, _MOST_STEPS = 1e-3, 200_000  # s between samples; maximum samples of an interactive run


@dataclass(frozen=True)
class CurvesAnswer:
    """Curves for the page, with equivalent ``python`` code, ``command``, and the ``files`` it needs."""

    viewer: Viewer | None
    equivalents: Mapping[str, Any]

    @property
    def _viewers(self) -> list[Viewer]:
        return [] if self.viewer is None else [self.viewer]

    def plain(self) -> dict[str, Any]:
        """Return the response as JSON, for scripts."""
        from jounce.report.live import live_data

        return {**live_data(self._viewers), **self.equivalents}

    def straight(self) -> bytes:
        """Return the response as binary numbers that the page draws directly."""
        from jounce.report.live import live_bytes

        return live_bytes(self._viewers, self.equivalents)


def rig_of(project: Project, name: str) -> Rig:
    """Load a rig of the project by its path (or an earlier version), or a rig of the library by its name."""
    from jounce.core.errors import unknown
    from jounce.core.files import only_below
    from jounce.parts import load
    from jounce.parts.files import library

    if "@" in name and not name.endswith(".toml"):
        return rig_in(project, *project.version(name))
    if not name.endswith(".toml"):
        if name not in library():
            raise unknown(name, library(), what="rig", where="rig")
        return _LOADED.of(name, lambda: load(name))
    file = project.inside(name)
    with only_below(project.root):
        try:
            text = file.read_bytes()
        except OSError:  # the error of `load` says which file would do
            return load(file)
        if b"jounce.vehicle/1" in text:  # its corners are files of their own
            return load(file)
        return _LOADED.of((file, text), lambda: load(file))


_LOADED: Recent[Rig] = Recent(4)
"""Rigs by the content of their file: a slider asks for the same at each step."""


def rig_in(project: Project, name: str, text: str) -> Rig:
    """Return the rig of a text as if it were the file at that path; nothing is saved."""
    from jounce.core.description import toml_error, toml_table
    from jounce.core.files import only_below
    from jounce.parts.files import rig_from_table

    file = project.inside(name)
    try:
        table = toml_table(text)
    except TOMLDecodeError as error:
        raise toml_error(error, name) from None
    with only_below(project.root):
        return rig_from_table(table, where=str(file), text=text)


def digest_of(rig: Rig) -> str:
    """Return the digest of a rig, by which a page detects changes of the file."""
    return sha256(rig.model_dump_json().encode()).hexdigest()


def describe_rig(rig: Rig, name: str) -> dict[str, Any]:
    """Return the parameters of a rig by path: value (SI), unit, display unit and factor, and who chooses them."""
    from jounce.core.display import display_unit
    from jounce.core.serialise import to_plain
    from jounce.design.variables import design_variables, is_constant
    from jounce.parts import rig_findings
    from jounce.parts.axles import DependentAxle
    from jounce.parts.rig import unit_of

    numbers, chosen = [], design_variables(rig)
    for path, value in rig.parameters().items():
        si = unit_of(rig, path)
        unit = display_unit(si, abs(value))
        numbers.append(
            {
                "path": path,
                "value": value,
                "si": si,
                "unit": unit.name,
                "factor": unit.factor,
                "is_constant": is_constant(path),
                "is_chosen": path in chosen,
            }
        )
    return {
        "name": name,
        "model": getattr(rig, "model", type(rig).__name__),
        "digest": digest_of(rig),
        "spatial": _is_spatial(rig),
        "is_dependent": isinstance(rig, DependentAxle),
        "numbers": numbers,
        "findings": to_plain(rig_findings(rig)),
    }


@dataclass(frozen=True)
class Beside:
    """What is shown beside a run: rigs over the same obstacle and saved runs, and a recording that begins later.

    ``measured`` is a recording of the project, with the time origin of the trial at ``begins``.
    """

    against: Sequence[str] = ()
    measured: str = ""
    begins: str = ""


def simulate_changes(
    project: Project,
    name: str,
    changes: Changes,
    trial: Mapping[str, Any],
    channels: Sequence[str] | None,
    *,
    text: str | None = None,
    beside: Beside | None = None,
    spectra: bool = False,
    numbers: Sequence[str] | None = None,
) -> CurvesAnswer:
    """Run a rig over an obstacle, unchanged and changed; return curves and equivalent code.

    With ``spectra``, spectra replace the curves over time. With ``numbers``, only these channels and the initial ones
    contain curves.
    """
    on = trial_of(project, trial)
    beside = beside or Beside()
    saved = [path for path in beside.against if path.endswith(".nc")]
    rigs = variants(project, name, changes, text, [n for n in beside.against if n not in saved])
    runs = {label: _run(rig, on) for label, rig in rigs.items()}
    for path in saved:
        runs[path] = _measured_part(project, path, "", on)
    measured = beside.measured
    if measured:
        runs[measured] = _measured_part(project, measured, beside.begins, on)
    equivalents = {
        "digest": digest_of(rigs["as it is"]),
        "differences": differences_of(rigs),
        **_equivalents_of(name, changes, trial, measured),
    }
    if spectra:
        from jounce.report.recordings import curve_viewer
        from jounce.web.spectra import spectra_of

        return CurvesAnswer(
            curve_viewer({"": spectra_of(runs)}, list(channels or []) or None), equivalents
        )
    return CurvesAnswer(_curves(runs, channels, rigs, on, numbers), equivalents)


def pasted_points(
    project: Project, rig: str, text: str | None, changes: Changes, table: str, **given: Any
) -> dict[str, Any]:
    """Return the hardpoints of a pasted table beside those of a rig with its unsaved changes."""
    from jounce.parts.corners import Corner
    from jounce.parts.importers.pasted import read_pasted_points

    corner: Any = next(iter(variants(project, rig, changes, text).values()))
    if not isinstance(corner, Corner):
        raise DescriptionError("no corner with hardpoints", where=rig)
    known = {name: value for name, value in given.items() if value}
    answer: dict[str, Any] = with_german(read_pasted_points(corner, table, **known).to_dict())
    return answer


def pasted_curve(
    table: str, over: Any, before: tuple[Sequence[Any], Sequence[Any]], **given: Any
) -> dict[str, Any]:
    """Return a pasted curve in SI beside the present one, whose values are as written; empty if it is not valid."""
    from jounce.core.units import to_si
    from jounce.parts.importers.curves import read_pasted_curve

    found = read_pasted_curve(table, over, **given).to_dict()
    units = ("m" if over == "deflection" else "m/s", "N")
    try:
        was = [[to_si(value, si) for value in part] for part, si in zip(before, units, strict=True)]
    except JounceError:
        was = [[], []]
    return found | {"before": was}


_DONE: OrderedDict[str, tuple[xr.Dataset, int]] = (
    OrderedDict()
)  # the most recent runs and their bytes: one stays while the other changes


def cached_run(key: str, make: Callable[[], xr.Dataset]) -> xr.Dataset:
    """Return the run of a key, which nobody may change, from the cache or else from ``make``."""
    with ONE:
        if key not in _DONE:
            run = make()
            _DONE[key] = run, run.nbytes
            while len(_DONE) > _MOST_DONE or (len(_DONE) > 2 and _cache_size() > _LARGEST_DONE):
                _DONE.popitem(last=False)
        _DONE.move_to_end(key)
        return _DONE[key][0]


def key_of(rig: Rig) -> str:
    """Return the key of a rig in the cache."""
    return f"{type(rig).__name__} {rig.model_dump_json()}"


def _run(rig: Rig, on: Trial) -> xr.Dataset:
    """Run a rig, without a list of what looks wrong in it, unless the result is cached."""
    from jounce.simulation.settings import RunSettings
    from jounce.simulation.solve import solve

    key = f"{key_of(rig)} {type(on.road).__name__} {on.model_dump_json()} {_file_of(on.road)}"
    return cached_run(
        key, lambda: solve(rig, on, RunSettings(), detail=_is_spatial(rig)).recording()
    )


def _cache_size() -> int:
    """Return the bytes of the cached runs."""
    return sum(size for _, size in _DONE.values())


def _file_of(road: Any) -> Any:
    """Return the state of a road's file, also of repeated roads, to detect that it has changed."""
    from jounce.core.files import state_of

    while hasattr(road, "of"):
        road = road.of
    file = getattr(road, "file", None)
    return None if file is None else state_of(file)


def _measured_part(project: Project, path: str, begins: str, on: Trial) -> xr.Dataset:
    """Return the part of a recording within a trial, on the trial's time axis."""
    import jounce as jn
    from jounce.core.units import to_si

    record, _ = jn.read_recording(project.inside(path))
    time = record["time"] - (to_si(begins, "s", where="begins") if begins.strip() else 0.0)
    part = record.assign_coords(time=time.assign_attrs(record["time"].attrs))
    part = part.isel(time=((time >= 0.0) & (time <= on.duration)).to_numpy())
    if part.sizes["time"] < 2:
        hint = "State where the trial begins in the recording."
        raise DescriptionError(
            "the recording does not overlap the trial",
            where="begins",
            found=begins,
            hint=hint,
        )
    return part


def _equivalents_of(
    name: str, changes: Changes, trial: Mapping[str, Any], measured: str
) -> dict[str, Any]:
    """Return Python code and command of a run."""
    given = {
        "rig": word(name),
        "set": changes,
        "speed": trial["speed"],
        "duration": trial["duration"],
    }
    run, command = (
        Request(operations()["simulate"], {**given, "road": road})
        for road in (dict(trial["road"]), "road.toml")
    )
    python = f"import jounce as jn\n\nrun = {run.expression()}\n"
    if measured:
        python += f"measured, findings = jn.read_recording({measured!r})\n"
    words = ["jounce", *command.words(), "--out", "run.nc"]
    road = {"kind": trial["road"]["kind"], **trial["road"]}  # the kind comes first
    return {
        "python": python,
        "command": command_line(words),
        "files": {"road.toml": tomlkit.dumps(road)},
    }


def variants(
    project: Project,
    name: str,
    changes: Changes,
    text: str | None = None,
    against: Sequence[str] = (),
) -> dict[str, Rig]:
    """Return the rig as edited in text and sliders, the saved rig if different, and rigs to compare with."""
    rig = rig_of(project, name) if text is None else rig_in(project, name, text)
    saved = rig
    if text is not None:
        try:
            saved = rig_of(project, name)
        except JounceError:  # the saved file is invalid, but the edited rig can be shown
            saved = rig
    changed = rig.with_changes(dict(changes)) if changes else rig
    rigs = {"as it is": saved} if changed == saved else {"changed": changed, "as it is": saved}
    for other in dict.fromkeys(against):
        label = name = label_of(other)
        count = 1
        while label in rigs:  # replaced within the same second
            count += 1
            label = f"{name} ({count})"
        rigs[label] = rig_of(project, other)
    return rigs


def label_of(name: str) -> str:
    """Return a name for people: of an earlier version, its file and when it was replaced (local time).

    >>> label_of("front.toml")
    'front.toml'
    """
    path, _, version = name.rpartition("@")
    moment = version.partition("-")[0]
    if not path or not moment.isdecimal():
        return name
    replaced = time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(int(moment) / 1000.0))
    return f"{path}, replaced {replaced}"


def differences_of(rigs: Mapping[str, Rig]) -> dict[str, Any] | None:
    """Return what differs between rigs as cells of a table; ``None`` for a single rig."""
    from jounce.parts.differences import compare_descriptions

    return None if len(rigs) < 2 else cells_of(compare_descriptions(rigs))


def cells_of(listed: DescriptionDifferences) -> dict[str, Any]:
    """Return differences as names and rows of texts: path, unit, then a value per description."""
    rows = []
    for row in listed.rows:
        values, unit = row.cells()
        rows.append([row.path, unit, *values])
    return {"names": list(listed.names), "rows": rows}


def _curves(
    runs: Mapping[str, xr.Dataset],
    channels: Sequence[str] | None,
    rigs: Mapping[str, Rig],
    trial: Trial | None,
    numbers: Sequence[str] | None,
) -> Viewer:
    """Return curves of all runs; the animated mechanism is the rig of the first run."""
    from jounce.plots.comparison import common_channels
    from jounce.report.recordings import curve_viewer

    rig = next(iter(rigs.values()))
    wanted = common_channels(runs, channels or None)
    return curve_viewer(
        {"": runs}, wanted, rig=rig if _is_spatial(rig) else None, trial=trial, numbers=numbers
    )


def trial_of(project: Project, table: Mapping[str, Any]) -> Trial:
    """Create a trial over one obstacle, or over the table of a road file."""
    from jounce.core.errors import unknown
    from jounce.core.files import only_below
    from jounce.roads import ROADS, Trial

    road = dict(table["road"])
    kind = str(road.pop("kind", ""))
    if kind not in ROADS:
        raise unknown(kind, ROADS, what="kind of road", where="road.kind")
    with only_below(project.root):
        trial = Trial(road=ROADS[kind](**road), speed=table["speed"], duration=table["duration"])
    if trial.duration / _STEP > _MOST_STEPS:
        most = Phrase("up to {most_steps:g} s", most_steps=_MOST_STEPS * _STEP)
        raise DescriptionError(
            "too long for an interactive run",
            where="duration",
            found=table["duration"],
            allowed=most,
        )
    return trial


def word(path: str) -> str:
    """Return a path as a word of a command, protected if it begins with a dash like an option."""
    return f"./{path}" if path.startswith("-") else path


def changed_by(changes: Changes) -> str:
    """Return Python code that changes a rig."""
    return f".with_changes({dict(changes)!r})" if changes else ""


def arguments(given: Mapping[str, Any], before: str = "") -> str:
    """Return Python code of keyword arguments, each preceded by ``before``."""
    texts = [f"{name}={value!r}" for name, value in given.items()]
    return "".join(f"{before}{text}" for text in texts) if before else ", ".join(texts)


def _is_spatial(rig: Rig) -> bool:
    """Whether a rig is a corner whose poses can be swept."""
    from jounce.parts import Corner

    return isinstance(rig, Corner)
