"""Some operations on files of some writers go wrong; the long form is ``python tests/hostile/faults/run.py``."""

from __future__ import annotations

import json
import platform
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

RUN = Path(__file__).parent / "faults" / "run.py"
WRITERS = (
    "export equations --out .c",
    "simulate --out .xlsx",
    "inspect import --store",
    "report in a folder",
)
pytestmark = [
    pytest.mark.skipif(
        (sys.platform, platform.machine()) != ("linux", "x86_64"),
        reason="traces system calls of Linux on x86-64",
    ),
    pytest.mark.skipif(shutil.which("cc") is None, reason="needs a C compiler"),
]


@pytest.mark.slow
def test_a_few_faults_of_some_writers() -> None:
    for extra in ("openpyxl", "sqlalchemy"):
        pytest.importorskip(extra)
    asked = [sys.executable, str(RUN), "--most", "3", "--writers", *WRITERS]
    ran = subprocess.run(asked, capture_output=True, text=True, timeout=600, check=False)
    if "cannot be traced" in ran.stderr:
        pytest.skip("no process may be traced here")
    assert ran.returncode == 0, ran.stdout + ran.stderr
    counts = json.loads(ran.stdout.splitlines()[-1])
    assert counts["writers"] == 5  # .casadi begins as .c does
    assert min(counts[mode] for mode in ("kill", "half", "full", "once", "refused")) >= 3


def test_no_traceback_of_half_made_objects() -> None:
    """Python prints them itself, where the temporary files of an MDF file cannot be written or removed."""
    for extra in ("asammdf", "sqlalchemy"):
        pytest.importorskip(extra)
    asked = [
        sys.executable,
        str(RUN),
        "--modes",
        "full",
        "refused",
        "--writers",
        "simulate --out .mf4",
    ]
    ran = subprocess.run(asked, capture_output=True, text=True, timeout=600, check=False)
    if "cannot be traced" in ran.stderr:
        pytest.skip("no process may be traced here")
    assert ran.returncode == 0, ran.stdout + ran.stderr
