"""Travel sweeps of the reference double wishbone: 41 poses with every quantity, and ten thousand variants of them."""

from __future__ import annotations

import numpy as np
from peer_kinematics import TRAVELS, metrics, poses
from timing import Row, median_time

import jounce as jn
from jounce.kinematics.sweeps import prepare_sweep

VARIANTS = 10_000
MOVED = ("lower_ball_joint", "upper_ball_joint", "tie_rod_inner")


def kinematics_rows() -> list[Row]:
    """Times of both sweeps; the error is that of the contact point's y against a sweep of ten times as many poses."""
    rig = jn.load("reference-double-wishbone")
    sweep = prepare_sweep(rig, TRAVELS)
    names = [row.name for row in sweep.model.rows]
    fine = prepare_sweep(
        rig, np.linspace(TRAVELS[0], TRAVELS[-1], 10 * (len(TRAVELS) - 1) + 1)
    ).run()
    exact = fine[names.index("contact_point_y"), ::10, 0]
    error = float(np.max(np.abs(sweep.run()[names.index("contact_point_y"), :, 0] - exact)))
    own = median_time(sweep.run, repeats=101)
    problem = f"double wishbone, travel sweep, {len(TRAVELS)} poses"
    rows = [
        Row(problem, f"jounce, compiled sweep, {len(names)} quantities", own, error, 1.0, "≤ 2 ms")
    ]
    whole = median_time(lambda: jn.sweep_travel(rig, TRAVELS), repeats=51)
    rows.append(
        Row(
            problem, "jounce, jn.sweep_travel with its Dataset", whole, error, whole / own, "≤ 2 ms"
        )
    )
    theirs = float(np.max(np.abs(metrics(poses())["contact_point_y"] - exact)))
    for name, run in (
        ("SciPy fsolve, poses", poses),
        ("SciPy fsolve, 11 quantities", lambda: metrics(poses())),
    ):
        median = median_time(run)
        rows.append(Row(problem, name, median, theirs, median / own))
    return [*rows, _variants(rig, len(names))]


def _variants(rig: jn.Rig, count: int) -> Row:
    random = np.random.default_rng(1)
    base = rig.parameters()
    paths = [f"hardpoints.{name}[{i}]" for name in MOVED for i in range(3)]
    changes = {path: base[path] + random.uniform(-0.005, 0.005, VARIANTS) for path in paths}
    median = median_time(lambda: jn.sweep_variants(rig, changes, TRAVELS), repeats=3)
    return Row(
        f"{VARIANTS} variants × {len(TRAVELS)} poses",
        f"jounce, {count} quantities",
        median,
        None,
        None,
        "≤ 10 s",
    )


if __name__ == "__main__":
    from timing import markdown

    print(markdown(kinematics_rows()))
