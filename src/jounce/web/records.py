"""The long records that a project has seen, each read once in a process of its own.

What was read lies in a folder of this server alone: what a project's folder brings along could show another record.
"""

from __future__ import annotations

import json
import shutil
import threading
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from hashlib import sha256
from pathlib import Path
from typing import Any

from jounce.core.commands import command_line
from jounce.core.errors import DescriptionError, JounceError
from jounce.core.files import state_of
from jounce.core.writing import lasting_folder
from jounce.web.answers import word
from jounce.web.jobs import Jobs
from jounce.web.levels import ABOUT, Levels
from jounce.web.project import Project
from jounce.web.tasks import Doing

_MOST_KEPT = 6
_MEMORY, _SECONDS = 6e9, 120.0  # that reading a record may take
_PIECES, _PIECE = (
    64,
    1 << 16,
)  # of a file's content, by which it is recognised: all of it up to 4 MB


class Records:
    """The records of a project that were looked at; the last few stay as they were read, until the server ends."""

    def __init__(self, project: Project, jobs: Jobs) -> None:
        self.project, self.jobs = project, jobs
        self.lock = threading.Lock()
        self.folder: Path | None = None
        self.known: OrderedDict[str, Levels] = OrderedDict()

    def open(self, path: str) -> Levels:
        """Read a record, in a process of its own, unless that was done."""
        file = self.project.inside(path)
        if not file.is_file():
            raise DescriptionError(
                "no such file", where=path, hint="Choose a record of the project."
            )
        with (
            self.lock
        ):  # a page that is loaded anew asks again: what is being read is not written twice
            key = _fingerprint(file)
            if key not in self.known:
                self.known[key] = self._read(path, file, key)
            self.known.move_to_end(key)
            while len(self.known) > _MOST_KEPT:
                _, old = self.known.popitem(last=False)
                shutil.rmtree(old.folder, ignore_errors=True)
            return self.known[key]

    def end(self) -> None:
        """Take away what was read."""
        if self.folder is not None:
            shutil.rmtree(self.folder, ignore_errors=True)

    def ways(self, path: str, about: Mapping[str, Any], channels: Sequence[str]) -> dict[str, Any]:
        """The same in Python and on the command line, which read known channels with a unit of theirs only."""
        every = {channel["name"]: channel["unit"] for channel in about["channels"]}
        read = [name for name in channels if _is_known(name) and _is_of(name, every[name])]
        wrong = [
            name
            for name in every
            if (_is_known(name) and not _is_of(name, every[name])) or " #" in name
        ]
        others = [*wrong, *(name for name in channels if name not in read and name not in wrong)]
        python, command = "import jounce as jn\n\n", ""
        if others:
            python += f"# no known channels, or not of their unit, to be mapped with columns={{...}}: {others!r}\n"
        if read and not wrong:
            python += f"recording, findings = jn.read_recording({path!r})\n"
            python += f"figure = jn.plots.time_history(recording, {read!r})\n"
            command = command_line(["jounce", "plot", word(path), *read, "--figure", "record.png"])
        return {"python": python, "command": command, "files": {}}

    def _read(self, path: str, file: Path, key: str) -> Levels:
        self.folder = self.folder or lasting_folder()
        folder = self.folder / key
        shutil.rmtree(folder, ignore_errors=True)  # half of it, where the disk was full
        question = {"kind": "levels", "file": str(file), "folder": str(folder)}
        limits = (_MEMORY, _SECONDS)
        try:
            self.jobs.ask(
                Doing(
                    f"Reading {path}",
                    [],
                    limits=limits,
                    patience=90.0,
                    question=question,
                    light=True,
                )
            )
        except Exception:
            shutil.rmtree(folder, ignore_errors=True)
            raise
        return Levels(folder, json.loads((folder / ABOUT).read_text(encoding="utf-8")))


def _fingerprint(file: Path) -> str:
    """What a record is recognised by.

    Dates and sizes can be set, as ``cp -p`` does, and some disks do not tell which file it is or when that was changed:
    so pieces of the content count, too, evenly spread from the first byte to the last.
    """
    state = state_of(file)
    digest, last = (
        sha256(f"{file}\0{state}".encode(errors="surrogatepass")),
        max(0, state[1] - _PIECE),
    )
    with file.open("rb") as stream:
        for place in dict.fromkeys(last * k // (_PIECES - 1) for k in range(_PIECES)):
            stream.seek(place)
            digest.update(stream.read(_PIECE))
    return digest.hexdigest()[:24]


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
