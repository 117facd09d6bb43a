"""Slopes along hardpoints: exact for every row of the catalogue, against differences of whole sweeps."""

from __future__ import annotations

import numpy as np
import pytest

import jounce as jn
from jounce.design.free_points import Numbering
from jounce.design.kinematic_study import KinematicTarget
from jounce.design.kinematic_targets import Evaluators, read_targets
from jounce.kinematics.model import kinematic_model
from jounce.kinematics.sweeps import prepare_sweep
from jounce.kinematics.tangents import Tangents

RIGS = (
    "reference-double-wishbone",
    "formula-student-front",
    "generic-mcpherson",
    "sedan-multi-link",
    "semi-trailing-arm",
)
STEP = 2e-6


@pytest.mark.parametrize(  # five links differ from the others in their number only, and take five seconds to compile
    "name",
    [
        pytest.param(name, marks=[pytest.mark.slow] if name == "sedan-multi-link" else [])
        for name in RIGS
    ],
)
def test_slopes_of_every_row_along_every_hardpoint(name: str) -> None:
    rig = jn.load(name)
    model = kinematic_model(rig)
    sweep = prepare_sweep(rig, [-0.02, 0.0, 0.015], 0.004 if len(model.tracks) > 1 else None)
    points = [
        i for i, path in enumerate(model.parameters) if path.startswith(("hardpoints.", "wheel."))
    ]
    directions = np.zeros((len(model.tracks) + len(model.parameters), len(points)))
    for j, i in enumerate(points):
        directions[len(model.tracks) + i, j] = 1.0
    sweep.run()
    exact = Tangents(sweep, directions).run()
    numbers = sweep.walk.p.copy()
    outputs = sweep.found.outputs.copy()
    largest = np.max(np.abs(exact), axis=(1, 2)) + 1e-6 * np.max(np.abs(outputs), axis=1) / 1e-3
    for j, i in enumerate(points):
        ends = []
        for sign in (1.0, -1.0):
            sweep.walk.p[:] = numbers
            sweep.walk.p[i] += sign * STEP
            sweep.run()
            ends.append(sweep.found.outputs.copy())
        difference = (ends[0] - ends[1]) / (2.0 * STEP)
        error = np.max(np.abs(difference - exact[:, j]), axis=1) / np.maximum(largest, 1e-6)
        worst = int(np.argmax(error))
        assert error[worst] < 2e-5, (model.parameters[i], model.rows[worst].name)


def test_slopes_along_travel_and_rack() -> None:
    rig = jn.load("formula-student-front")
    model = kinematic_model(rig)
    sweep = prepare_sweep(rig, [0.01], 0.003)
    sweep.run()
    found = Tangents(sweep, np.eye(2 + len(model.parameters))[:, :2]).run()[:, :, 0]
    rows = [row.name for row in model.rows]
    values = dict(zip(rows, sweep.found.outputs[:, 0], strict=True))
    assert found[rows.index("camber"), 0] == pytest.approx(values["camber_gain"], rel=1e-10)
    assert found[rows.index("spring_length"), 0] == pytest.approx(
        -values["motion_ratio"], rel=1e-10
    )
    assert found[rows.index("steer"), 1] == pytest.approx(values["steer_gain"], rel=1e-10)
    assert found[rows.index("wheel_centre_z")] == pytest.approx([1.0, 0.0], abs=1e-10)


