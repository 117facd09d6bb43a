"""Waiting times of a user: first runs with empty caches, warm commands, and overhead of calls.

Whole processes are given in processor seconds, their own and those of their children, which hardly depend on other
load of the machine. Cold means that only the cache of the package exists.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from timing import Row, median_time

import jounce as jn

HERE = Path(__file__).parent
DRIVEN = ["--road", "bump.toml", "--speed", "1.95 m/s", "--duration", "3 s"]
BUMP = 'kind = "half-sine"\nheight = "10 mm"\nlength = "60 mm"\nstart = "0.2 m"\n'
KART, CORNER, CAR = "kart-quarter-car", "reference-double-wishbone", "formula-student-car"
COLD = {
    "jounce simulate of the quarter car": (["simulate", KART, *DRIVEN], "≤ 4 s"),
    "the same, implicit method": (["simulate", KART, *DRIVEN, "--method", "implicit"], "≤ 6 s"),
    "the same, controlled (jounce compare)": (
        ["compare", KART, *DRIVEN, "--control", "skyhook"],
        "≤ 6 s",
    ),
    "jounce simulate of a 3-D corner": (["simulate", CORNER, *DRIVEN], "≤ 6 s"),
    "jounce inspect simulate": (
        [
            "inspect",
            "simulate",
            "audi-a6-quarter-car",
            "--tester",
            "egea-specsus2018",
            "--out",
            "lane.csv",
        ],
        "≤ 6 s",
    ),
    "jounce kinematics": (["kinematics", CORNER, "--travel", "-80 mm:80 mm:4 mm"], "≤ 6 s"),
    "jounce kc, all tests and their sheet": (
        ["kc", "double-wishbone-elastic", "--out", "kc"],
        "≤ 10 s",
    ),
    "jounce simulate of the full car on 3-D corners": (["simulate", CAR, *DRIVEN], "≤ 6 s"),
    "jounce demo": (["demo", "--out", "demo"], "≤ 40 s"),
}
WARM = {
    "jounce simulate": (["simulate", KART, *DRIVEN], "≤ 0.9 s, 250 MB"),
    "jounce library": (["library"], "≤ 0.6 s"),
    "jounce check": (["check", "bump.toml"], "≤ 0.6 s"),
    "jounce modes": (["modes", KART], "≤ 0.6 s"),
    "jounce --help": (["--help"], "≤ 0.6 s"),
}
COMPILED = {
    "quarter car": (KART, ""),
    "double wishbone": (CORNER, ""),
    "full car on four 3-D double wishbones": (CAR, "≤ 3 s"),
}
COMPILE = """
import time
import casadi, llvmlite.binding
import jounce as jn
from jounce.simulation.compiled import compile_rig
rig, begin = jn.load({name!r}), time.process_time()
compile_rig(rig)
print(time.process_time() - begin)
"""


@dataclass(frozen=True)
class Process:
    """Resources of one process: processor time (s), peak memory (MB), and what it printed."""

    seconds: float
    megabytes: float
    printed: str


_STARTED = """import json, os, sys
pid = os.posix_spawn(sys.executable, [sys.executable, *sys.argv[2:]], os.environ)
_, status, used = os.wait4(pid, 0)
told = [os.waitstatus_to_exitcode(status), used.ru_utime + used.ru_stime, used.ru_maxrss]
open(sys.argv[1], "w").write(json.dumps(told))"""
"""Starts a process from a small one: one that begins as a copy of a large one is told to have the memory of that."""


def process(arguments: list[str], folder: Path) -> Process:
    """Run Python in a folder, whose own cache it uses."""
    environment = {**os.environ, "JOUNCE_CACHE_DIR": str(folder / "cache"), "COLUMNS": "140"}
    environment.pop(
        "PYTHONDONTWRITEBYTECODE", None
    )  # or every process would make it anew of all our sources
    with tempfile.TemporaryDirectory() as told:
        numbers = Path(told, "used.json")
        command = [sys.executable, "-S", "-c", _STARTED, str(numbers), *arguments]
        printed = subprocess.run(
            command, cwd=folder, env=environment, stdout=subprocess.PIPE, check=True
        ).stdout
        code, seconds, memory = json.loads(numbers.read_text())
    if code:
        raise SystemExit(f"{' '.join(arguments)} failed: {code}")
    return Process(seconds, memory / (1e6 if sys.platform == "darwin" else 1e3), printed.decode())


def cold_rows() -> list[Row]:
    rows = []
    for name, (words, target) in COLD.items():
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "bump.toml").write_text(BUMP, encoding="utf-8")
            used = process(["-m", "jounce", *words], Path(folder))
        rows.append(
            Row("first run, empty caches, processor time", name, used.seconds, target=target)
        )
    return rows


def warm_rows() -> list[Row]:
    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "bump.toml").write_text(BUMP, encoding="utf-8")
        for way, (words, target) in WARM.items():
            used = [process(["-m", "jounce", *words], folder) for _ in range(6)][1:]
            seconds, most = (
                float(np.median([one.seconds for one in used])),
                max(one.megabytes for one in used),
            )
            note = f"{most:.0f} MB at most"
            rows.append(Row("warm command, processor time", way, seconds, target=target, note=note))
        script = "import time; start = time.perf_counter(); import jounce; print(time.perf_counter() - start)"
        imported = float(
            np.median([float(process(["-c", script], folder).printed) for _ in range(5)])
        )
        rows.append(Row("import jounce", "in a fresh process", imported, target="≤ 0.3 s"))
    return rows


def compile_rows() -> list[Row]:
    rows = []
    for what, (name, target) in COMPILED.items():
        with tempfile.TemporaryDirectory() as folder:
            first, *cached = (
                float(process(["-c", COMPILE.format(name=name)], Path(folder)).printed)
                for _ in range(4)
            )
        problem = f"build and compile the {what}, processor time"
        rows += [
            Row(problem, "first time", first, target=target),
            Row(problem, "from the cache", min(cached)),
        ]
    with tempfile.TemporaryDirectory() as folder:
        used = process([str(HERE / "hand_written_vehicle.py")], Path(folder))
    rows.append(
        Row(
            "hand-written vehicle of nine bodies, processor time",
            "first run",
            used.seconds,
            target="≤ 15 s",
        )
    )
    return rows


def call_rows() -> list[Row]:
    """Calls of the public functions, warm: with the same rig and trial again, and with others each time."""
    trial = jn.Trial(
        road=jn.HalfSine(height="10 mm", length="60 mm", start="0.2 m"),
        speed="1.95 m/s",
        duration="3 s",
    )
    rows, count = [], 101
    for name, targets in ((KART, ("≤ 0.4 ms", "≤ 0.6 ms")), (CORNER, ("run + 0.7 ms", ""))):
        rig = jn.load(name)
        path = next(path for path in rig.parameters() if path.endswith("spring.rate"))
        value = rig.parameters()[path]
        others = iter(
            [rig.with_changes({path: value * (1.0 + 1e-4 * i)}) for i in range(count + 1)]
        )
        again = median_time(lambda rig=rig: jn.simulate(rig, trial), repeats=count)
        other = median_time(lambda others=others: jn.simulate(next(others), trial), repeats=count)
        rows.append(
            Row(
                f"jn.simulate of {name}, 3 s at 1 kHz",
                "same rig and trial",
                again,
                target=targets[0],
            )
        )
        rows.append(
            Row(
                f"jn.simulate of {name}, 3 s at 1 kHz",
                "a different rig each time",
                other,
                target=targets[1],
            )
        )
    travel, rig = np.linspace(-0.08, 0.08, 41), jn.load(CORNER)
    swept = median_time(lambda: jn.sweep_travel(rig, travel), repeats=count)
    rows.append(Row("jn.sweep_travel, 41 poses", "with its Dataset", swept, target="≤ 0.6 ms"))
    pairs = median_time(lambda: jn.sweep_path(rig, travel, 0.1 * travel), repeats=count)
    rows.append(
        Row(
            "jn.sweep_path, 41 pairs of travel and rack",
            "with its Dataset",
            pairs,
            None,
            pairs / swept,
        )
    )
    return rows


def start_rows() -> list[Row]:
    return [*cold_rows(), *warm_rows(), *compile_rows(), *call_rows()]


if __name__ == "__main__":
    from timing import markdown

    sys.stdout.write(markdown(start_rows()) + "\n")
