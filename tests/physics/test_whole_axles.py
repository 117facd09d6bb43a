"""Axles of their own: attitudes against sweeps and rigid bodies, column against joints in space, effort, load cases."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

import jounce as jn
from jounce.kinematics.column import handwheel_angle, pinion_angle, rack_travel
from jounce.parts.elements import Steering

RIG = "formula-student-front"
CAR = {
    "axle": "front",
    "mass": 280.0,
    "wheelbase": 1.55,
    "centre_of_mass_height": 0.3,
    "weight_share": 0.48,
}
FRONT = jn.LoadedAxle(**CAR, brake_share=0.65, roll_share=0.5)
THIRD = {
    "third_spring": {"spring": {"rate": 30e3, "preload": 150.0}},
    "hardpoints.third_spring_end": [0.02, 0.21, 0.42],
}
U_BAR = {
    "hardpoints.arb_pivot": [-0.08, 0.15, 0.36],
    "hardpoints.arb_axis": [-0.18, 0.20, 0.33],
    "hardpoints.arb_arm_end": [-0.15, 0.12, 0.44],
    "hardpoints.arb_link_end": [0.0, 0.22, 0.43],
    "anti_roll_bar": {"stiffness": 900.0, "on": "rocker"},
}
T_BAR = {
    "hardpoints.arb_pivot": [-0.10, 0.0, 0.30],
    "hardpoints.arb_axis": [-0.08, 0.0, 0.45],
    "hardpoints.arb_arm_end": [-0.08, 0.16, 0.45],
    "hardpoints.arb_link_end": [0.0, 0.20, 0.44],
    "anti_roll_bar": {"stiffness": 400.0, "on": "rocker", "kind": "t"},
}


@pytest.fixture(scope="module")
def rig():
    return jn.load(RIG)


# attitudes ------------------------------------------------------------------------------------------------------------


def turned(axis: int, angle: float) -> np.ndarray:
    c, s = np.cos(angle), np.sin(angle)
    one, two = [(1, 2), (2, 0), (0, 1)][axis]
    matrix = np.eye(3)
    matrix[one, one], matrix[one, two], matrix[two, one], matrix[two, two] = c, -s, s, c
    return matrix


def test_both_wheels_stand_on_the_road_in_any_attitude(rig) -> None:
    """The body is put over a flat road; each wheel's circle, turned with it, touches z = 0 with its lowest point."""
    heave, roll, pitch, rack = -0.008, 0.02, 0.015, 0.006
    found = jn.sweep_axle(rig, heave=heave, roll=roll, pitch=pitch, rack=rack)
    design = jn.sweep_axle(rig, heave=0.0)
    assert float(design["left.wheel_travel"][0]) == pytest.approx(0.0, abs=1e-12)
    middle = np.array([0.0, 0.0, float(design["left.contact_point_z"][0])])
    body = turned(1, pitch) @ turned(0, roll)
    for name, side in (("left", 1.0), ("right", -1.0)):
        camber, steer = (float(found[f"{name}.{row}"][0]) for row in ("camber", "steer"))
        axis = np.array(
            [-side * np.sin(steer), side * np.cos(steer), -np.tan(camber)]
        )  # outboard, from its angles
        axis = body @ (axis / np.linalg.norm(axis))
        centre = np.array([float(found[f"{name}.wheel_centre_{a}"][0]) for a in "xyz"])
        centre = body @ (centre - middle) + [0.0, 0.0, heave]
        lowest = centre[2] - 0.228 * np.sqrt(1.0 - axis[2] ** 2)
        assert lowest == pytest.approx(0.0, abs=1e-11)
        assert float(found[f"{name}.camber_to_ground"][0]) == pytest.approx(
            -np.arcsin(axis[2]), abs=1e-12
        )
        ahead, nose = np.cross(axis * side, [0.0, 0.0, 1.0]), body @ [1.0, 0.0, 0.0]
        heading = np.arctan2(ahead[1], ahead[0]) - np.arctan2(nose[1], nose[0])
        assert float(found[f"{name}.steer_to_ground"][0]) == pytest.approx(heading, abs=1e-12)
    travels = {
        f"{name}_travel": float(found[f"{name}.wheel_travel"][0]) for name in ("left", "right")
    }
    again = jn.sweep_axle(rig, **travels, pitch=pitch, rack=rack)
    assert float(again["heave"][0]) == pytest.approx(heave, abs=1e-12)
    assert float(again["roll_angle"][0]) == pytest.approx(roll, abs=1e-12)


