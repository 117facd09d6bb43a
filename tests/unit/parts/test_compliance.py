"""Compliance of corners in their files: bushings, mounts, bearing, links; mirror images, refusals, findings."""

from __future__ import annotations

import tomllib
from typing import Any

import numpy as np
import pytest

from jounce import parts
from jounce.core.errors import DescriptionError
from jounce.parts import load, rig_findings, rig_from_table, save
from jounce.parts.bushings import SLIP_ANGLE, SLIP_TRAVEL, Bushing, load_of
from jounce.parts.files import rig_text, updated_text
from jounce.parts.rig import result_unit_of, structure_of, unit_of

MCPHERSON = load("generic-mcpherson")
TEXT = parts.library()["generic-mcpherson"].read_text(encoding="utf-8")
STIFF = {"stiffness": ["8 kN/mm", "8 kN/mm", "3 kN/mm"]}
SKEW = {
    "stiffness": [8e6, 0.0, 3e6],
    "rotational_stiffness": ["40 N*m/deg", "2 N*m/deg", "3 N*m/deg"],
    "x_axis": [1.0, 0.2, -0.1],
    "z_axis": [0.2, 0.0, 3.0],
    "curves": {
        "y": {"kind": "table", "deflection": ["-2 mm", "0 mm", "3 mm"], "force": [-3e3, 0.0, 2e3]},
        "z": {"kind": "polynomial", "coefficients": [3e6, 1e8, 4e12]},
        "rx": {"kind": "table", "angle": ["-2 deg", "0 deg", "3 deg"], "torque": [-20, 0, 10]},
        "ry": {"kind": "polynomial", "coefficients": [100.0, 300.0]},
    },
    "preload": ["20 N", "30 N", "200 N"],
    "rotational_preload": [1.0, 2.0, 3.0],
    "friction": ["50 N", 0.0, 0.0],
    "loss_angle": "6 deg",
}
MOUNT = {"point": ["200 mm", "450 mm", "200 mm"], **STIFF}
REAR = {**MOUNT, "point": ["-250 mm", "450 mm", "190 mm"]}
HOUSING = {"point": ["-300 mm", "250 mm", "281 mm"], **STIFF}
ELASTIC: dict[str, Any] = {
    "bushings": {"lower_arm_front": SKEW, "lower_ball_joint": STIFF, "tie_rod_outer": STIFF},
    "subframe": {
        "carries": ["lower_arm_front", "lower_arm_rear", "rack"],
        "mounts": [{**MOUNT, "curves": {"y": SKEW["curves"]["z"]}}, REAR],
    },
    "steering.rack_ratio": "8 mm/rad",
    "steering.column_stiffness": "15 N*m/deg",
    "steering.assistance": 4.0,
    "steering.housing": [HOUSING, {**HOUSING, "point": [-0.3, 0.25, 0.24]}],
    "bearing": {"rotational_stiffness": ["50 kN*m/deg", 0.0, "50 kN*m/deg"]},
    "links.tie_rod": {"stiffness": "50 kN/mm"},
    "links.lower_arm": {"stiffness": "30 kN/mm"},
}
RIG = MCPHERSON.with_changes(ELASTIC)
CODES = {item.code: item for item in rig_findings(RIG)}


def loads(bushing: Bushing, displacement: Any, rotation: Any) -> tuple[Any, Any]:
    """Force and torque on the second body, ground axes, as the description's text says."""
    axes = bushing.axes
    own = np.concatenate([axes.T @ displacement, axes.T @ rotation])
    linear = (*bushing.stiffness, *bushing.rotational_stiffness)
    resist = [
        stiffness * value if curve is None else load_of(curve, value)
        for curve, stiffness, value in zip(bushing.curve_of_each, linear, own, strict=True)
    ]
    load = bushing.preloads - np.array(resist)
    return axes @ load[:3], axes @ load[3:]


