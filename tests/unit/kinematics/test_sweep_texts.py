"""Sweeps take numbers in SI and texts with units, in every place where a value is given."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError

RIG = jn.load("reference-double-wishbone")
HEIGHT, RATE = "hardpoints.tie_rod_inner[2]", "hardpoints.upper_ball_joint[1]"


@pytest.mark.parametrize(
    ("values", "travel", "rack"),
    [
        ([0.18, 0.19], [-0.04, 0.0, 0.04], 0.01),
        (["180 mm", "19 cm"], ["-40 mm", 0.0, "4 cm"], "10 mm"),
        (("0.18 m", 0.19), "-40 mm:40 mm:40 mm", "1 cm"),
        (np.array([0.18, 0.19]), (-0.04, "0 mm", np.float64(0.04)), np.float64(0.01)),
    ],
)
def test_variants_take_texts_with_units(values, travel, rack):
    plain = jn.sweep_variants(RIG, {HEIGHT: [0.18, 0.19]}, [-0.04, 0.0, 0.04], rack=0.01)
    found = jn.sweep_variants(RIG, {HEIGHT: values}, travel, rack=rack)
    np.testing.assert_allclose(found["bump_steer"], plain["bump_steer"], rtol=1e-12)
    np.testing.assert_allclose(found[HEIGHT], [0.18, 0.19])


@pytest.mark.parametrize("sweep", [jn.sweep_travel, jn.sweep_rack])
def test_other_sweeps_take_texts_too(sweep):
    plain, found = sweep(RIG, [-0.01, 0.0, 0.02]), sweep(RIG, ["-10 mm", "0 mm", 0.02])
    np.testing.assert_allclose(found["toe"], plain["toe"], rtol=1e-12)


@pytest.mark.parametrize("sweep", [jn.sweep_roll])
def test_angles_take_texts_too(sweep):
    plain, found = sweep(RIG, np.deg2rad([-1.0, 0.0, 1.0])), sweep(RIG, ["-1 deg", 0.0, "1 deg"])
    np.testing.assert_allclose(found["roll_centre_height"], plain["roll_centre_height"], rtol=1e-12)


@pytest.mark.parametrize(
    ("changes", "travel", "text"),
    [
        ({HEIGHT: ["180 mm", "19 kg"]}, [0.0], r"changes: hardpoints.tie_rod_inner\[2\]\[1\].*kg"),
        ({HEIGHT: ["high"]}, [0.0], "high"),
        ({HEIGHT: [None]}, [0.0], "invalid physical value"),
        ({HEIGHT: [0.18]}, ["0 mm", "10 kg"], r"travel\[1\].*kg"),
        ({HEIGHT: [0.18]}, ["0 mm", "-10 mm", "5 mm"], "are not monotonic"),
        ({HEIGHT: [0.18], RATE: ["1 mm", "2 mm"]}, [0.0], "different lengths"),
        ({HEIGHT: []}, [0.0], "not a list"),
        ({HEIGHT: ["inf m"]}, [0.0], "inf"),
    ],
)
def test_wrong_texts_give_the_usual_message(changes, travel, text):
    with pytest.raises(DescriptionError, match=text):
        jn.sweep_variants(RIG, changes, travel)
