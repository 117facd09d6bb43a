"""Find an interpreter of a version: on the path, where version managers keep theirs, or in a Debian that has it."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

KEPT = (  # where version managers keep interpreters; their shims answer only where a version is selected
    Path(os.environ.get("PYENV_ROOT") or Path.home() / ".pyenv") / "versions",
    Path.home() / ".asdf" / "installs" / "python",
    Path.home() / ".local" / "share" / "mise" / "installs" / "python",
    Path.home() / ".local" / "share" / "uv" / "python",
)
SUITES = {"3.13": "trixie", "3.14": "sid"}  # Debian's releases by the Python that they have
_ASK = "import ensurepip, sys, venv; print('%d.%d' % sys.version_info[:2], sys.executable)"

_ENTER = 'for each in proc dev; do mount --rbind "/$each" "$0/$each" || exit; done; exec chroot "$0" env -C "$@"'


class Place(NamedTuple):
    """An interpreter, and the root folder of the system that it runs in."""

    python: str
    root: Path = Path("/")

    def folder(self, folder: Path) -> Path:
        """Where in this system a folder of ours lies."""
        return folder if self.root == Path("/") else self.root / folder.name

    def command(self, folder: Path, *words: str) -> list[str]:
        """Words that run a command within the system."""
        if self.root == Path("/"):
            return list(words)
        inside = [word.removeprefix(str(self.root)) for word in words]
        return [
            "unshare",
            "--mount",
            "sh",
            "-c",
            _ENTER,
            str(self.root),
            f"/{folder.relative_to(self.root)}",
            *inside,
        ]

    def taken(self, file: Path) -> str:
        """Take a file into the system; give its path there."""
        if self.root == Path("/"):
            return str(file)
        shutil.copy(file, self.root / "usr" / "local" / file.name)
        return f"/usr/local/{file.name}"


@cache
def place_of(version: str, uv: Path) -> Place | None:
    """Find an interpreter, or install one: by the system's packages, by uv, or in a Debian of its own."""
    for candidate in _candidates(version):
        if _answers(candidate, version):
            return Place(candidate)
    if _installed_by_apt(version):
        return Place(f"/usr/bin/python{version}")
    found = subprocess.run(
        [uv, "python", "install", "--quiet", version], capture_output=True, check=False
    )
    if found.returncode == 0:
        return next((Place(one) for one in _candidates(version) if _answers(one, version)), None)
    return _debian(version)


def _candidates(version: str) -> Iterator[str]:
    yield sys.executable
    if on_path := shutil.which(f"python{version}"):
        yield on_path
    for root in KEPT:
        yield from (
            str(file)
            for file in sorted(root.glob(f"*{version}*/bin/python{version}"), reverse=True)
        )


def _answers(python: str, version: str) -> bool:
    try:
        done = subprocess.run(
            [python, "-c", _ASK], capture_output=True, text=True, check=False, timeout=60
        )
    except OSError:
        return False
    return done.returncode == 0 and done.stdout.split()[0] == version


def _is_debian_of_ours() -> bool:
    return hasattr(os, "geteuid") and os.geteuid() == 0 and shutil.which("apt-get") is not None


def _apt(*words: str) -> bool:
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    return (
        subprocess.run(
            ["apt-get", "-qq", *words], env=environment, capture_output=True, check=False
        ).returncode
        == 0
    )


def _installed_by_apt(version: str) -> bool:
    names = [f"python{version}", f"python{version}-venv"]
    return (
        _is_debian_of_ours()
        and _apt("update")
        and _apt("install", "-y", "--no-install-recommends", *names)
    )


def _debian(version: str) -> Place | None:
    """Make a small Debian that has a version, in a folder that is used again."""
    if version not in SUITES or not _is_debian_of_ours():
        return None
    root = (
        Path(os.environ.get("JOUNCE_ROOTS") or Path.home() / ".cache" / "jounce-machines")
        / SUITES[version]
    )
    if not (root / "usr" / "bin" / f"python{version}").exists():
        if not (
            shutil.which("mmdebstrap")
            or _apt("install", "-y", "--no-install-recommends", "mmdebstrap")
        ):
            return None
        shutil.rmtree(root, ignore_errors=True)
        root.parent.mkdir(parents=True, exist_ok=True)
        wanted = f"--include=python{version},python{version}-venv,make,ca-certificates"
        fresh = '--aptopt=Acquire::Check-Valid-Until "false"'  # a mirror may be a month old
        made = ["mmdebstrap", "--variant=minbase", fresh, wanted, SUITES[version], str(root)]
        if subprocess.run(made, capture_output=True, check=False).returncode:
            return None
    certificates = [
        value
        for name, value in os.environ.items()
        if name.endswith(("_CERT", "_CERT_FILE", "_BUNDLE"))
    ]
    for file in map(Path, ["/etc/resolv.conf", "/etc/hosts", *certificates]):
        if file.is_file():
            (root / file.relative_to("/")).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, root / file.relative_to("/"))
    return Place(f"/usr/bin/python{version}", root)
