"""What all tests share: reproducible random examples, a throw-away cache of compiled models, and options."""

from __future__ import annotations

import gc
import os
import random
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import hypothesis
import pytest

for _library in (
    "OPENBLAS",
    "OMP",
    "MKL",
):  # before NumPy comes: on small matrices threads only wait for each other
    os.environ.setdefault(f"{_library}_NUM_THREADS", "1")

import rounding  # noqa: E402 - it imports NumPy
from rounded import is_rounded  # noqa: E402
from rules.evidence import Evidence, name_of, told  # noqa: E402

hypothesis.settings.register_profile("jounce", derandomize=True, deadline=None, max_examples=60)
hypothesis.settings.register_profile("quick", derandomize=True, deadline=None, max_examples=15)
hypothesis.settings.load_profile("jounce")


@pytest.fixture
def units_kept() -> Iterator[None]:
    """Let arithmetic with channels keep their units, as newer versions of xarray do by themselves."""
    import xarray as xr

    with xr.set_options(keep_attrs=True):
        yield


_CACHE = pytest.StashKey[str]()
COLLECTED = pytest.StashKey[set[str]]()
SOURCES = pytest.StashKey[dict[str, dict[str, str] | None]]()
FAST = (
    "not slow and not pages and not examples"  # the tests of `make test`, as pyproject.toml has it
)
QUICK = (
    "unit",
    "properties",
)  # the other kinds of test run models, which are compiled, or the whole documentation


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--quick", action="store_true", help="only what answers at once: `make quick`")
    parser.addoption(
        "--evidence", action="store_true", help="write what the page on validation says"
    )
    parser.addoption(
        "--rounding-noise", type=int, metavar="SEED", help="round as another library would"
    )
    parser.addoption(
        "--shuffle",
        type=int,
        metavar="SEED",
        help="run files, and the tests of each, in random order",
    )
    parser.addoption(
        "--rounded",
        action="store_true",
        help="only files that hang on linear algebra or an optimiser",
    )


def pytest_configure(config: pytest.Config) -> None:
    if not hasattr(
        config, "workerinput"
    ):  # the processes of pytest-xdist share the cache of the one that starts them
        config.stash[_CACHE] = os.environ["JOUNCE_CACHE_DIR"] = tempfile.mkdtemp(
            prefix="jounce-tests-"
        )
    config.stash[COLLECTED] = set()
    config.stash[SOURCES] = {}
    config.pluginmanager.register(Evidence(writes=config.getoption("--evidence")))
    if config.getoption("--rounding-noise") is not None:
        rounding.install(config.getoption("--rounding-noise"))
    if config.getoption("--quick"):
        hypothesis.settings.load_profile("quick")
        _skip_where_something_is_compiled_or_drawn()


def pytest_unconfigure(config: pytest.Config) -> None:
    if _CACHE in config.stash:
        shutil.rmtree(config.stash[_CACHE], ignore_errors=True)


def pytest_collection(session: pytest.Session) -> None:
    """Processes side by side collect the same tests: each rewrites asserts of its share first, and finds the others'.

    That takes twice as long as all else of collecting, once after every edit. What cannot be imported is told later.
    """
    worker = getattr(session.config, "workerinput", {"workerid": "gw0", "workercount": 1})
    if worker["workercount"] == 1 or sys.dont_write_bytecode or not _is_whole(session.config):
        return
    files = sorted(Path(__file__).parent.rglob("test_*.py"))
    for file in files[int(worker["workerid"].removeprefix("gw")) :: worker["workercount"]]:
        known = set(sys.modules)
        try:
            _ = pytest.Module.from_parent(session, path=file).obj
        except (Exception, pytest.skip.Exception):  # noqa: BLE001 - collecting tells it
            for name in set(sys.modules) - known:
                if name.startswith("tests."):
                    del sys.modules[name]


def pytest_itemcollected(item: pytest.Item) -> None:
    item.config.stash[COLLECTED].add(name_of(item))  # slow ones, too: they are deselected later
    item.config.stash[SOURCES][name_of(item)] = told(item)


def pytest_collection_finish(session: pytest.Session) -> None:
    """Thousands of tests are no garbage, and models are made of a million small objects: collections are rare."""
    if session.config.getoption(
        "--quick"
    ):  # not earlier: so are the processes started that run the tests
        subprocess.Popen.__init__ = _left_out("starts a process")  # type: ignore[method-assign]
    elif session.config.option.markexpr == FAST:
        _make_code_quickly()
    gc.collect()
    gc.freeze()
    gc.set_threshold(50_000, 20, 20)


