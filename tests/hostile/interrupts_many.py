"""Counts how commands end that are interrupted at even parts of the time they take; the page on robustness has them.

Each is begun with an empty cache, and its whole group gets the signal, as from a terminal. It should end with one
line, the signal's exit code, no temporary file and no process.

    python tests/hostile/interrupts_many.py [COUNT]
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

import test_interrupts as one

COMMANDS = {  # words, share of the signals
    "kinematics": (("kinematics", "hmmwv-front", "--travel", "-50 mm:50 mm:5 mm"), 0.3),
    "check": (("check", "hmmwv-front.toml", "base.csv"), 0.25),
    "sweep": (one.SWEEP, 0.25),
    "campaign run": (("campaign", "run", "mine/campaign.toml", "--out", "out"), 0.1),
    "demo": (("demo", "--quick", "--out", "demo"), 0.1),
}
SIGNALS = (
    signal.SIGINT,
    signal.SIGINT,
    signal.SIGINT,
    signal.SIGTERM,
    signal.SIGINT,
    signal.SIGHUP,
)


def prepare(folder: Path, name: str) -> None:
    """Put the files of a command into a folder."""
    import jounce as jn

    if name == "check":
        jn.save(jn.load("hmmwv-front"), folder / "hmmwv-front.toml")
        rows = "".join(f"{k / 1000},{1e-3 * (k % 7)}\n" for k in range(20_000))
        (folder / "base.csv").write_text(f"time [s], road.z [m]\n{rows}", encoding="utf-8")
    if name == "campaign run":
        jn.new_campaign(folder / "mine")


def judge(folder: Path, name: str, part: float, number: signal.Signals | None) -> tuple[str, float]:
    """Interrupt a command after some seconds; say how it ended, and how long it took [s]."""
    prepare(folder, name)
    begun = time.monotonic()
    with one._begin(folder, COMMANDS[name][0]) as started:
        try:
            started.communicate(timeout=part if number is not None else 1800.0)
            return "ended before", time.monotonic() - begun
        except subprocess.TimeoutExpired:
            os.killpg(started.pid, number or signal.SIGKILL)
        try:
            answer, said = started.communicate(timeout=120)
        except subprocess.TimeoutExpired:
            os.killpg(started.pid, signal.SIGKILL)
            return "did not end", 0.0
    assert number is not None
    lines = one._lines(said)
    if started.returncode == 0 and answer and not lines:  # it had answered, and was on its way out
        return "ended before", 0.0
    wrong = []
    if started.returncode != 128 + number:
        wrong.append(f"exit code {started.returncode}")
    if lines not in ([one.LINE], [one.HINT, one.LINE]):
        wrong.append(f"said {lines[-3:]}")
    if left := [file.name for file in (folder / "temporary").iterdir()]:
        wrong.append(f"left {left}")
    if not one._is_empty(started.pid):
        wrong.append("a process is left")
    return "; ".join(wrong) or "right", 0.0


def main() -> int:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 60
    bad = 0
    for name, (_, share) in COMMANDS.items():
        with tempfile.TemporaryDirectory() as place:
            _, whole = judge(Path(place), name, 0.0, None)
        ends, asked = Counter[str](), max(1, round(share * count))
        for k in range(asked):
            number, part = (
                SIGNALS[k % len(SIGNALS)],
                whole * (k + 0.5) / asked if k else min(0.15, 0.1 * whole),
            )
            with tempfile.TemporaryDirectory() as place:
                end, _ = judge(Path(place), name, part, number)
            ends[f"{number.name} {end if end in ('right', 'ended before') else 'wrong'}"] += 1
            if end not in ("right", "ended before"):
                print(
                    f"  {name}: {number.name} after {part:.2f} of {whole:.1f} s: {end}", flush=True
                )
                bad += 1
        print(f"{name} ({whole:.1f} s): {dict(ends)}", flush=True)
    return int(bad > 0)


if __name__ == "__main__":
    raise SystemExit(main())
