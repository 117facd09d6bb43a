"""Kinematics: derivatives against differences, virtual work, equilibrium, mirror symmetry, closed forms."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn

RIGS = (
    "reference-double-wishbone",
    "polaris-front",
    "hmmwv-front",
    "generic-mcpherson",
    "sedan-multi-link",
    "formula-student-front",
    "semi-trailing-arm",
)
STEP = 1e-4  # m
LOAD = {
    "longitudinal_force": -800.0,
    "lateral_force": 1500.0,
    "vertical_force": 3500.0,
    "aligning_torque": -40.0,
}


def differences(values: np.ndarray, step: float = STEP) -> float:
    """Derivative at the middle of five values, of fourth order."""
    a, b, _, d, e = values
    return float((a - 8.0 * b + 8.0 * d - e) / (12.0 * step))


@pytest.fixture(scope="module", params=RIGS)
def near(request: pytest.FixtureRequest):
    """Five poses close together, away from design."""
    rig = jn.load(request.param)
    return rig, jn.sweep_travel(rig, 0.013 + STEP * np.arange(-2, 3), points=True)


@pytest.mark.parametrize(
    ("slope", "value", "sign"),
    [
        ("camber_gain", "camber", 1.0),
        ("bump_steer", "steer", 1.0),
        ("caster_gain", "caster", 1.0),
        ("half_track_gradient", "half_track_change", 1.0),
        ("motion_ratio", "spring_length", -1.0),
        ("damper_motion_ratio", "damper_length", -1.0),
        ("motion_ratio_gradient", "motion_ratio", 1.0),
        ("wheel_centre_longitudinal_slope", "wheel_centre_x", 1.0),
        ("wheel_rate", "wheel_force", 1.0),
    ],
)
def test_slopes_are_derivatives_along_travel(near, slope: str, value: str, sign: float) -> None:
    rig, found = near
    if rig.model == "trailing-arm" and slope == "caster_gain":
        assert slope not in found  # no steering axis, so no row
        return
    scale = max(abs(float(found[slope][2])), 1e-3)
    assert sign * differences(found[value].to_numpy()) == pytest.approx(
        float(found[slope][2]), abs=1e-7 * scale
    )


def test_rates_count_a_stop_that_is_closed() -> None:
    """The energy of spring and stop, by their laws, has the wheel force as its slope, and this the wheel rate."""
    stop = {"gap": 0.004, "rate": 60e3, "progression": 4e8}
    rig = jn.load("reference-double-wishbone").with_changes({"strut.bump_stop": stop})
    found = jn.sweep_travel(rig, 0.03 + STEP * np.arange(-2, 3))
    short = rig.hardpoints.length("spring") - found["spring_length"].to_numpy()
    depth = short - stop["gap"]
    assert depth.min() > 0.01
    spring = rig.strut.spring
    energy = 0.5 * spring.rate * short**2 + spring.preload * short
    energy += 0.5 * stop["rate"] * depth**2 + 0.25 * stop["progression"] * depth**4
    assert differences(energy) == pytest.approx(float(found["wheel_force"][2]), rel=1e-7)
    assert differences(found["wheel_force"].to_numpy()) == pytest.approx(
        float(found["wheel_rate"][2]), rel=1e-7
    )
    lift = (
        found["motion_ratio"] / found["motion_ratio_contact"]
    ).to_numpy()  # of the patch for one of the centre
    contact = differences(found["wheel_force"].to_numpy() / lift) / lift[2]
    assert contact == pytest.approx(float(found["wheel_rate_contact"][2]), rel=1e-7)


def test_contact_patch_moves_with_the_upright(near) -> None:
    """The patch is a point of the upright: its path from three of its own points, not from the lowest of the wheel."""
    rig, found = near
    names = {
        "double-wishbone": ("lower_ball_joint", "upper_ball_joint", "tie_rod_outer"),
        "mcpherson": ("lower_ball_joint", "strut_bottom", "tie_rod_outer"),
        "five-link": ("link_1_outer", "link_3_outer", "link_5_outer"),
        "trailing-arm": ("wheel_centre", "strut_bottom", "arm_inner"),
    }[rig.model]
    frames = np.stack(
        [[found[f"{name}.{axis}"].to_numpy() for axis in "xyz"] for name in names]
    )  # point, axis, pose
    patch = np.array([float(found[f"contact_point_{axis}"][2]) for axis in "xyz"])
    base = frames[:, :, 2]
    frame = np.column_stack(
        [base[1] - base[0], base[2] - base[0], np.cross(base[1] - base[0], base[2] - base[0])]
    )
    share = np.linalg.solve(frame, patch - base[0])
    path = []
    for k in range(5):
        p = frames[:, :, k]
        moved = np.column_stack([p[1] - p[0], p[2] - p[0], np.cross(p[1] - p[0], p[2] - p[0])])
        path.append(p[0] + moved @ share)
    rate = np.array([differences(column) for column in np.array(path).T])
    side = 1.0 if rig.side == "left" else -1.0
    assert float(found["jacking"][2]) == pytest.approx(side * rate[1] / rate[2], abs=2e-7)
    assert float(found["contact_patch_recession"][2]) == pytest.approx(rate[0] / rate[2], abs=2e-7)
    height = patch[1] * rate[1] / rate[2]
    assert float(found["roll_centre_height"][2]) == pytest.approx(height, abs=5e-7)


@pytest.mark.parametrize("name", [name for name in RIGS if name != "semi-trailing-arm"])
def test_steering_ratio_is_the_derivative_along_the_rack(name: str) -> None:
    found = jn.sweep_rack(jn.load(name), 0.004 + STEP * np.arange(-2, 3), travel=-0.01)
    assert differences(found["steer"].to_numpy()) == pytest.approx(
        float(found["steer_gain"][2]), rel=1e-7
    )


@pytest.mark.parametrize("name", RIGS)
def test_joint_loads_balance_and_agree_with_virtual_work(name: str) -> None:
    rig, travel = jn.load(name), [-0.02, 0.0, 0.015]
    found = jn.pickup_loads(rig, jn.ContactLoad(**LOAD), travel)
    swept = jn.sweep_travel(rig, travel, points=True)
    chassis = {
        "double-wishbone": (
            "lower_arm_front",
            "lower_arm_rear",
            "upper_arm_front",
            "upper_arm_rear",
            "tie_rod_inner",
        ),
        "mcpherson": ("lower_arm_front", "lower_arm_rear", "tie_rod_inner", "strut_top"),
        "five-link": tuple(f"link_{i}_inner" for i in range(1, 6)),
        "trailing-arm": ("arm_inner", "arm_outer"),
    }[rig.model]
    spring = "spring_top" if "spring_top.fx" in found else "strut_top"
    held = list(
        dict.fromkeys((*chassis, spring, *(["rocker_pivot"] if "rocker_pivot.fx" in found else [])))
    )
    total = [sum(found[f"{point}.f{axis}"].to_numpy() for point in held) for axis in "xyz"]
    wanted = [LOAD["longitudinal_force"], LOAD["lateral_force"], LOAD["vertical_force"]]
    for force, given in zip(total, wanted, strict=True):
        assert force == pytest.approx(given, abs=1e-6)
    side = 1.0 if rig.side == "left" else -1.0
    down = 1.0 / (
        swept["motion_ratio"] / swept["motion_ratio_contact"]
    )  # wheel centre's rise for the patch's
    pushed = (
        LOAD["vertical_force"]
        + LOAD["lateral_force"] * side * swept["jacking"]
        + LOAD["longitudinal_force"] * swept["contact_patch_recession"]
    )
    vertical = jn.pickup_loads(rig, jn.ContactLoad(**{**LOAD, "aligning_torque": 0.0}), travel)
    work = vertical["spring.force"] * swept["motion_ratio_contact"]
    assert work.to_numpy() == pytest.approx(pushed.to_numpy(), rel=1e-9)
    assert np.all(down > 0.9)


def test_moments_of_the_joint_loads_balance() -> None:
    """About the origin: what the body feels is what the road does."""
    rig = jn.load("reference-double-wishbone")
    found, swept = (
        jn.pickup_loads(rig, jn.ContactLoad(**LOAD), 0.02),
        jn.sweep_travel(rig, 0.02, points=True),
    )
    force = np.array([LOAD["longitudinal_force"], LOAD["lateral_force"], LOAD["vertical_force"]])
    place = np.array([float(swept[f"contact_point.{axis}"][0]) for axis in "xyz"])
    moment = np.cross(place, force) + np.array([0.0, 0.0, LOAD["aligning_torque"]])
    total = np.zeros(3)
    for name in (
        "lower_arm_front",
        "lower_arm_rear",
        "upper_arm_front",
        "upper_arm_rear",
        "tie_rod_inner",
        "strut_top",
    ):
        at = np.array([float(swept[f"{name}.{axis}"][0]) for axis in "xyz"])
        total += np.cross(at, [float(found[f"{name}.f{axis}"][0]) for axis in "xyz"])
    assert total == pytest.approx(moment, abs=1e-6)


@pytest.mark.parametrize("name", RIGS)
def test_right_hand_corner_is_the_mirror_image(name: str) -> None:
    rig, travel = jn.load(name), [-0.02, 0.0, 0.02]
    rack = 0.0 if name == "semi-trailing-arm" else 0.005
    one, other = jn.sweep_travel(rig, travel, rack), jn.sweep_travel(rig.mirrored(), travel, -rack)
    odd = {
        "inclination",
        "steer",
        "bump_steer",
        "wheel_centre_y",
        "contact_point_y",
        "instant_centre_y",
    }
    for key in one.data_vars:
        sign = -1.0 if key in odd else 1.0
        assert sign * other[key].to_numpy() == pytest.approx(
            one[key].to_numpy(), rel=1e-9, abs=1e-11
        ), key


def test_trailing_arm_turns_about_its_axis() -> None:
    """A pure trailing arm: no camber, no steer; the side view's instant centre is the axis, the path a circle."""
    rig = jn.load("semi-trailing-arm")
    inner, outer = rig.hardpoints.arm_inner, rig.hardpoints.arm_outer
    rig = rig.with_changes(
        {
            "hardpoints.arm_inner": [outer[0], inner[1], outer[2]],
            "wheel.camber": 0.0,
            "wheel.toe": 0.0,
        }
    )
    travel = np.array([-0.05, 0.0, 0.05])
    found = jn.sweep_travel(rig, travel)
    centre = np.array(rig.hardpoints.wheel_centre)
    arm = np.hypot(centre[0] - outer[0], centre[2] - outer[2])
    assert found["camber"].to_numpy() == pytest.approx(0.0, abs=1e-13)
    assert found["steer"].to_numpy() == pytest.approx(0.0, abs=1e-13)
    assert found["side_instant_centre_x"].to_numpy() == pytest.approx(outer[0], abs=1e-12)
    assert found["side_instant_centre_z"].to_numpy() == pytest.approx(outer[2], abs=1e-12)
    x = outer[0] - np.sqrt(arm**2 - (centre[2] + travel - outer[2]) ** 2)
    assert found["wheel_centre_x"].to_numpy() == pytest.approx(x, abs=1e-12)


