"""Change one package in one place at a time and see whether its tests notice: ``make mutants PACKAGE=ride``.

Cosmic Ray makes the changes; here a random sample of them is drawn, each is tried in a process of its own that has the
libraries loaded already (so a mutant costs its tests, not four seconds of imports), and what went unnoticed is shown.
No file is changed. A mutant is held first against the tests that run the changed line, then against all the package's
own tests: ``tests/unit/PACKAGE`` and those of other kinds that use what the package makes public. Which test runs which
line, and how long it takes, is kept in ``build/mutants`` until the package or the test changes.
"""

from __future__ import annotations

import argparse
import ast
import ctypes
import functools
import gc
import hashlib
import importlib
import itertools
import json
import os
import pkgutil
import random
import re
import shutil
import signal
import sys
import tempfile
import time
import tomllib
import traceback
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path

os.environ |= {
    "OMP_NUM_THREADS": "1",
    "OPENBLAS_NUM_THREADS": "1",
}  # set before NumPy comes: a fork keeps no threads

import pytest
from coverage import CoverageData
from planted import plant as give
from positions import Mutant, mutants

ROOT = Path(__file__).parents[2]
SOURCES = ROOT / "src" / "jounce"
HARMLESS = Path(__file__).parent / "harmless.toml"
KEPT = ROOT / "build" / "mutants"
KINDS = ("physics", "reference", "properties")
PROOF = {"identify": ("recovery", "measured")}
"""Kinds of tests beside unit tests that use a package, and those that it is proven by (other kinds take minutes)."""
LIBRARIES = (
    "casadi",
    "h5py",
    "hypothesis.extra.numpy",
    "matplotlib",
    "numba",
    "numpy",
    "pydantic",
    "pint",
    "scipy.signal",
)
LIBRARIES += ("scipy.optimize", "tomlkit", "typer", "xarray")
CHEAP = ("tests/unit", "tests/architecture")
GOAL, BROKEN = 0.9, 70
PR_SET_PDEATHSIG = 1  # of linux/prctl.h
PATIENCE, COMPILING = 10.0, 60.0
"""With a mutant a test may take this many times as long as the slowest of its file without, and this many seconds."""
ENOUGH = 30.0
"""Seconds of tests, the quickest first, that a mutant is held against; all of them where a place is given."""
QUIET = ("-p", "no:cacheprovider", "-W", "ignore::pytest.PytestAssertRewriteWarning")
IDLE = ("-p", "no:unraisableexception", "-p", "no:cov", "-p", "no:xdist")
"""Plugins that a mutant's process would wait for: one collects garbage twice, of all libraries."""


def main() -> int:
    """Draw, try, tell; 1 where fewer than nine in ten were noticed."""
    asked = arguments()
    files = sources_of(asked.package)
    if not files:
        sys.exit(f"there is no package src/jounce/{asked.package}")
    for library in LIBRARIES:
        importlib.import_module(library)
    pool = [mutant for mutant in mutants(files) if wanted(mutant, asked.place)]
    sample = random.Random(asked.seed).sample(pool, min(asked.sample, len(pool)))
    print(f"{asked.package}: {len(sample)} of {len(pool)} mutants, seed {asked.seed}", flush=True)
    sweep()
    with tempfile.TemporaryDirectory(prefix=f"jounce-mutants-{os.getpid()}-") as folder:
        tests = Tests(asked.package, Path(folder), float("inf") if asked.place else ENOUGH)
        load_what_stands_below(asked.package)
        tests.stand_unchanged()
        end, seen = time.monotonic() + 60.0 * asked.minutes, {}
        for mutant in sample:
            if time.monotonic() < end:
                seen[mutant] = show(mutant, verdict(mutant, tests))
    return told(asked.package, seen)


