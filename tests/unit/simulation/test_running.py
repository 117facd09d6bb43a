"""Runs on a belt that has been running."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import SimulationError
from jounce.simulation.running import loops_before

BELT = jn.HalfSine(height="10 mm", length="60 mm", start="0.4 m", recurrence="1.97 m")
RIG = jn.load("kart-quarter-car")


@pytest.mark.parametrize("speed", [1.95, 2.86, 3.87])
@pytest.mark.parametrize("name", ["kart-quarter-car", "kart-double-wishbone"])
def test_a_periodic_start_repeats_after_a_loop(name: str, speed: float) -> None:
    rig, period = jn.load(name), 1.97 / speed
    trial = jn.Trial(road=BELT, speed=speed, duration=2.5 * period)
    run = jn.simulate(rig, trial, start="periodic", output_step=2e-4, tolerance=1e-7)
    assert run["time"][0] == 0.0
    assert run["time"][-1] == pytest.approx(trial.duration)
    time = run["time"].to_numpy()
    grid = np.linspace(0.0, period, 300)
    for channel in ("sprung.z", "unsprung.z"):
        first, second = (
            np.interp(grid + at, time, run[channel].to_numpy()) for at in (0.0, period)
        )
        assert np.max(np.abs(first - second)) < 3e-3 * np.ptp(second), channel
    rest = jn.simulate(rig, trial, output_step=2e-4)
    assert abs(float(rest["sprung.vz"][0])) < 1e-9 < abs(float(run["sprung.vz"][0]))
    np.testing.assert_allclose(run["road.z"], rest["road.z"], atol=1e-9)


def test_loops_are_counted() -> None:
    trial = jn.Trial(road=BELT, speed="3.87 m/s", duration="0.6 s")
    period = 1.97 / 3.87
    three = jn.simulate(RIG, trial, start=3)
    whole = jn.simulate(
        RIG, trial.model_copy(update={"duration": 0.6 + 3.0 * period}), output_step=1e-4
    )
    at = np.interp(three["time"] + 3.0 * period, whole["time"], whole["sprung.z"])
    assert np.max(np.abs(at - three["sprung.z"])) < 2e-3 * float(np.ptp(at))
    assert three.attrs["start"] == "after 3 loops"
    np.testing.assert_array_equal(
        jn.simulate(RIG, trial, start="0")["sprung.z"], jn.simulate(RIG, trial)["sprung.z"]
    )


def test_a_softer_damper_takes_more_loops() -> None:
    loops = [
        loops_before(RIG.with_changes({"strut.damper.coefficient": c}), 0.5)
        for c in (20.0, 60.0, 150.0)
    ]
    assert loops == sorted(loops, reverse=True)
    assert loops[0] > loops[-1]


@pytest.mark.parametrize(
    ("start", "road", "changes", "what"),
    [
        ("periodic", jn.HalfSine(height="10 mm", length="60 mm"), {}, "this road does not recur"),
        (-1, BELT, {}, "invalid start"),
        (10_000, BELT, {}, "invalid start"),
        ("soon", BELT, {}, "invalid start"),
        (
            "periodic",
            BELT,
            {"strut.damper.coefficient": 0.0, "tyre.damping_coefficient": 0.0},
            "does not settle",
        ),
    ],
)
def test_impossible_starts_are_refused(start, road, changes, what: str) -> None:
    rig = RIG.with_changes(changes)
    with pytest.raises(SimulationError, match=what):
        jn.simulate(rig, jn.Trial(road=road, speed="2 m/s", duration="1 s"), start=start)
