"""Gives the readable twin of a wheel on a plate to the tests, loaded by its path (tests are no packages)."""

from __future__ import annotations

import plate_twin
import pytest

from jounce.parts.testers import load_tester
from jounce.recordings import recording


@pytest.fixture(scope="session")
def twin():
    return plate_twin


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
