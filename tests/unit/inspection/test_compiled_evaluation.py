"""Compiled parts of the evaluation against their slow, readable twins."""

from __future__ import annotations

import normal_equations_twin
import numpy as np
import period_filter_twin
import pytest

from jounce.inspection.quarter_car import normal_equations
from jounce.inspection.turn_forces import force_in_periods, prototype

BASE = np.array([40.0, 25e3, 900.0, 200e3, 60.0, 400.0])


@pytest.fixture(scope="module")
def equations():
    return normal_equations_twin


@pytest.fixture(scope="module")
def low_pass():
    return period_filter_twin


class TestNormalEquations:
    @pytest.mark.parametrize("index", range(6))
    def test_slopes_of_the_twin_are_derivatives(self, equations, index):
        s = 2j * np.pi * np.linspace(0.5, 25.0, 40)
        step = np.zeros(6)
        step[index] = 1e-5 * BASE[index]
        for function in (equations.response_and_slopes, equations.denominator_and_slopes):
            numeric = (function(BASE + step, s)[0] - function(BASE - step, s)[0]) / (
                2.0 * step[index]
            )
            exact = function(BASE, s)[1][:, index]
            assert np.allclose(numeric, exact, atol=1e-6 * np.abs(exact).max())

    @pytest.mark.parametrize("bins", [24, 25, 263])
    @pytest.mark.parametrize("factor", [0.05, 1.0, 6.0])
    def test_equal_the_twin(self, equations, bins, factor):
        generator = np.random.default_rng(bins)
        speed = 2.0 * np.pi * np.linspace(0.7, 27.0, bins)
        parameters = BASE * np.array([1.0, 1.0, factor, 1.0, 0.0 if factor == 1.0 else -1.0, 1.0])
        height, force = generator.normal(size=(2, bins)) + 1j * generator.normal(size=(2, bins)) * [
            [1.0],
            [2.0],
        ]
        force = 1e5 * force
        cost, normal, right, left = normal_equations(parameters, speed, height, force)
        wanted = equations.normal_equations(parameters, speed, height, force)
        assert cost == pytest.approx(wanted[0], rel=1e-12)
        size = np.sqrt(np.diag(wanted[1]))
        assert np.abs((normal - wanted[1]) / np.outer(size, size)).max() < 1e-11
        assert np.abs((right - wanted[2]) / size).max() < 1e-11 * np.sqrt(cost)
        assert np.abs(left - wanted[3]).max() < 1e-11 * np.abs(force).max()

    def test_a_transient_costs_nothing(self, equations):
        speed = 2.0 * np.pi * np.linspace(0.7, 27.0, 200)
        s = 1j * speed
        transient = (
            1e5
            * (2e9 - 3e8 * s + 5e6 * s**2 - 4e4 * s**3)
            / equations.denominator_and_slopes(BASE, s)[0]
        )
        height = np.random.default_rng(0).normal(size=200) + 0.5j
        force = equations.response_and_slopes(BASE, s)[0] * height + transient
        cost, _, _, left = normal_equations(BASE, speed, height, force)
        assert cost < 1e-20 * np.sum(np.abs(force) ** 2)
        assert np.abs(left).max() < 1e-10 * np.abs(transient).max()


class TestLowPassOfThePeriod:
    @pytest.mark.parametrize("rate", [500.0, 1000.0, 1700.0])
    def test_equals_the_twin(self, low_pass, rate):
        taps, half = prototype()
        generator = np.random.default_rng(int(rate))
        frequency = np.linspace(24.0, 5.0, 40)
        tops = 1.0 + np.cumsum(1.0 / frequency)
        time = np.arange(round(6.0 * rate)) / rate
        turn = np.interp(time, tops, np.arange(tops.size))
        signal = (
            4000.0
            + 900.0 * np.cos(2.0 * np.pi * turn + 1.26)
            + generator.normal(0.0, 100.0, time.size)
        )
        window = (-0.12, 0.63)
        found = force_in_periods(signal[None], rate, 0.0, tops, frequency, 4000.0, window)[0]
        compared = 0
        for top, f, row in zip(tops, frequency, found, strict=True):
            if np.isnan(row[0]):
                continue
            least, at = low_pass.least_in_period(signal, rate, 0.0, top, f, taps, half, window)
            assert row[0] == pytest.approx(least, abs=1e-6)
            assert row[1] == pytest.approx(at, abs=1e-9)
            compared += 1
        assert compared > 25
