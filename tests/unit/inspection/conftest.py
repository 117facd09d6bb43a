"""Gives the readable twin of a wheel on a plate to the tests, loaded by its path (tests are no packages)."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

import pytest

from jounce.parts.testers import load_tester
from jounce.recordings.schema import recording


@pytest.fixture(scope="session")
def twin():
    path = Path(__file__).parents[2] / "twins" / "plate_twin.py"
    spec = importlib.util.spec_from_file_location("plate_twin", path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="session")
def eusama():
    return load_tester("eusama")


@pytest.fixture(scope="session")
def left_record():
    """Build a record of the left wheel from time, height and force."""

    def build(time, height, force, load=None, **facts):
        channels = {"left.plate.z": (height, "m", ""), "left.plate.force": (force, "N", "")}
        known = {} if load is None else {"left.static_load": load}
        return recording(time, channels, attributes=known | facts)

    return build
