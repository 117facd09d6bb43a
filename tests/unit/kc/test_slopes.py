"""Slopes, loops and lines of synthetic sweeps with closed forms."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.kc.loops import branches_of, directions_of, drift_of, lines_of, noise_of, value_at


def loop(to: float, cycles: int = 1, steps: int = 10) -> np.ndarray:
    """Input 0 -> to -> -to -> 0, a number of times."""
    quarter = np.arange(steps) / steps
    wave = np.concatenate([quarter, 1 - quarter, -quarter, quarter - 1])
    return to * np.append(np.tile(wave, cycles), 0.0)


def sheet(x: np.ndarray, y: np.ndarray, unit: str = "N") -> xr.Dataset:
    return xr.Dataset(
        {"left.toe": ("sample", y, {"units": "rad"})},
        {"input": ("sample", x, {"units": unit})},
        {"test": "lateral-opposed"},
    )


def test_a_loop_has_three_branches_and_noise_makes_no_more() -> None:
    x = loop(2000.0, 2)
    assert [branch.direction for branch in branches_of(x)] == [1, -1, 1, -1, 1]
    noisy = loop(2000.0, 2, 200) + np.random.default_rng(1).normal(0.0, 10.0, 1601)
    assert [branch.direction for branch in branches_of(noisy)] == [1, -1, 1, -1, 1]
    directions = directions_of(loop(1.0))
    assert directions[:11].tolist() == [1] * 11
    assert directions[11:31].tolist() == [-1] * 20
    assert branches_of(np.zeros(5)) == ()


def test_hysteresis_is_the_opening_of_the_loop_over_the_range_of_its_mean() -> None:
    x = loop(2000.0, 3)
    y = 1e-6 * x + 1e-4 * directions_of(x)  # 2e-4 open, 4e-3 high
    lines = lines_of(x, y, np.linspace(-1700.0, 1700.0, 18))
    assert lines.opening == pytest.approx(2e-4, rel=1e-9)
    assert lines.mean == pytest.approx(1e-6 * lines.inputs, abs=1e-12)
    fit = jn.kc_slopes(sheet(x, y), within="1.5 kN").sel(quantity="left.toe")
    assert float(fit["hysteresis"]) == pytest.approx(2e-4 / 3e-3, rel=1e-6)
    assert str(fit["unit"].values) == "rad/N"


def test_a_parabola_is_as_far_from_its_line_as_its_sag() -> None:
    x = np.linspace(-1.0, 1.0, 2001)
    fit = jn.kc_slopes(sheet(x, 2.0 * x + x**2, "m")).sel(quantity="left.toe")
    assert float(fit["slope"]) == pytest.approx(2.0, rel=1e-9)
    assert float(fit["intercept"]) == pytest.approx(1.0 / 3.0, rel=2e-3)
    assert float(fit["nonlinearity"]) == pytest.approx((2.0 / 3.0) / 4.0, rel=2e-3)


def test_slope_about_a_point_is_that_of_the_curve_there() -> None:
    x = np.linspace(-0.05, 0.05, 101)
    fit = jn.kc_slopes(sheet(x, x**2, "m"), about="20 mm", within="10 mm")
    assert float(fit["slope"][0]) == pytest.approx(0.04, rel=1e-9)
    assert (fit.attrs["low"], fit.attrs["high"]) == pytest.approx((0.01, 0.03))
    ends = jn.kc_slopes(sheet(x, x**2, "m"), within=("10 mm", 0.03))
    assert float(ends["slope"][0]) == pytest.approx(0.04, rel=1e-9)


def test_gaps_are_left_out_and_constants_have_no_shares() -> None:
    x = loop(1.0)
    y = np.where(np.arange(x.size) == 3, np.nan, 5.0 * x)
    fit = jn.kc_slopes(sheet(x, y))
    assert float(fit["slope"][0]) == pytest.approx(5.0)
    flat = jn.kc_slopes(sheet(x, np.full(x.size, 0.3)))
    assert float(flat["slope"][0]) == pytest.approx(0.0, abs=1e-15)
    assert np.isnan(flat["nonlinearity"][0])
    assert np.isnan(flat["hysteresis"][0])
    rounding = jn.kc_slopes(sheet(x, 1e-17 * np.cos(40.0 * x)))  # of a quantity that stays at 0
    assert np.isnan(rounding["nonlinearity"][0])
    assert np.isnan(rounding["hysteresis"][0])


@pytest.mark.parametrize("within", [(1.0, -1.0), "1 m", (5000.0, 6000.0), (0.0, 1.0, 2.0)])
def test_ranges_that_hold_nothing_are_refused(within: object) -> None:
    with pytest.raises(DescriptionError, match="within"):
        jn.kc_slopes(sheet(loop(2000.0), loop(1.0)), within=within)


def test_drift_is_linear_in_the_sample_index() -> None:
    x = loop(2000.0, 3)
    y = 1e-6 * x + 1e-4 * directions_of(x) + 3e-6 * np.arange(x.size)
    drift, error = drift_of(x, y)
    assert drift == pytest.approx(3e-6, rel=1e-6)
    assert error < 1e-9
    assert drift_of(loop(1.0), loop(1.0)) == (0.0, float("inf"))


def test_value_at_zero_is_the_mean_of_both_branches() -> None:
    x = loop(2000.0, 2)
    y = 0.3 + 1e-6 * x + 1e-4 * directions_of(x)
    assert value_at(x, y) == pytest.approx(0.3, abs=1e-9)
    assert np.isnan(value_at(x, y, 3000.0))


def test_noise_is_found_beside_the_curve() -> None:
    x = np.linspace(-1.0, 1.0, 2000)
    noisy = np.sin(3.0 * x) + np.random.default_rng(2).normal(0.0, 0.01, x.size)
    assert noise_of(noisy) == pytest.approx(0.01, rel=0.1)
