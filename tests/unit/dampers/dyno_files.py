"""Files as damper dynos write them, from the damper of known physics: records, whole loops and peak tables.

The layouts follow what dyno makers describe: CTW's paper "The Shock Dyno Graphs and how they are created" (scotch yoke,
continuous and peak velocity, in/s), reports of tests on a Roehrig 2VS with Shock 6 (crank, strokes of 1 and 2 in,
temperature), the diagrams that Soft-Engine lists (absolute force over absolute speed, gas test), and NTT's "Reading
Shock Dynamometer Results" (lbf, in/s). No maker publishes the layout of an export: header blocks vary freely here.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from tests.unit.dampers.shim_stack import ShimDamper

INCH, POUND, DECA, KILO = 0.0254, 4.4482216, 10.0, 9.80665

Columns = Sequence[tuple[str, np.ndarray]]


def written(
    columns: Columns, *, mark: str = ",", comma: bool = False, head: str = "", units: str = "", digits: int = 5
) -> str:  # fmt: skip
    """A table below a header block; ``units`` is a row below the names."""
    rows = (
        [f"{value:.{digits}f}" for value in row]
        for row in zip(*(c for _, c in columns), strict=True)
    )
    lines = [mark.join(row) for row in rows]
    if comma:
        lines = [line.replace(".", ",") for line in lines]
    names = mark.join(name for name, _ in columns)
    return (
        "\n".join(
            [*([head.rstrip("\n")] if head else []), names, *([units] if units else []), *lines]
        )
        + "\n"
    )


def sine(
    damper: ShimDamper, peak: float, *, stroke: float = 0.05, cycles: float = 5.0, samples: int = 400, seed: int = 1,
    noise: float = 2.0,
) -> dict[str, np.ndarray]:  # fmt: skip
    """Samples at equal angles of a yoke: time (s), displacement (m), velocity (m/s), force (N)."""
    omega = 2.0 * peak / stroke
    phase = 2.0 * np.pi * np.arange(round(cycles * samples)) / samples
    x, v, a = 0.5 * stroke * np.sin(phase), peak * np.cos(phase), -peak * omega * np.sin(phase)
    force = damper.on_rig(x, v, a) + noise * np.random.default_rng(seed).standard_normal(len(phase))
    return {"t": phase / omega, "x": x, "v": v, "f": force, "angle": np.degrees(phase) % 360.0}


def peaks(
    damper: ShimDamper, speeds: Sequence[float], *, gas: bool, seed: int = 1, noise: float = 2.0
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Peak velocities (m/s), and the forces in bump and rebound (N, compression positive), with or without gas."""
    rng, v = np.random.default_rng(seed), np.asarray(speeds, dtype=float)
    pairs = [
        damper.valves(way * v) + way * damper.friction + damper.gas * gas + noise * rng.standard_normal(len(v))
        for way in (1.0, -1.0)
    ]  # fmt: skip
    return v, pairs[0], pairs[1]