@pytest.mark.parametrize(
    "target",
    [
        {
            "quantity": "roll_centre_height",
            "over": "-2 deg:2 deg:1 deg",
            "at_least": 0.0,
            "tolerance": "1 mm",
        },
        {
            "quantity": "right.camber_to_ground",
            "over": "-2 deg:2 deg:1 deg",
            "at_least": 0.0,
            "tolerance": "1 deg",
        },
        {"quantity": "left.roll_steer", "at": "1.5 deg", "at_least": 0.0, "tolerance": 0.1},
        {"quantity": "track", "over": "-2 deg:2 deg:1 deg", "at_least": 0.0, "tolerance": "1 mm"},
        {"quantity": "ackermann", "at": {"rack": "15 mm"}, "at_least": 0.0, "tolerance": 0.1},
        {
            "quantity": "turn_diameter_kerbs",
            "at": {"rack": "15 mm"},
            "at_least": 0.0,
            "tolerance": 0.1,
        },
        {"quantity": "anti_dive", "over": "-20 mm:20 mm:20 mm", "at_least": 0.0, "tolerance": 0.1},
        {
            "quantity": "distance(tie_rod_inner, tie_rod_outer)",
            "at_least": 0.0,
            "tolerance": "1 mm",
        },
        {
            "quantity": "roll_centre_height",
            "over": "-20 mm:20 mm:10 mm",
            "value": 0.0,
            "tolerance": 0.1,
            "slope": True,
        },
        {
            "quantity": "steer",
            "over": "-10 mm:10 mm:5 mm",
            "along": "rack",
            "value": 0.0,
            "tolerance": 0.1,
        },
    ],
    ids=lambda target: target["quantity"],
)
def test_slopes_of_targets_are_those_of_their_values(target: dict) -> None:
    rig = jn.load("formula-student-front")
    car = jn.AxleLayout(axle="front", wheelbase=1.55, centre_of_mass_height=0.3, brake_share=0.6)
    wanted = read_targets({"": rig}, [KinematicTarget(**target)], {"": car})
    model = kinematic_model(rig)
    paths = [
        "hardpoints.tie_rod_inner[2]",
        "hardpoints.upper_ball_joint[1]",
        "hardpoints.wheel_centre[0]",
    ]
    paths += ["hardpoints.lower_arm_front[2]", "wheel.radius"]
    directions = np.zeros((len(model.parameters), len(paths)))
    for j, path in enumerate(paths):
        directions[model.parameters.index(path), j] = 1.0
    numbering = Numbering.of({"": rig})
    evaluator = Evaluators(numbering, wanted, directions, np.full(len(paths), 0.01), {"": car})
    numbers = numbering.values()
    _, slopes = evaluator.at(numbers)
    assert np.max(np.abs(slopes[0])) > 0.0
    step = 2e-5
    for j in range(len(paths)):
        ends = [
            evaluator.at(numbers + sign * step * directions[:, j], slopes=False)[0][0]
            for sign in (1.0, -1.0)
        ]
        difference = (ends[0] - ends[1]) / (2.0 * step)
        scale = np.max(np.abs(slopes[0])) + 1e-9
        assert slopes[0][:, j] / scale == pytest.approx(difference / scale, abs=2e-6), paths[j]


@pytest.mark.parametrize(
    ("quantity", "pose"),
    [
        ("roll_centre_height", {"at": "1.5 deg"}),
        ("roll_moment", {"at": "1.5 deg"}),
        ("right.camber_to_ground", {"over": "-1 deg:1 deg:1 deg"}),
        ("right.wheel_travel", {"at": "1.5 deg"}),
        ("ackermann", {"at": {"rack": "15 mm"}}),
    ],
)
def test_an_axle_of_two_corners(quantity: str, pose: dict) -> None:
    """Values are those of the sweep of both; slopes along numbers of either side are those of the values."""
    left = jn.load("formula-student-front")
    moved = {
        "hardpoints.upper_arm_front[2]": 0.265,
        "hardpoints.wheel_centre[1]": -0.61,
        "wheel.radius": 0.230,
    }
    rigs = {
        "left": left,
        "right": left.mirrored().with_changes({**moved, "strut.spring.rate": 30e3}),
    }
    car = jn.AxleLayout(axle="front", wheelbase=1.55, centre_of_mass_height=0.3, brake_share=0.6)
    target = {
        "quantity": quantity,
        **pose,
        "at_least": -1e9,
        "tolerance": 0.1,
        "rig": "left",
        "right": "right",
    }
    extra = (
        [{**target, "quantity": f"{side}.wheel_travel"} for side in rigs]
        if quantity != "ackermann"
        else []
    )
    wanted = read_targets(rigs, [KinematicTarget(**one) for one in [target, *extra]], {"left": car})
    numbering = Numbering.of(rigs)
    paths = [
        "left.hardpoints.tie_rod_inner[2]",
        "right.hardpoints.upper_ball_joint[1]",
        "right.wheel.radius",
    ]
    directions = np.array([[float(path == one) for one in paths] for path in numbering.paths])
    evaluator = Evaluators(numbering, wanted, directions, np.full(3, 0.01), {"left": car})
    numbers = numbering.values()
    values, slopes = evaluator.at(numbers)
    if quantity == "ackermann":
        swept = jn.sweep_axle(
            left, right=rigs["right"], left_travel=0.0, right_travel=0.0, rack=0.015, vehicle=car
        )
    else:
        swept = jn.sweep_axle(
            left, right=rigs["right"], left_travel=values[1], right_travel=values[2]
        )
        assert np.degrees(swept["roll_angle"].to_numpy()) == pytest.approx(
            np.degrees(wanted[0].at), abs=1e-7
        )
    if quantity in swept:
        assert values[0] == pytest.approx(swept[quantity].to_numpy(), rel=1e-7)
    alone = read_targets(
        {"": left}, [KinematicTarget(**{**target, "rig": None, "right": None})], {"": car}
    )
    mirrored = Evaluators(
        Numbering.of({"": left}), alone, np.zeros((len(numbers) // 2, 0)), np.zeros(0), {"": car}
    )
    assert (
        np.max(
            np.abs(
                values[0]
                - mirrored.at(kinematic_model(left).parameter_values(left), slopes=False)[0][0]
            )
        )
        > 1e-4
    )
    step = 2e-5
    for j, path in enumerate(paths):
        ends = [
            evaluator.at(numbers + sign * step * directions[:, j], slopes=False)[0][0]
            for sign in (1.0, -1.0)
        ]
        scale = np.max(np.abs(slopes[0])) + 1e-9
        assert slopes[0][:, j] / scale == pytest.approx(
            (ends[0] - ends[1]) / (2.0 * step) / scale, abs=3e-6
        ), path
    assert np.abs(slopes[0][:, 1:]).max() > 0.0


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"right": "rihgt"}, "rihgt"),
        ({"right": "left"}, "not a right corner"),
        ({"rig": "right", "right": "left"}, "not a left corner"),
        ({"quantity": "camber", "at": "10 mm"}, "rolled or steered"),
    ],
)
def test_corners_that_are_no_axle_are_refused(changes: dict, words: str) -> None:
    left = jn.load("formula-student-front")
    target = {
        "quantity": "track",
        "at": "1 deg",
        "value": "1.2 m",
        "tolerance": "1 mm",
        "rig": "left",
        "right": "right",
    }
    with pytest.raises(jn.DescriptionError, match=words):
        read_targets(
            {"left": left, "right": left.mirrored()}, [KinematicTarget(**{**target, **changes})], {}
        )


