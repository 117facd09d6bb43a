"""Solid axles and twist beams on the K&C rig: closed forms of their guides, and axles that bind or are not guided."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import root

import jounce as jn
from jounce.axles.dependent import build_axle, freedom
from jounce.core.errors import DescriptionError
from jounce.parts import SolidAxle, rig_findings

LINK = np.array([0.5, 0.0, 0.0])
PANHARD = np.array([0.0, -1.1, 0.04])
POINTS = {
    "wheel_centre": [0.0, 0.75, 0.3],
    "strut_bottom": [0.0, 0.5, 0.3],
    "strut_top": [0.0, 0.5, 0.7],
    "lower_link_axle": [0.0, 0.5, 0.2],
    "lower_link_body": [0.5, 0.5, 0.2],
    "upper_link_axle": [0.0, 0.0, 0.4],
    "upper_link_body": [0.5, 0.0, 0.4],
}
SIDEWAYS = {
    "panhard": {"panhard_axle": [-0.1, 0.55, 0.28], "panhard_body": [-0.1, -0.55, 0.32]},
    "watt": {
        "watt_pivot": [-0.1, 0.0, 0.3],
        "watt_upper_axle": [-0.1, 0.0, 0.36],
        "watt_upper_body": [-0.1, 0.5, 0.36],
        "watt_lower_axle": [-0.1, 0.0, 0.24],
        "watt_lower_body": [-0.1, -0.5, 0.24],
    },
    "none": {},
}


def axle(guide: str, **changes: object) -> SolidAxle:
    return SolidAxle.from_table(
        {
            "schema": "jounce.rig/1",
            "model": "solid-axle",
            "hardpoints": POINTS | SIDEWAYS[guide],
            "wheel": {"radius": 0.3},
            "strut": {"spring": {"rate": 3e4, "preload": 3e3}, "damper": {"coefficient": 1e3}},
            **changes,
        }
    )


def test_a_panhard_rod_moves_the_axle_on_its_circle() -> None:
    """Three equal parallel links only shift the axle: each keeps its length, and so does the rod."""
    test = jn.kc_test(axle("panhard"), "bounce", to="60 mm")
    for k in range(0, 41, 5):
        z = test["left.wheel_centre_z"].values[k]

        def lengths(d: np.ndarray, z: float = z) -> list[float]:
            shift = np.array([d[0], d[1], z])
            return [
                np.linalg.norm(vector - shift) - np.linalg.norm(vector)
                for vector in (LINK, PANHARD)
            ]

        x, y = root(lengths, [0.0, 0.0], tol=1e-14).x
        assert test["left.wheel_centre_x"].values[k] == pytest.approx(x, abs=1e-10)
        assert test["right.wheel_centre_y"].values[k] == pytest.approx(y, abs=1e-10)
    assert test["left.spin"].values == pytest.approx(0.0, abs=1e-10)


def test_a_watt_linkage_guides_the_axle_on_a_straight_line() -> None:
    test = jn.kc_test(axle("watt"), "bounce", to="60 mm")
    assert np.abs(test["left.wheel_centre_y"].values).max() < 1e-3 * 0.06
    rod = jn.kc_test(axle("panhard"), "bounce", to="60 mm")
    assert np.ptp(rod["left.wheel_centre_y"].values) > 30.0 * np.ptp(
        test["left.wheel_centre_y"].values
    )


@pytest.mark.parametrize("guide", ["panhard", "watt"])
def test_a_solid_axle_rolls_as_one(guide: str) -> None:
    test = jn.kc_test(axle(guide), "roll")
    left, right = test["left.camber"].values, test["right.camber"].values
    assert left == pytest.approx(-right, abs=1e-9)
    assert test["left.steer"].values == pytest.approx(test["right.steer"].values, abs=1e-9)
    total = test["left.vertical_force"].values + test["right.vertical_force"].values
    assert total == pytest.approx(np.full_like(total, total[0]), rel=1e-10)


def test_lateral_forces_on_a_solid_axle_go_to_its_guide() -> None:
    test = jn.kc_test(axle("panhard"), "lateral-in-phase", to="1 kN", held="height")
    rod = test["left.panhard.force"].values
    along = 1.1 / np.hypot(1.1, 0.04)
    assert np.abs(rod - rod[0]).max() == pytest.approx(2000.0 / along, rel=1e-3)


def test_a_twist_beam_rolls_about_pivots_and_shear_centre() -> None:
    """With ideal pivots each half turns about the line from its pivot to the shear centre."""
    rig = jn.load("twist-beam").with_changes(
        {"bushings": {}, "wheel.toe": 0.0, "wheel.camber": 0.0}
    )
    test = jn.kc_test(rig, "roll", to="0.01 deg")
    points = rig.hardpoints
    pivot, centre = np.array(points.pivot), np.array(points.shear_centre)
    wheel = np.array(points.wheel_centre)
    axis = (centre - pivot) / np.linalg.norm(centre - pivot)
    rise = np.cross(axis, wheel - pivot)[2]
    slope = jn.kc_slopes(test)["slope"]
    lift = float(slope.sel(quantity="left.wheel_centre_z"))
    assert float(slope.sel(quantity="left.steer")) / lift == pytest.approx(axis[2] / rise, rel=1e-6)
    camber = float(slope.sel(quantity="left.camber")) / lift
    assert camber == pytest.approx(-axis[0] / rise, rel=1e-6)


def test_the_beam_carries_the_roll_moment_of_its_twist() -> None:
    rig = jn.load("twist-beam").with_changes({"bushings": {}, "strut.spring.rate": 1.0})
    test = jn.kc_test(rig, "roll")
    twist, torque = test["beam.twist"].values, test["beam.torque"].values
    assert np.ptp(twist) > 0.05
    assert torque == pytest.approx(rig.beam.torsional_stiffness * twist)


@pytest.mark.parametrize("name", ["solid-axle", "twist-beam"])
def test_shipped_axles_do_every_test_but_steering(name: str) -> None:
    tests = jn.kc_tests(jn.load(name))
    assert len(tests) == 13
    for test in tests.values():
        assert np.isfinite(test["left.toe"].values).all()
    assert freedom(build_axle(jn.load(name)), elastic=True)[2] == 0


def test_links_that_bind_are_refused() -> None:
    with pytest.raises(DescriptionError, match=r"the links bind.*1 free motion"):
        jn.kc_test(jn.load("solid-axle").with_changes({"bushings": {}}), "bounce")


def test_an_axle_without_a_guide_is_refused() -> None:
    with pytest.raises(DescriptionError, match=r"do not guide the axle.*Panhard"):
        jn.kc_test(axle("none"), "bounce")


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"hardpoints": POINTS | SIDEWAYS["panhard"] | SIDEWAYS["watt"]}, "twice"),
        ({"hardpoints": POINTS | {"panhard_axle": [0.0, 0.5, 0.3]}}, "panhard_body is missing"),
        ({"hardpoints": POINTS | {"wheel_centre": [0.0, -0.7, 0.3]}}, "right side"),
        ({"hardpoints": POINTS | {"strut_top": [0.0, 0.5, 0.3]}}, "coincides"),
        ({"hardpoints": POINTS | {"strut_top": [0.0, 500.0, 700.0]}}, "far from the other points"),
        ({"bushings": {"panhard_axle": {"stiffness": [1e6, 1e6, 1e6]}}}, "panhard_axle is missing"),
        ({"links": {"panhard": {"stiffness": 1e6}}}, "panhard_axle is missing"),
    ],
)
def test_impossible_axles_are_refused(changes: dict, message: str) -> None:
    with pytest.raises(DescriptionError, match=message):
        axle("none", **changes)


def test_an_axle_in_metres_read_as_millimetres_is_reported() -> None:
    small = {name: [1e-3 * value for value in point] for name, point in POINTS.items()}
    (found,) = (
        item for item in rig_findings(axle("none", hardpoints=small)) if "hardpoints" in item.place
    )
    assert found.code == "parts.size_millimetres"


def test_what_an_axle_cannot_do_yet_is_said() -> None:
    rig = jn.load("twist-beam")
    with pytest.raises(DescriptionError, match="only a corner with hardpoints"):
        jn.adjust_report(rig)
    trial = jn.Trial(road=jn.Step(height="10 mm"), speed="2 m/s", duration="0.1 s")
    with pytest.raises(DescriptionError, match="does not run on roads"):
        jn.simulate(rig, trial)
