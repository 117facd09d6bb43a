"""3-D rigs: what their files may say, what is refused and where, and copies with other values."""

from __future__ import annotations

import re
import tomllib
from typing import Any

import numpy as np
import pytest

from jounce import parts
from jounce.core.errors import DescriptionError
from jounce.parts import changed_text, load, rig_from_table
from jounce.parts.rig import structure_of, unit_of, unknown_path

TEXT = parts.library()["reference-double-wishbone"].read_text(encoding="utf-8")
REFERENCE = load("reference-double-wishbone")
FIVE_LINK = load("sedan-multi-link")
MAP = load("hmmwv-front")
INERTIA = {"xx": 0.1, "yy": 0.1, "zz": 0.1}
BODY = {"mass": 1.0, "centre_of_mass": [0.0, 0.6, 0.3], "inertia": INERTIA}
ROCKER = {
    "hardpoints.pushrod_outer": [0.0, 0.65, 0.15],
    "hardpoints.pushrod_inner": [0.0, 0.4, 0.5],
    "hardpoints.rocker_pivot": [0.0, 0.35, 0.45],
    "hardpoints.rocker_axis": [0.1, 0.35, 0.45],
    "hardpoints.strut_bottom": [0.0, 0.35, 0.52],
    "hardpoints.strut_top": [0.0, 0.1, 0.52],
    "bodies.rocker": {**BODY, "centre_of_mass": [0.0, 0.36, 0.47]},
    "strut.on": "rocker",
}
BAR = {
    "anti_roll_bar": {"stiffness": "300 N*m/deg", "on": "lower_arm"},
    "hardpoints.arb_pivot": [0.3, 0.0, 0.2],
    "hardpoints.arb_arm_end": [0.1, 0.45, 0.2],
    "hardpoints.arb_link_end": [0.1, 0.5, 0.15],
}
TRAILING = {
    "schema": "jounce.rig/1",
    "model": "trailing-arm",
    "hardpoints": {
        "arm_inner": [0.4, 0.3, 0.3],
        "arm_outer": [0.35, 0.65, 0.3],
        "wheel_centre": [0.0, 0.7, 0.3],
        "strut_bottom": [0.1, 0.6, 0.28],
        "strut_top": [0.15, 0.58, 0.6],
    },
    "wheel": {"radius": "310 mm"},
    "bodies": {"arm": {**BODY, "mass": "30 kg", "inertia": {"xx": 1.0, "yy": 1.5, "zz": 1.2}}},
    "sprung": {"mass": "300 kg"},
    "strut": {"spring": {"rate": "40 N/mm"}, "damper": {"coefficient": 2000.0}},
    "tyre": {"stiffness": "200 N/mm"},
}


def read(text: str) -> Any:
    return rig_from_table(tomllib.loads(text), where="rig.toml", text=text)


def test_points_are_triples_of_si_numbers():
    assert REFERENCE.hardpoints.lower_arm_front == pytest.approx((0.150, 0.400, 0.155))
    assert REFERENCE.hardpoints.length("spring") == pytest.approx(
        0.389102, abs=1e-6
    )  # E5 of the kinematics: 389.102 mm
    assert REFERENCE.hardpoints.at("damper_top") == REFERENCE.hardpoints.strut_top
    assert MAP.hardpoints.at("damper_top") != MAP.hardpoints.strut_top
    assert REFERENCE.wheel.camber == pytest.approx(np.radians(-1.0))


def test_every_model_has_its_class():
    rigs = [load(name) for name in parts.library()]
    found = {rig.model: type(rig) for rig in rigs if not isinstance(rig, parts.Vehicle)}
    found["trailing-arm"] = type(rig_from_table(TRAILING))
    assert found == {
        "quarter-car": parts.QuarterCar,
        "double-wishbone": parts.DoubleWishbone,
        "mcpherson": parts.McPherson,
        "five-link": parts.FiveLink,
        "trailing-arm": parts.TrailingArm,
        "solid-axle": parts.SolidAxle,
        "twist-beam": parts.TwistBeam,
    }


@pytest.mark.parametrize(
    "rig", [REFERENCE, FIVE_LINK, MAP], ids=["double wishbone", "five-link", "damper map"]
)
def test_every_number_has_path_and_unit_and_can_be_changed(rig):
    before = rig.parameters()
    assert {"hardpoints.wheel_centre[2]", "sprung.mass"} <= set(before)
    units = {path: unit_of(rig, path) for path in before}
    assert "1" not in units.values()
    assert units["hardpoints.wheel_centre[2]"] == "m"
    for path, value in before.items():
        changed = rig.with_changes({path: value + 1e-6})
        assert changed.parameters() == {**before, path: value + 1e-6}
        assert structure_of(changed) == structure_of(rig)