def test_an_axle_of_a_corner_and_its_mirror_is_that_of_one_file(rig) -> None:
    poses = {"left_travel": [0.01, -0.012], "right_travel": [-0.005, 0.004], "rack": 0.004}
    one, both = jn.sweep_axle(rig, **poses), jn.sweep_axle(rig, right=rig.mirrored(), **poses)
    for name in one.data_vars:
        assert both[name].to_numpy() == pytest.approx(
            one[name].to_numpy(), abs=1e-12, nan_ok=True
        ), name
    moved = rig.mirrored().with_changes({"hardpoints.upper_ball_joint[1]": "-541 mm"})
    other = jn.sweep_axle(rig, right=moved, **poses)
    assert other["left.camber"].to_numpy() == pytest.approx(
        one["left.camber"].to_numpy(), abs=1e-14
    )
    alone = jn.sweep_path(moved, poses["right_travel"], 0.004)
    for row in ("camber", "steer", "wheel_centre_y", "motion_ratio"):
        assert other[f"right.{row}"].to_numpy() == pytest.approx(alone[row].to_numpy(), abs=1e-12)
    assert np.all(other["right.camber"] != one["right.camber"])
    rolled = jn.sweep_axle(rig, roll=0.02)
    against = jn.sweep_roll(
        rig, [0.02]
    )  # there the body neither rises nor sinks by more than the tyres' circles ask
    assert float(rolled["left.camber_to_ground"][0]) == pytest.approx(
        float(against["left.camber_to_ground"][0]), abs=2e-3
    )


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"left_travel": 0.01, "roll": 0.01}, "a body attitude are both given"),
        ({"heave": [0.0, 0.01], "roll": [0.0, 0.01, 0.02]}, "different numbers of values"),
        ({"left_travel": 20.0}, "Millimetres meant"),
        ({"roll": 2.0}, "too steep"),
        ({"handwheel": "30 deg"}, "the rack has no handwheel"),
        ({"rack": 0.0, "handwheel": 0.0}, "Give only one"),
    ],
)
def test_bad_poses_of_an_axle(rig, given, message: str) -> None:
    with pytest.raises(jn.DescriptionError, match=message):
        jn.sweep_axle(rig, **given)


def test_corners_that_are_no_axle(rig) -> None:
    with pytest.raises(jn.DescriptionError, match="not a right corner"):
        jn.sweep_axle(rig, right=rig, heave=0.0)
    with pytest.raises(jn.DescriptionError, match="both corners of an axle"):
        jn.sweep_axle(rig.with_changes(THIRD), right=rig.mirrored(), heave=0.0)


# column ---------------------------------------------------------------------------------------------------------------

COLUMN = {
    "handwheel": [-0.6, 0.3, 0.9],
    "upper_joint": [-0.2, 0.3, 0.7],
    "lower_joint": [0.1, 0.22, 0.45],
    "pinion": [0.25, 0.2, 0.2],
    "yoke_angle": 0.3,
    "phase": 0.4,
}


def test_shafts_turn_as_their_crosses_ask() -> None:
    """Each cross has one pin in either yoke: both yokes are followed in space, and their pins stay at right angles."""
    steering = Steering(rack_ratio=0.013, column=COLUMN)
    angles = np.radians(np.linspace(-400.0, 400.0, 81))
    found, slope = pinion_angle(steering, angles)
    points = [
        np.array(COLUMN[name]) for name in ("handwheel", "upper_joint", "lower_joint", "pinion")
    ]
    shafts = [(b - a) / np.linalg.norm(b - a) for a, b in pairwise(points)]

    def about(axis: np.ndarray, vector: np.ndarray, angle: float) -> np.ndarray:
        return (
            vector * np.cos(angle)
            + np.cross(axis, vector) * np.sin(angle)
            + axis * (axis @ vector) * (1.0 - np.cos(angle))
        )

    def end_pin(angle: float) -> np.ndarray:
        pin = np.cross(shafts[0], shafts[1])
        pin = about(
            shafts[0], pin / np.linalg.norm(pin), 0.3 - angle
        )  # to the left is left-handed about the shaft
        for i, (one, other) in enumerate(pairwise(shafts)):
            pin = np.cross(other, pin) if i == 0 else np.cross(other, about(one, pin, 0.4))
            pin = pin / np.linalg.norm(pin)
        return pin

    start = end_pin(0.0)
    seen = []
    for angle in angles:
        now = end_pin(angle)
        seen.append(-np.arctan2(np.cross(start, now) @ shafts[2], start @ now))
    seen = np.unwrap(np.array(seen), period=np.pi)  # a pin has no front
    seen = seen - seen[40]
    assert found == pytest.approx(seen, abs=1e-9)
    assert np.ptp(found - angles) > 0.05  # it does not turn evenly
    step = 1e-6
    ahead, behind = (pinion_angle(steering, angles + sign * step)[0] for sign in (1.0, -1.0))
    assert slope == pytest.approx((ahead - behind) / (2.0 * step), abs=1e-8)
    racks = rack_travel(steering, angles)[0]
    assert handwheel_angle(steering, racks) == pytest.approx(angles, abs=1e-11)


