"""The project folder of a workbench: listing, and reading and writing of files strictly within it."""

from __future__ import annotations

import contextlib
import os
import re
import time
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from hashlib import sha256
from pathlib import Path
from stat import S_ISDIR, S_ISREG
from typing import Any

from jounce.core.errors import DescriptionError, JounceError, OutputError
from jounce.core.files import State, content_of, state_of
from jounce.core.locking import holding
from jounce.core.writing import write_atomically
from jounce.web.untrusted import content

_DEEPEST, _MOST = 6, 2000  # maximum folder depth and number of files listed
_OWN, _MOST_OWN = (
    ".jounce",
    100_000,
)  # folder for the workbench's own files; maximum number of sweep files counted
_HEAD = 4096  # bytes within which a description declares its kind
_SCHEMA = re.compile(rb"""^\s*schema\s*=\s*["']jounce\.([a-z-]+)/1["']""", re.MULTILINE)
_ROAD = re.compile(rb"^\s*kind\s*=", re.MULTILINE)
_ROW = re.compile(rb"^\s*[-+]?[\d.][\d.,eE+-]*[\s;,]+[-+]?\.?\d", re.MULTILINE)
RECORDS = (
    ".nc", ".nc4", ".csv", ".tsv", ".txt", ".dat", ".mat", ".mf4", ".mdf", ".parquet", ".pq", ".xlsx", ".xlsm",
    ".tdms", ".lvm", ".uff", ".uf", ".unv", ".rsp", ".rpc", ".rpc3", ".tim", ".drv", ".ld", ".vbo", ".sst",
)  # fmt: skip
"""Suffixes of measured or simulated files: those of all readers."""
RESULTS = "results.json"
"""Name of the file that a campaign writes into its folder."""
_PAGES, _RESULTS, _STORES = (".html", ".pdf"), (RESULTS,), (".sqlite",)
LONGEST, _LONGEST_READ = (
    2_000_000,
    20_000_000,
)  # maximum bytes of a description written, and of one read
_SWEPT = "sweep.json"
_VERSIONS, _MOST_VERSIONS = "versions", 50
_VERSION = re.compile(r"\d{10,15}-[0-9a-f]{8}")  # ms since 1970, and the start of the digest


@dataclass(frozen=True)
class Entry:
    """One file of a project: path in the folder, kind, and modification time (s since 1970).

    A sweep is one entry: its folder, with the number of ``finished`` shards and the total ``count``. A rig with
    ``has_hardpoints`` supports kinematic sweeps, a rig or vehicle that ``has_axle`` can be tested on the K&C rig;
    ``is_dependent`` is a solid axle or twist beam, which only that rig takes.
    """

    path: str
    kind: str
    size: int
    modified: float
    finished: int | None = None
    count: int | None = None
    has_hardpoints: bool = False
    has_axle: bool = False
    is_dependent: bool = False


@dataclass(frozen=True)
class Text:
    """Content of a description, and its digest, used to detect changes by others."""

    path: str
    text: str
    digest: str


@dataclass(frozen=True)
class Version:
    """An earlier version of a description: its name, ``path@version``, and time of replacement (s since 1970)."""

    name: str
    replaced: float


