"""Hardpoints in nested keys (YAML of suspension-explorer, JSON) and in the front view of VSUSP."""

from __future__ import annotations

import json
import re
from pathlib import Path
from urllib.parse import quote

import numpy as np
import pytest

import jounce as jn
from jounce.core.errors import DescriptionError
from jounce.parts.importers import import_hardpoints

RIG = jn.load("formula-student-front")
EXPLORER = {
    "lower_arm_front": "lower_wishbone_inboard_front", "lower_arm_rear": "lower_wishbone_inboard_rear",
    "lower_ball_joint": "lower_wishbone_outboard", "upper_arm_front": "upper_wishbone_inboard_front",
    "upper_arm_rear": "upper_wishbone_inboard_rear", "upper_ball_joint": "upper_wishbone_outboard",
    "tie_rod_inner": "trackrod_inboard", "tie_rod_outer": "trackrod_outboard", "pushrod_outer": "pushrod_outboard",
    "pushrod_inner": "pushrod_inboard", "rocker_pivot": "rocker_axis_a", "rocker_axis": "rocker_axis_b",
    "strut_bottom": "strut_bottom", "strut_top": "strut_top",
}  # fmt: skip
FORMS = {
    "flow": lambda name, p: [f"    {name}: {{x: {p[0]}, y: {p[1]}, z: {p[2]}}}  # mm"],
    "lines": lambda name, p: [
        f"    {name}:",
        *(f"      {axis}: {value}" for axis, value in zip("xyz", p, strict=True)),
    ],
    "items": lambda name, p: [f"    {name}:", *(f"      - {value}" for value in p)],
}


def points() -> dict[str, np.ndarray]:
    """The rig's points in mm, the axle with a camber of -1 degree and a toe of 0.5 degrees in place of the centre."""
    given = {
        EXPLORER[name]: 1e3 * np.array(point)
        for name, point in RIG.hardpoints.given().items()
        if name in EXPLORER
    }
    camber, toe = np.radians([-1.0, 0.5])
    along = np.array([np.sin(toe) * np.cos(camber), np.cos(toe) * np.cos(camber), -np.sin(camber)])
    centre = 1e3 * np.array(RIG.hardpoints.wheel_centre)
    return given | {"axle_inboard": centre - 80.0 * along, "axle_outboard": centre + 10.0 * along}


def explorer(form: str = "flow", **changes: str) -> str:
    keys = {"type": "double_wishbone", "scope": "axle", "units": "millimeters"} | changes
    lines = [
        "# made up",
        *(f"{key}: {value}" for key, value in keys.items()),
        "axle_config:",
        "  axle_position: front",
    ]
    lines += [
        "  actuation:",
        "    type: pushrod_rocker",
        "    mount: lower_wishbone",
        "  wheel:",
        "    offset: 10",
        "    tire:",
    ]
    lines += [
        "      rim_diameter: 10",
        "      section_width: 190",
        "      aspect_ratio: 0.542105",
        "hardpoints:",
        "  left:",
    ]
    for name, point in points().items():
        lines += FORMS[form](name, point.tolist())
    return "\n".join([*lines, "  center:", "    arb_t_bar_pivot: {x: -300, y: 0, z: 280}", ""])


@pytest.mark.parametrize("form", list(FORMS))
def test_a_file_of_suspension_explorer(tmp_path, form: str) -> None:
    file = tmp_path / "fsae.yaml"
    file.write_text(explorer(form))
    rig, findings, _ = import_hardpoints(file)
    assert rig.model == "double-wishbone"
    radius = 0.5 * 10 * 0.0254 + 0.542105 * 0.190
    up = (
        radius * np.cos(np.radians(1.0)) - RIG.hardpoints.wheel_centre[2]
    )  # the road is where the tyre ends
    for name in (*EXPLORER, "wheel_centre"):
        wanted = np.add(getattr(RIG.hardpoints, name), (0.0, 0.0, up))
        assert getattr(rig.hardpoints, name) == pytest.approx(wanted, abs=1e-8), name
    assert (rig.wheel.camber, rig.wheel.toe) == pytest.approx(
        tuple(np.radians([-1.0, 0.5])), abs=1e-9
    )
    assert (rig.strut.on, rig.strut.pushrod_on) == ("rocker", "lower_arm")
    said = " ".join(finding.message for finding in findings)
    assert "arb_t_bar_pivot" in said


AXES = {  # a file's axes in ours
    "-x,-y,z": "Adams Car's", "y,-x,z": "x to the right, y forward", "x,-y,-z": "SAE's", "x,-z,y": "y up",
}  # fmt: skip


