"""The long records that a project has seen, each read once in a process of its own."""

from __future__ import annotations

import json
import os
import shutil
import tempfile
import threading
from collections.abc import Mapping, Sequence
from hashlib import sha256
from pathlib import Path
from typing import Any

from jounce.core.commands import command_line
from jounce.core.errors import DescriptionError, JounceError
from jounce.web.answers import word
from jounce.web.jobs import Jobs
from jounce.web.levels import ABOUT, Levels
from jounce.web.project import Project
from jounce.web.tasks import Doing

_PLACE, _MOST_KEPT = (".jounce", "levels"), 6
_MEMORY, _SECONDS = 6e9, 120.0  # that reading a record may take


class Records:
    """The records of a project that were looked at; what was read of them is kept beside it, the last few."""

    def __init__(self, project: Project, jobs: Jobs) -> None:
        self.project, self.jobs = project, jobs
        self.lock = threading.Lock()
        self.apart: tempfile.TemporaryDirectory[str] | None = None

    def open(self, path: str) -> Levels:
        """Read a record, in a process of its own, unless that was done."""
        file = self.project.inside(path)
        if not file.is_file():
            raise DescriptionError("no such file", where=path, hint="Choose a record of the project.")
        state = file.stat()
        key = sha256(f"{path}\0{state.st_size}\0{state.st_mtime_ns}".encode()).hexdigest()[:24]
        folder = self._place() / key
        with self.lock:  # a page that is loaded anew asks again: what is being read is not written twice
            if not (folder / ABOUT).is_file():
                self._read(path, file, folder)
        return Levels(folder, json.loads((folder / ABOUT).read_text(encoding="utf-8")))

    def ways(self, path: str, about: Mapping[str, Any], channels: Sequence[str]) -> dict[str, Any]:
        """The same in Python and on the command line, which read known channels with a unit of theirs only."""
        every = {one["name"]: one["unit"] for one in about["channels"]}
        read = [one for one in channels if _is_known(one) and _is_of(one, every[one])]
        wrong = [one for one in every if (_is_known(one) and not _is_of(one, every[one])) or " #" in one]
        others = [*wrong, *(one for one in channels if one not in read and one not in wrong)]
        python, command = "import jounce as jn\n\n", ""
        if others:
            python += f"# no known channels, or not of their unit, to be mapped with columns={{...}}: {others!r}\n"
        if read and not wrong:
            python += f"recording, findings = jn.read_recording({path!r})\n"
            python += f"figure = jn.plots.time_history(recording, {read!r})\n"
            command = command_line(["jounce", "plot", word(path), *read, "--figure", "record.png"])
        return {"python": python, "command": command, "files": {}}

    def _place(self) -> Path:
        """Where it is kept: in the project, or as long as the server lives where nothing can be written there."""
        place = self.project.inside("/".join(_PLACE))
        known = next(one for one in (place, *place.parents) if one.exists())
        if os.access(known, os.W_OK):
            return place
        self.apart = self.apart or tempfile.TemporaryDirectory(prefix="jounce-")
        return Path(self.apart.name)

    def _read(self, path: str, file: Path, folder: Path) -> None:
        question = {"kind": "levels", "file": str(file), "folder": str(folder)}
        limits = (_MEMORY, _SECONDS)
        try:
            self.jobs.ask(Doing(f"Reading {path}", [], limits=limits, patience=90.0, question=question, light=True))
        except Exception:
            shutil.rmtree(folder, ignore_errors=True)
            raise
        self._forget(folder)

    def _forget(self, new: Path) -> None:
        """Take away what was read longest ago."""
        kept = sorted((one for one in new.parent.iterdir() if one.is_dir()), key=lambda one: one.stat().st_mtime)
        for old in kept[:-_MOST_KEPT]:
            if old != new:
                shutil.rmtree(old, ignore_errors=True)


def _is_known(name: str) -> bool:
    from jounce.recordings.schema import quantity_of

    return bool(quantity_of(name))


def _is_of(name: str, unit: str) -> bool:
    """Whether a unit is one of the known channel of that name."""
    from jounce.core.units import conversion_factor
    from jounce.recordings.schema import channel_unit

    try:
        return conversion_factor(unit or "1", channel_unit(name)) != 0.0
    except JounceError:
        return False