def test_units_of_inertia_and_maps():
    assert unit_of(REFERENCE, "bodies.upright.inertia.xx") == "kg*m^2"
    assert unit_of(MAP, "strut.damper.force[3][1]") == "N"
    assert unit_of(MAP, "strut.damper.length[3]") == "m"


def test_points_are_changed_as_a_whole_or_by_coordinate():
    moved = REFERENCE.with_changes(
        {"hardpoints.strut_top": ["10 mm", "500 mm", "520 mm"], "wheel.camber": "-2 deg"}
    )
    assert moved.hardpoints.strut_top == pytest.approx((0.01, 0.5, 0.52))
    assert REFERENCE.with_changes({"hardpoints.strut_top[1]": "500 mm"}).hardpoints.strut_top[
        1
    ] == pytest.approx(0.5)
    assert (
        REFERENCE.with_changes(
            {"hardpoints.strut_top": np.array([0.0, 0.5, 0.6])}
        ).hardpoints.strut_top[2]
        == 0.6
    )


def test_one_number_is_written_into_one_line():
    text = changed_text(TEXT, REFERENCE, {"hardpoints.lower_ball_joint[1]": 0.7251})
    assert read(text) == REFERENCE.with_changes({"hardpoints.lower_ball_joint[1]": 0.7251})
    assert [line for line in text.splitlines() if line not in TEXT.splitlines()] == [
        'lower_ball_joint = ["5 mm", "0.7251 m", "140 mm"]'
    ]


def test_a_default_list_is_written_as_a_whole():
    text = TEXT + '\n[bushings.lower_arm_front]\nstiffness = ["5 kN/mm", "5 kN/mm", "1 kN/mm"]\n'
    rig = read(text)
    changed = changed_text(text, rig, {"bushings.lower_arm_front.damping[1]": 300.0})
    assert read(changed).bushings.lower_arm_front.damping == (0.0, 300.0, 0.0)


def test_structure_knows_guide_side_law_and_which_parts_there_are():
    changes = [
        {"guide": "fixed"},
        {"tyre.law": "radial"},
        {"tyre.undeformed_radius": None},
        {"strut.spring.preload": None, "strut.spring.free_length": 0.5},
        {"strut.on": "upright"},
        {"bodies.tie_rod": BODY},
        {"bushings.lower_arm_front": {"stiffness": [1e6, 1e6, 1e6]}},
        BAR,
        ROCKER,
    ]
    structures = [structure_of(REFERENCE.with_changes(change)) for change in changes]
    assert len({structure_of(REFERENCE), *structures}) == len(changes) + 1


def test_spring_with_free_length_or_preload():
    free = REFERENCE.with_changes({"strut.spring": {"rate": 4e4, "free_length": "500 mm"}})
    assert free.strut.spring.preload is None
    with pytest.raises(
        DescriptionError,
        match=r"strut.spring: give preload or free_length, not both; found .*5726.56 N",
    ):
        REFERENCE.with_changes({"strut.spring.free_length": 0.5})


def test_a_corner_is_mirrored_as_a_whole():
    rig = FIVE_LINK.with_changes({"bodies.link_4.inertia.xz": 0.01})
    right = rig.mirrored()
    assert (right.side, right.sign) == ("right", -1.0)
    assert right.bodies.link_4.inertia.xz == 0.01
    assert right.bodies.link_4.inertia.xy == -rig.bodies.link_4.inertia.xy
    assert right.bodies.upright.centre_of_mass[1] == -rig.bodies.upright.centre_of_mass[1]
    assert right.wheel == rig.wheel
    flip = np.diag([1.0, -1.0, 1.0])
    assert right.bodies.upright.inertia.tensor == pytest.approx(
        flip @ rig.bodies.upright.inertia.tensor @ flip
    )
    assert right.mirrored() == rig
    steered = REFERENCE.with_changes(
        {"steering.rack_travel": 0.01, "bushings.lower_arm_rear": {"stiffness": [1.0, 2.0, 3.0]}}
    )
    assert steered.mirrored().steering.rack_travel == -0.01
    assert steered.mirrored().bushings == steered.bushings


