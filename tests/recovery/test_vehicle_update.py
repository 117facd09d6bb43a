"""Known numbers of vehicles are found again from what a run would have measured."""

from __future__ import annotations

import pytest

import jounce as jn

TRUTH = {
    "front.spring_rate": 31e3,
    "rear.damping_coefficient": 2200.0,
    "body.pitch_inertia": 2650.0,
}
FREE = {
    "front.spring_rate": "20 %",
    "rear.damping_coefficient": "30 %",
    "body.pitch_inertia": "20 %",
}


@pytest.mark.parametrize("name", ["audi-a6-half-car", "audi-a6-half-car-4dof", "audi-a6-full-car"])
def test_springs_dampers_and_inertia_from_a_bump(name):
    car = jn.load(name)
    sides = {"right": jn.Flat()} if name == "audi-a6-full-car" else {}
    bump = jn.HalfSine(height="20 mm", length="0.5 m", start="2 m")
    trial = jn.Trial(road=bump, speed="10 m/s", duration="1.5 s", **sides)
    measured = jn.simulate(car.with_changes(TRUTH), trial)[["body.az", "body.pitch_rate"]]
    found = jn.update_model([jn.FitTrial("bump", car, trial, measured)], FREE)
    for path, value in TRUTH.items():
        assert abs(found.parameters[path].value / value - 1.0) < 1e-5
