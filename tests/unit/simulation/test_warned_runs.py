"""A run warns of what ``jounce check`` warns of: one function looks at the rig."""

from __future__ import annotations

import pytest

import jounce as jn
from jounce.parts import rig_findings

TRIAL = jn.Trial(
    road=jn.HalfSine(height="1 mm", length="60 mm"), speed="1.95 m/s", duration="0.05 s"
)


@pytest.mark.parametrize(
    ("name", "path"),
    [
        ("kart-quarter-car", "tyre.stiffness"),
        ("audi-a6-full-car", "rear.tyre.stiffness"),
        ("audi-a6-half-car-4dof", "front.tyre.stiffness"),
        ("reference-double-wishbone", "tyre.stiffness"),
        ("kart-whole-vehicle", "front.corner.tyre.stiffness"),
    ],
)
def test_a_tyre_of_200_newton_a_metre_is_asked_about(name, path):
    rig = jn.load(name)
    assert not [one for one in rig_findings(rig) if one.severity != "note"]
    (found,) = (
        one for one in rig_findings(rig.with_changes({path: 200.0})) if "compressed" in one.message
    )
    assert (found.place, found.severity) == (path.removesuffix(".stiffness"), "warning")
    assert found.value > 1.0  # m


@pytest.mark.parametrize("name", ["kart-quarter-car", "reference-double-wishbone"])
def test_a_run_warns_as_the_check_does(name):
    rig = jn.load(name)
    assert "findings" not in jn.simulate(rig, TRIAL).attrs
    soft = rig.with_changes({"tyre.stiffness": 200.0})
    run = jn.simulate(soft, TRIAL, check=False)
    assert run.attrs["findings"] == [str(one) for one in rig_findings(soft)]
