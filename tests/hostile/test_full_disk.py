"""Files that may not grow (ulimit -f), as on a full disk: one message, exit code 2, nothing half-written or lost."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from corpus.descriptions import _SWEEP

pytestmark = pytest.mark.skipif(
    sys.platform == "win32", reason="a quota of file size is a thing of POSIX"
)

# The limit on the size of a file is set after everything is imported: then the disk is full for what is written. What
# is imported later leaves no bytecode: Python would cut that at the limit, and stumble over it from then on.
FULL = """
import json, resource, signal, sys
sys.dont_write_bytecode = True
from jounce.cli import main
commands = json.loads(sys.argv[1])
main(["version", "--json"])
import h5netcdf, matplotlib.backends.backend_agg, pandas, xarray
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (2048, resource.getrlimit(resource.RLIMIT_FSIZE)[1]))
for command in commands:
    print(main(command), file=sys.stderr)
"""
RUN = ["simulate", "kart-quarter-car", "--excitation", "base.csv", "--force"]
COMMANDS = [
    [*RUN, "--out", "run.nc"],
    [*RUN, "--out", "run.csv"],
    ["plot", "base.csv", "--figure", "base.png"],
    ["kinematics", "kart-double-wishbone", "--travel", "-4 mm:4 mm:4 mm", "--out", "sweep.nc"],
    ["campaign", "new", "mine"],
    ["campaign", "new", "started", "--force"],
    ["inspect", "import", "base.csv", "--store", "lane.sqlite"],
    ["sweep", "sweep.toml", "--out", "swept"],
]


def listing(folder: Path) -> dict[str, bytes]:
    return {
        str(file.relative_to(folder)): file.read_bytes()
        for file in sorted(folder.rglob("*"))
        if file.is_file()
    }


def test_every_command_says_so_and_changes_nothing(tmp_path: Path) -> None:
    rows = "".join(f"{k / 1000},{1e-3 * (k % 7)}\n" for k in range(500))
    (tmp_path / "base.csv").write_text(f"time [s], road.z [m]\n{rows}", encoding="utf-8")
    (tmp_path / "run.nc").write_bytes(b"mine")
    (tmp_path / "sweep.toml").write_text(_SWEEP, encoding="utf-8")
    (tmp_path / "started").mkdir()
    (tmp_path / "started" / "campaign.toml").write_text("mine", encoding="utf-8")
    before = listing(tmp_path)
    asked = [sys.executable, "-c", FULL, json.dumps(COMMANDS)]
    ran = subprocess.run(
        asked, cwd=tmp_path, capture_output=True, text=True, timeout=300, check=False
    )
    lines = ran.stderr.splitlines()
    assert ran.returncode == 0, ran.stderr
    codes = [line for line in lines if line.isdigit()]
    assert codes == ["2"] * len(COMMANDS), ran.stderr
    messages = [line for line in lines if line.startswith("jounce: ")]
    assert len(messages) == len(COMMANDS), ran.stderr
    assert all("ulimit -f" in line or "disk I/O error" in line for line in messages), ran.stderr
    assert listing(tmp_path) == before