def test_own_axes_are_right_handed_and_keep_the_given_direction():
    for axes in ({"x_axis": (1.0, 0.5, 0.0)}, {"z_axis": (0.0, 0.5, 1.0)}, {}):
        bushing = Bushing(stiffness=(1.0, 2.0, 3.0), **axes)
        turn = bushing.axes
        assert np.allclose(turn.T @ turn, np.eye(3))
        assert np.linalg.det(turn) == pytest.approx(1.0)
        for name, column in (("x_axis", 0), ("z_axis", 2)):
            if name in axes:
                given = np.array(axes[name])
                assert np.allclose(turn[:, column], given / np.linalg.norm(given))
    both = RIG.bushings.lower_arm_front.axes
    assert np.allclose(both[:, 0], np.array([1.0, 0.2, -0.1]) / np.linalg.norm([1.0, 0.2, -0.1]))
    assert both[:, 2] @ [0.2, 0.0, 3.0] > 0.0


@pytest.mark.parametrize("seed", range(5))
def test_the_mirror_image_of_a_bushing_is_the_physical_one(seed: int):
    """Mirrored motion gives mirrored force; rotation and torque are axial vectors, whose mirror image is reversed."""
    rng = np.random.default_rng(seed)
    displacement, rotation = rng.normal(size=3) * 1e-3, rng.normal(size=3) * 0.02
    mirror = np.array([1.0, -1.0, 1.0])
    left = (RIG.bushings.lower_arm_front, *RIG.subframe.mounts)
    other = RIG.mirrored()
    right = (other.bushings.lower_arm_front, *other.subframe.mounts)
    for one, image in zip(left, right, strict=True):
        force, torque = loads(one, displacement, rotation)
        found = loads(image, mirror * displacement, -mirror * rotation)
        assert np.allclose(found[0], mirror * force, rtol=1e-9)
        assert np.allclose(found[1], -mirror * torque, rtol=1e-9)
    assert other.mirrored() == RIG
    assert other.steering.housing[0].point == (-0.3, -0.25, 0.281)
    assert other.bearing == RIG.bearing


def test_tangents_and_slip():
    bushing = RIG.bushings.lower_arm_front
    mean = 0.5 * (3e3 / 2e-3 + 2e3 / 3e-3)  # a kink at design
    assert bushing.tangents[:3] == pytest.approx([8e6, mean, 3e6])
    assert bushing.slip_loads == pytest.approx([50.0, 0, 0, 0, 0, 0])
    assert bushing.slip_stiffnesses == pytest.approx([50.0 / SLIP_TRAVEL, 0, 0, 0, 0, 0])
    joint = Bushing(**STIFF, rotational_friction=(2.0, 0.0, 1.0))
    assert joint.slip_stiffnesses[3:] == pytest.approx([2.0 / SLIP_ANGLE, 0.0, 1.0 / SLIP_ANGLE])
    given = Bushing(**STIFF, friction=(10.0, 0.0, 0.0), friction_stiffness=(5e5, 1e5, 0.0))
    assert given.slip_stiffnesses[:3] == pytest.approx([5e5, 0.0, 0.0])


def test_stiffness_may_be_left_out_where_curves_are():
    line = {"kind": "polynomial", "coefficients": [1e6]}
    full = Bushing(curves={"x": line, "y": line, "z": line})
    assert full.tangents[:3] == pytest.approx([1e6] * 3)
    with pytest.raises(DescriptionError, match=r"stiffness: is missing along y, z"):
        Bushing(curves={"x": line})


