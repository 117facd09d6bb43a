"""Converged references of the prototype's double wishbone: ``python tests/files/prototype/make_references.py``.

Runs the twin (tests/twins/double_wishbone_twin.py) at two tolerances, writes the finer run and says how far they differ
and how far 1.95 m/s is from the reference that came with the model. Takes about a minute.
"""

from __future__ import annotations

import importlib
import json
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
SPEEDS = (1.95, 2.86, 3.79)
CHANNELS = ("zs", "zu", "as", "au", "tyre_force", "strut_force")
GIVEN = {"tyre_force": "Ftyre", "strut_force": "Fstrut"}


def twin():
    sys.path.insert(0, str(HERE.parents[1] / "twins"))
    return importlib.import_module("double_wishbone_twin")


def main() -> None:
    module = twin()
    description = json.loads((HERE / "double_wishbone.json").read_text(encoding="utf-8"))
    road, given = description["road"], np.load(HERE / "double_wishbone_reference.npz")
    times = given["t"]
    for tyre in ("bilateral", "unilateral"):
        corner = module.prototype(description, unilateral=tyre == "unilateral")
        for speed in SPEEDS:
            bump = module.Obstacle(road["height"], road["length"], speed, road["t_start"])
            fine = corner.run(bump, times, rtol=1e-13, atol=1e-15)
            coarse = corner.run(bump, times, rtol=1e-11, atol=1e-13)
            columns = {name: fine[name] for name in CHANNELS}
            target = HERE / f"double_wishbone_{tyre}_{speed}.npz"
            np.savez_compressed(target, time=times, events=fine["events"], **columns)
            for name in CHANNELS:
                change = np.abs(fine[name] - coarse[name]).max() / np.ptp(fine[name])
                line = f"{tyre} {speed} {name}: range {np.ptp(fine[name]):.6g}, refinement {change:.1e}"
                if speed == 1.95:
                    other = given[
                        f"{tyre[:3].replace('bil', 'lin')}_{speed}_{GIVEN.get(name, name)}"
                    ]
                    line += f", from the given reference {np.abs(fine[name] - other).max() / np.ptp(other):.1e}"
                sys.stdout.write(line + "\n")
            sys.stdout.write(
                f"  violation {fine['violation']:.1e}, {len(fine['events'])} contact events\n"
            )


if __name__ == "__main__":
    main()
