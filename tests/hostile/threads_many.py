"""Many fresh processes whose first calls come from threads; counts those that crash or compute other numbers.

Usage: python threads_many.py PROCESSES [--cold]

Each process calls one model in one of five ways. All of them must print the same numbers, and end with 0. They share
one cache of compiled models, two at a time; with ``--cold`` each starts with an empty one. The counts are JSON.
"""

from __future__ import annotations

import asyncio
import collections
import faulthandler
import json
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

WAYS = ("two threads", "four threads", "asyncio", "simulate_many after simulate", "evicting store")
RIGS = ("kart-quarter-car", "audi-a6-quarter-car", "kart-quarter-car")  # the same one twice
MASSES = (90.0, 100.0)


def call(way: str) -> list[float]:
    """Call jounce in one way from threads; give peaks of the first rig, and in the last way those of all rigs."""
    import jounce as jn
    from jounce.core.remembered import Recent

    trial = jn.Trial(
        road=jn.Iso8608(**{"class": "C"}, length="5 m", seed=1), speed="5 m/s", duration="0.5 s"
    )

    def peak(rig: str = RIGS[0]) -> float:
        return float(abs(jn.simulate(jn.load(rig), trial)["sprung.az"]).max())

    def peaks(_: int) -> list[float]:
        many = jn.simulate_many(
            jn.load(RIGS[0]), trial, {"sprung.mass": MASSES}, metrics=["max sprung.az"]
        )
        return [float(value) for value in many["max sprung.az"]]

    async def together() -> list[float]:
        return list(await asyncio.gather(*(asyncio.to_thread(peak) for _ in range(5))))

    with ThreadPoolExecutor(6) as threads:
        match way:
            case "asyncio":
                values = asyncio.run(together())
            case "simulate_many after simulate":
                values = [peak()]
                first, *others = threads.map(peaks, range(4))
                if any(other != first for other in others):
                    sys.exit(f"threads differ: {first} {others}")
            case "evicting store":
                Recent.most = 1
                by_rig: dict[str, set[float]] = {rig: set() for rig in RIGS}
                for rig, value in zip(RIGS * 2, threads.map(peak, RIGS * 2), strict=True):
                    by_rig[rig].add(value)
                if any(len(found) > 1 for found in by_rig.values()):
                    sys.exit(f"threads differ: {by_rig}")
                values = [*by_rig[RIGS[0]]]
            case _:
                values = list(threads.map(peak, [RIGS[0]] * (2 if way == "two threads" else 4)))
    return values


def run(number: int, shared: Path, *, cold: bool) -> tuple[str, str]:
    """Run one process; give its way, and its answer or how it ended."""
    way = WAYS[number % len(WAYS)]
    with tempfile.TemporaryDirectory() as own:
        environment = {**os.environ, "JOUNCE_CACHE_DIR": own if cold else str(shared)}
        words = [sys.executable, __file__, "--one", way]
        try:
            ended = subprocess.run(
                words, env=environment, capture_output=True, text=True, check=False, timeout=600
            )
        except subprocess.TimeoutExpired:
            return way, "hung"
    return (
        way,
        ended.stdout
        if ended.returncode == 0
        else f"exit {ended.returncode}: {ended.stderr[-2000:]}",
    )


def count(processes: int, *, cold: bool = False) -> dict[str, object]:
    """Run many processes; give how many there were of each way, and what the wrong ones said."""
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(2) as two:
        ends = list(two.map(lambda number: run(number, Path(folder), cold=cold), range(processes)))
    expected = json.dumps(call(WAYS[0])[:1])
    wrong = [(way, said) for way, said in ends if said != expected]
    return {"processes": dict(collections.Counter(way for way, _ in ends)), "wrong": wrong}


if __name__ == "__main__":
    faulthandler.enable()
    if sys.argv[1] == "--one":
        json.dump(sorted(set(call(sys.argv[2]))), sys.stdout)
    else:
        json.dump(count(int(sys.argv[1]), cold="--cold" in sys.argv), sys.stdout, indent=1)