def test_every_number_is_a_parameter_with_its_unit():
    before = RIG.parameters()
    units = {path: unit_of(RIG, path) for path in before}
    expected = {
        "bushings.lower_ball_joint.stiffness[0]": "N/m",
        "bushings.lower_arm_front.curves.y.deflection[0]": "m",
        "bushings.lower_arm_front.curves.rx.torque[2]": "N*m",
        "bushings.lower_arm_front.curves.rx.angle[2]": "rad",
        "bushings.lower_arm_front.rotational_preload[1]": "N*m",
        "bushings.lower_arm_front.loss_angle": "rad",
        "subframe.mounts[1].point[2]": "m",
        "subframe.mounts[1].stiffness[2]": "N/m",
        "steering.housing[0].stiffness[0]": "N/m",
        "steering.column_stiffness": "N*m/rad",
        "bearing.rotational_stiffness[2]": "N*m/rad",
        "links.tie_rod.stiffness": "N/m",
    }
    assert expected.items() <= units.items()
    assert result_unit_of(RIG, "bushings.lower_arm_front.curves.z.coefficients[1]") == "N/m^2"
    assert result_unit_of(RIG, "bushings.lower_arm_front.curves.ry.coefficients[0]") == "N*m/rad"
    for path in expected:
        changed = RIG.with_changes({path: before[path] + 1e-6})
        assert changed.parameters() == {**before, path: before[path] + 1e-6}
        assert structure_of(changed) == structure_of(RIG)


def test_files_keep_everything(tmp_path):
    text = rig_text(RIG)
    assert "[[subframe.mounts]]" in text
    again = rig_from_table(tomllib.loads(text))
    assert again.parameters() == pytest.approx(RIG.parameters(), rel=1e-11)
    assert structure_of(again) == structure_of(RIG)
    file = save(RIG, tmp_path / "elastic.toml")
    assert load(file).elastic_parts == RIG.elastic_parts
    assert "# Left corner imported" in save(
        RIG, tmp_path / "b.toml", like="generic-mcpherson"
    ).read_text(encoding="utf-8")
    assert load(tmp_path / "b.toml") == RIG


def test_changes_inside_of_lists_are_written():
    text = rig_text(RIG)
    rig = rig_from_table(tomllib.loads(text))
    changed = rig.with_changes(
        {
            "subframe.carries": ["lower_arm_front", "lower_arm_rear"],
            "subframe.mounts[1].loss_angle": "4 deg",
            "steering.housing[0].point[2]": "280 mm",
        }
    )
    swapped = changed.with_changes({"subframe.carries": ["lower_arm_front", "rack"]})
    for wanted in (changed, swapped):
        written = updated_text(text, rig=wanted)
        assert rig_from_table(tomllib.loads(written)) == wanted
    assert updated_text(text, rig) == text


