"""Tyre stiffness against pressure."""

import pytest

from jounce.core.errors import FitError
from jounce.identify.estimate import Estimate
from jounce.identify.stiffness import stiffness_against_pressure

KART = [
    (0.31e6, Estimate(138468.0, 300.0, (137868.0, 139068.0))),
    (0.25e6, Estimate(125800.0, 400.0, (125000.0, 126600.0))),
]


def test_line_and_exponent_of_the_kart_tyre():
    # domain A5: dk/dp = 211.13 kN/m per MPa, k(0) = 73.02 kN/m, exponent 0.446
    tyre = stiffness_against_pressure(KART)
    assert tyre.slope * 1e3 == pytest.approx(211.13, abs=0.01)
    assert tyre.at_zero_pressure == pytest.approx(73020.0, abs=10.0)
    assert tyre.exponent == pytest.approx(0.446, abs=5e-4)


def test_interpolation_is_linear_and_its_interval_lies_between():
    found, findings = stiffness_against_pressure(KART).at(0.28e6)
    assert found.value == pytest.approx(132134.0)
    assert found.standard_error == pytest.approx(250.0)
    assert found.interval == pytest.approx((132134.0 - 500.0, 132134.0 + 500.0))
    assert findings == []


def test_measured_pressures_are_returned_as_they_are():
    tyre = stiffness_against_pressure(KART)
    assert tyre.at(0.31e6)[0] == KART[0][1]
    assert tyre.at(0.25e6) == (KART[1][1], [])


@pytest.mark.parametrize(("pressure", "stiffness"), [(0.20e6, 115243.33), (0.35e6, 146913.33)])
def test_extrapolation_is_flagged(pressure, stiffness):
    found, findings = stiffness_against_pressure(KART).at(pressure)
    assert found.value == pytest.approx(stiffness, abs=0.01)
    assert "extrapolated" in findings[0].message
    assert found.standard_error > 300.0


def test_three_pressures_interpolate_between_neighbours():
    # measured 335/65R22.5 tyre at 40 / 60 / 70 psi (Project Chrono, BSD-3)
    psi = 6894.757
    points = [(40 * psi, 4.0652e5), (60 * psi, 5.6519e5), (70 * psi, 6.4452e5)]
    tyre = stiffness_against_pressure([(p, Estimate(k)) for p, k in points])
    assert tyre.at(65 * psi)[0].value == pytest.approx((5.6519e5 + 6.4452e5) / 2, rel=1e-6)
    assert tyre.at(50 * psi)[0] == Estimate(pytest.approx((4.0652e5 + 5.6519e5) / 2, rel=1e-6))
    assert 0.8 < tyre.exponent < 0.85


def test_one_pressure_stands_for_all_with_a_finding():
    tyre = stiffness_against_pressure(KART[:1])
    assert tyre.slope is None
    assert tyre.at(0.25e6)[0] == KART[0][1]
    assert len(tyre.at(0.25e6)[1]) == 1
    assert tyre.at(0.31e6)[1] == []


def test_swapped_files_are_noticed():
    tyre = stiffness_against_pressure([(0.31e6, Estimate(1.2e5)), (0.25e6, Estimate(1.4e5))])
    assert "falls" in tyre.findings[0].message


@pytest.mark.parametrize(
    "points",
    [
        [],
        [(0.0, Estimate(1e5))],
        [(1e5, Estimate(1e5)), (1e5, Estimate(2e5))],
        [(1e5, Estimate(-1.0))],
    ],
)
def test_unusable_points_are_refused(points):
    with pytest.raises(FitError):
        stiffness_against_pressure(points)


def test_a_pressure_must_be_positive():
    with pytest.raises(FitError, match="above 0 Pa"):
        stiffness_against_pressure(KART).at(-1.0)