def test_anti_effects_are_the_slopes_times_the_vehicle() -> None:
    rig = jn.load("reference-double-wishbone")
    front = jn.AxleLayout(axle="front", wheelbase=2.7, centre_of_mass_height=0.55, brake_share=0.6)
    rear = jn.AxleLayout(axle="rear", wheelbase=2.7, centre_of_mass_height=0.55, brake_share=0.4)
    found, lever = jn.sweep_travel(rig, 0.0, vehicle=front), 2.7 / 0.55
    assert float(found["anti_dive"][0]) == pytest.approx(
        0.6 * lever * -0.005843, abs=2e-6
    )  # slopes: E5's table
    found = jn.sweep_travel(rig, 0.0, vehicle=rear)
    assert float(found["anti_lift"][0]) == pytest.approx(0.4 * lever * 0.005843, abs=2e-6)
    rise = float(
        (found["motion_ratio"] / found["motion_ratio_contact"])[0]
    )  # of the patch per rise of the centre
    assert float(found["anti_squat"][0]) == pytest.approx(lever * 0.05928 / rise, abs=3e-5)
    assert "anti_dive" not in found


@pytest.fixture(scope="module")
def rolled():
    return jn.load("reference-double-wishbone"), jn.sweep_roll(
        jn.load("reference-double-wishbone"), np.radians([-3.0, -1.0, 0.0, 1.0, 3.0])
    )