def test_a_bump_stop_may_stand_at_the_top():
    text = TEXT.replace(
        "[hardpoints]", '[bump_stop]\ngap = "40 mm"\nrate = "60 N/mm"\n\n[hardpoints]'
    )
    assert read(text).strut.bump_stop.gap == pytest.approx(0.04)


def test_the_body_on_a_spherical_joint_needs_more_than_mass():
    sprung = {
        "mass": 400.0,
        "centre_of_mass": [0.0, 0.2, 0.5],
        "inertia": INERTIA,
        "joint": [0.0, 0.0, 0.5],
    }
    assert REFERENCE.with_changes(
        {"guide": "vertical+spherical", "sprung": sprung}
    ).sprung.joint == (0.0, 0.0, 0.5)
    with pytest.raises(DescriptionError, match="sprung: centre_of_mass, inertia, joint is missing"):
        REFERENCE.with_changes({"guide": "vertical+spherical"})


def test_a_fixed_body_needs_no_mass():
    table = REFERENCE.model_dump(by_alias=True, exclude_none=True)
    del table["sprung"]
    assert rig_from_table({**table, "guide": "fixed"}).sprung is None
    with pytest.raises(
        DescriptionError, match='sprung: mass is missing; guide = "vertical" needs mass'
    ):
        rig_from_table(table)


MISTAKES = [  # old text, new text, line of the message, message
    (
        "lower_ball_joint",
        "lower_bal_joint",
        14,
        r"hardpoints.lower_bal_joint: unknown key.*mean 'lower_ball_joint'",
    ),
    (
        '"720 mm", "140 mm"]',
        '"720 mm"]',
        14,
        r"hardpoints.lower_ball_joint: three values along x, y and z.*found 2",
    ),
    (
        '["5 mm", "720 mm", "140 mm"]',
        '"5 mm"',
        14,
        r"lower_ball_joint: three values along x, y and z.*as in \[.*'5 mm'",
    ),
    (
        '"720 mm", "140 mm"',
        '"720", "140 mm"',
        14,
        r"hardpoints.lower_ball_joint\[1\]: the unit is missing",
    ),
    (
        '"720 mm", "140 mm"',
        '720, "140 mm"',
        14,
        r"lower_ball_joint: is far from the other points.*Were millimetres given as metres",
    ),
    (
        '"720 mm", "140 mm"',
        '"-720 mm", "140 mm"',
        14,
        r"lower_ball_joint: not on the same side of the car as the wheel",
    ),
    (
        '["110 mm", "450 mm"',
        '["110 mm", "-450 mm"',
        15,
        r"upper_arm_front: not on the same side.*Is the sign of y wrong",
    ),
    (
        'side = "left"',
        'side = "right"',
        20,
        r"wheel_centre: not on the right side of the car; found y = 760 mm.*below 0",
    ),
    (
        '"760 mm", "300 mm"',
        '"760 mm", "-10 mm"',
        20,
        r"wheel_centre: is in or below the road.*found z = -10 mm",
    ),
    (
        '["-120 mm", "700 mm", "180 mm"]',
        '["-130 mm", "380 mm", "185 mm"]',
        19,
        r"tie_rod_outer: coincides with tie_rod",
    ),
    (
        '["10 mm", "520 mm", "520 mm"]',
        '["0 mm", "640 mm", "150 mm"]',
        22,
        r"strut_top: coincides with strut_bottom",
    ),
    (
        '["-150 mm", "400 mm", "145 mm"]',
        '["150 mm", "400 mm", "155 mm"]',
        13,
        r"lower_arm_rear: coincides with lower_",
    ),
    (
        '["5 mm", "720 mm", "140 mm"]',
        '["0 mm", "400 mm", "150 mm"]',
        14,
        r"is on the line through lower_arm_front and",
    ),
    (
        '["-120 mm", "700 mm", "180 mm"]',
        '["-5 mm", "705 mm", "270 mm"]',
        19,
        r"tie_rod_outer: is on the line through lower",
    ),
    (
        'mass = "6 kg"',
        'mass = "0 kg"',
        33,
        r"bodies.lower_arm.mass: out of range; found '0 kg'; allowed: above 0 kg",
    ),
    ('mass = "6 kg"', 'mass = "-6 kg"', 33, r"bodies.lower_arm.mass: out of range"),
    (
        'xx = "0.08 kg*m^2"',
        'xx = "0.8 kg*m^2"',
        35,
        r"lower_arm.inertia: impossible inertia.*0.06, 0.13 and 0.8.*sum of the others",
    ),
    (
        'zz = "0.13 kg*m^2"',
        'zz = "0.13 kg*m^2", xy = 0.2',
        35,
        r"impossible inertia.*-0.13.*all must be above 0",
    ),
    ('xx = "0.08 kg*m^2"', 'xx = "-0.08 kg*m^2"', 35, r"bodies.lower_arm.inertia.xx: out of range"),
    (
        "[bodies.upright]",
        "[bodies.uprigt]",
        42,
        r"bodies.uprigt: unknown key.*Did you mean 'upright'",
    ),
    (
        'on = "lower_arm"',
        'on = "lower_arms"',
        48,
        r"strut.on: input should be 'lower_arm', 'upper_arm', 'upright' or",
    ),
    (
        'on = "lower_arm"',
        'on = "rocker"',
        48,
        r"strut.on: the body 'rocker' that carries it does not exist.*bodies.rocker",
    ),
    (
        'on = "lower_arm"',
        'angle = "26 deg"',
        48,
        r"strut.angle: a 3-D rig has no strut-angle setting.*found '26 deg'.*strut_top",
    ),
    (
        'guide = "vertical"',
        'guide = "verticl"',
        9,
        r"guide: input should be 'fixed', 'vertical' or 'vertical\+spherical'",
    ),
    (
        'side = "left"',
        'side = "centre"',
        8,
        r"side: input should be 'left' or 'right'; found 'centre'",
    ),
    (
        "[tyre]",
        '[tyre]\nlaw = "radal"',
        53,
        r"tyre.law: input should be 'vertical' or 'radial'; found 'radal'",
    ),
    (
        "[tyre]",
        "[bushings.wheel_centre]\n[tyre]",
        52,
        r"bushings.wheel_centre: unknown key; allowed: arb_arm_end",
    ),
    (
        "[steering]",
        "[anti_roll_bar]\nstiffness = 1e4\n[steering]",
        56,
        r"anti_roll_bar: an anti-roll bar needs its table.*arb_",
    ),
]


