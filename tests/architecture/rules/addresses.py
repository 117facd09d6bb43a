"""No committed file records where packages are fetched from, or a path of one machine."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

_REGISTRY = re.compile(
    r"pypi[.](?:org|python[.]org)|pythonhosted[.]org|registry[.](?:npmjs|yarnpkg)[.]|anaconda[.](?:org|com)"
    r"|crates[.]io/api|proxy[.]golang[.]org|--(?:extra-)?index-url[ =]+[^-\s]|--find-links[ =]+[^-\s]",
    re.IGNORECASE,
)
_MACHINE = re.compile(
    r"(?<![\w.])/(?:wo[r]k|ro[o]t|opt)/[\w.]|/(?:ho[m]e|Us[e]rs)/\w+/|/tm[p]/\w|[A-Z]:\\\\?Users\\",
    re.ASCII,
)


def committed_files(root: Path) -> list[Path]:
    """Files that are, or are about to be, under version control."""
    command = [
        "git",
        "-C",
        str(root),
        "ls-files",
        "-z",
        "--cached",
        "--others",
        "--exclude-standard",
    ]
    names = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split("\0")
    return [root / name for name in names if name and (root / name).is_file()]


def address_problems(file: Path) -> list[str]:
    """Registry hosts and machine paths in one text file."""
    try:
        text = file.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return []
    return [
        f"{file}:{number}: {kind} {match[0]!r}"
        for number, line in enumerate(text.splitlines(), 1)
        for kind, pattern in (("registry address", _REGISTRY), ("machine path", _MACHINE))
        if (match := pattern.search(line))
    ]
