"""Refuse to execute files that a different user could have written.

A checksum detects damage, not malice: anyone who can write a code file can run code as the user of jounce. The user,
root, and users who can write jounce itself are trusted; nobody else may be able to write the file, its folder, or any
folder or link in its path.
"""

from __future__ import annotations

import os
import stat
from functools import cache
from pathlib import Path

_MOST_LINKS = 40


class ForeignError(OSError):
    """A different user could have written the file; ``filename`` is the part of its path that others can write."""


def read_own(file: Path) -> bytes:
    """Return the content of a file that only trusted users can write.

    Raises
    ------
    ForeignError
        If a different user could have written it.
    OSError
        If there is no such regular file that can be read.
    """
    place = _check_path(file)
    # Opened first and then examined, to be sure that it is the same file. A pipe must not block.
    flags = (
        os.O_RDONLY
        | getattr(os, "O_NONBLOCK", 0)
        | getattr(os, "O_BINARY", 0)
        | getattr(os, "O_NOFOLLOW", 0)
    )
    with os.fdopen(os.open(place, flags), "rb") as stream:
        status = os.fstat(stream.fileno())
        if not stat.S_ISREG(status.st_mode):
            raise FileNotFoundError(place)
        _check(status, place)
        return stream.read()


def own_folder(folder: Path) -> Path:
    """Create a folder with its parents in which nobody else can write, and return its path.

    Raises
    ------
    ForeignError
        If a different user can write there.
    OSError
        If it cannot be created.
    """
    for path in (*reversed(folder.parents), folder):
        path.mkdir(mode=0o755, exist_ok=True)  # independent of the umask
    return _check_path(folder / "file").parent


def _check_path(file: Path) -> Path:
    """Resolve the path of a file; check every folder and link in it.

    The check starts at the root: entries of a folder that only trusted users can write cannot change after the check.
    In a folder with the sticky bit, such as /tmp, this is true for entries they own.
    """
    if os.name != "posix":  # owners and modes have no meaning there
        return file
    waiting, here, links = list(reversed(file.absolute().parts[1:])), Path("/"), 0
    while waiting:
        _check_folder(here, last=len(waiting) == 1)
        name = waiting.pop()
        if name == "..":
            here = here.parent
            continue
        try:
            status = (here / name).lstat()
        except FileNotFoundError:
            if waiting:
                raise
            return here / name
        if not stat.S_ISLNK(status.st_mode):
            here /= name
            continue
        if status.st_uid not in _trusted_users() or (links := links + 1) > _MOST_LINKS:
            raise ForeignError(None, "a link of another user", str(here / name))
        target = Path((here / name).readlink())
        waiting += reversed(target.parts[target.is_absolute() :])
        here = Path("/") if target.is_absolute() else here
    return here


def _check_folder(folder: Path, *, last: bool) -> None:
    """Refuse a folder in which others can replace the path; for the ``last`` one also if they can add files."""
    if folder in Path(__file__).resolve().parents:
        return  # users who can write there can also write jounce
    status = folder.lstat()
    if not stat.S_ISDIR(status.st_mode):
        raise NotADirectoryError(folder)
    _check(status, folder, sticky_will_do=not last)


def _check(status: os.stat_result, where: Path, *, sticky_will_do: bool = False) -> None:
    if os.name != "posix":
        return
    own = Path(__file__).stat()
    others = status.st_mode & ~own.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
    if status.st_gid != own.st_gid:
        others |= status.st_mode & stat.S_IWGRP
    if others & stat.S_IWGRP and _is_private(status.st_gid, status.st_uid):
        others &= ~stat.S_IWGRP
    if sticky_will_do and status.st_mode & stat.S_ISVTX:
        others = 0
    if status.st_uid not in _trusted_users() or others:
        raise ForeignError(None, "belongs to another user or can be written by others", str(where))


def _trusted_users() -> tuple[int, ...]:
    return (os.geteuid(), Path(__file__).stat().st_uid, 0)


@cache
def _is_private(group: int, user: int) -> bool:
    """Whether a group is a user's private group: of the same name, without other members."""
    import grp
    import pwd

    try:
        private, owner = grp.getgrgid(group), pwd.getpwuid(user)
    except KeyError:
        return False
    return (
        private.gr_name == owner.pw_name
        and owner.pw_gid == group
        and set(private.gr_mem) <= {owner.pw_name}
    )