@pytest.mark.parametrize(
    ("old", "new", "line", "message"), MISTAKES, ids=[f"{m[1]} {m[3][:20]}" for m in MISTAKES]
)
def test_mistakes_are_named_with_file_line_and_path(old: str, new: str, line: int, message: str):
    assert old in TEXT
    with pytest.raises(DescriptionError) as caught:
        read(TEXT.replace(old, new, 1))
    places = [text for text in str(caught.value).splitlines() if f"rig.toml, line {line}: " in text]
    assert any(re.search(message, text) for text in places), str(caught.value)
    if "lower_bal_joint" in new:
        assert len(str(caught.value).splitlines()) == 1, "the missing key is not told again"


def test_a_missing_hardpoint_is_named():
    with pytest.raises(
        DescriptionError, match=r"line 11: hardpoints.lower_ball_joint: the key is missing"
    ):
        read(re.sub(r"lower_ball_joint = .*\n", "", TEXT))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"hardpoints.link_1_outer": FIVE_LINK.hardpoints.link_1_inner},
            "link_1_outer: coincides with link_1_inner",
        ),
        (
            {"hardpoints.link_2_inner": FIVE_LINK.hardpoints.link_1_inner},
            "link 2 has both ends of link 1",
        ),
        ({"strut.on": "link_2"}, r"strut.on: the body 'link_2' that carries it.*\[bodies.link_2\]"),
        ({"bodies.link_6": BODY}, "bodies.link_6: unknown key.*Did you mean 'link_5'"),
        (
            {
                "strut.damper": {
                    "kind": "map",
                    "length": [0.4, 0.3],
                    "velocity": [-1.0, 1.0],
                    "force": [[0.0] * 2] * 2,
                }
            },
            "sort",
        ),
        (
            {"strut.damper": {"length": [0.3, 0.4], "velocity": [-1.0, 1.0], "force": [[0.0] * 2]}},
            "force has 1 rows and le",
        ),
        (
            {
                "strut.damper": {
                    "length": [0.3, 0.4],
                    "velocity": [-1.0, 1.0],
                    "force": [[0.0] * 2, [0.0]],
                }
            },
            r"strut.damper.force\[1\]: this row has 1 forces and velocity 2 points",
        ),
        (
            {"strut.damper": {"kind": "maps"}},
            "unknown kind 'maps'; allowed: linear, bilinear, blow-off, table, clicks, tanh, bouc-wen, map",
        ),
        (
            {"hardpoints.strut_topp[0]": 1.0},
            r"unknown parameter.*Did you mean 'hardpoints.strut_top\[0\]'",
        ),
        ({"hardpoints.strut_top[3]": 1.0}, "unknown parameter"),
        ({"tyre.undeformed_radius": 0.0}, "undeformed_radius: out of range"),
        ({"wheel.radius": "-1 mm"}, "wheel.radius: out of range"),
    ],
    ids=str,
)
def test_refused_changes_of_a_five_link(changes: dict[str, Any], message: str):
    with pytest.raises(DescriptionError, match=f"(?s){message}"):
        FIVE_LINK.with_changes(changes)


