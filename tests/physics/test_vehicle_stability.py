"""Vehicles that cannot stand or run away are told, with the time; what is only extreme is not."""

from __future__ import annotations

import re

import numpy as np
import pytest

import jounce as jn

HALF4 = jn.load("audi-a6-half-car-4dof")
FULL = jn.load("audi-a6-full-car")
BUMP = jn.HalfSine(height="20 mm", length="0.5 m", start="2 m")
DRIVING = {
    "front.damping_coefficient": None,
    "front.damper": {"velocity": [-1.0, 0.0, 1.0], "force": [3e3, 0.0, -3e3]},
}


def trial(duration=5.0, **loads):
    return jn.Trial(road=BUMP, speed="10 m/s", duration=duration, **loads)


def test_dampers_that_drive():
    """A falling force-velocity table: two modes grow; the run ends with time and reason, what was before is kept."""
    car = HALF4.with_changes(DRIVING)
    assert min(mode.damping_ratio for mode in jn.modes(car)) < -0.3
    with pytest.raises(jn.SimulationError, match=r"after 0\.\d+ s: .*unstable \(see its modes\)"):
        jn.simulate(car, trial())
    kept = jn.simulate(car, trial(), check=False)
    assert kept.attrs["status"] == "run_away"
    assert kept["time"][-1] < 1.0
    assert all(np.isfinite(kept[name].values).all() for name in kept)


def test_growth_is_that_of_the_mode():
    """Before it runs away the motion grows with the real part of the worst eigenvalue."""
    linear = {f"{axle}.tyre.lift_off": False for axle in ("front", "rear")}
    model = jn.linearise(HALF4.with_changes(DRIVING | linear))
    rate = np.linalg.eigvals(model.A).real.max()
    kept = jn.simulate(HALF4.with_changes(DRIVING | linear), trial(), check=False)
    motion = np.abs(kept["front.unsprung.z"].values - float(kept["front.unsprung.z"][0]))
    envelope = np.maximum.accumulate(motion)
    late, end = len(envelope) - 150, len(envelope) - 1
    slope = np.log(envelope[end] / envelope[late]) / 0.149
    assert abs(slope / rate - 1.0) < 0.25


@pytest.mark.parametrize(
    "loads",
    [{"lateral_acceleration": 25.0}, {"deceleration": 30.0}, {"pitch_moment": 1e6}],
    ids=lambda load: next(iter(load)),
)
def test_loads_from_the_start_that_nothing_holds(loads):
    name, value = next(iter(loads.items()))
    with pytest.raises(
        jn.SimulationError, match=re.escape(f"With {name} {value:g} (SI) from the very start")
    ):
        jn.simulate(FULL, trial(**loads))


def test_a_car_that_is_thrown_over_is_told_with_the_time():
    with pytest.raises(jn.SimulationError, match=r"after \d\.\d+ s: .*the body turns over"):
        jn.simulate(FULL, trial(lateral_acceleration={"value": 25.0, "start": 1.0}))
    kept = jn.simulate(FULL, trial(lateral_acceleration={"value": 25.0, "start": 1.0}), check=False)
    assert 1.0 < float(kept["time"][-1]) < 4.0
    assert 1.0 < float(kept["body.roll"][-1]) < 1.1  # outwards: right side down in a left turn


def test_just_below_the_limit_it_stands():
    """Tips over where m a h exceeds what the inner wheels can give up: all of the weight at half the track."""
    masses = 1636.0 + 2 * 45.0 + 2 * 42.0
    limit = masses * 9.81 * 0.5 * 1.54 / (1636.0 * 0.55)
    rest = jn.simulate(FULL, trial(0.1, lateral_acceleration=0.98 * limit))
    inner = sum(float(rest[f"{axle}_left.tyre.force"][0]) for axle in ("front", "rear"))
    assert 0.0 < inner < 0.03 * masses * 9.81
    with pytest.raises(jn.SimulationError, match="no static equilibrium"):
        jn.simulate(FULL, trial(0.1, lateral_acceleration=1.02 * limit))


@pytest.mark.parametrize("gravity", [-9.81])
def test_a_car_that_falls_off_the_road(gravity):
    with pytest.raises(jn.SimulationError, match="no static equilibrium"):
        jn.equilibrium(FULL.with_changes({"gravity": gravity}))


@pytest.mark.parametrize(
    "changes", [{"front.unsprung_mass": 1e-3}, {"front.tyre.stiffness": 1e10}], ids=str
)
def test_stiff_is_not_unstable(changes):
    run = jn.simulate(FULL.with_changes(changes), trial(1.0))
    assert run.attrs["status"] == "completed"
    assert float(np.ptp(run["body.z"].values)) < 0.05