REFUSED = [
    ({"bushings.wheel_centre": STIFF}, "bushings.wheel_centre: unknown key"),
    ({"bushings.spring_top": STIFF}, "bushings.spring_top: the hardpoint spring_top is missing"),
    (
        {"links.arb_link": {"stiffness": 1e6}},
        "links.arb_link: the hardpoint arb_link_end is missing",
    ),
    (
        {"subframe": {"carries": ["lower_arm_frnt"], "mounts": [MOUNT]}},
        r"subframe.carries\[0\]: the body of this rig has no such point.*lower_arm_front.*Did you mean",
    ),
    (
        {"subframe": {"carries": ["tie_rod_inner"], "mounts": [MOUNT]}},
        r"This point is on the rack: name the rack",
    ),
    (
        {"subframe": {"carries": ["lower_arm_rear", "lower_arm_rear"], "mounts": [MOUNT]}},
        r"subframe.carries\[1\]: lower_arm_rear is given twice",
    ),
    (
        {"subframe": {"carries": ["rack"], "mounts": [MOUNT]}, "steering": None},
        r"A rack needs the table \[steering\]",
    ),
    ({"subframe": {"carries": ["rack"], "mounts": []}}, r"subframe.mounts"),
    ({"steering.column_stiffness": 800.0}, r"column_stiffness: turns a pinion without a rack"),
    (
        {"bearing": {"stiffness": [1e8, 0.0, 1e8]}},
        r"bearing.stiffness\[1\]: does not hold the wheel",
    ),
    ({"links.tie_rod": {"stiffness": 0.0}}, r"links.tie_rod.stiffness"),
]
BUSHINGS = [
    ({"damping": [1.0, 0.0, 0.0], "loss_angle": 0.1}, "loss_angle: the losses are given twice"),
    ({"friction": [-5.0, 0.0, 0.0]}, r"friction\[0\]: .*-5"),
    ({"friction_stiffness": [1e5] * 3}, "friction_stiffness: needs friction"),
    (
        {"friction": [5.0, 0.0, 0.0], "friction_stiffness": [0.0] * 3},
        r"friction_stiffness\[0\]: friction without stiffness",
    ),
    ({"x_axis": [0.0, 0.0, 0.0]}, "x_axis: has no direction"),
    ({"z_axis": [2.0, 0.0, 0.0]}, r"z_axis: x_axis and z_axis are parallel.*give both"),
    ({"x_axis": [0.0, 1.0, 1.0], "z_axis": [0.0, -1.0, -1.0]}, "x_axis and z_axis are parallel"),
    (
        {"curves": {"x": {"kind": "table", "deflection": [-1e-3, 1e-3], "force": [5.0, -5.0]}}},
        r"curves.x.force: falls, so the bushing would not resist; found -5 after 5",
    ),
    (
        {"curves": {"x": {"kind": "table", "deflection": [1e-3, -1e-3], "force": [-5.0, 5.0]}}},
        r"deflection\[1\] = -0.001 is not above",
    ),
    (
        {"curves": {"rz": {"kind": "table", "angle": [0.01, 0.02], "torque": [1.0, 5.0]}}},
        r"curves.rz.angle: does not include 0",
    ),
    (
        {"curves": {"rz": {"kind": "table", "angle": [-0.01, 0.02], "torque": [1.0, 5.0, 6.0]}}},
        r"angle has 2 points and torque has 3",
    ),
    (
        {"curves": {"z": {"kind": "polynomial", "coefficients": [-1e5]}}},
        r"curves.z.coefficients: a bushing with negative stiffness at design",
    ),
    ({"curves": {"z": {"kind": "power", "coefficient": 1.0, "exponent": 2.0}}}, "unknown kind"),
    ({"loss_angle": "120 deg"}, "loss_angle"),
]


@pytest.mark.parametrize(("changes", "message"), REFUSED)
def test_impossible_compliance_is_refused(changes: dict[str, Any], message: str):
    with pytest.raises(DescriptionError) as caught:
        MCPHERSON.with_changes(changes)
    assert caught.match(f"(?s){message}")


@pytest.mark.parametrize(("more", "message"), BUSHINGS)
def test_impossible_bushings_are_refused(more: dict[str, Any], message: str):
    for place in ("bushings.lower_ball_joint", "bushings.tie_rod_outer"):
        with pytest.raises(DescriptionError) as caught:
            MCPHERSON.with_changes({place: {**STIFF, **more}})
        assert caught.match(
            f"(?s){place}.*{message}" if "deflection[1]" not in message else message
        )


def test_mistakes_in_lists_are_named_with_their_line():
    text = TEXT + '\n[subframe]\ncarries = ["rack"]\n[[subframe.mounts]]\npoint = [0.1, 0.4, 0.2]\n'
    text += "stiffness = [1e6, 1e6, 1e6]\n[[subframe.mounts]]\npoint = [0.1, 0.4, 0.2]\n"
    text += "stiffness = [1e6, -1e6, 1e6]\n"
    with pytest.raises(DescriptionError) as caught:
        rig_from_table(tomllib.loads(text), where="rig.toml", text=text)
    line = text.splitlines().index("stiffness = [1e6, -1e6, 1e6]") + 1
    assert f"rig.toml, line {line}: subframe.mounts[1].stiffness[1]" in str(caught.value)