def test_rolled_wheels_stand_on_one_plane(rolled) -> None:
    """Both contact circles touch the road that the roll makes, and the travels are opposite."""
    rig, found = rolled
    assert (found["left.wheel_travel"] + found["right.wheel_travel"]).to_numpy() == pytest.approx(
        0.0, abs=1e-14
    )
    for k, roll in enumerate(found["roll_angle"].to_numpy()):
        normal, height = np.array([0.0, np.sin(roll), np.cos(roll)]), {}
        for side, sign in (("left", 1.0), ("right", -1.0)):
            camber, steer = (float(found[f"{side}.{name}"][k]) for name in ("camber", "steer"))
            outboard = sign * np.array([-np.sin(steer), np.cos(steer), 0.0]) * np.cos(camber)
            axis = outboard - [0.0, 0.0, np.sin(camber)]
            circle = np.linspace(0.0, 2.0 * np.pi, 20001)
            one = np.cross(axis, [1.0, 0.0, 0.0])
            one /= np.linalg.norm(one)
            rim = np.outer(np.cos(circle), one) + np.outer(np.sin(circle), np.cross(axis, one))
            centre = [float(found[f"{side}.wheel_centre_{name}"][k]) for name in "xyz"]
            height[side] = float(np.min((np.array(centre) + rig.wheel.radius * rim) @ normal))
            assert float(found[f"{side}.camber_to_ground"][k]) == pytest.approx(
                -np.arcsin(axis @ normal), abs=1e-12
            )
        assert height["left"] == pytest.approx(height["right"], abs=5e-8)  # the rim is sampled


