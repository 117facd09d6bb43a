from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

RIG = jn.load("reference-double-wishbone")


def test_the_sweep_stops_at_the_last_reachable_pose_and_keeps_the_rest() -> None:
    found = jn.sweep_travel(RIG, np.linspace(-0.3, 0.3, 61))
    assert found.attrs["status"] == "end_of_travel"
    assert found["wheel_travel"].to_numpy()[[0, -1]] == pytest.approx([-0.24, 0.27])
    assert np.all(np.isfinite(found["camber"]))
    assert "wheel travel 271.2 mm" in found.attrs["stopped"]
    assert "wheel travel -245 mm" in found.attrs["stopped"]
    assert "upper_ball_joint" in found.attrs["stopped"]
    inside = jn.sweep_travel(RIG, [-0.2, 0.0, 0.2])
    kept = found.sel(wheel_travel=[-0.2, 0.0, 0.2], method="nearest")
    assert kept["steer"].to_numpy() == pytest.approx(inside["steer"].to_numpy(), abs=1e-10)


def test_the_end_of_travel_is_where_the_arms_are_stretched() -> None:
    """A pure planar case: with the upper arm out of the way the lower one ends where arm and upright are in line."""
    rig = jn.load("semi-trailing-arm")
    centre = np.array(rig.hardpoints.wheel_centre)
    inner, outer = np.array(rig.hardpoints.arm_inner), np.array(rig.hardpoints.arm_outer)
    along = (outer - inner) / np.linalg.norm(outer - inner)
    foot = inner + along * ((centre - inner) @ along)
    reach = np.linalg.norm(centre - foot) * np.sqrt(
        1.0 - along[2] ** 2
    )  # highest point of the circle over its middle
    found = jn.sweep_travel(rig, np.linspace(0.0, 0.8, 161))
    highest = foot[2] + reach - centre[2]
    assert found.attrs["status"] == "end_of_travel"
    text = found.attrs["stopped"].split("wheel travel ")[1].split(" mm")[0]
    assert float(text) * 1e-3 == pytest.approx(highest, abs=1e-4)
    last = float(found["wheel_travel"][-1])
    assert highest - 0.005 <= last <= highest


def test_poses_stay_on_their_branch_up_to_the_end() -> None:
    """No jump to the other way of assembling the mechanism, however wide the steps are."""
    fine = jn.sweep_travel(RIG, np.linspace(0.0, 0.27, 1081))
    assert fine.attrs["status"] == "completed"
    for name in ("camber", "steer", "caster"):
        values = fine[name].to_numpy()
        steps = np.abs(np.diff(values))
        assert np.max(steps[1:] / np.maximum(steps[:-1], 1e-6)) < 5.0, name
    wide = jn.sweep_travel(RIG, [0.0, 0.27])
    assert float(wide["camber"][1]) == pytest.approx(float(fine["camber"][-1]), abs=1e-8)


def test_unreachable_pairs_are_left_out() -> None:
    found = jn.sweep_travel(RIG, [0.01, 0.02], rack=np.linspace(-0.12, 0.12, 7))
    assert found["rack_travel"].to_numpy()[0] == pytest.approx(-0.08)
    assert found["rack_travel"].to_numpy()[-1] == pytest.approx(0.12)
    assert (
        "at wheel travel 10 mm, rack travel -87.91 mm, on the way to 10 mm, -120 mm;"
        in found.attrs["stopped"]
    )


def test_nothing_reachable_is_an_error() -> None:
    with pytest.raises(jn.SimulationError, match="no pose of the sweep can be reached"):
        jn.sweep_travel(RIG, [0.4, 0.5])


def test_a_roll_too_far_keeps_what_can_be_reached() -> None:
    found = jn.sweep_roll(RIG, np.radians([-20.0, -10.0, 0.0, 10.0, 20.0]))
    assert np.degrees(found["roll_angle"].to_numpy()) == pytest.approx([-10.0, 0.0, 10.0])
    assert found.attrs["status"] == "end_of_travel"
    assert found.attrs["stopped"]
    with pytest.raises(jn.DescriptionError, match="too steep"):
        jn.sweep_roll(RIG, [2.0])


def test_many_ends_are_counted() -> None:
    found = jn.sweep_travel(RIG, [-0.3, 0.0, 0.3], rack=np.linspace(-0.02, 0.02, 9))
    assert found.attrs["stopped"].count("on the way to") == 4
    assert found.attrs["stopped"].endswith("; and 14 more ends of travel")


def test_a_toggle_is_told_before_the_mechanism_locks() -> None:
    near = jn.sweep_travel(RIG, np.linspace(-0.24, 0.08, 321))
    assert near.attrs["status"] == "completed"
    assert "near a toggle position" in near.attrs["findings"]
    assert (
        "wheel travel -237 mm: some parts move 3.08 times as fast" in near.attrs["findings"]
    )  # the first beyond 3 times
    assert jn.sweep_travel(RIG, np.linspace(-0.08, 0.08, 41)).attrs["findings"] == ""
    steered = jn.sweep_rack(jn.load("formula-student-front"), "-60 mm:60 mm:4 mm")
    assert "rack travel -" in steered.attrs["findings"]


def test_a_rocker_that_runs_away_is_told() -> None:
    """The lever of the strut on the rocker nearly vanishes at design, so the motion ratio grows from nothing."""
    rig = jn.load("formula-student-front")
    ratios = np.abs(jn.sweep_travel(rig, np.linspace(-0.03, 0.03, 13))["motion_ratio"].to_numpy())
    told = jn.sweep_travel(rig, np.linspace(-0.03, 0.03, 13)).attrs["findings"]
    assert ("motion ratio" in told) == bool(np.max(ratios) > 3.0 * ratios[6])


@pytest.mark.parametrize("travel", ["-20:20:2", "-20", [-20.0, 0.0, 20.0], 20.0])
def test_millimetres_given_as_metres_are_told(travel: object) -> None:
    with pytest.raises(jn.DescriptionError, match="a bare number is in metres") as caught:
        jn.sweep_travel(RIG, travel)
    assert "mm" in str(caught.value)