@pytest.mark.parametrize("axes", [None, *AXES])
@pytest.mark.parametrize("side", ["left", "right"])
def test_axes_of_a_file_turn_the_wheel_too(tmp_path, axes: str | None, side: str) -> None:
    """Camber and toe are those of the wheel, whatever the file's axes; without a word x to the rear is noticed."""
    words = ["-x", "y", "z"] if axes is None else axes.split(",")
    turn = np.zeros((3, 3))
    for row, word in enumerate(words):
        turn[row, "xyz".index(word[-1])] = -1.0 if word[0] == "-" else 1.0
    keys: dict = {
        "units": "millimeters",
        "wheel": {"offset": 10},
        "hardpoints": {"left": {}, "right": {}},
    }
    keys["wheel"] |= {"rim_diameter": 10, "section_width": 190, "aspect_ratio": 0.542105}
    for name, point in points().items():
        for where, sign in (("left", 1.0), ("right", -1.0)):
            keys["hardpoints"][where][name] = (turn.T @ (point * [1.0, sign, 1.0])).tolist()
    file = tmp_path / "turned.json"
    file.write_text(json.dumps(keys))
    rig, _, _ = import_hardpoints(file, axes=axes, side=side)
    assert (rig.wheel.camber, rig.wheel.toe) == pytest.approx(
        tuple(np.radians([-1.0, 0.5])), abs=1e-9
    )
    radius = 0.5 * 10 * 0.0254 + 0.542105 * 0.190
    assert rig.wheel.radius == pytest.approx(radius, abs=1e-9)
    up = radius * np.cos(np.radians(1.0)) - RIG.hardpoints.wheel_centre[2]
    for name in (*EXPLORER, "wheel_centre"):
        assert getattr(rig.hardpoints, name) == pytest.approx(
            np.add(getattr(RIG.hardpoints, name), (0.0, 0.0, up)), abs=1e-8
        ), name


def test_json_of_points(tmp_path) -> None:
    file = tmp_path / "points.json"
    named = {
        name: [1e3 * value for value in point] for name, point in RIG.hardpoints.given().items()
    }
    file.write_text(json.dumps({"unit": "mm", "points": named}, indent=2))
    rig, _, _ = import_hardpoints(file)
    assert rig.hardpoints.lower_ball_joint == pytest.approx(RIG.hardpoints.lower_ball_joint)


def test_links_and_arms_of_suspension_explorer(tmp_path) -> None:
    five = {
        f"{end}_link_inboard": [0.1 * i, 0.4, 0.2 + 0.05 * i]
        for i, end in enumerate(("upper_front", "upper_rear"))
    }
    five |= {
        f"{end}_link_inboard": [0.2 - 0.3 * i, 0.4, 0.15]
        for i, end in enumerate(("lower_front", "lower_rear"))
    }
    five |= {
        name.replace("inboard", "outboard"): [0.5 * x, 0.7, z] for name, (x, _, z) in five.items()
    }
    five |= {
        "trackrod_inboard": [-0.15, 0.4, 0.2],
        "trackrod_outboard": [-0.12, 0.7, 0.2],
        "wheel_centre": [0, 0.8, 0.3],
    }
    five |= {"strut_bottom": [0.0, 0.65, 0.2], "strut_top": [0.0, 0.6, 0.6]}
    arm = {
        "trailing_arm_pivot_a": [0.5, 0.4, 0.3],
        "trailing_arm_pivot_b": [0.45, 0.7, 0.3],
        "wheel_centre": [0, 0.8, 0.3],
    }
    arm |= {"strut_bottom": [0.1, 0.7, 0.25], "strut_top": [0.1, 0.65, 0.7]}
    for model, named in (("five-link", five), ("trailing-arm", arm)):
        file = tmp_path / f"{model}.json"
        file.write_text(json.dumps({"units": "meters", "side": "left", "hardpoints": named}))
        assert import_hardpoints(file)[0].model == model


def vsusp(**changes: object) -> str:
    """A made-up double wishbone as the address of a project; numbers in micrometres."""
    block = {
        "frame.susp_type": 0, "frame.bottom_y": 60000, "frame.center_to_upper_mount_x": 300000,
        "frame.bottom_to_upper_mount_y": 260000, "frame.center_to_lower_mount_x": 250000,
        "frame.bottom_to_lower_mount_y": 70000, "control_arms.upper_length": 260000,
        "control_arms.lower_length": 340000, "wheels.offset": 20000, "tires.compression": 5000,
        "knuckles.hub_to_upper_x": 40000, "knuckles.hub_to_upper_y": 100000, "knuckles.hub_to_lower_x": 30000,
        "knuckles.hub_to_lower_y": 120000, "tires.diameter_expl": 520000,
    } | changes  # fmt: skip
    body = "|".join(f"{key}:{value}" for key, value in block.items() if value is not None)
    return "https://www.vsusp.com/?tool=2d#" + quote(f"0.8&project_name:made up&front{{{body}}}")