def test_roll_is_antisymmetric_and_matches_the_corner_at_rest(rolled) -> None:
    rig, found = rolled
    for name in ("camber", "toe", "wheel_force", "caster_trail"):
        left, right = (found[f"{side}.{name}"].to_numpy() for side in ("left", "right"))
        assert left == pytest.approx(right[::-1], abs=1e-9)
    assert found["roll_moment"].to_numpy() == pytest.approx(
        -found["roll_moment"].to_numpy()[::-1], abs=1e-7
    )
    corner = jn.sweep_travel(rig, 0.0)
    assert float(found["roll_centre_height"][2]) == pytest.approx(
        float(corner["roll_centre_height"][0]), abs=1e-12
    )
    assert float(found["roll_centre_y"][2]) == pytest.approx(0.0, abs=1e-12)
    assert float(found["track"][2]) == pytest.approx(
        2.0 * float(corner["contact_point_y"][0]), abs=1e-12
    )


@pytest.mark.parametrize("name", ["reference-double-wishbone", "hmmwv-front"])
def test_roll_stiffness_is_the_slope_of_the_moment(name: str) -> None:
    step = 1e-4
    found = jn.sweep_roll(jn.load(name), 0.02 + step * np.arange(-2, 3))
    assert differences(found["roll_moment"].to_numpy(), step) == pytest.approx(
        float(found["roll_stiffness"][2]), rel=1e-6
    )
    rate = differences(found["right.wheel_travel"].to_numpy(), step)
    camber = differences(found["right.camber"].to_numpy(), step)
    assert float(found["right.roll_camber"][2]) == pytest.approx(camber, rel=1e-6)
    for side in ("left", "right"):
        steer = differences(found[f"{side}.steer"].to_numpy(), step)
        assert float(found[f"{side}.roll_steer"][2]) == pytest.approx(steer, rel=1e-6)
    assert rate > 0.0


