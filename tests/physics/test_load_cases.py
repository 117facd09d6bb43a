"""Load cases of an axle: weights and load transfer by hand, every joint in balance, both sides alike."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.parts.leverage import motion_ratio, static_load, static_spring_force

CAR = {
    "axle": "front",
    "mass": 280.0,
    "wheelbase": 1.55,
    "centre_of_mass_height": 0.3,
    "weight_share": 0.48,
}
FRONT = jn.LoadedAxle(**CAR, brake_share=0.65, roll_share=0.5)
G = 280.0 * 9.80665


@pytest.fixture(scope="module")
def found():
    return jn.load_cases(jn.load("formula-student-front"), FRONT)


def test_wheel_loads_by_hand(found) -> None:
    load = found["vertical_force"]
    static = 0.5 * 0.48 * G
    gravity = float(load.sel(case="static", wheel="left")) / static
    assert gravity == pytest.approx(1.0, rel=2e-3)  # 9.80665 or 9.81 m/s^2
    unit = G * gravity
    braked = float(load.sel(case="braking 1 g").sum())
    assert braked == pytest.approx(0.48 * unit + unit * 0.3 / 1.55, rel=1e-12)
    turned = load.sel(case="cornering 1 g").to_numpy()  # to the left: the right wheel is loaded
    track = 2.0 * (
        0.6 + 0.228 * np.sin(np.radians(1.5))
    )  # of the contact points: wheels of 228 mm lean inwards
    transfer = unit * 0.3 * 0.5 / track
    assert turned == pytest.approx([0.24 * unit - transfer, 0.24 * unit + transfer], rel=1e-12)
    assert load.sel(case="bump 3 g").to_numpy() == pytest.approx(3.0 * static * gravity)
    forward = found["longitudinal_force"].sel(case="braking 1 g").to_numpy()
    assert forward == pytest.approx(-0.5 * 0.65 * unit, rel=1e-12)
    sideways = found["lateral_force"].sel(case="cornering 1 g")
    assert float(sideways.sum()) == pytest.approx(0.48 * unit, rel=1e-12)
    assert float(sideways.sel(wheel="right")) > float(sideways.sel(wheel="left"))


def test_what_the_body_takes_is_what_the_road_gives(found) -> None:
    body = (
        "lower_arm_front",
        "lower_arm_rear",
        "upper_arm_front",
        "upper_arm_rear",
        "tie_rod_inner",
    )
    body += ("rocker_pivot", "strut_top")
    for axis, road in (
        ("x", "longitudinal_force"),
        ("y", "lateral_force"),
        ("z", "vertical_force"),
    ):
        total = sum(found[f"{name}.f{axis}"] for name in body)
        assert total.to_numpy() == pytest.approx(found[road].to_numpy(), abs=1e-6)


def test_each_wheel_stands_where_its_spring_carries_it(found) -> None:
    rig = jn.load("formula-student-front")
    for wheel, side in (("left", rig), ("right", rig.mirrored())):
        one = found.sel(case="cornering 1 g", wheel=wheel)
        swept = jn.sweep_travel(side, float(one["wheel_travel"]))
        has = float(swept["spring_force"][0] + swept["stop_force"][0])
        assert has == pytest.approx(float(one["spring.force"]), rel=1e-4)


def test_the_gas_of_a_damper_carries_the_car_too() -> None:
    """Of a table that does not pass zero: its force pushes both ends apart, and the spring carries the rest."""
    law = {"velocity": [-1.0, 0.0, 1.0], "force": [-1800.0, 200.0, 1600.0]}
    rig = jn.load("formula-student-front").with_changes({"strut.damper": law})
    found = jn.load_cases(rig, FRONT, {"static": {}}).sel(case="static", wheel="left")
    travel, load = float(found["wheel_travel"]), float(found["vertical_force"])
    rest = jn.sweep_travel(rig, [travel]).isel(wheel_travel=0)
    rise = float(rest["motion_ratio"] / rest["motion_ratio_contact"])
    strut = 200.0 * float(rest["damper_motion_ratio"]) + float(
        rest["spring_force"] * rest["motion_ratio"]
    )
    assert strut == pytest.approx(load * rise, rel=1e-4)
    assert float(found["damper.force"]) == pytest.approx(200.0, rel=1e-12)
    near = jn.sweep_travel(rig, travel + 1e-4 * np.array([-1.0, 1.0]))
    assert float(rest["wheel_rate"]) == pytest.approx(
        float(np.diff(near["wheel_force"])[0]) / 2e-4, rel=1e-6
    )
    body = (
        "lower_arm_front",
        "lower_arm_rear",
        "upper_arm_front",
        "upper_arm_rear",
        "tie_rod_inner",
    )
    for axis, road in (("x", 0.0), ("y", 0.0), ("z", load)):
        total = sum(
            float(found[f"{name}.f{axis}"]) for name in (*body, "rocker_pivot", "strut_top")
        )
        assert total == pytest.approx(road, abs=1e-6)
    carried = static_spring_force(rig) * motion_ratio(rig) + 200.0 * motion_ratio(rig, "damper")
    assert carried == pytest.approx(static_load(rig), rel=1e-12)


def test_a_straight_case_is_the_same_on_both_sides(found) -> None:
    one, other = (found.sel(case="braking 1 g", wheel=wheel) for wheel in ("left", "right"))
    for name in ("lower_ball_joint.fx", "tie_rod.axial_force", "spring.force", "strut_top.fz"):
        assert float(one[name]) == pytest.approx(float(other[name]), rel=1e-9, abs=1e-6)
    assert float(one["lower_ball_joint.fy"]) == pytest.approx(
        -float(other["lower_ball_joint.fy"]), rel=1e-9
    )


def test_a_wheel_is_not_pulled_down_by_the_road() -> None:
    lifted = jn.load_cases(
        jn.load("formula-student-front"), FRONT, {"2.5 g": {"lateral": 2.5, "vertical": 0.8}}
    )
    load = lifted["vertical_force"].sel(case="2.5 g").to_numpy()
    assert load[0] == 0.0
    assert load[1] == pytest.approx(0.8 * 2.0 * 0.24 * G, rel=2e-3)


def test_both_wheels_of_the_only_axle_balance_the_car_in_roll() -> None:
    whole = {
        **CAR,
        "weight_share": 1.0,
        "roll_share": 1.0,
        "brake_share": 1.0,
    }  # all of the car on this axle
    rig = jn.load("formula-student-front")
    turned = jn.load_cases(rig, jn.LoadedAxle(**whole), {"0.5 g": {"lateral": 0.5}}).sel(
        case="0.5 g"
    )
    places = [
        float(jn.sweep_travel(one, 0.0)["contact_point_y"][0]) for one in (rig, rig.mirrored())
    ]
    moment = sum(
        y * load for y, load in zip(places, turned["vertical_force"].to_numpy(), strict=True)
    )
    assert -moment == pytest.approx(float(turned["lateral_force"].sum()) * 0.3, rel=1e-12)


@pytest.mark.parametrize(("longitudinal", "lifted"), [(-3.0, "rear"), (3.0, "front")])
def test_both_axles_never_carry_more_than_the_car_weighs(longitudinal, lifted) -> None:
    case, rig = {"tips": {"longitudinal": longitudinal}}, jn.load("formula-student-front")
    total = 0.0
    for axle, share in (("front", 0.48), ("rear", 0.52)):
        car = jn.LoadedAxle(**{**CAR, "axle": axle, "weight_share": share, "brake_share": share})
        found = jn.load_cases(rig, car, case)
        total += float(found["vertical_force"].sum())
        assert (
            f"tips: the car would tip over: the load on its {lifted} axle is -"
            in found.attrs["findings"]
        )
    assert total == pytest.approx(280.0 * 9.81, rel=2e-3)


def test_a_table_has_a_row_for_each_case_and_wheel(found) -> None:
    lines = jn.load_case_table(found).splitlines()
    assert len(lines) == 1 + 2 * found.sizes["case"]
    assert lines[1].startswith('"static",left,')
    assert len(lines[1].split(",")) == len(lines[0].split(","))
    assert np.isfinite([float(value) for value in lines[3].split(",")[2:]]).all()


def test_what_the_spring_cannot_carry_is_told(found) -> None:
    assert "bump 3 g, left wheel: spring and stops cannot carry the load" in found.attrs["findings"]
    assert "static" not in found.attrs["findings"]
    with pytest.raises(jn.DescriptionError, match="no load case"):
        jn.load_cases(jn.load("formula-student-front"), FRONT, {})
