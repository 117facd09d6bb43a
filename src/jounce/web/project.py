"""The folder that a workbench is opened on: what lies in it, and files read and written without ever leaving it."""

from __future__ import annotations

import contextlib
import os
import re
import time
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from hashlib import sha256
from pathlib import Path
from stat import S_ISREG

from jounce.core.errors import DescriptionError, JounceError, OutputError
from jounce.core.files import State, content_of, state_of
from jounce.core.writing import write_atomically

_DEEPEST, _MOST = 6, 2000  # folders below each other, and files, that are listed
_HEAD = 4096  # bytes in which a description says what it is
_SCHEMA = re.compile(rb"""^\s*schema\s*=\s*["']jounce\.([a-z-]+)/1["']""", re.MULTILINE)
_ROAD = re.compile(rb"^\s*kind\s*=", re.MULTILINE)
_ROW = re.compile(rb"^\s*[-+]?[\d.][\d.,eE+-]*[\s;,]+[-+]?\.?\d", re.MULTILINE)
RECORDS = (
    ".nc", ".nc4", ".csv", ".tsv", ".txt", ".dat", ".mat", ".mf4", ".mdf", ".parquet", ".pq", ".xlsx", ".xlsm",
    ".tdms", ".lvm", ".uff", ".uf", ".unv",
)  # fmt: skip
"""Suffixes of files that were measured, or simulated: those of all readers."""
_PAGES, _RESULTS, _STORES = (".html", ".pdf"), ("results.json",), (".sqlite",)
LONGEST = 2_000_000  # bytes of a description
_SWEPT = "sweep.json"
_VERSIONS, _MOST_VERSIONS = (".jounce", "versions"), 50
_VERSION = re.compile(r"\d{10,16}-[0-9a-f]{8}")


@dataclass(frozen=True)
class Entry:
    """One file of a project: its place in the folder, what it is, and when it was written (s since 1970).

    A sweep is one entry: its folder, with the shards that are ``finished`` and the ``count`` of all. A rig that
    ``has_hardpoints`` has kinematics.
    """

    path: str
    kind: str
    size: int
    modified: float
    finished: int | None = None
    count: int | None = None
    has_hardpoints: bool = False


@dataclass(frozen=True)
class Text:
    """Content of a description, and its digest, by which a later change by somebody else is noticed."""

    path: str
    text: str
    digest: str


@dataclass(frozen=True)
class Version:
    """What a description was: its name, ``path@version``, and when it was replaced (s since 1970)."""

    name: str
    replaced: float


