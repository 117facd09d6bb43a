"""Worked examples of suspension geometry whose text could be read: the numbers as printed, on mechanisms made for them.

Sources (title, page): CalculatorAtoZ, "Angle of Outside Wheel Lock Satisfying Correct Steering Condition", Calc-31583,
and "Turning Radius of Outer Front Wheel", Calc-31639; Super 7th Heaven, "Anti Dive Geometry"; calculator.7search.cc,
"Wheel Rate Calculator". A printed number is met to half a unit of its last digit.
"""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

import jounce as jn
from jounce.parts import rig_from_table

pytestmark = pytest.mark.source(
    kind="published",
    of="suspension kinematics",
    key="worked-examples",
    where="CalculatorAtoZ 31583 and 31639, Anti Dive Geometry, Wheel Rate Calculator",
    tolerance="half a unit of the last printed digit",
)

INCH, POUND_FORCE = 0.0254, 4.4482216152605


def trailing(points: dict[str, list[float]], **more: object):
    """An arm on an axis across the car, the wheel centre 0.3 m high."""
    table = {
        "wheel_centre": [0.0, 0.7, 0.3],
        "strut_bottom": [-0.2, 0.6, 0.3],
        "strut_top": [-0.2, 0.6, 0.7],
        **points,
    }
    return rig_from_table(
        {
            "schema": "jounce.rig/1",
            "model": "trailing-arm",
            "hardpoints": table,
            "wheel": {"radius": 0.3},
            **more,
        }
    )


def steered(track: float, offset: float, arm: float, inboard: float):
    """Upright steering axes ``track`` apart, contact points ``offset`` outboard of them, steering arms to the rear."""
    y = 0.5 * track
    points = {
        "lower_arm_front": [0.15, y - 0.3, 0.15],
        "lower_arm_rear": [-0.15, y - 0.3, 0.15],
        "lower_ball_joint": [0.0, y, 0.15],
        "upper_arm_front": [0.15, y - 0.3, 0.45],
        "upper_arm_rear": [-0.15, y - 0.3, 0.45],
        "upper_ball_joint": [0.0, y, 0.45],
        "tie_rod_inner": [-arm, y - 0.3, 0.3],
        "tie_rod_outer": [-arm, y - inboard, 0.3],
        "wheel_centre": [0.0, y + offset, 0.3],
        "strut_bottom": [0.0, y - 0.1, 0.15],
        "strut_top": [0.0, y - 0.1, 0.6],
    }
    return rig_from_table(
        {
            "schema": "jounce.rig/1",
            "model": "double-wishbone",
            "hardpoints": points,
            "wheel": {"radius": 0.3},
        }
    )


def test_outer_wheel_of_correct_steering() -> None:
    """Inside lock 0.75 rad, 0.13 m between the pivots, wheelbase 2.7 m: outside lock 0.728157 rad (all lengths x 5)."""
    car = jn.AxleLayout(axle="front", wheelbase=5 * 2.7, centre_of_mass_height=0.5, brake_share=0.6)
    rig = steered(5 * 0.13, 0.0, 0.12, 0.01)

    def inner(rack: float) -> float:
        return float(jn.sweep_steering(rig, [rack])["left.steer"][0]) - 0.75

    turned = jn.sweep_steering(rig, [brentq(inner, -0.085, -0.05, xtol=1e-13)], vehicle=car)
    assert float(turned["left.steer"][0]) == pytest.approx(0.75, abs=1e-9)
    assert float(turned["ideal_outer_steer"][0]) == pytest.approx(0.728157, abs=0.5e-6)


def test_turning_radius_of_the_outer_wheel() -> None:
    """Wheelbase 2.7 m, track 1.999 m, 0.13 m between the pivots, 4.99 m: the outer wheel turns by 0.728515 rad."""
    wheelbase, track, pivots, radius, angle = 2.7, 1.999, 0.13, 4.99, 0.728515
    scale = 10.0  # pivots 1.3 m apart
    car = jn.AxleLayout(
        axle="front", wheelbase=scale * wheelbase, centre_of_mass_height=0.5, brake_share=0.6
    )
    offset = 0.5 * scale * (track - pivots)

    def turned(inboard: float):
        rig = steered(scale * pivots, offset, 0.12, inboard)

        def outer(rack: float) -> float:
            return float(jn.sweep_steering(rig, [rack])["right.steer"][0]) - angle

        rack = brentq(outer, -0.085, -0.06, xtol=1e-13)
        return jn.sweep_steering(rig, [rack], vehicle=car)

    inboard = brentq(
        lambda one: float(turned(one)["ackermann"][0]) - 1.0, -0.005, 0.0, xtol=1e-12
    )  # one centre
    found = float(turned(inboard)["turn_diameter_kerbs"][0]) / 2.0 / scale
    assert found == pytest.approx(
        radius, abs=2e-5
    )  # half a unit of the angle's last digit is 2e-6 m


def test_anti_dive_of_a_swing_arm() -> None:
    """60 % of the brakes in front, wheelbase 2550 mm, centre of gravity 600 mm high: 25 % at 5.6 degrees."""
    height = 0.5 * np.tan(np.radians(5.6))
    rig = trailing({"arm_inner": [-0.5, 0.3, height], "arm_outer": [-0.5, 0.7, height]})
    car = jn.AxleLayout(axle="front", wheelbase=2.55, centre_of_mass_height=0.6, brake_share=0.6)
    found = jn.sweep_travel(rig, [0.0], vehicle=car)
    assert abs(np.degrees(float(found["side_view_swing_arm_angle"][0]))) == pytest.approx(
        5.6, abs=1e-9
    )
    assert float(found["anti_dive"][0]) == pytest.approx(
        0.25, abs=0.0023
    )  # half a unit of the angle's last digit


def test_wheel_rate_of_a_lever() -> None:
    """300 lbf/in at a motion ratio of 0.8: 192 lbf/in at the wheel."""
    unit = POUND_FORCE / INCH
    points = {"arm_inner": [-0.5, 0.3, 0.3], "arm_outer": [-0.5, 0.7, 0.3]}
    points |= {"strut_bottom": [-0.1, 0.6, 0.3], "strut_top": [-0.1, 0.6, 0.7]}
    rig = trailing(points, strut={"on": "arm", "spring": {"rate": 300.0 * unit}})
    found = jn.sweep_travel(rig, [0.0])
    assert float(found["motion_ratio"][0]) == pytest.approx(0.8, rel=1e-12)
    assert float(found["wheel_rate_spring"][0]) / unit == pytest.approx(192.0, rel=1e-12)
