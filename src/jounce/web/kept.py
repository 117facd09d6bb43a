"""Stored runs: written into the project with a record of their inputs, listed, and compared.

For each recording, ``.jounce/history`` contains an entry with the digest of the rig, the changes, the trial and the
version of jounce. The entry is written before the recording and is valid once the recording exists. A process killed
in between leaves nothing that a run of the same title would not replace.
"""

from __future__ import annotations

import contextlib
import json
import re
import time
from collections.abc import Mapping, Sequence
from hashlib import sha256
from importlib import metadata
from pathlib import Path
from typing import Any

from pydantic import BaseModel, FiniteFloat

from jounce.core.commands import command_line
from jounce.core.description import Description
from jounce.core.errors import DescriptionError, JounceError, OutputError
from jounce.core.locking import holding
from jounce.core.serialise import to_json
from jounce.core.writing import write_atomically
from jounce.web.answers import Changes, CurvesAnswer, digest_of, rig_of, trial_of, word
from jounce.web.project import Project
from jounce.web.untrusted import content, plain_json

_PLACE, _RUNS = "history", "runs"
_NAME = re.compile(r"[\w][\w .+-]{0,80}")
_MOST, _LONGEST = 500, 1_000_000  # maximum number of runs listed; maximum bytes of an entry


class _Made(BaseModel):
    """Inputs of a run; its ``number`` is greater than all earlier ones, independent of the clock time ``when``."""

    path: str
    rig: str
    changes: dict[str, Any]
    trial: dict[str, Any]
    seed: int | None
    version: str
    rig_digest: str
    trial_digest: str
    when: FiniteFloat
    number: int = 0


def keep(
    project: Project,
    name: str,
    changes: Changes,
    trial: Mapping[str, Any],
    title: str,
    digest: str = "",
) -> dict[str, Any]:
    """Run a rig and write the run into the project; return its history entry.

    ``digest`` is that of the displayed rig; the run is refused if the file has changed since.
    """
    import jounce as jn
    from jounce.recordings import write_recording

    if not _NAME.fullmatch(title):
        allowed = "up to 80 letters, digits, spaces, dots or dashes"
        raise DescriptionError(
            "invalid name for a run", where="title", found=title, allowed=allowed
        )
    path = f"{_RUNS}/{title}.nc"
    file = project.inside(path)
    taken = OutputError("the file already exists", where=path, hint="Choose another name.")
    if file.exists() and _read_entry(_entry(project, path)) is not None:
        raise taken
    saved, on = rig_of(project, name), trial_of(project, trial)
    if digest and digest != digest_of(saved):
        hint = "Reload the file and make your change again."
        raise OutputError("the file has changed since it was loaded", where=name, hint=hint)
    rig = saved.with_changes(dict(changes))
    run = jn.simulate(rig, on)
    made = {
        "path": path,
        "rig": name,
        "changes": dict(changes),
        "trial": dict(trial),
        "seed": trial["road"].get("seed"),
        "version": metadata.version("jounce"),
        "rig_digest": digest_of_inputs(rig),
        "trial_digest": digest_of_inputs(on),
        "when": time.time(),
    }
    run.attrs |= {
        f"jounce_{key}": value if isinstance(value, str) else to_json(value)
        for key, value in made.items()
    }
    with holding(project.root):  # of two concurrent runs with the same title, the second is refused
        made["number"] = max((earlier["number"] for earlier in history(project)), default=0) + 1
        entry = _entry(project, path)
        if file.exists() and (_read_entry(entry) is not None or not _is_of(file, made)):
            raise taken
        entry.parent.mkdir(parents=True, exist_ok=True)
        write_atomically(entry, to_json(made), force=True)
        file.parent.mkdir(parents=True, exist_ok=True)
        if not file.exists():
            write_recording(run, file)
    return made


def history(project: Project) -> list[dict[str, Any]]:
    """Return the stored runs that still exist, newest first."""
    runs = []
    with contextlib.suppress(OutputError):  # a link exists at their location
        for file in project.own(_PLACE).glob("*.json"):
            made = _read_entry(file)
            with contextlib.suppress(JounceError, OSError):
                if made is not None and project.inside(made["path"]).is_file():
                    runs.append(made)
    return sorted(runs, key=lambda made: (made["number"], made["when"]), reverse=True)[:_MOST]


def _entry(project: Project, path: str) -> Path:
    return project.own(_PLACE, f"{sha256(path.encode()).hexdigest()[:24]}.json")


def _read_entry(entry: Path) -> dict[str, Any] | None:
    """Read the history entry of a run; ``None`` if it is missing or invalid."""
    try:
        return _Made.model_validate(plain_json(content(entry, _LONGEST))).model_dump()
    except (OSError, ValueError):  # includes pydantic's errors
        return None


def _is_of(file: Path, made: Mapping[str, Any]) -> bool:
    """Whether a recording is the run to be stored, written earlier without its history entry."""
    import h5netcdf

    try:
        with h5netcdf.File(file) as run:
            return all(
                run.attrs.get(f"jounce_{key}") == made[key]
                for key in ("rig_digest", "trial_digest")
            )
    except Exception:  # noqa: BLE001 - an unreadable recording is a different one
        return False


def compare_recordings(
    project: Project, paths: Sequence[str], channels: Sequence[str]
) -> CurvesAnswer:
    """Overlay recordings of the project."""
    import jounce as jn
    from jounce.report.recordings import curve_viewer

    runs = {path: jn.read_recording(project.inside(path))[0] for path in dict.fromkeys(paths)}
    lines = "".join(f"    {path!r}: jn.read_recording({path!r})[0],\n" for path in runs)
    python = f"import jounce as jn\n\nfigure = jn.plots.compare({{\n{lines}}})\n"
    command = command_line(["jounce", "plot", *map(word, runs), "--figure", "compared.png"])
    return CurvesAnswer(
        curve_viewer({"": runs}, list(channels) or None),
        {"python": python, "command": command, "files": {}},
    )


def digest_of_inputs(description: Description) -> str:
    """Return the digest by which a run names its rig and its trial."""
    plain = description.model_dump(mode="json", by_alias=True)
    return sha256(json.dumps(plain, sort_keys=True).encode()).hexdigest()