def test_targets_without_a_tolerance_have_the_usual_one_of_their_unit() -> None:
    rig = jn.load("formula-student-front")
    wishes = [
        KinematicTarget(quantity=name, value=0.0, weight=2.0)
        for name in ("toe", "camber_gain", "scrub_radius")
    ]
    toe, gain, scrub = read_targets({"": rig}, wishes, {})
    assert (
        np.degrees(toe.tolerance),
        np.degrees(gain.tolerance),
        scrub.tolerance,
    ) == pytest.approx((0.05, 0.5, 1e-3))
    with pytest.raises(
        jn.DescriptionError, match=r"target\[0\].tolerance: the key is missing.*above 0 N"
    ):
        read_targets({"": rig}, [KinematicTarget(quantity="wheel_force", value=0.0)], {})


def test_roll_stiffness_is_a_target_with_bars_and_third_springs_too() -> None:
    """Values are those of the roll sweep; slopes those of sweeps of other rigs."""
    rig = jn.load("formula-student-front").with_changes(
        {
            "hardpoints.arb_pivot": [-0.10, 0.0, 0.30],
            "hardpoints.arb_axis": [-0.08, 0.0, 0.45],
            "hardpoints.arb_arm_end": [-0.08, 0.16, 0.45],
            "hardpoints.arb_link_end": [0.0, 0.20, 0.44],
            "anti_roll_bar": {"stiffness": 400.0, "on": "rocker", "kind": "t"},
        }
    )
    names = ("roll_stiffness_total", "roll_stiffness_bar", "roll_moment", "track")
    wishes = [
        KinematicTarget(quantity=name, at="1 deg", value=1.0, tolerance=1.0) for name in names
    ]
    numbering = Numbering.of({"": rig})
    path = "hardpoints.arb_arm_end[2]"
    directions = np.array([[float(one == path)] for one in numbering.paths])
    evaluator = Evaluators(
        numbering, read_targets({"": rig}, wishes, {}), directions, np.array([0.01]), {}
    )
    values, slopes = evaluator.at(numbering.values())
    swept = [
        jn.sweep_roll(rig.with_changes({path: 0.45 + step}), [np.radians(1.0)])
        for step in (0.0, 1e-4, -1e-4)
    ]
    for name, value, slope in zip(names, values, slopes, strict=True):
        found = [float(one[name][0]) for one in swept]
        assert value[0] == pytest.approx(found[0], rel=1e-9)
        assert slope[0, 0] == pytest.approx((found[1] - found[2]) / 2e-4, rel=1e-3, abs=1e-9), name
    assert slopes[1][0, 0] != 0.0
