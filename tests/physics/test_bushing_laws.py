"""Axes, curves and preloads of bushings in runs: against plain bushings, energy, and both sides of a car."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import jounce as jn
from jounce import parts
from jounce.roads import HalfSine, Trial

PROTOTYPE = parts.load(Path(__file__).parents[1] / "files" / "prototype-double-wishbone.toml")
ARMS = ("lower_arm_front", "lower_arm_rear", "upper_arm_front", "upper_arm_rear")
BUMP = Trial(road=HalfSine(height="10 mm", length="60 mm"), speed="1.95 m/s", duration="0.15 s")
PLAIN = {
    "stiffness": [3e6, 2e6, 1e6],
    "rotational_stiffness": [30.0, 20.0, 40.0],
    "damping": [300.0, 200.0, 100.0],
}
SKEW = {
    **PLAIN,
    "x_axis": [1.0, 0.3, -0.2],
    "z_axis": [0.1, 0.2, 1.0],
    "curves": {
        "x": {"kind": "table", "deflection": [-1e-4, 0.0, 2e-5], "force": [-250.0, 0.0, 70.0]},
        "y": {"kind": "polynomial", "coefficients": [2e6, 4e9, 1e14]},
        "rx": {"kind": "polynomial", "coefficients": [30.0, 60.0]},
        "rz": {"kind": "table", "angle": [-0.01, 0.0, 0.002], "torque": [-0.2, 0.0, 0.08]},
    },
    "preload": [50.0, 80.0, -30.0],
    "rotational_preload": [0.4, -0.6, 0.5],
}


def on(law, points=ARMS, rig=PROTOTYPE):
    return rig.with_changes({"bushings": dict.fromkeys(points, law)})


def run(rig, **more):
    return jn.simulate(rig, BUMP, tolerance=1e-8, **more)


def assert_same(
    one, other, names=("sprung.z", "unsprung.z", "tyre.force", "wheel.camber"), rel=1e-6
):
    for name in names:
        size = float(np.ptp(one[name].to_numpy()))
        assert size > 0.0
        assert float(abs(one[name] - other[name]).max()) < rel * size, name


def test_turned_axes_with_exchanged_stiffness_change_nothing():
    """Own x along -y, own y along x: stiffness along the car's axes is the same."""
    turned = {
        **{name: [row[1], row[0], row[2]] for name, row in PLAIN.items()},
        "x_axis": [0.0, -2.0, 0.0],
    }
    assert np.allclose(on(turned).bushings.lower_arm_front.axes, [[0, 1, 0], [-1, 0, 0], [0, 0, 1]])
    assert_same(run(on(PLAIN)), run(on(turned)))


def test_curves_along_the_stiffness_change_nothing():
    """A polynomial and a table with kinks on the straight line of the stiffness."""
    table = {
        "kind": "table",
        "deflection": [-2e-5, 1e-5, 3e-5],
        "force": [-60.0, 30.0, 90.0],
    }
    angle = {"kind": "table", "angle": [-0.01, 0.001], "torque": [-0.4, 0.04]}
    curves = {"x": table, "y": {"kind": "polynomial", "coefficients": [2e6]}, "rz": angle}
    law = {**PLAIN, "stiffness": [0.0, 0.0, 1e6], "curves": curves}
    assert_same(run(on(PLAIN)), run(on(law)))


def test_a_mirrored_corner_moves_as_its_mirror_image():
    left = on(SKEW)
    one, other = run(left, detail=True), run(left.mirrored(), detail=True)
    assert_same(one, other, ("sprung.z", "unsprung.z", "tyre.force", "wheel.camber"))
    for axis, sign in (("x", 1.0), ("y", -1.0), ("z", 1.0)):
        name = f"lower_arm_front.f{axis}"
        assert np.allclose(one[name], sign * other[name], rtol=1e-5, atol=1e-3)
    assert float(abs(one["lower_arm_front.fy"]).max()) > 10.0
    plain = run(on(PLAIN))
    assert (
        float(abs(plain["wheel.camber"] - one["wheel.camber"]).max()) > 1e-5
    )  # rad: the law matters


def test_energy_on_bushings_with_curves_and_preload():
    """What the road puts in is found in weights, springs, damper, bushings and motion."""
    result = run(on(SKEW), detail=True)
    taken = [
        name
        for name in result.data_vars
        if str(name).startswith("energy.") and name != "energy.road"
    ]
    total = sum(result[name] - result[name][0] for name in taken) - result["energy.road"]
    assert "energy.bushings" in taken
    assert float(abs(total).max()) < 1e-6 * float(abs(result["energy.road"]).max())


def test_both_sides_of_a_car_are_mirror_images():
    """On a road that is the same under both wheels the car neither rolls nor drifts, in spite of skew bushings."""
    car = jn.load("formula-student-car").with_changes(
        {"front.corner.bushings": dict.fromkeys(ARMS, SKEW)}
    )
    still = Trial(road=HalfSine(height="10 mm", length="2 m"), speed="10 m/s", duration="0.2 s")
    result = jn.simulate(car, still, tolerance=1e-7, detail=True)
    assert float(abs(result["body.roll"]).max()) < 1e-9
    for axis, sign in (("x", 1.0), ("y", -1.0), ("z", 1.0)):
        left, right = (
            result[f"front_{side}.lower_arm_front.f{axis}"] for side in ("left", "right")
        )
        assert np.allclose(left, sign * right, rtol=1e-5, atol=1e-2)


@pytest.mark.parametrize("point", ["tie_rod_inner"])
def test_beside_a_massless_rod_the_slope_at_design_acts(point):
    curve = {"kind": "table", "deflection": [-1e-3, 0.0, 1e-3], "force": [-400.0, 0.0, 200.0]}
    law = {"stiffness": [3e5, 0.0, 3e5], "curves": {"y": curve}, "x_axis": [1.0, 0.4, 0.0]}
    rig = on(law, (point,))
    slope = rig.bushings.tie_rod_inner.tangents[1]
    assert slope == pytest.approx(3e5)
    straight = {"stiffness": [3e5, slope, 3e5]}
    assert_same(run(on(straight, (point,))), run(rig))
    found = {item.code: item.place for item in parts.rig_findings(rig)}
    assert found["parts.curve_linear_in_runs"] == "bushings.tie_rod_inner.curves"
