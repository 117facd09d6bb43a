"""Torsion bars, third springs, T-, Z- and blade bars: forces are slopes of energies, T-bars stay closed."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import jounce as jn
from jounce.kinematics.axle import TwoWheelAxle
from jounce.mechanics import Mechanism
from jounce.models.attachments import link_end, t_bar_of
from jounce.models.bars import t_bar_function
from jounce.models.corner import build_linkage
from jounce.parts.advice import rig_findings
from jounce.parts.files import rig_text
from jounce.simulation import equilibrium

STEP = 1e-4
THIRD = {
    "third_spring": {"spring": {"rate": 30e3, "preload": 150.0}, "damper": {"coefficient": 800.0}},
    "hardpoints.third_spring_end": [0.02, 0.21, 0.42],
}
T_BAR = {
    "hardpoints.arb_pivot": [-0.10, 0.0, 0.30],
    "hardpoints.arb_axis": [-0.08, 0.0, 0.45],
    "hardpoints.arb_arm_end": [-0.08, 0.16, 0.45],
    "hardpoints.arb_link_end": [0.0, 0.20, 0.44],
    "anti_roll_bar": {"stiffness": 400.0, "on": "rocker", "kind": "t"},
}
U_BAR = {
    "hardpoints.arb_pivot": [-0.08, 0.15, 0.36],
    "hardpoints.arb_arm_end": [-0.15, 0.15, 0.44],
    "hardpoints.arb_link_end": [0.0, 0.22, 0.43],
    "anti_roll_bar": {"stiffness": 900.0, "on": "rocker"},
}


def differences(values: np.ndarray) -> float:
    a, b, _, d, e = values
    return float((a - 8.0 * b + 8.0 * d - e) / (12.0 * STEP))


@pytest.fixture(scope="module")
def plain():
    return jn.load("formula-student-front")


@pytest.fixture(scope="module")
def sprung(plain):
    """Torsion bar on the lower arm in place of the coil spring, and a third spring; a left and a right corner."""
    table = plain.model_dump(by_alias=True, exclude_none=True)
    table["strut"].pop("spring")
    table["torsion_bar"] = {"stiffness": 1900.0, "preload": 120.0, "on": "lower_arm"}
    rig = type(plain).from_table(table).with_changes(THIRD)
    return {"left": rig, "right": rig.mirrored()}


@pytest.mark.parametrize("side", ["left", "right"])
def test_forces_and_rates_are_slopes(sprung, side: str) -> None:
    found = jn.sweep_travel(sprung[side], 0.012 + STEP * np.arange(-2, 3), points=True)
    turned, ratio = (
        found["torsion_bar_angle"].to_numpy(),
        float(found["torsion_bar_motion_ratio"][2]),
    )
    arm = np.stack(
        [found[f"lower_ball_joint.{axis}"] - found[f"lower_arm_front.{axis}"] for axis in "xyz"],
        axis=1,
    )
    points = sprung[side].hardpoints
    axis = np.array(points.lower_arm_front) - np.array(points.lower_arm_rear)
    axis = axis / np.linalg.norm(axis)
    design = np.array(points.lower_ball_joint) - np.array(points.lower_arm_front)
    flat, level = arm - np.outer(arm @ axis, axis), design - (design @ axis) * axis
    seen = np.arctan2(np.cross(level, flat) @ axis, flat @ level)
    assert turned == pytest.approx(seen * np.sign(seen[2] * turned[2]), abs=1e-13)
    assert turned[2] > 0.0  # bump winds it up
    length = 2.0 * np.abs(found["third_spring_end.y"].to_numpy())
    assert found["third_spring_length"].to_numpy() == pytest.approx(length, abs=1e-14)
    short = length - 2.0 * 0.21
    energy = 120.0 * turned + 0.5 * 1900.0 * turned**2
    assert differences(energy) == pytest.approx(float(found["wheel_force"][2]), rel=1e-8)
    assert differences(turned) == pytest.approx(ratio, rel=1e-9)
    shared = 0.5 * (0.5 * 30e3 * short**2 - 150.0 * short)  # half of the energy is this wheel's
    assert differences(shared) == pytest.approx(float(found["third_wheel_force"][2]), rel=1e-8)
    for slope, value in (
        ("wheel_rate", "wheel_force"),
        ("third_wheel_rate", "third_wheel_force"),
        ("heave_rate", "heave_force"),
    ):
        assert differences(found[value].to_numpy()) == pytest.approx(
            float(found[slope][2]), rel=1e-8
        )
    heave = float(found["wheel_rate"][2] + found["third_wheel_rate"][2])
    assert float(found["heave_rate"][2]) == pytest.approx(heave, rel=1e-12)
    damped = 0.5 * 800.0 * found["third_spring_motion_ratio"] ** 2
    assert found["third_damping_coefficient"].to_numpy() == pytest.approx(
        damped.to_numpy(), rel=1e-12
    )
    assert "spring_force" not in found


@pytest.mark.slow
def test_a_car_stands_on_torsion_bar_and_third_spring_as_on_a_coil(plain, sprung) -> None:
    """Where the coil of the plain rig gives the same force at the wheel, both stand at the same height."""
    rest = equilibrium(sprung["left"])
    travel = float(rest["unsprung.z"] - rest["sprung.z"])
    found = jn.sweep_travel(sprung["left"], travel)
    ratio = jn.sweep_travel(plain, travel)
    needed = float((found["wheel_force"] + found["third_wheel_force"])[0]) / float(
        ratio["motion_ratio"][0]
    )
    short = plain.hardpoints.length("spring") - float(ratio["spring_length"][0])
    same = plain.with_changes({"strut.spring.preload": needed - 35e3 * short})
    again = equilibrium(same)
    assert float(again["unsprung.z"] - again["sprung.z"]) == pytest.approx(travel, abs=1e-9)
    assert abs(travel) < 0.03


def test_files_keep_torsion_bars_and_third_springs(sprung, tmp_path) -> None:
    text = rig_text(sprung["left"])
    assert "spring = {rate" not in text.split("[third_spring]")[0]
    (tmp_path / "rig.toml").write_text(text, encoding="utf-8")
    again = jn.load(tmp_path / "rig.toml")
    assert again.parameters() == pytest.approx(sprung["left"].parameters())
    assert "strut.spring.rate" not in again.parameters()
    assert again.mirrored() == sprung["right"]
    assert not any(
        "strut.spring" in item.place for item in rig_findings(again)
    )  # nothing stands in for it there


# bars -----------------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def stem(plain):
    return plain.with_changes({**T_BAR, **THIRD})


def test_a_t_bar_stays_closed_and_its_forces_are_slopes_of_the_energy(stem) -> None:
    axle, middle = TwoWheelAxle(stem), (0.011, -0.004)

    def at(left: np.ndarray, right: np.ndarray):
        wheels = [
            axle.wheel(side, travel, np.zeros_like(travel))
            for side, travel in ((1.0, left), (-1.0, right))
        ]
        return axle.connection(*wheels), wheels

    for side in (0, 1):
        pair = [np.full(5, travel) for travel in middle]
        pair[side] = pair[side] + STEP * np.arange(-2, 3)
        found, wheels = at(*pair)
        twist, deflection = (
            found.rows["anti_roll_bar_twist"][0],
            found.rows["third_spring_deflection"][0],
        )
        energy = 0.5 * 400.0 * twist**2 + 0.5 * 30e3 * deflection**2 + 150.0 * deflection
        assert differences(energy) == pytest.approx(found.forces[side][2], rel=1e-8)
        length = np.linalg.norm(
            np.subtract(T_BAR["hardpoints.arb_link_end"], T_BAR["hardpoints.arb_arm_end"])
        )
        for wheel, tip in zip(wheels, found.arm_ends, strict=True):
            link = wheel.ends.bar[0] - tip
            assert np.linalg.norm(link, axis=1) == pytest.approx(length, abs=1e-12)
        one, other = found.arm_ends
        assert np.linalg.norm(one - other, axis=1) == pytest.approx(0.32, abs=1e-13)  # a rigid bar
    assert abs(twist[2]) > 0.01
    alike = jn.sweep_travel(
        stem, 0.011, points=True
    )  # in heave the axle is two of the corner's bars
    both = np.full(1, 0.011)
    found, _ = at(both, both)
    for name, place in (("arb_arm_end", found.arm_ends[0]), ("arb_axis", found.stem_end)):
        assert place[0] == pytest.approx(
            [float(alike[f"{name}.{axis}"][0]) for axis in "xyz"], abs=1e-12
        ), name


def test_a_t_bar_is_found_where_it_was_put() -> None:
    """Hinged over and twisted by up to half a radian, its links swung as they may: that pose, no other."""
    random = np.random.default_rng(5)
    stem, mirror = np.array([0.02, 0.0, 0.15]), np.array([1.0, -1.0, 1.0])
    arms, far = (
        np.stack([np.array(point), mirror * point], axis=1)
        for point in ([0.02, 0.16, 0.15], [0.1, 0.2, 0.14])
    )
    design, along = far - arms, stem / np.linalg.norm(stem)
    for hinge, twist in random.uniform(-0.5, 0.5, (200, 2)):
        put = Rotation.from_rotvec([0.0, hinge, 0.0]) * Rotation.from_rotvec(twist * along)
        links = put.apply(design.T) + random.normal(0.0, 0.015, (2, 3))
        links *= np.linalg.norm(design, axis=0)[:, None] / np.linalg.norm(links, axis=1)[:, None]
        found = t_bar_function()(stem, arms, far, (put.apply(arms.T) + links).T)
        assert (float(found[0]), float(found[1])) == pytest.approx((hinge, twist), abs=1e-10)


def test_a_t_bar_whose_links_hold_nothing_has_no_numbers(plain) -> None:
    along = {
        "hardpoints.arb_arm_end": [-0.08, 0.16, 0.45],
        "hardpoints.arb_link_end": [-0.08, 0.20, 0.45],
    }
    loose = plain.with_changes({**T_BAR, **along})
    assert any("hardly hold the T-bar" in item.message for item in rig_findings(loose))
    assert not any("T-bar" in item.message for item in rig_findings(plain.with_changes(T_BAR)))
    found = jn.sweep_axle(loose, left_travel=0.005, right_travel=-0.005)
    for name in ("anti_roll_bar_twist", "anti_roll_bar_torque", "left.axle_force"):
        assert np.isnan(found[name].to_numpy()).all(), name
    assert np.isfinite(found["left.camber_to_ground"].to_numpy()).all()


def test_a_t_bar_twists_in_roll_only(stem) -> None:
    """Rates of the corner's rows, those of opposite and equal travel, are those of the axle."""
    axle, small = TwoWheelAxle(stem), 1e-5
    row = jn.sweep_travel(stem, 0.008)
    for way, name in ((-1.0, "anti_roll_bar_rate"), (1.0, "third_wheel_rate")):
        both = 0.008 + small * np.array([-1.0, 0.0, 1.0])
        left, right = (
            axle.wheel(side, at, np.zeros(3))
            for side, at in ((1.0, both), (-1.0, 0.008 + way * (both - 0.008)))
        )
        found = axle.connection(left, right)
        bar = found.rows["anti_roll_bar_twist"][0]
        if way > 0.0:
            assert np.abs(bar).max() < 1e-12
            rate = (found.forces[0][2] - found.forces[0][0]) / (2.0 * small)
        else:
            rate = 400.0 * 0.5 * ((bar[2] - bar[0]) / (2.0 * small)) ** 2
        assert rate == pytest.approx(float(row[name][0]), rel=1e-6)


