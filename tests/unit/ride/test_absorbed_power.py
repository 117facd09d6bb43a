"""Absorbed power and shock: closed forms, the filter of Project Chrono as a twin, and where they may be asked for."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import jounce as jn
from jounce.core.errors import DescriptionError, RecordingError
from jounce.ride.absorbed_power import absorbed_power, absorbed_power_response, power_course, shock
from jounce.variants.metrics import read_metrics

FOOT = 0.3048
RIG = jn.load("audi-a6-quarter-car")


def chrono_filter(acceleration: NDArray[np.float64], step: float) -> NDArray[np.float64]:
    """The published difference equation of ChAbsorbed_Power_Vertical; input ft/s^2, the output's square is W."""
    first, low, high = 63.0 * step, 375.0 * step**2, 24.0 * step
    above, below = first + 2.0, first - 2.0
    ahead, back, middle = low + high + 2.0, low - high + 2.0, 2.0 * low - 4.0
    scale = 1.0 / (above * ahead)
    b0 = 29.0 * step * (22.0 * step + 1.0) * scale
    b1 = 29.0 * step * (22.0 * step - 1.0) * scale
    a1 = (below * ahead + above * middle) * scale
    a2 = (above * back + below * middle) * scale
    a3 = below * back * scale
    u, y = np.zeros(4), np.zeros(4)
    filtered = np.empty_like(acceleration)
    for i, value in enumerate(acceleration):
        u[1:], y[1:] = u[:-1].copy(), y[:-1].copy()
        u[0] = value
        y[0] = b0 * (u[0] - u[2]) + b1 * (u[1] - u[3]) - a1 * y[1] - a2 * y[2] - a3 * y[3]
        filtered[i] = y[0]
    return filtered


@pytest.mark.parametrize("frequency", [0.8, 2.0, 4.5, 11.0, 30.0])
def test_a_sine_gives_half_its_squared_amplitude_times_the_gain(frequency: float) -> None:
    cycles = max(4, round(8.0 * frequency))
    t = np.arange(0.0, 8.0 + cycles / frequency, 1e-3)
    wave = 3.0 * np.sin(2.0 * np.pi * frequency * t)
    gain = abs(complex(absorbed_power_response([frequency])[0]))
    course = power_course(wave, 1000.0)[8000:]  # the transient has gone
    assert float(np.mean(course)) == pytest.approx(0.5 * (3.0 * gain) ** 2, rel=2e-3)


def test_it_is_the_filter_of_project_chrono() -> None:
    rng = np.random.default_rng(1)
    step = 2.5e-4
    t = np.arange(0.0, 6.0, step)
    shaken = sum(
        rng.normal() * np.sin(2.0 * np.pi * f * t + rng.uniform(0.0, 6.0))
        for f in np.geomspace(0.5, 25.0, 12)
    )
    twin = float(np.mean(chrono_filter(shaken / FOOT, step) ** 2))
    assert absorbed_power(shaken, 1.0 / step) == pytest.approx(twin, rel=2e-3)


def test_power_is_largest_where_people_were_measured() -> None:
    """Twelve men absorbed most at about 5 Hz, and at a lower frequency when shaken harder (mansfield-griffin-1998)."""
    frequency = np.linspace(0.5, 30.0, 3000)
    largest = frequency[np.argmax(np.abs(absorbed_power_response(frequency)))]
    assert 3.5 < largest < 5.5


def test_power_grows_with_the_square_and_not_with_the_offset() -> None:
    rng = np.random.default_rng(2)
    shaken = rng.normal(size=20000)
    single = absorbed_power(shaken, 1000.0)
    assert absorbed_power(3.0 * shaken, 1000.0) == pytest.approx(9.0 * single)
    held = np.concatenate([np.zeros(1), shaken[1:]])
    assert absorbed_power(held + 9.81, 1000.0, start="first") == pytest.approx(
        absorbed_power(held, 1000.0), rel=1e-6
    )


def test_a_shock_is_what_passes_thirty_hertz() -> None:
    t = np.arange(0.0, 4.0, 1e-3)
    assert shock(2.0 * np.sin(2.0 * np.pi * 3.0 * t), 1000.0) == pytest.approx(2.0, rel=1e-2)
    at_corner = 2.0 * np.sin(2.0 * np.pi * 30.0 * t)
    assert shock(at_corner, 1000.0) == pytest.approx(2.0 / np.sqrt(2.0), rel=0.03)
    assert shock(2.0 * np.sin(2.0 * np.pi * 300.0 * t), 1000.0) < 0.1


def test_refusals() -> None:
    with pytest.raises(RecordingError, match="too short for a mean power"):
        absorbed_power(np.zeros(500), 1000.0)
    with pytest.raises(RecordingError, match="too low"):
        absorbed_power(np.zeros(500), 50.0)
    with pytest.raises(RecordingError, match="not a finite number"):
        absorbed_power([0.0, np.nan, *np.zeros(2000)], 1000.0)
    with pytest.raises(DescriptionError, match="only for accelerations"):
        read_metrics("absorbed_power strut.deflection", {"strut.deflection": "m"})
    with pytest.raises(DescriptionError, match="only for accelerations"):
        jn.optimise(
            RIG, {"sprung.mass": (300.0, 500.0)}, "tyre.force absorbed_power", road="C", speed=10.0
        )


def test_metrics_of_rides_sweeps_and_designs_agree() -> None:
    road = jn.Iso8608(class_="E", length="130 m", run_in="10 m", seed=3)
    trial = jn.Trial(road=road, speed="10 m/s", duration="12 s")
    words = ["absorbed_power sprung.az", "shock sprung.az", "peak strut.velocity"]
    swept = jn.simulate_many(RIG, trial, {"trial.speed": [10.0]}, metrics=words)
    run = jn.simulate(RIG, trial)
    body = run["sprung.az"].to_numpy()
    assert float(swept[words[0]][0]) == pytest.approx(absorbed_power(body, 1000.0), rel=1e-3)
    assert float(swept[words[1]][0]) == pytest.approx(shock(body, 1000.0), rel=1e-3)
    assert swept[words[0]].attrs["units"] == "W"
    velocity = run["strut.velocity"].to_numpy()
    assert float(swept[words[2]][0]) == pytest.approx(np.abs(velocity).max(), rel=1e-3)
    metrics = jn.ride_metrics(run, RIG)
    assert metrics.value("absorbed_power") == pytest.approx(float(swept[words[0]][0]), rel=1e-3)
    assert metrics.value("shock") == pytest.approx(float(swept[words[1]][0]), rel=1e-3)
    assert max(
        metrics.value("peak_bump_velocity"), metrics.value("peak_rebound_velocity")
    ) == pytest.approx(float(swept[words[2]][0]), rel=1e-3)


def test_a_design_lowers_the_absorbed_power() -> None:
    rough = {"road": "E", "speed": "10 m/s", "band": "iso"}
    free = {"strut.damper.coefficient": (500.0, 6000.0)}
    best = jn.optimise(RIG, free, "sprung.az absorbed_power", **rough)
    found = RIG.with_changes({"strut.damper.coefficient": best.numbers[0].value})
    gain = {"sprung.az": lambda f: np.abs(absorbed_power_response(f))}
    before, after = (
        jn.stationary(rig, "E", "10 m/s", band="iso", weighting=gain).weighted["sprung.az"] ** 2
        for rig in (RIG, found)
    )
    assert best.value == pytest.approx((after / before) ** 2, rel=1e-3)
    assert after < 0.8 * before
