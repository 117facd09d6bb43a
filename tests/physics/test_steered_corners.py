"""Steered wheels: a run's whole mechanism starts where the one-coordinate model does, whichever way the rack went."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.parts.files import library

TRIAL = jn.Trial(
    road=jn.HalfSine(height="10 mm", length="0.5 m", start="0.1 m"), speed="5 m/s", duration="0.3 s"
)
STEERED = [
    name for name in sorted(library()) if getattr(jn.load(name), "steering", None) is not None
]
RACKS = (-0.05, -0.02, 0.005, 0.05)


def steered(name: str, rack: float):
    return jn.load(name).with_changes({"steering.rack_travel": rack})


def test_there_are_corners_to_steer():
    assert len(STEERED) >= 8


@pytest.mark.parametrize("name", STEERED)
@pytest.mark.some(3)
def test_a_steered_wheel_rests_where_its_run_begins(name):
    for rack in RACKS:
        rig = steered(name, rack)
        reduced = jn.simulate(rig, TRIAL)  # one coordinate, from poses on the loops
        whole = jn.simulate(rig, TRIAL, method="explicit")
        for channel in ("sprung.z", "tyre.force"):
            begin = float(reduced[channel][0])
            assert float(whole[channel][0]) == pytest.approx(begin, rel=1e-6, abs=1e-7), (
                rack,
                channel,
            )
        numbers = rig.parameters()
        weight = numbers["gravity"] * sum(
            value for path, value in numbers.items() if path.endswith(".mass")
        )
        assert jn.equilibrium(rig)["tyre.force"] == pytest.approx(weight, rel=1e-9)


@pytest.mark.parametrize("name", ["reference-double-wishbone", "generic-mcpherson"])
def test_all_ways_to_run_it_agree(name):
    rig = steered(name, 0.02)
    runs = [
        jn.simulate(rig, TRIAL, **options)
        for options in ({}, {"tolerance": 1e-9}, {"method": "explicit"}, {"detail": True})
    ]
    for run in runs[1:]:
        np.testing.assert_allclose(run["sprung.z"], runs[0]["sprung.z"], atol=1e-7)
    assert jn.modes(rig)[0].damped_frequency_hz > 0.0
    assert jn.lumped_from(rig).sprung.mass > 0.0