def test_roll_moment_is_the_slope_of_the_spring_energy() -> None:
    """Virtual work: the springs' energy over roll, integrated from their law, has the moment as its slope."""
    rig, step = jn.load("reference-double-wishbone"), 1e-4
    found = jn.sweep_roll(rig, 0.03 + step * np.arange(-2, 3))
    design, rate, preload = (
        rig.hardpoints.length("spring"),
        rig.strut.spring.rate,
        rig.strut.spring.preload,
    )
    energy = np.zeros(5)
    for side in ("left", "right"):
        short = design - found[f"{side}.spring_length"].to_numpy()
        energy += 0.5 * rate * short**2 + preload * short
    assert differences(energy, step) == pytest.approx(float(found["roll_moment"][2]), rel=1e-7)


def test_both_wheels_steer_alike() -> None:
    rig = jn.load("reference-double-wishbone")
    car = jn.AxleLayout(axle="front", wheelbase=2.7, centre_of_mass_height=0.55, brake_share=0.6)
    found = jn.sweep_steering(rig, [-0.02, -0.01, 0.0, 0.01, 0.02], vehicle=car)
    assert found["left.steer"].to_numpy() == pytest.approx(
        -found["right.steer"].to_numpy()[::-1], abs=1e-12
    )
    assert found["ackermann"].to_numpy()[[0, 1]] == pytest.approx(
        found["ackermann"].to_numpy()[[4, 3]], rel=1e-9
    )
    assert np.isnan(found["ackermann"].to_numpy()[2])
    # the wheels' normals meet the line of the rear axle, 2.7 m behind the static wheel centre
    rear = rig.hardpoints.wheel_centre[0] - 2.7
    for i in (0, 1, 3, 4):
        centres = {
            side: float(found[f"{side}.contact_point_y"][i])
            + (float(found[f"{side}.contact_point_x"][i]) - rear)
            / np.tan(float(found[f"{side}.steer"][i]))
            for side in ("left", "right")
        }
        inner, outer = (
            ("left", "right") if float(found["mean_steer"][i]) > 0.0 else ("right", "left")
        )
        x, y = (float(found[f"{outer}.contact_point_{axis}"][i]) for axis in "xy")
        ideal = abs(np.arctan((x - rear) / (centres[inner] - y)))
        left, right = (float(found[f"{side}.steer"][i]) for side in ("left", "right"))
        assert float(found["mean_steer"][i]) == pytest.approx(0.5 * (left + right), rel=1e-12)
        assert float(found["steer_difference"][i]) == pytest.approx(left - right, rel=1e-12)
        steer = {"left": abs(left), "right": abs(right)}
        assert ideal < steer[inner]
        assert float(found["ideal_outer_steer"][i]) == pytest.approx(ideal, rel=1e-12)
        share = (steer[inner] - steer[outer]) / (steer[inner] - ideal)
        assert float(found["ackermann"][i]) == pytest.approx(share, rel=1e-9)
        assert float(found["ackermann_error"][i]) == pytest.approx(steer[outer] - ideal, abs=1e-12)
        radius = 0.5 * (centres["left"] + centres["right"])
        assert float(found["turning_radius"][i]) == pytest.approx(radius, rel=1e-12)
        kerb = 2.0 * np.hypot(radius - y, x - rear)
        assert float(found["turn_diameter_kerbs"][i]) == pytest.approx(kerb, rel=1e-12)


