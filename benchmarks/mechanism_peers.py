"""Other engines on the prototype's double wishbone, each with the loosest setting that reaches the requested error.

    from mechanism_peers import PEERS, cheapest
    found = cheapest("Pinocchio + SciPy DOP853", Case("unilateral", 3.79), 1e-6)

Also a program of its own: ``python benchmarks/mechanism_peers.py [--quick] [--only NAME]``.
"""

from __future__ import annotations

import argparse
import importlib
import importlib.util
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from mechanism_problem import SPEEDS, TYRES, Array, Case

Run = Callable[[float], tuple[float, Array, Array]]


@dataclass(frozen=True)
class Peer:
    """A peer engine: its package, our module and its settings from loose to tight."""

    package: str
    module: str
    settings: tuple[float, ...]
    note: str

    @property
    def is_installed(self) -> bool:
        return importlib.util.find_spec(self.package) is not None

    def prepared(self, case: Case) -> Run:
        return importlib.import_module(self.module).prepared(case)


PEERS = {
    "Pinocchio + SciPy DOP853": Peer(
        "pinocchio",
        "peer_pinocchio",
        (1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 3e-7, 1e-7, 3e-8, 1e-8, 1e-9),
        "contact events located",
    ),
    "MuJoCo, RK4": Peer(
        "mujoco", "peer_mujoco", (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64), "soft loops, no events"
    ),
    "Exudyn, generalised alpha": Peer(
        "exudyn", "peer_exudyn", (2, 4, 8, 16, 32, 64, 96, 128), "no events"
    ),
}
TARGETS = {"bilateral": (2e-5, 1e-6), "unilateral": (1e-4, 1e-6)}


@dataclass(frozen=True)
class Found:
    """Result of a peer for one case: wall time (s), error, and whether it meets the request."""

    peer: str
    case: Case
    setting: float
    seconds: float
    error: float
    asked: float

    @property
    def is_reached(self) -> bool:
        return self.error <= self.asked


def cheapest(
    name: str, case: Case, asked: float, *, budget: float = 4.0, repeats: int = 5
) -> Found:
    """The loosest setting that reaches the asked error, else the most exact run within ``budget`` seconds a run."""
    peer = PEERS[name]
    run, best = peer.prepared(case), None
    run(peer.settings[0])
    for setting in peer.settings:
        seconds, zs, zu = run(setting)
        error = case.error(zs, zu)
        if best is None or error < best[2]:
            best = setting, seconds, error
        if error <= asked or seconds > budget:
            break
    setting, seconds, error = best
    count = max(1, min(repeats, int(2.0 * budget / seconds)))
    times = [seconds, *(run(setting)[0] for _ in range(count))]
    return Found(name, case, setting, float(np.median(times)), error, asked)


def all_found(*, quick: bool, only: str | None = None) -> Iterator[Found]:
    """Every installed peer on every tyre, speed and target; ``quick``: one speed, runs of at most 0.6 s."""
    budget = 0.6 if quick else 12.0
    for name, peer in PEERS.items():
        if not peer.is_installed or (only and only.lower() not in name.lower()):
            continue
        for tyre in TYRES:
            for speed in SPEEDS[:1] if quick else SPEEDS:
                for asked in TARGETS[tyre]:
                    yield cheapest(name, Case(tyre, speed), asked, budget=budget)


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--only")
    arguments = parser.parse_args()
    print(
        f"{'engine':28} {'tyre':11} {'m/s':>5} {'asked':>7} {'setting':>8} {'time':>10} {'error':>8}"
    )
    for f in all_found(quick=arguments.quick, only=arguments.only):
        mark = "" if f.is_reached else "  not reached"
        head = f"{f.peer:28} {f.case.tyre:11} {f.case.speed:5.2f} {f.asked:7.0e} {f.setting:8g}"
        print(f"{head} {f.seconds * 1e3:7.1f} ms {f.error:8.1e}{mark}", flush=True)


if __name__ == "__main__":
    main()
