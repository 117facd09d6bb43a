"""Applications that PyInstaller freezes: what the hook says that they need, and what child processes do in them."""

from __future__ import annotations

import json
import os
import pkgutil
import runpy
import signal
import subprocess
import sys
import tomllib
import types
import urllib.request
from importlib.util import find_spec
from pathlib import Path

import pytest

import jounce
from jounce.frozen import hook_folders

HOOKS = Path(hook_folders()[0])
ROOT = Path(__file__).parents[3]
PACKAGE = Path(jounce.__file__).parent


@pytest.fixture
def hook(monkeypatch: pytest.MonkeyPatch) -> dict[str, object]:
    """What the hook sets, with functions of PyInstaller that do what its documentation says."""
    hooks = types.SimpleNamespace(
        collect_data_files=lambda package, include_py_files: [(package, include_py_files)],
        collect_submodules=lambda package, wanted: [
            one.name
            for one in pkgutil.walk_packages([str(PACKAGE)], f"{package}.")
            if wanted(one.name)
        ],
        copy_metadata=lambda package, recursive: [(f"{package}.dist-info", recursive)],
    )
    for name in ("PyInstaller", "PyInstaller.utils"):
        monkeypatch.setitem(sys.modules, name, types.ModuleType(name))
    monkeypatch.setitem(sys.modules, "PyInstaller.utils.hooks", hooks)
    return runpy.run_path(str(HOOKS / "hook-jounce.py"))


def test_pyinstaller_finds_the_hook() -> None:
    entry = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"][
        "entry-points"
    ]
    module, _, function = entry["pyinstaller40"]["hook-dirs"].partition(":")
    assert (module, function) == (hook_folders.__module__, hook_folders.__name__)
    assert (HOOKS / "hook-jounce.py").is_file()
    started = json.loads((HOOKS / "rthooks.dat").read_text())
    assert {
        name: [(HOOKS / "rthooks" / one).is_file() for one in files]
        for name, files in started.items()
    } == {"jounce": [True]}


def test_the_hook_names_what_is_imported_by_name_only(hook: dict[str, object]) -> None:
    assert hook["datas"] == [
        ("jounce", True),
        ("jounce.dist-info", True),
    ]  # stubs, tables, pages, sources; versions
    modules = hook["hiddenimports"]
    assert isinstance(modules, list)
    wanted = {
        "jounce.simulation.trial_run",
        "jounce.web.worker",
        "jounce.recordings.readers",
        "jounce.kernel.loops",
    }
    assert wanted <= {*modules}
    assert not [
        name for name in modules if name.startswith(("jounce.frozen", "jounce.kernel.loops."))
    ]
    extras = {"fastapi", "uvicorn", "websockets", "openpyxl", "sqlalchemy", "typst", "distributed"}
    assert extras & {*modules} == {name for name in extras if find_spec(name)}
    assert hook["excludedimports"] == ["IPython", "numba"]


def test_a_child_process_does_what_an_interpreter_does(tmp_path: Path) -> None:
    """The application would say that it starts; here it must not come to it."""
    (tmp_path / "file.py").write_text("import sys; print('file', __name__, sys.argv[1:])")
    run = f"import runpy; runpy.run_path({str(HOOKS / 'rthooks' / 'pyi_rth_jounce.py')!r}); print('application')"

    def said(*words: str) -> str:
        done = subprocess.run(
            [sys.executable, "-c", run, *words], capture_output=True, text=True, check=True
        )
        return done.stdout.strip()

    code = "import sys; print('code', __name__, sys.argv)"
    assert said("-P", "-c", code, "a", "b") == "code __main__ ['-c', 'a', 'b']"
    assert said("-I", "-S", str(tmp_path / "file.py"), "a") == "file __main__ ['a']"
    assert said("-I", str(tmp_path / "file.py")) == "file __main__ []"
    for words in (["--version"], ["-c", code], ["simulate", "-P", "-c", code], []):
        assert said(*words) == "application"


@pytest.mark.slow
def test_a_frozen_application_simulates_sweeps_and_serves(tmp_path: Path) -> None:
    """Five minutes, and half a gigabyte on the disk."""
    pytest.importorskip("PyInstaller")
    (tmp_path / "app.py").write_text(
        "import sys\nfrom jounce.__main__ import run\nif __name__ == '__main__':\n    sys.exit(run())\n"
    )
    left_out = (
        "asammdf",
        "distributed",
        "emcee",
        "gymnasium",
        "playwright",
        "pyarrow",
        "pytest",
        "slycot",
        "zarr",
    )
    words = [
        sys.executable,
        "-m",
        "PyInstaller",
        "--log-level=WARN",
        f"--additional-hooks-dir={HOOKS}",
        "app.py",
    ]
    words += [f"--exclude-module={name}" for name in left_out]
    subprocess.run(words, cwd=tmp_path, check=True, capture_output=True)
    app = str(tmp_path / "dist" / "app" / "app")
    clean = {"PATH": os.defpath, "HOME": str(tmp_path), "JOUNCE_CACHE_DIR": str(tmp_path / "cache")}

    def told(*words: str) -> str:
        done = subprocess.run(
            [app, *words], cwd=tmp_path, env=clean, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr
        return done.stdout

    assert told("--version").startswith("jounce ")
    told("simulate", "kart-quarter-car", "--road", "detrended_rms_course_1in", "--speed", "5 m/s", "--duration", "1 s",
         "--out", "run.nc", "--figure", "run.svg", "--report", "run.html")  # fmt: skip
    told("demo", "--quick", "--out", "demo")
    assert (tmp_path / "demo" / "report.html").stat().st_size > 100_000
    (tmp_path / "study.toml").write_text(
        'schema = "jounce.sweep/1"\nrig = "kart-quarter-car"\nmetrics = ["max sprung.az"]\n'
        'trial = {speed = "2 m/s", duration = "1 s", road = {kind = "step", height = "10 mm", start = "1 m"}}\n'
        'design = {kind = "monte-carlo", count = 20}\nvary = {"strut.spring.rate" = "20 %"}\n'
    )
    told("sweep", "study.toml", "--out", "swept", "--workers", "2")
    server = subprocess.Popen([app, "serve", ".", "--no-open", "--json"], cwd=tmp_path, env=clean,
                              stdout=subprocess.PIPE, text=True)  # fmt: skip
    try:
        assert server.stdout is not None
        with urllib.request.urlopen(
            json.loads(server.stdout.readline())["url"], timeout=60
        ) as page:
            assert b"<title>" in page.read()
    finally:
        server.send_signal(signal.SIGINT)
    server.stdout.close()
    assert server.wait(30) == 0
