"""Files to read: given by a path, or by the name of one that comes with jounce."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import resources
from pathlib import Path

from jounce.core.errors import DescriptionError, JounceError, nearest


def existing_file(path: Path | str, error: type[JounceError] = DescriptionError) -> Path:
    """Give the path of a file; where there is none, the error says so."""
    file = Path(path)
    if not file.is_file():
        what = "a folder, not a file" if file.is_dir() else "no such file"
        raise error(what, where=str(file), hint="Check the path and the name.")
    return file


def shipped_files(package: str, folder: str, suffix: str = ".toml") -> dict[str, Path]:
    """Files that come with a package: name to file.

    >>> list(shipped_files("jounce.roads", "library", ".crg"))
    ['detrended_rms_course_1in']
    """
    root = Path(str(resources.files(package))) / folder
    return {file.stem: file for file in sorted(root.glob(f"*{suffix}"))}


def chosen_file(
    name: Path | str, shipped: Mapping[str, Path], what: str, *, others: str = "a path to a .toml file"
) -> Path:
    """Find what a user names: a path (which is taken for one by its suffix, or because it exists), or a shipped file.

    >>> chosen_file("eusama", {"eusama": Path("library/eusama.toml")}, "tester").name
    'eusama.toml'
    """
    file = Path(name)
    if file.suffix == ".toml" or file.is_file():
        return file
    if str(name) not in shipped:
        raise DescriptionError(
            f"no such file and no shipped {what} of that name",
            where=str(name),
            allowed=f"{others}, or one of {', '.join(shipped)}",
            hint=nearest(str(name), shipped),
        )
    return shipped[str(name)]
