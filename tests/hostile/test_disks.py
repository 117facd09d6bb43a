"""Disks of their own: a small one that is full, one that is read-only, one that goes away; where one may be mounted."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

COMMANDS = """
import json, sys
from pathlib import Path
from jounce.cli import main
print(json.dumps([main(command) for command in json.loads(sys.argv[1])]))
"""
DISK = 'mount -t tmpfs -o size=256k tmpfs "$0" && cd "$0" && '
RUN = ["simulate", "kart-quarter-car", "--excitation", "base.csv"]


@cache
def can_mount(folder: Path) -> bool:
    if shutil.which("unshare") is None:
        return False
    return in_disk(folder, "true").returncode == 0


def in_disk(folder: Path, script: str, *words: str) -> subprocess.CompletedProcess[str]:
    """Run a script of the shell in a small disk that only it sees; ``$0`` is its folder."""
    asked = [
        "unshare",
        "--map-root-user",
        "--mount",
        "sh",
        "-c",
        DISK + script,
        str(folder),
        *words,
    ]
    return subprocess.run(asked, capture_output=True, text=True, timeout=300, check=False)


@pytest.fixture
def disk(tmp_path: Path) -> Path:
    folder = tmp_path / "disk"
    folder.mkdir()
    if not can_mount(folder):
        pytest.skip("no disk may be mounted here")
    rows = "".join(f"{k / 1000},{1e-3 * (k % 7)}\n" for k in range(500))
    (tmp_path / "base.csv").write_text(f"time [s], road.z [m]\n{rows}", encoding="utf-8")
    return folder


def answers(
    disk: Path, before: str, commands: list[list[str]], after: str
) -> tuple[list[int], list[str], str]:
    """Exit codes, messages, and what the script ``after`` prints."""
    script = f'cp ../base.csv . && {before} && "$1" -c "$2" "$3" && {after}'
    ran = in_disk(disk, script, sys.executable, COMMANDS, json.dumps(commands))
    assert ran.returncode == 0, ran.stderr
    codes, _, rest = ran.stdout.rpartition("]\n")
    messages = [line for line in ran.stderr.splitlines() if line.startswith("jounce: ")]
    return json.loads(codes.splitlines()[-1] + "]"), messages, rest


WRITE = [
    [*RUN, "--out", "run.nc", "--force"],
    ["campaign", "new", "mine"],
    ["plot", "base.csv", "--figure", "base.png"],
]


def test_a_disk_that_is_full(disk: Path) -> None:
    fill = "echo old > run.nc; dd if=/dev/zero of=filler bs=1k count=1000 2>/dev/null || true"
    codes, messages, left = answers(disk, fill, WRITE, "ls -A; cat run.nc")
    assert codes == [2, 2, 2]
    assert len(messages) == 3
    assert all("No space left on device" in one for one in messages)
    assert left.split() == ["base.csv", "filler", "run.nc", "old"]


def test_a_disk_that_is_read_only(disk: Path) -> None:
    store = ["inspect", "import", "base.csv", "--store", "lane.sqlite"]
    codes, messages, left = answers(disk, 'mount -o remount,ro "$0"', [*WRITE, store], "ls -A")
    assert codes == [2, 2, 2, 2]
    assert len(messages) == 4
    assert all("Read-only" in one or "cannot be" in one for one in messages)
    assert left.split() == ["base.csv"]


VANISHING = """
import subprocess, sys
from pathlib import Path
from jounce.core.errors import OutputError
from jounce.core.writing import replacing, write_files
disk = Path(sys.argv[1])
try:
    with replacing(disk / "run.csv") as temporary:
        temporary.write_text("whole")
        subprocess.run(["umount", "-l", str(disk)], check=True)
except OutputError as error:
    print(error)