def test_roll_stiffness_is_the_slope_of_the_moment(stem) -> None:
    rolled = jn.sweep_roll(stem, 0.01 + STEP * np.arange(-2, 3))
    for total, moment in (("roll_stiffness", "roll_moment"),):
        assert differences(rolled[moment].to_numpy()) == pytest.approx(
            float(rolled[total][2]), rel=1e-6
        )
    tyres = 0.5 * 105e3 * float(rolled["track"][2]) ** 2
    stiffness = float(rolled["roll_stiffness"][2])
    assert float(rolled["roll_stiffness_total"][2]) == pytest.approx(
        1.0 / (1.0 / stiffness + 1.0 / tyres), rel=1e-12
    )


def test_a_z_bar_works_in_heave_and_not_in_roll(plain) -> None:
    rig = plain.with_changes(U_BAR).with_changes({"anti_roll_bar.kind": "z"})
    found = jn.sweep_travel(rig, 0.01 + STEP * np.arange(-2, 3))
    angle = found["anti_roll_bar_angle"].to_numpy()
    energy = 0.5 * 0.5 * 900.0 * (2.0 * angle) ** 2  # half of it is this wheel's
    rate = float((found["heave_rate"] - found["wheel_rate"])[2])
    force = found["heave_force"].to_numpy() - found["wheel_force"].to_numpy()
    assert differences(energy) == pytest.approx(force[2], rel=1e-8)
    assert differences(force) == pytest.approx(rate, rel=1e-8)
    second = (
        energy[0] * -1.0 + 16.0 * energy[1] - 30.0 * energy[2] + 16.0 * energy[3] - energy[4]
    ) / (12.0 * STEP**2)
    assert rate == pytest.approx(second, rel=1e-5)
    assert float(found["anti_roll_bar_rate"][2]) == 0.0
    rolled, without = (jn.sweep_roll(one, [-0.01, 0.0, 0.01]) for one in (rig, plain))
    assert rolled["roll_stiffness"].to_numpy() == pytest.approx(
        without["roll_stiffness"].to_numpy(), rel=2e-2
    )
    share = float(rolled["roll_stiffness_bar"][1] / rolled["roll_stiffness"][1])
    assert abs(share) < 1e-6  # a difference inside, and both ends turn alike to first order only


