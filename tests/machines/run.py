"""Run the tests where jounce was not made: on other interpreters, with other versions of what it depends on.

``make test-machines`` runs the whole suite on every machine of the table below, ``.ci/run`` the quick part of some
(``--quick``). Interpreters and packages get a copy of the checkout each, so none uses what another has compiled. Other
processors are played in the checkout itself, by what hangs on rounding. Logs and the summary are written to
``build/machines``.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import time
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, Literal

from numpy._core import (
    _multiarray_umath as built_numpy,
)  # there is no public list of what it can do without

from interpreters import Place, place_of
from jounce.kernel.machine import levels

ROOT = Path(__file__).parents[2]
BUILD = ROOT / "build" / "machines"
UV = Path(sys.executable).with_name("uv")
OTHERS = {
    "MAKEFLAGS",
    "MAKELEVEL",
    "PYTHONPATH",
    "PYTHONHOME",
    "VIRTUAL_ENV",
}  # would lead a machine back to this one
_LEFT_OUT = (
    ".git",
    ".venv*",
    ".*_cache",
    ".hypothesis",
    "__pycache__",
    "node_modules",
    "_build",
    "build",
    "built",
)
RED, PLAIN = "\033[31m", "\033[0m"


def configuration() -> dict[str, Any]:
    """Read ``pyproject.toml``."""
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))


def promised() -> list[str]:
    """Versions of Python that the classifiers name, the oldest first."""
    classifiers = configuration()["project"]["classifiers"]
    names = [name.rpartition(" ")[2] for name in classifiers if "Python :: 3." in name]
    return sorted(names, key=lambda name: int(name.partition(".")[2]))


HERE = f"{sys.version_info.major}.{sys.version_info.minor}"
OLDEST, NEWEST = promised()[0], promised()[-1]
THREADS = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")
SPARED = [name for name in built_numpy.__cpu_dispatch__ if built_numpy.__cpu_features__[name]]
QUICK = (
    "core",
    "kernel",
    "parts",
    "recordings",
    "simulation",
    "kinematics",
    "kc",
    "test_imports.py",
)
"""Unit tests that --quick runs on other interpreters and packages: what depends on them, and the engine."""
READERS = ("core", "recordings", "test_imports.py")
"""Those that it runs with other versions of packages."""
NOT_HERE = 77  # what debian.sh ends with where it cannot make one


@dataclass(frozen=True)
class Machine:
    """A row of the table: what the tests run on, and which of them."""

    name: str
    python: str = OLDEST
    # wheel: runtime pins, and jounce as a wheel; here: what runs this; debian: NumPy and SciPy of a newer Debian
    packages: Literal["pinned", "lowest", "newest", "wheel", "here", "debian"] = "pinned"
    environment: Mapping[str, str] = field(default_factory=dict)
    arguments: tuple[str, ...] = ()  # of pytest
    quick: bool = False  # whether `.ci/run` tries it, with --quick


MACHINES = (
    *(Machine(f"python-{version}", version, quick=version in {OLDEST, NEWEST} - {HERE}) for version in promised()),
    # Old packages warn of what has become of the ones they use.
    Machine("lowest", OLDEST, "lowest", arguments=("-o", "filterwarnings=default"), quick=True),
    Machine("newest", NEWEST, "newest"),
    *(
        Machine(f"wheel-{version}", version, "wheel", quick=version != NEWEST)  # whose tests --quick runs, too
        for version in promised() if version != HERE
    ),
    *(
        Machine(
            f"noise-{seed}", HERE, "here", arguments=("--rounded", f"--rounding-noise={seed}", f"--shuffle={seed}"),
            quick=seed == 1,
        )
        for seed in range(1, 6)
    ),
    Machine("threads-4", HERE, "here", dict.fromkeys(THREADS, "4"), ("--rounded",)),
    # Not with --quick, which compiles nothing: that sines are right at each level is a test of every run.
    *(
        Machine(
            level, HERE, "here", {"JOUNCE_PROCESSOR": level, "NPY_DISABLE_CPU_FEATURES": " ".join(SPARED)},
            ("--rounded",),
        )
        for level in levels()
    ),
    # Making a Debian takes longer than its tests: by hand.
    *(Machine(f"debian-{blas}", HERE, "debian", arguments=("--rounded",)) for blas in ("blas", "blis-serial")),
)  # fmt: skip


class Failed(Exception):
    """A step of a machine failed."""


class NotRun(Exception):
    """A machine cannot be had here."""


@dataclass
class Run:
    """One machine at work."""

    machine: Machine
    place: Place
    quick: bool

    def __post_init__(self) -> None:
        self.log = BUILD / f"{self.machine.name}.log"
        self.log.unlink(missing_ok=True)
        self.is_here = self.machine.packages in {"here", "debian"}
        self.folder = ROOT if self.is_here else copied(self.place.folder(BUILD) / self.machine.name)
        self.python = self.folder / ".venv" / ("Scripts" if os.name == "nt" else "bin") / "python"

    def call(self, *words: object) -> None:
        """Run a command in the machine's copy; what it says goes to the log."""
        kept = {name: value for name, value in os.environ.items() if name not in OTHERS}
        with self.log.open("a", encoding="utf-8") as log:
            log.write(f"\n$ {' '.join(map(str, words))}\n")
            log.flush()
            environment = {**kept, **self.machine.environment}
            command = self.place.command(self.folder, *map(str, words))
            done = subprocess.run(
                command, cwd=self.folder, env=environment, stdout=log, stderr=log, check=False
            )
        if done.returncode == NOT_HERE and self.is_here:
            raise NotRun(self.log.read_text(encoding="utf-8").strip().rpartition("\n")[2])
        if done.returncode:
            raise Failed(f"{' '.join(map(str, words))[:100]}: see {self.log}")

    def all(self) -> None:
        """Set up, run a demonstration and the tests."""
        tests = [
            "-n",
            "auto",
            "--dist",
            "loadfile",
            *(["--quick"] if self.quick else []),
            *([f"tests/unit/{name}" for name in self._units()] if self.quick else []),
            *self.machine.arguments,
        ]
        if self.machine.packages == "here":
            self.call(sys.executable, "-m", "pytest", *tests)
            return
        if self.machine.packages == "debian":
            self.call("tests/machines/debian.sh", self.machine.name.removeprefix("debian-"), *tests)
            return
        if self.machine.packages == "pinned":
            self.call(
                "make",
                "demo",
                ".venv/.test",
                f"PYTHON={self.place.python}",
                "DEMO_ARGUMENTS=--quick --out demo",
            )
        elif self.machine.packages == "wheel":
            self._environment("-r", "requirements/runtime.txt", "--no-deps", "--require-hashes")
            self.call(
                self._uv(),
                "pip",
                "install",
                "--quiet",
                "--python",
                self.python,
                "--no-deps",
                self._wheel(),
            )
            shutil.rmtree(self.folder / "src")  # only what is installed can be used
            self.call(self.python, "-m", "jounce", "--version")
            self.call(self.python, "-m", "jounce", "demo", "--quick", "--out", "demo")
            return
        else:
            strategy = {"lowest": "lowest-direct", "newest": "highest"}[self.machine.packages]
            self.call(
                self._uv(), "pip", "compile", "--quiet", "--python", self.place.python, "--resolution", strategy,
                "--all-extras", "--group", "test", "--group", "build", "pyproject.toml", "-o", "versions.txt",
            )  # fmt: skip
            self._environment("-r", "versions.txt")
            self.call(
                self._uv(), "pip", "install", "--quiet", "--python", self.python, "--no-deps", "--no-build-isolation",
                "--editable", ".",
            )  # fmt: skip
            if not self.quick:  # the demonstration makes those that it needs
                self.call(self.python, "-m", "jounce.kernel.loops.make")
            self.call(self.python, "-m", "jounce", "demo", "--quick", "--out", "demo")
        self.call(self.python, "-m", "pytest", *tests)

    def _units(self) -> tuple[str, ...]:
        """Return unit tests of --quick: what is rounded here, the engine on other interpreters, else readers."""
        return {"here": (), "debian": (), "pinned": QUICK}.get(self.machine.packages, READERS)

    def _environment(self, *wanted: str) -> None:
        self.call(self._uv(), "venv", "--quiet", "--python", self.place.python, ".venv")
        self.call(
            self._uv(),
            "pip",
            "install",
            "--quiet",
            "--only-binary",
            ":all:",
            "--python",
            self.python,
            *wanted,
        )

    def _uv(self) -> str:
        return self.place.taken(UV)

    def _wheel(self) -> str:
        return self.place.taken(wheel())


