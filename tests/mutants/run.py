"""Change one package in one place at a time and see whether its tests notice: ``make mutants PACKAGE=ride``.

Cosmic Ray makes the changes; here a random sample of them is drawn, each is tried in a process of its own that has the
libraries loaded already (so a mutant costs its tests, not four seconds of imports), and what went unnoticed is shown.
No file is changed. A mutant is held first against the tests that run the changed line, then against all the package's
own tests: ``tests/unit/PACKAGE`` and those of other kinds that use what the package makes public.
"""

from __future__ import annotations

import argparse
import ast
import importlib.abc
import importlib.machinery
import importlib.util
import json
import os
import random
import re
import signal
import sys
import tempfile
import time
import tomllib
import traceback
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # set before NumPy comes: a fork keeps no threads

import pytest
from coverage import CoverageData
from positions import Mutant, mutants

ROOT = Path(__file__).parents[2]
SOURCES = ROOT / "src" / "jounce"
HARMLESS = Path(__file__).parent / "harmless.toml"
KINDS = ("physics", "reference", "properties", "measured", "agreement", "recovery")
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
PATIENCE = 10.0
"""A mutant may take this many times as long as the tests took without it, and this many seconds more."""


def main() -> int:
    """Draw, try, tell; 1 where fewer than nine in ten were noticed."""
    asked = arguments()
    files = sources_of(asked.package)
    if not files:
        sys.exit(f"there is no package src/jounce/{asked.package}")
    for library in LIBRARIES:
        importlib.import_module(library)
    pool = [mutant for mutant in mutants(files) if wanted(mutant, asked.place)]
    sample = sorted(random.Random(asked.seed).sample(pool, min(asked.sample, len(pool))))
    print(f"{asked.package}: {len(sample)} of {len(pool)} mutants, seed {asked.seed}", flush=True)
    with tempfile.TemporaryDirectory(prefix="jounce-mutants-") as folder:
        tests = Tests(asked.package, Path(folder))
        seen = {mutant: show(mutant, verdict(mutant, tests)) for mutant in sample}
    return told(asked.package, seen)