class Project:
    """A folder and what is below it; nothing else can be reached, also through links."""

    def __init__(self, folder: Path | str) -> None:
        self.root = Path(folder).resolve(strict=True)

    def inside(self, path: str) -> Path:
        """Give the file of a path with slashes, relative to the folder; refuse what lies, or leads, elsewhere."""
        allowed = "a file below the project's folder, by its path relative to it"
        try:
            file = (self.root / path).resolve()
            plain = not path.startswith(("/", "\\")) and file.is_relative_to(self.root) and file != self.root
        except (OSError, ValueError, RuntimeError):  # a name that is none, links in a circle
            plain = False
        if not plain:
            raise DescriptionError("not a place in this project", where="path", found=path, allowed=allowed)
        return file

    def entries(self) -> list[Entry]:
        """List what is here, folder by folder; what a sweep wrote is one entry, its pages beside it."""
        found: list[Entry] = []
        files = list(self._files())
        swept = {file.parent: sweep for file in files if file.name == _SWEPT and (sweep := self._swept(file))}
        for file in files:
            if file.name == _SWEPT and file.parent in swept:
                found.append(swept[file.parent])
                continue
            kind = _kind(file)
            if kind and not (kind == "results" and file.parent in swept):
                state = file.stat()
                path = file.relative_to(self.root).as_posix()
                is_spatial = kind == "rig" and _has_hardpoints(file, state_of(file))
                found.append(Entry(path, kind, state.st_size, state.st_mtime, has_hardpoints=is_spatial))
            if len(found) == _MOST:
                break
        return found

    def _swept(self, manifest: Path) -> Entry | None:
        """Give the folder of a sweep, with how far it is where that can be read; none for the project itself."""
        folder = manifest.parent
        if folder == self.root:
            return None
        from jounce.variants.shards import read_kept

        files = []
        for one in folder.rglob("*"):
            with contextlib.suppress(OSError):  # a sweep that runs renames what it has written
                files.append(one.stat())
        finished: int | None = None
        count: int | None = None
        try:
            kept = read_kept(folder)
            finished, count = len(kept.names()), len(kept.spans)
        except (OSError, ValueError, JounceError):
            pass  # opened, it says why
        size, modified = (
            sum(one.st_size for one in files if S_ISREG(one.st_mode)),
            max((one.st_mtime for one in files), default=0.0),
        )
        return Entry(folder.relative_to(self.root).as_posix(), "swept", size, modified, finished, count)

    def read(self, path: str) -> Text:
        """Read a description."""
        file = self.inside(path)
        content = content_of(file)
        if len(content) > LONGEST:
            raise DescriptionError("too long for a description", where=path, found=f"{len(content)} bytes")
        try:
            return Text(path, content.decode(), _digest(content))
        except UnicodeDecodeError:
            raise DescriptionError("not a text", where=path, allowed="a description in UTF-8") from None

    def write(self, path: str, text: str, was: str = "") -> Text:
        """Write a description; ``was`` is the digest of what it replaces, and nothing for a new file."""
        file = self.inside(path)
        if file.suffix.lower() != ".toml":
            raise OutputError("only descriptions are written here", where=path, allowed="a name that ends in .toml")
        if file.exists() and _digest(content_of(file)) != was:
            hint = "Load it again, and make your change there." if was else "Choose another name."
            what = "the file was changed meanwhile" if was else "the file exists"
            raise OutputError(what, where=path, hint=hint)
        content = text.encode()
        if len(content) > LONGEST:
            raise OutputError("too long for a description", where=path, found=f"{len(content)} bytes")
        file.parent.mkdir(parents=True, exist_ok=True)
        if file.exists():
            self._keep(file)
        write_atomically(file, content, force=bool(was))
        return Text(path, text, _digest(content))

    def versions(self, path: str) -> list[Version]:
        """What a description was before it was written anew from here, the newest first."""
        folder = self._kept(self.inside(path))
        found = sorted((one for one in folder.glob("*.toml") if _VERSION.fullmatch(one.stem)), reverse=True)
        return [Version(f"{path}@{one.stem}", float(one.stem.partition("-")[0]) / 1000.0) for one in found]

    def version(self, name: str) -> tuple[str, str]:
        """Give path and text of an earlier version by its name, ``path@version``."""
        path, _, version = name.rpartition("@")
        file = self._kept(self.inside(path)) / f"{version}.toml"
        if not _VERSION.fullmatch(version) or not file.is_file():
            known = [one.name for one in self.versions(path)] if path else []
            raise DescriptionError("no such version", where="rig", found=name, allowed=", ".join(known[:5]) or "none")
        return path, content_of(file).decode()

    def _kept(self, file: Path) -> Path:
        own = "/".join((*_VERSIONS, *file.relative_to(self.root).parts))
        return self.inside(own)  # also where somebody has put a link there

    def _keep(self, file: Path) -> None:
        """Keep what a description is before it is written anew."""
        content, folder = content_of(file), self._kept(file)
        folder.mkdir(parents=True, exist_ok=True)
        write_atomically(folder / f"{time.time_ns() // 1_000_000}-{_digest(content)[:8]}.toml", content, force=True)
        for old in sorted(folder.glob("*.toml"))[:-_MOST_VERSIONS]:
            old.unlink(missing_ok=True)

    def _files(self) -> Iterator[Path]:
        """Regular files, without hidden ones and without following links, in the order of their names."""
        for folder, folders, files in os.walk(self.root):
            here = Path(folder)
            depth = len(here.relative_to(self.root).parts)
            own = (
                here != self.root and _SWEPT in files
            )  # shards, and the arrays of a Zarr group, are no files of anybody
            folders[:] = sorted(
                name
                for name in folders
                if not name.startswith((".", "__"))
                and depth < _DEEPEST
                and not (own and (name == "shards" or (here / name / ".zarray").is_file()))
            )
            for name in sorted(files):
                file = here / name
                if not name.startswith(".") and file.is_file() and not file.is_symlink():
                    yield file


def unusable(error: OSError, where: str) -> OutputError:
    """Say of a full disk, a name that is too long or a missing permission what it is."""
    hint = "Check the path, the permissions and the space on the disk."
    return OutputError("cannot be read or written", where=where, found=error.strerror or str(error), hint=hint)


def _digest(content: bytes) -> str:
    return sha256(content).hexdigest()


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


@lru_cache(256)
def _has_hardpoints(file: Path, state: State) -> bool:
    """Whether the text of a rig has them, as it is in that state."""
    try:
        return state[1] <= LONGEST and "hardpoints" in tomllib.loads(file.read_text(encoding="utf-8-sig"))
    except (OSError, ValueError, RecursionError):
        return False


def _is_table(file: Path) -> bool:
    """Whether a text holds rows of numbers, as measurements do, and a file that asks to be read does not."""
    try:
        with file.open("rb") as stream:
            head = stream.read(_HEAD)
    except OSError:
        return False
    return b"\0" in head or _ROW.search(head) is not None


def _is_written(file: Path) -> bool:
    """Whether a sweep, a campaign or a search wrote it: what it found, and nothing to begin with."""
    folder = file.parent.parent if file.parent.name == "shards" else file.parent
    return any((folder / name).is_file() for name in (*_RESULTS, _SWEPT))
