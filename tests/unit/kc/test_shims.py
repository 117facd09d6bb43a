"""Shim tables: slopes against the kinematics, the shim that is sought, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError


def test_slopes_are_those_of_the_kinematics_of_the_moved_point() -> None:
    """Joints of the shipped rig are ideal, so that the rig's bump steer is that of a sweep."""
    rig = jn.load("formula-student-front")
    table = jn.kc_shims(rig, shims=["-2 mm", "0 mm", "3 mm"], over="10 mm")
    z = rig.hardpoints.tie_rod_outer[2]
    for row in table.rows:
        moved = rig.with_changes({"hardpoints.tie_rod_outer[2]": z + row.shim})
        sweep = jn.sweep_travel(moved, np.linspace(-0.01, 0.01, 5))
        rise, toe = sweep["contact_point_z"].values, sweep["toe"].values
        assert row.slope == pytest.approx(np.polyfit(rise - rise[2], toe, 1)[0], rel=5e-3)
    assert table.slope_unit == "rad/m"


def test_the_shim_that_is_sought_gives_the_wanted_slope() -> None:
    rig = jn.load("formula-student-front")
    table = jn.kc_shims(rig, shims="-4 mm:4 mm:2 mm", wanted="2 deg/m")
    assert table.shim is not None
    assert 0.0 < table.shim < 0.002
    again = jn.kc_shims(rig, shims=[table.shim])
    assert again.rows[0].slope == pytest.approx(np.radians(2.0), rel=1e-6)
    assert "gives 2.000 deg/m" in str(table)
    assert table.rows[0].at_low > 0.0 > table.rows[-1].at_low
    assert jn.kc_shims(rig, shims="-4 mm:4 mm:4 mm", wanted="20 deg/m").shim is None


def test_other_points_directions_tests_and_axles() -> None:
    beam = jn.kc_shims(
        jn.load("twist-beam"),
        "pivot",
        "0 mm:20 mm:10 mm",
        test="roll",
        quantity="steer",
        wanted=-0.05,
    )
    assert beam.shim == pytest.approx(0.0153, abs=5e-4)
    force = {"test": "lateral-in-phase", "quantity": "right.toe", "over": "1 kN"}
    axle = jn.load("mcpherson-elastic")
    up, across = (
        jn.kc_shims(axle, "tie_rod_inner", ["2 mm"], along=along, **force).rows[0].slope
        for along in ("z", (0, 2, 0))
    )
    assert up != across


def test_shims_with_which_nothing_fits_are_named() -> None:
    rig = jn.load("formula-student-front")
    points = rig.hardpoints
    reach = np.array(points.tie_rod_inner) - np.array(points.tie_rod_outer)
    whole = float(np.linalg.norm(reach))  # the rod has no length left
    table = jn.kc_shims(rig, "tie_rod_outer", [0.0, whole], along=tuple(reach))
    assert table.rows[1].slope is None
    assert [item.code for item in table.findings] == ["kc.shims_left_out"]


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"point": "tie_rod_uter"}, "tie_rod_outer"),
        ({"shims": "5 mm:-5 mm:0 mm"}, "shims"),
        ({"shims": ["1 mm", "1 mm"]}, "monotonic"),
        ({"shims": "1 N"}, "m"),
        ({"along": "up"}, "x, y, z"),
        ({"along": (0.0, 0.0, 0.0)}, "direction"),
        ({"test": "bump"}, "bounce"),
        ({"quantity": "toes"}, "toe"),
        ({"wanted": "1 deg"}, "rad/m"),
        ({"over": ("1 mm", "2 mm", "3 mm")}, "two ends"),
        ({"over": "1 mm"}, "two inputs"),
    ],
)
def test_refused(given: dict, said: str) -> None:
    with pytest.raises(DescriptionError, match=said):
        jn.kc_shims(jn.load("formula-student-front"), **given)
