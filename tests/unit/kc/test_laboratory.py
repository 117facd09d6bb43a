"""Tests on the K&C rig: poses of ideal joints, closed forms, loops, exact slopes, and refusals."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.axles.corners import BuiltAxle
from jounce.core.errors import DescriptionError, SimulationError
from jounce.core.findings import findings_of
from jounce.kc.laboratory import Laboratory, loop
from jounce.kc.tests import TESTS
from jounce.kernel import equilibrium as eq

RIGS = (
    "generic-mcpherson",
    "reference-double-wishbone",
    "sedan-multi-link",
    "semi-trailing-arm",
    "formula-student-front",
)
SOFT = {
    "stiffness": ["8 kN/mm", "6 kN/mm", "3 kN/mm"],
    "rotational_stiffness": ["10 N*m/deg"] * 3,
}
EVERYWHERE = (
    "lower_arm_front",
    "lower_arm_rear",
    "upper_arm_front",
    "upper_arm_rear",
    "lower_ball_joint",
    "upper_ball_joint",
    "tie_rod_inner",
    "tie_rod_outer",
    "strut_bottom",
    "strut_top",
)


def soft(name: str = "reference-double-wishbone", points=EVERYWHERE, **bushing) -> jn.Rig:
    return jn.load(name).with_changes({"bushings": dict.fromkeys(points, SOFT | bushing)})


@pytest.mark.parametrize("name", RIGS)
def test_ideal_joints_move_as_the_kinematics_say(name: str) -> None:
    rig = jn.load(name)
    test = jn.kc_test(rig, "bounce", to="40 mm")
    travel = test["left.wheel_centre_z"].values
    sweep = jn.sweep_travel(rig, np.unique(np.round(travel, 12)))
    for quantity in ("toe", "camber", "caster"):
        if quantity in sweep and f"left.{quantity}" in test:
            want = np.interp(travel, sweep["wheel_travel"], sweep[quantity])
            assert test[f"left.{quantity}"].values == pytest.approx(want, abs=1e-12)
            right = test[f"right.{quantity}"].values
            assert right == pytest.approx(want, abs=1e-12)


def test_the_loads_are_carried_and_work_is_stored() -> None:
    """Work of the pads and loads over a closed loop without friction is zero, and a force moves its point along."""
    rig = soft()
    test = jn.kc_test(rig, "lateral-opposed", points=81)
    force, patch = test["left.lateral_force"].values, test["left.contact_point_y"].values
    assert np.ptp(patch) > 1e-3
    assert np.trapezoid(force, patch) == pytest.approx(
        0.0, abs=1e-9 * np.ptp(force) * np.ptp(patch)
    )
    assert jn.kc_slopes(test)["slope"].sel(quantity="left.contact_point_y") > 0.0
    total = test["left.vertical_force"].values
    assert total == pytest.approx(np.full_like(total, total[0]), rel=1e-9)


def test_a_trailing_arm_yields_as_two_springs() -> None:
    """Soft bushings far stiffer in turning than in shear: lateral compliance at the axis is 1 / (2 k)."""
    points = ("arm_inner", "arm_outer")
    rig = soft("semi-trailing-arm", points, rotational_stiffness=["1e9 N*m/rad"] * 3)
    rig = rig.with_changes({"strut.spring.rate": 1.0})
    test = jn.kc_test(rig, "lateral-in-phase", to="10 N", held="height")
    moved = jn.kc_slopes(test).sel(quantity="left.wheel_centre_y")
    stiff = np.linalg.inv(2.0 * np.diag([8e6, 6e6, 3e6]))[1, 1]
    assert float(moved["slope"]) == pytest.approx(stiff, rel=0.02)


def test_left_and_right_mirror_each_other() -> None:
    rig = soft(x_axis=[1.0, 0.3, 0.1], preload=["10 N", "150 N", "5 N"])
    test = jn.kc_test(rig, "lateral-opposed")
    for quantity in ("toe", "camber", "spin", "wheel_centre_x", "vertical_force"):
        left, right = test[f"left.{quantity}"].values, test[f"right.{quantity}"].values
        assert left == pytest.approx(right, abs=1e-9 * np.abs(left).max())
    assert test["left.contact_point_y"].values == pytest.approx(
        -test["right.contact_point_y"].values
    )


def test_friction_opens_the_loop() -> None:
    rig = soft(friction=["60 N", "60 N", "60 N"])
    test = jn.kc_test(rig, "lateral-in-phase", to="1 kN")
    without = jn.kc_slopes(jn.kc_test(soft(), "lateral-in-phase", to="1 kN"))
    with_friction = jn.kc_slopes(test)
    toe = with_friction.sel(quantity="left.toe"), without.sel(quantity="left.toe")
    assert float(toe[0]["hysteresis"]) > 0.02
    assert float(toe[1]["hysteresis"]) < 1e-6


@pytest.mark.parametrize("name", TESTS)
def test_every_test_starts_and_returns_where_it_was(name: str) -> None:
    test = jn.kc_test(soft(), name)
    assert test["input"].values[0] == test["input"].values[-1] == 0.0
    assert test.sizes["sample"] == 41
    for quantity in ("left.toe", "right.camber", "left.vertical_force"):
        values = test[quantity].values
        assert np.isfinite(values).all()
        assert values[0] == pytest.approx(values[-1], abs=1e-9)
    assert test["left.toe"].attrs["units"] == "rad"


def test_inboard_brakes_leave_the_carrier_unturned() -> None:
    rig = soft()
    outboard, inboard = (jn.kc_test(rig, name) for name in ("braking", "braking-inboard"))
    spin = [np.abs(test["left.spin"].values).max() for test in (outboard, inboard)]
    assert spin[0] > 3.0 * spin[1]


def test_a_free_handwheel_lets_the_rack_move() -> None:
    rig = soft().with_changes({"steering": {"rack_travel": 0.0}})
    locked, free = (
        jn.kc_test(rig, "aligning-in-phase", handwheel=way) for way in ("locked", "free")
    )
    assert np.ptp(locked["rack_travel"].values) < 1e-9
    assert np.ptp(free["rack_travel"].values) > 1e-4
    assert np.ptp(free["rack_force"].values) < 1e-6


@pytest.mark.parametrize("name", ["lateral-in-phase", "aligning-in-phase", "lateral-opposed"])
def test_loops_of_friction_close_and_are_the_same_on_both_sides(name: str) -> None:
    """A symmetric axle answers with mirrored loops, though the test begins on one side.

    Each further loop brings both a hundred times nearer; from the first they differ in the sign of a slope.
    """
    test = jn.kc_test(jn.load("mcpherson-elastic"), name)
    sign = 1.0 if name.endswith("opposed") else -1.0
    slopes = jn.kc_slopes(test)["slope"]
    for quantity in ("toe", "camber", "caster", "spin"):
        values = test[f"left.{quantity}"].values
        assert values[0] == pytest.approx(values[-1], abs=5e-3 * np.ptp(values))
        left, right = (float(slopes.sel(quantity=f"{s}.{quantity}")) for s in ("left", "right"))
        assert left == pytest.approx(
            sign * right, rel=2.5e-2, abs=1e-3 * abs(float(slopes.sel(quantity="left.toe")))
        )


def test_slopes_by_hardpoints_and_stiffnesses_are_exact() -> None:
    names = ("lower_arm_front", "tie_rod_inner", "upper_ball_joint", "strut_bottom")
    rig = soft(points=names).with_changes({"links": {"tie_rod": {"stiffness": "50 kN/mm"}}})
    lists = ("lower_ball_joint", "tie_rod_outer", "strut_top", "wheel_centre", "lower_arm_front")
    parameters = [f"hardpoints.{name}[{i}]" for name in lists for i in range(3)]
    parameters += ["bushings.lower_arm_front.stiffness[1]", "links.tie_rod.stiffness", "wheel.toe"]
    laboratory, test = Laboratory(rig), TESTS["lateral-left"]
    path = laboratory.path(test, loop(1000.0, 9, one_sided=False), "height", "locked", 0.0)
    seeds = BuiltAxle(rig, parameters).assembly.seeds()

    def settle(which: jn.Rig, own: eq.Seeds, count: int) -> eq.Settled:
        arrays = BuiltAxle(which).assembly.arrays()[0]
        return eq.settle(arrays, path, own, laboratory.bodies, laboratory.multipliers, count)[0]

    slopes = settle(rig, seeds, len(parameters)).slopes[2, : 6 * laboratory.bodies]
    pose = settle(rig, seeds, len(parameters)).poses[2].reshape(-1, 12)
    none = eq.Seeds(np.zeros((0, 2), dtype=np.int64), np.zeros((0, eq.WIDTH)))
    for column, path_name in enumerate(parameters):
        value = rig.parameters()[path_name]
        step = 1e-4 * max(abs(value), 1e-2)
        ends = []
        for sign in (1.0, -1.0):
            changed = rig.with_changes(_one(rig, path_name, value + sign * step))
            ends.append(settle(changed, none, 0).poses[2].reshape(-1, 12)[:, :3])
        want = (ends[0] - ends[1]) / (2.0 * step)
        motion = slopes[:, column].reshape(-1, 6)
        exact = motion[:, :3] + np.cross(motion[:, 3:], pose[:, :3])
        assert exact == pytest.approx(want, abs=1e-4 * np.abs(want).max() + 1e-14), path_name


def _one(rig: jn.Rig, path: str, value: float) -> dict:
    if not path.endswith("]"):
        return {path: value}
    name, i = path[:-1].split("[")
    part = rig
    for key in name.split("."):
        part = getattr(part, key)
    return {name: [value if k == int(i) else old for k, old in enumerate(part)]}


def test_coarse_and_fine_loops_stay_on_one_branch() -> None:
    """Steered far, a rod may also be assembled the other way round: no step may jump there."""
    rig = jn.load("formula-student-front")
    coarse, fine = (
        jn.kc_test(rig, "steer", steer="15 mm", to="25 mm", points=points) for points in (9, 161)
    )
    assert coarse["left.steer"].values == pytest.approx(fine["left.steer"].values[::20], abs=1e-10)
    assert coarse["left.steer"].values[0] == pytest.approx(
        coarse["left.steer"].values[-1], abs=1e-10
    )


@pytest.mark.parametrize("name", ["double-wishbone-elastic", "mcpherson-elastic"])
def test_axles_with_all_compliance_and_friction_do_every_test(name: str) -> None:
    for test in jn.kc_tests(jn.load(name)).values():
        assert np.isfinite(test["left.toe"].values).all()
        assert not test.attrs["findings"]


def test_pads_roll_by_the_stated_angle() -> None:
    test = jn.kc_test(jn.load("reference-double-wishbone"), "roll", to="5 deg")
    heights = (test[f"{side}.contact_point_z"].values for side in ("left", "right"))
    angle = np.arctan((next(heights) - next(heights)) / test.attrs["track"])
    assert angle == pytest.approx(test["input"].values, abs=1e-12)


def test_an_arm_may_be_held_by_two_bodies() -> None:
    """A very stiff subframe under one end of an arm leaves the kinematics of one under both."""
    stiff = {"stiffness": ["1e9 N/m"] * 3, "rotational_stiffness": ["1e9 N*m/rad"] * 3}
    rig = jn.load("reference-double-wishbone")
    frame = {"carries": ["lower_arm_front"], "mounts": [{"point": [0.1, 0.3, 0.15], **stiff}]}
    held = jn.kc_test(rig.with_changes({"subframe": frame}), "lateral-opposed", to="1 N")
    fixed = jn.kc_test(rig, "lateral-opposed", to="1 N")
    assert held["left.toe"].values == pytest.approx(fixed["left.toe"].values, abs=1e-7)
    assert not held.attrs["findings"]
    soft_mount = {**stiff, "stiffness": ["1e6 N/m"] * 3}
    soft_frame = {**frame, "mounts": [{"point": [0.1, 0.3, 0.15], **soft_mount}]}
    yields = jn.kc_test(rig.with_changes({"subframe": soft_frame}), "lateral-opposed", to="1 kN")
    assert np.ptp(yields["left.toe"].values) > 1e-4


def test_pads_that_would_have_to_pull_are_named() -> None:
    light = jn.load("reference-double-wishbone").with_changes({"strut.spring.preload": 500.0})
    test = jn.kc_test(light, "bounce")
    assert test["left.vertical_force"].min() < 0.0
    (left, right) = (item for item in test.attrs["findings"] if "would have to pull" in item)
    assert "left wheel" in left
    assert "right wheel" in right
    assert not jn.kc_test(jn.load("reference-double-wishbone"), "bounce").attrs["findings"]


@pytest.mark.parametrize(("key", "unit"), [("x", "m"), ("rx", "rad")])
def test_curves_beyond_their_tables_are_named(key: str, unit: str) -> None:
    at, load = ("deflection", "force") if key == "x" else ("angle", "torque")
    table = {"kind": "table", at: [-1e-5, 0.0, 1e-5], load: [-80.0, 0.0, 80.0]}
    rig = soft(points=("lower_arm_front", "lower_arm_rear"), curves={key: table})
    test = jn.kc_test(rig, "braking")
    said = [item for item in test.attrs["findings"] if "was continued straight" in item]
    assert any("lower_arm_front" in item and f"1e-05 {unit}" in item for item in said)


def test_a_loose_motion_is_named() -> None:
    rig = soft(points=("lower_arm_front", "lower_arm_rear"), stiffness=["0 N/m", "0 N/m", "0 N/m"])
    with pytest.raises(SimulationError, match=r"not held: (left|right)\."):
        jn.kc_test(rig, "bounce")


def test_a_load_beyond_the_mechanism_says_until_where_it_came() -> None:
    test = jn.kc_test(jn.load("reference-double-wishbone"), "bounce", to="400 mm")
    assert "no equilibrium beyond" in test.attrs["findings"][0]
    assert np.isnan(test["left.toe"].values).any()
    assert np.isfinite(test["left.toe"].values[:4]).all()


@pytest.mark.parametrize(
    ("name", "test", "options", "message"),
    [
        ("reference-double-wishbone", "lateral", {}, "unknown test"),
        ("semi-trailing-arm", "steer", {}, "no rack"),
        ("reference-double-wishbone", "bounce", {"points": 3}, "not a number of samples"),
        ("reference-double-wishbone", "bounce", {"points": 10**12}, "not a number of samples"),
        ("reference-double-wishbone", "bounce", {"points": 42}, "not a number of samples"),
        ("reference-double-wishbone", "bounce", {"to": "0 mm"}, "without a range"),
        ("reference-double-wishbone", "bounce", {"held": "both"}, "unknown setting"),
        ("reference-double-wishbone", "bounce", {"handwheel": "loose"}, "unknown setting"),
        ("semi-trailing-arm", "braking", {"handwheel": "free"}, "no handwheel"),
        ("reference-double-wishbone", "bounce", {"on": "middle"}, "unknown axle"),
        ("sedan-full-car-3d", "bounce", {}, "which axle"),
        ("kart-quarter-car", "bounce", {}, "lumped"),
        ("reference-double-wishbone", "bounce", {"to": "3 kN"}, "to"),
    ],
)
def test_what_cannot_be_tested_is_refused(
    name: str, test: str, options: dict, message: str
) -> None:
    with pytest.raises(DescriptionError, match=message):
        jn.kc_test(jn.load(name), test, **options)


def test_a_handwheel_that_steers_the_other_way_is_named() -> None:
    """The tie rods of the shipped rig are behind its axle, so that its rack moves to the right in a left turn."""
    rig = jn.load("mcpherson-elastic")
    right = jn.kc_test(rig, "steer", to="20 mm", points=9)
    assert not [item for item in findings_of(right.attrs) if item.code == "kc.steers_opposite"]
    ratio = jn.kc_overview({"steer": right}).row("steer", "steering_ratio").axle
    assert ratio is not None
    assert ratio > 0.0
    turned = rig.with_changes({"steering.rack_ratio": "8.5 mm/rad"})
    wrong = jn.kc_test(turned, "steer", to="20 mm", points=9)
    assert [item.code for item in findings_of(wrong.attrs)][-1:] == ["kc.steers_opposite"]