def test_a_finding_names_what_runs_ignore():
    item = CODES["parts.kc_only"]
    assert item.severity == "note"
    for name in (
        "bushings.lower_ball_joint",
        "bushings.lower_arm_front.friction",
        "bushings.lower_arm_front.loss_angle",
        "subframe",
        "bearing",
        "links.tie_rod",
        "steering.column_stiffness",
        "steering.assistance",
        "steering.housing",
    ):
        assert name in item.message.split(": ")[1].split(". ")[0].split(", ")
    known = MCPHERSON.with_changes({"bushings.lower_arm_front": STIFF, "bushings.strut_top": STIFF})
    assert not [found for found in rig_findings(known) if found.code == "parts.kc_only"]


def test_a_finding_names_what_runs_ignore_in_a_car():
    car = load("formula-student-car").with_changes(
        {"front.corner.bushings": {"lower_ball_joint": STIFF}}
    )
    found = {item.code: item.place for item in rig_findings(car)}
    assert found["parts.kc_only"] == "front.corner.bushings.lower_ball_joint"


def codes(changes: dict[str, Any], rig: Any = MCPHERSON) -> dict[str, Any]:
    return {item.code: item for item in rig_findings(rig.with_changes(changes))}


def test_directions_without_stiffness_are_named():
    flat = {
        "kind": "table",
        "deflection": [-2e-3, -1e-3, 1e-3, 2e-3],
        "force": [-5.0, 0.0, 0.0, 5.0],
    }
    loose = {"stiffness": [1e6, 0.0, 1e6], "curves": {"z": flat}}
    item = codes({"bushings.lower_ball_joint": loose})["parts.bushing_loose"]
    assert item.place == "bushings.lower_ball_joint"
    assert "about y, z, where" in item.message
    assert "parts.bushing_loose" not in CODES


def test_a_rocker_that_can_tilt_is_reported():
    rig = load("formula-student-front")
    held = {"stiffness": [1e7] * 3, "rotational_stiffness": [1e4] * 3}
    assert "parts.bushing_loose" not in codes({"bushings.rocker_pivot": held}, rig)
    axis = np.subtract(rig.hardpoints.rocker_axis, rig.hardpoints.rocker_pivot)
    along = {**held, "x_axis": axis.tolist(), "rotational_stiffness": [0.0, 1e4, 1e4]}
    assert "parts.bushing_loose" not in codes({"bushings.rocker_pivot": along}, rig)
    tilts = {**along, "rotational_stiffness": [0.0, 0.0, 1e4]}
    assert (
        "about ry, where"
        in codes({"bushings.rocker_pivot": tilts}, rig)["parts.bushing_loose"].message
    )


def test_parts_that_their_mounts_do_not_hold_are_reported():
    two = {"subframe": {"carries": ["rack"], "mounts": [MOUNT, REAR]}}
    assert "parts.mounts_loose" not in codes(two)
    slides = {"stiffness": [1e6, 0.0, 1e6]}
    free = {"subframe": {"carries": ["rack"], "mounts": [{**MOUNT, **slides}, {**REAR, **slides}]}}
    item = codes(free)["parts.mounts_loose"]
    assert (item.place, "freely along y" in item.message) == ("subframe.mounts", True)
    rolls = codes({"steering.housing": [HOUSING]})["parts.mounts_loose"]
    assert (rolls.place, "freely about y" in rolls.message) == ("steering.housing", True)
    firm = {**HOUSING, "rotational_stiffness": [0.0, 1e4, 0.0]}
    assert "parts.mounts_loose" not in codes({"steering.housing": [firm]})


def test_mounts_in_other_units_are_reported():
    lost = {
        "subframe": {"carries": ["rack"], "mounts": [{**MOUNT, "point": [200.0, 450.0, 200.0]}]}
    }
    assert codes(lost)["parts.size_metres"].place == "subframe.mounts[0]"


def test_curves_that_contradict_are_reported():
    offset = {"kind": "table", "deflection": [-1e-3, 1e-3], "force": [-5.0, 6.0]}
    found = codes({"bushings.lower_arm_front": {**STIFF, "curves": {"y": offset}}})
    assert found["parts.curve_not_zero"].value == pytest.approx(0.5)
    assert "along y" in found["parts.curve_replaces"].message