def test_two_equal_joints_in_phase_turn_evenly() -> None:
    """A Z-column of equal bends in one plane with parallel yokes passes the angle on unchanged; one joint does not."""
    points = {
        "handwheel": [0, 0, 0],
        "upper_joint": [1, 0, 0],
        "lower_joint": [2, 0, -0.5],
        "pinion": [3, 0, -0.5],
    }
    even = Steering(rack_ratio=0.01, column=points)
    angles = np.linspace(-6.0, 6.0, 41)
    assert pinion_angle(even, angles)[0] == pytest.approx(angles, abs=1e-12)
    crossed = Steering(rack_ratio=0.01, column={**points, "phase": 0.5 * np.pi})
    bend = np.cos(np.arctan(0.5))
    slope = pinion_angle(crossed, np.zeros(1))[1][0]
    assert slope == pytest.approx(bend**2, rel=1e-12) or slope == pytest.approx(bend**-2, rel=1e-12)
    one = Steering(
        rack_ratio=0.01,
        column={key: points[key] for key in ("handwheel", "upper_joint")}
        | {"pinion": [2, 0, -0.5]},
    )
    turned = pinion_angle(one, angles)[0]
    assert np.tan(turned) == pytest.approx(bend * np.tan(angles), rel=1e-9)


@pytest.mark.parametrize(
    ("table", "message"),
    [
        ({"rack_ratio": 0.0}, "does not move"),
        ({"column": COLUMN}, "without a rack"),
        ({"rack_ratio": 0.01, "column": {**COLUMN, "pinion": [0.1, 0.22, 0.45]}}, "coincides"),
        (
            {"rack_ratio": 0.01, "column": {**COLUMN, "pinion": [-0.5, 0.22, 0.45]}},
            "bends the column",
        ),
    ],
)
def test_columns_that_cannot_be(rig, table, message: str) -> None:
    with pytest.raises(jn.DescriptionError, match=message):
        rig.with_changes({"steering": table})


# effort ---------------------------------------------------------------------------------------------------------------


def uprights(found) -> list[np.ndarray]:
    """Frame of the upright at each pose, from three of its points: one of them and three vectors, shape (3, 4)."""
    names = ("lower_ball_joint", "upper_ball_joint", "tie_rod_outer")
    points = np.array(
        [[found[f"{name}.{axis}"].to_numpy() for axis in "xyz"] for name in names]
    ).transpose(2, 0, 1)
    return [np.column_stack([a, b - a, c - a, np.cross(b - a, c - a)]) for a, b, c in points]


