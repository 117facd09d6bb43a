"""Cache of the long records of a project, each read once in a separate process.

Cached data are stored in a folder of this server: a cache inside the project's folder could show a different record.
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
from jounce.web.formulas import is_computed, stems_of, with_formulas
from jounce.web.jobs import Jobs
from jounce.web.layouts import Formula
from jounce.web.levels import ABOUT, Levels
from jounce.web.project import Project
from jounce.web.tasks import JobSpec

_MOST_KEPT = 12
_MEMORY, _SECONDS = 6e9, 120.0  # limits for reading a record
_PIECES, _PIECE = (
    64,
    1 << 16,
)  # of a file's content, to identify it: the whole file up to 4 MB


class Records:
    """Records of a project that were viewed; the most recent ones are cached until the server stops."""

    def __init__(self, project: Project, jobs: Jobs) -> None:
        self.project, self.jobs = project, jobs
        self.lock = threading.Lock()
        self.folder: Path | None = None
        self.known: OrderedDict[str, Levels] = OrderedDict()

    def open(self, path: str) -> Levels:
        """Read a record in a separate process, unless it is cached."""
        file = self.project.inside(path)
        if not file.is_file():
            raise DescriptionError(
                "no such file", where=path, hint="Choose a record of the project."
            )
        with (
            self.lock
        ):  # a reloaded page repeats the request: a record being read is not written twice
            key = _fingerprint(file)
            if key not in self.known:
                self.known[key] = self._read(path, file, key)
            self.known.move_to_end(key)
            while len(self.known) > _MOST_KEPT:
                _, old = self.known.popitem(last=False)
                shutil.rmtree(old.folder, ignore_errors=True)
            return self.known[key]

    def compute(
        self, path: str, levels: Levels, formulas: Sequence[Formula]
    ) -> tuple[Levels, list[dict[str, Any]]]:
        """Return a record with its computed channels, and the state of each formula; compute what is not stored."""
        if not formulas:
            return levels, []
        with self.lock:
            if not all(is_computed(levels.folder, stem) for stem in stems_of(formulas)):
                question = {
                    "kind": "formulas",
                    "folder": str(levels.folder),
                    "path": path,
                    "formulas": [formula.model_dump() for formula in formulas],
                }
                self._ask(f"Computing channels of {path}", question)
        return with_formulas(levels, formulas)

    def digest(self, path: str) -> str:
        """Return what identifies the present content of a record; empty if there is no such file."""
        try:
            return _fingerprint(self.project.inside(path))
        except (JounceError, OSError):
            return ""

    def end(self) -> None:
        """Delete the cached data."""
        if self.folder is not None:
            shutil.rmtree(self.folder, ignore_errors=True)

    def equivalents(
        self, path: str, about: Mapping[str, Any], channels: Sequence[str]
    ) -> dict[str, Any]:
        """Return equivalent Python code and command, which read only known channels with a matching unit."""
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
        shutil.rmtree(folder, ignore_errors=True)  # incomplete, if the disk was full
        question = {"kind": "levels", "file": str(file), "folder": str(folder)}
        try:
            self._ask(f"Reading {path}", question)
        except Exception:
            shutil.rmtree(folder, ignore_errors=True)
            raise
        return Levels(folder, json.loads((folder / ABOUT).read_text(encoding="utf-8")))

    def _ask(self, title: str, question: dict[str, Any]) -> None:
        limits = (_MEMORY, _SECONDS)
        self.jobs.ask(
            JobSpec(title, [], limits=limits, patience=300.0, question=question, light=True)
        )


def _fingerprint(file: Path) -> str:
    """Return the fingerprint that identifies a record.

    Dates can be set, as ``cp -p`` does, and some file systems report neither a file identity nor the time of change.
    The fingerprint therefore includes pieces of the content, evenly spaced from the first byte to the last.
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


def is_known_channel(name: str, unit: str) -> bool:
    """Whether a column is read under its name: a known channel, in a unit of its quantity."""
    return _is_known(name) and _is_of(name, unit) and " #" not in name


def _is_known(name: str) -> bool:
    from jounce.recordings.schema import quantity_of

    return bool(quantity_of(name))


def _is_of(name: str, unit: str) -> bool:
    """Whether a unit is compatible with the known channel of that name."""
    from jounce.core.units import conversion_factor
    from jounce.recordings.schema import channel_unit

    try:
        return conversion_factor(unit or "1", channel_unit(name)) != 0.0
    except JounceError:
        return False
