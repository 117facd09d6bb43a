"""Cache of the long records of a project, each read once in a separate process.

Cached data are stored in a folder of this server, and in the user's cache folder for the next one: a cache inside the
project's folder could show a different record.
"""

from __future__ import annotations

import contextlib
import json
import shutil
import threading
import time
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from jounce.analysis.layouts import Formula
from jounce.core.commands import command_line
from jounce.core.errors import DescriptionError, JounceError
from jounce.core.files import state_of
from jounce.core.writing import lasting_folder
from jounce.web.answers import word
from jounce.web.formulas import is_computed, stems_of
from jounce.web.jobs import Jobs
from jounce.web.known_channels import is_known, is_of_its_unit
from jounce.web.level_store import digest_of_pieces, keep, restore, store_folder
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
        self.turns: dict[str, threading.Lock] = {}
        self.begun: dict[str, float] = {}  # s, by the path of each record that is being read

    def open(self, path: str) -> Levels:
        """Read a record in a separate process, unless it is cached."""
        file = self.project.inside(path)
        if not file.is_file():
            raise DescriptionError(
                "no such file", where=path, hint="Choose a record of the project."
            )
        key = _fingerprint(file)
        with self._turn(key):  # a reloaded page repeats the request
            levels = self.known.get(key) or self._read(path, file, key)
            with self.lock:
                self.known[key] = levels
                self.known.move_to_end(key)
                while len(self.known) > _MOST_KEPT:
                    name, old = self.known.popitem(last=False)
                    self.turns.pop(name, None)
                    shutil.rmtree(old.folder, ignore_errors=True)
        return levels

    def compute(
        self, opened: Mapping[str, Levels], formulas: Sequence[Formula]
    ) -> dict[str, JounceError]:
        """Compute the formulas that are not stored yet, and return what failed, by record.

        All records share one process. If that fails, such as for want of memory, each has a process of its own.
        """
        stems = stems_of(formulas)
        failed: dict[str, JounceError] = {}
        with contextlib.ExitStack() as turns:
            for name in sorted({levels.folder.name for levels in opened.values()}):
                turns.enter_context(self._turn(name))
            lacking = {
                path: levels
                for path, levels in opened.items()
                if not all(is_computed(levels.folder, stem) for stem in stems)
            }
            if len(lacking) > 1:
                with contextlib.suppress(JounceError):
                    self._compute(lacking, formulas)
                    return {}
            for path, levels in lacking.items():
                try:
                    self._compute({path: levels}, formulas)
                except JounceError as error:
                    failed[path] = error
        return failed

    def _compute(self, records: Mapping[str, Levels], formulas: Sequence[Formula]) -> None:
        question = {
            "kind": "formulas",
            "records": {path: str(levels.folder) for path, levels in records.items()},
            "formulas": [formula.model_dump() for formula in formulas],
        }
        self._ask(f"Computing channels of {', '.join(records)}", question)

    def reading(self) -> list[dict[str, Any]]:
        """Return the records that are being read: path, the share that is read if known, and time so far in s."""
        return [
            {
                "path": path,
                "share": self.jobs.share_of(_title(path)),
                "seconds": time.monotonic() - begun,
            }
            for path, begun in self.begun.copy().items()
        ]

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
        read = [name for name in channels if is_known(name) and is_of_its_unit(name, every[name])]
        wrong = [
            name
            for name in every
            if (is_known(name) and not is_of_its_unit(name, every[name])) or " #" in name
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

    def _turn(self, key: str) -> threading.Lock:
        with self.lock:
            return self.turns.setdefault(key, threading.Lock())

    def _read(self, path: str, file: Path, key: str) -> Levels:
        with self.lock:
            self.folder = self.folder or lasting_folder(store_folder())
        folder = self.folder / key
        shutil.rmtree(folder, ignore_errors=True)  # incomplete, if the disk was full
        if not restore(key, folder):
            question = {"kind": "levels", "file": str(file), "folder": str(folder)}
            self.begun[path] = time.monotonic()
            try:
                self._ask(_title(path), question)
            except Exception:
                shutil.rmtree(folder, ignore_errors=True)
                raise
            finally:
                self.begun.pop(path, None)
            keep(key, folder)
        return Levels(folder, json.loads((folder / ABOUT).read_text(encoding="utf-8")))

    def _ask(self, title: str, question: dict[str, Any]) -> None:
        limits = (_MEMORY, _SECONDS)
        self.jobs.ask(
            JobSpec(title, [], limits=limits, patience=300.0, question=question, light=True)
        )


def _title(path: str) -> str:
    return f"Reading {path}"


def _fingerprint(file: Path) -> str:
    """Return the fingerprint that identifies a record.

    Dates can be set, as ``cp -p`` does, and some file systems report neither a file identity nor the time of change.
    The fingerprint therefore includes pieces of the content, evenly spaced from the first byte to the last.
    """
    digest = digest_of_pieces(file, _PIECES, _PIECE)
    digest.update(f"{file}\0{state_of(file)}".encode(errors="surrogatepass"))
    return str(digest.hexdigest()[:24])
