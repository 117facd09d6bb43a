"""The memory of the server: requests of every route in random order, and what it gives back in pauses."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("uvicorn")
from clicks import Clicks, prepare_project, settled_memory

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="read from /proc")


@pytest.mark.slow
def test_the_memory_of_the_server_stays_flat_in_random_clicks(tmp_path: Path) -> None:
    prepare_project(tmp_path)
    words = [sys.executable, "-m", "jounce", "serve", str(tmp_path), "--no-open", "--json"]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as server:
        try:
            assert server.stdout is not None
            address = json.loads(server.stdout.readline())
            clicks = Clicks(address["url"], address["token"])
            assert set(clicks.makers()) == clicks.routes()
            held = []
            for count in (200, 150, 150):
                statuses = clicks.click(count)
                assert {status for own in statuses.values() for status in own} <= {200, 409, 422}
                held.append(settled_memory(server.pid)["resident"])
        finally:
            server.terminate()
            server.wait(30)
    served = [route for route, own in statuses.items() if 200 in own]
    assert len(served) > 35  # else requests are refused before anything is done
    assert held[2] - held[0] < 10.0, held
    assert max(held) < 160.0, held


def test_pages_of_program_files_are_dropped_and_read_again() -> None:
    script = """
import numpy as np
from jounce.web.memory import give_memory_back
rows = lambda: open("/proc/self/status").read().splitlines()
files = lambda: next(int(row.split()[1]) / 1024 for row in rows() if row.startswith("RssFile"))
give = give_memory_back()
matrix = np.random.default_rng(0).normal(size=(40, 40))
wanted = np.linalg.inv(matrix)
before = files()
give()
after = files()
assert np.array_equal(np.linalg.inv(matrix), wanted)
print(before, after)
"""
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    before, after = map(float, done.stdout.split())
    assert before > 15.0
    assert after < 0.6 * before