class Project:
    """A folder and its content; nothing outside it is accessible, not even through links."""

    def __init__(self, folder: Path | str) -> None:
        self.root = Path(folder).resolve(strict=True)

    def inside(self, path: str) -> Path:
        """Resolve a path with slashes relative to the folder; an error if it leads outside."""
        allowed = "a file below the project's folder, by its path relative to it"
        try:
            file = (self.root / path).resolve()
            plain = (
                not path.startswith(("/", "\\"))
                and file.is_relative_to(self.root)
                and file != self.root
            )
        except (OSError, ValueError, RuntimeError):  # an invalid name, or circular links
            plain = False
        if not plain:
            raise DescriptionError(
                "not a path in this project", where="path", found=path, allowed=allowed
            )
        return file

    def own(self, *parts: str) -> Path:
        """Return a path for the workbench's own files, without following links in the project."""
        place = self.root
        for part in (_OWN, *parts):
            place /= part
            if place.is_symlink():
                where = place.relative_to(self.root).as_posix()
                hint = "Remove the link, or replace it by a folder."
                raise OutputError(
                    "a link occupies a path reserved for the workbench's own files",
                    where=where,
                    hint=hint,
                )
        return place

    def entries(self) -> list[Entry]:
        """List the files, folder by folder; the output of a sweep is one entry, its pages are separate entries."""
        entries: list[Entry] = []
        files = list(self._files())
        swept = {
            file.parent: sweep
            for file in files
            if file.name == _SWEPT and (sweep := self._swept(file))
        }
        for file in files:
            if file.name == _SWEPT and file.parent in swept:
                entries.append(swept[file.parent])
                continue
            with contextlib.suppress(OSError):  # deleted meanwhile, or not readable
                kind = _kind(file)
                if kind and not (kind == "results" and file.parent in swept):
                    state = file.stat()
                    path = file.relative_to(self.root).as_posix()
                    is_rig = kind in ("rig", "vehicle")
                    table = _model_of(file, state_of(file)) if is_rig else {}
                    entries.append(
                        Entry(
                            path,
                            kind,
                            state.st_size,
                            state.st_mtime,
                            has_hardpoints=has_hardpoints(table),
                            has_axle=has_axle(table),
                            is_dependent=is_dependent(table),
                        )
                    )
            if len(entries) == _MOST:
                break
        return entries

    def _swept(self, manifest: Path) -> Entry | None:
        """Return the folder of a sweep, with its progress if readable; ``None`` for the project itself."""
        folder = manifest.parent
        if folder == self.root:
            return None
        from jounce.variants.shards import read_kept

        finished: int | None = None
        count: int | None = None
        try:
            sweep = read_kept(folder)
            finished, count = len(sweep.names()), len(sweep.spans)
        except (OSError, ValueError, JounceError):
            pass  # the reason is reported when it is opened
        size, modified = _extent(folder)
        return Entry(
            folder.relative_to(self.root).as_posix(), "swept", size, modified, finished, count
        )

    def read(self, path: str) -> Text:
        """Read a description."""
        file = self.inside(path)
        written = content_of(file, most=_LONGEST_READ)
        if len(written) > LONGEST:
            raise DescriptionError(
                "too long for a description", where=path, found=f"{len(written)} bytes"
            )
        try:
            return Text(path, written.decode(), _digest(written))
        except UnicodeDecodeError:
            raise DescriptionError(
                "not a text", where=path, allowed="a description in UTF-8"
            ) from None

    def write(self, path: str, text: str, was: str = "") -> Text:
        """Write a description; ``was`` is the digest of the replaced content, empty for a new file."""
        file = self.inside(path)
        if file.suffix.lower() != ".toml":
            raise OutputError(
                "only descriptions are written here",
                where=path,
                allowed="a name that ends in .toml",
            )
        written = text.encode()
        if len(written) > LONGEST:
            raise OutputError(
                "too long for a description", where=path, found=f"{len(written)} bytes"
            )
        with holding(
            self.root
        ):  # of two concurrent saves, even from two servers, the second detects the first
            before = content_of(file, most=_LONGEST_READ) if file.exists() else None
            if before is not None and _digest(before) != was:
                hint = (
                    "Reload the file and make your change again." if was else "Choose another name."
                )
                what = (
                    "the file has changed since it was loaded" if was else "the file already exists"
                )
                raise OutputError(what, where=path, hint=hint)
            file.parent.mkdir(parents=True, exist_ok=True)
            if before is not None:
                self._keep(file, before)
            write_atomically(file, written, force=before is not None)
        return Text(path, text, _digest(written))

    def versions(self, path: str) -> list[Version]:
        """Return earlier versions of a description that were replaced here, newest first."""
        return [
            Version(f"{path}@{name}", float(name.partition("-")[0]) / 1000.0)
            for name in reversed(_versions(self._versions_of(self.inside(path))))
        ]

    def version(self, name: str) -> tuple[str, str]:
        """Return path and text of an earlier version by its name, ``path@version``."""
        path, _, version = name.rpartition("@")
        place = self._versions_of(self.inside(path))
        if _VERSION.fullmatch(version):
            with contextlib.suppress(OSError, ValueError):  # deleted, or not created by jounce
                return path, content(place / f"{version}.toml", LONGEST).decode()
        known = [version.name for version in self.versions(path)]
        raise DescriptionError(
            "no such version", where="rig", found=name, allowed=", ".join(known[:5]) or "none"
        )

    def _versions_of(self, file: Path) -> Path:
        return self.own(_VERSIONS, *file.relative_to(self.root).parts)

    def _keep(self, file: Path, written: bytes) -> None:
        """Store the present version of a description as the newest, regardless of the clock, before it is replaced."""
        folder = self._versions_of(file)
        folder.mkdir(parents=True, exist_ok=True)
        known = _versions(folder)
        with contextlib.suppress(OSError, ValueError):
            if known and content(folder / f"{known[-1]}.toml", _LONGEST_READ) == written:
                return  # already stored by a save that failed later
        newest = int(known[-1].partition("-")[0]) if known else 0
        name = f"{max(time.time_ns() // 1_000_000, newest + 1)}-{_digest(written)[:8]}"
        write_atomically(folder / f"{name}.toml", written, force=True)
        for old in known[: 1 - _MOST_VERSIONS]:
            (folder / f"{old}.toml").unlink(missing_ok=True)

    def _files(self) -> Iterator[Path]:
        """Yield regular files sorted by name, without hidden files and without following links."""
        for folder, folders, files in os.walk(self.root):
            here = Path(folder)
            depth = len(here.relative_to(self.root).parts)
            own = (
                here != self.root and _SWEPT in files
            )  # shards, and the arrays of a Zarr group, are not user files
            folders[:] = sorted(
                name
                for name in folders
                if _is_text(name)
                and not name.startswith((".", "__"))
                and depth < _DEEPEST
                and not (own and (name == "shards" or (here / name / ".zarray").is_file()))
            )
            for name in sorted(files):
                with contextlib.suppress(OSError):  # not readable
                    if (
                        _is_text(name)
                        and not name.startswith(".")
                        and S_ISREG((here / name).lstat().st_mode)
                    ):
                        yield here / name


