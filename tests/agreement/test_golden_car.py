"""The golden car of the roughness index is a quarter car like any other."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce.roughness.iri import SPEED, golden_car_response, rectified_slope

FILES = Path(__file__).parents[1] / "files" / "road_iri"
MASS = 250.0


@pytest.fixture(scope="module")
def golden_car() -> jn.Rig:
    # World Bank Technical Paper 46, per sprung mass: tyre 653, spring 63.3 1/s^2, damper 6 1/s, unsprung mass 0.15
    table = {
        "schema": "jounce.rig/1",
        "model": "quarter-car",
        "sprung": {"mass": MASS},
        "unsprung": {"mass": 0.15 * MASS},
        "strut": {"spring": {"rate": 63.3 * MASS}, "damper": {"coefficient": 6.0 * MASS}},
        "tyre": {"stiffness": 653.0 * MASS, "lift_off": False},
    }
    return jn.QuarterCar.from_table(table)


@pytest.mark.source(
    kind="computed",
    of="quarter car",
    key="wtp-46",
    where="constants of the golden car, its modes solved beside jounce",
    tolerance="half a unit of the last digit",
    compares="modes of the golden car",
)
def test_its_modes(golden_car: jn.Rig) -> None:
    # computed from the constants of the paper, four digits
    body, hop = jn.modes(golden_car)
    assert (body.frequency_hz, hop.frequency_hz) == (
        pytest.approx(1.2363, abs=6e-5),
        pytest.approx(10.7554, abs=6e-5),
    )
    assert (body.damping_ratio, hop.damping_ratio) == (
        pytest.approx(0.3334, abs=6e-5),
        pytest.approx(0.3020, abs=6e-5),
    )


def test_its_response(golden_car: jn.Rig) -> None:
    model = jn.linearise(golden_car)
    wavelength = np.array([1.3, 2.29, 5.0, 15.78, 40.0])
    response = model.frequency_response(SPEED / wavelength, "sprung.z")
    response = response - model.frequency_response(SPEED / wavelength, "unsprung.z")
    np.testing.assert_allclose(golden_car_response(wavelength), response, rtol=1e-9)


def test_a_simulated_drive_gives_the_same_slopes(golden_car: jn.Rig) -> None:
    x, z = np.loadtxt(FILES / "profile_1.txt", unpack=True)
    x, z = x[:1601] - x[0], z[:1601] - z[0]
    trial = jn.Trial(road=jn.Table(x=x, height=z), speed=SPEED, duration=x[-1] / SPEED)
    run = jn.simulate(golden_car, trial, output_step=0.25 / SPEED, tolerance=1e-9)
    slope = abs(run["sprung.vz"] - run["unsprung.vz"]).to_numpy()[1:] / SPEED
    trace = rectified_slope(z, 0.25)
    assert slope.size == trace.size
    settled = 1000  # it starts at rest instead of with the mean slope
    np.testing.assert_allclose(slope[settled:], trace[settled:], atol=1e-7)
    assert abs(slope[:40] - trace[:40]).max() > 1e-4