def test_a_linkage_of_perfect_ackermann_has_one() -> None:
    """The wheelbase that makes the normals meet is found from the normals themselves."""
    rig = jn.load("reference-double-wishbone")
    plain = jn.sweep_steering(rig, [-0.03])
    x, y, steer = (
        {side: float(plain[f"{side}.{name}"][0]) for side in ("left", "right")}
        for name in ("contact_point_x", "contact_point_y", "steer")
    )
    # x_l - s_l sin = x_r - s_r sin, y_l + s_l cos = y_r + s_r cos
    matrix = [
        [-np.sin(steer["left"]), np.sin(steer["right"])],
        [np.cos(steer["left"]), -np.cos(steer["right"])],
    ]
    along = np.linalg.solve(matrix, [x["right"] - x["left"], y["right"] - y["left"]])
    meets = x["left"] - along[0] * np.sin(steer["left"])
    wheelbase = rig.hardpoints.wheel_centre[0] - meets
    assert wheelbase > 0.5
    car = jn.AxleLayout(
        axle="front",
        wheelbase=wheelbase,
        centre_of_mass_height=0.55,
        brake_share=0.6,
        front_overhang="0.8 m",
        body_width="1.7 m",
    )
    found = jn.sweep_steering(rig, [-0.03], vehicle=car)
    assert float(found["ackermann"][0]) == pytest.approx(1.0, abs=1e-9)
    assert float(found["ackermann_error"][0]) == pytest.approx(0.0, abs=1e-10)
    centre = y["left"] + along[0] * np.cos(steer["left"])
    assert float(found["turning_radius"][0]) == pytest.approx(centre, rel=1e-9)
    walls = 2.0 * np.hypot(abs(centre) + 0.85, wheelbase + 0.8)
    assert float(found["turn_diameter_walls"][0]) == pytest.approx(walls, rel=1e-9)


def test_rack_of_an_axle_turns_the_right_wheel_as_its_own_description_says() -> None:
    rig = jn.load("polaris-front")
    axle = jn.sweep_steering(rig, [-0.01, 0.0, 0.01])
    right = jn.sweep_rack(rig.mirrored(), [-0.01, 0.0, 0.01])
    for name in ("steer", "camber", "caster", "contact_point_y", "steer_gain", "inclination"):
        assert axle[f"right.{name}"].to_numpy() == pytest.approx(right[name].to_numpy(), abs=1e-12)


BAR = {
    "hardpoints.arb_pivot": [0.25, 0.45, 0.2],
    "hardpoints.arb_arm_end": [0.06, 0.5, 0.19],
    "hardpoints.arb_link_end": [0.05, 0.6, 0.14],
    "anti_roll_bar": {"stiffness": 900.0, "on": "lower_arm"},
}


@pytest.fixture(scope="module")
def with_bar():
    return jn.load("reference-double-wishbone").with_changes(BAR)


def test_link_of_the_anti_roll_bar_keeps_its_length(with_bar) -> None:
    found = jn.sweep_travel(with_bar, np.linspace(-0.06, 0.06, 7), points=True)
    link = np.stack(
        [found[f"arb_link_end.{axis}"] - found[f"arb_arm_end.{axis}"] for axis in "xyz"]
    )
    design = np.array(BAR["hardpoints.arb_link_end"]) - np.array(BAR["hardpoints.arb_arm_end"])
    assert np.linalg.norm(link, axis=0) == pytest.approx(np.linalg.norm(design), abs=1e-13)
    assert float(found["anti_roll_bar_angle"][3]) == pytest.approx(0.0, abs=1e-14)
    assert np.ptp(found["arb_arm_end.y"].to_numpy()) == 0.0
    ratio = found["anti_roll_bar_motion_ratio"]
    assert np.all(ratio > 1.0)  # the arm end lies behind the pivot: bump lifts it, a turn about +y
    assert found["anti_roll_bar_rate"].to_numpy() == pytest.approx(
        2.0 * 900.0 * ratio.to_numpy() ** 2, rel=1e-12
    )


ON_ROCKER = {
    "hardpoints.arb_pivot": [-0.08, 0.15, 0.36],
    "hardpoints.arb_axis": [-0.18, 0.20, 0.33],
    "hardpoints.arb_arm_end": [-0.15, 0.12, 0.44],
    "hardpoints.arb_link_end": [0.0, 0.26, 0.45],
    "anti_roll_bar": {"stiffness": 900.0, "on": "rocker"},
}


