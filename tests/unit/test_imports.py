"""What a command loads: no package that its work does not need, so that a warm command takes under a second."""

from __future__ import annotations

import importlib
import pkgutil
import re
import subprocess
import sys

import pytest

from jounce.cli import main
from jounce.parts import library

pytestmark = pytest.mark.usefixtures(
    "optimised"
)  # what is compiled here is that of a process of its own

HEAVY = (
    "casadi",
    "matplotlib",
    "numba",
    "pandas",
    "pint",
    "scipy.interpolate",
    "sqlalchemy",
    "xarray",
)
"""Packages that take long to load; jounce needs each of them for something."""
SCRIPT = """
import contextlib
import io
import sys

from jounce.cli import main

with contextlib.redirect_stdout(io.StringIO()):
    assert main(sys.argv[1:]) == 0
print(*sorted(name for name in sys.modules if name in {heavy!r} or name.startswith("jounce.")))
"""


@pytest.fixture
def loaded(tmp_path, monkeypatch):
    (tmp_path / "rig.toml").write_text(
        library()["kart-quarter-car"].read_text(encoding="utf-8"), encoding="utf-8"
    )
    (tmp_path / "bump.toml").write_text(
        'kind = "half-sine"\nheight = "10 mm"\nlength = "60 mm"\n', encoding="utf-8"
    )

    def run(*words):
        monkeypatch.chdir(tmp_path)
        assert (
            main(list(words)) == 0
        )  # here, where all is loaded: what it compiles is kept for the process below
        command = [sys.executable, "-c", SCRIPT.format(heavy=HEAVY), *words]
        for _ in range(
            2
        ):  # the second where a test before had this process compile for a cache of its own
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            assert done.returncode == 0, done.stderr
            found = set(done.stdout.split())
            if "casadi" not in found:
                break
        return found

    return run


DRIVEN = ("--road", "bump.toml", "--speed", "1.95 m/s", "--duration", "0.5 s")


@pytest.mark.parametrize(
    "words",
    [
        ("simulate", "reference-double-wishbone", *DRIVEN, "--json"),
        ("modes", "kart-quarter-car"),
        ("check", "rig.toml"),
        ("library",),
        ("library", "kart-quarter-car"),
        ("version",),
    ],
    ids=" ".join,
)
def test_a_warm_command_loads_no_heavy_package(loaded, words):
    assert not loaded(*words) & set(HEAVY)


def test_a_run_loads_neither_symbols_nor_controllers(loaded):
    found = loaded("simulate", "kart-quarter-car", *DRIVEN, "--json")
    assert not found & set(HEAVY)
    for package in (
        "control",
        "models",
        "plots",
        "report",
        "identify",
        "campaign",
        "design",
        "ride",
    ):
        assert not {name for name in found if name.startswith(f"jounce.{package}.")}, package
    assert {name for name in found if name.startswith("jounce.mechanics.")} == {
        "jounce.mechanics.facts"
    }


def test_a_listing_reads_files_and_loads_none_of_what_they_describe():
    script = SCRIPT.format(heavy=HEAVY)
    found = subprocess.run(
        [sys.executable, "-c", script, "library"], capture_output=True, text=True, check=True
    ).stdout
    for package in ("campaign", "inspection"):
        assert {name for name in found.split() if name.startswith(f"jounce.{package}.")} == {
            f"jounce.{package}.shipped"
        }


def test_help_loads_no_numbers():
    script = "import sys\nfrom jounce.cli import main\nmain(['--help'])\nprint('numpy' in sys.modules, file=sys.stderr)"
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stderr == "False\n"


def test_a_process_hardly_looks_for_garbage_while_it_loads():
    script = (
        "import gc, sys\nseen = []\ngc.callbacks.append(lambda phase, _: seen.append(phase))\n"
        "from jounce.__main__ import run\nsys.argv[1:] = ['library', 'kart-quarter-car']\ncode = run()\n"
        "print(code, len(seen), gc.get_freeze_count() > 50_000, file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    code, seen, frozen = done.stderr.split()
    assert (code, frozen) == ("0", "True")
    assert int(seen) < 60  # it was more than 200; 24 where no bytecode of our modules is kept yet


def test_validators_of_all_descriptions_can_be_made():
    """They are made when the first of a kind is made, so a mistake in one would show late."""
    import jounce
    from jounce.core.description import Description

    for module in pkgutil.walk_packages(jounce.__path__, "jounce."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)
    waiting, seen = [Description], set()
    while waiting:
        kind = waiting.pop()
        if kind not in seen:
            seen.add(kind)
            waiting += kind.__subclasses__()
            kind.model_rebuild()
            whole = {
                name: repr(one)
                for name, one in kind.model_fields.items()
                if re.search(r"\bint\b", repr(one))
            }
            lax = [name for name, one in whole.items() if "strict=True" not in one]
            assert not lax, (
                f"{kind.__name__} takes true for a whole number: {lax}; annotate it with Whole"
            )
    assert len(seen) > 100


@pytest.mark.parametrize(
    "package", ["campaign", "inspection", "mechanics", "recordings", "roads", "simulation"]
)
def test_no_name_of_a_package_is_that_of_a_module_in_it(package):
    """Names are loaded on first use, and importing a module puts it where the name would be."""
    whole = importlib.import_module(f"jounce.{package}")
    assert not {module.name for module in pkgutil.iter_modules(whole.__path__)} & set(whole.__all__)
    for name in whole.__all__:
        assert getattr(whole, name) is not None


@pytest.mark.parametrize(
    ("words", "may_come"),
    [(["modes", "kart-quarter-car"], False), (["sweep", "--cluster=x", "--help"], True)],
)
def test_a_command_loads_dask_only_for_a_cluster(
    words: list[str], may_come: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where Dask is installed xarray loads it on first use, which takes a third of a second."""
    from jounce.__main__ import run

    monkeypatch.delitem(sys.modules, "dask", raising=False)
    monkeypatch.setattr(sys, "argv", ["jounce", *words])
    monkeypatch.setattr("jounce.cli.main", lambda: 0)
    monkeypatch.setattr("gc.freeze", lambda: None)
    assert run() == 0
    assert ("dask" not in sys.modules) == may_come
    sys.modules.pop("dask", None)
