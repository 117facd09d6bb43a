"""Runs that were kept: written into the project with what they were made of, listed, and compared.

Beside each recording stands, in ``.jounce/history``, of which rig (by the digest of its numbers and words), changes,
trial and version of jounce it was made.
"""

from __future__ import annotations

import json
import re
import time
from collections.abc import Mapping, Sequence
from hashlib import sha256
from importlib import metadata
from typing import Any

from jounce.core.commands import command_line
from jounce.core.errors import DescriptionError, JounceError, OutputError
from jounce.core.serialise import to_json
from jounce.web.answers import Changes, Shown, digest_of, rig_of, trial_of, word
from jounce.web.project import Project

_PLACE, _RUNS = (".jounce", "history"), "runs"
_NAME = re.compile(r"[\w][\w .+-]{0,80}")
_MOST = 500


def keep(
    project: Project, name: str, changes: Changes, trial: Mapping[str, Any], title: str, digest: str = ""
) -> dict[str, Any]:
    """Run a rig and write the run into the project; give what stands in its history.

    ``digest`` is that of the rig that was looked at: a file that was changed since is another one.
    """
    import jounce as jn
    from jounce.recordings import write_recording

    if not _NAME.fullmatch(title):
        allowed = "letters, digits, spaces, dots, dashes; up to 80 of them"
        raise DescriptionError("not a name for a run", where="title", found=title, allowed=allowed)
    path = f"{_RUNS}/{title}.nc"
    file = project.inside(path)
    if file.exists():
        raise OutputError("the file exists", where=path, hint="Choose another name.")
    saved, on = rig_of(project, name), trial_of(project, trial)
    if digest and digest != digest_of(saved):
        hint = "Load it again, and make your change there."
        raise OutputError("the file was changed meanwhile", where=name, hint=hint)
    rig = saved.with_changes(dict(changes))
    run = jn.simulate(rig, on)
    made = {
        "path": path,
        "rig": name,
        "changes": dict(changes),
        "trial": dict(trial),
        "seed": trial["road"].get("seed"),
        "version": metadata.version("jounce"),
        "rig_digest": _digest(rig.model_dump(mode="json", by_alias=True)),
        "trial_digest": _digest(on.model_dump(mode="json", by_alias=True)),
        "when": time.time(),
    }
    run.attrs |= {f"jounce_{key}": value if isinstance(value, str) else to_json(value) for key, value in made.items()}
    file.parent.mkdir(parents=True, exist_ok=True)
    write_recording(run, file)
    entry = project.inside("/".join((*_PLACE, f"{sha256(path.encode()).hexdigest()[:24]}.json")))
    entry.parent.mkdir(parents=True, exist_ok=True)
    entry.write_text(to_json(made), encoding="utf-8")
    return made


def history(project: Project) -> list[dict[str, Any]]:
    """Give the runs that were kept and are still there, the newest first."""
    folder = project.root.joinpath(*_PLACE)
    found = []
    for file in folder.glob("*.json") if folder.is_dir() and not folder.is_symlink() else ():
        try:
            made = json.loads(file.read_text(encoding="utf-8"))
            if project.inside(str(made["path"])).is_file():
                found.append(made)
        except (OSError, ValueError, KeyError, TypeError, JounceError):
            continue  # not ours, or half of it
    return sorted(found, key=lambda made: -float(made.get("when") or 0.0))[:_MOST]


def compared(project: Project, paths: Sequence[str], channels: Sequence[str]) -> Shown:
    """Draw recordings of the project over each other."""
    import jounce as jn
    from jounce.report.recordings import curve_viewer

    runs = {path: jn.read_recording(project.inside(path))[0] for path in dict.fromkeys(paths)}
    lines = "".join(f"    {path!r}: jn.read_recording({path!r})[0],\n" for path in runs)
    python = f"import jounce as jn\n\nfigure = jn.plots.compare({{\n{lines}}})\n"
    command = command_line(["jounce", "plot", *map(word, runs), "--figure", "compared.png"])
    return Shown(curve_viewer({"": runs}, list(channels) or None), {"python": python, "command": command, "files": {}})


def _digest(plain: Any) -> str:
    return sha256(json.dumps(plain, sort_keys=True).encode()).hexdigest()