@pytest.mark.parametrize("side", ["left", "right"])
def test_a_bar_on_the_rocker_turns_about_its_own_axis(side: str) -> None:
    rig = jn.load("formula-student-front").with_changes(ON_ROCKER)
    rig = rig if side == "left" else rig.mirrored()
    found = jn.sweep_travel(rig, np.linspace(-0.02, 0.02, 5), points=True)
    link = np.stack(
        [found[f"arb_link_end.{axis}"] - found[f"arb_arm_end.{axis}"] for axis in "xyz"]
    )
    assert np.ptp(np.linalg.norm(link, axis=0)) < 1e-13
    points = rig.hardpoints
    along = np.array(points.arb_axis) - np.array(points.arb_pivot)
    along = along / np.linalg.norm(along) * np.sign(along[1])
    arm = np.stack([found[f"arb_arm_end.{axis}"] for axis in "xyz"], axis=1) - np.array(
        points.arb_pivot
    )
    assert np.ptp(arm @ along) < 1e-13
    assert np.ptp(np.linalg.norm(arm, axis=1)) < 1e-13
    level = arm - np.outer(arm @ along, along)
    turned = np.arctan2(np.cross(level[2], level) @ along, level @ level[2])
    assert found["anti_roll_bar_angle"].to_numpy() == pytest.approx(turned, abs=1e-12)
    other = jn.sweep_travel(rig.mirrored(), np.linspace(-0.02, 0.02, 5))
    for row in ("anti_roll_bar_angle", "anti_roll_bar_rate"):
        assert other[row].to_numpy() == pytest.approx(found[row].to_numpy(), abs=1e-9)


def test_roll_moment_of_a_bar_on_the_rocker_is_the_slope_of_its_energy() -> None:
    rig, step = jn.load("formula-student-front").with_changes(ON_ROCKER), 1e-4
    plain = jn.load("formula-student-front")
    rolled = 0.01 + step * np.arange(-2, 3)
    found, without = jn.sweep_roll(rig, rolled), jn.sweep_roll(plain, rolled)
    twist = (found["right.anti_roll_bar_angle"] - found["left.anti_roll_bar_angle"]).to_numpy()
    moment = float(found["roll_moment"][2] - without["roll_moment"][2])
    assert differences(0.5 * 900.0 * twist**2, step) == pytest.approx(moment, rel=1e-7)
    assert abs(moment) > 1.0


def test_bars_that_hang_on_nothing_are_refused() -> None:
    with pytest.raises(jn.DescriptionError, match="rocker"):
        jn.load("reference-double-wishbone").with_changes(ON_ROCKER)
    with pytest.raises(jn.DescriptionError, match="arb_pivot"):
        jn.load("formula-student-front").with_changes({"hardpoints.arb_axis": [0.0, 0.1, 0.1]})


def test_slopes_of_the_anti_roll_bar(with_bar) -> None:
    found = jn.sweep_travel(with_bar, 0.02 + STEP * np.arange(-2, 3))
    for slope, value in (
        ("anti_roll_bar_motion_ratio", "anti_roll_bar_angle"),
        ("anti_roll_bar_motion_ratio_gradient", "anti_roll_bar_motion_ratio"),
    ):
        assert differences(found[value].to_numpy()) == pytest.approx(
            float(found[slope][2]), rel=1e-7
        )


def test_roll_stiffness_with_a_bar(with_bar) -> None:
    step = 1e-4
    found = jn.sweep_roll(with_bar, 0.02 + step * np.arange(-2, 3))
    assert differences(found["roll_moment"].to_numpy(), step) == pytest.approx(
        float(found["roll_stiffness"][2]), rel=1e-6
    )
    still = jn.sweep_roll(with_bar, 0.0)
    corner = jn.sweep_travel(with_bar, 0.0)
    rate = float(corner["anti_roll_bar_rate"][0])
    arm = float(still["right.roll_camber"][0]) / float(
        corner["camber_gain"][0]
    )  # travel of a wheel for a radian of roll
    assert float(still["roll_stiffness_bar"][0]) == pytest.approx(2.0 * rate * arm**2, rel=1e-9)
