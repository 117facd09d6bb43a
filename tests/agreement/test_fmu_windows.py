"""The library that an FMU holds for Windows, made here and run under Wine, beside the one for this machine."""

from __future__ import annotations

import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.control.fmu.platforms import PLATFORMS, this_platform

fmpy = pytest.importorskip("fmpy")
WINE = shutil.which("wine") or shutil.which("wine64")
RUNNER = Path(__file__).parents[1] / "twins" / "fmu_runner.c"
STEPS, STEP = 500, 1e-3


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    """Courses of the tyre's force as the runner prints them, by rig and platform."""
    if WINE is None:
        pytest.skip("Wine is not installed (Debian: apt-get install wine64 wine)")
    pytest.importorskip(
        "ziglang", reason="the library for Windows is compiled by zig, of the extra fmu"
    )
    folder = tmp_path_factory.mktemp("windows")
    here, windows = this_platform(), "x86_64-windows"
    runners = {}
    for name in (here, windows):
        target, runners[name] = PLATFORMS[name], folder / f"runner-{name}.exe"
        words = [
            sys.executable,
            "-P",
            "-m",
            "ziglang",
            "cc",
            "-target",
            target.target,
            "-O1",
            str(RUNNER),
        ]
        words += ["-lm", *(["-ldl"] if name == here else []), "-o", str(runners[name])]
        subprocess.run(words, check=True, capture_output=True)

    def run(rig: str, name: str) -> np.ndarray:
        file = folder / f"{rig}.fmu"
        if not file.exists():
            jn.export_fmu(jn.load(rig), file, version=3, platforms=(here, windows))
            with zipfile.ZipFile(file) as archive:
                archive.extractall(folder / rig)
        about = fmpy.read_model_description(str(file))
        references = {variable.name: variable.valueReference for variable in about.modelVariables}
        library = next((folder / rig / "binaries" / name).glob(f"*{PLATFORMS[name].suffix}"))
        words = [str(runners[name]), str(library), about.instantiationToken]
        words += [str(references[one]) for one in ("road.z", "road.vz", "tyre.force")]
        words = [*([WINE] if name == windows else []), *words, str(STEPS), str(STEP)]
        done = subprocess.run(words, check=False, capture_output=True, text=True, timeout=300)
        assert done.returncode == 0, done.stderr[-500:]
        return np.array([float(line) for line in done.stdout.split()])

    return run


@pytest.mark.parametrize("rig", ["kart-quarter-car", "kart-double-wishbone"])
def test_the_library_for_windows_gives_what_that_of_this_machine_gives(course, rig):
    here, there = course(rig, this_platform()), course(rig, "x86_64-windows")
    assert len(here) == len(there) == STEPS
    assert np.ptp(here) > 20.0  # N: the wheel did move
    assert np.max(np.abs(here - there)) / np.ptp(here) < 1e-9
