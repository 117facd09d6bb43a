"""Updates to virtual K&C sheets with noise, friction and a wrong bushing curve: truths inside their intervals."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

SOFT = {
    "stiffness": ["8 kN/mm", "6 kN/mm", "3 kN/mm"],
    "rotational_stiffness": ["3 N*m/deg"] * 3,
}
ARMS = ("lower_arm_front", "lower_arm_rear", "upper_arm_front", "upper_arm_rear")
START = jn.load("reference-double-wishbone").with_changes(
    {
        "bushings": dict.fromkeys((*ARMS, "tie_rod_inner", "strut_top"), SOFT),
        "links": {"tie_rod": {"stiffness": "50 kN/mm"}},
    }
)
COORDINATES = {
    **dict.fromkeys(ARMS, (1, 2)),
    **dict.fromkeys(("lower_ball_joint", "upper_ball_joint", "tie_rod_inner", "tie_rod_outer"), (0, 1, 2)),
}  # fmt: skip
POINTS = [f"hardpoints.{name}[{i}]" for name, axes in COORDINATES.items() for i in axes]
STIFFNESSES = [f"bushings.{name}.stiffness[{i}]" for name in ARMS for i in (0, 1)]
STIFFNESSES += ["bushings.tie_rod_inner.stiffness[1]", "bushings.strut_top.stiffness[2]"]
STIFFNESSES += ["links.tie_rod.stiffness", "strut.spring.rate"]
NOISE = {"rad": 1e-4, "m": 2e-5, "N": 3.0, "N*m": 0.2}


def virtual_rig(seed: int) -> tuple[dict, dict[str, float], str]:
    """Return a noisy sheet, the true numbers, and the stiffness that a curve replaces."""
    rng, start = np.random.default_rng(seed), START.parameters()
    truth = {path: start[path] + rng.uniform(-3e-3, 3e-3) for path in POINTS}
    truth |= {path: start[path] * rng.uniform(0.7, 1.3) for path in STIFFNESSES}
    place, axis = ARMS[rng.integers(4)], int(rng.integers(2))
    wrong = f"bushings.{place}.stiffness[{axis}]"
    k, bend = truth[wrong], float(rng.uniform(0.5, 2.0)) / 3e-4**2
    curve = {"kind": "polynomial", "coefficients": [0.7 * k, 0.0, bend * k]}
    friction = {f"bushings.{name}.friction": [float(rng.uniform(0.0, 40.0))] * 3 for name in ARMS}
    rig = START.with_changes(truth).with_changes(
        {f"bushings.{place}.curves": {"xy"[axis]: curve}, **friction}
        | {"strut.friction": {"force": float(rng.uniform(10.0, 50.0))}}
    )
    sheet = jn.kc_tests(rig)
    for data in sheet.values():
        for name in data.data_vars:
            noise = rng.normal(0.0, NOISE.get(data[name].attrs["units"], 0.0), data[name].shape)
            data[name] = data[name].copy(data=data[name].values + noise)
    return sheet, truth, wrong


def inside(seed: int) -> tuple[int, int]:
    """Return how many truths are inside their intervals, and of how many."""
    sheet, truth, wrong = virtual_rig(seed)
    free = dict.fromkeys(POINTS, "3 mm") | dict.fromkeys(STIFFNESSES, "30 %")
    fit = jn.update_kc(START, sheet, free)
    known = [path for path in fit.parameters if path != wrong]
    assert len(known) + len(fit.undetermined) >= len(free) - 1
    return sum(fit.parameters[path].has(truth[path]) for path in known), len(known)


def pooled(seeds: range) -> float:
    counts = np.array([inside(seed) for seed in seeds])
    share = float(counts[:, 0].sum() / counts[:, 1].sum())
    print(f"{counts[:, 0].sum()} of {counts[:, 1].sum()} truths inside: {100.0 * share:.1f} %")  # noqa: T201 - the coverage itself
    return share


def test_truths_are_inside_on_two_rigs() -> None:
    assert pooled(range(2)) >= 0.9


@pytest.mark.slow
def test_truths_are_inside_on_fifty_rigs() -> None:
    assert pooled(range(50)) >= 0.92