@pytest.mark.slow
def test_a_z_bar_carries_a_corner_at_rest(plain) -> None:
    rig = plain.with_changes(U_BAR).with_changes({"anti_roll_bar.kind": "z"})
    rest = equilibrium(rig.with_changes({"strut.spring.preload": 900.0}))
    travel = float(rest["unsprung.z"] - rest["sprung.z"])
    turned = float(jn.sweep_travel(rig, travel)["anti_roll_bar_angle"][0])
    assert rest["anti_roll_bar.twist"] == pytest.approx(2.0 * turned, rel=1e-6)
    assert rest["anti_roll_bar.torque"] == pytest.approx(
        900.0 * rest["anti_roll_bar.twist"], rel=1e-12
    )
    assert abs(turned) > 1e-3


def test_blades_bend_as_cantilevers(plain) -> None:
    length = np.hypot(0.07, 0.08)  # from the axis to the link

    def stiffness(angle: float) -> float:
        blade = {"width": 0.02, "thickness": 0.005, "angle": angle, "youngs_modulus": 70e9}
        rig = plain.with_changes({**U_BAR, "anti_roll_bar.blade": blade})
        return float(jn.sweep_travel(rig, 0.0)["anti_roll_bar_stiffness"][0])

    flat, edge = 0.02 * 0.005**3 / 12.0, 0.005 * 0.02**3 / 12.0
    for angle, section in ((0.0, flat), (0.5 * np.pi, edge)):
        blade = 3.0 * 70e9 * section / length  # N m/rad of one arm
        assert stiffness(angle) == pytest.approx(1.0 / (1.0 / 900.0 + 2.0 / blade), rel=1e-12)
    between = 1.0 / stiffness(0.25 * np.pi) - 1.0 / 900.0
    ends = sum(1.0 / stiffness(angle) - 1.0 / 900.0 for angle in (0.0, 0.5 * np.pi))
    assert between == pytest.approx(0.5 * ends, rel=1e-12)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"hardpoints.third_spring_end": [0.0, 0.2, 0.4]}, "needs its table"),
        ({**THIRD, "hardpoints.third_spring_end": [0.0, 0.001, 0.4]}, "middle of the car"),
        ({**T_BAR, "hardpoints.arb_axis": [-0.08, 0.01, 0.45]}, "not in the middle"),
        ({**U_BAR, "anti_roll_bar.kind": "t"}, "stem of a T-bar"),
        ({"torsion_bar": {"stiffness": 100.0, "on": "upright"}}, "lower_arm"),
    ],
)
def test_bad_parts_are_refused(plain, change, message: str) -> None:
    with pytest.raises(jn.DescriptionError, match=message):
        plain.with_changes(change)


