from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.kinematics.axle import WheelRows
from jounce.kinematics.sweeps import prepare_sweep

RIG = jn.load("reference-double-wishbone")
TRAVEL = np.linspace(-0.08, 0.08, 41)


def test_units_signs_and_coordinates() -> None:
    found = jn.sweep_travel(RIG, TRAVEL)
    assert found["camber"].dims == ("wheel_travel",)
    assert found["camber"].attrs["units"] == "rad"
    assert found["camber"].attrs["clause"] == "ISO 23365:2022, 7.1.5"
    assert found["wheel_travel"].attrs["units"] == "m"
    assert np.array_equal(found["wheel_travel"], TRAVEL)
    assert float(found["rack_travel"]) == 0.0
    assert found.attrs["status"] == "completed"
    assert found.attrs["stopped"] == ""


def test_the_axis_of_a_wheel_turns_by_both_its_angles() -> None:
    def wheel(travel: float) -> WheelRows:  # leaning and steered far more than any wheel
        rows = {
            "camber": 0.7 + 0.5 * travel,
            "steer": 0.4 - 0.3 * travel,
            "camber_gain": 0.5,
            "bump_steer": -0.3,
        }
        return WheelRows({name: np.array([value]) for name, value in rows.items()}, 0.3)

    np.testing.assert_allclose(np.linalg.norm(wheel(0.0).axis, axis=1), 1.0, rtol=1e-14)
    slope = (wheel(1e-4).axis - wheel(-1e-4).axis) / 2e-4
    np.testing.assert_allclose(wheel(0.0).axis_slope, slope, rtol=1e-7)


def test_order_and_fineness_do_not_matter() -> None:
    """A pose is the same whichever way the sweep came to it."""
    coarse = jn.sweep_travel(RIG, [-0.08, 0.08])
    fine = jn.sweep_travel(RIG, np.linspace(-0.08, 0.08, 401))
    for name in coarse.data_vars:
        ends = fine[name].to_numpy()[[0, -1]]
        assert coarse[name].to_numpy() == pytest.approx(ends, rel=1e-9, abs=1e-12), name


def test_pairs_agree_with_single_sweeps() -> None:
    rack = np.array([-0.02, 0.0, 0.015])
    pairs = jn.sweep_travel(RIG, TRAVEL[::5], rack)
    assert pairs["steer"].dims == ("wheel_travel", "rack_travel")
    assert np.array_equal(pairs["rack_travel"], rack)
    for y in rack:
        single = jn.sweep_travel(RIG, TRAVEL[::5], float(y))
        for name in single.data_vars:
            values = pairs[name].sel(rack_travel=y).to_numpy()
            assert values == pytest.approx(single[name].to_numpy(), rel=1e-9, abs=1e-12), name
    steered = jn.sweep_rack(RIG, rack, travel=float(TRAVEL[10]))
    assert steered["camber"].to_numpy() == pytest.approx(pairs["camber"].to_numpy()[2], rel=1e-9)
    assert steered["camber"].dims == ("rack_travel",)
    assert float(steered["wheel_travel"]) == TRAVEL[10]


def test_the_description_says_the_rack_travel() -> None:
    rig = RIG.with_changes({"steering": {"rack_travel": 0.01}})
    turned = jn.sweep_travel(rig, [0.0, 0.02])
    assert float(turned["rack_travel"]) == 0.01
    assert turned["steer"].to_numpy() == pytest.approx(
        jn.sweep_travel(RIG, [0.0, 0.02], 0.01)["steer"].to_numpy()
    )
    assert float(jn.sweep_travel(rig, 0.0, 0.0)["steer"][0]) == pytest.approx(0.0, abs=1e-12)