def test_effort_is_the_work_of_the_road_over_the_turn_of_the_handwheel(rig) -> None:
    """Virtual work of the point of the upright at the contact as the rack moves, the spring kept at its length."""
    steered = rig.with_changes({"steering": {"rack_ratio": 0.013, "column": COLUMN}})
    left = jn.ContactLoad(lateral_force=900.0, aligning_torque=-20.0, vertical_force=800.0)
    right = jn.ContactLoad(lateral_force=1400.0, aligning_torque=-35.0, longitudinal_force=100.0)
    rack, step = 0.008, 1e-5
    effort = jn.steering_effort(steered, left, right, rack)
    work, two = 0.0, step * np.array([-1.0, 1.0])
    for side, load in ((steered, left), (steered.mirrored(), right)):
        held = np.diff(jn.sweep_path(side, 0.0, rack + two)["spring_length"])[0]
        held = (
            -held / np.diff(jn.sweep_path(side, two, rack)["spring_length"])[0]
        )  # travel for one of the rack
        at = jn.sweep_path(side, 0.0, rack, points=True)
        contact = np.array([float(at[f"contact_point_{axis}"][0]) for axis in "xyz"])
        (now,), (before, after) = (
            uprights(at),
            uprights(jn.sweep_path(side, held * two, rack + two, points=True)),
        )
        share = np.linalg.solve(now[:, 1:], contact - now[:, 0])
        rate = (after - before) @ [1.0, *share] / (2.0 * step)
        spin = (after[:, 1:] - before[:, 1:]) @ np.linalg.inv(now[:, 1:]) / (2.0 * step)
        work += (
            load.longitudinal_force * rate[0]
            + load.lateral_force * rate[1]
            + load.vertical_force * rate[2]
        )
        work += load.aligning_torque * 0.5 * (spin[1, 0] - spin[0, 1])
    assert float(effort["rack_force"][0]) == pytest.approx(work, rel=1e-6)
    ratio = float(effort["c_factor"][0]) / (2.0 * np.pi)
    assert float(effort["handwheel_torque"][0]) == pytest.approx(-work * ratio, rel=1e-5)
    assert float(effort["pinion_torque"][0]) == pytest.approx(-work * 0.013, rel=1e-5)
    axle = jn.sweep_axle(steered, handwheel=float(effort["handwheel_angle"][0]))
    assert float(axle["right.rack_travel"][0]) == pytest.approx(rack, abs=1e-12)
    assert float(axle["steering_ratio"][0]) == pytest.approx(
        float(effort["steering_ratio"][0]), rel=1e-9
    )
    two = [
        float(jn.sweep_axle(steered, handwheel=a)["mean_steer"][0])
        for a in (0.2 - 1e-5, 0.2 + 1e-5)
    ]
    ratio = float(jn.sweep_axle(steered, handwheel=0.2)["steering_ratio"][0])
    assert 2e-5 / (two[1] - two[0]) == pytest.approx(ratio, rel=1e-6)


# load cases -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("parts", [{**U_BAR, **THIRD}, {**T_BAR, **THIRD}], ids=["u", "t"])
def test_bars_and_third_springs_count_in_load_cases(rig, parts) -> None:
    sprung = rig.with_changes(parts)
    cases = {"static": {}, "turn": {"lateral": 1.0, "longitudinal": -0.5}}
    found, plain = jn.load_cases(sprung, FRONT, cases), jn.load_cases(rig, FRONT, cases)
    body = [
        "lower_arm_front",
        "lower_arm_rear",
        "upper_arm_front",
        "upper_arm_rear",
        "tie_rod_inner",
        "rocker_pivot",
    ]
    body += ["strut_top", "arb_pivot", "third_spring_end"]
    for axis, road in (
        ("x", "longitudinal_force"),
        ("y", "lateral_force"),
        ("z", "vertical_force"),
    ):
        total = sum(found[f"{name}.f{axis}"] for name in body)
        assert total.to_numpy() == pytest.approx(found[road].to_numpy(), abs=1e-6)
    for wheel, side in (
        ("left", sprung),
        ("right", sprung.mirrored()),
    ):  # the laws give what the balance asks for
        one = found.sel(case="turn", wheel=wheel)
        swept = jn.sweep_travel(side, float(one["wheel_travel"]))
        has = float(swept["spring_force"][0] + swept["stop_force"][0])
        assert has == pytest.approx(float(one["spring.force"]), rel=1e-6)
    turn = found.sel(case="turn")
    leaned = [
        abs(float(np.diff(one.sel(case="turn")["wheel_travel"])[0])) for one in (found, plain)
    ]
    assert leaned[0] < 0.97 * leaned[1]
    force = turn["third_spring.force"].to_numpy()
    assert force[0] == force[1]
    ends = [
        np.array([float(turn[f"third_spring_end.f{a}"].sel(wheel=w)) for a in "xyz"])
        for w in ("left", "right")
    ]
    assert ends[0] == pytest.approx(-ends[1], abs=1e-9)  # one spring between both
    assert np.linalg.norm(ends[0]) == pytest.approx(abs(force[0]), rel=1e-9)
    assert ends[0][1] * force[0] < 0.0  # compressed, it is pushed inwards by the left side
    static = found.sel(case="static")["anti_roll_bar_link.axial_force"].to_numpy()
    assert static == pytest.approx(0.0, abs=1e-6)
    assert np.abs(turn["anti_roll_bar_link.axial_force"].to_numpy()).min() > 20.0
    assert found.attrs["findings"] == ""