def arguments() -> argparse.Namespace:
    """What was asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("package", help="a package of src/jounce")
    parser.add_argument("--sample", type=int, default=200, help="how many mutants")
    parser.add_argument("--seed", type=int, default=1, help="of the random sample")
    parser.add_argument(
        "--minutes",
        type=float,
        default=float("inf"),
        help="how long mutants are tried; random order",
    )
    parser.add_argument(
        "--place", default="", metavar="FILE[:LINE]", help="only mutants of this file, on this line"
    )
    return parser.parse_args()


def sources_of(package: str) -> list[Path]:
    """Modules of a package."""
    return sorted(file for file in (SOURCES / package).rglob("*.py") if file.name != "__init__.py")


def wanted(mutant: Mutant, place: str) -> bool:
    """Whether a mutant lies where it was asked for."""
    name, _, line = place.partition(":")
    return mutant.file.name.startswith(name) and (not line or mutant.line == int(line))


# --- the tests of a package ------------------------------------------------------------------------------------------


class Tests:
    """A package's own tests, which of them run which line, and how long each takes."""

    def __init__(self, package: str, folder: Path, enough: float) -> None:
        self.package, self.folder, self.enough = package, folder, enough
        self.cache = folder / "models"
        kept = KEPT / package
        coverage, report = kept / "coverage", kept / "times.json"
        sources = digest(*sources_of(package))
        known = json.loads(report.read_text(encoding="utf-8")) if report.exists() else {}
        if known.get("sources") != sources:
            shutil.rmtree(kept, ignore_errors=True)
            kept.mkdir(parents=True)
            known = {"sources": sources, "files": {}}
        files = {name: digest(ROOT / name.partition("::")[0]) for name in own_tests(package)}
        known["files"] = {
            name: row for name, row in known["files"].items() if row["digest"] == files.get(name)
        }
        new = [name for name in files if name not in known["files"]]
        print("\n".join(["its tests:", *files, f"of them to be timed: {len(new)}"]), flush=True)
        if new:
            os.environ["COVERAGE_FILE"] = str(coverage)
            measured = [
                f"--cov=jounce.{package}",
                "--cov-context=test",
                "--cov-report=",
                "--cov-append",
            ]
            times = folder / "times.json"
            if apart(
                lambda: run_tests([*new, *measured], Clock(kept / "models"), times), 3600
            ) not in (0, 1):
                sys.exit("the tests cannot be run: see above")
            readers = [name for name in new if package == "recordings" and package in name]
            if readers:  # what a child does to a file, no coverage sees
                apart(lambda: run_tests([*readers, *measured], Childless(kept / "models")), 3600)
            seconds = json.loads(times.read_text(encoding="utf-8"))
            for name in new:
                own = {
                    test: taken
                    for test, taken in seconds.items()
                    if name in (test, test.partition("::")[0])
                }
                known["files"][name] = {"digest": files[name], "seconds": own}
            report.write_text(json.dumps(known), encoding="utf-8")
        self.seconds: dict[str, float] = {}
        for row in known["files"].values():
            self.seconds |= row["seconds"]
        self._runs = CoverageData(str(coverage))
        self._runs.read()
        shutil.copytree(kept / "models", self.cache, dirs_exist_ok=True)
        if (
            apart(
                lambda: run_tests(["--collect-only", *self.seconds], Clock(self.cache)),
                600,
                quiet=True,
            )
            != 0
        ):
            sys.exit("the tests cannot be asked for by their names")
        print(f"{len(self.seconds)} tests, {sum(self.seconds.values()):.0f} s", flush=True)

    def stand_unchanged(self) -> None:
        """Stop where the package's unit tests fail with a copy of a module that is no mutant: they would notice all."""
        file = sources_of(self.package)[-1]
        unit = [test for test in self.seconds if test.startswith(f"tests/unit/{self.package}/")]
        if self.notice(
            file, file.read_text(encoding="utf-8"), self._quick_first(unit, self.enough)
        ):
            sys.exit("its tests fail with the package as it is, in the way that mutants are tried")

    def of(self, mutant: Mutant) -> Iterator[list[str]]:
        """First the tests that run the changed statement, then unit tests and examples in the same files.

        The second round is for what is computed once for several tests. A name of the module is run where it is used;
        anything else that runs when a module is loaded is the business of all tests in the files that use it.
        """
        runs = self._runs.contexts_by_lineno(str(mutant.file))
        near = {
            context.rpartition("|")[0]
            for line in statements(mutant)
            for context in runs.get(line, ())
        } - {""}
        used = near or {
            context.rpartition("|")[0] for contexts in runs.values() for context in contexts
        } - {""}
        files = {test.partition("::")[0] for test in used}
        rest = {
            test for test in self.seconds if test.partition("::")[0] in files or not files
        } - near
        yield self._quick_first(near, self.enough)
        yield self._quick_first(
            {test for test in rest if not near or test.startswith(CHEAP)}, self.enough
        )

    def _quick_first(self, tests: Iterable[str], enough: float = float("inf")) -> list[str]:
        """The package's unit tests, then physics and references, then what uses it; by time, until it is enough."""
        own = (f"tests/unit/{self.package}/", "tests/architecture")
        rank = {
            test: 0 if test.startswith(own) else 2 if test.startswith(CHEAP) else 1
            for test in tests
        }
        known = sorted(
            (rank[test], self.seconds[test], test) for test in tests if test in self.seconds
        )
        ends = itertools.accumulate(seconds for _, seconds, _ in known)
        return [
            test
            for (_, seconds, test), end in zip(known, ends, strict=True)
            if end - seconds < enough
        ]

    def notice(self, file: Path, source: str, tests: Sequence[str]) -> bool:
        """Whether one of some tests fails, or does not end, with another text in the place of a file."""
        slowest: dict[str, float] = {}
        for test, seconds in self.seconds.items():
            name = test.partition("::")[0]
            slowest[name] = max(slowest.get(name, 0.0), seconds)

        def code(asked: Iterable[str]) -> int:
            def changed() -> int:
                plant(file, source, self.package, self.folder)
                limits = {name: COMPILING + PATIENCE * seconds for name, seconds in slowest.items()}
                return run_tests(["-x", *IDLE, *asked], Clock(self.cache, limits))

            return apart(changed, COMPILING, quiet=True)  # and each test has its own time

        found = code(tests)
        if (
            found == pytest.ExitCode.USAGE_ERROR
        ):  # a test goes by another name now, or its file cannot be loaded
            found = code(dict.fromkeys(test.partition("::")[0] for test in tests))
        return found != 0


