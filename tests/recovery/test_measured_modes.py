"""Modes of two masses on a random road, 100 roads: 95 % intervals hold the truth about as often as they say."""

from __future__ import annotations

import numpy as np
import pytest
from two_masses import TwoMasses

import jounce as jn

SEEDS = 100
OUTPUTS = ["sprung.az", "unsprung.az"]


def _covered(duration: float, *, given: str | None, two: TwoMasses) -> tuple[np.ndarray, int]:  # type: ignore[type-arg]
    """How often the intervals of both frequencies and both ratios hold the truth, and in how many records both are."""
    inside, complete = np.zeros(4), 0
    for seed in range(SEEDS):
        t, road, both = two.drive(seed, duration, rate=100.0)
        signals = {name: (both[:, k], "m/s^2", "") for k, name in enumerate(OUTPUTS)}
        run = jn.recording(t, {"road.z": (road, "m", ""), **signals})
        modes = jn.fit_modes(run, OUTPUTS, given, band=(0.4, 35.0)).modes
        if len(modes) != 2:
            continue
        complete += 1
        pairs = zip(modes, two.modes(), strict=True)
        inside += [
            has
            for mode, (f, z) in pairs
            for has in (mode.frequency.has(f), mode.damping_ratio.has(z))
        ]
    return inside, complete


@pytest.mark.slow
@pytest.mark.parametrize("damper", [300.0, 1000.0])
def test_modes_from_the_road_to_both_accelerations(damper: float) -> None:
    inside, complete = _covered(100.0, given="road.z", two=TwoMasses(damper=damper))
    assert complete >= 98  # one lightly damped record in a hundred asks for a third mode
    assert np.all(inside >= 88)
    assert inside.sum() >= 4 * 92


@pytest.mark.slow
def test_modes_of_the_accelerations_alone() -> None:
    """Without the road: where both modes are found, the intervals hold them; 300 s mostly suffice."""
    inside, complete = _covered(300.0, given=None, two=TwoMasses())
    assert complete >= 80
    assert np.all(inside >= 0.85 * complete)
    assert inside.sum() >= 0.89 * 4 * complete


@pytest.mark.slow
def test_the_body_with_its_wheel_held() -> None:
    """From the wheel's acceleration to the body's: the body on its spring, whatever the tyre and the road."""
    two, inside = TwoMasses(), np.zeros(2)
    rate = np.sqrt(two.spring / two.sprung)
    truth = rate / (2.0 * np.pi), two.damper / (2.0 * two.sprung * rate)
    for seed in range(SEEDS):
        t, _, both = two.drive(seed, 100.0, rate=100.0, noise=0.005)
        run = jn.recording(t, {name: (both[:, k], "m/s^2", "") for k, name in enumerate(OUTPUTS)})
        (mode,) = jn.fit_modes(run, "sprung.az", "unsprung.az", band=(0.4, 20.0), count=1).modes
        inside += [mode.frequency.has(truth[0]), mode.damping_ratio.has(truth[1])]
    assert np.all(inside >= 85), inside