@pytest.mark.slow
def test_a_third_spring_of_a_whole_car_stiffens_heave_and_not_roll() -> None:
    car = jn.load("formula-student-car")
    third = {
        "third_spring": {"spring": {"rate": 60e3}},
        "hardpoints.third_spring_end": [0.02, 0.21, 0.42],
    }
    stiff = car.with_changes({f"front.corner.{path}": value for path, value in third.items()})
    shares = []
    for one in (car, stiff):
        found = jn.modes(one)
        rolls = [mode for mode in found if abs(complex(*mode.shape["body.roll"])) > 0.99]
        shares.append((rolls[0].frequency_hz, found[0].frequency_hz + found[1].frequency_hz))
    assert shares[1][0] == pytest.approx(shares[0][0], rel=1e-4)
    assert shares[1][1] > 1.2 * shares[0][1]  # both motions of heave and pitch together
    rest = equilibrium(stiff)
    deflection, force = (
        float(rest[f"front.third_spring.{name}"]) for name in ("deflection", "force")
    )
    assert force == pytest.approx(60e3 * deflection, rel=1e-9)


@pytest.mark.slow
def test_a_described_bar_of_a_whole_car_is_its_rate_at_the_wheel() -> None:
    """A U- or T-bar stiffens roll as half of its rate in opposite travel (a force for each metre of difference)."""
    bare = jn.load("formula-student-car").with_changes({"front.anti_roll_bar_rate": 0.0})
    stem = {"stiffness": 6000.0, "on": "rocker", "kind": "t"}
    described = {
        kind: bare.with_changes({f"front.corner.{path}": value for path, value in parts.items()})
        for kind, parts in {"u": U_BAR, "z": U_BAR, "t": {**T_BAR, "anti_roll_bar": stem}}.items()
    }
    described["z"] = described["z"].with_changes({"front.corner.anti_roll_bar.kind": "z"})
    cars = {**described, "bare": bare}
    for kind in "ut":
        rest = equilibrium(described[kind])  # the rate changes with travel
        travel = float(rest["front_left.unsprung.z"] - rest["front_left.sprung.z"])
        rate = float(jn.sweep_travel(described[kind].front.corner, travel)["anti_roll_bar_rate"][0])
        cars[f"rate of {kind}"] = bare.with_changes({"front.anti_roll_bar_rate": 0.5 * rate})
    modes = {name: jn.modes(car) for name, car in cars.items()}
    roll = {
        name: next(
            mode.frequency_hz for mode in found if abs(complex(*mode.shape["body.roll"])) > 0.99
        )
        for name, found in modes.items()
    }
    for kind in "ut":
        assert roll[kind] == pytest.approx(roll[f"rate of {kind}"], rel=1e-6), kind
        assert roll[kind] > 1.1 * roll["bare"], kind
    assert roll["z"] == pytest.approx(roll["bare"], rel=1e-4)
    assert modes["z"][1].frequency_hz > 1.2 * modes["bare"][1].frequency_hz
    rest = equilibrium(described["z"])
    assert rest["front.anti_roll_bar.torque"] == pytest.approx(
        900.0 * rest["front.anti_roll_bar.twist"], rel=1e-12
    )


