"""A sweep from the other end has the same curves, bit by bit, in the other order."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

RACK = np.array([-0.02, -0.012, -0.003, 0.003, 0.011])  # two are as near to the middle
ANGLES = np.radians([-2.0, -0.5, 0.5, 1.0])
LOAD = jn.ContactLoad(lateral_force=500.0)
SWEEPS = {
    "travel": (jn.sweep_travel, RACK, {}),
    "rack": (jn.sweep_rack, RACK, {}),
    "axle roll": (jn.sweep_roll, ANGLES, {}),
    "axle rack": (jn.sweep_steering, RACK, {}),
    "points": (jn.sweep_travel, RACK, {"points": True}),
}


@pytest.mark.parametrize("name", SWEEPS)
def test_descending_values_give_the_ascending_curves_reversed(name):
    sweep, values, given = SWEEPS[name]
    rig = jn.load("reference-double-wishbone")
    up, down = sweep(rig, values, **given), sweep(rig, values[::-1], **given)
    (along,) = up.dims
    assert np.array_equal(down[along], values[::-1])
    for row in up.data_vars:
        np.testing.assert_array_equal(down[row], up[row][::-1], err_msg=row)


def test_both_grids_of_travel_and_rack_may_descend():
    rig = jn.load("reference-double-wishbone")
    up = jn.sweep_travel(rig, [-0.02, 0.01], [-0.01, 0.0, 0.02])
    down = jn.sweep_travel(rig, [0.01, -0.02], [0.02, 0.0, -0.01])
    np.testing.assert_array_equal(down["steer"], up["steer"][::-1, ::-1])


def test_the_end_of_travel_is_the_same_from_either_side():
    rig = jn.load("reference-double-wishbone")
    values = np.linspace(-0.3, 0.08, 20)
    up, down = jn.sweep_travel(rig, values), jn.sweep_travel(rig, values[::-1])
    assert up.attrs["stopped"] == down.attrs["stopped"]
    np.testing.assert_array_equal(down["camber"], up["camber"][::-1])


def test_steering_effort_and_pickup_loads_may_descend():
    rig = jn.load("reference-double-wishbone")
    up = jn.steering_effort(rig, LOAD, LOAD, [-0.01, 0.0, 0.01])
    down = jn.steering_effort(rig, LOAD, LOAD, [0.01, 0.0, -0.01])
    np.testing.assert_array_equal(down["rack_force"], up["rack_force"][::-1])
    up, down = (
        jn.pickup_loads(rig, LOAD, values) for values in ([-0.02, 0.0, 0.03], [0.03, 0.0, -0.02])
    )
    np.testing.assert_array_equal(down["tie_rod_outer.fy"], up["tie_rod_outer.fy"][::-1])