def digest(*files: Path) -> str:
    """Digest of the texts of some files."""
    return hashlib.sha256(b"\0".join(file.read_bytes() for file in files)).hexdigest()


def load_what_stands_below(package: str) -> None:
    """Load the packages that import nothing of this one: a mutant's process has them, and none of what it changes."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    contracts = project["tool"]["importlinter"]["contracts"]
    layers = next(
        [layer.strip("()") for layer in one["layers"]]
        for one in contracts
        if one["type"] == "layers"
    )
    for below in reversed(layers[layers.index(package) + 1 :]):
        loaded = importlib.import_module(f"jounce.{below}")
        for module in pkgutil.walk_packages(loaded.__path__, f"jounce.{below}."):
            importlib.import_module(module.name)
    gc.freeze()


def own_tests(package: str) -> list[str]:
    """Its unit tests, the examples in its docstrings, and files of other kinds that use it or a public function of it.

    What is loaded, or described by a class (a road, a controller), is only driven with in most files.
    """
    stub = (SOURCES / "__init__.pyi").read_text(encoding="utf-8")
    names = re.findall(rf"^from \.{package}\b[\w.]* import ((?!load_)[a-z]\w*)", stub, re.MULTILINE)
    uses = re.compile(
        "|".join([rf"\b(jounce|jn)\.{package}\b", *(rf"\bjn\.{name}\b" for name in names)])
    )
    imports = re.compile(rf"^from jounce\.{package}\b", re.MULTILINE)
    unit = ROOT / "tests" / "unit"
    files = [
        (file, uses) for kind in KINDS for file in sorted((ROOT / "tests" / kind).glob("test_*.py"))
    ]
    others = [file for file in sorted(unit.glob("*/test_*.py")) if file.parent.name != package]
    for kind in ("hostile", *PROOF.get(package, ())):
        others += sorted((ROOT / "tests" / kind).glob("test_*.py"))
    files += [(file, imports) for file in others]
    named = [file for file, words in files if words.search(file.read_text(encoding="utf-8"))]
    modules = (
        file.relative_to(SOURCES.parent).with_suffix("").parts for file in sources_of(package)
    )
    examples = "tests/architecture/test_docstrings.py::test_examples_are_true"
    return [
        *(
            str(file.relative_to(ROOT))
            for file in [*sorted((unit / package).rglob("test_*.py")), *named]
        ),
        *(f"{examples}[{'.'.join(parts)}]" for parts in modules),
    ]


def statements(mutant: Mutant) -> set[int]:
    """Lines of the smallest statement around a mutant, and of those that use a name which it gives to the module.

    Of a statement that holds others only the lines before them count.
    """
    tree = ast.parse(mutant.file.read_text(encoding="utf-8"))
    spans = []
    for node in ast.walk(tree):
        if isinstance(node, ast.stmt | ast.excepthandler):
            body = getattr(node, "body", None)
            first = min(part.lineno for part in (node, *getattr(node, "decorator_list", ())))
            span = range(
                first, max(node.lineno + 1, body[0].lineno) if body else node.end_lineno + 1
            )
            if mutant.line in span:
                spans.append((len(span), node.lineno, span, node))
    if not spans:  # a case
        return {mutant.line}
    _, _, own, node = min(spans, key=lambda found: found[:2])
    given = {
        part.id
        for part in ast.walk(node)
        if isinstance(part, ast.Name) and isinstance(part.ctx, ast.Store)
    }
    names = given if node in tree.body and isinstance(node, ast.Assign | ast.AnnAssign) else set()
    return {
        *own,
        *(
            part.lineno
            for part in ast.walk(tree)
            if isinstance(part, ast.Name) and part.id in names
        ),
    }


class Clock:
    """Notes how long tests take, ends the process where one takes longer than its file may, shares compiled models.

    Sharing is what `tests/conftest.py` would not let processes do.
    """

    def __init__(self, cache: Path, limits: Mapping[str, float] | None = None) -> None:
        self.cache, self.limits, self.seconds, self.failed = cache, limits or {}, {}, set()

    @pytest.hookimpl(trylast=True)
    def pytest_configure(self) -> None:
        self.cache.mkdir(exist_ok=True)
        os.environ["JOUNCE_CACHE_DIR"] = str(self.cache)

    def pytest_runtest_logstart(self, nodeid: str) -> None:
        if limit := self.limits.get(nodeid.partition("::")[0]):
            signal.alarm(int(limit))

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self.seconds[report.nodeid] = self.seconds.get(report.nodeid, 0.0) + report.duration
        if not report.passed:
            self.failed.add(report.nodeid)


class Childless(Clock):
    """Files are read in the process that runs the tests."""

    def pytest_collection(self) -> None:
        from jounce.recordings import readers

        readers.is_possible = lambda: False


def run_tests(options: Sequence[str], clock: Clock, times: Path | None = None) -> int:
    """Run pytest in this process; its exit code."""
    code = pytest.main(
        ["-q", "--no-header", *QUIET, "-m", "not slow and not pages", *options],
        plugins=[clock],
    )
    if times:
        passed = {
            test: seconds for test, seconds in clock.seconds.items() if test not in clock.failed
        }
        times.write_text(json.dumps(passed), encoding="utf-8")
    return int(code)


def apart(work: Callable[[], int], seconds: float, quiet: bool = False) -> int:
    """Do something in a process of its own, which is ended after some time; its exit code, negative where it was."""
    sys.stdout.flush()
    parent, child = os.getpid(), os.fork()
    if not child:
        code, told = BROKEN, os.dup(2)
        try:
            end_with(parent)
            signal.alarm(int(seconds) + 1)
            if quiet:
                for stream in (1, 2):
                    os.dup2(os.open(os.devnull, os.O_WRONLY), stream)
            code = work()
        except BaseException:  # noqa: BLE001 - a fork must never go on as its parent
            os.write(told, traceback.format_exc().encode())
        sys.stdout.flush()
        os._exit(code)
    code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    if code == BROKEN:
        sys.exit("this script failed, not a test: see above")
    return code


def end_with(parent: int) -> None:
    """Let this process end when its parent is killed, where the system can: otherwise its alarm ends it."""
    if sys.platform.startswith("linux"):
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
        if os.getppid() != parent:  # killed already
            os._exit(BROKEN)


def sweep() -> None:
    """Remove folders that killed runs left."""
    for left in Path(tempfile.gettempdir()).glob("jounce-mutants-*-*"):
        number = left.name.split("-")[2]
        if (
            number.isdecimal()
            and not Path("/proc", number).exists()
            and Path("/proc/self").exists()
        ):
            shutil.rmtree(left, ignore_errors=True)


# --- one mutant -------------------------------------------------------------------------------------------------------


def plant(file: Path, source: str, package: str, folder: Path) -> None:
    """Put another text in the place of a module, and keep what is compiled with it apart from the rest."""
    from jounce.core import sources

    copy = Path(tempfile.mkdtemp(dir=folder)) / file.name
    copy.write_text(source, encoding="utf-8")
    give(".".join(("jounce", *file.relative_to(SOURCES).with_suffix("").parts)), file, copy)
    plain = sources.digest_of.__wrapped__

    def within(name: str) -> bool:
        return name.partition("/")[0] == package

    @functools.cache
    def digest_of(*names: str) -> str:
        return plain(*names) + (str(copy) if any(map(within, names)) else "")

    for module in list(sys.modules.values()):  # those that are loaded have it under its name, too
        if getattr(module, "digest_of", None) is sources.digest_of and module is not sources:
            module.digest_of = digest_of
    sources.digest_of = digest_of


def verdict(mutant: Mutant, tests: Tests) -> str:
    """What became of a mutant: noticed, known as harmless, or unnoticed."""
    if any(tests.notice(mutant.file, mutant.source, some) for some in tests.of(mutant) if some):
        return "noticed"
    return "harmless" if reason(mutant) else "unnoticed"


def reason(mutant: Mutant) -> str | None:
    """Why a mutant changes nothing that a user sees, as the list beside this file says."""
    rows = tomllib.loads(HARMLESS.read_text(encoding="utf-8")).get(
        mutant.file.parent.relative_to(SOURCES).parts[0], []
    )
    key = (mutant.file.stem, *mutant.change)
    return next(
        (row["why"] for row in rows if (row["module"], row["before"], row["after"]) == key), None
    )


def show(mutant: Mutant, outcome: str) -> str:
    """Tell what became of a mutant, with its change where nobody noticed."""
    if outcome == "unnoticed":
        before, after = mutant.change
        print(
            f"{outcome}  {mutant.file.relative_to(ROOT)}:{mutant.line}  {mutant.operator}\n  - {before}\n  + {after}",
            flush=True,
        )
    return outcome


def told(package: str, seen: dict[Mutant, str]) -> int:
    """The last line: how many were noticed of those that matter."""
    count = {
        outcome: list(seen.values()).count(outcome)
        for outcome in ("noticed", "unnoticed", "harmless")
    }
    matter = count["noticed"] + count["unnoticed"]
    share = count["noticed"] / matter if matter else 1.0
    harmless = f"{count['harmless']} more listed as harmless"
    print(
        f"{package}, {len(seen)} tried: {count['noticed']} of {matter} noticed ({share:.0%}), {harmless}"
    )
    return int(share < GOAL)


if __name__ == "__main__":
    started = time.monotonic()
    code = main()
    print(f"{time.monotonic() - started:.0f} s")
    sys.exit(code)