@cache
def wheel() -> Path:
    """Build the wheel on the interpreter that runs this."""
    made, loops = copied(BUILD / "wheel"), Path("src", "jounce", "kernel", "loops", "built")
    if (ROOT / loops).exists():  # what this interpreter has made already takes minutes
        shutil.copytree(ROOT / loops, made / loops)
    command = [
        sys.executable,
        "-m",
        "pip",
        "wheel",
        "--quiet",
        "--no-deps",
        "--no-build-isolation",
        "-w",
        "dist",
        ".",
    ]
    subprocess.run(command, cwd=made, check=True, capture_output=True)
    return next((made / "dist").glob("*.whl"))


def copied(folder: Path) -> Path:
    """Copy the checkout as it is, without what was made in it."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(ROOT, folder, ignore=shutil.ignore_patterns(*_LEFT_OUT), symlinks=True)
    return folder


def results(machines: list[Machine], *, quick: bool) -> Iterator[tuple[Machine, str]]:
    """Run machines one after another; give what became of each."""
    for machine in machines:
        started = time.monotonic()
        place = place_of(machine.python, UV)
        if place is None:
            yield (
                machine,
                f"not run: no Python {machine.python} was found, and none could be installed",
            )
            continue
        run = Run(machine, place, quick)
        try:
            run.all()
        except NotRun as error:
            yield machine, f"not run: {error}"
        except (Failed, subprocess.CalledProcessError) as error:
            yield machine, f"FAILED: {error}"
        else:
            said = (
                run.log.read_text(encoding="utf-8").strip().rpartition("\n")[2]
                if run.log.exists()
                else ""
            )
            yield machine, f"passed in {time.monotonic() - started:.0f} s: {said.strip('= ')}"
            if not run.is_here:
                shutil.rmtree(run.folder, ignore_errors=True)


def main() -> int:
    """Run what is asked for, and write the summary."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "names", nargs="*", metavar="MACHINE", help=f"of {', '.join(one.name for one in MACHINES)}"
    )
    parser.add_argument(
        "--quick", action="store_true", help="a demonstration and the quick tests, as in .ci/run"
    )
    asked = parser.parse_args()
    chosen = [
        one
        for one in MACHINES
        if one.name in asked.names or (not asked.names and (one.quick or not asked.quick))
    ]
    if unknown := set(asked.names) - {one.name for one in MACHINES}:
        parser.error(f"no such machine: {', '.join(sorted(unknown))}")
    BUILD.mkdir(parents=True, exist_ok=True)
    ran, bad, lines = {HERE} if asked.quick else set(), False, []
    for machine, result in results(chosen, quick=asked.quick):
        has_run = not result.startswith("not run")
        ran |= {machine.python} if has_run else set()
        bad |= result.startswith("FAILED")
        lines.append(f"{machine.name}: {result}")
        print(lines[-1] if result.startswith("passed") else f"{RED}{lines[-1]}{PLAIN}", flush=True)
    if not asked.names:
        lines += [
            f"Python {version}: promised, and not run"
            for version in promised()
            if version not in ran
        ]
    (BUILD / "summary.txt").write_text("\n".join([*lines, ""]), encoding="utf-8")
    return int(bad)


if __name__ == "__main__":
    sys.exit(main())