def _extent(folder: Path) -> tuple[int, float]:
    """Return the total bytes of the files in a folder, and the latest modification time (s since 1970)."""
    waiting, size, modified = [folder], 0, 0.0
    for _ in range(_MOST_OWN):
        if not waiting:
            break
        with contextlib.suppress(OSError):  # a running sweep renames its files
            path = waiting.pop()
            state = path.lstat()
            modified = max(modified, state.st_mtime)
            if S_ISDIR(state.st_mode):
                waiting += path.iterdir()
            elif S_ISREG(state.st_mode):
                size += state.st_size
    return size, modified


def _versions(folder: Path) -> list[str]:
    """Return the names of the versions in a folder, oldest first."""
    names = (file.stem for file in folder.glob("*.toml") if _VERSION.fullmatch(file.stem))
    return sorted(names, key=lambda name: int(name.partition("-")[0]))


def unusable(error: OSError, where: str) -> OutputError:
    """Convert system errors (full disk, name too long, missing permission) into clear messages."""
    hint = "Check the path, the permissions and the free disk space."
    return OutputError(
        "cannot be read or written", where=where, found=error.strerror or str(error), hint=hint
    )


def _is_text(name: str) -> bool:
    """Whether a name is valid UTF-8: file systems also accept other names."""
    try:
        name.encode()
    except UnicodeEncodeError:
        return False
    return True


def _digest(written: bytes) -> str:
    return sha256(written).hexdigest()


def _kind(file: Path) -> str:
    suffix = file.suffix.lower()
    if suffix == ".toml":
        try:
            with file.open("rb") as stream:
                head = stream.read(_HEAD)
        except OSError:
            return ""
        schema = _SCHEMA.search(head)
        if schema and schema[1] == b"sweep" and _is_written(file):
            return "results"
        return schema[1].decode() if schema else "road" if _ROAD.search(head) else ""
    if suffix == ".crg":
        return "road"
    if suffix in _PAGES:
        return "page"
    if suffix in _STORES:
        return "store"
    if file.name in _RESULTS:
        return "results"
    if suffix not in RECORDS or (suffix in (".txt", ".dat") and not _is_table(file)):
        return ""
    return "results" if _is_written(file) else "record"


def has_hardpoints(table: Mapping[str, Any]) -> bool:
    """Whether a rig is a corner with hardpoints, whose kinematics can be swept."""
    return "hardpoints" in table and not is_dependent(table)


def is_dependent(table: Mapping[str, Any]) -> bool:
    """Whether a rig is a solid axle or a twist beam."""
    return table.get("model") in _DEPENDENT


def has_axle(table: Mapping[str, Any]) -> bool:
    """Whether a rig or vehicle can be tested on the K&C rig."""
    return "hardpoints" in table or table.get("model") == "full-car-3d"


_DEPENDENT = ("solid-axle", "twist-beam")


@lru_cache(256)
def _model_of(file: Path, state: State) -> Mapping[str, Any]:
    """Return the model of a rig, and its hardpoints if it has some, in the given state of the file."""
    try:
        table = tomllib.loads(file.read_text(encoding="utf-8-sig")) if state[1] <= LONGEST else {}
    except (OSError, ValueError, RecursionError):
        return {}
    return {key: table[key] for key in ("model", "hardpoints") if key in table}


def _is_table(file: Path) -> bool:
    """Whether a text contains rows of numbers, as measurements do, unlike a read-me file."""
    try:
        with file.open("rb") as stream:
            head = stream.read(_HEAD)
    except OSError:
        return False
    return b"\0" in head or _ROW.search(head) is not None


def _is_written(file: Path) -> bool:
    """Whether a file was written by a sweep, a campaign or a search: results, not inputs."""
    folder = file.parent.parent if file.parent.name == "shards" else file.parent
    return any((folder / name).is_file() for name in (*_RESULTS, _SWEPT))