def test_a_car_has_its_bar_once() -> None:
    car = jn.load("formula-student-car")
    for parts in (U_BAR, T_BAR):
        with pytest.raises(jn.DescriptionError, match="would be counted twice"):
            car.with_changes({f"front.corner.{path}": value for path, value in parts.items()})


def test_the_t_bar_of_a_car_is_that_of_the_axle(stem) -> None:
    """Twist as in kinematics, its rate as the slope of the twist: the power of its torque is that of its energy."""
    mechanism = Mechanism()
    pair = []
    for name, turned in (("left", 1.0), ("right", -1.0)):
        with mechanism.within(name, "corner"):
            pair.append(build_linkage(stem, mechanism, mechanism.ground, ahead=0.1, turned=turned))
    held = t_bar_of(*pair)
    rate = sum(
        ca.dot(slope, link_end(one).rate)
        for slope, one in zip(held.twist_slopes, pair, strict=True)
    )
    exact, travels = mechanism.rate_of(held.twist), [one.wheel_centre.value[2] for one in pair]
    collection = mechanism.collection
    numbers = stem.parameters()
    symbols = collection.parameters
    p = [numbers[path.removeprefix("corner.")] for path in symbols]
    closed = ca.vertcat(*(one.value for one in collection.constraints))
    target = ca.SX.sym("travel", 2)
    turns = [collection.q[first : first + 4] for first in collection.quaternions.values()]
    closed = ca.vertcat(closed, *(ca.dot(turn, turn) - 1.0 for turn in turns))
    off = ca.vertcat(closed, ca.vertcat(*travels) - numbers["hardpoints.wheel_centre[2]"] - target)
    gaps = ca.Function(
        "gaps",
        [collection.q, ca.vertcat(*symbols.values()), target],
        [off, ca.jacobian(off, collection.q)],
    )
    shown = ca.Function(
        "shown",
        [collection.q, collection.v, ca.vertcat(*symbols.values())],
        [held.twist, exact, rate, held.hinge],
    )
    random = np.random.default_rng(3)
    for pair_of_travels in ((0.011, -0.004), (-0.02, 0.025), (0.03, 0.03)):
        q = np.array(list(collection.start.values()))
        for _ in range(30):
            left, slope = (np.asarray(part) for part in gaps(q, p, pair_of_travels))
            q = q - np.linalg.lstsq(slope, left.ravel(), rcond=None)[0]
        axle = jn.sweep_axle(stem, left_travel=pair_of_travels[0], right_travel=pair_of_travels[1])
        speeds = random.standard_normal(collection.v.numel())
        twist, by_slope, by_links, hinge = (float(part) for part in shown(q, speeds, p))
        assert twist == pytest.approx(float(axle["anti_roll_bar_twist"][0]), abs=1e-12)
        assert hinge == pytest.approx(float(axle["anti_roll_bar_hinge_angle"][0]), abs=1e-12)
        assert by_links == pytest.approx(by_slope, rel=1e-9, abs=1e-12)