def test_links_may_share_a_point():
    assert FIVE_LINK.hardpoints.link_1_outer == FIVE_LINK.hardpoints.link_2_outer


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"bodies.rocker": None}, "strut.on: the body 'rocker' that carries it does not exist"),
        (
            {"hardpoints.rocker_axis": None},
            "rocker_axis is missing; give all of pushrod_outer, pushrod_inner, rocker_pivot",
        ),
        (
            {"hardpoints.pushrod_inner": [0.05, 0.35, 0.45]},
            "pushrod_inner: is on the line through rocker_pivot and",
        ),
        ({"strut.pushrod_on": "wheel"}, "strut.pushrod_on: input should be"),
    ],
    ids=str,
)
def test_rocker(changes: dict[str, Any], message: str):
    rig = REFERENCE.with_changes(ROCKER)
    assert rig.strut.on == "rocker"
    with pytest.raises(DescriptionError, match=message):
        rig.with_changes(changes)


def test_anti_roll_bar():
    rig = REFERENCE.with_changes(BAR)
    assert rig.anti_roll_bar.stiffness == pytest.approx(300.0 * 180.0 / np.pi)
    for changes in (
        {"anti_roll_bar": None},
        {key: None for key in BAR if key.startswith("hardpoints")},
    ):
        with pytest.raises(DescriptionError, match="an anti-roll bar needs its table"):
            rig.with_changes(changes)
    with pytest.raises(DescriptionError, match="arb_link_end is missing; give all of arb_pivot"):
        rig.with_changes({"hardpoints.arb_link_end": None})


def test_trailing_arm():
    rig = rig_from_table(TRAILING)
    assert rig.strut.on == "arm"
    with pytest.raises(
        DescriptionError, match="wheel_centre: is on the line through arm_inner and arm_outer"
    ):
        rig.with_changes({"hardpoints.wheel_centre": [0.3, 1.0, 0.3]})


def test_an_inertia_on_the_edge_of_the_possible_is_allowed():
    """A thin plate has exactly zz = xx + yy; data sheets round."""
    rig = REFERENCE.with_changes(
        {"bodies.lower_arm.inertia": {"xx": 0.05, "yy": 0.06, "zz": 0.11005}}
    )
    assert rig.bodies.lower_arm.inertia.principal_moments == pytest.approx([0.05, 0.06, 0.11005])
    with pytest.raises(DescriptionError, match="impossible inertia"):
        REFERENCE.with_changes({"bodies.lower_arm.inertia": {"xx": 0.05, "yy": 0.06, "zz": 0.1105}})


@pytest.mark.parametrize(
    ("path", "expected"),
    [
        ("hardpoints.strut_topp[0]", "Did you mean 'hardpoints.strut_top[0]'"),
        ("strut_top[1]", "Did you mean 'hardpoints.strut_top[1]'? All "),
        (
            "hardpoints.strut_top",
            "Did you mean 'hardpoints.strut_top[0]', 'hardpoints.strut_top[1]' or 'hardpoints.strut",
        ),
        ("quux", "allowed: paths that begin with bodies, gravity, hardpoints"),
    ],
)
def test_unknown_paths_are_answered_shortly(path: str, expected: str):
    """Of more than sixty paths only the nearest are said, and how to see all."""
    known = load("sedan-multi-link").parameters()
    message = str(unknown_path(path, known))
    assert message.startswith(f"{path}: unknown parameter")
    assert expected in message
    assert message.endswith(f"All {len(known)}: jounce check FILE --parameters.")
    assert len(message) < 280