write_files(disk / "out", {"a.txt": "whole"})
print((disk / "out" / "a.txt").read_text(), [file.name for file in disk.iterdir()])
"""


def test_a_disk_that_goes_away_while_it_is_written(disk: Path) -> None:
    ran = in_disk(disk, 'cd / && "$1" -c "$2" "$0"', sys.executable, VANISHING)
    assert ran.returncode == 0, ran.stderr
    first, second = ran.stdout.splitlines()
    assert first.startswith(
        f"{disk}/run.csv: the file cannot be written; found 'No such file or directory'"
    )
    assert second == "whole ['out']"


def test_a_folder_that_is_a_disk_is_written_into(disk: Path) -> None:
    script = "\"$1\" -c \"from jounce.core.writing import write_files; write_files('.', {'a/b.txt': 'x'})\" && ls -A"
    ran = in_disk(disk, script, sys.executable)
    assert (ran.returncode, ran.stdout) == (0, "a\n"), ran.stderr


STORES = """
import shutil, subprocess, sys
from pathlib import Path
from jounce.core.errors import OutputError
from jounce.inspection.archive.store import Store
disk, seen = Path(sys.argv[1]), set()
for size in range(16, 240, 8):
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}k", "tmpfs", str(disk)], check=True)
    file = disk / "lane.sqlite"
    try:
        Store(file).close()
        seen.add("made")
    except OutputError:
        seen.add("refused")
    if file.exists():  # to be read it needs room for its log
        store = Store(shutil.copy(file, disk.with_name("copy.sqlite")), read_only=True)
        assert store.problems() == [], size
        store.close()
    left = {one.name for one in disk.iterdir()}
    assert left <= {"lane.sqlite", "lane.sqlite-shm", "lane.sqlite-wal"}, f"{size} kB: {left}"
    subprocess.run(["umount", "-l", str(disk)], check=True)
print(sorted(seen))
"""


def test_a_new_store_on_a_small_disk_is_whole_or_absent(disk: Path) -> None:
    ran = in_disk(disk, 'cd / && "$1" -c "$2" "$0"', sys.executable, STORES)
    assert (ran.returncode, ran.stdout) == (0, "['made', 'refused']\n"), ran.stderr


def test_equations_on_a_small_disk_are_whole_or_absent(disk: Path) -> None:
    export = ["export", "equations", "kart-quarter-car", "--out"]
    small = 'rm base.csv && mount -o remount,size=4k "$0" && export TMPDIR="$0"'
    commands = [[*export, "k.casadi"], [*export, "../k.c"]]
    codes, messages, left = answers(disk, small, commands, "ls -A; tail -n 2 ../k.c")
    assert codes == [2, 0]
    assert "No space left on device" in messages[0]
    assert left.split() == ["}", "/*", "extern", '"C"', "*/", "#endif"]


def test_a_workbook_needs_no_room_for_temporary_files(disk: Path) -> None:
    openpyxl = pytest.importorskip("openpyxl")
    commands = [[*RUN, "--duration", "0.31 s", "--out", "../run.xlsx"]]
    full = 'export TMPDIR="$0"; dd if=/dev/zero of=filler bs=1k count=240 2>/dev/null'
    codes, messages, _ = answers(disk, full, commands, "true")
    assert (codes, messages) == ([0], [])
    assert openpyxl.load_workbook(disk.parent / "run.xlsx")["recording"].max_row == 312


def test_what_a_full_disk_keeps_from_being_looked_at_is_no_verdict(disk: Path) -> None:
    """Temporary files have no room: the record is left out, and taken the next time."""
    pytest.importorskip("sqlalchemy")
    (disk.parent / "lane").mkdir()
    (disk.parent / "lane" / "a.csv").write_text("time [s], left.plate.z [mm]\n" + "0, 1\n" * 10_000)
    into = ["--store", "../lane.sqlite", "--tester", "eusama"]
    watch = ["inspect", "watch", "../lane", *into, "--once", "--settle", "0 s"]
    add = ["inspect", "import", "../lane/a.csv", *into]
    full = 'export TMPDIR="$0"; dd if=/dev/zero of=filler bs=1k count=240 2>/dev/null'
    codes, messages, left = answers(disk, full, [add, watch], "ls -A")
    assert codes == [2, 2]
    assert "No space left on device" in messages[0]
    assert left.split() == ["base.csv", "filler"]
    search = '"$1" -m jounce inspect search --store ../lane.sqlite | grep -o a.csv'
    codes, _, shown = answers(disk, "true", [watch], search)
    assert (codes, shown) == ([0], "a.csv\n")
