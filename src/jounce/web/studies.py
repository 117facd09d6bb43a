"""Sweeps for the page: writing a study from a form, and returning its variants as columns of numbers."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import tomlkit

from jounce.core.commands import words_of
from jounce.core.errors import DescriptionError, OutputError, unforeseen
from jounce.core.files import content_of, only_below
from jounce.core.writing import temporary_beside
from jounce.web.project import Project, Text

_MOST_ROWS = 2000  # maximum number of variants drawn on a page
_SIMPLE = {"kind", "height", "depth", "length", "start"}


def write_study(
    project: Project, path: str, study: Mapping[str, Any], was: str = ""
) -> dict[str, Any]:
    """Write a study of the schema ``jounce.sweep/1``, read it back, and return its text and number of variants.

    An invalid study is not written.
    """
    from jounce.variants.study import read_sweep

    file, rig = project.inside(path), str(study["rig"])
    if rig.endswith(".toml"):  # a study refers to it relative to its own folder
        rig = Path(os.path.relpath(project.inside(rig), file.parent)).as_posix()
    try:
        text = tomlkit.dumps({"schema": "jounce.sweep/1", **study, "rig": rig})
    except (
        ValueError,
        TypeError,
    ) as error:  # includes tomlkit's errors: TOML cannot represent None
        raise DescriptionError(
            "this cannot be written as a study", where=path, found=str(error)
        ) from None
    if file.suffix != ".toml":
        raise OutputError(
            "only descriptions are written here", where=path, allowed="a name that ends in .toml"
        )
    file.parent.mkdir(parents=True, exist_ok=True)
    trial = temporary_beside(file)  # in the folder relative to which its files are resolved
    try:
        trial.write_text(text, encoding="utf-8")
        with only_below(project.root):
            count = read_sweep(trial).count
    except DescriptionError as error:
        where = error.where.replace(str(trial), path)
        raise DescriptionError(
            error.what, where=where, found=error.found, allowed=error.allowed, hint=error.hint
        ) from None
    finally:
        trial.unlink(missing_ok=True)
    written: Text = project.write(path, text, was)
    return {"path": path, "text": text, "digest": written.digest, "count": count}


def swept(project: Project, folder: str) -> dict[str, Any]:
    """Return the finished variants of a sweep, its statistics, and each variant's parameters as a run."""
    from jounce.core.display import display_unit
    from jounce.core.serialise import to_plain
    from jounce.variants.sensitivity import metrics_of, numbers_of
    from jounce.variants.shards import load_sweep, read_kept
    from jounce.variants.summary import summarise

    place = project.inside(folder)
    sweep = read_kept(place)
    try:
        data = load_sweep(place, channels=False)
    except Exception as error:  # noqa: BLE001 - any failure on a foreign file is reported
        raise unforeseen(error, folder) from None
    if "variant" not in data.dims:
        return {
            "count": sweep.count,
            "finished": 0,
            "columns": [],
            "variants": [],
            "summary": None,
            "run": None,
        }
    finished = data.sizes["variant"]
    rows = np.unique(np.linspace(0, finished - 1, min(finished, _MOST_ROWS)).round().astype(int))
    numbers, columns = numbers_of(data), []
    has_metrics = any(
        values.dims == ("variant",) and values.dtype.kind in "fi"
        for values in data.data_vars.values()
    )
    for name in (*numbers, *(metrics_of(data) if has_metrics else ())):
        values = data[name].to_numpy()
        finite = values[np.isfinite(values)]
        unit = display_unit(
            str(data[name].attrs.get("units", "1")),
            float(abs(finite).max()) if finite.size else 1.0,
        )
        shown = [
            None if not np.isfinite(value) else float(value) * unit.factor for value in values[rows]
        ]
        about = {
            "name": name,
            "unit": unit.name,
            "factor": unit.factor,
            "is_number": name in numbers,
        }
        columns.append({**about, "values": shown})
    variants = [int(number) for number in data["variant"].to_numpy()[rows]]
    plain = to_plain(summarise(data))
    return {"count": sweep.count, "finished": finished, "columns": columns, "variants": variants, "summary": plain,
            "run": _run(project, place, str(sweep.about.get("command", "")))}  # fmt: skip


def _run(project: Project, place: Path, command: str) -> dict[str, Any] | None:
    """Return the trial of a variant in the form of the trials page; ``None`` if that page cannot show it."""
    words = words_of(command) if command.startswith("jounce sweep ") else []
    named = next((word for word in words[2:] if word.endswith(".toml")), None)
    try:
        study = project.inside(named) if named else place / "study.toml"
        table = tomllib.loads(
            content_of(study if study.is_file() else place / "study.toml").decode()
        )
        rig, trial = str(table["rig"]), table["trial"]
        beside = (study.parent / rig).resolve()
        if rig.endswith(".toml"):
            rig = beside.relative_to(project.root).as_posix()
        road = trial["road"]
        if isinstance(road, Mapping):
            if not {"kind"} <= road.keys() <= _SIMPLE:
                return None
            road = dict(road)
        return {
            "rig": rig,
            "road": road,
            "speed": str(trial["speed"]),
            "duration": str(trial["duration"]),
        }
    except (OSError, ValueError, KeyError, TypeError, DescriptionError):
        return None
