"""Killed at any moment: every file is whole or absent, the same command again gives the same bytes, nothing is left."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="needs processes that are forked")
SCRIPT = Path(__file__).parent / "kills" / "run.py"
JOBS = ("recording", "report", "store", "cache")


def killed(folder: Path, kills: int, seed: int, *jobs: str) -> dict[str, dict[str, int]]:
    asked = [sys.executable, str(SCRIPT), str(folder), str(kills), str(seed), *jobs]
    ran = subprocess.run(asked, capture_output=True, text=True, timeout=7200, check=False)
    assert ran.returncode == 0, ran.stderr
    found: dict[str, dict[str, int]] = json.loads(ran.stdout)
    return found


def test_some_moments(tmp_path: Path) -> None:
    for counts in killed(tmp_path, 2, 2026, *JOBS).values():
        assert counts["kills"] >= 1


@pytest.mark.slow
@pytest.mark.parametrize("job", [*JOBS, "campaign"])
def test_two_hundred_moments(tmp_path: Path, job: str) -> None:
    (counts,) = killed(tmp_path, 200, 11, job).values()
    assert counts["kills"] > 140
    assert counts["unchanged"] > 0
    assert counts["partly"] + counts["done"] > 0
