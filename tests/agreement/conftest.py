"""Gives the readable twins to the agreement tests."""

from __future__ import annotations

import piecewise_linear_twin
import pytest
import quarter_car_twin
import vehicle_twin as twin_of_vehicles


@pytest.fixture(scope="session")
def twin():
    return quarter_car_twin


@pytest.fixture(scope="session")
def vehicle_twin():
    return twin_of_vehicles


@pytest.fixture(scope="session")
def piecewise_twin():
    return piecewise_linear_twin
