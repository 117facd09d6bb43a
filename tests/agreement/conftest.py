"""Gives the readable twin to the agreement tests, loaded by its path (tests are no packages)."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def twin():
    path = Path(__file__).parents[1] / "twins" / "quarter_car_twin.py"
    spec = importlib.util.spec_from_file_location("quarter_car_twin", path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="session")
def vehicle_twin():
    path = Path(__file__).parents[1] / "twins" / "vehicle_twin.py"
    spec = importlib.util.spec_from_file_location("vehicle_twin", path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="session")
def piecewise_twin():
    path = Path(__file__).parents[1] / "twins" / "piecewise_linear_twin.py"
    spec = importlib.util.spec_from_file_location("piecewise_linear_twin", path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module
