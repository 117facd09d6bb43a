"""Knees of dampers of known physics: where the shim stack opens; none where no valve opens."""

from __future__ import annotations

import math

import numpy as np
import pytest
from tests.unit.dampers.shim_stack import AREA, DENSITY, ROD, ShimDamper, Side, record

import jounce as jn
from jounce.dampers.knees import find_knees


def opening(side: Side, area: float) -> tuple[float, float]:
    """Velocity (m/s) and force of the valve (N) at which a stack opens: all flow passes the bleed."""
    flow = 0.7 * side.bleed * math.sqrt(2.0 * side.opening / DENSITY)
    return flow / area, side.opening * area


def found_and_true(seed: int) -> list[tuple[jn.Knee, tuple[float, float]]]:
    rng = np.random.default_rng(seed)
    sides = [
        Side(rng.uniform(5e-6, 1e-5), rng.uniform(4e5, 1.2e6), rng.uniform(3e-10, 8e-10))
        for _ in range(2)
    ]
    damper = ShimDamper(*sides, friction=rng.uniform(0.0, 20.0), lag=rng.uniform(0.0, 3e-3))
    given = [
        jn.RecordFile(
            f"{k}.csv", record(damper, speed, rng, noise=rng.uniform(1, 6), with_velocity=True)
        )
        for k, speed in enumerate((0.1, 0.3, 0.8))
    ]
    (item,) = jn.damper_map(given).settings
    truths = {}
    for name, side, area in (("bump", sides[0], AREA), ("rebound", sides[1], AREA - ROD)):
        velocity, force = opening(side, area)
        truths[name] = velocity, force + damper.friction
    return [(knee, truths[knee.side]) for knee in item.knees]


def hold(seeds: range, least: int) -> None:
    pairs = [pair for seed in seeds for pair in found_and_true(seed)]
    inside = [
        value.has(truth)
        for knee, truths in pairs
        for value, truth in zip((knee.velocity, knee.force), truths, strict=True)
    ]
    assert len(pairs) >= least
    assert np.mean(inside) >= 0.92
    widths = [np.ptp(knee.velocity.interval) / knee.velocity.value for knee, _ in pairs]
    assert np.median(widths) < 0.2


def test_shim_stacks_open_inside_the_intervals_of_knees() -> None:
    hold(range(4), 6)


@pytest.mark.slow
def test_shim_stacks_open_inside_the_intervals_of_knees_on_many_dampers() -> None:
    hold(range(100, 140), 60)


VELOCITY = np.array([-0.97, -0.8, -0.6, -0.5, -0.4, -0.3, -0.2, -0.15, -0.1, -0.05, 0.05, 0.1, 0.15,
                     0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 0.97])  # fmt: skip


@pytest.mark.parametrize(
    "law",
    [
        lambda v: 1500.0 * v,
        lambda v: 3000.0 * v * np.abs(v),
        lambda v: 900.0 * np.sign(v) * np.sqrt(np.abs(v)),
        lambda v: 20.0 * np.sign(v) + 800.0 * v + 700.0 * v * np.abs(v),
        lambda v: np.where(np.abs(v) < 0.4, 500.0 * v, 1500.0 * v - 400.0 * np.sign(v)),
    ],
    ids=["linear", "quadratic", "root", "friction", "stiffer"],
)
def test_smooth_and_progressive_curves_have_no_knee(law) -> None:
    rng = np.random.default_rng(3)
    force = law(VELOCITY)
    noise = 0.003 * np.abs(force).max()
    made = force + noise * rng.standard_normal(len(VELOCITY))
    assert find_knees(VELOCITY, made, np.full(len(VELOCITY), noise)) == ()


def test_a_linear_piston_that_blows_off_has_one_knee_a_side() -> None:
    force = np.where(np.abs(VELOCITY) < 0.27, 4000.0 * VELOCITY, 1080.0 * np.sign(VELOCITY))
    force += np.where(np.abs(VELOCITY) < 0.27, 0.0, 700.0 * (VELOCITY - 0.27 * np.sign(VELOCITY)))
    bump, rebound = sorted(
        find_knees(VELOCITY, force, np.full(len(VELOCITY), 3.0)), key=lambda knee: knee.side
    )
    for knee in (bump, rebound):
        assert knee.velocity.has(0.27)
        assert knee.force.has(1080.0)
        assert knee.softer == pytest.approx(0.175, abs=0.05)
    few = np.abs(VELOCITY) > 0.35
    assert find_knees(VELOCITY[few], force[few], np.full(int(few.sum()), 3.0)) == ()
