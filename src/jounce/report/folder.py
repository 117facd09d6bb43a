"""A folder of files, written whole or not at all."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Mapping
from pathlib import Path

from jounce.core.errors import OutputError


def check_folder(out: Path | str, *, force: bool = False) -> Path:
    """Refuse a folder that holds something (without ``force``) or a file of that name; give its resolved path.

    Raises
    ------
    OutputError
        With the path and what to do.
    """
    folder = Path(out).expanduser().resolve()
    if folder.exists() and not folder.is_dir():
        raise OutputError("the output is a file, not a folder", where=str(folder), hint="Choose another name.")
    if folder.is_dir() and not force and any(folder.iterdir()):
        raise OutputError(
            "the output folder is not empty", where=str(folder), hint="Choose another name or allow it with --force."
        )
    return folder


def write_folder(out: Path | str, files: Mapping[str, bytes | str], *, force: bool = False) -> list[Path]:
    """Write files into a folder through a temporary one beside it, so that nobody ever sees half of them.

    Parameters
    ----------
    out : Path or str
        Folder; made where it is missing. With ``force``, files of the same names in it are replaced, others stay.
    files : mapping of str to bytes or str
        Path within the folder to content.
    force : bool
        Write into a folder that is not empty.

    Returns
    -------
    list of Path
        The files, in the order given.

    Raises
    ------
    OutputError
        For a folder that is not empty, a file in its place, or a disk that refuses; nothing is changed then.

    Examples
    --------
    >>> folder = Path(tempfile.mkdtemp()) / "report"
    >>> [file.name for file in write_folder(folder, {"report.html": "<p>", "figures/one.svg": "<svg/>"})]
    ['report.html', 'one.svg']
    """
    folder = check_folder(out, force=force)
    _check_targets(folder, files)
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        built = Path(tempfile.mkdtemp(dir=folder.parent, prefix=f".{folder.name}."))
    except OSError as error:
        raise _refused(folder, error) from error
    try:
        for name, content in files.items():
            target = built / name
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content.encode() if isinstance(content, str) else content)
        _put_in_place(built, folder, files)
    except OSError as error:
        raise _refused(folder, error) from error
    finally:
        shutil.rmtree(built, ignore_errors=True)
    return [folder / name for name in files]


def _check_targets(folder: Path, files: Mapping[str, bytes | str]) -> None:
    for name in files:
        target = folder / name
        if not target.resolve().is_relative_to(folder):
            raise OutputError("the file would lie outside the output folder", where=str(folder), found=name)
        if target.is_dir():
            raise OutputError("a file cannot be written where a folder is", where=str(target))
        if any(parent.is_file() for parent in target.parents if parent.is_relative_to(folder)):
            raise OutputError("a folder cannot be made where a file is", where=str(target.parent))


def _put_in_place(built: Path, folder: Path, files: Mapping[str, bytes | str]) -> None:
    """Rename the whole folder where nothing is in its way, otherwise file by file."""
    built.chmod(0o755)
    if not folder.exists() or not any(folder.iterdir()):
        if folder.exists():
            folder.rmdir()
        built.rename(folder)
        return
    for name in files:
        target = folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        os.replace(built / name, target)  # noqa: PTH105 - replaces in one step on every system


def _refused(folder: Path, error: OSError) -> OutputError:
    return OutputError(
        "the folder cannot be written",
        where=str(folder),
        found=error.strerror or str(error),
        hint="Check the path, the permissions and the space on the disk.",
    )