def test_points_move_with_their_bodies() -> None:
    found = jn.sweep_travel(RIG, TRAVEL[::10], points=True)

    def place(name: str) -> np.ndarray:
        return np.stack([found[f"{name}.{axis}"].to_numpy() for axis in "xyz"], axis=1)

    for name, design in RIG.hardpoints.given().items():
        assert place(name)[2] == pytest.approx(np.array(design), abs=1e-13), name
    for one, other in (
        ("lower_arm_front", "lower_ball_joint"),
        ("lower_ball_joint", "upper_ball_joint"),
        ("tie_rod_inner", "tie_rod_outer"),
        ("strut_bottom", "lower_ball_joint"),
        ("wheel_centre", "tie_rod_outer"),
    ):
        gaps = np.linalg.norm(place(one) - place(other), axis=1)
        assert np.ptp(gaps) < 1e-13, (one, other)
    assert place("contact_point")[:, 1] == pytest.approx(
        found["contact_point_y"].to_numpy(), abs=1e-14
    )
    assert place("wheel_centre")[:, 2] == pytest.approx(0.3 + TRAVEL[::10], abs=1e-13)
    moved = jn.sweep_travel(RIG, [0.0], 0.01, points=True)
    assert float(moved["tie_rod_inner.y"][0]) == pytest.approx(0.39, abs=1e-14)


def test_prepared_sweeps_run_again() -> None:
    sweep = prepare_sweep(RIG, TRAVEL)
    first = sweep.run().copy()
    assert np.array_equal(first, sweep.run())


def test_a_trailing_arm_has_no_rack() -> None:
    arm = jn.load("semi-trailing-arm")
    with pytest.raises(jn.DescriptionError, match="this wheel has no steering rack"):
        jn.sweep_travel(arm, 0.0, 0.01)
    with pytest.raises(jn.DescriptionError, match="this wheel has no steering rack"):
        jn.sweep_rack(arm, [0.0, 0.01])
    assert jn.sweep_travel(arm, 0.0, 0.0)["camber"].shape == (1,)


@pytest.mark.parametrize("bad", [[0.0, 0.02, 0.01], [], [np.nan], "wide", [None]])
def test_bad_travel_is_refused(bad: object) -> None:
    with pytest.raises(jn.DescriptionError, match="wheel travel"):
        jn.sweep_travel(RIG, bad)  # type: ignore[arg-type]


def test_bilinear_dampers_count_with_the_mean_of_both_directions() -> None:
    rig = RIG.with_changes(
        {"strut.damper": {"bump_coefficient": 1000.0, "rebound_coefficient": 3000.0}}
    )
    found, ratio = (
        jn.sweep_travel(rig, 0.0),
        float(jn.sweep_travel(RIG, 0.0)["damper_motion_ratio"][0]),
    )
    assert float(found["wheel_damping_coefficient"][0]) == pytest.approx(
        2000.0 * ratio**2, rel=1e-9
    )


def test_stops_work_where_they_touch() -> None:
    rig = RIG.with_changes(
        {
            "strut.bump_stop": {"gap": 0.02, "rate": 50e3},
            "strut.rebound_stop": {"gap": 0.03, "rate": 1e5},
        }
    )
    found = jn.sweep_travel(rig, [-0.08, 0.0, 0.08])
    short = RIG.hardpoints.length("spring") - found["spring_length"].to_numpy()
    expected = [1e5 * (short[0] + 0.03), 0.0, 50e3 * (short[2] - 0.02)]
    assert found["stop_force"].to_numpy() == pytest.approx(expected, rel=1e-9)
    stiff = found["wheel_rate_spring"] / found["motion_ratio"] ** 2
    rate = RIG.strut.spring.rate
    assert stiff.to_numpy() == pytest.approx([rate + 1e5, rate, rate + 50e3], rel=1e-9)


def test_ranges_as_text() -> None:
    found = jn.sweep_travel(RIG, "-80 mm:80 mm:4 mm", "-10 mm:10 mm:10 mm")
    assert found["camber"].shape == (41, 3)
    assert np.array_equal(found["wheel_travel"], np.round(TRAVEL, 12))
    assert jn.sweep_travel(RIG, "20 mm", "5 mm")["camber"].dims == ("wheel_travel",)
    assert float(jn.sweep_rack(RIG, "-5 mm:5 mm:5 mm", "20 mm")["wheel_travel"]) == 0.02
    assert jn.sweep_roll(RIG, "-1 deg:1 deg:1 deg", "5 mm")["roll_angle"].shape == (3,)
