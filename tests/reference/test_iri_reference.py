"""Roughness index against the published tables and profiles of its inventors, and against another program."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from jounce.roughness.iri import golden_car_response, iri, rectified_slope, state_transition

pytestmark = pytest.mark.source(
    kind="computed",
    of="ride and roughness",
    key="wtp-46",
    where="the algorithm of the paper, computed beside jounce",
    tolerance="half a unit of the last printed digit",
)

FILES = Path(__file__).parents[1] / "files" / "road_iri"
PRINTED = json.loads((FILES / "sayers_wtp46_coefficients.json").read_text(encoding="utf-8"))[
    "matrices"
]


@pytest.mark.source(
    kind="published",
    of="ride and roughness",
    key="wtp-46",
    where="Table 2 and its column of 0.1 m",
    tolerance="single precision",
)
@pytest.mark.parametrize("spacing", sorted(PRINTED))
def test_state_transition_of_the_golden_car(spacing: str) -> None:
    # World Bank Technical Paper 46, Table 2 (0.25 m) and its 0.1 m column; single precision
    step, drive = state_transition(float(spacing))
    np.testing.assert_allclose(step, PRINTED[spacing]["ST"], rtol=2e-5, atol=1.6e-5)
    np.testing.assert_allclose(drive[1:], PRINTED[spacing]["PR"][1:], rtol=1e-6)
    np.testing.assert_allclose(drive[0], PRINTED[spacing]["PR"][0], rtol=8e-4)


def test_the_exact_value_behind_a_rounded_one() -> None:
    # the table prints 3.793992e-4, computed in single precision; exact is 3.796768e-4
    assert state_transition(0.1)[1][0] == pytest.approx(3.796768e-4, rel=2e-7)


@pytest.mark.source(
    kind="program",
    of="ride and roughness",
    key="sorel-iri",
    where="profile 1 of its files, three segments of 100 m",
    tolerance="five digits; another run-up moves the fifth",
)
def test_segments_of_a_measured_profile() -> None:
    # github.com/michalsorel/iri, its own program: 3.29852, 2.44211, 3.55511 m/km for the first three segments of 100 m.
    # It takes the run-up over 0.5 s at 80 km/h, which changes the first segment in the fifth digit.
    x, z = np.loadtxt(FILES / "profile_1.txt", unpack=True)
    theirs = iri(x, z, segment=100.0, run_up=0.5 * 80.0 / 3.6)
    assert [round(part.iri_m_per_km, 5) for part in theirs.segments[:3]] == [
        3.29852,
        2.44211,
        3.55511,
    ]
    ours = iri(x, z, segment=100.0)
    found = [part.iri_m_per_km for part in ours.segments[:3]]
    np.testing.assert_allclose(found, [3.29852, 2.44211, 3.55511], rtol=0.0, atol=4e-5)
    assert found[0] == pytest.approx(3.29849, abs=6e-6)


def test_the_pulse_of_the_technical_paper() -> None:
    # World Bank Technical Paper 46, check of the program: a triangle of 2 mm between 1 m and 5 m, x = 0.25 ... 30 m.
    # Running index in m/km, recomputed to five digits with the algorithm of the paper
    x = np.arange(0.25, 30.01, 0.25)
    z = 1e-3 * np.interp(x, [1.0, 3.0, 5.0], [0.0, 2.0, 0.0])
    trace = 1e3 * rectified_slope(z, 0.25)
    running = np.cumsum(trace) / np.arange(1, trace.size + 1)
    first = [
        0.0,
        0.0,
        0.0,
        0.05553,
        0.17619,
        0.31537,
        0.43129,
        0.50395,
        0.53395,
        0.53375,
        0.51838,
        0.48820,
        0.53101,
    ]
    first += [0.61800, 0.70999, 0.77932, 0.81681, 0.82787]
    np.testing.assert_allclose(running[: len(first)], first, rtol=0.0, atol=6e-6)
    assert running[-1] == pytest.approx(0.20668, abs=6e-6)
    assert iri(x, z).iri_m_per_km == pytest.approx(running[-1], rel=1e-12)


@pytest.mark.parametrize(("spacing", "expected"), [(0.05, 3.97605), (0.25, 3.97491)])
def test_a_sinusoid(spacing: float, expected: float) -> None:
    # 10 mm amplitude, 15.4 m wavelength, 0 ... 2000 m: computed with the algorithm of the paper, five digits
    x = np.arange(0.0, 2000.0 + 0.5 * spacing, spacing)
    found = iri(x, 0.010 * np.sin(2.0 * np.pi * x / 15.4))
    assert found.iri_m_per_km == pytest.approx(expected, abs=6e-6)


@pytest.mark.parametrize(
    ("wavelength", "gain"), [(2.0, 1.5335), (5.0, 1.1697), (10.0, 1.2597), (20.0, 1.2340)]
)
def test_gain_of_the_golden_car(wavelength: float, gain: float) -> None:
    # response of the golden car at 80 km/h, four digits, computed from the constants of the paper
    assert abs(golden_car_response(wavelength)) == pytest.approx(gain, abs=6e-5)


def test_peaks_of_the_golden_car() -> None:
    wavelength = np.geomspace(1.0, 40.0, 20_001)
    gain = abs(golden_car_response(wavelength))
    peaks = wavelength[1:-1][(gain[1:-1] > gain[:-2]) & (gain[1:-1] > gain[2:])]
    np.testing.assert_allclose(peaks, [2.29, 15.78], atol=0.01)