@pytest.fixture(scope="module")
def optimised() -> Iterator[None]:
    """Code as users have it: for twins, which hold that it computes what it shall, and for what compiles.

    Other tests of ``make test`` have code that is not optimised, but made in a fifth of the time: equations hold
    whatever is made of them. ``make test-pages`` and ``make test-all`` optimise all.
    """
    with pytest.MonkeyPatch.context() as patch:
        for (module, name), value in _OPTIMISED.items():
            patch.setattr(module, name, value)
        yield


_OPTIMISED: dict[tuple[Any, str], Any] = {}
"""What makes code that is optimised, and models of such code that this process has met, by module and name."""


def _make_code_quickly() -> None:
    from jounce.kernel import machine, native
    from jounce.kernel.methods import lanes
    from jounce.kinematics import compliances
    from jounce.kinematics import model as kinematics
    from jounce.simulation import compiled, reduced, reduced_car
    from jounce.variants import stepped

    kept_in_process = [
        (compiled, "_compiled"),
        (reduced, "_reductions"),
        (reduced_car, "_reductions"),
        (kinematics, "_models"),
        (compliances, "_models"),
        (lanes, "_codes"),
        (lanes, "_dependences"),
        (stepped, "_codes"),
    ]
    key_here = native.key_here

    def plain(module: Any, *_: object, **__: object) -> bytes:
        return bytes(machine.this_machine(0).emit_object(module))

    _OPTIMISED.update(
        {(module, name): type(getattr(module, name))() for module, name in kept_in_process}
    )
    _OPTIMISED.update(
        {(native, "machine_code"): native.machine_code, (native, "key_here"): key_here}
    )
    native.machine_code = plain
    native.key_here = lambda identity: key_here(f"{identity} made quickly")


@pytest.fixture(scope="session")
def collected(request: pytest.FixtureRequest) -> set[str] | None:
    """All tests that this run has collected as ``file::name``; None where it was asked for a part of them."""
    whole = _is_whole(request.config) and not request.config.getoption("--quick")
    return request.config.stash[COLLECTED] if whole else None


def _is_whole(config: pytest.Config) -> bool:
    return [str(Path(name)) for name in config.args] in (["tests"], [str(Path(__file__).parent)])


@pytest.fixture(scope="session")
def sources(request: pytest.FixtureRequest) -> dict[str, dict[str, str] | None]:
    """What all tests that this run has collected say of their sources."""
    return request.config.stash[SOURCES]


@pytest.hookimpl(tryfirst=True)  # before pytest leaves out what is slow
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Mark what ``some`` leaves out; files in random order, and the tests within each: fixtures are made once still."""
    cases: Counter[tuple[Path, str]] = Counter()
    for item in items:
        if (share := item.get_closest_marker("some")) and isinstance(item, pytest.Function):
            name = item.path, item.originalname
            if cases[name] % share.args[0]:
                item.add_marker(pytest.mark.slow)
            cases[name] += 1
    if (seed := config.getoption("--shuffle")) is not None:
        place = random.Random(seed)
        files = {item.path: place.random() for item in items}
        items.sort(key=lambda item: (files[item.path], place.random()))


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    quick = config.getoption("--quick")
    is_asked_for = not config.getoption("--rounded") or not collection_path.match("test_*.py")
    if not is_asked_for and not is_rounded(collection_path, itself=quick):
        return True
    if not quick:
        return None
    below = (
        collection_path.relative_to(Path(__file__).parent).parts
        if collection_path != config.rootpath
        else ()
    )
    return True if below and below[0] not in QUICK else None


def _skip_where_something_is_compiled_or_drawn() -> None:
    """Skip a test where it would wait for LLVM, a typeset page or a drawn figure: no list of such tests is kept."""
    from matplotlib.figure import Figure

    from jounce.kernel import call, native
    from jounce.kinematics import model
    from jounce.report import protocol

    native.told = call.object_for = call.bitcode_from_sources = _left_out("compiles")
    model._build = _left_out("forms equations that are compiled at once")
    protocol.compiled = _left_out("typesets")
    Figure.draw = _left_out("draws")  # type: ignore[method-assign]


def _left_out(why: str) -> Callable[..., Any]:
    def skip(*_: object, **__: object) -> None:
        raise pytest.skip.Exception(f"{why}: left out of the quick tests", allow_module_level=True)

    return skip
