"""Ride metrics and spectra of simulated quarter cars against closed forms and a deterministic benchmark road."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.ride.metrics import ride_metrics
from jounce.ride.spectra import channel_transfer, power_spectrum, response_spectrum

SPEED, PERIOD, ROUGHNESS = 20.0, 5.0, 256e-6
WAVES = np.arange(2, 301)
# Class C: G_d(n0) = 256e-6 m^3, n_i = 0.01 i 1/m, phases 2 pi frac(0.618... i): one period is 5 s at 20 m/s
AMPLITUDES = np.sqrt(2.0 * ROUGHNESS * (0.1 / (0.01 * WAVES)) ** 2 * 0.01)
PHASES = 2.0 * np.pi * np.modf(0.6180339887498949 * WAVES)[0]
INTENSITY = 2.0 * np.pi**2 * 0.1**2 * ROUGHNESS * SPEED


def car(damping: float, **changes: float) -> jn.Rig:
    table = {
        "schema": "jounce.rig/1",
        "model": "quarter-car",
        "sprung": {"mass": 400.0},
        "unsprung": {"mass": 40.0},
        "strut": {"spring": {"rate": 25e3}, "damper": {"coefficient": damping}},
        "tyre": {"stiffness": 200e3, "lift_off": False},
    }
    return jn.QuarterCar.from_table(table).with_changes(changes)


@pytest.fixture(scope="module")
def road() -> jn.Table:
    x = np.arange(0.0, 501.0, 0.02)
    height = np.zeros_like(x)
    for wave, amplitude, phase in zip(WAVES, AMPLITUDES, PHASES, strict=True):
        height += amplitude * np.cos(2.0 * np.pi * 0.01 * wave * x + phase)
    return jn.Table(x=x, height=height, interpolation="cubic")


def driven(rig: jn.Rig, road: jn.Table) -> xr.Dataset:
    return jn.simulate(rig, jn.Trial(road=road, speed=SPEED, duration=5.0 * PERIOD))


def test_the_benchmark_road(road: jn.Table) -> None:
    x = np.arange(0.0, 100.0, 0.02)
    assert 1e3 * np.std(road.height_at(x)) == pytest.approx(12.81605, abs=1e-3)


@pytest.mark.parametrize(
    ("damping", "acceleration", "stroke", "tyre"),
    [
        # domain benchmark: car A on the road above, Runge-Kutta at 0.2 ms, last 5 s: r.m.s. in m/s^2, mm, mm
        (300.0, 2.0964, 32.769, 8.2600),
        (1172.6, 1.2183, 13.797, 4.3368),
        (1500.0, 1.23520, 12.1731, 4.03544),
        (2483.6, 1.3841, 9.4527, 3.7829),
        (4000.0, 1.6547, 7.4444, 4.0086),
    ],
)
def test_metrics_on_the_benchmark_road(
    road, damping: float, acceleration: float, stroke: float, tyre: float
) -> None:
    found = ride_metrics(driven(car(damping), road), settling=4.0 * PERIOD)
    error = 2e-3 if damping < 1000.0 else 2e-4  # the softest one has not quite settled after 20 s
    assert found.duration == pytest.approx(PERIOD)
    assert found.value("rms_acceleration", "sprung.az") == pytest.approx(acceleration, rel=error)
    assert 1e3 * found.value("travel_rms") == pytest.approx(stroke, rel=error)
    assert 1e3 * found.value("tyre_deflection_rms") == pytest.approx(tyre, rel=error)
    load = 440.0 * 9.81
    assert found.value("dynamic_load_coefficient") == pytest.approx(
        200e3 * 1e-3 * tyre / load, rel=error
    )


@pytest.mark.parametrize("damping", [600.0, 1500.0, 4000.0])
@pytest.mark.parametrize("rate", [25e3, 12e3])
def test_dissipated_power_is_half_the_tyre_stiffness_times_the_intensity(
    road, damping: float, rate: float
) -> None:
    # closed form W k_t / 2, whatever spring and damper: W = 2 pi^2 n0^2 G_d(n0) v = 1.0106e-3 m^2/s
    assert pytest.approx(1.0106e-3, rel=1e-4) == INTENSITY
    run = driven(car(damping, **{"strut.spring.rate": rate}), road)
    found = ride_metrics(run, settling=4.0 * PERIOD)
    assert found.value("dissipated_power") == pytest.approx(INTENSITY * 200e3 / 2.0, rel=0.02)
    velocity = run["strut.velocity"].to_numpy()[-5001:]
    assert found.value("dissipated_power") == pytest.approx(
        damping * np.mean(velocity[:-1] ** 2), rel=1e-3
    )


def test_the_spectrum_of_a_run_is_the_squared_gain_times_that_of_the_road(road: jn.Table) -> None:
    run = driven(car(1500.0), road).isel(time=slice(-5001, -1))
    model = jn.linearise(car(1500.0))
    for channel in ("sprung.az", "strut.deflection", "tyre.force"):
        answer, drive = (
            power_spectrum(run[name].to_numpy(), 1000.0, segment=PERIOD, window="boxcar")
            for name in (channel, "road.z")
        )
        lines = np.arange(2, 301)  # one line of the road at each step of the frequency, none beside
        expected = response_spectrum(model, answer.frequency[lines], drive.density[lines], channel)
        np.testing.assert_allclose(answer.density[lines], expected, rtol=5e-3)
        assert answer.mean_square(0.0, 70.0) == pytest.approx(
            float(np.var(run[channel].to_numpy())), rel=1e-3
        )


def test_transfer_function_of_a_run_is_that_of_the_linear_model() -> None:
    noise = np.cumsum(np.random.default_rng(2).normal(size=12_001)) * 1e-3
    road = jn.Table(x=0.1 * np.arange(12_001), height=noise - np.linspace(0.0, noise[-1], 12_001))
    run = jn.simulate(car(1500.0), jn.Trial(road=road, speed=10.0, duration="120 s"))
    model = jn.linearise(car(1500.0))
    found = channel_transfer(run, "sprung.az", segment="12 s", settling=2.0)
    seen = (found.frequency > 0.5) & (found.frequency < 20.0)
    expected = model.frequency_response(found.frequency[seen], "sprung.az")
    ratio = found.response[seen] / expected
    assert abs(abs(ratio) - 1.0).max() < 0.1
    assert abs(abs(ratio).mean() - 1.0) < 0.01
    assert abs(np.angle(ratio)).max() < 0.1
    assert found.coherence[seen].min() > 0.9
    assert found.coherence[(found.frequency > 5.0) & (found.frequency < 20.0)].min() > 0.999


def test_a_harder_stop_is_met_less_often_when_there_is_more_room(road: jn.Table) -> None:
    counts = []
    for gap in (0.165, 0.175, 0.195):  # statically the strut is compressed by 157 mm
        rig = car(1500.0, **{"strut.bump_stop": {"gap": gap, "rate": 60e3}})
        counts.append(ride_metrics(driven(rig, road), rig).value("bump_stop_hits"))
    assert counts[0] > counts[1] > 0.0
    assert counts[2] < counts[1]