def arguments() -> argparse.Namespace:
    """What was asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("package", help="a package of src/jounce")
    parser.add_argument("--sample", type=int, default=200, help="how many mutants")
    parser.add_argument("--seed", type=int, default=1, help="of the random sample")
    parser.add_argument("--place", default="", metavar="FILE[:LINE]", help="only mutants of this file, on this line")
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

    def __init__(self, package: str, folder: Path) -> None:
        self.package, self.folder = package, folder
        self.cache = folder / "models"
        report = folder / "times.json"
        os.environ["COVERAGE_FILE"] = str(folder / "coverage")
        measured = [f"--cov=jounce.{package}", "--cov-context=test", "--cov-report="]
        files = own_tests(package)
        print("\n".join(["its tests:", *files]), flush=True)
        if apart(lambda: run_tests([*files, *measured], self.cache, report), 3600) not in (0, 1):
            sys.exit("the tests cannot be run: see above")
        self.seconds: dict[str, float] = json.loads(report.read_text(encoding="utf-8"))
        self._runs = CoverageData(str(folder / "coverage"))
        self._runs.read()
        if apart(lambda: run_tests(["--collect-only", *self.seconds], self.cache), 600, quiet=True) != 0:
            sys.exit("the tests cannot be asked for by their names")
        print(f"{len(self.seconds)} tests, {sum(self.seconds.values()):.0f} s", flush=True)

    def of(self, mutant: Mutant) -> Iterator[list[str]]:
        """First the tests that run the changed statement, then unit tests and examples in files that use its module.

        The second round is for what is computed once for several tests. What runs when a module is loaded is the
        business of all tests in those files.
        """
        lines = statement(mutant)
        runs = self._runs.contexts_by_lineno(str(mutant.file))
        near = {context.rpartition("|")[0] for line in lines for context in runs.get(line, ())} - {""}
        files = {context.partition("::")[0] for contexts in runs.values() for context in contexts} - {""}
        rest = {test for test in self.seconds if test.partition("::")[0] in files or not files} - near
        yield self._quick_first(near)
        yield self._quick_first({test for test in rest if not near or test.startswith(CHEAP)})

    def _quick_first(self, tests: Iterable[str]) -> list[str]:
        """Unit tests before the others, and each kind in the order of its time."""
        known = [test for test in tests if test in self.seconds]
        return sorted(known, key=lambda test: (not test.startswith(CHEAP), self.seconds[test]))

    def notice(self, mutant: Mutant, tests: Sequence[str]) -> bool:
        """Whether one of some tests fails, or does not end, with a mutant in the place of its file."""

        def code(asked: Iterable[str]) -> int:
            def changed() -> int:
                plant(mutant, self.package, self.folder)
                return run_tests(["-x", *asked], self.cache)

            return apart(changed, PATIENCE * (1.0 + sum(self.seconds[test] for test in tests)), quiet=True)

        found = code(tests)
        if found == pytest.ExitCode.USAGE_ERROR:  # a test goes by another name now, or its file cannot be loaded
            found = code(dict.fromkeys(test.partition("::")[0] for test in tests))
        return found != 0


def own_tests(package: str) -> list[str]:
    """Its unit tests, the examples in its docstrings, and files elsewhere that use it or a public function of it.

    What is loaded, or described by a class (a road, a controller), is only driven with in most files.
    """
    stub = (SOURCES / "__init__.pyi").read_text(encoding="utf-8")
    names = re.findall(rf"^from \.{package}\b[\w.]* import ((?!load_)[a-z]\w*)", stub, re.MULTILINE)
    uses = re.compile("|".join([rf"\b(jounce|jn)\.{package}\b", *(rf"\bjn\.{name}\b" for name in names)]))
    imports = re.compile(rf"^from jounce\.{package}\b", re.MULTILINE)
    unit = ROOT / "tests" / "unit"
    files = [(file, uses) for kind in KINDS for file in sorted((ROOT / "tests" / kind).glob("test_*.py"))]
    files += [(file, imports) for file in sorted(unit.glob("*/test_*.py")) if file.parent.name != package]
    named = [file for file, words in files if words.search(file.read_text(encoding="utf-8"))]
    modules = (file.relative_to(SOURCES.parent).with_suffix("").parts for file in sources_of(package))
    examples = "tests/architecture/test_docstrings.py::test_examples_are_true"
    return [
        *(str(file.relative_to(ROOT)) for file in [unit / package, *named] if file.exists()),
        *(f"{examples}[{'.'.join(parts)}]" for parts in modules),
    ]


def statement(mutant: Mutant) -> range:
    """Lines of the smallest statement around a mutant; of one that holds others, those before them."""
    spans = []
    for node in ast.walk(ast.parse(mutant.file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.stmt):
            body = getattr(node, "body", None)
            span = range(node.lineno, max(node.lineno + 1, body[0].lineno) if body else node.end_lineno + 1)
            if mutant.line in span:
                spans.append(span)
    return min(spans, key=len)


class Clock:
    """Notes how long tests take, and lets processes share compiled models, which `tests/conftest.py` would not."""

    def __init__(self, cache: Path) -> None:
        self.cache, self.seconds, self.failed = cache, {}, set()

    @pytest.hookimpl(trylast=True)
    def pytest_configure(self) -> None:
        os.environ["JOUNCE_CACHE_DIR"] = str(self.cache)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        self.seconds[report.nodeid] = self.seconds.get(report.nodeid, 0.0) + report.duration
        if not report.passed:
            self.failed.add(report.nodeid)


def run_tests(options: Sequence[str], cache: Path, times: Path | None = None) -> int:
    """Run pytest in this process; its exit code."""
    clock = Clock(cache)
    code = pytest.main(
        ["-q", "--no-header", "-p", "no:cacheprovider", "-W", "ignore::pytest.PytestAssertRewriteWarning", *options],
        plugins=[clock],
    )
    if times:
        passed = {test: seconds for test, seconds in clock.seconds.items() if test not in clock.failed}
        times.write_text(json.dumps(passed), encoding="utf-8")
    return int(code)


def apart(work: Callable[[], int], seconds: float, quiet: bool = False) -> int:
    """Do something in a process of its own, which is ended after some time; its exit code, negative where it was."""
    sys.stdout.flush()
    child = os.fork()
    if not child:
        code, told = BROKEN, os.dup(2)
        try:
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


# --- one mutant -------------------------------------------------------------------------------------------------------


class Planted(importlib.machinery.SourceFileLoader, importlib.abc.MetaPathFinder):
    """Gives one module from another text. Its code has its own file, for Numba keeps what it compiles by that file."""

    def __init__(self, name: str, mutant: Mutant, folder: Path) -> None:
        super().__init__(name, str(mutant.file))
        self.copy = Path(tempfile.mkdtemp(dir=folder)) / mutant.file.name
        self.copy.write_text(mutant.source, encoding="utf-8")

    def find_spec(self, name: str, *_: object) -> importlib.machinery.ModuleSpec | None:
        return importlib.util.spec_from_file_location(name, self.path, loader=self) if name == self.name else None

    def get_code(self, _: str) -> object:
        return compile(self.copy.read_bytes(), str(self.copy), "exec")


def plant(mutant: Mutant, package: str, folder: Path) -> None:
    """Put a mutant in the place of its module, and keep what is compiled with it apart from the rest."""
    from jounce.core import sources

    parts = mutant.file.relative_to(SOURCES).with_suffix("").parts
    planted = Planted(".".join(("jounce", *parts)), mutant, folder)
    sys.meta_path.insert(0, planted)
    plain = sources.digest_of
    sources.digest_of = lambda *names: plain(*names) + (str(planted.copy) if package in names else "")


def verdict(mutant: Mutant, tests: Tests) -> str:
    """What became of a mutant: noticed, known as harmless, or unnoticed."""
    if any(tests.notice(mutant, some) for some in tests.of(mutant) if some):
        return "noticed"
    return "harmless" if reason(mutant) else "unnoticed"


def reason(mutant: Mutant) -> str | None:
    """Why a mutant changes nothing that a user sees, as the list beside this file says."""
    rows = tomllib.loads(HARMLESS.read_text(encoding="utf-8")).get(mutant.file.parent.relative_to(SOURCES).parts[0], [])
    key = (mutant.file.stem, *mutant.change)
    return next((row["why"] for row in rows if (row["module"], row["before"], row["after"]) == key), None)


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
    count = {outcome: list(seen.values()).count(outcome) for outcome in ("noticed", "unnoticed", "harmless")}
    matter = count["noticed"] + count["unnoticed"]
    share = count["noticed"] / matter if matter else 1.0
    print(
        f"{package}: {count['noticed']} of {matter} noticed ({share:.0%}), {count['harmless']} more listed as harmless"
    )
    return int(share < GOAL)


if __name__ == "__main__":
    started = time.monotonic()
    code = main()
    print(f"{time.monotonic() - started:.0f} s")
    sys.exit(code)