def test_a_front_view_of_vsusp(tmp_path) -> None:
    file = tmp_path / "project.txt"
    file.write_text(vsusp() + "\n")
    rig, findings, _ = import_hardpoints(file)
    points = {name: np.array(point)[1:] for name, point in rig.hardpoints.given().items()}

    def length(one: str, other: str) -> float:
        return float(np.linalg.norm(points[one] - points[other]))

    assert points["lower_arm_front"] == pytest.approx([0.25, 0.13])
    assert points["upper_arm_rear"] == pytest.approx([0.3, 0.32])
    assert length("lower_arm_front", "lower_ball_joint") == pytest.approx(0.34)
    assert length("upper_arm_front", "upper_ball_joint") == pytest.approx(0.26)
    assert length("lower_ball_joint", "upper_ball_joint") == pytest.approx(np.hypot(0.01, 0.22))
    camber = rig.wheel.camber
    assert rig.wheel.radius == pytest.approx(0.255)
    assert points["wheel_centre"][1] == pytest.approx(
        0.255 * np.cos(camber)
    )  # the tyre stands on the road
    # The roll centre as it is constructed on paper: both arms meet, and so does the line from the contact point.
    normals = [
        (-d[1], d[0])
        for d in (points[f"{a}_ball_joint"] - points[f"{a}_arm_front"] for a in ("lower", "upper"))
    ]
    centre = np.linalg.solve(
        normals,
        [
            n @ points[f"{a}_arm_front"]
            for n, a in zip(np.array(normals), ("lower", "upper"), strict=True)
        ],
    )
    contact = np.array([points["wheel_centre"][0] - 0.255 * np.sin(camber), 0.0])
    height = contact[0] * centre[1] / (contact[0] - centre[0])
    swept = jn.sweep_travel(rig, [-0.01, 0.0, 0.01])
    assert float(swept["roll_centre_height"][1]) == pytest.approx(height, abs=1e-9)
    assert np.ptp(swept["toe"].values) < 1e-12  # its tie rod steers nowhere
    assert "hardpoints" in rig.estimated
    assert any("front view" in finding.message for finding in findings)


def test_axles_of_one_project_keep_their_own_wheels(tmp_path) -> None:
    front, rear = (
        vsusp(),
        vsusp(**{"tires.diameter_expl": 600000, "knuckles.hub_to_upper_x": 60000}),
    )
    found = {}
    for name, text in (
        ("both", front + "&rear" + rear.rpartition("front")[2]),
        ("front", front),
        ("rear", rear),
    ):
        file = tmp_path / f"{name}.txt"
        file.write_text(text)
        for axle in ("front", "rear") if name == "both" else (None,):
            rig, _, _ = import_hardpoints(file, axle=axle)
            found[f"{name} {axle}"] = rig.wheel.radius, rig.wheel.camber
    assert found["both front"] == pytest.approx(found["front None"])
    assert found["both rear"] == pytest.approx(found["rear None"])
    assert found["both front"][0] != pytest.approx(found["both rear"][0], abs=0.01)
    assert found["both front"][1] != pytest.approx(found["both rear"][1], abs=0.01)


@pytest.mark.parametrize(
    ("text", "name", "message"),
    [
        (
            explorer()
            .replace("axle_inboard", "axle_in")
            .replace(
                "axle_outboard: {",
                "axle_inboard: {x: 1, y: 2, z: 3}\n    axle_outboard: {x: 1, y: 2, z: 3}\n    end: {",
            ),
            "a.yaml",
            "two points of the axle coincide",
        ),
        (
            vsusp(**{"tires.diameter_expl": None}),
            "a.txt",
            "tires.diameter_expl: the number is missing",
        ),
        (vsusp(**{"tires.diameter_expl": "wide"}), "a.txt", "not a number; found 'wide'"),
        (vsusp(**{"control_arms.upper_length": 60000}), "a.txt", "do not meet"),
        (explorer(units="furlongs"), "a.yaml", "unknown unit 'furlongs'"),
        (explorer(units="inches"), "a.yaml", "an implausible half track width"),
        (explorer() + "\ntype: mcpherson\n", "a.yaml", "type is given twice"),
        ('{"unit": "mm", "unit": "m", "a": [1, 2, 3]}', "a.json", "unit is given twice"),
        ("a: {x: 1, y: 2}\n", "a.yaml", "the file contains no points"),
        ("{" * 1000, "a.json", "the file contains no points"),
        (
            "{" * 5000,
            "a.json",
            "a line is too long for a point; found '5000'; allowed: up to 2000 characters",
        ),
    ],
)
def test_mistakes_are_named(tmp_path, text: str, name: str, message: str) -> None:
    file = tmp_path / name
    file.write_text(text)
    with pytest.raises(DescriptionError, match=message):
        import_hardpoints(file)


def test_numbers_that_are_none(tmp_path) -> None:
    """A tyre's size with a decimal comma was no size, and a coordinate with one no point."""
    source = Path(__file__).parents[2] / "files" / "hardpoints" / "explorer.yaml"
    text = source.read_text(encoding="utf-8")
    file = tmp_path / "car.yaml"
    size = re.search(r"aspect_ratio: *([0-9.]+)", text)
    file.write_text(text.replace(size[0], size[0].replace(".", ",")), encoding="utf-8")
    with pytest.raises(DescriptionError, match=r"car.yaml: aspect_ratio: not a number; found '0,"):
        import_hardpoints(file)
    file.write_text("a:\n  wheel_centre: {x: 1.0D+03, y: 2, z: 3}\n")
    with pytest.raises(
        DescriptionError,
        match=r"wheel_centre: a point without three coordinates; found '1.0D\+03, 2, 3",
    ):
        import_hardpoints(file)
