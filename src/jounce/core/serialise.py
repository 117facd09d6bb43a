"""Results as plain data and strict JSON, written without ever losing a file."""

from __future__ import annotations

import dataclasses
import json
import math
import os
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, ClassVar, cast

import numpy as np

from jounce.core.errors import OutputError


class Plain:
    """Mix-in of results (dataclasses): ``to_dict`` gives their fields as plain data.

    A class names the fields that stay out in ``left_out`` and the properties that are given beside the fields in
    ``also``; what has another shape overrides ``to_dict`` (see `plain_table`).

    Examples
    --------
    >>> @dataclasses.dataclass
    ... class Drop(Plain):
    ...     left_out = ("times",)
    ...     height: float
    ...     times: tuple[float, ...] = ()
    >>> Drop(0.08).to_dict()
    {'height': 0.08}
    """

    left_out: ClassVar[tuple[str, ...]] = ()
    also: ClassVar[tuple[str, ...]] = ()

    def to_dict(self) -> dict[str, Any]:
        """Give plain values, SI."""
        fields = (field.name for field in dataclasses.fields(cast("Any", self)))
        names = [*(name for name in fields if name not in self.left_out), *self.also]
        return plain_table({name: getattr(self, name) for name in names})


def plain_table(values: Mapping[str, Any]) -> dict[str, Any]:
    """Turn each of the values into plain data: dicts, lists, text, finite numbers and None, ready for strict JSON.

    Parameters
    ----------
    values : mapping
        Results, arrays and numbers by name; units stay as they are.

    Returns
    -------
    dict
        The same names; NaN and infinities become None.

    Examples
    --------
    >>> plain_table({"rate": np.float64(22e3), "points": np.array([0.0, np.nan]), "pair": (1, True)})
    {'rate': 22000.0, 'points': [0.0, None], 'pair': [1, True]}
    """
    return {str(key): to_plain(item) for key, item in values.items()}


def to_plain(value: Any) -> Any:
    """Turn a result into dicts, lists, text, finite numbers and None (for NaN and infinities)."""
    if isinstance(value, Plain):
        return value.to_dict()
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return {field.name: to_plain(getattr(value, field.name)) for field in dataclasses.fields(value)}
    if isinstance(value, Mapping):
        return plain_table(value)
    if isinstance(value, np.ndarray):
        return to_plain(value.tolist())
    if isinstance(value, (list, tuple)):
        return [to_plain(item) for item in value]
    if isinstance(value, np.generic):
        return to_plain(value.item())
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    return value if value is None or isinstance(value, (bool, int, str)) else str(value)


def to_json(value: Any, *, indent: int | None = 2) -> str:
    """Write a result as strict JSON text (no NaN)."""
    return json.dumps(to_plain(value), indent=indent, allow_nan=False, ensure_ascii=False)


def check_writable(path: Path | str, *, what: str = "files", suffixes: Sequence[str] = (), force: bool = False) -> Path:
    """Refuse an output of another suffix, that exists (without ``force``) or whose folder is missing; give the path."""
    file = Path(path)
    if suffixes and file.suffix.lower() not in suffixes:
        problem, allowed = f"{what} are not written in this format", ", ".join(suffixes)
        raise OutputError(problem, where=str(file), found=file.suffix, allowed=allowed)
    if file.exists() and not force:
        raise OutputError("the output exists", where=str(file), hint="Choose another name or allow it with --force.")
    if not file.parent.is_dir():
        raise OutputError("the folder of the output does not exist", where=str(file.parent), hint="Create it first.")
    return file


def write_atomically(path: Path | str, content: bytes | str, *, force: bool = False) -> Path:
    """Write a file through a temporary one and a rename, so that nobody ever sees half of it."""
    file = check_writable(path, force=force)
    with replacing(file) as temporary:
        temporary.write_bytes(content.encode() if isinstance(content, str) else content)
    return file


@dataclasses.dataclass(frozen=True)
class Formats:
    """File formats that one kind of result can be written in.

    Attributes
    ----------
    what : str
        The kind of result, as messages name it, e.g. ``"recordings"``.
    writers : mapping of str to callable
        By suffix in small letters: takes the result and the path of a file to fill.
    """

    what: str
    writers: Mapping[str, Callable[[Any, Path], object]]

    def check(self, path: Path | str, *, force: bool = False) -> Path:
        """Refuse, before the work, a file that could not be written after it; give the path."""
        return check_writable(path, what=self.what, suffixes=tuple(self.writers), force=force)

    def write(self, result: Any, path: Path | str, *, force: bool = False) -> Path:
        """Write a result in the format that the suffix names; give the path."""
        file = self.check(path, force=force)
        with replacing(file) as temporary:
            self.writers[file.suffix.lower()](result, temporary)
        return file


@contextmanager
def replacing(file: Path) -> Iterator[Path]:
    """Give a temporary file beside ``file`` that takes its place when the block ends well, and is removed otherwise."""
    handle, name = tempfile.mkstemp(dir=file.parent, prefix=f".{file.stem}.", suffix=file.suffix)
    os.close(handle)
    temporary = Path(name)
    try:
        yield temporary
        temporary.chmod(0o644)  # mkstemp made it private
        temporary.replace(file)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


def write_files(folder: Path | str, contents: Mapping[str, bytes | str], *, force: bool = False) -> list[Path]:
    """Write files below a folder, which is made: all of them, or none.

    Parameters
    ----------
    folder : path
        Where to.
    contents : mapping of str to (bytes or str)
        Content by name; a name may lie in folders of its own.
    force : bool
        Overwrite existing files.

    Returns
    -------
    list of Path
        The files.

    Raises
    ------
    OutputError
        When one of the files exists, without ``force``; then nothing is written.

    Examples
    --------
    >>> made = write_files(tempfile.mkdtemp(), {"notes.txt": "rig 2", "trials/01.csv": "time [s]"})
    >>> [file.name for file in made]
    ['notes.txt', '01.csv']
    """
    root = Path(folder)
    if root.exists() and not root.is_dir():
        raise OutputError("a file stands where the folder should be", where=str(root), hint="Choose another name.")
    files = {root / name: content for name, content in contents.items()}
    for file in files:
        if file.exists() and not force:
            check_writable(file)
    for file in files:
        file.parent.mkdir(parents=True, exist_ok=True)
    return [write_atomically(file, content, force=force) for file, content in files.items()]
